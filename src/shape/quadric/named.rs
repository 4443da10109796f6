//! The quadrics with names, their axes along the coordinate axes [A (2.4)–(2.8)].

use super::{Coefficients, Quadric};
use crate::shape::ShapeError;
use glam::DVec3;

/// `s.x (x−l)² + s.y (y−m)² + s.z (z−n)² + 2 slope (z−n) + constant`.
fn upright(center: DVec3, s: DVec3, slope: f64, constant: f64) -> Result<Quadric, ShapeError> {
    let center = ShapeError::finite("center of a quadric", center)?;
    let moved = s * center;
    Quadric::new(Coefficients {
        a: s.x,
        e: s.y,
        h: s.z,
        d: -moved.x,
        g: -moved.y,
        i: slope - moved.z,
        j: moved.dot(center) - 2.0 * slope * center.z + constant,
        ..Coefficients::default()
    })
}

/// `1/a²` of semi-axes above 0.
fn squares(semi_axes: DVec3) -> Result<DVec3, ShapeError> {
    for axis in semi_axes.to_array() {
        ShapeError::positive("semi-axis of a quadric", axis)?;
    }
    Ok((semi_axes * semi_axes).recip())
}

impl Quadric {
    /// `(x−l)²/a² + (y−m)²/b² + (z−n)²/c² = 1` [A (2.6)]; [`super::Ellipsoid`] is bounded and keeps more digits.
    pub fn ellipsoid(center: DVec3, semi_axes: DVec3) -> Result<Self, ShapeError> {
        upright(center, squares(semi_axes)?, 0.0, -1.0)
    }

    /// `(x−l)² + (y−m)² = r²` [A (2.4)], an infinite cylinder along z.
    pub fn cylinder(center: DVec3, radius: f64) -> Result<Self, ShapeError> {
        let radius = ShapeError::positive("radius of a cylinder", radius)?;
        upright(center, DVec3::new(1.0, 1.0, 0.0), 0.0, -radius * radius)
    }

    /// `(x−l)² + (y−m)² = k² (z−n)²` [A (2.5) for `k = 1`], an infinite double cone along z.
    pub fn cone(apex: DVec3, slope: f64) -> Result<Self, ShapeError> {
        let slope = ShapeError::positive("slope of a cone", slope)?;
        upright(apex, DVec3::new(1.0, 1.0, -slope * slope), 0.0, 0.0)
    }

    /// `(x−l)²/a² + (y−m)²/b² = z − n` [A (2.7)], opening towards +z.
    pub fn paraboloid(vertex: DVec3, a: f64, b: f64) -> Result<Self, ShapeError> {
        let s = squares(DVec3::new(a, b, 1.0))?;
        upright(vertex, DVec3::new(s.x, s.y, 0.0), -0.5, 0.0)
    }

    /// `(x−l)²/a² − (y−m)²/b² = z − n`, a saddle.
    pub fn hyperbolic_paraboloid(center: DVec3, a: f64, b: f64) -> Result<Self, ShapeError> {
        let s = squares(DVec3::new(a, b, 1.0))?;
        upright(center, DVec3::new(s.x, -s.y, 0.0), -0.5, 0.0)
    }

    /// `(x−l)²/a² + (y−m)²/b² − (z−n)²/c² = 1`, connected around z.
    pub fn hyperboloid_of_one_sheet(center: DVec3, semi_axes: DVec3) -> Result<Self, ShapeError> {
        upright(center, squares(semi_axes)? * DVec3::new(1.0, 1.0, -1.0), 0.0, -1.0)
    }

    /// `(x−l)²/a² + (y−m)²/b² − (z−n)²/c² = −1`, two bowls along z.
    pub fn hyperboloid_of_two_sheets(center: DVec3, semi_axes: DVec3) -> Result<Self, ShapeError> {
        upright(center, squares(semi_axes)? * DVec3::new(1.0, 1.0, -1.0), 0.0, 1.0)
    }
}
