//! What a run says of itself reaches a Chinese page in Chinese.

use crate::chinese::lacking;
use crate::stage_case::{JOINT, LATERAL, SHAKING, STAGES, case, change, errors, run};
use std::fs;
use tremolite_report::{Language, write_in};
use tremolite_results::{ResultFolder, Said, Summary};

/// Bolts into the rock beside the opening, placed with its shell.
const BOLTS: &str = r#"install = ["shell"]
[[stage.bolts]]
name = "wall"
points = [[["12.1 m", "1 m", "8.5 m"], ["15 m", "1 m", "8.5 m"]], [["12.1 m", "3 m", "8.5 m"], ["15 m", "3 m", "8.5 m"]]]
diameter = "25 mm"
yield = "400 MPa"
bond = { stiffness = "10 GPa", strength = "300 kN/m", friction_angle = "0 deg" }
"#;

pub const CONCRETE: &str = r#"law = "concrete-damage"
friction_angle = "46 deg"
cohesion = "2 MPa"
tensile_strength = "0.02 MPa"
ultimate_strain_ratio = 10.0
residual_tension = 0.1
residual_shear = 0.2
evolution = "residual"
split = "effective"
young = "20 GPa""#;

#[test]
fn all_that_a_run_with_stages_an_interface_bolts_and_damage_says_has_chinese() {
    let temp = tempfile::tempdir().unwrap();
    let folder = temp.path();
    case(folder, LATERAL, &format!("{STAGES}{JOINT}"), SHAKING);
    change(folder, "install = [\"shell\"]\n", BOLTS);
    change(folder, "law = \"elastic\"\nyoung = \"20 GPa\"", CONCRETE);
    let output = run(folder, "out", &[]);
    assert!(output.status.success(), "{}", errors(&output));
    let results = ResultFolder::open_existing(&folder.join("out")).unwrap();
    let summary = Summary::read(&results.summary()).unwrap();

    // Laws speak English alone when they warn; this case gives them no reason.
    let mut told: Vec<(&str, &Said, &String)> = vec![
        ("outcome", &summary.conclusion.outcome_message, &summary.conclusion.outcome),
        ("step", &summary.computed.model.step_set_by_message, &summary.computed.model.step_set_by),
    ];
    let lines = summary.soundness.checks.iter();
    told.extend(lines.flat_map(|l| [(&*l.id, &l.name_message, &l.name), (&*l.id, &l.note_message, &l.note)]));
    let facts = summary.case.facts.iter();
    told.extend(facts.flat_map(|f| [(&*f.id, &f.name_message, &f.name), (&*f.id, &f.note_message, &f.note)]));
    let findings = summary.conclusion.findings.iter();
    told.extend(
        findings
            .flat_map(|f| [(&*f.id, &f.headline_message, &f.headline), (&*f.id, &f.text_message, &f.text)]),
    );
    for stage in &summary.computed.stages {
        told.extend(
            stage.changed_message.iter().zip(&stage.changed).map(|(said, text)| (&*stage.name, said, text)),
        );
    }
    told.extend(
        summary.computed.materials.iter().map(|(name, m)| (name.as_str(), &m.damping_message, &m.damping)),
    );
    for id in
        ["damage_shell", "interface_joint", "bolts_", "bolt_slip", "unreleased_force", "hourglass_energy"]
    {
        assert!(told.iter().any(|(found, ..)| found.starts_with(id)), "nothing is said of {id}");
    }
    let mut missing = Vec::new();
    for (id, said, english) in told {
        assert_eq!(&said.to_string(), english, "{id}");
        if !Language::Chinese.knows(said) {
            missing.push(format!("{id}: no Chinese for \"{english}\""));
        }
    }
    lacking(&missing);

    // And so it stands on the page: nothing but what was said before the run is marked as English.
    let page = fs::read_to_string(write_in(results.root(), Language::Chinese).unwrap()).unwrap();
    let english: Vec<&str> = page.split("<span lang=\"en\">").skip(1).collect();
    assert!(english.len() == summary.case.warnings.len() || !missing.is_empty(), "{english:#?}");
    assert!(page.contains("能量误差与最大持有能量之比"));
}
