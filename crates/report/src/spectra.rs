//! Response spectra: of the motion that comes in, and of the monitors beside the free field's.

use tremolite_results::Table;

use crate::axes::Axes;
use crate::figure::{Block, Chapter, Figure, Section};
use crate::language::{Language, say};
use crate::period_axis::{axis, place};
use crate::plot::{self, Curve, Pen, RIGHT, WIDTH};
use crate::scale::{Scale, quantity, trimmed};
use crate::source::Source;
use crate::svg::{Anchor, Style, Svg};
use crate::text_table::{Cell, Head, TextTable};
use crate::ticks::Ticks;
use crate::units::Kind;

const AXES: [&str; 3] = ["x", "y", "z"];
/// A component this much smaller than the largest does not count as moving.
const IDLE: f64 = 1e-3;
/// Monitors in one figure: as many as a printed page has room for.
const ROWS: usize = 6;
const HEIGHT: f64 = 128.0;
/// From this many rows a period on an oscillator's peak is at most 1 − cos π/10 above its rows'.
const ROWS_A_PERIOD: f64 = 10.0;
/// Room left of each pair of axes for its numbers, and between neighbours.
const LEFT: f64 = 46.0;
const APART: f64 = 10.0;
/// What stands behind the name of a monitor where the free field at its level is meant.
const BESIDE: &str = ".free_field";

/// What is drawn: the columns of a point.
struct Point<'a> {
    name: String,
    /// Along x, y and z; empty where the file has none.
    spectrum: [&'a [f64]; 3],
}

impl<'a> Point<'a> {
    fn of(table: &'a Table, name: &str) -> Point<'a> {
        let along = |axis: &str| table.column(&format!("{name}.a{axis}")).unwrap_or(&[]);
        Point { name: name.into(), spectrum: AXES.map(along) }
    }

    fn is_known(&self) -> bool {
        self.spectrum.iter().any(|s| s.iter().any(|x| x.is_finite()))
    }

    /// Period (s), from one on, and value of the largest of a component.
    fn peak(&self, periods: &[f64], axis: usize, shortest: f64) -> Option<(f64, f64)> {
        let values = periods.iter().copied().zip(self.spectrum[axis].iter().copied());
        values
            .filter(|(period, x)| x.is_finite() && *period >= shortest)
            .reduce(|most, next| if next.1 > most.1 { next } else { most })
    }
}

/// A spectrum that is drawn, under the name it has in the legend.
struct Drawn<'a> {
    name: String,
    point: &'a Point<'a>,
    colour: usize,
    pen: Pen,
}

/// Spectra of one pair of axes, or of several components.
struct Row<'a> {
    /// Before the component in the heading; empty for none.
    name: &'a str,
    drawn: Vec<Drawn<'a>>,
}

fn largest(points: &[&Point], axis: usize) -> f64 {
    let values = points.iter().flat_map(|point| point.spectrum[axis]).copied();
    values.filter(|x| x.is_finite()).fold(0.0, f64::max)
}

/// The components that move.
fn moving(points: &[&Point]) -> Vec<usize> {
    let sizes = [0, 1, 2].map(|axis| largest(points, axis));
    let most = sizes.into_iter().fold(0.0, f64::max);
    (0..3).filter(|&axis| most > 0.0 && sizes[axis] > IDLE * most).collect()
}

/// The names of the monitors, in the order of the file.
fn monitors(table: &Table) -> Vec<&str> {
    let taken = ["given", "incident", "free_field.surface", "free_field.base"];
    let stems = table.columns.iter().filter_map(|column| column.name.strip_suffix(".ax"));
    stems.filter(|stem| !taken.contains(stem) && !stem.ends_with(BESIDE)).collect()
}

/// Rows of spectra by component, all over the same periods and on the same scale.
fn draw(source: &Source, rows: &[Row], axes_of: &[usize], periods: &[f64], title: &str) -> String {
    let language = source.language;
    let mut svg = Svg::new(WIDTH);
    let all: Vec<&Point> = rows.iter().flat_map(|row| row.drawn.iter().map(|drawn| drawn.point)).collect();
    let most = axes_of.iter().map(|&axis| largest(&all, axis)).fold(0.0, f64::max);
    let scale = source.scale(Kind::Acceleration);
    let (low, high) = plot::range(periods.iter().copied());
    // Where one component moves, monitors stand beside each other.
    let across = if axes_of.len() > 1 { axes_of.len() } else { rows.len().min(3) };
    let cells: Vec<(&Row, usize)> =
        rows.iter().flat_map(|row| axes_of.iter().map(move |&axis| (row, axis))).collect();
    let wide = (WIDTH - RIGHT + APART) / across as f64;
    let legend = rows.first().map_or(Vec::new(), |row| curves(row, 0, periods, &scale));
    let words = scale.labelled(&say!(language, "spectral acceleration, 5 % damping"));
    let mut top = plot::title(&mut svg, (LEFT, 0.0), WIDTH - LEFT - RIGHT, &words, &legend);
    for line in cells.chunks(across.max(1)) {
        for (k, (row, axis_of)) in line.iter().enumerate() {
            let mut drawn = curves(row, *axis_of, periods, &scale);
            drawn.iter_mut().for_each(|curve| curve.name.clear());
            let left = LEFT + k as f64 * wide;
            let heading = match row.name {
                "" => say!(language, "along {axis}", axis = AXES[*axis_of]),
                name => say!(language, "{name}, along {axis}", name = name, axis = AXES[*axis_of]),
            };
            svg.text((left, top + 16.0), Anchor::Start, 12.5, Style::Bold, &heading);
            let top = top + 24.0;
            let axes = Axes {
                left,
                right: left + wide - LEFT - APART,
                top,
                bottom: top + HEIGHT,
                across: axis(low, high),
                up: Ticks::within(0.0, 1.06 * most * scale.factor, 4),
            };
            plot::draw(&mut svg, &axes, &drawn);
        }
        top += 24.0 + HEIGHT + 24.0;
    }
    svg.text((WIDTH - RIGHT, top + 8.0), Anchor::End, 12.0, Style::Muted, &say!(language, "period (s)"));
    svg.finish(top + 16.0, title, &words)
}

fn curves(row: &Row, axis: usize, periods: &[f64], scale: &Scale) -> Vec<Curve> {
    let curve = |drawn: &Drawn| {
        let points = periods.iter().zip(drawn.point.spectrum[axis]);
        let points = points.map(|(period, value)| (place(*period), value * scale.factor)).collect();
        Curve::new(drawn.name.clone(), drawn.colour, drawn.pen, points)
    };
    row.drawn.iter().map(curve).collect()
}

/// Spectra of the motion given, of the wave that comes in, and of the free field; nothing without them.
pub fn of_input(source: &Source) -> Option<Figure> {
    let Some(Ok(table)) = &source.spectra else { return None };
    let (language, periods) = (source.language, table.column("period")?);
    let points =
        ["given", "incident", "free_field.surface", "free_field.base"].map(|name| Point::of(table, name));
    let names = [
        say!(language, "motion given"),
        say!(language, "incident wave"),
        say!(language, "free field, surface"),
        say!(language, "free field, base"),
    ];
    let pens = [(3, Pen::Line), (2, Pen::Line), (0, Pen::Dashed), (1, Pen::Dashed)];
    let known: Vec<&Point> = points.iter().filter(|point| point.is_known()).collect();
    let axes_of = moving(&known);
    if axes_of.is_empty() {
        return None;
    }
    let all = points.iter().zip(names).zip(pens).filter(|((point, _), _)| point.is_known());
    let drawn = all.map(|((point, name), (colour, pen))| Drawn { name, point, colour, pen }).collect();
    let title = say!(language, "Response spectra of the motion that comes in");
    let svg = draw(source, &[Row { name: "", drawn }], &axes_of, periods, &title);
    let caption = say!(
        language,
        "Largest acceleration of an oscillator of each period with 5 % of critical damping (ω² times its largest displacement). \
         Compare the motion given with the spectrum that the design calls for. The surface of level rock that is neither damped \
         nor layered would have twice the incident wave's. Numbers: spectra.csv."
    );
    Some(Figure { heading: title, file: "input-spectra.svg".into(), svg, caption, curves: None })
}

/// The section of the monitors; nothing where no earthquake came.
pub fn section(source: &Source) -> Option<Section> {
    let language = source.language;
    let heading = say!(language, "Response spectra at the monitors");
    let table = match &source.spectra {
        Some(Ok(table)) => table,
        Some(Err(why)) => return Some(Section::left_out(&heading, why)),
        None if source.motion.is_some() => {
            let why = say!(
                language,
                "The folder has no spectra.csv: an older version ran, or the run has not ended. Run the case again to have \
                 spectra of the monitors beside those of the free field."
            );
            return Some(Section::left_out(&heading, why));
        }
        None => return None,
    };
    let periods = table.column("period").unwrap_or(&[]);
    let of = |name: &str| (Point::of(table, name), Point::of(table, &format!("{name}{BESIDE}")));
    let points: Vec<(Point, Point)> =
        monitors(table).into_iter().map(of).filter(|(own, _)| own.is_known()).collect();
    let own: Vec<&Point> = points.iter().map(|(own, _)| own).collect();
    let axes_of = moving(&own);
    if axes_of.is_empty() {
        let why = say!(language, "spectra.csv holds no monitor that moves.");
        return Some(Section::left_out(&heading, why));
    }
    let rows: Vec<Row> = points.iter().map(|pair| row(pair, language)).collect();
    let beside = points.iter().any(|(_, beside)| beside.is_known());
    let mut caption = say!(
        language,
        "Spectral acceleration with 5 % damping, all on one scale. Each monitor is drawn full; dashed is the free field at its own \
         level, which is how the ground would move there without caverns. Where the monitor rises above it, the cavern or the \
         lining rings at that period or amplifies the wave; where it stays below, the cavern shields it."
    );
    if !beside {
        caption = say!(
            language,
            "Spectral acceleration with 5 % damping, all on one scale. No column of ground stood beside the model, so there is no \
             free field to compare with."
        );
    }
    let figures = rows.chunks(ROWS).enumerate().map(|(k, rows)| Figure {
        heading: String::new(),
        file: if k == 0 { "spectra.svg".into() } else { format!("spectra-{}.svg", k + 1) },
        svg: draw(source, rows, &axes_of, periods, &heading),
        caption: if k == 0 { caption.clone() } else { String::new() },
        curves: None,
    });
    let block = Block {
        text: explained(source),
        figures: figures.collect(),
        tables: vec![peaks(source, &points, &axes_of, periods)],
        ..Block::default()
    };
    Some(Section::Told(Chapter { id: "spectra", heading, blocks: vec![block] }))
}

fn row<'a>((own, beside): &'a (Point<'a>, Point<'a>), language: Language) -> Row<'a> {
    let mut drawn = Vec::new();
    if beside.is_known() {
        let name = say!(language, "free field at the monitor's level");
        drawn.push(Drawn { name, point: beside, colour: 3, pen: Pen::Dashed });
    }
    drawn.push(Drawn { name: say!(language, "monitor"), point: own, colour: 0, pen: Pen::Line });
    Row { name: &own.name, drawn }
}

/// Time between rows of the histories (s).
fn interval(source: &Source) -> Option<f64> {
    match source.monitors.as_ref().ok()?.column("time")? {
        [first, second, ..] => Some(second - first),
        _ => None,
    }
}

/// Which accelerations these are of.
fn explained(source: &Source) -> String {
    let Some(interval) = interval(source) else { return String::new() };
    let shown = |x: f64| trimmed(&quantity("s", x));
    say!(
        source.language,
        "Of the accelerations between rows of the histories, {interval} apart, of the monitors and of the free field alike. \
         Oscillators are looked at in the rows: one that rings alone at a period below {short} may peak more than 5 % above what is \
         drawn, so the table has the largest from there on. Short periods that the motion given does not have come from cracks \
         and joints that open and close.",
        interval = shown(interval),
        short = shown(ROWS_A_PERIOD * interval)
    )
}

/// The largest of each spectrum, and at which period.
fn peaks(source: &Source, points: &[(Point, Point)], axes_of: &[usize], periods: &[f64]) -> TextTable {
    let language = source.language;
    let shortest = ROWS_A_PERIOD * interval(source).unwrap_or(0.0);
    let scale = source.scale(Kind::Acceleration);
    let largest = scale.labelled(&say!(language, "largest"));
    let at = say!(language, "at period (s)");
    let pair = || [Head::number(&largest), Head::number(&at)];
    let over = vec![
        Head::words("").over(2),
        Head::number(say!(language, "monitor")).over(2),
        Head::number(say!(language, "free field at its level")).over(2),
    ];
    let mut head = vec![Head::words(say!(language, "monitor")), Head::words(say!(language, "along"))];
    head.extend(pair().into_iter().chain(pair()));
    let mut rows = Vec::new();
    for (own, beside) in points {
        let mut name = Cell::words(own.name.as_str());
        for &axis in axes_of {
            let mut row = vec![std::mem::take(&mut name), Cell::words(AXES[axis])];
            for point in [own, beside] {
                let (period, value) = point.peak(periods, axis, shortest).unwrap_or((f64::NAN, f64::NAN));
                row.extend([scale.number(value), crate::scale::figures(period, 2)].map(Cell::number));
            }
            rows.push(row);
        }
    }
    TextTable { head: vec![over, head], rows }
}
