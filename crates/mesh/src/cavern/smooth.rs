//! Moves free nodes of a plane mesh of quadrilaterals so that its corners become squarer.

/// Sweeps over the free nodes, at most.
const SWEEPS: usize = 200;

/// Share of a quadrilateral's first area below which a corner's area is bent upwards while some are inverted.
const SOFT: f64 = 0.02;

/// What a quadrilateral aims at: the proportion it had at first, length along to length across, and the area
/// that softens its measure.
#[derive(Clone, Copy)]
struct Target {
    proportion: f64,
    soft: f64,
}

/// Moves the nodes `free`, which all belong to `quads` and have numbers from `first` on.
///
/// Each node in turn is moved so as to lower the sum over the corners round it of
/// (|a|² B/A + |b|² A/B) / (2 h), with a and b the edges there and A and B the lengths the quadrilateral had
/// along and across at first. h = a×b gives 1 for a right angle with edges in the old proportion and infinity
/// for a flat corner (Knupp's shape measure). As long as a corner is inverted, h = (a×b + √((a×b)² + 4δ²))/2
/// for all: finite, and so falling that inverted corners turn (Escobar's regularisation).
pub(super) fn smooth(points: &mut [[f64; 2]], quads: &[[u32; 4]], first: usize, free: &[u32]) {
    let length = |a: u32, b: u32| {
        let (a, b) = (points[a as usize], points[b as usize]);
        (a[0] - b[0]).hypot(a[1] - b[1])
    };
    let targets: Vec<Target> = quads
        .iter()
        .map(|&[a, b, c, d]| {
            let (along, across) = (length(a, b) + length(c, d), length(b, c) + length(d, a));
            Target { proportion: along / across, soft: SOFT * along * across / 4.0 }
        })
        .collect();
    let mut round: Vec<Vec<u32>> = vec![Vec::new(); points.len() - first];
    for (q, quad) in quads.iter().enumerate() {
        for &n in quad {
            if n as usize >= first {
                round[n as usize - first].push(q as u32);
            }
        }
    }
    for _ in 0..SWEEPS {
        let inverted = quads.iter().any(|quad| (0..4).any(|i| corner(points, quad, i).2 <= 0.0));
        let soft = if inverted { 1.0 } else { 0.0 };
        let mut largest = 0.0f64;
        for &n in free {
            let mine = &round[n as usize - first];
            let cost = |points: &[[f64; 2]]| -> f64 {
                mine.iter()
                    .map(|&q| {
                        let target = targets[q as usize];
                        quad_cost(points, &quads[q as usize], Target { soft: soft * target.soft, ..target })
                    })
                    .sum()
            };
            let size =
                mine.iter().map(|&q| shortest(points, &quads[q as usize])).fold(f64::INFINITY, f64::min);
            largest = largest.max(improve(points, n as usize, size, &cost) / size);
        }
        if largest < 1e-6 && !inverted {
            break;
        }
    }
}

fn shortest(points: &[[f64; 2]], quad: &[u32; 4]) -> f64 {
    (0..4)
        .map(|i| {
            let a = corner(points, quad, i).0;
            a[0].hypot(a[1])
        })
        .fold(f64::INFINITY, f64::min)
}

/// The edges from corner `i` to the next one and to the one before, and their cross product.
fn corner(points: &[[f64; 2]], quad: &[u32; 4], i: usize) -> ([f64; 2], [f64; 2], f64) {
    let at = points[quad[i] as usize];
    let edge = |j: usize| {
        let p = points[quad[j % 4] as usize];
        [p[0] - at[0], p[1] - at[1]]
    };
    let (a, b) = (edge(i + 1), edge(i + 3));
    (a, b, a[0] * b[1] - a[1] * b[0])
}

/// Infinite where a corner is flat or inverted and the target is not softened.
fn quad_cost(points: &[[f64; 2]], quad: &[u32; 4], target: Target) -> f64 {
    let mut sum = 0.0;
    for i in 0..4 {
        let (a, b, area) = corner(points, quad, i);
        let area = if target.soft > 0.0 { 0.5 * (area + area.hypot(2.0 * target.soft)) } else { area };
        if area.is_nan() || area <= 0.0 {
            return f64::INFINITY;
        }
        // From corners 0 and 2 the next edge runs along the quadrilateral, from 1 and 3 across.
        let r = if i % 2 == 0 { target.proportion } else { 1.0 / target.proportion };
        sum += ((a[0] * a[0] + a[1] * a[1]) / r + (b[0] * b[0] + b[1] * b[1]) * r) / (2.0 * area);
    }
    sum
}

/// One Newton step of one node, shortened until the cost falls; returns how far the node moved.
fn improve(points: &mut [[f64; 2]], n: usize, size: f64, cost: &dyn Fn(&[[f64; 2]]) -> f64) -> f64 {
    let start = points[n];
    let before = cost(points);
    let h = 1e-4 * size;
    let mut at = |x: f64, z: f64| {
        points[n] = [start[0] + x, start[1] + z];
        let value = cost(points);
        points[n] = start;
        value
    };
    let (e, w, u, d) = (at(h, 0.0), at(-h, 0.0), at(0.0, h), at(0.0, -h));
    let mixed = at(h, h) - at(h, -h) - at(-h, h) + at(-h, -h);
    let slope = [(e - w) / (2.0 * h), (u - d) / (2.0 * h)];
    let (a, b, c) =
        ((e - 2.0 * before + w) / (h * h), mixed / (4.0 * h * h), (u - 2.0 * before + d) / (h * h));
    let det = a * c - b * b;
    let mut step = if a > 0.0 && det > 1e-12 * a * c.abs() {
        [-(c * slope[0] - b * slope[1]) / det, -(a * slope[1] - b * slope[0]) / det]
    } else {
        // Not convex here: straight downhill.
        let norm = slope[0].hypot(slope[1]);
        [-0.3 * size * slope[0] / norm, -0.3 * size * slope[1] / norm]
    };
    if !(step[0].is_finite() && step[1].is_finite()) {
        return 0.0;
    }
    let far = step[0].hypot(step[1]) / (0.5 * size);
    if far > 1.0 {
        step = [step[0] / far, step[1] / far];
    }
    for _ in 0..12 {
        points[n] = [start[0] + step[0], start[1] + step[1]];
        if cost(points) < before {
            return step[0].hypot(step[1]);
        }
        step = [0.5 * step[0], 0.5 * step[1]];
    }
    points[n] = start;
    0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Nine nodes, four quadrilaterals, the middle node free.
    fn patch(middle: [f64; 2]) -> (Vec<[f64; 2]>, Vec<[u32; 4]>) {
        let mut points: Vec<[f64; 2]> = (0..9).map(|n| [(n % 3) as f64, (n / 3) as f64]).collect();
        points[4] = middle;
        (points, vec![[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7]])
    }

    #[test]
    fn a_node_outside_its_patch_is_brought_in() {
        for middle in [[1.3, 0.8], [2.4, 2.2], [-0.7, 1.0]] {
            let (mut points, quads) = patch(middle);
            smooth(&mut points, &quads, 0, &[4]);
            assert!(quads.iter().all(|quad| (0..4).all(|i| corner(&points, quad, i).2 > 0.3)), "{points:?}");
        }
    }

    #[test]
    fn a_patch_that_is_at_its_target_stays() {
        let (mut points, quads) = patch([1.0, 1.0]);
        smooth(&mut points, &quads, 0, &[4]);
        assert!((points[4][0] - 1.0).abs() < 1e-9 && (points[4][1] - 1.0).abs() < 1e-9);
    }
}
