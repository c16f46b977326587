//! Names of properties, which preprocessors write into comments.

use std::collections::BTreeMap;

use crate::input::text;

/// Names by the number of the property.
#[derive(Default)]
pub(super) struct Names {
    properties: BTreeMap<u64, String>,
    /// The name for the property that comes next.
    next: Option<String>,
}

impl Names {
    /// Takes a comment: `$ … Property 3 : rock` (Femap, Simcenter), `$HMNAME PROP 3"rock"` (HyperMesh),
    /// `$ANSA_NAME_COMMENT;3;PSOLID;rock;`, and `$ … region : rock` before a property (Patran).
    pub(super) fn comment(&mut self, comment: &[u8]) {
        let comment = text(comment);
        let numbered = |number: &str, name: &str| {
            let name = name.trim();
            number.trim().parse().ok().filter(|_| !name.is_empty()).map(|number| (number, name.to_owned()))
        };
        let entry = if let Some(rest) = comment.strip_prefix("$HMNAME PROP") {
            let mut parts = rest.split('"');
            numbered(parts.next().unwrap_or_default(), parts.next().unwrap_or_default())
        } else if let Some(rest) = comment.strip_prefix("$ANSA_NAME_COMMENT;") {
            let parts: Vec<&str> = rest.split(';').collect();
            parts.get(..3).filter(|p| p[1].starts_with('P')).and_then(|p| numbered(p[0], p[2]))
        } else if let Some((_, name)) = comment.split_once("region : ") {
            self.next = Some(name.trim().to_owned()).filter(|name| !name.is_empty());
            None
        } else {
            let rest = comment.split_once("Property ").map(|(_, rest)| rest);
            rest.and_then(|rest| rest.split_once(" : ")).and_then(|(number, name)| numbered(number, name))
        };
        self.properties.extend(entry);
    }

    /// Takes a property, which may have been named before.
    pub(super) fn property(&mut self, number: u64) {
        if let Some(name) = self.next.take() {
            self.properties.insert(number, name);
        }
    }

    pub(super) fn into_properties(self) -> BTreeMap<u64, String> {
        self.properties
    }
}
