//! spectra.csv: every spectrum is that of the history it is named after.

use crate::depth::{ground, plan, shaken};
use std::path::Path;
use tremolite::Side;
use tremolite_motion::{default_periods, pseudo_acceleration};
use tremolite_results::{ResultFolder, Table};

/// Not a whole number of rows: the last comes early.
const SECONDS: f64 = 0.8025;
const HEIGHTS: [f64; 2] = [59.0, 31.3];

fn run(folder: &Path) -> ResultFolder {
    let mut problem = ground(20);
    // The model is not the free field; wide enough for its sides not to drain all of the wave.
    problem.sides = [Side::Viscous; 2];
    problem.mesh.nodes.iter_mut().for_each(|node| (node[0], node[1]) = (30.0 * node[0], 30.0 * node[1]));
    let mut plan = plan(&problem, &HEIGHTS, SECONDS);
    // The name of a column of the motion's: it keeps its histories, and the run its results.
    plan.monitors.push(tremolite::plan::Monitor { name: "given".into(), ..plan.monitors[0].clone() });
    shaken(problem, &plan, folder).0
}

#[test]
fn every_spectrum_is_that_of_the_history_it_is_named_after() {
    let folder = tempfile::tempdir().unwrap();
    let results = run(folder.path());
    let of = |path: std::path::PathBuf| Table::read(&path).unwrap();
    let (motion, monitors, free_field) =
        (of(results.motion()), of(results.monitors()), of(results.free_field()));
    let spectra = of(results.spectra());
    let points = [
        "given",
        "incident",
        "free_field.surface",
        "free_field.base",
        "at59",
        "at59.free_field",
        "at31.3",
        "at31.3.free_field",
        "given.free_field",
    ];
    let names = points.iter().flat_map(|point| ["x", "y", "z"].map(|axis| format!("{point}.a{axis}")));
    assert_eq!(
        spectra.columns.iter().map(|c| c.header()).collect::<Vec<_>>(),
        std::iter::once("period [s]".to_owned())
            .chain(names.map(|name| format!("{name} [m/s2]")))
            .collect::<Vec<_>>()
    );
    assert_eq!(spectra.column("period").unwrap(), default_periods());
    let mut told = Vec::new();
    for axis in ["x", "y", "z"] {
        let column = |table: &Table, name: &str| table.column(&format!("{name}{axis}")).unwrap().to_vec();
        // The last row comes 2.5 ms behind the one before it.
        let rows = |mut values: Vec<f64>| {
            assert_eq!(values.len(), 162);
            values.truncate(161);
            values
        };
        // The motion as far as the histories go.
        let end = monitors.column("time").unwrap()[161];
        let came = |mut values: Vec<f64>| {
            values.truncate(motion.column("time").unwrap().iter().filter(|t| **t <= end + 1e-9).count());
            values
        };
        let slope = |velocity: Vec<f64>| -> Vec<f64> {
            std::iter::once(0.0).chain(velocity.windows(2).map(|v| (v[1] - v[0]) / 0.005)).collect()
        };
        for (point, dt, history) in [
            ("given", 1e-3, came(column(&motion, "given.a"))),
            ("incident", 1e-3, came(column(&motion, "incident.a"))),
            ("free_field.surface", 5e-3, slope(rows(column(&free_field, "reference.top.v")))),
            ("free_field.base", 5e-3, slope(rows(column(&free_field, "reference.base.v")))),
            ("at59", 5e-3, rows(column(&monitors, "at59.a"))),
            ("at31.3", 5e-3, rows(column(&monitors, "at31.3.a"))),
            ("at59.free_field", 5e-3, slope(rows(column(&free_field, "at59.free_field.v")))),
            ("at31.3.free_field", 5e-3, slope(rows(column(&free_field, "at31.3.free_field.v")))),
        ] {
            let exact = pseudo_acceleration(&history, dt, &default_periods(), 0.05).unwrap();
            let found = column(&spectra, &format!("{point}.a"));
            // Five rows a period at least, of histories.
            let shown = |period: f64| dt < 2e-3 || period >= 5.0 * dt;
            assert!(found.iter().zip(default_periods()).all(|(s, period)| s.is_finite() == shown(period)));
            let exact: Vec<f64> =
                exact.iter().zip(&found).filter(|(_, s)| s.is_finite()).map(|(e, _)| *e).collect();
            let found: Vec<f64> = found.into_iter().filter(|s| s.is_finite()).collect();
            let most = exact.iter().copied().fold(0.0, f64::max);
            let off = found.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            // Steps differ from the rows' interval by round-off alone.
            assert!(off <= 1e-9 * most, "{point}.a{axis}: {off} of {most}");
            if axis != "z" {
                told.push(found);
            }
        }
    }
    // No two are the same, so that none could stand for another unseen.
    for (k, one) in told.iter().enumerate() {
        let most = one.iter().copied().fold(0.0, f64::max);
        assert!(most > 0.01, "{k}: {most}");
        for other in &told[..k] {
            assert!(one.iter().zip(other).any(|(a, b)| (a - b).abs() > 0.005 * most), "{k}");
        }
    }
}

#[test]
fn the_free_field_beside_a_monitor_is_the_ground_at_its_level() {
    let folder = tempfile::tempdir().unwrap();
    let problem = ground(20);
    // Two between levels; the model is its own free field.
    let plan = plan(&problem, &HEIGHTS, 0.8);
    let (results, _) = shaken(problem, &plan, folder.path());
    let spectra = Table::read(&results.spectra()).unwrap();
    for z in HEIGHTS {
        for axis in ["x", "y"] {
            let of = |name: &str| spectra.column(&format!("at{z}{name}.a{axis}")).unwrap();
            let (own, free) = (of(""), of(".free_field"));
            let most = own.iter().copied().fold(0.0, f64::max);
            let same = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-9 * most || (a.is_nan() && b.is_nan());
            assert!(most > 0.0 && own.iter().zip(free).all(same), "{z} {axis}");
            let surface = spectra.column(&format!("free_field.surface.a{axis}")).unwrap();
            assert!(
                own.iter().zip(surface).any(|(a, b)| (a - b).abs() > 1e-3 * most),
                "{z}: not the surface"
            );
        }
    }
}
