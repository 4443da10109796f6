//! Many shadow segments from one point: how an area light is asked what reaches it.
//!
//! The rays to the points of a light share their origin, so shapes test them eight at a time, in whatever
//! vectors the processor has. The arithmetic is the same operation by operation, hence so are the
//! pictures: `vectorised!` compiles one body for the default target and for AVX2.

use crate::bounds::Aabb;
use crate::num::gamma;
pub use crate::num::vectors::Vectors;
pub(crate) use crate::num::vectors::vectorised;
use glam::DVec3;

/// Segments tested together.
pub const LANES: usize = 8;

/// The points that a fan's segments end in: the points of a light.
#[derive(Clone, Debug, Default)]
pub struct Ends {
    x: Vec<f64>,
    y: Vec<f64>,
    z: Vec<f64>,
    len: usize,
    hull: Option<Aabb>,
    center: DVec3,
    radius: f64,
}

impl Ends {
    /// No ends yet, in a ball of `radius` about `center`.
    pub fn within(center: DVec3, radius: f64) -> Self {
        Ends { center, radius, ..Default::default() }
    }

    /// Takes these points instead, reusing the memory.
    pub fn place(&mut self, points: impl Iterator<Item = DVec3>) {
        self.x.clear();
        self.y.clear();
        self.z.clear();
        let mut hull = Aabb::EMPTY;
        for p in points {
            hull = Aabb::new(hull.min.min(p), hull.max.max(p));
            self.x.push(p.x);
            self.y.push(p.y);
            self.z.push(p.z);
        }
        self.hull = Some(hull);
        self.len = self.x.len();
        for v in [&mut self.x, &mut self.y, &mut self.z] {
            v.resize(self.len.next_multiple_of(LANES), *v.last().unwrap_or(&0.0));
        }
    }
}

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

    /// Aims at `ends` from `origin`, reusing this fan's memory.
    ///
    /// Each segment stops short of its end by the rounding errors of the coordinates it was made from, so
    /// that a light may touch the surface that carries it.
    pub fn aim(&mut self, origin: DVec3, ends: &Ends) {
        let to = ends.center - origin;
        let distance = to.length();
        let hull = ends.hull.unwrap_or(Aabb::EMPTY);
        let coordinates = origin.abs().max_element() + ends.center.abs().max_element() + ends.radius;
        let nearest = (origin.clamp(hull.min, hull.max) - origin).length();
        // Never by more than half the digits, even where the origin lies among the ends.
        let shorten = 1.0 - (gamma(16) * (1.0 + coordinates / nearest)).min(f64::EPSILON.sqrt());
        self.origin = origin;
        self.hull = Aabb::new(hull.min.min(origin), hull.max.max(origin));
        self.len = ends.len;
        // A point within the ends' ball sees them in every direction: a cone of half angle π.
        let everywhere = !(distance > ends.radius);
        self.axis = if distance > 0.0 { to / distance } else { DVec3::Y };
        self.sin_spread = if everywhere { 1.0 } else { ends.radius / distance };
        self.cos_spread =
            if everywhere { -1.0 } else { ((1.0 - self.sin_spread) * (1.0 + self.sin_spread)).sqrt() };
        let vectors = self.vectors;
        for (to, from, origin) in [
            (&mut self.x, &ends.x, origin.x),
            (&mut self.y, &ends.y, origin.y),
            (&mut self.z, &ends.z, origin.z),
        ] {
            to.resize(from.len(), 0.0);
            subtract(vectors, to, from, origin, shorten);
        }
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
}

vectorised! {
    fn subtract(to: &mut [f64], from: &[f64], origin: f64, shorten: f64) {
        for (to, from) in to.iter_mut().zip(from) {
            *to = (from - origin) * shorten;
        }
    }
}
