//! The free field of one or several plane waves, at every place of a model's boundaries.

use super::answered::Signal;
use super::grid::Grid;
use super::ground::LayeredGround;
use super::heading::Heading;
use super::prepared::{OneWave, Prepared};
use super::pushed::{Known, Pushed, Source};
use super::series::{Rings, Series, arrives, bytes};
use std::sync::{Arc, OnceLock};
use tremolite_engine::courses::{self, Asked, Courses};
use tremolite_engine::free_field::{GivenField, Place, Pushes, Spot};
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

/// The sum of plane waves.
pub struct ObliqueField {
    waves: Vec<OneWave>,
    /// m
    base: f64,
    lead: f64,
    late: f64,
    prepared: OnceLock<Prepared>,
}

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
            let slowness = wave.heading.along.map(|h| p * h);
            let (base, height) = (frame.bounds[0][2], frame.ground.height());
            all.push(OneWave {
                heading: wave.heading,
                slowness,
                at: frame.at,
                base,
                height,
                series: Arc::new(series),
            });
        }
        // Whole samples, so that the record on the time of the run is the record.
        let sample = waves.first().map_or(0.0, |wave| wave.motion.dt);
        if sample > 0.0 {
            lead = (lead / sample * (1.0 - 1e-12)).ceil() * sample;
        }
        Ok(ObliqueField { waves: all, base: frame.bounds[0][2], lead, late, prepared: OnceLock::new() })
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
        self.waves.iter().map(|wave| wave.series.bytes()).sum::<usize>()
            + self.prepared.get().map_or(0, Prepared::bytes)
    }

    /// Samples of a wave's series since its first, where it is not later.
    fn place(&self, wave: &OneWave, time: f64) -> f64 {
        (time - self.lead - wave.series.start) / wave.series.dt()
    }

    /// What pushes places, with what is known of each wave.
    fn pushed(&self, places: &[&Place], known: &[Arc<Known>]) -> Box<dyn Pushes> {
        let source = |(wave, known): (&OneWave, &Arc<Known>)| Source {
            series: wave.series.clone(),
            known: Arc::clone(known),
            stacking: wave.stacking(),
            start: self.lead + wave.series.start,
        };
        Box::new(Pushed::new(self.waves.iter().zip(known).map(source).collect(), places))
    }

    /// What pushes places, where no more sums than so many are kept of a wave.
    #[cfg(test)]
    pub(super) fn with_sums_of(&self, most: usize, places: &[&Place]) -> Box<dyn Pushes> {
        let known = |wave| Arc::new(super::prepared::known(wave, places, most));
        self.pushed(places, &self.waves.iter().map(known).collect::<Vec<_>>())
    }

    /// How many sums are kept of what pushes places, of all waves.
    #[cfg(test)]
    pub(super) fn sums(&self) -> usize {
        let known = self.prepared.get().into_iter().flat_map(|prepared| prepared.pushes());
        known.map(|known| known.numbers.len()).sum()
    }

    /// Makes of each spot the sum of what each wave does there: `ready` reads courses, `elsewhere` is by the height \[m\] above the base and the
    /// samples by which the wave is later.
    #[inline(always)]
    fn each(
        &self,
        spots: &[Spot],
        out: &mut [[f64; 3]],
        ready: impl Fn(usize, &Courses, &[Asked], &mut [[f64; 4]]),
        elsewhere: impl Fn(usize, f64, f64) -> [f64; 4],
    ) {
        out.fill([0.0; 3]);
        let mut asked = [Asked { number: 0, late: 0.0 }; AT_ONCE];
        let mut found = [[0.0; 4]; AT_ONCE];
        for (k, wave) in self.waves.iter().enumerate() {
            let courses = self.prepared.get().map(|prepared| prepared.motion(k));
            let [px, py] = wave.slowness.map(|p| p / wave.series.dt());
            for (spots, out) in spots.chunks(AT_ONCE).zip(out.chunks_mut(AT_ONCE)) {
                let asked = &mut asked[..spots.len()];
                let found = &mut found[..spots.len()];
                for (asked, spot) in asked.iter_mut().zip(spots) {
                    let late = px * (spot.at[0] - wave.at[0]) + py * (spot.at[1] - wave.at[1]);
                    *asked = Asked { number: spot.height, late };
                }
                match courses {
                    Some(courses) => ready(k, courses, asked, found),
                    None => found.fill([0.0; 4]),
                }
                for ((out, found), (spot, asked)) in
                    out.iter_mut().zip(&*found).zip(spots.iter().zip(&*asked))
                {
                    let u = match courses {
                        Some(_) if spot.height != Spot::UNKNOWN => *found,
                        _ => elsewhere(k, spot.at[2] - self.base, asked.late),
                    };
                    (0..3).for_each(|i| out[i] += u[i]);
                }
            }
        }
    }
}

/// Spots whose courses are read together.
const AT_ONCE: usize = 64;

impl GivenField for ObliqueField {
    fn displacement(&self, at: [f64; 3], time: f64) -> [f64; 3] {
        let mut out = [[0.0; 3]];
        self.displacements(&[self.spot(at)], time, &mut out);
        out[0]
    }

    fn stress(&self, at: [f64; 3], time: f64) -> [f64; 6] {
        let mut out = [0.0; 6];
        for wave in &self.waves {
            let place = self.place(wave, time) - wave.stacking().late(at);
            let found = wave.series.stress_of(at[2] - self.base, place);
            for (of, s) in wave.heading.stress().iter().zip(found) {
                (0..6).for_each(|i| out[i] += s * of[i]);
            }
        }
        out
    }

    fn prepare(&self, places: &[&Place]) {
        self.prepared.get_or_init(|| Prepared::of(&self.waves, places));
    }

    fn spot(&self, at: [f64; 3]) -> Spot {
        let number = self.prepared.get().and_then(|prepared| prepared.height(at[2] - self.base));
        Spot { at, height: number.unwrap_or(Spot::UNKNOWN) }
    }

    fn displacements(&self, spots: &[Spot], time: f64, out: &mut [[f64; 3]]) {
        let now: Vec<f64> = self.waves.iter().map(|wave| self.place(wave, time)).collect();
        courses::wide(
            #[inline(always)]
            || {
                self.each(
                    spots,
                    out,
                    |k, courses, asked, found| courses.read(asked, now[k], found),
                    |k, height, late| self.waves[k].displacement(height, now[k] - late),
                );
            },
        );
    }

    fn velocities(&self, spots: &[Spot], time: f64, dt: f64, out: &mut [[f64; 3]]) {
        let ends = |wave: &OneWave| [time - dt, time + dt].map(|time| self.place(wave, time));
        let ends: Vec<[f64; 2]> = self.waves.iter().map(ends).collect();
        courses::wide(
            #[inline(always)]
            || {
                self.each(
                    spots,
                    out,
                    |k, courses, asked, found| courses.gained(asked, ends[k], found),
                    |k, height, late| {
                        let [before, after] =
                            ends[k].map(|place| self.waves[k].displacement(height, place - late));
                        [0, 1, 2, 3].map(|i| after[i] - before[i])
                    },
                );
                let per_time = 1.0 / (2.0 * dt);
                out.iter_mut().flatten().for_each(|v| *v *= per_time);
            },
        );
    }

    fn pushes(&self, places: &[&Place]) -> Option<Box<dyn Pushes>> {
        let prepared = self.prepared.get()?;
        Some(self.pushed(places, prepared.pushes()))
    }

    fn peak_velocity(&self) -> f64 {
        self.waves.iter().map(|wave| wave.series.peak).sum()
    }
}
