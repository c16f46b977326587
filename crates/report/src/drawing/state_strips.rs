//! Strips: which of several states hold, over time.

use crate::drawing::axes::Axes;
use crate::drawing::svg::Svg;
use crate::drawing::ticks::Ticks;

/// Height of one strip.
const PITCH: f64 = 16.0;

/// One state.
#[derive(Clone, Debug, PartialEq)]
pub struct Strip {
    pub name: String,
    /// Which colour.
    pub colour: usize,
    /// For each time, whether it held in the step that led there.
    pub on: Vec<bool>,
}

/// Draws the strips one below the other from `top` on, over times by the axis `across` that shows them in SI times
/// `factor`.
pub(crate) fn draw(
    svg: &mut Svg,
    strips: &[Strip],
    (across, time, factor): (&Ticks, &[f64], f64),
    (left, right, top): (f64, f64, f64),
) -> Axes {
    let rows = strips.len() as f64;
    let up = Ticks { range: (0.0, rows), marks: Vec::new() };
    let axes = Axes { left, right, top, bottom: top + rows * PITCH + 8.0, across: across.clone(), up };
    axes.draw(svg);
    for (k, strip) in strips.iter().enumerate() {
        let spans = spans(&strip.on, time);
        let bars = spans.map(|(from, to)| {
            let ends = [from, to].map(|t| axes.point(t * factor, rows - 0.5 - k as f64));
            // A step too short to be seen is shown all the same.
            vec![ends[0], (ends[1].0.max(ends[0].0 + 1.0), ends[1].1)]
        });
        svg.lines(strip.colour, 9.0, &bars.collect::<Vec<_>>());
    }
    axes
}

/// From when to when a state held without a break.
fn spans<'a>(on: &'a [bool], time: &'a [f64]) -> impl Iterator<Item = (f64, f64)> + 'a {
    let starts = (0..on.len()).filter(|&i| on[i] && (i == 0 || !on[i - 1]));
    starts.filter_map(move |first| {
        let steps = on[first..].iter().take_while(|on| **on).count();
        Some((*time.get(first.saturating_sub(1))?, *time.get(first + steps - 1)?))
    })
}

#[cfg(test)]
mod tests {
    use super::spans;

    #[test]
    fn a_state_lasts_from_the_start_of_its_first_step_to_the_end_of_its_last() {
        let time = [0.0, 1.0, 2.0, 3.0, 4.0];
        let spans: Vec<_> = spans(&[false, true, true, false, true], &time).collect();
        assert_eq!(spans, [(0.0, 2.0), (3.0, 4.0)]);
    }
}
