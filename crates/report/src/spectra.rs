//! Response spectra: of the motion that comes in, and of the monitors beside the free field's.

mod figure;

use std::collections::HashSet;

use tremolite_results::{Subject, Table};

use crate::chapter::figure::{Block, Chapter, Figure, Section};
use crate::chapter::text_table::{Cell, Head, TextTable};
use crate::drawing::plot::Pen;
use crate::language::{Language, say};
use crate::quantities::scale::{quantity, trimmed};
use crate::quantities::units::Kind;
use crate::source::Source;
use crate::spectra::figure::{AXES, DrawnSpectra, SpectraRow, SpectrumPlace, figure, moving};

/// Monitors in one figure: as many as a printed page has room for.
const ROWS: usize = 6;
/// Monitors drawn and listed, at most; of more nobody reads each.
const MOST: usize = 14 * ROWS;
/// From this many rows a period on an oscillator's peak is at most 1 − cos π/10 above its rows'.
const ROWS_A_PERIOD: f64 = 10.0;
/// The names of the monitors, in the order of the file.
fn monitors(table: &Table) -> Vec<&str> {
    let own = table.columns.iter().filter_map(|column| match &column.subject {
        Subject::Monitor(name) if column.quantity == "ax" => Some(name.as_str()),
        _ => None,
    });
    own.collect()
}

/// Spectra of the motion given, of the wave that comes in, and of the free field; nothing without them.
pub fn of_input(source: &Source) -> Option<Figure> {
    let Some(Ok(table)) = &source.spectra else { return None };
    let (language, periods) = (source.language, table.column("period")?);
    let points = ["given", "incident", "free_field.surface", "free_field.base", "free_field.equivalent"]
        .map(|name| SpectrumPlace::of(table, name));
    let names = [
        say!(language, "motion given"),
        say!(language, "incident wave"),
        say!(language, "free field, surface"),
        say!(language, "free field, base"),
        say!(language, "equivalent-linear column, surface"),
    ];
    let pens = [(3, Pen::Curve), (2, Pen::Curve), (0, Pen::Dashed), (1, Pen::Dotted), (5, Pen::Dashed)];
    let known: Vec<&SpectrumPlace> = points.iter().filter(|point| point.is_known()).collect();
    let axes_of = moving(&known);
    if axes_of.is_empty() {
        return None;
    }
    let all = points.iter().zip(names).zip(pens).filter(|((point, _), _)| point.is_known());
    let drawn =
        all.map(|((point, name), (colour, pen))| DrawnSpectra { name, point, colour, pen, periods: None });
    let mut drawn: Vec<DrawnSpectra> = drawn.collect();
    let facts = source.facts();
    let target = facts.computed.motion.target.unwrap_or_default();
    let called = SpectrumPlace { name: String::new(), spectrum: [&target.sa, &target.sa, &[]] };
    if called.is_known() {
        let name = say!(language, "design spectrum of the motion given");
        let (colour, periods) = (4, Some(&target.period[..]));
        drawn.push(DrawnSpectra { name, point: &called, colour, pen: Pen::Marked, periods });
    }
    let title = say!(language, "Response spectra of the motion that comes in");
    let rows = [SpectraRow { name: "", drawn }];
    let figure = figure(&rows, &axes_of, periods, &title, "input-spectra.svg".into(), source);
    let mut caption = say!(
        language,
        "Largest acceleration of an oscillator of each period with 5 % of critical damping (ω² times its largest displacement). \
         Compare the motion given with the spectrum that the design calls for. The surface of level rock that is neither damped \
         nor layered would have twice the incident wave's. Numbers: spectra.csv."
    );
    if points[4].is_known() {
        caption.push_str(&say!(
            language,
            " The ground can yield: the equivalent-linear column of its own laws stands beside its surface. Where shaking is weak the two \
             agree; where it is strong that column is an approximation, which may damp short periods too much."
        ));
    }
    Some(Figure { heading: title, caption, ..figure })
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
    let of = |name: &str| {
        (SpectrumPlace::of(table, name), SpectrumPlace::of(table, &format!("{name}.free_field")))
    };
    let points: Vec<Pair> = monitors(table).into_iter().map(of).filter(|(own, _)| own.is_known()).collect();
    let all = points.len();
    let points = largest(points);
    let own: Vec<&SpectrumPlace> = points.iter().map(|(own, _)| own).collect();
    let axes_of = moving(&own);
    if axes_of.is_empty() {
        let why = say!(language, "spectra.csv holds no monitor that moves.");
        return Some(Section::left_out(&heading, why));
    }
    let rows: Vec<SpectraRow> = points.iter().map(|pair| row(pair, language)).collect();
    let beside = points.iter().any(|(_, beside)| beside.is_known());
    let mut caption = say!(
        language,
        "Spectral acceleration with 5 % damping, all on one scale. Each monitor is drawn full; dashed is the free field at its own \
         level, which is how the ground would move there without caverns."
    );
    if let Some(interval) = interval(source) {
        caption.push_str(&say!(
            language,
            " Where the monitor rises above it at periods from {short} on, the cavern or the lining rings at that period or \
             amplifies the wave; where it stays below, the cavern shields it.",
            short = trimmed(&quantity("s", ROWS_A_PERIOD * interval))
        ));
    }
    if !beside {
        caption = say!(
            language,
            "Spectral acceleration with 5 % damping, all on one scale. No column of ground stood beside the model, so there is no \
             free field to compare with."
        );
    }
    if all > points.len() {
        caption.push_str(&say!(
            language,
            " Drawn and listed are the {most} of {all} monitors with the largest spectra; spectra.csv has all.",
            most = points.len(),
            all = all
        ));
    }
    let figures = rows.chunks(ROWS).enumerate().map(|(k, rows)| {
        let file = if k == 0 { "spectra.svg".into() } else { format!("spectra-{}.svg", k + 1) };
        let figure = figure(rows, &axes_of, periods, &heading, file, source);
        Figure { caption: if k == 0 { caption.clone() } else { String::new() }, ..figure }
    });
    let block = Block {
        text: explained(source),
        figures: figures.collect(),
        tables: vec![peaks(source, &points, &axes_of, periods)],
        ..Block::default()
    };
    Some(Section::Told(Chapter { id: "spectra", heading, blocks: vec![block] }))
}

/// A monitor, and the free field at its level.
type Pair<'a> = (SpectrumPlace<'a>, SpectrumPlace<'a>);

/// Of more than [`MOST`] those with the largest values of any component, in their order.
fn largest(points: Vec<Pair<'_>>) -> Vec<Pair<'_>> {
    if points.len() <= MOST {
        return points;
    }
    let mut sizes: Vec<(usize, f64)> = points.iter().map(|(own, _)| own.largest()).enumerate().collect();
    sizes.sort_by(|a, b| b.1.total_cmp(&a.1));
    let chosen: HashSet<usize> = sizes.into_iter().take(MOST).map(|(k, _)| k).collect();
    points.into_iter().enumerate().filter(|(k, _)| chosen.contains(k)).map(|(_, pair)| pair).collect()
}

fn row<'a>((own, beside): &'a Pair<'a>, language: Language) -> SpectraRow<'a> {
    let mut drawn = Vec::new();
    if beside.is_known() {
        let name = say!(language, "free field at the monitor's level");
        drawn.push(DrawnSpectra { name, point: beside, colour: 3, pen: Pen::Dashed, periods: None });
    }
    drawn.push(DrawnSpectra {
        name: say!(language, "monitor"),
        point: own,
        colour: 0,
        pen: Pen::Curve,
        periods: None,
    });
    SpectraRow { name: &own.name, drawn }
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
         Rows so far apart show short periods too low, by 20 % at the shortest that is drawn, five rows, and by 5 to 9 % at {short}, \
         ten rows: the table has the largest from there on. Short periods that the motion given does not have come from cracks \
         and joints that open and close, sampled by the rows.",
        interval = shown(interval),
        short = shown(ROWS_A_PERIOD * interval)
    )
}

/// The largest of each spectrum, and at which period.
fn peaks(source: &Source, points: &[Pair], axes_of: &[usize], periods: &[f64]) -> TextTable {
    let language = source.language;
    let shortest = ROWS_A_PERIOD * interval(source).unwrap_or(0.0);
    let scale = source.scale(Kind::Acceleration);
    let largest = scale.labelled(&say!(language, "largest from ten rows a period on"));
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
                row.extend(
                    [scale.number(value), crate::quantities::scale::figures(period, 2)].map(Cell::number),
                );
            }
            rows.push(row);
        }
    }
    TextTable { head: vec![over, head], rows }
}
