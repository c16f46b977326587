//! A file with changes behind switches. No line is added, so that places in it stay what they were.

use crate::Mutant;
use crate::places::{Place, Places};
use std::collections::BTreeMap;
use std::ops::Range;

/// A place with all that is to be put there: switches and what each puts.
struct Site<'a> {
    range: Range<usize>,
    place: &'a Place,
    changes: Vec<(u32, &'a str)>,
}

/// The text with its changes; `on` asks whether a switch is on.
pub fn changed(text: &str, places: &Places, mutants: &[Mutant], on: &str) -> String {
    let mut sites: BTreeMap<(usize, usize, bool), Site> = BTreeMap::new();
    for mutant in mutants {
        let (Some(switch), Some(place)) = (mutant.switch, place(places, mutant)) else { continue };
        let range = match place {
            Place::Operator { left, operator, right } => {
                left.as_ref().map_or(operator.start, |left| left.start)..right.end
            }
            Place::Body(start) => *start..*start,
            Place::Guard(range) => range.clone(),
            Place::Arm(end, guard) => *end..guard.as_ref().map_or(*end, |guard| guard.end),
        };
        // Where two begin together, what is put before everything first, then the wider, and a condition before what it is.
        let order = if range.is_empty() { 0 } else { usize::MAX - range.end };
        let key = (range.start, order, matches!(place, Place::Operator { .. }));
        let site = Site { range, place, changes: Vec::new() };
        sites.entry(key).or_insert(site).changes.push((switch, &mutant.replacement));
    }
    let sites: Vec<Site> = sites.into_values().collect();
    write(text, 0..text.len(), &sites, on)
}

/// Where a change can be switched, if it can.
pub fn place<'a>(places: &'a Places, mutant: &Mutant) -> Option<&'a Place> {
    let mut own = places.iter().filter(|((genre, at), _)| *genre == mutant.genre && *at == mutant.span.start);
    own.next().map(|(_, place)| place)
}

/// A part of the text, with the sites in it, which are ascending, wider ones first.
fn write(text: &str, part: Range<usize>, sites: &[Site], on: &str) -> String {
    let mut out = String::new();
    let mut at = part.start;
    for (k, site) in sites.iter().enumerate() {
        // Those inside one that was written are written with it.
        if site.range.start < at || site.range.end > part.end || site.range.start < part.start {
            continue;
        }
        out.push_str(&text[at..site.range.start]);
        let inner = |range: &Range<usize>| write(text, range.clone(), &sites[k + 1..], on);
        out.push_str(&switched(text, site, inner, on));
        at = site.range.end;
    }
    out.push_str(&text[at..part.end]);
    out
}

fn switched(text: &str, site: &Site, inner: impl Fn(&Range<usize>) -> String, on: &str) -> String {
    let choice = |otherwise: String, each: &dyn Fn(&str) -> String| {
        let chosen = site.changes.iter().map(|(k, put)| format!("if {on}({k}) {{ {} }} else ", each(put)));
        format!("({}{{ {otherwise} }})", chosen.collect::<String>())
    };
    match site.place {
        Place::Operator { left, operator, right } => {
            let left = left.as_ref().map_or(String::new(), |left| format!("({})", inner(left)));
            let right = format!("({})", inner(right));
            let with = |operator: &str| format!("{left} {operator} {right}").trim().to_owned();
            choice(with(&text[operator.clone()]), &with)
        }
        Place::Body(_) => {
            let returns = site.changes.iter().map(|(k, put)| format!("if {on}({k}) {{ return {put}; }} "));
            returns.collect()
        }
        Place::Guard(range) => choice(inner(range), &str::to_owned),
        Place::Arm(_, guard) => {
            let off: Vec<String> = site.changes.iter().map(|(k, _)| format!("!{on}({k})")).collect();
            let guard = guard.as_ref().map_or(String::new(), |guard| format!(" && ({})", inner(guard)));
            format!(" if {}{guard}", off.join(" && "))
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::{At, Mutant, Span, places};

    fn mutant(switch: u32, genre: &str, [line, column]: [usize; 2], replacement: &str) -> Mutant {
        let span = Span { start: At { line, column } };
        Mutant {
            switch: Some(switch),
            file: String::new(),
            genre: genre.into(),
            span,
            replacement: replacement.into(),
        }
    }

    #[test]
    fn changes_stand_behind_switches_inside_one_another_and_constants_are_left() {
        let text = "const N: f64 = 1.0 + 2.0;\nfn f(a: f64) -> f64 {\n    -a * a as f64 + 1.0\n}\n";
        let mutants = [
            mutant(1, "BinaryOperator", [1, 20], "-"),
            mutant(2, "BinaryOperator", [3, 19], "-"),
            mutant(3, "BinaryOperator", [3, 19], "*"),
            mutant(4, "UnaryOperator", [3, 5], ""),
            mutant(5, "FnValue", [3, 5], "0.0"),
        ];
        let places = places::of(text).unwrap();
        assert_eq!(
            mutants.each_ref().map(|mutant| super::place(&places, mutant).is_some()),
            [false, true, true, true, true]
        );
        let changed = super::changed(text, &places, &mutants, "on");
        let minus = "(if on(4) { (a) } else { - (a) })";
        let sum = format!("({minus} * a as f64)");
        assert_eq!(
            changed,
            format!(
                "const N: f64 = 1.0 + 2.0;\nfn f(a: f64) -> f64 {{\n    if on(5) {{ return 0.0; }} (if on(2) {{ {sum} - (1.0) }} \
                 else if on(3) {{ {sum} * (1.0) }} else {{ {sum} + (1.0) }})\n}}\n"
            )
        );
    }

    #[test]
    fn arms_and_their_conditions_are_switched_and_those_that_bind_are_left() {
        let text = "fn f(a: u8) -> u8 {\n    match a {\n        1 if a > 0 => 2,\n        2 => 1,\n        3 if let 3 = a && a > 1 => 1,\n        _ => 0,\n    }\n}\n";
        let mutants = [
            mutant(1, "MatchArmGuard", [3, 14], "true"),
            mutant(2, "MatchArm", [4, 9], ""),
            mutant(3, "BinaryOperator", [3, 16], "<"),
        ];
        let changed = super::changed(text, &places::of(text).unwrap(), &mutants, "on");
        assert!(
            changed.contains(
                "1 if (if on(1) { true } else { (if on(3) { (a) < (0) } else { (a) > (0) }) }) => 2,"
            ),
            "{changed}"
        );
        assert!(changed.contains("2 if !on(2) => 1,"), "{changed}");
    }
}
