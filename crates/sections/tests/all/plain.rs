//! Plain concrete by hand.

use super::rule;
use tremolite_sections::{Code, Plain, Rule};

#[test]
fn a_cracked_section_bears_what_is_compressed() {
    let plain = Plain { thickness: 0.5, compression: 10e6, tension: 0.0 };
    // e = 0.1 m leaves 0.3 m: 3 MN/m.
    assert!((plain.utilisation([-3e6, 0.3e6]) - 1.0).abs() < 1e-12);
    assert!((plain.utilisation([-1.5e6, -0.15e6]) - 0.5).abs() < 1e-12);
    // Nothing is left at e = h/2, and nothing holds tension.
    assert!(plain.utilisation([-1.0, 0.25]).is_infinite() && plain.utilisation([1.0, 0.0]).is_infinite());
    assert!((plain.utilisation([-5e6, 0.0]) - 1.0).abs() < 1e-12);
}

#[test]
fn tensile_strength_counts_in_the_elastic_section() {
    let plain = Plain { thickness: 0.5, compression: 10e6, tension: 1e6 };
    // Pure bending: 6 M / h² = f_t.
    let cracks = 1e6 * 0.25 / 6.0;
    assert!((plain.utilisation([0.0, cracks]) - 1.0).abs() < 1e-12);
    assert!((plain.utilisation([0.5e6, 0.0]) - 1.0).abs() < 1e-12);
    // With thrust enough the cracked section bears more than the sound one.
    assert!((plain.utilisation([-3e6, 0.3e6]) - 1.0).abs() < 1e-12);
}

#[test]
fn whether_it_counts_is_the_rules() {
    let with = rule(Code::En, "C25/30");
    let without = Rule { tension: false, ..with };
    let capacity = |rule: Rule| rule.capacity(0.5, &[], 1.0);
    let bending = [0.0, 1.8e6 * 0.25 / 6.0];
    assert!((capacity(with).utilisation(bending) - 1.0).abs() < 1e-12);
    assert!(capacity(without).utilisation(bending).is_infinite());
    // Strengths that have grown carry as much more.
    let grown = with.capacity(0.5, &[], 1.2);
    assert!((grown.utilisation(bending) - 1.0 / 1.2).abs() < 1e-12);
    for state in capacity(with).border() {
        assert!((capacity(with).utilisation(state) - 1.0).abs() < 1e-9);
    }
}
