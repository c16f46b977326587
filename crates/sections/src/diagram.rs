//! All N and M that a section's limits of strain allow.

use crate::Section;

/// Even points of the border from pure compression to pure tension, for each side that may be compressed most. With the corners beside
/// them a chord is off the border by less than 10⁻⁴ of the section's strength.
const POINTS: usize = 160;
/// Even points more where steel is at its limit of strain, which is reached long before the concrete's is left.
const STRAINED: usize = 400;

/// The border of what a section with steel bears: a closed line through (N, M), in their units.
///
/// Its points are states at a limit of strain (EN 1992-1-1 6.1 (3), figure 6.1): the concrete's ultimate strain at the face that is
/// compressed most, ε_c2 at the depth (1 − ε_c2/ε_cu2) h where all is compressed, or the strain at which steel breaks. The points
/// are joined by chords, which lie inside where the border is convex.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagram {
    points: Vec<[f64; 2]>,
}

impl Diagram {
    /// The border of a section.
    pub fn of(section: &Section) -> Self {
        let mut points = Vec::with_capacity(2 * POINTS + 2);
        // Compressed most at the extrados, as by a positive moment, from compression to tension; back with the other side.
        points.extend(parameters(section, -1.0).into_iter().map(|at| state(section, -1.0, at)));
        points.extend(parameters(section, 1.0).into_iter().rev().map(|at| state(section, 1.0, at)));
        Diagram { points }
    }

    /// The line's points, in their order round it; the last is the first again.
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// Utilisation by proportional loading: 1 where (N, M) is on the border, infinite where nothing on its ray is borne.
    pub fn utilisation(&self, [n, m]: [f64; 2]) -> f64 {
        if n == 0.0 && m == 0.0 {
            return 0.0;
        }
        let mut farthest: f64 = 0.0;
        for pair in self.points.windows(2) {
            let ([a, b], [c, d]) = (pair[0], pair[1]);
            // Either end to one side of the ray's line: positive where it is to the left.
            let (from, to) = (n * b - m * a, n * d - m * c);
            if (from > 0.0) == (to > 0.0) && from != 0.0 && to != 0.0 {
                continue;
            }
            // A chord along the ray ends at both of its ends.
            let shares = if from == to { [0.0, 1.0] } else { [from / (from - to); 2] };
            for share in shares {
                let at = [a + share * (c - a), b + share * (d - b)];
                farthest = farthest.max((at[0] * n + at[1] * m) / (n * n + m * m));
            }
        }
        1.0 / farthest
    }
}

/// Up to here all is compressed, and up to there the concrete's ultimate strain governs where steel can break.
const WHOLE: f64 = 0.25;
const BENT: f64 = 0.85;

/// Parameters of the points: even ones, and those where a layer begins to yield, at which the border has a corner.
fn parameters(section: &Section, side: f64) -> Vec<f64> {
    let concrete = &section.concrete;
    let (least, end) = least_share(section, side);
    let mut all: Vec<f64> = (0..=POINTS).map(|k| k as f64 / POINTS as f64).collect();
    if end < 1.0 {
        all.extend((1..STRAINED).map(|k| end + (1.0 - end) * k as f64 / STRAINED as f64));
    }
    for layer in &section.layers {
        for yields in [-1.0, 1.0] {
            let slope =
                (concrete.ultimate + yields * layer.yields / layer.young) / down(section, side, layer.depth);
            let run = (1.0 - concrete.ultimate / (slope * section.thickness)) / (1.0 - least);
            if (0.0..1.0).contains(&run) {
                all.push(WHOLE + run * (end - WHOLE));
            }
        }
    }
    all.sort_by(f64::total_cmp);
    all
}

/// Depth \[m\] from the most compressed face.
fn down(section: &Section, side: f64, y: f64) -> f64 {
    0.5 * section.thickness - side * y
}

/// Slope of strain \[1/m\] at which a layer of steel breaks while the face has this strain; infinite where none does.
fn breaking(section: &Section, side: f64, face: f64) -> f64 {
    let each = section.layers.iter().filter(|l| l.breaks.is_finite());
    each.map(|l| (l.breaks - face) / down(section, side, l.depth)).fold(f64::INFINITY, f64::min)
}

/// The smallest share of the depth that is compressed while the concrete's ultimate strain governs, and the parameter there.
fn least_share(section: &Section, side: f64) -> (f64, f64) {
    let ultimate = section.concrete.ultimate;
    let steepest = breaking(section, side, -ultimate);
    (ultimate / (steepest * section.thickness), if steepest.is_infinite() { 1.0 } else { BENT })
}

/// The state of the border at a parameter from 0, pure compression, to 1, pure tension, compressed most at the intrados (`side` 1)
/// or the extrados (−1).
fn state(section: &Section, side: f64, at: f64) -> [f64; 2] {
    let (thickness, concrete) = (section.thickness, &section.concrete);
    // Strain face + slope · depth from that face.
    let plane = |face: f64, slope: f64| section.forces(face + 0.5 * slope * thickness, -side * slope);
    // As long as all is compressed: through ε_c2 at its pivot.
    if at <= WHOLE {
        let pivot = (1.0 - concrete.plateau / concrete.ultimate) * thickness;
        let face = concrete.plateau + at / WHOLE * (concrete.ultimate - concrete.plateau);
        return plane(-face, (face - concrete.plateau) / pivot);
    }
    let (least, end) = least_share(section, side);
    if at <= end {
        // Through ε_cu2 at the face: by the share of the depth that is compressed, 1 to 0 or to where steel breaks.
        let share = 1.0 + (at - WHOLE) / (end - WHOLE) * (least - 1.0);
        if share <= 0.0 {
            // All steel is pulled without end.
            let pulled = |l: &crate::Layer| [l.area * l.yields, l.area * l.yields * l.depth];
            return section.layers.iter().map(pulled).fold([0.0; 2], |s, f| [s[0] + f[0], s[1] + f[1]]);
        }
        return plane(-concrete.ultimate, concrete.ultimate / (share * thickness));
    }
    // Through the strain at which steel breaks, to where all of the section has it.
    let last = section.layers.iter().map(|l| l.breaks).fold(f64::INFINITY, f64::min);
    let face = -concrete.ultimate + (at - BENT) / (1.0 - BENT) * (last + concrete.ultimate);
    plane(face, breaking(section, side, face).max(0.0))
}
