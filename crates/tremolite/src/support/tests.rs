use super::*;
use crate::plan::{BoltMonitor, Plan};
use crate::stages::PlannedStage;
use tremolite_engine::Bolts;
use tremolite_engine::bolts::{BoltPoint, Cuts, Segment};
use tremolite_results::{BoltPeak, BoltSummary, PageWish, Severity};

/// A set of so many bolts of three segments of 1 m that go up from z = 0, at x = 0, 1, 2 …
pub(crate) fn set(name: &str, bolts: u32, born: Stage, yields: f64) -> BoltSet {
    let point = |bar: u32, k: u32| BoltPoint {
        at: f64::from(k),
        place: [f64::from(bar), 0.0, f64::from(k)],
        weights: vec![(0, 0.25), (1, 0.75)],
        host: 0,
        beside: 0,
    };
    let segment = |k: u32| Segment {
        points: [k, k + 1],
        along: [0.0, 0.0, 1.0],
        length: 1.0,
        area: 5e-4,
        free: false,
        gone: None,
    };
    let bolt = |bar: u32| Bolt {
        bar,
        points: (0..4).map(|k| point(bar, k)).collect(),
        segments: (0..3).map(segment).collect(),
    };
    BoltSet {
        kind: Bolts {
            name: name.into(),
            bars: Vec::new(),
            young: 200e9,
            yields,
            breaks: f64::INFINITY,
            bond: None,
            pretension: 0.0,
            free_length: 0.0,
            plates: [false; 2],
            born,
        },
        bolts: (0..bolts).map(bolt).collect(),
        cuts: Cuts { given: bolts as usize, ..Cuts::default() },
    }
}

/// A segment under a force that yields at 200 kN.
pub(crate) fn under(force: f64) -> SegmentSeen {
    SegmentSeen { force, largest_force: force.abs(), yields_at: 2e5, ..SegmentSeen::default() }
}

pub(crate) fn plan(stages: &[&str]) -> Plan {
    Plan {
        page: PageWish::default(),
        boundaries: Default::default(),
        target: None,
        title: String::new(),
        stages: stages.iter().map(|name| PlannedStage::new(*name)).collect(),
        duration: 1.0,
        recorded: None,
        waves: None,
        histories: 0.1,
        snapshots: None,
        fields: Vec::new(),
        field_elements: 250_000,
        checkpoint: None,
        monitors: Vec::new(),
        pairs: Vec::new(),
        bolts: Vec::new(),
        bars: 0,
        water: false,
        relatives: Vec::new(),
        sections: Vec::new(),
    }
}

#[test]
fn a_bolt_is_as_its_worst_segment_and_its_force_keeps_its_sign() {
    let set = set("crown", 2, Stage::Before(1), 4e8);
    let mut segments = [under(5e4), under(-1.5e5), under(1e5)];
    (segments[0].state, segments[0].slid) = (SegmentState::Slid, true);
    segments[0].largest_slip = 2e-3;
    segments[2].state = SegmentState::Yielded;
    segments[2].largest_force = 1.9e5;
    let seen = BoltSeen::of(&set.bolts[1], &segments);
    assert_eq!((seen.force, seen.place, seen.over_yield), (-1.5e5, [1.0, 0.0, 1.5], 0.75));
    assert_eq!((seen.largest_force, seen.largest_place), (1.9e5, [1.0, 0.0, 2.5]));
    assert_eq!(seen.largest_over_yield, 0.95);
    assert_eq!((seen.state, seen.slip), (SegmentState::Yielded, 2e-3));
    assert!(seen.slid && seen.yielded && !seen.broken);
}

#[test]
fn what_was_cut_off_says_nothing_of_what_is_left() {
    let set = set("crown", 1, Stage::Before(1), 4e8);
    let cut = SegmentSeen { state: SegmentState::CutOff, largest_slip: 9.0, ..under(9e9) };
    let seen = BoltSeen::of(&set.bolts[0], &[cut, cut, under(1e5)]);
    assert_eq!((seen.force, seen.over_yield, seen.slip, seen.cut_off), (1e5, 0.5, 0.0, 2.0));
    assert_eq!(seen.state, SegmentState::Elastic);
    let seen = BoltSeen::of(&set.bolts[0], &[cut; 3]);
    assert_eq!(seen, BoltSeen { state: SegmentState::CutOff, cut_off: 3.0, ..BoltSeen::default() });
}

#[test]
fn a_bolt_that_never_yields_has_no_share_of_yield_and_a_lost_force_shows() {
    let set = set("bars", 1, Stage::Before(0), f64::INFINITY);
    let free = SegmentSeen { yields_at: f64::INFINITY, ..under(1e5) };
    let seen = BoltSeen::of(&set.bolts[0], &[free; 3]);
    assert_eq!((seen.over_yield, seen.largest_over_yield), (0.0, 0.0));
    let seen = BoltSeen::of(&set.bolts[0], &[under(1.0), under(f64::NAN), under(2.0)]);
    assert!(seen.force.is_nan() && seen.place == [0.0, 0.0, 1.5]);
}

#[test]
fn nothing_is_seen_of_bolts_that_are_not_placed_yet() {
    let sets = [set("crown", 2, Stage::Before(2), 4e8), set("empty", 0, Stage::Before(0), 4e8)];
    let look = |_: usize, _: usize| vec![under(1e5); 3];
    assert_eq!(seen(&sets, Stage::Before(1), &look), [Vec::new(), Vec::new()]);
    assert_eq!(seen(&sets, Stage::Before(2), &look)[0].len(), 2);
    assert_eq!(seen(&sets, Stage::Shaking, &look)[0].len(), 2);
}

/// Of a group of so many bolts in which bolt 0 did what `first` says and the others stand under 20 kN.
fn told(bolts: u32, yields: f64, first: [SegmentSeen; 3]) -> BoltSummary {
    let sets = [set("crown", bolts, Stage::Before(1), yields)];
    let other = SegmentSeen { yields_at: first[0].yields_at, ..under(2e4) };
    let look = |_: usize, bolt: usize| if bolt == 0 { first.to_vec() } else { vec![other; 3] };
    let peak =
        BoltPeak { force: 1.64e5, bolt: 1, at: [0.0, 0.0, 1.5], stage: "bench 1".into(), time: f64::NAN };
    let peaks = [(peak, if yields.is_finite() { 0.82 } else { 0.0 })];
    let plan = plan(&["initial", "bench 1"]);
    super::bolts(&sets, &plan, Some(Stage::Shaking), &look, &peaks).swap_remove("crown").unwrap()
}

fn said(group: BoltSummary) -> (String, String, Severity) {
    let found = findings(&[("crown".to_owned(), group)].into_iter().collect()).swap_remove(0);
    assert_eq!(found.id, "bolts_crown");
    assert!(found.numbers.values().all(|x| x.is_finite()));
    (found.headline, found.text, found.severity)
}

/// Of bars a number would be one of rows of elements, which nobody drew.
#[test]
fn of_reinforcement_a_finding_says_whether_bars_yielded_and_not_how_many() {
    let mut first = [under(1.64e5); 3];
    let bars = |first| BoltSummary { bars: true, ..told(240, 4e8, first) };
    assert_eq!(said(bars(first)).0, "no bar yielded; largest force 0.82 of yield");
    let text = said(bars(first)).1;
    assert_eq!(
        text,
        "Largest force 164 kN in row 1 of the bars at (0.0, 0.0, 1.5) m in the stage 'bench 1'."
    );
    first[1] = SegmentSeen { state: SegmentState::Yielded, plastic_strain: 0.01, ..first[1] };
    assert!(said(bars(first)).0.starts_with("bars yielded, none broke;"));
    // The last groups of a plan are its reinforcement.
    let sets = [set("crown", 3, Stage::Before(1), 4e8), set("rings", 3, Stage::Before(1), 4e8)];
    let look = |_: usize, _: usize| vec![under(2e4); 3];
    let plan = Plan { bars: 1, ..plan(&["initial", "bench 1"]) };
    let all = super::bolts(&sets, &plan, Some(Stage::Shaking), &look, &[]);
    assert!(!all["crown"].bars && all["rings"].bars);
}

#[test]
fn a_finding_says_how_many_yielded_and_broke_and_how_near_the_others_came() {
    let (headline, text, severity) = said(told(240, 4e8, [under(1.64e5); 3]));
    assert_eq!(headline, "none of 240 bolts yielded; largest force 0.82 of yield");
    assert_eq!(text, "Largest force 164 kN in bolt 1 at (0.0, 0.0, 1.5) m in the stage 'bench 1'.");
    assert_eq!(severity, Severity::Undamaged);

    let mut first = [under(1.64e5); 3];
    first[0] = SegmentSeen { state: SegmentState::Slid, slid: true, largest_slip: 3.1e-3, ..first[0] };
    first[1] = SegmentSeen { state: SegmentState::Broken, plastic_strain: 0.1, ..first[1] };
    first[2].state = SegmentState::CutOff;
    let group = told(240, 4e8, first);
    assert_eq!((group.yielded, group.broken, group.slid, group.cut, group.gone), (1, 1, 1, 1, 0));
    assert_eq!((group.length, group.segments, group.yield_force), (720.0, 720, 2e5));
    assert_eq!(group.placed, "bench 1");
    let (headline, text, severity) = said(group);
    assert!(headline.starts_with("1 of 240 bolts yielded, 1 broke;"), "{headline}");
    assert!(text.ends_with("The bond of 1 slid; largest slip 3.10 mm. Excavations cut 1."), "{text}");
    assert_eq!(severity, Severity::Through);
}

#[test]
fn a_group_that_never_yields_is_told_by_its_force() {
    let free = SegmentSeen { yields_at: f64::INFINITY, ..under(1e5) };
    let group = told(8, f64::INFINITY, [free; 3]);
    assert!(group.yield_force.is_nan() && group.force_over_yield == 0.0);
    assert_eq!(said(group).0, "8 bolts, which never yield; largest force 164 kN");
}

#[test]
fn a_group_that_was_excavated_says_so_and_one_that_is_not_there_says_nothing() {
    let cut = SegmentSeen { state: SegmentState::CutOff, ..under(0.0) };
    let group = told(1, 4e8, [cut; 3]);
    assert_eq!((group.cut, group.gone), (1, 1));
    assert!(said(group).0.starts_with("excavations removed its one bolt"));

    let sets = [set("crown", 2, Stage::Shaking, 4e8), set("empty", 0, Stage::Before(0), 4e8)];
    let look = |_: usize, _: usize| -> Vec<SegmentSeen> { unreachable!("not placed yet") };
    let plan = plan(&["initial"]);
    for stage in [None, Some(Stage::Before(0))] {
        let groups = super::bolts(&sets, &plan, stage, &look, &[]);
        assert!(!groups["crown"].there && groups["crown"].placed == "earthquake");
        assert!(groups.values().all(|group| group.force_over_yield == 0.0 && group.max_slip == 0.0));
        assert!(findings(&groups).is_empty());
    }
}

#[test]
fn bars_that_were_shortened_or_left_out_are_warned_of() {
    let mut sets = [set("good", 2, Stage::Before(0), 4e8), set("bad", 2, Stage::Before(0), 4e8)];
    sets[1].cuts = Cuts { given: 5, shortened: 1, left_out: 3, crossings: 0 };
    let all = |sets: &[BoltSet]| warnings(&super::bolts(sets, &plan(&[]), None, &|_, _| Vec::new(), &[]));
    let said = all(&sets);
    assert_eq!(said.len(), 1);
    assert!(said[0].0 == "bad" && said[0].1.contains("of the 5 bolts of 'bad' 3 left out"), "{}", said[0].1);
    assert!(said[0].1.contains("1 shortened"));
    sets[0] = set("none", 0, Stage::Before(0), 4e8);
    sets[1].bolts.clear();
    let said = all(&sets);
    assert!(said[0].1.contains("no bolts in 'none'") && said[1].1.contains("none of the 5"), "{said:?}");
}

#[test]
fn a_monitor_takes_the_segment_nearest_to_it() {
    let sets = [set("empty", 0, Stage::Before(0), 4e8), set("crown", 3, Stage::Before(0), 4e8)];
    let mut plan = plan(&[]);
    let monitor = |name: &str, set| BoltMonitor { name: name.into(), point: [2.2, 0.0, 9.0], set };
    plan.bolts = vec![monitor("A", 0), monitor("B", 1)];
    let found = monitors(&sets, &plan);
    assert_eq!(found.len(), 1, "a group without bolts has none");
    let place = &found["B"];
    assert_eq!((place.group.as_str(), place.bolt, place.at), ("crown", 3, [2.0, 0.0, 2.5]));
    assert_eq!(place.from_head, 2.5);
}
