//! The pictures: A's spheres under triangles and a sphere, D's bands, umbra and penumbra.

use super::place::other;
use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::color::Rgb;
use lightbench::film::Image;
use lightbench::integrator::{Local, Stage};
use lightbench::light::{AreaLight, Emission, Emitter, Light, Rectangle};
use lightbench::ray::Silent;
use lightbench::render::{Picture, render};
use lightbench::sample::Pattern;
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::plane::Plane;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::triangle::Triangle;
use lightbench_kit::figure::drawing::{Anchor, Chain, Drawing, Ends, Face, Item, Rect, Stroke, Text};
use lightbench_kit::figure::heading::Heading;
use lightbench_kit::figure::ink::Ink;
use lightbench_kit::figure::{Figure, Panels, Pixels};
use lightbench_kit::lesson::{Lesson, Result};
use lightbench_kit::scene_file::{Color, read};

const TRIANGLES: &str = include_str!("../../scenes/a48_triangle_lights.scene");
const BULB: &str = include_str!("../../scenes/a124_sphere_light.scene");
const ROOM: &str = include_str!("../../scenes/d01_boxes_spheres.scene");

fn from_file(text: &str, name: &str) -> Result<Scene> {
    Ok(read(text, name).map_err(|e| other(e.render(Color::Never)))?.scene)
}

fn with_lights(mut scene: Scene, change: impl Fn(AreaLight) -> AreaLight) -> Scene {
    for light in &mut scene.lights {
        if let Light::Area(area) = light {
            *area = change(*area);
        }
    }
    scene
}

/// A floor, a wall and a sphere, still dark: what the contest is about.
pub fn stage() -> Result<Scene> {
    let view = FieldOfView::Vertical(0.5);
    let camera = Camera::new(dvec3(0.0, 2.6, 8.0), dvec3(0.0, 0.9, 0.0), DVec3::Y, view).map_err(other)?;
    let mut scene = Scene::new(camera);
    for (name, diffuse) in [("floor", dvec3(0.6, 0.57, 0.52)), ("clay", dvec3(0.72, 0.3, 0.16))] {
        scene.materials.push(Material { name: name.into(), diffuse, ..Material::default() });
    }
    let plane = |p, n| Plane::new(p, n).map_err(other);
    scene.objects.push(Object::new("floor", Box::new(plane(DVec3::ZERO, DVec3::Y)?), 0));
    scene.objects.push(Object::new("wall", Box::new(plane(dvec3(0.0, 0.0, -2.2), DVec3::Z)?), 0));
    let sphere = Sphere::new(DVec3::Y, 1.0).map_err(other)?;
    scene.objects.push(Object::new("sphere", Box::new(sphere), 1));
    Ok(scene)
}

/// Three lights at one place, all turned to the sphere; out of the picture.
pub fn lamps() -> Result<[(&'static str, Emitter); 3]> {
    let c = dvec3(-2.2, 3.4, 1.6);
    let facing = dvec3(0.0, 0.6, 0.0) - c;
    let rectangle = Rectangle::facing(c, facing, 0.3, dvec2(1.6, 1.1)).map_err(other)?;
    let (w, h) = (rectangle.half_width(), rectangle.half_height());
    let corners = [c - w - h, c + w - h * 0.4, c - w * 0.2 + h * 1.5];
    let triangle = Triangle::new(corners[0], corners[1], corners[2]).map_err(other)?;
    let front = Emitter::from(triangle).faces(DVec3::ZERO);
    let [a, b, d] = corners;
    let triangle = if front { triangle } else { Triangle::new(a, d, b).map_err(other)? };
    let sphere = Sphere::new(c, 0.6).map_err(other)?;
    Ok([("rectangle", rectangle.into()), ("triangle", triangle.into()), ("sphere", sphere.into())])
}

pub fn save(lesson: &Lesson, size: Picture) -> Result {
    let shoot = |scene: &Scene, samples| render(scene, &Local::default(), Picture { samples, ..size }).image;
    let mut first = from_file(TRIANGLES, "a48_triangle_lights.scene")?;
    let both = shoot(&first, 1);
    first.lights.truncate(1);
    let one = shoot(&with_lights(first, |l| l.sampled(1, Pattern::Random)), 1);
    lesson.save_picture("triangle_one", &one,
        "A triangular light, one random point for each place (A, illustration 47): in the half shadow each pixel is lit or not, by chance. It is the mean that is right.",
        "A clay-coloured sphere on a floor; the edge of its shadow is a grain of bright and dark pixels.")?;
    lesson.save_picture("triangle_two", &both,
        "Two triangular lights, five random points each (A, illustration 48): five points make six levels of grey for each shadow, and the grain becomes finer.",
        "The same sphere with two shadows, left and right, that overlap behind it; their edges are finely grained.")?;
    let bulb = shoot(&from_file(BULB, "a124_sphere_light.scene")?, 4);
    lesson.save_picture("sphere_light", &bulb,
        "A sphere under a spherical light (A, illustration 124), 9 Sobol’ points by solid angle for each of 4 camera rays.",
        "A clay-coloured sphere on a floor before a wall, to its left a bright ball, the light; soft shadows on floor and wall.")?;
    let square = Picture { width: size.height.max(32), height: size.height.max(32), ..size };
    for (name, n, figure) in [("grid_5", 5, 30), ("grid_10", 10, 31)] {
        lesson.save(name, bands(n, figure, square)?)?;
    }
    Ok(())
}

/// Radiance in the plane of a row of pixels jumps by at least this share of the light where a column of points appears.
fn bands(n: u32, figure: u32, size: Picture) -> Result<Figure> {
    let room = |pattern| -> Result<Image> {
        let scene = from_file(ROOM, "d01_boxes_spheres.scene")?;
        let scene = with_lights(scene, |l| l.subdivided(n, n, pattern));
        Ok(render(&scene, &Local::default(), size).image)
    };
    let (fixed, jittered) = (room(Pattern::Centres)?, room(Pattern::Jittered)?);
    let s = size.width;
    let at = |share: f64| (share * s as f64) as usize;
    let panels = Panels::new()
        .columns(2)
        .title(if n == 5 {
            "25 fixed points draw steps where the half shadow should be smooth; moved at random they draw grain"
        } else {
            "100 fixed points still show their steps; jittered, the grain is nearly gone"
        })
        .subtitle(&format!("scene 1 of D, {n} × {n} points on a square of 2 × 2 m, {s} × {s} pixels; magnified: shadows on the back wall"))
        .picture(Pixels::from(&fixed), &format!("fixed grid, {n} × {n}"))
        .picture(Pixels::from(&jittered), &format!("jittered, {n} × {n}"))
        .zoom(at(0.22), at(0.41), at(0.16), at(0.16))
        .alt("Two pictures of a room with five spheres and their shadows on the back wall. Magnified, the left one shows stripes in the half shadow, the right one grain.");
    Ok(Figure::from(panels).caption(&format!(
        "Fixed points against jittered ones, after D, figure {figure}. Each place sees the same {n} columns of points; where a column vanishes behind a sphere the shadow takes a step, and eyes are made to find edges. \
         Jittered points turn the same error into noise.")))
}

/// How far a place of the floor is from umbra and from full light, as angles: `umbra < 0` inside the umbra, `lit > 0` in full light.
///
/// The sphere hides all of a flat light if it hides every corner, for its cone is convex; it hides nothing if the light's
/// polygon is farther from the axis than the cone is wide.
#[derive(Clone, Copy)]
pub struct Depth {
    pub umbra: f64,
    pub lit: f64,
}

pub fn depth(p: DVec3, corners: &[DVec3; 4], ball: (DVec3, f64)) -> Depth {
    let to = ball.0 - p;
    let (w, half) = (to.normalize(), (ball.1 / to.length()).min(1.0).asin());
    let d = corners.map(|c| (c - p).normalize());
    let between = |a: DVec3, b: DVec3| a.cross(b).length().atan2(a.dot(b));
    let farthest = d.iter().map(|c| between(w, *c)).fold(0.0, f64::max);
    let side = d[0].cross(d[1]).dot(d[2]).signum();
    let mut nearest = f64::INFINITY;
    let mut inside = true;
    for k in 0..4 {
        let (a, b) = (d[k], d[(k + 1) % 4]);
        let n = a.cross(b).normalize();
        inside &= w.dot(n) * side > 0.0;
        let over_arc = n.cross(a).dot(w) > 0.0 && b.cross(n).dot(w) > 0.0;
        nearest = nearest.min(if over_arc {
            w.dot(n).abs().min(1.0).asin()
        } else {
            between(w, a).min(between(w, b))
        });
    }
    Depth { umbra: farthest - half, lit: if inside { -half } else { nearest - half } }
}

/// The scene of the marked picture, its light's corners and its sphere.
fn marked_scene() -> Result<(Scene, [DVec3; 4], (DVec3, f64))> {
    let mut scene = stage()?;
    let view = FieldOfView::Vertical(0.5);
    scene.camera =
        Camera::new(dvec3(0.6, 5.2, 7.6), dvec3(0.55, 0.35, -0.1), DVec3::Y, view).map_err(other)?;
    let ball = (dvec3(0.0, 1.35, 0.0), 0.9);
    scene.objects = Default::default();
    let floor = Plane::new(DVec3::ZERO, DVec3::Y).map_err(other)?;
    scene.objects.push(Object::new("floor", Box::new(floor), 0));
    scene.objects.push(Object::new("ball", Box::new(Sphere::new(ball.0, ball.1).map_err(other)?), 1));
    let center = dvec3(-1.9, 5.2, 0.9);
    let rectangle =
        Rectangle::facing(center, dvec3(0.25, -1.0, -0.1), 0.0, dvec2(1.5, 1.5)).map_err(other)?;
    let light = AreaLight::new(rectangle, Emission::diffuse(Rgb::splat(16.0)));
    scene.ambient = Rgb::splat(0.09);
    scene.lights = vec![light.sampled(16, Pattern::Jittered).into()];
    Ok((scene, rectangle.corners(), ball))
}

/// What the lines were checked by: floor pixels in the umbra and in full light, and those that contradict the render.
pub struct Marked {
    pub figure: Figure,
    pub checked: [usize; 2],
    pub wrong: usize,
}

pub fn marked(size: Picture) -> Result<Marked> {
    let (scene, corners, ball) = marked_scene()?;
    let image = render(&scene, &Local::default(), size).image;
    let free = render(&scene, &Local { stage: Stage::Unshadowed, ..Local::default() }, size).image;
    let dark = scene.materials[0].diffuse * scene.ambient;
    let (w, h) = (size.width, size.height);
    let view = scene.camera.view(w, h);
    let depths: Vec<Option<Depth>> = (0..w * h)
        .map(|i| {
            let ray = view.ray(dvec2((i % w) as f64 + 0.5, (i / w) as f64 + 0.5));
            let (object, crossing) = scene.nearest(&ray, f64::INFINITY, &mut Silent)?;
            (object == 0).then(|| depth(ray.at(crossing.t), &corners, ball))
        })
        .collect();
    let (mut checked, mut wrong) = ([0, 0], 0);
    for (i, depth) in depths.iter().enumerate() {
        let Some(depth) = depth else { continue };
        // Rounding may decide on the lines themselves.
        if depth.umbra < -1.0e-9 {
            checked[0] += 1;
            wrong += usize::from(image.pixels()[i] != dark);
        } else if depth.lit > 1.0e-9 {
            checked[1] += 1;
            wrong += usize::from(image.pixels()[i] != free.pixels()[i]);
        }
    }
    let areas = floor_areas(&corners, ball);
    let shown = render(&scene, &Local::default(), Picture { samples: 4, ..size }).image;
    let figure = outlined(&shown, &depths, areas);
    Ok(Marked { figure, checked, wrong })
}

/// Areas of umbra and penumbra, by a grid of places.
fn floor_areas(corners: &[DVec3; 4], ball: (DVec3, f64)) -> [f64; 2] {
    let (n, side) = (300, 8.0);
    let cell = side / f64::from(n);
    let mut areas = [0.0; 2];
    for i in 0..n * n {
        let p = (dvec2(f64::from(i % n), f64::from(i / n)) + 0.5) * cell - side / 2.0;
        let depth = depth(dvec3(p.x + 1.0, 0.0, p.y), corners, ball);
        if depth.umbra < 0.0 {
            areas[0] += cell * cell;
        } else if depth.lit < 0.0 {
            areas[1] += cell * cell;
        }
    }
    areas
}

fn outlined(image: &Image, depths: &[Option<Depth>], areas: [f64; 2]) -> Figure {
    let title = format!(
        "Most of this shadow still sees a part of the light: umbra {:.2} m², penumbra {:.2} m²",
        areas[0], areas[1]
    );
    let heading = Heading {
        title: title.clone(),
        subtitle: "inside the inner line the ball hides all of a light of 1.5 × 1.5 m, outside the outer line none of it; lines by geometry, picture by rays".into(),
    };
    let mut d = Drawing::new(1200.0, 900.0);
    let top = heading.draw(&mut d);
    let (w, h) = (image.width(), image.height());
    let scale = 1120.0 / w as f64;
    let place = Rect::new(40.0, top, 40.0 + scale * w as f64, top + scale * h as f64);
    d.image(place, Pixels::from(image));
    let at = |p: DVec2| place.min + (p + 0.5) * scale;
    let umbra = contour(depths, w, |d| d.umbra);
    let lit = contour(depths, w, |d| d.lit);
    for (lines, ink) in [(umbra, [255, 214, 64]), (lit, [86, 180, 233])] {
        let chains: Vec<Chain> =
            lines.into_iter().map(|[a, b]| Chain { points: vec![at(a), at(b)], ends: Ends::Open }).collect();
        let dark = Some(Stroke::new(Ink::Fixed([20, 22, 28]), 5.0).faint(0.55));
        d.items.push(Item::Path { chains: chains.clone(), fill: None, stroke: dark });
        d.items.push(Item::Path { chains, fill: None, stroke: Some(Stroke::new(Ink::Fixed(ink), 2.6)) });
    }
    let mut write = |x: usize, y: usize, word: &str| {
        let text = Text::new(
            at(dvec2(x as f64, y as f64)) + dvec2(0.0, 7.0),
            word,
            22.0,
            Ink::Fixed([255, 255, 255]),
        );
        d.text(text.face(Face::Bold).anchor(Anchor::Middle));
    };
    // The deepest place of the umbra, and the middle of the half shadow to its right.
    let depth_at = |i: usize| depths[i].map_or(0.0, |d| d.umbra);
    let deepest = (0..depths.len()).fold(0, |a, b| if depth_at(b) < depth_at(a) { b } else { a });
    let (x, y) = (deepest % w, deepest / w);
    let half: Vec<usize> =
        (x..w).filter(|x| depths[y * w + x].is_some_and(|d| d.umbra > 0.0 && d.lit < 0.0)).collect();
    write(x, y, "umbra");
    write(half.get(half.len() / 2).copied().unwrap_or(x), y, "penumbra");
    d.height = place.max.y + 24.0;
    Figure::new(d, &title, "A ball above a floor under a square light. Its shadow on the floor, dark inside a yellow line marked umbra, fades out up to a blue line; between them it says penumbra.").caption(
        "Umbra and penumbra on the floor. The ball's cone, seen from a place, is convex: it hides the light if it hides the four corners, and hides nothing if it misses the polygon. Both lines follow from that; \
         no ray was asked.")
}

/// Where a value changes sign between the centres of neighbouring pixels: marching squares.
fn contour(depths: &[Option<Depth>], w: usize, value: impl Fn(&Depth) -> f64) -> Vec<[DVec2; 2]> {
    let at = |x: usize, y: usize| depths[y * w + x].as_ref().map(&value);
    let mut lines = Vec::new();
    for y in 0..(depths.len() / w).saturating_sub(1) {
        for x in 0..w - 1 {
            let ring = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)];
            let values = ring.map(|(x, y)| at(x, y));
            let crossings: Vec<DVec2> = (0..4)
                .filter_map(|k| {
                    let (a, b) = (values[k]?, values[(k + 1) % 4]?);
                    let [p, q] = [ring[k], ring[(k + 1) % 4]].map(|(x, y)| dvec2(x as f64, y as f64));
                    ((a < 0.0) != (b < 0.0)).then(|| p + (q - p) * (a / (a - b)))
                })
                .collect();
            lines.extend(crossings.chunks_exact(2).map(|c| [c[0], c[1]]));
        }
    }
    lines
}
