//! `tremolite run`: the main job.

mod messages;

use super::room::Free;
use super::{given, load, modelled, pool};
use crate::exit::{Code, Failure, Outcome};
use crate::machine;
use crate::ranks::{self, Started};
use crate::signals::stop_flag;
use crate::terminal::{ProgressLine, say, tell};
use messages::{Log, after, before, busy, check, progress, shared_out};
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::time::Instant;
use tremolite::RunError;
use tremolite::job::{Begun, Caller, Job};
use tremolite::run::{Control, Progress};
use tremolite::simulation::{Ending, Simulation, Start};
use tremolite_results::{Error, ResultFolder, Status, Summary};

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
    /// Go on from the checkpoint of a run that was stopped; begin where there is none, and do nothing where the run is complete
    #[arg(long)]
    resume: bool,
    /// Begin with what the run in this folder had come to before its earthquake: same mesh, materials and stages
    #[arg(long, value_name = "DIR", conflicts_with = "resume")]
    start_from: Option<PathBuf>,
    /// Replace the results that --out holds
    #[arg(long, conflicts_with = "resume")]
    overwrite: bool,
    /// Force an instruction set: scalar, avx2 or avx512
    #[arg(long)]
    isa: Option<String>,
    /// Run though this machine has hardly the memory or the disk for it
    #[arg(long)]
    ignore_resources: bool,
    /// End with status 1 where a check of the run fails or the case is warned of, before the earthquake where a check of the stages fails;
    /// results are kept
    #[arg(long)]
    strict: bool,
}

pub fn run(args: &Args) -> Outcome {
    let since = Instant::now();
    let started = ranks::started()?;
    let threads = args.threads.or_else(|| started.as_ref().map(Started::threads));
    let pool = pool(threads)?;
    // The pool's threads end before MPI does.
    pool.install(|| match &started {
        None => go(args, since, asked(args)?, None),
        Some(started) => {
            let asked = started.together(asked(args))?;
            started.same_case(&asked.job.case.source, args.start_from.is_some())?;
            go(args, since, asked, Some(started))
        }
    })
}

/// A case that can be run, and what it is to begin with.
struct Asked {
    job: Job,
    other: Option<ResultFolder>,
}

/// What is asked for, before anything is written.
fn asked(args: &Args) -> Result<Asked, Failure> {
    let isa = machine::isa(args.isa.as_deref())?;
    let free = Free::now(args.out.as_deref().unwrap_or(Path::new("results")));
    let loaded = load(&args.case, &given(&args.set, isa)?)?;
    let room = |lacking: &[String]| match lacking {
        [] => Ok(()),
        _ if args.ignore_resources => Ok(()),
        all => Err(Failure::input(format!("{}; `--ignore-resources` runs it all the same", all.join("\n")))),
    };
    room(&free.lacks_for_mesh(loaded.setup.problem.mesh.elements.len()).into_iter().collect::<Vec<_>>())?;
    if let Some(from) = &args.start_from {
        loaded.check_from().map_err(|why| no_rest(from, &why))?;
    }
    let job = modelled(loaded)?;
    tell(&job.remarks());
    // Who goes on has found room before, and what is replaced gives its own back.
    if !args.resume && !args.overwrite {
        room(&free.lacks_for(&job))?;
    }
    let other = args.start_from.as_deref().map(|from| rest(args, &job, from)).transpose()?;
    Ok(Asked { job, other })
}

/// A run in its folder, which keeps the case.
struct Own {
    folder: ResultFolder,
    begun: Begun,
    /// Whether it goes on from a checkpoint.
    resumed: bool,
}

/// Begins a run, or goes on with it; none if it is complete.
fn begin(args: &Args, job: &Job, other: Option<&ResultFolder>) -> Result<Option<Own>, Failure> {
    let name = job.name();
    let create = |out: Option<&Path>, overwrite: bool| {
        ResultFolder::create(out, &name, overwrite).map_err(Failure::input)
    };
    let (folder, resumed) = if args.resume {
        match ResultFolder::resume(args.out.as_deref(), &name) {
            Ok(folder) if is_done(folder.root()) => return complete(job, folder.root()),
            Ok(folder) => (folder, true),
            // A job that is put in the queue again is the same command: what has not begun begins.
            Err(Error::NoResults { path, .. }) if ResultFolder::was_cut_short(&path) => {
                job.check_kept(&path).map_err(other_case)?;
                (create(Some(&path), true)?, false)
            }
            Err(Error::NoResults { path, .. }) if is_done(&path) => return complete(job, &path),
            Err(Error::NoResults { path, .. }) if !path.join("summary.json").exists() => {
                (create(args.out.as_deref(), false)?, false)
            }
            Err(why) => return Err(Failure::input(why)),
        }
    } else {
        (create(args.out.as_deref(), args.overwrite)?, false)
    };
    let begun = job.begin(&folder, start(resumed, other)).map_err(other_case)?;
    Ok(Some(Own { folder, begun, resumed }))
}

/// What a run begins with.
fn start(resumed: bool, other: Option<&ResultFolder>) -> Start<'_> {
    match (resumed, other) {
        (true, _) => Start::Resume,
        (false, Some(other)) => Start::From(other),
        (false, None) => Start::Rest,
    }
}

fn other_case(why: RunError) -> Failure {
    match why {
        RunError::OtherCase { .. } => {
            Failure::input(format!("{why}; resume with that one, or start again without --resume"))
        }
        why => Failure::failed(why),
    }
}

/// What a run was to begin with is not what it takes; nothing was computed yet.
fn refused(why: RunError) -> Failure {
    match why {
        RunError::Checkpoint(_) | RunError::Results(_) => Failure::input(why),
        why => Failure::failed(why),
    }
}

/// Nothing is left to do of the same case, but for the page of a run that was killed before it had one.
fn complete(job: &Job, root: &Path) -> Result<Option<Own>, Failure> {
    job.check_kept(root).map_err(other_case)?;
    say(&format!("{}: this run is complete: there is nothing to go on with", root.display()));
    if !root.join("report.html").exists() {
        tremolite_report::write(root).map_err(Failure::failed)?;
    }
    Ok(None)
}

/// Whether a run ended as it should.
fn is_done(root: &Path) -> bool {
    Summary::read(&root.join("summary.json")).is_ok_and(|summary| summary.conclusion.status == Status::Done)
}

/// Runs what is asked for, alone or with other ranks.
fn go(args: &Args, since: Instant, Asked { mut job, other }: Asked, started: Option<&Started>) -> Outcome {
    let warned = !job.said().is_empty();
    let first = started.is_none_or(Started::is_first);
    let own = if first { Some(begin(args, &job, other.as_ref())) } else { None };
    let own = match (own, started) {
        (Some(own), None) => own?,
        (Some(own), Some(started)) => {
            let own = started.together(own)?;
            started.told_by_first(&told(own.as_ref()));
            started.together(Ok(own))?
        }
        (None, Some(started)) => {
            started.together(Ok(()))?;
            let told = started.told_by_first("");
            started.together(joined(&job, &told, other.as_ref()))?
        }
        (None, None) => return Err(Failure::failed("no rank is the first")),
    };
    let Some(Own { folder, begun, .. }) = own else { return Ok(Code::Done) };
    let mut log = if first { Log::open(&folder) } else { Log::none() };
    let caller = Caller {
        program: format!("tremolite {}", env!("CARGO_PKG_VERSION")),
        command: std::env::args().collect::<Vec<_>>().join(" "),
        started: jiff::Timestamp::now().to_string(),
        since,
    };
    log.keep(&format!("{}: {}", caller.program, caller.command));
    before(&mut log, &job);
    let ranks = started.map(|started| started.at_work(&job.model, &job.assembly));
    if let Some((ranks, started)) = ranks.as_ref().zip(started) {
        job.share(ranks);
        let bound = started.bound();
        log.say(&shared_out(&ranks.division));
        bound.iter().for_each(|bound| log.say(&format!("warning: {bound}")));
    }

    let stop = stop_flag();
    let mut line = ProgressLine::new();
    let mut in_stages = !job.plan.stages.is_empty();
    let mut tell = |p: Progress| {
        // The earthquake counts from its own beginning.
        if p.stage.is_none() && std::mem::take(&mut in_stages) {
            line = ProgressLine::new();
        }
        line.show(p.share, &progress(&job.plan, &p));
    };
    let mut control = Control { stop: &stop, progress: &mut tell };
    let simulation = begun.simulation_among(&job, Vec::new(), ranks.clone());
    if let Some(why) =
        simulation.as_ref().ok().and_then(|simulation| simulation.fallen_back()).filter(|_| first)
    {
        log.say(&format!("warning: {why}"));
    }
    let simulation = simulation.map_err(|why| {
        log.keep(&format!("error: {why}"));
        refused(why)
    })?;
    let (mut told, mut failing) = (Vec::new(), false);
    let mut at_rest = |simulation: &Simulation, _: usize| {
        let looks =
            simulation.checks_of_stages().into_iter().filter(|line| !line.not_applicable && !line.pass);
        for look in looks.filter(|look| !told.contains(&look.id)).collect::<Vec<_>>() {
            log.say(&check(&look));
            told.push(look.id);
            failing = true;
        }
        if args.strict && failing && job.motion.is_some() {
            stop.store(true, Ordering::Relaxed);
        }
    };
    let outcome = tremolite::run::run_checking(simulation, &mut control, &mut at_rest);
    let ended_by_checks = args.strict && failing && matches!(&outcome, Ok(outcome) if !outcome.shaken);
    line.end();
    let outcome = outcome.map_err(Failure::failed)?;
    let busy = ranks.map(|ranks| busy(&ranks, outcome.held));
    if first {
        let summary = begun.end(&job, &outcome, &caller).map_err(Failure::failed)?;
        let (page, answer) = tremolite_report::write_answering(folder.root()).map_err(Failure::failed)?;
        after(&mut log, &job, &outcome, &summary);
        answer.iter().for_each(|line| log.say(line));
        busy.iter().flatten().for_each(|busy| log.say(busy));
        log.say(&format!("Results are in {}; open {}", folder.root().display(), page.display()));
        if args.strict && matches!(outcome.ending, Ending::Done) && (warned || summary.warnings() > 0) {
            return Ok(Code::Failed);
        }
    }
    if ended_by_checks && matches!(outcome.ending, Ending::Stopped) {
        log.say("--strict: a check of the stages fails, so the earthquake was not run. --resume without it goes on.");
        return Ok(Code::Failed);
    }
    Ok(match outcome.ending {
        Ending::Done => Code::Done,
        Ending::Failed { .. }
        | Ending::Astray { .. }
        | Ending::Restless { .. }
        | Ending::SnappedBack { .. } => Code::Failed,
        Ending::Stopped => Code::Stopped,
    })
}

/// What the first rank tells the others of its run.
fn told(own: Option<&Own>) -> String {
    own.map_or(String::new(), |Own { folder, resumed, .. }| {
        format!("{}{}", if *resumed { GOES_ON } else { BEGINS }, folder.root().display())
    })
}

const GOES_ON: char = '+';
const BEGINS: char = '-';

/// The run that the first rank has begun.
fn joined(job: &Job, told: &str, other: Option<&ResultFolder>) -> Result<Option<Own>, Failure> {
    let Some(root) = told.strip_prefix([GOES_ON, BEGINS]) else { return Ok(None) };
    let resumed = told.starts_with(GOES_ON);
    let folder = ResultFolder::open_existing(Path::new(root)).map_err(|_| {
        Failure::input(format!(
            "the folder {root} that the first rank writes its results to is not here; put it where all machines see it under the same path, with --out"
        ))
    })?;
    let begun = job.join(&folder, start(resumed, other));
    Ok(Some(Own { folder, begun, resumed }))
}

/// Why a case cannot begin with the rest of the run in `from`.
fn no_rest(from: &Path, why: &RunError) -> Failure {
    match why {
        RunError::NoRest => Failure::input(format!(
            "--start-from {} has nothing to begin with: the case has no stages and no initial stress",
            from.display()
        )),
        RunError::RestAlone => Failure::input("--start-from leaves nothing to do: the case has no [motion]"),
        why => Failure::input(why),
    }
}

/// The run in `from`, whose rest the job can begin with, and which stays.
fn rest(args: &Args, job: &Job, from: &Path) -> Result<ResultFolder, Failure> {
    let other = ResultFolder::open_existing(from).map_err(Failure::input)?;
    job.check_start(Start::From(&other)).map_err(|why| no_rest(from, &why))?;
    let whole = |path: &Path| path.canonicalize().ok();
    if args.out.as_deref().is_some_and(|out| whole(out).is_some_and(|out| Some(out) == whole(from))) {
        return Err(Failure::input(format!(
            "--start-from {} is where the results would go; give another --out",
            from.display()
        )));
    }
    Ok(other)
}
