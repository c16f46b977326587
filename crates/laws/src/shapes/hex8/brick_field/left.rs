//! What damage has left in bricks of 2×2×2 points.

use super::super::field::FieldShape;
use super::super::full::{FullShape, SCALE};
use super::super::{LEFT, gather_modes, load_tensor, scatter_nodal, store_nodal};
use super::BrickField;
use crate::lane::{Lane, Octet, Row};
use crate::material::{Moduli, Sym};

/// Forces in bricks of the elasticity that damage has left ([`LEFT`] octets a point) times a factor of each element, added to `out`.
/// What a whole element would carry is integrated in closed form; points that damage has weakened take theirs off it.
///
/// # Safety
/// As for [`super::super::full`].
#[inline(always)]
pub unsafe fn bricks_left<L: Lane>(
    moduli: &Moduli,
    geometry: &BrickField,
    index: &[[u16; 8]; 8],
    left: &[Octet],
    factor: &Octet,
    rows: &[Row],
    out: &mut [Row],
) {
    let (zero, three) = (L::splat(0.0), L::splat(3.0));
    let mut nodal = [[Octet::ZERO; 3]; 8];
    let mut at = 0;
    while at < 8 {
        // SAFETY: passed on to the caller.
        let modes = unsafe { gather_modes::<L>(rows, index, at) };
        let e = geometry.strain::<L>(&modes, &SCALE, &[], at);
        let mut sums = geometry.elastic_resultants(moduli, &e, at);
        let mut traces = [zero; 8];
        let mut least = three;
        let mut p = 0;
        while p < 8 {
            let v = &left[p * LEFT..];
            traces[p] = L::load(&v[0], at) + L::load(&v[1], at) + L::load(&v[2], at);
            least = traces[p].smaller(least);
            p += 1;
        }
        if L::any(least.less(three)) {
            let mut values = e;
            BrickField::to_points(&mut values);
            let weight = geometry.weight::<L>(0, at);
            let mut p = 0;
            while p < 8 {
                let strain: Sym<L> =
                    [values[0][p], values[1][p], values[2][p], values[3][p], values[4][p], values[5][p]];
                let v = load_tensor(&left[p * LEFT..], at);
                let (whole, part) = (moduli.stress(&strain), moduli.stress_left(&strain, &v));
                // A closed crack leaves V at I but for the round-off of its axes: it carries all.
                let weight = L::select(traces[p].less(three), weight, zero);
                let mut c = 0;
                while c < 6 {
                    values[c][p] = weight * (part[c] - whole[c]);
                    c += 1;
                }
                p += 1;
            }
            BrickField::to_resultants(&mut values);
            let mut c = 0;
            while c < 6 {
                let mut mode = 0;
                while mode < 7 {
                    sums[c][mode] = sums[c][mode] + values[c][mode];
                    mode += 1;
                }
                c += 1;
            }
        }
        let factor = L::load(factor, at);
        let mut c = 0;
        while c < 6 {
            let mut mode = 0;
            while mode < 7 {
                sums[c][mode] = factor * sums[c][mode];
                mode += 1;
            }
            c += 1;
        }
        let mut forces = geometry.forces::<L>(sums, &SCALE, at);
        store_nodal(&mut forces, &mut nodal, at);
        at += L::WIDTH;
    }
    // SAFETY: passed on to the caller.
    unsafe { scatter_nodal::<L>(out, index, &nodal) };
}
