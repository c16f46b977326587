//! `tremolite study`: runs beside one another that differ in keys, records and levels, and what they say together.

mod planned;
mod process;
mod queue;
mod slurm;
mod tables;

use crate::exit::{Code, Failure, Outcome};
use crate::machine;
use crate::signals::stop_flag;
use crate::terminal::{colour, print, say};
use planned::Planned;
use queue::Queue;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use tremolite_case::Report;
use tremolite_case::study::{SampleKind, StudyFile};
use tremolite_results::replace_file;
use tremolite_results::study::{RunStatus, Study};
use tremolite_study::plan::Plan;
use tremolite_study::results;

#[derive(clap::Args)]
pub struct Args {
    /// The study file
    study: PathBuf,
    /// Where the runs, the tables and the page go (results/<study name> by default)
    #[arg(long)]
    out: Option<PathBuf>,
    /// Print the runs as a table of comma-separated columns, and run none
    #[arg(long)]
    list: bool,
    /// Runs beside one another (one a core by default)
    #[arg(long, value_name = "N")]
    jobs: Option<usize>,
    /// Threads of each run (the cores shared out by default); results do not depend on it
    #[arg(long, value_name = "N")]
    threads: Option<usize>,
    /// Run only what has this name or word in its name, and what it is set beside
    #[arg(long, value_name = "NAME")]
    only: Option<String>,
    /// Run only share K of N, here or on any other machine
    #[arg(long, value_name = "K/N")]
    shard: Option<String>,
    /// Run again what ended so
    #[arg(long, value_name = "STATUS")]
    retry: Option<Retry>,
    /// Put the tables and the page together of what is there, and run nothing
    #[arg(long)]
    gather: bool,
    /// Write a script of array tasks for Slurm into this folder, and run nothing
    #[arg(long, value_name = "FOLDER")]
    slurm: Option<PathBuf>,
    /// Array tasks of --slurm, each with several runs (100 at most by default)
    #[arg(long, value_name = "N", requires = "slurm")]
    tasks: Option<usize>,
}

/// Which runs are run again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Retry {
    /// Stopped by the guard in their earthquake
    Failed,
    /// Not at rest before their earthquake
    NotConverged,
    /// Refused by the program, or ended from outside
    Error,
    /// All of these
    All,
}

impl Retry {
    fn means(self, status: RunStatus) -> bool {
        match status {
            RunStatus::Failed => matches!(self, Retry::Failed | Retry::All),
            RunStatus::NotConverged => matches!(self, Retry::NotConverged | Retry::All),
            RunStatus::Error => matches!(self, Retry::Error | Retry::All),
            _ => false,
        }
    }
}

/// A study that is checked whole.
struct Read {
    study: StudyFile,
    plan: Plan,
    planned: Vec<Planned>,
    /// What is to be warned of, if anything.
    warnings: Option<Report>,
}

/// Plans a study and checks the case of every run; its language is then known.
fn read(mut study: StudyFile) -> Result<Read, Report> {
    let table = table(&study)?;
    let plan = Plan::of(&study, table.as_deref()).map_err(|problems| study.report(problems))?;
    let planned::Found { planned, language, warnings } = planned::of(&study, &plan)?;
    study.language.get_or_insert(language);
    let warnings = (!warnings.is_empty()).then(|| study.report(warnings).as_warnings());
    Ok(Read { study, plan, planned, warnings })
}

/// The plan of a study as `--list` prints it, of its text; `path` is where it stands or will stand, from which it names files.
///
/// # Errors
/// Everything that study or the case of a run is refused for, at its place in the study or the case.
pub fn plan(path: &Path, text: &str) -> Result<String, Report> {
    let Read { study, plan, planned, .. } = read(StudyFile::parse(path, text)?)?;
    let all: Vec<usize> = (0..plan.runs.len()).collect();
    Ok(tables::plan(&study, &plan, &planned, &all))
}

pub fn run(args: &Args) -> Outcome {
    let study = StudyFile::read(&args.study).map_err(|report| Failure::case(&report))?;
    let Read { study, plan, planned, warnings } = read(study).map_err(|report| Failure::case(&report))?;
    warnings.iter().for_each(|warnings| say(&warnings.render(colour())));
    let shard = args.shard.as_deref().map(shard).transpose()?;
    let mut chosen = match shard {
        Some((k, of)) => plan.shard(k - 1, of),
        None => (0..plan.runs.len()).collect(),
    };
    if let Some(word) = &args.only {
        let only = only(&plan, word)?;
        chosen.retain(|run| only.contains(run));
    }
    if args.list {
        print(tables::plan(&study, &plan, &planned, &chosen).trim_end());
        return Ok(Code::Done);
    }
    let out = out(args);
    if let Some(folder) = &args.slurm {
        return slurm::write(folder, args, &out, &study, &plan);
    }
    std::fs::create_dir_all(&out).map_err(|e| Failure::failed(format!("{}: {e}", out.display())))?;
    replace_file(&out.join("study.toml"), study.source.as_bytes()).map_err(Failure::failed)?;
    let all: Vec<usize> = (0..plan.runs.len()).collect();
    replace_file(&out.join("plan.csv"), tables::plan(&study, &plan, &planned, &all).as_bytes())
        .map_err(Failure::failed)?;
    let mut stopped = false;
    if !args.gather {
        // Without a handler a signal ends this program and leaves its runs; the next start waits for them.
        let stop = stop_flag();
        let cores = machine::threads();
        let wish = |n: Option<u32>| n.map(|n| n as usize);
        let at_once = args.jobs.or(wish(study.run.at_once)).unwrap_or(cores).clamp(1, chosen.len().max(1));
        let threads = args.threads.or(wish(study.run.threads)).unwrap_or((cores / at_once).max(1));
        if !(1..=4096).contains(&threads) || args.jobs == Some(0) {
            return Err(Failure::input("--threads and --jobs are between 1 and 4096"));
        }
        if let Some(retry) = args.retry {
            queue::retry(&plan, &planned, &out, &chosen, |status| retry.means(status))?;
        }
        let queue = Queue::new(&study, &plan, &planned, &out, chosen.clone(), threads, stop)?;
        say(&format!(
            "{}: {} runs, {} of them here, {at_once} at once on {threads} threads; results go to {}",
            study.title.value,
            plan.runs.len(),
            chosen.len(),
            out.display()
        ));
        stopped = queue.work(at_once)?;
    } else {
        let stop = Arc::new(AtomicBool::new(false));
        Queue::new(&study, &plan, &planned, &out, Vec::new(), 1, stop)?.tidy_all()?;
    }
    let (found, missing) = tables::write_with_limits(&study, &plan, &planned, &out)?;
    if let Some(first) = missing.first() {
        return Err(lacks(&study, first));
    }
    let page = tremolite_report::study(&out, None).map_err(Failure::failed)?;
    told(&found, &chosen);
    say(&format!(
        "{} and {}; open {}",
        out.join("study.csv").display(),
        out.join("study.json").display(),
        page.display()
    ));
    let ended_well = |run: &usize| {
        matches!(found.runs[*run].status, RunStatus::Done | RunStatus::Failed | RunStatus::NotNeeded)
    };
    Ok(match chosen.iter().all(ended_well) {
        _ if stopped => Code::Stopped,
        true => Code::Done,
        false => Code::Failed,
    })
}

/// That results lack what the study asks for.
fn lacks(study: &StudyFile, missing: &results::Missing) -> Failure {
    let results::Missing { measure, run, why } = missing;
    let at = study.measures.iter().find(|m| m.name.value == *measure).map_or(0..0, |m| m.name.span.clone());
    let problem = tremolite_case::Diagnostic::new(
        at,
        format!("the results of {run} have no `{measure}`: {why}"),
        "mend it, or say otherwise = 0 where that is meant, and start the study again: what is done stays",
    );
    Failure::case(&study.report(vec![problem]))
}

/// Where all goes.
fn out(args: &Args) -> PathBuf {
    let name = args.study.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    args.out.clone().unwrap_or_else(|| Path::new("results").join(name))
}

/// The text of the table that samples stand in.
fn table(study: &StudyFile) -> Result<Option<String>, Report> {
    let Some(sample) = study.sample.as_ref().filter(|s| s.kind.value == SampleKind::Table) else {
        return Ok(None);
    };
    let Some(file) = &sample.file else { return Ok(None) };
    let path = study.directory().join(&file.value);
    std::fs::read_to_string(&path).map(Some).map_err(|e| {
        let remedy = format!("paths start from the folder of the study; looked for {}", path.display());
        let problem = tremolite_case::Diagnostic::at(file, format!("{}: {e}", file.value.display()), remedy);
        study.report(vec![problem])
    })
}

/// A share: its number from 1, and how many there are.
fn shard(text: &str) -> Result<(usize, usize), Failure> {
    let numbers = text.split_once('/').and_then(|(k, of)| Some((k.parse().ok()?, of.parse().ok()?)));
    match numbers {
        Some((k, of)) if (1..=of).contains(&k) => Ok((k, of)),
        _ => Err(Failure::input(format!("--shard {text}: write K/N, such as 3/8, with K from 1 to N"))),
    }
}

/// The runs of a name, or else those with a word in name or title; with what they are set beside.
fn only(plan: &Plan, word: &str) -> Result<Vec<usize>, Failure> {
    let lower = word.to_lowercase();
    let title = |run: usize| plan.samples[plan.runs[run].sample].title.to_lowercase();
    let all = 0..plan.runs.len();
    let exact: Vec<usize> = all.clone().filter(|run| plan.runs[*run].name == lower).collect();
    let within = || {
        let has = |run: &usize| plan.runs[*run].name.contains(&lower) || title(*run).contains(&lower);
        all.clone().filter(has).collect::<Vec<usize>>()
    };
    let found = if exact.is_empty() { within() } else { exact };
    if found.is_empty() {
        return Err(Failure::input(format!("--only {word}: no run has this in its name; --list names them")));
    }
    let beside = |run: &usize| {
        let run = &plan.runs[*run];
        let sample = plan.samples[run.sample].beside?;
        plan.runs.iter().position(|r| r.sample == sample && r.record == run.record && r.level == run.level)
    };
    // Levels below one are needed to know whether it is.
    let below = |run: &usize| {
        let run = &plan.runs[*run];
        let rises = plan.rises;
        all.clone()
            .filter(move |r| rises && plan.runs[*r].chain == run.chain && plan.runs[*r].level < run.level)
    };
    let mut with: Vec<usize> = found.iter().filter_map(beside).chain(found.iter().flat_map(below)).collect();
    with.extend(found);
    with.sort_unstable();
    with.dedup();
    Ok(with)
}

/// How the runs ended, in words.
fn told(found: &Study, chosen: &[usize]) {
    let count = |status: RunStatus| chosen.iter().filter(|run| found.runs[**run].status == status).count();
    use RunStatus::{Done, Error, Failed, NotConverged, NotNeeded, Pending};
    let words = [
        (Done, "at their end"),
        (Failed, "stopped by the guard in the earthquake"),
        (NotConverged, "not at rest before it"),
        (Error, "refused or ended from outside"),
        (NotNeeded, "not needed"),
        (Pending, "still to run"),
    ];
    let parts: Vec<String> = words
        .iter()
        .filter(|(status, _)| count(*status) > 0)
        .map(|(status, words)| format!("{} {words}", count(*status)))
        .collect();
    say(&format!("of {} runs {}", chosen.len(), parts.join(", ")));
    let ended = chosen
        .iter()
        .map(|run| &found.runs[*run])
        .filter(|run| matches!(run.status, Failed | NotConverged | Error) || !run.why.is_empty());
    for run in ended.take(20) {
        let first: String = run.why.lines().next().unwrap_or_default().chars().take(160).collect();
        say(&format!("  {} {}: {first}", run.name, run.status.word()));
    }
    if count(Error) > 0 {
        say("  --retry error runs those again that were refused or ended from outside");
    }
    for fragility in &found.fragilities {
        let name = format!("{} above {} by {}", fragility.measure, fragility.above, fragility.by);
        match &fragility.fit {
            Some(fit) => {
                say(&format!("{name}: median {:.4} {}, beta {:.3}", fit.theta, fragility.unit, fit.beta))
            }
            None => say(&format!("{name}: no curve, {}", fragility.no_curve)),
        }
    }
}

/// What a run left is to be looked for by the study's own words.
fn gathered(
    study: &StudyFile,
    plan: &Plan,
    planned: &[Planned],
    out: &Path,
) -> (Study, Vec<results::Missing>) {
    let prepared: Vec<results::Prepared> = planned.iter().map(|p| p.prepared.clone()).collect();
    results::gather(study, plan, &prepared, out)
}
