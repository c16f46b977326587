//! A straight wall's nodes: at the cuts between benches, at the floors and roofs of galleries, and between them.

use super::spread::Spread;
use super::stretch::{MOST_GROWTH, growth, relax};

/// Levels of a wall's nodes over its foot, and for each row between them its bench (1 at the top).
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Rows {
    pub levels: Vec<f64>,
    pub bench_of: Vec<u32>,
}

impl Rows {
    /// Every bench has the same share of the wall; where the rows do not divide evenly the upper benches get one
    /// more.
    pub fn even(wall: usize, height: f64, benches: usize) -> Rows {
        let (mut levels, mut bench_of) = (vec![0.0], Vec::with_capacity(wall));
        let share = height / benches as f64;
        for bench in (0..benches).rev() {
            let rows = wall / benches + usize::from(bench < wall % benches);
            let bottom = (benches - 1 - bench) as f64 * share;
            for row in 1..=rows {
                levels.push(bottom + share * row as f64 / rows as f64);
                bench_of.push(bench as u32 + 1);
            }
        }
        levels[wall] = height;
        Rows { levels, bench_of }
    }
}

/// A cut between benches that lies at a gallery's floor or roof instead of its own level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MovedCut {
    /// The bench above it.
    pub bench: u32,
    /// Over the foot.
    pub from: f64,
    pub to: f64,
}

/// The levels at which a wall with galleries has nodes whatever the number of its rows.
#[derive(Clone, Debug)]
pub(super) struct Stops {
    /// Rising, from the foot to the springing.
    levels: Vec<f64>,
    /// Of each interval between two of them.
    bench_of: Vec<u32>,
    pub moved: Vec<MovedCut>,
    near: f64,
}

impl Stops {
    /// `galleries`: levels over the foot, rising, from 0 to below `height`. A cut within a quarter of `near` of one
    /// moves there: a thinner row would be of no use, and would set the time step.
    pub fn new(height: f64, benches: u32, galleries: &[f64], near: f64) -> Stops {
        let mut cuts: Vec<f64> =
            (1..benches).map(|cut| height * f64::from(cut) / f64::from(benches)).collect();
        let mut moved = Vec::new();
        for &level in galleries.iter().filter(|l| **l > 0.0) {
            let away = |cut: f64| (cut - level).abs();
            let nearest = (0..cuts.len()).min_by(|&a, &b| away(cuts[a]).total_cmp(&away(cuts[b])));
            let Some(cut) = nearest.filter(|&cut| away(cuts[cut]) < 0.25 * near) else { continue };
            if galleries.contains(&cuts[cut]) {
                continue;
            }
            if away(cuts[cut]) > 1e-9 {
                moved.push(MovedCut { bench: benches - 1 - cut as u32, from: cuts[cut], to: level });
            }
            cuts[cut] = level;
        }
        let mut levels: Vec<f64> = galleries.iter().copied().filter(|l| *l > 0.0).collect();
        levels.extend(&cuts);
        levels.extend([0.0, height]);
        levels.sort_by(f64::total_cmp);
        levels.dedup();
        let bench = |from: f64| benches - cuts.iter().filter(|cut| **cut <= from).count() as u32;
        let bench_of = levels[..levels.len() - 1].iter().map(|&from| bench(from)).collect();
        Stops { levels, bench_of, moved, near }
    }

    /// The intervals between two of the levels.
    fn intervals(&self, from: f64, to: f64) -> std::ops::Range<usize> {
        let place = |at: f64| self.levels.partition_point(|l| *l < at);
        place(from)..place(to)
    }

    /// Rows wanted between two of the levels, and the fewest that there must be.
    pub fn wanted(&self, from: f64, to: f64) -> (f64, usize) {
        let spread = Spread::new(&self.levels, self.near);
        let intervals = self.intervals(from, to);
        (intervals.clone().map(|i| spread.wanted(i).max(1.0)).sum(), intervals.len())
    }

    /// Appends `total` rows between two of the levels, at least one to an interval and more where more are wanted;
    /// nothing if there are too few.
    fn divide(&self, from: f64, to: f64, total: usize, rows: &mut Rows) -> Option<()> {
        let spread = Spread::new(&self.levels, self.near);
        let intervals = self.intervals(from, to);
        if total < intervals.len() || intervals.is_empty() {
            return None;
        }
        let wanted: Vec<f64> = intervals.clone().map(|i| spread.wanted(i)).collect();
        let mut given = vec![1usize; wanted.len()];
        for _ in wanted.len()..total {
            let size = |i: usize| wanted[i] / given[i] as f64;
            let largest = (0..wanted.len()).max_by(|&a, &b| size(a).total_cmp(&size(b)));
            given[largest?] += 1;
        }
        for (i, n) in intervals.zip(given) {
            spread.fill(i, n, &mut rows.levels);
            rows.bench_of.extend(std::iter::repeat_n(self.bench_of[i], n));
        }
        Some(())
    }

    /// How much neighbouring rows between two of the levels differ if there are `total`, beyond what is good: 0 up to
    /// the largest growth.
    pub fn uneven(&self, from: f64, to: f64, total: usize) -> f64 {
        let mut rows = Rows { levels: vec![from], bench_of: Vec::new() };
        if self.divide(from, to, total, &mut rows).is_none() {
            return 0.0;
        }
        relax(&mut rows.levels, &self.levels);
        (growth(&rows.levels, &[None, None]) - MOST_GROWTH).max(0.0)
    }

    /// The wall's rows. `pins` rise: the number of a node and its level, which is one of the stops', from the foot
    /// to the springing. Nothing if there are fewer rows than intervals somewhere.
    pub fn rows(&self, pins: &[(usize, f64)]) -> Option<Rows> {
        let mut rows = Rows { levels: vec![0.0], bench_of: Vec::new() };
        for pair in pins.windows(2) {
            self.divide(pair[0].1, pair[1].1, pair[1].0.checked_sub(pair[0].0)?, &mut rows)?;
        }
        relax(&mut rows.levels, &self.levels);
        Some(rows)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cuts_near_a_gallery_s_level_move_there_and_no_bench_is_lost() {
        // Cuts at 6, 12, 18 and 24.
        let stops = Stops::new(30.0, 5, &[12.3, 15.3], 2.0);
        assert_eq!(stops.levels, [0.0, 6.0, 12.3, 15.3, 18.0, 24.0, 30.0]);
        assert_eq!(stops.bench_of, [5, 4, 3, 3, 2, 1]);
        assert_eq!(stops.moved, [MovedCut { bench: 3, from: 12.0, to: 12.3 }]);
        // Two cuts near one level, two levels near one cut.
        let stops = Stops::new(1.2, 4, &[0.45], 1.2);
        assert_eq!(stops.bench_of, [4, 3, 2, 1]);
        assert_eq!(stops.moved.len(), 1);
        let stops = Stops::new(10.0, 2, &[4.9, 5.1], 2.0);
        assert_eq!(stops.levels, [0.0, 4.9, 5.1, 10.0]);
        assert_eq!(stops.bench_of, [2, 1, 1]);
    }

    #[test]
    fn rows_meet_their_pins_and_their_stops() {
        let stops = Stops::new(30.0, 5, &[13.0, 16.0], 3.0);
        let (below, least) = stops.wanted(0.0, 13.0);
        assert!(least == 3 && below > 4.0, "{below} {least}");
        let rows = stops.rows(&[(0, 0.0), (6, 13.0), (7, 16.0), (13, 30.0)]).unwrap();
        assert_eq!((rows.levels.len(), rows.bench_of.len()), (14, 13));
        assert_eq!((rows.levels[6], rows.levels[7], rows.levels[13]), (13.0, 16.0, 30.0));
        for cut in [6.0, 12.0, 18.0, 24.0] {
            let node = rows.levels.iter().position(|l| *l == cut).unwrap();
            assert_eq!(rows.bench_of[node] + 1, rows.bench_of[node - 1]);
        }
        assert!(stops.rows(&[(0, 0.0), (2, 13.0), (7, 16.0), (13, 30.0)]).is_none());
    }
}
