//! Sides and top as a user meets them: what is refused before anything is computed, and meshes that stand off the axes.

use crate::checks::{block, errors, tremolite};
use serde_json::Value;
use std::path::Path;
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::placement::Placement;

/// The line of the case, from 1, that has these words.
fn line(folder: &Path, words: &str) -> usize {
    let text = std::fs::read_to_string(folder.join("case.toml")).unwrap();
    1 + text.lines().position(|line| line.contains(words)).unwrap_or_else(|| panic!("{words}"))
}

fn change(folder: &Path, from: &str, to: &str) {
    let path = folder.join("case.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains(from), "the case has no '{from}'");
    std::fs::write(path, text.replacen(from, to, 1)).unwrap();
}

/// What a refusal says; it is one, of the line that has these words, and leaves no results.
fn refused(folder: &Path, words: &str) -> String {
    let output = tremolite(folder, &["run", "case.toml", "--out", "refused"]);
    let said = errors(&output);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains(&format!("case.toml:{}:", line(folder, words))), "{words}:\n{said}");
    assert!(!folder.join("refused").exists(), "nothing is computed");
    said
}

#[test]
fn sides_that_hold_what_the_motion_moves_are_refused_at_their_line() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for (dynamic, words, says) in [
        ("sides = \"fixed\"", "sides =", "fixed sides across x do not move"),
        (
            "[dynamic.sides]\nx = \"periodic\"\ny = \"fixed\"",
            "y = \"fixed",
            "fixed sides across y do not move",
        ),
        ("sides = \"roller\"", "sides =", "the roller sides across x hold their normal"),
        (
            "[dynamic.sides]\ny = \"periodic\"\nx = \"symmetry\"",
            "x = \"symmetry",
            "across x there is no symmetry",
        ),
    ] {
        block(folder, dynamic);
        let said = refused(folder, words);
        assert!(said.contains(says) && said.contains("\"free-field\""), "{dynamic}:\n{said}");
        assert!(said.ends_with("1 error\n"), "one mistake is told once:\n{said}");
        let check = tremolite(folder, &["check", "case.toml"]);
        assert_eq!(check.status.code(), Some(2), "{}", errors(&check));
    }
}

/// What counts is the motion along the model's axes, against the largest component.
#[test]
fn a_roller_is_allowed_where_the_motion_has_less_than_a_thousandth_along_its_normal() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let east = "east = { file = \"pulse.txt\", units = \"m/s2\", dt = \"0.01 s\" }";
    for (factor, azimuth, good) in [
        ("0.0009", "90 deg", true),
        ("0.0011", "90 deg", false),
        ("0", "90.05 deg", true),
        ("0", "90.06 deg", false),
    ] {
        for word in ["roller", "symmetry"] {
            block(folder, &format!("sides = {{ x = \"periodic\", y = \"{word}\" }}"));
            change(folder, east, &format!("{east}\nnorth = {{ from = \"east\", factor = {factor} }}"));
            change(folder, "title =", &format!("model_x_azimuth = \"{azimuth}\"\ntitle ="));
            if factor == "0" {
                change(folder, "\nnorth = { from = \"east\", factor = 0 }", "");
            }
            let check = tremolite(folder, &["check", "case.toml"]);
            let said = errors(&check);
            assert_eq!(
                check.status.code(),
                Some(if good { 0 } else { 2 }),
                "{word}, {factor}, {azimuth}: {said}"
            );
            assert!(good || said.contains("along it, of "), "{said}");
        }
    }
}

#[test]
fn a_top_that_absorbs_is_warned_of_at_its_line_and_listed() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    block(folder, "sides = \"periodic\"\ntop = \"viscous\"");
    let check = tremolite(folder, &["check", "case.toml"]);
    let said = errors(&check);
    assert_eq!(check.status.code(), Some(0), "{said}");
    assert!(said.contains(&format!("case.toml:{}:", line(folder, "top ="))), "{said}");
    assert!(said.contains("the wave that the real surface would send back is missing"), "{said}");
    block(folder, "sides = \"periodic\"");
    let check = tremolite(folder, &["check", "--verbose", "case.toml"]);
    assert_eq!(errors(&check), "", "a free top goes without saying");
    assert!(String::from_utf8(check.stdout).unwrap().contains("dynamic.top = free"));
    let list = String::from_utf8(tremolite(folder, &["list", "boundaries"]).stdout).unwrap();
    for words in ["\n    free-field ", "\n    symmetry ", "top (dynamic.top)\n    free ", "\n    viscous "] {
        assert!(list.contains(words), "{words}:\n{list}");
    }
}

/// A box of 80 × 60 × 40 m as a file, turned about z by so many degrees, and a case that reads it.
fn turned(folder: &Path, degrees: f64, dynamic: &str) {
    let mut mesh = BoxSpec::uniform([10.0, -20.0, 0.0], [90.0, 40.0, 40.0], [8, 6, 4]).mesh().unwrap();
    mesh.groups = [("rock".to_owned(), (0..mesh.elements.len() as u32).collect())].into();
    Placement { rotation: degrees.to_radians(), ..Placement::AS_IT_IS }.apply(&mut mesh);
    tremolite_mesh::write(folder.join("box.msh"), &mesh).unwrap();
    block(folder, dynamic);
    let path = folder.join("case.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let (head, rest) = text.split_once("[mesh.box]").unwrap();
    let (_, tail) = rest.split_once("[material.rock]").unwrap();
    std::fs::write(
        path,
        format!("model_x_azimuth = \"90 deg\"\n{head}[mesh.file]\npath = \"box.msh\"\n[material.rock]{tail}"),
    )
    .unwrap();
}

/// What check says, without estimates of time and bytes, which depend on the machine and on round-off.
fn model(folder: &Path) -> Value {
    let check = tremolite(folder, &["check", "case.toml", "--json"]);
    assert_eq!(check.status.code(), Some(0), "{}", errors(&check));
    let mut found: Value = serde_json::from_slice(&check.stdout).unwrap();
    for key in ["estimate", "mesh_rotation", "defaults_used"] {
        assert!(found.as_object_mut().unwrap().remove(key).is_some(), "{key}");
    }
    // Which of many equal elements is named goes by round-off.
    for (part, key) in [("motion", "coarsest"), ("time_step", "set_by")] {
        assert!(found[part].as_object_mut().unwrap().remove(key).is_some(), "{part}.{key}");
    }
    found
}

/// Whether two JSON values are the same, numbers but for round-off.
fn alike(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => {
            let [a, b] = [a, b].map(|x| x.as_f64().unwrap());
            (a - b).abs() <= 1e-9 * a.abs().max(b.abs())
        }
        (Value::Array(a), Value::Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| alike(a, b)),
        (Value::Object(a), Value::Object(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|((k, a), (l, b))| k == l && alike(a, b))
        }
        _ => a == b,
    }
}

#[test]
fn a_turned_box_is_refused_with_the_rotation_that_makes_it_the_straight_one() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let dynamic = "base = \"viscous\"\nsides = \"periodic\"";
    turned(folder, 0.0, dynamic);
    let straight = model(folder);
    for (by, found) in [(20.0, "20 deg"), (-37.0, "-37 deg"), (45.0, "45 deg"), (12.345_678, "12.345678 deg")]
    {
        turned(folder, by, dynamic);
        let said = refused(folder, "path = \"box.msh\"");
        assert!(said.contains(&format!("are turned by {found} about z")), "{said}");
        let info = String::from_utf8(tremolite(folder, &["mesh", "info", "box.msh"]).stdout).unwrap();
        assert!(info.contains(&format!("sides are turned by {by:.6} deg about z")), "{info}");
        let (_, rest) = said.split_once("write mesh.file.rotate = \"").expect("a remedy");
        let remedy = rest.split('"').next().unwrap();
        assert_eq!(
            remedy,
            if by < 0.0 { found.trim_start_matches('-').to_owned() } else { format!("-{found}") }
        );
        change(folder, "path = \"box.msh\"", &format!("path = \"box.msh\"\nrotate = \"{remedy}\""));
        let back = model(folder);
        assert!(alike(&straight, &back), "{by}: {straight:#}\n{back:#}");
        let text = String::from_utf8(tremolite(folder, &["check", "case.toml"]).stdout).unwrap();
        assert!(text.contains(&format!("turned by {remedy} about z; coordinates")), "{text}");
    }
    // A rotation that is there already is mended as a whole.
    turned(folder, 20.0, dynamic);
    change(folder, "path = \"box.msh\"", "path = \"box.msh\"\nrotate = \"-15 deg\"");
    let said = refused(folder, "path = \"box.msh\"");
    assert!(said.contains("turned by 5 deg") && said.contains("rotate = \"-20 deg\""), "{said}");
    // So that nobody takes the turned axis for that of the file.
    change(folder, "rotate = \"-15 deg\"", "rotate = \"-20 deg\"");
    change(folder, "model_x_azimuth = \"90 deg\"\n", "");
    let check = tremolite(folder, &["check", "case.toml"]);
    assert!(errors(&check).contains("is taken to point east"), "{}", errors(&check));
}

#[test]
fn free_sides_stand_as_they_like_but_for_stages_which_hold_them() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    turned(folder, 20.0, "base = \"viscous\"\nsides = \"free\"");
    let check = tremolite(folder, &["check", "case.toml"]);
    assert_eq!(check.status.code(), Some(0), "{}", errors(&check));
    change(folder, "[motion]", "[initial]\nlateral = 0.5\n[motion]");
    assert!(refused(folder, "path = \"box.msh\"").contains("turned by 20 deg"));
}

#[test]
fn a_plan_that_is_no_rectangle_and_sides_that_are_rough_are_refused_with_what_is_wrong() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    turned(folder, 0.0, "sides = \"periodic\"");
    let file = folder.join("box.msh");
    let bend = |shape: &dyn Fn([f64; 3]) -> [f64; 3]| {
        let mut mesh = tremolite_mesh::read(&file).unwrap();
        mesh.nodes.iter_mut().for_each(|x| *x = shape(*x));
        tremolite_mesh::write(&file, &mesh).unwrap();
    };
    // Nearly straight, as a file with few digits has it.
    bend(&|[x, y, z]| [if x > 89.0 && (5.0..15.0).contains(&z) { x + 1e-3 } else { x }, y, z]);
    let said = refused(folder, "path = \"box.msh\"");
    assert!(said.contains("the outer sides are not plane") && said.contains("more digits"), "{said}");
    assert!(!said.contains("rotate"), "{said}");
    bend(&|[x, y, z]| [x, if y > 39.0 { y + 0.05 * (x - 10.0) } else { y }, z]);
    let said = refused(folder, "path = \"box.msh\"");
    assert!(said.contains("not two pairs of parallel vertical planes") && !said.contains("rotate"), "{said}");
}

/// A turned box runs as the straight one: level ground that its free-field sides leave alone, and the same histories.
#[test]
fn a_box_that_is_turned_back_moves_as_the_straight_one_between_free_field_sides() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let run = |degrees: f64| {
        turned(folder, degrees, "sides = \"free-field\"");
        if degrees != 0.0 {
            let rotate = format!("path = \"box.msh\"\nrotate = \"{} deg\"", -degrees);
            change(folder, "path = \"box.msh\"", &rotate);
        }
        let out = format!("turned-{degrees}");
        let ran = tremolite(folder, &["run", "case.toml", "--out", &out]);
        assert_eq!(ran.status.code(), Some(0), "{}", errors(&ran));
        let out = folder.join(out);
        let summary = tremolite_results::Summary::read(&out.join("summary.json")).unwrap();
        let corners =
            summary.soundness.checks.iter().find(|line| line.id == "free_field_at_model_edges").unwrap();
        assert!(corners.pass && corners.value < 1e-9, "{degrees}: {corners:?}");
        tremolite_results::Table::read(&out.join("free_field.csv")).unwrap()
    };
    let (straight, back) = (run(0.0), run(20.0));
    let mut peak = 0.0_f64;
    for column in &straight.columns {
        let [a, b] = [&straight, &back].map(|table| table.column(&column.name).unwrap());
        let scale = a.iter().fold(0.0_f64, |most, x| most.max(x.abs())).max(1e-6);
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9 * scale), "{}", column.name);
        peak = peak.max(if column.name.starts_with("model.surface") { scale } else { 0.0 });
    }
    assert!(peak > 1e-3, "something moved: {peak}");
}

/// A hall from a file, along y or turned to run along x: then what is called across and along is the wrong way round, which bars in
/// particular must not be without a word.
#[test]
fn a_lining_that_runs_along_x_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let made = tremolite(folder.path(), &["new", "hall"]);
    assert!(made.status.success(), "{}", errors(&made));
    let folder = &folder.path().join("hall");
    let made = tremolite(folder, &["mesh", "cavern", "case.toml", "--out", "hall.msh"]);
    assert!(made.status.success(), "{}", errors(&made));
    let text = std::fs::read_to_string(folder.join("case.toml")).unwrap();
    let (before, rest) = text.split_once("[mesh.caverns]").unwrap();
    let (_, rest) = rest.split_once("[material.rock]").unwrap();
    let bars = "[[reinforcement]]\non = [\"hall.lining\"]\narea = \"1570 mm2/m\"\ncover = \"5 cm\"\ndirection = \"across\"\nyield = \"400 MPa\"\n";
    let case = |file: &str, sides: &str, more: &str| {
        let rest = rest.replace("at   = \"hall.crown\"", "at = [\"0 m\", \"0 m\", \"-60 m\"]");
        let rest = rest.replace("at   = \"hall.wall.left\"", "at = [\"0 m\", \"0 m\", \"-60 m\"]");
        let rest = rest.replace("{ x = \"free-field\", y = \"periodic\" }", sides);
        let rest = rest.replacen("[[stage]]", &format!("{more}[[stage]]"), 1);
        let text = format!("{before}[mesh.file]\npath = \"hall.msh\"\n{file}\n[material.rock]{rest}");
        std::fs::write(folder.join("case.toml"), text).unwrap();
        let check = tremolite(folder, &["check", "case.toml"]);
        assert_eq!(check.status.code(), Some(0), "{}", errors(&check));
        errors(&check)
    };
    let turned = ("rotate = \"90 deg\"", "{ y = \"free-field\", x = \"periodic\" }");
    let told = "bends round x";
    let said = case(turned.0, turned.1, bars);
    assert!(said.contains(told) && said.contains("rotate = \"90 deg\""), "{said}");
    assert!(!case("", "{ x = \"free-field\", y = \"periodic\" }", bars).contains(told));
    // Nothing is called across or along.
    assert!(!case(turned.0, turned.1, "").contains(told));
}
