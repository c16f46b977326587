//! The figure of the interface laws.

use super::{curve, draw, plane, ramp, stress, values};
use tremolite_laws::interface_path::{Across, InterfacePath, InterfaceResponse, drive_interface};
use tremolite_laws::interfaces::{Bandis, Coulomb};
use tremolite_laws::{BadParameter, Interface};
use tremolite_report::loops::{Curve, Quantity};

/// The joint of these figures: k_n0 = 20 GPa/m and, of a hyperbola, T = 0.5 mm.
fn joint<I: Interface>(numbers: &[(&str, f64)]) -> I {
    let values =
        values(&[&[("normal_stiffness", 20e9), ("friction_coefficient", 0.7)], numbers].concat(), &[]);
    I::new(&values).unwrap_or_else(|faults: Vec<BadParameter>| panic!("{}: {faults:?}", I::NAME))
}

const CLOSURE: (&str, f64) = ("max_closure", 0.5e-3);

fn pair<I: Interface>(law: &I, across: Across, values: Vec<[f64; 3]>) -> InterfaceResponse {
    let path = InterfacePath { time: vec![0.0; values.len()], values, across };
    drive_interface(law, &path).unwrap_or_else(|e| panic!("{e}"))
}

/// Pressure over closure as long as it stays below 60 MPa.
fn closing<I: Interface>(name: &str, colour: usize, law: &I) -> Curve<'static> {
    let closed = pair(law, Across::Gap, ramp(0.0, -0.45e-3, 450).map(|g| [g, 0.0, 0.0]).collect());
    let rows = closed.gap.iter().zip(&closed.pressure).map(|(g, p)| [-g, *p]);
    curve(name, colour, rows.take_while(|[_, p]| *p <= 60e6).collect::<Vec<_>>())
}

/// Shear over slip at a pressure, out and back beyond the start.
fn sheared(name: &str, colour: usize, pressure: f64) -> Curve<'static> {
    let law: Bandis = joint(&[CLOSURE, ("cohesion", 1e6)]);
    let slips = [0.0, 0.6e-3, -0.3e-3];
    let slips = slips.windows(2).flat_map(|leg| ramp(leg[0], leg[1], 900));
    let test = pair(&law, Across::Pressure, slips.map(|s| [pressure, s, 0.0]).collect());
    curve(name, colour, test.slip.iter().zip(&test.shear).map(|(s, t)| [s[0], t[0]]))
}

pub fn figure() -> String {
    // The least floor that a law takes is as good as none here.
    let hyperbola: Bandis = joint(&[CLOSURE, ("closure_floor", 1e-3)]);
    let closures = vec![
        closing("hyperbola", 3, &hyperbola),
        closing("bandis", 0, &joint::<Bandis>(&[CLOSURE])),
        closing("with p*", 1, &joint::<Bandis>(&[CLOSURE, ("pressure_for_step", 10e6)])),
        closing("linear", 2, &joint::<Coulomb>(&[])),
    ];
    let shears = vec![sheared("at 1 MPa", 0, 1e6), sheared("at 3 MPa", 1, 3e6)];
    let planes = vec![
        plane(Quantity::new("closure", "m"), stress("pressure"), closures),
        plane(Quantity::new("slip", "m"), stress("shear"), shears),
    ];
    draw("Joints: k_n0 = 20 GPa/m, T = 0.5 mm; sheared with c = 1 MPa, μ = 0.7", planes)
}
