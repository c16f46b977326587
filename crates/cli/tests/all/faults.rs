//! A fault through a hall: both walls slide where it cuts the shotcrete, as in a mesh split by hand, and are held where that stays whole.

use crate::stage_case::{code, errors, run, tremolite};
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;

/// A hall of 8 × 8 m with shotcrete on the rock, and a fault that dips by 20 degrees through both walls.
const GENERATED: &str = r#"[mesh.caverns]
overburden = "20 m"
below = "12 m"
sides = "16 m"
length = "4 m"
size_near = "1.5 m"
size_far = "4 m"
size_along = "2 m"
[[mesh.caverns.cavern]]
name = "hall"
width = "8 m"
height = "8 m"
arch_rise = "2 m"
shotcrete = "0.2 m"
[[mesh.plane]]
name = "fault"
through = [0, 0, "-25 m"]
dip = "20 deg"
dip_azimuth = "90 deg"
"#;

fn case(mesh: &str) -> String {
    format!(
        r#"title = "fault at a wall"
{mesh}
[material.rock]
law = "elastic"
young = "5 GPa"
poisson = 0.25
density = "2700 kg/m3"
[material.shotcrete]
law = "elastic"
young = "15 GPa"
poisson = 0.2
density = "2400 kg/m3"
[[region]]
groups = ["rock", "hall.bench*"]
material = "rock"
element = "reduced-integration"
[[region]]
groups = ["hall.shotcrete"]
material = "shotcrete"
element = "layered"
before = "rock"
[[interface]]
name = "fault"
between = ["fault.below", "fault.above"]
law = "coulomb"
friction_coefficient = 0.22
[initial]
lateral = 0.5
[[stage]]
name = "dig"
excavate = ["hall.bench*", "hall.shotcrete"]
install = ["hall.shotcrete"]
[[monitor]]
name = "left"
at = ["-4.2 m", "2 m", "-23.471 m"]
interface = "fault"
[[monitor]]
name = "right"
at = ["4.2 m", "2 m", "-26.529 m"]
interface = "fault"
"#
    )
}

/// The case with a concrete lining behind a joint, which the fault does not cut.
fn lined(mesh: &str) -> String {
    let text = case(&mesh.replace(
        "shotcrete = \"0.2 m\"",
        "lining = { walls = \"0.4 m\", crown = \"0.4 m\" }\nshotcrete = \"0.2 m\"",
    ));
    let text = text.replace(
        "[initial]",
        r#"[material.concrete]
law = "elastic"
young = "30 GPa"
poisson = 0.2
density = "2500 kg/m3"
[[region]]
groups = ["hall.lining"]
material = "concrete"
element = "layered"
before = "rock"
[[interface]]
name = "joint"
between = [["hall.lining"], ["hall.shotcrete", "rock"]]
law = "coulomb"
friction_coefficient = 0.6
[initial]"#,
    );
    let text = text.replace("excavate = [", "excavate = [\"hall.lining\", ");
    let line = "[[stage]]\nname = \"line\"\ninstall = [\"hall.lining\"]\n[[monitor]]\nname = \"left\"";
    text.replace("[[monitor]]\nname = \"left\"", line)
        .replace("4.2 m", "4.6 m")
        .replace("23.471", "23.326")
        .replace("26.529", "26.674")
}

/// What the fault did: nodes where it cannot slide, area that slid \[m²\], slip at both walls \[m\].
struct Slid {
    ends: u64,
    area: f64,
    walls: [f64; 2],
    text: String,
}

fn slid(folder: &Path, text: &str, out: &str) -> Slid {
    std::fs::write(folder.join("case.toml"), text).unwrap();
    let output = run(folder, out, &["--ignore-resources"]);
    assert_eq!(code(&output), 0, "{}", errors(&output));
    let text = std::fs::read_to_string(folder.join(out).join("summary.json")).unwrap();
    let summary: Value = serde_json::from_str(&text).unwrap();
    let fault = &summary["interfaces"]["fault"];
    let stages = std::fs::read_to_string(folder.join(out).join("stages.csv")).unwrap();
    let wall = |name: &str| {
        let last = |column: &str| -> f64 {
            let heads = stages.lines().next().unwrap().split(',');
            let at = heads.into_iter().position(|head| head == format!("{name}.{column} [m]")).unwrap();
            stages.lines().last().unwrap().split(',').nth(at).unwrap().parse().unwrap()
        };
        last("slip1").hypot(last("slip2"))
    };
    let found = summary["findings"].as_array().unwrap();
    let finding = found.iter().find(|finding| finding["id"] == "interface_fault").unwrap();
    Slid {
        ends: fault["ends"].as_u64().unwrap(),
        area: fault["ever_slid"].as_f64().unwrap(),
        walls: ["left", "right"].map(wall),
        text: finding.to_string(),
    }
}

/// The case's mesh as a file, with a copy of each node of both sides of the fault for the elements above it.
fn split_by_hand(folder: &Path) {
    let made = tremolite(folder, &["mesh", "convert", "case.toml", "hall.vtu"]);
    assert_eq!(code(&made), 0, "{}", errors(&made));
    let mut mesh = tremolite_mesh::read(folder.join("hall.vtu")).unwrap();
    let [above, below] = ["fault.above", "fault.below"].map(|group| mesh.groups[group].clone());
    let nodes_of = |list: &[u32]| -> BTreeSet<u32> {
        list.iter().flat_map(|&e| mesh.elements[e as usize].nodes().to_vec()).collect()
    };
    let both: Vec<u32> = nodes_of(&above).intersection(&nodes_of(&below)).copied().collect();
    let first = mesh.nodes.len() as u32;
    mesh.nodes.extend(both.iter().map(|&n| mesh.nodes[n as usize]).collect::<Vec<_>>());
    for &e in &above {
        for node in &mut mesh.elements[e as usize].nodes {
            if let Ok(k) = both.binary_search(node) {
                *node = first + k as u32;
            }
        }
    }
    mesh.node_ids.clear();
    tremolite_mesh::write(folder.join("split.vtu"), &mesh).unwrap();
}

#[test]
fn a_fault_slides_at_both_walls_as_in_a_mesh_split_by_hand() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let cut = slid(at, &case(GENERATED), "cut");
    split_by_hand(at);
    let split = slid(at, &case("[mesh.file]\npath = \"split.vtu\"\n"), "split");
    let tied = slid(at, &case(&format!("{GENERATED}across = \"whole\"\n")), "tied");
    let behind = slid(at, &lined(GENERATED), "lined");
    for (name, run) in [("cut", &cut), ("split", &split), ("tied", &tied), ("lined", &behind)] {
        let mm = run.walls.map(|slip| 1e3 * slip);
        println!("{name}: {} ends, {:.2} m2 slid, {mm:?} mm at the walls", run.ends, run.area);
    }
    assert_eq!((cut.ends, split.ends, behind.ends), (0, 0, 0));
    // At rest to 10⁻⁵ of all contributions.
    assert!((cut.area / split.area - 1.0).abs() < 1e-3, "{} {}", cut.area, split.area);
    for k in 0..2 {
        assert!((cut.walls[k] / split.walls[k] - 1.0).abs() < 1e-3, "{:?} {:?}", cut.walls, split.walls);
        // Whole shotcrete holds the walls, and the result says so.
        assert!(cut.walls[k] > 10.0 * tied.walls[k], "{:?} {:?}", cut.walls, tied.walls);
        // A lining that comes later, behind a joint, does not hold the walls; its opening is 0.8 m wider.
        assert!(behind.walls[k] > cut.walls[k], "{:?} {:?}", behind.walls, cut.walls);
    }
    assert!(tied.ends > 0 && tied.text.contains("it cannot slide"), "{} {}", tied.ends, tied.text);
    assert!(!cut.text.contains("cannot slide"), "{}", cut.text);
}
