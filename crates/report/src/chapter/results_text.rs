//! Texts of the result files, in the page's language.

use minijinja::Value;
use tremolite_results::Said;

use crate::drawing::svg::escape;
use crate::language::{Language, say};

/// A text as HTML, from its pattern. Where the page's language lacks that, as of a program's own observers or in files that
/// know of no patterns, the English text stands there and says that it is English.
pub fn told(language: Language, said: &Said, english: &str) -> Value {
    if language == Language::English || english.is_empty() {
        return Value::from_safe_string(escape(english));
    }
    match !said.is_empty() && language.knows(said) {
        true => Value::from_safe_string(escape(&language.tell(said))),
        false => in_english(english),
    }
}

/// As [`told`], of a text without slots that has no pattern beside it: what a law or a parameter is.
pub fn known(language: Language, english: &str) -> Value {
    told(language, &Said::plain(english), english)
}

/// A text that stands in English whatever the page's language.
pub fn in_english(english: &str) -> Value {
    Value::from_safe_string(format!("<span lang=\"en\">{}</span>", escape(english)))
}

/// The kind of motion that a case gives.
pub fn kind_of_motion(language: Language, kind: &str) -> String {
    match kind {
        "outcrop" => say!(language, "outcrop"),
        "incident" => say!(language, "incident"),
        "within" => say!(language, "within"),
        "surface" => say!(language, "surface record"),
        other => other.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tremolite_results::said;

    #[test]
    fn what_the_language_lacks_stands_in_english_and_says_so() {
        let (known, own) = (said!("undamaged"), Said::plain("a <b> of its own"));
        let text = |language, said: &Said| told(language, said, &said.to_string()).to_string();
        assert_eq!(text(Language::English, &own), "a &lt;b&gt; of its own");
        assert_eq!(text(Language::Chinese, &own), "<span lang=\"en\">a &lt;b&gt; of its own</span>");
        let chinese = text(Language::Chinese, &known);
        assert!(chinese != "undamaged" && !chinese.contains("lang"), "{chinese}");
        let part = said!("{first}, {rest}", first = known.clone(), rest = own);
        assert!(text(Language::Chinese, &part).starts_with("<span lang=\"en\">undamaged, a"));
        let old = told(Language::Chinese, &Said::default(), "of another version").to_string();
        assert!(old.contains("lang=\"en\""), "{old}");
    }
}
