//! Rays, what they find, and the hook that listens to them.
//!
//! A ray is the half line `p(t) = o + t d, t > 0` [B §4.4, A §5.4]. Intersection happens in two
//! steps, so that only the nearest surface pays for details: a shape answers with [`Crossing`]s
//! (where along the ray), and then describes one of them as a [`Hit`] (point, normal, coordinates).

pub mod leaving;

use crate::color::Rgb;
use crate::num::U;
use glam::{DVec2, DVec3};

/// The half line `o + t d`, `t > 0`.
///
/// `t` counts lengths of `direction`, which is a unit vector unless a function says otherwise;
/// transformed shapes and shadow segments use other lengths, and every shape accepts them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    pub origin: DVec3,
    pub direction: DVec3,
}

impl Ray {
    pub fn new(origin: DVec3, direction: DVec3) -> Self {
        Ray { origin, direction }
    }

    /// The point `o + t d`.
    #[inline]
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + self.direction * t
    }
}

/// One meeting of a ray with a surface: how far, and which part of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Ray parameter [lengths of the direction].
    pub t: f64,
    /// Which face of the shape: 0–5 of a box, side and caps of a cylinder, triangle of a mesh.
    pub face: u32,
    /// Which part of a compound: the leaf of a CSG tree, the member of an instance; else 0.
    pub part: u32,
}

impl Crossing {
    pub fn new(t: f64, face: u32) -> Self {
        Crossing { t, face, part: 0 }
    }
}

/// The stretch of a ray inside a solid, from `enter.t` to `leave.t` (either may be infinite).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    pub enter: Crossing,
    pub leave: Crossing,
}

/// What is known where a ray meets a surface [A ill. 64].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Ray parameter [lengths of the direction].
    pub t: f64,
    /// The point, as near to the true surface as the shape can put it.
    pub point: DVec3,
    /// Bound on the distance between `point` and the true surface, from rounding analysis
    /// (lengths of the scene). Rays that leave the point start beyond it.
    pub point_error: f64,
    /// Geometric normal: unit, outward, independent of the side the ray comes from.
    pub ng: DVec3,
    /// Shading normal: unit; equal to `ng` unless normals are interpolated or perturbed.
    pub n: DVec3,
    /// Unit tangent along growing `u`, perpendicular to `ng`.
    pub tangent: DVec3,
    /// Texture coordinates in `[0,1]²`.
    pub uv: DVec2,
    pub face: u32,
    pub part: u32,
}

impl Hit {
    /// Origin for a ray that leaves this hit towards `direction`, on that side of the surface.
    ///
    /// The point moves along `ng` by its error bound and by what the sum itself rounds, at most `u` of each
    /// coordinate, so that the origin lies on the right side whatever the scale of the scene; nothing is ever
    /// skipped by name.
    ///
    /// - Source: after Pharr, Jakob & Humphreys, *Physically Based Rendering* (2016) §3.9.5.
    #[inline]
    pub fn origin_towards(&self, direction: DVec3) -> DVec3 {
        let side = if direction.dot(self.ng) < 0.0 { -self.ng } else { self.ng };
        // Along the normal an error e of each coordinate counts |nx| e + |ny| e + |nz| e, which is at least e;
        // the sum errs by u of the moved point, which 2 u of the point cover.
        let error = self.point_error + 2.0 * U * self.point.abs().max_element();
        self.point + side * (error * side.abs().element_sum())
    }
}

/// Why a ray was shot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RayKind {
    Camera,
    Shadow,
    Reflected,
    Refracted,
    Indirect,
    Photon,
}

impl RayKind {
    pub const ALL: [RayKind; 6] = {
        use RayKind::*;
        [Camera, Shadow, Reflected, Refracted, Indirect, Photon]
    };

    /// The word for it in messages.
    pub fn name(self) -> &'static str {
        match self {
            RayKind::Camera => "camera",
            RayKind::Shadow => "shadow",
            RayKind::Reflected => "reflected",
            RayKind::Refracted => "refracted",
            RayKind::Indirect => "indirect",
            RayKind::Photon => "photon",
        }
    }
}

/// Listens to an integrator at every ray, hit and weight.
///
/// Rays nest: what is reported between [`Trace::enter`] and its [`Trace::leave`] is a child of that
/// ray. All methods do nothing by default, so that the silent tracer [`Silent`] compiles away.
pub trait Trace {
    /// Is anybody listening? Integrators may skip work that only serves the listener.
    const ACTIVE: bool = true;
    /// A ray sets out. `t_max` bounds the search (1 for a shadow segment, else infinite);
    /// `weight` is what its radiance will be multiplied by in its parent.
    fn enter(&mut self, _kind: RayKind, _ray: &Ray, _t_max: f64, _weight: Rgb) {}
    /// The current ray ends at `hit` on the object called `object`.
    fn hit(&mut self, _object: usize, _hit: &Hit) {}
    /// The current shadow segment is blocked by the object of that index.
    fn blocked(&mut self, _object: usize) {}
    /// The current ray is done and brings `radiance`.
    fn leave(&mut self, _radiance: Rgb) {}
    /// Work was done that is worth counting.
    fn count(&mut self, _work: Work, _times: u64) {}
}

/// Kinds of counted work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Work {
    /// A ray of that kind was traced.
    Ray(RayKind),
    /// A ray was tested against a shape.
    ShapeTest,
    /// A node of a hierarchy was visited.
    NodeVisit,
}

/// The tracer that listens to nothing and costs nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Trace for Silent {
    const ACTIVE: bool = false;
}

/// The tracer that only counts: a few additions a ray.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    rays: [u64; RayKind::ALL.len()],
    pub shape_tests: u64,
    pub node_visits: u64,
}

impl Tally {
    /// Rays of one kind.
    pub fn rays(&self, kind: RayKind) -> u64 {
        self.rays[kind as usize]
    }

    /// Rays of all kinds.
    pub fn total_rays(&self) -> u64 {
        self.rays.iter().sum()
    }

    /// Both counts together.
    pub fn plus(&self, other: &Tally) -> Tally {
        let mut rays = self.rays;
        for (sum, n) in rays.iter_mut().zip(other.rays) {
            *sum += n;
        }
        Tally {
            rays,
            shape_tests: self.shape_tests + other.shape_tests,
            node_visits: self.node_visits + other.node_visits,
        }
    }
}

impl Trace for Tally {
    const ACTIVE: bool = false;

    #[inline]
    fn count(&mut self, work: Work, times: u64) {
        match work {
            Work::Ray(kind) => self.rays[kind as usize] += times,
            Work::ShapeTest => self.shape_tests += times,
            Work::NodeVisit => self.node_visits += times,
        }
    }
}
