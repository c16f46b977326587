//! Heads of bolts that are placed, lest two come too near.

use super::wall::{Vector, minus, norm};
use std::collections::HashMap;

/// Heads at least some distance apart.
#[derive(Clone, Debug)]
pub struct Heads {
    /// m
    apart: f64,
    /// By cubes as large as the distance.
    cubes: HashMap<[i64; 3], Vec<Vector>>,
}

impl Heads {
    /// `apart` \[m\] is above 0.
    pub fn new(apart: f64) -> Self {
        Heads { apart, cubes: HashMap::new() }
    }

    /// Takes a head, unless another one is nearer than the distance.
    pub fn take(&mut self, at: Vector) -> bool {
        let own = at.map(|x| (x / self.apart).floor() as i64);
        let near = |cube: [i64; 3]| {
            let heads = self.cubes.get(&cube);
            // Those just as far apart stay, whatever the round-off.
            heads.is_some_and(|all| all.iter().any(|&x| norm(minus(x, at)) < (1.0 - 1e-9) * self.apart))
        };
        let around = (0..27).map(|i| [own[0] + i / 9 - 1, own[1] + i / 3 % 3 - 1, own[2] + i % 3 - 1]);
        if around.into_iter().any(near) {
            return false;
        }
        self.cubes.entry(own).or_default().push(at);
        true
    }
}
