//! What is unusual about a case though it can be run.

use crate::quantities::Field;
use crate::sections::{runs_along_x, stations};
use crate::stacks::stacks;
use crate::trust::{DRIFT, LEAST_AT_CORNERS, typical_extent};
use tremolite_case::{self as case, Case};
use tremolite_engine::extent::sizes;
use tremolite_engine::hexahedra::hex;
use tremolite_engine::{Body, Water};
use tremolite_kernels::Quadrature;
use tremolite_laws::Role;
use tremolite_laws::parameter::position;
use tremolite_motion::Process;

/// Speeds of P waves \[m/s\] that are nothing unusual: from loose soil to well beyond the stiffest rock.
const WAVE_SPEEDS: std::ops::RangeInclusive<f64> = 100.0..=10_000.0;

/// What laws find unusual, and fields that no law can fill.
pub fn of_laws(case: &Case, bodies: &[Body], fields: &[Field]) -> Vec<case::Diagnostic> {
    let mut warnings = Vec::new();
    let mut told: Vec<usize> = Vec::new();
    let solid = case.regions.iter().filter_map(|r| match &r.fill {
        case::Fill::Solid { material, .. } => Some(material.value),
        _ => None,
    });
    // Bodies are made region by region.
    for (material, body) in solid.zip(bodies) {
        if told.contains(&material) {
            continue;
        }
        told.push(material);
        let span = &case.materials[material].span;
        let remedy = "change the material's parameters if this is not meant";
        warnings.extend(
            body.material.warnings().into_iter().map(|w| case::Diagnostic::new(span.clone(), w, remedy)),
        );
        let (pressure, _) = body.material.moduli().wave_speeds(body.density);
        if !WAVE_SPEEDS.contains(&pressure) {
            let message = format!(
                "P waves would travel at {pressure:.0} m/s, where rock and concrete have 100 to 10000 m/s"
            );
            let remedy = "look at the units of young and density, and of gravity beside unit_weight";
            warnings.push(case::Diagnostic::new(span.clone(), message, remedy));
        }
    }
    let kept =
        |field: &Field| bodies.iter().any(|b| b.material.info().history.iter().any(|c| field.holds(c)));
    let words = [Field::Damage, Field::Plastic, Field::History];
    for field in words.iter().filter(|f| fields.contains(f) && !kept(f)) {
        let word = field.description().0;
        let message = format!("no material of this case keeps anything for the field '{word}'");
        warnings.push(case::Diagnostic::new(
            case.output.span.clone(),
            message,
            match field {
                Field::Plastic => {
                    "take 'plastic' out of `fields`, or give rock a law that yields: mohr-coulomb, drucker-prager or hoek-brown"
                }
                Field::Damage => "take 'damage' out of `fields`, or give concrete law = \"concrete-damage\"",
                _ => "take 'history' out of `fields`, or give materials laws that remember",
            },
        ));
    }
    warnings
}

/// Thicker \[m\] is no lining but ground: an assumption.
const THICK: f64 = 3.0;
/// Elements through a thickness up to which one-point elements miss most of its bending: their stresses are the mean's.
const THIN: usize = 3;

/// Linings and slabs of one-point elements.
pub fn of_thin_bodies(case: &Case, mesh: &tremolite_mesh::Mesh, bodies: &[Body]) -> Vec<case::Diagnostic> {
    let regions = case.regions.iter().filter(|r| matches!(r.fill, case::Fill::Solid { .. }));
    let all: usize = bodies.iter().map(|body| body.elements.len()).sum();
    regions
        .zip(bodies)
        // What most of the model is made of is no lining.
        .filter(|(_, body)| body.quadrature == Quadrature::OnePoint && 4 * body.elements.len() < all)
        .filter_map(|(region, body)| {
            let length = |&(e, axis): &(u32, usize)| hex(mesh, e as usize).map_or(0.0, |h| 2.0 * h.half_lengths[axis]);
            let thin = stacks(mesh, &body.elements).into_iter().filter(|s| s.iter().map(length).sum::<f64>() < THICK);
            let fewest = thin.map(|stack| stack.len()).min().filter(|&n| n <= THIN)?;
            Some(case::Diagnostic::new(
                region.span.clone(),
                format!(
                    "'{}' is {fewest} one-point elements thick: they see no bending through the thickness, and a ring of \
                     them showed half of its largest stress",
                    body.name
                ),
                "write element = \"layered\" for it if it is one element thick, else \"full-integration\"",
            ))
        })
        .collect()
}

/// Share of a body's volume in linear tetrahedra from which on they are told.
const TETRAHEDRA: f64 = 0.01;

/// Rock of linear tetrahedra that may yield, or whose water cannot leave in the earthquake: plastic flow keeps the volume and so does water,
/// which such an element can hardly do and be sheared.
pub fn of_tetrahedra(
    case: &Case,
    mesh: &tremolite_mesh::Mesh,
    bodies: &[Body],
    water: &Water,
) -> Vec<case::Diagnostic> {
    let regions = case.regions.iter().filter(|r| matches!(r.fill, case::Fill::Solid { .. }));
    let yields = |body: &Body| position(body.material.info().history, Role::PlasticShear).is_some();
    let volume = |e: &u32| hex(mesh, *e as usize).map_or(0.0, |h| h.volume);
    let is_one = |e: &&u32| mesh.elements[**e as usize].shape == tremolite_mesh::Shape::Tet4;
    regions
        .zip(bodies)
        .filter(|(_, body)| body.elements.iter().any(|e| is_one(&e)))
        .filter_map(|(region, body)| {
            let wet = |e: &&u32| water.undrained(**e as usize).is_some();
            let all: f64 = body.elements.iter().map(volume).sum();
            let (why, found): (_, f64) = if yields(body) {
                let found = body.elements.iter().filter(is_one).map(volume).sum();
                ("where rock yields: they keep their volume as plastic flow does", found)
            } else {
                let found = body.elements.iter().filter(is_one).filter(wet).map(volume).sum();
                ("where water cannot leave in the earthquake: they keep their volume as it does", found)
            };
            (found > TETRAHEDRA * all).then(|| {
                case::Diagnostic::new(
                    region.span.clone(),
                    format!(
                        "{:.0} % of '{}' is linear tetrahedra, which are too stiff {why}, and are hardly sheared",
                        100.0 * found / all,
                        body.name
                    ),
                    "mesh with hexahedra or wedges there, or halve the elements and see what changes",
                )
            })
        })
        .collect()
}

/// Linings of 2×2×2 points in one layer, of a law that cracks.
pub fn of_single_layers(case: &Case, mesh: &tremolite_mesh::Mesh, bodies: &[Body]) -> Vec<case::Diagnostic> {
    let regions = case.regions.iter().filter(|r| matches!(r.fill, case::Fill::Solid { .. }));
    let cracks = |body: &Body| position(body.material.info().history, Role::TensionDamage).is_some();
    regions
        .zip(bodies)
        .filter(|(_, body)| body.quadrature == Quadrature::Full && cracks(body))
        .filter(|(_, body)| stacks(mesh, &body.elements).iter().any(|stack| stack.len() == 1))
        .map(|(region, body)| {
            case::Diagnostic::new(
                region.span.clone(),
                format!(
                    "'{}' is one element thick, and 2×2×2 points lie inside it: in bending its fibre cracks at 1.7 times the \
                     tensile strength, and its section bears 18 % too much",
                    body.name
                ),
                "write element = \"layered\" for it",
            )
        })
        .collect()
}

/// Linings of caverns that run along x, whose bars, section forces or cracks are named by y as the axis.
pub fn of_axes(case: &Case, mesh: &tremolite_mesh::Mesh, bodies: &[Body]) -> Vec<case::Diagnostic> {
    let on = || case.reinforcement.iter().flat_map(|r| &r.on).chain(case.sections.iter().flat_map(|s| &s.on));
    let groups = mesh.groups.iter().filter(|(name, _)| on().any(|on| case::pattern::matches(on, name)));
    let mut named = vec![false; mesh.elements.len()];
    groups.flat_map(|(_, elements)| elements).for_each(|&e| named[e as usize] = true);
    let cracks = |body: &Body| position(body.material.info().history, Role::TensionDamage).is_some();
    // Which side is the inner one does not matter here.
    let standing = vec![false; mesh.elements.len()];
    let regions = case.regions.iter().filter(|r| matches!(r.fill, case::Fill::Solid { .. }));
    regions
        .zip(bodies)
        .filter(|(_, body)| cracks(body) || body.elements.iter().any(|&e| named[e as usize]))
        .filter(|(_, body)| runs_along_x(&stations(mesh, &body.elements, &standing)))
        .map(|(region, body)| {
            case::Diagnostic::new(
                region.span.clone(),
                format!(
                    "'{}' bends round x, as the lining of a cavern along x does. Caverns are taken to run along y: what is called \
                     across or round, of bars, section forces and cracks, leads along this one",
                    body.name
                ),
                "turn the mesh so that the cavern runs along y: mesh.file.rotate = \"90 deg\", with sides, points, motion and \
                 model_x_azimuth in the axes after it; or ask for bars the other way, and read the names so",
            )
        })
        .collect()
}

/// Concrete that drops to a plateau in elements so small that corners are too weak. A crack lies across the middle one of an
/// element's three extents, or the longest: the shortest is a lining's thickness.
pub fn of_plateaus(case: &Case, mesh: &tremolite_mesh::Mesh, bodies: &[Body]) -> Vec<case::Diagnostic> {
    let regions = case.regions.iter().filter(|r| matches!(r.fill, case::Fill::Solid { .. }));
    let of = |(region, body): (&case::Region, &Body)| {
        body.material.corner_strength(1.0)?;
        let middle = |&e: &u32| hex(mesh, e as usize).ok().map(|hex| sizes(&hex)[1]);
        let size = typical_extent(body.elements.iter().filter_map(middle).collect())?;
        let left = body.material.corner_strength(size).filter(|left| *left < LEAST_AT_CORNERS)?;
        Some(case::Diagnostic::new(
            region.span.clone(),
            format!(
                "'{}' drops to a plateau as it cracks, and half of its elements are {size:.3} m or smaller: at corners and the \
                 ends of cracks they bear some {:.0} % of what its fracture energy stands for, and the less the smaller they are",
                body.name,
                100.0 * left
            ),
            "write evolution = \"exponential\" for its material, unless a paper is to be followed",
        ))
    };
    regions.zip(bodies).filter_map(of).collect()
}

/// Factors that look like the half that is taken of an outcrop's motion.
const ABOUT_HALF: std::ops::RangeInclusive<f64> = 0.4..=0.6;

/// A record that is scaled by about ½ and called an outcrop's, of which half comes in.
fn halved_twice(motion: &case::Motion) -> Option<case::Diagnostic> {
    // What comes before a peak that is asked for has no say in how strong the motion is.
    let (mut whole, mut word) = (1.0, None);
    for step in &motion.processing {
        match Process::parse(&step.value) {
            Ok(Process::Scale(factor)) => (whole, word) = (whole * factor.abs(), Some(step)),
            Ok(Process::PeakAcceleration { .. } | Process::Match { .. }) => (whole, word) = (1.0, None),
            _ => {}
        }
    }
    let word = word.filter(|_| ABOUT_HALF.contains(&whole))?;
    (motion.kind.value == case::MotionKind::Outcrop).then(|| {
        case::Diagnostic::at(
            word,
            format!(
                "the motion is scaled by {whole}, and half of an outcrop's motion enters anyway: {} times the record in all",
                0.5 * whole
            ),
            "if the record is what a surface of the base's rock shows, leave the scale out; if it is halved already, write \
             kind = \"incident\"",
        )
    })
}

/// What the motion asks to be looked at.
pub fn of_motion(
    case: &Case,
    motion: &tremolite_motion::Motion,
    reference: Option<f64>,
) -> Vec<case::Diagnostic> {
    let mut warnings = Vec::new();
    warnings.extend(case.motion.as_ref().and_then(halved_twice));
    let drift = motion.drift();
    if drift > DRIFT {
        warnings.push(case::Diagnostic::new(
            case.motion.as_ref().map_or(0..0, |written| written.span.clone()),
            format!("the motion ends at {:.0} % of its largest displacement, which the model follows", 100.0 * drift),
            match case.motion.as_ref().map(|motion| motion.kind.value) {
                Some(case::MotionKind::Within | case::MotionKind::Surface) => {
                    "this is the wave found from the record, which may ring on where the record ends: put some seconds of zeros behind the \
                     record; if the record drifts itself, \"baseline\" last in motion.processing"
                }
                _ => "put \"baseline\" last in motion.processing, behind filter and taper; a high-pass alone may make it worse",
            },
        ));
    }
    if let (Some(band), Some(reference)) = (&case.dynamic.band, reference)
        && band.reference.is_none()
    {
        warnings.push(case::Diagnostic::at(
            &band.ratio,
            format!(
                "Young's moduli are taken to be meant at {reference:.2} Hz, the motion's central frequency, and are other \
                 for another record"
            ),
            "give `reference`, the frequency at which they were measured",
        ));
    }
    warnings
}
