//! What a part of pairs remembers of each, behind the columns of its law, and how it is read.

use tremolite_laws::material::History;
use tremolite_laws::{Interface, Octet, PairState};

/// d at activation \[m\], three columns.
pub(super) const OFFSET: usize = 0;
/// Gap and slips of the last evaluation \[m\], three columns.
pub(super) const DISPLACEMENT: usize = 3;
/// Pressure and shear t of the last evaluation \[Pa\], three columns.
pub(super) const TRACTION: usize = 6;
/// Pressure of the contact damping \[Pa\].
pub(super) const DAMPING: usize = 9;
/// Work of the law's tractions on the pair so far \[J/m²\], by the trapezoidal rule.
pub(super) const WORK: usize = 10;
/// Largest gap \[m\], slip \[m\] while closed with its bond broken, and pressure \[Pa\] so far, three columns.
pub(super) const LARGEST: usize = 11;
/// Columns of a pair behind those of its law.
pub const EXTRA: usize = 14;

/// Gap and slip \[m\] up to which a pair has not moved: the drift that a state at rest may have. Without initial stress pairs
/// without a bond open and slide by round-off.
const MOVED: f64 = 1e-9;

/// What is known of a pair after an evaluation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PairSeen {
    /// g \[m\], positive when open.
    pub gap: f64,
    /// s along e₁ and e₂ \[m\].
    pub slip: [f64; 2],
    /// p \[Pa\], positive in compression.
    pub pressure: f64,
    /// t on the second side along e₁ and e₂ \[Pa\].
    pub shear: [f64; 2],
    /// A [`tremolite_laws::PairState`] as a number.
    pub state: u8,
    /// Whether it slides or is open, by more than a nanometre.
    pub slides: bool,
    pub is_open: bool,
    /// Whether it ever slid or opened, likewise.
    pub has_slid: bool,
    pub has_opened: bool,
    /// Over all steps: largest gap \[m\], largest slip \[m\] while it was closed and its bond broken, and pressure \[Pa\].
    pub largest_gap: f64,
    pub largest_slip: f64,
    pub largest_pressure: f64,
    /// Taken by friction and breaking bonds so far \[J/m²\].
    pub friction: f64,
    /// Energy \[J/m²\] that the trapezoidal rule found or lost at impacts: stored + dissipated − created − work.
    pub impact_gain: f64,
}

/// A pair's history of its law, and the part's own columns.
pub(super) fn read<I: Interface>(octets: &[Octet], pair: usize) -> (I::History<f64>, [f64; EXTRA]) {
    let width = I::HISTORY.len() + EXTRA;
    let own = &octets[pair / 8 * width..][..width];
    let mut history = <I::History<f64> as History<f64>>::zero();
    for (value, octet) in history.as_mut().iter_mut().zip(own) {
        *value = octet.0[pair % 8];
    }
    let mut extra = [0.0; EXTRA];
    for (value, octet) in extra.iter_mut().zip(&own[I::HISTORY.len()..]) {
        *value = octet.0[pair % 8];
    }
    (history, extra)
}

/// See [`PairSeen`].
pub(crate) fn seen<I: Interface>(law: &I, octets: &[Octet], pair: usize) -> PairSeen {
    let (history, extra) = read::<I>(octets, pair);
    let column = |k: usize| history.as_ref()[k];
    let [gap, slip1, slip2] = [0, 1, 2].map(|i| extra[DISPLACEMENT + i]);
    let [pressure, t1, t2] = [0, 1, 2].map(|i| extra[TRACTION + i]);
    let stored = law.stored_energy(gap, [t1, t2], &history);
    PairSeen {
        gap,
        slip: [slip1, slip2],
        pressure,
        shear: [t1, t2],
        state: column(I::STATE) as u8,
        slides: column(I::STATE) == PairState::Sliding.number() && slip1.hypot(slip2) > MOVED,
        is_open: column(I::STATE) == PairState::Open.number() && gap > MOVED,
        has_slid: column(I::SLID) > 0.5 && extra[LARGEST + 1] > MOVED,
        has_opened: column(I::OPENED) > 0.5 && extra[LARGEST] > MOVED,
        largest_gap: extra[LARGEST],
        largest_slip: extra[LARGEST + 1],
        largest_pressure: extra[LARGEST + 2],
        friction: column(I::DISSIPATION),
        impact_gain: stored + column(I::DISSIPATION) - column(I::CREATION) - extra[WORK],
    }
}

/// The gap of a pair's last evaluation \[m\] alone: it is asked of all pairs, time and again.
pub(crate) fn gap<I: Interface>(octets: &[Octet], pair: usize) -> f64 {
    let width = I::HISTORY.len() + EXTRA;
    octets[pair / 8 * width + I::HISTORY.len() + DISPLACEMENT].0[pair % 8]
}

/// Puts values into columns of a pair, counted behind those of its law.
fn write<I: Interface>(octets: &mut [Octet], pair: usize, column: usize, values: &[f64]) {
    let first = pair / 8 * (I::HISTORY.len() + EXTRA) + I::HISTORY.len() + column;
    for (octet, value) in octets[first..].iter_mut().zip(values) {
        octet.0[pair % 8] = *value;
    }
}

/// The pair begins, unloaded, where its relative displacement is `d` \[m\].
pub(super) fn activate<I: Interface>(octets: &mut [Octet], pair: usize, d: [f64; 3]) {
    write::<I>(octets, pair, OFFSET, &d);
}

/// Work so far becomes what is stored and was spent, so that the gain counts from here.
pub(super) fn settle<I: Interface>(law: &I, octets: &mut [Octet], pair: usize) {
    let (_, extra) = read::<I>(octets, pair);
    let work = extra[WORK] + seen(law, octets, pair).impact_gain;
    write::<I>(octets, pair, WORK, &[work]);
}

/// The pair begins with a pressure and shear \[Pa\] where its relative displacement is `d` \[m\]; `normal` is its m.
pub(crate) fn load<I: Interface>(
    law: &I,
    octets: &mut [Octet],
    pair: usize,
    d: [f64; 3],
    normal: [f64; 3],
    pressure: f64,
    shear: [f64; 2],
) {
    let (gap, history) = law.start(pressure, shear);
    let width = I::HISTORY.len() + EXTRA;
    for (octet, value) in octets[pair / 8 * width..].iter_mut().zip(history.as_ref()) {
        octet.0[pair % 8] = *value;
    }
    write::<I>(octets, pair, OFFSET, &[0, 1, 2].map(|i| d[i] - gap * normal[i]));
    write::<I>(octets, pair, DISPLACEMENT, &[gap, 0.0, 0.0]);
    write::<I>(octets, pair, TRACTION, &[pressure, shear[0], shear[1]]);
    write::<I>(octets, pair, WORK, &[law.stored_energy(gap, shear, &history)]);
    write::<I>(octets, pair, LARGEST, &[gap.max(0.0), 0.0, pressure]);
}
