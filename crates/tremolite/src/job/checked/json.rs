//! What is said of a case, as one JSON object. Numbers are in SI.

use super::Checked;
use crate::setup::{SiteFacts, SoilFacts, WaveFacts};
use serde_json::{Map, Value, json};
use tremolite_case::{Diagnostic, Mesh, Report};
use tremolite_engine::column::corner_name;

impl Checked<'_> {
    pub(super) fn json(&self) -> Value {
        let Checked { job, disk, .. } = self;
        let (survey, steps) = (&job.survey, job.steps);
        let groups: Map<String, Value> =
            job.groups.iter().map(|(name, elements)| (name.clone(), json!(elements))).collect();
        let of_materials: Vec<_> = job.materials.values().flat_map(|facts| &facts.groups).collect();
        let groups_of = |name: &str| {
            of_materials
                .iter()
                .find(|group| group.body == name)
                .map_or(name.to_owned(), |group| group.names.clone())
        };
        let regions = survey.bodies.iter().map(|body| {
            json!({
                "groups": groups_of(&body.name), "law": body.law, "elements": body.elements,
                "could_run_at": body.element_step, "elements_per_wavelength": body.per_wavelength,
            })
        });
        let motion = job.motion.as_ref().map(|motion| {
            let peaks: Map<String, Value> = ["x", "y", "z"]
                .into_iter()
                .zip(&motion.intensity)
                .map(|(axis, m)| (axis.to_owned(), json!({ "pga": m.pga, "pgv": m.pgv, "pgd": m.pgd })))
                .collect();
            let enters: Map<String, Value> = ["x", "y", "z"]
                .into_iter()
                .zip(&motion.incident)
                .map(|(axis, p)| {
                    let peaks = json!({ "pga": p.acceleration, "pgv": p.velocity, "pgd": p.displacement });
                    (axis.to_owned(), peaks)
                })
                .collect();
            json!({
                "source": motion.source,
                "window": motion.window,
                "kind": motion.kind.to_string(),
                "incident_factor": motion.factor,
                "waves": motion.waves.iter().map(wave).collect::<Vec<_>>(),
                "condition": motion.condition,
                "lead": (!motion.waves.is_empty()).then_some(motion.lead),
                "deconvolved": motion.site.as_ref().map(deconvolved),
                "peaks": peaks,
                "enters": enters,
                "design_displacement": motion.design_displacement,
                "highest_frequency": motion.highest_frequency,
                "elements_per_wavelength": survey.coarsest().map(|body| body.per_wavelength),
                "coarsest": self.coarsest,
            })
        });
        let time_step = job.motion.as_ref().map(|_| {
            json!({
                "stable": job.stable.dt,
                "set_by": self.set_by,
                "impacts": self.impacts,
                "used": job.dt,
                "elements_of_level": job.phase.elements_of_level,
                "steps": steps.total,
                "duration": job.plan.duration,
            })
        });
        json!({
            "title": job.case.title.value,
            "elements": survey.active_elements,
            "excavated": survey.void_elements,
            "nodes": survey.nodes,
            "slab_elements": survey.slab_elements,
            "column_elements": survey.column_elements,
            "groups": groups,
            "mesh_rotation": self.rotation(),
            "regions": regions.collect::<Vec<_>>(),
            "materials": job.materials,
            "interfaces": self.interfaces,
            "pairs": self.pairs,
            "bolts": self.bolts,
            "bolt_monitors": self.bolt_monitors,
            "motion": motion,
            "initial_stress": self.initial_json(),
            "relaxed_moduli": self.relaxed_json(),
            "stages": self.stages_json(),
            "comes_and_goes": self.lives_json(),
            "time_step": time_step,
            "estimate": {
                "seconds": self.seconds(),
                "stage_seconds": self.stage_seconds(),
                "stage_cycles": self.cycles(),
                "threads": self.threads,
                "isa": job.model.scheme.isa.name(),
                "element_updates_per_second": self.updates_per_second(),
                "memory_bytes": survey.bytes,
                "disk_bytes": disk.total(),
                "field_files": disk.field_files,
                "stage_files": disk.stage_files,
                "field_file_bytes": disk.field_file,
                "histories_bytes": disk.histories,
                "bolts_bytes": disk.bolts,
                "checkpoint_bytes": disk.checkpoint,
            },
            "defaults_used": self.left_out,
            "findings": self.findings(),
        })
    }

    /// By which a mesh from a file is turned \[rad\].
    fn rotation(&self) -> Option<f64> {
        match &self.job.case.mesh {
            Mesh::File(file) => Some(file.rotate.value),
            _ => None,
        }
    }

    /// What is allowed but hardly meant, each at its key and its line of the case; what comes from `--set` has none.
    fn findings(&self) -> Vec<Value> {
        let report = self.job.case.report(self.job.warnings().cloned().collect());
        diagnostics(&report)
    }
}

/// Problems of a case as programs read them, each at its key and its line; what comes from `--set` has no line.
pub fn diagnostics(report: &Report) -> Vec<Value> {
    let diagnostic = |problem: &Diagnostic| {
        let place = problem.set.is_none().then(|| report.position(problem));
        let (line, column) = place.unzip();
        json!({
            "key": problem.key, "line": line, "column": column, "set": problem.set,
            "message": problem.message, "remedy": problem.remedy,
        })
    };
    report.problems.iter().map(diagnostic).collect()
}

/// How a record on or within layered ground was deconvolved; what is infinite is null.
fn wave(wave: &WaveFacts) -> Value {
    json!({
        "type": wave.kind.word(),
        "angle": wave.angle,
        "azimuth": wave.azimuth,
        "component": wave.component,
        "parts": wave.parts.iter().map(|part| json!({
            "component": part.component, "factor": part.factor, "phase": part.phase,
        })).collect::<Vec<_>>(),
        "apparent_velocity": wave.apparent_velocity.is_finite().then_some(wave.apparent_velocity),
        "arrives": wave.arrives,
    })
}

fn deconvolved(site: &SiteFacts) -> Value {
    json!({
        "depth": site.depth,
        "corner": site.corner.map(corner_name),
        "lead": site.lead,
        "band": site.band,
        "reach": site.reach,
        "left_out": site.left_out,
        "at_rest": site.at_rest,
        "least": site.least.0,
        "least_at": site.least.1,
        "soil": site.soil.iter().map(soil).collect::<Vec<_>>(),
    })
}

/// What a layer that softens, or one beside such, came to.
fn soil(layer: &SoilFacts) -> Value {
    json!({
        "thickness": layer.thickness,
        "shear_wave_velocity": layer.speed,
        "strain": layer.strain,
        "modulus": layer.modulus,
        "damping": layer.damping,
    })
}
