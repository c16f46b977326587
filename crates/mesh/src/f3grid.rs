//! FLAC3D's grid files (`.f3grid`), ASCII and binary.
//!
//! Zones of all types are read: B8, W6, P5, T4, and B7, a brick with one collapsed edge, which is split into two
//! pyramids. Zone groups become groups, face groups named faces. A name that is used in several slots gets the
//! slot in front, as FLAC3D writes it: `geology=rock`. Zones of no group are in `ungrouped`.
//!
//! The ASCII format is that of Itasca's manual (chapter Itasca Grid Format). Of the binary one no description is
//! public: meshio found out what the bytes mean, and its first eight, a mark and the number 3, are still unexplained.
//! Checked once: a grid of all zone types with zone groups and a face group that FLAC3D 7.00 wrote both ways (not kept
//! here) is the same mesh from both. Not checked, for want of a file: B7 zones, several slots and other versions in binary; a binary file
//! that does not fit the layout to its last byte is refused.

mod binary;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::Shape;
use crate::assembly::{Draft, Facet, Numbering, Stray};
use crate::fault::Fault;
use crate::format::{Format, Outcome};
use crate::input::{Input, shown};
use crate::note::Note;

/// FLAC3D grids, for [`crate::read::read`].
pub(crate) const FORMAT: Format = Format { name: "FLAC3D grid", recognises: is_f3grid, parse };

/// Where each node of ours stands in FLAC3D's order of a type, in which the first four gridpoints are a corner and
/// its neighbours along x, y and z. FLAC3D's own files then need no turning; meshio has the same order, but for
/// the wedge, which it takes as VTK did before 9.7.
const fn order(shape: Shape) -> &'static [usize] {
    match shape {
        Shape::Hex8 => &[0, 1, 4, 2, 3, 6, 7, 5],
        Shape::Wedge6 => &[0, 3, 1, 2, 5, 4],
        Shape::Pyramid5 => &[0, 1, 4, 2, 3],
        Shape::Tet4 => &[0, 1, 2, 3],
    }
}

/// Whether the first line that is no comment is a gridpoint, or the file is a binary grid.
fn is_f3grid(head: &[u8]) -> bool {
    let mut lines = head.split(|&b| b == b'\n').map(<[u8]>::trim_ascii);
    let first = lines.find(|line| !line.is_empty() && !line.starts_with(b"*"));
    let mut fields =
        first.unwrap_or_default().split(|b| b.is_ascii_whitespace() || *b == b',').filter(|f| !f.is_empty());
    let gridpoint = fields.next().is_some_and(|f| f.eq_ignore_ascii_case(b"G"))
        && fields.next().is_some_and(|id| id.iter().all(u8::is_ascii_digit));
    gridpoint || binary::is_binary(head)
}

/// A group as the file gives it.
struct Group {
    name: String,
    slot: String,
    numbers: Vec<u64>,
    /// Where it stands; 0 in a binary file.
    line: usize,
}

/// What the file holds.
#[derive(Default)]
struct Grid {
    /// Gridpoints and zones; the nodes of elements are the numbers of gridpoints.
    draft: Draft,
    /// The line of each zone.
    lines: Vec<u32>,
    faces: Vec<Cell>,
    zone_groups: Vec<Group>,
    face_groups: Vec<Group>,
}

/// A zone or face.
struct Cell {
    number: u64,
    count: u8,
    /// In FLAC3D's order.
    gridpoints: [u64; 8],
    line: usize,
}

/// Which list a line of numbers goes on with.
#[derive(Clone, Copy, PartialEq)]
enum Open {
    Nothing,
    ZoneGroup,
    FaceGroup,
    /// A record that is not taken over.
    Other,
}

fn parse(input: &mut Input, _: &Path) -> Outcome {
    let grid = if binary::is_binary(input.head()?) { binary::read(input)? } else { text(input)? };
    grid.assemble()?.finish("zones are lines that begin with Z; export the whole grid from FLAC3D")
}

fn text(input: &mut Input) -> Result<Grid, Fault> {
    let mut grid = Grid::default();
    let mut open = Open::Nothing;
    let mut passed: BTreeMap<String, usize> = BTreeMap::new();
    input.commas = true;
    while input.advance()? {
        let text = input.text();
        if text.starts_with(b"*") {
            continue;
        }
        if text[0].is_ascii_digit() {
            let numbers = match open {
                Open::ZoneGroup => grid.zone_groups.last_mut(),
                Open::FaceGroup => grid.face_groups.last_mut(),
                Open::Other => continue,
                Open::Nothing => None,
            };
            let Some(group) = numbers else {
                return Err(input.misplaced(input.text(), "a record such as G, Z or F"));
            };
            while !input.text().is_empty() {
                group.numbers.push(input.count("the number of a zone or face")?);
            }
            continue;
        }
        let word = crate::input::text(input.field().unwrap_or_default()).to_uppercase();
        open = match word.as_str() {
            "G" => {
                grid.draft.mesh.node_ids.push(input.count("a gridpoint's number")?);
                let mut x = [0.0; 3];
                for x in &mut x {
                    *x = input.real("a coordinate")?;
                }
                input.done()?;
                grid.draft.mesh.nodes.push(x);
                Open::Nothing
            }
            "Z" => {
                let zone = cell(input, &["B8", "W6", "P5", "T4", "B7"], "zone")?;
                grid.zone(&zone).map_err(|problem| input.fault(problem))?;
                Open::Nothing
            }
            "F" => {
                grid.faces.push(cell(input, &["Q4", "T3"], "face")?);
                Open::Nothing
            }
            "ZGROUP" | "ZG" => {
                grid.zone_groups.push(group(input)?);
                Open::ZoneGroup
            }
            "FGROUP" | "FG" => {
                grid.face_groups.push(group(input)?);
                Open::FaceGroup
            }
            _ => {
                *passed.entry(format!("records `{}`", shown(word.as_bytes()))).or_default() += 1;
                Open::Other
            }
        };
    }
    grid.draft.notes.extend(passed.into_iter().map(|(what, count)| Note::NotTaken { what, count }));
    Ok(grid)
}

/// A zone or face after its letter: type, number, gridpoints.
fn cell(input: &mut Input, types: &[&str], what: &str) -> Result<Cell, Fault> {
    let name = crate::input::text(input.field().unwrap_or_default()).to_uppercase();
    if !types.contains(&name.as_str()) {
        let name = shown(name.as_bytes());
        return Err(input.fault(format!("a {what} of type `{name}`, expected {}", types.join(", "))));
    }
    let number = input.count(&format!("the {what}'s number"))?;
    let count = name.as_bytes()[1] - b'0';
    let mut gridpoints = [0; 8];
    for gridpoint in &mut gridpoints[..usize::from(count)] {
        *gridpoint = input.count("a gridpoint's number")?;
    }
    input.done()?;
    Ok(Cell { number, count, gridpoints, line: input.line() })
}

/// The line that opens a group, after its first word.
fn group(input: &mut Input) -> Result<Group, Fault> {
    let text = crate::input::text(input.text());
    let (name, rest) = quoted(&text);
    let slot = rest.split_once(char::is_whitespace).map_or("", |(_, slot)| slot);
    let slot = quoted(slot).0;
    if name.is_empty() {
        return Err(input.fault("the group has no name; give it one"));
    }
    Ok(Group { name: name.to_owned(), slot: slot.to_owned(), numbers: Vec::new(), line: input.line() })
}

/// The word at the beginning of a text, or what stands there in quotes, and the rest.
fn quoted(text: &str) -> (&str, &str) {
    let text = text.trim();
    for quote in ['"', '\''] {
        if let Some((name, rest)) = text.strip_prefix(quote).and_then(|t| t.split_once(quote)) {
            return (name.trim(), rest.trim());
        }
    }
    text.split_once(char::is_whitespace).map_or((text, ""), |(name, rest)| (name, rest.trim()))
}

impl Grid {
    /// Adds a zone.
    fn zone(&mut self, zone: &Cell) -> Result<(), String> {
        let shape = match zone.count {
            4 => Shape::Tet4,
            5 => Shape::Pyramid5,
            6 => Shape::Wedge6,
            _ => Shape::Hex8,
        };
        // The seventh gridpoint of a B7 stands for the eighth too.
        let last = usize::from(zone.count) - 1;
        let mut corners = [0; 8];
        for (corner, &from) in corners.iter_mut().zip(order(shape)) {
            *corner = zone.gridpoints[from.min(last)];
        }
        self.lines.push(zone.line as u32);
        self.draft.push_numbered(zone.number, shape, &corners[..shape.nodes()])
    }

    fn assemble(self) -> Result<Draft, Fault> {
        let Grid { mut draft, lines, faces, zone_groups, face_groups } = self;
        draft.stray = Stray::Skipped;
        let nodes = Numbering::new(&draft.mesh.node_ids)
            .map_err(|number| Fault::whole(format!("there are two gridpoints {number}; renumber them")))?;
        let absent = |line: usize, number: u64| {
            place(line, format!("gridpoint {number} is not there; export the whole grid from FLAC3D"))
        };
        draft.resolve(0, &nodes).map_err(|(zone, number)| absent(lines[zone] as usize, number))?;
        let numbering = |numbers: &[u64], what: &str| {
            Numbering::new(numbers)
                .map_err(|number| Fault::whole(format!("there are two {what} {number}; renumber them")))
        };
        let zone_index = numbering(&draft.mesh.element_ids, "zones")?;
        for (name, group) in named(&zone_groups) {
            draft.mesh.groups.entry(name).or_default().extend(group.members(&zone_index, "zone")?);
        }
        let face_numbers: Vec<u64> = faces.iter().map(|f| f.number).collect();
        let face_index = numbering(&face_numbers, "faces")?;
        let mut grouped = vec![false; faces.len()];
        for (name, group) in named(&face_groups) {
            let list = draft.names.len() as u32;
            draft.names.push(vec![name]);
            for index in group.members(&face_index, "face")? {
                let face = &faces[index as usize];
                let mut corners = [0; 4];
                let corners = &mut corners[..usize::from(face.count)];
                for (corner, &number) in corners.iter_mut().zip(&face.gridpoints) {
                    *corner = nodes.index(number).ok_or_else(|| absent(face.line, number))?;
                }
                draft.facets.push(Facet::new(corners, face.number, list));
                grouped[index as usize] = true;
            }
        }
        draft.skip("faces of no group", grouped.iter().filter(|g| !**g).count());
        Ok(draft)
    }
}

fn place(line: usize, problem: String) -> Fault {
    if line == 0 { Fault::whole(problem) } else { Fault::at(line, problem) }
}

impl Group {
    fn members(&self, numbering: &Numbering, what: &str) -> Result<Vec<u32>, Fault> {
        let find = |&number: &u64| {
            numbering.index(number).ok_or_else(|| {
                let problem =
                    format!("{what} {number} of group `{}` is not there; export the whole grid", self.name);
                place(self.line, problem)
            })
        };
        self.numbers.iter().map(find).collect()
    }
}

/// Groups with their names, which have the slot in front where several slots use them.
fn named(groups: &[Group]) -> Vec<(String, &Group)> {
    let mut slots: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for group in groups {
        slots.entry(&group.name).or_default().insert(&group.slot);
    }
    let name = |group: &Group| match slots[group.name.as_str()].len() {
        1 => group.name.clone(),
        _ => format!("{}={}", group.slot, group.name),
    };
    groups.iter().map(|group| (name(group), group)).collect()
}

#[cfg(test)]
mod tests;
