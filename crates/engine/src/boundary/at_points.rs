//! What any given free field pushes with: its stress at the points of faces.

use super::matrix::times;
use crate::free_field::{End, GivenField, Place, Pushes};
use std::collections::BTreeMap;
use std::sync::Arc;
use tremolite_laws::Row;

/// Stresses at all points of some places, each once though up to four nodes share it.
pub struct AtPoints {
    field: Arc<dyn GivenField>,
    /// m, and the normals there.
    points: Vec<[f64; 3]>,
    normals: Vec<[f64; 3]>,
    /// Place after place, which points are its own, with N dA \[m²\], and where those of each end: one piece of memory, which is gone
    /// through in every step.
    shares: Vec<(u32, f64)>,
    share_ends: Vec<usize>,
    /// By place what it takes beside, at edges of the model.
    ends: Vec<Vec<(u32, End)>>,
}

impl AtPoints {
    pub fn new(field: Arc<dyn GivenField>, places: &[&Place]) -> Self {
        let (mut points, mut normals, mut known) = (Vec::new(), Vec::new(), BTreeMap::new());
        let mut number = |at: [f64; 3], normal: [f64; 3]| -> u32 {
            // The middle of a triangle's edge is one of its neighbour too, which beyond an edge of the model has another normal.
            let key = (at.map(f64::to_bits), normal.map(|x| (1e3 * x).round() as i64));
            *known.entry(key).or_insert_with(|| {
                points.push(at);
                normals.push(normal);
                points.len() as u32 - 1
            })
        };
        let (mut shares, mut share_ends, mut ends) = (Vec::new(), Vec::new(), Vec::new());
        for place in places {
            let share = |&(at, area): &([f64; 3], [f64; 3])| {
                let size = area.iter().map(|x| x * x).sum::<f64>().sqrt();
                (number(at, area.map(|x| x / size)), size)
            };
            shares.extend(place.shares.iter().map(share));
            share_ends.push(shares.len());
            let end = |end: &End| (number(end.at, end.normal), end.clone());
            ends.push(place.ends.iter().map(end).collect());
        }
        AtPoints { field, points, normals, shares, share_ends, ends }
    }

    /// By place its points, with N dA \[m²\].
    fn of_places(&self) -> impl Iterator<Item = &[(u32, f64)]> {
        let begins = std::iter::once(&0).chain(&self.share_ends);
        begins.zip(&self.share_ends).map(|(&begin, &end)| &self.shares[begin..end])
    }
}

impl Pushes for AtPoints {
    fn forces(&self, time: f64, out: &mut [[f64; 3]]) {
        let stresses: Vec<[f64; 6]> = self.points.iter().map(|&at| self.field.stress(at, time)).collect();
        let traction = |(stress, normal): (&[f64; 6], &[f64; 3])| Row::new(times(stress, *normal));
        let tractions: Vec<Row> = stresses.iter().zip(&self.normals).map(traction).collect();
        for ((out, shares), ends) in out.iter_mut().zip(self.of_places()).zip(&self.ends) {
            let mut sum = Row::ZERO;
            for &(k, area) in shares {
                let traction = &tractions[k as usize];
                (0..4).for_each(|i| sum.0[i] += area * traction.0[i]);
            }
            *out = sum.xyz();
            for (k, end) in ends {
                let force = end.force(&stresses[*k as usize]);
                (0..3).for_each(|i| out[i] += force[i]);
            }
        }
    }

    fn bytes(&self) -> usize {
        let AtPoints { points, normals, shares, share_ends, ends, .. } = self;
        let shares = size_of_val(&shares[..]) + size_of_val(&share_ends[..]);
        let ends: usize = ends.iter().map(|own| size_of_val(own) + size_of_val(&own[..])).sum();
        size_of_val(&points[..]) + size_of_val(&normals[..]) + shares + ends
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Pressed;

    impl GivenField for Pressed {
        fn displacement(&self, _: [f64; 3], _: f64) -> [f64; 3] {
            [0.0; 3]
        }

        fn stress(&self, _: [f64; 3], _: f64) -> [f64; 6] {
            [2.0, 3.0, 5.0, 0.0, 0.0, 0.0]
        }

        fn peak_velocity(&self) -> f64 {
            0.0
        }
    }

    /// Two triangles share the middle of an edge of the model, each on a side of it.
    #[test]
    fn a_point_on_two_sides_has_the_traction_of_each() {
        let at = [0.5, 0.0, 0.0];
        let shares = vec![(at, [-1.0, 0.0, 0.0]), (at, [0.0, -1.0, 0.0]), (at, [-1.0, 0.0, 0.0])];
        let place = Place { at, shares, ..Place::default() };
        let points = AtPoints::new(Arc::new(Pressed), &[&place]);
        assert_eq!(points.points.len(), 2);
        let mut out = [[0.0; 3]];
        points.forces(0.0, &mut out);
        assert_eq!(out, [[-4.0, -3.0, 0.0]]);
    }

    /// What is kept is counted: two points of six numbers, three shares, and of two places where their shares end, with one list and two ends.
    #[test]
    fn bytes_are_those_of_points_shares_and_ends() {
        let at = |x: f64| [x, 0.0, 0.0];
        let normal = [0.0, 0.0, -1.0];
        let end = |x: f64| {
            let along = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
            End { at: at(x), normal, along, lacking: [0.0; 2], beside: [0.0; 2] }
        };
        let first =
            Place { at: at(0.0), shares: vec![(at(1.0), normal), (at(2.0), normal)], ..Place::default() };
        let second = Place {
            at: at(3.0),
            shares: vec![(at(2.0), normal)],
            ends: vec![end(1.0), end(2.0)],
            ..Place::default()
        };
        let points = AtPoints::new(Arc::new(Pressed), &[&first, &second]);
        let of_points = 2 * 6 * size_of::<f64>();
        let of_shares = 3 * size_of::<(u32, f64)>() + 2 * size_of::<usize>();
        let of_ends = 2 * size_of::<Vec<End>>() + 2 * size_of::<(u32, End)>();
        assert_eq!(points.bytes(), of_points + of_shares + of_ends);
    }
}
