//! What is wrong with a file, and where: one finding each, and the list of all of them.

use std::ops::Range;

/// Bytes of the source, from start to end (exclusive); both lie on character boundaries inside it.
pub type Span = Range<usize>;

/// How bad a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// The file has no meaning here; nothing is built from it.
    Error,
    /// The file has a meaning, but probably not the intended one.
    Warning,
    /// Worth knowing.
    Note,
}

impl Severity {
    /// The word that messages begin with.
    pub fn word(self) -> &'static str {
        match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "note",
        }
    }
}

/// One finding at one place of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    pub severity: Severity,
    /// The place.
    pub span: Span,
    /// What is the matter, in one sentence without the place.
    pub message: String,
    /// What would be right there.
    pub expected: Option<String>,
    /// What stands there instead.
    pub found: Option<String>,
    /// Another place that has to do with it, and what is there.
    pub related: Option<(Span, String)>,
    /// What to do about it.
    pub help: Option<String>,
}

impl Diagnostic {
    pub fn new(severity: Severity, span: Span, message: impl Into<String>) -> Self {
        let message = printable(message.into());
        Diagnostic { severity, span, message, expected: None, found: None, related: None, help: None }
    }

    pub fn error(span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Error, span, message)
    }

    pub fn warning(span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, span, message)
    }

    pub fn note(span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Note, span, message)
    }

    pub fn expected(mut self, what: impl Into<String>) -> Self {
        self.expected = Some(what.into());
        self
    }

    pub fn found(mut self, what: impl Into<String>) -> Self {
        self.found = Some(what.into());
        self
    }

    pub fn related(mut self, span: Span, what: impl Into<String>) -> Self {
        self.related = Some((span, what.into()));
        self
    }

    pub fn help(mut self, what: impl Into<String>) -> Self {
        self.help = Some(what.into());
        self
    }

    /// The text under the underlined place.
    pub fn label(&self) -> Option<String> {
        match (&self.expected, &self.found) {
            (Some(e), Some(f)) => Some(format!("expected {e}, found {f}")),
            (Some(e), None) => Some(format!("expected {e}")),
            (None, Some(f)) => Some(format!("found {f}")),
            (None, None) => None,
        }
    }
}

/// Everything found in one file, sorted by place, with the text it speaks about.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostics {
    /// What messages call the file.
    pub name: String,
    /// The text that the spans count in.
    pub source: String,
    pub list: Vec<Diagnostic>,
    /// Of the files that this one names.
    pub files: Vec<Diagnostics>,
}

impl Diagnostics {
    pub fn new(name: &str, source: &str, mut list: Vec<Diagnostic>) -> Self {
        list.sort_by_key(|d| (d.span.start, d.span.end)); // stable: equal places keep the order of discovery
        Diagnostics { name: printable(name.to_owned()), source: source.to_owned(), list, files: Vec::new() }
    }

    /// With what was found in the files that this one names.
    pub fn with_files(self, files: Vec<Diagnostics>) -> Self {
        Diagnostics { files, ..self }
    }

    pub fn is_empty(&self) -> bool {
        self.list.is_empty() && self.files.iter().all(Diagnostics::is_empty)
    }

    pub fn of(&self, severity: Severity) -> impl Iterator<Item = &Diagnostic> {
        self.list.iter().filter(move |d| d.severity == severity)
    }

    pub fn errors(&self) -> impl Iterator<Item = &Diagnostic> {
        self.of(Severity::Error)
    }

    pub fn warnings(&self) -> impl Iterator<Item = &Diagnostic> {
        self.of(Severity::Warning)
    }

    pub fn notes(&self) -> impl Iterator<Item = &Diagnostic> {
        self.of(Severity::Note)
    }

    /// Line and column of a finding, both from 1.
    pub fn place(&self, diagnostic: &Diagnostic) -> Place {
        Place::of(&self.source, diagnostic.span.start)
    }
}

/// Line and column of a place, both from 1; columns count characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    pub line: usize,
    pub column: usize,
}

/// The invisible mark that some editors put before the first character.
pub const BYTE_ORDER_MARK: char = '\u{feff}';

impl Place {
    /// Where byte `offset` of the text is.
    ///
    /// Lines end with `\n`, `\r\n` or a lone `\r`. A byte order mark has no column.
    /// An offset behind the end counts as the end, one inside a character as that character.
    pub fn of(source: &str, offset: usize) -> Place {
        let mut offset = offset.min(source.len());
        while !source.is_char_boundary(offset) {
            offset -= 1;
        }
        let before = &source[..offset];
        let start = line_start(source, offset);
        let line = 1 + line_breaks(&source[..start]);
        let column = 1 + before[start..].chars().filter(|&c| c != BYTE_ORDER_MARK).count();
        Place { line, column }
    }
}

/// Number of line breaks in the text.
fn line_breaks(text: &str) -> usize {
    let bytes = text.as_bytes();
    let ends = |i: usize| bytes[i] == b'\n' || (bytes[i] == b'\r' && bytes.get(i + 1) != Some(&b'\n'));
    (0..bytes.len()).filter(|&i| ends(i)).count()
}

/// The byte at which the line of `offset` begins.
pub(super) fn line_start(source: &str, offset: usize) -> usize {
    let bytes = source.as_bytes();
    let mut i = offset;
    while i > 0 {
        let inside_crlf = bytes[i - 1] == b'\r' && bytes.get(i) == Some(&b'\n');
        if bytes[i - 1] == b'\n' || (bytes[i - 1] == b'\r' && !inside_crlf) {
            break;
        }
        i -= 1;
    }
    i
}

/// The byte at which the line of `offset` ends, before its line break.
pub(super) fn line_end(source: &str, offset: usize) -> usize {
    source[offset..].find(['\n', '\r']).map_or(source.len(), |i| offset + i)
}

/// Longest piece of a file that a message quotes [characters].
const LONGEST_QUOTE: usize = 40;

/// A piece of the file inside a message: in back quotes, shortened, control characters escaped.
pub fn quoted(text: &str) -> String {
    format!("`{}`", quoted_name(text))
}

/// The same without the quotes.
pub fn quoted_name(text: &str) -> String {
    let mut out = String::new();
    for (i, c) in text.chars().enumerate() {
        if i == LONGEST_QUOTE {
            out.push('…');
            break;
        }
        match is_printable(c) {
            true => out.push(c),
            false => out.extend(c.escape_default()),
        }
    }
    out
}

/// The text with what may not reach a terminal escaped; paths may hold anything.
fn printable(text: String) -> String {
    if text.chars().all(is_printable) {
        return text;
    }
    let escaped = |c: char| if is_printable(c) { c.to_string() } else { c.escape_default().to_string() };
    text.chars().map(escaped).collect()
}

/// May this character reach a terminal? Escape sequences and marks that turn the reading
/// direction may not: they would make a message lie.
pub fn is_printable(c: char) -> bool {
    let invisible = matches!(c, '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}'
        | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}'
        | '\u{e0000}'..='\u{e0fff}');
    !c.is_control() && !invisible
}
