//! Problems of a case, shown at their place in the file.

use std::ops::Range;
use std::path::PathBuf;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

use crate::Spanned;

/// One thing that is wrong, where it stands, and the way out.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// Bytes of the source text to underline.
    pub span: Range<usize>,
    /// What is wrong.
    pub message: String,
    /// What to do about it.
    pub remedy: String,
}

impl Problem {
    pub fn new(span: Range<usize>, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Problem { span, message: message.into(), remedy: remedy.into() }
    }

    /// A problem with a value of the case.
    pub fn at<T>(value: &Spanned<T>, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Problem::new(value.span.clone(), message, remedy)
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
/// the remedy.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// The file as the user named it.
    pub file: PathBuf,
    /// Its text; empty if it could not be read.
    pub source: String,
    /// Of all of them.
    pub severity: Severity,
    /// Sorted by their place.
    pub problems: Vec<Problem>,
}

impl Report {
    /// A report of errors; sorts the problems by their place.
    pub fn new(file: impl Into<PathBuf>, source: impl Into<String>, mut problems: Vec<Problem>) -> Self {
        problems.sort_by_key(|p| p.span.start);
        Report { file: file.into(), source: source.into(), severity: Severity::Error, problems }
    }

    /// The same as warnings.
    pub fn as_warnings(mut self) -> Self {
        self.severity = Severity::Warning;
        self
    }

    /// Line and column of a problem, both from 1; the column counts characters.
    pub fn position(&self, problem: &Problem) -> (usize, usize) {
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

    fn render_one(&self, renderer: &Renderer, problem: &Problem) -> String {
        let level = match self.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        let file = self.file.display().to_string();
        let mut group = Group::with_title(level.primary_title(problem.message.as_str()));
        if !self.source.is_empty() {
            let mark = AnnotationKind::Primary.span(self.clamp(&problem.span));
            group = group.element(Snippet::source(self.source.as_str()).path(file.as_str()).annotation(mark));
        }
        let remedy = Group::with_title(Level::HELP.secondary_title(problem.remedy.as_str()));
        renderer.render(&[group, remedy])
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
