//! One cavern whose outline is a closed curve in its rectangle: the opening with its benches, lining and shotcrete
//! all round, the rings of rock.

use super::Cavern;
use super::plot::Plot;
use super::rings::rings;
use super::section::{Part, Section};
use super::shell;
use super::smooth::smooth;
use super::tube::{Across, Tube};
use super::wall::Rows;

/// Fills the rectangle whose edge nodes are `rim`, clockwise from the lower left corner, with cavern `k`;
/// returns the smallest scaled Jacobian in it, and that in lining and shotcrete.
pub(super) fn fill(
    section: &mut Section,
    plot: &Plot,
    tube: &Tube,
    cavern: &Cavern,
    k: u32,
    rim: &[u32],
) -> [f64; 2] {
    let counts = plot.counts;
    let (first_quad, first_point) = (section.quads.len(), section.points.len());
    let [low, high] = tube.wall();
    let Rows { levels, bench_of } = Rows::even(counts.wall, high - low, cavern.benches as usize);
    let levels: Vec<f64> = levels.iter().map(|v| low + v).collect();
    let outline = outline(tube, &levels, counts.columns);
    let n = outline.len();
    let place = |p: [f64; 2]| [plot.centre[0] + p[0], plot.centre[1] + p[1]];

    let layers: Vec<Vec<u32>> = (0..=counts.layers)
        .map(|layer| {
            outline.iter().map(|across| section.point(place(shell::place(&counts, layer, *across)))).collect()
        })
        .collect();
    let (wall, columns) = (counts.wall, counts.columns);
    for (layer, pair) in layers.windows(2).enumerate() {
        for t in 0..n {
            let bench = bench_beside(t, columns, &bench_of);
            let lining = match t {
                t if t < wall => Part::Walls(k, bench),
                t if t < wall + columns => Part::Crown(k, bench),
                t if t < 2 * wall + columns => Part::Walls(k, bench),
                _ => Part::Floor(k, bench),
            };
            let part = shell::part(&counts, layer, lining);
            let u = (t + 1) % n;
            section.quad([pair[1][t], pair[0][t], pair[0][u], pair[1][u]], part);
        }
    }

    let mut free = Vec::new();
    core(section, plot, tube, &layers[0], &bench_of, k, &mut free);
    rings(section, plot, &layers[counts.layers], rim, &mut free);
    smooth(&mut section.points, &section.quads[first_quad..], first_point, &free);
    section.worst(first_quad)
}

/// The bench beside edge `t` of the outline, in the order of its points.
fn bench_beside(t: usize, columns: usize, bench_of: &[u32]) -> u32 {
    let rows = bench_of.len();
    match t {
        t if t < rows => bench_of[t],
        t if t < rows + columns => 1,
        t if t < 2 * rows + columns => bench_of[2 * rows + columns - 1 - t],
        _ => bench_of[0],
    }
}

/// Points of the outline clockwise from the lower left corner: left wall, crown, right wall, invert.
fn outline(tube: &Tube, levels: &[f64], columns: usize) -> Vec<Across> {
    let mirrored = |across: Across| across.map(|p| [-p[0], p[1]]);
    let wall = levels.len() - 1;
    let share = |i: usize| 2.0 * i as f64 / columns as f64 - 1.0;
    let left = (0..wall).map(|j| mirrored(tube.wall_point(levels[j])));
    let crown = (0..columns).map(|i| tube.crown_point(share(i)));
    let right = (1..=wall).rev().map(|j| tube.wall_point(levels[j]));
    let invert = (1..=columns).rev().map(|i| tube.invert_point(share(i)));
    left.chain(crown).chain(right).chain(invert).collect()
}

/// Fills the opening: a ring of quadrilaterals along the intrados and a grid inside it. Nodes on the cuts
/// between benches keep their level.
fn core(
    section: &mut Section,
    plot: &Plot,
    tube: &Tube,
    intrados: &[u32],
    bench_of: &[u32],
    k: u32,
    free: &mut Vec<u32>,
) {
    let (columns, rows, n) = (plot.counts.columns, plot.counts.wall, intrados.len());
    let centre = [plot.centre[0], plot.centre[1] + 0.5 * tube.height];
    // The ring is as wide as a column of the grid inside it.
    let share = columns as f64 / (columns + 2) as f64;
    let cut = |j: usize| j > 0 && j < rows && bench_of[j] != bench_of[j - 1];
    let row_of = |t: usize| {
        if t <= rows {
            t
        } else if t >= rows + columns && t <= 2 * rows + columns {
            2 * rows + columns - t
        } else {
            0
        }
    };
    let edge: Vec<u32> = (0..n)
        .map(|t| {
            let p = section.points[intrados[t] as usize];
            let pinned = cut(row_of(t));
            let v = if pinned { p[1] } else { centre[1] + share * (p[1] - centre[1]) };
            let node = section.point([centre[0] + share * (p[0] - centre[0]), v]);
            if !pinned {
                free.push(node);
            }
            node
        })
        .collect();
    for t in 0..n {
        let bench = bench_beside(t, columns, bench_of);
        let u = (t + 1) % n;
        section.quad([intrados[t], edge[t], edge[u], intrados[u]], Part::Bench(k, bench));
    }

    let mut grid = vec![vec![0u32; columns + 1]; rows + 1];
    for (j, row) in grid.iter_mut().enumerate() {
        row[0] = edge[j];
        row[columns] = edge[2 * rows + columns - j];
    }
    for i in 1..columns {
        grid[rows][i] = edge[rows + i];
        grid[0][i] = edge[(2 * (rows + columns) - i) % n];
    }
    for j in 1..rows {
        for i in 1..columns {
            let at = |j: usize, i: usize| section.points[grid[j][i] as usize];
            let (s, t) = (i as f64 / columns as f64, j as f64 / rows as f64);
            let p = [0, 1].map(|c| {
                let across = (1.0 - s) * at(j, 0)[c] + s * at(j, columns)[c];
                if cut(j) {
                    return across;
                }
                let up = (1.0 - t) * at(0, i)[c] + t * at(rows, i)[c];
                let low = (1.0 - s) * at(0, 0)[c] + s * at(0, columns)[c];
                let high = (1.0 - s) * at(rows, 0)[c] + s * at(rows, columns)[c];
                across + up - (1.0 - t) * low - t * high
            });
            grid[j][i] = section.point(p);
            if !cut(j) {
                free.push(grid[j][i]);
            }
        }
    }
    for j in 0..rows {
        for i in 0..columns {
            let nodes = [grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]];
            section.quad(nodes, Part::Bench(k, bench_of[j]));
        }
    }
}
