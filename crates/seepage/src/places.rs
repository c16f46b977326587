//! Where water comes in and leaves.

/// What holds at the nodes of a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Holds {
    /// Still water up to a height \[m\] outside: that head at nodes at or below it, nothing flows above.
    Head(f64),
    /// Open to a void: water leaves at the pressure of the air, or nothing flows. With a level \[m\] the void is full up to it, and that
    /// head holds at nodes below.
    Open(Option<f64>),
}

/// Nodes at which water may come in or leave, under a name by which the flow is told.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    pub name: String,
    pub holds: Holds,
    /// Nodes, each with its share of the place, an area or 1: of several places at a node each is given as much of its flow. Of an open one
    /// and one with a head the open one holds.
    pub nodes: Vec<(u32, f64)>,
}

impl Place {
    /// A place of faces, each of three or four nodes, the nodes' shares being those of the faces' areas.
    pub fn of_faces(
        name: impl Into<String>,
        holds: Holds,
        faces: impl IntoIterator<Item = Vec<u32>>,
        nodes: &[[f64; 3]],
    ) -> Self {
        let mut shares: Vec<(u32, f64)> = Vec::new();
        for face in faces {
            let share = area(&face, nodes) / face.len() as f64;
            shares.extend(face.iter().map(|&n| (n, share)));
        }
        shares.sort_by_key(|&(n, _)| n);
        let sum = |one: &[(u32, f64)]| (one[0].0, one.iter().map(|(_, s)| s).sum());
        let nodes = shares.chunk_by(|a, b| a.0 == b.0).map(sum).collect();
        Place { name: name.into(), holds, nodes }
    }
}

/// Area of a face \[m²\]: half the cross product of its diagonals, or of two edges.
fn area(face: &[u32], nodes: &[[f64; 3]]) -> f64 {
    let at = |k: usize| nodes[face[k] as usize];
    let less = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let (u, v) = match face.len() {
        4 => (less(at(2), at(0)), less(at(3), at(1))),
        _ => (less(at(1), at(0)), less(at(2), at(0))),
    };
    let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    0.5 * cross.iter().map(|c| c * c).sum::<f64>().sqrt()
}

/// What holds at a node of the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Node {
    Free,
    /// A head \[m\].
    Held(f64),
    /// Water leaves, or nothing flows.
    Outlet,
}

/// What holds at each node, by all places.
pub(crate) fn nodes(places: &[Place], coordinates: &[[f64; 3]]) -> Vec<Node> {
    let mut all = vec![Node::Free; coordinates.len()];
    let heights = coordinates.iter().map(|x| x[2].abs()).fold(0.0, f64::max);
    let near = 1e-9 * heights;
    let (open, heads): (Vec<&Place>, Vec<&Place>) =
        places.iter().partition(|place| matches!(place.holds, Holds::Open(_)));
    for place in heads.into_iter().chain(open) {
        for &(n, _) in &place.nodes {
            let z = coordinates[n as usize][2];
            let node = &mut all[n as usize];
            match place.holds {
                Holds::Head(head) if z <= head + near => *node = Node::Held(head),
                Holds::Head(_) => {}
                Holds::Open(Some(level)) if z <= level => *node = Node::Held(level),
                Holds::Open(_) => *node = Node::Outlet,
            }
        }
    }
    all
}

/// Flow \[m³/s\] that comes out of the ground at each place, of that at each node.
pub(crate) fn outflows(places: &[Place], out: &[f64]) -> Vec<f64> {
    let rank = |place: &Place| usize::from(matches!(place.holds, Holds::Open(_)));
    let mut highest = vec![0; out.len()];
    let each = || {
        places.iter().flat_map(|place| place.nodes.iter().map(move |&(n, share)| (place, n as usize, share)))
    };
    each().for_each(|(place, n, _)| highest[n] = highest[n].max(rank(place)));
    let mut shares = vec![0.0; out.len()];
    let counts = |place: &Place, n: usize| rank(place) == highest[n];
    each().filter(|(place, n, _)| counts(place, *n)).for_each(|(_, n, share)| shares[n] += share);
    let of = |place: &Place| {
        let own = place.nodes.iter().map(|&(n, share)| (n as usize, share));
        own.filter(|&(n, _)| counts(place, n) && shares[n] > 0.0)
            .map(|(n, share)| out[n] * share / shares[n])
            .fold(0.0, |sum, q| sum + q)
    };
    places.iter().map(of).collect()
}
