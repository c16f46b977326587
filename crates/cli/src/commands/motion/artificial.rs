//! `tremolite motion artificial`: motions that are computed for a target spectrum.

use super::files::interval;
use super::fit::{Fit, keep, share};
use crate::exit::{Code, Failure, Outcome};
use crate::terminal::print;
use std::path::PathBuf;
use tremolite_motion::{Envelope, artificial, correlation};

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    fit: Fit,
    /// How long they last
    #[arg(long, value_parser = interval)]
    duration: f64,
    /// When they have their full strength; left out, after a seventh of the duration
    #[arg(long, value_parser = interval)]
    rise: Option<f64>,
    /// When they begin to fade; left out, after three fifths of the duration
    #[arg(long, value_parser = interval)]
    fall: Option<f64>,
    /// Sampling interval before matching, which may need a finer one
    #[arg(long, default_value = "0.01 s", value_parser = interval)]
    dt: f64,
    /// How many, of mutual correlation below 0.3
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..=100))]
    count: u64,
    /// The first one's phases; equal numbers give equal motions
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// How far the spectrum may be from the target at any of 200 periods
    #[arg(long, default_value = "5 %", value_parser = share)]
    tolerance: f64,
    /// Folder for the motions
    #[arg(long, default_value = ".")]
    out: PathBuf,
    /// Leave out the figures
    #[arg(long)]
    no_plot: bool,
    #[arg(long)]
    json: bool,
}

pub fn run(args: &Args) -> Outcome {
    let (target, band) = args.fit.read()?;
    let envelope = Envelope::new(args.duration, args.rise, args.fall).map_err(Failure::input)?;
    let last = args.seed.checked_add(args.count);
    let last =
        last.ok_or_else(|| Failure::input("--seed: there are not so many numbers left; give a smaller one"))?;
    let seeds = args.seed..last;
    std::fs::create_dir_all(&args.out).map_err(|e| Failure::input(format!("{}: {e}", args.out.display())))?;
    let made = artificial(&target, band, envelope, args.dt, seeds.clone(), args.tolerance)
        .map_err(Failure::input)?;
    let mut all = Vec::new();
    for (seed, one) in seeds.zip(&made) {
        let path = args.out.join(format!("artificial_{seed}.txt"));
        all.push(keep(one, &target, band, &path, !args.no_plot, args.json)?);
    }
    let mut most = 0.0_f64;
    for (i, a) in made.iter().enumerate() {
        for b in &made[..i] {
            most = most.max(correlation(&a.channel.acceleration, &b.channel.acceleration).abs());
        }
    }
    if args.json {
        let all = serde_json::json!({ "target": target.name, "band": band, "motions": all, "largest_correlation": most });
        print(&all.to_string());
    } else if made.len() > 1 {
        print(&format!("largest correlation of two: {most:.3}"));
    }
    Ok(Code::Done)
}
