//! One stretch of a grid line between caverns, or from a cavern to the edge of the block: graded, with sizes that
//! suit its neighbours, and with lines at given places where they fit.

use crate::grading::{GradingError, graded};

/// Largest growth from one element to the next.
pub(super) const GROWTH: f64 = 1.25;

/// Largest growth that a stretch may have so that it meets its neighbours and its cuts.
pub(super) const MOST_GROWTH: f64 = 1.3;

/// Longer lines are left as they come: their sizes are far below any misfit.
const LONG: usize = 2000;

/// What lies beyond an end.
#[derive(Clone, Copy, Debug)]
pub(super) struct End {
    /// Size of the neighbouring element.
    pub next: f64,
    /// Size that would suit the rows or columns that run into the stretch.
    pub wish: f64,
}

/// Coordinates from `from` to `to`, both included, with sizes that grow inwards from the ends up to `far`.
///
/// Of many ways to begin, end and grow the one is taken that grows least abruptly, to the neighbours' sizes as
/// well. Among `cuts` those inside become coordinates, all of them or, if that would let the growth from element to
/// element exceed 1.3, none.
pub(super) fn stretch(
    from: f64,
    to: f64,
    ends: [Option<End>; 2],
    far: f64,
    cuts: &[f64],
) -> Result<Vec<f64>, GradingError> {
    let plain = graded(from, to, (ends[0].map(|e| e.wish), ends[1].map(|e| e.wish)), far, GROWTH)?;
    if plain.len() > LONG {
        return Ok(plain);
    }
    let sizes = |end: Option<End>| -> Vec<Option<f64>> {
        end.map_or(vec![None], |end| {
            let near = [1.25, 1.15, 1.05, 1.0, 0.9, 0.8].map(|f| f * end.next);
            std::iter::once(end.wish).chain(near).map(|s| Some(s.min(far))).collect()
        })
    };
    let inside: Vec<f64> = cuts.iter().copied().filter(|c| *c > from && *c < to).collect();
    let (mut best, mut best_cut) = ((growth(&plain, &ends), plain), None::<(f64, Vec<f64>)>);
    let (first, last) = (sizes(ends[0]), sizes(ends[1]));
    for rate in [GROWTH, 1.2, 1.15, 1.1] {
        for &a in &first {
            for &b in &last {
                let line = graded(from, to, (a, b), far, rate)?;
                if !inside.is_empty()
                    && let Some(line) = snapped(&line, &inside)
                {
                    let worst = growth(&line, &ends);
                    let larger = line.windows(2).any(|p| p[1] - p[0] > far * (1.0 + 1e-9));
                    if !larger && best_cut.as_ref().is_none_or(|b| worst < b.0) {
                        best_cut = Some((worst, line));
                    }
                }
                let worst = growth(&line, &ends);
                // Fewer elements where the growth is as good as asked for.
                let good = worst.max(GROWTH);
                if good < best.0.max(GROWTH) || (good == best.0.max(GROWTH) && line.len() < best.1.len()) {
                    best = (worst, line);
                }
            }
        }
    }
    match best_cut {
        Some((worst, line)) if worst <= MOST_GROWTH => Ok(line),
        _ => Ok(best.1),
    }
}

/// Largest ratio of neighbouring sizes, those beyond the ends included.
pub(super) fn growth(line: &[f64], ends: &[Option<End>; 2]) -> f64 {
    let mut sizes: Vec<f64> = ends[0].iter().map(|e| e.next).collect();
    sizes.extend(line.windows(2).map(|p| p[1] - p[0]));
    sizes.extend(ends[1].iter().map(|e| e.next));
    sizes.windows(2).map(|p| (p[0] / p[1]).max(p[1] / p[0])).fold(1.0, f64::max)
}

/// The line with its nearest coordinates moved to the cuts and the others in proportion; nothing if two cuts, or a
/// cut and an end, have the same nearest.
fn snapped(line: &[f64], cuts: &[f64]) -> Option<Vec<f64>> {
    let n = line.len() - 1;
    let mut pins = vec![(0, line[0])];
    let mut sorted = cuts.to_vec();
    sorted.sort_by(f64::total_cmp);
    for cut in sorted {
        let above = line.partition_point(|x| *x < cut);
        let nearest = if cut - line[above - 1] < line[above] - cut { above - 1 } else { above };
        if nearest <= pins[pins.len() - 1].0 || nearest >= n {
            return None;
        }
        pins.push((nearest, cut));
    }
    pins.push((n, line[n]));
    let mut moved = Vec::with_capacity(n + 1);
    for pair in pins.windows(2) {
        let [(i, a), (j, b)] = [pair[0], pair[1]];
        let share = |k: usize| (line[k] - line[i]) / (line[j] - line[i]);
        moved.extend((i..j).map(|k| if k == i { a } else { a + (b - a) * share(k) }));
    }
    moved.push(line[n]);
    Some(moved)
}

/// Moves coordinates so that no size is more than the largest growth times its neighbour's, or as little more as can be,
/// where they may move: not the ends, nor those among `fixed`. For lines made of stretches that each had to have a
/// whole number of elements.
///
/// One coordinate after the other is put where the squares of what the logarithms of the ratios round it exceed are
/// least; what cannot be had shows at the fixed ones.
pub(super) fn relax(line: &mut [f64], fixed: &[f64]) {
    if growth(line, &[None, None]) <= MOST_GROWTH {
        return;
    }
    // Below the largest growth, so that what is left of an excess stays below it.
    let most = (0.98 * MOST_GROWTH).ln();
    let excess = |a: f64, b: f64| ((a / b).ln().abs() - most).max(0.0).powi(2);
    // Where not all can be had, the fixed ones are to show it.
    let weight: Vec<f64> = line.iter().map(|x| if fixed.contains(x) { 0.01 } else { 1.0 }).collect();
    // Each sweep carries a misfit on by an element; more are never far apart.
    for _ in 0..200 {
        let mut moved = false;
        for i in 1..line.len() - 1 {
            if weight[i] < 1.0 {
                continue;
            }
            let (from, to) = (line[i - 1], line[i + 1]);
            let before = (i > 1).then(|| from - line[i - 2]);
            let after = line.get(i + 2).map(|next| next - to);
            let cost = |x: f64| {
                let (a, b) = (x - from, to - x);
                let lower = before.map_or(0.0, |h| weight[i - 1] * excess(h, a));
                let upper = after.map_or(0.0, |h| weight[i + 1] * excess(b, h));
                excess(a, b) + lower + upper
            };
            let now = cost(line[i]);
            if now == 0.0 {
                continue;
            }
            let best = least(from, to, &cost);
            if cost(best) < now - 1e-13 {
                line[i] = best;
                moved = true;
            }
        }
        if !moved {
            break;
        }
    }
}

/// Where between two places a function with one valley is least, by golden section.
fn least(from: f64, to: f64, function: &dyn Fn(f64) -> f64) -> f64 {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = (from, to);
    for _ in 0..40 {
        let step = golden * (high - low);
        let (a, b) = (high - step, low + step);
        // On level ground both ends come nearer.
        if function(a) <= function(b) {
            high = b;
        } else {
            low = a;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn end(next: f64) -> Option<End> {
        Some(End { next, wish: next })
    }

    #[test]
    fn neighbours_sizes_are_met_within_the_growth() {
        for (length, ends, far) in [
            (60.0, [end(1.0), None], 8.0),
            (9.0, [end(1.0), end(1.4)], 8.0),
            (31.0, [end(2.2), end(0.7)], 5.0),
            (47.0, [None, end(1.9)], 7.0),
        ] {
            let line = stretch(0.0, length, ends, far, &[]).unwrap();
            assert!(growth(&line, &ends) <= 1.3, "{length}: {line:?}");
            assert_eq!((line[0], line[line.len() - 1]), (0.0, length));
        }
    }

    #[test]
    fn a_misfit_is_spread_over_its_neighbours() {
        let mut line = vec![0.0, 1.0, 2.0, 3.0, 4.5, 6.5, 8.5, 10.5];
        relax(&mut line, &[8.5]);
        assert!(growth(&line, &[None, None]) <= 1.3, "{line:?}");
        assert_eq!((line[0], line[6], line[7]), (0.0, 8.5, 10.5));
        let even = vec![0.0, 1.0, 2.2, 3.4];
        let mut same = even.clone();
        relax(&mut same, &[]);
        assert_eq!(same, even);
    }

    #[test]
    fn cuts_are_met_exactly_where_the_growth_allows_it() {
        let line = stretch(-80.0, -20.0, [None, end(1.5)], 6.0, &[-55.3, -33.0, 4.0]).unwrap();
        assert!(line.contains(&-55.3) && line.contains(&-33.0), "{line:?}");
        assert!(growth(&line, &[None, end(1.5)]) <= 1.3);
        // A tenth of an element from the end.
        let line = stretch(-80.0, -20.0, [None, end(1.5)], 6.0, &[-20.15]).unwrap();
        assert!(!line.contains(&-20.15) && growth(&line, &[None, end(1.5)]) <= 1.3, "{line:?}");
    }
}
