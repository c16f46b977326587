//! How far a run can be trusted: each line a number against a limit.

use crate::evidence::Evidence;
use crate::observers::{ENERGY_MEMORY, FREE_FIELD_MEMORY};
use crate::survey::limit_in_words;
use tremolite_engine::extent::extents;
use tremolite_engine::hexahedra::hex;
use tremolite_engine::model::Model;
use tremolite_laws::Role;
use tremolite_laws::parameter::position;
use tremolite_results::{Table, TrustLine};

/// Elements a wavelength below which a wave's amplitude and speed suffer (Kuhlemeyer & Lysmer 1973).
const PER_WAVELENGTH: f64 = 8.0;
/// Energy that may be lost or found, over all that was supplied.
const ENERGY_ERROR: f64 = 0.01;
/// Energy that material laws may create, over what they dissipated.
const CREATED: f64 = 0.05;
/// Energy of the hourglass stabilisation over the strain energy at the same time.
const HOURGLASS: f64 = 0.1;
/// Strain energy over its largest value below which a model counts as still.
const STILL: f64 = 0.01;
/// Difference of the free field's velocity from theory, over its peak.
const FREE_FIELD: f64 = 0.05;
/// Displacement of the input at its end over its peak.
const DRIFT: f64 = 0.1;
/// Fracture energy of a weak concrete \[N/m\]: `mc1990`, G_F0 (f_cm/10 MPa)^0.7 with 25 N/m for 8 mm of aggregate and
/// f_cm = 28 MPa. Less means that elements crack for less than a crack takes.
const CRACK_ENERGY: f64 = 50.0;

/// Damage in tension above which a point carries nothing.
const BROKEN: f64 = 0.99;

/// Monitors in elements that tension has broken through: nothing holds such pieces, so their displacements mean little.
fn broken_monitors(evidence: &Evidence) -> Option<TrustLine> {
    let Evidence { assembly, phase, plan, outcome, .. } = evidence;
    let history = outcome.history(assembly);
    let mut judged = false;
    let mut broken: Vec<&str> = Vec::new();
    for monitor in &plan.monitors {
        let Some(slot) = &phase.element_slot[monitor.location.element as usize] else { continue };
        let Some(column) = history.with_role(slot, Role::TensionDamage) else { continue };
        judged = true;
        if history.values(slot, column).all(|d| d > BROKEN) {
            broken.push(&monitor.name);
        }
    }
    let note = if broken.is_empty() {
        "elements whose every point is broken in tension are loose pieces".to_owned()
    } else {
        format!(
            "{}: every point of the element is broken; its displacement is that of a loose piece",
            broken.join(", ")
        )
    };
    judged.then(|| {
        TrustLine::at_most("monitors on broken elements", broken.len() as f64, 0.0, "").with_note(note)
    })
}

pub(crate) fn trust(evidence: &Evidence) -> Vec<TrustLine> {
    let Evidence { model, assembly, phase, motion, survey, outcome, .. } = evidence;
    let mut lines = Vec::new();
    if let Some(coarsest) = survey.coarsest() {
        lines.push(
            TrustLine::at_least("elements per shortest wavelength", coarsest.per_wavelength, PER_WAVELENGTH, "")
                .with_note(format!(
                    "shear waves of {:.1} Hz (99.9 % of the input's energy lies below) along the longest edge of {}",
                    motion.highest_frequency,
                    model.element_name(coarsest.coarsest as usize)
                )),
        );
    }
    let stable = &outcome.stable;
    lines.push(TrustLine::at_most("time step over stable step", outcome.dt / stable.dt, 1.0, "").with_note(
        format!(
            "set by {}; the estimate changed by {:.0e} in the last of {} iterations",
            limit_in_words(model, assembly, stable),
            stable.change,
            stable.iterations
        ),
    ));
    let memory = |key: &str| outcome.state.observers.get(key).cloned().unwrap_or_default();
    if let [_, error, dissipated, created] = memory(ENERGY_MEMORY)[..] {
        let supplied = outcome.state.ledger.supplied;
        if supplied > 0.0 {
            let note = if phase.keeps_books {
                "largest difference between the energy found and the energy put in"
            } else {
                "says nothing of damping over a band, whose line is what all others leave"
            };
            lines.push(
                TrustLine::at_most("energy error over energy supplied", error / supplied, ENERGY_ERROR, "")
                    .with_note(note),
            );
        }
        if dissipated > 0.0 {
            lines.push(
                TrustLine::at_most(
                    "energy created by laws over energy dissipated",
                    created / dissipated,
                    CREATED,
                    "",
                )
                .with_note(
                    "what closed strain loops of cracked concrete gave out; split = \"compliance\" cannot",
                ),
            );
        }
    }
    lines.extend(hourglass(evidence.energy));
    lines.extend(free_field(&memory(FREE_FIELD_MEMORY)));
    lines.extend(unstressed(model));
    lines.extend(broken_monitors(evidence));
    if let Some(incident) = &model.incident {
        let u = &incident.motion.displacement;
        let worst = (0..3)
            .filter_map(|i| {
                let peak = u[i].iter().fold(0.0_f64, |m, x| m.max(x.abs()));
                let last = u[i].last()?.abs();
                (peak > 0.0).then(|| last / peak)
            })
            .fold(0.0, f64::max);
        lines.push(
            TrustLine::at_most("input displacement at its end over its peak", worst, DRIFT, "").with_note(
                "a large value is drift of the record, which the model follows: filter or taper it",
            ),
        );
    }
    lines.extend(crack_energies(model));
    let warnings: Vec<String> = model
        .user_bodies()
        .iter()
        .flat_map(|b| b.material.warnings().into_iter().map(|w| format!("{}: {w}", b.name)))
        .collect();
    if !warnings.is_empty() {
        let note = warnings.join("; ");
        lines.push(
            TrustLine::at_most("warnings of material laws", warnings.len() as f64, 0.0, "").with_note(note),
        );
    }
    lines
}

/// The largest ratio of hourglass to strain energy, row by row.
fn hourglass(energy: &Table) -> Option<TrustLine> {
    let [time, hourglass, strain] = ["time", "hourglass", "strain"].map(|name| energy.column(name));
    let (time, hourglass, strain) = (time?, hourglass?, strain?);
    let most = strain.iter().copied().fold(0.0, f64::max);
    // Before the wave comes and when it has passed, both are noise.
    let ratio = |row: usize| hourglass[row] / strain[row].max(STILL * most);
    let row = (0..time.len()).max_by(|a, b| ratio(*a).total_cmp(&ratio(*b)))?;
    (most > 0.0).then(|| {
        TrustLine::at_most("hourglass energy over strain energy", ratio(row), HOURGLASS, "").with_note(format!(
            "largest ratio of all rows, at {:.2} s: energy of the one-point elements' stabilisation, bending that their \
             one point misses",
            time[row]
        ))
    })
}

/// The reference column's top against theory.
fn free_field(memory: &[f64]) -> Option<TrustLine> {
    const NAME: &str = "free field against theory";
    let &[difference, seen, peak, damaged] = memory else { return None };
    if peak == 0.0 {
        None
    } else if damaged > 0.0 {
        Some(TrustLine::not_applicable(
            NAME,
            "the rock of the reference column yields or cracks, and theory is elastic",
        ))
    } else if seen < 0.5 * peak {
        Some(TrustLine::not_applicable(NAME, "the rows of the histories are too few to show the wave"))
    } else {
        Some(TrustLine::at_most(NAME, difference / peak, FREE_FIELD, "").with_note(
            "velocity at the top of the reference column against one-dimensional theory, damping included",
        ))
    }
}

/// Rock that yields by its pressure, without the pressure: no stage of a run gives it an initial stress yet.
fn unstressed(model: &Model) -> Option<TrustLine> {
    let plastic = [Role::PlasticShear, Role::PlasticTension];
    let bodies = model.user_bodies().iter().filter(|body| {
        let info = body.material.info();
        info.pressure_dependent && plastic.iter().any(|&role| position(info.history, role).is_some())
    });
    let names: Vec<&str> = bodies.map(|b| b.name.as_str()).collect();
    (!names.is_empty()).then(|| {
        TrustLine::at_most("yielding rock without initial stress", names.len() as f64, 0.0, "").with_note(format!(
            "{}: strength grows with pressure, and the weight of the ground is not in this run; it yields earlier and \
             further than in place, most of all in tension",
            names.join("; ")
        ))
    })
}

/// What cracks across the elements dissipate, a line for each body whose law can crack.
fn crack_energies(model: &Model) -> Vec<TrustLine> {
    let mut lines = Vec::new();
    for body in model.user_bodies() {
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for &element in &body.elements {
            let Ok(hex) = hex(&model.mesh, element as usize) else { continue };
            for energy in extents(&hex).into_iter().filter_map(|h| body.material.crack_energy(h)) {
                (least, most) = (least.min(energy), most.max(energy));
            }
        }
        if least <= most {
            let name = format!("implied fracture energy, {}", body.name);
            lines.push(TrustLine::at_least(&name, least, CRACK_ENERGY, "N/m").with_note(format!(
                "{least:.0} to {most:.0} N/m for cracks across the elements' shortest to longest extents; where a \
                 law softens by strain alone this grows with the element"
            )));
        }
    }
    lines
}
