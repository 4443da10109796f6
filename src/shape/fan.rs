//! Many shadow segments from one point: how an area light is asked what reaches it.
//!
//! The rays to the points of a light share their origin, so shapes test them eight at a time, in whatever
//! vectors the processor has. The arithmetic is the same operation by operation, hence so are the
//! pictures: [`Fan::run`] compiles one body for the default target and for AVX2.

use crate::bounds::Aabb;
use crate::num::gamma;
use glam::DVec3;

/// Segments tested together.
pub const LANES: usize = 8;

/// Segments `origin + t d`, `0 < t < 1`, that start in one point.
///
/// The number of segments is padded to a multiple of [`LANES`] by repeating the last one.
#[derive(Clone, Debug)]
pub struct Fan {
    pub origin: DVec3,
    x: Vec<f64>,
    y: Vec<f64>,
    z: Vec<f64>,
    len: usize,
    /// Unit direction about which the segments spread, and the half angle of a cone that holds them all.
    pub axis: DVec3,
    pub sin_spread: f64,
    pub cos_spread: f64,
    /// Holds every segment.
    pub hull: Aabb,
    pub vectors: Vectors,
}

/// Which instructions the tests of a fan may use.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Vectors {
    /// The widest that the processor has.
    #[default]
    Widest,
    /// Those of the default target.
    Baseline,
}

/// [`LANES`] directions.
#[derive(Clone, Copy)]
pub struct Lanes<'a> {
    pub x: &'a [f64; LANES],
    pub y: &'a [f64; LANES],
    pub z: &'a [f64; LANES],
}

impl Fan {
    /// A fan without segments.
    pub fn new(vectors: Vectors) -> Self {
        Fan {
            origin: DVec3::ZERO,
            x: Vec::new(),
            y: Vec::new(),
            z: Vec::new(),
            len: 0,
            axis: DVec3::Y,
            sin_spread: 0.0,
            cos_spread: 1.0,
            hull: Aabb::EMPTY,
            vectors,
        }
    }

    /// Aims at `ends`, reusing this fan's memory; `center` and `radius` bound the ends by a sphere.
    ///
    /// Each segment stops short of its end by the rounding errors of the coordinates it was made from, so
    /// that a light may touch the surface that carries it.
    pub fn aim(&mut self, origin: DVec3, ends: impl Iterator<Item = DVec3>, center: DVec3, radius: f64) {
        self.origin = origin;
        self.x.clear();
        self.y.clear();
        self.z.clear();
        let mut hull = Aabb::new(origin, origin);
        let to = center - origin;
        let distance = to.length();
        let coordinates = origin.abs().max_element() + center.abs().max_element() + radius;
        let shorten = 1.0 - (gamma(16) * (1.0 + coordinates / (distance - radius).max(radius))).min(0.5);
        for end in ends {
            let d = (end - origin) * shorten;
            hull.min = hull.min.min(end);
            hull.max = hull.max.max(end);
            self.x.push(d.x);
            self.y.push(d.y);
            self.z.push(d.z);
        }
        self.hull = hull;
        self.len = self.x.len();
        while !self.x.is_empty() && !self.x.len().is_multiple_of(LANES) {
            let last = self.direction(self.len - 1);
            self.x.push(last.x);
            self.y.push(last.y);
            self.z.push(last.z);
        }
        let wide = !(distance > radius) || distance == 0.0;
        self.axis = if distance > 0.0 { to / distance } else { DVec3::Y };
        // A point of the ends' sphere sees every direction: a cone of half angle π.
        self.sin_spread = if wide { 1.0 } else { radius / distance };
        self.cos_spread =
            if wide { -1.0 } else { ((1.0 - self.sin_spread) * (1.0 + self.sin_spread)).sqrt() };
    }

    /// Number of segments, without the padding.
    pub fn len(&self) -> usize {
        self.len
    }

    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Number of segments with the padding: the length of what [`Shape::shade`](super::Shape::shade) fills.
    pub fn padded_len(&self) -> usize {
        self.x.len()
    }

    /// From the origin to the end of segment `i`.
    pub fn direction(&self, i: usize) -> DVec3 {
        DVec3::new(self.x[i], self.y[i], self.z[i])
    }

    /// The directions, eight by eight.
    #[inline(always)]
    pub fn lanes(&self) -> impl Iterator<Item = Lanes<'_>> {
        let [x, y, z] = [&self.x, &self.y, &self.z].map(|v| v.as_chunks::<LANES>().0);
        x.iter().zip(y).zip(z).map(|((x, y), z)| Lanes { x, y, z })
    }

    /// Runs `work`, compiled for the widest vectors that are allowed and that the processor has.
    ///
    /// `work` must be a closure around `#[inline(always)]` functions. Rust never contracts a product
    /// and a sum by itself, so every body rounds alike and gives the same bits.
    #[inline(always)]
    pub fn run(&self, work: impl FnOnce()) {
        #[cfg(target_arch = "x86_64")]
        if self.vectors == Vectors::Widest && std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has AVX2.
            unsafe { with_avx2(work) };
            return;
        }
        work();
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn with_avx2(work: impl FnOnce()) {
    work();
}
