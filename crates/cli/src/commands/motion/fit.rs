//! What motions are to fit, as the commands `match`, `artificial` and `select` take it, and what they say of one that does.

use super::figure::draw_matched;
use super::files::interval;
use super::measures::{Measures, figures, seconds};
use crate::exit::Failure;
use crate::terminal::print;
use std::path::Path;
use tremolite_motion::{Intensity, Matched, TargetSpectrum, drift, write_text};

#[derive(clap::Args)]
pub struct Fit {
    /// "EN 1998-1 type 1 ground B 2 m/s2", or a CSV file with the columns `period [s]` and `sa [m/s2]` or `sa [g]`, for 5 % damping
    #[arg(long)]
    target: String,
    /// Shortest and longest period that are to fit, such as "0.05 s" "2 s"; left out, all that the target has from 0.04 s to 4 s
    #[arg(long, num_args = 2, value_names = ["FROM", "TO"], value_parser = interval)]
    band: Option<Vec<f64>>,
}

impl Fit {
    /// The target, and the band of periods (s).
    pub fn read(&self) -> Result<(TargetSpectrum, [f64; 2]), Failure> {
        let target = TargetSpectrum::parse(&self.target).map_err(Failure::input)?;
        let asked = self.band.as_deref().and_then(|band| <[f64; 2]>::try_from(band).ok());
        let band = target.band(asked).map_err(Failure::input)?;
        Ok((target, band))
    }
}

/// A share such as "5 %" or 0.05.
pub fn share(text: &str) -> Result<f64, String> {
    let word = text.trim();
    let (number, unit) = word.strip_suffix('%').map_or((word, 1.0), |number| (number, 0.01));
    match number.trim().parse::<f64>() {
        Ok(value) if value > 0.0 && value * unit < 1.0 => Ok(value * unit),
        _ => Err("write a share such as \"5 %\" or 0.05".to_owned()),
    }
}

/// Writes a motion into `path` with its figure, and gives what is known of it as data; prints it in words unless `json`.
pub fn keep(
    made: &Matched,
    target: &TargetSpectrum,
    band: [f64; 2],
    path: &Path,
    plot: bool,
    json: bool,
) -> Result<serde_json::Value, Failure> {
    let channel = &made.channel;
    let within = format!(
        "{:.1} % of {} at 200 periods from {} s to {} s",
        100.0 * made.after.largest,
        target.name,
        seconds(band[0]),
        seconds(band[1])
    );
    let notes = [format!("multiplied by {}, then matched within {within}", figures(made.factor))];
    write_text(channel, &notes, path).map_err(Failure::failed)?;
    let [v, u] = drift(&channel.acceleration, channel.dt);
    let mut rows = Vec::new();
    let all = [("before", &made.scaled, made.before), ("after", &channel.acceleration, made.after)];
    for (name, acceleration, misfit) in all {
        let i = Intensity::of_samples(acceleration, channel.dt);
        let row = serde_json::json!({
            "largest_misfit": misfit.largest, "at_period": misfit.period, "rms_misfit": misfit.rms,
            "pga": i.pga, "pgv": i.pgv, "pgd": i.pgd, "arias": i.arias, "d5_95": i.d5_95,
        });
        rows.push((name, row, i, misfit));
    }
    if !json {
        print(&format!("{}\n    multiplied by {}", path.display(), figures(made.factor)));
        for (name, _, i, misfit) in &rows {
            print(&format!(
                "    {name}: off by {:.1} % at {:.3} s, {:.1} % (rms); PGA {} m/s2, PGV {} m/s, PGD {} m, Arias {} m/s, 5-95 % in {} s",
                100.0 * misfit.largest,
                misfit.period,
                100.0 * misfit.rms,
                figures(i.pga),
                figures(i.pgv),
                figures(i.pgd),
                figures(i.arias),
                figures(i.d5_95)
            ));
        }
        print(&format!("    at the end: velocity {:.1e} and displacement {:.1e} of their peaks", v, u));
    }
    let mut figure = serde_json::Value::Null;
    if plot {
        let title = format!("{}: matched to {}", channel.name, target.name);
        let words = format!(
            "multiplied by {}, wavelets added in {} rounds, within {within}",
            figures(made.factor),
            made.rounds
        );
        let drawn = draw_matched(made, target, &title, words).map_err(Failure::failed)?;
        let path = path.with_extension("svg");
        std::fs::write(&path, drawn).map_err(|e| Failure::failed(format!("{}: {e}", path.display())))?;
        if !json {
            print(&path.display().to_string());
        }
        figure = path.display().to_string().into();
    }
    let measures = Measures::of(channel).json();
    let [(_, before, ..), (_, after, ..)] = &rows[..] else { return Ok(measures) };
    Ok(serde_json::json!({
        "written": path, "figure": figure, "factor": made.factor, "rounds": made.rounds, "dt": channel.dt,
        "before": before, "after": after, "velocity_at_end": v, "displacement_at_end": u,
    }))
}

#[cfg(test)]
mod tests {
    use super::share;

    #[test]
    fn shares_are_read_as_ratios_and_in_hundredths() {
        for text in ["5 %", "5%", "0.05"] {
            assert!((share(text).unwrap() - 0.05).abs() < 1e-15, "{text}");
        }
        for text in ["", "0", "-1 %", "5", "nan", "100 %"] {
            assert!(share(text).is_err(), "{text}");
        }
    }
}
