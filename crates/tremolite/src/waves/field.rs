//! The free field of one or several plane waves, at every place of a model's boundaries.

use super::answered::{Signal, components};
use super::grid::Grid;
use super::ground::LayeredGround;
use super::heading::{Heading, WaveType};
use super::heights::{self, AtHeights, Heights};
use super::series::{Rings, Series, arrives, bytes};
use std::sync::{Arc, OnceLock};
use tremolite_engine::free_field::{Asked, GivenField, Spot};
use tremolite_motion::{Complex64, Motion};

/// A wave as it enters.
#[derive(Clone)]
pub struct Entering {
    pub heading: Heading,
    /// The record that it carries.
    pub motion: Arc<Motion>,
    /// What each of the record's components is times in it, the sum of which it is: for a wave of e^(iωt), ω > 0.
    pub factors: [Complex64; 3],
}

impl Entering {
    /// A wave that carries one of the components of a record.
    pub fn of(heading: Heading, motion: Arc<Motion>, component: usize, factor: Complex64) -> Entering {
        let mut factors = [Complex64::default(); 3];
        factors[component] = factor;
        Entering { heading, motion, factors }
    }

    /// Whether any component is turned in phase.
    pub fn turns(&self) -> bool {
        self.factors.iter().any(|factor| factor.im != 0.0)
    }

    /// The sum of the components times what `part` takes of their factors.
    pub fn sum(&self, components: [f64; 3], part: fn(&Complex64) -> f64) -> f64 {
        self.factors.iter().zip(components).map(|(factor, x)| part(factor) * x).sum()
    }
}

/// What all waves come through.
#[derive(Clone, Debug)]
pub struct Frame {
    pub ground: LayeredGround,
    /// The model's corners \[m\].
    pub bounds: [[f64; 3]; 2],
    /// Where in plan the waves have the time of the record \[m\], the model's own x and y.
    pub at: [f64; 2],
    /// Highest frequency \[Hz\].
    pub frequency: f64,
    /// How long it is computed \[s\]; nothing: as long as the record and the lead.
    pub duration: Option<f64>,
}

/// Why there is no field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unsuitable {
    /// Which of the waves.
    pub wave: usize,
    pub rings: Rings,
}

/// One wave.
struct OneWave {
    heading: Heading,
    /// p h \[s/m\]
    slowness: [f64; 2],
    series: Series,
}

/// The sum of plane waves.
pub struct ObliqueField {
    waves: Vec<OneWave>,
    at: [f64; 2],
    base: f64,
    /// Of the ground \[m\].
    height: f64,
    lead: f64,
    late: f64,
    prepared: OnceLock<Prepared>,
}

/// What is at hand for the heights that a model asks for.
struct Prepared {
    /// Above the base: where displacements are asked for, and where stresses are.
    nodes: Heights,
    points: Heights,
    /// Of each wave both.
    waves: Vec<[AtHeights; 2]>,
}

/// Memory for the heights of a model over that of the series: more is left to the series alone.
const MOST_PREPARED: usize = 2;

impl Frame {
    /// The later a wave comes to the corners than to the reference point, least and most \[s\].
    pub fn delays(&self, heading: &Heading) -> [f64; 2] {
        let p = heading.slowness(&self.ground.below());
        let of = |x: usize, y: usize| {
            let [dx, dy] = [self.bounds[x][0] - self.at[0], self.bounds[y][1] - self.at[1]];
            p * (heading.along[0] * dx + heading.along[1] * dy)
        };
        let all = [of(0, 0), of(1, 0), of(0, 1), of(1, 1)];
        [all.into_iter().fold(f64::INFINITY, f64::min), all.into_iter().fold(f64::NEG_INFINITY, f64::max)]
    }

    /// Until when the series of a wave are asked for \[s\], on the time of its record.
    fn until(&self, wave: &Entering) -> f64 {
        let [least, most] = self.delays(&wave.heading);
        self.duration.unwrap_or(0.0).max(wave.motion.duration())
            + (most.max(0.0) - least)
            + 20.0 / self.frequency
    }

    /// Bytes of the series of some waves, without a lead where nothing arrives.
    pub fn bytes(&self, waves: &[Entering]) -> f64 {
        let levels = Grid::new(&self.ground, self.frequency).count();
        waves.iter().map(|wave| bytes(wave.heading.kind, levels, self.until(wave), self.frequency)).sum()
    }

    /// Levels at which series are kept.
    pub fn levels(&self) -> usize {
        Grid::new(&self.ground, self.frequency).count()
    }

    /// Whether a wave comes at some time, and not from ever on.
    pub fn arrives(&self, wave: &Entering) -> bool {
        arrives(&self.ground, &wave.heading) && !wave.turns()
    }
}

impl ObliqueField {
    /// Of waves in ground.
    ///
    /// # Errors
    /// If the ground rings longer under a wave than can be followed.
    pub fn new(frame: &Frame, waves: &[Entering]) -> Result<ObliqueField, Unsuitable> {
        let (mut lead, mut late) = (0.0_f64, 0.0_f64);
        let mut all = Vec::with_capacity(waves.len());
        for (k, wave) in waves.iter().enumerate() {
            let displacement = |t: f64| wave.sum(wave.motion.at(t).u, |factor| factor.re);
            let turned = |t: f64| wave.sum(wave.motion.at(t).u, |factor| factor.im);
            let signal = Signal {
                displacement: &displacement,
                turned: if wave.turns() { Some(&turned) } else { None },
                frequency: frame.frequency,
                until: frame.until(wave),
            };
            let series = Series::of(&frame.ground, &wave.heading, &signal)
                .map_err(|rings| Unsuitable { wave: k, rings })?;
            let [least, most] = frame.delays(&wave.heading);
            lead = lead.max(-least - series.start);
            late = late.max(most);
            let p = wave.heading.slowness(&frame.ground.below());
            all.push(OneWave { heading: wave.heading, slowness: wave.heading.along.map(|h| p * h), series });
        }
        // Whole samples, so that the record on the time of the run is the record.
        let sample = waves.first().map_or(0.0, |wave| wave.motion.dt);
        if sample > 0.0 {
            lead = (lead / sample * (1.0 - 1e-12)).ceil() * sample;
        }
        let (base, height) = (frame.bounds[0][2], frame.ground.height());
        Ok(ObliqueField { waves: all, at: frame.at, base, height, lead, late, prepared: OnceLock::new() })
    }

    /// By how much the field is later than the records \[s\], so that nothing moves at time 0; samples of the first record.
    pub fn lead(&self) -> f64 {
        self.lead
    }

    /// By how much waves come later than to the reference point, at most, to the corner of the base that they reach last \[s\].
    pub fn late(&self) -> f64 {
        self.late
    }

    /// What the series take of memory.
    pub fn bytes(&self) -> usize {
        let prepared = self.prepared.get().into_iter().flat_map(|prepared| prepared.waves.iter().flatten());
        self.waves.iter().map(|wave| wave.series.bytes()).sum::<usize>()
            + prepared.map(AtHeights::bytes).sum::<usize>()
    }

    /// Time on that of a wave's series.
    fn time(&self, wave: &OneWave, at: [f64; 3], time: f64) -> f64 {
        let [px, py] = wave.slowness;
        time - self.lead - px * (at[0] - self.at[0]) - py * (at[1] - self.at[1])
    }
}

impl OneWave {
    /// Components of displacement \[m\], or of stress \[Pa\], at a spot and a time of the series \[s\].
    #[inline(always)]
    fn there<const V: usize>(
        &self,
        ready: Option<&AtHeights>,
        height: f64,
        number: u32,
        time: f64,
        of: Asked,
    ) -> [f64; V] {
        match (ready, of) {
            (Some(ready), _) if number != Spot::UNKNOWN => ready.at(number as usize, time),
            (_, Asked::Motion) => self.series.displacement(height, time),
            (_, Asked::Stress) => self.series.stress(height, time),
        }
    }
}

impl ObliqueField {
    /// Calls back for each wave, with its components at each spot.
    #[inline(always)]
    fn each<const V: usize>(
        &self,
        wave: usize,
        spots: &[Spot],
        time: f64,
        of: Asked,
        mut add: impl FnMut(usize, [f64; V]),
    ) {
        let own = &self.waves[wave];
        let ready =
            self.prepared.get().map(|prepared| &prepared.waves[wave][usize::from(of == Asked::Stress)]);
        for (k, spot) in spots.iter().enumerate() {
            let time = self.time(own, spot.at, time);
            add(k, own.there(ready, spot.at[2] - self.base, spot.height, time, of));
        }
    }
}

impl GivenField for ObliqueField {
    fn displacement(&self, at: [f64; 3], time: f64) -> [f64; 3] {
        let mut out = [[0.0; 3]];
        self.displacements(&[self.spot(at, Asked::Motion)], time, &mut out);
        out[0]
    }

    fn stress(&self, at: [f64; 3], time: f64) -> [f64; 6] {
        let mut out = [[0.0; 6]];
        self.stresses(&[self.spot(at, Asked::Stress)], time, &mut out);
        out[0]
    }

    fn spot(&self, at: [f64; 3], of: Asked) -> Spot {
        let number = self.prepared.get().and_then(|prepared| {
            let heights = if of == Asked::Stress { &prepared.points } else { &prepared.nodes };
            heights.find(at[2] - self.base)
        });
        Spot { at, height: number.map_or(Spot::UNKNOWN, |number| number as u32) }
    }

    fn displacements(&self, spots: &[Spot], time: f64, out: &mut [[f64; 3]]) {
        out.fill([0.0; 3]);
        for (k, wave) in self.waves.iter().enumerate() {
            let [hx, hy] = wave.heading.along;
            if wave.heading.kind == WaveType::Sh {
                self.each(k, spots, time, Asked::Motion, |n, [u]| {
                    out[n][0] -= hy * u;
                    out[n][1] += hx * u;
                });
            } else {
                self.each(k, spots, time, Asked::Motion, |n, [along, up]| {
                    out[n][0] += hx * along;
                    out[n][1] += hy * along;
                    out[n][2] += up;
                });
            }
        }
    }

    fn velocities(&self, spots: &[Spot], time: f64, dt: f64, out: &mut [[f64; 3]]) {
        let mut before = vec![[0.0; 3]; out.len()];
        self.displacements(spots, time - dt, &mut before);
        self.displacements(spots, time + dt, out);
        for (out, before) in out.iter_mut().zip(before) {
            *out = [0, 1, 2].map(|i| (out[i] - before[i]) / (2.0 * dt));
        }
    }

    fn stresses(&self, spots: &[Spot], time: f64, out: &mut [[f64; 6]]) {
        out.fill([0.0; 6]);
        for (k, wave) in self.waves.iter().enumerate() {
            let [x, y] = wave.heading.along;
            let mut add = |n: usize, own: [f64; 6]| out[n].iter_mut().zip(own).for_each(|(sum, s)| *sum += s);
            if wave.heading.kind == WaveType::Sh {
                // t = (−y, x).
                self.each(k, spots, time, Asked::Stress, |n, [along, up]| {
                    let twice = 2.0 * x * y * along;
                    add(n, [-twice, twice, 0.0, (x * x - y * y) * along, x * up, -y * up]);
                });
            } else {
                self.each(k, spots, time, Asked::Stress, |n, [hh, tt, zz, hz]| {
                    let plane = [x * x * hh + y * y * tt, y * y * hh + x * x * tt];
                    add(n, [plane[0], plane[1], zz, x * y * (hh - tt), y * hz, x * hz]);
                });
            }
        }
    }

    fn prepare(&self, nodes: &[f64], points: &[f64]) {
        let above =
            |heights: &[f64]| Heights::new(heights.iter().map(|z| z - self.base).collect(), self.height);
        let (nodes, points) = (above(nodes), above(points));
        let takes = |wave: &OneWave| {
            let [moved, pulled] = components(wave.heading.kind);
            let samples = wave.series.samples();
            heights::bytes(nodes.all().len(), samples, moved)
                + heights::bytes(points.all().len(), samples, pulled)
        };
        if self.waves.iter().any(|wave| takes(wave) > MOST_PREPARED * wave.series.bytes()) {
            return;
        }
        self.prepared.get_or_init(|| {
            let of = |wave: &OneWave| {
                [(&nodes, false), (&points, true)]
                    .map(|(heights, stresses)| AtHeights::of(&wave.series, heights.all(), stresses))
            };
            let waves = self.waves.iter().map(of).collect();
            Prepared { nodes, points, waves }
        });
    }

    fn peak_velocity(&self) -> f64 {
        self.waves.iter().map(|wave| wave.series.peak).sum()
    }
}
