//! Along y: where caverns end, and the planes of nodes across.

use super::error::value;
use super::gallery::{Gallery, LEAST};
use super::spread::Spread;
use super::stretch::{End, GROWTH, MOST_GROWTH, growth, relax, stretch};
use super::{Cavern, CavernError, CavernSpec, passage};

/// Places that differ by less are one \[m\].
pub(super) const SAME: f64 = 1e-6;

/// Ways to divide the intervals between stops; one more element in a few of them is enough.
const MOST_TRIES: usize = 20;

impl CavernSpec {
    /// Size along the caverns.
    pub(super) fn step(&self) -> f64 {
        self.along.unwrap_or(self.near)
    }

    /// y of the block's faces.
    fn faces(&self) -> [f64; 2] {
        [-0.5 * self.length, 0.5 * self.length]
    }

    /// y of a cavern's ends; the block's very faces where it goes through.
    pub(super) fn ends(&self, cavern: &Cavern) -> [f64; 2] {
        let faces = self.faces();
        let Some(length) = cavern.length else { return faces };
        [0, 1].map(|side| {
            let end = cavern.middle + [-0.5, 0.5][side] * length;
            if (end - faces[side]).abs() < SAME { faces[side] } else { end }
        })
    }

    /// From the first end of any cavern to the last.
    fn hull(&self) -> [f64; 2] {
        let ends = self.caverns.iter().map(|c| self.ends(c));
        ends.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]).unwrap_or(self.faces())
    }

    /// About how many elements lie along y, or fewer; an even number if no cavern ends in rock.
    pub(super) fn rows(&self) -> f64 {
        let [from, to] = self.hull();
        let length = if [from, to] == self.faces() { self.length } else { to - from };
        2.0 * (length / self.step() / 2.0).round().max(1.0)
    }
}

/// Whether the caverns' lengths suit the block, one another and the galleries.
pub(super) fn check(spec: &CavernSpec) -> Result<(), CavernError> {
    let (step, faces) = (spec.step(), spec.faces());
    for (k, cavern) in spec.caverns.iter().enumerate() {
        let Some(length) = cavern.length else { continue };
        let refuse =
            |key: &str, at: f64, must: String| Err(value(format!("{}.{key}", cavern.name), at, must));
        if !(length > 0.0 && length <= spec.length + SAME) {
            let must = format!(
                "above 0 and at most the block's, {} m, without it the cavern goes through",
                spec.length
            );
            return refuse("length", length, must);
        }
        if length < step - SAME {
            let must = format!("at least an element's along the caverns, {step} m, or `size_along` lower");
            return refuse("length", length, must);
        }
        if !(-1e7..=1e7).contains(&cavern.middle) {
            return refuse("middle", cavern.middle, "a coordinate (and at most 1e7 m)".to_owned());
        }
        let ends = spec.ends(cavern);
        let (key, at) = if cavern.middle == 0.0 { ("length", length) } else { ("middle", cavern.middle) };
        for side in 0..2 {
            let rock = (faces[side] - ends[side]) * [-1.0, 1.0][side];
            if rock != 0.0 && rock < step - SAME {
                let must = format!(
                    "such that the cavern ends at the block's face or has rock for an element, {step} m, beyond its end at \
                     y = {:.3} m (the block ends at {:.3} m)",
                    ends[side], faces[side]
                );
                return refuse(key, at, must);
            }
        }
        for other in &spec.caverns[..k] {
            if let Some(least) = sliver(spec, &ends, &spec.ends(other)) {
                let must = format!(
                    "such that its ends, y = {:.3} and {:.3} m, are those of cavern {:?} or lie {least:.3} m away from them, \
                     a tenth of an element",
                    ends[0], ends[1], other.name
                );
                return refuse(key, at, must);
            }
        }
    }
    check_galleries(spec)
}

fn check_galleries(spec: &CavernSpec) -> Result<(), CavernError> {
    for gallery in &spec.galleries {
        let walls = gallery.walls();
        let refuse = |must: String| Err(value(format!("{}.at", gallery.name), gallery.at[0], must));
        for cavern in spec.caverns.iter().filter(|c| spec.ends(c) != spec.faces()) {
            let ends = spec.ends(cavern);
            let beyond = walls[0] < ends[0] - SAME || walls[1] > ends[1] + SAME;
            if beyond && gallery.between.contains(&cavern.name) {
                return refuse(format!(
                    "such that the gallery, {} m wide, lies between the ends of cavern {:?}, y = {:.3} and {:.3} m",
                    gallery.width, cavern.name, ends[0], ends[1]
                ));
            }
            // The ends of any cavern are planes through the block, and so are the walls.
            if let Some(least) = sliver(spec, &walls, &ends) {
                return refuse(format!(
                    "such that its walls, y = {:.3} and {:.3} m, are in the planes of the ends of cavern {:?} or {least:.3} m \
                     away from them",
                    walls[0], walls[1], cavern.name
                ));
            }
        }
    }
    Ok(())
}

/// The least distance, if some place of `a` is nearer to one of `b`, and not the same.
fn sliver(spec: &CavernSpec, a: &[f64], b: &[f64]) -> Option<f64> {
    let least = LEAST * spec.near.min(spec.step());
    let mut gaps = a.iter().flat_map(|a| b.iter().map(move |b| (a - b).abs()));
    gaps.any(|gap| gap > SAME && gap < least).then_some(least)
}

/// Planes across y, from face to face.
///
/// Where no cavern ends in rock they are even, or meet the galleries' walls. Else every end is one of them, and so is every
/// cavern's middle, unless another that must be is too near. From the first end to the last they are at most the size along
/// the caverns apart, from there to the faces they grow by 1.25 up to `far`. A description that is its own mirror image in
/// y = 0 has planes that are so to the last bit.
pub(super) fn planes(spec: &CavernSpec) -> Result<Vec<f64>, CavernError> {
    let faces = spec.faces();
    if spec.caverns.iter().all(|c| spec.ends(c) == faces) {
        let rows = spec.rows() as usize;
        return Ok(if spec.galleries.is_empty() {
            (0..=rows).map(|j| spec.length * (j as f64 / rows as f64 - 0.5)).collect()
        } else {
            passage::planes(spec, spec.length / rows as f64)
        });
    }
    let mut stops: Vec<f64> = spec.caverns.iter().flat_map(|c| spec.ends(c)).collect();
    stops.extend(spec.galleries.iter().flat_map(Gallery::walls));
    for cavern in &spec.caverns {
        let middle = if cavern.length.is_some() { cavern.middle } else { 0.0 };
        if stops.iter().all(|y| (y - middle).abs() > 0.3 * spec.step()) {
            stops.push(middle);
        }
    }
    stops.sort_by(f64::total_cmp);
    // Places that differ by round-off are one.
    stops.dedup_by(|a, b| *a - *b < SAME);
    let mirrored =
        stops.contains(&0.0) && stops.iter().zip(stops.iter().rev()).all(|(a, b)| (a + b).abs() < SAME);
    if mirrored {
        let upper: Vec<f64> = stops.into_iter().filter(|y| *y >= 0.0).collect();
        let half = line(spec, &upper, [0.0, faces[1]])?;
        return Ok(half.iter().rev().map(|y| -y).chain(half[1..].iter().copied()).collect());
    }
    line(spec, &stops, faces)
}

/// Planes that meet the stops, which rise, and grow from the first and the last of them to the faces.
///
/// Where neighbours differ by more than is allowed, since each interval has a whole number of elements, the interval of
/// the larger gets one more; of all tries the evenest is taken.
fn line(spec: &CavernSpec, stops: &[f64], faces: [f64; 2]) -> Result<Vec<f64>, CavernError> {
    let spread = Spread::new(stops, spec.step());
    let intervals = 0..stops.len() - 1;
    let mut counts: Vec<usize> =
        intervals.map(|i| (spread.wanted(i) - 1e-6).ceil().max(1.0) as usize).collect();
    let mut best: Option<(f64, Vec<f64>)> = None;
    for _ in 0..MOST_TRIES {
        let line = divided(spec, &spread, stops, &counts, faces)?;
        let worst = growth(&line, &[None, None]);
        let size = |i: usize| line[i + 1] - line[i];
        let ratio = |i: usize| (size(i) / size(i - 1)).max(size(i - 1) / size(i));
        let at = (1..line.len() - 1).max_by(|&a, &b| ratio(a).total_cmp(&ratio(b)));
        let larger = at.map(|i| if size(i) > size(i - 1) { line[i] } else { line[i - 1] });
        if best.as_ref().is_none_or(|b| worst < b.0) {
            best = Some((worst, line));
        }
        // Beyond the last stop there is nothing to add.
        let interval = larger.and_then(|y| stops.partition_point(|stop| *stop <= y).checked_sub(1));
        match interval.and_then(|i| counts.get_mut(i)) {
            Some(count) if worst > MOST_GROWTH => *count += 1,
            _ => break,
        }
    }
    Ok(best.map(|b| b.1).unwrap_or_default())
}

/// Planes with so many elements in each interval.
fn divided(
    spec: &CavernSpec,
    spread: &Spread,
    stops: &[f64],
    counts: &[usize],
    faces: [f64; 2],
) -> Result<Vec<f64>, CavernError> {
    let mut line = vec![stops[0]];
    for (i, &n) in counts.iter().enumerate() {
        spread.fill(i, n, &mut line);
    }
    let far = spec.far.max(spec.step());
    let beyond = |from: f64, to: f64, next: f64, side: usize| {
        let mut ends = [None; 2];
        ends[side] = Some(End { next, wish: GROWTH * next });
        let key = if spec.along.is_some() { "size_along" } else { "size_near" };
        stretch(from, to, ends, far, &[]).map_err(|cause| CavernError::Grading { line: "y", key, cause })
    };
    let (first, last) = (stops[0], stops[stops.len() - 1]);
    if last < faces[1] {
        let rock = beyond(last, faces[1], last - line[line.len() - 2], 0)?;
        line.extend(&rock[1..]);
    }
    if first > faces[0] {
        let mut rock = beyond(faces[0], first, line[1] - first, 1)?;
        rock.extend(&line[1..]);
        line = rock;
    }
    relax(&mut line, stops);
    Ok(line)
}
