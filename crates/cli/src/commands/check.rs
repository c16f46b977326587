//! `tremolite check`: what will happen, before it happens.

mod bolts;
mod stages;
mod text;

use super::{load, modelled, pool};
use crate::exit::{Code, Failure, Outcome};
use crate::machine;
use crate::terminal::{print, tell};
use std::path::PathBuf;

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
    /// Print one JSON object, numbers in SI
    #[arg(long)]
    json: bool,
    /// Write where bolts will be into this folder, a file a group, as a case's `file` reads them
    #[arg(long, value_name = "DIR")]
    bolts: Option<PathBuf>,
    /// End with status 1 where there is a warning
    #[arg(long)]
    strict: bool,
}

pub fn run(args: &Args) -> Outcome {
    let isa = machine::isa(args.isa.as_deref())?;
    let loaded = load(&args.case, &args.set, isa)?;
    let pool = pool(args.threads)?;
    pool.install(|| {
        let job = modelled(loaded)?;
        if let Some(folder) = &args.bolts {
            bolts::write(folder, &job.model.bolts).map_err(Failure::failed)?;
        }
        tell(&job.remarks());
        let checked = job.check();
        if args.json {
            print(&serde_json::to_string_pretty(&checked).unwrap_or_default());
        } else {
            text::print_all(&checked);
        }
        let failed = args.strict && job.warnings().next().is_some();
        Ok(if failed { Code::Failed } else { Code::Done })
    })
}
