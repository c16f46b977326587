//! `[motion]`: the earthquake and what is made of it before it enters the model.

mod component;
mod site;
mod soil;
mod target;
mod wave;

use std::ops::Range;
use std::path::PathBuf;

use tremolite_laws::parameter::Dimension;

pub(crate) use component::COMPONENT;
pub use component::{Component, Direction, Record, RecordUnit, TextColumn};
pub(crate) use site::unit_weights;
pub use site::{Corner, Site, SiteLayer};
pub use soil::Softening;
pub use target::{Target, TargetSpectrum};
pub use wave::{SurfacePart, Wave, WaveComponent, WaveWord};

use crate::fields::{Fields, Item, Node};
use crate::keys::{Key, Kind, Limit, Table, When, words};
use crate::{Diagnostic, Spanned};

const TIME: Kind = Kind::Number(Dimension::TIME, Limit::NotNegative);
const DURATION: Kind = Kind::Number(Dimension::TIME, Limit::Positive);
const PLACE: Kind = Kind::Number(Dimension::LENGTH, Limit::Any);

pub(crate) static MOTION: Table = Table {
    path: "motion",
    doc: "The earthquake and what is made of it before it enters the model.",
    keys: &[
        Key::required(
            "kind",
            Kind::Word(MotionKind::WORDS),
            "what the record is: of a rock outcrop (halved), the incident wave itself, measured at a depth within the ground, or \
             on the surface of layered ground",
        ),
        Key::required(
            "depth",
            Kind::Number(Dimension::LENGTH, Limit::NotNegative),
            "depth below the surface of the ground",
        )
        .when(When::Is("kind", "within")),
        Key::optional(
            "site",
            Kind::Table(&site::SITE),
            "",
            "The ground on or in which it was recorded; without it, the model's own at its corners",
        ),
        Key::optional("file", Kind::File, "", "File with all components, taken by their orientation"),
        Key::optional("sensitivity", Kind::Text, "", SENSITIVITY).when(When::Beside("file")),
        Key::optional("encoding", Kind::Text, "", ENCODING).when(When::Beside("file")),
        Key::optional("east", Kind::Table(&component::COMPONENT), "", "Component towards east"),
        Key::optional("north", Kind::Table(&component::COMPONENT), "", "Component towards north"),
        Key::optional("up", Kind::Table(&component::COMPONENT), "", "Component upwards"),
        Key::optional(
            "target",
            target::TARGETS,
            "",
            "Spectrum that the design calls for, drawn beside the record's, and matched by a step \"match\": \"EN 1998-1 type 1 ground B 2 m/s2\" \
             (type 1 or 2, ground A to E, a_g), a file, or points",
        ),
        Key::optional("window", WINDOW_KIND, "the whole record", "The part of the record that is used"),
        Key::optional(
            "processing",
            Kind::List(&Kind::Text, 0, 100),
            "no processing",
            "Steps of processing, in this order: \"detrend linear\", \"baseline\", \"baseline polynomial N\", \"pre-event S s\", \
             \"taper S s\", \"highpass F Hz\", \"lowpass F Hz\", \"bandpass F Hz F Hz\", \"scale X\", \"pga X g\" (the largest \
             component; the others by the same factor), \"match\" or \"match T s T s\" (to `target`, from one period to the other)",
        ),
        Key::optional(
            "x_azimuth",
            Kind::Number(Dimension::ANGLE, Limit::Any),
            "",
            "Direction of the model's x axis for this record alone, clockwise from north; left out: `model_x_azimuth`",
        ),
        Key::optional(
            "wave",
            Kind::Tables(&wave::WAVE),
            "",
            "Plane waves at angles, each with a component of the motion",
        ),
        Key::optional(
            "at",
            Kind::List(&PLACE, 2, 2),
            "the centre of the base",
            "Where in plan, in the model's x and y, waves at angles come at the time of the record",
        )
        .when(When::Beside("wave")),
    ],
    choice: &[&["file"], &["east", "north", "up"]],
};

/// What the keys of that name say.
const SENSITIVITY: &str = "What a count is, where the file holds counts: \"427336 counts/(m/s2)\", of the network's station metadata; or their \
                           StationXML file (`.xml`), for miniSEED and SAC, which has the directions too";
/// What the keys of that name say.
const ENCODING: &str = "Encoding of the file's text, where it is neither UTF-8 nor GB18030: \"big5\", \"shift_jis\", \"windows-1252\" …";

pub(crate) const WINDOW_KIND: Kind = Kind::Either(&[Kind::List(&TIME, 2, 2), Kind::Table(&WINDOW)]);

static WINDOW: Table = Table {
    path: "motion.window",
    doc: "The part of the record that is used.",
    keys: &[Key::required("strongest", DURATION, "the stretch of this length that shakes most")],
    choice: &[],
};

words! {
    /// What a record is, which decides how much of it enters at the base.
    MotionKind {
        /// Of a rock surface: twice the incident wave.
        Outcrop = "outcrop",
        /// The incident wave itself.
        Incident = "incident",
        /// Measured at a depth within the ground, waves that go up and down together: deconvolved.
        Within = "within",
        /// Measured on the surface of layered ground: deconvolved.
        Surface = "surface",
    }
}

/// The earthquake and what is made of it before it enters the model.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// What the record is.
    pub kind: Spanned<MotionKind>,
    /// Below the surface of the ground, m; of `within` alone.
    pub depth: Option<Spanned<f64>>,
    /// The ground on or in which it was recorded; nothing: the model's own. Of `within` and `surface` alone.
    pub site: Option<Site>,
    /// Where the components come from.
    pub records: Records,
    /// What a count of the one file is, as written; read by the motion crate. Files of components have their own.
    pub sensitivity: Option<Spanned<String>>,
    /// Encoding of the one file's text, as written.
    pub encoding: Option<Spanned<String>>,
    /// The spectrum that the design calls for.
    pub target: Option<Target>,
    /// The part that is used; nothing: all.
    pub window: Option<Spanned<Window>>,
    /// Steps of processing as they are written, in this order; read by the motion crate.
    pub processing: Vec<Spanned<String>>,
    /// Direction of the model's x axis for the record, clockwise from north, rad: that of the case, unless the record has its own.
    pub model_x_azimuth: Spanned<f64>,
    /// Plane waves at angles; none: one rises straight up.
    pub waves: Vec<Wave>,
    /// Where in plan waves at angles have the record's time, m; nothing: at the centre of the base.
    pub at: Option<Spanned<[f64; 2]>>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

/// Where the components come from.
#[derive(Clone, Debug, PartialEq)]
pub enum Records {
    /// One file with all components, taken by their orientation. As written; relative to the case's directory.
    File(Spanned<PathBuf>),
    /// East, north, up; a component that is missing is zero. At least one is a record.
    Components(Box<[Option<Component>; 3]>),
}

/// The part of a record that is used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Window {
    /// From and to, s from the start of the record.
    Between(f64, f64),
    /// The stretch of this length, s, that shakes most.
    Strongest(f64),
}

impl Motion {
    /// Unit weights become densities by gravity, m/s². `model_x_azimuth` is that of the case.
    pub(crate) fn read(f: &Fields, gravity: f64, model_x_azimuth: Spanned<f64>) -> Option<Self> {
        let kind = f.word("kind", MotionKind::from_word);
        let records = Records::read(f);
        let window = f.get("window").and_then(|node| {
            let window = match &node.item {
                Item::Table(table) => Window::Strongest(table.number("strongest")?.value),
                _ => {
                    let [from, to] = node.numbers()?.value;
                    Window::Between(from, to)
                }
            };
            Some(Spanned::new(window, node.span.clone()))
        });
        Some(Motion {
            window,
            target: Target::read(f),
            sensitivity: f.text("sensitivity"),
            encoding: f.text("encoding"),
            processing: f.texts("processing"),
            model_x_azimuth: f.number("x_azimuth").unwrap_or(model_x_azimuth),
            waves: f.tables("wave").filter_map(Wave::read).collect(),
            at: f.get("at").and_then(Node::numbers),
            span: f.span.clone(),
            depth: f.number("depth"),
            site: Site::read(f, gravity),
            kind: kind?,
            records: records?,
        })
    }

    /// Files of the records, as they are written.
    pub fn files(&self) -> Vec<&Spanned<PathBuf>> {
        match &self.records {
            Records::File(file) => vec![file],
            Records::Components(components) => {
                components.iter().flatten().filter_map(Component::record).map(|r| &r.file).collect()
            }
        }
    }

    /// What lies between keys; looks at each value that is good, whatever the others are.
    pub(crate) fn check(f: &Fields, problems: &mut Vec<Diagnostic>) {
        site::check(f, problems);
        wave::check(f, problems);
        f.table("target").into_iter().for_each(|target| TargetSpectrum::check(target, problems));
        if let Some(window) = f.get("window").and_then(Node::numbers::<2>)
            && window.value[1] <= window.value[0]
        {
            problems.push(Diagnostic::at(
                &window,
                "the window ends before it begins",
                "write [from, to] with the earlier time first",
            ));
        }
        for component in Direction::WORDS.iter().filter_map(|name| f.table(name)) {
            component::check(component, f, problems);
        }
    }
}

impl Records {
    fn read(f: &Fields) -> Option<Self> {
        let file = f.text("file");
        // A component that was refused has been reported; the others are read all the same.
        let mut refused = false;
        let components = [Direction::East, Direction::North, Direction::Up].map(|direction| {
            let component = f.table(direction.word()).map(Component::read);
            refused |= matches!(component, Some(None));
            component.flatten()
        });
        match file {
            Some(file) => Some(Records::File(Spanned::new(file.value.into(), file.span))),
            None if refused => None,
            None => Some(Records::Components(Box::new(components))),
        }
    }
}
