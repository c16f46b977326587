use super::*;
use tremolite_results::study::{
    Influence, RunStatus, Share, StudyBounds, StudyColumn, StudyFit, StudyFragility, StudyLimit, StudyRun,
    Tornado, TornadoBar,
};

fn sample() -> Study {
    let column = |name: &str, unit: &str| StudyColumn {
        name: name.into(),
        unit: Some(unit.into()),
        shown: String::new(),
        shown_factor: 1.0,
    };
    let run = |k: usize| StudyRun {
        name: format!("s{k}_<a>_0.{k}-g"),
        title: format!("s{k}"),
        sample: k,
        record: Some("<a>".into()),
        level: Some(format!("0.{k} g")),
        factor: Some(0.5),
        values: vec![Some(format!("\"{k} MPa\""))],
        intensities: vec![Some(0.980665 * k as f64)],
        measures: vec![if k == 3 { None } else { Some(0.1 * k as f64) }],
        status: if k == 3 { RunStatus::Failed } else { RunStatus::Done },
        why: if k == 3 { "It became <unstable>.".into() } else { String::new() },
        ..StudyRun::default()
    };
    Study {
        title: "What & where".into(),
        parameters: vec![column("material.c.tensile_strength", "MPa")],
        intensities: vec![StudyColumn { shown: "g".into(), shown_factor: 9.80665, ..column("PGA", "m/s2") }],
        measures: vec![column("cracked", "")],
        runs: (1..=4).map(run).collect(),
        tornados: vec![Tornado {
            measure: "cracked".into(),
            beside: String::new(),
            base: 0.2,
            bars: vec![TornadoBar {
                name: "initial.lateral".into(),
                low: ("0.5".into(), 0.1),
                high: ("1.2".into(), 0.4),
            }],
        }],
        influences: vec![Influence {
            parameter: "material.c.tensile_strength".into(),
            measure: "cracked".into(),
            rank: 1.0,
            runs: 3,
        }],
        fragilities: vec![
            StudyFragility {
                measure: "cracked".into(),
                above: 0.25,
                by: "PGA".into(),
                unit: "g".into(),
                fit: Some(StudyFit {
                    theta: 0.25,
                    beta: 0.3,
                    covariance: [[0.01, 0.0], [0.0, 0.02]],
                    log_likelihood: -3.0,
                }),
                curve: vec![[0.0, 0.0], [0.25, 0.5], [0.5, 0.98]],
                bounds: Some(StudyBounds {
                    band: vec![[0.0, 0.0], [0.3, 0.7], [0.9, 1.0]],
                    samples: 90,
                    without: 10,
                    ..StudyBounds::default()
                }),
                shares: vec![
                    Share { intensity: 0.1, exceeded: 0, of: 1, probability: None },
                    Share { intensity: 0.4, exceeded: 1, of: 1, probability: None },
                ],
                counted: 4,
                exceeded: 2,
                stopped_counted: 1,
                left_out: vec![("not_converged".into(), 2)],
                ..StudyFragility::default()
            },
            StudyFragility {
                measure: "cracked".into(),
                above: 0.9,
                no_curve: "the data are separated".into(),
                ..StudyFragility::default()
            },
        ],
        ..Study::default()
    }
}

#[test]
fn the_page_says_what_is_counted_and_what_is_not() {
    let out = tempfile::tempdir().unwrap();
    sample().write(&out.path().join("study.json")).unwrap();
    let page = study(out.path(), None).unwrap();
    let text = fs::read_to_string(&page).unwrap();
    for says in [
        "What &amp; where",
        "It became &lt;unstable&gt;.",
        "1 stopped by the guard in the earthquake and counted as beyond it",
        "Left out: 2 not converged",
        "the data are separated",
        "10 of 100 samples of the bootstrap have no curve",
        "median 0.25 g",
    ] {
        assert!(text.contains(says), "{says}");
    }
    for figure in [
        "fragility-1-cracked",
        "levels-cracked",
        "tornado-cracked",
        "scatter-cracked-material-c-tensile-strength",
    ] {
        let svg = fs::read_to_string(out.path().join(format!("figures/{figure}.svg"))).unwrap();
        roxmltree::Document::parse(&svg).unwrap_or_else(|e| panic!("{figure}: {e}"));
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{figure}");
    }
    let again = fs::read(&page).unwrap();
    study(out.path(), None).unwrap();
    assert_eq!(fs::read(&page).unwrap(), again);
}

/// The eighth was named in the colour of the first.
#[test]
fn lines_over_intensity_are_named_while_each_has_a_colour_of_its_own() {
    let names = |records: usize| {
        let mut study = sample();
        let run = study.runs[0].clone();
        study.runs = (0..records)
            .map(|k| StudyRun { record: Some(format!("record{k}")), sample: 0, ..run.clone() })
            .collect();
        let svg = rising::figures(&study, Language::English).remove(0).svg;
        svg.matches(">record").count()
    };
    assert_eq!((names(7), names(8)), (7, 0));
}

/// A run whose page is there is a link to it, and each limit of acceptance a column.
#[test]
fn runs_lead_to_their_pages_and_tell_whether_their_limits_are_met() {
    let out = tempfile::tempdir().unwrap();
    let mut held = sample();
    let limit = |found, met, limit, unit: &str| StudyLimit { limit, found, met, unit: unit.into() };
    let both = |found: f64, met| {
        [
            ("crack_width".to_owned(), limit(Some(found), Some(met), 3e-4, "m")),
            ("utilisation".to_owned(), limit(None, Some(false), 1.0, "1")),
        ]
    };
    held.runs[0].page = "runs/s1 #1/results/report.html".into();
    held.runs[0].limits = both(1.2e-4, true).into();
    held.runs[1].limits = both(4.5e-4, false).into();
    held.runs[3].limits = [("crack_width".to_owned(), limit(Some(1e-4), Some(true), 3e-4, "m"))].into();
    held.write(&out.path().join("study.json")).unwrap();
    assert_eq!(Study::read(&out.path().join("study.json")).unwrap(), held);
    let text = fs::read_to_string(study(out.path(), None).unwrap()).unwrap().replace('\u{a0}', " ");
    for says in [
        "<a href=\"runs&#x2f;s1%20%231&#x2f;results&#x2f;report.html\">",
        "<th>Crack width</th><th>Utilisation of a section</th>",
        "<td class=\"pass\">met <span class=\"note\">0.12 mm, ≤ 0.3 mm</span>",
        "<td class=\"fail\">not met <span class=\"note\">0.45 mm, ≤ 0.3 mm</span>",
        "<td class=\"fail\">not met <span class=\"note\">∞, ≤ 1</span>",
        "1 of 3 runs with results meet all limits of acceptance of their case",
    ] {
        assert!(text.contains(says), "{says}: {}", text.split("id=\"table\"").last().unwrap_or_default());
    }
    assert_eq!(text.matches("<a href=\"runs").count(), 1, "the others have no page");
    let chinese = fs::read_to_string(study(out.path(), Some(Language::Chinese)).unwrap()).unwrap();
    assert!(chinese.contains("3 次计算中，1 次满足") && chinese.contains("<th>裂缝宽度</th>"));
}

#[test]
fn a_study_of_which_nothing_ran_has_a_page() {
    let out = tempfile::tempdir().unwrap();
    assert!(study(out.path(), None).is_err());
    let mut nothing = sample();
    for run in &mut nothing.runs {
        (run.status, run.measures, run.intensities) = (RunStatus::Pending, vec![None], vec![None]);
    }
    nothing.fragilities.clear();
    nothing.tornados.clear();
    nothing.influences.clear();
    nothing.write(&out.path().join("study.json")).unwrap();
    let text = fs::read_to_string(study(out.path(), None).unwrap()).unwrap();
    assert!(text.contains("4 still to run"), "{text}");
}

/// No text of the page but names stays English: in none do three words of it stand in a row.
#[test]
fn a_page_in_chinese_is_chinese_throughout() {
    let out = tempfile::tempdir().unwrap();
    let mut all = sample();
    all.language = "zh".into();
    all.write(&out.path().join("study.json")).unwrap();
    let text = fs::read_to_string(study(out.path(), None).unwrap()).unwrap();
    assert!(
        text.contains("<html lang=\"zh-CN\">")
            && text.contains("易损性曲线")
            && text.contains("3 次计算至结束"),
        "{text}"
    );
    let names = [all.title.as_str(), "It became <unstable>.", "the data are separated"];
    let plain = text.split("</style>").nth(1).unwrap();
    let mut told = String::new();
    for part in plain.split('<').skip(1) {
        told += part.split_once('>').map_or("", |(_, text)| text);
        told.push('\n');
    }
    let told = told.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
    let told = names.iter().fold(told, |told, name| told.replace(name, ""));
    for line in told.lines() {
        let words =
            line.split(|c: char| !(c.is_ascii_alphabetic() || c == ' ')).map(|part| part.split_whitespace());
        for row in words {
            let row: Vec<&str> = row.filter(|word| word.len() > 1).collect();
            assert!(row.len() < 3, "{line}");
        }
    }
    let english = fs::read_to_string(study(out.path(), Some(crate::Language::English)).unwrap()).unwrap();
    assert!(english.contains("Fragility curves"), "the reader's own wish goes first");
}
