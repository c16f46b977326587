//! What a section bears by a code with its factors.

use crate::{Code, Concrete, Diagram, Grade, Layer, Plain, Section, Shear};

/// A code with all that it is used with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rule {
    pub code: Code,
    /// Characteristic strengths of the concrete.
    pub grade: Grade,
    /// γ_c and γ_s, by which strengths of concrete and steel are divided.
    pub concrete_factor: f64,
    pub steel_factor: f64,
    /// α_cc and α_ct, by which strengths of concrete are multiplied.
    pub compression_factor: f64,
    pub tension_factor: f64,
    /// By which every resistance is divided beyond that: γ_d, γ_0 and ψ of formats that have them.
    pub resistance_factor: f64,
    /// Whether plain concrete's tensile strength counts.
    pub tension: bool,
}

/// What one section bears.
#[derive(Clone, Debug, PartialEq)]
pub struct Capacity {
    section: Section,
    bears: Bears,
    shear: Option<Shear>,
    resistance_factor: f64,
}

#[derive(Clone, Debug, PartialEq)]
enum Bears {
    Reinforced(Diagram),
    Plain(Plain),
}

impl Rule {
    /// f_cd and f_ctd \[Pa\], with strengths `grown` by this factor, 1 where they are static.
    pub fn design(&self, grown: f64) -> [f64; 2] {
        let factor = grown / self.concrete_factor;
        [
            self.grade.compression * self.compression_factor * factor,
            self.grade.tension * self.tension_factor * factor,
        ]
    }

    /// The concrete with its static design strength.
    pub fn concrete(&self) -> Concrete {
        self.of(self.design(1.0)[0])
    }

    fn of(&self, compression: f64) -> Concrete {
        match self.code {
            Code::En => Concrete::en(compression),
            Code::Gb => Concrete::gb(compression),
        }
    }

    /// What a section of this thickness \[m\] bears with these layers, as drawn, with strengths of concrete `grown` by this factor.
    pub fn capacity(&self, thickness: f64, layers: &[Layer], grown: f64) -> Capacity {
        let [compression, tension] = self.design(grown);
        let concrete = self.of(compression);
        // GB 50010-2010 6.2.1: steel that is pulled is strained by 0.01 at most.
        let limit = if self.code == Code::Gb { 0.01 } else { f64::INFINITY };
        let design =
            |l: &Layer| Layer { yields: l.yields / self.steel_factor, breaks: l.breaks.min(limit), ..*l };
        let layers: Vec<Layer> = layers.iter().filter(|l| l.area > 0.0).map(design).collect();
        let reinforced = !layers.is_empty();
        let section = Section { thickness, concrete, layers };
        let bears = match reinforced {
            true => Bears::Reinforced(Diagram::of(&section)),
            false => {
                let tension = if self.tension { tension } else { 0.0 };
                Bears::Plain(Plain { thickness, compression, tension })
            }
        };
        let shear = match (self.code, reinforced) {
            (Code::En, true) => Some(Shear::En {
                characteristic: self.grade.compression * grown,
                design: compression,
                factor: self.concrete_factor,
            }),
            (Code::En, false) => Some(Shear::EnPlain { compression, tension }),
            (Code::Gb, true) => Some(Shear::Gb { tension }),
            (Code::Gb, false) => None,
        };
        Capacity { section, bears, shear, resistance_factor: self.resistance_factor }
    }
}

impl Capacity {
    /// Utilisation by proportional loading of N \[N/m\] and M \[N m/m\]: 1 at the limit; infinite where no share of them is borne. Not
    /// a number where they are none.
    pub fn utilisation(&self, state: [f64; 2]) -> f64 {
        if !state.iter().all(|x| x.is_finite()) {
            return f64::NAN;
        }
        self.resistance_factor
            * match &self.bears {
                Bears::Reinforced(diagram) => diagram.utilisation(state),
                Bears::Plain(plain) => plain.utilisation(state),
            }
    }

    /// Utilisation in shear of Q \[N/m\] beside N and M; not a number where the code has no clause here.
    pub fn shear(&self, state: [f64; 2], q: f64) -> f64 {
        let resistance = self.shear_resistance(state);
        if q == 0.0 && self.shear.is_some() { 0.0 } else { q.abs() / resistance }
    }

    /// Resistance V_Rd \[N/m\] to shear beside N \[N/m\] and M \[N m/m\]; not a number where the code has no clause here.
    pub fn shear_resistance(&self, state: [f64; 2]) -> f64 {
        let Some(shear) = &self.shear else { return f64::NAN };
        shear.resistance(&self.section, state) / self.resistance_factor
    }

    /// Whether it has steel.
    pub fn reinforced(&self) -> bool {
        matches!(self.bears, Bears::Reinforced(_))
    }

    /// The line round all N and M that it bears, divided by the factor of resistance; closed.
    pub fn border(&self) -> Vec<[f64; 2]> {
        match &self.bears {
            Bears::Reinforced(diagram) => {
                diagram.points().iter().map(|p| p.map(|x| x / self.resistance_factor)).collect()
            }
            Bears::Plain(plain) => {
                // Rays that are even in the plane of N/(f h) and M/(f h²/6).
                let (thrust, moment) = (plain.compression * plain.thickness, plain.thickness / 6.0);
                let ray = |k: usize| {
                    let angle = std::f64::consts::TAU * k as f64 / 240.0;
                    let state = [-thrust * angle.cos(), thrust * moment * angle.sin()];
                    let most = self.utilisation(state);
                    state.map(|x| if most > 0.0 { x / most } else { 0.0 })
                };
                (0..=240).map(ray).collect()
            }
        }
    }
}
