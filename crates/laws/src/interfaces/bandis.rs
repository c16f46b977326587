//! A joint whose closure is Bandis' hyperbola: rock on concrete, faults, joints.
//!
//! **Normal** (`wang2018` (32), (34), corrected; `bandis1983`). The stiffness per area k_n(g) = k_n0/(1 + g/T)² is integrated
//! from g = 0 to p = −k_n0 g/(1 + g/T), with the largest closure T. The print has (32) push the bodies apart further and (34)
//! as an increment's; the sign here restores, and the form is total, so that nothing drifts. Where 1 + g/T falls below φ the
//! curve goes straight on with k_n0/φ², φ the larger of `closure_floor` and 1/(1 + p*/(k_n0 T)) with p* of
//! `pressure_for_step`: no state is stiffer, and the time step counts just that.
//!
//! **Tangential** (33), (35): k_t = k_n/(2(1 + ν)). `following`, the paper's: t ← t − k_t Δs with k_t at the present closure.
//! Slipping out at one closure and back at a lesser one gives out energy; that is booked as created. `constant`:
//! t = −k_t0 (s − s_a) with k_t0 from k_n0 and an anchor s_a that follows when the pair slides.
//!
//! Bond, friction and books: [`super::joint`].
//!
//! **Not modelled.** Dilation, asperities that wear, hysteresis of closure, rates, water.

use super::joint::{self, Joint, Normal, Tangential, WIDTH};
use crate::interface::Interface;
use crate::lane::Lane;
use crate::lane::elementary::ln;
use crate::parameter::{BadParameter, Column, Dimension, Kind, Need, Parameter, Value, Values};

/// Bandis' hyperbola with a straight end.
#[derive(Clone, Copy, Debug)]
pub struct Hyperbola {
    /// k_n0 \[Pa/m\]
    stiffness: f64,
    /// T \[m\]
    closure: f64,
    /// φ
    floor: f64,
}

impl Hyperbola {
    /// Pressure \[Pa\] from which on it is straight.
    fn straight_from(&self) -> f64 {
        self.stiffness * self.closure * (1.0 / self.floor - 1.0)
    }
}

impl Normal for Hyperbola {
    #[inline(always)]
    fn pressure<L: Lane>(&self, gap: L) -> L {
        let Hyperbola { stiffness, closure, floor } = *self;
        let most = L::splat((floor - 1.0) * closure);
        let curved = most.larger(gap);
        let one = L::splat(1.0);
        let p = -(L::splat(stiffness) * curved) / curved.mul_add(L::splat(1.0 / closure), one);
        let beyond = (most - gap).larger(L::splat(0.0));
        L::splat(stiffness / (floor * floor)).mul_add(beyond, p)
    }

    #[inline(always)]
    fn stiffness<L: Lane>(&self, gap: L) -> L {
        let Hyperbola { stiffness, closure, floor } = *self;
        let open = gap.mul_add(L::splat(1.0 / closure), L::splat(1.0)).larger(L::splat(floor));
        L::splat(stiffness) / (open * open)
    }

    #[inline(always)]
    fn energy<L: Lane>(&self, gap: L) -> L {
        let Hyperbola { stiffness, closure, floor } = *self;
        let zero = L::splat(0.0);
        let most = L::splat((floor - 1.0) * closure);
        let x = most.larger(gap) * L::splat(1.0 / closure);
        let beyond = (most - gap).larger(zero);
        let straight =
            L::splat(0.5 * stiffness / (floor * floor)).mul_add(beyond, L::splat(self.straight_from()));
        straight.mul_add(beyond, L::splat(stiffness * closure * closure) * less_logarithm(x))
    }

    fn gap(&self, pressure: f64) -> f64 {
        let Hyperbola { stiffness, closure, floor } = *self;
        let beyond = pressure - self.straight_from();
        if beyond > 0.0 {
            (floor - 1.0) * closure - beyond * floor * floor / stiffness
        } else {
            -pressure / (stiffness + pressure / closure)
        }
    }
}

/// x − ln(1 + x), without the loss of digits near 0.
#[inline(always)]
fn less_logarithm<L: Lane>(x: L) -> L {
    let direct = x - ln(x + L::splat(1.0));
    // ln(1 + x) = 2 artanh y with y = x/(2 + x), and x − 2y = xy; |y| < 0.06 leaves 1e-17 after y¹³.
    let y = x / (x + L::splat(2.0));
    let s = y * y;
    let mut sum = L::splat(2.0 / 13.0);
    let mut k = 5;
    while k > 0 {
        sum = sum.mul_add(s, L::splat(2.0 / (2 * k + 1) as f64));
        k -= 1;
    }
    let series = (y * s).neg_mul_add(sum, x * y);
    L::select(x.abs().less(L::splat(0.1)), series, direct)
}

/// The law for one interface; see the [module](self).
#[derive(Clone, Copy, Debug)]
pub struct Bandis {
    joint: Joint<Hyperbola>,
}

/// Smallest part of the closure at which the curve goes straight, by default: p = 3 k_n0 T there.
const FLOOR: f64 = 0.25;

impl Interface for Bandis {
    const NAME: &'static str = "bandis";
    const SUMMARY: &'static str = "joint with a hyperbolic closure, bond and Coulomb friction; the paper's interface of rock and lining";
    const SOURCE: &'static str = "wang2018 (28)–(39) with corrections; bandis1983";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter {
            name: "normal_stiffness",
            kind: Kind::Number(Dimension::STIFFNESS),
            need: Need::Chosen("as stiff as leaves the time step to the elements"),
            doc: "normal stiffness per area k_n0 of the closed, unloaded joint",
        },
        Parameter {
            name: "max_closure",
            kind: Kind::Number(Dimension::LENGTH),
            need: Need::Required,
            doc: "largest closure T, at which the hyperbola ends",
        },
        Parameter {
            name: "poisson",
            kind: Kind::Number(Dimension::NONE),
            need: Need::Number(0.25),
            doc: "ν of k_t = k_n/(2(1 + ν))",
        },
        COHESION,
        TENSILE_STRENGTH,
        FRICTION,
        Parameter {
            name: "tangential",
            kind: Kind::Word(&["following", "constant"]),
            need: Need::Word("following"),
            doc: "k_t from k_n at the present closure (the paper), or from k_n0",
        },
        Parameter {
            name: "closure_floor",
            kind: Kind::Number(Dimension::NONE),
            need: Need::Number(FLOOR),
            doc: "share 1 + g/T of the closure that is left where the curve goes straight, at p = k_n0 T (1/φ − 1)",
        },
        Parameter {
            name: "pressure_for_step",
            kind: Kind::Number(Dimension::PRESSURE),
            need: Need::Optional("the closure's floor alone makes it straight"),
            doc: "pressure p* from which on the curve goes straight, so that no state is stiffer than the time step counts",
        },
    ];
    const HISTORY: &'static [Column] = joint::COLUMNS;
    const STATE: usize = joint::STATE;
    const SLID: usize = joint::SLID;
    const OPENED: usize = joint::OPENED;
    const DISSIPATION: usize = joint::FRICTION;
    const CREATION: usize = joint::CREATED;
    type History<L: Lane> = [L; WIDTH];

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        let mut bad = Vec::new();
        let mut take = |read: Result<f64, BadParameter>| read.map_err(|e| bad.push(e)).ok();
        let stiffness = take(positive(values, "normal_stiffness", "20 GPa/m is usual for rock and lining"));
        let closure = take(positive(values, "max_closure", "joints close by 0.1 mm to a few mm"));
        let poisson = take(values.number_where(
            "poisson",
            |x| x > -1.0 && x <= 0.5,
            "must lie between -1 and 0.5",
            "0.25 is usual",
        ));
        let strengths = [COHESION.name, FRICTION.name].map(|name| take(not_negative(values, name)));
        let floor = take(values.number_where(
            "closure_floor",
            |x| x > 0.0 && x <= 1.0,
            "must be above 0 and at most 1",
            "0.25 is usual; 1 makes the joint linear",
        ));
        let bond = take(bond(values, strengths[0].unwrap_or(0.0)));
        let limit = match values.optional("pressure_for_step") {
            Some(_) => take(positive(values, "pressure_for_step", "the strength of the lining is usual")),
            None => Some(f64::INFINITY),
        };
        let (Some(stiffness), Some(closure), Some(poisson), Some(floor), Some(bond), Some(limit)) =
            (stiffness, closure, poisson, floor, bond, limit)
        else {
            return Err(bad);
        };
        let [Some(cohesion), Some(friction)] = strengths else { return Err(bad) };
        if bond >= stiffness * closure {
            let name = if values.optional(TENSILE_STRENGTH.name).is_some() {
                "tensile_strength"
            } else {
                "cohesion"
            };
            return Err(vec![BadParameter::new(
                name,
                format!(
                    "gives a bond of {bond:.4e} Pa that the joint can never reach: its tension stays below \
                     normal_stiffness × max_closure, {:.4e} Pa",
                    stiffness * closure
                ),
                "give a smaller tensile_strength, or a larger normal_stiffness or max_closure",
            )]);
        }
        let share = 0.5 / (1.0 + poisson);
        let tangential = match values.word("tangential") {
            Some("constant") => Tangential::Constant(share * stiffness),
            _ => Tangential::Following(share),
        };
        let floor = floor.max(1.0 / (1.0 + limit / (stiffness * closure)));
        let normal = Hyperbola { stiffness, closure, floor };
        Ok(Bandis { joint: Joint { normal, tangential, friction, cohesion, bond } })
    }

    /// With p* the larger root k_n0 of k_n0 (1 + p*/(k_n0 T))² = `stiffness`; that has its least value 4p*/T at p*/T, so where
    /// `stiffness` is below it k_n0 = ¼ `stiffness` and p* = ¼ `stiffness` T. The closure's floor bounds it as well.
    fn chosen(values: &Values, stiffness: f64) -> Values {
        if values.optional("normal_stiffness").is_some() {
            return values.clone();
        }
        let closure = values.optional("max_closure").unwrap_or(f64::NAN);
        let floor = values.optional("closure_floor").unwrap_or(FLOOR);
        let by_floor = stiffness * floor * floor;
        let Some(limit) = values.optional("pressure_for_step") else {
            return values.clone().with("normal_stiffness", by_floor);
        };
        let least = limit / closure;
        if stiffness < 4.0 * least {
            let values = values.clone().with("pressure_for_step", 0.25 * stiffness * closure);
            return values.with("normal_stiffness", by_floor.max(0.25 * stiffness));
        }
        let root = 0.5 * ((stiffness - 2.0 * least) + (stiffness * (stiffness - 4.0 * least)).sqrt());
        values.clone().with("normal_stiffness", by_floor.max(root))
    }

    fn stiffness(&self, pressure: f64) -> [f64; 2] {
        self.joint.stiffness(pressure)
    }

    fn stiffest(&self) -> [f64; 2] {
        let Hyperbola { stiffness, floor, .. } = self.joint.normal;
        let normal = stiffness / (floor * floor);
        match self.joint.tangential {
            Tangential::Following(share) => [normal, share * normal],
            Tangential::Constant(tangential) => [normal, tangential],
        }
    }

    fn straight_from(&self) -> Option<f64> {
        Some(self.joint.normal.straight_from())
    }

    fn closure_limit(&self) -> Option<f64> {
        Some(self.joint.normal.closure)
    }

    fn start(&self, pressure: f64, shear: [f64; 2]) -> (f64, [f64; WIDTH]) {
        self.joint.start(pressure, shear)
    }

    #[inline(always)]
    fn update<L: Lane>(&self, gap: L, slip: [L; 2], history: [L; WIDTH]) -> (L, [L; 2], [L; WIDTH]) {
        self.joint.update(gap, slip, history)
    }

    #[inline(always)]
    fn stored_energy<L: Lane>(&self, gap: L, shear: [L; 2], history: &[L; WIDTH]) -> L {
        self.joint.stored_energy(gap, shear, history)
    }
}

pub(super) const COHESION: Parameter = Parameter {
    name: "cohesion",
    kind: Kind::Number(Dimension::PRESSURE),
    need: Need::Number(0.0),
    doc: "cohesion c of the bond; gone once it breaks",
};
pub(super) const TENSILE_STRENGTH: Parameter = Parameter {
    name: "tensile_strength",
    kind: Kind::Number(Dimension::PRESSURE),
    need: Need::Optional("the cohesion"),
    doc: "tension f_bond at which the bond breaks",
};
pub(super) const FRICTION: Parameter = Parameter {
    name: "friction",
    kind: Kind::Number(Dimension::NONE),
    need: Need::Required,
    doc: "coefficient of friction μ",
};

pub(super) fn positive(values: &Values, name: &'static str, usual: &str) -> Result<f64, BadParameter> {
    values.number_where(name, |x| x > 0.0, "must be positive", usual)
}

pub(super) fn not_negative(values: &Values, name: &'static str) -> Result<f64, BadParameter> {
    values.number_where(name, |x| x >= 0.0, "must not be negative", "give zero or more")
}

/// f_bond \[Pa\]: the tensile strength, by default the cohesion.
pub(super) fn bond(values: &Values, cohesion: f64) -> Result<f64, BadParameter> {
    match values.0.get(TENSILE_STRENGTH.name) {
        Some(Value::Number(_)) => not_negative(values, TENSILE_STRENGTH.name),
        _ => Ok(cohesion),
    }
}
