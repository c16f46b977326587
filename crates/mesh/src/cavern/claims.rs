//! How much of the block each cavern claims: the rectangle that its rings of rock fill.

use super::error::ROCK;
use super::profile::Outline;
use super::rows::Counts;
use super::{CavernError, CavernSpec};

/// Rectangle round a cavern while the layout is made. Axis 0 is x, axis 1 is z.
pub(super) struct Claim {
    /// The outside of lining and shotcrete.
    pub body: [[f64; 2]; 2],
    /// Rock between it and the rectangle, by axis and side.
    pub margin: [[f64; 2]; 2],
}

impl Claim {
    pub fn bound(&self, axis: usize, side: usize) -> f64 {
        self.body[side][axis] + [-1.0, 1.0][side] * self.margin[axis][side]
    }

    pub fn bounds(&self, axis: usize) -> [f64; 2] {
        [self.bound(axis, 0), self.bound(axis, 1)]
    }
}

/// Rock between extrados and rectangle that gives well-shaped rings, by axis and side. `footed`: a gallery's floor is at
/// the cavern's foot.
pub(super) fn margins(near: f64, outline: &Outline, counts: &Counts, footed: bool) -> [[f64; 2]; 2] {
    let profile = match outline {
        Outline::Walls(profile) => profile,
        // Lines from corner to corner at half a right angle, the same on all sides.
        Outline::Closed(tube) => return [[(0.2 * tube.height).max(2.2 * near); 2]; 2],
    };
    // The edges at the foot fan out into as many rows at the rectangle's side.
    let below = if footed {
        // There these rows are all, and they share it with the row in place of a slab.
        ((1.1 * counts.inset as f64 + 0.3) * near).max(1.6 * near)
    } else {
        (1.2 * (counts.inset + 1) as f64 * near).max(2.2 * near)
    };
    let above = (1.6 * near).max(0.5 * profile.outer.rise);
    // The line from the tied point of the arch, the springing or half-way up, to the rectangle's corner must
    // not lean too much.
    let rise = if counts.ring > 0 { 0.3 * profile.outer.rise } else { profile.outer.rise };
    let side = (0.75 * (rise + above)).max(2.2 * near);
    [[side; 2], [below, above]]
}

/// Makes the margins fit between neighbours and within the block.
pub(super) fn shrink(
    spec: &CavernSpec,
    claims: &mut [Claim],
    block: [[f64; 2]; 2],
) -> Result<(), CavernError> {
    let needed = ROCK * spec.near;
    for (k, claim) in claims.iter_mut().enumerate() {
        for axis in 0..2 {
            for side in 0..2 {
                let rock = (block[axis][side] - claim.body[side][axis]).abs();
                let inside = (block[axis][side] - claim.body[side][axis]) * [-1.0, 1.0][side] > 0.0;
                if !inside || rock < needed {
                    let key = [["sides", "sides"], ["below", "overburden"]][axis][side];
                    let rock = if inside { rock } else { -rock };
                    let cavern = spec.caverns[k].name.clone();
                    return Err(CavernError::TooNearToEdge { cavern, key, rock, needed });
                }
                claim.margin[axis][side] = claim.margin[axis][side].min(rock / 2.0);
            }
        }
    }
    for b in 1..claims.len() {
        for a in 0..b {
            let gap = |axis: usize| {
                let [a, b] = [&claims[a].body, &claims[b].body];
                let (right, left) = (b[0][axis] - a[1][axis], a[0][axis] - b[1][axis]);
                if right >= left { (right, 1) } else { (left, 0) }
            };
            let axis = if gap(0).0 >= gap(1).0 { 0 } else { 1 };
            let (rock, side) = gap(axis);
            if rock < needed {
                let [first, second] = [a, b].map(|k| spec.caverns[k].name.clone());
                return Err(CavernError::TooClose { first, second, rock, needed });
            }
            let [mine, theirs] = [claims[a].margin[axis][side], claims[b].margin[axis][1 - side]];
            // Two rectangles with less than an element between them share a line instead.
            if mine + theirs + 0.8 * spec.near > rock {
                claims[a].margin[axis][side] = rock * mine / (mine + theirs);
                claims[b].margin[axis][1 - side] = rock * theirs / (mine + theirs);
            }
        }
    }
    Ok(())
}

/// Moves rectangles' bounds that lie near a gallery's floor or roof there, so that one line serves both; not those of
/// caverns that the gallery meets.
pub(super) fn meet_levels(near: f64, claims: &mut [Claim], levels: &[f64]) {
    for claim in claims {
        let [low, high] = [claim.body[0][1], claim.body[1][1]];
        // A level at a foot may come out a hair lower.
        for &level in levels.iter().filter(|l| **l < low - 1e-6 || **l > high) {
            let side = usize::from(level > high);
            let margin = (level - claim.body[side][1]).abs();
            if (margin - claim.margin[1][side]).abs() < 0.7 * near && margin > 0.6 * near {
                claim.margin[1][side] = margin;
            }
        }
    }
}
