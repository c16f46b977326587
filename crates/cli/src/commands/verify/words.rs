//! Texts of problems as Markdown of a page of its own.

use tremolite_verify::PROBLEMS;

/// A text of code's documentation without what only that has: paths as links. Those to another problem lead to it.
pub fn of_text(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find("[`") {
        let (before, link) = rest.split_at(at);
        let Some((name, behind)) = link[2..].split_once("`]") else { break };
        out.push_str(before);
        rest = behind;
        match name.strip_prefix("super::").filter(|name| PROBLEMS.iter().any(|problem| problem.name == *name))
        {
            Some(other) => out.push_str(&format!("[`{other}`](#{other})")),
            None => {
                out.push_str(&format!("`{name}`"));
                // The path that the name stands for.
                if let Some((_, behind)) = rest.strip_prefix('(').and_then(|path| path.split_once(')')) {
                    rest = behind;
                }
            }
        }
    }
    out + rest
}

/// Keys of sources lead to the list of sources.
pub fn linked(source: &str) -> String {
    let pieces = source.trim_end_matches('.').split('`').enumerate();
    let is_key = |piece: &str| {
        piece.ends_with(|c: char| c.is_ascii_digit()) && piece.starts_with(|c: char| c.is_ascii_lowercase())
    };
    let each = pieces.map(|(k, piece)| match k % 2 {
        0 => piece.to_owned(),
        _ if is_key(piece) => format!("[`{piece}`](../references.bib)"),
        _ => format!("`{piece}`"),
    });
    each.collect()
}

/// A text in a cell of a table.
pub fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

/// A share of a tolerance, to two digits.
pub fn share(value: f64) -> String {
    let power = if value > 0.0 && value.is_finite() { value.log10().floor() } else { 0.0 };
    let last = 10f64.powf(power - 1.0);
    number((value / last).round() * last)
}

/// Four digits, plain where that is short.
pub fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() {
        return "∞".into();
    }
    if !(1e-3..1e5).contains(&size) {
        let text = format!("{value:.3e}");
        let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{power}", trimmed(digits)).replace('-', "−");
    }
    let decimals = (3 - size.log10().floor() as i32).clamp(0, 6) as usize;
    trimmed(&format!("{value:.decimals$}")).replace('-', "−")
}

fn trimmed(digits: &str) -> &str {
    if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_of_code_become_words_and_those_to_problems_stay() {
        assert_eq!(
            of_text("as in [`super::lamb`]), by [`A::b`](c::d), [`e`]'s [f](g.md)"),
            "as in [`lamb`](#lamb)), by `A::b`, `e`'s [f](g.md)"
        );
        assert_eq!(of_text("[`open"), "[`open");
        assert_eq!(linked("`pao1973`, `bolted`"), "[`pao1973`](../references.bib), `bolted`");
        assert_eq!(cell("|u| a"), "\\|u\\| a");
    }

    #[test]
    fn numbers_have_four_digits() {
        let all = [0.0, 2.0, 0.012345, -1.5, 123456.0, 1.2346e-7, 99999.0, f64::INFINITY].map(number);
        assert_eq!(
            [0.0, 0.3379, 0.02386, 2.442e-5, 1.26].map(share),
            ["0", "0.34", "0.024", "2.4e−5", "1.3"]
        );
        assert_eq!(all, ["0", "2", "0.01235", "−1.5", "1.235e5", "1.235e−7", "99999", "∞"]);
    }
}
