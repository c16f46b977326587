//! `tremolite motion`: earthquake records.

mod figure;
mod files;
mod info;
mod measures;
mod process;
mod spectrum;

use crate::exit::Outcome;
use files::Files;

#[derive(clap::Args)]
pub struct Args {
    #[command(subcommand)]
    action: Action,
}

#[derive(clap::Subcommand)]
enum Action {
    /// Time step, length and intensity of each channel, after linear detrend
    Info(Files),
    /// Response spectrum for 5 % damping
    Spectrum(Files),
    /// Process records and write them as two columns of text, with a figure of before and after; files given together are
    /// components of one record
    Process(process::Args),
}

pub fn run(args: &Args) -> Outcome {
    match &args.action {
        Action::Info(files) => info::run(files),
        Action::Spectrum(files) => spectrum::run(files),
        Action::Process(args) => process::run(args),
    }
}
