//! What is told of groups of bolts.

use super::{BoltSeen, Look, seen};
use crate::phrases::{clauses, sentences};
use crate::places::point;
use crate::plan::{BoltMonitor, Plan};
use indexmap::IndexMap;
use tremolite_engine::Stage;
use tremolite_engine::bolts::{BoltSet, SegmentState};
use tremolite_results::{BoltPeak, BoltPlace, BoltSummary, EARTHQUAKE, Finding, Said, Severity, said, snake};

/// Every group of bolts: `stage` is the last that the run came to, if any; `look` sees how they stand then, and `peaks` has
/// the largest force of each group and the same over what it yields at.
pub fn bolts(
    sets: &[BoltSet],
    plan: &Plan,
    stage: Option<Stage>,
    look: &Look,
    peaks: &[(BoltPeak, f64)],
) -> IndexMap<String, BoltSummary> {
    let seen = stage.map_or_else(|| vec![Vec::new(); sets.len()], |stage| seen(sets, stage, look));
    let of = |(k, set): (usize, &BoltSet)| {
        let mut told = given(set, plan);
        told.bars = k + plan.bars >= sets.len();
        told.there = stage.is_some_and(|stage| set.kind.born <= stage);
        let count = |is: fn(&BoltSeen) -> bool| seen[k].iter().filter(|bolt| is(bolt)).count() as u64;
        told.yielded = count(|bolt| bolt.yielded);
        told.broken = count(|bolt| bolt.broken);
        told.slid = count(|bolt| bolt.slid);
        told.cut = count(|bolt| bolt.cut_off > 0.0);
        told.gone = count(|bolt| bolt.state == SegmentState::CutOff);
        told.max_slip = seen[k].iter().fold(0.0, |most, bolt| bolt.slip.max(most));
        if let Some((peak, over)) = peaks.get(k) {
            (told.largest, told.force_over_yield) = (peak.clone(), *over);
        }
        (set.kind.name.clone(), told)
    };
    sets.iter().enumerate().map(of).collect()
}

/// What is known of a group before it is loaded.
fn given(set: &BoltSet, plan: &Plan) -> BoltSummary {
    let segments = || set.bolts.iter().flat_map(|bolt| &bolt.segments);
    let area = segments().map(|segment| segment.area).fold(f64::INFINITY, f64::min);
    let yields = set.kind.yields * area;
    BoltSummary {
        bolts: set.bolts.len() as u64,
        given: set.cuts.given as u64,
        shortened: set.cuts.shortened as u64,
        left_out: set.cuts.left_out as u64,
        crossings: set.cuts.crossings as u64,
        // Of nothing, 0 and not −0.
        length: segments().map(|segment| segment.length).sum::<f64>() + 0.0,
        segments: segments().count() as u64,
        placed: placed(set.kind.born, plan),
        bonded: set.kind.bond.is_some(),
        yield_force: if yields.is_finite() { yields } else { f64::NAN },
        pretension: set.kind.pretension,
        force_over_yield: 0.0,
        max_slip: 0.0,
        ..BoltSummary::default()
    }
}

/// The stage in which a group is placed, as tables have it; of stages that the plan lacks none.
fn placed(born: Stage, plan: &Plan) -> String {
    match born {
        Stage::Before(k) => {
            plan.stages.get(usize::from(k)).map(|stage| stage.name.clone()).unwrap_or_default()
        }
        Stage::Shaking => EARTHQUAKE.into(),
    }
}

/// The segments of monitors on bolts; those whose group has no bolt are left out.
pub fn monitors(sets: &[BoltSet], plan: &Plan) -> IndexMap<String, BoltPlace> {
    let of = |monitor: &BoltMonitor| {
        let set = &sets[monitor.set];
        let (b, s) = set.nearest(monitor.point)?;
        let bolt = &set.bolts[b];
        let [from, to] = bolt.segments[s].points.map(|p| bolt.points[p as usize].at);
        let place = BoltPlace {
            group: set.kind.name.clone(),
            bolt: u64::from(bolt.bar) + 1,
            at: bolt.middle(s),
            from_head: 0.5 * (from + to),
        };
        Some((monitor.name.clone(), place))
    };
    plan.bolts.iter().filter_map(of).collect()
}

/// What is unusual about groups of bolts before a run: the group, what, and what to do.
pub fn warnings(groups: &IndexMap<String, BoltSummary>) -> Vec<(String, String, &'static str)> {
    let mut all = Vec::new();
    for (name, group) in groups {
        let BoltSummary { bolts, given, shortened, left_out, .. } = group;
        if *given == 0 {
            let message = format!("there are no bolts in '{name}'");
            all.push((name.clone(), message, "name groups whose faces are laid bare, or a smaller spacing"));
        } else if *bolts == 0 {
            let message = format!("none of the {given} bolts of '{name}' begins in ground that stands then");
            all.push((name.clone(), message, "place them in the stage that lays their heads bare, or later"));
        } else if left_out + shortened > 0 {
            let told = [
                (left_out, "left out, since they begin in no ground that stands then"),
                (shortened, "shortened, since they run into a void or out of the model"),
            ];
            let told: Vec<String> = told
                .into_iter()
                .filter(|(count, _)| **count > 0)
                .map(|(count, what)| format!("{count} {what}"))
                .collect();
            let message = format!("of the {given} bolts of '{name}' {}", told.join("; "));
            all.push((
                name.clone(),
                message,
                "`check` counts them; change their pattern or length if this is not meant",
            ));
        }
    }
    all
}

/// A finding for each group that is there.
pub fn findings(groups: &IndexMap<String, BoltSummary>) -> Vec<Finding> {
    let there = groups.iter().filter(|(_, group)| group.there && group.bolts > 0);
    there.map(|(name, group)| finding(name, group, (None, group.bars))).collect()
}

/// Groups beyond which they are told as one.
const MANY: usize = 2;

/// What became of all groups that are there, where they are many.
pub fn together(groups: &IndexMap<String, BoltSummary>) -> Option<Finding> {
    let there = || groups.iter().filter(|(_, group)| group.there && group.bolts > 0);
    if there().count() <= MANY {
        return None;
    }
    let mut all = BoltSummary { yield_force: f64::NAN, ..BoltSummary::default() };
    let (mut over, mut largest): (f64, f64) = (0.0, 0.0);
    let mut of = (String::new(), false);
    for (name, group) in there() {
        all.bolts += group.bolts;
        all.yielded += group.yielded;
        all.broken += group.broken;
        all.slid += group.slid;
        all.cut += group.cut;
        all.gone += group.gone;
        all.yield_force = all.yield_force.min(group.yield_force);
        all.max_slip = group.max_slip.max(all.max_slip);
        over = group.force_over_yield.max(over);
        if group.largest.force.abs() > largest.abs() {
            largest = group.largest.force;
            all.largest = group.largest.clone();
            of = (name.clone(), group.bars);
        }
    }
    all.force_over_yield = over;
    Some(finding(&format!("All {} groups of bolts and bars", there().count()), &all, (Some(&of.0), of.1)))
}

/// Of one group, or of several together and the one that the largest force is of: bolts are numbered in their groups. And whether
/// that force is one of bars.
fn finding(name: &str, group: &BoltSummary, of: (Option<&str>, bool)) -> Finding {
    let BoltSummary { bolts, yielded, broken, slid, cut, gone, .. } = *group;
    let severity = match (yielded == 0 && broken == 0 && slid == 0, broken) {
        (true, _) => Severity::Undamaged,
        (_, 0) => Severity::Damaged,
        _ => Severity::Through,
    };
    let finding =
        Finding::new(format!("bolts_{}", snake(name)), name, severity, headline(group), text(group, of))
            .with("bolts", bolts as f64)
            .with("yielded", yielded as f64)
            .with("broken", broken as f64)
            .with("slid", slid as f64)
            .with("cut", cut as f64)
            .with("gone", gone as f64)
            .with("max_force", group.largest.force)
            .with("force_over_yield", group.force_over_yield)
            .with("max_slip", group.max_slip);
    let BoltPeak { bolt, at, time, .. } = group.largest;
    if bolt == 0 {
        return finding;
    }
    let finding = finding.with("max_force_bolt", bolt as f64).with_place("max_force", at);
    // A stage has no time.
    if time.is_finite() { finding.with("max_force_time", time) } else { finding }
}

/// '3 of 240 bolts yielded, none broke; largest force 0.82 of yield'.
fn headline(group: &BoltSummary) -> Said {
    let BoltSummary { bolts, yielded, broken, gone, .. } = *group;
    let all = bolts.to_string();
    if gone == bolts {
        return match bolts {
            1 => said!("excavations removed its one bolt"),
            _ => said!("excavations removed all of its {bolts} bolts", bolts = all),
        };
    }
    let (yields, some_yielded, some_broke) = (group.yield_force.is_finite(), yielded > 0, broken > 0);
    let (yielded, broken) = (yielded.to_string(), broken.to_string());
    let lost = match (yields, some_yielded, some_broke) {
        (true, false, false) if group.bars => said!("no bar yielded"),
        (true, true, false) if group.bars => said!("bars yielded, none broke"),
        (true, _, true) if group.bars => said!("bars yielded and broke"),
        (false, _, false) if group.bars => said!("bars, which never yield"),
        (false, _, true) if group.bars => said!("bars broke"),
        (true, false, false) if bolts == 1 => said!("its one bolt did not yield"),
        (true, false, false) => said!("none of {bolts} bolts yielded", bolts = all),
        (true, true, false) => {
            said!("{yielded} of {bolts} bolts yielded, none broke", yielded = yielded, bolts = all)
        }
        (true, false, true) => {
            said!("none of {bolts} bolts yielded, {broken} broke", bolts = all, broken = broken)
        }
        (true, true, true) => said!(
            "{yielded} of {bolts} bolts yielded, {broken} broke",
            yielded = yielded,
            bolts = all,
            broken = broken,
        ),
        (false, _, false) if bolts == 1 => said!("its one bolt never yields"),
        (false, _, false) => said!("{bolts} bolts, which never yield", bolts = all),
        (false, _, true) => said!("{broken} of {bolts} bolts broke", broken = broken, bolts = all),
    };
    let most = match yields {
        true => said!("largest force {share} of yield", share = format!("{:.2}", group.force_over_yield)),
        false => said!("largest force {force}", force = signed(group.largest.force)),
    };
    clauses([lost, most])
}

fn text(group: &BoltSummary, of: (Option<&str>, bool)) -> Said {
    let mut text = Vec::new();
    text.extend((group.largest.bolt > 0).then(|| largest(&group.largest, of)));
    if group.slid > 0 {
        text.push(said!(
            "The bond of {slid} slid; largest slip {slip}.",
            slid = group.slid.to_string(),
            slip = metres(group.max_slip),
        ));
    }
    if group.cut > 0 && group.gone < group.bolts {
        let cut = group.cut.to_string();
        text.push(match group.gone {
            0 => said!("Excavations cut {cut}.", cut = cut),
            gone => {
                said!(
                    "Excavations cut {cut} and removed {gone} of these.",
                    cut = cut,
                    gone = gone.to_string()
                )
            }
        });
    }
    sentences(text)
}

/// The largest force, with its bolt or row of bars, place and time.
fn largest(peak: &BoltPeak, of: (Option<&str>, bool)) -> Said {
    let (force, place) = (signed(peak.force), point(peak.at));
    let number = peak.bolt.to_string();
    let bolt = match of {
        // Bars are one chain a row of elements.
        (Some(group), true) => said!("row {row} of the bars '{group}'", row = number, group = group),
        (None, true) => said!("row {row} of the bars", row = number),
        (Some(group), false) => said!("bolt {bolt} of '{group}'", bolt = number, group = group),
        (None, false) => said!("bolt {bolt}", bolt = number),
    };
    match peak.stage.as_str() {
        "" => said!("Largest force {force} in {bolt} at {place}.", force = force, bolt = bolt, place = place),
        EARTHQUAKE => said!(
            "Largest force {force} in {bolt} at {place} at {time} s.",
            force = force,
            bolt = bolt,
            place = place,
            time = format!("{:.2}", peak.time),
        ),
        stage => said!(
            "Largest force {force} in {bolt} at {place} in the stage '{stage}'.",
            force = force,
            bolt = bolt,
            place = place,
            stage = stage,
        ),
    }
}

/// A force with its sense, where it is not the usual one.
fn signed(force: f64) -> Said {
    let size = newtons(force.abs());
    if force < 0.0 { said!("{force} of compression", force = size) } else { said!("{force}", force = size) }
}

/// The size of a force as one says it.
fn newtons(force: f64) -> String {
    match force.abs() {
        size if size >= 1e6 => format!("{:.2} MN", force / 1e6),
        size if size >= 1e3 => format!("{:.0} kN", force / 1e3),
        _ => format!("{force:.0} N"),
    }
}

fn metres(length: f64) -> String {
    if length < 1e-5 { format!("{:.2} µm", 1e6 * length) } else { format!("{:.2} mm", 1e3 * length) }
}
