//! Boundaries: what holds the outer faces, what absorbs there, what ties them, what enters.
//!
//! A boundary is a variant of [`Side`] or [`Base`] and what it does with its faces: components held, ties and dashpots
//! are filled in here; one that pushes with more is a part in a file below this one, made in [`members`].

mod asked;
mod at_points;
pub mod base;
pub mod bed;
mod face_shares;
mod far_field;
pub mod matrix;
mod nodes;
mod ties;

pub use asked::{Base, Boundaries, Side, Top};
pub use nodes::{Members, members};
pub use ties::{tie_outside, tie_periodic};

use crate::body::Body;
use crate::column::{Layer, SIDES, WIDTH};
use crate::error::ModelError;
use crate::free_field::Leader;
use crate::life::Stage;
use crate::model::{Elements, Outside};
use crate::outer_faces::{OuterFaces, near, nodes_of};
use crate::sheet::{Corner, Sheet, corners, faces_on};
use crate::water::Water;
use matrix::add;
use std::collections::BTreeMap;
use tremolite_mesh::topology::vector_areas;
use tremolite_mesh::{Face, Mesh};

/// What boundaries are made from: a checked model, as far as they need it.
#[derive(Clone, Copy)]
pub struct Surroundings<'a> {
    pub mesh: &'a Mesh,
    pub user_elements: usize,
    pub bodies: &'a [Body],
    pub elements: &'a Elements,
    pub engine_node: &'a [u32],
    /// The level of each engine node.
    pub level: &'a [u8],
    /// Of a stage.
    pub faces: &'a OuterFaces,
    /// Node of the mesh → one for all that interfaces part at its place.
    pub places: &'a [u32],
    /// What they are asked to do.
    pub asked: &'a Boundaries,
    /// What stands outside the sides.
    pub outside: &'a Outside,
    /// In the pores of all that.
    pub water: &'a Water,
}

impl Surroundings<'_> {
    fn engine(&self, node: u32) -> u32 {
        self.engine_node[node as usize]
    }

    /// The body behind a face. Every face belongs to an element of a body.
    fn body(&self, face: Face) -> Option<&Body> {
        let of = self.elements.parents[face.element as usize] as usize;
        self.elements.body_of[of].map(|b| &self.bodies[b])
    }

    /// ρc_p and ρc_s behind a face.
    fn impedance(&self, face: Face) -> (f64, f64) {
        self.body(face).map_or((0.0, 0.0), |body| self.impedances(body, face.element))
    }

    /// ρc_p and ρc_s of an element of a body, with what water that cannot leave its pores does to c_p.
    fn impedances(&self, body: &Body, element: u32) -> (f64, f64) {
        let moduli = self.water.stiffened(element as usize, body.material.moduli());
        let (p, s) = moduli.wave_speeds(body.density);
        (body.density * p, body.density * s)
    }

    /// Of the element behind a face, [what its stress lacks](crate::free_field::End::lacking).
    fn lacking(&self, face: Face) -> [f64; 2] {
        let Some(body) = self.body(face) else { return [0.0; 2] };
        let own = body.material.moduli();
        face_shares::lacking(own, self.water.stiffened(face.element as usize, own))
    }

    /// Dashpots of a quarter of a reference column's section in a layer.
    fn quarter(&self, layer: &Layer) -> [f64; 6] {
        let (p, s) = self.impedances(&self.bodies[layer.body], layer.element);
        let quarter = 0.25 * WIDTH * WIDTH;
        [s * quarter, s * quarter, p * quarter, 0.0, 0.0, 0.0]
    }

    /// Faces of a sheet on an outer plane that are there in a stage.
    fn of_sheet(&self, sheet: &Sheet, axis: usize, end: usize, stage: Stage) -> Vec<Face> {
        let level = [self.faces.bounds.0, self.faces.bounds.1][end][axis];
        let elements = sheet.elements().filter(|&e| self.elements.stands(e as usize, stage));
        faces_on(self.mesh, elements, axis, level, near(self.faces.bounds))
    }

    /// Faces on an outer plane, in a stage, of what stands outside the sides: of the slabs' ends, or of the bottoms and tops of
    /// slabs and columns. Before the shaking a slab rests on the rollers of its own side as well, as the model does there.
    fn outside(&self, axis: usize, end: usize, stage: Stage) -> Vec<Face> {
        let of = |sheet: &Sheet| self.of_sheet(sheet, axis, end, stage);
        if axis == 2 {
            return self.outside.sheets().flat_map(of).collect();
        }
        self.outside
            .slabs
            .iter()
            .map(|slab| &slab.sheet)
            .filter(|sheet| sheet.axis != axis || stage != Stage::Shaking)
            .flat_map(of)
            .collect()
    }

    /// Corners of all sheets that are there in a stage.
    fn corners(&self, stage: Stage) -> impl Iterator<Item = (Face, Corner)> + '_ {
        let there = move |twin: &(Face, u32)| self.elements.stands(twin.1 as usize, stage);
        let all = self.outside.sheets().flat_map(|sheet| sheet.twins.iter().copied());
        all.filter(there).flat_map(|twin| corners(self.mesh, twin).map(move |corner| (twin.0, corner)))
    }
}

/// What holds and absorbs in a stage, on engine nodes.
#[derive(Clone, Debug, Default)]
pub struct Supports {
    /// Components of a node that are held.
    pub held: BTreeMap<u32, [bool; 3]>,
    /// Dashpots of absorbing sides and of an absorbing top \[N s/m\].
    pub dashpots: BTreeMap<u32, [f64; 6]>,
    /// Dashpots between a node of a free-field side and the node of the slab outside it, or between that of a slab's end and that
    /// of the column, or between a node and a given free field: (node, leader).
    pub following: BTreeMap<(u32, Leader), [f64; 6]>,
}

impl Supports {
    /// Puts a dashpot between a node and a leader.
    pub fn follow(&mut self, node: u32, leader: Leader, matrix: &[f64; 6]) {
        add(self.following.entry((node, leader)).or_default(), matrix);
    }
}

/// Σ A (tangential I + (normal − tangential) n⊗n) by node, over faces with the two factors of each.
fn nodal_matrices(
    mesh: &Mesh,
    faces: &[Face],
    factors: impl Fn(Face) -> (f64, f64),
) -> BTreeMap<u32, [f64; 6]> {
    let mut matrices: BTreeMap<u32, [f64; 6]> = BTreeMap::new();
    for &face in faces {
        let (normal, tangential) = factors(face);
        for (node, a) in vector_areas(mesh, &[face]) {
            let area = (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).sqrt();
            if area == 0.0 {
                continue;
            }
            let n = a.map(|x| x / area);
            let matrix = matrices.entry(node).or_default();
            let pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)];
            for (m, (i, j)) in matrix.iter_mut().zip(pairs) {
                let identity = if i == j { tangential } else { 0.0 };
                *m += area * (identity + (normal - tangential) * n[i] * n[j]);
            }
        }
    }
    matrices
}

/// What holds and absorbs in a stage. Before the shaking the base, the column's too, and sides that are neither periodic nor
/// fixed are held as [`Bed`](bed::Bed) says.
///
/// # Errors
/// If a plane on which something should act has no faces.
pub fn supports(around: Surroundings, stage: Stage) -> Result<Supports, ModelError> {
    let Surroundings { mesh, faces, .. } = around;
    let mut out = Supports::default();
    let engine = |n: u32| around.engine(n);
    for &(node, held) in &around.asked.held {
        if let Some(&e) = around.engine_node.get(node as usize).filter(|&&e| e != u32::MAX) {
            hold(&mut out.held, e, held);
        }
    }
    for axis in 0..2 {
        let side = match (stage, around.asked.sides[axis]) {
            (Stage::Shaking, side) => side,
            (Stage::Before(_), side) => match side.before() {
                Side::Roller if !around.asked.bed.rollers[axis] => Side::Free,
                before => before,
            },
        };
        for (end, faces) in faces.planes[axis].iter().enumerate() {
            if side != Side::Free && faces.is_empty() {
                return Err(ModelError::NoFaces(SIDES[axis][end]));
            }
            let faces = &[faces.clone(), around.outside(axis, end, stage)].concat();
            let mut along = [false; 3];
            along[axis] = true;
            match side {
                Side::Free | Side::Periodic | Side::FreeField => {}
                Side::Fixed => {
                    for n in nodes_of(mesh, faces) {
                        hold(&mut out.held, engine(n), [true; 3]);
                    }
                }
                Side::Roller => {
                    for n in nodes_of(mesh, faces) {
                        hold(&mut out.held, engine(n), along);
                    }
                }
                Side::Viscous => {
                    for (n, matrix) in nodal_matrices(mesh, faces, |face| around.impedance(face)) {
                        add(out.dashpots.entry(engine(n)).or_default(), &matrix);
                    }
                }
            }
        }
    }
    let base = &faces.planes[2][0];
    let footing = match (stage, around.asked.base) {
        (Stage::Before(_), _) => around.asked.bed.base.held(),
        (Stage::Shaking, base) => (base == Base::Fixed).then_some([true; 3]),
    };
    if let Some(footing) = footing {
        if base.is_empty() {
            return Err(ModelError::NoFaces("base"));
        }
        let outside = around.outside(2, 0, stage);
        let below = around.outside.columns.iter().flat_map(|column| column.rings.first()).flatten();
        for n in nodes_of(mesh, base).into_iter().chain(nodes_of(mesh, &outside)).chain(below.copied()) {
            hold(&mut out.held, engine(n), footing);
        }
    }
    if stage == Stage::Shaking {
        if around.asked.top == Top::Viscous {
            check_top(around)?;
            // A given free field drives the top, with dashpots that follow it.
            if around.asked.free_field.is_none() {
                absorb_at_the_top(around, &mut out);
            }
        }
        for (face, corner) in around.corners(stage) {
            let matrices = nodal_matrices(mesh, &[face], |face| around.impedance(face));
            if let Some(matrix) = matrices.get(&corner.source) {
                out.follow(engine(corner.source), Leader::Node(engine(corner.front)), matrix);
            }
        }
    }
    Ok(out)
}

/// Refuses a top that absorbs and is not level.
fn check_top(around: Surroundings) -> Result<(), ModelError> {
    let Surroundings { mesh, faces, .. } = around;
    let [base, top] = &faces.planes[2];
    let area = |faces: &[Face]| -> f64 {
        faces.iter().flat_map(|&face| vector_areas(mesh, &[face])).map(|(_, a)| a[2].abs()).sum()
    };
    if (area(top) - area(base)).abs() > 1e-6 * area(base) {
        return Err(ModelError::Top { level: faces.bounds.1[2], share: area(top) / area(base) });
    }
    Ok(())
}

/// Dashpots of the top, and of what stands outside.
fn absorb_at_the_top(around: Surroundings, out: &mut Supports) {
    let Surroundings { mesh, faces, .. } = around;
    let [_, top] = &faces.planes[2];
    let all = [top.clone(), around.outside(2, 1, Stage::Shaking)].concat();
    for (n, matrix) in nodal_matrices(mesh, &all, |face| around.impedance(face)) {
        add(out.dashpots.entry(around.engine(n)).or_default(), &matrix);
    }
    for column in &around.outside.columns {
        let (Some(ring), Some(layer)) = (column.rings.last(), column.layers.last()) else { continue };
        for &n in ring {
            add(out.dashpots.entry(around.engine(n)).or_default(), &around.quarter(layer));
        }
    }
}

fn hold(held: &mut BTreeMap<u32, [bool; 3]>, node: u32, more: [bool; 3]) {
    let now = held.entry(node).or_default();
    for i in 0..3 {
        now[i] |= more[i];
    }
}
