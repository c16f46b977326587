//! One value for an element, or for a place in it, from those of its points.

use std::sync::LazyLock;
use tremolite_laws::shapes::hex8::{Layers, Points, Quadrature};
use tremolite_laws::sym3::extreme_values;

/// Largest and smallest principal stress over some points.
pub fn extremes(points: &[[f64; 6]]) -> [f64; 2] {
    over(&extreme_values(points))
}

/// Largest and smallest principal stress in each of some elements, by their points and whether they are damaged. Of an intact element with several
/// points it is that at its corners, which lie where a bent lining is stressed most; of others that over the points.
pub fn fibre_extremes<'a>(
    elements: impl Iterator<Item = (&'a Points, &'a [[f64; 6]], bool)>,
) -> impl Iterator<Item = [f64; 2]> {
    let (most, _) = elements.size_hint();
    let (mut stresses, mut ends) = (Vec::with_capacity(8 * most), Vec::with_capacity(most));
    for (places, points, damaged) in elements {
        match at_fibres(places, points, damaged) {
            Some(corners) => stresses.extend_from_slice(&corners),
            None => stresses.extend_from_slice(points),
        }
        ends.push(stresses.len());
    }
    let values = extreme_values(&stresses);
    let mut first = 0;
    ends.into_iter().map(move |end| over(&values[std::mem::replace(&mut first, end)..end]))
}

fn over(values: &[[f64; 2]]) -> [f64; 2] {
    let beyond = |[most, least]: [f64; 2], [one, third]: &[f64; 2]| [most.max(*one), least.min(*third)];
    values.iter().fold([f64::NEG_INFINITY, f64::INFINITY], beyond)
}

/// Stresses at the corners of an intact element with several points.
fn at_fibres(places: &Points, points: &[[f64; 6]], damaged: bool) -> Option<[[f64; 6]; 8]> {
    let several = points.len() >= 8 && !damaged;
    several.then(|| {
        let corners = Weights::at_corners(places);
        [0, 1, 2, 3, 4, 5, 6, 7].map(|k| corners[k].stress(points))
    })
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
    match places.quadrature {
        Quadrature::OnePoint => mean(places, points),
        _ => Weights::at(places, natural).stress(points),
    }
}

/// How the stress at a place of an elastic element follows from its points, worked out once for many times.
#[derive(Clone, Copy, Debug)]
pub struct Weights {
    /// Of the first four points and the last four.
    weights: [f64; 8],
}

impl Weights {
    /// At natural coordinates of an element of several points.
    pub fn at(places: &Points, natural: [f64; 3]) -> Self {
        let last = places.count().saturating_sub(4);
        let weight = |k: usize| {
            let at = places.natural(if k < 4 { k } else { last + k - 4 });
            (0..3).map(|axis| 0.5 * (1.0 + natural[axis] / at[axis])).product()
        };
        Weights { weights: std::array::from_fn(weight) }
    }

    /// At the corners, by binary number: bit 0 is ξ.
    fn at_corners(places: &Points) -> &'static [Weights; 8] {
        const CORNERS: [usize; 8] = [0, 1, 2, 3, 4, 5, 6, 7];
        static ALL: LazyLock<Vec<(Points, [Weights; 8])>> = LazyLock::new(|| {
            let layered = Layers::ALL.map(Quadrature::Layered);
            let kinds = std::iter::once(Quadrature::Full).chain(layered);
            let all = kinds.flat_map(|quadrature| [0, 1, 2].map(|axis| Points { quadrature, axis }));
            let corner = |k: usize| [0, 1, 2].map(|axis| if k >> axis & 1 == 1 { 1.0 } else { -1.0 });
            all.map(|places| (places, CORNERS.map(|k| Weights::at(&places, corner(k))))).collect()
        });
        let known = ALL.iter().position(|(known, _)| known == places);
        &ALL[known.unwrap_or(0)].1
    }

    /// The stress there, of those at the element's points.
    ///
    /// # Panics
    /// If there are fewer than eight.
    pub fn stress(&self, points: &[[f64; 6]]) -> [f64; 6] {
        let mut out = [0.0; 6];
        let (first, last) = (&points[..4], &points[points.len() - 4..]);
        for (point, weight) in first.iter().chain(last).zip(self.weights) {
            for c in 0..6 {
                out[c] += weight * point[c];
            }
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
    /// layers have points. Elements of all kinds together have what each has alone.
    #[test]
    fn a_bent_lining_is_stressed_most_at_its_fibre_and_at_points_it_shows_less() {
        let one = |places: &Points, points: &[[f64; 6]], damaged| {
            fibre_extremes(std::iter::once((places, points, damaged))).next().unwrap_or_default()
        };
        let near = |[s1, s3]: [f64; 2], most: f64| {
            assert!((s1 - most).abs() < 1e-12 && (s3 + most).abs() < 1e-12, "{s1} {s3}");
        };
        let full = along_x(&FULL, |x| x[2]);
        near(one(&FULL, &full, false), 1.0);
        near(one(&FULL, &full, true), 1.0 / 3f64.sqrt());
        assert_eq!(one(&FULL, &full, true), extremes(&full));
        assert_eq!(one(&ONE, &full[..1], false), one(&ONE, &full[..1], true));
        let mut all = vec![(FULL, full.clone(), false), (ONE, full[4..5].to_vec(), true), (FULL, full, true)];
        for axis in 0..3 {
            let places = layered(axis);
            let points = along_x(&places, |x| x[axis]);
            near(one(&places, &points, true), 1.0);
            near(one(&places, &points, false), 1.0);
            all.push((places, points, axis == 1));
        }
        let each = all.iter().map(|(places, points, damaged)| one(places, points, *damaged));
        let together =
            fibre_extremes(all.iter().map(|(places, points, damaged)| (places, &points[..], *damaged)));
        assert!(together.eq(each));
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
