//! The syllabus is the only list of lessons: files, programs, figures and README agree with it, and a lesson
//! imports what has been taught.

use crate::architecture::{floors, imports};
use lightbench_kit::lesson::{LessonRecord, SYLLABUS};
use lightbench_kit::page;
use std::collections::BTreeSet;
use std::fs;

#[test]
fn lessons_are_numbered_in_order_and_build_on_earlier_ones() {
    assert!(SYLLABUS.is_sorted_by(|a, b| a.number < b.number));
    for entry in SYLLABUS {
        assert!(entry.question.ends_with('?'), "lesson {} asks nothing", entry.number);
        let exists = |n: u32| SYLLABUS.iter().any(|e| e.number == n);
        assert!(entry.builds_on.iter().all(|(n, _)| *n < entry.number && exists(*n)), "{}", entry.name);
    }
}

#[test]
fn the_syllabus_has_exactly_the_lessons_that_exist() {
    let expected: BTreeSet<String> = SYLLABUS.iter().map(|e| format!("{}.rs", e.stem())).collect();
    let found: BTreeSet<String> = fs::read_dir("lessons")
        .expect("lessons/")
        .flatten()
        .filter(|f| f.path().extension().is_some_and(|e| e == "rs"))
        .map(|f| f.file_name().to_string_lossy().into_owned())
        .collect();
    assert_eq!(found, expected);
}

#[test]
fn every_lesson_has_its_program() {
    let manifest = fs::read_to_string("lessons/Cargo.toml").expect("lessons/Cargo.toml");
    let lines: Vec<&str> = manifest.lines().filter(|l| l.contains("\"lesson_")).collect();
    assert_eq!(lines.len(), SYLLABUS.len());
    for entry in SYLLABUS {
        let line = format!(
            "{{ name = \"{}\", path = \"{}.rs\", test = false, doc = false }},",
            entry.program(),
            entry.stem()
        );
        assert!(lines.iter().any(|l| l.trim() == line), "lessons/Cargo.toml lacks {line}");
    }
}

#[test]
fn the_readme_names_every_lesson() {
    let readme = fs::read_to_string("README.md").expect("README.md");
    for entry in SYLLABUS {
        assert!(readme.contains(entry.question), "README.md lacks the question of lesson {}", entry.number);
    }
}

/// A lesson reads top to bottom: its header, and at most about 150 lines.
#[test]
fn lessons_are_short_and_begin_with_their_question() {
    for entry in SYLLABUS {
        let text = fs::read_to_string(format!("lessons/{}.rs", entry.stem())).expect("a lesson");
        let lines = text.lines().count();
        assert!(lines <= 160, "lesson {} has {lines} lines", entry.number);
        assert!(
            text.starts_with(&format!("//! Lesson {:02}.", entry.number)),
            "lesson {} has no header",
            entry.number
        );
        for part in ["Builds on:", "New here:", "Notation:", "Predict:", "Figure:"] {
            assert!(text.contains(part), "the header of lesson {} lacks `{part}`", entry.number);
        }
    }
}

/// Floors 0–2, `scene`, `render`, `kit` are everybody's; chapters open one by one.
#[test]
fn lessons_import_what_has_been_taught() {
    let floors = floors();
    let mut taught: BTreeSet<&str> = ["scene", "render", "figure", "lesson"].into();
    for entry in SYLLABUS {
        taught.extend(entry.introduces);
        let mut texts = vec![fs::read_to_string(format!("lessons/{}.rs", entry.stem())).expect("a lesson")];
        for file in fs::read_dir(format!("lessons/{}", entry.stem())).into_iter().flatten().flatten() {
            texts.push(fs::read_to_string(file.path()).expect("a part of a lesson"));
        }
        for (line, module) in texts
            .iter()
            .flat_map(|t| ["lightbench::", "lightbench_kit::"].iter().flat_map(|root| imports(t, root)))
        {
            let low = floors.get(&module).is_some_and(|f| *f <= 2);
            assert!(
                low || taught.contains(module.as_str()),
                "lesson {}, line {line}: `{module}` has not been taught yet",
                entry.number
            );
        }
    }
}

/// What is committed in `figures/` is whole: every lesson's record, every file it names, and the page.
#[test]
fn the_figures_are_complete() {
    let index = fs::read_to_string("figures/index.html").expect("figures/index.html");
    let mut records = Vec::new();
    for entry in SYLLABUS {
        let text = fs::read_to_string(format!("figures/{}.json", entry.stem())).expect("a lesson's record");
        let record: LessonRecord = serde_json::from_str(&text).expect("a lesson's record");
        assert_eq!(record.question, entry.question, "figures/ is older than the syllabus");
        assert!(
            !record.answer.is_empty() && record.claims.iter().all(|c| c.holds),
            "lesson {}",
            entry.number
        );
        for figure in &record.figures {
            assert!(figure.alt.len() > 20, "{:?} has no alternative text", figure.files);
            assert!(!figure.command.contains("--out"), "{}", figure.command);
            for file in &figure.files {
                assert!(fs::metadata(format!("figures/{file}")).is_ok_and(|m| m.len() > 0), "figures/{file}");
            }
        }
        records.push(record);
    }
    assert_eq!(index, page::html(&records), "figures/index.html is not made from the records beside it");
    let scripted = index.contains("<script") || index.contains("javascript:");
    assert!(!scripted, "the page has no scripts");
}
