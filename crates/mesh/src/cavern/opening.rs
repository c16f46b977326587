//! One cavern in its rectangle: the opening with its benches, lining and shotcrete, the rings of rock.

use super::Cavern;
use super::closed;
use super::plot::Plot;
use super::profile::{Outline, Profile, Roof};
use super::rings::rings;
use super::section::{Part, Section};
use super::shell;
use super::smooth::smooth;
use super::tube::Across;

/// Fills the rectangle whose edge nodes are `rim`, clockwise from the lower left corner, with cavern `k`;
/// returns the smallest scaled Jacobian in
/// it, and that in lining and shotcrete.
pub(super) fn fill(section: &mut Section, plot: &Plot, cavern: &Cavern, k: u32, rim: &[u32]) -> [f64; 2] {
    let profile = match &plot.outline {
        Outline::Walls(profile) => profile,
        Outline::Closed(tube) => return closed::fill(section, plot, tube, cavern, k, rim),
    };
    let counts = plot.counts;
    let (first_quad, first_point) = (section.quads.len(), section.points.len());
    let path = Path { plot, profile };

    // From the opening outwards: the vault's layers, each from the left foot over the crown to the right one.
    let vault: Vec<Vec<u32>> = (0..=counts.layers)
        .map(|layer| {
            let place = |t: usize| path.place(shell::place(&counts, layer, path.across(t)));
            (0..=counts.vault()).map(|t| section.point(place(t))).collect()
        })
        .collect();
    for (layer, pair) in vault.windows(2).enumerate() {
        for t in 0..counts.vault() {
            let bench = path.bench(t);
            let lining = if path.is_arch(t) { Part::Crown(k, bench) } else { Part::Walls(k, bench) };
            let part = shell::part(&counts, layer, lining);
            section.quad([pair[1][t], pair[0][t], pair[0][t + 1], pair[1][t + 1]], part);
        }
    }

    let mut free = Vec::new();
    let floor = core(section, &path, &vault[0], k, &mut free);

    // Below: feet of the lining and clear floor, left to right, then the slab.
    let mut below: Vec<u32> = vault.iter().rev().map(|layer| layer[0]).collect();
    below.extend(&floor[1..floor.len() - 1]);
    below.extend(vault.iter().map(|layer| layer[counts.vault()]));
    let mut sides: [Vec<u32>; 2] = Default::default();
    let sprayed = counts.shotcrete;
    let slab = |column: usize, columns: usize| match cavern.lining.floor > 0.0 {
        true if column < sprayed || column + sprayed >= columns => Part::Shotcrete(k, path.bench(0)),
        true => Part::Floor(k, path.bench(0)),
        false => Part::Rock,
    };
    for row in 1..=counts.slab {
        let depth = profile.floor * row as f64 / counts.slab as f64;
        let next: Vec<u32> = below
            .iter()
            .map(|&n| {
                let x = section.points[n as usize][0];
                section.point([x, plot.centre[1] - depth])
            })
            .collect();
        for i in 0..next.len() - 1 {
            section.quad([next[i], next[i + 1], below[i + 1], below[i]], slab(i, next.len() - 1));
        }
        sides[0].push(below[0]);
        sides[1].push(below[below.len() - 1]);
        below = next;
    }

    // The outside of lining and shotcrete as a closed path, clockwise, from the point tied to the lower left corner.
    let outside = &vault[counts.layers];
    let inset = counts.inset;
    let right = below.len() - 1;
    let mut outline: Vec<u32> = below[..=inset].iter().rev().copied().collect();
    outline.extend(sides[0].iter().rev());
    outline.extend(&outside[1..counts.vault()]);
    outline.extend(&sides[1]);
    outline.extend(below[inset + 1..=right].iter().rev());
    debug_assert_eq!(outline.len(), rim.len());
    rings(section, plot, &outline, rim, &mut free);

    smooth(&mut section.points, &section.quads[first_quad..], first_point, &free);
    section.worst(first_quad)
}

/// Points of the profile by their number `t` along the vault. Local coordinates.
struct Path<'a> {
    plot: &'a Plot,
    profile: &'a Profile,
}

impl Path<'_> {
    fn place(&self, p: [f64; 2]) -> [f64; 2] {
        [self.plot.centre[0] + p[0], self.plot.centre[1] + p[1]]
    }

    /// Whether edge `t` lies on the arch.
    fn is_arch(&self, t: usize) -> bool {
        let counts = self.plot.counts;
        (counts.wall..counts.vault() - counts.wall).contains(&t)
    }

    /// The bench beside edge `t`; the arch is beside the first.
    fn bench(&self, t: usize) -> u32 {
        self.row_bench(t.min(self.plot.counts.vault() - 1 - t))
    }

    /// The bench of a row of the opening; above the wall's rows it is the first.
    fn row_bench(&self, row: usize) -> u32 {
        self.plot.wall.bench_of.get(row).copied().unwrap_or(1)
    }

    /// Fraction of the arch at node `t`, −1 to 1, or the number of the wall's node and the side.
    fn locate(&self, t: usize) -> Result<f64, (usize, f64)> {
        let counts = self.plot.counts;
        let edges = 2 * counts.flank + counts.columns;
        if t < counts.wall {
            Err((t, -1.0))
        } else if t <= counts.wall + edges {
            Ok(2.0 * (t - counts.wall) as f64 / edges as f64 - 1.0)
        } else {
            Err((counts.vault() - t, 1.0))
        }
    }

    fn across(&self, t: usize) -> Across {
        let located = self.locate(t);
        let on = |roof: &Roof| match located {
            Ok(s) => roof.point(s),
            Err((row, side)) => [side * roof.half, self.plot.wall.levels[row]],
        };
        [on(&self.profile.inner), on(&self.profile.lined), on(&self.profile.outer)]
    }

    /// The edge of the core where a ring lies between it and the intrados: the intrados shrunk sideways by
    /// one column, and its arch as much in height.
    fn shrunk(&self, t: usize) -> [f64; 2] {
        let arc = &self.profile.inner;
        let share = 1.0 - 2.0 / self.plot.counts.floor() as f64;
        let [p, ..] = self.across(t);
        let lift = (p[1] - arc.springing).max(0.0);
        [share * p[0], p[1] - (1.0 - share) * lift]
    }
}

/// Fills the opening; returns the nodes of the clear floor from left to right.
fn core(section: &mut Section, path: &Path, intrados: &[u32], k: u32, free: &mut Vec<u32>) -> Vec<u32> {
    let counts = path.plot.counts;
    let (columns, rows, vault) = (counts.columns, counts.wall + counts.flank, counts.vault());
    let bench = |row: usize| Part::Bench(k, path.row_bench(row));
    // The first row of bench 1: up to here all rows are level.
    let level = path.plot.wall.bench_of.iter().position(|&b| b == 1).unwrap_or(0);

    let edge: Vec<u32> = if counts.ring == 0 {
        intrados.to_vec()
    } else {
        let edge: Vec<u32> = (0..=vault)
            .map(|t| {
                let node = section.point(path.place(path.shrunk(t)));
                if t > level && vault - t > level {
                    free.push(node);
                }
                node
            })
            .collect();
        for t in 0..vault {
            let row = t.min(vault - 1 - t);
            section.quad([intrados[t], edge[t], edge[t + 1], intrados[t + 1]], bench(row));
        }
        edge
    };

    // The core as a grid: left and right column and top row from its edge, the rest in between.
    let mut grid = vec![vec![0u32; columns + 1]; rows + 1];
    for j in 0..=rows {
        grid[j][0] = edge[j];
        grid[j][columns] = edge[vault - j];
    }
    grid[rows].copy_from_slice(&edge[rows..=rows + columns]);
    let share = |i: usize| i as f64 / columns as f64;
    let blend = |a: [f64; 2], b: [f64; 2], s: f64| [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])];
    for j in 0..rows {
        for i in 1..columns {
            let at = |j: usize, i: usize| section.points[grid[j][i] as usize];
            let across = blend(at(j, 0), at(j, columns), share(i));
            let p = if j <= level {
                across
            } else {
                // Transfinite interpolation between the level row, the sides and the top.
                let s = (j - level) as f64 / (rows - level) as f64;
                let up = blend(at(level, i), at(rows, i), s);
                let low = blend(at(level, 0), at(level, columns), share(i));
                let high = blend(at(rows, 0), at(rows, columns), share(i));
                let corner = blend(low, high, s);
                [across[0] + up[0] - corner[0], across[1] + up[1] - corner[1]]
            };
            grid[j][i] = section.point(p);
            if j > level {
                free.push(grid[j][i]);
            }
        }
    }
    for j in 0..rows {
        for i in 0..columns {
            let nodes = [grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]];
            section.quad(nodes, bench(j));
        }
    }
    let mut floor = grid.swap_remove(0);
    if counts.ring > 0 {
        floor.insert(0, intrados[0]);
        floor.push(intrados[vault]);
    }
    floor
}
