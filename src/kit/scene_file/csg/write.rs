//! Trees as `.csg` files.

use super::operation;
use crate::csg::Operation;
use crate::scene_file::diagnostic::Span;
use crate::scene_file::format::Kind;
use crate::scene_file::parse::{Block, Entry};
use crate::scene_file::token::is_quote;
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
    #[error("no quotes can stand round this text; expected one without quotes and control characters")]
    Text { at: Span },
}

impl NotWritten {
    /// Where the block or the text stands that is in the way.
    pub fn at(&self) -> Span {
        match self {
            NotWritten::OtherFile { at, .. } | NotWritten::Operands { at, .. } | NotWritten::Text { at } => {
                at.clone()
            }
        }
    }
}

/// Longest list of operands that becomes a chain, `((a ∪ b) ∪ c) ∪ d`; a longer one is halved, `(a ∪ b) ∪ (c ∪ d)`, for a
/// chain is as deep as it is long, and the reader goes [`MOST_DEEP`](super::MOST_DEEP) deep.
const LONGEST_CHAIN: usize = 64;

/// The text of a `.csg` file for a tree as one block that holds its operands: a `CSG`, an operation or a solid.
///
/// Operands come before what names them; operations of more than two solids become several of two. Files are named as the tree
/// names them.
pub fn write(tree: &Block) -> Result<String, NotWritten> {
    write_moved(tree, &|path| path.to_owned())
}

/// [`write()`] for a file in another folder: the files that the tree names are called what `renamed` says.
pub fn write_moved(tree: &Block, renamed: &dyn Fn(&str) -> String) -> Result<String, NotWritten> {
    let mut writer = Writer { out: String::new(), counts: BTreeMap::new(), renamed };
    let mut tree = tree.clone();
    if tree.rule.name == "CSG" {
        // Its material is left to the scene that will name the file.
        tree.entries.retain(|e| e.param.name != "Material");
    }
    writer.node(&tree, Outer { material: None, transformations: &[] })?;
    Ok(writer.out)
}

struct Writer<'a> {
    out: String,
    /// Blocks so far, by type.
    counts: BTreeMap<&'static str, usize>,
    renamed: &'a dyn Fn(&str) -> String,
}

/// What a `CSG` inside of the tree says of the one block in it.
#[derive(Clone, Copy)]
struct Outer<'a> {
    /// For what names no material of its own.
    material: Option<&'a Entry>,
    /// To come after the block's own.
    transformations: &'a [Entry],
}

/// A block that stands in the file, by type and index.
type Written = (&'static str, usize);

impl Writer<'_> {
    /// Writes a node and all below it.
    fn node(&mut self, block: &Block, outer: Outer) -> Result<Written, NotWritten> {
        let (name, found) = (block.rule.name, block.children.len());
        let at = || block.keyword.clone();
        if name == "CSG" {
            let transformations: Vec<Entry> =
                transformations(block).chain(outer.transformations).cloned().collect();
            let material = block.entry("Material").or(outer.material);
            return match &block.children[..] {
                [child] if block.entry("Source").is_none() => {
                    self.node(child, Outer { material, transformations: &transformations })
                }
                _ if block.entry("Source").is_some() => Err(NotWritten::OtherFile { name, at: at() }),
                _ => Err(NotWritten::Operands { name, at: at(), expected: "one", found }),
            };
        }
        let entries: Vec<&Entry> = own(block)
            .chain(outer.material.filter(|_| block.entry("Material").is_none()))
            .chain(outer.transformations)
            .collect();
        let Some(operation) = operation(block) else {
            return self.block(name, &entries, &[]);
        };
        if found < 2 {
            return Err(NotWritten::Operands { name, at: at(), expected: "two or more", found });
        }
        let alone = Outer { material: None, transformations: &[] };
        let operands: Vec<Written> =
            block.children.iter().map(|c| self.node(c, alone)).collect::<Result<_, _>>()?;
        self.operation(operation, &operands, &entries)
    }

    /// Two or more operands that are written already, as operations of two; the last of them has the entries.
    fn operation(
        &mut self,
        operation: Operation,
        operands: &[Written],
        entries: &[&Entry],
    ) -> Result<Written, NotWritten> {
        let (left, right) = match (operation, operands) {
            (_, [left, right]) => (*left, *right),
            (_, [first @ .., last]) if operands.len() <= LONGEST_CHAIN => {
                (self.operation(operation, first, &[])?, *last)
            }
            // a − b − c − d is a − (b ∪ c ∪ d).
            (Operation::Difference, [first, rest @ ..]) => {
                (*first, self.operation(Operation::Union, rest, &[])?)
            }
            _ => {
                let (left, right) = operands.split_at(operands.len() / 2);
                (self.operation(operation, left, &[])?, self.operation(operation, right, &[])?)
            }
        };
        self.block(operation.name(), entries, &[("Left", left), ("Right", right)])
    }

    fn block(
        &mut self,
        name: &'static str,
        entries: &[&Entry],
        operands: &[(&str, Written)],
    ) -> Result<Written, NotWritten> {
        let count = self.counts.entry(name).or_default();
        let index = *count;
        *count += 1;
        // Writing to a string cannot fail.
        let _ = writeln!(self.out, "{name} # {index}\n{{");
        for (side, (of_type, index)) in operands {
            let _ = writeln!(self.out, "  {side}Type {of_type}\n  {side}Index {index}");
        }
        for entry in entries {
            let words = self.words(entry)?;
            let _ = writeln!(self.out, "  {} {words}", entry.param.name);
        }
        self.out.push_str("}\n\n");
        Ok((name, index))
    }

    /// The values as a file has them; numbers read back exactly.
    fn words(&self, entry: &Entry) -> Result<String, NotWritten> {
        let joined = |words: Vec<String>| words.join(" ");
        Ok(match &entry.value {
            Some(Value::Numbers(values)) => joined(values.iter().map(f64::to_string).collect()),
            Some(Value::Integers(values)) => joined(values.iter().map(i64::to_string).collect()),
            Some(Value::Word(word)) if entry.param.kind == Kind::Text => {
                quoted(&(self.renamed)(word), entry)?
            }
            Some(Value::Word(word)) if is_plain(word) => word.clone(),
            Some(Value::Word(word)) => quoted(word, entry)?,
            None => String::new(),
        })
    }
}

/// Is it a word without quotes?
fn is_plain(word: &str) -> bool {
    !word.contains(|c: char| c.is_whitespace() || c.is_control() || "{}#".contains(c) || is_quote(c))
}

fn quoted(text: &str, entry: &Entry) -> Result<String, NotWritten> {
    if text.contains(|c: char| c == '"' || c.is_control()) {
        return Err(NotWritten::Text { at: entry.span.clone() });
    }
    Ok(format!("\"{text}\""))
}

/// What the block says of itself, and not of who its operands are.
fn own(block: &Block) -> impl Iterator<Item = &Entry> {
    block.entries.iter().filter(|e| !(e.param.name.ends_with("Type") || e.param.name.ends_with("Index")))
}

fn transformations(block: &Block) -> impl Iterator<Item = &Entry> {
    block.entries.iter().filter(|e| matches!(e.param.name, "Translation" | "Rotation" | "Scale"))
}
