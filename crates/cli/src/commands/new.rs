//! `tremolite new`: a case to start from.

use crate::exit::{Code, Failure, Outcome};
use crate::terminal::say;
use std::path::PathBuf;
use tremolite_motion::{Channel, ricker_velocity, write_text};

#[derive(clap::Args)]
pub struct Args {
    /// A folder that does not exist yet
    folder: PathBuf,
    /// With water in the rock, which flows to the cavern and behind its drained lining
    #[arg(long)]
    water: bool,
}

const CASE: &str = include_str!("new_case.toml");

/// What the case has with water: before which line, and what stands there then.
const WATER: [(&str, &str); 4] = [
    (
        "[material.rock]\n",
        r#"[water]                            # laws then see effective stress
level    = "-20 m"                 # of the initial state
pressure = "seepage"               # steady flow to walls and drains in each stage; "level" for still water
heads    = { xmin = "-20 m", xmax = "-20 m", base = "-20 m" }   # where the water comes from

"#,
    ),
    (
        "\n[material.concrete]",
        r#"water       = { biot = 0.8, hydraulic_conductivity = "1e-7 m/s", saturated_unit_weight = "27.3 kN/m3" }
"#,
    ),
    (
        "# tensile_strength =",
        r#"water       = "none"              # it closes the wall behind it, unless that is drained
"#,
    ),
    (
        "\n[motion]",
        r#"water    = { drained = ["hall.*"] }  # drains behind the lining; else it closes the wall, and wants an [[interface]] without a bond
"#,
    ),
];

/// The case, with water or without.
fn text(water: bool) -> String {
    let more = if water { &WATER[..] } else { &[] };
    more.iter()
        .fold(CASE.to_owned(), |text, (before, added)| text.replacen(before, &format!("{added}{before}"), 1))
}

pub fn run(args: &Args) -> Outcome {
    let folder = &args.folder;
    if folder.exists() {
        return Err(Failure::input(format!("{} exists already; give a new folder", folder.display())));
    }
    let failed = |e: std::io::Error| Failure::failed(format!("{}: {e}", folder.display()));
    std::fs::create_dir_all(folder).map_err(failed)?;
    let case = folder.join("case.toml");
    std::fs::write(&case, text(args.water)).map_err(failed)?;
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
