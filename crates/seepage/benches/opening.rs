//! Seconds for an opening in a cube of 46³ elements of 10 m, to which water flows from the sides: `cargo bench -p tremolite-seepage`.

use std::time::Instant;
use tremolite_seepage::{Ground, Holds, Place, steady};

const COUNT: usize = 46;
const SIZE: f64 = 10.0;

fn main() {
    let across = COUNT + 1;
    let half = 0.5 * SIZE * COUNT as f64;
    let node = |i: usize, j: usize, k: usize| ((k * across + j) * across + i) as u32;
    let at = |n: usize| [n % across, n / across % across, n / (across * across)].map(|i| SIZE * i as f64);
    let nodes: Vec<[f64; 3]> =
        (0..across.pow(3)).map(at).map(|x| [x[0] - half, x[1] - half, x[2] - SIZE * COUNT as f64]).collect();
    // 40 × 160 × 60 m, its floor 260 m below the surface.
    let open = |x: [f64; 3], more: f64| {
        x[0].abs() < 20.0 + more && x[1].abs() < 80.0 + more && (x[2] + 230.0).abs() < 30.0 + more
    };
    let mut elements = Vec::new();
    for k in 0..COUNT {
        for j in 0..COUNT {
            for i in 0..COUNT {
                let ring = |k| [node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)];
                let (below, above) = (ring(k), ring(k + 1));
                let first = nodes[below[0] as usize];
                if !open(first.map(|x| x + 0.5 * SIZE), 0.0) {
                    elements.push(std::array::from_fn(|n| if n < 4 { below[n] } else { above[n - 4] }));
                }
            }
        }
    }
    let mut used = vec![false; nodes.len()];
    elements.iter().flatten().for_each(|&n: &u32| used[n as usize] = true);
    let place = |name: &str, holds, on: &dyn Fn([f64; 3]) -> bool| {
        let own = (0..nodes.len() as u32).filter(|&n| used[n as usize] && on(nodes[n as usize]));
        Place { name: name.into(), holds, nodes: own.map(|n| (n, 1.0)).collect() }
    };
    let sides = place("sides", Holds::Head(-50.0), &|x| x[0].abs() == half || x[1].abs() == half);
    let wall = place("wall", Holds::Open(None), &|x| open(x, 0.5 * SIZE));
    let conductivity = vec![1e-7; elements.len()];
    let ground = Ground { nodes: &nodes, elements: &elements, conductivity: &conductivity };
    let start = Instant::now();
    match steady(&ground, &[sides, wall]) {
        Ok(flow) => println!(
            "{} elements: {:.1} s, {} iterations ({} of conjugate gradients), {:.3} l/s, mass error {:.0e}",
            elements.len(),
            start.elapsed().as_secs_f64(),
            flow.iterations,
            flow.linear_iterations,
            1e3 * flow.outflows[1],
            flow.mass_error,
        ),
        Err(error) => println!("{error}"),
    }
}
