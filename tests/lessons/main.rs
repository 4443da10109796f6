//! Every lesson at smoke quality: it ends well, writes what it promises, and writes the same again.

use lightbench_kit::lesson::{Entry, LessonRecord, SYLLABUS};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn program(entry: &Entry) -> PathBuf {
    let folder = Path::new(env!("CARGO_BIN_EXE_lesson_01")).parent().expect("a folder");
    folder.join(format!("{}{}", entry.program(), std::env::consts::EXE_SUFFIX))
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    folder
}

fn run(entry: &Entry, out: &Path, more: &[&str]) -> Output {
    let mut command = Command::new(program(entry));
    command.args(["--quality", "smoke", "--out"]).arg(out).args(more);
    command.output().expect("a lesson runs")
}

/// File name → bytes, without those that hold measured seconds or quote them, as records and pages do.
fn repeatable(out: &Path) -> BTreeMap<String, Vec<u8>> {
    let files = fs::read_dir(out).expect("a folder").flatten();
    let named =
        files.map(|f| (f.file_name().to_string_lossy().into_owned(), fs::read(f.path()).expect("a file")));
    named
        .filter(|(name, _)| !name.contains("_time") && !name.ends_with(".json") && !name.ends_with(".html"))
        .collect()
}

#[test]
fn lessons_keep_their_promises() {
    for entry in SYLLABUS {
        let out = folder(&format!("promises_{}", entry.number));
        let done = run(entry, &out, &[]);
        let stdout = String::from_utf8(done.stdout).expect("text");
        assert!(
            done.status.success(),
            "{}: {}{stdout}",
            entry.program(),
            String::from_utf8_lossy(&done.stderr)
        );
        let record = fs::read_to_string(out.join(format!("{}.json", entry.stem()))).expect("a record");
        let record: LessonRecord = serde_json::from_str(&record).expect("a record");
        assert!((1..=3).contains(&record.claims.len()), "{}: one to three claims", entry.program());
        assert!(
            record.answer.chars().any(|c| c.is_ascii_digit()),
            "the answer has numbers: {}",
            record.answer
        );
        let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(words(&stdout).contains(&words(&record.answer)), "the answer is printed");
        let page = out.join(format!("{}.html", entry.stem()));
        let last = format!("{} figures · {}", record.figures.len(), page.display());
        assert_eq!(stdout.lines().last(), Some(last.as_str()), "the page comes last");
        assert!(page.is_file());
        for file in record.figures.iter().flat_map(|f| &f.files) {
            assert!(out.join(file).is_file(), "{file} was promised");
        }
        let header = fs::read_to_string(format!("{}/{}.rs", env!("CARGO_MANIFEST_DIR"), entry.stem()))
            .expect("a lesson");
        let promised =
            header.lines().filter_map(|l| l.strip_prefix("//! Figure:")).flat_map(|l| l.split(','));
        for file in promised.map(str::trim).filter(|f| !f.is_empty()) {
            assert!(out.join(file).is_file(), "the header of lesson {} promises {file}", entry.number);
        }
    }
}

#[test]
fn lessons_repeat_to_the_byte_whatever_the_threads() {
    for entry in SYLLABUS {
        let (a, b) =
            (folder(&format!("repeat_a_{}", entry.number)), folder(&format!("repeat_b_{}", entry.number)));
        assert!(run(entry, &a, &["--seed", "5", "--threads", "1"]).status.success());
        assert!(run(entry, &b, &["--seed", "5", "--threads", "3"]).status.success());
        let (a, b) = (repeatable(&a), repeatable(&b));
        assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>());
        for (name, bytes) in &a {
            assert!(bytes == &b[name], "{name} differs from run to run");
        }
    }
}

#[test]
fn wrong_usage_ends_with_code_2_and_writes_nothing() {
    let out = folder("wrong_usage");
    let done = run(&SYLLABUS[0], &out, &["--seed", "many"]);
    assert_eq!(done.status.code(), Some(2));
    assert!(!out.exists());
}
