//! One value for an element, or for a place in it, from those of its points.

use tremolite_laws::shapes::hex8::{Points, Quadrature};
use tremolite_laws::sym3::principal_values;

/// Largest and smallest principal stress over some points.
pub fn extremes(points: &[[f64; 6]]) -> [f64; 2] {
    points.iter().fold([f64::NEG_INFINITY, f64::INFINITY], |[most, least], stress| {
        let p = principal_values(stress);
        [most.max(p[0]), least.min(p[2])]
    })
}

/// The same at the fibre: of an intact element with several points at its corners, which lie where a bent lining is stressed
/// most; of others over the points.
pub fn fibre_extremes(places: &Points, points: &[[f64; 6]], damaged: bool) -> [f64; 2] {
    if points.len() < 8 || damaged {
        return extremes(points);
    }
    let corner = |k: usize| [0, 1, 2].map(|axis| if k >> axis & 1 == 1 { 1.0 } else { -1.0 });
    extremes(&[0, 1, 2, 3, 4, 5, 6, 7].map(|k| stress_at(places, points, corner(k))))
}

/// Mean stress over an element, of its points.
pub fn mean(places: &Points, points: &[[f64; 6]]) -> [f64; 6] {
    let mut sum = [0.0; 6];
    for (stress, share) in points.iter().zip(places.quadrature.shares()) {
        for c in 0..6 {
            sum[c] += share * stress[c];
        }
    }
    sum
}

/// Natural coordinates that count as equally far from two points.
const BETWEEN: f64 = 1e-6;

/// Stress at natural coordinates of an element whose material has cracked or yielded: of the nearest of its points,
/// the mean of those that are equally near. A line through points on a limit would lead beyond it; the largest
/// principal stress of a mean exceeds none of its parts'.
pub fn nearest_stress(places: &Points, points: &[[f64; 6]], natural: [f64; 3]) -> [f64; 6] {
    // Points lie on a grid, so the nearest one is nearest along each axis.
    let far = |p: usize| [0, 1, 2].map(|axis| (places.natural(p)[axis] - natural[axis]).abs());
    let least = (0..points.len())
        .map(far)
        .fold([f64::INFINITY; 3], |least, far| [0, 1, 2].map(|axis| f64::min(least[axis], far[axis])));
    let near = |p: &usize| {
        let far = far(*p);
        (0..3).all(|axis| far[axis] <= least[axis] + 2.0 * BETWEEN)
    };
    let chosen: Vec<usize> = (0..points.len()).filter(near).collect();
    [0, 1, 2, 3, 4, 5].map(|c| chosen.iter().map(|&p| points[p][c]).sum::<f64>() / chosen.len() as f64)
}

/// Stress at natural coordinates of an element as long as it is elastic: of its one point, or trilinear through the eight of its
/// points that lie farthest from each other.
pub fn stress_at(places: &Points, points: &[[f64; 6]], natural: [f64; 3]) -> [f64; 6] {
    let last = match places.quadrature {
        Quadrature::OnePoint => return mean(places, points),
        Quadrature::Full => 4,
        Quadrature::Layered(_) => points.len() - 4,
    };
    let mut out = [0.0; 6];
    for p in (0..4).chain(last..last + 4) {
        let at = places.natural(p);
        let weight: f64 = (0..3).map(|axis| 0.5 * (1.0 + natural[axis] / at[axis])).product();
        for c in 0..6 {
            out[c] += weight * points[p][c];
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use tremolite_laws::shapes::hex8::Layers;

    const ONE: Points = Points { quadrature: Quadrature::OnePoint, axis: 0 };
    const FULL: Points = Points { quadrature: Quadrature::Full, axis: 0 };

    fn layered(axis: usize) -> Points {
        Points { quadrature: Quadrature::Layered(Layers::Nine), axis }
    }

    fn along_x(places: &Points, stress: impl Fn([f64; 3]) -> f64) -> Vec<[f64; 6]> {
        (0..places.count()).map(|p| [stress(places.natural(p)), 0.0, 0.0, 0.0, 0.0, 0.0]).collect()
    }

    #[test]
    fn stress_is_extrapolated_in_an_elastic_element_and_never_beyond_its_points_in_a_cracked_one() {
        // Uniaxial along x, growing with ξ from 1 at one layer of points to 3 at the other.
        let points = along_x(&FULL, |x| 2.0 + x[0] * 3f64.sqrt());
        let face = [1.0, 0.0, 0.0];
        assert!((stress_at(&FULL, &points, face)[0] - (2.0 + 3f64.sqrt())).abs() < 1e-12);
        let near = |natural, value: f64| {
            assert!((nearest_stress(&FULL, &points, natural)[0] - value).abs() < 1e-12, "{natural:?}");
        };
        near(face, 3.0);
        near([-0.2, 1.0, 1.0], 1.0);
        // Between the two.
        near([0.0; 3], 2.0);
        assert_eq!(nearest_stress(&ONE, &points[..1], face), points[0], "one point");
        assert_eq!(stress_at(&ONE, &points[..1], face), points[0]);
    }

    /// A plate in bending: its stress is linear through the thickness, and at 2×2×2 points 1/√3 of that at the fibre, where
    /// layers have points.
    #[test]
    fn a_bent_lining_is_stressed_most_at_its_fibre_and_at_points_it_shows_less() {
        let points = along_x(&FULL, |x| x[2]);
        let [s1, s3] = fibre_extremes(&FULL, &points, false);
        assert!((s1 - 1.0).abs() < 1e-12 && (s3 + 1.0).abs() < 1e-12, "{s1} {s3}");
        assert_eq!(fibre_extremes(&FULL, &points, true), extremes(&points));
        assert!(extremes(&points)[0] < 0.58);
        assert_eq!(fibre_extremes(&ONE, &points[..1], false), extremes(&points[..1]));
        for axis in 0..3 {
            let places = layered(axis);
            let points = along_x(&places, |x| x[axis]);
            assert_eq!(extremes(&points), [1.0, -1.0]);
            let [s1, s3] = fibre_extremes(&places, &points, false);
            assert!((s1 - 1.0).abs() < 1e-12 && (s3 + 1.0).abs() < 1e-12, "{s1} {s3}");
        }
    }

    /// A field that is linear in each natural coordinate, as elastic stress is, has its mean at the middle; the nearest of layers
    /// are eight times nearer.
    #[test]
    fn layers_are_seen_as_they_lie_whatever_the_axis_of_the_thickness() {
        let field = |x: [f64; 3]| 1.0 + 2.0 * x[0] - 3.0 * x[1] + 4.0 * x[2] + 0.5 * x[0] * x[1];
        for axis in 0..3 {
            let places = layered(axis);
            let points = along_x(&places, field);
            let at = [0.3, -0.7, 0.9];
            assert!((stress_at(&places, &points, at)[0] - field(at)).abs() < 1e-12);
            assert!((mean(&places, &points)[0] - 1.0).abs() < 1e-12);
            let mut natural = [1.0 / 3f64.sqrt(); 3];
            natural[axis] = 0.3;
            let mut nearest = natural;
            nearest[axis] = 0.25;
            assert!((nearest_stress(&places, &points, natural)[0] - field(nearest)).abs() < 1e-12);
        }
    }
}
