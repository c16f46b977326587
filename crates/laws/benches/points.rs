//! Cost of one point of each law and of the eigen-decomposition, in nanoseconds, by instruction set.
//!
//! `cargo bench -p tremolite-laws`. The smallest of many repetitions over 1,024 points, data in the second-level
//! cache: shared machines disturb upwards only. One thread.

use std::hint::black_box;
use std::time::Instant;
use tremolite_laws::lane::Lane;
use tremolite_laws::materials::{Concrete, DruckerPrager, Elastic, HoekBrown, MohrCoulomb};
use tremolite_laws::sym3::{Spectrum, eigen};
use tremolite_laws::{History, Isa, Material, Octet, Point, Value, Values};

const OCTETS: usize = 128;
const REPEATS: usize = 400;

type Tensors = [[Octet; 6]];

/// What is measured: a pass over tensors, with the law's history where it has one.
trait Pass: Sync {
    fn run<L: Lane>(&self, dt: f64, tensors: &Tensors, history: &mut [Octet], out: &mut [[Octet; 6]]);
    fn columns(&self) -> usize;
}

#[inline(always)]
fn load<L: Lane>(from: &[Octet; 6], at: usize) -> [L; 6] {
    [
        L::load(&from[0], at),
        L::load(&from[1], at),
        L::load(&from[2], at),
        L::load(&from[3], at),
        L::load(&from[4], at),
        L::load(&from[5], at),
    ]
}

#[inline(always)]
fn store<L: Lane>(values: [L; 6], to: &mut [Octet; 6], at: usize) {
    let mut k = 0;
    while k < 6 {
        values[k].store(&mut to[k], at);
        k += 1;
    }
}

/// A law along with its history. Where it does not `KEEP` that, every pass starts from the same one: a plastic law
/// has nothing left to return when the same strain comes again.
struct Law<M, const KEEP: bool = true>(M);

impl<M: Material, const KEEP: bool> Pass for Law<M, KEEP> {
    fn columns(&self) -> usize {
        M::HISTORY.len() * if KEEP { 1 } else { 2 }
    }

    #[inline(always)]
    fn run<L: Lane>(&self, dt: f64, tensors: &Tensors, history: &mut [Octet], out: &mut [[Octet; 6]]) {
        let columns = M::HISTORY.len();
        let mut point = Point::new(L::splat(dt));
        let mut i = 0;
        while i < 3 {
            point.size[i] = L::splat(0.25);
            i += 1;
        }
        let mut octet = 0;
        while octet < tensors.len() {
            let own = &mut history[octet * self.columns()..(octet + 1) * self.columns()];
            let to = if KEEP { 0 } else { columns };
            let mut at = 0;
            while at < 8 {
                let mut old = <M::History<L> as History<L>>::zero();
                let mut k = 0;
                while k < columns {
                    old.as_mut()[k] = L::load(&own[k], at);
                    k += 1;
                }
                let (stress, new) = self.0.update(&point, load::<L>(&tensors[octet], at), old);
                let mut k = 0;
                while k < columns {
                    new.as_ref()[k].store(&mut own[to + k], at);
                    k += 1;
                }
                store(stress, &mut out[octet], at);
                at += L::WIDTH;
            }
            octet += 1;
        }
    }
}

struct Decomposition {
    directions: bool,
}

impl Pass for Decomposition {
    fn columns(&self) -> usize {
        0
    }

    #[inline(always)]
    fn run<L: Lane>(&self, _: f64, tensors: &Tensors, _: &mut [Octet], out: &mut [[Octet; 6]]) {
        let mut octet = 0;
        while octet < tensors.len() {
            let mut at = 0;
            while at < 8 {
                let t = load::<L>(&tensors[octet], at);
                let result = if self.directions {
                    let e = eigen(&t);
                    e.recompose([e.values[0] + e.values[1], e.values[1], e.values[2]])
                } else {
                    let v = Spectrum::of(&t).values();
                    [v[0], v[1], v[2], v[0], v[1], v[2]]
                };
                store(result, &mut out[octet], at);
                at += L::WIDTH;
            }
            octet += 1;
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[derive(Clone, Copy)]
struct Here;
#[cfg(target_arch = "x86_64")]
// SAFETY: named in `avx2` and `avx512` alone, which `dispatch` calls where the instruction set is there.
unsafe impl tremolite_laws::lane::Enabled for Here {}

/// The scalar reference fuses products and sums as the wide lanes do; without FMA that is a library call.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn scalar<P: Pass>(pass: &P, dt: f64, tensors: &Tensors, history: &mut [Octet], out: &mut [[Octet; 6]]) {
    pass.run::<f64>(dt, tensors, history, out);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn avx2<P: Pass>(pass: &P, dt: f64, tensors: &Tensors, history: &mut [Octet], out: &mut [[Octet; 6]]) {
    pass.run::<tremolite_laws::lane::Avx2<Here>>(dt, tensors, history, out);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx2,fma")]
fn avx512<P: Pass>(pass: &P, dt: f64, tensors: &Tensors, history: &mut [Octet], out: &mut [[Octet; 6]]) {
    pass.run::<tremolite_laws::lane::Avx512<Here>>(dt, tensors, history, out);
}

#[cfg(target_arch = "x86_64")]
fn dispatch<P: Pass>(
    isa: Isa,
    pass: &P,
    dt: f64,
    t: &Tensors,
    history: &mut [Octet],
    out: &mut [[Octet; 6]],
) {
    // SAFETY: the caller asks for instruction sets that are there; FMA machines without AVX2 are not built.
    unsafe {
        match isa {
            Isa::Scalar => scalar(pass, dt, t, history, out),
            Isa::Avx2 => avx2(pass, dt, t, history, out),
            Isa::Avx512 => avx512(pass, dt, t, history, out),
        }
    }
}

#[cfg(not(target_arch = "x86_64"))]
fn dispatch<P: Pass>(_: Isa, pass: &P, dt: f64, t: &Tensors, history: &mut [Octet], out: &mut [[Octet; 6]]) {
    pass.run::<f64>(dt, t, history, out);
}

fn measure<P: Pass>(name: &str, pass: &P, dt: f64, size: f64) {
    let mut seed = 1u64;
    let mut random = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    let tensors: Vec<[Octet; 6]> =
        (0..OCTETS).map(|_| [0; 6].map(|_| Octet([0; 8].map(|_| size * random())))).collect();
    print!("{name:44}");
    for isa in [Isa::Avx512, Isa::Avx2, Isa::Scalar] {
        if !isa.available() {
            print!("{:>10}", "-");
            continue;
        }
        let mut history = vec![Octet::ZERO; OCTETS * pass.columns()];
        let mut out = vec![[Octet::ZERO; 6]; OCTETS];
        let mut best = f64::INFINITY;
        for _ in 0..REPEATS {
            let start = Instant::now();
            dispatch(isa, pass, dt, black_box(&tensors), &mut history, &mut out);
            best = best.min(start.elapsed().as_secs_f64());
            black_box(&out);
        }
        print!("{:>10.2}", best * 1e9 / (8 * OCTETS) as f64);
    }
    println!();
}

fn concrete(words: &[(&str, &str)]) -> Law<Concrete> {
    let mut values = Values::default();
    for (name, value) in [
        ("young", 25e9),
        ("poisson", 0.17),
        ("tensile_strength", 1.2e6),
        ("cohesion", 2e6),
        ("friction_angle", 46f64.to_radians()),
        ("fracture_energy", 130.0),
    ] {
        values = values.with(name, value);
    }
    for (name, word) in words {
        values.0.insert((*name).to_owned(), Value::Word((*word).to_owned()));
    }
    Law(Concrete::new(&values).expect("the bench's own parameters are valid"))
}

/// Strains of ±1e-5 stay elastic, of ±2e-3 yield at nearly every point, in shear, tension or both.
fn rocks() {
    let rock = Values::default().with("young", 10e9).with("poisson", 0.25).with("tensile_strength", 1e6);
    let cone = rock.clone().with("cohesion", 2.18e6).with("friction_angle", 42f64.to_radians());
    let cone = cone.with("dilation_angle", 10f64.to_radians());
    let soft = cone.clone().with_table(
        "softening",
        &[("plastic_shear_strain", &[0.0, 2e-3, 1e-2]), ("cohesion", &[2.18e6, 1.4e6, 1e6])],
    );
    let mass = rock.with("compressive_strength", 60e6).with("gsi", 60.0).with("m_i", 12.0);
    let dilatant = mass.clone().with("dilation_angle", 10f64.to_radians());
    for (state, size) in [("elastic", 1e-5), ("yielding", 2e-3)] {
        rock_law::<MohrCoulomb>(&cone, state, size);
        rock_law::<MohrCoulomb>(&soft, &format!("softening, {state}"), size);
        rock_law::<DruckerPrager>(&cone, state, size);
        rock_law::<HoekBrown>(&mass, state, size);
        rock_law::<HoekBrown>(&dilatant, &format!("dilatant, {state}"), size);
    }
}

fn rock_law<M: Material>(values: &Values, state: &str, size: f64) {
    let law = Law::<M, false>(M::new(values).expect("the bench's own parameters are valid"));
    measure(&format!("{}, {state}", M::NAME), &law, 1e-5, size);
}

fn main() {
    println!("{:44}{:>10}{:>10}{:>10}", "ns a point", "avx512", "avx2", "scalar");
    measure("principal values", &Decomposition { directions: false }, 0.0, 1.0);
    measure("eigen-decomposition and recomposition", &Decomposition { directions: true }, 0.0, 1.0);
    let rock = Values::default().with("young", 10e9).with("poisson", 0.25);
    measure(
        "elastic",
        &Law::<_, true>(Elastic::new(&rock).expect("the bench's own parameters are valid")),
        1e-5,
        1e-5,
    );
    rocks();
    for (rate, dt) in [("none", 1e-5), ("ceb", 1e-5)] {
        for (state, size) in [("below threshold", 8e-6), ("damaging", 2e-4)] {
            for (split, evolution) in
                [("effective", "residual"), ("compliance", "residual"), ("effective", "exponential")]
            {
                let law = concrete(&[("rate", rate), ("split", split), ("evolution", evolution)]);
                measure(&format!("concrete, rate {rate}, {split}, {evolution}, {state}"), &law, dt, size);
            }
        }
    }
}
