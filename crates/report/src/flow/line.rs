//! One line through a flux.

use super::continuous::Continuous;
use super::{FlowLine, dot, size};

/// The longest step over a cell's width, and the shortest, with which a line ends.
const STEP: f64 = 0.3;
const END: f64 = 1e-3;
/// The cosine of the most that a line turns in one step: beyond it the steps are shorter, at a drain until it ends there.
const TURN: f64 = 0.7;
/// Of one way.
const STEPS: usize = 20_000;

/// The line through the middle of a cell, from where the water comes from to where it goes; nothing where none flows.
pub fn through<const D: usize>(field: &Continuous<D>, seed: usize) -> Option<FlowLine<D>> {
    let mut line = traced(field, seed, -1.0);
    line.reverse();
    let downstream = traced(field, seed, 1.0);
    line.extend(downstream.into_iter().skip(1));
    (line.len() > 1).then_some(line)
}

/// From the middle of a cell with the water, or against it.
fn traced<const D: usize>(field: &Continuous<D>, seed: usize, sign: f64) -> FlowLine<D> {
    let way = |at: &[f64; D], cell: usize| {
        let (flow, cell) = field.at(at, Some(cell))?;
        let q = size(&flow);
        (q > 0.0).then(|| (flow.map(|x| sign * x / q), cell))
    };
    let along = |at: &[f64; D], way: &[f64; D], step: f64| -> [f64; D] {
        std::array::from_fn(|i| at[i] + step * way[i])
    };
    let mut at = field.middles[seed];
    let mut line = vec![at];
    let Some((mut heading, mut cell)) = way(&at, seed) else { return line };
    for _ in 0..STEPS {
        let width = field.width(cell);
        let mut step = STEP * width;
        // Runge and Kutta's, of the fourth order.
        let tried = |step: f64| {
            let a = heading;
            let b = way(&along(&at, &a, 0.5 * step), cell)?.0;
            let c = way(&along(&at, &b, 0.5 * step), cell)?.0;
            let d = way(&along(&at, &c, step), cell)?.0;
            let mean: [f64; D] = std::array::from_fn(|i| (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0);
            let next = along(&at, &mean, step);
            let (heading, cell) = way(&next, cell)?;
            [b, c, d, heading].iter().all(|way| dot(way, &a) > TURN).then_some((next, heading, cell))
        };
        let found = loop {
            match tried(step) {
                Some(found) => break Some(found),
                None if step < END * width => break None,
                None => step *= 0.5,
            }
        };
        let Some((next, turned, there)) = found else { break };
        (at, heading, cell) = (next, turned, there);
        line.push(at);
    }
    line
}
