use super::*;
use crate::support::tests::{plan, set, under};
use tremolite_results::read_bolts;

fn look_at(force: f64) -> impl Fn(usize, usize) -> Vec<tremolite_engine::bolts::SegmentSeen> {
    move |_, bolt| vec![under(force + bolt as f64); 3]
}

#[test]
fn rows_of_stages_are_those_of_bolts_that_are_there_and_come_whole_from_what_is_remembered() {
    let sets = [
        set("crown", 2, Stage::Before(1), 4e8),
        set("none", 0, Stage::Before(0), 4e8),
        set("walls", 1, Stage::Before(2), 4e8),
    ];
    let plan = plan(&["initial", "bench 1", "bench, 2"]);
    let mut memory = Memory::new();
    for (k, force) in [1e4, 2e4, 1.5e4].into_iter().enumerate() {
        BoltsOfStages::remember(&mut memory, k, &seen(&sets, Stage::Before(k as u16), &look_at(force)));
    }
    let rows = rows_of_stages(&sets, &plan, &memory);
    let told: Vec<_> = rows
        .iter()
        .map(|r| (r.stage.as_str(), r.name.as_str(), r.bolt, r.max_force, r.state.as_str()))
        .collect();
    assert_eq!(
        told,
        [
            ("bench 1", "crown", 1, 2e4, "elastic"),
            ("bench 1", "crown", 2, 20001.0, "elastic"),
            ("bench, 2", "crown", 1, 1.5e4, "elastic"),
            ("bench, 2", "crown", 2, 15001.0, "elastic"),
            ("bench, 2", "walls", 1, 1.5e4, "elastic"),
        ]
    );
    assert!(rows.iter().all(|row| row.time.is_nan()));
    assert_eq!(rows[0].force_over_yield, 0.1);
    assert_eq!(
        [Stage::Before(0), Stage::Before(1), Stage::Before(2)].map(|stage| count(&sets, stage)),
        [0, 2, 3]
    );
    // Of the plan of another run, whose model has fewer bolts, nothing is made up.
    assert_eq!(rows_of_stages(&sets[..1], &plan, &memory).len(), 4);
}

#[test]
fn the_largest_force_is_kept_with_its_stage_and_in_the_earthquake_with_its_time() {
    let sets = [set("crown", 2, Stage::Before(1), 4e8), set("empty", 0, Stage::Before(0), 4e8)];
    let plan = plan(&["initial", "bench 1", "bench 2"]);
    let mut memory = Memory::new();
    let nothing = BoltForces::peaks(&sets, &plan, &memory);
    assert_eq!((nothing[0].0.bolt, nothing[0].0.force, nothing[0].1), (0, 0.0, 0.0));
    for (k, force) in [0.0, 5e4, 3e4].into_iter().enumerate() {
        BoltsOfStages::remember(&mut memory, k, &seen(&sets, Stage::Before(k as u16), &look_at(force)));
    }
    let (peak, over) = BoltForces::peaks(&sets, &plan, &memory).swap_remove(0);
    assert_eq!((peak.stage.as_str(), peak.force, peak.bolt), ("bench 1", 50001.0, 2));
    assert!(peak.time.is_nan() && (over - 50001.0 / 2e5).abs() < 1e-15);
    for (time, force) in [(0.0, 3e4), (0.1, 8e4), (0.2, 8e4)] {
        follow(&seen(&sets, Stage::Shaking, &look_at(force)), -1.0, time, &mut memory);
    }
    let peaks = BoltForces::peaks(&sets, &plan, &memory);
    assert_eq!((peaks[0].0.stage.as_str(), peaks[0].0.time, peaks[0].0.force), (EARTHQUAKE, 0.1, 80001.0));
    assert_eq!(peaks[0].0.at, [1.0, 0.0, 0.5]);
    assert_eq!((peaks[1].0.bolt, peaks[1].0.stage.as_str()), (0, ""), "a group without bolts");
}

#[test]
fn a_group_of_very_many_bars_is_told_by_the_one_that_carries_most() {
    let many = MOST as u32 + 1;
    let sets = [set("bars", many, Stage::Before(0), 4e8), set("crown", 3, Stage::Before(0), 4e8)];
    let rows = rows_of(&seen(&sets, Stage::Before(0), &look_at(1e4)));
    assert_eq!(rows.len(), 4);
    assert_eq!((rows[0][0], rows[0][1], rows[0][2]), (0.0, MOST as f64, 1e4 + MOST as f64));
    assert_eq!(count(&sets, Stage::Shaking), 4);
}

#[test]
fn numbers_that_stand_for_nothing_leave_no_nan_but_the_time_of_stages() {
    let sets = [set("bars", 2, Stage::Before(0), f64::INFINITY)];
    let free = |_: usize, bolt: usize| {
        let state = if bolt == 1 { SegmentState::CutOff } else { SegmentState::Elastic };
        vec![tremolite_engine::bolts::SegmentSeen { yields_at: f64::INFINITY, state, ..under(1e5) }; 3]
    };
    let mut memory = Memory::new();
    BoltsOfStages::remember(&mut memory, 0, &seen(&sets, Stage::Before(0), &free));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bolts.csv");
    BoltWriter::create(&path, &rows_of_stages(&sets, &plan(&["initial"]), &memory)).unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    assert_eq!(text.matches("NaN").count(), 2, "{text}");
    assert!(!text.contains("inf"), "{text}");
    let rows = read_bolts(&path).unwrap();
    assert_eq!((rows[0].force_over_yield, rows[0].state.as_str()), (0.0, "elastic"));
    assert_eq!((rows[1].max_force, rows[1].state.as_str(), rows[1].cut_off), (0.0, "cut-off", 3.0));
}
