//! Figure of moment over thrust at all stations of a lining.

use crate::chapter::figure::Figure;
use crate::drawing::axes::Axes;
use crate::drawing::plot::{self, LEFT, Pen, PlotCurve, RIGHT, WIDTH};
use crate::drawing::svg::{Anchor, Style, Svg};
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};
use crate::section_forces::along_lining::COLOURS;
use crate::section_forces::stations::{KILO, Lining, Station};

/// Boxes of more stations hide each other.
const BOXES: usize = 150;

/// The figure; nothing for a lining without numbers. Of a lining of many stations those of the section are followed through
/// the shaking.
pub fn figure(language: Language, lining: &Lining, section: &[&Station], suffix: &str) -> Option<Figure> {
    let after: Vec<(f64, f64)> =
        lining.stations.iter().map(|s| (s.after[0] * KILO, s.after[1] * KILO)).collect();
    let all = lining.stations.len() <= BOXES;
    let followed: Vec<&Station> = if all { lining.stations.iter().collect() } else { section.to_vec() };
    let boxes: Vec<Vec<(f64, f64)>> = followed
        .into_iter()
        .filter_map(|s| {
            let (low, high) = (s.least?.forces.map(|x| x * KILO), s.most?.forces.map(|x| x * KILO));
            Some(vec![
                (low[0], low[1]),
                (high[0], low[1]),
                (high[0], high[1]),
                (low[0], high[1]),
                (low[0], low[1]),
            ])
        })
        .collect();
    let mut curves = Vec::new();
    if boxes.iter().flatten().any(|(n, m)| n.is_finite() && m.is_finite()) {
        let name = say!(language, "between which values each station went while the ground shook");
        curves.push(PlotCurve { name, colour: 6, pen: Pen::Thin, pieces: boxes });
    }
    if after.iter().any(|(n, m)| n.is_finite() && m.is_finite()) {
        curves.push(PlotCurve::new(&lining.after, COLOURS[0], Pen::Dots, after));
    }
    if curves.is_empty() {
        return None;
    }
    let ((left, right), (low, high)) = plot::ranges(&curves);
    let title = say!(language, "{lining}: M, moment (kN\u{a0}m/m), over N, thrust", lining = lining.name);
    let mut svg = Svg::new(WIDTH);
    let top = plot::title(&mut svg, (LEFT, 0.0), WIDTH - LEFT - RIGHT, &title, &curves);
    let axes = Axes {
        left: LEFT,
        right: WIDTH - RIGHT,
        top,
        bottom: top + 300.0,
        across: Ticks::around(left.min(0.0), right.max(0.0), 10),
        up: Ticks::around(low.min(0.0), high.max(0.0), 7),
    };
    plot::draw(&mut svg, &axes, &curves);
    let along = say!(language, "N (kN/m), tension positive");
    svg.text((WIDTH - RIGHT, axes.bottom + 34.0), Anchor::End, 12.0, Style::Muted, &along);
    let shaken = match (lining.shaken(), all) {
        (false, _) => String::new(),
        (true, true) => say!(
            language,
            " Every pair of N and M that a station had lies in its box; the corners need not have occurred together."
        ),
        (true, false) => say!(
            language,
            " Boxes are those of the section drawn above: every pair of N and M that a station had lies in its box; the corners \
             need not have occurred together. The extremes of all sections are in the table."
        ),
    };
    let caption = say!(
        language,
        "All {number} stations of the lining, all sections.{shaken} Right of N = 0 a section is pulled. N and M are those of \
         the concrete and of bars in it together.",
        number = lining.stations.len(),
        shaken = shaken
    );
    let description = say!(language, "moment over thrust at each station");
    let svg = svg.finish(axes.bottom + 42.0, &title, &description);
    Some(Figure {
        heading: title,
        file: format!("thrust-moment{suffix}.svg"),
        svg,
        caption,
        curves: None,
        narrow: None,
    })
}
