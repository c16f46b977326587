//! Slips of units that can be computed with: `check` warns of each, with the number and a remedy, and of none in the case that `new` writes.

use crate::stage_case::{code, errors, tremolite};

#[test]
fn slips_of_units_are_warned_of_and_a_new_case_has_no_warning() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    tremolite(at, &["new", "study"]);
    let slow: String = (0..40).map(|k| format!("{} {}\n", 0.06 * f64::from(k), (k % 7) - 3)).collect();
    std::fs::write(at.join("study/slow.txt"), slow).unwrap();
    let sound = tremolite(at, &["check", "study/case.toml"]);
    assert_eq!(code(&sound), 0);
    assert!(!errors(&sound).contains("warning"), "{}", errors(&sound));

    // Slips are looked for in coarser meshes, which are made sooner.
    let text = std::fs::read_to_string(at.join("study/case.toml")).unwrap();
    assert!(text.contains("\"0.8 m\""));
    std::fs::write(at.join("study/case.toml"), text.replace("\"0.8 m\"", "\"2 m\"")).unwrap();
    let coarse = "mesh.caverns.size_far=\"500 m\"";
    let slips: &[(&[&str], &str, &str)] = &[
        (
            &["mesh.caverns.overburden=\"4 km\"", coarse],
            "4000 m of rock lie above the crown",
            "look at its unit",
        ),
        (&["mesh.caverns.below=\"6 km\"", coarse], "the model is 6.1 km across", "look at the units"),
        (&["mesh.caverns.cavern[0].width=\"62 m\""], "'hall' is 62 m wide", "look at its unit"),
        (&["mesh.caverns.cavern[0].height=\"102 m\""], "'hall' is 102 m high", "look at its unit"),
        (&["mesh.caverns.cavern[0].lining.walls=\"0.04 m\""], "a lining of 0.04 m", "look at its unit"),
        (&["dynamic.duration=\"12 s\""], "goes on for another 10.50 s", "leave `duration` out"),
        (&["motion.processing=[\"scale 0.03\"]"], "0.147 m/s2, 0.0150 g", "a record in g"),
        (&["motion.processing=[\"scale 5\"]"], "24.479 m/s2, 2.4962 g", "look at `units`"),
        (
            &["motion.east.file=\"slow.txt\"", "motion.east.units=\"m/s2\""],
            "the samples are 0.06 s apart",
            "rate of sampling",
        ),
        (
            &["material.rock.unit_weight=\"2600 kN/m3\""],
            "density of 'rock': 265036 kg/m3",
            "`unit_weight` in kN/m3",
        ),
        (&["material.rock.unit_weight=\"2.6 kN/m3\""], "density of 'rock': 265 kg/m3", "`density` in kg/m3"),
        (&["initial.gravity=\"981 m/s2\""], "gravity: 981 m/s2", "9.81 m/s2"),
        (&["initial.overburden=\"27 GPa\""], "overburden: 27 GPa", "look at its unit"),
        (&["initial.overburden=\"27 Pa\""], "overburden: 27 Pa", "look at its unit"),
        (
            &[
                "material.rock.law=mohr-coulomb",
                "material.rock.cohesion=\"1 MPa\"",
                "material.rock.friction_angle=\"40 deg\"",
                "material.rock.tensile_strength=\"9 MPa\"",
            ],
            "tensile strength of 'rock': 9 MPa, 2.098 of",
            "look at the units of tensile_strength",
        ),
    ];
    for (set, message, remedy) in slips {
        let mut args = vec!["check", "study/case.toml"];
        args.extend(set.iter().flat_map(|set| ["--set", set]));
        let done = tremolite(at, &args);
        let words = errors(&done);
        assert_eq!(code(&done), 0, "{set:?}: {words}");
        assert!(words.contains(message) && words.contains(remedy), "{set:?}: {words}");
    }
    // Just within the limits nothing of the kind is said.
    for set in [
        "mesh.caverns.cavern[0].width=\"58 m\"",
        "dynamic.duration=\"11 s\"",
        "motion.processing=[\"scale 0.05\"]",
        "material.rock.unit_weight=\"38 kN/m3\"",
        "initial.gravity=\"9.8 m/s2\"",
        "initial.overburden=\"5.4 MPa\"",
    ] {
        let words = errors(&tremolite(at, &["check", "study/case.toml", "--set", set]));
        assert!(
            !words.contains("m wide; caverns")
                && !words.contains("goes on")
                && !words.contains("(usual ")
                && !words.contains(" g; earthquakes"),
            "{words}"
        );
    }
}

/// Damping in proportion to the mass acts on pieces that slide or come loose as on all else: against the model's frame.
#[test]
fn mass_damping_is_warned_of_where_something_may_slide_or_come_loose() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    tremolite(at, &["new", "study"]);
    let text = std::fs::read_to_string(at.join("study/case.toml")).unwrap();
    assert!(text.contains("band"), "the case that `new` writes is damped over a band");
    let warned = |more: &str, set: &[&str]| {
        std::fs::write(at.join("study/case.toml"), format!("{text}{more}")).unwrap();
        let mut args = vec!["check", "study/case.toml"];
        args.extend(set.iter().flat_map(|set| ["--set", set]));
        let done = tremolite(at, &args);
        assert_eq!(code(&done), 0, "{}", errors(&done));
        errors(&done)
    };
    let mass = "dynamic.damping={ rayleigh = { mass = \"0.3 1/s\" } }";
    let joint = "[[interface]]\nname = \"back\"\nbetween = [\"hall.lining\", \"rock\"]\nlaw = \"bandis\"\nmax_closure = \"1 mm\"\nfriction_coefficient = 0.6\n";
    let words = "It reduces the slip of such pieces";
    assert!(!warned("", &[mass]).contains(words));
    assert!(!warned(joint, &[]).contains(words));
    let said = warned(joint, &[mass]);
    assert!(said.contains(words) && said.contains("the interface 'back' may slide"), "{said}");
    // The remedy is taken as it is written.
    let remedy = "dynamic.damping={ ratio = 0.02, band = [\"0.5 Hz\", \"20 Hz\"], reference = \"0 Hz\" }";
    assert!(said.contains("ratio = 0.02, band = [\"0.5 Hz\", \"20 Hz\"], reference = \"0 Hz\""), "{said}");
    assert!(!warned(joint, &[remedy]).contains("rayleigh"));
    let tied = joint.replace(
        "law = \"bandis\"\nmax_closure = \"1 mm\"\nfriction_coefficient = 0.6\n",
        "law = \"tied\"\n",
    );
    assert!(!warned(&tied, &[mass]).contains(words));
    let concrete = "material.concrete={ law = \"concrete-damage\", grade = \"C25/30\", fracture_energy = \"400 N/m\", friction_angle = \"37 deg\", unit_weight = \"25 kN/m3\" }";
    assert!(warned("", &[mass, concrete]).contains("'hall.lining' may come loose"));
}

/// A look at 147,000 elements and more takes longer than the slip deserves: its mesh is not even made. What is small goes on, and so does
/// who asks for all.
#[test]
fn a_model_too_large_to_be_meant_is_told_before_its_mesh_is_made() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    tremolite(at, &["new", "study"]);
    let deep = ["check", "study/case.toml", "--set", "mesh.caverns.overburden=\"20 km\""];
    let done = tremolite(at, &deep);
    let (words, text) = (errors(&done), String::from_utf8_lossy(&done.stdout).into_owned());
    assert_eq!(code(&done), 0, "{words}");
    assert!(words.contains("20000 m of rock") && words.contains("20.1 km across"), "{words}");
    assert!(text.contains("Nothing else is checked") && !text.contains("Time step"), "{text}");
    assert_eq!(code(&tremolite(at, &[&deep[..], &["--strict"]].concat())), 1);

    let coarse = ["--set", "mesh.caverns.size_far=\"500 m\""];
    for more in [&coarse[..], &[&coarse[..], &["--ignore-resources"]].concat()] {
        let done = tremolite(at, &[&deep[..], more].concat());
        let text = String::from_utf8_lossy(&done.stdout).into_owned();
        assert!(errors(&done).contains("20000 m of rock") && text.contains("Time step"), "{text}");
    }
}

/// The share of the ground that a warning names.
fn share(words: &str, after: &str) -> f64 {
    let at = words.find(after).unwrap_or_else(|| panic!("no '{after}' in {words}"));
    let (before, _) =
        words[..at].rsplit_once(" %").unwrap_or_else(|| panic!("no share before '{after}' in {words}"));
    before.rsplit(' ').next().and_then(|n| n.parse().ok()).unwrap_or_else(|| panic!("no number in {before}"))
}

const STUDY: &str = r#"title = "level ground"
[mesh.box]
group = "rock"
x = { to = "10 m", elements = 1 }
y = { to = "10 m", elements = 1 }
z = { from = "-200 m", to = 0, elements = ELEMENTS }
[material.rock]
law = "mohr-coulomb"
young = "10 GPa"
poisson = 0.25
unit_weight = "25 kN/m3"
cohesion = "0.5 MPa"
friction_angle = "30 deg"
[[region]]
groups = ["rock"]
material = "rock"
element = "reduced-integration"
[initial]
gravity = "10 m/s2"
INITIAL
"#;

fn checked(elements: usize, initial: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let text = STUDY.replace("ELEMENTS", &elements.to_string()).replace("INITIAL", initial);
    std::fs::write(folder.path().join("case.toml"), text).unwrap();
    let done = tremolite(folder.path(), &["check", "case.toml"]);
    assert_eq!(code(&done), 0, "{}", errors(&done));
    errors(&done)
}

/// Under σ_v = γd and σ_h = K σ_v rock lies beyond Mohr and Coulomb's line from d = f_c/γ(1 − kK) on, k = (1 + sin φ)/(1 − sin φ) = 3 and
/// f_c = 2c cos φ/(1 − sin φ) = 1.732 MPa: with K = 0.1 from 98.97 m on, which is 50.5 % of 200 m; with K = 0.2 from 173.2 m on, 13.4 %.
#[test]
fn ground_beyond_yield_at_rest_is_told_with_its_share() {
    for (lateral, exact) in [("0.1", 50.5), ("0.2", 13.4)] {
        for elements in [20, 200] {
            let words = checked(elements, &format!("lateral = {lateral}"));
            let found = share(&words, "of the ground lies beyond yield");
            // By whole elements, in whole per cent.
            assert!((found - exact).abs() <= 50.0 / elements as f64 + 0.5, "{found} for {exact}: {words}");
        }
    }
    // At K = 0.33 it is nowhere within 200 m.
    assert!(!checked(20, "lateral = 0.34").contains("beyond yield"));
}

#[test]
fn an_initial_stress_of_the_wrong_sign_is_told() {
    let stress = |sign: &str, where_: &str| {
        format!(
            "stress = {{ at = [0, 0, \"{where_}\"], xx = \"{sign}1 MPa\", yy = \"{sign}1 MPa\", zz = \"{sign}1 MPa\" }}"
        )
    };
    let words = checked(20, &stress("", "-50 m"));
    assert!(share(&words, "of the ground, by up to") == 100.0 || words.contains("pulls at 100 %"), "{words}");
    assert!(
        words.contains("by up to 1 MPa") && words.contains("compression is written with a minus"),
        "{words}"
    );
    assert!(!checked(20, &stress("-", "-50 m")).contains("pulls"));
}

/// The wall or the crown of an ellipse of the hall's extents, by the weight above what is taken out, of 27 kN/m3 and K = 0.6.
#[test]
fn rock_that_will_yield_round_an_opening_is_told() {
    let folder = tempfile::tempdir().unwrap();
    tremolite(folder.path(), &["new", "study"]);
    let check = |cohesion: &str, lateral: &str| {
        let rock = format!(
            "material.rock={{ law = \"mohr-coulomb\", young = \"10 GPa\", poisson = 0.25, unit_weight = \"27 kN/m3\", cohesion = \"{cohesion}\", \
             friction_angle = \"30 deg\" }}"
        );
        let lateral = format!("initial.lateral={lateral}");
        let done = tremolite(folder.path(), &["check", "study/case.toml", "--set", &rock, "--set", &lateral]);
        assert_eq!(code(&done), 0, "{}", errors(&done));
        errors(&done)
    };
    // f_c = 3.464 c.
    let words = check("0.5 MPa", "0.6");
    assert!(words.contains("its compressive strength of 1.732 MPa: it will yield"), "{words}");
    let (before, behind) = words.split_once(" (elastic, an ellipse of ").unwrap();
    let (extents, _) = behind.split_once(" m)").unwrap();
    let [width, height] = extents.split(" m × ").map(|x| x.parse::<f64>().unwrap()).collect::<Vec<_>>()[..]
    else {
        panic!("{words}")
    };
    let load: f64 = before.trim_end_matches(" MPa").rsplit(' ').next().unwrap().parse().unwrap();
    let [crown, wall] = [0.6 * (1.0 + 2.0 * height / width) - 1.0, 1.0 + 2.0 * width / height - 0.6];
    let depth = load / (27e-3 * crown.max(wall).max(3.0 - 0.6));
    let (_, place) = before.split_once("round the opening at (").unwrap();
    let z: f64 = place.split([',', ')']).nth(2).unwrap().trim().parse().unwrap();
    assert!((depth + z).abs() < 0.1, "{depth} m of rock above {z} m: {words}");
    assert!(!check("5 MPa", "0.6").contains("it will yield"));
    // What presses along the hall loads its ends, not its walls.
    let along = check("0.5 MPa", "{ x = 0.6, y = 3 }");
    let (told, _) = words[words.find("would have to carry").unwrap()..].split_once(" (elastic").unwrap();
    assert!(along.contains(told), "{along}");
}

#[test]
fn rows_closer_than_the_step_are_told_and_leave_the_step_alone() {
    let folder = tempfile::tempdir().unwrap();
    tremolite(folder.path(), &["new", "study"]);
    let check = |rows: &str| {
        let set = format!("output.histories=\"{rows}\"");
        let args = ["check", "study/case.toml", "--set", &set, "--set", "dynamic.levels=1"];
        let done = tremolite(folder.path(), &[&args[..], &["--json"]].concat());
        let found: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
        let step = found.pointer("/time_step/used").and_then(serde_json::Value::as_f64).unwrap();
        (step, errors(&tremolite(folder.path(), &args)))
    };
    let (usual, words) = check("5 ms");
    assert!(!words.contains("every step is a row"), "{words}");
    let (fine, words) = check("1 us");
    assert!(
        words.contains("rows 0.001 ms apart are closer than the finest step")
            && words.contains("every step is a row"),
        "{words}"
    );
    assert!((fine / usual - 1.0).abs() < 0.1, "{fine} and {usual}");
}

#[test]
fn a_run_without_room_on_the_disk_is_refused_before_it_begins_and_a_long_one_told() {
    let folder = tempfile::tempdir().unwrap();
    tremolite(folder.path(), &["new", "study"]);
    // Field files by the ten million.
    let much =
        ["study/case.toml", "--set", "dynamic.duration=\"100000 s\"", "--set", "output.snapshots=\"5 ms\""];
    let refused = tremolite(folder.path(), &[&["run"][..], &much].concat());
    assert_eq!(code(&refused), 2, "{}", errors(&refused));
    for words in ["of disk, beyond 80 % of the", "`snapshots`", "`--ignore-resources` runs it all the same"] {
        assert!(errors(&refused).contains(words), "{words}: {}", errors(&refused));
    }
    assert!(!folder.path().join("results").exists());
    let checked = tremolite(folder.path(), &[&["check"][..], &much].concat());
    assert_eq!(code(&checked), 0);
    assert!(
        errors(&checked).contains("`run` would refuse it without `--ignore-resources`"),
        "{}",
        errors(&checked)
    );
    let strict = tremolite(folder.path(), &[&["check", "--strict"][..], &much].concat());
    assert_eq!(code(&strict), 1);
}

#[test]
fn linear_tetrahedra_are_told_where_rock_may_yield_or_keeps_its_water_and_nowhere_else() {
    use tremolite_mesh::{Element, Shape, boxes::BoxSpec};
    let folder = tempfile::tempdir().unwrap();
    let mut mesh = BoxSpec::uniform([0.0, 0.0, -20.0], [20.0, 20.0, 0.0], [2, 2, 2]).mesh().unwrap();
    // Each brick in six tetrahedra about its diagonal 0–6.
    let bricks = std::mem::take(&mut mesh.elements);
    for brick in bricks {
        let n = brick.nodes().to_vec();
        for [a, b] in [[1, 2], [2, 3], [3, 7], [7, 4], [4, 5], [5, 1]] {
            mesh.elements.push(Element::new(Shape::Tet4, &[n[0], n[a], n[b], n[6]]));
        }
    }
    mesh.groups = [("rock".to_owned(), (0..mesh.elements.len() as u32).collect())].into();
    tremolite_mesh::write(folder.path().join("box.vtu"), &mesh).unwrap();
    let check = |yields: bool, earthquake: &str| {
        let mut text = STUDY.replace("INITIAL", "lateral = 0.5");
        if !earthquake.is_empty() {
            let pores = "[material.rock]\nwater = { biot = 0.8, porosity = 0.01 }\n";
            let water = format!("[water]\nlevel = \"0 m\"\nearthquake = \"{earthquake}\"\n[[region]]");
            text = text.replacen("[material.rock]\n", pores, 1).replacen("[[region]]", &water, 1);
        }
        if !yields {
            let strength = "cohesion = \"0.5 MPa\"\nfriction_angle = \"30 deg\"\n";
            text = text.replace("mohr-coulomb", "elastic").replace(strength, "");
        }
        let (head, rest) = text.split_once("[mesh.box]").unwrap();
        let (_, rest) = rest.split_once("[material.rock]").unwrap();
        let text = format!("{head}[mesh.file]\npath = \"box.vtu\"\n[material.rock]{rest}");
        std::fs::write(folder.path().join("case.toml"), text).unwrap();
        let done = tremolite(folder.path(), &["check", "case.toml"]);
        assert_eq!(code(&done), 0, "{}", errors(&done));
        errors(&done)
    };
    for earthquake in ["", "drained"] {
        assert!(!check(false, earthquake).contains("tetrahedra"), "{earthquake}");
    }
    let words = check(false, "undrained");
    assert!(
        words.contains("100 % of 'rock' is linear tetrahedra, which are too stiff where water"),
        "{words}"
    );
    let words = check(true, "");
    assert!(
        words.contains("100 % of 'rock' is linear tetrahedra") && words.contains("hexahedra or wedges"),
        "{words}"
    );
}

/// A surface of dip 45° through a grid of bricks: for each square metre of the plane two are steps, over √2 of it.
#[test]
fn an_interface_that_is_a_stair_of_elements_is_told_with_its_area() {
    use tremolite_mesh::boxes::BoxSpec;
    let folder = tempfile::tempdir().unwrap();
    let check = |above: &dyn Fn(f64, f64) -> bool| {
        let mut mesh = BoxSpec::uniform([0.0, 0.0, -20.0], [20.0, 4.0, 0.0], [10, 2, 10]).mesh().unwrap();
        let middle = |e: u32| {
            let nodes = mesh.elements[e as usize].nodes();
            [0, 2].map(|i| nodes.iter().map(|&n| mesh.nodes[n as usize][i]).sum::<f64>() / 8.0)
        };
        let (low, high): (Vec<u32>, Vec<u32>) = (0..mesh.elements.len() as u32).partition(|&e| {
            let [x, z] = middle(e);
            !above(x, z)
        });
        mesh.groups = [("low".to_owned(), low), ("high".to_owned(), high)].into();
        tremolite_mesh::write(folder.path().join("box.vtu"), &mesh).unwrap();
        let text = STUDY.replace("INITIAL", "lateral = 0.5").replace("[\"rock\"]", "[\"low\", \"high\"]");
        let (head, rest) = text.split_once("[mesh.box]").unwrap();
        let (_, rest) = rest.split_once("[material.rock]").unwrap();
        let joint = "[[interface]]\nname = \"fault\"\nbetween = [\"low\", \"high\"]\nlaw = \"coulomb\"\n\
                     normal_stiffness = \"20 GPa/m\"\nfriction_coefficient = 0.6\n";
        let text = format!("{head}[mesh.file]\npath = \"box.vtu\"\n[material.rock]{rest}{joint}");
        std::fs::write(folder.path().join("case.toml"), text).unwrap();
        let done = tremolite(folder.path(), &["check", "case.toml"]);
        assert_eq!(code(&done), 0, "{}", errors(&done));
        errors(&done)
    };
    // 9 treads and 9 risers, each 2 by 4 m; the plane is 18 √2 by 4 m.
    let words = check(&|x, z| z > x - 19.0);
    assert!(words.contains("'fault' is a stair of elements") && words.contains("of its 144 m2"), "{words}");
    assert!(
        words.contains("a plane would have 102 m2") && words.contains("faces of elements along the surface"),
        "{words}"
    );
    // A level plane, and one with a single bend, are none.
    assert!(!check(&|_, z| z > -10.0).contains("is a stair"));
    assert!(!check(&|x, z| z > if x > 10.0 { -6.0 } else { -14.0 }).contains("is a stair"));
}
