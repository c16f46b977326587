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
units = "SI"
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
element = "full-integration"
[[region]]
groups = ["crack"]
material = "concrete"
element = "full-integration"
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
    summary.computed.stages.iter().map(|stage| (stage.moved["jaw"][way], stage.moved["jaw"][force])).collect()
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
        // Damage keeps what the way to rest passed beyond: 2.3·10⁻⁴ of the peak in 30 steps, 1.3·10⁻⁴ in 60, of order 1.
        assert!(worst < 5e-4, "axis {axis}, {steps} steps: {worst}");
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
    assert_eq!(summary.conclusion.status, Status::Failed);
    assert!(
        summary.conclusion.verdict.contains("the specimen snapped back"),
        "{}",
        summary.conclusion.verdict
    );
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

/// A check of a run, by its id: value and whether it passes.
fn check_of(summary: &Summary, id: &str) -> (f64, bool) {
    let line = summary.soundness.checks.iter().find(|line| line.id == id).unwrap();
    assert!(!line.not_applicable, "{line:?}");
    (line.value, line.pass)
}

#[test]
fn checks_tell_steps_that_snap_a_first_step_that_cracks_and_nodes_that_move_too_fast() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let drive = |elements: usize, stages: &str| {
        bar(folder, 2, elements, stages);
        done(folder, "out")
    };
    let all = ["energy_drop_in_step", "first_step_dissipation", "relaxation_damping_share"];
    for elements in [3, 4] {
        let stable = drive(elements, &pulled(2, 60e-6, 30));
        let found = all.map(|id| check_of(&stable, id));
        println!("{elements} elements: {found:?}");
        assert!(found.iter().all(|(_, pass)| *pass), "{elements} elements: {found:?}");
    }
    // Half as long again as may be: it falls by a half at once, and holds too little to be refused.
    let snapping = check_of(&drive(7, &pulled(2, 60e-6, 30)), "energy_drop_in_step");
    println!("7 elements: {snapping:?}");
    assert!(!snapping.1 && snapping.0 < 0.1, "{snapping:?}");
    let cracked = check_of(&drive(3, &pulled(2, 60e-6, 2)), "first_step_dissipation");
    println!("two steps: {cracked:?}");
    assert!(!cracked.1, "{cracked:?}");
    bar(folder, 2, 9, &pulled(2, 10e-6, 5));
    let text = std::fs::read_to_string(folder.join("case.toml")).unwrap();
    std::fs::write(folder.join("case.toml"), text.replace("[initial]", "[initial]\nrelease_cycles = 2"))
        .unwrap();
    let fast = check_of(&done(folder, "out"), "relaxation_damping_share");
    println!("in 10 cycles a step: {fast:?}");
    assert!(!fast.1, "{fast:?}");
}

/// A reinforced section of a lining, 0.5 m long, that cracks through and is closed again. Its bars hold joules; its concrete, whose loss
/// in a step was taken for a snap-back, holds 10⁻⁵ J as the crack closes.
#[test]
fn a_reinforced_section_is_cracked_through_and_closed_again() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let at = |name: &str, x: f64, z: f64, held: &str| {
        format!(
            "{{ name = \"{name}\", group = \"lining\", within = {{ x = [{x}, {x}], z = [{z}, {z}] }}, {held} }}"
        )
    };
    let stage = |name: &str, bottom: f64, top: f64| {
        let moved = [
            at("lb", 0.0, 0.0, "ux = 0, uy = 0, uz = 0"),
            at("lt", 0.0, 0.5, "ux = 0, uy = 0"),
            at("bot", 0.5, 0.0, &format!("ux = {bottom}, steps = 24")),
            at("top", 0.5, 0.5, &format!("ux = {top}")),
        ];
        format!("[[stage]]\nname = \"{name}\"\ndisplacement = [{}]\n", moved.join(", "))
    };
    let text = format!(
        r#"title = "section"
units = "SI"
[mesh.box]
group = "lining"
x = {{ to = 0.5, elements = 1 }}
y = {{ to = 1, elements = 1 }}
z = {{ to = 0.5, elements = 1 }}
[material.concrete]
law = "concrete-damage"
young = 30e9
poisson = 0
density = 2400
tensile_strength = 2.5e6
compressive_strength = 30e6
friction_angle = "37 deg"
fracture_energy = 130
residual_shear = 0.2
rate = "none"
[[region]]
groups = ["lining"]
material = "concrete"
element = "layered"
[[reinforcement]]
on = ["lining"]
area = "1500 mm2/m"
cover = 0.06
direction = "across"
yield = "400 MPa"
[initial]
sides = "free"
base = "free"
tolerance = 1e-6
[[monitor]]
name = "M"
at = [0.25, 0.5, 0.25]
{}{}"#,
        stage("open", 4.5e-4, 4.5e-4),
        stage("close", -1e-4, -1.5e-4)
    );
    std::fs::write(folder.join("case.toml"), text).unwrap();
    let summary = done(folder, "out");
    assert_eq!(summary.computed.stages.len(), 49);
    let of = |stage: usize, name: &str| summary.computed.stages[stage].moved[name]["reaction_x"];
    // Opened: the bars alone carry, E_s A ε of both faces.
    let bars = 2.0 * 200e9 * 1500e-6 * 4.5e-4 / 0.5;
    let opened = of(24, "bot") + of(24, "top");
    assert!((opened / bars - 1.0).abs() < 0.02, "{opened} {bars}");
    let (share, pass) = check_of(&summary, "energy_drop_in_step");
    println!("largest share of the stored energy released in one step: {share:.1e}");
    assert!(pass && share < 0.02, "{share}");
}

/// A quarter of a ring on two rollers, whose outer faces lie on no plane but those of its two ends.
#[test]
fn a_curved_specimen_stands_free() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let place = |k: usize, r: f64, y: f64| {
        let angle = std::f64::consts::FRAC_PI_2 * k as f64 / 6.0;
        [r * angle.sin(), y, r * angle.cos()]
    };
    let mut nodes = String::new();
    for k in 0..7 {
        for (i, [r, y]) in [[4.75, 0.0], [5.25, 0.0], [4.75, 1.0], [5.25, 1.0]].into_iter().enumerate() {
            let [x, y, z] = place(k, r, y);
            nodes += &format!("{} {x} {y} {z}\n", 4 * k + i + 1);
        }
    }
    let elements: String = (0..6)
        .map(|k| {
            let n = |i: usize| 4 * k + i;
            let m = |i: usize| 4 * (k + 1) + i;
            format!(
                "{} 5 2 1 1 {} {} {} {} {} {} {} {}\n",
                k + 1,
                n(1),
                m(1),
                m(3),
                n(3),
                n(2),
                m(2),
                m(4),
                n(4)
            )
        })
        .collect();
    let mesh = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"ring\"\n$EndPhysicalNames\n$Nodes\n28\n{nodes}$EndNodes\n\
         $Elements\n6\n{elements}$EndElements\n"
    );
    std::fs::write(folder.join("ring.msh"), mesh).unwrap();
    let text = r#"title = "ring"
units = "SI"
[mesh.file]
path = "ring.msh"
[material.concrete]
law = "elastic"
young = 25e9
poisson = 0.2
density = 2500
[[region]]
groups = ["ring"]
material = "concrete"
element = "full-integration"
[initial]
sides = "free"
base = "free"
[[monitor]]
name = "M"
at = [0, 0.5, 5]
[[stage]]
name = "push"
displacement = [{ name = "foot", group = "ring", within = { z = [-1e-6, 1e-6] }, uz = 0 }, { name = "y0", group = "ring", within = { y = [0, 0] }, uy = 0 }, { name = "crown", group = "ring", within = { x = [-1e-6, 1e-6] }, ux = 0, uz = -1e-4 }]
"#;
    std::fs::write(folder.join("case.toml"), text).unwrap();
    let summary = done(folder, "out");
    let force = summary.computed.stages[1].moved["crown"]["reaction_z"];
    let foot = summary.computed.stages[1].moved["foot"]["reaction_z"];
    assert!(force < 0.0 && (foot / -force - 1.0).abs() < 1e-3, "{force} {foot}");
}

#[test]
fn a_specimen_that_is_free_of_force_again_is_at_rest() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let back = "[[stage]]\nname = \"back\"\ndisplacement = { name = \"jaw\", face = \"top\", uz = 0 }";
    bar(folder, 2, 3, &format!("{}\n{back}", pulled(2, 10e-6, 1)));
    let summary = done(folder, "out");
    let (last, before) = (summary.computed.stages.last().unwrap(), &summary.computed.stages[2]);
    assert!(before.moved["jaw"]["reaction_z"] > 0.9 * exact(3.0 * SIZE, 10e-6));
    assert!(last.moved["jaw"]["reaction_z"].abs() < 1e-4 * exact(3.0 * SIZE, 10e-6), "{last:?}");
    assert!(last.cycles < 4000, "{}", last.cycles);
}

#[test]
fn what_is_moved_moves_though_the_group_that_names_it_is_excavated() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    // The two lower elements stay; their upper face is named by the one above, which goes.
    let stage = |group: &str, low: f64| {
        format!(
            "[[stage]]\nname = \"pull\"\nexcavate = [\"cap\"]\ndisplacement = {{ name = \"jaw\", group = \"{group}\", within = {{ z = [{low}, \
             {low}] }}, uz = 10e-6, steps = 2 }}"
        )
    };
    let drive = |group: &str| {
        bar(folder, 2, 3, &stage(group, 0.1));
        let text = std::fs::read_to_string(folder.join("case.toml")).unwrap();
        let text = text.replace("part = [", "part = [{ group = \"cap\", z = [0.1, 0.15] }, ");
        let text = text.replace("groups = [\"bar\"]", "groups = [\"bar\", \"cap\"]");
        std::fs::write(folder.join("case.toml"), text).unwrap();
        curve(&done(folder, "out"), 2)
    };
    let (own, gone) = (drive("crack"), drive("cap"));
    assert_eq!(own, gone);
    let (way, force) = *gone.last().unwrap();
    assert!((force / (SECTION * YOUNG * way / 0.1) - 1.0).abs() < 1e-3, "{force}");
    // Nothing of it stands: the stage says so.
    bar(folder, 2, 3, &stage("cap", 0.15));
    let text = std::fs::read_to_string(folder.join("case.toml")).unwrap();
    let text = text.replace("part = [", "part = [{ group = \"cap\", z = [0.1, 0.15] }, ");
    let text = text.replace("groups = [\"bar\"]", "groups = [\"bar\", \"cap\"]");
    std::fs::write(folder.join("case.toml"), text).unwrap();
    let said = errors(&tremolite(folder, &["check", "case.toml"]));
    assert!(said.contains("nothing of 'jaw' stands in the stage 'pull 1/2'"), "{said}");
}

#[test]
fn a_free_specimen_is_pulled_by_a_pressure_though_nothing_is_said_of_its_ground() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    bar(folder, 2, 3, "[[stage]]\nname = \"pull\"\npressure = { top = \"-1 MPa\" }");
    let text = std::fs::read_to_string(folder.join("case.toml")).unwrap();
    let text = text.replace("base = \"roller\"", "base = \"free\"");
    let text = text.replace("displacement = [", "displacement = [{ face = \"base\", uz = 0 },");
    std::fs::write(folder.join("case.toml"), text).unwrap();
    let pull = &done(folder, "out").computed.stages[2];
    assert!((pull.moved["base"]["reaction_z"] / (1e6 * SECTION) + 1.0).abs() < 1e-3, "{pull:?}");
}

#[test]
fn a_negative_pressure_pulls() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    bar(folder, 2, 3, "[[stage]]\nname = \"pull\"\npressure = { top = \"-1 MPa\" }");
    let summary = done(folder, "out");
    let pull = &summary.computed.stages[2].monitors["M"];
    assert!((pull["s1"].unwrap() - 1e6).abs() < 1e2, "{pull:?}");
    assert!((pull["uz"].unwrap() - 1e6 / YOUNG * 0.05).abs() < 1e-3 * 1e6 / YOUNG * 0.05, "{pull:?}");
    // The second stage held two faces; none of them is pushed by what pulls along z.
    for hold in ["xmin", "ymin"] {
        let forces = &summary.computed.stages[2].moved[hold];
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
            "displacement = [{ face = \"top\", uz = 1e-5 }, { name = \"edge\", group = \"bar\", uz = 0 }]",
            "'edge' and 'top' move the same component of the node at (0.0000, 0.0000, 0.1500) m to different places",
            "let their nodes differ",
        ),
        (
            "displacement = { face = \"top\", uz = 0.1 }",
            "'top' is moved by 0.1 m, and the mesh is 0.15",
            "check the unit",
        ),
    ] {
        bar(folder, 2, 3, &format!("[[stage]]\nname = \"wrong\"\n{stage}"));
        let checked = tremolite(folder, &["check", "case.toml"]);
        let said = errors(&checked);
        assert_eq!(code(&checked), 2, "{said}");
        assert!(said.contains(message) && said.contains(remedy) && said.contains("case.toml:"), "{said}");
    }
}
