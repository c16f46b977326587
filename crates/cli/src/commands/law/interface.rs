//! A pair of an interface along a path of gap, or pressure, and slip.

mod figure;

use super::Kind;
use super::columns::{Form, INTERFACE};
use super::path_file::PathFile;
use super::table;
use std::iter::once;
use std::mem::take;
use tremolite_case::LawFile;
use tremolite_kernels::follow;
use tremolite_laws::Isa;
use tremolite_laws::interface_path::{Across, InterfacePath, InterfaceResponse};
use tremolite_laws::path::PathError;
use tremolite_results::Column;

pub struct Interface;

impl Kind<3> for Interface {
    const FORM: &'static Form<3> = &INTERFACE;
    type Response = InterfaceResponse;

    fn follow(law: &LawFile, file: &mut PathFile<3>, isa: Isa) -> Result<InterfaceResponse, PathError> {
        let path = InterfacePath {
            time: take(&mut file.time),
            values: take(&mut file.values),
            across: if file.by_stress[0] { Across::Pressure } else { Across::Gap },
        };
        let followed = follow::follow_interface(&law.law.value, &law.parameters, &path, isa);
        (file.time, file.values) = (path.time, path.values);
        followed
    }

    fn warnings(law: &LawFile) -> Vec<String> {
        follow::interface_warnings(&law.law.value, &law.parameters)
    }

    fn not_converged(miss: f64) -> String {
        format!(
            "no gap was found that gives the prescribed pressure, {miss:.3e} Pa are missing; a pair carries tension up to \
             that of its bond, and none once that is broken: prescribe the gap"
        )
    }

    fn table(time: &[f64], response: &InterfaceResponse) -> String {
        let others = || (0..response.columns.len()).filter(|k| *k != response.state);
        let columns = once(Column::new("time", "s"))
            .chain(INTERFACE.motions().map(|name| Column::new(name, "m")))
            .chain(INTERFACE.stresses().map(|name| Column::new(name, "Pa")))
            .chain(once(Column::new("state", "")))
            .chain(others().map(|k| table::of_history(&response.columns[k])));
        let rows = time.iter().enumerate().map(|(row, t)| {
            let motion = once(response.gap[row]).chain(response.slip[row]);
            let stress = once(response.pressure[row]).chain(response.shear[row]);
            let history = once(response.state).chain(others()).map(move |k| response.history[k][row]);
            once(*t).chain(motion).chain(stress).chain(history)
        });
        table::text(columns, rows)
    }

    fn figure(title: &str, time: &[f64], response: &InterfaceResponse) -> String {
        figure::draw(title, time, response)
    }
}
