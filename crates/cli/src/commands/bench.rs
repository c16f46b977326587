//! `tremolite bench`: the engine's speed on a box.

use crate::exit::{Code, Failure, Outcome};
use crate::machine;
use crate::terminal::print;
use std::sync::Arc;
use tremolite::bench::{BoxBench, run as run_box};
use tremolite::{Layers, Quadrature, laws};
use tremolite_laws::Values;

#[derive(clap::Args)]
pub struct Args {
    /// What to time
    #[arg(value_parser = ["box"], default_value = "box")]
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
    /// A material law, with E 10 GPa, ν 0.25 and the law's defaults
    #[arg(long, default_value = "elastic")]
    material: String,
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
    let values = Values::default().with("young", 10e9).with("poisson", 0.25);
    let material = (law.build)(&values).map_err(|bad| {
        let words: Vec<String> = bad.iter().map(ToString::to_string).collect();
        Failure::input(format!("'{}' needs more than E and ν: {}", args.material, words.join("; ")))
    })?;
    let bench = BoxBench {
        elements: args.elements,
        steps: args.steps,
        threads: args.threads,
        quadrature,
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
            "kind": args.kind,
            "seconds": best.seconds,
            "element_updates_per_second": best.element_updates_per_second,
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
        "{} {} elements, {} nodes, {} steps, {} threads: {:.3} s, {:.2} million element updates a second",
        best.elements,
        args.kind,
        best.nodes,
        best.steps,
        best.threads,
        best.seconds,
        rate / 1e6
    ));
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
