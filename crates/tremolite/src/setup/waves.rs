//! Waves at angles of a case: what they are in the model's axes, what of them is refused, and the field that they make.

use super::facts::{MotionFacts, Peaks, WaveFacts, largest};
use super::site::Around;
use crate::plan::PlannedWaves;
use crate::waves::resolved::{column, resolve};
use crate::waves::surface::coefficients;
use crate::waves::{Entering, Frame, Heading, LayeredGround, ObliqueField, Rock, Stratum, WaveType};
use std::sync::Arc;
use tremolite_case::{self as case, Case, Diagnostic, SurfacePart, WaveComponent, WaveWord};
use tremolite_engine::column::{Ground, corner_name};
use tremolite_motion::{Complex64, Motion};

/// The part of a surface's motion over the wave's below which that tells nothing of the wave: a twentieth of what it is straight up.
const LEAST: f64 = 0.1;
/// Of a sum of three products, over the largest.
const ROUND_OFF: f64 = 1e-12;
/// A component of a direction that counts as none.
const STILL: f64 = 1e-9;

/// Type and way of a wave in the model's axes.
fn heading(wave: &case::Wave, model_x_azimuth: f64) -> Heading {
    let kind = match wave.kind.value {
        WaveWord::P => WaveType::P,
        WaveWord::Sv => WaveType::Sv,
        WaveWord::Sh => WaveType::Sh,
    };
    Heading::new(kind, wave.angle.value, wave.azimuth.value, model_x_azimuth)
}

/// Refuses sides that cannot stand where waves at angles come.
pub fn check_sides(case: &Case, motion: &case::Motion, problems: &mut Vec<Diagnostic>) {
    let mut found = Vec::new();
    for (axis, side) in case.dynamic.sides.iter().enumerate() {
        let name = ["x", "y"][axis];
        let free = "write \"free-field\"";
        let mut refuse = |message: String| found.push(Diagnostic::at(side, message, free));
        match side.value {
            case::Side::FreeField => {}
            case::Side::Viscous | case::Side::Free => refuse(format!(
                "waves at an angle come in through free-field sides alone, and those across {name} are {}",
                side.value.word()
            )),
            case::Side::Fixed => refuse(format!(
                "the fixed sides across {name} do not move, while waves at an angle move the ground beside them"
            )),
            case::Side::Periodic | case::Side::Roller | case::Side::Symmetry => {
                let word = side.value.word();
                let periodic = side.value == case::Side::Periodic;
                for wave in &motion.waves {
                    let heading = heading(wave, motion.model_x_azimuth.value);
                    let travels = heading.way()[axis].abs() > STILL;
                    let moves = heading.polarisation()[axis].abs() > STILL;
                    let what = wave.kind.value.word();
                    if travels {
                        refuse(format!(
                            "a {what} wave of [[motion.wave]] travels across the {word} sides across {name}"
                        ));
                    } else if !periodic && wave.kind.value == WaveWord::Sh {
                        refuse(format!(
                            "an SH wave of [[motion.wave]] is not its own mirror image, and the {word} sides across {name} ask for that"
                        ));
                    } else if !periodic && moves {
                        refuse(format!(
                            "a {what} wave of [[motion.wave]] moves the ground along {name}, which the {word} sides across {name} hold"
                        ));
                    } else {
                        continue;
                    }
                    break;
                }
            }
        }
    }
    found.dedup_by(|a, b| a.span == b.span);
    problems.extend(found);
}

/// The motion along east, north and up, of that along the model's axes.
fn geographic(motion: &Motion, model_x_azimuth: f64) -> Motion {
    let (sin, cos) = model_x_azimuth.sin_cos();
    let whole = |x: f64| if x.abs() < 1e-15 { 0.0 } else { x };
    let (sin, cos) = (whole(sin), whole(cos));
    let turned = |[x, y, z]: &[Vec<f64>; 3]| {
        let pairs = || x.iter().zip(y);
        [
            pairs().map(|(x, y)| x * sin - y * cos).collect(),
            pairs().map(|(x, y)| x * cos + y * sin).collect(),
            z.clone(),
        ]
    };
    Motion {
        dt: motion.dt,
        acceleration: turned(&motion.acceleration),
        velocity: turned(&motion.velocity),
        displacement: turned(&motion.displacement),
    }
}

/// The ground that waves come through: that of the model's corners, alike at all of them.
fn ground(motion: &case::Motion, around: &Around) -> Result<LayeredGround, Diagnostic> {
    let refuse =
        |message: String, remedy: &str| Diagnostic::new(motion.waves[0].span.clone(), message, remedy);
    let grounds = around.grounds.as_ref().map_err(|reason| {
        refuse(
            format!("waves at an angle come through the ground at the model's corners, but {reason}"),
            "let the ground along the model's vertical edges be whole and stay in all stages",
        )
    })?;
    let of = |ground: &Ground| {
        let strata = ground.layers().map(|layer| Stratum {
            thickness: layer.top - layer.bottom,
            rock: Rock::in_water(&around.bodies[layer.body], layer.element, around.water, around.rayleigh),
        });
        LayeredGround::new(strata, around.top)
    };
    let none = || refuse("the model has no ground at its corners".into(), "leave [[motion.wave]] out");
    let first = of(&grounds[0]).ok_or_else(none)?;
    for (corner, other) in grounds.iter().enumerate().skip(1) {
        if !of(other).ok_or_else(none)?.close_to(&first) {
            return Err(refuse(
                format!(
                    "waves at an angle come through level layers, and the ground is not the same at {} and {}",
                    corner_name(0),
                    corner_name(corner)
                ),
                "let layers be level and alike at all four corners, or leave [[motion.wave]] out",
            ));
        }
    }
    Ok(first)
}

/// What the waves of a motion are of its components, by wave, and the condition of that where they carry all together.
fn factors(motion: &case::Motion, base: &Rock) -> Result<(Vec<[Complex64; 3]>, Option<f64>), Diagnostic> {
    if motion.waves.iter().any(|wave| wave.component.value == WaveComponent::Together) {
        let (factors, condition) = together(motion, base)?;
        return Ok((factors.to_vec(), Some(condition)));
    }
    let of = |wave: &case::Wave| {
        let mut factors = [Complex64::default(); 3];
        factors[wave.component.value as usize] = factor(motion, wave, base)?;
        Ok(factors)
    };
    Ok((motion.waves.iter().map(of).collect::<Result<_, _>>()?, None))
}

/// The same of a P, an SV and an SH wave that together move a place as it is recorded, and the condition of it.
fn together(motion: &case::Motion, base: &Rock) -> Result<([[Complex64; 3]; 3], f64), Diagnostic> {
    // Along east and north.
    let headings = motion.waves.iter().map(|wave| heading(wave, std::f64::consts::FRAC_PI_2));
    let columns: Vec<[Complex64; 3]> = headings
        .map(|heading| match motion.kind.value {
            case::MotionKind::Outcrop => column(&heading, coefficients(heading.kind, heading.angle, base)),
            _ => heading.polarisation().map(Complex64::from),
        })
        .collect();
    let refuse = |message: String| {
        Diagnostic::at(
            &motion.waves[0].component,
            message,
            "choose other angles or azimuths, or give each wave a component of its own",
        )
    };
    let columns = <[[Complex64; 3]; 3]>::try_from(columns)
        .map_err(|_| refuse("a P, an SV and an SH wave carry a record together".into()))?;
    let found = resolve(columns)
        .ok_or_else(|| refuse("these three waves do not move a place in three directions, so that they cannot carry a record together".into()))?;
    if found.least < LEAST {
        return Err(refuse(format!(
            "some motion of the place takes waves {:.0} times as large as it is (condition {:.0}), so what is recorded there tells little of \
             these waves",
            1.0 / found.least,
            found.condition
        )));
    }
    let mut factors = found.factors;
    for (row, wave) in factors.iter_mut().zip(&motion.waves) {
        let most = row.iter().map(|factor| factor.norm()).fold(0.0, f64::max);
        for factor in row {
            // Round-off turns nothing in phase.
            let im = if factor.im.abs() < ROUND_OFF * most { 0.0 } else { factor.im };
            *factor = Complex64::new(factor.re, im) * wave.scale.value;
        }
    }
    Ok((factors, found.condition))
}

/// What the component of a wave is times: its scale, over what of the wave a surface of bare rock shows.
fn factor(motion: &case::Motion, wave: &case::Wave, base: &Rock) -> Result<Complex64, Diagnostic> {
    let scale = wave.scale.value;
    if motion.kind.value != case::MotionKind::Outcrop {
        return Ok(Complex64::from(scale));
    }
    let kind = heading(wave, 0.0).kind;
    let [along, across, up] = coefficients(kind, wave.angle.value, base);
    let up_asked = wave.part.as_ref().is_some_and(|part| part.value == SurfacePart::Up);
    let (coefficient, word) = match kind {
        WaveType::Sh => (across, "across its way"),
        _ if up_asked => (up, "upwards"),
        _ => (along, "along its way in plan"),
    };
    if coefficient.norm() < LEAST {
        let other = if up_asked { "along" } else { "up" };
        return Err(Diagnostic::at(
            &wave.angle,
            format!(
                "bare rock under this {} wave at {:.2} deg moves {:.3} times the wave {word}, so what is recorded there tells nothing of it",
                kind.word(),
                wave.angle.value.to_degrees(),
                coefficient.norm()
            ),
            format!(
                "write part = \"{other}\", another angle, or the wave's own motion with kind = \"incident\""
            ),
        ));
    }
    Ok(scale / coefficient)
}

/// Components of a file with all components that no wave carries. One that is written by itself is refused before.
fn not_carried(written: &case::Motion, given: &Motion) -> Vec<Diagnostic> {
    let case::Records::File(file) = &written.records else { return Vec::new() };
    let carries = |component: WaveComponent| {
        let by = |wave: &case::Wave| [component, WaveComponent::Together].contains(&wave.component.value);
        written.waves.iter().any(by)
    };
    [WaveComponent::East, WaveComponent::North, WaveComponent::Up]
        .into_iter()
        .zip(&given.acceleration)
        .filter(|(component, a)| largest(a) > 0.0 && !carries(*component))
        .map(|(component, a)| {
            let name = component.word();
            Diagnostic::at(
                file,
                format!("component '{name}': {:.3} m/s2 at most; no [[motion.wave]] carries it, so it does not enter", largest(a)),
                format!("add a wave with component = \"{name}\", or give the components that are meant by `east`, `north` and `up`"),
            )
        })
        .collect()
}

/// The field of all waves of a motion, and what is to be reported of it; nothing where it is refused.
pub fn enter(
    case: &Case,
    written: &case::Motion,
    given: &Motion,
    facts: &mut MotionFacts,
    around: &Around,
    bounds: [[f64; 3]; 2],
    problems: &mut Vec<Diagnostic>,
) -> Option<PlannedWaves> {
    match field(case, written, given, facts, around, bounds) {
        Ok(planned) => Some(planned),
        Err(problem) => {
            problems.push(problem);
            None
        }
    }
}

fn field(
    case: &Case,
    written: &case::Motion,
    given: &Motion,
    facts: &mut MotionFacts,
    around: &Around,
    bounds: [[f64; 3]; 2],
) -> Result<PlannedWaves, Diagnostic> {
    facts.warnings.extend(not_carried(written, &geographic(given, written.model_x_azimuth.value)));
    let ground = ground(written, around)?;
    let base = ground.below();
    let azimuth = written.model_x_azimuth.value;
    let motion = Arc::new(geographic(given, azimuth));
    let (factors, condition) = factors(written, &base)?;
    let mut waves = Vec::with_capacity(written.waves.len());
    for (wave, factors) in written.waves.iter().zip(factors) {
        let carries = |(factor, a): (&Complex64, &Vec<f64>)| factor.norm() * largest(a) > 0.0;
        if !factors.iter().zip(&motion.acceleration).any(carries) {
            return Err(Diagnostic::new(
                wave.span.clone(),
                "this wave carries nothing: its component of the motion, or its scale, is zero",
                "leave the wave out, or name the component that it is to carry",
            ));
        }
        waves.push(Entering { heading: heading(wave, azimuth), motion: motion.clone(), factors });
    }
    let centre = [0, 1].map(|i| 0.5 * (bounds[0][i] + bounds[1][i]));
    let frame = Frame {
        bounds,
        at: written.at.as_ref().map_or(centre, |at| at.value),
        frequency: facts.highest_frequency,
        duration: case.dynamic.duration.as_ref().map(|duration| duration.value),
        ground,
    };
    if let Some(at) = &written.at {
        let delays = waves.iter().flat_map(|wave| frame.delays(&wave.heading));
        let longest = delays.map(f64::abs).fold(0.0, f64::max);
        if longest > given.duration() {
            return Err(Diagnostic::at(
                at,
                format!(
                    "waves come to the model {longest:.1} s before or after this place, longer than the record lasts ({:.1} s)",
                    given.duration()
                ),
                "name a place in the model or near it, in the model's axes",
            ));
        }
    }
    let field = ObliqueField::new(&frame, &waves).map_err(|found| {
        Diagnostic::new(
            written.waves[found.wave].span.clone(),
            format!(
                "the ground rings longer under this wave than can be followed: behind {:.0} s {:.1e} of the largest velocity is left",
                found.rings.span, found.rings.left
            ),
            "give the rock damping, leave out layers far softer than what lies below them, or choose an angle below the critical one",
        )
    })?;
    // Each wave has its own.
    facts.factor = None;
    facts.waves = waves
        .iter()
        .zip(&written.waves)
        .map(|(wave, written)| WaveFacts::of(wave, written, &frame))
        .collect();
    facts.condition = condition;
    facts.lead = field.lead();
    facts.series = field.bytes();
    let planned = PlannedWaves::new(field, frame, waves, given);
    facts.incident = Peaks::of(&planned.incident, 1.0);
    Ok(planned)
}
