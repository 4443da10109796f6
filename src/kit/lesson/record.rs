//! What a lesson leaves behind for the page, as JSON.

use super::Entry;
use serde::{Deserialize, Serialize};

/// A figure and its words; stands beside it as `NAME.json`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct FigureRecord {
    pub title: String,
    pub caption: String,
    /// What the figure shows, for those who do not see it.
    pub alt: String,
    /// The canonical command that makes it again.
    pub command: String,
    pub seed: u64,
    pub version: String,
    /// File names, the figure itself first.
    pub files: Vec<String>,
}

/// A sentence, and whether it held.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ClaimRecord {
    pub sentence: String,
    pub holds: bool,
}

/// A whole lesson.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct LessonRecord {
    pub number: u32,
    pub name: String,
    pub question: String,
    pub chapter: String,
    pub command: String,
    pub figures: Vec<FigureRecord>,
    pub claims: Vec<ClaimRecord>,
    pub answer: String,
}

impl FigureRecord {
    pub fn json(&self) -> String {
        // Plain strings and numbers always serialise.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }
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
            claims: Vec::new(),
            answer: String::new(),
        }
    }

    pub fn json(&self) -> String {
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }
}
