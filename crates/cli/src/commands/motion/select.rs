//! `tremolite motion select`: records of a folder by how near they are to a target spectrum.

use super::files::Declared;
use super::fit::Fit;
use super::measures::figures;
use crate::exit::{Code, Failure, Outcome};
use crate::terminal::{print, say};
use std::path::PathBuf;
use tremolite_motion::{Channel, Process, ReadOptions, read, select};

#[derive(clap::Args)]
pub struct Args {
    /// Folder with records in any supported format
    folder: PathBuf,
    #[command(flatten)]
    fit: Fit,
    /// How many to list
    #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u64).range(1..))]
    count: u64,
    /// Smallest and largest factor that a record may be multiplied by
    #[arg(long, num_args = 2, value_names = ["LEAST", "MOST"], default_values_t = [0.25, 4.0])]
    factors: Vec<f64>,
    #[command(flatten)]
    declared: Declared,
    #[arg(long)]
    json: bool,
}

pub fn run(args: &Args) -> Outcome {
    let (target, band) = args.fit.read()?;
    let factors = match args.factors[..] {
        [least, most] if least > 0.0 && least < most => [least, most],
        _ => {
            return Err(Failure::input(
                "--factors: give the smaller factor first, both above 0, as in --factors 0.25 4",
            ));
        }
    };
    let records = records(args)?;
    let [fit, unfit] = select(&records, &target, band, factors).map_err(Failure::input)?;
    let count = usize::try_from(args.count).unwrap_or(usize::MAX);
    let rows: Vec<serde_json::Value> = fit
        .iter()
        .take(count)
        .map(|c| {
            serde_json::json!({
                "name": records[c.record].name, "file": records[c.record].file, "factor": c.factor,
                "misfit": c.misfit, "largest": c.largest, "period": c.period,
            })
        })
        .collect();
    if args.json {
        let all = serde_json::json!({
            "target": target.name, "band": band, "records": rows, "considered": records.len(), "beyond_factors": unfit.len(),
        });
        print(&all.to_string());
        return Ok(Code::Done);
    }
    print("misfit  factor  farthest            record");
    for c in fit.iter().take(count) {
        print(&format!(
            "{:6.3}  {:6}  {:5.1} % at {:6.3} s  {}",
            c.misfit,
            figures(c.factor),
            100.0 * c.largest,
            c.period,
            records[c.record].name
        ));
    }
    print(&format!(
        "{} components considered, {} of them beyond the factors {} to {}; misfit: root of the mean square of ln(factor Sa/target)",
        records.len(),
        unfit.len(),
        factors[0],
        factors[1]
    ));
    Ok(Code::Done)
}

/// What does not exceed this (m/s²) is round-off of a channel that stands still.
const STILL: f64 = 1e-9;

/// The accelerations of a folder, less their lines of best fit. What is no record is named and passed over.
fn records(args: &Args) -> Result<Vec<Channel>, Failure> {
    let options = args.declared.options()?;
    // Of text with as many columns alone; other files of the folder have their own.
    let plain = ReadOptions { columns: None, ..options.clone() };
    let listed = std::fs::read_dir(&args.folder)
        .map_err(|e| Failure::input(format!("{}: {e}", args.folder.display())))?;
    let mut files: Vec<PathBuf> =
        listed.filter_map(|entry| Some(entry.ok()?.path())).filter(|p| p.is_file()).collect();
    files.sort();
    let mut all = Vec::new();
    for file in files {
        match read(&file, &options).or_else(|fault| read(&file, &plain).map_err(|_| fault)) {
            Err(fault) => say(&format!("note: passed over: {fault}")),
            Ok(channels) => {
                for mut c in channels {
                    if c.raw || c.other_sensor {
                        say(&format!("note: passed over: '{}' is no acceleration", c.name));
                        continue;
                    }
                    Process::DetrendLinear.apply(&mut [&mut c]).map_err(Failure::input)?;
                    if c.acceleration.iter().all(|a| a.abs() < STILL) {
                        say(&format!("note: passed over: '{}' does not move", c.name));
                        continue;
                    }
                    all.push(c);
                }
            }
        }
    }
    if all.is_empty() {
        return Err(Failure::input(format!(
            "{}: no record in the folder can be read as acceleration; give --units where files do not say theirs",
            args.folder.display()
        )));
    }
    Ok(all)
}
