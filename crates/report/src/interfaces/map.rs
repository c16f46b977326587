//! Maps of interfaces, developed flat: where they slid and opened.

use tremolite_results::{ElementGroups, PairSurface, Pvd};

use crate::chapter::figure::{Figure, Section};
use crate::developed::layout::{Bars, LEFT, Layout};
use crate::developed::unfold::{Sheet, unfold};
use crate::developed::words::{developed, from_left, labels};
use crate::drawing::svg::Svg;
use crate::interfaces::history::names;
use crate::interfaces::map_panel::{BELOW, Layer, ROW, TITLE, frame, panel};
use crate::language::{Language, say};
use crate::quantities::scale::moment;
use crate::quantities::units::Kind;
use crate::source::Source;

/// The section of the page; nothing for a run without files of interfaces.
pub fn section(source: &Source) -> Option<Section> {
    let path = source.folder.interfaces_pvd();
    if !path.exists() {
        return None;
    }
    let language = source.language;
    let heading = say!(language, "Interfaces, developed flat");
    let left_out = |why: String| Some(Section::left_out(&heading, why));
    let pvd = match Pvd::read(&path) {
        Ok(pvd) => pvd,
        Err(e) => return left_out(format!("{e}.")),
    };
    let Some(last) = pvd.snapshots().last() else {
        return left_out(say!(language, "interfaces.pvd lists no file yet."));
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
        let layers = layers(language, surface);
        if layers.is_empty() {
            idle.push(name);
            continue;
        }
        let (svg, mut said) = draw(source, surface, &layers, &name, &groups);
        said.push(match source.shakes() {
            true => {
                let time = moment(last.time, source.duration());
                say!(language, "From the file of t = {time}\u{a0}s.", time = time)
            }
            false => say!(language, "After the last stage."),
        });
        figures.push((format!("interface-map-{number}.svg"), svg, said));
    }
    if let (Some((.., said)), false) = (figures.last_mut(), idle.is_empty()) {
        said.push(say!(
            language,
            "Not drawn, since nothing slid or opened: {names}.",
            names = idle.join(", ")
        ));
    }
    if figures.is_empty() {
        return left_out(say!(language, "No interface slid or opened."));
    }
    let figure = |(file, svg, said): (String, String, Vec<String>)| Figure {
        heading: heading.clone(),
        file,
        svg,
        caption: language.joined(&said),
        curves: None,
        narrow: None,
    };
    Some(Section::Drawn(figures.into_iter().map(figure).collect()))
}

/// The groups of elements, to name linings by; none where no field file has them.
fn groups(source: &Source) -> ElementGroups {
    let read = || {
        let path = if source.shakes() { source.folder.pvd() } else { source.folder.stages_pvd() };
        let pvd = Pvd::read(&path).ok()?;
        Some(source.fields.at(&pvd, pvd.snapshots().last()?).ok()?.groups())
    };
    read().unwrap_or_default()
}

fn layers(language: Language, surface: &PairSurface) -> Vec<Layer<'_>> {
    let slip = Layer {
        title: say!(language, "largest slip over the run"),
        never: say!(language, "never slid"),
        now: say!(language, "sliding at the end"),
        values: &surface.slip_max,
        shown: &surface.slid,
        state: 2,
    };
    let gap = Layer {
        title: say!(language, "largest gap over the run"),
        never: say!(language, "never opened"),
        now: say!(language, "open at the end"),
        values: &surface.gap_max,
        shown: &surface.opened,
        state: 3,
    };
    [slip, gap].into_iter().filter(|layer| layer.shown.contains(&true)).collect()
}

/// The figure of one interface, and what is said of it.
fn draw(
    source: &Source,
    surface: &PairSurface,
    layers: &[Layer],
    name: &str,
    groups: &ElementGroups,
) -> (String, Vec<String>) {
    let language = source.language;
    let mut sheets = unfold(&surface.points, &surface.normals, &surface.faces);
    from_left(&mut sheets, &surface.points);
    let layout = Layout::of(&sheets, layers.len(), Bars::Each);
    let labels = labels(language, &sheets, &surface.elements, groups);
    let mut svg = Svg::new(940.0);
    let above = TITLE + ROW + if layout.upright { ROW } else { 0.0 };
    let height = above + layout.size.1 + BELOW;
    let scale = source.scale(Kind::Opening);
    let mut remarks = Vec::new();
    for (k, layer) in layers.iter().enumerate() {
        let (column, row) = if layout.beside { (k, 0) } else { (0, k) };
        let at = (LEFT + column as f64 * layout.panel_width(layers.len()), above + row as f64 * height);
        remarks.push(panel(&mut svg, at, above, &layout, &sheets, surface, layer, (language, &scale)));
        frame(&mut svg, language, at, &layout, &sheets, &labels);
    }
    let rows = if layout.beside { 1.0 } else { layers.len() as f64 };
    let title = say!(language, "Interface {name}, developed flat", name = name);
    let svg = svg.finish(rows * height, &title, &remarks.join(&say!(language, "; ")));
    (svg, said(language, &sheets, surface, layers, name))
}

fn said(
    language: Language,
    sheets: &[Sheet],
    surface: &PairSurface,
    layers: &[Layer],
    name: &str,
) -> Vec<String> {
    let mut said = vec![say!(
        language,
        "Interface {name}: of each pair the largest value of all steps, on its share of the faces; the median is of the pairs in colour.",
        name = name
    )];
    let has = |state: u8| layers.iter().any(|layer| layer.state == state);
    said.push(match (has(2), has(3)) {
        (true, true) => say!(language, "Grey: never slid, never opened."),
        (true, false) => say!(language, "Grey: never slid. It opened nowhere."),
        (false, _) => say!(language, "Grey: never opened. It slid nowhere."),
    });
    let now = |state: u8| has(state) && surface.state.contains(&state);
    match (now(2), now(3)) {
        (true, true) => {
            said.push(say!(language, "Hatched: what slides at the end, what is open at the end."))
        }
        (true, false) => said.push(say!(language, "Hatched: what slides at the end.")),
        (false, true) => said.push(say!(language, "Hatched: what is open at the end.")),
        (false, false) => {}
    }
    said.push(say!(
        language,
        "Look for patches that run along the axis or join across crown and wall: there the lining has come off the ground. Where such \
         a patch is open at the end, nothing presses on the lining any more; set it beside the damage of the lining at that place."
    ));
    said.extend(developed(language, sheets));
    said
}
