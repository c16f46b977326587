//! `displacement` of a `[[stage]]`: nodes that are moved, as by a machine that tests a specimen.

use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use super::Stage;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table};
use crate::{Diagnostic, Spanned};

const LENGTH: Kind = Kind::Number(Dimension::LENGTH, Limit::Any);
/// Smallest and largest coordinate.
const RANGE: Kind = Kind::List(&LENGTH, 2, 2);
/// Steps of a stage beyond which a case is a slip.
const MOST_STEPS: u32 = 5000;
const WAYS: [&str; 3] = ["ux", "uy", "uz"];
const AXES: [&str; 3] = ["x", "y", "z"];

pub(crate) const DISPLACEMENT_KIND: Kind =
    Kind::Either(&[Kind::Tables(&DISPLACEMENT), Kind::Table(&DISPLACEMENT)]);

static DISPLACEMENT: Table = Table {
    path: "stage.displacement",
    doc: "Nodes that a stage moves, and how far. They are held from the beginning on, and stay where they were moved to.",
    keys: &[
        Key::optional("group", Kind::Text, "", "The nodes of a group; * stands for any text"),
        Key::optional(
            "face",
            Kind::Text,
            "",
            "The nodes of a face: a named one of the mesh, or xmin, xmax, ymin, ymax, base or top",
        ),
        Key::optional("within", Kind::Table(&WITHIN), "", "Only those of them in this range of coordinates"),
        Key::optional(
            "name",
            Kind::Name,
            "",
            "First part of the names of its columns in stages.csv; by default the group's or the face's",
        ),
        Key::optional(
            "ux",
            LENGTH,
            "",
            "Displacement along x at the end, from the initial equilibrium; left out: free",
        ),
        Key::optional("uy", LENGTH, "", "Displacement along y"),
        Key::optional("uz", LENGTH, "", "Displacement along z"),
        Key::optional(
            "steps",
            Kind::Count(MOST_STEPS),
            "",
            "In how many equal steps the stage goes there (1): each comes to rest and is a row of stages.csv",
        ),
    ],
    choice: &[&["group"], &["face"]],
};

static WITHIN: Table = Table {
    path: "stage.displacement.within",
    doc: "A range of coordinates.",
    keys: &[
        Key::optional("x", RANGE, "", "Smallest and largest x"),
        Key::optional("y", RANGE, "", "Smallest and largest y"),
        Key::optional("z", RANGE, "", "Smallest and largest z"),
    ],
    choice: &[],
};

/// Which nodes are moved.
#[derive(Clone, Debug, PartialEq)]
pub enum Moved {
    /// Those of the elements of groups: a name in which `*` stands for any text.
    Group(Spanned<String>),
    /// Those of a named set of faces, or of an outer plane.
    Face(Spanned<String>),
}

/// Nodes that a stage moves, or that it goes on to hold where an earlier one has moved them.
#[derive(Clone, Debug, PartialEq)]
pub struct Displacement {
    /// Unique among those of a stage; the same name in a later stage means the same nodes.
    pub name: String,
    pub of: Moved,
    /// Smallest and largest coordinate along x, y, z, m.
    pub within: [Option<[f64; 2]>; 3],
    /// Displacement along x, y, z at the end of the stage, from the initial equilibrium, m; nothing: free.
    pub to: [Option<f64>; 3],
    /// Steps in which the stage goes there, where it is this one that says so.
    pub steps: Option<u32>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

impl Displacement {
    pub(crate) fn read(f: &Fields) -> Option<Self> {
        let of = match (f.text("group"), f.text("face")) {
            (Some(group), None) => Moved::Group(group),
            (None, Some(face)) => Moved::Face(face),
            _ => return None,
        };
        let (Moved::Group(what) | Moved::Face(what)) = &of;
        let range = |axis| f.table("within")?.numbers::<2>(axis).map(|range| range.value);
        Some(Displacement {
            name: f.text("name").map_or_else(|| plain(&what.value), |name| name.value),
            within: AXES.map(range),
            to: WAYS.map(|way| f.number(way).map(|u| u.value)),
            steps: f.count("steps").map(|steps| steps.value),
            span: f.span.clone(),
            of,
        })
    }

    /// What lies between keys, and between the stages.
    pub(crate) fn check(case: &Fields, problems: &mut Vec<Diagnostic>) {
        let mut earlier: Vec<Displacement> = Vec::new();
        let monitors: Vec<Spanned<String>> = case.tables("monitor").filter_map(|m| m.text("name")).collect();
        for stage in case.tables("stage") {
            let tables: Vec<&Fields> = stage.tables("displacement").collect();
            for f in &tables {
                if WAYS.iter().all(|way| f.get(way).is_none()) {
                    let remedy = "add uz = \"0.5 mm\", or 0 for a support";
                    problems.push(Diagnostic::new(
                        f.span.clone(),
                        "nothing says how far it is moved",
                        remedy,
                    ));
                }
                let ranges = AXES.iter().filter_map(|axis| f.table("within")?.numbers::<2>(axis));
                problems.extend(ranges.filter(|range| range.value[0] > range.value[1]).map(|range| {
                    Diagnostic::at(&range, "the larger coordinate stands first", "swap the two")
                }));
            }
            let read: Vec<Displacement> = tables.iter().filter_map(|f| Displacement::read(f)).collect();
            for (k, one) in read.iter().enumerate() {
                if read[..k].iter().any(|other| other.name == one.name) {
                    let what = format!("'{}' is moved twice in this stage", one.name);
                    problems.push(Diagnostic::new(one.span.clone(), what, "give each a `name` of its own"));
                }
                if monitors.iter().any(|monitor| monitor.value == one.name) {
                    let what = format!(
                        "a monitor is called '{}' as well, and both have columns of that name",
                        one.name
                    );
                    problems.push(Diagnostic::new(one.span.clone(), what, "give it another `name`"));
                }
                let told = read[..k].iter().find_map(|other| other.steps);
                if let (Some(told), Some(steps)) = (told, one.steps)
                    && told != steps
                {
                    let what = format!("a stage goes in {told} and in {steps} steps");
                    problems.push(Diagnostic::new(one.span.clone(), what, "say it once"));
                }
                let same = |other: &&Displacement| other.name == one.name;
                if earlier.iter().find(same).is_some_and(|other| !other.means_nodes_of(one)) {
                    let what = format!("'{}' meant other nodes in an earlier stage", one.name);
                    problems.push(Diagnostic::new(one.span.clone(), what, "give it another `name`"));
                }
            }
            if let (false, Some(release)) = (read.is_empty(), stage.number("release"))
                && release.value < 1.0
            {
                problems.push(Diagnostic::at(
                    &release,
                    "a stage that moves nodes lets go of all that is held",
                    "give `release` in a stage of its own",
                ));
            }
            earlier.extend(read);
        }
    }

    fn means_nodes_of(&self, other: &Displacement) -> bool {
        let what = |one: &Displacement| match &one.of {
            Moved::Group(group) => (true, group.value.clone()),
            Moved::Face(face) => (false, face.value.clone()),
        };
        what(self) == what(other) && self.within == other.within
    }
}

/// A pattern as the first part of a column's name.
fn plain(pattern: &str) -> String {
    pattern.chars().filter(|c| !"*?[],".contains(*c)).collect::<String>().replace([' ', '.'], "_")
}

/// Stages in single steps: one that goes in several becomes as many, of which the first has all else that it changes. Each has
/// all displacements of the case, those of other stages where these stand by then.
pub(crate) fn in_steps(stages: Vec<Stage>) -> Vec<Stage> {
    let mut now: Vec<Displacement> = Vec::new();
    for one in stages.iter().flat_map(|stage| &stage.displacements) {
        let held = one.to.map(|to| to.map(|_| 0.0));
        match now.iter_mut().find(|known| known.name == one.name) {
            Some(known) => (0..3).for_each(|i| known.to[i] = known.to[i].or(held[i])),
            None => now.push(Displacement { to: held, steps: None, ..one.clone() }),
        }
    }
    let mut all = Vec::new();
    for stage in stages {
        let steps = stage.displacements.iter().find_map(|one| one.steps).unwrap_or(1);
        let before = now.clone();
        for step in 1..=steps {
            for (known, before) in now.iter_mut().zip(&before) {
                let own = stage.displacements.iter().find(|one| one.name == known.name);
                let Some(own) = own else { continue };
                known.span.clone_from(&own.span);
                for i in 0..3 {
                    if let (Some(from), Some(to)) = (before.to[i], own.to[i]) {
                        let gone = (to - from) * f64::from(step) / f64::from(steps);
                        known.to[i] = Some(if step < steps { from + gone } else { to });
                    }
                }
            }
            let mut one = if step == 1 { stage.clone() } else { Stage::plain(&stage) };
            one.moves = !stage.displacements.is_empty();
            one.displacements.clone_from(&now);
            if steps > 1 {
                one.name.value = format!("{} {step}/{steps}", stage.name.value);
            }
            all.push(one);
        }
    }
    all
}
