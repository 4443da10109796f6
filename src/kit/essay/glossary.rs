//! The words of the field, a sentence each: `lessons/glossary.md`.

use std::sync::OnceLock;

/// A word and what it means.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Term {
    pub word: String,
    /// One sentence, as Markdown.
    pub meaning: String,
}

impl Term {
    /// How essays refer to it: small letters, `-` for what is no letter or digit.
    pub fn key(&self) -> String {
        key(&self.word)
    }
}

fn key(word: &str) -> String {
    word.chars().map(|c| if c.is_alphanumeric() { c.to_ascii_lowercase() } else { '-' }).collect()
}

/// All words, in alphabetical order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Glossary {
    pub terms: Vec<Term>,
}

impl Glossary {
    /// Reads a list of `- **word**: meaning.`, one a line; other lines are prose.
    pub fn parse(text: &str) -> Self {
        let term = |line: &str| {
            let (word, meaning) = line.strip_prefix("- **")?.split_once("**: ")?;
            Some(Term { word: word.to_string(), meaning: meaning.trim().to_string() })
        };
        let mut terms: Vec<Term> = text.lines().filter_map(term).collect();
        terms.sort_by_key(Term::key);
        Glossary { terms }
    }

    /// The glossary of this book.
    pub fn book() -> &'static Glossary {
        static BOOK: OnceLock<Glossary> = OnceLock::new();
        BOOK.get_or_init(|| Glossary::parse(include_str!("../../../lessons/glossary.md")))
    }

    /// The word that essays call `key`.
    pub fn get(&self, key: &str) -> Option<&Term> {
        self.terms.iter().find(|t| t.key() == key)
    }
}
