//! What lies between keys of water, of stages, materials and regions, and what needs a case with water.

use crate::Diagnostic;
use crate::fields::{Fields, Material};
use crate::key_path::below;
use crate::material::VOID;
use crate::seepage::Pressure;
use crate::stage::Written;
use crate::water::Earthquake;

/// What lies between keys, and what needs a case with water.
pub(crate) fn check(
    case: &Fields,
    materials: &[Material],
    written: &Written,
    problems: &mut Vec<Diagnostic>,
) {
    for pores in materials.iter().filter_map(|m| m.fields.get("water")?.table()) {
        of_pores(pores, problems);
    }
    let Some(water) = case.table("water") else {
        // A case with a broken table of water is no case without.
        if case.get("water").is_none() {
            without(case, materials, problems);
        }
        return;
    };
    seepage(case, water, materials, written, problems);
    if water
        .text("earthquake")
        .is_some_and(|word| Earthquake::from_word(&word.value) == Some(Earthquake::Undrained))
    {
        for material in materials {
            let Some(node) = material.fields.get("water") else { continue };
            let says = |pores: &Fields| ["porosity", "skempton"].iter().any(|key| pores.get(key).is_some());
            let refused = written.is_refused(&path(material));
            if node.table().is_some_and(|pores| !says(pores)) && !refused {
                problems.push(Diagnostic::new(
                    node.span.clone(),
                    "the earthquake is undrained, and nothing says how much water is in these pores",
                    "give it a `porosity`, or Skempton's coefficient as `skempton`",
                ));
            }
        }
    }
    if !written.stress {
        problems.push(Diagnostic::new(
            water.span.clone(),
            "there is water, and no initial stress that goes with it",
            "give [initial] lateral, stress or measured: total stresses",
        ));
    }
}

/// The path of a material's pores.
fn path(material: &Material) -> String {
    below(&below("material", &material.name.value), "water")
}

/// Refuses what says something of water in a case that has none.
fn without(case: &Fields, materials: &[Material], problems: &mut Vec<Diagnostic>) {
    let of_initial = case.table("initial").and_then(|initial| initial.get("k0_stress"));
    let of_materials =
        materials.iter().filter_map(|m| m.fields.get("water")).filter(|node| node.table().is_some());
    let of_stages = case.tables("stage").filter_map(|stage| stage.get("water"));
    let of_interfaces = case.tables("interface").filter_map(|interface| interface.get("water"));
    let all = of_initial.into_iter().chain(of_materials).chain(of_stages).chain(of_interfaces);
    problems.extend(all.map(|node| {
        Diagnostic::new(
            node.span.clone(),
            "this has a meaning only where there is water",
            "add [water] with the `level`, or leave it out",
        )
    }));
}

/// Refuses pores that cannot be.
fn of_pores(f: &Fields, problems: &mut Vec<Diagnostic>) {
    if let (Some(biot), Some(porosity)) = (f.number("biot"), f.number("porosity"))
        && *porosity > *biot
    {
        problems.push(Diagnostic::at(
            &porosity,
            format!("a porosity of {} is more than Biot's coefficient of {}", *porosity, *biot),
            "grains would stretch under pressure: give a larger `biot`, or a smaller porosity",
        ));
    }
    if let Some(skempton) = f.number("skempton").filter(|b| **b >= 1.0) {
        problems.push(Diagnostic::at(
            &skempton,
            "with a Skempton's coefficient of 1 nothing would be left of any pressure between grains",
            "give a value below 1; 0.6 to 0.99 is usual",
        ));
    }
}

/// What has a meaning with seepage alone, or with a level alone, and what seepage needs.
fn seepage(
    case: &Fields,
    water: &Fields,
    materials: &[Material],
    written: &Written,
    problems: &mut Vec<Diagnostic>,
) {
    let Some(pressure) = water.word("pressure", Pressure::from_word) else { return };
    let stages: Vec<&Fields> = case.tables("stage").filter_map(|stage| stage.table("water")).collect();
    if pressure.value == Pressure::Level {
        let of_stages =
            stages.iter().flat_map(|stage| ["heads", "drained", "drains"].map(|key| (stage.get(key), key)));
        let all = of_stages.chain([(water.get("heads"), "heads")]);
        problems.extend(all.filter_map(|(node, key)| Some((node?, key))).map(|(node, key)| {
            Diagnostic::new(
                node.span.clone(),
                format!("`{key}` has a meaning only with steady seepage, and pressures go by a level here"),
                "write pressure = \"seepage\" in [water], or leave it out",
            )
        }));
        return;
    }
    problems.extend(stages.iter().filter_map(|stage| stage.number("level")).map(|level| {
        Diagnostic::at(
            &level,
            "`level` of a stage does nothing where pressures come from seepage",
            "give `heads` in its place: where water comes from",
        )
    }));
    if water.get("heads").is_none() && !written.is_refused("water") {
        problems.push(Diagnostic::at(
            &pressure,
            "nothing says where the water of the seepage comes from",
            "give heads, such as heads = { sides = \"-50 m\" }",
        ));
    }
    let used: Vec<String> =
        case.tables("region").filter_map(|region| region.text("material")).map(|name| name.value).collect();
    let flows = |material: &&Material| {
        let pores = material.fields.get("water").and_then(|node| node.table());
        pores.is_some_and(|pores| {
            ["hydraulic_conductivity", "permeability"].iter().any(|key| pores.get(key).is_some())
        })
    };
    let of_regions: Vec<&Material> =
        materials.iter().filter(|material| used.contains(&material.name.value)).collect();
    let is_known = |name: &String| name == VOID || materials.iter().any(|m| m.name.value == *name);
    let is_refused = written.is_refused("region")
        || !used.iter().all(is_known)
        || of_regions.iter().any(|material| written.is_refused(&path(material)));
    if !(is_refused || of_regions.iter().any(flows)) {
        problems.push(Diagnostic::at(
            &pressure,
            "no material of a region has a hydraulic conductivity, so that no water flows",
            "give the rock one: water = { hydraulic_conductivity = \"1e-7 m/s\" }",
        ));
    }
}
