//! The command `tremolite`.

use std::process::ExitCode;

fn main() -> ExitCode {
    let again = std::env::current_exe().map_or_else(|_| "tremolite".into(), Into::into);
    ExitCode::from(tremolite_cli::run(std::env::args_os(), vec![again]))
}
