//! The verbs of the `lightbench` command.
//!
//! stdout carries results, and last the paths written, one a line; stderr carries progress, notes and
//! errors. Exit codes: 0 done, 1 a claim failed or a file could not be written, 2 wrong usage or input, and 129, 130 or
//! 143 when stopped by a signal (SIGHUP, SIGINT, SIGTERM).

pub mod check;
mod convert;
mod figures;
mod render;
mod target;
mod usage;

use clap::{FromArgMatches, Parser, Subcommand};
use lightbench_kit::compare;
use lightbench_kit::flags::Flags;
use lightbench_kit::probe;
use lightbench_kit::progress::{say, stop_code};
use lightbench_kit::scene_file::Color;
use std::io::{IsTerminal, Read, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use target::Out;

/// An optical bench for learning light transport.
#[derive(Parser)]
#[command(name = "lightbench", version, propagate_version = true, max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
}

const CHECK: &str = "\
Report every problem in scene and `.csg` files (`--list` shows what may stand in one).
A `.csg` file is read as this tracer reads it for `CSG { Source \"x.csg\" }`: with its own blocks and
parameters, marked † in that list, which document D's editor may not read.";

const CONVERT: &str = "\
Write the trees of solids of scene files as `.csg` files.
This tracer reads them with `CSG { Source \"x.csg\" }`. Where a tree has the tracer's own blocks and
parameters, marked † in `lightbench check --list`, document D's editor may not read the file.";

#[derive(Subcommand)]
enum Verb {
    /// List the lessons
    List(Flags),
    /// Run the lessons and make every figure and the page `index.html`
    Figures(Flags),
    /// Render scene files
    Render(render::RenderArgs),
    /// Compare two pictures: errors in numbers, and where they lie as a picture
    Compare {
        /// The picture to judge
        a: PathBuf,
        /// The reference
        b: PathBuf,
        #[command(flatten)]
        flags: Flags,
    },
    /// Report every problem in scene and `.csg` files (`--list` shows what may stand in one)
    #[command(long_about = CHECK)]
    Check {
        /// Scene files and `.csg` files
        files: Vec<PathBuf>,
        #[command(flatten)]
        flags: Flags,
    },
    /// Write the trees of solids of scene files as `.csg` files
    #[command(long_about = CONVERT)]
    Convert {
        /// Scene files; those with several trees make several files
        files: Vec<PathBuf>,
        #[command(flatten)]
        flags: Flags,
    },
    /// Evaluate a library function on each row of a table from stdin (`--list` shows the topics)
    Probe {
        /// What to compute
        topic: Option<String>,
        /// How, where there are several ways
        #[arg(long)]
        method: Option<String>,
        /// A file with data, for topics that need one
        #[arg(long, value_name = "FILE")]
        data: Option<PathBuf>,
        #[command(flatten)]
        flags: Flags,
    },
}

impl Verb {
    /// Its name and its flags.
    fn flags(&self) -> (&'static str, &Flags) {
        match self {
            Verb::List(flags) => ("list", flags),
            Verb::Figures(flags) => ("figures", flags),
            Verb::Render(args) => ("render", &args.flags),
            Verb::Compare { flags, .. } => ("compare", flags),
            Verb::Check { flags, .. } => ("check", flags),
            Verb::Convert { flags, .. } => ("convert", flags),
            Verb::Probe { flags, .. } => ("probe", flags),
        }
    }

    fn run(&self) -> Result<String, Failure> {
        match self {
            Verb::List(flags) => figures::list(flags.only.as_deref()),
            Verb::Figures(flags) => figures::figures(flags),
            Verb::Render(args) => render::render(args),
            Verb::Compare { a, b, flags } => compare_pictures(a, b, flags),
            Verb::Check { files, flags } => check_files(files, flags),
            Verb::Convert { files, flags } => convert::convert(files, flags),
            Verb::Probe { topic, method, data, flags } => {
                probe_table(topic.as_deref(), method.as_deref(), data.as_deref(), flags)
            }
        }
    }
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

    /// Stopped by a signal: the shell's code for it.
    pub(crate) fn interrupted(name: &str) -> Self {
        Failure { code: stop_code(), message: format!("interrupted: {name} was not written") }
    }

    /// Something that could not be done: exit code 1.
    pub(crate) fn work(message: impl ToString) -> Self {
        Failure { code: 1, message: message.to_string() }
    }
}

/// The `lightbench` command.
pub fn main() -> ExitCode {
    let cli = match usage::command().try_get_matches().and_then(|m| Cli::from_arg_matches(&m)) {
        Ok(cli) => cli,
        Err(error) => {
            let _ = error.print();
            return ExitCode::from(if error.use_stderr() { 2 } else { 0 });
        }
    };
    let (verb, flags) = cli.verb.flags();
    let done = usage::without_effect(verb, flags).and_then(|()| cli.verb.run());
    match done.and_then(|text| print(&text)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            let end = if failure.message.ends_with('\n') { "" } else { "\n" };
            say(&format!("{}{end}", failure.message));
            ExitCode::from(failure.code)
        }
    }
}

/// Prints a result; a reader that closed the pipe has read enough.
fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = std::io::stdout();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => Err(Failure::work(format!("stdout: {e}"))),
        _ => Ok(()),
    }
}

/// Answers the table on stdin. What is wrong with the command itself is said before anything is read.
fn probe_table(
    topic: Option<&str>,
    method: Option<&str>,
    data: Option<&Path>,
    flags: &Flags,
) -> Result<String, Failure> {
    if flags.list {
        return Ok(probe::list());
    }
    let Some(topic) = topic else {
        return Err(Failure::input("probe: which topic? `probe --list` shows them"));
    };
    let topic = probe::topic(topic).map_err(|e| Failure::input(format!("probe: {e}")))?;
    let wrong = |e: probe::ProbeError| Failure::input(format!("probe {}: {e}", topic.name));
    topic.method(method).map_err(wrong)?;
    if let Some(data) = data {
        let message = "this topic takes no data; expected no --data, found";
        return Err(Failure::input(format!("probe {}: {message} `{}`", topic.name, data.display())));
    }
    if std::io::stdin().is_terminal() && !flags.quiet {
        say("probe: reading a table from the terminal; Ctrl-D ends it\n");
    }
    let mut input = Vec::new();
    std::io::stdin().read_to_end(&mut input).map_err(|e| Failure::input(format!("stdin: {e}")))?;
    probe::run(topic, method, &input).map_err(wrong)
}

/// Compares, and puts the error picture beside the other results.
fn compare_pictures(a: &Path, b: &Path, flags: &Flags) -> Result<String, Failure> {
    let stem = |path: &Path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let target = match target::named(flags.out.as_deref(), render::ENDINGS)? {
        Out::File(file) => file,
        Out::Folder(folder) => folder.join(format!("{}_minus_{}.png", stem(a), stem(b))),
    };
    let report = compare::compare(a, b, Some(&target)).map_err(Failure::input)?;
    match report.picture {
        Ok(picture) => Ok(report.table + &picture),
        Err(e) => {
            print(&report.table)?;
            Err(Failure::work(e))
        }
    }
}

/// Checks scene files one after the other; the reports are the result, and a file with problems fails. `--quiet` leaves
/// those of right files out.
fn check_files(files: &[PathBuf], flags: &Flags) -> Result<String, Failure> {
    if flags.list {
        return Ok(lightbench_kit::scene_file::reference());
    }
    if files.is_empty() {
        return Err(Failure::input(
            "check: expected scene files, found none (`check --list` shows what may stand in one)",
        ));
    }
    // Right files are reported on stdout, wrong ones on stderr: colours only where neither is a file.
    let color = if std::io::stdout().is_terminal() { render::stderr_color() } else { Color::Never };
    let reports: Vec<_> = files.iter().map(|file| check::check(file, color)).collect();
    let (right, wrong): (Vec<_>, Vec<_>) = reports.into_iter().partition(|r| r.problems == 0);
    let texts = |reports: Vec<check::CheckReport>| reports.into_iter().map(|r| r.text).collect::<String>();
    let right = if flags.quiet { String::new() } else { texts(right) };
    if wrong.is_empty() {
        return Ok(right);
    }
    print(&right)?;
    Err(Failure::input(texts(wrong)))
}
