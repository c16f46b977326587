//! Interfaces: groups of elements that touch without being joined.

use crate::life::{Life, Stage};
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
    /// Share of the pressure that the water of the ground beside it has which acts between its sides, 0 where it is drained. None: all,
    /// where a side has pores.
    pub water: Option<f64>,
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
            water: None,
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
    /// Share of the ground's water pressure in it ([`Interface::water`]).
    pub water: Option<f64>,
    pub corner: f64,
    /// Faces of the first side with those of the second.
    pub faces: Vec<[Face; 2]>,
    /// Pairs, on nodes of the mesh.
    pub pairs: Vec<PairShape>,
    /// When both sides of each face stand.
    pub standing: Vec<Life>,
    /// When each pair is there: while both sides stand and nothing holds its nodes together ([`crate::rims`]).
    pub lives: Vec<Life>,
    /// Of each pair, whether its sides stood before, held together: it begins with the traction that passes there then.
    pub freed: Vec<bool>,
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
        self.tractions = (0..self.pairs.len())
            .map(|pair| self.traction(pair, |face| Some(initial[face.element as usize])))
            .collect();
        let largest = self
            .tractions
            .iter()
            .zip(self.lives.iter().zip(&self.freed))
            .filter(|(_, (life, freed))| !life.is_later() || **freed)
            .fold(0.0, |most: f64, ([p, ..], _)| most.max(*p));
        self.pressure = self.pressure.max(AMPLE * largest);
    }

    /// Pressure, and shear t on the second side along the tangents \[Pa\], of the mean stress of the elements beside a pair, as
    /// far as one is known.
    pub(crate) fn traction(&self, pair: usize, stress: impl Fn(Face) -> Option<[f64; 6]>) -> [f64; 3] {
        let PairShape { normal, corners, .. } = &self.pairs[pair];
        let known = corners.iter().flat_map(|(f, _)| self.faces[*f as usize]).filter_map(stress);
        let known: Vec<[f64; 6]> = known.collect();
        let share = 1.0 / known.len().max(1) as f64;
        let mut mean = [0.0; 6];
        for stress in known {
            (0..6).for_each(|c| mean[c] += share * stress[c]);
        }
        let [e1, e2] = tangents(*normal);
        let on = traction(&mean, *normal);
        let along = |e: [f64; 3]| on[0] * e[0] + on[1] * e[1] + on[2] * e[2];
        // The second side lies along m, so what it feels is −σm.
        [-along(*normal), -along(e1), -along(e2)]
    }

    /// Its pairs that are there in the shaking.
    pub fn lasting(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.pairs.len()).filter(|&k| self.lives[k].holds(Stage::Shaking))
    }

    /// Its area in the shaking \[m²\].
    pub fn area(&self) -> f64 {
        self.lasting().map(|k| self.pairs[k].area).sum()
    }

    /// Where a pair is \[m\].
    pub fn place(&self, mesh: &Mesh, pair: usize) -> [f64; 3] {
        mesh.nodes[self.pairs[pair].nodes[1] as usize]
    }

    /// The pair nearest to a point, of those that are there in the shaking, if there are any.
    pub fn nearest(&self, mesh: &Mesh, point: [f64; 3]) -> usize {
        let square = |k: usize| {
            let x = self.place(mesh, k);
            (0..3).map(|i| (x[i] - point[i]).powi(2)).sum::<f64>()
        };
        let nearest =
            |of: &mut dyn Iterator<Item = usize>| of.min_by(|&a, &b| square(a).total_cmp(&square(b)));
        nearest(&mut self.lasting()).or_else(|| nearest(&mut (0..self.pairs.len()))).unwrap_or(0)
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
