//! `tremolite check`: what will happen, before it happens.

mod bolts;
mod judged;
mod ranks;
mod stages;
mod text;

pub use ranks::more;

use super::room::{self, Free};
use super::{given, load, modelled, pool};
use crate::exit::{Code, Failure, Outcome};
use crate::machine;
use crate::terminal::{print, tell, warn};
use std::path::{Path, PathBuf};
use tremolite::job::oversized;
use tremolite::scaling::SharedOut;

/// What is said: the lines that decide on a run, or every line.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Lines {
    Deciding,
    All,
}

#[derive(clap::Args)]
pub struct Args {
    /// The case file
    case: PathBuf,
    /// Put another value at a key: material.rock.young="25 GPa", stage[*].release=0.5; as often as wanted
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Threads to estimate for (all by default)
    #[arg(long)]
    threads: Option<usize>,
    /// Force an instruction set: scalar, avx2 or avx512
    #[arg(long)]
    isa: Option<String>,
    /// Print every line: groups, what comes and goes, constants of the laws, keys that are left out
    #[arg(long, conflicts_with = "json")]
    verbose: bool,
    /// Check a model of any size: without it a model of implausibly many elements is not meshed
    #[arg(long)]
    ignore_resources: bool,
    /// Print one JSON object, numbers in SI
    #[arg(long)]
    json: bool,
    /// Write where bolts will be into this folder, a file a group, as a case's `file` reads them
    #[arg(long, value_name = "DIR")]
    bolts: Option<PathBuf>,
    /// Say how a run would be shared out to so many ranks, and about how long it would take
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..))]
    ranks: Option<u32>,
    /// End with status 1 where there is a warning
    #[arg(long)]
    strict: bool,
}

/// The end of a check that a slip of a unit has made long.
fn stopped(strict: bool) -> Code {
    print(
        "Nothing else is checked: a model of this size takes longer to look at than to mend. `check --ignore-resources` checks it all the same.",
    );
    if strict { Code::Failed } else { Code::Done }
}

pub fn run(args: &Args) -> Outcome {
    let isa = machine::isa(args.isa.as_deref())?;
    let free = Free::now(Path::new("results"));
    let any_size = args.ignore_resources || args.json || args.bolts.is_some() || args.ranks.is_some();
    let given = given(&args.set, isa)?;
    if !any_size && let Some(remark) = oversized(&args.case, &given) {
        tell(&[remark]);
        return Ok(stopped(args.strict));
    }
    let pool = pool(args.threads)?;
    let loaded = pool.install(|| load(&args.case, &given))?;
    if !any_size && loaded.is_oversized() {
        return Ok(stopped(args.strict));
    }
    if let Some(lacking) = free.lacks_for_mesh(loaded.setup.problem.mesh.elements.len()) {
        return Err(Failure::input(lacking));
    }
    pool.install(|| {
        let job = modelled(loaded)?;
        if let Some(folder) = &args.bolts {
            bolts::write(folder, &job.model.bolts).map_err(Failure::failed)?;
        }
        tell(&job.remarks());
        let checked = job.check();
        let shared = args.ranks.map(|ranks| SharedOut::of(&checked, ranks));
        if args.json {
            let mut said = serde_json::to_value(&checked).map_err(Failure::failed)?;
            if let Some(shared) = &shared {
                said["ranks"] = serde_json::to_value(shared).map_err(Failure::failed)?;
            }
            print(&serde_json::to_string_pretty(&said).unwrap_or_default());
        } else {
            let lines = if args.verbose { Lines::All } else { Lines::Deciding };
            text::print_lines(&checked, lines);
            shared.iter().for_each(ranks::print_lines);
        }
        let refused = free
            .lacks_for(&job)
            .into_iter()
            .map(|why| format!("`run` would refuse it without `--ignore-resources`: {why}"));
        let beyond: Vec<String> = refused.chain(room::long(checked.seconds(), &checked.set_by)).collect();
        warn(&beyond);
        let failed = args.strict && (job.warnings().next().is_some() || !beyond.is_empty());
        Ok(if failed { Code::Failed } else { Code::Done })
    })
}
