//! The data lines of elements.

use super::deck::{Deck, Label};
use super::kinds::{Kind, fewest};
use super::model::{Model, Section};
use super::part::{Flat, set};
use crate::assembly::numbered;
use crate::fault::Fault;

impl Model {
    /// A line of an element, which may need several.
    pub(super) fn element(
        &mut self,
        deck: &Deck,
        name: &str,
        kind: &Kind,
        group: Option<&Label>,
    ) -> Result<(), Fault> {
        let others = matches!(kind, Kind::Other | Kind::Flat { .. });
        for field in deck.fields() {
            match deck.number(field, "a number of an element or node") {
                Ok(number) => self.pending.push(number),
                // Other elements may have anything after their number.
                Err(_) if others && !self.pending.is_empty() => {}
                Err(fault) => return Err(fault),
            }
        }
        let wanted = match kind {
            Kind::Solid { nodes, .. } => fewest(*nodes),
            Kind::Flat { corners } => *corners,
            _ => 0,
        };
        let fixed = matches!(kind, Kind::Solid { nodes, .. } if fewest(*nodes) == *nodes);
        if self.pending.len() <= wanted || (!fixed && deck.goes_on()) {
            return Ok(());
        }
        let numbers = std::mem::take(&mut self.pending);
        let (number, nodes) = (numbers[0], &numbers[1..]);
        match kind {
            Kind::Solid { shape, nodes: most } => {
                // C3D15V has up to three nodes more than its name says.
                let most = if *most == 15 { 18 } else { *most };
                if nodes.len() > most {
                    let problem =
                        format!("element {number} of type {name} has {} nodes, expected {most}", nodes.len());
                    return Err(deck.fault(problem));
                }
                let solid =
                    numbered(*shape, &nodes[..shape.nodes()]).map_err(|problem| deck.fault(problem))?;
                self.draft.reduce(nodes.len(), *shape);
                let part = self.part();
                part.solid_numbers.push(number);
                part.solids.push(solid);
            }
            Kind::Flat { corners } => {
                let corners = nodes[..*corners].to_vec();
                self.part().flats.push(Flat { number, corners });
            }
            _ => {
                self.draft.skip(&format!("elements of type {name}"), 1);
                self.part().others.push(number);
            }
        }
        if let Some(label) = group {
            set(&mut self.part().elsets, label.clone(), false).push(None, number, deck.line_number());
        }
        self.pending = numbers;
        self.pending.clear();
        Ok(())
    }

    /// Checks that no element was left half.
    pub(super) fn complete(&mut self, deck: &Deck) -> Result<(), Fault> {
        let Some(&number) = self.pending.first() else { return Ok(()) };
        if let Section::Elements { name, kind: Kind::Other, .. } = &self.section {
            // Its last line ended with a comma.
            self.draft.skip(&format!("elements of type {name}"), 1);
            self.part().others.push(number);
            self.pending.clear();
            return Ok(());
        }
        Err(deck.fault(format!(
            "element {number} before this line has too few nodes; the file is cut short or damaged"
        )))
    }
}
