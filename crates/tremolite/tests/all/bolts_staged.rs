//! Bolts through stages: placed with an excavation, cut by one, tensioned, handed over to the shaking.

use crate::bolts::{Built, STEEL, bolts, bond, close};
use crate::staged::{LINED, OPENED, lined};
use tremolite::stages::settle;
use tremolite::{Bolts, Bond, Engine, Phase, Stage, State, stable_step};
use tremolite_engine::bolts::SegmentState;

/// Bolts around the opening of [`lined`], 3 m long from its walls, placed with the excavation.
fn around() -> Bolts {
    let rows = [0.7, 2.1, 3.4];
    let wall = |y: f64| {
        let side = move |sign: f64, z: f64| [[6.0 + sign * 2.0, y, z], [6.0 + sign * 5.0, y, z]];
        let crown = move |x: f64| [[x, y, 8.0], [x, y, 11.0]];
        [side(1.0, 5.2), side(1.0, 6.9), side(-1.0, 5.2), side(-1.0, 6.9), crown(5.3), crown(6.8)]
    };
    let bars: Vec<_> = rows.into_iter().flat_map(wall).collect();
    Bolts { born: OPENED, ..bolts(&bars) }
}

#[test]
fn bolts_placed_with_an_excavation_hold_its_wall_and_none_placed_later_do() {
    let crown = |kind: Option<Bolts>| {
        let mut problem = lined(false);
        problem.bolts = kind.into_iter().collect();
        let built = Built::new(problem);
        let (state, _) = settle(&built.model, &built.assembly, &[close(), close(), close()]).unwrap();
        let node = (0..built.model.user.nodes)
            .find(|&n| (0..3).all(|i| (built.model.mesh.nodes[n][i] - [6.0, 2.0, 8.0][i]).abs() < 1e-9))
            .unwrap();
        let forces: Vec<f64> = match built.assembly.bolts.first() {
            Some(bolting) => {
                let count = built.model.bolts[0].bolts.len();
                (0..count).flat_map(|b| bolting.seen(&state.numbers, b)).map(|s| s.force).collect()
            }
            None => Vec::new(),
        };
        (state.shown(built.model.engine_node[node] as usize).xyz()[2], forces)
    };
    let stiff = || Bolts { young: 40.0 * STEEL, ..around() };
    let (bare, _) = crown(None);
    let (bolted, forces) = crown(Some(stiff()));
    let (late, none) = crown(Some(Bolts { born: LINED, ..stiff() }));
    eprintln!("{bare} {bolted} {late}");
    assert!(bolted.abs() < 0.97 * bare.abs(), "{bare} {bolted}");
    assert!(forces.iter().filter(|f| **f > 0.0).count() > forces.len() / 2);
    // The lining alone changes nothing after full release, and bolts placed with it carry only what it weighs.
    assert!((late / bare - 1.0).abs() < 0.05, "{bare} {late}");
    let [most, then] = [&none, &forces].map(|all| all.iter().fold(0.0f64, |m, f| m.max(f.abs())));
    assert!(most < 0.1 * then, "{most} {then}");
}

#[test]
fn what_lies_in_excavated_rock_is_cut_off_and_the_rest_goes_on() {
    for bonded in [false, true] {
        let mut problem = lined(true);
        // From rock to rock through what is excavated.
        let mut kind = bolts(&[[[2.2, 2.1, 6.3], [10.1, 2.3, 6.6]]]);
        kind.bond = bonded.then(|| bond(0.4));
        problem.bolts = vec![kind];
        let built = Built::new(problem);
        let (state, _) = settle(&built.model, &built.assembly, &[close(), close(), close()]).unwrap();
        let seen = built.assembly.bolts[0].seen(&state.numbers, 0);
        let bolt = &built.model.bolts[0].bolts[0];
        for (k, segment) in seen.iter().enumerate() {
            let inside = (bolt.middle(k)[0] - 6.0).abs() < 2.0;
            assert_eq!(segment.state == SegmentState::CutOff, inside, "{k} {segment:?}");
            assert_eq!(segment.force == 0.0, inside, "{k} {segment:?}");
        }
    }
}

#[test]
fn pretension_is_kept_through_its_stage_and_its_length_from_then_on() {
    const P: f64 = 150e3;
    for bonded in [false, true] {
        let mut problem = lined(false);
        let mut kind = around();
        kind.bars.truncate(6);
        if bonded {
            kind.bond = Some(Bond { strength: 400e3, ..bond(0.2) });
            (kind.free_length, kind.plates) = (1.5, [true, false]);
        }
        kind.pretension = P;
        problem.bolts = vec![kind];
        let built = Built::new(problem);
        let plans = [close(), close(), close()];
        let (mut state, _) = settle(&built.model, &built.assembly, &plans[..2]).unwrap();
        let elongation = |state: &State, b: usize| {
            let bolt = &built.model.bolts[0].bolts[b];
            let u = |p: u32| {
                let of = bolt.points[p as usize].weights.iter().map(|&(n, w)| {
                    state.u[built.model.engine_node[n as usize] as usize].xyz().map(|x| w * x)
                });
                of.fold([0.0; 3], |a, b| [a[0] + b[0], a[1] + b[1], a[2] + b[2]])
            };
            let of = &bolt.segments[0];
            let [a, b] = of.points.map(u);
            ((0..3).map(|i| of.along[i] * (b[i] - a[i])).sum::<f64>(), STEEL * of.area / of.length)
        };
        let bars = |state: &State, b: usize| built.assembly.bolts[0].seen(&state.numbers, b);
        for b in 0..6 {
            let tensioned = |k: usize| !bonded || k == 0;
            let seen = bars(&state, b);
            assert!(seen.iter().enumerate().all(|(k, s)| !tensioned(k) || s.force == P), "{seen:?}");
        }
        let then: Vec<f64> = (0..6).map(|b| elongation(&state, b).0).collect();
        // What still is held goes in the next stage, with the lining's weight.
        let phase = Phase::of(&built.model, &built.assembly, LINED).unwrap();
        Engine::new(&built.model, &built.assembly, &phase).relax(&mut state, &close().release).unwrap();
        let mut moved: f64 = 0.0;
        for b in 0..6 {
            let (now, stiffness) = elongation(&state, b);
            // A following bar sees it directly; the end of a free length may slip in its bond by what that gives.
            let force = bars(&state, b)[0].force;
            let exact = P + stiffness * (now - then[b]);
            moved = moved.max((force - P).abs());
            if !bonded {
                assert!((force - exact).abs() < 1e-9 * P, "{force} {exact}");
            }
        }
        assert!(moved > 1e-6 * P && moved < 0.2 * P, "{moved}");
    }
}

#[test]
fn a_bolted_model_at_rest_stays_there_when_the_shaking_begins() {
    let mut problem = lined(true);
    let mut kind = around();
    kind.bond = Some(Bond { friction: 0.5, ..bond(0.5) });
    problem.bolts = vec![kind];
    let built = Built::new(problem);
    let (mut state, _) = settle(&built.model, &built.assembly, &[close(), close(), close()]).unwrap();
    let phase = Phase::of(&built.model, &built.assembly, Stage::Shaking).unwrap();
    let dt = 0.9 * stable_step(&built.model, &built.assembly, &phase).dt;
    let mut engine = Engine::new(&built.model, &built.assembly, &phase);
    engine.hand_over(&mut state, dt);
    let drift = engine.quiet_run(&state, 100);
    assert!(drift < 1e-12, "{drift}");
    let forces: f64 = built.assembly.bolts[0].seen(&state.numbers, 0).iter().map(|s| s.force.abs()).sum();
    assert!(forces > 1e3);
}

/// Cut by an excavation, with a bond by friction alone: at the cut the rock that is left presses on it, whichever end is the head.
#[test]
fn a_bolt_is_the_same_from_either_end() {
    let (above, below) = ([6.3, 2.1, 11.7], [6.4, 1.9, 6.6]);
    let forces = |ends: [[f64; 3]; 2]| {
        let mut problem = lined(false);
        let mut kind = bolts(&[ends]);
        kind.bond = Some(Bond { strength: 100.0, friction: 0.7, ..bond(f64::INFINITY) });
        problem.bolts = vec![kind];
        let built = Built::new(problem);
        let (state, _) = settle(&built.model, &built.assembly, &[close(), close()]).unwrap();
        let seen = built.assembly.bolts[0].seen(&state.numbers, 0);
        (0..seen.len()).map(|k| (built.model.bolts[0].bolts[0].middle(k)[2], seen[k])).collect::<Vec<_>>()
    };
    let (down, mut up) = (forces([above, below]), forces([below, above]));
    up.reverse();
    assert_eq!(down.len(), up.len());
    let most = down.iter().fold(0.0f64, |most, (_, seen)| most.max(seen.force.abs()));
    assert!(most > 100.0 && down.iter().any(|(_, seen)| seen.state == SegmentState::CutOff));
    for ((z, a), (other, b)) in down.iter().zip(&up) {
        assert!((z - other).abs() < 1e-9);
        assert!((a.force - b.force).abs() < 1e-6 * most, "{z}: {a:?} {b:?}");
        assert_eq!((a.state, a.slid), (b.state, b.slid), "{z}");
    }
}
