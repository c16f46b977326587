//! Words of a study file.

use crate::keys::words;

words! {
    /// How samples of the varied keys are chosen.
    SampleKind {
        /// the case as it is, then each key at each of its values with the others as they are.
        OneAtATime = "one-at-a-time",
        /// all values of all keys with one another.
        Grid = "grid",
        /// random, one sample in each of `count` strata of every key (`mckay1979`).
        LatinHypercube = "latin-hypercube",
        /// a Sobol sequence with a random digital shift, for sums over many keys.
        Sobol = "sobol",
        /// the rows of a table of values, a file of comma-separated columns under the paths of the keys.
        Table = "table",
    }
}

words! {
    /// How samples, records and levels go together.
    Design {
        /// each sample with each record at each level.
        Cross = "cross",
        /// sample k with record k modulo the number of records, at each level.
        Paired = "paired",
    }
}

words! {
    /// What a run counts as that the guard stopped in its earthquake.
    FailedRun {
        /// beyond the limit.
        Exceeds = "exceeds",
        /// nothing: it is in no sum, which the page says.
        LeftOut = "left-out",
    }
}

words! {
    /// Which number of a column is taken.
    Take {
        /// the largest absolute value.
        MaxAbs = "max-abs",
        /// the largest.
        Max = "max",
        /// the smallest.
        Min = "min",
        /// the largest less the smallest.
        Range = "range",
        /// that of the first row.
        First = "first",
        /// that of the last row.
        Last = "last",
    }
}

words! {
    /// What stays of a run that is done.
    Keep {
        /// all that it wrote, but for the checkpoint.
        All = "all",
        /// summary, tables and page; fields for ParaView are removed.
        Tables = "tables",
    }
}

words! {
    /// Which checks of how far a run may be trusted are counted.
    Checks {
        /// those that it passed.
        Passed = "passed",
        /// those that it missed.
        Missed = "missed",
        /// both.
        Judged = "judged",
    }
}
