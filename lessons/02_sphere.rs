//! Lesson 02. Which of three formulas for a ray and a sphere survives distance, and what does it cost?
//!
//! Builds on:  01 (a pixel becomes a ray).
//! New here:   the sphere by three formulas; errors measured against a truth; speed against accuracy.
//! Notation:   f from the centre to the ray's origin [m], d unit direction, r radius [m], D = |f|; u = 2⁻⁵³.
//! Read next:  src/shape/sphere/method.rs, src/shape/sphere/reference.rs
//! Figure:     02_sphere_stability.svg

use glam::DVec3;
use lightbench::measure::{Method, Point, Ratio, Series, Tally, log_slope};
use lightbench::num::gamma;
use lightbench::num::real::{Real, Triple};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::sphere::method::{Pair, algebraic, geometric, in_front, robust};
use lightbench_kit::figure::short;
use lightbench_kit::lesson::{Lesson, Result};
use std::cell::LazyCell;

#[path = "02_sphere/diagrams.rs"]
mod diagrams;
#[path = "02_sphere/figures.rs"]
mod figures;
#[path = "02_sphere/work.rs"]
mod work;
use figures::{Contest, between, error_at};
use work::{judge, losses, rounded, savings};

const RADIUS: f64 = 1.0; // m
const WIDEST: f64 = 0.9; // largest distance of a ray from the centre [radii]: nearer the rim the question itself is ill-conditioned
const HALF_DECADES: std::ops::RangeInclusive<i32> = 1..=16; // distance/radius = 10^(k/2)
const FAR: i32 = 6; // the distance that the text speaks of is 10⁶ radii

/// A ray by its vector f and its direction d.
pub type Ray<R> = (Triple<R>, Triple<R>);

fn main() -> Result {
    let lesson = Lesson::open(2, include_str!("02_sphere.md"))?;
    let rays = lesson.pick([64, 512, 4096, 16384]);

    // 1. The truth is part of the question: rays whose intersections are known beyond f64 (see `work::judge`).
    let sets = LazyCell::new(|| ray_sets(lesson.seed(), rays));

    // 2. The contestants: three formulas in two precisions.
    let contest = LazyCell::new(|| -> Contest {
        vec![
            (Method::default_of("robust, f64").styled(0), errors(&sets, robust::<f64>)),
            (Method::new("closest approach, f64").styled(1), errors(&sets, geometric::<f64>)),
            (Method::new("quadratic formula, f64").styled(2), errors(&sets, algebraic::<f64>)),
            (Method::new("robust, f32").styled(4), errors(&sets, robust::<f32>)),
            (Method::new("closest approach, f32").styled(3), errors(&sets, geometric::<f32>)),
            (Method::new("quadratic formula, f32").styled(5), errors(&sets, algebraic::<f32>)),
        ]
    });
    let of = |name: &str| figures::of(&contest, name);
    let costs = LazyCell::new(|| savings(lesson.seed()));

    // 3. The figures, and the numbers that the essay quotes.
    lesson.figure("triangle", || Ok(diagrams::triangle()))?;
    lesson.figure("normals", || Ok(figures::normals(lesson.pick([48, 320, 420, 420]))))?;
    lesson.figure("stability", || Ok(figures::stability(&contest, rays)))?;
    lesson.figure("speed_accuracy", || Ok(figures::speed_accuracy(&contest, &costs)))?;
    lesson.table("costs", || Ok(figures::costs(&costs)))?;
    lesson.table("as_printed", || Ok(figures::as_printed(&losses(lesson.seed(), rays))))?;
    diagrams::of_the_documents(&lesson)?;

    let radii = |name: &str| short(error_at(of(name), FAR));
    lesson.value("robust_far", || radii("robust, f64"));
    lesson.value("quadratic_far", || radii("quadratic formula, f64"));
    lesson.value("robust_f32_far", || radii("robust, f32"));
    lesson.value("gain", || {
        short(error_at(of("quadratic formula, f64"), FAR) / error_at(of("robust, f64"), FAR))
    });
    lesson.value("rays", || rays);
    lesson.value("quadratic_work", || format!("{:.1}", costs.quadratic.operations));
    lesson.value("robust_work", || format!("{:.1}", costs.robust.operations));
    lesson.value("time", || slower(lesson.seed()).words(1.0));
    lesson.value("first_lost", || figures::first_failure(of("quadratic formula, f32")));
    lesson.value("slope_robust", || format!("{:.2}", slope(of("robust, f64"))));
    lesson.value("slope_quadratic", || format!("{:.2}", slope(of("quadratic formula, f64"))));

    // 4. What the figures show, checked.
    lesson.claim("in f64 the error grows with the distance by the robust formula, with its square by the quadratic formula", || {
        // A root mean square over n rays scatters by 1/√(2n) ≤ 0.09; 6 σ at both ends of four decades: 0.083.
        (slope(of("robust, f64")) - 1.0).abs() < 0.1 && (slope(of("quadratic formula, f64")) - 2.0).abs() < 0.1
    });
    lesson.claim("up to 10⁸ radii the robust formula in f64 loses no ray and errs by less than 19 roundings of the distance", || {
        // 4 roundings of f·f, 5 of q, one of the quotient: 11 u D with t's own; and 2√3 u D across the ray, 2.06 times
        // as much along it at 0.9 r: 19 u D in all.
        let bound = |p: &Point| p.failures.total() == 0 && p.error.is_some_and(|e| e.high <= gamma(19) * p.parameter);
        of("robust, f64").points.iter().all(bound)
    });
    lesson.claim(
        "up to 10⁵ radii the robust formula in f32 answers every ray rightly, the quadratic formula does not",
        || {
            let lost = |name| between(of(name), 1.0, 1.0e5).failures().total();
            lost("quadratic formula, f32") > 0 && lost("robust, f32") == 0
        },
    );
    lesson.close()
}

/// Sets of rays, each from one distance.
fn ray_sets(seed: u64, rays: u32) -> Vec<(f64, Vec<Ray<f64>>)> {
    HALF_DECADES
        .map(|k| 10f64.powi(k / 2) * if k % 2 == 0 { 1.0 } else { 10f64.sqrt() })
        .map(|distance| (distance, aimed(seed, rays, distance, WIDEST)))
        .collect()
}

/// Rays towards a sphere at the origin, at random points of a disc of `widest` radii across them.
pub fn aimed(seed: u64, count: u32, distance: f64, widest: f64) -> Vec<Ray<f64>> {
    let ray = |i| {
        let mut sampler = Sampler::new(seed, distance.to_bits(), i);
        let (direction, [share, turn]) = (uniform_sphere(sampler.next_2d()), sampler.next_2d().to_array());
        passing(direction, distance, widest * share.sqrt(), turn)
    };
    (0..count).map(ray).collect()
}

/// A ray along `direction` from `distance` radii away that passes the centre `impact` radii off.
fn passing(direction: DVec3, distance: f64, impact: f64, turn: f64) -> Ray<f64> {
    let (right, up) = direction.any_orthonormal_pair();
    let (sin, cos) = (turn * std::f64::consts::TAU).sin_cos();
    let back = (distance * distance - impact * impact).max(0.0).sqrt();
    let f = (right * cos + up * sin) * impact - direction * back;
    ((f * RADIUS).to_array(), direction.to_array())
}

/// Errors and failures of one formula over all sets of rays.
fn errors<R: Real>(
    sets: &[(f64, Vec<Ray<f64>>)],
    solve: impl Fn(Triple<R>, Triple<R>, R) -> Pair<R>,
) -> Series {
    let point = |(distance, rays): &(f64, Vec<Ray<f64>>)| {
        let mut tally = Tally::new();
        for (f, d) in rays.iter().map(rounded) {
            judge(&mut tally, (f, d), in_front(solve(f, d, R::from_f64(RADIUS))));
        }
        tally.rms_at(*distance)
    };
    Series::new(sets.iter().map(point).collect())
}

/// How the error grows with the distance: its power, from 10² to 10⁶ radii.
fn slope(series: &Series) -> f64 {
    log_slope(&between(series, 1.0e2, 1.0e6), 1).value
}

/// How many times as long the robust formula takes as the quadratic one, over the same rays.
fn slower(seed: u64) -> Ratio {
    let rays = aimed(seed, 1024, 100.0, std::f64::consts::SQRT_2);
    let sum = |solve: fn(Triple<f64>, Triple<f64>, f64) -> Pair<f64>| -> f64 {
        rays.iter().filter_map(|&(f, d)| in_front(solve(f, d, RADIUS))).sum()
    };
    Ratio::measured(|| sum(robust), || sum(algebraic))
}
