//! The stable step by element, and what the worst elements cost the whole run.

use super::made_of::MadeOf;
use rayon::prelude::*;
use tremolite::hexahedra::hex;
use tremolite_laws::shapes::hex8::element_frequencies;
use tremolite_mesh::Mesh;

/// Elements that one could repair by hand.
pub const FEW: usize = 10;
/// Elements whose step is below this times the smallest share in limiting the run.
pub const NEAR: f64 = 1.25;

/// What each element alone could run with.
pub struct Steps {
    /// 2/ω of each element \[s\]; infinite where no material or no usable shape is.
    of: Vec<f64>,
}

/// The steps of a set of elements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The smallest \[s\], and its element.
    pub step: f64,
    pub element: u32,
    /// The smallest but for the [`FEW`] worst elements \[s\]; the smallest itself if there are no more.
    pub without_few: f64,
    /// What 99 % of the elements could run with \[s\].
    pub percentile: f64,
    /// What half of them could run with \[s\].
    pub median: f64,
    /// How many are below [`NEAR`] times the smallest, it included.
    pub near: usize,
}

impl Steps {
    /// Of all elements that are made of something.
    ///
    /// The highest frequency of one element, free, bounds that of the mesh (Irons & Treharne 1971): a run is never
    /// limited more than by its worst element alone, and as a rule a little less.
    pub fn new(mesh: &Mesh, made: &[MadeOf]) -> Self {
        let mut of = vec![f64::INFINITY; mesh.elements.len()];
        for material in made {
            let steps = material.elements.par_chunks(64).map(|chunk| {
                let usable = chunk.iter().filter_map(|&e| Some((e, hex(mesh, e as usize).ok()?)));
                let (elements, hexes): (Vec<u32>, Vec<_>) = usable.unzip();
                let omegas =
                    element_frequencies(&hexes, material.moduli, material.density, material.quadrature);
                elements.into_iter().zip(omegas.into_iter().map(|omega| 2.0 / omega)).collect::<Vec<_>>()
            });
            for (element, step) in steps.flatten_iter().collect::<Vec<_>>() {
                of[element as usize] = step;
            }
        }
        Steps { of }
    }

    /// Elements without a step.
    pub fn unknown(&self) -> usize {
        self.of.iter().filter(|s| s.is_infinite()).count()
    }

    /// The elements with the smallest steps, worst first.
    pub fn worst(&self, count: usize) -> Vec<u32> {
        let mut known: Vec<u32> =
            (0..).zip(&self.of).filter(|(_, s)| s.is_finite()).map(|(e, _)| e).collect();
        known.sort_by(|&a, &b| self.of[a as usize].total_cmp(&self.of[b as usize]));
        known.truncate(count);
        known
    }

    /// The steps of some elements; nothing if none of them has one.
    pub fn limits(&self, elements: impl Iterator<Item = u32>) -> Option<Limits> {
        let known = elements.map(|e| (self.of[e as usize], e)).filter(|(step, _)| step.is_finite());
        let mut sorted: Vec<(f64, u32)> = known.collect();
        sorted.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let &(step, element) = sorted.first()?;
        let count = sorted.len();
        let at = |index: usize| sorted[index].0;
        Some(Limits {
            step,
            element,
            without_few: at(if count > FEW { FEW } else { 0 }),
            percentile: at(count / 100),
            median: at(count / 2),
            near: sorted.partition_point(|(s, _)| *s < NEAR * step),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::made_of::stand_in;
    use super::*;
    use tremolite_mesh::boxes::BoxSpec;

    #[test]
    fn a_brick_halved_in_one_direction_runs_at_the_step_of_its_three_edges() {
        // Lumped one-point brick with edges h: ω² = 4 Σ c_p²/h² bounds it from above, and the thin direction alone,
        // 4c_p²/h², from below; 40 power iterations reach 1 % from below.
        let mesh = BoxSpec::uniform([0.0; 3], [4.0, 1.0, 1.0], [4, 1, 2]).mesh().unwrap();
        let made = stand_in(&mesh);
        let limits = Steps::new(&mesh, &made).limits(0..8).unwrap();
        let c = made[0].p_wave();
        assert!(
            limits.step <= 1.01 * 0.5 / c && limits.step >= 0.5 / c / 1.5_f64.sqrt(),
            "{}",
            limits.step * c
        );
        assert_eq!((limits.near, limits.without_few), (8, limits.step));
    }

    #[test]
    fn the_cost_of_the_worst_elements_is_the_ratio_of_steps() {
        let of: Vec<f64> =
            (0..1000).rev().map(|e| 1.0 + 0.01 * f64::from(e)).chain([f64::INFINITY]).collect();
        let steps = Steps { of };
        let limits = steps.limits(0..1001).unwrap();
        assert_eq!((limits.step, limits.element, steps.unknown()), (1.0, 999, 1));
        assert_eq!((limits.without_few, limits.percentile, limits.median), (1.1, 1.1, 6.0));
        assert_eq!(limits.near, 25);
        assert_eq!(steps.worst(3), [999, 998, 997]);
        assert_eq!(steps.limits([1000].into_iter()), None);
    }
}
