//! What a result folder holds, and by what its copies differ.

/// What stands in a file, or what a reader may take from its rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A number of `summary.json`, or one in a text of it.
    Leaf,
    /// Largest, smallest, first or last of a column, or what stands in the same row.
    Extreme,
    /// The largest, or the sum, of numbers of one name in several places.
    Over,
    /// Largest or smallest of an array of a VTU file.
    Field,
    /// Another row of a column.
    Row,
}

/// A number that the page may show.
#[derive(Clone, Debug)]
pub struct Known {
    pub kind: Kind,
    pub name: String,
    pub value: f64,
}

/// The numbers of a folder, and words with digits in them.
#[derive(Default)]
pub struct Content {
    pub known: Vec<Known>,
    pub names: Vec<String>,
    /// The factor of places in field files.
    pub places: f64,
}

/// Factors by which what is called `name` is scaled in the copy `copy`; those of no other name or copy.
pub fn factor(copy: u64, name: &str) -> f64 {
    if copy == 0 {
        return 1.0;
    }
    let mut hash = 0xcbf2_9ce4_8422_2325_u64 ^ copy.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    for byte in name.bytes() {
        hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }
    hash ^= hash >> 33;
    hash = hash.wrapping_mul(0xff51_afd7_ed55_8ccd);
    hash ^= hash >> 33;
    // By half of the spread at least, up or down.
    let part = (hash >> 12) as f64 / (1_u64 << 52) as f64;
    let by = super::SPREAD * (0.5 + 0.5 * part);
    if hash & 1 == 0 { 1.0 + by } else { 1.0 - by }
}

impl Content {
    /// Keeps a text with digits in it that is no number.
    pub fn name_of(&mut self, text: &str) {
        let text = text.split(" [").next().unwrap_or_default();
        let named = text.contains(|c: char| c.is_ascii_digit()) && text.contains(|c: char| c.is_alphabetic());
        if named && text.parse::<f64>().is_err() && !self.names.iter().any(|name| name == text) {
            self.names.push(text.to_owned());
        }
    }
}
