//! Bars cut where they leave an element.

use crate::ready::{Ready, body, joint};
use tremolite_engine::life::Stage;
use tremolite_engine::{Bar, Bolts, Problem};
use tremolite_mesh::boxes::BoxSpec;

/// A bar along x at the middle of a row of bricks with these borders, with a plate at its head.
fn bar(borders: &[f64], ends: [f64; 2]) -> Problem {
    let bricks = borders.len() as u32 - 1;
    let mut mesh = BoxSpec::uniform([0.0; 3], [1.0; 3], [bricks, 1, 1]).mesh().unwrap();
    for x in &mut mesh.nodes {
        x[0] = borders[(x[0] * f64::from(bricks)).round() as usize];
    }
    let mut problem = Problem::new(mesh, vec![body("rock", (0..bricks).collect())]);
    problem.bolts = vec![Bolts {
        name: "bolts".into(),
        bars: vec![Bar { points: ends.map(|x| [x, 0.5, 0.5]).into(), areas: vec![5e-4] }],
        young: 200e9,
        yields: f64::INFINITY,
        breaks: f64::INFINITY,
        bond: None,
        pretension: 0.0,
        free_length: 0.0,
        plates: [true, false],
        born: Stage::Before(0),
    }];
    problem
}

/// Where the segments of the bar begin and end along x, and whether they are free.
fn segments(problem: Problem) -> Vec<([f64; 2], bool)> {
    let ready = Ready::new(problem);
    let bolt = &ready.model.bolts[0].bolts[0];
    let all = bolt.segments.iter();
    all.map(|own| (own.points.map(|p| bolt.points[p as usize].place[0]), own.free)).collect()
}

#[test]
fn a_plate_holds_the_head_across_the_free_length_alone() {
    let borders = [0.0, 1.0, 2.0, 3.0];
    let every = [([0.0, 1.0], false), ([1.0, 2.0], false), ([2.0, 3.0], false)];
    assert_eq!(segments(bar(&borders, [0.0, 3.0])), every);
    let mut free = bar(&borders, [0.0, 3.0]);
    free.bolts[0].free_length = 2.0;
    assert_eq!(segments(free), [([0.0, 2.0], true), ([2.0, 3.0], false)]);
}

/// A head or a tail beside the wall by a round-off of whatever size is at it: no piece is lost, and no plate.
#[test]
fn a_bar_that_ends_a_little_beside_the_wall_ends_at_it() {
    let borders = [0.0, 0.3, 0.6, 0.9, 12.0];
    for off in [0.0, 1e-9, 1e-7, 4e-7, 8e-7, 1.1e-6, 1.3e-6, 2e-6, 1e-5, 1e-3, 8e-3] {
        let mut free = bar(&borders, [-off, 12.0 + off]);
        free.bolts[0].free_length = 0.5;
        let found = segments(free);
        let ends: Vec<f64> = found.iter().flat_map(|(ends, _)| *ends).collect();
        assert_eq!(
            found.iter().map(|(_, free)| *free).collect::<Vec<_>>(),
            [true, false, false, false],
            "{off}"
        );
        for (found, exact) in ends.iter().zip([0.0, 0.5, 0.5, 0.6, 0.6, 0.9, 0.9, 12.0]) {
            assert!((found - exact).abs() < 0.01, "{off}: {ends:?}");
        }
    }
}

/// What sees an interface reaches a quarter of an element's size on either side: an eighth of a metre of an element of a metre each way across
/// it is just that, a sixteenth is not.
#[test]
fn the_segment_across_an_interface_reaches_a_quarter_of_an_element_on_either_side() {
    let across = |thin: f64| {
        let mut problem = bar(&[0.0, 1.0, 1.0 + thin, 2.0 + thin, 3.0 + thin], [0.0, 3.0 + thin]);
        let far = problem.bodies[0].elements.split_off(1);
        problem.bodies.push(body("other", far));
        problem.interfaces = vec![joint(&problem, [0, 1], 1e9)];
        segments(problem).into_iter().map(|(ends, _)| ends).collect::<Vec<_>>()
    };
    assert_eq!(across(0.125), [[0.0, 1.125], [1.125, 2.125], [2.125, 3.125]]);
    assert_eq!(across(0.0625), [[0.0, 2.0625], [2.0625, 3.0625]]);
}
