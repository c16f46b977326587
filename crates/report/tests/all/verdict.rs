//! What the verdict answers: by cracks, by yielding where nothing can crack, and never green where checks warn.

use std::fs;

use tremolite_report::{Language, write_in};
use tremolite_results::{
    Damaged, Finding, GroupDamage, Peaks, ResultFolder, Severity, Summary, Table, TableWriter, TrustLine,
};

use crate::report::results;

fn finding(group: &str, severity: Severity, numbers: &[(&str, f64)]) -> Finding {
    Finding {
        id: format!("damage_{}", group.replace('.', "_")),
        group: group.into(),
        severity,
        numbers: numbers.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect(),
        ..Finding::default()
    }
}

/// Class and answer of the page.
fn answer(folder: &ResultFolder, language: Language) -> (String, String) {
    let page = fs::read_to_string(write_in(folder.root(), language).unwrap()).unwrap();
    let (_, from) = page.split_once("<div class=\"verdict ").unwrap();
    let (class, inside) = from.split_once("\">").unwrap();
    let text = inside.split_once("<ul").unwrap().0.replace('\u{a0}', " ");
    (class.to_owned(), text)
}

/// Writes the findings, with so many checks passed and so many that warn.
fn set(folder: &ResultFolder, findings: Vec<Finding>, pass: bool) {
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.conclusion.findings = findings;
    summary.soundness.trust[0].pass = pass;
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
    summary.write(&folder.summary()).unwrap();
    folder
}

#[test]
fn a_lining_that_cannot_crack_is_answered_by_its_yielding() {
    let temp = tempfile::tempdir().unwrap();
    let folder = lined(temp.path());
    let shares = [("share_yielded_in_shear", 0.64), ("share_yielded_in_tension", 0.0)];
    let rock = finding("rock", Severity::Damaged, &[("share_yielded_in_shear", 0.9)]);
    let lining = finding("adit.shotcrete", Severity::Damaged, &shares);
    set(&folder, vec![rock.clone(), lining.clone()], true);
    let (class, text) = answer(&folder, Language::English);
    assert_eq!(class, "warn");
    assert!(
        text.contains("Not judged by cracks. adit.shotcrete: yielded in shear in 64.0 % of its volume."),
        "{text}"
    );
    let (_, chinese) = answer(&folder, Language::Chinese);
    assert!(chinese.contains("未按裂缝判断。adit.shotcrete：剪切屈服体积占 64.0 %。"), "{chinese}");

    // Rock is no lining, and a lining that stayed elastic has nothing to be told of.
    set(&folder, vec![rock, finding("adit.shotcrete", Severity::Undamaged, &[])], true);
    assert!(answer(&folder, Language::English).1.contains("Not judged: no structure of this run can crack."));

    // A sound lining of concrete does not hide it.
    set(&folder, vec![finding("hall.lining", Severity::Undamaged, &[]), lining], true);
    let (class, text) = answer(&folder, Language::English);
    assert!(
        class == "warn" && text.contains("has not cracked, but it has yielded. adit.shotcrete"),
        "{text}"
    );
    assert!(answer(&folder, Language::Chinese).1.contains("未开裂，但已屈服。adit.shotcrete"));
}

#[test]
fn no_answer_is_green_where_checks_warn() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    let cracked = || finding("hall.lining", Severity::Damaged, &[("share_cracked", 0.1)]);
    let sound = || finding("hall.lining", Severity::Undamaged, &[]);
    let through =
        || finding("hall.lining", Severity::Through, &[("share_cracked", 0.1), ("crack_opening", 0.019)]);
    // The pieces may be another lining's than the one that is cracked most.
    let loose =
        || finding("adit.lining", Severity::Through, &[("share_cracked", 0.05), ("crack_opening", 0.021)]);
    for (findings, pass, class, english, chinese) in [
        (vec![sound()], true, "good", "It is undamaged.", "未损伤。"),
        (vec![sound()], false, "warn", "some checks warn", "部分检查未通过"),
        (vec![cracked()], true, "warn", "no crack runs through its thickness", "没有一处贯穿厚度"),
        (vec![cracked()], false, "warn", "no crack runs through its thickness", "没有一处贯穿厚度"),
        (vec![through()], false, "bad", "cracks run through its thickness.", "裂缝贯穿衬砌厚度。"),
        (
            vec![through(), loose()],
            false,
            "bad",
            "and pieces have come loose. This model cannot say",
            "并有块体脱离。",
        ),
        (vec![], false, "warn", "Not judged", "未作判断"),
    ] {
        set(&folder, findings, pass);
        for (language, wanted) in [(Language::English, english), (Language::Chinese, chinese)] {
            let (found, text) = answer(&folder, language);
            assert!(found == class && text.contains(wanted), "{class} {wanted}: {found} {text}");
        }
    }
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
fn up_to_three_checks_that_warn_are_named() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    for (warn, wanted) in [
        (1, "0 of 1 checks pass. Read the one that warns first: check 1."),
        (3, "0 of 3 checks pass. Read those that warn first: check 1; check 2; check 3."),
        (5, "0 of 5 checks pass. Read those that warn first: check 1; check 2; check 3, and 2 more."),
    ] {
        let mut summary = Summary::read(&folder.summary()).unwrap();
        let line =
            |k| TrustLine { name: format!("check {k}"), pass: false, ..summary.soundness.trust[0].clone() };
        summary.soundness.trust =
            (1..=warn).map(|k| TrustLine { name_said: Default::default(), ..line(k) }).collect();
        summary.write(&folder.summary()).unwrap();
        let page = fs::read_to_string(write_in(folder.root(), Language::English).unwrap()).unwrap();
        assert!(page.contains(wanted), "{wanted}");
    }
}
