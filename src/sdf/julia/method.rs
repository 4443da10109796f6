//! The ways of the books: steps as long as the distance estimate says.

use super::Julia;
use super::orbit::{escape, quaternion};
use crate::frame::unit;
use crate::ray::Ray;
use glam::{DVec3, DVec4};

/// How a Julia set finds where a ray meets it first.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum JuliaMethod {
    /// Bounds instead of estimates, and a grid of empty cells: the first root, to rounding.
    #[default]
    Certified,
    /// Step and bisect as the document tells it [A §5.4.5]: from the ray's origin, as far as the plain estimate says; from inside half
    /// of the last step back.
    AsPrinted(March),
    /// The estimate from the bounding ball on, until it is below the tolerance.
    Estimate(March),
    /// The estimate from the ball on, but no step shorter than [`SHORTEST`], and bisection between the last two places: the
    /// way of POV-Ray.
    AtLeast(March),
    /// Steps that are never too long, from the ball on, until they are below the tolerance.
    Ball(March),
}

/// Shortest step \[m\] of [`JuliaMethod::AtLeast`]: POV-Ray's `precision 20`.
pub const SHORTEST: f64 = 1.0 / 20.0;

/// What a march is told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct March {
    /// It ends where the surface seems nearer than this \[m\].
    pub tolerance: f64,
    /// Places looked at before it gives up.
    pub most: u32,
}

/// A place that a march looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Distance along the ray from its origin \[m\].
    pub along: f64,
    /// How near the surface seems to be \[m\]; 0 inside.
    pub distance: f64,
}

impl JuliaMethod {
    /// The name that the command line uses.
    pub fn name(self) -> &'static str {
        match self {
            JuliaMethod::Certified => "certified",
            JuliaMethod::AsPrinted(_) => "as_printed",
            JuliaMethod::Estimate(_) => "estimate",
            JuliaMethod::AtLeast(_) => "at_least",
            JuliaMethod::Ball(_) => "ball",
        }
    }
}

impl Julia {
    /// The places that the method of the books looks at along a ray, in order; the first hit \[m\] if there is one.
    ///
    /// The certified method looks at four places at a time and keeps no list: nothing is visited, nothing found.
    pub fn walk_by_estimate(&self, ray: &Ray, mut visit: impl FnMut(Look)) -> Option<f64> {
        let direction = unit(ray.direction)?;
        let line = Ray::new(ray.origin, direction);
        let mut look = |along: f64| {
            let seen = Look { along, distance: self.seen(line.at(along)) };
            visit(seen);
            seen.distance
        };
        match self.method {
            JuliaMethod::Certified => None,
            JuliaMethod::AsPrinted(march) => step_and_bisect(march, self.reach(&line), &mut look),
            JuliaMethod::Estimate(march) | JuliaMethod::Ball(march) => {
                stride(march, self.chord(&line)?, &mut look)
            }
            JuliaMethod::AtLeast(march) => stride_at_least(march, self.chord(&line)?, &mut look),
        }
    }

    /// How near the surface seems to be from a point, 0 inside.
    fn seen(&self, p: DVec3) -> f64 {
        if matches!(self.method, JuliaMethod::Ball(_)) {
            return if self.contains_point(p) { 0.0 } else { self.free_radius(p) };
        }
        let q = quaternion::<f64>(DVec4::new(p.x, p.y, p.z, self.w()));
        let end = escape(q, quaternion(self.c), self.iterations, self.bailout());
        if end.escaped { end.estimate().unwrap_or(0.0) } else { 0.0 }
    }

    /// Distances [m] from a ray's origin between which it is in the bounding ball; ahead of it.
    fn chord(&self, line: &Ray) -> Option<[f64; 2]> {
        let radius = self.set.radius()?;
        let along = -line.origin.dot(line.direction);
        let chord2 = radius * radius - line.at(along).length_squared();
        let leave = along + chord2.max(0.0).sqrt();
        (chord2 > 0.0 && leave > 0.0).then(|| [(along - chord2.sqrt()).max(0.0), leave])
    }

    /// Distance [m] at which a ray has left everything behind.
    fn reach(&self, line: &Ray) -> f64 {
        line.origin.length() + self.set.radius().unwrap_or(0.0)
    }
}

/// [A §5.4.5]: "move to where the estimate says; if that is inside, go back half of the distance moved".
fn step_and_bisect(march: March, reach: f64, look: &mut impl FnMut(f64) -> f64) -> Option<f64> {
    let (mut along, mut moved) = (0.0, 0.0);
    for _ in 0..march.most {
        let distance = look(along);
        if distance == 0.0 {
            moved *= 0.5;
            if moved < march.tolerance {
                return Some(along);
            }
            along -= moved;
        } else if distance < march.tolerance {
            return Some(along);
        } else {
            moved = distance;
            along += moved;
            if !(along < reach) {
                return None;
            }
        }
    }
    None
}

/// Steps as long as the surface seems near.
fn stride(march: March, [mut along, end]: [f64; 2], look: &mut impl FnMut(f64) -> f64) -> Option<f64> {
    for _ in 0..march.most {
        let distance = look(along);
        if distance < march.tolerance {
            return Some(along);
        }
        along += distance;
        if !(along < end) {
            return None;
        }
    }
    None
}

/// Steps of at least [`SHORTEST`], and bisection of the one that changed sides.
fn stride_at_least(
    march: March,
    [mut along, end]: [f64; 2],
    look: &mut impl FnMut(f64) -> f64,
) -> Option<f64> {
    let mut distance = look(along);
    let inside = distance == 0.0;
    for _ in 0..march.most {
        let mut step = distance.max(SHORTEST);
        if !(along + step < end) {
            return None;
        }
        distance = look(along + step);
        if (distance == 0.0) != inside {
            while step > march.tolerance {
                step *= 0.5;
                if (look(along + step) == 0.0) == inside {
                    along += step;
                }
            }
            return Some(along + step);
        }
        along += step;
    }
    None
}
