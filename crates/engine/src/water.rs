//! Water in the pores of ground: what is known of it in each stage, and the forces that it does.
//!
//! Laws see effective stress (`terzaghi1943`): elements begin with C⁻¹(σ₀ + p_i I), σ₀ total, and a change of p moves them by (1 − α)Δp/3K
//! (`biot1941`), with K of the law's own; total stress is σ' − p I. The pressure is one number an element, the same in all of a stage, so
//! what it does, ∫Bᵀ(−p I), is a constant force as weight is (`pore_forces.rs`): kernels know nothing of it, and where there is no water nothing
//! of this is there. A change of pressure is a change of forces, which stages hold and let go like any other.
//!
//! In the shaking water cannot leave its pores if that is asked for: then p = p_h − αM(θ − θ_h) down to a floor, with θ the element's mean
//! dilatation and h the hand-over. Kernels know of that ([`tremolite_laws::shapes::hex8::Undrained`]), in those elements alone.
//!
//! It does not model flow, suction, or what deformation does to the pressure before the shaking.

use crate::body::Body;
use crate::error::ModelError;
use crate::interface::Seam;
use crate::life::Stage;
use crate::sheet::{Sheet, corners};
use std::collections::HashMap;
use tremolite_kernels::PoresOf;
use tremolite_laws::Moduli;
use tremolite_laws::shapes::hex8::{Hex8, element_frequencies};
use tremolite_mesh::Mesh;

/// The least pressure \[Pa\]: water boils there.
pub const FLOOR: f64 = -1e5;

/// Water in a model, as a program states it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Water {
    /// Biot's coefficient α of each element of the mesh, above 0 and at most 1; 0 of what has no pores.
    pub biot: Vec<f64>,
    /// Biot's modulus M of each element \[Pa\], by which deformation changes the pressure in the shaking where there is any when that begins; 0,
    /// or empty: pressures stay.
    pub modulus: Vec<f64>,
    /// What holds from a stage on until the next, ascending; the first begins with the model. None: no water.
    pub spells: Vec<Spell>,
}

/// Pressures from a stage on.
#[derive(Clone, Debug, PartialEq)]
pub struct Spell {
    pub from: Stage,
    /// Pressure \[Pa\] of each element of the mesh above the atmosphere's, 0 or more. That of an element without pores does nothing.
    pub elements: Vec<f64>,
    /// Pressure \[Pa\] at each node of the mesh, for interfaces.
    pub nodes: Vec<f64>,
}

impl Water {
    /// What holds in a stage.
    pub fn spell(&self, stage: Stage) -> Option<&Spell> {
        self.spells.iter().rev().find(|spell| spell.from <= stage)
    }

    /// Pressure \[Pa\] in an element's pores in a stage; 0 where it has none.
    pub fn pressure(&self, element: usize, stage: Stage) -> f64 {
        match self.spell(stage) {
            Some(spell) if self.biot[element] > 0.0 => spell.elements[element],
            _ => 0.0,
        }
    }

    /// Pores of an element in which the shaking changes the pressure; none where it stays.
    pub fn undrained(&self, element: usize) -> Option<PoresOf> {
        let modulus = self.modulus.get(element).copied().filter(|modulus| *modulus > 0.0)?;
        let p = self.pressure(element, Stage::Shaking);
        (p > 0.0).then(|| PoresOf { biot: self.biot[element], modulus, least: FLOOR - p })
    }

    /// Elastic moduli \[Pa\] of an element's ground in the shaking, water included, from those without.
    pub fn stiffened(&self, element: usize, moduli: Moduli) -> Moduli {
        let more = self.undrained(element).map_or(0.0, |pores| pores.biot * pores.biot * pores.modulus);
        Moduli { lambda: moduli.lambda + more, ..moduli }
    }

    /// The highest frequency of each of some elements of a body alone in the shaking \[rad/s\], water included, from those without, `all`.
    /// `shape` is that of an element by its place among these.
    pub(crate) fn frequencies(
        &self,
        body: &Body,
        elements: &[u32],
        mut all: Vec<f64>,
        shape: impl Fn(usize) -> Option<Hex8>,
    ) -> Vec<f64> {
        let (moduli, density, quadrature) = (body.material.stiffest(), body.density, body.quadrature);
        let stiffened = |i: usize| self.stiffened(elements[i] as usize, moduli);
        let mut wet: Vec<usize> =
            (0..elements.len()).filter(|&i| self.undrained(elements[i] as usize).is_some()).collect();
        // Those that are equally stiff side by side: mostly all of them.
        while let Some(&first) = wet.first() {
            let moduli = stiffened(first);
            let (own, rest): (Vec<usize>, Vec<usize>) =
                wet.into_iter().partition(|&i| stiffened(i) == moduli);
            // `Model::new` has checked every element.
            let (own, alike): (Vec<usize>, Vec<Hex8>) =
                own.into_iter().filter_map(|i| Some((i, shape(i)?))).unzip();
            let omegas = element_frequencies(&alike, moduli, density, quadrature);
            own.into_iter().zip(omegas).for_each(|(i, omega)| all[i] = omega);
            wet = rest;
        }
        all
    }

    /// Whether an element has pores.
    pub fn is_porous(&self, element: usize) -> bool {
        self.biot.get(element).is_some_and(|alpha| *alpha > 0.0)
    }

    /// Whether there is any pressure in an element's pores at any time.
    pub(crate) fn wets(&self, element: usize) -> bool {
        self.is_porous(element) && self.spells.iter().any(|spell| spell.elements[element] > 0.0)
    }

    /// Pressure \[Pa\] of the water in a pair of an interface in a stage, which with that of the law is its total pressure.
    pub fn in_pair(&self, seam: &Seam, pair: usize, stage: Stage) -> f64 {
        let Some(spell) = self.spell(stage) else { return 0.0 };
        let shape = &seam.pairs[pair];
        let porous = || {
            let mut faces = shape.corners.iter().flat_map(|(face, _)| seam.faces[*face as usize]);
            faces.any(|face| self.is_porous(face.element as usize))
        };
        let factor = seam.water.unwrap_or_else(|| f64::from(u8::from(porous())));
        factor * spell.nodes[shape.nodes[1] as usize]
    }

    /// Refuses what does not fit a mesh, or elements that take over from others (later → earlier).
    ///
    /// # Errors
    /// If lists have other lengths than the mesh, or numbers that cannot be.
    pub(crate) fn check(&self, mesh: &Mesh, successors: &HashMap<u32, u32>) -> Result<(), ModelError> {
        let refuse = |reason: String| Err(ModelError::Water { reason });
        let Some(first) = self.spells.first() else { return Ok(()) };
        let (count, nodes) = (mesh.elements.len(), mesh.nodes.len());
        if self.biot.len() != count
            || self.spells.iter().any(|s| s.elements.len() != count || s.nodes.len() != nodes)
        {
            return refuse(format!("give numbers for all {count} elements and {nodes} nodes"));
        }
        if first.from != Stage::Before(0) || !self.spells.is_sorted_by(|a, b| a.from < b.from) {
            return refuse("pressures begin with stage 0, and go on with later ones".into());
        }
        if self.spells.iter().any(|spell| spell.from == Stage::Shaking) {
            return refuse("pressures change with stages before the shaking alone".into());
        }
        if !self.modulus.is_empty() && self.modulus.len() != count {
            return refuse(format!("give Biot's modulus of all {count} elements, or of none"));
        }
        if let Some(modulus) = self.modulus.iter().find(|modulus| !(modulus.is_finite() && **modulus >= 0.0))
        {
            return refuse(format!("Biot's modulus is {modulus} Pa: it must be 0 or more"));
        }
        if let Some(alpha) = self.biot.iter().find(|alpha| !(0.0..=1.0).contains(*alpha)) {
            return refuse(format!("Biot's coefficient is {alpha}: it lies above 0 and at most at 1"));
        }
        let all = self.spells.iter().flat_map(|spell| spell.elements.iter().chain(&spell.nodes));
        if let Some(p) = all.into_iter().find(|p| !(p.is_finite() && **p >= 0.0)) {
            return refuse(format!("a pressure is {p} Pa: it must be 0 or more"));
        }
        let unlike = |(a, b): (&u32, &u32)| self.is_porous(*a as usize) != self.is_porous(*b as usize);
        if let Some((later, _)) = successors.iter().filter(|&pair| unlike(pair)).min() {
            let element = mesh.element_id(*later as usize);
            return refuse(format!(
                "element {element} changes between materials with and without pores: give both `water`, or neither"
            ));
        }
        Ok(())
    }

    /// Says of elements outside sides, and of copies of nodes, what is said of those that they were made of. `origin` is the node that
    /// each of the user's was before interfaces parted the mesh; empty without.
    pub(crate) fn spread<'s>(
        &mut self,
        mesh: &Mesh,
        users: usize,
        parents: &[u32],
        origin: &[u32],
        sheets: impl Iterator<Item = &'s Sheet>,
    ) {
        if self.spells.is_empty() {
            return;
        }
        let sheets: Vec<&Sheet> = sheets.collect();
        let of_parents = |list: &[f64]| parents.iter().map(|&e| list[e as usize]).collect();
        self.biot = of_parents(&self.biot);
        if !self.modulus.is_empty() {
            self.modulus = of_parents(&self.modulus);
        }
        for spell in &mut self.spells {
            spell.elements = of_parents(&spell.elements);
            let given = &spell.nodes;
            let of = |n: usize| origin.get(n).map_or(n, |&n| n as usize);
            let mut nodes: Vec<f64> = (0..users).map(|n| given[of(n)]).collect();
            nodes.resize(mesh.nodes.len(), 0.0);
            for corner in sheets.iter().flat_map(|s| &s.twins).flat_map(|&twin| corners(mesh, twin)) {
                nodes[corner.front as usize] = nodes[corner.source as usize];
                nodes[corner.back as usize] = nodes[corner.source as usize];
            }
            spell.nodes = nodes;
        }
    }

    /// Strain by which a change of pressure \[Pa\] moves what the law sees, each normal component: grains give way.
    pub(crate) fn offset(&self, element: usize, change: f64, moduli: Moduli) -> f64 {
        let bulk = moduli.lambda + 2.0 / 3.0 * moduli.mu;
        (1.0 - self.biot[element]) * change / (3.0 * bulk)
    }
}

/// The stress \[Pa\] with a pressure in the pores taken off: effective with p, total with −p.
#[must_use]
pub fn with_pressure(mut stress: [f64; 6], p: f64) -> [f64; 6] {
    stress[..3].iter_mut().for_each(|s| *s += p);
    stress
}

/// The stage before one, if there is one before the shaking.
pub(crate) fn earlier(stage: Stage) -> Option<Stage> {
    match stage {
        Stage::Before(k) => k.checked_sub(1).map(Stage::Before),
        Stage::Shaking => None,
    }
}
