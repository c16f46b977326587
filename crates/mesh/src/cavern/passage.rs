//! Galleries in the block: where they run, and which rows of the grid they take.
//!
//! A row of the grid runs from one cavern's wall through the rings of rock round it to the other's. Floors and roofs
//! are lines of the grid; on the walls and in the rings the nodes of their rows are held at the same levels.

use super::gallery::{Gallery, LEAST};
use super::plot::{Pin, Plot};
use super::profile::Outline;
use super::spread::Spread;
use super::stretch::relax;
use super::{CavernError, CavernSpec};

/// A gallery's place in the block.
#[derive(Clone, Debug)]
pub(super) struct Passage {
    /// The cavern on the left and the one on the right.
    pub caverns: [usize; 2],
    /// From the outside of one's lining and shotcrete to that of the other's.
    pub x: [f64; 2],
    pub z: [f64; 2],
}

fn refuse(gallery: &Gallery, why: impl Into<String>) -> CavernError {
    CavernError::Gallery { gallery: gallery.name.clone(), why: why.into() }
}

/// The galleries' places, their floors and roofs at the walls of both caverns.
pub(super) fn find(spec: &CavernSpec, plots: &[Plot]) -> Result<Vec<Passage>, CavernError> {
    let mut passages: Vec<Passage> = Vec::with_capacity(spec.galleries.len());
    // Levels that differ by round-off are one.
    let mut known: Vec<f64> = plots.iter().map(|p| p.centre[1]).collect();
    for gallery in &spec.galleries {
        let find = |name: &String| spec.caverns.iter().position(|c| c.name == *name);
        let (Some(a), Some(b)) = (find(&gallery.between[0]), find(&gallery.between[1])) else {
            return Err(refuse(gallery, "names a cavern in `between` that there is not"));
        };
        let (a, b) = if plots[a].centre[0] <= plots[b].centre[0] { (a, b) } else { (b, a) };
        if a == b {
            return Err(refuse(gallery, BESIDE));
        }
        let (Outline::Walls(left), Outline::Walls(right)) = (&plots[a].outline, &plots[b].outline) else {
            return Err(refuse(
                gallery,
                "needs two caverns with straight walls in `between`, not circles or horseshoes",
            ));
        };
        let x = [plots[a].centre[0] + left.outer.half, plots[b].centre[0] - right.outer.half];
        let floor = -spec.overburden - spec.caverns[0].height + gallery.at[1];
        let z = [floor, floor + gallery.height].map(|level| {
            let same = known.iter().find(|k| (**k - level).abs() < 1e-6).copied();
            same.unwrap_or_else(|| {
                known.push(level);
                level
            })
        });
        for (k, profile) in [(a, left), (b, right)] {
            let [low, high] = [0.0, profile.inner.springing].map(|v| plots[k].centre[1] + v);
            let gap = LEAST * spec.near;
            if (z[0] - low).abs() > 1e-6 && z[0] < low + gap || z[1] > high - gap {
                // As `at` counts, from the first cavern's floor.
                let base = floor - gallery.at[1];
                return Err(refuse(
                    gallery,
                    format!(
                        "does not lie on the straight wall of cavern {:?}: with `at` as it counts, its floor must be \
                         at {:.3} m or from {:.3} m up, and its roof, {:.3} m, at most at {:.3} m; change `at` or \
                         `height`",
                        spec.caverns[k].name,
                        low - base,
                        low + gap - base,
                        z[1] - base,
                        high - gap - base
                    ),
                ));
            }
        }
        for (other, place) in spec.galleries.iter().zip(&passages) {
            let apart = |a: [f64; 2], b: [f64; 2]| a[1] <= b[0] + 1e-9 || b[1] <= a[0] + 1e-9;
            if !apart(x, place.x) && !apart(z, place.z) && !apart(gallery.walls(), other.walls()) {
                return Err(refuse(gallery, format!("overlaps gallery {:?}; move it with `at`", other.name)));
            }
        }
        passages.push(Passage { caverns: [a, b], x, z });
    }
    apart(spec, &passages)?;
    Ok(passages)
}

const BESIDE: &str = "needs two caverns in `between` that stand beside one another";

/// Levels and walls of different galleries that nearly meet would leave elements without a use.
fn apart(spec: &CavernSpec, passages: &[Passage]) -> Result<(), CavernError> {
    let least = LEAST * spec.near.min(spec.along.unwrap_or(spec.near));
    for (k, gallery) in spec.galleries.iter().enumerate() {
        for (other, theirs) in spec.galleries[..k].iter().zip(passages) {
            let shared = passages[k].caverns.iter().any(|c| theirs.caverns.contains(c));
            let near = |a: [f64; 2], b: [f64; 2]| {
                let gaps = a.iter().flat_map(|a| b.map(|b| (a - b).abs()));
                gaps.filter(|gap| *gap > 1e-6 && *gap < least).reduce(f64::min)
            };
            let levels = near(passages[k].z, theirs.z).filter(|_| shared);
            let walls = near(gallery.walls(), other.walls());
            for (gap, what) in [(levels, "floor or roof"), (walls, "wall in y")] {
                if let Some(gap) = gap {
                    let why = format!(
                        "has a {what} {gap:.3} m from one of gallery {:?}; make them one or {least:.3} m apart with \
                         `at`, `width` or `height`, or lower `size_near`",
                        other.name
                    );
                    return Err(refuse(gallery, why));
                }
            }
        }
    }
    Ok(())
}

/// Height of a level over a foot; of one there none at all.
fn over(level: f64, foot: f64) -> f64 {
    if (level - foot).abs() < 1e-6 { 0.0 } else { level - foot }
}

/// Levels over the foot, rising, at which galleries ask for nodes on the walls of cavern `k`.
pub(super) fn levels(passages: &[Passage], k: usize, foot: f64) -> Vec<f64> {
    let mine = passages.iter().filter(|p| p.caverns.contains(&k));
    let mut levels: Vec<f64> = mine.flat_map(|p| p.z).map(|z| over(z, foot)).collect();
    levels.sort_by(f64::total_cmp);
    levels.dedup();
    levels
}

/// Sets the rows of the walls that galleries meet, from the grid's lines.
pub(super) fn pin(
    spec: &CavernSpec,
    passages: &[Passage],
    z: &[f64],
    plots: &mut [Plot],
) -> Result<(), CavernError> {
    for (gallery, passage) in spec.galleries.iter().zip(passages) {
        let [a, b] = passage.caverns;
        if plots[a].columns.end > plots[b].columns.start {
            return Err(refuse(gallery, BESIDE));
        }
        let crossed = plots.iter().enumerate().any(|(k, plot)| {
            k != a
                && k != b
                && plot.columns.start < plots[b].columns.start
                && plot.columns.end > plots[a].columns.end
                && z[plot.rows.start] < passage.z[1]
                && z[plot.rows.end] > passage.z[0]
        });
        if crossed {
            return Err(refuse(
                gallery,
                "would cross the surroundings of another cavern; name neighbours in `between`, or move it with `at`",
            ));
        }
        for level in passage.z {
            for (k, side) in [(a, 1), (b, 0)] {
                let row = z.iter().position(|z| *z == level);
                let Some(node) =
                    row.and_then(|row| row.checked_sub(plots[k].first_row() + plots[k].rows.start))
                else {
                    return Err(CavernError::GalleryRows { gallery: gallery.name.clone(), near: spec.near });
                };
                let level = over(level, plots[k].centre[1]);
                let pins = &mut plots[k].pins;
                match pins.iter_mut().find(|pin| pin.node == node) {
                    Some(pin) => pin.sides[side] = true,
                    None => pins.push(Pin { node, level, sides: [side == 0, side == 1] }),
                }
            }
        }
    }
    for (k, plot) in plots.iter_mut().enumerate() {
        let (Some(stops), Outline::Walls(profile)) = (&plot.stops, &plot.outline) else { continue };
        let mut pins: Vec<(usize, f64)> = plot.pins.iter().map(|pin| (pin.node, pin.level)).collect();
        pins.extend([(0, 0.0), (plot.counts.wall, profile.inner.springing)]);
        pins.sort_by(|a, b| (a.0, a.1).partial_cmp(&(b.0, b.1)).unwrap_or(std::cmp::Ordering::Equal));
        pins.dedup();
        match stops.rows(&pins) {
            Some(rows) => plot.wall = rows,
            None => {
                let meets = |p: &(&Gallery, &Passage)| p.1.caverns.contains(&k);
                let mut galleries = spec.galleries.iter().zip(passages);
                let Some((gallery, _)) = galleries.find(meets) else { continue };
                return Err(CavernError::GalleryRows { gallery: gallery.name.clone(), near: spec.near });
            }
        }
    }
    Ok(())
}

/// Planes across y, with those of the galleries' walls; y = 0 is one, unless a wall is too near to it.
pub(super) fn planes(spec: &CavernSpec, along: f64) -> Vec<f64> {
    let half = 0.5 * spec.length;
    let mut stops = vec![-half, half];
    stops.extend(spec.galleries.iter().flat_map(Gallery::walls));
    if stops.iter().all(|y| y.abs() > 0.3 * along) {
        stops.push(0.0);
    }
    stops.sort_by(f64::total_cmp);
    // Walls that differ by round-off are one.
    stops.dedup_by(|a, b| *a - *b < 1e-6);
    let spread = Spread::new(&stops, along);
    let mut line = vec![-half];
    for i in 0..stops.len() - 1 {
        let n = (spread.wanted(i) - 0.25).ceil().max(1.0);
        spread.fill(i, n as usize, &mut line);
    }
    relax(&mut line, &stops);
    line
}
