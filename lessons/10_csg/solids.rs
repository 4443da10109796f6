//! The solids of lesson 10, and how they are looked at.

use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::csg::{Csg, Operation, Tree};
use lightbench::integrator::Local;
use lightbench::light::{AreaLight, Emission, Light};
use lightbench::ray::Ray;
use lightbench::render::render;
use lightbench::sample::Pattern;
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::Shape;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::cylinder::Cylinder;
use lightbench::shape::sphere::Sphere;
use lightbench_kit::figure::{Figure, Panels, Pixels};
use lightbench_kit::lesson::{LessonError, Picture, Result};
use lightbench_kit::scene_file::{Color, read_file};
use lightbench_kit::stage::{
    RenderSize, Stage,
    material::{colour, glossy},
};
use std::path::Path;
use std::sync::Arc;

/// Colours of box, sphere and the three cylinders, dark enough for white light.
pub const COLOURS: [DVec3; 5] = [
    DVec3::new(0.72, 0.20, 0.12),
    DVec3::new(0.10, 0.30, 0.66),
    DVec3::new(0.10, 0.50, 0.32),
    DVec3::new(0.80, 0.52, 0.10),
    DVec3::new(0.55, 0.28, 0.50),
];

pub fn block(min: DVec3, max: DVec3) -> Tree {
    Tree::leaf(Cuboid::new(min, max).expect("a box of literal numbers"))
}

pub fn cube() -> Tree {
    block(DVec3::splat(-1.5), DVec3::splat(1.5))
}

pub fn ball(center: DVec3, radius: f64) -> Tree {
    Tree::leaf(Sphere::new(center, radius).expect("a sphere of literal numbers"))
}

pub fn rod(axis: DVec3) -> Tree {
    Tree::leaf(Cylinder::new(axis * -2.0, axis * 2.0, 0.9).expect("a cylinder of literal numbers"))
}

/// [D figure 17]: what box and sphere have in common, less three cylinders.
pub fn document() -> Tree {
    let rods = rod(DVec3::X).union(rod(DVec3::Y)).union(rod(DVec3::Z));
    cube().intersection(ball(DVec3::ZERO, 2.0)).difference(rods)
}

/// A plate with `side × side × side` holes: a tree of any size.
pub fn sponge(side: i32) -> Tree {
    let cell = 3.0 / f64::from(side);
    let place = |i: i32| -1.5 + cell * (f64::from(i) + 0.5);
    let holes = (0..side.pow(3)).map(|n| {
        let at = dvec3(place(n % side), place(n / side % side), place(n / side / side));
        ball(at, 0.58 * cell)
    });
    Tree::all(Operation::Difference, [cube()].into_iter().chain(holes)).expect("a cube at least")
}

pub fn solid(tree: Tree) -> Csg {
    Csg::new(tree).expect("a tree of everyday size")
}

/// Where the solids are looked at from, and how wide.
pub const EYE: DVec3 = DVec3::new(4.6, 3.9, 7.4);
const FOV: f64 = 30.0; // degrees

pub fn camera(eye: DVec3) -> Camera {
    Camera::new(eye, dvec3(0.0, -0.05, 0.0), DVec3::Y, FieldOfView::Vertical(FOV.to_radians()))
        .expect("a camera in its place")
}

/// The ray through each pixel's centre, row by row.
pub fn rays(camera: &Camera, size: usize) -> Vec<Ray> {
    let share = |i: usize| (i as f64 + 0.5) / size as f64;
    let at = |n: usize| dvec2(share(n % size), share(n / size));
    (0..size * size).map(|n| ray_through(camera, at(n))).collect()
}

/// The ray through a place of the picture, in shares of its width and height.
pub fn ray_through(camera: &Camera, share: DVec2) -> Ray {
    camera.ray(share, 1, 1)
}

/// A shape on a pale floor, its leaves in the colours of `materials`.
pub fn portrait(shape: Box<dyn Shape>, materials: &[DVec3], size: usize, samples: u32) -> Pixels {
    let mut scene = Scene::new(camera(EYE));
    let matt = |diffuse: &DVec3| Material { diffuse: *diffuse, specular: DVec3::ZERO, ..Material::default() };
    scene.materials = [DVec3::splat(0.86)].iter().chain(materials).map(matt).collect();
    let floor = Cuboid::new(dvec3(-60.0, -3.3, -60.0), dvec3(60.0, -3.1, 60.0)).expect("a floor");
    scene.objects = vec![
        Object::new("floor", Box::new(floor), 0),
        Object::of_parts("solid", shape, (1..=materials.len()).collect()),
    ]
    .into();
    let (at, size_of_lamp): (DVec3, DVec2) = (dvec3(1.5, 8.0, 6.5), dvec2(2.4, 2.4));
    let lamp =
        AreaLight::rectangle(at, -at, 0.0, size_of_lamp, Emission::even(DVec3::splat(0.80))).expect("a lamp");
    scene.lights = vec![Light::Area(lamp.subdivided(3, 3, Pattern::Jittered))];
    scene.ambient = DVec3::splat(0.27);
    scene.background = DVec3::splat(0.93);
    let picture = lightbench::render::Picture { width: size, height: size, samples, seed: 0 };
    Pixels::from(&render(&scene, &Local::default(), picture).image)
}

/// The documents' solid in the studio.
pub fn hero(size: &RenderSize) -> Picture {
    use colour::{CLAY, NIGHT, OCHRE, SAGE, TEAL};
    let leaves = [CLAY, TEAL, OCHRE, SAGE, NIGHT].map(|c| glossy(c, 0.35)).to_vec();
    let stage = Stage::new(DVec3::ZERO, 1.9).ground(-1.5).with_parts(Arc::new(solid(document())), leaves);
    Picture {
        image: stage.seen_from(32.0).render(size),
        title: "A box, a sphere and three rods make one solid".to_string(),
        caption: "(box ∩ sphere) − (rod ∪ rod ∪ rod). Each point of the surface keeps the colour of the leaf it lies on."
            .to_string(),
        alt: "A rounded cube with a round tunnel through each pair of faces, on a pale ground; the flat faces are red, the \
              rounded edges blue, the tunnels ochre, green and dark blue."
            .to_string(),
    }
}

/// [D figures 47, 48].
pub fn scene_3(size: usize) -> Result<Figure> {
    let mut panels = Panels::new()
        .columns(2)
        .title("The solid of five leaves in an open room")
        .subtitle("After Tomas, figures 47 and 48. The sizes of the solids are not printed; these are ours.")
        .alt("Two pictures of a white rounded box with tunnels that floats in a red and green room, with a soft and a hard shadow.");
    for (name, label) in [("d03_csg", "light of 10 × 10 points"), ("d03_point_light", "point light")] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../scenes/{name}.scene"));
        let file = read_file(&path).map_err(|e| LessonError(e.render(Color::Never)))?;
        let picture = lightbench::render::Picture { width: size, height: size, samples: 1, seed: 0 };
        panels = panels.picture(Pixels::from(&render(&file.scene, &Local::default(), picture).image), label);
    }
    Ok(Figure::from(panels))
}
