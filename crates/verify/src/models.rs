//! What several problems are built from: elastic bodies, bricks, columns, and forces on a set of nodes.

use crate::VerifyError;
use std::sync::Arc;
use tremolite::parts::loads::Load;
use tremolite::{AnyMaterial, Body, Law, Layers, Problem, Quadrature, Side, elastic, laws};
use tremolite_laws::{Moduli, Values};
use tremolite_mesh::Mesh;
use tremolite_mesh::boxes::{BoxError, BoxSpec, Distortion};

/// Both quadratures, with the word for messages.
pub const QUADRATURES: [(Quadrature, &str); 2] =
    [(Quadrature::OnePoint, "one-point"), (Quadrature::Full, "full")];

/// Of linings one element thick, with nine points through them.
pub const LAYERED: (Quadrature, &str) = (Quadrature::Layered(Layers::Nine), "layered");

/// Sides that must leave a vertical wave alone, with what quantities are called behind their names.
pub const SIDES: &[(Side, &str)] = &[(Side::Periodic, ""), (Side::FreeField, ", free-field sides")];

/// An isotropic elastic solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solid {
    /// Young's modulus \[Pa\].
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Density \[kg/m³\].
    pub density: f64,
}

impl Solid {
    pub fn moduli(&self) -> Moduli {
        Moduli::from_young_poisson(self.young, self.poisson)
    }

    /// Speeds of P and S waves \[m/s\].
    pub fn speeds(&self) -> (f64, f64) {
        self.moduli().wave_speeds(self.density)
    }

    /// The solid with this speed of S waves \[m/s\].
    pub fn from_shear_speed(speed: f64, poisson: f64, density: f64) -> Self {
        Solid { young: 2.0 * (1.0 + poisson) * density * speed * speed, poisson, density }
    }

    fn material(&self) -> Arc<dyn AnyMaterial> {
        elastic(self.moduli())
    }

    /// A body of these elements.
    pub fn body(&self, name: &str, elements: Vec<u32>, quadrature: Quadrature) -> Body {
        Body {
            name: name.into(),
            elements,
            material: self.material(),
            density: self.density,
            quadrature,
            viscosity: 0.0,
        }
    }

    /// A problem in which all elements are of this solid.
    pub fn fill(&self, mesh: Mesh, quadrature: Quadrature) -> Problem {
        let elements = (0..mesh.elements.len() as u32).collect();
        let body = self.body("solid", elements, quadrature);
        Problem::new(mesh, vec![body])
    }
}

/// A law of the list by its name.
///
/// # Errors
/// If there is none.
pub fn law(name: &str) -> Result<Law, VerifyError> {
    let known = laws().into_iter().find(|known| known.info.name == name);
    known.ok_or_else(|| VerifyError::Setup(format!("there is no law '{name}'")))
}

/// A material of a law of the list, by the law's name.
///
/// # Errors
/// If there is no such law, or it refuses the values.
pub fn material(name: &str, values: &Values) -> Result<Arc<dyn AnyMaterial>, VerifyError> {
    (law(name)?.build)(values).map_err(|faults| VerifyError::Setup(format!("{faults:?}")))
}

/// A box of bricks from the origin, its nodes shifted by up to `fraction` of the spacing.
pub fn distorted(size: [f64; 3], elements: [u32; 3], fraction: f64) -> Result<Mesh, BoxError> {
    let mut spec = BoxSpec::uniform([0.0; 3], size, elements);
    spec.distortion = Some(Distortion { fraction, seed: 7, periodic: [false; 2] });
    spec.mesh()
}

/// A column of cubes with side `h`, `across` by `across` of them in a layer, from z = 0 up.
pub fn column(h: f64, layers: u32, across: u32) -> Result<Mesh, BoxError> {
    let width = h * f64::from(across);
    BoxSpec::uniform([0.0; 3], [width, width, h * f64::from(layers)], [across, across, layers]).mesh()
}

/// Nodes at a level z \[m\], to a millionth of the mesh's height.
pub fn nodes_at_level(mesh: &Mesh, axis: usize, level: f64) -> Vec<u32> {
    let (low, high) = mesh.bounds();
    let near = 1e-6 * (high[axis] - low[axis]);
    (0..mesh.nodes.len() as u32).filter(|&n| (mesh.nodes[n as usize][axis] - level).abs() < near).collect()
}

/// A force \[N\] shared equally by some nodes, times a factor of time.
pub fn shared(nodes: &[u32], force: [f64; 3], factor: impl Fn(f64) -> f64 + Send + Sync + 'static) -> Load {
    let share = force.map(|f| f / nodes.len() as f64);
    Load { forces: nodes.iter().map(|&n| (n, share)).collect(), factor: Arc::new(factor) }
}
