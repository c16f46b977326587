//! Nastran bulk data (`.bdf`, `.nas`, `.dat`).
//!
//! Read are GRID with GRDSET, CORD2R, the solids CHEXA, CPENTA, CPYRAM and CTETRA, and included files, in small, large
//! and free field. Each property (PID) becomes a group, named by a preprocessor's comment, else `property N`. Solids of
//! other cards are refused, other elements passed over with a count, and cards that join parts noted. All else is
//! passed over: executive and case control, loads, materials.
//!
//! The cards are those of the Quick Reference Guide of MSC Nastran.

mod bulk;
mod names;
mod systems;

use std::collections::BTreeMap;
use std::path::Path;

use crate::Shape;
use crate::assembly::Draft;
use crate::fault::Fault;
use crate::format::{Format, Outcome};
use crate::input::{Input, fortran_real, shown, whole};
use crate::note::Note;
use bulk::{Bulk, Card};
use names::Names;
use systems::Systems;

/// Nastran, for [`crate::read::read`].
pub(crate) const FORMAT: Format = Format { name: "Nastran bulk data", recognises: is_nastran, parse };

/// Whether one of the first lines is a card or a command of such files.
fn is_nastran(head: &[u8]) -> bool {
    const CARDS: [&str; 8] = ["GRID", "CHEXA", "CPENTA", "CPYRAM", "CTETRA", "PSOLID", "GRDSET", "CORD2R"];
    head.split(|&b| b == b'\n').any(|line| {
        let line = line.trim_ascii_end().to_ascii_uppercase();
        let end = line.iter().position(|b| !b.is_ascii_alphanumeric()).unwrap_or(line.len());
        let (word, rest) = line.split_at(end);
        let card = CARDS.iter().any(|card| card.as_bytes() == word);
        let quoted = || rest.trim_ascii_start().starts_with(b"'");
        line == b"CEND"
            || line.starts_with(b"BEGIN BULK")
            || (card && matches!(rest.first(), Some(b' ' | b',' | b'*' | b'\t')))
            || (word == b"INCLUDE" && quoted())
    })
}

/// The shape of a solid, and the number of its nodes with those at the middles of edges.
fn solid(name: &str) -> Option<(Shape, usize)> {
    Some(match name {
        "CHEXA" => (Shape::Hex8, 20),
        "CPENTA" => (Shape::Wedge6, 15),
        "CPYRAM" | "CPYRA" => (Shape::Pyramid5, 13),
        "CTETRA" => (Shape::Tet4, 10),
        _ => return None,
    })
}

/// How names of other solids begin.
const SOLIDS: [&str; 9] = ["CHEX", "CPEN", "CPYR", "CTETR", "CIHEX", "CIFHEX", "CIFPEN", "CHACAB", "CHACBR"];
/// How names of surface, line, point and contact elements begin.
const OTHERS: [&str; 21] = [
    "CQUAD", "CTRIA", "CSHEAR", "CBAR", "CBEAM", "CBEND", "CROD", "CONROD", "CTUBE", "CBUSH", "CELAS",
    "CDAMP", "CMASS", "CONM", "CVISC", "CGAP", "CWELD", "CFAST", "CSEAM", "PLOTEL", "CONV",
];
/// Cards that join parts, which a mesh cannot say.
const JOINTS: [&str; 8] = ["MPC", "RBAR", "RBE1", "RBE2", "RBE3", "RROD", "RSPLINE", "BCTABLE"];

fn parse(input: &mut Input, path: &Path) -> Outcome {
    let mut model = Model::default();
    let mut bulk = Bulk::new(input, path);
    while let Some(card) = bulk.next(&mut model.names)? {
        model.card(card)?;
    }
    model
        .assemble()?
        .finish("CHEXA, CPENTA, CPYRAM and CTETRA make a model; write the mesh with its bulk data")
}

#[derive(Default)]
struct Model {
    draft: Draft,
    /// Of each node the system (CP) of its coordinates; none if the card has none.
    node_systems: Vec<Option<u64>>,
    systems: Systems,
    /// The system of nodes without one.
    default_system: Option<u64>,
    /// Of each element its property.
    properties: Vec<u64>,
    names: Names,
    joints: BTreeMap<String, usize>,
}

impl Model {
    fn card(&mut self, card: &Card) -> Result<(), Fault> {
        let name = card.name();
        if let Some((shape, full)) = solid(name) {
            return self.element(card, shape, full);
        }
        match name {
            "GRID" => {
                card.check()?;
                let mut x = [0.0; 3];
                for (k, x) in x.iter_mut().enumerate() {
                    *x = card.real(2 + k, "a coordinate")?;
                }
                self.draft.mesh.node_ids.push(card.number(0, "a node's number")?);
                self.draft.mesh.nodes.push(x);
                self.node_systems.push(card.optional(1, "the number of a coordinate system")?);
            }
            "GRDSET" => self.default_system = card.optional(1, "the number of a coordinate system")?,
            "PSOLID" => self.names.property(card.number(0, "a property's number")?),
            _ if name.starts_with("CORD") => self.systems.define(card)?,
            _ if name.starts_with('=') || name.starts_with("*(") => {
                return Err(card.fault("replicated cards are not read; write every card out"));
            }
            _ if SOLIDS.iter().any(|begin| name.starts_with(begin)) => {
                return Err(card.fault(format!(
                    "solids of the card {name} are not read; write CHEXA, CPENTA, CPYRAM or CTETRA"
                )));
            }
            _ if OTHERS.iter().any(|begin| name.starts_with(begin)) => {
                self.draft.skip(&format!("cards of {name}"), 1);
            }
            _ if JOINTS.contains(&name) => *self.joints.entry(name.to_owned()).or_default() += 1,
            _ => {}
        }
        Ok(())
    }

    fn element(&mut self, card: &Card, shape: Shape, full: usize) -> Result<(), Fault> {
        card.check()?;
        let number = card.number(0, "an element's number")?;
        let property = card.optional(1, "a property's number")?.unwrap_or(number);
        let mut corners = [0; 8];
        let corners = &mut corners[..shape.nodes()];
        for (k, corner) in corners.iter_mut().enumerate() {
            *corner = card.number(2 + k, "the node at a corner")?;
        }
        let middles = (shape.nodes()..full).any(|k| !card.field(2 + k).is_empty());
        if card.count() > 2 + full {
            return Err(
                card.fault(format!("element {number} has more than {full} nodes; write the card again"))
            );
        }
        self.draft.push_numbered(number, shape, corners).map_err(|problem| card.fault(problem))?;
        self.draft.reduce(if middles { full } else { shape.nodes() }, shape);
        self.properties.push(property);
        Ok(())
    }

    fn assemble(self) -> Result<Draft, Fault> {
        let Model { mut draft, node_systems, systems, default_system, properties, names, joints } = self;
        let frames = systems.frames()?;
        for ((x, system), number) in draft.mesh.nodes.iter_mut().zip(node_systems).zip(&draft.mesh.node_ids) {
            let system = system.or(default_system).unwrap_or(0);
            if system != 0 {
                let of = |problem| Fault::whole(format!("node {number}: {problem}"));
                *x = frames.place(system, *x).map_err(of)?;
            }
        }
        draft.connect()?;
        draft.group_by_number(&properties, &names.into_properties(), "property");
        draft.notes.extend(joints.into_iter().map(|(what, count)| Note::NotTaken { what, count }));
        Ok(draft)
    }
}

impl Card {
    /// Field `k`, counted from 0 behind the name, as a whole number.
    fn number(&self, k: usize, what: &str) -> Result<u64, Fault> {
        whole(self.field(k)).ok_or_else(|| self.misplaced(k, what))
    }

    /// The same, none if it is blank.
    fn optional(&self, k: usize, what: &str) -> Result<Option<u64>, Fault> {
        if self.field(k).is_empty() { Ok(None) } else { self.number(k, what).map(Some) }
    }

    /// Field `k` as a real number, 0 if it is blank.
    fn real(&self, k: usize, what: &str) -> Result<f64, Fault> {
        match self.field(k) {
            [] => Ok(0.0),
            field => fortran_real(field).ok_or_else(|| self.misplaced(k, what)),
        }
    }

    fn misplaced(&self, k: usize, what: &str) -> Fault {
        self.fault(format!("`{}` stands where {what} should ({})", shown(self.field(k)), self.name()))
    }
}

#[cfg(test)]
mod tests;
