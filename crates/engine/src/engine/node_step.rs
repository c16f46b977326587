//! One node's step.

use crate::boundary::matrix::times;
use crate::model::Model;
use crate::phase::{Dashpot, Phase};
use crate::state::State;
use tremolite_laws::Row;

/// Products with K for ξ ≠ 0; empty otherwise.
#[derive(Clone, Debug, Default)]
pub(super) struct Products {
    /// K v⁻ and K v̂ by engine node \[N\].
    pub minus: Vec<Row>,
    pub hat: Vec<Row>,
}

impl Products {
    /// Both at a node.
    #[inline(always)]
    fn at(&self, node: usize) -> (Row, Row) {
        let at = |rows: &[Row]| rows.get(node).copied().unwrap_or(Row::ZERO);
        (at(&self.minus), at(&self.hat))
    }
}

/// Velocities of a node that others follow.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Lead {
    /// ½(v⁻ + v⁺) \[m/s\].
    pub mean: Row,
    /// v̂ \[m/s\].
    pub hat: Row,
}

/// v̂, dv/dt and the forces of the dampings at a node.
#[derive(Default)]
pub(super) struct NodeStep {
    pub velocity: Row,
    pub acceleration: Row,
    /// ½(v⁻ + v⁺)
    pub mean: Row,
    /// Forces \[N\]: Rayleigh's at v̂, those of the base's dashpots and of the sides' at the mean velocity, and what the
    /// dashpots of free-field sides do to the node.
    pub rayleigh: Row,
    pub base: Row,
    pub sides: Row,
    pub free_field: Row,
}

/// What a node's step needs besides its rows.
#[derive(Clone, Copy)]
pub(super) struct Damping {
    pub dt: f64,
    pub mass_proportional: f64,
    pub stiffness_proportional: f64,
}

#[inline(always)]
pub(super) fn node_step(
    damping: &Damping,
    phase: &Phase,
    products: &Products,
    leads: &[Lead],
    dashpot: Option<&Dashpot>,
    node: usize,
    force: Row,
    du: Row,
) -> NodeStep {
    let inverse = phase.inverse_mass[node];
    let mass = phase.mass[node];
    let Damping { dt, mass_proportional: omega, stiffness_proportional: xi } = *damping;
    let mut step = NodeStep::default();
    let minus = du.xyz().map(|d| d / dt);
    let (k_minus, k_hat) = products.at(node);
    // Acceleration without the dashpots, Rayleigh's damping at `v` with the product `k`.
    let free = |v: [f64; 3], k: &Row| {
        [0, 1, 2].map(|i| -force.0[i] * inverse.0[i] - omega * v[i] - xi * inverse.0[i] * k.0[i])
    };
    let follows = dashpot.map_or(&[][..], |dashpot| &dashpot.follows);
    let pull = |of: fn(&Lead) -> Row| {
        let mut pull = [0.0; 3];
        for follow in follows {
            let lead = of(&leads[follow.place as usize]);
            let force = times(&follow.matrix, lead.xyz());
            (0..3).for_each(|i| pull[i] += force[i]);
        }
        pull
    };
    let hat = mean_velocity(dashpot, inverse, dt, minus, free(minus, &k_minus), pull(|lead| lead.hat));
    let pulled = pull(|lead| lead.mean);
    let mean = mean_velocity(dashpot, inverse, dt, minus, free(hat, &k_hat), pulled);
    for i in 0..3 {
        step.velocity.0[i] = hat[i];
        step.mean.0[i] = mean[i];
        step.acceleration.0[i] = 2.0 * (mean[i] - minus[i]) / dt;
        step.rayleigh.0[i] = omega * mass * hat[i] + xi * k_hat.0[i];
    }
    if let Some(dashpot) = dashpot {
        step.base = Row::new(times(&dashpot.base, mean));
        step.sides = Row::new(times(&dashpot.sides, mean));
        step.free_field = Row::new(pulled);
        for follow in &dashpot.follows {
            let resisted = times(&follow.matrix, mean);
            (0..3).for_each(|i| step.free_field.0[i] -= resisted[i]);
        }
    }
    step
}

/// The same, to the bit, of a node without dashpots where ξ = 0: all components side by side.
#[inline(always)]
pub(super) fn free_node_step(damping: &Damping, phase: &Phase, node: usize, force: Row, du: Row) -> NodeStep {
    let (inverse, mass) = (&phase.inverse_mass[node], phase.mass[node]);
    let Damping { dt, mass_proportional: omega, .. } = *damping;
    let mut step = NodeStep::default();
    for i in 0..3 {
        let minus = du.0[i] / dt;
        let pushed = -force.0[i] * inverse.0[i];
        let hat = minus + 0.5 * dt * (pushed - omega * minus);
        let mean = minus + 0.5 * dt * (pushed - omega * hat);
        step.velocity.0[i] = hat;
        step.mean.0[i] = mean;
        step.acceleration.0[i] = 2.0 * (mean - minus) / dt;
        step.rayleigh.0[i] = omega * mass * hat;
    }
    step
}

/// ½(v⁻ + v⁺) of a node whose dashpots act on that very mean, as lumped dashpots can at no cost: with
/// v⁺ = v⁻ + Δt (a − M⁻¹(D ½(v⁻ + v⁺) − g)) it solves (I + ½Δt M⁻¹D)(v̄ − v⁻) = ½Δt (a − M⁻¹(D v⁻ − g)), where g is what
/// leaders pull with.
#[inline(always)]
fn mean_velocity(
    dashpot: Option<&Dashpot>,
    inverse: Row,
    dt: f64,
    minus: [f64; 3],
    a: [f64; 3],
    pull: [f64; 3],
) -> [f64; 3] {
    let Some(dashpot) = dashpot else { return [0, 1, 2].map(|i| minus[i] + 0.5 * dt * a[i]) };
    let d = dashpot.whole;
    let resisted = times(&d, minus);
    let b = [0, 1, 2].map(|i| 0.5 * dt * (a[i] - inverse.0[i] * (resisted[i] - pull[i])));
    let w = [0, 1, 2].map(|i| 0.5 * dt * inverse.0[i]);
    let m = [
        [1.0 + w[0] * d[0], w[0] * d[3], w[0] * d[5]],
        [w[1] * d[3], 1.0 + w[1] * d[1], w[1] * d[4]],
        [w[2] * d[5], w[2] * d[4], 1.0 + w[2] * d[2]],
    ];
    let cross = |p: [f64; 3], q: [f64; 3]| {
        [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
    };
    let c = [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])];
    let determinant = m[0][0] * c[0][0] + m[0][1] * c[0][1] + m[0][2] * c[0][2];
    [0, 1, 2].map(|i| minus[i] + (c[0][i] * b[0] + c[1][i] * b[1] + c[2][i] * b[2]) / determinant)
}

pub(super) fn damping(model: &Model, state: &State) -> Damping {
    Damping {
        dt: state.dt,
        mass_proportional: model.scheme.rayleigh.mass,
        stiffness_proportional: model.scheme.rayleigh.stiffness,
    }
}

/// Dashpots from a node on, in ascending order.
pub(super) struct Dashpots<'a> {
    rest: &'a [(u32, Dashpot)],
}

impl<'a> Dashpots<'a> {
    pub fn from(phase: &'a Phase, node: usize) -> Self {
        let first = phase.dashpots.partition_point(|(n, _)| (*n as usize) < node);
        Dashpots { rest: &phase.dashpots[first..] }
    }

    /// The dashpot of a node; nodes must be asked for in ascending order.
    #[inline(always)]
    pub fn take(&mut self, node: usize) -> Option<&'a Dashpot> {
        match self.rest.first() {
            Some((n, dashpot)) if *n as usize == node => {
                self.rest = &self.rest[1..];
                Some(dashpot)
            }
            _ => None,
        }
    }
}
