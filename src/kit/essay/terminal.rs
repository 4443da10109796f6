//! An essay on the terminal: paragraphs without markup, wrapped to its width.

use super::{Essay, Part, Values, filled, plain};
use pulldown_cmark::{Event, Tag, TagEnd};

/// The paragraphs of a section as plain text, list items with a mark before them; figures, tables and what is folded
/// are left out, except in a section that is folded whole.
pub fn paragraphs(essay: &Essay, part: Part, values: &Values) -> Vec<String> {
    let mut out = Vec::new();
    let mut text = String::new();
    let mut lists: Vec<Option<u64>> = Vec::new();
    let mut hidden = 0;
    let close = |text: &mut String, out: &mut Vec<String>| {
        let whole = text.split_whitespace().collect::<Vec<_>>().join(" ");
        if !whole.is_empty() {
            out.push(whole);
        }
        text.clear();
    };
    for (event, _) in essay.events(part) {
        match event {
            Event::Start(Tag::BlockQuote(_) | Tag::Image { .. } | Tag::Table(_)) => hidden += 1,
            Event::End(TagEnd::BlockQuote(_) | TagEnd::Image | TagEnd::Table) => hidden -= 1,
            _ if hidden > 0 => {}
            Event::Start(Tag::List(first)) => {
                close(&mut text, &mut out);
                lists.push(*first);
            }
            Event::End(TagEnd::List(_)) => {
                lists.pop();
            }
            Event::Start(Tag::Item) => match lists.last_mut() {
                Some(Some(number)) => {
                    text = format!("{number}. ");
                    *number += 1;
                }
                _ => text = mark(part, &out),
            },
            Event::End(TagEnd::Paragraph | TagEnd::Item | TagEnd::CodeBlock) => close(&mut text, &mut out),
            Event::Text(t) => text += &filled(t, values),
            Event::Code(t) => text += t,
            Event::InlineMath(m) => text += &plain(m),
            Event::DisplayMath(m) => {
                close(&mut text, &mut out);
                out.push(format!("    {}", plain(m)));
            }
            Event::SoftBreak | Event::HardBreak => text.push(' '),
            _ => {}
        }
    }
    close(&mut text, &mut out);
    out
}

/// Options to choose from carry letters, as on the page.
fn mark(part: Part, before: &[String]) -> String {
    if part != Part::Predict {
        return "• ".to_string();
    }
    let chosen = before.iter().filter(|p| p.get(1..3) == Some(") ")).count();
    format!("{}) ", ["a", "b", "c", "d"].get(chosen).unwrap_or(&"•"))
}

/// Wraps a paragraph at `width` columns; what begins with a mark hangs behind it.
pub fn wrapped(paragraph: &str, width: usize) -> String {
    let indent = paragraph.len() - paragraph.trim_start().len();
    let hang = match paragraph.split_once(' ') {
        Some((first, _))
            if first == "•"
                || first.ends_with(')') && first.len() == 2
                || first.ends_with('.') && first.len() == 2 =>
        {
            first.chars().count() + 1
        }
        _ => indent,
    };
    let mut lines: Vec<String> = vec![" ".repeat(indent)];
    let mut column = indent;
    for word in paragraph.split_whitespace() {
        let length = console::measure_text_width(word);
        if column > hang && column + 1 + length > width {
            lines.push(" ".repeat(hang));
            column = hang;
        }
        if let Some(line) = lines.last_mut() {
            if !line.trim().is_empty() {
                line.push(' ');
                column += 1;
            }
            line.push_str(word);
            column += length;
        }
    }
    lines.join("\n")
}
