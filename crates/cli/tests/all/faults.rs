//! A fault through a lined hall: both walls slide where it cuts the shotcrete, and are held where that stays whole.

use crate::stage_case::{code, errors, run};
use serde_json::Value;
use std::path::Path;

/// A hall of 8 × 8 m with shotcrete on the rock, a lining behind a joint, and a fault that dips by 20 degrees through both walls.
const GENERATED: &str = r#"[mesh.caverns]
overburden = "20 m"
below = "12 m"
sides = "16 m"
length = "4 m"
near = "1.5 m"
far = "4 m"
along = "2 m"
[[mesh.caverns.cavern]]
name = "hall"
width = "8 m"
height = "8 m"
arch_rise = "2 m"
lining = { walls = "0.4 m", crown = "0.4 m" }
shotcrete = "0.2 m"
[[mesh.plane]]
name = "fault"
through = [0, 0, "-25 m"]
dip = "20 deg"
dip_direction = "90 deg"
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
[material.concrete]
law = "elastic"
young = "30 GPa"
poisson = 0.2
density = "2500 kg/m3"
[[region]]
groups = ["rock", "hall.bench*"]
material = "rock"
element = "one-point"
[[region]]
groups = ["hall.shotcrete"]
material = "shotcrete"
element = "layered"
before = "rock"
[[region]]
groups = ["hall.lining"]
material = "concrete"
element = "layered"
before = "rock"
[[interface]]
name = "joint"
between = [["hall.lining"], ["hall.shotcrete", "rock"]]
law = "coulomb"
friction = 0.6
[[interface]]
name = "fault"
between = ["fault.below", "fault.above"]
law = "coulomb"
friction = 0.22
[initial]
lateral = 0.5
[[stage]]
name = "dig"
excavate = ["hall.bench*", "hall.lining", "hall.shotcrete"]
install = ["hall.shotcrete"]
[[stage]]
name = "line"
install = ["hall.lining"]
[[monitor]]
name = "left"
at = ["-4.6 m", "2 m", "-23.326 m"]
interface = "fault"
[[monitor]]
name = "right"
at = ["4.6 m", "2 m", "-26.674 m"]
interface = "fault"
"#
    )
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
    let output = run(folder, out, &["--allow"]);
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

#[test]
fn a_fault_slides_at_both_walls_where_it_cuts_the_shotcrete() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let cut = slid(at, &case(GENERATED), "cut");
    let tied = slid(at, &case(&format!("{GENERATED}across = \"whole\"\n")), "tied");
    for (name, run) in [("cut", &cut), ("tied", &tied)] {
        let mm = run.walls.map(|slip| 1e3 * slip);
        println!("{name}: {} ends, {:.2} m2 slid, {mm:?} mm at the walls", run.ends, run.area);
    }
    assert!(cut.ends < tied.ends, "{} {}", cut.ends, tied.ends);
    assert!(cut.area > 1.0 && cut.area > tied.area, "{} {}", cut.area, tied.area);
    for k in 0..2 {
        assert!(cut.walls[k] > 10.0 * tied.walls[k], "{:?} {:?}", cut.walls, tied.walls);
    }
    // Nodes that stay tied are told.
    assert!(tied.text.contains("it cannot slide"), "{}", tied.text);
}
