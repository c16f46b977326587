//! `tremolite run`: the main job.

use super::{load, modelled, pool};
use crate::exit::{Code, Failure, Outcome};
use crate::machine;
use crate::terminal::{ProgressLine, bytes, duration, say, tell};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Instant;
use tremolite::evidence::Evidence;
use tremolite::job::Job;
use tremolite::run::{Control, Progress};
use tremolite::simulation::{Ending, Simulation, Start, check_rest};
use tremolite::summary::summary;
use tremolite::survey::{impacts_in_words, limit_in_words};
use tremolite_results::{ResultFolder, RunFacts, Summary, Table, replace_file};

#[derive(clap::Args)]
pub struct Args {
    /// The case file
    case: PathBuf,
    /// Put another value at a key: material.rock.young="25 GPa", stage[*].release=0.5; as often as wanted
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Where to put the results (results/<case name> by default)
    #[arg(long)]
    out: Option<PathBuf>,
    /// Threads to use (all by default); results do not depend on it
    #[arg(long)]
    threads: Option<usize>,
    /// Go on from the checkpoint of a run that was stopped
    #[arg(long)]
    resume: bool,
    /// Begin with what the run in this folder had come to before its earthquake: same mesh, materials and stages
    #[arg(long, value_name = "DIR", conflicts_with = "resume")]
    from: Option<PathBuf>,
    /// Replace the results that --out holds
    #[arg(long, conflicts_with = "resume")]
    overwrite: bool,
    /// Force an instruction set: scalar, avx2 or avx512
    #[arg(long)]
    isa: Option<String>,
    /// End with status 1 where a check of the run fails or the case is warned of; results are kept
    #[arg(long)]
    strict: bool,
}

/// Messages to the terminal and to log.txt.
struct Log {
    file: Option<std::fs::File>,
}

impl Log {
    fn open(folder: &ResultFolder) -> Log {
        Log { file: std::fs::OpenOptions::new().create(true).append(true).open(folder.log()).ok() }
    }

    fn keep(&mut self, message: &str) {
        // The results matter more than their log: a full disk is reported by them.
        if let Some(file) = &mut self.file {
            let _ = writeln!(file, "{} {message}", jiff::Timestamp::now());
        }
    }

    fn say(&mut self, message: &str) {
        say(message);
        self.keep(message.trim());
    }
}

pub fn run(args: &Args) -> Outcome {
    let begin = Instant::now();
    let isa = machine::isa(args.isa.as_deref())?;
    let pool = pool(args.threads)?;
    let loaded = load(&args.case, &args.set, isa)?;
    pool.install(|| {
        if let (Some(from), true) = (&args.from, loaded.setup.plan.stages.is_empty()) {
            return Err(Failure::input(format!(
                "--from {} has nothing to begin with: the case has no stages and no initial stress",
                from.display()
            )));
        }
        if args.from.is_some() && loaded.setup.motion.is_none() {
            return Err(Failure::input("--from leaves nothing to do: the case has no [motion]"));
        }
        let job = modelled(loaded)?;
        tell(&job.remarks());
        let said = job.said();
        let warned = !said.is_empty();
        let Job { case, model, assembly, phase, plan, motion, survey, stable, dt, steps, .. } = &job;
        let dt = *dt;

        let other = match &args.from {
            Some(from) => {
                let other = ResultFolder::open_existing(from).map_err(Failure::input)?;
                check_rest(model, assembly, plan, dt, &other).map_err(Failure::input)?;
                let whole = |path: &Path| path.canonicalize().ok();
                if args.out.as_deref().is_some_and(|out| whole(out).is_some_and(|out| Some(out) == whole(from))) {
                    return Err(Failure::input(format!(
                        "--from {} is where the results would go; give another --out",
                        from.display()
                    )));
                }
                Some(other)
            }
            None => None,
        };
        let name = job.name();
        let folder = if args.resume {
            ResultFolder::resume(args.out.as_deref(), &name)
        } else {
            ResultFolder::create(args.out.as_deref(), &name, args.overwrite)
        }
        .map_err(Failure::input)?;
        let before = if args.resume { Summary::read(&folder.summary()).ok() } else { None };
        if args.resume && std::fs::read(folder.case()).is_ok_and(|earlier| earlier != case.source.as_bytes()) {
            return Err(Failure::input(format!(
                "{} differs from {}, from which the run was started; resume with that one, or start again without --resume",
                args.case.display(),
                folder.case().display()
            )));
        }
        replace_file(&folder.case(), case.source.as_bytes()).map_err(Failure::failed)?;
        let mut log = Log::open(&folder);
        let command: Vec<String> = std::env::args().collect();
        let started = jiff::Timestamp::now().to_string();
        log.keep(&format!("tremolite {}: {}", env!("CARGO_PKG_VERSION"), command.join(" ")));

        log.say(&plan.title);
        let shaken = motion.is_some();
        let steps_in_words = if shaken { format!("{} steps of {dt:.3e} s, ", steps.total) } else { String::new() };
        log.say(&format!(
            "  {} elements, {} nodes, {steps_in_words}{} threads, {}, about {}",
            survey.active_elements,
            survey.nodes,
            rayon::current_num_threads(),
            isa.name(),
            bytes(survey.bytes)
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

        let stop = Arc::new(AtomicBool::new(false));
        for signal in [signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM] {
            // Without the handler a signal ends the program at once; nothing worse.
            let _ = signal_hook::flag::register(signal, stop.clone());
        }
        let mut line = ProgressLine::new();
        let mut in_stages = !plan.stages.is_empty();
        let mut tell = |p: Progress| {
            let words = match p.stage {
                Some(stage) => {
                    let name = &plan.stages[stage].name;
                    format!("{name}: cycle {}, {:.1e} out of balance", p.cycle, p.ratio)
                }
                None => {
                    if std::mem::take(&mut in_stages) {
                        line = ProgressLine::new();
                    }
                    format!("{:.2} s of {:.2} s  {:.1} M/s", p.time, plan.duration, p.updates_per_second / 1e6)
                }
            };
            line.show(p.share, &words);
        };
        let mut control = Control { stop: &stop, progress: &mut tell };
        let start = match &other {
            Some(other) => Start::From(other),
            None if args.resume => Start::Resume,
            None => Start::Rest,
        };
        let outcome = Simulation::new(model, assembly, phase, plan, &folder, start, Vec::new())
            .and_then(|simulation| tremolite::run::run(simulation, &mut control))
            .map_err(Failure::failed);
        line.end();
        let outcome = outcome?;

        // Before the earthquake there are none.
        let table = |path: &Path| match outcome.shaken {
            true => Table::read(path).map_err(Failure::failed),
            false => Ok(Table::default()),
        };
        let (histories, energy) = (table(&folder.monitors())?, table(&folder.energy())?);
        let (earlier, resumed) = before.map_or((0.0, 0), |s| (s.wall_seconds, s.run.resumed + 1));
        let summary = summary(Evidence {
            model,
            assembly,
            phase,
            plan,
            motion: motion.as_ref(),
            survey,
            near: job.near.clone(),
            outcome: &outcome,
            histories: &histories,
            energy: &energy,
            run: RunFacts {
                program: format!("tremolite {}", env!("CARGO_PKG_VERSION")),
                command: command.join(" "),
                started,
                threads: rayon::current_num_threads() as u64,
                instruction_set: isa.name().into(),
                resumed,
            },
            inputs: job.inputs.clone(),
            before: said,
            materials: job.materials.clone(),
            defaulted: job.defaulted(),
            wall_seconds: begin.elapsed().as_secs_f64() + if earlier.is_finite() { earlier } else { 0.0 },
        });
        summary.write(&folder.summary()).map_err(Failure::failed)?;
        let page = tremolite_report::write(folder.root()).map_err(Failure::failed)?;

        for line in &summary.trust {
            // Each with its reason, where it does not bury the others.
            if line.not_applicable {
                log.keep(&format!("--   {}: not applicable, {}", line.name, line.note));
                continue;
            }
            let mark = if line.pass { "ok  " } else { "LOOK" };
            // What cannot be told says why.
            let found = match line.value.is_nan() {
                true => line.note.clone(),
                false => format!("{} (limit {})", short(line.value), line.limit),
            };
            log.say(&format!("  {mark} {}: {found}", line.name));
        }
        let idle = summary.trust.iter().filter(|line| line.not_applicable).count();
        if idle > 0 {
            log.say(&format!("  --   {idle} more checks do not apply; log.txt and the page say why"));
        }
        let elements = phase.counted_elements;
        if !plan.stages.is_empty() {
            log.say(&format!(
                "  {} for {} of {} stages",
                duration(outcome.stage_seconds),
                outcome.stages.len(),
                plan.stages.len()
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
        log.say(&summary.verdict);
        log.say(&format!("Results are in {}; open {}", folder.root().display(), page.display()));
        Ok(match outcome.ending {
            Ending::Done if args.strict && (warned || summary.warnings() > 0) => Code::Failed,
            Ending::Done => Code::Done,
            Ending::Failed { .. } | Ending::Restless { .. } | Ending::SnappedBack { .. } => Code::Failed,
            Ending::Stopped => Code::Stopped,
        })
    })
}

/// Three significant digits.
fn short(x: f64) -> String {
    if x != 0.0 && x.abs() < 1e-3 { format!("{x:.1e}") } else { format!("{x:.3}") }
}
