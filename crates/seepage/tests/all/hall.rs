//! A hall on a coarse mesh: the free surface passes few elements.

use crate::common::{Made, even, grid, middle};
use tremolite_seepage::{Holds, Place};

fn hall(n: usize) -> (Made, Place) {
    let mut made = grid(&even(0.0, 60.0, 12 * n), &even(0.0, 10.0, 2 * n), &even(-60.0, 0.0, 12 * n));
    let keep: Vec<bool> = (0..made.elements.len())
        .map(|e| {
            let x = middle(&made, e);
            !((x[0] - 30.0).abs() < 10.0 && (x[2] + 30.0).abs() < 10.0)
        })
        .collect();
    let mut k = keep.iter();
    made.elements.retain(|_| *k.next().unwrap());
    made.conductivity.truncate(made.elements.len());
    let wall =
        made.place("wall", Holds::Open(None), |x| (x[0] - 30.0).abs() <= 10.0 && (x[2] + 30.0).abs() <= 10.0);
    (made, wall)
}

/// Water that trickles down beside the hall and stands under it, on one side or both: heads on one side, two or four, below and above its floor.
#[test]
fn the_free_surface_is_found_beside_a_hall() {
    for n in [1, 2] {
        let heads = [[-5.0, -5.0], [-500.0, -5.0], [-25.0, -5.0], [-35.0, -5.0], [-55.0, -45.0]];
        for ([low, high], ends) in heads.map(|heads| (heads, false)).into_iter().chain([([-5.0, -5.0], true)])
        {
            let (made, wall) = hall(n);
            let mut places = vec![wall];
            places.push(made.place("xmin", Holds::Head(low), |x| x[0] == 0.0));
            places.push(made.place("xmax", Holds::Head(high), |x| x[0] == 60.0));
            if ends {
                places.push(made.place("ends", Holds::Head(high), |x| x[1] == 0.0 || x[1] == 10.0));
            }
            let flow = made.solve(&places).unwrap();
            let out = &flow.outflows;
            assert!(flow.mass_error < 1e-9 && out.iter().sum::<f64>().abs() < 1e-9 * flow.inflow, "{out:?}");
            assert!(
                flow.iterations <= 200 && flow.left <= 0.03,
                "{low} {high}: {} {}",
                flow.iterations,
                flow.left
            );
            assert!(out[0] >= 0.0 && out[2] < 0.0, "{out:?}");
            // Nothing presses on a wall that is open.
            for &(node, _) in &places[0].nodes {
                let pressure_head = flow.heads[node as usize] - made.nodes[node as usize][2];
                assert!(pressure_head < 1e-6, "{low} {high}: {pressure_head}");
            }
            // Below its floor nothing comes into the hall.
            assert_eq!(out[0] > 0.0, high > -40.0, "{low} {high}: {out:?}");
        }
    }
}
