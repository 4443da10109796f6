//! From blocks to solids made of solids.

use super::objects::{contradiction, lacks_numbers, solid};
use super::transformation::transformation;
use super::{is_spoilt, mesh};
use crate::csg::{Csg, Tree};
use crate::mesh::ClosedMesh;
use crate::scene::Object;
use crate::scene_file::csg::{self, MOST_DEEP, operation};
use crate::scene_file::diagnostic::{Diagnostic, Diagnostics, Severity};
use crate::scene_file::format::{Role, State};
use crate::scene_file::parse::Block;
use crate::scene_file::source::ReadError;
use crate::shape::Shape;
use glam::DAffine3;
use std::collections::HashMap;
use std::path::Path;

/// A tree, and the material of each of its parts.
struct Made {
    tree: Tree,
    materials: Vec<usize>,
}

/// What holds a solid passes on to it.
#[derive(Clone, Copy)]
struct From {
    map: DAffine3,
    material: usize,
    depth: usize,
}

/// Where the blocks at hand stand.
#[derive(Clone, Copy, PartialEq)]
enum Where {
    Scene,
    File,
}

/// Builds trees, and reads the files that hold them.
pub struct Workshop<'a> {
    /// Index of each material, by name.
    pub materials: &'a HashMap<&'a str, usize>,
    /// Where files are looked for.
    pub folder: &'a Path,
    /// What was found in files.
    pub files: Vec<Diagnostics>,
}

impl Workshop<'_> {
    /// The object of a `CSG`.
    pub fn object(&mut self, block: &Block, log: &mut Vec<Diagnostic>) -> Option<Object> {
        let material = block.word("Material").and_then(|name| self.materials.get(name)).copied();
        let from = From { map: DAffine3::IDENTITY, material: material.unwrap_or(0), depth: 0 };
        let Made { tree, materials } = self.whole(block, from, log)?;
        let name = format!("CSG (line {})", block.line);
        match Csg::new(tree) {
            Ok(solid) => material.map(|_| Object::of_parts(name, Box::new(solid), materials)),
            Err(error) => {
                log.push(Diagnostic::error(block.keyword.clone(), format!("this is no CSG: {error}")));
                None
            }
        }
    }

    /// What stands in a `CSG`, or in the file that it names.
    fn whole(&mut self, block: &Block, from: From, log: &mut Vec<Diagnostic>) -> Option<Made> {
        if block.is_broken() {
            return None; // reported where it was read
        }
        let from = From { map: from.map * transformation(block), ..from };
        let wrong = |message: &str| Diagnostic::error(block.keyword.clone(), message);
        let expected = "`Source \"file.csg\"`, or one solid or operation inside it";
        match (block.entry("Source"), &block.children[..]) {
            (Some(_), []) => self.named_file(block, from, log),
            (None, [inner]) => self.part(inner, from, Where::Scene, log),
            (None, []) => {
                log.push(wrong("the `CSG` is empty").expected(expected));
                None
            }
            (Some(source), [inner, ..]) => {
                let d = wrong("the `CSG` has both a `Source` and solids inside").expected(expected);
                let (a, b) = (source.keyword.clone(), inner.keyword.clone());
                log.push(Diagnostic { span: if a.start > b.start { a } else { b }, ..d });
                None
            }
            (None, [_, second, ..]) => {
                let found = format!("{} of them", block.children.len());
                let d =
                    wrong("the `CSG` holds several solids").expected("one solid or operation").found(found);
                let d = d.help("put them into `Union { … }`, `Difference { … }` or `Intersection { … }`");
                log.push(Diagnostic { span: second.keyword.clone(), ..d });
                None
            }
        }
    }

    fn named_file(&mut self, block: &Block, from: From, log: &mut Vec<Diagnostic>) -> Option<Made> {
        let span = block.span("Source");
        if log.iter().any(|d| d.severity == Severity::Error && d.span.start == span.start) {
            return None; // a text that does not end names no file
        }
        if is_spoilt(&block.span("Source"), log) {
            return None;
        }
        let path = self.folder.join(block.word("Source")?);
        let wrong = |message: String| Diagnostic::error(block.span("Source"), message);
        let file = match csg::read_file(&path) {
            Ok(file) => file,
            Err(ReadError::Wrong(found)) => {
                self.files.push(found);
                log.push(wrong(format!("{} is no text", path.display())).expected("a `.csg` file"));
                return None;
            }
            Err(error) => {
                log.push(wrong(error.to_string()).expected("a `.csg` file beside this one"));
                return None;
            }
        };
        let mut remarks = file.remarks.clone();
        let made = file.tree().and_then(|tree| self.part(&tree, from, Where::File, &mut remarks.list));
        let remarks = Diagnostics::new(&remarks.name, &remarks.source, remarks.list);
        let errors = remarks.errors().count();
        if errors > 0 {
            let word = if errors == 1 { "1 error".to_string() } else { format!("{errors} errors") };
            log.push(wrong(format!("{} has {word}", path.display())).expected("a right `.csg` file"));
        }
        self.files.extend(Some(remarks).filter(|r| !r.is_empty()));
        made.filter(|_| errors == 0)
    }

    /// A solid or an operation with all below it.
    fn part(&mut self, block: &Block, from: From, place: Where, log: &mut Vec<Diagnostic>) -> Option<Made> {
        if block.is_broken() {
            return None;
        }
        let wrong = |message: String| Diagnostic::error(block.keyword.clone(), message);
        let name = block.rule.name;
        if from.depth > MOST_DEEP {
            let d = wrong(format!("`{name}` stands too deep"));
            log.push(d.expected(format!("at most {MOST_DEEP} operations inside one another")));
            return None;
        }
        let material = self.material(block, from.material, place, log);
        let from = From { material, depth: from.depth + 1, ..from };
        if block.rule.role != Role::Operation {
            return match name {
                "CSG" => self.whole(block, from, log),
                "Mesh" => self.mesh(block, from, log),
                _ => leaf(block, from, log),
            };
        }
        if let Some(entry) =
            block.entries.iter().find(|e| e.param.name.ends_with("Type") && place == Where::Scene)
        {
            let d =
                Diagnostic::error(entry.keyword.clone(), format!("`{}` has no place here", entry.param.name));
            log.push(d.expected(
                "the operands themselves inside the braces; names of operands are for `.csg` files",
            ));
            return None;
        }
        if block.children.len() < 2 {
            let d = wrong(format!("`{name}` holds too few solids")).expected("two or more");
            log.push(d.found(block.children.len().to_string()));
            return None;
        }
        let from = From { map: from.map * transformation(block), ..from };
        let all: Vec<Option<Made>> = block.children.iter().map(|c| self.part(c, from, place, log)).collect();
        let all: Vec<Made> = all.into_iter().collect::<Option<_>>()?; // after all of them have spoken
        let (trees, materials): (Vec<Tree>, Vec<Vec<usize>>) =
            all.into_iter().map(|m| (m.tree, m.materials)).unzip();
        Some(Made { tree: Tree::all(operation(block)?, trees)?, materials: materials.concat() })
    }

    /// A closed mesh; all its faces have the material at hand.
    fn mesh(&mut self, block: &Block, from: From, log: &mut Vec<Diagnostic>) -> Option<Made> {
        let file = mesh::read(block, self.folder, &mut self.files, log)?;
        match ClosedMesh::new(mesh::made(block, &file.polygons, from.map, log)?) {
            Ok(solid) => {
                let materials = vec![from.material; solid.parts() as usize];
                Some(Made { tree: Tree::Leaf(Box::new(solid)), materials })
            }
            Err(open) => {
                let edges = open.topology().unbalanced_edges;
                let d =
                    Diagnostic::error(block.span("Source"), "the mesh encloses nothing: it is not closed");
                log.push(d.expected("two faces at every edge").found(format!("{edges} edges without")));
                None
            }
        }
    }

    /// The material of a block's own, if it names one that the scene declares.
    fn material(&self, block: &Block, inherited: usize, place: Where, log: &mut Vec<Diagnostic>) -> usize {
        let Some(name) = block.word("Material") else { return inherited };
        let found = self.materials.get(name).copied();
        if found.is_none() && place == Where::File {
            let message = format!("the scene declares no material `{name}`: that of the `CSG` is used");
            log.push(Diagnostic::new(Severity::Warning, block.span("Material"), message));
        }
        found.unwrap_or(inherited)
    }
}

fn leaf(block: &Block, from: From, log: &mut Vec<Diagnostic>) -> Option<Made> {
    if block.rule.state == State::Planned || lacks_numbers(block) {
        return None; // reported
    }
    if let Some(d) = contradiction(block) {
        log.push(d);
        return None;
    }
    let (name, wrong) = (block.rule.name, |message| Diagnostic::error(block.keyword.clone(), message));
    match solid(block, from.map * transformation(block)) {
        None => {
            let d = wrong(format!("`{name}` encloses nothing")).expected("a solid");
            log.push(d.help("a surface without an inside cannot be united, intersected or taken away"));
            None
        }
        Some(Err(error)) => {
            log.push(wrong(format!("this is no {name}: {error}")));
            None
        }
        Some(Ok(solid)) => {
            let materials = vec![from.material; solid.parts() as usize];
            Some(Made { tree: Tree::Leaf(solid), materials })
        }
    }
}
