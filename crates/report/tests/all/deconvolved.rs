//! A record on or within layered ground on the page: what was done with it, the transfer, and what came out at its place.

use std::fs;
use std::path::Path;

use tremolite_report::{Language, write_in};
use tremolite_results::{Column, Deconvolved, ResultFolder, Summary, TableWriter, TrustLine, said};

use super::free_field::{self, surface, too_much};

/// What was done with a record of the surface of the model's own ground.
fn site() -> Deconvolved {
    Deconvolved {
        depth: 0.0,
        corner: "xmin-ymin".into(),
        lead: 0.215,
        band: 9.0,
        reach: 11.3,
        left_out: 0.0042,
        at_rest: 1.94,
        least: 0.731,
        least_at: 6.35,
        soil: Vec::new(),
    }
}

/// A row each step of what `of` gives, behind the time or frequency.
fn table(
    path: &Path,
    first: (&str, &str),
    columns: &[(&str, &str)],
    rows: u32,
    step: f64,
    of: &dyn Fn(f64) -> Vec<f64>,
) {
    let header = std::iter::once(&first).chain(columns).map(|(name, unit)| Column::new(*name, *unit));
    let mut table = TableWriter::create(path, &header.collect::<Vec<_>>()).unwrap();
    for row in 0..rows {
        let at = f64::from(row) * step;
        table.write(&[vec![at], of(at)].concat()).unwrap();
    }
}

/// The record along x, and so many times as much along y.
fn given(folder: &ResultFolder, y: f64) {
    let slope = |t: f64| (surface(t + 1e-4) - surface(t - 1e-4)) / 2e-4;
    let columns = [
        ("given.ax", "m/s2"),
        ("given.ay", "m/s2"),
        ("given.az", "m/s2"),
        ("given.vx", "m/s"),
        ("given.vy", "m/s"),
        ("given.vz", "m/s"),
        ("incident.vx", "m/s"),
        ("incident.vy", "m/s"),
        ("incident.vz", "m/s"),
    ];
    table(&folder.motion(), ("time", "s"), &columns, 400, 0.005, &|t| {
        let (a, v, wave) = (slope(t), surface(t), 0.5 * surface(t + 0.2));
        vec![a, y * a, 0.0, v, y * v, 0.0, wave, y * wave, 0.0]
    });
}

/// A folder of a run whose motion is a record of the surface, along x and half of it along y.
pub fn recorded(root: &Path) -> ResultFolder {
    let folder = free_field::results(root);
    given(&folder, 0.5);
    let both = |t| 0.5 * too_much(t);
    free_field::free_field(
        &folder,
        &[
            ("reference.top.vx", &too_much),
            ("reference.top.vx_theory", &surface),
            ("record.free_field.vx", &too_much),
            ("record.free_field.vy", &both),
            ("record.free_field.vz", &|_| 0.0),
        ],
    );
    transfer(&folder, 1.0);
    let mut summary = Summary::read(&folder.summary()).unwrap();
    (summary.computed.motion.kind, summary.computed.motion.factor) = ("surface".into(), f64::NAN);
    summary.computed.motion.deconvolved = Some(site());
    let name = said!("computed motion at the record's place against the record");
    summary.soundness.checks.push(TrustLine::at_most("record_at_its_place", name, 0.0173, 0.05, ""));
    summary.write(&folder.summary()).unwrap();
    folder
}

/// The transfer up to 13.5 Hz, along y so many times that along x.
fn transfer(folder: &ResultFolder, y: f64) {
    let columns = [("x", "1"), ("y", "1"), ("z", "1")];
    table(&folder.transfer(), ("frequency", "Hz"), &columns, 28, 0.5, &|f| {
        let x = 2.9 - 0.2 * (f - 4.0).abs();
        vec![x, y * x, 7.7]
    });
}

fn change(folder: &ResultFolder, how: impl Fn(&mut Summary)) {
    let mut summary = Summary::read(&folder.summary()).unwrap();
    how(&mut summary);
    summary.write(&folder.summary()).unwrap();
}

/// The page with plain blanks.
fn page(folder: &ResultFolder) -> String {
    let page = fs::read_to_string(write_in(folder.root(), Language::English).unwrap()).unwrap();
    page.replace(['\u{a0}', '\u{202f}'], " ").replace("&#x2f;", "/").replace("&#x27;", "'")
}

fn drawing(folder: &ResultFolder, file: &str) -> Option<String> {
    let text = fs::read_to_string(folder.figures().join(file)).ok()?;
    roxmltree::Document::parse(&text).unwrap();
    assert!(!text.contains("NaN") && !text.contains("inf\"") && !text.contains("inf "), "{text}");
    Some(text.replace('\u{a0}', " "))
}

#[test]
fn caption_and_card_say_what_was_done() {
    let temp = tempfile::tempdir().unwrap();
    let folder = recorded(temp.path());
    let twice = |page: &str, text: &str| assert_eq!(page.matches(text).count(), 2, "{text}\n{page}");
    let whole = page(&folder);
    twice(
        &whole,
        "Recorded on the surface of the model's own ground at its corner xmin-ymin; the wave that comes up through the base is \
         deconvolved from it: at each frequency the record over what linear layers make of a vertical wave at that place. That \
         place moves 1.94 times the incident wave at low frequency and, of all that is let through, at least 0.731 times, at \
         6.35 Hz; the record is wanted up to 9 Hz. The record comes 0.215 s later than in its file: the wave takes time from the \
         base to its place, and what fades out rings before it as well. Above 11.3 Hz, where too little of the wave moves that place, the record fades out: at most 0.42 % of a \
         component's ∫a² dt is left out.",
    );
    assert!(whole.contains("surface record") && whole.contains("the motion given (surface record) peaks at"));
    assert!(!whole.contains("It is taken as") && !whole.contains("incident motion ="));
    change(&folder, |summary| {
        let site = Deconvolved { depth: 31.5, corner: String::new(), lead: 0.0, reach: f64::NAN, ..site() };
        (summary.computed.motion.kind, summary.computed.motion.deconvolved) = ("within".into(), Some(site));
    });
    let whole = page(&folder);
    twice(&whole, "Recorded 31.5 m below the surface of the layers of motion.site; ");
    twice(&whole, "the record is wanted up to 9 Hz. Nothing of the record is left out.");
}

#[test]
fn other_kinds_and_older_versions_say_what_they_said() {
    let temp = tempfile::tempdir().unwrap();
    let folder = recorded(temp.path());
    fs::remove_file(folder.transfer()).unwrap();
    for (kind, factor) in [("outcrop", 0.5), ("incident", 1.0), ("within", 0.5), ("within", f64::NAN)] {
        change(&folder, |summary| {
            (summary.computed.motion.kind, summary.computed.motion.factor) = (kind.into(), factor);
            summary.computed.motion.deconvolved = None;
        });
        let _ = fs::remove_dir_all(folder.figures());
        let whole = page(&folder);
        assert!(!whole.contains("deconvolved") && !whole.contains("transfer.csv"), "{kind}");
        let told = format!(
            "It is taken as {kind}: the wave that comes up through the base is {factor:.*} times",
            if factor < 1.0 { 3 } else { 2 }
        );
        assert_eq!(whole.contains(&told), factor.is_finite(), "{told}");
        assert_eq!(whole.contains("incident motion = "), factor.is_finite());
        assert!(drawing(&folder, "transfer.svg").is_none() && drawing(&folder, "record.svg").is_none());
    }
}

#[test]
fn the_transfer_is_drawn_for_what_moves_with_its_band_and_its_level() {
    let temp = tempfile::tempdir().unwrap();
    let folder = recorded(temp.path());
    let whole = page(&folder);
    let svg = drawing(&folder, "transfer.svg").unwrap();
    // Equal components are one line, and nothing moves along z, whose 7.7 would be far above.
    for name in [
        "x and y",
        "5 % of the value at low frequency: nothing is inverted below",
        "wanted up to 9 Hz",
        "fades out from 11.3 Hz",
    ] {
        assert!(svg.contains(&format!(">{name}</text>")), "{name}\n{svg}");
    }
    assert!(!svg.contains(">z</text>") && svg.contains(">3.0</text>"), "{svg}");
    // The rules stand at their frequencies, between those of the axis.
    let across = |label: &str| -> f64 {
        let (before, _) = svg.split_once(&format!(">{label}</text>")).unwrap();
        before.rsplit_once(" x=\"").unwrap().1.split('"').next().unwrap().parse().unwrap()
    };
    let at = |hertz: f64| across("2") + (hertz - 2.0) / 10.0 * (across("12") - across("2"));
    assert!((across("wanted up to 9 Hz") + 4.0 - at(9.0)).abs() < 0.2, "{svg}");
    assert!((across("fades out from 11.3 Hz") - 4.0 - at(11.3)).abs() < 0.2, "{svg}");
    // The level is 5 % of 1.94.
    let height = |label: &str| -> f64 {
        let (before, _) = svg.split_once(&format!(">{label}</text>")).unwrap();
        before.rsplit_once(" y=\"").unwrap().1.split('"').next().unwrap().parse().unwrap()
    };
    let level = svg.rsplit_once("stroke-dasharray=\"6 3\" d=\"M").unwrap().1;
    let level: f64 = level.split(['l', '\"']).next().unwrap().split_once(' ').unwrap().1.parse().unwrap();
    let wanted = height("0.0") + 0.05 * 1.94 / 3.0 * (height("3.0") - height("0.0"));
    assert!((level + 4.0 - wanted).abs() < 0.2, "{level} {wanted}");
    // The rules of the script stand there too.
    let manifest = whole.split_once("id=\"curves-data\">").unwrap().1.split_once("</script>").unwrap().0;
    let manifest: serde_json::Value = serde_json::from_str(manifest).unwrap();
    let rules = manifest["transfer.svg"]["rules"].as_array().unwrap();
    let places: Vec<f64> = rules.iter().map(|rule| rule["across"].as_f64().unwrap()).collect();
    assert_eq!(places, [9.0, 11.3]);
    assert!(whole.contains("vertical waves through linear layers"));

    transfer(&folder, 1.1);
    change(&folder, |summary| {
        summary.computed.motion.deconvolved = Some(Deconvolved { reach: f64::NAN, ..site() })
    });
    page(&folder);
    let svg = drawing(&folder, "transfer.svg").unwrap();
    assert!(svg.contains(">x</text>") && svg.contains(">y</text>") && !svg.contains("fades out"), "{svg}");
}

#[test]
fn round_off_of_a_record_that_was_turned_is_no_component() {
    let temp = tempfile::tempdir().unwrap();
    let folder = recorded(temp.path());
    given(&folder, 1e-16);
    assert!(page(&folder).contains("axes; largest 1.72 m/s² along x. <details"));
    assert!(page(&folder).contains("Nothing comes in along y, z. Recorded"));
    for file in ["input.svg", "input-drift.svg", "transfer.svg", "record.svg"] {
        let svg = drawing(&folder, file).unwrap();
        assert!(
            !svg.contains(">y</text>") && !svg.contains("and y") && !svg.contains("along y"),
            "{file}\n{svg}"
        );
    }
}

#[test]
fn a_transfer_that_is_missing_or_damaged_is_told() {
    let temp = tempfile::tempdir().unwrap();
    let folder = recorded(temp.path());
    for (content, wanted) in [
        (None, "Left out. There is no transfer.csv in the result folder."),
        (Some("frequency [Hz],x [1]\n"), "Left out. transfer.csv has no rows yet."),
        (Some("f [Hz],x [1]\n1,2\n"), "Left out. transfer.csv has no column frequency."),
        (Some("frequency [Hz],z [1]\n1,2\n"), "Left out. transfer.csv holds no motion."),
        (Some("frequency [Hz],x [1]\n1,NaN\n"), "Left out. transfer.csv holds no motion."),
    ] {
        match content {
            Some(content) => fs::write(folder.transfer(), content).unwrap(),
            None => fs::remove_file(folder.transfer()).unwrap(),
        }
        let _ = fs::remove_dir_all(folder.figures());
        let whole = page(&folder);
        assert!(whole.contains(wanted), "{wanted}");
        assert!(drawing(&folder, "transfer.svg").is_none() && drawing(&folder, "input.svg").is_some());
    }
    // Without a summary the curve stands alone.
    transfer(&folder, 1.0);
    fs::remove_file(folder.summary()).unwrap();
    page(&folder);
    let svg = drawing(&folder, "transfer.svg").unwrap();
    assert!(svg.contains(">x and y</text>") && !svg.contains("wanted up to"), "{svg}");
}

#[test]
fn what_came_out_at_its_place_lies_over_the_record() {
    let temp = tempfile::tempdir().unwrap();
    let folder = recorded(temp.path());
    let whole = page(&folder);
    assert!(whole.contains(
        "They differ by at most 1.7 % of the record's peak (check 'computed motion at the record's place against the record')."
    ));
    let svg = drawing(&folder, "record.svg").unwrap();
    for text in
        [">record</text>", ">free field where it was taken</text>", "velocity along x", "velocity along y"]
    {
        assert!(svg.contains(text), "{text}");
    }
    assert!(!svg.contains("velocity along z"));
    // It is no column of the free field.
    let section = whole.split_once("<h2>Incident motion and free field</h2>").unwrap().1;
    let section = section.split_once("</section>").unwrap().0;
    assert!(section.contains("reference") && !section.contains(">record"), "{section}");

    let none = |folder: &ResultFolder| {
        let _ = fs::remove_dir_all(folder.figures());
        page(folder);
        assert!(drawing(folder, "record.svg").is_none());
        assert!(drawing(folder, "transfer.svg").is_some());
    };
    // A check that was not made has no number.
    change(&folder, |summary| {
        let name = said!("computed motion at the record's place against the record");
        summary.soundness.checks[0] =
            TrustLine::not_applicable("record_at_its_place", name, said!("not all stages are done"));
    });
    assert!(!page(&folder).contains("of the record's peak") && drawing(&folder, "record.svg").is_some());
    // Of a monitor called 'record' its own level is meant.
    change(&folder, |summary| {
        summary.monitors.monitor_positions.insert("record".into(), [0.0, 0.0, -30.0]);
    });
    none(&folder);
    change(&folder, |summary| summary.monitors.monitor_positions.clear());
    free_field::free_field(&folder, &[("reference.top.vx", &too_much)]);
    none(&folder);
    free_field::free_field(
        &folder,
        &[("reference.top.vx", &too_much), ("record.free_field.vx", &|_| f64::NAN)],
    );
    none(&folder);
}
