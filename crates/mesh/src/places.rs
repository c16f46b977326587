//! Groups by place: elements leave the groups that they are in for one of their own.

use std::fmt;

use crate::Mesh;
use crate::plane::Plane;

/// A place. Lengths in metres; what lies on its surface is in it.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// Two opposite corners of a box along the axes.
    Box([[f64; 3]; 2]),
    /// One side of a plane.
    Halfspace { plane: Plane, above: bool },
    /// The ends of the axis of a round cylinder with plane ends, and its radius.
    Cylinder { ends: [[f64; 3]; 2], radius: f64 },
    /// Two z, in any order.
    Levels([f64; 2]),
    /// Below the first plane and above the second.
    Planes([Plane; 2]),
}

impl Place {
    /// Whether a point lies there.
    pub fn holds(&self, x: [f64; 3]) -> bool {
        let between = |x: f64, a: f64, b: f64| (a.min(b)..=a.max(b)).contains(&x);
        match self {
            Place::Box([one, other]) => (0..3).all(|i| between(x[i], one[i], other[i])),
            Place::Halfspace { plane, above: true } => plane.distance(x) >= 0.0,
            Place::Halfspace { plane, above: false } => plane.distance(x) <= 0.0,
            Place::Cylinder { ends: [from, to], radius } => {
                let axis: [f64; 3] = std::array::from_fn(|i| to[i] - from[i]);
                let way: [f64; 3] = std::array::from_fn(|i| x[i] - from[i]);
                let share = dot(way, axis) / dot(axis, axis);
                let off: [f64; 3] = std::array::from_fn(|i| way[i] - share * axis[i]);
                between(share, 0.0, 1.0) && dot(off, off) <= radius * radius
            }
            Place::Levels([a, b]) => between(x[2], *a, *b),
            Place::Planes([upper, lower]) => upper.distance(x) <= 0.0 && lower.distance(x) >= 0.0,
        }
    }
}

/// What a group by place has taken.
#[derive(Clone, Debug, PartialEq)]
pub struct Taken {
    pub name: String,
    /// The groups that lost elements, each with those that it lost.
    pub from: Vec<(String, Vec<u32>)>,
}

/// Why a group by place was not made.
#[derive(Clone, Debug, PartialEq)]
pub enum TakeError {
    /// The mesh has a group of that name.
    Known { name: String },
    /// No element's middle lies there; `of` are the groups that were looked through.
    Nothing { name: String, of: Vec<String>, low: [f64; 3], high: [f64; 3] },
    /// A group would lose all its elements.
    Whole { name: String, group: String },
    /// An earlier group by place took elements that lie here as well.
    Overlap { name: String, other: String, count: usize },
}

impl fmt::Display for TakeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Known { name } => write!(f, "the mesh has a group '{name}'; give the new one another name"),
            Self::Nothing { name, of, low, high } => {
                let range =
                    |i: usize| format!("{} from {:.1} to {:.1} m", ["x", "y", "z"][i], low[i], high[i]);
                write!(
                    f,
                    "no element of {} has its middle in the place of '{name}'; they lie in {}",
                    of.join(", "),
                    [0, 1, 2].map(range).join(", ")
                )
            }
            Self::Whole { name, group } => write!(
                f,
                "'{name}' would take all elements of '{group}'; name '{group}' itself where '{name}' is meant, or leave it out of `of`"
            ),
            Self::Overlap { name, other, count } => write!(
                f,
                "{count} elements in the place of '{name}' are those of '{other}'; list '{other}' in its `of` if they are to leave it, \
                 or let the places not overlap"
            ),
        }
    }
}

impl std::error::Error for TakeError {}

/// The middle of an element: the mean of its nodes.
pub fn middle(mesh: &Mesh, element: u32) -> [f64; 3] {
    let nodes = mesh.elements[element as usize].nodes();
    let sum = |i: usize| nodes.iter().map(|&n| mesh.nodes[n as usize][i]).sum::<f64>();
    [0, 1, 2].map(|i| sum(i) / nodes.len() as f64)
}

/// Makes a group of the elements of the groups `of` whose middles lie in `place`, and takes them out of these; other groups keep
/// them. `earlier` are those that were taken before.
///
/// # Errors
/// A name that is there, a place that holds none or all of a group, or some of an earlier group that was taken of the same and is not
/// in `of`. Then the mesh is as it was.
pub fn take(
    mesh: &mut Mesh,
    name: &str,
    of: &[String],
    place: &Place,
    earlier: &[Taken],
) -> Result<Taken, TakeError> {
    let name = name.to_owned();
    if mesh.groups.contains_key(&name) {
        return Err(TakeError::Known { name });
    }
    let inside = |e: &u32| place.holds(middle(mesh, *e));
    for other in earlier.iter().filter(|taken| !of.contains(&taken.name)) {
        let shared = other.from.iter().filter(|(group, _)| of.contains(group)).map(|(_, lost)| lost);
        let mut both: Vec<u32> = shared.flatten().copied().filter(inside).collect();
        both.sort_unstable();
        both.dedup();
        if !both.is_empty() {
            return Err(TakeError::Overlap { name, other: other.name.clone(), count: both.len() });
        }
    }
    let mut from: Vec<(String, Vec<u32>)> = Vec::new();
    for group in of {
        let Some(list) = mesh.groups.get(group) else { continue };
        let lost: Vec<u32> = list.iter().copied().filter(inside).collect();
        if lost.len() == list.len() && !list.is_empty() {
            return Err(TakeError::Whole { name, group: group.clone() });
        }
        if !lost.is_empty() {
            from.push((group.clone(), lost));
        }
    }
    if from.is_empty() {
        let elements = of.iter().filter_map(|group| mesh.groups.get(group)).flatten();
        let nodes = elements.flat_map(|&e| mesh.elements[e as usize].nodes());
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for x in nodes.map(|&n| mesh.nodes[n as usize]) {
            (low, high) =
                (std::array::from_fn(|i| low[i].min(x[i])), std::array::from_fn(|i| high[i].max(x[i])));
        }
        return Err(TakeError::Nothing { name, of: of.to_vec(), low, high });
    }
    for (group, lost) in &from {
        if let Some(list) = mesh.groups.get_mut(group) {
            list.retain(|e| lost.binary_search(e).is_err());
        }
    }
    let mut all: Vec<u32> = from.iter().flat_map(|(_, lost)| lost).copied().collect();
    all.sort_unstable();
    all.dedup();
    mesh.groups.insert(name.clone(), all);
    Ok(Taken { name, from })
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

#[cfg(test)]
mod tests;
