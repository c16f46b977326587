//! `[motion.site]`: the ground on or in which a record was measured.

use tremolite_laws::parameter::Dimension;

use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table, When, words};
use crate::{Diagnostic, Spanned};

use super::soil::{self, Softening};

pub(super) static SITE: Table = Table {
    path: "motion.site",
    doc: "The ground on or in which the record was measured, for `kind = \"within\"` and `\"surface\"`.",
    keys: &[
        Key::optional(
            "layers",
            Kind::Tables(&LAYER),
            "",
            "Its layers from the surface down, on a half-space of the rock at the model's base",
        ),
        Key::optional(
            "corner",
            Kind::Word(Corner::WORDS),
            "",
            "The model's own ground at this corner, where the corners differ",
        ),
    ],
    choice: &[&["layers"], &["corner"]],
};

static LAYER: Table = Table {
    path: "motion.site.layers",
    doc: "A layer of the ground that was recorded on.",
    keys: &[
        Key::required("thickness", Kind::Number(Dimension::LENGTH, Limit::Positive), "how thick it is"),
        Key::required(
            "shear_wave_velocity",
            Kind::Number(Dimension::VELOCITY, Limit::Positive),
            "velocity of shear waves in it",
        ),
        Key::required(
            "poisson",
            Kind::Number(Dimension::NONE, Limit::Within(0.499)),
            "Poisson's ratio, by which compression waves are faster; in saturated soil 0.48 to 0.499",
        ),
        Key::optional("density", Kind::Number(Dimension::DENSITY, Limit::Positive), "", "Mass per volume"),
        Key::optional(
            "unit_weight",
            Kind::Number(Dimension::UNIT_WEIGHT, Limit::Positive),
            "",
            "Weight per volume, instead of the density",
        ),
        Key::required(
            "damping",
            Kind::Number(Dimension::NONE, Limit::Within(0.3)),
            "ratio to critical damping, the same at all frequencies; the layer is linear then",
        )
        .when(When::WithoutAny(soil::CURVES)),
        Key::optional(
            "darendeli",
            Kind::Table(&soil::DARENDELI),
            "",
            "Softens and damps by its strain after Darendeli (2001), which the record is deconvolved with",
        )
        .when(When::WithoutAny(&["vucetic_dobry", "curves"])),
        Key::optional(
            "vucetic_dobry",
            Kind::Number(Dimension::NONE, Limit::Within(200.0)),
            "",
            "The same after Vucetic and Dobry (1991), for this plasticity index in %",
        )
        .when(When::Without("curves")),
        Key::optional("curves", Kind::Table(&soil::TABLE), "", "The same by a table of your own"),
    ],
    choice: &[&["density"], &["unit_weight"]],
};

words! {
    /// A vertical edge of the model.
    Corner {
        /// At the low ends of x and y.
        LowLow = "xmin-ymin",
        /// At the high end of x.
        HighLow = "xmax-ymin",
        /// At the high end of y.
        LowHigh = "xmin-ymax",
        /// At the high ends of x and y.
        HighHigh = "xmax-ymax",
    }
}

impl Corner {
    /// Bit 0 for the high end of x, bit 1 for that of y.
    pub fn index(self) -> usize {
        match self {
            Corner::LowLow => 0,
            Corner::HighLow => 1,
            Corner::LowHigh => 2,
            Corner::HighHigh => 3,
        }
    }
}

/// The ground on or in which a record was measured.
#[derive(Clone, Debug, PartialEq)]
pub enum Site {
    /// Layers from the surface down, at least one, on the rock of the model's base.
    Layers(Vec<SiteLayer>),
    /// The model's own ground at a corner.
    Corner(Spanned<Corner>),
}

/// A layer of the ground that was recorded on.
#[derive(Clone, Debug, PartialEq)]
pub struct SiteLayer {
    /// m
    pub thickness: Spanned<f64>,
    /// Velocity of shear waves, m/s.
    pub shear_wave_velocity: Spanned<f64>,
    pub poisson: Spanned<f64>,
    /// kg/m³
    pub density: Spanned<f64>,
    /// How it damps, and softens if it does.
    pub softening: Softening,
}

impl SiteLayer {
    /// Velocity of compression waves, m/s.
    pub fn compression_wave_velocity(&self) -> f64 {
        let nu = self.poisson.value;
        self.shear_wave_velocity.value * (2.0 * (1.0 - nu) / (1.0 - 2.0 * nu)).sqrt()
    }

    fn read(f: &Fields, gravity: f64) -> Option<Self> {
        let by_weight = f.number("unit_weight").map(|w| Spanned::new(w.value / gravity, w.span));
        Some(SiteLayer {
            thickness: f.number("thickness")?,
            shear_wave_velocity: f.number("shear_wave_velocity")?,
            poisson: f.number("poisson")?,
            density: f.number("density").or(by_weight)?,
            softening: Softening::read(f)?,
        })
    }
}

impl Site {
    /// Nothing where the case has none.
    pub(super) fn read(motion: &Fields, gravity: f64) -> Option<Self> {
        let f = motion.table("site")?;
        match f.word("corner", Corner::from_word) {
            Some(corner) => Some(Site::Corner(corner)),
            None => {
                Some(Site::Layers(f.tables("layers").filter_map(|f| SiteLayer::read(f, gravity)).collect()))
            }
        }
    }
}

/// Refuses ground for records that stand on none, and soil that softens where no record of its surface says how far.
pub(super) fn check(motion: &Fields, problems: &mut Vec<Diagnostic>) {
    let layers = motion.table("site").into_iter().flat_map(|f| f.tables("layers"));
    let soft = layers.flat_map(|layer| soil::CURVES.iter().filter_map(|key| layer.get(key))).next();
    if let (Some(soft), Some(kind)) = (soft, motion.text("kind"))
        && kind.value == "within"
    {
        problems.push(Diagnostic::new(
            soft.span.clone(),
            "a layer softens by the strain of a record at the surface, and this one was taken within the ground",
            "give the layers the velocities and `damping` that go with its strain",
        ));
    }
    if let (Some(site), Some(kind)) = (motion.get("site"), motion.text("kind"))
        && ["outcrop", "incident"].contains(&kind.value.as_str())
    {
        problems.push(Diagnostic::new(
            site.span.clone(),
            format!(
                "`site` has a meaning only for a record on or within layered ground, not for `{}`",
                kind.value
            ),
            "leave it out, or write kind = \"surface\" or \"within\"",
        ));
    }
}

/// The unit weights of the layers of a motion's site.
pub(crate) fn unit_weights(motion: &Fields) -> Vec<Spanned<f64>> {
    let layers = motion.table("site").into_iter().flat_map(|f| f.tables("layers"));
    layers.filter_map(|layer| layer.number("unit_weight")).collect()
}
