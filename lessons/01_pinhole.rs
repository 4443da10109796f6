//! Lesson 01. How does a hole make a picture, and why do we trace light backwards?
//!
//! Builds on:  nothing. Start here.
//! New here:   the camera obscura and its window; raster, NDC, screen, camera and world space; forward against
//!             backward tracing of one pixel, against a closed form.
//! Notation:   E irradiance of the film [W m⁻²], L radiance of the lamp [W m⁻² sr⁻¹], Ω solid angle [sr], α field of view.
//! Predict:    a lamp throws a million photons at a box with a hole of 2 cm, 1 m away. How many come in?
//! Figure:     01_pinhole_error_over_rays_time.svg

#[path = "01_pinhole/charts.rs"]
mod charts;
#[path = "01_pinhole/obscura.rs"]
mod obscura;
#[path = "01_pinhole/spaces.rs"]
mod spaces;
#[path = "01_pinhole/stage.rs"]
mod stage;

use glam::{DVec2, DVec3, Vec3Swizzles, dvec2};
use lightbench::film::Image;
use lightbench::kit::lesson::{Lesson, Result};
use lightbench::measure::{self, Method, Series};
use lightbench::sample::{Sampler, cosine_hemisphere, point2, uniform_disc, uniform_sphere};
use lightbench::scene::pinhole::{coaxial_discs_share, hole_solid_angle, obscura_line, shadow_blur};
use lightbench::scene::{Camera, FieldOfView, camera_from_screen, ndc_from_raster, screen_from_ndc};
use std::f64::consts::{PI, TAU};

const DEPTH: f64 = 0.1; // m, from the hole to the film
const DISTANCE: f64 = 1.0; // m, from the lamp to the hole
const HOLE: f64 = 0.01; // m, its radius
const PIXEL: f64 = 0.01; // m, radius of the round patch of film that we want to know
const LAMP: f64 = 0.25; // m, radius of a matt shining disc, wide enough to fill what the pixel sees
const RADIANCE: f64 = 1.0; // W m⁻² sr⁻¹
const PHOTONS: u32 = 1_000_000; // of a bare bulb in the lamp's place
const HOLES: [f64; 7] = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0]; // m, diameters; the first expects 6 photons
const REPETITIONS: u32 = 16; // an RMS error over 16 runs scatters by 1/√32 ≈ 18 %
const PICTURE: (usize, usize) = (210, 150); // 7 : 5, as B's little picture

fn main() -> Result {
    let lesson = Lesson::open(1)?;

    // 1. The truth: a pixel's way through four spaces, and two closed forms for light through a hole.
    spaces_of_one_pixel(&lesson);
    let passing = HOLES.map(|hole| f64::from(PHOTONS) * hole_solid_angle(0.5 * hole, DISTANCE) / (2.0 * TAU));
    let irradiance = PI * RADIANCE * coaxial_discs_share(PIXEL, HOLE, DEPTH);

    // 2. The contestants: follow light from the lamp, or ask from the film where it comes from; blind, or at the hole.
    let counted = photons_through(lesson.seed());
    let sweep = |first, last, sample: fn(Sampler) -> f64| {
        measure::sweep(&lesson.budgets(first..=last), REPETITIONS, irradiance, |rays, run| {
            let of = |i| sample(Sampler::new(lesson.seed(), u64::from(run), i));
            (0..rays).map(of).sum::<f64>() / f64::from(rays)
        })
    };
    let methods: [(Method, Series); 4] = [
        (Method::new("forward, blind"), sweep(14, 20, forward)),
        (Method::new("forward, at the hole"), sweep(8, 16, forward_at_hole)),
        (Method::new("backward, blind"), sweep(10, 18, backward)),
        (Method::default_of("backward, at the hole"), sweep(4, 14, backward_at_hole)),
    ];
    let (film, window) = (film_picture(), window_picture());

    // 3. The figures: the documents' diagrams, the pictures, the charts.
    charts::diagrams(&lesson)?;
    charts::pictures(&lesson, &film, &window)?;
    charts::holes(&lesson, &counted, &passing)?;
    charts::contest(&lesson, &methods)?;
    charts::wide_angles(&lesson)?;

    // 4. What the figures show, checked.
    let odds = |i: usize| passing[i] / f64::from(PHOTONS);
    let tolerance = |i: usize| measure::statistical((odds(i) * (1.0 - odds(i))).sqrt(), PHOTONS.into());
    let share = |i: usize| counted[i] as f64 / f64::from(PHOTONS);
    let all = (0..HOLES.len()).all(|i| measure::agrees(share(i), odds(i), tolerance(i)));
    lesson.claim("what passes a hole is its share of the sphere, Ω/4π, for holes from 1 cm to 1 m", all);
    let turned = |i: usize| window.pixels()[window.pixels().len() - 1 - i];
    let apart = film.pixels().iter().enumerate().map(|(i, p)| (*p - turned(i)).abs().max_element());
    let differing = apart.filter(|d| *d > measure::rounding(100, 1.0)).count();
    lesson.claim("the film's picture is the window's, turned by 180°, in every pixel", differing == 0);
    let slopes = methods.iter().map(|(_, series)| measure::log_slope(series, REPETITIONS));
    lesson.claim(
        "four times the rays halve the error of all four",
        slopes.into_iter().all(|s| s.agrees_with(-0.5)),
    );
    let rays = |k: usize| charts::rays_to(&methods[k].1, 0.01);
    lesson.answer(&format!(
        "through a hole every film point sees one direction only, so the picture stands upside down; of {PHOTONS} photons \
         {} pass a hole of 2 cm ({:.1} expected), and to know one pixel to 1 % takes {:.1e} photons forwards but {:.0} \
         rays backwards, because from the film we aim at the hole and every ray counts.",
        counted[1], passing[1], rays(0), rays(3).ceil()
    ))
}

/// One pixel of B's picture of 7 × 5, from the raster to a ray in the world.
fn spaces_of_one_pixel(lesson: &Lesson) {
    let (size, fov) = (dvec2(7.0, 5.0), FieldOfView::Vertical(90f64.to_radians()));
    let raster = dvec2(0.5, 0.5); // the centre of the upper left pixel
    let ndc = ndc_from_raster(raster, size);
    let screen = screen_from_ndc(ndc, size.x / size.y, fov);
    let p = camera_from_screen(screen);
    let d = p.normalize();
    lesson.say(&format!(
        "A picture of 7 × 5 pixels, 90° at distance 1, aspect 7/5 = {}. The centre of its first pixel is\n  {} in \
         raster space,\n  {} in NDC,\n  {} on the screen, after aspect and tan 45° = 1,\n  ({}, {}, {}) in camera \
         space,\nand its ray leaves the origin along ({:.3}, {:.3}, {:.3}).",
        size.x / size.y, spaces::pair(raster), spaces::pair(ndc), spaces::pair(screen), p.x, p.y, p.z, d.x, d.y, d.z
    ));
}

/// Photons of a bare bulb on the axis that pass each of the [`HOLES`].
fn photons_through(seed: u64) -> [u64; HOLES.len()] {
    let mut counted = [0; HOLES.len()];
    for i in 0..PHOTONS {
        let w = uniform_sphere(point2(seed, u32::MAX, i)); // a run of its own
        let off_axis = DISTANCE * w.xy().length() / w.z;
        for (count, hole) in counted.iter_mut().zip(HOLES) {
            *count += u64::from(w.z > 0.0 && off_axis <= 0.5 * hole);
        }
    }
    counted
}

/// E from one photon that leaves the lamp anywhere, in any direction.
fn forward(mut dice: Sampler) -> f64 {
    let (lamp, w) = (LAMP * uniform_disc(dice.next_2d()), cosine_hemisphere(dice.next_2d()));
    let (hole, film) = (lamp + w.xy() / w.z * DISTANCE, lamp + w.xy() / w.z * (DISTANCE + DEPTH));
    let arrives = hole.length() < HOLE && film.length() < PIXEL;
    if arrives { PI * RADIANCE * (LAMP / PIXEL).powi(2) } else { 0.0 }
}

/// E from one photon that leaves the lamp anywhere, for some point of the hole.
fn forward_at_hole(mut dice: Sampler) -> f64 {
    let (lamp, hole) = (LAMP * uniform_disc(dice.next_2d()), HOLE * uniform_disc(dice.next_2d()));
    let film = hole + (hole - lamp) * (DEPTH / DISTANCE);
    let flux = RADIANCE * PI * LAMP * LAMP * PI * HOLE * HOLE * cos4_over_square(hole - lamp, DISTANCE);
    if film.length() < PIXEL { flux / (PI * PIXEL * PIXEL) } else { 0.0 }
}

/// E from one ray that leaves the pixel anywhere, in any direction.
fn backward(mut dice: Sampler) -> f64 {
    let (film, w) = (PIXEL * uniform_disc(dice.next_2d()), cosine_hemisphere(dice.next_2d()));
    let (hole, lamp) = (film + w.xy() / w.z * DEPTH, film + w.xy() / w.z * (DEPTH + DISTANCE));
    if hole.length() < HOLE && lamp.length() < LAMP { PI * RADIANCE } else { 0.0 }
}

/// E from one ray that leaves the pixel anywhere, for some point of the hole.
fn backward_at_hole(mut dice: Sampler) -> f64 {
    let (film, hole) = (PIXEL * uniform_disc(dice.next_2d()), HOLE * uniform_disc(dice.next_2d()));
    let lamp = hole + (hole - film) * (DISTANCE / DEPTH);
    let e = RADIANCE * PI * HOLE * HOLE * cos4_over_square(hole - film, DEPTH);
    if lamp.length() < LAMP { e } else { 0.0 }
}

/// `cos θ cos θ′ / r²` between two parallel planes: `cos⁴θ / depth²`.
fn cos4_over_square(aside: DVec2, depth: f64) -> f64 {
    (depth / (depth * depth + aside.length_squared())).powi(2)
}

/// Half the width and height of the film [m].
fn film_half() -> DVec2 {
    DVec2::new(0.7, 0.5) * DEPTH
}

/// The film of a box with a hole without width, as somebody inside sees it who looks towards the scene.
fn film_picture() -> Image {
    let size = dvec2(PICTURE.0 as f64, PICTURE.1 as f64);
    Image::from_fn(PICTURE.0, PICTURE.1, |i, j| {
        let ndc = ndc_from_raster(dvec2(i as f64, j as f64) + 0.5, size);
        let film = film_half() * dvec2(2.0 * ndc.x - 1.0, 1.0 - 2.0 * ndc.y);
        let (_, direction) = obscura_line(film, DVec2::ZERO, DEPTH);
        stage::radiance(DVec3::ZERO, direction)
    })
}

/// The same picture by a camera: the film stands before the hole, at distance 1.
fn window_picture() -> Image {
    let fov = FieldOfView::Vertical(2.0 * (film_half().y / DEPTH).atan());
    let camera = Camera::new(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, fov).expect("a camera in its place");
    Image::from_fn(PICTURE.0, PICTURE.1, |i, j| {
        let ray = camera.ray(dvec2(i as f64, j as f64) + 0.5, PICTURE.0, PICTURE.1);
        stage::radiance(ray.origin, ray.direction)
    })
}
