//! Jobs: the same from a file, a text and a case, with what it names in files and in memory; what a refusal carries; a run in halves.

use std::path::Path;
use std::sync::atomic::AtomicBool;
use tremolite::RunError;
use tremolite::job::{Begun, Caller, Given, Inputs, Job, Loaded, Remark, Why};
use tremolite::laws;
use tremolite::run::Control;
use tremolite::simulation::{Ending, Go, Start, Stepping};
use tremolite_case::{Case, Change};
use tremolite_laws::LawInfo;
use tremolite_mesh::Mesh;
use tremolite_mesh::boxes::BoxSpec;
use tremolite_motion::Channel;
use tremolite_results::{ResultFolder, Status, Summary};

const CASE: &str = r#"title = "hall"
[mesh.file]
path = "hall.msh"
unit = "1 m"
[material.rock]
law = "mohr-coulomb"
young = "2 GPa"
poisson = 0.25
density = "2500 kg/m3"
cohesion = "1 MPa"
friction_angle = "40 deg"
tensile_strength = "0.5 MPa"
[material.spare]                  # of which no region is made
law = "elastic"
young = "2 GPa"
poisson = 0.25
density = "2500 kg/m3"
[[region]]
groups = ["rock", "core"]
material = "rock"
element = "reduced-integration"
[initial]
lateral = 0.5
release_cycles = 50
tolerance = 1e-4
[[stage]]
name = "bench"
excavate = ["core"]
[[stage.bolts]]
name = "wall"
file = "bolts.csv"
diameter = "25 mm"
young = "200 GPa"
yield = "400 MPa"
[motion]
kind = "incident"
east = { file = "pulse.txt", units = "m/s2", dt = "0.01 s" }
processing = ["baseline"]
[dynamic]
base = "viscous"
sides = "viscous"
duration = "0.1 s"
[[monitor]]
name = "crown"
at = ["8 m", "2 m", "10.5 m"]
[output]
histories = "0.01 s"
"#;

/// Rock of 16 × 4 × 16 m in cubes of 2 m, of which a core of 4 × 4 m along y is taken out.
fn mesh() -> Mesh {
    let mut mesh = BoxSpec::uniform([0.0; 3], [16.0, 4.0, 16.0], [8, 2, 8]).mesh().unwrap();
    let (core, rock) = (0..mesh.elements.len() as u32).partition(|&e| {
        let [x, _, z] = tremolite::hexahedra::centroid(&mesh, e);
        (x - 8.0).abs().max((z - 8.0).abs()) < 2.0
    });
    mesh.groups = [("core".to_owned(), core), ("rock".to_owned(), rock)].into();
    mesh
}

/// A Ricker pulse to six digits \[m/s²\], every 0.01 s.
fn pulse() -> Vec<String> {
    let at = |k: i32| {
        let t = (std::f64::consts::PI * 10.0 * (0.01 * f64::from(k) - 0.1)).powi(2);
        format!("{:.6}", (1.0 - 2.0 * t) * (-t).exp())
    };
    (0..40).map(at).collect()
}

const BOLT: [[f64; 3]; 2] = [[10.0, 2.0, 8.5], [14.0, 2.0, 8.5]];

/// The case with all that it names, as files.
fn files(folder: &Path) {
    std::fs::write(folder.join("case.toml"), CASE).unwrap();
    tremolite_mesh::write(folder.join("hall.msh"), &mesh()).unwrap();
    std::fs::write(folder.join("pulse.txt"), pulse().join("\n") + "\n").unwrap();
    let numbers: Vec<String> = BOLT.iter().flatten().map(f64::to_string).collect();
    std::fs::write(folder.join("bolts.csv"), numbers.join(",") + "\n").unwrap();
}

/// All that it names, in memory.
fn held() -> Inputs {
    let samples = pulse().iter().map(|x| x.parse().unwrap()).collect();
    Inputs {
        meshes: [("hall.msh".to_owned(), mesh())].into(),
        records: [("pulse.txt".to_owned(), vec![Channel::new("pulse", 0.01, samples)])].into(),
        bolts: [("bolts.csv".to_owned(), vec![BOLT])].into(),
        ..Inputs::default()
    }
}

fn in_memory(inputs: Inputs) -> Given {
    Given { inputs, ..Given::default() }
}

/// Names and bytes of the tables and fields in a result folder and in the folders there, and of the case.
fn tables(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let kept =
            path.extension().is_some_and(|e| ["csv", "vtu", "pvd", "toml"].iter().any(|kept| e == *kept));
        if path.is_dir() {
            found.extend(tables(&path));
        } else if kept {
            found.push((path.file_name().unwrap().to_string_lossy().into(), std::fs::read(&path).unwrap()));
        }
    }
    found.sort();
    found
}

fn make(parent: &Path, name: &str) -> ResultFolder {
    ResultFolder::create(Some(&parent.join(name)), name, false).unwrap()
}

/// Runs a job from its start, until it ends.
fn run(job: &Job, folder: &ResultFolder, start: Start) -> Result<Summary, RunError> {
    let mut control = Control { stop: &AtomicBool::new(false), progress: &mut |_| {} };
    job.run(folder, start, &Caller::new("test"), &mut control).map(|(_, summary)| summary)
}

fn change(key: &str, value: &str) -> Vec<Change> {
    vec![Change::new(key, value)]
}

#[test]
fn files_texts_and_cases_with_all_in_memory_give_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let parent = folder.path();
    files(parent);
    // Where no file is.
    let empty = tempfile::tempdir().unwrap();
    let infos: Vec<LawInfo> = laws().iter().map(|law| law.info).collect();
    let case = Case::parse(&empty.path().join("case.toml"), CASE, &infos).unwrap();
    let mut other = held();
    other.records["pulse.txt"][0].acceleration[12] += 1e-6;
    let jobs = [
        Job::read(&parent.join("case.toml"), &Given::default()),
        Job::of_text(CASE, parent, &Given::default()),
        Job::of(&case, &in_memory(held())),
        Job::of_text(CASE, empty.path(), &in_memory(other)),
    ]
    .map(|job| job.unwrap_or_else(|fault| panic!("{fault}")));
    let mut found = Vec::new();
    for (job, name) in jobs.iter().zip(["file", "text", "case", "other"]) {
        let results = make(parent, name);
        let summary = run(job, &results, Start::Rest).unwrap();
        assert_eq!(summary.conclusion.status, Status::Done, "{name}: {}", summary.conclusion.verdict);
        assert_eq!(std::fs::read_to_string(results.case()).unwrap(), CASE);
        assert_eq!(Summary::read(&results.summary()).unwrap().case.inputs, summary.case.inputs);
        found.push((tables(results.root()), summary.case.inputs));
    }
    let [(file, of_file), (text, of_text), (case, of_case), (other, of_other)] = found.try_into().unwrap();
    for wanted in ["monitors.csv", "energy.csv", "stages.csv", "motion.csv", "bolts.csv", "case.toml"] {
        assert!(file.iter().any(|(name, _)| name == wanted), "{wanted}");
    }
    assert!(file == text && file == case);
    // The comparison sees a thousandth of a gal, and so do the hashes of what was in memory.
    assert!(file != other);
    assert_eq!(of_file, of_text);
    let input = |of: &[tremolite_results::Input], name: &str| {
        of.iter().find(|input| input.name == name).unwrap_or_else(|| panic!("{name}")).clone()
    };
    for name in ["hall.msh", "pulse.txt", "bolts.csv"] {
        assert!(!input(&of_file, name).path.is_empty(), "{name}");
        let (here, there) = (input(&of_case, name), input(&of_other, name));
        assert!(here.path.is_empty() && here.hash.len() == 64, "{here:?}");
        assert_eq!(here.hash == there.hash, name != "pulse.txt", "{name}");
    }
    // The cases that the folders keep say what is not as it was then.
    let kept = |name: &str, given: &Given| -> Vec<String> {
        let job = Job::read(&parent.join(name).join("case.toml"), given).unwrap_or_else(|f| panic!("{f}"));
        job.said().into_iter().skip(job.warnings().count()).collect()
    };
    assert!(kept("file", &Given::default()).is_empty());
    assert!(kept("case", &in_memory(held())).is_empty());
    assert_eq!(
        kept("other", &in_memory(held())),
        ["pulse.txt is not what that run had in memory: its contents have changed"]
    );
    let told = kept("file", &in_memory(held()));
    assert!(
        told.len() == 3 && told.iter().all(|what| what.ends_with("may not be what that run read")),
        "{told:?}"
    );
}

#[test]
fn a_job_can_be_handed_to_another_thread() {
    fn whole<T: Send + Sync>() {}
    whole::<Job>();
    whole::<Given>();
    whole::<Begun>();
}

#[test]
fn a_refusal_carries_what_was_found_unusual_before_in_its_order() {
    let folder = tempfile::tempdir().unwrap();
    files(folder.path());
    let path = folder.path().join("case.toml");
    let with = |changes: Vec<Change>| Given { changes, ..Given::default() };
    let words = |remarks: &[Remark]| -> Vec<String> { remarks.iter().map(|r| r.render(false)).collect() };
    let spare = "no region is made of `spare`";

    // Of the text alone there is nothing before.
    let fault = Loaded::read(&path, &with(change("material.rock.yung", "3"))).err().unwrap();
    let Why::Case(report) = &fault.why else { panic!("{fault}") };
    assert_eq!(report.problems[0].key, "material.rock.yung");
    assert!(fault.remarks.is_empty());
    // Of what the case names: the text's own.
    let fault = Loaded::read(&path, &with(change("mesh.file.path", "bolts.csv"))).err().unwrap();
    let Why::Case(report) = &fault.why else { panic!("{fault}") };
    assert_eq!(report.problems[0].key, "mesh.file.path");
    let [before] = &words(&fault.remarks)[..] else { panic!("{:?}", fault.remarks) };
    assert!(before.contains(spare), "{before}");
    // Of the model: what was found unusual of that as well.
    let endless = with(change("material.rock.young", "1e25 GPa"));
    let of_case = Loaded::read(&path, &endless).unwrap_or_else(|fault| panic!("{fault}")).remarks();
    let fault = Job::read(&path, &endless).err().unwrap();
    assert!(matches!(fault.why, Why::Endless { .. }), "{fault}");
    assert_eq!(fault.remarks[..of_case.len()], of_case);
    let of_model = &words(&fault.remarks)[of_case.len()..];
    assert!(of_model.iter().any(|remark| remark.contains("from an opening of")), "{of_model:?}");
    // A job that can be run has them all, those of the model last.
    let job = Job::read(&path, &with(change("dynamic.time_step", "1 s"))).unwrap_or_else(|f| panic!("{f}"));
    let said = job.said();
    assert!(said[0].contains(spare), "{said:?}");
    assert!(said.iter().any(|s| s.contains("above the stable step")), "{said:?}");
    assert_eq!(job.warnings().count(), said.len());
    assert!(words(&job.remarks())[0].contains("above the stable step"));
}

#[test]
fn a_check_foretells_what_the_run_does() {
    let folder = tempfile::tempdir().unwrap();
    let job = Job::of_text(CASE, folder.path(), &in_memory(held())).unwrap_or_else(|fault| panic!("{fault}"));
    let checked = serde_json::to_value(job.check()).unwrap();
    let summary = run(&job, &make(folder.path(), "out"), Start::Rest).unwrap();
    assert_eq!(checked["time_step"]["steps"], summary.computed.model.steps);
    assert_eq!(checked["time_step"]["used"], summary.computed.model.time_step);
    assert_eq!(checked["elements"], summary.computed.model.elements);
    assert_eq!(checked["stages"].as_array().unwrap().len(), summary.computed.stages.len());
    assert_eq!(checked["defaults_used"], serde_json::to_value(&summary.case.defaults_used).unwrap());
    assert_eq!(checked["findings"].as_array().unwrap().len(), summary.case.warnings.len());
    assert_eq!(checked["findings"][0]["key"], "material.spare");
}

#[test]
fn a_run_in_two_halves_is_one() {
    let folder = tempfile::tempdir().unwrap();
    let parent = folder.path();
    let given = in_memory(held());
    let job = Job::of_text(CASE, parent, &given).unwrap_or_else(|fault| panic!("{fault}"));
    let whole = make(parent, "whole");
    let summary = run(&job, &whole, Start::Rest).unwrap();
    assert_eq!((summary.conclusion.status, summary.computed.run.resumed), (Status::Done, 0));

    // Stopped half way through the shaking, by a program that drives it by itself.
    let halves = make(parent, "halves");
    let begun = job.begin(&halves, Start::Rest).unwrap();
    let mut simulation = begun.simulation(&job, Vec::new()).unwrap();
    while simulation.stage().is_some() {
        simulation.relax(&mut |_| Go::On).unwrap();
    }
    let half = simulation.steps().1.total / 2;
    assert!(matches!(simulation.step(half).unwrap(), Stepping::On));
    assert!(simulation.checkpoint().unwrap().is_none());
    let outcome = simulation.finish(Ending::Stopped, 0.0).unwrap();
    let stopped = begun.end(&job, &outcome, &Caller::new("test")).unwrap();
    assert_eq!((stopped.conclusion.status, stopped.computed.model.steps), (Status::Stopped, half));
    assert_ne!(tables(whole.root()), tables(halves.root()), "half of it is not all of it");
    drop((begun, halves, simulation));

    // Another case, and another record in memory, are not resumed.
    let again = || ResultFolder::resume(Some(&parent.join("halves")), "halves").unwrap();
    let text = CASE.replace("\"hall\"", "\"hall two\"");
    let renamed = Job::of_text(&text, parent, &given).unwrap_or_else(|fault| panic!("{fault}"));
    assert!(matches!(run(&renamed, &again(), Start::Resume), Err(RunError::OtherCase { .. })));
    let mut inputs = held();
    inputs.records["pulse.txt"][0].acceleration[30] += 1e-6;
    let other = Job::of_text(CASE, parent, &in_memory(inputs)).unwrap_or_else(|fault| panic!("{fault}"));
    assert!(matches!(run(&other, &again(), Start::Resume), Err(RunError::Checkpoint(_))));
    let resumed = run(&job, &again(), Start::Resume).unwrap();
    assert_eq!((resumed.conclusion.status, resumed.computed.run.resumed), (Status::Done, 1));
    assert!(tables(whole.root()) == tables(&parent.join("halves")));

    // What it had come to before the earthquake another run can begin with, and one without an earthquake cannot.
    let shaken = make(parent, "shaken");
    let summary = run(&job, &shaken, Start::From(&whole)).unwrap();
    assert_eq!(summary.conclusion.status, Status::Done);
    let of = |root: &Path| std::fs::read(root.join("monitors.csv")).unwrap();
    assert!(of(shaken.root()) == of(whole.root()));
    let text = CASE.split_once("[motion]").unwrap().0;
    let still = Job::of_text(text, parent, &given).err().unwrap();
    assert!(still.to_string().contains("pulse.txt"), "{still}");
    let mut inputs = held();
    inputs.records.clear();
    let still = Job::of_text(text, parent, &in_memory(inputs)).unwrap_or_else(|fault| panic!("{fault}"));
    assert!(matches!(still.check_start(Start::From(&whole)), Err(RunError::RestAlone)));
}

/// Where the mesh ends says little of where a lining does.
#[test]
fn a_monitor_beside_its_body_is_told_where_that_is() {
    let folder = tempfile::tempdir().unwrap();
    files(folder.path());
    for (stage, says) in [
        (
            "{ name = \"bench\", excavate = [\"core\"] }",
            "nothing of its body is there when the ground shakes",
        ),
        ("{ name = \"bench\" }", "its body spans x 6 to 10, y 0 to 4, z 6 to 10 m"),
    ] {
        let text = CASE.replace(
            "at = [\"8 m\", \"2 m\", \"10.5 m\"]",
            "at = [\"8 m\", \"2 m\", \"10.5 m\"]\nbody = \"core\"",
        );
        let changes = change("stage", &format!("[{stage}]"));
        let fault = Job::of_text(&text, folder.path(), &Given { changes, ..Given::default() }).err();
        let fault = fault.expect("it must be refused").to_string();
        assert!(fault.contains("lies in no element of its body") && fault.contains(says), "{fault}");
    }
}

#[test]
fn what_is_in_memory_and_cannot_be_used_is_refused_where_the_case_names_it() {
    let empty = tempfile::tempdir().unwrap();
    let refusal = |spoil: &dyn Fn(&mut Inputs)| {
        let mut inputs = held();
        spoil(&mut inputs);
        let fault = Job::of_text(CASE, empty.path(), &in_memory(inputs)).err().expect("it must be refused");
        let Why::Case(report) = fault.why else { panic!("{fault}") };
        (report.problems[0].key.clone(), report.to_string())
    };
    let mesh = |inputs: &mut Inputs, spoil: &dyn Fn(&mut Mesh)| spoil(&mut inputs.meshes["hall.msh"]);
    let record =
        |inputs: &mut Inputs, spoil: &dyn Fn(&mut Channel)| spoil(&mut inputs.records["pulse.txt"][0]);
    type Spoil<'a> = &'a dyn Fn(&mut Inputs);
    let spoils: [(&str, &str, Spoil); 11] = [
        ("mesh.file.path", "node of index 999", &|i| mesh(i, &|m| m.elements[3].nodes[5] = 999)),
        ("mesh.file.path", "there is no file hall.msh", &|i| i.meshes.clear()),
        ("motion.east.file", "sample 6 of 'pulse' is NaN", &|i| record(i, &|c| c.acceleration[5] = f64::NAN)),
        ("motion.east.file", "dt = \"0.01 s\" was declared", &|i| record(i, &|c| c.dt = 0.02)),
        ("motion.east.file", "interval of 0 s", &|i| record(i, &|c| c.dt = 0.0)),
        ("motion.east.file", "has 1 samples", &|i| record(i, &|c| c.acceleration.truncate(1))),
        ("motion.east.file", "is in counts", &|i| record(i, &|c| c.raw = true)),
        ("motion.east.file", "no channels", &|i| i.records["pulse.txt"].clear()),
        ("stage[0].bolts[0].file", "one place", &|i| i.bolts["bolts.csv"][0][1] = BOLT[0]),
        ("", "'hall.msh' is in memory among bolts, but no key", &|i| {
            i.bolts.insert("hall.msh".into(), vec![BOLT]);
        }),
        ("", "'pulse2.txt' is in memory among records, but no key", &|i| {
            i.records.insert("pulse2.txt".into(), Vec::new());
        }),
    ];
    for (key, says, spoil) in spoils {
        let (found, text) = refusal(spoil);
        assert!(text.contains(says), "{says}: {text}");
        assert_eq!(found, key, "{text}");
    }
}
