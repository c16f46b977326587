//! What is left out so that the view keeps within its share of the page.

use std::collections::HashSet;

use super::manifest::{PartData, PartKind};
use crate::script::blocks::Blocks;

/// What was left out of the ground.
#[derive(Debug, Default, PartialEq)]
pub struct LeftOut {
    /// Of how many times one is there: 1 where all are.
    pub every: usize,
    /// Names of fields.
    pub fields: Vec<String>,
    /// Whether displacement as well.
    pub displacement: bool,
    /// Bytes of all that is there.
    pub size: usize,
}

/// Fields of the ground that go last; those that are not here go first.
const LASTING: [&str; 6] = ["s1", "s3", "plastic_shear_strain", "displacement_max", "s1_max", "s3_min"];

/// Leaves out what is over `budget` (bytes in the page): of the ground every second time, again until it fits or two
/// times are left; then its fields, last those of [`LASTING`] from its end, and of the others the last of the file first;
/// then its displacement. The last time stays always, and linings and interfaces are never touched.
pub fn fit(parts: &mut [PartData], times: usize, blocks: &Blocks, budget: usize) -> LeftOut {
    let mut left = LeftOut { every: 1, ..LeftOut::default() };
    loop {
        left.size = size(parts, blocks);
        if left.size <= budget {
            return left;
        }
        if times.div_ceil(2 * left.every) >= 2 {
            left.every *= 2;
            thin(parts, times, left.every);
        } else if let Some(name) = next(parts) {
            ground(parts).for_each(|part| part.fields.retain(|field| field.name != name));
            left.fields.push(name);
        } else if !left.displacement {
            ground(parts).for_each(|part| part.displacement.fill(None));
            left.displacement = true;
        } else {
            return left;
        }
    }
}

fn ground(parts: &mut [PartData]) -> impl Iterator<Item = &mut PartData> {
    parts.iter_mut().filter(|part| part.kind == PartKind::Rock)
}

/// Keeps one of `every` times, counted from the last.
fn thin(parts: &mut [PartData], times: usize, every: usize) {
    let keep = |time: usize| (times - 1 - time).is_multiple_of(every);
    for part in ground(parts) {
        let series = part.fields.iter_mut().map(|field| &mut field.blocks).chain([&mut part.displacement]);
        series.for_each(|blocks| {
            (0..times).filter(|&time| !keep(time)).for_each(|time| blocks[time] = None);
        });
    }
}

/// The field that goes next.
fn next(parts: &mut [PartData]) -> Option<String> {
    let names: Vec<String> =
        ground(parts).flat_map(|part| &part.fields).map(|field| field.name.clone()).collect();
    let rank = |name: &String| LASTING.iter().position(|known| known == name).unwrap_or(LASTING.len());
    names.into_iter().max_by_key(rank)
}

/// Bytes of all blocks that are there.
pub fn size(parts: &mut [PartData], blocks: &Blocks) -> usize {
    let used: HashSet<usize> = parts.iter_mut().flat_map(PartData::blocks).map(|block| *block).collect();
    used.into_iter().map(|block| blocks.size(block)).sum()
}
