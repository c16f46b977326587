//! A law from outside the list: what ARCHITECTURE.md, 'How to add a law', says.

mod common;

use std::sync::Arc;
use tremolite::{Engine, Instance, Law, Model, Phase, stable_step};
use tremolite_laws::materials::elastic::{POISSON, YOUNG, read_moduli};
use tremolite_laws::{
    BadParameter, Column, Dimension, Kind, Lane, Material, Moduli, Need, Parameter, Point, Sym, Values,
};

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
    const HISTORY: &'static [Column] =
        &[Column { name: "opened", unit: "1", doc: "1 once the limit was reached" }];
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

    let mut problem = common::block([5, 4, 6]);
    problem.bodies[0].material = (law.build)(&values).unwrap();
    problem.bodies[1].material = Arc::new(Instance(Arc::new(NoTension::new(&values).unwrap())));
    let model = Model::new(problem).unwrap();
    let phase = Phase::dynamic(&model).unwrap();
    let mut state = phase.rest();
    state.dt = 0.9 * stable_step(&model, &phase).dt;
    let mut engine = Engine::new(&model, &phase);
    let mut most = f64::NEG_INFINITY;
    while state.time() < 0.3 {
        let snapshot = engine.observe(&mut state);
        let counted = phase.slices[phase.counted_parts - 1].points.end;
        for s in &snapshot.stress[..counted] {
            most = most.max((s[0] + s[1] + s[2]) / 3.0);
        }
        engine.step(&mut state).unwrap();
    }
    assert!((most - 1e4).abs() < 1.0, "mean tension stops at its limit: {most}");
    assert!(state.history.iter().flat_map(|o| o.0).any(|opened| opened == 1.0));
}
