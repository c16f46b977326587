//! Adds to a model the ground outside its sides, with all that is said of what it is made of.

use super::Draft;
use crate::boundary::{Base, Boundaries};
use crate::column::{self, Ground, Reference};
use crate::error::ModelError;
use crate::interface::Interface;
use crate::life::{Life, Stage};
use crate::model::{Elements, Outside};
use crate::seams::{self, Standing, place_lives};
use crate::slabs::{Inside, Slabs};

/// The ground along the model's four vertical edges, or why no reference column is made of it.
pub(super) type Grounds = Result<[Ground; 4], String>;

/// Smallest and largest coordinates \[m\].
type Bounds = ([f64; 3], [f64; 3]);

impl Draft {
    /// The ground that reference columns are made of in the shaking, before interfaces part the mesh.
    pub fn grounds(&self, asked: &Boundaries, interfaces: &[Interface]) -> Grounds {
        let absorbs = matches!(asked.base, Base::Viscous | Base::ViscousSpring { .. });
        if asked.free_field.is_some() {
            Err("the free field is given".to_owned())
        } else if absorbs && asked.free_sides() != [true; 2] {
            let Elements { body_of, lives, .. } = &self.elements;
            let there =
                body_of.iter().zip(lives).map(|(body, life)| body.filter(|_| life.holds(Stage::Shaking)));
            column::grounds(&self.mesh, &self.bodies, &there.collect::<Vec<_>>(), interfaces, lives)
        } else if asked.free_sides() == [true; 2] {
            Err("the slabs have columns of their own".to_owned())
        } else {
            Err("no wave enters through an absorbing base".to_owned())
        }
    }

    /// Adds slabs and columns, and says how many bodies there are without those of columns. `bounds` are the model's own, and
    /// `sides` the elements on both sides of its interfaces.
    ///
    /// # Errors
    /// If a free-field side has no ground that could stand outside it, or springs of the base have no column.
    pub fn add_outside(
        &mut self,
        asked: &Boundaries,
        bounds: Bounds,
        sides: Vec<[Vec<u32>; 2]>,
        grounds: Grounds,
    ) -> Result<(Outside, usize), ModelError> {
        let mut slabs = self.slabs(asked, bounds)?;
        if !self.seams.is_empty() {
            self.part_slabs(&mut slabs, sides)?;
        }
        slabs.press(&self.mesh, &mut self.tractions);
        let elements = &self.elements;
        let slab_bodies = slabs.fill(&self.mesh, &mut self.bodies, &elements.body_of, &elements.lives);
        let Slabs { slabs, columns, parents } = slabs;
        self.elements.parents = parents;
        let mut outside = Outside { slabs, columns, no_column: String::new() };
        match grounds {
            Ok(grounds) => self.add_columns(&mut outside, grounds, bounds),
            Err(reason) => {
                let all_free = asked.free_sides() == [true; 2] || asked.free_field.is_some();
                if asked.base.has_springs() && !all_free {
                    return Err(column::refusal(&reason));
                }
                outside.no_column = reason;
            }
        }
        Ok((outside, slab_bodies))
    }

    /// The elements outside all free-field sides, which are what those are that they are made of.
    fn slabs(&mut self, asked: &Boundaries, bounds: Bounds) -> Result<Slabs, ModelError> {
        let elements = &mut self.elements;
        let sides = asked.free_sides().map(|side| side && asked.free_field.is_none());
        let inside = Inside { bounds, body_of: &elements.body_of, lives: &elements.lives, sides };
        let slabs = Slabs::beside(&mut self.mesh, &inside)?;
        slabs.spread(&mut elements.lives);
        slabs.spread(&mut elements.initial);
        slabs.spread_pairs(&mut elements.successors);
        Ok(slabs)
    }

    /// Lets the interfaces of the model run on through slabs.
    fn part_slabs(&mut self, outside: &mut Slabs, sides: Vec<[Vec<u32>; 2]>) -> Result<(), ModelError> {
        let Draft { mesh, elements, seams, parted, origin, .. } = self;
        let pair_lives = place_lives(&elements.lives, &elements.successors);
        let sides: Vec<[Vec<u32>; 2]> = sides.into_iter().map(|sides| sides.map(ascending)).collect();
        outside.origins(mesh, origin);
        let parents = &outside.parents;
        let solid = |e: u32| elements.body_of[parents[e as usize] as usize].is_some();
        let standing = Standing {
            solid: &solid,
            lives: &pair_lives,
            successors: &elements.successors,
            initial: &elements.initial,
        };
        let mut more = Vec::new();
        for slab in &outside.slabs {
            let alone = outside.standing_alone(slab);
            let (own, held) = seams::outside(mesh, origin, &alone, parents, &sides, seams, standing)?;
            more.extend(own);
            parted.joints.extend(held);
        }
        seams::keep_sides(mesh, &elements.successors);
        outside.mark_parted(&more);
        for seam in &more {
            let own = seam.of.map(|of| &mut seams[of].pressure);
            own.into_iter().for_each(|pressure| *pressure = pressure.max(seam.pressure));
        }
        seams.extend(more);
        Ok(())
    }

    /// Adds reference columns of the ground along the model's vertical edges.
    fn add_columns(&mut self, outside: &mut Outside, grounds: [Ground; 4], bounds: Bounds) {
        let first = self.mesh.elements.len();
        let Reference { columns, like } = column::build(&mut self.mesh, &mut self.bodies, grounds, bounds);
        let elements = &mut self.elements;
        elements.columns = first..self.mesh.elements.len();
        elements.lives.resize(self.mesh.elements.len(), Life::ALWAYS);
        column::press(&self.mesh, &mut self.tractions, &columns, bounds.1[2], &like);
        if !elements.initial.is_empty() {
            let beside: Vec<_> = like.iter().map(|&e| elements.initial[e as usize]).collect();
            elements.initial.extend(beside);
        }
        elements.parents.extend(like);
        outside.columns.extend(columns);
    }
}

fn ascending(mut elements: Vec<u32>) -> Vec<u32> {
    elements.sort_unstable();
    elements
}
