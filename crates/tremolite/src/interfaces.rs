//! What interfaces did, for people.

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
    Finding, InterfaceSummary, MaterialValue, Origin, PairPeak, PairPlace, Severity, snake,
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
            for k in 0..seam.pairs.len() {
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
            pairs: seam.pairs.len() as u64,
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
    let share = |part: f64| 100.0 * part / area;
    let headline = match (*ever_slid > 0.0, *ever_opened > 0.0) {
        (false, false) => format!("the interface neither slid nor opened on its {area:.0} m²"),
        (true, false) => format!("the interface slid over {:.1} % of its {area:.0} m²", share(*ever_slid)),
        (false, true) => {
            format!("the interface opened over {:.1} % of its {area:.0} m²", share(*ever_opened))
        }
        (true, true) => format!(
            "the interface slid over {:.1} % and opened over {:.1} % of its {area:.0} m²",
            share(*ever_slid),
            share(*ever_opened)
        ),
    };
    let place = |peak: &PairPeak| {
        let [x, y, z] = peak.at;
        let value = peak.value;
        let value =
            if value < 1e-5 { format!("{:.2} µm", 1e6 * value) } else { format!("{:.2} mm", 1e3 * value) };
        format!("{value} at ({x:.1}, {y:.1}, {z:.1}) m")
    };
    let mut parts = Vec::new();
    if *ever_slid > 0.0 {
        parts.push(format!("largest slip {}", place(max_slip)));
    }
    if *ever_opened > 0.0 {
        parts.push(format!("largest gap {}", place(max_gap)));
    }
    let mut text = parts.join(", ");
    if !text.is_empty() {
        text = format!("{}{}.", text[..1].to_uppercase(), &text[1..]);
    }
    let severity = match (*ever_slid > 0.0, *ever_opened > 0.0) {
        (false, false) => Severity::Undamaged,
        _ => Severity::Damaged,
    };
    let numbers = [
        ("share_slid", ever_slid / area),
        ("share_opened", ever_opened / area),
        ("max_slip", max_slip.value),
        ("max_gap", max_gap.value),
    ];
    Finding {
        id: format!("interface_{}", snake(name)),
        group: name.to_owned(),
        severity,
        headline,
        text,
        numbers: numbers.map(|(name, value)| (name.to_owned(), value)).into_iter().collect(),
    }
}
