//! Checks of water that cannot leave its pores: whether it stays in what is modelled of it.

use crate::evidence::Evidence;
use crate::observers::{PoreWaterSeen, undrained};
use crate::places;
use crate::setup::undrained::DIFFUSIVITY;
use std::collections::{BTreeMap, BTreeSet};
use tremolite_engine::Stage;
use tremolite_engine::extent::extents;
use tremolite_engine::hexahedra::hex;
use tremolite_engine::model::Model;
use tremolite_mesh::Face;
use tremolite_mesh::topology::all_faces;
use tremolite_results::{Fact, MaterialFacts, Said, TrustLine, said};

/// Share of the volume of wet ground up to which an assumption may fail: a hundredth is next to openings alone.
const SHARE: f64 = 0.01;
const FLOOR: &str = "pore_water_at_the_floor";
const DRAINAGE: &str = "pore_water_drainage";
const OPEN: &str = "pore_water_above_the_least_pressure";

pub(super) fn lines(evidence: &Evidence) -> Vec<TrustLine> {
    if evidence.plan.water { vec![floor(evidence), open(evidence), drainage(evidence)] } else { Vec::new() }
}

fn seen(evidence: &Evidence) -> Result<PoreWaterSeen, Said> {
    PoreWaterSeen::recall(&evidence.outcome.state.observers)
        .ok_or_else(|| said!("pressures stay as the stages leave them"))
}

/// Where the pressure came down to that at which water boils.
fn floor(evidence: &Evidence) -> TrustLine {
    let name = said!("wet ground whose water boils");
    match seen(evidence) {
        Err(why) => TrustLine::not_applicable(FLOOR, name, why),
        Ok(PoreWaterSeen { floor, pressures: [least, most], .. }) => {
            TrustLine::at_most(FLOOR, name, floor.share, SHARE, "")
                .with("time", floor.time)
                .with("least", least)
                .with("most", most)
                .with_note(said!(
                    "largest share of the volume of wet ground at −100 kPa, at {time} s; pressures lie between {least} and {most} MPa. What \
                     happens once water has boiled is not modelled",
                    time = format!("{:.3}", floor.time),
                    least = format!("{:.3}", least / 1e6),
                    most = format!("{:.3}", most / 1e6),
                ))
        }
    }
}

/// Where the pressure exceeds the least total pressure.
fn open(evidence: &Evidence) -> TrustLine {
    let name = said!("wet ground in which water exceeds the least pressure");
    match seen(evidence) {
        Err(why) => TrustLine::not_applicable(OPEN, name, why),
        Ok(PoreWaterSeen { open, .. }) => TrustLine::at_most(OPEN, name, open.share, SHARE, "")
            .with("time", open.time)
            .with_note(said!(
                "largest share of the volume of wet ground with an effective principal stress in tension, at {time} s: water would open cracks \
                 there and flow into them, which is not modelled",
                time = format!("{:.3}", open.time),
            )),
    }
}

/// How far water goes in the earthquake where wet ground ends at a void or at ground without water in its pores.
fn drainage(evidence: &Evidence) -> TrustLine {
    let name = said!("way of the water in the earthquake over the element at drained ground");
    let none = |why: Said| TrustLine::not_applicable(DRAINAGE, name.clone(), why);
    if let Err(why) = seen(evidence) {
        return none(why);
    }
    let model = evidence.model;
    let diffusivities: Vec<Option<f64>> =
        model.user_bodies().iter().map(|body| diffusivity(evidence, &body.name)).collect();
    if diffusivities.iter().all(Option::is_none) {
        return none(said!("no hydraulic conductivity is given"));
    }
    let time = evidence.outcome.taken as f64 * evidence.outcome.dt;
    let far = |e: u32| {
        let diffusivity = diffusivities[model.elements.body_of[e as usize]?]?;
        let [extent, _] = extents(&hex(&model.mesh, e as usize).ok()?);
        Some((diffusivity * time).sqrt() / extent)
    };
    let all = at_drained_ground(model).into_iter().filter_map(|e| Some((far(e)?, e)));
    let Some((most, element)) = all.max_by(|a, b| a.0.total_cmp(&b.0)) else {
        return none(said!("wet ground ends nowhere"));
    };
    TrustLine::at_most(DRAINAGE, name.clone(), most, 1.0, "").with("time", time).with_note(said!(
        "√(c_v T) over the shortest extent, largest in {element}: so far from voids and drained ground water does leave, and pressures change by less",
        element = places::element(model, element as usize),
    ))
}

/// c_v \[m²/s\] of a body's material, where it is known.
fn diffusivity(evidence: &Evidence, body: &str) -> Option<f64> {
    let made_of = |facts: &&MaterialFacts| facts.groups.iter().any(|group| group.body == body);
    let values = &evidence.materials.values().find(made_of)?.values;
    values.iter().find(|value| value.name == DIFFUSIVITY).map(|value| value.value)
}

/// Wet elements with a face on a void, or beside ground with pores and no water in them.
fn at_drained_ground(model: &Model) -> Vec<u32> {
    let (low, high) = model.faces.bounds;
    let on_a_plane = |face: Face| {
        let on = |i: usize, level: f64| {
            let near = 1e-6 * (high[i] - low[i]);
            model.mesh.face_nodes(face).all(|n| (model.mesh.nodes[n as usize][i] - level).abs() < near)
        };
        (0..3).any(|i| on(i, low[i]) || on(i, high[i]))
    };
    // Both sides of an interface are one place.
    let key = |face: Face| {
        let mut key: Vec<u32> =
            model.mesh.face_nodes(face).map(|n| model.parted.places[n as usize]).collect();
        key.sort_unstable();
        key
    };
    let standing = model.standing(Stage::Shaking);
    let mut meeting: BTreeMap<Vec<u32>, Vec<Face>> = BTreeMap::new();
    all_faces(&model.mesh, Some(&standing)).for_each(|face| meeting.entry(key(face)).or_default().push(face));
    let wet = |face: &Face| model.water.undrained(face.element as usize).is_some();
    let drained = |face: &Face| !wet(face) && model.water.is_porous(face.element as usize);
    let mut found = BTreeSet::new();
    for faces in meeting.values() {
        let ends = match faces[..] {
            [face] => !on_a_plane(face),
            _ => faces.iter().any(drained),
        };
        found.extend(faces.iter().filter(|face| ends && wet(face)).map(|face| face.element));
    }
    found.into_iter().collect()
}

/// How much of the ground it is.
pub(super) fn fact(evidence: &Evidence) -> Option<Fact> {
    let count = undrained(evidence.model).count();
    (count > 0).then(|| {
        Fact::new(
            "undrained_elements",
            said!("elements whose water cannot leave in the earthquake"),
            count as f64,
            "",
            said!(
                "they had water in their pores when it began; which of drained and undrained moves a lining more depends on the case: run it \
                 with [water] earthquake = \"drained\" as well"
            ),
        )
    })
}
