//! A pass over the pairs of a part, in the instruction set of the machine.

use super::Geometry;
use super::memory::{DAMPING, DISPLACEMENT, EXTRA, LARGEST, OFFSET, TRACTION, WORK};
use tremolite_laws::material::History;
use tremolite_laws::{Interface, Isa, Lane, Octet, Row};

/// Arguments of a pass.
pub(super) struct Pass<'a, I> {
    pub law: &'a I,
    pub geometry: &'a [Geometry],
    pub history: &'a mut [Octet],
    /// Displacements and increments of the part's nodes \[m\].
    pub rows: &'a [Row],
    pub increments: &'a [Row],
    pub out: &'a mut [Row],
    /// Pressure over the closing of a step \[Pa/m\]; 0 while time stands still.
    pub damping: f64,
}

/// a·b.
#[inline(always)]
fn dot<L: Lane>(a: &[L; 3], b: &[L; 3]) -> L {
    a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]))
}

/// x₂ − x₁ of a register of pairs.
///
/// # Safety
/// All indices must be in range of `rows`.
#[inline(always)]
unsafe fn across<L: Lane>(rows: &[Row], index: &[[u16; 8]; 2], at: usize) -> [L; 3] {
    // SAFETY: passed on to the caller.
    let [a, b] = unsafe { [L::gather(rows, &index[0], at), L::gather(rows, &index[1], at)] };
    [b[0] - a[0], b[1] - a[1], b[2] - a[2]]
}

/// Evaluates all pairs; what contact damping took \[J\].
#[inline(always)]
unsafe fn pairs<L: Lane, I: Interface>(pass: Pass<I>) -> f64 {
    let Pass { law, geometry, history, rows, increments, out, damping } = pass;
    let width = I::HISTORY.len() + EXTRA;
    let (zero, half) = (L::splat(0.0), L::splat(0.5));
    let mut taken = 0.0;
    for (octet, geometry) in geometry.iter().enumerate() {
        let own = &mut history[octet * width..(octet + 1) * width];
        let (of_law, extra) = own.split_at_mut(I::HISTORY.len());
        let mut force = [[Octet::ZERO; 3]; 2];
        let mut damped = Octet::ZERO;
        let mut at = 0;
        while at < 8 {
            let mut axes = [[zero; 3]; 3];
            for a in 0..3 {
                for i in 0..3 {
                    axes[a][i] = L::load(&geometry.axes[a][i], at);
                }
            }
            let area = L::load(&geometry.area, at);
            // SAFETY: `Contact::new` checked every index against the number of nodes, which all three slices have.
            let (mut d, step) = unsafe {
                (across::<L>(rows, &geometry.index, at), across::<L>(increments, &geometry.index, at))
            };
            for i in 0..3 {
                d[i] = d[i] - L::load(&extra[OFFSET + i], at);
            }
            let now = [dot(&d, &axes[0]), dot(&d, &axes[1]), dot(&d, &axes[2])];

            let mut old = <I::History<L> as History<L>>::zero();
            for (value, column) in old.as_mut().iter_mut().zip(of_law.iter()) {
                *value = L::load(column, at);
            }
            let (pressure, shear, new) = law.update(now[0], [now[1], now[2]], old);
            for (value, column) in new.as_ref().iter().zip(of_law.iter_mut()) {
                value.store(column, at);
            }

            // A dashpot on closed pairs whose bond is broken; it never pulls, and friction does not know of it.
            let state = new.as_ref()[I::STATE];
            let broken = half.less(state);
            let loose = L::both(broken, state.less(L::splat(2.5)));
            let closing = dot(&step, &axes[0]);
            let pushed = (L::splat(-damping) * closing).larger(-pressure);
            let pushed = L::select(loose, pushed, zero);
            let before = L::load(&extra[DAMPING], at);
            (L::splat(-0.5) * (before + pushed) * closing * area).store(&mut damped, at);
            pushed.store(&mut extra[DAMPING], at);

            let traction = [pressure, shear[0], shear[1]];
            let mut work = L::load(&extra[WORK], at);
            for i in 0..3 {
                let moved = now[i] - L::load(&extra[DISPLACEMENT + i], at);
                let mean = half * (L::load(&extra[TRACTION + i], at) + traction[i]);
                work = mean.neg_mul_add(moved, work);
                now[i].store(&mut extra[DISPLACEMENT + i], at);
                traction[i].store(&mut extra[TRACTION + i], at);
            }
            work.store(&mut extra[WORK], at);
            let slip = now[1].mul_add(now[1], now[2] * now[2]).sqrt();
            // What a bonded joint gives elastically is no gap and no slip.
            let apart = L::select(broken, now[0], zero);
            // At a sharp edge the slip of one pair is the gap of the other: it counts while the pair is closed.
            let slid = L::select(loose, slip, zero);
            let largest = &mut extra[LARGEST..];
            for (value, most) in [apart, slid, pressure].iter().zip(largest) {
                value.larger(L::load(most, at)).store(most, at);
            }

            let total = pressure + pushed;
            for i in 0..3 {
                let push =
                    axes[2][i].mul_add(shear[1], axes[1][i].mul_add(shear[0], axes[0][i] * total)) * area;
                // Parts resist: the second side is pushed by the traction.
                push.store(&mut force[0][i], at);
                (-push).store(&mut force[1][i], at);
            }
            at += L::WIDTH;
        }
        for side in 0..2 {
            // SAFETY: as above.
            unsafe { L::scatter_add(out, &geometry.index[side], &force[side]) };
        }
        for value in damped.0 {
            taken += value;
        }
    }
    taken
}

#[cfg(target_arch = "x86_64")]
mod instances {
    use super::{Interface, Pass, pairs};
    use tremolite_laws::lane::{Avx2, Avx512, Enabled};

    #[derive(Clone, Copy)]
    struct Here;
    // SAFETY: named below alone, in functions that `dispatch` calls where the instruction set is there.
    unsafe impl Enabled for Here {}

    macro_rules! instances {
        ($($name:ident, $lane:ty, $features:literal;)*) => {$(
            #[target_feature(enable = $features)]
            pub(super) unsafe fn $name<I: Interface>(pass: Pass<I>) -> f64 {
                // SAFETY: this function enables the instruction set; indices were checked.
                unsafe { pairs::<$lane, I>(pass) }
            }
        )*};
    }

    instances! {
        avx512, Avx512<Here>, "avx512f,avx2,fma";
        avx2, Avx2<Here>, "avx2,fma";
        scalar_fma, f64, "fma";
    }
}

pub(super) fn dispatch<I: Interface>(isa: Isa, pass: Pass<I>) -> f64 {
    // SAFETY: `Contact::new` keeps only available instruction sets, and checked all indices.
    unsafe {
        #[cfg(target_arch = "x86_64")]
        match isa {
            Isa::Avx512 => return instances::avx512(pass),
            Isa::Avx2 => return instances::avx2(pass),
            Isa::Scalar if is_x86_feature_detected!("fma") => return instances::scalar_fma(pass),
            Isa::Scalar => {}
        }
        let _ = isa;
        pairs::<f64, I>(pass)
    }
}
