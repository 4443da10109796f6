//! Trees as `.csg` files.

use super::operation;
use crate::scene_file::diagnostic::Span;
use crate::scene_file::format::Kind;
use crate::scene_file::parse::{Block, Entry};
use crate::scene_file::value::Value;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Why a tree has no `.csg` file of its own.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotWritten {
    #[error("`{name}` comes from another file")]
    OtherFile { name: &'static str, at: Span },
    #[error("`{name}` holds {found} solids; expected {expected}")]
    Operands { name: &'static str, at: Span, expected: &'static str, found: usize },
}

impl NotWritten {
    /// Where the block stands that is in the way.
    pub fn at(&self) -> Span {
        match self {
            NotWritten::OtherFile { at, .. } | NotWritten::Operands { at, .. } => at.clone(),
        }
    }
}

/// The text of a `.csg` file for a tree as one block that holds its operands: a `CSG`, an operation or a solid.
///
/// Operands come before what names them; operations of more than two solids become chains of two.
pub fn write(tree: &Block) -> Result<String, NotWritten> {
    let mut writer = Writer::default();
    writer.node(tree, &[])?;
    Ok(writer.out)
}

#[derive(Default)]
struct Writer {
    out: String,
    /// Blocks so far, by type.
    counts: BTreeMap<&'static str, usize>,
}

/// A block that stands in the file, by type and index.
type Written = (&'static str, usize);

impl Writer {
    /// Writes a node and all below it; `more` are transformations from above that come after its own.
    fn node(&mut self, block: &Block, more: &[Entry]) -> Result<Written, NotWritten> {
        let (name, found) = (block.rule.name, block.children.len());
        let at = || block.keyword.clone();
        if name == "CSG" {
            let own: Vec<Entry> = transformations(block).chain(more).cloned().collect();
            return match &block.children[..] {
                [child] if block.entry("Source").is_none() => self.node(child, &own),
                _ if block.entry("Source").is_some() => Err(NotWritten::OtherFile { name, at: at() }),
                _ => Err(NotWritten::Operands { name, at: at(), expected: "one", found }),
            };
        }
        let Some(operation) = operation(block) else {
            return Ok(self.block(name, own(block).chain(more), &[]));
        };
        if found < 2 {
            return Err(NotWritten::Operands { name, at: at(), expected: "two or more", found });
        }
        let operands: Vec<Written> =
            block.children.iter().map(|c| self.node(c, &[])).collect::<Result<_, _>>()?;
        let entries = || own(block).chain(more);
        let last = operands.len() - 1;
        let mut left = operands[0];
        for (i, right) in operands.iter().enumerate().skip(1) {
            let names = [("Left", left), ("Right", *right)];
            left = match i == last {
                true => self.block(operation.name(), entries(), &names),
                false => self.block(operation.name(), std::iter::empty(), &names),
            };
        }
        Ok(left)
    }

    fn block<'a>(
        &mut self,
        name: &'static str,
        entries: impl Iterator<Item = &'a Entry>,
        operands: &[(&str, Written)],
    ) -> Written {
        let count = self.counts.entry(name).or_default();
        let index = *count;
        *count += 1;
        // Writing to a string cannot fail.
        let _ = writeln!(self.out, "{name} # {index}\n{{");
        for (side, (of_type, index)) in operands {
            let _ = writeln!(self.out, "  {side}Type {of_type}\n  {side}Index {index}");
        }
        for entry in entries {
            let _ = writeln!(self.out, "  {} {}", entry.param.name, words(entry));
        }
        self.out.push_str("}\n\n");
        (name, index)
    }
}

/// What the block says of itself, and not of who its operands are.
fn own(block: &Block) -> impl Iterator<Item = &Entry> {
    block.entries.iter().filter(|e| !(e.param.name.ends_with("Type") || e.param.name.ends_with("Index")))
}

fn transformations(block: &Block) -> impl Iterator<Item = &Entry> {
    block.entries.iter().filter(|e| matches!(e.param.name, "Translation" | "Rotation" | "Scale"))
}

/// The values as a file has them; numbers read back exactly.
fn words(entry: &Entry) -> String {
    let joined = |words: Vec<String>| words.join(" ");
    match &entry.value {
        Some(Value::Numbers(values)) => joined(values.iter().map(f64::to_string).collect()),
        Some(Value::Integers(values)) => joined(values.iter().map(i64::to_string).collect()),
        Some(Value::Word(word)) if entry.param.kind == Kind::Text => format!("\"{word}\""),
        Some(Value::Word(word)) => word.clone(),
        None => String::new(),
    }
}
