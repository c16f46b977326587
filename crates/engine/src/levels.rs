//! The level of each node's and element's steps in the shaking.

use tremolite_mesh::{Element, Mesh};

/// The level of each node and element of a mesh.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Levels {
    /// By node and by element of the mesh; empty where there is one level.
    node: Vec<u8>,
    element: Vec<u8>,
}

impl Levels {
    /// All on one level.
    pub fn one() -> Self {
        Levels::default()
    }

    /// That of each node of a mesh, and of each of these elements the finest of its nodes; others are on the finest, so that it does
    /// not matter to them.
    pub fn given(mesh: &Mesh, elements: &[u32], node: Vec<u8>) -> Self {
        let finest = |e: &Element| e.nodes().iter().map(|&n| node[n as usize]).min().unwrap_or(0);
        let mut element = vec![0; mesh.elements.len()];
        elements.iter().for_each(|&e| element[e as usize] = finest(&mesh.elements[e as usize]));
        Levels { node, element }
    }

    /// With none coarser than this.
    #[must_use]
    pub fn capped(&self, coarsest: u8) -> Self {
        if coarsest == 0 {
            return Levels::one();
        }
        let capped = |all: &[u8]| all.iter().map(|&level| level.min(coarsest)).collect();
        Levels { node: capped(&self.node), element: capped(&self.element) }
    }

    pub fn of_node(&self, node: u32) -> u8 {
        self.node.get(node as usize).copied().unwrap_or(0)
    }

    pub fn of_element(&self, element: u32) -> u8 {
        self.element.get(element as usize).copied().unwrap_or(0)
    }

    /// The coarsest of all.
    pub fn coarsest(&self) -> u8 {
        self.node.iter().copied().max().unwrap_or(0)
    }

    /// Elements that are evaluated in a step of the finest level, in the mean, over those that are there.
    pub fn share(&self, elements: &[u32]) -> f64 {
        if elements.is_empty() {
            return 1.0;
        }
        let often = |&e: &u32| 0.5_f64.powi(i32::from(self.of_element(e)));
        elements.iter().map(often).sum::<f64>() / elements.len() as f64
    }
}
