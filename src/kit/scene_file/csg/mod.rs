//! `.csg` files: trees of solids whose nodes name each other by type and index [D Annex C].
//!
//! ```text
//! Box { Scale 3 3 3 }   Sphere { Radius 2 }
//! Intersection { LeftType Box LeftIndex 0  RightType Sphere RightIndex 0 }
//! ```
//!
//! The document leaves two things open, which hold here: indices count the blocks of their type from 0 in the order of the
//! file, and the whole tree is the node that no other names. `Operation` as a type counts the blocks of all three
//! operations, which the document keeps in one list (§5.4.7.3).

mod link;
mod outline;
mod write;

pub use write::{NotWritten, write, write_moved};

use super::declared;
use super::diagnostic::{Diagnostic, Diagnostics};
use super::format::Role;
use super::parse::{self, Block};
use super::source::{self, ReadError};
use super::token;
use crate::csg::Operation;
use link::Links;
use std::path::{Component, Path, PathBuf};

/// Most solids of a tree, a node that is named twice counted twice.
pub const MOST_SOLIDS: usize = 65_536;

/// Most operations inside one another.
pub const MOST_DEEP: usize = 512;

/// A file's nodes and who holds whom; also of files that are wrong, as far as they can be read.
#[derive(Debug)]
pub struct CsgFile {
    /// All blocks, in the file's order.
    blocks: Vec<Block>,
    links: Links,
    /// Everything that was found.
    pub remarks: Diagnostics,
}

/// Which operation a block is.
pub(super) fn operation(block: &Block) -> Option<Operation> {
    Operation::ALL.into_iter().find(|o| block.rule.role == Role::Operation && o.name() == block.rule.name)
}

/// Reads a tree from its text; `name` is what messages call the file. What is wrong stands in the remarks.
pub fn read(source: &str, name: &str) -> CsgFile {
    let mut log = Vec::new();
    let tokens = token::tokens(source, &mut log);
    let parsed = parse::parse(source, &tokens, &mut log);
    for block in &parsed.blocks {
        log.extend(foreign(block));
        declared::lacking(block, &mut log);
    }
    let links = Links::new(&parsed, source, &mut log);
    CsgFile { blocks: parsed.blocks, links, remarks: Diagnostics::new(name, source, log) }
}

/// Reads a tree from a file; messages call it by its path as given.
///
/// - Errors: a file that cannot be read at all; one that is wrong comes with its remarks.
pub fn read_file(path: &Path) -> Result<CsgFile, ReadError> {
    Ok(read(&source::text(path, source::LARGEST_FILE)?, &path.display().to_string()))
}

/// The text of a `.csg` file for each `CSG` of a scene, in the scene's order; `name` is what messages call the scene, and the
/// files are to stand in the folder `into`, from which they name others.
///
/// - Errors: everything that is wrong with the scene; a `CSG` that has no such file, at its place.
pub fn of_scene(source: &str, name: &str, into: &Path) -> Result<Vec<String>, Diagnostics> {
    let scene = super::read(source, name)?;
    let parsed = parse::parse(source, &token::tokens(source, &mut Vec::new()), &mut Vec::new());
    let folder = Path::new(name).parent().unwrap_or(Path::new(""));
    let renamed = |path: &str| path_from(into, folder, path);
    let mut log = Vec::new();
    let mut texts = Vec::new();
    for block in parsed.blocks.iter().filter(|b| b.rule.name == "CSG") {
        match write_moved(block, &renamed) {
            Ok(text) => {
                log.extend(not_read(&text, block));
                texts.push(text);
            }
            Err(why) => log.push(Diagnostic::error(why.at(), why.to_string())),
        }
    }
    if parsed.blocks.iter().all(|b| b.rule.name != "CSG") {
        let message = format!("the scene has {} objects, none of them a `CSG`", scene.scene.objects.len());
        log.push(Diagnostic::error(0..0, message).expected("a `CSG`, which can be a file of its own"));
    }
    if log.is_empty() { Ok(texts) } else { Err(Diagnostics::new(name, source, log)) }
}

/// Why a text that was written would be refused when it is read: more solids, or deeper, than such a file may hold.
fn not_read(text: &str, block: &Block) -> Option<Diagnostic> {
    let back = read(text, "");
    let error = back.remarks.errors().next()?;
    let message = format!("this `CSG` cannot be a file of its own: {}", error.message);
    let d = Diagnostic::error(block.keyword.clone(), message);
    Some(Diagnostic { expected: error.expected.clone(), found: error.found.clone(), ..d })
}

/// The path of a file as seen from a folder: `../parts/a.obj`; as it is where it is absolute, or where nothing is known of
/// the current folder.
fn path_from(into: &Path, folder: &Path, named: &str) -> String {
    if Path::new(named).is_absolute() {
        return named.to_owned();
    }
    let (Some(from), Some(to)) = (resolved(into), resolved(&folder.join(named))) else {
        return named.to_owned();
    };
    let shared = from.components().zip(to.components()).take_while(|(a, b)| a == b).count();
    let up = from.components().skip(shared).map(|_| Component::ParentDir);
    let steps = up.chain(to.components().skip(shared));
    steps.map(|step| step.as_os_str().to_string_lossy().into_owned()).collect::<Vec<_>>().join("/")
}

/// The absolute path of what need not exist yet, without links as far as it does.
fn resolved(path: &Path) -> Option<PathBuf> {
    let path = std::path::absolute(path).ok()?;
    let existing = path.ancestors().find(|a| a.exists())?;
    Some(existing.canonicalize().ok()?.join(path.strip_prefix(existing).ok()?))
}

/// [`of_scene`] of a file; messages call it by its path as given.
///
/// - Errors: as there; a file that cannot be read.
pub fn of_scene_file(path: &Path, into: &Path) -> Result<Vec<String>, ReadError> {
    let text = source::text(path, source::LARGEST_FILE)?;
    of_scene(&text, &path.display().to_string(), into).map_err(ReadError::Wrong)
}

/// A block that has no place in such a file.
fn foreign(block: &Block) -> Option<Diagnostic> {
    let name = block.rule.name;
    if let Some(inner) = block.children.first() {
        let d = Diagnostic::error(
            inner.keyword.clone(),
            format!("`{}` stands inside of `{name}`", inner.rule.name),
        );
        return Some(d.expected(
            "blocks side by side, named by `LeftType`, `LeftIndex`, `RightType` and `RightIndex`",
        ));
    }
    let fits = matches!(block.rule.role, Role::Object | Role::Operation) && name != "CSG";
    let d = Diagnostic::error(block.keyword.clone(), format!("`{name}` is no part of a tree of solids"));
    (!fits).then(|| d.expected("solids, `Union`, `Difference` and `Intersection`"))
}

impl CsgFile {
    pub fn is_right(&self) -> bool {
        self.remarks.errors().next().is_none()
    }

    /// The whole as one block that holds its operands, as a scene would have it; none of a file that is wrong.
    pub fn tree(&self) -> Option<Block> {
        let root = self.links.root.filter(|_| self.is_right())?;
        Some(self.nested(root))
    }

    fn nested(&self, node: usize) -> Block {
        let children = self.links.operands[node].iter().flatten().map(|&child| self.nested(child)).collect();
        Block { children, ..self.blocks[node].clone() }
    }
}
