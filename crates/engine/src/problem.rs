//! The problem as a program states it: what a case file becomes, and what a Rust program writes directly.

use crate::member::Member;
use crate::parts::loads::Load;
use std::sync::Arc;
use tremolite_kernels::{AnyMaterial, Quadrature};
use tremolite_laws::Isa;
use tremolite_mesh::Mesh;
use tremolite_motion::Motion;

/// Elements of one material and one quadrature.
#[derive(Clone)]
pub struct Body {
    /// For messages and reports.
    pub name: String,
    /// Indices into the mesh's elements.
    pub elements: Vec<u32>,
    pub material: Arc<dyn AnyMaterial>,
    /// Density ρ \[kg/m³\].
    pub density: f64,
    pub quadrature: Quadrature,
}

/// What holds or leaves a pair of opposite vertical sides.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Side {
    /// No traction.
    #[default]
    Free,
    /// No displacement.
    Fixed,
    /// No displacement normal to the side.
    Roller,
    /// Dashpots ρc_p, ρc_s (Lysmer & Kuhlemeyer 1969).
    Viscous,
    /// Opposite nodes move as one.
    Periodic,
}

/// What holds or drives the base.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Base {
    #[default]
    Free,
    Fixed,
    /// Dashpots, through which the incident wave enters.
    Viscous,
    /// Dashpots and springs α G/R on the motion scattered by the caverns.
    ViscousSpring {
        /// α_N (normal).
        normal: f64,
        /// α_T (tangential).
        tangential: f64,
        /// R \[m\], from the source of scattering to the base; by default from the centre of what is excavated.
        distance: Option<f64>,
    },
}

impl Base {
    /// Whether springs act, which need the free field of a reference column.
    pub fn has_springs(&self) -> bool {
        matches!(self, Base::ViscousSpring { normal, tangential, .. } if *normal != 0.0 || *tangential != 0.0)
    }
}

/// Rayleigh damping C = ω M + ξ K (19).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rayleigh {
    /// ω \[1/s\].
    pub mass: f64,
    /// ξ \[s\].
    pub stiffness: f64,
}

/// An incident wave, travelling up through the base.
#[derive(Clone)]
pub struct Incident {
    /// Motion in the model's axes.
    pub motion: Motion,
    /// Factor from that motion to the incident wave: ½ for an outcrop's.
    pub factor: f64,
}

/// How the time step is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeStep {
    /// Fraction of the stable step to use.
    pub safety: f64,
    /// A step to use instead \[s\]; the guard still watches.
    pub given: Option<f64>,
}

impl Default for TimeStep {
    fn default() -> Self {
        TimeStep { safety: 0.9, given: None }
    }
}

/// Makes a part of a program's own, once the mesh has its final form and its nodes have their engine numbers (`u32::MAX`
/// for those that no element uses). Such parts come behind all others.
pub type MakePart = Arc<dyn Fn(&Mesh, &[u32]) -> Member + Send + Sync>;

/// Everything that defines a run in space.
#[derive(Clone)]
pub struct Problem {
    pub mesh: Mesh,
    /// Elements in no body are void.
    pub bodies: Vec<Body>,
    pub base: Base,
    /// Sides normal to x and to y.
    pub sides: [Side; 2],
    pub incident: Option<Incident>,
    pub rayleigh: Rayleigh,
    /// Forces on nodes of the mesh.
    pub loads: Vec<Load>,
    /// Components held at single nodes of the mesh.
    pub held: Vec<(u32, [bool; 3])>,
    /// Nodes of the mesh that move as one.
    pub ties: Vec<(u32, u32)>,
    /// Parts of the program's own.
    pub parts: Vec<MakePart>,
    pub time_step: TimeStep,
    pub isa: Isa,
    /// Elements a patch, rounded up to eights; by default from the size of the model.
    pub patch_elements: Option<usize>,
}

impl Problem {
    /// A problem with free boundaries and nothing acting.
    pub fn new(mesh: Mesh, bodies: Vec<Body>) -> Self {
        Problem {
            mesh,
            bodies,
            base: Base::Free,
            sides: [Side::Free; 2],
            incident: None,
            rayleigh: Rayleigh::default(),
            loads: Vec::new(),
            held: Vec::new(),
            ties: Vec::new(),
            parts: Vec::new(),
            time_step: TimeStep::default(),
            isa: Isa::best(),
            patch_elements: None,
        }
    }
}
