//! Courses of vectors in time, read at many instants at once.
//!
//! A free field that is given in advance keeps what boundaries ask of it in every step: at equal intervals a vector and its slope, cubics
//! between (Hermite). A read takes one cache line and sixteen products, so that what is left to save is how many there are: they
//! go side by side in [wide] registers.

use crate::soon::soon;
use tremolite_laws::Isa;

/// Does something with wide registers where the processor has them: to the same bits, as no operation is fused.
#[inline(always)]
pub fn wide<T>(something: impl FnOnce() -> T) -> T {
    #[cfg(target_arch = "x86_64")]
    if Isa::Avx2.available() {
        #[target_feature(enable = "avx2")]
        fn wide<T>(something: impl FnOnce() -> T) -> T {
            something()
        }
        // SAFETY: the processor has AVX2.
        return unsafe { wide(something) };
    }
    something()
}

/// Courses whose weights are found together.
const AT_ONCE: usize = 64;

/// What is kept at a sample: a vector with a place to spare, and its slope times the interval.
#[derive(Clone, Copy)]
#[repr(align(32))]
struct Sample([f32; 8]);

/// Added to a number below 2⁵¹ it leaves that rounded to a whole one, in the low bits of its fraction.
const WHOLE: f64 = 6_755_399_441_055_744.0;

/// Vectors in time, all with the same instants.
pub struct Courses {
    /// Of each course, and one more that reads of the last may touch.
    samples: usize,
    /// Course after course, sample after sample.
    kept: Vec<Sample>,
}

/// One course, later than it is by so many samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Asked {
    pub number: u32,
    pub late: f64,
}

/// Bytes of so many courses with so many samples.
pub fn bytes(courses: usize, samples: usize) -> usize {
    size_of::<Sample>() * courses * (samples + 1)
}

/// Where some courses are read: the sample before, and weights of vector and slope there and at the next.
struct Cells {
    sample: [u32; AT_ONCE],
    weights: [[f64; AT_ONCE]; 4],
}

impl Courses {
    /// So many at rest, with so many samples each.
    pub fn new(courses: usize, samples: usize) -> Self {
        Courses { samples, kept: vec![Sample([0.0; 8]); courses * (samples + 1)] }
    }

    /// All courses, each to be [kept](Course::keep).
    pub fn each(&mut self) -> impl Iterator<Item = Course<'_>> {
        self.kept.chunks_exact_mut(self.samples + 1).map(Course)
    }

    /// Vectors `place` samples after the first, rest before it and the last after it. Numbers that there are not are at rest.
    pub fn read(&self, asked: &[Asked], place: f64, out: &mut [[f64; 4]]) {
        wide(
            #[inline(always)]
            || self.read_each(asked, place, out),
        );
    }

    /// By how much vectors grow from one place to another.
    pub fn gained(&self, asked: &[Asked], between: [f64; 2], out: &mut [[f64; 4]]) {
        wide(
            #[inline(always)]
            || self.gained_each(asked, between, out),
        );
    }

    #[inline(always)]
    fn read_each(&self, asked: &[Asked], place: f64, out: &mut [[f64; 4]]) {
        for (asked, out) in asked.chunks(AT_ONCE).zip(out.chunks_mut(AT_ONCE)) {
            let cells = self.cells(&late(asked), place);
            self.expect(asked, &cells);
            for (k, (asked, out)) in asked.iter().zip(out).enumerate() {
                *out = self.at(asked.number, &cells, k);
            }
        }
    }

    #[inline(always)]
    fn gained_each(&self, asked: &[Asked], [from, to]: [f64; 2], out: &mut [[f64; 4]]) {
        for (asked, out) in asked.chunks(AT_ONCE).zip(out.chunks_mut(AT_ONCE)) {
            let late = late(asked);
            let [before, after] = [self.cells(&late, from), self.cells(&late, to)];
            self.expect(asked, &after);
            for (k, (asked, out)) in asked.iter().zip(out).enumerate() {
                let (a, b) = (self.at(asked.number, &before, k), self.at(asked.number, &after, k));
                (0..4).for_each(|i| out[i] = b[i] - a[i]);
            }
        }
    }

    #[inline(always)]
    fn cells(&self, late: &[f64; AT_ONCE], place: f64) -> Cells {
        let last = self.samples.saturating_sub(1) as f64;
        let mut cells = Cells { sample: [0; AT_ONCE], weights: [[0.0; AT_ONCE]; 4] };
        for (k, late) in late.iter().enumerate() {
            let place = place - late;
            let place = if place > 0.0 { place } else { 0.0 };
            let place = if place < last { place } else { last };
            // Of a sample itself the one before may come as well, which leaves the same.
            let whole = place - 0.5 + WHOLE;
            let x = place - (whole - WHOLE);
            let y = 1.0 - x;
            cells.sample[k] = whole.to_bits() as u32;
            cells.weights[0][k] = y * y * (1.0 + 2.0 * x);
            cells.weights[1][k] = x * y * y;
            cells.weights[2][k] = x * x * (3.0 - 2.0 * x);
            cells.weights[3][k] = -x * x * y;
        }
        cells
    }

    /// Where one of the courses is read.
    #[inline(always)]
    fn from(&self, number: u32, cells: &Cells, k: usize) -> usize {
        number as usize * (self.samples + 1) + cells.sample[k] as usize
    }

    /// Asks for the second of the samples that are read of each, by which the first has mostly come as well.
    #[inline(always)]
    fn expect(&self, asked: &[Asked], cells: &Cells) {
        asked
            .iter()
            .enumerate()
            .for_each(|(k, asked)| soon(&self.kept, self.from(asked.number, cells, k) + 1));
    }

    #[inline(always)]
    fn at(&self, number: u32, cells: &Cells, k: usize) -> [f64; 4] {
        let from = self.from(number, cells, k);
        let mut out = [0.0; 4];
        if let Some(two) = self.kept.get(from..from + 2) {
            for (sample, weights) in two.iter().zip(cells.weights.as_chunks::<2>().0) {
                for (part, weights) in sample.0.as_chunks::<4>().0.iter().zip(weights) {
                    let part = part.map(f64::from);
                    (0..4).for_each(|i| out[i] += weights[k] * part[i]);
                }
            }
        }
        out
    }

    /// What they take of memory.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.kept[..])
    }
}

/// By how many samples each is later.
#[inline(always)]
fn late(asked: &[Asked]) -> [f64; AT_ONCE] {
    let mut late = [0.0; AT_ONCE];
    late.iter_mut().zip(asked).for_each(|(late, asked)| *late = asked.late);
    late
}

/// One course as it is made.
pub struct Course<'a>(&'a mut [Sample]);

impl Course<'_> {
    /// Keeps at each sample a vector and its slope times the interval; at the first it is at rest.
    pub fn keep(self, course: &[[[f64; 4]; 2]]) {
        for (kept, [value, slope]) in self.0.iter_mut().zip(course).skip(1) {
            kept.0[..4].iter_mut().zip(value).for_each(|(kept, x)| *kept = *x as f32);
            kept.0[4..].iter_mut().zip(slope).for_each(|(kept, x)| *kept = *x as f32);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// t³ along x, 2 t² along y, of which cubics leave nothing, numbered by what they are times.
    fn courses() -> Courses {
        let samples = 40;
        let mut courses = Courses::new(5, samples);
        for (k, course) in courses.each().enumerate() {
            let at = |t: usize| {
                let (t, k) = (t as f64, k as f64);
                [[k * t * t * t, 2.0 * k * t * t, 0.0, 0.0], [3.0 * k * t * t, 4.0 * k * t, 0.0, 0.0]]
            };
            course.keep(&(0..samples).map(at).collect::<Vec<_>>());
        }
        courses
    }

    #[test]
    fn cubics_are_read_as_they_are_with_and_without_wide_registers() {
        let courses = courses();
        let asked: Vec<Asked> =
            (0..75).map(|k| Asked { number: k % 6, late: 0.37 * f64::from(k) - 2.0 }).collect();
        for place in [-3.0, 0.0, 0.5, 1.0, 11.0, 22.25, 38.0, 39.0, 70.0, f64::NAN] {
            let [mut found, mut narrow] = [0, 1].map(|_| vec![[f64::NAN; 4]; asked.len()]);
            courses.read(&asked, place, &mut found);
            courses.read_each(&asked, place, &mut narrow);
            assert_eq!(found, narrow);
            let [mut gained, mut narrow] = [0, 1].map(|_| vec![[f64::NAN; 4]; asked.len()]);
            courses.gained(&asked, [place - 0.7, place + 0.7], &mut gained);
            courses.gained_each(&asked, [place - 0.7, place + 0.7], &mut narrow);
            assert_eq!(gained, narrow);
            let exact = |asked: &Asked, place: f64| {
                // What is no place is read as rest; a clamp would keep it.
                let t = if place.is_nan() { 0.0 } else { (place - asked.late).clamp(0.0, 39.0) };
                let size = if asked.number < 5 { f64::from(asked.number) } else { 0.0 };
                [size * t * t * t, 2.0 * size * t * t]
            };
            for ((asked, found), gained) in asked.iter().zip(found).zip(gained) {
                let now = exact(asked, place);
                let [before, after] = [place - 0.7, place + 0.7].map(|place| exact(asked, place));
                for i in 0..2 {
                    assert!((found[i] - now[i]).abs() < 1e-9 * (1.0 + now[i]), "{asked:?} {place}");
                    let grown = after[i] - before[i];
                    assert!((gained[i] - grown).abs() < 1e-9 * (1.0 + after[i]), "{asked:?} {place}");
                }
            }
        }
    }
}
