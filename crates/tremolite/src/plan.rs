//! What a run does in time and what it writes; the counterpart of [`crate::Problem`], which is what it runs on.

use crate::deconvolution::Place;
use crate::quantities::Field;
use crate::stages::PlannedStage;
use crate::strength::JudgedBy;
use crate::waves::{Entering, Frame, ObliqueField};
use indexmap::IndexMap;
use std::sync::Arc;
use tremolite_engine::model::Model;
use tremolite_mesh::locate::Location;
use tremolite_motion::{Complex64, Motion, Sample};
use tremolite_results::{PageWish, TargetSpectrum};

/// A point whose histories are kept.
#[derive(Clone, Debug)]
pub struct Monitor {
    pub name: String,
    /// Where it was asked for \[m\].
    pub point: [f64; 3],
    /// The element of the mesh it lies in.
    pub location: Location,
}

/// A pair of an interface whose histories are kept: the nearest to a point.
#[derive(Clone, Debug)]
pub struct PairMonitor {
    pub name: String,
    /// Where it was asked for \[m\].
    pub point: [f64; 3],
    /// Index among the problem's interfaces.
    pub interface: usize,
}

/// A segment of a bolt whose histories are kept: the nearest to a point.
#[derive(Clone, Debug)]
pub struct BoltMonitor {
    pub name: String,
    /// Where it was asked for \[m\].
    pub point: [f64; 3],
    /// Index among the problem's bolts.
    pub set: usize,
}

/// A motion that was recorded on or within layered ground, from which the wave that comes in was deconvolved.
#[derive(Clone, Debug)]
pub struct Recorded {
    /// As it is given, on the time of the run.
    pub motion: Motion,
    /// The ground, and where in it.
    pub place: Place,
    /// The corner of the model whose own ground that is ([`tremolite_engine::column::corner_at`]); none where it is another.
    pub corner: Option<usize>,
    /// Up to which frequency the record was wanted \[Hz\].
    pub band: f64,
}

/// Waves at angles that shake a model.
#[derive(Clone)]
pub struct PlannedWaves {
    pub field: Arc<ObliqueField>,
    pub frame: Frame,
    pub waves: Vec<Entering>,
    /// The motion that is given, in the model's axes, on the time of the run.
    pub motion: Motion,
    /// What all waves together do at their common place at the base, without what the ground sends back.
    pub incident: Motion,
}

impl PlannedWaves {
    /// Of a field, and the motion on the time of the record, in the model's axes. It goes on until the last corner of the base has had it.
    pub fn new(field: ObliqueField, frame: Frame, waves: Vec<Entering>, given: &Motion) -> PlannedWaves {
        let rows = (field.lead() / given.dt).round() as usize;
        let behind = (field.late() / given.dt).ceil() as usize;
        let after: Vec<Sample> =
            (1..=behind).map(|k| given.at(given.duration() + k as f64 * given.dt)).collect();
        let late = |columns: &[Vec<f64>; 3], of: fn(&Sample) -> [f64; 3]| {
            [0, 1, 2].map(|axis| {
                let after = after.iter().map(|sample| of(sample)[axis]);
                std::iter::repeat_n(0.0, rows).chain(columns[axis].iter().copied()).chain(after).collect()
            })
        };
        let motion = Motion {
            dt: given.dt,
            acceleration: late(&given.acceleration, |sample| sample.a),
            velocity: late(&given.velocity, |sample| sample.v),
            displacement: late(&given.displacement, |sample| sample.u),
        };
        let incident = incident(&waves, rows, &motion);
        PlannedWaves { field: Arc::new(field), frame, waves, motion, incident }
    }
}

/// The sum of waves at their common place, put off by so many rows as the motion was; as long as that.
fn incident(waves: &[Entering], rows: usize, motion: &Motion) -> Motion {
    let count = motion.acceleration[0].len();
    let mut sum = motion.clone().scaled(0.0);
    for wave in waves {
        let moves = wave.heading.polarisation();
        let own = &*wave.motion;
        let kinds = [
            (&mut sum.acceleration, &own.acceleration),
            (&mut sum.velocity, &own.velocity),
            (&mut sum.displacement, &own.displacement),
        ];
        for (sum, own) in kinds {
            let late = |part: fn(&Complex64) -> f64| {
                let own = (0..own[0].len()).map(move |k| wave.sum([0, 1, 2].map(|axis| own[axis][k]), part));
                std::iter::repeat_n(0.0, rows).chain(own)
            };
            let mut carried: Vec<f64> = late(|factor| factor.re).collect();
            if wave.turns() {
                // Turned in phase, as a surface beyond the critical angle turns it.
                let padded: Vec<f64> =
                    late(|factor| factor.im).chain(std::iter::repeat_n(0.0, 3 * count)).collect();
                let turned = tremolite_motion::transferred(&padded, motion.dt, &|_| Complex64::i());
                carried.iter_mut().zip(turned).for_each(|(x, turned)| *x += turned);
            }
            for (sum, share) in sum.iter_mut().zip(moves) {
                sum.iter_mut().zip(&carried).for_each(|(sum, x)| *sum += share * x);
            }
        }
    }
    sum
}

impl std::fmt::Debug for PlannedWaves {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("PlannedWaves").field("frame", &self.frame).finish_non_exhaustive()
    }
}

/// Elements of a field file at most, unless a plan says otherwise: some 50 MB on the disk and a quarter of a GB while it is written.
pub const FIELD_ELEMENTS: usize = 250_000;

/// Times and outputs of a run.
#[derive(Clone, Debug)]
pub struct Plan {
    pub title: String,
    /// How the page is to be set.
    pub page: PageWish,
    /// Where → the boundary there while the ground shakes, in words for the summary.
    pub boundaries: IndexMap<String, String>,
    /// The spectrum that the design calls for, for the page.
    pub target: Option<TargetSpectrum>,
    /// Before the earthquake: the equilibrium of what is there at the start, then what is changed; none for a run from rest
    /// without stress.
    pub stages: Vec<PlannedStage>,
    /// Simulated time \[s\]; 0 for no earthquake.
    pub duration: f64,
    /// The motion that was recorded on or within layered ground; none where the wave that comes in is the one given times a
    /// factor.
    pub recorded: Option<Recorded>,
    /// Waves at angles, which make the free field; none where one rises straight up.
    pub waves: Option<PlannedWaves>,
    /// Time between rows of the histories \[s\]; a whole number of steps.
    pub histories: f64,
    /// Time between field files \[s\]; rounded to whole intervals of the histories.
    pub snapshots: Option<f64>,
    pub fields: Vec<Field>,
    /// Elements of a field file at most: a model of more has its fields in pieces of so many.
    pub field_elements: usize,
    /// Wall-clock time between checkpoints \[s\].
    pub checkpoint: Option<f64>,
    pub monitors: Vec<Monitor>,
    /// Behind them in monitors.csv.
    pub pairs: Vec<PairMonitor>,
    /// Behind these.
    pub bolts: Vec<BoltMonitor>,
    /// So many of the problem's groups of bolts, the last ones, are reinforcement.
    pub bars: usize,
    /// Whether there is water in the ground, of which results then tell as well.
    pub water: bool,
    /// By which codes sections of linings are judged.
    pub sections: Vec<JudgedBy>,
    /// Pairs of monitors whose relative displacement is kept.
    pub relatives: Vec<[usize; 2]>,
}

/// The plan in steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Steps {
    /// Steps of the finest level in the whole run.
    pub total: u64,
    /// Steps between rows of the histories.
    pub histories: u64,
    /// Steps between field files.
    pub snapshots: Option<u64>,
}

impl Plan {
    /// The motion that shakes a model, in its axes, on the time of the run: the wave that rises, to be taken times a factor, or what
    /// waves at angles carry. None without an earthquake.
    pub fn shaken_by<'a>(&'a self, model: &'a Model) -> Option<&'a Motion> {
        let rises = model.boundaries.incident.as_ref().map(|incident| &incident.motion);
        rises.or(self.waves.as_ref().map(|waves| &waves.motion))
    }

    /// By how much waves at angles come later to the model's last corner than where [the motion](Plan::shaken_by) is given \[s\].
    pub fn late(&self) -> f64 {
        self.waves.as_ref().map_or(0.0, |waves| waves.field.late())
    }

    /// Whether fields of a model of so many elements are written in pieces.
    pub fn in_pieces(&self, elements: usize) -> bool {
        elements > self.field_elements
    }

    /// The file of fields of such a model, by its name without an ending: the fields themselves, or a list of their pieces.
    pub fn field_file(&self, name: &str, elements: usize) -> String {
        format!("{name}.{}", if self.in_pieces(elements) { "pvtu" } else { "vtu" })
    }

    /// Time between rows of the histories \[s\] where steps of the finest level are stable up to `step` \[s\]: as asked for, or every one.
    pub fn row(&self, step: f64) -> f64 {
        self.histories.max(step)
    }

    /// The step of the finest level to use, at most `longest` \[s\], so that rows of the histories, `row` \[s\] apart, fall on steps of
    /// the coarsest, in one of which are `span`; and the plan in steps.
    pub fn steps(&self, row: f64, longest: f64, span: u64) -> (f64, Steps) {
        let histories = steps_of_row(row, longest, span);
        let dt = row / histories as f64;
        let total = span * (self.duration / dt / span as f64).round().max(1.0) as u64;
        let snapshots = self.snapshots.map(|every| (every / row).round().max(1.0) as u64 * histories);
        (dt, Steps { total, histories, snapshots })
    }
}

/// Steps of the finest level between rows that are `row` \[s\] apart: the fewest of `longest` \[s\] at most that are a multiple of `span`,
/// the steps in one of the coarsest level.
pub fn steps_of_row(row: f64, longest: f64, span: u64) -> u64 {
    let spans = (row / longest / span as f64).ceil().max(1.0);
    spans as u64 * span
}
