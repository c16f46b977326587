//! Specimens as tests have them: plates of bricks one element thick, moved at lines of nodes past their largest load.
//!
//! The plate lies in x and z; its faces across y are free. Nodes are moved stage by stage, each a ramp and then rest, while time
//! stands still for the laws. Nothing else holds the plate.

pub mod beams;
pub mod l_panel;
pub mod measured;
pub mod plate;

use crate::VerifyError;
use crate::models::material;
use plate::Plate;
use tremolite::engine::Release;
use tremolite::history::History;
use tremolite::{
    Assembly, Bed, Body, Bolts, Engine, Life, Line, Model, Phase, Prescribed, Problem, Quadrature, Stage,
};

use tremolite_laws::materials::{Concrete, Elastic};
use tremolite_laws::{Material, Role, Value, Values};

/// Nodes of a plate, by where they lie \[m\].
pub type Pick<'p> = &'p dyn Fn([f64; 2]) -> bool;

/// The concrete of a test.
#[derive(Clone, Copy, Debug)]
pub struct Mix {
    /// E \[Pa\], ν, f_t \[Pa\], G_f \[N/m\], f_c \[Pa\]
    pub young: f64,
    pub poisson: f64,
    pub tension: f64,
    pub energy: f64,
    pub compression: f64,
}

/// The words of a law.
pub type Words = [(&'static str, &'static str)];

/// The law for new work, the same driven by stress, and the paper's.
pub const BAND: &Words = &[("evolution", "exponential"), ("split", "compliance"), ("driver", "strain")];
pub const STRESS: &Words = &[("evolution", "exponential"), ("split", "compliance"), ("driver", "stress")];
pub const PLATEAU: &Words = &[("evolution", "residual"), ("split", "effective"), ("driver", "strain")];

impl Mix {
    fn values(&self, words: &Words) -> Values {
        let mut values = Values::default()
            .with("young", self.young)
            .with("poisson", self.poisson)
            .with("tensile_strength", self.tension)
            .with("fracture_energy", self.energy)
            .with("compressive_strength", self.compression)
            // Assumption: N = 4, usual for concrete; none of these specimens fails by pressure.
            .with("friction_angle", 37f64.to_radians());
        for (name, word) in [("rate", "none")].iter().chain(words) {
            values.0.insert((*name).to_owned(), Value::Word((*word).to_owned()));
        }
        values
    }

    /// Work per area \[N/m\] that a crack of the exponential law took which is now this wide \[m\], less what it would give back:
    /// ∫σ dw − ½σw with σ = f_t exp(−w/w_f), w_f = G_f/f_t.
    pub fn taken(&self, width: f64) -> f64 {
        let over = width.max(0.0) * self.tension / self.energy;
        self.energy * (1.0 - (1.0 + 0.5 * over) * (-over).exp())
    }
}

/// Nodes that are moved together, and how.
pub struct Grip<'p> {
    pub nodes: Pick<'p>,
    /// Share of each stage's way along x, y and z; a component without one is free.
    pub share: [Option<f64>; 3],
}

/// A test: a plate, what it is made of, how it is held and moved.
pub struct Specimen<'p> {
    pub plate: &'p Plate,
    pub mix: Mix,
    pub words: &'static Words,
    pub quadrature: Quadrature,
    /// Elements, by their centres, that stay elastic: where rollers press.
    pub sound: Pick<'p>,
    /// The first is the machine's: its force along z is what is read.
    pub grips: Vec<Grip<'p>>,
    /// Bars in it.
    pub bolts: Vec<Bolts>,
    /// Two places on an edge along x whose distance is the opening.
    pub gauge: Option<[[f64; 2]; 2]>,
    /// Cycles over which each stage goes its way.
    pub ramp: u64,
    /// Ways \[m\] of the machine at the end of each stage.
    pub ways: Vec<f64>,
}

/// What is read at rest after a stage.
#[derive(Clone, Copy, Debug, Default)]
pub struct Reading {
    /// Way of the machine \[m\], and its force \[N\].
    pub way: f64,
    pub force: f64,
    /// Opening of the gauge \[m\].
    pub opening: f64,
    /// Work of the machine so far, by trapezes \[J\].
    pub work: f64,
    /// What the plate holds, what its cracks took, and what the relaxation's damping took, so far \[J\].
    pub held: f64,
    pub taken: f64,
    pub damped: f64,
    /// Cycles to rest.
    pub cycles: u64,
}

/// What came of a test.
pub struct Tested {
    pub readings: Vec<Reading>,
    /// D⁺ of each element at the end, the mean of its points.
    pub damage: Vec<f64>,
    /// Displacement \[m\] along x and z of the plate's nodes at y = 0 at the end.
    pub moved: Vec<[f64; 2]>,
}

impl Tested {
    /// The largest force \[N\], by a parabola through the three largest readings in a row.
    pub fn peak(&self) -> f64 {
        let r = &self.readings;
        let top = (0..r.len()).max_by(|&a, &b| r[a].force.total_cmp(&r[b].force)).unwrap_or(0);
        let (Some(a), b, Some(c)) = (top.checked_sub(1).map(|k| r[k]), r[top], r.get(top + 1)) else {
            return r[top].force;
        };
        // b is the largest: the parabola through the three has its top between a and c.
        let (p, q) = ((b.force - a.force) / (b.way - a.way), (c.force - b.force) / (c.way - b.way));
        let bend = (p - q) / (c.way - a.way);
        let slope = (p * (c.way - b.way) + q * (b.way - a.way)) / (c.way - a.way);
        b.force + if bend > 0.0 { 0.25 * slope * slope / bend } else { 0.0 }
    }

    fn at(&self, x: f64, of: impl Fn(&Reading) -> f64, value: impl Fn(&Reading) -> f64) -> f64 {
        let pair = self.readings.windows(2).find(|pair| of(&pair[0]) <= x && x <= of(&pair[1]));
        pair.map_or(f64::NAN, |pair| {
            let share = (x - of(&pair[0])) / (of(&pair[1]) - of(&pair[0]));
            value(&pair[0]) + share * (value(&pair[1]) - value(&pair[0]))
        })
    }

    /// The force \[N\] where the machine first stands there \[m\], and where the gauge first opens so far \[m\].
    pub fn force_at_way(&self, way: f64) -> f64 {
        self.at(way, |r| r.way, |r| r.force)
    }

    pub fn force_at_opening(&self, opening: f64) -> f64 {
        self.at(opening, |r| r.opening, |r| r.force)
    }

    /// The last reading.
    pub fn last(&self) -> Reading {
        self.readings.last().copied().unwrap_or_default()
    }

    /// What the plate holds and its cracks took at the end, over the machine's work: 1 where nothing jumps.
    pub fn booked(&self) -> f64 {
        let end = self.last();
        (end.held + end.taken) / end.work
    }

    /// Cycles of all stages.
    pub fn cycles(&self) -> u64 {
        self.readings.iter().map(|r| r.cycles).sum()
    }
}

impl Specimen<'_> {
    /// Drives it.
    ///
    /// # Errors
    /// If it is no model, or a stage does not come to rest.
    pub fn run(&self) -> Result<Tested, VerifyError> {
        let mesh = self.plate.mesh.clone();
        let (sound, cracking): (Vec<u32>, Vec<u32>) =
            (0..mesh.elements.len() as u32).partition(|&e| (self.sound)(self.plate.centre(e)));
        let elastic = Values::default().with("young", self.mix.young).with("poisson", self.mix.poisson);
        let made_of = [
            ("concrete", Concrete::NAME, self.mix.values(self.words), cracking),
            ("rollers", Elastic::NAME, elastic, sound),
        ];
        let mut bodies = Vec::new();
        for (name, law, values, elements) in made_of {
            if elements.is_empty() {
                continue;
            }
            let (material, name) = (material(law, &values)?, name.into());
            let body = Body {
                name,
                elements,
                material,
                density: 2400.0,
                quadrature: self.quadrature,
                viscosity: 0.0,
            };
            bodies.push(body);
        }
        let mut problem = Problem::new(mesh, bodies);
        problem.bed = Bed::NONE;
        problem.bolts = self.bolts.clone();
        let corners: Vec<_> = self.grips.iter().map(|grip| self.plate.corners(grip.nodes)).collect();
        // The initial equilibrium, in which nothing acts, and then the ways.
        for (k, way) in (0u16..).zip([0.0].iter().chain(&self.ways)) {
            let life = Life { born: Stage::Before(k), gone: Some(Stage::Before(k + 1)) };
            for (grip, corners) in self.grips.iter().zip(&corners) {
                let to = grip.share.map(|share| share.map(|share| share * way));
                problem.prescribed.push(Prescribed {
                    name: "grip".into(),
                    corners: corners.clone(),
                    to,
                    life,
                });
            }
        }
        // At rest where 1e-4 of all contributions are out of balance, far below what any mesh errs.
        let release =
            Release { cycles: self.ramp, tolerance: [1e-4, 2e-2], most: 200_000, ..Release::default() };
        let model = Model::new(problem)?;
        let assembly = Assembly::new(&model)?;
        let gauge = self.gauge.map(|at| at.map(|x| self.plate.between(x)));
        let mut state = assembly.rest();
        let mut tested = Tested { readings: vec![Reading::default()], damage: Vec::new(), moved: Vec::new() };
        for k in 0..=self.ways.len() {
            let phase = Phase::of(&model, &assembly, Stage::Before(k as u16))?;
            let mut engine = Engine::new(&model, &assembly, &phase);
            let rest = engine
                .relax(&mut state, &release)
                .map_err(|rest| VerifyError::Setup(format!("stage {k} does not come to rest: {rest:?}")))?;
            if k == 0 {
                continue;
            }
            let before = tested.last();
            let way = self.ways[k - 1];
            let force = engine.reactions(&state)[k * self.grips.len()][2];
            let balance = engine.look(&state).snapshot.balance;
            let shown = |node: u32| state.shown(model.engine_node[node as usize] as usize).0[0];
            let along = |pairs: &[(u32, f64)]| pairs.iter().map(|&(n, w)| w * shown(n)).sum::<f64>();
            let opened = gauge.as_ref().map_or(0.0, |[a, b]| along(b) - along(a));
            tested.readings.push(Reading {
                way,
                force: force.abs(),
                opening: opened,
                work: before.work + 0.5 * (way - before.way) * (force.abs() + before.force),
                held: balance[Line::Strain] + balance[Line::Hourglass],
                taken: balance[Line::Dissipated] - balance[Line::Created],
                damped: before.damped + rest.damped,
                cycles: rest.cycles,
            });
            if k == self.ways.len() {
                let history = History::new(&assembly, &state.history);
                let damage = (0..model.mesh.elements.len()).map(|e| {
                    let slot = phase.element_slot[e].as_ref()?;
                    let column = history.with_role(slot, Role::TensionDamage)?;
                    Some(history.values(slot, column).sum::<f64>() / f64::from(slot.points))
                });
                tested.damage = damage.map(|d| d.unwrap_or(0.0)).collect();
                let moved = |node: usize| state.shown(model.engine_node[node] as usize).xyz();
                tested.moved = (0..self.plate.points.len()).map(|n| [moved(n)[0], moved(n)[2]]).collect();
            }
        }
        Ok(tested)
    }
}

/// Ways \[m\]: up to each of some ends, in equal steps.
pub fn steps(legs: &[(f64, f64)]) -> Vec<f64> {
    let mut ways: Vec<f64> = Vec::new();
    for &(end, step) in legs {
        let from = ways.last().copied().unwrap_or(0.0);
        let many = ((end - from) / step).round().max(1.0) as u32;
        ways.extend((1..=many).map(|i| from + (end - from) * f64::from(i) / f64::from(many)));
    }
    ways
}
