//! Bad inputs, each a change to a sound one, with the file, the line, the message and the way out that must come of it.

mod case;
mod files;
mod law;
mod record;
mod study;

use std::path::Path;
use tremolite::job::{Given, Job};

/// A change to a sound input and what must come of it.
pub struct Row {
    from: &'static str,
    to: &'static str,
    /// Where the problem is told.
    line: usize,
    says: &'static str,
    remedy: &'static str,
}

pub const fn row(
    from: &'static str,
    to: &'static str,
    line: usize,
    says: &'static str,
    remedy: &'static str,
) -> Row {
    Row { from, to, line, says, remedy }
}

impl Row {
    fn changed(&self, sound: &str) -> String {
        assert!(sound.contains(self.from), "{:?} is not in the sound input", self.from);
        sound.replacen(self.from, self.to, 1)
    }

    /// Whether a report has this problem: its message, its place in `file` and its remedy in one paragraph. Nothing but the line itself is
    /// shown of the input, so that neither a terminal nor a log takes it for a command.
    fn found(&self, file: &str, shown: &str) -> Result<(), String> {
        let place = format!("{file}:{}:", self.line);
        let of = |part: &str| {
            let (said, rest) = part.split_once('\n').unwrap_or((part, ""));
            said.starts_with("error")
                && said.contains(self.says)
                && rest.contains(&place)
                && rest.contains(self.remedy)
        };
        if shown.contains(|c: char| c.is_control() && c != '\n') {
            return Err(format!("{:?} to {:?}: control characters are shown\n{shown:?}", self.from, self.to));
        }
        match shown.split("\n\n").any(of) {
            true => Ok(()),
            false => Err(format!(
                "{:?} to {:?}: expected {place} {} / {}\n{shown}",
                self.from, self.to, self.says, self.remedy
            )),
        }
    }
}

/// Fails with all rows that came out otherwise.
fn all(rows: usize, wrong: Vec<String>) {
    assert!(wrong.is_empty(), "{} of {rows}:\n\n{}", wrong.len(), wrong.join("\n\n"));
}

const DATA: [(&str, &str); 3] = [
    ("case.toml", include_str!("../../data/bad_input/case.toml")),
    ("hall.msh", include_str!("../../data/bad_input/hall.msh")),
    ("pulse.txt", include_str!("../../data/bad_input/pulse.txt")),
];

/// What a case says whose file, or one beside it, was changed.
fn refusals(file: &str, rows: &[Row]) {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    DATA.iter().for_each(|(name, text)| write(name, text));
    let prefix = format!("{}/", folder.path().display());
    let read = || Job::read(&folder.path().join("case.toml"), &Given::default());
    if let Err(fault) = read() {
        panic!("the sound case is refused: {fault}");
    }
    let sound = DATA.iter().find(|(name, _)| *name == file).unwrap().1;
    let told = |row: &Row| {
        write(file, &row.changed(sound));
        match read() {
            Ok(_) => Err(format!("{:?} to {:?} is accepted", row.from, row.to)),
            Err(fault) => row.found("case.toml", &fault.to_string().replace(&prefix, "")),
        }
    };
    all(rows.len(), rows.iter().filter_map(|row| told(row).err()).collect());
}

/// The same of a file alone, by what reads it.
fn refusals_of(file: &str, sound: &str, rows: &[Row], read: fn(&Path, &str) -> Result<(), String>) {
    if let Err(shown) = read(Path::new(file), sound) {
        panic!("the sound file is refused: {shown}");
    }
    let told = |row: &Row| match read(Path::new(file), &row.changed(sound)) {
        Ok(()) => Err(format!("{:?} to {:?} is accepted", row.from, row.to)),
        Err(shown) => row.found(file, &shown),
    };
    all(rows.len(), rows.iter().filter_map(|row| told(row).err()).collect());
}
