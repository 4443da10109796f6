//! From a block and the OBJ file it names to a mesh.

use super::is_spoilt;
use super::transformation::transformation;
use crate::color::Rgb;
use crate::mesh::{Mesh, Polygons};
use crate::scene::{Material, Object};
use crate::scene_file::diagnostic::{Diagnostic, Diagnostics};
use crate::scene_file::obj::{self, MtlMaterial, ObjFile};
use crate::scene_file::parse::Block;
use crate::scene_file::source::ReadError;
use glam::DAffine3;
use std::collections::HashMap;
use std::path::Path;

/// Builds meshes, and reads the files that hold them.
pub struct Meshes<'a> {
    /// Index of each material of the scene, by name.
    pub materials: &'a HashMap<&'a str, usize>,
    /// Where files are looked for.
    pub folder: &'a Path,
    /// Materials of libraries; the first has the index `first`.
    pub found: Vec<Material>,
    pub first: usize,
    /// What was found in files.
    pub files: Vec<Diagnostics>,
}

impl Meshes<'_> {
    /// The object of a `Mesh`. A material that the block names is that of every face; else those of the file's own libraries.
    pub fn object(&mut self, block: &Block, log: &mut Vec<Diagnostic>) -> Option<Object> {
        let file = read(block, self.folder, &mut self.files, log)?;
        let mesh = made(block, &file.polygons, DAffine3::IDENTITY, log)?;
        let name = format!("Mesh (line {})", block.line);
        if block.entry("Material").is_some() {
            // A name without a material is reported where it stands.
            let &material = self.materials.get(block.word("Material")?)?;
            return Some(Object::new(name, Box::new(mesh), material));
        }
        if file.needs_material() {
            let d = Diagnostic::error(block.keyword.clone(), "the `Mesh` has faces without a material");
            let d =
                d.expected("`Material` and a name, or a material of the file's own libraries for every face");
            log.push(d.help("a material that is named here is that of all faces"));
            return None;
        }
        let offset = self.first + self.found.len();
        self.found.extend(file.materials.iter().map(material));
        // Part 0 has no face.
        let parts = std::iter::once(offset).chain(offset..offset + file.materials.len()).collect();
        Some(Object::of_parts(name, Box::new(mesh), parts))
    }
}

/// The polygons of the file that a block names; what is wrong with the file goes to the files.
pub fn read(
    block: &Block,
    folder: &Path,
    files: &mut Vec<Diagnostics>,
    log: &mut Vec<Diagnostic>,
) -> Option<ObjFile> {
    if block.is_broken() || is_spoilt(&block.span("Source"), log) {
        return None; // reported where it was read
    }
    let path = folder.join(block.word("Source")?);
    let wrong = |message: String| Diagnostic::error(block.span("Source"), message);
    let file = match obj::read_file(&path) {
        Ok(file) => file,
        Err(ReadError::Wrong(found)) => {
            files.push(found);
            log.push(wrong(format!("{} is no text", path.display())).expected("an OBJ file"));
            return None;
        }
        Err(error) => {
            log.push(wrong(error.to_string()).expected("an OBJ file beside this one"));
            return None;
        }
    };
    let errors = file.errors();
    // A file that is named twice is remarked upon once.
    let is_new = files.iter().all(|f| f.name != file.remarks.name);
    files.extend(Some(file.remarks.clone()).filter(|r| is_new && !r.is_empty()));
    if errors > 0 {
        let word = if errors == 1 { "1 error".to_string() } else { format!("{errors} errors") };
        log.push(wrong(format!("{} has {word}", path.display())).expected("a right OBJ file"));
        return None;
    }
    Some(file)
}

/// The mesh of a block's polygons: shaded and transformed as the block says, then moved by `from`.
pub fn made(block: &Block, polygons: &Polygons, from: DAffine3, log: &mut Vec<Diagnostic>) -> Option<Mesh> {
    let [crease] = block.numbers("Crease").map(f64::to_radians);
    let shaded = match block.word("Normals") {
        Some("flat") => polygons.clone().facetted(),
        // Points that are equal are one, or nothing is smooth about them.
        Some("smooth") => polygons.welded().facetted().with_smooth_normals(crease),
        _ => polygons.welded().with_smooth_normals(crease),
    };
    match Mesh::new(&shaded.transformed(&(from * transformation(block)))) {
        Ok(mesh) => {
            if mesh.repairs().inside_out {
                let d = Diagnostic::note(
                    block.span("Source"),
                    "the mesh is inside out: its faces show their backs",
                );
                log.push(d.help("they are turned round"));
            }
            Some(mesh)
        }
        Err(error) => {
            log.push(Diagnostic::error(block.keyword.clone(), format!("this is no Mesh: {error}")));
            None
        }
    }
}

/// A library's material; what it leaves open is as of a scene's material, but for colours, which are black.
///
/// Phong's exponent becomes the roughness of the microfacet slope distribution that is as wide, `√(2 / (n + 2))`.
///
/// - Source: Walter et al., *Microfacet Models for Refraction through Rough Surfaces*, EGSR (2007) §5.2.
fn material(m: &MtlMaterial) -> Material {
    let default = Material::default();
    Material {
        name: m.name.clone(),
        diffuse: m.diffuse.unwrap_or(default.diffuse),
        specular: m.specular.unwrap_or(Rgb::ZERO),
        emissive: m.emissive.unwrap_or(Rgb::ZERO),
        roughness: m.shininess.map_or(default.roughness, |n| (2.0 / (n + 2.0)).sqrt()),
        opacity: m.opacity.unwrap_or(default.opacity),
        ior: m.ior.filter(|n| *n > 0.0).unwrap_or(default.ior),
        ..default
    }
}
