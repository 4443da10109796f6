//! A sphere in single precision throughout, as graphics cards compute: where the integer offset comes from.

use super::bodies::{AWAY, Lamp, Truth, lamps};
use super::contest::{Budget, Score};
use glam::DVec3;
use lightbench::frame::duff;
use lightbench::num::real::{Real, Triple, along, dot};
use lightbench::ray::leaving::integer_offset_single;
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::sphere::method::{in_front, robust};

/// Ways to leave, in `f32`.
#[derive(Clone, Copy, PartialEq)]
pub enum Rule {
    /// The library's rule with the sphere's bound, with `u = 2⁻²⁴`.
    Bound,
    /// As published.
    Integer,
    /// A constant along the normal [m].
    AlongNormal(f32),
    OnTheSpot,
}

pub const RULES: [(&str, Rule); 5] = [
    ("error bound", Rule::Bound),
    ("256 last places, as published", Rule::Integer),
    ("10⁻³ m along n", Rule::AlongNormal(1.0e-3)),
    ("B: 10⁻⁴ m along n", Rule::AlongNormal(1.0e-4)),
    ("no remedy", Rule::OnTheSpot),
];

/// Sine of the angle to the tangent plane from which on the truth is certain, with `u = 2⁻²⁴`. 256 last places are up to 512 u
/// of a coordinate, so that starts that rounding asks for rise by less than `h = 512 u (1 + d)`.
///
/// - Above: plane and light are known to 64 roundings, the tilt to as many, the light's distance is 4 sizes or more.
/// - Below: `h` sees over the horizon by √(2h) = 32 √(u (1 + d)).
fn certain(distance: f64, truth: Truth) -> f64 {
    let doubt = f32::ROUNDOFF * (1.0 + distance);
    match truth {
        Truth::Lit => 256.0 * doubt,
        Truth::Dark => 40.0 * doubt.sqrt(),
    }
}

type V = Triple<f32>;

fn single(v: DVec3) -> V {
    v.to_array().map(|x| x as f32)
}

fn minus(a: V, b: V) -> V {
    along(a, -1.0, b)
}

fn largest(v: V) -> f32 {
    v.into_iter().map(f32::abs).fold(0.0, f32::max)
}

impl Rule {
    fn origin(self, p: V, n: V, center: V, radius: f32) -> V {
        let u = f32::EPSILON / 2.0;
        match self {
            Rule::Bound => {
                let error = 12.0 * u * (radius + largest(center)) + 2.0 * u * largest(p);
                along(p, error * n.into_iter().map(f32::abs).sum::<f32>(), n)
            }
            Rule::Integer => integer_offset_single(p, n),
            Rule::AlongNormal(bias) => along(p, bias, n),
            Rule::OnTheSpot => p,
        }
    }
}

/// The scores of all [`RULES`] on a sphere of `size` [m], `distance` sizes from the world's origin.
pub fn contest(seed: u64, size: f64, distance: f64, budget: Budget) -> [Score; RULES.len()] {
    let (center, radius) = (single(AWAY * (size * distance)), size as f32);
    let lamps = lamps(seed, 1 << 12, |truth| certain(distance, truth));
    let mut turn = lamps.iter().cycle();
    let mut scores = [Score::default(); RULES.len()];
    for i in 0..budget.starts as u32 {
        let Some((p, n)) = start(seed, i, center, radius) else { continue };
        let (x, y) = duff(n);
        let [x, y, z] = [x, y, n].map(|v| DVec3::from_array(v.map(f64::from)));
        for lamp in turn.by_ref().take(budget.lights) {
            let way: &Lamp = lamp;
            let light = along(p, 1.0, single(way.way((x, y, z)) * size));
            for ((_, rule), score) in RULES.iter().zip(&mut scores) {
                let origin = rule.origin(p, n, center, radius);
                let t = in_front(robust(minus(origin, center), minus(light, origin), radius));
                let blocked = t.is_some_and(|t| t < 1.0);
                score.shadow_rays += 1;
                score.false_shadows += u64::from(blocked && lamp.truth == Truth::Lit);
                score.leaks += u64::from(!blocked && lamp.truth == Truth::Dark);
            }
        }
    }
    scores
}

/// A hit, put back on the sphere along its radius, and the normal.
fn start(seed: u64, i: u32, center: V, radius: f32) -> Option<(V, V)> {
    let mut sampler = Sampler::new(seed, u64::MAX - 1, i);
    let from = along(center, 4.0 * radius, single(uniform_sphere(sampler.next_2d())));
    let at = along(center, 0.7 * radius, single(uniform_sphere(sampler.next_2d())));
    let (f, d) = (minus(from, center), minus(at, from));
    let radial = along(f, in_front(robust(f, d, radius))?, d);
    let n = radial.map(|x| x / dot(radial, radial).sqrt());
    Some((along(center, radius, n), n))
}
