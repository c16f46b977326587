//! Relaxation of overstress after Duvaut and Lions, in laws that soften.

use crate::common::rock::*;
use tremolite_laws::materials::{HoekBrown, MohrCoulomb};
use tremolite_laws::{Material, Point, Softens, Values, virgin};

const C: f64 = 2e6;
const TAU: f64 = 1e-3;
const MU: f64 = YOUNG / (2.0 * (1.0 + POISSON));

fn cohesive() -> Values {
    mohr_coulomb(C, 0.0, 0.0, 1e9)
}

/// γ of shear at a step.
fn sheared(gamma: f64) -> [f64; 6] {
    [0.0, 0.0, 0.0, 0.0, 0.0, gamma]
}

#[test]
fn steady_shear_exceeds_the_strength_by_its_rate_times_the_viscosity() {
    let law = MohrCoulomb::new(&cohesive().with("relaxation_time", TAU)).unwrap();
    for dt in [1e-5, 1e-4, 3e-3] {
        let rate = 0.5;
        let mut history = virgin::<MohrCoulomb>();
        let mut stress = [0.0; 6];
        let steps = (30.0 * TAU / dt) as usize + 100;
        for k in 1..=steps {
            let strain = sheared(rate * dt * k as f64);
            (stress, history) = law.update(&Point::new(dt), strain, history);
        }
        assert!((stress[5] / (C + MU * TAU * rate) - 1.0).abs() < 1e-9, "{dt}: {}", stress[5]);
        // The plastic strain is what the stress leaves of the strain, and √J₂ is half of it.
        let plastic = rate * dt * steps as f64 - stress[5] / MU;
        assert!((2.0 * history[0] / plastic - 1.0).abs() < 1e-9, "{}", history[0]);
    }
}

#[test]
fn held_strain_relaxes_to_the_surface_at_the_rate_of_the_time_given() {
    let law = MohrCoulomb::new(&cohesive().with("relaxation_time", TAU)).unwrap();
    let dt = TAU / 50.0;
    let gamma = sheared(3.0 * C / MU);
    let mut history = virgin::<MohrCoulomb>();
    for k in 1..=200 {
        let stress;
        (stress, history) = law.update(&Point::new(dt), gamma, history);
        let exact = C + 2.0 * C * (1.0 + dt / TAU).powi(-k);
        assert!((stress[5] / exact - 1.0).abs() < 1e-9, "{k}: {} {exact}", stress[5]);
    }
}

/// Strains that yield in shear, in tension, and back.
const WALK: [[f64; 6]; 6] = [
    [-2e-4, -3e-4, -4e-4, 0.0, 0.0, 0.0],
    [1e-3, -3e-4, -6e-3, 2e-3, 0.0, 1e-3],
    [1e-3, 1e-3, -8e-3, 2e-3, 3e-3, -1e-3],
    [6e-3, 1e-3, 8e-3, 0.0, 3e-3, -1e-3],
    [6e-3, 1e-3, -2e-2, 0.0, 0.0, 4e-3],
    [0.0; 6],
];

/// Stresses along [`WALK`] with a step \[s\].
fn walk<M: Material>(law: &M, dt: f64) -> Vec<[f64; 6]> {
    let mut history = virgin::<M>();
    let step = |strain: &[f64; 6]| {
        let (stress, new) = law.update(&Point::new(dt), *strain, history);
        history = new;
        stress
    };
    WALK.iter().map(step).collect()
}

fn both(values: Values) -> [Values; 2] {
    [values.clone(), values.with("relaxation_time", TAU)]
}

fn softening() -> Values {
    let columns: [(&str, &[f64]); 2] = [("plastic_shear_strain", &[0.0, 0.01]), ("cohesion", &[C, 0.2 * C])];
    mohr_coulomb(C, 35.0, 10.0, 1e6).with_table("softening", &columns)
}

fn residual() -> Values {
    let columns: [(&str, &[f64]); 2] = [("gsi", &[30.0]), ("plastic_shear_strain", &[0.01])];
    rock(&[("compressive_strength", 80e6), ("gsi", 70.0), ("m_i", 15.0), ("dilation_angle", 0.1)])
        .with_table("residual", &columns)
}

#[test]
fn laws_lie_on_their_surface_while_time_stands_still_and_beyond_it_in_short_steps() {
    fn check<M: Material>([plain, relaxing]: [Values; 2]) {
        let [plain, relaxing] = [plain, relaxing].map(|values| M::new(&values).unwrap());
        let on_surface = walk(&plain, 0.0);
        assert_eq!(walk(&relaxing, 0.0), on_surface);
        assert_eq!(walk(&plain, 1e-4), on_surface);
        // Steps far longer than the relaxation time end on the surface, far shorter ones at the elastic stress.
        let largest = |a: &[[f64; 6]], b: &[[f64; 6]]| {
            a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        let scale = largest(&on_surface, &[[0.0; 6]; 6]);
        assert!(largest(&walk(&relaxing, 1e9 * TAU), &on_surface) < 1e-6 * scale);
        let moduli = plain.moduli();
        let elastic = WALK.map(|e| {
            let mean = moduli.lambda * (e[0] + e[1] + e[2]);
            [0, 1, 2, 3, 4, 5].map(|k| if k < 3 { mean + 2.0 * moduli.mu * e[k] } else { moduli.mu * e[k] })
        });
        assert!(largest(&walk(&relaxing, 1e-9 * TAU), &elastic) < 1e-6 * scale);
        assert!(largest(&walk(&relaxing, TAU), &on_surface) > 0.1 * scale);
    }
    check::<MohrCoulomb>(both(softening()));
    check::<HoekBrown>(both(residual()));
}

#[test]
fn a_relaxing_band_grows_by_the_slope_of_the_strength_over_the_shear_strain() {
    let law = MohrCoulomb::new(&softening().with("relaxation_time", TAU)).unwrap();
    // c cos φ falls by 0.8 C cos φ over γ = 2 Γ.
    let slope = 0.8 * C * 35f64.to_radians().cos() / 0.02;
    let Softens::Relaxing(time) = law.softens() else { panic!("{:?}", law.softens()) };
    assert!((time / (TAU * MU / slope) - 1.0).abs() < 1e-12, "{time}");
    assert!(law.warnings().is_empty(), "{:?}", law.warnings());
    let rock_mass = HoekBrown::new(&residual().with("relaxation_time", TAU)).unwrap();
    assert!(matches!(rock_mass.softens(), Softens::Relaxing(time) if time > 0.0 && time.is_finite()));
    assert!(rock_mass.warnings().is_empty());
    let softens = |values: &Values| MohrCoulomb::new(values).unwrap().softens();
    assert_eq!(softens(&softening()), Softens::OverStrain);
    assert_eq!(softens(&mohr_coulomb(C, 35.0, 0.0, 0.0).with("relaxation_time", TAU)), Softens::Never);
}

#[test]
fn relaxation_times_that_cannot_be_used_are_refused_by_key() {
    fn faults<M: Material>(values: Values) -> Vec<&'static str> {
        M::new(&values).map_or_else(|faults| faults.iter().map(|fault| fault.name).collect(), |_| Vec::new())
    }
    assert_eq!(faults::<MohrCoulomb>(softening().with("relaxation_time", 0.0)), ["relaxation_time"]);
    assert_eq!(faults::<HoekBrown>(residual().with("relaxation_time", -TAU)), ["relaxation_time"]);
    let columns: [(&str, &[f64]); 2] =
        [("plastic_shear_displacement", &[0.0, 0.01]), ("cohesion", &[C, 0.2 * C])];
    let slips =
        mohr_coulomb(C, 35.0, 0.0, 0.0).with_table("softening", &columns).with("relaxation_time", TAU);
    assert_eq!(faults::<MohrCoulomb>(slips), ["relaxation_time"]);
    let columns: [(&str, &[f64]); 2] = [("gsi", &[30.0]), ("plastic_shear_displacement", &[0.01])];
    let slips =
        rock(&[("compressive_strength", 80e6), ("gsi", 70.0), ("m_i", 15.0), ("relaxation_time", TAU)]);
    assert_eq!(faults::<HoekBrown>(slips.with_table("residual", &columns)), ["relaxation_time"]);
}
