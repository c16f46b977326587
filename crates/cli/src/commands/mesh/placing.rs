//! The options of `mesh convert` that put a mesh where a model wants it.

use crate::exit::Failure;
use tremolite_case::units;
use tremolite_laws::Dimension;
use tremolite_mesh::placement::{Placement, Up};

/// They apply in the order in which they stand here.
#[derive(clap::Args)]
pub struct Args {
    /// Axis of the file that points up; it becomes z
    #[arg(long, default_value = "z", value_parser = ["x", "y", "z"])]
    up: String,
    /// Then a factor, or one along each axis: 0.001 for a file in mm, 1,-1,1 to mirror
    #[arg(long, value_name = "FACTOR", allow_hyphen_values = true)]
    scale: Option<String>,
    /// Then an angle about z, counter-clockwise seen from above: "30 deg"
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    rotate: Option<String>,
    /// Then a way along x, y and z, in m: 0,0,-200
    #[arg(long = "move", value_name = "X,Y,Z", allow_hyphen_values = true)]
    shift: Option<String>,
}

impl Args {
    /// What they ask for; nothing if that leaves a mesh as it is.
    pub fn placement(&self) -> Result<Option<Placement>, Failure> {
        let mut placement = Placement::AS_IT_IS;
        placement.up = match self.up.as_str() {
            "x" => Up::X,
            "y" => Up::Y,
            _ => Up::Z,
        };
        if let Some(text) = &self.scale {
            let wrong =
                || Failure::input(format!("--scale {text}: give one factor or three, none of them 0: 0.001"));
            let factors = numbers(text, Dimension::NONE).ok_or_else(wrong)?;
            placement.scale = match factors[..] {
                [all] => [all; 3],
                [x, y, z] => [x, y, z],
                _ => return Err(wrong()),
            };
            if placement.scale.contains(&0.0) {
                return Err(wrong());
            }
        }
        if let Some(text) = &self.rotate {
            let wrong = |e: units::UnitError| {
                Failure::input(format!(
                    "--rotate {text}: the angle {}; {}",
                    e.message("rotate"),
                    e.remedy("rotate")
                ))
            };
            placement.rotation = units::parse(text, Dimension::ANGLE).map_err(wrong)?;
        }
        if let Some(text) = &self.shift {
            let wrong = || Failure::input(format!("--move {text}: give three lengths, in m: 0,0,-200"));
            placement.shift =
                numbers(text, Dimension::LENGTH).and_then(|way| way.try_into().ok()).ok_or_else(wrong)?;
        }
        Ok((placement != Placement::AS_IT_IS).then_some(placement))
    }
}

/// Numbers with commas between them, bare in SI or with their unit; nothing if one cannot be read.
fn numbers(text: &str, dimension: Dimension) -> Option<Vec<f64>> {
    let number = |word: &str| {
        let bare = word.trim().parse::<f64>().ok().filter(|x| x.is_finite());
        bare.or_else(|| units::parse(word, dimension).ok())
    };
    text.split(',').map(number).collect()
}
