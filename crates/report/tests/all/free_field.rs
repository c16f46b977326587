//! Incident motion and free field, from hand-made files.

use std::fs;
use std::path::Path;

use tremolite_report::write;
use tremolite_results::{Column, ResultFolder, Soundness, Summary, TableWriter, TrustLine, said};

/// A folder of a run that shook, without anything of the free field.
pub fn results(root: &Path) -> ResultFolder {
    let folder = ResultFolder::create(Some(root), "case", false).unwrap();
    let columns = [Column::new("time", "s"), Column::new("A.ux", "m")];
    let mut table = TableWriter::create(&folder.monitors(), &columns).unwrap();
    (0..200).for_each(|k| table.write(&[0.01 * f64::from(k), 0.01 * (0.03 * f64::from(k)).sin()]).unwrap());
    let columns = ["kinetic", "rayleigh_damping", "input", "initial", "error"];
    energy(&folder, &columns, |t| vec![t, 0.3 * t, 1.3 * t, 0.0, 0.0]);
    let mut summary = Summary::default();
    (summary.computed.motion.kind, summary.computed.motion.factor) = ("outcrop".into(), 0.5);
    summary.write(&folder.summary()).unwrap();
    folder
}

fn energy(folder: &ResultFolder, lines: &[&str], of: impl Fn(f64) -> Vec<f64>) {
    let mut columns = vec![Column::new("time", "s")];
    columns.extend(lines.iter().map(|line| Column::new(*line, "J")));
    let mut table = TableWriter::create(&folder.energy(), &columns).unwrap();
    for k in 0..=100 {
        let t = 0.02 * f64::from(k);
        table.write(&[vec![t], of(1e4 * t)].concat()).unwrap();
    }
}

/// The wave: a pulse along x, half of it along y and nothing along z.
fn wave(t: f64) -> f64 {
    0.1 * (-((t - 0.6) / 0.1).powi(2)).exp()
}

pub fn motion(folder: &ResultFolder) {
    let mut columns = vec![Column::new("time", "s")];
    for of in ["given", "incident"] {
        columns.extend(["x", "y", "z"].map(|axis| Column::new(format!("{of}.v{axis}"), "m/s")));
    }
    let mut table = TableWriter::create(&folder.motion(), &columns).unwrap();
    for k in 0..400 {
        let t = 0.005 * f64::from(k);
        let v = wave(t);
        table.write(&[t, 2.0 * v, v, 0.0, v, 0.5 * v, 0.0]).unwrap();
    }
}

/// Columns of free_field.csv, and a row at a time.
pub type Columns<'a> = &'a [(&'a str, &'a dyn Fn(f64) -> f64)];

pub fn free_field(folder: &ResultFolder, columns: Columns) {
    let header = [("time", "s")].into_iter().chain(columns.iter().map(|(name, _)| (*name, "m/s")));
    let header: Vec<Column> = header.map(|(name, unit)| Column::new(name, unit)).collect();
    let mut table = TableWriter::create(&folder.free_field(), &header).unwrap();
    for k in 0..200 {
        let t = 0.01 * f64::from(k);
        table.write(&[vec![t], columns.iter().map(|(_, of)| of(t)).collect()].concat()).unwrap();
    }
}

/// The surface 0.2 s later and twice the wave; 2 % more than that.
pub fn surface(t: f64) -> f64 {
    2.0 * wave(t - 0.2)
}

pub fn too_much(t: f64) -> f64 {
    1.02 * surface(t)
}

/// The base: up and, 0.4 s later, down again.
pub fn base(t: f64) -> f64 {
    wave(t) + wave(t - 0.4)
}

/// The text of the section alone, with plain blanks.
fn told(folder: &ResultFolder) -> Option<String> {
    let page = fs::read_to_string(write(folder.root()).unwrap()).unwrap();
    let (_, from) = page.split_once("<h2>Incident motion and free field</h2>")?;
    let text = from.split_once("</section>").unwrap().0.replace(['\u{a0}', '\u{202f}'], " ");
    Some(text.replace("&#x2f;", "/").replace("&#x27;", "'"))
}

/// The figure, well-formed and of numbers.
fn drawing(folder: &ResultFolder) -> String {
    let text = fs::read_to_string(folder.figures().join("free_field.svg")).unwrap();
    roxmltree::Document::parse(&text).unwrap();
    assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
    text
}

#[test]
fn one_sentence_says_what_was_asked_for_and_what_came() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    motion(&folder);
    free_field(
        &folder,
        &[
            ("reference.top.vx", &too_much),
            ("reference.top.vx_theory", &surface),
            ("reference.top.vz", &|t| 1e-9 * wave(t)),
            ("reference.base.vx", &base),
            ("reference.base.vx_theory", &base),
            ("model.surface.vx", &|t| 0.95 * too_much(t)),
            ("model.base.vx", &base),
        ],
    );
    let told = told(&folder).unwrap();
    // The wave's peak is 100 mm/s, the outcrop's 200; 2 % of 204 is 1.96 %, 5 % of 204 is 5.0 %.
    for text in [
        "Along x the motion given (outcrop) peaks at 200 mm/s and the incident wave at 100 mm/s",
        "the surface of column reference at 204 mm/s, 2.04 times the incident wave (theory 200 mm/s; they differ by at \
         most 2.0 % of its peak)",
        "the base of column reference at 100 mm/s (theory 100 mm/s; they differ by at most 0 % of its peak)",
        // A file of an older version.
        "the model's own surface, mean of the four corners, at 194 mm/s (differing from the column's by at most 5.0 % of its \
         peak)",
        "the model's own base, mean of the four corners, at 100 mm/s (differing from the column's by at most 0 % of its peak).",
        "This file holds the mean of the model's four corners alone",
        "<td>mean of the four corners <span class=\"note\">beside reference</span></td><td>x</td><td class=\"n\">194</td>",
        "rows of free_field.csv, 10 ms apart",
        "Not drawn: z, nowhere more than",
    ] {
        assert!(told.contains(text), "{text}\n{told}");
    }
    let drawing = drawing(&folder);
    for name in
        ["reference, theory", "reference, as it moved", "model, mean of the four corners", "incident wave"]
    {
        assert_eq!(drawing.matches(&format!(">{name}</text>")).count(), 1, "{name}");
    }
    for panel in ["surface, velocity along x", "base, velocity along x"] {
        assert!(drawing.contains(panel), "{panel}");
    }
    // y is in the wave alone: half as much, and no line but the wave's in its panels.
    assert!(drawing.contains("base, velocity along y") && !drawing.contains("along z"));
}

#[test]
fn of_many_columns_the_one_farthest_from_theory_is_drawn_and_all_are_tabled() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    motion(&folder);
    free_field(
        &folder,
        &[
            ("xmin-ymin.top.vx", &surface),
            ("xmin-ymin.top.vx_theory", &surface),
            ("ymin-xmax.top.vx", &too_much),
            ("ymin-xmax.top.vx_theory", &surface),
            // Farther from the model than any, which does not count where there is theory.
            ("ymax-xmax.top.vx", &|t| 3.0 * surface(t)),
            ("model.surface.vx", &surface),
        ],
    );
    let text = told(&folder).unwrap();
    for name in ["xmin-ymin", "ymin-xmax", "ymax-xmax"] {
        assert!(text.contains(&format!("<td>{name}</td>")), "{name}");
    }
    assert!(text.contains("Of the 3 columns the one farthest from theory is drawn, ymin-xmax."), "{text}");
    assert!(
        text.contains("no theory for ymax-xmax.")
            && text
                .contains("<td>mean of the four corners <span class=\"note\">beside ymin-xmax</span></td>"),
        "{text}"
    );
    let drawing = drawing(&folder);
    assert!(drawing.contains(">ymin-xmax, theory<") && !drawing.contains("xmin-ymin"));
}

#[test]
fn without_theory_the_column_farthest_from_the_model_is_drawn() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    free_field(
        &folder,
        &[
            ("reference-xmin-ymin.top.vx", &surface),
            ("reference-xmax-ymin.top.vx", &too_much),
            // As a run writes it where ground yields.
            ("reference-xmax-ymin.top.vx_theory", &|_| f64::NAN),
            ("model.surface.vx", &surface),
        ],
    );
    let text = told(&folder).unwrap();
    assert!(text.contains("farthest from the model is drawn, reference-xmax-ymin."), "{text}");
    assert!(text.contains("the surface of column reference-xmax-ymin at 204 mm/s (no theory)"), "{text}");
    // Without motion.csv nothing is known of what was asked for.
    assert!(!text.contains("the motion given") && !drawing(&folder).contains("incident wave"));
}

#[test]
fn a_page_without_the_file_says_nothing_of_it() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    motion(&folder);
    assert_eq!(told(&folder), None);
    let page = fs::read_to_string(folder.report()).unwrap();
    assert!(!page.contains("free-field") && !page.contains("free_field"));
    assert!(!folder.figures().join("free_field.svg").exists());
}

#[test]
fn gaps_single_rows_and_other_columns_leave_a_page_that_reads() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    motion(&folder);
    for (content, wanted) in [
        ("time [s],reference.top.vx [m/s]\n0,0.1\n", "the surface of column reference at 100 mm/s"),
        ("time [s],reference.top.vx [m/s]\n0,NaN\n1,NaN\n2,inf\n", "the surface of column reference at –"),
        (
            "time [s],reference.top.vx [m/s],reference.top.vx_theory [m/s]\n0,0\n",
            "2 fields under 3 headers; the file is damaged",
        ),
        (
            "time [s],a.top.vx [m/s],a.top.vx_theory [m/s],a.odd.vx [m/s],b\n0,NaN,1,1,1\n1,0.5,NaN,1,1\n2,0.5,0.25,1,1\n",
            "at 0.500 m/s, 5.00 times the incident wave (theory 1.00 m/s; they differ by at most 25 % of its peak)",
        ),
        (
            "time [s],model.surface.vx [m/s]\n0,0.1\n1,0.2\n",
            "the model's own surface, mean of the four corners, at 200 mm/s.",
        ),
        (
            "time [s],model.surface.vx [m/s],model.xmin-ymin.surface.vx [m/s],model.xmax-ymin.surface.vx [m/s]\n0,0.1,0.1,0.1\n1,0.2,0.1,0.3\n",
            "the model's own surface, corner xmax-ymin, at 300 mm/s.",
        ),
        ("time [s],reference.top.vx [m/s]\n", "free_field.csv has no rows yet"),
        ("t [s],reference.top.vx [m/s]\n0,1\n", "free_field.csv has no column time"),
        ("time [s],reference.middle.vx [m/s]\n0,1\n", "free_field.csv has no columns of velocities."),
        ("time [s],a.top.vx [m/s],a.base.vx [m/s]\nNaN,1e308,5e-324\n3,-1e308,0\n2,1,1\n", "column a"),
    ] {
        fs::write(folder.free_field(), content).unwrap();
        let _ = fs::remove_file(folder.figures().join("free_field.svg"));
        let text = told(&folder).unwrap_or_else(|| panic!("{content}"));
        assert!(text.contains(wanted), "{content}\n{text}");
        if !text.contains("Left out.") {
            drawing(&folder);
        }
    }
    fs::remove_file(folder.motion()).unwrap();
    fs::write(folder.free_field(), "time [s],reference.top.vx [m/s]\n0,0\n1,0\n").unwrap();
    assert!(told(&folder).unwrap().contains("free_field.csv holds no motion."));
    fs::write(folder.free_field(), "time [s],a.top.vx [m/s]\n0,0\n1,0.2\n2,0.").unwrap();
    let _ = told(&folder);
    assert!(fs::read_to_string(folder.report()).unwrap().contains("ends in the middle of a line"));
}

#[test]
fn names_of_columns_cannot_become_markup() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    free_field(&folder, &[("<b>.top.vx", &surface), ("</text>.top.vx", &surface)]);
    let page = told(&folder).unwrap();
    assert!(!page.contains("<b>") && page.contains("&lt;b&gt;"));
    drawing(&folder);
}

#[test]
fn work_through_the_sides_stands_beside_the_input_and_is_told() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    write(folder.root()).unwrap();
    let before = fs::read_to_string(folder.report()).unwrap();
    assert!(!before.contains("through the sides"));
    energy(&folder, &["kinetic", "free_field", "input", "initial", "error"], |t| {
        vec![t, 0.25 * t, t, 0.0, 0.0]
    });
    write(folder.root()).unwrap();
    let page = fs::read_to_string(folder.report()).unwrap().replace('\u{a0}', " ");
    // Where the caption is split does not matter here.
    let page = page.replace("<details class=\"more\"><summary>How to read it</summary>", "");
    assert!(page.contains(
        "Work through the sides is that of the ground outside free-field sides on the model: of its forces, beyond those at the \
         start, and of the dashpots between. It counts into the model: 5.00 kJ at the end, between 0 kJ and 5.00 kJ over the run. \
         Level ground without caverns passes on next to nothing of the input; far below zero are scattered waves that leave."
    ));
    let drawing = fs::read_to_string(folder.figures().join("energy.svg")).unwrap();
    let at = |name: &str| drawing.find(&format!(">{name}</text>")).unwrap_or_else(|| panic!("{name}"));
    assert!(at("kinetic") < at("input") && at("input") < at("work through the sides"));
    assert!(!drawing.contains("free field"));
}

#[test]
fn dashpots_of_other_sides_are_not_taken_for_those_of_free_field_sides() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let idle = |lines: &[&str]| {
        energy(&folder, lines, |t| (0..lines.len()).map(|k| if k == 0 { t } else { 0.0 }).collect());
        write(folder.root()).unwrap();
        let page = fs::read_to_string(folder.report()).unwrap();
        page.split_once("Zero throughout: ").unwrap().1.split_once('.').unwrap().0.to_owned()
    };
    assert_eq!(idle(&["input", "side_dashpots", "error"]), "side dashpots");
    assert_eq!(
        idle(&["input", "side_dashpots", "free_field", "error"]),
        "work through the sides, dashpots of viscous sides and top"
    );
}

#[test]
fn the_error_that_is_drawn_and_that_of_the_check_are_told_apart() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let page = || {
        write(folder.root()).unwrap();
        fs::read_to_string(folder.report()).unwrap().replace("&#x27;", "'")
    };
    let told = "The error drawn includes ⅛Δt²aᵀMa, a part of the scheme that shrinks with the step.";
    assert!(!page().contains(told));
    let name = || said!("energy error over the largest energy in the model");
    for (line, wanted) in [
        (TrustLine::at_most("energy_error", name(), 1e-9, 5e-4, ""), true),
        (TrustLine::not_applicable("energy_error", name(), said!("nothing moves")), false),
    ] {
        Summary { soundness: Soundness { checks: vec![line], ..Soundness::default() }, ..Summary::default() }
            .write(&folder.summary())
            .unwrap();
        assert_eq!(page().contains(told), wanted);
    }
}

const CORNERS: [&str; 4] = ["xmin-ymin", "xmax-ymin", "xmin-ymax", "xmax-ymax"];

/// A column of free_field.csv and its history.
type Given = (String, Box<dyn Fn(f64) -> f64>);

/// The text of the section for such columns.
fn told_of(folder: &ResultFolder, columns: &[Given]) -> String {
    let columns: Vec<_> = columns.iter().map(|(name, of)| (name.as_str(), &**of)).collect();
    free_field(folder, &columns);
    told(folder).unwrap()
}

/// A history `factor` times that of the surface.
fn times(name: impl Into<String>, factor: f64) -> Given {
    (name.into(), Box::new(move |t| factor * surface(t)))
}

/// Soft ground on one side and hard on the other, where the mean over the corners is that of the columns.
#[test]
fn errors_of_corners_do_not_cancel_and_the_worst_is_named_and_drawn() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let mut columns = vec![
        times("reference-xmin-ymin+xmin-ymax.top.vx", 1.0),
        times("reference-xmax-ymin+xmax-ymax.top.vx", 2.0),
        times("model.surface.vx", 1.5),
    ];
    let model = |k: usize| format!("model.{}.surface.vx", CORNERS[k]);
    // 12 % too much, 8 % too little twice and 6 % too much of each corner's own column: the mean is right.
    for (k, factor) in [1.12, 1.84, 0.92, 2.12].into_iter().enumerate() {
        columns.push(times(model(k), factor));
    }
    let text = told_of(&folder, &columns);
    for wanted in [
        "the model's own surface, corner xmin-ymin, at 224 mm/s (differing from the column's by at most 12 % of its peak).",
        "The corner of the model farthest from its column is xmin-ymin: by 12 % of the peak of column \
         reference-xmin-ymin+xmin-ymax, along x at the surface.",
        "Drawn is the corner of the model that is farthest from its column, xmin-ymin, and that column",
        "<td>xmax-ymin <span class=\"note\">beside reference-xmax-ymin+xmax-ymax</span></td><td>x</td><td class=\"n\">368</td><td class=\"n\">400</td><td \
         class=\"n\">8.0</td>",
        "<td>xmin-ymax <span class=\"note\">beside reference-xmin-ymin+xmin-ymax</span></td><td>x</td><td class=\"n\">184</td><td class=\"n\">200</td><td \
         class=\"n\">8.0</td>",
        "<td>xmax-ymax <span class=\"note\">beside reference-xmax-ymin+xmax-ymax</span></td><td>x</td><td class=\"n\">424</td><td class=\"n\">400</td><td \
         class=\"n\">6.0</td>",
        "A reference column is named by the corners of the model that it stands for.",
    ] {
        assert!(text.contains(wanted), "{wanted}\n{text}");
    }
    assert!(!text.contains("mean of the"));
    assert!(drawing(&folder).contains(">model, corner xmin-ymin</text>"));
    // Ground that differs is no error.
    for (k, factor) in [1.0, 2.0, 1.0, 2.0].into_iter().enumerate() {
        columns[3 + k] = times(model(k), factor);
    }
    let text = told_of(&folder, &columns);
    assert!(text.contains("No corner of the model differs from its column."), "{text}");
}

#[test]
fn a_difference_is_over_the_largest_component_of_its_column() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    // z moves at the model alone, as caverns and layers that dip make it.
    let text = told_of(
        &folder,
        &[
            times("reference.top.vx", 0.5),
            times("reference.top.vz", 0.0),
            times("reference.base.vx", 1.0),
            times("reference.base.vx_theory", 1.0),
            times("model.xmax-ymin.surface.vx", 0.49),
            times("model.xmax-ymin.surface.vz", 0.04),
            times("model.xmax-ymin.base.vx", 1.0),
        ],
    );
    // 2 mm/s of 200, not of 100; 8 of 200, not of 8.
    for wanted in [
        "(differing from the column's by at most 1.0 % of its peak)",
        "farthest from its column is xmax-ymin: by 4.0 % of the peak of column reference, along z at the surface.",
    ] {
        assert!(text.contains(wanted), "{wanted}\n{text}");
    }
    assert!(drawing(&folder).contains("surface, velocity along z") && !text.contains("Not drawn: z"));
}

#[test]
fn columns_that_move_alike_are_one_row_and_those_that_do_not_are_named() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let ends = [
        "xmin-ymin",
        "xmin-ymax",
        "xmax-ymin",
        "xmax-ymax",
        "ymin-xmin",
        "ymin-xmax",
        "ymax-xmin",
        "ymax-xmax",
    ];
    let page = |apart: f64| {
        let mut columns: Vec<_> = ends.iter().map(|end| times(format!("{end}.top.vx"), 1.0)).collect();
        columns.push(times("ymax-xmax.top.vx_theory", 1.0));
        columns.extend(ends[..7].iter().map(|end| times(format!("{end}.top.vx_theory"), 1.0)));
        columns[7].1 = Box::new(move |t| (1.0 + apart) * surface(t));
        columns.extend(CORNERS.map(|corner| times(format!("model.{corner}.surface.vx"), 1.12)));
        told_of(&folder, &columns)
    };
    let rows = |page: &str| page.matches("<tr><td>").count();
    let alike = page(1e-12);
    assert!(
        alike.contains("8 columns of the same values") && alike.contains("is xmin-ymin: by 12 %"),
        "{alike}"
    );
    // One column, and the model at four corners.
    assert_eq!(rows(&alike), 1 + 4);
    let unlike = page(1.2e-4);
    assert!(
        unlike.contains("7 columns of the same values") && unlike.contains("<td>ymax-xmax</td>"),
        "{unlike}"
    );
    // Two columns stand for xmax-ymax.
    assert_eq!(rows(&unlike), 2 + 5);
    // The drawn one is the one that its corner is farthest from; what is farther from theory is told.
    assert!(
        unlike.contains("The column farthest from theory is ymax-xmax: by 0.012 % of its peak"),
        "{unlike}"
    );
}

#[test]
fn rows_too_few_to_show_the_wave_are_told() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    motion(&folder);
    let row = |t: f64| format!("{t},{}\n", surface(t));
    fs::write(folder.free_field(), format!("time [s],a.top.vx [m/s]\n{}{}{}", row(0.0), row(0.5), row(1.0)))
        .unwrap();
    let text = told(&folder).unwrap();
    // At 0.5 s the wave stands at 100/e mm/s.
    let told = "The rows are too few to show the wave: at their times the incident one peaks at 36.8 mm/s.";
    assert!(text.contains(told), "{text}");
}
