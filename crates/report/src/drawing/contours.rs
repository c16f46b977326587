//! Filled contours and lines of one value over a polygon with a value at each corner, linear in between.

/// A point with its value.
type Valued = ([f64; 2], f64);

/// The parts of a convex polygon by level, which `level` gives of a value; `from` is the least value of a level. Nothing
/// where a corner has no number.
pub fn bands(
    corners: &[Valued],
    level: impl Fn(f64) -> usize,
    from: impl Fn(usize) -> f64,
) -> Vec<(usize, Vec<[f64; 2]>)> {
    if corners.iter().any(|(_, value)| !value.is_finite()) {
        return Vec::new();
    }
    let (low, high) = ends(corners);
    let (first, last) = (level(low), level(high));
    if first == last {
        return vec![(first, corners.iter().map(|(at, _)| *at).collect())];
    }
    let mut bands = Vec::new();
    for triangle in triangles(corners) {
        let (low, high) = ends(&triangle);
        let (first, last) = (level(low), level(high));
        for k in first..=last {
            let mut part = triangle.to_vec();
            if k > first {
                part = above(&part, from(k), 1.0);
            }
            if k < last {
                part = above(&part, from(k + 1), -1.0);
            }
            if part.len() > 2 {
                bands.push((k, part.into_iter().map(|(at, _)| at).collect()));
            }
        }
    }
    bands
}

/// The line on which the value is `wanted`, in pieces.
pub fn line(corners: &[Valued], wanted: f64) -> Vec<[[f64; 2]; 2]> {
    if corners.iter().any(|(_, value)| !value.is_finite()) {
        return Vec::new();
    }
    let crossing = |triangle: [Valued; 3]| {
        let sides = [(0, 1), (1, 2), (2, 0)].map(|(i, j)| (triangle[i], triangle[j]));
        let cut = sides.into_iter().filter(|(a, b)| (a.1 < wanted) != (b.1 < wanted));
        let points: Vec<[f64; 2]> = cut.map(|(a, b)| between(a, b, wanted).0).collect();
        <[[f64; 2]; 2]>::try_from(points).ok()
    };
    triangles(corners).into_iter().filter_map(crossing).collect()
}

/// A polygon as triangles: itself, or one on each side around its middle, which has the mean of the corners' values.
fn triangles(corners: &[Valued]) -> Vec<[Valued; 3]> {
    if let Ok(own) = <[Valued; 3]>::try_from(corners) {
        return vec![own];
    }
    let n = corners.len().max(1) as f64;
    let sum = corners.iter().fold([0.0; 3], |s, (at, value)| [s[0] + at[0], s[1] + at[1], s[2] + value]);
    let middle = ([sum[0] / n, sum[1] / n], sum[2] / n);
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| [middle, *a, *b]).collect()
}

/// The part of a polygon where the value is at least `limit`, or at most with `sense` −1.
fn above(polygon: &[Valued], limit: f64, sense: f64) -> Vec<Valued> {
    let mut part = Vec::with_capacity(polygon.len() + 1);
    for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let inside = |p: &Valued| sense * (p.1 - limit) >= 0.0;
        if inside(a) {
            part.push(*a);
        }
        if inside(a) != inside(b) {
            part.push(between(*a, *b, limit));
        }
    }
    part
}

fn between(a: Valued, b: Valued, value: f64) -> Valued {
    let s = (value - a.1) / (b.1 - a.1);
    ([0, 1].map(|i| a.0[i] + s * (b.0[i] - a.0[i])), value)
}

fn ends(corners: &[Valued]) -> (f64, f64) {
    corners.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (_, x)| (low.min(*x), high.max(*x)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(outline: &[[f64; 2]]) -> f64 {
        let next = outline.iter().cycle().skip(1);
        0.5 * outline.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>().abs()
    }

    /// Four corners of a leaning quadrilateral with the value 2x + z.
    fn leaning() -> Vec<Valued> {
        [[0.0, 0.0], [4.0, 1.0], [4.5, 5.0], [-1.0, 3.0]].map(|[x, z]| ([x, z], 2.0 * x + z)).to_vec()
    }

    #[test]
    fn a_linear_field_has_straight_bands_at_equal_distances_that_cover_it_once() {
        let level = |value: f64| ((value + 4.0) / 2.0).clamp(0.0, 9.0) as usize;
        let from = |k: usize| 2.0 * k as f64 - 4.0;
        let bands = bands(&leaning(), level, from);
        for (k, outline) in &bands {
            for [x, z] in outline {
                let value = 2.0 * x + z;
                assert!(value > from(*k) - 1e-12 && value < from(k + 1) + 1e-12, "{k} {value}");
            }
        }
        let own: Vec<[f64; 2]> = leaning().iter().map(|(at, _)| *at).collect();
        let total: f64 = bands.iter().map(|(_, outline)| area(outline)).sum();
        assert!((total - area(&own)).abs() < 1e-12, "{total}");
        // From 0 to 14 by twos, and each band goes from one of its limits to the other.
        for k in 2..=8 {
            let own = bands.iter().filter(|(band, _)| *band == k).flat_map(|(_, outline)| outline);
            let values = own.map(|[x, z]| 2.0 * x + z);
            let (low, high) =
                values.fold((99.0, -99.0), |(low, high), x| (f64::min(low, x), f64::max(high, x)));
            assert!((low - from(k)).abs() < 1e-12 && (high - from(k + 1)).abs() < 1e-12, "{k} {low} {high}");
        }
    }

    #[test]
    fn lines_of_a_linear_field_lie_where_it_has_the_value() {
        let lines = line(&leaning(), 3.0);
        assert!(!lines.is_empty());
        for [x, z] in lines.iter().flatten() {
            assert!((2.0 * x + z - 3.0).abs() < 1e-12, "{x} {z}");
        }
    }

    #[test]
    fn a_corner_without_a_number_leaves_a_gap() {
        let mut corners = leaning();
        corners[2].1 = f64::NAN;
        assert!(bands(&corners, |_| 0, |_| 0.0).is_empty() && line(&corners, 3.0).is_empty());
    }
}
