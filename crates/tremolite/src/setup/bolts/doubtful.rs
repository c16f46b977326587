//! What of bolts cannot be meant, and what is hardly meant.

use super::listed::Standing;
use super::wall::{minus, norm};
use tremolite_case::{self as case, Diagnostic, units};
use tremolite_laws::Dimension;

/// Length of a segment over that on which the bond passes force on, beyond which ends are not resolved: a chain of such segments
/// passes force on over a length 12 % too long (arcosh(1 + h²/2)/h at h = 2).
const COARSE: f64 = 2.0;
/// Bolts of which the segments are looked at.
const LOOKED_AT: usize = 50;
/// Young's moduli \[Pa\] of bars, of plastic ones too, and stresses at which they yield.
const YOUNG: [f64; 2] = [1e9, 1e12];
const YIELD: [f64; 2] = [10e6, 5e9];
/// A diameter \[m\] beyond which it is no bar's: the thickest threaded bars have 75 mm, bundles of strands some 150.
const THICKEST: f64 = 0.16;
/// A pretension \[N\] below which its unit is forgotten.
const LEAST: f64 = 1e3;
/// Depth \[m\] in front of a plate within which the wall must be.
const BEFORE_PLATE: f64 = 0.05;

/// A pretension that the bond cannot hold, of the first bolt with one.
pub fn pulled_out(written: &case::Bolts, ends: &[[[f64; 3]; 2]]) -> Option<Diagnostic> {
    let (bond, pretension) = (written.bond.as_ref()?, written.pretension.as_ref()?);
    let friction = bond.friction_angle.value > 0.0;
    if friction || written.plate.value.ends()[1] {
        return None;
    }
    let free = written.free_length.as_ref().map_or(0.0, |free| free.value);
    let held = |ends: &[[f64; 3]; 2]| bond.strength.value * (norm(minus(ends[1], ends[0])) - free).max(0.0);
    let least = ends.iter().map(held).fold(f64::INFINITY, f64::min);
    (least <= pretension.value).then(|| {
        Diagnostic::at(
            pretension,
            format!(
                "the bond behind the free length holds {}, no more than the pretension pulls: bolts would be drawn out",
                units::format(least, Dimension::FORCE)
            ),
            "make the bond stronger or longer, or the pretension smaller",
        )
    })
}

/// Numbers that look as if another unit had been meant.
pub fn units(written: &case::Bolts) -> Vec<Diagnostic> {
    let mut warnings = Vec::new();
    let stresses = [
        ("Young's modulus", Some(&written.young), YOUNG),
        ("the yield stress", written.yields.as_ref(), YIELD),
    ];
    for (what, value, [least, most]) in stresses {
        if let Some(value) = value.filter(|value| !(least..=most).contains(&value.value)) {
            let shown = units::format(value.value, Dimension::PRESSURE);
            let usual = [least, most].map(|x| units::format(x, Dimension::PRESSURE));
            warnings.push(Diagnostic::at(
                value,
                format!("{what} of a bolt is {shown}, which is no steel and no other bar"),
                format!("look at the unit: {} to {} is usual", usual[0], usual[1]),
            ));
        }
    }
    if written.diameter.value > THICKEST {
        warnings.push(Diagnostic::at(
            &written.diameter,
            format!("a bolt is {} thick", units::format(written.diameter.value, Dimension::LENGTH)),
            "look at the unit: bars have 16 to 75 mm, anchors of many strands up to 150 mm",
        ));
    }
    if let Some(pretension) = written.pretension.as_ref().filter(|p| p.value > 0.0 && p.value < LEAST) {
        warnings.push(Diagnostic::at(
            pretension,
            format!("the pretension is {}", units::format(pretension.value, Dimension::FORCE)),
            "look at the unit: tens or hundreds of kN are usual",
        ));
    }
    warnings
}

/// That the bond passes force on over less than a segment, where ends matter: at plates and behind free lengths.
pub fn coarse(ground: &Standing, written: &case::Bolts, ends: &[[[f64; 3]; 2]]) -> Option<Diagnostic> {
    let bond = written.bond.as_ref()?;
    if written.plate.value.ends() == [false; 2] {
        return None;
    }
    let transfer = (written.young.value * written.area() / bond.stiffness.value).sqrt();
    let step = ends.len().div_ceil(LOOKED_AT).max(1);
    let pieces: Vec<f64> = ends.iter().step_by(step).filter_map(|&ends| ground.piece(ends)).collect();
    let mean = pieces.iter().sum::<f64>() / pieces.len().max(1) as f64;
    let segment = bond.segment.as_ref().map_or(mean, |longest| longest.value.min(mean));
    (segment > COARSE * transfer).then(|| {
        Diagnostic::at(
            bond.segment.as_ref().unwrap_or(&bond.stiffness),
            format!(
                "the bond passes force on over {transfer:.2} m, a segment is some {segment:.2} m long: forces near plates and ends \
                 are smeared over it",
            ),
            format!(
                "write segment = \"{:.2} m\" in `bond` where that matters (more segments, slower); else leave it",
                0.5 * transfer
            ),
        )
    })
}

/// Plates that press on no wall: ground stands in front of them, and nothing that was installed there.
pub fn buried(
    ground: &Standing,
    written: &case::Bolts,
    ends: &[[[f64; 3]; 2]],
    installed: impl Fn(u32) -> bool,
) -> Option<Diagnostic> {
    let plates = written.plate.value.ends();
    let stands = |k: usize, &[head, tail]: &[[f64; 3]; 2]| {
        let [from, to] = if k == 0 { [tail, head] } else { [head, tail] };
        let way = minus(to, from);
        let size = norm(way);
        let beyond = [0, 1, 2].map(|i| to[i] + BEFORE_PLATE * way[i] / size);
        ground.locator.locate(beyond, 0.0).is_some_and(|found| !installed(found.element))
    };
    let buried = |ends: &[[f64; 3]; 2]| (0..2).find(|&k| plates[k] && stands(k, ends));
    let (k, first) = ends.iter().find_map(|ends| buried(ends).map(|k| (k, ends)))?;
    let count = ends.iter().filter(|ends| buried(ends).is_some()).count();
    let [x, y, z] = first[k];
    let swapped = plates[1 - k] != plates[k] && !stands(1 - k, first);
    let remedy = if swapped {
        "the other end is at a wall: give the head first"
    } else {
        "place the bolts in the stage that lays the wall bare, or put the end on the wall"
    };
    Some(Diagnostic::new(
        written.span.clone(),
        format!(
            "{count} of {} bolts of '{}' have a plate inside what stands, the first at ({x:.2}, {y:.2}, {z:.2}) m",
            ends.len(),
            written.name.value
        ),
        remedy,
    ))
}
