//! `tremolite run`: the main job.

use super::defaulted::{Known, defaulted};
use super::near::{check_near, mirrored};
use super::pieces::check_pieces;
use super::{check_bolts, check_length, check_pairs, check_step, check_waves, load, pool, refused};
use crate::exit::{Code, Failure, Outcome};
use crate::machine;
use crate::terminal::{ProgressLine, bytes, duration, say};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Instant;
use tremolite::evidence::Evidence;
use tremolite::near_sides::near_sides;
use tremolite::outlook::outlook;
use tremolite::run::{Control, Progress};
use tremolite::setup::changed;
use tremolite::simulation::{Ending, Simulation, Start, check_rest, choose_step};
use tremolite::summary::summary;
use tremolite::survey::{impacts_in_words, limit_in_words, survey};
use tremolite::{Assembly, Model, Phase, Stage, stable_step};
use tremolite_case::Problem;
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

/// The name of a case: its folder's if the file is called case.toml, else the file's.
fn case_name(path: &Path) -> String {
    let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let whole = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let folder = whole.parent().and_then(Path::file_name).map(|s| s.to_string_lossy().into_owned());
    if stem == "case" { folder.unwrap_or(stem) } else { stem }
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
    let (case, setup) = load(&args.case, &args.set, isa)?;
    pool.install(|| {
        let (motion, plan) = (setup.motion, setup.plan);
        if let (Some(from), true) = (&args.from, plan.stages.is_empty()) {
            return Err(Failure::input(format!(
                "--from {} has nothing to begin with: the case has no stages and no initial stress",
                from.display()
            )));
        }
        if args.from.is_some() && motion.is_none() {
            return Err(Failure::input("--from leaves nothing to do: the case has no [motion]"));
        }
        let model = Model::new(setup.problem).map_err(|e| refused(&case, &e))?;
        let assembly = Assembly::new(&model).map_err(|e| refused(&case, &e))?;
        let phase = Phase::of(&model, &assembly, Stage::Shaking).map_err(|e| refused(&case, &e))?;
        // Without an earthquake every wave is long.
        let highest = motion.as_ref().map_or(0.0, |motion| motion.highest_frequency);
        let survey = survey(&model, &assembly, highest).map_err(Failure::input)?;
        let stable = stable_step(&model, &assembly, &phase);
        let mut warnings = [case.warnings.clone(), setup.warnings.clone()].concat();
        if !plan.stages.is_empty() {
            let outlook = outlook(&model, &assembly, &plan).map_err(|e| refused(&case, &e))?;
            warnings.extend(check_pieces(&case, &outlook));
        }
        warnings.extend(check_step(&case, &stable));
        warnings.extend(check_waves(&case, &model, &survey));
        let near = near_sides(&model, mirrored(&case));
        warnings.extend(check_near(&case, &near));
        warnings.extend(check_pairs(&case, &model, &plan));
        warnings.extend(check_bolts(&case, &model, &plan));
        let sentence = |p: &Problem| format!("{}; {}", p.message, p.remedy);
        let mut said: Vec<String> = warnings.iter().map(sentence).collect();
        said.extend(changed(&args.case, &setup.inputs));
        let warned = !said.is_empty();
        let (dt, steps) = choose_step(&model, &plan, &stable);
        check_length(&model, &assembly, &stable, steps)?;

        let other = match &args.from {
            Some(from) => {
                let other = ResultFolder::open_existing(from).map_err(Failure::input)?;
                check_rest(&model, &assembly, &plan, dt, &other).map_err(Failure::input)?;
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
        let name = case_name(&args.case);
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
                limit_in_words(&model, &assembly, &stable)
            ));
            if let Some(impacts) = impacts_in_words(&model, &stable) {
                log.say(&format!("  {impacts}"));
            }
        }
        if let Some(motion) = &motion {
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
        let outcome = Simulation::new(&model, &assembly, &phase, &plan, &folder, start, Vec::new())
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
        let defaulted = defaulted(&Known {
            case: &case,
            model: &model,
            assembly: &assembly,
            plan: &plan,
            motion: motion.as_ref(),
            materials: &setup.materials,
            reference: setup.reference,
            base_without_springs: setup.base_without_springs.as_deref(),
            dt,
        });
        let summary = summary(Evidence {
            model: &model,
            assembly: &assembly,
            phase: &phase,
            plan: &plan,
            motion: motion.as_ref(),
            survey: &survey,
            near,
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
            inputs: setup.inputs.clone(),
            before: said,
            materials: setup.materials.clone(),
            defaulted,
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
