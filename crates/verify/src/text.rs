//! What a problem says of itself.

use crate::Verification;
use crate::problems::{FILES, PROBLEMS};

/// What the problem's file begins with, in Markdown: formula, model, and what errs; empty for one that is not in the list.
pub fn text(problem: &Verification) -> String {
    let file = PROBLEMS.iter().position(|other| other.name == problem.name).map_or("", |k| FILES[k]);
    let lines = file.lines().map_while(|line| line.strip_prefix("//!"));
    lines.map(|line| line.strip_prefix(' ').unwrap_or(line)).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_problem_says_what_it_verifies() {
        for problem in PROBLEMS {
            let text = text(problem);
            assert!(text.len() > 100 && text.contains("\n\n"), "{}: a title and a text", problem.name);
        }
    }
}
