//! From lines to parts and instances.

use std::collections::BTreeMap;

use super::deck::{Deck, Label, LineKind};
use super::entries::{members, surface_entry};
use super::kinds::{Kind, kind};
use super::part::{Instance, Part, set};
use crate::assembly::Draft;
use crate::fault::Fault;
use crate::note::Note;

/// What the file holds.
#[derive(Default)]
pub(super) struct Model {
    /// What stands outside of parts: the whole model in a file without an assembly.
    pub root: Part,
    pub parts: Vec<Part>,
    /// What stands in the assembly but in no instance.
    pub assembly: Part,
    pub instances: Vec<Instance>,
    /// Counts of reduced and skipped elements.
    pub draft: Draft,
    /// Keywords with a meaning for the model that were not taken over.
    not_taken: BTreeMap<String, usize>,
    place: Place,
    pub(super) section: Section,
    /// Numbers of the element that is not complete yet.
    pub(super) pending: Vec<u64>,
}

/// Where lines belong.
#[derive(Clone, Copy, Default, PartialEq)]
enum Place {
    #[default]
    Root,
    Part,
    Assembly,
    Instance,
}

/// What data lines mean.
#[derive(Default)]
pub(super) enum Section {
    #[default]
    Passed,
    Nodes {
        set: Option<Label>,
    },
    Elements {
        name: String,
        kind: Kind,
        set: Option<Label>,
    },
    Set {
        of_nodes: bool,
        label: Label,
        internal: bool,
        instance: Option<String>,
        generate: bool,
    },
    Surface {
        label: Label,
        internal: bool,
    },
    Placement,
}

/// Keywords that make nodes or elements.
const GENERATORS: [&str; 9] = [
    "NGEN",
    "NFILL",
    "NCOPY",
    "NMAP",
    "ELGEN",
    "ELCOPY",
    "SYSTEM",
    "SYMMETRIC MODEL GENERATION",
    "PARAMETER",
];
/// Keywords that join parts, which a mesh cannot say.
const JOINTS: [&str; 7] =
    ["TIE", "MPC", "EQUATION", "EMBEDDED ELEMENT", "COUPLING", "SHELL TO SOLID COUPLING", "CONTACT PAIR"];

impl Model {
    /// Reads all lines.
    pub(super) fn read(deck: &mut Deck) -> Result<Self, Fault> {
        let mut model = Model::default();
        while let Some(line) = deck.advance()? {
            match line {
                LineKind::Keyword => {
                    model.complete(deck)?;
                    model.section = model.keyword(deck)?;
                }
                LineKind::Data => model.data(deck)?,
            }
        }
        model.complete(deck)?;
        let not_taken = std::mem::take(&mut model.not_taken);
        model.draft.notes.extend(not_taken.into_iter().map(|(what, count)| Note::NotTaken { what, count }));
        Ok(model)
    }

    /// The part that lines belong to.
    pub(super) fn part(&mut self) -> &mut Part {
        match self.place {
            Place::Part => self.parts.last_mut().unwrap_or(&mut self.root),
            Place::Instance => self.instances.last_mut().map_or(&mut self.root, |i| &mut i.own),
            Place::Assembly => &mut self.assembly,
            Place::Root => &mut self.root,
        }
    }

    fn keyword(&mut self, deck: &Deck) -> Result<Section, Fault> {
        let keyword = &deck.keyword;
        let needs = |name: &str| {
            let label = keyword.label(name).filter(|l| !l.key.is_empty());
            label.ok_or_else(|| {
                deck.fault(format!("*{} needs the parameter {name}; add {name}=…", keyword.name))
            })
        };
        let section = match keyword.name.as_str() {
            "PART" => {
                self.place = Place::Part;
                self.parts.push(Part { key: needs("NAME")?.key, ..Part::default() });
                Section::Passed
            }
            "ASSEMBLY" | "END INSTANCE" => {
                self.place = Place::Assembly;
                Section::Passed
            }
            "END PART" | "END ASSEMBLY" => {
                self.place = Place::Root;
                Section::Passed
            }
            "INSTANCE" => {
                if keyword.has("INSTANCE") || keyword.has("LIBRARY") {
                    return Err(
                        deck.fault("instances of earlier results cannot be read; write the mesh itself")
                    );
                }
                if self.place == Place::Instance {
                    return Err(deck.fault("an instance in an instance; close the first with *END INSTANCE"));
                }
                self.place = Place::Instance;
                let (label, part, line) = (needs("NAME")?, needs("PART")?.key, deck.line_number());
                self.instances.push(Instance { label, part, line, ..Instance::default() });
                Section::Placement
            }
            "NODE" => {
                if let Some(system) = keyword.get("SYSTEM").filter(|s| !s.eq_ignore_ascii_case("R")) {
                    return Err(deck.fault(format!(
                        "nodes in the system {system} cannot be read; write them in rectangular coordinates"
                    )));
                }
                Section::Nodes { set: keyword.label("NSET") }
            }
            "ELEMENT" => {
                let name = needs("TYPE")?.key;
                let kind = kind(&name);
                if kind == Kind::Unknown {
                    return Err(deck.fault(format!(
                        "elements of type {name} are not supported; use C3D8, C3D6, C3D5, C3D4 or their kin of second \
                         order"
                    )));
                }
                Section::Elements { name, kind, set: keyword.label("ELSET") }
            }
            "NSET" | "ELSET" => {
                let of_nodes = keyword.name == "NSET";
                let section = Section::Set {
                    of_nodes,
                    label: needs(&keyword.name)?,
                    internal: keyword.has("INTERNAL"),
                    instance: keyword.label("INSTANCE").map(|l| l.key),
                    generate: keyword.has("GENERATE"),
                };
                // NSET, ELSET=… : the nodes of elements.
                if of_nodes && keyword.has("ELSET") { Section::Passed } else { section }
            }
            "SURFACE" => {
                let of_elements = keyword.get("TYPE").is_none_or(|t| t.eq_ignore_ascii_case("ELEMENT"));
                if of_elements && !keyword.has("COMBINE") && !keyword.has("CROP") {
                    Section::Surface { label: needs("NAME")?, internal: keyword.has("INTERNAL") }
                } else {
                    *self.not_taken.entry("surfaces not made of element faces".to_owned()).or_default() += 1;
                    Section::Passed
                }
            }
            name if GENERATORS.contains(&name) => {
                return Err(deck.fault(format!(
                    "*{name} cannot be read: nodes and elements must be written out; open the file in Abaqus/CAE or a \
                     mesher and write it again"
                )));
            }
            name => {
                if JOINTS.contains(&name) {
                    *self.not_taken.entry(format!("*{name}")).or_default() += 1;
                }
                Section::Passed
            }
        };
        Ok(section)
    }

    fn data(&mut self, deck: &Deck) -> Result<(), Fault> {
        let section = std::mem::take(&mut self.section);
        let result = match &section {
            Section::Passed => Ok(()),
            Section::Nodes { set } => self.node(deck, set.as_ref()),
            Section::Elements { name, kind, set } => self.element(deck, name, kind, set.as_ref()),
            Section::Set { of_nodes, label, internal, instance, generate } => {
                let part = self.part();
                let sets = if *of_nodes { &mut part.nsets } else { &mut part.elsets };
                members(deck, set(sets, label.clone(), *internal), instance.as_deref(), *generate)
            }
            Section::Surface { label, internal } => {
                surface_entry(deck, set(&mut self.part().surfaces, label.clone(), *internal))
            }
            Section::Placement => self.placement(deck),
        };
        self.section = section;
        result
    }

    fn placement(&mut self, deck: &Deck) -> Result<(), Fault> {
        let Some(instance) = self.instances.last_mut() else { return Ok(()) };
        let wanted = if instance.placement.is_empty() { 3 } else { 7 };
        let mut numbers = Vec::new();
        for field in deck.fields() {
            numbers.push(deck.real(field, "a number of the instance's position")?);
        }
        if numbers.len() > wanted || instance.placement.len() >= 10 || (wanted == 7 && numbers.len() != 7) {
            let problem = "an instance is placed by three numbers and, in a second line, seven";
            return Err(deck.fault(problem));
        }
        // Numbers left out at the end are 0.
        numbers.resize(wanted, 0.0);
        instance.placement.extend(numbers);
        Ok(())
    }

    fn node(&mut self, deck: &Deck, group: Option<&Label>) -> Result<(), Fault> {
        let mut fields = deck.fields();
        let number = deck.number(fields.next().unwrap_or_default(), "a node's number")?;
        let mut x = [0.0; 3];
        for (x, field) in x.iter_mut().zip(fields) {
            *x = deck.real(field, "a coordinate")?;
        }
        let part = self.part();
        part.node_numbers.push(number);
        part.nodes.push(x);
        if let Some(label) = group {
            set(&mut part.nsets, label.clone(), false).push(None, number, deck.line_number());
        }
        Ok(())
    }
}
