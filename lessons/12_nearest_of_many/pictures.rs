//! A mesh like that of D's scene 2, and what its pixels cost in an octree and in a hierarchy.

use super::contest::{Face, boxes};
use super::threshold::faces;
use glam::{DAffine3, DQuat, DVec2, DVec3, dvec2, dvec3};
use lightbench::accel::{Facets, Octree, Splitting};
use lightbench::integrator::Local;
use lightbench::light::{AreaLight, Emission, Light};
use lightbench::mesh::{Mesh, tessellate::bumpy_knot};
use lightbench::ray::{Ray, Tally};
use lightbench::render::{Picture, render};
use lightbench::sample::Pattern;
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::Shape;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::instance::Instance;
use lightbench::shape::triangle::PreparedRay;
use lightbench_kit::figure::colormap::viridis;
use lightbench_kit::figure::{Figure, Panels, Pixels};
use lightbench_kit::lesson::{Lesson, Result};
use std::sync::Arc;

/// The knot in D's box of five walls, open towards the camera.
fn scene(size: (u32, u32)) -> Option<Scene> {
    let camera =
        Camera::new(dvec3(0.0, 0.0, 11.0), DVec3::ZERO, DVec3::Y, FieldOfView::Vertical(0.7)).ok()?;
    let mut scene = Scene::new(camera);
    let matt = |r: f64, g: f64, b: f64| Material { diffuse: dvec3(r, g, b), ..Material::default() };
    scene.materials =
        vec![matt(0.82, 0.8, 0.76), matt(0.72, 0.2, 0.16), matt(0.2, 0.52, 0.26), matt(0.86, 0.62, 0.3)];
    let walls = [
        (dvec3(-4.1, -3.6, -4.0), dvec3(4.1, -3.5, 4.0), 0),
        (dvec3(-4.1, 3.5, -4.0), dvec3(4.1, 3.6, 4.0), 0),
        (dvec3(-4.1, -3.6, -4.1), dvec3(4.1, 3.6, -4.0), 0),
        (dvec3(-4.2, -3.6, -4.0), dvec3(-4.1, 3.6, 4.0), 1),
        (dvec3(4.1, -3.6, -4.0), dvec3(4.2, 3.6, 4.0), 2),
    ];
    for (low, high, material) in walls {
        scene.objects.push(Object::new("wall", Box::new(Cuboid::new(low, high).ok()?), material));
    }
    let mesh = Arc::new(Mesh::new(&bumpy_knot(size.0, size.1)).ok()?);
    // Two levels: one mesh, three times in the scene.
    for (at, scale) in
        [(dvec3(0.0, -0.2, -0.6), 0.78), (dvec3(-2.7, -2.75, 1.6), 0.2), (dvec3(2.7, -2.75, 1.6), 0.2)]
    {
        let turn = DQuat::from_rotation_y(0.35) * DQuat::from_rotation_x(-0.5);
        let map = DAffine3::from_scale_rotation_translation(DVec3::splat(scale), turn, at);
        let shape: Box<dyn Shape> = Box::new(Instance::new(Box::new(mesh.clone()), map).ok()?);
        scene.objects.push(Object::new("knot", shape, 3));
    }
    let lamp = AreaLight::rectangle(
        dvec3(0.0, 3.45, 0.5),
        DVec3::NEG_Y,
        0.0,
        dvec2(2.4, 2.4),
        Emission::even(DVec3::splat(0.9)),
    )
    .ok()?;
    scene.lights = vec![Light::Area(lamp.subdivided(4, 4, Pattern::Jittered))];
    scene.ambient = DVec3::splat(0.26);
    Some(scene)
}

/// Looks of one camera ray.
fn looks(find: impl Fn(&Ray, &mut Tally), ray: &Ray) -> f64 {
    let mut tally = Tally::default();
    find(ray, &mut tally);
    (tally.node_visits + tally.shape_tests) as f64
}

/// Colours by decades, from one look to 10⁴.
fn heat(values: &[f64], side: usize) -> Pixels {
    let rgb = values.iter().flat_map(|v| viridis((v.max(1.0).log10() / 4.0).min(1.0))).collect();
    Pixels::new(side, side, rgb)
}

pub fn save(lesson: &Lesson) -> Result {
    let size = lesson.pick([(100, 10), (1000, 35), (1000, 35), (1000, 35)]);
    let (width, samples) = lesson.pick([(32, 1), (480, 4), (720, 9), (960, 16)]);
    if let Some(scene) = scene(size) {
        let picture = Picture { width, height: width * 7 / 8, samples, seed: lesson.seed() };
        let image = render(&scene, &Local::default(), picture).image;
        lesson.save_picture(
            "knots",
            &image,
            "One mesh of 70 000 triangles, three times in the scene: a hierarchy over instances of a hierarchy (after D, figure 43)",
            "A bumpy golden knot floats in a box with a red and a green wall, two small copies of it stand in the corners.",
        )?;
    }
    let side = lesson.pick([24, 320, 400, 640]);
    lesson.save("looks", maps(&faces(size), side))
}

/// What each pixel of a picture of the knot looks at.
fn maps(mesh: &[Face], side: usize) -> Figure {
    let (facets, octree) =
        (Facets::build(mesh.len(), |i| mesh[i as usize]), Octree::build(&boxes(mesh), Splitting::D));
    let eye = dvec3(0.0, 0.0, 12.0);
    let ray = |k: usize| {
        let at = (DVec2::new((k % side) as f64, (k / side) as f64) + 0.5) / side as f64 - 0.5;
        Ray::new(eye, (dvec3(at.x * 7.6, -at.y * 7.6, 0.0) - eye).normalize())
    };
    let meet = |ray: &Ray| {
        let prepared = PreparedRay::new(ray);
        move |i: u32, limit: f64| {
            prepared.meet(mesh[i as usize]).map(|m| m.t).filter(|&t| 0.0 < t && t < limit)
        }
    };
    let by_octree = |r: &Ray, tally: &mut Tally| {
        octree.nearest(r, 0.0, f64::INFINITY, tally, &mut Vec::new(), meet(r));
    };
    let by_facets = |r: &Ray, tally: &mut Tally| {
        facets.nearest(r, 0.0, f64::INFINITY, tally, meet(r));
    };
    let pixels = side * side;
    let first: Vec<f64> = (0..pixels).map(|k| looks(by_octree, &ray(k))).collect();
    let second: Vec<f64> = (0..pixels).map(|k| looks(by_facets, &ray(k))).collect();
    let mean = |v: &[f64]| v.iter().sum::<f64>() / pixels as f64;
    Figure::from(
        Panels::new()
            .columns(2)
            .title(&format!(
                "A pixel looks at {:.0} cubes and triangles in D's octree, at {:.1} nodes and triangles in a hierarchy",
                mean(&first),
                mean(&second)
            ))
            .subtitle("dark blue: one look, green: a hundred, yellow: ten thousand; means over the picture")
            .alt("Two maps of a knot: with the octree its surface is yellow and green, with the hierarchy dark blue.")
            .picture(heat(&first, side), "octree, 300 triangles a cube")
            .picture(heat(&second, side), "hierarchy, eight triangles a leaf (default)"),
    )
    .caption("Counted work of each camera ray on a mesh of 70 000 triangles, the size of that in D's scene 2.")
}
