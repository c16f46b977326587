//! The mesh of a case: generated or read.

use std::path::Path;
use tremolite_case::{self as case, Problem};
use tremolite_mesh::boxes::{Axis, BoxSpec};
use tremolite_mesh::cavern::{Cavern, CavernShape, CavernSpec, Gallery, Ground, Lining, RockLayer};
use tremolite_mesh::note::Note;
use tremolite_mesh::{Mesh, read_with_notes};

/// The mesh in metres and what its user should know of it; nothing if it was refused, which is among the problems. Paths
/// of mesh files start from `directory`.
pub fn build(
    mesh: &case::Mesh,
    directory: &Path,
    problems: &mut Vec<Problem>,
) -> Option<(Mesh, Vec<Problem>)> {
    let (made, span, remedy) = match mesh {
        case::Mesh::Caverns(caverns) => {
            let made = spec(caverns).mesh_with_notes().map_err(|e| e.to_string());
            (made, &caverns.span, "change the description of the caverns if this is not meant")
        }
        case::Mesh::Box(bricks) => (boxed(bricks).map(|mesh| (mesh, Vec::new())), &bricks.span, ""),
        case::Mesh::File(file) => {
            let made = read_with_notes(directory.join(&file.path.value)).map_err(|e| e.to_string());
            let made = made.map(|(mesh, notes)| (scaled(mesh, file.unit.value), notes));
            (made, &file.path.span, "change the file if this is not meant")
        }
    };
    match made {
        Ok((mesh, notes)) => {
            let warning = |note: Note| Problem::new(span.clone(), note.to_string(), remedy);
            Some((mesh, notes.into_iter().map(warning).collect()))
        }
        Err(message) => {
            problems.push(Problem::new(span.clone(), message, "change the mesh as the message says"));
            None
        }
    }
}

fn spec(c: &case::Caverns) -> CavernSpec {
    let cavern = |c: &case::Cavern| Cavern {
        name: c.name.value.clone(),
        shape: match c.shape.value {
            case::CavernShape::Arch => CavernShape::Arch,
            case::CavernShape::Ellipse => CavernShape::Ellipse,
            case::CavernShape::Rectangle => CavernShape::Rectangle,
            case::CavernShape::Horseshoe => CavernShape::Horseshoe,
            case::CavernShape::Circle => CavernShape::Circle,
        },
        at: c.at.value,
        width: c.width.value,
        height: c.height.value,
        arch_rise: c.arch_rise.value,
        benches: c.benches.value,
        lining: c.lining.as_ref().map_or(Lining::NONE, |l| Lining {
            walls: l.walls.value,
            crown: l.crown.value,
            floor: l.floor.value,
            layers: l.layers.value,
        }),
    };
    let layer = |l: &case::RockLayer| RockLayer {
        name: l.name.value.clone(),
        depth: l.depth.value,
        dip: l.dip.value,
        dip_direction: l.dip_direction.value,
    };
    let gallery = |g: &case::Gallery| Gallery {
        name: g.name.value.clone(),
        between: g.between.each_ref().map(|b| b.value.clone()),
        at: g.at.value,
        width: g.width.value,
        height: g.height.value,
    };
    let ground = match &c.ground {
        None => Ground::Level,
        Some(case::Ground::Slope(slope)) => {
            let [x, y] = slope.value.map(f64::tan);
            Ground::Inclined { x, y }
        }
        Some(case::Ground::Heights { x, y, heights }) => {
            let y = if y.is_empty() { vec![0.0] } else { y.clone() };
            Ground::Table { x: x.clone(), y, heights: heights.clone() }
        }
    };
    CavernSpec {
        overburden: c.overburden.value,
        below: c.below.value,
        sides: c.sides.value,
        length: c.length.value,
        near: c.near.value,
        far: c.far.value,
        along: c.along.as_ref().map(|a| a.value),
        caverns: c.caverns.iter().map(cavern).collect(),
        layers: c.layers.iter().map(layer).collect(),
        ground,
        galleries: c.galleries.iter().map(gallery).collect(),
    }
}

fn boxed(bricks: &case::MeshBox) -> Result<Mesh, String> {
    let axis = |a: &case::Axis| Axis::Graded {
        from: a.from.value,
        to: a.to.value,
        elements: a.elements.value,
        ratio: a.growth.value,
    };
    let [x, y, z] = bricks.axes.each_ref().map(axis);
    let mut mesh = BoxSpec { x, y, z, distortion: None }.mesh().map_err(|e| e.to_string())?;
    mesh.groups = [(bricks.group.value.clone(), (0..mesh.elements.len() as u32).collect())].into();
    Ok(mesh)
}

fn scaled(mut mesh: Mesh, unit: f64) -> Mesh {
    mesh.nodes.iter_mut().chain(mesh.points.values_mut()).flatten().for_each(|x| *x *= unit);
    mesh
}
