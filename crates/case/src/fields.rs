//! A table of the case once checked: every value has its kind, its unit and its limits, defaults are filled in.

use std::collections::BTreeMap;
use std::ops::Range;

use tremolite_laws::parameter::{Value, Values};

use crate::Spanned;
use crate::keys::Table;

/// A checked value.
#[derive(Clone, Debug)]
pub(crate) struct Node {
    pub item: Item,
    pub span: Range<usize>,
}

#[derive(Clone, Debug)]
pub(crate) enum Item {
    /// In SI.
    Number(f64),
    Count(u32),
    Text(String),
    Flag(bool),
    List(Vec<Node>),
    Table(Fields),
    /// Values by free keys, in the order of the file.
    Map(Vec<(Spanned<String>, Node)>),
    /// Materials, in the order of the file.
    Materials(Vec<Material>),
}

/// A checked material.
#[derive(Clone, Debug)]
pub(crate) struct Material {
    pub name: Spanned<String>,
    pub fields: Fields,
}

/// A checked table: its values by key. A key is missing if it was left out without a default, or if it was refused,
/// and then that has been reported.
#[derive(Clone, Debug)]
pub(crate) struct Fields {
    pub table: &'static Table,
    /// Its header.
    pub span: Range<usize>,
    pub nodes: BTreeMap<&'static str, Node>,
    /// Which keys are parameters of the law that the table names; nothing if it names none that is known.
    pub parameters: Option<Vec<&'static str>>,
}

impl Fields {
    pub fn get(&self, key: &'static str) -> Option<&Node> {
        debug_assert!(self.table.keys.iter().any(|k| k.name == key), "{} has no key {key}", self.table.path);
        #[cfg(test)]
        reads::record(self.table.path, key);
        self.nodes.get(key)
    }

    pub fn number(&self, key: &'static str) -> Option<Spanned<f64>> {
        self.get(key)?.number()
    }

    pub fn count(&self, key: &'static str) -> Option<Spanned<u32>> {
        let node = self.get(key)?;
        match node.item {
            Item::Count(n) => Some(Spanned::new(n, node.span.clone())),
            _ => None,
        }
    }

    pub fn text(&self, key: &'static str) -> Option<Spanned<String>> {
        self.get(key)?.text()
    }

    /// A word, turned into its enumeration.
    pub fn word<T>(&self, key: &'static str, from: impl Fn(&str) -> Option<T>) -> Option<Spanned<T>> {
        let word = self.text(key)?;
        Some(Spanned::new(from(&word)?, word.span))
    }

    pub fn flag(&self, key: &'static str) -> Option<bool> {
        match self.get(key)?.item {
            Item::Flag(flag) => Some(flag),
            _ => None,
        }
    }

    pub fn table(&self, key: &'static str) -> Option<&Fields> {
        self.get(key)?.table()
    }

    /// The values of a list; none if it is missing.
    pub fn list(&self, key: &'static str) -> &[Node] {
        self.get(key).map_or(&[], Node::list)
    }

    /// A list of texts.
    pub fn texts(&self, key: &'static str) -> Vec<Spanned<String>> {
        self.get(key).map_or_else(Vec::new, Node::texts)
    }

    /// The entries of a table with free keys; none if it is missing.
    pub fn entries(&self, key: &'static str) -> &[(Spanned<String>, Node)] {
        match self.get(key).map(|node| &node.item) {
            Some(Item::Map(entries)) => entries,
            _ => &[],
        }
    }

    /// An array of tables, or the one table in its place.
    pub fn tables(&self, key: &'static str) -> impl Iterator<Item = &Fields> {
        let nodes = match self.get(key) {
            Some(node) if node.table().is_some() => std::slice::from_ref(node),
            Some(node) => node.list(),
            None => &[],
        };
        nodes.iter().filter_map(Node::table)
    }

    /// A list of exactly N numbers.
    pub fn numbers<const N: usize>(&self, key: &'static str) -> Option<Spanned<[f64; N]>> {
        self.get(key)?.numbers()
    }

    /// The parameters of the law that the table names; nothing if it names none that is known.
    pub fn values(&self) -> Option<Values> {
        let mut values = Values::default();
        for name in self.parameters.as_ref()? {
            let value = match self.nodes.get(name).map(|n| &n.item) {
                Some(Item::Number(x)) => Value::Number(*x),
                Some(Item::Text(word)) => Value::Word(word.clone()),
                Some(Item::Table(table)) => Value::Table(table.columns()),
                _ => continue,
            };
            values.0.insert((*name).to_owned(), value);
        }
        Some(values)
    }

    /// The columns of a checked table of them, or of single numbers.
    fn columns(&self) -> BTreeMap<String, Vec<f64>> {
        let column = |(name, node): (&&'static str, &Node)| match &node.item {
            Item::List(numbers) => {
                let numbers = numbers.iter().filter_map(|n| Some(n.number()?.value));
                Some(((*name).to_owned(), numbers.collect()))
            }
            Item::Number(x) => Some(((*name).to_owned(), vec![*x])),
            _ => None,
        };
        self.nodes.iter().filter_map(column).collect()
    }
}

impl Node {
    pub fn number(&self) -> Option<Spanned<f64>> {
        match self.item {
            Item::Number(x) => Some(Spanned::new(x, self.span.clone())),
            _ => None,
        }
    }

    pub fn text(&self) -> Option<Spanned<String>> {
        match &self.item {
            Item::Text(text) => Some(Spanned::new(text.clone(), self.span.clone())),
            _ => None,
        }
    }

    /// The values of a list; none if it is no list.
    pub fn list(&self) -> &[Node] {
        match &self.item {
            Item::List(nodes) => nodes,
            _ => &[],
        }
    }

    /// The texts of a list.
    pub fn texts(&self) -> Vec<Spanned<String>> {
        self.list().iter().filter_map(Node::text).collect()
    }

    pub fn table(&self) -> Option<&Fields> {
        match &self.item {
            Item::Table(fields) => Some(fields),
            _ => None,
        }
    }

    pub fn numbers<const N: usize>(&self) -> Option<Spanned<[f64; N]>> {
        let Item::List(nodes) = &self.item else { return None };
        let values: Vec<f64> = nodes.iter().filter_map(|n| n.number().map(|x| x.value)).collect();
        Some(Spanned::new(values.try_into().ok()?, self.span.clone()))
    }
}

/// Records which keys are read, so that a test can compare them with the tables.
#[cfg(test)]
pub(crate) mod reads {
    use std::cell::RefCell;
    use std::collections::BTreeSet;

    thread_local! {
        static READS: RefCell<BTreeSet<(&'static str, &'static str)>> = const { RefCell::new(BTreeSet::new()) };
    }

    pub fn record(table: &'static str, key: &'static str) {
        READS.with(|reads| reads.borrow_mut().insert((table, key)));
    }

    /// Everything read by this thread so far.
    pub fn take() -> BTreeSet<(&'static str, &'static str)> {
        READS.with(RefCell::take)
    }
}
