//! Sums of what a wave does at some heights, each a course of its own.
//!
//! Meshes have their nodes, and the points of their faces, at few heights, often beside and above one another in the same way at many
//! places. There the cubics upwards, and sums over what lies so, are the same at all times, so what they come to is kept.

use super::later::Later;
use super::series::Series;
use rayon::prelude::*;
use tremolite_engine::courses::{Course, Courses};

/// What is summed up: components of displacement or of stress at a height, times what one of each makes of a vector.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// By how many samples it is later than the sum, 0 or more.
    pub behind: f64,
    /// m above the base.
    pub height: f64,
    pub of: [[f64; 4]; 4],
}

/// Sums of displacements, or of stresses. Terms stand in the order of what they are behind.
pub fn rows(series: &Series, stresses: bool, sums: &[&[Term]]) -> Courses {
    let samples = series.samples();
    let mut rows = Courses::new(sums.len(), samples);
    let mut each: Vec<(&[Term], Course)> = sums.iter().copied().zip(rows.each()).collect();
    let room = || [0, 1].map(|_| vec![[[0.0; 4]; 2]; samples]);
    each.par_drain(..).for_each_init(room, |[sum, part], (terms, course)| {
        sum.fill([[0.0; 4]; 2]);
        for together in terms.chunk_by(|a, b| a.behind == b.behind) {
            part.fill([[0.0; 4]; 2]);
            together.iter().for_each(|term| series.add(term.height, stresses, &term.of, part));
            Later::by(together[0].behind).add(part, sum);
        }
        course.keep(sum);
    });
    rows
}
