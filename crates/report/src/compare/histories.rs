//! Histories of monitors overlaid, a line for each run; and how far they part at any one time.

use tremolite_results::Table;

use super::Run;
use super::numbers::head;
use crate::chapter::figure::Figure;
use crate::chapter::text_table::{Cell, TextTable};
use crate::drawing::axes::Axes;
use crate::drawing::plot::{self, LEFT, Pen, PlotCurve, RIGHT, WIDTH};
use crate::drawing::svg::{Anchor, Style, Svg};
use crate::drawing::thinning::thin;
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};
use crate::quantities::scale::{Scale, figures, moment, trimmed};
use crate::script::curves::Curves;
use crate::script::plot_curves::{self, Plot};
use crate::source::monitor_pairs::names;

/// What is drawn of each monitor and pair, where a run has it.
const QUANTITIES: [&str; 5] = ["ux", "uy", "uz", "s1", "s3"];
/// Height of a panel, and room for its heading.
const HEIGHT: f64 = 150.0;
const HEADING: f64 = 30.0;
/// A component this much smaller than the largest one of its unit is round-off or nearly so, and not drawn.
const NEGLIGIBLE: f64 = 1e-6;

/// One column of all runs that have it.
struct History<'a> {
    quantity: &'static str,
    unit: &'a str,
    /// Run, times and values.
    of: Vec<(usize, &'a [f64], &'a [f64])>,
}

impl History<'_> {
    fn largest(&self) -> f64 {
        let all = self.of.iter().flat_map(|(_, _, values)| values.iter());
        all.filter(|x| x.is_finite()).fold(0.0, |most, x| most.max(x.abs()))
    }
}

/// The histories of one monitor, those that two runs at least have.
fn of_monitor<'a>(tables: &[Option<&'a Table>], monitor: &str) -> Vec<History<'a>> {
    let history = |quantity: &'static str| {
        let name = format!("{monitor}.{quantity}");
        let column = |(run, table): (usize, &Option<&'a Table>)| {
            let table = (*table)?;
            Some((run, table.column("time")?, table.column(&name)?))
        };
        let of: Vec<_> = tables.iter().enumerate().filter_map(column).collect();
        let unit = tables.iter().flatten().find_map(|t| t.columns.iter().find(|c| c.name == name))?;
        (of.len() > 1).then_some(History { quantity, unit: &unit.unit, of })
    };
    let mut found: Vec<History> = QUANTITIES.into_iter().filter_map(history).collect();
    let most = |unit: &str| found.iter().filter(|h| h.unit == unit).map(History::largest).fold(0.0, f64::max);
    let drawn: Vec<bool> = found.iter().map(|h| h.largest() > NEGLIGIBLE * most(h.unit)).collect();
    let mut drawn = drawn.into_iter();
    found.retain(|_| drawn.next().unwrap_or(false));
    found
}

/// The runs' tables of monitors, and all names in them.
fn monitors(runs: &[Run]) -> (Vec<Option<&Table>>, Vec<String>) {
    let tables: Vec<Option<&Table>> = runs.iter().map(|run| run.source.monitors.as_ref().ok()).collect();
    let mut all: Vec<String> = Vec::new();
    for name in tables.iter().flatten().flat_map(|table| names(table, |_| true)) {
        if !all.contains(&name) {
            all.push(name);
        }
    }
    (tables, all)
}

/// A figure for each monitor and pair that two runs at least have.
pub fn figures_of(runs: &[Run], language: Language) -> Vec<Figure> {
    let (tables, all) = monitors(runs);
    let each = all.iter().filter_map(|name| {
        let histories = of_monitor(&tables, name);
        (!histories.is_empty()).then(|| figure(runs, name, &histories, language))
    });
    let named = |(k, figure): (usize, Figure)| Figure { file: format!("histories-{}.svg", k + 1), ..figure };
    each.enumerate().map(named).collect()
}

/// The histories for the page's script.
fn answering(runs: &[Run], monitor: &str, histories: &[History]) -> Curves {
    let curves = |history: &History| {
        let scale = Scale::suiting(history.unit, history.largest());
        let curve = |(run, time, values): &(usize, &[f64], &[f64])| {
            let points = time.iter().zip(values.iter()).map(|(t, x)| (*t, x * scale.factor));
            PlotCurve::new(&runs[*run].name, *run, Pen::Curve, points.collect())
        };
        history.of.iter().map(curve).collect::<Vec<_>>()
    };
    let drawn: Vec<(&History, Vec<PlotCurve>)> = histories.iter().map(|h| (h, curves(h))).collect();
    let plots = drawn.iter().map(|(history, curves)| Plot {
        title: history.quantity.into(),
        unit: Scale::suiting(history.unit, history.largest()).unit,
        log: false,
        ends: None,
        curves,
    });
    plot_curves::curves(monitor, "", "s", &plots.collect::<Vec<_>>())
}

fn figure(runs: &[Run], monitor: &str, histories: &[History], language: Language) -> Figure {
    let mut svg = Svg::new(WIDTH);
    let legend: Vec<PlotCurve> = runs
        .iter()
        .enumerate()
        .filter(|(run, _)| histories.iter().any(|h| h.of.iter().any(|(r, ..)| r == run)))
        .map(|(run, named)| PlotCurve::new(&named.name, run, Pen::Curve, Vec::new()))
        .collect();
    let mut top = plot::title(&mut svg, (LEFT, 0.0), WIDTH - LEFT - RIGHT, monitor, &legend);
    let times = histories.iter().flat_map(|h| &h.of).flat_map(|(_, time, _)| [time.first(), time.last()]);
    let (start, end) = plot::range(times.flatten().copied());
    let across = Ticks::within(start, end, 10);
    let mut bottom = top;
    for history in histories {
        let scale = Scale::suiting(history.unit, history.largest());
        let (low, high) =
            plot::range(history.of.iter().flat_map(|(_, _, x)| x.iter().map(|x| x * scale.factor)));
        bottom = top + HEADING + HEIGHT;
        let axes = Axes {
            left: LEFT,
            right: WIDTH - RIGHT,
            top: top + HEADING,
            bottom,
            across: across.clone(),
            up: Ticks::around(low, high, 4),
        };
        axes.draw(&mut svg);
        let title = scale.labelled(history.quantity);
        svg.text((LEFT, top + HEADING - 8.0), Anchor::Start, 13.0, Style::Bold, &title);
        for (run, time, values) in &history.of {
            let points = time.iter().zip(values.iter()).map(|(t, x)| axes.point(*t, x * scale.factor));
            svg.lines(*run, 1.3, &thin(points, 0.12));
        }
        top = bottom + 4.0;
    }
    for (t, label) in &across.marks {
        let x = LEFT + across.fraction(*t) * (WIDTH - LEFT - RIGHT);
        svg.text((x, bottom + 17.0), Anchor::Middle, 12.0, Style::Muted, label);
    }
    let below = say!(language, "time (s)");
    svg.text((WIDTH - RIGHT, bottom + 34.0), Anchor::End, 12.0, Style::Muted, &below);
    let svg = svg.finish(bottom + 42.0, monitor, &say!(language, "histories of the runs, overlaid"));
    let curves = Some(answering(runs, monitor, histories));
    Figure { heading: monitor.into(), file: String::new(), svg, caption: String::new(), curves, narrow: None }
}

/// How many rows of two histories are at the same times, where one is as the other begins; nothing where they are not.
fn common(first: &[f64], other: &[f64]) -> Option<usize> {
    let rows = first.len().min(other.len());
    (rows > 0 && first[..rows] == other[..rows]).then_some(rows)
}

/// By monitor and quantity the largest difference from the first run at one time, over the first run's largest value; up to
/// which time where one run is shorter. Of runs whose rows are at other times than the first's nothing is said.
pub fn parting(runs: &[Run], language: Language) -> Option<TextTable> {
    let (tables, all) = monitors(runs);
    let mut rows = Vec::new();
    for name in &all {
        for history in of_monitor(&tables, name) {
            let Some((_, time, first)) = history.of.iter().find(|(run, ..)| *run == 0) else { continue };
            let most = first.iter().filter(|x| x.is_finite()).fold(0.0_f64, |most, x| most.max(x.abs()));
            let cell = |run: usize| {
                let other = history.of.iter().find(|(r, ..)| *r == run);
                let other = other.and_then(|(_, times, values)| Some((times, values, common(time, times)?)));
                let Some((times, values, rows)) = other else { return Cell::number("–") };
                let apart = first.iter().zip(values.iter()).map(|(a, b)| (a - b).abs());
                let apart = apart.filter(|x| x.is_finite()).fold(0.0, f64::max);
                let percent = figures(100.0 * apart / most, 2);
                let text = if apart == 0.0 { "=".into() } else { format!("{}\u{a0}%", trimmed(&percent)) };
                let cell = Cell::number(text);
                match rows == time.len() && rows == times.len() {
                    true => cell,
                    false => {
                        let end = trimmed(&moment(time[rows - 1], time[rows - 1]));
                        cell.with(say!(language, "up to {time}\u{a0}s", time = end))
                    }
                }
            };
            let label = Cell::words(format!("{name} {}", history.quantity));
            rows.push(std::iter::once(label).chain((1..runs.len()).map(cell)).collect());
        }
    }
    let mut head = head(runs);
    head.remove(1);
    head[0].text = say!(language, "against {first}", first = runs.first()?.name);
    (!rows.is_empty()).then_some(TextTable { head: vec![head], rows })
}
