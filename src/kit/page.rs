//! `figures/index.html`: one static page of all lessons, without scripts.
//!
//! The page is made from the `.json` files that lessons leave beside their figures, so that it can be
//! made again without running a lesson.

use super::lesson::{FigureRecord, LessonRecord, SYLLABUS};
use crate::file::{FileError, write_atomically};
use std::fmt::Write;
use std::path::{Path, PathBuf};

const STYLE: &str = include_str!("page.css");

/// Writes `index.html` for the lessons whose records lie in `folder`; answers with its path.
///
/// - Errors: the page cannot be written. A lesson without a readable record is left out.
pub fn write(folder: &Path) -> Result<PathBuf, FileError> {
    let lessons: Vec<LessonRecord> = SYLLABUS
        .iter()
        .filter_map(|entry| {
            let text = std::fs::read_to_string(folder.join(format!("{}.json", entry.stem()))).ok()?;
            serde_json::from_str(&text).ok()
        })
        .collect();
    let path = folder.join("index.html");
    write_atomically(&path, html(&lessons).as_bytes())?;
    Ok(path)
}

/// The page as text.
pub fn html(lessons: &[LessonRecord]) -> String {
    let mut out = String::from(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>lightbench: the lessons</title>\n<style>\n",
    );
    out += STYLE;
    out += "</style>\n</head>\n<body>\n<header>\n<h1>lightbench</h1>\n\
            <p>An optical bench for learning light transport: every lesson asks one question, draws the figures \
            that answer it, and checks what it claims. The command under a question makes its figures again. \
            Sources: A Sancho 2003, B Anguera 2020, C Ramos, D Tomas, E Ureña 2022 (see ERRATA.md).</p>\n\
            </header>\n<nav aria-label=\"Lessons\">\n<ol>\n";
    for lesson in lessons {
        // Writing to a string cannot fail.
        let _ = writeln!(
            out,
            "<li value=\"{}\"><a href=\"#lesson-{:02}\">{}</a></li>",
            lesson.number,
            lesson.number,
            escape(&lesson.question)
        );
    }
    out += "</ol>\n</nav>\n<main>\n";
    let mut chapter = "";
    for lesson in lessons {
        if lesson.chapter != chapter {
            chapter = &lesson.chapter;
            let _ = writeln!(out, "<p class=\"chapter\">{}</p>", escape(chapter));
        }
        section(&mut out, lesson);
    }
    out += "</main>\n</body>\n</html>\n";
    out
}

fn section(out: &mut String, lesson: &LessonRecord) {
    let n = lesson.number;
    let _ = writeln!(out, "<section id=\"lesson-{n:02}\" aria-labelledby=\"question-{n:02}\">");
    let _ = writeln!(out, "<h2 id=\"question-{n:02}\"><span>{n:02}</span> {}</h2>", escape(&lesson.question));
    let _ = writeln!(out, "<p class=\"answer\"><strong>Answer.</strong> {}</p>", escape(&lesson.answer));
    let _ = writeln!(out, "<pre><code>{}</code></pre>", escape(&lesson.command));
    for record in &lesson.figures {
        figure(out, record);
    }
    if !lesson.claims.is_empty() {
        *out += "<h3>Checked in this run</h3>\n<ul class=\"claims\">\n";
        for claim in &lesson.claims {
            let mark = if claim.holds { "holds" } else { "fails" };
            let _ = writeln!(out, "<li><b>{mark}</b> {}</li>", escape(&claim.sentence));
        }
        *out += "</ul>\n";
    }
    *out += "</section>\n";
}

fn figure(out: &mut String, record: &FigureRecord) {
    let Some(shown) = record.files.first() else { return };
    let _ = writeln!(
        out,
        "<figure>\n<a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\" loading=\"lazy\"></a>",
        escape(shown),
        escape(&record.alt)
    );
    let _ = writeln!(out, "<figcaption>{}", escape(&record.caption));
    *out += "<small>";
    for (i, file) in record.files.iter().enumerate() {
        let kind = file.rsplit('.').next().unwrap_or_default().to_uppercase();
        let kind = if file.ends_with("_time.csv") { "CSV of times".to_string() } else { kind };
        let _ = write!(out, "{}<a href=\"{}\">{kind}</a>", if i > 0 { " · " } else { "" }, escape(file));
    }
    let _ = writeln!(out, "</small></figcaption>\n</figure>");
}

/// Text in HTML, in elements and in quoted attributes.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
