//! Sides and top of a case: what they become, and what of them is refused or unusual.

use tremolite_case::{self as case, Case, Diagnostic, units};
use tremolite_engine::outer_faces::{NEAR, OuterFaces};
use tremolite_engine::{Base, Body, Side, Top};
use tremolite_laws::Dimension;
use tremolite_mesh::Mesh;
use tremolite_mesh::sides::sides;
use tremolite_motion::Motion;

/// A component of motion over the largest that counts as none.
const STILL: f64 = 1e-3;

pub fn side(side: case::Side) -> Side {
    match side {
        case::Side::FreeField => Side::FreeField,
        case::Side::Periodic => Side::Periodic,
        // Symmetry holds before and in the shaking, and so does a roller: the word says what is meant.
        case::Side::Symmetry | case::Side::Roller => Side::Roller,
        case::Side::Viscous => Side::Viscous,
        case::Side::Fixed => Side::Fixed,
        case::Side::Free => Side::Free,
    }
}

/// Whether springs stand at free-field sides.
pub fn has_springs(case: &Case) -> bool {
    matches!(case.dynamic.base.value, case::Base::ViscousSpring { side_springs: true, .. })
}

/// Refuses springs of sides where no ground beside the model leads them.
pub fn check_springs(case: &Case, at_angles: bool, problems: &mut Vec<Diagnostic>) {
    let free_field = case.dynamic.sides.iter().any(|side| side.value == case::Side::FreeField);
    if !has_springs(case) || (free_field && !at_angles) {
        return;
    }
    let (what, remedy) = match at_angles {
        true => {
            ("no ground stands beside the model, where waves at angles come in", "take `side_springs` out")
        }
        false => ("no side is free field", "take `side_springs` out, or write sides = \"free-field\""),
    };
    let what = format!("`side_springs` act against the ground outside free-field sides, but {what}");
    problems.push(Diagnostic::at(&case.dynamic.base, what, remedy));
}

/// What acts on the sides across x and y, and on a base. A specimen that stands free without an earthquake may have any shape: where it has no
/// faces on a plane, nothing acts there.
pub fn acting(case: &Case, mesh: &Mesh, bodies: &[Body], base: Base) -> ([Side; 2], Base) {
    let given = [0, 1].map(|axis| side(case.dynamic.sides[axis].value));
    let [x, y] = [0, 1].map(|axis| {
        let holds = matches!(given[axis], Side::Periodic | Side::Fixed);
        !holds && case.initial.sides[axis].value == case::SideHold::Free
    });
    let stands = case.initial.base.value == case::BaseHold::Free;
    if case.motion.is_some() || !(x || y || stands) {
        return (given, base);
    }
    let elements: Vec<u32> = bodies.iter().flat_map(|body| body.elements.iter().copied()).collect();
    let outer = OuterFaces::of(mesh, mesh.bounds(), &elements);
    let curved = |axis: usize| outer.planes[axis].iter().any(Vec::is_empty);
    let sides = [0, 1].map(|axis| if [x, y][axis] && curved(axis) { Side::Free } else { given[axis] });
    let base = if stands && outer.planes[2][0].is_empty() { Base::Free } else { base };
    (sides, base)
}

pub fn top(top: case::Top) -> Top {
    match top {
        case::Top::Free => Top::Free,
        case::Top::Viscous => Top::Viscous,
    }
}

/// Refuses a mesh from a file whose outer sides do not lie along x and y where sides act. Generated meshes stand along them.
pub fn check_planes(case: &Case, mesh: &Mesh, problems: &mut Vec<Diagnostic>) {
    let case::Mesh::File(file) = &case.mesh else { return };
    let acts = [0, 1].map(|axis| {
        let side = case.dynamic.sides[axis].value;
        let holds = matches!(side, case::Side::Periodic | case::Side::Fixed);
        // Where equilibrium is sought, free sides are rollers until the earthquake, unless the case says otherwise.
        let before = holds || case.initial.sides[axis].value == case::SideHold::Roller;
        (case.motion.is_some() && side != case::Side::Free) || (case.seeks_equilibrium() && before)
    });
    if acts == [false; 2] {
        return;
    }
    let place = &file.path;
    let found = match sides(mesh) {
        Ok(found) => found,
        // What one pair of sides needs, the engine asks for.
        Err(_) if acts != [true; 2] => return,
        Err(e) => {
            let remedy = "cut the model along two pairs of parallel vertical planes, or write sides = \"free\", in [initial] as well, \
                          where nothing is to act on them";
            problems.push(Diagnostic::at(place, e.to_string(), remedy));
            return;
        }
    };
    let most = |off: [f64; 2]| (0..2).filter(|&i| acts[i]).map(|i| off[i]).fold(0.0, f64::max);
    let off = most(found.off);
    if off > NEAR && most(found.off_axes) > NEAR {
        let message = format!(
            "the outer sides are not plane: nodes lie off them by up to {off:.1e} of the model's width, and no boundary acts on \
             faces that are off by more than {NEAR:.0e}"
        );
        problems.push(Diagnostic::at(
            place,
            message,
            "write the mesh with more digits, or make its sides plane",
        ));
    }
    if found.turned(acts, NEAR) {
        let (angle, total) = (found.angle.to_degrees(), (file.rotate.value - found.angle).to_degrees());
        let message = format!(
            "the outer sides of the mesh are turned by {} about z (counter-clockwise seen from above), and boundaries act on \
             sides that lie along x and y",
            degrees(angle)
        );
        let remedy = format!(
            "write mesh.file.rotate = \"{}\", which turns the mesh as it is read: coordinates and stresses of the case, its \
             results and model_x_azimuth are then meant in the axes after it",
            degrees(total - 360.0 * (total / 360.0).round())
        );
        problems.push(Diagnostic::at(place, message, remedy));
    }
}

/// An angle with as many digits as leave nodes where they would be without rounding, to 10⁻⁹ of the model's size.
fn degrees(angle: f64) -> String {
    // A nought without a sign.
    let text = format!("{:.8}", (1e8 * angle).round() / 1e8 + 0.0);
    format!("{} deg", text.trim_end_matches('0').trim_end_matches('.'))
}

/// Refuses sides that hold what the motion moves.
pub fn check_motion(case: &Case, motion: &Motion, problems: &mut Vec<Diagnostic>) {
    let peak = |i: usize| motion.velocity[i].iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let largest = (0..3).map(peak).fold(0.0, f64::max);
    let mut found = Vec::new();
    for (axis, side) in case.dynamic.sides.iter().enumerate() {
        let name = ["x", "y"][axis];
        let along = || {
            let [velocity, most] =
                [peak(axis), largest].map(|v| units::format(rounded(v), Dimension::VELOCITY));
            format!("the motion reaches {velocity} along it, of {most} at most, and moves the ground so")
        };
        let (message, remedy) = match side.value {
            case::Side::Fixed => (
                format!(
                    "the fixed sides across {name} do not move, while the earthquake moves the ground beside them"
                ),
                "write \"free-field\" or \"periodic\"",
            ),
            case::Side::Roller if peak(axis) > STILL * largest => (
                format!("the roller sides across {name} hold their normal, but {}", along()),
                "write \"free-field\" or \"periodic\"",
            ),
            case::Side::Symmetry if peak(axis) > STILL * largest => (
                format!("across {name} there is no symmetry: it needs rest along {name}, but {}", along()),
                "write \"free-field\" or \"periodic\" for a model of the whole, or leave this component of the motion out",
            ),
            _ => continue,
        };
        found.push(Diagnostic::at(side, message, remedy));
    }
    // One word for both sides is one mistake.
    found.dedup_by(|a, b| a.span == b.span);
    problems.extend(found);
}

/// Three digits: more would say more than is known.
fn rounded(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}

/// Boundaries that do not let ground move as it would without them, and axes that may not be the motion's.
pub fn warnings(case: &Case) -> Vec<Diagnostic> {
    let Some(motion) = &case.motion else { return Vec::new() };
    let mut warnings = Vec::new();
    for (axis, side) in case.dynamic.sides.iter().enumerate() {
        let what = match side.value {
            case::Side::Viscous => "drain the wave as it rises",
            case::Side::Free => "stand free, where ground would press",
            _ => continue,
        };
        let (name, word) = (["x", "y"][axis], side.value.word());
        let message = format!(
            "the {word} sides across {name} {what}: in homogeneous ground velocities were wrong by 80 to 130 % of the surface's peak with such sides"
        );
        let remedy = "use \"free-field\"; the check 'motion at the model's corners against the free field' says what is left";
        warnings.push(Diagnostic::at(side, message, remedy));
    }
    // One word for both sides is one warning.
    warnings.dedup_by(|a, b| a.span == b.span);
    if case.dynamic.top.value == case::Top::Viscous {
        warnings.push(Diagnostic::at(
            &case.dynamic.top,
            "the top absorbs: the wave that the real surface would send back is missing, so motion there is about half of a \
             surface's",
            "keep it for full space, or where what the surface sends back is meant to be left out; else leave `top` out",
        ));
    }
    let assumed = case.defaulted.iter().any(|d| d.key == "model_x_azimuth");
    if let case::Mesh::File(file) = &case.mesh
        && file.rotate.value != 0.0
        && assumed
    {
        warnings.push(Diagnostic::new(
            motion.span.clone(),
            format!(
                "the mesh is turned by {}, and its x axis after that is taken to point east",
                degrees(file.rotate.value.to_degrees())
            ),
            "give model_x_azimuth: the azimuth of the file's x axis plus mesh.file.rotate",
        ));
    }
    warnings
}
