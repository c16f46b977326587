//! Laws from outside the list: what ARCHITECTURE.md, 'How to add a law', says.

use crate::block::block;
use crate::ready::Ready;
use indexmap::IndexMap;
use std::sync::atomic::AtomicBool;
use tremolite::evidence::Evidence;
use tremolite::plan::{Monitor, Plan};
use tremolite::run::{Control, run};
use tremolite::setup::{MotionFacts, Peaks};
use tremolite::simulation::{Built, Simulation, Start};
use tremolite::summary::summary;
use tremolite::survey::survey;
use tremolite::{Engine, Law, Phase, Problem, Stage};
use tremolite_laws::band::Band;
use tremolite_laws::materials::elastic::{POISSON, YOUNG, read_moduli};
use tremolite_laws::{
    BadParameter, Column, Dimension, Kind, Lane, Material, Moduli, Need, Parameter, Point, Role, Row, Sym,
    Values,
};
use tremolite_mesh::locate::Locator;
use tremolite_motion::{Intensity, Kind as MotionKind};
use tremolite_results::{ResultFolder, RunFacts, Summary, Table};

/// Elastic in compression; carries no mean tension beyond a limit. A toy, with one history variable.
struct NoTension {
    moduli: Moduli,
    limit: f64,
}

impl Material for NoTension {
    const NAME: &'static str = "no-tension";
    const SUMMARY: &'static str = "elastic with a limit on mean tension";
    const SOURCE: &'static str = "none";
    const PARAMETERS: &'static [Parameter] = &[
        YOUNG,
        POISSON,
        Parameter {
            name: "mean_tension",
            kind: Kind::Number(Dimension::PRESSURE),
            need: Need::Number(0.0),
            doc: "largest mean tension",
        },
    ];
    const HISTORY: &'static [Column] = &[Column::new("opened", "1", "1 once the limit was reached")];
    type History<L: Lane> = [L; 1];

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        Ok(NoTension {
            moduli: read_moduli(values)?,
            limit: values.number("mean_tension").map_err(|e| vec![e])?,
        })
    }

    fn moduli(&self) -> Moduli {
        self.moduli
    }

    fn scaled(&self, factor: f64) -> Self {
        NoTension { moduli: self.moduli.scaled(factor), ..*self }
    }

    #[inline(always)]
    fn update<L: Lane>(&self, _: &Point<L>, e: Sym<L>, h: [L; 1]) -> (Sym<L>, [L; 1]) {
        let (one, limit) = (L::splat(1.0), L::splat(self.limit));
        let mu2 = L::splat(2.0 * self.moduli.mu);
        let trace = e[0] + e[1] + e[2];
        let mean = L::splat(self.moduli.lambda + 2.0 / 3.0 * self.moduli.mu) * trace;
        let over = limit.less(mean);
        let kept = L::select(over, limit, mean);
        let opened = L::select(over, one, h[0]);
        let shift = kept - mu2 * trace * L::splat(1.0 / 3.0);
        let half = L::splat(self.moduli.mu);
        (
            [
                mu2.mul_add(e[0], shift),
                mu2.mul_add(e[1], shift),
                mu2.mul_add(e[2], shift),
                half * e[3],
                half * e[4],
                half * e[5],
            ],
            [opened],
        )
    }
}

#[test]
fn a_law_from_outside_the_list_runs_in_the_engine_with_its_history() {
    let values = Values::default().with("young", 1e9).with("poisson", 0.25).with("mean_tension", 1e4);
    let law = Law::of::<NoTension>();
    assert_eq!(law.info.name, "no-tension");
    assert!((law.info.check)(&Values::default()).is_err(), "missing moduli are refused");

    let mut problem = block([5, 4, 6]);
    for body in &mut problem.bodies {
        body.material = (law.build)(&values).unwrap();
    }
    let ready = Ready::new(problem);
    let mut state = ready.rest(0.9);
    let mut engine = ready.engine();
    let mut most = f64::NEG_INFINITY;
    while state.time() < 0.3 {
        let snapshot = engine.look(&state).snapshot;
        for slot in ready.phase.element_slot.iter().flatten() {
            for s in &snapshot.stress[slot.point as usize..][..slot.points as usize] {
                most = most.max((s[0] + s[1] + s[2]) / 3.0);
            }
        }
        engine.step(&mut state);
    }
    assert!((most - 1e4).abs() < 1.0, "mean tension stops at its limit: {most}");
    assert!(state.history.iter().flat_map(|o| o.0).any(|opened| opened == 1.0));
}

/// √J₂ of the stress stops at a limit, whatever the pressure. A toy: it has no plastic strain, and remembers the largest
/// excess of the elastic √J₂ over 2μ as `kappa`. Its moduli have names of their own.
struct Metal {
    bulk: f64,
    shear: f64,
    limit: f64,
}

const fn modulus(name: &'static str) -> Parameter {
    Parameter { name, kind: Kind::Number(Dimension::PRESSURE), need: Need::Required, doc: "a modulus" }
}

impl Material for Metal {
    const NAME: &'static str = "metal";
    const SUMMARY: &'static str = "elastic with a limit on shear";
    const SOURCE: &'static str = "none";
    const PARAMETERS: &'static [Parameter] = &[modulus("K"), modulus("G"), modulus("limit")];
    const HISTORY: &'static [Column] =
        &[Column::with_role("kappa", "1", Role::PlasticShear, "largest excess so far")];
    type History<L: Lane> = [L; 1];

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        let number = |name| values.number(name).map_err(|e| vec![e]);
        Ok(Metal { bulk: number("K")?, shear: number("G")?, limit: number("limit")? })
    }

    fn moduli(&self) -> Moduli {
        Moduli { lambda: self.bulk - 2.0 / 3.0 * self.shear, mu: self.shear }
    }

    fn scaled(&self, factor: f64) -> Self {
        Metal { bulk: factor * self.bulk, shear: factor * self.shear, ..*self }
    }

    #[inline(always)]
    fn update<L: Lane>(&self, _: &Point<L>, e: Sym<L>, h: [L; 1]) -> (Sym<L>, [L; 1]) {
        let mut stress = self.moduli().stress(&e);
        let mean = (stress[0] + stress[1] + stress[2]) * L::splat(1.0 / 3.0);
        let d = [stress[0] - mean, stress[1] - mean, stress[2] - mean];
        let normal = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        let shear = stress[3] * stress[3] + stress[4] * stress[4] + stress[5] * stress[5];
        let size = (L::splat(0.5) * normal + shear).sqrt();
        let limit = L::splat(self.limit);
        let share = limit / size.larger(limit);
        for k in 0..3 {
            stress[k] = mean + share * d[k];
            stress[k + 3] = share * stress[k + 3];
        }
        let excess = (size - limit) * L::splat(0.5 / self.shear);
        (stress, [h[0].larger(excess)])
    }
}

/// The same, which says that it books what it takes, and books nothing.
struct Silent(Metal);

impl Material for Silent {
    const NAME: &'static str = "silent";
    const SUMMARY: &'static str = Metal::SUMMARY;
    const SOURCE: &'static str = Metal::SOURCE;
    const PARAMETERS: &'static [Parameter] = Metal::PARAMETERS;
    const HISTORY: &'static [Column] =
        &[Metal::HISTORY[0], Column::with_role("taken", "J/m3", Role::Dissipated, "always 0")];
    type History<L: Lane> = [L; 2];

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        Metal::new(values).map(Silent)
    }

    fn moduli(&self) -> Moduli {
        self.0.moduli()
    }

    fn scaled(&self, factor: f64) -> Self {
        Silent(self.0.scaled(factor))
    }

    #[inline(always)]
    fn update<L: Lane>(&self, point: &Point<L>, e: Sym<L>, h: [L; 2]) -> (Sym<L>, [L; 2]) {
        let (stress, [kappa]) = self.0.update(point, e, [h[0]]);
        (stress, [kappa, h[1]])
    }
}

/// A law that leaves out of its book what it takes fails both checks of the balance; one that keeps no book is told that they
/// do not apply.
#[test]
fn energy_that_no_line_has_fails_the_balance_and_that_of_its_body() {
    let checks = |law: Law| {
        let mut problem = block([5, 4, 6]);
        problem.bodies[1].material = (law.build)(&metal()).unwrap();
        let summary = told(problem);
        let line =
            |id: &str| summary.soundness.checks.iter().find(|line| line.id.starts_with(id)).unwrap().clone();
        [line("energy_error"), line("body_energy_error")]
    };
    let [whole, slab] = checks(Law::of::<Silent>());
    assert!(!whole.pass && whole.value > 10.0 * whole.limit, "{whole:?}");
    assert!(slab.id == "body_energy_error_slab" && !slab.pass, "{slab:?}");
    for line in checks(Law::of::<Metal>()) {
        assert!(line.not_applicable, "{line:?}");
    }
}

/// E = 1 GPa, ν = 0.25.
fn metal() -> Values {
    Values::default().with("K", 2e9 / 3.0).with("G", 4e8).with("limit", 2e4)
}

/// The shaken block, its slab of metal, and what the summary says of it.
fn told(problem: Problem) -> Summary {
    let folder = tempfile::tempdir().unwrap();
    let location = Locator::new(&problem.mesh, None).locate([6.0, 5.0, 7.0], 1e-6).unwrap();
    let plan = Plan {
        page: tremolite_results::PageWish::default(),
        boundaries: Default::default(),
        target: None,
        title: "metal".into(),
        stages: Vec::new(),
        duration: 0.3,
        recorded: None,
        waves: None,
        histories: 0.002,
        snapshots: None,
        fields: Vec::new(),
        field_elements: 250_000,
        checkpoint: None,
        monitors: vec![Monitor { name: "slab".into(), point: [6.0, 5.0, 7.0], location }],
        pairs: Vec::new(),
        bolts: Vec::new(),
        bars: 0,
        water: false,
        relatives: Vec::new(),
        sections: Vec::new(),
    };
    let motion = problem.incident.clone().unwrap().motion;
    let Ready { model, assembly, phase } = Ready::new(problem);
    let results = ResultFolder::create(Some(folder.path()), "metal", true).unwrap();
    let mut control = Control { stop: &AtomicBool::new(false), progress: &mut |_| {} };
    let outcome =
        Simulation::new(&Built::of(&model, &assembly, &phase), &plan, &results, Start::Rest, Vec::new())
            .and_then(|simulation| run(simulation, &mut control))
            .unwrap();
    let facts = MotionFacts {
        kind: MotionKind::Outcrop,
        factor: Some(0.5),
        site: None,
        waves: Vec::new(),
        condition: None,
        lead: 0.0,
        series: 0,
        incident: [Peaks::default(); 3],
        design_displacement: None,
        intensity: [0, 1, 2].map(|i| Intensity::of_samples(&motion.acceleration[i], motion.dt)),
        source: "a pulse".into(),
        window: [0.0, 0.3],
        highest_frequency: 25.0,
        lowpass: None,
        warnings: Vec::new(),
    };
    summary(Evidence {
        model: &model,
        assembly: &assembly,
        phase: &phase,
        plan: &plan,
        motion: Some(&facts),
        survey: &survey(&model, &assembly, 25.0).unwrap(),
        near: Vec::new(),
        outcome: &outcome,
        histories: &Table::read(&results.monitors()).unwrap(),
        energy: &Table::read(&results.energy()).unwrap(),
        materials: IndexMap::new(),
        inputs: Vec::new(),
        bare_si: false,
        before: Vec::new(),
        run: RunFacts::default(),
        defaulted: Vec::new(),
        wall_seconds: 0.0,
    })
}

#[test]
fn what_a_column_means_gives_its_onset_and_its_verdict_whatever_its_name() {
    let mut problem = block([5, 4, 6]);
    problem.bodies[1].material = (Law::of::<Metal>().build)(&metal()).unwrap();
    let summary = told(problem);
    let slab = &summary.parts.damage["slab"].measures["kappa"];
    assert!(slab.largest > 1e-6 && slab.first.unwrap().time > 0.0, "{slab:?}");
    let [finding] = &summary.conclusion.findings[..] else { panic!("{:?}", summary.conclusion.findings) };
    assert!(finding.headline.starts_with("yielded in shear in "), "{finding:?}");
    assert!(finding.text.contains("First yielded in shear at "), "{finding:?}");
    let warned =
        summary.soundness.checks.iter().find(|line| line.name == "yielding rock without initial stress");
    assert!(
        warned.is_some_and(|line| line.not_applicable),
        "its strength does not grow with pressure: {warned:?}"
    );
}

#[test]
fn rock_whose_strength_grows_with_pressure_is_told_that_the_pressure_is_missing() {
    let values = Values::default()
        .with("young", 1e9)
        .with("poisson", 0.25)
        .with("cohesion", 5e4)
        .with("friction_angle", 0.7)
        .with("dilation_angle", 0.0)
        .with("tensile_strength", 2e4);
    let rock = tremolite::laws().into_iter().find(|law| law.info.name == "mohr-coulomb").unwrap();
    let mut problem = block([5, 4, 6]);
    problem.bodies[1].material = (rock.build)(&values).unwrap();
    let summary = told(problem);
    let warned =
        summary.soundness.checks.iter().find(|line| line.name == "yielding rock without initial stress");
    assert!(warned.is_some_and(|line| !line.pass && line.note.starts_with("slab: ")), "{warned:?}");
}

/// With K and G for keys the law gets relaxed moduli beside Maxwell bodies as with `young`; it went without, 23 % too
/// stiff. Before the shaking the bodies are away, and the relaxed law alone is left.
#[test]
fn damping_over_a_band_relaxes_a_law_whatever_its_moduli_are_called() {
    let band = Band::fit(0.05, [0.5, 20.0], 3.0).unwrap();
    let material = (Law::of::<Metal>().build_banded)(&metal().with("limit", 1e9), band).unwrap();
    assert!((material.moduli().young() / 1e9 - 1.0).abs() < 1e-12);
    assert!((material.stiffest().young() / (1e9 * band.unrelaxed()) - 1.0).abs() < 1e-12);

    let mut problem = block([5, 4, 6]);
    problem.incident = None;
    problem.bodies.iter_mut().for_each(|body| body.material = material.clone());
    let ready = Ready::new(problem);
    assert!(!ready.phase.keeps_books, "what this law takes it does not book");
    let before = Phase::of(&ready.model, &ready.assembly, Stage::Before(0)).unwrap();
    let mut state = ready.assembly.rest();
    state.dt = 1e-5;
    let model = &ready.model;
    let pulled = |n: &u32| Row::new([0.0, 0.0, 1e-4 * model.mesh.nodes[*n as usize][2]]);
    state.u = model.mesh_node.iter().map(pulled).collect();
    let snapshot = Engine::new(model, &ready.assembly, &before).look(&state).snapshot;
    // K + 4/3 G, confined along x and y.
    let expected = 1e-4 * band.relaxed() * (2e9 / 3.0 + 4.0 / 3.0 * 4e8);
    for slot in before.element_slot.iter().flatten() {
        let found = snapshot.stress[slot.point as usize][2];
        assert!((found / expected - 1.0).abs() < 1e-9, "{found:e} instead of {expected:e} Pa");
    }
}
