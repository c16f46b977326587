//! How far each group of elements is damaged or has yielded, at the end of a run.

use crate::groups::{Group, groups};
use crate::history::History;
use crate::observers::{Cracks as Watch, onset_memory};
use crate::phrases::{listed, sentences};
use crate::places::point;
use crate::quantities::{MEASURES, Measure, threshold};
use crate::rate_factors::rate_factor;
use crate::stacks::{Stack, stacks};
use indexmap::IndexMap;
use tremolite_engine::hexahedra::{centroid, hex};
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_engine::state::Memory;
use tremolite_laws::Role;
use tremolite_laws::parameter::position;
use tremolite_results::{
    CrackDirection, Cracks, Damaged, Finding, GroupDamage, Onset, Opened, Place, Said, Severity, said, snake,
};

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
        let weights = slot.places.weights(&hex);
        for measure in &MEASURES {
            let Some(column) = position(columns, measure.role) else { continue };
            let name = columns[column].name.to_owned();
            let found = result.measures.entry(name).or_insert_with(|| nothing(measure));
            for (value, weight) in history.values(&slot, column).zip(&weights) {
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
    for measure in &MEASURES {
        let Some(column) = position(columns, measure.role) else { continue };
        if let Some(found) = result.measures.get_mut(columns[column].name) {
            found.rate = rate_factor(model, phase, &history, group, (measure.role, found.first));
        }
    }
    result
}

fn nothing(measure: &Measure) -> Damaged {
    Damaged {
        beyond: measure.thresholds.iter().map(|t| (threshold(*t), 0.0)).collect(),
        largest: 0.0,
        first: None,
        rate: None,
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
    // Of those that are equally wide the first, here and below.
    let (element, at) = own.reduce(|best, e| if widest[e.1] > widest[best.1] { e } else { best })?;
    slot(element).and_then(|s| history.with_role(&s, Role::CrackWidth))?;
    // Through an element if all points in a row along the axis are open.
    let open = |&(e, axis): &(u32, usize)| {
        let Some(slot) = slot(e) else { return false };
        let Some(column) = history.with_role(&slot, Role::TensionDamage) else { return false };
        let open: Vec<bool> = history.values(&slot, column).map(|damage| damage > OPEN).collect();
        let at: Vec<[f64; 3]> = (0..open.len()).map(|p| slot.places.natural(p)).collect();
        let in_row = |p: usize, q: usize| (1..3).all(|k| at[p][(axis + k) % 3] == at[q][(axis + k) % 3]);
        (0..open.len()).any(|p| (0..open.len()).all(|q| open[q] || !in_row(p, q)))
    };
    let stacks = stacks(&model.mesh, &group.elements);
    let through: Vec<&Stack> = stacks.iter().filter(|stack| stack.iter().all(open)).collect();
    let opening = |e: u32| slot(e).map_or(0.0, |slot| widest[slot.element as usize]);
    let wider = |best: u32, e: u32| if opening(e) > opening(best) { e } else { best };
    let last = memory.get(Watch::LAST);
    let left = |e: u32| Some(last?[slot(e)?.element as usize]);
    let worst = through.iter().flat_map(|stack| stack.iter().map(|(e, _)| *e)).reduce(wider);
    let Place { element, at: centre } = place(element);
    let rows = Watch::rows(history.assembly(), phase);
    let of_direction = |k: usize| {
        let remembered = Watch::remembered(memory);
        let row = |e: &u32| rows.get(e).filter(|_| !remembered.is_empty());
        let own = || group.elements.iter().filter_map(|e| Some((*e, Watch::opened(remembered, *row(e)?)[k])));
        let (element, most) = own().reduce(|best, e| if e.1.widest > best.1.widest { e } else { best })?;
        let Place { element, at } = place(element);
        Some(Opened {
            direction: CrackDirection::ALL[k],
            opening: most.widest,
            widest: (most.widest > 0.0).then_some(Onset { time: most.time, element, at }),
            left: own().map(|(_, opened)| opened.last).fold(0.0, f64::max),
        })
    };
    Some(Cracks {
        directions: (0..CrackDirection::ALL.len()).filter_map(of_direction).collect(),
        opening: widest[at],
        left: group.elements.iter().filter_map(|&e| left(e)).fold(f64::NAN, f64::max),
        widest: (widest[at] > 0.0).then_some(Onset { time: when[at], element, at: centre }),
        stacks: stacks.len() as u64,
        through: through.len() as u64,
        through_at: worst.map(place),
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
    let numbers = MEASURES.iter().filter_map(|m| Some((format!("share_{}", snake(m.words)), share(m)?)));
    // The mean of the directions repeats what cracks and crushing say.
    let told = MEASURES.iter().filter(|m| m.role != Role::MeanDamagePeak);
    let shares: Vec<Said> = told
        .filter_map(|m| Some((m, share(m).filter(|share| *share > 0.0)?)))
        .map(|(m, share)| match percent(share) {
            Some(percent) => {
                said!("{measure} in {percent} % of its volume", measure = words(m), percent = percent)
            }
            None => said!("{measure} in less than 0.1 % of its volume", measure = words(m)),
        })
        .collect();
    let first = MEASURES
        .iter()
        .filter_map(|m| Some((m, damaged(m)?.first?)))
        .min_by(|a, b| a.1.time.total_cmp(&b.1.time));
    if first.is_none() && shares.is_empty() {
        return Finding::new(id, group, Severity::Undamaged, said!("undamaged"), Said::default());
    }
    let mut headline = if shares.is_empty() { vec![said!("hardly damaged")] } else { shares };
    let mut severity = Severity::Damaged;
    let mut text = Vec::new();
    let cracks = found.cracks.as_ref().filter(|cracks| cracks.widest.is_some());
    if let Some(cracks) = cracks {
        if cracks.through_at.is_some() {
            severity = Severity::Through;
            headline.push(said!(
                "through the thickness at {through} of {places} places",
                through = cracks.through.to_string(),
                places = cracks.stacks.to_string(),
            ));
        }
        text.extend(of_cracks(cracks));
    }
    // Without an earthquake nothing tells when.
    text.extend(first.map(|(measure, onset)| begins(measure, &onset)));
    let mut finding = Finding::new(id, group, severity, listed(headline), sentences(text));
    finding.numbers.extend(numbers);
    if let (Some(cracks), Some(widest)) = (cracks, cracks.and_then(|cracks| cracks.widest)) {
        finding = finding
            .with("crack_opening", cracks.opening)
            .with("crack_time", widest.time)
            .with("crack_element", widest.element as f64)
            .with_place("crack", widest.at)
            .with("through", cracks.through as f64)
            .with("places", cracks.stacks as f64);
        for (name, of) in [("crack_across_bars", cracks.across()), ("crack_parallel", cracks.parallel())] {
            if let Some(of) = of {
                finding = finding.with(name, of.opening);
            }
        }
        if let Some(place) = cracks.through_at {
            finding = finding.with("through_element", place.element as f64).with_place("through", place.at);
        }
    }
    if let Some((_, onset)) = first {
        finding = finding.with("first_time", onset.time);
        if onset.time > 0.0 {
            finding = finding.with("first_element", onset.element as f64).with_place("first", onset.at);
        }
    }
    finding
}

/// Whether cracks run through, and the widest.
fn of_cracks(cracks: &Cracks) -> Vec<Said> {
    let mut text = Vec::new();
    if let Some(place) = cracks.through_at {
        text.push(said!(
            "The widest of these cracks is in element {element} at {place}.",
            element = place.element.to_string(),
            place = point(place.at),
        ));
    } else if cracks.stacks > 0 {
        text.push(said!("No crack runs through the thickness."));
    }
    let Some(widest) = cracks.widest else { return text };
    text.push(match cracks.is_loose() {
        true => said!(
            "Cracks open beyond {limit} mm, widest at {time} s in element {element} at {place}: pieces have come loose, and this model does not follow them.",
            limit = format!("{:.0}", 1e3 * Cracks::LOOSE),
            time = format!("{:.2}", widest.time),
            element = widest.element.to_string(),
            place = point(widest.at),
        ),
        false => said!(
            "Widest crack {opening} mm, at {time} s in element {element} at {place}.",
            opening = format!("{:.2}", 1e3 * cracks.opening),
            time = format!("{:.2}", widest.time),
            element = widest.element.to_string(),
            place = point(widest.at),
        ),
    });
    text.extend(directions(cracks));
    text.push(said!("The number of cracks over a length, and so their width, depends on the mesh."));
    text
}

/// Which way the widest cracks run: across bars, and parallel to the wall.
fn directions(cracks: &Cracks) -> Vec<Said> {
    let millimetres = |of: &Opened| format!("{:.2}", 1e3 * of.opening);
    let open = |of: &&Opened| of.widest.is_some() && of.opening <= Cracks::LOOSE;
    let across = cracks.across().filter(open).map(|of| match of.direction {
        CrackDirection::Longitudinal => {
            said!("Across the bars round the ring {opening} mm at most.", opening = millimetres(of))
        }
        CrackDirection::Ring => {
            said!("Across the bars along the axis {opening} mm at most.", opening = millimetres(of))
        }
        _ => said!("Where walls meet {opening} mm at most.", opening = millimetres(of)),
    });
    let parallel = cracks.parallel().filter(open).map(|of| {
        said!(
            "Parallel to the wall {opening} mm at most: no bar of the section crosses these.",
            opening = millimetres(of)
        )
    });
    across.into_iter().chain(parallel).collect()
}

/// Where and when damage began.
fn begins(measure: &Measure, onset: &Onset) -> Said {
    let (words, element, place) = (words(measure), onset.element.to_string(), point(onset.at));
    // At rest nothing is damaged at t = 0 but by stages.
    if onset.time > 0.0 {
        said!(
            "First {measure} at {time} s in element {element} at {place}.",
            measure = words,
            time = format!("{:.2}", onset.time),
            element = element,
            place = place,
        )
    } else {
        // Where first is not known: all that stages did has that time.
        said!("First {measure} before the earthquake.", measure = words)
    }
}

/// [`Measure::words`].
fn words(measure: &Measure) -> Said {
    match measure.role {
        Role::TensionDamage => said!("cracked"),
        Role::ShearDamage => said!("crushed or sheared"),
        Role::MeanDamagePeak => said!("mean principal damage"),
        Role::PlasticShear => said!("yielded in shear"),
        Role::PlasticTension => said!("yielded in tension"),
        _ => Said::plain(measure.words),
    }
}

/// A share of a volume that is not too small to tell.
fn percent(share: f64) -> Option<String> {
    let percent = 100.0 * share;
    (percent >= 0.1).then(|| format!("{percent:.1}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_loose_pieces_the_place_is_told_and_not_a_width_that_means_little() {
        let widest = Some(Onset { time: 12.9, element: 7, at: [1.0, 2.0, 3.0] });
        let told =
            |opening| sentences(of_cracks(&Cracks { opening, widest, ..Cracks::default() })).to_string();
        assert!(told(0.019).starts_with("Widest crack 19.00 mm, at 12.90 s in element 7 at"));
        let loose = told(0.0212);
        assert!(loose.starts_with("Cracks open beyond 20 mm, widest at 12.90 s in element 7 at"), "{loose}");
        assert!(!loose.contains("21.2"));
    }

    #[test]
    fn measures_are_called_in_findings_what_they_are_called_in_tables() {
        for measure in &MEASURES {
            assert_eq!(words(measure).to_string(), measure.words);
        }
    }
}
