//! What is said of sections that are judged and of limits of acceptance, for people.

use crate::terminal::print;
use tremolite::job::Checked;

pub(super) fn print_judged(checked: &Checked) {
    let job = checked.job;
    if !job.plan.sections.is_empty() {
        print("\nSections");
    }
    for (section, by) in job.case.sections.iter().zip(&job.plan.sections) {
        let on: Vec<&str> = section.on.iter().map(|on| on.value.as_str()).collect();
        let factors = by.factors();
        let grade = if by.grade.is_empty() { "strengths as given" } else { by.grade.as_str() };
        print(&format!("           {}: {}, {grade}, {} elements", on.join(", "), by.code, by.elements.len()));
        print(&format!(
            "             γ_c {}, γ_s {}, α_cc {}, α_ct {}, γ_d {}; concrete × {} in the earthquake; crack widths {}",
            factors.gamma_c,
            factors.gamma_s,
            factors.alpha_cc,
            factors.alpha_ct,
            factors.gamma_d,
            factors.dynamic,
            match by.bar_diameter {
                Some(diameter) => format!("of bars of {:.0} mm", 1e3 * diameter),
                None => "by no code, without `bar_diameter`".to_owned(),
            }
        ));
    }
    let limits = &job.plan.page.limits;
    if !limits.is_empty() {
        print("\nLimits of acceptance");
    }
    for (name, limit) in limits {
        print(&format!("           {}", in_words(name, *limit)));
    }
}

fn in_words(name: &str, limit: f64) -> String {
    let millimetres = || format!("{} mm", trimmed(1e3 * limit));
    match name {
        "displacement" => {
            format!("displacement of a monitor, the ground's own included, up to {}", millimetres())
        }
        "relative_displacement" => {
            format!("displacement of two monitors against each other up to {}", millimetres())
        }
        "crack_width" => {
            format!(
                "cracks across bars up to {} wide; those parallel to the wall are told, not judged",
                millimetres()
            )
        }
        "damage" => format!("{} % of a lining's volume cracked", trimmed(100.0 * limit)),
        "crushing" => format!("{} % of a lining's volume crushed or sheared", trimmed(100.0 * limit)),
        "utilisation" => format!("utilisation of a section up to {}", trimmed(limit)),
        other => format!("{other} up to {limit}"),
    }
}

/// Without the round-off of a factor.
fn trimmed(x: f64) -> String {
    let text = format!("{x:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::in_words;

    #[test]
    fn limits_are_told_in_the_units_in_which_people_give_them() {
        assert!(in_words("crack_width", 3e-4).starts_with("cracks across bars up to 0.3 mm wide"));
        assert_eq!(in_words("damage", 0.1), "10 % of a lining's volume cracked");
        assert_eq!(in_words("utilisation", 0.95), "utilisation of a section up to 0.95");
    }
}
