//! What is left out to keep within a budget.

use std::path::Path;

use serde_json::Value;
use tremolite_mesh::vtu::{Array, Grid, Values};
use tremolite_mesh::{Element, Mesh, Shape};
use tremolite_results::{Cracks, GroupDamage, Pvd, ResultFolder, Summary, Wave};

use super::within;
use crate::script::blocks::Blocks;
use crate::source::Source;

const TIMES: usize = 9;

/// A row of 40 hexahedra of rock and two of lining, with numbers that do not pack well.
fn source(root: &Path) -> Source {
    let folder = ResultFolder::create(Some(root), "case", false).unwrap();
    let mut mesh = Mesh::default();
    for i in 0..=42 {
        let x = f64::from(i);
        mesh.nodes.extend([[x, 0.0, 0.0], [x, 1.0, 0.0], [x, 1.0, 1.0], [x, 0.0, 1.0]]);
    }
    for i in (0..42u32).map(|i| 4 * i) {
        let nodes = [i, i + 4, i + 5, i + 1, i + 3, i + 7, i + 6, i + 2];
        mesh.elements.push(Element::new(Shape::Hex8, &nodes));
    }
    let mut pvd = Pvd::create(&folder.pvd()).unwrap();
    for time in 0..TIMES {
        let (mut grid, _) = Grid::from_mesh(&mesh, None);
        let rough = |count: usize, seed: usize| {
            let number = |k: usize| ((k * 7919 + seed * 104_729 + time * 1_299_709) as f32).sin();
            Values::Float32((0..count).map(number).collect())
        };
        let lining = |k: i64| k >= 40;
        grid.cell_data = vec![
            Array::new("element", "", 1, Values::Int64((0..42).collect())),
            Array::new("body", "", 1, Values::Int32((0..42).map(|k| lining(k).into()).collect())),
            Array::new("group:lining", "", 1, Values::UInt8((0..42).map(|k| lining(k).into()).collect())),
            Array::new("s3", "Pa", 1, rough(42, 1)),
            Array::new("s1", "Pa", 1, rough(42, 2)),
            Array::new("own", "", 1, rough(42, 3)),
        ];
        grid.point_data = vec![Array::new("displacement", "m", 3, rough(3 * 43 * 4, 4))];
        grid.write(&folder.fields().join(format!("{time}.vtu"))).unwrap();
        pvd.add(time as f64, &format!("fields/{time}.vtu")).unwrap();
    }
    let mut summary = Summary::default();
    let cracks = GroupDamage { cracks: Some(Cracks::default()), ..GroupDamage::default() };
    summary.parts.damage.insert("lining".into(), cracks);
    summary.write(&folder.summary()).unwrap();
    Source::read(root, None).unwrap()
}

/// The manifest, and how much its blocks take.
fn view(source: &Source, budget: usize) -> (Value, usize) {
    let mut blocks = Blocks::default();
    let text = within(source, &mut blocks, &|_| budget);
    let json = text.split_once('>').unwrap().1.rsplit_once("</script>").unwrap().0;
    let elements = blocks.elements();
    let size = elements.lines().map(|line| line.split(['>', '<']).nth(2).unwrap().len()).sum();
    (serde_json::from_str(json).unwrap(), size)
}

/// At which times a series is there.
fn there(series: &Value) -> Vec<usize> {
    (0..TIMES).filter(|&time| !series[time].is_null()).collect()
}

#[test]
fn over_the_budget_times_of_the_ground_go_then_fields_then_displacement() {
    let temp = tempfile::tempdir().unwrap();
    let source = source(temp.path());
    let (full, fine) = view(&source, usize::MAX);
    let every: Vec<usize> = (0..TIMES).collect();
    assert_eq!(there(&full["parts"][0]["displacement"]), every);
    assert!(!full["notes"].to_string().contains("To keep"));
    let names = |part: &Value| -> Vec<String> {
        part["fields"].as_array().unwrap().iter().map(|f| f["name"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(view(&source, fine), (full.clone(), fine), "just enough");
    // A byte too little, and displacement is held in coarser steps before any time goes.
    let (coarse, all) = view(&source, fine - 1);
    assert!(all < fine && there(&coarse["parts"][0]["displacement"]) == every, "{all} of {fine}");
    let steps = |manifest: &Value| manifest["displacementStep"].as_f64().unwrap();
    assert!((steps(&coarse) / steps(&full) - 32767.0 / 2047.0).abs() < 1e-9);

    // Each time a byte too little for what there was: one step after the other.
    let mut seen: Vec<(Vec<usize>, Vec<String>)> = Vec::new();
    let mut budget = all - 1;
    loop {
        let (less, size) = view(&source, budget);
        let (rock, lining, notes) = (&less["parts"][0], &less["parts"][1], less["notes"].to_string());
        assert_eq!(there(&lining["displacement"]), every);
        assert!(lining["fields"].as_array().unwrap().iter().all(|field| there(&field["blocks"]) == every));
        let (fields, times) = (names(rock), there(&rock["displacement"]));
        assert!((0..fields.len()).all(|k| there(&rock["fields"][k]["blocks"]) == times));
        assert_eq!(size <= budget, !notes.contains("more than the"), "{size} of {budget}: {notes}");
        assert!(notes.contains("one time in"), "{notes}");
        assert_eq!(notes.contains("fields of the ground"), fields.len() < 3);
        assert_eq!(notes.contains("displacement of the ground"), times.is_empty());
        if size > budget {
            assert_eq!(seen.pop(), Some((times, fields)), "nothing more can go");
            seen.push((Vec::new(), Vec::new()));
            break;
        }
        seen.push((times, fields));
        budget = size - 1;
    }
    let steps: Vec<(Vec<usize>, &[&str])> = vec![
        (vec![0, 2, 4, 6, 8], &["s3", "s1", "own"]),
        (vec![0, 4, 8], &["s3", "s1", "own"]),
        (vec![0, 8], &["s3", "s1", "own"]),
        (vec![0, 8], &["s3", "s1"]),
        (vec![0, 8], &["s1"]),
        (vec![0, 8], &[]),
        (vec![], &[]),
    ];
    let steps: Vec<(Vec<usize>, Vec<String>)> =
        steps.into_iter().map(|(t, f)| (t, f.iter().map(|&f| f.to_owned()).collect())).collect();
    assert_eq!(seen, steps);
}

#[test]
fn times_are_told_without_the_round_off_of_their_steps() {
    let temp = tempfile::tempdir().unwrap();
    let source = source(temp.path());
    let mut pvd = Pvd::create(&source.folder.pvd()).unwrap();
    for time in [0.0, 1.5000000000000002, 0.1 + 0.2, 12.345678] {
        pvd.add(time, "fields/0.vtu").unwrap();
    }
    let (manifest, _) = view(&source, usize::MAX);
    let labels: Vec<&str> =
        manifest["times"].as_array().unwrap().iter().map(|time| time["label"].as_str().unwrap()).collect();
    assert_eq!(labels, ["0 s", "1.5 s", "0.3 s", "12.345678 s"]);
}

#[test]
fn waves_at_angles_are_arrows_during_the_earthquake_alone() {
    let temp = tempfile::tempdir().unwrap();
    let mut source = source(temp.path());
    assert_eq!(view(&source, usize::MAX).0["waves"], Value::Array(Vec::new()));
    let (sin, cos) = 0.45f64.sin_cos();
    let wave = Wave {
        kind: "SV".into(),
        angle: 0.45,
        way: [sin, 0.0, cos],
        polarisation: [cos, 0.0, -sin],
        ..Wave::default()
    };
    source.summary.as_mut().unwrap().computed.motion.waves = vec![wave];
    let (manifest, _) = view(&source, usize::MAX);
    let arrow = &manifest["waves"][0];
    assert_eq!(arrow["label"], "SV 25.78°");
    assert_eq!(arrow["way"], serde_json::json!([sin, 0.0, cos]));
    assert_eq!(arrow["polarisation"], serde_json::json!([cos, 0.0, -sin]));
    assert!(manifest["notes"].to_string().contains("Arrows beside the axes"));
}

/// Elements of a row along x, water to +x in the first of them; at the last times alone, and the same at both.
#[test]
fn the_flow_of_water_is_lines_at_the_times_that_have_it() {
    let temp = tempfile::tempdir().unwrap();
    let source = source(temp.path());
    let (still, _) = view(&source, usize::MAX);
    assert_eq!(still["flows"], Value::Array(Vec::new()));
    assert!(still["flowAt"].as_array().unwrap().iter().all(Value::is_null));
    for time in TIMES - 2..TIMES {
        let path = source.folder.fields().join(format!("{time}.vtu"));
        let mut grid = Grid::read(&path).unwrap();
        let values = (0..42).flat_map(|k| [if k < 30 { 1e-8 } else { 0.0 }, 0.0, 0.0]).collect();
        grid.cell_data.push(Array::new("seepage", "m/s", 3, Values::Float32(values)));
        // Water under pressure from the tenth element on; in the earthquake this changes, and the lines stay.
        let pressed = if time == TIMES - 2 { 10 } else { 20 };
        let values = (0..42).map(|k| if k < pressed { 0.0 } else { 1e5 }).collect();
        grid.cell_data.push(Array::new("p", "Pa", 1, Values::Float32(values)));
        grid.write(&path).unwrap();
    }
    let (manifest, _) = view(&source, usize::MAX);
    let at: Vec<Option<u64>> = manifest["flowAt"].as_array().unwrap().iter().map(Value::as_u64).collect();
    assert_eq!(at, [vec![None; TIMES - 2], vec![Some(0); 2]].concat());
    let [flow] = &manifest["flows"].as_array().unwrap()[..] else { panic!("one flow") };
    let lines = flow["lines"].as_array().unwrap();
    assert!(!lines.is_empty() && flow["beside"].as_f64().unwrap() > 0.0);
    for line in lines {
        let line: Vec<f64> = line.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
        assert_eq!(line, [10.0, 0.5, 0.5, 30.0, 0.5, 0.5]);
    }
    let notes = manifest["notes"].to_string();
    assert!(notes.contains("flow lines of the water") && !notes.contains("holds them: seepage"), "{notes}");
}
