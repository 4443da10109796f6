//! The essay of a lesson: Markdown that a student reads, in ten sections, with formulas, figures by name, and numbers
//! that the run provides.
//!
//! An essay is the file `lessons/05_torus.md`. Beside ordinary Markdown it has
//!
//! - formulas in LaTeX between dollar signs, `$r^2$` in the line and `$$…$$` on their own;
//! - `{lost}`, the value that the run named `lost`;
//! - `![](stability)` alone in a paragraph, the figure or table that the run named `stability`; words in the brackets
//!   replace the figure's own caption;
//! - `[penumbra](#penumbra)`, a word that the glossary explains;
//! - a quotation that begins with a word in bold, `> **Hint.** …`, which is folded under that word.
//!
//! [`Essay::parse`] reads it and reports every departure from the form with its line.

mod check;
mod formula;
mod glossary;
mod html;
mod terminal;

pub use check::EssayError;
pub use formula::{FormulaError, mathml, plain};
pub use glossary::{Glossary, Term};
pub use html::{Shown, escaped, html, line};
pub use terminal::{paragraphs, wrapped};

use pulldown_cmark::{Event, HeadingLevel, Options, Parser, Tag, TagEnd, TextMergeWithOffset};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// The most words of an essay, everything counted that white space separates.
pub const MOST_WORDS: usize = 900;
/// The most figures outside the folded section.
pub const MOST_FIGURES: usize = 6;

/// A section of an essay.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    Question,
    Predict,
    Idea,
    See,
    Measure,
    Breaks,
    Use,
    Try,
    Read,
    Sources,
    /// Folded; the only one that may be missing.
    Documents,
}

/// Every section in its order, with its heading.
pub const PARTS: [(Part, &str); 11] = [
    (Part::Question, "Question"),
    (Part::Predict, "Predict"),
    (Part::Idea, "The idea"),
    (Part::See, "See it"),
    (Part::Measure, "Measure it"),
    (Part::Breaks, "Where it breaks"),
    (Part::Use, "Use this"),
    (Part::Try, "Try it"),
    (Part::Read, "Read next"),
    (Part::Sources, "Sources and errata"),
    (Part::Documents, "Figures of the documents"),
];

impl Part {
    /// The heading, as it stands in the essay.
    pub fn heading(self) -> &'static str {
        PARTS[self as usize].1
    }
}

/// An essay that was read: its sections as Markdown events.
#[derive(Clone, Debug)]
pub struct Essay<'a> {
    source: &'a str,
    sections: Vec<Section<'a>>,
}

/// A section's events, each with its place in the source.
#[derive(Clone, Debug)]
struct Section<'a> {
    part: Part,
    events: Vec<(Event<'a>, Range<usize>)>,
}

/// A figure's place in an essay.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    pub name: String,
    pub part: Part,
    /// The words that replace the figure's own caption; empty if there are none.
    pub caption: String,
}

/// The text of each value that a run named.
pub type Values = BTreeMap<String, String>;

impl<'a> Essay<'a> {
    /// Reads an essay.
    ///
    /// - Errors: every departure from the form, with its line (see [`EssayError`]).
    pub fn parse(source: &'a str) -> Result<Self, EssayError> {
        let essay = Essay { source, sections: sections(source)? };
        check::check(&essay)?;
        Ok(essay)
    }

    /// The question: the first paragraph of its section.
    pub fn question(&self) -> String {
        let mut text = String::new();
        for (event, _) in self.events(Part::Question) {
            match event {
                Event::End(TagEnd::Paragraph) => break,
                Event::Text(t) | Event::Code(t) => text += t,
                Event::SoftBreak => text.push(' '),
                Event::InlineMath(m) => text += &plain(m),
                _ => {}
            }
        }
        text
    }

    /// The figures, in their order.
    pub fn figures(&self) -> Vec<Place> {
        let mut found: Vec<Place> = Vec::new();
        for section in &self.sections {
            let mut open = false;
            for (event, _) in &section.events {
                match event {
                    Event::Start(Tag::Image { dest_url, .. }) => {
                        open = true;
                        let name = dest_url.to_string();
                        found.push(Place { name, part: section.part, caption: String::new() });
                    }
                    Event::End(TagEnd::Image) => open = false,
                    Event::Text(t) | Event::Code(t) if open => {
                        if let Some(place) = found.last_mut() {
                            place.caption += t;
                        }
                    }
                    Event::SoftBreak if open => {
                        if let Some(place) = found.last_mut() {
                            place.caption.push(' ');
                        }
                    }
                    _ => {}
                }
            }
        }
        found
    }

    /// The names of the values that the text asks for.
    pub fn values(&self) -> BTreeSet<String> {
        self.texts().flat_map(|(text, _)| pieces(text)).filter_map(Piece::name).map(str::to_string).collect()
    }

    /// The glossary's words that the text marks, in alphabetical order.
    pub fn terms(&self) -> BTreeSet<String> {
        let all = self.sections.iter().flat_map(|s| &s.events);
        all.filter_map(|(event, _)| match event {
            Event::Start(Tag::Link { dest_url, .. }) => dest_url.strip_prefix('#').map(str::to_string),
            _ => None,
        })
        .collect()
    }

    /// The number of words, everything counted that white space separates.
    pub fn words(&self) -> usize {
        self.source.split_whitespace().count()
    }

    fn events(&self, part: Part) -> impl Iterator<Item = &(Event<'a>, Range<usize>)> {
        self.sections.iter().filter(move |s| s.part == part).flat_map(|s| &s.events)
    }

    /// All ordinary text, with its place.
    fn texts(&self) -> impl Iterator<Item = (&str, &Range<usize>)> {
        self.sections.iter().flat_map(|s| &s.events).filter_map(|(event, place)| match event {
            Event::Text(text) => Some((text.as_ref(), place)),
            _ => None,
        })
    }

    /// The line \[from 1\] of a place in the source.
    fn line(&self, at: usize) -> usize {
        line_of(self.source, at)
    }
}

fn line_of(source: &str, at: usize) -> usize {
    source[..at.min(source.len())].matches('\n').count() + 1
}

/// Splits the events at the headings.
fn sections(source: &str) -> Result<Vec<Section<'_>>, EssayError> {
    let options = Options::ENABLE_MATH | Options::ENABLE_TABLES;
    let events = TextMergeWithOffset::new(Parser::new_ext(source, options).into_offset_iter());
    let mut sections: Vec<Section> = Vec::new();
    let mut heading: Option<String> = None;
    let mut problems = Vec::new();
    for (event, place) in events {
        match event {
            Event::Start(Tag::Heading { level: HeadingLevel::H2, .. }) => heading = Some(String::new()),
            Event::End(TagEnd::Heading(HeadingLevel::H2)) => {
                let title = heading.take().unwrap_or_default();
                match PARTS.iter().find(|(_, name)| *name == title) {
                    Some((part, _)) => sections.push(Section { part: *part, events: Vec::new() }),
                    None => problems.push(format!(
                        "line {}: expected one of the headings {}, found `{title}`",
                        line_of(source, place.start),
                        PARTS.map(|p| p.1).join(", ")
                    )),
                }
            }
            event => match (&mut heading, sections.last_mut()) {
                (Some(title), _) => {
                    if let Event::Text(text) = event {
                        *title += &text;
                    }
                }
                (None, Some(section)) => section.events.push((event, place)),
                (None, None) => problems.push(format!(
                    "line {}: expected the heading `## Question`, found text before it",
                    line_of(source, place.start)
                )),
            },
        }
    }
    if problems.is_empty() { Ok(sections) } else { Err(EssayError(problems)) }
}

/// A stretch of text: words, or the name of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Piece<'a> {
    Words(&'a str),
    Value(&'a str),
}

impl<'a> Piece<'a> {
    fn name(self) -> Option<&'a str> {
        match self {
            Piece::Value(name) => Some(name),
            Piece::Words(_) => None,
        }
    }
}

/// The pieces of a text: `{name}` is a value where the name is letters, digits and underscores.
fn pieces(text: &str) -> Vec<Piece<'_>> {
    let mut out = Vec::new();
    let mut rest = text;
    let mut from = 0;
    while let Some(open) = rest[from..].find('{').map(|i| i + from) {
        let name = rest[open + 1..].find('}').map(|close| &rest[open + 1..open + 1 + close]);
        let is_name = |n: &str| !n.is_empty() && n.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        match name.filter(|n| is_name(n)) {
            Some(name) => {
                if open > 0 {
                    out.push(Piece::Words(&rest[..open]));
                }
                out.push(Piece::Value(name));
                rest = &rest[open + name.len() + 2..];
                from = 0;
            }
            None => from = open + 1,
        }
    }
    if !rest.is_empty() {
        out.push(Piece::Words(rest));
    }
    out
}

/// A text with its values filled in; an unknown one keeps its braces.
fn filled(text: &str, values: &Values) -> String {
    let fill = |piece| match piece {
        Piece::Words(words) => words.to_string(),
        Piece::Value(name) => values.get(name).cloned().unwrap_or_else(|| format!("{{{name}}}")),
    };
    pieces(text).into_iter().map(fill).collect()
}
