//! Displacements of stages: what is read, how a stage is cut into steps, what is refused.

use std::path::Path;

use tremolite_case::{Case, Moved};
use tremolite_laws::materials::MATERIALS;

use crate::problems::{Bad, bad};

const GOOD: &str = include_str!("../cases/every-key.toml");
const JACK: &str = "ux = \"1 mm\"\nuz = 0\nsteps = 1";

fn read(source: &str) -> Case {
    Case::parse(Path::new("case.toml"), source, MATERIALS).unwrap_or_else(|e| panic!("{e}"))
}

/// Way of a name along an axis in each stage \[m\].
fn ways(case: &Case, name: &str, axis: usize) -> Vec<f64> {
    let of = |k: usize| case.stages[k].displacements.iter().find(|one| one.name == name);
    (0..case.stages.len()).filter_map(|k| of(k)?.to[axis]).collect()
}

#[test]
fn every_value_of_a_displacement_arrives_in_si() {
    let case = read(GOOD);
    let [jack, top] = &case.stages[1].displacements[..] else { panic!("two displacements") };
    assert!(matches!(&jack.of, Moved::Group(group) if group.value == "*.lining"));
    assert_eq!(jack.within, [Some([1.0, 2.0]), Some([0.0, 5.0]), Some([-10.0, -9.0])]);
    assert_eq!((jack.name.as_str(), jack.to), ("jack", [Some(1e-3), None, Some(0.0)]));
    assert!(matches!(&top.of, Moved::Face(face) if face.value == "top"));
    assert_eq!((top.name.as_str(), top.to), ("top", [None, Some(-1e-3), None]));
    assert!(case.stages[1].moves && !case.stages[0].moves);
}

#[test]
fn what_a_stage_moves_is_held_from_the_beginning_and_stays_where_it_was_moved_to() {
    let steps = GOOD.replace("uz = 0\nsteps = 1", "uz = 0").replace("steps = 1", "steps = 4");
    let later = "[[stage]]\nname = \"back\"\ndisplacement = { name = \"jack\", group = \"*.lining\", within = { x = [\"1 m\", \"2 m\"], y = [0, \"5 m\"], \
                 z = [\"-10 m\", \"-9 m\"] }, ux = \"-1 mm\", steps = 2 }\n[[stage]]\nname = \"rest\"\n[motion]";
    let case = read(&steps.replace("[motion]", later));
    let names: Vec<&str> = case.stages[1..].iter().map(|stage| stage.name.value.as_str()).collect();
    let filled = (1..=4).map(|k| format!("tunnel filled {k}/4"));
    let expected: Vec<String> = filled.chain(["back 1/2".into(), "back 2/2".into(), "rest".into()]).collect();
    assert_eq!(names, expected);
    assert_eq!(ways(&case, "jack", 0), [0.0, 0.25e-3, 0.5e-3, 0.75e-3, 1e-3, 0.0, -1e-3, -1e-3]);
    assert_eq!(ways(&case, "jack", 2), [0.0; 8]);
    assert_eq!(ways(&case, "top", 1), [0.0, -0.25e-3, -0.5e-3, -0.75e-3, -1e-3, -1e-3, -1e-3, -1e-3]);
    // What else the stage changes comes with its first step, and stays by itself.
    let pressed: Vec<usize> = case.stages.iter().map(|stage| stage.pressures.len()).collect();
    assert_eq!(pressed, [0, 2, 0, 0, 0, 0, 0, 0]);
}

#[rustfmt::skip]
const BAD: &[Bad] = &[
    bad(JACK, "steps = 1", "[[stage.displacement]]", "nothing says how far it is moved", "0 for a support"),
    bad(JACK, "ux = \"1 MPa\"", "\"1 MPa\"", "a length is expected", "0.5 m"),
    bad(JACK, "ux = \"1e-3 m\"\nsteps = 0", "0", "`steps` should be a whole number from 1 to 5000", "steps"),
    bad("group = \"*.lining\"\nwithin", "group = \"*.lining\"\nface = \"top\"\nwithin", "face", "`face` cannot stand beside `group`", "one of"),
    bad("x = [\"1 m\", \"2 m\"]", "x = [\"2 m\", \"1 m\"]", "[\"2 m\", \"1 m\"]", "the larger coordinate stands first", "swap"),
    bad("name = \"jack\"", "name = \"A\"", "[[stage.displacement]]", "a monitor is called 'A' as well", "another `name`"),
    bad("release = \"100 %\"", "release = 0.5", "0.5", "lets go of all that is held", "a stage of its own"),
    bad("[motion]", "[[stage]]\nname = \"again\"\ndisplacement = { name = \"jack\", face = \"top\", ux = 0 }\n[motion]", "{ name = \"jack\", face = \"top\", ux = 0 }", "'jack' meant other nodes in an earlier stage", "another `name`"),
];

#[test]
fn each_mistake_in_a_displacement_is_reported_once_at_its_place_with_a_way_out() {
    let failures: Vec<String> = BAD.iter().filter_map(Bad::failure).collect();
    assert!(failures.is_empty(), "{} of {}:\n{}", failures.len(), BAD.len(), failures.join("\n\n"));
}

#[test]
fn displacements_of_a_stage_have_the_same_steps_and_names_of_their_own() {
    for (from, to, message) in [
        (JACK, "ux = \"1e-3 m\"\nsteps = 3", "a stage goes in 3 and in 1 steps"),
        ("name = \"jack\"", "name = \"top\"", "'top' is moved twice in this stage"),
    ] {
        let source = GOOD.replace(from, to);
        let report = Case::parse(Path::new("case.toml"), &source, MATERIALS).expect_err(to);
        let [problem] = &report.problems[..] else { panic!("{report}") };
        assert_eq!(problem.message, message);
        assert!(source[problem.span.start..].starts_with("[[stage.displacement]]\nface"), "{report}");
    }
}
