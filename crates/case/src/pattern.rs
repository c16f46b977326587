//! Patterns of group names.

/// Whether a group's name fits a pattern in which each `*` stands for any text, also none: `*.lining` fits
/// `powerhouse.lining`. Capital letters count; nothing else in the pattern is special.
pub fn matches(pattern: &str, name: &str) -> bool {
    let Some((head, rest)) = pattern.split_once('*') else { return pattern == name };
    let Some(mut name) = name.strip_prefix(head) else { return false };
    let mut parts: Vec<&str> = rest.split('*').collect();
    // split yields at least one part
    let tail = parts.pop().unwrap_or_default();
    for part in parts {
        // The earliest fit leaves the most for the parts that follow.
        match name.find(part) {
            Some(at) => name = &name[at + part.len()..],
            None => return false,
        }
    }
    name.ends_with(tail)
}

#[cfg(test)]
mod tests {
    use super::matches;

    #[test]
    fn a_star_stands_for_any_text() {
        for (pattern, name) in [
            ("rock", "rock"),
            ("*", "anything"),
            ("*", ""),
            ("*.lining", "powerhouse.lining"),
            ("powerhouse.bench*", "powerhouse.bench"),
            ("powerhouse.bench*", "powerhouse.bench12"),
            ("a*b*c", "abc"),
            ("a*b*c", "a--b--b--c"),
            ("a*bc", "abcbc"),
            ("**", "x"),
        ] {
            assert!(matches(pattern, name), "{pattern} {name}");
        }
        for (pattern, name) in [
            ("rock", "rocks"),
            ("*.lining", "lining"),
            ("*.lining", "powerhouse.lining2"),
            ("*.bench*", "powerhouse.lining2"),
            ("ab*ba", "aba"),
            ("a*b*c", "acb"),
            ("Rock", "rock"),
            ("", "x"),
        ] {
            assert!(!matches(pattern, name), "{pattern} {name}");
        }
    }
}
