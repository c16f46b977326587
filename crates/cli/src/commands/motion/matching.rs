//! `tremolite motion match`: records whose spectra are made a target's.

use super::files::Files;
use super::fit::{Fit, keep, share};
use crate::exit::{Code, Failure, Outcome};
use crate::terminal::print;
use std::path::PathBuf;
use tremolite_motion::matched;

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    files: Files,
    #[command(flatten)]
    fit: Fit,
    /// How far the spectrum may be from the target at any of 200 periods
    #[arg(long, default_value = "5 %", value_parser = share)]
    tolerance: f64,
    /// Folder for the motions
    #[arg(long, default_value = ".")]
    out: PathBuf,
    /// Leave out the figures
    #[arg(long)]
    no_plot: bool,
}

pub fn run(args: &Args) -> Outcome {
    let (target, band) = args.fit.read()?;
    let channels = args.files.accelerations()?;
    std::fs::create_dir_all(&args.out).map_err(|e| Failure::input(format!("{}: {e}", args.out.display())))?;
    let mut all = Vec::new();
    for (i, channel) in channels.iter().enumerate() {
        let made = matched(channel, &target, band, args.tolerance).map_err(Failure::input)?;
        let stem = channel.file.file_stem().map_or("record".into(), |s| s.to_string_lossy());
        let path = args.out.join(format!("{stem}_{}.matched.txt", i + 1));
        all.push(keep(&made, &target, band, &path, !args.no_plot, args.files.json)?);
    }
    if args.files.json {
        print(&serde_json::json!({ "target": target.name, "band": band, "motions": all }).to_string());
    }
    Ok(Code::Done)
}
