//! What a run leaves for people: summary.json, with a verdict and a line for each thing that bears on trust.

use crate::damage;
use crate::evidence::Evidence;
use crate::failure_modes::{failure_modes, tension};
use crate::interfaces::{self, interfaces};
use crate::observers::{BoltForces, Extremes, SectionForces, strengths};
use crate::outcome::run_in_words;
use crate::outlook::{MIDDLE, stress_at_start};
use crate::plan::Plan;
use crate::setup::{CarriedFacts, MotionFacts, SoilFacts, WaveFacts};
use crate::simulation::Ending;
use crate::stress::stresses;
use crate::support;
use crate::survey::step_in_words;
use crate::synchrony::synchrony;
use crate::trust::{facts, on_broken_elements, trust};
use indexmap::IndexMap;
use tremolite_engine::Model;
use tremolite_engine::column::corner_name;
use tremolite_results::{
    Assessment, CaseFacts, Computed, Conclusion, Deconvolved, Finding, InitialStress, ModelFacts,
    MonitorFacts, MotionFacts as MotionSummary, PartFacts, SoilLayer, Soundness, Status, Summary, Wave,
    WavePart, assess, peaks_by_monitor,
};

/// Where the water's pressure comes from, and what becomes of it in the earthquake.
fn water(model: &Model, plan: &Plan) -> IndexMap<String, String> {
    if model.water.spells.is_empty() {
        return IndexMap::new();
    }
    let flows = plan.stages.iter().any(|stage| stage.flow.is_some());
    let undrained = !model.water.modulus.is_empty();
    let words = [
        ("pressure", if flows { "seepage" } else { "level" }),
        ("earthquake", if undrained { "undrained" } else { "drained" }),
    ];
    words.map(|(key, word)| (key.to_owned(), word.to_owned())).into()
}

/// The summary of a run that ended.
pub fn summary(evidence: Evidence) -> Summary {
    let Evidence { model, assembly, phase, plan, motion, survey, outcome, histories, .. } = evidence;
    let [mut monitors, relative] = peaks_by_monitor(histories);
    for (monitor, quantities) in &mut monitors {
        for (quantity, peaks) in quantities {
            let extremes = Extremes::of(&outcome.state.observers, plan, monitor, quantity);
            (peaks.step_max, peaks.step_min) = (extremes.map(|e| e.max), extremes.map(|e| e.min));
        }
    }
    let (_, loose) = on_broken_elements(&evidence);
    let held = plan.monitors.iter().map(|monitor| monitor.name.as_str()).filter(|name| !loose.contains(name));
    let synchrony = synchrony(histories, held);
    let (trust, facts) = (trust(&evidence), facts(&evidence));
    let damage = damage::damage(model, phase, outcome.history(assembly), &outcome.state.observers);
    let stress = stresses(model, phase, &outcome.state.observers);
    let run = run_in_words(&evidence, &trust, &stress);
    let set_by = step_in_words(model, assembly, &outcome.stable);
    let interfaces = interfaces(model, assembly, &outcome.state.history);
    let memory = &outcome.state.observers;
    let bolts = support::bolts(
        &model.bolts,
        plan,
        outcome.stage(),
        &support::look(assembly, &outcome.state.numbers),
        &BoltForces::peaks(&model.bolts, plan, memory),
    );
    let sections = strengths(model, plan, memory);
    // Of what was stopped on its way to rest nothing is judged.
    let judged = outcome.shaken || !matches!(outcome.ending, Ending::Stopped);
    let mut findings = if judged { damage::findings(model, &damage) } else { Vec::new() };
    if judged {
        findings.extend(tension(&sections, &stress));
        findings.extend(interfaces::findings(&interfaces));
        findings.extend(support::findings(&bolts));
    }
    let status = match outcome.ending {
        Ending::Done => Status::Done,
        Ending::Stopped => Status::Stopped,
        Ending::Failed { .. }
        | Ending::Astray { .. }
        | Ending::Restless { .. }
        | Ending::SnappedBack { .. } => Status::Failed,
    };
    let axes = ["x", "y", "z"];
    let mut groups: IndexMap<String, u64> =
        survey.bodies.iter().map(|b| (b.name.clone(), b.elements as u64)).collect();
    if survey.void_elements > 0 {
        groups.insert("void".into(), survey.void_elements as u64);
    }
    let mut summary = Summary {
        title: plan.title.clone(),
        conclusion: Conclusion {
            status,
            outcome: run.to_string(),
            outcome_message: run,
            findings,
            ..Conclusion::default()
        },
        computed: Computed {
            wall_seconds: evidence.wall_seconds,
            element_updates_per_second: outcome.updates_per_second(phase.evaluated_elements),
            model: ModelFacts {
                groups,
                elements: survey.active_elements as u64,
                nodes: survey.nodes as u64,
                steps: outcome.taken,
                elements_of_level: match &phase.elements_of_level[..] {
                    [] | [_] => Vec::new(),
                    all => all.iter().map(|&count| count as u64).collect(),
                },
                time_step: outcome.dt,
                step_set_by: set_by.to_string(),
                step_set_by_message: set_by,
                duration: outcome.taken as f64 * outcome.dt,
            },
            materials: evidence.materials,
            motion: motion.map_or_else(MotionSummary::default, |motion| MotionSummary {
                kind: motion.kind.to_string(),
                factor: motion.factor.unwrap_or(f64::NAN),
                peak_acceleration: (0..3)
                    .map(|i| (axes[i].to_owned(), motion.incident[i].acceleration))
                    .collect(),
                given_peak_acceleration: given_peaks(plan, motion).map_or_else(IndexMap::new, |peaks| {
                    (0..3).map(|i| (axes[i].to_owned(), peaks[i])).collect()
                }),
                source: (0..3).map(|i| (axes[i].to_owned(), motion.source.clone())).collect(),
                target: plan.target.clone(),
                deconvolved: motion.site.as_ref().map(|site| Deconvolved {
                    depth: site.depth,
                    corner: site.corner.map_or_else(String::new, corner_name),
                    lead: site.lead,
                    band: site.band,
                    reach: if site.reach.is_finite() { site.reach } else { f64::NAN },
                    left_out: site.left_out,
                    at_rest: site.at_rest,
                    least: site.least.0,
                    least_at: site.least.1,
                    soil: site.soil.iter().map(soil).collect(),
                }),
                waves: motion.waves.iter().map(wave).collect(),
                lead: motion.lead,
            }),
            boundaries: plan.boundaries.clone(),
            initial_stress: stress_at_start(model)
                .get(MIDDLE)
                .map(|found| InitialStress { at: found.at, stress: found.stress }),
            linings: SectionForces::of(model).extents(),
            water: water(model, plan),
            run: evidence.run,
            stages: outcome.stages.clone(),
        },
        monitors: MonitorFacts {
            monitor_positions: plan.monitors.iter().map(|m| (m.name.clone(), m.point)).collect(),
            peaks: monitors,
            relative,
            synchrony,
            on_broken_elements: loose.into_iter().map(str::to_owned).collect(),
        },
        parts: PartFacts {
            stress,
            damage,
            interfaces,
            pairs: interfaces::monitors(model, plan),
            bolts,
            failure_modes: failure_modes(model, &sections),
            sections,
            bolt_monitors: support::monitors(&model.bolts, plan),
        },
        soundness: Soundness {
            energy: assembly.lines().map(|line| (line.name().to_owned(), outcome.balance[line])).collect(),
            checks: trust,
        },
        case: CaseFacts {
            report: plan.page.clone(),
            assume_si: evidence.bare_si,
            warnings: evidence.before,
            facts,
            inputs: evidence.inputs,
            version: env!("CARGO_PKG_VERSION").to_owned(),
            defaults_used: evidence.defaulted,
        },
    };
    let assessment = assess(&summary, Some(histories));
    summary.conclusion.verdict = verdict(&summary, &assessment);
    summary.conclusion.state = assessment.state;
    summary.conclusion.reliance = assessment.reliance;
    summary
}

/// Largest acceleration of the motion given, by axis \[m/s²\].
fn given_peaks(plan: &Plan, motion: &MotionFacts) -> Option<[f64; 3]> {
    let largest = |a: &Vec<f64>| a.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    match (&plan.recorded, motion.factor) {
        _ if plan.waves.is_some() => {
            plan.waves.as_ref().map(|waves| waves.motion.acceleration.each_ref().map(largest))
        }
        (Some(recorded), _) => Some(recorded.motion.acceleration.each_ref().map(largest)),
        (None, Some(factor)) => Some(motion.incident.map(|peak| peak.acceleration / factor.abs())),
        (None, None) => None,
    }
}

/// The run's outcome, both classes, and what became of each structure, in one text; of many groups of bolts that of all together.
fn verdict(summary: &Summary, assessment: &Assessment) -> String {
    let bolts = &summary.parts.bolts;
    let mut text = format!("{} {}", summary.conclusion.outcome, assessment.classes());
    let all_bolts = support::together(bolts);
    let others = |finding: &&Finding| all_bolts.is_none() || !bolts.contains_key(&finding.group);
    for finding in summary.conclusion.findings.iter().filter(others).chain(&all_bolts) {
        text += &format!(" {}: {}.", finding.group, finding.headline);
        if !finding.text.is_empty() {
            text += &format!(" {}", finding.text);
        }
    }
    text
}

fn soil(layer: &SoilFacts) -> SoilLayer {
    SoilLayer {
        thickness: layer.thickness,
        shear_wave_velocity: layer.speed,
        strain: layer.strain,
        modulus: layer.modulus,
        damping: layer.damping,
    }
}

fn wave(wave: &WaveFacts) -> Wave {
    let part = |part: &CarriedFacts| WavePart {
        component: part.component.into(),
        factor: part.factor,
        phase: part.phase,
    };
    Wave {
        kind: wave.kind.word().into(),
        angle: wave.angle,
        azimuth: wave.azimuth,
        way: wave.way,
        polarisation: wave.polarisation,
        parts: wave.parts.iter().map(part).collect(),
        apparent_velocity: if wave.apparent_velocity.is_finite() { wave.apparent_velocity } else { f64::NAN },
        arrives: wave.arrives,
    }
}
