//! The space a tree lives in, and rays in it.
//!
//! A tree keeps its boxes in `f32`, half as large as in `f64` and twice as many to a vector. So that nothing is lost
//! to their 24 bits, all it holds is moved and scaled into the cube [−1, 1]³, boxes are rounded outwards, and
//! rays start where they enter the cube, with a bound on how far they may be displaced.

use crate::bounds::Aabb;
use crate::num::certified::power_of_two_below;
use crate::ray::Ray;
use glam::DVec3;

/// Boxes that reach farther than this count as unbounded: beyond, differences and products could overflow.
pub(super) const FARTHEST: f64 = 3.0e150;

/// About `center`, in lengths of `size`, a power of two: everything lies in [−1, 1]³.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    center: DVec3,
    size: f64,
    per_size: f64,
}

/// A box in a frame, rounded outwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Box32 {
    pub min: [f32; 3],
    pub max: [f32; 3],
}

impl Frame {
    /// The frame of everything in a box.
    pub fn around(bounds: &Aabb) -> Self {
        let half = (bounds.max * 0.5 - bounds.min * 0.5).max_element();
        // The next power of two above; not below 10⁻¹⁵⁰, so that its square can be counted with.
        let size = 2.0 * power_of_two_below(half.clamp(1.0 / FARTHEST, FARTHEST));
        Frame { center: bounds.max * 0.5 + bounds.min * 0.5, size, per_size: 1.0 / size }
    }

    /// One rounding, relative to the distance from the centre.
    #[inline]
    pub fn place(&self, p: DVec3) -> DVec3 {
        (p - self.center) * self.per_size
    }

    #[inline]
    pub fn hold(&self, bounds: &Aabb) -> Box32 {
        let (min, max) = (self.place(bounds.min), self.place(bounds.max));
        Box32 { min: min.to_array().map(round_down), max: max.to_array().map(round_up) }
    }
}

impl Frame {
    /// A box of this frame in the space outside it.
    pub fn release(&self, b: &Box32) -> Aabb {
        let out = |p: [f32; 3]| DVec3::from_array(p.map(f64::from)) * self.size + self.center;
        Aabb::new(out(b.min), out(b.max))
    }
}

#[inline]
pub(super) fn round_down(x: f64) -> f32 {
    let y = x as f32;
    if f64::from(y) > x { y.next_down() } else { y }
}

#[inline]
pub(super) fn round_up(x: f64) -> f32 {
    let y = x as f32;
    if f64::from(y) < x { y.next_up() } else { y }
}

/// A ray in a tree's frame: `o + τ d`, from where it enters the root.
#[derive(Clone, Copy, Debug)]
pub(super) struct LocalRay {
    /// Origins displaced along and against the direction by the bound of their error, so that near faces seem
    /// nearer than they are, and far ones farther.
    pub near_origin: [f32; 3],
    pub far_origin: [f32; 3],
    /// `1/dᵢ`, finite.
    pub inverse: [f32; 3],
    /// Which of the six planes of a box is nearer, by axis.
    pub near_plane: [usize; 3],
    /// In full; bound on its error: infinite if nothing can be said, and everything is to be tested.
    pub origin: [f64; 3],
    pub shift: f32,
    pub direction: [f64; 3],
    pub direction32: [f32; 3],
    /// The axis along which the direction is longest, and `1/d` there.
    pub longest: usize,
    pub ahead: f64,
    per_size: f64,
    per_stretch: f64,
    start: f64,
    slack: f64,
}

/// `f32` makes three roundings in each `(x − o)·(1/d)`, relative to the result: `1 + 2γ₃` and something to spare.
pub(super) const WIDEN: f32 = 1.0 + 8.0 * f32::EPSILON;

/// Longer than any way through the root, counted in lengths of the direction's largest coordinate.
const THROUGH: f64 = 4.0;

/// Coordinates of directions are made at least this large. Within the root that moves a ray by at most `2⁻⁵⁸`,
/// and from the largest distance that is not given up by `2⁻⁶⁰ · 2⁴⁸`, within the displacement of `2⁻⁴⁸ · 2⁴⁸`.
const STEEPEST: f64 = 1.0 / (1u64 << 60) as f64;

/// Sizes of the tree from which its frame is lost in the rounding of the ray's origin.
const LOST: f64 = (1u64 << 48) as f64;

impl LocalRay {
    /// The ray within `root` and `t_min ≤ t ≤ t_max`, and how far it goes; `None` if it certainly misses.
    #[inline]
    pub fn enter(frame: &Frame, root: &Box32, ray: &Ray, t_min: f64, t_max: f64) -> Option<(Self, f32)> {
        let largest = ray.direction.abs().max_element();
        let stretch = 1.0 / power_of_two_below(largest);
        let origin = frame.place(ray.origin);
        let away = origin.abs().max_element();
        if !(away < LOST && largest >= f64::MIN_POSITIVE && largest < f64::INFINITY) {
            return Some((Self::everywhere(), THROUGH as f32));
        }
        let direction = ray.direction * stretch;
        let steep = direction.to_array().map(|d| if d.abs() < STEEPEST { STEEPEST.copysign(d) } else { d });
        let inverse = steep.map(|d| 1.0 / d);
        // Roundings of the frame and of the way to the root, and what `STEEPEST` moves; then of `f32`.
        let shift = (THROUGH + away) * 2f64.powi(-48);
        let displacement = f64::from(2.0 * f32::EPSILON) + shift;
        let d = direction.abs();
        let longest = if d.x >= d.y && d.x >= d.z {
            0
        } else if d.y >= d.z {
            1
        } else {
            2
        };
        let slack = (THROUGH + away) * 2f64.powi(-40);
        let per_stretch = 1.0 / stretch;
        let per_size = frame.per_size;
        let along = |t: f64| t * per_size * per_stretch;
        let (mut near, mut far) = (along(t_min) - slack, along(t_max) + slack);
        for i in 0..3 {
            let (a, b) = (f64::from(root.min[i]), f64::from(root.max[i]));
            let (first, last) = if inverse[i] < 0.0 { (b, a) } else { (a, b) };
            let back = displacement.copysign(inverse[i]);
            near = near.max((first - (origin[i] + back)) * inverse[i]);
            far = far.min((last - (origin[i] - back)) * inverse[i]);
        }
        if !(near <= far + slack) {
            return None;
        }
        let start = near;
        let origin = origin + direction * start;
        let mut local = LocalRay {
            near_origin: [0.0; 3],
            far_origin: [0.0; 3],
            inverse: inverse.map(|x| x as f32),
            near_plane: [0, 1, 2],
            origin: origin.to_array(),
            shift: shift as f32,
            direction: direction.to_array(),
            direction32: direction.as_vec3().to_array(),
            longest,
            ahead: inverse[longest],
            per_size,
            per_stretch,
            start,
            slack,
        };
        for i in 0..3 {
            let back = displacement.copysign(inverse[i]);
            local.near_origin[i] = (origin[i] + back) as f32;
            local.far_origin[i] = (origin[i] - back) as f32;
            local.near_plane[i] = if inverse[i] < 0.0 { i + 3 } else { i };
        }
        let limit = local.limit(t_max);
        Some((local, limit))
    }

    /// A ray that meets every box that is not empty.
    #[cold]
    fn everywhere() -> Self {
        LocalRay {
            near_origin: [1e30; 3],
            far_origin: [-1e30; 3],
            inverse: [1.0; 3],
            near_plane: [0, 1, 2],
            origin: [0.0; 3],
            shift: f32::INFINITY,
            direction: [1.0; 3],
            direction32: [1.0; 3],
            longest: 0,
            ahead: 1.0,
            per_size: 0.0,
            per_stretch: 0.0,
            start: 0.0,
            slack: f64::INFINITY,
        }
    }

    /// The `τ` beyond which nothing has a ray parameter of `t` or less.
    ///
    /// Tests may err in `t` by `2⁻⁴⁰` of the way and of the root's size, far more than any shape allows itself.
    #[inline]
    pub fn limit(&self, t: f64) -> f32 {
        let tau = t * self.per_size * self.per_stretch - self.start;
        let tau = (tau + self.slack) * f64::from(WIDEN);
        if tau < THROUGH { tau as f32 } else { THROUGH as f32 }
    }
}
