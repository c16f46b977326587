//! What a run says, to the terminal and to log.txt.

use crate::commands::check::more;
use crate::terminal::{bytes as in_bytes, duration, say, sent};
use std::io::Write;
use tremolite::job::Job;
use tremolite::plan::Plan;
use tremolite::ranks::Took;
use tremolite::run::Progress;
use tremolite::simulation::Outcome;
use tremolite::survey::{impacts_in_words, limit_in_words};
use tremolite::{Bytes, Division, Ranks};
use tremolite_results::{ResultFolder, Summary, TrustLine};

/// Messages to the terminal and to log.txt.
pub(super) struct Log {
    file: Option<std::fs::File>,
}

impl Log {
    pub(super) fn open(folder: &ResultFolder) -> Log {
        Log { file: std::fs::OpenOptions::new().create(true).append(true).open(folder.log()).ok() }
    }

    /// That of a rank for which another speaks.
    pub(super) fn none() -> Log {
        Log { file: None }
    }

    pub(super) fn keep(&mut self, message: &str) {
        // The results matter more than their log: a full disk is reported by them.
        if let Some(file) = &mut self.file {
            let _ = writeln!(file, "{} {message}", jiff::Timestamp::now());
        }
    }

    pub(super) fn say(&mut self, message: &str) {
        say(message);
        self.keep(message.trim());
    }
}

/// How a model is shared out.
pub(super) fn shared_out(division: &Division) -> String {
    format!(
        "  {} ranks, of which in each step the one with most work has {}",
        division.ranks,
        more(division.imbalance, division.imbalance_cracked)
    )
}

/// How evenly ranks were at work, and what they held.
pub(super) fn busy(ranks: &Ranks, held: Option<Bytes>) -> Vec<String> {
    let Took { halos, bytes, waited, worked } = ranks.tally.took();
    let [worked, waited, bytes] =
        [worked, waited, bytes as f64 / halos.max(1) as f64].map(|own| ranks.each(own));
    let mean = |all: &[f64]| all.iter().sum::<f64>() / all.len() as f64;
    let most = |all: &[f64]| all.iter().copied().fold(0.0, f64::max);
    let mut said = vec![format!(
        "  ranks evaluated parts for {:.1} s in the mean and {:.1} s at most, and waited for others for {:.1} s in the mean; each sent up to {} an \
         evaluation",
        mean(&worked),
        most(&worked),
        mean(&waited),
        sent(most(&bytes))
    )];
    let shared = ranks.each(held.map_or(0.0, |held| held.shared() as f64));
    let all: f64 = shared.iter().sum();
    if all > 0.0 {
        let most = most(&shared);
        said.push(format!(
            "  of parts and what they remember the rank with most held {}, {:.2} of what all held",
            in_bytes(most as usize),
            most / all
        ));
    }
    said
}

/// What will be run.
pub(super) fn before(log: &mut Log, job: &Job) {
    let Job { model, assembly, plan, motion, survey, stable, dt, steps, .. } = job;
    log.say(&plan.title);
    let shaken = motion.is_some();
    let steps_in_words =
        if shaken { format!("{} steps of {dt:.3e} s, ", steps.total) } else { String::new() };
    log.say(&format!(
        "  {} elements, {} nodes, {steps_in_words}{} threads, {}, about {}",
        survey.active_elements,
        survey.nodes,
        rayon::current_num_threads(),
        model.scheme.isa.name(),
        in_bytes(survey.bytes)
    ));
    if shaken {
        log.say(&format!(
            "  the stable step is {:.3e} s, set by {}",
            stable.dt,
            limit_in_words(model, assembly, stable)
        ));
        if let Some(impacts) = impacts_in_words(model, stable) {
            log.say(&format!("  {impacts}"));
        }
    }
    if let Some(motion) = motion {
        log.say(&format!("  motion: kind = {}, so {}", motion.kind, motion.entering().join("; ")));
    }
}

/// How far it is.
pub(super) fn progress(plan: &Plan, p: &Progress) -> String {
    match p.stage {
        Some(stage) => {
            let name = &plan.stages[stage].name;
            format!("{name}: cycle {}, {:.1e} out of balance", p.cycle, p.ratio)
        }
        None => format!("{:.2} s of {:.2} s  {:.1} M/s", p.time, plan.duration, p.updates_per_second / 1e6),
    }
}

/// A check that applies, in a line.
pub(super) fn check(line: &TrustLine) -> String {
    let mark = if line.pass { "ok  " } else { "LOOK" };
    // What cannot be told says why.
    let found = match line.value.is_nan() {
        true => line.note.clone(),
        false => format!("{} (limit {})", short(line.value), line.limit),
    };
    format!("  {mark} {}: {found}", line.name)
}

/// What came out.
pub(super) fn after(log: &mut Log, job: &Job, outcome: &Outcome, summary: &Summary) {
    for line in &summary.soundness.checks {
        // Each with its reason, where it does not bury the others.
        if line.not_applicable {
            log.keep(&format!("--   {}: not applicable, {}", line.name, line.note));
            continue;
        }
        log.say(&check(line));
    }
    let idle = summary.soundness.checks.iter().filter(|line| line.not_applicable).count();
    if idle > 0 {
        log.say(&format!("  --   {idle} more checks do not apply; log.txt and the page say why"));
    }
    let elements = job.phase.evaluated_elements;
    if !job.plan.stages.is_empty() {
        log.say(&format!(
            "  {} for {} of {} stages",
            duration(outcome.stage_seconds),
            outcome.stages.len(),
            job.plan.stages.len()
        ));
    }
    if outcome.shaken {
        log.say(&format!(
            "  {} for {} steps: {:.1} million element updates a second",
            duration(outcome.loop_seconds),
            outcome.taken_here,
            outcome.updates_per_second(elements) / 1e6
        ));
    }
    log.say(&summary.conclusion.verdict);
}

/// Three significant digits.
fn short(x: f64) -> String {
    if x != 0.0 && x.abs() < 1e-3 { format!("{x:.1e}") } else { format!("{x:.3}") }
}
