//! `tremolite motion`: earthquake records.

use crate::exit::{Code, Failure, Outcome};
use crate::terminal::print;
use std::path::{Path, PathBuf};
use tremolite_motion::{
    Channel, Intensity, Process, ReadOptions, Units, default_periods, process, pseudo_acceleration, read,
    write_text,
};

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
    /// Process records and write them as two columns of text; files given together are components of one record
    Process {
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
    },
}

#[derive(clap::Args)]
struct Files {
    /// Records in any supported format
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Units of text files: g, m/s2, cm/s2 or mm/s2
    #[arg(long)]
    units: Option<String>,
    /// Sampling interval of one-column text files, in s
    #[arg(long)]
    dt: Option<f64>,
    #[arg(long)]
    json: bool,
}

impl Files {
    fn channels(&self) -> Result<Vec<Channel>, Failure> {
        let units = self.units.as_deref().map(str::parse::<Units>).transpose().map_err(Failure::input)?;
        let options = ReadOptions { units, dt: self.dt, ..ReadOptions::default() };
        let mut all = Vec::new();
        for file in &self.files {
            all.extend(read(file, &options).map_err(Failure::input)?);
        }
        Ok(all)
    }
}

pub fn run(args: &Args) -> Outcome {
    match &args.action {
        Action::Info(files) => info(files),
        Action::Spectrum(files) => spectrum(files),
        Action::Process { files, steps, window, out } => process_all(files, steps, window.as_deref(), out),
    }
}

fn info(files: &Files) -> Outcome {
    let channels = files.channels()?;
    let mut list = Vec::new();
    for c in &channels {
        let m = Intensity::of(c);
        if files.json {
            list.push(serde_json::json!({
                "name": c.name, "file": c.file, "dt": m.dt, "npts": m.npts, "units": c.units.to_string(), "pga": m.pga,
                "pgv": m.pgv, "pgd": m.pgd, "arias": m.arias, "d5_95": m.d5_95, "cav": m.cav,
            }));
        } else {
            print(&format!(
                "{} [{}]: {} points of {} s\n    PGA {:.4} m/s2, PGV {:.4} m/s, PGD {:.4} m, Arias {:.4} m/s, D5-95 {:.2} s, CAV {:.3} m/s",
                c.name, c.units, m.npts, m.dt, m.pga, m.pgv, m.pgd, m.arias, m.d5_95, m.cav
            ));
        }
    }
    if files.json {
        print(&serde_json::json!({ "channels": list }).to_string());
    }
    Ok(Code::Done)
}

fn spectrum(files: &Files) -> Outcome {
    let periods = default_periods();
    let mut list = Vec::new();
    for mut c in files.channels()? {
        process(&mut [&mut c], &[Process::DetrendLinear]).map_err(Failure::input)?;
        let psa = pseudo_acceleration(&c.acceleration, c.dt, &periods, 0.05).map_err(Failure::input)?;
        if files.json {
            list.push(serde_json::json!({ "name": c.name, "file": c.file, "periods": periods, "psa": psa }));
        } else {
            print(&format!("# {} : period [s], pseudo-acceleration [m/s2], 5 % damping", c.name));
            for (t, a) in periods.iter().zip(&psa) {
                print(&format!("{t:.4} {a:.6}"));
            }
        }
    }
    if files.json {
        print(&serde_json::json!({ "channels": list }).to_string());
    }
    Ok(Code::Done)
}

fn process_all(files: &Files, steps: &[String], window: Option<&[f64]>, out: &Path) -> Outcome {
    let parsed: Vec<Process> =
        steps.iter().map(|s| Process::parse(s)).collect::<Result<_, _>>().map_err(Failure::input)?;
    std::fs::create_dir_all(out).map_err(|e| Failure::input(format!("{}: {e}", out.display())))?;
    let mut channels = files.channels()?;
    if let Some([from, to]) = window {
        for c in &mut channels {
            *c = c.window(*from, *to).map_err(Failure::input)?;
        }
    }
    process(&mut channels.iter_mut().collect::<Vec<_>>(), &parsed).map_err(Failure::input)?;
    let mut written = Vec::new();
    for (i, c) in channels.iter().enumerate() {
        let stem = Path::new(&c.file).file_stem().map(|s| s.to_string_lossy().into_owned());
        let path = out.join(format!("{}_{}.txt", stem.unwrap_or_else(|| "record".into()), i + 1));
        let notes: Vec<String> =
            std::iter::once(format!("from {}", c.name)).chain(steps.iter().cloned()).collect();
        write_text(c, &notes, &path).map_err(Failure::failed)?;
        let name = path.display().to_string();
        if !files.json {
            print(&name);
        }
        written.push(name);
    }
    if files.json {
        print(&serde_json::json!({ "written": written }).to_string());
    }
    Ok(Code::Done)
}
