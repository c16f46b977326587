//! `[[stage.bolts]]`: rock bolts and anchors that a stage places.

mod check;
mod table;

use std::f64::consts::PI;
use std::ops::Range;
use std::path::PathBuf;

use crate::Spanned;
use crate::fields::{Fields, Item, Node};
use crate::keys::words;

pub(crate) use check::check;
pub(crate) use table::{BOLTS, BOLTS_KIND, BOND};

words! {
    /// Faces that a pattern bolts, of those that its stage exposes. What is to be bolted on a floor is given by points.
    BoltedFaces {
        /// Crown and walls. Floors are left out, as the next bench takes them.
        Systematic = "systematic",
        /// Faces whose normal into the rock points up by more than 45°.
        Crown = "crown",
        /// Faces whose normal into the rock points neither up nor down by more than 45°; end walls as well.
        Walls = "walls",
    }
}

words! {
    /// Where plates hold a bolt.
    Plate {
        /// At the head.
        Head = "head",
        /// At both ends.
        Both = "both",
        /// Nowhere.
        None = "none",
    }
}

/// Bolts of one kind that a stage places.
#[derive(Clone, Debug, PartialEq)]
pub struct Bolts {
    /// Unique among all bolts of the case.
    pub name: Spanned<String>,
    /// Where they are.
    pub place: BoltPlace,
    /// Diameter of the steel, m, in \[0.1 mm, 1 m\].
    pub diameter: Spanned<f64>,
    /// Young's modulus, Pa.
    pub young: Spanned<f64>,
    /// Stress at which they yield, Pa; nothing: never.
    pub yields: Option<Spanned<f64>>,
    /// Strain at which they break, in (0, 1], beyond that at which they yield; nothing: never.
    pub breaking_strain: Option<Spanned<f64>>,
    /// N, below what yields or breaks them; nothing: none.
    pub pretension: Option<Spanned<f64>>,
    /// Length from the head on which they touch nothing, m; nothing: none. Only with a plate at the head.
    pub free_length: Option<Spanned<f64>>,
    /// Where plates hold them.
    pub plate: Spanned<Plate>,
    /// Nothing: they move with the rock.
    pub bond: Option<BoltBond>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

/// Where bolts are.
#[derive(Clone, Debug, PartialEq)]
pub enum BoltPlace {
    /// On faces that the stage exposes.
    Pattern(BoltPattern),
    /// Head and other end of each, m.
    Points(Vec<Spanned<[[f64; 3]; 2]>>),
    /// A file with a bolt in each row. As written; relative to the case's directory.
    File(Spanned<PathBuf>),
}

/// A pattern of bolts.
#[derive(Clone, Debug, PartialEq)]
pub struct BoltPattern {
    /// Which faces.
    pub faces: Spanned<BoltedFaces>,
    /// Group names, in which `*` stands for any text (see [`pattern::matches`](crate::pattern::matches)), on either side of the
    /// faces; empty: any.
    pub on: Vec<Spanned<String>>,
    /// Between rows along the cavern, and around it in a row, m.
    pub spacing: Spanned<[f64; 2]>,
    /// m
    pub length: Spanned<f64>,
    /// A unit vector, in either sense; nothing: normal to the face.
    pub direction: Option<Spanned<[f64; 3]>>,
}

/// How bolts are joined to the rock along their length.
#[derive(Clone, Debug, PartialEq)]
pub struct BoltBond {
    /// Force per length and slip, N/m².
    pub stiffness: Spanned<f64>,
    /// Force per length at which it slips without confinement, N/m.
    pub strength: Spanned<f64>,
    /// rad, in [0°, 80°].
    pub friction_angle: Spanned<f64>,
    /// Longest segment, m; nothing: cut where it leaves an element alone.
    pub segment: Option<Spanned<f64>>,
}

impl Plate {
    /// Whether there is one at the head, and at the other end.
    pub fn ends(self) -> [bool; 2] {
        [self != Plate::None, self == Plate::Both]
    }
}

impl Bolts {
    /// Cross-section of the steel, m².
    pub fn area(&self) -> f64 {
        area(self.diameter.value)
    }

    /// `stage` is the name of the stage.
    pub(crate) fn read(f: &Fields, stage: &str) -> Option<Self> {
        let (yields, breaking_strain) = (f.number("yield"), f.number("breaking_strain"));
        let (pretension, free_length) = (f.number("pretension"), f.number("free_length"));
        let bond = match f.table("bond") {
            Some(bond) => Some(BoltBond::read(bond)?),
            None => None,
        };
        Some(Bolts {
            name: name(f, stage),
            place: BoltPlace::read(f)?,
            diameter: f.number("diameter")?,
            young: f.number("young")?,
            yields,
            breaking_strain,
            pretension,
            free_length,
            plate: plate(f)?,
            bond,
            span: f.span.clone(),
        })
    }
}

impl BoltPlace {
    fn read(f: &Fields) -> Option<Self> {
        let (points, file, pattern) = (points(f), f.text("file"), BoltPattern::read(f));
        if let Some(pattern) = pattern {
            return Some(BoltPlace::Pattern(pattern));
        }
        if let Some(file) = file {
            return Some(BoltPlace::File(Spanned::new(PathBuf::from(file.value), file.span)));
        }
        (!points.is_empty()).then_some(BoltPlace::Points(points))
    }
}

impl BoltPattern {
    fn read(f: &Fields) -> Option<Self> {
        let faces = f.word("pattern", BoltedFaces::from_word);
        let (on, spacing, length) = (f.texts("on"), spacing(f), f.number("length"));
        let direction = direction(f);
        Some(BoltPattern {
            faces: faces?,
            on,
            spacing: spacing?,
            length: length?,
            direction: match direction {
                Some(written) => Some(Spanned::new(unit(written.value)?, written.span)),
                None => None,
            },
        })
    }
}

impl BoltBond {
    fn read(f: &Fields) -> Option<Self> {
        let segment = f.number("segment");
        Some(BoltBond {
            stiffness: f.number("stiffness")?,
            strength: f.number("strength")?,
            friction_angle: f.number("friction_angle")?,
            segment,
        })
    }
}

/// m²
fn area(diameter: f64) -> f64 {
    0.25 * PI * diameter * diameter
}

/// What bolts are called: as they say, or by their pattern and the stage.
pub(crate) fn name(f: &Fields, stage: &str) -> Spanned<String> {
    f.text("name").unwrap_or_else(|| {
        let what = f.text("pattern").map_or_else(|| "bolts".to_owned(), |word| word.value);
        Spanned::new(format!("{what} of {stage}"), f.span.clone())
    })
}

fn plate(f: &Fields) -> Option<Spanned<Plate>> {
    let node = f.get("plate")?;
    let plate = match &node.item {
        Item::Flag(true) => Plate::Head,
        Item::Flag(false) => Plate::None,
        Item::Text(word) => Plate::from_word(word)?,
        _ => return None,
    };
    Some(Spanned::new(plate, node.span.clone()))
}

fn spacing(f: &Fields) -> Option<Spanned<[f64; 2]>> {
    let node = f.get("spacing")?;
    match node.number() {
        Some(one) => Some(Spanned::new([one.value; 2], one.span)),
        None => node.numbers(),
    }
}

/// The direction as it is written; nothing where it is a word, or left out.
fn direction(f: &Fields) -> Option<Spanned<[f64; 3]>> {
    f.get("direction")?.numbers()
}

/// A vector of length 1; nothing of one without length.
fn unit(v: [f64; 3]) -> Option<[f64; 3]> {
    // By its largest component first, lest squares overflow or vanish.
    let largest = v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    if !largest.is_normal() {
        return None;
    }
    let scaled = v.map(|x| x / largest);
    let length = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
    Some(scaled.map(|x| x / length))
}

/// Head and other end of each bolt of a list.
fn points(f: &Fields) -> Vec<Spanned<[[f64; 3]; 2]>> {
    let ends = |node: &Node| {
        let ends =
            node.list().iter().map(|end| end.numbers().map(|x| x.value)).collect::<Option<Vec<_>>>()?;
        Some(Spanned::new(ends.try_into().ok()?, node.span.clone()))
    };
    f.list("points").iter().filter_map(ends).collect()
}
