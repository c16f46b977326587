//! `tremolite law`: one law driven along a path: a material's of strain and stress, an interface's of gap and slip.

mod columns;
mod figure;
mod interface;
mod material;
mod path_file;
mod table;

use crate::exit::{Code, Failure, Outcome};
use crate::machine;
use crate::terminal::{colour, print, say};
use columns::Form;
use interface::Interface;
use material::Material;
use path_file::PathFile;
use std::path::{Path, PathBuf};
use tremolite_case::{Diagnostic, LawFile, LawKind};
use tremolite_laws::Isa;
use tremolite_laws::materials::MATERIALS;
use tremolite_laws::path::PathError;
use tremolite_results::replace_file;

const HELP: &str = "\
LAW.toml holds one [material] or one [interface] as a case does; a material needs no density, an interface has no name
and no sides. `size = \"0.5 m\"` gives the extent of the element to laws with a fracture energy. `tremolite list
materials` and `tremolite list interfaces` name all laws and their parameters.

P.csv has a line of names and one row a step, separated by commas, semicolons or tabs; lines that start with # are
remarks. A name may carry a unit: sxx [MPa], gap [mm].
  time                       [s], not falling; where it stands still nothing has a rate
For a material
  exx eyy ezz gxy gyz gzx    strain, shear as the engineering angle (gxy = 2 exy); tension is positive
  sxx syy szz sxy syz szx    [Pa], in the place of the strain of that component: its stress is prescribed
For an interface, whose laws know no time
  gap                        [m], positive when open; closed under pressure it is negative
  pressure                   [Pa], in the place of the gap: it is prescribed; compression is positive
  slip1 slip2                [m], along two tangents

Each component is prescribed once. A uniaxial test in x is time,exx,syy,szz,sxy,syz,szx with zeros below the stresses; for
a triaxial one syy and szz hold minus the cell pressure; a shear test at constant pressure is time,pressure,slip1,slip2. The
material is virgin at the first row, which takes no time, and the pair just made. An O.csv of a former run is a path as
well: its strains, or gap and slip, are prescribed.

O.csv holds time, the six strains, the six stresses [Pa] and what the law keeps, by its names; of an interface time, gap,
slip1 and slip2, then pressure, shear1 and shear2 [Pa] along the slip that caused them, state (0 bonded, 1 stuck, 2 sliding,
3 open) and the rest that the law keeps.

Where no strain is found for a prescribed stress, the step is gone in smaller ones, of strain and stress alike. Where the
law's stress drops at once, as concrete's when it is crushed, the damage of the next strain comes first and the sides
follow; a note names the lines. A step whose prescribed stress or pressure the law cannot carry ends with status 1; the rows
before it are written.

  tremolite law concrete.toml --path cyclic.csv --divide 50 --out loops.csv --plot loops.svg
  tremolite law joint.toml --path shear.csv --divide 200 --plot joint.svg";

#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Args {
    /// The material or interface
    #[arg(value_name = "LAW.toml")]
    law: PathBuf,
    /// The path, row by row
    #[arg(long, value_name = "P.csv")]
    path: PathBuf,
    /// The answer as a table; without it and without --plot it goes to standard output
    #[arg(long, value_name = "O.csv")]
    out: Option<PathBuf>,
    /// The answer as a figure: stress over strain, or pressure over closure and shear over slip, and all that varies over
    /// time
    #[arg(long, value_name = "F.svg")]
    plot: Option<PathBuf>,
    /// Equal steps from each row of the path to the next
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    divide: u32,
    /// Force an instruction set: scalar, avx2 or avx512; each gives the same bits
    #[arg(long)]
    isa: Option<String>,
}

/// What sets one kind of law and its paths of `N` components apart.
trait Kind<const N: usize> {
    const FORM: &'static Form<N>;
    type Response;

    /// The answer; `file` is as before behind it.
    fn follow(law: &LawFile, file: &mut PathFile<N>, isa: Isa) -> Result<Self::Response, PathError>;

    /// What is unusual about the parameters.
    fn warnings(law: &LawFile) -> Vec<String>;

    /// What is to be said of an answer.
    fn note(_file: &PathFile<N>, _response: &Self::Response) -> Option<String> {
        None
    }

    /// What the law refuses, at its place in the law file.
    fn refused(_law: &LawFile, error: &PathError) -> Failure {
        Failure::input(error)
    }

    /// What is said of a prescribed stress of which so much is missing \[Pa\].
    fn not_converged(miss: f64) -> String;

    fn table(time: &[f64], response: &Self::Response) -> String;

    fn figure(title: &str, time: &[f64], response: &Self::Response) -> String;
}

pub fn run(args: &Args) -> Outcome {
    let isa = machine::isa(args.isa.as_deref())?;
    let law = LawFile::read(&args.law, MATERIALS).map_err(|r| Failure::case(&r))?;
    args.check_files().map_err(Failure::input)?;
    match law.kind {
        LawKind::Material => drive::<6, Material>(args, &law, isa),
        LawKind::Interface => drive::<3, Interface>(args, &law, isa),
    }
}

fn drive<const N: usize, K: Kind<N>>(args: &Args, law: &LawFile, isa: Isa) -> Outcome {
    let mut file = PathFile::read(&args.path, K::FORM).map_err(Failure::input)?;
    let path = args.path.display();
    if !file.ignored.is_empty() {
        let names = file.ignored.join(", ");
        say(&format!(
            "{path}: {names} belong to an answer and are not read; what the path prescribes is the rest"
        ));
    }
    file.divide(args.divide).map_err(Failure::input)?;
    let (response, stop) = match K::follow(law, &mut file, isa) {
        Ok(response) => (response, None),
        Err(PathError::NotConverged { row, miss }) => {
            let line = file.line(row);
            file.truncate(row);
            let before = K::follow(law, &mut file, isa);
            (before.map_err(|e| K::refused(law, &e))?, Some((line, miss)))
        }
        Err(error) => return Err(K::refused(law, &error)),
    };
    if args.plot.is_some() && stop.is_none() && file.time.len() < 2 {
        return Err(Failure::input(format!(
            "{path}: one row makes no figure; leave --plot out, or give more rows"
        )));
    }
    for warning in K::warnings(law) {
        let problem = Diagnostic::new(law.span.clone(), warning, "go on only if this is meant");
        say(&law.report(vec![problem]).as_warnings().render(colour()));
    }
    say_defaults(law);
    if let Some(note) = K::note(&file, &response) {
        say(&format!("{path}: {note}"));
    }
    let figure = |title: &str| K::figure(title, &file.time, &response);
    let drawable = file.time.len() > 1;
    args.write(law, drawable.then_some(figure), || K::table(&file.time, &response))?;
    match stop {
        None => Ok(Code::Done),
        Some((line, miss)) => {
            Err(Failure::failed(format!("{path}, line {line}: {}", K::not_converged(miss))))
        }
    }
}

/// What stands for parameters that were left out.
fn say_defaults(law: &LawFile) {
    let defaults = law.defaulted.iter().filter_map(|d| {
        let key = d.key.strip_prefix(law.kind.word())?.strip_prefix('.')?;
        law.parameters.0.contains_key(key).then(|| format!("{key} {}", d.value))
    });
    let defaults: Vec<String> = defaults.collect();
    if !defaults.is_empty() {
        say(&format!("by default: {}", defaults.join(", ")));
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

    /// Writes what was asked for; without a figure there is too little to draw.
    fn write(
        &self,
        law: &LawFile,
        figure: Option<impl Fn(&str) -> String>,
        table: impl Fn() -> String,
    ) -> Result<(), Failure> {
        let put = |path: &Path, text: &str| replace_file(path, text.as_bytes()).map_err(Failure::failed);
        if let (Some(plot), Some(figure)) = (&self.plot, figure) {
            let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            let title = format!("{} ({}) along {}", law.law.value, name(&self.law), name(&self.path));
            put(plot, &figure(&title))?;
        }
        match &self.out {
            Some(out) => put(out, &table()),
            None if self.plot.is_none() => {
                print(table().trim_end());
                Ok(())
            }
            None => Ok(()),
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
