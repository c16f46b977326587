//! Interfaces that go up and down by whole elements where a plane was meant.

use std::collections::HashMap;
use tremolite_case::{Case, Diagnostic};
use tremolite_engine::Model;
use tremolite_engine::interface::Seam;
use tremolite_mesh::Mesh;

/// Share of an interface's area in steps from which on it is a stair: of a stair with treads of ten elements a riser each.
const SHARE: f64 = 0.08;
/// cos of the angle between neighbours from which on there is a corner between them.
const CORNER: f64 = 0.5;

/// Of interfaces that are stairs.
pub fn of_stairs(case: &Case, model: &Model) -> Vec<Diagnostic> {
    let written = |name: &str| case.interfaces.iter().find(|interface| interface.name.value == name);
    let seams = model
        .user_seams()
        .iter()
        .filter_map(|seam| Some((written(&seam.name)?, Steps::of(&model.mesh, seam))));
    seams
        .filter(|(_, steps)| steps.stepped > SHARE * steps.area)
        .map(|(interface, steps)| {
            Diagnostic::new(
                interface.span.clone(),
                format!(
                    "'{}' is a stair of elements: {:.0} % of its {:.0} m2 are steps, where a plane would have {:.0} m2; it cannot slide \
                     or open as a plane does",
                    interface.name.value,
                    100.0 * steps.stepped / steps.area,
                    steps.area,
                    steps.plane
                ),
                "cut generated ground with a [[mesh.plane]], or mesh it with faces of elements along the surface, as Gmsh does of a surface \
                 embedded in the volume",
            )
        })
        .collect()
}

/// How far an interface goes by steps \[m²\].
#[derive(Default)]
struct Steps {
    area: f64,
    /// Of faces that have a corner to one neighbour inwards and to another outwards.
    stepped: f64,
    /// Of the plane between the same edges.
    plane: f64,
}

impl Steps {
    fn of(mesh: &Mesh, seam: &Seam) -> Steps {
        let faces: Vec<Side> = seam.faces.iter().map(|[first, _]| Side::of(mesh, *first)).collect();
        let mut beside: HashMap<[u32; 2], Vec<usize>> = HashMap::new();
        for (i, face) in faces.iter().enumerate() {
            let count = face.nodes.len();
            for k in 0..count {
                let (a, b) = (face.nodes[k], face.nodes[(k + 1) % count]);
                beside.entry([a.min(b), a.max(b)]).or_default().push(i);
            }
        }
        let mut inwards = vec![[false; 2]; faces.len()];
        for pair in beside.values() {
            let &[i, j] = &pair[..] else { continue };
            let (a, b) = (&faces[i], &faces[j]);
            if dot(a.normal, b.normal) < CORNER {
                let way = [0, 1, 2].map(|k| b.centre[k] - a.centre[k]);
                let turn = usize::from(dot(way, a.normal) > 0.0);
                inwards[i][turn] = true;
                inwards[j][turn] = true;
            }
        }
        let mut steps = Steps::default();
        let mut sum = [0.0; 3];
        for (face, turns) in faces.iter().zip(&inwards) {
            steps.area += face.area;
            steps.stepped += if *turns == [true; 2] { face.area } else { 0.0 };
            (0..3).for_each(|k| sum[k] += face.area * face.normal[k]);
        }
        steps.plane = dot(sum, sum).sqrt();
        steps
    }
}

/// A face as it is seen from its element.
struct Side {
    nodes: Vec<u32>,
    centre: [f64; 3],
    /// Unit, out of the element.
    normal: [f64; 3],
    area: f64,
}

impl Side {
    fn of(mesh: &Mesh, face: tremolite_mesh::Face) -> Side {
        let nodes: Vec<u32> = mesh.face_nodes(face).collect();
        let at = |k: usize| mesh.nodes[nodes[k % nodes.len()] as usize];
        let share = 1.0 / nodes.len() as f64;
        let centre = [0, 1, 2].map(|i| (0..nodes.len()).map(|k| share * at(k)[i]).sum::<f64>());
        let mut twice = [0.0; 3];
        for k in 0..nodes.len() {
            let [a, b] = [at(k), at(k + 1)].map(|p| [0, 1, 2].map(|i| p[i] - centre[i]));
            (0..3)
                .for_each(|i| twice[i] += a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
        }
        let length = dot(twice, twice).sqrt();
        Side { nodes, centre, normal: twice.map(|x| x / length), area: 0.5 * length }
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}
