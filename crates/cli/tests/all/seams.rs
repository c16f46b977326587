//! A thin seam as an interface: as stiff as the layer that it stands for, as strong, and refused where it should be meshed.

use crate::stage_case::{code, errors, run, tremolite};
use std::path::Path;
use tremolite_mesh::boxes::{Axis, BoxSpec};
use tremolite_results::Summary;

/// Rock and seam: Young's modulus \[Pa\], Poisson's ratio.
const ROCK: [f64; 2] = [10e9, 0.25];
const CLAY: [f64; 2] = [100e6, 0.3];
const THICKNESS: f64 = 0.1;
/// A block of 2 × 1 × 4 m, by its section \[m²\] and its height \[m\].
const SECTION: f64 = 2.0;
const HEIGHT: f64 = 4.0;
const COHESION: f64 = 20e3;
const DENSITY: f64 = 2700.0;

/// The modulus of a layer that cannot widen, and that of shear.
fn moduli([young, poisson]: [f64; 2]) -> [f64; 2] {
    [young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson)), 0.5 * young / (1.0 + poisson)]
}

/// A block with the seam as an interface, elements of 0.5 m, the plane off their nodes.
const AS_INTERFACE: &str = r#"[mesh.box]
x = { to = 2, elements = 4 }
y = { to = 1, elements = 2 }
z = { to = 4, elements = 8 }
[[mesh.plane]]
name = "bedding"
through = [0, 0, 1.9]
dip = "0 deg"
dip_azimuth = "90 deg"
seam = { material = "clay", thickness = 0.1 }
[[monitor]]
name = "J"
at = [1, 0.5, 1.9]
interface = "bedding"
"#;

/// And with the seam meshed, two elements through it.
const MESHED: &str = "[mesh.file]\npath = \"block.vtu\"\n[[region]]\ngroups = [\"clay\"]\nmaterial = \"clay\"\nelement = \"full-integration\"\n";

fn meshed(folder: &Path) {
    let z = Axis::Coordinates(vec![0.0, 0.5, 1.0, 1.5, 1.85, 1.9, 1.95, 2.5, 3.0, 3.5, 4.0]);
    let spec = BoxSpec { x: Axis::uniform(0.0, 2.0, 4), y: Axis::uniform(0.0, 1.0, 2), z, distortion: None };
    let mut mesh = spec.mesh().unwrap();
    mesh.groups.clear();
    for e in 0..mesh.elements.len() {
        let z = mesh.elements[e].nodes().iter().map(|&n| mesh.nodes[n as usize][2]).sum::<f64>() / 8.0;
        let group = if (1.85..1.95).contains(&z) { "clay" } else { "rock" };
        mesh.groups.entry(group.to_owned()).or_default().push(e as u32);
    }
    tremolite_mesh::write(folder.join("block.vtu"), &mesh).unwrap();
}

/// A case of a mesh; all nodes are held but along `way`, the top is moved along it step by step.
fn case(mesh: &str, initial: &str, way: &str, to: &[f64]) -> String {
    let held: String =
        ["ux", "uy", "uz"].iter().filter(|u| **u != way).map(|u| format!(", {u} = 0")).collect();
    let groups: &[&str] = if mesh == MESHED { &["rock", "clay"] } else { &["rock"] };
    let hold: String = groups.iter().map(|g| format!("{{ group = \"{g}\"{held} }},")).collect();
    let stages: String = to
        .iter()
        .map(|to| format!("[[stage]]\nname = \"{to}\"\ndisplacement = [{{ name = \"jack\", face = \"top\", {way} = {to} }}, {hold}]\n"))
        .collect();
    let ([young, poisson], [soft, swelling]) = (ROCK, CLAY);
    format!(
        r#"title = "seam"
units = "SI"
{mesh}
[material.rock]
law = "elastic"
young = {young}
poisson = {poisson}
density = {DENSITY}
[material.clay]
law = "mohr-coulomb"
young = {soft}
poisson = {swelling}
cohesion = {COHESION}
friction_angle = "25 deg"
tensile_strength = 40e3
density = {DENSITY}
[[region]]
groups = ["rock"]
material = "rock"
element = "full-integration"
{initial}
{stages}"#
    )
}

/// The force on the top along `way` and the rows of the stages.
fn forces(folder: &Path, text: &str, way: &str) -> Vec<f64> {
    std::fs::write(folder.join("case.toml"), text).unwrap();
    let output = run(folder, "out", &["--overwrite"]);
    assert_eq!(code(&output), 0, "{}", errors(&output));
    let summary = Summary::read(&folder.join("out/summary.json")).unwrap();
    let reaction = format!("reaction_{}", &way[1..]);
    summary.computed.stages.iter().filter_map(|s| s.moved.get("jack")?.get(&reaction).copied()).collect()
}

const FREE: &str = "[initial]\nsides = \"free\"\ntolerance = 1e-6";

#[test]
fn a_thin_seam_gives_way_as_its_layer_does_in_compression_and_in_shear() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    meshed(at);
    for (k, way, to) in [(0, "uz", -1e-5), (1, "ux", 1e-5)] {
        let [rock, clay] = [moduli(ROCK)[k], moduli(CLAY)[k]];
        let exact = |rock_height: f64| SECTION * to / (rock_height / rock + THICKNESS / clay);
        let of = |mesh: &str| {
            // No strength but the layer's own: what is moved stays far below it.
            *forces(at, &case(mesh, FREE, way, &[to]), way).last().unwrap()
        };
        let [interface, layer] = [of(AS_INTERFACE), of(MESHED)];
        println!(
            "{way}: interface {interface:.3} N of {:.3} N, meshed {layer:.3} N of {:.3} N",
            exact(HEIGHT),
            exact(HEIGHT - THICKNESS)
        );
        // At rest to 10⁻⁶ of all contributions.
        assert!((interface / exact(HEIGHT) - 1.0).abs() < 1e-4, "{way}");
        assert!((layer / exact(HEIGHT - THICKNESS) - 1.0).abs() < 1e-4, "{way}");
        // The interface leaves the rock its full height: softer than the layer by the seam's thickness of rock, and by E/t it would be softer still.
        assert!(interface.abs() < layer.abs() && (interface / layer - 1.0).abs() < 0.01, "{way}");
    }
}

#[test]
fn a_thin_seam_slides_where_the_strength_of_its_rock_ends() {
    let folder = tempfile::tempdir().unwrap();
    let top = 1e6;
    let initial = format!(
        "[initial]\nsides = \"free\"\ntolerance = 1e-6\noverburden = {top}\nstress = {{ at = [0, 0, 4], zz = -{top}, gradient = {{ zz = {} }} }}",
        DENSITY * 9.81
    );
    let pressure = top + DENSITY * 9.81 * (HEIGHT - 1.9);
    let friction = 25_f64.to_radians().tan() * pressure;
    let strength = friction + COHESION;
    let compliance = HEIGHT / moduli(ROCK)[1] + THICKNESS / moduli(CLAY)[1];
    let ways = [0.99 * strength * compliance, 1.01 * strength * compliance];
    let text = case(AS_INTERFACE, &initial, "ux", &ways);
    let found = forces(folder.path(), &text, "ux");
    let [before, after] = found[found.len() - 2..] else { panic!("{found:?}") };
    println!(
        "before {before:.1} N, after {after:.1} N of {:.1} and {:.1}",
        0.99 * strength * SECTION,
        friction * SECTION
    );
    // Pairs begin with the mean of the stresses in the middle of the elements beside them, of 0.4 and 0.6 m: 0.05 m of weight off, 1.3·10⁻³.
    assert!((before / (0.99 * strength * SECTION) - 1.0).abs() < 1e-3);
    assert!((after / (friction * SECTION) - 1.0).abs() < 2e-3, "the bond of c is gone once it slides");
}

#[test]
fn seams_are_said_and_what_is_wrong_with_them_is_refused_at_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let sound = case(AS_INTERFACE, FREE, "uz", &[-1e-5]);
    let check = |text: &str| {
        std::fs::write(at.join("case.toml"), text).unwrap();
        tremolite(at, &["check", "case.toml", "--verbose"])
    };
    let output = check(&sound);
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(code(&output), 0, "{}", errors(&output));
    // M = 1.34615 E for ν = 0.3, over 0.1 m; G = E/2.6.
    for words in
        ["a seam of clay, 0.1 m thick", "1.346 GPa/m normal", "0.3846 GPa/m in shear", "a bond of 20 kPa"]
    {
        assert!(said.contains(words), "'{words}' in {said}");
    }
    assert!(said.contains("interface[bedding].normal_stiffness"), "{said}");
    assert!(!errors(&output).contains("no region is made of"), "{}", errors(&output));
    let twice = "[[interface]]\nname = \"other\"\nbetween = [\"bedding.above\", \"bedding.below\"]\nlaw = \"coulomb\"\nfriction_coefficient = 0.6\n[material.rock]";
    for (from, to, says, remedy) in [
        (
            "thickness = 0.1",
            "thickness = 0.4",
            "more than half of the elements beside it (0.60",
            "give its two walls as planes",
        ),
        (
            "material = \"clay\", t",
            "material = \"cly\", t",
            "there is no material `cly`",
            "did you mean \"clay\"?",
        ),
        (
            "material = \"clay\", t",
            "material = \"rock\", t",
            "and `rock` is `elastic`",
            "law = \"mohr-coulomb\"",
        ),
        ("material = \"clay\", t", "material = \"void\", t", "a seam of nothing", "name a material"),
        ("thickness = 0.1", "thickness = -0.1", "`thickness` must be above 0", "above 0"),
        (", thickness = 0.1", "", "`thickness` is missing", "thickness ="),
        ("[material.rock]", twice, "is between the groups of interface `bedding`", "keep one of the two"),
        (
            "interface = \"bedding\"",
            "interface = \"beding\"",
            "there is no interface `beding`",
            "did you mean \"bedding\"?",
        ),
        (
            "cohesion = 2",
            "dilation_angle = \"5 deg\"\ncohesion = 2",
            "cannot use dilation_angle of `clay`",
            "or mesh the seam",
        ),
    ] {
        assert!(sound.contains(from), "{from}");
        let output = check(&sound.replacen(from, to, 1));
        let words = errors(&output);
        let warned = says.contains("cannot use");
        assert_eq!(code(&output), if warned { 0 } else { 2 }, "{to}: {words}");
        assert!(
            words.contains(says) && words.contains(remedy) && words.contains("case.toml:"),
            "{to}: {words}"
        );
    }
}
