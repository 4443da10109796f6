//! A ray as the solid sees it: its middle, where it comes nearest to the origin, and a parameter `s` counted from there.

use super::lanes::Lanes;
use super::reach::Start;
use super::set::Set;
use crate::num::certified::power_of_two_below;
use crate::ray::Ray;
use glam::DVec3;

/// `(2|q_N|)²` beyond which it is taken for ∞: its product with the derivative is still finite.
const GONE: f64 = 1.0e140;

/// Squared lengths of directions that are taken as they are; others are scaled first, lest products of a hundred factors
/// leave the numbers.
const ORDINARY: std::ops::Range<f64> = 1.0e-6..1.0e6;

/// The line `middle + s direction`, and what the iteration needs of it.
///
/// `s` counts lengths of the direction, as the ray's parameter does, so that nothing is normalised: the bounds of [`super::reach`] begin with
/// `β₀` = [`Line::length`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub middle: DVec3,
    pub direction: DVec3,
    /// `s` of the ray's origin, and by how much the ray's direction is longer than this one: 1 for ordinary ones.
    origin: f64,
    speed: f64,
    /// Of the direction, and its reciprocal.
    pub length: f64,
    pub per_length: f64,
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
        let (mut direction, mut squared, mut speed) = (ray.direction, ray.direction.length_squared(), 1.0);
        if !ORDINARY.contains(&squared) {
            let largest = direction.abs().max_element();
            // A power of two rounds nothing; where the numbers end there is none.
            speed = if largest < f64::MIN_POSITIVE { largest } else { power_of_two_below(largest) };
            direction /= speed;
            squared = direction.length_squared();
        }
        let per_squared = 1.0 / squared;
        let mut origin = ray.origin.dot(direction) * per_squared;
        let mut middle = ray.origin - direction * origin;
        let off =
            |middle: DVec3| (middle.dot(direction) * per_squared, middle.length_squared() - radius * radius);
        let (mut b, mut c) = off(middle);
        if c >= 0.0 {
            // A miss, unless the middle stands aside along the line, by the rounding of a far origin.
            if !(b * b > c * per_squared) {
                return None;
            }
            middle -= direction * b;
            origin += b;
            (b, c) = off(middle);
        }
        let chord2 = b * b - c * per_squared;
        if !(c < 0.0 && chord2 > 0.0) {
            return None;
        }
        let (half, length) = (chord2.sqrt(), squared.sqrt());
        let (at, to) = (set.reduced(middle, set.w()), set.reduced(direction, 0.0));
        Some(Line {
            middle,
            direction,
            origin,
            speed,
            length,
            per_length: length * per_squared,
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
        t * self.speed + self.origin
    }

    /// The ray's parameter `t` of `s`.
    #[inline]
    pub fn t(&self, s: f64) -> f64 {
        let along = s - self.origin;
        if self.speed == 1.0 { along } else { along / self.speed }
    }

    pub fn at(&self, s: f64) -> DVec3 {
        self.middle + self.direction * s
    }

    /// What the iteration starts with at four places.
    #[inline(always)]
    pub fn start<V: Lanes>(&self, s: V) -> Start<V> {
        let ([x0, dx], [y0, dy]) = (self.x.map(V::splat), self.y.map(V::splat));
        let [z0, z1, z2] = self.z.map(V::splat);
        let half_dz = z1 + s * z2;
        Start {
            x: x0 + s * dx,
            y: y0 + s * dy,
            z: z0 + s * (half_dz + z1),
            dx,
            dy,
            half_dz,
            beta: V::splat(self.length),
        }
    }

    /// `(2|q_N|)²` and half its derivative at one place; ∞ and 0 where the orbit has left for good.
    ///
    /// By `a` = x/2, `u` = y/2 and `p` = z/4, (1) of [`super::set`]: more products, but a shorter chain of them that wait for each other.
    #[inline(always)]
    pub fn value(&self, set: &Set, s: f64) -> (f64, f64) {
        let ([x0, dx], [y0, dy], [z0, z1, z2]) = (self.x, self.y, self.z);
        let half_dz = z1 + s * z2;
        let (mut a, mut u) = (0.5 * (x0 + s * dx), 0.5 * (y0 + s * dy));
        let mut p = 0.25 * (z0 + s * (half_dz + z1));
        let (mut dx, mut dy, mut half_dz) = (dx, dy, half_dz);
        let (c0, k) = (0.5 * set.c0_twice, 0.5 * set.k_twice);
        for _ in 1..set.levels.len() {
            let (x, y) = (a + a, u + u);
            let (x2, xdx, across) = (x * x, x * dx, y * dy + half_dz);
            dy = x * dy + y * dx;
            dx = xdx - across;
            half_dz = 4.0 * (xdx * p) + x2 * half_dz;
            (a, u, p) = ((a * a + c0) - (u * u + p), x * u + k, x2 * p);
        }
        let n = 4.0 * (a * a + (u * u + p));
        // Once an orbit has overflowed, it is no number.
        if n < GONE { (n, 2.0 * (a * dx) + (2.0 * (u * dy) + half_dz)) } else { (f64::INFINITY, 0.0) }
    }
}
