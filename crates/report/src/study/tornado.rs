//! Tornados: how far each key, changed alone, moves a result.

use tremolite_results::study::{Study, Tornado};

use super::Figure;
use super::paper::{file_part, suiting};
use crate::drawing::svg::{Anchor, LINES, Style, Svg, text_width};
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};

const WIDTH: f64 = 940.0;
const ROW: f64 = 30.0;
const TOP: f64 = 40.0;
/// What study.json calls the value of a key that is the case's.
const AS_IT_IS: &str = "as it is";
/// Bars at most.
const MOST: usize = 30;

/// One figure a measure.
pub fn figures(study: &Study, language: Language) -> Vec<Figure> {
    study.tornados.iter().map(|tornado| figure(study, language, tornado)).collect()
}

fn figure(study: &Study, language: Language, tornado: &Tornado) -> Figure {
    let bars = &tornado.bars[..tornado.bars.len().min(MOST)];
    let column = study.measures.iter().find(|m| m.name == tornado.measure).cloned().unwrap_or_default();
    let ends = bars.iter().flat_map(|b| [b.low.1, b.high.1]).chain([tornado.base]);
    let scale = suiting(&column, ends);
    let low = bars.iter().map(|b| b.low.1).fold(tornado.base, f64::min);
    let high = bars.iter().map(|b| b.high.1).fold(tornado.base, f64::max);
    let names = bars.iter().map(|b| text_width(&b.name, 12.0)).fold(80.0, f64::max);
    let left = names.min(380.0) + 24.0;
    let room = 0.25 * (high - low).max(1e-12 * high.abs().max(1e-300));
    let axis = Ticks::within((low - room) * scale.factor, (high + room) * scale.factor, 8);
    let place = |x: f64| left + axis.fraction(x * scale.factor) * (WIDTH - left - 16.0);
    let bottom = TOP + ROW * bars.len() as f64;
    let mut svg = Svg::new(WIDTH);
    let title = match tornado.beside.as_str() {
        "" => say!(language, "{measure}: what each key changes", measure = tornado.measure),
        base => say!(
            language,
            "{measure}: what each key changes of {base}",
            measure = tornado.measure,
            base = base
        ),
    };
    svg.text((16.0, 18.0), Anchor::Start, 14.0, Style::Bold, &title);
    for (value, label) in &axis.marks {
        let x = left + axis.fraction(*value) * (WIDTH - left - 16.0);
        svg.rule((x, TOP), (x, bottom), false);
        svg.text((x, bottom + 17.0), Anchor::Middle, 12.0, Style::Muted, label);
    }
    for (k, bar) in bars.iter().enumerate() {
        let y = TOP + ROW * k as f64;
        let (from, to) = (place(bar.low.1), place(bar.high.1).max(place(bar.low.1) + 1.0));
        svg.areas(LINES[0], &[vec![(from, y + 6.0), (to, y + 6.0), (to, y + 22.0), (from, y + 22.0)]]);
        svg.text((left - 8.0, y + 18.0), Anchor::End, 12.0, Style::Plain, &bar.name);
        let named =
            |value: &str| if value == AS_IT_IS { say!(language, "as it is") } else { value.to_owned() };
        svg.text((from - 5.0, y + 18.0), Anchor::End, 11.0, Style::Muted, &named(&bar.low.0));
        svg.text((to + 5.0, y + 18.0), Anchor::Start, 11.0, Style::Muted, &named(&bar.high.0));
    }
    svg.rule((place(tornado.base), TOP), (place(tornado.base), bottom), true);
    svg.text(
        (WIDTH - 16.0, bottom + 36.0),
        Anchor::End,
        12.0,
        Style::Muted,
        &scale.labelled(&tornado.measure),
    );
    let said = say!(language, "Bars of the results at the values of each key, the widest first.");
    let svg = svg.finish(bottom + 44.0, &title, &said);
    let value = format!("{} {}", scale.number(tornado.base), scale.unit);
    let mut caption = vec![match tornado.beside.as_str() {
        "" => say!(
            language,
            "{measure} as the case is: {value}; at the ends of a bar the values of its key.",
            measure = tornado.measure,
            value = value.trim_end()
        ),
        base => say!(
            language,
            "{measure} of {base}: {value}; at the ends of a bar the values of its key.",
            measure = tornado.measure,
            base = base,
            value = value.trim_end()
        ),
    }];
    let more = tornado.bars.len().saturating_sub(MOST);
    if more > 0 {
        caption.push(say!(language, "{some} more change it less.", some = more));
    }
    let caption = language.joined(&caption);
    let name: String = [&tornado.measure, &tornado.beside].map(|part| file_part(part)).join("-");
    Figure { file: format!("tornado-{}.svg", name.trim_end_matches('-')), svg, caption }
}
