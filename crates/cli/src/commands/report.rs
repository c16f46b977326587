//! `tremolite report`: the page again, from the result files; or runs beside one another.

use crate::exit::{Code, Failure, Outcome};
use crate::terminal::{print, warn};
use std::path::PathBuf;
use tremolite_case::Limits;
use tremolite_report::Language;

#[derive(clap::Args)]
pub struct Args {
    /// The result folder, or that of a study
    #[arg(required_unless_present = "compare", conflicts_with = "compare")]
    folder: Option<PathBuf>,
    /// Two or more result folders to set beside one another, the first being that which the others are compared with
    #[arg(long, num_args = 2.., value_name = "DIR")]
    compare: Vec<PathBuf>,
    /// Where the comparison is written
    #[arg(long, value_name = "FILE", default_value = "comparison.html", requires = "compare")]
    out: PathBuf,
    /// Limits of acceptance in place of those of the case: a file with the keys of [report.limits]
    #[arg(long, value_name = "FILE", conflicts_with = "compare")]
    limits: Option<PathBuf>,
    /// The page's language, en or zh; left out, that of the (first) case
    #[arg(long, value_name = "CODE")]
    language: Option<Language>,
}

pub fn run(args: &Args) -> Outcome {
    if let Some(folder) = args.folder.as_ref().filter(|folder| folder.join("study.json").is_file()) {
        if args.limits.is_some() {
            return Err(Failure::input("--limits: a study has none; give them to the folder of a run"));
        }
        let page = tremolite_report::study(folder, args.language).map_err(Failure::failed)?;
        print(&page.display().to_string());
        return Ok(Code::Done);
    }
    for folder in args.folder.iter().chain(&args.compare) {
        let folder = tremolite_results::ResultFolder::open_existing(folder).map_err(Failure::input)?;
        let damaged = folder.damaged().map_err(Failure::input)?;
        let remedy = |file: &String| format!("{file}; restore it from a copy, or run the case again");
        warn(&damaged.iter().map(remedy).collect::<Vec<_>>());
    }
    let limits = match &args.limits {
        Some(file) => Some(Limits::from_file(file).map_err(Failure::input)?),
        None => None,
    };
    let page = match (&args.folder, args.language) {
        (Some(folder), language) if limits.is_some() => {
            let limits = limits.iter().flat_map(tremolite::setup::limits);
            tremolite_report::write_held(folder, language, limits)
        }
        (None, language) => {
            tremolite_report::compare(&args.compare, &args.out, language).map(|()| args.out.clone())
        }
        (Some(folder), Some(language)) => tremolite_report::write_in(folder, language),
        (Some(folder), None) => tremolite_report::write(folder),
    };
    print(&page.map_err(Failure::failed)?.display().to_string());
    Ok(Code::Done)
}
