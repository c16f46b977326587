//! What all pages are set with.

use minijinja::syntax::SyntaxConfig;
use minijinja::{AutoEscape, Environment, Value};

use crate::drawing::svg::escape;
use crate::language::Language;

/// The style sheet of all pages.
pub const STYLE: &str = include_str!("../../template/report.css");

/// The script of all pages, built from `page/src` and checked in.
pub const SCRIPT: &str = include_str!("../../page/dist/page.js");

/// An environment for templates of pages in a language: everything is escaped but [`markup`]. It knows `t('English text')`
/// and the filter `dots`.
pub fn environment<'a>(language: Language) -> Result<Environment<'a>, minijinja::Error> {
    let mut environment = Environment::new();
    environment.set_auto_escape_callback(|_| AutoEscape::Html);
    environment.set_syntax(SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build()?);
    environment.add_filter("dots", dots);
    environment.add_function("t", move |english: &str| language.pattern(english).to_owned());
    Ok(environment)
}

/// What goes into a page as it is: drawings, which escape their own texts, and our own style and script.
pub fn markup(text: &str) -> Value {
    Value::from_safe_string(text.into())
}

/// A name of several parts, which may break behind its dots and nowhere else.
fn dots(name: String) -> Value {
    Value::from_safe_string(escape(&name).replace('.', ".<wbr>"))
}
