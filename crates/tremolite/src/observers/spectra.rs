//! Response spectra at the end, from the histories that were written.

use super::free_field::chosen;
use super::observer::{Event, Observer, Setting, Wants};
use crate::error::RunError;
use crate::plan::Plan;
use crate::spectra;
use std::sync::Arc;
use tremolite_engine::state::Memory;
use tremolite_results::ResultFolder;

/// Writes spectra.csv.
pub struct Spectra {
    folder: ResultFolder,
    plan: Arc<Plan>,
    /// The column that stands for the free field.
    column: Option<String>,
}

impl Spectra {
    /// Nothing where no wave comes in.
    pub fn new(setting: &Setting) -> Option<Self> {
        let Setting { folder, model, plan, .. } = *setting;
        plan.shaken_by(model)?;
        let column = chosen(model, plan).map(|(column, _)| model.outside.columns[column].name.clone());
        Some(Spectra { folder: folder.clone(), plan: plan.clone(), column })
    }
}

impl Observer for Spectra {
    fn wants(&self) -> Wants {
        Wants::default()
    }

    fn told(&mut self, event: &Event, _: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::End { .. } => spectra::write(&self.folder, &self.plan, self.column.as_deref()),
            _ => Ok(()),
        }
    }
}
