//! What the verdict says of what lies around the linings.

use tremolite_results::{Finding, Severity, Summary};

use crate::language::{Language, say};
use crate::quantities::scale::{figures, quantity};
use crate::verdict::short_names::{NAME, percent, short};

/// A share that hides how much of a block of rock, most of it far from the caverns, has yielded.
const SMALL: f64 = 0.01;

/// Interfaces, and groups of bolts, that have a line each where all are told: of more the worst.
const TOLD: usize = 5;

/// What lies around the linings: the worst interface, the worst bolts, the rock.
pub fn around(language: Language, facts: &Summary) -> Vec<(Severity, String)> {
    let mut found: Vec<(Severity, String)> = Vec::new();
    found.extend(ranked(facts, "interface_").first().and_then(|worst| of_interface(language, worst)));
    found.extend(ranked(facts, "bolts_").first().and_then(|worst| of_bolts(language, facts, worst)));
    found.extend(of_worst_rock(language, facts));
    found
}

/// The same with every interface and every group of bolts; groups of bolts of which none yielded share a line.
pub fn all_around(language: Language, facts: &Summary) -> Vec<String> {
    let interfaces = ranked(facts, "interface_").into_iter().take(TOLD);
    let mut found: Vec<String> = interfaces.filter_map(|one| in_full(language, one)).collect();
    let bars = |finding: &&Finding| facts.parts.bolts.get(&finding.group).is_some_and(|group| group.bars);
    let number = |finding: &Finding, name: &str| finding.numbers.get(name).copied().unwrap_or(0.0);
    let whole = |finding: &&Finding| number(finding, "yielded") == 0.0 && !bars(finding);
    let (sound, told): (Vec<&Finding>, Vec<&Finding>) =
        ranked(facts, "bolts_").into_iter().partition(|finding| whole(finding));
    match &sound[..] {
        [] => {}
        [one] => found.extend(of_bolts(language, facts, one).map(|(_, text)| text)),
        [worst, ..] => found.push(say!(
            language,
            "Bolts of {groups} groups: none of {all} yielded; largest force {share} of yield, in {name}.",
            groups = sound.len(),
            all = sound.iter().map(|finding| number(finding, "bolts")).sum::<f64>(),
            share = figures(number(worst, "force_over_yield"), 2),
            name = short(&worst.group, NAME)
        )),
    }
    found.extend(told.into_iter().take(TOLD).filter_map(|one| Some(of_bolts(language, facts, one)?.1)));
    found.extend(of_worst_rock(language, facts).map(|(_, text)| text));
    found
}

/// Findings of one kind, the worst first.
fn ranked<'a>(facts: &'a Summary, prefix: &str) -> Vec<&'a Finding> {
    let number = |finding: &Finding, name: &str| finding.numbers.get(name).copied().unwrap_or(0.0);
    let area = |f: &Finding| number(f, "share_slid").max(number(f, "share_opened"));
    let rank = |f: &Finding| area(f).max(number(f, "force_over_yield"));
    let own = facts.conclusion.findings.iter().filter(|finding| finding.id.starts_with(prefix));
    let mut own: Vec<&Finding> = own.collect();
    own.sort_by(|a, b| (b.severity as u8).cmp(&(a.severity as u8)).then(rank(b).total_cmp(&rank(a))));
    own
}

/// How much of an interface slid and opened.
fn of_interface(language: Language, interface: &Finding) -> Option<(Severity, String)> {
    let number = |name: &str| interface.numbers.get(name).copied();
    let (slid, opened) = (number("share_slid")?, number("share_opened")?);
    let name = short(&interface.group, NAME);
    let (slides, opens) = (percent(slid), percent(opened));
    let text = match (slid > 0.0, opened > 0.0) {
        (false, false) => say!(language, "Interface {name}: neither slid nor opened.", name = name),
        (true, false) => say!(
            language,
            "Interface {name}: slid over {slid} of its area, opened nowhere.",
            name = name,
            slid = slides
        ),
        (false, true) => say!(
            language,
            "Interface {name}: opened over {opened} of its area, slid nowhere.",
            name = name,
            opened = opens
        ),
        (true, true) => say!(
            language,
            "Interface {name}: slid over {slid} and opened over {opened} of its area.",
            name = name,
            slid = slides,
            opened = opens
        ),
    };
    Some(match number("closed_nodes") {
        Some(nodes) if nodes > 0.0 => {
            let held = say!(
                language,
                "At {nodes} nodes, where it meets linings or its own ends, it cannot slide.",
                nodes = nodes
            );
            (
                // What cannot slide everywhere is no good news where it did not.
                if interface.severity == Severity::Undamaged {
                    Severity::Damaged
                } else {
                    interface.severity
                },
                say!(language, "{first} {second}", first = text, second = held),
            )
        }
        _ => (interface.severity, text),
    })
}

/// The same with the largest slip and gap.
fn in_full(language: Language, interface: &Finding) -> Option<String> {
    let (_, text) = of_interface(language, interface)?;
    let far = |name: &str| interface.numbers.get(name).copied().filter(|far| *far > 0.0);
    let more = match (far("max_slip"), far("max_gap")) {
        (None, None) => return Some(text),
        (Some(slip), None) => say!(language, "Largest slip {slip}.", slip = quantity("m", slip)),
        (None, Some(gap)) => say!(language, "Largest gap {gap}.", gap = quantity("m", gap)),
        (Some(slip), Some(gap)) => say!(
            language,
            "Largest slip {slip}, largest gap {gap}.",
            slip = quantity("m", slip),
            gap = quantity("m", gap)
        ),
    };
    Some(say!(language, "{first} {second}", first = text, second = more))
}

/// How many bolts of a group yielded and broke.
fn of_bolts(language: Language, facts: &Summary, bolts: &Finding) -> Option<(Severity, String)> {
    let number = |name: &str| bolts.numbers.get(name).copied();
    let (all, yielded, broken) = (number("bolts")?, number("yielded")?, number("broken")?);
    let name = short(&bolts.group, NAME);
    // Of reinforcement each row of elements has a chain: their number says nothing.
    let bars = facts.parts.bolts.get(&bolts.group).is_some_and(|group| group.bars);
    // Beside concrete that cannot crack they carry little: where its sections are beyond their strength that is no good news.
    let beyond = facts.parts.sections.values().any(|of| of.reinforced > 0 && of.is_overloaded());
    let used = facts.parts.bolts.get(&bolts.group).map(|group| group.force_over_yield);
    let used = used.filter(|share| share.is_finite() && *share > 0.0).map(|share| format!("{share:.2}"));
    let text = match (yielded > 0.0, broken > 0.0) {
        (false, false) if bars && beyond => say!(
            language,
            "Reinforcement {name}: no bar yielded in the elastic model, whose concrete takes tension without cracking.",
            name = name
        ),
        (false, false) if bars => match used {
            Some(share) => say!(
                language,
                "Reinforcement {name}: no bar yielded, as a mean over an element; largest force {share} of yield.",
                name = name,
                share = share
            ),
            None => say!(language, "Reinforcement {name}: no bar yielded.", name = name),
        },
        (_, false) if bars => {
            say!(language, "Reinforcement {name}: bars yielded, none broke.", name = name)
        }
        (_, true) if bars => {
            say!(language, "Reinforcement {name}: bars yielded and broke.", name = name)
        }
        (false, false) => say!(language, "Bolts {name}: none of {all} yielded.", name = name, all = all),
        (_, false) => say!(
            language,
            "Bolts {name}: {yielded} of {all} yielded, none broke.",
            name = name,
            yielded = yielded,
            all = all
        ),
        (_, true) => say!(
            language,
            "Bolts {name}: {yielded} of {all} yielded, {broken} broke.",
            name = name,
            yielded = yielded,
            all = all,
            broken = broken
        ),
    };
    let severity = match bolts.severity {
        Severity::Undamaged if bars && beyond => Severity::Damaged,
        other => other,
    };
    Some((severity, text))
}

/// Of the rock that which has yielded worst.
fn of_worst_rock(language: Language, facts: &Summary) -> Option<(Severity, String)> {
    let rock = facts.conclusion.findings.iter().filter(|f| of_rock(f)).max_by_key(|f| f.severity as u8)?;
    Some((rock.severity, yielded(language, facts, rock)))
}

/// In how much of its volume a group has yielded; of a large one, the ground, also how much that is.
pub fn yielded(language: Language, facts: &Summary, finding: &Finding) -> String {
    let text = by_share(language, finding);
    let measure =
        facts.parts.damage.get(&finding.group).and_then(|group| group.measures.get("plastic_shear_strain"));
    let volume = measure.and_then(|measure| measure.beyond.values().next()).copied().unwrap_or(0.0);
    match finding.numbers.get("share_yielded_in_shear") {
        Some(share) if *share < SMALL && volume > 0.0 => {
            let volume = format!("{}\u{a0}m³", figures(volume, 3));
            if finding.numbers.get("share_yielded_in_tension").copied().unwrap_or(0.0) == 0.0 {
                return say!(
                    language,
                    "{name}: yielded in shear in {volume}, {shear} of its volume.",
                    name = short(&finding.group, NAME),
                    volume = volume,
                    shear = percent(*share)
                );
            }
            say!(language, "{first} In shear that is {volume}.", first = text, volume = volume)
        }
        _ => text,
    }
}

fn by_share(language: Language, finding: &Finding) -> String {
    let share = |name: &str| finding.numbers.get(name).copied().unwrap_or(0.0);
    let shear = share("share_yielded_in_shear");
    let tension = share("share_yielded_in_tension");
    let name = short(&finding.group, NAME);
    let (in_shear, in_tension) = (percent(shear), percent(tension));
    match (shear > 0.0, tension > 0.0) {
        (false, false) => say!(language, "{group}: undamaged.", group = name),
        (true, false) => {
            say!(
                language,
                "{name}: yielded in shear in {shear} of its volume.",
                name = name,
                shear = in_shear
            )
        }
        (false, true) => say!(
            language,
            "{name}: yielded in tension in {tension} of its volume.",
            name = name,
            tension = in_tension
        ),
        (true, true) => say!(
            language,
            "{name}: yielded in shear in {shear} and in tension in {tension} of its volume.",
            name = name,
            shear = in_shear,
            tension = in_tension
        ),
    }
}

/// Whether a finding is of rock, which yields but does not crack.
pub fn of_rock(finding: &Finding) -> bool {
    finding.numbers.keys().any(|name| name.starts_with("share_yielded"))
}
