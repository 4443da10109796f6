//! Pictures of Julia sets: one large, and rows of sets, steps and slices.

use super::VIEWED;
use glam::{DAffine3, DVec3, DVec4, dvec2, dvec3};
use lightbench::integrator::Local;
use lightbench::light::{AreaLight, Emission, Light};
use lightbench::render::{Picture, render};
use lightbench::sample::Pattern;
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::sdf::julia::Julia;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::instance::Instance;
use lightbench_kit::figure::{Figure, Panels, Pixels};
use lightbench_kit::lesson::{Lesson, LessonError, Result};

/// A set, how much of its slice is shown, and its colour.
struct Model {
    c: DVec4,
    iterations: u32,
    w: f64,
    /// Height of the middle over the floor [m].
    height: f64,
    color: DVec3,
}

const VIOLET: DVec3 = DVec3::new(0.36, 0.17, 0.62);
const OCHRE: DVec3 = DVec3::new(0.80, 0.47, 0.10);
const TEAL: DVec3 = DVec3::new(0.04, 0.45, 0.46);
const RED: DVec3 = DVec3::new(0.78, 0.16, 0.10);

fn wrong(e: &dyn std::fmt::Display) -> LessonError {
    LessonError(e.to_string())
}

/// The set over a floor, under a lamp of 3 m × 3 m.
fn scene(model: &Model) -> Result<Scene> {
    let target = dvec3(0.0, model.height - 0.12, 0.0);
    let eye = target + dvec3(1.5, 2.2, 4.3);
    let camera = Camera::new(eye, target, DVec3::Y, FieldOfView::Vertical(0.58)).map_err(|e| wrong(&e))?;
    let mut scene = Scene::new(camera);
    let paint = |diffuse| Material { diffuse, specular: DVec3::ZERO, ..Default::default() };
    scene.materials = vec![paint(dvec3(0.72, 0.70, 0.66)), paint(model.color)];
    let far = 400.0;
    let floor = Cuboid::new(dvec3(-far, -1.0, -far), dvec3(far, 0.0, far)).map_err(|e| wrong(&e))?;
    scene.objects.push(Object::new("floor", Box::new(floor), 0));
    let julia = Julia::new(model.c, model.iterations, 2.0, model.w).map_err(|e| wrong(&e))?;
    let raised = DAffine3::from_translation(DVec3::Y * model.height);
    let set = Instance::new(Box::new(julia), raised).map_err(|e| wrong(&e))?;
    scene.objects.push(Object::new("set", Box::new(set), 1));
    let place = dvec3(4.6, 7.0, 3.6);
    let size = dvec2(3.0, 3.0);
    let lamp = AreaLight::rectangle(place, target - place, 0.0, size, Emission::even(DVec3::splat(0.95)));
    scene.lights.push(Light::Area(lamp.map_err(|e| wrong(&e))?.subdivided(3, 3, Pattern::Jittered)));
    scene.background = dvec3(0.80, 0.86, 0.92);
    scene.ambient = DVec3::splat(0.16);
    Ok(scene)
}

fn shot(lesson: &Lesson, model: &Model, (width, height, samples): (usize, usize, u32)) -> Result<Pixels> {
    let picture = Picture { width, height, samples, seed: lesson.seed() };
    Ok(Pixels::from(&render(&scene(model)?, &Local::default(), picture).image))
}

/// [A ill. 16].
pub fn set(lesson: &Lesson) -> Result {
    let model = Model { c: VIEWED, iterations: 10, w: 0.0, height: 1.0, color: OCHRE };
    let (width, samples) = lesson.pick([(40, 1), (400, 2), (720, 4), (1200, 16)]);
    let picture = Picture { width, height: width * 3 / 4, samples, seed: lesson.seed() };
    lesson.save_picture(
        "set",
        &render(&scene(&model)?, &Local::default(), picture).image,
        "The quaternion Julia set of c = −0.2 + 0.6 i + 0.2 j + 0.2 k after ten steps, in its own shadow (after A, illustration 16).",
        "An ochre body of folded lobes and a knob that repeats the whole, over a pale floor, with soft shadows on itself.",
    )
}

fn panels(lesson: &Lesson, models: &[(Model, String)], panels: Panels) -> Result<Panels> {
    let (width, samples) = lesson.pick([(24, 1), (200, 2), (280, 4), (400, 16)]);
    models.iter().try_fold(panels, |panels, (model, label)| {
        Ok(panels.picture(shot(lesson, model, (width, width * 5 / 6, samples))?, label))
    })
}

pub fn sets(lesson: &Lesson) -> Result {
    let quaternions = [
        ("−0.125 − 0.256 i + 0.847 j + 0.0895 k", DVec4::new(-0.125, -0.256, 0.847, 0.0895), VIOLET),
        ("−1 + 0.2 i", DVec4::new(-1.0, 0.2, 0.0, 0.0), TEAL),
        ("−0.291 − 0.399 i + 0.339 j + 0.437 k", DVec4::new(-0.291, -0.399, 0.339, 0.437), RED),
        ("0.185 + 0.478 i + 0.125 j − 0.392 k", DVec4::new(0.185, 0.478, 0.125, -0.392), VIOLET),
        ("−0.213 − 0.041 i − 0.563 j − 0.56 k", DVec4::new(-0.213, -0.041, -0.563, -0.56), TEAL),
        ("−0.45 − 0.447 i + 0.181 j + 0.306 k", DVec4::new(-0.45, -0.447, 0.181, 0.306), OCHRE),
    ];
    let models = quaternions.map(|(name, c, color)| {
        (Model { c, iterations: 9, w: 0.0, height: 1.05, color }, format!("c = {name}"))
    });
    let shown = Panels::new()
        .columns(3)
        .title("One rule, six sets: only the quaternion that is added differs")
        .subtitle("q² + c nine times, |q| ≤ 2; shadow rays meet the set that they leave")
        .alt(
            "Six bodies with lobes within lobes: a pierced shell, a string of beads, and four folded lumps.",
        );
    let figure = Figure::from(panels(lesson, &models, shown)?)
        .caption("Six quaternion Julia sets, each lit by a square lamp and throwing shadows on itself (after A, illustration 16).");
    lesson.save("sets", figure)
}

pub fn steps(lesson: &Lesson) -> Result {
    let models = [2, 3, 4, 6, 8, 12].map(|iterations| {
        (Model { c: VIEWED, iterations, w: 0.0, height: 1.0, color: OCHRE }, format!("{iterations} steps"))
    });
    let shown = Panels::new()
        .columns(3)
        .title("Each step doubles the degree, and folds the surface once more")
        .subtitle("q² + c, c = −0.2 + 0.6 i + 0.2 j + 0.2 k; the points with |q| ≤ 2 after 2 to 12 steps")
        .alt("Six stages from a smooth lump to a body of lobes within lobes.");
    let figure = Figure::from(panels(lesson, &models, shown)?).caption(
        "The same set after 2, 3, 4, 6, 8 and 12 steps. A surface of N steps is a polynomial of degree 2ᴺ⁺¹ along a ray: 8192 for the last.",
    );
    lesson.save("iterations", figure)
}

pub fn slices(lesson: &Lesson) -> Result {
    let models = [-0.3, -0.1, 0.1, 0.3, 0.5, 0.6].map(|w| {
        (
            Model { c: VIEWED, iterations: 10, w, height: 1.0, color: TEAL },
            format!("w = {w}").replace('-', "−"),
        )
    });
    let shown = Panels::new()
        .columns(3)
        .title("The set has four dimensions; a picture shows a slice")
        .subtitle(
            "the points x + y i + z j + w k with the same w; ten steps, c = −0.2 + 0.6 i + 0.2 j + 0.2 k",
        )
        .alt("Six slices of the set: they shrink as w grows, and lose their knobs.");
    let figure = Figure::from(panels(lesson, &models, shown)?)
        .caption("Six slices through the fourth coordinate w of one set.");
    lesson.save("slices", figure)
}
