//! Rectangular coordinate systems by three points (CORD2R).

use std::collections::{BTreeMap, HashMap, HashSet};

use super::bulk::Card;
use crate::fault::Fault;

/// A system as its card has it.
struct System {
    card: String,
    /// The system of the points; 0 is that of the mesh.
    of: u64,
    /// Its origin, a point on its z axis and one in its xz plane.
    points: [[f64; 3]; 3],
}

/// The systems of a file.
#[derive(Default)]
pub(super) struct Systems(BTreeMap<u64, System>);

/// Origin and axes.
struct Frame([f64; 3], [[f64; 3]; 3]);

/// The systems at their places.
pub(super) struct Frames {
    frames: HashMap<u64, Frame>,
    systems: Systems,
}

impl Systems {
    /// Takes a card whose name begins with CORD. One of another kind than CORD2R fails where it is used.
    pub(super) fn define(&mut self, card: &Card) -> Result<(), Fault> {
        let number = card.number(0, "the number of a coordinate system")?;
        let mut system = System { card: card.name().to_owned(), of: 0, points: [[0.0; 3]; 3] };
        if card.name() == "CORD2R" {
            card.check()?;
            system.of = card.optional(1, "the number of a coordinate system")?.unwrap_or(0);
            for (k, x) in system.points.iter_mut().flatten().enumerate() {
                *x = card.real(2 + k, "a coordinate")?;
            }
        }
        if self.0.insert(number, system).is_some() {
            return Err(card.fault(format!("there are two coordinate systems {number}; renumber them")));
        }
        Ok(())
    }

    /// Places all systems.
    ///
    /// # Errors
    /// If the points of one lie on a line, or one refers to itself.
    pub(super) fn frames(self) -> Result<Frames, Fault> {
        let mut frames = Frames { frames: HashMap::new(), systems: self };
        // Those that refer, through others or not, to a system that is missing or of another kind. They fail where they are used.
        let mut unplaced: HashSet<u64> = HashSet::new();
        for &first in frames.systems.0.keys() {
            // Those that it refers to come first.
            let mut open = vec![first];
            while let Some(&number) = open.last() {
                let system = frames.systems.0.get(&number).filter(|s| s.card == "CORD2R");
                let done = frames.frames.contains_key(&number) || unplaced.contains(&number);
                let Some(system) = system.filter(|_| !done) else {
                    open.pop();
                    continue;
                };
                let of = frames.frames.get(&system.of);
                let known = system.of == 0 || of.is_some();
                let to_place = !known && !unplaced.contains(&system.of);
                if to_place && frames.systems.0.get(&system.of).is_some_and(|s| s.card == "CORD2R") {
                    if open.len() > frames.systems.0.len() {
                        return Err(Fault::whole(format!(
                            "coordinate system {number} refers to itself; give its points in another"
                        )));
                    }
                    open.push(system.of);
                    continue;
                }
                open.pop();
                if known {
                    let points = system.points.map(|x| of.map_or(x, |frame| frame.place(x)));
                    let frame = Frame::through(points).ok_or_else(|| {
                        Fault::whole(format!(
                            "the points of coordinate system {number} lie on a line; move one"
                        ))
                    })?;
                    frames.frames.insert(number, frame);
                } else {
                    unplaced.insert(number);
                }
            }
        }
        Ok(frames)
    }
}

impl Frame {
    fn through([origin, on_z, in_xz]: [[f64; 3]; 3]) -> Option<Self> {
        let from = |x: [f64; 3]| [0, 1, 2].map(|i| x[i] - origin[i]);
        let cross = |a: [f64; 3], b: [f64; 3]| {
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        };
        let unit = |a: [f64; 3]| {
            let length = a.iter().map(|c| c * c).sum::<f64>().sqrt();
            (length > 0.0 && length.is_finite()).then(|| a.map(|c| c / length))
        };
        let z = unit(from(on_z))?;
        let y = unit(cross(z, from(in_xz)))?;
        Some(Frame(origin, [cross(y, z), y, z]))
    }

    fn place(&self, x: [f64; 3]) -> [f64; 3] {
        let Frame(origin, axes) = self;
        [0, 1, 2].map(|i| origin[i] + (0..3).map(|k| axes[k][i] * x[k]).sum::<f64>())
    }
}

impl Frames {
    /// The place of a point of a system in the mesh.
    ///
    /// # Errors
    /// If the system is not there, or of a kind that is not read.
    pub(super) fn place(&self, system: u64, x: [f64; 3]) -> Result<[f64; 3], String> {
        if let Some(frame) = self.frames.get(&system) {
            return Ok(frame.place(x));
        }
        Err(match self.systems.0.get(&system) {
            Some(System { card, .. }) if card != "CORD2R" => {
                format!(
                    "coordinate system {system} is a {card}; write the mesh in CORD2R or in basic coordinates"
                )
            }
            Some(System { of, .. }) => {
                format!(
                    "coordinate system {system} refers to system {of}, which is not read; write basic coordinates"
                )
            }
            None => format!("there is no coordinate system {system}; write its CORD2R, or basic coordinates"),
        })
    }
}
