//! The format, printed.

use super::blocks::{TRANSFORMATIONS, rules};
use super::format::{Default, Origin, Param, Rule, State, Times};
use super::pending::is_pending;

/// A small scene that a reader can copy.
const EXAMPLE: &str = include_str!("example.scene");

/// The whole format as Markdown: a scene as an example, what holds for every block, then every block with its parameters,
/// values, defaults and units.
pub fn reference() -> String {
    let mut out = format!(
        "A scene file describes what is seen, from where, and in which light. This is a whole one; saved as `first.scene`, \
         `cargo run -- render first.scene` makes a picture of it:\n\n```text\n{EXAMPLE}```\n\n\
         A scene file is UTF-8 text: blocks `Name {{ Parameter values … }}` in any order, parameters in any \
         order, white space and line breaks anywhere between words. `#` begins a comment, to the end of the \
         line. Materials are declared before they are used. Names distinguish capital letters. A scene has a `Camera` and at \
         least one object. Blocks and rows marked † are this project's own, not the document's.\n"
    );
    out.push_str(&transformations());
    for rule in rules() {
        out.push_str(&section(rule));
    }
    out
}

/// What most objects take, described once.
fn transformations() -> String {
    let mut out = String::from(
        "\n### Transformations\n\nMost objects, and what is made of several, can be moved, turned and stretched: a block \
         with the line *Transformations* takes any number of these, and they are applied in the order in which they are \
         written.\n\n",
    );
    out.push_str(HEAD);
    TRANSFORMATIONS.iter().for_each(|param| out.push_str(&row("", param)));
    out
}

const HEAD: &str = "| parameter | values | default | unit | meaning |\n|---|---|---|---|---|\n";

fn section(rule: &Rule) -> String {
    let later = if rule.state == State::Planned { " *Not supported yet.*" } else { "" };
    let mut out = format!("\n### `{}`{}\n\n{}{later}\n\n{HEAD}", rule.name, mark(rule.origin), rule.doc);
    let (moved, own): (Vec<&Param>, Vec<&Param>) = rule.params.iter().partition(|p| is_transformation(p));
    own.into_iter().for_each(|param| out.push_str(&row(rule.name, param)));
    if let [first, ..] = moved[..] {
        let mark = mark(first.origin);
        out.push_str(&format!("\nTransformations{mark}: see [above](#transformations).\n"));
    }
    out
}

fn is_transformation(param: &Param) -> bool {
    TRANSFORMATIONS.iter().any(|t| t.name == param.name)
}

fn row(block: &str, param: &Param) -> String {
    let later = if is_pending(block, param.name) { " *No effect yet.*" } else { "" };
    let repeat = if param.times == Times::Any { "; may be repeated" } else { "" };
    format!(
        "| `{}`{} | `{}`: {} | {} | {} | {}{repeat}{later} |\n",
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
