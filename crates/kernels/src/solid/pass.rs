//! A pass of a kernel over the octets of a patch, in the instruction set of the machine.

#[cfg(target_arch = "x86_64")]
use super::any::AnyLaw;
use super::rule::Rule;
use super::weakened::Weakened;
use crate::part::{ElementEnergy, ProbeOut};
use tremolite_laws::band::BandStep;
use tremolite_laws::shapes::hex8::{Given, LEFT, Probe, Stabilisation};
use tremolite_laws::{Isa, Lane, Material, Octet, Point, Row};

/// Arguments of a pass over the octets of a patch.
pub(super) struct Pass<'a, R: Rule> {
    pub rule: &'a R,
    pub stabilisation: &'a Stabilisation,
    pub point: Point<f64>,
    pub index: &'a [[[u16; 8]; 8]],
    pub geometry: &'a [R::Geometry],
    pub history: &'a mut [Octet],
    pub band: Option<BandStep>,
    pub overstress: &'a mut [Octet],
    pub given: Given<'a>,
    pub rows: &'a [Row],
    pub out: &'a mut [Row],
    pub probe: Option<ProbeOut<'a>>,
    pub after: Option<After<'a>>,
}

/// A second product of the same octet while its geometry is at hand: the elastic stiffness in what the law has left, times a
/// factor of each element, with other rows.
pub(super) struct After<'a> {
    pub law: &'a Weakened,
    pub rows: &'a [Row],
    pub out: &'a mut [Row],
    /// An octet of elements each; 1 if empty.
    pub factor: &'a [Octet],
    /// Room for what is left at the points of an octet, [`LEFT`] octets each.
    pub left: &'a mut [Octet],
}

/// [`Rule::weakened`] in an instruction set, out of line: all laws share it.
type Second<R> = unsafe fn(
    &R,
    &Weakened,
    &Stabilisation,
    &<R as Rule>::Geometry,
    &[[u16; 8]; 8],
    &mut [Octet],
    &Octet,
    &[Row],
    &mut [Row],
);

#[inline(always)]
unsafe fn octets<L: Lane, R: Rule, M: Material, const PROBE: bool>(
    law: &M,
    pass: Pass<R>,
    second: Second<R>,
) {
    let rule = pass.rule;
    let facts = law.facts();
    let (per_octet, memory) = (rule.points() * facts.columns, rule.memory());
    let (mut wanted, mut after) = (pass.probe, pass.after);
    let mut probe = Probe { wanted: wanted.is_some(), ..Probe::ZERO };
    for (i, (index, geometry)) in pass.index.iter().zip(pass.geometry).enumerate() {
        let history = &mut pass.history[i * per_octet..(i + 1) * per_octet];
        let overstress = match pass.band {
            Some(_) => &mut pass.overstress[i * memory..(i + 1) * memory],
            None => &mut [],
        };
        let given = pass.given.of(i);
        let room: &mut [Octet] = match after.as_mut() {
            Some(after) => &mut *after.left,
            None => &mut [],
        };
        // SAFETY: `Solid::new` checked every index against the number of nodes, which both slices have.
        unsafe {
            rule.kernel::<L, M, PROBE>(
                law,
                pass.stabilisation,
                &pass.point,
                geometry,
                index,
                history,
                pass.band.as_ref(),
                overstress,
                given,
                room,
                pass.rows,
                pass.out,
                &mut probe,
            );
        }
        if PROBE && let Some(to) = wanted.as_mut() {
            keep(&probe, rule.points(), i, to);
        }
        if let Some(after) = after.as_mut() {
            let factor = after.factor.get(i).copied().unwrap_or(ONE);
            let left = &mut *after.left;
            if !facts.damages {
                for point in left.chunks_exact_mut(LEFT) {
                    point.copy_from_slice(&whole(factor));
                }
            }
            // SAFETY: as above; `dispatch` chose the function for the same instruction set.
            unsafe {
                second(
                    rule,
                    after.law,
                    pass.stabilisation,
                    geometry,
                    index,
                    left,
                    &factor,
                    after.rows,
                    after.out,
                )
            };
        }
    }
}

pub(super) const ONE: Octet = Octet([1.0; 8]);

/// What is left of a material without damage.
pub(super) fn whole(factor: Octet) -> [Octet; LEFT] {
    [ONE, ONE, ONE, Octet::ZERO, Octet::ZERO, Octet::ZERO, ONE, factor]
}

/// Copies an octet's probe to the places of its real elements.
fn keep(probe: &Probe, points: usize, octet: usize, to: &mut ProbeOut) {
    for lane in 0..8.min(to.energy.len() - 8 * octet) {
        let element = 8 * octet + lane;
        to.energy[element] = ElementEnergy {
            strain: probe.strain_energy.0[lane],
            hourglass: probe.hourglass_energy.0[lane],
            dissipated: probe.dissipated.0[lane],
            created: probe.created.0[lane],
            band: probe.of_band.0[lane],
        };
        for p in 0..points {
            to.stress[element * points + p] = [0, 1, 2, 3, 4, 5].map(|c| probe.stress[p][c].0[lane]);
        }
    }
}

#[cfg(target_arch = "x86_64")]
mod instances {
    use super::{Material, Octet, Pass, Row, Rule, Stabilisation, Weakened, octets};
    use tremolite_laws::lane::{Avx2, Avx512, Enabled};

    #[derive(Clone, Copy)]
    struct Here;
    // SAFETY: named below alone, in functions that `dispatch` calls where the instruction set is there.
    unsafe impl Enabled for Here {}

    #[target_feature(enable = "avx512f,avx2,fma")]
    pub(super) unsafe fn avx512<R: Rule, M: Material>(law: &M, pass: Pass<R>) {
        // SAFETY: this function enables the instruction set; indices were checked.
        unsafe { octets::<Avx512<Here>, R, M, false>(law, pass, second_avx512::<R>) }
    }

    #[target_feature(enable = "avx2,fma")]
    pub(super) unsafe fn avx2<R: Rule, M: Material, const PROBE: bool>(law: &M, pass: Pass<R>) {
        // SAFETY: as above.
        unsafe { octets::<Avx2<Here>, R, M, PROBE>(law, pass, second_avx2::<R>) }
    }

    macro_rules! seconds {
        ($($name:ident, $lane:ty, $features:literal;)*) => {$(
            #[target_feature(enable = $features)]
            #[inline(never)]
            pub(super) unsafe fn $name<R: Rule>(
                rule: &R,
                law: &Weakened,
                stabilisation: &Stabilisation,
                geometry: &R::Geometry,
                index: &[[u16; 8]; 8],
                left: &mut [Octet],
                factor: &Octet,
                rows: &[Row],
                out: &mut [Row],
            ) {
                // SAFETY: this function enables the instruction set; indices were checked.
                unsafe {
                    rule.weakened::<$lane>(law, stabilisation, geometry, index, left, factor, rows, out)
                }
            }
        )*};
    }

    seconds! {
        second_avx512, Avx512<Here>, "avx512f,avx2,fma";
        second_avx2, Avx2<Here>, "avx2,fma";
    }
}

/// Runs a pass of every step.
pub(super) fn dispatch<R: Rule, M: Material>(isa: Isa, law: &M, pass: Pass<R>) {
    match isa {
        // SAFETY: `Solid::new` keeps only available instruction sets, and checked all indices.
        #[cfg(target_arch = "x86_64")]
        Isa::Avx512 => unsafe { instances::avx512::<R, M>(law, pass) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        Isa::Avx2 if !R::PROBING_STEPS => unsafe { instances::avx2::<R, M, false>(law, pass) },
        _ => dispatch_rare::<R, M, true>(isa, law, pass),
    }
}

/// Runs a pass that is rare beside the steps: eight lanes are not worth the time that their instance takes to compile. The bits
/// are the same.
pub(super) fn dispatch_rare<R: Rule, M: Material, const PROBE: bool>(isa: Isa, law: &M, pass: Pass<R>) {
    match isa {
        // SAFETY: as above; whoever has AVX-512F has AVX2.
        #[cfg(target_arch = "x86_64")]
        Isa::Avx512 | Isa::Avx2 => unsafe { instances::avx2::<R, M, PROBE>(law, pass) },
        _ => reference::<R, M, PROBE>(law, pass),
    }
}

/// A pass in one lane.
fn reference<R: Rule, M: Material, const PROBE: bool>(law: &M, pass: Pass<R>) {
    #[cfg(target_arch = "x86_64")]
    apart(&AnyLaw::of(law), pass);
    // SAFETY: `Solid::new` checked all indices.
    #[cfg(not(target_arch = "x86_64"))]
    unsafe {
        octets::<f64, R, M, PROBE>(law, pass, R::weakened::<f64>)
    }
}

/// Where there are instruction sets one lane is there to compare with and for old machines: one instance of each quadrature, for
/// [`AnyLaw`] law, which probes whether that is wanted or not, is enough.
#[cfg(target_arch = "x86_64")]
#[inline(never)]
fn apart<R: Rule>(law: &AnyLaw, pass: Pass<R>) {
    // SAFETY: `Solid::new` checked all indices.
    unsafe { octets::<f64, R, AnyLaw, true>(law, pass, R::weakened::<f64>) }
}

/// Runs a product of the elasticity that is left at the points of each octet ([`LEFT`] octets each, the same for all octets), times
/// `factor`, 1 if empty.
pub(super) fn products<R: Rule>(
    isa: Isa,
    law: &Weakened,
    pass: Pass<R>,
    factor: &[Octet],
    left: &mut [Octet],
) {
    let second: Second<R> = match isa {
        #[cfg(target_arch = "x86_64")]
        Isa::Avx512 => instances::second_avx512::<R>,
        #[cfg(target_arch = "x86_64")]
        Isa::Avx2 => instances::second_avx2::<R>,
        _ => R::weakened::<f64>,
    };
    for (i, (index, geometry)) in pass.index.iter().zip(pass.geometry).enumerate() {
        let factor = factor.get(i).unwrap_or(&ONE);
        // SAFETY: `Solid::new` keeps only available instruction sets, and checked all indices.
        unsafe {
            second(pass.rule, law, pass.stabilisation, geometry, index, left, factor, pass.rows, pass.out)
        }
    }
}
