use crate::body::Body;
use crate::boundary::Side;
use crate::error::ModelError;
use crate::hexahedra::{centroid, hex};
use crate::model::Model;
use crate::problem::Problem;
use std::collections::{BTreeMap, BTreeSet};
use tremolite_kernels::{Layers, Quadrature, elastic};
use tremolite_laws::Moduli;
use tremolite_laws::shapes::hex8::turned;
use tremolite_mesh::boxes::{Axis, BoxSpec};
use tremolite_mesh::{Element, Mesh};

/// Half the clear width and height of the tube, so long that the way along its floor is clearly shorter than that up its walls.
const HALF: [f64; 2] = [6.0, 12.0];

/// What is modelled of a square tube of 12 m by 24 m in the rock.
#[derive(Clone)]
struct Tube {
    /// Of walls and of slabs \[m\].
    thickness: [f64; 2],
    layers: usize,
    /// Without a crown, and with a slab at half its height.
    open: bool,
    deck: bool,
    /// Ends on planes of symmetry through its axis: the one normal to x, the one normal to z.
    halved: [bool; 2],
    /// Of the slice along its axis.
    sides: Side,
    /// Turned about its axis \[rad\].
    turn: f64,
}

const TUBE: Tube = Tube {
    thickness: [0.5; 2],
    layers: 1,
    open: false,
    deck: false,
    halved: [false; 2],
    sides: Side::Roller,
    turn: 0.0,
};

/// Nodes along x or z: to each side of the plane of symmetry, or to one.
fn nodes(half: f64, thickness: f64, layers: usize, halved: bool) -> Vec<f64> {
    let mut right = vec![0.0, 0.5 * thickness, 0.5 * half];
    right.extend((0..=layers).map(|k| half + thickness * k as f64 / layers as f64));
    right.extend([half + thickness + 2.0, half + thickness + 20.0]);
    if halved {
        return right;
    }
    let left = right.iter().skip(1).rev().map(|x| -x);
    left.chain(right.iter().copied()).collect()
}

impl Tube {
    /// Whether the middle of an element lies in a wall, and whether in a slab.
    fn parts(&self, [x, _, z]: [f64; 3]) -> [bool; 2] {
        let [wall, slab] = self.thickness;
        let inside = x.abs() < HALF[0] + wall && z.abs() < HALF[1] + slab;
        let slabs = z < -HALF[1] || (z > HALF[1] && !self.open) || (self.deck && z.abs() < 0.5 * slab);
        [inside && x.abs() > HALF[0], inside && slabs]
    }

    /// Of each element of the lining, by where its middle lies \[mm\]: the direction, of x, y and z, of its thickness. With another
    /// stride elements, their nodes and their axes have other numbers.
    fn axes(&self, stride: usize) -> Result<BTreeMap<[i64; 3], usize>, ModelError> {
        let [x, z] =
            [0, 1].map(|i| Axis::Coordinates(nodes(HALF[i], self.thickness[i], self.layers, self.halved[i])));
        let spec = BoxSpec { x, z, ..BoxSpec::uniform([0.0; 3], [1.0, 2.0, 1.0], [1, 2, 1]) };
        let straight = spec.mesh().unwrap();
        let mut mesh = renumbered(&straight, stride);
        let places: Vec<[f64; 3]> = (0..mesh.elements.len() as u32).map(|e| centroid(&mesh, e)).collect();
        let (sin, cos) = self.turn.sin_cos();
        for [x, _, z] in &mut mesh.nodes {
            (*x, *z) = (cos * *x - sin * *z, sin * *x + cos * *z);
        }
        let lining: Vec<u32> =
            (0u32..).zip(&places).filter(|(_, at)| self.parts(**at) != [false; 2]).map(|(e, _)| e).collect();
        let held = (0u32..).zip(&mesh.nodes).filter(|(_, at)| self.halved[1] && at[2].abs() < 1e-9);
        let held = held.map(|(n, _)| (n, [false, false, true])).collect();
        let body = Body {
            name: "lining".into(),
            elements: lining.clone(),
            material: elastic(Moduli::from_young_poisson(25e9, 0.17)),
            density: 2500.0,
            quadrature: Quadrature::Layered(Layers::Nine),
            viscosity: 0.0,
        };
        let mut problem = Problem::new(mesh, vec![body]);
        problem.sides = [if self.halved[0] { Side::Roller } else { Side::Free }, self.sides];
        problem.held = held;
        let model = Model::new(problem)?;
        let direction = |e: u32| {
            let d = hex(&model.mesh, e as usize).unwrap().directions
                [model.elements.thickness[e as usize] as usize];
            let d = [cos * d[0] + sin * d[2], d[1], cos * d[2] - sin * d[0]];
            (0..3).find(|&i| d[i].abs() > 0.999).unwrap()
        };
        let place = |e: u32| places[e as usize].map(|x| (1e3 * x).round() as i64);
        Ok(lining.into_iter().map(|e| (place(e), direction(e))).collect())
    }

    /// That walls and slabs have their own thickness and where they meet one of the two, whatever the numbers.
    fn check(&self, name: &str) -> BTreeMap<[i64; 3], usize> {
        let found = self.axes(1).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(!found.is_empty(), "{name}");
        for (place, axis) in &found {
            match self.parts(place.map(|x| 1e-3 * x as f64)) {
                [true, true] => assert_ne!(*axis, 1, "{name}, where they meet at {place:?}"),
                [wall, _] => assert_eq!(*axis, if wall { 0 } else { 2 }, "{name}, {place:?}"),
            }
        }
        for stride in [7, 101, 577] {
            assert_eq!(found, self.axes(stride).unwrap(), "{name}, renumbered");
        }
        found
    }
}

/// The same mesh with nodes and elements in another order, and each element numbered from another of its axes.
fn renumbered(mesh: &Mesh, stride: usize) -> Mesh {
    if stride == 1 {
        return mesh.clone();
    }
    let shuffled = |count: usize| -> Vec<usize> {
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by_key(|i| ((i + 1) * stride * 7919) % 10_007);
        order
    };
    let (nodes, elements) = (shuffled(mesh.nodes.len()), shuffled(mesh.elements.len()));
    let mut number = vec![0; nodes.len()];
    for (new, &old) in nodes.iter().enumerate() {
        number[old] = new as u32;
    }
    let mut other = mesh.clone();
    other.nodes = nodes.iter().map(|&old| mesh.nodes[old]).collect();
    other.elements = (0..elements.len())
        .map(|new| {
            let old = &mesh.elements[elements[new]];
            Element::new(old.shape, &turned((new + stride) % 3).map(|k| number[old.nodes[k] as usize]))
        })
        .collect();
    other
}

/// From a corner the way along the floor is clearly shorter than the way up the wall, and on a plane of symmetry the other way ends at a
/// cut: neither makes it a thickness.
#[test]
fn a_tube_with_a_long_floor_whole_and_halved_has_the_thickness_of_its_walls_and_slabs() {
    for halved in [[false, false], [true, false], [false, true], [true, true]] {
        for layers in [1, 2] {
            for open in [false, true] {
                let tube = Tube { halved, layers, open, ..TUBE };
                tube.check(&format!("halved {halved:?}, {layers} layers, open {open}"));
            }
        }
    }
}

/// A slice of 2 m with free ends is shorter than every way from a corner along walls and slabs.
#[test]
fn corners_of_a_free_slice_have_no_thickness_along_the_tube() {
    for halved in [[false, false], [true, false], [true, true]] {
        Tube { halved, sides: Side::Free, ..TUBE }.check(&format!("halved {halved:?}"));
    }
}

/// The shape of an element decides where walls and slabs meet: that along which it is the shorter, and of equals the vertical.
#[test]
fn where_walls_and_slabs_meet_the_thickness_is_a_matter_of_shape_and_not_of_numbers() {
    for (thickness, expected) in [([0.5, 0.5], 2), ([0.5, 0.6], 0), ([0.6, 0.5], 2)] {
        for deck in [false, true] {
            let tube = Tube { thickness, deck, ..TUBE };
            let found = tube.check(&format!("{thickness:?}, deck {deck}"));
            // Elements of the deck are half as high.
            let corner =
                |at: &[i64; 3]| tube.parts(at.map(|x| 1e-3 * x as f64)) == [true; 2] && at[2].abs() > 1000;
            let meeting = found.iter().filter(|(at, _)| corner(at));
            let axes: BTreeSet<usize> = meeting.map(|(_, axis)| *axis).collect();
            assert_eq!(axes, BTreeSet::from([expected]), "{thickness:?}, deck {deck}");
        }
    }
    // Turned so that both are as near to the vertical as to x, and by angles between.
    for turn in [0.1, 0.25, 0.4].map(|share| share * std::f64::consts::PI) {
        Tube { turn, ..TUBE }.check(&format!("turned by {turn}"));
    }
}
