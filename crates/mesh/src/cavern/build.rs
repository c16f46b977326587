//! The section of a block: its grid laid out, its caverns filled in, and where their rings of rock are best tied to the
//! grid found by trial.

use std::collections::HashMap;

use super::error::LEAST_JACOBIAN;
use super::layout::Layout;
use super::opening;
use super::section::{Part, Section};
use super::{Cavern, CavernError, CavernSpec, GroundSurface};
use crate::note::Note;

/// Good enough not to look for better.
const GOOD_JACOBIAN: f64 = 0.45;

/// The section of a description that the checks have passed.
///
/// # Errors
/// If lines cannot be laid out, or elements round a cavern come out worse than [`LEAST_JACOBIAN`].
pub(super) fn build(spec: &CavernSpec) -> Result<Section, CavernError> {
    let mut insets = vec![None; spec.caverns.len()];
    lead_rows(spec, &mut insets)?;
    let (mut section, mut worst) = assemble(spec, &insets)?;
    // Where the rings round a cavern are best tied to its rectangle's lower corners is found by trial.
    for (k, cavern) in spec.caverns.iter().enumerate() {
        if worst[k][0] >= GOOD_JACOBIAN || cavern.shape.is_closed() {
            continue;
        }
        for inset in 0..=layers(cavern) + 2 {
            let kept = insets[k].replace(inset);
            // A trial may ask for more elements than a block can have; the usual inset did not.
            match assemble(spec, &insets) {
                Ok(trial) if trial.1[k][0] > worst[k][0] => (section, worst) = trial,
                _ => insets[k] = kept,
            }
        }
    }
    for (cavern, worst) in spec.caverns.iter().zip(&worst) {
        for (&scaled_jacobian, limit) in worst.iter().zip(LEAST_JACOBIAN) {
            if scaled_jacobian < limit {
                let (cavern, near) = (cavern.name.clone(), spec.near);
                return Err(CavernError::Poor { cavern, near, scaled_jacobian, limit });
            }
        }
    }
    Ok(section)
}

/// Layers of lining and shotcrete that a cavern may have.
fn layers(cavern: &Cavern) -> usize {
    (cavern.lining.layers + cavern.shotcrete.layers) as usize
}

/// Where the layout departs from what was asked for.
fn notes(spec: &CavernSpec, layout: &Layout) -> Vec<Note> {
    let moved = spec.caverns.iter().zip(&layout.plots).flat_map(|(cavern, plot)| {
        let cuts = plot.stops.iter().flat_map(|stops| &stops.moved);
        cuts.map(|cut| Note::MovedCut {
            cavern: cavern.name.clone(),
            bench: cut.bench,
            from: cut.from,
            to: cut.to,
        })
    });
    // Under ground that is not level no plane above the caverns' surroundings stays level either.
    let (base, top) = (layout.z[0], if spec.ground == GroundSurface::Level { 0.0 } else { f64::INFINITY });
    let cover = layout.plots.iter().map(|plot| layout.rectangle(plot)[1][1]).fold(base, f64::max);
    let stepped = spec.layers.iter().skip(1).filter(|layer| {
        let plane = -layer.depth;
        let cut = layout.z.contains(&plane) && (spec.ground == GroundSurface::Level || plane <= cover);
        layer.dip == 0.0 && plane > base && plane < top && !cut
    });
    let stepped = stepped.map(|layer| Note::Stepped { layer: layer.name.clone() });
    moved.chain(stepped).collect()
}

/// Finds insets with which rows lead through the galleries: rows from the base of the caverns' rectangles to the
/// gallery must be as many on either side, and each edge more below a cavern is a row more there.
fn lead_rows(spec: &CavernSpec, insets: &mut [Option<usize>]) -> Result<(), CavernError> {
    for _ in &spec.galleries {
        let Err(CavernError::GalleryRows { gallery, near }) = Layout::new(spec, insets) else {
            return Ok(());
        };
        let between = spec.galleries.iter().find(|g| g.name == gallery).map(|g| &g.between);
        let pair: Vec<usize> = spec
            .caverns
            .iter()
            .enumerate()
            .filter(|(_, cavern)| between.is_some_and(|b| b.contains(&cavern.name)))
            .map(|(k, _)| k)
            .collect();
        let [a, b] = pair[..] else { return Ok(()) };
        let most = |k: usize| layers(&spec.caverns[k]) + 3;
        let leads = |insets: &[Option<usize>]| match Layout::new(spec, insets) {
            Err(CavernError::GalleryRows { gallery: still, .. }) => still != gallery,
            _ => true,
        };
        let mut pairs = (0..=most(a)).flat_map(|i| (0..=most(b)).map(move |j| [i, j]));
        let found = pairs.any(|[i, j]| {
            (insets[a], insets[b]) = (Some(i), Some(j));
            leads(insets)
        });
        if !found {
            return Err(CavernError::GalleryRows { gallery, near });
        }
    }
    Ok(())
}

/// The section, and for each cavern the smallest scaled Jacobian in its rectangle and in its lining and shotcrete.
fn assemble(spec: &CavernSpec, insets: &[Option<usize>]) -> Result<(Section, Vec<[f64; 2]>), CavernError> {
    let layout = Layout::new(spec, insets)?;
    let ends = |line: &[f64]| [line[0], line[line.len() - 1]];
    let mut section = Section {
        y: layout.y.clone(),
        surroundings: layout.plots.iter().map(|plot| layout.rectangle(plot)).collect(),
        passages: layout.passages.clone(),
        block: [ends(&layout.x), ends(&layout.z)],
        notes: notes(spec, &layout),
        ..Section::default()
    };
    let mut taken = vec![false; (layout.x.len() - 1) * (layout.z.len() - 1)];
    for plot in &layout.plots {
        for j in plot.rows.clone() {
            let row = j * (layout.x.len() - 1);
            taken[row + plot.columns.start..row + plot.columns.end].fill(true);
        }
    }
    // Points are made where a cell first needs them: none lies within a cavern's rectangle.
    let mut at: HashMap<(usize, usize), u32> = HashMap::new();
    let mut node = |section: &mut Section, (i, j): (usize, usize)| {
        *at.entry((i, j)).or_insert_with(|| section.point([layout.x[i], layout.z[j]]))
    };
    for j in 0..layout.z.len() - 1 {
        for i in 0..layout.x.len() - 1 {
            if !taken[j * (layout.x.len() - 1) + i] {
                let quad = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|at| node(&mut section, at));
                section.quad(quad, Part::Rock);
            }
        }
    }
    let mut worst = Vec::with_capacity(layout.plots.len());
    for (k, plot) in layout.plots.iter().enumerate() {
        let (c, r) = (&plot.columns, &plot.rows);
        // Clockwise from the lower left corner.
        let left = r.clone().map(|j| (c.start, j));
        let top = c.clone().map(|i| (i, r.end));
        let right = (r.start + 1..=r.end).rev().map(|j| (c.end, j));
        let bottom = (c.start + 1..=c.end).rev().map(|i| (i, r.start));
        let rim: Vec<u32> =
            left.chain(top).chain(right).chain(bottom).map(|at| node(&mut section, at)).collect();
        worst.push(opening::fill(&mut section, plot, &spec.caverns[k], k as u32, &rim));
    }
    Ok((section, worst))
}
