//! An essay as HTML: sections with ids, formulas as MathML, figures numbered, answers folded.

use super::formula::{Setting, mathml};
use super::{Essay, Glossary, Part, Section, Values, filled};
use pulldown_cmark::{CowStr, Event, LinkType, Tag, TagEnd, html::push_html};

/// What stands in a figure's place: its HTML, made by the page.
pub trait Shown {
    /// The figure of that name, the `number`-th of the page; words of the essay replace its caption unless empty.
    fn figure(&self, name: &str, number: usize, caption: &str) -> String;
}

/// The sections as HTML. The first paragraph of the question is left to the page, which shows it as its heading.
pub fn html(essay: &Essay, values: &Values, figures: &dyn Shown) -> String {
    let mut writer = Writer { values, figures, number: 0 };
    essay.sections.iter().map(|section| writer.section(section)).collect()
}

/// An identifier for a heading: `where-it-breaks`.
fn id(part: Part) -> String {
    part.heading().to_lowercase().replace(' ', "-")
}

struct Writer<'a> {
    values: &'a Values,
    figures: &'a dyn Shown,
    number: usize,
}

impl Writer<'_> {
    fn section(&mut self, section: &Section) -> String {
        let mut body = String::new();
        push_html(&mut body, self.events(section).into_iter());
        let (id, heading) = (id(section.part), section.part.heading());
        match section.part {
            Part::Question => format!("<section id=\"{id}\">\n{body}</section>\n"),
            Part::Use | Part::Documents => format!(
                "<section id=\"{id}\"><details class=\"{}\"><summary><h2>{heading}</h2></summary>\n{body}</details></section>\n",
                if section.part == Part::Use { "answer" } else { "documents" }
            ),
            _ => format!("<section id=\"{id}\">\n<h2>{heading}</h2>\n{body}</section>\n"),
        }
    }

    fn events<'e>(&mut self, section: &'e Section) -> Vec<Event<'e>> {
        let mut out: Vec<Event> = Vec::new();
        let mut events = section.events.iter().map(|(event, _)| event).peekable();
        let mut lists = 0;
        let mut skipping = section.part == Part::Question;
        while let Some(event) = events.next() {
            if skipping {
                skipping = !matches!(event, Event::End(TagEnd::Paragraph));
                continue;
            }
            match event {
                Event::Text(text) => out.push(Event::Text(filled(text, self.values).into())),
                Event::InlineMath(m) => out.push(raw(formula(m, Setting::Inline))),
                Event::DisplayMath(m) => {
                    out.push(raw(format!("<div class=\"formula\">{}</div>", formula(m, Setting::Display))))
                }
                Event::Start(Tag::Paragraph)
                    if matches!(events.peek(), Some(Event::Start(Tag::Image { .. }))) =>
                {
                    let mut caption = String::new();
                    let mut name = String::new();
                    for inner in events.by_ref() {
                        match inner {
                            Event::Start(Tag::Image { dest_url, .. }) => name = dest_url.to_string(),
                            Event::Text(t) | Event::Code(t) => caption += &filled(t, self.values),
                            Event::SoftBreak => caption.push(' '),
                            Event::End(TagEnd::Paragraph) => break,
                            _ => {}
                        }
                    }
                    self.number += 1;
                    out.push(raw(self.figures.figure(&name, self.number, &caption)));
                }
                Event::Start(Tag::BlockQuote(_)) => {
                    events.next_if(|e| matches!(e, Event::Start(Tag::Paragraph)));
                    events.next_if(|e| matches!(e, Event::Start(Tag::Strong)));
                    let label = match events.next() {
                        Some(Event::Text(text)) => text.trim_end_matches('.').to_string(),
                        _ => String::new(),
                    };
                    events.next_if(|e| matches!(e, Event::End(TagEnd::Strong)));
                    out.push(raw(format!("<details><summary>{}</summary><p>", escaped(&label))));
                }
                Event::End(TagEnd::BlockQuote(_)) => out.push(raw("</details>\n".to_string())),
                Event::Start(Tag::Link { dest_url, .. }) if dest_url.starts_with('#') => {
                    out.push(raw(term_link(&dest_url[1..])));
                }
                Event::Start(Tag::Link {
                    link_type: LinkType::Autolink | LinkType::Inline,
                    dest_url,
                    ..
                }) if !dest_url.starts_with("http") => {
                    out.push(raw(format!("<a href=\"../{}\">", escaped(dest_url))));
                }
                Event::End(TagEnd::Link) => out.push(raw("</a>".to_string())),
                Event::Start(Tag::List(_)) if section.part == Part::Predict && lists == 0 => {
                    lists += 1;
                    out.push(raw("<ol class=\"options\" type=\"a\">\n".to_string()));
                }
                Event::End(TagEnd::List(_)) if section.part == Part::Predict => {
                    lists -= 1;
                    out.push(raw("</ol>\n".to_string()));
                }
                Event::Start(Tag::Item) if section.part == Part::Predict => {
                    out.push(raw("<li><label><input type=\"radio\" name=\"predict\"> ".to_string()));
                }
                Event::End(TagEnd::Item) if section.part == Part::Predict => {
                    out.push(raw("</label></li>\n".to_string()));
                }
                event => out.push(event.clone()),
            }
        }
        out
    }
}

fn raw(html: String) -> Event<'static> {
    Event::Html(CowStr::from(html))
}

/// MathML; a formula that cannot be read was refused when the essay was.
fn formula(latex: &str, setting: Setting) -> String {
    mathml(latex, setting).unwrap_or_else(|_| escaped(latex))
}

/// The beginning of a link to a word's meaning, which also shows when the pointer rests on it.
fn term_link(key: &str) -> String {
    let meaning =
        Glossary::book().get(key).map(|t| t.meaning.replace(['*', '$', '`'], "")).unwrap_or_default();
    format!("<a class=\"term\" href=\"#term-{}\" title=\"{}\">", escaped(key), escaped(&meaning))
}

/// Text in HTML, in elements and in quoted attributes.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A line of Markdown as HTML, without a paragraph round it.
pub fn line(markdown: &str) -> String {
    let mut body = String::new();
    let events = pulldown_cmark::Parser::new_ext(markdown, pulldown_cmark::Options::ENABLE_MATH);
    let inner = events.filter(|e| !matches!(e, Event::Start(Tag::Paragraph) | Event::End(TagEnd::Paragraph)));
    push_html(
        &mut body,
        inner.map(|e| match e {
            Event::InlineMath(m) => raw(formula(&m, Setting::Inline)),
            e => e,
        }),
    );
    body
}
