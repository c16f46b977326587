//! What sections of linings use of their strength, from the case to `utilisation.csv` and `summary.json`.

use crate::stage_case::{bytes, change, code, errors, run};
use serde_json::Value;
use std::path::Path;
use tremolite_results::utilisation::{UtilisationRow, read_utilisation};
use tremolite_results::{SectionRow, read_sections};

const SECTION: &str = r#"[[section]]
on = ["*.lining"]
code = "EN 1992-1-1"
compressive_strength = "20 MPa"
tensile_strength = "1.5 MPa"
gamma_c = 1.25
alpha_cc = 0.8
"#;

const STEEL: &str = r#"[[reinforcement]]
on = ["*.lining"]
area = "1000 mm2/m"
cover = "6 cm"
direction = "across"
yield = "500 MPa"
"#;

/// Thrust and moment of a lining that no stage installs and that does not crack: it is a lining by its layered elements.
#[test]
fn an_elastic_lining_that_stands_from_the_start_has_sections() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, "");
    let text = std::fs::read_to_string(folder.join("case.toml")).unwrap();
    let (start, end) = (text.find("[initial]").unwrap(), text.find("[motion]").unwrap());
    let text = format!("{}{}", &text[..start], &text[end..]);
    let void = "groups = [\"rock\"]\nmaterial = \"rock\"\nelement = \"reduced-integration\"\n[[region]]\ngroups = [\"hall.bench*\"]\nmaterial = \"void\"";
    let text = text.replace("before = \"rock\"\n", "").replace(
        "groups = [\"rock\", \"hall.bench*\"]\nmaterial = \"rock\"\nelement = \"reduced-integration\"",
        void,
    );
    std::fs::write(folder.join("case.toml"), text).unwrap();
    let ended = run(folder, "out", &["--overwrite"]);
    assert_eq!(code(&ended), 0, "{}", errors(&ended));
    let rows = read_sections(&folder.join("out/sections.csv")).unwrap();
    let moved = rows.iter().filter(|row| row.lining == "hall.lining" && row.when == "max").count();
    assert!(moved > 8, "{moved}");
    assert!(rows.iter().any(|row| row.forces[1].abs() > 1.0), "no moment");
}

/// A round lined tunnel in rock under unlike pressures, shaken by a pulse. Elastic throughout.
fn case(folder: &Path, more: &str) {
    let pulse: String = (0..30)
        .map(|k| {
            let t = (std::f64::consts::PI * 10.0 * (0.01 * f64::from(k) - 0.1)).powi(2);
            format!("{:.6}\n", 3.0 * (1.0 - 2.0 * t) * (-t).exp())
        })
        .collect();
    std::fs::write(folder.join("pulse.txt"), pulse).unwrap();
    let text = r#"title = "tunnel"
[mesh.caverns]
overburden = "12 m"
below = "12 m"
sides = "12 m"
length = "3 m"
size_near = "1.6 m"
size_far = "5 m"
size_along = "3 m"
[[mesh.caverns.cavern]]
name = "hall"
shape = "circle"
width = "8 m"
height = "8 m"
lining = { walls = "0.4 m", crown = "0.4 m", floor = "0.4 m" }
[material.rock]
law = "elastic"
young = "2 GPa"
poisson = 0.25
density = "2600 kg/m3"
[material.concrete]
law = "elastic"
young = "30 GPa"
poisson = 0.2
density = "2500 kg/m3"
[[region]]
groups = ["rock", "hall.bench*"]
material = "rock"
element = "reduced-integration"
[[region]]
groups = ["*.lining"]
material = "concrete"
before = "rock"
[initial]
gravity = 0
overburden = "1 MPa"
stress = { xx = "-0.4 MPa", yy = "-0.5 MPa", zz = "-1 MPa" }
tolerance = 1e-4
[[stage]]
name = "excavation"
excavate = ["hall.bench*"]
release = 0.3
[[stage]]
name = "lining"
install = ["*.lining"]
[motion]
kind = "incident"
east = { file = "pulse.txt", units = "m/s2", dt = "0.01 s" }
processing = ["baseline"]
[dynamic]
base = "viscous"
sides = "viscous"
duration = "0.3 s"
[output]
histories = "0.01 s"
"#;
    std::fs::write(folder.join("case.toml"), format!("{text}{more}")).unwrap();
}

fn both(folder: &Path, out: &str) -> (Vec<SectionRow>, Vec<UtilisationRow>) {
    let folder = folder.join(out);
    (
        read_sections(&folder.join("sections.csv")).unwrap(),
        read_utilisation(&folder.join("utilisation.csv")).unwrap(),
    )
}

fn near(found: f64, wanted: f64) -> bool {
    (found - wanted).abs() <= 1e-9 * wanted.abs()
}

/// Plain concrete by hand: f_cd = 0.8 · 20/1.25 = 12.8 MPa, f_ctd = 1.5/1.25 = 1.2 MPa. Sound where no fibre of N/h ± 6M/h² leaves
/// them; cracked N = f_cd (h − 2 |M/N|).
fn by_hand([n, m]: [f64; 2], h: f64) -> f64 {
    let (direct, bending) = (n / h, 6.0 * m.abs() / (h * h));
    let sound = ((direct + bending) / 1.2e6).max((bending - direct) / 12.8e6);
    let pressed = h - 2.0 * (m / n).abs();
    let cracked = if n < 0.0 && pressed > 0.0 { -n / (12.8e6 * pressed) } else { f64::INFINITY };
    sound.min(cracked)
}

#[test]
fn an_elastic_lining_uses_what_a_hand_calculation_from_its_section_forces_says() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, SECTION);
    let done = run(folder, "out", &[]);
    assert_eq!(code(&done), 0, "{}", errors(&done));
    let (sections, used) = both(folder, "out");
    let stations = sections.iter().filter(|s| s.when == "lining").count();
    assert!(stations > 12);
    for section in sections.iter().filter(|s| s.when == "lining") {
        let of = used.iter().find(|u| u.station == section.station && u.when == "lining").unwrap();
        assert!(
            (0..3).all(|i| near(of.forces[i], section.forces[i]) || of.forces[i].abs() < 1e-3),
            "{of:?} {section:?}"
        );
        let [n, m, q] = section.forces;
        assert!((of.bending / by_hand([n, m], section.thickness) - 1.0).abs() < 1e-9, "{of:?}");
        // EN 1992-1-1 12.6.3, with the term of pressures beyond f_cd − 2 (f_ctd (f_ctd + f_cd))^½ = 4.6 MPa.
        // Of what is pressed, once the force leaves the core.
        let h = section.thickness;
        let eccentricity = if n < 0.0 { (m / n).abs() } else { 0.0 };
        let pressed = if eccentricity > h / 6.0 { h - 2.0 * eccentricity } else { h };
        let pressure = -n / pressed / 1e6;
        let beyond = (0.5 * (pressure - (12.8 - 2.0 * (1.2 * 14.0_f64).sqrt()))).max(0.0);
        let square = 1.44 + 1.2 * pressure - beyond * beyond;
        let resistance = square.sqrt() * 1e6 * pressed / 1.5;
        assert!((of.shear / (q.abs() / resistance) - 1.0).abs() < 1e-9, "{of:?}");
    }
    // In the shaking: one instant each, and of all steps, so at least what the rows of sections.csv show.
    let mut more = 0;
    for station in 1..=stations as u32 {
        let find = |when: &str| used.iter().find(|u| u.station == station && u.when == when).unwrap();
        let (most, shear) = (find("max"), find("max_shear"));
        let rows = sections.iter().filter(|s| s.station == station && s.time[0].is_finite());
        for row in rows {
            let h = row.thickness;
            assert!(near(most.bending, by_hand([most.forces[0], most.forces[1]], h)), "{most:?}");
            for state in [[row.thrust_at_moment, row.forces[1]], [row.forces[0], row.moment_at_thrust]] {
                assert!(most.bending >= by_hand(state, h) * (1.0 - 1e-9), "{most:?} {row:?}");
            }
            more += usize::from(most.bending > 1.001 * by_hand([row.thrust_at_moment, row.forces[1]], h));
        }
        assert!(shear.shear >= most.shear && most.bending >= shear.bending);
        assert!((0.0..=0.3 + 1e-9).contains(&most.time));
    }
    assert!(more > 0, "some instant between rows, or beside both extremes, uses more");
    let summary: Value = serde_json::from_slice(&bytes(folder, "out", "summary.json")).unwrap();
    let of = &summary["sections"]["hall.lining"];
    let largest = used.iter().map(|u| u.bending).fold(0.0, f64::max);
    assert_eq!(of["bending"]["value"].as_f64(), Some(largest));
    assert_eq!((of["stations"].as_u64(), of["reinforced"].as_u64()), (Some(stations as u64), Some(0)));
    assert_eq!((of["yields"].as_bool(), of["compression"].as_f64()), (Some(false), Some(12.8e6)));
    let beyond = (1..=stations as u32)
        .filter(|s| used.iter().any(|u| u.station == *s && (u.bending > 1.0 || u.shear > 1.0)))
        .count();
    assert_eq!(of["beyond"].as_u64(), Some(beyond as u64));
}

/// Bars make it a reinforced section: in each stage what plane sections say of its forces, bars' included. Judging changes no other bit,
/// nor do a stop and several levels of steps.
#[test]
fn bars_count_and_judging_changes_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, STEEL);
    assert_eq!(code(&run(folder, "plain", &[])), 0);
    case(folder, &format!("{STEEL}{SECTION}"));
    let done = run(folder, "judged", &[]);
    assert_eq!(code(&done), 0, "{}", errors(&done));
    for file in ["sections.csv", "energy.csv", "stages.csv"] {
        assert!(bytes(folder, "plain", file) == bytes(folder, "judged", file), "{file}");
    }
    let (sections, used) = both(folder, "judged");
    use tremolite_sections::{Concrete, Diagram, Layer, Section};
    for section in sections.iter().filter(|s| s.when == "lining") {
        let of = used.iter().find(|u| u.station == section.station && u.when == "lining").unwrap();
        let h = section.thickness;
        // Bars go from edge to edge of a station, so their lever is that of a chord: within 1 %.
        let layer = |depth| Layer { area: 1e-3, depth, young: 200e9, yields: 500e6, breaks: f64::INFINITY };
        let layers = vec![layer(0.5 * h - 0.06), layer(0.06 - 0.5 * h)];
        let exact = Diagram::of(&Section { thickness: h, concrete: Concrete::en(12.8e6), layers });
        let exact = exact.utilisation([section.forces[0], section.forces[1]]);
        assert!((of.bending / exact - 1.0).abs() < 0.01, "{} {exact}", of.bending);
    }
}

/// The crack that is left is that of EN 1992-1-1 7.3.4 at the forces of the last step, which lie between the extremes of the file; without
/// a diameter there is none.
#[test]
fn the_crack_that_is_left_is_that_of_the_forces_at_the_end() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, &format!("{STEEL}{SECTION}bar_diameter = \"16 mm\"\n"));
    // Much less across than down: the lining bends.
    change(folder, "xx = \"-0.4 MPa\"", "xx = \"-0.1 MPa\"");
    let done = run(folder, "out", &[]);
    assert_eq!(code(&done), 0, "{}", errors(&done));
    let (sections, _) = both(folder, "out");
    let summary: Value = serde_json::from_slice(&bytes(folder, "out", "summary.json")).unwrap();
    let crack = &summary["sections"]["hall.lining"]["crack"];
    let number = |v: &Value| v.as_f64().unwrap();
    let (width, forces) = (number(&crack["width"]), [0, 1].map(|i| number(&crack["forces"][i])));
    let of = |when: &str| {
        let station = number(&crack["station"]) as u32;
        sections.iter().find(|s| s.station == station && s.when == when).unwrap()
    };
    for i in 0..2 {
        let (low, high) = (of("min").forces[i], of("max").forces[i]);
        let room = 0.01 * (high - low);
        assert!((low - room..=high + room).contains(&forces[i]), "{forces:?} {low} {high}");
    }
    use tremolite_sections::{Concrete, CrackRule, Layer, Section};
    let rule = CrackRule::en(20e6, 0.016);
    let at = |h: f64, forces: [f64; 2]| {
        let layer = |depth| Layer { area: 1e-3, depth, young: 200e9, yields: 500e6, breaks: f64::INFINITY };
        let layers = vec![layer(0.5 * h - 0.06), layer(0.06 - 0.5 * h)];
        rule.crack(&Section { thickness: h, concrete: Concrete::en(12.8e6), layers }, forces).unwrap()
    };
    let exact = at(of("lining").thickness, forces);
    // The bars' lever is that of a chord.
    assert!(width > 1e-6 && (width / exact.width - 1.0).abs() < 0.03, "{width} {exact:?}");
    assert!((number(&crack["stress"]) / exact.stress - 1.0).abs() < 0.03, "{exact:?}");
    case(folder, &format!("{STEEL}{SECTION}"));
    assert_eq!(code(&run(folder, "none", &[])), 0);
    let summary: Value = serde_json::from_slice(&bytes(folder, "none", "summary.json")).unwrap();
    assert!(summary["sections"]["hall.lining"]["crack"].is_null());
}

#[test]
fn what_cannot_be_judged_is_refused_at_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for (from, to, says) in [
        ("compressive_strength = \"20 MPa\"\n", "", "how strong the concrete is"),
        ("compressive_strength = \"20 MPa\"", "compressive_strength = \"51 MPa\"", "beyond C50"),
        (
            "compressive_strength = \"20 MPa\"\ntensile_strength = \"1.5 MPa\"",
            "grade = \"C31\"",
            "knows no grade 'C31'",
        ),
        ("compressive_strength = \"20 MPa\"", "grade = \"C30/37\"", "without `grade`"),
        ("[\"*.lining\"]\ncode", "[\"*.linnig\"]\ncode", "no group of the mesh fits"),
        ("\"EN 1992-1-1\"", "\"EN 1992\"", "EN 1992-1-1"),
        ("yield = \"500 MPa\"\n", "", "never yield"),
        (SECTION, &format!("{SECTION}{SECTION}"), "judged by [[section]] 1 as well"),
    ] {
        case(folder, &format!("{STEEL}{SECTION}"));
        change(folder, from, to);
        let refused = run(folder, "none", &[]);
        let said = errors(&refused);
        assert!(code(&refused) == 2 && said.contains(says) && said.contains("case.toml:"), "{says}: {said}");
    }
}
