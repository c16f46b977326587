//! What the results of a run will take on disk.

use crate::groups::groups;
use crate::observers::{BoltGrid, Depth, bolt_rows, cells};
use crate::plan::{Plan, Steps};
use crate::quantities::{Field, INTERFACE, MEASURES};
use crate::spectra;
use crate::transfer_table;
use std::collections::BTreeSet;
use tremolite_engine::Domain;
use tremolite_engine::Stage;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_kernels::Line;
use tremolite_laws::Role;
use tremolite_laws::parameter::position;
use tremolite_motion::default_periods;
use tremolite_results::CrackDirection;

/// Bytes of a number in a table with its comma, about: of 20.1 to 20.8 in monitors.csv of two cases.
const NUMBER: u64 = 21;
/// Bytes of a row of bolts.csv without the names of group and stage: eight numbers with their commas, two short ones and a word.
const BOLT_ROW: u64 = 8 * NUMBER + 16;
/// Bytes that a file has for each array beside its numbers: 203 in one of two bolts.
const HEADERS: u64 = 220;
/// What compression leaves of a field file: of its mesh a quarter (0.15 to 0.2 in two generated ones), of values that
/// have no pattern 0.93. Where a model is the same along an axis so are its values, and less than half of them is left.
const MESH_LEFT: f64 = 0.25;
const VALUES_LEFT: f64 = 0.93;

/// Bytes of the results, at most about; the page and its figures, some hundred kilobytes, left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Disk {
    /// Number of field files, and bytes of one.
    pub field_files: u64,
    pub field_file: u64,
    /// Number of those at the ends of stages.
    pub stage_files: u64,
    /// Of monitors.csv, energy.csv, damage.csv, interfaces.csv and free_field.csv, of depth.csv, transfer.csv and spectra.csv.
    pub histories: u64,
    /// Of bolts.csv and the files of bolts, of stages and of the shaking.
    pub bolts: u64,
    /// Of the checkpoint and the one before it, which are there while the run goes on and after a stop, and of the rest that another run may
    /// begin with.
    pub checkpoint: u64,
}

impl Disk {
    pub fn total(&self) -> u64 {
        (self.field_files + self.stage_files) * self.field_file
            + self.histories
            + self.bolts
            + self.checkpoint
    }
}

/// Bytes that a run by this plan will write.
pub fn disk(model: &Model, assembly: &Assembly, phase: &Phase, plan: &Plan, steps: Steps) -> Disk {
    let pores = match plan.stages.iter().any(|stage| stage.flow.is_some()) {
        true => Pores::Flowing,
        false if plan.water => Pores::Still,
        false => Pores::None,
    };
    let (mesh, values) = field_bytes(model, phase, &plan.fields, pores);
    let rows = |every: u64| steps.total.div_ceil(every) + 1;
    let totals = assembly.totals();
    let nodes = model.mesh_node.len() as u64;
    let laws: Vec<_> = model.user_bodies().iter().map(|body| body.material.info().history).collect();
    let has = |role| laws.iter().any(|history| position(history, role).is_some());
    // Envelopes with their times, onsets and cracks.
    let onsets = MEASURES.iter().filter(|m| has(m.role)).count() as u64;
    let remembered = 4 + onsets + if has(Role::CrackWidth) { 3 } else { 0 };
    // Of what cracks three numbers for each direction, by element.
    let cracking = model
        .user_bodies()
        .iter()
        .filter(|body| position(body.material.info().history, Role::CrackWidth).is_some());
    let directions = 12 * cracking.map(|body| body.elements.len() as u64).sum::<u64>();
    let state = 8 * (totals.history.end + totals.overstress.end + totals.initial.end)
        + 4 * totals.reference.end
        + totals.numbers.end;
    let kept = 9 * nodes + state as u64;
    // Where results count from, what is held, where a relaxation began; what parts did at the hand-over.
    let more = if plan.stages.is_empty() { 0 } else { 12 * nodes + 8 * totals.contributions.end as u64 };
    let rest = if plan.stages.is_empty() { 0 } else { kept + 12 * nodes };
    let shaken = plan.duration > 0.0;
    Disk {
        field_files: steps.snapshots.filter(|_| shaken).map_or(0, rows),
        stage_files: plan.stages.len() as u64,
        field_file: (MESH_LEFT * mesh as f64 + VALUES_LEFT * values as f64) as u64,
        histories: NUMBER
            * ((plan.stages.len() as u64 + if shaken { rows(steps.histories) } else { 0 })
                * columns(model, plan)
                + if shaken { along_depth_and_period(model, plan) } else { 0 }),
        bolts: bolts(model, plan, steps),
        checkpoint: 8 * (2 * (kept + more + remembered * totals.elements.end as u64 + directions) + rest),
    }
}

/// Bytes of all that is written of bolts.
fn bolts(model: &Model, plan: &Plan, steps: Steps) -> u64 {
    if model.bolts.is_empty() {
        return 0;
    }
    let name = model.bolts.iter().map(|set| set.kind.name.len()).max().unwrap_or(0) as u64;
    let stage = plan.stages.iter().map(|stage| stage.name.len()).max().unwrap_or(0).max(10) as u64;
    let file = |stage: Stage| bolt_file(&BoltGrid::of(&model.bolts, stage));
    let row = BOLT_ROW + name + stage;
    let table = |stage: Stage| row * bolt_rows(&model.bolts, stage) as u64;
    let before = (0..plan.stages.len()).map(|k| Stage::Before(k as u16));
    let before: u64 = before.map(|stage| file(stage) + table(stage)).sum();
    if plan.duration == 0.0 {
        return before;
    }
    let looks = steps.total.div_ceil(steps.snapshots.unwrap_or(steps.total)) + 1;
    let files = if steps.snapshots.is_some() { looks } else { 0 };
    before + files * file(Stage::Shaking) + looks * table(Stage::Shaking)
}

/// Bytes of a file of bolts; of none where nothing is placed.
fn bolt_file(grid: &BoltGrid) -> u64 {
    if grid.is_empty() {
        return 0;
    }
    let (pattern, values) = grid.bytes();
    HEADERS * grid.arrays() + (MESH_LEFT * pattern as f64 + VALUES_LEFT * values as f64) as u64
}

/// Columns of all tables.
fn columns(model: &Model, plan: &Plan) -> u64 {
    let monitors = 1 + cells(plan).len();
    let interfaces =
        if model.user_seams().is_empty() { 0 } else { 1 + INTERFACE.len() * model.user_seams().len() };
    let damage: usize = groups(model)
        .iter()
        .filter(|group| group.whole)
        .map(|group| {
            let history = group.body.material.info().history;
            // Cracks of any direction, and of each.
            let cracks = std::iter::repeat_n(Role::CrackWidth, 1 + CrackDirection::ALL.len());
            let roles = MEASURES.iter().map(|m| m.role).chain(cracks);
            roles.filter(|role| position(history, *role).is_some()).count()
        })
        .sum();
    // Time; by column of ground top and base along three axes, measured and by theory; the model's corners and their mean; the
    // free field beside each monitor.
    let beside = if model.outside.columns.is_empty() {
        0
    } else {
        3 * plan.monitors.len() + 3 * usize::from(plan.recorded.is_some())
    };
    let free_field = if model.boundaries.incident.is_some() {
        // An equivalent-linear column has two more.
        1 + 12 * model.outside.columns.len() + 2 + 30 + beside
    } else if plan.waves.is_some() {
        // Time; the field and the model at two places of four corners along three axes; the field at each monitor.
        1 + 48 + 3 * plan.monitors.len()
    } else {
        0
    };
    (monitors + interfaces + 1 + Line::ALL.len() + 1 + damage + free_field) as u64
}

/// Numbers of depth.csv, transfer.csv and spectra.csv.
fn along_depth_and_period(model: &Model, plan: &Plan) -> u64 {
    if plan.shaken_by(model).is_none() {
        return 0;
    }
    let depth = Depth::of(model, plan).map_or(0, |depth| depth.numbers());
    let points = spectra::points(plan, !model.outside.columns.is_empty()).len();
    let transfer = plan.recorded.as_ref().map_or(0, transfer_table::numbers);
    (depth + transfer + default_periods().len() * (1 + 3 * points)) as u64
}

/// What pores of the ground have, by which fields are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pores {
    None,
    /// Water.
    Still,
    /// Water that flows.
    Flowing,
}

/// Bytes of a field file before compression: of the mesh with its groups, and of values.
pub fn field_bytes(model: &Model, phase: &Phase, fields: &[Field], pores: Pores) -> (u64, u64) {
    let active = |element: &u32| phase.element_slot[*element as usize].is_some();
    let cells = phase.element_slot.iter().flatten().count() as u64;
    let history = || model.user_bodies().iter().flat_map(|body| body.material.info().history);
    let cracks = history().any(|column| column.role == Role::CrackWidth);
    let (mut of_node, mut of_cell) = (0, 0);
    for field in fields {
        let (node, cell) = match field {
            Field::Displacement | Field::Velocity | Field::Acceleration => (3, 0),
            Field::Stress => (0, 6),
            Field::Seepage => (0, if pores == Pores::Flowing { 3 } else { 0 }),
            Field::Principal => (0, if pores == Pores::None { 2 } else { 5 }),
            Field::Envelope => (1, 2),
            // Two widths; which way the widest runs is a byte.
            Field::Damage => (0, 2 * u64::from(cracks)),
            Field::Plastic | Field::History | Field::Interface => (0, 0),
        };
        of_node += node;
        of_cell += cell;
    }
    let ways = if cracks && fields.contains(&Field::Damage) { cells } else { 0 };
    let kept = history().filter(|column| fields.iter().any(|field| field.holds(column)));
    of_cell += kept.map(|column| column.name).collect::<BTreeSet<_>>().len() as u64;
    // Coordinates; corners, where they end, type, element and body; a mark for each group.
    let nodes = model.nodes.of(Domain::Model).count() as u64;
    let groups = model.mesh.groups.values().filter(|elements| elements.iter().any(active)).count() as u64;
    (24 * nodes + (8 * 8 + 8 + 1 + 8 + 4 + groups) * cells, 4 * (of_node * nodes + of_cell * cells) + ways)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::support::tests::{set, under};
    use tremolite_engine::bolts::{BoltSet, SegmentSeen};

    /// Bolts that point this way and that, as in a vault, under forces without a pattern.
    fn vault(bolts: u32) -> Vec<BoltSet> {
        let mut sets =
            vec![set("crown", bolts, Stage::Before(0), 4e8), set("walls", 1, Stage::Before(0), 4e8)];
        for (b, bolt) in sets[0].bolts.iter_mut().enumerate() {
            let (angle, along) = (0.37 * b as f64, 1.5 * (b / 20) as f64);
            for point in &mut bolt.points {
                let r = 10.0 + point.at;
                point.place = [r * angle.sin(), along, r * angle.cos()];
            }
        }
        sets
    }

    #[test]
    fn files_of_bolts_take_no_more_than_was_foretold() {
        let folder = tempfile::tempdir().unwrap();
        let noise = |k: usize| (k as f64 * 12.9898).sin() * 43_758.545 % 1.0;
        for bolts in [1, 30, 2400] {
            let sets = vault(bolts);
            let grid = BoltGrid::of(&sets, Stage::Shaking);
            let look = |_: usize, bolt: usize| -> Vec<SegmentSeen> {
                let of = |s: usize| SegmentSeen {
                    slip: noise(bolt * 7 + s),
                    largest_slip: noise(bolt * 5 + s),
                    ..under(1e5 * noise(bolt * 3 + s))
                };
                (0..3).map(of).collect()
            };
            let filled =
                grid.filled(&sets, &look, |point| point.place.map(|x| 1e-3 * noise((1e4 * x) as usize)));
            let path = folder.path().join("a.vtu");
            filled.write(&path).unwrap();
            let (real, told) = (std::fs::metadata(&path).unwrap().len(), bolt_file(&grid));
            assert!(real <= told && real > told / 2, "{bolts} bolts: {real} bytes, foretold {told}");
        }
    }
}
