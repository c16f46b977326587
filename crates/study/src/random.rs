//! Random numbers as a function of their place: the same on every machine and in every version, in whatever order they are asked
//! for.

/// The finaliser of SplitMix64 (`steele2014`): a bijection of 64 bits that leaves no pattern.
fn mixed(x: u64) -> u64 {
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

/// What is added from number to number: 2⁶⁴ over the golden ratio, odd.
const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// A stream of random numbers, told apart from others by a seed and a number of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stream(u64);

impl Stream {
    pub fn new(seed: u32, stream: u64) -> Stream {
        Stream(mixed(mixed(u64::from(seed).wrapping_add(STEP)) ^ stream.wrapping_mul(STEP)))
    }

    /// The number at a place, all 64 bits of it random.
    pub fn bits(self, place: u64) -> u64 {
        mixed(self.0.wrapping_add(place.wrapping_add(1).wrapping_mul(STEP)))
    }

    /// The number at a place, uniform in (0, 1) and neither of the two.
    pub fn uniform(self, place: u64) -> f64 {
        ((self.bits(place) >> 12) as f64 + 0.5) / (1_u64 << 52) as f64
    }

    /// The numbers from 0 to below `count` in random order.
    pub fn order(self, count: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..count).collect();
        // Equal bits, of 64, keep their order.
        order.sort_by_key(|&k| (self.bits(k as u64), k));
        order
    }

    /// A number from 0 to below `count`.
    pub fn below(self, place: u64, count: usize) -> usize {
        ((u128::from(self.bits(place)) * count as u128) >> 64) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From seed 1234567, the first numbers of SplitMix64 in Vigna's reference code (prng.di.unimi.it, splitmix64.c).
    #[test]
    fn numbers_are_those_of_split_mix() {
        let stream = Stream(1_234_567);
        let first: Vec<u64> = (0..3).map(|k| stream.bits(k)).collect();
        assert_eq!(first, [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423]);
    }

    #[test]
    fn uniform_numbers_fill_their_interval_and_streams_differ() {
        let stream = Stream::new(7, 3);
        let n = 20_000_u64;
        let mean = (0..n).map(|k| stream.uniform(k)).sum::<f64>() / n as f64;
        // Three standard errors of the mean, 3/√(12 n).
        assert!((mean - 0.5).abs() < 3.0 / (12.0 * n as f64).sqrt(), "{mean}");
        let other = Stream::new(7, 4);
        assert!((0..100).all(|k| stream.bits(k) != other.bits(k)));
        let mut order = stream.order(50);
        assert_ne!(order, Stream::new(8, 3).order(50));
        order.sort_unstable();
        assert_eq!(order, (0..50).collect::<Vec<_>>());
        assert!((0..1000).all(|k| stream.below(k, 7) < 7));
    }
}
