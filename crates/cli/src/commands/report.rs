//! `tremolite report`: the page again, from the result files.

use crate::exit::{Code, Failure, Outcome};
use crate::terminal::print;
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Args {
    /// The result folder
    folder: PathBuf,
}

pub fn run(args: &Args) -> Outcome {
    tremolite_results::ResultFolder::open_existing(&args.folder).map_err(Failure::input)?;
    let page = tremolite_report::write(&args.folder).map_err(Failure::failed)?;
    print(&page.display().to_string());
    Ok(Code::Done)
}
