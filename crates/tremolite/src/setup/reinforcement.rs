//! Reinforcement of a case: bars laid into the stacks of a lining, edge to edge, and joined to chains.

mod doubtful;

use super::groups::nothing_fits;
use crate::sections::{Station, stations};
use doubtful::{Laid, not_in_slabs, too_much, too_thick, too_thin, twice};
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use tremolite_case::{BarDirection, BarFace, Case, Diagnostic, Reinforcement, pattern};
use tremolite_engine::{Bar, Bolts, Life, Stage};
use tremolite_mesh::{Mesh, Shape};

type Point = [f64; 3];

/// A straight bar across one stack.
struct Leg {
    ends: [Point; 2],
    /// m²
    area: f64,
}

/// The bars of all reinforcement of a case, a set for each stage in which some of them begin. `lives` says when something of its
/// own stands in the place of each element of the mesh, `solid` whether any does. With what is unusual about it.
pub fn build(
    case: &Case,
    mesh: &Mesh,
    lives: &[Life],
    solid: &[bool],
    problems: &mut Vec<Diagnostic>,
) -> (Vec<Bolts>, Vec<Diagnostic>) {
    let standing: Vec<bool> =
        lives.iter().zip(solid).map(|(life, solid)| *solid && life.holds(Stage::Shaking)).collect();
    let (mut all, mut warnings) = (Vec::new(), Vec::new());
    let mut laid = Laid::new();
    let bounds = mesh.bounds();
    for steel in &case.reinforcement {
        let Some(groups) = groups(steel, mesh, solid, problems) else { continue };
        let mut legs: BTreeMap<Stage, Vec<Leg>> = BTreeMap::new();
        let (mut count, mut without) = (0, 0);
        let before = problems.len();
        for (name, elements) in &groups {
            let stations = stations(mesh, elements, &standing);
            let inside: HashSet<u32> =
                stations.iter().flat_map(|s| s.stack.iter().map(|(e, _)| *e)).collect();
            count += elements.len();
            without += elements.len() - inside.len();
            if let Some(problem) =
                too_thin(steel, name, &stations).or_else(|| too_thick(steel, name, &stations))
            {
                problems.push(problem);
                break;
            }
            warnings.extend(too_much(steel, name, &stations).filter(|_| warnings.is_empty()));
            if let Some(problem) = twice(steel, name, elements, &mut laid) {
                problems.push(problem);
                break;
            }
            let all = legs_of(steel, &stations);
            let at_sides = |(station, leg): &(&Station, Leg)| {
                let nodes = station.stack.iter().flat_map(|(e, _)| mesh.elements[*e as usize].nodes());
                not_in_slabs(case, steel, bounds, nodes.map(|&n| mesh.nodes[n as usize]), &leg.ends)
            };
            warnings.extend(all.iter().find_map(at_sides));
            for (station, leg) in all {
                let born = station.stack.iter().map(|(e, _)| lives[*e as usize].born).max();
                legs.entry(born.unwrap_or(Stage::Before(0))).or_default().push(leg);
            }
        }
        if problems.len() > before {
            continue;
        }
        if legs.is_empty() {
            let names: Vec<&str> = groups.iter().map(|(name, _)| *name).collect();
            problems.extend(steel.on.first().map(|on| {
                Diagnostic::at(
                    on,
                    format!("{} has no thickness that bars could lie in", names.join(", ")),
                    "name groups of hexahedra that are thin one way, as linings are",
                )
            }));
            continue;
        }
        if without > 0 {
            warnings.push(Diagnostic::new(
                steel.span.clone(),
                format!("{without} of {count} elements get no bars: where walls meet there is no thickness"),
                "give rounder corners, or take it that bars end there",
            ));
        }
        let name = match &steel.name {
            Some(name) => name.value.clone(),
            None => groups.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", "),
        };
        let several = legs.len() > 1;
        all.extend(legs.into_iter().map(|(born, legs)| Bolts {
            name: if several { format!("{name} {}", when(case, born)) } else { name.clone() },
            bars: chains(&legs),
            young: steel.young.value,
            yields: steel.yields.as_ref().map_or(f64::INFINITY, |y| y.value),
            breaks: steel.breaks.as_ref().map_or(f64::INFINITY, |b| b.value),
            bond: None,
            pretension: 0.0,
            free_length: 0.0,
            plates: [false; 2],
            born,
        }));
    }
    (all, warnings)
}

/// From when on bars are there.
fn when(case: &Case, born: Stage) -> String {
    match born {
        Stage::Before(k) => match usize::from(k).checked_sub(1).and_then(|k| case.stages.get(k)) {
            Some(stage) => format!("of {}", stage.name.value),
            None => "from the start".to_owned(),
        },
        Stage::Shaking => "of the earthquake".to_owned(),
    }
}

/// Gives groups of bolts that share a name a number behind it: tables go by names.
pub fn tell_apart(all: &mut [Bolts]) {
    let mut known: BTreeSet<String> = BTreeSet::new();
    for bolts in all {
        let name = bolts.name.clone();
        let mut next = 2;
        while !known.insert(bolts.name.clone()) {
            bolts.name = format!("{name} {next}");
            next += 1;
        }
    }
}

/// The groups that are reinforced, each with its elements, without those that a larger one holds; none if they do not fit.
fn groups<'m>(
    steel: &Reinforcement,
    mesh: &'m Mesh,
    solid: &[bool],
    problems: &mut Vec<Diagnostic>,
) -> Option<Vec<(&'m str, &'m [u32])>> {
    let before = problems.len();
    let mut fitting: Vec<(&str, &[u32], usize)> = Vec::new();
    for (k, on) in steel.on.iter().enumerate() {
        let known = fitting.len();
        let fits = mesh.groups.iter().filter(|(name, _)| pattern::matches(on, name));
        fitting.extend(fits.map(|(name, elements)| (name.as_str(), elements.as_slice(), k)));
        if fitting.len() == known {
            problems.push(nothing_fits(mesh, on));
        }
        let found =
            fitting[known..].iter().flat_map(|(name, elements, _)| elements.iter().map(move |e| (name, *e)));
        let refused = found.clone().find(|(_, e)| mesh.elements[*e as usize].shape != Shape::Hex8);
        if let Some((name, e)) = refused {
            problems.push(Diagnostic::at(
                on,
                format!("element {} of '{name}' is no hexahedron", mesh.element_id(e as usize)),
                "bars are laid through hexahedra alone: mesh the group with them, or leave it out",
            ));
        } else if let Some((name, e)) = found.clone().find(|(_, e)| !solid[*e as usize]) {
            problems.push(Diagnostic::at(
                on,
                format!("element {} of '{name}' is void", mesh.element_id(e as usize)),
                "name groups that are made of a material",
            ));
        }
    }
    // Largest first; of two alike, the first.
    fitting.sort_by_key(|(_, elements, _)| std::cmp::Reverse(elements.len()));
    let mut taken: HashMap<u32, &str> = HashMap::new();
    let mut kept: Vec<(&str, &[u32])> = Vec::new();
    for (name, elements, k) in fitting {
        let new = elements.iter().filter(|e| !taken.contains_key(e)).count();
        if new == elements.len() {
            taken.extend(elements.iter().map(|&e| (e, name)));
            kept.push((name, elements));
        } else if new > 0 {
            let other = elements.iter().find_map(|e| taken.get(e)).copied().unwrap_or_default();
            problems.push(Diagnostic::at(
                &steel.on[k],
                format!("'{name}' and '{other}' share elements, which would be reinforced twice"),
                "name groups that do not overlap, or give each a [[reinforcement]] of its own",
            ));
        }
    }
    kept.sort_unstable();
    (problems.len() == before).then_some(kept)
}

/// That the cover leaves no room for the bars in the thinnest station.
/// The way from the middle of one edge to that of the opposite one, between corners of a face that lie so.
fn way(station: &Station, k: usize, face: usize) -> [Point; 2] {
    let corners = &station.faces[face];
    let middle = |a: usize, b: usize| [0, 1, 2].map(|i| 0.5 * (corners[a][i] + corners[b][i]));
    // 0: from the edge 0–3 to 1–2; 1: from 0–1 to 3–2.
    if k == 0 { [middle(0, 3), middle(1, 2)] } else { [middle(0, 1), middle(3, 2)] }
}

/// The legs of all stations, one for each face that is reinforced, neighbours ending at one point.
fn legs_of<'s>(steel: &Reinforcement, stations: &'s [Station]) -> Vec<(&'s Station, Leg)> {
    // Where a bar enters or leaves a stack: on the line from face to face through the middles of two edges. There the
    // thickness is the mean of those of the stacks that meet, so that in a corner each has its cover.
    let bits = |x: Point| x.map(f64::to_bits);
    let key = |[extrados, intrados]: [Point; 2]| (bits(extrados), bits(intrados));
    let mut thick: HashMap<([u64; 3], [u64; 3]), (f64, f64)> = HashMap::new();
    let lines = |station: &Station| -> [[Point; 2]; 2] {
        let k = across(station, steel.direction.value);
        let [extrados, intrados] = [0, 1].map(|face| way(station, k, face));
        [0, 1].map(|end| [extrados[end], intrados[end]])
    };
    for station in stations {
        for line in lines(station) {
            let through = dot(minus(line[1], line[0]), station.normal).abs();
            let sum = thick.entry(key(line)).or_default();
            *sum = (sum.0 + through, sum.1 + 1.0);
        }
    }
    let mut legs = Vec::new();
    for station in stations {
        let k = across(station, steel.direction.value);
        // Per metre across the bars, measured in the mid-surface.
        let [ways, sides] = [k, 1 - k].map(|k| {
            let middle = [0, 1].map(|face| way(station, k, face)).map(|[a, b]| minus(b, a));
            [0, 1, 2].map(|i| 0.5 * (middle[0][i] + middle[1][i]))
        });
        let width = norm(cross(ways, sides)) / norm(ways);
        for (face, wanted) in [(1, BarFace::Intrados), (0, BarFace::Extrados)] {
            if steel.face.value != BarFace::Both && steel.face.value != wanted {
                continue;
            }
            let ends = lines(station).map(|line| {
                let (sum, count) = thick[&key(line)];
                let share = steel.cover.value * count / sum;
                let (from, to) = (line[face], line[1 - face]);
                [0, 1, 2].map(|i| from[i] + share * (to[i] - from[i]))
            });
            legs.push((station, Leg { ends, area: steel.area.value * width }));
        }
    }
    legs
}

/// Which of the two ways within a station's faces bars go.
fn across(station: &Station, direction: BarDirection) -> usize {
    let aligned = [0, 1].map(|k| {
        let [a, b] = way(station, k, 0);
        let way = minus(b, a);
        dot(way, station.along).abs() / norm(way)
    });
    let round = usize::from(aligned[1] > aligned[0]);
    match direction {
        BarDirection::Across => round,
        BarDirection::Along => 1 - round,
    }
}

/// Joins legs that end at one point, two of them, to bars. Legs keep their order as far as they can.
fn chains(legs: &[Leg]) -> Vec<Bar> {
    let bits = |x: Point| x.map(f64::to_bits);
    let mut at: HashMap<[u64; 3], Vec<usize>> = HashMap::new();
    for (l, leg) in legs.iter().enumerate() {
        leg.ends.iter().for_each(|x| at.entry(bits(*x)).or_default().push(l));
    }
    let next = |l: usize, end: Point| match at[&bits(end)][..] {
        [a, b] if a != b => Some(if a == l { b } else { a }),
        _ => None,
    };
    let other = |l: usize, end: Point| legs[l].ends[usize::from(legs[l].ends[0] == end)];
    let mut used = HashSet::new();
    let mut bars = Vec::new();
    // First those that have an end, from there; then what is left is closed.
    let ended =
        (0..legs.len()).filter_map(|l| legs[l].ends.iter().find(|x| next(l, **x).is_none()).map(|x| (l, *x)));
    let rings = (0..legs.len()).map(|l| (l, legs[l].ends[0]));
    for (start, end) in ended.chain(rings) {
        if used.contains(&start) {
            continue;
        }
        let (mut l, mut end) = (start, end);
        let mut bar = Bar { points: vec![end], areas: Vec::new() };
        while used.insert(l) {
            end = other(l, end);
            bar.points.push(end);
            bar.areas.push(legs[l].area);
            let Some(following) = next(l, end) else { break };
            l = following;
        }
        bars.push(bar);
    }
    bars
}

fn dot(a: Point, b: Point) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

fn minus(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn norm(a: Point) -> f64 {
    dot(a, a).sqrt()
}

fn cross(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}

#[cfg(test)]
mod tests;
