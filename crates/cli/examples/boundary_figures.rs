//! Draws the figures of docs/boundaries.md: `cargo run --release -p tremolite-cli --example boundary_figures`.
//!
//! Dashpots and springs are those that the engine makes of a case's base; [`figures`] and [`rows`] have what the page shows,
//! and a test compares them with it.

use std::path::Path as File;
use tremolite::problem::Rayleigh;
use tremolite::waves::surface::coefficients;
use tremolite::waves::{Rock, WaveType};
use tremolite::{Base, Side};
use tremolite_case::{Base as Given, Case};
use tremolite_laws::materials::MATERIALS;
use tremolite_report::loops::{Curve, Loops, Named, Plane, Quantity};
use tremolite_verify::VerifyError;
use tremolite_verify::box_size::{DISTANCES, FAR, FREQUENCIES, RockMass, shake};
use tremolite_verify::reflection::{Boundary, Medium, Reflection, Solid, Wave, of_base};

fn main() -> std::io::Result<()> {
    let folder = File::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/boundaries");
    for (name, svg) in figures() {
        std::fs::write(folder.join(name), svg)?;
    }
    rows().iter().for_each(|row| println!("{row}"));
    // Runs that take too long for a test; `tremolite verify box_size` has the same numbers.
    let boxes = boxes().map_err(std::io::Error::other)?;
    std::fs::write(folder.join(BOXES), draw_boxes(&boxes))?;
    boxes.iter().for_each(|of| println!("{}", of.row()));
    Ok(())
}

/// Every figure with the name of its file.
pub fn figures() -> Vec<(&'static str, String)> {
    vec![
        ("reflected-waves.svg", reflected_waves()),
        ("reflected-energy.svg", reflected_energy()),
        ("surface-motion.svg", surface_motion()),
    ]
}

/// Distance R of the springs \[m\]. It and the ground's speed cancel: what counts is ωR/c_s.
const DISTANCE: f64 = 100.0;

/// Ground and its boundary.
struct Edge {
    ground: Medium,
    boundary: Boundary,
}

impl Edge {
    fn new(poisson: f64, base: Base) -> Edge {
        let solid = Solid::from_shear_speed(1200.0, poisson, 2700.0);
        let boundary = of_base(solid, base).unwrap_or_else(|e| panic!("{e}"));
        Edge { ground: Medium::of(solid), boundary }
    }

    /// What is sent back of a wave at so many degrees from the normal, at a frequency given as ωR/c_s.
    fn back(&self, wave: Wave, degrees: f64, ratio: f64) -> Reflection {
        let frequency = ratio * self.ground.speeds.1 / DISTANCE;
        self.ground.reflection(&self.boundary, wave, degrees.to_radians(), frequency)
    }
}

/// The base with springs of the coefficients that a case has which does not give them.
fn springs() -> Base {
    let source = include_str!("../src/commands/new_case.toml").replace("\"viscous\"", "\"viscous-spring\"");
    let case = Case::parse(File::new("case.toml"), &source, MATERIALS).unwrap_or_else(|e| panic!("{e}"));
    match &case.dynamic.base.value {
        Given::ViscousSpring { normal, tangential, .. } => Base::ViscousSpring {
            normal: normal.value,
            tangential: tangential.value,
            distance: Some(DISTANCE),
        },
        other => panic!("the base of the new case has no springs: {other:?}"),
    }
}

/// From the normal to just short of the grazing wave, in degrees.
fn degrees() -> impl Iterator<Item = f64> {
    (0..=360).map(|quarter| (0.25 * f64::from(quarter)).min(90.0 - 1e-6))
}

fn curve<'a>(name: &str, colour: usize, up: impl Fn(f64) -> f64) -> Curve<'a> {
    let up: Vec<f64> = degrees().map(up).collect();
    let across: Vec<f64> = degrees().collect();
    Curve { name: name.into(), colour, across: across.into(), up: up.into(), points: false }
}

/// A plane for each wave that comes in.
fn draw<'a>(title: &str, curves: impl Fn(Wave) -> Vec<Curve<'a>>) -> String {
    let plane = |(wave, name)| Plane {
        across: Quantity::new("angle from the normal in degrees", ""),
        up: Quantity::new(name, ""),
        curves: curves(wave),
        named: Named::Nothing,
    };
    Loops {
        title: title.into(),
        along: Quantity::new("", ""),
        time: &[],
        planes: [(Wave::P, "P comes in"), (Wave::Sv, "SV comes in")].map(plane).into(),
        tracks: vec![],
        states: None,
    }
    .draw()
}

/// From this colour on those of the first lines come again, dashed.
const DASHED: usize = 7;

fn reflected_waves() -> String {
    let edges = [("P", "SV", 0.25, 0), ("P, ν 0.4", "SV, ν 0.4", 0.4, DASHED)];
    draw(
        "Dashpots: displacement of the waves sent back, over that of the wave that comes in; ν = 0.25",
        |wave| {
            let of = edges.map(|(p, sv, poisson, colour)| {
                let edge = Edge::new(poisson, Base::Viscous);
                // A P wave that clings to the boundary is none that runs back.
                let runs = |at: f64| wave == Wave::P || at.to_radians() < edge.ground.critical();
                let amplitude = |at: f64| if runs(at) { edge.back(wave, at, 1.0).p.norm() } else { f64::NAN };
                [curve(p, colour, amplitude), curve(sv, colour + 1, |at| edge.back(wave, at, 1.0).sv.norm())]
            });
            of.into_iter().flatten().collect()
        },
    )
}

fn reflected_energy() -> String {
    let bare = [("dashpots", 0.25, 0), ("ν 0.4", 0.4, DASHED)];
    draw(
        "Share of the energy sent back: dashpots, ν = 0.25; numbers: with springs, at that ωR/c_s",
        |wave| {
            let dashpots = bare.map(|(name, poisson, colour)| {
                let edge = Edge::new(poisson, Base::Viscous);
                curve(name, colour, |at| edge.back(wave, at, 1.0).energy)
            });
            let edge = Edge::new(0.25, springs());
            let sprung = [("5", 5.0, 1), ("2", 2.0, 2), ("1", 1.0, 4)]
                .map(|(name, ratio, colour)| curve(name, colour, |at| edge.back(wave, at, ratio).energy));
            dashpots.into_iter().chain(sprung).collect()
        },
    )
}

/// What a surface of bare rock shows of a wave that comes up at an angle.
fn surface_motion() -> String {
    let rocks = [("", 0.25, 0), (", ν 0.4", 0.4, DASHED)];
    draw("Largest displacement of bare rock over that of the wave that comes up; ν = 0.25", |wave| {
        let kind = if wave == Wave::P { WaveType::P } else { WaveType::Sv };
        let of = rocks.map(|(name, poisson, colour)| {
            let (p, s) = Edge::new(poisson, Base::Viscous).ground.speeds;
            let rock = Rock { density: 2700.0, p, s, band: None, rayleigh: Rayleigh::default(), water: None };
            [(0, "along the ground"), (2, "up")].map(|(part, part_name)| {
                curve(&format!("{part_name}{name}"), colour + part / 2, move |at| {
                    coefficients(kind, at.to_radians(), &rock)[part].norm()
                })
            })
        });
        of.into_iter().flatten().collect()
    })
}

/// The rows of the page's table: the share of the energy that is sent back.
pub fn rows() -> Vec<String> {
    let bare = [0.25, 0.4].map(|poisson| Edge::new(poisson, Base::Viscous));
    let sprung = Edge::new(0.25, springs());
    let row = |degrees: f64| {
        let share =
            |edge: &Edge, wave, ratio| format!("{:.1} %", 100.0 * edge.back(wave, degrees, ratio).energy);
        let columns = [(&bare[0], 1.0), (&bare[1], 1.0), (&sprung, 5.0), (&sprung, 1.0)];
        let shares =
            columns.map(|(edge, ratio)| [Wave::P, Wave::Sv].map(|wave| share(edge, wave, ratio)).join(" | "));
        format!("| {degrees:.0}° | {} |", shares.join(" | "))
    };
    [0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 85.0].map(row).into()
}

/// The figure of boxes of several widths.
pub const BOXES: &str = "box-size.svg";

/// One ground and pulse in boxes of several widths, over that in a box twice as wide as the widest.
struct Boxes {
    ground: &'static str,
    frequency: f64,
    /// Difference of the walls' peak displacement, and the largest at any time, by [`DISTANCES`].
    free_field: Vec<[f64; 2]>,
    /// Of the peaks, with periodic sides.
    periodic: Vec<f64>,
}

impl Boxes {
    fn row(&self) -> String {
        let of = |[peaks, times]: &[f64; 2]| format!("{:.1} / {:.1} %", 100.0 * peaks, 100.0 * times);
        let shares: Vec<String> = self.free_field.iter().map(of).collect();
        format!("| {}, {} Hz | {} |", self.ground, self.frequency, shares.join(" | "))
    }
}

fn boxes() -> Result<Vec<Boxes>, VerifyError> {
    let mut all = Vec::new();
    for (kind, ground) in [(RockMass::Elastic, "elastic"), (RockMass::Yielding, "yielding layer")] {
        for frequency in FREQUENCIES {
            let far = shake(kind, Side::FreeField, FAR, frequency)?;
            let apart = |side, widths| -> Result<[f64; 2], VerifyError> {
                Ok(shake(kind, side, widths, frequency)?.apart(&far))
            };
            let free_field =
                DISTANCES.iter().map(|&widths| apart(Side::FreeField, widths)).collect::<Result<_, _>>()?;
            let periodic = DISTANCES
                .iter()
                .map(|&widths| apart(Side::Periodic, widths))
                .collect::<Result<Vec<_>, _>>()?;
            let periodic = periodic.into_iter().map(|[peaks, _]: [f64; 2]| peaks).collect();
            all.push(Boxes { ground, frequency, free_field, periodic });
        }
    }
    Ok(all)
}

fn draw_boxes(all: &[Boxes]) -> String {
    let across: Vec<f64> = DISTANCES.iter().map(|&widths| f64::from(widths)).collect();
    let line = |name: String, colour: usize, up: Vec<f64>| Curve {
        name,
        colour,
        across: across.clone().into(),
        up: up.into(),
        points: false,
    };
    let plane = |(ground, name): (&str, &str)| Plane {
        across: Quantity::new("distance of the sides in widths of the cavern", ""),
        up: Quantity::new(name, ""),
        curves: all
            .iter()
            .filter(|of| of.ground == ground)
            .enumerate()
            .flat_map(|(k, of)| {
                let peaks = of.free_field.iter().map(|[peaks, _]| *peaks).collect();
                [
                    line(format!("{} Hz", of.frequency), k, peaks),
                    line("periodic".into(), DASHED + k, of.periodic.clone()),
                ]
            })
            .collect(),
        named: Named::Nothing,
    };
    Loops {
        title: "Difference of the walls' peak displacement from that with sides at 16 widths".into(),
        along: Quantity::new("", ""),
        time: &[],
        planes: [("elastic", "elastic"), ("yielding layer", "yielding")].map(plane).into(),
        tracks: vec![],
        states: None,
    }
    .draw()
}
