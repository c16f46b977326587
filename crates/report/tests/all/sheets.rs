//! The two sheets: limits met or not, who signs, what sections use.

use std::fs;
use std::path::Path;

use tremolite_report::{Language, write_held, write_in};
use tremolite_results::{
    Factors, LastingCrack, MaterialFacts, MaterialValue, Origin, ResultFolder, SectionStrength, Summary,
    TargetSpectrum, Used,
};

use super::report;

/// A lining of a law that cannot crack, which uses so much in thrust and moment.
pub fn judged(value: f64) -> SectionStrength {
    let used = |value: f64, time: f64| Used {
        value,
        station: 7,
        at: [3.25, 1.5, -21.75],
        stage: String::new(),
        time,
        forces: [-1.234e6, 0.321e6, 0.456e6],
        resistance: 0.789e6,
        part: "haunch".into(),
    };
    SectionStrength {
        code: "EN 1992-1-1".into(),
        grade: "C30/37".into(),
        compression: 20e6,
        tension: 1.37e6,
        factors: Factors {
            gamma_c: 1.53,
            gamma_s: 1.16,
            alpha_cc: 0.97,
            alpha_ct: 0.93,
            gamma_d: 1.21,
            dynamic: 1.11,
        },
        stations: 64,
        reinforced: 48,
        plain_tension: true,
        yields: false,
        beyond: 3,
        bending: Some(used(value, 0.75)),
        shear: Some(used(0.432, 0.52)),
        ..SectionStrength::default()
    }
}

/// A run of monitors A and B with limits, judged sections and a motion.
pub fn results(root: &Path) -> ResultFolder {
    let folder = report::results(root, &["A", "B"]);
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.conclusion.findings.clear();
    summary.parts.sections.insert("hall.lining".into(), judged(0.876));
    let report = &mut summary.case.report;
    report.limits = [("displacement", 0.0523), ("crack_width", 3.1e-4), ("utilisation", 0.94)]
        .map(|(name, limit)| (name.to_owned(), limit))
        .into();
    report.project = "Hall of the <example>".into();
    report.signed.insert("checked".into(), "B. Name".into());
    let motion = &mut summary.computed.motion;
    motion.kind = "outcrop".into();
    motion.peak_acceleration = [("x".to_owned(), 1.37), ("z".to_owned(), 0.77)].into();
    motion.given_peak_acceleration = [("x".to_owned(), 2.74), ("z".to_owned(), 1.54)].into();
    motion.target = Some(TargetSpectrum { period: vec![0.1, 1.0], sa: vec![5.0, 2.0] });
    summary.computed.boundaries =
        [("base", "viscous-spring"), ("x", "free-field"), ("y", "roller"), ("top", "free")]
            .map(|(place, word)| (place.to_owned(), word.to_owned()))
            .into();
    summary.write(&folder.summary()).unwrap();
    folder
}

fn sheets(folder: &ResultFolder, language: Language) -> String {
    let page = fs::read_to_string(write_in(folder.root(), language).unwrap()).unwrap();
    page.split_once("<header>").unwrap().1.split_once("</header>").unwrap().0.replace('\u{a0}', " ")
}

/// The row of a limit: its class and its mark.
fn row<'a>(sheets: &'a str, name: &str) -> &'a str {
    let rows = sheets.split_once("<table class=\"limits\">").unwrap().1.split_once("</table>").unwrap().0;
    rows.split("<tr").find(|row| row.contains(name)).unwrap_or_else(|| panic!("no {name} in {rows}"))
}

#[test]
fn limits_are_met_or_not_and_what_the_results_lack_is_neither() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let found = sheets(&folder, Language::English);
    assert!(found.contains("Hall of the &lt;example&gt;") && found.contains("<td>B. Name</td>"));
    assert!(
        row(&found, "Utilisation").contains("class=\"pass\"") && row(&found, "Utilisation").contains(">met<")
    );
    assert!(row(&found, "Crack width").contains("not known"), "{found}");
    assert!(
        found.contains("State: <strong>fails</strong>. Displacement of a monitor: ")
            && found.contains("0.876")
    );
    assert!(found.contains("Crack width: not known (limit 0.31 mm)."), "{found}");
    assert!(found.contains("x 2.74 m&#x2f;s² (0.28 g); z 1.54 m&#x2f;s² (0.16 g)"), "{found}");
    assert!(found.contains("base viscous with springs; sides across x free field"));
    // Chinese has its own words, and the same numbers.
    let chinese = sheets(&folder, Language::Chinese);
    assert!(
        chinese.contains("控制标准")
            && row(&chinese, "利用率").contains(">满足<")
            && chinese.contains("0.876")
    );
}

#[test]
fn limits_of_the_command_stand_in_for_those_of_the_case_and_what_has_no_bound_meets_none() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let mut summary = Summary::read(&folder.summary()).unwrap();
    // An infinite utilisation is no number in the file.
    summary.parts.sections.insert("hall.lining".into(), judged(f64::INFINITY));
    summary.write(&folder.summary()).unwrap();
    let limits = [("utilisation".to_owned(), 5.0), ("displacement".to_owned(), 1e-9)];
    let page = fs::read_to_string(write_held(folder.root(), None, limits).unwrap()).unwrap();
    let found =
        page.split_once("<header>").unwrap().1.split_once("</header>").unwrap().0.replace('\u{a0}', " ");
    for name in ["Utilisation", "Displacement"] {
        assert!(
            row(&found, name).contains("class=\"fail\"") && row(&found, name).contains("not met"),
            "{name}"
        );
    }
    assert!(!found.contains("Crack width") && found.contains("∞"), "{found}");
    assert!(found.contains(
        "State: <strong>fails</strong>. Utilisation of hall.lining in thrust and moment: ∞ (limit 1)"
    ));
}

/// An elastic law does not know what is left of forces beyond the strength: whatever width the clause gives for the end of the run, it
/// meets no limit.
#[test]
fn a_lining_loaded_beyond_its_strength_has_no_crack_width_that_meets_a_limit() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let held = |value: f64, width: f64| {
        let mut summary = Summary::read(&folder.summary()).unwrap();
        let crack = LastingCrack { width, station: 3, ..LastingCrack::default() };
        let section = SectionStrength { crack: Some(crack), ..judged(value) };
        summary.parts.sections.insert("hall.lining".into(), section);
        summary.write(&folder.summary()).unwrap();
        row(&sheets(&folder, Language::English), "Crack width").to_owned()
    };
    assert!(held(0.876, 0.0).contains(">met<"));
    assert!(held(0.876, 4e-4).contains(">not met<"));
    let beyond = held(1.3, 0.0);
    assert!(beyond.contains(">not known<") && beyond.contains("loaded beyond its strength"), "{beyond}");
    // A width that is too large is so whatever the earthquake did.
    assert!(held(f64::INFINITY, 0.0).contains(">not known<"));
}

/// By its clause, and why where nothing is borne.
#[test]
fn shear_names_its_clause_and_why_nothing_is_borne() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    assert!(sheets(&folder, Language::English).contains("0.432 in shear (6.2.2)"));
    let mut summary = Summary::read(&folder.summary()).unwrap();
    let mut section = judged(0.876);
    let shear = section.shear.as_mut().unwrap();
    (shear.value, shear.forces[0]) = (f64::INFINITY, 2.5e6);
    summary.parts.sections.insert("hall.lining".into(), section);
    summary.write(&folder.summary()).unwrap();
    let found = sheets(&folder, Language::English);
    assert!(
        found.contains("∞ in shear (6.2.2: tension of 2500 kN&#x2f;m leaves no resistance to shear)"),
        "{found}"
    );
    assert!(found.contains("Shear utilisation of hall.lining: ∞ (limit 1)"), "{found}");
}

/// What cannot crack has no cracked share; the sheet says so instead of asking for more results.
#[test]
fn the_cracked_share_of_what_cannot_crack_does_not_apply() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.case.report.limits.insert("damage".into(), 0.1);
    summary.parts.damage.clear();
    summary.computed.materials.insert("concrete".into(), tremolite_results::MaterialFacts::default());
    summary.write(&folder.summary()).unwrap();
    let found = sheets(&folder, Language::English);
    assert!(row(&found, "Cracked share").contains(">does not apply<"), "{found}");
    summary.parts.damage.insert("hall.lining".into(), report::cracked());
    summary.write(&folder.summary()).unwrap();
    assert!(!row(&sheets(&folder, Language::English), "Cracked share").contains("does not apply"));
}

#[test]
fn without_limits_or_sections_the_sheets_say_how_to_have_them() {
    let temp = tempfile::tempdir().unwrap();
    let folder = report::results(temp.path(), &["A"]);
    let found = sheets(&folder, Language::English);
    assert!(found.contains("[report.limits]") && found.contains("[[section]]"));
    assert_eq!(found.matches("<div class=\"sheet\">").count(), 2);
}

/// A utilisation above 1 fails whatever the law; of a lining that cracks both are to be read.
#[test]
fn a_lining_that_cracks_fails_by_its_utilisation_with_a_word_on_its_law() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.parts.sections.insert("hall.lining".into(), SectionStrength { yields: true, ..judged(1.3) });
    summary.write(&folder.summary()).unwrap();
    let found = sheets(&folder, Language::English);
    assert!(found.contains("1.30 (limit 1)") && found.contains("own law cracks: read both."), "{found}");
    assert!(found.contains("cross-check"), "{found}");
}

/// Whoever signs sees by which strengths a lining is judged: factors, that of the earthquake among them, and steel.
#[test]
fn the_line_of_sections_has_the_factor_of_the_earthquake_and_the_steel() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.parts.sections.insert("hall.lining".into(), SectionStrength { steel: 4.35e8, ..judged(0.876) });
    let input = tremolite_results::Input {
        name: "case".into(),
        hash: "0123456789abcdef".into(),
        ..Default::default()
    };
    summary.case.inputs.push(input);
    summary.computed.run.started = "2026-11-26T01:54:06Z".into();
    summary.write(&folder.summary()).unwrap();
    let found = sheets(&folder, Language::English);
    assert!(found.contains("γ_d 1.21, concrete × 1.11 in the earthquake"), "{found}");
    assert!(found.contains("f_yk 435 MPa"), "{found}");
    // Which case it was.
    assert!(found.contains("Case 0123456789ab."), "{found}");
    // The limit says in which way the section uses most.
    assert!(row(&found, "Utilisation").contains("in thrust and moment, hall.lining"), "{found}");
}

/// A width that no eye sees is none that a clause computes.
#[test]
fn a_tiny_crack_is_told_by_its_bound() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let mut summary = Summary::read(&folder.summary()).unwrap();
    let crack = LastingCrack { width: 5.2e-7, station: 3, ..LastingCrack::default() };
    summary
        .parts
        .sections
        .insert("hall.lining".into(), SectionStrength { crack: Some(crack), ..judged(0.876) });
    summary.write(&folder.summary()).unwrap();
    let found = sheets(&folder, Language::English);
    assert!(row(&found, "Crack width").contains("&lt; 0.01 mm"), "{}", row(&found, "Crack width"));
}

/// Monitors on broken elements do not count, and the sheet says which.
#[test]
fn limits_name_the_monitors_that_do_not_count() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.monitors.on_broken_elements.push("B".into());
    summary.case.report.limits.insert("relative_displacement".into(), 0.02);
    summary.monitors.relative.insert("A-B".into(), Default::default());
    summary.write(&folder.summary()).unwrap();
    let found = sheets(&folder, Language::English);
    assert!(
        row(&found, "Displacement of a monitor").contains("not counted, on broken elements: B"),
        "{found}"
    );
    assert!(row(&found, "Relative displacement").contains("A-B: on broken elements"), "{found}");
}

/// Section forces of wet ground are of total stress, which changes what a lining with pores uses.
#[test]
fn wet_section_forces_are_said_to_be_of_total_stress() {
    let temp = tempfile::tempdir().unwrap();
    let folder = super::stages::example(temp.path(), true);
    let told = || sheets(&folder, Language::English).contains("Section forces are of total stress");
    assert!(!told());
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.computed.water.insert("pressure".into(), "seepage".into());
    summary.write(&folder.summary()).unwrap();
    assert!(told());
}

/// The section's C30/37 beside a lining whose law has another strength, and beside one that has that strength.
#[test]
fn a_section_of_another_concrete_than_the_models_is_told() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    for (strength, told) in [(9.9e6, true), (30e6, false)] {
        let mut summary = Summary::read(&folder.summary()).unwrap();
        let of = summary.parts.sections.get_mut("hall.lining").unwrap();
        (of.yields, of.beyond_bending, of.beyond_shear) = (true, 1, 2);
        let value = MaterialValue {
            name: "compressive_strength".into(),
            value: strength,
            most: strength,
            unit: "Pa".into(),
            origin: Origin::Derived,
            ..MaterialValue::default()
        };
        let concrete =
            MaterialFacts { law: "concrete-damage".into(), values: vec![value], ..MaterialFacts::default() };
        summary.computed.materials = [("concrete".to_owned(), concrete)].into();
        summary.write(&folder.summary()).unwrap();
        let found = sheets(&folder, Language::English);
        let words = "f_c 9.9 MPa in the model, 31.5 MPa (characteristic) to 39.5 MPa (mean) by C30&#x2f;37";
        assert_eq!(found.contains(words), told, "{strength}: {found}");
        assert!(found.contains("of 64: 1 by N and M, 2 by shear"), "{found}");
    }
}
