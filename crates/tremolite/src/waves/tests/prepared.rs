//! What is kept for the boundaries of a model beside what is found anywhere.

use super::super::field::{Frame, ObliqueField};
use super::super::ground::LayeredGround;
use super::super::heading::{Heading, WaveType};
use super::{START, entering, frame, layered, step_up};
use tremolite_engine::Top;
use tremolite_engine::free_field::{End, GivenField, Place};

/// Nodes of a side across x in rows, with the points of faces between them, one at an edge, and points at heights of their own.
fn places() -> Vec<Place> {
    let mut places = Vec::new();
    for (j, k) in (0..4).flat_map(|j| (0..5).map(move |k| (j, k))) {
        let at = [60.0, 9.0 * f64::from(j), 11.0 * f64::from(k)];
        let near = [-0.4, 0.3].into_iter().flat_map(|y| [-0.6, 0.2, 0.9].map(|z| (y, z)));
        let shares = near
            .map(|(y, z)| {
                ([at[0], at[1] + 9.0 * y, (at[2] + 11.0 * z).max(0.0)], [(1.0 + y) * (2.0 - z), 0.0, 0.0])
            })
            .collect();
        places.push(Place { at, shares, ..Place::default() });
    }
    let end = End {
        at: [60.0, 4.0, 50.0],
        normal: [1.0, 0.0, 0.0],
        along: [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        lacking: [0.4, 0.1],
        beside: [0.7, -0.2],
    };
    places[7].ends.push(end);
    for k in 0..6 {
        let at = [7.0 * f64::from(k), 3.1 * f64::from(k), 2.7 * f64::from(k)];
        places.push(Place { at, shares: vec![(at, [0.3, -0.2, 0.5])], ..Place::default() });
    }
    places
}

/// What is kept for the places of a model is what is found anywhere else, to round-off of four bytes, and what pushes them is the sum over
/// their points, whether all sums are kept, some or few.
#[test]
fn prepared_places_answer_as_all_others_do() {
    let ground = LayeredGround::new(layered(), Top::Free).unwrap();
    let frame = Frame {
        bounds: [[0.0; 3], [60.0, 40.0, ground.height()]],
        at: [30.0, 20.0],
        ..frame(ground.clone())
    };
    let wave = |kind, degrees: f64| {
        let heading = Heading { kind, angle: degrees.to_radians(), along: [0.6, 0.8] };
        entering(heading, step_up())
    };
    let waves = [wave(WaveType::Sv, 25.0), wave(WaveType::Sh, 60.0)];
    let [plain, ready] = [0, 1].map(|_| ObliqueField::new(&frame, &waves).unwrap());
    let places = places();
    let places: Vec<&Place> = places.iter().collect();
    assert!(plain.pushes(&places).is_none());
    ready.prepare(&places);
    assert!(ready.bytes() > plain.bytes());
    // All places whole, rows of them whole and some of the rest in stacks, hardly anything.
    let pushes =
        [ready.pushes(&places).unwrap(), ready.with_sums_of(11, &places), ready.with_sums_of(3, &places)];
    let mut of = Largest::default();
    let mut of_forces = Largest::default();
    for k in 0..40 {
        let t = plain.lead() + START - 0.02 + 0.0071 * f64::from(k);
        let at = places.iter().map(|place| place.at).chain([[13.0, 29.0, 3.7], [13.0, 29.0, 70.3]]);
        for at in at {
            of.compare(&plain.displacement(at, t), &ready.displacement(at, t));
            let dt = 0.003 + 0.001 * f64::from(k);
            let mut v = [[0.0; 3]];
            ready.velocities(&[ready.spot(at)], t, dt, &mut v);
            let moved = v[0].map(|v| 2.0 * dt * v);
            let [before, after] = [t - dt, t + dt].map(|t| plain.displacement(at, t));
            of.compare(&[0, 1, 2].map(|i| after[i] - before[i]), &moved);
        }
        for pushes in &pushes {
            let mut found = vec![[0.0; 3]; places.len()];
            pushes.forces(t, &mut found);
            for (place, found) in places.iter().zip(found) {
                let mut sum = [0.0; 3];
                let shares = place.shares.iter().map(|&(at, area)| {
                    let [xx, yy, zz, xy, yz, zx] = plain.stress(at, t);
                    let [x, y, z] = area;
                    [xx * x + xy * y + zx * z, xy * x + yy * y + yz * z, zx * x + yz * y + zz * z]
                });
                let ends = place.ends.iter().map(|end| end.force(&plain.stress(end.at, t)));
                shares.chain(ends).for_each(|force| (0..3).for_each(|i| sum[i] += force[i]));
                of_forces.compare(&sum, &found);
            }
        }
    }
    for Largest { off, most } in [of, of_forces] {
        assert!(most > 0.0 && off < 1e-6 * most, "{off:e} of {most:e}");
    }
    // Nodes in rows ask for few series: of 4 × 5 nodes with two delays each those of a row are one, and the one with an end has its own.
    assert!(ready.sums() < 2 * (5 + 1 + 2 + 6 + 4), "{}", ready.sums());
}

/// The largest of some numbers, and of what others differ from them by.
#[derive(Default)]
struct Largest {
    off: f64,
    most: f64,
}

impl Largest {
    fn compare(&mut self, right: &[f64; 3], found: &[f64; 3]) {
        for (a, b) in right.iter().zip(found) {
            self.most = self.most.max(a.abs());
            self.off = self.off.max((a - b).abs());
        }
    }
}
