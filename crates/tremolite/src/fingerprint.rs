//! What ties a checkpoint to its model and plan: whatever changes the run changes this number.

use crate::plan::Plan;
use crate::stages::PlannedStage;
use std::fmt::Debug;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::boundary::Boundaries;
use tremolite_engine::model::{Elements, Loading, Model, Scheme};

/// Times at which the factor of a load is looked at: a function cannot be compared otherwise.
const LOOKS: u32 = 64;

struct Hasher(crc32fast::Hasher);

impl Hasher {
    fn number(&mut self, x: f64) {
        self.0.update(&x.to_bits().to_le_bytes());
    }

    fn numbers<'x>(&mut self, all: impl IntoIterator<Item = &'x f64>) {
        all.into_iter().for_each(|&x| self.number(x));
    }

    fn indices(&mut self, all: &[u32]) {
        all.iter().for_each(|n| self.0.update(&n.to_le_bytes()));
    }

    /// A value by its debug form, which names its variants and prints numbers so that they can be told apart.
    fn shown(&mut self, value: &impl Debug) {
        self.0.update(format!("{value:?}").as_bytes());
    }
}

/// Two sums over everything that defines a run: of space, and of what happens in it. What a model or a plan gains does not compile
/// before it is said here whether it counts.
pub(crate) fn fingerprint(model: &Model, assembly: &Assembly, plan: &Plan, dt: f64) -> u64 {
    let Model {
        mesh,
        bodies,
        elements,
        seams,
        bolts,
        boundaries,
        loading,
        scheme,
        nodes,
        water,
        // Follow from these, or are what the members below are made of.
        user: _,
        patches: _,
        mesh_node: _,
        engine_node: _,
        domains: _,
        faces: _,
        parted: _,
        outside: _,
    } = model;
    let Elements {
        lives,
        stand_ins,
        viscosity,
        initial,
        // Follow from the rest, or are what the members below are made of.
        body_of: _,
        successors: _,
        parents: _,
        thickness: _,
        columns: _,
        linked: _,
        frequencies: _,
    } = elements;
    let Boundaries {
        base,
        sides,
        side_springs,
        top,
        bed,
        prescribed,
        held,
        ties,
        incident,
        // That of the plan's waves; other formulas are in no file, as parts are: a program that resumes must give the same again.
        free_field: _,
    } = boundaries;
    let Loading { gravity, tractions, loads, parts: _ } = loading;
    let Scheme {
        rayleigh,
        // Its step is `dt`.
        time_step: _,
        // The bits are the same.
        isa: _,
        // The members below are made by it.
        patch_elements: _,
    } = scheme;
    let Plan {
        stages,
        duration,
        histories,
        snapshots,
        monitors,
        pairs,
        bolts: bolt_monitors,
        relatives,
        sections,
        // The wave follows from it.
        recorded: _,
        waves,
        // Change nothing that is remembered.
        bars: _,
        // That of the model.
        water: _,
        title: _,
        page: _,
        boundaries: _,
        target: _,
        fields: _,
        field_elements: _,
        checkpoint: _,
    } = plan;
    let mut space = Hasher(crc32fast::Hasher::new());
    space.numbers(mesh.nodes.iter().flatten());
    for element in &mesh.elements {
        space.indices(&element.nodes);
    }
    for body in bodies {
        space.shown(&(&body.name, body.quadrature, body.density));
        space.shown(&(body.material.info().name, body.material.values(), body.material.band()));
        space.indices(&body.elements);
    }
    space.shown(&(base, sides, side_springs, held, ties));
    for (seam, contacts) in seams.iter().zip(&assembly.contacts) {
        space.shown(&(&seam.name, contacts.law.info().name, contacts.law.values(), contacts.frequency));
        for pair in &seam.pairs {
            space.indices(&pair.nodes);
            space.numbers(pair.normal.iter().chain([&pair.normal_area]));
        }
    }
    for set in bolts {
        space.shown(&set.kind);
        for bolt in &set.bolts {
            space.shown(&bolt.segments);
            space.numbers(bolt.points.iter().flat_map(|p| p.weights.iter().map(|(_, weight)| weight)));
        }
    }
    for (member, slices) in assembly.members.iter().zip(&assembly.slices) {
        space.shown(&(&member.name, &member.life, member.counted, slices));
        space.indices(member.part.nodes());
        space.numbers(&member.masses);
    }
    // What flows follows from the pressures below; how long it took to find is no part of a model.
    let bare = |stage: &PlannedStage| PlannedStage { flow: None, ..stage.clone() };
    let stages: Vec<PlannedStage> = stages.iter().map(bare).collect();
    space.shown(&(stages, gravity, stand_ins, tractions, bed, prescribed));
    space.shown(lives);
    space.numbers(initial.iter().flatten());
    if !water.spells.is_empty() {
        space.numbers(water.biot.iter().chain(&water.modulus));
        for spell in &water.spells {
            space.shown(&spell.from);
            space.numbers(spell.elements.iter().chain(&spell.nodes));
        }
    }

    let mut time = Hasher(crc32fast::Hasher::new());
    time.shown(&(dt, duration, histories, snapshots, rayleigh, top));
    // While time stands still before the shaking these do nothing.
    time.0.update(if nodes.coarsest() > 0 { &nodes.level } else { &[] });
    time.numbers(viscosity);
    time.shown(&seams.iter().map(|seam| seam.damping).collect::<Vec<_>>());
    if let Some(incident) = incident {
        time.number(incident.factor);
        time.number(incident.motion.dt);
        time.numbers(incident.motion.acceleration.iter().flatten());
    }
    if let Some(waves) = waves {
        time.shown(&waves.frame);
        for wave in &waves.waves {
            time.shown(&wave.heading);
            time.numbers(wave.factors.iter().flat_map(|factor| [&factor.re, &factor.im]));
        }
        time.number(waves.motion.dt);
        time.numbers(waves.motion.acceleration.iter().flatten());
    }
    for load in loads {
        time.shown(&load.forces);
        for k in 0..=LOOKS {
            time.number((load.factor)(duration * f64::from(k) / f64::from(LOOKS)));
        }
    }
    if !sections.is_empty() {
        time.shown(sections);
    }
    for monitor in monitors {
        time.shown(&(&monitor.name, monitor.point));
    }
    for pair in pairs {
        time.shown(&(&pair.name, pair.point, pair.interface));
    }
    for bolt in bolt_monitors {
        time.shown(&(&bolt.name, bolt.point, bolt.set));
    }
    time.shown(relatives);
    u64::from(space.0.finalize()) << 32 | u64::from(time.0.finalize())
}
