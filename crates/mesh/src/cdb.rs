//! ANSYS archives (`.cdb`, written by CDWRITE; Workbench's `ds.dat` too).
//!
//! Nodes come from NBLOCK, elements from EBLOCK with the key SOLID, element types from ET and ETBLOCK. Element
//! components (CMBLOCK) become groups, node components of one node named points. Elements of no component are in
//! the group `material N`. Bricks with repeated nodes are the wedges, pyramids and tetrahedra that ANSYS means.
//!
//! The blocks are those of the Programmer's Reference (chapter Coded Database File Commands). Checked once,
//! beside mapdl-archive, on archives that ANSYS wrote with SOLID185, SOLID186 and SOLID187 in three formats of columns,
//! which are not kept here. A block with the key COMPACT has elements of one line, whose type and material TYPE and MAT set.
//! Solids in blocks without a key are refused, other elements there passed over with a count. Archives of single commands
//! (UNBLOCKED) and files of parameters alone are refused.

mod columns;
mod types;

use std::collections::{BTreeMap, HashMap};
use std::path::Path;

use crate::Shape;
use crate::assembly::{Draft, Numbering};
use crate::fault::Fault;
use crate::format::{Format, Outcome};
use crate::input::{Input, fortran_real, text, whole};
use crate::note::Note;
use columns::{Columns, integer};
use types::{Family, family};

/// ANSYS archives, for [`crate::read::read`].
pub(crate) const FORMAT: Format = Format { name: "ANSYS archive (.cdb)", recognises: is_cdb, parse };

/// What to do about a file without blocks.
const EXPORT: &str = "write it with CDWRITE,DB,NAME,cdb";

/// Whether one of the first lines is a command of such files.
fn is_cdb(head: &[u8]) -> bool {
    const COMMANDS: [&[u8]; 8] =
        [b"NBLOCK,", b"EBLOCK,", b"ETBLOCK,", b"/PREP7", b"/COM,ANSYS", b"*SET,", b"*DIM,", b"*PREAD,"];
    let starts =
        |line: &[u8], word: &&[u8]| line.len() >= word.len() && line[..word.len()].eq_ignore_ascii_case(word);
    head.split(|&b| b == b'\n').any(|line| COMMANDS.iter().any(|word| starts(line.trim_ascii(), word)))
}

#[derive(Default)]
struct Archive {
    draft: Draft,
    /// ANSYS's number of each element type that is defined.
    types: HashMap<u64, String>,
    /// Material and line of each element of the draft, whose nodes are still numbers.
    materials: Vec<u32>,
    lines: Vec<u32>,
    components: Vec<Component>,
    /// The type and the material that TYPE and MAT set last.
    current: Option<u64>,
    material: u64,
    /// Whether nodes or elements stand there as single commands.
    unblocked: bool,
    /// Whether parameters are set.
    parameters: bool,
}

struct Component {
    name: String,
    of_nodes: bool,
    /// First and last of each run.
    ranges: Vec<[u64; 2]>,
}

fn parse(input: &mut Input, _: &Path) -> Outcome {
    let mut archive = Archive::default();
    while input.advance()? {
        let text = text(input.text());
        // `!` begins a comment, `$` another command on the line.
        for command in text.split('!').next().unwrap_or_default().split('$') {
            archive.command(input, &command.split(',').map(str::trim).collect::<Vec<_>>())?;
        }
    }
    archive.assemble()?.finish("select the solid elements and write them again")
}

impl Archive {
    /// One command, with the block that follows it.
    fn command(&mut self, input: &mut Input, fields: &[&str]) -> Result<(), Fault> {
        let number = |k: usize| fields.get(k).and_then(|n| whole(n.as_bytes()));
        match fields[0].to_ascii_uppercase().as_str() {
            "NBLOCK" => self.nodes(input)?,
            "EBLOCK" => match fields.get(2) {
                Some(key) if key.eq_ignore_ascii_case("COMPACT") => self.compact(input)?,
                _ => self.elements(input, fields)?,
            },
            "ETBLOCK" => self.type_block(input)?,
            "ET" => {
                if let (Some(number), Some(name)) = (number(1), fields.get(2)) {
                    let name = name.split_whitespace().next();
                    self.types.insert(number, name.unwrap_or_default().to_owned());
                }
            }
            "TYPE" => self.current = number(1),
            "MAT" => self.material = number(1).unwrap_or(0),
            "CMBLOCK" => self.component(input, fields)?,
            "N" | "EN" | "E" => self.unblocked = true,
            "*SET" | "*DIM" | "*PREAD" => self.parameters = true,
            _ => {}
        }
        Ok(())
    }

    fn nodes(&mut self, input: &mut Input) -> Result<(), Fault> {
        let columns = Columns::read(input)?;
        loop {
            input.expect("a node, or the end of the block")?;
            if ends(input) {
                return Ok(());
            }
            let line = input.whole_line();
            let id = columns.integer(line, 0).and_then(whole);
            let mut x = [0.0; 3];
            let mut good = id.is_some();
            for (k, x) in x.iter_mut().enumerate() {
                match columns.real(line, k) {
                    // Coordinates at the end that are 0 may be left out.
                    None | Some(b"") => {}
                    Some(field) => match fortran_real(field) {
                        Some(value) => *x = value,
                        None => good = false,
                    },
                }
            }
            let (Some(id), true) = (id, good) else {
                return Err(input.misplaced(line, "a node in the columns of the block's format"));
            };
            self.draft.mesh.node_ids.push(id);
            self.draft.mesh.nodes.push(x);
        }
    }

    fn type_block(&mut self, input: &mut Input) -> Result<(), Fault> {
        input.expect("the format of the block")?;
        loop {
            input.expect("an element type, or the end of the block")?;
            if ends(input) {
                return Ok(());
            }
            let number = input.count("the number of an element type")?;
            let name = input.count("the element type")?;
            self.types.insert(number, name.to_string());
        }
    }

    fn elements(&mut self, input: &mut Input, fields: &[&str]) -> Result<(), Fault> {
        let solid = fields.get(2).is_some_and(|f| f.eq_ignore_ascii_case("SOLID"));
        let current = self.current.and_then(|kind| self.types.get(&kind));
        if let (false, Some(name)) = (solid, current)
            && family(name) != Family::Other
        {
            return Err(input.fault(format!(
                "elements of type {name} stand in a block without the key SOLID, which cannot be read; {EXPORT}"
            )));
        }
        let columns = Columns::read(input)?;
        loop {
            input.expect("an element, or the end of the block")?;
            if ends(input) {
                return Ok(());
            }
            if !solid {
                self.draft.skip("elements of a block without the key SOLID", 1);
                continue;
            }
            let line = input.whole_line();
            let at = |k: usize| columns.integer(line, k).and_then(whole);
            let (Some(material), Some(kind), Some(count), Some(number)) = (at(0), at(1), at(8), at(10))
            else {
                return Err(input.misplaced(line, "an element of eleven numbers and its nodes"));
            };
            if count > 20 {
                return Err(
                    input.fault(format!("element {number} has {count} nodes, expected at most 20; {EXPORT}"))
                );
            }
            let count = count as usize;
            let mut nodes = Vec::with_capacity(20);
            nodes.extend((0..count.min(8)).map_while(|k| at(11 + k)));
            let first = input.line();
            while nodes.len() >= 8 && nodes.len() < count {
                input.expect("the other nodes of an element")?;
                let before = nodes.len();
                let line = input.whole_line();
                nodes.extend((0..count - before).map_while(|k| columns.integer(line, k).and_then(whole)));
                if nodes.len() == before {
                    break;
                }
            }
            if nodes.len() < count {
                return Err(
                    input.fault(format!("element {number} has {} nodes, {count} are announced", nodes.len()))
                );
            }
            self.element(input, [kind, number, material], &nodes, first)?;
        }
    }

    /// The elements of a block with the key COMPACT: a number and nodes a line; TYPE and MAT hold for all of them.
    fn compact(&mut self, input: &mut Input) -> Result<(), Fault> {
        let columns = Columns::read(input)?;
        let (kind, material) = (self.current.unwrap_or(1), self.material);
        loop {
            input.expect("an element, or the end of the block")?;
            if ends(input) {
                return Ok(());
            }
            let line = input.whole_line();
            let mut numbers = (0..columns.integers).map_while(|k| columns.integer(line, k)).map(whole);
            let number = numbers.next().flatten();
            let nodes: Option<Vec<u64>> = numbers.collect();
            let (Some(number), Some(nodes)) = (number, nodes) else {
                return Err(input.misplaced(line, "an element's number and its nodes"));
            };
            let brick = self.types.get(&kind).is_some_and(|name| family(name) == Family::Brick);
            if brick && nodes.len() > 8 && nodes.len() + 1 == columns.integers {
                return Err(input.fault(format!(
                    "element {number} of a COMPACT block fills its line; whether it goes on cannot be told; {EXPORT}"
                )));
            }
            self.element(input, [kind, number, material], &nodes, input.line())?;
        }
    }

    /// Adds an element, given its type, number and material, and the line where it begins.
    fn element(
        &mut self,
        input: &Input,
        [kind, number, material]: [u64; 3],
        nodes: &[u64],
        line: usize,
    ) -> Result<(), Fault> {
        let Some((shape, full)) = self.shape(input, kind, number, nodes)? else { return Ok(()) };
        self.draft
            .push_numbered(number, shape, &nodes[..shape.nodes()])
            .map_err(|problem| Fault::at(line, problem))?;
        self.draft.reduce(full, shape);
        self.materials.push(u32::try_from(material).unwrap_or(u32::MAX));
        self.lines.push(line as u32);
        Ok(())
    }

    /// The shape of an element of type `kind` with these nodes, and the number of nodes that it has in full: midside nodes
    /// at the end may be absent. None if it is passed over.
    fn shape(
        &mut self,
        input: &Input,
        kind: u64,
        number: u64,
        nodes: &[u64],
    ) -> Result<Option<(Shape, usize)>, Fault> {
        let Some(name) = self.types.get(&kind) else {
            let problem =
                format!("element {number} has type {kind}, which no ET before it defines; {EXPORT}");
            return Err(input.fault(problem));
        };
        let full = types::nodes(name);
        // A tetrahedron as a brick with repeated nodes.
        let repeated = nodes.len() >= 8 && nodes[4..8].iter().all(|&n| n == nodes[4]);
        match (family(name), nodes.len()) {
            (Family::Other, _) => {
                self.draft.skip(&format!("elements of ANSYS's type {name}"), 1);
                Ok(None)
            }
            (Family::Tetrahedron, 8 | 20) if repeated => Ok(Some((Shape::Hex8, nodes.len()))),
            (Family::Brick | Family::Tetrahedron, 4) => Ok(Some((Shape::Tet4, 4))),
            (Family::Brick, count @ (8 | 20)) => Ok(Some((Shape::Hex8, count))),
            (Family::Tetrahedron, 10) => Ok(Some((Shape::Tet4, 10))),
            (Family::Tetrahedron, 5..10) if full == 10 => Ok(Some((Shape::Tet4, 10))),
            (Family::Brick, 9..20) if full == 20 => Ok(Some((Shape::Hex8, 20))),
            (_, count) => {
                Err(input.fault(format!("element {number} of type {name} has {count} nodes; {EXPORT}")))
            }
        }
    }

    fn component(&mut self, input: &mut Input, fields: &[&str]) -> Result<(), Fault> {
        let name = fields.get(1).copied().unwrap_or_default();
        let count = fields.get(3).and_then(|f| f.split_whitespace().next()).and_then(|f| whole(f.as_bytes()));
        let Some(count) = count.filter(|_| !name.is_empty()) else {
            return Err(input.fault("expected CMBLOCK, a name, NODE or ELEM, and a count here"));
        };
        let of_nodes = fields[2].to_ascii_uppercase().starts_with("NODE");
        let mut component = Component { name: name.to_owned(), of_nodes, ranges: Vec::new() };
        let columns = Columns::read(input)?;
        let mut found = 0;
        while found < count {
            input.expect("members of the component")?;
            let line = input.whole_line();
            let mut here = 0;
            while found < count && here < columns.integers {
                let Some(field) = columns.integer(line, here) else { break };
                let Some(member) = integer(field) else {
                    return Err(input.misplaced(field, "a member of the component"));
                };
                match (component.ranges.last_mut(), member.unsigned_abs()) {
                    // A negative number is the last of a run from the one before it.
                    (Some([_, last]), end) if member < 0 && end >= *last => *last = end,
                    (_, one) if member > 0 => component.ranges.push([one, one]),
                    _ => return Err(input.misplaced(field, "a member of the component")),
                }
                here += 1;
                found += 1;
            }
            if here == 0 {
                return Err(input.misplaced(line, "members of the component"));
            }
        }
        self.components.push(component);
        Ok(())
    }

    fn assemble(self) -> Result<Draft, Fault> {
        let Archive { mut draft, materials, lines, components, unblocked, parameters, .. } = self;
        if parameters && !unblocked && draft.mesh.nodes.is_empty() && draft.mesh.elements.is_empty() {
            return Err(Fault::whole(format!(
                "this ANSYS file holds parameters, but neither nodes nor elements; {EXPORT}"
            )));
        }
        if unblocked && (draft.mesh.nodes.is_empty() || draft.mesh.elements.is_empty()) {
            return Err(Fault::whole(format!("nodes or elements are single commands, not blocks; {EXPORT}")));
        }
        let nodes = Numbering::new(&draft.mesh.node_ids)
            .map_err(|number| Fault::whole(format!("there are two nodes {number}; renumber them")))?;
        draft.resolve(0, &nodes).map_err(|(e, node)| {
            let element = draft.mesh.element_ids[e];
            let problem = format!("element {element} uses node {node}, which is not there; {EXPORT}");
            Fault::at(lines[e] as usize, problem)
        })?;
        let numbering = Numbering::new(&draft.mesh.element_ids).map_err(|number| {
            Fault::whole(format!("there are two solid elements {number}; renumber them"))
        })?;
        let mut grouped = vec![false; draft.mesh.elements.len()];
        let mut several = 0;
        for Component { name, of_nodes, ranges } in components {
            let numbering = if of_nodes { &nodes } else { &numbering };
            let members: Vec<u32> = ranges.iter().flat_map(|&[a, b]| numbering.indices(a, b, 1)).collect();
            match (of_nodes, members.as_slice()) {
                (true, [node]) => drop(draft.mesh.points.insert(name, draft.mesh.nodes[*node as usize])),
                (true, _) => several += 1,
                (false, []) => {}
                (false, list) => {
                    for &e in list {
                        grouped[e as usize] = true;
                    }
                    draft.mesh.groups.entry(name).or_default().extend(members);
                }
            }
        }
        if several > 0 {
            draft
                .notes
                .push(Note::NotTaken { what: "node components of several nodes".into(), count: several });
        }
        let mut rest: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for (index, &material) in (0..).zip(&materials).filter(|(i, _): &(u32, _)| !grouped[*i as usize]) {
            rest.entry(material).or_default().push(index);
        }
        for (material, list) in rest {
            draft.mesh.groups.entry(format!("material {material}")).or_default().extend(list);
        }
        Ok(draft)
    }
}

/// Whether the line ends a block.
fn ends(input: &Input) -> bool {
    let text = input.text();
    text == b"-1" || text.starts_with(b"N,") || text.starts_with(b"n,")
}

#[cfg(test)]
mod tests;
