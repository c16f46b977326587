//! Figure of section forces drawn on the lining's own shape, at right angles to it.

use crate::chapter::figure::Figure;
use crate::drawing::plot::{self, WIDTH};
use crate::drawing::svg::{Anchor, LINES, Style, Svg, text_width};
use crate::language::{Language, say};
use crate::quantities::scale::{figures, trimmed};
use crate::section_forces::along_lining::COLOURS;
use crate::section_forces::stations::{Extreme, Lining, Station, forces, joints, kilo};

/// Longest ordinate.
const LONGEST: f64 = 34.0;
const TALLEST: f64 = 420.0;
const TOP: f64 = 52.0;
/// Beside the ordinates, for their numbers.
const ROOM: f64 = 46.0;
/// By this texts are larger where the drawing is shrunk to half a page's width.
const LARGER: f64 = 2.0;
/// Room beside the ordinates there, where their numbers stand above the drawing.
const LARGER_ROOM: f64 = 14.0;
/// Lines after the stages, of the largest and of the smallest: the last is dashed, so that print without colours tells them apart.
const STROKES: [usize; 3] = [COLOURS[0], COLOURS[1], COLOURS[2] + LINES.len()];
/// The forces in a word there.
const BRIEF: [&str; 3] = ["N (kN/m)", "M (kN\u{a0}m/m)", "Q (kN/m)"];

/// Forces at a station by which a diagram is drawn; none where there is no number.
type Of<'a> = &'a dyn Fn(&Station) -> Option<f64>;

/// The figure of one section; nothing for fewer than three stations, which have no shape.
pub fn figure(
    language: Language,
    lining: &Lining,
    (y, section): (f64, &[&Station]),
    suffix: &str,
) -> Option<Figure> {
    if section.len() < 3 || !section.iter().any(|s| s.after[0].is_finite() || s.least.is_some()) {
        return None;
    }
    let (x, z) =
        (plot::range(section.iter().map(|s| s.place[0])), plot::range(section.iter().map(|s| s.place[2])));
    let title = say!(
        language,
        "{lining}: forces on the lining's shape at y = {y}\u{a0}m",
        lining = lining.name,
        y = trimmed(&figures(y, 3))
    );
    let description = say!(language, "thrust, moment and shear on the section of the lining");
    let drawn = |larger: f64| {
        let cell = WIDTH / 3.0;
        let shrunk = larger > 1.0;
        let margin = LONGEST + if shrunk { LARGER_ROOM } else { ROOM };
        let zoom = ((cell - 2.0 * margin) / (x.1 - x.0).max(1e-9))
            .min((TALLEST - 2.0 * LONGEST) / (z.1 - z.0).max(1e-9));
        let room = if shrunk { LARGER_ROOM } else { ROOM };
        let height = (z.1 - z.0) * zoom + 2.0 * LONGEST + 2.0 * room;
        let mut svg = Svg::new(WIDTH);
        // There a line more: between which values the force went.
        let line = if shrunk { 15.0 * larger } else { 0.0 };
        let top = legend(language, &mut svg, lining, larger) + line;
        for (i, force) in forces(language).into_iter().enumerate() {
            let force = if shrunk { BRIEF[i].to_owned() } else { force };
            let middle = (i as f64 + 0.5) * cell;
            let size = (13.0 * larger).min(0.96 * cell / text_width(&force, 1.0));
            svg.text((middle, top - 8.0 - line), Anchor::Middle, size, Style::Bold, &force);
            if let Some((least, most)) = extent(section, i).filter(|_| shrunk) {
                let range = say!(language, "{least} to {most}", least = kilo(least), most = kilo(most));
                let size = (12.0 * larger).min(0.96 * cell / text_width(&range, 1.0));
                svg.text((middle, top - 8.0), Anchor::Middle, size, Style::Plain, &range);
            }
            let place = |s: &Station| {
                let down = LONGEST + room + (z.1 - s.place[2]) * zoom;
                (middle + (s.place[0] - 0.5 * (x.0 + x.1)) * zoom, top + down)
            };
            let places: Vec<(f64, f64)> = section.iter().map(|s| place(s)).collect();
            diagram(&mut svg, (section, &places), i, !shrunk);
        }
        if !shrunk {
            return svg.finish(top + height + 4.0, &title, &description);
        }
        // There no caption says which side is which.
        let sides = say!(language, "outwards: N in compression, Q positive; M on the side that it stretches");
        let size = (12.0 * larger).min(0.96 * WIDTH / text_width(&sides, 1.0));
        svg.text((WIDTH, top + height + 12.0 * larger), Anchor::End, size, Style::Muted, &sides);
        svg.finish(top + height + 16.0 * larger, &title, &description)
    };
    let (svg, narrow) = (drawn(1.0), Some(drawn(LARGER)));
    let caption = say!(
        language,
        "Section y = {y}\u{a0}m; to the left x is smaller. The thin line is the middle of the lining. N is drawn outwards \
         where it compresses, Q where it is positive, M on the side that it stretches; each of the three has a scale of its own, set by its largest value. Look \
         where M peaks, and whether N still compresses there.",
        y = trimmed(&format!("{y:.2}").replace('-', "−"))
    );
    Some(Figure {
        heading: title,
        file: format!("lining-shape{suffix}.svg"),
        svg,
        caption,
        curves: None,
        narrow,
    })
}

/// Names and colours in rows; returns where the drawings begin.
fn legend(language: Language, svg: &mut Svg, lining: &Lining, larger: f64) -> f64 {
    let (mut x, mut y) = (24.0, 16.0 * larger.sqrt());
    let all = [
        lining.after.clone(),
        say!(language, "largest while the ground shakes"),
        say!(language, "smallest while the ground shakes"),
    ];
    for (k, name) in all.iter().enumerate().take(if lining.shaken() { 3 } else { 1 }) {
        let wide = 26.0 + text_width(name, 12.0 * larger) + 16.0;
        if x + wide > WIDTH && x > 24.0 {
            (x, y) = (24.0, y + 18.0 * larger);
        }
        svg.lines(STROKES[k], 2.4, &[vec![(x, y - 4.5 * larger), (x + 20.0, y - 4.5 * larger)]]);
        svg.text((x + 26.0, y), Anchor::Start, 12.0 * larger, Style::Plain, name);
        x += wide;
    }
    y + (TOP - 16.0) * larger
}

/// The smallest and the largest of a force, after the stages and in the shaking; none where there is no number.
fn extent(section: &[&Station], i: usize) -> Option<(f64, f64)> {
    let of = |s: &Station| [Some(s.after[i]), s.most.map(|e| e.forces[i]), s.least.map(|e| e.forces[i])];
    let values = section.iter().flat_map(|s| of(s)).flatten().filter(|value| value.is_finite());
    values.fold(None, |range, x| {
        let (least, most) = range.unwrap_or((x, x));
        Some((x.min(least), x.max(most)))
    })
}

/// One force over the shape; with `numbered`, its largest values to either side stand at their ordinates.
fn diagram(svg: &mut Svg, (section, places): (&[&Station], &[(f64, f64)]), i: usize, numbered: bool) {
    let joints = joints(section);
    let normals = normals(&joints, places);
    // A positive moment stretches the intrados, which is inside. Thrust mostly compresses, and has more room outside.
    let side = if i < 2 { -1.0 } else { 1.0 };
    let finite = |x: f64| x.is_finite().then_some(x);
    let extreme = |of: Option<Extreme>| of.and_then(|e| finite(e.forces[i]));
    let after = |s: &Station| finite(s.after[i]);
    let most = |s: &Station| extreme(s.most);
    let least = |s: &Station| extreme(s.least);
    let all: [Of; 3] = [&after, &most, &least];
    let values = || section.iter().flat_map(|s| all.iter().filter_map(|of| of(s)));
    let largest = values().fold(0.0, |most: f64, x| most.max(x.abs()));
    let zoom = if largest > 0.0 { LONGEST / largest } else { 0.0 };
    let tip = |k: usize, value: f64| {
        let (p, n) = (places[k], normals[k]);
        (p.0 + side * value * zoom * n.0, p.1 + side * value * zoom * n.1)
    };
    let next = |k: usize| (k + 1) % places.len();
    for k in (0..places.len()).filter(|&k| joints[k]) {
        svg.rule(places[k], places[next(k)], true);
    }
    // Ordinates of what stood still, then the lines over all.
    for (k, station) in section.iter().enumerate() {
        if let Some(value) = after(station) {
            svg.rule(places[k], tip(k, value), false);
        }
    }
    for (number, of) in all.iter().enumerate().rev() {
        let mut lines = vec![Vec::new()];
        for (k, station) in section.iter().enumerate() {
            if k > 0 && !joints[k - 1] {
                lines.push(Vec::new());
            }
            match (of(station), lines.last_mut()) {
                (Some(value), Some(line)) => line.push(tip(k, value)),
                _ => lines.push(Vec::new()),
            }
        }
        let ends = [section.len() - 1, 0].map(|k| of(section[k]).map(|value| tip(k, value)));
        if let ([Some(last), Some(first)], true) = (ends, joints[section.len() - 1]) {
            lines.push(vec![last, first]);
        }
        lines.retain(|line| !line.is_empty());
        if !lines.is_empty() {
            svg.lines(STROKES[number], if number == 0 { 1.9 } else { 1.2 }, &lines);
        }
    }
    if !numbered {
        return;
    }
    // The longest ordinate to either side, with its number.
    let mut ends: Vec<(usize, f64)> = Vec::new();
    for sign in [1.0, -1.0] {
        let each =
            (0..section.len()).flat_map(|k| all.iter().filter_map(move |of| Some((k, of(section[k])?))));
        if let Some((k, value)) = each.max_by(|a, b| (sign * a.1).total_cmp(&(sign * b.1)))
            && sign * value > 0.0
        {
            ends.push((k, value));
        }
    }
    for (k, value) in ends {
        let (at, n) = (tip(k, value), normals[k]);
        let way = if side * value < 0.0 { -1.0 } else { 1.0 };
        let (dx, dy) = (way * n.0, way * n.1);
        let anchor = if dx > 0.4 {
            Anchor::Start
        } else if dx < -0.4 {
            Anchor::End
        } else {
            Anchor::Middle
        };
        svg.text((at.0 + 6.0 * dx, at.1 + 4.0 + 10.0 * dy), anchor, 12.0, Style::Bold, &kilo(value));
    }
}

/// Across the lining and outwards, at each station.
fn normals(joints: &[bool], places: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let number = places.len();
    let mean = |of: fn(&(f64, f64)) -> f64| places.iter().map(of).sum::<f64>() / number as f64;
    let centre = (mean(|p| p.0), mean(|p| p.1));
    let normal = |k: usize| {
        // Not across a corner, where the wall turns.
        let previous = (k + number - 1) % number;
        let a = places[if joints[previous] { previous } else { k }];
        let b = places[if joints[k] { (k + 1) % number } else { k }];
        let length = (b.0 - a.0).hypot(b.1 - a.1).max(1e-9);
        let n = ((b.1 - a.1) / length, -(b.0 - a.0) / length);
        let outwards = (places[k].0 - centre.0) * n.0 + (places[k].1 - centre.1) * n.1;
        if outwards < 0.0 { (-n.0, -n.1) } else { n }
    };
    (0..number).map(normal).collect()
}
