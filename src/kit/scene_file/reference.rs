//! The format, printed.

use super::blocks::rules;
use super::format::{Default, Origin, Param, Rule, State, Times};

/// The whole format as Markdown: every block with its parameters, values, defaults and units.
pub fn reference() -> String {
    let mut out = String::from(
        "A scene file is UTF-8 text: blocks `Name { Parameter values … }` in any order, parameters in any \
         order, white space and line breaks anywhere between words. `#` begins a comment, to the end of the \
         line. Materials are declared before they are used. Names distinguish capital letters. \
         Rows marked † are this project's own, not the document's.\n",
    );
    for rule in rules() {
        out.push_str(&section(rule));
    }
    out
}

fn section(rule: &Rule) -> String {
    let later = if rule.state == State::Planned { " *Not supported yet.*" } else { "" };
    let mut out = format!("\n### `{}`{}\n\n{}{later}\n\n", rule.name, mark(rule.origin), rule.doc);
    out.push_str("| parameter | values | default | unit | meaning |\n|---|---|---|---|---|\n");
    for param in rule.params {
        out.push_str(&row(param));
    }
    out
}

fn row(param: &Param) -> String {
    let repeat = if param.times == Times::Any { "; may be repeated" } else { "" };
    format!(
        "| `{}`{} | `{}`: {} | {} | {} | {}{repeat} |\n",
        param.name,
        mark(param.origin),
        param.values,
        param.kind.all(),
        default_text(param),
        param.unit,
        param.doc,
    )
}

fn mark(origin: Origin) -> &'static str {
    match origin {
        Origin::Document => "",
        Origin::Extension => " †",
    }
}

/// The default as it would be written in a file.
pub fn default_text(param: &Param) -> String {
    let joined = |words: Vec<String>| words.join(" ");
    match param.default {
        Default::Required => "must be given".to_owned(),
        Default::Absent => "none".to_owned(),
        Default::Numbers(values) => joined(values.iter().map(f64::to_string).collect()),
        Default::Integers(values) => joined(values.iter().map(i64::to_string).collect()),
        Default::Word(word) => word.to_owned(),
    }
}
