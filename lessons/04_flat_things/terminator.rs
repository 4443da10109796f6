//! Smooth shading of a coarse mesh, and the shadow that its facets cast on themselves.

use glam::{DVec3, dvec2, dvec3};
use lightbench::color::Rgb;
use lightbench::film::Image;
use lightbench::ray::{Hit, Ray};
use lightbench::scene::{Camera, FieldOfView};
use lightbench::shape::Shape;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::triangle::{
    Meeting, PreparedRay, Triangle, icosphere, interpolated_normal, terminator_point,
};
use lightbench_kit::figure::Panels;
use lightbench_kit::lesson::{Lesson, LessonError, Result};
use rayon::prelude::*;

const COARSE: u32 = 1; // 80 faces
const LIGHT: DVec3 = dvec3(-3.0, 3.4, 2.2); // m
const SAMPLES: usize = 3; // across a pixel

/// Which normal shades, and where the shadow ray starts.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    Facets,
    Interpolated,
    Lifted,
    Sphere,
}

const GROUND: f64 = 0.78;

struct Mesh {
    faces: Vec<Triangle>,
    ball: Sphere,
}

/// Writes the panels; returns the root mean square errors without and with the lift.
pub fn save(lesson: &Lesson) -> Result<(f64, f64)> {
    let side = lesson.pick([40, 300, 400, 640]);
    let sphere = Sphere::new(DVec3::ZERO, 1.0).map_err(|e| LessonError(e.to_string()))?;
    let faces = icosphere(COARSE).into_iter().filter_map(|[a, b, c]| Triangle::new(a, b, c).ok()).collect();
    let mesh = Mesh { faces, ball: sphere };
    let pictures =
        [Way::Facets, Way::Interpolated, Way::Lifted, Way::Sphere].map(|way| picture(&mesh, way, side));
    let [facets, plain, lifted, truth] = pictures;
    let pictures = [&facets?, &plain?, &lifted?, &truth?].map(Image::clone);
    let [before, after] = [1, 2].map(|i| error_inside(&pictures[i], &pictures[3]));
    let labels = [
        "one normal a facet".to_string(),
        format!("interpolated normals: RMSE {before:.4}"),
        format!("shadow ray lifted: RMSE {after:.4}"),
        "the sphere that is meant".to_string(),
    ];
    let panels =
        pictures.iter().zip(&labels).fold(Panels::new(), |p, (image, label)| p.picture(image.into(), label));
    let zoom = side / 4;
    let panels = panels
        .title("Interpolated normals leave a jagged terminator; lifting the shadow ray's origin mends it")
        .subtitle(
            "80 triangles, one point light, cosine shading with shadow rays; after A §2.1, and Hanika (2021)",
        )
        .columns(4)
        .zoom(side * 17 / 100, side * 52 / 100, zoom, zoom);
    lesson.save("terminator", panels)?;
    Ok((before, after))
}

fn picture(mesh: &Mesh, way: Way, side: usize) -> Result<Image> {
    let view = FieldOfView::Vertical(0.46);
    let camera = Camera::new(dvec3(0.0, 0.0, 5.0), DVec3::ZERO, DVec3::Y, view)
        .map_err(|e| LessonError(e.to_string()))?;
    let pixel = |k: usize| {
        let corner = dvec2((k % side) as f64, (k / side) as f64);
        let sample = |i: usize| {
            let within = dvec2((i % SAMPLES) as f64, (i / SAMPLES) as f64) + 0.5;
            radiance(mesh, way, &camera.ray(corner + within / SAMPLES as f64, side, side))
        };
        Rgb::splat(1.0) * ((0..SAMPLES * SAMPLES).map(sample).sum::<f64>() / (SAMPLES * SAMPLES) as f64)
    };
    Ok(Image::from_pixels(side, side, (0..side * side).into_par_iter().map(pixel).collect()))
}

/// Root mean square of the difference where both pictures are dark: round the terminator, inside both outlines.
fn error_inside(picture: &Image, truth: &Image) -> f64 {
    let inside = picture.pixels().iter().zip(truth.pixels()).filter(|(a, b)| a.x.max(b.x) < 0.5);
    let (sum, count) = inside.fold((0.0, 0), |(sum, n), (a, b)| (sum + (a.x - b.x).powi(2), n + 1));
    (sum / f64::from(count.max(1))).sqrt()
}

/// Cosine to the light where it is seen, over a pale ground.
fn radiance(mesh: &Mesh, way: Way, ray: &Ray) -> f64 {
    const AMBIENT: f64 = 0.05;
    let found = if way == Way::Sphere { on_ball(mesh, ray) } else { on_mesh(mesh, way, ray) };
    let Some((n, start)) = found else { return GROUND };
    let to_light = LIGHT - start.point;
    let cosine = n.dot(to_light.normalize());
    let shadow = Ray::new(start.origin_towards(to_light), to_light);
    let is_lit = cosine > 0.0 && (way == Way::Sphere || !mesh.faces.iter().any(|f| f.blocks(&shadow, 1.0)));
    AMBIENT + if is_lit { 0.9 * cosine } else { 0.0 }
}

fn on_ball(mesh: &Mesh, ray: &Ray) -> Option<(DVec3, Hit)> {
    let crossing = mesh.ball.nearest(ray, 0.0, f64::INFINITY)?;
    let hit = mesh.ball.hit(ray, &crossing);
    Some((hit.ng, hit))
}

/// The shading normal, and the hit from which the shadow ray leaves.
fn on_mesh(mesh: &Mesh, way: Way, ray: &Ray) -> Option<(DVec3, Hit)> {
    let prepared = PreparedRay::new(ray);
    let near = |face: &Triangle| -> Option<Meeting> { face.meet(&prepared).filter(|m| m.t > 0.0) };
    let all = mesh.faces.iter().filter_map(|f| near(f).map(|m| (f, m)));
    let (face, m) = all.min_by(|a, b| a.1.t.total_cmp(&b.1.t))?;
    let hit = face.describe(&m, &lightbench::ray::Crossing::new(m.t, 0));
    // The normals of the sphere: its corners are unit vectors.
    let n = interpolated_normal(m.b, face.corners())?;
    Some(match way {
        Way::Facets | Way::Sphere => (hit.ng, hit),
        Way::Interpolated => (n, hit),
        // The lifted point lies on the surface that is meant, and leaves it along that one's normal.
        Way::Lifted => {
            let point = terminator_point(m.b, face.corners(), face.corners());
            (n, Hit { point, ng: n, ..hit })
        }
    })
}
