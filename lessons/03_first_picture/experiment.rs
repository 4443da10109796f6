//! The room under each way to light it: its pictures, their errors, and a version that is wrong on purpose.

use super::POINT;
use super::RUNS;
use glam::{DVec3, dvec2, dvec3};
use lightbench::color::Rgb;
use lightbench::film::Image;
use lightbench::film::metric::compare;
use lightbench::integrator::{Local, Stage};
use lightbench::light::Light;
use lightbench::measure::{Point, Tally, quantised, timed};
use lightbench::ray::{Ray, Silent};
use lightbench::render::{Picture, render, shade};
use lightbench::sample::Pattern;
use lightbench::scene::{Camera, FieldOfView, Scene};
use lightbench_kit::lesson::{LessonError, Result};
use lightbench_kit::scene_file::{Color, read};
use std::f64::consts::FRAC_1_PI;
use std::fmt::Display;

pub const AREA: &str = include_str!("../../scenes/d01_boxes_spheres.scene");
pub const AMBIENT: f64 = 0.05; // W/(m² sr), in every picture but D's own
pub const BIAS: f64 = 1.0e-4; // m
/// A stage: its name, how far it goes, and n of its n × n light points.
pub struct Way(pub &'static str, pub Stage, pub u32, pub Pattern);
/// What a picture took and how far it is off; shape tests a pixel.
pub type Measured = (Point, f64);
/// Radiance at places on a line.
pub type Line = Vec<(f64, f64)>;

pub fn soft(n: u32, pattern: Pattern) -> Way {
    Way("", Stage::Shadowed, n, pattern)
}

pub fn room(text: &str) -> Result<Scene> {
    Ok(read(text, "scene 1").map_err(|e| LessonError(e.render(Color::Never)))?.scene)
}

/// Scene 1 under n × n light points, and ambient light.
pub fn lit(way: &Way) -> Result<Scene> {
    let mut scene = room(AREA)?;
    scene.ambient = Rgb::splat(AMBIENT);
    for light in &mut scene.lights {
        if let Light::Area(area) = light {
            *area = area.subdivided(way.2, way.2, way.3);
        }
    }
    Ok(scene)
}

pub fn shoot(way: &Way, picture: Picture) -> Result<Image> {
    Ok(render(&lit(way)?, &Local { stage: way.1, ..Local::default() }, picture).image)
}

/// Every run takes all ways in turn, so that a busy moment of the machine favours none.
pub fn measured(ways: &[Way], picture: Picture, truth: &Image) -> Result<Vec<Measured>> {
    let scenes = ways.iter().map(lit).collect::<Result<Vec<_>>>()?;
    let pixels = (picture.width * picture.height) as f64;
    let mut found = vec![(Tally::new(), 0.0, 0.0); ways.len()];
    for run in 0..RUNS {
        let picture = Picture { seed: picture.seed.wrapping_add(run.into()), ..picture };
        for ((way, scene), (runs, rays, tests)) in ways.iter().zip(&scenes).zip(&mut found) {
            let (seconds, done) =
                timed(|| render(scene, &Local { stage: way.1, ..Local::default() }, picture));
            runs.timed_answer(seconds, compare(&done.image, truth).rmse, 0.0);
            (*rays, *tests) =
                (done.tally.total_rays() as f64 / pixels, done.tally.shape_tests as f64 / pixels);
        }
    }
    let points = ways.iter().zip(found);
    Ok(points
        .map(|(w, (runs, rays, tests))| (runs.rms_at(f64::from(w.2 * w.2)).worked(rays), tests))
        .collect())
}

/// Red radiance over x [m] on the back wall, along a level line across the shadow of the middle sphere.
pub fn wall(way: &Way, seed: u64) -> Result<Line> {
    let mut scene = lit(way)?;
    let view = FieldOfView::Horizontal(0.085);
    scene.camera =
        Camera::new(scene.camera.position(), dvec3(-3.72, 5.0, -5.0), DVec3::Y, view).map_err(other)?;
    let picture = Picture { width: 400, height: 1, samples: 1, seed };
    let image = render(&scene, &Local::default(), picture).image;
    let place = |i: usize| {
        let ray = scene.camera.ray(dvec2(i as f64 + 0.5, 0.5), picture.width, 1);
        scene.nearest(&ray, f64::INFINITY, &mut Silent).map_or(f64::NAN, |(_, c)| ray.at(c.t).x)
    };
    Ok((0..picture.width).map(|i| (place(i), image.get(i, 0).x)).collect())
}

/// Correlation of the errors of neighbours, and its standard deviation if they are independent.
pub fn neighbours(errors: &Line) -> (f64, f64) {
    let products = errors.windows(2).map(|w| w[0].1 * w[1].1);
    let squares: f64 = errors.iter().map(|e| e.1 * e.1).sum();
    (products.clone().sum::<f64>() / squares, products.map(|p| p * p).sum::<f64>().sqrt() / squares)
}

/// The largest change of radiance and the share of pixels that change visibly, where every length of the room is
/// multiplied: with the library's origins, and with a fixed bias.
pub fn changes(size: f64, picture: Picture, truth: &Image) -> Result<[(f64, f64); 2]> {
    const LENGTHS: [&str; 7] = ["POV", "POI", "Center", "Radius", "Scale", "Translation", "Position"];
    let line = |line: &str| match line.trim().split_once(' ') {
        Some((name, numbers)) if LENGTHS.contains(&name) => {
            let number = |x: &str| x.parse().map_or(x.to_string(), |x: f64| format!("{:e}", x * size));
            format!("{name} {}", numbers.split(' ').map(number).collect::<Vec<_>>().join(" "))
        }
        _ => line.to_string(),
    };
    let scene = room(&POINT.lines().map(line).collect::<Vec<_>>().join("\n"))?;
    let change = |image: Image| {
        let visible = |(p, q): &(&Rgb, &Rgb)| (**p - **q).abs().max_element() > quantised() / 255.0;
        let count = image.pixels().iter().zip(truth.pixels()).filter(visible).count();
        (compare(&image, truth).max_error.abs(), count as f64 / image.pixels().len() as f64)
    };
    let ours = render(&scene, &Local::default(), picture).image;
    Ok([change(ours), change(shade(&scene, picture, naive_bias))])
}

/// Hard shadows whose rays start a fixed distance off the surface: **wrong** in rooms of another size.
fn naive_bias(ray: &Ray, scene: &Scene) -> Rgb {
    let Some((object, crossing)) = scene.nearest(ray, f64::INFINITY, &mut Silent) else {
        return scene.background;
    };
    let hit = scene.hit(ray, object, &crossing);
    let origin = hit.point + hit.ng * BIAS;
    let Some(Light::Point(light)) = scene.lights.first() else { return Rgb::ZERO };
    let to = light.position - origin;
    if scene.blocker(&Ray::new(origin, to), 1.0, &mut Silent).is_some() {
        return Rgb::ZERO;
    }
    scene.materials[scene.objects[object].material(hit.part)].diffuse
        * light.strength
        * FRAC_1_PI
        * (hit.ng.dot(to) / to.length()).max(0.0)
}

pub fn other(e: impl Display) -> LessonError {
    LessonError(e.to_string())
}

pub fn rmse(point: &Point) -> f64 {
    point.error.map_or(f64::NAN, |e| e.mid)
}

/// Median time [s].
pub fn mid(stages: &[Measured], i: usize) -> f64 {
    stages[i].0.time.map_or(f64::NAN, |t| t.mid)
}
