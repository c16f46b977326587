//! The path of the key that a place in the text belongs to.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

use crate::key_path::below;

/// The paths of the keys or tables that are the smallest around these places, in their order; empty where there is none.
/// Entries of lists go by their number from 0, which is theirs alone whatever their names.
pub(crate) fn paths(source: &str, places: &[Range<usize>]) -> Vec<String> {
    let (document, _) = DeTable::parse_recoverable(source);
    let mut all = Vec::new();
    walk(document.get_ref(), "", &mut all);
    // Places lie within one another or apart: of two that begin alike the longer is around the other.
    all.sort_by_key(|(place, _)| (place.start, usize::MAX - place.end));
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by_key(|&k| places[k].start);
    let mut found = vec![String::new(); places.len()];
    let mut around: Vec<&(Range<usize>, String)> = Vec::new();
    let mut next = all.iter().peekable();
    for k in order {
        let place = &places[k];
        while let Some(entry) = next.next_if(|(at, _)| at.start <= place.start) {
            around.retain(|(at, _)| at.end > entry.0.start);
            around.push(entry);
        }
        let holds = |(at, _): &&&(Range<usize>, String)| !place.is_empty() && at.end >= place.end;
        if let Some((_, path)) = around.iter().rev().find(holds) {
            found[k].clone_from(path);
        }
    }
    found
}

/// Lists the keys and the values below a table with their paths, each table before what is in it.
fn walk(table: &DeTable<'_>, path: &str, all: &mut Vec<(Range<usize>, String)>) {
    for (key, value) in table {
        let path = below(path, key.get_ref());
        all.push((key.span(), path.clone()));
        inside(value.get_ref(), value.span(), path, all);
    }
}

fn inside(value: &DeValue<'_>, place: Range<usize>, path: String, all: &mut Vec<(Range<usize>, String)>) {
    all.push((place, path.clone()));
    match value {
        DeValue::Table(table) => walk(table, &path, all),
        DeValue::Array(entries) => {
            for (k, entry) in entries.iter().enumerate() {
                inside(entry.get_ref(), entry.span(), format!("{path}[{k}]"), all);
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_has_the_path_of_the_smallest_key_around_it() {
        let source = "title = \"t\"\nlateral.x = 1 # one\n[material.\"rock.a\"]\nyoung = \"25 GPa\"\n[[stage]]\nname = \"a\"\n\
                      excavate = [\"g\", \"h\"]\n[[stage]]\nbolts = { bond = { stiffness = 2 } }\n";
        let at = |text: &str| {
            let start = source.find(text).unwrap_or_else(|| panic!("{text}"));
            start..start + text.len()
        };
        let second = source.rfind("[[stage]]").expect("two stages");
        for (place, path) in [
            (at("\"t\""), "title"),
            (at("x"), "lateral.x"),
            (at("1"), "lateral.x"),
            (at("[material.\"rock.a\"]"), "material.\"rock.a\""),
            (at("\"rock.a\""), "material.\"rock.a\""),
            (at("GPa"), "material.\"rock.a\".young"),
            (at("[\"g\", \"h\"]"), "stage[0].excavate"),
            (at("\"h\""), "stage[0].excavate[1]"),
            (second..second + 9, "stage[1]"),
            (at("2 }"), "stage[1].bolts.bond"),
            (at("{ stiffness = 2 }"), "stage[1].bolts.bond"),
            (at("stiffness"), "stage[1].bolts.bond.stiffness"),
            (at("# one"), ""),
            (0..0, ""),
        ] {
            assert_eq!(paths(source, std::slice::from_ref(&place)), [path], "{}", &source[place]);
        }
        // Together as each alone.
        let places = [at("GPa"), at("x"), 0..0, at("\"h\"")];
        assert_eq!(
            paths(source, &places),
            ["material.\"rock.a\".young", "lateral.x", "", "stage[0].excavate[1]"]
        );
    }
}
