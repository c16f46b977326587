//! The energy balance: what is booked step by step, and what it says where somebody looks.

use super::evaluation::{Forces, Probed, Works};
use super::nodes::NodeSums;
use super::{BodyBooks, Engine, Snapshot, guard, nodes};
use crate::parts::{ElementEnergy, Kept, Motion};
use crate::state::{Ledger, State};
use tremolite_kernels::{Booked, Line, Lines};

impl Engine {
    /// What the counted parts hold, have dissipated and created, by line: by element, and what else they report; and of the
    /// elements of each account.
    pub(super) fn held(&self, state: &State, kept: Kept, energy: &[ElementEnergy]) -> (Lines, Vec<Lines>) {
        let mut held = Lines::default();
        let mut bodies = vec![Lines::default(); self.assembly.accounts.len()];
        let motion = Motion { u: &state.u, du: &state.du };
        for &m in &self.phase.active {
            let (member, slices) = (&self.assembly.members[m as usize], &self.assembly.slices[m as usize]);
            if !member.counted {
                continue;
            }
            let mut own = Lines::default();
            for element in &energy[slices.elements.clone()] {
                own[Line::Strain] += element.strain;
                own[Line::Hourglass] += element.hourglass;
                own[Line::Dissipated] += element.dissipated;
                own[Line::Created] += element.created;
                own[Line::Band] += element.band;
            }
            if let Some(account) = self.assembly.account[m as usize] {
                let body = &mut bodies[account as usize];
                *body = *body + own;
            }
            held = held + own + member.part.energy(&motion, slices.kept(&kept));
        }
        (held, bodies)
    }

    /// What is seen at a state, from the forces just evaluated there, what parts remember and what was probed.
    pub(super) fn snapshot(&self, state: &State, kept: Kept, probed: Probed) -> Snapshot {
        let Forces { contributions, rates, works: work, .. } = &self.forces;
        let (sums, velocity, acceleration) =
            nodes::measure(&self.model, &self.phase, contributions, &rates.products, state);
        let (held, bodies) = self.held(state, kept, &probed.energy);
        let (given, given_bodies) = self.given(state);
        let taken = sums.dampings();
        let mut put_in = work.lines;
        put_in[Line::FreeField] -= sums.free_field;
        let (ledger, mut balance) = (&state.ledger, Lines::default());
        for &line in Line::ALL {
            balance[line] = match line.booked() {
                Booked::Motion => sums.kinetic,
                Booked::Stored => held[line] - ledger.lines[line] - given[line],
                Booked::Spent => held[line] - ledger.lines[line],
                Booked::Damping => ledger.lines[line] + taken[line],
                Booked::Work => ledger.lines[line] + line.sign() * (put_in[line] - given[line]),
                Booked::Start => ledger.lines[line],
                Booked::Rest => 0.0,
            };
        }
        balance[Line::Error] = balance.sum();
        let bodies = bodies
            .into_iter()
            .enumerate()
            .map(|(k, mut held)| {
                let work = ledger.bodies[k] + sums.bodies[k] - work.viscosity[k] - given_bodies[k].sum();
                for &line in Line::ALL {
                    held[line] -= ledger.rest[k][line] + given_bodies[k][line];
                }
                BodyBooks { work, held }
            })
            .collect();
        let kinetic = guard::kinetic(&self.model, &self.phase, state);
        let stored = Line::ALL.iter().filter(|line| line.booked() == Booked::Stored);
        Snapshot {
            step: state.steps(),
            time: state.time(),
            displacement: (0..state.u.len()).map(|node| state.shown(node)).collect(),
            velocity,
            acceleration,
            stress: probed.stress,
            energy: probed.energy,
            scheme: sums.scheme,
            held: kinetic + stored.map(|&line| balance[line]).sum::<f64>(),
            supplied: ledger.supplied + work.supplied(),
            balance,
            bodies,
        }
    }
}

impl Ledger {
    /// Books a step: the parts' own work, and what the node pass found.
    pub(super) fn book(&mut self, work: &Works, sums: &NodeSums) {
        let taken = sums.dampings();
        for &line in Line::ALL {
            match line.booked() {
                Booked::Work => self.lines[line] += line.sign() * work.lines[line],
                Booked::Damping => self.lines[line] += taken[line],
                Booked::Motion | Booked::Stored | Booked::Spent | Booked::Start | Booked::Rest => {}
            }
        }
        self.lines[Line::FreeField] += sums.free_field;
        self.supplied += work.supplied() + sums.free_field.max(0.0);
        for ((own, more), viscosity) in self.bodies.iter_mut().zip(&sums.bodies).zip(&work.viscosity) {
            *own += more - viscosity;
        }
    }
}
