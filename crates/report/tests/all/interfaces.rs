//! What interfaces did is on the page of a run that has some, and on no other.

use std::fs;

use tremolite_mesh::vtu::{Array, Grid, Values};
use tremolite_mesh::{Element, Mesh, Shape};
use tremolite_report::write;
use tremolite_results::{Column, Pvd, ResultFolder, TableWriter};

use super::interface_results::{Deed, fault, pairs, results, tunnel};

fn page(folder: &ResultFolder) -> String {
    fs::read_to_string(write(folder.root()).unwrap()).unwrap()
}

/// A figure, which is well-formed.
fn figure(folder: &ResultFolder, name: &str) -> String {
    let text = fs::read_to_string(folder.figures().join(name)).unwrap();
    roxmltree::Document::parse(&text).unwrap_or_else(|e| panic!("{name}: {e}"));
    assert!(!text.contains("NaN") && !text.contains("inf"), "{name}");
    text
}

/// The crown slides by up to 3 mm, more in its middle; some of it opens.
const CROWN: Deed = |[x, y, z]| match z {
    z if z < 8.0 => (0.0, 0.0, 0),
    _ if y < 3.0 => (3e-3, 0.0, 1),
    _ if x < 3.0 => (2e-3, 1e-3, 3),
    _ => (1e-3, 0.0, 2),
};

#[test]
fn the_table_has_every_interface_with_shares_and_places() {
    let temp = tempfile::tempdir().unwrap();
    let page = page(&results(temp.path()));
    for text in [
        "<h2>Interfaces</h2>",
        "456\u{a0}pairs; ends, closed, at 12 nodes",
        "4.50\u{a0}GPa",
        "chosen by the program",
        "0.201\u{a0}mm",
        "100\u{a0}m² <span class=\"note\">25\u{a0}%",
        "40\u{a0}m² <span class=\"note\">10\u{a0}%",
        "at\u{a0}(−1.25,\u{a0}4,\u{a0}8)",
        "above 4\u{a0}MPa, where the stiffness is constant",
        "−0.00200\u{a0}kJ",
        "lining: the interface slid over 25.0 % of its 400 m²",
        "Largest slip of an interface",
    ] {
        assert!(page.contains(text), "{text}");
    }
}

#[test]
fn areas_and_lengths_over_time_are_drawn_for_interfaces_that_moved() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let page = page(&folder);
    let svg = figure(&folder, "interface-history-1.svg");
    for text in ["area (% of its area)", "slid so far", "open now", "largest slip so far, 3.00\u{a0}mm"] {
        assert!(svg.contains(text), "{text}");
    }
    assert!(!folder.figures().join("interface-history-2.svg").exists());
    assert!(page.contains("Nothing slid or opened on fault."));
    // Without a summary the areas are not known as shares.
    fs::remove_file(folder.summary()).unwrap();
    self::page(&folder);
    assert!(figure(&folder, "interface-history-1.svg").contains("area (m²)"));
    fs::write(folder.interfaces(), "time [s]\n").unwrap();
    assert!(self::page(&folder).contains("interfaces.csv has no rows yet"));
}

#[test]
fn a_monitor_on_an_interface_has_its_own_figures_and_no_others() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let page = page(&folder);
    let (svg, path) = (figure(&folder, "interface-monitor-1.svg"), figure(&folder, "interface-path-1.svg"));
    for text in ["gap (", "along e2", "pressure, compression positive (", "sliding", "open"] {
        assert!(svg.contains(text), "{text}");
    }
    assert!(path.contains("|shear| (") && path.contains(">sliding<") && !path.contains(">bonded<"));
    assert!(page.contains("Monitors on interfaces"));
    assert!(!folder.figures().join("further-1.svg").exists(), "its columns are drawn once");
    assert!(!figure(&folder, "displacement.svg").contains(">J</text>"));
}

#[test]
fn lines_of_interfaces_in_the_energy_balance_have_words_and_axes_of_their_own_in_the_one_unit() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let page = page(&folder);
    let svg = figure(&folder, "energy.svg");
    for text in ["held by interfaces", "friction and broken bonds of interfaces", "created by interface laws"]
    {
        assert!(svg.contains(text), "{text}");
    }
    assert!(svg.contains("energy (kJ)") && svg.contains("energy of interfaces (kJ)"));
    assert!(page.contains(
        "At the end interfaces hold 3.00\u{a0}kJ; friction and broken bonds have taken 50.0\u{a0}kJ"
    ));
}

#[test]
fn the_map_unrolls_each_lining_and_says_what_is_where() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let both =
        tunnel(0, 0.0, 100).into_iter().chain(tunnel(0, 20.0, 500)).chain(fault(1, 60.0)).collect::<Vec<_>>();
    pairs(&folder, &both, CROWN);
    let page = page(&folder);
    let svg = figure(&folder, "interface-map-1.svg");
    for text in [
        "largest slip over the run (mm)",
        "up to 3.00\u{a0}mm",
        "largest gap over the run",
        "crown",
        "left wall",
    ] {
        assert!(svg.contains(text), "{text}");
    }
    assert!(
        svg.contains(">never slid<")
            && svg.contains(">sliding at the end<")
            && svg.contains(">open at the end<")
    );
    assert!(
        svg.contains(">part 1</text>")
            && svg.contains(">part 2</text>")
            && svg.contains(">end of the lining</text>"),
        "without fields sheets have numbers"
    );
    for text in ["Left and right are as seen along +y", "since nothing slid or opened: fault"] {
        assert!(page.contains(text), "{text}");
    }

    // A field file gives linings their names.
    let corner = |i: u32| [f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)];
    let all: Vec<i64> = both.iter().filter(|p| p.interface == 0).map(|p| p.element).collect();
    let mesh = Mesh {
        nodes: (0..8).map(corner).collect(),
        elements: vec![Element::new(Shape::Hex8, &[0, 1, 3, 2, 4, 5, 7, 6]); all.len()],
        ..Mesh::default()
    };
    let (mut grid, _) = Grid::from_mesh(&mesh, None);
    let group = |name: &str, inside: fn(i64) -> bool| {
        Array::new(name, "", 1, Values::UInt8(all.iter().map(|e| u8::from(inside(*e))).collect()))
    };
    grid.cell_data = vec![
        group("group:lining", |_| true),
        group("group:east.lining", |e| e >= 500),
        group("group:west.lining", |e| e < 500),
        Array::new("element", "", 1, Values::Int64(all.clone())),
    ];
    grid.write(&folder.fields().join("0.vtu")).unwrap();
    Pvd::create(&folder.pvd()).unwrap().add(1.0, "fields/0.vtu").unwrap();
    self::page(&folder);
    let svg = figure(&folder, "interface-map-1.svg");
    let (west, east) = (svg.find(">west.lining<").unwrap(), svg.find(">east.lining<").unwrap());
    assert!(west < east, "from left to right as they stand");
}

#[test]
fn a_fault_is_drawn_by_strike_and_dip_and_broken_files_give_a_reason() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    pairs(&folder, &fault(1, 0.0), |[x, ..]| (if x > 9.0 { 0.1 } else { 1e-3 * x }, 0.0, 2));
    let page = page(&folder);
    let svg = figure(&folder, "interface-map-2.svg");
    assert!(
        svg.contains("up to 100\u{a0}mm (median 5.00\u{a0}mm)"),
        "one stretch far beyond the others is told"
    );
    assert!(svg.contains("along the strike (m)") && svg.contains("up the dip (m)") && !svg.contains("crown"));
    assert!(page.contains("Interface fault: ") && page.contains("It opened nowhere."));

    pairs(&folder, &fault(1, 0.0), |_| (0.0, 0.0, 0));
    assert!(self::page(&folder).contains("No interface slid or opened."));
    fs::write(folder.interface_fields().join("000001.vtu"), "garbage").unwrap();
    assert!(self::page(&folder).contains("not a readable VTU file"));
    Pvd::create(&folder.interfaces_pvd()).unwrap();
    assert!(self::page(&folder).contains("interfaces.pvd lists no file yet"));
}

#[test]
fn a_run_without_interfaces_says_nothing_of_them() {
    let temp = tempfile::tempdir().unwrap();
    let folder = ResultFolder::create(Some(temp.path()), "case", false).unwrap();
    let columns = [Column::new("time", "s"), Column::new("A.ux", "m")];
    let mut table = TableWriter::create(&folder.monitors(), &columns).unwrap();
    (0..9).for_each(|step| table.write(&[f64::from(step), f64::from(step)]).unwrap());
    let page = page(&folder);
    let body = page.split_once("</style>").unwrap().1.split_once("</main>").unwrap().0;
    assert!(!body.to_lowercase().contains("interface"));
    assert!(
        fs::read_dir(folder.figures()).unwrap().all(|f| !f
            .unwrap()
            .file_name()
            .to_string_lossy()
            .contains("interface"))
    );
}
