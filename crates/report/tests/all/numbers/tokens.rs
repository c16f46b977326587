//! The numbers that a reader of the page meets, with what stands around them.

use std::collections::HashMap;

/// A number in the page's text.
#[derive(Clone, Debug)]
pub struct Token {
    /// As it stands there.
    pub text: String,
    pub value: f64,
    /// Half of its last digit.
    pub half: f64,
    /// Directly behind it, where that is a unit that this test knows: what a value in SI is multiplied by.
    pub factor: Option<f64>,
    /// The heading above it and the first cell of its row.
    pub above: String,
    /// The whole text between two tags in which it stands, and its first byte there.
    pub line: String,
    pub at: usize,
}

impl Token {
    /// Where it stands, for people.
    pub fn told(&self) -> String {
        let from = self.line[..self.at].char_indices().rev().nth(50).map_or(0, |(at, _)| at);
        let behind = &self.line[self.at..];
        let to = behind.char_indices().nth(60).map_or(behind.len(), |(at, _)| at);
        format!("{} [{}] …{}…", self.text, self.above, &self.line[from..self.at + to])
    }
}

/// What values in SI are multiplied by before a unit.
const UNITS: [(&str, f64); 33] = [
    ("%", 100.0),
    ("m", 1.0),
    ("mm", 1e3),
    ("µm", 1e6),
    ("nm", 1e9),
    ("m²", 1.0),
    ("m³", 1.0),
    ("m/s", 1.0),
    ("mm/s", 1e3),
    ("µm/s", 1e6),
    ("m/s²", 1.0),
    ("mm/s²", 1e3),
    ("GPa", 1e-9),
    ("MPa", 1e-6),
    ("kPa", 1e-3),
    ("Pa", 1.0),
    ("TPa/m", 1e-12),
    ("GPa/m", 1e-9),
    ("MPa/m", 1e-6),
    ("MN", 1e-6),
    ("kN", 1e-3),
    ("N", 1.0),
    ("kN/m", 1e-3),
    ("MN/m", 1e-6),
    ("GJ", 1e-9),
    ("MJ", 1e-6),
    ("kJ", 1e-3),
    ("J", 1.0),
    ("s", 1.0),
    ("ms", 1e3),
    ("µs", 1e6),
    ("Hz", 1.0),
    ("kg/m³", 1.0),
];

/// The numbers of a page but for drawings, the case and code; `names` are words with digits that are none.
pub fn tokens(page: &str, names: &[String]) -> Vec<Token> {
    let (_, main) = page.split_once("<main>").expect("a page");
    let (main, _) = main.split_once("</main>").expect("a whole page");
    let mut tokens = Vec::new();
    let (mut heading, mut row, mut headed) = (String::new(), String::new(), false);
    let mut rest = main.replace("<wbr>", "");
    for (open, close) in [("<svg", "</svg>"), ("<pre", "</pre>"), ("<code", "</code>"), ("<nav", "</nav>")] {
        rest = without(&rest, open, close);
    }
    for piece in rest.split('<') {
        let (tag, text) = piece.split_once('>').unwrap_or(("", piece));
        match tag.split(' ').next().unwrap_or_default() {
            "h2" | "h3" | "h4" | "caption" => (heading, headed) = (String::new(), true),
            "/h2" | "/h3" | "/h4" => headed = false,
            "tr" | "ul" | "p" | "/table" => row.clear(),
            _ => {}
        }
        let mut text = text.trim().to_owned();
        for (entity, character) in [
            ("&#x2f;", "/"),
            ("&#x27;", "'"),
            ("&#39;", "'"),
            ("&quot;", "\""),
            ("&lt;", "<"),
            ("&gt;", ">"),
            ("&amp;", "&"),
        ] {
            text = text.replace(entity, character);
        }
        // Names keep their length, so that places in the line stay what they are.
        let plain = names.iter().fold(text.clone(), |text, name| text.replace(name, &"x".repeat(name.len())));
        let above = format!("{heading} | {row}");
        tokens.extend(of_line(&plain).into_iter().map(|(at, end, value, half)| Token {
            text: text[at..end].to_owned(),
            value,
            half,
            factor: unit(&plain[end..]),
            above: above.clone(),
            line: text.clone(),
            at,
        }));
        if headed {
            heading.push_str(&text);
        } else if row.is_empty() {
            row = text;
        }
    }
    tokens
}

/// Tokens by what stands in one row or paragraph: the text around them, with every number as `#`, and how often it came
/// before. Equal for pages that say the same of other numbers.
pub fn places(tokens: &[Token]) -> Vec<(String, usize)> {
    let mut met: HashMap<String, usize> = HashMap::new();
    let place = |token: &Token| {
        let text = format!("{} | {}", blank(&token.above), blank(&token.line));
        let before = met.entry(text.clone()).or_default();
        *before += 1;
        (text, *before)
    };
    tokens.iter().map(place).collect()
}

fn blank(line: &str) -> String {
    let mut out = String::new();
    let mut last = 0;
    for (at, end, ..) in of_line(line) {
        out.push_str(&line[last..at]);
        out.push('#');
        last = end;
    }
    out + &line[last..]
}

/// `text` without what stands between such tags, which may stand in one another.
fn without(text: &str, open: &str, close: &str) -> String {
    let mut out = String::new();
    let (mut rest, mut depth) = (text, 0_usize);
    loop {
        let (next, end) = (rest.find(open).unwrap_or(rest.len()), rest.find(close).unwrap_or(rest.len()));
        if depth == 0 {
            out.push_str(&rest[..next]);
        }
        let at = if depth == 0 { next } else { next.min(end) };
        if at == rest.len() {
            return out;
        }
        let opens = at == next;
        depth = if opens { depth + 1 } else { depth - 1 };
        rest = &rest[at + if opens { open.len() } else { close.len() }..];
    }
}

/// The factor of the unit at the beginning of `text`, if there is one.
fn unit(text: &str) -> Option<f64> {
    let text = text.trim_start_matches(['\u{a0}', '\u{202f}', ' ']);
    let end = text.find(|c: char| !(c.is_alphabetic() || "²³/%".contains(c))).unwrap_or(text.len());
    factor_of(&text[..end])
}

/// What a value in SI is multiplied by before this unit.
pub fn factor_of(unit: &str) -> Option<f64> {
    UNITS.iter().find(|(name, _)| *name == unit).map(|(_, factor)| *factor)
}

/// Begin, end, value and half of the last digit of each number in a text.
pub fn of_line(line: &str) -> Vec<(usize, usize, f64, f64)> {
    let characters: Vec<(usize, char)> = line.char_indices().collect();
    let at = |k: usize| characters.get(k).map_or('\0', |(_, c)| *c);
    let byte = |k: usize| characters.get(k).map_or(line.len(), |(at, _)| *at);
    let mut found = Vec::new();
    let mut k = 0;
    while k < characters.len() {
        if !at(k).is_ascii_digit() {
            k += 1;
            continue;
        }
        let before = if k == 0 { '\0' } else { at(k - 1) };
        let begin = k;
        let mut digits = String::new();
        let (mut places, mut point) = (0, false);
        while at(k).is_ascii_digit()
            || (!point && at(k) == '.' && at(k + 1).is_ascii_digit())
            || (!point
                && at(k) == '\u{202f}'
                && (1..4).all(|i| at(k + i).is_ascii_digit())
                && !at(k + 4).is_ascii_digit())
        {
            match at(k) {
                '.' => (point, digits) = (true, digits + "."),
                '\u{202f}' => {}
                digit => {
                    digits.push(digit);
                    places += i32::from(point);
                }
            }
            k += 1;
        }
        if before.is_alphabetic() || before == '_' || superscript(at(k)).is_some() {
            // A letter with a number is a name, and 10⁻⁶ alone a unit.
            while superscript(at(k)).is_some() {
                k += 1;
            }
            continue;
        }
        let mut power = String::new();
        if [at(k), at(k + 1), at(k + 2), at(k + 3), at(k + 4)] == ['\u{202f}', '×', '\u{202f}', '1', '0'] {
            k += 5;
            while let Some(c) = superscript(at(k)) {
                power.push(c);
                k += 1;
            }
        } else if at(k) == 'e'
            && (at(k + 1).is_ascii_digit() || (at(k + 1) == '-' && at(k + 2).is_ascii_digit()))
        {
            k += 1;
            while at(k) == '-' || at(k).is_ascii_digit() {
                power.push(at(k));
                k += 1;
            }
        }
        let joined = begin > 1 && (at(begin - 2).is_alphanumeric() || at(begin - 2) == ')');
        let negative = before == '−' || (before == '-' && !joined);
        let power: i32 = power.parse().unwrap_or(0);
        let value: f64 = format!("{digits}e{power}").parse().expect("digits");
        let value = if negative { -value } else { value };
        found.push((byte(begin), byte(k), value, 0.5 * 10_f64.powi(power - places)));
    }
    found
}

fn superscript(c: char) -> Option<char> {
    Some(match c {
        '⁻' => '-',
        '⁰' => '0',
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        '⁴'..='⁹' => char::from_digit(c as u32 - '⁰' as u32, 10)?,
        _ => return None,
    })
}
