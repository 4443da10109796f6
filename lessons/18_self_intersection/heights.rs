//! How high over a sphere the starts lie, and how deep under it the computed points.

use super::bodies::{AWAY, bodies};
use glam::DVec3;
use lightbench::measure::{Method, Spread, log_spaced};
use lightbench::num::double_double::DoubleDouble;
use lightbench::num::{U, gamma};
use lightbench::ray::Hit;
use lightbench::ray::leaving::{Departure, Leaving};
use lightbench::sample::Sampler;
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, short};
use lightbench_kit::lesson::{LessonError, Result};

/// Height over a sphere of radius 1, decided with 106 bits.
fn height(p: DVec3, center: DVec3) -> f64 {
    let squares = |i: usize| DoubleDouble::difference(p[i], center[i]).square();
    0.5 * (squares(0) + squares(1) + squares(2) - DoubleDouble::of(1.0)).value()
}

/// pbrt's start over a sphere that was moved from the origin, with pbrt's bound per axis: 5 roundings on the sphere, 3 on the way
/// to its place.
fn origin_by_pbrt(hit: &Hit, center: DVec3) -> DVec3 {
    let local = (hit.point - center).abs();
    let error = local * gamma(5) * (1.0 + gamma(3)) + (local + center.abs()) * gamma(3);
    hit.point + hit.ng * hit.ng.abs().dot(error)
}

/// What was measured at one distance from the world's origin.
pub struct Heights {
    distance: f64,
    /// Of the lowest computed point, under the surface.
    depth: f64,
    /// Median start of the error bound, pbrt's own, the integer offset, B's bias.
    ways: [f64; 4],
    /// The lowest start of the error bound.
    lowest: f64,
}

impl Heights {
    /// The lowest start's height over the lowest point's depth.
    pub fn margin(&self) -> f64 {
        self.lowest / self.depth
    }

    /// How many times as high as by pbrt's bound.
    pub fn over_pbrt(&self) -> f64 {
        self.ways[0] / self.ways[1]
    }
}

pub fn measured(seed: u64, starts: u32) -> Result<Vec<Heights>> {
    log_spaced(1.0, 1.0e10, 11).into_iter().map(|distance| at(seed, starts, distance)).collect()
}

fn at(seed: u64, starts: u32, distance: f64) -> Result<Heights> {
    let sphere = &bodies(1.0, distance).map_err(|e| LessonError(e.to_string()))?[0];
    let center = AWAY * distance;
    let (mut depth, mut ways) = (0.0f64, [const { Vec::new() }; 4]);
    for start in (0..starts).filter_map(|i| sphere.start(&mut Sampler::new(seed, 9, i))) {
        let way = Departure { arriving: start.arriving, side: start.side, leaving: start.side };
        let of = |leaving: Leaving| leaving.origin(&start.hit, &way);
        let origins = [
            of(Leaving::ErrorBound),
            origin_by_pbrt(&start.hit, center),
            of(Leaving::Integer),
            of(Leaving::AlongNormal(1.0e-4)),
        ];
        depth = depth.max(-height(start.hit.point, center));
        for (all, origin) in ways.iter_mut().zip(origins) {
            all.push(height(origin, center));
        }
    }
    let lowest = ways[0].iter().copied().fold(f64::INFINITY, f64::min);
    let ways = ways.map(|all| Spread::median(&all).map_or(f64::NAN, |s| s.mid));
    Ok(Heights { distance, depth, ways, lowest })
}

pub fn figure(found: &[Heights], starts: u32) -> Figure {
    let line = |of: &dyn Fn(&Heights) -> f64| found.iter().map(|h| (h.distance, of(h))).collect::<Vec<_>>();
    let way = |k: usize| line(&|h| h.ways[k]);
    let least = found.iter().map(Heights::margin).fold(f64::INFINITY, f64::min);
    let chart = Chart::new(Axis::log("distance from the world's origin, radii"), Axis::log("height, radii"))
        .title("Errors grow with the distance from the origin, and so must the start; a fixed bias does not")
        .subtitle(&format!(
            "a sphere of radius 1 m, {starts} hits at each distance; heights with 106 bits, medians of starts"
        ))
        .guide(Guide::slope_through(1.0, 1.0, U, "u × distance"))
        .curve(Method::default_of("error bound").styled(0), &way(0))
        .curve(Method::new("pbrt with its own bound").styled(1), &way(1))
        .curve(Method::new("256 last places").styled(2), &way(2))
        .curve(Method::new("B: 10⁻⁴ m along n").styled(4), &way(3))
        .curve(Method::new("depth of the lowest computed point").styled(5), &line(&|h| h.depth));
    let over_pbrt = found.iter().map(Heights::over_pbrt).fold(0.0, f64::max);
    let of_bias = |h: &Heights| short(h.ways[3] / h.depth);
    let [first, last] = [found.first(), found.last()].map(|h| h.map_or(String::new(), of_bias));
    Figure::from(chart).caption(&format!(
        "How far off the surface rays start, and how far under it the computed points lie. The lowest start of the default still lies \
         {least:.1} times as high as the lowest point lies deep, at every distance. It is up to {over_pbrt:.1} times as high as with pbrt's \
         bound for a sphere, which counts 5 roundings instead of 12 and each axis by itself. B's bias is {first} errors high at the left and {last} at \
         the right."
    ))
}
