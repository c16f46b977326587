//! The command `tremolite` as a function of its arguments, which the program calls, and the script of the Python package.

mod commands;
mod exit;
mod machine;
mod ranks;
mod renamed;
mod signals;
mod terminal;

pub use commands::study::plan as study_plan;

use clap::{Parser, Subcommand};
use std::ffi::OsString;

/// Does the concrete lining of a cavern survive an earthquake?
#[derive(Parser)]
#[command(name = "tremolite", version, about, propagate_version = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Check a case and say what running it will take; computes nothing
    Check(commands::check::Args),
    /// Run a case
    Run(commands::run::Args),
    /// Run a study: cases that differ in their keys, records and levels of shaking
    Study(commands::study::Args),
    /// Write the report page again, from the result files alone
    Report(commands::report::Args),
    /// Run the verification problems and print each figure beside the exact one
    Verify(commands::verify::Args),
    /// Drive one law along a path: a material along strain and stress, an interface along gap and slip
    Law(commands::law::Args),
    /// Look at earthquake records and process them
    Motion(commands::motion::Args),
    /// Look at meshes, convert them, make them
    Mesh(commands::mesh::Args),
    /// Time the engine on a box of hexahedra
    Bench(commands::bench::Args),
    /// List what there is: materials, interfaces, bolts, boundaries, quantities, formats
    List(commands::list::Args),
    /// Print the JSON schema of case files, for completion in editors
    Schema,
    /// Write a small commented case to start from
    New(commands::new::Args),
}

/// Runs the command; the first argument is the program's name. `again` is what starts this program once more, as a study does for each run:
/// the program, and what stands before a command.
///
/// Returns the status to end with: 0 done, 1 failed for a physical or numerical reason, 2 bad input, 3 stopped by a signal. `run`
/// handles SIGINT, SIGTERM and SIGHUP from then on.
pub fn run(arguments: impl IntoIterator<Item = OsString>, again: Vec<OsString>) -> u8 {
    machine::starts_again_by(again);
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    if let Some(message) = renamed::option(&arguments) {
        terminal::say(&format!("error: {message}"));
        return exit::Code::BadInput as u8;
    }
    let asks_for_json = arguments.iter().any(|argument| argument == "--json");
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(told) => {
            // A closed pipe is no reason to fail.
            let _ = told.print();
            return told.exit_code() as u8;
        }
    };
    if ranks::is_one_of_several() && !matches!(cli.command, Command::Run(_)) {
        terminal::say("error: `run` alone works on several ranks; start other commands without mpirun");
        return exit::Code::BadInput as u8;
    }
    let result = match cli.command {
        Command::Check(args) => commands::check::run(&args),
        Command::Run(args) => commands::run::run(&args),
        Command::Study(args) => commands::study::run(&args),
        Command::Report(args) => commands::report::run(&args),
        Command::Verify(args) => commands::verify::run(&args),
        Command::Law(args) => commands::law::run(&args),
        Command::Motion(args) => commands::motion::run(&args),
        Command::Mesh(args) => commands::mesh::run(&args),
        Command::Bench(args) => commands::bench::run(&args),
        Command::List(args) => commands::list::run(&args),
        Command::Schema => commands::list::schema(),
        Command::New(args) => commands::new::run(&args),
    };
    let code = match result {
        Ok(code) => code,
        Err(failure) => {
            if asks_for_json {
                terminal::print(&serde_json::to_string_pretty(&failure.json()).unwrap_or_default());
            }
            ranks::failed(&failure);
            failure.code
        }
    };
    ranks::end();
    code as u8
}
