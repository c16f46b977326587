//! Maps of the section show what field files hold: one scale for two times, shapes as many times enlarged as is said, and a
//! sentence for what is missing.

use std::fs;
use std::path::Path;

use indexmap::IndexMap;
use tremolite_mesh::vtu::{Array, Grid, Values};
use tremolite_mesh::{Element, Mesh, Shape};
use tremolite_report::write;
use tremolite_results::{
    Column, Damaged, GroupDamage, Peaks, Pvd, ResultFolder, Status, Summary, TableWriter,
};

const LINES: [f64; 6] = [0.0, 10.0, 11.0, 19.0, 20.0, 30.0];
const GAMMA: f64 = 1e-3;

/// A hall of 8 m by 8 m with a lining of 1 m in a block of 30 m by 30 m, without any field but its bodies and groups.
fn hall(time: f64) -> (Grid, Vec<bool>) {
    let (grid, lining, _) = hall_of(&LINES, time);
    (grid, lining)
}

/// The same with elements between other lines, and how far each is from the hall's middle, the larger of x and z.
fn hall_of(lines: &[f64], time: f64) -> (Grid, Vec<bool>, Vec<f64>) {
    let mut mesh = Mesh::default();
    let n = lines.len();
    let id = |i: usize, j: usize, k: usize| (i + n * (j + 3 * k)) as u32;
    for z in lines {
        for y in [0.0, 5.0, 10.0] {
            mesh.nodes.extend(lines.iter().map(|x| [*x, y, *z]));
        }
    }
    let far = |i: usize| (0.5 * (lines[i] + lines[i + 1]) - 15.0).abs();
    let mut away = Vec::new();
    for k in 0..n - 1 {
        for (j, i) in (0..2).flat_map(|j| (0..n - 1).map(move |i| (j, i))) {
            if far(i).max(far(k)) > 4.0 {
                let face = |k| [id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k)];
                mesh.elements.push(Element::new(Shape::Hex8, &[face(k), face(k + 1)].concat()));
                away.push(far(i).max(far(k)));
            }
        }
    }
    let lining: Vec<bool> = away.iter().map(|far| *far < 5.0).collect();
    let (mut grid, _) = Grid::from_mesh(&mesh, None);
    grid.time = Some(time);
    let flags: Vec<u8> = lining.iter().map(|l| u8::from(*l)).collect();
    let bodies = flags.iter().map(|f| i32::from(*f)).collect();
    let numbers = (1..=lining.len() as i64).collect();
    grid.cell_data.push(Array::new("element", "", 1, Values::Int64(numbers)));
    grid.cell_data.push(Array::new("body", "", 1, Values::Int32(bodies)));
    grid.cell_data.push(Array::new("group:hall.lining", "", 1, Values::UInt8(flags)));
    (grid, lining, away)
}

/// Adds fields: damage of the lining, displacement that shears (γ = 10⁻³) on top of a common motion, the rest.
fn complete(time: f64, damage: f64, yielded: i32) -> Grid {
    let (mut grid, lining) = hall(time);
    let of_lining =
        |value: f64| Values::Float64(lining.iter().map(|l| if *l { value } else { 0.0 }).collect());
    for name in ["d_b_max", "d_tension"] {
        grid.cell_data.push(Array::new(name, "", 1, of_lining(damage)));
    }
    grid.cell_data.push(Array::new("d_shear", "", 1, of_lining(0.5 * damage)));
    grid.cell_data.push(Array::new(
        "s1_max",
        "Pa",
        1,
        Values::Float64(lining.iter().map(|l| if *l { 1.4e6 } else { -2e6 }).collect()),
    ));
    let state = lining.iter().map(|l| if *l { f64::NAN } else { f64::from(yielded) }).collect();
    grid.cell_data.push(Array::new("plastic_state", "", 1, Values::Float64(state)));
    let strain = lining.iter().map(|l| if *l { 0.0 } else { 1e-4 * f64::from(yielded) }).collect();
    grid.cell_data.push(Array::new("plastic_shear_strain", "", 1, Values::Float64(strain)));
    let moved = grid.points.iter().flat_map(|p| [0.5 + GAMMA * p[2], 0.3, -0.2]).collect();
    grid.point_data.push(Array::new("displacement", "m", 3, Values::Float64(moved)));
    grid
}

fn folder(root: &Path, grids: &[Grid]) -> ResultFolder {
    let folder = ResultFolder::create(Some(root), "case", false).unwrap();
    let mut summary = Summary::default();
    let measure = || Damaged { beyond: IndexMap::new(), largest: 1.0, ..Damaged::default() };
    let measures = [("d_tension".to_owned(), measure()), ("d_b_max".to_owned(), measure())].into();
    summary.parts.damage.insert("hall.lining".into(), GroupDamage { volume: 1.0, measures, cracks: None });
    let peaks = Peaks::of(&[0.0, 0.45, 1.0], &[0.0, 0.002, 0.001]);
    summary.monitors.relative.insert("A-B".into(), [("u".to_owned(), peaks)].into());
    summary.computed.model.duration = 1.0;
    summary.write(&folder.summary()).unwrap();
    let mut pvd = Pvd::create(&folder.pvd()).unwrap();
    for (k, grid) in grids.iter().enumerate() {
        grid.write(&folder.fields().join(format!("{k}.vtu"))).unwrap();
        pvd.add(grid.time.unwrap(), &format!("fields/{k}.vtu")).unwrap();
    }
    folder
}

fn page(folder: &ResultFolder) -> String {
    fs::read_to_string(write(folder.root()).unwrap()).unwrap()
}

fn figure(folder: &ResultFolder, name: &str) -> String {
    let text = fs::read_to_string(folder.figures().join(name)).unwrap();
    assert!(!text.contains("NaN") && !text.contains("inf"), "{name}");
    text
}

/// The colours of the areas in each map of a figure.
fn colours(figure: &str) -> Vec<Vec<String>> {
    let document = roxmltree::Document::parse(figure).unwrap();
    let maps = document.root_element().children().filter(|node| node.has_tag_name("svg"));
    let fills = |map: roxmltree::Node| {
        let paths = map.children().filter(|node| node.has_tag_name("path"));
        paths.filter_map(|path| path.attribute("fill")).filter(|f| *f != "none").map(str::to_owned).collect()
    };
    maps.map(fills).collect()
}

#[test]
fn only_of_a_run_that_is_done_the_last_file_is_after_the_earthquake() {
    let temp = tempfile::tempdir().unwrap();
    let folder = folder(temp.path(), &[complete(0.0, 0.2, 0), complete(1.0, 0.9, 0)]);
    for (status, is, other) in [
        (Status::Done, "After the earthquake", "So far"),
        (Status::Stopped, "So far", "After the earthquake"),
    ] {
        let mut summary = Summary::read(&folder.summary()).unwrap();
        summary.conclusion.status = status;
        summary.write(&folder.summary()).unwrap();
        page(&folder);
        let drawn = figure(&folder, "lining-damage.svg");
        assert!(drawn.contains(is) && !drawn.contains(other), "{status:?}");
    }
}

#[test]
fn before_and_after_have_one_scale_whatever_their_largest_values() {
    let drawn = |before: f64, after: f64| {
        let temp = tempfile::tempdir().unwrap();
        let folder = folder(temp.path(), &[complete(0.0, before, 0), complete(1.0, after, 0)]);
        let page = page(&folder);
        assert!(page.contains("Both maps have one scale."));
        figure(&folder, "lining-damage.svg")
    };
    let (rising, resting) = (drawn(0.2, 0.9), drawn(0.2, 0.2));
    let (rising_maps, resting_maps) = (colours(&rising), colours(&resting));
    assert_eq!(rising_maps.len(), 2);
    assert_eq!(rising_maps[0], resting_maps[0]);
    assert_eq!(resting_maps[0], resting_maps[1]);
    assert_ne!(rising_maps[0], rising_maps[1]);
    assert_eq!(rising.matches(">1.0<").count(), 1, "one bar");
    assert!(rising.contains("up to 0.20<") && rising.contains("up to 0.90<"));
}

#[test]
fn a_lining_is_unrolled_with_what_is_worst_through_its_thickness() {
    let temp = tempfile::tempdir().unwrap();
    let folder = folder(temp.path(), &[complete(0.0, 0.0, 0), complete(1.0, 0.7, 0)]);
    let page = page(&folder);
    for file in ["lining-damage-unrolled.svg", "lining-damage-kinds.svg", "lining-damage-kinds-unrolled.svg"]
    {
        assert!(figure(&folder, file).contains("hall.lining") || file == "lining-damage-kinds.svg", "{file}");
    }
    for text in [
        "linings drawn 3 times as thick",
        "before 0, after 0.70",
        "D⁺ 0.70, D⁻ 0.35",
        "Unrolled at true lengths",
    ] {
        assert!(page.contains(text), "{text}");
    }
}

#[test]
fn what_is_damaged_behind_the_outermost_elements_is_unrolled_too() {
    let temp = tempfile::tempdir().unwrap();
    // Two elements through the thickness, of which the inner ones are damaged.
    let (mut grid, lining, away) = hall_of(&[0.0, 10.0, 10.5, 11.0, 19.0, 19.5, 20.0, 30.0], 1.0);
    let damage =
        away.iter().zip(&lining).map(|(far, own)| if *own && *far < 4.5 { 0.9 } else { 0.0 }).collect();
    grid.cell_data.push(Array::new("d_tension", "", 1, Values::Float64(damage)));
    let folder = folder(temp.path(), &[grid]);
    assert!(page(&folder).contains("through the thickness the largest is shown"));
    let text = figure(&folder, "lining-damage-unrolled.svg");
    let document = roxmltree::Document::parse(&text).unwrap();
    let fills: Vec<&str> =
        document.root_element().children().filter_map(|node| node.attribute("fill")).collect();
    // The bar has each colour once; corners have no way into the open and show what they are themselves.
    let twice =
        fills.iter().filter(|fill| fill.len() == 7 && fills.iter().filter(|f| f == fill).count() == 2);
    assert_eq!(twice.count(), 2 * 2, "{fills:?}");
}

#[test]
fn stress_is_drawn_once_by_element_and_the_number_is_the_cells() {
    let temp = tempfile::tempdir().unwrap();
    let folder = folder(temp.path(), &[complete(1.0, 0.0, 0)]);
    let page = page(&folder);
    assert!(page.contains("Highest value shown: 1.40\u{a0}MPa"));
    let maps = colours(&figure(&folder, "section-s1.svg"));
    // The field jumps between two bodies and is even in each.
    assert_eq!((maps.len(), maps[0].len()), (1, 2));
}

#[test]
fn the_shape_is_drawn_as_many_times_enlarged_as_is_said() {
    let temp = tempfile::tempdir().unwrap();
    let grids = [0.0, 0.5, 1.0].map(|time| complete(time, 0.0, 0));
    let folder = folder(temp.path(), &grids);
    let page = page(&folder);
    assert!(page.contains("The file at 0.500\u{a0}s is the nearest to 0.450\u{a0}s"), "time");
    assert!(page.contains("A-B by 2.00\u{a0}mm"));
    let text = figure(&folder, "section-deformed.svg");
    let (_, rest) = text.split_once("shape of linings and openings × ").unwrap();
    let factor: f64 = rest.split_once('<').unwrap().0.parse().unwrap();
    assert!(page.contains(&format!("with that displacement {factor} times enlarged")));
    let document = roxmltree::Document::parse(&text).unwrap();
    let map = document.descendants().find(|n| n.has_tag_name("svg") && n.has_attribute("overflow")).unwrap();
    // The lining from 10 m to 20 m with 15 % around it.
    let zoom = map.attribute("width").unwrap().parse::<f64>().unwrap() / 13.0;
    let shape = map.children().find(|n| n.attribute("stroke-width") == Some("2")).unwrap();
    let starts: Vec<[f64; 2]> = shape
        .attribute("d")
        .unwrap()
        .split('M')
        .filter_map(|part| {
            let (x, y) = part.split_once('l')?.0.split_once(' ')?;
            Some([x.parse().ok()?, y.parse().ok()?])
        })
        .collect();
    // Half of γ on either axis about the middle of what is drawn, at (15, 15).
    let moved = 0.5 * GAMMA * -5.0 * factor;
    let [x, z] = [10.0 + moved, 10.0 + moved];
    let wanted = [(x - 8.5) * zoom, (21.5 - z) * zoom];
    let near = |p: &[f64; 2]| (p[0] - wanted[0]).abs() < 0.2 && (p[1] - wanted[1]).abs() < 0.2;
    assert!(starts.iter().any(near), "{wanted:?} {starts:?}");
    // What all has in common is not in the colours: half of γ over 5 m both ways is the most that is seen.
    assert!(
        page.contains("less the mean motion (552\u{a0}mm)") && page.contains("up to 3.54\u{a0}mm"),
        "common"
    );
}

#[test]
fn of_all_files_that_is_drawn_in_which_monitors_moved_most() {
    let temp = tempfile::tempdir().unwrap();
    let folder = folder(temp.path(), &[0.0, 0.5, 1.0].map(|time| complete(time, 0.0, 0)));
    // The peak at 0.45 s is over at 0.5 s.
    let columns = [Column::new("time", "s"), Column::new("A-B.ux", "m"), Column::new("A-B.uz", "m")];
    let mut table = TableWriter::create(&folder.monitors(), &columns).unwrap();
    for row in [[0.0, 0.0, 0.0], [0.45, 0.002, 0.0], [0.5, 0.0, 0.0], [1.0, -0.0008, 0.0006]] {
        table.write(&row).unwrap();
    }
    drop(table);
    let page = page(&folder);
    assert!(page.contains("Drawn is the field file at 1.000\u{a0}s, in which"), "which");
    assert!(
        page.contains("A-B by 1.00\u{a0}mm in the row of monitors.csv nearest to it.")
            && page.contains("The most over the run is 2.00\u{a0}mm of A-B at 0.450\u{a0}s.")
    );
}

#[test]
fn plastic_zones_stand_before_beside_after() {
    let temp = tempfile::tempdir().unwrap();
    let folder = folder(temp.path(), &[complete(0.0, 0.0, 0), complete(1.0, 0.0, 1)]);
    let page = page(&folder);
    assert!(page.contains("800\u{a0}m² of the section in shear, 0\u{a0}m² in tension"), "after");
    assert!(page.contains("before the earthquake, t = 0: 0\u{a0}m² in shear"), "before");
    let maps = colours(&figure(&folder, "section-plastic.svg"));
    assert_eq!(maps.len(), 2);
    assert_ne!(maps[0], maps[1]);
}

#[test]
fn what_files_lack_leaves_a_sentence() {
    let temp = tempfile::tempdir().unwrap();
    let folder = folder(temp.path(), &[hall(0.0).0, hall(1.0).0]);
    let bare = page(&folder);
    for text in [
        "The last field file has no field d_b_max",
        "The last field file has no field s1_max or s1.",
        "The field files have no displacement",
        "the file has neither plastic_state nor plastic_shear_strain",
    ] {
        assert!(bare.contains(text), "{text}");
    }
    complete(1.0, 0.5, 1).write(&folder.fields().join("1.vtu")).unwrap();
    let last_alone = page(&folder);
    assert!(last_alone.contains("Before the earthquake is not drawn"));
    assert_eq!(colours(&figure(&folder, "lining-damage.svg")).len(), 1);
    fs::remove_file(folder.fields().join("0.vtu")).unwrap();
    let lost = page(&folder);
    assert!(
        lost.contains("0.vtu") && lost.contains("section-s1.svg")
            || lost.contains("Highest value shown: 1.40")
    );
    fs::remove_file(folder.fields().join("1.vtu")).unwrap();
    let none = page(&folder);
    let (_, maps) = none.split_once("<section id=\"damage-map\"").unwrap();
    let (why, rest) = maps.split_once("</section>").unwrap();
    assert!(why.contains("1.vtu") && !rest.contains("<section id=\"section\""), "said once");
}
