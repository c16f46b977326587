//! The grid of the block: where its lines run and which rectangle of it each cavern takes.

use std::ops::Range;

use super::claims::{Claim, margins, meet_levels, shrink};
use super::lines::lines;
use super::passage::{self, Passage};
use super::plot::Plot;
use super::profile::Outline;
use super::rows::Counts;
use super::stretch::GROWTH;
use super::wall::Rows;
use super::{CavernError, CavernSpec, along};
use crate::boxes::MOST_ELEMENTS;
use crate::grading::graded;

/// The lines of the grid and the caverns' places in it.
pub(super) struct Layout {
    pub x: Vec<f64>,
    pub y: Vec<f64>,
    pub z: Vec<f64>,
    pub plots: Vec<Plot>,
    /// The galleries.
    pub passages: Vec<Passage>,
}

impl Layout {
    /// `insets`: for each cavern the number of edges below it to the tied point, or the usual one.
    pub fn new(spec: &CavernSpec, insets: &[Option<usize>]) -> Result<Layout, CavernError> {
        let first = &spec.caverns[0];
        let ground = -spec.overburden - first.height;
        let mut plots: Vec<Plot> = Vec::with_capacity(spec.caverns.len());
        for (cavern, inset) in spec.caverns.iter().zip(insets) {
            let outline = Outline::new(cavern);
            let mut counts = Counts::new(cavern, &outline, spec.near);
            counts.inset = inset.unwrap_or(counts.inset);
            plots.push(Plot {
                centre: [cavern.at[0] - first.at[0], ground + cavern.at[1] - first.at[1]],
                outline,
                counts,
                columns: 0..0,
                rows: 0..0,
                wall: Rows::default(),
                galleries: Vec::new(),
                stops: None,
                pins: Vec::new(),
                rings: Vec::new(),
            });
        }
        let passages = passage::find(spec, &plots)?;
        let mut levels: Vec<f64> = passages.iter().flat_map(|p| p.z).collect();
        levels.sort_by(f64::total_cmp);
        levels.dedup();
        for (k, (plot, cavern)) in plots.iter_mut().zip(&spec.caverns).enumerate() {
            plot.galleries = passage::levels(&passages, k, plot.centre[1]);
            plot.meet_galleries(cavern, spec.near);
        }

        let claims = plots.iter().map(|plot| {
            let (low, high) = plot.outline.bounds();
            let body = [low, high].map(|p| [plot.centre[0] + p[0], plot.centre[1] + p[1]]);
            Claim {
                body,
                margin: margins(spec.near, &plot.outline, &plot.counts, plot.galleries.first() == Some(&0.0)),
            }
        });
        let mut claims: Vec<Claim> = claims.collect();
        let floor = plots.iter().map(|p| p.centre[1]).fold(f64::INFINITY, f64::min);
        let left = claims.iter().map(|c| c.body[0][0]).fold(f64::INFINITY, f64::min);
        let right = claims.iter().map(|c| c.body[1][0]).fold(f64::NEG_INFINITY, f64::max);
        let across = [left - spec.sides, right + spec.sides];
        // As high as the ground anywhere: squeezed to meet it, no element gets larger than it is here.
        let top = spec.ground.highest(across, [-0.5 * spec.length, 0.5 * spec.length]);
        let block = [across, [floor - spec.below, top]];

        shrink(spec, &mut claims, block)?;
        meet_levels(spec.near, &mut claims, &levels);
        for (plot, claim) in plots.iter_mut().zip(&claims) {
            let mean = claim.margin.as_flattened().iter().sum::<f64>() / 4.0;
            let line = graded(0.0, mean, (Some(spec.near), None), spec.far, GROWTH).map_err(|cause| {
                CavernError::Grading { line: "the rings round a cavern", key: "size_near", cause }
            })?;
            plot.rings = line.iter().map(|s| s / mean).collect();
        }

        let x = lines(spec, 0, block[0], &[], &claims, &mut plots)?;
        let z = lines(spec, 1, block[1], &levels, &claims, &mut plots)?;
        let rows = spec.rows();
        let elements = rows * (x.len() - 1) as f64 * (z.len() - 1) as f64;
        let inside: f64 = plots.iter().map(|p| (p.counts.vault() * p.counts.vault()) as f64 * rows).sum();
        if elements + inside > MOST_ELEMENTS as f64 {
            return Err(CavernError::TooMany {
                elements: elements + inside,
                near: spec.near,
                along: spec.step(),
            });
        }
        for (plot, cavern) in plots.iter_mut().zip(&spec.caverns) {
            if let Outline::Walls(profile) = &plot.outline {
                plot.wall = Rows::even(plot.counts.wall, profile.inner.springing, cavern.benches as usize);
            }
        }
        passage::pin(spec, &passages, &z, &mut plots)?;
        Ok(Layout { x, y: along::planes(spec)?, z, plots, passages })
    }

    /// A cavern's rectangle: lowest and highest x and z.
    pub fn rectangle(&self, plot: &Plot) -> [[f64; 2]; 2] {
        let Range { start, end } = plot.columns;
        [[self.x[start], self.x[end]], [self.z[plot.rows.start], self.z[plot.rows.end]]]
    }
}
