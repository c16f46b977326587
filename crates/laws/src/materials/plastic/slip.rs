//! Softening over displacement: the slip of a shear band and the opening of a crack across an element.
//!
//! An element of extent h in which the strain localises represents a band. The sides of the band slip along each other by 2hΓ, where Γ is
//! the plastic shear strain (√J₂, half the engineering shear of a band without dilation), and a crack opens by h ε_t. Strengths that
//! depend on these displacements dissipate one energy per area in elements of any size, as the crack band of concrete does
//! (`bazant1983`).
//!
//! The extent h of the slip is that along the direction in which the displacement of the element varies
//! ([`Point::extent_across_band`]); that of an opening lies along the largest principal stress.

use super::{COLUMNS, Memory, SHEAR, TENSION};
use crate::lane::Lane;
use crate::material::{Facts, Material, Point};
use crate::parameter::{Column, Derived, Role};

/// History of a point with displacements behind the columns of all plastic laws, in the order of [`LONG_COLUMNS`].
pub(in crate::materials) type LongMemory<L> = [L; 12];

/// Columns that a law without softening over displacement keeps.
pub(in crate::materials) const SHORT: usize = COLUMNS.len();
const SLIP: usize = SHORT;
const OPENING: usize = SHORT + 1;

pub(in crate::materials) const LONG_COLUMNS: [Column; 12] = {
    let mut all = [COLUMNS[0]; 12];
    let mut k = 0;
    while k < SHORT {
        all[k] = COLUMNS[k];
        k += 1;
    }
    all[SLIP] = Column::with_role(
        "plastic_shear_displacement",
        "m",
        Role::Own,
        "accumulated slip across the element, twice its extent times the plastic shear strain",
    );
    all[OPENING] = Column::with_role(
        "plastic_tension_displacement",
        "m",
        Role::Own,
        "accumulated opening across the element, its extent times the plastic tension strain",
    );
    all
};

/// What strengths depend on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::materials) enum Measure {
    /// Plastic strains: results depend on the size of the elements.
    Strain,
    /// Displacements \[m\].
    Displacement,
}

impl Measure {
    /// The measures of shear and of tension after what a point went through.
    #[inline(always)]
    pub fn of<L: Lane>(self, memory: &LongMemory<L>) -> [L; 2] {
        match self {
            Measure::Strain => [memory[SHEAR], memory[TENSION]],
            Measure::Displacement => [memory[SLIP], memory[OPENING]],
        }
    }

    /// A history whose measures of shear and of tension are these, and all else 0.
    pub fn memory(self, shear: f64, tension: f64) -> LongMemory<f64> {
        let mut memory = [0.0; 12];
        let at = match self {
            Measure::Strain => [SHEAR, TENSION],
            Measure::Displacement => [SLIP, OPENING],
        };
        (memory[at[0]], memory[at[1]]) = (shear, tension);
        memory
    }
}

/// Names of a table's measures of shear and of tension.
pub(in crate::materials) const STRAINS: [&str; 2] = ["plastic_shear_strain", "plastic_tension_strain"];
pub(in crate::materials) const DISPLACEMENTS: [&str; 2] =
    ["plastic_shear_displacement", "plastic_tension_displacement"];

/// The columns that an instance keeps.
#[inline(always)]
pub(in crate::materials) fn columns(slips: bool) -> &'static [Column] {
    const SHORT_COLUMNS: &[Column] = &COLUMNS;
    const ALL: &[Column] = &LONG_COLUMNS;
    if slips { ALL } else { SHORT_COLUMNS }
}

/// [`Material::facts`] of an instance that keeps displacements, or does not.
#[inline(always)]
pub(in crate::materials) fn facts<M: Material>(slips: bool) -> Facts {
    Facts {
        columns: columns(slips).len(),
        needs_size: slips,
        damages: M::DAMAGES,
        dissipation: M::DISSIPATION,
        creation: M::CREATION,
    }
}

/// The limit of an element's size, where there is one.
pub(in crate::materials) fn derived(limit: f64) -> Option<Derived> {
    let doc = "extent that elements must stay below, or they give out energy as they soften";
    limit.is_finite().then(|| Derived::new("size_limit", limit, "m", doc))
}

/// The columns that all plastic laws have.
#[inline(always)]
pub(in crate::materials) fn short<L: Lane>(memory: &LongMemory<L>) -> Memory<L> {
    let mut short = [memory[0]; SHORT];
    let mut k = 1;
    while k < SHORT {
        short[k] = memory[k];
        k += 1;
    }
    short
}

/// New columns, with the displacements of an old history.
#[inline(always)]
pub(in crate::materials) fn kept<L: Lane>(new: &Memory<L>, old: &LongMemory<L>) -> LongMemory<L> {
    let mut memory = *old;
    let mut k = 0;
    while k < SHORT {
        memory[k] = new[k];
        k += 1;
    }
    memory
}

/// New columns, with displacements that have grown as the plastic strains have; `first` is the direction of the largest principal
/// stress.
#[inline(always)]
pub(in crate::materials) fn advanced<L: Lane>(
    point: &Point<L>,
    first: &[L; 3],
    new: &Memory<L>,
    old: &LongMemory<L>,
) -> LongMemory<L> {
    let zero = L::splat(0.0);
    let mut memory = kept(new, old);
    let (sheared, opened) = (new[SHEAR] - old[SHEAR], new[TENSION] - old[TENSION]);
    let slip = (L::splat(2.0) * point.extent_across_band()).mul_add(sheared, old[SLIP]);
    let opening = point.extent(first).mul_add(opened, old[OPENING]);
    // A strain that is no number makes an extent that is none: it must not enter the memory.
    memory[SLIP] = L::select(zero.less(sheared), slip, old[SLIP]);
    memory[OPENING] = L::select(zero.less(opened), opening, old[OPENING]);
    memory
}

/// A stage of softening, from one state of the strength to the next, as the limit of an element's size sees it.
#[derive(Clone, Copy, Debug)]
pub(in crate::materials) struct Fall {
    /// What the axial strength in triaxial compression loses \[Pa\], at whatever confinement it loses most.
    pub shear: f64,
    /// k of the strength before.
    pub slope: f64,
    /// Slip \[m\], or plastic shear strain, over which it does.
    pub slip: f64,
    /// M of the flow, the larger of both states.
    pub flow: f64,
    /// What f_t loses \[Pa\], and the opening \[m\] over which it does, if it goes by that.
    pub tension: Option<[f64; 2]>,
}

/// The extent \[m\] of an element that softens without giving out energy, in compression or tension along its axis with sides that are
/// free to move: infinite where nothing softens.
///
/// Along the axis a plastic shortening λ adds 2hλ√((M² + M + 1)/3) to the slip, so that the stress falls by 2h√((M² + M + 1)/3) |σ′| λ,
/// σ′ the slope over the slip. The element shortens further where that is below E λ; an opening falls by h|f_t′|.
pub(in crate::materials) fn size_limit(young: f64, falls: impl Iterator<Item = Fall>) -> f64 {
    falls.fold(f64::INFINITY, |limit, fall| {
        let m = fall.flow;
        let root = ((m * m + m + 1.0) / 3.0).sqrt();
        let of_shear =
            if fall.shear > 0.0 { young * fall.slip / (2.0 * root * fall.shear) } else { f64::INFINITY };
        let of_tension = fall.tension.filter(|[lost, _]| *lost > 0.0);
        let of_tension = of_tension.map_or(f64::INFINITY, |[lost, opening]| young * opening / lost);
        limit.min(of_shear).min(of_tension)
    })
}

/// What is said of softening over strain without a relaxation time.
pub(in crate::materials) fn without_length(key: &str) -> String {
    format!(
        "{key} over plastic strain has no length: the slip depends on the element size. Add relaxation_time = \"1 ms\" for \
         earthquakes, or give `plastic_shear_displacement` for stages."
    )
}
