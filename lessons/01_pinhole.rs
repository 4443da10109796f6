//! Lesson 01. How does a hole make a picture, and why do we trace light backwards?
//!
//! Builds on:  nothing. Start here.
//! New here:   the camera obscura and its window; raster, NDC, screen, camera and world space; forward
//!             against backward tracing of one pixel, against a closed form.
//! Notation:   E irradiance of the film [W m⁻²], Ω solid angle [sr], α field of view.
//! Predict:    a lamp throws a million photons at a box with a hole of 2 cm, 1 m away. How many come in?
//! Figure:     01_pinhole_error_over_rays_time.svg

#[path = "01_pinhole/charts.rs"]
mod charts;
#[path = "01_pinhole/obscura.rs"]
mod obscura;
#[path = "01_pinhole/photons.rs"]
mod photons;
#[path = "01_pinhole/spaces.rs"]
mod spaces;
#[path = "01_pinhole/stage.rs"]
mod stage;

use glam::{DVec2, Vec3Swizzles};
use lightbench::measure::{self, Method};
use lightbench::num::statistics::Moments;
use lightbench::sample::{Sampler, cosine_hemisphere, uniform_disc};
use lightbench::scene::pinhole::{coaxial_discs_share, hole_solid_angle};
use lightbench_kit::figure::{grouped, short};
use lightbench_kit::lesson::{Lesson, Result};
use std::f64::consts::{PI, TAU};
use std::ops::RangeInclusive;

const DEPTH: f64 = 0.1; // m, from the hole to the film
const DISTANCE: f64 = 1.0; // m, from the lamp to the hole
const HOLE: f64 = 0.01; // m, its radius
const PIXEL: f64 = 0.01; // m, radius of the round patch of film that we want to know
const LAMP: f64 = 0.25; // m, radius of a matt shining disc, wide enough to fill what the pixel sees
const RADIANCE: f64 = 1.0; // W m⁻² sr⁻¹
const PHOTONS: u32 = 1_000_000; // of a bare bulb in the lamp's place
const HOLES: [f64; 7] = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0]; // m, diameters; the first expects 6 photons
const REPETITIONS: u32 = 16; // an RMS error over 16 runs scatters by 1/√32 ≈ 18 %

/// An estimate of the irradiance from one photon or ray.
type Estimator = fn(Sampler) -> f64;

fn main() -> Result {
    let lesson = Lesson::without_essay(1)?;

    // 1. The truth: a pixel's way through four spaces, and two closed forms for light through a hole.
    lesson.say(&spaces::of_one_pixel());
    let passing = HOLES.map(|hole| f64::from(PHOTONS) * hole_solid_angle(0.5 * hole, DISTANCE) / (2.0 * TAU));
    let irradiance = PI * RADIANCE * coaxial_discs_share(PIXEL, HOLE, DEPTH);

    // 2. The contestants: follow light from the lamp, or ask from the film; blind, or aimed at the hole.
    let counted = photons::through(lesson.seed());
    let contest = |(method, budgets, sample): (Method, _, Estimator)| {
        let mut answers = Vec::new();
        let series = measure::sweep(&lesson.budgets(budgets), REPETITIONS, irradiance, |rays, run| {
            let index = u64::from(rays) << 32 | u64::from(run); // budgets share no ray
            let of = |i| sample(Sampler::new(lesson.seed(), index, i));
            answers.push((0..rays).map(of).sum::<f64>() / f64::from(rays));
            answers[answers.len() - 1]
        });
        let largest = answers.into_iter().rev().take(REPETITIONS as usize);
        ((method, series), largest.collect::<Moments>())
    };
    let contestants: [(Method, RangeInclusive<u32>, Estimator); 4] = [
        (Method::new("forward, blind"), 14..=18, forward),
        (Method::new("forward, at the hole"), 8..=16, forward_at_hole),
        (Method::new("backward, blind"), 10..=16, backward),
        (Method::default_of("backward, at the hole"), 4..=14, backward_at_hole),
    ];
    let (methods, answers): (Vec<_>, Vec<_>) = contestants.map(contest).into_iter().unzip();
    let (film, window) = (stage::on_film(), stage::in_window());

    // 3. The figures: the documents' diagrams, the pictures, the charts.
    charts::diagrams(&lesson)?;
    charts::pictures(&lesson, &film, &window)?;
    charts::holes(&lesson, &counted)?;
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
    let right = answers.iter().all(|runs| {
        let (mean, error) = (runs.mean().unwrap_or(f64::NAN), runs.standard_error().unwrap_or(f64::NAN));
        measure::agrees(mean, irradiance, measure::statistical(error, 1))
    });
    let slope = |(_, series): &(_, _)| measure::log_slope(series, REPETITIONS);
    let halve = methods.iter().map(slope).all(|s| s.agrees_with(-0.5));
    let sentence =
        "all four find the irradiance of the closed form, and four times the rays halve their error";
    lesson.claim(sentence, right && halve);
    let rays = |k: usize| charts::rays_to(&methods[k].1, 0.01);
    lesson.answer(&format!(
        "through a hole every point of the film sees one direction only, so the picture stands upside \
         down; of {} photons {} pass a hole of 2 cm ({:.1} expected), and to know one pixel to 1 % takes {} \
         photons forwards ({} if all are aimed at the hole) but {:.0} rays backwards: they start where we \
         look, and every one counts.",
        grouped(PHOTONS.into()),
        counted[1],
        passing[1],
        short(rays(0)),
        short(rays(1)),
        rays(3).ceil()
    ))
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
