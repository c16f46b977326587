//! The section when linings are strained most: displacement without the common motion, and the deformed shape.

use tremolite_results::{Peaks, Slice, Snapshot};

use crate::chapter::figure::{Figure, Section};
use crate::drawing::frame_row::MapRow;
use crate::language::say;
use crate::quantities::scale::{figures, moment, trimmed};
use crate::quantities::units::Kind;
use crate::section_maps::relative_motion::{Moved, Rigid, exaggeration};
use crate::section_maps::section_view::{
    Edge, Positions, area, border_sides, on_plane, plane, points, window,
};
use crate::section_maps::snapshots::Snapshots;
use crate::source::Source;
use crate::source::monitor_pairs::held;

/// Room around linings, as a part of their extent: ground that strains with them.
const MARGIN: f64 = 0.15;
/// How far the most moved point is drawn from its place, as a part of the window.
const DRAWN: f64 = 0.05;

/// The section of the page.
pub fn section(source: &Source, snapshots: &Snapshots) -> Section {
    let language = source.language;
    let heading = say!(language, "Deformed shape when the linings are strained most");
    let facts = source.facts();
    let strained = strained_most(source);
    let seen = widest_seen(source, snapshots);
    let nearest = || strained.as_ref().map(|(_, time, _)| snapshots.nearest(*time));
    let snapshot = seen.as_ref().map(|(snapshot, ..)| *snapshot).or_else(nearest).unwrap_or(snapshots.last());
    let fields = match snapshots.read(snapshot) {
        Ok(fields) => fields,
        Err(why) => return Section::left_out(&heading, why),
    };
    let slice = fields.slice(plane(&facts.monitors.monitor_positions));
    let Some(motion) = fields.vectors(&slice, "displacement") else {
        let why = say!(language, "The field files have no displacement with three components.");
        return Section::left_out(&heading, why);
    };
    let Some(cut) = fields.cut(&slice, &["displacement"]).filter(|cut| !cut.cells.is_empty()) else {
        return Section::left_out(&heading, say!(language, "The plane of the section meets no element."));
    };
    let time = snapshots.at(snapshot.time);
    let duration = source.duration();
    let length = |size: f64| source.quantity(Kind::Displacement, size);
    let why = match (&seen, &strained) {
        (Some((_, pair, size)), Some((most_pair, at, most))) => say!(
            language,
            "Drawn is the field file {when}, in which of all files monitors have moved most against each other, {pair} by {size} in the row of monitors.csv nearest to it. The most over the run is {most} of {most_pair} at {time}\u{a0}s.",
            when = time,
            pair = pair,
            size = length(*size),
            most = length(*most),
            most_pair = most_pair,
            time = moment(*at, duration)
        ),
        (_, Some((pair, at, most))) => say!(
            language,
            "The file {when} is the nearest to {time}\u{a0}s, when monitors moved most against each other: {pair} by {size}.",
            when = time,
            time = moment(*at, duration),
            pair = pair,
            size = length(*most)
        ),
        (_, None) => say!(
            language,
            "The file {when}, the last: the case compares no monitors ([[monitor_pair]]), so that nothing says when linings are strained most.",
            when = time
        ),
    };
    Section::Drawn(vec![figure(
        source,
        &heading,
        &slice,
        &cut,
        &motion,
        why,
        &facts.monitors.monitor_positions,
    )])
}

/// The pair of monitors that moved most against each other, when, and how far; of those that did not come loose.
fn strained_most(source: &Source) -> Option<(String, f64, f64)> {
    let facts = source.facts();
    let largest = |peaks: &indexmap::IndexMap<String, Peaks>| {
        let of = |name: &&str| peaks.get(*name).map(Peaks::largest);
        // The vector's length where the run wrote it, else the largest component.
        let whole = of(&"u");
        let parts = ["ux", "uy", "uz"].iter().filter_map(of).max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        whole.or(parts)
    };
    let all = held(source, &facts).0.into_iter().filter_map(|(pair, peaks)| {
        let (time, size) = largest(peaks)?;
        (time.is_finite() && size.is_finite()).then(|| (pair.to_owned(), time, size.abs()))
    });
    all.max_by(|a, b| a.2.total_cmp(&b.2))
}

/// The file in which a pair of monitors has moved most against each other, that pair, and how far; nothing where the
/// histories do not say.
fn widest_seen<'a>(source: &Source, snapshots: &'a Snapshots) -> Option<(&'a Snapshot, String, f64)> {
    let table = source.monitors.as_ref().ok()?;
    let times = table.column("time")?;
    let step = times.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    let facts = source.facts();
    let mut widest: Option<(&Snapshot, String, f64)> = None;
    for (pair, _) in held(source, &facts).0 {
        let parts = ["ux", "uy", "uz"].map(|name| table.column(&format!("{pair}.{name}")));
        let parts: Vec<&[f64]> = parts.into_iter().flatten().collect();
        for snapshot in snapshots.all().iter().filter(|_| !parts.is_empty()) {
            let far = |row: &usize| (times[*row] - snapshot.time).abs();
            let Some(row) = (0..times.len()).min_by(|a, b| far(a).total_cmp(&far(b))) else { continue };
            let size = parts.iter().map(|part| part[row] * part[row]).sum::<f64>().sqrt();
            if far(&row) <= step && size.is_finite() && widest.as_ref().is_none_or(|(.., most)| size > *most)
            {
                widest = Some((snapshot, pair.to_owned(), size));
            }
        }
    }
    widest
}

fn figure(
    source: &Source,
    heading: &str,
    slice: &Slice,
    cut: &tremolite_results::Cut,
    motion: &[Vec<[f64; 3]>],
    why: String,
    positions: &Positions,
) -> Figure {
    let language = source.language;
    let window = window(cut, positions, MARGIN, |_| false);
    let seen: Vec<usize> = (0..cut.cells.len()).filter(|&k| window.meets(&cut.cells[k].outline)).collect();
    let in_plane = |u: &[f64; 3]| [u[0], u[2]];
    let moved = |&k: &usize| Moved {
        area: area(&cut.cells[k].outline),
        corners: cut.cells[k].outline.iter().copied().zip(motion[k].iter().map(in_plane)).collect(),
    };
    let rigid = Rigid::of(&seen.iter().map(moved).collect::<Vec<_>>());
    let rest = |k: usize, corner: usize| {
        let corner = corner % slice.pieces[k].corners.len();
        rigid.rest(cut.cells[k].outline[corner], in_plane(&motion[k][corner]))
    };
    let size = |[x, z]: [f64; 2]| x.hypot(z);
    let sizes = |k: usize| (0..cut.cells[k].outline.len()).map(move |corner| size(rest(k, corner)));
    // Cells at the rim reach beyond the window, where nobody sees what they do.
    let shown = |k: usize| {
        let corners = cut.cells[k].outline.iter().zip(sizes(k));
        corners.filter(|(at, _)| window.meets(&[**at])).map(|(_, size)| size).collect::<Vec<_>>()
    };
    let most = seen.iter().flat_map(|&k| shown(k)).filter(|x| x.is_finite()).fold(0.0, f64::max);

    let borders = border_sides(&cut.cells);
    let [width, height] = window.size();
    let on_borders = borders.iter().flatten().filter(|side| seen.contains(&side.cell));
    let farthest = on_borders
        .flat_map(|side| [side.corner, side.corner + 1].map(|corner| size(rest(side.cell, corner))))
        .filter(|x| x.is_finite())
        .fold(0.0, f64::max);
    let factor = exaggeration(farthest, DRAWN * width.max(height));

    let scale = source.scale(Kind::Displacement);
    let row = MapRow::of(window, 1);
    let mut frame = row.frame(0.0, most * scale.factor);
    for &k in &seen {
        let values: Vec<f64> = sizes(k).map(|value| value * scale.factor).collect();
        frame.contours(&cut.cells[k].outline, &values);
    }
    let undeformed: Vec<Edge> = borders.iter().map(|sides| sides[0].edge).collect();
    frame.outlines(&undeformed);
    // Each side of a border by its own nodes: where an interface opened, two lines part.
    let drawn = |side: &crate::section_maps::section_view::CellSide| {
        [0, 1].map(|end| {
            let u = rest(side.cell, side.corner + end);
            [0, 1].map(|i| side.edge[end][i] + factor * u[i])
        })
    };
    let deformed: Vec<Edge> = borders
        .iter()
        .flatten()
        .map(drawn)
        .filter(|edge| edge.iter().flatten().all(|c| c.is_finite()))
        .collect();
    frame.shapes(&deformed);
    points(&mut frame, cut, positions);
    let title = say!(language, "displacement less the common motion");
    let name =
        say!(language, "shape of linings and openings × {factor}", factor = trimmed(&figures(factor, 3)));
    let svg = row.draw(
        &scale.labelled(&title),
        &[(name, frame)],
        &say!(language, "a section with filled contours and the deformed shape"),
    );
    let said = [
        why,
        say!(
            language,
            "Colours: length of the displacement in the plane, {plane}, less the mean motion ({shift}) and the mean turn of all that is \
             drawn, which strain nothing; up to {most}. Motion along y is not in it. Interpolated between nodes.",
            plane = on_plane(language, cut.y),
            shift = scale.quantity(rigid.shift()),
            most = scale.quantity(most)
        ),
        say!(
            language,
            "Thick lines: linings and openings with that displacement {factor} times enlarged, over their shape at rest in thin lines. Look \
             for walls that come together or bow inwards and for a crown that is pushed to one side: there the lining is bent. Where the outer line of a lining is double, it has come off the rock.",
            factor = trimmed(&figures(factor, 3))
        ),
    ];
    Figure {
        heading: heading.into(),
        file: "section-deformed.svg".into(),
        svg,
        caption: language.joined(&said),
        curves: None,
        narrow: None,
    }
}
