//! Which way cracks run, and how much stronger concrete was for being strained fast: on the sheets, in table and figure.

use std::fs;
use std::path::Path;

use tremolite_report::{Language, write_in};
use tremolite_results::{
    CrackDirection, Cracks, Finding, MaterialFacts, MaterialValue, Onset, Opened, Origin, Place, RateFactor,
    ResultFolder, Severity, Summary,
};

use crate::report;

/// So wide \[m\] in each direction; 0 for none.
fn directions(widths: [f64; 4]) -> Vec<Opened> {
    let of = |(direction, opening): (CrackDirection, f64)| Opened {
        direction,
        opening,
        widest: (opening > 0.0).then_some(Onset { time: 7.5, element: 4712, at: [1.0, 2.5, -4.0] }),
        left: 0.3 * opening,
    };
    CrackDirection::ALL.into_iter().zip(widths).map(of).collect()
}

/// A lining of concrete that goes by the rate, cracked so wide \[m\] in each direction.
pub fn results(root: &Path, widths: [f64; 4]) -> ResultFolder {
    let folder = report::results(root, &["A"]);
    let mut summary = Summary::read(&folder.summary()).unwrap();
    let opening = widths.into_iter().fold(0.0, f64::max);
    let mut cracked = report::cracked();
    // It shares a row with what it equals, and in copies of the folder no longer does.
    cracked.measures.shift_remove("d_b_max");
    cracked.cracks = Some(Cracks { opening, directions: directions(widths), ..cracked.cracks.unwrap() });
    cracked.measures["d_tension"].rate = Some(RateFactor {
        largest: 1.637,
        at: Place { element: 4717, at: [1.0, 2.5, -5.5] },
        mean: 1.413,
        first: 1.276,
    });
    summary.parts.damage = [("hall.lining".to_owned(), cracked)].into();
    let numbers = [("share_cracked", 0.25), ("through", 7.0), ("places", 96.0), ("crack_opening", opening)];
    summary.conclusion.findings = vec![Finding {
        id: "damage_hall_lining".into(),
        group: "hall.lining".into(),
        severity: Severity::Through,
        numbers: numbers.map(|(name, value)| (name.to_owned(), value)).into(),
        ..Finding::default()
    }];
    let rate = MaterialValue {
        name: "rate".into(),
        word: "ceb".into(),
        origin: Origin::Given,
        ..MaterialValue::default()
    };
    let concrete = MaterialFacts { values: vec![rate], ..MaterialFacts::default() };
    summary.computed.materials = [("concrete".to_owned(), concrete)].into();
    summary.computed.model.duration = 20.0;
    summary.write(&folder.summary()).unwrap();
    folder
}

/// The page, with plain blanks.
fn page(folder: &ResultFolder, language: Language) -> String {
    fs::read_to_string(write_in(folder.root(), language).unwrap()).unwrap().replace('\u{a0}', " ")
}

/// The first bullet of a lining tells by which crack its limit goes, and which way the widest runs.
#[test]
fn the_verdict_tells_cracks_across_bars_apart_from_those_parallel_to_the_wall() {
    for (widths, english, chinese) in [
        (
            [2.4e-3, 0.1e-3, 9.0e-3, 0.0],
            "widest crack across bars 2.40 mm (longitudinal), parallel to the wall 9.00 mm.",
            "与钢筋相交的裂缝最宽 2.40 mm（纵向），平行于壁面的最宽 9.00 mm。",
        ),
        (
            [0.2e-3, 0.7e-3, 0.0, 0.0],
            "widest crack 0.700 mm, round the ring.",
            "最大裂缝宽度 0.700 mm（环向）。",
        ),
        (
            [0.0, 0.0, 0.7e-3, 0.0],
            "widest crack 0.700 mm, parallel to the wall; none across bars.",
            "最大裂缝宽度 0.700 mm（平行于壁面），无与钢筋相交的裂缝。",
        ),
        (
            [0.0, 0.0, 0.1e-3, 30e-3],
            "widest crack across bars > 20 mm (where walls meet), parallel to the wall 0.100 mm.",
            "与钢筋相交的裂缝最宽 > 20 mm（墙体交接处），平行于壁面的最宽 0.100 mm。",
        ),
    ] {
        let temp = tempfile::tempdir().unwrap();
        let folder = results(temp.path(), widths);
        for (language, wanted) in [(Language::English, english), (Language::Chinese, chinese)] {
            let found = page(&folder, language).replace("&gt;", ">");
            let lines = found.split_once("class=\"verdict").unwrap().1.split_once("</ul>").unwrap().0;
            assert!(lines.contains(wanted), "{wanted}: {lines}");
        }
    }
}

#[test]
fn the_page_tells_how_much_stronger_concrete_was_where_it_cracked_and_where_cracking_began() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), [1e-3, 0.0, 0.0, 0.0]);
    let english = page(&folder, Language::English);
    for text in [
        "Where it cracked its tensile strength was up to 1.64 times in hall.lining, 1.28 where cracking began.",
        "Strength by the rate of strain",
        "<td class=\"n\">1.64</td><td>element 4717 (1, 2.5, −5.5)</td><td class=\"n\">1.41</td><td class=\"n\">1.28</td>",
    ] {
        assert!(english.contains(text), "{text}");
    }
    assert!(page(&folder, Language::Chinese).contains("hall.lining 1.64 倍（最先开裂处 1.28 倍）"));

    // A law that is the same at any rate has nothing to tell.
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.computed.materials[0].values[0].word = "none".into();
    summary.write(&folder.summary()).unwrap();
    let found = page(&folder, Language::English);
    assert!(
        !found.contains("Strength by the rate of strain") && !found.contains("Where it cracked its tensile")
    );
}

#[test]
fn the_figure_over_time_draws_cracks_across_bars_and_parallel_to_the_wall() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), [2e-3, 1e-3, 9e-3, 0.0]);
    let text = "time [s],a.lining.d_tension [m3/m3],a.lining.crack_opening [m],a.lining.crack_longitudinal [m],\
                a.lining.crack_ring [m],a.lining.crack_parallel [m],a.lining.crack_unplaced [m]\n\
                0,0,0,0,0,0,0\n1,0.1,9e-3,1e-3,5e-4,9e-3,0\n2,0.3,9e-3,1e-3,4e-3,9e-3,0\n";
    fs::write(folder.damage(), text).unwrap();
    let found = page(&folder, Language::English);
    let figure = found.split_once("Damage over time").unwrap().1;
    for text in [
        "widest crack across bars (mm)",
        "widest crack parallel to the wall (mm)",
        "highest: a.lining, 4.00 mm",
        "highest: a.lining, 9.00 mm",
    ] {
        assert!(figure.contains(text), "{text}");
    }
    assert!(!figure.contains("widest crack (mm)"), "it repeats the wider of both");
}
