//! Numbers that can be computed with and are hardly meant: slips of units and of a decimal point.

use super::facts::largest;
use std::ops::RangeInclusive;
use tremolite_case::{self as case, Case, Diagnostic, Mesh, Spanned};
use tremolite_mesh as mesh;
use tremolite_motion::{Motion, STANDARD_GRAVITY};

/// Extent of a model \[m\] beyond that of any underground complex with the rock around it.
const MODEL: f64 = 5e3;
/// Width and height of a cavern \[m\]: hardly a hall in rock is wider, and the highest powerhouses have some 90 m.
const WIDTH: f64 = 60.0;
const HEIGHT: f64 = 100.0;
/// Rock above a cavern \[m\].
const OVERBURDEN: f64 = 3e3;
/// Thickness of a lining \[m\].
const LINING: RangeInclusive<f64> = 0.05..=5.0;
/// Peak acceleration of strong motions \[g\].
const PEAK: RangeInclusive<f64> = 0.02..=2.0;
/// Time between samples of a record of strong motion \[s\].
const INTERVAL: RangeInclusive<f64> = 1e-3..=50e-3;
/// Time that a run may go on behind its motion \[s\]: a cavern has come to rest long before.
const BEHIND: f64 = 10.0;

/// Largest extent of a mesh along an axis \[m\].
pub fn extent(mesh: &mesh::Mesh) -> f64 {
    let (low, high) = mesh.bounds();
    (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max)
}

/// Of lengths of the mesh.
pub fn lengths(case: &Case, mesh: &mesh::Mesh) -> Vec<Diagnostic> {
    [sizes(case, extent(mesh)), linings(case)].concat()
}

/// Of the size of the model, whose largest `extent` is this many metres, and of its openings.
pub fn sizes(case: &Case, extent: f64) -> Vec<Diagnostic> {
    let (place, unit) = match &case.mesh {
        Mesh::Caverns(caverns) => {
            (caverns.span.clone(), "look at the units of `sides`, `length`, `below` and `overburden`")
        }
        Mesh::Box(given) => (given.span.clone(), "look at the units of `from` and `to`"),
        Mesh::File(file) => (
            file.path.span.clone(),
            "if the file's coordinates are not in metres say so: unit = \"1 mm\" beside `path`",
        ),
    };
    let mut all = Vec::new();
    if extent > MODEL {
        let message = format!(
            "the model is {:.1} km across; an underground complex with the rock around it is less than {:.0} km",
            1e-3 * extent,
            1e-3 * MODEL
        );
        all.push(Diagnostic::new(place, message, unit));
    }
    let Mesh::Caverns(caverns) = &case.mesh else { return all };
    let above = &caverns.overburden;
    if above.value > OVERBURDEN {
        let message =
            format!("{:.0} m of rock lie above the crown, more than above any power station", above.value);
        all.push(Diagnostic::at(
            above,
            message,
            "look at its unit; for ground above the model give its pressure, `overburden` of [initial]",
        ));
    }
    for cavern in &caverns.caverns {
        let sizes = [(&cavern.width, WIDTH, "wide"), (&cavern.height, HEIGHT, "high")];
        for (size, most, word) in sizes.into_iter().filter(|(size, most, _)| size.value > *most) {
            let message = format!(
                "'{}' is {:.0} m {word}; caverns are less than {most:.0} m",
                cavern.name.value, size.value
            );
            all.push(Diagnostic::at(size, message, "look at its unit"));
        }
    }
    all
}

/// Of the thickness of linings.
fn linings(case: &Case) -> Vec<Diagnostic> {
    let Mesh::Caverns(caverns) = &case.mesh else { return Vec::new() };
    let mut all = Vec::new();
    for cavern in &caverns.caverns {
        let lining = cavern.lining.iter().flat_map(|lining| [&lining.walls, &lining.crown, &lining.floor]);
        // 0 is none.
        let odd = |thick: &&Spanned<f64>| thick.value > 0.0 && !LINING.contains(&thick.value);
        for thick in lining.filter(odd) {
            let message = format!("a lining of {} m, where linings are 0.05 to 5 m thick", thick.value);
            all.push(Diagnostic::at(thick, message, "look at its unit"));
        }
    }
    all
}

/// Of a record as it is processed, in the model's axes.
pub fn record(written: &case::Motion, given: &Motion) -> Vec<Diagnostic> {
    let mut all = Vec::new();
    let peak = given.acceleration.iter().map(|a| largest(a)).fold(0.0, f64::max);
    let in_g = peak / STANDARD_GRAVITY;
    if !PEAK.contains(&in_g) {
        let message = format!(
            "the processed motion reaches {peak:.3} m/s2, {in_g:.4} g; earthquakes that matter to a cavern reach {} to {} g",
            PEAK.start(),
            PEAK.end()
        );
        let remedy = "look at `units` of the components (a record in g that is read as m/s2 is ten times too weak) and at \"scale\"";
        all.push(Diagnostic::new(written.span.clone(), message, remedy));
    }
    if !INTERVAL.contains(&given.dt) {
        let message = format!(
            "the samples are {} s apart, where records of strong motion have 0.001 to 0.05 s",
            given.dt
        );
        all.push(Diagnostic::new(
            written.span.clone(),
            message,
            "look at the column of times or the rate of sampling of the files",
        ));
    }
    all
}

/// Of a run that goes on long after its motion.
pub fn duration(case: &Case, wave: &Motion) -> Option<Diagnostic> {
    let duration = case.dynamic.duration.as_ref()?;
    (duration.value > wave.duration() + BEHIND).then(|| {
        let message = format!(
            "the motion ends after {:.2} s, and the run goes on for another {:.2} s",
            wave.duration(),
            duration.value - wave.duration()
        );
        Diagnostic::at(duration, message, "leave `duration` out: it is then that of the motion")
    })
}
