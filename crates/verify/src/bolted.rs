//! Bolts of several problems, a bar that is pulled out of its bond, and bolts followed from outside.

use crate::simulation::Simulation;
use tremolite::bolts::Bolt;
use tremolite::{Bar, Bolts, Bond, Stage, State};

/// Young's modulus of steel \[Pa\], and the area of a bar of 25 mm \[m²\].
pub const STEEL: f64 = 200e9;
pub const AREA: f64 = 4.909e-4;

/// Straight bars, head first, that move with the rock, elastic, from the initial equilibrium on.
pub fn bolts(bars: &[[[f64; 3]; 2]], area: f64) -> Bolts {
    let bar = |points: &[[f64; 3]; 2]| Bar { points: points.to_vec(), areas: vec![area] };
    Bolts {
        name: "bolts".into(),
        bars: bars.iter().map(bar).collect(),
        young: STEEL,
        yields: f64::INFINITY,
        breaks: f64::INFINITY,
        bond: None,
        pretension: 0.0,
        free_length: 0.0,
        plates: [false; 2],
        born: Stage::Before(0),
    }
}

/// A bar bonded from x = 0 to its free end at x = L in rock that does not move, pulled at x = 0.
///
/// With β² = k/EA, N = P sinh(β(L − x))/sinh(βL) and a slip of N′ over −k. Where that is beyond S/k the bond slides, along x_s:
/// there N = P − S x, and behind it the elastic solution with the slip S/k where it begins, so
/// P = S x_s + (S/β) tanh(β(L − x_s)).
#[derive(Clone, Copy, Debug)]
pub struct Bonded {
    /// EA \[N\].
    pub bar: f64,
    /// k \[N/m²\] and S \[N/m\].
    pub bond: f64,
    pub strength: f64,
    /// L \[m\].
    pub length: f64,
}

impl Bonded {
    /// What the engine is given, cut into segments \[m\].
    pub fn bond(&self, segment: f64) -> Bond {
        let Bonded { bond: stiffness, strength, .. } = *self;
        Bond { stiffness, strength, friction: 0.0, perimeter: 0.0, segment }
    }

    /// β \[1/m\].
    pub fn beta(&self) -> f64 {
        (self.bond / self.bar).sqrt()
    }

    /// The pull \[N\] under which this length \[m\] slides.
    fn pull(&self, slid: f64) -> f64 {
        self.strength * (slid + (self.beta() * (self.length - slid)).tanh() / self.beta())
    }

    /// The length \[m\] that slides under a pull \[N\]: all of it where nothing can hold.
    pub fn slid(&self, pull: f64) -> f64 {
        if pull <= self.pull(0.0) {
            return 0.0;
        }
        bisect(0.0, self.length, |slid| self.pull(slid) < pull)
    }

    /// N \[N\] at a distance \[m\] from where it is pulled.
    pub fn force(&self, pull: f64, x: f64) -> f64 {
        let slid = self.slid(pull);
        if x < slid {
            return pull - self.strength * x;
        }
        let beta = self.beta();
        (pull - self.strength * slid) * (beta * (self.length - x)).sinh()
            / (beta * (self.length - slid)).sinh()
    }

    /// Largest error \[N\] of forces cut into segments \[m\] where a front falls between points: there the force per length bends by Sβ
    /// at most, which sums of it over a segment miss by h²/8 of that.
    pub fn front_error(&self, segment: f64) -> f64 {
        segment * segment / 8.0 * self.strength * self.beta()
    }

    /// Bar ahead of the rock against the pull \[m\].
    pub fn slip(&self, pull: f64, x: f64) -> f64 {
        let (slid, beta) = (self.slid(pull), self.beta());
        let elastic = |x: f64| {
            let force = pull - self.strength * slid;
            force * (beta * (self.length - x)).cosh()
                / (self.bar * beta * (beta * (self.length - slid)).sinh())
        };
        if x >= slid {
            return elastic(x);
        }
        let stretched = pull * (slid - x) - 0.5 * self.strength * (slid * slid - x * x);
        self.strength / self.bond + stretched / self.bar
    }
}

/// Where a condition that holds at `low` ends, on the way to `high`.
pub fn bisect(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if holds(middle) { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// A bolt followed from outside.
pub struct Watched {
    bolt: Bolt,
    /// Force on the rock \[N\] and slip \[m\] at its points.
    seen: Vec<[f64; 2]>,
    /// ∫F ds and ½F²/k of all points \[J\].
    work: f64,
    stored: f64,
    /// Force \[N\] and plastic strain of its segments, and ∫N dε_p ℓ \[J\].
    segments: Vec<[f64; 2]>,
    plastic: f64,
}

impl Watched {
    pub fn new(bolt: &Bolt) -> Self {
        Watched {
            bolt: bolt.clone(),
            seen: vec![[0.0; 2]; bolt.points.len()],
            work: 0.0,
            stored: 0.0,
            segments: vec![[0.0; 2]; bolt.segments.len()],
            plastic: 0.0,
        }
    }

    /// What friction took \[J\]: work on slips less what bonds store.
    pub fn friction(&self) -> f64 {
        self.work - self.stored
    }

    /// What yield took \[J\].
    pub fn plastic(&self) -> f64 {
        self.plastic
    }

    /// Takes in a step, of the bolt `b` of the only set; the largest force of its segments \[N\].
    pub fn look(&mut self, simulation: &Simulation, state: &State, b: usize) -> f64 {
        let (bolt, model) = (&self.bolt, &simulation.model);
        let seen = simulation.assembly.bolts[0].seen(&state.numbers, b);
        let largest = seen.iter().map(|seen| seen.force.abs()).fold(0.0, f64::max);
        for ((segment, seen), then) in bolt.segments.iter().zip(&seen).zip(&mut self.segments) {
            let now = [seen.force, seen.plastic_strain];
            self.plastic += 0.5 * (now[0] + then[0]) * (now[1] - then[1]) * segment.length;
            *then = now;
        }
        let Some(bond) = model.bolts[0].kind.bond else { return largest };
        let rock = |p: u32| {
            let point = &bolt.points[p as usize];
            let u = |n: u32| state.u[model.engine_node[n as usize] as usize].xyz();
            let t = bolt.segments[0].along;
            point.weights.iter().map(|&(n, w)| w * (0..3).map(|i| t[i] * u(n)[i]).sum::<f64>()).sum::<f64>()
        };
        // By how much the slip grows along each segment.
        let grows: Vec<f64> = bolt
            .segments
            .iter()
            .zip(&seen)
            .map(|(segment, seen)| {
                let [from, to] = segment.points;
                segment.length * (seen.force / (STEEL * segment.area) + seen.plastic_strain)
                    - (rock(to) - rock(from))
            })
            .collect();
        // The larger of both ends' is told: of the first segment it is the second's if it grows on its way from none.
        let told = seen[0].slip;
        let mut slip = if told * grows[0] > 0.0 { told - grows[0] } else { told };
        let (mut before, mut stored) = (0.0, 0.0);
        for i in 0..=seen.len() {
            let after = seen.get(i).map_or(0.0, |seen| seen.force);
            let beside =
                |k: Option<usize>| k.and_then(|k| bolt.segments.get(k)).map_or(0.0, |s| 0.5 * s.length);
            let (force, stiffness) =
                (after - before, bond.stiffness * (beside(i.checked_sub(1)) + beside(Some(i))));
            let [then, was] = self.seen[i];
            self.work += 0.5 * (force + then) * (slip - was);
            stored += 0.5 * force * force / stiffness;
            self.seen[i] = [force, slip];
            slip += grows.get(i).copied().unwrap_or(0.0);
            before = after;
        }
        self.stored = stored;
        largest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BAR: Bonded = Bonded { bar: 1e8, bond: 1e8, strength: 5e4, length: 4.0 };

    /// EA w″ = b by differences, b of the slip and no more than its strength.
    #[test]
    fn a_bar_pulled_out_is_in_balance_with_its_bond_where_it_slides_and_where_not() {
        let e = 1e-4;
        for pull in [4e4, 1.2e5] {
            assert_eq!(BAR.slid(pull) > 0.0, pull > 5e4);
            for k in 1..39 {
                let x = 0.1 * f64::from(k);
                let slope = (BAR.force(pull, x + e) - BAR.force(pull, x - e)) / (2.0 * e);
                let bond = (BAR.bond * BAR.slip(pull, x)).min(BAR.strength);
                assert!((slope + bond).abs() < 1e-4 * BAR.strength, "{x}: {slope} {bond}");
                let strain = (BAR.slip(pull, x + e) - BAR.slip(pull, x - e)) / (2.0 * e);
                assert!((strain + BAR.force(pull, x) / BAR.bar).abs() < 1e-4 * pull / BAR.bar, "{x}");
            }
            assert_eq!(BAR.force(pull, 0.0), pull);
            assert!(BAR.force(pull, BAR.length).abs() < 1e-9 * pull);
        }
    }
}
