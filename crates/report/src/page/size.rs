//! How large a page may be. Figures and words have what they need; the numbers for the script share what is left.

/// Bytes of the page of a small model, and of any other: 4 and 12 MB less what the lists of blocks may take.
const PAGE: [usize; 2] = [3_850_000, 11_800_000];
/// Elements that a small model has at most.
const SMALL: usize = 20_000;
/// Bytes that the view has in any case, so that it shows its linings.
pub const VIEW: usize = 350_000;

/// What the page of a model of so many elements may take, in bytes.
pub fn limit(elements: usize) -> usize {
    PAGE[usize::from(elements > SMALL)]
}
