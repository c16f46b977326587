//! What strength the law leaves where stress concentrates: at corners, holes and tips of cracks.

use super::{Concrete, Evolution, grade};

impl Concrete {
    /// See [`crate::Material::corner_strength`]; none for the crack band, which keeps G_f and strength apart from the mesh.
    ///
    /// At the tip of a crack the stress is K/√(2πr), and its mean over an element of extent h is K √(2/(πh)). The element
    /// breaks when this reaches f_t and drops to α f_t at once, so that K grows to f_t √(πh/2) where it should grow to
    /// √(E G_f) = f_t √l_ch, l_ch = E G_f/f_t²: a share √(πh/(2 l_ch)) of it. α f_t goes on being carried, and only the rest
    /// is subject to this:
    ///
    /// strength over the right one = α + (1 − α) √(πh/(2 l_ch)), at most 1, which it is from h = 2 l_ch/π on.
    ///
    /// The L-shaped panel (`winkler2001`; E 25.85 GPa, f_t 2.7 MPa, G_f 65 N/m, α 0.1, measured peak 7,219 N) bears 4,307, 2,974 and 2,213 N
    /// in elements of 25, 10 and 5 mm (verification problem `l_panel`), so 0.60, 0.41 and 0.31; this gives 0.47, 0.34 and 0.27, less by a fifth to
    /// an eighth, since a corner of 270° concentrates stress less than the end of a crack (r^−0.456). G_f is the given one, in
    /// whatever the plateau's length; where ε_us alone is given, G_f grows with the element and so is no measure, and
    /// that of Model Code 2010 by f_c stands for it.
    pub(super) fn strength_at_a_corner(&self, extent: f64) -> Option<f64> {
        let energy = match self.evolution {
            Evolution::Exponential { .. } => return None,
            Evolution::Energy { energy } => energy,
            Evolution::Ratio { .. } => grade::fracture_energy(self.fc),
        };
        let length = energy * self.young / (self.ft * self.ft);
        let drops = (std::f64::consts::FRAC_PI_2 * extent / length).sqrt().min(1.0);
        Some(self.alpha + (1.0 - self.alpha) * drops)
    }
}
