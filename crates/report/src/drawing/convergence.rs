//! Errors over the size of elements or steps, both by powers: lines whose slope is the order of convergence.

use crate::drawing::axes::Axes;
use crate::drawing::plot::{LEFT, Pen, PlotCurve, RIGHT, WIDTH, draw as draw_curves, ranges, title};
use crate::drawing::svg::{Anchor, LINES, Style, Svg};
use crate::drawing::ticks::Ticks;

/// Height of the axes.
const HEIGHT: f64 = 260.0;
/// More lines than colours have no names, which would fill the figure.
const NAMED: usize = LINES.len();
/// Room on either side of what is shown, in powers of ten.
const ROOM: f64 = 0.1;
const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/// The errors of one figure.
pub struct Levels {
    pub name: String,
    /// Size over the finest, and error there. What is zero or no number is not drawn.
    pub errors: Vec<[f64; 2]>,
}

/// The figure; none where there is nothing to draw. Beside the lines stand dashed ones of the `orders`, through the middle of what is finest.
pub fn draw(name: &str, lines: &[Levels], orders: &[f64]) -> Option<String> {
    let named = lines.len() <= NAMED;
    let mut curves: Vec<PlotCurve> = Vec::new();
    for (k, line) in lines.iter().enumerate() {
        let sound = line
            .errors
            .iter()
            .map(|e| e.map(f64::abs))
            .filter(|e| e.iter().all(|x| *x > 0.0 && x.is_finite()));
        let points: Vec<_> = sound.map(|[size, error]| (size.log10(), error.log10())).collect();
        if points.len() > 1 {
            curves.push(PlotCurve::new(if named { line.name.as_str() } else { "" }, k, Pen::Marked, points));
        }
    }
    if curves.is_empty() {
        return None;
    }
    let ((_, coarsest), (low, high)) = ranges(&curves);
    let finest: Vec<f64> =
        curves.iter().filter_map(|curve| curve.pieces[0].last()).map(|(_, error)| *error).collect();
    let middle = finest.iter().sum::<f64>() / finest.len() as f64;
    for (k, order) in orders.iter().enumerate() {
        let ends = vec![(0.0, middle), (coarsest, middle + order * coarsest)];
        // Grey, and then in the colours after it.
        curves.push(PlotCurve::new(format!("slope of order {}", rounded(*order)), 3 + k, Pen::Dashed, ends));
    }
    let (low, high) =
        orders.iter().map(|p| middle + p * coarsest).fold((low, high), |(l, h), y| (l.min(y), h.max(y)));

    let mut svg = Svg::new(WIDTH);
    let top =
        title(&mut svg, (LEFT, 0.0), WIDTH - LEFT - RIGHT, &format!("{name}: error over size"), &curves)
            + 8.0;
    let axes = Axes {
        left: LEFT,
        right: WIDTH - RIGHT,
        top,
        bottom: top + HEIGHT,
        across: Ticks { range: (-ROOM, coarsest + ROOM), marks: sizes(coarsest) },
        up: Ticks { range: (low - ROOM, high + ROOM), marks: powers(low - ROOM, high + ROOM) },
    };
    draw_curves(&mut svg, &axes, &curves);
    let below = axes.bottom + 36.0;
    let what =
        "size of elements, length of steps, or whatever a figure's name says, over the smallest that was run";
    svg.text((0.5 * (axes.left + axes.right), below), Anchor::Middle, 12.0, Style::Muted, what);
    let description = format!(
        "Errors of {} figures of {name} over the size; straight lines have the order as their slope.",
        lines.len()
    );
    Some(svg.finish(below + 10.0, name, &description))
}

/// An order as it is written: 2, 0.5, 0.67.
fn rounded(order: f64) -> String {
    let text = format!("{order:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Ticks of sizes: 1, 2, 4 and so on; of ten and more in powers of ten.
fn sizes(coarsest: f64) -> Vec<(f64, String)> {
    let base: f64 = if coarsest > 2.0 { 10.0 } else { 2.0 };
    let count = (coarsest / base.log10() + 1e-9).floor() as i32;
    (0..=count.max(1)).map(|k| (f64::from(k) * base.log10(), format!("{}", base.powi(k)))).collect()
}

/// Ticks of errors: powers of ten, and between them 2 and 5 where there are few.
fn powers(low: f64, high: f64) -> Vec<(f64, String)> {
    let few = high - low < 2.5;
    let many = if high - low > 12.0 { 2 } else { 1 };
    let mut marks = Vec::new();
    for power in low.floor() as i32..=high.ceil() as i32 {
        for first in if few { &[1, 2, 5][..] } else { &[1][..] } {
            let at = f64::from(power) + f64::from(*first).log10();
            if (low..=high).contains(&at) && power % many == 0 {
                marks.push((at, number(*first, power)));
            }
        }
    }
    marks
}

/// `first`·10^`power`, plain where that is short.
fn number(first: i32, power: i32) -> String {
    if (-3..=3).contains(&power) {
        let decimals = usize::try_from(-power).unwrap_or(0);
        return format!("{:.decimals$}", f64::from(first) * 10f64.powi(power));
    }
    let digits: String =
        power.unsigned_abs().to_string().bytes().map(|b| DIGITS[usize::from(b - b'0')]).collect();
    let sign = if power < 0 { "⁻" } else { "" };
    let front = if first == 1 { String::new() } else { format!("{first}·") };
    format!("{front}10{sign}{digits}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_powers_and_what_lies_between_where_there_are_few() {
        let texts =
            |low, high| powers(low, high).into_iter().map(|(_, text)| text).collect::<Vec<_>>().join(" ");
        assert_eq!(texts(-2.1, -0.9), "0.01 0.02 0.05 0.1");
        assert_eq!(texts(-6.1, -1.9), "10⁻⁶ 10⁻⁵ 10⁻⁴ 0.001 0.01");
        assert_eq!(texts(-4.5, -3.9), "5·10⁻⁵ 10⁻⁴");
        assert_eq!(rounded(2.0) + &rounded(0.5) + &rounded(2.0 / 3.0), "20.50.67");
    }

    #[test]
    fn what_has_one_level_or_no_error_is_not_drawn() {
        let levels = |errors: &[[f64; 2]]| vec![Levels { name: "q".into(), errors: errors.to_vec() }];
        assert_eq!(draw("x", &levels(&[[2.0, 0.0], [1.0, 1e-3]]), &[2.0]), None);
        assert_eq!(draw("x", &levels(&[[2.0, f64::NAN], [1.0, 1e-3]]), &[]), None);
        let svg = draw("x", &levels(&[[2.0, -4e-3], [1.0, 1e-3]]), &[2.0]).unwrap();
        assert!(svg.contains("slope of order 2") && svg.contains(">q<"));
    }
}
