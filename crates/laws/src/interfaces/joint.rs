//! What all joints share: a bond, Coulomb's friction and the books, over any normal law of the total gap.
//!
//! **Checks** (`wang2018` (38), (39), corrected): with p_c = max(p, 0),
//! - where the pair is bonded, g > 0 and −p > f_bond, the bond breaks and the pair is open;
//! - otherwise, where |t| > μp_c + c, it slides: |t| = μp_c along t. A bond that breaks so at g > 0 leaves an open pair.
//!
//! **Where the print is corrected.** (38) asks for ‖Δ_n‖ > 0 and ‖P_n‖ > cA. A norm has no sign, so a closed pair under a pressure above
//! cA would open; here g > 0 and the tension −p count. (39) prints the friction of ‖P_n‖, in tension as well; here it is that of p_c.
//!
//! From a break on c = f_bond = 0. An open pair carries nothing until g ≤ 0 again; then p is the normal law's and t begins
//! anew, with that step's −k_t Δs where k_t goes by the gap.
//!
//! **Books** per area, by the trapezoidal rule of the equations of motion: friction −½(t_old + t)·Δs_p with
//! Δs_p = Δs + (t − t_old)/k_t; where a bond breaks, the step's work less the change of what is stored; where k_t goes by the
//! gap, ½|t_old|²(1/k_t − 1/k_t,old) as created, negative where the spring stiffens. So along the tangents stored energy is
//! work less friction plus created, exactly; along the normal the rule's own error is left.

use super::strength::Strength;
use crate::lane::Lane;
use crate::parameter::Column;

/// Pressure as a function of the gap alone. An instance of f64s, so that one law serves all lanes.
pub trait Normal: Copy {
    /// Pressure \[Pa\] at a gap \[m\], negative in tension.
    fn pressure<L: Lane>(&self, gap: L) -> L;
    /// −dp/dg \[Pa/m\].
    fn stiffness<L: Lane>(&self, gap: L) -> L;
    /// ∫ −p dg from 0 \[J/m²\].
    fn energy<L: Lane>(&self, gap: L) -> L;
    /// The gap at a pressure; infinite for a tension that is never reached.
    fn gap(&self, pressure: f64) -> f64;
}

/// Stiffness along the tangents.
#[derive(Clone, Copy, Debug)]
pub enum Tangential {
    /// This share of the normal stiffness at the present gap.
    Following(f64),
    /// Constant \[Pa/m\].
    Constant(f64),
}

/// A joint over a normal law.
#[derive(Clone, Copy, Debug)]
pub struct Joint<N> {
    pub normal: N,
    pub tangential: Tangential,
    pub strength: Strength,
}

pub const STATE: usize = 0;
pub const SLID: usize = 1;
pub const OPENED: usize = 2;
pub const FRICTION: usize = 3;
pub const CREATED: usize = 4;
const GAP: usize = 5;
const SLIP: usize = 6;
const SHEAR: usize = 8;
const ANCHOR: usize = 10;
/// Columns of a joint's history.
pub const WIDTH: usize = 12;

pub const COLUMNS: &[Column] = &[
    Column::new("state", "1", "0 bonded, 1 stuck (bond broken, closed), 2 sliding, 3 open"),
    Column::new("slid", "1", "1 once it has slid"),
    Column::new("opened", "1", "1 once it has opened"),
    Column::new("friction_work", "J/m2", "taken by friction and by breaking bonds so far"),
    Column::new("created", "J/m2", "given out because the shear stiffness goes by the closure"),
    Column::new("last_gap", "m", "gap of the last step"),
    Column::new("last_slip1", "m", "slip of the last step along the first tangent"),
    Column::new("last_slip2", "m", "and along the second"),
    Column::new("last_t1", "Pa", "shear t on the second side in the last step, along the first tangent"),
    Column::new("last_t2", "Pa", "and along the second"),
    Column::new(
        "anchor1",
        "m",
        "slip at which t is zero, of a constant shear stiffness, along the first tangent",
    ),
    Column::new("anchor2", "m", "and along the second"),
];

impl<N: Normal> Joint<N> {
    /// Tangential stiffness at a gap, with which an open pair closes.
    #[inline(always)]
    fn tangential_stiffness<L: Lane>(&self, gap: L) -> L {
        match self.tangential {
            Tangential::Following(share) => L::splat(share) * self.normal.stiffness(gap),
            Tangential::Constant(stiffness) => L::splat(stiffness),
        }
    }

    /// See [`crate::Interface::stiffness`].
    pub fn stiffness(&self, pressure: f64) -> [f64; 2] {
        let gap = self.normal.gap(pressure);
        [self.normal.stiffness(gap), self.tangential_stiffness(gap)]
    }

    /// See [`crate::Interface::start`].
    pub fn start(&self, pressure: f64, shear: [f64; 2]) -> (f64, [f64; WIDTH]) {
        let mut history = [0.0; WIDTH];
        let gap = self.normal.gap(pressure.max(-self.strength.bond));
        history[GAP] = gap;
        if -pressure > self.strength.bond {
            // A hyperbola has no gap for every tension, and one of many closures for others.
            (history[STATE], history[OPENED]) = (3.0, 1.0);
            return (gap, history);
        }
        for i in 0..2 {
            history[SHEAR + i] = shear[i];
            if let Tangential::Constant(stiffness) = self.tangential {
                history[ANCHOR + i] = shear[i] / stiffness;
            }
        }
        (gap, history)
    }

    /// See [`crate::Interface::update`].
    #[inline(always)]
    pub fn update<L: Lane>(&self, gap: L, slip: [L; 2], old: [L; WIDTH]) -> (L, [L; 2], [L; WIDTH]) {
        let (zero, half, one) = (L::splat(0.0), L::splat(0.5), L::splat(1.0));
        let has_bond = zero.less(L::splat(self.strength.cohesion.max(self.strength.bond)));
        let bonded = L::both(old[STATE].less(half), has_bond);
        let was_open = L::splat(2.5).less(old[STATE]);
        let apart = zero.less(gap);

        let p = self.normal.pressure(gap);
        let closing = gap.smaller(zero);
        // A bonded pair may be apart and go by the law's own branch there; any other is closed or carries nothing.
        let at = L::select(bonded, gap, closing);
        let last = L::select(bonded, old[GAP], old[GAP].smaller(zero));
        let stiffness = self.tangential_stiffness(at);
        let moved = [slip[0] - old[SLIP], slip[1] - old[SLIP + 1]];
        // `t` as it would be without sliding.
        let mut trial = [zero; 2];
        for i in 0..2 {
            trial[i] = match self.tangential {
                Tangential::Following(_) => stiffness.neg_mul_add(moved[i], old[SHEAR + i]),
                Tangential::Constant(_) => {
                    stiffness * (L::select(was_open, slip[i], old[ANCHOR + i]) - slip[i])
                }
            };
        }
        let size = trial[0].mul_add(trial[0], trial[1] * trial[1]).sqrt();

        let torn = L::both(bonded, L::both(apart, L::splat(self.strength.bond).less(-p)));
        let hold = L::splat(self.strength.friction) * p.larger(zero);
        let strength = hold + L::select(bonded, L::splat(self.strength.cohesion), zero);
        let slides = L::both(L::not(torn), strength.less(size));
        let broken = L::either(L::not(bonded), L::either(torn, slides));
        let open = L::both(broken, apart);
        let slid = L::both(slides, L::either(L::not(apart), bonded));

        // Where nothing slides, `size` may be zero.
        let factor = L::select(slides, hold / L::select(slides, size, one), one);
        let pressure = L::select(open, zero, p);
        let shear = [L::select(open, zero, factor * trial[0]), L::select(open, zero, factor * trial[1])];

        let before = [old[SHEAR], old[SHEAR + 1]];
        let old_stiffness = self.tangential_stiffness(last);
        let mut friction = zero;
        for i in 0..2 {
            let plastic = moved[i] + (shear[i] - before[i]) / stiffness;
            friction = (L::splat(-0.5) * (before[i] + shear[i])).mul_add(plastic, friction);
        }
        // Where it holds there is nothing but round-off.
        friction = L::select(L::either(slides, open), friction, zero);
        let square = before[0].mul_add(before[0], before[1] * before[1]);
        let created = match self.tangential {
            Tangential::Following(_) => half * square * (one / stiffness - one / old_stiffness),
            Tangential::Constant(_) => zero,
        };
        // A break books all that it takes, the rule's error along the normal included.
        let parts = L::both(bonded, broken);
        let breaking = if L::any(parts) {
            let last_pressure = self.normal.pressure(last);
            let mut work = -(half * (last_pressure + pressure)) * (gap - old[GAP]);
            for i in 0..2 {
                work = (L::splat(-0.5) * (before[i] + shear[i])).mul_add(moved[i], work);
            }
            let held = self.stored(gap, shear, open) - self.stored(last, before, zero.less(zero));
            work - held
        } else {
            friction
        };

        let mut new = old;
        new[STATE] =
            L::select(open, L::splat(3.0), L::select(slides, L::splat(2.0), L::select(bonded, zero, one)));
        new[SLID] = L::select(slid, one, old[SLID]);
        new[OPENED] = L::select(open, one, old[OPENED]);
        new[FRICTION] = old[FRICTION] + L::select(parts, breaking, friction);
        new[CREATED] = old[CREATED] + L::select(parts, zero, created);
        new[GAP] = gap;
        for i in 0..2 {
            new[SLIP + i] = slip[i];
            new[SHEAR + i] = shear[i];
            if let Tangential::Constant(stiffness) = self.tangential {
                let anchor = slip[i] + shear[i] * L::splat(1.0 / stiffness);
                let moves = L::either(L::either(slides, open), was_open);
                new[ANCHOR + i] = L::select(moves, anchor, old[ANCHOR + i]);
            }
        }
        (pressure, shear, new)
    }

    /// Stored energy at a gap and shear, none where open.
    #[inline(always)]
    fn stored<L: Lane>(&self, gap: L, shear: [L; 2], open: L::Mask) -> L {
        let square = shear[0].mul_add(shear[0], shear[1] * shear[1]);
        let tangential = L::splat(0.5) * square / self.tangential_stiffness(gap);
        L::select(open, L::splat(0.0), self.normal.energy(gap) + tangential)
    }

    /// See [`crate::Interface::stored_energy`].
    #[inline(always)]
    pub fn stored_energy<L: Lane>(&self, gap: L, shear: [L; 2], history: &[L; WIDTH]) -> L {
        self.stored(gap, shear, L::splat(2.5).less(history[STATE]))
    }
}
