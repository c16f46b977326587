//! Cases with water: level ground, a drawdown, wet weight, a lake, and what is refused and warned of.

use std::sync::atomic::AtomicBool;
use tremolite::Stage;
use tremolite::hexahedra::centroid;
use tremolite::job::{Caller, Given, Inputs, Job};
use tremolite::run::Control;
use tremolite::simulation::Start;
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::{Element, Shape};
use tremolite_results::{ResultFolder, StageSummary, Status};

const GROUND: &str = r#"title = "level ground with water"
[mesh.box]
x = { from = "0 m", to = "32 m", elements = 2 }
y = { from = "0 m", to = "16 m", elements = 1 }
z = { from = "-288 m", to = "0 m", elements = 18 }
[water]
level = "-50 m"
[material.rock]
law = "elastic"
young = "10 GPa"
poisson = 0.25
unit_weight = "27 kN/m3"
water = { biot = 0.8 }
[[region]]
groups = ["*"]
material = "rock"
element = "reduced-integration"
[initial]
lateral = 0.8
[[monitor]]
name = "A"
at = ["24 m", "8 m", "-200 m"]
"#;

const STAGE: &str = "[[stage]]\nname = \"later\"\n";

fn job(text: &str) -> Result<Job, String> {
    let folder = tempfile::tempdir().unwrap();
    Job::of_text(text, folder.path(), &Given::default()).map_err(|fault| fault.to_string())
}

/// The stages of a case that comes to rest.
fn stages(text: &str) -> Vec<StageSummary> {
    let job = job(text).unwrap_or_else(|fault| panic!("{fault}"));
    let folder = tempfile::tempdir().unwrap();
    let results = ResultFolder::create(Some(folder.path()), "wet", true).unwrap();
    let mut control = Control { stop: &AtomicBool::new(false), progress: &mut |_| {} };
    let (_, summary) = job.run(&results, Start::Rest, &Caller::new("test"), &mut control).unwrap();
    assert_eq!(summary.conclusion.status, Status::Done, "{}", summary.conclusion.verdict);
    summary.computed.stages
}

fn at_a(stage: &StageSummary, quantity: &str) -> f64 {
    stage.monitors["A"][quantity].unwrap()
}

fn near(found: f64, exact: f64, share: f64) {
    assert!((found - exact).abs() <= share * exact.abs(), "{found} instead of {exact}");
}

/// γ 27 kN/m³, water at 50 m, 200 m deep: 5.4 MPa above and 1.4715 MPa of water.
#[test]
fn level_ground_with_water_is_at_rest_under_the_stresses_of_theory() {
    for (of, horizontal) in [("effective", -4_614_300.0), ("total", -4_320_000.0)] {
        let ground = GROUND.replace("lateral = 0.8", &format!("lateral = 0.8\nk0_stress = \"{of}\""));
        let [stage] = &stages(&ground)[..] else { panic!("one stage") };
        assert!(stage.largest_motion < 1e-14, "{}", stage.largest_motion);
        let wanted = [("szz", -5.4e6), ("p", 1.4715e6), ("s3_eff", -3.9285e6), ("sxx", horizontal)];
        wanted.iter().for_each(|(quantity, exact)| near(at_a(stage, quantity), *exact, 1e-12));
        near(at_a(stage, "s1_eff"), horizontal + 1.4715e6, 1e-12);
    }
}

/// Δp is 50 γ_w below the new level and falls to nothing at the old one: the ground settles by ∫αΔp/M dz. Of the kinks a 2×2×2 mean errs by
/// a thousandth.
#[test]
fn ground_settles_by_the_drawdown_as_biot_says_and_its_weight_stays() {
    let drawn = format!("{GROUND}{STAGE}water = {{ level = \"-100 m\" }}\n");
    let stages = stages(&drawn);
    let stiffness = 10e9 * 0.75 / (1.25 * 0.5);
    near(stages[1].largest_motion, 0.8 * 9810.0 * (0.5 * 50.0 * 50.0 + 50.0 * 188.0) / stiffness, 1e-3);
    near(at_a(&stages[1], "szz"), -5.4e6, 1e-4);
    near(at_a(&stages[1], "p"), 9.81e5, 1e-12);
    // Effective stress takes over what the water no longer bears, and αΔp goes sideways by ν.
    let sideways = -4_614_300.0 + 0.8 * 490_500.0 * (1.0 - 0.25 / 0.75);
    near(at_a(&stages[1], "sxx"), sideways, 1e-3);
    assert_eq!(stages[1].changed, ["water level at -100 m"]);
}

/// The elements down to 48 m have no water in them.
#[test]
fn wet_ground_weighs_what_its_material_says() {
    let wet = GROUND.replace("biot = 0.8", "biot = 0.8, saturated_unit_weight = \"28 kN/m3\"");
    let [stage] = &stages(&wet)[..] else { panic!("one stage") };
    near(at_a(stage, "szz"), -(48.0 * 27e3 + 152.0 * 28e3), 1e-12);
    assert!(stage.largest_motion < 1e-14, "{}", stage.largest_motion);
}

#[test]
fn a_lake_presses_on_the_top_by_its_depth() {
    let lake = format!("{GROUND}{STAGE}water = {{ filled = {{ \"top\" = \"10 m\" }} }}\n");
    let stages = stages(&lake);
    near(at_a(&stages[1], "szz"), -5.4e6 - 98.1e3, 1e-4);
    assert_eq!(stages[1].changed, ["top full of water to 10 m"]);
}

#[test]
fn what_is_not_there_yet_or_has_no_water_is_refused_with_a_way_out() {
    let refused = |from: &str, to: &str, words: &[&str]| {
        assert!(GROUND.contains(from), "{from}");
        let fault = job(&GROUND.replacen(from, to, 1)).err().unwrap_or_else(|| panic!("{to} is taken"));
        words.iter().for_each(|word| assert!(fault.contains(word), "{to}: no '{word}' in {fault}"));
    };
    let level = "level = \"-50 m\"";
    refused(
        level,
        &format!("{level}\nheads = {{ sides = \"-50 m\" }}"),
        &["only with steady seepage", "seepage"],
    );
    refused("water = { biot = 0.8 }\n", "", &["below the water level", "none"]);
    refused("[water]\nlevel = \"-50 m\"\n", "", &["only where there is water"]);
    refused("biot = 0.8", "biot = 1.2", &["at most 1"]);
    refused("biot = 0.8", "biot = 0.1, porosity = 0.2", &["porosity", "grains"]);
    refused("biot = 0.8", "skempton = 1.0", &["Skempton"]);
    refused("lateral = 0.8\n", "", &["no initial stress"]);
    let dry = GROUND.replace("water = { biot = 0.8 }", "water = \"none\"");
    assert!(job(&dry).is_ok());
}

/// Ground of 10 m that is dug away, pressed on or filled with water, and filled in again: under the name of what was there the floor is pressed as
/// under the name of the floor, though the fill stands later under the same name.
#[test]
fn a_pit_that_is_filled_in_later_is_pressed_under_its_own_name() {
    let pit = |pressed: &str| {
        let part = "elements = 18 }\npart = [{ group = \"pit\", z = [\"-32 m\", \"0 m\"] }, { group = \"floor\", z = [\"-288 m\", \"-32 m\"] }]";
        let fill = "[material.fill]\nlaw = \"elastic\"\nyoung = \"1 GPa\"\npoisson = 0.25\nunit_weight = \"20 kN/m3\"\nwater = \"none\"\n\
                    [[region]]\ngroups = [\"pit\"]\nmaterial = \"fill\"\nbefore = \"rock\"\nelement = \"reduced-integration\"\n[initial]";
        let ground = GROUND
            .replace("elements = 18 }", part)
            .replace("[initial]", fill)
            .replace("groups = [\"*\"]", "groups = [\"floor\"]");
        let dig = format!("[[stage]]\nname = \"dig\"\nexcavate = [\"pit\"]\n{pressed}\n");
        stages(&format!("{ground}{dig}[[stage]]\nname = \"fill\"\ninstall = [\"pit\"]\n"))
    };
    // 27 kN/m³ over 168 m, and what presses on the floor; in the second stage the fill with what is on its own top, nothing.
    for (pressed, p) in [
        ("pressure = { pit = \"0.5 MPa\" }", 0.5e6),
        ("pressure = { floor = \"0.5 MPa\" }", 0.5e6),
        ("water = { filled = { pit = \"0 m\" } }", 32.0 * 9810.0),
        ("water = { filled = { floor = \"0 m\" } }", 32.0 * 9810.0),
        ("", 0.0),
    ] {
        let stages = pit(pressed);
        near(at_a(&stages[1], "szz"), -168.0 * 27e3 - p, 1e-3);
    }
}

const HALL: &str = r#"title = "hall in wet rock"
[mesh.file]
path = "hall.msh"
unit = "1 m"
[water]
level = "-5 m"
[material.rock]
law = "elastic"
young = "2 GPa"
poisson = 0.25
unit_weight = "27 kN/m3"
water = { biot = 1 }
[material.concrete]
law = "elastic"
young = "25 GPa"
poisson = 0.2
unit_weight = "25 kN/m3"
water = "none"
[[region]]
groups = ["rock", "core"]
material = "rock"
element = "reduced-integration"
[[region]]
groups = ["shell"]
material = "concrete"
element = "full-integration"
[initial]
lateral = 0.5
[[stage]]
name = "dig"
excavate = ["core"]
water = { level = "-70 m" }
[[stage]]
name = "line"
install = ["shell"]
[[stage]]
name = "fill"
water = { level = "-20 m" }
"#;

const GROUTED: &str = r#"[material.grouted]
law = "elastic"
young = "4 GPa"
poisson = 0.25
unit_weight = "27 kN/m3"
water = { biot = 1 }
"#;

/// What is said of a hall in a block of 60 × 10 × 60 m, 20 m wide, with a shell of 5 m.
fn told(text: &str) -> Vec<String> {
    let mut mesh = BoxSpec::uniform([0.0, 0.0, -60.0], [60.0, 10.0, 0.0], [12, 2, 12]).mesh().unwrap();
    let far = |e: u32| {
        let [x, _, z] = centroid(&mesh, e);
        (x - 30.0).abs().max((z + 30.0).abs())
    };
    let within =
        |low: f64, high: f64| (0..288).filter(|&e| (low..high).contains(&far(e))).collect::<Vec<u32>>();
    let groups = [("core", within(0.0, 5.0)), ("shell", within(5.0, 10.0)), ("rock", within(10.0, 60.0))];
    mesh.groups = groups.map(|(name, elements)| (name.to_owned(), elements)).into();
    let inputs = Inputs { meshes: [("hall.msh".to_owned(), mesh)].into(), ..Inputs::default() };
    let folder = tempfile::tempdir().unwrap();
    let job = Job::of_text(text, folder.path(), &Given { inputs, ..Given::default() });
    job.unwrap_or_else(|fault| panic!("{fault}")).said()
}

#[test]
fn openings_below_the_level_and_linings_tied_to_wet_rock_are_warned_of() {
    let has = |said: &[String], words: &str| said.iter().any(|one| one.contains(words));
    let (below, tied) = ("takes out ground below the water level", "it does not feel the water behind it");
    let said = told(HALL);
    assert!(!has(&said, below) && has(&said, tied), "{said:?}");
    // Without a drawdown where it is dug; and what stands at the same level all along is no matter.
    let still = HALL.replace("water = { level = \"-70 m\" }\n", "").replace("\"-20 m\"", "\"-5 m\"");
    let said = told(&still);
    assert!(has(&said, below) && !has(&said, tied), "{said:?}");
    // Rock that becomes another takes nothing out; and if its water changes in that very stage, the lining misses the head as well.
    let ground = GROUND.replacen("[[region]]", &format!("{GROUTED}[[region]]"), 1);
    let said = job(&format!("{ground}{STAGE}material = {{ rock = \"grouted\" }}\n")).unwrap().said();
    assert!(!has(&said, below), "{said:?}");
    let both = HALL
        .replace("name = \"fill\"", "name = \"fill\"\nmaterial = { rock = \"grouted\" }")
        .replacen("[[region]]", &format!("{GROUTED}[[region]]"), 1);
    let said = told(&both);
    assert!(!has(&said, below) && has(&said, tied), "{said:?}");
    let joint = "[[interface]]\nname = \"joint\"\nbetween = [\"shell\", \"rock\"]\nlaw = \"coulomb\"\nnormal_stiffness = \"20 GPa/m\"\nfriction_coefficient = 0.6\ncohesion = \"0 Pa\"\n";
    let said = told(&HALL.replace("[initial]", &format!("{joint}[initial]")));
    assert!(!has(&said, tied), "{said:?}");
    for (level, words) in [("10 m", "nothing presses on its top"), ("-300 m", "below the model")] {
        let said = job(&GROUND.replace("-50 m", level)).unwrap().said();
        assert!(has(&said, words), "{said:?}");
    }
}

/// Still water presses on a wedge as at its centre of mass, whichever corners of the hexahedron fall together.
#[test]
fn pressures_of_wedges_know_no_order_of_corners() {
    let bricks = BoxSpec::uniform([0.0, 0.0, -96.0], [32.0, 16.0, 0.0], [2, 1, 6]).mesh().unwrap();
    for turns in 0..3 {
        let turned = |n: [u32; 6]| {
            let at = |k: usize| n[k / 3 * 3 + (k + turns) % 3];
            Element::new(Shape::Wedge6, &[0, 1, 2, 3, 4, 5].map(at))
        };
        // Parted across y, so that corners at different heights fall together.
        let parted = |n: [u32; 8]| {
            [turned([n[0], n[4], n[5], n[3], n[7], n[6]]), turned([n[0], n[5], n[1], n[3], n[6], n[2]])]
        };
        let mut mesh = bricks.clone();
        mesh.elements = bricks.elements.iter().flat_map(|e| parted(e.nodes)).collect();
        mesh.faces.clear();
        mesh.groups = [("ground".to_owned(), (0..mesh.elements.len() as u32).collect())].into();
        let box_of = &GROUND[GROUND.find("[mesh.box]").unwrap()..GROUND.find("[water]").unwrap()];
        let text = GROUND.replace(box_of, "[mesh.file]\npath = \"g.msh\"\n").replace("-200 m", "-90 m");
        let inputs = Inputs { meshes: [("g.msh".to_owned(), mesh.clone())].into(), ..Inputs::default() };
        let folder = tempfile::tempdir().unwrap();
        let job = Job::of_text(&text, folder.path(), &Given { inputs, ..Given::default() }).unwrap();
        for e in (0..mesh.elements.len() as u32).filter(|&e| centroid(&mesh, e)[2] < -64.0) {
            let (found, exact) = (
                job.model.water.pressure(e as usize, Stage::Before(0)),
                -9810.0 * (50.0 + centroid(&mesh, e)[2]),
            );
            assert!((found / exact - 1.0).abs() < 1e-12, "{turns} turns, element {e}: {found} for {exact}");
        }
    }
}
