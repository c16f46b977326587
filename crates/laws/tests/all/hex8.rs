//! The hexahedron's promises: patch test, zero-energy modes, locking, bits.

use tremolite_laws::materials::Elastic;
use tremolite_laws::shapes::hex8::{
    CORNERS, FullGeometry, Given, Hex8, LayeredGeometry, Layers, OnePointGeometry, OnePointShape, Points,
    Probe, Quadrature, Stabilisation, Through, elastic_stress, full, layered, one_point, turned,
};
use tremolite_laws::{Isa, Moduli, Octet, Point, Row};

pub(crate) type Forces = [[f64; 3]; 8];

/// Layered elements have their thickness along ζ here, as kernels do.
pub(crate) type Kind = Quadrature;
const LAYERED: Kind = Kind::Layered(Layers::Nine);
pub(crate) const KINDS: [Kind; 3] = [Kind::OnePoint, Kind::Full, LAYERED];

pub(crate) fn points(kind: Kind) -> Points {
    Points { quadrature: kind, axis: 2 }
}

/// Forces of one element by the scalar reference, with its strain and hourglass energy and the mean stress.
fn element(kind: Kind, moduli: Moduli, corners: [[f64; 3]; 8], u: [[f64; 3]; 8]) -> (Forces, f64, [f64; 6]) {
    let hex = Hex8::new(corners).unwrap();
    let (forces, probe) = pass(kind, moduli, &hex, u);
    let mut mean = [0.0; 6];
    for (stress, weight) in probe.stress.iter().zip(points(kind).weights(&hex)) {
        for c in 0..6 {
            mean[c] += weight / hex.volume * stress[c].0[0];
        }
    }
    (forces, probe.strain_energy.0[0] + probe.hourglass_energy.0[0], mean)
}

/// Forces of one element by the scalar reference, with what the probe finds, in lane 0.
pub(crate) fn pass(kind: Kind, moduli: Moduli, hex: &Hex8, u: [[f64; 3]; 8]) -> (Forces, Probe) {
    let law = Elastic::from_moduli(moduli);
    let stabilisation = Stabilisation::new(moduli);
    let index: [[u16; 8]; 8] = core::array::from_fn(|k| [k as u16; 8]);
    let rows = u.map(Row::new);
    let mut out = [Row::ZERO; 8];
    let mut probe = Probe::ZERO;
    let point = Point::new(0.0);
    // All eight lanes scatter to the same rows: give the element to lane 0 alone.
    match kind {
        Kind::OnePoint => {
            let mut geometry = OnePointGeometry::EMPTY;
            geometry.set(0, hex);
            unsafe {
                one_point::<f64, _, _, true>(
                    &law,
                    &stabilisation,
                    &point,
                    &geometry,
                    &index,
                    &mut [],
                    None,
                    &mut [],
                    Given::NONE,
                    &mut [],
                    &rows,
                    &mut out,
                    &mut probe,
                )
            }
        }
        Kind::Full => {
            let mut geometry = FullGeometry::EMPTY;
            geometry.set(0, hex, &stabilisation);
            unsafe {
                full::<f64, _, _, true>(
                    &law,
                    &stabilisation,
                    &point,
                    &geometry,
                    &index,
                    &mut [],
                    None,
                    &mut [],
                    Given::NONE,
                    &mut [],
                    &rows,
                    &mut out,
                    &mut probe,
                )
            }
        }
        Kind::Layered(layers) => {
            let through = Through::of(layers);
            let mut geometry = LayeredGeometry::EMPTY;
            geometry.set(0, hex, &stabilisation, through);
            unsafe {
                layered::<f64, _, _, true>(
                    through,
                    &law,
                    &point,
                    &geometry,
                    &index,
                    &mut [],
                    None,
                    &mut [],
                    Given::NONE,
                    &mut [],
                    &rows,
                    &mut out,
                    &mut probe,
                )
            }
        }
    }
    (out.map(|r| r.xyz()), probe)
}

/// A brick of the given sides with every corner moved by up to `shift`.
fn distorted(sides: [f64; 3], shift: f64, seed: u64) -> [[f64; 3]; 8] {
    let mut s = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut random = || {
        s ^= s << 13;
        s ^= s >> 7;
        s ^= s << 17;
        (s >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    CORNERS.map(|c| [0, 1, 2].map(|i| sides[i] * (0.5 * c[i] + shift * random())))
}

fn linear_field(x: [f64; 3]) -> [f64; 3] {
    [
        1e-3 * (0.3 + 2.0 * x[0] - 0.7 * x[1] + 0.4 * x[2]),
        1e-3 * (-0.1 + 0.9 * x[0] + 1.5 * x[1] - 0.2 * x[2]),
        1e-3 * (0.2 - 0.5 * x[0] + 0.8 * x[1] - 1.1 * x[2]),
    ]
}

#[test]
fn elastic_stress_is_that_of_the_elements_own_pass() {
    let moduli = Moduli::from_young_poisson(25e9, 0.17);
    for seed in 0..20 {
        let corners = distorted([1.0, 1.3, 0.6], 0.3, seed);
        let u = distorted([1e-3, 2e-3, 1e-3], 0.7, seed + 100);
        let hex = Hex8::new(corners).unwrap();
        for kind in KINDS {
            let (_, _, mean) = element(kind, moduli, corners, u);
            let points = elastic_stress(&hex, moduli, kind, &u);
            assert_eq!(points.len(), if kind == Kind::OnePoint { 1 } else { 8 });
            for c in 0..6 {
                let weight = |p: usize| if points.len() == 1 { 1.0 } else { hex.weights[p] / hex.volume };
                let own: f64 = points.iter().enumerate().map(|(p, stress)| weight(p) * stress[c]).sum();
                assert!((own - mean[c]).abs() < 1e-9 * mean[0].abs().max(1e6), "{kind:?} {c}");
            }
        }
    }
}

#[test]
fn constant_strain_gives_constant_stress_on_any_shape() {
    let moduli = Moduli::from_young_poisson(25e9, 0.17);
    let (l, m) = (moduli.lambda, moduli.mu);
    let trace = 1e-3 * (2.0 + 1.5 - 1.1);
    let exact = [
        l * trace + 2.0 * m * 2e-3,
        l * trace + 2.0 * m * 1.5e-3,
        l * trace - 2.0 * m * 1.1e-3,
        m * 0.2e-3,
        m * 0.6e-3,
        m * -0.1e-3,
    ];
    for seed in 0..20 {
        let corners = distorted([1.0, 1.3, 0.6], 0.3, seed);
        for kind in KINDS {
            let (_, energy, mean) = element(kind, moduli, corners, corners.map(linear_field));
            for c in 0..6 {
                assert!((mean[c] - exact[c]).abs() < 1e-12 * exact[0].abs(), "{kind:?} {c}");
            }
            let volume = Hex8::new(corners).unwrap().volume;
            let strain = [2e-3, 1.5e-3, -1.1e-3, 0.2e-3, 0.6e-3, -0.1e-3];
            let density: f64 = 0.5 * exact.iter().zip(strain).map(|(s, e)| s * e).sum::<f64>();
            assert!((energy - density * volume).abs() < 1e-12 * energy, "no energy in the hourglass part");
        }
    }
}

/// MacNeal & Harder (1985): the cube of seven distorted hexahedra; the inner nodes must find the linear field.
#[test]
fn macneal_harder_1985_patch_test_to_round_off() {
    let inner = [
        [0.249, 0.342, 0.192],
        [0.826, 0.288, 0.288],
        [0.850, 0.649, 0.263],
        [0.273, 0.750, 0.230],
        [0.320, 0.186, 0.643],
        [0.677, 0.305, 0.683],
        [0.788, 0.693, 0.644],
        [0.165, 0.745, 0.702],
    ];
    let outer = CORNERS.map(|c| c.map(|x| 0.5 + 0.5 * x));
    let node = |n: usize| if n < 8 { inner[n] } else { outer[n - 8] };
    // The inner hexahedron, and one on each face of it towards the cube's face.
    let faces = [[0, 3, 7, 4], [1, 2, 6, 5], [0, 1, 5, 4], [3, 2, 6, 7], [0, 1, 2, 3], [4, 5, 6, 7]];
    let mut cells: Vec<[usize; 8]> = vec![[0, 1, 2, 3, 4, 5, 6, 7]];
    for f in faces {
        let mut cell = [f[0] + 8, f[1] + 8, f[2] + 8, f[3] + 8, f[0], f[1], f[2], f[3]];
        if Hex8::new(cell.map(node)).is_err() {
            cell = [f[0], f[1], f[2], f[3], f[0] + 8, f[1] + 8, f[2] + 8, f[3] + 8];
        }
        cells.push(cell);
    }
    let field = |x: [f64; 3]| {
        [
            5e-4 * (2.0 * x[0] + x[1] + x[2]),
            5e-4 * (x[0] + 2.0 * x[1] + x[2]),
            5e-4 * (x[0] + x[1] + 2.0 * x[2]),
        ]
    };
    let moduli = Moduli::from_young_poisson(1e6, 0.25);
    for kind in KINDS {
        let mut residual = [[0.0; 3]; 16];
        for cell in &cells {
            let corners = cell.map(node);
            let (forces, _, stress) = element(kind, moduli, corners, corners.map(field));
            for (c, exact) in stress.into_iter().zip([2000.0, 2000.0, 2000.0, 400.0, 400.0, 400.0]) {
                assert!((c - exact).abs() < 1e-9 * exact);
            }
            for (n, f) in cell.iter().zip(forces) {
                for i in 0..3 {
                    residual[*n][i] += f[i];
                }
            }
        }
        // Forces of 2000 Pa on faces of some 0.1 m² are of order 100 N.
        let worst = residual[..8].iter().flatten().fold(0.0_f64, |w, r| w.max(r.abs()));
        assert!(worst < 1e-11, "{kind:?}: {worst:e} N at the free nodes");
    }
}

/// The 24×24 stiffness, column by column.
fn stiffness(kind: Kind, moduli: Moduli, corners: [[f64; 3]; 8]) -> Vec<Vec<f64>> {
    let mut k = vec![vec![0.0; 24]; 24];
    for column in 0..24 {
        let mut u = [[0.0; 3]; 8];
        u[column / 3][column % 3] = 1.0;
        let (f, ..) = element(kind, moduli, corners, u);
        for row in 0..24 {
            k[row][column] = f[row / 3][row % 3];
        }
    }
    k
}

/// Eigenvalues of a symmetric matrix by Jacobi's rotations, ascending.
pub(crate) fn eigenvalues(mut a: Vec<Vec<f64>>) -> Vec<f64> {
    let n = a.len();
    for _ in 0..30 {
        for p in 0..n {
            for q in p + 1..n {
                if a[p][q] == 0.0 {
                    continue;
                }
                let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
                let t = theta.signum() / (theta.abs() + theta.hypot(1.0));
                let c = 1.0 / t.hypot(1.0);
                let s = t * c;
                for r in 0..n {
                    let (x, y) = (a[r][p], a[r][q]);
                    a[r][p] = c * x - s * y;
                    a[r][q] = s * x + c * y;
                }
                for r in 0..n {
                    let (x, y) = (a[p][r], a[q][r]);
                    a[p][r] = c * x - s * y;
                    a[q][r] = s * x + c * y;
                }
            }
        }
    }
    let mut values: Vec<f64> = (0..n).map(|i| a[i][i]).collect();
    values.sort_by(f64::total_cmp);
    values
}

#[test]
fn exactly_six_zero_energy_modes_and_a_symmetric_stiffness() {
    for nu in [0.0, 0.25, 0.4999] {
        let moduli = Moduli::from_young_poisson(1.0, nu);
        for seed in 0..5 {
            let corners = distorted([1.0, 1.2, 0.8], if seed == 0 { 0.0 } else { 0.25 }, seed);
            for kind in KINDS {
                let k = stiffness(kind, moduli, corners);
                let size = k.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
                for i in 0..24 {
                    for j in 0..i {
                        assert!((k[i][j] - k[j][i]).abs() < 1e-14 * size, "{kind:?}");
                    }
                }
                let values = eigenvalues(k);
                assert!(values[5].abs() < 1e-13 * size, "{kind:?} ν = {nu}: {:e}", values[5]);
                assert!(values[6] > 1e-3, "{kind:?} ν = {nu}: seventh eigenvalue {:e} E m", values[6]);
            }
        }
    }
}

/// A brick pushed over into a parallelepiped, turned at will.
fn leaning(sides: [f64; 3], shear: f64) -> [[f64; 3]; 8] {
    let (s, c) = 0.4_f64.sin_cos();
    CORNERS.map(|k| {
        let x = [0, 1, 2].map(|i| 0.5 * sides[i] * k[i]);
        let x = [x[0] + shear * x[1] - 0.3 * shear * x[2], x[1] + 0.2 * shear * x[2], x[2]];
        [c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]]
    })
}

#[test]
fn quadratures_agree_on_parallelepipeds_where_the_closed_form_is_exact() {
    for shear in [0.0, 0.3, 1.0] {
        let corners = leaning([2.0, 0.7, 1.1], shear);
        let moduli = Moduli::from_young_poisson(1.0, 0.3);
        let one = stiffness(Kind::OnePoint, moduli, corners);
        let others = Layers::ALL.map(Kind::Layered).into_iter().chain([Kind::Full]);
        for other in others {
            let other = stiffness(other, moduli, corners);
            for (a, b) in one.iter().flatten().zip(other.iter().flatten()) {
                assert!((a - b).abs() < 1e-14, "{shear}: {a} and {b}");
            }
        }
    }
}

/// The outer weights make 1 and ζ² exact, the middle makes odd powers vanish; none is negative. Volumes and means of the modes
/// are then those of Gauss's points in any shape, where det J is quadratic in ζ.
#[test]
fn layers_integrate_cubics_through_the_thickness_and_the_volume_of_any_shape() {
    for layers in Layers::ALL {
        let through = Through::of(layers);
        let of = |power: i32| -> f64 {
            (0..through.count).map(|k| through.weight[k] * through.zeta[k].powi(power)).sum()
        };
        for (power, exact) in [(0, 2.0), (1, 0.0), (2, 2.0 / 3.0), (3, 0.0)] {
            assert!((of(power) - exact).abs() < 4e-16, "{layers:?} ζ^{power}: {}", of(power));
        }
        assert!(through.weight[..through.count].iter().all(|weight| *weight > 0.0));
        assert_eq!((through.zeta[0], through.zeta[through.count - 1]), (-1.0, 1.0));
        for (seed, axis) in (0..30).map(|seed| (seed, seed as usize % 3)) {
            let hex = Hex8::new(distorted([1.0, 1.3, 0.6], 0.3, seed)).unwrap();
            let points = Points { quadrature: Kind::Layered(layers), axis };
            let weights = points.weights(&hex);
            let mean = |of: &dyn Fn([f64; 3]) -> f64| -> f64 {
                (0..points.count()).map(|p| weights[p] * of(points.natural(p))).sum()
            };
            let exact = |of: &dyn Fn([f64; 3]) -> f64| -> f64 {
                let full = Points { quadrature: Kind::Full, axis };
                (0..8).map(|p| hex.weights[p] * of(full.natural(p))).sum()
            };
            let modes: [&dyn Fn([f64; 3]) -> f64; 5] =
                [&|_| 1.0, &|x| x[0], &|x| x[1], &|x| x[2], &|x| x[0] * x[1] - x[1] * x[2] + x[2] * x[0]];
            for mode in modes {
                assert!((mean(mode) - exact(mode)).abs() < 1e-15 * 4.0, "{layers:?}, axis {axis}");
            }
        }
    }
}

/// An element turned so that another natural axis is its thickness is the same element.
#[test]
fn an_element_may_be_numbered_from_any_of_its_axes() {
    let moduli = Moduli::from_young_poisson(1.0, 0.3);
    let corners = distorted([2.0, 0.7, 1.1], 0.3, 5);
    for axis in 0..3 {
        let order = turned(axis);
        assert_eq!(order.map(|k| CORNERS[k][axis]), CORNERS.map(|c| c[2]), "ζ is the axis asked for");
        let volume = Hex8::new(order.map(|k| corners[k])).unwrap().volume;
        assert!((volume / Hex8::new(corners).unwrap().volume - 1.0).abs() < 1e-14, "no mirror image");
        let own = stiffness(Kind::Full, moduli, corners);
        let other = stiffness(Kind::Full, moduli, order.map(|k| corners[k]));
        for (i, row) in other.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                let same = own[3 * order[i / 3] + i % 3][3 * order[j / 3] + j % 3];
                assert!((value - same).abs() < 1e-14, "{axis}");
            }
        }
    }
    assert_eq!(turned(2), [0, 1, 2, 3, 4, 5, 6, 7]);
}

/// A leaning element under the displacements of pure bending about an axis of its mid-surface has exactly the
/// energy of plane-stress bending: ends that are not square to the fibres do not matter.
#[test]
fn a_leaning_element_bends_as_exactly_as_a_square_one() {
    let nu = 0.25;
    let moduli = Moduli::from_young_poisson(1.0, nu);
    let (a, b, c) = (1.0, 0.1, 0.2);
    for lean in [0.0, 0.2, 1.0] {
        let corners = CORNERS.map(|k| [k[0] * a + lean * k[1] * b, k[1] * b, k[2] * c]);
        // Curvature 1 about z, with the anticlastic curvature −ν about x.
        let u =
            corners.map(|x| [x[0] * x[1], -0.5 * x[0] * x[0] + 0.5 * nu * x[2] * x[2], -nu * x[1] * x[2]]);
        let exact = 0.5 * (2.0 * a) * (2.0 * c) * (2.0 * b).powi(3) / 12.0;
        for kind in KINDS {
            let (_, energy, _) = element(kind, moduli, corners, u);
            assert!((energy / exact - 1.0).abs() < 1e-12, "{kind:?}, lean {lean}: ratio {}", energy / exact);
        }
    }
}

/// Hexahedra with corners made one: wedge, pyramid, tetrahedron. Node of each corner, and the nodes.
fn collapsed() -> [([usize; 8], Vec<[f64; 3]>); 3] {
    let (a, b, c, d) = ([0.1, 0.0, 0.0], [1.0, 0.0, 0.1], [1.1, 1.0, -0.1], [0.0, 0.9, 0.1]);
    let (e, f, g) = ([0.0, 0.0, 1.0], [1.1, 0.1, 1.2], [0.2, 0.9, 0.9]);
    [
        ([0, 1, 2, 2, 3, 4, 5, 5], vec![a, b, d, e, f, g]),
        ([0, 1, 2, 3, 4, 4, 4, 4], vec![a, b, c, d, [0.4, 0.6, 1.1]]),
        ([0, 1, 2, 2, 3, 3, 3, 3], vec![a, b, d, e]),
    ]
}

#[test]
fn collapsed_hexahedra_are_sound_wedges_pyramids_and_tetrahedra() {
    let moduli = Moduli::from_young_poisson(1.0, 0.25);
    for (node, nodes) in collapsed() {
        let corners = node.map(|n| nodes[n]);
        let n = nodes.len();
        for kind in KINDS {
            // Patch test: exact stress, exact energy, forces that balance at every node of a constant stress.
            let (_, energy, stress) = element(kind, moduli, corners, corners.map(linear_field));
            let trace = 1e-3 * (2.0 + 1.5 - 1.1);
            let exact = moduli.lambda * trace + 2.0 * moduli.mu * 2e-3;
            assert!((stress[0] - exact).abs() < 1e-16, "{kind:?}, {n} nodes");
            assert!(energy > 0.0);
            let k = stiffness(kind, moduli, corners);
            let mut joined = vec![vec![0.0; 3 * n]; 3 * n];
            for (i, row) in k.iter().enumerate() {
                for (j, value) in row.iter().enumerate() {
                    joined[3 * node[i / 3] + i % 3][3 * node[j / 3] + j % 3] += value;
                }
            }
            let values = eigenvalues(joined);
            assert!(values[5].abs() < 1e-14, "{kind:?}, {n} nodes: {:e}", values[5]);
            assert!(values[6] > 1e-3, "{kind:?}, {n} nodes: {:e}", values[6]);
        }
        // The tetrahedron and the prism share their mass evenly.
        let hex = Hex8::new(corners).unwrap();
        let mut shares = vec![0.0; n];
        for (corner, share) in node.into_iter().zip(hex.corner_volumes) {
            shares[corner] += share / hex.volume;
        }
        assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-14);
        if n == 4 {
            assert!(shares.iter().all(|s| (s - 0.25).abs() < 1e-14), "{shares:?}");
        }
    }
}

#[test]
fn nearly_incompressible_material_stiffens_one_mode_only() {
    // Of 24 modes only the mean dilatation may grow with the bulk modulus.
    let modes = |nu| {
        KINDS.map(|kind| {
            eigenvalues(stiffness(kind, Moduli::from_young_poisson(1.0, nu), distorted([1.0; 3], 0.2, 3)))
        })
    };
    for (soft, hard) in modes(0.49).into_iter().zip(modes(0.4999)) {
        assert!(hard[23] > 50.0 * soft[23], "the dilatation must feel the bulk modulus");
        for m in 6..23 {
            assert!(hard[m] < 1.2 * soft[m], "mode {m} grows from {} to {}", soft[m], hard[m]);
        }
    }
}

#[test]
fn stiffness_turns_with_the_element() {
    let moduli = Moduli::from_young_poisson(1.0, 0.2);
    let corners = distorted([1.0, 0.5, 2.0], 0.2, 7);
    let u = distorted([1e-3; 3], 1.0, 8);
    let (s, c) = 0.7_f64.sin_cos();
    let turn = |v: [f64; 3]| {
        let w = [c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]];
        [w[0], c * w[1] - s * w[2], s * w[1] + c * w[2]]
    };
    for kind in KINDS {
        let (f, energy, _) = element(kind, moduli, corners, u);
        let (turned, turned_energy, _) = element(kind, moduli, corners.map(turn), u.map(turn));
        assert!((energy - turned_energy).abs() < 1e-13 * energy);
        for (f, g) in f.map(turn).iter().flatten().zip(turned.iter().flatten()) {
            assert!((f - g).abs() < 1e-13 * 1e-3, "{kind:?}");
        }
    }
}

/// Pure bending of a regular element: the exact energy of plane-stress beam bending, with the sides free to
/// contract. The amplitude of the free contraction is found by minimising over the anticlastic mode.
#[test]
fn a_regular_element_bends_without_shear_or_poisson_locking() {
    for nu in [0.0, 0.3, 0.4999] {
        let moduli = Moduli::from_young_poisson(1.0, nu);
        let (a, b, c) = (1.0, 0.1, 0.2);
        let corners = CORNERS.map(|k| [k[0] * a, k[1] * b, k[2] * c]);
        // u_x = x y; u_z = −ν y z at the corners (the parabola of u_y is beyond trilinear functions).
        let u = corners.map(|x| [x[0] * x[1], 0.0, -nu * x[1] * x[2]]);
        let exact = 0.5 * (2.0 * a) * (2.0 * c) * (2.0 * b).powi(3) / 12.0;
        for kind in KINDS {
            let (_, energy, _) = element(kind, moduli, corners, u);
            assert!((energy / exact - 1.0).abs() < 1e-12, "{kind:?} ν = {nu}: ratio {}", energy / exact);
        }
    }
}

/// Every instruction set gives the scalar reference's bits, for ordinary and extraordinary numbers.
#[cfg(target_arch = "x86_64")]
#[test]
fn lanes_equal_the_scalar_reference_bit_for_bit() {
    use tremolite_laws::lane::{Avx2, Avx512, Enabled};

    #[derive(Clone, Copy)]
    struct Here;
    // SAFETY: named in `avx2` and `avx512` alone, which are called where the instruction set is there.
    unsafe impl Enabled for Here {}

    #[target_feature(enable = "avx512f,avx2,fma")]
    unsafe fn avx512(c: &Case, out: &mut [Row], probe: &mut Probe) {
        unsafe { run::<Avx512<Here>>(c, out, probe) }
    }
    #[target_feature(enable = "avx2,fma")]
    unsafe fn avx2(c: &Case, out: &mut [Row], probe: &mut Probe) {
        unsafe { run::<Avx2<Here>>(c, out, probe) }
    }
    struct Case {
        kind: Kind,
        one: OnePointGeometry,
        full: FullGeometry,
        layers: LayeredGeometry,
        index: [[u16; 8]; 8],
        rows: Vec<Row>,
    }
    #[inline(always)]
    unsafe fn run<L: tremolite_laws::Lane>(c: &Case, out: &mut [Row], probe: &mut Probe) {
        let moduli = Moduli::from_young_poisson(25e9, 0.17);
        let (law, s, point) = (Elastic::from_moduli(moduli), Stabilisation::new(moduli), Point::new(1e-4));
        unsafe {
            match c.kind {
                Kind::OnePoint => one_point::<L, _, _, true>(
                    &law,
                    &s,
                    &point,
                    &c.one,
                    &c.index,
                    &mut [],
                    None,
                    &mut [],
                    Given::NONE,
                    &mut [],
                    &c.rows,
                    out,
                    probe,
                ),
                Kind::Full => full::<L, _, _, true>(
                    &law,
                    &s,
                    &point,
                    &c.full,
                    &c.index,
                    &mut [],
                    None,
                    &mut [],
                    Given::NONE,
                    &mut [],
                    &c.rows,
                    out,
                    probe,
                ),
                Kind::Layered(layers) => layered::<L, _, _, true>(
                    Through::of(layers),
                    &law,
                    &point,
                    &c.layers,
                    &c.index,
                    &mut [],
                    None,
                    &mut [],
                    Given::NONE,
                    &mut [],
                    &c.rows,
                    out,
                    probe,
                ),
            }
        }
    }

    let mut seed = 42u64;
    let mut random = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let mut compared = 0;
    for trial in 0..40 {
        let (mut one, mut full) = (OnePointGeometry::EMPTY, FullGeometry::EMPTY);
        let mut layers = LayeredGeometry::EMPTY;
        for lane in 0..8 {
            let hex = Hex8::new(distorted([1.0, 2.0, 0.5], 0.3, 8 * trial + lane + 1)).unwrap();
            let s = Stabilisation::new(Moduli::from_young_poisson(25e9, 0.17));
            one.set(lane as usize, &hex);
            full.set(lane as usize, &hex, &s);
            layers.set(lane as usize, &hex, &s, Through::of(Layers::Nine));
        }
        // Twenty rows for 64 corners: lanes collide on purpose.
        let index = core::array::from_fn(|_| core::array::from_fn(|_| ((random() + 0.5) * 19.99) as u16));
        let mut rows: Vec<Row> = (0..20).map(|_| Row::new([random(), random(), random()])).collect();
        for (i, special) in [0.0, -0.0, 5e-324, 1e300, f64::INFINITY, f64::NAN].into_iter().enumerate() {
            if trial % 7 == i as u64 + 1 {
                rows[i].0[i % 3] = special;
            }
        }
        for kind in KINDS {
            let case = Case { kind, one, full, layers, index, rows: rows.clone() };
            let bits = |out: &[Row], probe: &Probe| -> Vec<u64> {
                let points = kind.points();
                out.iter()
                    .flat_map(|r| r.0)
                    .chain(probe.stress[..points].iter().flatten().flat_map(|o: &Octet| o.0))
                    .chain(probe.strain_energy.0)
                    .chain(probe.hourglass_energy.0)
                    .map(|x| if x.is_nan() { 1 } else { x.to_bits() })
                    .collect()
            };
            let mut out = vec![Row::ZERO; 20];
            let mut probe = Probe::ZERO;
            unsafe { run::<f64>(&case, &mut out, &mut probe) };
            let reference = bits(&out, &probe);
            if Isa::Avx2.available() {
                let (mut out, mut probe) = (vec![Row::ZERO; 20], Probe::ZERO);
                unsafe { avx2(&case, &mut out, &mut probe) };
                assert!(bits(&out, &probe) == reference, "{kind:?} AVX2, trial {trial}");
                compared += 1;
            }
            if Isa::Avx512.available() {
                let (mut out, mut probe) = (vec![Row::ZERO; 20], Probe::ZERO);
                unsafe { avx512(&case, &mut out, &mut probe) };
                assert!(bits(&out, &probe) == reference, "{kind:?} AVX-512, trial {trial}");
                compared += 1;
            }
        }
    }
    eprintln!("{compared} comparisons with {:?}", Isa::best());
}
