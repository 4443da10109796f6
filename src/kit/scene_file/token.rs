//! From characters to words, quoted texts and braces.

use super::diagnostic::{BYTE_ORDER_MARK, Diagnostic, Span};

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// `{`
    Open,
    /// `}`
    Close,
    /// Anything between white space, braces, quotes and comments.
    Word,
    /// Between double quotes; the token's text leaves the quotes out, its span does not.
    Quoted,
}

/// A piece of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Token<'a> {
    pub kind: TokenKind,
    pub text: &'a str,
    pub span: Span,
    /// Nothing but white space stands before it on its line.
    pub starts_line: bool,
}

/// Splits a file into tokens.
///
/// White space of any kind separates; `#` begins a comment, to the end of the line, everywhere but
/// inside a quoted text. A quoted text ends on its line. Control characters are reported, once
/// for the file, and otherwise count as white space.
pub fn tokens<'a>(source: &'a str, log: &mut Vec<Diagnostic>) -> Vec<Token<'a>> {
    let mut lexer =
        Lexer { source, at: 0, starts_line: true, tokens: Vec::new(), controls: None, curly: None };
    lexer.run(log);
    if let Some((span, count)) = lexer.controls.clone() {
        log.push(control_characters(source, span, count));
    }
    if let Some(span) = lexer.curly.clone() {
        let note = Diagnostic::note(span, "typographic quotes are read as \"straight\" ones");
        log.push(note);
    }
    lexer.tokens
}

fn control_characters(source: &str, span: Span, count: usize) -> Diagnostic {
    let code = source[span.clone()].chars().next().map_or(0, u32::from);
    let rest = if count > 1 { format!(" (the first of {count} in this file)") } else { String::new() };
    Diagnostic::error(span.clone(), format!("control character U+{code:04X} at byte {}{rest}", span.start))
        .expected("text")
        .found("a character that no text has")
        .help("is this a binary file, or one saved as UTF-16? Scene files are UTF-8 text")
}

struct Lexer<'a> {
    source: &'a str,
    at: usize,
    starts_line: bool,
    tokens: Vec<Token<'a>>,
    controls: Option<(Span, usize)>,
    curly: Option<Span>,
}

impl<'a> Lexer<'a> {
    fn run(&mut self, log: &mut Vec<Diagnostic>) {
        if self.source.starts_with(BYTE_ORDER_MARK) {
            self.at = BYTE_ORDER_MARK.len_utf8();
        }
        while let Some(c) = self.source[self.at..].chars().next() {
            match c {
                '\n' | '\r' => {
                    self.at += 1;
                    self.starts_line = true;
                }
                c if c.is_whitespace() => self.at += c.len_utf8(),
                c if c.is_control() => self.control(c),
                '#' => self.at = self.end_of_line(),
                '{' => self.push(TokenKind::Open, self.at..self.at + 1, self.at..self.at + 1),
                '}' => self.push(TokenKind::Close, self.at..self.at + 1, self.at..self.at + 1),
                c if is_quote(c) => self.quoted(c, log),
                _ => self.word(),
            }
        }
    }

    fn end_of_line(&self) -> usize {
        super::diagnostic::line_end(self.source, self.at)
    }

    fn push(&mut self, kind: TokenKind, text: Span, span: Span) {
        self.at = span.end;
        let starts_line = std::mem::replace(&mut self.starts_line, false);
        self.tokens.push(Token { kind, text: &self.source[text], span, starts_line });
    }

    fn control(&mut self, c: char) {
        let span = self.at..self.at + c.len_utf8();
        self.at = span.end;
        let (_, count) = self.controls.get_or_insert((span, 0));
        *count += 1;
    }

    fn word(&mut self) {
        let rest = &self.source[self.at..];
        let ends =
            |c: char| c.is_whitespace() || c.is_control() || matches!(c, '{' | '}' | '#') || is_quote(c);
        let span = self.at..self.at + rest.find(ends).unwrap_or(rest.len());
        self.push(TokenKind::Word, span.clone(), span);
    }

    fn quoted(&mut self, open: char, log: &mut Vec<Diagnostic>) {
        let start = self.at + open.len_utf8();
        let line_end = self.end_of_line();
        let closes = |c: char| if open == '"' { c == '"' } else { is_quote(c) };
        if open != '"' {
            self.curly.get_or_insert(self.at..start);
        }
        if let Some(length) = self.source[start..line_end].find(closes) {
            let end = start + length;
            let close = self.source[end..].chars().next().map_or(0, char::len_utf8);
            self.push(TokenKind::Quoted, start..end, self.at..end + close);
            return;
        }
        let line = &self.source[start..line_end];
        let text = line[..line.find(['{', '}']).unwrap_or(line.len())].trim_end(); // a brace still counts
        let end = start + text.len();
        log.push(
            Diagnostic::error(self.at..start, "this quote is never closed")
                .expected("a closing quote before the end of the line")
                .help("a text in quotes stands on one line"),
        );
        self.push(TokenKind::Quoted, start..end, self.at..end);
    }
}

/// Does it open or close a text?
pub fn is_quote(c: char) -> bool {
    matches!(c, '"' | '\u{201c}' | '\u{201d}')
}
