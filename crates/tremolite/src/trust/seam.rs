//! Checks of one interface: whether its pairs stay where their law and the step are good.

use crate::evidence::Evidence;
use crate::observers::{Interfaces, Ringing};
use crate::places;
use tremolite_engine::Seam;
use tremolite_engine::give::{MOST_CLOSURE, give_of_elements};
use tremolite_kernels::contact::PairSeen;
use tremolite_mesh::Mesh;
use tremolite_results::{Said, TrustLine, said, snake};

/// Closure over the largest: beyond, k_n is sixteen times k_n0, and what the joint still closes says more of the law's end
/// than of the joint.
const CLOSURE: f64 = 0.75;
/// Slip over the shortest edge of the faces at a pair: normals do not turn, and pairs do not change partners.
const SLIP: f64 = 0.1;
/// Gap over the shortest edge: a pair far apart closes on faces that are no longer its own.
const GAP: f64 = 0.1;
/// Energy found or lost at impacts over all that was supplied.
const IMPACTS: f64 = 0.01;
/// Acceleration above the input's band over that below, of pairs that slide: of a block on a slope 0.08 with the default's viscosity and
/// 2.0 with a quarter of it, with which it still slides as far; 11 where it slides 3 % too far, 44 where 17 %.
const RINGING: f64 = 1.0;
/// Share of area and time that must count, or nothing is said of ringing.
const LEAST_COUNTED: f64 = 0.01;
/// Round-off of a step that is to be a share of another.
const ROUND_OFF: f64 = 1e-9;

/// The checks of an interface.
pub(super) fn of(evidence: &Evidence, number: usize) -> Vec<TrustLine> {
    let Evidence { model, assembly, outcome, .. } = evidence;
    let (seam, contacts) = (&model.seams[number], &assembly.contacts[number]);
    let history = &outcome.state.history;
    let totals = contacts.totals(seam, history);
    let id = |what: &str| format!("{what}_{}", snake(&seam.name));
    let name = |what: Said| said!("{check}, {interface}", check = what, interface = &seam.name);

    let closure = match contacts.law.closure_limit() {
        None => TrustLine::not_applicable(
            id("interface_closure"),
            name(said!("largest closure over its limit")),
            said!("the law '{law}' has no largest closure", law = contacts.law.info().name),
        ),
        Some(limit) => {
            let most = contacts.law.closure(totals.largest_pressure.max(0.0));
            let line = TrustLine::at_most(
                id("interface_closure"),
                name(said!("largest closure over its limit")),
                most / limit,
                CLOSURE,
                "",
            );
            line.with("closure", most).with("limit", limit).with_note(said!(
                "of all pairs and steps, by the law at the largest pressure, over `max_closure`: the joint is nearly closed and as stiff as it gets; give a larger one, or a stiffer joint"
            ))
        }
    };

    let node = |pair: usize| model.mesh.node_id(seam.pairs[pair].nodes[1] as usize) as f64;
    let edges = shortest_edges(&model.mesh, seam);
    // The largest value over the edges at its pair, and that pair.
    let worst = |value: fn(&PairSeen) -> f64| {
        let mut worst = (0.0, 0);
        for k in seam.lasting() {
            let share = value(&contacts.seen(history, k)) / edges[k];
            if share > worst.0 || share.is_nan() {
                worst = (share, k);
            }
        }
        (worst.0, worst.1)
    };
    let (share, at) = worst(|seen| seen.largest_slip);
    let slip_name = name(said!("largest slip over element size"));
    let slip = TrustLine::at_most(id("interface_slip"), slip_name, share, SLIP, "")
        .with("slip", totals.largest_slip)
        .with("node", node(at))
        .with_note(said!(
            "shortest edge of the faces at {pair}; normals and partners of pairs do not change, so slip must stay small",
            pair = places::pair(&model.mesh, seam, at),
        ));
    let (share, at) = worst(|seen| seen.largest_gap);
    let gap_name = name(said!("largest gap over element size"));
    let gap = TrustLine::at_most(id("interface_gap"), gap_name, share, GAP, "")
        .with("gap", totals.largest_gap)
        .with("node", node(at))
        .with_note(said!(
            "shortest edge of the faces at {pair}; sides so far apart have come loose, and where they close they meet other faces than the model pairs",
            pair = places::pair(&model.mesh, seam, at),
        ));

    let straight = match contacts.law.straight_from() {
        None => TrustLine::not_applicable(
            id("contact_above_pressure_limit"),
            name(said!("interface pairs under more pressure than pressure_for_step")),
            said!("the law is linear"),
        ),
        Some(limit) => TrustLine::at_most(
            id("contact_above_pressure_limit"),
            name(said!("interface pairs under more pressure than pressure_for_step")),
            totals.beyond as f64,
            0.0,
            "",
        )
        .with("pressure", totals.largest_pressure)
        .with("limit", limit)
        .with("pairs", seam.lasting().count() as f64)
        .with_note(said!(
            "of {pairs} pairs; the largest pressure was {pressure} MPa, and from {limit} MPa on the joint is held at a constant \
             stiffness, so that it does not shorten the step; give a larger `pressure_for_step`, at the price of a shorter one",
            pairs = seam.lasting().count().to_string(),
            pressure = format!("{:.3}", totals.largest_pressure / 1e6),
            limit = format!("{:.3}", limit / 1e6),
        )),
    };

    let supplied = outcome.state.ledger.supplied;
    let gained = Interfaces::largest_gain(&outcome.state.observers, number);
    let (impacts_id, impacts_name) =
        (id("contact_energy_error"), name(said!("energy error of impacts over energy supplied")));
    let impacts = match evidence.outcome.shaken {
        true if gained == 0.0 && supplied == 0.0 => {
            TrustLine::not_applicable(impacts_id, impacts_name, said!("no energy was supplied"))
        }
        true => TrustLine::at_most(impacts_id, impacts_name, gained / supplied, IMPACTS, "")
            .with("impact_gain", gained)
            .with("supplied", supplied)
            .with_note(said!(
                "largest of all rows: energy that the explicit step creates or loses when pairs close and open; a smaller `contact_limit` or a larger `contact_damping` reduces it"
            )),
        false => TrustLine::not_applicable(impacts_id, impacts_name, said!("there is no earthquake")),
    };

    // A step that is just as long as the limit lets it may differ by round-off.
    let product = outcome.dt * contacts.frequency;
    let product = if product > seam.limit { product * (1.0 - ROUND_OFF) } else { product };
    let step = TrustLine::at_most(
        id("contact_frequency_step"),
        name(said!("time step × frequency of the stiffest contact pair")),
        product,
        seam.limit,
        "",
    )
    .with("frequency", contacts.frequency)
    .with("node", node(contacts.stiffest_pair))
    .with_note(said!(
        "ω_c of {pair} with its stiffest state; beyond 0.8 impacts may gain energy though the step is stable",
        pair = places::pair(&model.mesh, seam, contacts.stiffest_pair),
    ));

    let chosen_name = name(said!("compliance of the interface over that of the adjacent elements"));
    let chosen = if contacts.chosen {
        let stiffness = contacts.law.stiffness(0.0)[0];
        TrustLine::at_most(
            id("contact_penalty_compliance"),
            chosen_name,
            1.0 / (stiffness * give_of_elements(evidence.model, seam)),
            MOST_CLOSURE,
            "",
        )
        .with("normal_stiffness", stiffness)
        .with_note(said!(
            "at equal pressure, unloaded; the program chose the stiffness. Above the limit results depend on it: give \
             `normal_stiffness` from a test, or leave `time_step` out"
        ))
    } else {
        TrustLine::not_applicable(
            id("contact_penalty_compliance"),
            chosen_name,
            said!("its stiffness was given"),
        )
    };
    vec![closure, slip, gap, straight, impacts, step, ringing(evidence, number), chosen]
}

/// Whether the bodies beside an interface ring.
fn ringing(evidence: &Evidence, number: usize) -> TrustLine {
    let Evidence { model, outcome, .. } = evidence;
    let seam = &model.seams[number];
    let id = format!("interface_ringing_{}", snake(&seam.name));
    let name = said!("{check}, {interface}", check = ringing_name(), interface = &seam.name);
    let none = |why: Said| TrustLine::not_applicable(&id, name.clone(), why);
    let Some(Ringing { above, below, counted, corner }) =
        Ringing::of(model, evidence.plan, &outcome.state.observers, number, outcome.taken)
    else {
        return none(said!("no wave comes in"));
    };
    if counted < LEAST_COUNTED {
        return none(said!(
            "between sound elements, and apart from what hits, it slid over {share} % of area and time alone",
            share = format!("{:.1}", 100.0 * counted),
        ));
    }
    TrustLine::at_most(&id, name.clone(), above / below, RINGING, "")
        .with("above", above)
        .with("below", below)
        .with("corner", corner)
        .with("counted", counted)
        .with_note(said!(
            "acceleration of its nodes above {corner} Hz, twice the highest frequency that comes in, {above} m/s², over that below, \
             {below} m/s²; root mean squares over {share} % of area and time: where it slid between sound elements, away from what was open. Sliding feeds such vibrations, and they make it slide further: give the interface more `viscosity`",
            corner = format!("{corner:.1}"),
            above = format!("{above:.3}"),
            below = format!("{below:.3}"),
            share = format!("{:.0}", 100.0 * counted),
        ))
}

pub(super) fn ringing_name() -> Said {
    said!("ringing of the interface: acceleration above the input's band over that within it")
}

/// By pair, the shortest edge \[m\] of the faces around it.
fn shortest_edges(mesh: &Mesh, seam: &Seam) -> Vec<f64> {
    let edge = |face: u32| {
        let nodes: Vec<u32> = mesh.face_nodes(seam.faces[face as usize][0]).collect();
        let length = |(a, b): (u32, u32)| {
            let [a, b] = [a, b].map(|n| mesh.nodes[n as usize]);
            (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
        };
        let next = nodes.iter().copied().cycle().skip(1);
        nodes.iter().copied().zip(next).map(length).fold(f64::INFINITY, f64::min)
    };
    let shortest =
        |corners: &[(u32, u8)]| corners.iter().map(|&(face, _)| edge(face)).fold(f64::INFINITY, f64::min);
    seam.pairs.iter().map(|pair| shortest(&pair.corners)).collect()
}
