//! Strength that changes with slip and opening, or with plastic strain, by a table.

use crate::lane::Lane;
use crate::materials::plastic::parameters::slope as slope_of;
use crate::materials::plastic::slip::{self, Fall, Measure};

/// A row of the table: strengths once the measures have come so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    /// Slip \[m\] or plastic shear strain.
    pub shear: f64,
    /// Opening \[m\] or plastic tension strain, where the table has it.
    pub tension: Option<f64>,
    /// c \[Pa\]
    pub cohesion: f64,
    /// φ \[rad\]
    pub friction: f64,
    /// ψ \[rad\]
    pub dilation: f64,
    /// f_t \[Pa\]
    pub tensile: f64,
}

/// Straight lines from row to row, the last row beyond the end.
#[derive(Clone, Debug)]
pub(super) struct Softening {
    pub measure: Measure,
    first: Row,
    steps: Box<[Step]>,
}

/// From one row to the next.
#[derive(Clone, Copy, Debug)]
struct Step {
    /// Measures at its start, and one over how far they go on to its end; 0 where tension has no say.
    shear: [f64; 2],
    tension: [f64; 2],
    /// What strengths gain on the way.
    cohesion: f64,
    friction: f64,
    dilation: f64,
    tensile: f64,
}

impl Step {
    fn between(a: &Row, b: &Row) -> Self {
        let tension = match (a.tension, b.tension) {
            (Some(from), Some(to)) => [from, 1.0 / (to - from)],
            _ => [0.0; 2],
        };
        Step {
            shear: [a.shear, 1.0 / (b.shear - a.shear)],
            tension,
            cohesion: b.cohesion - a.cohesion,
            friction: b.friction - a.friction,
            dilation: b.dilation - a.dilation,
            tensile: b.tensile - a.tensile,
        }
    }
}

/// What is left of the strength.
pub(super) struct Left<L> {
    /// k = (1 + sin φ)/(1 − sin φ)
    pub slope: L,
    /// M = (1 + sin ψ)/(1 − sin ψ)
    pub flow: L,
    /// \[Pa\]
    pub cohesion: L,
    /// \[Pa\]
    pub tensile: L,
}

/// How much of a step is done, from 0 to 1.
#[inline(always)]
fn done<L: Lane>(measure: L, [start, per_length]: [f64; 2]) -> L {
    let share = (measure - L::splat(start)) * L::splat(per_length);
    L::splat(1.0).smaller(share.larger(L::splat(0.0)))
}

/// sin x for x from 0 to π/2, by Taylor's series up to x¹⁹; within 5e-16, five units below 1.
#[inline(always)]
fn sine<L: Lane>(x: L) -> L {
    const C: [f64; 10] = {
        let mut c = [1.0; 10];
        let mut k = 1;
        while k < 10 {
            c[k] = -c[k - 1] / ((2 * k) as f64 * (2 * k + 1) as f64);
            k += 1;
        }
        c
    };
    let square = x * x;
    let mut sum = L::splat(C[9]);
    let mut k = 9;
    while k > 0 {
        k -= 1;
        sum = sum.mul_add(square, L::splat(C[k]));
    }
    sum * x
}

/// (1 + sin x)/(1 − sin x)
#[inline(always)]
fn slope<L: Lane>(angle: L) -> L {
    let (one, sine) = (L::splat(1.0), sine(angle));
    (one + sine) / (one - sine)
}

impl Softening {
    /// From rows whose measures grow from 0.
    pub fn new(measure: Measure, first: Row, others: &[Row]) -> Self {
        let starts = std::iter::once(&first).chain(others);
        let steps = starts.zip(others).map(|(a, b)| Step::between(a, b)).collect();
        Softening { measure, first, steps }
    }

    /// Whether any strength falls.
    pub fn falls(&self) -> bool {
        self.steps.iter().any(|step| step.cohesion < 0.0 || step.friction < 0.0 || step.tensile < 0.0)
    }

    /// See [`slip::size_limit`]: infinite where softening has no length.
    pub fn size_limit(&self, young: f64) -> f64 {
        match self.measure {
            Measure::Strain => f64::INFINITY,
            Measure::Displacement => slip::size_limit(young, self.stages().into_iter()),
        }
    }

    /// What strength loses from row to row.
    pub fn stages(&self) -> Vec<Fall> {
        let uniaxial = |row: &Row| 2.0 * row.cohesion * slope_of(row.friction).sqrt();
        let confined = uniaxial(&self.first);
        let axial = |row: &Row| {
            [0.0, confined].map(|confinement| slope_of(row.friction).mul_add(confinement, uniaxial(row)))
        };
        let mut rows = vec![self.first];
        for step in &*self.steps {
            let mut next = rows[rows.len() - 1];
            next.cohesion += step.cohesion;
            next.friction += step.friction;
            next.dilation += step.dilation;
            next.tensile += step.tensile;
            rows.push(next);
        }
        let fall = |(pair, step): (&[Row], &Step)| {
            let (from, to) = (axial(&pair[0]), axial(&pair[1]));
            Fall {
                slope: slope_of(pair[0].friction),
                shear: (0..2).map(|k| from[k] - to[k]).fold(0.0, f64::max),
                slip: 1.0 / step.shear[1],
                flow: slope_of(pair[0].dilation.max(pair[1].dilation)),
                tension: (step.tension[1] > 0.0)
                    .then(|| [pair[0].tensile - pair[1].tensile, 1.0 / step.tension[1]]),
            }
        };
        rows.windows(2).zip(&*self.steps).map(fall).collect()
    }

    /// Strength after these measures of shear and of tension.
    #[inline(always)]
    pub fn left<L: Lane>(&self, shear: L, tension: L) -> Left<L> {
        let zero = L::splat(0.0);
        let mut cohesion = L::splat(self.first.cohesion);
        let mut friction = L::splat(self.first.friction);
        let mut dilation = L::splat(self.first.dilation);
        let mut tensile = L::splat(self.first.tensile);
        for step in &*self.steps {
            let sheared = done(shear, step.shear);
            let opened = sheared.larger(done(tension, step.tension));
            cohesion = sheared.mul_add(L::splat(step.cohesion), cohesion);
            friction = sheared.mul_add(L::splat(step.friction), friction);
            dilation = sheared.mul_add(L::splat(step.dilation), dilation);
            tensile = opened.mul_add(L::splat(step.tensile), tensile);
        }
        // Sums of differences may end a hair below the 0 that they mean.
        Left {
            slope: slope(friction.larger(zero)),
            flow: slope(dilation.larger(zero)),
            cohesion: cohesion.larger(zero),
            tensile: tensile.larger(zero),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::sine;

    #[test]
    fn sine_of_every_friction_angle() {
        for i in 0..=1570 {
            let x = i as f64 * 1e-3;
            assert!((sine(x) - x.sin()).abs() <= 5e-16, "{x}");
        }
    }
}
