//! What looks at a run: what an observer wants to be shown and when is apart from what it does with it.

mod apart;
mod audience;
mod bolt_fields;
mod bolts;
mod cracks;
mod depth;
mod energy;
mod envelopes;
mod fibres;
mod fields;
mod free_field;
mod growth;
mod histories;
mod interfaces;
mod observer;
mod onsets;
mod own_tables;
mod pore_water;
pub mod recorded;
mod ringing;
mod rows;
mod run_table;
mod section_forces;
mod spectra;
mod stages;
mod steps;
mod unseen;
mod utilisation;
mod wishes;

pub(crate) use apart::Apart;
pub(crate) use audience::Audience;
pub use bolt_fields::{BoltFields, BoltGrid};
pub use bolts::{BoltForces, BoltsOfStages, count as bolt_rows};
pub use cracks::Cracks;
pub use depth::{Depth, DepthPeaks};
pub use energy::{Energy, MEMORY as ENERGY_MEMORY};
pub use envelopes::Envelopes;
pub use fibres::Fibres;
pub use fields::Fields;
pub use free_field::{
    AtCorners, ColumnSeen, FreeField, FreeFieldSeen, NoColumn, Theory, YieldingSeen, chosen,
};
pub use growth::Growth;
pub use histories::Histories;
pub use interfaces::{InterfaceFields, Interfaces};
pub use observer::{
    CycleMade, Event, Keeps, MakeObserver, Observer, OwnObservers, Schedule, Setting, StageSeen, Stepped,
    View, Wants, Which,
};
pub use onsets::{Onsets, memory_key as onset_memory};
pub use own_tables::add_row;
pub(crate) use own_tables::forget as forget_own_tables;
pub use pore_water::{Extreme as WaterExtreme, PoreWater, PoreWaterSeen, undrained};
pub use ringing::{Ringing, Rings};
pub use rows::{Cell, Seen, cells};
pub use run_table::RunTable;
pub(crate) use run_table::check as check_tables;
pub use section_forces::{SectionForces, SectionTable};
pub use spectra::Spectra;
pub(crate) use stages::write_tables as write_stage_tables;
pub use stages::{Beginning, Beside, summaries, uneven};
pub use steps::{Extremes, StepPeaks};
pub use utilisation::{Utilisation, strengths};
pub(crate) use wishes::LaidOut;

pub use tremolite_results::CrackDirection;

use crate::error::RunError;
use stages::{Begins, BesidePlanes, Relaxation, StageGrids, StageRows};
use std::sync::Arc;

/// What an entry of the lists makes.
type Made = Result<Option<Box<dyn Observer>>, RunError>;

/// Boxes an observer that may be none.
fn boxed<O: Observer + 'static>(observer: Option<O>) -> Made {
    Ok(observer.map(|observer| Box::new(observer) as Box<dyn Observer>))
}

/// The program's own observers of a stage, in the order in which they are told.
const OF_STAGES: &[fn(&Setting) -> Made] = &[
    |s| boxed(Some(StageGrids::new(s))),
    |s| boxed(Some(StageRows::new(s))),
    |s| boxed(Some(Relaxation::new(s))),
    |s| boxed(Some(Begins::new(s))),
    |s| boxed(BesidePlanes::new(s)),
    |s| boxed(BoltsOfStages::new(s)),
    |s| boxed(SectionTable::new(s)),
    |s| boxed(Utilisation::new(s)),
];

/// Those of the shaking that look at each node and element by itself, of which each of several ranks has its own part. They are told first: others
/// read what they keep.
const APART: &[fn(&Setting) -> Made] = &[|s| boxed(Some(Envelopes::new(s))), |s| boxed(Onsets::new(s))];

/// Others of the shaking.
const OF_SHAKING: &[fn(&Setting) -> Made] = &[
    |s| boxed(Some(Histories::new(s)?)),
    |s| boxed(Some(StepPeaks::new(s))),
    |s| boxed(Some(Energy::new(s)?)),
    |s| boxed(PoreWater::new(s)),
    |s| boxed(FreeField::new(s)?),
    |s| boxed(AtCorners::new(s)?),
    |s| boxed(recorded::AtRecord::new(s)),
    |s| boxed(DepthPeaks::new(s)),
    |s| boxed(Cracks::new(s)),
    |s| boxed(Fibres::new(s)),
    // Behind the cracks, whose widths it writes.
    |s| boxed(Growth::new(s)?),
    |s| boxed(Fields::new(s)?),
    |s| boxed(SectionTable::new(s)),
    |s| boxed(Utilisation::new(s)),
    |s| boxed(Interfaces::new(s)?),
    |s| boxed(Rings::new(s)),
    |s| boxed(InterfaceFields::new(s)?),
    |s| boxed(BoltForces::new(s)?),
    |s| boxed(BoltFields::new(s)?),
    // Behind the histories, which it reads.
    |s| boxed(Spectra::new(s)),
];

/// Observers of the shaking that this list makes.
fn of_shaking(list: &'static [fn(&Setting) -> Made]) -> impl Iterator<Item = Arc<MakeObserver>> {
    list.iter().map(|&make| -> Arc<MakeObserver> {
        Arc::new(move |setting: &Setting| if setting.shakes() { make(setting) } else { Ok(None) })
    })
}

/// The program's own observers.
pub fn observers() -> OwnObservers {
    observers_among_ranks().concat()
}

/// The same: those of which each of several ranks has its own part, and others.
pub(crate) fn observers_among_ranks() -> [OwnObservers; 2] {
    let of_stages = OF_STAGES.iter().map(|&make| -> Arc<MakeObserver> {
        Arc::new(move |setting: &Setting| if setting.shakes() { Ok(None) } else { make(setting) })
    });
    // Whoever goes on with a run, also without the program that adds to them.
    let own: Arc<MakeObserver> = Arc::new(|setting: &Setting| own_tables::cut_back(setting).map(|()| None));
    let others = std::iter::once(own).chain(of_stages).chain(of_shaking(OF_SHAKING)).collect();
    [of_shaking(APART).collect(), others]
}
