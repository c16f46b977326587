//! Why an interface could not be opened, or its copies not be tied.

use crate::topology::Unmatched;

/// Why a mesh was not split.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SplitError {
    /// A side has no element, or none that is there; `side` is 1 or 2.
    #[error("interface '{name}': side {side} has no element that is there; name groups that have some")]
    Empty { name: String, side: u8 },
    /// An element is in both sides.
    #[error(
        "interface '{name}': element {element} is in both sides; give two groups that have no element in common"
    )]
    BothSides { name: String, element: u64 },
    /// The sides have no face in common.
    #[error(
        "interface '{name}': its two sides have no face in common; {}; name groups that touch, give both the same mesh where they \
         do, or merge their nodes if a gap parts them",
        apart(*distance)
    )]
    Apart { name: String, distance: f64 },
    /// A face is on two interfaces.
    #[error(
        "interfaces '{first}' and '{second}' both claim a face of element {element}; take its element out of the \
         sides of one of them"
    )]
    Claimed { first: String, second: String, element: u64 },
    /// More than one element of a side has the same face.
    #[error(
        "interface '{name}': more than two elements have the same face, {first} and {second} among them; take the \
         elements that lie on others out of the mesh"
    )]
    Crowded { name: String, first: u64, second: u64 },
}

impl SplitError {
    /// Name of the interface, of the second where there are two.
    pub fn interface(&self) -> &str {
        match self {
            SplitError::Empty { name, .. }
            | SplitError::BothSides { name, .. }
            | SplitError::Apart { name, .. }
            | SplitError::Claimed { second: name, .. }
            | SplitError::Crowded { name, .. } => name,
        }
    }
}

fn apart(distance: f64) -> String {
    if distance == 0.0 {
        "they touch along edges or at nodes alone".into()
    } else {
        format!("their faces' nodes are {distance} m apart at the nearest")
    }
}

/// Why the nodes of two opposite sides of a split mesh could not be paired.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum UnmatchedSplit {
    /// The sides do not match before the split.
    #[error(transparent)]
    Sides(#[from] Unmatched),
    /// A node is split and its partner is not, or otherwise.
    #[error(
        "node {node} has no partner for each of its copies at an interface; the interface must reach both sides \
         alike: give it the same faces there, or sides of another kind"
    )]
    Copies { node: u64 },
}
