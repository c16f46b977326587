use std::collections::BTreeSet;

use super::blocks::{block, shaped};
use super::made;
use crate::cavern::{CavernError, CavernShape, CavernSpec, GroundSurface, Lining, RockLayer};
use crate::mesh::Mesh;
use crate::quality;

fn site() -> CavernSpec {
    block(1.5, vec![shaped(CavernShape::Arch, [10.0, 12.0, 3.0], 2, Lining::NONE)])
}

fn layer(name: &str, depth: f64, dip: f64) -> RockLayer {
    RockLayer { name: name.to_owned(), depth, dip, dip_direction: 0.0 }
}

fn middle(mesh: &Mesh, e: u32) -> [f64; 3] {
    let nodes = mesh.elements[e as usize].nodes();
    std::array::from_fn(|c| nodes.iter().map(|&n| mesh.nodes[n as usize][c]).sum::<f64>() / 8.0)
}

#[test]
fn layers_divide_the_rock_and_level_ones_are_cut_exactly() {
    let layers = vec![layer("soil", 0.0, 0.0), layer("weathered", 11.3, 0.0), layer("sound", 105.7, 0.0)];
    let spec = CavernSpec { layers, ..site() };
    let mesh = made("layers", &spec);
    let parts = ["rock.soil", "rock.weathered", "rock.sound"].map(|g| &mesh.groups[g]);
    let mut all: Vec<u32> = parts.iter().flat_map(|p| p.iter().copied()).collect();
    all.sort_unstable();
    assert_eq!(&all, &mesh.groups["rock"]);
    let groups = quality::by_group(&mesh);
    let area = (spec.length) * (10.0 + 2.0 * spec.sides);
    assert!((groups["rock.soil"].volume / (11.3 * area) - 1.0).abs() < 1e-12);
    let depth = spec.overburden + 12.0 + spec.below;
    assert!((groups["rock.sound"].volume / ((depth - 105.7) * area) - 1.0).abs() < 1e-12);
}

#[test]
fn dipping_layers_take_elements_by_their_middles() {
    let dip = 25f64.to_radians();
    let across = RockLayer { dip_direction: std::f64::consts::FRAC_PI_2, ..layer("b", 40.0, dip) };
    for second in [layer("b", 40.0, dip), across] {
        let towards = second.dip_direction.sin_cos();
        let spec = CavernSpec { layers: vec![layer("a", 0.0, 0.0), second], ..site() };
        let mesh = made("dip", &spec);
        for (group, below) in [("rock.a", false), ("rock.b", true)] {
            assert!(!mesh.groups[group].is_empty());
            for &e in &mesh.groups[group] {
                let [x, y, z] = middle(&mesh, e);
                assert_eq!(z < -40.0 - dip.tan() * (x * towards.1 + y * towards.0), below);
            }
        }
    }
}

#[test]
fn the_rock_above_the_caverns_follows_the_ground_and_nothing_else_moves() {
    let level = made("level", &site());
    let table = GroundSurface::Table {
        x: vec![-40.0, 0.0, 30.0],
        y: vec![-3.0, 3.0],
        heights: vec![20.0, 0.0, -8.0, 24.0, 1.0, -10.0],
    };
    for ground in [GroundSurface::Inclined { x: 0.2, y: -0.1 }, table] {
        let mesh = made("ground", &CavernSpec { ground: ground.clone(), ..site() });
        assert!(!mesh.faces["top"].is_empty());
        for n in mesh.faces["top"].iter().flat_map(|&f| mesh.face_nodes(f)) {
            let [x, y, z] = mesh.nodes[n as usize];
            assert!((z - ground.height(x, y)).abs() < 1e-9, "{x} {y} {z}");
        }
        // From the crown down all is where it is under level ground.
        let low = |mesh: &Mesh| -> BTreeSet<[u64; 3]> {
            mesh.nodes.iter().filter(|x| x[2] < -60.0).map(|x| x.map(f64::to_bits)).collect()
        };
        assert!(low(&mesh) == low(&level));
        let highest = mesh.nodes.iter().map(|x| x[2]).fold(0.0, f64::max);
        // `far` is 7 m; the steepest ground rises by 0.6 m per m.
        assert!(highest > 10.0 && quality::summary(&mesh).longest_edge < 7.0 * 1.0_f64.hypot(0.6));
        assert!(quality::summary(&mesh).min_scaled_jacobian > 0.3);
    }
    let plane = GroundSurface::Inclined { x: 0.2, y: -0.1 };
    assert_eq!(plane.height(10.0, 5.0), 1.5);
}

#[test]
fn a_table_of_heights_is_linear_between_its_places_and_constant_beyond() {
    let ground =
        GroundSurface::Table { x: vec![0.0, 10.0], y: vec![0.0, 4.0], heights: vec![0.0, 5.0, 8.0, 1.0] };
    for (at, height) in [
        ([5.0, 0.0], 2.5),
        ([0.0, 2.0], 4.0),
        ([5.0, 2.0], 3.5),
        ([-7.0, -7.0], 0.0),
        ([99.0, 99.0], 1.0),
        ([10.0, 1.0], 4.0),
    ] {
        assert!((ground.height(at[0], at[1]) - height).abs() < 1e-12, "{at:?}");
    }
    let line = GroundSurface::Table { x: vec![0.0, 2.0], y: vec![7.0], heights: vec![1.0, 3.0] };
    assert_eq!(line.height(1.0, -50.0), 2.0);
}

#[test]
fn impossible_ground_and_layers_are_refused_with_the_key() {
    let with = |ground: GroundSurface| CavernSpec { ground, ..site() }.mesh().unwrap_err();
    let table = |x: Vec<f64>, y: Vec<f64>, heights: Vec<f64>| with(GroundSurface::Table { x, y, heights });
    assert!(matches!(with(GroundSurface::Inclined { x: -1.5, y: 0.0 }), CavernError::LowGround { .. }));
    for (error, says) in [
        (with(GroundSurface::Inclined { x: f64::NAN, y: 0.0 }), "ground.x is NaN"),
        (table(vec![], vec![0.0], vec![]), "ground.x is 0"),
        (table(vec![0.0, 0.0], vec![0.0], vec![1.0, 1.0]), "above the place before"),
        (table(vec![0.0, 1.0], vec![0.0], vec![1.0]), "a list of 2 heights"),
        (table(vec![0.0], vec![0.0], vec![f64::INFINITY]), "ground.heights is inf"),
        (table(vec![0.0, 0.2], vec![0.0], vec![0.0, 900.0]), "smooth the table"),
    ] {
        assert!(error.to_string().contains(says), "{says:?} not in {error}");
    }
    for (layers, says) in [
        (vec![layer("a", 1.0, 0.0)], "layer a.depth is 1"),
        (vec![layer("a", 0.0, 0.1)], "layer a.dip is 0.1"),
        (vec![layer("a", 0.0, 0.0), layer("b", 0.0, 0.0)], "layer b.depth is 0"),
        (vec![layer("a", 0.0, 0.0), layer("b", 5.0, 1.5)], "from 0 to 80 degrees"),
        (vec![layer("a", 0.0, 0.0), layer("a", 5.0, 0.0)], "the name is used twice"),
        (vec![layer("a.b", 0.0, 0.0)], "a name is a word"),
        (
            vec![layer("a", 0.0, 0.0), layer("rock", 5.0, 0.0)],
            "layer \"rock\": its group would be \"rock.rock\"; choose",
        ),
    ] {
        let error = CavernSpec { layers, ..site() }.mesh().unwrap_err();
        assert!(error.to_string().contains(says), "{says:?} not in {error}");
    }
}

#[test]
fn shapes_that_cannot_be_meshed_are_refused_with_the_reason() {
    let lining = |floor: f64| Lining { walls: 0.4, crown: 0.4, floor, layers: 1 };
    for (shape, size, lining, says) in [
        (CavernShape::Circle, [9.0, 8.0, 0.0], lining(0.4), "t.height is 8; it must be the width"),
        (CavernShape::Circle, [9.0, 9.0, 0.0], lining(0.0), "t.lining.floor is 0"),
        (CavernShape::Horseshoe, [9.0, 6.0, 0.0], lining(0.4), "from 6.75 m to 9.9"),
        (CavernShape::Ellipse, [9.0, 20.0, 9.5], lining(0.0), "at most the width"),
        (CavernShape::Ellipse, [9.0, 20.0, 0.5], lining(0.0), "at least 1.35"),
        // The corner's diagonal is too skew.
        (
            CavernShape::Rectangle,
            [9.0, 9.0, 0.0],
            Lining { walls: 0.3, crown: 0.9, floor: 0.0, layers: 1 },
            "below 0.6",
        ),
    ] {
        let error = block(1.0, vec![shaped(shape, size, 1, lining)]).mesh().unwrap_err();
        assert!(error.to_string().contains(says), "{says:?} not in {error}");
    }
}
