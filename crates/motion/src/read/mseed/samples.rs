//! Samples of one record, by the encodings of miniSEED.
//!
//! Steim's two compressions (SEED manual, appendix B): frames of sixteen words of 32 bits. The first word of a frame has two
//! bits for each of the others, which say with the topmost bits of that word how many differences of how many bits it
//! holds. The first frame has the first and the last sample in its second and third word; the very first difference leads
//! there from the record before and is passed over.

/// What codes of encodings are called; `None` for those that are not read.
pub(super) fn name(encoding: u8) -> Option<&'static str> {
    match encoding {
        1 => Some("16-bit integers"),
        3 => Some("32-bit integers"),
        4 => Some("32-bit floats"),
        5 => Some("64-bit floats"),
        10 => Some("Steim 1"),
        11 => Some("Steim 2"),
        _ => None,
    }
}

/// Whether samples of this encoding can be other than whole.
pub(super) fn is_float(encoding: u8) -> bool {
    matches!(encoding, 4 | 5)
}

/// `count` samples, all finite.
///
/// # Errors
/// A sentence that says what is wrong with the data.
pub(super) fn decode(encoding: u8, data: &[u8], count: usize, big: bool) -> Result<Vec<f64>, String> {
    let values: Vec<f64> = match encoding {
        1 => words(data, count, big, i16::from_be_bytes)?.map(f64::from).collect(),
        3 => words(data, count, big, i32::from_be_bytes)?.map(f64::from).collect(),
        4 => words(data, count, big, f32::from_be_bytes)?.map(f64::from).collect(),
        5 => words(data, count, big, f64::from_be_bytes)?.collect(),
        10 | 11 => steim(encoding == 11, data, count, big)?,
        _ => return Err(format!("its encoding, {encoding}, is not read")),
    };
    match values.iter().position(|v| !v.is_finite()) {
        Some(i) => Err(format!("sample {} of it is not a finite number", i + 1)),
        None => Ok(values),
    }
}

/// Numbers of `N` bytes each.
fn words<const N: usize, T>(
    data: &[u8],
    count: usize,
    big: bool,
    number: fn([u8; N]) -> T,
) -> Result<impl Iterator<Item = T>, String> {
    if data.len() / N < count {
        return Err(format!("it promises {count} samples of {N} bytes and has {} bytes of them", data.len()));
    }
    let words = data.chunks_exact(N).take(count).map(move |chunk| {
        let mut word = [0; N];
        word.copy_from_slice(chunk);
        if !big {
            word.reverse();
        }
        number(word)
    });
    Ok(words)
}

const FRAME: usize = 64;

fn steim(second: bool, data: &[u8], count: usize, big: bool) -> Result<Vec<f64>, String> {
    let all: Vec<u32> = words(data, data.len() / FRAME * (FRAME / 4), big, u32::from_be_bytes)?.collect();
    let short = |found: usize| format!("it promises {count} samples and has {found}");
    // A word holds seven differences at most.
    if all.len().saturating_mul(7) < count {
        return Err(short(0));
    }
    let mut samples = Vec::with_capacity(count);
    let (mut sample, mut last) = (0, 0);
    'frames: for (i, frame) in all.chunks_exact(FRAME / 4).enumerate() {
        let skipped = if i == 0 {
            // These are integers of 32 bits as they stand.
            (sample, last) = (frame[1] as i32, frame[2] as i32);
            2
        } else {
            0
        };
        for (k, &word) in frame.iter().enumerate().skip(1 + skipped) {
            let (bits, number) = match ((frame[0] >> (30 - 2 * k)) & 3, second, word >> 30) {
                (0, ..) => continue,
                (1, ..) => (8, 4),
                (2, false, _) => (16, 2),
                (3, false, _) => (32, 1),
                (2, true, 1) => (30, 1),
                (2, true, 2) => (15, 2),
                (2, true, 3) => (10, 3),
                (3, true, 0) => (6, 5),
                (3, true, 1) => (5, 6),
                (3, true, 2) => (4, 7),
                _ => return Err(format!("word {k} of frame {} has no code of Steim 2", i + 1)),
            };
            // The order of bytes is that of each number, and differences of 8 and 16 bits are numbers: in a little-endian word,
            // whose four bytes were turned round above, the first of them is the lowest. libmseed writes and reads it so.
            let word = match bits {
                8 if !big => word.swap_bytes(),
                16 if !big => word.rotate_left(16),
                _ => word,
            };
            for j in (0..number).rev() {
                // The difference's bits are moved to the top, and from there down again with its sign.
                let difference = ((word >> (bits * j)) << (32 - bits)) as i32 >> (32 - bits);
                if !samples.is_empty() {
                    sample = i32::wrapping_add(sample, difference);
                }
                samples.push(f64::from(sample));
                if samples.len() == count {
                    break 'frames;
                }
            }
        }
    }
    if samples.len() < count {
        return Err(short(samples.len()));
    }
    if sample != last {
        return Err(format!("its differences lead to {sample}, but it ends at {last} by its header"));
    }
    Ok(samples)
}
