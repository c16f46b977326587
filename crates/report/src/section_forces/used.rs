//! Figure and table of what sections use of their strength.

use tremolite_results::utilisation::UtilisationRow;
use tremolite_results::{SectionStrength, Summary, Used};

use crate::chapter::figure::{Block, Figure};
use crate::chapter::text_table::{Cell, Head, TextTable};
use crate::drawing::axes::Axes;
use crate::drawing::plot::{self, LEFT, NARROW, Pen, PlotCurve, RIGHT, WIDTH};
use crate::drawing::svg::{Anchor, Style, Svg};
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};
use crate::quantities::scale::{figures, moment, trimmed};
use crate::quantities::units::Kind;
use crate::section_forces::stations::{Station, distance, kilo};
use crate::source::Source;

/// Beyond this a utilisation says no more than that nearly nothing is borne.
const MOST: f64 = 100.0;

/// Beyond this it is drawn at this, so that 1 can be told.
const DRAWN: f64 = 5.0;

/// Width (m) of a crack below which it counts as closed: a crack of 0.01 mm is seen by no eye.
const SEEN: f64 = 1e-5;

/// A utilisation as the page shows it. Where nothing at all is borne it is infinite, which is no number in the file.
pub fn shown(value: f64) -> String {
    match value {
        v if v.is_nan() || v.is_infinite() => "∞".to_owned(),
        v if v > MOST => format!("> {MOST}"),
        v => figures(v, 3),
    }
}

/// The clauses by which a lining is judged in thrust and moment and in shear; none where its code has none.
pub fn clauses(of: &SectionStrength) -> [&'static str; 2] {
    match (of.code.starts_with("GB"), of.reinforced > 0) {
        (false, true) => ["6.1", "6.2.2"],
        (false, false) => ["12.6.1", "12.6.3"],
        (true, true) => ["6.2", "6.3.3"],
        (true, false) => ["D.2.1", ""],
    }
}

/// Why nothing is borne in shear; empty where something is.
pub fn without_shear(language: Language, of: &SectionStrength) -> String {
    let infinite = of.shear.as_ref().filter(|used| !used.value.is_finite());
    match infinite.map(|used| used.forces[0]) {
        Some(thrust) if thrust > 0.0 => {
            say!(language, "tension of {thrust} kN/m leaves no resistance to shear", thrust = kilo(thrust))
        }
        Some(_) => say!(language, "too little is compressed to resist shear"),
        None => String::new(),
    }
}

/// The part of the chapter; nothing where no section is judged.
pub fn block(source: &Source, facts: &Summary) -> Option<Block> {
    let language = source.language;
    if facts.parts.sections.is_empty() {
        return None;
    }
    let mut block = Block {
        heading: say!(language, "What the sections use of their strength"),
        text: say!(
            language,
            "Thrust and moment of one instant, in every step, on the ray from the origin to the border of what the section bears: 1 is \
             all of its strength. Shear is |Q| over its resistance. utilisation.csv has every station."
        ),
        tables: vec![table(source, facts)],
        ..Block::default()
    };
    block.notes.extend(facts.parts.sections.iter().map(|(lining, of)| rule(source, lining, of)));
    Some(block)
}

fn table(source: &Source, facts: &Summary) -> TextTable {
    let language = source.language;
    let head = vec![
        Head::words(say!(language, "lining")),
        Head::words(""),
        Head::number(say!(language, "utilisation")),
        Head::number("N (kN/m)"),
        Head::number("M (kN\u{a0}m/m)"),
        Head::number("Q (kN/m)"),
        Head::words(say!(language, "where and when")),
    ];
    let mut rows = Vec::new();
    for (lining, of) in &facts.parts.sections {
        let each =
            [(say!(language, "thrust and moment"), &of.bending), (say!(language, "shear force"), &of.shear)];
        for (k, (what, used)) in each.into_iter().enumerate() {
            let Some(used) = used else { continue };
            let mut row = vec![Cell::words(if k == 0 { lining.as_str() } else { "" }), Cell::words(what)];
            row.push(Cell::number(shown(used.value)));
            row.extend(used.forces.map(|force| Cell::number(kilo(force))));
            row.push(Cell::words(place(source, used)));
            rows.push(row);
        }
        if let Some(crack) = of.crack.as_ref().filter(|crack| crack.station > 0) {
            let mut row = vec![Cell::words(""), Cell::words(say!(language, "crack width left"))];
            row.push(Cell::number(left(source, of)));
            row.extend(crack.forces.map(|force| Cell::number(kilo(force))));
            let [x, y, z] = coordinates(crack.at);
            row.push(Cell::number("–"));
            row.push(Cell::words(say!(language, "({x}, {y}, {z}) at the end", x = x, y = y, z = z)));
            rows.push(row);
        }
    }
    TextTable { head: vec![head], rows }
}

fn coordinates(at: [f64; 3]) -> [String; 3] {
    at.map(|c| trimmed(&format!("{c:.1}").replace('-', "−")))
}

/// The widest crack that is left in a lining's sections with bars.
pub fn left(source: &Source, of: &SectionStrength) -> String {
    match &of.crack {
        Some(crack) if crack.station > 0 && of.is_overloaded() => say!(source.language, "not known"),
        Some(crack) if crack.station > 0 && crack.width.is_nan() => say!(source.language, "bars yield"),
        Some(crack) if crack.station > 0 && crack.width == 0.0 => say!(source.language, "none"),
        // Less than one can see or measure is no number of the clause's accuracy.
        Some(crack) if crack.station > 0 && crack.width < SEEN => {
            format!("<\u{a0}{}", trimmed(&source.quantity(Kind::Opening, SEEN)))
        }
        Some(crack) if crack.station > 0 => source.quantity(Kind::Opening, crack.width),
        _ => "–".to_owned(),
    }
}

/// Where and when a station used most.
pub fn place(source: &Source, used: &Used) -> String {
    let language = source.language;
    let [x, y, z] = coordinates(used.at);
    match used.time.is_finite() {
        true => {
            let time = moment(used.time, source.duration());
            say!(language, "({x}, {y}, {z}) at {time}\u{a0}s", x = x, y = y, z = z, time = time)
        }
        false => say!(language, "({x}, {y}, {z}) after {stage}", x = x, y = y, z = z, stage = used.stage),
    }
}

/// Where in its lining a station lies; of files of older versions a station.
pub fn part(language: Language, part: &str) -> String {
    match part {
        "crown" => say!(language, "crown"),
        "haunch" => say!(language, "haunch"),
        "wall" => say!(language, "wall"),
        "foot" => say!(language, "foot of the wall"),
        "floor" => say!(language, "floor"),
        _ => say!(language, "station"),
    }
}

/// N, M and V of a station that used most, with the resistance to shear beside them.
pub fn forces(language: Language, used: &Used) -> String {
    let [n, m, v] = used.forces.map(kilo);
    // None by the code, or in files of older versions, whose zero is none either.
    match used.resistance.is_finite()
        && (used.resistance > 0.0 || used.value.is_infinite() || used.value.is_nan())
    {
        true => say!(
            language,
            "N {thrust}, V {shear}, V_Rd {resistance} kN/m, M {moment} kN m/m",
            thrust = n,
            shear = v,
            resistance = kilo(used.resistance),
            moment = m
        ),
        false => {
            say!(language, "N {thrust}, V {shear} kN/m, M {moment} kN m/m", thrust = n, shear = v, moment = m)
        }
    }
}

/// At how many stations nothing is borne at some time, and the largest tension there; empty where something always is.
pub fn unborne(language: Language, of: &SectionStrength) -> String {
    match (of.unborne, of.unborne_thrust > 0.0) {
        (0, _) => String::new(),
        (stations, true) => say!(
            language,
            "∞ at {stations}, tension there up to {thrust} kN/m",
            stations = stations,
            thrust = kilo(of.unborne_thrust)
        ),
        (stations, false) => say!(language, "∞ at {stations}", stations = stations),
    }
}

/// By which rule a lining is judged, in a sentence or two.
pub fn rule(source: &Source, lining: &str, of: &SectionStrength) -> String {
    let language = source.language;
    let strength = |x: f64| source.quantity(Kind::Stress, x);
    let factor = |x: f64| trimmed(&figures(x, 3));
    let mut text = say!(
        language,
        "{lining}: {code}, concrete {grade}, f_cd {compression}, f_ctd {tension}; γ_c {gamma_c}, γ_s {gamma_s}, α_cc {alpha_cc}, \
         α_ct {alpha_ct}, γ_d {gamma_d}, strengths × {dynamic} while the ground shakes. {reinforced} of {stations} stations have bars.",
        lining = lining,
        code = of.code,
        grade = of.grade,
        compression = strength(of.compression),
        tension = strength(of.tension),
        gamma_c = factor(of.factors.gamma_c),
        gamma_s = factor(of.factors.gamma_s),
        alpha_cc = factor(of.factors.alpha_cc),
        alpha_ct = factor(of.factors.alpha_ct),
        gamma_d = factor(of.factors.gamma_d),
        dynamic = factor(of.factors.dynamic),
        reinforced = of.reinforced,
        stations = of.stations,
    );
    if of.reinforced < of.stations {
        text.push_str(&match of.plain_tension {
            true => say!(language, " Plain sections count their tensile strength."),
            false => say!(language, " Plain sections count no tensile strength."),
        });
    }
    if let Some(crack) = of.crack.as_ref().filter(|crack| crack.station > 0 && crack.width != 0.0) {
        text.push_str(&say!(
            language,
            " Crack width left: EN 1992-1-1 7.3.4 with N and M at the end, the section cracked, lasting load (k_t 0.4); σ_s {stress}, s_r,max {spacing}.",
            stress = strength(crack.stress),
            spacing = source.quantity(Kind::Opening, crack.spacing),
        ));
        if crack.without > 0 {
            text.push_str(&say!(
                language,
                " For {without} stations with bars the clause has no width: a face without bars opens.",
                without = crack.without
            ));
        }
    }
    if of.yields {
        text.push_str(&say!(
            language,
            " The lining's own law cracks or yields, and what has cracked carries no more than it can: this is a cross-check of the \
             computed forces, and the verdict is by cracks."
        ));
    }
    text
}

/// Along one section of a lining: what its stations used after the last stage, and most while the ground shook.
pub fn figure(
    language: Language,
    lining: &str,
    section: &[&Station],
    rows: &[UtilisationRow],
    suffix: &str,
) -> Option<Figure> {
    let of = |number: u32, when: &dyn Fn(&str) -> bool| {
        rows.iter().rev().find(|r| r.lining == lining && r.station == number && when(&r.when))
    };
    let mut along = vec![0.0];
    for pair in section.windows(2) {
        along.push(along[along.len() - 1] + distance(pair[0], pair[1]));
    }
    let end = along[along.len() - 1];
    let still = |when: &str| when != "max" && when != "max_shear";
    type Value = fn(&UtilisationRow) -> f64;
    type Of<'a> = &'a dyn Fn(&str) -> bool;
    let wanted: [(String, Of, Value, usize); 4] = [
        (say!(language, "thrust and moment, after the stages"), &still, |r| r.bending, 3),
        (say!(language, "thrust and moment, largest in the earthquake"), &|w| w == "max", |r| r.bending, 1),
        (say!(language, "shear, after the stages"), &still, |r| r.shear, 4),
        (say!(language, "shear, largest in the earthquake"), &|w| w == "max_shear", |r| r.shear, 0),
    ];
    let curve = |(name, when, value, colour): (String, Of, Value, usize)| {
        let points = section.iter().zip(&along);
        let points = points.filter_map(|(s, x)| Some((*x, value(of(s.number, when)?).min(MOST))));
        let points: Vec<(f64, f64)> = points.filter(|p| p.1.is_finite()).collect();
        let pen = match colour {
            3 => Pen::Marked,
            1 => Pen::Curve,
            4 => Pen::Dotted,
            _ => Pen::Dashed,
        };
        (points.len() > 1).then(|| PlotCurve::new(name, colour, pen, points))
    };
    let mut curves: Vec<PlotCurve> = wanted.into_iter().filter_map(curve).collect();
    if curves.is_empty() {
        return None;
    }
    curves.push(PlotCurve::new(
        say!(language, "design strength"),
        2,
        Pen::Dotted,
        vec![(0.0, 1.0), (end, 1.0)],
    ));
    let largest = plot::ranges(&curves).1.1;
    let most = largest.min(DRAWN);
    let cut = largest > DRAWN;
    for curve in &mut curves {
        curve.pieces.iter_mut().flatten().for_each(|p| p.1 = p.1.min(most));
    }
    let title = say!(language, "{lining}: utilisation of the sections", lining = lining);
    let below = say!(language, "along the lining (m), from the foot at greater x over the crown");
    // The axis says of its highest mark what is drawn there.
    let up = || {
        let mut up = Ticks::around(0.0, most, 6);
        let highest = up.marks.iter_mut().filter(|(at, _)| cut && (*at - most).abs() < 1e-9);
        highest.for_each(|(_, label)| *label = format!("≥\u{a0}{label}"));
        up
    };
    let drawn = |width: f64, heading: &str| {
        let mut svg = Svg::new(width);
        let top = plot::title(&mut svg, (LEFT, 0.0), width - LEFT - RIGHT, heading, &curves);
        let axes = Axes {
            left: LEFT,
            right: width - RIGHT,
            top,
            bottom: top + if width < WIDTH { 220.0 } else { 240.0 },
            across: Ticks::within(0.0, end, if width < WIDTH { 7 } else { 12 }),
            up: up(),
        };
        plot::draw(&mut svg, &axes, &curves);
        svg.text((width - RIGHT, axes.bottom + 34.0), Anchor::End, 12.0, Style::Muted, &below);
        svg.finish(axes.bottom + 42.0, &title, &below)
    };
    let (svg, narrow) = (drawn(WIDTH, &title), Some(drawn(NARROW, "")));
    let mut caption = say!(language, "Of the section drawn below.");
    if cut {
        let most = figures(most, 2);
        caption.push_str(&say!(
            language,
            " Values above {most}, infinite ones too, are drawn at {most}.",
            most = most
        ));
    }
    Some(Figure {
        heading: title,
        file: format!("utilisation{suffix}.svg"),
        svg,
        caption,
        curves: None,
        narrow,
    })
}
