//! A ray as the solid sees it: its middle, where it comes nearest to the origin, and a parameter `s` counted from there.

use super::lanes::{LANES, Lanes};
use super::reach::Start;
use super::set::Set;
use crate::ray::Ray;
use glam::DVec3;

/// `|q|²` beyond which an orbit is gone: its square, and the product with the derivative, are still finite.
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
    a: f64,
    da: f64,
    u: f64,
    du: f64,
    /// `p = p₀ + 2 p₁ s + p₂ s²`.
    p: [f64; 3],
}

impl Line {
    /// The ray's line, if it meets the ball of `radius` about the origin.
    ///
    /// The middle is as far from the true line as the ray's origin is rounded: u of its distance.
    #[inline]
    pub fn new(set: &Set, ray: &Ray, radius: f64) -> Option<Self> {
        let largest = ray.direction.abs().max_element();
        let direction = ray.direction / largest;
        let length = direction.length();
        let direction = direction / length;
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
            a: at.a,
            da: to.a,
            u: at.u,
            du: to.u,
            p: [at.across.length_squared(), at.across.dot(to.across), to.across.length_squared()],
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
        let (s, [p0, p1, p2]) = (V::of(s), self.p.map(V::splat));
        let hp = p1 + s * p2;
        Start {
            a: V::splat(self.a) + s * V::splat(self.da),
            u: V::splat(self.u) + s * V::splat(self.du),
            p: p0 + s * (hp + p1),
            da: V::splat(self.da),
            du: V::splat(self.du),
            hp,
        }
    }

    /// `|q_N|²` and half its derivative at one place. An orbit that leaves for good may overflow: then ∞ and 0.
    #[inline(always)]
    pub fn value(&self, set: &Set, s: f64) -> (f64, f64) {
        let [p0, p1, p2] = self.p;
        let (mut a, mut u, mut da, mut du) = (self.a + s * self.da, self.u + s * self.du, self.da, self.du);
        let mut hp = p1 + s * p2;
        let mut p = p0 + s * (hp + p1);
        for _ in 1..set.levels.len() {
            let (ada, ta, a2, u2) = (a * da, a + a, a * a, u * u);
            if a2 + u2 + p > GONE {
                return (f64::INFINITY, 0.0);
            }
            let next_da = 2.0 * (ada - u * du - hp);
            du = ta * du + (u + u) * da;
            hp = 4.0 * (ada * p + a2 * hp);
            a = (a2 - u2) - (p - set.c0);
            u = ta * u + set.k;
            p = 4.0 * (a2 * p);
            da = next_da;
        }
        (a * a + u * u + p, a * da + u * du + hp)
    }
}
