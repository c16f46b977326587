//! What no single key can tell: order between values, names that must be known, unique or used.

use std::collections::BTreeSet;

use crate::bolts;
use crate::fields::{Fields, Item, Material};
use crate::initial::Initial;
use crate::interface::{self, TIED};
use crate::material::VOID;
use crate::mesh::{Mesh, check_seams};
use crate::motion::{self, Motion};
use crate::section::Section;
use crate::seepage;
use crate::stage::{Stage, Written};
use crate::value::{NO_FORMULA, begins_a_formula};
use crate::{Diagnostic, Spanned, suggest, units, wet};
use tremolite_laws::parameter::Dimension;

/// The materials of a checked case, also those with problems.
pub(crate) fn materials(case: &Fields) -> &[Material] {
    match case.get("material").map(|n| &n.item) {
        Some(Item::Materials(materials)) => materials,
        _ => &[],
    }
}

/// Checks what lies between keys and between parts of the case; returns problems and warnings.
///
/// Works on the checked tables rather than on the finished parts, so that a problem in one part hides nothing here; `written`
/// tells of parts that were refused.
pub(crate) fn check(case: &Fields, written: &Written) -> (Vec<Diagnostic>, Vec<Diagnostic>) {
    let (mut problems, mut warnings) = (Vec::new(), Vec::new());
    if let Some(mesh) = case.table("mesh") {
        Mesh::check(mesh, &mut problems);
    }
    if let Some(motion) = case.table("motion") {
        Motion::check(motion, &mut problems);
    }
    if let Some(initial) = case.table("initial") {
        Initial::check(initial, &mut problems);
    }
    if !(written.motion || written.equilibrium) {
        problems.push(Diagnostic::new(
            case.span.clone(),
            "there is nothing to compute: no [motion], no [[stage]] and no initial stress",
            "add [motion] (the earthquake), [[stage]], or initial.lateral (the weight of the ground)",
        ));
    }
    Stage::check(case, written, &mut problems);
    wet::check(case, materials(case), written, &mut problems);
    stages(case, &mut problems);
    weights(case, &mut problems);
    reference(case, written, &mut problems);
    regions(case, &mut problems, &mut warnings);
    interfaces(case, &mut problems);
    let bolts = bolts::check(case, &written.excavates, &mut problems);
    monitors(case, &bolts, bolts.len() == written.bolts, &mut problems);
    case.tables("section").for_each(|section| Section::check(section, &mut problems));
    // Reinforcement is told of beside them, so it has names of its own as well.
    let bars = case.tables("reinforcement").filter_map(|steel| steel.text("name"));
    unique(bolts.into_iter().chain(bars).collect(), "bolts", "give each its own name", &mut problems);
    if let Some(output) = case.table("output") {
        unique(output.texts("fields"), "field", "name each field once", &mut problems);
        if !(seepage::flows(case) || written.is_refused("water")) {
            let fields = output.texts("fields");
            warnings.extend(fields.iter().filter(|field| field.value == seepage::FIELD).map(|field| {
                Diagnostic::at(
                    field,
                    "no water flows in this case, so that the field `seepage` is not written",
                    "write pressure = \"seepage\" in [water], or leave the field out",
                )
            }));
        }
    }
    let base = case.table("dynamic").and_then(|d| d.table("base")).and_then(|b| b.text("kind"));
    if let Some(base) = base
        && *base == "free"
        && written.motion
    {
        warnings.push(Diagnostic::at(
            &base,
            "no motion enters through a free base",
            "write base = \"viscous\", unless the model is to stay at rest",
        ));
    }
    (problems, warnings)
}

fn regions(case: &Fields, problems: &mut Vec<Diagnostic>, warnings: &mut Vec<Diagnostic>) {
    let materials = materials(case);
    let regions: Vec<&Fields> = case.tables("region").collect();
    let mut used: Vec<Spanned<String>> = regions.iter().filter_map(|r| r.text("material")).collect();
    problems.extend(used.iter().filter_map(|name| unknown_material(name, materials, ", or write \"void\"")));
    let before: Vec<Spanned<String>> = regions.iter().filter_map(|r| r.text("before")).collect();
    let later: Vec<Spanned<String>> = case
        .tables("stage")
        .flat_map(|stage| stage.entries("material"))
        .filter_map(|(_, name)| name.text())
        .collect();
    for name in before.iter().chain(&later) {
        problems.extend(unknown_material(name, materials, ""));
    }
    for name in later.iter().filter(|n| n.value == VOID) {
        let remedy = "name the groups in the `excavate` of the stage";
        problems.push(Diagnostic::at(name, "a stage makes nothing of no material", remedy));
    }
    used.extend(before.into_iter().chain(later));
    for seam in seams(case).filter_map(|plane| plane.table("seam")?.text("material")) {
        problems.extend(unknown_material(&seam, materials, ""));
        used.push(seam);
    }
    if let Some(mesh) = case.table("mesh") {
        warnings.extend(check_seams(mesh, materials, problems));
    }
    for material in materials {
        if !used.iter().any(|n| n.value == material.name.value) {
            warnings.push(Diagnostic::at(
                &material.name,
                format!("no region is made of `{}`", material.name.value),
                "name it in a [[region]], or remove it",
            ));
        }
    }
    let groups = regions.iter().flat_map(|r| r.texts("groups")).collect();
    unique(groups, "group", "name each group in one region only", problems);
}

/// The problem of a name that no material has; `or` is another way out.
fn unknown_material(name: &Spanned<String>, materials: &[Material], or: &str) -> Option<Diagnostic> {
    if name.value == VOID || materials.iter().any(|m| m.name.value == name.value) {
        return None;
    }
    let known = materials.iter().map(|m| m.name.value.as_str());
    let remedy = match suggest::nearest(name, known) {
        Some(meant) => format!("did you mean \"{meant}\"?"),
        None => format!("add [material.{}]{or}", name.value),
    };
    Some(Diagnostic::at(name, format!("there is no material `{}`", name.value), remedy))
}

fn stages(case: &Fields, problems: &mut Vec<Diagnostic>) {
    let names: Vec<Spanned<String>> = case.tables("stage").filter_map(|s| s.text("name")).collect();
    for name in names.iter().filter(|name| begins_a_formula(&name.value)) {
        problems.push(Diagnostic::at(name, format!("no stage can be called `{}`", name.value), NO_FORMULA));
    }
    unique(names, "stage", "give each stage its own name", problems);
    for stage in case.tables("stage") {
        // Rock may go out and lining of the same group in, in one stage.
        for key in ["excavate", "install"] {
            unique(stage.texts(key), "group", "name each group once in a list", problems);
        }
    }
}

/// Refuses unit weights that gravity does not turn into densities.
fn weights(case: &Fields, problems: &mut Vec<Diagnostic>) {
    let Some(gravity) = case.table("initial").and_then(|f| f.number("gravity")) else { return };
    let weights = materials(case).iter().filter_map(|m| m.fields.number("unit_weight"));
    let of_site = case.table("motion").map_or_else(Vec::new, motion::unit_weights);
    let weights = weights.chain(of_site);
    for weight in weights.filter(|w| !(w.value / gravity.value).is_normal()) {
        let gravity = units::format(gravity.value, Dimension::ACCELERATION);
        problems.push(Diagnostic::at(
            &weight,
            format!("a gravity of {gravity} turns no unit weight into a density"),
            "give density = \"… kg/m3\" instead",
        ));
    }
}

/// With damping over a band moduli go by the frequency, and what comes before the earthquake is computed at rest.
fn reference(case: &Fields, written: &Written, problems: &mut Vec<Diagnostic>) {
    let Some(damping) = case.table("dynamic").and_then(|d| d.table("damping")) else { return };
    if let (Some(band), true, false) = (damping.get("band"), written.equilibrium, written.reference) {
        problems.push(Diagnostic::new(
            band.span.clone(),
            "`reference` is missing: with initial stress or stages it must be known at which frequency Young's moduli are meant",
            "add reference = \"0 Hz\" where they are meant at rest, as for the stages, or the frequency they were measured at",
        ));
    }
}

fn interfaces(case: &Fields, problems: &mut Vec<Diagnostic>) {
    let mut before: Vec<([BTreeSet<String>; 2], String)> = Vec::new();
    for f in seams(case) {
        let name = f.text("name").map_or_else(String::new, |n| n.value);
        let sides = ["above", "below"].map(|side| BTreeSet::from([format!("{name}.{side}")]));
        before.push((sides, name));
    }
    for (k, f) in case.tables("interface").enumerate() {
        let Some([first, second]) = interface::sides(f) else { continue };
        for pattern in &second {
            if first.iter().any(|p| p.value == pattern.value) {
                problems.push(Diagnostic::at(
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
            Some((_, other)) => problems.push(Diagnostic::new(
                f.get("between").map_or_else(|| f.span.clone(), |n| n.span.clone()),
                format!("interface `{name}` is between the groups of interface `{other}`"),
                "keep one of the two",
            )),
            None => before.push((sides, name)),
        }
    }
    let names = case.tables("interface").chain(seams(case)).filter_map(|i| i.text("name")).collect();
    unique(names, "interface", "give each interface its own name", problems);
}

/// The planes of the mesh that have a seam, and so are interfaces.
fn seams(case: &Fields) -> impl Iterator<Item = &Fields> {
    let planes = case.table("mesh").into_iter().flat_map(|mesh| mesh.tables("plane"));
    planes.filter(|plane| plane.table("seam").is_some())
}

/// `bolts` are the names of bolts, `all_bolts` whether they are those of all.
fn monitors(case: &Fields, bolts: &[Spanned<String>], all_bolts: bool, problems: &mut Vec<Diagnostic>) {
    let (names, all_known) = names(case, "monitor");
    let with = |key: &'static str| -> BTreeSet<String> {
        let monitors = case.tables("monitor").filter(|m| m.text(key).is_some());
        monitors.filter_map(|m| Some(m.text("name")?.value)).collect()
    };
    let (at_interface, at_bolt) = (with("interface"), with("bolt"));
    looked_at(case, problems);
    for name in case.tables("monitor").filter_map(|m| m.text("bolt")) {
        if all_bolts && !bolts.iter().any(|b| b.value == name.value) {
            problems.push(no_bolts(&name, bolts));
        }
    }
    let moves =
        |name: &&Spanned<String>| !at_interface.contains(&name.value) && !at_bolt.contains(&name.value);
    let mut columns: BTreeSet<String> = names.iter().filter(moves).map(|name| name.value.clone()).collect();
    for relative in case.tables("monitor_pair") {
        let between = relative.texts("between");
        if let [a, b] = &between[..]
            && !columns.insert(format!("{}-{}", a.value, b.value))
        {
            problems.push(Diagnostic::at(
                b,
                format!(
                    "columns of this pair are called `{}-{}`, and so are those of another entry",
                    a.value, b.value
                ),
                "leave out the pair that stands there twice, or give the monitors other names",
            ));
        }
        for name in &between {
            if at_interface.contains(&name.value) {
                problems.push(Diagnostic::at(
                    name,
                    format!("monitor `{}` keeps gap and slip of an interface, no displacement", name.value),
                    "name two monitors without `interface`",
                ));
            } else if at_bolt.contains(&name.value) {
                problems.push(Diagnostic::at(
                    name,
                    format!("monitor `{}` keeps the force of a bolt, no displacement", name.value),
                    "name two monitors without `bolt`",
                ));
            } else if all_known && !names.iter().any(|n| n.value == name.value) {
                problems.push(unknown("monitor", name, &names));
            }
        }
        if let [a, b] = &between[..]
            && a.value == b.value
        {
            problems.push(Diagnostic::at(
                b,
                "a monitor does not move against itself",
                "name another monitor",
            ));
        }
    }
    unique(names, "monitor", "give each monitor its own name", problems);
}

/// Checks the interfaces that monitors name.
fn looked_at(case: &Fields, problems: &mut Vec<Diagnostic>) {
    let (mut names, all_known) = names(case, "interface");
    names.extend(seams(case).filter_map(|plane| plane.text("name")));
    for name in case.tables("monitor").filter_map(|m| m.text("interface")) {
        let named = |i: &&Fields| i.text("name").is_some_and(|n| n.value == name.value);
        match case.tables("interface").find(named) {
            Some(interface) if interface.text("law").is_some_and(|law| *law == TIED) => {
                problems.push(Diagnostic::at(
                    &name,
                    format!("interface `{}` is tied: it has no gap and no slip", name.value),
                    "name an interface with a law, or leave `interface` out",
                ));
            }
            None if all_known && !names.iter().any(|n| n.value == name.value) => {
                problems.push(unknown("interface", &name, &names));
            }
            _ => {}
        }
    }
}

/// The problem of a name that no bolts have.
fn no_bolts(name: &Spanned<String>, bolts: &[Spanned<String>]) -> Diagnostic {
    let known = || bolts.iter().map(|b| b.value.as_str());
    let remedy = match suggest::nearest(name, known()) {
        Some(meant) => format!("did you mean \"{meant}\"?"),
        None if bolts.is_empty() => "add [[stage.bolts]] of that name to a stage".to_owned(),
        None => format!("known bolts: {}", known().collect::<Vec<_>>().join(", ")),
    };
    Diagnostic::at(name, format!("there are no bolts `{}`", name.value), remedy)
}

/// The names of the entries of a list of tables, and whether all have one. One that was refused may be the one that is
/// looked for: its own problem is enough.
fn names(case: &Fields, list: &'static str) -> (Vec<Spanned<String>>, bool) {
    let names: Vec<Spanned<String>> = case.tables(list).filter_map(|t| t.text("name")).collect();
    let all = names.len() == case.tables(list).count();
    (names, all)
}

/// The problem of a name that no entry of a list of tables has.
fn unknown(list: &str, name: &Spanned<String>, names: &[Spanned<String>]) -> Diagnostic {
    let known = || names.iter().map(|n| n.value.as_str());
    let remedy = match suggest::nearest(name, known()) {
        Some(meant) => format!("did you mean \"{meant}\"?"),
        None if names.is_empty() => format!("add a [[{list}]] of that name"),
        None => format!("known {list}s: {}", known().collect::<Vec<_>>().join(", ")),
    };
    Diagnostic::at(name, format!("there is no {list} `{}`", name.value), remedy)
}

/// Reports every text that has stood before.
fn unique(texts: Vec<Spanned<String>>, what: &str, remedy: &str, problems: &mut Vec<Diagnostic>) {
    let mut seen = BTreeSet::new();
    for text in texts {
        if !seen.insert(text.value.clone()) {
            problems.push(Diagnostic::at(&text, format!("{what} `{}` is named twice", text.value), remedy));
        }
    }
}
