//! Small problems, ready to run in the shaking.

use std::sync::Arc;
use tremolite_engine::{
    Assembly, Body, Interface, Model, Phase, Problem, Quadrature, StableStep, Stage, elastic, interface_laws,
    settle_levels, stable_step,
};
use tremolite_laws::{Moduli, Values};
use tremolite_mesh::Mesh;

pub const DENSITY: f64 = 2500.0;

/// A model with its parts and what of them is active in the shaking.
pub struct Ready {
    pub model: Arc<Model>,
    pub assembly: Arc<Assembly>,
    pub phase: Arc<Phase>,
}

impl Ready {
    pub fn new(problem: Problem) -> Self {
        let model = Model::new(problem).unwrap();
        let assembly = Assembly::new(&model).unwrap();
        let phase = Phase::of(&model, &assembly, Stage::Shaking).unwrap();
        Ready { model, assembly, phase }
    }

    /// The same with levels of steps as near to those wished for at each place as may be.
    pub fn levelled(self, wished: impl Fn([f64; 3]) -> u8) -> Self {
        let wished = self.model.mesh.nodes.iter().map(|&at| wished(at)).collect();
        let model = self.model.at_levels(&settle_levels(&self.model, &self.phase, wished));
        let assembly = self.assembly.again(&model).unwrap();
        let phase = Phase::of(&model, &assembly, Stage::Shaking).unwrap();
        Ready { model, assembly, phase }
    }

    pub fn stable(&self) -> StableStep {
        stable_step(&self.model, &self.assembly, &self.phase)
    }

    /// Where an engine node is \[m\].
    pub fn place(&self, node: u32) -> [f64; 3] {
        self.model.mesh.nodes[self.model.mesh_node[node as usize] as usize]
    }
}

/// Elastic elements of 2×2×2 points, of which no mode is left to a stabilisation.
pub fn body(name: &str, elements: Vec<u32>) -> Body {
    Body {
        name: name.into(),
        elements,
        material: elastic(moduli()),
        density: DENSITY,
        quadrature: Quadrature::Full,
        viscosity: 0.0,
    }
}

pub fn moduli() -> Moduli {
    Moduli::from_young_poisson(1e9, 0.25)
}

/// All of a mesh as one body.
pub fn whole(mesh: Mesh) -> Problem {
    let elements = (0..mesh.elements.len() as u32).collect();
    Problem::new(mesh, vec![body("rock", elements)])
}

/// A joint without friction between two bodies, of a stiffness \[Pa/m\].
pub fn joint(problem: &Problem, bodies: [usize; 2], stiffness: f64) -> Interface {
    let law = interface_laws().into_iter().find(|law| law.info.name == "coulomb").unwrap();
    let values = Values::default().with("normal_stiffness", stiffness).with("friction_coefficient", 0.0);
    Interface::new("joint", bodies.map(|b| problem.bodies[b].elements.clone()), law, values)
}
