//! `tremolite mesh info`: what a mesh is and how far it will do.

mod json;
mod text;

use super::made_of::{self, MadeOf};
use super::steps::{Limits, Steps};
use crate::commands::infos;
use crate::exit::{Code, Failure, Outcome};
use crate::terminal::{print, say};
use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::path::{Path, PathBuf};
use tremolite::laws;
use tremolite::outer_faces::NEAR;
use tremolite::setup::{Inputs, bodies_of};
use tremolite_case::{Case, pattern};
use tremolite_mesh::merge::{coincident_nodes, shortest_edge};
use tremolite_mesh::picture::{section, view, window_of};
use tremolite_mesh::quality::{Summary, by_group, summary};
use tremolite_mesh::sides::sides;
use tremolite_mesh::topology::{components, crowded_faces, exterior_faces, plane_faces};
use tremolite_mesh::{Face, Mesh};

const HELP: &str = "\
The stable step of a group is that of its stiffest element alone, 2/ω. It needs materials: those of a case, or
  --material \"*: E = 10 GPa, nu = 0.25, density = 2752 kg/m3\"
  --material \"*.lining*: E = 25 GPa, nu = 0.17, density = 2400 kg/m3, element = full\"
on the groups that fit the pattern before the colon, in which * stands for any text; where several fit an element the
last counts. Without any, rock of 10 GPa is assumed everywhere; what an element costs beside the others is then right for
any one material.";

#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Args {
    /// A mesh in any supported format, a case, or a file with [mesh] alone
    file: PathBuf,
    /// Draw a section across y as SVG
    #[arg(long)]
    section: Option<PathBuf>,
    /// Where the section is, in m; by default y = 0, or the middle of a mesh that does not reach there
    #[arg(long, value_name = "Y", requires = "section", allow_negative_numbers = true)]
    at: Option<f64>,
    /// Draw a view in three dimensions as SVG
    #[arg(long)]
    view: Option<PathBuf>,
    /// Draw only these groups in the view, and of the section what lies round them; * stands for any text
    #[arg(long, value_name = "GROUPS")]
    only: Option<String>,
    /// What groups are made of, for the stable step; may be given several times
    #[arg(long, value_name = "GROUPS: E = …, nu = …, density = …")]
    material: Vec<String>,
    /// The same from the materials and regions of a case
    #[arg(long, value_name = "CASE.toml", conflicts_with = "material")]
    materials: Option<PathBuf>,
    #[arg(long)]
    json: bool,
}

/// All that is said of a mesh.
struct Info<'m> {
    mesh: &'m Mesh,
    whole: Summary,
    groups: BTreeMap<&'m str, Summary>,
    assumed: bool,
    made: Vec<MadeOf>,
    steps: Steps,
    sides: BTreeMap<String, Vec<Face>>,
    /// How far sides off the axes are turned \[rad\].
    turned: Option<f64>,
    /// Outer faces that are on no side and in no named set.
    elsewhere: usize,
    /// Faces that more than two elements share.
    crowded: Vec<Face>,
    /// Elements of each separate part.
    parts: Vec<usize>,
    /// Within which distance \[m\] nodes were looked for, and how many have another there.
    coincident: (f64, usize),
}

pub fn run(args: &Args) -> Outcome {
    let (mesh, case) = super::load(&args.file)?;
    let made = made(args, &mesh, case.as_ref())?;
    let info = Info::new(&mesh, made);
    if args.json {
        print(&info.json().to_string());
    } else {
        info.print(&args.file);
    }
    let (low, high) = mesh.bounds();
    let middle = if low[1] < 0.0 && high[1] > 0.0 { 0.0 } else { 0.5 * (low[1] + high[1]) };
    let only = args.only.as_deref().map(|only| chosen(&mesh, only)).transpose()?;
    if let Some(path) = &args.section {
        let at = args.at.unwrap_or(middle);
        if !(low[1]..=high[1]).contains(&at) {
            let range = format!("from {:.3} to {:.3}", low[1], high[1]);
            return Err(Failure::input(format!("--at {at} lies outside of the mesh, whose y is {range} m")));
        }
        let margin = 0.1 * (high[0] - low[0]).max(high[2] - low[2]);
        let window =
            args.only.as_ref().and_then(|only| window_of(&mesh, margin, |name| pattern::matches(only, name)));
        save(path, &section(&mesh, at, window))?;
    }
    if let Some(path) = &args.view {
        save(path, &view(&mesh, only.as_deref()))?;
    }
    Ok(Code::Done)
}

/// Elements of the groups that fit a pattern.
fn chosen(mesh: &Mesh, pattern: &str) -> Result<Vec<u32>, Failure> {
    let groups = mesh.groups.iter().filter(|(name, _)| pattern::matches(pattern, name));
    let elements: BTreeSet<u32> = groups.flat_map(|(_, elements)| elements.iter().copied()).collect();
    if elements.is_empty() {
        let names: Vec<&str> = mesh.groups.keys().map(String::as_str).collect();
        return Err(Failure::input(format!(
            "no group fits --only {pattern}; there are {}",
            names.join(", ")
        )));
    }
    Ok(elements.into_iter().collect())
}

fn save(path: &Path, text: &str) -> Result<(), Failure> {
    std::fs::write(path, text).map_err(|e| Failure::failed(format!("{}: {e}", path.display())))
}

/// What the elements are made of, if anything says so.
fn made(args: &Args, mesh: &Mesh, case: Option<&Case>) -> Result<Option<Vec<MadeOf>>, Failure> {
    if !args.material.is_empty() {
        return made_of::options(mesh, &args.material).map(Some).map_err(Failure::input);
    }
    if let Some(path) = &args.materials {
        let case = Case::read(path, &infos()).map_err(|r| Failure::case(&r))?;
        let bodies = bodies_of(&case, mesh, &Inputs::default(), &laws()).map_err(|r| Failure::case(&r))?;
        return Ok(Some(bodies.iter().map(MadeOf::body).collect()));
    }
    let Some(case) = case else { return Ok(None) };
    match bodies_of(case, mesh, &Inputs::default(), &laws()) {
        Ok(bodies) => Ok(Some(bodies.iter().map(MadeOf::body).collect())),
        // The mesh is there to be seen while its regions are still being written.
        Err(report) => {
            say(&report.as_warnings().render(crate::terminal::colour()));
            Ok(None)
        }
    }
}

/// How far sides that boundaries would miss are turned \[rad\].
fn turned(mesh: &Mesh) -> Option<f64> {
    let found = sides(mesh).ok()?;
    found.turned([true; 2], NEAR).then_some(found.angle)
}

impl<'m> Info<'m> {
    fn new(mesh: &'m Mesh, made: Option<Vec<MadeOf>>) -> Self {
        let (low, high) = mesh.bounds();
        let near = NEAR * (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
        let sides = plane_faces(mesh, near);
        let named: HashSet<Face> = sides.values().chain(mesh.faces.values()).flatten().copied().collect();
        let tolerance = 1e-4 * shortest_edge(mesh);
        let assumed = made.is_none();
        let made = made.unwrap_or_else(|| made_of::stand_in(mesh));
        Info {
            mesh,
            whole: summary(mesh),
            groups: by_group(mesh),
            assumed,
            steps: Steps::new(mesh, &made),
            made,
            elsewhere: exterior_faces(mesh, None).iter().filter(|f| !named.contains(f)).count(),
            turned: turned(mesh),
            sides,
            crowded: crowded_faces(mesh),
            parts: components(mesh, None).iter().map(Vec::len).collect(),
            coincident: (tolerance, coincident_nodes(mesh, tolerance).len()),
        }
    }

    fn types(&self, elements: impl Iterator<Item = u32>) -> BTreeMap<&'static str, usize> {
        let mut types = BTreeMap::new();
        for element in elements {
            *types.entry(self.mesh.elements[element as usize].shape.name()).or_default() += 1;
        }
        types
    }

    fn all(&self) -> std::ops::Range<u32> {
        0..self.mesh.elements.len() as u32
    }

    /// The steps of the whole mesh and of each group that has any.
    fn limits(&self) -> (Option<Limits>, Vec<(&str, Limits)>) {
        let of = |(name, list): (&'m String, &Vec<u32>)| {
            Some((name.as_str(), self.steps.limits(list.iter().copied())?))
        };
        (self.steps.limits(self.all()), self.mesh.groups.iter().filter_map(of).collect())
    }
}
