//! A staged, lined cavern beside joints under SV at 25° with P at 15°: quiet without motion, its mirror image, levels and ranks.

use crate::ranks::{Case, how};
use crate::ready::Ready;
use crate::waves_at_angles::{CASE, given};
use std::path::Path;
use std::sync::atomic::AtomicBool;
use tremolite::job::{Caller, Job};
use tremolite::run::Control;
use tremolite::simulation::Start;
use tremolite_results::{ResultFolder, Summary, Table};

/// [`CASE`] in rock under its weight with a hall whose floor is lined when it is out, the lining on an interface that closes and slides, and a
/// block above it that joints part from the rock. Symmetric in x about 20 m. Waves go north-east, or to the mirror image of that.
fn jointed(mirrored: bool, levels: u32) -> String {
    let [shear, pressure] = if mirrored { [330, 300] } else { [30, 60] };
    let part = |name: &str, z: [u32; 2]| {
        format!(
            "[[mesh.box.part]]\ngroup = \"{name}\"\nx = [\"15 m\", \"25 m\"]\ny = [\"10 m\", \"20 m\"]\nz = [\"{} m\", \"{} m\"]\n",
            z[0], z[1]
        )
    };
    let parts =
        part("lining", [10, 15]) + &part("core", [15, 25]) + &part("block", [30, 35]) + "[material.rock]";
    let more = r#"[material.concrete]
law = "elastic"
young = "25 GPa"
poisson = 0.2
density = "2500 kg/m3"
[[region]]
groups = ["lining"]
material = "concrete"
element = "reduced-integration"
before = "rock"
[[interface]]
name = "joint"
between = ["block", "rock"]
law = "coulomb"
friction_coefficient = 0.1
[[interface]]
name = "bed"
between = ["lining", "rock"]
law = "bandis"
normal_stiffness = "20 GPa/m"
max_closure = "2 mm"
friction_coefficient = 0.3
[initial]
lateral = 0.5
release_cycles = 50
tolerance = 1e-6
[[stage]]
name = "out"
excavate = ["core"]
[[stage]]
name = "lined"
excavate = ["lining"]
install = ["lining"]
[motion]"#;
    CASE.replace("[material.rock]", &parts)
        .replace("groups = [\"rock\"]", "groups = [\"rock\", \"core\", \"block\"]")
        .replace("azimuth = \"30 deg\"", &format!("azimuth = \"{shear} deg\""))
        .replace(
            "[dynamic]",
            &format!("[[motion.wave]]\ntype = \"P\"\nangle = \"15 deg\"\nazimuth = \"{pressure} deg\"\ncomponent = \"up\"\n[dynamic]"),
        )
        .replace("processing =", "up = { from = \"east\", factor = 0.5 }\nprocessing =")
        .replace("[motion]", more)
        .replace("levels = 1", &format!("levels = {levels}"))
        // In the walls of the hall, at both ends of x.
        .replace("at = [\"10 m\", \"10 m\", \"40 m\"]", "at = [\"14 m\", \"15 m\", \"20 m\"]")
        .replace("at = [\"30 m\", \"10 m\", \"40 m\"]", "at = [\"26 m\", \"15 m\", \"20 m\"]")
}

fn job(text: &str) -> Job {
    Job::of_text(text, Path::new("."), &given()).unwrap_or_else(|fault| panic!("{fault}"))
}

fn run(text: &str) -> (Summary, Table) {
    let parent = tempfile::tempdir().unwrap();
    let folder = ResultFolder::create(Some(&parent.path().join("out")), "jointed", false).unwrap();
    let mut control = Control { stop: &AtomicBool::new(false), progress: &mut |_| {} };
    let (_, summary) = job(text).run(&folder, Start::Rest, &Caller::new("test"), &mut control).unwrap();
    (summary, Table::read(&folder.monitors()).unwrap())
}

/// Largest difference of what one column is and another is times a sign, less what each has at first, over the largest of the first.
fn apart(own: &Table, other: &Table, pairs: &[(&str, &str, f64)]) -> f64 {
    let (mut worst, mut most) = (0.0_f64, 0.0_f64);
    for &(name, image, sign) in pairs {
        let [a, b] = [own.column(name).unwrap(), other.column(image).unwrap()];
        for (x, y) in a.iter().zip(b) {
            worst = worst.max((x - a[0] - sign * (y - b[0])).abs());
            most = most.max((x - a[0]).abs());
        }
    }
    assert!(most > 1e-6, "{most:e}");
    worst / most
}

#[test]
fn a_staged_lined_jointed_cavern_is_quiet_mirrored_and_the_same_on_levels() {
    let (summary, own) = run(&jointed(false, 1));
    let fact = |id: &str| summary.case.facts.iter().find(|fact| fact.id == id).unwrap().value;
    assert!(fact("drift_without_motion") < 1e-9, "{}", fact("drift_without_motion"));
    // The joints work, or this were a cavern without any.
    let slips: Vec<f64> = summary.parts.interfaces.values().map(|interface| interface.ever_slid).collect();
    assert!(slips.len() == 2 && slips.iter().all(|slip| *slip > 0.0), "{slips:?}");
    let (_, mirror) = run(&jointed(true, 1));
    let image =
        [("A.ux", "B.ux", -1.0), ("A.uz", "B.uz", 1.0), ("B.uy", "A.uy", 1.0), ("B.ux", "A.ux", -1.0)];
    let off = apart(&own, &mirror, &image);
    // Pairs slide a little earlier or later by what stages leave to their tolerance.
    assert!(off < 1e-4, "{off:e}");
    // The wave goes north-east, so neither is its own image.
    let self_image = apart(&own, &own, &image);
    assert!(self_image > 0.1, "{self_image:e}");
    let (levelled, other) = run(&jointed(false, 4));
    assert!(
        levelled.computed.model.elements_of_level.len() > 1,
        "{:?}",
        levelled.computed.model.elements_of_level
    );
    let same = ["A.ux", "A.uy", "A.uz", "B.ux", "B.uy", "B.uz"].map(|name| (name, name, 1.0));
    let off = apart(&own, &other, &same);
    assert!(off < 0.02, "{off:e}");
}

#[test]
fn three_ranks_write_the_files_of_one_process_for_a_jointed_cavern_under_a_wave_at_an_angle() {
    let made = job(&jointed(false, 1).replace("duration = \"0.5 s\"", "duration = \"0.06 s\""));
    let Job { model, assembly, phase, plan, .. } = made;
    Case::of(Ready { model, assembly, phase }, plan)
        .holds("jointed cavern, wave at an angle", &[how(3, 1, false)]);
}
