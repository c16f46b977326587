use super::oscillator::response;
use super::*;
use crate::drift;
use std::f64::consts::PI;

/// A shaking of 24 s whose spectrum is not that of the target: three bursts of many frequencies.
fn shaking(dt: f64) -> Channel {
    let n = (24.0 / dt).round() as usize;
    let one = |i: usize| {
        let t = i as f64 * dt;
        (1..40)
            .map(|k| {
                let (f, phase) = (0.2 * 1.13_f64.powi(k), (7 * k * k % 23) as f64);
                let middle = 6.0 + (k % 3) as f64 * 3.0;
                0.2 * (2.0 * PI * f * t + phase).sin() * (-((t - middle) / 3.0).powi(2)).exp()
            })
            .sum()
    };
    Channel::new("three bursts", dt, (0..n).map(one).collect())
}

#[test]
fn responses_by_pulses_are_those_by_steps() {
    let record = shaking(0.02);
    let target = TargetSpectrum::en1998(1, 'B', 2.0).unwrap();
    let mut a = record.acceleration.clone();
    a[0] = 0.0;
    let all = oscillators(&target, [0.2, 2.0], a.len(), record.dt);
    for o in &all {
        let by_steps = response(&a, record.dt, o.omega, o.damping);
        let most = by_steps.iter().fold(0.0_f64, |most, r| most.max(r.abs()));
        for at in [3, 400, 1199] {
            let all = Wavelet { from: 0, values: a.clone() };
            assert!((response_at(o, &all, at) - by_steps[at]).abs() < 1e-9 * most);
            let cut = Wavelet { from: 1, values: a[1..600].to_vec() };
            let mut padded = a[..600].to_vec();
            padded.resize(a.len(), 0.0);
            let by_steps = response(&padded, record.dt, o.omega, o.damping);
            assert!((response_at(o, &cut, at) - by_steps[at]).abs() < 1e-9 * most);
        }
    }
}

#[test]
fn a_wavelet_s_largest_response_falls_on_its_instant_and_it_ends_at_rest() {
    let target = TargetSpectrum::en1998(1, 'B', 2.0).unwrap();
    let (dt, samples) = (0.005, 6000);
    for o in oscillators(&target, [0.1, 2.0], samples, dt) {
        let period = 2.0 * PI / o.omega;
        let part = wavelet(samples, dt, &o, 15.0);
        let mut wavelet = vec![0.0; samples];
        wavelet[part.from..part.from + part.values.len()].copy_from_slice(&part.values);
        let all = response(&wavelet, dt, o.omega, o.damping);
        let most = (0..samples).max_by(|a, b| all[*a].abs().total_cmp(&all[*b].abs())).unwrap();
        assert!((most as f64 * dt - 15.0).abs() < 0.1 * period, "{period}: {}", most as f64 * dt);
        assert!(drift(&wavelet, dt).iter().all(|x| *x < 1e-9));
    }
}

#[test]
fn a_record_fits_a_target_between_the_matched_periods_too_and_does_not_drift() {
    let record = shaking(0.01);
    let target = TargetSpectrum::en1998(1, 'B', 2.0).unwrap();
    let band = [0.1, 2.0];
    let made = matched(&record, &target, band, 0.05).unwrap();
    assert!(made.before.largest > 0.2, "{:?}", made.before);
    assert!(made.after.largest <= 0.05, "{:?}", made.after);
    let again = misfit(&made.channel.acceleration, made.channel.dt, &target, band).unwrap();
    assert_eq!(again, made.after);
    assert!(drift(&made.channel.acceleration, made.channel.dt).iter().all(|x| *x < 1e-9));
    // Sampled twice as finely, straight between its samples, it is the same motion: peaks between samples are small.
    let fine = between_samples(&made.channel.acceleration, 4);
    let finer = misfit(&fine, 0.25 * made.channel.dt, &target, band).unwrap();
    assert!((finer.largest - made.after.largest).abs() < 1.0 - (PI / SAMPLES).cos(), "{finer:?}");
    // Twice the record: the factor takes it away.
    let mut twice = record.clone();
    twice.acceleration.iter_mut().for_each(|a| *a *= 2.0);
    let same = matched(&twice, &target, band, 0.05).unwrap();
    assert!((same.factor * 2.0 / made.factor - 1.0).abs() < 1e-12);
    let off = same.channel.acceleration.iter().zip(&made.channel.acceleration);
    assert!(off.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) < 1e-6);
}

#[test]
fn what_cannot_fit_is_refused_with_words() {
    let target = TargetSpectrum::en1998(1, 'B', 2.0).unwrap();
    let short = shaking(0.02).window(0.0, 5.0).unwrap();
    let told = |c: &Channel, band| matched(c, &target, band, 0.05).unwrap_err().to_string();
    assert!(told(&short, [0.2, 4.0]).contains("twice the longest period"));
    assert!(told(&shaking(0.02), [0.05, 2.0]).contains("tells nothing"));
    let still = Channel::new("still", 0.01, vec![0.0; 1000]);
    assert!(told(&still, [0.2, 2.0]).contains("does not move"));
    // A target with a step that no damped oscillator's spectrum has.
    let step =
        TargetSpectrum::of_table("a step", 0.05, &[[0.1, 1.0], [0.5, 1.0], [0.51, 8.0], [2.0, 8.0]]).unwrap();
    let told = matched(&shaking(0.02), &step, [0.1, 2.0], 0.05).unwrap_err().to_string();
    assert!(told.contains("comes no nearer"), "{told}");
}
