//! What each level of the ground does in time under one wave.
//!
//! Displacement and stress are kept as series at levels at most 1/20 of the shortest shear wave apart and 1/20 of the shortest
//! period, with their slopes in both directions, and found between them by cubics in both (Hermite): at 20 points a wave those err
//! by (2π/20)⁴/384 = 3·10⁻⁵ of it.
//!
//! **Nothing arrives.** Where all waves of all layers travel, the field is at rest before the wave comes, and frequencies lie
//! beside the imaginary axis as in [`crate::layered_column`], so that however long the ground rings nothing of it comes round
//! again. Beyond a critical angle the field has no beginning: what runs along faster than p came from far away. Then the frequencies are
//! real, the span is doubled until hardly anything is left at its ends, and the series are faded in where no level moves faster
//! than 10⁻⁴ of the largest velocity, or later and slowly.

use super::ground::{ACROSS, IN_PLANE, LayeredGround, Level, Waves};
use super::heading::{Heading, WaveType};
use rayon::prelude::*;
use std::f64::consts::PI;
use tremolite_motion::{Complex64, Lines};

/// Points a wave length and a period.
const FINE: f64 = 20.0;
/// Smallest e^(−ηT), as in [`crate::layered_column`].
const LEFT: f64 = 1e-8;
/// Velocity over the largest below which nothing counts as moving, where nothing arrives.
const STILL: f64 = 1e-4;
/// The same up to which it may be faded in, so much more slowly.
const SLOW: f64 = 1e-2;
/// Lines of less than this share of the largest are none.
const FAINT: f64 = 1e-9;
/// Samples of a span at most.
const LONGEST: usize = 1 << 22;
/// p c from which a wave of speed c counts as beyond critical, a little before it is.
const CRITICAL: f64 = 0.9999;

/// Displacement of an incident wave along its polarisation.
pub struct Signal<'a> {
    /// u(t) \[m\], zero before t = 0.
    pub displacement: &'a (dyn Fn(f64) -> f64 + Sync),
    /// What is added to that turned in phase, times i in a wave of e^(iωt), ω > 0, as a surface beyond a critical angle turns it.
    pub turned: Option<&'a (dyn Fn(f64) -> f64 + Sync)>,
    /// Highest frequency \[Hz\].
    pub frequency: f64,
    /// Until when it is wanted \[s\].
    pub until: f64,
}

/// A level at which series are kept.
#[derive(Clone, Copy, Debug)]
struct At {
    layer: usize,
    /// m above the layer's bottom.
    above: f64,
}

/// Where levels are: cells of equal height in each layer.
#[derive(Clone, Debug)]
pub struct Grid {
    /// Of each layer: its bottom, the height of a cell \[m\], the number of its first level, the number of its cells.
    layers: Vec<(f64, f64, usize, usize)>,
    levels: Vec<At>,
}

impl Grid {
    /// For waves of a frequency \[Hz\] at most.
    pub fn new(ground: &LayeredGround, frequency: f64) -> Grid {
        let mut bottom = 0.0;
        let mut grid = Grid { layers: Vec::new(), levels: Vec::new() };
        for (layer, stratum) in ground.strata().iter().enumerate() {
            let cells = (stratum.thickness * FINE * frequency / stratum.rock.s).ceil().max(1.0) as usize;
            let cell = stratum.thickness / cells as f64;
            grid.layers.push((bottom, cell, grid.levels.len(), cells));
            grid.levels.extend((0..=cells).map(|k| At { layer, above: k as f64 * cell }));
            bottom += stratum.thickness;
        }
        grid
    }

    /// How many levels there are.
    pub fn count(&self) -> usize {
        self.levels.len()
    }

    /// The level below a height \[m\] above the base, the height of the cell there, and the place in it from 0 to 1.
    fn cell(&self, height: f64) -> (usize, f64, f64) {
        let k = self.layers.iter().rposition(|layer| height > layer.0).unwrap_or(0);
        let (bottom, cell, first, cells) = self.layers[k];
        let place = ((height - bottom) / cell).clamp(0.0, cells as f64);
        let index = (place as usize).min(cells - 1);
        (first + index, cell, place - index as f64)
    }
}

/// Numbers kept of a value at a sample: it, its slope in time times the interval, both slopes upwards of these.
const KEPT: usize = 4;

/// Series of one wave at all levels.
pub struct Series {
    grid: Grid,
    /// Between samples, and of the first one \[s\].
    dt: f64,
    pub start: f64,
    samples: usize,
    /// Components of displacement and of stress.
    moved: Vec<f32>,
    pulled: Vec<f32>,
    /// Largest velocity at any level \[m/s\].
    pub peak: f64,
}

/// Why there are no series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rings {
    /// Velocity at the ends of the span \[s\] over the largest.
    pub left: f64,
    pub span: f64,
}

/// How many components of displacement and of stress a wave has.
pub fn components(kind: WaveType) -> [usize; 2] {
    if kind == WaveType::Sh { [1, ACROSS - 1] } else { [2, IN_PLANE - 2] }
}

/// Bytes of series at so many levels for so long \[s\].
pub fn bytes(kind: WaveType, levels: usize, until: f64, frequency: f64) -> f64 {
    let [moved, pulled] = components(kind);
    (levels * (moved + pulled) * KEPT * 4) as f64 * until * FINE * frequency
}

/// Whether all waves travel in all layers, so that nothing moves before the wave comes.
pub fn arrives(ground: &LayeredGround, heading: &Heading) -> bool {
    let p = heading.slowness(&ground.below());
    let pressure = heading.kind != WaveType::Sh;
    let below = ground.below();
    let rocks = ground.strata().iter().map(|stratum| stratum.rock).chain([below]);
    rocks.map(|rock| p * rock.fastest(pressure)).fold(0.0, f64::max) < CRITICAL
}

/// The waves at all frequencies.
enum Answers {
    InPlane(Vec<Waves<2>>),
    Across(Vec<Waves<1>>),
}

/// All that a spectrum gives at one level.
struct Spectra<'a> {
    answers: &'a Answers,
    lines: &'a Lines,
    s: &'a [Complex64],
}

/// Of a value, what of it.
#[derive(Clone, Copy)]
struct Of {
    component: usize,
    rate: bool,
    slope: bool,
}

impl Spectra<'_> {
    /// Of a level, some signals.
    fn at(&self, at: At, wanted: &[Of]) -> Vec<Vec<f64>> {
        match self.answers {
            Answers::InPlane(waves) => {
                self.of(&waves.iter().map(|w| w.at(at.layer, at.above)).collect::<Vec<_>>(), wanted)
            }
            Answers::Across(waves) => {
                self.of(&waves.iter().map(|w| w.at(at.layer, at.above)).collect::<Vec<_>>(), wanted)
            }
        }
    }

    fn of<const V: usize>(&self, levels: &[Level<V>], wanted: &[Of]) -> Vec<Vec<f64>> {
        self.lines.through_each(wanted.iter().map(|&Of { component, rate, slope }| {
            levels.iter().zip(self.s).map(move |(level, s)| {
                let value = if slope { level.slope[component] } else { level.value[component] };
                value * if rate { *s } else { Complex64::from(1.0) }
            })
        }))
    }
}

impl Series {
    /// Of a wave in ground.
    ///
    /// # Errors
    /// If nothing arrives, and the ground rings longer than any span.
    pub fn of(ground: &LayeredGround, heading: &Heading, signal: &Signal) -> Result<Series, Rings> {
        let grid = Grid::new(ground, signal.frequency);
        let dt = 1.0 / (FINE * signal.frequency);
        let wanted = (signal.until / dt).ceil() as usize + 2;
        let mut count = (2 * wanted).next_power_of_two();
        // What is turned in phase begins before its cause, as what runs ahead does.
        if arrives(ground, heading) && signal.turned.is_none() {
            let eta = -LEFT.ln() / (count as f64 * dt);
            let answers = Answered::of(ground, heading, signal, dt, count, 0, eta);
            let scan = answers.scan(&grid);
            let peak = scan.velocity[..wanted].iter().copied().fold(0.0, f64::max);
            return Ok(answers.keep(grid, Stretch { first: 0, wanted, fade: 0 }, peak));
        }
        loop {
            count *= 2;
            let zero = count / 2;
            let answers = Answered::of(ground, heading, signal, dt, count, zero, 0.0);
            let scan = answers.scan(&grid);
            let end = zero + wanted;
            let peak = scan.velocity[..end].iter().copied().fold(0.0, f64::max);
            let still =
                |from: usize, to: usize| scan.velocity[from..to].iter().copied().fold(0.0, f64::max) / peak;
            let left = still(0, count / 16).max(still(count - count / 16, count));
            // In which a shear wave goes through the ground \[s\].
            let across = ground.strata().iter().map(|l| l.thickness / l.rock.s).sum();
            if left < STILL
                && let Some((start, fade)) = scan.beginning(end, dt, across)
            {
                let first = start - fade;
                return Ok(answers.keep(grid, Stretch { first, wanted: end - first, fade }, peak));
            }
            if count >= LONGEST {
                return Err(Rings { left, span: count as f64 * dt });
            }
        }
    }

    /// When the series begin \[s\] on the time of the signal, at the base of the reference point.
    fn sample(&self, time: f64) -> Option<(usize, f64)> {
        let place = (time - self.start) / self.dt;
        if place.is_nan() || place <= 0.0 {
            return None;
        }
        let index = (place as usize).min(self.samples - 2);
        Some((index, (place - index as f64).min(1.0)))
    }

    /// Components of displacement \[m\] at a height \[m\] above the base: (u_h, u_z), or u_t alone.
    pub fn displacement<const V: usize>(&self, height: f64, time: f64) -> [f64; V] {
        self.between(&self.moved, height, time)
    }

    /// Components of stress \[Pa\]: (σ_hh, σ_tt, σ_zz, σ_hz), or (σ_ht, σ_tz).
    pub fn stress<const V: usize>(&self, height: f64, time: f64) -> [f64; V] {
        self.between(&self.pulled, height, time)
    }

    fn between<const V: usize>(&self, kept: &[f32], height: f64, time: f64) -> [f64; V] {
        let mut out = [0.0; V];
        let Some((sample, x)) = self.sample(time) else { return out };
        let (level, cell, y) = self.grid.cell(height);
        let [t0, t1] = hermite(x);
        let [z0, z1] = hermite(y).map(|[value, slope]| [value, slope * cell]);
        let row = V * KEPT;
        for (level, z) in [(level, z0), (level + 1, z1)] {
            let [value, slope] = z;
            let at = (level * self.samples + sample) * row;
            for (t, kept) in [(t0, &kept[at..at + row]), (t1, &kept[at + row..at + 2 * row])] {
                for (out, k) in out.iter_mut().zip(kept.chunks_exact(KEPT)) {
                    let [f, ft, fz, ftz] = [0, 1, 2, 3].map(|i| f64::from(k[i]));
                    *out += t[0] * (value * f + slope * fz) + t[1] * (value * ft + slope * ftz);
                }
            }
        }
        out
    }

    /// What it takes of memory.
    pub fn bytes(&self) -> usize {
        4 * (self.moved.len() + self.pulled.len())
    }
}

/// Weights of value and slope at both ends of a unit interval.
fn hermite(x: f64) -> [[f64; 2]; 2] {
    let y = 1.0 - x;
    [[y * y * (1.0 + 2.0 * x), x * y * y], [x * x * (3.0 - 2.0 * x), -x * x * y]]
}

/// What levels do over the whole span, sample by sample.
struct Scan {
    /// The largest velocity of any level.
    velocity: Vec<f64>,
    /// By component the mean displacement.
    mean: Vec<Vec<f64>>,
}

impl Scan {
    /// Where a field that has no beginning is let begin: the sample from which on it is whole, and over how many before that it is faded
    /// in. `across` is the time of a wave through the ground \[s\].
    ///
    /// What is faded in over a time F disturbs itself: where it moves with v by some 2 v T/F, T the way of a wave, and where it has come
    /// to u by some 10 u T/F² and moves with 2 u/F meanwhile. So what moves fast may be faded in slowly, or what hardly moves quickly, alike
    /// good, and of all that begins latest is taken. A signal turned in phase falls with the second power of time alone where ∫u dt is
    /// not zero, and where it moves with [`STILL`] may be half a minute early.
    fn beginning(&self, end: usize, dt: f64, across: f64) -> Option<(usize, usize)> {
        let peak = self.velocity[..end].iter().copied().fold(0.0, f64::max);
        let mut most = 0.0_f64;
        let mut latest: Option<(usize, usize)> = None;
        for (start, v) in self.velocity[..end].iter().enumerate() {
            most = most.max(v / peak);
            if !(most <= SLOW) {
                break;
            }
            let come = self.mean.iter().map(|mean| mean[start].powi(2)).sum::<f64>().sqrt() / peak;
            let fade = [
                2.0 * across * (most / STILL).max(1.0),
                (10.0 * across * come / STILL).sqrt(),
                2.0 * come / SLOW,
                FINE * dt,
            ];
            let fade = (fade.into_iter().fold(0.0, f64::max) / dt).ceil() as usize;
            if start > fade + 1 && latest.is_none_or(|(of, its)| start - fade >= of - its) {
                latest = Some((start, fade));
            }
        }
        latest
    }
}

/// The part of a span that is kept.
struct Stretch {
    first: usize,
    wanted: usize,
    /// Samples over which it is faded in.
    fade: usize,
}

/// The answers to a signal at all its frequencies.
struct Answered {
    answers: Answers,
    lines: Lines,
    s: Vec<Complex64>,
    dt: f64,
    eta: f64,
    /// The sample of time 0.
    zero: usize,
    components: [usize; 2],
}

impl Answered {
    fn of(
        ground: &LayeredGround,
        heading: &Heading,
        signal: &Signal,
        dt: f64,
        count: usize,
        zero: usize,
        eta: f64,
    ) -> Answered {
        // What comes later changes nothing before where waves arrive, and little where they do not; faded out, it rings nowhere.
        let end = (count - zero) as f64 * dt;
        let out = if zero == 0 { end } else { 0.75 * end };
        let fade = |t: f64| match t {
            t if t <= signal.until => 1.0,
            t if t >= out => 0.0,
            t => 0.5 + 0.5 * (PI * (t - signal.until) / (out - signal.until)).cos(),
        };
        let sampled = |displacement: &dyn Fn(f64) -> f64| -> Vec<f64> {
            let sample = |k: usize| {
                let t = (k as f64 - zero as f64) * dt;
                if t < 0.0 { 0.0 } else { fade(t) * displacement(t) * (-eta * t).exp() }
            };
            (0..count).map(sample).collect()
        };
        let p = heading.slowness(&ground.below());
        let own = sampled(&signal.displacement);
        let lines = match signal.turned {
            Some(turned) => Lines::of_turned(&own, &sampled(&turned), dt),
            None => Lines::of(&own, dt),
        };
        let lines = lines.expect("a power of two is a length of a transform");
        let s: Vec<Complex64> =
            (0..lines.above(FAINT)).map(|k| Complex64::new(eta, lines.omega(k))).collect();
        let [one, none] = [1.0, 0.0].map(Complex64::from);
        let in_plane = |incident: [Complex64; 2]| {
            Answers::InPlane(s.par_iter().map(|&s| ground.p_sv(s, p, incident)).collect())
        };
        let answers = match heading.kind {
            WaveType::P => in_plane([one, none]),
            WaveType::Sv => in_plane([none, one]),
            WaveType::Sh => Answers::Across(s.par_iter().map(|&s| ground.sh(s, p)).collect()),
        };
        let components = components(heading.kind);
        Answered { answers, lines, s, dt, eta, zero, components }
    }

    fn spectra(&self) -> Spectra<'_> {
        Spectra { answers: &self.answers, lines: &self.lines, s: &self.s }
    }

    fn grown(&self, sample: usize) -> f64 {
        (self.eta * (sample as f64 - self.zero as f64) * self.dt).exp()
    }

    fn scan(&self, grid: &Grid) -> Scan {
        let moved = self.components[0];
        let wanted: Vec<Of> = [true, false]
            .into_iter()
            .flat_map(|rate| (0..moved).map(move |component| Of { component, rate, slope: false }))
            .collect();
        let of_level = |at: &At| -> Scan {
            let found = self.spectra().at(*at, &wanted);
            let (rates, values) = found.split_at(moved);
            let velocity = (0..rates[0].len())
                .map(|k| self.grown(k) * rates.iter().map(|rate| rate[k] * rate[k]).sum::<f64>().sqrt());
            Scan { velocity: velocity.collect(), mean: values.to_vec() }
        };
        let both = |mut a: Scan, b: Scan| {
            a.velocity.iter_mut().zip(b.velocity).for_each(|(a, b)| *a = a.max(b));
            let sums = a.mean.iter_mut().flatten().zip(b.mean.into_iter().flatten());
            sums.for_each(|(a, b)| *a += b);
            a
        };
        // One after the other, so that sums do not depend on threads; each block side by side.
        let mut all: Option<Scan> = None;
        for block in grid.levels.chunks(rayon::current_num_threads().max(1)) {
            let of_block: Vec<Scan> = block.par_iter().map(of_level).collect();
            for scan in of_block {
                all = Some(match all {
                    Some(sum) => both(sum, scan),
                    None => scan,
                });
            }
        }
        let mut all = all.unwrap_or(Scan { velocity: Vec::new(), mean: Vec::new() });
        all.mean.iter_mut().flatten().for_each(|sum| *sum /= grid.count() as f64);
        all
    }

    fn keep(&self, grid: Grid, stretch: Stretch, peak: f64) -> Series {
        let Stretch { first, wanted, fade } = stretch;
        let [moved, pulled] = self.components;
        let all: Vec<Of> = (0..moved + pulled)
            .flat_map(|component| {
                let kinds = [(false, false), (true, false), (false, true), (true, true)];
                kinds.map(|(rate, slope)| Of { component, rate, slope })
            })
            .collect();
        let of_level = |at: &At| -> [Vec<f32>; 2] {
            let found = self.spectra().at(*at, &all);
            [(0, moved), (moved, moved + pulled)].map(|(from, to)| {
                let mut kept = Vec::with_capacity(wanted * (to - from) * KEPT);
                for k in first..first + wanted {
                    let grown = self.grown(k);
                    let [ramp, steep] = faded(k - first, fade);
                    for component in from..to {
                        let [f, ft, fz, ftz] = [0, 1, 2, 3].map(|i| grown * found[component * KEPT + i][k]);
                        let own = [
                            ramp * f,
                            ramp * ft * self.dt + steep * f,
                            ramp * fz,
                            ramp * ftz * self.dt + steep * fz,
                        ];
                        // The wave comes in at the first sample, where round-off is all there is.
                        kept.extend(own.map(|x| if k == first { 0.0 } else { x as f32 }));
                    }
                }
                kept
            })
        };
        let of_levels: Vec<[Vec<f32>; 2]> = grid.levels.par_iter().map(of_level).collect();
        let whole = |k: usize| of_levels.iter().flat_map(|level| level[k].iter().copied()).collect();
        let start = (first as f64 - self.zero as f64) * self.dt;
        Series { dt: self.dt, start, samples: wanted, moved: whole(0), pulled: whole(1), grid, peak }
    }
}

/// A rise from 0 to 1 over so many samples, and its slope a sample.
fn faded(sample: usize, over: usize) -> [f64; 2] {
    if sample >= over {
        return [1.0, 0.0];
    }
    let x = PI * sample as f64 / over as f64;
    [0.5 - 0.5 * x.cos(), 0.5 * x.sin() * PI / over as f64]
}
