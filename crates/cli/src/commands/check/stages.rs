//! What is said of stages, for people and for programs.

use super::Checked;
use crate::commands::pieces::{in_words, pressure};
use crate::terminal::print;
use serde_json::{Value, json};
use tremolite::Stage;
use tremolite::outlook::{Hold, Named, StageOutlook};
use tremolite_results::MaterialFacts;

/// Shear below this share of the largest stress goes without saying.
const SHEAR: f64 = 1e-3;

impl Checked<'_> {
    pub(super) fn print_stages(&self) {
        let Some(outlook) = &self.outlook else { return };
        if !self.initial.is_empty() {
            print("\nInitial stress, compression positive");
            for found in &self.initial {
                let [x, y, z] = found.at;
                let [xx, yy, zz, shear @ ..] = found.stress;
                let largest = found.stress.iter().fold(0.0, |most: f64, s| most.max(s.abs()));
                let shear = if shear.iter().any(|s| s.abs() > SHEAR * largest) {
                    let [xy, yz, zx] = shear.map(|s| pressure(-s));
                    format!("; shear {xy} in xy, {yz} in yz, {zx} in zx, as tension is positive")
                } else {
                    String::new()
                };
                print(&format!(
                    "           {}, ({x:.1}, {y:.1}, {z:.1}) m: vertical {}, horizontal {} along x and {} along y{shear}",
                    found.place,
                    pressure(zz),
                    pressure(xx),
                    pressure(yy)
                ));
            }
            print("           where rock is beyond yield under it the run will show");
        }
        for relaxed in &self.relaxed {
            print(&format!(
                "           {}: in the stages E is {:.1} % of the one given, relaxed as under a load that lasts{}",
                relaxed.material,
                100.0 * relaxed.share,
                relaxed.young.map_or(String::new(), |[given, now]| format!(
                    ": {} beside {}",
                    pressure(-now),
                    pressure(-given)
                ))
            ));
        }
        print("\nStages");
        for (k, stage) in outlook.stages.iter().enumerate() {
            let what = changes(stage);
            print(&format!("           {k:>3}  {}{what}", stage.name));
            print(&format!(
                "                {} elements stand; {:.1} m2 of wall without lining",
                stage.standing, stage.bare
            ));
            for piece in &stage.pieces {
                let held = match &piece.held {
                    Hold::Nothing => "nothing holds".to_owned(),
                    Hold::Hangs { interfaces, bolts, .. } => {
                        format!("only {} holds", [&interfaces[..], bolts].concat().join(", "))
                    }
                };
                print(&format!("                {held} {}", in_words(piece)));
            }
        }
        if !outlook.lots.is_empty() {
            print("\nWhat comes and goes");
        }
        for lot in &outlook.lots {
            print(&format!(
                "           {:28} {:>8}  {}",
                lot.group,
                lot.elements,
                self.life(lot.life.born, lot.life.gone)
            ));
        }
        for stand_in in &outlook.stand_ins {
            print(&format!(
                "           in the place of {} elements of {} stands {} {}",
                stand_in.elements,
                stand_in.group,
                self.material_of(&stand_in.body),
                self.life(Stage::Before(0), stand_in.gone)
            ));
        }
    }

    /// The material of a body, which is called by its groups.
    fn material_of<'a>(&'a self, body: &'a str) -> &'a str {
        let made = |facts: &MaterialFacts| facts.groups.iter().any(|group| group.names == body);
        self.materials.iter().find(|(_, facts)| made(facts)).map_or(body, |(name, _)| name)
    }

    fn life(&self, born: Stage, gone: Option<Stage>) -> String {
        let from = (born > Stage::Before(0)).then(|| format!("from '{}' on", self.stage_name(born)));
        let until = gone.map(|gone| format!("until '{}'", self.stage_name(gone)));
        match (from, until) {
            (None, None) => "from the start to the end".into(),
            (from, until) => [from, until].into_iter().flatten().collect::<Vec<_>>().join(" "),
        }
    }

    fn stage_name(&self, stage: Stage) -> &str {
        match (stage, &self.outlook) {
            (Stage::Before(k), Some(outlook)) => outlook.stages.get(k as usize).map_or("", |s| &s.name),
            _ => "the earthquake",
        }
    }

    pub(super) fn stages_json(&self) -> Value {
        let Some(outlook) = &self.outlook else { return json!([]) };
        let groups = |all: &[Named]| {
            let one = |g: &Named| json!({ "groups": g.pattern, "elements": g.elements });
            all.iter().map(one).collect::<Vec<_>>()
        };
        let stages = outlook.stages.iter().map(|stage| {
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
        let Some(outlook) = &self.outlook else { return json!([]) };
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
        let one =
            |s: &tremolite::outlook::StressAt| json!({ "place": s.place, "at": s.at, "stress": s.stress });
        Value::Array(self.initial.iter().map(one).collect())
    }

    pub(super) fn relaxed_json(&self) -> Value {
        let one = |r: &super::Relaxed| {
            let young = r.young.map(|[given, now]| json!({ "given": given, "in_stages": now }));
            json!({ "material": r.material, "share": r.share, "young": young })
        };
        Value::Array(self.relaxed.iter().map(one).collect())
    }
}

/// What a stage does, behind its name.
fn changes(stage: &StageOutlook) -> String {
    let groups = |verb: &str, all: &[Named]| {
        let all: Vec<String> = all.iter().map(|g| format!("{} ({})", g.pattern, g.elements)).collect();
        (!all.is_empty()).then(|| format!("{verb} {}", all.join(", ")))
    };
    let mut parts: Vec<String> =
        [groups("excavates", &stage.excavated), groups("installs", &stage.installed)]
            .into_iter()
            .flatten()
            .chain(stage.changed.iter().cloned())
            .collect();
    if stage.release < 1.0 {
        parts.push(format!("{:.0} % of what is held goes", 100.0 * stage.release));
    }
    if parts.is_empty() { String::new() } else { format!(": {}", parts.join("; ")) }
}
