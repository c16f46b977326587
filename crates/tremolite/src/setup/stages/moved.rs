//! The nodes that stages move.

use super::fitting;
use tremolite_case::{Case, Diagnostic, Displacement, Moved, Spanned, nearest};
use tremolite_engine::outer_faces::near;
use tremolite_engine::{Bed, Footing, Life, Prescribed, Stage};
use tremolite_mesh::Mesh;

/// Outer planes by name: the axis, and whether it is the upper one.
const PLANES: [(&str, usize, bool); 6] = [
    ("xmin", 0, false),
    ("xmax", 0, true),
    ("ymin", 1, false),
    ("ymax", 1, true),
    ("base", 2, false),
    ("top", 2, true),
];

/// What holds the sides and the base before the earthquake.
pub fn bed(case: &Case) -> Bed {
    let base = match case.initial.base.value {
        tremolite_case::BaseHold::Fixed => Footing::Fixed,
        tremolite_case::BaseHold::Roller => Footing::Roller,
        tremolite_case::BaseHold::Free => Footing::Free,
    };
    let rollers = case.initial.sides.each_ref().map(|side| side.value == tremolite_case::SideHold::Roller);
    Bed { rollers, base }
}

/// The displacements of each stage, the initial equilibrium first: what any stage moves is held from there on.
pub(super) fn prescribed(case: &Case, mesh: &Mesh, shown: &[u32]) -> Vec<Prescribed> {
    let Some(first) = case.stages.first() else { return Vec::new() };
    let at_start = |one: &Displacement| Displacement { to: one.to.map(|to| to.map(|_| 0.0)), ..one.clone() };
    let start: Vec<Displacement> = first.displacements.iter().map(at_start).collect();
    let all: Vec<Vec<(u32, u8)>> = start.iter().map(|one| corners(one, mesh, shown)).collect();
    let stages = std::iter::once(&start).chain(case.stages.iter().map(|stage| &stage.displacements));
    let lives = (0..=case.stages.len()).map(|k| {
        let next = if k < case.stages.len() { Stage::Before(k as u16 + 1) } else { Stage::Shaking };
        Life { born: Stage::Before(k as u16), gone: Some(next) }
    });
    let of_stage = |(life, stage): (Life, &Vec<Displacement>)| -> Vec<Prescribed> {
        let each = stage.iter().zip(&all);
        each.map(|(one, corners)| Prescribed {
            name: one.name.clone(),
            corners: corners.clone(),
            to: one.to,
            life,
        })
        .collect()
    };
    lives.zip(stages).flat_map(of_stage).collect()
}

/// What moves nothing, as nothing of it stands in its stage: `standing` are the elements that do in the k-th stage, the initial
/// equilibrium being none.
pub(super) fn gone(case: &Case, k: usize, mesh: &Mesh, standing: &[u32], shown: &[u32]) -> Vec<Diagnostic> {
    let Some(stage) = k.checked_sub(1).map(|k| &case.stages[k]).filter(|stage| stage.moves) else {
        return Vec::new();
    };
    let mut there = vec![false; mesh.nodes.len()];
    for &e in standing {
        mesh.elements[e as usize].nodes().iter().for_each(|&node| there[node as usize] = true);
    }
    let stands = |one: &&Displacement| {
        corners(one, mesh, shown).into_iter().any(|(e, bits)| {
            let nodes = mesh.elements[e as usize].nodes().iter().enumerate();
            nodes.filter(|(k, _)| bits >> k & 1 == 1).any(|(_, &node)| there[node as usize])
        })
    };
    let told = stage.displacements.iter().filter(|one| !stands(one));
    told.map(|one| {
        let what = format!(
            "nothing of '{}' stands in the stage '{}', so nothing is moved",
            one.name, stage.name.value
        );
        Diagnostic::new(one.span.clone(), what, "name what stands there")
    })
    .collect()
}

/// Elements with those of their nodes that are meant; `shown` has each element's number in the mesh as it was read.
fn corners(one: &Displacement, mesh: &Mesh, shown: &[u32]) -> Vec<(u32, u8)> {
    let bounds = mesh.bounds();
    let near = near(bounds);
    let inside = |node: u32| {
        let x = mesh.nodes[node as usize];
        let mut ranges = x.iter().zip(&one.within);
        ranges.all(|(x, range)| range.is_none_or(|[low, high]| (low - near..=high + near).contains(x)))
    };
    let of = |e: u32, keep: &dyn Fn(usize, u32) -> bool| {
        let nodes = mesh.elements[e as usize].nodes().iter().enumerate();
        let bits =
            nodes.filter(|&(k, &node)| inside(node) && keep(k, node)).fold(0u8, |bits, (k, _)| bits | 1 << k);
        (bits != 0).then_some((e, bits))
    };
    let all = 0..mesh.elements.len() as u32;
    match &one.of {
        Moved::Group(group) => {
            let mut fits = vec![false; mesh.elements.len()];
            let own = fitting(group, mesh, &mut Vec::new()).unwrap_or_default();
            own.into_iter().for_each(|e| fits[e as usize] = true);
            all.filter(|&e| fits[shown[e as usize] as usize]).filter_map(|e| of(e, &|_, _| true)).collect()
        }
        Moved::Face(face) => match (mesh.faces.get(&face.value), plane(face)) {
            (_, Some((axis, upper))) => {
                let level = [bounds.0, bounds.1][usize::from(upper)][axis];
                let on = |_, node: u32| (mesh.nodes[node as usize][axis] - level).abs() <= near;
                all.filter_map(|e| of(e, &on)).collect()
            }
            (Some(faces), None) => {
                let mut marked = vec![0u8; mesh.elements.len()];
                for face in faces {
                    let element = &mesh.elements[face.element as usize];
                    let sides = element.shape.faces()[face.side as usize].iter();
                    sides.for_each(|&k| marked[face.element as usize] |= 1 << k);
                }
                let on = |e: u32| move |k: usize, _| e >> k & 1 == 1;
                all.filter_map(|e| of(e, &on(u32::from(marked[shown[e as usize] as usize])))).collect()
            }
            (None, None) => Vec::new(),
        },
    }
}

fn plane(face: &Spanned<String>) -> Option<(usize, bool)> {
    PLANES.iter().find(|(name, ..)| *name == face.value).map(|&(_, axis, upper)| (axis, upper))
}

/// Displacement over the mesh's extent beyond which it is a slip, or not small.
const MOST: f64 = 0.1;

/// Ways that are beyond small displacements.
fn far(case: &Case, mesh: &Mesh, problems: &mut Vec<Diagnostic>) {
    let (low, high) = mesh.bounds();
    let extent = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
    let moved = case.stages.iter().filter(|stage| stage.moves).flat_map(|stage| &stage.displacements);
    let mut told: Vec<&str> = Vec::new();
    for one in moved {
        let most = one.to.iter().flatten().fold(0.0, |most: f64, to| most.max(to.abs()));
        if most > MOST * extent && !told.contains(&one.name.as_str()) {
            told.push(&one.name);
            problems.push(Diagnostic::new(
                one.span.clone(),
                format!("'{}' is moved by {most} m, and the mesh is {extent} m large: displacements must be small", one.name),
                "check the unit, \"0.5 mm\" for one",
            ));
        }
    }
}

/// Displacements that mean no node, one that another means as well, or go too far; `solid` says which elements are made of something.
pub fn check_moved(case: &Case, mesh: &Mesh, solid: &[bool], problems: &mut Vec<Diagnostic>) {
    let Some(first) = case.stages.first() else { return };
    far(case, mesh, problems);
    let own: Vec<u32> = (0..mesh.elements.len() as u32).collect();
    let mut by: Vec<[Option<usize>; 3]> = vec![[None; 3]; mesh.nodes.len()];
    for (k, one) in first.displacements.iter().enumerate() {
        if let Moved::Group(group) = &one.of
            && fitting(group, mesh, problems).is_none()
        {
            continue;
        }
        if let Moved::Face(face) = &one.of
            && plane(face).is_none()
            && !mesh.faces.contains_key(&face.value)
        {
            let known = || PLANES.iter().map(|(name, ..)| *name).chain(mesh.faces.keys().map(String::as_str));
            let meant = nearest(&face.value, known())
                .map_or(String::new(), |name| format!("did you mean '{name}'? "));
            let mut all: Vec<&str> = known().collect();
            all.sort_unstable();
            all.dedup();
            problems.push(Diagnostic::at(
                face,
                format!("the mesh has no face '{}'", face.value),
                format!("{meant}there are {}", all.join(", ")),
            ));
            continue;
        }
        let nodes: Vec<u32> = corners(one, mesh, &own)
            .into_iter()
            .filter(|(e, _)| solid[*e as usize])
            .flat_map(|(e, bits)| {
                let nodes = mesh.elements[e as usize].nodes().iter().enumerate();
                nodes.filter(move |(k, _)| bits >> k & 1 == 1).map(|(_, &node)| node)
            })
            .collect();
        if nodes.is_empty() {
            let remedy = match one.within == [None; 3] {
                true => "it is void there: name what stands",
                false => {
                    "widen `within` so that nodes lie in it: `tremolite mesh info` gives the mesh's extents"
                }
            };
            let what = format!("'{}' means no node of what is there", one.name);
            problems.push(Diagnostic::new(one.span.clone(), what, remedy));
            continue;
        }
        let ways = |i: &usize| one.to[*i].is_some();
        let other = nodes.iter().flat_map(|&node| (0..3).filter(ways).map(move |i| (node, i)));
        let apart = |known: usize, i: usize| {
            case.stages.iter().any(|stage| stage.displacements[known].to[i] != stage.displacements[k].to[i])
        };
        let clash = other.clone().find_map(|(node, i)| {
            by[node as usize][i].filter(|&known| known != k && apart(known, i)).map(|known| (known, node))
        });
        if let Some((known, node)) = clash {
            let known = &first.displacements[known].name;
            let [x, y, z] = mesh.nodes[node as usize];
            problems.push(Diagnostic::new(
                one.span.clone(),
                format!("'{}' and '{known}' move the same component of the node at ({x:.4}, {y:.4}, {z:.4}) m to different places", one.name),
                "let their nodes differ (`within`), or leave the component out of one",
            ));
        }
        other.for_each(|(node, i)| by[node as usize][i] = Some(k));
    }
}
