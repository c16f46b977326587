//! The curves of figures drawn with [`plot`](crate::drawing::plot), for the page's script: all over one abscissa.

use crate::drawing::axes::drawable;
use crate::drawing::chart::Stroke;
use crate::drawing::plot::{Pen, PlotCurve};
use crate::script::curves::{Across, CurveLine, CurvePanel, Curves, PASSED};

/// One set of axes.
pub struct Plot<'a> {
    pub title: String,
    /// May stand in the title instead.
    pub unit: String,
    pub log: bool,
    /// The ends of the upright axis, where they are not to follow the values.
    pub ends: Option<[f64; 2]>,
    /// In the units of the axes, ascending within each piece.
    pub curves: &'a [PlotCurve],
}

/// Curves over an abscissa with this name and unit.
pub fn curves(title: &str, name: &str, unit: &str, plots: &[Plot<'_>]) -> Curves {
    let all = || plots.iter().flat_map(|plot| plot.curves);
    let values = abscissa(all());
    let panel = |plot: &Plot<'_>| CurvePanel {
        title: plot.title.clone(),
        unit: plot.unit.clone(),
        log: plot.log,
        ends: plot.ends,
        remark: String::new(),
        mark: None,
        lines: plot.curves.iter().map(|curve| line(curve, &values)).collect(),
    };
    let panels = plots.iter().map(panel).collect();
    let across = Across { name: name.into(), unit: unit.into(), log: false, values };
    Curves::new(title, across, panels)
}

/// Where any of the curves has a point, ascending, each once; and where one breaks between neighbours, the middle.
fn abscissa<'a>(curves: impl Iterator<Item = &'a PlotCurve> + Clone) -> Vec<f64> {
    let pieces = || curves.clone().flat_map(|curve| &curve.pieces);
    let mut values: Vec<f64> = pieces().flatten().map(|point| point.0).filter(|x| drawable(*x)).collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    let breaks = curves.clone().flat_map(|curve| curve.pieces.windows(2)).filter_map(|pair| {
        let (from, to) = (pair[0].last()?.0, pair[1].first()?.0);
        let next = values.get(values.partition_point(|x| *x <= from)).copied();
        (from < to && next == Some(to)).then_some(0.5 * (from + to))
    });
    let breaks: Vec<f64> = breaks.collect();
    values.extend(breaks);
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

fn line(curve: &PlotCurve, abscissa: &[f64]) -> CurveLine {
    let mut values = vec![f64::NAN; abscissa.len()];
    for piece in &curve.pieces {
        let mut last = None;
        for (x, y) in piece.iter().filter(|point| drawable(point.0)) {
            let row = abscissa.partition_point(|other| other < x);
            match last {
                // What a resumed run repeats is passed over.
                Some(last) if row <= last => continue,
                Some(last) => values[last + 1..row].fill(PASSED),
                None => {}
            }
            values[row] = if drawable(*y) { *y } else { f64::NAN };
            last = Some(row);
        }
    }
    CurveLine {
        name: curve.name.clone(),
        colour: curve.colour,
        stroke: if curve.pen == Pen::Dashed { Stroke::Dashed } else { Stroke::Thin },
        points: matches!(curve.pen, Pen::Marked | Pen::Dots),
        values,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(curves: &[PlotCurve]) -> Curves {
        let plot = Plot { title: String::new(), unit: String::new(), log: false, ends: None, curves };
        super::curves("", "", "s", &[plot])
    }

    #[test]
    fn runs_with_rows_at_other_times_share_an_abscissa_and_keep_their_values() {
        let history = |step: f64, rows: usize| -> Vec<(f64, f64)> {
            (0..rows).map(|row| row as f64 * step).map(|t| (t, 1.0 + t * t)).collect()
        };
        let [coarse, fine] = [history(0.5, 4), history(0.2, 6)];
        let merged = of(&[
            PlotCurve::new("coarse", 0, Pen::Curve, coarse.clone()),
            PlotCurve::new("fine", 1, Pen::Curve, fine.clone()),
        ]);
        let across = &merged.across.values;
        assert!(across.windows(2).all(|pair| pair[0] < pair[1]), "{across:?}");
        // 0 and 1 are rows of both.
        assert_eq!(across.len(), 4 + 6 - 2);
        for (line, own) in merged.panels[0].lines.iter().zip([coarse, fine]) {
            let there: Vec<(f64, f64)> = across.iter().copied().zip(line.values.iter().copied()).collect();
            let finite: Vec<(f64, f64)> = there.iter().copied().filter(|p| p.1.is_finite()).collect();
            assert_eq!(finite, own, "{}", line.name);
            // Rows of others do not break it; beyond its end there is nothing.
            let end = own.last().unwrap().0;
            for (x, y) in there.iter().filter(|p| !p.1.is_finite()) {
                assert!(if *x < end { *y == PASSED } else { y.is_nan() }, "{}: {y} at {x}", line.name);
            }
        }
    }

    #[test]
    fn a_line_breaks_between_its_pieces_and_where_it_has_no_number() {
        let pieces = vec![vec![(0.0, 1.0), (1.0, 2.0)], vec![(2.0, 3.0), (3.0, f64::NAN), (4.0, 5.0)]];
        let broken = of(&[PlotCurve { name: String::new(), colour: 0, pen: Pen::Marked, pieces }]);
        assert_eq!(broken.across.values, [0.0, 1.0, 1.5, 2.0, 3.0, 4.0]);
        let values = &broken.panels[0].lines[0].values;
        assert!(values[2].is_nan() && values[4].is_nan());
        assert_eq!([0, 1, 3, 5].map(|row| values[row]), [1.0, 2.0, 3.0, 5.0]);
        assert!(broken.panels[0].lines[0].points);
    }

    #[test]
    fn a_time_that_a_resumed_run_repeats_is_passed_over() {
        let points = vec![(0.0, 1.0), (0.1, 2.0), (0.2, 3.0), (0.1, 9.0), (0.2, 9.0), (0.3, 4.0)];
        let curves = of(&[PlotCurve::new("", 0, Pen::Curve, points)]);
        assert_eq!(curves.across.values, [0.0, 0.1, 0.2, 0.3]);
        assert_eq!(curves.panels[0].lines[0].values, [1.0, 2.0, 3.0, 4.0]);
    }
}
