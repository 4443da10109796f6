//! The sponge: walked through its grid, or marched through its field.

use super::Contest;
use super::contestant::is_wrong;
use glam::{DVec3, dvec3};
use lightbench::integrator::Local;
use lightbench::light::{AreaLight, Emission, Light, PointLight};
use lightbench::measure::{Failures, Method, Point, Series, Spread, time_each};
use lightbench::ray::Ray;
use lightbench::render::{Picture, render};
use lightbench::sample::Pattern;
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::sdf::{DistanceField, FieldShape, Menger, Stride};
use lightbench::shape::Shape;
use lightbench::shape::plane::Plane;
use lightbench_kit::figure::{Axis, Chart, Figure, grouped};
use lightbench_kit::lesson::{Lesson, LessonError, Result};

/// Both methods over the depth.
pub struct Sponges(Contest);

impl Sponges {
    fn failures(&self) -> Failures {
        self.0.iter().fold(Failures::default(), |sum, (_, s)| sum.plus(&s.failures()))
    }
    pub fn of(&self) -> String {
        grouped(self.failures().of)
    }
    pub fn wrong(&self) -> u64 {
        self.failures().total()
    }
    /// How many times as long marching takes as walking: the median over the depths.
    fn factor(&self) -> f64 {
        let time = |p: &Point| p.time.map_or(f64::NAN, |t| t.mid);
        let ratio = |(a, b): (&Point, &Point)| time(b) / time(a);
        let ratios: Vec<f64> = self.0[0].1.points.iter().zip(&self.0[1].1.points).map(ratio).collect();
        Spread::median(&ratios).map_or(f64::NAN, |s| s.mid)
    }
}

/// Rays at the sponge of edge 2 from all around, aimed anywhere into it.
fn rays(seed: u64, count: u32) -> Vec<Ray> {
    let ray = |i| {
        let mut sampler = Sampler::new(seed, 94, i);
        let from = uniform_sphere(sampler.next_2d()) * 5.0;
        let [xy, z] = [sampler.next_2d(), sampler.next_2d()];
        Ray::new(from, (dvec3(xy.x, xy.y, z.x) * 2.0 - 1.0 - from).normalize())
    };
    (0..count).map(ray).collect()
}

pub fn contest(lesson: &Lesson) -> Sponges {
    let rays = rays(lesson.seed(), lesson.pick([64, 512, 2048, 8192]));
    let (mut walked, mut marched) = (Vec::new(), Vec::new());
    for depth in 1..=lesson.pick([4, 7, 8, 8]) {
        let sponge = Menger::new(DVec3::ZERO, 2.0, depth).expect("a sponge");
        let shape = FieldShape::new(sponge).expect("a bounded field");
        let near = |s: &dyn Shape, r: &Ray| s.nearest(r, 0.0, f64::INFINITY).map(|c| c.t);
        let time =
            |s: &dyn Shape| time_each(rays.len(), || rays.iter().filter(|r| near(s, r).is_some()).count());
        // Where a ray cuts an edge more finely than the tolerance, both are right: the field says how deep it dives.
        let shallow = |r: &Ray, t: Option<f64>| {
            t.is_some_and(|t| {
                sponge.distance(r.at(t + 2.0 * shape.march().tolerance)) > -64.0 * shape.march().tolerance
            })
        };
        let wrong = |r: &&Ray| {
            let (a, b) = (near(&sponge, r), near(&shape, r));
            is_wrong(b, a) && !shallow(r, a) && !shallow(r, b)
        };
        let missed = rays.iter().filter(wrong).count() as u64;
        let failures = Failures { missed, of: rays.len() as u64, ..Failures::default() };
        let steps = |r: &Ray| shape.march().first(&sponge, r, 0.0, 10.0).steps;
        let work = rays.iter().map(|r| f64::from(steps(r))).sum::<f64>() / rays.len() as f64;
        let depth = f64::from(depth);
        walked.push(Point::at(depth).timed(time(&sponge)));
        marched.push(Point { failures, ..Point::at(depth).timed(time(&shape)).worked(work) });
    }
    let name = format!("marched, {}", Stride::ALL[2].name());
    Sponges(vec![
        (Method::default_of("walked").styled(0), Series::new(walked)),
        (Method::new(&name).styled(2), Series::new(marched)),
    ])
}

pub fn show(lesson: &Lesson, sponges: &Sponges) -> Result {
    lesson.save("sponge", chart(sponges))?;
    let samples = lesson.pick([1, 1, 4, 16]);
    let width = lesson.pick([48, 480, 720, 1280]);
    let picture = Picture { width, height: width * 9 / 16, samples, seed: lesson.seed() };
    let shot = |scene: Scene| render(&scene, &Local::default(), picture).image;
    lesson.save_picture(
        "journey",
        &shot(journey()?),
        "A Menger sponge of depth 5, seen from one of its tunnels, after E, slide 94.",
        "A tunnel whose walls are pierced by square holes within square holes, warm light in the middle, blue at the end.",
    )?;
    lesson.save_picture(
        "menger",
        &shot(on_the_floor()?),
        "A Menger sponge of depth 4 under a square lamp.",
        "A sandy cube full of square holes of four sizes stands on a grey floor; soft light from above falls through it.",
    )
}

fn chart(sponges: &Sponges) -> Figure {
    let mut chart = Chart::time_over(Axis::linear("depth of the sponge").every(1.0), "time per ray")
        .title(&format!(
            "Marched through its field, the sponge takes {:.1} times as long as walked",
            sponges.factor()
        ))
        .subtitle("rays from all around, aimed anywhere into the cube; cells of 3⁻ⁿ of the edge");
    for (method, series) in &sponges.0 {
        chart = chart.line(method.clone(), series);
    }
    Figure::from(chart).caption(
        "Time to the first surface of a Menger sponge over its depth, median with quartiles. The walk divides the ray at the planes of \
         the cells, from coarse to fine; the march leaps by a field whose every evaluation looks at all the depths.",
    )
}

fn wrong(e: &dyn std::fmt::Display) -> LessonError {
    LessonError(e.to_string())
}

fn paint(name: &str, diffuse: DVec3) -> Material {
    Material { name: name.to_string(), diffuse, specular: DVec3::ZERO, ..Default::default() }
}

/// Inside, in the wide tunnel along z.
fn journey() -> Result<Scene> {
    let (eye, target) = (dvec3(-0.12, -0.13, 0.95), dvec3(0.10, 0.03, -0.4));
    let camera = Camera::new(eye, target, dvec3(0.12, 1.0, 0.0), FieldOfView::Vertical(1.12))
        .map_err(|e| wrong(&e))?;
    let mut scene = Scene::new(camera);
    scene.materials = vec![paint("stone", dvec3(0.80, 0.72, 0.62))];
    let sponge = Menger::new(DVec3::ZERO, 2.0, 5).map_err(|e| wrong(&e))?;
    scene.objects.push(Object::new("sponge", Box::new(sponge), 0));
    let lamp = |position, power| Light::Point(PointLight::of_intensity(position, power));
    scene.lights = vec![
        lamp(dvec3(0.14, 0.16, 0.02), dvec3(1.0, 0.62, 0.28) * 0.75),
        lamp(dvec3(-0.2, 0.22, 1.0), dvec3(0.75, 0.85, 1.0) * 0.55),
        lamp(dvec3(0.0, 0.0, -1.6), dvec3(0.35, 0.55, 1.0) * 1.2),
    ];
    scene.background = dvec3(0.62, 0.76, 0.95);
    scene.ambient = dvec3(0.13, 0.135, 0.15);
    Ok(scene)
}

/// Outside, on a floor: `scenes/e94_menger.scene`.
fn on_the_floor() -> Result<Scene> {
    let (eye, target) = (dvec3(3.1, 2.7, 4.4), dvec3(0.0, 0.86, 0.0));
    let camera = Camera::new(eye, target, DVec3::Y, FieldOfView::Vertical(0.56)).map_err(|e| wrong(&e))?;
    let mut scene = Scene::new(camera);
    scene.materials = vec![paint("floor", dvec3(0.62, 0.60, 0.57)), paint("sponge", dvec3(0.86, 0.55, 0.24))];
    let floor = Plane::new(DVec3::ZERO, DVec3::Y).map_err(|e| wrong(&e))?;
    let sponge = Menger::new(DVec3::Y, 2.0, 4).map_err(|e| wrong(&e))?;
    scene.objects.push(Object::new("floor", Box::new(floor), 0));
    scene.objects.push(Object::new("sponge", Box::new(sponge), 1));
    let place = dvec3(2.4, 5.2, 4.8);
    let size = glam::DVec2::splat(2.0);
    let lamp =
        AreaLight::rectangle(place, DVec3::Y * 0.8 - place, 0.0, size, Emission::even(dvec3(0.9, 0.87, 0.8)));
    scene.lights.push(Light::Area(lamp.map_err(|e| wrong(&e))?.subdivided(4, 4, Pattern::Jittered)));
    scene.background = dvec3(0.72, 0.80, 0.90);
    scene.ambient = dvec3(0.16, 0.17, 0.20);
    Ok(scene)
}
