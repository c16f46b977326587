//! A material's answer as a figure: which components and histories are worth a line.

use super::super::columns::MATERIAL;
use super::super::figure::{Along, NEGLIGIBLE, Pair, courses, curves, largest, most, spread};
use tremolite_laws::Role;
use tremolite_laws::path::Response;
use tremolite_report::Strip;
use tremolite_report::loops::{Course, Curve, Loops, Named, Plane, Quantity, Track};

const COMPONENTS: [&str; 6] = ["xx", "yy", "zz", "xy", "yz", "zx"];

/// The flags of a plastic state.
const FLAGS: [(&str, u32); 4] =
    [("shear now", 1), ("tension now", 2), ("shear earlier", 4), ("tension earlier", 8)];

/// The figure as SVG: normal and shear stress over strain, then strain, stress and history over time.
pub fn draw(title: &str, time: &[f64], response: &Response) -> String {
    let strain: [Vec<f64>; 6] = std::array::from_fn(|k| response.strain.iter().map(|e| e[k]).collect());
    let stress: [Vec<f64>; 6] = std::array::from_fn(|k| response.stress.iter().map(|s| s[k]).collect());
    let along = Along::of(time);
    let mut planes = Vec::new();
    planes.extend(plane("normal", 0..3, &strain, &stress));
    planes.extend(plane("shear", 3..6, &strain, &stress));
    if let [normal] = &planes[..] {
        planes.extend(tension(normal));
    }
    let mut tracks = Vec::new();
    tracks.extend(courses(Quantity::new("strain", ""), &MATERIAL.motions(), &strain, true));
    tracks.extend(courses(Quantity::new("stress", "Pa"), &MATERIAL.stresses(), &stress, false));
    tracks.extend(histories(response));
    Loops {
        title: title.to_owned(),
        along: along.quantity(),
        time: along.values(),
        planes,
        tracks,
        states: states(response),
    }
    .draw()
}

/// Loops of the components whose strain and stress both vary; equal ones are one line.
fn plane<'a>(
    word: &str,
    range: std::ops::Range<usize>,
    strain: &'a [Vec<f64>; 6],
    stress: &'a [Vec<f64>; 6],
) -> Option<Plane<'a>> {
    let noise = (NEGLIGIBLE * largest(strain), NEGLIGIBLE * largest(stress));
    let pairs = range.map(|k| Pair { name: COMPONENTS[k], colour: k, across: &strain[k], up: &stress[k] });
    let curves = curves(pairs, noise);
    let quantity = |kind: &str, unit: &str| Quantity::new(format!("{word} {kind}"), unit);
    (!curves.is_empty()).then(|| Plane {
        across: quantity("strain", ""),
        up: quantity("stress", "Pa"),
        curves,
        named: Named::HighestAndLowest,
    })
}

/// The history variables that vary; those whose names start with the same word share a track, components of a tensor
/// apart from the rest.
fn histories(response: &Response) -> Vec<Track<'_>> {
    let mut tracks: Vec<Track<'_>> = Vec::new();
    for (column, values) in response.columns.iter().zip(&response.history) {
        let (word, rest) = column.name.split_once('_').unwrap_or((column.name, ""));
        // A rate factor of 1, and 0 before there is one, changes nothing.
        let idle = word == "factor" && values.iter().all(|x| *x == 0.0 || *x == 1.0);
        if idle || spread(values) == 0.0 || column.role == Role::PlasticState {
            continue;
        }
        let component = MATERIAL.motions().iter().position(|name| *name == rest);
        let title = match (word, component) {
            ("d", None) => "damage".to_owned(),
            (_, None) => word.to_owned(),
            (_, Some(_)) => format!("{word} strain"),
        };
        let quantity = Quantity::new(title, if column.unit == "1" { "" } else { column.unit });
        let at = tracks.iter().position(|t| t.quantity == quantity).unwrap_or_else(|| {
            tracks.push(Track { quantity, courses: Vec::new() });
            tracks.len() - 1
        });
        let courses = &mut tracks[at].courses;
        let colour = component.unwrap_or(courses.len());
        courses.push(Course { name: column.name.to_owned(), colour, values });
    }
    for track in &mut tracks {
        let noise = NEGLIGIBLE * track.courses.iter().map(|c| most(c.values)).fold(0.0, f64::max);
        track.courses.retain(|c| spread(c.values) > noise);
    }
    tracks
}

/// The flags that ever hold of a plastic state, their sum.
fn states(response: &Response) -> Option<(String, Vec<Strip>)> {
    let (name, sum) = response.with_role(Role::PlasticState)?;
    let strips = FLAGS.iter().enumerate().map(|(colour, (name, flag))| {
        let on = sum.iter().map(|x| (*x as u32) & flag != 0).collect();
        Strip { name: (*name).to_owned(), colour, on }
    });
    let strips: Vec<Strip> = strips.filter(|s| s.on.contains(&true)).collect();
    (!strips.is_empty()).then(|| (name.to_owned(), strips))
}

/// The tension side alone, where it is too low beside the pressures to be seen.
fn tension<'a>(plane: &Plane<'a>) -> Option<Plane<'a>> {
    let values = || plane.curves.iter().flat_map(|c| c.up.iter().copied());
    let (low, high) = (values().fold(0.0, f64::min), values().fold(0.0, f64::max));
    // Round-off beside the pressures is no tension.
    if high <= 1e-4 * -low || high >= -0.4 * low {
        return None;
    }
    let curves = plane.curves.iter().filter_map(|c| {
        let (across, up) = above(&c.across, &c.up, -0.3 * high);
        let seen = !up.is_empty();
        seen.then(|| Curve { across: across.into(), up: up.into(), ..c.clone() })
    });
    Some(Plane {
        up: Quantity::new(format!("{}, tension side", plane.up.name), &*plane.up.unit),
        curves: curves.collect(),
        named: Named::Highest,
        ..plane.clone()
    })
}

/// The parts of a curve that lie above a level, up to the points where it crosses; NaN stands between them.
fn above(across: &[f64], up: &[f64], level: f64) -> (Vec<f64>, Vec<f64>) {
    let mut kept = (Vec::new(), Vec::new());
    let mut keep = |x: f64, y: f64| {
        kept.0.push(x);
        kept.1.push(y);
    };
    for k in 0..up.len() {
        let crosses = k > 0 && (up[k - 1] > level) != (up[k] > level);
        if crosses {
            let part = (level - up[k - 1]) / (up[k] - up[k - 1]);
            keep(across[k - 1] + part * (across[k] - across[k - 1]), level);
        }
        if up[k] > level {
            keep(across[k], up[k]);
        } else if crosses {
            keep(f64::NAN, f64::NAN);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_is_cut_where_it_crosses_the_level() {
        let (x, y) = above(&[0.0, 1.0, 2.0, 3.0, 4.0], &[1.0, -1.0, -2.0, 2.0, 3.0], 0.0);
        assert_eq!(x[..2], [0.0, 0.5]);
        assert_eq!(x[3..], [2.5, 3.0, 4.0]);
        assert_eq!(y[..2], [1.0, 0.0]);
        assert_eq!(y[3..], [0.0, 2.0, 3.0]);
        assert!(x[2].is_nan() && y[2].is_nan());
    }
}
