//! Where samples live: surfaces with a chart that keeps areas.
//!
//! The chart maps the surface to the unit square so that equal areas stay equal. Then the cells of a grid in
//! the square are cells of equal area on the surface, and the integral of a density over one is a plain double integral.

use glam::{DVec2, DVec3};
use lightbench::num::gamma;
use std::f64::consts::{PI, TAU};

/// A surface with an area-preserving chart.
pub trait Domain {
    type Point: Copy + std::fmt::Debug;
    /// Area, in the measure of the densities (solid angle for directions).
    fn area(&self) -> f64;
    /// The point at a place of the chart.
    fn point(&self, st: DVec2) -> Self::Point;
    /// The place of a point in the chart [0,1]², `None` outside the surface.
    fn chart(&self, p: Self::Point) -> Option<DVec2>;
}

/// Directions with `1 − cos θ ≤ versine` about `z`.
#[derive(Clone, Copy, Debug)]
pub struct Cone {
    pub versine: f64,
}

impl Cone {
    pub const SPHERE: Cone = Cone { versine: 2.0 };
    pub const HEMISPHERE: Cone = Cone { versine: 1.0 };
}

impl Domain for Cone {
    type Point = DVec3;

    fn area(&self) -> f64 {
        TAU * self.versine
    }

    fn point(&self, st: DVec2) -> DVec3 {
        let h = self.versine * st.x;
        let (sin, cos) = (TAU * st.y).sin_cos();
        let r = (h * (2.0 - h)).sqrt();
        DVec3::new(r * cos, r * sin, 1.0 - h)
    }

    fn chart(&self, w: DVec3) -> Option<DVec2> {
        let h = if w.z > 0.0 { (w.x * w.x + w.y * w.y) / (1.0 + w.z) } else { 1.0 - w.z };
        inside(DVec2::new(h / self.versine, turns(w.y, w.x)))
    }
}

/// The unit disc.
#[derive(Clone, Copy, Debug)]
pub struct Disc;

impl Domain for Disc {
    type Point = DVec2;

    fn area(&self) -> f64 {
        PI
    }

    fn point(&self, st: DVec2) -> DVec2 {
        let (sin, cos) = (TAU * st.y).sin_cos();
        DVec2::new(cos, sin) * st.x.sqrt()
    }

    fn chart(&self, p: DVec2) -> Option<DVec2> {
        inside(DVec2::new(p.length_squared(), turns(p.y, p.x)))
    }
}

/// The unit square itself.
#[derive(Clone, Copy, Debug)]
pub struct Square;

impl Domain for Square {
    type Point = DVec2;

    fn area(&self) -> f64 {
        1.0
    }

    fn point(&self, st: DVec2) -> DVec2 {
        st
    }

    fn chart(&self, p: DVec2) -> Option<DVec2> {
        inside(p)
    }
}

/// A triangle of area 1 in barycentric coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Triangle;

impl Domain for Triangle {
    type Point = DVec3;

    fn area(&self) -> f64 {
        1.0
    }

    fn point(&self, st: DVec2) -> DVec3 {
        let s = st.x.sqrt();
        DVec3::new(1.0 - s, s * (1.0 - st.y), s * st.y)
    }

    /// The triangle at height `b₀` is narrower by `1 − b₀`: `(1 − b₀)²` is the share of the area beyond.
    fn chart(&self, b: DVec3) -> Option<DVec2> {
        if b.min_element() < 0.0 {
            return None;
        }
        let beyond = b.y + b.z;
        let along = if beyond > 0.0 { b.z / beyond } else { 0.0 };
        inside(DVec2::new(beyond * beyond, along))
    }
}

/// The angle in turns, in [0,1).
fn turns(y: f64, x: f64) -> f64 {
    let turn = y.atan2(x) / TAU;
    if turn < 0.0 { turn + 1.0 } else { turn }
}

/// Points on the rim may come out beyond it by the roundings of warp and chart, 16 at most.
fn inside(st: DVec2) -> Option<DVec2> {
    let slack = gamma(16);
    let ok = st.cmpge(DVec2::splat(-slack)).all() && st.cmple(DVec2::splat(1.0 + slack)).all();
    ok.then(|| st.clamp(DVec2::ZERO, DVec2::ONE))
}
