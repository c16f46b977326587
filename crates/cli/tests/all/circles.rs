//! The files of a crate name each other one way: none names a file that, itself or through others, names it in turn.
//!
//! Arrows are the paths that begin with `crate`, `super` or `self`, in `use` and elsewhere, in macros too, outside tests.
//! A path leads to the file that holds what it names, through whatever modules re-export it; only names re-exported by a
//! star end at the star. A module and the modules inside it are one house: arrows between them are not followed.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use syn::buffer::{Cursor, TokenBuffer};
use syn::visit::{self, Visit};
use syn::{Attribute, Item, UseTree};

/// Names from the crate's root on: of a module, or of something in one.
type Names = Vec<String>;

/// What the files of one crate say.
#[derive(Default)]
struct Crate {
    /// The file of each module that has one.
    files: BTreeMap<Names, String>,
    /// What each name that a `use` brings into a module stands for.
    imports: BTreeMap<Names, Names>,
    /// The module that a path stands in, and what it names.
    paths: Vec<(Names, Names)>,
}

/// Reads a file; `module` is where it is just now, a module within the file included.
struct Reader<'a> {
    krate: &'a mut Crate,
    module: Names,
    /// Modules that the file declares and does not hold.
    declared: Vec<Names>,
}

impl Crate {
    /// The crate that begins with the file `root`, from `sources`: texts by their path below `src`.
    fn read(root: &str, sources: &BTreeMap<String, String>) -> Crate {
        let mut krate = Crate::default();
        let mut open = vec![Names::new()];
        while let Some(module) = open.pop() {
            let path = module.join("/");
            let places = if module.is_empty() {
                vec![root.to_owned()]
            } else {
                vec![format!("{path}.rs"), format!("{path}/mod.rs")]
            };
            let Some((place, text)) = places.iter().find_map(|place| sources.get_key_value(place)) else {
                panic!("there is no file of the module {path}")
            };
            let parsed = syn::parse_file(text).unwrap_or_else(|e| panic!("{place}: {e}"));
            krate.files.insert(module.clone(), place.clone());
            let mut reader = Reader { krate: &mut krate, module, declared: Vec::new() };
            reader.visit_file(&parsed);
            open.append(&mut reader.declared);
        }
        krate
    }

    /// The module whose file holds what a path names.
    fn holder(&self, path: &[String], steps: usize) -> Names {
        for length in (1..=path.len()).rev() {
            let (head, rest) = path.split_at(length);
            if self.files.contains_key(head) {
                return head.to_vec();
            }
            // A re-export that leads back to itself does not compile; the bound only ends the search.
            if let Some(whole) = self.imports.get(head).filter(|_| steps < 20) {
                return self.holder(&[whole, rest].concat(), steps + 1);
            }
        }
        Names::new()
    }

    /// From each module's file to others, with one of the names that lead there.
    fn arrows(&self) -> BTreeMap<(Names, Names), String> {
        let mut arrows = BTreeMap::new();
        for (from, path) in &self.paths {
            let (from, to) = (self.holder(from, 0), self.holder(path, 0));
            if !from.starts_with(&to) && !to.starts_with(&from) {
                arrows.entry((from, to)).or_insert(path.last().cloned().unwrap_or_default());
            }
        }
        arrows
    }

    /// The circles, each as the lines `a.rs -> b.rs: Name` between its files.
    fn circles(&self) -> Vec<Vec<String>> {
        let arrows = self.arrows();
        let reached = |start: &Names| {
            let mut found = BTreeSet::new();
            let mut open = vec![start];
            while let Some(module) = open.pop() {
                let next = arrows.keys().filter(|(from, _)| from == module).map(|(_, to)| to);
                open.extend(next.filter(|to| found.insert((*to).clone())));
            }
            found
        };
        let reach: BTreeMap<&Names, BTreeSet<Names>> = self.files.keys().map(|m| (m, reached(m))).collect();
        let circle = |module: &Names, within: &BTreeSet<Names>| {
            let both = reach.iter().filter(|(other, back)| within.contains(**other) && back.contains(module));
            both.map(|(other, _)| *other).collect::<Vec<&Names>>()
        };
        let circles: BTreeSet<Vec<&Names>> =
            reach.iter().map(|(module, within)| circle(module, within)).filter(|c| !c.is_empty()).collect();
        let inside = |circle: &Vec<&Names>| {
            let lines =
                arrows.iter().filter(|((from, to), _)| circle.contains(&from) && circle.contains(&to));
            lines
                .map(|((from, to), name)| format!("{} -> {}: {name}", self.files[from], self.files[to]))
                .collect()
        };
        circles.iter().map(inside).collect()
    }
}

impl Reader<'_> {
    /// A path as names from the crate's root on; none if it leads out of the crate, or into the prelude.
    fn absolute(&self, path: &[String]) -> Option<Names> {
        let mut rest = path;
        let mut names = match rest.first()?.as_str() {
            "crate" => Names::new(),
            "super" | "self" => self.module.clone(),
            _ => return None,
        };
        while let Some(first @ ("crate" | "super" | "self")) = rest.first().map(String::as_str) {
            if first == "super" {
                names.pop();
            }
            rest = &rest[1..];
        }
        names.extend_from_slice(rest);
        Some(names)
    }

    fn path(&mut self, path: &[String]) {
        let named = self.absolute(path);
        self.krate.paths.extend(named.map(|named| (self.module.clone(), named)));
    }

    /// Every name that a `use` brings in.
    fn import(&mut self, tree: &UseTree, before: &[String]) {
        let with = |name: &syn::Ident| [before, &[name.to_string()]].concat();
        let (path, name) = match tree {
            UseTree::Path(path) => return self.import(&path.tree, &with(&path.ident)),
            UseTree::Group(group) => return group.items.iter().for_each(|tree| self.import(tree, before)),
            UseTree::Glob(_) => return self.path(before),
            UseTree::Name(name) if name.ident == "self" => (before.to_vec(), before.last().cloned()),
            UseTree::Name(name) => (with(&name.ident), Some(name.ident.to_string())),
            UseTree::Rename(name) if name.ident == "self" => (before.to_vec(), Some(name.rename.to_string())),
            UseTree::Rename(name) => (with(&name.ident), Some(name.rename.to_string())),
        };
        self.path(&path);
        // Without `crate` or `super` it begins with a module in here, or with another crate, which no path leads to.
        let whole = self.absolute(&path).unwrap_or_else(|| [self.module.clone(), path].concat());
        let imported = [self.module.clone(), Vec::from_iter(name)].concat();
        if imported != whole {
            self.krate.imports.insert(imported, whole);
        }
    }

    /// The paths in what a macro is given, or is made of.
    fn tokens(&mut self, mut at: Cursor<'_>) {
        while !at.eof() {
            if let Some((inside, _, _, after)) = at.any_group() {
                self.tokens(inside);
                at = after;
                continue;
            }
            let mut path = Names::new();
            while let Some((name, after)) = at.ident() {
                path.push(name.to_string());
                at = after;
                match colon(at).and_then(colon) {
                    Some(after) => at = after,
                    None => break,
                }
            }
            if path.is_empty() {
                at = at.token_tree().map_or(Cursor::empty(), |(_, after)| after);
            } else {
                self.path(&path);
            }
        }
    }
}

/// What stands behind a colon, if here is one.
fn colon(at: Cursor<'_>) -> Option<Cursor<'_>> {
    at.punct().filter(|(punct, _)| punct.as_char() == ':').map(|(_, after)| after)
}

/// Whether something is there for tests alone.
fn for_tests(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("cfg")
            && attribute.parse_args::<syn::Path>().is_ok_and(|what| what.is_ident("test"))
    })
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        let attributes = match item {
            Item::Const(item) => &item.attrs,
            Item::Fn(item) => &item.attrs,
            Item::Impl(item) => &item.attrs,
            Item::Macro(item) => &item.attrs,
            Item::Mod(item) => &item.attrs,
            Item::Static(item) => &item.attrs,
            Item::Struct(item) => &item.attrs,
            Item::Use(item) => &item.attrs,
            _ => return visit::visit_item(self, item),
        };
        if !for_tests(attributes) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        self.module.push(item.ident.to_string());
        if item.content.is_some() {
            visit::visit_item_mod(self, item);
        } else {
            self.declared.push(self.module.clone());
        }
        self.module.pop();
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        self.import(&item.tree, &[]);
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let names: Names = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        self.path(&names);
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, it: &'ast syn::Macro) {
        self.tokens(TokenBuffer::new2(it.tokens.clone()).begin());
        visit::visit_macro(self, it);
    }
}

/// The texts below a folder, by their path from there.
fn texts(folder: &Path, before: &str, found: &mut BTreeMap<String, String>) {
    for entry in fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display())) {
        let path = entry.unwrap().path();
        let name = format!("{before}{}", path.file_name().unwrap_or_default().to_string_lossy());
        if path.is_dir() {
            texts(&path, &format!("{name}/"), found);
        } else if name.ends_with(".rs") {
            let text = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
            found.insert(name, text);
        }
    }
}

#[test]
fn no_file_names_one_that_names_it_in_turn() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let (mut files, mut circles) = (0, Vec::new());
    for entry in fs::read_dir(&crates).unwrap() {
        let folder = entry.unwrap().path();
        let mut sources = BTreeMap::new();
        texts(&folder.join("src"), "", &mut sources);
        for root in ["lib.rs", "main.rs"].into_iter().filter(|root| sources.contains_key(*root)) {
            let krate = Crate::read(root, &sources);
            files += krate.files.len();
            let name = folder.file_name().unwrap_or_default().to_string_lossy();
            circles.extend(krate.circles().iter().map(|lines| format!("{name}:\n  {}", lines.join("\n  "))));
        }
    }
    circles.sort();
    assert!(files > 200, "{files} files are not all");
    assert!(
        circles.is_empty(),
        "files that name each other in a circle; what both need lies below both, in a file of its own:\n{}",
        circles.join("\n")
    );
}

/// The circles of made-up files, as one text.
fn circles_of(files: &[(&str, &str)]) -> String {
    let sources = files.iter().map(|(place, text)| ((*place).to_owned(), (*text).to_owned())).collect();
    Crate::read("lib.rs", &sources)
        .circles()
        .iter()
        .map(|lines| lines.join(", "))
        .collect::<Vec<_>>()
        .join("; ")
}

#[test]
fn circles_are_found_through_re_exports_and_macros_and_only_where_there_are_some() {
    let root = "mod a; mod b; mod c; pub use a::Error;";
    let below = "pub struct Error; #[cfg(test)] mod tests { use crate::b::read; }";
    let reads = "use crate::{Error, c::deep::Thing}; pub fn read() -> Result<Thing, Error> { todo!() }";
    let files =
        |a, b, c, deep| [("lib.rs", root), ("a.rs", a), ("b.rs", b), ("c/mod.rs", c), ("c/deep.rs", deep)];
    let house =
        ("pub mod deep; pub fn all() { deep::one() }", "pub struct Thing; pub fn one() { super::all() }");
    assert_eq!(circles_of(&files(below, reads, house.0, house.1)), "");
    for (a, found) in [
        ("pub struct Error(super::b::Reader);", "a.rs -> b.rs: Reader, b.rs -> a.rs: Error"),
        (
            "pub enum Error {} pub fn why() { println!(\"{}\", [crate::b::read()]) }",
            "a.rs -> b.rs: read, b.rs -> a.rs: Error",
        ),
        (
            "use crate::c as other; pub struct Error; pub fn read(_: self::other::Front) {}",
            "a.rs -> b.rs: Front, a.rs -> c/mod.rs: c, b.rs -> a.rs: Error, c/mod.rs -> b.rs: Reader",
        ),
    ] {
        let c = "pub mod deep; pub use crate::b::Reader as Front;";
        assert_eq!(circles_of(&files(a, reads, c, "pub struct Thing;")), found);
    }
    // Two houses, by modules inside them.
    let found = circles_of(&files(
        "mod inner { pub(in crate::a) type Deep = crate::c::deep::Thing; } pub struct Error;",
        "",
        "pub mod deep;",
        "pub struct Thing(crate::Error);",
    ));
    assert_eq!(found, "a.rs -> c/deep.rs: Thing, c/deep.rs -> a.rs: Error");
}
