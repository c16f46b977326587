//! Maps of interfaces, developed flat: where they slid and opened.

use tremolite_results::{ElementGroups, PairSurface, Pvd};

use crate::contact_history::names;
use crate::contact_panel::{BELOW, Layer, ROW, TITLE, direction, frame, panel};
use crate::figure::{Figure, Section};
use crate::plan::{LEFT, Plan};
use crate::scale::moment;
use crate::source::Source;
use crate::svg::Svg;
use crate::unfold::{Sheet, unfold};

const HEADING: &str = "Interfaces, developed flat";
/// The section of the page; nothing for a run without files of interfaces.
pub fn section(source: &Source) -> Option<Section> {
    let path = source.folder.interfaces_pvd();
    if !path.exists() {
        return None;
    }
    let left_out = |why: String| Some(Section::left_out(HEADING, why));
    let pvd = match Pvd::read(&path) {
        Ok(pvd) => pvd,
        Err(e) => return left_out(format!("{e}.")),
    };
    let Some(last) = pvd.snapshots().last() else {
        return left_out("interfaces.pvd lists no file yet.".into());
    };
    let surfaces = match PairSurface::read(&pvd.locate(last)) {
        Ok(surfaces) => surfaces,
        Err(e) => return left_out(format!("{e}.")),
    };
    let groups = groups(source);
    let names = names(source);
    let (mut figures, mut idle) = (Vec::new(), Vec::new());
    for surface in &surfaces {
        let number = surface.interface + 1;
        let name = names.get(surface.interface).cloned().unwrap_or_else(|| number.to_string());
        let layers = layers(surface);
        if layers.is_empty() {
            idle.push(name);
            continue;
        }
        let (svg, caption) = draw(surface, &layers, &name, &groups);
        let when = match source.shakes() {
            true => {
                format!("From the file of t = {}\u{a0}s.", moment(last.time, crate::facts::duration(source)))
            }
            false => "After the last stage.".to_owned(),
        };
        figures.push(Figure {
            heading: HEADING.into(),
            file: format!("interface-map-{number}.svg"),
            svg,
            caption: format!("{caption} {when}"),
            curves: None,
        });
    }
    if let (Some(last), false) = (figures.last_mut(), idle.is_empty()) {
        last.caption.push_str(&format!(" Not drawn, since nothing slid or opened: {}.", idle.join(", ")));
    }
    if figures.is_empty() {
        left_out("No interface slid or opened.".into())
    } else {
        Some(Section::Drawn(figures))
    }
}

/// The groups of elements, to name linings by; none where no field file has them.
fn groups(source: &Source) -> ElementGroups {
    let read = || {
        let path = if source.shakes() { source.folder.pvd() } else { source.folder.stages_pvd() };
        let pvd = Pvd::read(&path).ok()?;
        ElementGroups::read(&pvd.locate(pvd.snapshots().last()?)).ok()
    };
    read().unwrap_or_default()
}

fn layers(surface: &PairSurface) -> Vec<Layer<'_>> {
    let slip = Layer {
        title: "largest slip over the run",
        never: "never slid",
        now: "sliding at the end",
        values: &surface.slip_max,
        shown: &surface.slid,
        state: 2,
    };
    let gap = Layer {
        title: "largest gap over the run",
        never: "never opened",
        now: "open at the end",
        values: &surface.gap_max,
        shown: &surface.opened,
        state: 3,
    };
    [slip, gap].into_iter().filter(|layer| layer.shown.contains(&true)).collect()
}

/// The figure of one interface, and its caption.
fn draw(surface: &PairSurface, layers: &[Layer], name: &str, groups: &ElementGroups) -> (String, String) {
    let mut sheets = unfold(&surface.points, &surface.normals, &surface.faces);
    // From left to right as they stand in the ground.
    let middle = |sheet: &Sheet| {
        let [x, y, _] = sheet.axis;
        let points = sheet.faces.iter().flat_map(|face| &face.points).map(|p| surface.points[*p as usize]);
        let (sum, number) = points.fold((0.0, 0.0), |(s, n), p| (s + p[0] * y - p[1] * x, n + 1.0));
        sum / number
    };
    sheets.sort_by(|a, b| middle(a).total_cmp(&middle(b)));
    let plan = Plan::of(&sheets, layers.len());
    let labels = labels(&sheets, surface, groups);
    let mut svg = Svg::new(940.0);
    let above = TITLE + ROW + if plan.upright { ROW } else { 0.0 };
    let height = above + plan.size.1 + BELOW;
    let mut remarks = Vec::new();
    for (k, layer) in layers.iter().enumerate() {
        let (column, row) = if plan.beside { (k, 0) } else { (0, k) };
        let at = (LEFT + column as f64 * plan.panel_width(layers.len()), above + row as f64 * height);
        remarks.push(panel(&mut svg, at, above, &plan, &sheets, surface, layer));
        frame(&mut svg, at, &plan, &sheets, &labels);
    }
    let rows = if plan.beside { 1.0 } else { layers.len() as f64 };
    let title = format!("Interface {name}, developed flat");
    (svg.finish(rows * height, &title, &remarks.join("; ")), caption(&sheets, surface, layers, name))
}

/// A name for each sheet: the smallest group of elements that holds its first side, where that tells sheets apart.
fn labels(sheets: &[Sheet], surface: &PairSurface, groups: &ElementGroups) -> Vec<String> {
    let group = |sheet: &Sheet| {
        let elements: Vec<i64> = sheet.faces.iter().map(|face| surface.elements[face.face]).collect();
        groups.of_all(&elements).map(str::to_owned)
    };
    let names: Vec<Option<String>> = sheets.iter().map(group).collect();
    let label = |(k, name): (usize, &Option<String>)| match name {
        Some(name) if names.iter().filter(|other| *other == &Some(name.clone())).count() == 1 => name.clone(),
        Some(name) => format!("{name}, {}", k + 1),
        None if sheets.len() > 1 => format!("part {}", k + 1),
        None => String::new(),
    };
    names.iter().enumerate().map(label).collect()
}

fn caption(sheets: &[Sheet], surface: &PairSurface, layers: &[Layer], name: &str) -> String {
    let mut text =
        format!("Interface {name}: of each pair the largest value of all steps, on its share of the faces.");
    let done: Vec<&str> =
        layers.iter().map(|layer| if layer.state == 2 { "slid" } else { "opened" }).collect();
    text.push_str(&format!(" Grey: never {}.", done.join(", never ")));
    let now = |state: u8, what| {
        let hatched = layers.iter().any(|layer| layer.state == state) && surface.state.contains(&state);
        hatched.then_some(what)
    };
    let now: Vec<&str> = [now(2, "slides"), now(3, "is open")].into_iter().flatten().collect();
    if !now.is_empty() {
        text.push_str(&format!(" Hatched: what {} at the end.", now.join(", what ")));
    }
    if layers.len() < 2 {
        text.push_str(if layers[0].state == 2 { " It opened nowhere." } else { " It slid nowhere." });
    }
    text.push_str(if sheets.iter().any(|sheet| sheet.wraps) {
        " Unrolled at true lengths and opened at the bottom, seen from the rock."
    } else {
        " At true lengths, seen from the second side."
    });
    if let Some(sheet) = sheets.iter().find(|sheet| sheet.wraps && sheet.axis[2].abs() <= 0.5) {
        text.push_str(&format!(" Left and right are those of who looks along +{}.", direction(sheet.axis)));
    }
    if sheets.iter().any(|sheet| sheet.pieces > 1) {
        text.push_str(" Parts that would lie on others are moved apart.");
    }
    text
}
