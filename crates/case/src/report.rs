//! Problems of a case, shown at their place in the file.

use std::ops::Range;
use std::path::PathBuf;

use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};

use crate::{Spanned, key_path, keyed};

/// One thing that is wrong, where it stands, and the way out.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// Bytes of the source text to underline.
    pub span: Range<usize>,
    /// The path of the key or table that it is about, as a [`Change`](crate::Change) takes it: `material.rock.young`,
    /// `stage[1].release`. Found by the span ([`Case::keyed`](crate::Case::keyed)); empty where it is about the whole file.
    pub key: String,
    /// The change that it comes from and not the file; the span is then where the file would have it.
    pub set: Option<Box<str>>,
    /// What is wrong.
    pub message: String,
    /// What to do about it.
    pub remedy: String,
    /// The key of the table there that is missing.
    missing: Option<&'static str>,
}

impl Diagnostic {
    pub fn new(span: Range<usize>, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        let (message, remedy) = (message.into(), remedy.into());
        Diagnostic { span, key: String::new(), set: None, message, remedy, missing: None }
    }

    /// The same about a key that the table at its place does not have.
    pub(crate) fn missing(self, key: &'static str) -> Self {
        Diagnostic { missing: Some(key), ..self }
    }

    /// A problem with a value of the case.
    pub fn at<T>(value: &Spanned<T>, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Diagnostic::new(value.span.clone(), message, remedy)
    }
}

/// Gives the problems in a text the paths of their keys, but for those that have one.
pub(crate) fn find_keys(source: &str, problems: &mut [Diagnostic]) {
    if problems.iter().all(|problem| !problem.key.is_empty()) {
        return;
    }
    let places: Vec<Range<usize>> = problems.iter().map(|problem| problem.span.clone()).collect();
    for (problem, path) in problems.iter_mut().zip(keyed::paths(source, &places)) {
        if problem.key.is_empty() {
            problem.key = match problem.missing {
                Some(key) => key_path::below(&path, key),
                None => path,
            };
        }
    }
}

/// Problems printed at most; whoever has more starts with these.
const SHOWN: usize = 40;

/// Whether the problems forbid the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// Nothing is computed.
    Error,
    /// The run goes on.
    Warning,
}

/// All problems found in one case file, in the order of the file.
///
/// `Display` and [`Report::render`] print each with `file:line:column`, the line itself, the place underlined, and
/// the remedy; one that comes from a change with the change in place of the line.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// The file as the user named it.
    pub file: PathBuf,
    /// Its text; empty if it could not be read.
    pub source: String,
    /// Of all of them.
    pub severity: Severity,
    /// Sorted by their place.
    pub problems: Vec<Diagnostic>,
}

impl Report {
    /// A report of errors; sorts the problems by their place and finds their keys.
    pub fn new(file: impl Into<PathBuf>, source: impl Into<String>, mut problems: Vec<Diagnostic>) -> Self {
        let source = source.into();
        problems.sort_by_key(|p| p.span.start);
        find_keys(&source, &mut problems);
        Report { file: file.into(), source, severity: Severity::Error, problems }
    }

    /// The same as warnings.
    pub fn as_warnings(mut self) -> Self {
        self.severity = Severity::Warning;
        self
    }

    /// Line and column of a problem, both from 1; the column counts characters.
    pub fn position(&self, problem: &Diagnostic) -> (usize, usize) {
        let before = &self.source[..self.clamp(&problem.span).start];
        let line_start = before.rfind('\n').map_or(0, |i| i + 1);
        (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
    }

    /// The text for the terminal; with ANSI colours only if asked.
    pub fn render(&self, colour: bool) -> String {
        let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
        let mut text = String::new();
        for problem in self.problems.iter().take(SHOWN) {
            text.push_str(&self.render_one(&renderer, problem));
            text.push_str("\n\n");
        }
        let what = match self.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        };
        let plural = if self.problems.len() == 1 { "" } else { "s" };
        let more =
            if self.problems.len() > SHOWN { format!(", the first {SHOWN} shown") } else { String::new() };
        text + &format!("{}: {} {what}{plural}{more}", self.file.display(), self.problems.len())
    }

    fn render_one(&self, renderer: &Renderer, problem: &Diagnostic) -> String {
        let level = match self.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        let file = self.file.display().to_string();
        let mut group = Group::with_title(level.primary_title(problem.message.as_str()));
        if let Some(set) = &problem.set {
            group = group.element(Origin::path(&**set));
        } else if !self.source.is_empty() {
            let mark = AnnotationKind::Primary.span(self.clamp(&problem.span));
            group = group.element(Snippet::source(self.source.as_str()).path(file.as_str()).annotation(mark));
        }
        // Titles and sources are made printable by the renderer, but not these; and what is written is told in them.
        let printable = |c: char| if c.is_control() && c != '\n' { '\u{fffd}' } else { c };
        let remedy: String = problem.remedy.chars().map(printable).collect();
        let remedy = Group::with_title(Level::HELP.secondary_title(remedy));
        // It leaves what 8-bit terminals take for the beginning of a command.
        renderer.render(&[group, remedy]).replace(|c| ('\u{80}'..='\u{9f}').contains(&c), "\u{fffd}")
    }

    /// The span cut to the text, to whole characters and to one line, so that any span can be shown.
    fn clamp(&self, span: &Range<usize>) -> Range<usize> {
        let mut start = span.start.min(self.source.len());
        while !self.source.is_char_boundary(start) {
            start -= 1;
        }
        let line_end = self.source[start..].find(['\n', '\r']).map_or(self.source.len(), |i| start + i);
        let mut end = span.end.clamp(start, line_end);
        while !self.source.is_char_boundary(end) {
            end += 1;
        }
        start..end
    }
}

impl std::fmt::Display for Report {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.render(false))
    }
}

impl std::error::Error for Report {}
