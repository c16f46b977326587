//! The page holds what the files hold, whatever the files hold.

use std::fs;
use std::path::Path;

use tremolite_mesh::vtu::{Array, Grid, Values};
use tremolite_mesh::{Element, Mesh, Shape};
use tremolite_report::{Language, write, write_in};
use tremolite_results::{
    CaseFacts, Column, Computed, Conclusion, Cracks, Damaged, Defaulted, Finding, GroupDamage, MaterialFacts,
    MaterialGroup, MaterialValue, MonitorFacts, Onset, Origin, Place, Pvd, ResultFolder, Severity, Soundness,
    Status, Summary, Table, TableWriter, TrustLine, peaks_by_monitor, said,
};

/// A small but complete result folder: monitors with the given names, one second of a swinging motion.
pub fn results(root: &Path, monitors: &[&str]) -> ResultFolder {
    let folder = ResultFolder::create(Some(root), "case", false).unwrap();
    let quantities =
        [("ux", "m"), ("uy", "m"), ("uz", "m"), ("vx", "m/s"), ("ax", "m/s2"), ("s1", "Pa"), ("d_b", "")];
    let mut columns = vec![Column::new("time", "s")];
    for monitor in monitors {
        columns.extend(quantities.map(|(q, unit)| Column::new(format!("{monitor}.{q}"), unit)));
    }
    let mut table = TableWriter::create(&folder.monitors(), &columns).unwrap();
    for step in 0..=400 {
        let t = f64::from(step) / 400.0;
        let mut row = vec![t];
        for k in 0..monitors.len() {
            let u = 0.05 * (1.0 + 0.1 * k as f64) * (20.0 * t).sin() * t;
            row.extend([u, 0.0, 0.5 * u, 10.0 * u, 80.0 * u, 0.85e6 + 1.5e7 * u, 0.5 * t]);
        }
        table.write(&row).unwrap();
    }
    let columns = ["kinetic", "strain", "error"].map(|name| Column::new(name, "J"));
    let mut table =
        TableWriter::create(&folder.energy(), &[&[Column::new("time", "s")], &columns[..]].concat()).unwrap();
    for step in 0..=100 {
        let t = f64::from(step) / 100.0;
        table.write(&[t, 2e5 * t, 1e5 * t * t, -300.0 * t]).unwrap();
    }
    let mut summary = Summary {
        title: "Cavern under a hill".into(),
        conclusion: Conclusion {
            status: Status::Done,
            verdict: "The lining stays elastic.".into(),
            ..Conclusion::default()
        },
        computed: Computed { wall_seconds: 90.0, ..Computed::default() },
        soundness: Soundness {
            checks: vec![
                TrustLine::at_most("energy_error", said!("energy error"), 0.0015, 0.01, "")
                    .with_note(said!("over the run")),
            ],
            ..Soundness::default()
        },
        case: CaseFacts {
            defaults_used: vec![Defaulted::new("dynamic.safety", "0.9")],
            ..CaseFacts::default()
        },
        monitors: MonitorFacts {
            peaks: peaks_by_monitor(&Table::read(&folder.monitors()).unwrap())[0].clone(),
            ..MonitorFacts::default()
        },
        ..Summary::default()
    };
    if let [first, second, ..] = monitors {
        let pair = summary.monitors.peaks[*first].clone();
        summary.monitors.relative.insert(format!("{first}-{second}"), pair);
    }
    summary.write(&folder.summary()).unwrap();
    folder
}

fn page(folder: &ResultFolder) -> String {
    fs::read_to_string(write(folder.root()).unwrap()).unwrap()
}

/// Every drawing is well-formed XML; returns their names.
fn drawings(folder: &ResultFolder) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for entry in fs::read_dir(folder.figures()).unwrap() {
        let path = entry.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        roxmltree::Document::parse(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        assert!(!text.contains("NaN") && !text.contains("inf"), "{}", path.display());
        names.push(path.file_name().unwrap().to_str().unwrap().into());
    }
    names.sort();
    names
}

#[test]
fn the_page_shows_every_monitor_every_check_and_every_default() {
    let temp = tempfile::tempdir().unwrap();
    let names = ["A", "crown-left", "拱顶", "hall.2"];
    let folder = results(temp.path(), &names);
    let page = page(&folder);
    for name in names {
        let breakable = name.replace('.', ".<wbr>");
        assert!(page.contains(&format!("<th>{breakable}</th>")), "{name} in the table of peaks");
        assert!(page.contains(&format!(">{name}</text>")), "{name} in a legend");
    }
    for text in
        ["Run: all 1 checks pass", "energy error", "0.00150", "≤\u{a0}0.01", "dynamic.safety", "A-crown-left"]
    {
        assert!(page.contains(text), "{text}");
    }
    assert_eq!(
        drawings(&folder),
        [
            "acceleration.svg",
            "displacement-less-mean.svg",
            "displacement.svg",
            "energy.svg",
            "further-1.svg",
            "relative.svg",
            "stress.svg",
            "velocity.svg"
        ]
    );
    // 50 mm · 1.3 at the last of the four, at the largest of t sin 20 t on the grid of the table.
    let peak =
        (0..=400).map(|k| f64::from(k) / 400.0).map(|t| (t * (20.0 * t).sin()).abs()).fold(0.0, f64::max);
    assert!(page.contains(&format!("{:.1}\u{a0}mm", 65.0 * peak)), "{}", 65.0 * peak);
}

#[test]
fn the_page_is_self_contained_and_equal_for_equal_results() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A", "B"]);
    let first = page(&folder);
    assert_eq!(first, page(&folder));
    // Behind the main part come the script and its data, which the browser holds to the policy above all else.
    assert!(first.contains("content=\"default-src 'none'; script-src 'unsafe-inline'"));
    let (main, _) = first.split_once("</main>").unwrap();
    let outside = main.replace("http://www.w3.org/2000/svg", "");
    // Links lead into the page itself.
    let outside = outside.replace("href=\"#", "");
    for reference in ["http:", "https:", "src=", "href=", "@import", "url(", "<script "] {
        assert!(!outside.contains(reference), "{reference}");
    }
}

#[test]
fn text_from_files_cannot_become_markup() {
    let temp = tempfile::tempdir().unwrap();
    let evil = "<script>alert(1)</script>&\"'";
    let folder = results(temp.path(), &["<img/onerror=x>", "B</text>&amp;"]);
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.title = evil.into();
    summary.conclusion.verdict = format!("{{{{ 7 * 7 }}}} {evil}");
    summary.soundness.checks[0].name = evil.into();
    summary.soundness.checks[0].unit = "<b>".into();
    summary.soundness.checks[0].note = evil.into();
    summary.computed.model.step_set_by = evil.into();
    summary.computed.model.steps = 1;
    summary.computed.motion.kind = evil.into();
    summary.computed.motion.peak_acceleration.insert(evil.into(), 1.0);
    summary.computed.run.command = evil.into();
    summary.monitors.monitor_positions.insert(evil.into(), [0.0; 3]);
    summary.case.defaults_used.push(Defaulted::new(evil, evil));
    summary.write(&folder.summary()).unwrap();
    let page = page(&folder);
    let (page, _) = page.split_once("</main>").unwrap();
    for markup in ["<script", "<img", "<b>", "B</text>&amp;"] {
        assert!(!page.contains(markup), "{markup}");
    }
    assert!(page.contains("{{ 7 * 7 }}"), "a template in a text is text");
    drawings(&folder);
}

#[test]
fn what_is_missing_or_damaged_is_left_out_with_its_reason() {
    type Damage = fn(&ResultFolder);
    let cases: [(Damage, &str); 9] = [
        (|f| fs::remove_file(f.summary()).unwrap(), "There is no summary.json"),
        (|f| fs::write(f.summary(), "{").unwrap(), "not a summary of a run"),
        (|f| fs::remove_file(f.monitors()).unwrap(), "There is no monitors.csv"),
        (|f| fs::write(f.monitors(), "time [s],A.ux [m]\n").unwrap(), "monitors.csv has no rows yet"),
        (|f| fs::write(f.monitors(), "t [s],A.ux [m]\n1,2\n").unwrap(), "monitors.csv has no column time"),
        (|f| fs::write(f.monitors(), "time [s],A.ux [m]\n1,x\n").unwrap(), "is not a number"),
        (|f| fs::write(f.monitors(), "time [s],A.s1 [Pa]\n0,1\n1,2\n").unwrap(), "no columns of ux, uy, uz"),
        (|f| fs::remove_file(f.energy()).unwrap(), "There is no energy.csv"),
        (|f| fs::write(f.energy(), "time [s],kinetic [J]\n0,0\n1,5\n").unwrap(), "no column error"),
    ];
    for (damage, reason) in cases {
        let temp = tempfile::tempdir().unwrap();
        let folder = results(temp.path(), &["A"]);
        damage(&folder);
        let page = page(&folder);
        assert!(page.contains(reason), "{reason}");
        drawings(&folder);
    }
    let temp = tempfile::tempdir().unwrap();
    assert!(write(temp.path()).is_err(), "an empty folder is no result");
}

#[test]
fn histories_with_gaps_extremes_and_cut_lines_are_drawn() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    for content in [
        "time [s],A.ux [m]\n0,0\n1,NaN\n2,1e-3\n3,inf\n4,2e-3\n5,0.00",
        "time [s],A.ux [m]\n0,1e308\n1,-1e308\n",
        "time [s],A.ux [m]\n0,5e-324\n1,0\n",
        "time [s],A.ux [m]\nNaN,1\nNaN,2\n",
        "time [s],A.ux [m]\n1,1\n",
        "time [s],A.ux [m]\n0,NaN\n1,NaN\n",
        "time [s],A.ux [m]\n3,1\n2,2\n2,5\n9,1\n",
    ] {
        fs::write(folder.monitors(), content).unwrap();
        let page = page(&folder);
        drawings(&folder);
        assert_eq!(page.contains("ends in the middle of a line"), !content.ends_with('\n'), "{content}");
    }
}

#[test]
fn the_banner_tells_failed_stopped_warned_and_good_runs_apart() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    let mut summary = Summary::read(&folder.summary()).unwrap();
    for (status, pass, class, headline) in [
        (Status::Done, true, "good", "Run: all 1 checks pass"),
        (Status::Done, false, "warn", "Run: done, 1 of 1 checks warns"),
        (Status::Stopped, true, "bad", "Run: stopped before its end"),
        (Status::Failed, true, "bad", "Run: failed"),
    ] {
        summary.conclusion.status = status;
        summary.soundness.checks[0].pass = pass;
        summary.write(&folder.summary()).unwrap();
        let page = page(&folder);
        assert!(
            page.contains(&format!("class=\"outcome {class}\"")) && page.contains(headline),
            "{headline}"
        );
    }
}

#[test]
fn more_monitors_than_a_page_of_paper_holds_go_on_in_further_figures() {
    let temp = tempfile::tempdir().unwrap();
    let names: Vec<String> = (0..16).map(|i| format!("M{i}")).collect();
    let folder = results(temp.path(), &names.iter().map(String::as_str).collect::<Vec<_>>());
    write(folder.root()).unwrap();
    let drawn = drawings(&folder);
    for (file, monitors, cells) in
        [("displacement.svg", ["M0", "M13"], 28), ("displacement-2.svg", ["M14", "M15"], 4)]
    {
        assert!(drawn.iter().any(|name| name == file), "{file}");
        let drawing = fs::read_to_string(folder.figures().join(file)).unwrap();
        // x and z; nothing moves along y. Each has a cell of its own with the range of all behind it.
        for monitor in monitors {
            assert_eq!(drawing.matches(&format!(">{monitor}</text>")).count(), 2, "{file}: {monitor}");
        }
        assert_eq!(drawing.matches("class=\"veil\"").count(), cells, "{file}");
    }
    assert!(!drawn.contains(&"displacement-3.svg".to_owned()));
}

#[test]
fn a_field_file_gives_a_section_and_a_broken_one_a_reason() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    let corner = |i: u32| [f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)];
    let mesh = Mesh {
        nodes: (0..8).map(corner).collect(),
        elements: vec![Element::new(Shape::Hex8, &[0, 1, 3, 2, 4, 5, 7, 6])],
        ..Mesh::default()
    };
    let (mut grid, _) = Grid::from_mesh(&mesh, None);
    grid.cell_data.push(Array::new("s1_max", "Pa", 1, Values::Float64(vec![1.5e6])));
    let mut pvd = Pvd::create(&folder.pvd()).unwrap();
    assert!(page(&folder).contains("lists no field file yet"));
    grid.write(&folder.fields().join("0.vtu")).unwrap();
    pvd.add(0.5, "fields/0.vtu").unwrap();
    assert!(page(&folder).contains("1.50\u{a0}MPa in the element at x = 0.500\u{a0}m"));
    assert!(drawings(&folder).contains(&"section-s1.svg".into()));

    grid.cell_data[0].values = Values::Float64(vec![f64::NAN]);
    grid.write(&folder.fields().join("0.vtu")).unwrap();
    assert!(page(&folder).contains("The last field file has no field"));
    fs::write(folder.fields().join("0.vtu"), "garbage").unwrap();
    assert!(page(&folder).contains("not a readable VTU file"));
    fs::remove_file(folder.fields().join("0.vtu")).unwrap();
    assert!(page(&folder).contains("0.vtu"));
}

/// A lining of 80 m³ with two measures of damage.
pub fn cracked() -> GroupDamage {
    let measure = |beyond: &[(&str, f64)], first| Damaged {
        beyond: beyond.iter().map(|(t, v)| ((*t).to_owned(), *v)).collect(),
        largest: 0.95,
        first,
        rate: None,
    };
    let first = Some(Onset { time: 4.25, element: 4711, at: [1.0, 2.5, -3.0] });
    let in_stages = Some(Onset { time: 0.0, element: 7, at: [0.0; 3] });
    let widest = Some(Onset { time: 7.5, element: 4712, at: [1.0, 2.5, -4.0] });
    GroupDamage {
        volume: 80.0,
        measures: [
            ("d_tension".to_owned(), measure(&[("0.5", 20.0), ("0.9", 4.0)], first)),
            ("d_b_max".to_owned(), measure(&[("0.5", 20.0), ("0.9", 4.0)], first)),
            ("d_new".to_owned(), measure(&[("0.5", f64::NAN)], None)),
            ("plastic_shear_strain".to_owned(), measure(&[("1e-6", 1.0)], in_stages)),
        ]
        .into(),
        cracks: Some(Cracks {
            opening: 2.4e-4,
            widest,
            left: 1.1e-4,
            directions: Vec::new(),
            stacks: 96,
            through: 7,
            through_at: Some(Place { element: 4713, at: [0.0; 3] }),
        }),
    }
}

#[test]
fn damage_is_tabled_by_group_and_measure_with_volumes_shares_beginnings_and_cracks() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    assert!(!page(&folder).contains("id=\"damage\""), "nothing can be damaged in this run");
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.parts.damage.insert("hall.<lining>".into(), cracked());
    summary.computed.model.duration = 20.0;
    summary.write(&folder.summary()).unwrap();
    let page = page(&folder);
    for text in [
        "Cracked, D⁺",
        "above 0.5",
        "above 1e-6",
        ">20 <span class=\"note\">25\u{a0}%",
        ">4 <span class=\"note\">5\u{a0}%",
        "4.25\u{a0}s",
        ">before the earthquake<",
        "element\u{a0}4711 (1,\u{a0}2.5,\u{a0}−3)",
        "hall.<wbr>&lt;lining&gt;",
        "d_new",
        "7 of 96",
        "0.240\u{a0}mm",
        "7.50\u{a0}s",
        "share of the group’s volume",
    ] {
        assert!(page.contains(text), "{text}");
    }
    assert!(!page.contains("Mean of the principal directions, D_b"), "it repeats D⁺");
    assert!(page.contains("D_b, the mean of the damage in the three principal directions, is not listed"));
    summary.parts.damage[0].measures["d_b_max"].largest = 0.3;
    summary.write(&folder.summary()).unwrap();
    assert!(self::page(&folder).contains("Mean of the principal directions, D_b"));
    let chinese = write_in(folder.root(), Language::Chinese).unwrap();
    assert!(fs::read_to_string(chinese).unwrap().contains("三个主方向平均，D_b"));
}

#[test]
fn a_sound_run_and_a_cracked_lining_have_banners_of_their_own() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    assert!(page(&folder).contains("No structure is judged"));
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.conclusion.outcome = "The run reached its end.".into();
    for (severity, class) in
        [(Severity::Undamaged, "good"), (Severity::Damaged, "warn"), (Severity::Through, "bad")]
    {
        let headline = "cracked <i>".to_owned();
        summary.conclusion.findings =
            vec![Finding { group: "hall.lining".into(), severity, headline, ..Finding::default() }];
        summary.write(&folder.summary()).unwrap();
        let page = page(&folder);
        assert!(
            page.contains("class=\"outcome good\"><p class")
                || page.contains("class=\"outcome good\">\n<p class")
        );
        assert!(page.contains("Run: all 1 checks pass") && page.contains("The run reached its end."));
        assert!(page.contains(&format!("class=\"outcome {class}\"")) && page.contains("cracked &lt;i&gt;"));
        assert!(!page.contains("The lining stays elastic."), "the verdict as a whole would say all twice");
    }
}

#[test]
fn a_line_that_cannot_be_judged_counts_neither_way() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.soundness.checks.push(TrustLine::not_applicable(
        "free_field",
        said!("free field"),
        said!("the rock yields"),
    ));
    summary.write(&folder.summary()).unwrap();
    let page = page(&folder);
    for text in
        ["1 of 1 checks of the run pass", "not applicable", "the rock yields", "<span class=\"pill\">–"]
    {
        assert!(page.contains(text), "{text}");
    }
}

#[test]
fn damage_over_time_is_drawn_group_by_group() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    let text = "time [s],a.lining.d_tension [m3/m3],a.lining.crack_opening [m],b.lining.d_tension [m3/m3],\
                b.lining.d_shear [m3/m3]\n0,0,0,0,0\n1,0.1,1e-4,0.2,0\n2,0.3,2e-4,0.2,0\n";
    fs::write(folder.damage(), text).unwrap();
    let page = page(&folder);
    for text in [
        "Damage over time",
        "Cracked, D⁺ (% of volume)",
        "widest crack (mm)",
        "highest: a.lining, 30.0\u{a0}% of volume",
    ] {
        assert!(page.contains(text), "{text}");
    }
    assert!(!page.contains("Crushed or sheared"), "zero throughout");
    assert!(drawings(&folder).contains(&"damage.svg".into()));
    fs::write(folder.damage(), "time [s],a.d_tension\n0,0\n1,0\n").unwrap();
    assert!(self::page(&folder).contains("Nothing was damaged."));
}

#[test]
fn materials_are_tabled_with_what_is_made_of_them_and_what_their_laws_derive() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    let mut summary = Summary::read(&folder.summary()).unwrap();
    let value = |name: &str, [value, most]: [f64; 2], unit: &str, origin| MaterialValue {
        name: name.into(),
        value,
        most,
        unit: unit.into(),
        meaning: format!("meaning of {name}"),
        origin,
        ..MaterialValue::default()
    };
    let word = MaterialValue { name: "rate".into(), word: "ceb".into(), ..MaterialValue::default() };
    let facts = MaterialFacts {
        law: "concrete-damage".into(),
        density: 2752.3,
        wave_speed_p: 3125.0,
        wave_speed_s: 1970.0,
        damping: "3 % over 0.5 to 20 Hz".into(),
        groups: vec![MaterialGroup {
            names: "hall.lining".into(),
            body: "hall.lining".into(),
            elements: 1234,
            element: "full".into(),
        }],
        values: vec![
            value("young", [25e9; 2], "Pa", Origin::Given),
            value("friction_angle", [46f64.to_radians(); 2], "rad", Origin::Given),
            word,
            value("rate_filter_time", [5e-3; 2], "s", Origin::Default),
            value("ultimate_strain", [4.8e-4, 9e-4], "", Origin::Derived),
        ],
        ..MaterialFacts::default()
    };
    summary.computed.materials.insert("concrete".into(), facts);
    summary.write(&folder.summary()).unwrap();
    let page = page(&folder);
    for text in [
        "concrete: <code>concrete-damage</code>",
        "hall.<wbr>lining",
        "1\u{202f}234 elements, full",
        "2752\u{a0}kg",
        "25\u{a0}GPa",
        ">46°<",
        ">ceb<",
        "5\u{a0}ms",
        "default</span>",
        "4.8\u{202f}×\u{202f}10⁻⁴ to 9\u{202f}×\u{202f}10⁻⁴",
        "meaning of young",
        "What the law makes of them",
    ] {
        assert!(page.contains(text), "{text}");
    }
}

/// That no table or figure is wider than a phone is seen in a browser; here, that each is provided for.
#[test]
fn on_a_narrow_screen_every_table_scrolls_in_itself_or_wraps() {
    let (template, style) =
        (include_str!("../../template/report.html"), include_str!("../../template/report.css"));
    let (_, narrow) = style.split_once("@media screen and (max-width: 700px) {").unwrap();
    let narrow = narrow.split_once("@media").unwrap().0;
    assert!(narrow.contains("figure { overflow-x: auto; }"));
    assert!(
        narrow.contains(".spectrum:has(.slim) > svg { display: none; }")
            && narrow.contains(".slim { display: block; }")
    );
    let mut classes: Vec<&str> = template.split("<table class=\"").skip(1).collect();
    classes.iter_mut().for_each(|rest| *rest = rest.split_once('"').unwrap().0);
    assert!(classes.len() >= 5 && classes.len() == template.matches("<table").count());
    for class in classes {
        let rules = narrow.lines().filter(|rule| rule.contains(&format!(".{class}")));
        let held = |rule: &str| rule.contains("overflow-x: auto") || rule.contains("overflow-wrap: anywhere");
        // In a box that scrolls, at every width.
        let boxed = template.contains(&format!("<div class=\"wide\">\n<table class=\"{class}\">"));
        assert!(
            boxed && style.contains(".wide { overflow-x: auto; }") || rules.into_iter().any(held),
            ".{class} may overflow"
        );
    }
}

#[test]
fn the_motion_that_comes_in_is_drawn_by_axis_with_what_the_base_makes_of_it() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    assert!(!page(&folder).contains("The motion that comes in"));
    let mut columns = vec![Column::new("time", "s")];
    for (kind, unit) in [("a", "m/s2"), ("v", "m/s"), ("u", "m")] {
        columns.extend(["x", "y", "z"].map(|axis| Column::new(format!("given.{kind}{axis}"), unit)));
    }
    let mut table = TableWriter::create(&folder.motion(), &columns).unwrap();
    for k in 0..200 {
        let t = 0.01 * f64::from(k);
        let x = (6.0 * t).sin();
        table.write(&[t, 1.25 * x, 0.0, -x, 0.2 * x, 0.0, -0.1 * x, 0.03 * x, 0.0, 0.01 * x]).unwrap();
    }
    let mut summary = Summary::read(&folder.summary()).unwrap();
    (summary.computed.motion.kind, summary.computed.motion.factor) = ("outcrop".into(), 0.5);
    summary.write(&folder.summary()).unwrap();
    let page = page(&folder);
    assert!(page.contains("The motion that comes in") && page.contains("is 0.500 times this"), "{page}");
    assert!(page.contains("motion.csv") && drawings(&folder).contains(&"input.svg".to_owned()));
    // What does not move is not drawn.
    let drawing = fs::read_to_string(folder.figures().join("input.svg")).unwrap();
    assert!(drawing.contains(">x</text>") && drawing.contains(">z</text>") && !drawing.contains(">y</text>"));
}
