use super::{Station, forces, middle, place, runs_along_x, stations};
use std::f64::consts::TAU;
use tremolite_laws::shapes::hex8::{Layers, Points, Quadrature};
use tremolite_mesh::boxes::{Axis, BoxSpec};
use tremolite_mesh::split::{Cut, split};
use tremolite_mesh::{Element, Mesh, Shape};

type Stress = [[f64; 3]; 3];

const THICKNESS: f64 = 0.6;

/// A plate between z = 2 and 2.6 in layers, on two layers of rock, below two of a bench: the mesh and the plate.
fn plate(layers: u32) -> (Mesh, Vec<u32>) {
    let within = (0..=layers).map(|k| 2.0 + THICKNESS * f64::from(k) / f64::from(layers));
    let z = [0.0, 1.0].into_iter().chain(within).chain([3.6, 4.6]).collect();
    let spec = BoxSpec { z: Axis::Coordinates(z), ..BoxSpec::uniform([0.0; 3], [8.0, 6.0, 1.0], [4, 3, 1]) };
    (spec.mesh().unwrap(), (24..24 + 12 * layers).collect())
}

/// Everything but the bench.
fn standing(mesh: &Mesh, plate: &[u32]) -> Vec<bool> {
    (0..mesh.elements.len() as u32).map(|e| e <= plate[plate.len() - 1]).collect()
}

fn product(a: &Stress, b: &Stress) -> Stress {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

fn transposed(a: &Stress) -> Stress {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| a[j][i]))
}

/// A rotation about one of the axes.
fn rotation(axis: usize, angle: f64) -> Stress {
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut r = [[0.0; 3]; 3];
    r[axis][axis] = 1.0;
    (r[j][j], r[j][k]) = (angle.cos(), -angle.sin());
    (r[k][j], r[k][k]) = (angle.sin(), angle.cos());
    r
}

fn turned(r: &Stress, x: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| (0..3).map(|k| r[i][k] * x[k]).sum())
}

fn voigt(s: Stress) -> [f64; 6] {
    [s[0][0], s[1][1], s[2][2], s[0][1], s[1][2], s[2][0]]
}

const ONE: Quadrature = Quadrature::OnePoint;
const FULL: Quadrature = Quadrature::Full;
const LAYERED: Quadrature = Quadrature::Layered(Layers::Nine);

type Seen = Vec<(Points, Vec<[f64; 6]>)>;

/// Stresses of every element at its points, of layered ones with the thickness along an axis.
fn seen_along(mesh: &Mesh, quadrature: Quadrature, axis: usize, stress: impl Fn([f64; 3]) -> Stress) -> Seen {
    let points = Points { quadrature, axis };
    let at = |e: u32, p: usize| voigt(stress(place(mesh, e, points.natural(p))));
    let of = |e: u32| (points, (0..points.count()).map(|p| at(e, p)).collect());
    (0..mesh.elements.len() as u32).map(of).collect()
}

fn seen(mesh: &Mesh, quadrature: Quadrature, stress: impl Fn([f64; 3]) -> Stress) -> Seen {
    seen_along(mesh, quadrature, 2, stress)
}

/// Bending, tension and shear along x, linear through the plate, with as much of other components as they please.
fn in_plate(x: [f64; 3]) -> Stress {
    let n = x[2] - 2.3;
    [[2e6 + 5e6 * n, 3e5, -4e5], [3e5, -7e6 * n, 6e5], [-4e5, 6e5, 1e6]]
}

const EXACT: [f64; 3] = [2e6 * THICKNESS, 5e6 * THICKNESS * THICKNESS * THICKNESS / 12.0, -4e5 * THICKNESS];

fn assert_forces(got: [f64; 3], exact: [f64; 3]) {
    for (got, exact) in got.iter().zip(exact) {
        assert!((got - exact).abs() < 1e-9 * EXACT[0], "{got} {exact}");
    }
}

fn all(mesh: &Mesh, stations: &[Station], seen: &Seen) -> Vec<[f64; 3]> {
    let points = |e: u32| seen.get(e as usize).map(|(points, stress)| (*points, stress.as_slice()));
    stations.iter().map(|station| forces(mesh, station, points)).collect()
}

#[test]
fn a_plate_has_the_tension_the_moment_and_the_shear_of_its_stress() {
    for layers in 1..4 {
        let (mesh, plate) = plate(layers);
        let found = stations(&mesh, &plate, &standing(&mesh, &plate));
        assert_eq!(found.len(), 12);
        for station in &found {
            assert!((station.thickness - THICKNESS).abs() < 1e-12 && (station.place[2] - 2.3).abs() < 1e-12);
            assert_eq!((station.normal, station.along), ([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]), "up is free");
            assert!(station.stack.is_sorted() && station.stack.len() == layers as usize);
        }
        // Layers through the thickness, or along another axis of the elements.
        for axis in 0..3 {
            for found in all(&mesh, &found, &seen_along(&mesh, LAYERED, axis, in_plate)) {
                assert_forces(found, EXACT);
            }
        }
        for found in all(&mesh, &found, &seen(&mesh, FULL, in_plate)) {
            assert_forces(found, EXACT);
        }
        // One point an element sees steps: of a single layer no moment at all.
        let share = 1.0 - f64::from(layers * layers).recip();
        for found in all(&mesh, &found, &seen(&mesh, ONE, in_plate)) {
            assert_forces(found, [EXACT[0], share * EXACT[1], EXACT[2]]);
        }
    }
}

#[test]
fn tension_at_the_intrados_is_a_positive_moment_on_either_side() {
    // The rock gone and the bench standing, the intrados is below: the moment and the shear turn round.
    let (mesh, plate) = plate(2);
    let below: Vec<bool> = (0..mesh.elements.len() as u32).map(|e| e >= plate[0]).collect();
    let found = stations(&mesh, &plate, &below);
    assert!(found.iter().all(|s| s.normal == [0.0, 0.0, -1.0] && s.along == [-1.0, 0.0, 0.0]));
    assert!(found.iter().all(|s| s.stack[0].0 > s.stack[1].0), "from extrados to intrados");
    for found in all(&mesh, &found, &seen(&mesh, FULL, in_plate)) {
        assert_forces(found, [EXACT[0], -EXACT[1], EXACT[2]]);
    }
}

#[test]
fn a_slab_alone_has_its_intrados_above() {
    let (mesh, plate) = plate(2);
    for there in [true, false] {
        let found = stations(&mesh, &plate, &vec![there; mesh.elements.len()]);
        assert!(found.len() == 12 && found.iter().all(|s| s.normal == [0.0, 0.0, 1.0]));
    }
}

#[test]
fn rock_with_nodes_of_its_own_is_still_behind_the_extrados() {
    let (mut mesh, plate) = plate(1);
    let there = standing(&mesh, &plate);
    let before = stations(&mesh, &plate, &there);
    let rock: Vec<u32> = (0..plate[0]).collect();
    let times: Vec<_> = there.iter().map(|there| 0..u32::from(*there)).collect();
    split(&mut mesh, &[Cut { name: "lining-rock", sides: [&plate, &rock] }], &times).unwrap();
    let after = stations(&mesh, &plate, &there);
    assert_eq!(format!("{before:?}"), format!("{after:?}"));
}

#[test]
fn a_turned_plate_has_the_same_forces() {
    let (mut mesh, plate) = plate(3);
    let there = standing(&mesh, &plate);
    // Any angle about y, and then a little about the others, so that y remains the caverns' direction.
    for about_y in [0.4, 1.5, 2.9, -2.0, -0.7] {
        let r = product(&rotation(2, 0.3), &product(&rotation(0, -0.2), &rotation(1, about_y)));
        mesh.nodes.iter_mut().for_each(|x| *x = turned(&r, *x));
        let back = transposed(&r);
        let stress = |x| product(&r, &product(&in_plate(turned(&back, x)), &back));
        let found = stations(&mesh, &plate, &there);
        assert_eq!(found.len(), 12);
        for found in all(&mesh, &found, &seen(&mesh, FULL, stress)) {
            assert_forces(found, EXACT);
        }
        mesh.nodes.iter_mut().for_each(|x| *x = turned(&back, *x));
    }
}

const RADII: [f64; 2] = [4.5, 5.1];

/// A ring around an axis along y, with two layers through its wall and two slices.
fn ring(facets: u32) -> Mesh {
    let mut mesh = Mesh::default();
    for y in 0..3 {
        for r in 0..3 {
            let radius = RADII[0] + 0.5 * f64::from(r) * (RADII[1] - RADII[0]);
            for k in 0..facets {
                let (sin, cos) = (TAU * f64::from(k) / f64::from(facets)).sin_cos();
                mesh.nodes.push([20.0 + radius * cos, f64::from(y), radius * sin - 9.0]);
            }
        }
    }
    for y in 0..2 {
        for r in 0..2 {
            for k in 0..facets {
                let node = |k: u32, r: u32, y: u32| k % facets + facets * (r + 3 * y);
                let ring = |y| [node(k, r, y), node(k, r + 1, y), node(k + 1, r + 1, y), node(k + 1, r, y)];
                mesh.elements.push(Element::new(Shape::Hex8, &[ring(y + 1), ring(y)].concat()));
            }
        }
    }
    mesh
}

/// Lamé's stresses of a ring under a pressure from outside: A − B/r² across and A + B/r² around.
fn lame([x, _, z]: [f64; 3]) -> Stress {
    let (x, z) = (x - 20.0, z + 9.0);
    let square = x * x + z * z;
    let [inner, outer] = RADII.map(|r| r * r);
    let a = -3e6 * outer / (outer - inner);
    let b = a * inner;
    let (cos, sin, mean, half) = (x * x / square, z * z / square, a, b / square);
    let both = x * z / square * -2.0 * half;
    [
        [mean - half * (cos - sin), 0.0, both],
        [0.0, 0.3 * 2.0 * a, 0.0],
        [both, 0.0, mean + half * (cos - sin)],
    ]
}

#[test]
fn a_ring_along_x_is_known_from_one_along_y_and_from_a_plate_a_shaft_and_one_between() {
    let along = |turn: &dyn Fn([f64; 3]) -> [f64; 3]| {
        let mut mesh = ring(24);
        mesh.nodes.iter_mut().for_each(|x| *x = turn(*x));
        let all: Vec<u32> = (0..mesh.elements.len() as u32).collect();
        runs_along_x(&stations(&mesh, &all, &vec![true; all.len()]))
    };
    assert!(along(&|[x, y, z]| [-y, x, z]), "along x");
    assert!(!along(&|x| x), "along y");
    assert!(!along(&|[x, y, z]| [x, -z, y]), "a shaft");
    assert!(!along(&|[x, y, z]| [(x - y) / 2f64.sqrt(), (x + y) / 2f64.sqrt(), z]), "between");
    let (mesh, plate) = plate(2);
    assert!(!runs_along_x(&stations(&mesh, &plate, &standing(&mesh, &plate))), "a plate");
}

#[test]
fn a_ring_has_the_thrust_and_the_moment_of_lame_s_stresses() {
    let [inner, outer] = RADII;
    let a = -3e6 * outer * outer / (outer * outer - inner * inner);
    let b = a * inner * inner;
    // ∫ σ_θ dr and ∫ σ_θ (r_m − r) dr, with the intrados at the inner radius.
    let thrust = a * (outer - inner) + b * (1.0 / inner - 1.0 / outer);
    let first = 0.5 * a * (outer * outer - inner * inner) + b * (outer / inner).ln();
    let moment = 0.5 * (inner + outer) * thrust - first;
    assert!((thrust + 3e6 * outer).abs() < 1e-6, "the boiler formula");
    let errors = [40, 80].map(|facets| {
        let mesh = ring(facets);
        let lining: Vec<u32> = (0..mesh.elements.len() as u32).collect();
        // Alone, both ends of each stack are free.
        let found = stations(&mesh, &lining, &vec![true; mesh.elements.len()]);
        assert_eq!(found.len(), 2 * facets as usize);
        let seen = seen(&mesh, FULL, lame);
        let mut worst = [0.0f64; 3];
        for [n, m, q] in all(&mesh, &found, &seen) {
            worst = [
                worst[0].max((n / thrust - 1.0).abs()),
                worst[1].max((m / moment - 1.0).abs()),
                worst[2].max(q.abs()),
            ];
        }
        // By symmetry there is no shear, whatever the facets.
        assert!(worst[2] < 1e-9 * thrust.abs(), "{worst:?}");
        worst
    });
    // The axes are those of a facet's middle, so errors go with the square of its angle: quartered by halving it, but for
    // what two Gauss stations through an element leave of 1/r².
    for error in [0, 1].map(|k| errors.map(|e| e[k])) {
        assert!(error[0] < 0.02 && error[0] / error[1] > 3.5, "{errors:?}");
    }
}

#[test]
fn stations_follow_one_another_from_below_by_greater_x_over_the_crown() {
    let mesh = ring(40);
    let lining: Vec<u32> = (0..mesh.elements.len() as u32).collect();
    let found = stations(&mesh, &lining, &vec![true; mesh.elements.len()]);
    let centre = middle(&mesh, &lining);
    assert!((centre[0] - 20.0).abs() < 1e-9 && (centre[2] + 9.0).abs() < 1e-9);
    for (slice, y) in found.chunks(40).zip([0.5, 1.5]) {
        assert!(slice.iter().all(|s| (s.place[1] - y).abs() < 1e-9));
        for pair in slice.windows(2) {
            let way = [0, 1, 2].map(|i| pair[1].place[i] - pair[0].place[i]);
            assert!(way.iter().zip(pair[0].along).map(|(a, b)| a * b).sum::<f64>() > 0.7, "one step on");
        }
        assert!(slice[0].place[2] < -13.0 && slice[10].place[0] > 24.0 && slice[20].place[2] > -5.0);
        assert!(slice.iter().all(|s| s.normal[2] * (s.place[2] + 9.0) <= 1e-9), "inwards");
    }
}

#[test]
fn the_lining_of_a_generated_cavern_looks_into_its_opening() {
    let mesh = tremolite_mesh::cavern::CavernSpec::yingxiuwan().mesh().unwrap();
    let mut there = vec![true; mesh.elements.len()];
    for cavern in ["powerhouse", "transformer"] {
        mesh.groups[&format!("{cavern}.excavation")].iter().for_each(|&e| there[e as usize] = false);
    }
    for (cavern, x) in [("powerhouse", 0.0), ("transformer", 33.0)] {
        let lining = &mesh.groups[&format!("{cavern}.lining")];
        let excavated = stations(&mesh, lining, &there);
        assert_eq!(excavated.len(), lining.len(), "one layer");
        assert!(excavated.iter().all(|s| s.normal[0] * (s.place[0] - x) <= 1e-9));
        // Before the excavation neither end is free, and the middle of the group decides.
        let before = stations(&mesh, lining, &vec![true; mesh.elements.len()]);
        assert_eq!(format!("{excavated:?}"), format!("{before:?}"));
    }
}
