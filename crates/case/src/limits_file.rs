//! A file of limits of acceptance, under the keys of `[report.limits]`.

use std::path::Path;

use crate::case::CASE;
use crate::check::Checker;
use crate::laws::Laws;
use crate::page::{LIMITS, Limits};
use crate::{Report, syntax};

impl Limits {
    /// Reads and checks such a file: `displacement = "50 mm"`, each limit a line.
    ///
    /// # Errors
    /// All problems of the file at once.
    pub fn from_file(path: &Path) -> Result<Limits, Report> {
        Limits::parse(path, &syntax::read(path, "file of limits")?)
    }

    /// Checks the text of such a file; `path` names it in messages.
    ///
    /// # Errors
    /// As [`Limits::from_file`].
    pub fn parse(path: &Path, source: &str) -> Result<Limits, Report> {
        let report = |problems| Report::new(path, source, problems);
        let document = syntax::parse(source).map_err(report)?;
        let mut checker = Checker::new(&CASE, Laws { materials: &[], interfaces: &[] }, document.get_ref());
        let written = checker.table(&LIMITS, Some(&[]), document.get_ref(), document.span(), "");
        let Checker { problems, .. } = checker;
        if problems.is_empty() { Ok(Limits::read(&written)) } else { Err(report(problems)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_are_read_with_their_units_and_others_are_refused() {
        let read = |text: &str| Limits::parse(Path::new("limits.toml"), text);
        let limits =
            read("displacement = \"50 mm\"\nutilisation = 0.9\nrelative_displacement = \"20 mm\"\n").unwrap();
        assert_eq!(limits.relative_displacement, Some(0.02));
        assert_eq!((limits.displacement, limits.utilisation, limits.damage), (Some(0.05), Some(0.9), None));
        let refused = read("crack_with = \"1 mm\"\ndamage = 1.5\n").unwrap_err().to_string();
        assert!(refused.contains("crack_width") && refused.contains("limits.toml:2"), "{refused}");
    }
}
