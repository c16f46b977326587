//! Names and shares as briefly as the verdict has room for.

/// Characters of a group's name of which nothing is left out.
pub const NAME: usize = 48;
/// How many of a longer one's end are kept.
const END: usize = 12;

/// A name as it is, or without its middle.
pub fn short(name: &str, most: usize) -> String {
    let all: Vec<char> = name.chars().collect();
    match all.len() > most {
        true => {
            let [start, end] = [&all[..most - END - 1], &all[all.len() - END..]];
            format!(
                "{}…{}",
                start.iter().collect::<String>().trim_end(),
                end.iter().collect::<String>().trim_start()
            )
        }
        false => name.to_owned(),
    }
}

/// A share; a small one does not become zero.
pub fn percent(share: f64) -> String {
    match share {
        0.0 => "0".into(),
        s if s > 0.0 && s < 1e-3 => "<\u{a0}0.1\u{a0}%".into(),
        s => format!("{:.1}\u{a0}%", 100.0 * s),
    }
}
