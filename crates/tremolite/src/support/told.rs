//! What is told of groups of bolts.

use super::{BoltSeen, Look, seen};
use crate::plan::{BoltMonitor, Plan};
use indexmap::IndexMap;
use tremolite_engine::Stage;
use tremolite_engine::bolts::{BoltSet, SegmentState};
use tremolite_results::{BoltPeak, BoltPlace, BoltSummary, EARTHQUAKE, Finding, Severity, snake};

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
    there.map(|(name, group)| finding(name, group)).collect()
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
    let mut of = String::new();
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
            of = name.clone();
        }
    }
    all.force_over_yield = over;
    let mut all = finding(&format!("All {} groups of bolts and bars", there().count()), &all);
    // Bolts are numbered in their groups.
    all.text = all.text.replacen(" at (", &format!(" of '{of}' at ("), 1);
    Some(all)
}

fn finding(name: &str, group: &BoltSummary) -> Finding {
    let BoltSummary { bolts, yielded, broken, slid, cut, gone, .. } = *group;
    let (headline, text) = (headline(group), text(group));
    let whole = yielded == 0 && broken == 0 && slid == 0;
    let numbers = [
        ("bolts", bolts as f64),
        ("yielded", yielded as f64),
        ("broken", broken as f64),
        ("slid", slid as f64),
        ("cut", cut as f64),
        ("gone", gone as f64),
        ("max_force", group.largest.force),
        ("force_over_yield", group.force_over_yield),
        ("max_slip", group.max_slip),
    ];
    Finding {
        id: format!("bolts_{}", snake(name)),
        group: name.to_owned(),
        severity: match (whole, broken) {
            (true, _) => Severity::Undamaged,
            (_, 0) => Severity::Damaged,
            _ => Severity::Through,
        },
        headline,
        text,
        numbers: numbers.map(|(name, value)| (name.to_owned(), value)).into_iter().collect(),
    }
}

/// '3 of 240 bolts yielded, none broke; largest force 0.82 of yield'.
fn headline(group: &BoltSummary) -> String {
    let BoltSummary { bolts, yielded, broken, gone, .. } = *group;
    if gone == bolts {
        return match bolts {
            1 => "nothing is left of its one bolt, which excavations took".to_owned(),
            _ => format!("nothing is left of its {bolts} bolts, which excavations took"),
        };
    }
    let some = |count: u64| if count == 0 { "none".to_owned() } else { count.to_string() };
    let lost = match (group.yield_force.is_finite(), broken) {
        (true, _) if bolts == 1 && yielded + broken == 0 => "its one bolt did not yield".to_owned(),
        (true, _) if yielded + broken == 0 => format!("none of {bolts} bolts yielded"),
        (false, 0) if bolts == 1 => "its one bolt never yields".to_owned(),
        (true, _) => format!("{} of {bolts} bolts yielded, {} broke", some(yielded), some(broken)),
        (false, 0) => format!("{bolts} bolts, which never yield"),
        (false, _) => format!("{broken} of {bolts} bolts broke"),
    };
    let most = match group.yield_force.is_finite() {
        true => format!("{:.2} of yield", group.force_over_yield),
        false => signed(group.largest.force),
    };
    format!("{lost}; largest force {most}")
}

fn text(group: &BoltSummary) -> String {
    let mut text = String::new();
    let BoltPeak { force, bolt, at: [x, y, z], ref stage, time } = group.largest;
    if bolt > 0 {
        let when = match stage.as_str() {
            "" => String::new(),
            EARTHQUAKE => format!(" at {time:.2} s"),
            stage => format!(" in the stage '{stage}'"),
        };
        text = format!("Largest force {} in bolt {bolt} at ({x:.1}, {y:.1}, {z:.1}) m{when}.", signed(force));
    }
    if group.slid > 0 {
        text += &format!(" The bond of {} slid; largest slip {}.", group.slid, metres(group.max_slip));
    }
    if group.cut > 0 && group.gone < group.bolts {
        text += &format!(" Excavations cut {}", group.cut);
        text += &if group.gone > 0 { format!(" and left nothing of {}.", group.gone) } else { ".".into() };
    }
    text.trim_start().to_owned()
}

/// A force with its sense, where it is not the usual one.
fn signed(force: f64) -> String {
    let sense = if force < 0.0 { " of compression" } else { "" };
    format!("{}{sense}", newtons(force.abs()))
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
