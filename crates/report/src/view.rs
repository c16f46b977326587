//! The model in three dimensions: what the page's script draws, in blocks of compressed numbers.
//!
//! A part is a body or an interface; its name and kind come from the result files ([`names`]). What the field files hold
//! goes in as it is: places in u16 steps, scalars in 255 levels between their extremes over all times, displacement in i16
//! steps about the mean of the model at that time. The flow of water goes in as lines; other vectors and tensors stay in the files.

mod code;
mod columns;
mod encode;
mod faces;
mod fit;
mod interface;
mod labels;
mod manifest;
mod mesh;
mod names;
mod notes;
mod part;
#[cfg(test)]
mod tests;

use tremolite_results::{FieldFile, Pvd, SectionRow};

use self::code::Grid16;
use self::encode::Common;
use self::fit::{fit, size};
use self::manifest::{Arrow, FlowHeld, Manifest, Moment, PartData, PartKind};
use self::part::Part;
use crate::flow::{self, FlowCell};
use crate::language::say;
use crate::page::size::{VIEW, limit};
use crate::script::blocks::{Blocks, json_element};
use crate::source::Source;

/// Steps of displacement to each side of the mean where all that i16 holds would take too much.
const COARSE: f64 = 2047.0;

/// Flow lines in the whole model: how many at most, how long all are, how far a line is from where it is, and how far behind a cut lines are shown,
/// all over the diagonal of what is wet.
const LINES: usize = 150;
const LENGTH: f64 = 40.0;
const OFF: f64 = 5e-4;
const BESIDE: f64 = 0.03;

/// The page's manifest of the view, its numbers in `blocks`; empty where there is nothing to draw or the case wants none.
/// Where a file cannot be read the manifest has no parts, and a note that says why. `rest` is how many bytes all else of the
/// page takes.
pub fn embedded(source: &Source, blocks: &mut Blocks, rest: usize) -> String {
    within(source, blocks, &|elements| limit(elements).saturating_sub(rest).max(VIEW))
}

/// Whether [`embedded`] gives anything.
pub fn is_wanted(source: &Source) -> bool {
    found(source).is_some()
}

/// The list of the field files, and what its times are; nothing where there is none or none is wanted.
fn found(source: &Source) -> Option<(&'static str, Result<Pvd, String>)> {
    if source.summary.as_ref().is_ok_and(|summary| !summary.case.report.view) {
        return None;
    }
    let folder = &source.folder;
    let list = |path: &std::path::Path| {
        path.exists().then(|| Pvd::read(path).map_err(|e| e.to_string())).filter(|list| {
            // A run that has not come so far has a list without files.
            list.as_ref().map_or(true, |pvd| !pvd.snapshots().is_empty())
        })
    };
    match list(&folder.pvd()) {
        Some(found) => Some(("earthquake", found)),
        None => Some(("stages", list(&folder.stages_pvd())?)),
    }
}

/// As [`embedded`], with the bytes that the blocks may take by the number of elements.
fn within(source: &Source, blocks: &mut Blocks, budget: &dyn Fn(usize) -> usize) -> String {
    let Some((clock, found)) = found(source) else { return String::new() };
    let manifest = found.and_then(|pvd| drawn(source, clock, &pvd, blocks, budget));
    let manifest = manifest.unwrap_or_else(|why| Manifest {
        version: 1,
        clock,
        origin: [0.0; 3],
        step: [0.0; 3],
        times: Vec::new(),
        mean: Vec::new(),
        displacement_step: 0.0,
        displacement_largest: 0.0,
        parts: Vec::new(),
        waves: Vec::new(),
        flows: Vec::new(),
        flow_at: Vec::new(),
        notes: vec![say!(source.language, "The view is left out. {why}.", why = why)],
    });
    // Only keys that are no texts could fail, and there are none.
    json_element("view-data", &serde_json::to_string(&manifest).unwrap_or_default())
}

/// # Errors
/// In words, if a field file cannot be read.
fn drawn(
    source: &Source,
    clock: &'static str,
    pvd: &Pvd,
    blocks: &mut Blocks,
    budget: &dyn Fn(usize) -> usize,
) -> Result<Manifest, String> {
    let (language, summary) = (source.language, source.facts());
    let moments = moments(source, clock, pvd);
    let mut solids: Vec<Part> = Vec::new();
    let mut mean = Vec::new();
    let (mut flows, mut flow_at) = (Vec::new(), Vec::new());
    // What flows is the same at all times of an earthquake; its pressures, which change there, are those of the first.
    let (mut flowing, mut now) = (None, None);
    for (time, snapshot) in pvd.snapshots().iter().enumerate() {
        let file = FieldFile::solids(&pvd.locate(snapshot)).map_err(|e| e.to_string())?;
        mean.push(file.displacement.as_deref().map_or([0.0; 3], mean_of));
        part::take(&mut solids, time, &file, 8, mean[time]);
        if file.discharge != flowing {
            now = flow_of(&file).map(|flow| {
                flows.push(flow);
                flows.len() - 1
            });
            flowing = file.discharge.clone();
        }
        flow_at.push(now);
    }
    let (interfaces, broken) = match interface::read(&source.folder.interfaces_pvd(), &moments, &solids) {
        Ok(interfaces) => (interfaces, None),
        Err(why) => (Vec::new(), Some(why)),
    };

    let rows: &[SectionRow] = source.sections.as_ref().and_then(|rows| rows.as_deref().ok()).unwrap_or(&[]);
    let linings: Vec<&str> = rows.iter().map(|row| row.lining.as_str()).collect();
    let mut names = names::bodies(language, &solids);
    let mut kinds = names::kinds(&solids, &linings, &summary);
    let mut outer = faces::outer(&solids.iter().map(|part| &part.mesh).collect::<Vec<_>>());
    for part in &interfaces {
        let numbered = || say!(language, "interface {number}", number = part.owner);
        names.push(interface::name(part).map_or_else(numbered, str::to_owned));
        kinds.push(PartKind::Interface);
        outer.push(faces::of_interface(&part.mesh));
    }

    let elements: usize = solids.iter().map(|part| part.mesh.elements.len()).sum();
    let parts: Vec<Part> = solids.into_iter().chain(interfaces).collect();
    let grid = Grid16::around(parts.iter().flat_map(|part| &part.mesh.points));
    let encoded = |levels: f64| {
        let step = largest_displacement(&parts) / levels;
        let common = Common { language, grid, times: moments.len(), step };
        let mut draft = Blocks::default();
        let mut data: Vec<PartData> = Vec::new();
        let mut notes = Vec::new();
        for ((part, name), (kind, outer)) in parts.iter().zip(&names).zip(kinds.iter().zip(&outer)) {
            let (encoded, uniform) = common.encode(part, name.clone(), *kind, outer, &mut draft);
            notes.extend(notes::uniform(language, &encoded.name, &uniform));
            data.push(encoded);
        }
        (common, draft, data, notes)
    };
    let budget = budget(elements);
    let (mut common, mut draft, mut data, mut notes) = encoded(f64::from(i16::MAX));
    // Coarser steps of displacement, which show as much, rather than fewer times.
    if size(&mut data, &draft) > budget {
        (common, draft, data, notes) = encoded(COARSE);
    }
    let left = fit(&mut data, moments.len(), &draft, budget);
    data.iter_mut().flat_map(PartData::blocks).for_each(|block| *block = blocks.take(&draft, *block));
    notes.splice(0..0, notes::left_out(language, &left, budget));
    notes.extend(broken.map(|why| say!(language, "Interfaces are left out. {why}.", why = why)));
    notes.extend(notes::vectors(language, clock, &parts));
    let coming = if clock == "earthquake" { &summary.computed.motion.waves[..] } else { &[] };
    let waves: Vec<Arrow> = coming.iter().map(Arrow::of).collect();
    notes.extend((!waves.is_empty()).then(|| notes::waves(language)));
    notes.extend((!flows.is_empty()).then(|| notes::flow(language)));
    Ok(Manifest {
        version: 1,
        clock,
        origin: common.grid.origin,
        step: common.grid.step,
        times: moments,
        mean,
        displacement_step: common.step,
        displacement_largest: largest_displacement(&parts),
        parts: data,
        waves,
        flows,
        flow_at,
        notes,
    })
}

/// The flow of water in a file, through what has water under pressure; nothing where it holds none or the water is still.
fn flow_of(file: &FieldFile) -> Option<FlowHeld> {
    let p = file.scalars.iter().find(|scalar| scalar.at_cells && scalar.name == "p");
    let cells = file.cells.iter().zip(file.discharge.as_ref()?).enumerate();
    let wet = cells.filter(|(cell, _)| p.is_none_or(|p| p.values[*cell] > 0.0));
    let flowing: Vec<FlowCell<3>> = wet
        .map(|(_, (cell, q))| FlowCell {
            corners: cell.corners.map(|corner| file.points[corner as usize]).to_vec(),
            flow: q.map(f64::from),
            wanted: true,
        })
        .collect();
    let places = || flowing.iter().flat_map(|cell| &cell.corners);
    let extent = |k: usize| {
        let along = || places().map(|place| place[k]);
        along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
    };
    let diagonal = (0..3).map(|k| extent(k).powi(2)).sum::<f64>().sqrt();
    let lines = flow::lines(&flowing, LENGTH * diagonal, LINES);
    let lines: Vec<_> = lines.iter().map(|line| flow::thinned(line, OFF * diagonal)).collect();
    (!lines.is_empty()).then(|| FlowHeld::of(&lines, BESIDE * diagonal))
}

/// The times of the files, or the stages.
fn moments(source: &Source, clock: &str, pvd: &Pvd) -> Vec<Moment> {
    let stages = source.summary.as_ref().map_or(&[][..], |summary| &summary.computed.stages);
    let label = |t: f64| {
        if clock == "earthquake" {
            return format!("{} s", microseconds(t));
        }
        let name = stages.get(t as usize).map_or("", |stage| &stage.name);
        if name.is_empty() { say!(source.language, "stage {number}", number = t) } else { name.to_owned() }
    };
    pvd.snapshots().iter().map(|snapshot| Moment { t: snapshot.time, label: label(snapshot.time) }).collect()
}

/// A time (s) as it was asked for: what steps add up to differs from that by round-off.
fn microseconds(t: f64) -> f64 {
    (t * 1e6).round() / 1e6
}

/// Over all points of a file.
fn mean_of(displacement: &[[f32; 3]]) -> [f64; 3] {
    let finite = || displacement.iter().filter(|u| u.iter().all(|x| x.is_finite()));
    let count = finite().count().max(1) as f64;
    [0, 1, 2].map(|axis| finite().map(|u| f64::from(u[axis])).sum::<f64>() / count)
}

/// The largest component of any displacement about the mean (m).
fn largest_displacement(parts: &[Part]) -> f64 {
    let all = parts.iter().flat_map(|part| part.displacement.iter().flatten().flatten().flatten());
    let most = all.filter(|x| x.is_finite()).fold(0.0f32, |most, x| most.max(x.abs()));
    f64::from(most)
}
