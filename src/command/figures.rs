//! `lightbench list` and `lightbench figures`: the lessons, and everything they draw.

use super::check::counted;
use super::{Failure, target};
use lightbench_kit::flags::Flags;
use lightbench_kit::lesson::{Entry, SYLLABUS};
use lightbench_kit::page;
use lightbench_kit::progress::{Progress, Verbosity, stop_flag};
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::atomic::Ordering;
use std::thread;
use std::time::Duration;

/// The lessons, or those that `--only` names by number or word, a line each.
pub(super) fn list(only: Option<&str>) -> Result<String, Failure> {
    let mut out = String::new();
    let mut chapter = "";
    for entry in chosen(only)? {
        if entry.chapter != chapter {
            chapter = entry.chapter;
            out += &format!("{chapter}\n");
        }
        out += &format!("  {}  {:<16} {}\n", entry.program(), entry.name, entry.question);
    }
    Ok(out)
}

/// The lessons that `--only` lets through, at least one.
fn chosen(only: Option<&str>) -> Result<Vec<&'static Entry>, Failure> {
    let chosen: Vec<&Entry> = SYLLABUS.iter().filter(|e| is_chosen(e, only)).collect();
    match only {
        Some(only) if chosen.is_empty() => {
            let numbers = format!(
                "a number from 1 to {}, or part of a name that `lightbench list` shows",
                SYLLABUS.len()
            );
            Err(Failure::input(format!("--only {only}: expected {numbers}")))
        }
        _ => Ok(chosen),
    }
}

/// Runs every lesson, or those that `--only` names by number or word, and makes the page.
pub(super) fn figures(flags: &Flags) -> Result<String, Failure> {
    if flags.list {
        return list(flags.only.as_deref());
    }
    let chosen = chosen(flags.only.as_deref())?;
    let folder = flags.out.clone().unwrap_or_else(|| PathBuf::from("figures"));
    target::writable(&folder.join("index.html"))?;
    let programs = programs()?;
    let verbosity = if flags.quiet { Verbosity::Quiet } else { Verbosity::Normal };
    let progress = Progress::start("figures", verbosity);
    let mut out = String::new();
    let mut failed = Vec::new();
    for (i, entry) in chosen.iter().enumerate() {
        let run = ended(lesson_command(&programs, entry, &folder, flags));
        let run = run.map_err(|e| Failure::work(format!("{}: cannot be run: {e}", entry.program())))?;
        if stop_flag().load(Ordering::Relaxed) {
            return Err(Failure::interrupted(&entry.program()));
        }
        out += &String::from_utf8_lossy(&run.stdout);
        out.push('\n');
        if !run.status.success() {
            failed.push(format!("{}: {}", entry.program(), String::from_utf8_lossy(&run.stderr).trim_end()));
        }
        progress.set((i + 1) as f64 / chosen.len() as f64);
    }
    let page = page::write(&folder).map_err(Failure::work)?;
    progress.finish(&counted(chosen.len(), "lesson"));
    out += &format!("{}\n", page.display());
    if failed.is_empty() {
        return Ok(out);
    }
    super::print(&out)?;
    Err(Failure::work(failed.join("\n")))
}

/// Runs a program to its end, or until this one is to stop: then it is ended too.
fn ended(mut command: Command) -> io::Result<Output> {
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()?;
    let streams: [Option<Box<dyn Read + Send>>; 2] = [
        child.stdout.take().map(|s| Box::new(s) as Box<dyn Read + Send>),
        child.stderr.take().map(|s| Box::new(s) as Box<dyn Read + Send>),
    ];
    // Both are read at once, or a full pipe would stop the program.
    let readers = streams.map(|stream| {
        thread::spawn(move || {
            let mut bytes = Vec::new();
            stream.map_or(Ok(0), |mut s| s.read_to_end(&mut bytes)).map(|_| bytes)
        })
    });
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        if stop_flag().load(Ordering::Relaxed) {
            child.kill()?;
            break child.wait()?;
        }
        thread::sleep(Duration::from_millis(20));
    };
    let [stdout, stderr] =
        readers.map(|r| r.join().unwrap_or_else(|_| Err(io::Error::other("a reader failed"))));
    Ok(Output { status, stdout: stdout?, stderr: stderr? })
}

fn is_chosen(entry: &Entry, only: Option<&str>) -> bool {
    only.is_none_or(|only| {
        entry.name.contains(only)
            || only.parse() == Ok(entry.number)
            || entry.program() == only
            || entry.stem() == only
    })
}

fn lesson_command(programs: &Path, entry: &Entry, folder: &Path, flags: &Flags) -> Command {
    let mut command =
        Command::new(programs.join(format!("{}{}", entry.program(), std::env::consts::EXE_SUFFIX)));
    command.arg("--out").arg(folder);
    // `--only` has chosen lessons here; within a lesson it would choose figures.
    let inside = Flags { only: None, ..flags.clone() };
    command.args(inside.canonical().split_whitespace());
    if let Some(threads) = flags.threads {
        command.args(["--threads", &threads.to_string()]);
    }
    if flags.quiet {
        command.arg("--quiet");
    }
    command
}

/// The folder of the lessons' programs: that of this program, after building them if it was started by cargo, which
/// builds only what it runs.
fn programs() -> Result<PathBuf, Failure> {
    let own =
        std::env::current_exe().map_err(|e| Failure::work(format!("this program cannot be found: {e}")))?;
    if let Some(cargo) = std::env::var_os("CARGO") {
        let mut build = Command::new(cargo);
        build.args(["build", "--package", "lightbench-lessons", "--bins", "--quiet"]);
        if own.components().any(|c| c.as_os_str() == "release") {
            build.arg("--release");
        }
        if let Some(manifest) = std::env::var_os("CARGO_MANIFEST_DIR") {
            build.arg("--manifest-path").arg(Path::new(&manifest).join("../../Cargo.toml"));
        }
        let status = build.status().map_err(|e| Failure::work(format!("cargo cannot be run: {e}")))?;
        if !status.success() {
            return Err(Failure::work("the lessons could not be built"));
        }
    }
    Ok(own.parent().unwrap_or(Path::new(".")).to_path_buf())
}
