//! The command `tremolite`.

mod commands;
mod exit;
mod machine;
mod terminal;

use clap::{Parser, Subcommand};

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

fn main() -> std::process::ExitCode {
    let result = match Cli::parse().command {
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
    match result {
        Ok(code) => code.into(),
        Err(failure) => {
            terminal::say(&failure.message);
            failure.code.into()
        }
    }
}
