//! Bricks of several points, turned anyhow, are the general element: forces, stresses, energies, and what is remembered.

use crate::common::Random;
use crate::common::concrete::{FT, with_words};
use tremolite_laws::band::{Band, MEMORY};
use tremolite_laws::materials::Concrete;
use tremolite_laws::shapes::hex8::{
    BrickField, CORNERS, FullGeometry, FullShape, Given, Hex8, LEFT, LayeredGeometry, LayeredShape, Layers,
    MODAL_MEMORY, Probe, Stabilisation, Through, bricks_left, full, layered, layered_left,
};
use tremolite_laws::{Material, Octet, Point, Row, Values};

const YOUNG: f64 = 25e9;

fn concrete() -> Concrete {
    let values = Values::default()
        .with("young", YOUNG)
        .with("poisson", 0.17)
        .with("tensile_strength", FT)
        .with("cohesion", 2e6)
        .with("friction_angle", 46f64.to_radians())
        .with("residual_shear", 0.2)
        .with("fracture_energy", 130.0);
    let words = [("rate", "ceb"), ("split", "compliance"), ("evolution", "exponential")];
    Concrete::new(&with_words(values, &words)).unwrap()
}

fn corners(sides: [f64; 3], axes: &[[f64; 3]; 3]) -> [[f64; 3]; 8] {
    CORNERS.map(|c| [0, 1, 2].map(|i| 3.0 + (0..3).map(|k| 0.5 * c[k] * sides[k] * axes[k][i]).sum::<f64>()))
}

/// Memory of one element, beside what is given.
struct One {
    history: Vec<Octet>,
    bodies: Vec<Octet>,
    left: Vec<Octet>,
}

impl One {
    fn new(points: usize, bodies: usize) -> Self {
        let octets = |n: usize| vec![Octet::ZERO; n];
        One {
            history: octets(points * Concrete::HISTORY.len()),
            bodies: octets(bodies),
            left: octets(points * LEFT),
        }
    }
}

/// What a pass leaves: forces and those of what is left, stresses, energies.
fn seen(out: [[Row; 8]; 2], probe: &Probe, points: usize) -> [Vec<f64>; 4] {
    let forces = |rows: [Row; 8]| rows.iter().flat_map(Row::xyz).collect();
    let energies = [probe.strain_energy, probe.dissipated, probe.created, probe.of_band];
    [
        forces(out[0]),
        forces(out[1]),
        probe.stress[..points].iter().flatten().map(|octet| octet.0[0]).collect(),
        energies.map(|octet| octet.0[0]).to_vec(),
    ]
}

const INDEX: [[u16; 8]; 8] = {
    let mut index = [[0; 8]; 8];
    let mut k = 0;
    while k < 8 {
        index[k] = [k as u16; 8];
        k += 1;
    }
    index
};

/// Whole paths with cracks, begun with a strain, with sizes that others give, at steps that bring the memory of a band on and others.
#[test]
fn bricks_of_several_points_resist_as_the_general_element_does() {
    let law = concrete();
    let band = Band::fit(0.03, [0.5, 20.0], 3.0).unwrap();
    let stabilisation = Stabilisation::new(law.moduli());
    let mut random = Random::new(11);
    let (mut cracked, mut worst) = (0, 0.0_f64);
    for draw in 0..12 {
        let sides = [0, 1, 2].map(|_| 0.5 * 2.0_f64.powf(2.0 * random.symmetric()));
        let hex = Hex8::new(corners(sides, &random.rotation())).unwrap();
        assert!(hex.is_brick());
        let through = Through::of(Layers::Seven);
        let mut general = (FullGeometry::EMPTY, LayeredGeometry::EMPTY);
        general.0.set(0, &hex, &stabilisation);
        general.1.set(0, &hex, &stabilisation, through);
        let mut bricks = [<BrickField as FullShape>::EMPTY; 2];
        FullShape::set(&mut bricks[0], 0, &hex, &stabilisation);
        LayeredShape::set(&mut bricks[1], 0, &hex, &stabilisation, through);
        let mut tensors = [0; 12].map(|_| Octet::ZERO);
        for (c, octet) in tensors.iter_mut().enumerate() {
            octet.0[0] = match c {
                0..6 => 1e-5 * random.symmetric(),
                _ => [0.3, 0.2, 0.4, 0.05, -0.04, 0.03][c - 6],
            };
        }
        let (strain, size) = tensors.split_at(6);
        let (strain, size) =
            (if draw % 2 == 0 { strain } else { &[] }, if draw % 3 == 0 { size } else { &[] });
        let mut full_ones = [(); 2].map(|()| One::new(8, 8 * MEMORY));
        let mut layered_ones = [(); 2].map(|()| One::new(28, MODAL_MEMORY));
        let way: [[[f64; 3]; 8]; 2] =
            std::array::from_fn(|_| std::array::from_fn(|_| [0; 3].map(|_| 4e-5 * random.symmetric())));
        let dt = 2e-4;
        assert_eq!(band.steps(dt), 4);
        let mut last = [[0.0; 3]; 8];
        let mut most = [[1e-30_f64; 4]; 2];
        for step in 0..40 {
            let t = step as f64 / 10.0;
            let u: [[f64; 3]; 8] =
                std::array::from_fn(|c| [0, 1, 2].map(|i| way[0][c][i] * t + way[1][c][i] * (5.0 * t).sin()));
            let rows = u.map(Row::new);
            let moved: [Row; 8] = std::array::from_fn(|c| Row::new([0, 1, 2].map(|i| u[c][i] - last[c][i])));
            last = u;
            let given = Given { strain, size, moved: &moved, water: None };
            let bodies = band.step(dt, law.moduli(), step);
            let (point, factor) = (Point::new(dt), Octet([0.3; 8]));
            macro_rules! pass {
                ($one:expr, $kernel:ident($($own:expr),*), $points:expr, $left:expr) => {{
                    let (one, mut probe, mut out) = (&mut $one, Probe::ZERO, [[Row::ZERO; 8]; 2]);
                    // SAFETY: eight rows, indices 0 to 7, and the scalar lane needs no instruction set.
                    unsafe {
                        $kernel::<f64, _, _, true>(
                            $($own,)* &INDEX, &mut one.history, Some(&bodies), &mut one.bodies, given,
                            &mut one.left, &rows, &mut out[0], &mut probe,
                        );
                        #[allow(clippy::redundant_closure_call)]
                        ($left)(&one.left, &mut out[1]);
                    }
                    seen(out, &probe, $points)
                }};
            }
            let moduli = law.moduli();
            let nothing = |_: &[Octet], _: &mut [Row; 8]| ();
            let ours = |left: &[Octet], out: &mut [Row; 8]| unsafe {
                bricks_left::<f64>(&moduli, &bricks[0], &INDEX, left, &factor, &moved, out)
            };
            let of_layers = |left: &[Octet], out: &mut [Row; 8]| unsafe {
                layered_left::<f64, _>(through, &moduli, &general.1, &INDEX, left, &factor, &moved, out)
            };
            let of_bricks = |left: &[Octet], out: &mut [Row; 8]| unsafe {
                layered_left::<f64, _>(through, &moduli, &bricks[1], &INDEX, left, &factor, &moved, out)
            };
            let s = &stabilisation;
            let pairs = [
                [
                    pass!(full_ones[0], full(&law, s, &point, &general.0), 8, nothing),
                    pass!(full_ones[1], full(&law, s, &point, &bricks[0]), 8, ours),
                ],
                [
                    pass!(layered_ones[0], layered(through, &law, &point, &general.1), 28, of_layers),
                    pass!(layered_ones[1], layered(through, &law, &point, &bricks[1]), 28, of_bricks),
                ],
            ];
            for (kind, [a, b]) in pairs.into_iter().enumerate() {
                for (group, (a, b)) in a.iter().zip(&b).enumerate() {
                    if kind == 0 && group == 1 {
                        continue;
                    }
                    let largest = a.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
                    most[kind][group] = most[kind][group].max(largest);
                    for (a, b) in a.iter().zip(b) {
                        worst = worst.max((a - b).abs() / most[kind][group]);
                    }
                }
            }
        }
        cracked +=
            layered_ones[1].history.chunks(Concrete::HISTORY.len()).filter(|p| p[0].0[0] > 0.0).count();
    }
    // Round-off, and what a crack that opens at once makes of it.
    assert!(worst < 1e-9, "{worst:e}");
    assert!(cracked > 50, "{cracked} points cracked");
}

/// Of 2×2×2 points the closed form is what the points would give one by one; V is anything symmetric between 0 and the unit tensor.
#[test]
fn what_damage_has_left_in_bricks_is_that_of_the_points() {
    let moduli = concrete().moduli();
    let mut random = Random::new(3);
    for draw in 0..20 {
        let hex = Hex8::new(corners([0.5, 1.0, 0.7], &random.rotation())).unwrap();
        let mut bricks = <BrickField as FullShape>::EMPTY;
        FullShape::set(&mut bricks, 0, &hex, &Stabilisation::new(moduli));
        let mut left = vec![Octet::ZERO; 8 * LEFT];
        for (p, point) in left.chunks_mut(LEFT).enumerate() {
            let broken = if draw == 0 || p % 3 == 0 { 0.0 } else { 0.3 };
            for (c, octet) in point.iter_mut().enumerate() {
                octet.0[0] = match c {
                    0..3 => 1.0 - broken * (1.0 + random.symmetric()),
                    3..6 => broken * 0.3 * random.symmetric(),
                    _ => 1.0,
                };
            }
        }
        let factor = Octet([0.4; 8]);
        let rows = [(); 8].map(|()| Row::new([0; 3].map(|_| 1e-4 * random.symmetric())));
        let (mut closed, mut summed, mut probe) = ([Row::ZERO; 8], [Row::ZERO; 8], Probe::ZERO);
        let law = Left { moduli };
        // SAFETY: as above.
        unsafe {
            bricks_left::<f64>(&moduli, &bricks, &INDEX, &left, &factor, &rows, &mut closed);
            full::<f64, _, _, false>(
                &law,
                &Stabilisation::new(moduli),
                &Point::new(0.0),
                &bricks,
                &INDEX,
                &mut left,
                None,
                &mut [],
                Given::NONE,
                &mut [],
                &rows,
                &mut summed,
                &mut probe,
            );
        }
        let largest = summed.iter().flat_map(Row::xyz).fold(0.0_f64, |most, f| most.max(f.abs()));
        for (a, b) in closed.iter().zip(&summed) {
            for i in 0..3 {
                assert!((a.0[i] - 0.4 * b.0[i]).abs() < 1e-13 * largest, "{a:?} and {b:?}");
            }
        }
    }
}

/// V·(C:(V·ε·V))·V with V in the history.
struct Left {
    moduli: tremolite_laws::Moduli,
}

impl Material for Left {
    const NAME: &'static str = "left";
    const SUMMARY: &'static str = "what damage has left";
    const SOURCE: &'static str = "a test";
    const PARAMETERS: &'static [tremolite_laws::Parameter] = &[];
    const HISTORY: &'static [tremolite_laws::Column] =
        &[const { tremolite_laws::Column::new("v", "1", "V") }; LEFT];
    type History<L: tremolite_laws::Lane> = [L; LEFT];

    fn new(_: &Values) -> Result<Self, Vec<tremolite_laws::BadParameter>> {
        Ok(Left { moduli: tremolite_laws::Moduli::from_young_poisson(YOUNG, 0.2) })
    }
    fn moduli(&self) -> tremolite_laws::Moduli {
        self.moduli
    }
    fn scaled(&self, factor: f64) -> Self {
        Left { moduli: self.moduli.scaled(factor) }
    }
    fn update<L: tremolite_laws::Lane>(
        &self,
        _: &Point<L>,
        strain: tremolite_laws::Sym<L>,
        v: [L; LEFT],
    ) -> (tremolite_laws::Sym<L>, [L; LEFT]) {
        (self.moduli.stress_left(&strain, &[v[0], v[1], v[2], v[3], v[4], v[5]]), v)
    }
}

#[test]
fn what_is_not_a_brick_is_none() {
    let mut random = Random::new(2);
    for _ in 0..50 {
        let sides = [1.0, 0.25, 2.0];
        let axes = random.rotation();
        let mut off = corners(sides, &axes);
        assert!(Hex8::new(off).unwrap().is_brick());
        off[5][1] += 1e-9;
        assert!(!Hex8::new(off).unwrap().is_brick());
        let mut sheared = axes;
        for i in 0..3 {
            sheared[1][i] += 1e-9 * axes[0][i];
        }
        assert!(!Hex8::new(corners(sides, &sheared)).unwrap().is_brick());
    }
}
