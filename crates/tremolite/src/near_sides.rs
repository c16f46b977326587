//! Sides, base and top that stand near an opening: how much they change the stress around it.
//!
//! An excavation relieves a stress that falls off as (R/r)² (`kirsch1898`). What stands at r = R + d and does not give
//! sends it back, so that the stress around the opening is wrong by about 1.5 (R/(R + d))² of itself: of a hall of 10 m by 7.3 % with
//! sides and base at 15 m, where the measure says 9.4 %, and by 4.8 % at 21 m, where it says 5.6 %.

use rayon::slice::ParallelSliceMut;
use std::collections::{BTreeMap, HashMap};
use tremolite_engine::outer_faces::NEAR;
use tremolite_engine::{Base, Model, Side, Stage};
use tremolite_mesh::Face;
use tremolite_mesh::topology::all_faces;

/// The error of stress around an opening from which on a side stands too near.
pub const MOST: f64 = 0.05;

/// A wall of void within the ground: connected faces that lie on no outer plane and are not part of the ground's surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Opening {
    /// Smallest and largest coordinates \[m\].
    pub low: [f64; 3],
    pub high: [f64; 3],
    /// By axis, whether it reaches the low and the high outer plane.
    pub meets: [[bool; 2]; 3],
    /// The elements whose faces it is made of, ascending.
    pub walls: Vec<u32>,
}

/// A boundary near an opening.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearSide {
    /// 0, 1 for sides across x and y, 2 for base and top; the low end of the axis or the high one.
    pub axis: usize,
    pub high: bool,
    /// Half the opening's extent along the boundary, and its distance from there \[m\].
    pub radius: f64,
    pub distance: f64,
    /// Whether another opening reaches the boundary: what changes there is that one's.
    pub met: bool,
}

impl NearSide {
    /// 1.5 (R/(R + d))²: what it changes of the stress around the opening, about.
    pub fn share(&self) -> f64 {
        1.5 * (self.radius / (self.radius + self.distance)).powi(2)
    }

    /// The distance \[m\] from which on that is below [`MOST`].
    pub fn enough(&self) -> f64 {
        self.radius * ((1.5 / MOST).sqrt() - 1.0)
    }

    /// In words.
    pub fn name(&self) -> &'static str {
        match (self.axis, self.high) {
            (0, false) => "xmin",
            (0, true) => "xmax",
            (1, false) => "ymin",
            (1, true) => "ymax",
            (_, false) => "base",
            (_, true) => "top",
        }
    }

    /// Its place among the six planes.
    pub fn plane(&self) -> usize {
        2 * self.axis + usize::from(self.high)
    }
}

/// The openings of what stands in a stage. What reaches the top of the model is the ground's surface, cuts and shafts from there
/// included, and no opening. Caverns that a gallery joins are apart where the void elements are in groups `NAME.PART`, by their names.
pub fn openings(model: &Model, stage: Stage) -> Vec<Opening> {
    let standing = model.standing(stage);
    let (low, high) = model.faces.bounds;
    // Where an interface parts them faces lie at the same places with other nodes.
    let place = |node: u32| model.parted.places.get(node as usize).copied().unwrap_or(node);
    let places = |face: Face| model.mesh.face_nodes(face).map(place).collect::<Vec<u32>>();
    let key = |face: Face| {
        let mut key = [u32::MAX; 4];
        key.iter_mut().zip(places(face)).for_each(|(k, n)| *k = n);
        key.sort_unstable();
        key
    };
    let mut keyed: Vec<([u32; 4], Face)> =
        all_faces(&model.mesh, Some(&standing)).map(|face| (key(face), face)).collect();
    keyed.par_sort_unstable();
    let alone = keyed.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() == 1).map(|same| same[0].1);
    let on = |node: u32, axis: usize, end: usize| {
        let x = model.mesh.nodes[node as usize][axis];
        (x - [low, high][end][axis]).abs() <= NEAR * (high[axis] - low[axis])
    };
    let outer = |face: &Face| {
        (0..3).any(|axis| (0..2).any(|end| model.mesh.face_nodes(*face).all(|n| on(n, axis, end))))
    };
    let walls: Vec<Face> = alone.filter(|face| !outer(face)).collect();
    let caverns = caverns(model, &standing, key);
    let cavern = |face: Face| caverns.get(&key(face)).copied().unwrap_or(0);

    // By cavern and place: places of two caverns are not joined.
    let mut parent: BTreeMap<(u32, u32), (u32, u32)> = BTreeMap::new();
    for &face in &walls {
        let nodes: Vec<(u32, u32)> = places(face).into_iter().map(|place| (cavern(face), place)).collect();
        nodes.iter().for_each(|&n| _ = parent.entry(n).or_insert(n));
        let first = root(&mut parent, nodes[0]);
        for &n in &nodes[1..] {
            let other = root(&mut parent, n);
            let first = root(&mut parent, first);
            parent.insert(first.max(other), first.min(other));
        }
    }
    let mut found: BTreeMap<(u32, u32), Opening> = BTreeMap::new();
    for &face in &walls {
        let first = place(model.mesh.face_nodes(face).next().unwrap_or(0));
        let of = root(&mut parent, (cavern(face), first));
        let opening = found.entry(of).or_insert(Opening {
            low: [f64::INFINITY; 3],
            high: [f64::NEG_INFINITY; 3],
            meets: [[false; 2]; 3],
            walls: Vec::new(),
        });
        opening.walls.push(face.element);
        for n in model.mesh.face_nodes(face) {
            let x = model.mesh.nodes[n as usize];
            for axis in 0..3 {
                opening.low[axis] = opening.low[axis].min(x[axis]);
                opening.high[axis] = opening.high[axis].max(x[axis]);
                (0..2).for_each(|end| opening.meets[axis][end] |= on(n, axis, end));
            }
        }
    }
    let mut openings: Vec<Opening> = found.into_values().filter(|opening| !opening.meets[2][1]).collect();
    for opening in &mut openings {
        opening.walls.sort_unstable();
        opening.walls.dedup();
    }
    openings
}

/// By key of a face of what does not stand, the number of its cavern: of the first part of the name of the smallest group `NAME.PART`
/// that its element is in, from 1 on.
fn caverns(model: &Model, standing: &[u32], key: impl Fn(Face) -> [u32; 4]) -> HashMap<[u32; 4], u32> {
    let mut void = vec![true; model.user.elements];
    standing.iter().for_each(|&e| void[e as usize] = false);
    let mut groups: Vec<(&String, &Vec<u32>)> = model.mesh.groups.iter().collect();
    groups.sort_by_key(|(_, elements)| std::cmp::Reverse(elements.len()));
    let mut names: Vec<&str> = Vec::new();
    let mut of = vec![0; model.user.elements];
    for (name, elements) in groups {
        let Some((cavern, _)) = name.split_once('.') else { continue };
        let number = names.iter().position(|known| *known == cavern).unwrap_or_else(|| {
            names.push(cavern);
            names.len() - 1
        });
        elements.iter().for_each(|&e| of[e as usize] = number as u32 + 1);
    }
    let named: Vec<u32> =
        (0..model.user.elements as u32).filter(|&e| void[e as usize] && of[e as usize] > 0).collect();
    all_faces(&model.mesh, Some(&named)).map(|face| (key(face), of[face.element as usize])).collect()
}

/// The root of a place's tree, halving the path on the way.
fn root(parent: &mut BTreeMap<(u32, u32), (u32, u32)>, mut node: (u32, u32)) -> (u32, u32) {
    while parent[&node] != node {
        let next = parent[&parent[&node]];
        parent.insert(node, next);
        node = next;
    }
    node
}

/// Each boundary that stands for ground that goes on, with the opening for which it is nearest. Periodic sides, those that `mirrored`
/// says stand for a mirror, free ones, and boundaries that all openings reach are none; the top is one where an overburden presses.
pub fn near_sides(model: &Model, mirrored: [bool; 2]) -> Vec<NearSide> {
    // What stands free before the shaking is a specimen, and no ground.
    if model.boundaries.bed.rollers == [false; 2] {
        return Vec::new();
    }
    let openings = openings(model, Stage::Shaking);
    let (low, high) = model.faces.bounds;
    let presses = model.loading.tractions.iter().flat_map(|traction| &traction.faces).any(|(face, _)| {
        let top = |n: u32| (model.mesh.nodes[n as usize][2] - high[2]).abs() <= NEAR * (high[2] - low[2]);
        model.mesh.face_nodes(*face).all(top)
    });
    let side = |axis: usize| {
        let side = model.boundaries.sides[axis];
        side.ends_ground() && !(side == Side::Roller && mirrored[axis])
    };
    let base = model.boundaries.base != Base::Free;
    let judged = [[side(0); 2], [side(1); 2], [base, presses]];
    let mut found = Vec::new();
    for (axis, ends) in judged.into_iter().enumerate() {
        for (end, _) in ends.into_iter().enumerate().filter(|(_, judged)| *judged) {
            let met = openings.iter().any(|opening| opening.meets[axis][end]);
            let of_opening = |opening: &Opening| {
                let along = (0..3).filter(|other| *other != axis).map(|other| extent(model, opening, other));
                let radius = 0.5 * along.fold(f64::INFINITY, f64::min);
                let distance = [opening.low[axis] - low[axis], high[axis] - opening.high[axis]][end];
                NearSide { axis, high: end == 1, radius, distance, met }
            };
            let apart = openings.iter().filter(|opening| !opening.meets[axis][end]).map(of_opening);
            let known = apart.filter(|near| near.radius.is_finite());
            found.extend(known.max_by(|a, b| a.share().total_cmp(&b.share())));
        }
    }
    found
}

/// How far an opening goes along an axis \[m\]: without end where it goes on beyond a side, twice as far where a side mirrors it.
fn extent(model: &Model, opening: &Opening, axis: usize) -> f64 {
    let length = opening.high[axis] - opening.low[axis];
    let mirrors = axis < 2 && model.boundaries.sides[axis] == Side::Roller;
    match opening.meets[axis] {
        [false, false] => length,
        [true, true] => f64::INFINITY,
        _ if mirrors => 2.0 * length,
        _ if axis < 2 => f64::INFINITY,
        _ => length,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;
    use tremolite_engine::{Body, Problem, Quadrature, elastic, hexahedra::centroid};
    use tremolite_laws::Moduli;
    use tremolite_mesh::boxes::BoxSpec;

    /// A block of 40 × 8 × 40 m with a hole of 10 × 10 m, `left` m from xmin and 6 m from the base, that goes through along y, or
    /// from ymin halfway.
    fn model(left: f64, halfway: bool, sides: [Side; 2]) -> Arc<Model> {
        let mesh = BoxSpec::uniform([0.0; 3], [40.0, 8.0, 40.0], [20, 4, 20]).mesh().unwrap();
        let inside = |e: &u32| {
            let [x, y, z] = centroid(&mesh, *e);
            (left..left + 10.0).contains(&x) && (6.0..16.0).contains(&z) && !(halfway && y > 4.0)
        };
        let body = Body {
            name: "rock".into(),
            elements: (0..mesh.elements.len() as u32).filter(|e| !inside(e)).collect(),
            material: elastic(Moduli::from_young_poisson(1e10, 0.25)),
            density: 2700.0,
            quadrature: Quadrature::OnePoint,
            viscosity: 0.0,
        };
        let mut problem = Problem::new(mesh, vec![body]);
        problem.sides = sides;
        problem.base = Base::Fixed;
        Model::new(problem).unwrap()
    }

    /// Two halls of 10 × 10 m, 12 m apart, of 6 m of rock below, with a gallery of 4 × 4 m from one to the other. In groups of their names
    /// each is judged alone; without them the walls hang together and are one opening of 32 m.
    #[test]
    fn halls_joined_by_a_gallery_are_judged_each_alone_at_the_base() {
        let radius = |named: bool| {
            let mut mesh = BoxSpec::uniform([0.0; 3], [80.0, 8.0, 40.0], [40, 4, 20]).mesh().unwrap();
            let of = |e: u32| {
                let [x, _, z] = centroid(&mesh, e);
                let hall = |left: f64| (left..left + 10.0).contains(&x) && (6.0..16.0).contains(&z);
                let gallery = (30.0..42.0).contains(&x) && (8.0..12.0).contains(&z);
                [hall(20.0), hall(42.0), gallery].iter().position(|inside| *inside)
            };
            let all: Vec<Option<usize>> = (0..mesh.elements.len() as u32).map(of).collect();
            let pick = |want| (0u32..).zip(&all).filter(|(_, of)| **of == want).map(|(e, _)| e).collect();
            let body = Body {
                name: "rock".into(),
                elements: pick(None),
                material: elastic(Moduli::from_young_poisson(1e10, 0.25)),
                density: 2700.0,
                quadrature: Quadrature::OnePoint,
                viscosity: 0.0,
            };
            for (k, name) in ["a.bench1", "b.bench1", "way.gallery"].into_iter().enumerate().filter(|_| named)
            {
                mesh.groups.insert(name.to_owned(), pick(Some(k)));
            }
            let mut problem = Problem::new(mesh, vec![body]);
            problem.sides = [Side::Fixed, Side::Periodic];
            problem.base = Base::Fixed;
            let model = Model::new(problem).unwrap();
            near_sides(&model, [false; 2]).iter().find(|near| near.name() == "base").map(|near| near.radius)
        };
        assert_eq!([false, true].map(radius), [Some(16.0), Some(5.0)]);
    }

    fn of(model: &Model, mirrored: [bool; 2]) -> Vec<(&'static str, f64, f64)> {
        let near = near_sides(model, mirrored);
        near.iter().map(|near| (near.name(), near.radius, near.distance)).collect()
    }

    #[test]
    fn a_hole_through_the_model_is_judged_at_the_sides_beside_it_and_at_the_base() {
        let found = of(&model(4.0, false, [Side::Fixed, Side::Periodic]), [false; 2]);
        assert_eq!(found, [("xmin", 5.0, 4.0), ("xmax", 5.0, 26.0), ("base", 5.0, 6.0)]);
        let near = NearSide { axis: 0, high: false, radius: 5.0, distance: 3.5, met: false };
        assert!((near.share() - 0.519).abs() < 1e-3 && (near.enough() - 22.4).abs() < 0.05);
    }

    #[test]
    fn sides_that_mirror_repeat_or_are_met_are_none_and_a_mirror_doubles() {
        // Against xmin, where a roller stands for a mirror: the hole is 20 m wide.
        let found = of(&model(0.0, false, [Side::Roller, Side::Periodic]), [true, false]);
        assert_eq!(found, [("base", 10.0, 6.0)]);
        let found = of(&model(0.0, false, [Side::Roller, Side::Periodic]), [false; 2]);
        assert_eq!(found, [("xmax", 5.0, 30.0), ("base", 10.0, 6.0)]);
        // Beyond the end wall of a hole that ends in the rock there are 4 m.
        let found = of(&model(10.0, true, [Side::Fixed; 2]), [false; 2]);
        assert_eq!(found, [("xmin", 5.0, 10.0), ("xmax", 5.0, 20.0), ("ymax", 5.0, 4.0), ("base", 5.0, 6.0)]);
        assert!(of(&model(4.0, false, [Side::Free, Side::Periodic]), [false; 2]).len() == 1);
    }
}
