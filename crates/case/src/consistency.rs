//! What no single key can tell: order between values, names that must be known, unique or used.

use std::collections::BTreeSet;

use crate::fields::{Fields, Item, Material};
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

fn monitors(case: &Fields, problems: &mut Vec<Problem>) {
    let names: Vec<Spanned<String>> = case.tables("monitor").filter_map(|m| m.text("name")).collect();
    // A name that was refused may be the one that is looked for: its own problem is enough.
    let all_known = names.len() == case.tables("monitor").count();
    for relative in case.tables("relative") {
        let between = relative.texts("between");
        for name in &between {
            if all_known && !names.iter().any(|n| n.value == name.value) {
                let known = || names.iter().map(|n| n.value.as_str());
                let remedy = match suggest::nearest(name, known()) {
                    Some(meant) => format!("did you mean \"{meant}\"?"),
                    None if names.is_empty() => "add a [[monitor]]".to_owned(),
                    None => format!("known monitors: {}", known().collect::<Vec<_>>().join(", ")),
                };
                problems.push(Problem::at(name, format!("there is no monitor `{}`", name.value), remedy));
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

/// Reports every text that has stood before.
fn unique(texts: Vec<Spanned<String>>, what: &str, remedy: &str, problems: &mut Vec<Problem>) {
    let mut seen = BTreeSet::new();
    for text in texts {
        if !seen.insert(text.value.clone()) {
            problems.push(Problem::at(&text, format!("{what} `{}` is named twice", text.value), remedy));
        }
    }
}
