//! Observers that look at each node and element by itself: of several ranks each has its own part of them, and what they keep stays there
//! until somebody reads it.

use super::observer::{Keeps, MakeObserver, Observer, Setting, View, Wants};
use crate::error::RunError;
use std::sync::Arc;
use tremolite_engine::Ranks;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::model::Model;
use tremolite_engine::ranks::Marks;
use tremolite_engine::state::Memory;

/// A rank's part of them.
#[derive(Default)]
pub(crate) struct Apart {
    all: Vec<(Box<dyn Observer>, Wants)>,
    /// What they keep of this rank's nodes and elements.
    kept: Memory,
}

impl Apart {
    /// Those that have something to see. The setting's phase is what the rank has of it; what of the memory they keep they take to themselves.
    ///
    /// # Errors
    /// None: they have no files.
    pub fn of(
        makers: &[Arc<MakeObserver>],
        setting: &Setting,
        memory: &mut Memory,
    ) -> Result<Self, RunError> {
        let mut all = Vec::new();
        for make in makers {
            all.extend(make(setting)?.map(|observer| {
                let wants = observer.wants();
                (observer, wants)
            }));
        }
        let mut apart = Apart { all, kept: Memory::default() };
        for (name, keeps) in apart.columns() {
            if let Some(whole) = memory.remove(&name) {
                let own = match keeps {
                    Keeps::Nodes => whole,
                    Keeps::Elements => own(setting.assembly, &whole),
                };
                apart.kept.insert(name, own);
            }
        }
        Ok(apart)
    }

    fn columns(&self) -> Vec<(String, Keeps)> {
        self.all.iter().flat_map(|(_, wants)| wants.keeps.iter().cloned()).collect()
    }

    /// What they want, as if they were on the first rank.
    pub fn wants(&self) -> impl Iterator<Item = &Wants> {
        self.all.iter().map(|(_, wants)| wants)
    }

    /// Shows a step to those who look at it: what this rank has of it.
    ///
    /// # Errors
    /// None: they have no files.
    pub fn look(&mut self, step: u64, view: &View) -> Result<(), RunError> {
        for (observer, _) in self.all.iter_mut().filter(|(_, wants)| wants.look_at(step)) {
            observer.told(&super::Event::Look(*view), &mut self.kept)?;
        }
        Ok(())
    }

    /// Gives the first rank's memory what all ranks keep. All ranks call it together.
    pub fn lend(&self, ranks: &Ranks, model: &Model, assembly: &Assembly, memory: &mut Memory) {
        let mut letter = ranks.letter();
        let there = || self.columns().into_iter().filter(|(name, _)| self.kept.contains_key(name));
        for (name, keeps) in there() {
            match keeps {
                Keeps::Nodes => letter.nodes(model, &Marks::All, &self.kept[&name], 1),
                Keeps::Elements => {
                    let of = (assembly, &Marks::All);
                    letter.members(of, &self.kept[&name], 1, |s| s.elements.clone());
                }
            }
        }
        let Some(mut arrived) = letter.send() else { return };
        for (name, keeps) in there() {
            let whole = match keeps {
                Keeps::Nodes => {
                    let mut whole = vec![0.0; model.nodes.len()];
                    arrived.numbers_of_nodes(model, &Marks::All, &mut whole);
                    whole
                }
                Keeps::Elements => {
                    let mut whole = vec![0.0; assembly.totals().elements.end];
                    let of = (assembly, &Marks::All);
                    arrived.members(of, &mut whole, 1, |s| s.elements.clone());
                    whole
                }
            };
            memory.insert(name, whole);
        }
    }

    /// Takes it out again, so that nobody reads there what is old.
    pub fn take_back(&self, memory: &mut Memory) {
        self.columns().iter().for_each(|(name, _)| {
            memory.remove(name);
        });
    }
}

/// Numbers of this rank's elements, out of those of all.
fn own(assembly: &Assembly, whole: &[f64]) -> Vec<f64> {
    let mut own = vec![0.0; assembly.held_totals().elements.end];
    for (m, (all, held)) in assembly.slices.iter().zip(&assembly.held).enumerate() {
        if assembly.has(m) {
            own[held.elements.clone()].copy_from_slice(&whole[all.elements.clone()]);
        }
    }
    own
}
