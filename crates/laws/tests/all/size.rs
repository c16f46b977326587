//! The size tensor and the displacement gradient that element kernels hand to laws which ask for them.

use crate::common::Random;
use tremolite_laws::shapes::hex8::{
    BrickField, BrickGeometry, CORNERS, FullGeometry, FullShape, Given, Hex8, LayeredGeometry, Layers,
    OnePointGeometry, OnePointShape, Probe, Stabilisation, Through, full, layered, one_point,
};
use tremolite_laws::{BadParameter, Column, Lane, Material, Moduli, Octet, Parameter, Point, Row, Values};

/// A law whose stress is the size tensor itself.
struct ShowsSize;

impl Material for ShowsSize {
    const NAME: &'static str = "shows-size";
    const SUMMARY: &'static str = "a test's own";
    const SOURCE: &'static str = "";
    const PARAMETERS: &'static [Parameter] = &[];
    const HISTORY: &'static [Column] = &[];
    const NEEDS_SIZE: bool = true;
    type History<L: Lane> = [L; 0];

    fn new(_: &Values) -> Result<Self, Vec<BadParameter>> {
        Ok(ShowsSize)
    }

    fn moduli(&self) -> Moduli {
        Moduli::from_young_poisson(1.0, 0.2)
    }

    fn scaled(&self, _: f64) -> Self {
        ShowsSize
    }

    fn update<L: Lane>(&self, point: &Point<L>, _: [L; 6], _: [L; 0]) -> ([L; 6], [L; 0]) {
        (point.size, [])
    }
}

#[test]
fn both_quadratures_hand_over_half_the_second_moment_of_the_corners_or_what_they_are_given() {
    let mut random = Random::new(31);
    for _ in 0..50 {
        let (r, sides) = (random.rotation(), [0.25, 1.2, 0.6]);
        let corners = CORNERS.map(|c| {
            let x: [f64; 3] = std::array::from_fn(|i| sides[i] * (0.5 * c[i] + 0.12 * random.symmetric()));
            std::array::from_fn(|i| 3.0 + (0..3).map(|j| r[j][i] * x[j]).sum::<f64>())
        });
        let mean: [f64; 3] =
            std::array::from_fn(|i| corners.iter().map(|x: &[f64; 3]| x[i]).sum::<f64>() / 8.0);
        let exact = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)]
            .map(|(i, j)| 0.5 * corners.iter().map(|x| (x[i] - mean[i]) * (x[j] - mean[j])).sum::<f64>());
        let hex = Hex8::new(corners).unwrap();
        let stabilisation = Stabilisation::new(ShowsSize.moduli());
        let index: [[u16; 8]; 8] = std::array::from_fn(|k| [k as u16; 8]);
        let (rows, point) = ([Row::ZERO; 8], Point::new(0.0));
        // What is given in place of the elements' own, to the first of them alone.
        let other: [Octet; 6] = std::array::from_fn(|c| {
            let mut octet = Octet::ZERO;
            octet.0[0] = 1.0 + c as f64;
            octet
        });
        let given = Given { size: &other, ..Given::NONE };
        let both = [(Given::NONE, exact), (given, other.map(|octet| octet.0[0]))];
        for ((given, exact), points) in both.into_iter().flat_map(|one| [(one, 1), (one, 8), (one, 36)]) {
            let mut out = [Row::ZERO; 8];
            let mut probe = Probe::ZERO;
            // SAFETY: eight rows, indices 0 to 7, and the scalar lane needs no instruction set.
            unsafe {
                if points == 1 {
                    let mut g = OnePointGeometry::EMPTY;
                    g.set(0, &hex);
                    one_point::<f64, _, _, true>(
                        &ShowsSize,
                        &stabilisation,
                        &point,
                        &g,
                        &index,
                        &mut [],
                        None,
                        &mut [],
                        given,
                        &mut [],
                        &rows,
                        &mut out,
                        &mut probe,
                    );
                } else if points == 36 {
                    let through = Through::of(Layers::Nine);
                    let mut g = LayeredGeometry::EMPTY;
                    g.set(0, &hex, &stabilisation, through);
                    layered::<f64, _, _, true>(
                        through,
                        &ShowsSize,
                        &point,
                        &g,
                        &index,
                        &mut [],
                        None,
                        &mut [],
                        given,
                        &mut [],
                        &rows,
                        &mut out,
                        &mut probe,
                    );
                } else {
                    let mut g = FullGeometry::EMPTY;
                    g.set(0, &hex, &stabilisation);
                    full::<f64, _, _, true>(
                        &ShowsSize,
                        &stabilisation,
                        &point,
                        &g,
                        &index,
                        &mut [],
                        None,
                        &mut [],
                        given,
                        &mut [],
                        &rows,
                        &mut out,
                        &mut probe,
                    );
                }
            }
            for stress in &probe.stress[..points] {
                for (found, exact) in stress.iter().zip(exact) {
                    assert!((found.0[0] - exact).abs() <= 1e-13, "{points} points: {} {exact}", found.0[0]);
                    // Lanes without an element: no size, and no NaN.
                    assert_eq!(found.0[1], 0.0);
                }
            }
        }
    }
}

/// A law whose stress is a row of the displacement gradient, or two.
struct ShowsGradient(usize);

impl Material for ShowsGradient {
    const NAME: &'static str = "shows-gradient";
    const SUMMARY: &'static str = "a test's own";
    const SOURCE: &'static str = "";
    const PARAMETERS: &'static [Parameter] = &[];
    const HISTORY: &'static [Column] = &[];
    const NEEDS_SIZE: bool = true;
    type History<L: Lane> = [L; 0];

    fn new(_: &Values) -> Result<Self, Vec<BadParameter>> {
        Ok(ShowsGradient(0))
    }

    fn moduli(&self) -> Moduli {
        Moduli::from_young_poisson(1.0, 0.2)
    }

    fn scaled(&self, _: f64) -> Self {
        ShowsGradient(self.0)
    }

    fn update<L: Lane>(&self, point: &Point<L>, _: [L; 6], _: [L; 0]) -> ([L; 6], [L; 0]) {
        let [a, b] = [point.gradient[self.0], point.gradient[(self.0 + 1) % 3]];
        ([a[0], a[1], a[2], b[0], b[1], b[2]], [])
    }
}

#[test]
fn all_quadratures_bricks_and_wedges_compute_the_gradient_of_a_uniform_field_with_its_rotation() {
    let mut random = Random::new(32);
    for round in 0..50 {
        let (brick, is_wedge) = (round % 3 == 0, round % 3 == 2);
        let sides = [0.25, 1.2, 0.6];
        let mut corners = CORNERS.map(|c| {
            std::array::from_fn(|i| {
                2.0 + sides[i] * (0.5 * c[i] + if brick { 0.0 } else { 0.12 * random.symmetric() })
            })
        });
        if is_wedge {
            (corners[3], corners[7]) = (corners[2], corners[6]);
        }
        let exact: [[f64; 3]; 3] = [0; 3].map(|_| [0; 3].map(|_| random.symmetric()));
        let rows = corners.map(|x: [f64; 3]| {
            Row::new([0, 1, 2].map(|i| 5.0 + (0..3).map(|j| exact[i][j] * x[j]).sum::<f64>()))
        });
        let hex = Hex8::new(corners).unwrap();
        assert_eq!(hex.is_wedge, is_wedge);
        let stabilisation = Stabilisation::new(ShowsGradient(0).moduli());
        let index: [[u16; 8]; 8] = std::array::from_fn(|k| [k as u16; 8]);
        let point = Point::new(0.0);
        for row in 0..3 {
            let law = ShowsGradient(row);
            macro_rules! shown {
                ($kernel:ident, $points:expr, $geometry:expr, $($before:expr,)*) => {{
                    let mut out = [Row::ZERO; 8];
                    let mut probe = Probe::ZERO;
                    // SAFETY: eight rows, indices 0 to 7, and the scalar lane needs no instruction set.
                    unsafe {
                        $kernel::<f64, _, _, true>(
                            $($before,)*
                            &point,
                            &$geometry,
                            &index,
                            &mut [],
                            None,
                            &mut [],
                            Given::NONE,
                            &mut [],
                            &rows,
                            &mut out,
                            &mut probe,
                        );
                    }
                    for stress in &probe.stress[..$points] {
                        for (k, found) in stress.iter().enumerate() {
                            let exact = exact[(row + k / 3) % 3][k % 3];
                            let found = found.0[0];
                            assert!((found - exact).abs() <= 1e-12, "{} points: {found} {exact}", $points);
                        }
                    }
                }};
            }
            let mut one = OnePointGeometry::EMPTY;
            one.set(0, &hex);
            shown!(one_point, 1, one, &law, &stabilisation,);
            let mut eight = FullGeometry::EMPTY;
            eight.set(0, &hex, &stabilisation);
            shown!(full, 8, eight, &law, &stabilisation,);
            let through = Through::of(Layers::Nine);
            let mut many = LayeredGeometry::EMPTY;
            many.set(0, &hex, &stabilisation, through);
            shown!(layered, 36, many, through, &law,);
            if brick {
                let mut one = BrickGeometry::EMPTY;
                one.set(0, &hex);
                shown!(one_point, 1, one, &law, &stabilisation,);
                let mut eight = <BrickField as FullShape>::EMPTY;
                FullShape::set(&mut eight, 0, &hex, &stabilisation);
                shown!(full, 8, eight, &law, &stabilisation,);
            }
        }
    }
}
