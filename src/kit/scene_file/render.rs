//! Findings as text: `file:line:column: error: …`, and the place underlined.

use super::diagnostic::{
    BYTE_ORDER_MARK, Diagnostic, Diagnostics, Place, Severity, Span, is_printable, line_end, line_start,
};
use ariadne::{CharSet, Config, IndexType, Label, Report, ReportKind, Source};

/// Are escape sequences for colours wanted?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Color {
    Always,
    Never,
}

/// Findings shown at most; a file of garbage has more, and nobody reads them.
const SHOWN: usize = 100;
/// Longest line shown whole [characters]; of a longer one, a window about the place.
const LONGEST_LINE: usize = 160;
/// Characters shown before the place in such a window.
const BEFORE: usize = 40;

impl Diagnostics {
    /// All findings as text, in order of place; after the hundredth only their number is told.
    pub fn render(&self, color: Color) -> String {
        let name: String = self.name.chars().map(|c| if is_printable(c) { c } else { '\u{fffd}' }).collect();
        let mut out = String::new();
        for diagnostic in self.list.iter().take(SHOWN) {
            out.push_str(&render_one(&name, &self.source, diagnostic, color));
            out.push('\n');
        }
        if self.list.len() > SHOWN {
            out.push_str(&format!("{name}: … and {} more\n", self.list.len() - SHOWN));
        }
        self.files.iter().for_each(|file| out.push_str(&file.render(color)));
        out
    }
}

fn render_one(name: &str, source: &str, diagnostic: &Diagnostic, color: Color) -> String {
    let place = Place::of(source, diagnostic.span.start);
    let excerpt = Excerpt::new(source, diagnostic);
    let heading = format!("{name}:{}:{}: {}", place.line, place.column, diagnostic.severity.word());
    let (tint, escape) = match diagnostic.severity {
        Severity::Error => (ariadne::Color::Red, "31"),
        Severity::Warning => (ariadne::Color::Yellow, "33"),
        Severity::Note => (ariadne::Color::Cyan, "36"),
    };
    let primary = (name, excerpt.primary.clone());
    let config = Config::new()
        .with_color(color == Color::Always)
        .with_index_type(IndexType::Byte)
        .with_char_set(CharSet::Unicode);
    let mut report = Report::build(ReportKind::Error, primary.clone()).with_config(config);
    let (first, second) = if excerpt.related_comes_first() { (1, 0) } else { (0, 1) };
    let mut label = Label::new(primary).with_color(tint).with_order(first);
    if let Some(text) = diagnostic.label() {
        label = label.with_message(text);
    }
    report = report.with_label(label);
    if let (Some(span), Some((_, text))) = (excerpt.related.clone(), &diagnostic.related) {
        let label = Label::new((name, span)).with_color(ariadne::Color::Blue).with_order(second);
        report = report.with_label(label.with_message(text));
    }
    if let Some(help) = &diagnostic.help {
        report = report.with_help(help);
    }
    let heading = match color {
        Color::Always => format!("\u{1b}[{escape}m{heading}:\u{1b}[0m {}", diagnostic.message),
        Color::Never => format!("{heading}: {}", diagnostic.message),
    };
    let mut bytes = Vec::new();
    // Writing to memory fails on no input; were it to, the heading still says what and where.
    let frame = match report.finish().write((name, Source::from(excerpt.text.as_str())), &mut bytes) {
        Ok(()) => String::from_utf8_lossy(&bytes).into_owned(),
        Err(_) => String::new(),
    };
    let frame = frame.split_once('\n').map_or("", |(_, rest)| rest); // our heading is better than its own
    let frame = correct_column(frame, name, place, excerpt.first_column);
    let lines = std::iter::once(heading.as_str()).chain(frame.lines().map(str::trim_end));
    lines.collect::<Vec<_>>().join("\n") + "\n"
}

/// In a window of a long line the frame counts columns from the window's edge.
fn correct_column(frame: &str, name: &str, place: Place, first_column: usize) -> String {
    if first_column == 1 {
        return frame.to_owned();
    }
    let shown = place.column + 2 - first_column; // the window begins with the mark `…`
    let wrong = format!(" {name}:{}:{shown} ", place.line);
    frame.replacen(&wrong, &format!(" {name}:{}:{} ", place.line, place.column), 1)
}

/// The lines that a finding points at, harmless to a terminal; the others are left empty, so that
/// line numbers stay.
struct Excerpt {
    text: String,
    primary: Span,
    related: Option<Span>,
    /// Column of the source that the first shown character of the primary line has.
    first_column: usize,
}

impl Excerpt {
    fn new(source: &str, diagnostic: &Diagnostic) -> Self {
        let at = Place::of(source, diagnostic.span.start);
        let related = diagnostic.related.as_ref().map(|(span, _)| (span, Place::of(source, span.start)));
        let main = Line::around(source, &diagnostic.span);
        let mut excerpt =
            Excerpt { text: String::new(), primary: 0..0, related: None, first_column: main.first_column };
        let other = related.filter(|(_, place)| place.line != at.line);
        if let Some((span, place)) = other.filter(|(_, place)| place.line < at.line) {
            excerpt.related = Some(excerpt.add(place.line, &Line::around(source, span), span));
        }
        excerpt.primary = excerpt.add(at.line, &main, &diagnostic.span);
        if let Some((span, place)) = other.filter(|(_, place)| place.line > at.line) {
            excerpt.related = Some(excerpt.add(place.line, &Line::around(source, span), span));
        }
        if let Some((span, _)) = related.filter(|(_, place)| place.line == at.line) {
            let start = excerpt.text.len() - main.text.len();
            excerpt.related = main.locate(span).map(|r| start + r.start..start + r.end);
        }
        excerpt
    }

    /// Appends a line under its number; returns where the span is in the excerpt.
    fn add(&mut self, number: usize, line: &Line, span: &Span) -> Span {
        let have = 1 + self.text.bytes().filter(|&b| b == b'\n').count();
        self.text.extend(std::iter::repeat_n('\n', number - have));
        let start = self.text.len();
        self.text.push_str(&line.text);
        let inside = line.locate(span).unwrap_or(0..1);
        start + inside.start..start + inside.end
    }

    fn related_comes_first(&self) -> bool {
        self.related.as_ref().is_some_and(|r| r.start < self.primary.start)
    }
}

/// One line of the source, cleaned, or a window of it.
struct Line {
    text: String,
    /// Byte in the source and byte in `text` of each shown character, and of the end.
    places: Vec<(usize, usize)>,
    first_column: usize,
}

impl Line {
    fn around(source: &str, span: &Span) -> Self {
        let (start, end) = (line_start(source, span.start), line_end(source, span.start));
        let chars: Vec<(usize, char)> = source[start..end]
            .char_indices()
            .map(|(i, c)| (start + i, c))
            .filter(|&(_, c)| c != BYTE_ORDER_MARK)
            .collect();
        let at = chars.partition_point(|&(i, _)| i < span.start);
        let window = match chars.len() > LONGEST_LINE {
            true => at.saturating_sub(BEFORE)..chars.len().min(at.saturating_sub(BEFORE) + LONGEST_LINE),
            false => 0..chars.len(),
        };
        let mut line = Line { text: String::new(), places: Vec::new(), first_column: window.start + 1 };
        if window.start > 0 {
            line.text.push('…');
        }
        for &(i, c) in &chars[window.clone()] {
            line.places.push((i, line.text.len()));
            line.text.push(if is_printable(c) || c == '\t' { c } else { '\u{fffd}' });
        }
        line.places.push((chars.get(window.end).map_or(end, |c| c.0), line.text.len()));
        line.text.push(if window.end < chars.len() { '…' } else { ' ' });
        line
    }

    /// The span in the shown text, at least one character long; nothing if it lies outside.
    fn locate(&self, span: &Span) -> Option<Span> {
        let (first, last) = (self.places.first()?.0, self.places.last()?.0);
        if span.start > last || span.end < first {
            return None;
        }
        let at = |byte: usize| self.places.partition_point(|&(i, _)| i < byte).min(self.places.len() - 1);
        let (from, to) = (self.places[at(span.start)].1, self.places[at(span.end)].1);
        let width = self.text[from..].chars().next().map_or(1, char::len_utf8);
        Some(from..to.max(from + width))
    }
}
