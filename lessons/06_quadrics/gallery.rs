//! The named quadrics, rendered [A ill. 9–14].

use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::bounds::Aabb;
use lightbench::color::srgb_encode;
use lightbench::integrator::Local;
use lightbench::light::{AreaLight, Emission, Light};
use lightbench::render::{Picture, render};
use lightbench::sample::Pattern;
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::quadric::{ClippedQuadric, Quadric};
use lightbench_kit::figure::{Figure, Panels, Pixels};

/// What stands in each picture: its name, its surface, its colour.
fn surfaces() -> [(&'static str, Quadric, DVec3); 8] {
    let o = DVec3::ZERO;
    let made = |q: Result<Quadric, _>| q.expect("a quadric of literal numbers");
    [
        ("sphere (2.3)", made(Quadric::ellipsoid(o, DVec3::ONE)), dvec3(0.80, 0.30, 0.16)),
        ("infinite cylinder (2.4)", made(Quadric::cylinder(o, 0.7)), dvec3(0.16, 0.42, 0.66)),
        ("infinite cone (2.5)", made(Quadric::cone(o, 0.8)), dvec3(0.75, 0.52, 0.12)),
        ("ellipsoid (2.6)", made(Quadric::ellipsoid(o, dvec3(1.15, 0.62, 0.86))), dvec3(0.20, 0.55, 0.36)),
        ("paraboloid (2.7)", made(Quadric::paraboloid(-DVec3::Z, 0.78, 0.62)), dvec3(0.62, 0.34, 0.52)),
        (
            "hyperboloid, one sheet: = 1",
            made(Quadric::hyperboloid_of_one_sheet(o, dvec3(0.46, 0.46, 0.56))),
            dvec3(0.28, 0.52, 0.68),
        ),
        (
            "hyperboloid, two sheets: = −1",
            made(Quadric::hyperboloid_of_two_sheets(o, dvec3(0.34, 0.34, 0.32))),
            dvec3(0.72, 0.40, 0.20),
        ),
        ("a saddle, not in A", made(Quadric::hyperbolic_paraboloid(o, 0.8, 0.8)), dvec3(0.42, 0.50, 0.24)),
    ]
}

pub fn panels(size: usize, samples: u32, seed: u64) -> Figure {
    let mut panels = Panels::new()
        .columns(4)
        .title("One equation of ten numbers, eight surfaces")
        .subtitle("A x² + E y² + H z² + 2B xy + 2F yz + 2C xz + 2D x + 2G y + 2I z + J = 0; unbounded ones are cut off at a box")
        .alt(
            "Eight matt surfaces on a pale floor under one lamp: a sphere, a pipe, a double cone, an ellipsoid, a bowl, a \
             cooling tower, two bowls mouth to mouth away from each other, and a saddle.",
        );
    for (name, quadric, colour) in surfaces() {
        let side = if name.contains("saddle") { 0.8 } else { 1.3 };
        let clip = Aabb::new(dvec3(-side, -side, -1.0), dvec3(side, side, 1.0));
        let image = render(
            &scene(ClippedQuadric { quadric, clip }, colour),
            &Local::default(),
            Picture { width: size, height: size, samples, seed },
        )
        .image;
        let level = |x: f64| (255.0 * srgb_encode(x.clamp(0.0, 1.0))).round() as u8;
        let rgb = image.pixels().iter().flat_map(|p| p.to_array().map(level)).collect();
        panels = panels.picture(Pixels::new(size, size, rgb), name);
    }
    Figure::from(panels).caption(
        "After A, illustrations 9 to 14, rendered by the general quadric. Equation (2.8), the hyperboloids, is missing in A: \
         x²/α² + y²/β² − z²/τ² = ±1, one sheet for +1 and two for −1.",
    )
}

fn scene(shape: ClippedQuadric, colour: DVec3) -> Scene {
    let camera = Camera::new(
        dvec3(3.2, -5.4, 3.0),
        dvec3(0.0, 0.0, -0.06),
        DVec3::Z,
        FieldOfView::Vertical(25f64.to_radians()),
    );
    let mut scene = Scene::new(camera.expect("a camera in its place"));
    let matt = |diffuse| Material { diffuse, specular: DVec3::ZERO, ..Material::default() };
    scene.materials = vec![matt(DVec3::splat(0.86)), matt(colour)];
    let floor = Cuboid::new(dvec3(-60.0, -60.0, -1.2), dvec3(60.0, 60.0, -1.01)).expect("a floor");
    scene.objects =
        vec![Object::new("floor", Box::new(floor), 0), Object::new("quadric", Box::new(shape), 1)].into();
    let (at, size): (DVec3, DVec2) = (dvec3(2.6, -3.6, 5.6), dvec2(1.6, 1.6));
    let lamp = AreaLight::rectangle(at, -at, 0.0, size, Emission::even(DVec3::splat(0.86))).expect("a lamp");
    scene.lights = vec![Light::Area(lamp.subdivided(2, 2, Pattern::Jittered))];
    scene.ambient = DVec3::splat(0.24);
    scene.background = DVec3::splat(0.93);
    scene
}
