//! Figure of how much of the incident wave moves the place where a record was taken, by frequency.

use tremolite_results::{Deconvolved, Table};

use crate::chapter::figure::Figure;
use crate::drawing::axes::Axes;
use crate::drawing::plot::{self, LEFT, Pen, PlotCurve, RIGHT, WIDTH};
use crate::drawing::svg::{Anchor, Style, Svg};
use crate::drawing::ticks::Ticks;
use crate::free_field::numbers::AXES;
use crate::language::{Language, say};
use crate::quantities::scale::{figures, trimmed};
use crate::script::curves::{Curves, Rule, RuleAnchor};
use crate::script::plot_curves::{self, Plot};
use crate::source::Source;

/// The share of its value at rest below which a transfer is not inverted.
const LEAST: f64 = 0.05;
const HEIGHT: f64 = 230.0;
/// Room above the axes for the names of frequencies.
const NAMES: f64 = 18.0;

/// The figure for the components that move, and a sentence for what there should be and is not.
pub fn figure(source: &Source, moving: &[usize]) -> (Option<Figure>, Vec<String>) {
    let language = source.language;
    let left_out = |why: &str| (None, vec![say!(language, "Left out. {why}", why = why)]);
    let site = source.facts().computed.motion.deconvolved;
    let table = match &source.transfer {
        Some(Ok(table)) => table,
        Some(Err(why)) => return left_out(why),
        None if site.is_some() => {
            return left_out(&say!(
                language,
                "There is no {file} in the result folder.",
                file = "transfer.csv"
            ));
        }
        None => return (None, Vec::new()),
    };
    let hertz = table.column("frequency").unwrap_or(&[]);
    let mut curves = components(language, table, hertz, moving);
    let ((_, end), (_, most)) = plot::ranges(&curves);
    if !(end > 0.0 && most > 0.0) {
        return left_out(&say!(language, "transfer.csv holds no motion."));
    }
    if let Some(site) = site.as_ref().filter(|site| site.at_rest > 0.0) {
        let level = LEAST * site.at_rest;
        let name = say!(language, "5 % of the value at low frequency: nothing is inverted below");
        curves.push(PlotCurve::new(name, 1, Pen::Dashed, hertz.iter().map(|f| (*f, level)).collect()));
    }
    let heading = say!(language, "From the incident wave to the place of the record");
    let drawing = TransferDrawing {
        words: say!(language, "motion where the record was taken over incident wave, amplitude"),
        below: say!(language, "frequency"),
        across: Ticks::within(0.0, end, 10),
        up: Ticks::within(0.0, 1.06 * most, 5),
        rules: site.as_ref().map_or(Vec::new(), |site| rules(language, site, end)),
        curves,
    };
    let caption = say!(
        language,
        "Amplitude by frequency, of theory: vertical waves through linear layers, damping included (Kramer 1996, section 7.2.1). The \
         record over it is the wave that comes in. Where it is small, hardly anything of the wave moves that place, and the wave is \
         so many times the record, errors of the record included. Numbers: transfer.csv."
    );
    let (svg, answering) = (drawing.draw(&heading), Some(drawing.answering(&heading)));
    (
        Some(Figure { heading, file: "transfer.svg".into(), svg, caption, curves: answering, narrow: None }),
        Vec::new(),
    )
}

/// A curve for each component, one for those that are the same.
fn components(language: Language, table: &Table, hertz: &[f64], moving: &[usize]) -> Vec<PlotCurve> {
    let mut curves: Vec<PlotCurve> = Vec::new();
    for &axis in moving {
        let Some(values) = table.column(AXES[axis]) else { continue };
        let points: Vec<(f64, f64)> = hertz.iter().copied().zip(values.iter().copied()).collect();
        match curves.iter_mut().find(|curve| curve.pieces[0] == points) {
            Some(same) => same.name = say!(language, "{a} and {b}", a = same.name, b = AXES[axis]),
            None => curves.push(PlotCurve::new(AXES[axis], axis, Pen::Curve, points)),
        }
    }
    curves
}

/// Up to where the record is wanted, and from where it fades out, by frequency.
fn rules(language: Language, site: &Deconvolved, end: f64) -> Vec<Rule> {
    let band =
        say!(language, "wanted up to {frequency}\u{a0}Hz", frequency = trimmed(&figures(site.band, 3)));
    let reach = say!(language, "fades out from {frequency}\u{a0}Hz", frequency = figures(site.reach, 3));
    let mut rules = vec![(site.band, band), (site.reach, reach)];
    rules.retain(|(at, _)| (0.0..=end).contains(at));
    rules.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Names of neighbours stand on the sides that are turned away.
    let sides = if rules.len() > 1 { [RuleAnchor::End, RuleAnchor::Start] } else { [RuleAnchor::End; 2] };
    rules.into_iter().zip(sides).map(|((across, name), side)| Rule { across, name, side }).collect()
}

/// What the figure is made of.
struct TransferDrawing {
    words: String,
    /// Below the axis, without the unit.
    below: String,
    across: Ticks,
    up: Ticks,
    rules: Vec<Rule>,
    curves: Vec<PlotCurve>,
}

impl TransferDrawing {
    fn draw(&self, title: &str) -> String {
        let mut svg = Svg::new(WIDTH);
        let top = plot::title(&mut svg, (LEFT, 0.0), WIDTH - LEFT - RIGHT, &self.words, &self.curves) + NAMES;
        let bottom = top + HEIGHT;
        let (across, up) = (self.across.clone(), self.up.clone());
        let axes = Axes { left: LEFT, right: WIDTH - RIGHT, top, bottom, across, up };
        for Rule { across, name, side } in &self.rules {
            let (x, _) = axes.point(*across, 0.0);
            svg.rule((x, top - NAMES + 4.0), (x, bottom), true);
            let (shift, anchor) = match side {
                RuleAnchor::End => (-4.0, Anchor::End),
                _ => (4.0, Anchor::Start),
            };
            svg.text((x + shift, top - 5.0), anchor, 11.0, Style::Muted, name);
        }
        plot::draw(&mut svg, &axes, &self.curves);
        let below = format!("{} (Hz)", self.below);
        svg.text((WIDTH - RIGHT, bottom + 34.0), Anchor::End, 12.0, Style::Muted, &below);
        svg.finish(bottom + 42.0, title, &self.words)
    }

    /// The same for the page's script.
    fn answering(&self, title: &str) -> Curves {
        let plot = Plot {
            title: self.words.clone(),
            unit: String::new(),
            log: false,
            ends: Some(self.up.range.into()),
            curves: &self.curves,
        };
        let mut curves = plot_curves::curves(title, &self.below, "Hz", &[plot]);
        curves.rules.clone_from(&self.rules);
        curves
    }
}
