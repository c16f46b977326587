//! What no single key can tell: order between values, names that must be known, unique or used.

use std::collections::BTreeSet;

use crate::fields::{Fields, Item, Material};
use crate::interface::{self, TIED};
use crate::material::VOID;
use crate::mesh::Mesh;
use crate::motion::Motion;
use crate::{Problem, Spanned, suggest};

/// The materials of a checked case, also those with problems.
pub(crate) fn materials(case: &Fields) -> &[Material] {
    match case.get("material").map(|n| &n.item) {
        Some(Item::Materials(materials)) => materials,
        _ => &[],
    }
}

/// Checks what lies between keys and between parts of the case; returns problems and warnings.
///
/// Works on the checked tables rather than on the finished parts, so that a problem in one part hides nothing here.
pub(crate) fn check(case: &Fields) -> (Vec<Problem>, Vec<Problem>) {
    let (mut problems, mut warnings) = (Vec::new(), Vec::new());
    if let Some(mesh) = case.table("mesh") {
        Mesh::check(mesh, &mut problems);
    }
    if let Some(motion) = case.table("motion") {
        Motion::check(motion, &mut problems);
    }
    regions(case, &mut problems, &mut warnings);
    interfaces(case, &mut problems);
    monitors(case, &mut problems);
    if let Some(output) = case.table("output") {
        unique(output.texts("fields"), "field", "name each field once", &mut problems);
    }
    let base = case.table("dynamic").and_then(|d| d.table("base")).and_then(|b| b.text("kind"));
    if let Some(base) = base
        && *base == "free"
    {
        warnings.push(Problem::at(
            &base,
            "no motion enters through a free base",
            "write base = \"viscous-spring\", unless the model is to stay at rest",
        ));
    }
    (problems, warnings)
}

fn regions(case: &Fields, problems: &mut Vec<Problem>, warnings: &mut Vec<Problem>) {
    let materials = materials(case);
    let regions: Vec<&Fields> = case.tables("region").collect();
    let used: Vec<Spanned<String>> = regions.iter().filter_map(|r| r.text("material")).collect();
    for name in used.iter().filter(|n| n.value != VOID) {
        if !materials.iter().any(|m| m.name.value == name.value) {
            let known = materials.iter().map(|m| m.name.value.as_str());
            let remedy = match suggest::nearest(name, known) {
                Some(meant) => format!("did you mean \"{meant}\"?"),
                None => format!("add [material.{}], or write \"void\"", name.value),
            };
            problems.push(Problem::at(name, format!("there is no material `{}`", name.value), remedy));
        }
    }
    for material in materials {
        if !used.iter().any(|n| n.value == material.name.value) {
            warnings.push(Problem::at(
                &material.name,
                format!("no region is made of `{}`", material.name.value),
                "name it in a [[region]], or remove it",
            ));
        }
    }
    let groups = regions.iter().flat_map(|r| r.texts("groups")).collect();
    unique(groups, "group", "name each group in one region only", problems);
}

fn interfaces(case: &Fields, problems: &mut Vec<Problem>) {
    let mut before: Vec<([BTreeSet<String>; 2], String)> = Vec::new();
    for (k, f) in case.tables("interface").enumerate() {
        let Some([first, second]) = interface::sides(f) else { continue };
        for pattern in &second {
            if first.iter().any(|p| p.value == pattern.value) {
                problems.push(Problem::at(
                    pattern,
                    format!("group `{}` is on both sides", pattern.value),
                    "give what lies on each side, such as between = [\"*.lining\", \"rock\"]",
                ));
            }
        }
        let mut sides = [&first, &second].map(|side| side.iter().map(|p| p.value.clone()).collect());
        for side in [first, second] {
            unique(side, "group", "name each group once", problems);
        }
        // Which side is the first makes no other place of it.
        sides.sort();
        let name = f.text("name").map_or_else(|| (k + 1).to_string(), |n| n.value);
        match before.iter().find(|(other, _)| *other == sides) {
            Some((_, other)) => problems.push(Problem::new(
                f.get("between").map_or_else(|| f.span.clone(), |n| n.span.clone()),
                format!("interface `{name}` is between the groups of interface `{other}`"),
                "keep one of the two",
            )),
            None => before.push((sides, name)),
        }
    }
    let names = case.tables("interface").filter_map(|i| i.text("name")).collect();
    unique(names, "interface", "give each interface its own name", problems);
}

fn monitors(case: &Fields, problems: &mut Vec<Problem>) {
    let (names, all_known) = names(case, "monitor");
    let at_interface: BTreeSet<String> = case
        .tables("monitor")
        .filter(|m| m.text("interface").is_some())
        .filter_map(|m| Some(m.text("name")?.value))
        .collect();
    looked_at(case, problems);
    for relative in case.tables("relative") {
        let between = relative.texts("between");
        for name in &between {
            if at_interface.contains(&name.value) {
                problems.push(Problem::at(
                    name,
                    format!("monitor `{}` keeps gap and slip of an interface, no displacement", name.value),
                    "name two monitors without `interface`",
                ));
            } else if all_known && !names.iter().any(|n| n.value == name.value) {
                problems.push(unknown("monitor", name, &names));
            }
        }
        if let [a, b] = &between[..]
            && a.value == b.value
        {
            problems.push(Problem::at(b, "a monitor does not move against itself", "name another monitor"));
        }
    }
    unique(names, "monitor", "give each monitor its own name", problems);
}

/// Checks the interfaces that monitors name.
fn looked_at(case: &Fields, problems: &mut Vec<Problem>) {
    let (names, all_known) = names(case, "interface");
    for name in case.tables("monitor").filter_map(|m| m.text("interface")) {
        let named = |i: &&Fields| i.text("name").is_some_and(|n| n.value == name.value);
        match case.tables("interface").find(named) {
            Some(interface) if interface.text("law").is_some_and(|law| *law == TIED) => {
                problems.push(Problem::at(
                    &name,
                    format!("interface `{}` is tied: it has no gap and no slip", name.value),
                    "name an interface with a law, or leave `interface` out",
                ));
            }
            None if all_known => problems.push(unknown("interface", &name, &names)),
            _ => {}
        }
    }
}

/// The names of the entries of a list of tables, and whether all have one. One that was refused may be the one that is
/// looked for: its own problem is enough.
fn names(case: &Fields, list: &'static str) -> (Vec<Spanned<String>>, bool) {
    let names: Vec<Spanned<String>> = case.tables(list).filter_map(|t| t.text("name")).collect();
    let all = names.len() == case.tables(list).count();
    (names, all)
}

/// The problem of a name that no entry of a list of tables has.
fn unknown(list: &str, name: &Spanned<String>, names: &[Spanned<String>]) -> Problem {
    let known = || names.iter().map(|n| n.value.as_str());
    let remedy = match suggest::nearest(name, known()) {
        Some(meant) => format!("did you mean \"{meant}\"?"),
        None if names.is_empty() => format!("add a [[{list}]] of that name"),
        None => format!("known {list}s: {}", known().collect::<Vec<_>>().join(", ")),
    };
    Problem::at(name, format!("there is no {list} `{}`", name.value), remedy)
}

/// Reports every text that has stood before.
fn unique(texts: Vec<Spanned<String>>, what: &str, remedy: &str, problems: &mut Vec<Problem>) {
    let mut seen = BTreeSet::new();
    for text in texts {
        if !seen.insert(text.value.clone()) {
            problems.push(Problem::at(&text, format!("{what} `{}` is named twice", text.value), remedy));
        }
    }
}
