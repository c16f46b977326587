//! `tremolite motion process`: records cut, corrected, filtered, scaled, and written.

use super::figure;
use super::files::Files;
use super::measures::{Measures, figures as number, less_mean, seconds};
use crate::exit::{Code, Failure, Outcome};
use crate::terminal::{print, say};
use std::path::PathBuf;
use tremolite_motion::{Channel, Process, TargetSpectrum, align, write_text};

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    files: Files,
    /// A step, in order: "detrend linear", "pre-event 5 s", "taper 1 s", "bandpass 0.1 Hz 20 Hz", "pga 0.3 g" (the
    /// largest component, the others by the same factor), "baseline", "match 0.1 s 2 s" …; without a step it is only looked at
    #[arg(long = "step")]
    steps: Vec<String>,
    /// What a step "match" is to fit: "EN 1998-1 type 1 ground B 2 m/s2", or a CSV file with the columns `period [s]` and `sa [m/s2]` or
    /// `sa [g]`
    #[arg(long)]
    target: Option<String>,
    /// Keep this part of the record only: from and to in s
    #[arg(long, num_args = 2, value_names = ["FROM", "TO"])]
    window: Option<Vec<f64>>,
    /// Folder for the processed records
    #[arg(long, default_value = ".")]
    out: PathBuf,
    /// Leave out the figures of the record before and after processing
    #[arg(long)]
    no_plot: bool,
}

pub fn run(args: &Args) -> Outcome {
    let steps: Vec<Process> =
        args.steps.iter().map(|s| Process::parse(s)).collect::<Result<_, _>>().map_err(Failure::input)?;
    let target = args.target.as_deref().map(TargetSpectrum::parse).transpose().map_err(Failure::input)?;
    let mut before = args.files.of_accelerometers()?;
    align(&mut before.iter_mut().collect::<Vec<_>>());
    belong_together(&before)?;
    if let Some([from, to]) = args.window.as_deref() {
        for c in &mut before {
            let whole = [c.start, c.end()];
            *c = c.window(*from, *to).map_err(Failure::input)?;
            // Samples need not lie at the window's limits.
            if from + c.dt < whole[0] || to - c.dt > whole[1] {
                say(&format!(
                    "note: the window reaches beyond '{}', which runs from {} s to {} s; kept {} s to {} s",
                    c.name,
                    seconds(whole[0]),
                    seconds(whole[1]),
                    seconds(c.start),
                    seconds(c.end())
                ));
            }
        }
    }
    let mut after = before.clone();
    let mut factors = Vec::new();
    for step in &steps {
        let old = largest(&after);
        step.apply_towards(&mut after.iter_mut().collect::<Vec<_>>(), target.as_ref())
            .map_err(Failure::input)?;
        if matches!(step, Process::PeakAcceleration { .. }) {
            factors.push((step.to_string(), largest(&after) / old));
        }
    }

    let folder = &args.out;
    std::fs::create_dir_all(folder).map_err(|e| Failure::input(format!("{}: {e}", folder.display())))?;
    let (mut written, mut figures, mut records) = (Vec::new(), Vec::new(), Vec::new());
    for (i, (old, new)) in before.iter().zip(&after).enumerate() {
        let stem = new.file.file_stem().map_or("record".into(), |s| s.to_string_lossy());
        let path = folder.join(format!("{stem}_{}.txt", i + 1));
        let notes: Vec<String> =
            std::iter::once(format!("from {}", new.name)).chain(args.steps.iter().cloned()).collect();
        write_text(new, &notes, &path).map_err(Failure::failed)?;
        written.push(path.display().to_string());
        let old = less_mean(old);
        let [measured, made] = [&old, new].map(Measures::of);
        if args.files.json {
            records.push(serde_json::json!({
                "name": new.name, "file": new.file, "written": path, "before": measured.json(), "after": made.json(),
            }));
        } else {
            print(&format!("{}\n    before, less its mean: {}", path.display(), measured.text()));
            if !steps.is_empty() {
                print(&format!("    after: {}", made.text()));
            }
            for (step, factor) in &factors {
                print(&format!("    {step}: multiplied by {}", number(*factor)));
            }
        }
        if !args.no_plot {
            // Without a step there is nothing after.
            let new = if steps.is_empty() { &old } else { new };
            let drawn = figure::draw(&old, new, &steps).map_err(Failure::failed)?;
            let path = path.with_extension("svg");
            std::fs::write(&path, drawn).map_err(|e| Failure::failed(format!("{}: {e}", path.display())))?;
            figures.push(path.display().to_string());
        }
    }
    if args.files.json {
        let factors: Vec<f64> = factors.iter().map(|(_, factor)| *factor).collect();
        let all = serde_json::json!({
            "written": written, "figures": figures, "records": records, "pga_factors": factors,
        });
        print(&all.to_string());
    } else {
        figures.iter().for_each(|name| print(name));
    }
    Ok(Code::Done)
}

/// The largest size of any sample.
fn largest(channels: &[Channel]) -> f64 {
    channels.iter().flat_map(|c| &c.acceleration).fold(0.0, |most, a| a.abs().max(most))
}

/// Refuses channels that share no time: they are no components of one record.
fn belong_together(channels: &[Channel]) -> Result<(), Failure> {
    let late = channels.iter().max_by(|a, b| a.start.total_cmp(&b.start));
    let early = channels.iter().min_by(|a, b| a.end().total_cmp(&b.end()));
    match (early, late) {
        (Some(early), Some(late)) if late.start >= early.end() => Err(Failure::input(format!(
            "'{}' begins {} s after '{}' has ended, so they are not components of one record; process records of different \
             earthquakes one by one",
            late.name,
            seconds(late.start - early.end()),
            early.name
        ))),
        _ => Ok(()),
    }
}
