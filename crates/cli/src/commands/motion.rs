//! `tremolite motion`: earthquake records.

mod artificial;
mod figure;
mod files;
mod fit;
mod info;
mod matching;
mod measures;
mod process;
mod select;
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
    /// Match records to a target spectrum in time, and write them with a figure beside the target
    Match(matching::Args),
    /// Motions of random phases under an envelope, matched to a target spectrum
    Artificial(artificial::Args),
    /// The records of a folder whose spectra are nearest to a target in shape, and what to multiply them by
    Select(select::Args),
}

pub fn run(args: &Args) -> Outcome {
    match &args.action {
        Action::Info(files) => info::run(files),
        Action::Spectrum(files) => spectrum::run(files),
        Action::Process(args) => process::run(args),
        Action::Match(args) => matching::run(args),
        Action::Artificial(args) => artificial::run(args),
        Action::Select(args) => select::run(args),
    }
}
