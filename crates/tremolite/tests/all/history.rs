//! Histories of laws, read back point by point.

use crate::block::block;
use crate::ready::Ready;
use tremolite::Law;
use tremolite::history::History;
use tremolite_laws::materials::Elastic;
use tremolite_laws::{BadParameter, Column, Lane, Material, Moduli, Parameter, Point, Sym, Values};

/// Elastic, and remembers its mean stress and twice and three times as much: the same in every frame.
struct Remembers(Elastic, Moduli);

const COLUMNS: [Column; 3] = [
    Column::new("once", "Pa", "mean stress"),
    Column::new("twice", "Pa", "twice the mean stress"),
    Column::new("thrice", "Pa", "three times the mean stress"),
];

impl Material for Remembers {
    const NAME: &'static str = "remembers";
    const SUMMARY: &'static str = "a test's own";
    const SOURCE: &'static str = "none";
    const PARAMETERS: &'static [Parameter] = &[];
    const HISTORY: &'static [Column] = &COLUMNS;
    type History<L: Lane> = [L; 3];

    fn new(_: &Values) -> Result<Self, Vec<BadParameter>> {
        let moduli = Moduli::from_young_poisson(2e9, 0.2);
        Ok(Remembers(Elastic::from_moduli(moduli), moduli))
    }

    fn moduli(&self) -> Moduli {
        self.1
    }

    fn scaled(&self, factor: f64) -> Self {
        let moduli = self.1.scaled(factor);
        Remembers(Elastic::from_moduli(moduli), moduli)
    }

    #[inline(always)]
    fn update<L: Lane>(&self, point: &Point<L>, strain: Sym<L>, _: [L; 3]) -> (Sym<L>, [L; 3]) {
        let (stress, _) = self.0.update(point, strain, []);
        let mean = (stress[0] + stress[1] + stress[2]) * L::splat(1.0 / 3.0);
        (stress, [mean, mean + mean, mean + mean + mean])
    }
}

#[test]
fn every_column_of_every_point_is_found_in_both_quadratures_and_padded_octets() {
    let mut problem = block([5, 3, 7]);
    let material = (Law::of::<Remembers>().build)(&Values::default()).unwrap();
    for body in &mut problem.bodies {
        assert_ne!(body.elements.len() % 8, 0, "the last octet is padded");
        body.material = material.clone();
    }
    problem.patch_elements = Some(24);
    let ready = Ready::new(problem);
    let mut state = ready.rest(0.9);
    let mut engine = ready.engine();
    while state.time() < 0.15 {
        engine.step(&mut state);
    }
    let snapshot = engine.finish(&mut state);
    let history = History::new(&ready.assembly, &state.history);
    let most = snapshot.stress.iter().flatten().fold(0.0_f64, |m, s| m.max(s.abs()));
    let mut points = [0, 0];
    for slot in ready.phase.element_slot.iter().flatten() {
        assert_eq!(history.named(slot, "nothing"), None);
        for (k, column) in COLUMNS.iter().enumerate() {
            let position = history.named(slot, column.name).unwrap();
            let values = history.values(slot, position);
            assert_eq!(values.len(), slot.points as usize);
            for (p, value) in values.enumerate() {
                let s = snapshot.stress[slot.point as usize + p];
                let mean = (s[0] + s[1] + s[2]) / 3.0;
                assert!((value - (k + 1) as f64 * mean).abs() < 1e-9 * most, "{} of {slot:?}", column.name);
                points[usize::from(slot.points == 8)] += 1;
            }
        }
    }
    assert!(points[0] > 100 && points[1] > 100, "{points:?}");
}
