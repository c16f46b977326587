//! Gmsh's MSH files: version 4.1 and 2, ASCII and binary.
//!
//! Physical volumes become groups of elements, physical surfaces groups of faces, physical points named
//! points; physical curves are passed over. Elements of no physical volume form the group `ungrouped`.
//! A physical group without a name is called by its dimension and tag, as `volume 3` or `surface 7`.
//! Elements of second order are reduced to their corners, with a note. Sections that are not needed are
//! skipped; partitioned files are refused.

mod entities;
mod kinds;
mod numbers;
mod out;
mod version2;
mod version4;
mod write;

use std::collections::HashSet;
use std::path::Path;

use crate::assembly::{Draft, Numbering};
use crate::fault::Fault;
use crate::format::{Format, Outcome};
use crate::input::{Input, shown, text};
use entities::{Entities, Names, physical_names};
use numbers::{Encoding, Numbers};

pub(crate) use write::{ascii, binary};

/// MSH, for [`crate::read::read`].
pub(crate) const FORMAT: Format =
    Format { name: "Gmsh MSH 4.1 or 2 (ASCII or binary)", recognises: is_msh, parse };

/// What to do about a file of another version.
const EXPORT: &str = "export it as MSH 4.1 (in Gmsh: File > Export, .msh, `Version 4 ASCII`, or by \
                      `gmsh FILE -save -format msh41 -o NEW.msh`)";
const PARTITIONED: &str =
    "the mesh is partitioned; remove the partition (in Gmsh: Mesh > Unpartition) and save again";
/// The sections that are read; each may be there once.
const READ: [&str; 5] = ["MeshFormat", "PhysicalNames", "Entities", "Nodes", "Elements"];

/// Whether a file that begins so is an MSH file of any version.
fn is_msh(head: &[u8]) -> bool {
    head.split(|&b| b == b'\n').any(|line| matches!(line.trim_ascii(), b"$MeshFormat" | b"$NOD"))
}

/// What has been read.
#[derive(Default)]
struct Reader {
    /// Major version, once the section $MeshFormat was there.
    version: Option<(u8, Encoding)>,
    names: Names,
    entities: Entities,
    numbering: Option<Numbering>,
    draft: Draft,
}

fn parse(input: &mut Input, _: &Path) -> Outcome {
    let mut reader = Reader::default();
    let mut seen = HashSet::new();
    while input.advance()? {
        let Some(name) = input.text().strip_prefix(b"$") else { continue };
        let name = text(name);
        if READ.contains(&name.as_str()) && !seen.insert(name.clone()) {
            return Err(input.fault(format!("a second section ${name}; save the mesh in one piece")));
        }
        reader.section(input, &name)?;
    }
    for name in ["MeshFormat", "Nodes", "Elements"] {
        if !seen.contains(name) {
            return Err(Fault::whole(format!("there is no section ${name}; save the whole mesh from Gmsh")));
        }
    }
    let Reader { mut draft, entities, .. } = reader;
    draft.mesh.points.extend(entities.points);
    draft.finish(
        "mesh the volumes (Mesh > 3D) and save with them in a physical volume, or with Mesh.SaveAll = 1",
    )
}

impl Reader {
    /// Reads a section, from the line that opens it to the one that closes it.
    fn section(&mut self, input: &mut Input, name: &str) -> Result<(), Fault> {
        match name {
            "MeshFormat" => {
                self.version = Some(version(input)?);
                return Numbers { input, encoding: Encoding::Ascii }.close(name);
            }
            "NOD" => return Err(input.fault(format!("this is MSH version 1, expected 4.1 or 2; {EXPORT}"))),
            "ParametricNodes" => {
                return Err(input.fault(
                    "its nodes have parameters on curves and surfaces; save with Mesh.SaveParametric = 0 or as MSH 4.1",
                ));
            }
            "PartitionedEntities" | "GhostElements" => return Err(input.fault(PARTITIONED)),
            "PhysicalNames" => self.names = physical_names(input)?,
            "Entities" | "Nodes" | "Elements" => {
                let Some((version, encoding)) = self.version else {
                    return Err(input.fault(format!(
                        "the section ${name} stands before $MeshFormat; save the mesh again"
                    )));
                };
                let missing =
                    |what: &str| format!("the section ${name} stands before {what}; save the mesh again");
                let mut numbers = Numbers { input, encoding };
                let draft = &mut self.draft;
                match (name, version) {
                    ("Entities", _) if self.numbering.is_some() => {
                        return Err(numbers
                            .input
                            .fault("the section $Entities follows $Nodes; save the mesh again"));
                    }
                    ("Entities", _) => self.entities = Entities::parse(&mut numbers, &self.names)?,
                    ("Nodes", _) => {
                        if version == 4 {
                            version4::nodes(&mut numbers, draft)?;
                        } else {
                            version2::nodes(&mut numbers, draft)?;
                        }
                        let numbering = Numbering::new(&draft.mesh.node_ids).map_err(|number| {
                            numbers.input.fault(format!("there are two nodes {number}; renumber the nodes"))
                        })?;
                        self.numbering = Some(numbering);
                    }
                    _ => {
                        let Some(numbering) = self.numbering.as_ref() else {
                            return Err(numbers.input.fault(missing("$Nodes")));
                        };
                        if version == 4 {
                            version4::elements(&mut numbers, draft, numbering, &self.entities.groups)?;
                        } else {
                            version2::elements(&mut numbers, draft, numbering, &self.names)?;
                        }
                    }
                }
                return numbers.close(name);
            }
            _ => return skip(input, name),
        }
        Numbers { input, encoding: Encoding::Ascii }.close(name)
    }
}

/// Passes over a section.
fn skip(input: &mut Input, name: &str) -> Result<(), Fault> {
    let open = input.fault(format!(
        "the section ${0} is not closed by $End{0}; the file is cut short or damaged",
        shown(name.as_bytes())
    ));
    while input.advance()? {
        match input.text().strip_prefix(b"$End") {
            Some(end) if end == name.as_bytes() => return Ok(()),
            _ => {}
        }
    }
    Err(open)
}

/// The section $MeshFormat.
fn version(input: &mut Input) -> Result<(u8, Encoding), Fault> {
    input.expect("the version")?;
    let version = input.real("the version of the format")?;
    let major = match version {
        4.1 => 4,
        2.0..3.0 => 2,
        _ => return Err(input.fault(format!("this is MSH version {version}, expected 4.1 or 2; {EXPORT}"))),
    };
    if input.count("0 for ASCII or 1 for binary")? == 0 {
        return Ok((major, Encoding::Ascii));
    }
    let size = input.count("the size of a number in bytes")?;
    if size != 8 {
        return Err(input.fault(format!("its numbers have {size} bytes, expected 8; {EXPORT}")));
    }
    let one = input.bytes(4)?.map(<[u8]>::to_vec);
    match one.as_deref() {
        Some([1, 0, 0, 0]) => Ok((major, Encoding::Little)),
        Some([0, 0, 0, 1]) => Ok((major, Encoding::Big)),
        _ => Err(input.fault(format!("the mark of the byte order is missing; {EXPORT}"))),
    }
}

/// The index of a node.
fn node(numbers: &Numbers, numbering: &Numbering, number: u64) -> Result<u32, Fault> {
    numbering.index(number).ok_or_else(|| {
        numbers.input.fault(format!("node {number} is not in the section $Nodes; save the whole mesh again"))
    })
}

#[cfg(test)]
mod tests;
