//! The steady state: conductivity above the free surface and what walls let through, found by turns with the heads.

use crate::element::{conductance, gradients, height, relative_of};
use crate::ground::{Ground, SeepageError};
use crate::matrix::Matrix;
use crate::places::{Node, Place, nodes, outflows};
use crate::regions::{check, corners, number, reached};

/// Shares of the conductivity that are left in dry ground, and after how many iterations the next is tried. With little left, what trickles
/// down beside an opening need not come to rest, and hardly matters.
const LEFT: [f64; 4] = [1e-3, 1e-2, 3e-2, 1e-1];
const ITERATIONS: usize = 50;
/// Step of an element's conductivity towards what goes with the heads; shorter where it swings.
const STEP: [f64; 2] = [0.01, 0.5];
/// Change of heads over their range at which they are at rest.
const AT_REST: f64 = 1e-6;
/// Of the flow that heads bring, what conjugate gradients leave in the end, and at most on the way.
const SOLVED: f64 = 1e-12;
const ON_THE_WAY: f64 = 1e-6;
/// What they leave over the change of heads before.
const OF_CHANGE: f64 = 1e-3;
/// Share of the largest flow, or of the range of heads, below which a wall's node neither closes nor opens.
const LEAST: f64 = 1e-9;

/// Steady flow.
#[derive(Clone, Debug, PartialEq)]
pub struct Flow {
    /// Head h \[m\] of each node; its height where it is no corner of an element, and where no head reaches the ground around it, whose
    /// water has all left.
    pub heads: Vec<f64>,
    /// Specific discharge −k_r k ∇h \[m/s\] of each element, mean over its points.
    pub velocities: Vec<[f64; 3]>,
    /// What comes out of the ground at each place \[m³/s\]; negative where water comes in.
    pub outflows: Vec<f64>,
    /// All that comes in \[m³/s\].
    pub inflow: f64,
    /// What comes in less what comes out, over what comes in; 0 where nothing flows.
    pub mass_error: f64,
    /// Share of the conductivity that is left in dry ground: 10⁻³, or more where the free surface is not found with so little.
    pub left: f64,
    /// Iterations for the free surface, and of conjugate gradients in all of them.
    pub iterations: usize,
    pub linear_iterations: usize,
}

/// Finds the steady flow.
///
/// # Errors
/// If the input cannot be, a region is bounded by no place, or the free surface is not found.
pub fn steady(ground: &Ground, places: &[Place]) -> Result<Flow, SeepageError> {
    check(ground, places)?;
    // Heads go by ratios of permeabilities alone, and products of very small ones are 0 in numbers of the computer.
    let scale = scale(ground.conductivity);
    let conductivity: Vec<f64> = ground.conductivity.iter().map(|k| k * scale).collect();
    let scaled = Ground { conductivity: &conductivity, ..*ground };
    let mut search = Search::new(&scaled, places)?;
    let mut failed = None;
    for left in LEFT {
        match search.find(left)? {
            None => return Ok(search.flow(&scaled, places, left).over(scale)),
            Some(error) => failed = Some(error),
        }
    }
    Err(failed.unwrap_or(SeepageError::Linear(0)))
}

/// The power of two that brings the largest conductivity near to 1: by it no number changes but in its exponent.
fn scale(conductivity: &[f64]) -> f64 {
    let largest = conductivity.iter().copied().fold(0.0, f64::max);
    2.0_f64.powi(-largest.log2().floor().clamp(-1000.0, 1000.0) as i32)
}

impl Flow {
    /// What flows where every conductivity is so many times less.
    fn over(mut self, scale: f64) -> Flow {
        self.velocities.iter_mut().flatten().chain(&mut self.outflows).for_each(|q| *q /= scale);
        self.inflow /= scale;
        self
    }
}

/// A search for the free surface, and what it has found. Nodes and elements are those that heads reach.
struct Search {
    /// Elements of the ground, their corners, their conductivities \[m/s\], heights \[m\] and conductances \[m\].
    wet: Vec<usize>,
    elements: Vec<[u32; 8]>,
    conductivity: Vec<f64>,
    heights: Vec<f64>,
    whole: Vec<[f64; 36]>,
    /// Nodes of the ground, their heights \[m\], and what holds there.
    used: Vec<u32>,
    z: Vec<f64>,
    kinds: Vec<Node>,
    /// The highest head that is held \[m\]. Heads count from it: where all are the same nothing flows, to the last bit.
    datum: f64,
    matrix: Matrix,
    /// k_r of each element.
    share: Vec<f64>,
    /// Heads \[m\], where they are held, and what comes in at each node \[m³/s\].
    x: Vec<f64>,
    held: Vec<bool>,
    flows: Vec<f64>,
    iterations: usize,
    linear: usize,
}

impl Search {
    fn new(ground: &Ground, places: &[Place]) -> Result<Self, SeepageError> {
        let kinds = nodes(places, ground.nodes);
        let wet = reached(ground, &kinds)?;
        let used = corners(ground, &wet);
        let numbers = number(&used, ground.nodes.len());
        let elements: Vec<[u32; 8]> =
            wet.iter().map(|&e| ground.elements[e].map(|n| numbers[n as usize])).collect();
        let kinds: Vec<Node> = used.iter().map(|&n| kinds[n as usize]).collect();
        let highest = |a: f64, kind: &Node| if let Node::Held(head) = kind { a.max(*head) } else { a };
        let shape = |&e: &usize| conductance(&ground.geometry(e)).ok_or(SeepageError::Shape(e));
        Ok(Search {
            conductivity: wet.iter().map(|&e| ground.conductivity[e]).collect(),
            heights: wet.iter().map(|&e| height(&ground.geometry(e))).collect(),
            whole: wet.iter().map(shape).collect::<Result<_, _>>()?,
            z: used.iter().map(|&n| ground.nodes[n as usize][2]).collect(),
            datum: kinds.iter().fold(f64::NEG_INFINITY, highest),
            matrix: Matrix::new(used.len(), &elements),
            share: vec![1.0; wet.len()],
            x: vec![0.0; used.len()],
            held: vec![false; used.len()],
            flows: vec![0.0; used.len()],
            wet,
            elements,
            used,
            kinds,
            iterations: 0,
            linear: 0,
        })
    }

    /// Searches with a share of the conductivity left in dry ground. Says why nothing was found.
    fn find(&mut self, left: f64) -> Result<Option<SeepageError>, SeepageError> {
        self.share.fill(1.0);
        self.x.fill(0.0);
        for ((held, kind), z) in self.held.iter_mut().zip(&self.kinds).zip(&self.z) {
            *held = match kind {
                Node::Free => false,
                Node::Held(_) => true,
                Node::Outlet => *z < self.datum,
            };
        }
        // How far each element's conductivity goes at a time, and how far it wanted to go the last time.
        let mut pace = vec![[STEP[1], 0.0]; self.wet.len()];
        let mut tolerance = ON_THE_WAY;
        let (mut change, mut switches) = (f64::INFINITY, 0);
        for _ in 0..ITERATIONS {
            self.iterations += 1;
            change = self.solve(tolerance)?;
            switches = self.switch();
            let at_rest = switches == 0 && change < AT_REST;
            if at_rest && tolerance == SOLVED {
                return Ok(None);
            }
            if at_rest {
                // The same once more, to the end.
                tolerance = SOLVED;
            } else {
                tolerance = (OF_CHANGE * change).clamp(SOLVED, ON_THE_WAY);
                self.dry(left, &mut pace);
            }
        }
        Ok(Some(SeepageError::Unsettled { iterations: self.iterations, change, switches }))
    }

    /// Heads under what conducts and what is held. Returns by how much they change, over their range.
    fn solve(&mut self, tolerance: f64) -> Result<f64, SeepageError> {
        let before = self.x.clone();
        for (i, kind) in self.kinds.iter().enumerate().filter(|(i, _)| self.held[*i]) {
            let head = if let Node::Held(head) = kind { *head } else { self.z[i] };
            self.x[i] = head - self.datum;
        }
        self.matrix.clear();
        for (e, whole) in self.whole.iter().enumerate() {
            self.matrix.add(e, whole, self.conductivity[e] * self.share[e]);
        }
        self.linear += self.matrix.solve(&self.held, &mut self.x, tolerance).map_err(SeepageError::Linear)?;
        self.matrix.times(&self.x, &mut self.flows);
        let change = self.x.iter().zip(&before).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let range = self.range();
        Ok(if range > 0.0 { change / range } else { 0.0 })
    }

    /// Extent of the heads \[m\].
    fn range(&self) -> f64 {
        let extreme = |pick: fn(f64, f64) -> f64, start: f64| self.x.iter().copied().fold(start, pick);
        extreme(f64::max, f64::NEG_INFINITY) - extreme(f64::min, f64::INFINITY)
    }

    /// Closes what is open and would give water, opens what is closed under pressure. Returns how many nodes changed.
    fn switch(&mut self) -> usize {
        let held = self.flows.iter().zip(&self.held).filter(|(_, held)| **held);
        let most = held.map(|(q, _)| q.abs()).fold(0.0, f64::max);
        let range = self.range();
        let mut switches = 0;
        for (i, _) in self.kinds.iter().enumerate().filter(|(_, kind)| **kind == Node::Outlet) {
            let wrong = match self.held[i] {
                true => self.flows[i] > LEAST * most,
                false => self.x[i] + self.datum - self.z[i] > LEAST * range,
            };
            if wrong {
                self.held[i] = !self.held[i];
                switches += 1;
            }
        }
        switches
    }

    /// Brings conductivities nearer to what goes with the heads.
    fn dry(&mut self, left: f64, pace: &mut [[f64; 2]]) {
        for (e, corners) in self.elements.iter().enumerate() {
            let heads = corners.map(|i| self.x[i as usize]);
            let above = corners.map(|i| self.x[i as usize] + self.datum - self.z[i as usize]);
            if self.share[e] == 1.0 && above.iter().all(|h| *h >= 0.0) {
                continue;
            }
            let goal = relative_of(corners, &heads, &above, self.heights[e], left);
            let wanted = goal - self.share[e];
            let [step, last] = &mut pace[e];
            *step =
                if wanted * *last < 0.0 { (0.6 * *step).max(STEP[0]) } else { (1.1 * *step).min(STEP[1]) };
            *last = wanted;
            self.share[e] += *step * wanted;
            if goal == 1.0 && wanted < 1e-9 {
                self.share[e] = 1.0;
            }
        }
    }

    /// What was found.
    fn flow(&self, ground: &Ground, places: &[Place], left: f64) -> Flow {
        let sums = Sums::of(&self.flows, &self.held);
        let mut out = vec![0.0; ground.nodes.len()];
        let mut heads: Vec<f64> = ground.nodes.iter().map(|x| x[2]).collect();
        for (i, &n) in self.used.iter().enumerate() {
            heads[n as usize] = self.x[i] + self.datum;
            out[n as usize] = if self.held[i] { 0.0 - self.flows[i] } else { 0.0 };
        }
        let mut velocities = vec![[0.0; 3]; ground.elements.len()];
        for (i, (corners, &e)) in self.elements.iter().zip(&self.wet).enumerate() {
            let heads = corners.map(|n| self.x[n as usize]);
            velocities[e] = velocity(self.conductivity[i] * self.share[i], &heads, &ground.geometry(e));
        }
        Flow {
            heads,
            velocities,
            outflows: outflows(places, &out),
            inflow: sums.inflow,
            mass_error: sums.relative,
            left,
            iterations: self.iterations,
            linear_iterations: self.linear,
        }
    }
}

struct Sums {
    inflow: f64,
    relative: f64,
}

impl Sums {
    fn of(flows: &[f64], held: &[bool]) -> Self {
        let own = || flows.iter().zip(held).filter(|(_, held)| **held).map(|(q, _)| *q);
        // Nothing is +0: a sum of no numbers would be −0.
        let inflow: f64 = own().filter(|q| *q > 0.0).fold(0.0, |sum, q| sum + q);
        let net: f64 = own().sum();
        Sums { inflow, relative: if inflow > 0.0 { net.abs() / inflow } else { 0.0 } }
    }
}

/// Mean discharge of an element \[m/s\].
fn velocity(conductivity: f64, heads: &[f64; 8], corners: &[[f64; 3]; 8]) -> [f64; 3] {
    let mut mean = [0.0; 3];
    let Some((gradients, volumes)) = gradients(corners) else { return mean };
    let volume: f64 = volumes.iter().sum();
    for (gradients, own) in gradients.iter().zip(volumes) {
        let factor = -conductivity * own / volume;
        for (gradient, head) in gradients.iter().zip(heads) {
            (0..3).for_each(|i| mean[i] += factor * gradient[i] * (head - heads[0]));
        }
    }
    mean
}
