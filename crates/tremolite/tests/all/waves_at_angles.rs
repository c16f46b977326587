//! Waves at angles in cases: what is refused and where, files and checks, and what must be the same.

use crate::oblique::{SIZE, rock, worst};
use crate::ready::Ready;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use tremolite::Top;
use tremolite::free_field::GivenField;
use tremolite::job::{Caller, Given, Inputs, Job, Why};
use tremolite::run::Control;
use tremolite::simulation::Start;
use tremolite::waves::{Entering, Frame, Heading, LayeredGround, ObliqueField, Rock, Stratum, WaveType};
use tremolite_motion::{Channel, Complex64, Motion, ricker_velocity};
use tremolite_results::{ResultFolder, Summary, Table};

pub const CASE: &str = r#"title = "aslant"
[mesh.box]
x = { to = "40 m", elements = 8 }
y = { to = "30 m", elements = 6 }
z = { to = "40 m", elements = 8 }
group = "rock"
[material.rock]
law = "elastic"
young = "5 GPa"
poisson = 0.3
density = "2500 kg/m3"
[[region]]
groups = ["rock"]
material = "rock"
element = "reduced-integration"
[motion]
kind = "incident"
east = { file = "pulse.txt", units = "m/s2", dt = "0.005 s" }
processing = ["baseline"]
[[motion.wave]]
type = "SV"
angle = "25 deg"
azimuth = "30 deg"
component = "east"
[dynamic]
sides = "free-field"
duration = "0.5 s"
levels = 1
[[monitor]]
name = "A"
at = ["10 m", "10 m", "40 m"]
[[monitor]]
name = "B"
at = ["30 m", "10 m", "40 m"]
[output]
histories = "0.02 s"
"#;

/// A Ricker pulse of acceleration of 8 Hz \[m/s²\], every 0.005 s.
pub fn given() -> Given {
    let at = |k: i32| {
        let t = (std::f64::consts::PI * 8.0 * (0.005 * f64::from(k) - 0.15)).powi(2);
        (1.0 - 2.0 * t) * (-t).exp()
    };
    let samples = (0..80).map(at).collect();
    let records = [("pulse.txt".to_owned(), vec![Channel::new("pulse", 0.005, samples)])].into();
    Given { inputs: Inputs { records, ..Inputs::default() }, ..Given::default() }
}

fn job(text: &str) -> Job {
    Job::of_text(text, Path::new("."), &given()).unwrap_or_else(|fault| panic!("{fault}"))
}

/// What is said of a case that is refused.
fn refused(text: &str) -> String {
    let fault =
        Job::of_text(text, Path::new("."), &given()).err().unwrap_or_else(|| panic!("taken:\n{text}"));
    match &fault.why {
        Why::Case(report) => report.to_string(),
        _ => fault.to_string(),
    }
}

/// With another wave than that of [`CASE`].
fn with_waves(waves: &[(&str, &str, &str)]) -> String {
    let one = "type = \"SV\"\nangle = \"25 deg\"\nazimuth = \"30 deg\"";
    let table = |&(kind, angle, azimuth): &(&str, &str, &str)| {
        format!("type = \"{kind}\"\nangle = \"{angle} deg\"\nazimuth = \"{azimuth} deg\"")
    };
    let all: Vec<String> = waves.iter().map(table).collect();
    CASE.replace(one, &all.join("\ncomponent = \"east\"\n[[motion.wave]]\n"))
}

#[test]
fn what_cannot_be_is_refused_with_its_line_and_a_remedy() {
    let line = |text: &str, words: &str| 1 + text.lines().position(|line| line.contains(words)).unwrap();
    let sides = |word: &str| format!("sides = {{ x = \"{word}\", y = \"free-field\" }}");
    let soft = "[[mesh.box.part]]\ngroup = \"soft\"\nx = [\"0 m\", \"10 m\"]\ny = [\"10 m\", \"20 m\"]\nz = [\"10 m\", \"20 m\"]\n[material.rock]";
    let sides_of = |text: String, word: &str| text.replace("sides = \"free-field\"", &sides(word));
    let hole = CASE.replace("[material.rock]", &soft.replace("soft", "hole"));
    let hole = hole.replace("[motion]", "[[region]]\ngroups = [\"hole\"]\nmaterial = \"void\"\n[motion]");
    let clay = "[material.clay]\nlaw = \"elastic\"\nyoung = \"1 GPa\"\npoisson = 0.3\ndensity = \"2000 kg/m3\"\n\
                [[region]]\ngroups = [\"soft\"]\nmaterial = \"clay\"\nelement = \"reduced-integration\"\n[motion]";
    let lens = CASE.replace("[material.rock]", soft).replace("[motion]", clay);
    // A joint through the whole model, and round a block inside it.
    let jointed = |[from, to]: [&str; 2]| {
        let block = format!(
            "[[mesh.box.part]]\ngroup = \"block\"\nx = [\"{from} m\", \"{to} m\"]\ny = [\"10 m\", \"20 m\"]\nz = [\"15 m\", \"25 m\"]\n[material.rock]"
        );
        let joint = "[[interface]]\nname = \"joint\"\nbetween = [\"block\", \"rock\"]\nlaw = \"coulomb\"\nfriction_coefficient = 0.6\n[motion]";
        CASE.replace("[material.rock]", &block)
            .replace("groups = [\"rock\"]", "groups = [\"rock\", \"block\"]")
            .replace("[motion]", joint)
    };
    job(&jointed(["15", "25"]));
    let outcrop = |text: String| text.replace("kind = \"incident\"", "kind = \"outcrop\"");
    for (text, place, says) in [
        (CASE.replace("kind = \"incident\"", "kind = \"surface\""), "[[motion.wave]]", "straight up alone"),
        (
            CASE.replace("component = \"east\"", "component = \"north\""),
            "component = \"north\"",
            "no component 'north'",
        ),
        (
            CASE.replace("processing =", "up = { from = \"east\", factor = 0.5 }\nprocessing ="),
            "up = { from",
            "carries `up`",
        ),
        (CASE.replace("angle = \"25 deg\"", "angle = \"95 deg\""), "angle =", "must be from 0"),
        (
            CASE.replace("sides = \"free-field\"", "sides = \"viscous\""),
            "sides =",
            "through free-field sides alone",
        ),
        (CASE.replace("sides = \"free-field\"", "sides = \"fixed\""), "sides =", "do not move"),
        (sides_of(CASE.to_owned(), "periodic"), "sides =", "travels across the periodic sides across x"),
        (sides_of(CASE.to_owned(), "symmetry"), "sides =", "travels across the symmetry sides across x"),
        (sides_of(with_waves(&[("SH", "0", "0")]), "symmetry"), "sides =", "is not its own mirror image"),
        (sides_of(with_waves(&[("SV", "0", "90")]), "symmetry"), "sides =", "moves the ground along x"),
        (
            CASE.replace("processing =", "at = [\"-50000 m\", \"0 m\"]\nprocessing ="),
            "at =",
            "longer than the record lasts",
        ),
        (outcrop(with_waves(&[("P", "1", "0")])), "angle =", "0.0"),
        (outcrop(with_waves(&[("SV", "45", "0")])), "angle =", "tells nothing of it"),
        (
            CASE.replace("component = \"east\"", "component = \"east\"\nsurface_component = \"up\""),
            "surface_component =",
            "the incident wave itself",
        ),
        (jointed(["0", "10"]), "sides =", "let it end at x = 5.00 m"),
        (hole, "sides =", "let it end at x = 5.00 m"),
        (lens, "sides =", "other ground, y from 10.00 m to 20.00 m and z from 10.00 m to 20.00 m"),
        (
            CASE.replace("component = \"east\"", "component = \"east\"\nscale = 0"),
            "[[motion.wave]]",
            "carries nothing",
        ),
    ] {
        let said = refused(&text);
        assert!(said.contains(says), "{says}:\n{said}");
        assert!(said.contains(&format!(":{}:", line(&text, place))), "{place}:\n{said}");
    }
    // What no wave travels or moves across may be periodic or a mirror.
    for (text, word) in [
        (with_waves(&[("SV", "25", "0")]), "symmetry"),
        (with_waves(&[("P", "25", "180")]), "symmetry"),
        (with_waves(&[("SH", "25", "0")]), "periodic"),
        (with_waves(&[("SV", "25", "0")]), "periodic"),
    ] {
        job(&sides_of(text, word));
    }
}

#[test]
fn check_says_what_waves_are_over_the_component_and_by_how_much_they_are_late() {
    let words = |text: &str| job(text).motion.unwrap().entering().join("\n");
    let said = words(CASE);
    assert!(
        said.contains("SV at 25 deg towards 30 deg is 1.000 times 'east'")
            && said.contains("m/s along the ground"),
        "{said}"
    );
    assert!(!said.contains("critical"), "{said}");
    // ν = 0.3: SV beyond 32.3° is beyond critical.
    assert!(words(&with_waves(&[("SV", "50", "30")])).contains("beyond a critical angle"));
    // The surface doubles SH at any angle, and what goes straight up.
    for wave in [("SH", "60", "10"), ("SV", "0", "10")] {
        let text = with_waves(&[wave]).replace("kind = \"incident\"", "kind = \"outcrop\"");
        assert!(words(&text).contains("is 0.500 times 'east'"), "{wave:?}");
    }
}

/// One P, one SV and one SH wave at their angles with all components of a record.
fn together(kind: &str, angles: [&str; 3], azimuths: [&str; 3]) -> String {
    let of = |k: usize| [["P", "SV", "SH"][k], angles[k], azimuths[k]];
    let waves: Vec<[&str; 3]> = (0..3).map(of).collect();
    let waves: Vec<(&str, &str, &str)> = waves.iter().map(|[a, b, c]| (*a, *b, *c)).collect();
    let text = with_waves(&waves).replace("component = \"east\"", "component = \"together\"");
    let others =
        "north = { from = \"east\", factor = -0.7 }\nup = { from = \"east\", factor = 0.5 }\nprocessing =";
    text.replace("processing =", others).replace("kind = \"incident\"", &format!("kind = \"{kind}\""))
}

/// The bare rock of the base moves as recorded at the waves' common place; SV at 50° is beyond critical.
#[test]
fn a_p_an_sv_and_an_sh_wave_make_a_record_of_three_components_together() {
    for (kind, angles, azimuths, turned) in [
        ("outcrop", ["20", "25", "30"], ["30", "30", "30"], false),
        ("outcrop", ["10", "20", "40"], ["0", "75", "200"], false),
        ("outcrop", ["20", "50", "30"], ["30", "30", "30"], true),
        ("incident", ["10", "20", "40"], ["0", "75", "200"], false),
    ] {
        let made = job(&together(kind, angles, azimuths));
        let said = made.motion.as_ref().unwrap().entering().join("\n");
        assert!(said.contains("condition") && said.matches(" times 'north'").count() >= 2, "{said}");
        assert_eq!(said.contains("in phase"), turned, "{said}");
        let planned = made.plan.waves.as_ref().unwrap();
        // A film of rock with a free surface, or in full space.
        let (film, top) = (1e-3, if kind == "outcrop" { Top::Free } else { Top::Viscous });
        let stratum = Stratum { thickness: film, ..planned.frame.ground.strata()[0] };
        let frame = Frame {
            ground: LayeredGround::new([stratum], top).unwrap(),
            bounds: [[0.0; 3], [40.0, 30.0, film]],
            ..planned.frame.clone()
        };
        let field = ObliqueField::new(&frame, &planned.waves).unwrap();
        // x is east and y north.
        let record = &planned.waves[0].motion;
        let [at_x, at_y] = frame.at;
        let (mut worst, mut peak) = (0.0_f64, 0.0_f64);
        for k in 0..100 {
            let t = 0.004 * f64::from(k);
            let found = field.displacement([at_x, at_y, film], t + field.lead());
            for (found, given) in found.into_iter().zip(record.at(t).u) {
                worst = worst.max((found - given).abs());
                peak = peak.max(given.abs());
            }
        }
        assert!(worst < 2e-3 * peak, "{kind} {angles:?}: {}", worst / peak);
    }
}

#[test]
fn waves_that_cannot_carry_a_record_together_are_refused() {
    let [near, far] = [["20", "25", "30"], ["30", "30", "30"]];
    let good = together("outcrop", near, far);
    let two = good.replacen("type = \"SH\"", "type = \"SV\"", 1);
    assert!(refused(&two).contains("as one P, one SV and one SH wave"), "{}", refused(&two));
    let own = good.replacen("component = \"together\"", "component = \"east\"", 1);
    assert!(refused(&own).contains("as one P, one SV and one SH wave"));
    // P nearly along the ground and SV straight up move it alike.
    let level = together("incident", ["89", "0", "30"], ["30", "30", "30"]);
    assert!(refused(&level).contains("condition"), "{}", refused(&level));
}

/// A run's summary, monitors.csv and free_field.csv.
fn run(text: &str) -> (Summary, Table, Table) {
    let parent = tempfile::tempdir().unwrap();
    let folder = ResultFolder::create(Some(&parent.path().join("out")), "aslant", false).unwrap();
    let mut control = Control { stop: &AtomicBool::new(false), progress: &mut |_| {} };
    let (_, summary) = job(text).run(&folder, Start::Rest, &Caller::new("test"), &mut control).unwrap();
    (summary, Table::read(&folder.monitors()).unwrap(), Table::read(&folder.free_field()).unwrap())
}

/// Displacements of the monitors, by column.
fn moved(table: &Table) -> BTreeMap<String, Vec<f64>> {
    let names = ["A.ux", "A.uy", "A.uz", "B.ux", "B.uy", "B.uz"];
    names.iter().map(|name| ((*name).to_owned(), table.column(name).unwrap().to_vec())).collect()
}

/// Largest difference over the largest value.
fn apart(a: &BTreeMap<String, Vec<f64>>, b: &BTreeMap<String, Vec<f64>>) -> f64 {
    let most = a.values().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    let pairs = a.values().flatten().zip(b.values().flatten());
    pairs.fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs())) / most
}

#[test]
fn a_run_compares_its_corners_with_the_field_and_two_waves_are_their_sum() {
    // At one angle and azimuth they have one lead.
    let waves = [("SV", "25", "30"), ("SH", "25", "30")];
    let (summary, both, field) = run(&with_waves(&waves));
    let line = |id: &str| summary.soundness.checks.iter().find(|line| line.id == id).unwrap();
    let corners = line("free_field_at_model_edges");
    // Elements of 5 m are twelve a shear wave of 14 Hz.
    assert!(corners.pass && corners.value < 0.05 && corners.value > 1e-6, "{corners:?}");
    for id in ["input_drift", "truncated_motion", "energy_error", "hourglass_energy"] {
        assert!(line(id).pass && !line(id).not_applicable, "{:?}", line(id));
    }
    for name in ["xmin-ymin.top.vx", "model.xmin-ymin.surface.vx", "A.free_field.vz"] {
        assert!(field.column(name).is_some(), "{name}");
    }
    // The monitor lies on the surface of ground without works: it is the field's.
    let (a, free) = (both.column("A.vz").unwrap(), field.column("A.free_field.vz").unwrap());
    let peak = free.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    assert!(peak > 0.0 && a.iter().zip(free).all(|(a, b)| (a - b).abs() < 0.05 * peak));
    let [mut sum, other] = waves.map(|wave| moved(&run(&with_waves(&[wave])).1));
    let pairs = sum.values_mut().flatten().zip(other.values().flatten());
    pairs.for_each(|(sum, other)| *sum += other);
    assert!(apart(&moved(&both), &sum) < 1e-9, "{}", apart(&moved(&both), &sum));
    assert!(apart(&moved(&both), &other) > 0.1);
}

#[test]
fn model_and_azimuth_turned_together_and_mirror_images_are_the_same() {
    let at = |x_azimuth: &str, azimuth: &str, kind: &str| {
        let text = with_waves(&[(kind, "25", azimuth)]);
        moved(&run(&format!("model_x_azimuth = \"{x_azimuth} deg\"\n{text}")).1)
    };
    for kind in ["SV", "SH"] {
        let plain = at("90", "30", kind);
        // East is still the component, whatever the axes.
        let mut turned = at("130", "70", kind);
        assert!(apart(&plain, &turned) < 1e-9, "{kind}: {}", apart(&plain, &turned));
        // Across x: A and B change places, ux its sign; SH is the other way round.
        turned = at("90", "330", kind);
        let sign = if kind == "SH" { -1.0 } else { 1.0 };
        let mirrored: BTreeMap<String, Vec<f64>> = turned
            .into_iter()
            .map(|(name, values)| {
                let (monitor, axis) = name.split_at(1);
                let other = if monitor == "A" { "B" } else { "A" };
                let flip = if axis == ".ux" { -sign } else { sign };
                (format!("{other}{axis}"), values.into_iter().map(|u| flip * u).collect())
            })
            .collect();
        assert!(apart(&plain, &mirrored) < 1e-9, "{kind}: {}", apart(&plain, &mirrored));
    }
}

/// A field of two waves in the box of [`rock`].
pub fn two_waves(size: [f64; 3], body: &tremolite::Body, top: Top) -> ObliqueField {
    let rock = Rock::of(body, tremolite::Rayleigh::default());
    let ground = LayeredGround::new([Stratum { thickness: size[2], rock }], top).unwrap();
    let pulse = ricker_velocity(8.0, 0.2, 0.1);
    let motion = Arc::new(Motion::sampled(0.002, 0.5, |t| pulse(t).along([1.0, 0.0, 0.0])).unwrap());
    let wave = |kind, angle: f64, along| {
        Entering::of(Heading { kind, angle, along }, motion.clone(), 0, Complex64::from(1.0))
    };
    let frame = Frame {
        ground,
        bounds: [[0.0; 3], size],
        at: [0.5 * size[0], 0.5 * size[1]],
        frequency: 20.0,
        duration: Some(0.5),
    };
    let waves = [wave(WaveType::Sv, 0.4, [0.6, 0.8]), wave(WaveType::Sh, 0.7, [-0.8, 0.6])];
    ObliqueField::new(&frame, &waves).unwrap()
}

/// Nodes with steps of their own follow the field with those steps: what a coarser one does errs no more than with the finest.
#[test]
fn levels_of_steps_follow_the_field() {
    let problem = || {
        let mut problem = rock(4.0, Top::Free);
        let field = Arc::new(two_waves(SIZE, &problem.bodies[0], Top::Free));
        problem.free_field = Some(field.clone());
        (problem, field)
    };
    let (one, field) = problem();
    // With a fifth of the stable step all may be of the third level.
    let alone = worst(&Ready::new(one), 0.2, &|at, t| field.displacement(at, t), 0.4);
    let levelled = Ready::new(problem().0).levelled(|[_, _, z]| (z / 20.0) as u8);
    assert!(levelled.phase.beats.len() > 2);
    let several = worst(&levelled, 0.2, &|at, t| field.displacement(at, t), 0.4);
    assert!(alone < 1e-2 && several < 1.3 * alone, "{alone:e} {several:e}");
}

/// The record is the field's to the sample, wherever the waves have its time, and a run goes on until the last corner has had it.
#[test]
fn a_record_at_a_far_place_is_that_of_the_field_and_is_run_to_its_end() {
    // ρ = 2500 kg/m³, E = 5 GPa, ν = 0.3; 25° along azimuth 30°, x is east.
    let shear = (5e9 / 2.6 / 2500.0_f64).sqrt();
    let (sin, cos) = 25.0_f64.to_radians().sin_cos();
    let delay = |x: f64, y: f64| sin / shear * (0.5 * x + 0.75_f64.sqrt() * y);
    for (at, late) in [
        ("-300 m\", \"-500 m", delay(340.0, 530.0)),
        ("300 m\", \"500 m", 0.0),
        ("17 m\", \"11 m", delay(23.0, 19.0)),
    ] {
        let text = with_waves(&[("SH", "25", "30")])
            .replace("processing =", &format!("at = [\"{at}\"]\nprocessing ="))
            .replace("duration = \"0.5 s\"\n", "");
        let made = job(&text);
        let planned = made.plan.waves.as_ref().unwrap();
        let lead = planned.field.lead();
        assert!((planned.field.late() - late).abs() < 1e-9, "{}", planned.field.late());
        assert!(made.plan.duration > 0.395 + lead + late - 1e-9 && made.plan.duration < 0.41 + lead + late);
        let [from_x, from_y] = planned.frame.at;
        // The surface does twice what comes up, across (0.5, √¾).
        let [x, y, z] = [30.0, 10.0, 40.0];
        let later = delay(x - from_x, y - from_y) + z * cos / shear;
        let (mut worst, mut peak) = (0.0_f64, 0.0_f64);
        for k in 0..200 {
            let t = 0.0031 * f64::from(k) + later.max(0.0);
            let came = planned.incident.at(t - later).u;
            for (found, came) in planned.field.displacement([x, y, z], t).into_iter().zip(came) {
                worst = worst.max((found - 2.0 * came).abs());
                peak = peak.max(2.0 * came.abs());
            }
        }
        assert!(worst < 2e-3 * peak, "{at}: {}", worst / peak);
    }
    // What comes behind the end is told of, though the record is over by then where it is given.
    let short = CASE.replace("processing =", "at = [\"-300 m\", \"-500 m\"]\nprocessing =");
    let made = job(&short);
    let warned: Vec<String> = made.warnings().map(|warning| warning.message.clone()).collect();
    assert!(warned.iter().any(|warning| warning.contains("comes after this")), "{warned:?}");
}
