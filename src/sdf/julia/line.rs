//! A ray as the solid sees it: its middle, where it comes nearest to the origin, and a parameter `s` counted from there.

use super::lanes::{LANES, Lanes};
use super::reach::Start;
use super::set::Set;
use crate::ray::Ray;
use glam::DVec3;

/// `(2|q|)²` beyond which an orbit is gone: its square, and the product with the derivative, are still finite.
const GONE: f64 = 1.0e140;

/// The line `middle + s direction`, with a unit direction, and what the iteration needs of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub middle: DVec3,
    pub direction: DVec3,
    /// `s` of the ray's origin, and lengths of the ray's direction per unit of `s`.
    origin: f64,
    speed: [f64; 2],
    /// Where the line passes through the ball that holds the solid.
    pub enter: f64,
    pub leave: f64,
    /// The coordinates (2) of [`super::set`]: `x = x₀ + s dx`, likewise `y`, and `z = z₀ + 2 z₁ s + z₂ s²`.
    x: [f64; 2],
    y: [f64; 2],
    z: [f64; 3],
}

impl Line {
    /// The ray's line, if it meets the ball of `radius` about the origin.
    ///
    /// The middle is as far from the true line as the ray's origin is rounded: u of its distance.
    #[inline]
    pub fn new(set: &Set, ray: &Ray, radius: f64) -> Option<Self> {
        // Squares of ordinary lengths are ordinary; others are scaled first.
        let squared = ray.direction.length_squared();
        let largest =
            if (1.0e-200..1.0e200).contains(&squared) { 1.0 } else { ray.direction.abs().max_element() };
        let direction = if largest == 1.0 { ray.direction } else { ray.direction / largest };
        let length = direction.length();
        let direction = direction * (1.0 / length);
        let origin = ray.origin.dot(direction);
        let middle = ray.origin - direction * origin;
        let (b, c) = (middle.dot(direction), middle.length_squared() - radius * radius);
        let chord2 = b * b - c;
        if !(chord2 > 0.0) {
            return None;
        }
        let half = chord2.sqrt();
        let (at, to) = (set.reduced(middle, set.w()), set.reduced(direction, 0.0));
        Some(Line {
            middle,
            direction,
            origin,
            speed: [largest, length],
            enter: -b - half,
            leave: half - b,
            x: [2.0 * at.a, 2.0 * to.a],
            y: [2.0 * at.u, 2.0 * to.u],
            z: [
                4.0 * at.across.length_squared(),
                4.0 * at.across.dot(to.across),
                4.0 * to.across.length_squared(),
            ],
        })
    }

    /// `s` of the ray's parameter `t`.
    #[inline]
    pub fn s(&self, t: f64) -> f64 {
        t * self.speed[0] * self.speed[1] + self.origin
    }

    /// The ray's parameter `t` of `s`.
    #[inline]
    pub fn t(&self, s: f64) -> f64 {
        (s - self.origin) / self.speed[1] / self.speed[0]
    }

    pub fn at(&self, s: f64) -> DVec3 {
        self.middle + self.direction * s
    }

    /// What the iteration starts with at four places.
    #[inline(always)]
    pub fn start<V: Lanes>(&self, s: [f64; LANES]) -> Start<V> {
        let (s, [x0, dx], [y0, dy]) = (V::of(s), self.x.map(V::splat), self.y.map(V::splat));
        let [z0, z1, z2] = self.z.map(V::splat);
        let half_dz = z1 + s * z2;
        Start { x: x0 + s * dx, y: y0 + s * dy, z: z0 + s * (half_dz + z1), dx, dy, half_dz }
    }

    /// `(2|q_N|)²` and half its derivative at one place; ∞ and 0 where the orbit has left for good.
    #[inline(always)]
    pub fn value(&self, set: &Set, s: f64) -> (f64, f64) {
        let ([x0, mut dx], [y0, mut dy], [z0, z1, z2]) = (self.x, self.y, self.z);
        let (mut x, mut y, mut half_dz) = (x0 + s * dx, y0 + s * dy, z1 + s * z2);
        let mut z = z0 + s * (half_dz + z1);
        for _ in 1..set.levels.len() {
            let (x2, y2, xdx) = (x * x, y * y, x * dx);
            if x2 + (y2 + z) > GONE {
                return (f64::INFINITY, 0.0);
            }
            let next_dx = xdx - (y * dy + half_dz);
            dy = x * dy + y * dx;
            dx = next_dx;
            half_dz = xdx * z + x2 * half_dz;
            y = x * y + set.k_twice;
            x = 0.5 * (x2 - (y2 + z)) + set.c0_twice;
            z *= x2;
        }
        (x * x + (y * y + z), x * dx + (y * dy + half_dz))
    }
}
