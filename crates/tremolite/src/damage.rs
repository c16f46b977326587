//! How far each group of elements is damaged or has yielded, at the end of a run.

use crate::history;
use crate::model::{Model, centroid, hex};
use crate::observers::onset_memory;
use crate::phase::Phase;
use crate::quantities::{MEASURES, Measure};
use crate::state::State;
use indexmap::IndexMap;
use tremolite_results::{Damaged, GroupDamage, Onset};

/// Elements with a name.
struct Group<'a> {
    name: &'a str,
    elements: &'a [u32],
    /// Whether it is no part of another group of the same body.
    whole: bool,
}

/// Groups of the mesh that lie in one body each, and bodies that are no such group, where the law has a measure.
fn groups(model: &Model) -> Vec<Group<'_>> {
    let mut all = Vec::new();
    for body in model.user_bodies() {
        let columns = body.material.info().history;
        if !columns.iter().any(|c| MEASURES.iter().any(|m| m.column == c.name)) {
            continue;
        }
        let mut inside = vec![false; model.mesh.elements.len()];
        body.elements.iter().for_each(|&e| inside[e as usize] = true);
        let within = |elements: &[u32]| !elements.is_empty() && elements.iter().all(|&e| inside[e as usize]);
        let own: Vec<(&str, &[u32])> = model
            .mesh
            .groups
            .iter()
            .filter(|(_, elements)| within(elements))
            .map(|(name, elements)| (name.as_str(), elements.as_slice()))
            .collect();
        if !own.iter().any(|(_, elements)| elements.len() == body.elements.len()) {
            all.push(Group { name: &body.name, elements: &body.elements, whole: own.is_empty() });
        }
        // A group is whole unless a larger one (or, of two equal ones, the first) holds all of it.
        let mut whole = vec![true; own.len()];
        for (k, (_, outer)) in own.iter().enumerate() {
            let mut inside = vec![false; model.mesh.elements.len()];
            outer.iter().for_each(|&e| inside[e as usize] = true);
            for (i, (_, inner)) in own.iter().enumerate() {
                let smaller = inner.len() < outer.len() || (inner.len() == outer.len() && k < i);
                whole[i] &= !(smaller && inner.iter().all(|&e| inside[e as usize]));
            }
        }
        all.extend(own.iter().zip(whole).map(|((name, elements), whole)| Group { name, elements, whole }));
    }
    all
}

/// What summaries say of damage, by group. Volumes are those of integration points, and first times go by the rows of
/// the histories.
pub fn damage(model: &Model, phase: &Phase, state: &State) -> IndexMap<String, GroupDamage> {
    groups(model).iter().map(|group| (group.name.to_owned(), of_group(model, phase, state, group))).collect()
}

fn of_group(model: &Model, phase: &Phase, state: &State, group: &Group) -> GroupDamage {
    let mut result = GroupDamage { volume: 0.0, measures: IndexMap::new() };
    for &element in group.elements {
        let (Some(slot), Ok(hex)) =
            (phase.element_slot[element as usize], hex(&model.mesh, element as usize))
        else {
            continue;
        };
        result.volume += hex.volume;
        let weights: &[f64] = if slot.points == 8 { &hex.weights } else { &[hex.volume] };
        for measure in &MEASURES {
            let Some(column) = history::position(model, &slot, measure.column) else { continue };
            let found = result.measures.entry(measure.column.to_owned()).or_insert_with(|| nothing(measure));
            for (value, weight) in history::values(model, phase, state, &slot, column).zip(weights) {
                found.largest = found.largest.max(value);
                for (threshold, volume) in measure.thresholds.iter().zip(found.beyond.values_mut()) {
                    if value > *threshold {
                        *volume += weight;
                    }
                }
            }
            let first = state.observers.get(&onset_memory(measure)).map(|times| times[slot.element as usize]);
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
        beyond: measure.thresholds.iter().map(|t| (t.to_string(), 0.0)).collect(),
        largest: 0.0,
        first: None,
    }
}

/// A sentence for each body or part of it with a name of its own: does it survive?
pub fn verdict(model: &Model, damage: &IndexMap<String, GroupDamage>) -> String {
    let mut text = String::new();
    for group in groups(model).iter().filter(|g| g.whole) {
        let Some(found) = damage.get(group.name) else { continue };
        let mut shares = Vec::new();
        for measure in &MEASURES {
            let Some(damaged) = found.measures.get(measure.column).filter(|d| d.largest > 0.0) else {
                continue;
            };
            // What has cracked is what matters; the mean of the directions repeats it.
            if measure.column == "d_b_max" {
                continue;
            }
            let share = |t: &str| percent(damaged.beyond.get(t).copied().unwrap_or(0.0) / found.volume);
            shares.push(match measure.thresholds {
                [only] => format!("{} in {} of its volume", measure.words, share(&only.to_string())),
                _ => format!(
                    "{} beyond 0.5 in {} of its volume, beyond 0.9 in {}",
                    measure.words,
                    share("0.5"),
                    share("0.9")
                ),
            });
        }
        let first = MEASURES
            .iter()
            .filter_map(|m| Some((m, found.measures.get(m.column)?.first?)))
            .min_by(|a, b| a.1.time.total_cmp(&b.1.time));
        match first {
            Some((measure, Onset { time, element, at: [x, y, z] })) => {
                text += &format!(
                    " {}: {}; first {} at {time:.2} s in element {element} at ({x:.1}, {y:.1}, {z:.1}) m.",
                    group.name,
                    shares.join("; "),
                    measure.words
                );
            }
            None => text += &format!(" {}: undamaged.", group.name),
        }
    }
    text
}

/// A share of a volume; small ones do not become zero.
fn percent(share: f64) -> String {
    match 100.0 * share {
        0.0 => "0 %".into(),
        x if x < 0.1 => "less than 0.1 %".into(),
        x => format!("{x:.1} %"),
    }
}
