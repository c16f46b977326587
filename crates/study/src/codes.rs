//! What the codes of practice take of several records: of three to six the largest result, of seven and more the mean
//! (EN 1998-1:2004, 4.3.3.4.3; GB 50011-2010, 5.1.2). Fewer than three are too few for a design.

/// Records from which the largest result counts.
pub const LEAST: usize = 3;
/// Records from which the mean counts.
pub const MEAN: usize = 7;

/// The result to design by, of that of each record; `largest` is the worst, which for a result that is worse the smaller it is would be
/// the smallest.
pub fn by_code(results: &[f64]) -> Option<f64> {
    match results.len() {
        few if few < LEAST => None,
        several if several < MEAN => results.iter().copied().reduce(f64::max),
        many => Some(results.iter().sum::<f64>() / many as f64),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_records_give_their_largest_and_seven_their_mean() {
        assert_eq!(by_code(&[]), None);
        assert_eq!(by_code(&[1.0, 2.0]), None);
        assert_eq!(by_code(&[1.0, 5.0, 3.0]), Some(5.0));
        assert_eq!(by_code(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]), Some(6.0));
        assert_eq!(by_code(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]), Some(4.0));
    }
}
