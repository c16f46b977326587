//! Interfaces: groups of elements that touch without being joined.

use crate::life::Life;
use std::collections::HashMap;
use tremolite_kernels::InterfaceLaw;
use tremolite_laws::Values;
use tremolite_mesh::pairs::{PairShape, tangents};
use tremolite_mesh::{Face, Mesh};

/// An interface as a problem states it.
#[derive(Clone)]
pub struct Interface {
    /// For messages and reports.
    pub name: String,
    /// Elements of the two sides; normals point out of the first into the second, which keeps the mesh's nodes.
    pub sides: [Vec<u32>; 2],
    pub law: InterfaceLaw,
    /// Of the law, in SI. What it may leave to be chosen ([`tremolite_laws::Need::Chosen`]) may be missing.
    pub values: Values,
    /// Pressure \[Pa\] that is not expected to be exceeded, where the law leaves open from which on it goes straight.
    pub pressure: f64,
    /// Faces that meet at less than this share pairs \[rad\].
    pub corner: f64,
    /// Dashpots of closed pairs whose bond is broken, as a share of critical at the stiffest state.
    pub damping: f64,
    /// ω_c Δt at most.
    pub limit: f64,
    /// Artificial viscosity of the elements that have a node on it, where their body has less: share of critical damping at an
    /// element's own highest frequency.
    pub viscosity: f64,
}

impl Interface {
    /// Of what has no compressive strength \[Pa\].
    pub const PRESSURE: f64 = 10e6;
    /// The foot of a wall, 90°, has pairs for each side; facets of a curve share theirs.
    pub const CORNER: f64 = tremolite_mesh::pairs::CORNER;
    /// Enough that impacts lose energy on the whole at [`Interface::LIMIT`].
    pub const DAMPING: f64 = 0.01;
    /// Beyond, impacts may gain energy.
    pub const LIMIT: f64 = 0.8;
    /// What slides feeds vibrations at the mesh's own frequencies, as friction follows the pressure; so much takes them out on a
    /// slope, whatever mesh and stiffness (`block_on_slope` in `crates/verify`).
    pub const VISCOSITY: f64 = 0.06;

    /// An interface with the usual corner, damping, limit and viscosity.
    pub fn new(name: impl Into<String>, sides: [Vec<u32>; 2], law: InterfaceLaw, values: Values) -> Self {
        Interface {
            name: name.into(),
            sides,
            law,
            values,
            pressure: Self::PRESSURE,
            corner: Self::CORNER,
            damping: Self::DAMPING,
            limit: Self::LIMIT,
            viscosity: Self::VISCOSITY,
        }
    }
}

/// An interface of a model: split, with its pairs.
#[derive(Clone)]
pub struct Seam {
    /// Of which interface of the model's, where it runs through what stands outside a side.
    pub of: Option<usize>,
    pub name: String,
    pub law: InterfaceLaw,
    /// As given.
    pub values: Values,
    pub pressure: f64,
    pub damping: f64,
    pub limit: f64,
    pub viscosity: f64,
    pub corner: f64,
    /// Faces of the first side with those of the second.
    pub faces: Vec<[Face; 2]>,
    /// Pairs, on nodes of the mesh.
    pub pairs: Vec<PairShape>,
    /// When each pair is there.
    pub lives: Vec<Life>,
    /// Of pairs that are there from the start under initial stress: pressure, and shear t on the second side along the tangents
    /// \[Pa\]; empty without initial stress.
    pub tractions: Vec<[f64; 3]>,
    /// Nodes at which it ends inside the model, closed.
    pub ends: Vec<u32>,
}

/// How much more than the pressure that a pair begins with may come before a law goes straight by itself.
const AMPLE: f64 = 1.5;

impl Seam {
    /// Gives pairs that are there from the start the traction of the initial stress beside them, and the law room for it.
    pub(crate) fn load(&mut self, initial: &[[f64; 6]]) {
        if initial.is_empty() {
            return;
        }
        let of_pair = |pair: &PairShape| {
            let mut mean = [0.0; 6];
            let sides = pair.corners.iter().flat_map(|(f, _)| self.faces[*f as usize]);
            let share = 0.5 / pair.corners.len() as f64;
            for face in sides {
                let stress = &initial[face.element as usize];
                (0..6).for_each(|c| mean[c] += share * stress[c]);
            }
            let [e1, e2] = tangents(pair.normal);
            let on = traction(&mean, pair.normal);
            let along = |e: [f64; 3]| on[0] * e[0] + on[1] * e[1] + on[2] * e[2];
            // The second side lies along m, so what it feels is −σm.
            [-along(pair.normal), -along(e1), -along(e2)]
        };
        self.tractions = self.pairs.iter().map(of_pair).collect();
        let largest = self
            .tractions
            .iter()
            .zip(&self.lives)
            .filter(|(_, life)| !life.is_later())
            .fold(0.0, |most: f64, ([p, ..], _)| most.max(*p));
        self.pressure = self.pressure.max(AMPLE * largest);
    }

    /// Its area \[m²\].
    pub fn area(&self) -> f64 {
        self.pairs.iter().map(|pair| pair.area).sum()
    }

    /// Where a pair is \[m\].
    pub fn place(&self, mesh: &Mesh, pair: usize) -> [f64; 3] {
        mesh.nodes[self.pairs[pair].nodes[1] as usize]
    }

    /// The pair nearest to a point.
    pub fn nearest(&self, mesh: &Mesh, point: [f64; 3]) -> usize {
        let square = |k: usize| {
            let x = self.place(mesh, k);
            (0..3).map(|i| (x[i] - point[i]).powi(2)).sum::<f64>()
        };
        (0..self.pairs.len()).min_by(|&a, &b| square(a).total_cmp(&square(b))).unwrap_or(0)
    }
}

/// σ·n \[Pa\].
pub fn traction(stress: &[f64; 6], n: [f64; 3]) -> [f64; 3] {
    let [xx, yy, zz, xy, yz, zx] = *stress;
    [xx * n[0] + xy * n[1] + zx * n[2], xy * n[0] + yy * n[1] + yz * n[2], zx * n[0] + yz * n[1] + zz * n[2]]
}

/// All nodes that were one, by that one, of those that were split.
pub fn copies(origin: &[u32]) -> HashMap<u32, Vec<u32>> {
    let mut copies: HashMap<u32, Vec<u32>> = HashMap::new();
    for (node, &of) in (0u32..).zip(origin) {
        if node != of {
            copies.entry(of).or_insert_with(|| vec![of]).push(node);
        }
    }
    copies
}
