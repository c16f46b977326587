//! What of the motion of a case is worth reporting.

use crate::deconvolution::Place;
use crate::waves::{Entering, Frame, WaveType};
use tremolite_case::{self as case, Diagnostic};
use tremolite_engine::column::corner_name;
use tremolite_motion::{Complex64, Intensity, Kind, Motion};

/// The share of the velocity's energy below what counts as the highest frequency.
pub const ENERGY_SHARE: f64 = 0.999;

/// What of the motion is worth reporting.
#[derive(Clone, Debug)]
pub struct MotionFacts {
    pub kind: Kind,
    /// Factor from the given motion to the incident wave; none where it was deconvolved.
    pub factor: Option<f64>,
    /// How it was deconvolved.
    pub site: Option<SiteFacts>,
    /// Waves at angles that carry it; none: one that rises straight up.
    pub waves: Vec<WaveFacts>,
    /// Of the waves that carry all components together: by so much errors of the record may grow in them.
    pub condition: Option<f64>,
    /// By how much they come later than in the record, so that nothing moves at time 0 \[s\].
    pub lead: f64,
    /// Bytes of the series of waves at angles.
    pub series: usize,
    /// Along x, y, z of the model: measures of the processed given motion (before the factor).
    pub intensity: [Intensity; 3],
    /// Where the components came from, in words.
    pub source: String,
    /// The part of the record that is used \[s\].
    pub window: [f64; 2],
    /// Peaks of the incident wave along x, y, z; of waves at angles those of all together at their common place at the base.
    pub incident: [Peaks; 3],
    /// Design displacement of the ground d_g of a target of `en1998` \[m\]; none with another target.
    pub design_displacement: Option<f64>,
    /// Frequency below which 99.9 % of the energy of the incident wave's velocity lies \[Hz\].
    pub highest_frequency: f64,
    /// Lowest low-pass corner that was applied \[Hz\].
    pub lowpass: Option<f64>,
    /// What reading did beside reading, directions that do not fit, and numbers that are not what they seem, at their places in the
    /// case.
    pub warnings: Vec<Diagnostic>,
}

/// Largest sizes of a motion along an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peaks {
    /// \[m/s²\]
    pub acceleration: f64,
    /// \[m/s\]
    pub velocity: f64,
    /// \[m\]
    pub displacement: f64,
}

impl Peaks {
    /// Those of a motion times a factor, along x, y, z.
    pub(super) fn of(motion: &Motion, factor: f64) -> [Peaks; 3] {
        let size = |values: &[f64]| factor.abs() * largest(values);
        [0, 1, 2].map(|axis| Peaks {
            acceleration: size(&motion.acceleration[axis]),
            velocity: size(&motion.velocity[axis]),
            displacement: size(&motion.displacement[axis]),
        })
    }
}

impl MotionFacts {
    /// How the wave that comes in follows from the given motion, in lines to be read behind the kind.
    pub fn entering(&self) -> Vec<String> {
        if !self.waves.is_empty() {
            let lead = format!(
                "the waves come {:.3} s later than in the record, so that nothing moves before; their series take {:.1} MB",
                self.lead,
                1e-6 * self.series as f64
            );
            let condition = self.condition.map(|condition| {
                format!("together they move the place as recorded; condition {condition:.2}: by so much errors of the record may grow in them")
            });
            return self.waves.iter().map(WaveFacts::words).chain(condition).chain([lead]).collect();
        }
        match (&self.site, self.factor) {
            (Some(site), _) => site.words(),
            (None, Some(factor)) => vec![format!("the incident wave is {factor} times the given motion")],
            (None, None) => vec!["the incident wave is not known".into()],
        }
    }
}

/// A wave at an angle.
#[derive(Clone, Debug)]
pub struct WaveFacts {
    pub kind: WaveType,
    /// From the vertical, and clockwise from north, as written \[rad\].
    pub angle: f64,
    pub azimuth: f64,
    /// Its way along x, y, z of the model, and what it moves, of length 1.
    pub way: [f64; 3],
    pub polarisation: [f64; 3],
    /// The component that it carries, or "together".
    pub component: &'static str,
    /// What it is the sum of.
    pub parts: Vec<CarriedFacts>,
    /// With which the field goes along in plan \[m/s\]; infinite straight up.
    pub apparent_velocity: f64,
    /// Whether it comes at some time; beyond a critical angle something runs ahead of it.
    pub arrives: bool,
}

/// What a component of the record is times in a wave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarriedFacts {
    pub component: &'static str,
    /// Negative where the wave is opposite.
    pub factor: f64,
    /// By how much it is turned in phase \[rad\], not 0 beyond a critical angle alone.
    pub phase: f64,
}

impl CarriedFacts {
    fn of(component: &'static str, factor: Complex64) -> CarriedFacts {
        match factor.im == 0.0 {
            true => CarriedFacts { component, factor: factor.re, phase: 0.0 },
            false => CarriedFacts { component, factor: factor.norm(), phase: factor.arg() },
        }
    }

    fn words(&self) -> String {
        let turned = if self.phase == 0.0 {
            String::new()
        } else {
            format!(" turned by {:.0} deg in phase", self.phase.to_degrees())
        };
        format!("{:.3} times '{}'{turned}", self.factor, self.component)
    }
}

impl WaveFacts {
    pub(super) fn of(wave: &Entering, written: &case::Wave, frame: &Frame) -> WaveFacts {
        WaveFacts {
            kind: wave.heading.kind,
            angle: written.angle.value,
            azimuth: written.azimuth.value,
            way: wave.heading.way(),
            polarisation: wave.heading.polarisation(),
            component: written.component.value.word(),
            parts: ["east", "north", "up"]
                .into_iter()
                .zip(wave.factors)
                .filter(|(_, factor)| factor.norm() > 1e-12)
                .map(|(component, factor)| CarriedFacts::of(component, factor))
                .collect(),
            apparent_velocity: 1.0 / wave.heading.slowness(&frame.ground.below()),
            arrives: frame.arrives(wave),
        }
    }

    /// In words, to be read behind the kind.
    pub fn words(&self) -> String {
        let WaveFacts { kind, apparent_velocity, .. } = self;
        let [angle, azimuth] = [self.angle, self.azimuth].map(|x| (1e6 * x.to_degrees()).round() / 1e6);
        let speed = match apparent_velocity.is_finite() {
            true => format!(", {apparent_velocity:.0} m/s along the ground"),
            false => String::new(),
        };
        let ahead = if self.arrives {
            ""
        } else {
            "; beyond a critical angle, or turned in phase, so the field fades in before the wave comes"
        };
        format!(
            "{} at {angle} deg towards {azimuth} deg is {}{speed}{ahead}",
            kind.word(),
            self.parts.iter().map(CarriedFacts::words).collect::<Vec<_>>().join(" + ")
        )
    }
}

/// What a layer of soil came to under a record of its surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoilFacts {
    /// \[m\]
    pub thickness: f64,
    /// Of shear waves, with the modulus that it is left with \[m/s\].
    pub speed: f64,
    /// Largest shear strain in its middle.
    pub strain: f64,
    /// G/G_max and the ratio to critical damping, of 0.65 of that strain.
    pub modulus: f64,
    pub damping: f64,
}

/// How a motion was deconvolved.
#[derive(Clone, Debug)]
pub struct SiteFacts {
    /// The ground that it was recorded on, and where.
    pub place: Place,
    /// Below the surface of that ground \[m\].
    pub depth: f64,
    /// The corner of the model whose own ground it is; none for layers of the case.
    pub corner: Option<usize>,
    /// What layers that soften came to, with the others, from the surface down; empty where none does.
    pub soil: Vec<SoilFacts>,
    /// By how much it is put off \[s\].
    pub lead: f64,
    /// Up to which frequency the record was wanted \[Hz\].
    pub band: f64,
    /// Up to which frequency the incident wave is the record's \[Hz\]; infinite where nothing was left out.
    pub reach: f64,
    /// The largest share of ∫a² dt of a component that was left out above.
    pub left_out: f64,
    /// Motion there over that of the incident wave, at low frequency.
    pub at_rest: f64,
    /// The least and the largest of the same that is let through, along the axes that move, and its frequency \[Hz\].
    pub least: (f64, f64),
    pub most: (f64, f64),
}

impl SiteFacts {
    /// What was done, in lines to be read behind the kind.
    pub fn words(&self) -> Vec<String> {
        let ground = match self.corner {
            Some(corner) => format!("the model's own ground at {}", corner_name(corner)),
            None => "the layers of motion.site".to_owned(),
        };
        let (least, hertz) = self.least;
        let place = match self.depth {
            0.0 => format!("from the surface of {ground}"),
            depth => format!("from {depth:.1} m below the surface of {ground}"),
        };
        let (most, most_at) = self.most;
        let how = match self.soil.is_empty() {
            true => "as linear layers",
            false => "as linear layers of the moduli and the damping that go with its own strain",
        };
        let mut words = vec![
            format!("deconvolved {place}, {how}"),
            format!(
                "that place moves {:.2} times the incident wave at low frequency, at most {most:.2} times (at {most_at:.2} Hz), at \
                 least {least:.2} times (at {hertz:.2} Hz)",
                self.at_rest
            ),
            format!("the record comes to its place {:.3} s later than in its file", self.lead),
        ];
        words.extend(self.soil.iter().enumerate().map(|(k, soil)| {
            format!(
                "layer {} ({} m) shears by {:.3} %: {:.2} of its modulus, {:.0} m/s, damping ratio {:.3}",
                k + 1,
                soil.thickness,
                100.0 * soil.strain,
                soil.modulus,
                soil.speed,
                soil.damping
            )
        }));
        if self.reach.is_finite() {
            words.push(format!(
                "what it has above {:.2} Hz fades out, since further up too little of the wave moves that place: {:.2} % of the \
                 processed record's energy",
                self.reach,
                100.0 * self.left_out
            ));
        }
        words
    }
}

/// The largest size.
pub(super) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0_f64, |most, x| most.max(x.abs()))
}
