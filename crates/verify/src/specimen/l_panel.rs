//! The L-shaped panel of Winkler (2001): a leg that stands fixed, an arm that is pushed up near its end, and a crack from the corner
//! between them into the leg.

use super::plate::{Plate, graded, within};
use super::{Grip, Mix, Specimen, Tested, Words};
use crate::VerifyError;
use tremolite::Quadrature;

/// `winkler2001`: E and ν as in the input of those who computed the test before; f_t, f_c and G_f as they are cited.
pub const MIX: Mix = Mix { young: 25.85e9, poisson: 0.18, tension: 2.7e6, energy: 65.0, compression: 31e6 };

/// Edge of the panel, width of leg and arm, thickness, place of the load along x \[m\].
pub const EDGE: f64 = 0.5;
pub const LEG: f64 = 0.25;
pub const THICK: f64 = 0.1;
pub const LOAD: f64 = 0.47;

/// Elements within this distance of the load stay elastic \[m\].
const ROLLER: f64 = 0.03;

/// How the mesh lies to the crack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lie {
    /// Lines along the edges.
    Along,
    /// Both families of lines turned about the corner where the crack runs, by an angle \[rad\].
    Turned(f64),
    /// Squares on their corners: turned by 45° everywhere.
    Diamonds,
}

fn stands(x: [f64; 2]) -> bool {
    x[0] < LEG || x[1] > LEG
}

/// Elements of this size \[m\] where the crack runs.
pub fn plate(size: f64, lie: Lie) -> Plate {
    if lie == Lie::Diamonds {
        // Sides of half √2; even numbers to the corner and to the load's line as near as it goes.
        let half = LEG / (2.0 * (0.5 * LEG * std::f64::consts::SQRT_2 / size).round());
        let number = (EDGE / half).round() as usize;
        let plate = Plate::diamonds([number; 2], half, THICK, stands);
        let near = half * 2.0 * (0.5 * LOAD / half).round();
        return plate
            .moved(|[x, z]| if z == LEG && (x - near).abs() < 0.1 * half { [LOAD, z] } else { [x, z] });
    }
    let lines = |fine: [f64; 2]| {
        if size > 0.02 {
            let many = (EDGE / size).round() as u32;
            return (0..=many).map(|i| EDGE * f64::from(i) / f64::from(many)).collect();
        }
        graded([0.0, EDGE], fine, size, 1.3, 0.04)
    };
    let mut across: Vec<f64> = lines([0.0, LEG + 2.0 * size]);
    let up: Vec<f64> = lines([LEG - 2.0 * size, LEG + 0.1]);
    // A line at the load.
    let near =
        (1..across.len() - 1).min_by(|&a, &b| (across[a] - LOAD).abs().total_cmp(&(across[b] - LOAD).abs()));
    if let Some(near) = near {
        across[near] = LOAD;
    }
    let plate = Plate::bricks([&across, &up], THICK, stands);
    match lie {
        Lie::Turned(angle) => plate.moved(|x| turned(x, angle)),
        _ => plate,
    }
}

/// Where a node goes so that the lines in the leg beside the corner are turned by an angle; edges go onto themselves.
fn turned([x, z]: [f64; 2], angle: f64) -> [f64; 2] {
    let slope = angle.tan();
    // Rows lean left of the corner alone; the arm's underside stays.
    let rows = slope * (LEG - x).max(0.0) * within(z, [0.0, LEG - 0.02, LEG + 0.1, EDGE]);
    // Columns lean above the corner alone; the left edge stays.
    let columns = slope
        * (z - LEG).max(0.0)
        * within(x, [0.0, 0.05, LEG, EDGE])
        * within(z, [0.0, LEG, LEG + 0.1, EDGE]);
    [x + columns, z - rows]
}

/// The test, on such a mesh.
///
/// # Errors
/// If the panel does not come to rest.
pub fn test(
    plate: &Plate,
    mix: Mix,
    words: &'static Words,
    quadrature: Quadrature,
    ramp: u64,
    ways: Vec<f64>,
) -> Result<Tested, VerifyError> {
    Specimen {
        plate,
        mix,
        words,
        quadrature,
        sound: &|x| (x[0] - LOAD).hypot(x[1] - LEG) < ROLLER,
        grips: vec![
            Grip {
                nodes: &|x| (x[0] - LOAD).abs() < 1e-9 && (x[1] - LEG).abs() < 1e-9,
                share: [None, None, Some(1.0)],
            },
            Grip { nodes: &|x| x[1].abs() < 1e-9, share: [Some(0.0); 3] },
        ],
        bolts: Vec::new(),
        gauge: None,
        ramp,
        ways,
    }
    .run()
}

/// Ways \[m\] to 1 mm: finer to where the crack has run through most of the leg.
pub fn ways(fine: f64) -> Vec<f64> {
    super::steps(&[(0.05e-3, 0.05e-3), (0.25e-3, fine), (0.5e-3, 2.5 * fine), (1e-3, 6.25 * fine)])
}

/// Cycles over which a stage goes its way: waves need more of them to cross finer elements, and the force that the relaxation's damping
/// adds on the way falls as they grow. At 200 a mesh of 5 mm cracks beside its crack and bears 4 % more.
pub fn ramp(size: f64) -> u64 {
    (1000.0 * (0.01 / size).max(1.0)).round() as u64
}

/// What the crack should have taken \[J\] by how far it is open, and the share of the leg's section that this stands for.
///
/// Each column of nodes is a gauge across the crack, about 30 mm to either side. What it opens, less what concrete under the crack's
/// own stress stretches there, is the width w of the crack; there G_f \[1 − (1 + ½w/w_f) exp(−w/w_f)\] went. So what is not yet fully open
/// counts with its own share, and where the crack runs aslant the width falls as its length grows.
pub fn crack(plate: &Plate, tested: &Tested, mix: &Mix) -> [f64; 2] {
    let row = |z: f64| plate.points[plate.nearest([0.0, z]) as usize][1];
    let (low, high) = (row(LEG - 0.03), row(LEG + 0.03));
    let up = |x: f64, z: f64| {
        plate.between([x, z]).iter().map(|&(n, share)| share * tested.moved[n as usize][1]).sum::<f64>()
    };
    let mut columns: Vec<f64> = plate
        .points
        .iter()
        .filter(|x| (x[1] - low).abs() < 1e-9 && x[0] < LEG + 1e-9)
        .map(|x| x[0])
        .collect();
    columns.sort_by(f64::total_cmp);
    let taken = columns.iter().map(|&x| {
        let apart = up(x, high) - up(x, low);
        let stretch = mix.tension * (high - low) / mix.young;
        // The stretch falls as w grows, slower than w grows.
        let (mut least, mut most) = (0.0, apart.max(0.0));
        for _ in 0..60 {
            let w = 0.5 * (least + most);
            if w + stretch * (-w * mix.tension / mix.energy).exp() < apart { least = w } else { most = w }
        }
        mix.taken(least)
    });
    let taken: Vec<f64> = taken.collect();
    let sum: f64 =
        (1..columns.len()).map(|i| 0.5 * (taken[i] + taken[i - 1]) * (columns[i] - columns[i - 1])).sum();
    [THICK * sum, sum / (mix.energy * LEG)]
}
