//! Quaternion Julia sets: what is left of space when `q ↦ q² + c` is repeated [A §2.4, §5.4.5].
//!
//! A point `(x, y, z)` is the quaternion `q₀ = x + y i + z j + w k` of a slice `w` of four-dimensional space. The solid
//! holds the points whose orbit has not left after `N` steps:
//!
//! ```text
//! q_{n+1} = q_n² + c,        |q_N| ≤ B                                                           (1)
//! |q'_{n+1}| = 2 |q_n| |q'_n|,     |q'_0| = 1
//! distance ≈ ½ |q| ln |q| / |q'|                                                                   (2)
//! ```
//!
//! (2) is the estimate of Hart, Sandin and Kauffman: right up to a factor near the set of the endless iteration, and
//! too long far away ([`orbit`]). [`Julia`] meets rays with the surface `|q_N| = B` itself, and for certain: its steps
//! are bounds, not estimates (`reach.rs`), empty space is leapt over by a grid of proofs (`grid.rs`), and the
//! first root is the first (`march.rs`). [`JuliaMethod`] lists the ways of the books beside it.
//!
//! - Source: Hart, Sandin & Kauffman, *Ray Tracing Deterministic 3-D Fractals*, SIGGRAPH 1989.

mod grid;
mod lanes;
mod line;
mod march;
mod method;
pub mod orbit;
mod reach;
mod set;

pub use method::{JuliaMethod, Look, March, SHORTEST};

use crate::bounds::Aabb;
use crate::num::gamma;
use crate::ray::{Crossing, Hit, Ray, Span};
use crate::shape::fan::Vectors;
use crate::shape::{Shape, ShapeError, Solid, perpendicular_part, turn};
use glam::{DVec2, DVec3, DVec4};
use grid::Grid;
use lanes::Plain;
use line::Line;
use march::{Ask, Begin, Found, Search};
use set::Set;
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;
use std::sync::Arc;

/// Most steps of the iteration.
pub const MOST_ITERATIONS: u32 = 100;
/// Largest `|c|`: what stays lies within 10.6 of the origin, and `β²` of `reach` stays below (21.1)²⁰⁰ = 10²⁶⁵. (Beyond 2 the
/// endless iteration leaves nothing but dust.)
pub const LARGEST_C: f64 = 100.0;
/// Largest bailout: what may still come back is shorter than 1.4·10³⁰, its square squared still a number.
pub const LARGEST_BAILOUT: f64 = 1.0e60;

/// The solid of points whose orbit has not left after `N` steps.
#[derive(Clone)]
pub struct Julia {
    c: DVec4,
    iterations: u32,
    method: JuliaMethod,
    vectors: Vectors,
    set: Set,
    /// Whose gradient shades, if it is not the set's own.
    shading: Option<Set>,
    /// Shared by all copies.
    grid: Arc<Grid>,
}

impl Julia {
    /// The points of the slice `w` with `|q_N| ≤ bailout`, `q₀ = (x, y, z, w)`; `c` holds the factors of 1, i, j, k.
    ///
    /// - Domain: `|c| ≤` [`LARGEST_C`], at most [`MOST_ITERATIONS`], `0 < bailout ≤` [`LARGEST_BAILOUT`], `w` finite. A slice may
    ///   hold no point at all; it is then never met.
    pub fn new(c: DVec4, iterations: u32, bailout: f64, w: f64) -> Result<Self, ShapeError> {
        let range = |what, allowed, found| Err(ShapeError::OutOfRange { what, allowed, found });
        if !(c.length() <= LARGEST_C) {
            return range("c of a Julia set", "a length of at most 100", c.length());
        }
        if iterations > MOST_ITERATIONS {
            return range("iterations of a Julia set", "at most 100", f64::from(iterations));
        }
        if !(bailout > 0.0 && bailout <= LARGEST_BAILOUT) {
            return range("bailout of a Julia set", "a number above 0, at most 10⁶⁰", bailout);
        }
        if !w.is_finite() {
            return Err(ShapeError::NotFinite { what: "w of a Julia set", found: w });
        }
        let set = Set::new(c, iterations, bailout, w);
        let grid = Arc::new(survey(&set));
        let (method, vectors) = (JuliaMethod::Certified, Vectors::default());
        Ok(Julia { c, iterations, method, vectors, set, shading: None, grid })
    }

    /// The same set, met by another method.
    pub fn with_method(self, method: JuliaMethod) -> Self {
        Julia { method, ..self }
    }

    /// The same set, shaded by the gradient of `|q_n|` after another number of steps: POV-Ray's is one ahead of its surface, and
    /// with many more it is the gradient of the potential, which smooths what a low bailout cuts.
    ///
    /// - Domain: at most [`MOST_ITERATIONS`], else that many; where the orbit overflows the surface's own normal is kept.
    pub fn with_normals_after(self, iterations: u32) -> Self {
        let steps = iterations.min(MOST_ITERATIONS);
        let other = (steps != self.iterations).then(|| Set::new(self.c, steps, self.bailout(), self.w()));
        Julia { shading: other, ..self }
    }

    /// The same set, computed by other instructions; the answers are the same bits.
    pub fn with_vectors(self, vectors: Vectors) -> Self {
        Julia { vectors, ..self }
    }

    pub fn c(&self) -> DVec4 {
        self.c
    }

    pub fn iterations(&self) -> u32 {
        self.iterations
    }

    pub fn bailout(&self) -> f64 {
        self.set.bailout()
    }

    pub fn w(&self) -> f64 {
        self.set.w()
    }

    /// `|q_N|` at a point, and its gradient, analytically; outside the ball of [`Julia::radius`] orbits may overflow, and
    /// there is no answer.
    pub fn level(&self, p: DVec3) -> Option<(f64, DVec3)> {
        let value = self.set.value(p);
        (value.size.is_finite() && value.gradient.is_finite()).then_some((value.size, value.gradient))
    }

    /// Radius of a ball about the origin that holds the solid; 0 if there is none.
    pub fn radius(&self) -> f64 {
        self.grid.radius
    }

    /// A length \[m\] by which one may move from `p` in any direction without entering or leaving the solid.
    ///
    /// - Domain: any finite point; 0 on the surface.
    /// - Accuracy: never beyond the surface, but for the rounding of `|q_N|`; (1) and (2) of `reach.rs`.
    pub fn free_radius(&self, p: DVec3) -> f64 {
        let Some(ball) = self.set.radius() else { return f64::INFINITY };
        let beyond = p.length() - ball;
        if beyond > 0.0 {
            return beyond;
        }
        reach::free(&self.set, p)
    }

    fn contains_point(&self, p: DVec3) -> bool {
        p.length() <= self.grid.radius && self.set.value(p).size <= self.bailout()
    }

    fn search(&self, search: &Search, begin: Begin, end: f64) -> Found {
        #[cfg(target_arch = "x86_64")]
        if self.vectors == Vectors::Widest && lanes::has_avx2() {
            // SAFETY: the processor has AVX2 and FMA3.
            return unsafe { search_avx2(search, begin, end) };
        }
        search.run::<Plain>(begin, end)
    }

    /// Visits the changes of sign along a line from `from` on, in order, each with what is behind it: inside or not.
    fn walk(
        &self,
        line: &Line,
        [from, end]: [f64; 2],
        ask: Ask,
        mut visit: impl FnMut(f64, bool) -> ControlFlow<()>,
    ) {
        let mut search = Search { set: &self.set, grid: &self.grid, line, inside: false, ask };
        // Before the ball a ray is outside.
        let mut begin = if from > line.enter { Begin::Unseen(from) } else { Begin::Known(line.enter) };
        let end = end.min(line.leave);
        loop {
            match self.search(&search, begin, end) {
                Found::Nothing => return,
                Found::OtherSide => search.inside = !search.inside,
                Found::At(s) => {
                    search.inside = !search.inside;
                    if visit(s, search.inside).is_break() {
                        return;
                    }
                    begin = Begin::Behind(s);
                }
            }
        }
    }

    /// The first crossing with `t_min < t < t_max`, for certain.
    fn certified(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        let line = Line::new(&self.set, ray, self.grid.radius)?;
        let mut found = None;
        self.walk(&line, [line.s(0.0), line.s(t_max)], Ask::First, |s, _| {
            let t = line.t(s);
            if !(t > t_min) || t <= 0.0 {
                return ControlFlow::Continue(());
            }
            found = (t < t_max).then(|| Crossing::new(t, 0));
            ControlFlow::Break(())
        });
        found
    }
}

/// What it is made of; not the grid, which follows from that.
impl std::fmt::Debug for Julia {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (bailout, w) = (self.bailout(), self.w());
        let mut shown = f.debug_struct("Julia");
        shown.field("c", &self.c).field("iterations", &self.iterations);
        shown.field("bailout", &bailout).field("w", &w).field("method", &self.method);
        let steps = self.shading.as_ref().map_or(self.iterations, |set| set.iterations());
        shown.field("normals_after", &steps).finish()
    }
}

/// The grid of a set, by the widest instructions there are.
fn survey(set: &Set) -> Grid {
    let radius = set.radius().unwrap_or(0.0);
    #[cfg(target_arch = "x86_64")]
    {
        #[target_feature(enable = "avx2,fma")]
        fn avx2(set: &Set, radius: f64) -> Grid {
            Grid::new::<lanes::Avx2>(set, radius)
        }
        if lanes::has_avx2() {
            // SAFETY: the processor has AVX2 and FMA3.
            return unsafe { avx2(set, radius) };
        }
    }
    Grid::new::<Plain>(set, radius)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn search_avx2(search: &Search, begin: Begin, end: f64) -> Found {
    search.run::<lanes::Avx2>(begin, end)
}

/// Longitude from +x towards −z and latitude from the south pole, as of a sphere.
fn uv_of(direction: DVec3) -> DVec2 {
    let n = crate::frame::unit(direction).unwrap_or(DVec3::X);
    DVec2::new(turn(n.x, -n.z), n.y.clamp(-1.0, 1.0).asin() / PI + 0.5)
}

impl Shape for Julia {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        if self.method == JuliaMethod::Certified {
            return self.certified(ray, t_min, t_max);
        }
        let t = self.walk_by_estimate(ray, |_| ())? / ray.direction.length();
        (t > t_min && t < t_max).then(|| Crossing::new(t, 0))
    }

    fn blocks(&self, ray: &Ray, t_max: f64) -> bool {
        if self.method != JuliaMethod::Certified {
            return self.nearest(ray, 0.0, t_max).is_some();
        }
        let Some(line) = Line::new(&self.set, ray, self.grid.radius) else { return false };
        let mut blocked = false;
        self.walk(&line, [line.s(0.0), line.s(t_max)], Ask::Any, |_, _| {
            blocked = true;
            ControlFlow::Break(())
        });
        blocked
    }

    /// The methods of the books know the first crossing only.
    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        if self.method != JuliaMethod::Certified {
            out.extend(self.nearest(ray, 0.0, f64::INFINITY));
            return;
        }
        let Some(line) = Line::new(&self.set, ray, self.grid.radius) else { return };
        self.walk(&line, [line.s(0.0), f64::INFINITY], Ask::First, |s, _| {
            let t = line.t(s);
            if t > 0.0 && t < f64::INFINITY {
                out.push(Crossing::new(t, 0));
            }
            ControlFlow::Continue(())
        });
    }

    /// The point is put back on the surface along the gradient: along the ray, rounding grows with the distance.
    ///
    /// - Accuracy: `point_error` = twice the rounding error of `|q_N|` over the slope, so that the sign at the end of
    ///   it is certain. Where the slope nearly vanishes (two parts of the surface touch) an error moves the surface by its
    ///   square root.
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let line = Line::new(&self.set, ray, self.grid.radius);
        let point = line.map_or_else(|| ray.at(crossing.t), |line| line.at(line.s(crossing.t)));
        // The surface lies within the ball, wherever the rounding of a far ray has put the point.
        let ball = DVec3::splat(self.radius());
        let mut point = if point.is_nan() { DVec3::ZERO } else { point.clamp(-ball, ball) };
        let mut value = self.set.value(point);
        for _ in 0..4 {
            let (off, slope2) = (value.size - self.bailout(), value.gradient.length_squared());
            let step = value.gradient * (off / slope2);
            // A step of Newton's is right where it is short against the curvature: κ |step| ≪ slope.
            if off.abs() <= value.error || !(step.length() * value.kappa < slope2.sqrt()) {
                break;
            }
            point -= step;
            value = self.set.value(point);
        }
        let n = crate::frame::unit(value.gradient).or_else(|| crate::frame::unit(point)).unwrap_or(DVec3::Y);
        let slope = value.gradient.length().max((4.0 * value.error * value.kappa).sqrt());
        let error = 2.0 * value.error / slope;
        Hit {
            t: crossing.t,
            point,
            point_error: (if error < self.radius() { error } else { self.radius() })
                + gamma(4) * point.length(),
            ng: n,
            n: self
                .shading
                .as_ref()
                .map_or(n, |set| crate::frame::unit(set.value(point).gradient).unwrap_or(n)),
            tangent: perpendicular_part(DVec3::new(n.z, 0.0, -n.x), n),
            uv: uv_of(point),
            face: crossing.face,
            part: crossing.part,
        }
    }

    /// The outermost point of the surface in the direction of `uv`, seen from the origin; the origin where there is none.
    fn point_at(&self, _face: u32, uv: DVec2) -> DVec3 {
        let (sin_u, cos_u) = (uv.x * TAU).sin_cos();
        let (sin_v, cos_v) = ((uv.y - 0.5) * PI).sin_cos();
        let outwards = DVec3::new(cos_v * cos_u, sin_v, -cos_v * sin_u);
        let ray = Ray::new(outwards * (2.0 * self.radius()), -outwards);
        match self.certified(&ray, 0.0, 2.0 * self.radius()) {
            Some(crossing) => self.hit(&ray, &crossing).point,
            None => DVec3::ZERO,
        }
    }

    fn bounds(&self) -> Aabb {
        self.grid.bounds
    }
}

impl Solid for Julia {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        let Some(line) = Line::new(&self.set, ray, self.grid.radius) else { return };
        let mut enter = None;
        self.walk(&line, [f64::NEG_INFINITY, f64::INFINITY], Ask::First, |s, inside| {
            let here = Crossing::new(line.t(s), 0);
            if inside {
                enter = Some(here);
            } else if let Some(enter) = enter.take().filter(|enter: &Crossing| enter.t < here.t) {
                out.push(Span { enter, leave: here });
            }
            ControlFlow::Continue(())
        });
    }

    /// - Accuracy: by the sign of `|q_N| − B`, rounded.
    fn contains(&self, p: DVec3) -> bool {
        self.contains_point(p)
    }
}
