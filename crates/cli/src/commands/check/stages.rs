//! What is said of stages, for people.

use super::Lines;
use crate::terminal::print;
use tremolite::Stage;
use tremolite::job::Checked;
use tremolite::job::warnings::{in_words, pressure};
use tremolite::outlook::{Hold, Named, StageOutlook};

/// Shear below this share of the largest stress goes without saying.
const SHEAR: f64 = 1e-3;
/// A modulus of the stages nearer than this to the one given is that one, as people read it.
const SHARE: f64 = 5e-4;

pub(super) fn print_stages(checked: &Checked, lines: Lines) {
    let Some(outlook) = &checked.job.outlook else { return };
    if !checked.initial.is_empty() {
        print("\nInitial stress, compression positive");
        for found in &checked.initial {
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
    }
    if let Some(rest) = &outlook.at_rest {
        print(&format!(
            "           under it {:.1} % of the ground is in tension, {:.1} % beyond yield",
            100.0 * rest.tension / rest.volume,
            100.0 * rest.beyond / rest.volume
        ));
    }
    let moved = |share: f64| lines == Lines::All || (share - 1.0).abs() > SHARE;
    for relaxed in checked.relaxed.iter().filter(|relaxed| moved(relaxed.share)) {
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
        if lines == Lines::All {
            print(&format!(
                "                {} elements stand; {:.1} m2 of wall without lining",
                stage.standing, stage.bare
            ));
        }
        print_flow(checked, k);
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
    if lines == Lines::Deciding {
        return;
    }
    if !outlook.lots.is_empty() {
        print("\nWhat comes and goes");
    }
    for lot in &outlook.lots {
        print(&format!(
            "           {:28} {:>8}  {}",
            lot.group,
            lot.elements,
            life(checked, lot.life.born, lot.life.gone)
        ));
    }
    for stand_in in &outlook.stand_ins {
        print(&format!(
            "           in the place of {} elements of {} stands {} {}",
            stand_in.elements,
            stand_in.group,
            checked.material_of(&stand_in.body),
            life(checked, Stage::Before(0), stand_in.gone)
        ));
    }
}

/// The seepage that begins with a stage: what walls and drains take.
fn print_flow(checked: &Checked, stage: usize) {
    let Some(flow) = checked.job.plan.stages.get(stage).and_then(|stage| stage.flow.as_ref()) else { return };
    let taken = flow.taken().iter().map(|(name, q)| format!("{name} {}", discharge(*q)));
    let taken: Vec<String> = taken.collect();
    let what = if taken.is_empty() { "no wall and no drain takes water".into() } else { taken.join(", ") };
    print(&format!(
        "                seepage: {what}; mass error {:.0e}, {} iterations, {:.1} s{}",
        flow.mass_error,
        flow.iterations,
        flow.seconds,
        if flow.left > 1e-3 {
            format!("; {} % of the permeability is left in dry ground", 100.0 * flow.left)
        } else {
            String::new()
        }
    ));
}

/// A flow of water as people read it.
fn discharge(q: f64) -> String {
    format!("{:.3e} m3/s ({} l/s)", q, figures(1e3 * q))
}

/// Three significant figures.
fn figures(x: f64) -> String {
    let places = if x == 0.0 { 0.0 } else { (2.0 - x.abs().log10().floor()).clamp(0.0, 9.0) };
    format!("{x:.*}", places as usize)
}

fn life(checked: &Checked, born: Stage, gone: Option<Stage>) -> String {
    let from = (born > Stage::Before(0)).then(|| format!("from '{}' on", checked.stage_name(born)));
    let until = gone.map(|gone| format!("until '{}'", checked.stage_name(gone)));
    match (from, until) {
        (None, None) => "from the start to the end".into(),
        (from, until) => [from, until].into_iter().flatten().collect::<Vec<_>>().join(" "),
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
