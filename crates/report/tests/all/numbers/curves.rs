//! The numbers behind the figures' curves are those of the tables.

use std::collections::BTreeMap;
use std::fs;
use std::io::Read;
use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::read::ZlibDecoder;
use serde_json::Value;
use tremolite_report::write;
use tremolite_results::Table;

use super::super::{bolts, deconvolved, free_field, interface_results, report, stages};
use super::tokens::factor_of;

/// A line of a figure: `figure / panel / name`, its unit, and what it was drawn from.
struct Line {
    told: String,
    name: String,
    unit: String,
    values: Vec<f32>,
}

/// The lines in the page's data.
fn lines(page: &str) -> Vec<Line> {
    let Some((_, rest)) = page.split_once(r#"<script type="application/json" id="curves-data">"#) else {
        return Vec::new();
    };
    let manifest: Value = serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap();
    let mut blocks: BTreeMap<u64, Vec<f32>> = BTreeMap::new();
    for block in rest.split(r#"<script type="text/plain" id="block-"#).skip(1) {
        let (number, rest) = block.split_once("\">").unwrap();
        let packed = STANDARD.decode(rest.split_once("</script>").unwrap().0).unwrap();
        let mut bytes = Vec::new();
        ZlibDecoder::new(&packed[..]).read_to_end(&mut bytes).unwrap();
        let count = bytes.len() / 4;
        let number_at = |k: usize| f32::from_le_bytes([0, 1, 2, 3].map(|plane| bytes[plane * count + k]));
        blocks.insert(number.parse().unwrap(), (0..count).map(number_at).collect());
    }
    let mut all = Vec::new();
    for (figure, entry) in manifest.as_object().unwrap() {
        let text = |value: &Value| value.as_str().unwrap().to_owned();
        let rows = entry["rows"].as_u64().unwrap() as usize;
        let across = &blocks[&entry["across_block"].as_u64().unwrap()];
        assert_eq!(across.len(), rows);
        let mut values = blocks[&entry["block"].as_u64().unwrap()].chunks(rows);
        all.push(Line {
            told: format!("{figure} / across / "),
            name: text(&entry["across"]["name"]),
            unit: text(&entry["across"]["unit"]),
            values: across.clone(),
        });
        for panel in entry["panels"].as_array().unwrap() {
            for line in panel["lines"].as_array().unwrap() {
                let name = text(&line["name"]);
                all.push(Line {
                    told: format!("{figure} / {} / {name}", text(&panel["title"])),
                    name,
                    unit: text(&panel["unit"]),
                    values: values.next().expect("a line's numbers").to_vec(),
                });
            }
        }
        assert!(values.next().is_none(), "{figure}: numbers without a line");
    }
    all
}

/// All columns of the folder's tables of histories, as `file:column`.
fn columns(root: &Path) -> Vec<(String, Vec<f64>)> {
    let tables = [
        "monitors",
        "energy",
        "damage",
        "interfaces",
        "motion",
        "free_field",
        "spectra",
        "depth",
        "transfer",
    ];
    let paths = tables.map(|name| root.join(format!("{name}.csv")));
    let tables = paths.iter().filter(|path| path.exists()).map(|path| (path, Table::read(path).unwrap()));
    let own = |(path, table): (&std::path::PathBuf, Table)| {
        let file = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let named = table.columns.into_iter().zip(table.values);
        named.map(move |(column, values)| (format!("{file}:{}", column.name), values)).collect::<Vec<_>>()
    };
    tables.flat_map(own).collect()
}

/// Checks each line against the columns; `derived` are lines that stand in no table, by what they begin with.
fn check(root: &Path, derived: &[&str]) {
    let page = fs::read_to_string(write(root).unwrap()).unwrap();
    let (columns, lines) = (columns(root), lines(&page));
    assert!(lines.len() > 1);
    let mut met = vec![false; derived.len()];
    let mut wrong = Vec::new();
    for line in &lines {
        let factor = factor_of(&line.unit).unwrap_or(1.0);
        let equal = |values: &Vec<f64>| {
            // Five digits are kept, of what single precision can tell from nothing.
            let same = |(x, own): (&f64, &f32)| {
                (factor * x - f64::from(*own)).abs() <= 8e-6 * (factor * x).abs() + 1e-37
                    || (x.is_nan() && own.is_nan())
            };
            values.len() == line.values.len() && values.iter().zip(&line.values).all(same)
        };
        let found: Vec<&str> =
            columns.iter().filter(|(_, values)| equal(values)).map(|(name, _)| &**name).collect();
        // A line that is called as a monitor or a group is of its columns.
        let prefix = format!("{}.", line.name);
        let owned = |name: &str| name.split_once(':').is_some_and(|(_, column)| column.starts_with(&prefix));
        let named = columns.iter().any(|(name, _)| owned(name));
        let sound = found.iter().any(|name| !named || owned(name));
        match derived.iter().position(|start| line.told.starts_with(start)) {
            Some(entry) if !sound => met[entry] = true,
            _ if sound => {}
            _ => wrong.push(format!("{} ({}) is none of its columns, but {found:?}", line.told, line.unit)),
        }
    }
    wrong.extend(
        derived.iter().zip(met).filter(|(_, met)| !met).map(|(entry, _)| format!("no line needs {entry}")),
    );
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn curves_of_monitors_and_energy_are_columns() {
    let temp = tempfile::tempdir().unwrap();
    report::results(temp.path(), &["A", "B"]);
    // Of two monitors the pair, which this table does not hold, is drawn from their rows.
    check(temp.path(), &["relative.svg"]);
    report::results(&temp.path().join("three"), &["A", "B", "C"]);
    check(&temp.path().join("three"), &["displacement-less-mean.svg", "relative.svg"]);
}

#[test]
fn curves_of_the_ground_interfaces_and_stages_are_columns() {
    let temp = tempfile::tempdir().unwrap();
    interface_results::results(temp.path());
    check(temp.path(), &["interface-history-1.svg / area / "]);
    let temp = tempfile::tempdir().unwrap();
    stages::example(temp.path(), true);
    // Rows of one section of a lining, and of one stage: parts of columns, which are not followed here.
    check(temp.path(), &["lining-forces", "relaxation", "reaction"]);
    let temp = tempfile::tempdir().unwrap();
    bolts::results(temp.path());
    check(temp.path(), &[]);
    let temp = tempfile::tempdir().unwrap();
    let folder = free_field::results(temp.path());
    free_field::motion(&folder);
    free_field::free_field(
        &folder,
        &[
            ("reference.top.vx", &free_field::too_much),
            ("reference.top.vx_theory", &free_field::surface),
            ("model.xmin-ymin.surface.vx", &|t| 0.9 * free_field::surface(t)),
        ],
    );
    // The wave is in motion.csv, whose rows are at other times.
    check(
        temp.path(),
        &[
            "free_field.svg / surface, velocity along x / incident wave",
            "free_field.svg / surface, velocity along y / incident wave",
            "free_field.svg / base, velocity along x / incident wave",
            "free_field.svg / base, velocity along y / incident wave",
        ],
    );
}

#[test]
fn curves_of_a_record_and_of_its_transfer_are_columns() {
    let temp = tempfile::tempdir().unwrap();
    deconvolved::recorded(temp.path());
    // Numbers of motion.csv at the rows of free_field.csv; and a share of a number of the summary.
    let of_rows = [
        "free_field.svg / surface, velocity along x / incident wave",
        "free_field.svg / surface, velocity along y / incident wave",
        "free_field.svg / base, velocity along x / incident wave",
        "free_field.svg / base, velocity along y / incident wave",
        "record.svg / velocity along x / record",
        "record.svg / velocity along y / record",
        "transfer.svg / motion where the record was taken over incident wave, amplitude / 5 % of",
    ];
    check(temp.path(), &of_rows);
}
