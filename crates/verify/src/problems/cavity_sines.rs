//! A round cavity in a space without end, under steady P waves.
//!
//! Pao and Mow's solution (`pao1973`, `scattering`) concentrates the incident stress σ₀ at the wall beside the cavity by
//! 8/3 where the wave is long, by 2.91 at most, at ka = ωa/c_p = 0.255, and by less where it is shorter (ν = ¼). Three waves at
//! once go through the model (`full_space`), and σ_θ all round is found in amplitude and phase over their common
//! period, once all is steady.
//!
//! What errs is the box: sides and top know the ground without the cavity, so what it scatters meets dashpots alone. For long waves
//! these are no more than the edge of a block under the stresses from far away, which errs by (a/L)²; for others they send back
//! what meets them aslant, and it comes back weaker by a root of the way. Mesh and step err with order 2, by the angle of an
//! element at the wall and by the wave's delay, ⅟₂₄(kh)²kL; so a larger box asks for a finer mesh.

use crate::convergence::order;
use crate::full_space::{BARE, Slice};
use crate::scattering::Cavity;
use crate::{Check, Effort, Verification, VerifyError};

const NAME: &str = "cavity_sines";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "round cavity in full space under steady P waves: hoop stress all round in amplitude and phase",
    source: "`pao1973`",
    from: Effort::Test,
    run,
};

const SERIES: Series = Series {
    name: NAME,
    cavity: BARE,
    fundamental: 0.05,
    waves: &[(2, "ka = 0.1"), (5, "ka = 0.25"), (10, "ka = 0.5")],
};

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = SERIES.boxes(10, &[8.0, 16.0])?;
    if effort == Effort::Full {
        checks.extend(SERIES.boxes(20, &[8.0, 16.0, 32.0])?);
        checks.extend(SERIES.meshes([10, 20], 32.0)?);
    }
    Ok(checks)
}

/// Steady waves at a cavity: multiples of a ka, with the words for messages.
pub(super) struct Series {
    pub name: &'static str,
    pub cavity: Cavity,
    pub fundamental: f64,
    pub waves: &'static [(u32, &'static str)],
}

impl Series {
    /// Boxes one larger than the other, by half their width over the radius, with so many elements along the square round the
    /// cavity.
    pub fn boxes(&self, elements: u32, boxes: &[f64]) -> Result<Vec<Check>, VerifyError> {
        let errors: Result<Vec<_>, _> = boxes.iter().map(|reach| self.errors(elements, *reach)).collect();
        let (errors, around) = (errors?, 4 * elements);
        let mut checks = Vec::new();
        for (pair, reach) in errors.windows(2).zip(boxes.windows(2)) {
            for (k, (_, wave)) in self.waves.iter().enumerate() {
                let (before, error) = (pair[0][k], pair[1][k]);
                let p = order(before, error, reach[1] / reach[0]);
                let quantity = format!(
                    "error of hoop stress over its peak, {wave}, box of {} radii, {around} around",
                    reach[1]
                );
                let note = "3 %: 1 to 2 % are the box's at 16 radii, and fall with it";
                checks.push(Check::new(self.name, quantity, error, 0.0, 0.03, "1", note).with_order(p));
                let quantity = format!(
                    "error with a box of {} radii over that with {}, {wave}, {around} around",
                    reach[1], reach[0]
                );
                let note = "below 1: a larger box errs less";
                checks
                    .push(Check::new(self.name, quantity, error / before, 0.0, 1.0, "1", note).with_order(p));
            }
        }
        Ok(checks)
    }

    /// Two meshes in one box.
    pub fn meshes(&self, [coarse, fine]: [u32; 2], reach: f64) -> Result<Vec<Check>, VerifyError> {
        let [before, errors] = [self.errors(coarse, reach)?, self.errors(fine, reach)?];
        let one = |((before, error), (_, wave)): ((&f64, &f64), &(u32, &str))| {
            let p = order(*before, *error, f64::from(fine) / f64::from(coarse));
            let quantity = format!(
                "error with {} around over that with {}, {wave}, box of {reach} radii",
                4 * fine,
                4 * coarse
            );
            let note = "below 1: a finer mesh errs less";
            Check::new(self.name, quantity, error / before, 0.0, 1.0, "1", note).with_order(p)
        };
        Ok(before.iter().zip(&errors).zip(self.waves).map(one).collect())
    }

    /// Largest error all round of σ_θ over its largest amplitude, by wave.
    fn errors(&self, elements: u32, reach: f64) -> Result<Vec<f64>, VerifyError> {
        // Of the coarsest elements eighteen go on an S wave of ka = 0.5; of larger ones what is scattered is sent back in part.
        let slice = Slice { cavity: self.cavity, elements, layers: 1, reach, coarsest: 0.4 };
        let multiples: Vec<u32> = self.waves.iter().map(|(multiple, _)| *multiple).collect();
        slice.sines(self.fundamental, &multiples, SETTLE)
    }
}

/// Times in which the wave travels a radius, until all is steady: twice as many change the errors by 3 % of them.
const SETTLE: f64 = 100.0;
