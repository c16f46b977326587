//! The standard normal distribution.

use std::f64::consts::{PI, SQRT_2};

/// The probability of a value at most x.
pub fn cdf(x: f64) -> f64 {
    0.5 * libm::erfc(-x / SQRT_2)
}

/// The density at x.
pub fn pdf(x: f64) -> f64 {
    libm::exp(-0.5 * x * x) / (2.0 * PI).sqrt()
}

/// φ(x)/Φ(x), also where both are too small to be told from 0.
pub fn hazard(x: f64) -> f64 {
    if x > -30.0 {
        pdf(x) / cdf(x)
    } else {
        // The continued fraction of Mills' ratio to its second term: an error below x⁻⁴.
        -x - 1.0 / x + 2.0 / (x * x * x)
    }
}

/// ln Φ(x), also where Φ is too small to be told from 0.
pub fn log_cdf(x: f64) -> f64 {
    if x > -30.0 {
        libm::log(cdf(x))
    } else {
        -0.5 * x * x - 0.5 * libm::log(2.0 * PI) - libm::log(hazard(x))
    }
}

/// The value that a share p of all lies below, 0 < p < 1: algorithm PPND16 of `wichura1988`, to 1e-16.
pub fn quantile(p: f64) -> f64 {
    let q = p - 0.5;
    if q.abs() <= 0.425 {
        let r = 0.180625 - q * q;
        return q * ratio(r, &CENTRAL);
    }
    let tail = if q < 0.0 { p } else { 1.0 - p };
    let r = (-libm::log(tail)).sqrt();
    let size = if r <= 5.0 { ratio(r - 1.6, &MIDDLE) } else { ratio(r - 5.0, &FAR) };
    if q < 0.0 { -size } else { size }
}

/// Numerator and denominator of a rational function, from the constant up.
type Ratio = [[f64; 8]; 2];

fn ratio(r: f64, [above, below]: &Ratio) -> f64 {
    let horner = |c: &[f64; 8]| c.iter().rev().fold(0.0, |sum, c| sum * r + c);
    horner(above) / horner(below)
}

const CENTRAL: Ratio = [
    [
        3.387_132_872_796_366_6,
        133.141_667_891_784_38,
        1_971.590_950_306_551_3,
        13_731.693_765_509_46,
        45_921.953_931_549_87,
        67_265.770_927_008_7,
        33_430.575_583_588_13,
        2_509.080_928_730_122_7,
    ],
    [
        1.0,
        42.313_330_701_600_91,
        687.187_007_492_057_9,
        5_394.196_021_424_751,
        21_213.794_301_586_597,
        39_307.895_800_092_71,
        28_729.085_735_721_943,
        5_226.495_278_852_854,
    ],
];
const MIDDLE: Ratio = [
    [
        1.423_437_110_749_683_5,
        4.630_337_846_156_546,
        5.769_497_221_460_691,
        3.647_848_324_763_204_5,
        1.270_458_252_452_368_4,
        0.241_780_725_177_450_6,
        0.022_723_844_989_269_184,
        7.745_450_142_783_414e-4,
    ],
    [
        1.0,
        2.053_191_626_637_759,
        1.676_384_830_183_803_8,
        0.689_767_334_985_1,
        0.148_103_976_427_480_08,
        0.015_198_666_563_616_457,
        5.475_938_084_995_345e-4,
        1.050_750_071_644_416_9e-9,
    ],
];
const FAR: Ratio = [
    [
        6.657_904_643_501_103,
        5.463_784_911_164_114,
        1.784_826_539_917_291_3,
        0.296_560_571_828_504_87,
        0.026_532_189_526_576_124,
        0.001_242_660_947_388_078_4,
        2.711_555_568_743_487_6e-5,
        2.010_334_399_292_288_1e-7,
    ],
    [
        1.0,
        0.599_832_206_555_888,
        0.136_929_880_922_735_8,
        0.014_875_361_290_850_615,
        7.868_691_311_456_133e-4,
        1.846_318_317_510_054_7e-5,
        1.421_511_758_316_446e-7,
        2.044_263_103_389_939_8e-15,
    ],
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantile_and_distribution_undo_each_other() {
        for k in 1..2000 {
            let p = f64::from(k) / 2000.0;
            assert!((cdf(quantile(p)) - p).abs() < 1e-15, "{p}");
        }
        for p in [1e-300, 1e-100, 1e-16, 1e-9, 1e-4] {
            // A change of x by one unit in the last place changes ln p by x² of them.
            assert!((cdf(quantile(p)) / p - 1.0).abs() < 1e-12, "{p}");
        }
        // scipy.special.ndtri of SciPy 1.17.1.
        assert!((quantile(0.975) - 1.959_963_984_540_054).abs() < 1e-15);
        assert!((quantile(1e-10) + 6.361_340_902_404_056).abs() < 1e-14);
    }

    #[test]
    fn far_tails_go_on_smoothly() {
        let (a, b) = (-29.999_999, -30.000_001);
        assert!((hazard(a) - hazard(b)).abs() < 1e-4 && (log_cdf(a) - log_cdf(b)).abs() < 1e-3);
        assert!((log_cdf(-40.0) + 804.608_442_013_753_6).abs() < 1e-6);
        assert!(log_cdf(-1e5).is_finite() && hazard(-1e5).is_finite());
    }
}
