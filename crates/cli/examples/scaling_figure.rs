//! Draws the figure of docs/clusters.md: `cargo run --release -p tremolite-cli --example scaling_figure`.
//!
//! [`figure`] and [`rows`] have what the page shows, and a test compares them with it.

use std::path::Path;
use tremolite::scaling::{Machines, NETWORK};
use tremolite_report::loops::{Curve, Loops, Named, Plane, Quantity};

fn main() -> std::io::Result<()> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/clusters").join(FIGURE);
    rows().iter().for_each(|row| println!("{row}"));
    std::fs::write(path, figure())
}

/// The name of its file.
pub const FIGURE: &str = "scaling.svg";

/// Machines of 64 cores; docs/clusters.md says where each number is from.
const LIKE: Machines =
    Machines { rate: 1.8e8, share: 0.26, surface: 200.0, neighbours: 12, network: NETWORK, first: 0.05 };

/// Elements of the models, and of each machine where these grow with their number.
const MODELS: [(f64, &str); 3] = [(1e5, "10⁵"), (1e7, "10⁷"), (1e9, "10⁹")];
const EACH: [(f64, &str); 2] = [(1e5, "10⁵ each"), (1e6, "10⁶ each")];
/// From this colour on those of the first lines come again, dashed.
const DASHED: usize = 7;
/// The number of machines is two to this power at most.
const MOST: u32 = 12;

/// The rows of the page's table: shares of the machines' time that are used, without and with what the first rank does for rows.
pub fn rows() -> Vec<String> {
    let row = |name: &str, of: &dyn Fn(u32, bool) -> f64| {
        let cell = |machines: u32| {
            [false, true].map(|rows| format!("{:.0}", 100.0 * of(machines, rows))).join(" / ")
        };
        let cells: Vec<String> = [4, 16, 64, 256, 1024].map(cell).into();
        format!("| {name} | {} |", cells.join(" | "))
    };
    let strong = MODELS.map(|(elements, name)| row(name, &|n, rows| LIKE.strong(elements, n, rows)));
    let weak = EACH.map(|(each, name)| row(name, &|n, rows| LIKE.weak(each, n, rows)));
    strong.into_iter().chain(weak).collect()
}

/// Over the number of machines: models of one size, and of one size a machine; dashed with the first rank's rows.
pub fn figure() -> String {
    let across: Vec<f64> = (0..=MOST).map(f64::from).collect();
    let curve = |name: String, colour: usize, of: &dyn Fn(u32) -> f64| Curve {
        name,
        colour,
        across: across.clone().into(),
        up: across.iter().map(|power| 100.0 * of(1 << *power as u32)).collect::<Vec<_>>().into(),
        points: false,
    };
    let plane = |name: &'static str, curves: Vec<Curve<'static>>| Plane {
        across: Quantity::new("number of machines, as a power of two", ""),
        up: Quantity::new(name, "%"),
        curves,
        named: Named::Nothing,
    };
    let both = |k: usize, name: &str, of: &dyn Fn(u32, bool) -> f64| {
        [(false, 0, ""), (true, DASHED, ", rows")]
            .map(|(rows, dashed, word)| curve(format!("{name}{word}"), k + dashed, &|n| of(n, rows)))
    };
    let strong = MODELS.iter().enumerate();
    let strong = strong.flat_map(|(k, (n, name))| both(k, name, &|m, rows| LIKE.strong(*n, m, rows)));
    let weak = EACH.iter().enumerate();
    let weak = weak.flat_map(|(k, (n, name))| both(k + 3, name, &|m, rows| LIKE.weak(*n, m, rows)));
    Loops {
        title: "A model, not a measurement: share of the machines' time that is used".into(),
        along: Quantity::new("", ""),
        time: &[],
        planes: vec![plane("one model", strong.collect()), plane("one size a machine", weak.collect())],
        tracks: vec![],
        states: None,
    }
    .draw()
}
