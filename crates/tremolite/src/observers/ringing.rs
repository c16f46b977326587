//! Motion above the band of what comes in, beside interfaces: what slides may feed vibrations at the mesh's own frequencies.
//!
//! Friction follows the pressure, so a pair that slides can drive a body that rings; every piece obeys its law, the balance closes,
//! and the body slides too far. So the acceleration of the nodes of pairs is parted at [`ABOVE`] times the highest frequency of
//! the motion (99.9 % of its energy lies below), by a Butterworth filter of fourth order, step by step. An interval between rows at
//! whose ends more than half the interface is open does not count: what comes off and hits rings. Less does count, for pairs that
//! ring hop.

use super::{Observer, Schedule, Setting, Stepped, View};
use crate::error::RunError;
use crate::setup::facts::ENERGY_SHARE;
use std::ops::Range;
use tremolite_engine::model::Model;
use tremolite_engine::state::Memory;
use tremolite_motion::{Band, Filter, Section, highest_frequency};

/// Key of what this observer remembers: [`Sums`] of each interface, then [`EACH`] numbers of each node that it follows.
const MEMORY: &str = "ringing";
/// The band above begins at this many times the highest frequency that comes in.
pub const ABOVE: f64 = 2.0;
/// Share of an interface's area that is open while nothing counts.
const OPEN: f64 = 0.5;
/// Nodes followed on each side of an interface, about.
const MOST: usize = 128;
/// Sections of the filter.
const SECTIONS: usize = 2;
/// Numbers of a node: velocity of the last step, and two of each section by component.
const EACH: usize = 3 * (1 + 2 * SECTIONS);
/// Numbers of an interface.
const SUMS: usize = 8;

/// What is known of an interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ringing {
    /// Root mean squares of the acceleration above the band and below \[m/s²\], over area and the time that counts.
    pub above: f64,
    pub below: f64,
    /// Share of the shaking that counts.
    pub counted: f64,
    /// Where the band above begins \[Hz\].
    pub corner: f64,
}

impl Ringing {
    /// What was seen at an interface of the user's; nothing where no wave comes in or no row has been written.
    pub fn of(model: &Model, memory: &Memory, interface: usize) -> Option<Self> {
        let kept = memory.get(MEMORY)?.get(SUMS * interface..SUMS * (interface + 1))?;
        let &[above, below, _, _, steps, all, ..] = kept else { return None };
        (all > 0.0).then_some(())?;
        let mean = |sum: f64| if steps > 0.0 { (sum / steps).sqrt() } else { 0.0 };
        Some(Ringing { above: mean(above), below: mean(below), counted: steps / all, corner: corner(model)? })
    }
}

/// Where the band above begins \[Hz\].
fn corner(model: &Model) -> Option<f64> {
    Some(ABOVE * highest_frequency(&model.incident.as_ref()?.motion, ENERGY_SHARE)?)
}

/// A node that is followed, with its share of what is followed of its interface.
struct Followed {
    node: usize,
    share: f64,
}

/// Follows nodes of interfaces through every step.
pub struct Rings {
    schedule: Schedule,
    sections: Vec<Section>,
    /// By interface, its nodes among `followed`.
    of: Vec<Range<usize>>,
    followed: Vec<Followed>,
}

impl Rings {
    /// Nothing without interfaces, where no wave comes in, or where steps are too long for the band.
    pub fn observer(setting: &Setting) -> Option<Self> {
        let Setting { model, dt, .. } = *setting;
        if model.user_seams().is_empty() {
            return None;
        }
        let filter = Filter::design(Band::High(corner(model)?), dt).ok()?;
        let (mut of, mut followed) = (Vec::new(), Vec::new());
        for seam in model.user_seams() {
            let first = followed.len();
            let every = seam.pairs.len().div_ceil(MOST).max(1);
            let pairs = || seam.pairs.iter().step_by(every);
            let area: f64 = pairs().map(|pair| pair.area).sum();
            for pair in pairs() {
                followed.extend(pair.nodes.map(|node| Followed {
                    node: model.engine_node[node as usize] as usize,
                    share: 0.5 * pair.area / area,
                }));
            }
            of.push(first..followed.len());
        }
        Some(Rings { schedule: setting.rows(), sections: filter.sections().to_vec(), of, followed })
    }

    fn kept<'m>(&self, memory: &'m mut Memory) -> &'m mut Vec<f64> {
        let length = SUMS * self.of.len() + EACH * self.followed.len();
        memory.entry(MEMORY.into()).or_insert_with(|| vec![0.0; length])
    }
}

/// [`SUMS`] numbers in this order: squares above and below that count, those since the last row, steps that count, all steps, those
/// since the last row, and whether it was open there.
impl Observer for Rings {
    fn schedule(&self) -> Schedule {
        self.schedule
    }

    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let View { model, assembly, history, .. } = *view;
        let kept = self.kept(memory);
        for (i, (seam, contacts)) in model.user_seams().iter().zip(&assembly.contacts).enumerate() {
            let [above, below, above_now, below_now, counted, all, steps, was_open] =
                &mut kept[SUMS * i..][..SUMS]
            else {
                continue;
            };
            let open = contacts.totals(seam, history.octets).open > OPEN * seam.area();
            if !open && *was_open == 0.0 {
                *above += *above_now;
                *below += *below_now;
                *counted += *steps;
            }
            *all += *steps;
            (*above_now, *below_now, *steps, *was_open) = (0.0, 0.0, 0.0, f64::from(u8::from(open)));
        }
        Ok(())
    }

    fn stepped(&mut self, step: &Stepped, memory: &mut Memory) {
        let Stepped { du, dt, .. } = *step;
        let seams = self.of.len();
        let kept = self.kept(memory);
        let (sums, nodes) = kept.split_at_mut(SUMS * seams);
        for (sums, of) in sums.chunks_exact_mut(SUMS).zip(&self.of) {
            sums[6] += 1.0;
            for (followed, own) in
                self.followed[of.clone()].iter().zip(nodes[EACH * of.start..].chunks_exact_mut(EACH))
            {
                let velocity = du[followed.node].xyz().map(|d| d / dt);
                for (v, own) in velocity.into_iter().zip(own.chunks_exact_mut(EACH / 3)) {
                    let a = (v - own[0]) / dt;
                    own[0] = v;
                    let mut x = a;
                    for (Section { b, a }, z) in self.sections.iter().zip(own[1..].chunks_exact_mut(2)) {
                        let y = b[0] * x + z[0];
                        z[0] = b[1] * x - a[0] * y + z[1];
                        z[1] = b[2] * x - a[1] * y;
                        x = y;
                    }
                    sums[2] += followed.share * x * x;
                    sums[3] += followed.share * (a - x) * (a - x);
                }
            }
        }
    }
}
