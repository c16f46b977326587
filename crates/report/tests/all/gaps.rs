//! What results lack or have too much of is said on the page: numbers that are none, an error with a part of the scheme.

use std::fs;

use tremolite_report::{Language, write, write_in};
use tremolite_results::{ResultFolder, Summary};

use crate::report::results;

fn page(folder: &ResultFolder) -> String {
    fs::read_to_string(write(folder.root()).unwrap()).unwrap()
}

#[test]
fn a_monitor_without_a_number_is_named_with_its_first_time_and_what_does_not_stand_is_not() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    let told = |content: &str| {
        fs::write(folder.monitors(), content).unwrap();
        let chinese = write_in(folder.root(), Language::Chinese).unwrap();
        let chinese = fs::read_to_string(chinese).unwrap().contains("monitors.csv 中有非数值");
        let page = page(&folder);
        let english = page.split("monitors.csv has values that are no number, first at ").nth(1);
        let english = english.map(|rest| rest.split(':').next().unwrap().replace('\u{a0}', " "));
        assert_eq!(chinese, english.is_some());
        english
    };
    let text = "time [s],A.ux [m],B.ux [m],B.uy [m]\n0,0,0,0\n1,1,1,NaN\n2,NaN,1,1\n";
    assert_eq!(told(text).as_deref(), Some("1.000 s (B.uy)"));
    assert_eq!(told(&text.replace("NaN", "inf")).as_deref(), Some("1.000 s (B.uy)"));
    assert_eq!(told(&text.replace("NaN", "1")), None);
    for by_design in [
        "time [s],A.ux [m],B.ux [m]\n0,0,NaN\n1,1,NaN\n",
        "time [s],A.ux [m],J.gap [m],J.pressure [Pa],J.shear1 [Pa]\n0,0,0,NaN,NaN\n1,1,NaN,1,1\n",
        "time [s],A.ux [m],R.force [N],R.force_over_yield [1]\n0,0,NaN,NaN\n1,1,1,1\n",
    ] {
        assert_eq!(told(by_design), None, "{by_design}");
    }
}

#[test]
fn without_a_check_the_card_of_the_energy_error_says_what_it_holds() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path(), &["A"]);
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.soundness.checks[0].numbers.insert("error".into(), 250.0);
    summary.write(&folder.summary()).unwrap();
    assert!(!page(&folder).contains("from energy.csv, with ⅛Δt²aᵀMa"));
    fs::remove_file(folder.summary()).unwrap();
    assert!(page(&folder).contains("of the largest energy held; from energy.csv, with ⅛Δt²aᵀMa"));
    let chinese = write_in(folder.root(), Language::Chinese).unwrap();
    assert!(fs::read_to_string(chinese).unwrap().contains("取自 energy.csv，含属于积分格式的 ⅛Δt²aᵀMa"));
}
