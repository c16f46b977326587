//! A small result folder with interfaces, as a run writes it.

use std::path::Path;

use tremolite_mesh::vtu::{Array, Grid, Values};
use tremolite_results::{
    Column, Conclusion, Finding, InterfaceSummary, PairPeak, PartFacts, Pvd, ResultFolder, Severity, Status,
    Summary, TableWriter,
};

/// Faces of one interface with points of their own: corners, and the way out of the first side.
pub struct Patch {
    pub interface: i32,
    pub element: i64,
    pub corners: Vec<[f64; 3]>,
    pub out: [f64; 3],
}

/// The lining of a tunnel along y, 6 m wide and 8 m high in cells of a metre, 12 m long, with an end wall.
pub fn tunnel(interface: i32, at: f64, first: i64) -> Vec<Patch> {
    let mut patches = Vec::new();
    let mut add = |corners: [[f64; 3]; 4], out: [f64; 3]| {
        let element = first + patches.len() as i64;
        let corners = corners.map(|[x, y, z]| [x + at, y, z]).to_vec();
        patches.push(Patch { interface, element, corners, out });
    };
    for j in 0..12 {
        let (y, next) = (f64::from(j), f64::from(j + 1));
        for i in 0..6 {
            let x = f64::from(i);
            for (z, up) in [(0.0, -1.0), (8.0, 1.0)] {
                let corners = [[x, y, z], [x + 1.0, y, z], [x + 1.0, next, z], [x, next, z]];
                add(corners, [0.0, 0.0, up]);
            }
        }
        for k in 0..8 {
            let z = f64::from(k);
            for (x, right) in [(0.0, -1.0), (6.0, 1.0)] {
                let corners = [[x, y, z], [x, next, z], [x, next, z + 1.0], [x, y, z + 1.0]];
                add(corners, [right, 0.0, 0.0]);
            }
        }
    }
    for i in 0..6 {
        for k in 0..8 {
            let (x, z) = (f64::from(i), f64::from(k));
            let corners = [[x, 12.0, z], [x + 1.0, 12.0, z], [x + 1.0, 12.0, z + 1.0], [x, 12.0, z + 1.0]];
            add(corners, [0.0, 1.0, 0.0]);
        }
    }
    patches
}

/// A fault that dips by 45° along x, 20 m by 14 m, of triangles.
pub fn fault(interface: i32, at: f64) -> Vec<Patch> {
    let mut patches = Vec::new();
    let place = |i: i32, j: i32| [at + f64::from(j), 2.0 * f64::from(i), -f64::from(j)];
    for i in 0..10 {
        for j in 0..10 {
            let [a, b, c, d] = [place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)];
            for corners in [vec![a, b, c], vec![a, c, d]] {
                patches.push(Patch { interface, element: 0, corners, out: [1.0, 0.0, 1.0] });
            }
        }
    }
    patches
}

/// What a pair did: slip and gap (m), and its state at the end.
pub type Deed = fn([f64; 3]) -> (f64, f64, u8);

/// Writes one file of pairs, listed at 1 s.
pub fn pairs(folder: &ResultFolder, patches: &[Patch], deed: Deed) {
    let mut grid = Grid::default();
    let mut normals = Vec::new();
    let mut deeds = Vec::new();
    for patch in patches {
        let size = patch.out.iter().map(|c| c * c).sum::<f64>().sqrt();
        for corner in &patch.corners {
            grid.connectivity.push(grid.points.len() as u32);
            grid.points.push(*corner);
            normals.extend(patch.out.map(|c| (c / size) as f32));
            deeds.push(deed(*corner));
        }
        grid.offsets.push(grid.connectivity.len() as u32);
        grid.types.push(if patch.corners.len() == 3 { 5 } else { 9 });
    }
    let scalar = |name: &str, value: fn(&(f64, f64, u8)) -> f64| {
        Array::new(name, "m", 1, Values::Float32(deeds.iter().map(|d| value(d) as f32).collect()))
    };
    let flags = |name: &str, value: fn(&(f64, f64, u8)) -> u8| {
        Array::new(name, "", 1, Values::UInt8(deeds.iter().map(value).collect()))
    };
    grid.point_data = vec![
        Array::new("normal", "", 3, Values::Float32(normals)),
        flags("state", |d| d.2),
        flags("slid", |d| u8::from(d.0 > 0.0)),
        flags("opened", |d| u8::from(d.1 > 0.0)),
        scalar("gap_max", |d| d.1),
        scalar("slip_max", |d| d.0),
    ];
    grid.cell_data = vec![
        Array::new("interface", "", 1, Values::Int32(patches.iter().map(|p| p.interface).collect())),
        Array::new("element", "", 1, Values::Int64(patches.iter().map(|p| p.element).collect())),
    ];
    grid.time = Some(1.0);
    std::fs::create_dir_all(folder.interface_fields()).unwrap();
    grid.write(&folder.interface_fields().join("000001.vtu")).unwrap();
    Pvd::create(&folder.interfaces_pvd()).unwrap().add(1.0, "interfaces/000001.vtu").unwrap();
}

/// The tables and the summary of a run with an interface `lining` that slid and opened and a fault that did nothing.
pub fn results(root: &Path) -> ResultFolder {
    let folder = ResultFolder::create(Some(root), "case", false).unwrap();
    let quantities = [
        ("gap", "m"),
        ("slip1", "m"),
        ("slip2", "m"),
        ("pressure", "Pa"),
        ("shear1", "Pa"),
        ("shear2", "Pa"),
        ("state", "1"),
    ];
    let mut columns = vec![Column::new("time", "s"), Column::new("A.ux", "m")];
    columns.extend(quantities.map(|(q, unit)| Column::new(format!("J.{q}"), unit)));
    let mut table = TableWriter::create(&folder.monitors(), &columns).unwrap();
    for step in 0..=200 {
        let t = f64::from(step) / 200.0;
        let (p, q) = (1e5 + 2e5 * (9.0 * t).sin(), 1.5e5 * (20.0 * t).sin());
        let (open, slides) = (p < 0.0, q.abs() > 0.7 * p);
        let carried = if open { [0.0, 0.0] } else { [p, if slides { 0.7 * p * q.signum() } else { q }] };
        let state = if open { 3.0 } else { f64::from(1 + u8::from(slides)) };
        table.write(&[t, 0.01 * t, -1e-9 * p, 1e-8 * q, 0.0, carried[0], carried[1], 0.0, state]).unwrap();
    }
    let lines =
        ["kinetic", "strain", "interface", "friction", "created_by_interface", "contact_damping", "error"];
    let columns: Vec<Column> =
        [Column::new("time", "s")].into_iter().chain(lines.map(|name| Column::new(name, "J"))).collect();
    let mut table = TableWriter::create(&folder.energy(), &columns).unwrap();
    for step in 0..=50 {
        let t = f64::from(step) / 50.0;
        table.write(&[t, 2e6 * t, 1e6 * t, 3e3 * t, 5e4 * t * t, 100.0 * t, 2e3 * t, -30.0 * t]).unwrap();
    }
    let areas = ["sliding", "open", "ever_slid", "ever_opened"].map(|q| (q, "m2"));
    let others = [("max_gap", "m"), ("max_slip", "m"), ("impact_gain", "J")];
    let mut columns = vec![Column::new("time", "s")];
    for name in ["lining", "fault"] {
        columns
            .extend(areas.iter().chain(&others).map(|(q, unit)| Column::new(format!("{name}.{q}"), *unit)));
    }
    let mut table = TableWriter::create(&folder.interfaces(), &columns).unwrap();
    for step in 0..=100 {
        let t = f64::from(step) / 100.0;
        let lining =
            [50.0 * t, 20.0 * (9.0 * t).sin().abs(), 100.0 * t, 40.0 * t, 1e-3 * t, 3e-3 * t, -2.0 * t];
        table.write(&[&[t], &lining[..], &[0.0, 0.0, 0.0, 0.0, 0.0, 1e-6 * t, 0.0]].concat()).unwrap();
    }
    let lining = InterfaceSummary {
        law: "bandis".into(),
        values: Vec::new(),
        pairs: 456,
        ends: 12,
        area: 400.0,
        normal_stiffness: 4.5e9,
        chosen: true,
        closure_at_1_mpa: 2.01e-4,
        straight_from: 4e6,
        ever_slid: 100.0,
        ever_opened: 40.0,
        sliding: 50.0,
        open: 10.0,
        max_gap: PairPeak { value: 1.2e-3, node: 7, at: [0.0, 4.0, 8.0] },
        max_slip: PairPeak { value: 3e-3, node: 8, at: [-1.25, 4.0, 8.0] },
        max_pressure: 5e6,
        impact_gain: -2.0,
    };
    let idle =
        InterfaceSummary { law: "coulomb".into(), pairs: 9, area: 280.0, ever_slid: 0.0, ..lining.clone() };
    let idle = InterfaceSummary { max_gap: PairPeak::default(), ..idle };
    let idle = InterfaceSummary { ever_opened: 0.0, sliding: 0.0, open: 0.0, chosen: false, ends: 0, ..idle };
    let finding = Finding {
        group: "lining".into(),
        severity: Severity::Damaged,
        headline: "the interface slid over 25.0 % of its 400 m²".into(),
        ..Finding::default()
    };
    let summary = Summary {
        title: "A tunnel that slides".into(),
        conclusion: Conclusion { status: Status::Done, findings: vec![finding], ..Conclusion::default() },
        parts: PartFacts {
            interfaces: [("lining".to_owned(), lining), ("fault".to_owned(), idle)].into_iter().collect(),
            ..PartFacts::default()
        },
        ..Summary::default()
    };
    summary.write(&folder.summary()).unwrap();
    folder
}
