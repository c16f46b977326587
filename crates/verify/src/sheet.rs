//! Plates, strips and shells as sheets of elements, under forces.

use crate::convergence::order;
use crate::dense::dot;
use crate::models::{LAYERED, Solid};
use crate::simulation::Simulation;
use crate::{Check, VerifyError, banded};
use tremolite::Quadrature;
use tremolite_mesh::{Element, Mesh, Shape};

/// The elements of a sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    Hexahedra,
    /// Two in the place of each hexahedron, by diagonals that alternate.
    Wedges,
}

/// Both, with the word for messages.
pub const CELLS: [(Cell, &str); 2] = [(Cell::Hexahedra, "hexahedra"), (Cell::Wedges, "wedges")];

/// A node of a sheet.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// Its numbers along the two directions of the sheet and through the thickness.
    pub number: [usize; 3],
    pub at: [f64; 3],
}

/// Elements along two directions and through the thickness.
#[derive(Clone, Debug)]
pub struct Sheet {
    pub cells: [usize; 3],
    mesh: Mesh,
}

impl Sheet {
    /// `place` gives the place of a node by its numbers along the sheet and its place through the thickness, from −½ to ½.
    pub fn new(cells: [usize; 3], cell: Cell, place: impl Fn([usize; 2], f64) -> [f64; 3]) -> Self {
        let mut sheet = Sheet { cells, mesh: Mesh::default() };
        for [i, j, k] in sheet.numbers() {
            sheet.mesh.nodes.push(place([i, j], k as f64 / cells[2] as f64 - 0.5));
        }
        let node = |i: usize, j: usize, k: usize| (((i * (cells[1] + 1)) + j) * (cells[2] + 1) + k) as u32;
        for i in 0..cells[0] {
            for j in 0..cells[1] {
                for k in 0..cells[2] {
                    let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
                    let mut add = |shape, plan: &[usize]| {
                        let level = |k| plan.iter().map(move |&p| node(corners[p].0, corners[p].1, k));
                        let nodes: Vec<u32> = level(k).chain(level(k + 1)).collect();
                        sheet.mesh.elements.push(Element::new(shape, &nodes));
                    };
                    match (cell, (i + j) % 2) {
                        (Cell::Hexahedra, _) => add(Shape::Hex8, &[0, 1, 2, 3]),
                        (Cell::Wedges, 0) => {
                            [[0, 1, 2], [0, 2, 3]].iter().for_each(|plan| add(Shape::Wedge6, plan))
                        }
                        _ => [[0, 1, 3], [1, 2, 3]].iter().for_each(|plan| add(Shape::Wedge6, plan)),
                    }
                }
            }
        }
        sheet
    }

    /// Of all nodes, in their order.
    fn numbers(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        let [across, along, through] = self.cells;
        (0..=across).flat_map(move |i| (0..=along).flat_map(move |j| (0..=through).map(move |k| [i, j, k])))
    }

    /// All nodes, in their order.
    pub fn nodes(&self) -> impl Iterator<Item = Node> + '_ {
        self.numbers().zip(&self.mesh.nodes).map(|(number, &at)| Node { number, at })
    }

    /// Share of a node in a uniform load of unit sum along some directions of the sheet, and through the thickness.
    pub fn share(&self, node: Node, along: &[usize]) -> f64 {
        let part = |&axis: &usize| {
            let end = node.number[axis] == 0 || node.number[axis] == self.cells[axis];
            (if end { 0.5 } else { 1.0 }) / self.cells[axis] as f64
        };
        along.iter().chain([&2]).map(part).product()
    }

    /// Displacements \[m\] by node under forces \[N\]. Elements are layered where the sheet is one element thick, else have 2×2×2 points.
    ///
    /// # Errors
    /// If the sheet is not held against rigid motion.
    pub fn displacements(
        &self,
        solid: Solid,
        held: impl Fn(Node) -> [bool; 3],
        force: impl Fn(Node) -> [f64; 3],
    ) -> Result<Vec<[f64; 3]>, VerifyError> {
        let quadrature = if self.cells[2] == 1 { LAYERED.0 } else { Quadrature::Full };
        let mut problem = solid.fill(self.mesh.clone(), quadrature);
        problem.held = (0..).zip(self.nodes().map(held)).collect();
        let simulation = Simulation::on_one_level(problem)?;
        let forces: Vec<(u32, [f64; 3])> = (0..).zip(self.nodes().map(force)).collect();
        banded::solve(&simulation, &forces)
    }

    /// Work \[J\] of forces \[N\] on the displacements that they cause, twice the strain energy.
    ///
    /// # Errors
    /// If the sheet is not held against rigid motion.
    pub fn work(
        &self,
        solid: Solid,
        held: impl Fn(Node) -> [bool; 3],
        force: impl Fn(Node) -> [f64; 3],
    ) -> Result<f64, VerifyError> {
        let u = self.displacements(solid, held, &force)?;
        Ok(u.iter().zip(self.nodes()).map(|(u, node)| dot(u, &force(node))).sum())
    }
}

/// Deflections over their reference in two divisions, the second with twice as many elements along each direction.
#[derive(Clone, Copy, Debug)]
pub struct Ratios {
    pub coarse: f64,
    pub fine: f64,
}

impl Ratios {
    /// Deflections by the number of elements a side, over the reference.
    ///
    /// # Errors
    /// Those of the deflections.
    pub fn new(
        coarse: usize,
        reference: f64,
        deflection: impl Fn(usize) -> Result<f64, VerifyError>,
    ) -> Result<Self, VerifyError> {
        Ok(Ratios { coarse: deflection(coarse)? / reference, fine: deflection(2 * coarse)? / reference })
    }

    /// The order of the stiffness over that of the reference, less 1. It lies between 2, of moments constant in an element, and 4, of edges that fan out.
    pub fn order(self, name: &'static str, what: &str) -> Check {
        let excess = [self.coarse, self.fine].map(|ratio| (1.0 / ratio - 1.0).abs());
        let p = order(excess[0], excess[1], 2.0);
        let quantity = format!("order of the stiffness over the reference, less 1, {what}");
        let note = "1.3 about 3: 2 of moments constant in an element, 4 of fanned edges, a tenth of an order for the terms \
                    after each, and 0.2 for the reference's own digits";
        Check::new(name, quantity, p, 3.0, 1.3, "1", note).with_order(p)
    }
}
