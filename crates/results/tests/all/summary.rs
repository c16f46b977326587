//! `summary.json` has the names scripts rely on and reads back as it was.

use std::fs;

use serde_json::{Map, Value};
use tremolite_results::{
    CaseFacts, Computed, Conclusion, Cracks, Damaged, Defaulted, Error, Finding, GroupDamage, MaterialFacts,
    MaterialValue, Onset, Origin, Peaks, Place, RateFactor, Said, Severity, Soundness, Status, Summary,
    Table, TrustLine, peaks_by_monitor, said,
};

fn summary() -> Summary {
    let mut summary = Summary {
        title: "Cavern \"<b>\"".into(),
        conclusion: Conclusion {
            status: Status::Done,
            verdict: "The lining stays elastic.".into(),
            ..Conclusion::default()
        },
        computed: Computed { wall_seconds: 12.5, element_updates_per_second: 3.2e7, ..Computed::default() },
        soundness: Soundness {
            checks: vec![
                TrustLine::at_most("energy_error", said!("energy error"), 0.002, 0.01, "")
                    .with_note(said!("largest over time")),
                TrustLine::at_least(
                    "elements_per_wavelength",
                    said!("elements per shortest wavelength"),
                    7.5,
                    10.0,
                    "",
                ),
            ],
            ..Soundness::default()
        },
        case: CaseFacts {
            defaults_used: vec![Defaulted::new("dynamic.safety", "0.9")],
            ..CaseFacts::default()
        },
        ..Summary::default()
    };
    let peaks = Peaks {
        max: 0.05,
        t_max: 13.2,
        min: -0.01,
        t_min: 9.0,
        residual: 0.007,
        step_max: Some(0.06),
        step_min: None,
    };
    summary.monitors.peaks.entry("B".into()).or_default().insert("ux".into(), peaks);
    summary.monitors.peaks.entry("A".into()).or_default().insert("ux".into(), peaks);
    let tension = Damaged {
        beyond: [("0.1".to_owned(), 2.5), ("0.9".to_owned(), 1.0)].into(),
        largest: 0.95,
        first: Some(Onset { time: 4.25, element: 4711, at: [1.0, 2.0, -3.0] }),
        rate: Some(RateFactor {
            largest: 1.6,
            at: Place { element: 4712, at: [1.0, 2.0, -4.0] },
            mean: 1.3,
            first: 1.2,
        }),
    };
    let widest = Some(Onset { time: 5.0, element: 7, at: [0.0; 3] });
    let cracks = Some(Cracks {
        directions: Vec::new(),
        opening: 1e-4,
        widest,
        left: 4e-5,
        stacks: 8,
        through: 0,
        through_at: None,
    });
    let lining = GroupDamage { volume: 10.0, measures: [("d_tension".to_owned(), tension)].into(), cracks };
    let id = "damage_hall_lining".to_owned();
    let finding = Finding::new(id, "hall.lining", Severity::Damaged, said!("cracked"), Said::default());
    summary.conclusion.findings.push(finding.with("share_cracked", 0.25));
    let young = MaterialValue {
        name: "young".into(),
        value: 1e10,
        most: 1e10,
        unit: "Pa".into(),
        origin: Origin::Given,
        ..MaterialValue::default()
    };
    let word = MaterialValue { name: "rate".into(), word: "ceb".into(), ..young.clone() };
    let rock = MaterialFacts { law: "elastic".into(), values: vec![young, word], ..MaterialFacts::default() };
    summary.computed.materials.insert("rock".into(), rock);
    summary.parts.damage.insert("hall.lining".into(), lining);
    summary.soundness.energy.insert("kinetic".into(), 0.5);
    summary.soundness.energy.insert("error".into(), f64::NAN);
    summary
}

#[test]
fn the_json_is_what_the_contract_says() {
    let json = serde_json::to_value(summary()).unwrap();
    assert_eq!(json["status"], "done");
    assert_eq!(json["verdict"], "The lining stays elastic.");
    assert_eq!(json["wall_seconds"], 12.5);
    assert_eq!(json["element_updates_per_second"], 3.2e7);
    let peaks = serde_json::to_string(&summary().monitors.peaks["A"]["ux"]).unwrap();
    assert_eq!(
        peaks,
        r#"{"max":0.05,"t_max":13.2,"min":-0.01,"t_min":9.0,"residual":0.007,"step_max":0.06}"#
    );
    let line = serde_json::to_string(&summary().soundness.checks[1]).unwrap();
    assert_eq!(
        line,
        r#"{"id":"elements_per_wavelength","name":"elements per shortest wavelength","name_message":{"pattern":"elements per shortest wavelength"},"value":7.5,"limit":10.0,"bound":"at_least","pass":false,"unit":"","note":"","not_applicable":false,"numbers":{}}"#
    );
    let defaulted = serde_json::to_string(&summary().case.defaults_used).unwrap();
    assert_eq!(defaulted, r#"[{"key":"dynamic.safety","value":"0.9"}]"#);
    assert_eq!(
        serde_json::to_string(&summary().parts.damage).unwrap(),
        r#"{"hall.lining":{"volume":10.0,"measures":{"d_tension":{"beyond":{"0.1":2.5,"0.9":1.0},"largest":0.95,"first":{"time":4.25,"element":4711,"at":[1.0,2.0,-3.0]},"rate":{"largest":1.6,"at":{"element":4712,"at":[1.0,2.0,-4.0]},"mean":1.3,"first":1.2}}},"cracks":{"opening":0.0001,"widest":{"time":5.0,"element":7,"at":[0.0,0.0,0.0]},"left":0.00004,"stacks":8,"through":0,"through_at":null}}}"#
    );
    let monitors = serde_json::to_string(&summary().monitors.peaks).unwrap();
    assert!(monitors.starts_with(r#"{"B":"#), "the order of the case is kept: {monitors}");
    for (status, text) in [(Status::Failed, "\"failed\""), (Status::Stopped, "\"stopped\"")] {
        assert_eq!(serde_json::to_string(&status).unwrap(), text);
    }
}

#[test]
fn a_summary_reads_back_as_it_was_nan_included() {
    let temp = tempfile::tempdir().unwrap();
    let path = temp.path().join("summary.json");
    let written = summary();
    written.write(&path).unwrap();
    let mut read = Summary::read(&path).unwrap();
    assert!(read.soundness.energy["error"].is_nan());
    read.soundness.energy.insert("error".into(), 0.0);
    let expected = {
        let mut expected = written;
        expected.soundness.energy.insert("error".into(), 0.0);
        expected
    };
    assert_eq!(read, expected);
    assert_eq!(read.warnings(), 1);
}

/// A file with something in every field, as it was written when all fields lay in one struct.
const FILLED: &str = include_str!("../data/summary.json");

#[test]
fn a_file_with_something_in_every_field_is_written_again_byte_for_byte() {
    let temp = tempfile::tempdir().unwrap();
    let path = temp.path().join("summary.json");
    fs::write(&path, FILLED).unwrap();
    let read = Summary::read(&path).unwrap();
    read.write(&path).unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), FILLED);
    let [filled, empty] = [&read, &Summary::default()].map(|s| serde_json::to_value(s).unwrap());
    for (name, value) in filled.as_object().unwrap() {
        assert_ne!(Some(value), empty.get(name), "{name} shows nothing");
    }
}

#[test]
fn a_file_may_lack_any_field_and_the_others_are_read_as_they_were() {
    let temp = tempfile::tempdir().unwrap();
    let path = temp.path().join("summary.json");
    let filled: Map<String, Value> = serde_json::from_str(FILLED).unwrap();
    for name in filled.keys() {
        let mut lacking = filled.clone();
        lacking.remove(name);
        fs::write(&path, serde_json::to_string(&lacking).unwrap()).unwrap();
        let read = serde_json::to_value(Summary::read(&path).unwrap()).unwrap();
        for (other, value) in &lacking {
            assert_eq!(&read[other], value, "{other} without {name}");
        }
    }
}

#[test]
fn summaries_of_other_versions_are_read_and_damaged_ones_refused_with_the_line() {
    let temp = tempfile::tempdir().unwrap();
    let path = temp.path().join("summary.json");
    let other = r#"{"status": "failed", "new_field": [1, 2], "checks": [{"name": "x"}],
        "damage": {"rock": {"measures": {"d_new": {"beyond": {"0.5": null}}}}}}"#;
    fs::write(&path, other).unwrap();
    let read = Summary::read(&path).unwrap();
    assert_eq!(read.conclusion.status, Status::Failed);
    assert!(
        read.computed.wall_seconds.is_nan()
            && read.soundness.checks[0].value.is_nan()
            && !read.soundness.checks[0].pass
    );
    let found = &read.parts.damage["rock"].measures["d_new"];
    assert!(
        read.parts.damage["rock"].volume.is_nan() && found.beyond["0.5"].is_nan() && found.first.is_none()
    );
    let deep = "{\"model\": {\n\"nodes\": -1,\n\"steps\": 2},\n\"version\": \"0.1.0\"}";
    for (damaged, at) in
        [("", 1), ("{\n\"status\": \"won\"}", 2), ("{\"title\":\n\n3}", 3), ("[1", 1), (deep, 2)]
    {
        fs::write(&path, damaged).unwrap();
        match Summary::read(&path) {
            Err(Error::Format { line: Some(line), .. }) => assert_eq!(line, at, "{damaged}"),
            other => panic!("{damaged} gave {other:?}"),
        }
    }
}

#[test]
fn a_line_that_cannot_be_judged_is_no_warning_and_does_not_count() {
    let line = TrustLine::not_applicable("free_field", said!("free field"), said!("the rock yields"));
    let summary = Summary {
        soundness: Soundness {
            checks: vec![line, TrustLine::at_most("a", said!("a"), 2.0, 1.0, "")],
            ..Soundness::default()
        },
        ..Summary::default()
    };
    assert_eq!((summary.judged(), summary.warnings()), (1, 1));
}

#[test]
fn a_number_that_is_not_one_never_passes_a_trust_limit() {
    assert!(
        TrustLine::at_most("a", said!("a"), 1.0, 1.0, "").pass
            && TrustLine::at_least("a", said!("a"), 1.0, 1.0, "").pass
    );
    assert!(!TrustLine::at_most("a", said!("a"), f64::NAN, 1.0, "").pass);
    assert!(!TrustLine::at_least("a", said!("a"), f64::NAN, 1.0, "").pass);
}

#[test]
fn peaks_come_from_the_table_by_monitor_and_quantity() {
    let temp = tempfile::tempdir().unwrap();
    let path = temp.path().join("monitors.csv");
    fs::write(&path, "time [s],B.ux [m],hall.2.s1 [Pa],B.uz [m]\n0,0,5,1\n1,2,4,NaN\n2,-3,9,0.5\n").unwrap();
    let [peaks, relative] = peaks_by_monitor(&Table::read(&path).unwrap());
    assert!(relative.is_empty());
    assert_eq!(peaks.keys().collect::<Vec<_>>(), ["B", "hall.2"]);
    assert_eq!(
        peaks["B"]["ux"],
        Peaks { max: 2.0, t_max: 1.0, min: -3.0, t_min: 2.0, residual: -3.0, step_max: None, step_min: None }
    );
    assert_eq!(peaks["hall.2"]["s1"].max, 9.0);
    assert_eq!(peaks["B"]["uz"].residual, 0.5);
}
