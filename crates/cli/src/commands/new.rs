//! `tremolite new`: a case to start from.

use crate::exit::{Code, Failure, Outcome};
use crate::terminal::say;
use std::path::PathBuf;
use tremolite_motion::{Channel, ricker_velocity, write_text};

#[derive(clap::Args)]
pub struct Args {
    /// A folder that does not exist yet
    folder: PathBuf,
}

const CASE: &str = include_str!("new_case.toml");

pub fn run(args: &Args) -> Outcome {
    let folder = &args.folder;
    if folder.exists() {
        return Err(Failure::input(format!("{} exists already; give a new folder", folder.display())));
    }
    let failed = |e: std::io::Error| Failure::failed(format!("{}: {e}", folder.display()));
    std::fs::create_dir_all(folder).map_err(failed)?;
    let case = folder.join("case.toml");
    std::fs::write(&case, CASE).map_err(failed)?;
    // A pulse of 4 Hz and 0.2 m/s: short, smooth, and zero at both ends.
    let dt = 0.005;
    let pulse = ricker_velocity(4.0, 0.5, 0.2);
    let channel = Channel {
        file: "pulse.txt".into(),
        ..Channel::new("Ricker pulse, 4 Hz", dt, (0..=300).map(|i| pulse(f64::from(i) * dt).a).collect())
    };
    let notes = ["A made pulse; replace it by a record of your site.".to_owned()];
    write_text(&channel, &notes, &folder.join("pulse.txt")).map_err(Failure::failed)?;
    say(&format!("{} is ready; try\n  tremolite run {}", folder.display(), case.display()));
    Ok(Code::Done)
}
