//! How far each group of elements is damaged or has yielded, at the end of a run.

use crate::groups::{Group, groups};
use crate::history::History;
use crate::observers::{Cracks as Watch, onset_memory};
use crate::quantities::{MEASURES, Measure, threshold};
use crate::stacks::{Stack, stacks};
use indexmap::IndexMap;
use tremolite_engine::hexahedra::{centroid, hex};
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_engine::state::Memory;
use tremolite_laws::Role;
use tremolite_laws::parameter::position;
use tremolite_results::{Cracks, Damaged, Finding, GroupDamage, Onset, Place, Severity, snake};

/// What summaries say of damage, by group. Volumes are those of integration points, and first times go by the rows of
/// the histories.
pub fn damage(
    model: &Model,
    phase: &Phase,
    history: History,
    memory: &Memory,
) -> IndexMap<String, GroupDamage> {
    let of = |group: &Group| of_group(model, phase, history, memory, group);
    groups(model).iter().map(|group| (group.name.to_owned(), of(group))).collect()
}

fn of_group(model: &Model, phase: &Phase, history: History, memory: &Memory, group: &Group) -> GroupDamage {
    let columns = group.body.material.info().history;
    let cracks = cracks(model, phase, history, memory, group);
    let mut result = GroupDamage { volume: 0.0, measures: IndexMap::new(), cracks };
    for &element in &group.elements {
        let (Some(slot), Ok(hex)) =
            (phase.element_slot[element as usize], hex(&model.mesh, element as usize))
        else {
            continue;
        };
        result.volume += hex.volume;
        let weights: &[f64] = if slot.points == 8 { &hex.weights } else { &[hex.volume] };
        for measure in &MEASURES {
            let Some(column) = position(columns, measure.role) else { continue };
            let name = columns[column].name.to_owned();
            let found = result.measures.entry(name).or_insert_with(|| nothing(measure));
            for (value, weight) in history.values(&slot, column).zip(weights) {
                found.largest = found.largest.max(value);
                for (threshold, volume) in measure.thresholds.iter().zip(found.beyond.values_mut()) {
                    if value > *threshold {
                        *volume += weight;
                    }
                }
            }
            let first = memory.get(&onset_memory(measure)).map(|times| times[slot.element as usize]);
            if let Some(time) = first.filter(|time| time.is_finite())
                && found.first.is_none_or(|earlier| time < earlier.time)
            {
                let number = model.mesh.element_id(element as usize);
                found.first = Some(Onset { time, element: number, at: centroid(&model.mesh, element) });
            }
        }
    }
    result
}

fn nothing(measure: &Measure) -> Damaged {
    Damaged {
        beyond: measure.thresholds.iter().map(|t| (threshold(*t), 0.0)).collect(),
        largest: 0.0,
        first: None,
    }
}

/// Damage in tension beyond which a crack is open for good.
const OPEN: f64 = 0.9;

/// How wide cracks were, and whether they run through; nothing where the law knows none.
fn cracks(model: &Model, phase: &Phase, history: History, memory: &Memory, group: &Group) -> Option<Cracks> {
    let (widest, when) = (memory.get(Watch::OPENING)?, memory.get(Watch::TIME)?);
    let slot = |e: u32| phase.element_slot[e as usize];
    let place = |e: u32| Place { element: model.mesh.element_id(e as usize), at: centroid(&model.mesh, e) };
    let own = group.elements.iter().filter_map(|&e| Some((e, slot(e)?.element as usize)));
    let (element, at) = own.max_by(|a, b| widest[a.1].total_cmp(&widest[b.1]))?;
    slot(element).and_then(|s| history.with_role(&s, Role::CrackExtent))?;
    // Through an element if both points of a pair along the axis are open, of four pairs, or its one point.
    let open = |&(e, axis): &(u32, usize)| {
        let Some(slot) = slot(e) else { return false };
        let Some(column) = history.with_role(&slot, Role::TensionDamage) else { return false };
        let open: Vec<bool> = history.values(&slot, column).map(|damage| damage > OPEN).collect();
        if open.len() == 8 { (0..8).any(|p| open[p] && open[p ^ 1 << axis]) } else { open.iter().all(|o| *o) }
    };
    let stacks = stacks(&model.mesh, &group.elements);
    let through: Vec<&Stack> = stacks.iter().filter(|stack| stack.iter().all(open)).collect();
    let Place { element, at: centre } = place(element);
    Some(Cracks {
        opening: widest[at],
        widest: (widest[at] > 0.0).then_some(Onset { time: when[at], element, at: centre }),
        stacks: stacks.len() as u64,
        through: through.len() as u64,
        through_at: through.first().map(|stack| place(stack[0].0)),
    })
}

/// What became of each group that is no part of another: does it survive?
pub fn findings(model: &Model, damage: &IndexMap<String, GroupDamage>) -> Vec<Finding> {
    let whole = groups(model).into_iter().filter(|g| g.whole);
    whole.filter_map(|group| Some(finding(&group, damage.get(group.name)?))).collect()
}

fn finding(group: &Group, found: &GroupDamage) -> Finding {
    let columns = group.body.material.info().history;
    let group = group.name;
    let id = format!("damage_{}", snake(group));
    let damaged = |m: &Measure| position(columns, m.role).and_then(|at| found.measures.get(columns[at].name));
    let share = |measure: &Measure| {
        let damaged = damaged(measure)?;
        Some(damaged.beyond.get(&threshold(measure.counts)).copied().unwrap_or(0.0) / found.volume)
    };
    let mut numbers: IndexMap<String, f64> =
        MEASURES.iter().filter_map(|m| Some((format!("share_{}", snake(m.words)), share(m)?))).collect();
    // The mean of the directions repeats what cracks and crushing say.
    let told = MEASURES.iter().filter(|m| m.role != Role::MeanDamagePeak);
    let shares: Vec<String> = told
        .filter_map(|m| Some((m, share(m).filter(|share| *share > 0.0)?)))
        .map(|(m, share)| format!("{} in {} of its volume", m.words, percent(share)))
        .collect();
    let first = MEASURES
        .iter()
        .filter_map(|m| Some((m, damaged(m)?.first?)))
        .min_by(|a, b| a.1.time.total_cmp(&b.1.time));
    if first.is_none() && shares.is_empty() {
        let headline = "undamaged".to_owned();
        return Finding {
            id,
            group: group.into(),
            severity: Severity::Undamaged,
            headline,
            ..Finding::default()
        };
    }
    let mut headline = if shares.is_empty() { "hardly damaged".to_owned() } else { shares.join(", ") };
    let mut severity = Severity::Damaged;
    let mut sentences = Vec::new();
    let at = |[x, y, z]: [f64; 3]| format!("({x:.1}, {y:.1}, {z:.1}) m");
    if let Some(cracks) = &found.cracks
        && let Some(widest) = cracks.widest
    {
        numbers.extend([
            ("crack_opening".to_owned(), cracks.opening),
            ("crack_time".to_owned(), widest.time),
            ("through".to_owned(), cracks.through as f64),
            ("places".to_owned(), cracks.stacks as f64),
        ]);
        if let Some(place) = cracks.through_at {
            severity = Severity::Through;
            headline += &format!(", through the thickness at {} of {} places", cracks.through, cracks.stacks);
            sentences.push(format!("One such place is element {} at {}.", place.element, at(place.at)));
        } else if cracks.stacks > 0 {
            sentences.push("No crack runs through the thickness.".to_owned());
        }
        if cracks.is_loose() {
            sentences.push(format!(
                "Cracks open beyond {:.0} mm: pieces have come loose, which this model does not follow.",
                1e3 * Cracks::LOOSE
            ));
        } else {
            sentences.push(format!(
                "Widest crack {:.2} mm, at {:.2} s in element {} at {}.",
                1e3 * cracks.opening,
                widest.time,
                widest.element,
                at(widest.at)
            ));
        }
    }
    // Without an earthquake nothing tells when.
    if let Some((measure, onset)) = first {
        // At rest nothing is damaged at t = 0 but by stages.
        let when = match onset.time > 0.0 {
            true => format!("at {:.2} s", onset.time),
            false => "before the earthquake".to_owned(),
        };
        let (words, element) = (measure.words, onset.element);
        sentences.push(format!("First {words} {when} in element {element} at {}.", at(onset.at)));
        numbers.extend([("first_time".to_owned(), onset.time), ("first_element".to_owned(), element as f64)]);
    }
    Finding { id, group: group.into(), severity, headline, text: sentences.join(" "), numbers }
}

/// A share of a volume; small ones do not become zero.
fn percent(share: f64) -> String {
    match 100.0 * share {
        0.0 => "0 %".into(),
        x if x < 0.1 => "less than 0.1 %".into(),
        x => format!("{x:.1} %"),
    }
}
