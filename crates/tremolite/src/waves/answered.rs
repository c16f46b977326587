//! The answers of the ground to a wave at all its frequencies, and what they make of it in time.

use super::grid::{At, FINE, Grid};
use super::ground::{ACROSS, IN_PLANE, LayeredGround, Level, Waves};
use super::heading::{Heading, WaveType};
use rayon::prelude::*;
use std::f64::consts::PI;
use tremolite_motion::{Complex64, Lines};

/// Velocity over the largest up to which a field that has no beginning may be faded in, and what fading in may disturb it by.
const SLOW: f64 = 1e-2;
const DISTURBED: f64 = 5e-4;
/// Lines of less than this share of the largest are none.
const FAINT: f64 = 1e-9;

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

/// Numbers kept of a value at a sample: it, its slope in time times the interval, both slopes upwards of these.
pub const KEPT: usize = 4;

/// How many components of displacement and of stress a wave has.
pub fn components(kind: WaveType) -> [usize; 2] {
    if kind == WaveType::Sh { [1, ACROSS - 1] } else { [2, IN_PLANE - 2] }
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

/// What levels do over the whole span, sample by sample.
pub struct Scan {
    /// The largest velocity of any level.
    pub velocity: Vec<f64>,
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
    /// not zero, and where it moves with a ten-thousandth of its largest velocity may be half a minute early.
    pub fn beginning(&self, end: usize, dt: f64, across: f64) -> Option<(usize, usize)> {
        let peak = self.velocity[..end].iter().copied().fold(0.0, f64::max);
        let mut most = 0.0_f64;
        let mut latest: Option<(usize, usize)> = None;
        for (start, v) in self.velocity[..end].iter().enumerate() {
            most = most.max(v / peak);
            if most > SLOW {
                break;
            }
            let come = self.mean.iter().map(|mean| mean[start].powi(2)).sum::<f64>().sqrt() / peak;
            let fade = [
                2.0 * across * (most / DISTURBED).max(1.0),
                (10.0 * across * come / DISTURBED).sqrt(),
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
pub struct Stretch {
    pub first: usize,
    pub wanted: usize,
    /// Samples over which it is faded in.
    pub fade: usize,
}

/// What is kept of all levels: components of displacement and of stress, each [`KEPT`] numbers, by level and sample; and when it begins
/// \[s\].
pub struct Kept {
    pub moved: Vec<f32>,
    pub pulled: Vec<f32>,
    pub start: f64,
}

/// The answers to a signal at all its frequencies.
pub struct Answered {
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
    pub fn of(
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

    pub fn scan(&self, grid: &Grid) -> Scan {
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

    pub fn keep(&self, grid: &Grid, stretch: &Stretch) -> Kept {
        let Stretch { first, wanted, fade } = *stretch;
        let [moved, pulled] = self.components;
        let all: Vec<Of> = (0..moved + pulled)
            .flat_map(|component| {
                let kinds = [(false, false), (true, false), (false, true), (true, true)];
                kinds.map(|(rate, slope)| Of { component, rate, slope })
            })
            .collect();
        let of_level = |(at, kept): (&At, [&mut [f32]; 2])| {
            let found = self.spectra().at(*at, &all);
            for ((from, to), kept) in [(0, moved), (moved, moved + pulled)].into_iter().zip(kept) {
                for (k, sample) in (first..).zip(kept.chunks_exact_mut((to - from) * KEPT)) {
                    let grown = self.grown(k);
                    let [ramp, steep] = faded(k - first, fade);
                    for (component, kept) in (from..to).zip(sample.chunks_exact_mut(KEPT)) {
                        let [f, ft, fz, ftz] = [0, 1, 2, 3].map(|i| grown * found[component * KEPT + i][k]);
                        let own = [
                            ramp * f,
                            ramp * ft * self.dt + steep * f,
                            ramp * fz,
                            ramp * ftz * self.dt + steep * fz,
                        ];
                        // The wave comes in at the first sample, where round-off is all there is.
                        let own = own.map(|x| if k == first { 0.0 } else { x as f32 });
                        kept.copy_from_slice(&own);
                    }
                }
            }
        };
        // Into what is kept at once: series beside it would take as much again.
        let sizes = self.components.map(|count| wanted * count * KEPT);
        let [mut moved, mut pulled] = sizes.map(|size| vec![0.0_f32; grid.count() * size]);
        let rows = moved.par_chunks_mut(sizes[0]).zip(pulled.par_chunks_mut(sizes[1]));
        grid.levels.par_iter().zip(rows.map(|(moved, pulled)| [moved, pulled])).for_each(of_level);
        Kept { moved, pulled, start: (first as f64 - self.zero as f64) * self.dt }
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
