//! Width of cracks of a reinforced section under lasting thrust and moment: EN 1992-1-1 7.3.4.

use crate::{Layer, Section};

/// What crack widths need beside the section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrackRule {
    /// E_cm \[Pa\].
    pub young: f64,
    /// f_ctm \[Pa\].
    pub tension: f64,
    /// Diameter of the bars \[m\].
    pub diameter: f64,
}

/// A crack by the code, and what it is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Crack {
    /// w_k \[m\]; infinite where bars yield, for which the clause has no width.
    pub width: f64,
    /// σ_s of the bars next to the face that opens \[Pa\].
    pub stress: f64,
    /// s_r,max \[m\].
    pub spacing: f64,
    /// Depth of what is compressed \[m\]; 0 where all is pulled.
    pub compressed: f64,
}

/// k_t of lasting loads, k_1 of bars with high bond, and the recommended k_3 and k_4.
const LASTING: f64 = 0.4;
const BOND: f64 = 0.8;
const COVERS: f64 = 3.4;
const DIAMETERS: f64 = 0.425;
/// Least share of σ_s/E_s that opens a crack.
const LEAST: f64 = 0.6;
/// Newton's steps, of which few are needed.
const STEPS: usize = 60;

impl CrackRule {
    /// E_cm and f_ctm by table 3.1 from f_ck \[Pa\], up to C50/60.
    pub fn en(characteristic: f64, diameter: f64) -> Self {
        let f = characteristic / 1e6;
        CrackRule { young: 22e9 * ((f + 8.0) / 10.0).powf(0.3), tension: 0.3e6 * f.powf(2.0 / 3.0), diameter }
    }

    /// The crack of a section at N \[N/m\] and M \[N m/m\], at the face that opens more. The section is taken as cracked: plane, concrete
    /// elastic in compression and without tension, bars elastic. Zero where no bar is pulled; nothing where they cannot hold the forces, or a
    /// face opens that has none.
    pub fn crack(&self, section: &Section, state: [f64; 2]) -> Option<Crack> {
        let (middle, curvature) = self.strains(section, state)?;
        let bare = |side: f64| {
            let opens = middle + curvature * side * 0.5 * section.thickness > 0.0;
            opens && !section.layers.iter().any(|l| side * l.depth > 0.0)
        };
        if bare(1.0) || bare(-1.0) {
            return None;
        }
        let each = [1.0, -1.0].map(|side| self.at(section, middle, curvature, side));
        each.into_iter().flatten().max_by(|a, b| a.width.total_cmp(&b.width)).or(Some(Crack::default()))
    }

    /// At the intrados (`side` 1) or the extrados (−1); nothing where its bars are not pulled.
    fn at(&self, section: &Section, middle: f64, curvature: f64, side: f64) -> Option<Crack> {
        let h = section.thickness;
        let half = 0.5 * h;
        let strain = |y: f64| middle + curvature * y;
        let (near, far) = (strain(side * half), strain(-side * half));
        // The bars next to the face.
        let next = section.layers.iter().max_by(|a, b| (side * a.depth).total_cmp(&(side * b.depth)))?;
        let stress = next.young * strain(next.depth);
        if near <= 0.0 || stress <= 0.0 {
            return None;
        }
        let compressed = if far >= 0.0 { 0.0 } else { h * far / (far - near) };
        // h_c,ef (7.3.2 (3)); where all is pulled figure 7.1 c.
        let to_face = half - side * next.depth;
        let third = if compressed > 0.0 { (h - compressed) / 3.0 } else { f64::INFINITY };
        let effective = (2.5 * to_face).min(third).min(half);
        let within = |l: &&Layer| half - side * l.depth <= effective.max(to_face);
        let area: f64 = section.layers.iter().filter(within).map(|l| l.area).sum();
        let share = area / effective;
        let ratio = next.young / self.young;
        // (7.9), (7.11), (7.13), (7.14).
        let stiffened = (stress - LASTING * self.tension / share * (1.0 + ratio * share)) / next.young;
        let mean = stiffened.max(LEAST * stress / next.young);
        let cover = to_face - 0.5 * self.diameter;
        // k_2 is of the section, by the greater strain of both faces, at the face that opens less too.
        let bent = (near.max(far) + near.min(far).max(0.0)) / (2.0 * near.max(far));
        let between = 0.25 * std::f64::consts::PI * self.diameter * self.diameter / next.area;
        let spacing = if between <= 5.0 * (cover + 0.5 * self.diameter) {
            COVERS * cover + BOND * bent * DIAMETERS * self.diameter / share
        } else {
            1.3 * (h - compressed)
        };
        let width = if stress > next.yields { f64::INFINITY } else { spacing * mean };
        Some(Crack { width, stress, spacing, compressed })
    }

    /// Strain of the middle and curvature of the cracked section, the lowest point of its energy less the work of N and M, which is convex.
    fn strains(&self, section: &Section, [n, m]: [f64; 2]) -> Option<(f64, f64)> {
        let h = section.thickness;
        let size = n.abs().max(m.abs() / h);
        if section.layers.is_empty() || !size.is_finite() {
            return None;
        }
        // Begin with the whole section.
        let (axial, bending) = (self.young * h, self.young * h * h * h / 12.0);
        let mut at = [n / axial, m / bending];
        for _ in 0..STEPS {
            let ([[a, b], [_, c]], [fn_, fm]) = self.tangent(section, at);
            let out = [n - fn_, m - fm];
            if out[0].abs().max(out[1].abs() / h) <= 1e-9 * size {
                return Some((at[0], at[1]));
            }
            let determinant = a * c - b * b;
            if determinant <= 1e-12 * a * c {
                return None;
            }
            let step = [(c * out[0] - b * out[1]) / determinant, (a * out[1] - b * out[0]) / determinant];
            // The energy falls along the step: shorten it until it does.
            let energy = |x: [f64; 2]| self.energy(section, x) - n * x[0] - m * x[1];
            let before = energy(at);
            let mut share = 1.0;
            let moved = |share: f64| [at[0] + share * step[0], at[1] + share * step[1]];
            while share > 1e-6 && energy(moved(share)) > before {
                share *= 0.5;
            }
            at = moved(share);
        }
        None
    }

    /// ∂(N, M)/∂(strain of the middle, curvature), and N and M.
    fn tangent(&self, section: &Section, [middle, curvature]: [f64; 2]) -> ([[f64; 2]; 2], [f64; 2]) {
        let (from, to) = pressed(section.thickness, middle, curvature);
        let (l, s, i) = (to - from, 0.5 * (to * to - from * from), (to.powi(3) - from.powi(3)) / 3.0);
        let mut k = [l, s, i].map(|x| self.young * x);
        for layer in &section.layers {
            let stiffness = layer.area * layer.young;
            k = [
                k[0] + stiffness,
                k[1] + stiffness * layer.depth,
                k[2] + stiffness * layer.depth * layer.depth,
            ];
        }
        let [a, b, c] = k;
        ([[a, b], [b, c]], [a * middle + b * curvature, b * middle + c * curvature])
    }

    fn energy(&self, section: &Section, at: [f64; 2]) -> f64 {
        let (_, [n, m]) = self.tangent(section, at);
        0.5 * (n * at[0] + m * at[1])
    }
}

/// The depths between which a section is compressed.
fn pressed(thickness: f64, middle: f64, curvature: f64) -> (f64, f64) {
    let half = 0.5 * thickness;
    let strain = |y: f64| middle + curvature * y;
    match (strain(-half) < 0.0, strain(half) < 0.0) {
        (true, true) => (-half, half),
        (false, false) => (0.0, 0.0),
        (true, false) => (-half, -middle / curvature),
        (false, true) => (-middle / curvature, half),
    }
}
