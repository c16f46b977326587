//! What stands at boundaries through which waves at angles come: level layers of rock, and nothing else.
//!
//! The free field there is that of the layers, so an opening, a lining, an interface or other ground at the boundary would be
//! pushed as if it were not there.

use crate::quantities::MEASURES;
use crate::waves::{LayeredGround, Rock};
use std::collections::HashSet;
use tremolite_case::{self as case, Case, Diagnostic};
use tremolite_engine::column::SIDES;
use tremolite_engine::outer_faces::{OuterFaces, near};
use tremolite_engine::{Body, Interface, Life, Water};
use tremolite_laws::parameter::position;
use tremolite_mesh::topology::vector_areas;
use tremolite_mesh::{Face, Mesh};

/// A model and the boundaries of it that a free field drives.
pub struct Driven<'a> {
    pub case: &'a Case,
    pub mesh: &'a Mesh,
    /// With the elements that are there in the shaking.
    pub bodies: &'a [Body],
    /// In the pores of these.
    pub water: &'a Water,
    pub lives: &'a [Life],
    /// Of the mesh \[m\].
    pub bounds: ([f64; 3], [f64; 3]),
}

/// A plane that is driven.
struct Plane {
    axis: usize,
    end: usize,
    name: &'static str,
}

impl Driven<'_> {
    fn planes(&self) -> Vec<Plane> {
        let dynamic = &self.case.dynamic;
        let mut planes = vec![Plane { axis: 2, end: 0, name: "base" }];
        for axis in 0..2 {
            if dynamic.sides[axis].value == case::Side::FreeField {
                planes.extend([0, 1].map(|end| Plane { axis, end, name: SIDES[axis][end] }));
            }
        }
        if dynamic.top.value == case::Top::Viscous {
            planes.push(Plane { axis: 2, end: 1, name: "top" });
        }
        planes
    }

    fn body_of(&self) -> Vec<Option<usize>> {
        let mut body_of = vec![None; self.mesh.elements.len()];
        for (b, body) in self.bodies.iter().enumerate() {
            body.elements.iter().for_each(|&e| body_of[e as usize] = Some(b));
        }
        body_of
    }

    fn faces(&self) -> OuterFaces {
        let elements: Vec<u32> = self.bodies.iter().flat_map(|body| body.elements.iter().copied()).collect();
        OuterFaces::of(self.mesh, self.bounds, &elements)
    }

    /// Refuses what is not the ground.
    pub fn check(&self, ground: &LayeredGround, interfaces: &[Interface], problems: &mut Vec<Diagnostic>) {
        let (mesh, bounds) = (self.mesh, self.bounds);
        let (body_of, faces) = (self.body_of(), self.faces());
        let rock =
            |b: usize, e: usize| Rock::in_water(&self.bodies[b], e as u32, self.water, self.rayleigh());
        let joints = self.joints(interfaces);
        for plane in self.planes() {
            let level = [bounds.0, bounds.1][plane.end][plane.axis];
            let on_plane = |n: &u32| (mesh.nodes[*n as usize][plane.axis] - level).abs() <= near(bounds);
            let reaches = |e: usize| mesh.elements[e].nodes().iter().filter(|n| on_plane(n)).count() >= 3;
            let foreign = |e: usize| match body_of[e] {
                None => true,
                Some(b) => {
                    let life = self.lives[e];
                    let (stratum, _) = ground.stratum_at(self.middle(e)[2] - bounds.0[2]);
                    life.is_later() || life.gone.is_some() || rock(b, e) != ground.strata()[stratum].rock
                }
            };
            let apart = |e: usize| {
                mesh.elements[e].nodes().iter().any(|n| on_plane(n) && joints.contains(&self.spot(*n)))
            };
            let found: Vec<usize> =
                (0..mesh.elements.len()).filter(|&e| reaches(e) && (foreign(e) || apart(e))).collect();
            if !found.is_empty() {
                problems.push(self.refused(&plane, &found));
            } else if self.area(&faces.planes[plane.axis][plane.end], plane.axis) < 1.0 - 1e-6 {
                problems.push(self.open(&plane));
            }
        }
    }

    /// Where a node is, as whole millionths of the model's size: nodes of both sides of an interface may be one or two.
    fn spot(&self, node: u32) -> [i64; 3] {
        let (low, high) = self.bounds;
        let size = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
        [0, 1, 2].map(|i| ((self.mesh.nodes[node as usize][i] - low[i]) / (1e-6 * size)).round() as i64)
    }

    /// Spots of all interfaces: those that elements of both sides have.
    fn joints(&self, interfaces: &[Interface]) -> HashSet<[i64; 3]> {
        let spots = |elements: &[u32]| -> HashSet<[i64; 3]> {
            let nodes = elements.iter().flat_map(|&e| self.mesh.elements[e as usize].nodes());
            nodes.map(|&n| self.spot(n)).collect()
        };
        let mut joints = HashSet::new();
        for interface in interfaces {
            let [first, second] = interface.sides.each_ref().map(|side| spots(side));
            joints.extend(first.intersection(&second));
        }
        joints
    }

    fn rayleigh(&self) -> tremolite_engine::Rayleigh {
        let rayleigh = &self.case.dynamic.rayleigh;
        tremolite_engine::Rayleigh { mass: rayleigh.mass.value, stiffness: rayleigh.stiffness.value }
    }

    fn middle(&self, element: usize) -> [f64; 3] {
        let nodes = self.mesh.elements[element].nodes();
        let sum = |i: usize| nodes.iter().map(|&n| self.mesh.nodes[n as usize][i]).sum::<f64>();
        [0, 1, 2].map(|i| sum(i) / nodes.len() as f64)
    }

    /// The area of faces over that of the model's bounds across an axis.
    fn area(&self, faces: &[Face], axis: usize) -> f64 {
        let (low, high) = self.bounds;
        let whole: f64 = (0..3).filter(|&i| i != axis).map(|i| high[i] - low[i]).product();
        let area = |&face: &Face| -> f64 {
            vector_areas(self.mesh, &[face]).into_values().map(|a| a[axis].abs()).sum()
        };
        faces.iter().map(area).sum::<f64>() / whole
    }

    fn place(&self, plane: &Plane) -> std::ops::Range<usize> {
        match plane.axis {
            2 if plane.end == 0 => self.case.dynamic.base.span.clone(),
            2 => self.case.dynamic.top.span.clone(),
            axis => self.case.dynamic.sides[axis].span.clone(),
        }
    }

    fn refused(&self, plane: &Plane, found: &[usize]) -> Diagnostic {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for &n in found.iter().flat_map(|&e| self.mesh.elements[e].nodes()) {
            for i in 0..3 {
                low[i] = low[i].min(self.mesh.nodes[n as usize][i]);
                high[i] = high[i].max(self.mesh.nodes[n as usize][i]);
            }
        }
        let axis = ["x", "y", "z"][plane.axis];
        let extent: Vec<String> = (0..3)
            .filter(|&i| i != plane.axis)
            .map(|i| format!("{} from {:.2} m to {:.2} m", ["x", "y", "z"][i], low[i], high[i]))
            .collect();
        let inside = if plane.end == 0 { high[plane.axis] } else { low[plane.axis] };
        Diagnostic::new(
            self.place(plane),
            format!(
                "at the {} stands what is not the level ground of the corners, which waves at an angle come through: an opening, a \
                 lining, an interface or other ground, {}",
                plane.name,
                extent.join(" and ")
            ),
            format!(
                "let it end at {axis} = {inside:.2} m or further inside, so that the ground beyond is whole and stays in all stages"
            ),
        )
    }

    fn open(&self, plane: &Plane) -> Diagnostic {
        Diagnostic::new(
            self.place(plane),
            format!(
                "the {} is not whole up to the model's highest point, and waves at an angle come through level ground: an opening \
                 reaches it, or the surface slopes or is uneven there",
                plane.name
            ),
            "let openings end inside, and the surface be level",
        )
    }

    /// Rock at the boundaries that may yield: the field there is that of elastic layers.
    pub fn warnings(&self) -> Vec<Diagnostic> {
        let (body_of, faces) = (self.body_of(), self.faces());
        let planes = self.planes();
        let yields = |body: &Body| {
            let columns = body.material.info().history;
            MEASURES.iter().any(|measure| position(columns, measure.role).is_some())
        };
        let mut names: Vec<&str> = planes
            .iter()
            .flat_map(|plane| &faces.planes[plane.axis][plane.end])
            .filter_map(|face| Some(&self.bodies[body_of[face.element as usize]?]))
            .filter(|body| yields(body))
            .map(|body| body.name.as_str())
            .collect();
        names.sort_unstable();
        names.dedup();
        if names.is_empty() {
            return Vec::new();
        }
        vec![Diagnostic::new(
            self.place(&planes[0]),
            format!(
                "rock at the boundaries can yield or crack ({}), and waves at an angle push there as in elastic ground",
                names.join(", ")
            ),
            "let a margin along the sides and the base be elastic, or see in the results that nothing yields there",
        )]
    }
}
