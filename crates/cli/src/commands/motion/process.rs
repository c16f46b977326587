//! `tremolite motion process`: records cut, corrected, filtered, scaled, and written.

use super::figure;
use super::files::Files;
use crate::exit::{Code, Failure, Outcome};
use crate::terminal::print;
use std::path::PathBuf;
use tremolite_motion::{Channel, Process, align, process, write_text};

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    files: Files,
    /// A step, in order: "detrend linear", "pre-event 5 s", "taper 1 s", "bandpass 0.1 Hz 20 Hz", "pga 0.3 g" (the
    /// largest component, the others by the same factor), "baseline" …
    #[arg(long = "step", required = true)]
    steps: Vec<String>,
    /// Keep this part of the record only: from and to in s
    #[arg(long, num_args = 2, value_names = ["FROM", "TO"])]
    window: Option<Vec<f64>>,
    /// Folder for the processed records
    #[arg(long, default_value = ".")]
    out: PathBuf,
    /// Leave out the figures of before and after
    #[arg(long)]
    no_plot: bool,
}

pub fn run(args: &Args) -> Outcome {
    let steps: Vec<Process> =
        args.steps.iter().map(|s| Process::parse(s)).collect::<Result<_, _>>().map_err(Failure::input)?;
    let mut before = args.files.channels()?;
    align(&mut before.iter_mut().collect::<Vec<_>>());
    belong_together(&before)?;
    if let Some([from, to]) = args.window.as_deref() {
        for c in &mut before {
            *c = c.window(*from, *to).map_err(Failure::input)?;
        }
    }
    let mut after = before.clone();
    process(&mut after.iter_mut().collect::<Vec<_>>(), &steps).map_err(Failure::input)?;

    let folder = &args.out;
    std::fs::create_dir_all(folder).map_err(|e| Failure::input(format!("{}: {e}", folder.display())))?;
    let (mut written, mut figures) = (Vec::new(), Vec::new());
    for (i, (old, new)) in before.iter().zip(&after).enumerate() {
        let stem = new.file.file_stem().map_or("record".into(), |s| s.to_string_lossy());
        let path = folder.join(format!("{stem}_{}.txt", i + 1));
        let notes: Vec<String> =
            std::iter::once(format!("from {}", new.name)).chain(args.steps.iter().cloned()).collect();
        write_text(new, &notes, &path).map_err(Failure::failed)?;
        written.push(path.display().to_string());
        if !args.no_plot {
            let drawn = figure::draw(old, new, &steps).map_err(Failure::failed)?;
            let path = path.with_extension("svg");
            std::fs::write(&path, drawn).map_err(|e| Failure::failed(format!("{}: {e}", path.display())))?;
            figures.push(path.display().to_string());
        }
    }
    if args.files.json {
        print(&serde_json::json!({ "written": written, "figures": figures }).to_string());
    } else {
        written.iter().chain(&figures).for_each(|name| print(name));
    }
    Ok(Code::Done)
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
            late.start - early.end(),
            early.name
        ))),
        _ => Ok(()),
    }
}
