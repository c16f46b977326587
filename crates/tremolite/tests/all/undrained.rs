//! Cases with water that cannot leave in the earthquake: what is refused, what is said, ground that moves as theory has it, and a run that
//! is stopped in it.

use crate::held::files;
use crate::waves_at_angles::given;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use tremolite::job::{Caller, Job};
use tremolite::run::Control;
use tremolite::simulation::{Ending, Go, Start, Stepping};
use tremolite_results::{ResultFolder, Status, Summary, Table};

/// The paper's rock with grains of 45 GPa, 1 % of pores, on elements of 10 × 10 × 5 m.
const GROUND: &str = r#"title = "wet ground"
[mesh.box]
x = { to = "30 m", elements = 3 }
y = { to = "20 m", elements = 2 }
z = { from = "-120 m", to = "0 m", elements = 24 }
[water]
level = "-30 m"
earthquake = "undrained"
[material.rock]
law = "elastic"
young = "10 GPa"
poisson = 0.25
density = "2752 kg/m3"
water = { biot = 0.8518518518518519, porosity = "1 %" }
[[region]]
groups = ["*"]
material = "rock"
element = "reduced-integration"
[initial]
lateral = 0.8
[motion]
kind = "incident"
east = { file = "pulse.txt", units = "m/s2", dt = "0.005 s" }
up = { from = "east", factor = 0.5 }
processing = ["baseline"]
[dynamic]
sides = "free-field"
duration = "0.5 s"
levels = 1
[[monitor]]
name = "A"
at = ["15 m", "10 m", "-57 m"]
[[monitor]]
name = "B"
at = ["15 m", "10 m", "-17 m"]
[output]
histories = "0.01 s"
"#;

fn job(text: &str) -> Job {
    Job::of_text(text, Path::new("."), &given()).unwrap_or_else(|fault| panic!("{fault}"))
}

fn run(job: &Job, folder: &ResultFolder, start: Start) -> Summary {
    let mut control = Control { stop: &AtomicBool::new(false), progress: &mut |_| {} };
    let (_, summary) = job.run(folder, start, &Caller::new("test"), &mut control).unwrap();
    assert_eq!(summary.conclusion.status, Status::Done, "{}", summary.conclusion.verdict);
    summary
}

fn trust(summary: &Summary, id: &str) -> f64 {
    let line = summary.soundness.checks.iter().find(|line| line.id == id).unwrap();
    assert!(line.pass && !line.not_applicable, "{line:?}");
    line.value
}

#[test]
fn pores_that_no_rock_has_are_refused_before_anything_is_computed() {
    let refused = |from: &str, to: &str, words: &[&str]| {
        assert!(GROUND.contains(from), "{from}");
        let text = GROUND.replacen(from, to, 1);
        let fault =
            Job::of_text(&text, Path::new("."), &given()).err().unwrap_or_else(|| panic!("{to} is taken"));
        let fault = fault.to_string();
        let line = 1 + text.lines().position(|line| line.contains(to)).unwrap();
        words.iter().for_each(|word| assert!(fault.contains(word), "{to}: no '{word}' in {fault}"));
        assert!(fault.contains(&format!("toml:{line}")), "{fault}");
    };
    let pores = "biot = 0.8518518518518519, porosity = \"1 %\"";
    refused(pores, "biot = 0.8518518518518519", &["nothing says how much water", "skempton"]);
    refused(
        pores,
        "biot = 1, porosity = \"1 %\"",
        &["226.667 GPa", "any grains", "60 GPa", "larger `porosity`"],
    );
    refused(pores, "biot = 0.95, skempton = 0.999", &["any grains", "smaller `biot`"]);
    // Only a fluid stiffer than the grains makes more of them than they are.
    let stiff = GROUND.replace("level = \"-30 m\"", "level = \"-30 m\"\nbulk_modulus = \"60 GPa\"");
    let fault = Job::of_text(&stiff, Path::new("."), &given()).err().unwrap().to_string();
    assert!(fault.contains("its own grains, K/(1 − biot), 45 GPa"), "{fault}");
    refused(pores, "biot = 0.1, porosity = 0.2", &["porosity", "grains"]);
    refused(pores, "skempton = 1.0", &["below 1"]);
    refused("\"undrained\"", "\"sealed\"", &["drained", "undrained"]);
}

#[test]
fn what_water_makes_of_a_material_is_said() {
    let of = |text: &str, name: &str| {
        let values = job(text).materials["rock"].values.clone();
        values.into_iter().find(|value| value.name == name).map(|value| value.value)
    };
    let near = |name: &str, exact: f64| {
        let found = of(GROUND, name).unwrap();
        assert!((found / exact - 1.0).abs() < 1e-12, "{name}: {found} instead of {exact}");
        found
    };
    let b = near("skempton_coefficient", 0.9672732833766632);
    near("undrained_bulk_modulus", 37_873_093_506.660_66);
    near("undrained_wave_speed_p", 3962.3237819371598);
    // The same by Skempton's coefficient.
    let by_b = GROUND.replace("porosity = \"1 %\"", &format!("skempton = {b}"));
    assert!((of(&by_b, "undrained_bulk_modulus").unwrap() / 37_873_093_506.660_66 - 1.0).abs() < 1e-12);
    assert_eq!(of(&GROUND.replace("undrained", "drained"), "skempton_coefficient"), None);
}

/// Slabs, columns, base and theory know of the water: below the level in P waves 3,962 m/s, above it 2,088.
#[test]
fn ground_below_the_water_moves_as_theory_has_it() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| ResultFolder::create(Some(&folder.path().join(name)), name, true).unwrap();
    let (wet, dry) = (at("undrained"), at("drained"));
    let tight = GROUND.replace("\"1 %\"", "\"1 %\", hydraulic_conductivity = \"1e-8 m/s\"");
    let summary = run(&job(&tight), &wet, Start::Rest);
    // √(c_v T) beside the drained ground above the level, elements of 10 × 10 × 5 m.
    let diffusivity: f64 =
        1e-8 / 9810.0 * 43_004_697_857.004_96 * 12e9 / (37_873_093_506.660_66 + 16e9 / 3.0);
    let way = trust(&summary, "pore_water_drainage");
    assert!((way / ((diffusivity * 0.5).sqrt() / 5.0) - 1.0).abs() < 1e-2, "{way}");
    // Theory of drained ground would be off by far more than a tenth.
    assert!(trust(&summary, "free_field_theory") < 0.02);
    assert!(trust(&summary, "free_field_at_model_edges") < 1e-9);
    assert_eq!(trust(&summary, "pore_water_at_the_floor"), 0.0);
    trust(&summary, "energy_error");
    let summary = run(&job(&GROUND.replace("undrained", "drained")), &dry, Start::Rest);
    let stays = summary.soundness.checks.iter().find(|line| line.id == "pore_water_at_the_floor").unwrap();
    assert!(stays.not_applicable);
    let [wet, dry] = [wet, dry].map(|folder| Table::read(&folder.monitors()).unwrap());
    let largest = |table: &Table, name: &str| {
        let column = table.column(name).unwrap();
        column.iter().map(|x| (x - column[0]).abs()).fold(0.0, f64::max)
    };
    assert!((largest(&dry, "A.p"), largest(&dry, "B.p")) == (0.0, 0.0));
    // B = αM/K_u of what presses all round, of which the vertical share follows in a P wave: p changes by αM/(K_u + 4G/3) of σ_zz.
    let (p, s) = (largest(&wet, "A.p"), largest(&wet, "A.szz"));
    let share = 0.8518518518518519 * 43_004_697_857.004_96 / (37_873_093_506.660_66 + 16e9 / 3.0);
    assert!(p > 1e3 && (p / s / share - 1.0).abs() < 1e-6, "{p} of {s}: {}", p / s / share);
    assert!(largest(&wet, "B.p") == 0.0, "no water above the level");
}

/// The free field of a wave at an angle, on base and sides, is that of the water as well.
#[test]
fn waves_at_angles_go_through_wet_ground_as_theory_has_it() {
    let wave =
        "[[motion.wave]]\ntype = \"P\"\nangle = \"30 deg\"\nazimuth = \"30 deg\"\ncomponent = \"east\"\n";
    let aslant = GROUND
        .replace("up = { from = \"east\", factor = 0.5 }\n", "")
        .replace("[dynamic]", &format!("{wave}[dynamic]"));
    let folder = tempfile::tempdir().unwrap();
    let results = ResultFolder::create(Some(folder.path()), "aslant", true).unwrap();
    let found = trust(&run(&job(&aslant), &results, Start::Rest), "free_field_at_model_edges");
    assert!(found < 0.03, "{found}");
}

#[test]
fn an_undrained_earthquake_goes_on_where_it_was_stopped() {
    let parent = tempfile::tempdir().unwrap();
    let at = |name: &str| ResultFolder::create(Some(&parent.path().join(name)), name, true).unwrap();
    let job = job(GROUND);
    let whole = at("whole");
    run(&job, &whole, Start::Rest);
    let halves = at("halves");
    let begun = job.begin(&halves, Start::Rest).unwrap();
    let mut simulation = begun.simulation(&job, Vec::new()).unwrap();
    while simulation.stage().is_some() {
        simulation.relax(&mut |_| Go::On).unwrap();
    }
    let half = simulation.steps().1.total / 2;
    assert!(matches!(simulation.step(half).unwrap(), Stepping::On));
    simulation.checkpoint().unwrap();
    let outcome = simulation.finish(Ending::Stopped, 0.0).unwrap();
    begun.end(&job, &outcome, &Caller::new("test")).unwrap();
    drop((begun, halves, simulation));
    let resumed = ResultFolder::resume(Some(&parent.path().join("halves")), "halves").unwrap();
    run(&job, &resumed, Start::Resume);
    let tables = |folder: &ResultFolder| {
        let mut all = files(folder.root());
        all.retain(|name, _| name.extension().is_some_and(|end| end == "csv"));
        all
    };
    assert!(tables(&whole).len() > 3 && tables(&whole) == tables(&resumed));
}

/// Artificial viscosity is a share of critical damping at an element's own highest frequency, that with water: alike elements leave about √(1 + b²) − b of
/// the step. The mesh's highest mode has a little more shear in it than one element's, which is damped more; against the rock without its
/// water b would be below 0.1 here.
#[test]
fn viscosity_goes_by_the_frequency_with_water() {
    let wet = GROUND.replace("level = \"-30 m\"", "level = \"0 m\"");
    let job = job(&wet
        .replace("element = \"reduced-integration\"", "element = \"reduced-integration\"\nviscosity = 0.2"));
    let left = tremolite::engine::viscous_share;
    let share = job.stable.dt / job.stable.undamped;
    assert!(share > left(0.22) && share < left(0.18), "{share}: {} to {}", left(0.22), left(0.18));
}
