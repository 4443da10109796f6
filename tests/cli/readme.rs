//! What the README promises: its commands run in the order in which they stand, in a clean copy of the project, and what it
//! names is there.
#![cfg(unix)]

use crate::bench::{Bench, root};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Stands in for `cargo`, whose programs are built already: `cargo run` runs the one that is meant, at a small size where
/// nothing else is said. `cargo test` is what runs this.
const CARGO: &str = r#"#!/bin/sh
program=lightbench
verb="$1"
shift
case "$verb" in
test | build) exit 0 ;;
run) ;;
*) echo "cargo $verb: the test of the README does not know it" >&2; exit 97 ;;
esac
while [ $# -gt 0 ]; do
    case "$1" in
    --) shift; break ;;
    --bin) program="$2"; shift 2 ;;
    --bin=*) program="${1#--bin=}"; shift ;;
    --quiet | -q | --release) shift ;;
    -*) echo "cargo run $1: the test of the README does not know it" >&2; exit 97 ;;
    *) break ;;
    esac
done
small=""
case "$program $* " in
*" --quality "*) ;;
"lesson_"* | *" figures "*) small="--quality smoke" ;;
*" --pixel "* | *" --list "*) ;;
*" render "*) small="--width 48 --height 48" ;;
esac
case "$program $* " in
*" --only "*) ;;
*" figures "*) small="$small --only 01" ;;
esac
exec "$PROGRAMS/$program" "$@" $small
"#;

fn readme() -> String {
    fs::read_to_string(root().join("README.md")).expect("README.md")
}

/// The text of every block of shell commands.
fn blocks(readme: &str) -> Vec<String> {
    let parts = readme.split("\n```").collect::<Vec<_>>();
    let opened = parts.into_iter().skip(1).step_by(2);
    opened.filter_map(|part| part.strip_prefix("sh\n")).map(|text| format!("{text}\n")).collect()
}

/// A copy of what the project holds, without what it builds.
fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder");
    for entry in fs::read_dir(from).expect("a folder of the project").flatten() {
        let (path, name) = (entry.path(), entry.file_name());
        if ["target", "out", ".git"].iter().any(|skipped| name.to_str() == Some(skipped)) {
            continue;
        }
        if path.is_dir() {
            copy(&path, &to.join(name));
        } else {
            fs::copy(&path, to.join(name)).expect("a file of the project");
        }
    }
}

/// The folder of the built programs, with every lesson that the commands run.
pub fn programs(commands: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_BIN_EXE_lightbench")).parent().expect("a folder").to_path_buf();
    // `figures` runs the first one.
    let figures = commands.contains("-- figures").then_some("lesson_01");
    for word in commands.split_whitespace().filter(|word| word.starts_with("lesson_")).chain(figures) {
        if !folder.join(word).exists() {
            let mut build = Command::new(std::env::var_os("CARGO").expect("cargo runs this test"));
            build.args(["build", "--quiet", "--bin", word]).current_dir(root());
            assert!(build.status().expect("cargo").success(), "{word} cannot be built");
        }
    }
    folder
}

#[test]
fn the_readmes_commands_run_in_its_order() {
    let readme = readme();
    let blocks = blocks(&readme);
    assert!(blocks.len() >= 3, "the README has {} blocks of commands", blocks.len());
    let bench = Bench::new("readme");
    let project = bench.folder.join("project");
    copy(&root(), &project);
    bench.write("bin/cargo", CARGO.as_bytes());
    let stub = bench.folder.join("bin/cargo");
    fs::set_permissions(&stub, fs::Permissions::from_mode(0o755)).expect("a program");
    let path = std::env::var("PATH").expect("a PATH");
    // Exit codes are those of `--help`.
    for code in ["129", "130", "143"] {
        assert!(readme.contains(code), "the README is silent about the exit code {code}");
    }
    for block in &blocks {
        let mut shell = Command::new("sh");
        shell.args(["-exc", block]).current_dir(&project).stdin(Stdio::null());
        shell.env("PATH", format!("{}:{path}", bench.folder.join("bin").display()));
        shell.env("PROGRAMS", programs(block)).env_remove("CARGO").env_remove("RUST_BACKTRACE");
        let ran = shell.output().expect("a shell");
        let err = String::from_utf8_lossy(&ran.stderr);
        assert!(ran.status.success(), "the README says:\n{block}\nand that fails:\n{err}");
        for word in ["note:", "warning:", "error:", "panicked"] {
            assert!(!err.contains(word), "the README says:\n{block}\nand a reader sees:\n{err}");
        }
    }
    for file in named_results(&readme) {
        assert!(project.join(&file).exists(), "the README speaks of {file}, which its commands do not write");
    }
}

/// The files in `out/` that the README speaks of.
fn named_results(readme: &str) -> Vec<String> {
    let words = readme.split(['`', ' ', '\n']).filter(|word| word.starts_with("out/"));
    words.filter(|w| Path::new(w).extension().is_some() && !w.contains('*')).map(str::to_owned).collect()
}

#[test]
fn what_the_readme_links_to_is_there() {
    let readme = readme();
    let links: Vec<&str> = readme.split("](").skip(1).filter_map(|rest| rest.split(')').next()).collect();
    assert!(links.len() > 3, "{links:?}");
    for link in links.iter().filter(|link| !link.contains("://") && !link.starts_with('#')) {
        let file = link.split('#').next().unwrap_or(link);
        assert!(root().join(file).exists(), "the README links to {link}, which is not there");
    }
}
