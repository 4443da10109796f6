//! From blocks to objects.

use super::csg::Workshop;
use super::mesh::Meshes;
use super::transformation::{Made, MadeSolid, Put, cube, ellipsoid, instance, placed, transformation};
use super::{later, natural, of, point};
use crate::bounds::Aabb;
use crate::frame::basis;
use crate::scene::{Material, Object};
use crate::scene_file::diagnostic::{Diagnostic, Diagnostics};
use crate::scene_file::format::{Default, Kind, Param, Role, State};
use crate::scene_file::parse::Block;
use crate::sdf::Menger;
use crate::sdf::julia::{Julia, LARGEST_C};
use crate::shape::cone::Cone;
use crate::shape::cylinder::Cylinder;
use crate::shape::disc::Disc;
use crate::shape::plane::Plane;
use crate::shape::quadric::{ClippedQuadric, Coefficients, Quadric};
use crate::shape::torus::Torus;
use crate::shape::triangle::Triangle;
use crate::shape::{ShapeError, Sides};
use glam::{DAffine3, DMat3, DVec3, DVec4};
use std::collections::HashMap;
use std::path::Path;

/// The objects of a file, and materials that belong to them alone, to stand behind those of the file; what is wrong with them is
/// added to the log, and what is to be said about files of `folder`, to the files.
pub fn objects(
    blocks: &[Block],
    folder: &Path,
    materials: &[(&Block, Material)],
    log: &mut Vec<Diagnostic>,
    files: &mut Vec<Diagnostics>,
) -> (Vec<Object>, Vec<Material>) {
    let index: HashMap<&str, usize> =
        materials.iter().enumerate().rev().map(|(i, (_, m))| (m.name.as_str(), i)).collect();
    let mut workshop = Workshop { materials: &index, folder, files: Vec::new() };
    let first = materials.len();
    let mut meshes = Meshes { materials: &index, folder, found: Vec::new(), first, files: Vec::new() };
    let mut objects = Vec::new();
    for block in of(blocks, |r| r == Role::Object) {
        match block.rule.name {
            "CSG" => objects.extend(workshop.object(block, log)),
            "Mesh" => objects.extend(meshes.object(block, log)),
            _ => objects.extend(object(block, &index, log)),
        }
    }
    files.append(&mut workshop.files);
    files.append(&mut meshes.files);
    (objects, meshes.found)
}

/// The object of a block that describes one shape.
fn object(block: &Block, materials: &HashMap<&str, usize>, log: &mut Vec<Diagnostic>) -> Option<Object> {
    if block.is_broken() || block.rule.state == State::Planned || lacks_numbers(block) {
        return None; // reported where it was read
    }
    if let Some(d) = contradiction(block) {
        log.push(d);
        return None;
    }
    match shape(block) {
        Ok(shape) => {
            // A name without a material is reported where it stands.
            let &material = materials.get(block.word("Material")?)?;
            Some(Object::new(format!("{} (line {})", block.rule.name, block.line), shape, material))
        }
        Err(error) => {
            let message = format!("this is no {}: {error}", block.rule.name);
            log.push(Diagnostic::error(block.keyword.clone(), message));
            None
        }
    }
}

/// Is there a required parameter that is not written? (A shape can be checked without its material.)
pub fn lacks_numbers(block: &Block) -> bool {
    let required = |p: &&Param| p.default == Default::Required && matches!(p.kind, Kind::Numbers { .. });
    block.rule.params.iter().filter(required).any(|p| block.entry(p.name).is_none())
}

fn vector(block: &Block, name: &str) -> DVec3 {
    DVec3::from(block.numbers(name))
}

fn scalar(block: &Block, name: &str) -> f64 {
    block.numbers::<1>(name)[0]
}

/// Two parameters that are right alone and wrong together.
pub fn contradiction(block: &Block) -> Option<Diagnostic> {
    let at = |a, b| block.span(later(block, a, b));
    match block.rule.name {
        "Cone" if scalar(block, "Radius") == 0.0 && scalar(block, "TopRadius") == 0.0 => {
            let d = Diagnostic::error(at("Radius", "TopRadius"), "both radii of the `Cone` are 0");
            Some(d.expected("one of them above 0"))
        }
        "Torus" => {
            let (major, minor) = (scalar(block, "Major"), scalar(block, "Minor"));
            let message = "the `Torus` has no hole";
            let d = Diagnostic::error(at("Major", "Minor"), message).expected("`Major` above `Minor`");
            (major <= minor).then(|| d.found(format!("Major {major} and Minor {minor}")))
        }
        "Julia" => {
            let length = DVec4::from(block.numbers("C")).length();
            let d = Diagnostic::error(block.span("C"), "the `C` of the `Julia` is too long");
            let d = d.expected(format!("a length of at most {LARGEST_C}"));
            (!(length <= LARGEST_C)).then(|| d.found(length.to_string()))
        }
        "Quadric" => {
            let clip = clip_box(block);
            let d = Diagnostic::error(at("ClipMin", "ClipMax"), "the clip box is empty");
            let d = d.expected("`ClipMin` below `ClipMax` along each axis");
            let found = format!("{} and {}", point(clip.min), point(clip.max));
            (!clip.min.cmplt(clip.max).all()).then(|| d.found(found))
        }
        _ => None,
    }
}

/// The shape of an object's block.
fn shape(block: &Block) -> Made {
    let map = transformation(block);
    if let Some(solid) = solid(block, map).filter(|_| block.rule.name != "Plane") {
        return Ok(solid?);
    }
    match block.rule.name {
        "Plane" => Ok(plane(block, map)?.shape()),
        "Disc" => Ok(placed(map, |by| {
            let disc =
                Disc::new(vector(block, "Center") + by, vector(block, "Normal"), scalar(block, "Radius"))?;
            Ok(disc.with_sides(sides(block)))
        })?
        .shape()),
        "Triangle" => Ok(placed(map, |by| {
            let [v0, v1, v2] = ["V0", "V1", "V2"].map(|name| vector(block, name) + by);
            Ok(Triangle::new(v0, v1, v2)?.with_sides(sides(block)))
        })?
        .shape()),
        "Quadric" => {
            Ok(instance(ClippedQuadric { quadric: quadric(block)?, clip: clip_box(block) }, map)?.shape())
        }
        other => unreachable!("the table of blocks promises a builder of {other}"),
    }
}

/// The solid of an object's block under a map; none, if it encloses nothing.
pub fn solid(block: &Block, map: DAffine3) -> Option<MadeSolid> {
    let (vector, scalar) = (|name| vector(block, name), |name| scalar(block, name));
    let made = match block.rule.name {
        "Sphere" => ellipsoid(vector("Center"), DVec3::splat(scalar("Radius")), map),
        "Ellipsoid" => ellipsoid(vector("Center"), vector("SemiAxes"), map),
        "Box" => cube(map),
        "Cylinder" => placed(map, |by| {
            Cylinder::upon(vector("Base") + by, vector("Axis"), scalar("Height"), scalar("Radius"))
        })
        .map(Put::solid),
        "Cone" => placed(map, |by| {
            let base = vector("Base") + by;
            let axis = ShapeError::direction("axis of a cone", vector("Axis"))?;
            Cone::new(base, base + axis * scalar("Height"), scalar("Radius"), scalar("TopRadius"))
        })
        .map(Put::solid),
        "Torus" => torus(block, map),
        "Plane" => plane(block, map).map(Put::solid),
        "Quadric" if clip_box(block) == Aabb::EVERYTHING => {
            quadric(block).and_then(|quadric| instance(quadric, map)).map(Put::solid)
        }
        "Julia" => julia(block, map),
        "Menger" => {
            let [depth] = block.integers("Depth").map(natural);
            placed(map, |by| Menger::new(vector("Center") + by, scalar("Edge"), depth)).map(Put::solid)
        }
        _ => return None,
    };
    Some(made)
}

fn plane(block: &Block, map: DAffine3) -> Result<Put<Plane>, ShapeError> {
    let plane = |by| Plane::new(vector(block, "Point") + by, vector(block, "Normal"));
    placed(map, |by| Ok(plane(by)?.with_sides(sides(block))))
}

fn sides(block: &Block) -> Sides {
    match block.word("Sides") {
        Some("front") => Sides::Front,
        _ => Sides::Both,
    }
}

/// A torus is made about +z at the origin; an instance brings it to its axis and centre.
fn torus(block: &Block, map: DAffine3) -> MadeSolid {
    let axis = ShapeError::direction("axis of a torus", vector(block, "Axis"))?;
    let (x, y) = basis(axis);
    let stand = DAffine3::from_mat3_translation(DMat3::from_cols(x, y, axis), vector(block, "Center"));
    let torus = Torus::new(scalar(block, "Major"), scalar(block, "Minor"))?;
    Ok(instance(torus, map * stand)?.solid())
}

/// A Julia set is made about the origin with unit 1; an instance brings it to its centre and size.
fn julia(block: &Block, map: DAffine3) -> MadeSolid {
    let [iterations] = block.integers("Iterations").map(|n| u32::try_from(n).unwrap_or(0));
    let c = DVec4::from(block.numbers("C"));
    let mut julia = Julia::new(c, iterations, scalar(block, "Bailout"), scalar(block, "W"))?;
    if block.entry("NormalIterations").is_some() {
        let [steps] = block.integers("NormalIterations").map(|n| u32::try_from(n).unwrap_or(0));
        julia = julia.with_normals_after(steps);
    }
    let unit = DAffine3::from_scale(DVec3::splat(scalar(block, "Unit")));
    Ok(instance(julia, map * DAffine3::from_translation(vector(block, "Center")) * unit)?.solid())
}

/// The box of `ClipMin` and `ClipMax`; where one is not written, endless that way.
fn clip_box(block: &Block) -> Aabb {
    let corner = |name, none| if block.entry(name).is_some() { vector(block, name) } else { none };
    Aabb::new(corner("ClipMin", DVec3::NEG_INFINITY), corner("ClipMax", DVec3::INFINITY))
}

fn quadric(block: &Block) -> Result<Quadric, ShapeError> {
    let [a, b, c, d, e] = ["A", "B", "C", "D", "E"].map(|name| scalar(block, name));
    let [f, g, h, i, j] = ["F", "G", "H", "I", "J"].map(|name| scalar(block, name));
    Quadric::new(Coefficients { a, b, c, d, e, f, g, h, i, j })
}
