//! Cases whose motion was recorded on or within layered ground: what is refused, and what comes out of whole runs.

use crate::ready::Ready;
use std::f64::consts::TAU;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use tremolite::laws;
use tremolite::run::{Control, run};
use tremolite::setup::{Laws, Setup, setup};
use tremolite::simulation::{Built, Simulation, Start};
use tremolite_case::Case;
use tremolite_laws::{Isa, LawInfo};
use tremolite_mesh::boxes::BoxSpec;
use tremolite_results::{ResultFolder, Table};

/// A case of 40 m of soil (500 m/s) on 60 m of rock (2000 m/s).
struct GroundCase<'a> {
    /// Keys of `[motion]`.
    motion: &'a str,
    process: &'a str,
    /// Keys of `[dynamic]`.
    sides: &'a str,
    damped: bool,
    /// Whether the soil is 20 m thicker at the high end of x.
    step: bool,
    /// Every so many samples of the record are given.
    every: usize,
    /// Elements over the height, a multiple of 5.
    layers: u32,
}

impl Default for GroundCase<'_> {
    fn default() -> Self {
        GroundCase {
            motion: "kind = \"surface\"",
            process: "\"lowpass 9 Hz\"",
            sides: "sides = \"periodic\"",
            damped: true,
            step: false,
            every: 1,
            layers: 25,
        }
    }
}

impl GroundCase<'_> {
    fn text(&self) -> String {
        let GroundCase { motion, process, sides, .. } = self;
        let damping = match self.damped {
            true => r#"damping = { ratio = 0.03, band = ["0.5 Hz", "20 Hz"], reference = "3 Hz" }"#,
            false => "",
        };
        format!(
            r#"
title = "ground"
[mesh.file]
path = "ground.inp"
[material.rock]
law = "elastic"
young = "27 GPa"
poisson = 0.25
density = "2700 kg/m3"
[material.soil]
law = "elastic"
young = "1.25 GPa"
poisson = 0.25
density = "2000 kg/m3"
[[region]]
groups = ["rock"]
material = "rock"
element = "reduced-integration"
[[region]]
groups = ["soil"]
material = "soil"
element = "reduced-integration"
[motion]
{motion}
east = {{ file = "record.txt" }}
up = {{ from = "east", factor = 0.5 }}
processing = ["taper 0.2 s", {process}]
[dynamic]
base = "viscous"
{sides}
{damping}
[output]
histories = "5 ms"
"#
        )
    }

    /// The case of a text, with its record and its mesh.
    fn case(&self, text: &str, folder: &Path) -> Case {
        // Bursts from 1 Hz to 7 Hz, and a little of 11 Hz.
        let sample = |k: u32| {
            let t = f64::from(k) * 0.005;
            let burst = |hertz: f64, at: f64| (TAU * hertz * t).sin() * (-((t - at) / 0.3).powi(2)).exp();
            0.3 * (burst(1.0, 0.9) + burst(4.0, 1.1) + burst(7.0, 1.4)) + 0.02 * burst(11.0, 1.2)
        };
        let samples: Vec<String> =
            (0..500).step_by(self.every).map(|k| format!("{:.6}", sample(k))).collect();
        let dt = 0.005 * self.every as f64;
        let record = format!("# units = \"m/s2\"\n# dt = \"{dt} s\"\n{}\n", samples.join("\n"));
        std::fs::write(folder.join("record.txt"), record).unwrap();
        let mut mesh =
            BoxSpec::uniform([0.0, 0.0, -100.0], [4.0, 4.0, 0.0], [2, 1, self.layers]).mesh().unwrap();
        let (soil, rock) = (0..mesh.elements.len() as u32).partition(|&e| {
            let [x, _, z] = tremolite::hexahedra::centroid(&mesh, e);
            z > if self.step && x > 2.0 { -60.0 } else { -40.0 }
        });
        mesh.groups = [("rock".to_owned(), rock), ("soil".to_owned(), soil)].into();
        tremolite_mesh::write(folder.join("ground.inp"), &mesh).unwrap();
        let infos: Vec<LawInfo> = laws().iter().map(|l| l.info).collect();
        Case::parse(&folder.join("case.toml"), text, &infos).unwrap_or_else(|e| panic!("{e}"))
    }

    fn setup(&self) -> Result<Setup, String> {
        let folder = tempfile::tempdir().unwrap();
        setup(&self.case(&self.text(), folder.path()), &Laws::default(), Isa::best())
            .map_err(|report| report.to_string())
    }

    fn refusal(&self) -> String {
        self.setup().err().unwrap_or_else(|| panic!("must be refused:\n{}", self.text()))
    }

    /// motion.csv and free_field.csv of its run.
    fn run(&self) -> [Table; 2] {
        let Setup { problem, plan, .. } = self.setup().unwrap();
        let Ready { model, assembly, phase } = Ready::new(problem);
        let parent = tempfile::tempdir().unwrap();
        let results = ResultFolder::create(Some(&parent.path().join("out")), "ground", false).unwrap();
        let mut control = Control { stop: &AtomicBool::new(false), progress: &mut |_| {} };
        Simulation::new(&Built::of(&model, &assembly, &phase), &plan, &results, Start::Rest, Vec::new())
            .and_then(|simulation| run(simulation, &mut control))
            .unwrap();
        [results.motion(), results.free_field()].map(|path| Table::read(&path).unwrap())
    }
}

/// Largest difference of two columns over the largest of the first, row by row.
fn difference(of: [(&Table, &str); 2]) -> f64 {
    let [a, b] = of.map(|(table, name)| table.column(name).unwrap_or_else(|| panic!("{name}")));
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, |most, x| most.max(x.abs()));
    largest(&mut a.iter().zip(b).map(|(a, b)| a - b)) / largest(&mut a.iter().copied())
}

#[test]
fn a_record_of_the_surface_or_of_a_depth_comes_out_there_with_order_two() {
    for motion in ["kind = \"surface\"", "kind = \"within\"\ndepth = \"4 m\""] {
        let errors = |layers: u32| {
            let [given, seen] = GroundCase { motion, layers, ..GroundCase::default() }.run();
            let time = [&given, &seen].map(|table| table.column("time").unwrap().to_vec());
            assert!(
                time[1].iter().zip(&time[0]).all(|(a, b)| (a - b).abs() < 1e-9),
                "rows at the record's samples"
            );
            ["x", "z"].map(|axis| {
                let [given_name, seen_name] =
                    [format!("given.v{axis}"), format!("record.free_field.v{axis}")];
                difference([(&given, &given_name), (&seen, &seen_name)])
            })
        };
        let (coarse, fine) = (errors(25), errors(50));
        for k in 0..2 {
            let order = (coarse[k] / fine[k]).log2();
            println!("{motion}, {}: {:.5} {:.5}, order {order:.2}", ["x", "z"][k], coarse[k], fine[k]);
            // (kh)²/24 of the phase kH = 2π·7·40/500 = 3.5 in elements of 2 m is 0.4 %, and the burst of 7 Hz a third of the record.
            assert!(
                fine[k] < 0.002 && (order - 2.0).abs() < 0.15,
                "{motion}: {coarse:?} {fine:?}, order {order}"
            );
        }
    }
}

/// One deep wave, two records of it: what the surface of a model shows is a record of the surface that makes that wave again.
#[test]
fn the_surface_of_one_run_is_a_record_for_the_next() {
    let ground = GroundCase::default();
    let Setup { problem, motion, .. } = ground.setup().unwrap();
    let site = motion.unwrap().site.unwrap();
    assert_eq!((site.corner, site.depth, site.band), (Some(0), 0.0, 9.0));
    assert!((site.at_rest - 2.0).abs() < 1e-3 && site.reach == f64::INFINITY && site.left_out == 0.0);
    // Twice the input is twice the wave.
    let twice =
        GroundCase { process: "\"lowpass 9 Hz\", \"scale 2\"", ..GroundCase::default() }.setup().unwrap();
    let (one, two) = (problem.incident.unwrap().motion, twice.problem.incident.unwrap().motion);
    for (a, b) in one.acceleration.iter().flatten().zip(two.acceleration.iter().flatten()) {
        assert!((2.0 * a - b).abs() < 1e-9, "{a} {b}");
    }
    // Nothing comes before the wave can have left the base: 40 m at 500 m/s and 60 m at 2000 m/s.
    assert!((site.lead - 0.110).abs() < 1e-9, "{}", site.lead);
    assert_eq!(one.acceleration[0].len(), 500 + 22);
}

/// Layers of the case that are those of the model make the same wave, and rock of the base below them changes only its time.
#[test]
fn layers_of_the_case_make_the_wave_that_the_same_layers_of_the_model_make() {
    let undamped = |motion: &str| {
        GroundCase { motion, damped: false, ..GroundCase::default() }
            .setup()
            .unwrap_or_else(|e| panic!("{e}"))
    };
    let layers = r#"
site.layers = [{ thickness = "40 m", shear_wave_velocity = "500 m/s", poisson = 0.25, density = "2000 kg/m3", damping = 0.0 }]"#;
    for motion in ["kind = \"surface\"", "kind = \"within\"\ndepth = \"4 m\""] {
        let (own, given) = (undamped(motion), undamped(&format!("{motion}{layers}")));
        assert_eq!(given.motion.as_ref().unwrap().site.as_ref().unwrap().corner, None);
        let [own, given] = [own, given].map(|setup| setup.problem.incident.unwrap().motion);
        // The wave passes 60 m of rock before it comes to the layers.
        assert!((own.duration() - given.duration() - 0.030).abs() < 1e-9);
    }
}

#[test]
fn what_cannot_be_deconvolved_is_refused_with_the_way_out() {
    let within = "kind = \"within\"\ndepth = \"25 m\"";
    // Undamped, the notch of 25 m lies at 500/(4·25) = 5 Hz.
    let notch = GroundCase { motion: within, damped: false, ..GroundCase::default() }.refusal();
    for words in [
        "at 5.00 Hz hardly anything moves",
        "up to 9.00 Hz, the low-pass",
        "put a low-pass of 3.66 Hz or less",
    ] {
        assert!(notch.contains(words), "{words}: {notch}");
    }
    let low =
        GroundCase { motion: within, damped: false, process: "\"lowpass 4 Hz\"", ..GroundCase::default() }
            .setup();
    let site = low.unwrap_or_else(|e| panic!("{e}")).motion.unwrap().site.unwrap();
    assert!(site.reach < 5.0 && site.left_out > 0.0 && site.left_out < 0.05, "{site:?}");

    let deep =
        GroundCase { motion: "kind = \"within\"\ndepth = \"120 m\"", ..GroundCase::default() }.refusal();
    assert!(
        deep.contains("the model's base lies 100.0 m below its surface")
            && deep.contains("motion.site.layers"),
        "{deep}"
    );
    let buried =
        GroundCase { sides: "sides = \"periodic\"\ntop = \"viscous\"", ..GroundCase::default() }.refusal();
    assert!(buried.contains("ground goes on above this model"), "{buried}");
    // Ground above may be there as a pressure alone.
    let ground = GroundCase::default();
    let text =
        ground.text().replace("[output]", "[initial]\nlateral = 0.8\noverburden = \"2 MPa\"\n[output]");
    let folder = tempfile::tempdir().unwrap();
    let pressed =
        setup(&ground.case(&text, folder.path()), &Laws::default(), Isa::best()).err().unwrap().to_string();
    assert!(pressed.contains("ground goes on above this model"), "{pressed}");
}

/// The same ground, inside sides that leave it alone and beside slabs and columns of its own.
#[test]
fn the_wave_is_the_same_with_periodic_sides_and_with_a_free_field() {
    let wave = |sides: &str| {
        GroundCase { sides, ..GroundCase::default() }.setup().unwrap().problem.incident.unwrap().motion
    };
    assert_eq!(wave("sides = \"periodic\""), wave("sides = \"free-field\""));
}

/// Where the ground differs from corner to corner the case says on which the record was taken.
#[test]
fn unlike_corners_are_told_apart_by_the_case() {
    let refused = GroundCase { step: true, ..GroundCase::default() }.refusal();
    assert!(
        refused.contains("not the same at xmin-ymin and xmax-ymin") && refused.contains("site = { corner"),
        "{refused}"
    );
    let at = |corner: &str, motion: &str| {
        let motion = format!("{motion}\nsite = {{ corner = \"{corner}\" }}");
        GroundCase { motion: &motion, step: true, ..GroundCase::default() }
            .setup()
            .unwrap_or_else(|e| panic!("{e}"))
    };
    let [low, high] = ["xmin-ymin", "xmax-ymin"].map(|corner| at(corner, "kind = \"surface\""));
    // The corner that has the ground of the level model makes its wave, and the other another.
    let wave = |setup: &Setup| setup.problem.incident.clone().unwrap().motion;
    assert_eq!(wave(&low), wave(&GroundCase::default().setup().unwrap()));
    assert_ne!(wave(&low), wave(&high));
    let site = high.motion.unwrap().site.unwrap();
    assert_eq!(site.corner, Some(1));
}

/// What can be run though its numbers are not what they seem is warned of, and what is sound is not.
#[test]
fn motions_that_are_not_what_they_seem_are_warned_of() {
    let warnings = |ground: &GroundCase| -> Vec<String> {
        let setup = ground.setup().unwrap_or_else(|e| panic!("{e}"));
        setup.warnings.into_iter().map(|problem| problem.message).collect()
    };
    let sound = GroundCase { process: "\"lowpass 9 Hz\", \"baseline\"", ..GroundCase::default() };
    assert_eq!(warnings(&sound), Vec::<String>::new());
    let layer = |velocity: &str, density: &str| {
        format!(
            "kind = \"surface\"\nsite.layers = [{{ thickness = \"4 m\", shear_wave_velocity = \"{velocity}\", poisson = 0.3, \
             density = \"{density}\", damping = 0.2 }}]"
        )
    };
    let [fine, soft, light, slow] = [
        ("300 m/s", "1900 kg/m3"),
        ("45 m/s", "1900 kg/m3"),
        ("300 m/s", "190 kg/m3"),
        ("30 m/s", "1900 kg/m3"),
    ]
    .map(|(velocity, density)| layer(velocity, density));
    let process = "\"lowpass 9 Hz\", \"baseline\"";
    assert_eq!(
        warnings(&GroundCase { motion: &fine, process, ..GroundCase::default() }),
        Vec::<String>::new()
    );
    for (ground, words) in [
        // The burst of 4 Hz reaches over the notch at 4.2 Hz, and the low-pass leaves half of it.
        (
            GroundCase {
                motion: "kind = \"within\"\ndepth = \"29.8 m\"",
                damped: false,
                process: "\"lowpass 3.85 Hz\", \"baseline\"",
                ..GroundCase::default()
            },
            "of the processed record's energy (∫a² dt) lies above 3.85 Hz and does not come in",
        ),
        (GroundCase { motion: &soft, process, ..GroundCase::default() }, "strains this layer by about 0."),
        (
            GroundCase { motion: &light, process, ..GroundCase::default() },
            "190 kg/m3 is no density of ground",
        ),
        (
            GroundCase { motion: &slow, process, ..GroundCase::default() },
            "30 m/s is no velocity of shear waves",
        ),
        (
            GroundCase {
                process,
                sides: "sides = \"periodic\"\nduration = \"1 s\"",
                ..GroundCase::default()
            },
            "% of its energy (∫a² dt) comes after this",
        ),
        (
            GroundCase { process: "\"pga 0.3 g\", \"lowpass 2 Hz\", \"baseline\"", ..GroundCase::default() },
            "the peak of 2.942 m/s2 that is asked for becomes",
        ),
        (
            GroundCase {
                motion: "kind = \"outcrop\"",
                process: "\"detrend linear\", \"baseline\"",
                every: 7,
                ..GroundCase::default()
            },
            "between samples 0.035 s apart the acceleration is taken as linear",
        ),
    ] {
        let found = warnings(&ground);
        assert!(found.iter().any(|message| message.contains(words)), "{words}: {found:?}");
    }
    // Fifteen seconds of the Kaikōura record come to six times the displacement of all of it by what brings them to rest.
    let text = GroundCase {
        motion: "kind = \"outcrop\"\nwindow = { strongest = \"15 s\" }",
        process,
        ..GroundCase::default()
    }
    .text();
    let (head, rest) = text.split_once("east = ").unwrap();
    let (_, rest) = rest.split_once("process").unwrap();
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/records/20161113_110259_WTMC_20.V2A");
    for (window, doubted) in [("{ strongest = \"15 s\" }", true), ("[\"0 s\", \"163.84 s\"]", false)] {
        let text = format!("{head}file = \"{}\"\nprocess{rest}", file.display());
        let text = text.replace("{ strongest = \"15 s\" }", window);
        let folder = tempfile::tempdir().unwrap();
        let case = GroundCase::default().case(&text, folder.path());
        let setup = setup(&case, &Laws::default(), Isa::best()).unwrap_or_else(|e| panic!("{e}"));
        let found = setup.warnings.iter().any(|w| w.message.contains("cut out of its motion"));
        assert_eq!(
            found,
            doubted,
            "{window}: {:?}",
            setup.warnings.iter().map(|w| &w.message).collect::<Vec<_>>()
        );
    }
}

/// A trace of an SMC file that looks towards an azimuth \[deg\].
fn trace(azimuth: u32) -> String {
    let mut text = "2 CORRECTED ACCELEROGRAM\n".to_owned() + &"*\n".repeat(10);
    let integers = (1..=48).map(|i| match i {
        13 => 90,
        14 => i64::from(azimuth),
        16 => 0,
        17 => 400,
        _ => -32768,
    });
    let integers: Vec<String> = integers.map(|i| format!("{i:10}")).collect();
    integers.chunks(8).for_each(|line| text += &(line.concat() + "\n"));
    let reals: Vec<&str> =
        (1..=50).map(|i| if i == 2 { "  0.2000000E+03" } else { "  0.1700000E+39" }).collect();
    reals.chunks(5).for_each(|line| text += &(line.concat() + "\n"));
    text + &" 1.0000E+0-1.0000E+0 2.0000E+0-2.0000E+0 1.0000E+0-1.0000E+0 2.0000E+0-2.0000E+0\n".repeat(50)
}

/// Two sensors of one direction, one of them deeper perhaps, are not one the other: which is meant must be said.
#[test]
fn a_file_with_two_channels_of_one_direction_asks_which() {
    let of = |second: u32| -> Result<(), String> {
        let folder = tempfile::tempdir().unwrap();
        let ground = GroundCase { motion: "kind = \"outcrop\"", ..GroundCase::default() };
        let case = ground.case(&ground.text().replace("record.txt", "two.smc"), folder.path());
        std::fs::write(folder.path().join("two.smc"), trace(90) + &trace(second)).unwrap();
        setup(&case, &Laws::default(), Isa::best()).map(|_| ()).map_err(|report| report.to_string())
    };
    assert_eq!(of(360), Ok(()));
    let refused = of(90).unwrap_err();
    assert!(refused.contains("the channel is not clear: the file has 90 deg, 90 deg (2)"), "{refused}");
}
