//! Figures of monitors on interfaces: gap and slip, pressure and shear, and the path of one over the other.

use tremolite_results::Table;

use crate::contact_path::Path;
use crate::figure::{Figure, Section};
use crate::loops::{Course, Loops, Quantity, Track};
use crate::source::Source;
use crate::strips::Strip;

const HEADING: &str = "Monitors on interfaces";
/// The columns of such a monitor.
pub const QUANTITIES: [&str; 7] = ["gap", "slip1", "slip2", "pressure", "shear1", "shear2", "state"];
/// Numbers of states, their names and colours.
const STATES: [(f64, &str, usize); 4] =
    [(0.0, "bonded", 2), (1.0, "stuck, bond broken", 3), (2.0, "sliding", 1), (3.0, "open", 0)];

/// Whether a monitor lies on an interface.
pub fn is_on_interface(table: &Table, monitor: &str) -> bool {
    ["gap", "pressure", "shear1"].iter().all(|q| table.column(&format!("{monitor}.{q}")).is_some())
}

/// The section of the page; nothing where no monitor lies on an interface.
pub fn section(source: &Source) -> Option<Section> {
    let table = source.monitors.as_ref().ok()?;
    let monitors = crate::pairs::names(table).into_iter().filter(|name| is_on_interface(table, name));
    let both = |(k, name): (usize, String)| {
        let file = |what: &str| format!("interface-{what}-{}.svg", k + 1);
        [figure(table, &name, file("monitor")), path(table, &name, file("path"))]
    };
    let figures: Vec<Figure> = monitors.enumerate().flat_map(both).collect();
    (!figures.is_empty()).then_some(Section::Drawn(figures))
}

fn figure(table: &Table, monitor: &str, file: String) -> Figure {
    let column = |quantity: &str| table.column(&format!("{monitor}.{quantity}")).unwrap_or(&[]);
    let track = |name: &str, unit: &str, wanted: &[(&'static str, &str, usize)]| {
        let course = |&(quantity, name, colour): &(&'static str, &str, usize)| {
            let values = column(quantity);
            (!values.is_empty()).then(|| Course { name: name.into(), colour, values })
        };
        let courses: Vec<Course> = wanted.iter().filter_map(course).collect();
        (!courses.is_empty()).then(|| Track { quantity: Quantity::new(name, unit), courses })
    };
    let tracks = [
        track("gap", "m", &[("gap", "gap", 0)]),
        track("slip", "m", &[("slip1", "along e1", 1), ("slip2", "along e2", 5)]),
        track("pressure, compression positive", "Pa", &[("pressure", "pressure", 0)]),
        track("shear", "Pa", &[("shear1", "along e1", 1), ("shear2", "along e2", 5)]),
    ];
    let state = column("state");
    let strips = STATES.iter().map(|&(number, name, colour)| Strip {
        name: name.into(),
        colour,
        on: state.iter().map(|s| *s == number).collect(),
    });
    let strips: Vec<Strip> = strips.filter(|strip| strip.on.contains(&true)).collect();
    let title = format!("{monitor}: the pair of the interface nearest to it");
    let loops = Loops {
        title,
        along: Quantity::new("time", "s"),
        time: table.column("time").unwrap_or(&[]),
        planes: Vec::new(),
        tracks: tracks.into_iter().flatten().collect(),
        states: (!strips.is_empty()).then(|| ("state".into(), strips)),
    };
    let caption = format!(
        "Monitor {monitor}, rows of monitors.csv. The gap is positive where it is open and negative where pressure closes the \
         joint. Slip of the second side against the first, and shear along the slip that causes it: along e1, horizontal, \
         and e2, up the dip (x and y on a level interface)."
    );
    Figure { heading: HEADING.into(), file, svg: loops.draw(), caption, curves: None }
}

/// Shear over pressure, each row in the colour of its state.
fn path(table: &Table, monitor: &str, file: String) -> Figure {
    let column = |quantity: &str| table.column(&format!("{monitor}.{quantity}")).unwrap_or(&[]);
    let (along, across) = (column("shear1"), column("shear2"));
    let of_row = |row: usize| along[row].hypot(across.get(row).copied().unwrap_or(0.0));
    let shear: Vec<f64> = (0..along.len()).map(of_row).collect();
    let state = column("state");
    let drawing = Path {
        title: format!("{monitor}: shear over pressure"),
        pressure: column("pressure"),
        shear: &shear,
        state: &|row| STATES.iter().position(|s| state.get(row) == Some(&s.0)),
        states: &STATES.map(|(_, name, colour)| (name, colour)),
    };
    let caption = format!(
        "Monitor {monitor}: size of the shear over the pressure, a dot a row of monitors.csv. Pairs that slide lie on a \
         line through the origin whose slope is the friction μ; above it only the bond holds."
    );
    Figure { heading: HEADING.into(), file, svg: drawing.draw(), caption, curves: None }
}
