//! Figures of monitors on interfaces: gap and slip, pressure and shear, and the path of one over the other.

use tremolite_results::{Subject, Table};

use crate::chapter::figure::{Figure, Section};
use crate::drawing::loops::{Course, Loops, Quantity, Track};
use crate::drawing::state_strips::Strip;
use crate::interfaces::shear_path::Path;
use crate::language::{Language, say};
use crate::quantities::units::Kind;
use crate::source::Source;
use crate::source::monitor_pairs::names;

/// The columns of such a monitor.
pub const QUANTITIES: [&str; 7] = ["gap", "slip1", "slip2", "pressure", "shear1", "shear2", "state"];
/// Numbers of states and their colours.
const STATES: [(f64, usize); 4] = [(0.0, 2), (1.0, 3), (2.0, 1), (3.0, 0)];

/// What the states are called.
fn states(language: Language) -> [String; 4] {
    [
        say!(language, "bonded"),
        say!(language, "stuck, bond broken"),
        say!(language, "sliding"),
        say!(language, "open"),
    ]
}

/// The section of the page; nothing where no monitor lies on an interface.
pub fn section(source: &Source) -> Option<Section> {
    let table = source.monitors.as_ref().ok()?;
    let monitors = names(table, |subject| matches!(subject, Subject::Pair(_)));
    let both = |(k, name): (usize, String)| {
        let file = |what: &str| format!("interface-{what}-{}.svg", k + 1);
        [figure(source, table, &name, file("monitor")), path(source, table, &name, file("path"))]
    };
    let figures: Vec<Figure> = monitors.into_iter().enumerate().flat_map(both).collect();
    (!figures.is_empty()).then_some(Section::Drawn(figures))
}

fn figure(source: &Source, table: &Table, monitor: &str, file: String) -> Figure {
    let language = source.language;
    let column = |quantity: &str| table.column(&format!("{monitor}.{quantity}")).unwrap_or(&[]);
    let track = |name: String, unit: &str, kind: Kind, wanted: Vec<(&'static str, String, usize)>| {
        let course = |(quantity, name, colour): (&'static str, String, usize)| {
            let values = column(quantity);
            (!values.is_empty()).then_some(Course { name, colour, values })
        };
        let courses: Vec<Course> = wanted.into_iter().filter_map(course).collect();
        (!courses.is_empty())
            .then(|| Track { quantity: Quantity::new(name, unit).shown_in(source.scale(kind)), courses })
    };
    let both =
        |first, second| vec![(first, say!(language, "along e1"), 1), (second, say!(language, "along e2"), 5)];
    let gap = || say!(language, "gap");
    let pressure = vec![("pressure", say!(language, "pressure"), 0)];
    let tracks = [
        track(gap(), "m", Kind::Opening, vec![("gap", gap(), 0)]),
        track(say!(language, "slip"), "m", Kind::Opening, both("slip1", "slip2")),
        track(say!(language, "pressure, compression positive"), "Pa", Kind::Stress, pressure),
        track(say!(language, "shear"), "Pa", Kind::Stress, both("shear1", "shear2")),
    ];
    let state = column("state");
    let strips = STATES.into_iter().zip(states(language)).map(|((number, colour), name)| Strip {
        name,
        colour,
        on: state.iter().map(|s| *s == number).collect(),
    });
    let strips: Vec<Strip> = strips.filter(|strip| strip.on.contains(&true)).collect();
    let title = say!(language, "{monitor}: the pair of the interface nearest to it", monitor = monitor);
    let loops = Loops {
        title,
        along: Quantity::new(say!(language, "time"), "s"),
        time: table.column("time").unwrap_or(&[]),
        planes: Vec::new(),
        tracks: tracks.into_iter().flatten().collect(),
        states: (!strips.is_empty()).then(|| (say!(language, "state"), strips)),
    };
    let caption = say!(
        language,
        "Monitor {monitor}, rows of monitors.csv. The gap is positive where it is open and negative where pressure closes the \
         joint. Slip of the second side against the first, and shear along the slip that causes it: along e1, horizontal, \
         and e2, up the dip (x and y on a level interface). Look for slip that stays and gaps that do not close when the \
         shaking ends.",
        monitor = monitor
    );
    Figure {
        heading: say!(language, "Monitors on interfaces"),
        file,
        svg: loops.draw(),
        caption,
        curves: None,
        narrow: None,
    }
}

/// Shear over pressure, each row in the colour of its state.
fn path(source: &Source, table: &Table, monitor: &str, file: String) -> Figure {
    let language = source.language;
    let column = |quantity: &str| table.column(&format!("{monitor}.{quantity}")).unwrap_or(&[]);
    let (along, across) = (column("shear1"), column("shear2"));
    let of_row = |row: usize| along[row].hypot(across.get(row).copied().unwrap_or(0.0));
    let shear: Vec<f64> = (0..along.len()).map(of_row).collect();
    let state = column("state");
    let states = states(language).into_iter().zip(STATES);
    let states: Vec<(String, usize)> = states.map(|(name, (_, colour))| (name, colour)).collect();
    let drawing = Path {
        language,
        title: say!(language, "{monitor}: shear over pressure", monitor = monitor),
        pressure: column("pressure"),
        shear: &shear,
        scale: source.scale(Kind::Stress),
        state: &|row| STATES.iter().position(|s| state.get(row) == Some(&s.0)),
        states: &states,
    };
    let caption = say!(
        language,
        "Monitor {monitor}: size of the shear over the pressure, a dot a row of monitors.csv. Pairs that slide lie on a \
         line through the origin whose slope is the friction μ; above it only the bond holds.",
        monitor = monitor
    );
    Figure {
        heading: say!(language, "Monitors on interfaces"),
        file,
        svg: drawing.draw(),
        caption,
        curves: None,
        narrow: None,
    }
}
