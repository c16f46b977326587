//! What the verdict says of what lies around the linings.

use tremolite_results::{Finding, Severity, Summary};

use crate::language::{Language, say};
use crate::quantities::scale::figures;
use crate::verdict::short_names::{NAME, percent, short};

/// A share that hides how much of a block of rock, most of it far from the caverns, has yielded.
const SMALL: f64 = 0.01;

/// What lies around the linings: the worst interface, the worst bolts, the rock.
pub fn around(language: Language, facts: &Summary) -> Vec<(Severity, String)> {
    let worst = |prefix: &str| {
        let own = facts.conclusion.findings.iter().filter(|finding| finding.id.starts_with(prefix));
        let number = |finding: &Finding, name: &str| finding.numbers.get(name).copied().unwrap_or(0.0);
        let rank = |f: &Finding| {
            let area = number(f, "share_slid").max(number(f, "share_opened"));
            (f.severity as u8, area.max(number(f, "force_over_yield")))
        };
        own.reduce(|a, b| if rank(b) > rank(a) { b } else { a })
    };
    let number = |finding: &Finding, name: &str| finding.numbers.get(name).copied();
    let mut found: Vec<(Severity, String)> = Vec::new();
    if let Some(interface) = worst("interface_")
        && let (Some(slid), Some(opened)) =
            (number(interface, "share_slid"), number(interface, "share_opened"))
    {
        let name = short(&interface.group, NAME);
        let (slides, opens) = (percent(slid), percent(opened));
        let text = match (slid > 0.0, opened > 0.0) {
            (false, false) => say!(language, "Interface {name}: neither slid nor opened.", name = name),
            (true, false) => {
                say!(
                    language,
                    "Interface {name}: slid over {slid} of its area, opened nowhere.",
                    name = name,
                    slid = slides
                )
            }
            (false, true) => {
                say!(
                    language,
                    "Interface {name}: opened over {opened} of its area, slid nowhere.",
                    name = name,
                    opened = opens
                )
            }
            (true, true) => say!(
                language,
                "Interface {name}: slid over {slid} and opened over {opened} of its area.",
                name = name,
                slid = slides,
                opened = opens
            ),
        };
        found.push((interface.severity, text));
    }
    if let Some(bolts) = worst("bolts_")
        && let (Some(all), Some(yielded), Some(broken)) =
            (number(bolts, "bolts"), number(bolts, "yielded"), number(bolts, "broken"))
    {
        let name = short(&bolts.group, NAME);
        // Of reinforcement each row of elements has a chain: their number says nothing.
        let bars = facts.parts.bolts.get(&bolts.group).is_some_and(|group| group.bars);
        let text = match (yielded > 0.0, broken > 0.0) {
            (false, false) if bars => say!(language, "Reinforcement {name}: no bar yielded.", name = name),
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
        found.push((bolts.severity, text));
    }
    if let Some(rock) =
        facts.conclusion.findings.iter().filter(|f| of_rock(f)).max_by_key(|f| f.severity as u8)
    {
        found.push((rock.severity, yielded(language, facts, rock)));
    }
    found
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
