//! `[[mesh.caverns.layer]]` and `[mesh.caverns.ground]`: the rock and its surface.

use tremolite_laws::parameter::Dimension;

use super::super::COORDINATE;
use super::NOT_NEGATIVE;
use crate::Spanned;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table, When};

const ANGLE: Kind = Kind::Number(Dimension::ANGLE, Limit::Any);
const DIP: Kind = Kind::Number(Dimension::ANGLE, Limit::NotNegative);
const PLACES: Kind = Kind::List(&COORDINATE, 1, 100_000);

pub(super) static LAYER: Table = Table {
    path: "mesh.caverns.layer",
    doc: "A layer of rock under a plane, down to the next layer's plane. Its elements are the group `rock.NAME`, beside \
          `rock`.",
    keys: &[
        Key::required("name", Kind::Name, "last part of the name of its group"),
        Key::default(
            "depth",
            NOT_NEGATIVE,
            r#""0 m""#,
            "Upper plane below z = 0 at x = y = 0; 0 for the first",
        ),
        Key::default("dip", DIP, r#""0 deg""#, "Angle at which the upper plane falls; 0 for the first"),
        Key::optional("dip_azimuth", ANGLE, "along x", "Direction in which it falls, clockwise from north"),
    ],
    choice: &[],
};

pub(super) static GROUND: Table = Table {
    path: "mesh.caverns.ground",
    doc: "Surface of the ground: a plane through z = 0 at x = y = 0, or a table of heights above z = 0. The rock above \
          the caverns is squeezed where the ground is lower.",
    keys: &[
        Key::optional("slope", Kind::List(&ANGLE, 2, 2), "", "Angles at which it rises along x and along y"),
        Key::optional("heights", PLACES, "", "Heights, for each of `y` those at all of `x`"),
        Key::optional(
            "x",
            PLACES,
            "",
            "Places of the heights along x, rising; beyond them the ground is level",
        )
        .when(When::Beside("heights")),
        Key::optional("y", PLACES, "", "Places along y, rising; without it the heights are the same along y")
            .when(When::Beside("heights")),
    ],
    choice: &[&["slope"], &["heights"]],
};

/// A layer of rock.
#[derive(Clone, Debug, PartialEq)]
pub struct RockLayer {
    /// Unique; last part of the name of its group.
    pub name: Spanned<String>,
    /// Upper plane below z = 0 at x = y = 0, m; 0 for the first layer.
    pub depth: Spanned<f64>,
    /// rad
    pub dip: Spanned<f64>,
    /// Direction in which the upper plane falls, from the model's x towards y, rad.
    pub dip_direction: Spanned<f64>,
}

/// Surface of the ground above z = 0.
#[derive(Clone, Debug, PartialEq)]
pub enum GroundSurface {
    /// Angles at which it rises along x and along y, rad.
    Slope(Spanned<[f64; 2]>),
    /// Heights at places, m.
    Heights {
        /// Rising.
        x: Vec<f64>,
        /// Rising; empty: the same heights along y.
        y: Vec<f64>,
        /// For each of `y` those at all of `x`.
        heights: Vec<f64>,
    },
}

impl RockLayer {
    pub(super) fn read(f: &Fields, x_azimuth: f64) -> Option<Self> {
        let dip = f.number("dip")?;
        Some(RockLayer {
            name: f.text("name")?,
            depth: f.number("depth")?,
            dip_direction: match f.number("dip_azimuth") {
                Some(azimuth) => Spanned::new(x_azimuth - azimuth.value, azimuth.span),
                None => Spanned::new(0.0, dip.span.clone()),
            },
            dip,
        })
    }
}

impl GroundSurface {
    pub(super) fn read(f: &Fields) -> Option<Self> {
        let places = |key| f.list(key).iter().filter_map(|n| Some(n.number()?.value)).collect::<Vec<f64>>();
        let (x, y, heights) = (places("x"), places("y"), places("heights"));
        match f.numbers("slope") {
            Some(slope) => Some(GroundSurface::Slope(slope)),
            None if heights.is_empty() => None,
            None => Some(GroundSurface::Heights { x, y, heights }),
        }
    }
}
