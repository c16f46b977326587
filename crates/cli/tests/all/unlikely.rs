//! Slips of units that can be computed with: `check` warns of each, with the number and a remedy, and of none in the case that `new` writes.

use crate::stage_case::{code, errors, tremolite};

#[test]
fn slips_of_units_are_warned_of_and_a_new_case_has_none() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    tremolite(at, &["new", "study"]);
    let slow: String = (0..40).map(|k| format!("{} {}\n", 0.06 * f64::from(k), (k % 7) - 3)).collect();
    std::fs::write(at.join("study/slow.txt"), slow).unwrap();
    let sound = tremolite(at, &["check", "study/case.toml"]);
    assert_eq!(code(&sound), 0);
    assert!(!errors(&sound).contains("warning"), "{}", errors(&sound));

    let coarse = "mesh.caverns.far=\"500 m\"";
    let slips: &[(&[&str], &str, &str)] = &[
        (
            &["mesh.caverns.overburden=\"4 km\"", coarse],
            "4000 m of rock lie above the crown",
            "look at its unit",
        ),
        (&["mesh.caverns.below=\"6 km\"", coarse], "the model is 6.1 km across", "look at the units"),
        (&["mesh.caverns.cavern[0].width=\"62 m\""], "'hall' is 62 m wide", "look at its unit"),
        (&["mesh.caverns.cavern[0].height=\"102 m\""], "'hall' is 102 m high", "look at its unit"),
        (&["mesh.caverns.cavern[0].lining.walls=\"0.04 m\""], "a lining of 0.04 m", "look at its unit"),
        (&["dynamic.duration=\"12 s\""], "goes on for another 10.50 s", "leave `duration` out"),
        (&["motion.process=[\"scale 0.03\"]"], "0.147 m/s2, 0.0150 g", "a record in g"),
        (&["motion.process=[\"scale 5\"]"], "24.479 m/s2, 2.4962 g", "look at `units`"),
        (
            &["motion.east.file=\"slow.txt\"", "motion.east.units=\"m/s2\""],
            "the samples are 0.06 s apart",
            "rate of sampling",
        ),
    ];
    for (set, message, remedy) in slips {
        let mut args = vec!["check", "study/case.toml"];
        args.extend(set.iter().flat_map(|set| ["--set", set]));
        let done = tremolite(at, &args);
        let words = errors(&done);
        assert_eq!(code(&done), 0, "{set:?}: {words}");
        assert!(words.contains(message) && words.contains(remedy), "{set:?}: {words}");
    }
    // Just within the limits nothing of the kind is said.
    for set in [
        "mesh.caverns.cavern[0].width=\"58 m\"",
        "dynamic.duration=\"11 s\"",
        "motion.process=[\"scale 0.05\"]",
    ] {
        let words = errors(&tremolite(at, &["check", "study/case.toml", "--set", set]));
        assert!(
            !words.contains("wide, where") && !words.contains("goes on") && !words.contains(" g, where"),
            "{words}"
        );
    }
}
