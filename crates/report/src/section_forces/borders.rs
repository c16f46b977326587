//! Figure of moment over thrust against what the sections bear by their code, bars included.

use tremolite_results::utilisation::UtilisationRow;
use tremolite_results::{Border, SectionStrength};

use crate::chapter::figure::Figure;
use crate::drawing::axes::Axes;
use crate::drawing::plot::{self, LEFT, NARROW, Pen, PlotCurve, RIGHT, WIDTH};
use crate::drawing::svg::{Anchor, Style, Svg};
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};
use crate::quantities::scale::{figures, trimmed};
use crate::section_forces::stations::KILO;

/// Colours of the lines, and of the points after the stages and in the shaking.
const LINES: [usize; 3] = [1, 2, 4];
const PENS: [Pen; 3] = [Pen::Curve, Pen::Dashed, Pen::Dotted];
const AFTER: usize = 3;
const SHAKEN: usize = 6;

/// The figure; nothing where no line or no point is known.
pub fn figure(
    language: Language,
    lining: &str,
    of: &SectionStrength,
    rows: &[UtilisationRow],
    suffix: &str,
) -> Option<Figure> {
    let point = |row: &UtilisationRow| (row.forces[0] * KILO, row.forces[1] * KILO);
    let own = || rows.iter().filter(|row| row.lining == lining && row.forces.iter().all(|f| f.is_finite()));
    let shaken: Vec<(f64, f64)> = own().filter(|row| row.when == "max").map(point).collect();
    // Of each station the last of its stages.
    let mut last: Vec<&UtilisationRow> = Vec::new();
    for row in own().filter(|row| row.when != "max" && row.when != "max_shear") {
        match last.last_mut() {
            Some(before) if before.station == row.station => *before = row,
            _ => last.push(row),
        }
    }
    let after: Vec<(f64, f64)> = last.into_iter().map(point).collect();
    if of.borders.is_empty() || shaken.is_empty() && after.is_empty() {
        return None;
    }
    let mut curves: Vec<PlotCurve> =
        of.borders.iter().zip(LINES.into_iter().zip(PENS)).map(|(b, of)| line(language, b, of)).collect();
    if !shaken.is_empty() {
        let name = say!(language, "each station at its largest utilisation");
        curves.push(PlotCurve::new(name, SHAKEN, Pen::Dots, shaken));
    }
    if !after.is_empty() {
        curves.push(PlotCurve::new(say!(language, "after the stages"), AFTER, Pen::Dots, after));
    }
    let ((left, right), (low, high)) = plot::ranges(&curves);
    let title = say!(language, "{lining}: N and M against the strength of the sections", lining = lining);
    let below = say!(language, "N (kN/m), tension positive; upwards M (kN\u{a0}m/m)");
    let drawn = |width: f64, heading: &str| {
        let mut svg = Svg::new(width);
        let top = plot::title(&mut svg, (LEFT, 0.0), width - LEFT - RIGHT, heading, &curves);
        let axes = Axes {
            left: LEFT,
            right: width - RIGHT,
            top,
            bottom: top + if width < WIDTH { 250.0 } else { 320.0 },
            across: Ticks::around(left, right, if width < WIDTH { 6 } else { 10 }),
            up: Ticks::around(low, high, 7),
        };
        plot::draw(&mut svg, &axes, &curves);
        svg.text((width - RIGHT, axes.bottom + 34.0), Anchor::End, 12.0, Style::Muted, &below);
        svg.finish(axes.bottom + 42.0, &title, &below)
    };
    let (svg, narrow) = (drawn(WIDTH, &title), Some(drawn(NARROW, "")));
    let mut caption = say!(
        language,
        "Design strength by {code}, bars (inside + outside) included; each point is N and M of one instant. Inside its line a section bears them.",
        code = of.code
    );
    if of.factors.dynamic != 1.0 && rows.iter().any(|row| row.when == "max") {
        caption.push_str(&say!(
            language,
            " The lines have the concrete's strength of the earthquake, {dynamic} times the static one by which the points after the stages are judged.",
            dynamic = trimmed(&figures(of.factors.dynamic, 3))
        ));
    }
    Some(Figure {
        heading: title,
        file: format!("section-strength{suffix}.svg"),
        svg,
        caption,
        curves: None,
        narrow,
    })
}

fn line(language: Language, border: &Border, (colour, pen): (usize, Pen)) -> PlotCurve {
    let thickness = trimmed(&figures(border.thickness, 3));
    let area = |area: f64| format!("{:.0}", 1e6 * area);
    let stations = border.stations;
    let name = match border.bars {
        [0.0, 0.0] => say!(
            language,
            "{thickness} m, without bars ({stations} stations)",
            thickness = thickness,
            stations = stations
        ),
        [inner, outer] => say!(
            language,
            "{thickness} m, bars {inner} + {outer} mm²/m ({stations} stations)",
            thickness = thickness,
            inner = area(inner),
            outer = area(outer),
            stations = stations
        ),
    };
    let points = border.line.iter().map(|[n, m]| (n * KILO, m * KILO)).collect();
    PlotCurve::new(name, colour, pen, points)
}
