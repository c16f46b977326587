//! What the verdict answers: by cracks, by yielding where nothing can crack, and never green where checks warn.

use std::fs;

use tremolite_report::{Language, write_in};
use tremolite_results::{Damaged, Finding, GroupDamage, ResultFolder, Severity, Summary};

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
    let through = || finding("hall.lining", Severity::Through, &[("share_cracked", 0.1)]);
    for (findings, pass, class, english, chinese) in [
        (vec![sound()], true, "good", "It is undamaged.", "未损伤。"),
        (vec![sound()], false, "warn", "the checks do not vouch for that", "自检不能为此作保"),
        (vec![cracked()], true, "warn", "nowhere through its thickness", "没有一处贯穿厚度"),
        (vec![cracked()], false, "warn", "nowhere through its thickness", "没有一处贯穿厚度"),
        (vec![through()], false, "bad", "cracks run through its thickness", "裂缝贯穿衬砌厚度"),
        (vec![], false, "warn", "Not judged", "未作判断"),
    ] {
        set(&folder, findings, pass);
        for (language, wanted) in [(Language::English, english), (Language::Chinese, chinese)] {
            let (found, text) = answer(&folder, language);
            assert!(found == class && text.contains(wanted), "{class} {wanted}: {found} {text}");
        }
    }
}
