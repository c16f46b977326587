//! Specimens that stages pull and push, beside exact solutions, and what is refused of them.

use crate::stage_case::{code, errors, run, tremolite};
use std::path::Path;
use tremolite_results::{Status, Summary};

const YOUNG: f64 = 25.85e9;
const STRENGTH: f64 = 2.7e6;
const FRACTURE_ENERGY: f64 = 65.0;
/// Length of the elements \[m\], of which the middle one cracks.
const SIZE: f64 = 0.05;
const SECTION: f64 = 0.1 * 0.1;

/// A bar of so many elements along an axis, free at its sides, held at its lower end and moved at its upper one.
fn bar(folder: &Path, axis: usize, elements: usize, stages: &str) {
    let length = SIZE * elements as f64;
    let extent = |i: usize| match i == axis {
        true => format!("{{ to = {length}, elements = {elements} }}"),
        false => "{ to = 0.1, elements = 1 }".to_owned(),
    };
    let middle = SIZE * ((elements / 2) as f64);
    let low = ["xmin", "ymin", "base"];
    let hold: String = (0..3)
        .filter(|i| !(axis == 2 && *i == 2))
        .map(|i| format!("{{ face = \"{}\", {} = 0 }},", low[i], ["ux", "uy", "uz"][i]))
        .collect();
    let base = if axis == 2 { "roller" } else { "free" };
    let text = format!(
        r#"title = "bar"
[mesh.box]
group = "bar"
x = {x}
y = {y}
z = {z}
part = [{{ group = "crack", {along} = [{middle}, {end}] }}]
[material.sound]
law = "elastic"
young = {YOUNG}
poisson = 0
density = 2400
[material.concrete]
law = "concrete-damage"
young = {YOUNG}
poisson = 0
density = 2400
tensile_strength = {STRENGTH}
compressive_strength = 31e6
friction_angle = "37 deg"
fracture_energy = {FRACTURE_ENERGY}
residual_shear = 0.2
evolution = "exponential"
split = "compliance"
rate = "none"
[[region]]
groups = ["bar"]
material = "sound"
element = "full"
[[region]]
groups = ["crack"]
material = "concrete"
element = "full"
[initial]
sides = "free"
base = "{base}"
[[monitor]]
name = "M"
at = [0.05, 0.05, 0.05]
[[stage]]
name = "hold"
displacement = [{hold}]
{stages}
"#,
        x = extent(0),
        y = extent(1),
        z = extent(2),
        along = ["x", "y", "z"][axis],
        end = middle + SIZE,
    );
    std::fs::write(folder.join("case.toml"), text).unwrap();
}

fn pulled(axis: usize, to: f64, steps: usize) -> String {
    let (face, way) = (["xmax", "ymax", "top"][axis], ["ux", "uy", "uz"][axis]);
    format!(
        "[[stage]]\nname = \"pull\"\ndisplacement = {{ name = \"jaw\", face = \"{face}\", {way} = {to}, steps = {steps} }}"
    )
}

/// (way \[m\], force \[N\]) of each stage.
fn curve(summary: &Summary, axis: usize) -> Vec<(f64, f64)> {
    let (way, force) = (["ux", "uy", "uz"][axis], ["reaction_x", "reaction_y", "reaction_z"][axis]);
    summary.stages.iter().map(|stage| (stage.moved["jaw"][way], stage.moved["jaw"][force])).collect()
}

/// The force of the bar \[N\] at a way: all of it elastic but for the element that cracks (crack band, `bazant1983`).
fn exact(length: f64, way: f64) -> f64 {
    let cracking = STRENGTH / YOUNG;
    if way <= cracking * length {
        return SECTION * YOUNG * way / length;
    }
    let softening = FRACTURE_ENERGY / (STRENGTH * SIZE) - 0.5 * cracking;
    // The way grows as the stress falls, as long as the bar is shorter than E (G_f/f_t² − ½ h/E) + ….
    let way_at = |stress: f64| {
        let strain = cracking + softening * (STRENGTH / stress).ln();
        stress / YOUNG * (length - SIZE) + SIZE * strain
    };
    let (mut low, mut high) = (1e-6 * STRENGTH, STRENGTH);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if way_at(middle) > way { low = middle } else { high = middle }
    }
    SECTION * low
}

fn done(folder: &Path, out: &str) -> Summary {
    let ended = run(folder, out, &["--overwrite"]);
    assert_eq!(code(&ended), 0, "{}", errors(&ended));
    Summary::read(&folder.join(out).join("summary.json")).unwrap()
}

#[test]
fn a_bar_is_pulled_past_its_peak_along_the_exact_curve_whatever_its_axis_and_the_steps() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let (length, to) = (3.0 * SIZE, 60e-6);
    let peak = SECTION * STRENGTH;
    let mut along = Vec::new();
    for (axis, steps) in [(2, 30), (2, 60), (0, 30)] {
        bar(folder, axis, 3, &pulled(axis, to, steps));
        let found = curve(&done(folder, "out"), axis);
        assert_eq!(found.len(), steps + 2);
        let worst =
            found.iter().map(|&(way, force)| (force - exact(length, way)).abs() / peak).fold(0.0, f64::max);
        println!("axis {axis}, {steps} steps: off by {worst:.1e} of the peak");
        // Damage keeps what the way to rest passed beyond: 1.2·10⁻³ of the peak in 30 steps, 0.7·10⁻³ in 60, of order 1.
        assert!(worst < 2e-3, "axis {axis}, {steps} steps: {worst}");
        along.push(found);
    }
    let table = std::fs::read_to_string(folder.join("out/stages.csv")).unwrap();
    let header = table.lines().next().unwrap();
    assert!(header.ends_with("jaw.ux [m],jaw.reaction_x [N]"), "{header}");
    for ((_, up), (_, aside)) in along[0].iter().zip(&along[2]) {
        assert!((up - aside).abs() < 2e-3 * peak, "{up} {aside}");
    }
}

#[test]
fn a_bar_that_holds_more_than_its_crack_takes_snaps_back_and_is_refused_with_its_rows_kept() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let critical = YOUNG * FRACTURE_ENERGY / (STRENGTH * STRENGTH);
    // Nine elements are 1.95 times as long as may be, three 0.65 times.
    assert!((9.0 * SIZE / critical - 1.95).abs() < 0.01);
    bar(folder, 2, 9, &pulled(2, 90e-6, 45));
    let ended = run(folder, "out", &[]);
    assert_eq!(code(&ended), 1);
    let summary = Summary::read(&folder.join("out/summary.json")).unwrap();
    assert_eq!(summary.status, Status::Failed);
    assert!(summary.verdict.contains("the specimen snapped back"), "{}", summary.verdict);
    // What was before the peak stands.
    let rows = curve(&summary, 2);
    let at_peak = STRENGTH / YOUNG * 9.0 * SIZE;
    let last = rows.last().unwrap();
    assert!(last.0 <= at_peak && last.0 > at_peak - 2.1e-6, "{last:?} of {at_peak}");
    for (way, force) in rows {
        assert!((force - exact(9.0 * SIZE, way)).abs() < 2e-3 * SECTION * STRENGTH, "{way} {force}");
    }
    assert!(folder.join("out/report.html").exists());
}

#[test]
fn a_negative_pressure_pulls() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    bar(folder, 2, 3, "[[stage]]\nname = \"pull\"\npressure = { top = \"-1 MPa\" }");
    let summary = done(folder, "out");
    let pull = &summary.stages[2].monitors["M"];
    assert!((pull["s1"].unwrap() - 1e6).abs() < 1e2, "{pull:?}");
    assert!((pull["uz"].unwrap() - 1e6 / YOUNG * 0.05).abs() < 1e-3 * 1e6 / YOUNG * 0.05, "{pull:?}");
    // The second stage held two faces; none of them is pushed by what pulls along z.
    for hold in ["xmin", "ymin"] {
        let forces = &summary.stages[2].moved[hold];
        assert!(forces.values().all(|x| x.abs() < 1.0), "{forces:?}");
    }
}

#[test]
fn displacements_that_mean_no_node_or_one_twice_are_refused_at_their_place() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for (stage, message, remedy) in [
        ("displacement = { face = \"tip\", uz = 0 }", "the mesh has no face 'tip'", "did you mean 'top'?"),
        (
            "displacement = { group = \"bra\", uz = 0 }",
            "no group of the mesh fits 'bra'",
            "did you mean 'bar'?",
        ),
        (
            "displacement = { group = \"bar\", within = { z = [0.06, 0.07] }, uz = 0 }",
            "'bar' means no node of what is there",
            "widen `within`",
        ),
        (
            "displacement = [{ face = \"top\", uz = 0 }, { name = \"edge\", group = \"bar\", uz = 0 }]",
            "'edge' and 'top' hold the same component of a node",
            "let their nodes differ",
        ),
    ] {
        bar(folder, 2, 3, &format!("[[stage]]\nname = \"wrong\"\n{stage}"));
        let checked = tremolite(folder, &["check", "case.toml"]);
        let said = errors(&checked);
        assert_eq!(code(&checked), 2, "{said}");
        assert!(said.contains(message) && said.contains(remedy) && said.contains("case.toml:"), "{said}");
    }
}
