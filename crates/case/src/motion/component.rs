//! One component of the ground motion.

use std::path::PathBuf;

use tremolite_laws::parameter::Dimension;

use super::DURATION;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table, When, words};
use crate::{Diagnostic, Spanned};

/// The word in place of a unit for what a digitiser counts.
const COUNTS: &str = "counts";

pub(crate) static COMPONENT: Table = Table {
    path: "motion.east",
    doc: "One component of the ground motion: a record, or another component times a factor.",
    keys: &[
        Key::optional("file", Kind::File, "", "The record, relative to the case"),
        Key::optional("channel", Kind::Text, "", "Which of the file's channels, by its label or its name: \"N28W\"")
            .when(When::Beside("file")),
        Key::optional(
            "units",
            Kind::Either(&[Kind::Word(&[COUNTS]), Kind::Unit(Dimension::ACCELERATION)]),
            "",
            "Unit of the figures, where the file does not say: \"cm/s2\", \"g\", or \"counts\" beside `sensitivity`",
        )
        .when(When::Beside("file")),
        Key::optional(
            "columns",
            Kind::List(&Kind::Word(TextColumn::WORDS), 1, 100),
            "",
            "What the columns of a plain text file hold, from the left; `rows` alone for one series in rows of numbers",
        )
        .when(When::Beside("file")),
        Key::optional("dt", DURATION, "", "Time between figures, where the file does not say")
            .when(When::Beside("file")),
        Key::optional("sensitivity", Kind::Text, "", super::SENSITIVITY).when(When::Beside("file")),
        Key::optional("encoding", Kind::Text, "", super::ENCODING).when(When::Beside("file")),
        Key::optional("from", Kind::Word(Direction::WORDS), "", "The component this one is made of"),
        Key::required("factor", Kind::Number(Dimension::NONE, Limit::Any), "this component over the other")
            .when(When::Beside("from")),
    ],
    choice: &[&["file"], &["from"]],
};

words! {
    /// Direction of a component.
    Direction {
        /// First of [`Records::Components`](super::Records::Components).
        East = "east",
        /// Second.
        North = "north",
        /// Third.
        Up = "up",
    }
}

words! {
    /// What a column of a plain text record holds.
    TextColumn {
        /// Time, s.
        Time = "time",
        /// Acceleration, in `units`.
        Acceleration = "acceleration",
        /// Something else.
        Skip = "skip",
        /// The only word: all numbers are one acceleration, row by row.
        Rows = "rows",
    }
}

/// One component of the ground motion.
#[derive(Clone, Debug, PartialEq)]
pub enum Component {
    /// Measured.
    Record(Record),
    /// Another component, which is a record, times a factor.
    Scaled {
        /// The other component.
        from: Spanned<Direction>,
        /// This component over the other.
        factor: Spanned<f64>,
    },
}

/// The unit of a record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RecordUnit {
    /// An acceleration of this SI value, m/s².
    Acceleration(f64),
    /// What a digitiser counts.
    Counts,
}

/// A record of one component.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// As written; relative to the case's directory.
    pub file: Spanned<PathBuf>,
    /// Which of the file's channels.
    pub channel: Option<Spanned<String>>,
    /// The file's unit.
    pub units: Option<Spanned<RecordUnit>>,
    /// What the columns of a plain text file hold; empty: not said.
    pub columns: Vec<Spanned<TextColumn>>,
    /// Time between figures, s.
    pub dt: Option<Spanned<f64>>,
    /// What a count of the file is, as written; read by the motion crate.
    pub sensitivity: Option<Spanned<String>>,
    /// Encoding of the file's text, as written.
    pub encoding: Option<Spanned<String>>,
}

impl Component {
    /// The record, if it is one of its own.
    pub fn record(&self) -> Option<&Record> {
        match self {
            Component::Record(record) => Some(record),
            Component::Scaled { .. } => None,
        }
    }

    pub(super) fn read(f: &Fields) -> Option<Self> {
        let (file, channel, dt) = (f.text("file"), f.text("channel"), f.number("dt"));
        let units = f.get("units").and_then(|node| {
            let unit = match node.number() {
                Some(unit) => RecordUnit::Acceleration(unit.value),
                // The only word that is let through.
                None => node.text().map(|_| RecordUnit::Counts)?,
            };
            Some(Spanned::new(unit, node.span.clone()))
        });
        let (sensitivity, encoding) = (f.text("sensitivity"), f.text("encoding"));
        let columns = f.list("columns").iter().filter_map(|n| {
            let word = n.text()?;
            Some(Spanned::new(TextColumn::from_word(&word)?, word.span))
        });
        let columns = columns.collect();
        let (from, factor) = (f.word("from", Direction::from_word), f.number("factor"));
        match file {
            Some(file) => {
                let file = Spanned::new(file.value.into(), file.span);
                Some(Component::Record(Record { file, channel, units, columns, dt, sensitivity, encoding }))
            }
            None => Some(Component::Scaled { from: from?, factor: factor? }),
        }
    }
}

/// What lies between the keys of one component, and between it and the others of the motion.
pub(super) fn check(component: &Fields, motion: &Fields, problems: &mut Vec<Diagnostic>) {
    if let Some(from) = component.word("from", Direction::from_word) {
        let source = motion.table(from.value.word());
        if source.is_none_or(|s| s.text("file").is_none()) {
            problems.push(Diagnostic::at(
                &from,
                format!("`{}` is not a record of its own", from.value.word()),
                "take the component from one that has a `file`",
            ));
        }
    }
    let columns = component.texts("columns");
    let all = |what: TextColumn| columns.iter().filter(move |c| c.value == what.word());
    let rows = columns.len() == 1 && all(TextColumn::Rows).count() == 1;
    if let Some(first) = columns.first()
        && !rows
        && all(TextColumn::Acceleration).count() != 1
    {
        problems.push(Diagnostic::at(
            first,
            "one column must be the acceleration",
            "write columns = [\"time\", \"acceleration\"], with \"skip\" for the others, or columns = [\"rows\"] alone",
        ));
    }
    if let Some(time) = all(TextColumn::Time).nth(1) {
        problems.push(Diagnostic::at(time, "two columns are the time", "write \"skip\" for one of them"));
    }
    if let (Some(dt), Some(_)) = (component.number("dt"), all(TextColumn::Time).next()) {
        problems.push(Diagnostic::at(
            &dt,
            "`dt` beside a column of times",
            "leave `dt` out, or skip the column",
        ));
    }
}
