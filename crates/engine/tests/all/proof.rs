//! Which steps are found to be too long around borders of levels, beside a motion whose growth is known.

use crate::ready::{DENSITY, Ready, body, joint, whole};
use tremolite_engine::Problem;
use tremolite_engine::engine::{Proof, TRIED, prove};
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::{Element, Mesh, Shape};

/// Edge of the cube that sets the step \[m\].
const EDGE: f64 = 0.25;

/// A small cube that stands by itself at (x, 0, 0).
fn add_cube(mesh: &mut Mesh, x: f64) -> u32 {
    let own = BoxSpec::uniform([x, 0.0, 0.0], [x + EDGE, EDGE, EDGE], [1; 3]).mesh().unwrap();
    let first = mesh.nodes.len() as u32;
    let nodes: Vec<u32> = own.elements[0].nodes().iter().map(|n| first + n).collect();
    mesh.nodes.extend(own.nodes);
    mesh.elements.push(Element::new(Shape::Hex8, &nodes));
    mesh.elements.len() as u32 - 1
}

/// Which nodes of the cube are tied to which, from its first on.
type Tied = &'static [(u32, u32)];

/// The cube alone.
fn alone(viscosity: f64, tied: Tied) -> Ready {
    let mut mesh = Mesh::default();
    add_cube(&mut mesh, 0.0);
    let mut problem = whole(mesh);
    problem.bodies[0].viscosity = viscosity;
    problem.ties = tied.to_vec();
    Ready::new(problem)
}

/// A bar with finest steps over 68 of its 72 elements, one of which, near the border, is ten thousand times as heavy, and the cube, which takes
/// twice as long ones and is in the patch behind the border. Nodes around the border have numbers beyond those that a thread works on at a time.
fn beside_a_border(viscosity: f64, tied: Tied) -> Ready {
    let mut mesh = BoxSpec::uniform([0.0; 3], [72.0, 1.0, 1.0], [72, 1, 1]).mesh().unwrap();
    let first = mesh.nodes.len() as u32;
    let cube = add_cube(&mut mesh, 74.0);
    let mut heavy = body("heavy", vec![65]);
    heavy.density = 1e4 * DENSITY;
    let mut light = body("light", (0..=cube).filter(|&e| e != 65).collect());
    light.viscosity = viscosity;
    let mut problem = Problem::new(mesh, vec![heavy, light]);
    problem.ties = tied.iter().map(|&(a, b)| (first + a, first + b)).collect();
    problem.patch_elements = Some(8);
    let ready = Ready::new(problem).levelled(|[x, ..]| u8::from(x > 67.5));
    assert_eq!(ready.phase.beats.len(), 2);
    let own = ready.model.patches.iter().find(|patch| patch.elements.contains(&cube)).unwrap();
    assert!(own.elements.len() > 1 && own.level == 1, "with those behind the border");
    assert!(ready.phase.borders.iter().all(|border| border.node >= 256), "{:?}", ready.phase.borders);
    ready
}

/// What is found with so many times the longest step that the cube allows.
fn found(ready: &Ready, times: f64, longest: f64) -> Proof {
    prove(&ready.model, &ready.assembly, &ready.phase, 0.5 * times * longest)
}

/// A mode with ωΔt = 2r grows by e^θ a step, r = cosh(θ/2).
fn growing(growth: f64) -> f64 {
    (0.5 * growth.ln_1p()).cosh()
}

#[test]
fn the_smallest_growth_brings_a_hundredth_of_an_energy_to_thirty_times_it() {
    let energy = 0.01 * (1.0 + Proof::smallest_growth()).powi(2 * TRIED as i32);
    assert!((energy - 30.0).abs() < 1e-9, "{energy}");
}

/// Of a cube by itself, one whose opposite faces move as one, and one with artificial viscosity, for which the step is shorter: in each
/// the mode that grows has no less than a hundredth of the energy that the members of the heavy or the light body begin with.
#[test]
fn a_mode_that_grows_by_twice_the_smallest_growth_is_found_and_none_that_does_not() {
    let opposite: Tied = &[(1, 0), (3, 2), (5, 4), (7, 6)];
    for tied in [&[][..], opposite] {
        let longest = alone(0.0, tied).stable().dt;
        let ready = beside_a_border(0.0, tied);
        let proof = found(&ready, growing(2.0 * Proof::smallest_growth()), longest);
        let name = |m: &u32| ready.assembly.members[*m as usize].name.clone();
        assert!(
            !proof.grown.is_empty() && proof.grown.iter().all(|m| name(m).contains("light")),
            "{proof:?}"
        );
        // Nearer to the limit what does not grow for ever swings up to as much.
        let proof = found(&ready, 0.99, longest);
        assert!(proof.tried > 2 && proof.grown.is_empty(), "{proof:?}");
    }
    // The step of a viscous element is found to a thousandth.
    let viscosity = 0.3;
    let (longest, undamped) = (alone(viscosity, &[]).stable().dt, alone(0.0, &[]).stable().dt);
    assert!(longest < 0.8 * undamped);
    let ready = beside_a_border(viscosity, &[]);
    assert!(!found(&ready, 1.02, longest).grown.is_empty());
    assert!(found(&ready, 0.98, longest).grown.is_empty());
}

/// A joint beside what is tried reaches nodes of elements that are not: these stand still.
#[test]
fn what_lies_beyond_the_surroundings_stands_still() {
    let mesh = BoxSpec::uniform([0.0; 3], [12.0, 1.0, 1.0], [12, 1, 1]).mesh().unwrap();
    let mut problem =
        Problem::new(mesh, vec![body("own", (0..6).collect()), body("other", (6..12).collect())]);
    let mut joint = joint(&problem, [0, 1], 1e9);
    joint.viscosity = 0.0;
    problem.interfaces = vec![joint];
    problem.patch_elements = Some(8);
    let ready = Ready::new(problem).levelled(|[x, ..]| u8::from(x > 2.5));
    let proof = prove(&ready.model, &ready.assembly, &ready.phase, 0.4 * ready.stable().dt);
    let patches = ready.model.patches.len();
    assert!(proof.grown.is_empty(), "{proof:?}");
    assert!(patches == 3 && proof.tried == 3, "two patches and the joint of {patches}: {proof:?}");
}
