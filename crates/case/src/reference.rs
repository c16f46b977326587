//! The reference of the case file as a page of Markdown: every key with its value, what stands for it where it is left out, and
//! its meaning, from the tables that also check the file.

use tremolite_laws::parameter::{Dimension, LawInfo};

use crate::case::CASE;
use crate::keys::{Key, Kind, Limit, Table};
use crate::laws::Laws;
use crate::listing::listed;
use crate::{law_key, suggest, units};

const HEAD: &str = "# Reference of the case file

Every key of a case. `tremolite list keys` prints this page, `tremolite schema` the same as a JSON schema for editors. A value is
checked by the very tables that this page is made of.

A case is TOML: `[mesh.caverns]` begins a table, `[[stage]]` one more entry of a list of tables, text behind `#` is a comment.
Positions are x, y, z with z up; stresses are positive in tension.

## Units

A number that has a dimension stands with its unit in a text: `\"25 GPa\"`, `\"27 kN/m3\"`, `\"46 deg\"`. Units are joined by `*` and `/` and
read from left to right, each with an optional power: `m3`, `m^3`, `m³`, `s^-2`. A wrong dimension is refused. 0 needs no unit, a
pure number has none (`0.3`, `\"30 %\"`), an angle always has one.

A bare number with a dimension is refused with the unit that it probably has. `units = \"SI\"` at the top of a case, law or mesh file
says that all its bare numbers are in SI, angles excepted; the first line of `check` and the page of the run then say so.

";

/// The same page for these laws.
pub fn reference<'a>(laws: impl Into<Laws<'a>>) -> String {
    let laws = laws.into();
    let mut page = Page { text: HEAD.to_owned(), done: Vec::new(), laws };
    page.units();
    page.text += "## Top of the file\n\n";
    let tables = |key: &&'static Key| !suggest::tables(&key.kind).is_empty();
    page.keys(&CASE.keys.iter().filter(|key| !tables(key)).copied().collect::<Vec<_>>());
    page.below(&CASE);
    page.text
}

/// Pictures of what the lengths of a table mean: where they lie beside the page, and what they show.
const PICTURES: &[(&str, &str, &str)] = &[
    (
        "mesh.caverns",
        "reference/caverns.svg",
        "Lengths of a generated mesh, seen across the caverns and along them",
    ),
    ("mesh.box", "reference/box.svg", "Lengths of a box"),
];

struct Page<'a> {
    text: String,
    /// Paths of the tables that are on it.
    done: Vec<&'static str>,
    laws: Laws<'a>,
}

impl Page<'_> {
    fn line(&mut self, line: &str) {
        self.text += line;
        self.text.push('\n');
    }

    /// Examples of every dimension that has a name.
    fn units(&mut self) {
        self.line("| dimension | such as | other units |\n|---|---|---|");
        for (name, example, others) in units::listed() {
            self.line(&format!("| {name} | `\"{example}\"` | {} |", others.join(", ")));
        }
        self.line("");
    }

    /// The tables that the keys of a table lead to, and what is below them.
    fn below(&mut self, table: &'static Table) {
        for key in table.keys {
            for inner in suggest::tables(&key.kind) {
                if !self.done.contains(&inner.path) {
                    self.done.push(inner.path);
                    self.table(inner, &key.kind);
                    self.below(inner);
                }
            }
        }
    }

    fn table(&mut self, table: &'static Table, kind: &Kind) {
        let level = if table.path.contains('.') { "###" } else { "##" };
        self.line(&format!("{level} {}\n", table.path));
        let header = match kind {
            Kind::Tables(_) | Kind::Interfaces(_) => format!("`[[{}]]`", table.path),
            Kind::Materials(_) => format!("`[{}.NAME]`", table.path),
            _ => format!("`[{}]`", table.path),
        };
        self.line(&format!("{header}: {}\n", table.doc));
        if let Some((_, picture, shows)) = PICTURES.iter().find(|(path, ..)| *path == table.path) {
            self.line(&format!("![{shows}]({picture})\n"));
        }
        let named: Vec<String> =
            table.choice.iter().filter(|g| !g.is_empty()).map(|g| format!("`{}`", g.join("`/`"))).collect();
        if !named.is_empty() {
            let most = if table.choice.iter().any(|group| group.is_empty()) { "At most" } else { "Exactly" };
            self.line(&format!("{most} one of {} is given.\n", named.join(", ")));
        }
        self.keys(table.keys);
        match kind {
            Kind::Materials(_) => self.of_laws(self.laws.materials),
            Kind::Interfaces(_) => self.of_laws(self.laws.interfaces),
            _ => {}
        }
    }

    fn of_laws(&mut self, laws: &[LawInfo]) {
        for law in laws {
            self.line(&format!("### law = \"{}\"\n\n{}.\n", law.name, suggest::capital(law.summary)));
            self.keys(&law.parameters.iter().map(law_key::of).collect::<Vec<_>>());
        }
    }

    fn keys(&mut self, keys: &[Key]) {
        if keys.is_empty() {
            return;
        }
        self.line("| key | value | left out | meaning |\n|---|---|---|---|");
        for key in keys {
            let need = listed(key).need;
            let row =
                [&format!("`{}`", key.name), &value(key.name, &key.kind), &need, &suggest::capital(key.doc)];
            let row = row.map(|cell| cell.replace('|', "\\|"));
            self.line(&format!("| {} |", row.join(" | ")));
            let inner: Vec<Key> = match key.kind {
                Kind::Columns(columns) => columns.iter().map(law_key::column).collect(),
                Kind::Set(entries) => entries.iter().map(law_key::of).collect(),
                _ => Vec::new(),
            };
            for inner in inner {
                let (need, doc) = (listed(&inner).need, suggest::capital(inner.doc));
                let value = value(inner.name, &inner.kind);
                self.line(&format!("| `{}.{}` | {value} | {need} | {doc} |", key.name, inner.name));
            }
        }
        self.line("");
    }
}

/// What a value is, with an example or the words that it may be.
fn value(key: &str, kind: &Kind) -> String {
    match kind {
        Kind::Number(Dimension::NONE, limit) => bounded("a pure number", *limit, Dimension::NONE),
        Kind::Number(dimension, limit) => format!(
            "{}, `\"{}\"`",
            bounded(&units::name_for(key, *dimension), *limit, *dimension),
            units::example(key, *dimension)
        ),
        Kind::Numbers(dimension) if *dimension == Dimension::NONE => "a list of pure numbers".to_owned(),
        Kind::Numbers(dimension) => {
            format!(
                "a list, each {}, `\"{}\"`",
                units::name_for(key, *dimension),
                units::example(key, *dimension)
            )
        }
        Kind::Word(words) => format!("`\"{}\"`", words.join("\"`, `\"")),
        Kind::List(each, least, most) => {
            let count = match (least, most) {
                (least, most) if least == most => format!("{least}"),
                (least, most) if *most > 1000 => format!("{least} or more"),
                (least, most) => format!("{least} to {most}"),
            };
            format!("a list of {count}, each {}", value(key, each))
        }
        Kind::Table(table) => link(table, "a table"),
        Kind::Tables(table) | Kind::Interfaces(table) => link(table, "a list of tables"),
        Kind::Materials(table) => link(table, "tables by name"),
        Kind::Brief(table, keys) => {
            let brief =
                table.brief(keys).map_or_else(String::new, |brief| format!("{}, or ", value(key, brief)));
            format!("{brief}{}", link(table, "a table"))
        }
        Kind::Map(like, each) => {
            format!("a table such as `{{ \"{like}\" = … }}`, each value {}", value("", each))
        }
        Kind::Columns(_) => "a table of columns:".to_owned(),
        Kind::Set(_) => "a table of numbers:".to_owned(),
        Kind::Either(kinds) => kinds.iter().map(|kind| value(key, kind)).collect::<Vec<_>>().join(" or "),
        Kind::Permeability => "a permeability in m2 or in m2/(Pa s), `\"1e-14 m2\"`".to_owned(),
        Kind::Unit(dimension) => format!("a unit of {}", units::name_for(key, *dimension)),
        _ => suggest::describe(key, kind),
    }
}

fn bounded(what: &str, limit: Limit, dimension: Dimension) -> String {
    if matches!(limit, Limit::Any) { what.to_owned() } else { format!("{what} {}", limit.words(dimension)) }
}

/// A table's section on the page.
fn link(table: &Table, what: &str) -> String {
    match table.path {
        "" => what.to_owned(),
        path => format!("[{what}](#{})", path.replace('.', "")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tremolite_laws::materials::MATERIALS;

    /// Every key of every table that a case may have, at its table.
    #[test]
    fn the_page_holds_every_key_of_every_table_and_law() {
        fn all(table: &'static Table, found: &mut Vec<&'static Table>) {
            if found.iter().all(|known| known.path != table.path) {
                found.push(table);
                table.keys.iter().flat_map(|k| suggest::tables(&k.kind)).for_each(|t| all(t, found));
            }
        }
        let page = reference(MATERIALS);
        let mut tables = Vec::new();
        all(&CASE, &mut tables);
        assert!(tables.len() > 20);
        for table in tables {
            let heading = if table.path.is_empty() { "Top of the file" } else { table.path };
            let section = page.split("\n## ").flat_map(|part| part.split("\n### "));
            let section = section.clone().find(|part| part.lines().next() == Some(heading));
            let section = section.unwrap_or_else(|| panic!("no section '{heading}'"));
            for key in table.keys {
                // The tables of a case have sections of their own.
                let above = table.path.is_empty() && !suggest::tables(&key.kind).is_empty();
                assert!(above || section.contains(&format!("| `{}` |", key.name)), "{heading}: {}", key.name);
            }
        }
        for law in MATERIALS.iter() {
            assert!(page.contains(&format!("### law = \"{}\"", law.name)), "{}", law.name);
        }
    }

    #[test]
    fn every_link_of_the_page_leads_to_a_section() {
        let page = reference(MATERIALS);
        let anchors: Vec<String> = page
            .lines()
            .filter_map(|line| line.strip_prefix("## ").or(line.strip_prefix("### ")))
            .map(|heading| heading.replace('.', "").replace(' ', "-").to_lowercase())
            .collect();
        let mut links = page.split("](#").skip(1).filter_map(|rest| rest.split(')').next());
        assert!(links.clone().count() > 20);
        assert_eq!(links.find(|link| !anchors.iter().any(|a| a == link)), None);
    }
}
