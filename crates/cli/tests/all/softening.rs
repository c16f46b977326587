//! Softening of a layer under a pulse and of a specimen against the element size, and what `check` says of it.

use crate::stage_case::{code, errors, run, tremolite, write_ricker};
use std::path::Path;
use tremolite_results::{Summary, Table};

/// A column of 48 m with a layer of 8 m that softens, under a pulse of 2 Hz from below (a Ricker wavelet of 6 m/s² at the outcrop).
fn column(folder: &Path, elements: usize, softening: &str) {
    write_ricker(folder);
    let text = format!(
        r#"title = "column with a layer that softens"
[mesh.box]
group = "rock"
x = {{ to = "2 m", elements = 1 }}
y = {{ to = "2 m", elements = 1 }}
z = {{ from = "-48 m", to = "0 m", elements = {elements} }}
part = [{{ group = "weak", z = ["-24 m", "-16 m"] }}]
[material.rock]
law = "elastic"
young = "3 GPa"
poisson = 0.3
unit_weight = "25 kN/m3"
[material.weak]
law = "mohr-coulomb"
young = "0.4 GPa"
poisson = 0.3
unit_weight = "20 kN/m3"
cohesion = "150 kPa"
friction_angle = "20 deg"
tensile_strength = "10 kPa"
softening = {softening}
[[region]]
groups = ["rock"]
material = "rock"
element = "reduced-integration"
[[region]]
groups = ["weak"]
material = "weak"
element = "reduced-integration"
[initial]
lateral = 0.7
[motion]
kind = "outcrop"
east = {{ file = "ricker2.txt" }}
processing = ["scale 3"]
[dynamic]
base = "viscous-spring"
sides = "periodic"
[[monitor]]
name = "top"
at = ["0 m", "0 m", "0 m"]
[output]
snapshots = "none"
histories = "0.02 s"
"#
    );
    std::fs::write(folder.join("case.toml"), text).unwrap();
}

const BY_STRAIN: &str = r#"{ plastic_shear_strain = [0, 0.01], cohesion = ["150 kPa", "5 kPa"] }"#;
const BY_SLIP: &str =
    r#"{ plastic_shear_displacement = ["0 mm", "20 mm"], cohesion = ["150 kPa", "5 kPa"] }"#;

/// Over strain, with a relaxation time \[ms\].
fn relaxing(time: f64) -> String {
    format!("{BY_STRAIN}\nrelaxation_time = \"{time} ms\"")
}

/// By how much the top has moved for good \[mm\].
fn left(folder: &Path) -> f64 {
    let ended = run(folder, "out", &["--overwrite"]);
    assert_eq!(code(&ended), 0, "{}", errors(&ended));
    let table = Table::read(&folder.join("out/monitors.csv")).unwrap();
    1e3 * table.column("top.ux").unwrap().last().unwrap().abs()
}

/// Slip \[mm\] of the layer in elements of 4, 2, 1 and 0.5 m.
fn slips(folder: &Path, softening: &str) -> [f64; 4] {
    [12, 24, 48, 96].map(|elements| {
        column(folder, elements, softening);
        left(folder)
    })
}

/// The row of this name in a table of `docs/laws.md`.
fn documented<const N: usize>(name: &str) -> [f64; N] {
    let laws = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/laws.md")).unwrap();
    let row = laws.lines().find(|line| line.starts_with(&format!("| {name} |"))).unwrap();
    let numbers: Vec<f64> = row.split('|').filter_map(|cell| cell.trim().parse().ok()).collect();
    numbers.try_into().unwrap()
}

#[test]
fn the_slip_of_a_layer_that_softens_with_a_relaxation_time_does_not_depend_on_the_mesh() {
    let folder = tempfile::tempdir().unwrap();
    for time in [1.0, 2.0] {
        let found = slips(folder.path(), &relaxing(time));
        println!("{time} ms: {found:.2?} mm");
        let finest = found[3];
        assert!(finest > 5.0);
        for slip in found {
            assert!((slip / finest - 1.0).abs() < 0.05, "{time} ms: {found:?}");
        }
    }
}

#[test]
fn the_slip_of_a_softening_layer_is_the_documented_one_with_its_dependence_on_the_mesh() {
    let folder = tempfile::tempdir().unwrap();
    let rows = [
        ("over strain", BY_STRAIN.to_owned()),
        ("over displacement", BY_SLIP.to_owned()),
        ("over strain, τ = 1 ms", relaxing(1.0)),
    ];
    for (name, softening) in rows {
        let found = slips(folder.path(), &softening);
        println!("{name}: {found:.2?} mm");
        for (found, told) in found.into_iter().zip(documented::<4>(name)) {
            assert!((found - told).abs() <= 0.051, "{name}: {found} {told}");
        }
    }
}

/// A specimen of 0.5 m × 1 m in plane strain that is shortened by 12 mm, with a weaker corner in elements of 100 mm over `finer`.
fn specimen(folder: &Path, finer: usize, measure: &str) {
    let material = |name: &str, cohesion: f64| {
        format!(
            r#"[material.{name}]
law = "mohr-coulomb"
young = 1e9
poisson = 0.25
density = 2400
cohesion = {cohesion}
friction_angle = "30 deg"
tensile_strength = 1e6
softening = {{ {measure}, cohesion = [{cohesion}, 0.2e6] }}
[[region]]
groups = ["{name}"]
material = "{name}"
element = "reduced-integration"
"#
        )
    };
    let text = format!(
        r#"title = "biaxial specimen that softens"
units = "SI"
[mesh.box]
group = "rock"
x = {{ to = 0.5, elements = {} }}
y = {{ to = 0.1, elements = 1 }}
z = {{ to = 1.0, elements = {} }}
part = [{{ group = "weak", x = [0.0, 0.1], z = [0.4, 0.5] }}]
{}{}
[initial]
sides = "free"
base = "roller"
[[stage]]
name = "push"
displacement = [
    {{ face = "ymin", uy = 0 }},
    {{ face = "ymax", uy = 0 }},
    {{ face = "base", within = {{ x = [0, 0.001] }}, ux = 0 }},
    {{ name = "jaw", face = "top", uz = -0.012, steps = 30 }},
]
"#,
        5 * finer,
        10 * finer,
        material("rock", 1e6),
        material("weak", 0.9e6)
    );
    std::fs::write(folder.join("case.toml"), text).unwrap();
}

/// Peak of the axial stress \[MPa\] and the work past it, over the section \[MPa mm\].
fn peak_and_work(folder: &Path) -> [f64; 2] {
    let ended = run(folder, "out", &["--overwrite"]);
    assert_eq!(code(&ended), 0, "{}", errors(&ended));
    let summary = Summary::read(&folder.join("out/summary.json")).unwrap();
    let moved = summary.computed.stages.iter().filter_map(|stage| stage.moved.get("jaw"));
    let curve: Vec<[f64; 2]> = moved.map(|jaw| [-1e3 * jaw["uz"], jaw["reaction_z"] / -0.05e6]).collect();
    let peak = (0..curve.len()).max_by(|&a, &b| curve[a][1].total_cmp(&curve[b][1])).unwrap();
    let work = curve[peak..]
        .windows(2)
        .map(|pair| 0.5 * (pair[1][0] - pair[0][0]) * (pair[0][1] + pair[1][1]))
        .sum();
    [curve[peak][1], work]
}

#[test]
fn peak_and_work_of_a_specimen_that_softens_over_displacement_are_the_documented_ones_on_three_meshes() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let found = [1, 2, 4].map(|finer| {
        specimen(folder, finer, "plastic_shear_displacement = [0, 10e-3]");
        peak_and_work(folder)
    });
    println!("peak [MPa] and work [MPa mm]: {found:.3?}");
    let told = [documented::<3>("peak over displacement"), documented::<3>("work over displacement")];
    for (k, [peak, work]) in found.into_iter().enumerate() {
        assert!(
            (peak - told[0][k]).abs() <= 0.0051 && (work - told[1][k]).abs() <= 0.051,
            "{k}: {peak} {work}"
        );
        assert!(
            (peak / found[2][0] - 1.0).abs() < 0.03 && (work / found[2][1] - 1.0).abs() < 0.1,
            "{found:?}"
        );
    }
    // Over strain a finer mesh dissipates less; in elements of 100 mm both tables are the same.
    specimen(folder, 4, "plastic_shear_strain = [0, 0.05]");
    let [_, work] = peak_and_work(folder);
    assert!((work - documented::<3>("work over strain")[2]).abs() <= 0.051, "{work}");
}

#[test]
fn softening_whose_slip_depends_on_the_mesh_is_warned_of_and_too_large_elements_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let check = |elements: usize, softening: &str| {
        column(folder, elements, softening);
        let done = tremolite(folder, &["check", "case.toml"]);
        (code(&done), errors(&done))
    };
    let (status, said) = check(12, BY_STRAIN);
    assert!(status == 0 && said.contains("softening over plastic strain has no length"), "{said}");
    let (status, said) = check(12, BY_SLIP);
    assert!(status == 0 && said.contains("'weak' softens over displacement"), "{said}");
    // E δ/(2 Δf_c) = 0.4 GPa × 5 mm/(2 × 0.414 MPa), in elements of 4 m.
    let (status, said) = check(12, &BY_SLIP.replace("20 mm", "5 mm"));
    assert_eq!(status, 2, "{said}");
    assert!(said.contains("softening elements must stay below 2.41 m"), "{said}");
    assert!(said.contains("plastic displacements of the softening 1.7 times as long"), "{said}");
    // The remedy holds as it is written.
    let (status, said) = check(12, &BY_SLIP.replace("20 mm", "8.5 mm"));
    assert_eq!(status, 0, "{said}");
    // V_s τ μ/(3 |H|) = 274.7 m/s × 1 ms × 153.8 MPa/(3 × 6.81 MPa).
    let (status, said) = check(12, &relaxing(1.0));
    assert!(
        status == 0 && said.contains("do not resolve a softening band: 2, up to 4.00 m (limit 2.07 m"),
        "{said}"
    );
    assert!(said.contains("2.05 m or less") && said.contains("multiply `relaxation_time` by 2.0"), "{said}");
    for (elements, time) in [(24, 1.0), (12, 2.0)] {
        let (status, said) = check(elements, &relaxing(time));
        assert!(status == 0 && !said.contains("soften"), "{elements} {time}: {said}");
    }
}
