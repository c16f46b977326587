//! What cannot be, and what of the ground heads reach.

use crate::ground::{Ground, SeepageError};
use crate::places::{Holds, Node, Place};

/// Refuses what cannot be.
pub(crate) fn check(ground: &Ground, places: &[Place]) -> Result<(), SeepageError> {
    let refuse = |reason: String| Err(SeepageError::Input(reason));
    let count = ground.nodes.len();
    if ground.conductivity.len() != ground.elements.len() {
        return refuse("give a conductivity for each element".into());
    }
    if let Some(k) = ground.conductivity.iter().find(|k| !(k.is_finite() && **k > 0.0)) {
        return refuse(format!("a conductivity is {k} m/s: it must be positive"));
    }
    let named = places.iter().flat_map(|place| place.nodes.iter().map(|(n, _)| *n));
    if let Some(n) = ground.elements.iter().flatten().copied().chain(named).find(|n| *n as usize >= count) {
        return refuse(format!("node {n} is named, and there are {count}"));
    }
    let finite = |place: &Place| match place.holds {
        Holds::Head(head) | Holds::Open(Some(head)) => head.is_finite(),
        Holds::Open(None) => true,
    };
    if let Some(place) = places.iter().find(|place| !finite(place)) {
        return refuse(format!("the head of '{}' is no number", place.name));
    }
    Ok(())
}

/// The elements that heads reach. From others, which are open somewhere, all water has left.
pub(crate) fn reached(ground: &Ground, kinds: &[Node]) -> Result<Vec<usize>, SeepageError> {
    let mut parent: Vec<u32> = (0..ground.nodes.len() as u32).collect();
    for corners in ground.elements {
        let first = root(&mut parent, corners[0]);
        for &n in corners {
            let other = root(&mut parent, n);
            parent[other as usize] = first;
        }
    }
    let (mut has_head, mut is_open) = (vec![false; ground.nodes.len()], vec![false; ground.nodes.len()]);
    for (n, kind) in kinds.iter().enumerate() {
        let root = root(&mut parent, n as u32) as usize;
        match kind {
            Node::Held(_) => has_head[root] = true,
            Node::Outlet => is_open[root] = true,
            Node::Free => {}
        }
    }
    let mut wet = Vec::new();
    for (e, corners) in ground.elements.iter().enumerate() {
        let root = root(&mut parent, corners[0]) as usize;
        if has_head[root] {
            wet.push(e);
        } else if !is_open[root] {
            return Err(SeepageError::Apart(e));
        }
    }
    Ok(wet)
}

/// The node that stands for all that hang together with one.
fn root(parent: &mut [u32], mut n: u32) -> u32 {
    while parent[n as usize] != n {
        parent[n as usize] = parent[parent[n as usize] as usize];
        n = parent[n as usize];
    }
    n
}

/// The nodes of elements, ascending.
pub(crate) fn corners(ground: &Ground, elements: &[usize]) -> Vec<u32> {
    let mut is_used = vec![false; ground.nodes.len()];
    elements.iter().flat_map(|&e| ground.elements[e]).for_each(|n| is_used[n as usize] = true);
    (0..ground.nodes.len() as u32).filter(|&n| is_used[n as usize]).collect()
}

/// The place of each node among those that are used.
pub(crate) fn number(used: &[u32], count: usize) -> Vec<u32> {
    let mut numbers = vec![u32::MAX; count];
    used.iter().enumerate().for_each(|(i, &n)| numbers[n as usize] = i as u32);
    numbers
}
