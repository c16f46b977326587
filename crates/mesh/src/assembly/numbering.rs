//! From the numbers that a file uses to indices.

/// Finds the index of a number used in a file.
#[derive(Debug)]
pub(crate) enum Numbering {
    /// Numbers from `.0` on, one after the other; there are `.1`.
    Plain(u64, u64),
    /// Index by number, `u32::MAX` where there is none.
    Table(Vec<u32>),
    /// Numbers ascending, with their indices; for numbers with large gaps.
    Sorted(Vec<(u64, u32)>),
}

impl Numbering {
    /// The numbering in which `numbers[i]` means `i`.
    ///
    /// # Errors
    /// A number that is there twice.
    pub(crate) fn new(numbers: &[u64]) -> Result<Self, u64> {
        let first = numbers.first().copied().unwrap_or(1);
        if numbers.iter().enumerate().all(|(i, &n)| first.checked_add(i as u64) == Some(n)) {
            return Ok(Numbering::Plain(first, numbers.len() as u64));
        }
        let largest = numbers.iter().copied().max().unwrap_or(0);
        if largest <= 4 * numbers.len() as u64 + 1000 {
            let mut table = vec![u32::MAX; largest as usize + 1];
            for (index, &number) in numbers.iter().enumerate() {
                let entry = &mut table[number as usize];
                if *entry != u32::MAX {
                    return Err(number);
                }
                *entry = index as u32;
            }
            return Ok(Numbering::Table(table));
        }
        let mut sorted: Vec<(u64, u32)> = numbers.iter().zip(0..).map(|(&n, i)| (n, i)).collect();
        sorted.sort_unstable();
        match sorted.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            Some(pair) => Err(pair[0].0),
            None => Ok(Numbering::Sorted(sorted)),
        }
    }

    /// The index of a number.
    pub(crate) fn index(&self, number: u64) -> Option<u32> {
        match self {
            Numbering::Plain(first, count) => {
                let index = number.checked_sub(*first)?;
                (index < *count).then_some(index as u32)
            }
            Numbering::Table(table) => {
                let index = *table.get(usize::try_from(number).ok()?)?;
                (index != u32::MAX).then_some(index)
            }
            Numbering::Sorted(sorted) => {
                let place = sorted.binary_search_by_key(&number, |&(n, _)| n).ok()?;
                Some(sorted[place].1)
            }
        }
    }

    /// The indices of the numbers from `first` to `last` in steps of `step`, of those that are there; costs no
    /// more than there are numbers, however long the range.
    pub(crate) fn indices(&self, first: u64, last: u64, step: u64) -> Vec<u32> {
        let wanted =
            |number: u64| number >= first && number <= last && (number - first).is_multiple_of(step.max(1));
        match self {
            Numbering::Plain(start, count) => {
                let low = first.max(*start);
                let high = last.min(start.saturating_add(*count).saturating_sub(1));
                (low..=high).filter(|&n| wanted(n)).filter_map(|n| self.index(n)).collect()
            }
            Numbering::Table(table) => {
                let high = last.min(table.len() as u64);
                (first..=high).filter(|&n| wanted(n)).filter_map(|n| self.index(n)).collect()
            }
            Numbering::Sorted(sorted) => {
                let from = sorted.partition_point(|&(n, _)| n < first);
                let inside = sorted[from..].iter().take_while(|&&(n, _)| n <= last);
                inside.filter(|&&(n, _)| wanted(n)).map(|&(_, i)| i).collect()
            }
        }
    }
}

/// Numbers as a mesh keeps them: none if they are 1, 2, 3 …
pub(crate) fn kept(numbers: Vec<u64>) -> Vec<u64> {
    let plain = numbers.iter().zip(1..).all(|(&number, plain)| number == plain);
    if plain { Vec::new() } else { numbers }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_numbering_finds_its_numbers_and_no_other() {
        let plain: Vec<u64> = (7..20).collect();
        let shuffled = vec![5, 3, 9, 1];
        let huge = vec![u64::MAX, 4, 900_000_000_000];
        for numbers in [plain, shuffled, huge] {
            let numbering = Numbering::new(&numbers).unwrap();
            for (index, &number) in numbers.iter().enumerate() {
                assert_eq!(numbering.index(number), Some(index as u32));
            }
            for absent in [0, 2, 21, 899_999_999_999, u64::MAX - 1] {
                assert_eq!(numbering.index(absent), None, "{absent} in {numbering:?}");
            }
            let mut all = numbering.indices(0, u64::MAX, 1);
            all.sort_unstable();
            assert_eq!(all, (0..numbers.len() as u32).collect::<Vec<_>>());
        }
        assert_eq!(Numbering::new(&[5, 3, 9, 1]).unwrap().indices(1, 9, 4), [3, 0, 2]);
        assert_eq!(Numbering::new(&[3, 1, 3]).unwrap_err(), 3);
        assert_eq!(Numbering::new(&[3, 1 << 60, 3]).unwrap_err(), 3);
        assert_eq!(Numbering::new(&[]).unwrap().index(1), None);
    }
}
