//! `lightbench list` and `lightbench figures`: the lessons, and everything they draw.

use super::Failure;
use lightbench_kit::flags::Flags;
use lightbench_kit::lesson::{Entry, SYLLABUS};
use lightbench_kit::page;
use lightbench_kit::progress::{Progress, Verbosity, stop_flag};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::Ordering;

/// The lessons, a line each.
pub(super) fn list() -> String {
    let mut out = String::new();
    let mut chapter = "";
    for entry in SYLLABUS {
        if entry.chapter != chapter {
            chapter = entry.chapter;
            out += &format!("{chapter}\n");
        }
        out += &format!("  {}  {:<16} {}\n", entry.program(), entry.name, entry.question);
    }
    out
}

/// Runs every lesson, or those that `--only` names by number or word, and makes the page.
pub(super) fn figures(flags: &Flags) -> Result<String, Failure> {
    if flags.list {
        return Ok(list());
    }
    let chosen: Vec<&Entry> = SYLLABUS.iter().filter(|e| is_chosen(e, flags.only.as_deref())).collect();
    if chosen.is_empty() {
        let only = flags.only.as_deref().unwrap_or_default();
        return Err(Failure::input(format!(
            "--only {only}: no lesson has that in its number or name\n{}",
            list()
        )));
    }
    let folder = flags.out.clone().unwrap_or_else(|| PathBuf::from("figures"));
    let programs = programs()?;
    let verbosity = if flags.quiet { Verbosity::Quiet } else { Verbosity::Normal };
    let progress = Progress::start("figures", verbosity);
    let mut out = String::new();
    let mut failed = Vec::new();
    for (i, entry) in chosen.iter().enumerate() {
        if stop_flag().load(Ordering::Relaxed) {
            return Err(Failure::interrupted(&entry.program()));
        }
        let run = lesson_command(&programs, entry, &folder, flags).output();
        let run = run.map_err(|e| Failure::work(format!("{}: cannot be run: {e}", entry.program())))?;
        out += &String::from_utf8_lossy(&run.stdout);
        out.push('\n');
        if !run.status.success() {
            failed.push(format!("{}: {}", entry.program(), String::from_utf8_lossy(&run.stderr).trim_end()));
        }
        progress.set((i + 1) as f64 / chosen.len() as f64);
    }
    let page = page::write(&folder).map_err(Failure::work)?;
    progress.finish(&format!("{} lessons", chosen.len()));
    out += &format!("{}\n", page.display());
    if failed.is_empty() {
        return Ok(out);
    }
    super::print(&out)?;
    Err(Failure::work(failed.join("\n")))
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
