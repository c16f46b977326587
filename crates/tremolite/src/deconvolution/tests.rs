//! There and back again, and against closed forms.

use super::*;
use crate::layered_column::Layer;
use tremolite_engine::Top;
use tremolite_engine::problem::Rayleigh;
use tremolite_laws::band::Band;
use tremolite_motion::{Channel, Motion, Process, process};

const NONE: Rayleigh = Rayleigh { mass: 0.0, stiffness: 0.0 };
const ROCK: Layer = Layer {
    thickness: 100.0,
    density: 2700.0,
    speed: 2000.0,
    band: None,
    rayleigh: NONE,
    damping: 0.0,
    water: None,
};
const SOIL: Layer = Layer { thickness: 20.0, density: 1900.0, speed: 300.0, damping: 0.05, ..ROCK };

fn place(layers: &[Layer], height: f64) -> Place {
    let column = || LayeredColumn::new(layers.iter().copied(), Top::Free).unwrap();
    Place { columns: [column(), column(), column()], height }
}

const DT: f64 = 0.005;

/// Bursts around 3 s and 6 s, with nothing to speak of above 9 Hz.
fn record() -> Vec<f64> {
    let burst = |t: f64, at: f64, hertz: f64| (TAU * hertz * t).sin() * (-((t - at) / 0.6).powi(2)).exp();
    (0..2000).map(|k| f64::from(k) * DT).map(|t| burst(t, 3.0, 2.0) + 0.5 * burst(t, 6.0, 7.0)).collect()
}

fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// A signal that is given by samples, linear between them and zero outside.
fn linear(samples: &[f64]) -> impl Fn(f64) -> f64 {
    |t| {
        let (k, part) = ((t / DT + 1e-9).floor(), (t / DT + 1e-9).fract());
        let of = |k: f64| samples.get(k as usize).copied().unwrap_or(0.0);
        (1.0 - part) * of(k) + part * of(k + 1.0)
    }
}

/// A record along one axis.
fn along(axis: usize, record: &[f64]) -> [Vec<f64>; 3] {
    [0, 1, 2].map(|k| if k == axis { record.to_vec() } else { vec![0.0; record.len()] })
}

/// What goes through the column forwards and back again, over the record's peak.
fn error(place: &Place, band: f64) -> f64 {
    let record = record();
    let Deconvolved { incident, lead: late, .. } = place.deconvolved(&along(0, &record), DT, band).unwrap();
    assert_eq!(incident[0].len(), record.len() + late);
    let duration = (incident[0].len() - 1) as f64 * DT;
    let back = &place.columns[0].velocities_at(&[place.height], linear(&incident[0]), DT, duration)[0];
    let before = largest(back[..late].iter().copied());
    before.max(largest(record.iter().zip(&back[late..]).map(|(r, b)| r - b)))
        / largest(record.iter().copied())
}

#[test]
fn what_is_deconvolved_comes_out_at_its_place_again() {
    let band = Some(Band::fit(0.03, [0.5, 20.0], 3.0).unwrap());
    for (layers, height) in [
        (vec![ROCK, SOIL], 120.0),
        (vec![Layer { band, ..ROCK }, SOIL], 110.0),
        (vec![ROCK, Layer { rayleigh: Rayleigh { mass: 0.5, stiffness: 1e-3 }, ..SOIL }], 115.0),
        (vec![ROCK], 100.0),
        // Its notch lies at 12.5 Hz, above the record.
        (vec![ROCK], 60.0),
        (vec![Layer { thickness: 0.0, ..ROCK }, SOIL], 20.0),
    ] {
        let place = place(&layers, height);
        let found = error(&place, 11.0);
        println!("{height} m: {found:.1e}");
        // Round-off, damped and let grow again by 10⁶ over four records; that of the band's sums of reciprocals is larger.
        assert!(found < if layers[0].band.is_some() { 1e-5 } else { 1e-7 }, "{height} m: {found:.1e}");
    }
}

/// On the surface of rock half the record goes up, and comes to the base before: there is no layer to be known.
#[test]
fn on_the_surface_of_undamped_rock_half_the_record_comes_in_earlier() {
    let (record, place) = (record(), place(&[ROCK], 100.0));
    let found = place.deconvolved(&along(2, &record), DT, 20.0).unwrap();
    assert_eq!((found.lead, found.reach, found.left_out), (10, f64::INFINITY, 0.0));
    for (k, a) in record.iter().enumerate() {
        assert!((found.incident[2][k] - 0.5 * a).abs() < 1e-9, "{k}: {} {a}", found.incident[2][k]);
    }
}

/// A record that comes to rest makes a wave that does, also where what is above a notch fades out and shakes from the first
/// sample on.
#[test]
fn the_wave_of_a_record_that_comes_to_rest_does_not_drift() {
    let hum = |t: f64| (1..60).map(|k| (TAU * 0.21 * f64::from(k) * t + 2.4 * f64::from(k * k)).sin()).sum();
    let mut channel = Channel::new("hum", DT, (0..2000).map(|k| hum(f64::from(k) * DT)).collect());
    let steps = ["taper 0.2 s", "baseline"].map(|step| Process::parse(step).unwrap());
    process(&mut [&mut channel], &steps).unwrap();
    let record = channel.acceleration;
    for depth in [0.0, 30.0, 50.0, 80.0] {
        let place = place(&[ROCK], 100.0 - depth);
        let band = place.notch(0, 100.0).map_or(20.0, |notch| 0.85 * notch.from);
        let found = place.deconvolved(&along(0, &record), DT, band).unwrap();
        let wave = Motion::from_acceleration(DT, found.incident).unwrap();
        println!("{depth} m: lead {} s, drift {:.1e}", found.lead as f64 * DT, wave.drift());
        assert!(wave.drift() < 0.02, "{depth} m: {}", wave.drift());
    }
}

/// Under h of undamped ground of speed c the first notch lies at c/4h.
#[test]
fn a_notch_is_found_at_its_frequency_and_refused_within_the_band() {
    for (depth, hertz) in [(50.0, 10.0), (25.0, 20.0), (100.0, 5.0)] {
        let place = place(&[ROCK], 100.0 - depth);
        let notch = place.notch(0, 100.0).unwrap();
        assert!((notch.at - hertz).abs() < 1e-3 * hertz && notch.share < 1e-3, "{notch:?}");
        // |cos| = 0.05 at the edge.
        let edge = hertz * LEAST.acos() / (0.5 * PI);
        assert!((notch.from - edge).abs() < 1e-6 * hertz, "{notch:?} {edge}");
        let record = record();
        for band in [0.951, 1.0, 1.1] {
            assert_eq!(place.deconvolved(&along(0, &record), DT, band * edge).unwrap_err(), (0, notch));
        }
        // All of the band is kept, and less than it is never said.
        for (band, reach) in [(0.949, 0.949), (0.1, FADE[0])] {
            let kept = place.deconvolved(&along(0, &record), DT, band * edge).unwrap();
            assert!((kept.reach - reach * edge).abs() < 1e-6 * edge, "{}", kept.reach);
        }
        let kept = place.deconvolved(&along(0, &record), DT, 0.949 * edge).unwrap();
        // The burst at 7 Hz holds a fifth of the record's energy, and 5 Hz lies far below it.
        assert!(
            if hertz < 7.0 { (kept.left_out - 0.2).abs() < 0.01 } else { kept.left_out < 1e-6 },
            "{}",
            kept.left_out
        );
        assert_eq!(place.notch(0, 0.999 * notch.from), None);
    }
}

#[test]
fn what_is_damped_away_is_refused_as_well_and_what_stands_still_asks_for_nothing() {
    let mud = Layer { thickness: 100.0, speed: 100.0, damping: 0.1, ..SOIL };
    let place = place(&[ROCK, mud], 200.0);
    let notch = place.notch(0, 100.0).unwrap();
    assert!(
        notch.from < 30.0 && notch.at == notch.from && (notch.share / LEAST - 1.0).abs() < 1e-6,
        "{notch:?}"
    );
    assert!(place.deconvolved(&along(0, &record()), DT, 30.0).is_err());
    let still = place.deconvolved(&along(0, &[0.0; 50]), DT, 30.0).unwrap();
    assert!(still.incident[0].len() > 50 && still.incident.iter().flatten().all(|a| *a == 0.0));
}

/// At the foot of h of undamped soil on rock H = 2/(1 + iα tan kh): its notches, at odd multiples of c/4h, are as narrow as the
/// ratio of impedances α.
#[test]
fn no_notch_is_too_narrow_to_be_found() {
    for (k, speed) in (80..250).step_by(7).enumerate() {
        let soil = Layer { thickness: 10.3 + 1.7 * k as f64, speed: f64::from(speed), damping: 0.0, ..SOIL };
        let rock = Layer { speed: 1500.0 + 80.0 * k as f64, ..ROCK };
        let place = place(&[rock, soil], rock.thickness);
        let exact = soil.speed / (4.0 * soil.thickness);
        let notch = place.notch(0, 10.0 * exact).unwrap_or_else(|| panic!("{exact} Hz is missed"));
        assert!((notch.at - exact).abs() < 1e-6 * exact && notch.share < 1e-4, "{notch:?} {exact}");
        let alpha = soil.density * soil.speed / (rock.density * rock.speed);
        // α tan kh = √(1/LEAST² − 1) at its edge.
        let edge = exact * ((1.0 / LEAST.powi(2) - 1.0).sqrt() / alpha).atan() / (0.5 * PI);
        assert!((notch.from - edge).abs() < 1e-6 * exact, "{notch:?} {edge}");
        let found =
            place.shares(0, 10.0 * exact).into_iter().filter(|(_, share, dip)| *dip && *share < 1e-3).count();
        assert_eq!(found, 5, "{exact} Hz");
        // Also in the last step before the end.
        for end in [1.0005, 1.002, 1.01] {
            let notch =
                place.notch(0, end * exact).unwrap_or_else(|| panic!("{exact} Hz is missed before {end}"));
            assert!((notch.at - exact).abs() < 1e-6 * exact, "{notch:?} {exact}");
        }
    }
}

/// The surface of undamped rock moves twice as much at all frequencies: round-off makes no dips.
#[test]
fn what_is_flat_has_no_dips() {
    let shares = place(&[ROCK], 100.0).shares(0, 50.0);
    assert!(shares.iter().all(|(_, share, dip)| !dip && (share - 1.0).abs() < 1e-9));
}
