//! What a lesson leaves behind for its page, as JSON.

use super::Entry;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A figure, picture or table, and its words.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FigureRecord {
    /// What the lesson calls it.
    pub name: String,
    pub title: String,
    pub caption: String,
    /// What the figure shows, for those who do not see it.
    pub alt: String,
    /// The canonical command that makes it again.
    pub command: String,
    pub seed: u64,
    pub version: String,
    /// File names, the one to show first.
    pub files: Vec<String>,
    /// Size of the picture \[px\]; 0 for a table.
    pub width: f64,
    pub height: f64,
    /// Height of the heading drawn at the picture's top \[px\]: the page has the heading as text.
    pub heading: f64,
    /// Size of the smallest text in the picture \[px\]; 0 if there is none.
    pub text: f64,
    /// The table itself, as HTML.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub table: String,
}

/// A sentence, and whether it held.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ClaimRecord {
    pub sentence: String,
    pub holds: bool,
}

/// A whole lesson.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LessonRecord {
    pub number: u32,
    pub name: String,
    pub question: String,
    pub chapter: String,
    pub command: String,
    pub figures: Vec<FigureRecord>,
    /// The numbers of this run that the essay quotes.
    #[serde(default)]
    pub values: BTreeMap<String, String>,
    pub claims: Vec<ClaimRecord>,
    pub answer: String,
}

impl LessonRecord {
    pub fn new(entry: &Entry, command: String) -> Self {
        LessonRecord {
            number: entry.number,
            name: entry.name.to_string(),
            question: entry.question.to_string(),
            chapter: entry.chapter.to_string(),
            command,
            figures: Vec::new(),
            values: BTreeMap::new(),
            claims: Vec::new(),
            answer: String::new(),
        }
    }

    /// The record as JSON; strings and numbers always serialise.
    pub fn json(&self) -> String {
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }
}
