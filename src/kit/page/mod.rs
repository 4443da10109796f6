//! The pages that students read: one for each lesson, an index, and the glossary; without scripts, without network.
//!
//! A page is made of the lesson's essay and of the record that its run left, so that it can be made again without
//! running the lesson.

use crate::essay::{self, Essay, Glossary, Shown, escaped};
use crate::file::{FileError, write_atomically};
use crate::syllabus::{Entry, FigureRecord, LessonRecord, SYLLABUS, entry};
use std::fmt::Write;
use std::path::{Path, PathBuf};

const STYLE: &str = include_str!("page.css");
/// Text in a figure is at least this large on the narrowest screen \[px\]; the figure scrolls in its frame before it
/// gets smaller.
const LEGIBLE: f64 = 11.0;

/// The page of a lesson.
pub fn lesson(entry: &Entry, essay: Option<&Essay>, record: &LessonRecord) -> String {
    let number = entry.number;
    let mut out = head(&format!("{number:02} · {}", entry.question));
    let _ = writeln!(out, "{}<main>", links(entry));
    let _ = writeln!(out, "<p class=\"chapter\">Lesson {number:02} · {}</p>", escaped(entry.chapter));
    let _ = writeln!(out, "<h1>{}</h1>", escaped(entry.question));
    if !entry.builds_on.is_empty() {
        let built: Vec<String> = entry.builds_on.iter().map(builds_on).collect();
        let _ = writeln!(out, "<p class=\"builds\">Builds on {}.</p>", built.join("; "));
    }
    match essay {
        Some(essay) => {
            out += &essay::html(essay, &record.values, &Figures(record));
            out += &words(essay);
        }
        None => plain(&mut out, record),
    }
    claims(&mut out, record);
    let _ = writeln!(
        out,
        "<p class=\"again\">Every number and figure on this page was measured by</p>\n<pre><code>{}</code></pre>",
        escaped(&record.command)
    );
    let _ = write!(out, "</main>\n{}</body>\n</html>\n", links(entry));
    out
}

/// A lesson that has no essay yet: its answer, then its figures.
fn plain(out: &mut String, record: &LessonRecord) {
    let _ = writeln!(
        out,
        "<details class=\"answer\"><summary>Answer</summary><p>{}</p></details>",
        escaped(&record.answer)
    );
    for (i, figure) in record.figures.iter().enumerate() {
        *out += &shown(figure, i + 1, &figure.caption);
    }
}

fn builds_on((number, gave): &(u32, &str)) -> String {
    let stem = entry(*number).map(Entry::stem).unwrap_or_default();
    format!("<a href=\"{stem}.html\">lesson {number:02}</a> ({})", escaped(gave))
}

/// Links to the neighbours and to the index.
fn links(here: &Entry) -> String {
    let at = SYLLABUS.iter().position(|e| e.number == here.number).unwrap_or(0);
    let link = |entry: Option<&Entry>, word: &str| {
        entry.map_or(format!("<span>{word}</span>"), |e| {
            format!("<a href=\"{}.html\" title=\"{}\">{word}</a>", e.stem(), escaped(e.question))
        })
    };
    format!(
        "<nav aria-label=\"Lessons\">{} <a href=\"index.html\">All lessons</a> <a href=\"glossary.html\">Glossary</a> {}</nav>\n",
        link(at.checked_sub(1).map(|i| &SYLLABUS[i]), "← Previous"),
        link(SYLLABUS.get(at + 1), "Next →")
    )
}

/// The figures of a run, by name.
struct Figures<'a>(&'a LessonRecord);

impl Shown for Figures<'_> {
    fn figure(&self, name: &str, number: usize, caption: &str) -> String {
        match self.0.figures.iter().find(|f| f.name == name) {
            Some(figure) => shown(figure, number, if caption.is_empty() { &figure.caption } else { caption }),
            None => {
                format!("<p class=\"missing\">The figure “{}” was not made in this run.</p>\n", escaped(name))
            }
        }
    }
}

/// A figure: its number, its heading as text, the picture that grows when it is clicked, its caption and its files.
fn shown(record: &FigureRecord, number: usize, caption: &str) -> String {
    let name = escaped(&record.name);
    let mut out = format!(
        "<figure id=\"fig-{name}\">\n<p class=\"title\"><b>{}. </b>{}</p>\n",
        label(record, number),
        escaped(&record.title)
    );
    match record.files.first().filter(|_| record.table.is_empty()) {
        Some(file) => out += &picture(record, file, &name),
        None => {
            let _ = writeln!(out, "<div class=\"scroll\">{}</div>", record.table);
        }
    }
    let caption = if caption == record.title { "" } else { caption };
    let _ = write!(out, "<figcaption>{}<small>", escaped(caption));
    for (i, file) in record.files.iter().enumerate() {
        let kind = file.rsplit('.').next().unwrap_or_default().to_uppercase();
        let kind = if file.ends_with("_time.csv") { "CSV of times".to_string() } else { kind };
        let _ = write!(out, "{}<a href=\"{}\">{kind}</a>", if i > 0 { " · " } else { "" }, escaped(file));
    }
    out + "</small></figcaption>\n</figure>\n"
}

fn label(record: &FigureRecord, number: usize) -> String {
    format!("{} {number}", if record.table.is_empty() { "Figure" } else { "Table" })
}

/// The picture in its frame, without the heading drawn at its top, and the whole picture over the page on demand.
fn picture(record: &FigureRecord, file: &str, name: &str) -> String {
    let (file, alt) = (escaped(file), escaped(&record.alt));
    let (width, height) = (record.width.max(1.0), record.height.max(1.0));
    let narrowest = if record.text > 0.0 { (width * LEGIBLE / record.text).ceil() } else { 0.0 };
    format!(
        "<div class=\"scroll\"><a class=\"zoom\" href=\"#large-{name}\" style=\"min-width:{narrowest}px;max-width:{width}px;aspect-ratio:{width}/{}\">\
         <img src=\"{file}\" alt=\"{alt}\" width=\"{width}\" height=\"{height}\" loading=\"lazy\" style=\"margin-top:-{:.3}%\"></a></div>\n\
         <a class=\"large\" id=\"large-{name}\" href=\"#fig-{name}\" aria-label=\"close the large picture\"><img src=\"{file}\" alt=\"\" loading=\"lazy\"></a>\n",
        height - record.heading,
        100.0 * record.heading / width,
    )
}

fn claims(out: &mut String, record: &LessonRecord) {
    if record.claims.is_empty() {
        return;
    }
    *out += "<details class=\"claims\"><summary>Checked in this run</summary>\n<ul>\n";
    for claim in &record.claims {
        let mark = if claim.holds { "holds" } else { "fails" };
        let _ = writeln!(out, "<li><b>{mark}</b> {}</li>", escaped(&claim.sentence));
    }
    *out += "</ul>\n</details>\n";
}

/// The words that the essay marks, with their meanings.
fn words(essay: &Essay) -> String {
    let marked = essay.terms();
    let terms = Glossary::book().terms.iter().filter(|t| marked.contains(&t.key()));
    let list: String = terms.map(definition).collect();
    if list.is_empty() {
        list
    } else {
        format!("<section id=\"words\">\n<h2>Words</h2>\n<dl>\n{list}</dl>\n</section>\n")
    }
}

fn definition(term: &essay::Term) -> String {
    format!(
        "<dt id=\"term-{}\">{}</dt>\n<dd>{}</dd>\n",
        term.key(),
        escaped(&term.word),
        essay::line(&term.meaning)
    )
}

fn head(title: &str) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{}</title>\n\
         <link rel=\"icon\" href=\"data:,\">\n<style>\n{STYLE}</style>\n</head>\n<body>\n",
        escaped(title)
    )
}

/// The page of all lessons: chapters, a small picture and the question of each.
pub fn index(lessons: &[LessonRecord]) -> String {
    let mut out = head("lightbench: the lessons");
    out += "<nav aria-label=\"Pages\"><a href=\"glossary.html\">Glossary</a></nav>\n<main>\n<h1>lightbench</h1>\n\
            <p>An optical bench for learning light transport. Every lesson asks one question, lets you predict the answer, \
            and measures it: speed and accuracy, and where each method breaks.</p>\n";
    let mut chapter = "";
    for lesson in lessons {
        if lesson.chapter != chapter {
            out += if chapter.is_empty() { "" } else { "</ul>\n" };
            chapter = &lesson.chapter;
            let _ = writeln!(out, "<h2>{}</h2>\n<ul class=\"lessons\">", escaped(chapter));
        }
        let picture = lesson
            .figures
            .iter()
            .find_map(|f| Some((f.files.first()?, f)))
            .filter(|(_, f)| f.table.is_empty());
        let image = picture.map_or(String::new(), |(file, f)| {
            let (width, height) = (f.width.max(1.0), f.height.max(1.0));
            format!(
                "<img src=\"{}\" alt=\"\" width=\"{width}\" height=\"{height}\" loading=\"lazy\">",
                escaped(file)
            )
        });
        let stem = entry(lesson.number).map(Entry::stem).unwrap_or_default();
        let _ = writeln!(
            out,
            "<li><a href=\"{stem}.html\"><span class=\"thumbnail\">{image}</span><span><b>{:02}</b> {}</span></a></li>",
            lesson.number,
            escaped(&lesson.question)
        );
    }
    out += if lessons.is_empty() { "" } else { "</ul>\n" };
    out += "<p class=\"again\">Sources: Sancho 2003 (A), Anguera 2020 (B), Ramos (C), Tomas (D), Ureña 2022 (E); \
            <code>ERRATA.md</code> lists where they err and which lesson shows it.</p>\n</main>\n</body>\n</html>\n";
    out
}

/// The page of all words.
pub fn glossary() -> String {
    let list: String = Glossary::book().terms.iter().map(definition).collect();
    head("lightbench: the glossary")
        + "<nav aria-label=\"Pages\"><a href=\"index.html\">All lessons</a></nav>\n<main>\n<h1>Glossary</h1>\n<dl>\n"
        + &list
        + "</dl>\n</main>\n</body>\n</html>\n"
}

/// Writes `index.html` and `glossary.html` for the lessons whose records lie in `folder`; returns the path of the index.
///
/// - Errors: a page that cannot be written. A lesson without a readable record is left out.
pub fn write(folder: &Path) -> Result<PathBuf, FileError> {
    let read = |entry: &Entry| {
        let text = std::fs::read_to_string(folder.join(format!("{}.json", entry.stem()))).ok()?;
        serde_json::from_str(&text).ok()
    };
    let lessons: Vec<LessonRecord> = SYLLABUS.iter().filter_map(read).collect();
    write_atomically(&folder.join("glossary.html"), glossary().as_bytes())?;
    let path = folder.join("index.html");
    write_atomically(&path, index(&lessons).as_bytes())?;
    Ok(path)
}
