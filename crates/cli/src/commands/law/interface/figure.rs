//! A pair's answer as a figure: pressure over closure, shear over slip, and what varies over time.

use super::super::columns::INTERFACE;
use super::super::figure::{Along, NEGLIGIBLE, Pair, courses, curves, largest, most, spread};
use tremolite_laws::PairState;
use tremolite_laws::interface_path::InterfaceResponse;
use tremolite_report::Strip;
use tremolite_report::loops::{Course, Loops, Named, Plane, Quantity, Track};

/// How far beyond all gaps and closures that carry something a gap that carries nothing is drawn.
const BEYOND: f64 = 1.25;

/// The figure as SVG.
pub fn draw(title: &str, time: &[f64], response: &InterfaceResponse) -> String {
    let InterfaceResponse { gap, pressure, .. } = response;
    let slip = [0, 1].map(|i| response.slip.iter().map(|s| s[i]).collect::<Vec<f64>>());
    let shear = [0, 1].map(|i| response.shear.iter().map(|t| t[i]).collect::<Vec<f64>>());
    let closure = closure(gap, pressure);
    let [gap_name, slip_names @ ..] = INTERFACE.motions();
    let [pressure_name, shear_names @ ..] = INTERFACE.stresses();
    let along = Along::of(time);

    let normal = Pair { name: pressure_name, colour: 0, across: &closure, up: pressure };
    let noise = (NEGLIGIBLE * most(&closure), NEGLIGIBLE * most(pressure));
    let mut planes = Vec::new();
    planes.extend(plane("closure", "pressure", [normal].into_iter(), noise));
    let tangential =
        (0..2).map(|i| Pair { name: shear_names[i], colour: i, across: &slip[i], up: &shear[i] });
    let noise = (NEGLIGIBLE * largest(&slip), NEGLIGIBLE * largest(&shear));
    planes.extend(plane("slip", "shear", tangential, noise));

    let (gaps, pressures) = (std::slice::from_ref(gap), std::slice::from_ref(pressure));
    let mut tracks = Vec::new();
    tracks.extend(courses(Quantity::new("gap", "m"), &[gap_name], gaps, true));
    tracks.extend(courses(Quantity::new("slip", "m"), &slip_names, &slip, true));
    tracks.extend(courses(Quantity::new("pressure", "Pa"), &[pressure_name], pressures, false));
    tracks.extend(courses(Quantity::new("shear", "Pa"), &shear_names, &shear, false));
    let drawn: Vec<&[f64]> =
        [gap, pressure].into_iter().chain(&slip).chain(&shear).map(Vec::as_slice).collect();
    tracks.extend(histories(response, &drawn));
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

/// Minus the gap. Where nothing is carried it ends a little beyond all that is: an open pair may be a thousand times as far
/// apart as it ever closes.
fn closure(gap: &[f64], pressure: &[f64]) -> Vec<f64> {
    let pairs = || gap.iter().zip(pressure);
    let reach = pairs().filter(|(_, p)| **p != 0.0).fold(0.0, |most, (g, _)| f64::max(most, g.abs()));
    pairs().map(|(&g, &p)| if p == 0.0 { -g.min(BEYOND * reach) } else { -g }).collect()
}

fn plane<'a>(
    across: &str,
    up: &str,
    pairs: impl Iterator<Item = Pair<'a>>,
    noise: (f64, f64),
) -> Option<Plane<'a>> {
    let curves = curves(pairs, noise);
    (!curves.is_empty()).then(|| Plane {
        across: Quantity::new(across, "m"),
        up: Quantity::new(up, "Pa"),
        curves,
        named: Named::HighestAndLowest,
    })
}

/// The history variables that vary; both tangents share a track. The flags of what it ever did are in the strips, and what
/// repeats a line that is drawn is left out.
fn histories<'a>(response: &'a InterfaceResponse, drawn: &[&[f64]]) -> Vec<Track<'a>> {
    let flags = [response.state, response.slid, response.opened];
    let repeats = |values: &[f64]| {
        drawn
            .iter()
            .any(|line| [1.0, -1.0].iter().any(|sign| values.iter().zip(*line).all(|(a, b)| *a == sign * b)))
    };
    let mut tracks: Vec<Track<'a>> = Vec::new();
    for (k, (column, values)) in response.columns.iter().zip(&response.history).enumerate() {
        if flags.contains(&k) || spread(values) == 0.0 || repeats(values) {
            continue;
        }
        let title = column.name.trim_end_matches(|c: char| c.is_ascii_digit());
        let quantity = Quantity::new(title, if column.unit == "1" { "" } else { column.unit });
        let at = tracks.iter().position(|t| t.quantity == quantity).unwrap_or_else(|| {
            tracks.push(Track { quantity, courses: Vec::new() });
            tracks.len() - 1
        });
        let courses = &mut tracks[at].courses;
        courses.push(Course { name: column.name.to_owned(), colour: courses.len(), values });
    }
    tracks
}

/// The states that it was ever in.
fn states(response: &InterfaceResponse) -> Option<(String, Vec<Strip>)> {
    let state = response.history.get(response.state)?;
    let strips = PairState::ALL.iter().enumerate().map(|(colour, s)| Strip {
        name: s.word().to_owned(),
        colour,
        on: state.iter().map(|x| *x == s.number()).collect(),
    });
    let strips: Vec<Strip> = strips.filter(|s| s.on.contains(&true)).collect();
    (!strips.is_empty()).then(|| ("state".to_owned(), strips))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pair_that_opens_wide_is_drawn_no_further_than_what_it_carries_needs() {
        let (gap, pressure) = ([0.0, -1.0, 0.5, 3.0, 100.0], [0.0, 2.0, -0.5, 0.0, 0.0]);
        assert_eq!(closure(&gap, &pressure), [0.0, 1.0, -0.5, -1.25, -1.25]);
        assert_eq!(closure(&gap[3..], &pressure[3..]), [0.0, 0.0]);
    }
}
