//! The steady state: conductivity above the free surface and what walls let through, found by turns with the heads.

use crate::element::{at_points, conductance, gradients, height, relative};
use crate::matrix::Matrix;
use crate::places::{Holds, Node, Place, nodes, outflows};
use crate::{Ground, SeepageError};

/// Iterations after which the free surface is given up.
pub const MOST_ITERATIONS: usize = 200;
/// Change of heads over their range at which they are at rest.
const AT_REST: f64 = 1e-5;
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
    let kinds = nodes(places, ground.nodes);
    let wet = reached(ground, &kinds)?;
    let used = corners(ground, &wet);
    let numbers = number(&used, ground.nodes.len());
    let count = used.len();
    let elements: Vec<[u32; 8]> =
        wet.iter().map(|&e| ground.elements[e].map(|n| numbers[n as usize])).collect();
    let z: Vec<f64> = used.iter().map(|&n| ground.nodes[n as usize][2]).collect();
    let kinds: Vec<Node> = used.iter().map(|&n| kinds[n as usize]).collect();
    let highest = |a: f64, kind: &Node| if let Node::Held(head) = kind { a.max(*head) } else { a };
    // Heads from the highest one that is held: where all are the same nothing flows, to the last bit.
    let datum = kinds.iter().fold(f64::NEG_INFINITY, highest);
    let mut matrix = Matrix::new(count, &elements);
    let geometry = |i: usize| ground.elements[wet[i]].map(|n| ground.nodes[n as usize]);
    let whole: Vec<[f64; 36]> = (0..wet.len())
        .map(|i| conductance(&geometry(i), &[1.0; 8]).ok_or(SeepageError::Shape(wet[i])))
        .collect::<Result<_, _>>()?;
    let heights: Vec<f64> = (0..wet.len()).map(|i| height(&geometry(i))).collect();
    let conductivity: Vec<f64> = wet.iter().map(|&e| ground.conductivity[e]).collect();
    let mut share = vec![[1.0; 8]; wet.len()];

    let mut held: Vec<bool> = kinds
        .iter()
        .zip(&z)
        .map(|(kind, z)| match kind {
            Node::Free => false,
            Node::Held(_) => true,
            Node::Outlet => *z < datum,
        })
        .collect();
    let given = |i: usize, kind: &Node| match kind {
        Node::Held(head) => head - datum,
        _ => z[i] - datum,
    };
    let mut x = vec![0.0; count];
    let mut linear = 0;
    let mut last = (f64::INFINITY, 0);
    let mut flows = vec![0.0; count];
    let mut tolerance = ON_THE_WAY;
    for iteration in 1..=MOST_ITERATIONS {
        let before = x.clone();
        for (i, kind) in kinds.iter().enumerate().filter(|(i, _)| held[*i]) {
            x[i] = given(i, kind);
        }
        assemble(&mut matrix, &conductivity, &whole, &share, &geometry);
        linear += matrix.solve(&held, &mut x, tolerance).map_err(SeepageError::Linear)?;
        matrix.times(&x, &mut flows);

        let most = flows.iter().zip(&held).filter(|(_, held)| **held).map(|(q, _)| q.abs());
        let most = most.fold(0.0, f64::max);
        let extreme = |pick: fn(f64, f64) -> f64, start: f64| x.iter().copied().fold(start, pick);
        let range = extreme(f64::max, f64::NEG_INFINITY) - extreme(f64::min, f64::INFINITY);
        let change = x.iter().zip(&before).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let change = if range > 0.0 { change / range } else { 0.0 };
        let mut switches = 0;
        for (i, _) in kinds.iter().enumerate().filter(|(_, kind)| **kind == Node::Outlet) {
            let wrong = match held[i] {
                true => flows[i] > LEAST * most,
                false => x[i] + datum - z[i] > LEAST * range,
            };
            if wrong {
                held[i] = !held[i];
                switches += 1;
            }
        }
        last = (change, switches);
        let at_rest = switches == 0 && change < AT_REST;
        if at_rest && tolerance > SOLVED {
            // The same once more, to the end.
            tolerance = SOLVED;
            continue;
        }
        tolerance = (OF_CHANGE * change).clamp(SOLVED, ON_THE_WAY);
        if at_rest {
            let sums = Sums::of(&flows, &held);
            let mut out = vec![0.0; ground.nodes.len()];
            let mut all: Vec<f64> = ground.nodes.iter().map(|x| x[2]).collect();
            for (i, &n) in used.iter().enumerate() {
                all[n as usize] = x[i] + datum;
                out[n as usize] = if held[i] { -flows[i] } else { 0.0 };
            }
            let mut velocities = vec![[0.0; 3]; ground.elements.len()];
            for (i, corners) in elements.iter().enumerate() {
                let heads = corners.map(|n| x[n as usize]);
                velocities[wet[i]] = velocity(conductivity[i], &heads, &share[i], &geometry(i));
            }
            return Ok(Flow {
                heads: all,
                velocities,
                outflows: outflows(places, &out),
                inflow: sums.inflow,
                mass_error: sums.relative,
                iterations: iteration,
                linear_iterations: linear,
            });
        }
        for (e, corners) in elements.iter().enumerate() {
            let heads = corners.map(|i| x[i as usize] + datum - z[i as usize]);
            if heads.iter().all(|h| *h >= 0.0) && share[e] == [1.0; 8] {
                continue;
            }
            let goal = at_points(&heads).map(|head| relative(head, heights[e]));
            for (share, goal) in share[e].iter_mut().zip(goal) {
                *share = 0.5 * (*share + goal);
                if goal == 1.0 && *share > 1.0 - 1e-9 {
                    *share = 1.0;
                }
            }
        }
    }
    Err(SeepageError::Unsettled { iterations: MOST_ITERATIONS, change: last.0, switches: last.1 })
}

struct Sums {
    inflow: f64,
    relative: f64,
}

impl Sums {
    fn of(flows: &[f64], held: &[bool]) -> Self {
        let own = || flows.iter().zip(held).filter(|(_, held)| **held).map(|(q, _)| *q);
        let inflow: f64 = own().filter(|q| *q > 0.0).sum();
        let net: f64 = own().sum();
        Sums { inflow, relative: if inflow > 0.0 { net.abs() / inflow } else { 0.0 } }
    }
}

fn assemble(
    matrix: &mut Matrix,
    conductivity: &[f64],
    whole: &[[f64; 36]],
    share: &[[f64; 8]],
    geometry: &impl Fn(usize) -> [[f64; 3]; 8],
) {
    matrix.clear();
    for (e, &k) in conductivity.iter().enumerate() {
        if share[e] == [1.0; 8] {
            matrix.add(e, &whole[e], k);
        } else if let Some(entries) = conductance(&geometry(e), &share[e]) {
            matrix.add(e, &entries, k);
        }
    }
}

/// Mean discharge of an element \[m/s\].
fn velocity(conductivity: f64, heads: &[f64; 8], share: &[f64; 8], corners: &[[f64; 3]; 8]) -> [f64; 3] {
    let mut mean = [0.0; 3];
    let Some((gradients, volumes)) = gradients(corners) else { return mean };
    let volume: f64 = volumes.iter().sum();
    for q in 0..8 {
        let factor = -conductivity * share[q] * volumes[q] / volume;
        for (gradient, head) in gradients[q].iter().zip(heads) {
            (0..3).for_each(|i| mean[i] += factor * gradient[i] * (head - heads[0]));
        }
    }
    mean
}

/// Refuses what cannot be.
fn check(ground: &Ground, places: &[Place]) -> Result<(), SeepageError> {
    let refuse = |reason: String| Err(SeepageError::Input(reason));
    let count = ground.nodes.len();
    if ground.conductivity.len() != ground.elements.len() {
        return refuse("give a conductivity for each element".into());
    }
    if let Some(k) = ground.conductivity.iter().find(|k| !(k.is_finite() && **k > 0.0)) {
        return refuse(format!("a conductivity is {k} m/s: it must be positive"));
    }
    let named = places.iter().flat_map(|place| place.nodes.iter().map(|(n, _)| *n));
    if let Some(n) = ground.elements.iter().flatten().copied().chain(named).find(|n| *n as usize >= count) {
        return refuse(format!("node {n} is named, and there are {count}"));
    }
    let finite = |place: &Place| match place.holds {
        Holds::Head(head) | Holds::Open(Some(head)) => head.is_finite(),
        Holds::Open(None) => true,
    };
    if let Some(place) = places.iter().find(|place| !finite(place)) {
        return refuse(format!("the head of '{}' is no number", place.name));
    }
    Ok(())
}

/// The elements that heads reach. From others, which are open somewhere, all water has left.
fn reached(ground: &Ground, kinds: &[Node]) -> Result<Vec<usize>, SeepageError> {
    let mut parent: Vec<u32> = (0..ground.nodes.len() as u32).collect();
    for corners in ground.elements {
        let first = root(&mut parent, corners[0]);
        for &n in corners {
            let other = root(&mut parent, n);
            parent[other as usize] = first;
        }
    }
    let (mut has_head, mut is_open) = (vec![false; ground.nodes.len()], vec![false; ground.nodes.len()]);
    for (n, kind) in kinds.iter().enumerate() {
        let root = root(&mut parent, n as u32) as usize;
        match kind {
            Node::Held(_) => has_head[root] = true,
            Node::Outlet => is_open[root] = true,
            Node::Free => {}
        }
    }
    let mut wet = Vec::new();
    for (e, corners) in ground.elements.iter().enumerate() {
        let root = root(&mut parent, corners[0]) as usize;
        if has_head[root] {
            wet.push(e);
        } else if !is_open[root] {
            return Err(SeepageError::Apart(e));
        }
    }
    Ok(wet)
}

/// The node that stands for all that hang together with one.
fn root(parent: &mut [u32], mut n: u32) -> u32 {
    while parent[n as usize] != n {
        parent[n as usize] = parent[parent[n as usize] as usize];
        n = parent[n as usize];
    }
    n
}

/// The nodes of elements, ascending.
fn corners(ground: &Ground, elements: &[usize]) -> Vec<u32> {
    let mut is_used = vec![false; ground.nodes.len()];
    elements.iter().flat_map(|&e| ground.elements[e]).for_each(|n| is_used[n as usize] = true);
    (0..ground.nodes.len() as u32).filter(|&n| is_used[n as usize]).collect()
}

/// The place of each node among those that are used.
fn number(used: &[u32], count: usize) -> Vec<u32> {
    let mut numbers = vec![u32::MAX; count];
    used.iter().enumerate().for_each(|(i, &n)| numbers[n as usize] = i as u32);
    numbers
}
