//! The problem as a program states it: what a case file becomes, and what a Rust program writes directly.

use crate::body::Body;
use crate::bolts::Bolts;
use crate::boundary::bed::Bed;
use crate::boundary::{Base, Side, Top};
use crate::free_field::{GivenField, Incident};
use crate::interface::Interface;
use crate::life::Life;
use crate::member::Member;
use crate::parts::loads::Load;
use crate::prescribed::Prescribed;
use crate::traction::Traction;
use crate::water::Water;
use std::sync::Arc;
use tremolite_laws::Isa;
use tremolite_mesh::Mesh;

/// Rayleigh damping C = ω M + ξ K (19).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rayleigh {
    /// ω \[1/s\].
    pub mass: f64,
    /// ξ \[s\].
    pub stiffness: f64,
}

/// How the time step is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeStep {
    /// Fraction of the stable step to use.
    pub safety: f64,
    /// A step to use instead \[s\]; the guard still watches.
    pub given: Option<f64>,
    /// Levels of steps at most: 1 for one step of all nodes, [`MOST_LEVELS`] for steps of up to eight times the finest.
    pub levels: u8,
}

/// Levels of steps that a model can have.
pub const MOST_LEVELS: u8 = 4;

impl Default for TimeStep {
    fn default() -> Self {
        TimeStep { safety: 0.9, given: None, levels: 1 }
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
    /// The life of each element of the mesh; all are always there if empty. Where one stands in the place of another at another
    /// time, both are elements of the mesh.
    pub lives: Vec<Life>,
    /// Elements that stand in the place of others before these do: (stand-in, the other). What they do is shown as the other's.
    pub stand_ins: Vec<(u32, u32)>,
    /// Elements that take over from others at the same place and nodes, at their stress: (later, earlier). The later ones begin
    /// with a stage, in which the earlier ones are gone.
    pub successors: Vec<(u32, u32)>,
    /// Stress \[Pa\] of each element of the mesh before anything moves, of those that are there then; empty for none.
    pub initial: Vec<[f64; 6]>,
    /// Water in the pores of ground; by default none. The initial stress is then total stress.
    pub water: Water,
    /// Acceleration \[m/s²\] along −z with which masses weigh down before the shaking, 0 for no weight.
    pub gravity: f64,
    /// Tractions on faces before the shaking, which what is held carries on.
    pub tractions: Vec<Traction>,
    pub base: Base,
    /// Sides normal to x and to y.
    pub sides: [Side; 2],
    /// Whether the springs of the base stand at free-field sides as well.
    pub side_springs: bool,
    pub top: Top,
    /// What holds the sides and the base before the shaking.
    pub bed: Bed,
    /// What is moved before the shaking.
    pub prescribed: Vec<Prescribed>,
    /// A wave that rises through the base.
    pub incident: Option<Incident>,
    /// A free field that is known in advance, instead of that wave: base, free-field sides and a viscous top are driven by it.
    pub free_field: Option<Arc<dyn GivenField>>,
    pub rayleigh: Rayleigh,
    /// Groups of elements that touch without being joined.
    pub interfaces: Vec<Interface>,
    /// Bolts, anchors and reinforcing bars, each group placed in its stage.
    pub bolts: Vec<Bolts>,
    /// Forces on nodes of the mesh; where an interface splits one, on its second side.
    pub loads: Vec<Load>,
    /// Components held at single nodes of the mesh, on both sides of an interface.
    pub held: Vec<(u32, [bool; 3])>,
    /// Nodes of the mesh that move as one; where an interface splits one, its second side.
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
            lives: Vec::new(),
            stand_ins: Vec::new(),
            successors: Vec::new(),
            initial: Vec::new(),
            water: Water::default(),
            gravity: 0.0,
            tractions: Vec::new(),
            base: Base::Free,
            sides: [Side::Free; 2],
            side_springs: false,
            top: Top::Free,
            bed: Bed::default(),
            prescribed: Vec::new(),
            incident: None,
            free_field: None,
            rayleigh: Rayleigh::default(),
            interfaces: Vec::new(),
            bolts: Vec::new(),
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
