//! The problems, one a file.

use crate::Problem;

pub mod band_damping;
pub mod bar_step_wave;
pub mod cantilever_thin;
pub mod circular_opening;
pub mod concrete_biaxial;
pub mod concrete_fracture_energy;
pub mod concrete_loops;
pub mod concrete_rates;
pub mod concrete_triaxial;
pub mod concrete_uniaxial;
pub mod damping_ratio;
pub mod discrete_energy;
pub mod dispersion;
pub mod incident_pulse;
pub mod lamb;
pub mod layered_column;
pub mod macneal_harder_beam;
pub mod rock_strength;
pub mod scheme_literal;
pub mod strip_footing;
pub mod thick_cylinder;
pub mod time_order;

/// All problems, in the order in which they run: the scheme, waves, boundaries, elements, laws.
pub const PROBLEMS: &[Problem] = &[
    scheme_literal::PROBLEM,
    time_order::PROBLEM,
    discrete_energy::PROBLEM,
    damping_ratio::PROBLEM,
    band_damping::PROBLEM,
    dispersion::PROBLEM,
    bar_step_wave::PROBLEM,
    incident_pulse::PROBLEM,
    layered_column::PROBLEM,
    lamb::PROBLEM,
    macneal_harder_beam::PROBLEM,
    cantilever_thin::PROBLEM,
    thick_cylinder::PROBLEM,
    concrete_uniaxial::PROBLEM,
    concrete_triaxial::PROBLEM,
    concrete_rates::PROBLEM,
    concrete_biaxial::PROBLEM,
    concrete_loops::PROBLEM,
    concrete_fracture_energy::PROBLEM,
    rock_strength::PROBLEM,
    circular_opening::PROBLEM,
    strip_footing::PROBLEM,
];
