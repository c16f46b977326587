//! What a case names and a program holds in memory.

use indexmap::IndexMap;
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};
use tremolite_case::{self as case, BoltPlace, Case, Spanned};
use tremolite_mesh::Mesh;
use tremolite_motion::Channel;

const MESHES: &str = "meshes";
const RECORDS: &str = "records";
const BOLTS: &str = "bolts";

/// Meshes, records and bolts in memory, each under the name that the case has where it would name a file. What is not here is read
/// from the file.
#[derive(Clone, Debug, Default)]
pub struct Inputs {
    /// For `mesh.file.path`, as a file would hold them: `mesh.file.unit` and `rotate` apply to them.
    pub meshes: IndexMap<String, Mesh>,
    /// For `motion.file`, by the orientation of each channel, or for `file` of a component: samples in m/s² as a file would hold
    /// them, before `motion.processing`. What the case says of how a file is written (`units`, `columns`, `sensitivity`) has no
    /// meaning for them; a `dt` must agree.
    pub records: IndexMap<String, Vec<Channel>>,
    /// For `file` of bolts: head and other end \[m\].
    pub bolts: IndexMap<String, Vec<[[f64; 3]; 2]>>,
    /// Groups of elements beside those of the mesh, by which a case may call them: numbers from 0, ascending.
    pub groups: IndexMap<String, Vec<u32>>,
}

impl Inputs {
    /// Puts its groups into a mesh.
    ///
    /// # Errors
    /// In words: where the mesh has one of that name, or no such element.
    pub(super) fn add_groups(&self, mesh: &mut Mesh) -> Result<(), String> {
        let count = mesh.elements.len();
        for (name, elements) in &self.groups {
            if mesh.groups.contains_key(name) {
                return Err(format!(
                    "the mesh has a group \"{name}\" already, which is given in memory as well"
                ));
            }
            if let Some(e) = elements.iter().find(|&&e| e as usize >= count) {
                return Err(format!(
                    "the group \"{name}\" in memory has the element {e}, where the mesh has {count}"
                ));
            }
            mesh.groups.insert(name.clone(), elements.clone());
        }
        Ok(())
    }

    pub(super) fn mesh(&self, file: &Path) -> Option<&Mesh> {
        self.meshes.get(&*file.to_string_lossy())
    }

    pub(super) fn record(&self, file: &Path) -> Option<&[Channel]> {
        Some(self.records.get(&*file.to_string_lossy())?)
    }

    pub(super) fn bolts(&self, file: &Path) -> Option<&[[[f64; 3]; 2]]> {
        Some(self.bolts.get(&*file.to_string_lossy())?)
    }

    /// Whether something in memory has the name by which the case calls a file.
    pub fn has(&self, file: &Path) -> bool {
        self.names().any(|(_, name)| name == file.to_string_lossy())
    }

    /// The kind and the name of what no key of the case asks for: slips of the pen, for else a file may be read in its place.
    pub fn not_named(&self, case: &Case) -> Vec<(&'static str, &str)> {
        let mesh = match &case.mesh {
            case::Mesh::File(file) => Some(&file.path),
            _ => None,
        };
        let bolts = case.bolts().filter_map(|(_, bolts)| match &bolts.place {
            BoltPlace::File(file) => Some(file),
            _ => None,
        });
        let others: Vec<&Spanned<PathBuf>> = mesh.into_iter().chain(bolts).collect();
        let kind = |file: &Spanned<PathBuf>| match others.iter().position(|other| other.span == file.span) {
            None => RECORDS,
            Some(0) if mesh.is_some() => MESHES,
            Some(_) => BOLTS,
        };
        let asked: Vec<_> =
            case.files().into_iter().map(|file| (kind(file), file.value.to_string_lossy())).collect();
        self.names().filter(|of| asked.iter().all(|(kind, name)| (*kind, &**name) != *of)).collect()
    }

    /// All names, each with its kind.
    fn names(&self) -> impl Iterator<Item = (&'static str, &str)> {
        let meshes = self.meshes.keys().map(|name| (MESHES, name.as_str()));
        let records = self.records.keys().map(|name| (RECORDS, name.as_str()));
        let bolts = self.bolts.keys().map(|name| (BOLTS, name.as_str()));
        meshes.chain(records).chain(bolts)
    }

    /// The contents of all that has a name: numbers by their bytes, low end first, texts and lists behind their length.
    pub(super) fn contents(&self, file: &Path) -> Option<Sha256> {
        let mut contents = Contents(Sha256::new());
        if let Some(mesh) = self.mesh(file) {
            contents.mesh(mesh);
        }
        for channel in self.record(file).unwrap_or_default() {
            contents.channel(channel);
        }
        contents.numbers(self.bolts(file).unwrap_or_default().iter().flatten().flatten());
        self.has(file).then_some(contents.0)
    }
}

struct Contents(Sha256);

impl Contents {
    fn count(&mut self, n: u64) {
        self.0.update(n.to_le_bytes());
    }

    fn text(&mut self, text: &str) {
        self.count(text.len() as u64);
        self.0.update(text);
    }

    fn numbers<'x>(&mut self, numbers: impl IntoIterator<Item = &'x f64>) {
        numbers.into_iter().for_each(|x| self.0.update(x.to_bits().to_le_bytes()));
    }

    fn mesh(&mut self, mesh: &Mesh) {
        self.count(mesh.nodes.len() as u64);
        self.numbers(mesh.nodes.iter().flatten());
        self.count(mesh.elements.len() as u64);
        for element in &mesh.elements {
            self.text(element.shape.name());
            element.nodes().iter().for_each(|&n| self.count(n.into()));
        }
        for (name, list) in &mesh.groups {
            self.text(name);
            self.count(list.len() as u64);
            list.iter().for_each(|&e| self.count(e.into()));
        }
        for (name, list) in &mesh.faces {
            self.text(name);
            self.count(list.len() as u64);
            list.iter().for_each(|face| self.count(u64::from(face.element) << 8 | u64::from(face.side)));
        }
        for (name, point) in &mesh.points {
            self.text(name);
            self.numbers(point);
        }
        for numbers in [&mesh.node_ids, &mesh.element_ids] {
            self.count(numbers.len() as u64);
            numbers.iter().for_each(|&n| self.count(n));
        }
    }

    fn channel(&mut self, channel: &Channel) {
        self.text(&channel.name);
        self.text(&channel.orientation.map_or(String::new(), |o| o.to_string()));
        self.numbers([&channel.dt, &channel.start, &channel.clock.unwrap_or(f64::NAN)]);
        self.count(channel.acceleration.len() as u64);
        self.numbers(&channel.acceleration);
    }
}

/// What is wrong with something in memory, with its way out behind a semicolon as what is wrong with a file has it.
pub(super) fn in_memory(file: &Path, fault: &str) -> String {
    format!("{} in memory: {fault}", file.display())
}

/// The channels of a record in memory, where they are such as a reader hands out; `declared` is the interval \[s\] that the case
/// states.
///
/// # Errors
/// What is wrong, and what to do about it.
pub(super) fn checked(
    file: &Path,
    channels: &[Channel],
    declared: Option<f64>,
) -> Result<Vec<Channel>, (String, String)> {
    let fault = |what: String, remedy: &str| Err((in_memory(file, &what), remedy.to_owned()));
    if channels.is_empty() {
        return fault("there are no channels".into(), "give one and more");
    }
    for channel in channels {
        if let Err(e) = channel.sound() {
            let (what, remedy) = e.message_and_remedy();
            return fault(what, &remedy);
        }
        let Channel { name, dt, raw, .. } = channel;
        if *raw {
            return fault(format!("'{name}' is in counts"), "give samples in m/s2");
        }
        // A thousandth, as for what a file states.
        if let Some(declared) = declared.filter(|declared| (declared - dt).abs() > 1e-3 * dt) {
            return fault(
                format!("'{name}' has an interval of {dt} s, but dt = \"{declared} s\" was declared"),
                "remove the declaration, or correct whichever is wrong",
            );
        }
    }
    Ok(channels.to_vec())
}
