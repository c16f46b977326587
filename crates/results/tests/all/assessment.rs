//! State and reliance of summaries, by the table of items.

use std::collections::BTreeSet;

use tremolite_results::assessment::items::{FAR, RELIANCE, STATE, table};
use tremolite_results::{
    FailureModes, Finding, JudgedBy, LiningExtent, Reliance, SectionStrength, Severity, State, Status,
    Summary, TrustLine, Used, assess, said,
};

/// A run that is done, with an elastic lining that its section judges, and a check that passes.
fn sound() -> Summary {
    let mut summary = Summary::default();
    summary.conclusion.status = Status::Done;
    summary.computed.model.steps = 100;
    summary.computed.linings.insert("lining".into(), LiningExtent::default());
    let used = |value: f64| Some(Used { value, ..Used::default() });
    let section =
        SectionStrength { stations: 8, bending: used(0.5), shear: used(0.4), ..SectionStrength::default() };
    summary.parts.sections.insert("lining".into(), section);
    let modes = FailureModes {
        law: "elastic".into(),
        thrust_moment: JudgedBy::Section,
        shear: JudgedBy::Section,
        stations: 8,
    };
    summary.parts.failure_modes.insert("lining".into(), modes);
    summary.soundness.checks.push(TrustLine::at_most("energy_error", said!("energy error"), 1e-5, 5e-4, ""));
    summary
}

fn finding(id: &str, severity: Severity, numbers: &[(&str, f64)]) -> Finding {
    let numbers = numbers.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect();
    Finding { id: id.into(), group: "lining".into(), severity, numbers, ..Finding::default() }
}

fn check(id: &str, value: f64, limit: f64) -> TrustLine {
    TrustLine::at_most(id, said!("a check"), value, limit, "")
}

/// A change of a sound summary.
type Change = fn(&mut Summary);

/// Each item of the state with a change that it alone is for.
const STATES: [(&str, Change); 14] = [
    ("section_beyond_strength", |s| s.parts.sections["lining"].shear.as_mut().unwrap().value = 2.06),
    ("limit_not_met", |s| _ = s.case.report.limits.insert("utilisation".into(), 0.45)),
    ("loose_pieces", |s| {
        s.conclusion.findings.push(finding("damage_lining", Severity::Undamaged, &[("crack_opening", 0.03)]))
    }),
    ("steel_broken", |s| {
        s.conclusion.findings.push(finding("bolts_a", Severity::Through, &[("broken", 1.0)]))
    }),
    ("cracked_through", |s| s.conclusion.findings.push(finding("damage_lining", Severity::Through, &[]))),
    ("cracked", |s| {
        s.conclusion.findings.push(finding("damage_lining", Severity::Damaged, &[("share_cracked", 0.1)]))
    }),
    ("tension_beyond_strength", |s| {
        s.conclusion.findings.push(finding("tension_lining", Severity::Damaged, &[]))
    }),
    ("steel_yielded", |s| {
        s.conclusion.findings.push(finding("bolts_a", Severity::Damaged, &[("yielded", 2.0)]))
    }),
    ("run_failed", |s| s.conclusion.status = Status::Failed),
    ("not_complete", |s| s.conclusion.status = Status::Stopped),
    ("mode_not_judged", |s| s.parts.failure_modes["lining"].shear = JudgedBy::Nothing),
    ("limit_not_known", |s| _ = s.case.report.limits.insert("displacement".into(), 0.1)),
    ("limit_does_not_apply", |s| {
        s.computed.materials.insert("concrete".into(), Default::default());
        s.case.report.limits.insert("damage".into(), 0.1);
    }),
    ("no_lining", |s| {
        s.parts = Default::default();
        s.computed.linings.clear();
    }),
];

/// The same of the reliance.
const RELIANCES: [(&str, Change); 6] = [
    ("run_failed", |s| s.conclusion.status = Status::Failed),
    ("run_stopped", |s| s.conclusion.status = Status::Stopped),
    ("check_far_beyond_limit", |s| s.soundness.checks.push(check("boundary_stress_change", 0.52, 0.08))),
    ("check_beyond_limit", |s| s.soundness.checks.push(check("boundary_stress_change", 0.1, 0.08))),
    ("nothing_checked", |s| s.soundness.checks.clear()),
    ("warned", |s| s.case.warnings.push("the ground is soft; see there".into())),
];

#[test]
fn each_item_alone_sets_its_class() {
    let found = assess(&sound(), None);
    assert_eq!((found.state.class, found.reliance.class), (State::Withstands, Reliance::Sound));
    assert!(found.state.reasons.is_empty() && found.reliance.reasons.is_empty());
    for (item, (id, change)) in STATE.iter().zip(STATES) {
        let mut summary = sound();
        change(&mut summary);
        let found = assess(&summary, None).state;
        let items: BTreeSet<&str> = found.reasons.iter().map(|reason| reason.item.as_str()).collect();
        assert_eq!((item.id, items), (id, [id].into()), "{:?}", found.reasons);
        assert_eq!(found.class, item.class, "{id}");
    }
    for (item, (id, change)) in RELIANCE.iter().zip(RELIANCES) {
        let mut summary = sound();
        change(&mut summary);
        let found = assess(&summary, None).reliance;
        assert_eq!(item.id, id);
        assert_eq!((found.class, found.reasons[0].item.as_str()), (item.class, id));
    }
}

/// Whatever else holds, a run that is not complete or not judged does not withstand.
#[test]
fn what_is_not_complete_or_not_judged_never_withstands() {
    for change in [STATES[9].1, STATES[10].1, STATES[11].1, STATES[12].1, STATES[13].1, |s: &mut Summary| {
        s.soundness.checks.push(check("truncated_motion", 0.4, 0.01));
    }] {
        let mut summary = sound();
        change(&mut summary);
        let found = assess(&summary, None);
        assert_eq!(found.state.class, State::NotJudged);
        assert!(found.classes().to_string().starts_with("State: not judged. "));
    }
    // A limit that is exceeded before a run is stopped stays so.
    let mut summary = sound();
    (STATES[1].1)(&mut summary);
    (STATES[9].1)(&mut summary);
    assert_eq!(assess(&summary, None).state.class, State::Fails);
    // Of a run that failed nothing else is judged.
    (STATES[8].1)(&mut summary);
    assert_eq!(assess(&summary, None).state.class, State::NotJudged);
}

#[test]
fn the_worst_class_comes_first_and_all_its_reasons_are_kept() {
    let mut summary = sound();
    for (_, change) in &STATES[..7] {
        change(&mut summary);
    }
    let found = assess(&summary, None).state;
    assert_eq!(found.class, State::Fails);
    assert!(found.reasons.windows(2).all(|pair| pair[0].class >= pair[1].class), "{:?}", found.reasons);
    assert!(found.reasons.iter().all(|reason| reason.text == reason.text_message.to_string()));
}

#[test]
fn the_documentation_prints_the_table_of_items() {
    let docs = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/report.md");
    let text = std::fs::read_to_string(docs).unwrap();
    assert!(text.contains(&table()), "docs/report.md lacks this table:\n{}", table());
    assert!(FAR.iter().all(|(id, _)| table().contains(&format!("`{id}`"))));
}

#[test]
fn files_have_the_classes_as_words() {
    let mut summary = sound();
    (STATES[0].1)(&mut summary);
    summary.conclusion.state = assess(&summary, None).state;
    summary.conclusion.reliance = assess(&summary, None).reliance;
    let json = serde_json::to_value(&summary).unwrap();
    assert_eq!((&json["state"]["class"], &json["reliance"]["class"]), (&"fails".into(), &"sound".into()));
    assert_eq!(json["state"]["reasons"][0]["item"], "section_beyond_strength");
    assert_eq!(json["failure_modes"]["lining"]["shear"], "section");
}

#[test]
fn a_share_of_nothing_in_nothing_does_not_apply() {
    let line = |part, whole| TrustLine::share_at_most("id", said!("name"), [part, whole], 0.1, said!("why"));
    assert!(line(0.0, 0.0).not_applicable && line(0.0, 0.0).note == "why");
    assert!(line(0.0, 1.0).pass && !line(0.0, 1.0).not_applicable);
    assert!(!line(1e-9, 0.0).pass && !line(f64::NAN, 0.0).pass && !line(0.2, 1.0).pass);
}
