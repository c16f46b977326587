//! Of very many monitors the page draws and lists those that reach most, and says how many it leaves to the tables.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use tremolite_report::write;
use tremolite_results::{Column, ResultFolder, Subject, TableWriter};

const ALL: usize = 200;
/// As many as the page draws and lists.
const MOST: usize = 84;

/// How much a monitor moves beside the others: no two alike, and not in the order of their numbers.
fn size(k: usize) -> f64 {
    1.0 + (k * 73 % ALL) as f64
}

fn of_monitors(k: usize, quantities: &[(&str, &str)]) -> Vec<Column> {
    let monitor = Subject::Monitor(format!("m{k}"));
    quantities.iter().map(|(quantity, unit)| Column::of(monitor.clone(), *quantity, *unit)).collect()
}

/// Histories and spectra of all; rows go from nine tenths of the sizes to these.
fn results(folder: &ResultFolder) {
    let table = |path: &Path, first: Column, quantities: &[(&str, &str)]| {
        let columns: Vec<Column> =
            [first].into_iter().chain((0..ALL).flat_map(|k| of_monitors(k, quantities))).collect();
        let mut table = TableWriter::create(path, &columns).unwrap();
        for step in 1..=5 {
            let t = 0.9 + f64::from(step) / 50.0;
            let sizes = (0..ALL).flat_map(|k| vec![size(k) * t; quantities.len()]);
            table.write(&[t].into_iter().chain(sizes).collect::<Vec<f64>>()).unwrap();
        }
    };
    table(
        &folder.monitors(),
        Column::new("time", "s"),
        &[("ux", "m"), ("uy", "m"), ("uz", "m"), ("ax", "m/s2"), ("s2", "Pa")],
    );
    table(&folder.spectra(), Column::new("period", "s"), &[("ax", "m/s2")]);
}

#[test]
fn of_very_many_monitors_those_that_reach_most_are_drawn_and_listed() {
    let temp = tempfile::tempdir().unwrap();
    let folder = ResultFolder::create(Some(temp.path()), "case", false).unwrap();
    results(&folder);
    let page = fs::read_to_string(write(folder.root()).unwrap()).unwrap();
    let largest: BTreeSet<String> =
        (0..ALL).filter(|&k| size(k) > (ALL - MOST) as f64).map(|k| format!("m{k}")).collect();
    assert_eq!(largest.len(), MOST);

    for figure in ["displacement", "acceleration", "further-1", "spectra"] {
        let files = fs::read_dir(folder.figures()).unwrap().map(|entry| entry.unwrap().path());
        // Further sheets have a number behind the name.
        let is_own = |path: &PathBuf| {
            let name = path.file_stem().unwrap().to_str().unwrap();
            name.strip_prefix(figure)
                .is_some_and(|rest| rest.trim_matches(|c: char| c == '-' || c.is_ascii_digit()).is_empty())
        };
        let own = files.filter(is_own);
        let drawn = own.map(|path| fs::read_to_string(path).unwrap()).collect::<String>();
        let is_named = |name: &String| {
            // A spectrum has the component behind the name.
            drawn.contains(&format!(">{name}</text>")) || drawn.contains(&format!(">{name}, along "))
        };
        let named: BTreeSet<String> = (0..ALL).map(|k| format!("m{k}")).filter(is_named).collect();
        assert_eq!(named, largest, "{figure}");
    }
    assert!(page.contains("Drawn are the 84 of 200 that reach most; the other 116 are in the tables"));
    assert!(page.contains("Drawn and listed are the 84 of 200 monitors with the largest spectra"));

    let peaks = page.split("<section id=\"peaks\"").nth(1).unwrap().split("</section>").next().unwrap();
    assert!(peaks.contains("Displacement: the 84 of 200 that reach most"));
    let listed: BTreeSet<String> =
        (0..ALL).map(|k| format!("m{k}")).filter(|name| peaks.contains(&format!(">{name}<"))).collect();
    assert_eq!(listed, largest);
}

/// The grey behind each line is the range of all, also of those that are not drawn.
#[test]
fn the_grey_range_is_that_of_all_monitors() {
    let temp = tempfile::tempdir().unwrap();
    let folder = ResultFolder::create(Some(temp.path()), "case", false).unwrap();
    results(&folder);
    write(folder.root()).unwrap();
    let svg = fs::read_to_string(folder.figures().join("further-1.svg")).unwrap();
    let veil =
        svg.split("class=\"veil\"").nth(1).unwrap().split(" d=\"").nth(1).unwrap().split('"').next().unwrap();
    // A place, then steps from each point to the next.
    let steps = veil.replace(['M', 'l', 'z'], " ").replace('-', " -");
    let down = steps.split_whitespace().map(|x| x.parse::<f64>().unwrap()).skip(1).step_by(2);
    let heights = down.scan(0.0, |y, step| {
        *y += step;
        Some(*y)
    });
    let (low, high) = heights.fold((f64::MAX, f64::MIN), |(low, high), y| (low.min(y), high.max(y)));
    let height = high - low;
    // A cell is 57 high: all lines take some 200 of an axis to 220 at most, those that are drawn 94.
    assert!(height > 0.8 * 57.0, "{height}");
}
