//! What an observer did not want is not a number to it: a mode for tests, in which whoever reads what it did not name shows it.

use super::observer::{StageSeen, View, Wants, Which};
use tremolite_engine::Snapshot;
use tremolite_engine::assembly::Slices;
use tremolite_engine::parts::ElementEnergy;
use tremolite_laws::{Octet, Row};

/// Copies of what a view shows, of which all that is not wanted is not a number.
pub(super) struct Unseen {
    snapshot: Snapshot,
    history: Vec<Octet>,
    numbers: Vec<f64>,
}

/// Rows by engine node, and those from which elements count.
pub(super) struct EndRows {
    u: Vec<Row>,
    start: Vec<Row>,
    last: Vec<Row>,
    reference: Vec<Row>,
}

const UNKNOWN: ElementEnergy = ElementEnergy {
    strain: f64::NAN,
    hourglass: f64::NAN,
    dissipated: f64::NAN,
    created: f64::NAN,
    band: f64::NAN,
};

impl Which {
    pub(super) fn has(&self, one: usize) -> bool {
        match self {
            Which::Nothing => false,
            Which::Some(all) => all.binary_search(&(one as u32)).is_ok(),
            Which::All => true,
        }
    }

    /// Rows of which those of others are not numbers.
    pub(super) fn rows(&self, rows: &[Row]) -> Vec<Row> {
        let own = |(node, row): (usize, &Row)| if self.has(node) { *row } else { Row([f64::NAN; 4]) };
        rows.iter().enumerate().map(own).collect()
    }
}

impl Unseen {
    pub fn of(view: &View, wants: &Wants) -> Self {
        let View { assembly, phase, snapshot, history, numbers, .. } = *view;
        let mut unseen = Unseen {
            snapshot: Snapshot {
                displacement: wants.nodes.rows(&snapshot.displacement),
                velocity: wants.nodes.rows(&snapshot.velocity),
                acceleration: wants.nodes.rows(&snapshot.acceleration),
                stress: vec![[f64::NAN; 6]; snapshot.stress.len()],
                energy: vec![UNKNOWN; snapshot.energy.len()],
                pore: vec![f64::NAN; snapshot.pore.len()],
                ..snapshot.clone()
            },
            history: vec![Octet([f64::NAN; 8]); history.octets.len()],
            numbers: vec![f64::NAN; numbers.len()],
        };
        for (_, slices) in assembly.slices.iter().enumerate().filter(|(m, _)| wants.members.has(*m)) {
            let Slices { history: octets, numbers: own, points, elements, .. } = slices;
            unseen.history[octets.clone()].copy_from_slice(&history.octets[octets.clone()]);
            unseen.numbers[own.clone()].copy_from_slice(&numbers[own.clone()]);
            unseen.snapshot.stress[points.clone()].copy_from_slice(&snapshot.stress[points.clone()]);
            unseen.snapshot.energy[elements.clone()].copy_from_slice(&snapshot.energy[elements.clone()]);
            if !snapshot.pore.is_empty() {
                unseen.snapshot.pore[elements.clone()].copy_from_slice(&snapshot.pore[elements.clone()]);
            }
        }
        for (_, slot) in phase.element_slot.iter().enumerate().filter(|(e, _)| wants.elements.has(*e)) {
            let Some(slot) = slot else { continue };
            let points = slot.point as usize..slot.point as usize + slot.points as usize;
            unseen.snapshot.stress[points.clone()].copy_from_slice(&snapshot.stress[points]);
            let element = slot.element as usize;
            unseen.snapshot.energy[element] = snapshot.energy[element];
            if let Some(&p) = snapshot.pore.get(element) {
                unseen.snapshot.pore[element] = p;
            }
            for (octet, lane) in history.places(slot) {
                unseen.history[octet].0[lane] = history.octets[octet].0[lane];
            }
        }
        for (_, slot) in phase.element_slot.iter().enumerate().filter(|(e, _)| wants.histories.has(*e)) {
            let Some(slot) = slot else { continue };
            for (octet, lane) in history.places(slot) {
                unseen.history[octet].0[lane] = history.octets[octet].0[lane];
            }
        }
        unseen
    }

    pub fn view<'v>(&'v self, view: &View<'v>) -> View<'v> {
        let history = view.history.with(&self.history);
        View { snapshot: &self.snapshot, history, numbers: &self.numbers, ..*view }
    }

    /// The rows of a stage's end that are wanted.
    pub fn rows_at_end(&self, seen: &StageSeen, wants: &Wants) -> EndRows {
        let StageSeen { view, u, start, last, reference, .. } = *seen;
        let mut own = vec![Row([f64::NAN; 4]); reference.len()];
        let of_elements = view.phase.element_slot.iter().enumerate().filter(|(e, _)| wants.elements.has(*e));
        let members = of_elements.filter_map(|(_, slot)| Some(slot.as_ref()?.member as usize));
        for member in members.chain((0..view.assembly.slices.len()).filter(|m| wants.members.has(*m))) {
            let rows = view.assembly.slices[member].reference.clone();
            own[rows.clone()].copy_from_slice(&reference[rows]);
        }
        let [u, start, last] = [u, start, last].map(|rows| wants.nodes.rows(rows));
        EndRows { u, start, last, reference: own }
    }

    pub fn stage<'v>(&'v self, seen: &StageSeen<'v>, rows: &'v EndRows) -> StageSeen<'v> {
        let EndRows { u, start, last, reference } = rows;
        StageSeen { view: self.view(&seen.view), u, start, last, reference, ..*seen }
    }
}
