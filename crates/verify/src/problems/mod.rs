//! The problems, one a file.

use crate::Verification;

macro_rules! problems {
    ($($name:ident $effort:ident,)*) => {
        $(pub mod $name;)*

        /// All problems, in the order in which they run: the scheme, waves, boundaries, elements, laws, interfaces,
        /// stages, bolts, tests of specimens.
        pub const PROBLEMS: &[Verification] = &[$($name::PROBLEM),*];

        /// The file of each, whose head says what is verified and how: formula, model, errors.
        pub(crate) const FILES: &[&str] = &[$(include_str!(concat!(stringify!($name), ".rs"))),*];

        #[cfg(test)]
        mod tests {
            use crate::tests::passes;
            use crate::{Effort, PROBLEMS};

            $(problems!(@test $name $effort);)*

            #[test]
            fn every_problem_has_the_name_of_its_file_and_begins_where_the_list_says() {
                let listed = [$((stringify!($name), Effort::$effort)),*];
                assert!(PROBLEMS.iter().map(|p| (p.name, p.from)).eq(listed));
            }
        }
    };
    (@test $name:ident Test) => {
        #[test]
        fn $name() {
            passes(stringify!($name));
        }
    };
    (@test $name:ident Verify) => {};
    (@test $name:ident Full) => {};
}

// A problem's file, and the effort at which it begins: one of the tests is a test by this line.
problems! {
    scheme_literal Test,
    time_order Test,
    discrete_energy Test,
    levels_energy Test,
    damping_ratio Test,
    band_damping Test,
    dispersion Test,
    bar_step_wave Test,
    incident_pulse Test,
    layered_column Test,
    layer_transfer Test,
    recorded_motion Test,
    oblique_waves Test,
    oblique_unbounded Verify,
    free_field_tunnel Test,
    mirror_image Test,
    box_size Verify,
    lamb Verify,
    cavity_sines Test,
    lined_cavity_sines Verify,
    cavity_step Verify,
    oblique_cavity Verify,
    canyon Verify,
    macneal_harder_beam Test,
    cantilever_thin Test,
    bending_strips Test,
    skew_plate Test,
    twisted_beam Test,
    pinched_ring Test,
    pinched_cylinder Test,
    pinched_hemisphere Test,
    thick_cylinder Test,
    concrete_uniaxial Test,
    concrete_triaxial Test,
    concrete_rates Test,
    concrete_biaxial Test,
    concrete_loops Test,
    concrete_fracture_energy Test,
    crack_direction Verify,
    crack_width Test,
    rock_strength Test,
    circular_opening Verify,
    strip_footing Verify,
    interface_waves Test,
    bars_collide Test,
    block_on_slope Verify,
    sliding_block Test,
    oblique_joint Test,
    contact_cycles Verify,
    interface_ring Test,
    interface_bonded Test,
    interface_fault Test,
    loaded_interface Test,
    wet_joint Test,
    undrained_waves Test,
    undrained_books Test,
    planes_at_rest Test,
    hand_over_wave Test,
    gravity_column Test,
    kirsch_hole Test,
    excavated_opening Verify,
    undrained_cavern Verify,
    wet_opening Verify,
    finite_cavern Verify,
    lined_tunnel Verify,
    shotcrete_ring Verify,
    free_field_hand_over Test,
    release_ramp Verify,
    bolt_pull_out Test,
    bolt_across_interface Test,
    bolt_pretension Verify,
    bolted_tunnel Test,
    bolted_wave Test,
    l_panel Verify,
    half_notched_beam Verify,
    mixed_mode_beam Verify,
    askew_crack Verify,
    willam_rotating_strain Verify,
    modulus_of_rupture Verify,
    tension_stiffening Verify,
    ring_line_load Verify,
}
