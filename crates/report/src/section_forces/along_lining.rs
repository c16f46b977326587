//! Figure of section forces along a lining.

use crate::chapter::figure::Figure;
use crate::drawing::axes::Axes;
use crate::drawing::plot::{self, LEFT, Pen, PlotCurve, RIGHT, WIDTH};
use crate::drawing::svg::{Anchor, Style, Svg, text_width};
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};
use crate::quantities::scale::trimmed;
use crate::script::curves::{Rule, RuleAnchor};
use crate::script::plot_curves::{self, Plot};
use crate::section_forces::stations::{Extreme, KILO, Lining, Station, distance, forces, joints};

/// Colours: after the stages, largest, smallest.
pub const COLOURS: [usize; 3] = [3, 1, 0];

/// The figure of one section; nothing for fewer than two stations.
pub fn figure(
    language: Language,
    lining: &Lining,
    (y, section): (f64, &[&Station]),
    suffix: &str,
) -> Option<Figure> {
    if section.len() < 2 || !section.iter().any(|s| s.after[0].is_finite() || s.least.is_some()) {
        return None;
    }
    let along: Vec<f64> = std::iter::once(0.0)
        .chain(section.windows(2).scan(0.0, |s, pair| {
            *s += distance(pair[0], pair[1]);
            Some(*s)
        }))
        .collect();
    let end = along[along.len() - 1];
    let title = say!(language, "{lining}: forces along the lining", lining = lining.name);
    let mut svg = Svg::new(WIDTH);
    let mut top = 0.0;
    let mut panels = Vec::new();
    for (i, heading) in forces(language).into_iter().enumerate() {
        let mut curves = curves(language, lining, section, &along, i);
        let answering = curves.clone();
        if i > 0 {
            curves.iter_mut().for_each(|curve| curve.name.clear());
        }
        top = plot::title(&mut svg, (LEFT, top), WIDTH - LEFT - RIGHT, &heading, &curves);
        top += if i == 0 { 14.0 } else { 0.0 };
        let (low, high) = plot::ranges(&curves).1;
        let axes = Axes {
            left: LEFT,
            right: WIDTH - RIGHT,
            top,
            bottom: top + 150.0,
            across: Ticks::within(0.0, end, 12),
            up: Ticks::around(low.min(0.0), high.max(0.0), 5),
        };
        for (k, words) in landmarks(language, section) {
            let (x, _) = axes.point(along[k], 0.0);
            svg.rule((x, top - if i == 0 { 4.0 } else { 0.0 }), (x, axes.bottom), true);
            if i == 0 {
                let half = 0.5 * text_width(&words, 11.0);
                let x = x.clamp(LEFT + half, WIDTH - RIGHT - half);
                svg.text((x, top - 7.0), Anchor::Middle, 11.0, Style::Muted, &words);
            }
        }
        plot::draw(&mut svg, &axes, &curves);
        top = axes.bottom + 26.0;
        panels.push((heading, axes.up.range, answering));
    }
    let words = say!(language, "along the lining");
    svg.text((WIDTH - RIGHT, top + 8.0), Anchor::End, 12.0, Style::Muted, &format!("{words} (m)"));
    let plots = panels.iter().map(|(heading, ends, curves)| Plot {
        title: heading.clone(),
        unit: String::new(),
        log: false,
        ends: Some((*ends).into()),
        curves,
    });
    let mut curves = plot_curves::curves(&title, &words, "m", &plots.collect::<Vec<_>>());
    let landmarks = landmarks(language, section).into_iter();
    curves.rules =
        landmarks.map(|(k, name)| Rule { across: along[k], name, side: RuleAnchor::Center }).collect();
    let mut caption = say!(
        language,
        "Section y = {y}\u{a0}m, {number} stations going round from below by the wall of greater x over the crown. Lines break where \
         stations are missing, as where walls meet.",
        y = trimmed(&format!("{y:.2}").replace('-', "−")),
        number = section.len()
    );
    if lining.shaken() {
        caption.push_str(&say!(
            language,
            " What lies between the line after the stages and those of the shaking is what the earthquake adds."
        ));
    }
    let description = say!(language, "thrust, moment and shear over the length along the lining");
    let svg = svg.finish(top + 16.0, &title, &description);
    let file = format!("lining-forces{suffix}.svg");
    Some(Figure { heading: title, file, svg, caption, curves: Some(curves), narrow: None })
}

/// What is drawn of a force: after the stages, largest, smallest.
fn curves(
    language: Language,
    lining: &Lining,
    section: &[&Station],
    along: &[f64],
    i: usize,
) -> Vec<PlotCurve> {
    let after = |s: &Station| s.after[i];
    let extreme = |of: Option<Extreme>| of.map_or(f64::NAN, |e| e.forces[i]);
    let most = |s: &Station| extreme(s.most);
    let least = |s: &Station| extreme(s.least);
    type Of<'a> = &'a dyn Fn(&Station) -> f64;
    let wanted: [(String, Of); 3] = [
        (lining.after.clone(), &after),
        (say!(language, "largest while the ground shakes"), &most),
        (say!(language, "smallest while the ground shakes"), &least),
    ];
    let curve = |(k, (name, of)): (usize, (String, Of))| {
        let mut pieces = vec![Vec::new()];
        let joints = joints(section);
        for (n, station) in section.iter().enumerate() {
            if n > 0 && !joints[n - 1] {
                pieces.push(Vec::new());
            }
            if let Some(piece) = pieces.last_mut() {
                piece.push((along[n], of(station) * KILO));
            }
        }
        let pen = if k == 0 { Pen::Marked } else { Pen::Curve };
        PlotCurve { name, colour: COLOURS[k], pen, pieces }
    };
    let drawn = |curve: &PlotCurve| curve.pieces.iter().flatten().any(|p| p.1.is_finite());
    wanted.into_iter().enumerate().map(curve).filter(drawn).collect()
}

/// Stations by which one finds one's way.
fn landmarks(language: Language, section: &[&Station]) -> Vec<(usize, String)> {
    let ends = |of: &dyn Fn(&Station) -> f64| plot::range(section.iter().map(|s| of(s)));
    let ((left, right), (low, high)) = (ends(&|s| s.place[0]), ends(&|s| s.place[2]));
    let (x, z) = (0.5 * (left + right), 0.5 * (low + high));
    let nearest = |at: [f64; 2]| {
        let away = |s: &Station| (s.place[0] - at[0]).hypot(s.place[2] - at[1]);
        (0..section.len()).min_by(|a, b| away(section[*a]).total_cmp(&away(section[*b]))).unwrap_or(0)
    };
    let mut marks = Vec::new();
    for (at, words) in [
        ([right, z], say!(language, "wall of greater x")),
        ([x, high], say!(language, "crown")),
        ([left, z], say!(language, "wall of smaller x")),
    ] {
        let k = nearest(at);
        if !marks.iter().any(|(known, _)| *known == k) {
            marks.push((k, words));
        }
    }
    marks
}
