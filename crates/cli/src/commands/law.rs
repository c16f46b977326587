//! `tremolite law`: one material driven along a path of strain and stress.

mod figure;
mod path_file;
mod table;

use crate::exit::{Code, Failure, Outcome};
use crate::machine;
use crate::terminal::{colour, print, say};
use path_file::PathFile;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use tremolite_case::{LawFile, LawKind, Problem};
use tremolite_kernels::follow;
use tremolite_laws::materials::MATERIALS;
use tremolite_laws::path::{PathError, Response};
use tremolite_results::replace_file;

const HELP: &str = "\
LAW.toml holds one [material] as a case does; it needs no density. `size = \"0.5 m\"` gives the extent of the element
to laws with a fracture energy. `tremolite list materials` names all laws and their parameters.

P.csv has a line of names and one row a step, separated by commas, semicolons or tabs; lines that start with # are
remarks:
  time                       [s], not falling; where it stands still nothing has a rate
  exx eyy ezz gxy gyz gzx    strain, shear as the engineering angle (gxy = 2 exy); tension is positive
  sxx syy szz sxy syz szx    [Pa], in the place of the strain of that component: its stress is prescribed
Each component is prescribed once. A uniaxial test in x is time,exx,syy,szz,sxy,syz,szx with zeros below the stresses; for
a triaxial one syy and szz hold minus the cell pressure. A name may carry a unit: sxx [MPa]. The material is virgin at the
first row, which takes no time. An O.csv of a former run is a path as well: its strains are prescribed.

O.csv holds time, the six strains, the six stresses [Pa] and what the law keeps, by its names. Where no strain is found
for a prescribed stress, the step is gone in smaller ones, of strain and stress alike. Where the law's stress drops at
once, as concrete's when it is crushed, the damage of the next strain comes first and the sides follow; a note names the
lines. A step whose prescribed stress the material cannot carry ends with status 1; the rows before it are written.

  tremolite law concrete.toml --path cyclic.csv --divide 50 --out loops.csv --plot loops.svg";

#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Args {
    /// The material
    #[arg(value_name = "LAW.toml")]
    law: PathBuf,
    /// The path, row by row
    #[arg(long, value_name = "P.csv")]
    path: PathBuf,
    /// The answer as a table; without it and without --plot it goes to standard output
    #[arg(long, value_name = "O.csv")]
    out: Option<PathBuf>,
    /// The answer as a figure: stress over strain, and all that varies over time
    #[arg(long, value_name = "F.svg")]
    plot: Option<PathBuf>,
    /// Equal steps from each row of the path to the next
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    divide: u32,
    /// Force an instruction set: scalar, avx2 or avx512; each gives the same bits
    #[arg(long)]
    isa: Option<String>,
}

pub fn run(args: &Args) -> Outcome {
    let isa = machine::isa(args.isa.as_deref())?;
    let law = LawFile::read(&args.law, MATERIALS).map_err(|r| Failure::case(&r))?;
    if law.kind == LawKind::Interface {
        // The seam for interfaces, which is planned: a pair driven along gap and slip.
        let message = format!("the interface law `{}` cannot be driven alone yet", law.law.value);
        let problem = Problem::new(law.span.clone(), message, "give a [material] table");
        return Err(Failure::case(&law.report(vec![problem])));
    }
    args.check_files().map_err(Failure::input)?;
    let mut file = PathFile::read(&args.path).map_err(Failure::input)?;
    if !file.ignored.is_empty() {
        let (path, names) = (args.path.display(), file.ignored.join(", "));
        say(&format!(
            "{path}: {names} belong to an answer and are not read; what the path prescribes is the rest"
        ));
    }
    file.divide(args.divide).map_err(Failure::input)?;
    file.path.size = law.size.as_ref().map(|s| s.value);
    let name = law.law.value.as_str();
    let followed = follow::follow(name, &law.parameters, &file.path, isa);
    let (response, stop) = match followed {
        Ok(response) => (response, None),
        Err(PathError::NotConverged { row, miss }) => {
            let line = file.line(row);
            file.path.time.truncate(row);
            file.path.values.truncate(row);
            let before = follow::follow(name, &law.parameters, &file.path, isa);
            (before.map_err(|e| refused(&law, &e))?, Some((line, miss)))
        }
        Err(error) => return Err(refused(&law, &error)),
    };
    if args.plot.is_some() && stop.is_none() && file.path.time.len() < 2 {
        let what = "one row makes no figure; leave --plot out, or give more rows";
        return Err(Failure::input(format!("{}: {what}", args.path.display())));
    }
    for warning in follow::warnings(name, &law.parameters) {
        let problem = Problem::new(law.span.clone(), warning, "go on only if this is meant");
        say(&law.report(vec![problem]).as_warnings().render(colour()));
    }
    let defaults = law.defaulted.iter().filter_map(|d| {
        let key = d.key.strip_prefix("material.")?;
        law.parameters.0.contains_key(key).then(|| format!("{key} {}", d.value))
    });
    let defaults: Vec<String> = defaults.collect();
    if !defaults.is_empty() {
        say(&format!("by default: {}", defaults.join(", ")));
    }
    let jumps: BTreeSet<usize> =
        response.between.iter().filter(|b| b.jump).map(|b| file.line(b.row)).collect();
    if !jumps.is_empty() {
        let lines: Vec<String> = jumps.iter().map(usize::to_string).collect();
        say(&format!(
            "{}: the stress drops at once on the way to line {}; damage came first there, then the sides followed",
            args.path.display(),
            lines.join(", ")
        ));
    }
    write(args, name, &file.path.time, &response)?;
    match stop {
        None => Ok(Code::Done),
        Some((line, miss)) => Err(Failure::failed(format!(
            "{}, line {line}: no strain was found that gives the prescribed stress, {miss:.3e} Pa are missing, in \
             small steps either; the material may not carry it there: prescribe the strain",
            args.path.display()
        ))),
    }
}

impl Args {
    /// Refuses outputs that would destroy an input or each other, and figures under a name that says otherwise.
    fn check_files(&self) -> Result<(), String> {
        let inputs = [("LAW.toml", Some(&self.law)), ("--path", Some(&self.path))];
        let outputs = [("--out", self.out.as_ref()), ("--plot", self.plot.as_ref())];
        for (k, (name, output)) in outputs.iter().enumerate() {
            let Some(output) = output else { continue };
            for (other, file) in inputs.iter().chain(&outputs[..k]) {
                if file.is_some_and(|file| real(file) == real(output)) {
                    return Err(format!(
                        "{}: {name} would overwrite {other}, which is the same file; name another",
                        output.display()
                    ));
                }
            }
        }
        match &self.plot {
            Some(plot) if plot.extension().is_none_or(|e| !e.eq_ignore_ascii_case("svg")) => {
                Err(format!("{}: figures are SVG; let the name after --plot end in .svg", plot.display()))
            }
            _ => Ok(()),
        }
    }
}

/// A file without links and detours; of one that is not there yet, its folder without them.
fn real(file: &Path) -> PathBuf {
    file.canonicalize().unwrap_or_else(|_| {
        let folder = file.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        match (folder.canonicalize(), file.file_name()) {
            (Ok(folder), Some(name)) => folder.join(name),
            _ => file.to_owned(),
        }
    })
}

/// What the law refuses, at its place in the law file.
fn refused(law: &LawFile, error: &PathError) -> Failure {
    let problem = match error {
        PathError::SizeMissing => {
            let given = law.parameters.optional("fracture_energy").is_some();
            let from = law.parameters.word("grade").filter(|_| !given);
            let (of, instead) = from.map_or_else(Default::default, |grade| {
                (format!(", that of grade {grade},"), ", or ultimate_strain_ratio in place of the energy")
            });
            Problem::new(
                law.span.clone(),
                format!("the law goes by a fracture energy{of} and needs the element's extent"),
                format!("add size = \"… m\"{instead}"),
            )
        }
        PathError::Size { limit, .. } => Problem::new(
            law.size.as_ref().map_or_else(|| law.span.clone(), |s| s.span.clone()),
            format!(
                "`size` must be below {limit:.3} m, where an element stores as much as a crack dissipates"
            ),
            if *limit < 0.1 {
                "the limit is 2 G_f E/f_t²: E or G_f looks too low, or f_t too high, by its unit"
            } else {
                "give a smaller size, or a larger fracture energy"
            },
        ),
        other => return Failure::input(other),
    };
    Failure::case(&law.report(vec![problem]))
}

fn write(args: &Args, law: &str, time: &[f64], response: &Response) -> Result<(), Failure> {
    let put = |path: &Path, text: &str| replace_file(path, text.as_bytes()).map_err(Failure::failed);
    if let Some(plot) = args.plot.as_ref().filter(|_| time.len() > 1) {
        let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let title = format!("{law} ({}) along {}", name(&args.law), name(&args.path));
        put(plot, &figure::draw(&title, time, response))?;
    }
    match &args.out {
        Some(out) => put(out, &table::text(time, response)),
        None if args.plot.is_none() => {
            print(table::text(time, response).trim_end());
            Ok(())
        }
        None => Ok(()),
    }
}
