//! `tremolite report`: the page again, from the result files.

use crate::exit::{Code, Failure, Outcome};
use crate::terminal::print;
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Args {
    /// The result folder
    folder: PathBuf,
    /// The page's language, en or zh; left out, that of the case
    #[arg(long, value_name = "CODE")]
    language: Option<tremolite_report::Language>,
}

pub fn run(args: &Args) -> Outcome {
    tremolite_results::ResultFolder::open_existing(&args.folder).map_err(Failure::input)?;
    let page = match args.language {
        Some(language) => tremolite_report::write_in(&args.folder, language),
        None => tremolite_report::write(&args.folder),
    };
    let page = page.map_err(Failure::failed)?;
    print(&page.display().to_string());
    Ok(Code::Done)
}
