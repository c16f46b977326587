use super::*;
use crate::boxes::BoxSpec;
use crate::placement::Placement;
use crate::quality::summary_of;
use std::f64::consts::PI;

/// A block of 8 × 6 × 4 m in bricks, `n` to two metres, all of them in `rock`, those of x > 2 m in `half` as well.
fn block(n: u32) -> Mesh {
    let spec = BoxSpec::uniform([-4.0, -3.0, -2.0], [4.0, 3.0, 2.0], [4 * n, 3 * n, 2 * n]);
    let mut mesh = spec.mesh().unwrap_or_else(|e| panic!("{e}"));
    let all: Vec<u32> = (0..mesh.elements.len() as u32).collect();
    let half = all.iter().copied().filter(|&e| middle(&mesh, e)[0] > 2.0).collect();
    mesh.groups = [("rock".to_owned(), all), ("half".to_owned(), half)].into();
    mesh
}

fn of(names: &[&str]) -> Vec<String> {
    names.iter().map(|&n| n.to_owned()).collect()
}

fn plane(through: [f64; 3], dip: f64, direction: f64) -> Plane {
    Plane::dipping(through, dip.to_radians(), direction.to_radians())
}

/// Places with their exact volumes \[m³\] and the areas of their borders \[m²\] within the block.
fn places() -> Vec<(Place, f64, f64)> {
    let upper = plane([0.0, 0.0, 0.5], 10.0, 70.0);
    let lower = Plane { through: [0.0, 0.0, -0.5], ..upper };
    vec![
        (Place::Box([[1.7, 2.1, 1.3], [-2.3, -1.1, -0.9]]), 4.0 * 3.2 * 2.2, 57.3),
        // Through the middle of a block any plane leaves half.
        (Place::Halfspace { plane: plane([0.0; 3], 35.0, 200.0), above: true }, 96.0, 58.6),
        (Place::Halfspace { plane: plane([0.0; 3], 90.0, 33.0), above: false }, 96.0, 40.0),
        (
            Place::Cylinder { ends: [[0.3, 3.5, 0.1], [0.3, -3.5, 0.1]], radius: 1.5 },
            6.0 * PI * 2.25,
            6.0 * PI * 3.0,
        ),
        (Place::Levels([1.3, -0.4]), 8.0 * 6.0 * 1.7, 96.0),
        // 1 m apart along z; of a length and width where both planes stay within the block's height
        (Place::Planes([upper, lower]), 48.0, 97.5),
    ]
}

#[test]
fn the_volume_of_a_group_goes_to_that_of_its_place_with_the_size() {
    for (place, exact, area) in places() {
        let error = |n: u32| {
            let mut mesh = block(n);
            let all = mesh.elements.len() as u32;
            let taken = take(&mut mesh, "new", &of(&["rock"]), &place, &[]);
            let new = mesh.groups.get("new").cloned().unwrap_or_else(|| panic!("{place:?}: {taken:?}"));
            let rock = &mesh.groups["rock"];
            assert_eq!(new.len() + rock.len(), all as usize);
            assert!(new.iter().all(|e| rock.binary_search(e).is_err()));
            (summary_of(&mesh, new).volume - exact).abs()
        };
        // Wrong are elements at most whose middle is nearer to the border than half a diagonal.
        for n in [4, 8, 16] {
            let bound = area * 3f64.sqrt() / f64::from(n);
            assert!(error(n) < bound, "{place:?} {n}: {} {bound}", error(n));
        }
    }
}

#[test]
fn groups_of_a_mesh_that_is_turned_and_mirrored_are_turned_and_mirrored() {
    let quarter = Placement { rotation: std::f64::consts::FRAC_PI_2, ..Placement::AS_IT_IS };
    let mirror = Placement { scale: [-1.0, 1.0, 1.0], ..Placement::AS_IT_IS };
    // Counter-clockwise by a right angle a direction counts a right angle less; mirrored in x it counts the other way.
    let direction = |placement: &Placement, degrees: f64| match placement.scale[0] < 0.0 {
        true => -degrees,
        false => degrees - 90.0,
    };
    for placement in [quarter, mirror] {
        let moved = |x: [f64; 3]| match placement.scale[0] < 0.0 {
            true => [-x[0], x[1], x[2]],
            false => [-x[1], x[0], x[2]],
        };
        let turned =
            |through: [f64; 3], dip: f64, to: f64| plane(moved(through), dip, direction(&placement, to));
        let (at, low, high) = ([0.7, -0.4, 0.2], [-1.2, -2.3, -1.1], [2.1, 1.4, 0.9]);
        let pairs = [
            (Place::Box([low, high]), Place::Box([moved(low), moved(high)])),
            (
                Place::Halfspace { plane: plane(at, 55.0, 112.0), above: true },
                Place::Halfspace { plane: turned(at, 55.0, 112.0), above: true },
            ),
            (
                Place::Halfspace { plane: plane(at, 90.0, 20.0), above: true },
                Place::Halfspace { plane: turned(at, 90.0, 20.0), above: true },
            ),
            (
                Place::Cylinder { ends: [low, high], radius: 1.3 },
                Place::Cylinder { ends: [moved(low), moved(high)], radius: 1.3 },
            ),
            (
                Place::Planes([plane(at, 30.0, 250.0), plane(low, 25.0, 240.0)]),
                Place::Planes([turned(at, 30.0, 250.0), turned(low, 25.0, 240.0)]),
            ),
        ];
        for (here, there) in pairs {
            let (mut one, mut other) = (block(5), block(5));
            placement.apply(&mut other);
            let taken = take(&mut one, "new", &of(&["rock", "half"]), &here, &[]);
            assert_eq!(taken, take(&mut other, "new", &of(&["rock", "half"]), &there, &[]), "{here:?}");
            assert!(taken.is_ok() && one.groups == other.groups);
        }
    }
    // A direction that is counted the wrong way round is found out.
    let (mut one, mut other) = (block(5), block(5));
    mirror.apply(&mut other);
    let place = |to: f64| Place::Halfspace { plane: plane([0.0; 3], 55.0, to), above: true };
    assert_ne!(
        take(&mut one, "new", &of(&["rock"]), &place(70.0), &[]),
        take(&mut other, "new", &of(&["rock"]), &place(70.0), &[])
    );
}

#[test]
fn elements_leave_the_groups_named_and_stay_in_others() {
    let mut mesh = block(2);
    let before = mesh.groups.clone();
    let place = Place::Halfspace { plane: plane([0.0; 3], 90.0, 90.0), above: true };
    let taken = take(&mut mesh, "east", &of(&["rock"]), &place, &[]);
    assert_eq!(mesh.groups["half"], before["half"]);
    assert_eq!(2 * mesh.groups["east"].len(), before["rock"].len());
    let Ok(taken) = taken else { panic!("{taken:?}") };
    assert_eq!(taken.from, [("rock".to_owned(), mesh.groups["east"].clone())]);
    // One that overlaps it must name it.
    let level = Place::Levels([0.0, 1.0]);
    let kept = mesh.clone();
    let refused = take(&mut mesh, "level", &of(&["rock"]), &level, std::slice::from_ref(&taken));
    assert_eq!(refused.map_err(|e| e.to_string().contains("list 'east' in its `of`")), Err(true));
    assert_eq!(mesh, kept);
    assert!(take(&mut mesh, "level", &of(&["rock", "east"]), &level, std::slice::from_ref(&taken)).is_ok());
    assert_eq!(4 * mesh.groups["level"].len(), before["rock"].len());
}

#[test]
fn what_takes_nothing_or_all_is_refused_and_leaves_the_mesh() {
    let mut mesh = block(2);
    let kept = mesh.clone();
    for (name, groups, place, says) in [
        ("half", &["rock"], Place::Levels([0.0, 1.0]), "another name"),
        ("new", &["rock"], Place::Levels([10.0, 11.0]), "z from -2.0 to 2.0 m"),
        ("new", &["half"], Place::Levels([-9.0, 9.0]), "all elements of 'half'"),
    ] {
        let refused = take(&mut mesh, name, &of(groups), &place, &[]).map_err(|e| e.to_string());
        assert!(refused.as_ref().is_err_and(|e| e.contains(says)), "{refused:?}");
        assert_eq!(mesh, kept);
    }
}
