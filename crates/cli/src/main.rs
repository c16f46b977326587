//! The command `tremolite`.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(tremolite_cli::run(std::env::args_os()))
}
