//! A column of a table: whose it is, which quantity, in which unit.

use serde::{Deserialize, Serialize};

/// What stands before the quantities of the model itself.
const MODEL: &str = "model";

/// Whose a column is, by name. Names may hold dots and hyphens, so no header tells it for sure.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "subject", content = "of", rename_all = "lowercase")]
pub enum Subject {
    /// Nobody's: the time, a line of the balance, the given motion.
    #[default]
    None,
    Monitor(String),
    /// The first monitor less the second.
    #[serde(rename = "pair of monitors")]
    Relative([String; 2]),
    /// A monitor on an interface: the pair of nodes nearest to it.
    #[serde(rename = "interface pair")]
    Pair(String),
    /// A monitor on a bolt: the segment nearest to it.
    Bolt(String),
    Interface(String),
    Group(String),
    /// A column of ground beside the model.
    Column(String),
    /// The mean over the model's vertical edges.
    Model,
    /// A vertical edge of the model, `xmin-ymin` ….
    Edge(String),
    /// The place of a record that was deconvolved.
    Record,
    /// Nodes that a stage moves.
    Moved(String),
}

impl Subject {
    /// What stands before the quantity in a header; nothing of nobody.
    pub fn name(&self) -> Option<String> {
        match self {
            Subject::None => None,
            Subject::Model => Some(MODEL.to_owned()),
            Subject::Record => Some("record".to_owned()),
            Subject::Monitor(name)
            | Subject::Pair(name)
            | Subject::Bolt(name)
            | Subject::Interface(name)
            | Subject::Group(name)
            | Subject::Column(name)
            | Subject::Moved(name) => Some(name.clone()),
            Subject::Relative([first, second]) => Some(format!("{first}-{second}")),
            Subject::Edge(name) => Some(format!("{MODEL}.{name}")),
        }
    }
}

/// A column, `time [s]` or `A.ux [m]` in the file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Column {
    /// The first word of the header: the subject's name, dot, quantity; the quantity alone without a subject.
    pub name: String,
    #[serde(flatten)]
    pub subject: Subject,
    pub quantity: String,
    /// SI unit; empty for a pure number.
    pub unit: String,
}

impl Column {
    /// A column of nobody's.
    pub fn new(name: impl Into<String>, unit: impl Into<String>) -> Self {
        let name = name.into();
        Column { quantity: name.clone(), name, subject: Subject::None, unit: unit.into() }
    }

    /// A column of somebody's, whose name follows.
    pub fn of(subject: Subject, quantity: impl Into<String>, unit: impl Into<String>) -> Self {
        let quantity = quantity.into();
        let name = match subject.name() {
            Some(whose) => format!("{whose}.{quantity}"),
            None => quantity.clone(),
        };
        Column { name, subject, quantity, unit: unit.into() }
    }

    /// `name [unit]`, or the name alone where there is no unit.
    pub fn header(&self) -> String {
        if self.unit.is_empty() { self.name.clone() } else { format!("{} [{}]", self.name, self.unit) }
    }

    /// The column of a header, whose as yet nobody said.
    pub fn parse(header: &str) -> Self {
        let header = header.trim();
        let (name, rest) = header.split_once(char::is_whitespace).unwrap_or((header, ""));
        let unit = rest.trim().trim_start_matches('[').trim_end_matches(']').trim();
        Column::new(name, unit)
    }
}
