//! The page as a whole: its order, its list of contents, the verdict, one unit for one quantity.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use tremolite_report::{Language, write, write_in};
use tremolite_results::{
    Column, Conclusion, Finding, InterfaceSummary, MonitorFacts, ResultFolder, Severity, Soundness, Status,
    Summary, Table, TableWriter, TrustLine, peaks_by_monitor,
};

/// Monitors that move by half a metre and apart by a third of a millimetre, and cracks: what would take three units if
/// each had its own.
pub fn results(root: &Path) -> ResultFolder {
    let folder = ResultFolder::create(Some(root), "case", false).unwrap();
    let monitors = ["A", "B", "C", "D", "E", "F"];
    let quantities = [("ux", "m"), ("uz", "m"), ("s1", "Pa"), ("vx", "m/s")];
    let mut columns = vec![Column::new("time", "s")];
    for name in monitors {
        columns.extend(quantities.map(|(quantity, unit)| Column::new(format!("{name}.{quantity}"), unit)));
    }
    columns.extend(["ux", "uz", "u"].map(|quantity| Column::new(format!("A-B.{quantity}"), "m")));
    let mut table = TableWriter::create(&folder.monitors(), &columns).unwrap();
    for step in 0..=200 {
        let t = f64::from(step) / 100.0;
        let mut row = vec![t];
        for k in 0..monitors.len() {
            let u = 0.5 * (3.0 * t).sin() + 3e-4 * k as f64 * t;
            row.extend([u, 1e-3 * u, 2e6 * t, u]);
        }
        row.extend([-3e-4 * t, -3e-7 * t, 3e-4 * t]);
        table.write(&row).unwrap();
    }
    let columns = ["kinetic", "strain", "input", "error"].map(|name| Column::new(name, "J"));
    let columns = [&[Column::new("time", "s")], &columns[..]].concat();
    let mut table = TableWriter::create(&folder.energy(), &columns).unwrap();
    for step in 0..=100 {
        let t = f64::from(step) / 50.0;
        table.write(&[t, 2e6 * t, 1e5 * t, 3e6 * t, -30.0 * t]).unwrap();
    }
    fs::write(
        folder.damage(),
        "time [s],hall.lining.d_tension [m3/m3],hall.lining.crack_opening [m]\n0,0,0\n1,0.1,1e-4\n2,0.3,6e-4\n",
    )
    .unwrap();
    fs::write(root.join("case.toml"), "title = \"<b>bold</b> & </pre><script>alert(1)</script>\"\n").unwrap();
    let [all, relative] = peaks_by_monitor(&Table::read(&folder.monitors()).unwrap());
    let pair = relative["A-B"].clone();
    let mut summary = Summary {
        title: "Two linings".into(),
        conclusion: Conclusion {
            status: Status::Done,
            findings: vec![
                cracked("hall.lining", [0.123, 7.0, 96.0, 6e-4]),
                cracked("adit.lining", [0.345, 0.0, 48.0, 2e-4]),
                Finding {
                    id: "damage_rock".into(),
                    group: "rock".into(),
                    severity: Severity::Damaged,
                    numbers: [("share_yielded_in_shear".to_owned(), 0.0004)].into(),
                    ..Finding::default()
                },
                Finding {
                    id: "interface_joint".into(),
                    group: "joint".into(),
                    severity: Severity::Damaged,
                    numbers: [("share_slid".to_owned(), 0.021), ("share_opened".to_owned(), 0.0)].into(),
                    ..Finding::default()
                },
                Finding {
                    id: "bolts_crown".into(),
                    group: "crown".into(),
                    severity: Severity::Undamaged,
                    numbers: [("bolts", 144.0), ("yielded", 3.0), ("broken", 0.0)]
                        .map(|(name, value)| (name.to_owned(), value))
                        .into(),
                    ..Finding::default()
                },
            ],
            ..Conclusion::default()
        },
        soundness: Soundness {
            checks: (0..4)
                .map(|k| {
                    TrustLine::at_most(format!("check_{k}"), tremolite_results::said!("check"), 0.5, 1.0, "")
                })
                .collect(),
            ..Soundness::default()
        },
        monitors: MonitorFacts {
            peaks: all,
            relative: [("A-B".to_owned(), pair)].into(),
            ..MonitorFacts::default()
        },
        ..Summary::default()
    };
    summary.soundness.checks[3].pass = false;
    summary.computed.model.duration = 2.0;
    summary.parts.interfaces.insert("joint".into(), InterfaceSummary::default());
    summary.write(&folder.summary()).unwrap();
    folder
}

fn cracked(group: &str, [share, through, places, opening]: [f64; 4]) -> Finding {
    Finding {
        id: format!("damage_{}", group.replace('.', "_")),
        group: group.into(),
        severity: if through > 0.0 { Severity::Through } else { Severity::Damaged },
        numbers: [
            ("share_cracked", share),
            ("through", through),
            ("places", places),
            ("crack_opening", opening),
        ]
        .map(|(name, value)| (name.to_owned(), value))
        .into(),
        ..Finding::default()
    }
}

/// The page before its data and script.
fn main_of(page: &str) -> &str {
    page.split_once("</main>").unwrap().0
}

fn between<'a>(text: &'a str, from: &str, to: &str) -> Vec<&'a str> {
    text.split(from).skip(1).filter_map(|rest| Some(rest.split_once(to)?.0)).collect()
}

/// A line of the two classes without its marks.
fn plain(line: &str) -> String {
    line.split_once('>').unwrap().1.replace("<strong>", "").replace("</strong>", "")
}

/// The question with state and reliance, and the lines below.
fn verdict(page: &str) -> (String, Vec<String>) {
    let (_, from) = page.split_once("<div class=\"verdict").unwrap();
    let (inside, _) = from.split_once("</div>").unwrap();
    let inside = inside.replace('\u{a0}', " ");
    let judged: Vec<String> = between(&inside, "<p class=\"judged ", "</p>").into_iter().map(plain).collect();
    let question = between(&inside, "<p class=\"question\">", "</p>")[0];
    let question = format!("{question} {}", judged.join(" "));
    let lines = inside.split("<li ").skip(1);
    let text =
        |line: &str| line.split_once('>').unwrap().1.split_once("</li>").unwrap().0.replace("&lt;", "<");
    (question, lines.map(text).collect())
}

#[test]
fn sections_come_in_their_order_and_the_contents_list_each_once() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    for language in [Language::English, Language::Chinese] {
        let page = fs::read_to_string(write_in(folder.root(), language).unwrap()).unwrap();
        let page = main_of(&page);
        let sections = between(page, "<section id=\"", "\"");
        let order = [
            "findings",
            "displacement",
            "displacement-less-mean",
            "relative",
            "stress",
            "damage-map",
            "damage-history",
            "velocity",
            "acceleration",
            "peaks",
            "interfaces",
            "energy",
            "trust",
            "model",
            "defaulted",
            "case",
            "run",
        ];
        let known: Vec<&str> = sections.iter().copied().filter(|id| order.contains(id)).collect();
        assert_eq!(known, order);
        let links = between(page, "<a href=\"#", "\"");
        assert_eq!(links, sections, "the contents list every section once, in its order");
        assert_eq!(links.iter().collect::<BTreeSet<_>>().len(), links.len());
        let (head, contents) = page.split_once("<nav").unwrap();
        assert!(head.contains("class=\"verdict") && !head.contains("<section"));
        assert!(contents.contains("<section"));
        let headings = between(page, "<h2>", "</h2>");
        assert_eq!(headings.len(), sections.len());
        let (list, _) = contents.split_once("</nav>").unwrap();
        for (heading, named) in headings.iter().zip(between(list, "\">", "</a>")) {
            assert!(!heading.is_empty() && *heading == named, "{heading} and {named}");
        }
    }
}

#[test]
fn the_verdict_answers_in_five_lines_with_the_numbers_of_the_summary() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let page = fs::read_to_string(write(folder.root()).unwrap()).unwrap();
    let (question, lines) = verdict(&page);
    assert!(question.starts_with("Does the lining withstand the earthquake?"));
    for told in [
        "State: damaged. hall.lining: cracks run through its thickness. ",
        "adit.lining: cracked.",
        "Bolts or bars of crown yielded.",
        "Reliance: with reservations. 3 of 4 checks of the run pass. Check &#x27;check&#x27;: ",
    ] {
        assert!(question.contains(told), "{told}: {question}");
    }
    assert_eq!(
        lines,
        [
            "hall.lining: cracked in 12.3 % of its volume, through the thickness at 7 of 96 places; widest crack 0.600 mm.",
            "adit.lining: cracked in 34.5 % of its volume, nowhere through the thickness; widest crack 0.200 mm.",
            "Interface joint: slid over 2.1 % of its area, opened nowhere.",
            "Bolts crown: 3 of 144 yielded, none broke.",
            "rock: yielded in shear in < 0.1 % of its volume.",
        ]
    );
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.conclusion.findings.retain(|finding| ["hall.lining", "rock"].contains(&finding.group.as_str()));
    summary.conclusion.findings[0].group = ["hall.bench1"; 9].join(", ");
    summary.soundness.checks[1].pass = false;
    summary.write(&folder.summary()).unwrap();
    let (question, lines) = verdict(&fs::read_to_string(write(folder.root()).unwrap()).unwrap());
    assert_eq!(question.matches("Check &#x27;check&#x27;: ").count(), 2, "{question}");
    assert!(lines[0].starts_with("hall.bench1, hall.bench1, hall.benc…"), "{}", lines[0]);
    assert_eq!(lines[1], "rock: yielded in shear in < 0.1 % of its volume.");
    assert!(
        lines[2].starts_with("Monitors A-B moved by up to 0.600 mm"),
        "what there is room for: {lines:?}"
    );
    for k in 0..5 {
        summary.conclusion.findings.push(cracked(&format!("more{k}.lining"), [0.01, 1.0, 10.0, 1e-4]));
    }
    summary.write(&folder.summary()).unwrap();
    let page = fs::read_to_string(write(folder.root()).unwrap()).unwrap();
    let (_, lines) = verdict(&page);
    assert!(lines.len() <= 5, "{lines:?}");
    assert!(lines.iter().any(|line| line.starts_with("4 more structures")), "{lines:?}");
    assert!(lines[0].starts_with("hall.bench1"), "the worst first: {lines:?}");
}

#[test]
fn the_verdict_says_what_is_not_known() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let mut summary = Summary::read(&folder.summary()).unwrap();
    let answer = |summary: &Summary| {
        summary.write(&folder.summary()).unwrap();
        verdict(&fs::read_to_string(write(folder.root()).unwrap()).unwrap()).0
    };
    summary.conclusion.status = Status::Failed;
    let failed = answer(&summary);
    assert!(failed.contains("State: not judged. The run failed. Reliance: not to be used."), "{failed}");
    summary.conclusion.status = Status::Stopped;
    let stopped = answer(&summary);
    assert!(stopped.contains("State: damaged. hall.lining: cracks run through"), "{stopped}");
    assert!(stopped.contains("Reliance: not to be used."), "{stopped}");
    summary.conclusion.status = Status::Done;
    let whole = summary.clone();
    for finding in summary.conclusion.findings.iter_mut() {
        finding.severity = Severity::Undamaged;
        finding.numbers.clear();
    }
    assert!(
        answer(&summary).contains("State: withstands. No damage is computed. Reliance: with reservations.")
    );
    summary = whole;
    summary.conclusion.findings.retain(|finding| finding.group == "rock");
    assert!(answer(&summary).contains("State: not judged. The run has no lining"));
    fs::remove_file(folder.summary()).unwrap();
    let page = fs::read_to_string(write(folder.root()).unwrap()).unwrap();
    assert!(verdict(&page).0.contains("State: not judged. There is no summary of the run."));
}

/// Units of the SI unit `symbol` that stand in brackets behind titles, or behind a number.
fn units<'a>(text: &'a str, symbol: &str) -> BTreeSet<&'a str> {
    let words = text.split(|c: char| c.is_whitespace() || "(),;:.<>\"".contains(c));
    let prefixes = ["n", "µ", "m", "c", "k", "M", "G", ""];
    words.filter(|word| prefixes.iter().any(|prefix| format!("{prefix}{symbol}") == **word)).collect()
}

#[test]
fn a_quantity_has_one_unit_on_the_whole_page() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let page = fs::read_to_string(write(folder.root()).unwrap()).unwrap();
    let drawing = |name: &str| fs::read_to_string(folder.figures().join(name)).unwrap();
    let (_, lines) = verdict(&page);
    let (_, tables) = page.split_once("<section id=\"peaks\"").unwrap();
    let (tables, _) = tables.split_once("</section>").unwrap();
    let headings = between(tables, "<h3>", "</h3>");
    let heading = |name: &str| headings.iter().find(|heading| heading.starts_with(name)).unwrap().to_string();
    // Half a metre, a third of a millimetre, and what is shared taken away.
    for place in [
        drawing("displacement.svg"),
        drawing("displacement-less-mean.svg"),
        drawing("relative.svg"),
        drawing("damage.svg"),
        heading("Displacement"),
        heading("Relative displacement"),
        lines[0].clone(),
    ] {
        assert_eq!(units(&place, "m"), BTreeSet::from(["mm"]), "{place}");
    }
    // Megajoules that go through, and an error of some joules.
    let (_, energy) = page.split_once("<section id=\"energy\"").unwrap();
    let (energy, _) = energy.split_once("</section>").unwrap();
    assert_eq!(units(energy, "J").len(), 1, "{:?}", units(energy, "J"));
}

#[test]
fn the_case_is_on_the_page_as_text() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let page = fs::read_to_string(write(folder.root()).unwrap()).unwrap();
    assert!(page.contains("&lt;b&gt;bold&lt;&#x2f;b&gt; &amp; &lt;&#x2f;pre&gt;&lt;script&gt;alert(1)"));
    assert!(!main_of(&page).contains("<script") && !page.contains("<b>bold"));
    fs::remove_file(temp.path().join("case.toml")).unwrap();
    let page = fs::read_to_string(write(folder.root()).unwrap()).unwrap();
    assert!(!page.contains("id=\"case\""));
}

#[test]
fn a_page_in_chinese_speaks_chinese_at_its_top_and_in_its_contents() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let page = fs::read_to_string(write_in(folder.root(), Language::Chinese).unwrap()).unwrap();
    let (question, lines) = verdict(&page);
    let chinese = |text: &str| text.chars().any(|c| ('\u{4e00}'..'\u{9fff}').contains(&c));
    assert!(question.starts_with("衬砌能否"), "{question}");
    assert!(chinese(&question) && lines.iter().all(|line| chinese(line)), "{question} {lines:?}");
    assert!(lines[0].contains("贯穿性裂缝 7&#x2f;96 处"), "{}", lines[0]);
    assert!(question.contains("状态：已受损") && question.contains("可信度：有保留"), "{question}");
    assert!(page.contains("<html lang=\"zh-CN\">") && page.contains("目录") && page.contains("能量平衡"));
}
