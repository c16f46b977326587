//! Motion on a section without what moves as a whole: that strains a lining.

/// A piece of the section: its area, and its corners (x, z) with their displacements along x and z.
pub struct Moved {
    pub area: f64,
    pub corners: Vec<([f64; 2], [f64; 2])>,
}

/// What all pieces have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rigid {
    /// A place, how it moves, and how much the section turns about it \[rad\]: from x to z.
    about: [f64; 2],
    shift: [f64; 2],
    turn: f64,
}

impl Rigid {
    /// The mean motion and turn of pieces, by their areas: what is left of displacements then is least in the square.
    pub fn of(pieces: &[Moved]) -> Rigid {
        let mean = |piece: &Moved| {
            let n = piece.corners.len().max(1) as f64;
            let sum = piece
                .corners
                .iter()
                .fold([0.0; 4], |s, (at, u)| [s[0] + at[0], s[1] + at[1], s[2] + u[0], s[3] + u[1]]);
            (piece.area, sum.map(|c| c / n))
        };
        let means: Vec<(f64, [f64; 4])> =
            pieces.iter().map(mean).filter(|m| m.1.iter().all(|c| c.is_finite())).collect();
        let area: f64 = means.iter().map(|(area, _)| area).sum();
        let all = [0, 1, 2, 3]
            .map(|i| means.iter().map(|(area, m)| area * m[i]).sum::<f64>() / area.max(f64::MIN_POSITIVE));
        let [x, z, ux, uz] = all;
        let (mut turning, mut inertia) = (0.0, 0.0);
        for (area, m) in &means {
            let [dx, dz] = [m[0] - x, m[1] - z];
            turning += area * (dx * (m[3] - uz) - dz * (m[2] - ux));
            inertia += area * (dx * dx + dz * dz);
        }
        let turn = if inertia > 0.0 { turning / inertia } else { 0.0 };
        Rigid { about: [x, z], shift: [ux, uz], turn }
    }

    /// What is left of a displacement.
    pub fn rest(&self, at: [f64; 2], moved: [f64; 2]) -> [f64; 2] {
        let [dx, dz] = [at[0] - self.about[0], at[1] - self.about[1]];
        [moved[0] - self.shift[0] + self.turn * dz, moved[1] - self.shift[1] - self.turn * dx]
    }

    /// How far it moves as a whole.
    pub fn shift(&self) -> f64 {
        self.shift[0].hypot(self.shift[1])
    }
}

/// The round factor 1, 2 or 5 × 10ⁿ by which motions up to `most` come nearest to `wanted` from below; 1 where nothing moves.
pub fn exaggeration(most: f64, wanted: f64) -> f64 {
    let ratio = wanted / most;
    if !ratio.is_finite() || ratio <= 0.0 {
        return 1.0;
    }
    let power = 10_f64.powf((ratio.log10() + 1e-9).floor());
    [5.0, 2.0, 1.0]
        .into_iter()
        .map(|f| f * power)
        .find(|factor| *factor <= ratio * (1.0 + 1e-9))
        .unwrap_or(power)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Squares of a grid of unlike sizes that move as `motion` says.
    fn grid(motion: impl Fn([f64; 2]) -> [f64; 2]) -> Vec<Moved> {
        let ends = [0.0, 1.0, 3.0, 7.0, 15.0];
        let square = |i: usize, j: usize| {
            let (x, z) = ([ends[i], ends[i + 1]], [ends[j] - 200.0, ends[j + 1] - 200.0]);
            let corners = [[x[0], z[0]], [x[1], z[0]], [x[1], z[1]], [x[0], z[1]]];
            Moved {
                area: (x[1] - x[0]) * (z[1] - z[0]),
                corners: corners.map(|at| (at, motion(at))).to_vec(),
            }
        };
        (0..16).map(|k| square(k / 4, k % 4)).collect()
    }

    fn most(pieces: &[Moved], rigid: Rigid) -> f64 {
        let all = pieces.iter().flat_map(|piece| &piece.corners);
        all.map(|(at, u)| rigid.rest(*at, *u)).map(|[x, z]| x.hypot(z)).fold(0.0, f64::max)
    }

    #[test]
    fn nothing_is_left_of_a_rigid_motion() {
        let pieces = grid(|[x, z]| [0.04 - 1e-4 * z, 0.01 + 1e-4 * x]);
        let rigid = Rigid::of(&pieces);
        assert!(most(&pieces, rigid) < 1e-15, "{}", most(&pieces, rigid));
        assert!(rigid.shift() > 0.05);
    }

    #[test]
    fn shear_is_left_without_its_turn() {
        // γ = 10⁻³: half of it is strain on both sides.
        let rigid = Rigid::of(&grid(|[_, z]| [1e-3 * z, 0.0]));
        let at = [rigid.about[0] + 2.0, rigid.about[1] + 6.0];
        let rest = rigid.rest(at, [1e-3 * at[1], 0.0]);
        assert!((rest[0] - 3e-3).abs() < 1e-4 && (rest[1] - 1e-3).abs() < 1e-4, "{rest:?}");
    }

    #[test]
    fn factors_are_round_and_do_not_overshoot() {
        for (most, wanted, factor) in
            [(1e-3, 2.1, 2000.0), (1e-3, 1.99, 1000.0), (0.01, 5.0, 500.0), (0.5, 0.1, 0.2), (0.0, 1.0, 1.0)]
        {
            assert!((exaggeration(most, wanted) / factor - 1.0).abs() < 1e-12, "{most} {wanted}");
        }
    }
}
