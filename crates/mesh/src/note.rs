//! What a reader, a writer or a generator did that its user should know.

use std::fmt;

use crate::Shape;

/// One remark on a mesh that was read, written or generated. Its text says what it means for the calculation.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Note {
    /// `count` elements of `nodes` nodes were reduced to their corners.
    Reduced { nodes: usize, shape: Shape, count: usize },
    /// `count` elements of a kind that no model can hold were passed over.
    Skipped { kind: String, count: usize },
    /// `count` elements were numbered in mirror image, the first of them `first`, and were renumbered.
    Turned { count: usize, first: u64 },
    /// `count` hexahedra with repeated nodes were read as the shape that they are.
    Collapsed { shape: Shape, count: usize },
    /// `count` hexahedra with one collapsed edge, the first of them `first`, were split into two pyramids each.
    Split { count: usize, first: u64 },
    /// `count` nodes belong to no element and were dropped.
    UnusedNodes { count: usize },
    /// `count` nodes lie within `tolerance` \[m\] of another, as `first` does of `second`.
    Coincident { count: usize, first: u64, second: u64, tolerance: f64 },
    /// Instances use the same numbers, so nodes or elements were numbered anew.
    Renumbered,
    /// The file holds `count` of something that a mesh does not, such as `*TIE`.
    NotTaken { what: String, count: usize },
    /// The node set `set` names `count` nodes that the file does not define, the first of them `first`.
    AbsentNodes { set: String, count: usize, first: u64 },
    /// The text is not UTF-8 and was read in this encoding.
    Assumed { encoding: String },
    /// The surface `name` has `count` faces inside the mesh for one side only; the file written names both.
    BothSides { name: String, count: usize },
    /// The cut below bench `bench` of a generated cavern lies `to` \[m\] above its floor, at a gallery's floor or roof,
    /// instead of `from`, where equal benches have it.
    MovedCut { cavern: String, bench: u32, from: f64, to: f64 },
    /// The plane above the layer `layer` of a generated block is level but not a plane of nodes.
    Stepped { layer: String },
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Note::Reduced { nodes, shape: Shape::Tet4, count } => write!(
                f,
                "{count} {nodes}-node tetrahedra were reduced to their 4 corners: strain is then constant in \
                 each, which makes the model too stiff in bending and where it yields without change of volume \
                 (locking); prefer hexahedra, or refine"
            ),
            Note::Reduced { nodes, shape, count } => write!(
                f,
                "{count} {nodes}-node elements were reduced to {}: curved edges become straight, and bending \
                 needs about twice as many elements along each edge",
                shape.name()
            ),
            Note::Skipped { kind, count } => {
                write!(f, "{count} {kind} were passed over: the model holds solid elements only")
            }
            Note::Turned { count, first } => write!(
                f,
                "{count} elements were numbered in mirror image and were renumbered, the first of them is {first}"
            ),
            Note::Collapsed { shape, count } => {
                write!(f, "{count} hexahedra with repeated nodes were read as {}", shape.name())
            }
            Note::Split { count, first } => write!(
                f,
                "{count} hexahedra with one collapsed edge were split into two pyramids each, the first of them is \
                 {first}; beside hexahedra their split sides fit only at the nodes"
            ),
            Note::UnusedNodes { count } => {
                write!(f, "{count} nodes belong to no solid element and were dropped")
            }
            Note::Coincident { count, first, second, tolerance } => write!(
                f,
                "{count} nodes lie within {tolerance:.1e} m of another, as {first} does of {second}: parts are not \
                 joined there; if they should be, merge the nodes within that tolerance"
            ),
            Note::Renumbered => {
                write!(f, "instances use the same numbers; nodes and elements are numbered anew from 1")
            }
            Note::NotTaken { what, count } => write!(f, "{count} {what} were not taken over"),
            Note::AbsentNodes { set, count, first } => {
                write!(
                    f,
                    "node set `{set}` names {count} nodes that the file does not define, among them {first}"
                )
            }
            Note::Assumed { encoding } => {
                write!(
                    f,
                    "the text is not UTF-8 and was read as {encoding}; if names are wrong, give `encoding` in [mesh.file], or write it in UTF-8"
                )
            }
            Note::BothSides { name, count } => write!(
                f,
                "surface `{name}` has {count} faces inside the mesh for one side only; this format names both sides"
            ),
            Note::MovedCut { cavern, bench, from, to } => write!(
                f,
                "the cut below bench {bench} of cavern `{cavern}` lies {to:.3} m above its floor, at a gallery's floor or \
                 roof, not {from:.3} m, as equal benches have it; a lower `size_near` keeps it there"
            ),
            Note::Stepped { layer } => write!(
                f,
                "the plane above layer `{layer}` runs among the elements round a cavern or leaves too little room for \
                 a line of the grid: there elements belong to the layer of their middles, and the boundary has steps"
            ),
        }
    }
}
