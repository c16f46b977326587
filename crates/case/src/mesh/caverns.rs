//! `[mesh.caverns]`: a block of rock with caverns, generated.

mod cavern;
mod gallery;
mod site;

use std::collections::BTreeSet;
use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use super::LENGTH;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table};
use crate::{Diagnostic, Spanned};

pub use cavern::{Cavern, CavernShape, Length, Lining, Shotcrete};
pub use gallery::Gallery;
pub use site::{GroundSurface, RockLayer};

const NOT_NEGATIVE: Kind = Kind::Number(Dimension::LENGTH, Limit::NotNegative);

pub(super) static CAVERNS: Table = Table {
    path: "mesh.caverns",
    doc: "A block of rock with caverns along y, generated; they go through it or end in its rock. x runs across the caverns, from the first one's axis; y from \
          the middle of the block; z upwards from the ground.",
    keys: &[
        Key::required("overburden", LENGTH, "rock from the ground down to the first cavern's crown"),
        Key::required("below", LENGTH, "rock from the lowest floor down to the base of the block"),
        Key::required(
            "sides",
            LENGTH,
            "rock from the outermost linings, or their shotcrete, to the sides of the block",
        ),
        Key::required("length", LENGTH, "length of the block along the caverns"),
        Key::required("size_near", LENGTH, "element size at the caverns"),
        Key::required("size_far", LENGTH, "element size far from the caverns"),
        Key::optional(
            "size_along",
            LENGTH,
            "the size `size_near`",
            "Element size along the caverns; beyond the ends of all of them elements grow, up to `size_far`",
        ),
        Key::required("cavern", Kind::Tables(&cavern::CAVERN), "the caverns"),
        Key::optional(
            "gallery",
            Kind::Tables(&gallery::GALLERY),
            "",
            "Straight galleries across, between two caverns",
        ),
        Key::optional("layer", Kind::Tables(&site::LAYER), "", "Layers of rock, from the ground down"),
        Key::optional(
            "ground",
            Kind::Table(&site::GROUND),
            "",
            "Surface of the ground; without it level, at z = 0",
        ),
    ],
    choice: &[],
};

/// A block of rock with caverns along y. Lengths in m.
#[derive(Clone, Debug, PartialEq)]
pub struct Caverns {
    /// From the ground down to the first cavern's crown.
    pub overburden: Spanned<f64>,
    /// From the lowest floor down to the base.
    pub below: Spanned<f64>,
    /// From the outermost linings, or their shotcrete, to the sides.
    pub sides: Spanned<f64>,
    /// Length of the block along y.
    pub length: Spanned<f64>,
    /// Element size at the caverns.
    pub near: Spanned<f64>,
    /// Element size far from the caverns.
    pub far: Spanned<f64>,
    /// Element size along y; nothing: `near`.
    pub along: Option<Spanned<f64>>,
    /// At least one, names unique.
    pub caverns: Vec<Cavern>,
    /// From the ground down; names unique.
    pub layers: Vec<RockLayer>,
    /// Across, between caverns.
    pub galleries: Vec<Gallery>,
    /// Nothing: level, at z = 0.
    pub ground: Option<GroundSurface>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

impl Caverns {
    pub(super) fn read(f: &Fields, x_azimuth: f64) -> Option<Self> {
        let caverns: Vec<Option<Cavern>> = f.tables("cavern").map(Cavern::read).collect();
        let along = f.number("size_along");
        let layer = |layer| RockLayer::read(layer, x_azimuth);
        let layers: Vec<Option<RockLayer>> = f.tables("layer").map(layer).collect();
        let galleries: Vec<Option<Gallery>> = f.tables("gallery").map(Gallery::read).collect();
        let ground = f.table("ground").map(GroundSurface::read);
        Some(Caverns {
            overburden: f.number("overburden")?,
            below: f.number("below")?,
            sides: f.number("sides")?,
            length: f.number("length")?,
            near: f.number("size_near")?,
            far: f.number("size_far")?,
            along,
            caverns: caverns.into_iter().collect::<Option<_>>()?,
            layers: layers.into_iter().collect::<Option<_>>()?,
            galleries: galleries.into_iter().collect::<Option<_>>()?,
            ground: match ground {
                Some(ground) => Some(ground?),
                None => None,
            },
            span: f.span.clone(),
        })
    }

    pub(super) fn check(f: &Fields, problems: &mut Vec<Diagnostic>) {
        if let (Some(near), Some(far)) = (f.number("size_near"), f.number("size_far"))
            && near.value > far.value
        {
            problems.push(Diagnostic::at(
                &near,
                "`size_near` is larger than `size_far`",
                "elements grow from `size_near` at the caverns to `size_far`: give `size_near` the smaller size",
            ));
        }
        let (mut caverns, block) = (BTreeSet::new(), f.number("length"));
        for cavern in f.tables("cavern") {
            Cavern::check(cavern, block.as_ref(), problems);
            once(cavern, "cavern", &mut caverns, problems);
        }
        let (mut names, mut layers) = (caverns.clone(), BTreeSet::new());
        f.tables("layer").for_each(|layer| once(layer, "layer", &mut layers, problems));
        for gallery in f.tables("gallery") {
            once(gallery, "gallery", &mut names, problems);
            // Where two caverns share a name, the other may be the one that is meant.
            let doubled = caverns.len() < f.tables("cavern").count();
            let unknown = |name: &&Spanned<String>| !doubled && !caverns.contains(&name.value);
            for cavern in gallery.texts("between").iter().filter(unknown) {
                let message = format!("there is no cavern `{}`", cavern.value);
                problems.push(Diagnostic::at(cavern, message, "name two caverns of this block"));
            }
        }
    }
}

/// Names lead to groups, so no two may be alike.
fn once(table: &Fields, what: &str, names: &mut BTreeSet<String>, problems: &mut Vec<Diagnostic>) {
    if let Some(name) = table.text("name")
        && !names.insert(name.value.clone())
    {
        let message = match what {
            "gallery" => format!("a cavern or another gallery is called `{}`", name.value),
            _ => format!("two {what}s are called `{}`", name.value),
        };
        problems.push(Diagnostic::at(&name, message, format!("give each {what} its own name")));
    }
}
