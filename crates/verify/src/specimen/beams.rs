//! Notched beams in bending on three points: that of Grégoire et al. (2013) with its notch in the middle, and that of García-Álvarez
//! et al. (2012) with its notch beside, where the crack leans.
//!
//! A notch is a column of elements that is left out, so a crack begins in the element above it. One support is a hinge and one a
//! roller; so is the load, 5 mm wide at most. Elements beside supports stay elastic, as what rollers press is not tested.

use super::plate::{Plate, graded, within};
use super::{Grip, Mix, Specimen, Tested, Words};
use crate::VerifyError;
use tremolite::Quadrature;

/// A beam \[m\].
#[derive(Clone, Copy, Debug)]
pub struct Beam {
    pub length: f64,
    pub depth: f64,
    pub width: f64,
    pub span: f64,
    pub notch: f64,
    /// How far the notch is beside the middle.
    pub beside: f64,
    /// Distance of the two points whose motion apart is the opening of the notch's mouth.
    pub gauge: f64,
    /// Elements within this distance of the load, and of supports, stay elastic \[m\].
    pub firm: [f64; 2],
    pub mix: Mix,
}

/// `gregoire2013`, beam 4 with half notch. f_t is from splitting; G_f is Model Code's 73 f_cm^0.18, f_cm 42.3 MPa.
pub const HALF_NOTCHED: Beam = Beam {
    length: 0.175,
    depth: 0.05,
    width: 0.05,
    span: 0.125,
    notch: 0.025,
    beside: 0.0,
    gauge: 0.02,
    // Its crack ends below the load.
    firm: [0.0, 8e-3],
    mix: Mix { young: 37e9, poisson: 0.2, tension: 3.9e6, energy: 143.2, compression: 42.3e6 },
};

/// `garciaalvarez2012`, depth 80 mm, eccentricity 0.625 depths. Span 2.5 depths and notch a quarter of the depth as those have it who
/// computed it before; f_c by Model Code's G_f = 73 f_cm^0.18.
pub const MIXED: Beam = Beam {
    length: 0.25,
    depth: 0.08,
    width: 0.05,
    span: 0.2,
    notch: 0.02,
    beside: 0.05,
    gauge: 0.02,
    firm: [8e-3, 8e-3],
    mix: Mix { young: 33.8e9, poisson: 0.2, tension: 3.5e6, energy: 125.2, compression: 20e6 },
};

/// Half the width of a load \[m\], a hair more.
const PRESS: f64 = 2.501e-3;

impl Beam {
    fn notch_at(&self) -> f64 {
        0.5 * self.length - self.beside
    }

    fn supports(&self) -> [f64; 2] {
        [0.5 * (self.length - self.span), 0.5 * (self.length + self.span)]
    }

    /// Elements of this size \[m\] where the crack runs: one column above the notch and what is `reach` \[m\] beside it.
    pub fn plate(&self, size: f64, reach: [f64; 2]) -> Plate {
        let at = self.notch_at();
        let [left, right] = reach.map(|reach| ((reach / size).ceil() + 0.5) * size);
        let mut across = graded([0.0, self.length], [at - left, at + right], size, 1.3, 0.012);
        let mut meet = |x: f64| {
            let fine = at - left - 1e-9..at + right + 1e-9;
            let inner = (1..across.len() - 1).filter(|&i| !fine.contains(&across[i]));
            if let Some(near) = inner.min_by(|&a, &b| (across[a] - x).abs().total_cmp(&(across[b] - x).abs()))
            {
                across[near] = x;
            }
        };
        self.supports().into_iter().for_each(&mut meet);
        if self.beside > 0.0 && 0.5 * self.length > at + right {
            meet(0.5 * self.length);
        }
        let rows = (self.depth / size).round() as u32;
        let up: Vec<f64> = (0..=rows).map(|k| self.depth * f64::from(k) / f64::from(rows)).collect();
        Plate::bricks([&across, &up], self.width, |x| (x[0] - at).abs() > 0.4 * size || x[1] > self.notch)
    }

    /// The same with the columns above the notch turned by an angle \[rad\] towards the longer part, in full near it and less beside.
    pub fn turned(&self, size: f64, reach: [f64; 2], angle: f64) -> Plate {
        let (at, middle) = (self.notch_at(), 0.5 * self.length);
        let plate = self.plate(size, reach).moved(|[x, z]| {
            let near = within(x, [0.0, at - reach[0], at + reach[1], self.length]);
            [x + angle.tan() * (z - self.notch).max(0.0) * near, z]
        });
        // A node at the load.
        let loaded = plate.points[plate.nearest([middle, self.depth]) as usize];
        plate.moved(|x| if x == loaded { [middle, x[1]] } else { x })
    }

    /// Squares on their corners.
    pub fn diamonds(&self, size: f64) -> Plate {
        let half = self.notch / (2.0 * (0.5 * self.notch * std::f64::consts::SQRT_2 / size).round());
        let numbers = [self.length, self.depth].map(|l| (l / half).round() as usize);
        let at = self.notch_at();
        let plate =
            Plate::diamonds(numbers, half, self.width, |x| (x[0] - at).abs() > half || x[1] > self.notch);
        let ends = self.supports();
        plate.moved(|[x, z]| {
            let near = ends
                .iter()
                .find(|&&end| z < 1e-9 && (2.0 * half * (0.5 * end / half).round() - x).abs() < 0.1 * half);
            near.map_or([x, z], |&end| [end, z])
        })
    }

    /// The test, on such a mesh.
    ///
    /// # Errors
    /// If the beam does not come to rest.
    pub fn test(
        &self,
        plate: &Plate,
        mix: Mix,
        words: &'static Words,
        quadrature: Quadrature,
        ramp: u64,
        ways: Vec<f64>,
    ) -> Result<Tested, VerifyError> {
        let (middle, [left, right]) = (0.5 * self.length, self.supports());
        let low = |x: [f64; 2], at: f64| x[1] < 1e-9 && (x[0] - at).abs() < 1e-9;
        let high = |x: [f64; 2]| x[1] > self.depth - 1e-9;
        let far = |x: [f64; 2], at: [f64; 2]| (x[0] - at[0]).hypot(x[1] - at[1]);
        let nearest = plate
            .points
            .iter()
            .filter(|&&x| high(x))
            .map(|x| (x[0] - middle).abs())
            .fold(f64::INFINITY, f64::min);
        let press = PRESS.max(nearest + 1e-9);
        let (at, half) = (self.notch_at(), 0.5 * self.gauge);
        Specimen {
            plate,
            mix,
            words,
            quadrature,
            sound: &|x| {
                far(x, [middle, self.depth]) < self.firm[0]
                    || far(x, [left, 0.0]).min(far(x, [right, 0.0])) < self.firm[1]
            },
            grips: vec![
                Grip {
                    nodes: &|x| high(x) && (x[0] - middle).abs() <= press,
                    share: [None, None, Some(-1.0)],
                },
                Grip { nodes: &|x| low(x, left), share: [Some(0.0), Some(0.0), Some(0.0)] },
                Grip { nodes: &|x| low(x, right), share: [None, Some(0.0), Some(0.0)] },
            ],
            bolts: Vec::new(),
            gauge: Some([[at - half, 0.0], [at + half, 0.0]]),
            ramp,
            ways,
        }
        .run()
    }

    /// Cycles over which a stage goes its way ([`super::l_panel::ramp`]).
    pub fn ramp(size: f64) -> u64 {
        (1000.0 * (0.0025 / size).max(1.0)).round() as u64
    }

    /// Where the crack runs: x \[m\] of the element of each row above the notch that is stretched most along x, and the row's z.
    pub fn path(&self, plate: &Plate, tested: &Tested) -> Vec<[f64; 2]> {
        let mut nodes: Vec<usize> =
            (0..plate.points.len()).filter(|&n| plate.points[n][1] > self.notch - 1e-9).collect();
        let order = |a: &usize, b: &usize| {
            let [a, b] = [plate.points[*a], plate.points[*b]];
            a[1].total_cmp(&b[1]).then(a[0].total_cmp(&b[0]))
        };
        nodes.sort_by(order);
        let rows = nodes.chunk_by(|&a, &b| (plate.points[a][1] - plate.points[b][1]).abs() < 1e-9);
        rows.filter_map(|row| {
            let stretch = |pair: &&[usize]| tested.moved[pair[1]][0] - tested.moved[pair[0]][0];
            let widest = row.windows(2).max_by(|a, b| stretch(a).total_cmp(&stretch(b)))?;
            let [a, b] = [plate.points[widest[0]], plate.points[widest[1]]];
            Some([0.5 * (a[0] + b[0]), a[1]])
        })
        .collect()
    }
}
