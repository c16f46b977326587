//! What can be said of a model before it runs: materials, steps, wavelengths, memory.

use crate::places;
use rayon::prelude::*;
use tremolite_engine::Domain;
use tremolite_engine::ModelError;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::hexahedra::{centroid, hex};
use tremolite_engine::model::Model;
use tremolite_engine::{Life, Limit, StableStep};
use tremolite_kernels::Quadrature;
use tremolite_laws::Row;
use tremolite_laws::shapes::hex8::{
    BrickField, BrickGeometry, FullGeometry, LayeredGeometry, OnePointGeometry,
};
use tremolite_results::{Said, said};

/// Bytes an element beside the state and the kernels' geometry: mesh, groups, and fields on their way to a file.
/// Measured on 13,452 and 76,992 elements, 970 and 870.
const AROUND: usize = 900;
/// Bytes of the program without a model.
const PROGRAM: usize = 12 << 20;

/// One body of the user.
#[derive(Clone, Debug)]
pub struct BodySurvey {
    pub name: String,
    pub law: &'static str,
    pub quadrature: Quadrature,
    pub elements: usize,
    pub density: f64,
    /// P and S wave speeds \[m/s\].
    pub wave_speeds: (f64, f64),
    /// 2/ω of its stiffest element alone \[s\], and that element: what the body could run with at best.
    pub element_step: f64,
    /// The same without water that cannot leave its pores \[s\]; none where it has none.
    pub drained_step: Option<f64>,
    pub stiffest: u32,
    /// Fewest elements a shear wave of the highest frequency has along an element's longest edge, and where.
    pub per_wavelength: f64,
    pub coarsest: u32,
}

/// A model at a glance.
#[derive(Clone, Debug)]
pub struct Survey {
    pub bodies: Vec<BodySurvey>,
    pub active_elements: usize,
    pub void_elements: usize,
    /// Of the slabs outside free-field sides, and of columns.
    pub slab_elements: usize,
    pub column_elements: usize,
    pub nodes: usize,
    /// Bytes that a run takes at its peak, about.
    pub bytes: usize,
    /// What of it several ranks share: parts, what they remember and what they push with.
    pub shared: usize,
}

impl Survey {
    /// The body with fewest elements a wavelength.
    pub fn coarsest(&self) -> Option<&BodySurvey> {
        self.bodies.iter().min_by(|a, b| a.per_wavelength.total_cmp(&b.per_wavelength))
    }
}

/// The step \[s\] of a body's stiffest element alone if its pressures stayed; none where they do.
fn drained_step(model: &Model, lasting: &[u32]) -> Option<f64> {
    lasting.iter().find(|&&e| model.water.undrained(e as usize).is_some())?;
    Some(2.0 / lasting.iter().map(|&e| model.elements.frequencies[e as usize]).fold(0.0, f64::max))
}

/// Surveys a model for waves up to `frequency` \[Hz\].
///
/// # Errors
/// If an element's geometry cannot be used; [`Model::new`] has checked that.
pub fn survey(model: &Model, assembly: &Assembly, frequency: f64) -> Result<Survey, ModelError> {
    let mut bodies = Vec::new();
    for body in model.user_bodies() {
        let moduli = body.material.moduli();
        let speeds = moduli.wave_speeds(body.density);
        let wavelength = speeds.1 / frequency;
        // (ω, element) and (elements a wavelength, element), worst first.
        let lasting = model.lasting(body);
        let worst = lasting
            .par_chunks(64)
            .map(|chunk| {
                let omegas = model.frequencies(body, chunk);
                let mut worst = ((0.0_f64, 0), (f64::INFINITY, 0));
                for (&e, omega) in chunk.iter().zip(omegas) {
                    let Ok(hex) = hex(&model.mesh, e as usize) else { continue };
                    let longest = 2.0 * hex.half_lengths.iter().copied().fold(0.0, f64::max);
                    if omega > worst.0.0 {
                        worst.0 = (omega, e);
                    }
                    if wavelength / longest < worst.1.0 {
                        worst.1 = (wavelength / longest, e);
                    }
                }
                worst
            })
            .collect::<Vec<_>>();
        let (omega, stiffest) =
            worst.iter().map(|w| w.0).fold((0.0, 0), |a, b| if b.0 > a.0 { b } else { a });
        let (per_wavelength, coarsest) =
            worst.iter().map(|w| w.1).fold((f64::INFINITY, 0), |a, b| if b.0 < a.0 { b } else { a });
        bodies.push(BodySurvey {
            name: body.name.clone(),
            law: body.material.info().name,
            quadrature: body.quadrature,
            elements: lasting.len(),
            density: body.density,
            wave_speeds: speeds,
            element_step: 2.0 / omega,
            drained_step: drained_step(model, &lasting),
            stiffest,
            per_wavelength,
            coarsest,
        });
    }
    let active = bodies.iter().map(|b| b.elements).sum();
    let totals = assembly.totals();
    let row = size_of::<Row>();
    // Of all that is ever there, slabs and columns included.
    let geometry: usize = model
        .patches
        .iter()
        .map(|patch| {
            let octet = match model.bodies[patch.body].quadrature {
                Quadrature::OnePoint if patch.bricks => size_of::<BrickGeometry>(),
                Quadrature::OnePoint => size_of::<OnePointGeometry>(),
                Quadrature::Full | Quadrature::Layered(_) if patch.bricks => size_of::<BrickField>(),
                Quadrature::Full => size_of::<FullGeometry>(),
                Quadrature::Layered(_) => size_of::<LayeredGeometry>(),
            };
            patch.elements.len() * (octet / 8 + 16)
        })
        .sum();
    let ever: usize = model.bodies.iter().map(|b| b.elements.len()).sum();
    let nodes = model.mesh_node.len();
    let staged =
        !model.elements.initial.is_empty() || model.elements.lives.iter().any(|life| *life != Life::ALWAYS);
    let state = 64 * (totals.history.end + totals.overstress.end + totals.initial.end)
        + row * totals.reference.end
        + 8 * totals.numbers.end;
    // Where results count from, what is held, where a relaxation began, masses; what parts did at the hand-over; and a copy of
    // the state, which the quiet run shakes.
    let stages = if staged { nodes * (8 * row + 8) + 4 * row * totals.contributions.end + state } else { 0 };
    let pushes = row * totals.contributions.end;
    let carried = if staged { 4 * pushes + state } else { 0 };
    Ok(Survey {
        bodies,
        active_elements: active,
        slab_elements: model.outside.slabs.iter().map(|slab| slab.sheet.twins.len()).sum(),
        column_elements: model.outside.columns.iter().map(|column| column.layers.len()).sum(),
        void_elements: model.user.elements - model.elements.stand_ins.len() - active,
        nodes: model.nodes.of(Domain::Model).count(),
        shared: geometry + state + carried + pushes + totals.points.end * 48 + totals.elements.end * 16,
        bytes: geometry
            + state
            + stages
            + (row + 4) * totals.contributions.end
            + nodes * (5 * row + 16)
            + totals.points.end * 48
            + totals.elements.end * 16
            + ever * AROUND
            + PROGRAM,
    })
}

/// What sets the stable step, in words.
pub fn limit_in_words(model: &Model, assembly: &Assembly, stable: &StableStep) -> Said {
    match &stable.limit {
        Limit::Element(e) => {
            let place = places::point(centroid(&model.mesh, model.elements.parents[*e as usize]));
            said!("{what} at {place}", what = places::element(model, *e as usize), place = place)
        }
        Limit::Part { member, node } => said!(
            "{part} at node {node} at {place}",
            part = places::part(&assembly.members[*member as usize].name),
            node = model.mesh.node_id(*node as usize).to_string(),
            place = places::point(model.mesh.nodes[*node as usize]),
        ),
        Limit::Damping => said!("Rayleigh damping, mostly its stiffness-proportional part"),
    }
}

/// What impacts at interfaces allow, in words, where there are any.
pub fn impacts_in_words(model: &Model, stable: &StableStep) -> Option<Said> {
    let contact = stable.contact?;
    let seam = &model.seams[contact.interface];
    Some(said!(
        "impacts allow {step} s, ω_c Δt = {limit} at {pair}",
        step = format!("{:.3e}", contact.dt),
        limit = seam.limit.to_string(),
        pair = places::pair(&model.mesh, seam, contact.pair),
    ))
}

/// What sets the step that is used, in words.
pub fn step_in_words(model: &Model, assembly: &Assembly, stable: &StableStep) -> Said {
    let shorter =
        stable.contact.is_some_and(|contact| contact.dt < model.scheme.time_step.safety * stable.dt);
    let impacts = impacts_in_words(model, stable).filter(|_| shorter);
    impacts.unwrap_or_else(|| limit_in_words(model, assembly, stable))
}
