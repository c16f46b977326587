//! Thrust, moment and shear of linings: what stages leave, and the extremes over the shaking.

mod lined;

use super::observer::{Event, Observer, Setting, StageSeen, View, Wants, Which};
use crate::error::RunError;
use crate::plan::Plan;
use crate::sections::{Levers, Station, Steel, forces};
use indexmap::IndexMap;
pub(super) use lined::lined;
use lined::steel;
use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;
use tremolite_engine::Model;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::bolts::SegmentSeen;
use tremolite_engine::member::Kind;
use tremolite_engine::phase::{ElementSlot, Phase};
use tremolite_engine::state::Memory;
use tremolite_engine::water::with_pressure;
use tremolite_results::{EFFECTIVE, LiningExtent, ResultFolder, SectionRow, write_sections};

/// Forces by station at the end of each stage, three each, stage behind stage.
const STAGES: &str = "section forces of stages";
/// By station and force over the shaking: largest with its time, smallest with its time.
const EXTREMES: &str = "section forces";
/// By station over the shaking: the thrust at the largest moment and at the smallest, the moment at the largest thrust and at
/// the smallest.
const BESIDE: &str = "thrust and moment beside each other's extremes";

/// The stations of a model's linings. Their forces are those of the concrete and of bars in it that move with it.
pub struct SectionForces {
    /// Each with the group that it is in.
    stations: Vec<(String, Station)>,
    /// The bars in each.
    steel: Vec<Vec<Steel>>,
    /// Whether stresses are effective ones: total stress and the pressure in the pores.
    effective: bool,
}

/// Keeps the forces of stations at the end of stages and their extremes in the shaking, and writes them.
pub struct SectionTable {
    wants: Wants,
    folder: ResultFolder,
    plan: Arc<Plan>,
    /// Forces of total stress, and where there are pores in linings those of effective stress.
    tables: Vec<Followed>,
}

/// Forces, with what the many times of the shaking do not change of them, by station.
struct Followed {
    sections: SectionForces,
    levers: Vec<Option<Levers>>,
}

impl SectionTable {
    /// Nothing where there are no stations.
    pub fn new(setting: &Setting) -> Option<Self> {
        let Setting { model, assembly, plan, folder, .. } = *setting;
        let sections = SectionForces::of(model);
        if sections.stations.is_empty() {
            return None;
        }
        let looks = setting.shakes().then(|| setting.rows());
        let wants = Wants { looks, ..sections.wants(model, assembly) };
        let effective = sections.effective(model);
        let followed = |sections: SectionForces| {
            let levers = match setting.shakes() {
                true => sections.levers(model, setting.phase),
                false => Vec::new(),
            };
            Followed { sections, levers }
        };
        let tables = std::iter::once(sections).chain(effective).map(followed).collect();
        Some(SectionTable { wants, folder: folder.clone(), plan: plan.clone(), tables })
    }
}

impl Observer for SectionTable {
    fn wants(&self) -> Wants {
        self.wants.clone()
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        let SectionTable { folder, plan, tables, .. } = self;
        match event {
            Event::Look(view) => {
                for Followed { sections, levers } in tables {
                    sections.follow(memory, view.snapshot.time, &sections.looked_at(view, levers));
                }
                return Ok(());
            }
            Event::StageEnds(StageSeen { at_rest: true, view, .. }) => {
                for Followed { sections, .. } in &*tables {
                    let kept = memory.entry(sections.named(STAGES)).or_default();
                    kept.extend(sections.at(view).into_iter().flatten());
                }
            }
            Event::StageEnds(_) | Event::StagesTaken | Event::End { .. } => {}
            _ => return Ok(()),
        }
        let rows: Vec<SectionRow> =
            tables.iter().flat_map(|table| table.sections.rows(plan, memory)).collect();
        Ok(write_sections(&folder.sections(), &rows)?)
    }
}

impl SectionForces {
    /// Finds the stations: of whole groups that damage, or that begin with a stage.
    pub fn of(model: &Model) -> Self {
        let stations = lined(model);
        SectionForces { steel: steel(model, &stations), stations, effective: false }
    }

    /// Those stations of linings with pores, for their forces of effective stress; nothing where no lining has any.
    fn effective(&self, model: &Model) -> Option<SectionForces> {
        let earlier = |e: &u32| model.elements.successors.get(e).copied();
        let porous = |station: &Station| {
            let elements = station.stack.iter().flat_map(|&(e, _)| std::iter::successors(Some(e), earlier));
            elements.into_iter().any(|e| model.water.is_porous(e as usize))
        };
        let own = self.stations.iter().zip(&self.steel).filter(|((_, station), _)| porous(station));
        let (stations, steel): (Vec<_>, Vec<_>) = own
            .map(|((lining, station), steel)| {
                ((format!("{lining}{EFFECTIVE}"), station.clone()), steel.clone())
            })
            .unzip();
        (!stations.is_empty()).then_some(SectionForces { stations, steel, effective: true })
    }

    /// The name of a column of the memory.
    fn named(&self, column: &str) -> String {
        if self.effective { format!("{column}{EFFECTIVE}") } else { column.into() }
    }

    /// Stresses \[Pa\] by point, of which these forces are.
    fn stresses<'v>(&self, view: &View<'v>) -> Cow<'v, [[f64; 6]]> {
        let snapshot = view.snapshot;
        if !self.effective {
            return Cow::Borrowed(&snapshot.stress);
        }
        let mut stresses = snapshot.stress.clone();
        for (e, _) in self.stations.iter().flat_map(|(_, station)| &station.stack) {
            let Some(slot) = slot_of(view, *e) else { continue };
            let p = snapshot.pore[slot.element as usize];
            for stress in &mut stresses[slot.point as usize..][..slot.points as usize] {
                *stress = with_pressure(*stress, p);
            }
        }
        Cow::Owned(stresses)
    }

    /// Middle of the mid-surface of every station \[m\].
    pub fn places(&self) -> impl Iterator<Item = [f64; 3]> {
        self.stations.iter().map(|(_, station)| station.place)
    }

    /// How far each lining extends, by the corners of its stations' faces.
    pub fn extents(&self) -> IndexMap<String, LiningExtent> {
        let mut bounds: IndexMap<&str, [[[f64; 2]; 3]; 2]> = IndexMap::new();
        for (lining, station) in &self.stations {
            let of = bounds.entry(lining).or_insert([[[f64::INFINITY, f64::NEG_INFINITY]; 3]; 2]);
            for (of, face) in of.iter_mut().zip(&station.faces) {
                for corner in face {
                    of.iter_mut().zip(corner).for_each(|(of, x)| *of = [of[0].min(*x), of[1].max(*x)]);
                }
            }
        }
        let of = |[outer, clear]: [[[f64; 2]; 3]; 2]| {
            let [outer, clear] = [outer, clear].map(|bounds| bounds.map(|[low, high]| high - low));
            LiningExtent { clear, outer }
        };
        bounds.into_iter().map(|(lining, bounds)| (lining.to_owned(), of(bounds))).collect()
    }

    /// Stations of each lining.
    pub fn counts(&self) -> IndexMap<String, u64> {
        let mut counts = IndexMap::new();
        self.stations.iter().for_each(|(lining, _)| *counts.entry(lining.clone()).or_insert(0) += 1);
        counts
    }

    /// The stations, each with the group that it is in and the bars in it.
    pub(super) fn stations(&self) -> impl Iterator<Item = (&(String, Station), &Vec<Steel>)> {
        self.stations.iter().zip(&self.steel)
    }

    /// What the forces are made of: elements, or what these were before their material changed, and bars.
    pub(super) fn wants(&self, model: &Model, assembly: &Assembly) -> Wants {
        let earlier = |e: &u32| model.elements.successors.get(e).copied();
        let stacked = self.stations.iter().flat_map(|(_, station)| &station.stack);
        let elements = stacked.flat_map(|&(e, _)| std::iter::successors(Some(e), earlier));
        let sets: HashSet<usize> = self.steel.iter().flatten().map(|bar| bar.segment[0]).collect();
        let barred = |kind| matches!(kind, Kind::Bolts(set) if sets.contains(&(set as usize)));
        Wants {
            elements: Which::some(elements.map(|e| e as usize)),
            members: Which::members(assembly, barred),
            ..Wants::default()
        }
    }

    /// What of every station's forces does not go by the stresses in a phase; nothing where it does not stand.
    fn levers(&self, model: &Model, phase: &Phase) -> Vec<Option<Levers>> {
        let places = |e: u32| slot_in(model, phase, e).map(|slot| slot.places);
        let of_station = |(_, station): &(String, Station)| {
            let stands = station.stack.iter().all(|(e, _)| places(*e).is_some());
            stands.then(|| Levers::of(&model.mesh, station, places))
        };
        self.stations.iter().map(of_station).collect()
    }

    /// Forces of every station at a time, in the order of the stations; not a number where it does not stand.
    pub fn at(&self, view: &View) -> Vec<[f64; 3]> {
        let stresses = self.stresses(view);
        let points = |e: u32| {
            let slot = slot_of(view, e)?;
            let stress = &stresses[slot.point as usize..][..slot.points as usize];
            Some((slot.places, stress))
        };
        self.with_steel(view, |_, station| {
            if station.stack.iter().any(|(e, _)| points(*e).is_none()) {
                return [f64::NAN; 3];
            }
            forces(&view.model.mesh, station, points)
        })
    }

    /// The same, to the bit, with the levers of the view's phase.
    fn looked_at(&self, view: &View, levers: &[Option<Levers>]) -> Vec<[f64; 3]> {
        let stresses = self.stresses(view);
        let points = |e: u32| {
            let slot = slot_of(view, e)?;
            Some(&stresses[slot.point as usize..][..slot.points as usize])
        };
        self.with_steel(view, |k, station| match &levers[k] {
            Some(levers) => levers.forces(station, points),
            None => [f64::NAN; 3],
        })
    }

    /// What the concrete of each station bears, and the bars in it as well.
    fn with_steel(&self, view: &View, concrete: impl Fn(usize, &Station) -> [f64; 3]) -> Vec<[f64; 3]> {
        let mut seen: HashMap<[usize; 2], Vec<SegmentSeen>> = HashMap::new();
        let mut tension = |[set, bolt, segment]: [usize; 3]| {
            let look = || view.assembly.bolts[set].seen(view.numbers, bolt);
            seen.entry([set, bolt]).or_insert_with(look).get(segment).map_or(0.0, |s| s.force)
        };
        let both = |(k, ((_, station), steel)): (usize, (&(String, Station), &Vec<Steel>))| {
            let mut sums = concrete(k, station);
            for bar in steel {
                let force = tension(bar.segment);
                sums.iter_mut().zip(bar.shares).for_each(|(sum, share)| *sum += share * force);
            }
            sums
        };
        self.stations.iter().zip(&self.steel).enumerate().map(both).collect()
    }

    /// Follows the extremes of the shaking.
    fn follow(&self, memory: &mut Memory, time: f64, forces: &[[f64; 3]]) {
        let start = || [f64::NEG_INFINITY, 0.0, f64::INFINITY, 0.0].repeat(3 * self.stations.len());
        let kept = memory.entry(self.named(EXTREMES)).or_insert_with(start);
        let mut beside = Vec::new();
        for (k, now) in forces.iter().flatten().enumerate() {
            let kept = &mut kept[4 * k..4 * k + 4];
            for (c, beyond) in [(0, *now > kept[0]), (2, *now < kept[2])] {
                if beyond {
                    (kept[c], kept[c + 1]) = (*now, time);
                    // Beside the moment, the second of the three, the thrust, and beside that the moment.
                    beside.extend(
                        [(1, 0, 0), (0, 1, 2)]
                            .into_iter()
                            .filter(|(of, ..)| k % 3 == *of)
                            .map(|(_, other, at)| (4 * (k / 3) + at + c / 2, forces[k / 3][other])),
                    );
                }
            }
        }
        let kept =
            memory.entry(self.named(BESIDE)).or_insert_with(|| vec![f64::NAN; 4 * self.stations.len()]);
        beside.into_iter().for_each(|(at, value)| kept[at] = value);
    }

    /// Rows of sections.csv from what is remembered.
    fn rows(&self, plan: &Plan, memory: &Memory) -> Vec<SectionRow> {
        let mut rows = Vec::new();
        let mut number = HashMap::<&str, u32>::new();
        let row =
            |lining: &str, number: u32, station: &Station, when: &str, time, forces, beside: [f64; 2]| {
                SectionRow {
                    lining: lining.to_owned(),
                    station: number,
                    place: station.place,
                    thickness: station.thickness,
                    thrust_at_moment: beside[0],
                    moment_at_thrust: beside[1],
                    when: when.to_owned(),
                    time,
                    forces,
                }
            };
        for (k, (lining, station)) in self.stations.iter().enumerate() {
            let next = number.entry(lining).or_default();
            *next += 1;
            let at = 3 * k;
            let stages = memory.get(&self.named(STAGES)).map_or(&[][..], Vec::as_slice);
            for (stage, forces) in plan.stages.iter().zip(stages.chunks_exact(3 * self.stations.len())) {
                let forces = [forces[at], forces[at + 1], forces[at + 2]];
                if forces.iter().all(|f| f.is_finite()) {
                    rows.push(row(
                        lining,
                        *next,
                        station,
                        &stage.name,
                        [f64::NAN; 3],
                        forces,
                        [forces[0], forces[1]],
                    ));
                }
            }
            let Some(kept) = memory.get(&self.named(EXTREMES)) else { continue };
            let of = |i: usize, c: usize| kept[4 * (at + i) + c];
            let beside = |c: usize| {
                let kept = memory.get(&self.named(BESIDE)).map(|kept| &kept[4 * k..]);
                kept.map_or([f64::NAN; 2], |kept| [kept[c / 2], kept[2 + c / 2]])
            };
            for (when, c) in [("min", 2), ("max", 0)] {
                let (forces, times) = ([0, 1, 2].map(|i| of(i, c)), [0, 1, 2].map(|i| of(i, c + 1)));
                if forces.iter().all(|f| f.is_finite()) {
                    rows.push(row(lining, *next, station, when, times, forces, beside(c)));
                }
            }
        }
        rows
    }
}

/// Where an element has its place, or what it was before its material changed; none where neither stands.
fn slot_of<'v>(view: &View<'v>, element: u32) -> Option<&'v ElementSlot> {
    slot_in(view.model, view.phase, element)
}

/// The same in a phase of a model.
pub(super) fn slot_in<'p>(model: &Model, phase: &'p Phase, element: u32) -> Option<&'p ElementSlot> {
    let earlier = |e: &u32| model.elements.successors.get(e).copied();
    std::iter::successors(Some(element), earlier).find_map(|e| phase.element_slot[e as usize].as_ref())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A station in the plane z = 0, half a metre thick.
    fn station(x: f64) -> Station {
        let faces = [[[0.0; 3]; 4]; 2];
        Station {
            stack: Vec::new(),
            place: [x, 0.0, 0.0],
            normal: [0.0, 0.0, 1.0],
            along: [1.0, 0.0, 0.0],
            thickness: 0.5,
            faces,
        }
    }

    #[test]
    fn the_thrust_of_the_largest_moment_is_that_of_its_time() {
        let stations = [1.0, 2.0].map(|x| ("hall".to_owned(), station(x))).to_vec();
        let all = SectionForces { stations, steel: vec![Vec::new(); 2], effective: false };
        let mut memory = Memory::new();
        // N, M, Q of both stations at three times; the second station's moments swing the other way.
        let rows = [
            [[-1.0, 2.0, 0.0], [-10.0, -2.0, 0.0]],
            [[-3.0, 9.0, 1.0], [-30.0, -9.0, 0.0]],
            [[-7.0, -4.0, 0.0], [-70.0, 4.0, 0.0]],
        ];
        rows.iter().enumerate().for_each(|(k, forces)| all.follow(&mut memory, k as f64, forces));
        // The thrust at the largest and the smallest moment, the moment at the largest and the smallest thrust.
        assert_eq!(memory[BESIDE], [-3.0, -7.0, 2.0, -4.0, -70.0, -30.0, -2.0, 4.0]);
        assert_eq!(memory[EXTREMES][4..8], [9.0, 1.0, -4.0, 2.0]);
    }
}
