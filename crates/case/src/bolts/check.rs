//! What no single key of bolts can tell.

use tremolite_laws::parameter::Dimension;

use super::{area, direction, name, plate, points, unit};
use crate::fields::Fields;
use crate::{Diagnostic, Spanned, units};

/// Thinner \[m\] is no bolt but a slip in the unit.
const THINNEST: f64 = 1e-4;
/// Shorter \[m\] is no bolt but a point written twice.
const SHORTEST: f64 = 1e-3;

/// Checks the bolts of all stages; `excavates` says of each stage whether it takes something out: a pattern is laid out on what the last
/// of them up to its own has laid bare. Looks at each value that is
/// good, whatever the others are. Returns the names.
pub(crate) fn check(
    case: &Fields,
    excavates: &[bool],
    problems: &mut Vec<Diagnostic>,
) -> Vec<Spanned<String>> {
    let mut names = Vec::new();
    for (k, stage) in case.tables("stage").enumerate() {
        let own = stage.text("name").map_or_else(|| (k + 1).to_string(), |n| n.value);
        for bolts in stage.tables("bolts") {
            names.push(name(bolts, &own));
            if let Some(pattern) = bolts.text("pattern")
                && !excavates.iter().take(k + 1).any(|takes| *takes)
            {
                problems.push(Diagnostic::at(
                    &pattern,
                    format!("no stage up to '{own}' excavates anything, so there is no bare face for a pattern"),
                    "place the pattern in the stage that excavates or a later one, or give the bolts as `points`",
                ));
            }
            place(bolts, problems);
            steel(bolts, problems);
            free(bolts, problems);
        }
    }
    names
}

fn place(f: &Fields, problems: &mut Vec<Diagnostic>) {
    if let Some(written) = direction(f)
        && unit(written.value).is_none()
    {
        problems.push(Diagnostic::at(
            &written,
            "`direction` has no length",
            "give a vector such as [0, 0, 1], or write \"normal\"",
        ));
    }
    for (k, ends) in points(f).iter().enumerate() {
        let [a, b] = ends.value;
        if (0..3).map(|i| (b[i] - a[i]).powi(2)).sum::<f64>().sqrt() < SHORTEST {
            problems.push(Diagnostic::at(
                ends,
                format!("the two points of bolt {} are one place", k + 1),
                "give its head, at the wall, and its other end",
            ));
        }
    }
    if let Some(length) = f.number("length").filter(|l| l.value < SHORTEST) {
        problems.push(Diagnostic::at(
            &length,
            format!("a bolt of {} is none", units::format(length.value, Dimension::LENGTH)),
            "give the length in the rock: \"6 m\"",
        ));
    }
}

fn steel(f: &Fields, problems: &mut Vec<Diagnostic>) {
    let (diameter, young) = (f.number("diameter"), f.number("young"));
    let (yields, breaks, pretension) =
        (f.number("yield"), f.number("breaking_strain"), f.number("pretension"));
    if let Some(diameter) = diameter.as_ref().filter(|d| d.value < THINNEST) {
        problems.push(Diagnostic::at(
            diameter,
            format!("a bolt {} thick is none", units::format(diameter.value, Dimension::LENGTH)),
            "look at the unit: \"25 mm\"",
        ));
        return;
    }
    if let (Some(young), Some(yields), Some(breaks)) = (&young, &yields, &breaks)
        && breaks.value <= yields.value / young.value
    {
        problems.push(Diagnostic::at(
            breaks,
            format!("it would break before it yields, at a strain of {:.2e}", yields.value / young.value),
            "give the strain at the end of yielding, 0.05 to 0.2 for steel, or leave `yield` out",
        ));
    }
    if let (Some(pretension), Some(diameter)) = (&pretension, &diameter) {
        let stress = pretension.value / area(diameter.value);
        let force = |stress: f64| units::format(stress * area(diameter.value), Dimension::FORCE);
        if let Some(yields) = yields.filter(|yields| stress >= yields.value) {
            problems.push(Diagnostic::at(
                pretension,
                format!("the pretension yields the steel, which holds {}", force(yields.value)),
                "give at most some 70 % of that, or thicker or stronger bolts",
            ));
        } else if let (Some(young), Some(breaks)) = (young, breaks)
            && stress >= breaks.value * young.value
        {
            problems.push(Diagnostic::at(
                pretension,
                format!("the pretension breaks the steel, which holds {}", force(breaks.value * young.value)),
                "give less, or thicker bolts",
            ));
        }
    }
}

fn free(f: &Fields, problems: &mut Vec<Diagnostic>) {
    let (free, pretension) = (f.number("free_length"), f.number("pretension"));
    let plates = plate(f).map(|plate| plate.ends());
    if let (Some(free), Some([false, _])) = (&free, plates) {
        problems.push(Diagnostic::at(
            free,
            "nothing holds the head of a free length without a plate there",
            "add plate = \"head\", or plate = \"both\", or leave `free_length` out",
        ));
    }
    if let (Some(free), Some(length)) = (&free, f.number("length")) {
        if free.value > length.value {
            problems.push(Diagnostic::at(
                free,
                format!(
                    "the free length is longer than the bolt, {}",
                    units::format(length.value, Dimension::LENGTH)
                ),
                "make it shorter: the rest is what is anchored",
            ));
        } else if let (true, Some([true, false])) = (free.value == length.value, plates) {
            problems.push(Diagnostic::at(
                free,
                "nothing holds the other end of a bolt that is free all along",
                "make the free length shorter, or write plate = \"both\"",
            ));
        }
    }
    if let (Some(pretension), Some(_), None) = (&pretension, f.get("bond"), &free) {
        problems.push(Diagnostic::at(
            pretension,
            "a bolt that is grouted all along has nothing to be drawn against",
            "add free_length = \"… m\" and plate = \"head\", or leave `bond` out",
        ));
    }
}
