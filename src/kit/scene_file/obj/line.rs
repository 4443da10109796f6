//! Lines of OBJ and MTL files: words with their places.

use crate::scene_file::diagnostic::{Diagnostic, Span, quoted};

/// A word and where it stands.
#[derive(Clone, Copy, Debug)]
pub struct Word<'a> {
    pub text: &'a str,
    start: usize,
}

impl Word<'_> {
    pub fn span(&self) -> Span {
        self.start..self.start + self.text.len()
    }
}

/// A keyword and what follows it.
#[derive(Clone, Debug)]
pub struct Line<'a> {
    pub keyword: Word<'a>,
    pub words: Vec<Word<'a>>,
}

impl<'a> Line<'a> {
    /// From the keyword to the last word.
    pub fn span(&self) -> Span {
        let last = self.words.last().unwrap_or(&self.keyword);
        self.keyword.span().start..last.span().end
    }

    /// Everything behind the keyword as one name; names may hold spaces.
    pub fn name(&self, text: &'a str) -> Option<(&'a str, Span)> {
        let span = self.words.first()?.span().start..self.words.last()?.span().end;
        Some((text.get(span.clone())?, span))
    }

    /// An error for the wrong number of values, at the first one too many or at the end.
    pub fn miscounted(&self, expected: &str, most: usize) -> Diagnostic {
        let place = self.words.get(most).map_or(self.span(), Word::span);
        let message = format!("`{}` has the wrong number of values", self.keyword.text);
        Diagnostic::error(place, message).expected(expected).found(self.words.len().to_string())
    }
}

/// Keywords that a name follows: it runs to the end of the line, and `#` is a character of it.
const NAMED: &[&str] = &["usemtl", "newmtl", "mtllib", "g", "o"];

/// The lines that say something. A line ends with `\n`, `\r\n` or `\r`, unless `\` stands before that; a word that begins
/// with `#` begins a comment, except in names.
pub fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    let mut at = 0;
    std::iter::from_fn(move || {
        let mut words = Vec::new();
        while at < text.len() {
            let end = text[at..].find(['\n', '\r']).map_or(text.len(), |n| at + n);
            let part = &text[at..end];
            let continued = part.trim_end_matches([' ', '\t']).ends_with('\\');
            gather(part, at, &mut words);
            let crlf = text[end..].starts_with("\r\n");
            at = (end + if crlf { 2 } else { 1 }).min(text.len());
            if end == text.len() {
                at = end;
            }
            if !continued && !words.is_empty() {
                break;
            }
        }
        if words.is_empty() {
            return None;
        }
        let keyword = words.remove(0);
        Some(Line { keyword, words })
    })
}

fn gather<'a>(part: &'a str, start: usize, words: &mut Vec<Word<'a>>) {
    let blank = |c: char| c.is_whitespace() || c == '\u{feff}';
    let mut rest = part;
    loop {
        rest = rest.trim_start_matches(blank);
        let end = rest.find(blank).unwrap_or(rest.len());
        let word = &rest[..end];
        let in_name = words.first().is_some_and(|first| NAMED.contains(&first.text));
        if word.is_empty() || (word.starts_with('#') && !in_name) {
            return;
        }
        let place = start + (part.len() - rest.len());
        rest = &rest[end..];
        let is_last = rest.trim_matches(blank).is_empty();
        let text = if is_last { word.strip_suffix('\\').unwrap_or(word) } else { word };
        if !text.is_empty() {
            words.push(Word { text, start: place });
        }
    }
}

/// A finite number.
pub fn number(word: &Word, what: &str) -> Result<f64, Box<Diagnostic>> {
    match word.text.parse::<f64>() {
        Ok(x) if x.is_finite() => Ok(x),
        read => {
            let message = match read {
                Ok(_) => format!("{} is not finite", quoted(word.text)),
                Err(_) => format!("{} is not a number", quoted(word.text)),
            };
            let d = Diagnostic::error(word.span(), message);
            Err(Box::new(d.expected(format!("a finite number, {what}")).found(quoted(word.text))))
        }
    }
}
