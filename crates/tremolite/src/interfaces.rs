//! What interfaces did, for people.

use crate::places::point;
use crate::plan::{PairMonitor, Plan};
use crate::units::unit;
use indexmap::IndexMap;
use tremolite_engine::Seam;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::contacts::Contacts;
use tremolite_engine::model::Model;
use tremolite_kernels::contact::PairSeen;
use tremolite_laws::{Need, Octet, Parameter, Value};
use tremolite_mesh::pairs::tangents;
use tremolite_results::{
    Finding, InterfaceSummary, MaterialValue, Origin, PairPeak, PairPlace, Said, Severity, said, snake,
};

/// Pressure \[Pa\] at which the closure of an interface is told.
pub const TOLD_AT: f64 = 1e6;

/// Every interface of a model, with what its pairs remember at the end.
pub fn interfaces(
    model: &Model,
    assembly: &Assembly,
    history: &[Octet],
) -> IndexMap<String, InterfaceSummary> {
    let of = |(seam, contacts): (&Seam, &Contacts)| {
        let totals = contacts.totals(seam, history);
        let peak = |value: fn(&PairSeen) -> f64| {
            let (mut most, mut pair) = (0.0, None);
            for k in seam.lasting() {
                let now = value(&contacts.seen(history, k));
                if now > most {
                    (most, pair) = (now, Some(k));
                }
            }
            let node = |k: usize| model.mesh.node_id(seam.pairs[k].nodes[1] as usize);
            let at = pair.map_or([0.0; 3], |k| seam.place(&model.mesh, k));
            PairPeak { value: most, node: pair.map_or(0, node), at }
        };
        let summary = InterfaceSummary {
            law: contacts.law.info().name.into(),
            values: values(seam, contacts),
            pairs: seam.lasting().count() as u64,
            ends: seam.ends.len() as u64,
            area: seam.area(),
            normal_stiffness: contacts.law.stiffness(0.0)[0],
            chosen: contacts.chosen,
            closure_at_1_mpa: contacts.law.closure(TOLD_AT),
            straight_from: contacts.law.straight_from().unwrap_or(f64::NAN),
            ever_slid: totals.ever_slid,
            ever_opened: totals.ever_opened,
            sliding: totals.sliding,
            open: totals.open,
            max_gap: peak(|seen| seen.largest_gap),
            max_slip: peak(|seen| seen.largest_slip),
            max_pressure: totals.largest_pressure,
            impact_gain: totals.impact_gain,
        };
        (seam.name.clone(), summary)
    };
    model.user_seams().iter().zip(&assembly.contacts).map(of).collect()
}

/// The law's parameters, with what was chosen for them.
fn values(seam: &Seam, contacts: &Contacts) -> Vec<MaterialValue> {
    let value = |parameter: &Parameter| {
        let (value, word) = match contacts.law.values().0.get(parameter.name)? {
            Value::Number(x) => (*x, String::new()),
            Value::Word(word) => (f64::NAN, word.clone()),
            Value::Table(_) => return None,
        };
        let given = seam.values.0.get(parameter.name) == contacts.law.values().0.get(parameter.name);
        Some(MaterialValue {
            name: parameter.name.into(),
            value,
            most: value,
            word: word.clone(),
            unit: unit(parameter.kind).into(),
            meaning: parameter.doc.into(),
            origin: match parameter.need {
                _ if !given => Origin::Derived,
                // A default that is written out is one as well.
                Need::Number(x) if x == value => Origin::Default,
                Need::Word(default) if default == word => Origin::Default,
                _ => Origin::Given,
            },
        })
    };
    contacts.law.info().parameters.iter().filter_map(value).collect()
}

/// The pairs of monitors on interfaces.
pub fn monitors(model: &Model, plan: &Plan) -> IndexMap<String, PairPlace> {
    let of = |monitor: &PairMonitor| {
        let seam = &model.seams[monitor.interface];
        let pair = seam.nearest(&model.mesh, monitor.point);
        let normal = seam.pairs[pair].normal;
        let place = PairPlace {
            interface: seam.name.clone(),
            node: model.mesh.node_id(seam.pairs[pair].nodes[1] as usize),
            at: seam.place(&model.mesh, pair),
            normal,
            tangents: tangents(normal),
        };
        (monitor.name.clone(), place)
    };
    plan.pairs.iter().map(of).collect()
}

/// A finding for each interface.
pub fn findings(interfaces: &IndexMap<String, InterfaceSummary>) -> Vec<Finding> {
    interfaces.iter().map(|(name, interface)| finding(name, interface)).collect()
}

fn finding(name: &str, interface: &InterfaceSummary) -> Finding {
    let InterfaceSummary { area, ever_slid, ever_opened, max_gap, max_slip, .. } = interface;
    let whole = format!("{area:.0}");
    let share = |part: f64| format!("{:.1}", 100.0 * part / area);
    let (slid, opened) = (share(*ever_slid), share(*ever_opened));
    let (slip, gap) = (length(max_slip.value), length(max_gap.value));
    let (slip_at, gap_at) = (point(max_slip.at), point(max_gap.at));
    let (headline, text) = match (*ever_slid > 0.0, *ever_opened > 0.0) {
        (false, false) => {
            let text = match interface.ends {
                0 => Said::default(),
                n => said!(
                    "At {nodes} nodes, where it meets linings or its own ends, it cannot slide.",
                    nodes = n.to_string()
                ),
            };
            (said!("the interface neither slid nor opened on its {area} m²", area = whole), text)
        }
        (true, false) => (
            said!("the interface slid over {slid} % of its {area} m²", slid = slid, area = whole),
            said!("Largest slip {slip} at {slip_at}.", slip = slip, slip_at = slip_at),
        ),
        (false, true) => (
            said!("the interface opened over {opened} % of its {area} m²", opened = opened, area = whole),
            said!("Largest gap {gap} at {gap_at}.", gap = gap, gap_at = gap_at),
        ),
        (true, true) => (
            said!(
                "the interface slid over {slid} % and opened over {opened} % of its {area} m²",
                slid = slid,
                opened = opened,
                area = whole,
            ),
            said!(
                "Largest slip {slip} at {slip_at}, largest gap {gap} at {gap_at}.",
                slip = slip,
                slip_at = slip_at,
                gap = gap,
                gap_at = gap_at,
            ),
        ),
    };
    let severity = match (*ever_slid > 0.0, *ever_opened > 0.0) {
        (false, false) => Severity::Undamaged,
        _ => Severity::Damaged,
    };
    Finding::new(format!("interface_{}", snake(name)), name, severity, headline, text)
        .with("area", *area)
        .with("share_slid", ever_slid / area)
        .with("share_opened", ever_opened / area)
        .with("closed_nodes", interface.ends as f64)
        .with("max_slip", max_slip.value)
        .with_place("max_slip", max_slip.at)
        .with("max_gap", max_gap.value)
        .with_place("max_gap", max_gap.at)
}

/// A slip or gap as one says it.
fn length(x: f64) -> String {
    if x < 1e-5 { format!("{:.2} µm", 1e6 * x) } else { format!("{:.2} mm", 1e3 * x) }
}
