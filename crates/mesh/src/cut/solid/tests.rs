use std::collections::{BTreeMap, BTreeSet};

use super::*;
use crate::boxes::BoxSpec;
use crate::cut::{Bounds, Cut, Done};
use crate::quality::{self, summary, summary_of};
use crate::topology::{all_faces, exterior_faces, face_key, plane_faces};
use crate::{Face, Shape};

/// A block of 24 × 24 × 20 m in bricks of 2 m.
fn block() -> Mesh {
    let spec = BoxSpec::uniform([-12.0, -12.0, -20.0], [12.0, 12.0, 0.0], [12, 12, 10]);
    let mut mesh = spec.mesh().unwrap_or_else(|e| panic!("{e}"));
    mesh.groups = [("rock".to_owned(), (0..mesh.elements.len() as u32).collect())].into();
    mesh.faces = plane_faces(&mesh, 1e-9);
    mesh
}

fn fault(through: [f64; 3], dip: f64, direction: f64) -> Cut {
    let plane = Plane::dipping(through, dip.to_radians(), direction.to_radians());
    Cut { name: "fault".to_owned(), plane, extent: None }
}

fn cut_of(base: &Mesh, cuts: &[Cut]) -> (Mesh, Done) {
    let mut mesh = base.clone();
    let done = crate::cut::cut(&mut mesh, cuts, &Bounds::default());
    (mesh, done.unwrap_or_else(|e| panic!("{cuts:?}: {e}")))
}

/// Dips and dip directions at which planes are tried.
const DIPS: [f64; 8] = [20.0, 30.0, 40.0, 45.0, 50.0, 55.0, 65.0, 75.0];

fn volume(mesh: &Mesh, group: &str) -> f64 {
    summary_of(mesh, mesh.groups[group].iter().copied()).volume
}

#[test]
#[ignore]
fn survey() {
    let base = block();
    for direction in [30.0, 75.0] {
        for dip in DIPS {
            for k in [0, 3, 5] {
                let cut = fault([0.25 * f64::from(k), 0.0, -10.0], dip, direction);
                let mut mesh = base.clone();
                let start = std::time::Instant::now();
                match crate::cut::cut(&mut mesh, &[cut], &Bounds::default()) {
                    Err(e) => println!("{direction} {dip} {k}: {e}"),
                    Ok(done) => {
                        let at = |n: u32| mesh.nodes[n as usize];
                        let step = mesh.elements.iter().map(|e| super::polyhedron::step_length(e, &at)).fold(9.0, f64::min);
                        let count = |s: Shape| mesh.elements.iter().filter(|e| e.shape == s).count();
                        println!("{direction} {dip} {k}: jac {:.2} step {:.2} moved {:.2} hex {} wedge {} pyr {} tet {} {:?}", done.jacobian, step / 2.0, done.moved, count(Shape::Hex8), count(Shape::Wedge6), count(Shape::Pyramid5), count(Shape::Tet4), start.elapsed());
                    }
                }
            }
        }
    }
    let _ = (summary(&base), quality::of(&base, 0), volume as fn(&Mesh, &str) -> f64, all_faces(&base, None).count(), exterior_faces(&base, None), face_key(&base, Face{element:0, side:0}), BTreeSet::<u8>::new(), BTreeMap::<u8,u8>::new(), cut_of as fn(&Mesh,&[Cut])->(Mesh,Done));
}
