//! The rays, the sets, and how far the hits of one lie from those of another.

use super::charts::Way;
use super::{BAILOUT, PLAIN, VIEWED};
use lightbench::measure::{Point, Tally, time_each};
use lightbench::ray::Ray;
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::sdf::julia::{Julia, JuliaMethod};
use lightbench::shape::Shape;
use lightbench_kit::lesson::{LessonError, Result};

/// Where rays set out [m from the middle], and how far from the middle they aim.
pub const FROM: f64 = 4.0;
const AIM: f64 = 1.1;

/// Rays from a sphere about the set towards places in it and beside it.
pub fn rays(seed: u64, count: u32) -> Vec<Ray> {
    let ray = |i| {
        let mut sampler = Sampler::new(seed, 9, i);
        let origin = uniform_sphere(sampler.next_2d()) * FROM;
        let target = uniform_sphere(sampler.next_2d()) * (AIM * sampler.next_1d().cbrt());
        Ray::new(origin, (target - origin).normalize())
    };
    (0..count).map(ray).collect()
}

pub fn set(iterations: u32, method: JuliaMethod) -> Result<Julia> {
    let julia = Julia::new(VIEWED, iterations, BAILOUT, 0.0).map_err(|e| LessonError(e.to_string()))?;
    Ok(julia.with_method(method))
}

pub fn hit(julia: &Julia, ray: &Ray) -> Option<f64> {
    julia.nearest(ray, 0.0, f64::INFINITY).map(|crossing| crossing.t)
}

/// How far the hits of a way after `n` steps lie from those of the endless set, where both are hit; and the time of a ray.
pub fn moved(rays: &[Ray], truth: &[Option<f64>], way: Way, n: f64) -> Point {
    let Ok(julia) = set(n as u32, way.julia_method()) else { return Point::at(n) };
    let mut tally = Tally::new();
    for (ray, truth) in rays.iter().zip(truth) {
        if let (Some(t), Some(truth)) = (hit(&julia, ray), truth) {
            tally.error(t - truth);
        }
    }
    let some = rays.len().min(256);
    let time = time_each(some, || rays[..some].iter().filter_map(|ray| hit(&julia, ray)).count());
    tally.median_at(n).timed(time)
}

/// How far the hits of a march lie from those of the certified method on the same surface, which it misses, and how often it looks.
pub fn missed(rays: &[Ray], truth: &[Option<f64>], way: Way, tolerance: f64) -> Point {
    let Ok(julia) = set(PLAIN, way.julia_method()) else { return Point::at(tolerance) };
    let (mut tally, mut looks) = (Tally::new(), 0u64);
    for (ray, truth) in rays.iter().zip(truth) {
        let found = julia.walk_by_estimate(ray, |_| looks += 1);
        match (found, truth) {
            (Some(t), Some(truth)) => tally.error(t - truth),
            _ => tally.answer(found, *truth),
        }
    }
    tally.median_at(tolerance).worked(looks as f64 / rays.len() as f64)
}
