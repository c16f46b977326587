//! Cards of input files: lines, with those of included files, and fields between commas or in columns.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use crate::content;
use crate::fault::Fault;
use crate::input::{Input, shown, whole};

/// Files open at a time; more is a mistake.
const DEEPEST: usize = 20;

/// A line of a file.
#[derive(Clone, Default)]
pub(crate) struct Place {
    /// None if it is the file that was asked for.
    file: Option<Rc<Path>>,
    line: usize,
}

impl Place {
    /// A fault there.
    pub(crate) fn fault(&self, problem: impl Into<String>) -> Fault {
        Fault { file: self.file.as_deref().map(Path::to_owned), ..Fault::at(self.line, problem) }
    }
}

struct Included {
    path: Rc<Path>,
    /// Without links, to know a file that includes itself.
    real: PathBuf,
    input: Input<'static>,
}

/// The lines of a file and of those that it includes.
pub(crate) struct Deck<'i, 'a> {
    root: &'i mut Input<'a>,
    path: Rc<Path>,
    included: Vec<Included>,
    line: Vec<u8>,
}

impl<'i, 'a> Deck<'i, 'a> {
    pub(crate) fn new(root: &'i mut Input<'a>, path: &Path) -> Self {
        Deck { root, path: path.into(), included: Vec::new(), line: Vec::new() }
    }

    /// Goes to the next line, blank or not; behind an included file to the line after the one that names it. False at the
    /// end.
    pub(crate) fn advance(&mut self) -> Result<bool, Fault> {
        loop {
            let more = match self.included.last_mut() {
                Some(file) => next_line(&mut file.input, &mut self.line),
                None => next_line(self.root, &mut self.line),
            };
            if more.map_err(|fault| self.placed(fault))? {
                return Ok(true);
            }
            if !self.leave() {
                return Ok(false);
            }
        }
    }

    /// The current line from its first column, without blanks at its end.
    pub(crate) fn line(&self) -> &[u8] {
        &self.line
    }

    /// How many included files the current line is inside of.
    pub(crate) fn depth(&self) -> usize {
        self.included.len()
    }

    /// Leaves the current file; false if it is the first.
    pub(crate) fn leave(&mut self) -> bool {
        self.included.pop().is_some()
    }

    /// Goes on in a file, whose name is relative to the file that names it.
    pub(crate) fn include(&mut self, name: &str) -> Result<(), Fault> {
        let from = self.included.last().map_or(&self.path, |file| &file.path);
        let folder = from.parent().unwrap_or(Path::new(""));
        let mut path = folder.join(name);
        if !path.exists() {
            // On Windows a backslash separates folders.
            path = folder.join(name.replace('\\', "/"));
        }
        let absent = |e: std::io::Error| {
            self.fault(format!(
                "the included file {} cannot be opened ({e}); put it beside this file, or remove the line",
                path.display()
            ))
        };
        let real = path.canonicalize().map_err(absent)?;
        let root = self.path.canonicalize().ok();
        if self.included.iter().any(|file| file.real == real) || root.as_ref() == Some(&real) {
            return Err(self.fault(format!("{} includes itself; remove the line", path.display())));
        }
        if self.included.len() >= DEEPEST {
            return Err(
                self.fault(format!("more than {DEEPEST} files include one another; put them into fewer"))
            );
        }
        let file = File::open(&path).map_err(absent)?;
        let input = content::open(file, self.root.encoding)
            .map_err(|fault| Fault { file: Some(path.clone()), ..fault })?;
        self.root.assumed = self.root.assumed.or(input.assumed);
        self.included.push(Included { path: path.into(), real, input });
        Ok(())
    }

    /// A field as a whole number.
    pub(crate) fn number(&self, field: &[u8], what: &str) -> Result<u64, Fault> {
        whole(field).ok_or_else(|| self.misplaced(field, what))
    }

    pub(crate) fn misplaced(&self, field: &[u8], what: &str) -> Fault {
        self.fault(format!("`{}` stands where {what} should", shown(field)))
    }

    /// Number of the current line, in whichever file it is.
    pub(crate) fn line_number(&self) -> usize {
        self.included.last().map_or(self.root.line(), |file| file.input.line())
    }

    /// The current line.
    pub(crate) fn place(&self) -> Place {
        let file = self.included.last().map(|file| file.path.clone());
        Place { file, line: self.line_number() }
    }

    /// A fault in the current line.
    pub(crate) fn fault(&self, problem: impl Into<String>) -> Fault {
        self.place().fault(problem)
    }

    fn placed(&self, fault: Fault) -> Fault {
        Fault { file: self.place().file.as_deref().map(Path::to_owned), ..fault }
    }
}

/// Copies the next line; false at the end.
fn next_line(input: &mut Input, line: &mut Vec<u8>) -> Result<bool, Fault> {
    let more = input.next_line();
    line.clear();
    line.extend_from_slice(input.whole_line());
    more
}

/// The fields of a line, without blanks.
pub(crate) struct Fields<'l> {
    rest: Option<&'l [u8]>,
    /// None between commas.
    widths: Option<std::slice::Iter<'static, usize>>,
}

/// The fields between the commas of a line, or in columns of these widths if it has none.
pub(crate) fn fields<'l>(line: &'l [u8], widths: &'static [usize]) -> Fields<'l> {
    let free = widths.is_empty() || line.contains(&b',');
    Fields { rest: Some(line), widths: (!free).then(|| widths.iter()) }
}

impl<'l> Iterator for Fields<'l> {
    type Item = &'l [u8];

    fn next(&mut self) -> Option<&'l [u8]> {
        let rest = self.rest?;
        let end = match &mut self.widths {
            None => rest.iter().position(|&b| b == b',').unwrap_or(rest.len()),
            Some(_) if rest.is_empty() => return None,
            Some(widths) => (*widths.next()?).min(rest.len()),
        };
        let comma = usize::from(self.widths.is_none());
        self.rest = rest.get(end + comma..);
        Some(rest[..end].trim_ascii())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(line: &str, widths: &'static [usize]) -> Vec<String> {
        fields(line.as_bytes(), widths).map(|f| String::from_utf8(f.to_vec()).unwrap()).collect()
    }

    #[test]
    fn fields_stand_between_commas_or_in_columns() {
        assert_eq!(all("1, a b ,,2", &[]), ["1", "a b", "", "2"]);
        assert_eq!(all("1,2,", &[3, 3]), ["1", "2", ""]);
        assert_eq!(all("", &[]), [""]);
        assert_eq!(all("  1 23  4567", &[3, 3, 4, 5]), ["1", "23", "45", "67"]);
        assert_eq!(all("  1 2", &[3, 3, 4]), ["1", "2"]);
        assert_eq!(all("  1 2345", &[3, 3]), ["1", "23"]);
        assert_eq!(all("", &[3]), Vec::<String>::new());
    }
}
