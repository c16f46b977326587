//! Response spectra and peaks along depth on the page: what is drawn is what the files hold.

use std::fs;
use std::path::Path;

use tremolite_report::{Language, write_in};
use tremolite_results::{Column, Peaks, ResultFolder, Summary, TableWriter};

/// A folder with the names and values of a table's columns in a file.
fn table(path: &Path, columns: &[(&str, &str, &[f64])]) {
    let header: Vec<Column> = columns.iter().map(|(name, unit, _)| Column::new(*name, *unit)).collect();
    let mut table = TableWriter::create(path, &header).unwrap();
    for row in 0..columns[0].2.len() {
        table.write(&columns.iter().map(|column| column.2[row]).collect::<Vec<_>>()).unwrap();
    }
}

pub fn shaken(root: &Path) -> ResultFolder {
    let folder = ResultFolder::create(Some(root), "case", true).unwrap();
    let (time, one) = ([0.0, 0.01, 0.02], [0.0, 1.0, 0.5]);
    table(&folder.monitors(), &[("time", "s", &time), ("A.ax", "m/s2", &one)]);
    table(&folder.energy(), &[("time", "s", &time), ("kinetic", "J", &one)]);
    table(&folder.motion(), &[("time", "s", &time), ("given.ax", "m/s2", &one)]);
    let mut summary = Summary::default();
    summary.monitors.monitor_positions.insert("A".into(), [0.0, 0.0, -30.0]);
    let of = |max: f64| Peaks::of(&[0.0, 1.0], &[-max, max]);
    summary.monitors.peaks.entry("A".into()).or_default().insert("ax".into(), of(2.5));
    summary.write(&folder.summary()).unwrap();
    folder
}

fn page(folder: &ResultFolder, language: &str) -> String {
    fs::read_to_string(write_in(folder.root(), language.parse::<Language>().unwrap()).unwrap()).unwrap()
}

fn drawing(folder: &ResultFolder, name: &str) -> String {
    fs::read_to_string(folder.figures().join(name)).unwrap()
}

#[test]
fn a_monitor_stands_beside_the_free_field_at_its_own_level() {
    let temp = tempfile::tempdir().unwrap();
    let folder = shaken(temp.path());
    assert!(page(&folder, "en").contains("The folder has no spectra.csv"));
    let own = [1.0, 9.37, 2.0];
    table(
        &folder.spectra(),
        &[
            ("period", "s", &[0.02, 0.35, 10.0]),
            ("given.ax", "m/s2", &[1.0, 2.0, 0.1]),
            ("free_field.surface.ax", "m/s2", &[1.0, 2.0, 0.1]),
            ("A.ax", "m/s2", &own),
            ("A.ay", "m/s2", &[0.0; 3]),
            ("A.free_field.ax", "m/s2", &[4.21, 3.0, 0.1]),
        ],
    );
    let text = page(&folder, "en");
    // The largest of each from ten rows a period on, and its period: those of the file.
    for told in [">9.37<", ">0.35<", ">3.00<"] {
        assert!(text.contains(told), "{told}");
    }
    assert!(!text.contains(">4.21<"));
    assert!(!text.contains("no free field to compare with"));
    // Ten rows, 0.01 s apart.
    assert!(text.contains("Where the monitor rises above it at periods from 0.1\u{a0}s on"));
    let svg = drawing(&folder, "spectra.svg");
    assert!(svg.contains("A, along x") && !svg.contains("A, along y") && svg.contains("free field at the"));
    assert!(drawing(&folder, "input-spectra.svg").contains("free field, surface"));
    // The first sheet has them across its width, and on a phone half as wide in its place, within the screen.
    let (_, shown) = text.split_once("<figure class=\"spectrum\">").unwrap();
    let (wide, slim) = shown.split_once("</figure>").unwrap().0.split_once("<div class=\"slim\">").unwrap();
    for (part, width) in [(wide, "viewBox=\"0 0 940 "), (slim, "viewBox=\"0 0 470 ")] {
        assert!(part.contains(width) && part.contains("free field, surface"), "{part}");
    }
    let text = page(&folder, "zh");
    assert!(text.contains("监测点的反应谱") && drawing(&folder, "spectra.svg").contains("周期 (s)"));
    // Without columns of ground there is nothing to compare with.
    table(&folder.spectra(), &[("period", "s", &[0.02, 0.35, 10.0]), ("A.ax", "m/s2", &own)]);
    assert!(page(&folder, "en").contains("no free field to compare with"));
}

#[test]
fn peaks_along_depth_point_down_and_monitors_stand_at_their_level() {
    let temp = tempfile::tempdir().unwrap();
    let folder = shaken(temp.path());
    assert!(page(&folder, "en").contains("The folder has no depth.csv"));
    let write = |theory: &str| {
        table(
            &folder.depth(),
            &[
                ("z", "m", &[0.0, -20.0, -40.0]),
                ("depth", "m", &[0.0, 20.0, 40.0]),
                ("free_field.vx", "m/s", &[0.2, 0.15, 0.1]),
                ("free_field.ax", "m/s2", &[2.0, 1.5, 1.0]),
                ("free_field.ux", "m", &[0.02, 0.01, 0.0]),
                (theory, "m/s2", &[2.0, 1.5, 1.0]),
                ("free_field.gxz", "1", &[1e-4, 2e-4, f64::NAN]),
                ("model.ax", "m/s2", &[1.9, 1.4, 0.9]),
            ],
        );
    };
    write("free_field.ax_theory");
    let text = page(&folder, "en");
    assert!(text.contains("Peaks along depth") && !text.contains("No theory stands beside it"));
    let svg = drawing(&folder, "depth.svg");
    assert!(
        ["free field, theory", "edge of the model", "monitors", "shear strain γxz", "from base, x (mm)"]
            .iter()
            .all(|x| svg.contains(x))
    );
    // One dot, of the acceleration 2.5 at 30 m: three quarters of the way from 0 to 40 m, below all of the column's middle.
    let height = |label: &str| -> f64 {
        let (before, _) = svg.split_once(&format!(">{label}</text>")).unwrap();
        before.rsplit_once(" y=\"").unwrap().1.split('"').next().unwrap().parse().unwrap()
    };
    let dots: Vec<&str> = svg.split("stroke-linecap=\"round\" d=\"M").skip(1).collect();
    let y: f64 = dots.last().unwrap().split([' ', 'h']).nth(1).unwrap().parse().unwrap();
    let (top, bottom) = (height("0") - 4.0, height("40") - 4.0);
    assert!(bottom > top && (y - (top + 0.75 * (bottom - top))).abs() < 0.2, "{top} {y} {bottom}");
    write("free_field.other");
    assert!(page(&folder, "en").contains("No theory stands beside it"));
}
