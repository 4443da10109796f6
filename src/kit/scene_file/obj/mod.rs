//! OBJ files: polygons with texture coordinates, normals and materials [D §4.9, Annex B].
//!
//! A file is read twice. The first reading checks every line, reports what is wrong where it stands, and writes down what is
//! meant in the plainest words: absolute indices, joined lines, polygons only. The second, by the library `tobj`, which
//! knows neither places nor mercy, makes lists of that.
//!
//! Faces have any number of corners. Texture coordinates and normals may be missing, for all faces or for some. Lines, points
//! and free-form surfaces are left out with a warning.

mod check;
mod line;
mod mtl;
mod write;

pub use mtl::MtlMaterial;
pub use write::write;

use super::diagnostic::{Diagnostic, Diagnostics, Severity, Span};
use super::source::{self, ReadError};
use crate::frame::unit;
use crate::mesh::{Corner, MOST_CONCAVE, NONE, Outline, Polygons, triangulate};
use crate::shape::triangle::Triangle;
use check::Checked;
use glam::{DVec2, DVec3};
use std::path::Path;

/// Largest OBJ or MTL file that is read \[bytes\].
pub const LARGEST_MESH: u64 = 256 << 20;

/// Most findings that are kept of one file.
const MOST_FINDINGS: usize = 64;

/// What a file holds. If its remarks hold an error, the polygons are empty.
#[derive(Clone, Debug)]
pub struct ObjFile {
    /// Part 0 is what has no material of the file's own; part `i + 1` is made of `materials[i]`.
    pub polygons: Polygons,
    pub materials: Vec<MtlMaterial>,
    /// Everything that was found, in the file and in its material libraries.
    pub remarks: Diagnostics,
}

impl ObjFile {
    /// Does a face have no material of the file's own?
    pub fn needs_material(&self) -> bool {
        self.polygons.parts.contains(&0)
    }

    /// Number of errors, in the file and its libraries.
    pub fn errors(&self) -> usize {
        self.remarks.errors().count() + self.remarks.files.iter().map(|f| f.errors().count()).sum::<usize>()
    }
}

/// Reads polygons from a file; messages call it by its path as given.
///
/// - Errors: a file that cannot be read at all; one that is wrong comes with its remarks.
pub fn read_file(path: &Path) -> Result<ObjFile, ReadError> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let (text, foreign) = source::text_or_latin1(path, LARGEST_MESH)?;
    let mut file = read(&text, &path.display().to_string(), &|library| {
        let path = folder.join(library);
        let text = || source::text_or_latin1(&path, LARGEST_MESH);
        path.is_file().then(|| text().map(|(text, _)| (path.display().to_string(), text)))
    });
    file.remarks.list.extend(latin1(&text, &foreign));
    Ok(file)
}

/// A note about the first character that is no UTF-8 and stands outside comments.
fn latin1(text: &str, foreign: &[Span]) -> Option<Diagnostic> {
    let first = foreign.first()?.start;
    let holds = |word: &Span| {
        let next = foreign.partition_point(|f| f.start < word.start);
        foreign.get(next).is_some_and(|f| f.start < word.end)
    };
    let mut words = line::lines(text).flat_map(|line| {
        let words = line.words.iter().map(line::Word::span);
        std::iter::once(line.keyword.span()).chain(words).collect::<Vec<_>>()
    });
    let word = words.find(|word| word.end > first && holds(word))?;
    let message = "bytes that are not UTF-8 text are read as Latin-1, first in this word";
    Some(Diagnostic::note(word, message).help("save the file as UTF-8"))
}

/// A material library by the name that a file gives it: its path and text, why it cannot be read, or nothing if there is none.
pub type Library = Option<Result<(String, String), ReadError>>;

/// Reads polygons from a text; `name` is what messages call it, `library` finds material libraries.
pub fn read(text: &str, name: &str, library: &dyn Fn(&str) -> Library) -> ObjFile {
    let mut checked = check::check(text, library);
    let polygons = match checked.is_right() {
        true => polygons(&mut checked),
        false => Polygons::of_points(Vec::new()),
    };
    if checked.is_right() {
        inspect(&polygons, &checked.faces, &mut checked.log);
    }
    checked.log.truncate(MOST_FINDINGS);
    let wrong = checked.log.iter().any(|d| d.severity == Severity::Error);
    let remarks = Diagnostics::new(name, text, checked.log).with_files(checked.files);
    match wrong {
        true => ObjFile { polygons: Polygons::of_points(Vec::new()), materials: Vec::new(), remarks },
        false => ObjFile { polygons, materials: checked.materials, remarks },
    }
}

/// The lists that `tobj` makes of a checked text.
fn polygons(checked: &mut Checked) -> Polygons {
    let options = tobj::LoadOptions::default();
    let name = |m: &MtlMaterial| tobj::Material { name: m.name.clone(), ..Default::default() };
    let materials = |_: &Path| {
        // Of equal names the first counts: it is put in last.
        let index = checked.materials.iter().enumerate().rev().map(|(i, m)| (m.name.clone(), i));
        Ok((checked.materials.iter().map(name).collect(), index.collect()))
    };
    let loaded = tobj::load_obj_buf(&mut checked.plain.as_bytes(), &options, materials);
    let models = match loaded {
        Ok((models, _)) => models,
        Err(error) => {
            // What was checked is right for tobj too; should a version of it differ, its word is final.
            checked.log.push(Diagnostic::error(0..0, format!("tobj refuses the file: {error}")));
            Vec::new()
        }
    };
    let mut out = Polygons::of_points(Vec::new());
    let mut faces = checked.faces.iter();
    for model in &models {
        append(&mut out, &model.mesh, &mut faces);
    }
    out
}

/// A face of the text.
#[derive(Clone, Debug, PartialEq)]
struct Face {
    span: Span,
    /// Do its corners have texture coordinates, and normals?
    uvs: bool,
    normals: bool,
}

/// Appends the faces of one of `tobj`'s meshes. Where a corner has no index, `tobj` makes one up: `faces` know better.
fn append<'a>(out: &mut Polygons, mesh: &tobj::Mesh, faces: &mut impl Iterator<Item = &'a Face>) {
    let triples =
        |list: &[f64]| list.chunks_exact(3).map(|c| DVec3::new(c[0], c[1], c[2])).collect::<Vec<_>>();
    let first = [out.points.len(), out.uvs.values.len(), out.normals.values.len()].map(|n| n as u32);
    out.points.extend(triples(&mesh.positions));
    out.uvs.values.extend(mesh.texcoords.chunks_exact(2).map(|c| DVec2::new(c[0], c[1])));
    let normals: Vec<Option<DVec3>> = triples(&mesh.normals).into_iter().map(unit).collect();
    out.normals.values.extend(normals.iter().map(|n| n.unwrap_or(DVec3::Z)));
    let part = mesh.material_id.map_or(0, |id| id as u32 + 1);
    let threes = vec![3; if mesh.face_arities.is_empty() { mesh.indices.len() / 3 } else { 0 }];
    let mut at = 0;
    let mut corners = Vec::new();
    for (&count, face) in mesh.face_arities.iter().chain(&threes).zip(faces) {
        corners.clear();
        for c in at..at + count as usize {
            let uv = mesh.texcoord_indices.get(c).filter(|_| face.uvs).map_or(NONE, |i| i + first[1]);
            let normal =
                mesh.normal_indices.get(c).filter(|i| face.normals && normals[**i as usize].is_some());
            let normal = normal.map_or(NONE, |i| i + first[2]);
            corners.push(Corner { point: mesh.indices[c] + first[0], uv, normal });
        }
        at += count as usize;
        out.push(&corners, part);
    }
}

/// Remarks about the shapes of faces, each kind once, at the first such face.
fn inspect(polygons: &Polygons, faces: &[Face], log: &mut Vec<Diagnostic>) {
    let (mut flat, mut crossed, mut bent): (Vec<usize>, Vec<usize>, Vec<usize>) = Default::default();
    let mut triangles = Vec::new();
    for (f, face) in faces.iter().enumerate().take(polygons.len()) {
        let outline: Vec<DVec3> = polygons.outline(f).collect();
        triangles.clear();
        match triangulate(&outline, &mut triangles) {
            Outline::TooLong => {
                let d =
                    Diagnostic::error(face.span.clone(), "a face that is not convex has too many corners");
                let expected = format!("at most {MOST_CONCAVE} corners");
                log.push(d.expected(expected).found(outline.len().to_string()));
            }
            Outline::Crossed => crossed.push(f),
            Outline::Simple => {
                let at = |t: &[u32; 3]| t.map(|k| outline[k as usize]);
                let has_area = |t: &[u32; 3]| {
                    let [a, b, c] = at(t);
                    Triangle::new(a, b, c).is_ok()
                };
                match triangles.iter().any(has_area) {
                    false => flat.push(f),
                    true if is_bent(polygons, f) => bent.push(f),
                    true => {}
                }
            }
        }
    }
    let mut note = |list: &[usize], one: &str, many: &str, help: &str| {
        if let Some(&first) = list.first() {
            let message = if list.len() == 1 { one.to_string() } else { format!("{} {many}", list.len()) };
            log.push(Diagnostic::note(faces[first].span.clone(), message).help(help));
        }
    };
    note(&flat, "a face has no area", "faces have no area, the first of them here", "they are left out");
    let help = "they are cut into triangles as far as that goes";
    note(
        &crossed,
        "the outline of a face crosses itself",
        "outlines of faces cross themselves, first here",
        help,
    );
    let help = "they are cut into triangles as they look along the axis nearest to their normal";
    note(&bent, "a face is not flat", "faces are not flat, the first of them here", help);
}

/// How far corners may lie off their plane, per size of a face, before it is worth a word. Tuned: quadrilaterals of coarse
/// curved surfaces bend by a few hundredths; a corner of a square that is bent by a right angle lies half its size off.
const FLATNESS: f64 = 0.1;

fn is_bent(polygons: &Polygons, face: usize) -> bool {
    let outline: Vec<DVec3> = polygons.outline(face).collect();
    let Some(n) = unit(polygons.area_vector(face)).filter(|_| outline.len() > 3) else { return false };
    let size = outline.iter().map(|p| (*p - outline[0]).length()).fold(0.0, f64::max);
    outline.iter().any(|p| (*p - outline[0]).dot(n).abs() > FLATNESS * size)
}
