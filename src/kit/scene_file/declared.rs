//! Names: declared once, before they are used; and blocks that stand too often, or lack something.

use super::diagnostic::{Diagnostic, Span, quoted};
use super::format::{Default, Kind, Names, Param, Role, State};
use super::parse::{Block, Entry};
use super::suggest::nearest;

/// A name and the block that declares it.
struct Declared<'a> {
    names: Names,
    name: &'a str,
    /// Index of the block.
    block: usize,
    span: Span,
}

/// Checks every name of a file, and that each block has what it requires.
pub fn check(blocks: &[Block], log: &mut Vec<Diagnostic>) {
    let declared = declarations(blocks, log);
    for (i, block) in blocks.iter().enumerate() {
        if block.rule.role == Role::Operation {
            let message = format!("`{}` stands outside of any `CSG`", block.rule.name);
            let d = Diagnostic::error(block.keyword.clone(), message);
            log.push(d.expected("it inside the braces of a `CSG`, or in a `.csg` file"));
        }
        log.extend(material_missing(block));
        inside(block, i, blocks, &declared, log);
    }
}

/// Checks a block and those inside of it; they count as standing where the outermost stands.
fn inside(block: &Block, at: usize, blocks: &[Block], declared: &[Declared], log: &mut Vec<Diagnostic>) {
    if block.rule.state == State::Planned {
        let message = format!("`{}` is not supported yet", block.rule.name);
        let d = Diagnostic::error(block.keyword.clone(), message);
        log.push(d.help("without it the picture would be wrong, so nothing is drawn"));
    }
    lacking(block, log);
    for entry in &block.entries {
        if let Kind::Reference(names) = entry.param.kind {
            log.extend(reference(entry, names, at, blocks, declared));
        }
    }
    block.children.iter().for_each(|inner| inside(inner, at, blocks, declared, log));
}

/// What a block requires and does not have, but for its material, which the leaves of a tree may leave to the tree.
pub fn lacking(block: &Block, log: &mut Vec<Diagnostic>) {
    let required = |p: &&Param| p.default == Default::Required && !is_material(p);
    log.extend(block.rule.params.iter().filter(required).filter_map(|param| missing(block, param)));
}

fn is_material(param: &Param) -> bool {
    param.kind == Kind::Reference(Names::Material)
}

fn material_missing(block: &Block) -> Option<Diagnostic> {
    let required = |p: &&Param| p.default == Default::Required && is_material(p);
    block.rule.params.iter().find(required).and_then(|param| missing(block, param))
}

fn missing(block: &Block, param: &Param) -> Option<Diagnostic> {
    let message = format!("`{}` has no `{}`", block.rule.name, param.name);
    let d = Diagnostic::error(block.keyword.clone(), message).expected(param.kind.all());
    let d = d.help(format!("write `{} {}` in it", param.name, param.values));
    (block.closed && block.entry(param.name).is_none()).then_some(d)
}

fn declarations<'a>(blocks: &'a [Block], log: &mut Vec<Diagnostic>) -> Vec<Declared<'a>> {
    let mut declared: Vec<Declared> = Vec::new();
    let mut first = std::collections::HashMap::new();
    for (i, block) in blocks.iter().enumerate() {
        let Role::Named(names) = block.rule.role else { continue };
        let Some(name) = block.word("Name") else { continue };
        let span = block.span("Name");
        let before = *first.entry((names.word(), name)).or_insert(i);
        if before == i {
            declared.push(Declared { names, name, block: i, span });
            continue;
        }
        let message = format!("{} {} is declared twice", names.word(), quoted(name));
        let d = Diagnostic::error(span, message).expected("another name");
        log.push(d.related(blocks[before].span("Name"), "first declared here"));
    }
    declared
}

/// Is the name declared, and above its use?
fn reference(
    entry: &Entry,
    names: Names,
    at: usize,
    blocks: &[Block],
    declared: &[Declared],
) -> Option<Diagnostic> {
    let name = entry.value.as_ref()?.word();
    let family = || declared.iter().filter(|d| d.names == names);
    // A declaration whose name cannot be read may be the one that is meant.
    let unreadable = |b: &Block| b.rule.role == Role::Named(names) && b.word("Name").is_none();
    match family().find(|d| d.name == name) {
        Some(d) if d.block < at => None,
        Some(d) => {
            let message = format!("{} {} is used before it is declared", names.word(), quoted(name));
            Some(
                Diagnostic::error(entry.span.clone(), message)
                    .expected(format!("a {} declared above", names.word()))
                    .related(d.span.clone(), "declared here")
                    .help("move the declaration up"),
            )
        }
        None if blocks.iter().any(unreadable) => None,
        None => {
            let message = format!("{} {} is not declared", names.word(), quoted(name));
            let d = Diagnostic::error(entry.span.clone(), message)
                .expected(format!("the name of a {} declared above", names.word()));
            Some(match nearest(name, family().map(|d| d.name)) {
                Some(near) => d.help(format!("did you mean `{near}`?")),
                None => d,
            })
        }
    }
}
