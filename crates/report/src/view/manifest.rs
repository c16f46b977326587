//! What the page's script is told of the view: the blocks that hold numbers, and what these mean. SI throughout.

use serde::Serialize;
use tremolite_results::Wave;

use crate::flow::FlowLine;
use crate::quantities::scale::trimmed;

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Manifest {
    pub version: u32,
    /// `earthquake` or `stages`.
    pub clock: &'static str,
    /// Place = origin + step × u16 (m).
    pub origin: [f64; 3],
    pub step: [f64; 3],
    pub times: Vec<Moment>,
    /// By time, mean displacement of the model (m).
    pub mean: Vec<[f64; 3]>,
    /// What a displacement of 1 is (m); 0 where no file holds displacement.
    pub displacement_step: f64,
    /// The largest component of any displacement about the mean (m).
    pub displacement_largest: f64,
    pub parts: Vec<PartData>,
    /// Plane waves at angles, during the earthquake.
    pub waves: Vec<Arrow>,
    /// Flows of water, each once, and by time which of them is there.
    pub flows: Vec<FlowHeld>,
    pub flow_at: Vec<Option<usize>>,
    /// For the reader.
    pub notes: Vec<String>,
}

/// How a wave comes in.
#[derive(Serialize)]
pub struct Arrow {
    pub label: String,
    /// Its way along x, y, z of the model, of length 1.
    pub way: [f64; 3],
    /// What it moves, likewise.
    pub polarisation: [f64; 3],
}

impl Arrow {
    pub fn of(wave: &Wave) -> Arrow {
        let angle = trimmed(&format!("{:.2}", wave.angle.to_degrees()));
        Arrow { label: format!("{} {angle}°", wave.kind), way: wave.way, polarisation: wave.polarisation }
    }
}

/// Flow lines of water.
#[derive(PartialEq, Serialize)]
pub struct FlowHeld {
    /// How far behind a cut lines are shown (m).
    pub beside: f64,
    /// The points of each line, from where the water comes from to where it goes: x, y, z of one after the other (m).
    pub lines: Vec<Vec<f64>>,
}

impl FlowHeld {
    /// To a centimetre, which is finer than what is seen.
    pub fn of(lines: &[FlowLine<3>], beside: f64) -> FlowHeld {
        let rounded = |x: &f64| (x * 1e2).round() / 1e2;
        let lines = lines.iter().map(|line| line.iter().flatten().map(rounded).collect());
        FlowHeld { beside: rounded(&beside), lines: lines.collect() }
    }
}

/// A time, or the end of a stage.
#[derive(Clone, Serialize)]
pub struct Moment {
    /// s, or the stage's number.
    pub t: f64,
    pub label: String,
}

/// `rock`, `lining` or `interface`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum PartKind {
    Rock,
    Lining,
    Interface,
}

#[derive(Serialize)]
pub struct PartData {
    pub name: String,
    pub kind: PartKind,
    pub groups: Vec<Group>,
    pub points: Points,
    pub cells: Cells,
    pub elements: usize,
    pub faces: Faces,
    /// By time; none where it was left out.
    pub displacement: Vec<Option<usize>>,
    pub fields: Vec<Field>,
}

#[derive(Serialize)]
pub struct Group {
    pub name: String,
    pub block: usize,
}

#[derive(Serialize)]
pub struct Points {
    pub count: usize,
    pub block: usize,
}

#[derive(Serialize)]
pub struct Cells {
    pub count: usize,
    pub corners: usize,
    pub block: usize,
}

#[derive(Serialize)]
pub struct Faces {
    pub count: usize,
    pub block: usize,
    pub kind: usize,
}

#[derive(Serialize)]
pub struct Field {
    pub name: String,
    pub label: String,
    pub unit: String,
    pub low: f64,
    pub high: f64,
    /// `cells` or `points`.
    pub at: &'static str,
    /// By time; none where it was left out.
    pub blocks: Vec<Option<usize>>,
}

impl PartData {
    /// All numbers of blocks.
    pub fn blocks(&mut self) -> impl Iterator<Item = &mut usize> {
        let fixed = [
            &mut self.points.block,
            &mut self.cells.block,
            &mut self.elements,
            &mut self.faces.block,
            &mut self.faces.kind,
        ];
        let groups = self.groups.iter_mut().map(|group| &mut group.block);
        let fields = self.fields.iter_mut().flat_map(|field| &mut field.blocks);
        fixed.into_iter().chain(groups).chain(fields.chain(&mut self.displacement).flatten())
    }
}
