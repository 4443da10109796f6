//! Rendered meshes.

use glam::{DAffine3, DVec2, DVec3, dvec3};
use lightbench::film::Image;
use lightbench::integrator::Local;
use lightbench::light::{AreaLight, Emission, Light};
use lightbench::mesh::{Mesh, Polygons, tessellate};
use lightbench::render::{Picture, render};
use lightbench::sample::Pattern;
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::Shape;
use lightbench::shape::cylinder::Cylinder;
use lightbench::shape::plane::Plane;
use lightbench_kit::figure::{Figure, Panels, Pixels, grouped};
use lightbench_kit::lesson::{Lesson, LessonError, Result};

fn wrong(e: impl std::fmt::Display) -> LessonError {
    LessonError(e.to_string())
}

const PAPER: DVec3 = dvec3(0.80, 0.85, 0.91);

/// An object on the floor at y = 0, under a soft light from the left.
fn scene(shape: Box<dyn Shape>, color: DVec3, target: DVec3, eye: DVec3, height: f64) -> Result<Scene> {
    let field = FieldOfView::Vertical(2.0 * (0.5 * height / eye.distance(target)).atan());
    let mut scene = Scene::new(Camera::new(eye, target, DVec3::Y, field).map_err(wrong)?);
    let paint = |name: &str, diffuse: DVec3| Material {
        name: name.to_string(),
        diffuse,
        specular: DVec3::ZERO,
        ..Default::default()
    };
    scene.materials = vec![paint("floor", dvec3(0.74, 0.72, 0.69)), paint("thing", color)];
    let floor = Plane::new(DVec3::ZERO, DVec3::Y).map_err(wrong)?;
    scene.objects.push(Object::new("floor", Box::new(floor), 0));
    scene.objects.push(Object::new("thing", shape, 1));
    let place = target + (eye - target).length() * dvec3(-0.75, 1.1, 0.45);
    let lamp = AreaLight::rectangle(
        place,
        target - place,
        0.0,
        DVec2::splat(0.5 * height),
        Emission::even(DVec3::splat(0.95)),
    );
    scene.lights.push(Light::Area(lamp.map_err(wrong)?.subdivided(3, 3, Pattern::Jittered)));
    scene.background = PAPER;
    scene.ambient = DVec3::splat(0.22);
    Ok(scene)
}

fn picture(lesson: &Lesson, scene: &Scene, aspect: f64) -> Image {
    let (width, samples) = lesson.pick([(32, 1), (320, 4), (480, 16), (800, 16)]);
    let height = (width as f64 * aspect) as usize;
    render(scene, &Local::default(), Picture { width, height, samples, seed: lesson.seed() }).image
}

/// [A ill. 3].
pub fn cylinders(lesson: &Lesson) -> Result {
    let standing = DAffine3::from_scale(dvec3(1.0, 2.4, 1.0));
    let show = |shape: Box<dyn Shape>| -> Result<Pixels> {
        let blue = dvec3(0.10, 0.36, 0.62);
        let scene = scene(shape, blue, dvec3(0.0, 1.12, 0.0), dvec3(1.4, 4.2, 7.0), 3.9)?;
        Ok(Pixels::from(&picture(lesson, &scene, 1.15)))
    };
    let mut panels = Panels::new()
        .columns(4)
        .title("Polygons come near a cylinder; the formula is the cylinder")
        .subtitle("polygons with one normal each; soft light from the left");
    for sides in [6, 12, 48] {
        let polygons = tessellate::cylinder(sides);
        let mesh = Mesh::new(&polygons.facetted().transformed(&standing)).map_err(wrong)?;
        let label = format!("{} polygons, {} triangles", sides + 2, mesh.len());
        panels = panels.picture(show(Box::new(mesh))?, &label);
    }
    let true_one = Cylinder::new(DVec3::ZERO, DVec3::Y * 2.4, 1.0).map_err(wrong)?;
    panels = panels.picture(show(Box::new(true_one))?, "the formula: 7 numbers");
    let alt = "Four pictures of a standing cylinder: of 6 sides, of 12, of 48 that are hardly told from round, and round.";
    let figure = Figure::from(panels.alt(alt)).caption(
        "A cylinder as polygons (after A, illustration 3): n rectangles around and two polygons of n corners, each face shaded by its own normal.",
    );
    lesson.save("cylinder_polygons", figure)
}

/// The same knot, coarse and flat, coarse and smooth, fine.
pub fn knot(lesson: &Lesson) -> Result {
    let place = DAffine3::from_translation(dvec3(0.0, 3.55, 0.0)) * DAffine3::from_rotation_y(0.5);
    let show = |polygons: Polygons| -> Result<(usize, Pixels)> {
        let mesh = Mesh::new(&polygons.transformed(&place)).map_err(wrong)?;
        let n = mesh.len();
        let coral = dvec3(0.80, 0.30, 0.14);
        let scene = scene(Box::new(mesh), coral, dvec3(0.0, 3.2, 0.0), dvec3(2.0, 6.5, 15.0), 8.6)?;
        Ok((n, Pixels::from(&picture(lesson, &scene, 1.0))))
    };
    let coarse = || tessellate::bumpy_knot(240, 12);
    let fine = lesson.pick([240, 1000, 1000, 1000]);
    let all = [
        ("flat", coarse()),
        ("smooth normals", coarse().with_smooth_normals(1.2)),
        ("smooth normals", tessellate::bumpy_knot(fine, 35).with_smooth_normals(1.2)),
    ];
    let mut panels = Panels::new()
        .columns(3)
        .title("Smooth normals hide the facets, but not the outline")
        .subtitle("a bumpy tube along a trefoil knot; shadow rays start above the facets (Hanika 2021)");
    for (word, polygons) in all {
        let (n, pixels) = show(polygons)?;
        panels = panels.picture(pixels, &format!("{} triangles, {word}", grouped(n as u64)));
    }
    let alt = "Three pictures of a knotted, bumpy, coral tube standing on a pale floor: of flat facets, of the same facets shaded smoothly, and of many more.";
    let figure = Figure::from(panels.alt(alt))
        .caption("One surface in three meshes. Interpolated normals make facets look round (A §2.1: the normal of a polygon may be interpolated between those of its vertices); bumps that no vertex has stay lost.");
    lesson.save("knot", figure)
}
