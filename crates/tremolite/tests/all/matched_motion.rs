//! Motions of a case that a step fits to its target: where they fit, what follows, what is refused.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::path::Path;
use tremolite::job::{Given, Inputs, Job, Why};
use tremolite_motion::{Channel, TargetSpectrum, misfit};

const TARGET: &str = "EN 1998-1 type 1 ground B 1 m/s2";
const BAND: [f64; 2] = [0.2, 1.5];

const CASE: &str = r#"title = "matched"
[mesh.box]
x = { to = "40 m", elements = 2 }
y = { to = "40 m", elements = 2 }
z = { to = "60 m", elements = 3 }
group = "rock"
[material.rock]
law = "elastic"
young = "20 GPa"
poisson = 0.25
density = "2600 kg/m3"
[[region]]
groups = ["rock"]
material = "rock"
element = "reduced-integration"
[motion]
kind = "outcrop"
east = { file = "record.txt" }
up = { from = "east", factor = 0.6 }
target = "EN 1998-1 type 1 ground B 1 m/s2"
processing = ["taper 1 s", "baseline", "match 0.2 s 1.5 s"]
[dynamic]
sides = "periodic"
"#;

/// Waves of many frequencies, of phases that look random, under an envelope of 16 s.
fn given() -> Given {
    let at = |k: u32| {
        let t = 0.01 * f64::from(k);
        let wave = |i: u32| {
            let hertz = 0.3 * (i as f64 * 0.09).exp();
            (TAU * hertz * t + 2.4 * f64::from(i * i)).sin() * hertz.sqrt()
        };
        (-((t - 7.0) / 4.0).powi(2)).exp() * (0..42).map(wave).sum::<f64>() * 0.1
    };
    let record = Channel::new("record", 0.01, (0..1600).map(at).collect());
    let records = BTreeMap::from([("record.txt".to_owned(), vec![record])]);
    Given {
        inputs: Inputs { records: records.into_iter().collect(), ..Inputs::default() },
        ..Given::default()
    }
}

fn job(text: &str) -> Job {
    Job::of_text(text, Path::new("."), &given()).unwrap_or_else(|fault| panic!("{fault}"))
}

fn refused(text: &str) -> String {
    let fault =
        Job::of_text(text, Path::new("."), &given()).err().unwrap_or_else(|| panic!("taken:\n{text}"));
    match &fault.why {
        Why::Case(report) => report.to_string(),
        _ => fault.to_string(),
    }
}

fn off(acceleration: &[f64], dt: f64) -> f64 {
    misfit(acceleration, dt, &TargetSpectrum::parse_code(TARGET).unwrap(), BAND).unwrap().largest
}

#[test]
fn a_step_of_processing_fits_the_motion_to_the_target_and_what_is_made_of_it_follows() {
    let made = job(CASE);
    let given = made.plan.shaken_by(&made.model).unwrap();
    let [east, _, up] = &given.acceleration;
    assert!(off(east, given.dt) <= 0.05, "{}", off(east, given.dt));
    for (a, b) in east.iter().zip(up) {
        assert!((0.6 * a - b).abs() < 1e-12);
    }
    // Drawn on the page: the corners of the spectrum.
    let target = made.plan.target.as_ref().unwrap();
    assert!(target.sa.iter().any(|sa| (sa - 1.2 * 2.5).abs() < 1e-9));
    // Without the step it is far from it, whatever its size.
    let plain = job(&CASE.replace(", \"match 0.2 s 1.5 s\"", ""));
    let given = plain.plan.shaken_by(&plain.model).unwrap();
    let least = (1..60).map(|k| {
        let times = 0.1 * f64::from(k);
        off(&given.acceleration[0].iter().map(|a| times * a).collect::<Vec<_>>(), given.dt)
    });
    assert!(least.fold(f64::INFINITY, f64::min) > 0.15);
}

/// Down through soil that softens and up again: what comes out at the surface has the spectrum that was asked for there.
#[test]
fn a_matched_motion_of_the_surface_comes_out_there_again() {
    let soil = "kind = \"surface\"\nsite.layers = [\n  { thickness = \"4 m\", shear_wave_velocity = \"220 m/s\", poisson = 0.4, density = \"1900 kg/m3\", \
                vucetic_dobry = 15 },\n  { thickness = \"6 m\", shear_wave_velocity = \"380 m/s\", poisson = 0.4, density = \"2000 kg/m3\", \
                vucetic_dobry = 30 },\n]";
    let made = job(&CASE.replace("kind = \"outcrop\"", soil));
    let site = made.motion.as_ref().unwrap().site.as_ref().unwrap();
    assert!(site.soil.iter().all(|soil| soil.modulus < 0.97), "{:?}", site.soil);
    let wave = made.plan.shaken_by(&made.model).unwrap();
    let incident = |t: f64| wave.acceleration[0].get((t / wave.dt).round() as usize).copied().unwrap_or(0.0);
    let [top, base] = site.place.columns[0].velocities(incident, wave.dt, wave.duration());
    assert!(off(&top, wave.dt) < 0.06, "{}", off(&top, wave.dt));
    // At the base it is another motion.
    assert!(off(&base, wave.dt) > 0.15, "{}", off(&base, wave.dt));
}

#[test]
fn what_cannot_be_matched_is_refused_at_its_place() {
    let line = |text: &str, words: &str| 1 + text.lines().position(|line| line.contains(words)).unwrap();
    let none = CASE.replace("target = \"EN 1998-1 type 1 ground B 1 m/s2\"\n", "");
    let unknown = CASE.replace("EN 1998-1 type 1 ground B", "NB 35047");
    let upright = CASE.replace("up = { from = \"east\", factor = 0.6 }", "up = { file = \"record.txt\" }");
    let short = CASE
        .replace("match 0.2 s 1.5 s", "match 0.2 s 3.9 s")
        .replace("processing =", "window = [\"0 s\", \"7 s\"]\nprocessing =");
    let turned = CASE.replace("match 0.2 s 1.5 s", "match 1.5 s 0.2 s");
    let beyond = CASE.replace("match 0.2 s 1.5 s", "match 0.2 s 6 s");
    for (text, place, says) in [
        (none, "processing =", "no target that it could be matched to"),
        (unknown, "target =", "not a spectrum that is known by its words"),
        (upright, "up = {", "has none for a vertical record"),
        (short, "processing =", "less than twice the longest period"),
        (turned, "processing =", "the shorter period comes first"),
        (beyond, "processing =", "reaches beyond"),
    ] {
        let said = refused(&text);
        assert!(said.contains(says), "{says}:\n{said}");
        assert!(said.contains(&format!(":{}:", line(&text, place))), "{place}:\n{said}");
    }
}
