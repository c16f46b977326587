//! A lined cavern under a strong pulse: histories as fields, in the summary and in the verdict; bits; resuming.

use crate::ready::Ready;
use indexmap::IndexMap;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use tremolite::damage::{damage, findings};
use tremolite::disk::{Pores, field_bytes};
use tremolite::plan::{Monitor, Plan};
use tremolite::quantities::Field;
use tremolite::run::{Control, run};
use tremolite::simulation::{Built, Ending, Outcome, Simulation, Start};
use tremolite::{
    AnyMaterial, Base, Body, Incident, Problem, Quadrature, Rayleigh, Side, elastic, hexahedra, laws,
};
use tremolite_laws::{Isa, Moduli, Values};
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::locate::Locator;
use tremolite_mesh::vtu::{Array, Grid, Values as ArrayValues};
use tremolite_results::{CrackDirection, GroupDamage, ResultFolder, Severity, Table};

/// A hall of 4 × 4 m in a block of 16 × 3 × 14 m, its lining of 1 m of a concrete of 0.6 MPa tensile strength.
fn hall() -> Problem {
    hall_of(0.6e6, "effective")
}

/// Concrete of a tensile strength \[Pa\].
pub fn concrete(strength: f64, split: &str) -> Arc<dyn AnyMaterial> {
    let mut values = Values::default()
        .with("young", 25e9)
        .with("poisson", 0.17)
        .with("tensile_strength", strength)
        .with("cohesion", f64::max(2e6, 10.0 * strength))
        .with("friction_angle", 0.8)
        .with("fracture_energy", 130.0);
    for (key, word) in [("evolution", "residual"), ("split", split)] {
        values.0.insert(key.into(), tremolite_laws::parameter::Value::Word(word.into()));
    }
    let law = laws().into_iter().find(|l| l.info.name == "concrete-damage").unwrap();
    (law.build)(&values).unwrap()
}

pub fn hall_of(strength: f64, split: &str) -> Problem {
    let mut mesh = BoxSpec::uniform([0.0; 3], [16.0, 3.0, 14.0], [16, 3, 14]).mesh().unwrap();
    mesh.groups.clear();
    for e in 0..mesh.elements.len() as u32 {
        let [x, _, z] = hexahedra::centroid(&mesh, e).map(|x| x - 0.5);
        let (x, z) = (x.round() as i32, z.round() as i32);
        let mut add = |name: &str| mesh.groups.entry(name.into()).or_default().push(e);
        if (6..10).contains(&x) && (5..9).contains(&z) {
            add("hall.excavation");
        } else if (5..11).contains(&x) && (4..10).contains(&z) {
            add("hall.lining");
            add(if z == 9 { "hall.lining.crown" } else { "hall.lining.walls" });
        } else {
            add("rock");
        }
    }
    let rock = elastic(Moduli::from_young_poisson(10e9, 0.25));
    let body = |name: &str, group: &str, material: Arc<dyn AnyMaterial>, quadrature, viscosity| Body {
        name: name.into(),
        elements: mesh.groups[group].clone(),
        material,
        density: 2700.0,
        quadrature,
        viscosity,
    };
    let bodies = vec![
        body("rock", "rock", rock, Quadrature::OnePoint, 0.0),
        body("*.lining", "hall.lining", concrete(strength, split), Quadrature::Full, 0.06),
    ];
    let mut problem = Problem::new(mesh, bodies);
    problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: None };
    problem.sides = [Side::Periodic; 2];
    problem.rayleigh = Rayleigh { mass: 0.4, stiffness: 0.0 };
    problem.incident = Some(Incident { motion: crate::block::pulse(), factor: 0.5 });
    problem.patch_elements = Some(16);
    problem
}

/// Runs the hall into a folder; stops at the first chance after `stop_after` \[s\] of simulated time.
fn go(problem: Problem, folder: &Path, threads: usize, resume: bool, stop_after: f64) -> (Ready, Outcome) {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(|| {
        let lining = problem.mesh.groups["hall.lining"].clone();
        let locator = Locator::new(&problem.mesh, Some(&lining));
        let monitor = |name: &str, point| Monitor {
            name: name.into(),
            point,
            location: locator.locate(point, 1e-6).unwrap(),
        };
        let monitors = vec![
            monitor("crown", [8.0, 1.5, 9.0]),
            monitor("foot", [6.0, 1.5, 5.0]),
            monitor("wall", [6.0, 1.5, 7.0]),
        ];
        let plan = Plan {
            page: tremolite_results::PageWish::default(),
            boundaries: Default::default(),
            target: None,
            title: "hall".into(),
            stages: Vec::new(),
            duration: 0.3,
            recorded: None,
            waves: None,
            histories: 0.002,
            snapshots: Some(0.1),
            fields: Field::ALL.to_vec(),
            field_elements: 250_000,
            checkpoint: None,
            monitors,
            pairs: Vec::new(),
            bolts: Vec::new(),
            bars: 0,
            water: false,
            relatives: Vec::new(),
            sections: Vec::new(),
        };
        let ready = Ready::new(problem);
        let results = if resume {
            ResultFolder::open_existing(folder).unwrap()
        } else {
            ResultFolder::create(Some(folder), "hall", true).unwrap()
        };
        let stop = AtomicBool::new(false);
        let mut tell = |p: tremolite::run::Progress| stop.store(p.time > stop_after, Ordering::Relaxed);
        let mut control = Control { stop: &stop, progress: &mut tell };
        let outcome = Simulation::new(
            &Built::of(&ready.model, &ready.assembly, &ready.phase),
            &plan,
            &results,
            if resume { Start::Resume } else { Start::Rest },
            Vec::new(),
        )
        .and_then(|simulation| run(simulation, &mut control))
        .unwrap();
        (ready, outcome)
    })
}

fn damaged(ready: &Ready, outcome: &Outcome) -> IndexMap<String, GroupDamage> {
    damage(&ready.model, &ready.phase, outcome.history(&ready.assembly), &outcome.state.observers)
}

#[test]
fn a_weak_lining_cracks_and_fields_summary_and_verdict_say_where_and_how_far() {
    let folder = tempfile::tempdir().unwrap();
    let (ready, outcome) = go(hall(), folder.path(), 2, false, f64::INFINITY);
    assert_eq!(outcome.ending, Ending::Done);
    let found = damaged(&ready, &outcome);
    let names: Vec<&str> = found.keys().map(String::as_str).collect();
    assert_eq!(
        names,
        ["hall.lining", "hall.lining.crown", "hall.lining.walls"],
        "not the rock, nothing twice"
    );
    let [lining, crown, walls] = [0, 1, 2].map(|i| &found[i]);
    assert!((lining.volume - 60.0).abs() < 1e-9 && (crown.volume - 18.0).abs() < 1e-9);
    let beyond = |g: &GroupDamage, t: &str| g.measures["d_tension"].beyond[t];
    for threshold in ["0.1", "0.5", "0.9"] {
        let parts = beyond(crown, threshold) + beyond(walls, threshold);
        assert!((beyond(lining, threshold) - parts).abs() < 1e-9, "parts make the whole");
    }
    assert!(beyond(lining, "0.9") > 1.0 && beyond(lining, "0.9") <= beyond(lining, "0.5"));
    assert!(beyond(lining, "0.1") < lining.volume, "not all of it cracks");
    let tension = &lining.measures["d_tension"];
    assert!(tension.largest > 0.9 && tension.largest <= 1.0);
    let first = tension.first.unwrap();
    assert!(first.time > 0.0 && first.time < 0.3);
    let parts = [crown, walls].map(|g| g.measures["d_tension"].first.map_or(f64::INFINITY, |f| f.time));
    assert_eq!(first.time, parts[0].min(parts[1]));
    let told = findings(&ready.model, &found);
    assert_eq!(told.len(), 1, "the whole is enough for a verdict: {told:?}");
    let share = 100.0 * beyond(lining, "0.5") / lining.volume;
    assert!(told[0].headline.starts_with(&format!("cracked in {share:.1} % of its volume")), "{told:?}");
    let began = format!("First cracked at {:.2} s in element {}", first.time, first.element);
    assert!(told[0].text.contains(&began), "{told:?}");

    // One element thick, of bricks: all but the four corners are passed through, at three places along the hall.
    let cracks = lining.cracks.as_ref().unwrap();
    assert_eq!(cracks.stacks, 3 * 16);
    assert_eq!(told[0].severity == Severity::Through, cracks.through > 0);
    let widest = cracks.widest.unwrap();
    assert!(widest.time >= first.time && cracks.opening > 1e-6 && cracks.opening < 0.05, "{cracks:?}");
    // The widest crack of all runs through here, so it is the one that is named, and not the first in the order of elements.
    assert!(cracks.through > 1);
    assert_eq!(cracks.through_at.unwrap().element, widest.element);
    let named = format!("The widest of these cracks is in element {} at", widest.element);
    assert!(told[0].text.starts_with(&named), "{told:?}");
    assert!(crown.cracks.as_ref().unwrap().opening <= cracks.opening);

    // By direction: the widest of all is one of them, and of the parts the whole's.
    let of = |cracks: &tremolite_results::Cracks| {
        cracks.directions.iter().map(|d| d.opening).collect::<Vec<f64>>()
    };
    let all = of(cracks);
    assert_eq!(all.len(), CrackDirection::ALL.len());
    assert_eq!(all.iter().copied().fold(0.0, f64::max), cracks.opening, "{all:?}");
    let parts = [crown, walls].map(|g| of(g.cracks.as_ref().unwrap()));
    assert_eq!(all, (0..all.len()).map(|k| parts[0][k].max(parts[1][k])).collect::<Vec<f64>>());
    assert!(cracks.directions.iter().all(|d| d.left <= d.opening && (d.opening > 0.0) == d.widest.is_some()));
    // The hall is as long as the block, and a motion across it bends its ring.
    assert_eq!(cracks.across().unwrap().direction, CrackDirection::Longitudinal, "{cracks:?}");
    // Where walls meet nothing tells which way they run: the four corners of the ring.
    let corner = cracks.directions[CrackDirection::Unplaced as usize].widest;
    assert!(
        corner.is_none_or(|c| [5.5, 10.5].contains(&c.at[0]) && [4.5, 9.5].contains(&c.at[2])),
        "{corner:?}"
    );

    // The table over time ends with the shares of the summary, and never falls.
    let table = tremolite_results::Table::read(&folder.path().join("damage.csv")).unwrap();
    for (column, last) in [("d_tension", 0.01 * share), ("crack_opening", cracks.opening)] {
        let values = table.column(&format!("hall.lining.{column}")).unwrap();
        let unit = if column == "d_tension" { "m3/m3" } else { "m" };
        assert_eq!(table.unit(&format!("hall.lining.{column}")), Some(unit));
        assert!(values[0] == 0.0 && values.is_sorted() && (values.last().unwrap() / last - 1.0).abs() < 1e-9);
    }

    // So do the columns of each direction.
    for of in &cracks.directions {
        let values = table.column(&format!("hall.lining.{}", of.direction.column())).unwrap();
        assert!(values[0] == 0.0 && values.is_sorted() && values.last() == Some(&of.opening), "{of:?}");
    }

    // Cells of the last file, mean over eight equal points, add up to no more than what is beyond 0 and 0.9.
    let grid = Grid::read(&folder.path().join("fields/000003.vtu")).unwrap();
    let cells = |name: &str| {
        let array = grid.cell_array(name).unwrap_or_else(|| panic!("{name} is written"));
        (0..array.values.len()).map(|i| array.values.get(i)).collect::<Vec<f64>>()
    };
    let group = cells("body");
    let numbers = cells("element");
    assert_eq!(cells("group:hall.lining"), group);
    let crown: Vec<f64> =
        ready.model.mesh.groups["hall.lining.crown"].iter().map(|&e| f64::from(e) + 1.0).collect();
    let marked = numbers.iter().zip(cells("group:hall.lining.crown")).filter(|(_, inside)| *inside == 1.0);
    assert_eq!(marked.map(|(n, _)| *n).collect::<Vec<f64>>(), crown, "by the numbers of messages");
    assert!(grid.cell_array("group:hall.excavation").is_none(), "nothing of it is left");
    for name in ["d_tension", "d_shear", "d_b", "d_b_max"] {
        let values = cells(name);
        assert!(values.iter().all(|d| (0.0..=1.0).contains(d)), "{name}");
        assert!(group.iter().zip(&values).all(|(g, d)| *g == 1.0 || *d == 0.0), "{name}: rock has none");
    }
    // The bytes of a file before compression are those that are told beforehand.
    let values: usize = grid.point_data.iter().map(|a| 4 * a.values.len()).sum();
    let own = |name: &str| name == "element" || name == "body" || name.starts_with("group:");
    let of_cells = grid.cell_data.iter().filter(|a| !own(&a.name));
    let bytes = |a: &Array| if matches!(a.values, ArrayValues::UInt8(_)) { 1 } else { 4 };
    let values = values + of_cells.map(|a| bytes(a) * a.values.len()).sum::<usize>();
    let marks = grid.cell_data.iter().filter(|a| a.name.starts_with("group:")).count();
    let mesh =
        24 * grid.points.len() + 8 * grid.connectivity.len() + (8 + 1 + 8 + 4 + marks) * grid.types.len();
    assert_eq!(
        field_bytes(&ready.model, &ready.phase, &Field::ALL, Pores::None),
        (mesh as u64, values as u64)
    );
    // By direction: of the whole what the summary has, by element one of them is the widest.
    let [all, across, ways] = ["crack_opening", "crack_across", "crack_direction"].map(cells);
    let most = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    let widest = cracks.across().unwrap().opening;
    assert!((most(&across) / widest - 1.0).abs() < 1e-6, "{} and {widest}", most(&across));
    let parallel = f64::from(CrackDirection::Parallel.number());
    for (k, way) in ways.iter().enumerate() {
        let open = all[k] > 0.0;
        assert!((0.0..=4.0).contains(way) && open == (*way > 0.0) && across[k] <= all[k], "{k}: {way}");
        assert_eq!(open && *way != parallel, open && across[k] == all[k], "{k}: {way}");
    }
    assert!(ways.contains(&parallel) && ways.contains(&1.0), "{ways:?}");
    // Strained fast, concrete cracked later than it would have: by the mean of an element no more than at its points.
    let rate = tension.rate.unwrap();
    let factors = cells("factor_tension");
    assert!(
        rate.largest > (1.0 - 1e-6) * most(&factors) && rate.largest > 1.0 && rate.largest < 4.0,
        "{rate:?}"
    );
    assert!(
        (1.0..=rate.largest).contains(&rate.mean) && (1.0..=rate.largest).contains(&rate.first),
        "{rate:?}"
    );
    let worst = numbers.iter().position(|n| *n == rate.at.element as f64).unwrap();
    assert!(factors[worst] > 0.0 && factors[worst] < (1.0 + 1e-6) * rate.largest);

    let sum: f64 = cells("d_tension").iter().sum();
    assert!(sum > 0.9 * beyond(lining, "0.9") && sum < lining.volume, "{sum}");
    let [now, most] = ["d_b", "d_b_max"].map(cells);
    assert!(now.iter().zip(&most).all(|(now, most)| now <= most));
    let size = grid.cell_array("crack_size").unwrap();
    assert_eq!(size.unit, "m");
    assert_eq!(grid.cell_data.iter().filter(|a| a.name == "d_tension").count(), 1);
}

#[test]
fn monitors_of_cracked_elements_show_no_more_than_their_points_carried() {
    let folder = tempfile::tempdir().unwrap();
    let (ready, outcome) = go(hall(), folder.path(), 2, false, f64::INFINITY);
    let table = tremolite_results::Table::read(&folder.path().join("monitors.csv")).unwrap();
    let locator = Locator::new(&ready.model.mesh, Some(&ready.model.mesh.groups["hall.lining"]));
    let mut judged = 0;
    for (name, point) in [("crown", [8.0, 1.5, 9.0]), ("foot", [6.0, 1.5, 5.0]), ("wall", [6.0, 1.5, 7.0])] {
        let element = locator.locate(point, 1e-6).unwrap().element as usize;
        let slot = ready.phase.element_slot[element].unwrap().element as usize;
        let cracked = outcome.state.observers["first cracked"][slot];
        let most = outcome.state.observers["s1_max"][slot];
        let rows = table.column("time").unwrap().iter().zip(table.column(&format!("{name}.s1")).unwrap());
        for (t, s1) in rows.filter(|(t, _)| **t >= cracked) {
            judged += 1;
            assert!(*s1 <= most + 1e-6 * most.abs(), "{name} at {t} s: {s1:e} of {most:e}");
        }
    }
    assert!(judged > 20, "monitors crack: {judged} rows");
}

#[test]
fn damage_has_the_same_bits_for_any_threads_and_instruction_set() {
    let shaken = |threads, isa| {
        let folder = tempfile::tempdir().unwrap();
        let mut problem = hall();
        problem.isa = isa;
        let (ready, outcome) = go(problem, folder.path(), threads, false, f64::INFINITY);
        let found = damaged(&ready, &outcome);
        let field = std::fs::read(folder.path().join("fields/000003.vtu")).unwrap();
        (outcome.state, found, field)
    };
    let reference = shaken(1, Isa::best());
    assert!(reference.1["hall.lining"].measures["d_tension"].largest > 0.9);
    assert!(reference == shaken(3, Isa::best()), "three threads");
    for isa in Isa::ALL.into_iter().filter(|isa| isa.available() && *isa != Isa::best()) {
        assert!(reference == shaken(2, isa), "{}", isa.name());
    }
}

#[test]
fn a_run_stopped_after_the_first_crack_resumes_to_the_same_damage() {
    let folder = tempfile::tempdir().unwrap();
    let (whole, parts) = (folder.path().join("whole"), folder.path().join("parts"));
    let problem = || {
        let mut problem = hall();
        problem.time_step.given = Some(1e-5);
        problem
    };
    let (ready, outcome) = go(problem(), &whole, 2, false, f64::INFINITY);
    let expected = damaged(&ready, &outcome);
    let first = expected["hall.lining"].measures["d_tension"].first.unwrap().time;
    let (.., stopped) = go(problem(), &parts, 1, false, first);
    assert_eq!(stopped.ending, Ending::Stopped);
    assert!(stopped.taken < stopped.steps.total);
    let (ready, resumed) = go(problem(), &parts, 3, true, f64::INFINITY);
    assert_eq!(resumed.ending, Ending::Done);
    assert!(resumed.state == outcome.state);
    assert_eq!(damaged(&ready, &resumed), expected);
    for file in ["energy.csv", "damage.csv", "fields.pvd", "fields/000003.vtu"] {
        let bytes = |folder: &Path| std::fs::read(folder.join(file)).unwrap();
        assert!(bytes(&whole) == bytes(&parts), "{file}");
    }
}

/// As a wave passes, the work done on the elements is what they hold and what cracks took, as the law books it; the same
/// lining without cracks takes nothing, and the compliance split gives nothing out.
#[test]
fn what_cracks_take_and_give_are_lines_of_the_balance_and_no_error() {
    let run = |strength: f64, split: &str, dt: f64| {
        let folder = tempfile::tempdir().unwrap();
        let mut problem = hall_of(strength, split);
        problem.time_step.given = Some(dt);
        let (.., outcome) = go(problem, folder.path(), 2, false, f64::INFINITY);
        let table = tremolite_results::Table::read(&folder.path().join("energy.csv")).unwrap();
        let supplied = outcome.state.ledger.supplied;
        ["dissipated", "created_by_law", "band_damping", "error"]
            .map(|name| table.column(name).unwrap().iter().map(|x| x / supplied).collect::<Vec<f64>>())
    };
    let largest = |x: &[f64]| x.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let [dissipated, created, ..] = run(1e9, "effective", 8e-5);
    assert_eq!([largest(&dissipated), largest(&created)], [0.0; 2]);
    for split in ["effective", "compliance"] {
        let errors = [8e-5, 4e-5, 2e-5].map(|dt| {
            let [dissipated, created, band, error] = run(0.6e6, split, dt);
            println!(
                "{split}, {dt:.0e} s: dissipated {:.3e}, created {:.3e}, error {:.3e} of what was supplied",
                largest(&dissipated),
                created[created.len() - 1],
                largest(&error)
            );
            assert!(dissipated.windows(2).all(|pair| pair[0] <= pair[1]), "{split}");
            assert_eq!(largest(&band), 0.0);
            assert_eq!(largest(&created) > 0.0, split == "effective");
            largest(&error) / largest(&dissipated)
        });
        // A jump of damage, and a crack that closes, fall into a step: the error is of its first order.
        assert!(errors[2] < 0.01, "{split}: {errors:?}");
        for pair in errors.windows(2) {
            assert!((pair[0] / pair[1]).log2() > 0.8, "{split}: {errors:?}");
        }
    }
}

/// C:ε says what a crack has taken: in a lining too strong to crack it is the stress, in a weak one the stress until the crack
/// comes, and then what the strain would ask for.
#[test]
fn elastic_stress_is_the_stress_until_a_crack_takes_it() {
    let histories = |strength: f64| {
        let folder = tempfile::tempdir().unwrap();
        go(hall_of(strength, "compliance"), folder.path(), 2, false, f64::INFINITY);
        Table::read(&folder.path().join("monitors.csv")).unwrap()
    };
    let (strong, weak) = (histories(60e6), histories(0.6e6));
    let column = |table: &Table, name: &str| table.column(name).unwrap().to_vec();
    let most = |values: &[f64]| values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    for monitor in ["crown", "foot", "wall"] {
        let [s1, elastic] = ["s1", "s1_elastic"].map(|q| column(&strong, &format!("{monitor}.{q}")));
        for (a, b) in s1.iter().zip(&elastic) {
            assert!((a - b).abs() < 1e-9 * most(&s1), "{monitor}: {a} and {b}");
        }
    }
    let [s1, elastic] = ["s1", "s1_elastic"].map(|q| column(&weak, &format!("foot.{q}")));
    let differ = |k: usize| (s1[k] - elastic[k]).abs() > 1e-6 * most(&s1);
    let cracked = (0..s1.len()).find(|k| differ(*k)).unwrap();
    assert!(s1[..cracked].iter().any(|s| *s > 0.4e6), "there is stress before the crack");
    let strain = most(&elastic[cracked..]);
    assert!(strain > 2.0 * 0.6e6 && most(&s1) < 1.2e6, "{strain} {}", most(&s1));
}
