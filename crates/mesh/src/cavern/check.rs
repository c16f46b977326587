//! Whether a description of caverns can be meshed, as far as single values and caverns tell.

use super::error::{MOST_CAVERNS, Named, value};
use super::profile::Profile;
use super::tube::{HORSESHOE, Tube};
use super::{Cavern, CavernError, CavernShape, CavernSpec, Shotcrete, along, gallery, ground, name, strata};

const MOST_LAYERS: u32 = 20;

/// Quadrilaterals in the clear section of a cavern. Smoothing them takes a millisecond each, and their elements would have time steps
/// that no earthquake is integrated with.
const MOST_IN_SECTION: f64 = 40_000.0;

/// The checks that need no geometry of the block as a whole.
pub(super) fn check(spec: &CavernSpec) -> Result<(), CavernError> {
    let lengths = [
        ("overburden", spec.overburden),
        ("below", spec.below),
        ("sides", spec.sides),
        ("length", spec.length),
        ("size_near", spec.near),
        ("size_far", spec.far),
        ("size_along", spec.along.unwrap_or(spec.near)),
    ];
    for (key, length) in lengths {
        // A block larger than the Earth is a slip, and its squares stay finite.
        if !(length > 0.0 && length <= 1e7) {
            return Err(value(key, length, "a length above 0 (and at most 1e7 m)"));
        }
    }
    if spec.far < spec.near {
        return Err(value("size_far", spec.far, format!("at least `size_near`, {} m", spec.near)));
    }
    if spec.caverns.is_empty() || spec.caverns.len() > MOST_CAVERNS {
        return Err(CavernError::Caverns { count: spec.caverns.len() });
    }
    for (k, cavern) in spec.caverns.iter().enumerate() {
        let taken = spec.caverns[..k].iter().any(|other| other.name == cavern.name);
        name::check(Named::Cavern, &cavern.name, taken)?;
        check_cavern(cavern, spec.near)?;
        check_size(cavern, spec.near)?;
    }
    strata::check(&spec.layers)?;
    ground::check(&spec.ground)?;
    gallery::check(spec)?;
    along::check(spec)
}

/// Before anything is laid out or smoothed: a slip of the unit of `near` would else be told after minutes.
fn check_size(cavern: &Cavern, near: f64) -> Result<(), CavernError> {
    let area = cavern.width * cavern.height;
    let count = area / (near * near);
    if count <= MOST_IN_SECTION {
        return Ok(());
    }
    // To the centimetre above, so that what is named is taken.
    let least = (100.0 * (area / MOST_IN_SECTION).sqrt()).ceil() / 100.0;
    let must = format!(
        "at least {least:.2} m, since the section of cavern {:?} would have some {count:.0} elements and at most {MOST_IN_SECTION} \
         are taken; look at its unit",
        cavern.name
    );
    Err(value("size_near", near, must))
}

fn check_cavern(cavern: &Cavern, near: f64) -> Result<(), CavernError> {
    let key = |k: &str| format!("{}.{k}", cavern.name);
    let rise =
        if matches!(cavern.shape, CavernShape::Arch | CavernShape::Ellipse) { cavern.arch_rise } else { 1.0 };
    for (k, length) in [("width", cavern.width), ("height", cavern.height), ("arch_rise", rise)] {
        if !(length > 0.0 && length <= 1e5) {
            return Err(value(key(k), length, "a length above 0 (and at most 1e5 m)"));
        }
    }
    for at in cavern.at {
        if !(-1e6..=1e6).contains(&at) {
            return Err(value(key("at"), at, "a length (and at most 1e6 m)"));
        }
    }
    let half = cavern.width / 2.0;
    let (walls, what) = match cavern.shape {
        CavernShape::Arch | CavernShape::Ellipse => {
            let (most, why) = if cavern.shape == CavernShape::Arch {
                (half, "half the width")
            } else {
                (cavern.width, "the width")
            };
            if cavern.arch_rise > most * (1.0 + 1e-12) {
                let must = format!("at most {why}, {most} m, for a roof of this shape");
                return Err(value(key("arch_rise"), cavern.arch_rise, must));
            }
            // An ellipse that is flatter bends too sharply at the springings.
            let least = if cavern.shape == CavernShape::Arch { 0.02 } else { 0.15 } * cavern.width;
            if cavern.arch_rise < least {
                let must = format!(
                    "at least {least:.3} m for a roof of this shape over {} m, its `width`",
                    cavern.width
                );
                return Err(value(key("arch_rise"), cavern.arch_rise, must));
            }
            (cavern.height - cavern.arch_rise, "straight wall")
        }
        CavernShape::Rectangle => (cavern.height, "straight wall"),
        CavernShape::Circle => {
            if (cavern.height / cavern.width - 1.0).abs() > 1e-9 {
                let must = format!("the width, {} m, for a circle", cavern.width);
                return Err(value(key("height"), cavern.height, must));
            }
            (cavern.height * std::f64::consts::FRAC_1_SQRT_2, "wall")
        }
        CavernShape::Horseshoe => {
            let [low, high] = HORSESHOE.map(|share| share * cavern.width);
            if !(low..=high).contains(&cavern.height) {
                let must = format!(
                    "from {low} m to {high} m for a horseshoe of this width: a higher hall has straight walls, shape = \"arch\""
                );
                return Err(value(key("height"), cavern.height, must));
            }
            let [low, high] = Tube::new(cavern).wall();
            (high - low, "wall")
        }
    };
    if walls < 0.25 * near {
        let closed = cavern.shape.is_closed();
        let least =
            if closed { cavern.height * 0.25 * near / walls } else { cavern.height - walls + 0.25 * near };
        let must = format!(
            "at least {:.2} m, so that its {what} is a quarter of `size_near` high{}",
            (100.0 * least).ceil() / 100.0,
            if closed { String::new() } else { format!(" above the arch rise, {} m", cavern.arch_rise) }
        );
        return Err(value(key("height"), cavern.height, must));
    }
    let most = (walls / (0.25 * near)).floor();
    if cavern.benches == 0 || f64::from(cavern.benches) > most {
        let must = format!(
            "from 1 to {most}: with {walls} m of {what} a bench may not be lower than a quarter of `size_near`"
        );
        return Err(value(key("benches"), f64::from(cavern.benches), must));
    }
    check_shotcrete(cavern, half, &key)?;
    check_lining(cavern, half, &key)
}

fn check_shotcrete(cavern: &Cavern, half: f64, key: &dyn Fn(&str) -> String) -> Result<(), CavernError> {
    let Shotcrete { thickness, layers } = cavern.shotcrete;
    if !(thickness >= 0.0 && thickness <= half) {
        return Err(value(key("shotcrete"), thickness, format!("from 0 to half the width, {half} m")));
    }
    if thickness > 0.0 && !(1..=MOST_LAYERS).contains(&layers) {
        return Err(value(key("shotcrete_layers"), f64::from(layers), format!("from 1 to {MOST_LAYERS}")));
    }
    Ok(())
}

fn check_lining(cavern: &Cavern, half: f64, key: &dyn Fn(&str) -> String) -> Result<(), CavernError> {
    let lining = &cavern.lining;
    for (k, thickness) in
        [("lining.walls", lining.walls), ("lining.crown", lining.crown), ("lining.floor", lining.floor)]
    {
        if !(thickness >= 0.0 && thickness <= half) {
            return Err(value(key(k), thickness, format!("from 0 to half the width, {half} m")));
        }
    }
    if lining.is_none() {
        return Ok(());
    }
    if lining.walls == 0.0 || lining.crown == 0.0 {
        let (k, other) = if lining.walls == 0.0 { ("walls", "crown") } else { ("crown", "walls") };
        let must = format!("above 0 where `lining.{other}` is, or leave out both and the floor");
        return Err(value(key(&format!("lining.{k}")), 0.0, must));
    }
    if lining.layers == 0 || lining.layers > MOST_LAYERS {
        let must = format!("from 1 to {MOST_LAYERS}");
        return Err(value(key("lining.layers"), f64::from(lining.layers), must));
    }
    if cavern.shape.is_closed() {
        if lining.floor == 0.0 {
            return Err(value(key("lining.floor"), 0.0, "above 0: round this shape the lining is closed"));
        }
        return Ok(());
    }
    if cavern.shape != CavernShape::Arch {
        return Ok(());
    }
    let profile = Profile::new(cavern);
    // Shotcrete adds to rise and half width alike, or more to the latter.
    let rise = profile.lined.rise;
    if rise < 0.02 * cavern.width || rise > 1.1 * profile.lined.half {
        let least = lining.crown + 0.02 * cavern.width - rise;
        let most = lining.crown + 1.1 * profile.lined.half - rise;
        let must = format!(
            "from {:.3} m to {most:.3} m, so that the extrados stays an arch on walls of {} m",
            least.max(0.0),
            lining.walls
        );
        return Err(value(key("lining.crown"), lining.crown, must));
    }
    Ok(())
}
