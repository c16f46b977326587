//! Every number on the page stands in a file: with other numbers in the files, each by a factor of its own, each number of
//! the page is another, and still that of its file in the unit shown.

mod compared;
mod curves;
mod field_files;
mod known;
mod leaves;
mod scaled;
mod sources;
mod tables;
mod tokens;

use std::fs;
use std::path::Path;

use tremolite_report::Language;
use tremolite_results::Summary;

use self::sources::Pages;
use super::{bolts, cracks, deconvolved, free_field, interface_results, page, report, sheets, stages};

/// By how much numbers are scaled at most, up and down: enough to be seen in three figures, too little to make another
/// monitor the one that moves most wherever that can be helped.
const SPREAD: f64 = 0.05;

/// How many copies of a folder a number is followed through.
const COPIES: u64 = 5;

/// A number that stands in no file as it is: of what kind it is, and where on the page.
type Derived = (&'static str, &'static str);

/// A sentence on what is wrong for each number that comes from nowhere, and each entry of the list that nothing needs.
fn wrong(root: &Path, language: Language, derived: &[Derived]) -> Vec<String> {
    let pages = Pages::of(root, COPIES, language);
    assert!(pages.tokens.len() > 20);
    let mut met = vec![false; derived.len()];
    let mut wrong = Vec::new();
    for (k, token) in pages.tokens.iter().enumerate() {
        let source = pages.source(k);
        let (told, place) = (source.told(), format!("{} | {}", token.above, token.line));
        let listed = derived.iter().position(|(kind, at)| told.starts_with(kind) && place.contains(at));
        match listed {
            _ if source.stands() => {}
            Some(entry) => met[entry] = true,
            None => wrong.push(format!("{told} @ {}", token.told())),
        }
    }
    let idle = derived.iter().zip(met).filter(|(_, met)| !met);
    wrong.extend(idle.map(|((kind, at), _)| format!("no number needs the entry {kind}, {at}")));
    wrong
}

fn assert_sound(root: &Path, language: Language, derived: &[Derived]) {
    let wrong = wrong(root, language, derived);
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The balance's error is told as a share of what its rows hold together, and says so.
const BALANCE: [Derived; 1] = [("over: error over the largest energy held", "largest energy held")];

/// Cells of a cut through a field file, and of it in all, are counted.
const CUT: Derived = ("constant", "that the plane meets are shown");

/// No number of the run: what a release of everything is.
const RELEASE: Derived = ("constant", "a release below 100\u{a0}%");

/// What a crack is that lies parallel to a wall.
const PARALLEL: Derived = ("constant", "lies within 45° of the thickness");

#[test]
fn numbers_of_monitors_checks_and_damage_stand_in_the_files() {
    let temp = tempfile::tempdir().unwrap();
    let folder = report::results(temp.path(), &["A", "B"]);
    let mut summary = Summary::read(&folder.summary()).unwrap();
    let mut cracked = report::cracked();
    // Measures that are equal share a row, and in copies no longer are.
    cracked.measures["d_b_max"].largest = 0.93;
    cracked.measures["d_b_max"].beyond["0.9"] = 4.6;
    cracked.measures["plastic_shear_strain"].beyond["1e-6"] = 13.7;
    summary.parts.damage.insert("hall.lining".into(), cracked);
    summary.computed.model.duration = 20.0;
    summary.write(&folder.summary()).unwrap();
    let derived = [
        PARALLEL,
        // Cards hold the largest of all monitors.
        ("over: length of the displacement of B", " | Largest displacement of a monitor"),
        ("over: largest", " | Largest displacement of a monitor"),
        // Shares of the group's volume, as said above the table.
        (
            "ratio of damage.hall.lining.measures.d_tension.beyond.0.5 and damage.hall.lining.volume",
            "Cracked, D⁺",
        ),
        (
            "ratio of damage.hall.lining.measures.d_tension.beyond.0.9 and damage.hall.lining.volume",
            "Cracked, D⁺",
        ),
        (
            "ratio of damage.hall.lining.measures.d_b_max.beyond.0.5 and damage.hall.lining.volume",
            "hall.lining",
        ),
        (
            "ratio of damage.hall.lining.measures.d_b_max.beyond.0.9 and damage.hall.lining.volume",
            "hall.lining",
        ),
        (
            "ratio of damage.hall.lining.measures.plastic_shear_strain.beyond.1e-6 and damage.hall.lining.volume",
            "hall.lining",
        ),
    ];
    assert_sound(temp.path(), Language::English, &derived);
}

#[test]
fn numbers_of_the_two_sheets_stand_in_the_files() {
    let temp = tempfile::tempdir().unwrap();
    sheets::results(temp.path());
    for (language, clause) in [(Language::English, "(6.1)"), (Language::Chinese, "（6.1）")] {
        let derived = [
            // Of the code.
            ("constant", clause),
            // Of all monitors.
            ("over: length of the displacement of B", " | "),
            ("over: largest of monitors", " | "),
        ];
        assert_sound(temp.path(), language, &derived);
    }
}

#[test]
fn numbers_of_cracks_by_direction_and_of_rates_stand_in_the_files() {
    let temp = tempfile::tempdir().unwrap();
    cracks::results(temp.path(), [2.417e-3, 1.3e-4, 9.037e-3, 1.1e-5]);
    let ratio = "ratio of damage.hall.lining.measures.";
    let derived = [
        PARALLEL,
        ("over: length of the displacement of A", " | "),
        (ratio, "hall.lining"),
        (ratio, "Cracked, D⁺"),
    ];
    assert_sound(temp.path(), Language::English, &derived);
}

#[test]
fn numbers_of_stages_and_section_forces_stand_in_the_files() {
    let temp = tempfile::tempdir().unwrap();
    stages::example(temp.path(), true);
    let derived = [
        CUT,
        RELEASE,
        // Stations of sections.csv.
        ("constant", "tations going round"),
        ("constant", "stations of the lining, all sections"),
        // How far walls have come towards each other.
        ("sum of stages.", "Convergence | "),
        ("difference of stages.", "Convergence | "),
        ("area", "of the section in shear"),
        ("place", "in the element at x ="),
    ];
    assert_sound(temp.path(), Language::English, &derived);
}

#[test]
fn numbers_of_bolts_stand_in_the_files() {
    let temp = tempfile::tempdir().unwrap();
    let folder = bolts::results(temp.path());
    // Without the ground, whose cells would take most of the time.
    fs::remove_file(folder.pvd()).unwrap();
    fs::remove_dir_all(folder.fields()).unwrap();
    let derived = [
        RELEASE,
        ("over: sum of bolts.*.bolts", "bolts yielded"),
        ("place", "in walls, bolt 330, at ("),
        // By its number in the file of the bolts' forces.
        ("constant", "in walls, bolt 330, at ("),
    ];
    assert_sound(temp.path(), Language::English, &derived);
}

#[test]
fn numbers_of_interfaces_stand_in_the_files() {
    let temp = tempfile::tempdir().unwrap();
    interface_results::results(temp.path());
    for language in [Language::English, Language::Chinese] {
        // Shares of the interface's area, as said above the table.
        let derived = [
            ("ratio of interfaces.lining.ever_slid and interfaces.lining.area", " | "),
            ("ratio of interfaces.lining.ever_opened and interfaces.lining.area", " | "),
            ("ratio of interfaces.lining.sliding and interfaces.lining.area", " | "),
            ("ratio of interfaces.lining.open and interfaces.lining.area", " | "),
            ("over: error over the largest energy held", " | "),
        ];
        assert_sound(temp.path(), language, &derived);
    }
}

#[test]
fn numbers_of_the_verdict_stand_in_the_files() {
    let temp = tempfile::tempdir().unwrap();
    page::results(temp.path());
    // Monitors move alike, and in each copy another one is the farthest.
    let derived = [
        ("over: ", " | Largest displacement of a monitor"),
        ("unsettled", " | Largest displacement of a monitor"),
        ("over: monitors.csv: largest of all uz", "Not drawn: z, up, nowhere more than"),
        BALANCE[0],
    ];
    assert_sound(temp.path(), Language::English, &derived);
}

#[test]
fn numbers_of_the_free_field_stand_in_the_files_or_are_told_to_be_of_their_rows() {
    let temp = tempfile::tempdir().unwrap();
    let folder = free_field::results(temp.path());
    free_field::motion(&folder);
    // Of one shape, so that the largest difference is that of the peaks.
    free_field::free_field(
        &folder,
        &[
            ("reference.top.vx", &free_field::too_much),
            ("reference.top.vx_theory", &free_field::surface),
            ("reference.base.vx", &free_field::base),
            ("model.xmin-ymin.surface.vx", &|t| 0.9 * free_field::surface(t)),
        ],
    );
    let derived = [
        ("ratio of free_field.csv: ", "times the incident wave"),
        ("relative difference of free_field.csv: ", "they differ by at most"),
        ("relative difference of free_field.csv: ", "Peaks of velocity of the columns"),
        ("relative difference of free_field.csv: ", "Peaks of velocity of the model at its corners"),
    ];
    assert_sound(temp.path(), Language::English, &derived);
}

#[test]
fn numbers_of_a_record_that_was_deconvolved_stand_in_the_files() {
    let temp = tempfile::tempdir().unwrap();
    deconvolved::recorded(temp.path());
    let derived = [
        ("ratio of free_field.csv: ", "times the incident wave"),
        ("relative difference of free_field.csv: ", "they differ by at most"),
        ("relative difference of free_field.csv: ", "Peaks of velocity of the columns"),
        // Where the theory stands.
        ("constant", "Kramer"),
    ];
    assert_sound(temp.path(), Language::English, &derived);
}
