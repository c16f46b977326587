//! Draws the figures of waves at angles and of a matched motion at depth, in docs/boundaries and docs/records: `cargo run --release -p tremolite-cli
//! --example wave_figures`.
//!
//! Both are of small boxes of level ground without openings. At their corners the model is run; at depth the field alone is asked.

use std::error::Error;
use std::f64::consts::PI;
use std::path::Path;
use std::sync::Arc;
use tremolite::Engine;
use tremolite::free_field::GivenField;
use tremolite::job::{Given, Inputs, Job};
use tremolite::waves::ObliqueField;
use tremolite_motion::{Channel, TargetSpectrum, pseudo_acceleration};
use tremolite_report::loops::{Curve, Loops, Named, Plane, Quantity};

/// Where each goes below docs.
pub const CORNERS: &str = "boundaries/corners.svg";
pub const DEPTH: &str = "records/matched-depth.svg";

fn main() -> Result<(), Box<dyn Error>> {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let (corners, apart) = corners()?;
    std::fs::write(docs.join(CORNERS), corners)?;
    println!("model beside field at the corners: {:.2} % of the largest velocity", 100.0 * apart);
    let (depth, peaks) = depth()?;
    std::fs::write(docs.join(DEPTH), depth)?;
    peaks.iter().for_each(|row| println!("{row}"));
    Ok(())
}

const GROUND: &str = r#"
[[mesh.box.part]]
group = "hard"
x = ["0 m", "WIDTH m"]
y = ["0 m", "LENGTH m"]
z = ["0 m", "HALF m"]
[[mesh.box.part]]
group = "weathered"
x = ["0 m", "WIDTH m"]
y = ["0 m", "LENGTH m"]
z = ["SOFT m", "HEIGHT m"]
[material.hard]
law = "elastic"
young = "16 GPa"
poisson = 0.3
density = "2650 kg/m3"
[material.rock]
law = "elastic"
young = "8 GPa"
poisson = 0.3
density = "2500 kg/m3"
[material.weathered]
law = "elastic"
young = "3 GPa"
poisson = 0.3
density = "2300 kg/m3"
[[region]]
groups = ["hard"]
material = "hard"
element = "reduced-integration"
[[region]]
groups = ["rock"]
material = "rock"
element = "reduced-integration"
[[region]]
groups = ["weathered"]
material = "weathered"
element = "reduced-integration"
"#;

/// A box of level ground in three layers, its size \[m\] and elements, under SV at 25° towards 30°.
fn case(size: [u32; 3], elements: [u32; 3], motion: &str, dynamic: &str) -> String {
    let [x, y, z] = [0, 1, 2].map(|i| format!("{{ to = \"{} m\", elements = {} }}", size[i], elements[i]));
    let ground = GROUND
        .replace("WIDTH", &size[0].to_string())
        .replace("LENGTH", &size[1].to_string())
        .replace("HALF", &(size[2] / 2).to_string())
        .replace("SOFT", &(size[2] * 4 / 5).to_string())
        .replace("HEIGHT", &size[2].to_string());
    format!(
        "title = \"level ground\"\n[mesh.box]\nx = {x}\ny = {y}\nz = {z}\ngroup = \"rock\"\n{ground}[motion]\n{motion}[[motion.wave]]\ntype = \"SV\"\n\
         angle = \"25 deg\"\nazimuth = \"30 deg\"\ncomponent = \"north\"\n[dynamic]\nsides = \"free-field\"\n{dynamic}"
    )
}

fn job(text: &str, given: &Given) -> Result<Job, Box<dyn Error>> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/records");
    Job::of_text(text, &directory, given).map_err(|fault| fault.to_string().into())
}

fn field(job: &Job) -> Result<Arc<ObliqueField>, Box<dyn Error>> {
    Ok(job.plan.waves.as_ref().ok_or("no waves")?.field.clone())
}

/// Of the pulse \[Hz\], and its largest velocity \[m/s\].
const FREQUENCY: f64 = 5.0;
const PEAK: f64 = 0.1;

/// A Ricker pulse of velocity, as acceleration every 0.005 s.
fn pulse() -> Given {
    let at = |k: i32| {
        let t = 0.005 * f64::from(k) - 0.25;
        let a = (PI * FREQUENCY).powi(2);
        PEAK * 2.0 * a * t * (2.0 * a * t * t - 3.0) * (-a * t * t).exp()
    };
    let samples = (0..120).map(at).collect();
    let records = [("pulse".to_owned(), vec![Channel::new("pulse", 0.005, samples)])].into();
    Given { inputs: Inputs { records, ..Inputs::default() }, ..Given::default() }
}

/// Velocity of model and field at the upper corners, over time; and the largest difference over the largest velocity.
fn corners() -> Result<(String, f64), Box<dyn Error>> {
    let motion = "kind = \"incident\"\nnorth = { file = \"pulse\", units = \"m/s2\", dt = \"0.005 s\" }\nprocessing = [\"baseline\"]\n";
    let size = [120, 180, 60];
    let text = case(size, [30, 45, 15], motion, "duration = \"0.9 s\"\nlevels = 1\n");
    let job = job(&text, &pulse())?;
    let field = field(&job)?;
    let Job { model, assembly, phase, dt, .. } = &job;
    let named =
        [("south-west", [0, 0]), ("south-east", [1, 0]), ("north-west", [0, 1]), ("north-east", [1, 1])];
    let places = named.map(|(_, [x, y])| [x * size[0], y * size[1], size[2]].map(f64::from));
    let nodes = places.map(|place| {
        let at = |n: &usize| {
            let own = model.mesh.nodes[model.mesh_node[*n] as usize];
            (0..3).all(|i| (own[i] - place[i]).abs() < 1e-6)
        };
        (0..model.mesh_node.len()).find(at)
    });
    let mut state = assembly.rest();
    state.dt = *dt;
    let mut engine = Engine::new(model, assembly, phase);
    let (mut times, mut found, mut exact) = (Vec::new(), Vec::new(), Vec::new());
    while state.time() < 0.9 {
        engine.step(&mut state);
        let middle = state.time() - 0.5 * dt;
        times.push(middle);
        found.push(nodes.map(|node| node.map_or([f64::NAN; 3], |n| state.du[n].xyz().map(|du| du / dt))));
        exact.push(places.map(|at| field.velocity(at, middle, 1e-4)));
    }
    let each = found.iter().zip(&exact).flat_map(|(a, b)| a.iter().flatten().zip(b.iter().flatten()));
    let (worst, most) =
        each.fold((0.0_f64, 0.0_f64), |(worst, most), (a, b)| (worst.max((a - b).abs()), most.max(b.abs())));
    let plane = |(axis, name): (usize, &str)| {
        let field = named.iter().enumerate().map(|(k, (corner, _))| Curve {
            name: (*corner).into(),
            colour: k,
            across: times.clone().into(),
            up: exact.iter().map(|now| now[k][axis]).collect::<Vec<f64>>().into(),
            points: false,
        });
        // Every tenth step is told by a ring.
        let every = || (0..times.len()).step_by(10);
        let steps = || (0..4).flat_map(|k| every().map(move |step| (k, step)));
        let model = Curve {
            name: "model".into(),
            colour: 4,
            across: steps().map(|(_, step)| times[step]).collect::<Vec<f64>>().into(),
            up: steps().map(|(k, step)| found[step][k][axis]).collect::<Vec<f64>>().into(),
            points: true,
        };
        Plane {
            across: Quantity::new("time", "s"),
            up: Quantity::new(name, "m/s"),
            curves: field.chain([model]).collect(),
            named: Named::Nothing,
        }
    };
    let loops = Loops {
        title:
            "Upper corners of a box under SV at 25° towards 30° from north: field (lines) and model (rings)"
                .into(),
        along: Quantity::new("", ""),
        time: &[],
        planes: [(1, "velocity north"), (2, "up")].map(plane).into(),
        tracks: vec![],
        states: None,
    };
    Ok((loops.draw(), worst / most))
}

/// What the motion is fitted to, and where \[s\].
const TARGET: &str = "EN 1998-1 type 1 ground A 2 m/s2";
const BAND: [f64; 2] = [0.1, 2.0];

/// Spectra of a matched motion of the bare rock, and of what it is in the ground; and of each the largest.
fn depth() -> Result<(String, Vec<String>), Box<dyn Error>> {
    let motion = format!(
        "kind = \"outcrop\"\nnorth = {{ file = \"20161113_110259_WTMC_20.V2A\", channel = \"20161113_110259_WTMC_20 N28W\" }}\ntarget = \"{TARGET}\"\n\
         processing = [\"detrend linear\", \"taper 1 s\", \"bandpass 0.1 Hz 20 Hz\", \"baseline\", \"match {} s {} s\"]\n",
        BAND[0], BAND[1]
    );
    let size = [40, 40, 100];
    let text =
        case(size, [4, 4, 20], &motion, "damping = { ratio = 0.02, band = [\"0.5 Hz\", \"20 Hz\"] }\n");
    let job = job(&text, &Given::default())?;
    let field = field(&job)?;
    let given = job.plan.shaken_by(&job.model).ok_or("no motion")?;
    let target = TargetSpectrum::parse_code(TARGET)?;
    let (dt, periods) =
        (0.005, (0..200).map(|k| 0.04 * 50_f64.powf(f64::from(k) / 199.0)).collect::<Vec<f64>>());
    // Along the wave's way in plan.
    let along = job.plan.waves.as_ref().map_or([0.0; 2], |waves| waves.waves[0].heading.along);
    let within = |depth: f64| -> Result<Vec<f64>, Box<dyn Error>> {
        let at = [20.0, 20.0, f64::from(size[2]) - depth];
        let count = ((given.duration() + field.lead() + 0.5) / dt) as usize;
        let moved = |k: usize, by: f64| {
            let [x, y, _] = field.displacement(at, k as f64 * dt + by);
            along[0] * x + along[1] * y
        };
        let half = 0.5 * dt;
        let acceleration: Vec<f64> = (1..count)
            .map(|k| (moved(k, half) - 2.0 * moved(k, 0.0) + moved(k, -half)) / (half * half))
            .collect();
        Ok(pseudo_acceleration(&acceleration, dt, &periods, target.damping)?)
    };
    let outcrop = pseudo_acceleration(&given.acceleration[1], given.dt, &periods, target.damping)?;
    let curves = [
        ("target", periods.iter().map(|&period| target.at(period)).collect()),
        ("matched, bare rock", outcrop),
        ("surface", within(0.0)?),
        ("35 m deep", within(35.0)?),
        ("base, 100 m deep", within(100.0)?),
    ];
    let peaks = curves.iter().map(|(name, spectrum): &(&str, Vec<f64>)| {
        let most = spectrum
            .iter()
            .zip(&periods)
            .fold((0.0, 0.0), |most, (sa, period)| if *sa > most.0 { (*sa, *period) } else { most });
        format!("{name}: largest {:.2} m/s2 at {:.2} s", most.0, most.1)
    });
    let peaks = peaks.collect();
    let curves = curves.iter().enumerate().map(|(k, (name, spectrum))| Curve {
        name: (*name).into(),
        colour: k,
        across: periods.clone().into(),
        up: spectrum.clone().into(),
        points: false,
    });
    let plane = Plane {
        across: Quantity::new("period", "s"),
        up: Quantity::new("spectral acceleration, 5 %", "m/s2"),
        curves: curves.collect(),
        named: Named::Nothing,
    };
    let loops = Loops {
        title: "A motion matched to EN 1998-1 type 1 ground A as SV at 25° in three layers, along its way in plan".into(),
        along: Quantity::new("", ""),
        time: &[],
        planes: vec![plane],
        tracks: vec![],
        states: None,
    };
    Ok((loops.draw(), peaks))
}
