//! How many rows and columns of elements each stretch of the grid gets.

use super::Cavern;
use super::profile::Outline;
use super::stretch::MOST_GROWTH;

/// Numbers of elements that describe one cavern's part of the section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Counts {
    /// Columns of the core of the opening, and edges of the middle part of the arch; even.
    pub columns: usize,
    /// Rows along the straight walls.
    pub wall: usize,
    /// Edges of the arch on either side that belong to the sides of the core; 0 for a flat arch.
    pub flank: usize,
    /// Rings between core and intrados; 1 for a steep arch, else 0.
    pub ring: usize,
    /// Layers of lining and shotcrete, 0 if none.
    pub layers: usize,
    /// Of them the outermost, which are shotcrete.
    pub shotcrete: usize,
    /// Rows of the floor slab, or of rock in its place where a gallery's floor is at the foot; 0 if none.
    pub slab: usize,
    /// Edges below the cavern from the foot of the lining (or of its slab) to the point that is tied to the
    /// rectangle's lower corner.
    pub inset: usize,
    /// Whether the outline is a closed curve; then only columns, wall and layers matter.
    pub closed: bool,
}

impl Counts {
    /// The numbers that follow from the shape alone; `columns` and `wall` wait for the grid, `inset` is the
    /// usual one.
    ///
    /// A flat arch meets the walls at a marked angle, which serves as a corner of the core. A steep one runs
    /// smoothly into them: the core then has its corners half-way up the arch, inside a ring.
    pub fn new(cavern: &Cavern, outline: &Outline, near: f64) -> Self {
        let lining = if cavern.lining.is_none() { 0 } else { cavern.lining.layers as usize };
        let shotcrete = if cavern.shotcrete.is_none() { 0 } else { cavern.shotcrete.layers as usize };
        let layers = lining + shotcrete;
        let profile = match outline {
            Outline::Walls(profile) => profile,
            // Corner is tied to corner: a row of the rectangle for each of the walls, a column for each of the
            // crown.
            Outline::Closed(_) => {
                let (columns, wall, slab, inset) = (0, 0, 0, 0);
                return Counts {
                    columns,
                    wall,
                    flank: 0,
                    ring: 0,
                    layers,
                    shotcrete,
                    slab,
                    inset,
                    closed: true,
                };
            }
        };
        let steep = profile.inner.angle > 70f64.to_radians();
        let flank = if steep { ((0.2 * profile.inner.length() / near).round() as usize).max(1) } else { 0 };
        let slab = if cavern.lining.floor > 0.0 { lining } else { 0 };
        let ring = usize::from(steep);
        let inset = layers + ring;
        Counts { columns: 0, wall: 0, flank, ring, layers, shotcrete, slab, inset, closed: false }
    }

    /// Rows of the rectangle round the cavern beyond those of the straight walls. With the usual inset the
    /// rectangle's upper corners are tied to the corners of the core; each edge less moves them an edge down.
    pub fn extra_rows(&self) -> isize {
        if self.closed {
            return 0;
        }
        (self.flank + self.slab + 2 * self.inset) as isize - (self.ring + self.layers) as isize
    }

    /// Columns of the rectangle beyond those of the core.
    pub fn extra_columns(&self) -> isize {
        if self.closed {
            return 0;
        }
        2 * ((self.ring + self.layers) as isize - self.inset as isize)
    }

    /// Columns of the opening at its floor.
    pub fn floor(&self) -> usize {
        self.columns + 2 * self.ring
    }

    /// Edges along walls and arch, from the left foot over the crown to the right foot.
    pub fn vault(&self) -> usize {
        2 * (self.wall + self.flank) + self.columns
    }
}

/// What one cavern would like of the stretches it covers along one axis.
pub(super) struct Wish {
    /// First stretch and one past the last.
    pub stretches: std::ops::Range<usize>,
    /// Wished number over all of them.
    pub ideal: f64,
    /// How many of the number are not for the divisible part (or lack from it).
    pub extra: isize,
    /// The rest should be a multiple of this, and at least this.
    pub multiple: usize,
    /// Weight of missing the multiple.
    pub weight: f64,
    /// Whether no more are of use: the number is `extra`.
    pub exact: bool,
    /// What it costs to have so many more than `multiple`; more than there are here cost as much as the last. Empty: what
    /// missing the multiple costs.
    pub uneven: Vec<f64>,
}

impl Wish {
    fn cost(&self, counts: &[usize]) -> f64 {
        let total: usize = counts[self.stretches.clone()].iter().sum();
        let rest = total as isize - self.extra;
        if self.exact {
            return 1e6 * rest.unsigned_abs() as f64;
        }
        if rest < self.multiple as isize {
            return 1e6 * (1 + self.multiple as isize - rest) as f64;
        }
        let rest = rest as usize;
        let off = (rest as f64 / (self.ideal - self.extra as f64)).ln();
        if let Some(last) = self.uneven.last() {
            return 4.0 * off * off + self.uneven.get(rest - self.multiple).unwrap_or(last);
        }
        // Rows of a bench that gets one row more than another differ in height by this ratio.
        let uneven = rest.div_ceil(self.multiple) as f64 / (rest / self.multiple) as f64;
        4.0 * off * off + self.weight * (uneven - 1.0)
    }
}

/// How much the sizes in neighbouring stretches differ, beyond what their elements can bridge with the largest growth.
fn abrupt(counts: &[usize], length: &[f64]) -> f64 {
    let pairs = counts.windows(2).zip(length.windows(2)).filter(|(n, _)| n[0] > 0 && n[1] > 0);
    pairs
        .map(|(n, l)| {
            let ratio = (l[0] / n[0] as f64) / (l[1] / n[1] as f64);
            let bridged = MOST_GROWTH.ln() * 0.5 * (n[0] + n[1]) as f64;
            (ratio.ln().abs() - bridged).max(0.0).powi(2)
        })
        .sum()
}

/// Whole numbers for the stretches of lengths `length`: near the caverns' wishes and evenly spread.
///
/// A descent from the rounded ideal; the numbers of stretches outside all wishes are
/// left at 0.
pub(super) fn whole_numbers(length: &[f64], wishes: &[Wish]) -> Vec<usize> {
    let density: Vec<f64> = (0..length.len())
        .map(|i| {
            let covering = wishes.iter().filter(|w| w.stretches.contains(&i));
            covering.map(|w| w.ideal / length[w.stretches.clone()].iter().sum::<f64>()).fold(0.0, f64::max)
        })
        .collect();
    let mut counts: Vec<usize> = density
        .iter()
        .zip(length)
        .map(|(d, l)| if *d > 0.0 { ((d * l).round() as usize).max(1) } else { 0 })
        .collect();
    let cost = |counts: &[usize]| -> f64 {
        let spread: f64 = (0..counts.len())
            .filter(|&i| density[i] > 0.0)
            .map(|i| (counts[i] as f64 / (density[i] * length[i])).ln().powi(2))
            .sum();
        4.0 * spread + 16.0 * abrupt(counts, length) + wishes.iter().map(|w| w.cost(counts)).sum::<f64>()
    };
    // One stretch more or less, or one given to another: neighbours' wishes may conflict along the way.
    let inside: Vec<usize> = (0..counts.len()).filter(|&i| density[i] > 0.0).collect();
    let mut moves: Vec<Vec<(usize, isize)>> = Vec::new();
    for (place, &i) in inside.iter().enumerate() {
        moves.extend([-3, -2, -1, 1, 2, 3].map(|step| vec![(i, step)]));
        for &j in inside.iter().skip(place + 1).take(4) {
            moves.extend([vec![(i, 1), (j, -1)], vec![(i, -1), (j, 1)]]);
        }
    }
    let mut best = cost(&counts);
    // Each round lowers the cost; the bound only guards against a very long descent.
    for _ in 0..1000 {
        let before = best;
        for steps in &moves {
            let mut trial = counts.clone();
            let possible = steps.iter().all(|&(i, step)| {
                trial[i] = trial[i].saturating_add_signed(step);
                trial[i] > 0
            });
            if possible && cost(&trial) < best - 1e-12 {
                best = cost(&trial);
                counts = trial;
            }
        }
        if best == before {
            break;
        }
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn benches_get_equal_rows_where_a_small_change_allows_it() {
        let wishes = [
            Wish {
                stretches: 0..2,
                ideal: 13.4,
                extra: 1,
                multiple: 6,
                weight: 1.0,
                exact: false,
                uneven: vec![],
            },
            Wish {
                stretches: 0..1,
                ideal: 9.6,
                extra: 1,
                multiple: 4,
                weight: 1.0,
                exact: false,
                uneven: vec![],
            },
        ];
        let counts = whole_numbers(&[30.0, 16.0, 50.0], &wishes);
        assert_eq!((counts[0] - 1) % 4, 0, "{counts:?}");
        assert_eq!((counts[0] + counts[1] - 1) % 6, 0, "{counts:?}");
        assert_eq!(counts[2], 0);
    }

    #[test]
    fn a_wish_for_more_benches_than_rows_is_met() {
        let wishes = [Wish {
            stretches: 0..1,
            ideal: 3.2,
            extra: 2,
            multiple: 7,
            weight: 1.0,
            exact: false,
            uneven: vec![],
        }];
        assert!(whole_numbers(&[10.0], &wishes)[0] >= 9);
    }
}
