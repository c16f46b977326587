//! Characteristic strengths of concrete by its grade, up to C50.

use crate::Code;

/// Characteristic strengths \[Pa\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grade {
    /// f_ck
    pub compression: f64,
    /// f_ctk,0.05 (EN), f_tk (GB)
    pub tension: f64,
}

/// EN 1992-1-1 table 3.1: name, f_ck, f_ctk,0.05 \[MPa\].
const EN: [(&str, f64, f64); 9] = [
    ("C12/15", 12.0, 1.1),
    ("C16/20", 16.0, 1.3),
    ("C20/25", 20.0, 1.5),
    ("C25/30", 25.0, 1.8),
    ("C30/37", 30.0, 2.0),
    ("C35/45", 35.0, 2.2),
    ("C40/50", 40.0, 2.5),
    ("C45/55", 45.0, 2.7),
    ("C50/60", 50.0, 2.9),
];

/// GB 50010-2010 tables 4.1.3-1 and 4.1.3-2: name, f_ck, f_tk \[MPa\].
const GB: [(&str, f64, f64); 7] = [
    ("C20", 13.4, 1.54),
    ("C25", 16.7, 1.78),
    ("C30", 20.1, 2.01),
    ("C35", 23.4, 2.20),
    ("C40", 26.8, 2.39),
    ("C45", 29.6, 2.51),
    ("C50", 32.4, 2.64),
];

impl Grade {
    /// Of a code; nothing where it does not know the name.
    pub fn of(code: Code, name: &str) -> Option<Grade> {
        let found = table(code).iter().find(|(known, ..)| *known == name)?;
        Some(Grade { compression: found.1 * 1e6, tension: found.2 * 1e6 })
    }

    /// The names that a code knows.
    pub fn names(code: Code) -> impl Iterator<Item = &'static str> {
        table(code).iter().map(|(name, ..)| *name)
    }
}

fn table(code: Code) -> &'static [(&'static str, f64, f64)] {
    match code {
        Code::En => &EN,
        Code::Gb => &GB,
    }
}
