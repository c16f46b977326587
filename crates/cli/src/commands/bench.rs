//! `tremolite bench`: the engine's speed on a box.

use crate::exit::{Code, Failure, Outcome};
use crate::machine;
use crate::terminal::print;
use std::sync::Arc;
use tremolite::bench::{BoxBench, run as run_box};
use tremolite::{Layers, Quadrature, laws};
use tremolite_laws::Values;
use tremolite_laws::band::Band;

/// What a law is given of these, by the names of its parameters: strengths of `wang2018`, table 1, of its rock but for f_t and G_f.
const GROUND: [(&str, f64); 6] = [
    ("young", 10e9),
    ("poisson", 0.25),
    ("cohesion", 2.18e6),
    ("friction_angle", 0.733_038_285_837_618),
    ("tensile_strength", 1.2e6),
    ("fracture_energy", 130.0),
];

#[derive(clap::Args)]
pub struct Args {
    /// What to time: a box of distorted elements, of bricks, as most of a generated mesh is, or of bricks with four levels of steps
    #[arg(value_parser = ["box", "bricks", "levels"], default_value = "box")]
    problem: String,
    /// Elements; the nearest cube is run
    #[arg(long, default_value_t = 97_336)]
    elements: usize,
    #[arg(long, default_value_t = 200)]
    steps: u64,
    #[arg(long, default_value_t = 1)]
    threads: usize,
    #[arg(long, value_parser = ["one-point", "full", "layered"], default_value = "one-point")]
    kind: String,
    /// A material law, with E 10 GPa, ν 0.25 and strengths of rock or concrete where it has them
    #[arg(long, default_value = "elastic")]
    material: String,
    /// With damping over a band, 3 % from 0.5 to 20 Hz
    #[arg(long)]
    band: bool,
    /// With a stress that elements begin with, as ground does
    #[arg(long)]
    stressed: bool,
    /// With water in the pores of the elements that cannot leave
    #[arg(long)]
    water: bool,
    /// Speed at which the top is struck (m/s); concrete cracks from some 1 m/s on
    #[arg(long, default_value_t = 0.1)]
    strike: f64,
    /// Force an instruction set: scalar, avx2 or avx512
    #[arg(long)]
    isa: Option<String>,
    /// Times to repeat; the best is reported
    #[arg(long, default_value_t = 3)]
    repeat: usize,
    #[arg(long)]
    json: bool,
}

pub fn run(args: &Args) -> Outcome {
    let isa = machine::isa(args.isa.as_deref())?;
    let quadrature = match args.kind.as_str() {
        "full" => Quadrature::Full,
        "layered" => Quadrature::Layered(Layers::default()),
        _ => Quadrature::OnePoint,
    };
    if !(1..=50_000_000).contains(&args.elements) || !(1..=4096).contains(&args.threads) {
        return Err(Failure::input("give 1 to 50 million elements and 1 to 4096 threads"));
    }
    let all = laws();
    let law = all.iter().find(|l| l.info.name == args.material).ok_or_else(|| {
        let names: Vec<&str> = all.iter().map(|l| l.info.name).collect();
        Failure::input(format!("there is no material '{}'; known are {}", args.material, names.join(", ")))
    })?;
    let parameters = law.info.parameters.iter().map(|parameter| parameter.name);
    let known = |&(name, _): &(&str, f64)| parameters.clone().any(|parameter| parameter == name);
    let values = GROUND
        .into_iter()
        .filter(known)
        .fold(Values::default(), |values, (name, value)| values.with(name, value));
    let built = match args.band {
        false => (law.build)(&values),
        true => {
            let band = Band::fit(0.03, [0.5, 20.0], 0.0).map_err(|bad| Failure::input(bad.to_string()))?;
            (law.build_banded)(&values, band)
        }
    };
    let material = built.map_err(|bad| {
        let words: Vec<String> = bad.iter().map(ToString::to_string).collect();
        Failure::input(format!("'{}' needs more than is known here: {}", args.material, words.join("; ")))
    })?;
    let bench = BoxBench {
        elements: args.elements,
        steps: args.steps,
        threads: args.threads,
        quadrature,
        distorted: args.problem == "box",
        levels: args.problem == "levels",
        stressed: args.stressed,
        water: args.water,
        strike: args.strike,
        material: Arc::clone(&material),
        isa,
    };
    let mut best = run_box(&bench).map_err(Failure::failed)?;
    for _ in 1..args.repeat {
        let again = run_box(&bench).map_err(Failure::failed)?;
        if again.seconds < best.seconds {
            best = again;
        }
    }
    if args.json {
        let object = serde_json::json!({
            "elements": best.elements,
            "steps": best.steps,
            "threads": best.threads,
            "problem": args.problem,
            "kind": args.kind,
            "material": args.material,
            "seconds": best.seconds,
            "element_updates_per_second": best.element_updates_per_second,
            "updates_per_element_and_step": best.share,
            "peak_bytes": machine::peak_bytes(),
        });
        print(&object.to_string());
        return Ok(Code::Done);
    }
    let rate = best.element_updates_per_second;
    let (bytes, flops) = best.cost_per_element;
    let threads = best.threads as f64;
    let (bandwidth, peak) = (machine::triad_bandwidth(best.threads), threads * machine::peak_flops());
    print(&format!("{}, {}", machine::processor(), isa.name()));
    print(&format!(
        "{} {} elements ({}), {} nodes, {} steps, {} threads: {:.3} s, {:.2} million element updates a second",
        best.elements,
        args.kind,
        args.problem,
        best.nodes,
        best.steps,
        best.threads,
        best.seconds,
        rate / 1e6
    ));
    if args.problem == "levels" {
        print(&format!(
            "{:.3} updates of an element in a step: {:.2} times the steps a second that this rate gives without levels",
            best.share,
            1.0 / best.share
        ));
    }
    print(&format!(
        "an update moves at least {bytes:.0} bytes and takes {flops:.0} operations: {:.0} % of the memory bandwidth \
         of {} threads ({:.1} GB/s, triad) and {:.0} % of their peak ({:.1} GFLOP/s)",
        100.0 * rate * bytes / bandwidth,
        best.threads,
        bandwidth / 1e9,
        100.0 * rate * flops / peak,
        peak / 1e9
    ));
    Ok(Code::Done)
}
