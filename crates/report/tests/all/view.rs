//! The model in three dimensions: what the page's blocks hold is what the field files hold.

use std::fs;

use serde_json::Value;
use tremolite_mesh::vtu::Grid;
use tremolite_report::{Language, write_in};
use tremolite_results::{GroupDamage, SectionRow, Summary, write_sections};

use super::view_blocks::Page;
use super::view_files::{self, INTERFACE, TIMES, place};

fn field<'a>(part: &'a Value, name: &str) -> Option<&'a Value> {
    part["fields"].as_array().unwrap().iter().find(|field| field["name"] == name)
}

/// The corners of a cell without repetition, which is their order in the file.
fn once(corners: &[u32]) -> Vec<u32> {
    let mut own: Vec<u32> = Vec::new();
    corners.iter().for_each(|c| {
        if !own.contains(c) {
            own.push(*c);
        }
    });
    own
}

/// Compares a part with the file of a time: places, fields, displacement, and what does not stand. `per` file cell of the
/// part its index there.
fn compare(page: &Page, part: &Value, time: usize, grid: &Grid, own: &[usize]) {
    let (places, cells, elements) = (page.places(part), page.cells(part), page.elements(part));
    let number = |cell: usize| grid.cell_array("element").unwrap().values.get(cell) as u32;
    let mut pairs = Vec::new();
    let mut standing = vec![false; cells.len()];
    for &file_cell in own {
        let cell = elements.iter().position(|&e| e == number(file_cell)).unwrap();
        standing[cell] = true;
        let (ours, theirs) = (once(&cells[cell]), once(grid.cell(file_cell)));
        assert_eq!(ours.len(), theirs.len());
        pairs.extend(ours.into_iter().map(|c| c as usize).zip(theirs.into_iter().map(|c| c as usize)));
    }
    let step = page.three("step");
    for &(ours, theirs) in &pairs {
        for i in 0..3 {
            let off = (places[ours][i] - grid.points[theirs][i]).abs();
            // Half a step, and the round-off of the sum.
            assert!(off <= 0.5 * step[i] + 1e-12, "{off} of {}", step[i]);
        }
    }
    if let Some(displacement) = grid.point_array("displacement") {
        let unit = page.manifest["displacementStep"].as_f64().unwrap();
        let ours = page.displacement(part, time);
        for &(point, theirs) in &pairs {
            for i in 0..3 {
                let mean = page.manifest["mean"][time][i].as_f64().unwrap();
                let off = (mean + ours[point][i] - displacement.values.get(3 * theirs + i)).abs();
                // Half a unit, and the round-off of f32 among 2¹⁵ units: 2¹⁵/2²⁴.
                assert!(off <= 0.502 * unit, "{off} of {unit}");
            }
        }
    }
    for field in part["fields"].as_array().unwrap() {
        let name = field["name"].as_str().unwrap();
        let (low, high) = (field["low"].as_f64().unwrap(), field["high"].as_f64().unwrap());
        let levels = page.bytes(&field["blocks"][time]);
        let check = |ours: usize, value: f64| {
            if value.is_nan() {
                assert_eq!(levels[ours], 255, "{name}");
                return;
            }
            let off = (low + (high - low) * f64::from(levels[ours]) / 254.0 - value).abs();
            assert!(levels[ours] < 255 && off <= (0.5 + 1e-6) * (high - low) / 254.0, "{name}: {off}");
        };
        if field["at"] == "cells" {
            let array = grid.cell_array(name).unwrap();
            assert_eq!(field["unit"], array.unit);
            for &file_cell in own {
                check(
                    elements.iter().position(|&e| e == number(file_cell)).unwrap(),
                    array.values.get(file_cell),
                );
            }
            for (cell, _) in standing.iter().enumerate().filter(|(_, standing)| !**standing) {
                assert_eq!(levels[cell], 255, "{name} of an element that is not there");
            }
        } else {
            let array = grid.point_array(name).unwrap();
            pairs.iter().for_each(|&(ours, theirs)| check(ours, array.values.get(theirs)));
            let used = |point: usize| pairs.iter().any(|(ours, _)| *ours == point);
            (0..levels.len()).filter(|&p| !used(p)).for_each(|p| assert_eq!(levels[p], 255, "{name}"));
        }
    }
}

#[test]
fn blocks_hold_what_the_field_files_hold() {
    let temp = tempfile::tempdir().unwrap();
    let folder = view_files::results(temp.path());
    let page = Page::of(&folder).unwrap();
    assert_eq!((&page.manifest["version"], &page.manifest["clock"]), (&1.into(), &"earthquake".into()));
    assert_eq!(page.manifest["times"][1]["label"], "0.5 s");
    assert_eq!(page.parts().len(), 2);
    for (time, t) in TIMES.iter().enumerate() {
        assert_eq!(page.manifest["times"][time]["t"], *t);
        let grid = Grid::read(&folder.fields().join(format!("{time}.vtu"))).unwrap();
        let displacement = &grid.point_array("displacement").unwrap().values;
        for i in 0..3 {
            let sum: f64 = (0..grid.points.len()).map(|p| displacement.get(3 * p + i)).sum();
            let mean = page.manifest["mean"][time][i].as_f64().unwrap();
            assert!((mean - sum / grid.points.len() as f64).abs() < 1e-12);
        }
        let body = &grid.cell_array("body").unwrap().values;
        for (k, part) in page.parts().iter().enumerate() {
            let own: Vec<usize> =
                (0..grid.types.len()).filter(|&cell| body.get(cell) as usize == k).collect();
            assert_eq!(
                own.len() as u64 + u64::from(k == 0 && time == 1),
                part["cells"]["count"].as_u64().unwrap()
            );
            compare(&page, part, time, &grid, &own);
        }
    }
    let rock = &page.parts()[0];
    for name in ["s1", "displacement_max", "law's own"] {
        let field = field(rock, name).unwrap();
        let count =
            if name == "displacement_max" { &rock["points"]["count"] } else { &rock["cells"]["count"] };
        assert_eq!(page.bytes(&field["blocks"][0]).len() as u64, count.as_u64().unwrap());
    }
    assert_eq!(field(rock, "s1").unwrap()["label"], "largest principal stress s1");
    assert_eq!(field(rock, "law's own").unwrap()["label"], "law's own");
    // What does not change is there once; what has one value is not, and is named.
    let blocks = field(&page.parts()[1], "law's own").unwrap()["blocks"].as_array().unwrap();
    assert!(blocks.iter().all(|block| *block == blocks[0]));
    assert!(field(rock, "d_tension").is_none() && field(&page.parts()[1], "d_tension").is_some());
    assert!(page.notes().contains("d_tension = 0, even = 5.00"), "{}", page.notes());
    assert!(page.notes().contains("fields/*.vtu holds them: stress, velocity."), "{}", page.notes());
    assert!(field(rock, "body").is_none() && field(rock, "element").is_none());
}

#[test]
fn faces_enclose_the_parts_and_know_what_lies_behind() {
    let temp = tempfile::tempdir().unwrap();
    let page = Page::of(&view_files::results(temp.path())).unwrap();
    let sides = [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]];
    // Of 32 hexahedra 6 are missing and 2 are lining; on top stand a pyramid (1/3) and a tetrahedron (1/4).
    let unit = (0..3).map(|i| place([1.0; 3])[i] - place([0.0; 3])[i]).product::<f64>();
    for (part, volume, kinds) in
        [(0, 24.0 + 7.0 / 12.0, [None, Some(4), Some(12)]), (1, 2.0, [Some(2), Some(4), Some(4)])]
    {
        let part = &page.parts()[part];
        let (places, cells, faces) = (page.places(part), page.cells(part), page.faces(part));
        let enclosed: f64 = faces
            .iter()
            .map(|(face, _)| {
                let corner = |k: usize| {
                    let p = places[cells[*face as usize / 6][sides[*face as usize % 6][k]] as usize];
                    [0, 1, 2].map(|i| p[i] - places[0][i])
                };
                let triple = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
                    a[0] * (b[1] * c[2] - b[2] * c[1])
                        + a[1] * (b[2] * c[0] - b[0] * c[2])
                        + a[2] * (b[0] * c[1] - b[1] * c[0])
                };
                (triple(corner(0), corner(1), corner(2)) + triple(corner(0), corner(2), corner(3))) / 6.0
            })
            .sum();
        // Corners are off by half a step of 2⁻¹⁶ of the model's extent.
        assert!((enclosed / unit / volume - 1.0).abs() < 1e-4, "{enclosed}");
        for (kind, expected) in (0u8..).zip(kinds) {
            let found = faces.iter().filter(|(_, k)| *k == kind).count();
            assert!(expected.is_none_or(|expected| expected == found), "{kind}: {found}");
        }
    }
}

#[test]
fn parts_have_names_kinds_and_groups_whatever_these_are_called() {
    let temp = tempfile::tempdir().unwrap();
    let folder = view_files::results(temp.path());
    let page = Page::of(&folder).unwrap();
    let said = |page: &Page| -> Vec<(String, String)> {
        let text = |part: &Value, key: &str| part[key].as_str().unwrap().to_owned();
        page.parts().iter().map(|part| (text(part, "name"), text(part, "kind"))).collect()
    };
    let pairs = |list: [(&str, &str); 2]| list.map(|(a, b)| (a.to_owned(), b.to_owned())).to_vec();
    assert_eq!(said(&page), pairs([("rock", "rock"), ("hall.lining", "lining")]));
    let groups = page.parts()[0]["groups"].as_array().unwrap();
    let names: Vec<&str> = groups.iter().map(|group| group["name"].as_str().unwrap()).collect();
    // `rock` and `all` hold all of the part; `hall.lining` nothing.
    assert_eq!(names, ["<script>", "</script>"]);
    let grid = Grid::read(&folder.fields().join("0.vtu")).unwrap();
    for group in groups {
        let bits = page.bytes(&group["block"]);
        let array = grid.cell_array(&format!("group:{}", group["name"].as_str().unwrap())).unwrap();
        let numbers = &grid.cell_array("element").unwrap().values;
        for (cell, number) in page.elements(&page.parts()[0]).into_iter().enumerate() {
            let there = (0..grid.types.len()).find(|&c| numbers.get(c) as u32 == number).unwrap();
            assert_eq!(f64::from(bits[cell / 8] >> (cell % 8) & 1), array.values.get(there));
        }
    }

    // Without cracks the body is ground, unless section forces were taken of it.
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.parts.damage.insert("hall.lining".into(), GroupDamage::default());
    summary.write(&folder.summary()).unwrap();
    assert_eq!(said(&Page::of(&folder).unwrap()), pairs([("rock", "rock"), ("hall.lining", "rock")]));
    let row = SectionRow {
        lining: "hall.lining".into(),
        station: 1,
        place: [0.0; 3],
        when: "lining".into(),
        time: [0.0; 3],
        forces: [0.0; 3],
        thickness: 0.5,
        thrust_at_moment: 0.0,
        moment_at_thrust: 0.0,
    };
    write_sections(&folder.sections(), &[row]).unwrap();
    assert_eq!(said(&Page::of(&folder).unwrap()), pairs([("rock", "rock"), ("hall.lining", "lining")]));
}

#[test]
fn an_interface_is_a_part_that_moves_with_the_element_behind() {
    let temp = tempfile::tempdir().unwrap();
    let folder = view_files::results(temp.path());
    view_files::interface(&folder);
    let page = Page::of(&folder).unwrap();
    let part = &page.parts()[2];
    assert_eq!((&part["name"], &part["kind"]), (&INTERFACE.into(), &"interface".into()));
    let cells = page.cells(part);
    assert!(cells.iter().all(|cell| cell.len() == 4) && cells.iter().any(|cell| cell[2] == cell[3]));
    let expected: Vec<(u32, u8)> = (0..cells.len() as u32).map(|cell| (6 * cell, 1)).collect();
    assert_eq!(page.faces(part), expected);
    let grid = Grid::read(&folder.interface_fields().join("2.vtu")).unwrap();
    let all: Vec<usize> = (0..grid.types.len()).collect();
    let elements = page.elements(part);
    let numbers = &grid.cell_array("element").unwrap().values;
    assert_eq!(elements, all.iter().map(|&c| numbers.get(c) as u32).collect::<Vec<_>>());
    for name in ["slip_max", "state"] {
        let field = field(part, name).unwrap();
        let (low, high) = (field["low"].as_f64().unwrap(), field["high"].as_f64().unwrap());
        let (levels, array) = (page.bytes(&field["blocks"][2]), grid.point_array(name).unwrap());
        for &cell in &all {
            for (ours, theirs) in once(&cells[cell]).into_iter().zip(once(grid.cell(cell))) {
                let value = low + (high - low) * f64::from(levels[ours as usize]) / 254.0;
                let off = (value - array.values.get(theirs as usize)).abs();
                assert!(off <= (0.5 + 1e-6) * (high - low) / 254.0, "{name}: {off}");
            }
        }
        // No file of the interface at this time.
        assert!(page.bytes(&field["blocks"][0]).iter().all(|level| *level == 255));
    }
    assert!(
        page.notes().contains("interfaces/*.vtu hold them: stress, velocity, normal."),
        "{}",
        page.notes()
    );
    // The displacement is that of the lining's corner at the same place.
    let lining = &page.parts()[1];
    let (theirs, ours) = (page.places(lining), page.places(part));
    for time in 0..TIMES.len() {
        let (moved, behind) = (page.displacement(part, time), page.displacement(lining, time));
        for (point, place) in ours.iter().enumerate() {
            let at = theirs.iter().position(|other| other == place).unwrap();
            assert_eq!(moved[point], behind[at]);
        }
    }
    // A broken file costs the interface alone.
    fs::write(folder.interface_fields().join("2.vtu"), "garbage").unwrap();
    let page = Page::of(&folder).unwrap();
    assert!(page.parts().len() == 2 && page.notes().contains("Interfaces are left out. "));
    assert!(page.notes().contains("2.vtu: not a readable VTU file"), "{}", page.notes());
}

#[test]
fn the_view_is_left_out_where_it_is_not_wanted_or_a_file_is_broken() {
    let temp = tempfile::tempdir().unwrap();
    let folder = view_files::results(temp.path());
    fs::write(folder.fields().join("1.vtu"), "garbage").unwrap();
    let page = Page::of(&folder).unwrap();
    assert!(page.parts().is_empty() && page.blocks.is_empty());
    assert!(page.notes().starts_with("The view is left out. "), "{}", page.notes());
    assert!(page.notes().contains("1.vtu: not a readable VTU file"), "{}", page.notes());
    let chinese = fs::read_to_string(write_in(folder.root(), Language::Chinese).unwrap()).unwrap();
    assert!(Page::of_text(&chinese).unwrap().notes().starts_with("三维视图从略"));
    fs::remove_file(folder.fields().join("1.vtu")).unwrap();
    assert!(Page::of(&folder).unwrap().notes().contains("1.vtu"));

    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.case.report.view = false;
    summary.write(&folder.summary()).unwrap();
    assert!(Page::of(&folder).is_none());
    // Without a summary nobody said so; without files there is nothing.
    fs::remove_file(folder.summary()).unwrap();
    assert!(Page::of(&folder).is_some());
    fs::remove_file(folder.pvd()).unwrap();
    fs::write(folder.log(), "").unwrap();
    assert!(Page::of(&folder).is_none());
}

#[test]
fn a_study_without_shaking_goes_by_its_stages() {
    let temp = tempfile::tempdir().unwrap();
    let folder = view_files::results(temp.path());
    view_files::as_stages(&folder);
    let page = Page::of(&folder).unwrap();
    assert_eq!(page.manifest["clock"], "stages");
    let labels: Vec<&Value> = (0..3).map(|k| &page.manifest["times"][k]["label"]).collect();
    assert_eq!(labels, ["initial", "bench & <b>", "stage 2"]);
    assert!(page.notes().contains("stages/*.vtu"));
}
