//! A segment of a bar: elastic, perfectly plastic from yield on, until it breaks.

use super::Bar;
use super::memory::{BROKEN, LinkMemory, YIELDED};
use crate::bolts::Bolts;

/// What a segment's force goes by.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// EA/L \[N/m\].
    pub stiffness: f64,
    /// N
    pub yields: f64,
    /// Elongation \[m\] beyond which it breaks.
    pub breaks: f64,
}

impl Link {
    #[inline(always)]
    pub fn of(bar: &Bar, kind: &Bolts) -> Self {
        Link { stiffness: bar.stiffness, yields: bar.yields, breaks: kind.breaks * bar.length }
    }

    /// Whether it carries what it is stretched to, and not what is kept or nothing.
    pub fn is_live(link: &LinkMemory) -> bool {
        link.status < BROKEN && link.kept == 0.0
    }

    /// Tension \[N\] at an elongation \[m\], before anything is remembered.
    #[inline(always)]
    pub fn trial(&self, link: &LinkMemory, elongation: f64) -> f64 {
        if link.status >= BROKEN {
            0.0
        } else if link.kept > 0.0 {
            link.kept
        } else {
            self.stiffness * (elongation - link.reference - link.plastic)
        }
    }

    /// Whether an elongation \[m\] breaks it.
    pub fn is_broken_by(&self, link: &LinkMemory, elongation: f64) -> bool {
        Link::is_live(link) && elongation - link.reference > self.breaks
    }

    /// Moves it to an elongation \[m\], and tells its tension \[N\]. What it dissipates is booked by the trapezoidal rule of the
    /// equations of motion, so that the balance closes in every step.
    #[inline(always)]
    pub fn update(&self, link: &mut LinkMemory, elongation: f64) -> f64 {
        if self.is_broken_by(link, elongation) {
            link.status = BROKEN;
        }
        let trial = self.trial(link, elongation);
        let force = trial.clamp(-self.yields, self.yields);
        let broken = link.status == BROKEN;
        if link.kept == 0.0 && (force != trial || broken) {
            let plastic = elongation - link.elongation - (force - link.force) / self.stiffness;
            link.dissipated += 0.5 * (force + link.force) * plastic;
            link.plastic = elongation - link.reference - force / self.stiffness;
            if link.status < YIELDED {
                link.status = YIELDED;
            }
        }
        (link.elongation, link.force) = (elongation, force);
        // What is not a number is the largest, so that it shows.
        if force.abs() > link.largest.abs() || force.is_nan() {
            link.largest = force;
        }
        force
    }
}
