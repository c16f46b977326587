//! `tremolite mesh` as a user meets it.

use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

fn tremolite(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tremolite")).current_dir(folder).args(args).output().unwrap()
}

fn out(output: &Output) -> String {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout.clone()).unwrap()
}

/// Two unit cubes side by side whose nodes are not joined; the second is a tenth as thick as the first.
const TWO: &str = "\
*NODE
1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1
11, 1, 0, 0\n12, 1.1, 0, 0\n13, 1.1, 1, 0\n14, 1, 1, 0\n15, 1, 0, 1\n16, 1.1, 0, 1\n17, 1.1, 1, 1\n18, 1, 1, 1
*ELEMENT, TYPE=C3D8, ELSET=rock
1, 1, 2, 3, 4, 5, 6, 7, 8
*ELEMENT, TYPE=C3D8, ELSET=lining
7, 11, 12, 13, 14, 15, 16, 17, 18
*SURFACE, NAME=wall
1, S6
";

#[test]
fn info_says_by_group_what_the_step_is_and_what_it_costs() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("two.inp"), TWO).unwrap();
    let rock = "*: E = 10 GPa, nu = 0.25, density = 2752 kg/m3";
    // Nine times the modulus: a third of the step.
    let stiff = "lin*: E = 90 GPa, nu = 0.25, density = 2752 kg/m3";
    let info = |more: &[&str]| -> Value {
        let args = [["mesh", "info", "two.inp", "--json"].as_slice(), more].concat();
        serde_json::from_str(&out(&tremolite(folder.path(), &args))).unwrap()
    };
    let (one, two) = (info(&["--material", rock]), info(&["--material", rock, "--material", stiff]));
    let step = |info: &Value, group: &str| info["stable_step_by_group"][group]["step"].as_f64().unwrap();
    assert!((step(&one, "lining") / step(&two, "lining") - 3.0).abs() < 1e-12);
    assert_eq!(step(&one, "rock"), step(&two, "rock"));
    // Without materials the ratios are those of any one material.
    let none = info(&[]);
    assert_eq!(none["materials_assumed"], true);
    assert_eq!(step(&none, "rock") / step(&none, "lining"), step(&one, "rock") / step(&one, "lining"));
    let whole = &two["stable_step"];
    assert_eq!(whole["element"], 7);
    assert!((whole["at"][0].as_f64().unwrap() - 1.05).abs() < 1e-12 && whole["elements_within_1.25"] == 1);
    for (key, value) in [
        ("nodes", serde_json::json!(16)),
        ("elements", serde_json::json!({"hex8": 2})),
        ("groups", serde_json::json!({"lining": 1, "rock": 1})),
        ("min_scaled_jacobian", serde_json::json!(1.0)),
        ("parts", serde_json::json!([1, 1])),
        ("named_faces", serde_json::json!({"wall": 1})),
        ("coincident_nodes", serde_json::json!(4)),
        // Of twelve faces five lie on the x, y and z planes of each cube, and `wall` is one of these.
        ("other_outer_faces", serde_json::json!(2)),
    ] {
        assert_eq!(two[key], value, "{key}");
    }
    assert!((two["volume"].as_f64().unwrap() - 1.1).abs() < 1e-12);
    let refused = tremolite(folder.path(), &["mesh", "info", "two.inp", "--material", "rock: E = 10 m"]);
    assert_eq!(refused.status.code(), Some(2));
}

#[test]
fn the_command_that_info_offers_joins_the_parts() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("two parts.inp"), TWO).unwrap();
    let text = out(&tremolite(
        folder.path(),
        &["mesh", "info", "two parts.inp", "--section", "s.svg", "--view", "v.svg"],
    ));
    for words in
        ["1 hex8", "xmin", "wall", "2 separate parts, of 1, 1 elements", "4 nodes lie within", "assumed"]
    {
        assert!(text.contains(words), "'{words}' is missing:\n{text}");
    }
    assert!(["s.svg", "v.svg"].iter().all(|f| folder.path().join(f).is_file()));
    let offered = text
        .lines()
        .find_map(|l| l.trim().strip_prefix("tremolite mesh convert \"two parts.inp\" "))
        .unwrap();
    let args: Vec<&str> =
        ["mesh", "convert", "two parts.inp"].into_iter().chain(offered.split(' ')).collect();
    out(&tremolite(folder.path(), &args));
    let joined = out(&tremolite(folder.path(), &["mesh", "info", "joined.vtu"]));
    assert!(joined.contains("12 nodes") && joined.contains("all elements hang together"), "{joined}");
}

#[test]
fn a_case_brings_its_materials_and_lends_them_to_a_mesh_file() {
    let folder = tempfile::tempdir().unwrap();
    out(&tremolite(folder.path(), &["new", "study"]));
    let json =
        |args: &[&str]| -> Value { serde_json::from_str(&out(&tremolite(folder.path(), args))).unwrap() };
    let own = json(&["mesh", "info", "study/case.toml", "--json"]);
    assert_eq!(own["materials_assumed"], false);
    assert_eq!(own["elements_without_step"], 0, "what stages take out is rock");
    out(&tremolite(folder.path(), &["mesh", "cavern", "study/case.toml", "--out", "cavern.msh"]));
    let lent = json(&["mesh", "info", "cavern.msh", "--materials", "study/case.toml", "--json"]);
    assert_eq!(own["stable_step_by_group"], lent["stable_step_by_group"]);
    // Regions that do not fit are told, and the mesh is shown all the same.
    let case = folder.path().join("study/case.toml");
    let text = std::fs::read_to_string(&case).unwrap().replace("[\"rock\",", "[\"rok\",");
    std::fs::write(&case, text).unwrap();
    let shown = tremolite(folder.path(), &["mesh", "info", "study/case.toml"]);
    assert!(out(&shown).contains("assumed") && String::from_utf8_lossy(&shown.stderr).contains("fits 'rok'"));
    let refused = tremolite(folder.path(), &["mesh", "info", "cavern.msh", "--materials", "study/case.toml"]);
    assert_eq!(refused.status.code(), Some(2));
}

#[test]
fn convert_turns_scales_and_moves_in_that_order_and_says_where_the_mesh_lies() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("two.inp"), TWO).unwrap();
    let info = |file: &str| -> Value {
        serde_json::from_str(&out(&tremolite(folder.path(), &["mesh", "info", file, "--json"]))).unwrap()
    };
    // 1.1 × 1 × 1: upright 1.1 × 1 (mirrored) × 1, in mm, its long side along y.
    let placed = tremolite(
        folder.path(),
        &[
            "mesh",
            "convert",
            "two.inp",
            "placed.inp",
            "--up",
            "y",
            "--scale",
            "1e-3,-1e-3,1e-3",
            "--rotate",
            "90 deg",
            "--move",
            "-5,0 m,-200",
        ],
    );
    assert!(out(&placed).contains("placed.inp: 2 elements"));
    let message = String::from_utf8(placed.stderr).unwrap();
    assert!(message.contains("z from -200.000000 to -199.999000 m"), "{message}");
    let (before, after) = (info("two.inp"), info("placed.inp"));
    for key in ["elements", "groups", "named_faces", "parts"] {
        assert_eq!(before[key], after[key], "{key}");
    }
    let number = |value: &Value| value.as_f64().unwrap();
    assert!((number(&after["volume"]) / 1.1e-9 - 1.0).abs() < 1e-9, "{after:#}");
    assert!(number(&after["min_scaled_jacobian"]) > 1.0 - 1e-9);
    let exact = [[-5.001, 0.0, -200.0], [-5.0, 1.1e-3, -199.999]];
    for (found, exact) in after["bounds"].as_array().unwrap().iter().zip(exact) {
        assert!((0..3).all(|i| (number(&found[i]) - exact[i]).abs() < 1e-9), "{after:#}");
    }
    for (wrong, words) in [
        (["--scale", "0"], "none of them 0"),
        (["--scale", "1,2"], "one factor or three"),
        (["--rotate", "30"], "write the unit: \"30 deg\""),
        (["--move", "1,2"], "three lengths"),
        (["--up", "w"], "x, y, z"),
    ] {
        let refused =
            tremolite(folder.path(), &[&["mesh", "convert", "two.inp", "no.inp"][..], &wrong].concat());
        assert_eq!(refused.status.code(), Some(2), "{wrong:?}");
        assert!(String::from_utf8_lossy(&refused.stderr).contains(words), "{wrong:?}");
    }
    assert!(!folder.path().join("no.inp").exists());
}

/// Two cubes of rock with a box of them as a group of its own, in a file and in an option.
#[test]
fn groups_by_place_are_made_of_own_meshes_and_name_what_they_take() {
    let folder = tempfile::tempdir().unwrap();
    let place = "box = [[\"0.9 m\", 0, 0], [\"2 m\", \"1 m\", \"1 m\"]]";
    std::fs::write(folder.path().join("two.inp"), TWO.replace("ELSET=lining", "ELSET=rock")).unwrap();
    let file = format!("[mesh.file]\npath = \"two.inp\"\n[[mesh.group]]\nname = \"thin\"\n{place}\n");
    std::fs::write(folder.path().join("mesh.toml"), &file).unwrap();
    let convert = |args: &[&str]| tremolite(folder.path(), &[["mesh", "convert"].as_slice(), args].concat());
    let groups = |name: &str| -> Value {
        let info = out(&tremolite(folder.path(), &["mesh", "info", name, "--json"]));
        serde_json::from_str::<Value>(&info).unwrap()["groups"].clone()
    };
    out(&convert(&["mesh.toml", "from-file.vtu"]));
    let option = format!("name = \"thin\", {place}");
    out(&convert(&["two.inp", "from-option.vtu", "--group", &option]));
    for name in ["mesh.toml", "from-file.vtu", "from-option.vtu"] {
        assert_eq!(groups(name), serde_json::json!({"rock": 1, "thin": 1}), "{name}");
    }
    // Placed first, then grouped: in millimetres the same box is 1000 times as large.
    let scaled = option.replace("0.9 m", "900 m").replace("2 m", "2 km").replace("1 m", "1 km");
    out(&convert(&["two.inp", "scaled.vtu", "--scale", "1000", "--group", &scaled]));
    assert_eq!(groups("scaled.vtu"), serde_json::json!({"rock": 1, "thin": 1}));
    for (option, says) in [
        (option.replace("0.9 m", "5 m").replace("2 m", "6 m"), "no element of rock"),
        (option.replace("0.9 m", "-1 m"), "all elements of 'rock'"),
        (option.replace("thin", "rock"), "another name"),
        (option.replace("\"0.9 m\"", "0.9"), "has no unit"),
        (option.replace("box", "boks"), "`boks` is no key"),
        (format!("{option}, of = [\"rok\"]"), "did you mean 'rock'"),
        (format!("{option}, between = {{ levels = [0, \"1 m\"] }}"), "between"),
    ] {
        let refused = convert(&["two.inp", "none.vtu", "--group", &option]);
        let text = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert!(refused.status.code() == Some(2) && text.contains(says), "{option}\n{text}");
    }
}
