//! The scenes: A's sphere on a floor, and what stands on it otherwise.

use super::contest::{Question, TILE, Tile};
use glam::{DAffine3, DVec3, dvec3};
use lightbench::color::Rgb;
use lightbench::light::{DirectionalLight, Light, PointLight, SpotLight};
use lightbench::mesh::{Mesh, tessellate};
use lightbench::ray::Ray;
use lightbench::sample::Sampler;
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::Shape;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::cylinder::Cylinder;
use lightbench::shape::instance::Instance;
use lightbench::shape::plane::Plane;
use lightbench::shape::sphere::Sphere;
use lightbench_kit::lesson::{LessonError, Result};
use lightbench_kit::scene_file::{Color, read};
use std::fmt::Display;

const ROOM: &str = include_str!("../../scenes/d01_point_light.scene");
/// A says "above and to the right", and "farther back"; the places are ours [A ill. 38, 39].
pub const OMNI: [DVec3; 2] = [dvec3(3.2, 4.2, 1.2), dvec3(2.6, 5.2, -4.2)];
/// Directions of the light [A ill. 42, 43].
pub const PARALLEL: [DVec3; 2] = [dvec3(-1.0, -1.0, 0.0), dvec3(-1.0, -1.0, 1.0)];
const FLOOR: Rgb = Rgb::new(0.62, 0.59, 0.54);
const WHITE: Rgb = Rgb::new(0.85, 0.85, 0.85);
const CLAY: Rgb = Rgb::new(0.78, 0.3, 0.16);
const SKY: Rgb = Rgb::new(0.55, 0.66, 0.8);

pub fn other(e: impl Display) -> LessonError {
    LessonError(e.to_string())
}

/// A camera, a floor of material 0, and a material 1 for what stands on it.
fn stage(eye: DVec3, target: DVec3, degrees: f64, colors: [Rgb; 2]) -> Result<Scene> {
    let view = FieldOfView::Vertical(degrees.to_radians());
    let mut scene = Scene::new(Camera::new(eye, target, DVec3::Y, view).map_err(other)?);
    scene.background = SKY;
    for diffuse in colors {
        scene.materials.push(Material { diffuse, ..Material::default() });
    }
    let floor = Plane::new(DVec3::ZERO, DVec3::Y).map_err(other)?;
    scene.objects.push(Object::new("floor", Box::new(floor), 0));
    Ok(scene)
}

fn put(scene: &mut Scene, shape: impl Shape + 'static) {
    scene.objects.push(Object::new("thing", Box::new(shape), 1));
}

/// A's sphere on its floor.
pub fn sphere_on_floor(lights: Vec<Light>) -> Result<Scene> {
    let mut scene = stage(dvec3(-0.3, 3.1, 7.4), dvec3(-0.3, 0.6, 0.0), 34.0, [FLOOR, CLAY])?;
    put(&mut scene, Sphere::new(DVec3::Y, 1.0).map_err(other)?);
    scene.ambient = Rgb::splat(0.06);
    scene.lights = lights;
    Ok(scene)
}

pub fn omni(place: DVec3, color: f64) -> Light {
    PointLight::of_color(place, Rgb::splat(color)).into()
}

pub fn parallel(direction: DVec3, color: f64) -> Result<Light> {
    Ok(DirectionalLight::of_color(direction, Rgb::splat(color)).map_err(other)?.into())
}

/// Red, green and blue light on white things.
pub fn coloured() -> Result<Scene> {
    let mut scene = stage(dvec3(0.0, 5.2, 7.6), dvec3(0.0, 0.45, -0.1), 30.0, [WHITE, WHITE])?;
    put(&mut scene, Sphere::new(dvec3(0.0, 0.9, 0.0), 0.9).map_err(other)?);
    for (k, color) in
        [dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0), dvec3(0.0, 0.0, 1.0)].into_iter().enumerate()
    {
        let angle = (90.0 + 120.0 * k as f64).to_radians();
        let place = dvec3(2.6 * angle.cos(), 5.0, 2.6 * angle.sin());
        scene.lights.push(PointLight::of_color(place, color).into());
    }
    Ok(scene)
}

/// Three cones on a floor with things: a wide soft rim, a narrow one, a hard one.
pub fn spots() -> Result<Scene> {
    let mut scene = stage(dvec3(0.0, 5.0, 9.2), dvec3(0.0, 0.35, 0.0), 26.0, [FLOOR, WHITE])?;
    put(&mut scene, Sphere::new(dvec3(-2.75, 0.55, 0.1), 0.55).map_err(other)?);
    put(&mut scene, Cylinder::new(DVec3::ZERO, DVec3::Y * 1.3, 0.4).map_err(other)?);
    put(&mut scene, Cuboid::new(dvec3(2.3, 0.0, -0.4), dvec3(3.1, 0.8, 0.4)).map_err(other)?);
    scene.background = Rgb::splat(0.02);
    scene.ambient = Rgb::splat(0.03);
    let cones = [
        (-2.75, 0.0, dvec3(1.0, 0.72, 0.4)),
        (0.0, 12.0, dvec3(0.9, 0.95, 0.9)),
        (2.75, 16.0, dvec3(0.4, 0.66, 1.0)),
    ];
    for (x, full, color) in cones {
        let from = dvec3(x + 0.9, 4.4, 1.6);
        let point = PointLight::of_color(from, color);
        let cone =
            SpotLight::new(point, dvec3(x, 0.0, -0.1) - from, f64::to_radians(full), 16f64.to_radians());
        scene.lights.push(cone.map_err(other)?.into());
    }
    Ok(scene)
}

/// B's sphere under a ring of many lights.
pub fn ring_of_lights(count: u32) -> Result<Scene> {
    let mut scene = stage(dvec3(0.0, 7.0, 6.6), dvec3(0.0, 0.0, 0.25), 34.0, [WHITE, CLAY])?;
    put(&mut scene, Sphere::new(dvec3(0.0, 0.9, 0.0), 0.7).map_err(other)?);
    for k in 0..count {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / f64::from(count)).sin_cos();
        scene.lights.push(omni(dvec3(3.4 * cos, 3.6, 3.4 * sin), 1.15 / f64::from(count)));
    }
    Ok(scene)
}

/// A sphere in the low sun.
pub fn evening() -> Result<Scene> {
    let mut scene = stage(dvec3(-1.2, 2.3, 7.6), dvec3(-1.2, 0.75, 0.0), 34.0, [FLOOR, WHITE])?;
    put(&mut scene, Sphere::new(DVec3::Y, 1.0).map_err(other)?);
    scene.background = dvec3(0.72, 0.58, 0.5);
    scene.ambient = dvec3(0.05, 0.07, 0.12);
    let sun = DirectionalLight::of_color(dvec3(-2.2, -1.0, 0.45), dvec3(1.6, 1.15, 0.7)).map_err(other)?;
    scene.lights.push(sun.into());
    Ok(scene)
}

/// Side of the square that a swarm floats over [m].
pub const SQUARE: f64 = 6.0;
/// Where its light travels.
const STEEP: DVec3 = dvec3(-0.3, -1.0, -0.2);

/// Radius [m] of `n` spheres over the square that cover this share of it: discs at random places leave exp(−n π r²/A) free.
pub fn radius_of(n: usize, share: f64) -> f64 {
    (-(1.0 - share).ln() * SQUARE * SQUARE / (n as f64 * std::f64::consts::PI)).sqrt()
}

/// `n` spheres that float over a floor in parallel light and cover this share of it, seen from above. The more, the smaller.
pub fn swarm(n: usize, share: f64, seed: u64) -> Result<Scene> {
    let mut scene = stage(dvec3(0.0, 16.0, 0.8), dvec3(0.3, 0.0, 0.2), 15.0, [FLOOR, CLAY])?;
    let radius = radius_of(n, share);
    for k in 0..n {
        let mut sampler = Sampler::new(seed, k as u64, 0);
        let (a, b) = (sampler.next_2d(), sampler.next_2d());
        let center = dvec3(SQUARE * (a.x - 0.5), 1.0 + radius + 1.5 * b.x, SQUARE * (a.y - 0.5));
        put(&mut scene, Sphere::new(center, radius).map_err(other)?);
    }
    scene.lights.push(parallel(STEEP, 0.9)?);
    Ok(scene)
}

/// Tiles of a floor under the swarm, `step` metres from place to place, at random where the whole tile has its shadow from
/// the swarm's square.
pub fn places(tiles: u32, step: f64, seed: u64) -> Vec<Tile> {
    let side = TILE as f64 * step;
    let corner = |k: u32| {
        let u = Sampler::new(seed, 1 << 40, k).next_2d() * (SQUARE - 2.0 - side).max(0.0);
        dvec3(u.x - 0.5 * SQUARE + 1.6, 0.0, u.y - 0.5 * SQUARE + 1.4)
    };
    let tile = |k: u32| {
        let corner = corner(k);
        let question = |i: usize| {
            let from = corner + dvec3((i % TILE) as f64, 0.0, (i / TILE) as f64) * step;
            Question { light: 0, segment: Ray::new(from, -STEEP), t_max: f64::INFINITY }
        };
        (0..TILE * TILE).map(question).collect()
    };
    (0..tiles).map(tile).collect()
}

/// A knot of triangles over the floor.
pub fn knot() -> Result<Scene> {
    let mut scene = stage(dvec3(0.0, 4.0, 7.0), dvec3(0.0, 0.8, 0.0), 34.0, [FLOOR, CLAY])?;
    let mesh = Mesh::new(&tessellate::bumpy_knot(120, 24)).map_err(other)?;
    let size = mesh.bounds();
    let scale = 2.4 / (size.max - size.min).max_element();
    let frame = DAffine3::from_translation(dvec3(0.0, 1.25, 0.0)) * DAffine3::from_scale(DVec3::splat(scale));
    put(&mut scene, Instance::new(Box::new(mesh), frame).map_err(other)?);
    scene.lights = vec![omni(OMNI[0], 0.9)];
    Ok(scene)
}

/// Scene 1 of D under its point light.
pub fn room() -> Result<Scene> {
    Ok(read(ROOM, "scene 1").map_err(|e| other(e.render(Color::Never)))?.scene)
}
