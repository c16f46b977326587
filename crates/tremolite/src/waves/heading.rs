//! Where a plane wave goes and what it moves.

use super::rock::Rock;

/// The kind of a wave.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WaveType {
    /// Moves along its way d.
    P,
    /// Moves along h cos θ − z sin θ.
    Sv,
    /// Moves along t = z × h.
    Sh,
}

/// Type and way of a wave, in the model's axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heading {
    pub kind: WaveType,
    /// θ from the vertical \[rad\], at least 0 and below a right angle.
    pub angle: f64,
    /// h, of length 1: where it goes in plan.
    pub along: [f64; 2],
}

impl WaveType {
    /// As it is written.
    pub fn word(self) -> &'static str {
        match self {
            WaveType::P => "P",
            WaveType::Sv => "SV",
            WaveType::Sh => "SH",
        }
    }

    /// Its speed in a rock \[m/s\].
    pub fn speed(self, rock: &Rock) -> f64 {
        if self == WaveType::P { rock.p } else { rock.s }
    }
}

impl Heading {
    /// By the azimuth ψ of its way, and the azimuth of the model's x axis, both clockwise from north \[rad\].
    pub fn new(kind: WaveType, angle: f64, azimuth: f64, model_x_azimuth: f64) -> Heading {
        // A quarter of a turn in radians is none by 10⁻¹⁶: what stands still along an axis should.
        let whole = |x: f64| if x.abs() < 1e-15 { 0.0 } else { x };
        // y points a quarter of a turn counter-clockwise from x.
        let (sin, cos) = (azimuth - model_x_azimuth).sin_cos();
        Heading { kind, angle, along: [whole(cos), -whole(sin)] }
    }

    /// d, its way.
    pub fn way(&self) -> [f64; 3] {
        let (sin, cos) = self.angle.sin_cos();
        [sin * self.along[0], sin * self.along[1], cos]
    }

    /// t = z × h.
    pub fn across(&self) -> [f64; 2] {
        [-self.along[1], self.along[0]]
    }

    /// What it moves, of length 1.
    pub fn polarisation(&self) -> [f64; 3] {
        let (sin, cos) = self.angle.sin_cos();
        let [x, y] = self.along;
        match self.kind {
            WaveType::P => self.way(),
            WaveType::Sv => [cos * x, cos * y, -sin],
            WaveType::Sh => [-y, x, 0.0],
        }
    }

    /// What one of each component of displacement of a series moves along x, y and z.
    pub fn motion(&self) -> [[f64; 4]; 4] {
        let [x, y] = self.along;
        match self.kind {
            // (u_t)
            WaveType::Sh => [[-y, x, 0.0, 0.0], [0.0; 4], [0.0; 4], [0.0; 4]],
            // (u_h, u_z)
            _ => [[x, y, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0; 4], [0.0; 4]],
        }
    }

    /// The stress xx, yy, zz, xy, yz, zx of one of each component of stress.
    pub fn stress(&self) -> [[f64; 6]; 4] {
        let [x, y] = self.along;
        match self.kind {
            // (σ_ht, σ_tz)
            WaveType::Sh => [
                [-2.0 * x * y, 2.0 * x * y, 0.0, x * x - y * y, 0.0, 0.0],
                [0.0, 0.0, 0.0, 0.0, x, -y],
                [0.0; 6],
                [0.0; 6],
            ],
            // (σ_hh, σ_tt, σ_zz, σ_hz)
            _ => [
                [x * x, y * y, 0.0, x * y, 0.0, 0.0],
                [y * y, x * x, 0.0, -x * y, 0.0, 0.0],
                [0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
                [0.0, 0.0, 0.0, 0.0, y, x],
            ],
        }
    }

    /// p = sin θ/c in the rock of the base \[s/m\].
    pub fn slowness(&self, base: &Rock) -> f64 {
        self.angle.sin() / self.kind.speed(base)
    }
}
