//! A small result folder with field files of every shape: two bodies about an opening, an element that is missing at one
//! time, cells in another order at another.

use std::path::Path;

use tremolite_mesh::vtu::{Array, Grid, Values};
use tremolite_mesh::{Element, Mesh, Shape};
use tremolite_results::{Cracks, GroupDamage, Pvd, ResultFolder, StageSummary, Summary};

pub const TIMES: [f64; 3] = [0.0, 0.5, 1.25];
/// Name of the interface.
pub const INTERFACE: &str = "joint";

/// Where a node of the grid of units stands (m).
pub fn place([x, y, z]: [f64; 3]) -> [f64; 3] {
    [1.3 * x - 2.0, 0.7 * y + 5.0, 2.1 * z - 100.0]
}

/// 4 × 2 × 4 cells. Of the four in the middle one is lining (body 1), three are open; those at the upper left are two wedges
/// each; a pyramid stands on top, and a tetrahedron on that. With the body of each element, and its cell.
fn mesh() -> (Mesh, Vec<i32>) {
    let mut mesh = Mesh::default();
    let mut bodies = Vec::new();
    let mut places: Vec<[f64; 3]> = Vec::new();
    let mut add = |shape: Shape, body: i32, corners: &[[f64; 3]]| {
        let node = |corner: &[f64; 3]| {
            places.iter().position(|known| known == corner).unwrap_or_else(|| {
                places.push(*corner);
                places.len() - 1
            }) as u32
        };
        let nodes: Vec<u32> = corners.iter().map(node).collect();
        mesh.elements.push(Element::new(shape, &nodes));
        bodies.push(body);
    };
    for (j, (i, k)) in (0..2).flat_map(|j| (0..16).map(move |c| (j, (c % 4, c / 4)))) {
        let at = |a: i32, b: i32, c: i32| [f64::from(i + a), f64::from(j + b), f64::from(k + c)];
        match (i, k) {
            (2, 1) | (1 | 2, 2) => {}
            (0, 3) => {
                let one = [at(0, 0, 0), at(0, 0, 1), at(1, 0, 0), at(0, 1, 0), at(0, 1, 1), at(1, 1, 0)];
                let two = [at(1, 0, 1), at(1, 0, 0), at(0, 0, 1), at(1, 1, 1), at(1, 1, 0), at(0, 1, 1)];
                add(Shape::Wedge6, 0, &one);
                add(Shape::Wedge6, 0, &two);
            }
            _ => {
                let base = [at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)];
                let top = [at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)];
                add(Shape::Hex8, i32::from((i, k) == (1, 1)), &[base, top].concat());
            }
        }
    }
    let (a, b, apex) = ([4.0, 0.0, 4.0], [4.0, 1.0, 4.0], [3.5, 0.5, 5.0]);
    add(Shape::Pyramid5, 0, &[[3.0, 0.0, 4.0], a, b, [3.0, 1.0, 4.0], apex]);
    add(Shape::Tet4, 0, &[a, b, apex, [5.0, 0.5, 5.0]]);
    mesh.nodes = places.into_iter().map(place).collect();
    (mesh, bodies)
}

/// The file of time number `time`: at time 1 an element is not there, at time 2 the cells come the other way round.
fn grid(time: usize) -> Grid {
    let (mesh, bodies) = mesh();
    let mut cells: Vec<u32> = (0..bodies.len() as u32).filter(|&cell| time != 1 || cell != 8).collect();
    if time == 2 {
        cells.reverse();
    }
    let (mut grid, nodes) = Grid::from_mesh(&mesh, Some(&cells));
    grid.time = Some(TIMES[time]);
    let t = time as f64;
    let scalar = |name: &str, unit: &str, value: &dyn Fn(f64, bool) -> f64| {
        let of = |&cell: &u32| value(f64::from(cell), bodies[cell as usize] == 1) as f32;
        Array::new(name, unit, 1, Values::Float32(cells.iter().map(of).collect()))
    };
    let group = |name: &str, inside: &dyn Fn(usize) -> bool| {
        let inside = cells.iter().map(|&cell| u8::from(inside(cell as usize))).collect();
        Array::new(format!("group:{name}"), "", 1, Values::UInt8(inside))
    };
    grid.cell_data = vec![
        Array::new("element", "", 1, Values::Int64(cells.iter().map(|&c| 7 * i64::from(c) + 3).collect())),
        Array::new("body", "", 1, Values::Int32(cells.iter().map(|&c| bodies[c as usize]).collect())),
        group("all", &|_| true),
        group("rock", &|cell| bodies[cell] == 0),
        group("hall.lining", &|cell| bodies[cell] == 1),
        group("<script>", &|cell| bodies[cell] == 0 && cell % 3 == 0),
        group("</script>", &|cell| bodies[cell] == 0 && cell < 4),
        Array::new("stress", "Pa", 6, Values::Float32(vec![1.0; 6 * cells.len()])),
        // A damaged element may have no stress.
        scalar("s1", "Pa", &|cell, _| if cell == 9.0 { f64::NAN } else { 1e6 * (cell + 3.0 * t).sin() }),
        scalar("d_tension", "", &|cell, lining| if lining { 0.5 * (1.0 + (cell + t).cos()) } else { 0.0 }),
        scalar("even", "", &|_, _| 5.0),
        scalar("law's own", "", &|cell, _| cell),
    ];
    let node = |name: &str, unit: &str, components: usize, value: &dyn Fn(f64, usize) -> f64| {
        let values = nodes.iter().flat_map(|&n| (0..components).map(move |i| value(f64::from(n), i) as f32));
        Array::new(name, unit, components, Values::Float32(values.collect()))
    };
    // Much of it is common to all.
    let displacement = |n: f64, i: usize| 0.3 * t + 1e-3 * (n + t + i as f64).sin();
    grid.point_data = vec![
        node("displacement", "m", 3, &displacement),
        node("velocity", "m/s", 3, &|n, _| n),
        node("displacement_max", "m", 1, &|n, _| t * n.cos().abs()),
    ];
    grid
}

/// The folder; its summary knows that the lining can crack.
pub fn results(root: &Path) -> ResultFolder {
    let folder = ResultFolder::create(Some(root), "case", false).unwrap();
    let mut pvd = Pvd::create(&folder.pvd()).unwrap();
    for (k, t) in TIMES.iter().enumerate() {
        grid(k).write(&folder.fields().join(format!("{k}.vtu"))).unwrap();
        pvd.add(*t, &format!("fields/{k}.vtu")).unwrap();
    }
    let mut summary = Summary::default();
    let lining = GroupDamage { cracks: Some(Cracks::default()), ..GroupDamage::default() };
    summary.parts.damage.insert("hall.lining".into(), lining);
    summary.write(&folder.summary()).unwrap();
    folder
}

/// Adds an interface under the lining, of a quadrilateral and two triangles, with a file at the last two times.
pub fn interface(folder: &ResultFolder) {
    let (mesh, bodies) = mesh();
    let lining: Vec<usize> = (0..bodies.len()).filter(|&cell| bodies[cell] == 1).collect();
    let corners = |cell: usize| [0, 1, 2, 3].map(|k| mesh.nodes[mesh.elements[cell].nodes()[k] as usize]);
    let points = [corners(lining[0]), corners(lining[1])].concat();
    let numbers = [0, 1, 1].map(|k| 7 * lining[k] as i64 + 3).to_vec();
    let mut pvd = Pvd::create(&folder.interfaces_pvd()).unwrap();
    std::fs::create_dir_all(folder.interface_fields()).unwrap();
    for (time, t) in TIMES.iter().enumerate().skip(1) {
        let slip = (0..8).map(|k| 1e-4 * (k * time) as f32).collect();
        let grid = Grid {
            points: points.clone(),
            connectivity: vec![0, 1, 2, 3, 4, 5, 6, 4, 6, 7],
            offsets: vec![4, 7, 10],
            types: vec![9, 5, 5],
            point_data: vec![
                Array::new("normal", "", 3, Values::Float32(vec![0.0; 24])),
                Array::new("slip_max", "m", 1, Values::Float32(slip)),
                Array::new("state", "", 1, Values::UInt8(vec![0, 1, 2, 3, 0, 0, 1, 1])),
            ],
            cell_data: vec![
                Array::new("interface", "", 1, Values::Int32(vec![0; 3])),
                Array::new("element", "", 1, Values::Int64(numbers.clone())),
                Array::new("other_element", "", 1, Values::Int64(vec![3; 3])),
                Array::new(format!("interface:{INTERFACE}"), "", 1, Values::UInt8(vec![1; 3])),
            ],
            time: Some(*t),
            ..Grid::default()
        };
        grid.write(&folder.interface_fields().join(format!("{time}.vtu"))).unwrap();
        pvd.add(*t, &format!("interfaces/{time}.vtu")).unwrap();
    }
}

/// Makes stages of the times, of which the summary names two.
pub fn as_stages(folder: &ResultFolder) {
    std::fs::remove_file(folder.pvd()).unwrap();
    let mut pvd = Pvd::create(&folder.stages_pvd()).unwrap();
    (0..TIMES.len()).for_each(|k| pvd.add(k as f64, &format!("fields/{k}.vtu")).unwrap());
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.computed.stages = ["initial", "bench & <b>", ""]
        .map(|name| StageSummary { name: name.into(), ..StageSummary::default() })
        .to_vec();
    summary.write(&folder.summary()).unwrap();
}
