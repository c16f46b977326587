//! What the verdict answers: by cracks, by yielding where nothing can crack, and never green where checks warn.

use std::fs;

use tremolite_report::{Language, write_in};
use tremolite_results::{
    Damaged, Finding, GroupDamage, Peaks, ResultFolder, Severity, Summary, Table, TableWriter,
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
    summary.findings = findings;
    summary.trust[0].pass = pass;
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
    summary.damage = [("adit.shotcrete".to_owned(), group.clone()), ("rock".to_owned(), group)].into();
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
    assert!(class == "warn" && text.contains("nowhere cracked, but has yielded. adit.shotcrete"), "{text}");
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
        (vec![sound()], false, "warn", "the checks do not vouch for that", "自检不能为此作保"),
        (vec![cracked()], true, "warn", "nowhere through its thickness", "没有一处贯穿厚度"),
        (vec![cracked()], false, "warn", "nowhere through its thickness", "没有一处贯穿厚度"),
        (vec![through()], false, "bad", "cracks run through its thickness.", "裂缝贯穿衬砌厚度。"),
        (
            vec![through(), loose()],
            false,
            "bad",
            "and pieces have come loose. Whether they fall",
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

/// Three monitors, of which C moves fifty times as far as it did, the others hardly along z, with the pairs A-B and A-C; `loose` came loose.
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
    summary.relative = [pair("A-B", 0.005), pair("A-C", 2.5)].into();
    summary.monitors_on_broken_elements = loose.iter().map(|&name| name.to_owned()).collect();
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
        let along_z = of("displacement.svg").contains("z, up");
        (page, of("relative.svg"), of("displacement-less-mean.svg"), along_z)
    };
    // Nothing came loose: the pair that moved most is told and drawn.
    let temp = tempfile::tempdir().unwrap();
    let (page, relative, less_mean, along_z) = read(&with_a_stray(temp.path(), &[]));
    assert!(page.contains("Monitors A-C moved by up to 2500 mm"), "the most of all");
    assert!(relative.contains(">A-C</text>") && relative.contains(">A-B</text>"));
    assert!(!page.contains("came loose") && !page.contains("loose pieces"));
    assert!(along_z, "C moves along z as well");

    let temp = tempfile::tempdir().unwrap();
    let (page, relative, held, along_z_of_held) = read(&with_a_stray(temp.path(), &["C"]));
    assert!(page.contains("Monitors A-B moved by up to 5.00 mm"), "of those that are held");
    assert!(page.contains("Not looked at: A-C, with a monitor on a piece that came loose."));
    assert!(page.contains("A-B, x, at 1.000 s; without A-C, loose pieces"), "the card");
    assert!(!relative.contains(">A-C</text>") && relative.contains(">A-B</text>"));
    assert!(page.contains("Not drawn: A-C, up to 2693 mm along an axis"), "with its size");
    assert!(!along_z_of_held && page.contains("Not drawn: z, up, nowhere more than"), "the others hardly do");
    assert!(page.contains("Not in the mean, since they are on pieces that came loose: C."));
    assert_ne!(less_mean, held, "A and B are less their own mean");

    // Where all are loose they are all there is.
    let temp = tempfile::tempdir().unwrap();
    let (page, relative, all, along_z_of_all) = read(&with_a_stray(temp.path(), &["A", "B", "C"]));
    assert!(!page.contains("moved by up to"), "nothing is told of the lining");
    assert!(along_z_of_all);
    assert!(relative.contains(">A-C</text>") && relative.contains(">A-B</text>"));
    assert_eq!(less_mean, all);
}
