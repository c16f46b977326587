//! The wedge's promises: bending without shear, patch test, zero-energy modes, no first corner.

use crate::hex8::{KINDS, Kind, eigenvalues, pass, points};
use tremolite_laws::Moduli;
use tremolite_laws::shapes::hex8::Hex8;

type Vector = [f64; 3];

/// A wedge as a hexahedron: three nodes of a triangle, then those across.
fn corners(nodes: [Vector; 6]) -> [Vector; 8] {
    let [a, b, c, d, e, f] = nodes;
    [a, b, c, c, d, e, f, f]
}

fn wedge(nodes: [Vector; 6]) -> Hex8 {
    let hex = Hex8::new(corners(nodes)).unwrap();
    assert!(hex.is_wedge);
    hex
}

/// Numbers between −½ and ½.
fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut s = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    move || {
        s ^= s << 13;
        s ^= s >> 7;
        s ^= s << 17;
        (s >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    }
}

/// A prism over any triangle, of this thickness.
fn prism(seed: u64, thickness: f64) -> [Vector; 6] {
    let mut random = random(seed);
    let triangle = [[0.0, 0.0], [1.0, 0.1], [0.2, 0.9]].map(|p: [f64; 2]| p.map(|x| x + 0.3 * random()));
    let at = |z: f64| triangle.map(|[x, y]| [x, y, z]);
    let ([a, b, c], [d, e, f]) = (at(-0.5 * thickness), at(0.5 * thickness));
    [a, b, c, d, e, f]
}

/// A wedge with every node moved.
fn distorted(seed: u64) -> [Vector; 6] {
    let mut random = random(seed + 100);
    prism(seed, 0.8).map(|x| x.map(|x| x + 0.2 * random()))
}

/// Turned about two axes.
fn turned(x: Vector) -> Vector {
    let ((s, c), (t, d)) = (0.7_f64.sin_cos(), 0.4_f64.sin_cos());
    let [x, y, z] = [c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]];
    [x, d * y - t * z, t * y + d * z]
}

fn forces(kind: Kind, hex: &Hex8, nodes: [Vector; 6], u: impl Fn(Vector) -> Vector) -> [Vector; 6] {
    let moduli = Moduli::from_young_poisson(1.0, 0.3);
    let (f, _) = pass(kind, moduli, hex, corners(nodes.map(u)));
    let plus = |a: usize, b: usize| [0, 1, 2].map(|i| f[a][i] + f[b][i]);
    [f[0], f[1], plus(2, 3), f[4], f[5], plus(6, 7)]
}

/// The stiffness of the six nodes.
fn stiffness(kind: Kind, moduli: Moduli, hex: &Hex8) -> Vec<Vec<f64>> {
    const NODE: [usize; 8] = [0, 1, 2, 2, 3, 4, 5, 5];
    let mut k = vec![vec![0.0; 18]; 18];
    for column in 0..18 {
        let mut u = [[0.0; 3]; 8];
        (0..8).filter(|&c| NODE[c] == column / 3).for_each(|c| u[c][column % 3] = 1.0);
        let (f, _) = pass(kind, moduli, hex, u);
        for (f, node) in f.iter().zip(NODE) {
            (0..3).for_each(|i| k[3 * node + i][column] += f[i]);
        }
    }
    k
}

/// u = (xz, 0, −x²/2), turned: ε_xx = z and, of plane stress, ε_zz = −ν/(1 − ν) z; thick and thin.
#[test]
fn a_wedge_bends_without_shear_whatever_its_triangle() {
    let nu = 0.3;
    let moduli = Moduli::from_young_poisson(1.0, nu);
    for seed in 0..20 {
        for thickness in [0.02, 0.5, 2.0] {
            let nodes = prism(seed, thickness);
            for angle in [0.0, 0.6, 2.0_f64] {
                let (s, c) = angle.sin_cos();
                let bent = |[x, y, z]: Vector| {
                    let along = c * x + s * y;
                    turned([c * along * z, s * along * z, -0.5 * along * along])
                };
                let hex = wedge(nodes.map(turned));
                for kind in KINDS.into_iter().filter(|kind| *kind != Kind::OnePoint) {
                    let (_, probe) = pass(kind, moduli, &hex, corners(nodes.map(bent)));
                    for p in 0..kind.points() {
                        let z = 0.5 * thickness * points(kind).natural(p)[2];
                        let stress = probe.stress[p].map(|c| c.0[0]);
                        let [along, across, normal] =
                            [[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]].map(turned);
                        let of = |a: Vector, b: Vector| {
                            let row = |i: usize| {
                                let t = [[0, 3, 5], [3, 1, 4], [5, 4, 2]][i];
                                (0..3).map(|j| stress[t[j]] * b[j]).sum::<f64>()
                            };
                            (0..3).map(|i| a[i] * row(i)).sum::<f64>()
                        };
                        let plate = z / (1.0 - nu * nu);
                        let near = |found: f64, exact: f64| {
                            assert!((found - exact).abs() < 1e-13, "{kind:?} {seed}: {found} and {exact}")
                        };
                        near(of(along, along), plate);
                        near(of(across, across), nu * plate);
                        near(of(normal, normal), 0.0);
                        near(of(along, normal), 0.0);
                        near(of(across, normal), 0.0);
                        near(of(along, across), 0.0);
                    }
                }
            }
        }
    }
}

#[test]
fn constant_strain_gives_constant_stress_in_any_wedge() {
    let moduli = Moduli::from_young_poisson(1.0, 0.3);
    let linear = |[x, y, z]: Vector| {
        [0.3 + 2.0 * x - 0.7 * y + 0.4 * z, 0.9 * x + 1.5 * y - 0.2 * z, -0.5 * x + 0.8 * y - 1.1 * z]
    };
    let exact = moduli.stress(&[2.0, 1.5, -1.1, 0.2, 0.6, -0.1]);
    for seed in 0..40 {
        let nodes = distorted(seed);
        let mut hex = wedge(nodes);
        for linked in [hex.linked, [false; 3], [true; 3]] {
            hex.linked = linked;
            for kind in KINDS {
                let (_, probe) = pass(kind, moduli, &hex, corners(nodes.map(linear)));
                for p in 0..kind.points() {
                    for c in 0..6 {
                        let found = probe.stress[p][c].0[0];
                        assert!(
                            (found - exact[c]).abs() < 1e-12,
                            "{kind:?} {seed}: {found} and {}",
                            exact[c]
                        );
                    }
                }
                let energy = probe.strain_energy.0[0] + probe.hourglass_energy.0[0];
                let density =
                    0.5 * (0..6).map(|c| exact[c] * [2.0, 1.5, -1.1, 0.2, 0.6, -0.1][c]).sum::<f64>();
                assert!((energy / (density * hex.volume) - 1.0).abs() < 1e-12, "{kind:?} {seed}");
            }
        }
    }
}

/// Largest force at free nodes of a patch under a linear field. A plan of 4 by 4 cells with nodes moved at will, most of them two wedges,
/// one in five a hexahedron, in two layers, of edges that lean alike; surfaces are uneven by `uneven`, and edges lean each on their own by `twist`.
fn patch_residual(kind: Kind, seed: u64, uneven: f64, twist: f64) -> f64 {
    let mut random = random(seed);
    let lean = [0.3 * random(), 0.3 * random()];
    let mut nodes = vec![[0.0; 3]; 75];
    for (n, x) in nodes.iter_mut().enumerate() {
        let [i, j, k] = [n % 5, n / 5 % 5, n / 25].map(|i| i as f64);
        *x = [i, j, 0.7 * k + uneven * random()];
    }
    let shifts: Vec<[f64; 2]> = (0..25).map(|_| [0.4 * random(), 0.4 * random()]).collect();
    for (n, x) in nodes.iter_mut().enumerate() {
        for i in 0..2 {
            x[i] += shifts[n % 25][i] + (lean[i] + twist * random()) * x[2];
        }
    }
    let mut cells: Vec<Vec<usize>> = Vec::new();
    for (k, j, i) in (0..32).map(|n| (n / 16, n / 4 % 4, n % 4)) {
        let first = 25 * k + 5 * j + i;
        let [a, b, c, d] = [first, first + 1, first + 6, first + 5];
        match (i + 4 * j) % 5 {
            0 => cells.push(vec![a, b, c, d]),
            n if n % 2 == 0 => cells.extend([vec![a, b, c], vec![a, c, d]]),
            _ => cells.extend([vec![a, b, d], vec![b, c, d]]),
        }
    }
    // A side is linked where all that share it link it.
    let side = |cell: &[usize], s: usize| {
        let [a, b] = [cell[s], cell[(s + 1) % cell.len()]];
        [a.min(b), a.max(b)]
    };
    let hex_of = |cell: &[usize]| {
        let all: Vec<Vector> =
            cell.iter().chain(&cell.iter().map(|n| n + 25).collect::<Vec<_>>()).map(|&n| nodes[n]).collect();
        match cell.len() {
            4 => Hex8::new(core::array::from_fn(|k| all[k])).unwrap(),
            _ => wedge(core::array::from_fn(|k| all[k])),
        }
    };
    let mut hexes: Vec<Hex8> = cells.iter().map(|cell| hex_of(cell)).collect();
    let may: Vec<[bool; 3]> = hexes.iter().map(|hex| hex.linked).collect();
    for (e, cell) in cells.iter().enumerate().filter(|(_, cell)| cell.len() == 3) {
        for s in 0..3 {
            hexes[e].linked[s] = cells.iter().zip(&may).all(|(other, may)| {
                (0..other.len()).all(|t| side(other, t) != side(cell, s) || (other.len() == 3 && may[t]))
            });
        }
    }
    let linked = hexes.iter().flat_map(|hex| hex.linked).filter(|linked| *linked).count();
    if uneven == 0.0 && twist == 0.0 {
        assert!(linked > 60, "{linked}");
    }
    let linear =
        |[x, y, z]: Vector| [2.0 * x - 0.7 * y + 0.4 * z, 0.9 * x + y - 0.2 * z, 0.8 * y - 0.5 * x - z];
    let moduli = Moduli::from_young_poisson(1.0, 0.3);
    let mut residual = vec![[0.0; 3]; nodes.len()];
    for (cell, hex) in cells.iter().zip(&hexes) {
        let (f, _) = pass(kind, moduli, hex, hex.corners.map(linear));
        let place: Vec<usize> = match cell.len() {
            4 => (0..8).map(|k| cell[k % 4] + 25 * (k / 4)).collect(),
            _ => (0..8).map(|k| cell[(k % 4).min(2)] + 25 * (k / 4)).collect(),
        };
        for (n, f) in place.into_iter().zip(f) {
            (0..3).for_each(|i| residual[n][i] += f[i]);
        }
    }
    let inner = |n: &usize| (1..4).contains(&(n % 5)) && (1..4).contains(&(n / 5 % 5)) && n / 25 == 1;
    (0..75).filter(inner).flat_map(|n| residual[n]).fold(0.0, |most: f64, f| most.max(f.abs()))
}

/// Forces of stresses of order 1 on sides of order 1. Only the shear across twisted sides that are linked leaves any, here of the lean of each edge.
#[test]
fn wedges_beside_wedges_hexahedra_and_other_layers_pass_the_patch_test() {
    for seed in 0..12 {
        for kind in KINDS {
            for uneven in [0.0, 0.2] {
                let worst = patch_residual(kind, seed, uneven, 0.0);
                assert!(worst < 1e-13, "{kind:?} {seed}, uneven by {uneven}: {worst:e}");
            }
            let worst = patch_residual(kind, seed, 0.2, 0.3);
            let limit = if kind == Kind::OnePoint { 1e-13 } else { 0.01 };
            eprintln!("{kind:?} {seed} {worst:e}");
            assert!(worst < limit, "{kind:?} {seed}, twisted: {worst:e}");
        }
    }
}

#[test]
fn a_wedge_has_exactly_six_zero_energy_modes_and_a_symmetric_stiffness() {
    for nu in [0.0, 0.25, 0.4999] {
        let moduli = Moduli::from_young_poisson(1.0, nu);
        for seed in 0..10 {
            for nodes in [prism(seed, 0.5), distorted(seed)] {
                let mut hex = wedge(nodes);
                for linked in [[true; 3], [false; 3], hex.linked] {
                    hex.linked = linked;
                    for kind in KINDS {
                        let k = stiffness(kind, moduli, &hex);
                        let size = k.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
                        for i in 0..18 {
                            for j in 0..i {
                                assert!((k[i][j] - k[j][i]).abs() < 1e-14 * size, "{kind:?}");
                            }
                        }
                        let values = eigenvalues(k);
                        assert!(values[5].abs() < 1e-13 * size, "{kind:?} ν = {nu}: {:e}", values[5]);
                        assert!(
                            values[6] > 1e-3,
                            "{kind:?} ν = {nu}: seventh eigenvalue {:e} E m",
                            values[6]
                        );
                    }
                }
            }
        }
    }
}

/// Triangles may begin with any corner, and either may be the first. A prism is the same in all; in other shapes centre and axes of the collapsed
/// hexahedron go by the corner, so that whoever numbers them chooses it by shape.
#[test]
fn a_prism_has_no_first_corner_and_turns_with_its_axes() {
    for seed in 0..10 {
        for thickness in [0.1, 1.0] {
            let nodes = prism(seed, thickness);
            let mut random = random(seed + 7);
            let u: [Vector; 6] = nodes.map(|_| [random(), random(), random()]);
            for kind in KINDS {
                let of = |order: [usize; 6], turn: fn(Vector) -> Vector| {
                    let hex = wedge(order.map(|k| turn(nodes[k])));
                    let moved = order.map(|k| turn(u[k]));
                    let all = forces(kind, &hex, core::array::from_fn(|k| [k as f64, 0.0, 0.0]), |x| {
                        moved[x[0] as usize]
                    });
                    let mut own = [[0.0; 3]; 6];
                    order.into_iter().zip(all).for_each(|(k, f)| own[k] = f);
                    own
                };
                let same: fn(Vector) -> Vector = |x| x;
                let first = of([0, 1, 2, 3, 4, 5], same);
                let size = first.iter().flatten().fold(0.0_f64, |m, f| m.max(f.abs()));
                let near = |found: [Vector; 6], exact: [Vector; 6]| {
                    let pairs = found.iter().flatten().zip(exact.iter().flatten());
                    pairs.fold(0.0_f64, |most, (a, b)| most.max((a - b).abs())) < 1e-13 * size
                };
                assert!(near(of([1, 2, 0, 4, 5, 3], same), first), "{kind:?} {seed}");
                assert!(near(of([2, 0, 1, 5, 3, 4], same), first), "{kind:?} {seed}");
                assert!(near(of([3, 5, 4, 0, 2, 1], same), first), "{kind:?} {seed}");
                assert!(near(of([0, 1, 2, 3, 4, 5], turned), first.map(turned)), "{kind:?} {seed}");
            }
        }
    }
}

#[test]
fn quadratures_agree_on_prisms_that_are_not_linked() {
    let moduli = Moduli::from_young_poisson(1.0, 0.3);
    for seed in 0..10 {
        let mut hex = wedge(prism(seed, 0.6).map(turned));
        hex.linked = [false; 3];
        let [one, full, layered] = KINDS.map(|kind| stiffness(kind, moduli, &hex));
        for ((a, b), c) in one.iter().flatten().zip(full.iter().flatten()).zip(layered.iter().flatten()) {
            assert!((a - b).abs() < 1e-14 && (a - c).abs() < 1e-14, "{seed}: {a}, {b} and {c}");
        }
    }
}
