//! What a run leaves for people: summary.json, with a verdict and a line for each thing that bears on trust.

use crate::damage;
use crate::plan::Plan;
use crate::run::{Ending, Outcome, active_elements};
use crate::setup::MotionFacts;
use crate::survey::{Survey, limit_in_words};
use crate::trust::trust;
use crate::{Halt, Model, Phase};
use indexmap::IndexMap;
use tremolite_results::{
    Defaulted, Finding, MaterialFacts, ModelFacts, MotionFacts as MotionSummary, Peaks, RunFacts, Status,
    Summary, Table, TrustLine, peaks_by_monitor,
};

/// All a summary is made from.
pub struct Input<'a> {
    pub model: &'a Model,
    pub phase: &'a Phase,
    pub plan: &'a Plan,
    pub motion: &'a MotionFacts,
    pub survey: &'a Survey,
    pub outcome: &'a Outcome,
    /// monitors.csv as it was written.
    pub histories: &'a Table,
    /// energy.csv as it was written.
    pub energy: &'a Table,
    pub materials: IndexMap<String, MaterialFacts>,
    pub run: RunFacts,
    pub defaulted: Vec<Defaulted>,
    /// Wall time of the whole process so far \[s\].
    pub wall_seconds: f64,
}

/// The summary of a run that ended.
pub fn summary(input: Input) -> Summary {
    let Input { model, phase, plan, motion, survey, outcome, histories, .. } = input;
    let all = peaks_by_monitor(histories);
    let is_pair = |name: &str| {
        plan.relatives
            .iter()
            .any(|[a, b]| name == format!("{}-{}", plan.monitors[*a].name, plan.monitors[*b].name))
    };
    let (relative, monitors): (IndexMap<_, _>, IndexMap<_, _>) =
        all.into_iter().partition(|(n, _)| is_pair(n));
    let trust = trust(&input);
    let damage = damage::damage(model, phase, &outcome.state);
    let run = run_in_words(outcome, &trust, &monitors);
    let findings = damage::findings(model, &damage);
    let status = match outcome.ending {
        Ending::Done => Status::Done,
        Ending::Stopped => Status::Stopped,
        Ending::Failed { .. } => Status::Failed,
    };
    let axes = ["x", "y", "z"];
    let peak = |i: usize| (axes[i].to_owned(), motion.factor * motion.intensity[i].pga);
    let source = |i: usize| (axes[i].to_owned(), motion.source.clone());
    let mut groups: IndexMap<String, u64> =
        survey.bodies.iter().map(|b| (b.name.clone(), b.elements as u64)).collect();
    if survey.void_elements > 0 {
        groups.insert("void".into(), survey.void_elements as u64);
    }
    Summary {
        title: plan.title.clone(),
        status,
        verdict: verdict(&run, &findings),
        outcome: run,
        findings,
        wall_seconds: input.wall_seconds,
        element_updates_per_second: outcome.updates_per_second(active_elements(phase)),
        model: ModelFacts {
            groups,
            elements: survey.active_elements as u64,
            nodes: survey.nodes as u64,
            steps: outcome.taken,
            time_step: outcome.dt,
            step_set_by: limit_in_words(model, &outcome.stable),
            duration: outcome.taken as f64 * outcome.dt,
        },
        materials: input.materials,
        motion: MotionSummary {
            kind: motion.kind.to_string(),
            factor: motion.factor,
            peak_acceleration: (0..3).map(peak).collect(),
            source: (0..3).map(source).collect(),
        },
        positions: plan.monitors.iter().map(|m| (m.name.clone(), m.point)).collect(),
        monitors,
        relative,
        damage,
        energy: outcome.balance.lines().iter().map(|(n, v)| ((*n).to_owned(), *v)).collect(),
        trust,
        run: input.run,
        defaulted: input.defaulted,
    }
}

/// The run's outcome and that of each structure, in one text.
fn verdict(run: &str, findings: &[Finding]) -> String {
    let mut text = run.to_owned();
    for finding in findings {
        text += &format!(" {}: {}.", finding.group, finding.headline);
        if !finding.text.is_empty() {
            text += &format!(" {}", finding.text);
        }
    }
    text
}

fn run_in_words(
    outcome: &Outcome,
    trust: &[TrustLine],
    monitors: &IndexMap<String, IndexMap<String, Peaks>>,
) -> String {
    let judged = trust.iter().filter(|t| !t.not_applicable);
    let passed = judged.clone().filter(|t| t.pass).count();
    let time = outcome.taken as f64 * outcome.dt;
    let mut text = match &outcome.ending {
        Ending::Done => format!("The run reached its end, {time:.2} s."),
        Ending::Stopped => format!("The run was stopped at {time:.3} s; go on with --resume."),
        Ending::Failed { halt: Halt::Energy { kinetic, supplied, .. }, place } => format!(
            "The run became unstable and was stopped at {time:.4} s: the kinetic energy of {kinetic:.3e} J exceeds all \
             the energy supplied, {supplied:.3e} J. Most of it is in {place}. Use a smaller time_step or safety."
        ),
    };
    text += &format!(" {passed} of {} checks of the run pass", judged.count());
    let warned: Vec<&str> = trust.iter().filter(|t| !t.pass).map(|t| t.name.as_str()).collect();
    if warned.is_empty() {
        text += ".";
    } else {
        text += &format!("; look at: {}.", warned.join(", "));
    }
    if matches!(outcome.ending, Ending::Failed { .. }) {
        return text;
    }
    let most = monitors
        .iter()
        .filter_map(|(name, q)| Some((name, q.get("s1")?)))
        .filter(|(_, p)| p.max.is_finite())
        .max_by(|a, b| a.1.max.total_cmp(&b.1.max));
    if let Some((name, peak)) = most {
        text += &format!(
            " Largest principal stress at a monitor, in full elements extrapolated to it as long as they are intact: \
             {:.2} MPa at {name}, {:.2} s (change by the earthquake alone).",
            peak.max / 1e6,
            peak.t_max
        );
    }
    text
}
