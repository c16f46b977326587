//! LS-DYNA keyword files (`.k`, `.key`, `.dyn`).
//!
//! Read are `*NODE`, `*ELEMENT_SOLID` with its nodes in the same line or in the next one, `*PART`, `*SET_SOLID` and
//! included files, in fixed columns (standard, `i10=y`, `long=y`, and `%`, `+` or `-` behind a keyword) and with commas.
//! Parts become groups by their titles, else `part N`; sets of solids become groups likewise. Bricks with repeated nodes are
//! the wedges, pyramids and tetrahedra that they mean. Solids of other keywords, and keywords that make or move
//! nodes or elements, are refused; surface, line and point elements are passed over with a count, and keywords that join
//! parts noted.
//!
//! The cards are those of the Keyword User's Manual, volume I.

use std::collections::BTreeMap;
use std::path::Path;

use crate::Shape;
use crate::assembly::{Draft, Numbering};
use crate::cards::{Deck, Place, fields};
use crate::fault::Fault;
use crate::format::{Format, Outcome};
use crate::input::{Input, fortran_real, text};
use crate::note::Note;

/// LS-DYNA, for [`crate::read::read`].
pub(crate) const FORMAT: Format = Format { name: "LS-DYNA keyword", recognises: is_dyna, parse };

/// Whether the first line that is no comment is a keyword, and one is written as LS-DYNA's alone are: with an underscore,
/// or followed by columns. A comment of LS-DYNA begins with `$`.
fn is_dyna(head: &[u8]) -> bool {
    let mut lines = head.split(|&b| b == b'\n').map(<[u8]>::trim_ascii_end).filter(|line| !line.is_empty());
    let Some(first) = lines.clone().find(|line| !line.starts_with(b"$")) else { return false };
    if !first.starts_with(b"*") || first.starts_with(b"**") {
        return false;
    }
    let mut after_node = false;
    lines.any(|line| {
        if !line.starts_with(b"*") {
            return line.starts_with(b"$") || (std::mem::take(&mut after_node) && !line.contains(&b','));
        }
        let (name, _) = keyword(line);
        after_node = name == "NODE";
        name == "KEYWORD" || (name.contains('_') && !line.starts_with(b"**"))
    })
}

/// A keyword's name, in upper case, and the mark of its columns: `%`, `+` or `-`.
fn keyword(line: &[u8]) -> (String, Option<u8>) {
    let line = line.get(1..).unwrap_or_default();
    let end = line.iter().position(|b| b.is_ascii_whitespace() || *b == b',').unwrap_or(line.len());
    let (name, rest) = line.split_at(end);
    let is_mark = |b: &&u8| matches!(b, b'%' | b'+' | b'-');
    let (own, behind) = (name.last().filter(is_mark), rest.trim_ascii_start().first().filter(is_mark));
    let name = &name[..name.len() - usize::from(own.is_some())];
    (text(name).to_uppercase(), own.or(behind).copied())
}

/// How wide columns are.
#[derive(Clone, Copy, Default)]
enum Columns {
    #[default]
    Standard,
    Ten,
    Long,
}

impl Columns {
    /// Of nodes.
    const fn node(self) -> &'static [usize] {
        match self {
            Columns::Standard => &[8, 16, 16, 16],
            Columns::Ten => &[10, 16, 16, 16],
            Columns::Long => &[20; 4],
        }
    }

    /// Of elements.
    const fn element(self) -> &'static [usize] {
        match self {
            Columns::Standard => &[8; 10],
            Columns::Ten => &[10; 10],
            Columns::Long => &[20; 10],
        }
    }

    /// Of all else.
    const fn other(self) -> &'static [usize] {
        match self {
            Columns::Standard | Columns::Ten => &[10; 8],
            Columns::Long => &[20; 8],
        }
    }
}

/// What data lines mean.
#[derive(Clone, Default)]
enum Section {
    #[default]
    Passed,
    Nodes,
    Solids,
    /// A title and a card each; `more` if others may follow.
    Parts {
        more: bool,
    },
    /// A title if `titled`, a card with the number, then members.
    Set {
        titled: bool,
        ranges: bool,
    },
    Includes,
    /// Elements that are passed over.
    Skipped(String),
}

/// A set of solids.
struct Set {
    number: u64,
    title: String,
    /// First and last.
    members: Vec<[u64; 2]>,
    place: Place,
}

#[derive(Default)]
struct Model {
    draft: Draft,
    /// Of each element its part.
    parts: Vec<u64>,
    titles: BTreeMap<u64, String>,
    sets: Vec<Set>,
    not_taken: BTreeMap<String, usize>,
    section: Section,
    /// Of the file, of those that include it, and of the current keyword.
    columns: Vec<Columns>,
    current: Columns,
    /// Number and part of the element whose nodes stand in the next line.
    half: Option<[u64; 2]>,
    /// The title whose card stands in the next line.
    title: Option<String>,
    /// Whether the set that is read has its number.
    open: bool,
    /// A file's name that goes on in the next line.
    name: String,
}

/// Keywords of elements that are no solids, without `ELEMENT_`, as they begin.
const OTHERS: [&str; 14] = [
    "SHELL",
    "BEAM",
    "DISCRETE",
    "MASS",
    "INERTIA",
    "SEATBELT",
    "PLOTEL",
    "SPH",
    "TRIM",
    "LANCING",
    "BEARING",
    "BLANKING",
    "INTERPOLATION",
    "DIRECT_MATRIX",
];
/// Keywords that make or move nodes or elements, as they begin.
const GENERATORS: [&str; 6] =
    ["NODE_TRANSFORM", "PART_DUPLICATE", "PART_MOVE", "PART_STACKED", "PART_ADD", "INCLUDE_"];
/// What may stand behind `PART_` where a title and a card with the number come first.
const TITLED: [&str; 6] = ["CONTACT", "INERTIA", "REPOSITION", "PRINT", "ATTACHMENT", "AVERAGED"];
/// Keywords that join parts, which a mesh cannot say, as they begin.
const JOINTS: [&str; 4] = ["NODE_MERGE", "CONTACT_", "CONSTRAINED_", "SET_SOLID_"];

fn parse(input: &mut Input, path: &Path) -> Outcome {
    let mut deck = Deck::new(input, path);
    let mut model = Model { columns: vec![Columns::Standard], ..Model::default() };
    let mut depth = 0;
    while deck.advance()? {
        if deck.depth() < depth {
            // The lines behind an included file name others.
            model.complete(&deck)?;
            model.section = Section::Includes;
            model.columns.truncate(deck.depth() + 1);
        }
        depth = deck.depth();
        let line = deck.line();
        if line.starts_with(b"$") {
            continue;
        }
        if line.starts_with(b"*") {
            model.complete(&deck)?;
            if keyword(line).0 == "END" {
                if !deck.leave() {
                    break;
                }
                continue;
            }
            model.keyword(&deck)?;
        } else if let Some(name) = model.data(&deck)? {
            deck.include(&name)?;
            model.section = Section::Passed;
            model.columns.push(model.columns.last().copied().unwrap_or_default());
            depth = deck.depth();
        }
    }
    model.complete(&deck)?;
    model.assemble()?.finish("*ELEMENT_SOLID makes a model; write the mesh of the solid parts")
}

impl Model {
    fn keyword(&mut self, deck: &Deck) -> Result<(), Fault> {
        let (name, mark) = keyword(deck.line());
        self.current = match mark {
            Some(b'%') => Columns::Ten,
            Some(b'+') => Columns::Long,
            Some(_) => Columns::Standard,
            None => self.columns.last().copied().unwrap_or_default(),
        };
        let begins = |words: &[&str]| words.iter().any(|word| name.starts_with(word));
        let element = name.strip_prefix("ELEMENT_");
        let part = name.strip_prefix("PART_");
        let set = name.strip_prefix("SET_SOLID").map(|rest| (rest.trim_end_matches("_TITLE"), rest));
        self.section = match (name.as_str(), set) {
            ("KEYWORD", _) => {
                let options: String = text(deck.line()).to_lowercase().split_whitespace().collect();
                for (option, columns) in [("i10=y", Columns::Ten), ("long=y", Columns::Long)] {
                    if options.contains(option) {
                        self.columns.pop();
                        self.columns.push(columns);
                    }
                }
                Section::Passed
            }
            ("NODE", _) => Section::Nodes,
            // Tetrahedra of four nodes, which LS-DYNA gives ten.
            ("ELEMENT_SOLID" | "ELEMENT_SOLID_TET4TOTET10", _) => Section::Solids,
            ("PART", _) => Section::Parts { more: true },
            ("INCLUDE", _) => Section::Includes,
            ("INCLUDE_PATH" | "INCLUDE_PATH_RELATIVE", _) => Section::Passed,
            (_, Some(("" | "_LIST", rest))) => {
                Section::Set { titled: rest.ends_with("_TITLE"), ranges: false }
            }
            (_, Some(("_GENERATE" | "_LIST_GENERATE", rest))) => {
                Section::Set { titled: rest.ends_with("_TITLE"), ranges: true }
            }
            _ if begins(&GENERATORS) => {
                return Err(deck.fault(format!(
                    "*{name} is not read; write all nodes and elements where they are into one file"
                )));
            }
            _ if element.is_some_and(|kind| !OTHERS.iter().any(|other| kind.starts_with(other))) => {
                return Err(deck.fault(format!("elements of *{name} are not read; write *ELEMENT_SOLID")));
            }
            _ if element.is_some() => Section::Skipped(format!("cards of *{name}")),
            _ if part.is_some_and(|kind| TITLED.iter().any(|other| kind.starts_with(other))) => {
                Section::Parts { more: false }
            }
            _ => {
                if begins(&JOINTS) {
                    *self.not_taken.entry(format!("*{name}")).or_default() += 1;
                }
                Section::Passed
            }
        };
        Ok(())
    }

    /// A data line; the name of a file that is to be included.
    fn data(&mut self, deck: &Deck) -> Result<Option<String>, Fault> {
        let line = deck.line();
        let blank = line.trim_ascii().is_empty();
        match self.section {
            Section::Parts { .. } | Section::Set { titled: true, .. }
                if self.title.is_none() && !self.open =>
            {
                self.title = Some(text(line).trim().to_owned());
            }
            Section::Parts { more } => {
                let number = self.numbers(deck, self.current.other(), 1)?;
                let Some(&number) = number.first() else {
                    return Err(deck.misplaced(line, "a part's number"));
                };
                let title = self.title.take().unwrap_or_default();
                if !title.is_empty() {
                    self.titles.insert(number, title);
                }
                if !more {
                    self.section = Section::Passed;
                }
            }
            _ if blank => {}
            Section::Nodes => self.node(deck)?,
            Section::Solids => self.solid(deck)?,
            Section::Set { ranges, .. } => self.member(deck, ranges)?,
            Section::Includes => {
                let part = text(line);
                let part = part.trim();
                // A name goes on in the next line behind a blank and a plus.
                match part.strip_suffix(" +") {
                    Some(part) => self.name += part,
                    None => return Ok(Some(std::mem::take(&mut self.name) + part)),
                }
            }
            Section::Skipped(ref kind) => self.draft.skip(kind, 1),
            Section::Passed => {}
        }
        Ok(None)
    }

    /// The first `most` numbers of a line, up to the last that is neither blank nor 0.
    fn numbers(&self, deck: &Deck, widths: &'static [usize], most: usize) -> Result<Vec<u64>, Fault> {
        let mut numbers = Vec::with_capacity(10);
        for field in fields(deck.line(), widths).take(most) {
            numbers.push(if field.is_empty() { 0 } else { deck.number(field, "a whole number")? });
        }
        let count = numbers.iter().rposition(|&number| number != 0).map_or(0, |k| k + 1);
        numbers.truncate(count);
        Ok(numbers)
    }

    fn node(&mut self, deck: &Deck) -> Result<(), Fault> {
        let mut fields = fields(deck.line(), self.current.node());
        let number = deck.number(fields.next().unwrap_or_default(), "a node's number")?;
        let mut x = [0.0; 3];
        for (x, field) in x.iter_mut().zip(fields).filter(|(_, field)| !field.is_empty()) {
            *x = fortran_real(field).ok_or_else(|| deck.misplaced(field, "a coordinate"))?;
        }
        self.draft.mesh.node_ids.push(number);
        self.draft.mesh.nodes.push(x);
        Ok(())
    }

    fn solid(&mut self, deck: &Deck) -> Result<(), Fault> {
        let numbers = self.numbers(deck, self.current.element(), 10)?;
        let ([number, part], nodes) = match (self.half.take(), numbers.as_slice()) {
            (Some(half), nodes) => (half, nodes),
            (None, &[number, part]) => {
                self.half = Some([number, part]);
                return Ok(());
            }
            (None, &[number, part, ref nodes @ ..]) => ([number, part], nodes),
            (None, _) => return Err(deck.misplaced(deck.line(), "an element's number and part")),
        };
        let (shape, corners) = match nodes.len() {
            10 => (Shape::Tet4, &nodes[..4]),
            // A tetrahedron repeats its last node, or leaves the others blank.
            4 => (Shape::Tet4, nodes),
            8 if nodes[4..].iter().all(|&n| n == nodes[3]) => (Shape::Tet4, &nodes[..4]),
            8 => (Shape::Hex8, nodes),
            count => {
                return Err(deck.fault(format!(
                    "element {number} has {count} nodes, expected 8 (some repeated) or 10; write it again"
                )));
            }
        };
        self.draft.push_numbered(number, shape, corners).map_err(|problem| deck.fault(problem))?;
        self.draft.reduce(if nodes.len() == 10 { 10 } else { shape.nodes() }, shape);
        self.parts.push(part);
        Ok(())
    }

    fn member(&mut self, deck: &Deck, ranges: bool) -> Result<(), Fault> {
        let numbers = self.numbers(deck, self.current.other(), if self.open { 8 } else { 1 })?;
        if !self.open {
            let Some(&number) = numbers.first() else {
                return Err(deck.misplaced(deck.line(), "a set's number"));
            };
            let (title, place) = (self.title.take().unwrap_or_default(), deck.place());
            self.sets.push(Set { number, title, members: Vec::new(), place });
            self.open = true;
            return Ok(());
        }
        let Some(set) = self.sets.last_mut() else { return Ok(()) };
        if !ranges {
            set.members.extend(numbers.iter().filter(|&&n| n != 0).map(|&n| [n, n]));
            return Ok(());
        }
        for pair in numbers.chunks(2) {
            match *pair {
                [first, last] if first <= last => set.members.push([first, last]),
                _ => return Err(deck.misplaced(deck.line(), "pairs of a first and a last element")),
            }
        }
        Ok(())
    }

    /// Ends a keyword.
    fn complete(&mut self, deck: &Deck) -> Result<(), Fault> {
        if let Some([number, _]) = self.half {
            return Err(deck.fault(format!(
                "element {number} before this line has no nodes; the file is cut short or damaged"
            )));
        }
        (self.title, self.open) = (None, false);
        self.name.clear();
        Ok(())
    }

    fn assemble(self) -> Result<Draft, Fault> {
        let Model { mut draft, parts, titles, sets, not_taken, .. } = self;
        draft.connect()?;
        draft.group_by_number(&parts, &titles, "part");
        let elements = Numbering::new(&draft.mesh.element_ids).map_err(|number| {
            Fault::whole(format!("there are two solid elements {number}; renumber the elements"))
        })?;
        for Set { number, title, members, place } in sets {
            let mut list = Vec::new();
            for [first, last] in members {
                let found = elements.indices(first, last, 1);
                if found.is_empty() {
                    return Err(place.fault(format!(
                        "set {number} holds element {first}, which is not there; take it out, or write the whole mesh"
                    )));
                }
                list.extend(found);
            }
            list.sort_unstable();
            list.dedup();
            let name = if title.is_empty() { format!("set {number}") } else { title };
            draft.add_group(&name, number, &list);
        }
        draft.notes.extend(not_taken.into_iter().map(|(what, count)| Note::NotTaken { what, count }));
        Ok(draft)
    }
}

#[cfg(test)]
mod tests;
