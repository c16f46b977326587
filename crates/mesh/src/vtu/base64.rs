//! Bytes written in base64.

use std::io::{self, BufRead, Read};

/// Bytes in base64. Padding may stand in the middle, where a header was encoded on its own; blanks are passed over,
/// and anything else ends them.
///
/// The reader of the crate `base64` does not serve: after padding it takes nothing more, and a blank is an error to it. Files may
/// also hold both within what it reads ahead, so it would need a reader before it that knows all digits, as this one does.
pub(super) struct Base64<R> {
    from: R,
    bits: u32,
    filled: u32,
}

impl<R: BufRead> Base64<R> {
    pub(super) fn new(from: R) -> Self {
        Base64 { from, bits: 0, filled: 0 }
    }
}

impl<R: BufRead> Read for Base64<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let mut count = 0;
        while count < into.len() {
            let text = self.from.fill_buf()?;
            if text.is_empty() {
                break;
            }
            let (mut used, mut ended) = (0, false);
            for &c in text {
                if count == into.len() {
                    break;
                }
                used += 1;
                let digit = match c {
                    b'A'..=b'Z' => c - b'A',
                    b'a'..=b'z' => c - b'a' + 26,
                    b'0'..=b'9' => c - b'0' + 52,
                    b'+' => 62,
                    b'/' => 63,
                    b'=' => {
                        (self.bits, self.filled) = (0, 0);
                        continue;
                    }
                    _ if c.is_ascii_whitespace() => continue,
                    _ => {
                        // It is left where it is, and ends every later read as well.
                        (used, ended) = (used - 1, true);
                        break;
                    }
                };
                self.bits = (self.bits << 6) | u32::from(digit);
                self.filled += 6;
                if self.filled >= 8 {
                    self.filled -= 8;
                    into[count] = (self.bits >> self.filled) as u8;
                    count += 1;
                    self.bits &= (1 << self.filled) - 1;
                }
            }
            self.from.consume(used);
            if ended {
                break;
            }
        }
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_decoded_across_padding_however_much_is_asked_for() {
        for (text, exact) in [
            // RFC 4648, section 10.
            (b"Zm9vYmFy".as_slice(), b"foobar".as_slice()),
            (b"Zm9v\n Yg==Zm8=Zg==", b"foobfof"),
            (b"Zm9v*Zm9v", b"foo"),
            (b"Z*", b""),
        ] {
            for step in 1..9 {
                let mut reader = Base64::new(text);
                let mut all = Vec::new();
                while (&mut reader).take(step).read_to_end(&mut all).unwrap() > 0 {}
                assert_eq!(all, exact, "{step}");
            }
        }
    }
}
