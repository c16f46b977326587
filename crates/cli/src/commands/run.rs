//! `tremolite run`: the main job.

use super::defaulted::{Known, defaulted};
use super::{check_length, check_pairs, check_step, check_waves, load, pool, refused};
use crate::exit::{Code, Failure, Outcome};
use crate::machine;
use crate::terminal::{ProgressLine, bytes, duration, say};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Instant;
use tremolite::evidence::Evidence;
use tremolite::run::{Control, Ending, Progress, choose_step};
use tremolite::setup::changed;
use tremolite::summary::summary;
use tremolite::survey::{impacts_in_words, limit_in_words, survey};
use tremolite::{Assembly, Model, Phase, Stage, stable_step};
use tremolite_case::Problem;
use tremolite_results::{ResultFolder, RunFacts, Summary, Table, replace_file};

#[derive(clap::Args)]
pub struct Args {
    /// The case file
    case: PathBuf,
    /// Where to put the results (results/<case name> by default)
    #[arg(long)]
    out: Option<PathBuf>,
    /// Threads to use (all by default); results do not depend on it
    #[arg(long)]
    threads: Option<usize>,
    /// Go on from the checkpoint of a run that was stopped
    #[arg(long)]
    resume: bool,
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
    let (case, setup) = load(&args.case, isa)?;
    let Some(motion) = setup.motion else {
        return Err(Failure::input("a case without [motion] cannot be run yet"));
    };
    if case.seeks_equilibrium() {
        return Err(Failure::input("a case with [[stage]] or initial stress cannot be run yet"));
    }
    pool.install(|| {
        let plan = setup.plan;
        let model = Model::new(setup.problem).map_err(|e| refused(&case, &e))?;
        let assembly = Assembly::new(&model).map_err(|e| refused(&case, &e))?;
        let phase = Phase::of(&model, &assembly, Stage::Shaking).map_err(Failure::input)?;
        let survey = survey(&model, &assembly, motion.highest_frequency).map_err(Failure::input)?;
        let stable = stable_step(&model, &assembly, &phase);
        let mut warnings = [case.warnings.clone(), setup.warnings.clone()].concat();
        warnings.extend(check_step(&case, &stable));
        warnings.extend(check_waves(&case, &model, &survey));
        warnings.extend(check_pairs(&case, &model, &plan));
        let sentence = |p: &Problem| format!("{}; {}", p.message, p.remedy);
        let mut said: Vec<String> = warnings.iter().map(sentence).collect();
        said.extend(changed(&args.case, &setup.inputs));
        let warned = !said.is_empty();
        let (dt, steps) = choose_step(&model, &plan, &stable);
        check_length(&model, &assembly, &stable, steps)?;

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
        log.say(&format!(
            "  {} elements, {} nodes, {} steps of {dt:.3e} s, {} threads, {}, about {}",
            survey.active_elements,
            survey.nodes,
            steps.total,
            rayon::current_num_threads(),
            isa.name(),
            bytes(survey.bytes)
        ));
        log.say(&format!(
            "  the stable step is {:.3e} s, set by {}",
            stable.dt,
            limit_in_words(&model, &assembly, &stable)
        ));
        if let Some(impacts) = impacts_in_words(&model, &stable) {
            log.say(&format!("  {impacts}"));
        }
        log.say(&format!(
            "  motion: kind = {}, so the incident wave is {} times the given motion",
            motion.kind, motion.factor
        ));

        let stop = Arc::new(AtomicBool::new(false));
        for signal in [signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM] {
            // Without the handler a signal ends the program at once; nothing worse.
            let _ = signal_hook::flag::register(signal, stop.clone());
        }
        let mut line = ProgressLine::new();
        let mut tell = |p: Progress| {
            let words =
                format!("{:.2} s of {:.2} s  {:.1} M/s", p.time, plan.duration, p.updates_per_second / 1e6);
            line.show(p.step as f64 / p.total as f64, &words);
        };
        let mut control = Control { stop: &stop, progress: &mut tell, observers: Vec::new() };
        let outcome = tremolite::run::run(&model, &assembly, &phase, &plan, &folder, args.resume, &mut control)
            .map_err(Failure::failed);
        line.end();
        let outcome = outcome?;

        let histories = Table::read(&folder.monitors()).map_err(Failure::failed)?;
        let energy = Table::read(&folder.energy()).map_err(Failure::failed)?;
        let (earlier, resumed) = before.map_or((0.0, 0), |s| (s.wall_seconds, s.run.resumed + 1));
        let defaulted = defaulted(&Known {
            case: &case,
            model: &model,
            assembly: &assembly,
            plan: &plan,
            motion: Some(&motion),
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
            motion: &motion,
            survey: &survey,
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
            if line.not_applicable {
                log.say(&format!("  --   {}: not applicable, {}", line.name, line.note));
                continue;
            }
            let mark = if line.pass { "ok  " } else { "LOOK" };
            log.say(&format!("  {mark} {}: {} (limit {})", line.name, short(line.value), line.limit));
        }
        let elements = phase.counted_elements;
        log.say(&format!(
            "  {} for {} steps: {:.1} million element updates a second",
            duration(outcome.loop_seconds),
            outcome.taken_here,
            outcome.updates_per_second(elements) / 1e6
        ));
        log.say(&summary.verdict);
        log.say(&format!("Results are in {}; open {}", folder.root().display(), page.display()));
        Ok(match outcome.ending {
            Ending::Done if args.strict && (warned || summary.warnings() > 0) => Code::Failed,
            Ending::Done => Code::Done,
            Ending::Failed { .. } => Code::Failed,
            Ending::Stopped => Code::Stopped,
        })
    })
}

/// Three significant digits.
fn short(x: f64) -> String {
    if x != 0.0 && x.abs() < 1e-3 { format!("{x:.1e}") } else { format!("{x:.3}") }
}
