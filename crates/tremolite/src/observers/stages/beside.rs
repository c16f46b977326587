//! What stages change of the stress beside the outer planes, where ground goes on that is not in the model.

use super::super::observer::{Event, Observer, Setting, View, Wants, Which};
use crate::error::RunError;
use crate::near_sides::openings;
use crate::point_stress::mean;
use tremolite_engine::Stage;
use tremolite_engine::state::Memory;

/// Keys of what is remembered: the stress beside each face of the outer planes before anything is taken out, and by plane the
/// largest change of it so far; behind these the mean size of that stress along the openings.
const BEFORE: &str = "stress beside the outer planes";
const CHANGE: &str = "change of stress beside the outer planes";

/// Follows the stress beside the outer planes and at the openings' walls.
pub struct BesidePlanes;

impl BesidePlanes {
    /// Nothing without initial stress.
    pub fn new(setting: &Setting) -> Option<Self> {
        (!setting.model.elements.initial.is_empty()).then_some(BesidePlanes)
    }
}

impl Observer for BesidePlanes {
    fn wants(&self) -> Wants {
        Wants { elements: Which::All, ..Wants::default() }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        if let Event::StageEnds(seen) = event
            && seen.at_rest
        {
            memory.extend(Beside::of(&seen.view, memory, seen.stage == 0));
        }
        Ok(())
    }
}

/// Change of stress beside the outer planes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beside {
    /// √(Δσ:Δσ) \[Pa\], the largest along each plane: low and high end of x, y, z.
    pub change: [f64; 6],
    /// √(σ₀:σ₀) \[Pa\], the mean over the elements at the openings' walls.
    pub initial: f64,
}

impl Beside {
    /// What is to be remembered of a stage that came to rest, by its keys. The first of them begins with the initial equilibrium, or
    /// with the stress that was given where an opening is there from the start.
    fn of(view: &View, memory: &Memory, first: bool) -> Vec<(String, Vec<f64>)> {
        if !first {
            let (Some(before), Some(kept)) = (memory.get(BEFORE), memory.get(CHANGE)) else {
                return Vec::new();
            };
            return vec![(
                CHANGE.to_owned(),
                largest(view, before).into_iter().chain(kept[6..].iter().copied()).collect(),
            )];
        }
        let given = !openings(view.model, Stage::Before(0)).is_empty();
        let before = |element: u32| match given {
            true => view.model.elements.initial.get(element as usize).copied(),
            false => stress(view, element),
        };
        // Where a lining will be, of what is there now.
        let place = |element: u32| match view.model.standing_at(element as usize, Stage::Before(0)) {
            Some(there) => there as u32,
            None => std::iter::successors(Some(element), |e| view.model.elements.successors.get(e).copied())
                .last()
                .unwrap_or(element),
        };
        let beside: Vec<f64> =
            faces(view).flat_map(|(_, element)| before(element).unwrap_or([f64::NAN; 6])).collect();
        let walls = openings(view.model, Stage::Shaking).into_iter().flat_map(|opening| opening.walls);
        let sizes: Vec<f64> = walls.map(place).filter_map(before).map(size).collect();
        let initial = sizes.iter().sum::<f64>() / sizes.len() as f64;
        let change = largest(view, &beside).into_iter().chain([initial]).collect();
        vec![(BEFORE.to_owned(), beside), (CHANGE.to_owned(), change)]
    }

    /// What was remembered; none without initial stress or before the initial equilibrium.
    pub fn recall(memory: &Memory) -> Option<Self> {
        match memory.get(CHANGE)?[..] {
            [a, b, c, d, e, f, initial] => Some(Beside { change: [a, b, c, d, e, f], initial }),
            _ => None,
        }
    }
}

/// The largest change along each plane \[Pa\] since what was before, face by face.
fn largest(view: &View, before: &[f64]) -> [f64; 6] {
    let mut most = [0.0_f64; 6];
    for ((plane, element), before) in faces(view).zip(before.as_chunks::<6>().0) {
        let Some(now) = stress(view, element) else { continue };
        let change = size([0, 1, 2, 3, 4, 5].map(|c| now[c] - before[c]));
        // Of what is installed later nothing was known.
        if change.is_finite() {
            most[plane] = most[plane].max(change);
        }
    }
    most
}

/// The elements behind the faces of the outer planes, plane by plane.
fn faces<'a>(view: &View<'a>) -> impl Iterator<Item = (usize, u32)> + 'a {
    let planes = view.model.faces.planes.iter().flatten().enumerate();
    planes.flat_map(|(plane, faces)| faces.iter().map(move |face| (plane, face.element)))
}

/// The mean stress of an element \[Pa\], where it stands.
fn stress(view: &View, element: u32) -> Option<[f64; 6]> {
    let slot = (*view.phase.element_slot.get(element as usize)?)?;
    Some(mean(&slot.places, &view.snapshot.stress[slot.point as usize..][..slot.points as usize]))
}

/// √(σ:σ).
fn size(s: [f64; 6]) -> f64 {
    let [xx, yy, zz, xy, yz, zx] = s.map(|x| x * x);
    (xx + yy + zz + 2.0 * (xy + yz + zx)).sqrt()
}
