//! What sections of linings use of their strength: at the end of stages, and most over the steps of the shaking; and the forces that are
//! left at its end.

use super::observer::{Event, Observer, Setting, StageSeen, View, Wants};
use super::section_forces::{SectionForces, slot_in};
use crate::error::RunError;
use crate::groups::groups;
use crate::plan::Plan;
use crate::sections::{Integration, Station, Steel};
use crate::strength::JudgedBy;
use indexmap::IndexMap;
use rayon::prelude::*;
use std::collections::HashMap;
use std::sync::Arc;
use tremolite_engine::Model;
use tremolite_engine::bolts::SegmentSeen;
use tremolite_engine::state::Memory;
use tremolite_results::utilisation::{UtilisationRow, write_utilisation};
use tremolite_results::{ResultFolder, SectionStrength, Used};
use tremolite_sections::{Capacity, Layer};

mod left;
mod part;

/// By stage and station N, M, Q and both utilisations, stage behind stage.
const STAGES: &str = "utilisation of stages";
/// By station over the shaking, of thrust with moment and then of shear: the largest utilisation (of infinite ones that with the largest N), its time, N, M, Q and the other
/// utilisation there and then.
const MOST: &str = "utilisation";
/// By station N and M of the last step that was seen.
const LAST: &str = "section forces of the last step";
/// Numbers a station has in each of the first two.
const OF_STAGE: usize = 5;
const OF_MOST: usize = 12;

/// Stations fewer than which are not worth sharing among threads.
const SHARED: usize = 64;

/// A station that is judged.
struct Judged {
    lining: String,
    /// As in sections.csv.
    number: u32,
    station: Station,
    bars: Vec<Steel>,
    /// The same as layers of the section.
    layers: Vec<Layer>,
    /// Which of the plan's rules.
    by: usize,
    /// What it bears before the shaking, and in it.
    still: Capacity,
    shaking: Capacity,
}

impl Judged {
    /// V_Rd \[N/m\] at a state.
    fn resistance(&self, state: &State) -> f64 {
        let capacity = if state.stage.is_some() { &self.still } else { &self.shaking };
        capacity.shear_resistance([state.forces[0], state.forces[1]])
    }
}

/// Follows utilisations and writes them.
pub struct Utilisation {
    wants: Wants,
    folder: ResultFolder,
    plan: Arc<Plan>,
    judged: Vec<Judged>,
    /// How stresses make forces, in the phase it is made for; none of what does not stand.
    integrations: Vec<Option<Integration>>,
    /// Bars in stations, each once: set and bolt.
    bars: Vec<[usize; 2]>,
    shakes: bool,
}

impl Utilisation {
    /// Nothing where no section is judged.
    pub fn new(setting: &Setting) -> Option<Self> {
        let Setting { model, assembly, phase, plan, folder, .. } = *setting;
        if plan.sections.is_empty() {
            return None;
        }
        let all = SectionForces::of(model);
        let judged = judged(model, &all, &plan.sections);
        if judged.is_empty() {
            return None;
        }
        let slot = |e: u32| slot_in(model, phase, e).map(|slot| (slot.point, slot.places));
        let integrations = judged.iter().map(|j| Integration::of(&model.mesh, &j.station, slot)).collect();
        let mut bars: Vec<[usize; 2]> =
            judged.iter().flat_map(|j| j.bars.iter().map(|bar| [bar.segment[0], bar.segment[1]])).collect();
        bars.sort_unstable();
        bars.dedup();
        let shakes = setting.shakes();
        let wants = Wants { glances: shakes, ..all.wants(model, assembly) };
        Some(Utilisation {
            wants,
            folder: folder.clone(),
            plan: plan.clone(),
            judged,
            integrations,
            bars,
            shakes,
        })
    }

    /// N, M, Q and both utilisations of every station at a time; not numbers where it does not stand.
    fn at(&self, view: &View) -> Vec<[f64; OF_STAGE]> {
        let seen: HashMap<[usize; 2], Vec<SegmentSeen>> = self
            .bars
            .iter()
            .map(|&[set, bolt]| ([set, bolt], view.assembly.bolts[set].seen(view.numbers, bolt)))
            .collect();
        let of = |(judged, integration): (&Judged, &Option<Integration>)| {
            let Some(integration) = integration else { return [f64::NAN; OF_STAGE] };
            let mut forces = integration.forces(&view.snapshot.stress);
            for bar in &judged.bars {
                let [set, bolt, segment] = bar.segment;
                let force = seen[&[set, bolt]].get(segment).map_or(0.0, |s| s.force);
                forces.iter_mut().zip(bar.shares).for_each(|(sum, share)| *sum += share * force);
            }
            let [n, m, q] = forces;
            let capacity = if self.shakes { &judged.shaking } else { &judged.still };
            [n, m, q, capacity.utilisation([n, m]), capacity.shear([n, m], q)]
        };
        let both = self.judged.par_iter().zip(&self.integrations);
        both.with_min_len(SHARED).map(of).collect()
    }

    /// Keeps what is more than before.
    fn follow(memory: &mut Memory, time: f64, now: &[[f64; OF_STAGE]]) {
        let none = || [-1.0, 0.0, 0.0, 0.0, 0.0, 0.0].repeat(2 * now.len());
        let kept = memory.entry(MOST.into()).or_insert_with(none);
        for (&[n, m, q, bending, shear], kept) in now.iter().zip(kept.chunks_exact_mut(OF_MOST)) {
            let (first, second) = kept.split_at_mut(OF_MOST / 2);
            for (used, other, kept) in [(bending, shear, first), (shear, bending, second)] {
                let unborne = used.is_infinite() && kept[0].is_infinite() && n > kept[2];
                if used > kept[0] || unborne {
                    kept.copy_from_slice(&[used, time, n, m, q, other]);
                }
            }
        }
        memory.insert(LAST.into(), now.iter().flat_map(|[n, m, ..]| [*n, *m]).collect());
    }

    fn write(&self, memory: &Memory) -> Result<(), RunError> {
        let mut rows = Vec::new();
        for (k, judged) in self.judged.iter().enumerate() {
            rows.extend(states(&self.plan, self.judged.len(), memory, k).into_iter().map(|state| {
                UtilisationRow {
                    resistance: judged.resistance(&state),
                    lining: judged.lining.clone(),
                    station: judged.number,
                    place: judged.station.place,
                    when: match (state.stage, state.by_shear) {
                        (Some(stage), _) => stage.to_owned(),
                        (None, false) => "max".into(),
                        (None, true) => "max_shear".into(),
                    },
                    time: state.time,
                    forces: state.forces,
                    bending: state.bending,
                    shear: state.shear,
                }
            }));
        }
        Ok(write_utilisation(&self.folder.utilisation(), &rows)?)
    }
}

impl Observer for Utilisation {
    fn wants(&self) -> Wants {
        self.wants.clone()
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Glance(view) => {
                let now = self.at(view);
                Utilisation::follow(memory, view.snapshot.time, &now);
                Ok(())
            }
            Event::StageEnds(StageSeen { at_rest, view, .. }) => {
                if *at_rest {
                    memory.entry(STAGES.into()).or_default().extend(self.at(view).into_iter().flatten());
                }
                self.write(memory)
            }
            Event::StagesTaken | Event::End { .. } => self.write(memory),
            _ => Ok(()),
        }
    }
}

/// The stations of linings that a rule is meant for. A station that lies under two rules in part has none.
fn judged(model: &Model, all: &SectionForces, rules: &[JudgedBy]) -> Vec<Judged> {
    let mut found = Vec::new();
    let mut number = HashMap::<&str, u32>::new();
    for ((lining, station), bars) in all.stations() {
        let next = number.entry(lining).or_default();
        *next += 1;
        let holds = |rule: &JudgedBy| rule.holds(station.stack.iter().map(|(e, _)| *e));
        let Some(by) = rules.iter().position(holds) else { continue };
        let layers: Vec<Layer> = bars.iter().filter_map(|bar| layer(model, bar)).collect();
        let rule = &rules[by];
        let capacity = |grown: f64| rule.rule.capacity(station.thickness, &layers, grown);
        found.push(Judged {
            lining: lining.clone(),
            number: *next,
            station: station.clone(),
            bars: bars.clone(),
            by,
            still: capacity(1.0),
            shaking: capacity(rule.dynamic),
            layers,
        });
    }
    found
}

/// A bar as a layer of the section; none where it runs across the thrust.
fn layer(model: &Model, bar: &Steel) -> Option<Layer> {
    let [set, bolt, segment] = bar.segment;
    let kind = &model.bolts[set].kind;
    let area = model.bolts[set].bolts[bolt].segments[segment].area * bar.shares[0];
    let depth = bar.shares[1] / bar.shares[0];
    // Less than a bar of 1 mm a metre is the slope of one that runs along.
    (area > 1e-6).then_some(Layer {
        area,
        depth,
        young: kind.young,
        yields: kind.yields,
        breaks: kind.breaks,
    })
}

/// A station's forces at one time, with what they use.
struct State<'p> {
    /// None: of the shaking.
    stage: Option<&'p str>,
    by_shear: bool,
    time: f64,
    forces: [f64; 3],
    bending: f64,
    shear: f64,
}

/// What is remembered of a station: of stages in their order, then what used most in the shaking.
fn states<'p>(plan: &'p Plan, stations: usize, memory: &Memory, k: usize) -> Vec<State<'p>> {
    let mut all = Vec::new();
    let stages = memory.get(STAGES).map_or(&[][..], Vec::as_slice);
    for (stage, rows) in plan.stages.iter().zip(stages.chunks_exact(OF_STAGE * stations)) {
        let [n, m, q, bending, shear] = std::array::from_fn(|i| rows[OF_STAGE * k + i]);
        if n.is_finite() {
            let (stage, time, forces) = (Some(stage.name.as_str()), f64::NAN, [n, m, q]);
            all.push(State { stage, by_shear: false, time, forces, bending, shear });
        }
    }
    let most = memory.get(MOST).and_then(|kept| kept.get(OF_MOST * k..OF_MOST * (k + 1)));
    for (by_shear, kept) in most.into_iter().flat_map(|kept| kept.chunks_exact(OF_MOST / 2)).enumerate() {
        if kept[0] >= 0.0 {
            let by_shear = by_shear == 1;
            let (bending, shear) = if by_shear { (kept[5], kept[0]) } else { (kept[0], kept[5]) };
            let forces = [kept[2], kept[3], kept[4]];
            all.push(State { stage: None, by_shear, time: kept[1], forces, bending, shear });
        }
    }
    all
}

/// What linings use of their strength, by lining; empty where none is judged.
pub fn strengths(model: &Model, plan: &Plan, memory: &Memory) -> IndexMap<String, SectionStrength> {
    let mut all = IndexMap::<String, SectionStrength>::new();
    if plan.sections.is_empty() {
        return all;
    }
    let forces = SectionForces::of(model);
    let judged = judged(model, &forces, &plan.sections);
    let mut heights = HashMap::<&str, [f64; 2]>::new();
    for ((lining, station), _) in forces.stations() {
        let z = station.place[2];
        let of = heights.entry(lining).or_insert([z; 2]);
        *of = [of[0].min(z), of[1].max(z)];
    }
    for (k, station) in judged.iter().enumerate() {
        let by = &plan.sections[station.by];
        let of = all.entry(station.lining.clone()).or_insert_with(|| {
            let [compression, tension] = by.rule.design(1.0);
            SectionStrength {
                code: by.code.clone(),
                grade: by.grade.clone(),
                compression,
                tension,
                steel: f64::NAN,
                unborne_thrust: f64::NAN,
                factors: by.factors(),
                plain_tension: by.rule.tension,
                yields: groups(model).iter().any(|group| group.name == station.lining),
                ..SectionStrength::default()
            }
        });
        of.stations += 1;
        of.reinforced += u64::from(station.still.reinforced());
        // Of no number and a number the number.
        of.steel = station.layers.iter().fold(of.steel, |most, layer| most.max(layer.yields));
        let states = states(plan, judged.len(), memory, k);
        let [bending, shear] = [states.iter().any(|s| s.bending > 1.0), states.iter().any(|s| s.shear > 1.0)];
        let unborne = |s: &&State| s.bending.is_infinite() || s.shear.is_infinite();
        if let Some(thrust) = states.iter().filter(unborne).map(|s| s.forces[0]).reduce(f64::max) {
            of.unborne += 1;
            // Of no number and a number the number.
            of.unborne_thrust = of.unborne_thrust.max(thrust);
        }
        let height = heights.get(station.lining.as_str()).copied().unwrap_or([station.station.place[2]; 2]);
        of.beyond += u64::from(bending || shear);
        of.beyond_bending += u64::from(bending);
        of.beyond_shear += u64::from(shear);
        for state in &states {
            let used = |value: f64| Used {
                value,
                station: station.number,
                at: station.station.place,
                stage: state.stage.unwrap_or_default().to_owned(),
                time: state.time,
                forces: state.forces,
                resistance: station.resistance(state),
                part: part::part(&station.station, height).into(),
            };
            for (most, value) in [(&mut of.bending, state.bending), (&mut of.shear, state.shear)] {
                let unborne = |most: &Used| {
                    value.is_infinite() && most.value.is_infinite() && state.forces[0] > most.forces[0]
                };
                let more = |most: &Used| value > most.value || unborne(most);
                if most.as_ref().is_none_or(more) && !value.is_nan() {
                    *most = Some(used(value));
                }
            }
        }
        left::crack(of, by, station, left::forces(plan, judged.len(), memory, k));
        left::count(of, station);
    }
    all.values_mut().for_each(left::sort);
    all
}
