//! Options with their names of before: they are refused, and the new name is given.

use std::ffi::OsString;

/// Command, option before, option now.
const RENAMED: [(&str, &str, &str); 5] = [
    ("run", "--from", "--start-from"),
    ("run", "--allow", "--ignore-resources"),
    ("study", "--at-once", "--jobs"),
    ("check", "--all", "--verbose"),
    ("check", "--allow", "--ignore-resources"),
];

/// What to say of the first option in the arguments that has another name now. The first argument is the program.
pub fn option(arguments: &[OsString]) -> Option<String> {
    let mut words = arguments.iter().skip(1).filter_map(|argument| argument.to_str());
    let command = words.next()?;
    words.take_while(|word| *word != "--").find_map(|word| {
        let (name, _) = word.split_once('=').unwrap_or((word, ""));
        let (_, old, new) = RENAMED.iter().find(|(of, old, _)| *of == command && *old == name)?;
        let more = match *old {
            "--all" => "; a model that is too large to check needs `--ignore-resources`",
            _ => "",
        };
        Some(format!("`{old}` of `tremolite {command}` is now `{new}`{more}"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_of_before_are_refused_with_the_new_name() {
        let said = |line: &str| option(&line.split(' ').map(OsString::from).collect::<Vec<_>>());
        assert_eq!(
            said("tremolite run a.toml --from=other").unwrap(),
            "`--from` of `tremolite run` is now `--start-from`"
        );
        assert!(said("tremolite run --allow a.toml").unwrap().contains("`--ignore-resources`"));
        assert!(said("tremolite study a.toml --at-once 2").unwrap().contains("`--jobs`"));
        assert!(said("tremolite check --all a.toml").unwrap().contains("`--verbose`"));
        for line in ["tremolite study a.toml --all", "tremolite run a.toml -- --allow", "tremolite"] {
            assert_eq!(said(line), None, "{line}");
        }
    }
}
