//! Long histories, thinned to what a figure can show.

/// A point of a figure in its own units.
type Point = (f64, f64);

/// The polylines that look like the history `points` (ascending first coordinate) when each column of one
/// unit is as wide as the pen.
///
/// Of each column the smallest and the largest value are kept, in their order in time, so no peak is lost; then
/// points that lie on the line between their neighbours to within `tolerance` (in the second coordinate) are left
/// out. Points that are not finite break the line.
pub fn thin(points: impl Iterator<Item = Point>, tolerance: f64) -> Vec<Vec<Point>> {
    let mut lines = Vec::new();
    let mut line = Vec::new();
    let mut column: Option<PixelColumn> = None;
    for point in points {
        if !(point.0.is_finite() && point.1.is_finite()) {
            close(&mut column, &mut line);
            if !line.is_empty() {
                lines.push(straighten(&line, tolerance));
                line.clear();
            }
            continue;
        }
        match &mut column {
            Some(current) if current.left == point.0.floor() => current.add(point),
            _ => {
                close(&mut column, &mut line);
                column = Some(PixelColumn { left: point.0.floor(), low: point, high: point });
            }
        }
    }
    close(&mut column, &mut line);
    if !line.is_empty() {
        lines.push(straighten(&line, tolerance));
    }
    lines
}

struct PixelColumn {
    left: f64,
    low: Point,
    high: Point,
}

impl PixelColumn {
    fn add(&mut self, point: Point) {
        if point.1 < self.low.1 {
            self.low = point;
        }
        if point.1 > self.high.1 {
            self.high = point;
        }
    }
}

fn close(column: &mut Option<PixelColumn>, line: &mut Vec<Point>) {
    if let Some(PixelColumn { low, high, .. }) = column.take() {
        if low == high {
            line.push(low);
        } else if low.0 <= high.0 {
            line.extend([low, high]);
        } else {
            line.extend([high, low]);
        }
    }
}

/// Swinging-door thinning: from the last kept point, goes on while one straight line passes all points since
/// within the tolerance.
fn straighten(line: &[Point], tolerance: f64) -> Vec<Point> {
    let mut kept = vec![line[0]];
    let mut anchor = line[0];
    let (mut least, mut most) = (f64::NEG_INFINITY, f64::INFINITY);
    for pair in line.windows(2) {
        let (last, next) = (pair[0], pair[1]);
        let slopes = |from: Point, to: Point| {
            let dx = (to.0 - from.0).max(f64::MIN_POSITIVE);
            ((to.1 - tolerance - from.1) / dx, (to.1 + tolerance - from.1) / dx)
        };
        let direct = (next.1 - anchor.1) / (next.0 - anchor.0).max(f64::MIN_POSITIVE);
        if direct < least || direct > most {
            kept.push(last);
            anchor = last;
            (least, most) = slopes(anchor, next);
        } else {
            let (low, high) = slopes(anchor, next);
            (least, most) = (least.max(low), most.min(high));
        }
    }
    if line.len() > 1 {
        kept.push(line[line.len() - 1]);
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_peak_of_a_long_history_survives() {
        let n = 100_000;
        let wave = |i: usize| 100.0 * (i as f64 * 0.0031).sin() + if i == 54_321 { 500.0 } else { 0.0 };
        let lines = thin((0..n).map(|i| (i as f64 * 800.0 / n as f64, wave(i))), 0.1);
        assert_eq!(lines.len(), 1);
        assert!(lines[0].len() <= 1600);
        let highest = lines[0].iter().map(|p| p.1).fold(f64::MIN, f64::max);
        assert_eq!(highest, wave(54_321));
    }

    #[test]
    fn the_thinned_line_stays_within_the_tolerance() {
        // One point a column, so that only the straightening acts.
        let points: Vec<Point> =
            (0..800).map(|i| (f64::from(i), 60.0 * (f64::from(i) * 0.02).sin())).collect();
        let line = thin(points.iter().copied(), 0.1).remove(0);
        assert!(line.len() < 400, "{}", line.len());
        let mut k = 0;
        for point in &points {
            while line[k + 1].0 < point.0 {
                k += 1;
            }
            let (a, b) = (line[k], line[k + 1]);
            let there = a.1 + (b.1 - a.1) * (point.0 - a.0) / (b.0 - a.0);
            assert!((there - point.1).abs() <= 0.1 + 1e-9, "{point:?} {there}");
        }
    }

    #[test]
    fn values_that_are_not_finite_break_the_line() {
        let points = [(0.0, 1.0), (1.0, f64::NAN), (2.0, 3.0), (3.0, 9.0), (4.0, f64::INFINITY)];
        assert_eq!(thin(points.into_iter(), 0.1), [vec![(0.0, 1.0)], vec![(2.0, 3.0), (3.0, 9.0)]]);
        assert!(thin([(f64::NAN, 0.0)].into_iter(), 0.1).is_empty());
    }
}
