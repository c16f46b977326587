//! Flow lines of water: traced through the flux that elements have, the closer to each other the more water flows.

mod continuous;
mod line;

use continuous::Continuous;

/// Lines are looked for from so many cells at most, evenly taken from those with the most flow to those with the least.
const SEEDS: usize = 4000;
/// Flow below this share of the largest is none.
const LEAST: f64 = 1e-6;

/// A cell with water that flows: a polygon of a section or a hexahedron, some of whose corners may coincide.
#[derive(Clone, Debug)]
pub struct FlowCell<const D: usize> {
    /// In order around the outline, or as VTK has those of a hexahedron (m).
    pub corners: Vec<[f64; D]>,
    /// Specific discharge, mean over the cell (m/s).
    pub flow: [f64; D],
    /// Whether lines are wanted through it.
    pub wanted: bool,
}

/// A line from where the water comes from to where it goes, point by point (m).
pub type FlowLine<const D: usize> = Vec<[f64; D]>;

/// Lines through what is wanted, at most `most`, and about `length` (m) of them in all.
///
/// Corners get the mean of their cells, each by one over the distance of its middle; between corners and middles the flux is linear. A line goes
/// both ways from the middle of a cell to where the cells end, or to where the water does: a drain. Of all cells those with the strongest flow come
/// first, and one farther from all lines before than they are to lie apart there is the next. In a plane that is as far as so much water needs that
/// it is the same between two lines anywhere; so nothing goes by the order of the cells, nor by which way they lie.
pub fn lines<const D: usize>(cells: &[FlowCell<D>], length: f64, most: usize) -> Vec<FlowLine<D>> {
    let strength = |cell: &FlowCell<D>| size(&cell.flow);
    let finite = cells.iter().map(strength).filter(|q| q.is_finite());
    let largest = finite.fold(0.0, f64::max);
    let flows = |cell: &&FlowCell<D>| strength(cell).is_finite() && strength(cell) > LEAST * largest;
    let field = Continuous::of(cells.iter().filter(flows).cloned().collect());
    let mut seeds: Vec<usize> = (0..field.cells.len()).filter(|&cell| field.cells[cell].wanted).collect();
    // Where the lines are so much water apart, they are `length` long in all.
    let through = seeds.iter().map(|&cell| strength(&field.cells[cell]) * field.volume(cell)).sum::<f64>();
    let water = through / length;
    let apart = |q: f64| (water / q).powf(1.0 / (D - 1) as f64);
    seeds.sort_by(|&a, &b| strength(&field.cells[b]).total_cmp(&strength(&field.cells[a])));
    let each = seeds.len().div_ceil(SEEDS).max(1);
    let mut found: Vec<FlowLine<D>> = Vec::new();
    for seed in seeds.into_iter().step_by(each) {
        if found.len() == most {
            break;
        }
        let (at, room) = (field.middles[seed], apart(strength(&field.cells[seed])).powi(2));
        if found.iter().flatten().all(|point| square(&minus(point, &at)) > room) {
            found.extend(line::through(&field, seed));
        }
    }
    found
}

/// The points that a line needs to stay within a distance (m) of what it was; the ends stay.
pub fn thinned<const D: usize>(line: &[[f64; D]], within: f64) -> FlowLine<D> {
    let [first, .., last] = line else { return line.to_vec() };
    let chord = minus(last, first);
    let off = |point: &[f64; D]| {
        let from = minus(point, first);
        let share = (dot(&from, &chord) / square(&chord).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        square(&std::array::from_fn::<f64, D, _>(|i| from[i] - share * chord[i]))
    };
    let farthest = (0..line.len()).max_by(|&a, &b| off(&line[a]).total_cmp(&off(&line[b]))).unwrap_or(0);
    if off(&line[farthest]) <= within * within {
        return vec![*first, *last];
    }
    let mut kept = thinned(&line[..=farthest], within);
    kept.pop();
    kept.extend(thinned(&line[farthest..], within));
    kept
}

fn minus<const D: usize>(a: &[f64; D], b: &[f64; D]) -> [f64; D] {
    std::array::from_fn(|i| a[i] - b[i])
}

fn dot<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn square<const D: usize>(a: &[f64; D]) -> f64 {
    dot(a, a)
}

fn size<const D: usize>(a: &[f64; D]) -> f64 {
    square(a).sqrt()
}

#[cfg(test)]
mod tests;
