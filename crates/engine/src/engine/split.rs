//! One slice cut into many.

use std::ops::Range;

/// The slice of `data` that belongs to each of `all`; their ranges ascend and may leave gaps.
pub(super) fn split<'d, T, S>(
    mut data: &'d mut [T],
    all: &[S],
    range: impl Fn(&S) -> Range<usize>,
) -> Vec<&'d mut [T]> {
    let mut at = 0;
    all.iter()
        .map(|one| {
            let range = range(one);
            let (before, rest) = std::mem::take(&mut data).split_at_mut(range.end - at);
            data = rest;
            let own = &mut before[range.start - at..];
            at = range.end;
            own
        })
        .collect()
}
