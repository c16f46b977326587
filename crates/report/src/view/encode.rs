//! A part of the view as blocks.

use super::code::{Grid16, bits, deltas32, displacements, levels};
use super::columns::PartColumn;
use super::faces::Outer;
use super::labels::label;
use super::manifest::{Cells, Faces, Field, Group, PartData, PartKind, Points};
use super::part::Part;
use crate::language::Language;
use crate::script::blocks::Blocks;

/// In what all parts agree.
pub struct Common {
    pub language: Language,
    pub grid: Grid16,
    /// Number of times.
    pub times: usize,
    /// What a displacement of 1 is (m); 0 without any.
    pub step: f64,
}

impl Common {
    /// The part in the manifest, its numbers in `blocks`, and its fields of one value throughout: name and value.
    pub fn encode(
        &self,
        part: &Part,
        name: String,
        kind: PartKind,
        outer: &[Outer],
        blocks: &mut Blocks,
    ) -> (PartData, Vec<(String, f32)>) {
        let mesh = &part.mesh;
        let count = mesh.elements.len();
        let corners = (0..mesh.per).flat_map(|k| {
            // Within each run of corners the differences begin anew.
            deltas32(mesh.corners.iter().skip(k).step_by(mesh.per).copied())
        });
        let corners: Vec<u8> = corners.collect();
        let groups = part.groups.iter().filter(|(_, inside)| Part::size(inside) < count);
        let groups = groups
            .map(|(name, inside)| Group { name: name.clone(), block: blocks.add(&bits(inside, count)) });
        let groups = groups.collect();
        let mut uniform = Vec::new();
        let mut fields = Vec::new();
        for column in &part.columns.0 {
            match column.range() {
                Some((low, high)) if low < high => fields.push(self.field(part, column, low, high, blocks)),
                Some((low, _)) => uniform.push((column.name.clone(), low)),
                None => {}
            }
        }
        let data = PartData {
            name,
            kind,
            groups,
            points: Points { count: mesh.points.len(), block: blocks.add(&self.grid.points(&mesh.points)) },
            cells: Cells { count, corners: mesh.per, block: blocks.add(&corners) },
            elements: blocks.add(&deltas32(mesh.elements.iter().copied())),
            faces: Faces {
                count: outer.len(),
                block: blocks.add(&deltas32(outer.iter().map(|(face, _)| *face))),
                kind: blocks.add(&outer.iter().map(|(_, behind)| *behind as u8).collect::<Vec<_>>()),
            },
            displacement: (0..self.times).map(|time| self.displacement(part, time, blocks)).collect(),
            fields,
        };
        (data, uniform)
    }

    fn displacement(&self, part: &Part, time: usize, blocks: &mut Blocks) -> Option<usize> {
        let held = part.displacement.get(time).and_then(Option::as_ref);
        let values = held.map_or(&[][..], Vec::as_slice);
        (self.step > 0.0).then(|| blocks.add(&displacements(values, part.mesh.points.len(), self.step)))
    }

    fn field(&self, part: &Part, column: &PartColumn, low: f32, high: f32, blocks: &mut Blocks) -> Field {
        let count = if column.at_cells { part.mesh.elements.len() } else { part.mesh.points.len() };
        let mut stored: Vec<Option<usize>> = Vec::new();
        for time in 0..self.times {
            let values = column.at(time);
            // What did not change need not be packed to be found equal.
            let same = time > 0 && values.map(<[f32]>::as_ptr) == column.at(time - 1).map(<[f32]>::as_ptr);
            let block = match stored.last() {
                Some(&before) if same => before,
                _ => Some(blocks.add(&levels(values.unwrap_or(&[]), count, low, high))),
            };
            stored.push(block);
        }
        Field {
            name: column.name.clone(),
            label: label(self.language, &column.name),
            unit: column.unit.clone(),
            low: f64::from(low),
            high: f64::from(high),
            at: if column.at_cells { "cells" } else { "points" },
            blocks: stored,
        }
    }
}
