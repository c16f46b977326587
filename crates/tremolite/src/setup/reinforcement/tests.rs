use super::*;
use std::f64::consts::TAU;
use std::path::Path;
use tremolite_laws::materials::MATERIALS;
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::cavern::{Cavern, CavernShape, CavernSpec, Lining};
use tremolite_mesh::{Element, Shape};

/// A case with reinforcement; what else it says does not matter here.
fn case(steel: &str) -> Case {
    let text = format!(
        r#"title = "bars"
[mesh.box]
x = {{ from = 0, to = "1 m", elements = 1 }}
y = {{ from = 0, to = "1 m", elements = 1 }}
z = {{ from = 0, to = "1 m", elements = 1 }}
group = "lining"
[material.concrete]
law = "elastic"
young = "30 GPa"
poisson = 0.2
density = "2500 kg/m3"
[[region]]
groups = ["*"]
material = "concrete"
element = "full-integration"
[initial]
lateral = 1
{steel}
"#
    );
    Case::parse(Path::new("case.toml"), &text, MATERIALS).unwrap_or_else(|e| panic!("{e}"))
}

fn steel(on: &str, cover: &str, direction: &str, more: &str) -> String {
    format!(
        "[[reinforcement]]\non = [\"{on}\"]\narea = \"1570 mm2/m\"\ncover = \"{cover}\"\ndirection = \"{direction}\"\n{more}\n"
    )
}

/// The bars in a mesh that stands from the start, its benches excavated.
fn built(
    steel: &str,
    mesh: &Mesh,
    lives: Option<Vec<Life>>,
) -> (Vec<Bolts>, Vec<Diagnostic>, Vec<Diagnostic>) {
    let lives = lives.unwrap_or_else(|| {
        let mut lives = vec![Life::ALWAYS; mesh.elements.len()];
        let open = mesh.groups.iter().filter(|(name, _)| name.ends_with(".excavation"));
        let gone = Life { born: Stage::Before(0), gone: Some(Stage::Before(1)) };
        open.flat_map(|(_, elements)| elements).for_each(|&e| lives[e as usize] = gone);
        lives
    });
    let mut problems = Vec::new();
    let (bolts, warnings) =
        build(&case(steel), mesh, &lives, &vec![true; mesh.elements.len()], &mut problems);
    (bolts, problems, warnings)
}

fn cavern(shape: CavernShape, near: f64) -> Mesh {
    let floor = if shape.is_closed() { 0.5 } else { 0.0 };
    let [height, arch_rise] = if shape.is_closed() { [9.0, 0.0] } else { [12.0, 3.0] };
    let lining = Lining { walls: 0.5, crown: 0.5, floor, layers: 2 };
    let cavern = Cavern {
        name: "hall".into(),
        shape,
        width: 9.0,
        height,
        arch_rise,
        benches: 2,
        lining,
        ..Cavern::default()
    };
    let spec = CavernSpec {
        overburden: 40.0,
        below: 30.0,
        sides: 30.0,
        length: 6.0,
        near,
        far: 7.0,
        along: Some(3.0),
        caverns: vec![cavern],
        ..CavernSpec::default()
    };
    spec.mesh().unwrap_or_else(|e| panic!("{e}"))
}

fn volume(bolts: &[Bolts]) -> f64 {
    let of_bar = |bar: &Bar| -> f64 {
        let legs = bar.points.windows(2).zip(&bar.areas);
        legs.map(|(ends, area)| norm(minus(ends[1], ends[0])) * area).sum()
    };
    bolts.iter().flat_map(|set| &set.bars).map(of_bar).sum()
}

#[test]
fn rings_are_closed_and_hold_the_steel_of_both_faces() {
    let mut deficits = Vec::new();
    for near in [1.6, 0.8] {
        let mesh = cavern(CavernShape::Circle, near);
        let (bolts, problems, warnings) = built(&steel("*.lining", "6 cm", "across", ""), &mesh, None);
        assert!(problems.is_empty() && warnings.is_empty(), "{problems:?} {warnings:?}");
        let [set] = &bolts[..] else { panic!("{} sets", bolts.len()) };
        assert_eq!((set.name.as_str(), set.born, set.bond), ("hall.lining", Stage::Before(0), None));
        // Two faces in each of two rows along y.
        assert_eq!(set.bars.len(), 4);
        let around = mesh.groups["hall.lining"].len() / (2 * 2);
        for bar in &set.bars {
            assert_eq!((bar.points.len(), bar.areas.len()), (around + 1, around));
            assert_eq!(bar.points[0], bar.points[around]);
            assert!(bar.points.iter().all(|x| x[1] == bar.points[0][1]), "in a plane across y");
        }
        // The mid-surface is a polygon of the bars' sectors, and what bars lie within it they lack without it.
        let angle = |x: Point| (x[2] + 40.0 + 4.5).atan2(x[0]);
        let chord = |ends: &[Point]| 2.0 * 4.75 * (0.5 * (angle(ends[1]) - angle(ends[0]))).sin().abs();
        let polygon: f64 = set.bars[0].points.windows(2).map(chord).sum();
        let steel = volume(&bolts) / (2.0 * 1.57e-3 * 6.0);
        assert!((steel / polygon - 1.0).abs() < 1e-4, "{steel} {polygon}");
        deficits.push(1.0 - steel / (TAU * 4.75));
    }
    // Of order 2 in the sectors' angles, and never too much steel.
    assert!(deficits[0] < 0.01 && deficits[1] > 0.0 && deficits[1] < 0.5 * deficits[0], "{deficits:?}");
}

#[test]
fn bars_lie_at_the_cover_s_depth_in_the_face_that_is_named() {
    for (shape, error) in
        [(CavernShape::Circle, 1e-3), (CavernShape::Arch, 2e-2), (CavernShape::Rectangle, 1e-9)]
    {
        let mesh = cavern(shape, 1.2);
        for (word, face) in [("intrados", 1), ("extrados", 0)] {
            for direction in ["across", "along"] {
                let text = steel("*.lining", "6 cm", direction, &format!("face = \"{word}\""));
                let case = case(&text);
                let stations = stations(&mesh, &mesh.groups["hall.lining"], &standing(&mesh));
                let legs = legs_of(&case.reinforcement[0], &stations);
                assert_eq!(legs.len(), stations.len());
                for (station, leg) in legs {
                    let middle = |places: &[Point]| {
                        [0, 1, 2].map(|i| places.iter().map(|x| x[i]).sum::<f64>() / places.len() as f64)
                    };
                    let depth = minus(middle(&leg.ends), middle(&station.faces[face]));
                    let depth = dot(depth, station.normal).abs();
                    assert!((depth / 0.06 - 1.0).abs() < error, "{shape:?} {word} {direction} {depth}");
                }
            }
        }
    }
}

fn standing(mesh: &Mesh) -> Vec<bool> {
    let mut standing = vec![true; mesh.elements.len()];
    mesh.groups["hall.excavation"].iter().for_each(|&e| standing[e as usize] = false);
    standing
}

#[test]
fn bars_along_run_from_side_to_side_and_those_of_a_vault_from_foot_to_foot() {
    let mesh = cavern(CavernShape::Arch, 1.2);
    let around = mesh.groups["hall.lining"].len() / (2 * 2);
    let (bolts, problems, _) = built(&steel("*.lining", "6 cm", "along", ""), &mesh, None);
    assert!(problems.is_empty());
    assert_eq!(bolts[0].bars.len(), 2 * around);
    for bar in &bolts[0].bars {
        let [from, to] = [bar.points[0], bar.points[2]];
        assert_eq!([from[1].abs(), to[1].abs(), bar.points[1][1]], [3.0, 3.0, 0.0]);
        assert!((from[0] - to[0]).abs() < 1e-12 && (from[2] - to[2]).abs() < 1e-12);
    }
    let (bolts, _, _) = built(&steel("*.lining", "6 cm", "across", ""), &mesh, None);
    assert_eq!(bolts[0].bars.len(), 4);
    let floor = mesh.points["hall.floor"][2];
    for bar in &bolts[0].bars {
        assert_eq!(bar.areas.len(), around);
        let [from, to] = [bar.points[0], bar.points[around]];
        assert!((from[2] - floor).abs() < 1e-9 && (to[2] - floor).abs() < 1e-9, "{from:?} {to:?}");
        assert!(from[0] * to[0] < 0.0);
    }
}

#[test]
fn a_mirrored_cavern_has_mirrored_bars() {
    let mesh = cavern(CavernShape::Arch, 1.2);
    for direction in ["across", "along"] {
        let (bolts, _, _) = built(&steel("*.lining", "6 cm", direction, ""), &mesh, None);
        let legs = || bolts[0].bars.iter().flat_map(|bar| bar.points.windows(2).zip(&bar.areas));
        let middle = |ends: &[Point]| [0, 1, 2].map(|i| 0.5 * (ends[0][i] + ends[1][i]));
        let all: Vec<(Point, f64)> = legs().map(|(ends, area)| (middle(ends), *area)).collect();
        for (x, area) in &all {
            let mirrored = [-x[0], x[1], x[2]];
            let found = all.iter().filter(|(other, _)| norm(minus(*other, mirrored)) < 1e-6);
            let areas: Vec<f64> = found.map(|(_, area)| *area).collect();
            assert!(areas.len() == 1 && (areas[0] / area - 1.0).abs() < 1e-6, "{direction} {x:?} {areas:?}");
        }
    }
}

#[test]
fn bars_begin_with_what_they_lie_in_and_end_where_that_begins_later() {
    let mesh = cavern(CavernShape::Arch, 1.2);
    let mut lives = vec![Life::ALWAYS; mesh.elements.len()];
    for (group, stage) in [("hall.lining1", 1), ("hall.lining2", 3)] {
        let life = Life { born: Stage::Before(stage), gone: None };
        mesh.groups[group].iter().for_each(|&e| lives[e as usize] = life);
    }
    let (bolts, problems, _) = built(&steel("*.lining*", "6 cm", "across", ""), &mesh, Some(lives));
    assert!(problems.is_empty(), "parts of a group that is named are no second helping: {problems:?}");
    let born: Vec<Stage> = bolts.iter().map(|set| set.born).collect();
    assert_eq!(born, [Stage::Before(1), Stage::Before(3)]);
    // The vault is one chain, the walls below it two, each in two faces and two rows.
    assert_eq!(bolts.iter().map(|set| set.bars.len()).collect::<Vec<_>>(), [4, 8]);
    let ends = |set: &Bolts| -> Vec<Point> {
        set.bars.iter().flat_map(|bar| [bar.points[0], bar.points[bar.points.len() - 1]]).collect()
    };
    let [upper, lower] = [ends(&bolts[0]), ends(&bolts[1])];
    assert!(upper.iter().all(|x| lower.contains(x)), "the later bars take up where the earlier ones end");
}

#[test]
fn what_cannot_be_reinforced_is_refused_with_what_to_do() {
    let cavern = cavern(CavernShape::Circle, 1.6);
    let mut block = BoxSpec::uniform([0.0; 3], [6.0; 3], [6, 6, 6]).mesh().unwrap();
    let cube = (0..216).filter(|&e| {
        let x = tremolite_engine::hexahedra::centroid(&block, e);
        x.iter().all(|x| (2.0..4.0).contains(x))
    });
    block.groups = [("cube".to_owned(), cube.collect())].into();
    let mut wedge = cavern.clone();
    let first = wedge.groups["hall.lining"][0] as usize;
    let n = wedge.elements[first].nodes;
    wedge.elements[first] = Element::new(Shape::Wedge6, &[n[0], n[1], n[2], n[4], n[5], n[6]]);
    let one = |more: &str| format!("face = \"{more}\"");
    for (mesh, text, what, remedy) in [
        (
            &cavern,
            steel("*.linning", "6 cm", "across", ""),
            "no group of the mesh fits",
            "the mesh has the groups",
        ),
        (&cavern, steel("*.lining", "25 cm", "across", ""), "half the thickness", "less than 2"),
        (
            &cavern,
            steel("*.lining", "0.5 m", "along", &one("extrados")),
            "would lie outside",
            "mm, from the concrete",
        ),
        (&block, steel("cube", "6 cm", "across", ""), "cube has no thickness", "thin one way"),
        (&wedge, steel("*.lining", "6 cm", "across", ""), "is no hexahedron", "with them"),
        (
            &cavern,
            steel("rock", "6 cm", "across", ""),
            "thick in places, so it is no lining",
            "of the lining",
        ),
    ] {
        let (bolts, problems, _) = built(&text, mesh, None);
        let [problem] = &problems[..] else { panic!("{what}: {problems:?}") };
        assert!(problem.message.contains(what) && problem.remedy.contains(remedy), "{problem:?}");
        assert!(bolts.is_empty() && !problem.span.is_empty());
    }
    let again =
        format!("{}{}", steel("*.lining", "6 cm", "across", ""), steel("*.lining", "6 cm", "across", ""));
    let (_, problems, _) = built(&again, &cavern, None);
    assert!(problems.len() == 1 && problems[0].message.contains("bars of another"), "{problems:?}");
    let meant =
        format!("{}{}", steel("*.lining", "6 cm", "across", ""), steel("*.lining", "12 cm", "across", ""));
    assert!(built(&meant, &cavern, None).1.is_empty());
    let (_, _, warnings) =
        built(&steel("*.lining", "6 cm", "across", "").replace("1570 mm2/m", "1570 m2/m"), &cavern, None);
    assert!(warnings.iter().any(|w| w.message.contains("% of steel")), "{warnings:?}");
    let mut overlapping = cavern;
    let crown = overlapping.groups["hall.lining.crown"].clone();
    let more = [crown, overlapping.groups["hall.bench1"].clone()].concat();
    overlapping.groups.insert("x.lining".into(), more);
    let (_, problems, _) = built(&steel("*.lining", "6 cm", "across", ""), &overlapping, None);
    assert!(problems[0].message.contains("reinforced twice"), "{problems:?}");
}

#[test]
fn corners_without_a_thickness_are_counted() {
    // A slab under walls: its ends have none.
    let lining = Lining { walls: 0.5, crown: 0.5, floor: 0.6, layers: 1 };
    let hall = Cavern {
        name: "hall".into(),
        width: 9.0,
        height: 12.0,
        arch_rise: 3.0,
        benches: 1,
        lining,
        ..Cavern::default()
    };
    let spec = CavernSpec {
        overburden: 40.0,
        below: 30.0,
        sides: 30.0,
        length: 6.0,
        near: 1.2,
        far: 7.0,
        along: Some(3.0),
        caverns: vec![hall],
        ..CavernSpec::default()
    };
    let mesh = spec.mesh().unwrap();
    let (bolts, problems, warnings) = built(&steel("*.lining", "6 cm", "across", ""), &mesh, None);
    assert!(problems.is_empty() && !bolts.is_empty(), "{problems:?}");
    let [warning] = &warnings[..] else { panic!("{warnings:?}") };
    assert!(warning.message.starts_with("4 of "), "{warning:?}");
}

/// The slab outside a free-field side stands for the section at it, and has no bars: told of bars that lie along the side, and of no others.
#[test]
fn bars_in_a_free_field_side_are_told() {
    let mesh = cavern(CavernShape::Arch, 1.2);
    let shaken = |sides: &str| {
        format!(
            "[motion]\nkind = \"incident\"\neast = {{ file = \"a.txt\" }}\n[dynamic]\nbase = \"viscous\"\nsides = {sides}\nduration = \"1 s\"\n"
        )
    };
    let said = |direction: &str, more: &str| {
        let (_, problems, warnings) = built(&steel("*.lining", "6 cm", direction, more), &mesh, None);
        assert!(problems.is_empty(), "{problems:?}");
        warnings.into_iter().map(|w| format!("{} ({})", w.message, w.remedy)).collect::<Vec<_>>()
    };
    for sides in ["\"free-field\"", "{ x = \"periodic\", y = \"free-field\" }"] {
        let told = said("across", &shaken(sides));
        assert_eq!(told.len(), 1, "{told:?}");
        assert!(
            told[0].contains("free-field side across y") && told[0].contains("y = \"periodic\""),
            "{told:?}"
        );
        assert!(said("along", &shaken(sides)).is_empty());
    }
    for sides in ["{ x = \"free-field\", y = \"periodic\" }", "{ x = \"free-field\", y = \"symmetry\" }"] {
        assert!(said("across", &shaken(sides)).is_empty(), "{sides}");
    }
    // Before an earthquake sides are rollers.
    assert!(said("across", "").is_empty());
}
