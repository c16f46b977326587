//! State and reliance on the page, the worst of what sets them, in both languages.

use std::fs;

use tremolite_report::{Language, write_in};
use tremolite_results::{
    Damaged, FailureModes, Finding, GroupDamage, JudgedBy, LiningExtent, Peaks, ResultFolder,
    SectionStrength, Severity, Summary, Table, TableWriter, TrustLine, said,
};

use crate::report::results;
use crate::sheets;

fn finding(group: &str, severity: Severity, numbers: &[(&str, f64)]) -> Finding {
    Finding {
        id: format!("damage_{}", group.replace('.', "_")),
        group: group.into(),
        severity,
        numbers: numbers.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect(),
        ..Finding::default()
    }
}

/// Colour and text of state and of reliance.
fn judged(folder: &ResultFolder, language: Language) -> [(String, String); 2] {
    let page = fs::read_to_string(write_in(folder.root(), language).unwrap()).unwrap();
    let lines = page.split("<p class=\"judged ").skip(1).map(|line| {
        let (class, text) = line.split_once("</p>").unwrap().0.split_once("\">").unwrap();
        let text = text.replace("<strong>", "").replace("</strong>", "").replace('\u{a0}', " ");
        (class.to_owned(), text.replace("&#x27;", "'").replace("&#x2f;", "/"))
    });
    lines.collect::<Vec<_>>().try_into().unwrap()
}

/// Writes the findings, with so many checks passed and so many that warn.
fn set(folder: &ResultFolder, findings: Vec<Finding>, pass: bool) {
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.conclusion.findings = findings;
    summary.soundness.checks[0].pass = pass;
    summary.write(&folder.summary()).unwrap();
}

/// A folder with section forces of `adit.shotcrete`, whose law only yields.
fn lined(root: &std::path::Path) -> ResultFolder {
    let folder = results(root, &["A"]);
    fs::write(
        folder.sections(),
        "lining,station,x [m],y [m],z [m],when,time [s],N [N/m],M [N],Q [N/m],time_M [s],time_Q [s]\n\
         adit.shotcrete,1,0,0,0,min,1,-1,0,0,1,1\nadit.shotcrete,1,0,0,0,max,1,1,0,0,1,1\n",
    )
    .unwrap();
    let mut summary = Summary::read(&folder.summary()).unwrap();
    let measures = [("plastic_shear_strain".to_owned(), Damaged::default())].into();
    let group = GroupDamage { volume: 1.0, measures, ..GroupDamage::default() };
    summary.parts.damage = [("adit.shotcrete".to_owned(), group.clone()), ("rock".to_owned(), group)].into();
    summary.computed.linings.insert("adit.shotcrete".into(), LiningExtent::default());
    summary.write(&folder.summary()).unwrap();
    folder
}

#[test]
fn a_lining_that_yields_is_damaged_and_rock_that_yields_is_none() {
    let temp = tempfile::tempdir().unwrap();
    let folder = lined(temp.path());
    let shares = [("share_yielded_in_shear", 0.64), ("share_yielded_in_tension", 0.0)];
    let rock = finding("rock", Severity::Damaged, &[("share_yielded_in_shear", 0.9)]);
    let lining = finding("adit.shotcrete", Severity::Damaged, &shares);
    set(&folder, vec![rock.clone(), lining.clone()], true);
    let [(class, text), _] = judged(&folder, Language::English);
    assert_eq!(
        (class.as_str(), text.as_str()),
        ("warn", "State: damaged. adit.shotcrete: yielded in shear.")
    );
    let [(_, chinese), _] = judged(&folder, Language::Chinese);
    assert!(chinese.contains("状态：已受损") && chinese.contains("adit.shotcrete：剪切屈服。"), "{chinese}");

    set(&folder, vec![rock, finding("adit.shotcrete", Severity::Undamaged, &[])], true);
    assert_eq!(judged(&folder, Language::English)[0].0, "good");

    // A sound lining of concrete does not hide it.
    set(&folder, vec![finding("hall.lining", Severity::Undamaged, &[]), lining], true);
    let [(class, text), _] = judged(&folder, Language::English);
    assert!(class == "warn" && text.contains("damaged. adit.shotcrete: yielded"), "{text}");
}

#[test]
fn state_and_reliance_have_a_colour_each() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    let cracked = || finding("hall.lining", Severity::Damaged, &[("share_cracked", 0.1)]);
    let sound = || finding("hall.lining", Severity::Undamaged, &[]);
    let through =
        || finding("hall.lining", Severity::Through, &[("share_cracked", 0.1), ("crack_opening", 0.019)]);
    // The pieces may be another lining's than the one that is cracked most.
    let loose =
        || finding("adit.lining", Severity::Through, &[("share_cracked", 0.05), ("crack_opening", 0.021)]);
    for (findings, class, english, chinese) in [
        (vec![sound()], "good", "withstands. No damage is computed.", "未计算出损伤。"),
        (vec![cracked()], "warn", "damaged. hall.lining: cracked.", "hall.lining：开裂。"),
        (
            vec![through()],
            "warn",
            "damaged. hall.lining: cracks run through its thickness.",
            "裂缝贯穿厚度。",
        ),
        (vec![through(), loose()], "bad", "fails. Pieces of adit.lining have come loose", "块体脱离"),
        (vec![], "warn", "not judged. The run has no lining", "没有衬砌"),
    ] {
        for (pass, colour, word, zh) in
            [(true, "good", "sound", "可靠"), (false, "warn", "with reservations", "有保留")]
        {
            set(&folder, findings.clone(), pass);
            for (language, state, reliance) in
                [(Language::English, english, word), (Language::Chinese, chinese, zh)]
            {
                let [(found, text), (relied, why)] = judged(&folder, language);
                assert!(found == class && text.contains(state), "{class} {state}: {found} {text}");
                assert!(relied == colour && why.contains(reliance), "{colour} {reliance}: {relied} {why}");
            }
        }
    }
}

/// A shear utilisation of 2.06 beside a lining whose law computes no damage.
#[test]
fn shear_beyond_strength_fails_where_no_damage_is_computed() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    set(&folder, vec![finding("hall.lining", Severity::Undamaged, &[])], true);
    let mut summary = Summary::read(&folder.summary()).unwrap();
    let mut section = SectionStrength { yields: true, ..sheets::judged(0.4) };
    section.shear.as_mut().unwrap().value = 2.06;
    summary.parts.sections.insert("hall.lining".into(), section);
    let modes = FailureModes {
        law: "concrete-damage".into(),
        thrust_moment: JudgedBy::Law,
        shear: JudgedBy::Section,
        stations: 64,
    };
    summary.parts.failure_modes.insert("hall.lining".into(), modes);
    summary.write(&folder.summary()).unwrap();
    let [(class, text), _] = judged(&folder, Language::English);
    assert_eq!(class, "bad");
    assert_eq!(
        text,
        "State: fails. Shear utilisation of hall.lining: 2.06 (limit 1) at (3.2, 1.5, −21.8) m. This model does not \
         compute shear failure of a section."
    );
    // Without the section nothing judges shear.
    summary.parts.sections.clear();
    summary.parts.failure_modes["hall.lining"].shear = JudgedBy::Nothing;
    summary.write(&folder.summary()).unwrap();
    let [(class, text), _] = judged(&folder, Language::English);
    assert!(class == "warn" && text.contains("not judged. Shear of hall.lining: this model"), "{text}");
}

/// Limits are met up to the end of a run that lacks 40 % of the shaking.
#[test]
fn limits_of_a_run_that_is_cut_short_are_not_met_yet() {
    let temp = tempfile::tempdir().unwrap();
    let folder = sheets::results(temp.path());
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.case.report.limits = [("utilisation".to_owned(), 1.0)].into();
    let line = TrustLine::at_most(
        "truncated_motion",
        said!("share of the motion after the end of the run"),
        0.4,
        0.01,
        "",
    );
    summary.soundness.checks = vec![line];
    summary.case.warnings = vec!["xmin is 3.5 m from an opening; use at least 23 m".into()];
    summary.write(&folder.summary()).unwrap();
    let [(class, text), (relied, why)] = judged(&folder, Language::English);
    assert_eq!(
        (class.as_str(), text.as_str()),
        ("warn", "State: not judged. Shaking not run: 40.0 % (limit 1 %).")
    );
    assert!(relied == "bad" && why.contains("not to be used. 0 of 1 checks"), "{why}");
    assert!(why.contains("Warning of the case: xmin is 3.5 m from an opening."), "{why}");
    let page = fs::read_to_string(write_in(folder.root(), Language::English).unwrap()).unwrap();
    assert!(page.contains(">met so far<") && !page.contains("limits of acceptance are met"));
}

/// Three monitors, of which C moves fifty times as far as it did and the others hardly along z, with the pairs A-B and A-C;
/// `loose` came loose.
fn with_a_stray(root: &std::path::Path, loose: &[&str]) -> ResultFolder {
    let folder = results(root, &["A", "B", "C"]);
    let mut table = Table::read(&folder.monitors()).unwrap();
    for (name, factor) in [("C.ux", 50.0), ("C.uz", 50.0), ("A.uz", 0.001), ("B.uz", 0.001)] {
        let column = table.columns.iter().position(|c| c.name == name).unwrap();
        table.values[column].iter_mut().for_each(|u| *u *= factor);
    }
    let mut writer = TableWriter::create(&folder.monitors(), &table.columns).unwrap();
    for row in 0..table.values[0].len() {
        writer.write(&table.values.iter().map(|column| column[row]).collect::<Vec<_>>()).unwrap();
    }
    let mut summary = Summary::read(&folder.summary()).unwrap();
    let moved = |most: f64| Peaks {
        max: most,
        t_max: 1.0,
        min: 0.0,
        t_min: 0.0,
        residual: 0.0,
        step_max: None,
        step_min: None,
    };
    let pair = |name: &str, most: f64| {
        (name.to_owned(), [("u", most), ("ux", most)].map(|(q, m)| (q.to_owned(), moved(m))).into())
    };
    summary.monitors.relative = [pair("A-B", 0.005), pair("A-C", 2.5)].into();
    summary.monitors.on_broken_elements = loose.iter().map(|&name| name.to_owned()).collect();
    summary.write(&folder.summary()).unwrap();
    folder
}

#[test]
fn a_loose_piece_is_no_strain_of_the_lining() {
    let read = |folder: &ResultFolder| {
        let page = fs::read_to_string(write_in(folder.root(), Language::English).unwrap())
            .unwrap()
            .replace('\u{a0}', " ");
        let of = |name: &str| fs::read_to_string(folder.figures().join(name)).unwrap();
        let displacement = of("displacement.svg");
        (page, of("relative.svg"), of("displacement-less-mean.svg"), displacement)
    };
    // Nothing came loose: the pair that moved most is told and drawn.
    let temp = tempfile::tempdir().unwrap();
    let (page, relative, less_mean, displacement) = read(&with_a_stray(temp.path(), &[]));
    assert!(page.contains("Monitors A-C moved by up to 2500 mm"), "the most of all");
    assert!(relative.contains(">A-C</text>") && relative.contains(">A-B</text>"));
    assert!(!page.contains("broken element"));
    assert!(displacement.contains("z, up") && displacement.contains(">C</text>"), "C moves along z as well");
    assert!(page.contains("C at 1.000 s, its components together in one row of monitors.csv<"), "the card");

    let temp = tempfile::tempdir().unwrap();
    let (page, relative, held, displacement) = read(&with_a_stray(temp.path(), &["C"]));
    assert!(page.contains("Monitors A-B moved by up to 5.00 mm"), "of those that are held");
    assert!(page.contains("Not counted: A-C, of which a monitor is on a broken element."));
    assert!(page.contains("A-B at 1.000 s, its length; not counted, on broken elements: A-C"), "the card");
    assert!(!relative.contains(">A-C</text>") && relative.contains(">A-B</text>"));
    assert!(page.contains("Not drawn: A-C, up to 2693 mm along an axis"), "with its size");
    assert!(!displacement.contains("z, up"), "the others hardly move so");
    assert!(page.contains("Not drawn: z, up, nowhere more than"));
    assert!(!displacement.contains(">C</text>") && displacement.contains(">B</text>"));
    assert!(page.contains("Not drawn: C, up to 2739 mm, on a broken element."));
    assert!(
        page.contains(
            "its components together in one row of monitors.csv; not counted, on broken elements: C"
        )
    );
    assert!(page.contains("Not in the mean, since they are on broken elements: C."));
    assert_ne!(less_mean, held, "A and B are less their own mean");

    // Where all are loose they are all there is.
    let temp = tempfile::tempdir().unwrap();
    let (page, relative, all, displacement) = read(&with_a_stray(temp.path(), &["A", "B", "C"]));
    assert!(!page.contains("moved by up to"), "nothing is told of the lining");
    assert!(displacement.contains("z, up") && displacement.contains(">C</text>"));
    assert!(relative.contains(">A-C</text>") && relative.contains(">A-B</text>"));
    assert_eq!(less_mean, all);
}

/// A group of so much volume (m³), so much of it beyond a threshold of a measure.
fn group(volume: f64, measure: &str, threshold: &str, beyond: f64) -> GroupDamage {
    let damaged = Damaged { beyond: [(threshold.to_owned(), beyond)].into(), ..Damaged::default() };
    GroupDamage { volume, measures: [(measure.to_owned(), damaged)].into(), ..GroupDamage::default() }
}

#[test]
fn parts_what_was_there_before_and_the_volume_of_rock_are_told() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    let share = |x| [("share_cracked", x)];
    let yielded = |x| finding("rock", Severity::Damaged, &[("share_yielded_in_shear", x)]);
    set(&folder, vec![finding("hall.lining", Severity::Damaged, &share(0.4)), yielded(0.003)], true);
    fs::write(folder.damage(), "time [s],hall.lining.d_tension [m3/m3]\n0,0.052\n1,0.4\n").unwrap();
    let of = |parts: &[(&str, f64, f64)], rock: f64| {
        let mut summary = Summary::read(&folder.summary()).unwrap();
        summary.parts.damage = [("hall.lining".to_owned(), group(10.0, "d_tension", "0.5", 4.0))].into();
        for (name, volume, beyond) in parts {
            summary.parts.damage.insert((*name).to_owned(), group(*volume, "d_tension", "0.5", *beyond));
        }
        summary.parts.damage.insert("rock".into(), group(rock, "plastic_shear_strain", "1e-6", 3000.0));
        summary.write(&folder.summary()).unwrap();
        fs::read_to_string(write_in(folder.root(), Language::English).unwrap())
            .unwrap()
            .replace('\u{a0}', " ")
    };
    let (crown, walls) = (("hall.lining.crown", 4.0, 0.4), ("hall.lining.walls", 6.0, 3.6));
    let page = of(&[crown, walls, ("hall.lining2", 1.0, 1.0)], 1e6);
    assert!(page.contains(
        "cracked in 40.0 % of its volume. By parts: walls 60.0 %, crown 10.0 %. Before the earthquake: 5.2 %."
    ));
    assert!(page.contains("rock: yielded in shear in 3000 m³, 0.3 % of its volume."));
    // One part says nothing beside the whole, and many are for the table.
    let many = ["a", "b", "c", "d"].map(|part| format!("hall.lining.{part}"));
    let many: Vec<_> = many.iter().map(|name| (name.as_str(), 1.0, 0.5)).collect();
    assert!(!of(&[crown], 1e6).contains("By parts") && !of(&many, 1e6).contains("By parts"));

    // Where much has yielded the share says enough, and nothing was cracked before.
    set(&folder, vec![finding("hall.lining", Severity::Damaged, &share(0.4)), yielded(0.03)], true);
    fs::write(folder.damage(), "time [s],hall.lining.d_tension [m3/m3]\n0,0\n1,0.4\n").unwrap();
    let page = of(&[crown, walls], 1e5);
    assert!(!page.contains("yielded in shear in 3000 m³") && !page.contains("Before the earthquake:"));
}

#[test]
fn up_to_two_reasons_of_the_reliance_are_told() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    for (warn, wanted) in [
        (1, "0 of 1 checks of the run pass. Check 'check 1': "),
        (3, "One more reason is in summary.json."),
        (4, "2 more reasons are in summary.json."),
    ] {
        let mut summary = Summary::read(&folder.summary()).unwrap();
        let line =
            |k| TrustLine { name: format!("check {k}"), pass: false, ..summary.soundness.checks[0].clone() };
        summary.soundness.checks =
            (1..=warn).map(|k| TrustLine { name_message: Default::default(), ..line(k) }).collect();
        summary.write(&folder.summary()).unwrap();
        let [_, (_, why)] = judged(&folder, Language::English);
        assert!(why.contains(wanted), "{wanted}: {why}");
        assert_eq!(why.matches("Check '").count(), warn.min(2), "{why}");
    }
}
