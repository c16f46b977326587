//! Ground outside free-field sides: slabs one element thick, and columns at their ends.
//!
//! Each face on a free-field side, of an element that is there in any stage, is extruded outwards into an ordinary element with
//! all that its parent has, but with nodes and bodies of its own. What stands one behind the other moves as one, so the slab is
//! the side's section in a field that does not vary along the normal: openings, linings and interfaces that reach the side are in
//! it. The slab's ends are extruded once more into columns whose levels move as one; beside a side that is not free field an end
//! takes that side's condition instead. A slab with its two columns stands alone.
//!
//! The coupling is one-way, column → slab → model: forces by [`PassedOn`](crate::parts::passed_on::PassedOn), dashpots ρc on the
//! difference of mean velocities of the same step ([`crate::phase::Follow`]). Nothing here is in the balance.

use crate::body::Body;
use crate::column::{Column, Layer, SIDES, corner_at, own_body};
use crate::error::ModelError;
use crate::interface::Seam;
use crate::life::{Life, Stage};
use crate::outer_faces::near;
use crate::sheet::{Sheet, corners, faces_on};
use crate::traction::Traction;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use tremolite_mesh::{Face, Mesh};

/// Ground outside a side.
#[derive(Clone, Debug)]
pub struct Slab {
    pub sheet: Sheet,
    /// Of the model's columns, those at its low and at its high end.
    pub columns: [Option<usize>; 2],
}

/// What stands outside the free-field sides of a model.
#[derive(Clone, Debug, Default)]
pub struct Slabs {
    pub slabs: Vec<Slab>,
    pub columns: Vec<Column>,
    /// Of each element of the mesh, the one of the user's that it was made of: itself if it is one.
    pub parents: Vec<u32>,
}

/// What slabs are made of: the user's part of a model, split along its interfaces.
pub struct Inside<'a> {
    pub bounds: ([f64; 3], [f64; 3]),
    pub body_of: &'a [Option<usize>],
    pub lives: &'a [Life],
    /// Whether the sides across x and y are free field.
    pub sides: [bool; 2],
}

impl Inside<'_> {
    fn near(&self) -> f64 {
        near(self.bounds)
    }

    fn level(&self, axis: usize, end: usize) -> f64 {
        [self.bounds.0, self.bounds.1][end][axis]
    }
}

impl Slabs {
    /// Adds the elements outside all free-field sides behind those of a mesh.
    ///
    /// # Errors
    /// If a side has no faces, or the ground at an end of a slab does not reach from the base to its top in every stage.
    pub fn beside(mesh: &mut Mesh, inside: &Inside) -> Result<Slabs, ModelError> {
        let users = mesh.elements.len() as u32;
        let mut all = Slabs { parents: (0..users).collect(), ..Slabs::default() };
        let standing = || (0..users).filter(|&e| inside.body_of[e as usize].is_some());
        for axis in (0..2).filter(|&axis| inside.sides[axis]) {
            for end in 0..2 {
                let faces = faces_on(mesh, standing(), axis, inside.level(axis, end), inside.near());
                let sheet =
                    all.extrude(mesh, faces, axis, end).ok_or(ModelError::NoFaces(SIDES[axis][end]))?;
                let mut slab = Slab { sheet, columns: [None; 2] };
                if inside.sides[1 - axis] {
                    for (other, place) in slab.columns.iter_mut().enumerate() {
                        *place = Some(all.columns.len());
                        let column = all.column(mesh, &slab.sheet, other, inside)?;
                        all.columns.push(column);
                    }
                }
                all.check_whole(mesh, &slab, inside)?;
                all.slabs.push(slab);
            }
        }
        Ok(all)
    }

    fn extrude(&mut self, mesh: &mut Mesh, faces: Vec<Face>, axis: usize, end: usize) -> Option<Sheet> {
        let sheet = Sheet::beside(mesh, faces, axis, end)?;
        self.parents.extend(
            sheet.twins.iter().map(|(face, _)| self.parents[face.element as usize]).collect::<Vec<_>>(),
        );
        Some(sheet)
    }

    /// Refuses a slab without columns that an opening cuts in two in the shaking: what does not hang together with the base has
    /// nothing that leads it. Across interfaces it does.
    fn check_whole(&self, mesh: &Mesh, slab: &Slab, inside: &Inside) -> Result<(), ModelError> {
        if slab.columns != [None; 2] {
            return Ok(());
        }
        let standing = |e: &u32| inside.lives[self.parents[*e as usize] as usize].holds(Stage::Shaking);
        let elements: Vec<u32> = slab.sheet.elements().filter(standing).collect();
        let apart = inside.near();
        let place = |n: u32| mesh.nodes[n as usize].map(|x| (x / apart).round() as i64);
        let mut at: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
        for (k, &e) in elements.iter().enumerate() {
            mesh.elements[e as usize].nodes().iter().for_each(|&n| at.entry(place(n)).or_default().push(k));
        }
        let on_base = |e: u32| {
            let nodes = mesh.elements[e as usize].nodes();
            nodes.iter().any(|&n| (mesh.nodes[n as usize][2] - inside.level(2, 0)).abs() <= apart)
        };
        let mut reached: Vec<bool> = elements.iter().map(|&e| on_base(e)).collect();
        let mut next: Vec<usize> = (0..elements.len()).filter(|&k| reached[k]).collect();
        while let Some(k) = next.pop() {
            for &n in mesh.elements[elements[k] as usize].nodes() {
                for &other in at.get(&place(n)).map_or(&[][..], Vec::as_slice) {
                    if !std::mem::replace(&mut reached[other], true) {
                        next.push(other);
                    }
                }
            }
        }
        if reached.iter().all(|reached| *reached) {
            return Ok(());
        }
        Err(ModelError::FreeField(format!(
            "the ground outside {} is cut in two by an opening, and nothing would lead what hangs above it; let all four sides be \
             free field, whose columns do, move the side away from the opening, or choose sides of another kind",
            SIDES[slab.sheet.axis][slab.sheet.end]
        )))
    }

    /// The column at an end of a slab.
    fn column(
        &mut self,
        mesh: &mut Mesh,
        slab: &Sheet,
        end: usize,
        inside: &Inside,
    ) -> Result<Column, ModelError> {
        let axis = 1 - slab.axis;
        let (side, at) = (SIDES[slab.axis][slab.end], SIDES[axis][end]);
        let faces = faces_on(mesh, slab.elements(), axis, inside.level(axis, end), inside.near());
        let refuse = |reason: String| {
            ModelError::FreeField(format!(
                "the ground along the vertical edge of the model where {side} and {at} meet {reason}, so it is no column of ground \
                 that the sides could have as their free field; let openings keep away from the edge and leave through one side \
                 alone, or write base = \"viscous\" and sides of another kind"
            ))
        };
        let sheet = self
            .extrude(mesh, faces, axis, end)
            .ok_or_else(|| refuse("has no element with a face on both sides of it".into()))?;
        let span = |e: u32| {
            let z = mesh.elements[e as usize].nodes().iter().map(|&n| mesh.nodes[n as usize][2]);
            z.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| [low.min(z), high.max(z)])
        };
        let top = sheet.elements().map(|e| span(e)[1]).fold(f64::NEG_INFINITY, f64::max);
        let bottom = sheet.elements().map(|e| span(e)[0]).fold(f64::INFINITY, f64::min);
        if bottom - inside.level(2, 0) > inside.near() {
            return Err(refuse(format!(
                "ends {:.3} m above the lowest level of the model, which is that of the base",
                bottom - inside.level(2, 0)
            )));
        }
        let life = |e: u32| inside.lives[self.parents[e as usize] as usize];
        // Ground changes where a life begins or ends.
        let mut stages: BTreeSet<Stage> = [Stage::Before(0), Stage::Shaking].into();
        for life in sheet.elements().map(life) {
            stages.insert(life.born);
            stages.extend(life.gone);
        }
        for stage in stages {
            let there = sheet.elements().filter(|&e| life(e).holds(stage)).map(span);
            let filled: f64 = there.map(|[low, high]| high - low).sum();
            if (filled - (top - inside.level(2, 0))).abs() > inside.near() {
                let what = if stage == Stage::Before(0) { "has a gap" } else { "is excavated" };
                return Err(refuse(what.into()));
            }
        }
        let extreme = |sign: f64| {
            let nodes = sheet.twins.iter().flat_map(|&twin| corners(mesh, twin)).map(|corner| corner.front);
            nodes.min_by(|&a, &b| {
                let z = |n: u32| sign * mesh.nodes[n as usize][2];
                z(a).total_cmp(&z(b))
            })
        };
        let (top, bottom) = (extreme(-1.0).unwrap_or(0), extreme(1.0).unwrap_or(0));
        let mut ends = [end; 2];
        ends[slab.axis] = slab.end;
        Ok(Column {
            name: format!("{side}-{at}"),
            corners: vec![corner_at(ends)],
            top,
            bottom,
            layers: Vec::new(),
            bodies: 0..0,
            parted: false,
            rings: Vec::new(),
            sheet: Some(sheet),
        })
    }

    /// Notes which columns interfaces run through.
    pub fn mark_parted(&mut self, seams: &[Seam]) {
        let parted: BTreeSet<u32> =
            seams.iter().flat_map(|s| s.faces.iter().flatten()).map(|f| f.element).collect();
        for column in &mut self.columns {
            let elements = column.sheet.iter().flat_map(Sheet::elements);
            column.parted = elements.into_iter().any(|e| parted.contains(&e));
        }
    }

    /// Every sheet, each slab's before those of its columns.
    pub fn sheets(&self) -> impl Iterator<Item = &Sheet> {
        sheets(&self.slabs, &self.columns)
    }

    /// The elements of a slab and of its columns.
    pub fn standing_alone(&self, slab: &Slab) -> Vec<u32> {
        let columns = slab.columns.iter().flatten().filter_map(|&c| self.columns[c].sheet.as_ref());
        std::iter::once(&slab.sheet).chain(columns).flat_map(Sheet::elements).collect()
    }

    /// Which node was one with each before interfaces parted the mesh, of those outside as well; `origin` has those of the user's.
    pub fn origins(&self, mesh: &Mesh, origin: &mut Vec<u32>) {
        origin.resize(mesh.nodes.len(), u32::MAX);
        for sheet in self.sheets() {
            let mut firsts: BTreeMap<u32, [u32; 2]> = BTreeMap::new();
            for corner in sheet.twins.iter().flat_map(|&twin| corners(mesh, twin)) {
                let own = [corner.front, corner.back];
                let first = *firsts.entry(origin[corner.source as usize]).or_insert(own);
                own.iter().zip(first).for_each(|(&node, first)| origin[node as usize] = first);
            }
        }
    }

    /// Bodies of the slabs, then those of the columns at their ends, with their layers.
    pub fn fill(
        &mut self,
        mesh: &Mesh,
        bodies: &mut Vec<Body>,
        body_of: &[Option<usize>],
        lives: &[Life],
    ) -> usize {
        let parents = &self.parents;
        let of = |e: u32| body_of[parents[e as usize] as usize];
        let first = bodies.len();
        for slab in &self.slabs {
            for e in slab.sheet.elements() {
                if let Some(like) = of(e) {
                    let body = own_body(bodies, first, like, "free field");
                    bodies[body].elements.push(e);
                }
            }
        }
        let slabs = bodies.len();
        for column in &mut self.columns {
            let Some(sheet) = &column.sheet else { continue };
            let first = bodies.len();
            for e in sheet.elements() {
                let Some(like) = of(e) else { continue };
                let body = own_body(bodies, first, like, &format!("column {}", column.name));
                bodies[body].elements.push(e);
                if lives[e as usize].holds(Stage::Shaking) {
                    let z = || mesh.elements[e as usize].nodes().iter().map(|&n| mesh.nodes[n as usize][2]);
                    let (bottom, top) =
                        (z().fold(f64::INFINITY, f64::min), z().fold(f64::NEG_INFINITY, f64::max));
                    column.layers.push(Layer { bottom, top, body, element: e });
                }
            }
            column.layers.sort_by(|a, b| a.bottom.total_cmp(&b.bottom));
            column.bodies = first..bodies.len();
        }
        slabs
    }

    /// What each list says of an element of the user's said of those made of it.
    pub fn spread<T: Copy>(&self, list: &mut Vec<T>) {
        if !list.is_empty() {
            let more: Vec<T> = self.parents[list.len()..].iter().map(|&e| list[e as usize]).collect();
            list.extend(more);
        }
    }

    /// Pairs of elements, said of those of the user's, said of those that stand outside as well.
    pub fn spread_pairs(&self, pairs: &mut HashMap<u32, u32>) {
        for sheet in self.sheets() {
            let twins: BTreeMap<Face, u32> = sheet.twins.iter().copied().collect();
            let own: Vec<(u32, u32)> = sheet
                .twins
                .iter()
                .filter_map(|&(face, later)| {
                    let element = *pairs.get(&face.element)?;
                    Some((later, *twins.get(&Face { element, ..face })?))
                })
                .collect();
            pairs.extend(own);
        }
    }

    /// Tractions on faces that meet a side act on the elements outside it as well.
    pub fn press(&self, mesh: &Mesh, tractions: &mut [Traction]) {
        for sheet in self.sheets() {
            let twins: BTreeMap<u32, (Face, u32)> =
                sheet.twins.iter().map(|&(face, twin)| (face.element, (face, twin))).collect();
            for traction in &mut *tractions {
                let beside = |&(face, stress): &(Face, [f64; 6])| {
                    let &twin = twins.get(&face.element)?;
                    Some((face_beside(mesh, face, twin)?, stress))
                };
                let more: Vec<_> = traction.faces.iter().filter_map(beside).collect();
                traction.faces.extend(more);
            }
        }
    }
}

/// Every sheet, each slab's before those of its columns.
pub fn sheets<'a>(slabs: &'a [Slab], columns: &'a [Column]) -> impl Iterator<Item = &'a Sheet> {
    slabs.iter().flat_map(move |slab| {
        let columns = slab.columns.iter().flatten().filter_map(|&c| columns[c].sheet.as_ref());
        std::iter::once(&slab.sheet).chain(columns)
    })
}

/// The face of an extruded element that goes on where a face of its parent meets the plane, if that has an edge there.
fn face_beside(mesh: &Mesh, face: Face, twin: (Face, u32)) -> Option<Face> {
    if face == twin.0 {
        return None;
    }
    let of_face: Vec<u32> = mesh.face_nodes(face).collect();
    let edge: Vec<u32> = corners(mesh, twin)
        .filter(|corner| of_face.contains(&corner.source))
        .flat_map(|corner| [corner.front, corner.back])
        .collect();
    if edge.len() != 4 {
        return None;
    }
    let sides = mesh.elements[twin.1 as usize].shape.faces().len() as u8;
    let mut all = (0..sides).map(|side| Face { element: twin.1, side });
    all.find(|&side| mesh.face_nodes(side).count() == 4 && mesh.face_nodes(side).all(|n| edge.contains(&n)))
}
