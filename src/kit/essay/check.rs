//! The form of an essay.

use super::{Essay, Glossary, MOST_FIGURES, MOST_WORDS, PARTS, Part, formula};
use pulldown_cmark::{Event, Tag, TagEnd};
use std::fmt;

/// What is wrong with an essay: a line for each problem, `line N: expected …, found …`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EssayError(pub Vec<String>);

impl fmt::Display for EssayError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0.join("\n"))
    }
}

impl std::error::Error for EssayError {}

/// Checks order, length, options, exercises, figures, glossary words and formulas.
pub(super) fn check(essay: &Essay) -> Result<(), EssayError> {
    let mut problems = Vec::new();
    order(essay, &mut problems);
    let words = essay.words();
    if words > MOST_WORDS {
        problems.push(format!("expected at most {MOST_WORDS} words, found {words}"));
    }
    let options = items(essay, Part::Predict);
    if !(3..=4).contains(&options.len()) {
        problems.push(format!("Predict: expected three or four options, found {}", options.len()));
    }
    if folds(essay, Part::Predict) != ["Answer"] {
        problems.push("Predict: expected one folded `> **Answer.** …`".to_string());
    }
    exercises(essay, &mut problems);
    figures(essay, &mut problems);
    for term in essay.terms().iter().filter(|t| Glossary::book().get(t).is_none()) {
        problems.push(format!("expected a word of the glossary, found `#{term}`"));
    }
    for (event, place) in essay.sections.iter().flat_map(|s| &s.events) {
        if let Event::InlineMath(math) | Event::DisplayMath(math) = event
            && let Err(error) = formula::mathml(math, formula::Setting::Inline)
        {
            problems.push(format!("line {}: {error}", essay.line(place.start)));
        }
    }
    if problems.is_empty() { Ok(()) } else { Err(EssayError(problems)) }
}

fn order(essay: &Essay, problems: &mut Vec<String>) {
    let found: Vec<&str> = essay.sections.iter().map(|s| s.part.heading()).collect();
    let expected: Vec<&str> = PARTS.iter().map(|p| p.1).collect();
    let required = expected.len() - 1;
    if found != expected && found != expected[..required] {
        problems.push(format!("expected the sections {}, found {}", expected.join(", "), found.join(", ")));
    }
}

/// Number of folded quotations in each item of the outermost lists of a section.
fn items(essay: &Essay, part: Part) -> Vec<usize> {
    let (mut depth, mut items) = (0, Vec::new());
    for (event, _) in essay.events(part) {
        match event {
            Event::Start(Tag::List(_)) => depth += 1,
            Event::End(TagEnd::List(_)) => depth -= 1,
            Event::Start(Tag::Item) if depth == 1 => items.push(0),
            Event::Start(Tag::BlockQuote(_)) if depth == 1 => {
                if let Some(last) = items.last_mut() {
                    *last += 1;
                }
            }
            _ => {}
        }
    }
    items
}

/// The words under which a section's quotations are folded.
fn folds(essay: &Essay, part: Part) -> Vec<String> {
    let mut found = Vec::new();
    let mut events = essay.events(part).map(|(event, _)| event).peekable();
    while let Some(event) = events.next() {
        if matches!(event, Event::Start(Tag::BlockQuote(_))) {
            events.next_if(|e| matches!(e, Event::Start(Tag::Paragraph)));
            events.next_if(|e| matches!(e, Event::Start(Tag::Strong)));
            let label = match events.next() {
                Some(Event::Text(text)) => text.trim_end_matches('.').to_string(),
                _ => String::new(),
            };
            found.push(label);
        }
    }
    found
}

fn exercises(essay: &Essay, problems: &mut Vec<String>) {
    let exercises = items(essay, Part::Try);
    if exercises.len() != 3 {
        problems.push(format!("Try it: expected three exercises, found {}", exercises.len()));
    }
    let expected: Vec<&str> = exercises.iter().flat_map(|_| ["Hint", "Solution"]).collect();
    if folds(essay, Part::Try) != expected {
        problems.push(
            "Try it: expected a folded `> **Hint.**` and `> **Solution.**` in each exercise".to_string(),
        );
    }
}

fn figures(essay: &Essay, problems: &mut Vec<String>) {
    let places = essay.figures();
    let shown = places.iter().filter(|p| p.part != Part::Documents).count();
    if shown > MOST_FIGURES {
        problems
            .push(format!("expected at most {MOST_FIGURES} figures before the folded ones, found {shown}"));
    }
    for (i, place) in places.iter().enumerate() {
        if places[..i].iter().any(|p| p.name == place.name) {
            problems.push(format!("expected each figure once, found `{}` twice", place.name));
        }
    }
}
