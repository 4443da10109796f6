//! The iteration in as few numbers as it needs, and its thresholds.
//!
//! Squaring keeps the axis of a quaternion's vector part, and adding `c` moves it towards the axis of `c`. So the part
//! of the vector across that axis never turns, it only grows by `2a` a step, and three numbers follow the whole orbit:
//! the real part `a`, the vector part `u` along the axis of `c`, and the square `p` of the rest.
//!
//! ```text
//! q = (a, u, √p),   c = (c₀, k, 0):     a' = a² − u² − p + c₀,   u' = 2 a u + k,   p' = 4 a² p      (1)
//! |q|² = a² + u² + p
//! ```
//!
//! (`|q|`, distances and angles are those of space: the set is a body of revolution about the plane of 1 and `c`.)
//!
//! The level set `|q_N| = B` lies within `|q_n| ≤ R_n`, where `R_N = B` and `R_n² = R_{n+1} + |c|`, because
//! `|q² + c| ≥ |q|² − |c|`. A place beyond the threshold of any level is outside. As `N` grows, `R₀` falls (or rises)
//! to the escape radius `(1 + √(1 + 4|c|))/2`.

use crate::num::{U, gamma};
use glam::{DVec3, DVec4};

/// One level of the iteration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Level {
    /// `R_n`: beyond it a place is outside.
    pub threshold: f64,
    /// `|q|²` above which iterating further tells no more about distances than stopping here.
    pub stop2: f64,
}

/// By how much `|q_n|` exceeds its threshold before an orbit is stopped. Tuned: at 1.2 the stretches of
/// [`super::reach`] are shorter, because little of the way out is known, and at 1.6, because higher powers bend more.
const STOP: f64 = 1.35;

/// Relative rounding of one step: its coordinates sum up to four products.
const ROUNDED: f64 = gamma(6);

/// The iterated map `q² + c` and the level set of its `N`th iterate.
#[derive(Clone, Debug)]
pub(super) struct Set {
    pub c0: f64,
    pub k: f64,
    /// Unit axis of `c`'s vector part.
    axis: DVec3,
    /// The fourth coordinate of the space that is looked at.
    w: f64,
    pub levels: Vec<Level>,
}

/// A place, its value and what is known about both.
#[derive(Clone, Copy, Debug)]
pub(super) struct Value {
    /// `|q_N|`.
    pub size: f64,
    /// Gradient of `|q_N|`.
    pub gradient: DVec3,
    /// Bound on the rounding error of `size`.
    pub error: f64,
    /// `κ` of [`super::reach`]: how fast the gradient may change.
    pub kappa: f64,
}

/// Coordinates (1) of a point of space: `a`, `u`, and the part across the axis.
#[derive(Clone, Copy)]
pub(super) struct Reduced {
    pub a: f64,
    pub u: f64,
    pub across: DVec3,
}

impl Set {
    pub fn new(c: DVec4, iterations: u32, bailout: f64, w: f64) -> Self {
        let vector = DVec3::new(c.y, c.z, c.w);
        let k = vector.length();
        let axis = if k > 0.0 { vector / k } else { DVec3::X };
        let mut thresholds = vec![bailout];
        for i in 0..iterations as usize {
            thresholds.push((thresholds[i] + c.length()).sqrt() * (1.0 + 4.0 * U));
        }
        thresholds.reverse();
        let level = |r: f64| Level { threshold: r, stop2: (STOP * r) * (STOP * r) };
        Set { c0: c.x, k, axis, w, levels: thresholds.into_iter().map(level).collect() }
    }

    /// Threshold of the last level: the set's own `B`.
    pub fn bailout(&self) -> f64 {
        self.levels[self.levels.len() - 1].threshold
    }

    pub fn iterations(&self) -> u32 {
        self.levels.len() as u32 - 1
    }

    /// Radius of a ball about the origin of space that holds the solid, a millionth beyond it, so that a line is outside where it
    /// enters and leaves; `None` if the slice passes the solid by.
    pub fn radius(&self) -> Option<f64> {
        let r = self.levels[0].threshold;
        let r2 = (r - self.w) * (r + self.w);
        (r2 > 0.0).then(|| r2.sqrt() * (1.0 + 1.0 / (1 << 20) as f64))
    }

    /// A point of space in the coordinates (1); a direction with `w` = 0.
    pub fn reduced(&self, p: DVec3, w: f64) -> Reduced {
        let vector = DVec3::new(p.y, p.z, w);
        let u = vector.dot(self.axis);
        Reduced { a: p.x, u, across: vector - self.axis * u }
    }

    pub fn w(&self) -> f64 {
        self.w
    }

    /// `|q_N|` at a point of the ball of [`Set::radius`], with its gradient.
    ///
    /// The gradient is carried back from the last iterate to the first. Rounding: each step rounds its three
    /// coordinates by at most γ₆ of `α² + |c|`, and stretches what it got by `2α`.
    pub fn value(&self, at: DVec3) -> Value {
        let Reduced { mut a, mut u, across } = self.reduced(at, self.w);
        let mut p = across.length_squared();
        let c = self.c0.abs() + self.k;
        let mut orbit = arrayvec::ArrayVec::<(f64, f64, f64), { super::MOST_ITERATIONS as usize }>::new();
        let (mut beta, mut kappa, mut error) = (1.0, 0.0, ROUNDED * (at.length() + self.w.abs()));
        let mut n = a * a + u * u + p;
        for _ in 1..self.levels.len() {
            orbit.push((a, u, p));
            let twice = 2.0 * n.sqrt();
            error = twice * error + ROUNDED * (n + c);
            kappa = beta * beta + twice * kappa;
            beta *= twice;
            (a, u, p) = (a * a - u * u - (p - self.c0), 2.0 * (a * u) + self.k, 4.0 * (a * a * p));
            n = a * a + u * u + p;
        }
        // Half the derivatives of a² + u² + p, back to the first iterate.
        let size = n.sqrt();
        if !(size < f64::INFINITY) {
            return Value { size: f64::INFINITY, gradient: DVec3::ZERO, error, kappa };
        }
        let (mut ga, mut gu, mut gp) = (a, u, 0.5);
        for &(a, u, p) in orbit.iter().rev() {
            let next = 2.0 * (a * ga + u * gu) + 8.0 * (a * p * gp);
            (gu, gp) = (2.0 * (a * gu - u * ga), 4.0 * (a * a * gp) - ga);
            ga = next;
        }
        let vector = self.axis * gu + across * (2.0 * gp);
        let gradient = DVec3::new(ga, vector.x, vector.y) / size;
        Value { size, gradient, error: error + ROUNDED * size, kappa }
    }
}
