//! `tremolite mesh`: look at meshes, convert them, make them.

use super::infos;
use crate::exit::{Code, Failure, Outcome};
use crate::terminal::{print, say};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use tremolite::setup::mesh_of;
use tremolite_case::Case;
use tremolite_laws::Moduli;
use tremolite_laws::shapes::hex8::element_frequencies;
use tremolite_mesh::cavern::CavernSpec;
use tremolite_mesh::merge::{coincident_nodes, merge_nodes, shortest_edge};
use tremolite_mesh::picture::{section, view};
use tremolite_mesh::quality::{Summary, by_group, summary};
use tremolite_mesh::topology::{components, plane_faces};
use tremolite_mesh::{Mesh, read_with_notes, write};

#[derive(clap::Args)]
pub struct Args {
    #[command(subcommand)]
    action: Action,
}

#[derive(clap::Subcommand)]
enum Action {
    /// Counts, sizes, quality, stable step, boundary faces, separate parts
    Info {
        /// A mesh in any supported format, or a case
        file: PathBuf,
        /// Draw the section at y = 0 (or the middle) as SVG
        #[arg(long)]
        section: Option<PathBuf>,
        /// Draw a view in three dimensions as SVG
        #[arg(long)]
        view: Option<PathBuf>,
        /// P-wave speed for the stable step, in m/s
        #[arg(long, default_value_t = 2088.0)]
        p_wave: f64,
        #[arg(long)]
        json: bool,
    },
    /// Write a mesh in another format, by the ending of the new name: vtu, msh or inp
    Convert {
        from: PathBuf,
        to: PathBuf,
        /// Merge nodes that lie within this distance, in m
        #[arg(long)]
        merge: Option<f64>,
    },
    /// Make the mesh of a case's [mesh.caverns], or of a preset, and write it
    Cavern {
        /// A case, or one of yingxiuwan and yingxiuwan-fine
        what: String,
        /// The file to write: vtu, msh or inp
        #[arg(long)]
        out: PathBuf,
    },
}

pub fn run(args: &Args) -> Outcome {
    match &args.action {
        Action::Info { file, section, view, p_wave, json } => {
            info(file, section.as_deref(), view.as_deref(), *p_wave, *json)
        }
        Action::Convert { from, to, merge } => convert(from, to, *merge),
        Action::Cavern { what, out } => cavern(what, out),
    }
}

/// A mesh from a mesh file or from a case; what was done to it on the way goes to the terminal.
fn load(file: &Path) -> Result<Mesh, Failure> {
    if file.extension().is_some_and(|e| e == "toml") {
        let case = Case::read(file, &infos()).map_err(|r| Failure::case(&r))?;
        return mesh_of(&case).map_err(|r| Failure::case(&r));
    }
    let (mesh, notes) = read_with_notes(file).map_err(Failure::input)?;
    notes.iter().for_each(|note| say(&format!("note: {note}")));
    Ok(mesh)
}

fn info(file: &Path, section_to: Option<&Path>, view_to: Option<&Path>, p_wave: f64, json: bool) -> Outcome {
    if !(p_wave.is_finite() && p_wave > 0.0) {
        return Err(Failure::input("--p-wave is a speed in m/s, such as 2088"));
    }
    let mesh = load(file)?;
    let mut types: BTreeMap<&str, usize> = BTreeMap::new();
    for element in &mesh.elements {
        *types.entry(element.shape.name()).or_default() += 1;
    }
    let whole = summary(&mesh);
    let groups = by_group(&mesh);
    let (low, high) = mesh.bounds();
    if json {
        let counts: BTreeMap<&str, usize> = mesh.groups.iter().map(|(n, e)| (n.as_str(), e.len())).collect();
        let object = serde_json::json!({
            "nodes": mesh.nodes.len(),
            "elements": types,
            "groups": counts,
            "volume": whole.volume,
            "min_scaled_jacobian": whole.min_scaled_jacobian,
            "bounds": [low, high],
            "shortest_edge": whole.shortest_edge,
            "longest_edge": whole.longest_edge,
        });
        print(&object.to_string());
    } else {
        let shapes: Vec<String> = types.iter().map(|(name, count)| format!("{count} {name}")).collect();
        print(&format!("{}, {} nodes", shapes.join(", "), mesh.nodes.len()));
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            print(&format!("  {name} from {:.3} to {:.3} m", low[axis], high[axis]));
        }
        print(&format!(
            "\n{:30} {:>9} {:>13} {:>9} {:>17} {:>8} {:>12}",
            "group", "elements", "volume [m3]", "Jacobian", "edges [m]", "aspect", "step [s]"
        ));
        let everything: Vec<u32> = (0..mesh.elements.len() as u32).collect();
        row("(all)", &whole, step(&mesh, &everything, p_wave));
        for (name, of) in &groups {
            row(name, of, step(&mesh, &mesh.groups[*name], p_wave));
        }
        print(&format!("  step: of the stiffest element alone, for c_p = {p_wave} m/s and ν = 0.25"));
        topology(&mesh);
    }
    let middle = if low[1] < 0.0 && high[1] > 0.0 { 0.0 } else { 0.5 * (low[1] + high[1]) };
    if let Some(path) = section_to {
        save(path, &section(&mesh, middle, None))?;
    }
    if let Some(path) = view_to {
        save(path, &view(&mesh, None))?;
    }
    Ok(Code::Done)
}

fn row(name: &str, of: &Summary, step: Option<f64>) {
    let edges = format!("{:.3} to {:.3}", of.shortest_edge, of.longest_edge);
    let step = step.map_or("-".to_owned(), |s| format!("{s:.3e}"));
    print(&format!(
        "{name:30} {:>9} {:>13.1} {:>9.3} {edges:>17} {:>8.1} {step:>12}",
        of.elements, of.volume, of.min_scaled_jacobian, of.max_aspect
    ));
}

/// 2/ω of the stiffest of some elements alone \[s\]; nothing if one of them cannot be used.
fn step(mesh: &Mesh, elements: &[u32], p_wave: f64) -> Option<f64> {
    // With ρ = 1 and ν = 1/4, λ = μ = c_p²/3.
    let moduli = Moduli { lambda: p_wave * p_wave / 3.0, mu: p_wave * p_wave / 3.0 };
    let hexes: Vec<_> =
        elements.iter().map(|&e| tremolite::model::hex(mesh, e as usize)).collect::<Result<_, _>>().ok()?;
    let highest = element_frequencies(&hexes, moduli, 1.0, false).into_iter().fold(0.0, f64::max);
    (highest > 0.0).then(|| 2.0 / highest)
}

fn topology(mesh: &Mesh) {
    let (low, high) = mesh.bounds();
    let near = 1e-6 * (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
    print("\nfaces on the outer planes");
    for (name, faces) in plane_faces(mesh, near) {
        print(&format!("  {name:28} {:>9}", faces.len()));
    }
    if !mesh.faces.is_empty() {
        print("named faces");
        for (name, faces) in &mesh.faces {
            print(&format!("  {name:28} {:>9}", faces.len()));
        }
    }
    let parts = components(mesh, None);
    print(&format!("{} separate part{}", parts.len(), if parts.len() == 1 { "" } else { "s" }));
    let tolerance = 1e-4 * shortest_edge(mesh);
    let pairs = coincident_nodes(mesh, tolerance).len();
    if pairs > 0 {
        print(&format!(
            "{pairs} nodes lie within {tolerance:.1e} m of another: `tremolite mesh convert … --merge {tolerance:.1e}` joins them"
        ));
    }
}

fn convert(from: &Path, to: &Path, merge: Option<f64>) -> Outcome {
    let mut mesh = load(from)?;
    if let Some(tolerance) = merge {
        let merged = merge_nodes(&mut mesh, tolerance).map_err(Failure::input)?;
        say(&format!("{merged} nodes merged"));
    }
    save_mesh(&mesh, to)
}

fn cavern(what: &str, out: &Path) -> Outcome {
    let mesh = match what {
        "yingxiuwan" => CavernSpec::yingxiuwan().mesh().map_err(Failure::input)?,
        "yingxiuwan-fine" => CavernSpec::yingxiuwan_fine().mesh().map_err(Failure::input)?,
        case => load(Path::new(case))?,
    };
    save_mesh(&mesh, out)
}

fn save_mesh(mesh: &Mesh, path: &Path) -> Outcome {
    let notes = write(path, mesh).map_err(Failure::input)?;
    notes.iter().for_each(|note| say(&format!("note: {note}")));
    print(&format!("{}: {} elements, {} nodes", path.display(), mesh.elements.len(), mesh.nodes.len()));
    Ok(Code::Done)
}

fn save(path: &Path, text: &str) -> Result<(), Failure> {
    std::fs::write(path, text).map_err(|e| Failure::failed(format!("{}: {e}", path.display())))
}
