use super::*;
use std::f64::consts::PI;
use tremolite_seepage::{Ground, Holds, Place, steady};

/// A grid across, of one element along y, bent by `to`: nodes and elements.
fn grid([m, n]: [usize; 2], to: impl Fn(f64, f64) -> [f64; 2]) -> (Vec<[f64; 3]>, Vec<[u32; 8]>) {
    let node = |i: usize, j: usize, k: usize| ((k * 2 + j) * (m + 1) + i) as u32;
    let mut nodes = Vec::new();
    for k in 0..=n {
        for j in 0..2 {
            nodes.extend((0..=m).map(|i| {
                let [x, z] = to(i as f64 / m as f64, k as f64 / n as f64);
                [x, j as f64, z]
            }));
        }
    }
    let ring = |i, k| [node(i, 0, k), node(i + 1, 0, k), node(i + 1, 1, k), node(i, 1, k)];
    let all = (0..n).flat_map(|k| (0..m).map(move |i| (i, k)));
    let elements = all.map(|(i, k)| {
        let (below, above) = (ring(i, k), ring(i, k + 1));
        std::array::from_fn(|c| if c < 4 { below[c] } else { above[c - 4] })
    });
    (nodes, elements.collect())
}

/// Faces across x of the grid's first or last column.
fn side((nodes, elements): &(Vec<[f64; 3]>, Vec<[u32; 8]>), m: usize, last: bool) -> Vec<Vec<u32>> {
    assert!(!nodes.is_empty());
    let column = elements.iter().skip(if last { m - 1 } else { 0 }).step_by(m);
    let face = if last { [1, 2, 6, 5] } else { [0, 4, 7, 3] };
    column.map(|e| face.map(|k| e[k]).to_vec()).collect()
}

/// What flows between two columns of a grid, as polygons in the plane and as hexahedra.
fn solved(mesh: &(Vec<[f64; 3]>, Vec<[u32; 8]>), m: usize) -> (Vec<FlowCell<2>>, Vec<FlowCell<3>>) {
    let (nodes, elements) = mesh;
    let conductivity = vec![1e-7; elements.len()];
    let ground = Ground { nodes, elements, conductivity: &conductivity };
    let place = |name: &str, head: f64, last: bool| {
        Place::of_faces(name, Holds::Head(head), side(mesh, m, last), nodes)
    };
    let flow = steady(&ground, &[place("wall", 100.0, false), place("far", 200.0, true)]).unwrap();
    let at = |n: u32| nodes[n as usize];
    let flat = |[x, _, z]: [f64; 3]| [x, z];
    let both = elements.iter().zip(&flow.velocities);
    let plane = both.clone().map(|(e, q)| FlowCell {
        corners: [0, 1, 5, 4].map(|k| flat(at(e[k]))).to_vec(),
        flow: flat(*q),
        wanted: true,
    });
    let space = both.map(|(e, q)| FlowCell { corners: e.map(at).to_vec(), flow: *q, wanted: true });
    (plane.collect(), space.collect())
}

/// The largest angle between the pieces of lines and what is exact at their middles, and the root of the mean square over their length (°).
fn angles<const D: usize>(lines: &[FlowLine<D>], exact: impl Fn([f64; D]) -> [f64; D]) -> [f64; 2] {
    let pieces = lines.iter().flat_map(|line| line.windows(2));
    let of = |ends: &[[f64; D]]| {
        let [a, b] = [&ends[0], &ends[1]];
        let (way, to) = (minus(b, a), exact(std::array::from_fn(|i| 0.5 * (a[i] + b[i]))));
        ((dot(&way, &to) / (size(&way) * size(&to))).clamp(-1.0, 1.0).acos().to_degrees(), size(&way))
    };
    let (mut largest, mut squares, mut length) = (0.0f64, 0.0, 0.0);
    for (angle, own) in pieces.map(of) {
        largest = largest.max(angle);
        (squares, length) = (squares + angle * angle * own, length + own);
    }
    [largest, (squares / length).sqrt()]
}

/// Errors fall with the element, by the first order where they are largest, at edges, which have cells on one side alone; and below what is said
/// with the smallest.
fn falls(errors: &[Vec<f64>], least: &[f64]) {
    println!("{errors:?}");
    for (k, least) in least.iter().enumerate() {
        assert!(errors[2][k] < *least, "{errors:?}");
        assert!(errors.windows(2).all(|pair| pair[0][k] > 1.5 * pair[1][k]), "{errors:?}");
    }
}

/// A quarter of the ground around a well of 5 m, to 50 m away, by rings and spokes that are bent: 2n × n elements.
fn well(n: usize) -> (Vec<[f64; 3]>, Vec<[u32; 8]>) {
    grid([2 * n, n], |x, z| {
        let inside = (PI * x).sin();
        let angle = 0.5 * PI * z + 0.2 * inside * (2.0 * PI * z).sin();
        let r = 5.0 * 10f64.powf(x) * (1.0 + 0.1 * inside * (2.0 * PI * z).cos());
        [r * angle.cos(), r * angle.sin()]
    })
}

/// Lines are straight, and go from the rim to the well.
#[test]
fn lines_to_a_well_are_straight() {
    let mut errors = Vec::new();
    for n in [8, 16, 32] {
        let (plane, space) = solved(&well(n), 2 * n);
        let lines = super::lines(&plane, 800.0, 60);
        assert!((12..60).contains(&lines.len()), "{}", lines.len());
        for line in &lines {
            let [from, to] = [line[0], line[line.len() - 1]].map(|end| size(&end));
            // To within a thousandth of a cell's width of the chords of the rim and the well.
            let chord = (0.5 * PI / n as f64).powi(2);
            assert!(
                (1.0 - chord..1.001).contains(&(from / 50.0)) && (1.0 - chord..1.01).contains(&(to / 5.0)),
                "{from} {to}"
            );
        }
        let inwards = |at: [f64; 2]| at.map(|x| -x);
        let in_space = super::lines(&space, 800.0, 60);
        let flat = |at: [f64; 3]| [-at[0], 0.0, -at[2]];
        errors.push([angles(&lines, inwards), angles(&in_space, flat)].concat());
    }
    falls(&errors, &[1.5, 0.5, 3.0, 0.5]);
}

/// Around a corner between walls on which xz is constant: so it is on lines, which go (−x, z). Bent as for the well.
#[test]
fn lines_around_a_corner_are_hyperbolas() {
    let mut errors = Vec::new();
    for n in [8, 16, 32] {
        let mesh = grid([2 * n, n], |x, z| {
            let inside = (PI * x).sin() * (PI * z).sin();
            let (potential, stream) = (600.0 * x - 300.0 + 40.0 * inside, 100.0 + 300.0 * z + 40.0 * inside);
            // The root of the complex number.
            let size = potential.hypot(stream);
            [(0.5 * (size + potential)).sqrt(), (0.5 * (size - potential)).sqrt()]
        });
        let (plane, _) = solved(&mesh, 2 * n);
        let lines = super::lines(&plane, 200.0, 60);
        assert!((6..60).contains(&lines.len()), "{}", lines.len());
        errors.push(angles(&lines, |[x, z]| [-x, z]).to_vec());
    }
    falls(&errors, &[0.5, 0.2]);
}

/// The mirror image of a model, its cells from last to first, has the mirror image of its lines.
#[test]
fn mirrored_ground_has_mirrored_lines() {
    let (cells, _) = solved(&well(16), 32);
    let turned = |[x, z]: [f64; 2]| [-x, z];
    let image = cells.iter().rev().map(|cell| FlowCell {
        corners: cell.corners.iter().rev().map(|&at| turned(at)).collect(),
        flow: turned(cell.flow),
        wanted: true,
    });
    let lines = lines(&cells, 800.0, 60);
    let image = super::lines(&image.collect::<Vec<_>>(), 800.0, 60);
    assert_eq!(lines.len(), image.len());
    for (line, image) in lines.iter().zip(&image) {
        assert_eq!(line.len(), image.len());
        for (a, b) in line.iter().zip(image) {
            assert!(size(&minus(&turned(*a), b)) < 1e-6, "{a:?} {b:?}");
        }
    }
}

/// At a drain within the ground lines end, within a cell of it; still water has none, nor has what is no number.
#[test]
fn lines_end_at_drains() {
    let cell = |x: f64, z: f64, flow: [f64; 2]| FlowCell {
        corners: vec![[x, z], [x + 1.0, z], [x + 1.0, z + 1.0], [x, z + 1.0]],
        flow,
        wanted: true,
    };
    let places = || (0..400).map(|k| [(k % 20) as f64 - 10.0, (k / 20) as f64 - 10.0]);
    let to_middle = |[x, z]: [f64; 2]| {
        let [a, b] = [x + 0.5, z + 0.5];
        cell(x, z, [a, b].map(|c| -1e-8 * c / (a * a + b * b)))
    };
    let found = lines(&places().map(to_middle).collect::<Vec<_>>(), 200.0, 60);
    assert!(found.len() > 10);
    for line in &found {
        let [from, to] = [line[0], line[line.len() - 1]];
        assert!(line.len() < 200, "it does not go to and fro there: {} points", line.len());
        assert!(from[0].abs().max(from[1].abs()) > 9.99 && size(&to) < 0.8, "{from:?} {to:?}");
    }
    assert!(lines(&places().map(|[x, z]| cell(x, z, [0.0; 2])).collect::<Vec<_>>(), 200.0, 60).is_empty());
    assert!(lines(&[cell(0.0, 0.0, [f64::NAN, 1.0])], 200.0, 60).is_empty());
    // What is not wanted has no line of its own, but lines go through it.
    let mut half: Vec<_> = places().map(|[x, z]| cell(x, z, [1e-8, 0.0])).collect();
    half.iter_mut().for_each(|cell| cell.wanted = cell.corners[0][0] < -5.0);
    let found = lines(&half, 30.0, 60);
    assert!(!found.is_empty() && found.iter().all(|line| line[line.len() - 1][0] > 9.99));
    assert!(found.len() < 12, "{}", found.len());
    let straight = thinned(&found[0], 1e-6);
    assert_eq!(straight, [found[0][0], found[0][found[0].len() - 1]]);
}
