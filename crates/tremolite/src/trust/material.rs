//! Checks of what the material laws assume and did.

use crate::evidence::Evidence;
use crate::phrases::clauses;
use tremolite_engine::Body;
use tremolite_engine::extent::extents;
use tremolite_engine::hexahedra::hex;
use tremolite_engine::model::Model;
use tremolite_laws::Role;
use tremolite_laws::parameter::position;
use tremolite_results::{Fact, Said, TrustLine, said, snake};

/// Fracture energy of a weak concrete \[N/m\]: `mc1990`, G_F0 (f_cm/10 MPa)^0.7 with 25 N/m for 8 mm of aggregate and
/// f_cm = 28 MPa. Less means that elements crack for less than a crack takes.
const CRACK_ENERGY: f64 = 50.0;

/// Damage in tension above which a point carries nothing.
const BROKEN: f64 = 0.99;

pub(super) fn lines(evidence: &Evidence) -> Vec<TrustLine> {
    let mut lines = vec![unstressed(evidence.model), broken_monitors(evidence)];
    lines.extend(crack_energies(evidence.model));
    lines.push(warnings(evidence.model));
    lines
}

/// How many monitors are in a material that cracks, and which of them in elements that tension has broken through: nothing holds
/// such pieces.
pub(crate) fn on_broken_elements<'a>(evidence: &Evidence<'a>) -> (u32, Vec<&'a str>) {
    let Evidence { assembly, phase, plan, outcome, .. } = evidence;
    let history = outcome.history(assembly);
    let mut judged = 0;
    let mut broken: Vec<&str> = Vec::new();
    for monitor in &plan.monitors {
        let Some(slot) = &phase.element_slot[monitor.location.element as usize] else { continue };
        let Some(column) = history.with_role(slot, Role::TensionDamage) else { continue };
        judged += 1;
        if history.values(slot, column).all(|d| d > BROKEN) {
            broken.push(&monitor.name);
        }
    }
    (judged, broken)
}

/// Monitors on pieces that came loose: their displacements mean little.
fn broken_monitors(evidence: &Evidence) -> TrustLine {
    const ID: &str = "monitors_on_broken_elements";
    let name = said!("monitors on broken elements");
    let (judged, broken) = on_broken_elements(evidence);
    if judged == 0 {
        return TrustLine::not_applicable(ID, name, said!("no monitor is in a material that can crack"));
    }
    let note = if broken.is_empty() {
        said!("nothing holds an element with all points broken in tension")
    } else {
        said!(
            "{monitors}: every point of the element is broken in tension; its displacement is not the lining's",
            monitors = broken.join(", "),
        )
    };
    TrustLine::at_most(ID, name, broken.len() as f64, 0.0, "")
        .with("judged", f64::from(judged))
        .with_note(note)
}

/// Rock that yields by its pressure, without the pressure.
fn unstressed(model: &Model) -> TrustLine {
    const ID: &str = "yielding_rock_without_initial_stress";
    let name = said!("yielding rock without initial stress");
    if !model.elements.initial.is_empty() {
        return TrustLine::not_applicable(ID, name, said!("the ground begins with initial stress"));
    }
    let plastic = [Role::PlasticShear, Role::PlasticTension];
    let bodies = model.user_bodies().iter().filter(|body| {
        let info = body.material.info();
        info.pressure_dependent && plastic.iter().any(|&role| position(info.history, role).is_some())
    });
    let names: Vec<&str> = bodies.map(|b| b.name.as_str()).collect();
    if names.is_empty() {
        return TrustLine::not_applicable(ID, name, said!("no rock's strength depends on its pressure"));
    }
    TrustLine::at_most(ID, name, names.len() as f64, 0.0, "").with_note(said!(
        "{names}: strength grows with pressure, and the weight of the ground is not in this run; it yields earlier and further \
         than in place, most of all in tension",
        names = names.join("; "),
    ))
}

/// The least and the largest energy of cracks across a body's elements \[N/m\], if its law cracks.
fn crack_energy(model: &Model, body: &Body) -> Option<[f64; 2]> {
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for &element in &model.lasting(body) {
        let Ok(hex) = hex(&model.mesh, element as usize) else { continue };
        for energy in extents(&hex).into_iter().filter_map(|h| body.material.crack_energy(h)) {
            (least, most) = (least.min(energy), most.max(energy));
        }
    }
    (least <= most).then_some([least, most])
}

/// Whether the energy of a crack is given, by the case, a grade or f_c: then every size of element dissipates it.
fn given_energy(body: &Body) -> bool {
    body.material.size_limit().is_finite()
}

/// What cracks across the elements dissipate, a line for each body whose law softens by strain alone.
fn crack_energies(model: &Model) -> Vec<TrustLine> {
    const ID: &str = "implied_fracture_energy";
    let mut lines = Vec::new();
    for body in model.user_bodies().iter().filter(|body| !given_energy(body)) {
        let Some([least, most]) = crack_energy(model, body) else { continue };
        let id = format!("{ID}_{}", snake(&body.name));
        let name = said!("implied fracture energy, {body}", body = &body.name);
        lines.push(
            TrustLine::at_least(id, name, least, CRACK_ENERGY, "N/m")
                .with("least", least)
                .with("most", most)
                .with_note(said!(
                    "{least} to {most} N/m for cracks across the elements' shortest to longest extents: a law that softens by \
                     strain alone dissipates more the larger the element; give fracture_energy",
                    least = format!("{least:.0}"),
                    most = format!("{most:.0}"),
                )),
        );
    }
    if lines.is_empty() {
        let name = said!("implied fracture energy");
        lines.push(TrustLine::not_applicable(ID, name, said!("no law has a softening in strain alone")));
    }
    lines
}

/// Fracture energies that do not go by the element.
pub(super) fn facts(model: &Model) -> Vec<Fact> {
    let given = model.user_bodies().iter().filter(|body| given_energy(body));
    given
        .filter_map(|body| {
            let [energy, _] = crack_energy(model, body)?;
            let id = format!("fracture_energy_{}", snake(&body.name));
            let name = said!("fracture energy, {body}", body = &body.name);
            let note = said!("cracks dissipate it in elements of any size");
            Some(Fact::new(id, name, energy, "N/m", note))
        })
        .collect()
}

fn warnings(model: &Model) -> TrustLine {
    let of = |body: &Body| {
        body.material.warnings().into_iter().map(|w| (body.name.clone(), w)).collect::<Vec<_>>()
    };
    let warnings: Vec<(String, String)> = model.user_bodies().iter().flat_map(of).collect();
    let line = TrustLine::at_most(
        "law_warnings",
        said!("warnings of material laws"),
        warnings.len() as f64,
        0.0,
        "",
    );
    // As the laws say them, in English alone.
    line.with_note(clauses(
        warnings
            .into_iter()
            .map(|(body, warning)| said!("{body}: {warning}", body = body, warning = Said::plain(&warning))),
    ))
}
