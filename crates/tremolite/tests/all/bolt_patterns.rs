//! Where bolts of a case come to lie: patterns on what stages lay bare, points and files.

use std::path::Path;
use tremolite::setup::{Laws, Setup, setup};
use tremolite::{Bolts, Model, Problem, Stage, laws};
use tremolite_case::{Case, Report};
use tremolite_laws::{Isa, LawInfo};
use tremolite_mesh::boxes::{BoxSpec, Distortion};
use tremolite_mesh::locate::Locator;
use tremolite_mesh::{Mesh, write};

type Ends = [[f64; 3]; 2];

const X: [f64; 2] = [-6.0, 6.0];
const HEAD: &str = "title = \"bolts\"\nunits = \"SI\"\n[material.rock]\nlaw = \"elastic\"\nyoung = \"10 GPa\"\npoisson = 0.25\n\
    density = 2700\n[initial]\nlateral = 1\n";

/// A block with a cavern of three benches of 4 m each, 12 m wide under a flat roof at z = 0, in elements of 2 m; along y it has
/// these ends.
fn block(y: [f64; 2], distortion: Option<Distortion>) -> Mesh {
    let spec = BoxSpec::uniform([-20.0, 0.0, -24.0], [20.0, 30.0, 12.0], [20, 15, 18]);
    let plain = spec.mesh().unwrap();
    let mut mesh = BoxSpec { distortion, ..spec }.mesh().unwrap();
    for (e, element) in plain.elements.iter().enumerate() {
        let mut at = [0.0; 3];
        element.nodes().iter().for_each(|&n| (0..3).for_each(|i| at[i] += plain.nodes[n as usize][i] / 8.0));
        let inside =
            X[0] < at[0] && at[0] < X[1] && y[0] < at[1] && at[1] < y[1] && -12.0 < at[2] && at[2] < 0.0;
        let group =
            if inside { format!("hall.bench{}", 1 + (-at[2] / 4.0) as u32) } else { "rock".to_owned() };
        mesh.groups.entry(group).or_default().push(e as u32);
    }
    mesh
}

/// The block seen in a mirror across an axis.
fn mirrored(mesh: &Mesh, axis: usize) -> Mesh {
    let order = [[1, 0, 3, 2, 5, 4, 7, 6], [3, 2, 1, 0, 7, 6, 5, 4], [4, 5, 6, 7, 0, 1, 2, 3]][axis];
    let mut mesh = mesh.clone();
    mesh.nodes.iter_mut().for_each(|x| x[axis] = -x[axis]);
    mesh.elements.iter_mut().for_each(|e| e.nodes = order.map(|k| e.nodes[k]));
    mesh
}

const BENCHES: [&str; 3] = ["hall.bench1", "hall.bench2", "hall.bench3"];

/// Stages that take out these groups, one after the other, each with these bolts.
fn stages(groups: &[&str], bolts: &str) -> String {
    let stage = |group: &&str| format!("[[stage]]\nname = \"{group}\"\nexcavate = [\"{group}\"]\n{bolts}\n");
    groups.iter().map(stage).collect()
}

const REGION: &str = "[[region]]\ngroups = [\"*\"]\nmaterial = \"rock\"\nelement = \"reduced-integration\"\n";

fn parse(folder: &Path, text: &str) -> Case {
    let infos: Vec<LawInfo> = laws().iter().map(|l| l.info).collect();
    Case::parse(&folder.join("case.toml"), text, &infos).unwrap_or_else(|e| panic!("{e}"))
}

/// What becomes of a case with this mesh and these stages.
fn of_mesh(mesh: &Mesh, stages: &str, files: &[(&str, &str)]) -> Result<(Case, Setup), Report> {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path().join("block.vtu"), mesh).unwrap();
    files.iter().for_each(|(name, text)| std::fs::write(folder.path().join(name), text).unwrap());
    let case = parse(folder.path(), &format!("{HEAD}[mesh.file]\npath = \"block.vtu\"\n{REGION}{stages}"));
    let made = setup(&case, &Laws::default(), Isa::best())?;
    Ok((case, made))
}

/// The bolts of the block with these stages.
fn placed(mesh: &Mesh, stages: &str) -> (Vec<Bolts>, String) {
    let (case, made) = of_mesh(mesh, stages, &[]).unwrap_or_else(|e| panic!("{e}"));
    (made.problem.bolts, case.report(made.warnings).to_string())
}

fn ends(bolts: &Bolts) -> Vec<Ends> {
    bolts.bars.iter().map(|bar| [bar.points[0], bar.points[1]]).collect()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

fn direction([head, tail]: Ends) -> [f64; 3] {
    [0, 1, 2].map(|i| (tail[i] - head[i]) / distance(head, tail))
}

fn near(a: [f64; 3], b: [f64; 3]) -> bool {
    // Heads lie a billionth of the spacing in the rock.
    distance(a, b) < 1e-8
}

fn nearest_pair(heads: &[[f64; 3]]) -> f64 {
    let pairs = heads.iter().enumerate().flat_map(|(i, a)| heads[i + 1..].iter().map(|b| distance(*a, *b)));
    pairs.fold(f64::INFINITY, f64::min)
}

fn pattern(word: &str, spacing: &str) -> String {
    format!("bolts = {{ pattern = \"{word}\", spacing = {spacing}, length = 6, diameter = \"25 mm\" }}")
}

#[test]
fn a_systematic_pattern_places_area_over_spacings_in_every_bench_at_its_places() {
    let mesh = block([0.0, 30.0], None);
    let (bolts, warnings) = placed(&mesh, &stages(&BENCHES, &pattern("systematic", "[1.5, 1.25]")));
    // 30 m of roof 12 m and walls 2 · 4 m; then of walls. 4 m hold 3.2 spacings, that is 3 bolts a wall and row.
    assert_eq!(bolts.iter().map(|b| b.bars.len()).collect::<Vec<_>>(), [20 * 16, 20 * 6, 20 * 6]);
    assert_eq!(20 * 16, (30.0 * 20.0 / (1.5 * 1.25)) as usize, "the area over the spacings");
    assert_eq!(bolts.iter().map(|b| b.born).collect::<Vec<_>>(), [1, 2, 3].map(Stage::Before));
    assert!(!warnings.contains("bolts"), "{warnings}");
    let second = ends(&bolts[1]);
    for side in [-1.0, 1.0] {
        for row in 0..20 {
            for k in [-1.0, 0.0, 1.0] {
                let head = [6.0 * side, 0.75 + 1.5 * f64::from(row), -6.0 + 1.25 * k];
                let found = second.iter().find(|ends| near(ends[0], head));
                let found = found.unwrap_or_else(|| panic!("no head at {head:?}"));
                assert!(near(found[1], [12.0 * side, head[1], head[2]]), "{found:?}");
            }
        }
    }
    // Up the left wall, along the roof and down the right one in one line: 0.625 m from the bench's floor, 1.25 m on.
    let first = ends(&bolts[0]);
    let row: Vec<&Ends> = first.iter().filter(|ends| (ends[0][1] - 0.75).abs() < 1e-6).collect();
    for k in 0..16 {
        let arc = 0.625 + 1.25 * f64::from(k);
        let head = match arc {
            s if s < 4.0 => [-6.0, 0.75, -4.0 + s],
            s if s < 16.0 => [-10.0 + s, 0.75, 0.0],
            s => [6.0, 0.75, 16.0 - s],
        };
        assert!(row.iter().any(|ends| near(ends[0], head)), "no head at {head:?}");
    }
}

#[test]
fn bolts_that_follow_in_a_later_stage_lie_on_what_the_last_excavation_laid_bare() {
    let mesh = block([0.0, 30.0], None);
    let bolts = pattern("systematic", "[1.5, 1.25]");
    let (at_once, _) = placed(&mesh, &stages(&BENCHES[..2], &bolts));
    let later: String = BENCHES[..2]
        .iter()
        .map(|bench| {
            let excavated =
                format!("[[stage]]\nname = \"{bench}\"\nexcavate = [\"{bench}\"]\nrelease = 0.7\n");
            format!("{excavated}[[stage]]\nname = \"bolts of {bench}\"\n{bolts}\n")
        })
        .collect();
    let (later, warnings) = placed(&mesh, &later);
    assert_eq!(later.iter().map(|b| b.born).collect::<Vec<_>>(), [2, 4].map(Stage::Before));
    for (later, at_once) in later.iter().zip(&at_once) {
        assert_eq!(ends(later), ends(at_once));
    }
    assert!(!warnings.contains("bolts are placed"), "{warnings}");
}

#[test]
fn crown_and_walls_share_the_faces_of_a_systematic_pattern_and_floors_have_none() {
    let mesh = block([0.0, 30.0], None);
    let count = |word: &str| {
        let (bolts, _) = placed(&mesh, &stages(&BENCHES, &pattern(word, "1.5")));
        (bolts.iter().map(|b| b.bars.len()).collect::<Vec<_>>(), bolts)
    };
    let (counts, crown) = count("crown");
    assert_eq!(counts, [20 * 8, 0, 0]);
    assert!(ends(&crown[0]).iter().all(|&e| near(direction(e), [0.0, 0.0, 1.0]) && e[0][2].abs() < 1e-8));
    let (counts, walls) = count("walls");
    assert_eq!(counts, [20 * 6; 3], "4 m hold 2.67 spacings, that is 3 bolts");
    for ends in walls.iter().flat_map(ends) {
        assert!(near(direction(ends), [ends[0][0].signum(), 0.0, 0.0]), "{ends:?}");
    }
}

#[test]
fn end_walls_have_a_grid_of_their_own() {
    let mesh = block([6.0, 24.0], None);
    let (bolts, _) = placed(&mesh, &stages(&BENCHES, &pattern("systematic", "[1.5, 1.25]")));
    let heads = ends(&bolts[1]);
    let (end, side): (Vec<&Ends>, Vec<&Ends>) =
        heads.iter().partition(|&&ends| direction(ends)[1].abs() > 0.5);
    assert_eq!((end.len(), side.len()), (2 * 8 * 3, 12 * 2 * 3));
    for [head, tail] in end {
        let y = if head[1] < 15.0 { [6.0, 0.0] } else { [24.0, 30.0] };
        assert!((head[1] - y[0]).abs() < 1e-8 && (tail[1] - y[1]).abs() < 1e-8, "{head:?} {tail:?}");
        let steps = [(head[0] + 5.25) / 1.5, (head[2] + 7.25) / 1.25];
        assert!(steps.iter().all(|s| (s - s.round()).abs() < 1e-8), "{head:?}");
    }
    // In the first bench the roof is no end.
    let roof = ends(&bolts[0]).iter().filter(|&&e| direction(e)[2] > 0.5).count();
    assert_eq!(roof, 12 * 10, "of 16 in a row 10 are in the roof");
}

#[test]
fn no_two_heads_are_nearer_than_half_the_spacing_over_all_stages() {
    for (y, spacing) in [([0.0, 30.0], 1.6), ([6.0, 24.0], 1.6), ([6.0, 24.0], 1.7), ([6.0, 24.0], 2.9)] {
        let mesh = block(y, None);
        let (bolts, _) = placed(&mesh, &stages(&BENCHES, &pattern("systematic", &spacing.to_string())));
        let heads: Vec<[f64; 3]> = bolts.iter().flat_map(ends).map(|ends| ends[0]).collect();
        let nearest = nearest_pair(&heads);
        assert!(nearest > 0.5 * spacing - 1e-8, "{y:?} {spacing}: {nearest}");
    }
    // A heading that advances by less than half the spacing: every step has a row in its middle, and only those far enough from
    // earlier ones stay.
    let mut mesh = block([0.0, 30.0], None);
    let plain = BoxSpec::uniform([-20.0, 0.0, -24.0], [20.0, 30.0, 12.0], [20, 15, 18]).mesh().unwrap();
    let top = mesh.groups.remove("hall.bench1").unwrap();
    for &e in &top {
        let y = plain.nodes[plain.elements[e as usize].nodes[0] as usize][1];
        mesh.groups.entry(format!("step{:02}", (y / 2.0) as u32)).or_default().push(e);
    }
    let steps: Vec<String> = (0..15).map(|k| format!("step{k:02}")).collect();
    let steps: Vec<&str> = steps.iter().map(String::as_str).collect();
    let (bolts, _) = placed(&mesh, &stages(&steps, &pattern("crown", "[4.5, 3]")));
    let rows: Vec<usize> = bolts.iter().map(|b| b.bars.len()).collect();
    // Half of the smaller spacing is 1.5 m, and steps are 2 m long. The face of the heading, which is larger than the walls of a
    // step, makes no other direction the axis.
    assert_eq!(rows, [4; 15]);
    let (bolts, _) = placed(&mesh, &stages(&steps, &pattern("crown", "[4.5, 4.5]")));
    let rows: Vec<usize> = bolts.iter().map(|b| b.bars.len()).collect();
    assert_eq!(rows[..4], [3, 0, 3, 0], "rows 2 m apart would be nearer than 2.25 m");
    let heads: Vec<[f64; 3]> = bolts.iter().flat_map(ends).map(|ends| ends[0]).collect();
    assert!((nearest_pair(&heads) - 4.0).abs() < 1e-8);
}

#[test]
fn longer_bolts_may_stand_among_shorter_ones() {
    let mesh = block([0.0, 30.0], None);
    let two = "bolts = [\n{ pattern = \"walls\", name = \"NAME short\", spacing = 1, length = 3, diameter = 0.025 },\n\
        { pattern = \"walls\", name = \"NAME long\", spacing = 3, length = 9, diameter = 0.025 }]";
    let text: String = BENCHES.iter().map(|bench| stages(&[bench], &two.replace("NAME", bench))).collect();
    let (bolts, _) = placed(&mesh, &text);
    assert_eq!(bolts.iter().map(|b| b.bars.len()).collect::<Vec<_>>(), [240, 20, 240, 20, 240, 20]);
}

/// In the engine's hands every bolt begins at its head and is as long as it was meant to be.
fn whole(problem: Problem, length: f64) {
    let model = Model::new(problem).unwrap();
    for set in &model.bolts {
        assert_eq!((set.cuts.given, set.cuts.left_out, set.cuts.shortened), (set.bolts.len(), 0, 0));
        assert!(set.bolts.iter().all(|bolt| (bolt.length() - length).abs() < 1e-6));
    }
}

/// A distorted mesh: faces are warped, rows cut them where they like.
#[test]
fn a_mesh_in_a_mirror_has_its_bolts_in_the_mirror_and_heads_lie_on_warped_faces() {
    let mesh = block([6.0, 24.0], Some(Distortion { fraction: 0.12, seed: 7, periodic: [false; 2] }));
    // Behind the end walls are 6 m of rock, and bolts lean as the faces do.
    let text = stages(&BENCHES, &pattern("systematic", "[1.7, 1.3]").replace("length = 6", "length = 5"));
    let (bolts, _) = placed(&mesh, &text);
    for axis in [0, 1] {
        let (other, _) = placed(&mirrored(&mesh, axis), &text);
        for (one, two) in bolts.iter().zip(&other) {
            let (one, two) = (ends(one), ends(two));
            assert_eq!(one.len(), two.len());
            for bolt in one {
                let image = bolt.map(|mut x| {
                    x[axis] = -x[axis];
                    x
                });
                assert!(two.iter().any(|b| near(b[0], image[0]) && near(b[1], image[1])), "{axis}: {bolt:?}");
            }
        }
    }
    whole(of_mesh(&mesh, &text, &[]).unwrap_or_else(|e| panic!("{e}")).1.problem, 5.0);
    // In the rock, but not a thousandth of a millimetre before it.
    let rock = Locator::new(&mesh, Some(&mesh.groups["rock"]));
    let gone: Vec<u32> = BENCHES.iter().flat_map(|bench| mesh.groups[*bench].clone()).collect();
    let void = Locator::new(&mesh, Some(&gone));
    for bolt in bolts.iter().flat_map(ends) {
        let before = [0, 1, 2].map(|i| bolt[0][i] - 1e-6 * direction(bolt)[i]);
        assert!(rock.locate(bolt[0], 0.0).is_some(), "{bolt:?}");
        assert!(rock.locate(before, 0.0).is_none() && void.locate(before, 0.0).is_some(), "{bolt:?}");
    }
}

#[test]
fn a_given_direction_leads_into_the_rock_on_both_sides_and_nowhere_along_the_wall() {
    let mesh = block([0.0, 30.0], None);
    let bolts = "bolts = { pattern = \"systematic\", spacing = 2, length = 5, diameter = 0.025, direction = [3, 0, 4] }";
    let (all, warnings) = placed(&mesh, &stages(&BENCHES[..2], bolts));
    for ends in all.iter().flat_map(ends) {
        let sense = if ends[0][0] < -5.9 { -1.0 } else { 1.0 };
        assert!(near(direction(ends), [0.6 * sense, 0.0, 0.8 * sense]), "{ends:?}");
    }
    let (all, warnings_of_up) =
        placed(&mesh, &stages(&BENCHES[..2], &bolts.replace("[3, 0, 4]", "[0, 0, 1]")));
    assert_eq!(all.iter().map(|b| b.bars.len()).collect::<Vec<_>>(), [15 * 6, 0]);
    assert!(!warnings.contains("along the wall"), "{warnings}");
    assert!(warnings_of_up.contains("60 places have no bolt"), "{warnings_of_up}");
    assert!(warnings_of_up.contains("runs along the wall everywhere"), "{warnings_of_up}");
}

#[test]
fn groups_on_either_side_choose_the_faces() {
    let mut mesh = block([0.0, 30.0], None);
    let rock = mesh.groups.remove("rock").unwrap();
    let left = |e: &u32| mesh.nodes[mesh.elements[*e as usize].nodes[0] as usize][0] < 0.0;
    let (left, right): (Vec<u32>, Vec<u32>) = rock.into_iter().partition(left);
    mesh.groups.insert("left".into(), left);
    mesh.groups.insert("right".into(), right);
    let on = |groups: &str| {
        let bolts = pattern("walls", "2").replace("spacing", &format!("on = [{groups}], spacing"));
        let (bolts, warnings) = placed(&mesh, &stages(&["hall.bench*"], &bolts));
        (ends(&bolts[0]).iter().map(|e| e[0][0].signum()).sum::<f64>(), bolts[0].bars.len(), warnings)
    };
    assert_eq!((on("\"left\"").0, on("\"left\"").1), (-90.0, 90));
    assert_eq!((on("\"hall.bench2\"").0, on("\"hall.bench2\"").1), (0.0, 60));
    assert_eq!(on("\"left\", \"right\"").1, 180);
    let text =
        stages(&["hall.bench1"], &pattern("walls", "2").replace("spacing", "on = [\"halle.*\"], spacing"));
    let refused = of_mesh(&mesh, &text, &[]).err().unwrap().to_string();
    assert!(refused.contains("no group of the mesh fits 'halle.*'"), "{refused}");
    let text = stages(
        &["hall.bench1"],
        &pattern("walls", "2").replace("spacing", "on = [\"hall.bench3\"], spacing"),
    );
    let (bolts, warnings) = placed(&mesh, &text);
    assert_eq!(bolts[0].bars.len(), 0, "it stays among the bolts, so that their order is the case's");
    assert!(
        warnings.contains(
            "'walls of hall.bench1': no bolts are placed: none of these faces are laid bare by the stage"
        ),
        "{warnings}"
    );
}

#[test]
fn a_spacing_in_the_wrong_unit_is_refused_before_bolts_are_made() {
    let mesh = block([0.0, 30.0], None);
    let text = stages(&["hall.bench1"], &pattern("walls", "\"1.5 mm\""));
    let refused = of_mesh(&mesh, &text, &[]).err().unwrap().to_string();
    assert!(refused.contains("would place some") && refused.contains("unit of the spacing"), "{refused}");
}

/// A shaft and a hall under an arch, from the generator.
fn arch(lining: &str, bolts: &str) -> (Case, Setup) {
    let folder = tempfile::tempdir().unwrap();
    let region = if lining.is_empty() {
        REGION.to_owned()
    } else {
        "[[region]]\ngroups = [\"rock\", \"*.bench*\"]\nmaterial = \"rock\"\nelement = \"reduced-integration\"\n[[region]]\n\
         groups = [\"*.lining\"]\nmaterial = \"rock\"\nelement = \"full-integration\"\nbefore = \"rock\"\n"
            .to_owned()
    };
    let install = if lining.is_empty() { "" } else { "install = [\"hall.lining\"]\n" };
    let text = format!(
        "{HEAD}[mesh.caverns]\noverburden = \"60 m\"\nbelow = \"40 m\"\nsides = \"40 m\"\nlength = \"24 m\"\nsize_near = \"1.2 m\"\n\
         size_far = \"8 m\"\nsize_along = \"2 m\"\n[[mesh.caverns.cavern]]\nname = \"hall\"\nwidth = \"17 m\"\nheight = \"20 m\"\n\
         arch_rise = \"4.5 m\"\nbenches = 3\n{lining}{region}[[stage]]\nname = \"all\"\nexcavate = [\"hall.bench*\"]\n{install}{bolts}\n"
    );
    let case = parse(folder.path(), &text);
    let made = setup(&case, &Laws::default(), Isa::best()).unwrap_or_else(|e| panic!("{e}"));
    (case, made)
}

#[test]
fn bolts_of_an_arch_stand_on_it_at_the_spacing_and_point_away_from_its_centre() {
    let spacing = 1.5;
    let (_, made) = arch("", &pattern("crown", "1.5"));
    // Chord 17 m, rise 4.5 m: R = (8.5² + 4.5²)/(2 · 4.5), its centre R below the crown at z = −60 m.
    let radius = (8.5_f64.powi(2) + 4.5_f64.powi(2)) / 9.0;
    let centre = -60.0 - radius;
    let bolts = ends(&made.problem.bolts[0]);
    let mut rows: Vec<f64> = bolts.iter().map(|ends| ends[0][1]).collect();
    rows.sort_by(f64::total_cmp);
    rows.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
    assert_eq!(rows.len(), 16, "24 m over 1.5 m");
    for y in rows {
        let mut row: Vec<&Ends> = bolts.iter().filter(|ends| (ends[0][1] - y).abs() < 1e-6).collect();
        row.sort_by(|a, b| a[0][0].total_cmp(&b[0][0]));
        assert!(row.len() >= 10, "{}", row.len());
        for pair in row.windows(2) {
            let angle = |e: &Ends| (e[0][0]).atan2(e[0][2] - centre);
            let arc = radius * (angle(pair[1]) - angle(pair[0]));
            assert!((arc - spacing).abs() < 0.01 * spacing, "{arc}");
        }
        for ends in row {
            let out = [ends[0][0], 0.0, ends[0][2] - centre];
            let size = distance(out, [0.0; 3]);
            // Faces are chords of 1.2 m, up to their sagitta within the arc, and lean from the radius by up to half their angle.
            let half = 0.5 * 1.4 / radius;
            assert!(size < radius + 1e-6 && size > radius * half.cos() - 1e-6, "{size} of {radius}");
            let cos = (out[0] * direction(*ends)[0] + out[2] * direction(*ends)[2]) / size;
            // But beside the springing, where a corner is, directions are smoothed.
            let most = if ends[0][0].abs() < 7.0 { 0.1 * half } else { half };
            assert!(cos > most.cos() - 1e-9, "{} at {:?}", cos.acos().to_degrees(), ends[0]);
        }
    }
    // The same row left and right, and its middle one, if there is one, upright.
    for bolt in &bolts {
        let image = bolt.map(|[x, y, z]| [-x, y, z]);
        assert!(bolts.iter().any(|b| near(b[0], image[0]) && near(b[1], image[1])), "{bolt:?}");
    }
}

#[test]
fn the_wall_behind_a_lining_that_is_installed_in_the_same_stage_is_the_rock() {
    let lining = "lining = { walls = \"0.5 m\", crown = \"0.5 m\", layers = 1 }\n";
    let (_, made) = arch(lining, &pattern("walls", "2"));
    let bolts = ends(&made.problem.bolts[0]);
    assert_eq!(
        made.plan.stages[1].changed.iter().map(ToString::to_string).collect::<Vec<_>>(),
        ["bolts 'walls of all' placed"]
    );
    assert!(made.plan.stages[0].changed.is_empty());
    let side = bolts.iter().filter(|&&e| direction(e)[0].abs() > 0.999).collect::<Vec<_>>();
    assert!(side.len() > 100, "{}", side.len());
    assert!(side.iter().all(|e| (e[0][0].abs() - 9.0).abs() < 1e-6), "half of 17 m and 0.5 m of lining");
    whole(made.problem, 6.0);
}

/// Bolts of the block with both halls: of the second bench there is a void on one side.
fn points(stages: &str, files: &[(&str, &str)]) -> Result<(Case, Setup), String> {
    of_mesh(&block([0.0, 30.0], None), stages, files).map_err(|e| e.to_string())
}

#[test]
fn points_and_a_file_give_the_same_bolts() {
    let steel = "diameter = \"20 mm\", yield = \"400 MPa\", bond = { stiffness = \"10 MPa\", strength = \"1 kN/m\", friction_angle = \"45 deg\" }";
    let by = |place: &str| stages(&["hall.bench1"], &format!("bolts = {{ {place}, {steel} }}"));
    let csv = "x1,y1,z1,x2,y2,z2\n# the left wall\n-6,15,-2,-12,15,-2.5\n\n6, 15, -2, 12, 15, -2.5\n";
    let (_, listed) =
        points(&by("points = [[[-6, 15, -2], [-12, 15, -2.5]], [[6, 15, -2], [12, 15, -2.5]]]"), &[])
            .unwrap();
    let (case, read) = points(&by("file = \"b.csv\""), &[("b.csv", csv)]).unwrap();
    let (_, bare) = points(&by("file = \"b.csv\""), &[("b.csv", &csv[csv.find('#').unwrap()..])]).unwrap();
    assert_eq!(listed.problem.bolts, read.problem.bolts);
    assert_eq!(listed.problem.bolts, bare.problem.bolts);
    assert!(
        read.inputs.iter().any(|input| input.name == "b.csv" && !input.hash.is_empty()),
        "{:?}",
        case.files()
    );
    let [bolts] = &read.problem.bolts[..] else { panic!("one entry") };
    assert_eq!(
        ends(bolts),
        [[[-6.0, 15.0, -2.0], [-12.0, 15.0, -2.5]], [[6.0, 15.0, -2.0], [12.0, 15.0, -2.5]]]
    );
    let bond = bolts.bond.unwrap();
    assert_eq!((bolts.name.as_str(), bolts.born), ("bolts of hall.bench1", Stage::Before(1)));
    assert!((bolts.bars[0].areas[0] - 1e-4 * std::f64::consts::PI).abs() < 1e-15);
    assert!(
        (bond.friction - 1.0).abs() < 1e-12 && (bond.perimeter - 0.02 * std::f64::consts::PI).abs() < 1e-12
    );
    assert_eq!((bolts.yields, bolts.breaks, bond.segment), (400e6, f64::INFINITY, f64::INFINITY));
    assert_eq!((bolts.pretension, bolts.free_length, bolts.plates), (0.0, 0.0, [false, false]));
}

#[test]
fn a_file_that_cannot_be_read_is_refused_with_its_line() {
    let text = stages(&["hall.bench1"], "bolts = { file = \"b.csv\", diameter = 0.025 }");
    for (csv, says) in [
        ("", "b.csv holds no bolts"),
        ("x1,y1,z1,x2,y2,z2\n", "b.csv holds no bolts"),
        ("-6,15,-2,-12,15\n", "b.csv, line 1: 5 values"),
        ("\n-6,15,-2,-12,15,-2\n-6,15,-2,-12,x,-2", "b.csv, line 3: y2 is 'x'"),
        ("-6,15,-2,-12,15,inf", "b.csv, line 1: z2 is 'inf'"),
        ("x1,y1,z1,x2,y2\n-6,15,-2,-12,15,-2", "b.csv, line 1: the columns are x1,y1,z1,x2,y2"),
        ("x1 [mm],y1,z1,x2,y2,z2\n-6,15,-2,-12,15,-2", "in m are expected"),
        ("x1 [m],y1,z1,x2,y2,z2\n-6,15,-2,-6,15,-2", "b.csv, line 2: the two points"),
        (
            "-6,15,-2,-12,15,-2\n0,15,-2,-12,15,-2",
            "the bolt in line 2 of b.csv: its head at (0.000, 15.000, -2.000) m lies in nothing",
        ),
    ] {
        let refused = points(&text, &[("b.csv", csv)]).err().unwrap_or_else(|| panic!("{csv} is taken"));
        assert!(refused.contains(says) && refused.contains("case.toml:"), "{csv}: {refused}");
    }
}

#[test]
fn a_listed_bolt_must_lie_in_what_stands_but_for_its_free_length() {
    let bolts = |place: &str, more: &str| {
        stages(&BENCHES[..2], "").replacen(
            "[[stage]]\nname = \"hall.bench2\"",
            &format!("[[stage]]\nname = \"bolts\"\nbolts = {{ points = [{place}], diameter = 0.025{more} }}\n[[stage]]\nname = \"hall.bench2\""),
            1,
        )
    };
    let refused = |place: &str, more: &str| {
        points(&bolts(place, more), &[]).err().unwrap_or_else(|| panic!("{place} is taken"))
    };
    // The second bench stands yet.
    assert!(points(&bolts("[[0, 15, -4], [0, 15, -10]]", ""), &[]).is_ok());
    let text = refused("[[6, 15, -2], [12, 15, -2]], [[12, 15, -2], [-12, 15, -2]]", "");
    assert!(
        text.contains(
            "bolt 2 leaves what stands in 'bolts' at (6.000, 15.000, -2.000) m, 6.000 m from its head"
        ),
        "{text}"
    );
    // A void thinner than an element is found as well: here a corner of it, 0.35 m long.
    let text = refused("[[12, 15, 4.25], [0, 15, -7.75]], [[9.75, 15, -4], [5.75, 15, 0]]", "");
    assert!(text.contains("bolt 2 leaves"), "{text}");
    assert!(
        refused("[[6, 15, -2], [12, 15, -2]], [[5.9, 15, -2], [12, 15, -2]]", "")
            .contains("bolt 2: its head at (5.900")
    );
    assert!(
        refused("[[12, 15, -2], [25, 15, -2]]", "")
            .contains("bolt 1 leaves what stands in 'bolts' at (20.000, 15.000, -2.000) m, 8.000 m")
    );
    // A centimetre is a slip of the tape.
    let (_, made) = points(&bolts("[[5.992, 15, -2], [12, 15, -2]]", ""), &[]).unwrap();
    let head = made.problem.bolts[0].bars[0].points[0];
    assert!(head[0] >= 6.0 - 1e-6 && head[0] < 6.0 + 1e-6, "{head:?}");
    // From cavern to cavern, or here from wall to wall through the void.
    let across = "[[12, 15, -2], [-12, 15, -2]]";
    assert!(
        points(&bolts(across, ", free_length = 24, plate = \"both\", pretension = \"100 kN\""), &[]).is_ok()
    );
    assert!(points(&bolts(across, ", free_length = 18.5, plate = \"head\""), &[]).is_ok());
    let text = refused(across, ", free_length = 17.5, plate = \"head\"");
    assert!(text.contains("at (-5.500, 15.000, -2.000) m, 17.500 m from its head"), "{text}");
    let text = refused(across, ", free_length = 24, plate = \"head\"");
    assert!(text.contains("all of it free: nothing holds its other end"), "{text}");
}

#[test]
fn a_bond_that_acts_over_less_than_a_segment_is_warned_of() {
    let with = |bond: &str, plate: &str| {
        let bolts =
            pattern("walls", "2").replace("diameter", &format!("bond = {{ {bond} }}, {plate}diameter"));
        let (bolts, warnings) = placed(&block([0.0, 30.0], None), &stages(&["hall.bench1"], &bolts));
        assert!(!bolts[0].bars.is_empty());
        warnings
    };
    // √(200 GPa · 491 mm² / 10 GPa) = 99 mm; elements are 2 m.
    let text = with("stiffness = \"10 GPa\", strength = 3e5", "plate = true, ");
    assert!(
        text.contains("over 0.10 m, a segment is some 2.00 m long") && text.contains("\"0.05 m\""),
        "{text}"
    );
    let finer = "stiffness = \"10 GPa\", strength = 3e5, segment = 0.3";
    assert!(with(finer, "plate = true, ").contains("some 0.30 m long"));
    assert!(
        !with("stiffness = \"10 GPa\", strength = 3e5, segment = 0.1", "plate = true, ").contains("bond")
    );
    assert!(!with("stiffness = \"30 MPa\", strength = 3e5", "plate = true, ").contains("bond"));
    // Where nothing ends that matters, it is the rule.
    assert!(!with("stiffness = \"10 GPa\", strength = 3e5", "").contains("bond"));
    let bolts = pattern("walls", "2")
        .replace("diameter", "bond = { stiffness = 1e10, strength = 1e5, segment = 1e-5 }, diameter");
    let refused =
        of_mesh(&block([0.0, 30.0], None), &stages(&["hall.bench1"], &bolts), &[]).err().unwrap().to_string();
    assert!(refused.contains("segments") && refused.contains("longer segment"), "{refused}");
}

#[test]
fn what_a_later_stage_takes_is_not_bolted() {
    let mut mesh = block([6.0, 24.0], None);
    let bench = mesh.groups.remove("hall.bench1").unwrap();
    let first = |e: &u32| mesh.nodes[mesh.elements[*e as usize].nodes[0] as usize][1] < 13.0;
    let (first, second): (Vec<u32>, Vec<u32>) = bench.into_iter().partition(first);
    mesh.groups.insert("first".into(), first);
    mesh.groups.insert("second".into(), second);
    let (bolts, _) = placed(&mesh, &stages(&["first", "second"], &pattern("walls", "2")));
    // 8 m and 10 m of two walls, and one end of 12 m each: the face at y = 14 m goes.
    assert_eq!(bolts.iter().map(|b| b.bars.len()).collect::<Vec<_>>(), [2 * (8 + 6), 2 * (10 + 6)]);
    assert!(bolts.iter().flat_map(ends).all(|ends| (ends[0][1] - 14.0).abs() > 0.5));
}

#[test]
fn a_shaft_has_rings_and_its_corners_are_bolted_once() {
    let spec = BoxSpec::uniform([-20.0, 0.0, -24.0], [20.0, 30.0, 12.0], [20, 15, 18]);
    let mut mesh = spec.mesh().unwrap();
    for (e, element) in mesh.elements.iter().enumerate() {
        let [x, y, z] = mesh.nodes[element.nodes[0] as usize];
        let inside = (-6.0..6.0).contains(&x) && (10.0..22.0).contains(&y) && z >= -4.0;
        mesh.groups.entry(if inside { "shaft" } else { "rock" }.into()).or_default().push(e as u32);
    }
    let (bolts, _) = placed(&mesh, &stages(&["shaft"], &pattern("systematic", "[4, 2.05]")));
    let bolts = ends(&bolts[0]);
    // 16 m of depth over 4 m; 48 m around over 2.05 m, which is 23 times stretched to close.
    assert_eq!(bolts.len(), 4 * 23);
    for level in [-2.0, 2.0, 6.0, 10.0] {
        let ring: Vec<f64> = bolts
            .iter()
            .filter(|ends| (ends[0][2] - level).abs() < 1e-6)
            .map(|&[[x, y, _], _]| match [x, y - 16.0] {
                [x, y] if x > 6.0 - 1e-6 => y,
                [x, y] if y > 6.0 - 1e-6 => 12.0 - x,
                [x, y] if x < -6.0 + 1e-6 => 24.0 - y,
                [x, _] => 36.0 + x,
            })
            .collect();
        let mut ring: Vec<f64> = ring.into_iter().map(|s| s.rem_euclid(48.0)).collect();
        ring.sort_by(f64::total_cmp);
        assert_eq!(ring.len(), 23);
        assert!(ring.windows(2).all(|s| (s[1] - s[0] - 48.0 / 23.0).abs() < 1e-6), "{ring:?}");
    }
    assert!(bolts.iter().all(|&ends| direction(ends)[2].abs() < 1e-12));
}

#[test]
fn what_can_hardly_be_meant_is_refused_or_warned_of() {
    let with = |place: &str, more: &str| {
        let text = format!("bolts = {{ points = [{place}], diameter = 0.025{more} }}");
        points(&stages(&["hall.bench1"], &text), &[])
            .map(|(case, made)| case.report(made.warnings).to_string())
    };
    let wall = "[[6, 15, -2], [12, 15, -2]]";
    let bonded = |strength: &str| {
        let bond = format!("bond = {{ stiffness = \"1 GPa\", strength = \"{strength}\" }}");
        with(wall, &format!(", free_length = 2, plate = true, pretension = \"60 kN\", {bond}"))
    };
    // Four metres hold 60 kN at 15 kN/m.
    let text = bonded("14.9 kN/m").unwrap_err();
    assert!(text.contains("holds 59.6 kN") && text.contains("drawn out"), "{text}");
    assert!(bonded("15.1 kN/m").is_ok());
    for (more, says) in [
        (", yield = 400", "the yield stress of a bolt is 400 Pa"),
        (", young = 200", "Young's modulus of a bolt is 200 Pa"),
        (", pretension = 60", "the pretension is 60 N"),
    ] {
        let text = with(wall, more).unwrap();
        assert!(text.contains(says) && text.contains("look at the unit"), "{text}");
    }
    // Swapped ends, and a plate behind ground that goes later; none where the wall is bare.
    let swapped = with("[[12, 15, -2], [6, 15, -2]]", ", plate = true").unwrap();
    assert!(swapped.contains("1 of 1 bolts") && swapped.contains("give the head first"), "{swapped}");
    let early = with("[[0, 15, -4.5], [6, 15, -10]]", ", plate = true").unwrap();
    assert!(early.contains("in the stage that lays the wall bare"), "{early}");
    assert!(!with(wall, ", plate = true").unwrap().contains("plate"));
}
