//! A material along a path of strain and stress.

mod figure;

use super::Kind;
use super::columns::{Form, MATERIAL};
use super::path_file::PathFile;
use super::table;
use crate::exit::Failure;
use std::collections::BTreeSet;
use std::iter::once;
use std::mem::take;
use tremolite_case::{Diagnostic, LawFile};
use tremolite_kernels::follow;
use tremolite_laws::Isa;
use tremolite_laws::materials::MATERIALS;
use tremolite_laws::path::{Control, Path, PathError, Response};
use tremolite_results::Column;

pub struct Material;

/// Whether a fracture energy says how the law softens.
fn cracks(law: &LawFile) -> bool {
    MATERIALS.iter().any(|known| known.name == law.law.value && known.damages)
}

impl Kind<6> for Material {
    const FORM: &'static Form<6> = &MATERIAL;
    type Response = Response;

    fn follow(law: &LawFile, file: &mut PathFile<6>, isa: Isa) -> Result<Response, PathError> {
        let path = Path {
            time: take(&mut file.time),
            values: take(&mut file.values),
            control: file.by_stress.map(|stress| if stress { Control::Stress } else { Control::Strain }),
            size: law.size.as_ref().map(|s| s.value),
        };
        let followed = follow::follow(&law.law.value, &law.parameters, &path, isa);
        (file.time, file.values) = (path.time, path.values);
        followed
    }

    fn warnings(law: &LawFile) -> Vec<String> {
        follow::warnings(&law.law.value, &law.parameters)
    }

    fn note(file: &PathFile<6>, response: &Response) -> Option<String> {
        let jumps = response.between.iter().filter(|b| b.jump).map(|b| file.line(b.row));
        let lines: Vec<String> = jumps.collect::<BTreeSet<_>>().iter().map(usize::to_string).collect();
        (!lines.is_empty()).then(|| {
            format!(
                "the stress drops at once on the way to line {}; damage came first there, then the sides followed",
                lines.join(", ")
            )
        })
    }

    fn refused(law: &LawFile, error: &PathError) -> Failure {
        let problem = match error {
            PathError::SizeMissing => {
                let given = law.parameters.optional("fracture_energy").is_some();
                let from = law.parameters.word("grade").filter(|_| !given);
                let (of, instead) = from.map_or_else(Default::default, |grade| {
                    (
                        format!(", that of grade {grade},"),
                        ", or evolution = \"residual\" and ultimate_strain_ratio in place of the energy",
                    )
                });
                Diagnostic::new(
                    law.span.clone(),
                    match cracks(law) {
                        true => {
                            format!("the law goes by a fracture energy{of} and needs the element's extent")
                        }
                        false => {
                            "the law softens over displacement and needs the element's extent".to_owned()
                        }
                    },
                    format!("add size = \"… m\"{instead}"),
                )
            }
            PathError::Size { limit, .. } => Diagnostic::new(
                law.size.as_ref().map_or_else(|| law.span.clone(), |s| s.span.clone()),
                format!(
                    "`size` must be below {limit:.3} m, where an element stores as much energy as it dissipates"
                ),
                match (cracks(law), *limit < 0.1) {
                    (true, true) => {
                        "the limit is 2 G_f E/f_t²: E or G_f looks too low, or f_t too high, by its unit"
                    }
                    (true, false) => "give a smaller size, or a larger fracture energy",
                    (false, _) => "give a smaller size, or a longer plastic displacement",
                },
            ),
            other => return Failure::input(other),
        };
        Failure::case(&law.report(vec![problem]))
    }

    fn not_converged(miss: f64) -> String {
        format!(
            "no strain was found that gives the prescribed stress, {miss:.3e} Pa are missing, in small steps either; \
             the material may not carry it there: prescribe the strain"
        )
    }

    fn table(time: &[f64], response: &Response) -> String {
        let columns = once(Column::new("time", "s"))
            .chain(MATERIAL.motions().map(|name| Column::new(name, "")))
            .chain(MATERIAL.stresses().map(|name| Column::new(name, "Pa")))
            .chain(response.columns.iter().map(table::of_history));
        let rows = time.iter().enumerate().map(|(row, t)| {
            let values = once(*t).chain(response.strain[row]).chain(response.stress[row]);
            values.chain(response.history.iter().map(move |column| column[row]))
        });
        table::text(columns, rows)
    }

    fn figure(title: &str, time: &[f64], response: &Response) -> String {
        figure::draw(title, time, response)
    }
}
