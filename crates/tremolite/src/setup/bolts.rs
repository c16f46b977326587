//! Where bolts come from: patterns on what a stage lays bare, points, files.

mod doubtful;
mod heads;
mod listed;
mod opening;
mod pattern;
mod slice;
mod wall;

use super::changes::before;
use super::groups::nothing_fits;
use super::memory::Inputs;
use super::stages::Staged;
use crate::plan::BoltMonitor;
use heads::Heads;
use listed::{Listed, Outside, Standing};
use opening::{Opening, openings};
use pattern::{Laid, lay};
use std::f64::consts::PI;
use std::path::Path;
use tremolite_case::{self as case, BoltPattern, BoltPlace, Case, Diagnostic, Place, Spanned, units};
use tremolite_engine::{Bar, Bolts, Bond, Stage};
use tremolite_laws::Dimension;
use tremolite_mesh::Mesh;
use tremolite_mesh::locate::Locator;
use wall::{minus, norm};

/// Bolts of a pattern beyond which its spacing is a slip in the unit.
const MOST_BOLTS: f64 = 200_000.0;
/// Segments beyond which the longest one is.
const MOST_SEGMENTS: f64 = 5e6;
/// Heads apart over the smaller spacing, at least.
const APART: f64 = 0.5;
/// The bolts of a case.
pub struct Placed {
    /// In the order of [`Case::bolts`]; a pattern that found no face has no bars.
    pub bolts: Vec<Bolts>,
    pub warnings: Vec<Diagnostic>,
}

/// Makes the bolts of a case. Those that cannot be placed are among the problems.
pub fn build(
    case: &Case,
    mesh: &Mesh,
    staged: &Staged,
    held: &Inputs,
    problems: &mut Vec<Diagnostic>,
) -> Placed {
    let mut placed = Placed { bolts: Vec::new(), warnings: Vec::new() };
    let listed: Vec<Vec<Listed>> =
        case.bolts().map(|(_, bolts)| listed(case, bolts, held, problems)).collect();
    let patterns = case.bolts().filter_map(|(_, bolts)| match &bolts.place {
        BoltPlace::Pattern(pattern) => Some(pattern),
        _ => None,
    });
    for written in patterns.flat_map(|pattern| &pattern.on) {
        if !mesh.groups.keys().any(|name| case::pattern::matches(written, name)) {
            problems.push(nothing_fits(mesh, written));
        }
    }
    // Who stands when is not known before all stages are good.
    if listed.is_empty() || !problems.is_empty() {
        return placed;
    }
    let mut systems: Vec<(System, Heads)> = Vec::new();
    let mut bare: Option<(usize, Vec<Opening>)> = None;
    let mut standing: Option<(usize, Locator)> = None;
    for ((k, written), listed) in case.bolts().zip(listed) {
        if standing.as_ref().is_none_or(|(of, _)| *of != k) {
            let elements: Vec<u32> =
                (0..mesh.elements.len() as u32).filter(|&e| staged.stands(e, before(k))).collect();
            standing = Some((k, Locator::new(mesh, Some(&elements))));
        }
        let Some((_, locator)) = &standing else { continue };
        let ground = Standing { locator };
        let ends = match &written.place {
            BoltPlace::Pattern(pattern) => {
                // Bolts may follow once a part of the stress has gone: what is bare is what the last excavation made.
                let made = case.stages.iter().take(k + 1).rposition(|stage| !stage.excavate.is_empty());
                let made = made.unwrap_or(k);
                if bare.as_ref().is_none_or(|(of, _)| *of != made) {
                    bare = Some((made, openings(mesh, staged, made)));
                }
                let openings = bare.as_ref().map_or(&[][..], |(_, openings)| openings);
                let heads = heads_of(&mut systems, pattern);
                patterned(mesh, &written.name, pattern, openings, heads, problems, &mut placed.warnings)
            }
            _ => pointed(&ground, written, &case.stages[k].name, listed, problems),
        };
        problems.extend(doubtful::pulled_out(written, &ends));
        placed.warnings.extend(doubtful::units(written));
        placed.warnings.extend(doubtful::coarse(&ground, written, &ends));
        placed
            .warnings
            .extend(doubtful::buried(&ground, written, &ends, |e| staged.places[e as usize].is_later()));
        too_many(written, &ends, problems);
        placed.bolts.push(made(written, ends, before(k)));
    }
    placed
}

/// Monitors at bolts that could be placed; the others are among the problems.
pub fn monitors(case: &Case, mesh: &Mesh, problems: &mut Vec<Diagnostic>) -> Vec<BoltMonitor> {
    let mut monitors = Vec::new();
    for monitor in &case.monitors {
        let Some(bolt) = &monitor.bolt else { continue };
        let point = match &monitor.at.value {
            Place::Point(point) => Some(*point),
            Place::Named(name) => super::monitors::named(mesh, name, &monitor.at.span, problems),
        };
        if let Some(point) = point {
            monitors.push(BoltMonitor { name: monitor.name.value.clone(), point, set: bolt.value });
        }
    }
    monitors
}

/// Bolts that are to keep apart are those of one spacing and length, whatever entry they are of. Longer ones may stand among
/// shorter ones.
#[derive(Clone, PartialEq)]
struct System {
    spacing: [f64; 2],
    length: f64,
}

/// The heads that a pattern has to keep away from: those of its system, of this stage and earlier ones.
fn heads_of<'a>(systems: &'a mut Vec<(System, Heads)>, pattern: &BoltPattern) -> &'a mut Heads {
    let system = System { spacing: pattern.spacing.value, length: pattern.length.value };
    let at = systems.iter().position(|(other, _)| *other == system).unwrap_or_else(|| {
        let apart = APART * system.spacing[0].min(system.spacing[1]);
        systems.push((system, Heads::new(apart)));
        systems.len() - 1
    });
    &mut systems[at].1
}

fn patterned(
    mesh: &Mesh,
    name: &str,
    pattern: &BoltPattern,
    openings: &[Opening],
    heads: &mut Heads,
    problems: &mut Vec<Diagnostic>,
    warnings: &mut Vec<Diagnostic>,
) -> Vec<[[f64; 3]; 2]> {
    let mut on = vec![pattern.on.is_empty(); mesh.elements.len()];
    for (name, elements) in &mesh.groups {
        if pattern.on.iter().any(|written| case::pattern::matches(written, name)) {
            elements.iter().for_each(|&e| on[e as usize] = true);
        }
    }
    let [along, around] = pattern.spacing.value;
    let area: f64 = openings.iter().flat_map(|opening| &opening.walls).map(|wall| wall.area).sum();
    if area / along / around > MOST_BOLTS {
        problems.push(Diagnostic::at(
            &pattern.spacing,
            format!("the pattern would place some {:.1e} bolts on {area:.0} m2", area / along / around),
            "look at the unit of the spacing; 1 m to 3 m is usual",
        ));
        return Vec::new();
    }
    let mut laid = Laid::default();
    let mut faces = 0;
    for opening in openings {
        let chosen: Vec<bool> =
            opening.sides.iter().map(|sides| sides.iter().any(|&e| on[e as usize])).collect();
        faces += chosen.iter().filter(|&&chosen| chosen).count();
        lay(pattern, &opening.walls, &chosen, heads, &mut laid);
    }
    if laid.bolts.is_empty() {
        let (message, remedy) = if faces == 0 {
            (
                "no bolts are placed: none of these faces are laid bare by the stage, or by the last one before it that excavates",
                "name in `on` what it excavates, or leave it out",
            )
        } else if laid.along > 0 {
            (
                "no bolts are placed: the direction runs along the wall everywhere",
                "give another direction, or \"normal\"",
            )
        } else {
            (
                "no bolts are placed: no exposed face looks that way, or it is bolted already",
                "take another pattern, or a smaller spacing",
            )
        };
        warnings.push(Diagnostic::at(&pattern.faces, format!("'{name}': {message}"), remedy));
    } else if let (true, Some(direction)) = (laid.along > 0, &pattern.direction) {
        warnings.push(Diagnostic::at(
            direction,
            format!(
                "{} places have no bolt, since it would run along the wall there, within 5 degrees",
                laid.along
            ),
            "bolt them by an entry of its own, with another direction",
        ));
    }
    laid.bolts
}

/// The bolts that a case or its file lists, those of a pattern not among them.
fn listed(case: &Case, written: &case::Bolts, held: &Inputs, problems: &mut Vec<Diagnostic>) -> Vec<Listed> {
    match &written.place {
        BoltPlace::Pattern(_) => Vec::new(),
        BoltPlace::Points(points) => points
            .iter()
            .enumerate()
            .map(|(k, ends)| Listed { name: format!("bolt {}", k + 1), ends: ends.value })
            .collect(),
        BoltPlace::File(file) => match of_file(case, &file.value, held) {
            Ok(bolts) => bolts,
            Err(message) => {
                let remedy = "a bolt a row: x1,y1,z1,x2,y2,z2 in m, its head at the wall first";
                problems.push(Diagnostic::at(file, message, remedy));
                Vec::new()
            }
        },
    }
}

fn of_file(case: &Case, file: &Path, held: &Inputs) -> Result<Vec<Listed>, String> {
    let name = file.display().to_string();
    if let Some(bolts) = held.bolts(file) {
        return listed::of_ends(&name, bolts);
    }
    let text =
        std::fs::read_to_string(case.resolve(file)).map_err(|e| format!("{name} cannot be read: {e}"))?;
    listed::parse(&name, &text)
}

/// Listed bolts, refused where they lie in nothing that stands.
fn pointed(
    ground: &Standing,
    written: &case::Bolts,
    stage: &Spanned<String>,
    listed: Vec<Listed>,
    problems: &mut Vec<Diagnostic>,
) -> Vec<[[f64; 3]; 2]> {
    let free = written.free_length.as_ref().map_or(0.0, |free| free.value);
    let mut bars = Vec::new();
    for (k, bolt) in listed.into_iter().enumerate() {
        let span = match &written.place {
            BoltPlace::Points(points) => points.get(k).map_or(written.span.clone(), |p| p.span.clone()),
            BoltPlace::File(file) => file.span.clone(),
            BoltPlace::Pattern(_) => written.span.clone(),
        };
        let whole = norm(minus(bolt.ends[1], bolt.ends[0]));
        if free >= whole && !written.plate.value.ends()[1] {
            let length = |x: f64| units::format(x, Dimension::LENGTH);
            problems.push(Diagnostic::new(
                span,
                format!(
                    "{} is {} long, all of it free: nothing holds its other end",
                    bolt.name,
                    length(whole)
                ),
                "make the free length shorter, or write plate = \"both\"",
            ));
            continue;
        }
        let place = |[x, y, z]: [f64; 3]| format!("({x:.3}, {y:.3}, {z:.3}) m");
        match ground.place(bolt.ends, free) {
            Ok(ends) => bars.push(ends),
            Err(Outside::End(end, at)) => problems.push(Diagnostic::new(
                span,
                format!(
                    "{}: {end} at {} lies in nothing that stands in '{}'",
                    bolt.name,
                    place(at),
                    stage.value
                ),
                if free >= whole {
                    "a tie across an opening has its ends a few centimetres inside the ground"
                } else {
                    "put it into the rock, or on the wall to a centimetre; what the stage excavates is gone"
                },
            )),
            Err(Outside::Leaves(at, distance)) => problems.push(Diagnostic::new(
                span,
                format!(
                    "{} leaves what stands in '{}' at {}, {distance:.3} m from its head",
                    bolt.name,
                    stage.value,
                    place(at)
                ),
                "let it end there, or let a free length, with a plate, reach beyond the void",
            )),
        }
    }
    bars
}

fn too_many(written: &case::Bolts, ends: &[[[f64; 3]; 2]], problems: &mut Vec<Diagnostic>) {
    let Some(segment) = written.bond.as_ref().and_then(|bond| bond.segment.as_ref()) else { return };
    let length: f64 = ends.iter().map(|[a, b]| norm(minus(*b, *a))).sum();
    if length / segment.value > MOST_SEGMENTS {
        problems.push(Diagnostic::at(
            segment,
            format!("{length:.0} m of bolts would be cut into some {:.1e} segments", length / segment.value),
            "give a longer segment: half of √(EA/stiffness) resolves the bond",
        ));
    }
}

/// The bolts as the engine takes them.
fn made(written: &case::Bolts, ends: Vec<[[f64; 3]; 2]>, born: Stage) -> Bolts {
    let given = |value: &Option<Spanned<f64>>, otherwise: f64| value.as_ref().map_or(otherwise, |x| x.value);
    let area = written.area();
    let bar = |ends: [[f64; 3]; 2]| Bar { points: ends.to_vec(), areas: vec![area] };
    Bolts {
        name: written.name.value.clone(),
        bars: ends.into_iter().map(bar).collect(),
        young: written.young.value,
        yields: given(&written.yields, f64::INFINITY),
        breaks: given(&written.breaking_strain, f64::INFINITY),
        bond: written.bond.as_ref().map(|bond| Bond {
            stiffness: bond.stiffness.value,
            strength: bond.strength.value,
            friction: bond.friction_angle.value.tan(),
            perimeter: PI * written.diameter.value,
            segment: given(&bond.segment, f64::INFINITY),
        }),
        pretension: given(&written.pretension, 0.0),
        free_length: given(&written.free_length, 0.0),
        plates: written.plate.value.ends(),
        born,
    }
}
