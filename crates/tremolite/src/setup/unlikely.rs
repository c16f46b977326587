//! Numbers that can be computed with and are hardly meant: slips of units and of a decimal point.

use super::facts::largest;
use indexmap::IndexMap;
use std::ops::RangeInclusive;
use tremolite_case::{self as case, Case, Diagnostic, Mesh, Spanned, units};
use tremolite_laws::Dimension;
use tremolite_mesh as mesh;
use tremolite_motion::{Motion, STANDARD_GRAVITY};
use tremolite_results::MaterialFacts;

/// Acceleration of gravity on Earth \[m/s²\], rounded values included.
const GRAVITY: RangeInclusive<f64> = 9.7..=10.0;
/// Density of ground and concrete \[kg/m³\]: from peat to ores.
const DENSITY: RangeInclusive<f64> = 1000.0..=4000.0;
/// Weight of a metre of rock \[Pa\].
const ROCK: f64 = 27e3;
/// Pressure on the top of a model \[Pa\]: of half a metre of soil and of rock 3 km thick, [`OVERBURDEN`].
const PRESSURE: RangeInclusive<f64> = 1e4..=ROCK * OVERBURDEN;
/// f_t over f_c of concrete: 0.05 for C90 to 0.08 for C12 (`mc2010`, table 5.1-3), with room for what cohesion and friction make of f_c.
const CONCRETE_TENSION: RangeInclusive<f64> = 0.02..=0.25;
/// The same of rock, which may have no tensile strength. An assumption: tests of rock lie below 0.2, fitted envelopes higher.
const ROCK_TENSION: RangeInclusive<f64> = 0.0..=0.5;
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

/// Of gravity, of what lies on the model, and of densities and strengths. Densities are left to a second look where gravity, by which
/// unit weights are divided, is no gravity.
pub fn physics(case: &Case, materials: &IndexMap<String, MaterialFacts>) -> Vec<Diagnostic> {
    let mut all = Vec::new();
    let gravity = &case.initial.gravity;
    // 0 is none.
    let odd_gravity = gravity.value != 0.0 && !GRAVITY.contains(&gravity.value);
    if odd_gravity {
        all.push(Diagnostic::at(
            gravity,
            format!(
                "gravity: {} m/s2 (usual {} to {}); unit weights are divided by it",
                gravity.value,
                GRAVITY.start(),
                GRAVITY.end()
            ),
            "look at its unit; on Earth it is 9.81 m/s2",
        ));
    }
    if let Some(pressure) = &case.initial.overburden
        && !PRESSURE.contains(&pressure.value)
    {
        all.push(Diagnostic::at(
            pressure,
            format!(
                "overburden: {} (usual {} to {}), the weight of about {:.3e} m of rock",
                pressure_in_words(pressure.value),
                pressure_in_words(*PRESSURE.start()),
                pressure_in_words(*PRESSURE.end()),
                pressure.value / ROCK
            ),
            "look at its unit",
        ));
    }
    for material in &case.materials {
        let density = &material.density;
        if !odd_gravity && !DENSITY.contains(&density.value) {
            all.push(Diagnostic::at(
                density,
                format!(
                    "density of '{}': {:.0} kg/m3 (usual {} to {})",
                    material.name.value,
                    density.value,
                    DENSITY.start(),
                    DENSITY.end()
                ),
                "look at its unit: `density` in kg/m3 or g/cm3, `unit_weight` in kN/m3",
            ));
        }
        all.extend(materials.get(&material.name.value).and_then(|facts| tensile_strength(material, facts)));
    }
    all
}

/// A pressure to four digits.
fn pressure_in_words(pressure: f64) -> String {
    units::format(format!("{pressure:.3e}").parse().unwrap_or(pressure), Dimension::PRESSURE)
}

/// Of a tensile strength beside the compressive one: as given, though a law may use less.
fn tensile_strength(material: &case::Material, facts: &MaterialFacts) -> Option<Diagnostic> {
    let value = |name: &str| facts.values.iter().find(|value| value.name == name).map(|value| value.value);
    let (tension, pressure) = (value("tensile_strength")?, value("compressive_strength")?);
    let usual = if facts.law.starts_with("concrete") { CONCRETE_TENSION } else { ROCK_TENSION };
    let ratio = tension / pressure;
    (pressure > 0.0 && !usual.contains(&ratio)).then(|| {
        Diagnostic::new(
            material.span.clone(),
            format!(
                "tensile strength of '{}': {}, {ratio:.3} of the compressive strength {} (usual {} to {})",
                material.name.value,
                pressure_in_words(tension),
                pressure_in_words(pressure),
                usual.start(),
                usual.end()
            ),
            "look at the units of tensile_strength, cohesion and compressive_strength",
        )
    })
}

/// Of a record as it is processed, in the model's axes.
pub fn record(written: &case::Motion, given: &Motion) -> Vec<Diagnostic> {
    let mut all = Vec::new();
    let peak = given.acceleration.iter().map(|a| largest(a)).fold(0.0, f64::max);
    let in_g = peak / STANDARD_GRAVITY;
    if peak == 0.0 {
        all.push(Diagnostic::new(
            written.span.clone(),
            "motion: 0 m/s2 everywhere, so the run tests whether the model stays at rest",
            "nothing, if that is meant; else look at the records, `window` and \"scale\"",
        ));
    } else if !PEAK.contains(&in_g) {
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
