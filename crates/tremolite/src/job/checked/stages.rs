//! What is said of stages, for programs.

use super::{Checked, Relaxed};
use crate::outlook::{Hold, Named, StressAt};
use crate::seepage::StageFlow;
use serde_json::{Value, json};
use tremolite_engine::Stage;
use tremolite_results::MaterialFacts;

impl Checked<'_> {
    /// The material of a body.
    pub fn material_of<'a>(&'a self, body: &'a str) -> &'a str {
        let made = |facts: &MaterialFacts| facts.groups.iter().any(|group| group.body == body);
        self.job.materials.iter().find(|(_, facts)| made(facts)).map_or(body, |(name, _)| name)
    }

    /// The name of a stage.
    pub fn stage_name(&self, stage: Stage) -> &str {
        match (stage, &self.job.outlook) {
            (Stage::Before(k), Some(outlook)) => outlook.stages.get(k as usize).map_or("", |s| &s.name),
            _ => "the earthquake",
        }
    }

    pub(super) fn stages_json(&self) -> Value {
        let Some(outlook) = &self.job.outlook else { return json!([]) };
        let groups = |all: &[Named]| {
            let one = |g: &Named| json!({ "groups": g.pattern, "elements": g.elements });
            all.iter().map(one).collect::<Vec<_>>()
        };
        let stages = outlook.stages.iter().zip(&self.job.plan.stages).map(|(stage, planned)| {
            let pieces = stage.pieces.iter().map(|piece| {
                let (low, high) = piece.bounds;
                let hangs = match &piece.held {
                    Hold::Nothing => Vec::new(),
                    Hold::Hangs { interfaces, bolts, .. } => [&interfaces[..], bolts].concat(),
                };
                json!({
                    "group": piece.group, "elements": piece.elements.len(), "volume": piece.volume,
                    "low": low, "high": high, "hangs_by": hangs,
                })
            });
            json!({
                "name": stage.name,
                "excavated": groups(&stage.excavated),
                "installed": groups(&stage.installed),
                "release": stage.release,
                "changed": stage.changed,
                "seepage": planned.flow.as_ref().map(StageFlow::summary),
                "standing": stage.standing,
                "gone": stage.gone,
                "begun": stage.begun,
                "wall_without_lining": stage.bare,
                "without_support": pieces.collect::<Vec<_>>(),
            })
        });
        Value::Array(stages.collect())
    }

    pub(super) fn lives_json(&self) -> Value {
        let Some(outlook) = &self.job.outlook else { return json!([]) };
        let from = |born: Stage| (born > Stage::Before(0)).then(|| self.stage_name(born));
        let until = |gone: Option<Stage>| gone.map(|gone| self.stage_name(gone));
        let lots = outlook.lots.iter().map(|lot| {
            json!({
                "group": lot.group, "elements": lot.elements, "stands_in": null,
                "from": from(lot.life.born), "until": until(lot.life.gone),
            })
        });
        let stand_ins = outlook.stand_ins.iter().map(|stand_in| {
            json!({
                "group": stand_in.group, "elements": stand_in.elements, "stands_in": self.material_of(&stand_in.body),
                "from": null, "until": until(stand_in.gone),
            })
        });
        Value::Array(lots.chain(stand_ins).collect())
    }

    pub(super) fn initial_json(&self) -> Value {
        let one = |s: &StressAt| json!({ "place": s.place, "at": s.at, "stress": s.stress });
        Value::Array(self.initial.iter().map(one).collect())
    }

    pub(super) fn relaxed_json(&self) -> Value {
        let one = |r: &Relaxed| {
            let young = r.young.map(|[given, now]| json!({ "given": given, "in_stages": now }));
            json!({ "material": r.material, "share": r.share, "young": young })
        };
        Value::Array(self.relaxed.iter().map(one).collect())
    }
}
