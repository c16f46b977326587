//! Pairs of interfaces by the masses that they move: how stiff they may be for the step goes by these.

use crate::assembly::Assembly;
use crate::error::ModelError;
use crate::interface::Seam;
use crate::life::{Life, Stage};
use crate::model::Model;
use crate::phase::Phase;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The phases that pairs are judged in: of the shaking, and for those that are gone by then of a stage in which they are there.
pub struct Phases(pub BTreeMap<Stage, Arc<Phase>>);

impl Phases {
    pub fn of(model: &Model, assembly: &Assembly) -> Result<Self, ModelError> {
        let lives = model.seams.iter().flat_map(|seam| &seam.lives);
        let stages: BTreeSet<Stage> = lives.map(judged_in).chain([Stage::Shaking]).collect();
        let phase = |stage| Ok((stage, Phase::of(model, assembly, stage)?));
        Ok(Phases(stages.into_iter().map(phase).collect::<Result<_, ModelError>>()?))
    }

    /// The nodes that the two of a pair move with.
    pub fn masters(&self, model: &Model, seam: &Seam, pair: usize) -> [u32; 2] {
        let phase = &self.0[&judged_in(&seam.lives[pair])];
        seam.pairs[pair].nodes.map(|n| phase.master[model.engine_node[n as usize] as usize])
    }
}

/// The shaking, or else the last stage in which something is there: what goes with the shaking has not been told how many there
/// are, and is judged in its first.
fn judged_in(life: &Life) -> Stage {
    match life.gone {
        // Nothing is gone before it was there, so not from the first on.
        Some(Stage::Before(k)) => Stage::Before(k.saturating_sub(1)),
        Some(Stage::Shaking) => life.born,
        None => Stage::Shaking,
    }
}

/// Pairs by the masses that they move.
pub struct PairMasses {
    /// By interface and pair: 1/m of both nodes along the normal, with their tied sets \[1/kg\].
    inverse: Vec<Vec<[f64; 2]>>,
    /// And the masters of both, with the stage that they are judged in.
    masters: Vec<Vec<[(Stage, u32); 2]>>,
    /// Area of the pairs of each interface at a master \[m²\].
    areas: Vec<BTreeMap<(Stage, u32), f64>>,
}

impl PairMasses {
    pub fn of(model: &Model, phases: &Phases) -> Self {
        let mut all = PairMasses { inverse: Vec::new(), masters: Vec::new(), areas: Vec::new() };
        for seam in &model.seams {
            let mut areas: BTreeMap<(Stage, u32), f64> = BTreeMap::new();
            let (mut inverse, mut masters) = (Vec::new(), Vec::new());
            for (k, pair) in seam.pairs.iter().enumerate() {
                let stage = judged_in(&seam.lives[k]);
                let both = phases.masters(model, seam, k);
                both.iter().for_each(|&n| *areas.entry((stage, n)).or_default() += pair.normal_area);
                inverse.push(both.map(|n| {
                    let row = &phases.0[&stage].inverse_mass[n as usize];
                    (0..3).map(|i| row.0[i] * pair.normal[i] * pair.normal[i]).sum()
                }));
                masters.push(both.map(|n| (stage, n)));
            }
            all.inverse.push(inverse);
            all.masters.push(masters);
            all.areas.push(areas);
        }
        all
    }

    /// ω² of each pair of an interface, with the stiffness of each interface.
    pub fn squares(&self, of: usize, stiffness: impl Fn(usize) -> f64) -> Vec<f64> {
        let at = |master: (Stage, u32)| -> f64 {
            let area = |areas: &BTreeMap<(Stage, u32), f64>| areas.get(&master).copied().unwrap_or(0.0);
            self.areas.iter().enumerate().map(|(s, areas)| area(areas) * stiffness(s)).sum()
        };
        self.masters[of]
            .iter()
            .zip(&self.inverse[of])
            .map(|(masters, inverse)| inverse[0] * at(masters[0]) + inverse[1] * at(masters[1]))
            .collect()
    }
}
