//! The mesh of a case: generated or read.

use super::memory::{Inputs, in_memory};
use super::{holes, places, planes};
use std::ops::Range;
use std::path::Path;
use tremolite_case::{self as case, Diagnostic, NO_FORMULA, begins_a_formula};
use tremolite_files::text::encoding as encoding_of;
use tremolite_mesh::boxes::{Axis, BoxSpec};
use tremolite_mesh::cavern::{
    Cavern, CavernShape, CavernSpec, Gallery, GroundSurface, Lining, RockLayer, Shotcrete,
};
use tremolite_mesh::note::Note;
use tremolite_mesh::placement::Placement;
use tremolite_mesh::places::Taken;
use tremolite_mesh::read::read_encoded;
use tremolite_mesh::{Mesh, sound};

/// A mesh in metres, and what its user should know of it.
pub struct Built {
    pub mesh: Mesh,
    pub warnings: Vec<Diagnostic>,
    /// Of nodes at one place that are not joined, which may be meant.
    pub doubled: Option<Diagnostic>,
    /// What groups by place took.
    pub taken: Vec<Taken>,
}

/// The mesh in metres and what its user should know of it; nothing if it was refused, which is among the problems. Paths
/// of mesh files start from `directory`; what is `held` in memory is not looked for there. Planes leave linings whole that `interfaces`
/// separate from the rock. Sides that are `free` need not match one another.
pub fn build(
    mesh: &case::Mesh,
    ground: &case::Ground,
    interfaces: &[case::Interface],
    free: [bool; 2],
    directory: &Path,
    held: &Inputs,
    problems: &mut Vec<Diagnostic>,
) -> Option<Built> {
    let before = problems.len();
    let mut built = made(mesh, directory, held, problems)?;
    let cut = planes::cut_by(mesh, &ground.planes, interfaces, free, &mut built.mesh, problems);
    if problems.len() > before {
        return None;
    }
    built.warnings.extend(cut);
    let overlays: Vec<String> = ground.planes.iter().flat_map(planes::groups_of).collect();
    built.taken = places::group(mesh, &ground.groups, &overlays, &mut built.mesh, problems);
    holes::line(&ground.linings, &mut built.mesh, problems);
    if let Err(why) = held.add_groups(&mut built.mesh) {
        problems.push(Diagnostic::new(
            0..0,
            why,
            "give the group another name, or the elements of this mesh",
        ));
    }
    refuse_formulas(mesh, &built.mesh, problems);
    (problems.len() == before).then_some(built)
}

/// Groups head the columns of tables.
fn refuse_formulas(mesh: &case::Mesh, built: &Mesh, problems: &mut Vec<Diagnostic>) {
    let case::Mesh::File(file) = mesh else { return };
    if let Some((name, _)) = built.groups.iter().find(|(name, _)| begins_a_formula(name)) {
        problems.push(Diagnostic::at(
            &file.path,
            format!("no group of a mesh can be called '{name}'"),
            NO_FORMULA,
        ));
    }
}

/// The mesh as it is generated or read.
fn made(mesh: &case::Mesh, directory: &Path, held: &Inputs, problems: &mut Vec<Diagnostic>) -> Option<Built> {
    let (made, span, remedy) = match mesh {
        case::Mesh::Caverns(caverns) => {
            let spec = spec(caverns);
            let made = spec.mesh_with_notes().map_err(|e| {
                let message = e.to_string();
                let does = spec.size_that_does(&e);
                let message = match (&does, message.rsplit_once("; ")) {
                    (Some((key, size)), Some((what, remedy))) => {
                        let key = key.split_once('.').map_or(key.as_str(), |(_, own)| own);
                        format!("{what}; `{key} = \"{size} m\"` would do, or {remedy}")
                    }
                    _ => message,
                };
                let subject = does.map_or_else(|| e.subject(), |(key, _)| key);
                (place(caverns, &subject), message)
            });
            (made, &caverns.span, "change the description of the caverns if this is not meant")
        }
        case::Mesh::Box(bricks) => {
            let made = boxed(bricks).map(|mesh| (mesh, Vec::new()));
            (made.map_err(|e| (bricks.span.clone(), e)), &bricks.span, "")
        }
        case::Mesh::File(file) => {
            let (path, span) = (&file.path.value, &file.path.span);
            let encoding = file.encoding.as_ref();
            let encoding =
                encoding.map(|e| encoding_of(&e.value).map_err(|problem| (e.span.clone(), problem)));
            let made = match (held.mesh(path), encoding.transpose()) {
                (_, Err(problem)) => Err(problem),
                (Some(mesh), _) => sound(mesh.clone()).map_err(|e| (span.clone(), in_memory(path, &e))),
                (None, Ok(encoding)) => {
                    read_encoded(directory.join(path), encoding).map_err(|e| (span.clone(), e.to_string()))
                }
            };
            let placement =
                Placement { scale: [file.unit.value; 3], rotation: file.rotate.value, ..Placement::AS_IT_IS };
            let made = made.map(|(mut mesh, notes)| {
                placement.apply(&mut mesh);
                (mesh, notes)
            });
            (made, span, "change the file if this is not meant")
        }
    };
    match made {
        Ok((built, notes)) => {
            let at = |note: &Note| match (mesh, note) {
                (case::Mesh::Caverns(caverns), Note::MovedCut { cavern, .. }) => {
                    place(caverns, &format!("{cavern}.benches"))
                }
                (case::Mesh::Caverns(caverns), Note::Stepped { layer }) => {
                    place(caverns, &format!("layer {layer}.depth"))
                }
                _ => span.clone(),
            };
            let warning = |note: &Note| Diagnostic::new(at(note), note.to_string(), remedy);
            let (doubled, notes): (Vec<Note>, Vec<Note>) =
                notes.into_iter().partition(|note| matches!(note, Note::Coincident { .. }));
            let doubled = doubled.first().map(warning);
            Some(Built {
                mesh: built,
                warnings: notes.iter().map(warning).collect(),
                doubled,
                taken: Vec::new(),
            })
        }
        Err((span, message)) => {
            // Errors of the mesh crate end with the way out.
            let (what, remedy) = message.rsplit_once("; ").unwrap_or((&message, "change the mesh"));
            problems.push(Diagnostic::new(span, what, remedy));
            None
        }
    }
}

/// Where in the case the generator's `subject` is written.
fn place(c: &case::Caverns, subject: &str) -> Range<usize> {
    let (subject, of_layer) = match subject.strip_prefix("layer ") {
        Some(rest) => (rest, true),
        None => (subject, false),
    };
    let (name, key) = subject.split_once('.').unwrap_or((subject, ""));
    // The last of a name is the one that uses it twice.
    if of_layer && let Some(layer) = c.layers.iter().rfind(|layer| layer.name.value == name) {
        return match key {
            "depth" => layer.depth.span.clone(),
            "dip" => layer.dip.span.clone(),
            "dip_direction" => layer.dip_direction.span.clone(),
            _ => layer.name.span.clone(),
        };
    }
    let of_gallery = key.is_empty() && c.galleries.iter().any(|gallery| gallery.name.value == name);
    if !of_gallery && let Some(cavern) = c.caverns.iter().rfind(|cavern| cavern.name.value == name) {
        let (lining, sprayed) = (cavern.lining.as_ref(), cavern.shotcrete.as_ref());
        let length = cavern.length.as_ref();
        return match key {
            "at" => cavern.at.span.clone(),
            "length" => length.map_or(cavern.span.clone(), |l| l.length.span.clone()),
            "middle" => length.map_or(cavern.span.clone(), |l| l.middle.span.clone()),
            "width" => cavern.width.span.clone(),
            "height" => cavern.height.span.clone(),
            "arch_rise" => cavern.arch_rise.span.clone(),
            "benches" => cavern.benches.span.clone(),
            "shotcrete" => sprayed.map_or(cavern.span.clone(), |s| s.thickness.span.clone()),
            "shotcrete_layers" => sprayed.map_or(cavern.span.clone(), |s| s.layers.span.clone()),
            "lining" => lining.map_or(cavern.span.clone(), |l| l.walls.span.clone()),
            "lining.walls" => lining.map_or(cavern.span.clone(), |l| l.walls.span.clone()),
            "lining.crown" => lining.map_or(cavern.span.clone(), |l| l.crown.span.clone()),
            "lining.floor" => lining.map_or(cavern.span.clone(), |l| l.floor.span.clone()),
            "lining.layers" => lining.map_or(cavern.span.clone(), |l| l.layers.span.clone()),
            _ => cavern.name.span.clone(),
        };
    }
    if let Some(gallery) = c.galleries.iter().rfind(|gallery| gallery.name.value == name) {
        return match key {
            "at" => gallery.at.span.clone(),
            "width" => gallery.width.span.clone(),
            "height" => gallery.height.span.clone(),
            _ => gallery.name.span.clone(),
        };
    }
    let along = c.along.as_ref().map(|along| &along.span);
    match name {
        "overburden" => c.overburden.span.clone(),
        "below" => c.below.span.clone(),
        "sides" => c.sides.span.clone(),
        "length" => c.length.span.clone(),
        "size_near" => c.near.span.clone(),
        "size_far" => c.far.span.clone(),
        "size_along" => along.unwrap_or(&c.span).clone(),
        "ground" => match &c.ground {
            Some(case::GroundSurface::Slope(slope)) => slope.span.clone(),
            _ => c.span.clone(),
        },
        _ => c.span.clone(),
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
        length: c.length.as_ref().map(|l| l.length.value),
        middle: c.length.as_ref().map_or(0.0, |l| l.middle.value),
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
        shotcrete: c
            .shotcrete
            .as_ref()
            .map_or(Shotcrete::NONE, |s| Shotcrete { thickness: s.thickness.value, layers: s.layers.value }),
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
        None => GroundSurface::Level,
        Some(case::GroundSurface::Slope(slope)) => {
            let [x, y] = slope.value.map(f64::tan);
            GroundSurface::Inclined { x, y }
        }
        Some(case::GroundSurface::Heights { x, y, heights }) => {
            let y = if y.is_empty() { vec![0.0] } else { y.clone() };
            GroundSurface::Table { x: x.clone(), y, heights: heights.clone() }
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
    mesh.groups.clear();
    for e in 0..mesh.elements.len() {
        let nodes = mesh.elements[e].nodes();
        let middle = [0, 1, 2]
            .map(|i| nodes.iter().map(|&n| mesh.nodes[n as usize][i]).sum::<f64>() / nodes.len() as f64);
        let is_in = |part: &&case::MeshPart| {
            let mut ranges = middle.iter().zip(&part.ranges);
            ranges.all(|(x, range)| range.as_ref().is_none_or(|r| (r.value[0]..r.value[1]).contains(x)))
        };
        let group = bricks.parts.iter().rfind(is_in).map_or(&bricks.group, |part| &part.group);
        mesh.groups.entry(group.value.clone()).or_default().push(e as u32);
    }
    match bricks.parts.iter().find(|part| !mesh.groups.contains_key(&part.group.value)) {
        None => Ok(mesh),
        Some(part) => Err(format!(
            "no element of the box has its middle in the part '{}', or a later part has them all",
            part.group.value
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tremolite_case::MeshAlone;

    const CAVERNS: &str = r#"[mesh.caverns]
overburden = "60 m"
below = "40 m"
sides = "40 m"
length = "30 m"
size_near = "3 m"
size_far = "8 m"
[[mesh.caverns.cavern]]
name = "hall"
width = "12 m"
height = "20 m"
arch_rise = "3 m"
lining = { walls = "0.5 m", crown = "0.9 m" }
"#;

    #[test]
    fn what_the_generator_refuses_is_shown_where_it_is_written() {
        for (from, to, marked, remedy) in [
            ("crown = \"0.9 m\"", "crown = \"9 m\"", "\"9 m\"", "half the width"),
            ("crown = \"0.9 m\" }", "crown = \"0.9 m\" }\nshotcrete = \"7 m\"", "\"7 m\"", "half the width"),
            ("overburden = \"60 m\"", "overburden = \"0.1 m\"", "\"0.1 m\"", "raise `overburden` by 4.4 m"),
            ("arch_rise = ", "length = \"2 m\"\narch_rise = ", "\"2 m\"", "`size_along`"),
            ("arch_rise = ", "length = \"28 m\"\narch_rise = ", "\"28 m\"", "rock"),
            ("arch_rise = ", "length = \"9 m\"\nmiddle = \"11 m\"\narch_rise = ", "\"11 m\"", "rock"),
            (
                "size_far = \"8 m\"",
                "size_far = \"8 m\"\nsize_along = \"1e-9 m\"",
                "\"1e-9 m\"",
                "raise `size_along`",
            ),
            (
                "[[mesh.caverns.cavern]]",
                "[[mesh.caverns.layer]]\nname = \"cap\"\n[[mesh.caverns.layer]]\nname = \"rock\"\ndepth = \"9 m\"\n[[mesh.caverns.cavern]]",
                "\"rock\"",
                "choose another name",
            ),
            ("name = \"hall\"", "name = \"rock\"", "\"rock\"", "choose another name"),
        ] {
            let source = CAVERNS.replace(from, to);
            let alone = MeshAlone::parse(Path::new("mesh.toml"), &source);
            let alone = alone.unwrap_or_else(|e| panic!("{e}")).expect("it has no other table");
            let mut problems = Vec::new();
            assert!(
                build(
                    &alone.mesh,
                    &alone.ground,
                    &[],
                    [false; 2],
                    Path::new(""),
                    &Inputs::default(),
                    &mut problems
                )
                .is_none()
            );
            let [problem] = &problems[..] else { panic!("{problems:?}") };
            assert!(source[problem.span.clone()].starts_with(marked), "{}", &source[problem.span.clone()]);
            assert!(problem.remedy.contains(remedy), "{problem:?}");
        }
    }
}
