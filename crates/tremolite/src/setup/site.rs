//! From the motion of a case to the wave that comes in: times a factor, or deconvolved through the ground it was recorded on.

use super::doubts;
use super::facts::{ENERGY_SHARE, MotionFacts, Peaks, SiteFacts, SoilFacts, largest};
use super::motion::beyond_any_earthquake;
use super::soil;
use crate::deconvolution::{Deconvolved, LEAST, Notch, Place};
use crate::layered_column::{Layer, LayeredColumn};
use crate::plan::Recorded;
use tremolite_case::{self as case, Diagnostic, Site, SiteLayer, Softening};
use tremolite_engine::column::{Ground, corner_name};
use tremolite_engine::problem::Rayleigh;
use tremolite_engine::{Body, Incident, Top, Water};
use tremolite_motion::{Motion, frequency_below, highest_frequency};

/// What of a model the way of a wave depends on.
pub struct Around<'a> {
    pub bodies: &'a [Body],
    /// In the pores of these.
    pub water: &'a Water,
    pub rayleigh: Rayleigh,
    pub top: Top,
    /// The ground at the corners, or why there is none, in words that may stand behind 'but'.
    pub grounds: Result<[Ground; 4], String>,
    /// Whether ground that is not in the model presses on its top.
    pub overburden: bool,
}

/// The wave that comes in.
pub struct Entering {
    pub incident: Incident,
    /// What it was deconvolved from.
    pub recorded: Option<Recorded>,
}

/// The wave that comes in by a motion, and what is to be reported of it; nothing where it is refused.
pub fn enter<'a>(
    motion: &case::Motion,
    given: Motion,
    facts: &mut MotionFacts,
    around: impl FnOnce() -> Around<'a>,
    problems: &mut Vec<Diagnostic>,
) -> Option<Entering> {
    if let Some(factor) = facts.factor {
        return Some(Entering { incident: Incident { motion: given, factor }, recorded: None });
    }
    match deconvolved(motion, &given, facts, &around()) {
        Ok((wave, recorded, site)) => {
            if let Some(problem) = beyond_any_earthquake(&motion.span, &wave, 1.0) {
                problems.push(problem);
                return None;
            }
            facts.incident = Peaks::of(&wave, 1.0);
            facts.highest_frequency =
                highest_frequency(&wave, ENERGY_SHARE).unwrap_or(facts.highest_frequency);
            let recorded = Recorded {
                motion: recorded,
                place: site.place.clone(),
                corner: site.corner,
                band: site.band,
            };
            facts.warnings.extend(doubts::of_site(motion, &site, &recorded.motion));
            facts.site = Some(site);
            Some(Entering { incident: Incident { motion: wave, factor: 1.0 }, recorded: Some(recorded) })
        }
        Err(problem) => {
            problems.push(problem);
            None
        }
    }
}

/// The wave, the record on the time of the run, and what is to be reported.
fn deconvolved(
    motion: &case::Motion,
    given: &Motion,
    facts: &MotionFacts,
    around: &Around,
) -> Result<(Motion, Motion, SiteFacts), Diagnostic> {
    let band = match facts.lowpass {
        Some(corner) => corner,
        None => frequency_below(&given.acceleration, given.dt, ENERGY_SHARE).unwrap_or(0.0),
    };
    let band = band.min(0.5 / given.dt);
    let Taken { place, corner, soil } = place(motion, around, &soil::Recorded { motion: given, band })?;
    let found = place
        .deconvolved(&given.acceleration, given.dt, band)
        .map_err(|(axis, notch)| refused(motion, facts, axis, &notch, band))?;
    let Deconvolved { incident, lead, reach, left_out } = found;
    let moving = (0..3).filter(|&axis| largest(&given.acceleration[axis]) > 0.0);
    let shares: Vec<(f64, f64)> = moving
        .flat_map(|axis| {
            let rest = place.at_rest(axis);
            let shares = place.shares(axis, reach.min(0.5 / given.dt)).into_iter();
            shares.map(move |(hertz, share, _)| (rest * share, hertz))
        })
        .collect();
    let extreme = |found: Option<&(f64, f64)>| found.copied().unwrap_or((place.at_rest(0), 0.0));
    let least = extreme(shares.iter().min_by(|a, b| a.0.total_cmp(&b.0)));
    let most = extreme(shares.iter().max_by(|a, b| a.0.total_cmp(&b.0)));
    let site = SiteFacts {
        depth: motion.depth.as_ref().map_or(0.0, |depth| depth.value),
        corner,
        soil,
        lead: lead as f64 * given.dt,
        band,
        reach,
        left_out,
        at_rest: place.at_rest(0),
        least,
        most,
        place,
    };
    let wave = Motion::from_acceleration(given.dt, incident).map_err(|e| {
        let (message, remedy) = e.message_and_remedy();
        Diagnostic::new(motion.span.clone(), message, remedy)
    })?;
    Ok((wave, late(given, lead), site))
}

fn refused(motion: &case::Motion, facts: &MotionFacts, axis: usize, notch: &Notch, band: f64) -> Diagnostic {
    let above = match facts.lowpass {
        Some(_) => "the low-pass of motion.processing",
        None => "below which 99.9 % of the record's energy lies",
    };
    Diagnostic::new(
        motion.span.clone(),
        format!(
            "the record cannot be turned into the wave that comes in: at {at:.2} Hz hardly anything moves where it was taken, \
             {share:.1} % of what does at low frequency (along {axis}; below {least:.0} % from {from:.2} Hz on), and the record is \
             wanted up to {band:.2} Hz, {above}",
            at = notch.at,
            share = 100.0 * notch.share,
            axis = ["x", "y", "z"][axis],
            least = 100.0 * LEAST,
            from = notch.from,
        ),
        format!(
            "put a low-pass of {:.2} Hz or less into motion.processing if the rest will do, or give a record of the surface or of an outcrop",
            0.75 * notch.from
        ),
    )
}

/// Where a record was taken.
struct Taken {
    place: Place,
    /// The corner of the model whose ground that is.
    corner: Option<usize>,
    /// What layers that soften came to.
    soil: Vec<SoilFacts>,
}

fn place(motion: &case::Motion, around: &Around, recorded: &soil::Recorded) -> Result<Taken, Diagnostic> {
    let refuse = |message: String, remedy: &str| Diagnostic::at(&motion.kind, message, remedy);
    let kind = motion.kind.value.word();
    let grounds = around.grounds.as_ref().map_err(|reason| {
        refuse(
            format!("a motion of kind \"{kind}\" goes through the ground at the model's corners, but {reason}"),
            "let the ground along the model's vertical edges be whole and stay in all stages, or give the wave itself with kind = \
             \"incident\"",
        )
    })?;
    let columns = |layers: &dyn Fn(usize) -> Vec<Layer>| {
        let column = |axis: usize| LayeredColumn::new(layers(axis), Top::Free);
        Some([column(0)?, column(1)?, column(2)?])
    };
    let own = |corner: usize| {
        let layers = |axis: usize| -> Vec<Layer> {
            let layer = |l: tremolite_engine::column::Layer| {
                let body = &around.bodies[l.body];
                Layer::of(body, l.element, around.water, l.top - l.bottom, axis, around.rayleigh)
            };
            grounds[corner].layers().map(layer).collect()
        };
        columns(&layers)
    };
    let depth = motion.depth.as_ref().map_or(0.0, |depth| depth.value);
    let none = || refuse("the model has no ground at its corners".into(), "give kind = \"incident\"");
    if let Some(Site::Layers(given)) = &motion.site {
        let base = |corner: usize, axis: usize| {
            let lowest = grounds[corner].layers().next()?;
            let body = &around.bodies[lowest.body];
            Some(Layer::of(body, lowest.element, around.water, 0.0, axis, around.rayleigh))
        };
        if (1..4).any(|corner| (0..3).any(|axis| base(corner, axis) != base(0, axis))) {
            return Err(refuse(
                "the layers of motion.site lie on the rock of the model's base, which is not the same at its four corners".into(),
                "give the wave itself with kind = \"incident\"",
            ));
        }
        let thickness: f64 = given.iter().map(|layer| layer.thickness.value).sum();
        // A place below the layers lies in rock of the base.
        let below = (depth - thickness).max(0.0);
        let made = |soil: &[SoilFacts]| {
            let layers = |axis: usize| -> Vec<Layer> {
                let base = base(0, axis).map(|layer| Layer { thickness: below, ..layer });
                let own = given.iter().enumerate().rev();
                base.into_iter().chain(own.map(|(k, layer)| of_site(layer, soil.get(k), axis))).collect()
            };
            Some(Place { columns: columns(&layers)?, height: thickness + below - depth })
        };
        let soil = match base(0, 0).filter(|_| soil::softens(given)) {
            Some(rock) => soil::fitted(motion, given, &rock, recorded, &made)?,
            None => Vec::new(),
        };
        return Ok(Taken { place: made(&soil).ok_or_else(none)?, corner: None, soil });
    }
    if around.top != Top::Free || around.overburden {
        return Err(refuse(
            format!(
                "a motion of kind \"{kind}\" was taken below a free surface, but ground goes on above this model"
            ),
            "describe the ground where it was recorded, down to the rock of the model's base, in motion.site.layers",
        ));
    }
    let corner = match &motion.site {
        Some(Site::Corner(corner)) => corner.value.index(),
        _ => {
            let first = own(0).ok_or_else(none)?;
            for corner in 1..4 {
                let other = own(corner).ok_or_else(none)?;
                if !first.iter().zip(&other).all(|(a, b)| a.close_to(b)) {
                    return Err(refuse(
                        format!(
                            "the ground is not the same at {} and {}, so it is not clear on which the record was taken",
                            corner_name(0),
                            corner_name(corner)
                        ),
                        "say where, as in site = { corner = \"xmin-ymin\" }, or describe the ground in motion.site.layers",
                    ));
                }
            }
            0
        }
    };
    let columns = own(corner).ok_or_else(none)?;
    let height = columns[0].height() - depth;
    if let Some(depth) = motion.depth.as_ref().filter(|_| height < -1e-6 * columns[0].height()) {
        return Err(Diagnostic::at(
            depth,
            format!(
                "the model's base lies {:.1} m below its surface, above the place of the record",
                columns[0].height()
            ),
            "make the model deeper, or describe the ground in motion.site.layers",
        ));
    }
    Ok(Taken { place: Place { columns, height: height.max(0.0) }, corner: Some(corner), soil: Vec::new() })
}

/// A layer of a case as waves along an axis see it; with the modulus and the damping that it came to where layers soften, waves of
/// compression by the same share of the modulus.
fn of_site(layer: &SiteLayer, soil: Option<&SoilFacts>, axis: usize) -> Layer {
    let own = if axis == 2 { layer.compression_wave_velocity() } else { layer.shear_wave_velocity.value };
    let small = match layer.softening {
        Softening::None(ref damping) => damping.value,
        _ => 0.0,
    };
    let (modulus, damping) = soil.map_or((1.0, small), |soil| (soil.modulus, soil.damping));
    Layer {
        thickness: layer.thickness.value,
        density: layer.density.value,
        speed: own * modulus.sqrt(),
        band: None,
        rayleigh: Rayleigh::default(),
        damping,
        water: None,
    }
}

/// A motion put off by so many of its steps.
fn late(motion: &Motion, steps: usize) -> Motion {
    let put_off = |columns: &[Vec<f64>; 3]| {
        columns
            .each_ref()
            .map(|column| std::iter::repeat_n(0.0, steps).chain(column.iter().copied()).collect())
    };
    Motion {
        dt: motion.dt,
        acceleration: put_off(&motion.acceleration),
        velocity: put_off(&motion.velocity),
        displacement: put_off(&motion.displacement),
    }
}
