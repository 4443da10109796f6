//! The verbs of the `lightbench` command.
//!
//! stdout carries results, and last the paths written, one a line; stderr carries progress, notes and
//! errors. Exit codes: 0 done, 1 a claim failed or a file could not be written, 2 wrong usage or input.

pub mod check;
pub mod compare;
mod render;

use crate::film::file::FileError;
use crate::kit::flags::Flags;
use crate::probe;
use clap::{Parser, Subcommand};
use compare::CompareError;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// An optical bench for learning light transport.
#[derive(Parser)]
#[command(name = "lightbench", version, about, max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
    #[command(flatten)]
    flags: Flags,
}

#[derive(Subcommand)]
enum Verb {
    /// Render scene files
    Render(render::RenderArgs),
    /// Compare two pictures: errors in numbers, and where they lie as a picture
    Compare { a: PathBuf, b: PathBuf },
    /// Report every problem in scene files
    Check {
        #[arg(required = true)]
        files: Vec<PathBuf>,
    },
    /// Evaluate a library function on each row of a table from stdin (`--list` shows the topics)
    Probe {
        /// What to compute
        topic: Option<String>,
        /// How, where there are several ways
        #[arg(long)]
        method: Option<String>,
    },
}

/// Why a verb failed, as an exit code and a message.
pub(crate) struct Failure {
    code: u8,
    message: String,
}

impl Failure {
    /// A mistake of the user's: exit code 2.
    pub(crate) fn input(message: impl ToString) -> Self {
        Failure { code: 2, message: message.to_string() }
    }

    /// Ctrl-C: the shell's code for an interrupt.
    pub(crate) fn interrupted() -> Self {
        Failure { code: 130, message: "interrupted: nothing was written".to_string() }
    }

    /// Something that could not be done: exit code 1.
    pub(crate) fn work(message: impl ToString) -> Self {
        Failure { code: 1, message: message.to_string() }
    }
}

/// The `lightbench` command.
pub fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => {
            let _ = error.print();
            return ExitCode::from(if error.use_stderr() { 2 } else { 0 });
        }
    };
    let done = match cli.verb {
        Verb::Render(args) => render::render(&args, &cli.flags),
        Verb::Compare { a, b } => compare_pictures(&a, &b, &cli.flags),
        Verb::Check { files } => check_files(&files),
        Verb::Probe { topic, method } => probe_table(topic.as_deref(), method.as_deref(), &cli.flags),
    };
    match done.and_then(|text| print(&text)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            let end = if failure.message.ends_with('\n') { "" } else { "\n" };
            eprint!("{}{end}", failure.message);
            ExitCode::from(failure.code)
        }
    }
}

/// Prints a result; a reader that closed the pipe has read enough.
fn print(text: &str) -> Result<(), Failure> {
    match std::io::stdout().write_all(text.as_bytes()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => Err(Failure::work(format!("stdout: {e}"))),
        _ => Ok(()),
    }
}

fn probe_table(topic: Option<&str>, method: Option<&str>, flags: &Flags) -> Result<String, Failure> {
    if flags.list {
        return Ok(probe::list());
    }
    let Some(topic) = topic else {
        return Err(Failure::input("probe: which topic? `probe --list` shows them"));
    };
    let topic = probe::topic(topic).map_err(|e| Failure::input(format!("probe: {e}")))?;
    let mut input = Vec::new();
    std::io::stdin().read_to_end(&mut input).map_err(|e| Failure::work(format!("stdin: {e}")))?;
    probe::run(topic, method, &input).map_err(|e| Failure::input(format!("probe {}: {e}", topic.name)))
}

/// Compares, and puts the error picture beside the other results.
fn compare_pictures(a: &Path, b: &Path, flags: &Flags) -> Result<String, Failure> {
    let stem = |path: &Path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let target = flags.out().join(format!("{}_minus_{}.png", stem(a), stem(b)));
    compare::compare(a, b, Some(&target)).map_err(|e| match &e {
        CompareError::File(FileError::Io { path, .. }) if *path == target => Failure::work(e),
        _ => Failure::input(e),
    })
}

/// Checks scene files one after the other; the reports are the result, and a file with problems fails.
fn check_files(files: &[PathBuf]) -> Result<String, Failure> {
    let color = render::stderr_color();
    let reports: Vec<_> = files.iter().map(|file| check::check(file, color)).collect();
    let (right, wrong): (Vec<_>, Vec<_>) = reports.into_iter().partition(|r| r.problems == 0);
    let texts = |reports: Vec<check::CheckReport>| reports.into_iter().map(|r| r.text).collect::<String>();
    if wrong.is_empty() {
        return Ok(texts(right));
    }
    print(&texts(right))?;
    Err(Failure::input(texts(wrong)))
}
