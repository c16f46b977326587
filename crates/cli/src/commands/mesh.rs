//! `tremolite mesh`: look at meshes, convert them, make them.

mod info;
mod made_of;
mod placing;
mod steps;

use super::infos;
use crate::exit::{Code, Failure, Outcome};
use crate::terminal::{print, say};
use std::path::{Path, PathBuf};
use tremolite::setup::{Inputs, add_to_mesh, free_sides, mesh_of};
use tremolite_case::{Case, MeshAlone};
use tremolite_mesh::cavern::CavernSpec;
use tremolite_mesh::merge::merge_nodes;
use tremolite_mesh::{Mesh, read_with_notes, write};

#[derive(clap::Args)]
pub struct Args {
    #[command(subcommand)]
    action: Action,
}

#[derive(clap::Subcommand)]
enum Action {
    /// Counts, sizes, quality, stable step, boundary faces, separate parts
    Info(info::Args),
    /// Write a mesh in another format, by the ending of the new name: vtu, msh or inp; turned, scaled and moved if asked
    Convert {
        from: PathBuf,
        to: PathBuf,
        #[command(flatten)]
        placing: placing::Args,
        /// Last, merge nodes that lie within this distance, in m
        #[arg(long)]
        merge: Option<f64>,
        /// At the very end, make a group by place, with the keys of [[mesh.group]]: 'name = "fault", box = [[…], […]]'; may be
        /// given several times
        #[arg(long, value_name = "KEYS")]
        group: Vec<String>,
        /// After that, cast a lining against the walls of holes, with the keys of [[mesh.lining]]: 'name = "lining", thickness =
        /// "0.4 m"'; may be given several times
        #[arg(long, value_name = "KEYS")]
        lining: Vec<String>,
    },
    /// Make the mesh that [mesh.caverns] describes, or a preset, and write it
    Cavern {
        /// A case, a file with [mesh.caverns] alone, or one of yingxiuwan and yingxiuwan-fine
        what: String,
        /// The file to write: vtu, msh or inp
        #[arg(long)]
        out: PathBuf,
    },
}

pub fn run(args: &Args) -> Outcome {
    match &args.action {
        Action::Info(args) => info::run(args),
        Action::Convert { from, to, placing, merge, group, lining } => {
            convert(from, to, placing, *merge, [("group", group), ("lining", lining)])
        }
        Action::Cavern { what, out } => cavern(what, out),
    }
}

/// A mesh from a mesh file, from a description, or from a case, which comes with it; what was done to it on the way goes
/// to the terminal.
fn load(file: &Path) -> Result<(Mesh, Option<Case>), Failure> {
    if file.extension().is_some_and(|e| e == "toml") {
        let (made, case) = match MeshAlone::read(file).map_err(|r| Failure::case(&r))? {
            Some(alone) => {
                let directory = file.parent().unwrap_or(Path::new(""));
                let made =
                    mesh_of(&alone.mesh, &alone.ground, &[], [false; 2], directory, &Inputs::default());
                (made.map_err(|p| alone.report(p)), None)
            }
            None => {
                let case = Case::read(file, &infos()).map_err(|r| Failure::case(&r))?;
                let made = mesh_of(
                    &case.mesh,
                    &case.ground,
                    &case.interfaces,
                    free_sides(&case),
                    case.directory(),
                    &Inputs::default(),
                );
                (made.map_err(|p| case.report(p)), Some(case))
            }
        };
        let (mesh, warnings) = made.map_err(|r| Failure::case(&r))?;
        warnings.iter().for_each(|warning| say(&format!("note: {}", warning.message)));
        return Ok((mesh, case));
    }
    let (mesh, notes) = read_with_notes(file).map_err(Failure::input)?;
    notes.iter().for_each(|note| say(&format!("note: {note}")));
    Ok((mesh, None))
}

fn convert(
    from: &Path,
    to: &Path,
    placing: &placing::Args,
    merge: Option<f64>,
    more: [(&str, &[String]); 2],
) -> Outcome {
    let placement = placing.placement()?;
    let (mut mesh, _) = load(from)?;
    if let Some(placement) = placement {
        placement.apply(&mut mesh);
        let (low, high) = mesh.bounds();
        let span = |i: usize| format!("{} from {:.6} to {:.6} m", ["x", "y", "z"][i], low[i], high[i]);
        say(&format!("placed: {}", [0, 1, 2].map(span).join(", ")));
    }
    if let Some(tolerance) = merge {
        let merged = merge_nodes(&mut mesh, tolerance).map_err(Failure::input)?;
        say(&format!("{merged} nodes merged"));
    }
    add(&mut mesh, more)?;
    save_mesh(&mesh, to)
}

/// Makes groups by place and linings of the keys that options give.
fn add(mesh: &mut Mesh, more: [(&str, &[String]); 2]) -> Result<(), Failure> {
    // As in a file that reads a mesh, so that keys and messages are the same.
    let mut text = "mesh.file.path = \"-\"\n".to_owned();
    for (key, options) in more.into_iter().filter(|(_, options)| !options.is_empty()) {
        let entries: Vec<String> = options.iter().map(|keys| format!("  {{ {keys} }},\n")).collect();
        text += &format!("mesh.{key} = [\n{}]\n", entries.concat());
    }
    let read = MeshAlone::parse(Path::new("the command's options"), &text).map_err(|r| Failure::case(&r))?;
    let Some(read) = read else { return Ok(()) };
    add_to_mesh(&read.mesh, &read.ground, mesh).map_err(|problems| Failure::case(&read.report(problems)))
}

fn cavern(what: &str, out: &Path) -> Outcome {
    let mesh = match what {
        "yingxiuwan" => CavernSpec::yingxiuwan().mesh().map_err(Failure::input)?,
        "yingxiuwan-fine" => CavernSpec::yingxiuwan_fine().mesh().map_err(Failure::input)?,
        case => load(Path::new(case))?.0,
    };
    save_mesh(&mesh, out)
}

fn save_mesh(mesh: &Mesh, path: &Path) -> Outcome {
    let notes = write(path, mesh).map_err(Failure::input)?;
    notes.iter().for_each(|note| say(&format!("note: {note}")));
    print(&format!("{}: {} elements, {} nodes", path.display(), mesh.elements.len(), mesh.nodes.len()));
    Ok(Code::Done)
}
