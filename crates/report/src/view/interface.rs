//! Interfaces in the view: their faces, which move with the elements behind them.

use std::collections::HashMap;

use tremolite_results::{FieldFile, Pvd};

use super::manifest::Moment;
use super::part::{self, Part};

/// The interfaces at the view's times; none where the run has none.
///
/// # Errors
/// In words, if a file cannot be read.
pub fn read(pvd: &std::path::Path, moments: &[Moment], solids: &[Part]) -> Result<Vec<Part>, String> {
    if !pvd.exists() {
        return Ok(Vec::new());
    }
    let pvd = Pvd::read(pvd).map_err(|e| e.to_string())?;
    let mut parts = Vec::new();
    for (time, moment) in moments.iter().enumerate() {
        // Both lists were written from the same number, at the same step.
        let Some(snapshot) = pvd.snapshots().iter().find(|snapshot| snapshot.time == moment.t) else {
            continue;
        };
        let file = FieldFile::faces(&pvd.locate(snapshot)).map_err(|e| e.to_string())?;
        part::take(&mut parts, time, &file, 4, [0.0; 3]);
    }
    parts.iter_mut().for_each(|part| follow(part, moments.len(), solids));
    Ok(parts)
}

/// The name of an interface: the array that holds all of it.
pub fn name(part: &Part) -> Option<&str> {
    let count = part.mesh.elements.len();
    part.groups.iter().find(|(_, inside)| Part::size(inside) == count).map(|(name, _)| name.as_str())
}

/// Gives the points of an interface the displacement of the corner of the element behind that lies nearest.
fn follow(interface: &mut Part, times: usize, solids: &[Part]) {
    let mut home: HashMap<u32, (usize, usize)> = HashMap::new();
    for (k, part) in solids.iter().enumerate() {
        part.mesh.elements.iter().enumerate().for_each(|(cell, &number)| {
            home.insert(number, (k, cell));
        });
    }
    let mesh = &interface.mesh;
    let mut leader: Vec<Option<(usize, usize)>> = vec![None; mesh.points.len()];
    for (cell, number) in mesh.elements.iter().enumerate() {
        let Some(&(part, element)) = home.get(number) else { continue };
        let solid = &solids[part].mesh;
        for &point in mesh.cell(cell) {
            let place = mesh.points[point as usize];
            let away = |corner: u32| {
                let other = solid.points[corner as usize];
                (0..3).map(|i| (other[i] - place[i]).powi(2)).sum::<f64>()
            };
            let corners = solid.cell(element).iter().copied();
            let nearest = corners.min_by(|&a, &b| away(a).total_cmp(&away(b)));
            leader[point as usize] = nearest.map(|corner| (part, corner as usize));
        }
    }
    let of = |leader: &Option<(usize, usize)>, time: usize| {
        let (part, point) = (*leader)?;
        solids[part].displacement.get(time)?.as_ref()?.get(point).copied()
    };
    interface.displacement = (0..times)
        .map(|time| Some(leader.iter().map(|leader| of(leader, time).unwrap_or_default()).collect()))
        .collect();
}
