//! From what a file says to a sound mesh: numbers to indices, orientation, unused nodes, named faces.
//! Shared by the readers of all formats.

mod degenerate;
mod facets;
mod numbering;
mod soundness;

use std::collections::BTreeMap;

use crate::coincident::{coincident_nodes, shortest_edge};
use crate::fault::Fault;
use crate::note::Note;
use crate::{Element, Mesh, Shape};

pub(crate) use facets::{Facet, Stray};
pub(crate) use numbering::{Numbering, kept};
pub(crate) use soundness::{drop_unused_nodes, mirror};

/// Group of the elements that a file puts into none.
const UNGROUPED: &str = "ungrouped";
/// Nodes closer than this share of the mesh's shortest edge are told to the user: far above what rounding
/// in a file does, far below what a mesh resolves.
const COINCIDENT: f64 = 1e-3;

/// What a reader gathers, and [`Draft::finish`] makes a mesh of.
#[derive(Default)]
pub(crate) struct Draft {
    /// Nodes and elements with their numbers, groups and points; faces by the sides of the elements as the file
    /// has them.
    pub mesh: Mesh,
    pub facets: Vec<Facet>,
    /// The lists of names that facets refer to.
    pub names: Vec<Vec<String>>,
    pub stray: Stray,
    pub notes: Vec<Note>,
    /// Elements of higher order, by their number of nodes and the shape of their corners.
    reduced: BTreeMap<(usize, Shape), usize>,
    /// Elements that are no solids, by kind.
    skipped: BTreeMap<String, usize>,
}

impl Draft {
    /// One of a mesh whose indices are good.
    pub(crate) fn of(mesh: Mesh) -> Self {
        Draft { mesh, ..Draft::default() }
    }

    /// Counts an element of `nodes` nodes, of which only the corners are kept.
    pub(crate) fn reduce(&mut self, nodes: usize, shape: Shape) {
        if nodes != shape.nodes() {
            *self.reduced.entry((nodes, shape)).or_default() += 1;
        }
    }

    /// Counts elements that are passed over.
    pub(crate) fn skip(&mut self, kind: &str, count: usize) {
        match self.skipped.get_mut(kind) {
            Some(skipped) => *skipped += count,
            None if count > 0 => drop(self.skipped.insert(kind.to_owned(), count)),
            None => {}
        }
    }

    /// Adds an element, given the indices of its corners.
    pub(crate) fn push(&mut self, number: u64, shape: Shape, corners: &[u32]) {
        self.mesh.element_ids.push(number);
        self.mesh.elements.push(Element::new(shape, corners));
    }

    /// Adds an element, given the numbers of its corners; [`Draft::resolve`] puts indices in their place, so that
    /// elements need not be held twice.
    ///
    /// # Errors
    /// A number that 32 bits do not hold, in words.
    pub(crate) fn push_numbered(&mut self, number: u64, shape: Shape, corners: &[u64]) -> Result<(), String> {
        self.mesh.element_ids.push(number);
        self.mesh.elements.push(numbered(shape, corners)?);
        Ok(())
    }

    /// Puts indices in the place of the node numbers of the elements from `from` on.
    ///
    /// # Errors
    /// The first element that uses a node that is not there (its index), and that node's number.
    pub(crate) fn resolve(&mut self, from: usize, nodes: &Numbering) -> Result<(), (usize, u64)> {
        for (index, element) in self.mesh.elements.iter_mut().enumerate().skip(from) {
            for node in &mut element.nodes {
                let number = u64::from(*node);
                *node = nodes.index(number).ok_or((index, number))?;
            }
        }
        Ok(())
    }

    /// Puts indices in the place of all node numbers.
    ///
    /// # Errors
    /// If two nodes have the same number, or an element uses a node that is not there.
    pub(crate) fn connect(&mut self) -> Result<(), Fault> {
        let nodes = Numbering::new(&self.mesh.node_ids)
            .map_err(|number| Fault::whole(format!("there are two nodes {number}; renumber them")))?;
        self.resolve(0, &nodes).map_err(|(e, node)| {
            let element = self.mesh.element_ids[e];
            let problem = format!("element {element} uses node {node}, which is not there");
            Fault::whole(format!("{problem}; write the whole mesh again"))
        })
    }

    /// Makes a group of the elements of each number, by its name, else `kind` and the number. Where two numbers have the
    /// same name, the number stands behind it.
    pub(crate) fn group_by_number(&mut self, of: &[u64], names: &BTreeMap<u64, String>, kind: &str) {
        let mut lists: BTreeMap<u64, Vec<u32>> = BTreeMap::new();
        for (element, &number) in (0..).zip(of) {
            lists.entry(number).or_default().push(element);
        }
        for (&number, list) in &lists {
            let plain = format!("{kind} {number}");
            self.add_group(names.get(&number).unwrap_or(&plain), number, list);
        }
    }

    /// Adds a group, whose number stands behind its name if there is one of that name.
    pub(crate) fn add_group(&mut self, name: &str, number: u64, list: &[u32]) {
        let mut name = name.to_owned();
        while self.mesh.groups.contains_key(&name) {
            name = format!("{name} {number}");
        }
        self.mesh.groups.insert(name, list.to_vec());
    }

    /// The mesh, and what was done to get it.
    ///
    /// # Errors
    /// If there are no solid elements (with `remedy`), if two have the same number, if one is flat or inside out,
    /// or if a named surface lies on no solid.
    pub(crate) fn finish(self, remedy: &str) -> Result<(Mesh, Vec<Note>), Fault> {
        let Draft { mut mesh, facets, names, stray, mut notes, reduced, mut skipped } = self;
        if mesh.elements.is_empty() {
            return Err(Fault::whole(format!("there are no solid elements; {remedy}")));
        }
        // The second pyramids of split hexahedra at most double the elements.
        if mesh.nodes.len() >= u32::MAX as usize || mesh.elements.len() >= u32::MAX as usize / 2 {
            return Err(Fault::whole("there are more nodes or elements than 32 bits can number"));
        }
        if let Err(number) = Numbering::new(&mesh.element_ids) {
            return Err(Fault::whole(format!(
                "there are two solid elements {number}; renumber the elements"
            )));
        }
        mesh.node_ids = kept(mesh.node_ids);
        mesh.element_ids = kept(mesh.element_ids);
        group_all(&mut mesh);
        notes.extend(reduced.into_iter().map(|((nodes, shape), count)| Note::Reduced {
            nodes,
            shape,
            count,
        }));
        let mut changed = soundness::collapse_degenerate(&mut mesh, &mut notes);
        soundness::orient(&mut mesh, &mut notes, &mut changed)?;
        soundness::renumber_sides(&mut mesh, &changed);
        drop(changed);
        let strays = facets::name_faces(&mut mesh, facets, &names, stray)?;
        if strays > 0 {
            *skipped.entry("triangles and quadrilaterals on no solid element".to_owned()).or_default() +=
                strays;
        }
        notes.extend(skipped.into_iter().map(|(kind, count)| Note::Skipped { kind, count }));
        for list in mesh.faces.values_mut() {
            list.sort_unstable();
            list.dedup();
        }
        mesh.faces.retain(|_, list| !list.is_empty());
        let count = drop_unused_nodes(&mut mesh);
        if count > 0 {
            notes.push(Note::UnusedNodes { count });
        }
        let tolerance = COINCIDENT * shortest_edge(&mesh);
        let pairs = coincident_nodes(&mesh, tolerance);
        if let Some(&(first, second)) = pairs.first() {
            let [first, second] = [first, second].map(|n| mesh.node_id(n as usize));
            notes.push(Note::Coincident { count: pairs.len(), first, second, tolerance });
        }
        Ok((mesh, notes))
    }
}

/// An element that has node numbers where indices will be.
///
/// # Errors
/// A number that 32 bits do not hold, in words.
pub(crate) fn numbered(shape: Shape, corners: &[u64]) -> Result<Element, String> {
    let mut nodes = [0; 8];
    for (node, &corner) in nodes.iter_mut().zip(corners) {
        *node = u32::try_from(corner).map_err(|_| {
            format!("node {corner}: numbers up to {} can be read; renumber the nodes", u32::MAX)
        })?;
    }
    Ok(Element::new(shape, &nodes[..corners.len()]))
}

/// Sorts the groups, and puts the elements of none into one of their own.
fn group_all(mesh: &mut Mesh) {
    let mut grouped = vec![false; mesh.elements.len()];
    for list in mesh.groups.values_mut() {
        if !list.is_sorted_by(|a, b| a < b) {
            list.sort_unstable();
            list.dedup();
        }
        for &element in list.iter() {
            grouped[element as usize] = true;
        }
    }
    mesh.groups.retain(|_, list| !list.is_empty());
    let rest: Vec<u32> = (0..).zip(&grouped).filter(|(_, g)| !**g).map(|(e, _)| e).collect();
    if !rest.is_empty() {
        let list = mesh.groups.entry(UNGROUPED.to_owned()).or_default();
        list.extend(rest);
        list.sort_unstable();
    }
}
