//! A figure's name for programs.

/// The words of a text in snake case: letters and digits of ASCII, Greek letters by their names, all else between words.
pub(crate) fn snake_case(text: &str) -> String {
    let mut words = String::new();
    for c in text.chars() {
        match c {
            'a'..='z' | '0'..='9' => words.push(c),
            'A'..='Z' => words.push(c.to_ascii_lowercase()),
            'é' => words.push('e'),
            '₀' => words.push('0'),
            _ => words.push_str(greek(c)),
        }
    }
    words.split('_').filter(|word| !word.is_empty()).collect::<Vec<_>>().join("_")
}

/// The name of a letter that stands in figures, as a word.
fn greek(c: char) -> &'static str {
    match c {
        'α' => "_alpha_",
        'β' => "_beta_",
        'Δ' => "_delta_",
        'ε' => "_epsilon_",
        'ν' => "_nu_",
        'ξ' => "_xi_",
        'φ' => "_phi_",
        'ψ' => "_psi_",
        'ω' => "_omega_",
        _ => "_",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_numbers_and_greek_letters_are_kept_and_nothing_else() {
        for (text, id) in [
            ("Lamé's, ν = 0.49", "lame_s_nu_0_49"),
            ("growth at ωΔt = 0.1, K u^{n+1}", "growth_at_omega_delta_t_0_1_k_u_n_1"),
            ("Mohr–Coulomb, ψ = 0° over p₀", "mohr_coulomb_psi_0_over_p0"),
            (" --_ ", ""),
        ] {
            assert_eq!(snake_case(text), id);
        }
    }
}
