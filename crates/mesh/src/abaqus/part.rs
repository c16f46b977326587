//! What belongs together in an input file: nodes, elements, sets and surfaces of a part or instance.

use std::collections::BTreeMap;

use super::deck::Label;
use crate::Element;

/// A surface element with the numbers of its 3 or 4 corners.
pub(super) struct Flat {
    pub number: u64,
    pub corners: Vec<u64>,
}

/// What an entry of a set or surface refers to.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Target {
    /// The numbers from the first to the second in steps of the third.
    Range(u64, u64, u64),
    /// Runs of consecutive numbers.
    Runs(Vec<Run>),
    /// A set, by its key.
    Set(String),
}

/// The numbers from `first` to `last`, of which the first stands in `line`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Run {
    pub first: u64,
    pub last: u64,
    pub line: u32,
}

/// An entry of a set or surface.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    /// Key of the instance, if it is named.
    pub instance: Option<String>,
    pub target: Target,
    /// Of a surface's entry, the face: `S1`, `SPOS`, or empty.
    pub face: String,
    /// Where it stands.
    pub line: usize,
}

/// A set of nodes or elements, or a surface.
#[derive(Clone, Debug, Default)]
pub(super) struct Set {
    pub shown: String,
    /// Made by Abaqus/CAE for its own use.
    pub internal: bool,
    pub entries: Vec<Entry>,
}

/// Sets by key.
pub(super) type Sets = BTreeMap<String, Set>;

/// The set of that name, made if there is none yet.
pub(super) fn set(sets: &mut Sets, label: Label, internal: bool) -> &mut Set {
    let Label { key, shown } = label;
    sets.entry(key).or_insert_with(|| Set { shown, internal, entries: Vec::new() })
}

impl Set {
    /// Adds one number; consecutive ones become one run.
    pub(super) fn push(&mut self, instance: Option<&str>, number: u64, line: usize) {
        let run = Run { first: number, last: number, line: line as u32 };
        if let Some(Entry { instance: same, target: Target::Runs(runs), .. }) = self.entries.last_mut()
            && same.as_deref() == instance
        {
            match runs.last_mut() {
                Some(last) if last.last.checked_add(1) == Some(number) => last.last = number,
                _ => runs.push(run),
            }
            return;
        }
        let target = Target::Runs(vec![run]);
        self.entries.push(Entry { instance: instance.map(str::to_owned), target, face: String::new(), line });
    }
}

/// A part, or what an instance has of its own.
#[derive(Default)]
pub(super) struct Part {
    pub key: String,
    pub node_numbers: Vec<u64>,
    pub nodes: Vec<[f64; 3]>,
    /// Numbers of the solids.
    pub solid_numbers: Vec<u64>,
    /// The solids, with node numbers where indices will be.
    pub solids: Vec<Element>,
    pub flats: Vec<Flat>,
    /// Numbers of elements that are passed over.
    pub others: Vec<u64>,
    pub elsets: Sets,
    pub nsets: Sets,
    pub surfaces: Sets,
}

/// A part put into the assembly.
#[derive(Default)]
pub(super) struct Instance {
    pub label: Label,
    /// Key of its part.
    pub part: String,
    /// What it defines itself.
    pub own: Part,
    /// Three numbers: a translation; seven more after it: a turn about the line from a to b by an angle in degrees.
    pub placement: Vec<f64>,
    pub line: usize,
}

impl Instance {
    /// A node's place in the assembly.
    pub(super) fn place(&self, x: [f64; 3]) -> [f64; 3] {
        let p = &self.placement;
        let moved = match p.get(..3) {
            Some(by) => [x[0] + by[0], x[1] + by[1], x[2] + by[2]],
            None => return x,
        };
        let Some(&[ax, ay, az, bx, by, bz, degrees]) = p.get(3..10) else { return moved };
        let axis = [bx - ax, by - ay, bz - az];
        let length = axis.iter().map(|c| c * c).sum::<f64>().sqrt();
        if length == 0.0 {
            return moved;
        }
        let k = axis.map(|c| c / length);
        let r = [moved[0] - ax, moved[1] - ay, moved[2] - az];
        let (sin, cos) = degrees.to_radians().sin_cos();
        // Rodrigues' formula.
        let cross = [k[1] * r[2] - k[2] * r[1], k[2] * r[0] - k[0] * r[2], k[0] * r[1] - k[1] * r[0]];
        let along = (0..3).map(|i| k[i] * r[i]).sum::<f64>() * (1.0 - cos);
        let origin = [ax, ay, az];
        [0, 1, 2].map(|i| origin[i] + r[i] * cos + cross[i] * sin + k[i] * along)
    }
}
