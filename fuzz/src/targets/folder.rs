//! A result folder in which one file is what the bytes say: its name in the first line, then its content. A page is made of whatever is there,
//! and holds nothing that a browser would run.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use tremolite_results::ResultFolder;

/// The files of a sound folder.
macro_rules! sound {
    ($($name:literal),* $(,)?) => { &[$(($name, include_bytes!(concat!("../../folder/", $name)))),*] };
}
const SOUND: &[(&str, &[u8])] = sound![
    "SHA256SUMS",
    "bolts.csv",
    "bolts.pvd",
    "bolts/000000.vtu",
    "case.toml",
    "damage.columns.json",
    "damage.csv",
    "depth.csv",
    "energy.csv",
    "fields.pvd",
    "fields/000000.vtu",
    "fields/000001.vtu",
    "free_field.columns.json",
    "free_field.csv",
    "interfaces.columns.json",
    "interfaces.csv",
    "interfaces.pvd",
    "interfaces/000001.vtu",
    "monitors.columns.json",
    "monitors.csv",
    "motion.csv",
    "relaxation.csv",
    "sections.csv",
    "spectra.columns.json",
    "spectra.csv",
    "stages.columns.json",
    "stages.csv",
    "stages.pvd",
    "summary.json",
];

fn write(root: &Path, name: &str, content: &[u8]) {
    let path = root.join(name);
    fs::create_dir_all(path.parent().unwrap_or(root)).expect("a folder in memory");
    fs::write(path, content).expect("a file in memory");
}

/// A folder of this process, made once and left as it was after each input.
fn folder() -> &'static PathBuf {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let parent = tempfile::Builder::new().prefix("tremolite-folder-").tempdir().expect("a folder").keep();
        SOUND.iter().for_each(|(name, content)| write(&parent, name, content));
        parent
    })
}

/// An input for each file: as the run wrote it.
pub fn inputs() -> impl Iterator<Item = Vec<u8>> {
    SOUND.iter().map(|(name, content)| [name.as_bytes(), b"\n", content].concat())
}

pub fn results(bytes: &[u8]) -> bool {
    let mut parts = bytes.splitn(2, |&b| b == b'\n');
    let (name, content) = (parts.next().unwrap_or_default(), parts.next().unwrap_or_default());
    let Some((name, before)) = SOUND.iter().find(|(known, _)| known.as_bytes() == name) else {
        return false;
    };
    let root = folder();
    write(root, name, content);
    if let Ok(page) = tremolite_report::write(root) {
        let page = fs::read_to_string(page).expect("a page is text");
        assert!(!page.contains("<script>alert"), "the page holds a script of its input");
    }
    // Which files are not what the run wrote.
    if let Ok(folder) = ResultFolder::open_existing(root) {
        let _ = folder.damaged();
    }
    write(root, name, before);
    true
}
