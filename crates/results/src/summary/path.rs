//! Whether a path leads to a number in `summary.json`, by the types that it is written from and without a file.

use std::cell::RefCell;

use serde::Deserialize;
use serde::de::value::{Error, StrDeserializer};
use serde::de::{DeserializeSeed, Deserializer, Error as _, MapAccess, SeqAccess, Visitor};
use serde::forward_to_deserialize_any;

use super::{CaseFacts, Computed, Conclusion, MonitorFacts, PartFacts, Soundness};

/// A part of a path.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Segment {
    /// A key; `whole` where quotes say that it is one key whatever dots it has.
    Key { name: String, whole: bool },
    /// An entry of a list, by number or name.
    Entry,
}

/// What a path leads to.
#[derive(Clone, Debug)]
enum Leads {
    /// To a number, or to a value of any type.
    Number,
    /// To nothing: how many segments led on, and what the next one may be.
    Nowhere { reached: usize, known: Vec<&'static str>, why: String },
}

/// Whether `path` may lead to a number in a summary: keys with dots between them, quoted where a key has dots of its own, entries of
/// lists in brackets. Names of groups and monitors are not looked at.
///
/// # Errors
/// Why it cannot, and the keys that could stand there.
pub fn check_summary_path(path: &str) -> Result<(), (String, Vec<&'static str>)> {
    let segments = segments(path.trim());
    let mut best: Option<(usize, Vec<&'static str>, String)> = None;
    // A name without quotes may be one key or several; three maps at most lie in one another.
    let most = segments.len().clamp(1, 6);
    let counts = 1..=most;
    for first in counts.clone() {
        for second in counts.clone() {
            for third in counts.clone() {
                match leads(&segments, &[first, second, third]) {
                    Leads::Number => return Ok(()),
                    Leads::Nowhere { reached, known, why } => {
                        if best.as_ref().is_none_or(|(most, ..)| reached > *most) {
                            best = Some((reached, known, why));
                        }
                    }
                }
            }
        }
    }
    let (_, known, why) = best.unwrap_or_default();
    Err((why, known))
}

fn segments(path: &str) -> Vec<Segment> {
    let mut all = Vec::new();
    let mut rest = path;
    while let Some(first) = rest.chars().next() {
        rest = match first {
            '.' => &rest[1..],
            '"' | '\'' => {
                let (name, behind) = rest[1..].split_once(first).unwrap_or((&rest[1..], ""));
                all.push(Segment::Key { name: name.to_owned(), whole: true });
                behind
            }
            '[' => {
                all.push(Segment::Entry);
                rest.split_once(']').map_or("", |(_, behind)| behind)
            }
            _ => {
                let end = rest.find(['.', '[']).unwrap_or(rest.len());
                all.push(Segment::Key { name: rest[..end].to_owned(), whole: false });
                &rest[end..]
            }
        };
    }
    all
}

/// Where segments lead, if the maps on the way take so many of them as a key.
fn leads(segments: &[Segment], counts: &[usize]) -> Leads {
    let found = RefCell::new(Leads::Nowhere { reached: 0, known: Vec::new(), why: String::new() });
    let top = Probe { segments, at: 0, counts, found: &found };
    let mut fields: Vec<&'static str> = vec!["title"];
    macro_rules! part {
        ($($part:ty),*) => {$(
            let names = RefCell::new(Vec::new());
            let _ = <$part>::deserialize(Fields(&names));
            let names = names.into_inner();
            if matches!(segments.first(), Some(Segment::Key { name, .. }) if names.contains(&name.as_str())) {
                let _ = <$part>::deserialize(top);
                return found.into_inner();
            }
            fields.extend(names);
        )*};
    }
    part!(Conclusion, Computed, MonitorFacts, PartFacts, Soundness, CaseFacts);
    top.nowhere("the summary has no such key", fields);
    found.into_inner()
}

/// The names of a struct's fields.
struct Fields<'a>(&'a RefCell<Vec<&'static str>>);

impl<'de> Deserializer<'de> for Fields<'_> {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, Error> {
        Err(Error::custom("only structs have fields"))
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        _: V,
    ) -> Result<V::Value, Error> {
        self.0.borrow_mut().extend(fields);
        Err(Error::custom("that is all"))
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct newtype_struct seq
        tuple tuple_struct map enum identifier ignored_any
    }
}

/// Follows a path down the types, whose reading always fails: what was found is kept beside.
#[derive(Clone, Copy)]
struct Probe<'a> {
    segments: &'a [Segment],
    at: usize,
    /// Segments that each further map on the way takes.
    counts: &'a [usize],
    found: &'a RefCell<Leads>,
}

impl Probe<'_> {
    fn next(&self) -> Option<&Segment> {
        self.segments.get(self.at)
    }

    fn nowhere(&self, why: &str, known: Vec<&'static str>) -> Error {
        *self.found.borrow_mut() = Leads::Nowhere { reached: self.at, known, why: why.to_owned() };
        Error::custom(why)
    }

    /// A value without others below it.
    fn leaf(&self, is_number: bool) -> Error {
        if self.next().is_some() {
            return self.nowhere("nothing stands below a value", Vec::new());
        }
        if !is_number {
            return self.nowhere("it is no number", Vec::new());
        }
        *self.found.borrow_mut() = Leads::Number;
        Error::custom("found")
    }
}

/// One key and what stands there.
struct OneKey<'a> {
    key: Option<String>,
    value: Probe<'a>,
}

impl<'de> MapAccess<'de> for OneKey<'_> {
    type Error = Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Error> {
        match self.key.take() {
            Some(key) => seed.deserialize(StrDeserializer::new(&key)).map(Some),
            None => Ok(None),
        }
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Error> {
        seed.deserialize(self.value)
    }
}

/// One entry of a list.
struct OneEntry<'a>(Probe<'a>);

impl<'de> SeqAccess<'de> for OneEntry<'_> {
    type Error = Error;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Error> {
        seed.deserialize(self.0).map(Some)
    }
}

macro_rules! leaves {
    ($number:literal: $($method:ident)*) => {$(
        fn $method<V: Visitor<'de>>(self, _: V) -> Result<V::Value, Error> {
            Err(self.leaf($number))
        }
    )*};
}

impl<'de> Deserializer<'de> for Probe<'_> {
    type Error = Error;

    /// A value of any type, of which nothing is known here.
    fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, Error> {
        *self.found.borrow_mut() = Leads::Number;
        Err(Error::custom("found"))
    }

    leaves! { true: deserialize_bool deserialize_i8 deserialize_i16 deserialize_i32 deserialize_i64 deserialize_u8 deserialize_u16
    deserialize_u32 deserialize_u64 deserialize_f32 deserialize_f64 }
    leaves! { false: deserialize_char deserialize_str deserialize_string deserialize_bytes deserialize_byte_buf deserialize_unit
    deserialize_identifier deserialize_ignored_any }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_unit_struct<V: Visitor<'de>>(self, _: &'static str, _: V) -> Result<V::Value, Error> {
        Err(self.leaf(false))
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        _: V,
    ) -> Result<V::Value, Error> {
        Err(self.leaf(false))
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.next() {
            Some(Segment::Entry) => visitor.visit_seq(OneEntry(Probe { at: self.at + 1, ..self })),
            Some(_) => Err(self.nowhere("it stands below a list: write [0], or [name]", Vec::new())),
            None => Err(self.nowhere("it is a list: write [0], or [name]", Vec::new())),
        }
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, _: usize, visitor: V) -> Result<V::Value, Error> {
        self.deserialize_seq(visitor)
    }

    fn deserialize_tuple_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: usize,
        visitor: V,
    ) -> Result<V::Value, Error> {
        self.deserialize_seq(visitor)
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        let (first, counts) = self.counts.split_first().map_or((1, &[][..]), |(first, rest)| (*first, rest));
        let mut key = String::new();
        let mut at = self.at;
        while let Some(Segment::Key { name, whole }) = self.segments.get(at)
            && at < self.at + first
        {
            // What is quoted is a key of its own.
            if *whole && at > self.at {
                break;
            }
            key += if key.is_empty() { "" } else { "." };
            key += name;
            at += 1;
            if *whole {
                break;
            }
        }
        if at == self.at {
            return Err(self.nowhere("a name is expected there", Vec::new()));
        }
        visitor.visit_map(OneKey { key: Some(key), value: Probe { at, counts, ..self } })
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        match self.next() {
            Some(Segment::Key { name, .. }) if fields.contains(&name.as_str()) => visitor
                .visit_map(OneKey { key: Some(name.clone()), value: Probe { at: self.at + 1, ..self } }),
            Some(_) => Err(self.nowhere("there is no such key", fields.to_vec())),
            None => Err(self.nowhere("it is no number but has others below it", fields.to_vec())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_to_numbers_are_known_from_the_types_alone() {
        for path in [
            "damage.\"main.lining\".measures.d_tension.beyond.\"0.5\"",
            "damage.main.lining.measures.d_tension.beyond.0.5",
            "damage.main.lining.volume",
            "damage.'main.lining'.cracks.opening",
            "checks[energy].value",
            "checks[0].value",
            "model.time_step",
            "wall_seconds",
            "motion.peak_acceleration.x",
            "monitors.A.s1.max",
            "relative.\"A-base\".u.residual",
            "interfaces.\"lining-rock\".normal_stiffness",
            "interfaces.\"lining-rock\".max_gap.value",
            "energy.created_by_law",
        ] {
            assert_eq!(check_summary_path(path), Ok(()), "{path}");
        }
        for (path, says, known) in [
            ("damege.a.volume", "no such key", "damage"),
            ("damage.\"a\".cracks.openning", "no such key", "opening"),
            ("damage.\"a\".cracks", "has others below", "opening"),
            // Without quotes all of it may be the name.
            ("damage.a.lining.volum", "has others below", "volume"),
            ("damage.\"a.lining\".volum", "no such key", "volume"),
            ("title.more", "no such key", "damage"),
            ("checks.value", "a list", ""),
            ("verdict", "no number", ""),
            ("model.time_step.more", "nothing stands below", ""),
        ] {
            let (why, keys) = check_summary_path(path).expect_err(path);
            assert!(
                why.contains(says) && (known.is_empty() || keys.contains(&known)),
                "{path}: {why} {keys:?}"
            );
        }
    }
}
