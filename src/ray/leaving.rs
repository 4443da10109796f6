//! Ways to leave a surface: what [`Hit::origin_towards`] is measured against.
//!
//! A computed hit lies a little above or below the true surface, and a ray that starts there may meet the
//! surface it leaves. Every remedy moves the origin; they differ in how far, and in what that length is tied to:
//!
//! | way | moves by | along |
//! |---|---|---|
//! | [`Leaving::ErrorBound`] | the hit's own error bound | the geometric normal |
//! | [`Leaving::RoundedAway`] | the same, and each coordinate to its next neighbour | the geometric normal |
//! | [`Leaving::Integer`] | 256 units in the last place of each coordinate | the geometric normal |
//! | [`Leaving::AlongNormal`] | a constant [lengths of the scene] | the normal on the viewer's side |
//! | [`Leaving::Ahead`] | a constant | the ray that leaves |
//! | [`Leaving::Back`] | a constant | against the ray that arrived |
//! | [`Leaving::OnTheSpot`] | nothing | |
//!
//! Renderers call `origin_towards`; everything else here is a contestant, for comparisons.

use super::Hit;
use crate::num::certified::power_of_two_below;
use glam::DVec3;

/// A way to choose the origin of a ray that leaves a hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Leaving {
    /// [`Hit::origin_towards`]: the default.
    ErrorBound,
    /// By the error bound, then each coordinate that moved goes on to its next neighbour away from the surface.
    ///
    /// ```text
    /// o = p ± (|n| · e) n,    then oᵢ to its neighbour on the side of the move,    e = (error, error, error)
    /// ```
    ///
    /// The neighbour makes up for the rounding of the sum, where the default adds `2 u` of the largest coordinate.
    ///
    /// - Source: Pharr, Jakob & Humphreys, *Physically Based Rendering*, 4th ed. (2023) §6.8.6 `OffsetRayOrigin`,
    ///   with this library's bounds as `e`.
    RoundedAway,
    /// [`integer_offset`], on the side of [`Departure::side`].
    Integer,
    /// A constant along the normal, on the side that the arriving ray saw: "shadow bias" [B §7.4.1, 10⁻⁴].
    ///
    /// Wrong side for a ray that goes through the surface.
    AlongNormal(f64),
    /// A constant along the ray that leaves [A ill. 69, 0.01]; the same as to ignore what it meets sooner than that
    /// [A ill. 57, 10⁻⁶; C §1.6.3, as a share of the sphere].
    ///
    /// At a grazing angle it hardly leaves the surface: height = constant × cos θ.
    Ahead(f64),
    /// A constant back along the ray that arrived [D §5.9.8].
    ///
    /// Wrong side for a ray that goes through the surface.
    Back(f64),
    /// The computed point itself.
    OnTheSpot,
}

/// How a ray leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Departure {
    /// Direction of the ray that arrived, of any length.
    pub arriving: DVec3,
    /// Any direction into the side of the surface from which the ray sets out: that of the viewer for shadows and
    /// reflections, the other for what is transmitted.
    pub side: DVec3,
    /// Direction of the ray that leaves, of any length.
    pub leaving: DVec3,
}

impl Leaving {
    /// Where a ray starts.
    ///
    /// - Domain: directions that are not zero; a zero one moves nothing.
    /// - NaN in, NaN out.
    #[inline]
    pub fn origin(self, hit: &Hit, way: &Departure) -> DVec3 {
        let along = |d: DVec3, length: f64| {
            // In units of its own size, so that no square overflows or vanishes.
            let scaled = d / power_of_two_below(d.abs().max_element());
            hit.point + scaled.normalize_or_zero() * length
        };
        match self {
            Leaving::ErrorBound => hit.origin_towards(way.side),
            Leaving::RoundedAway => rounded_away(hit.point, hit.ng, hit.point_error, way.side),
            Leaving::Integer => {
                integer_offset(hit.point, if way.side.dot(hit.ng) < 0.0 { -hit.ng } else { hit.ng })
            }
            Leaving::AlongNormal(bias) => {
                hit.point + hit.ng * if way.arriving.dot(hit.ng) > 0.0 { -bias } else { bias }
            }
            Leaving::Ahead(bias) => along(way.leaving, bias),
            Leaving::Back(bias) => along(way.arriving, -bias),
            Leaving::OnTheSpot => hit.point,
        }
    }
}

/// See [`Leaving::RoundedAway`].
fn rounded_away(p: DVec3, ng: DVec3, error: f64, side: DVec3) -> DVec3 {
    let distance = ng.abs().element_sum() * error;
    let offset = ng * if side.dot(ng) < 0.0 { -distance } else { distance };
    let away = |x: f64, step: f64| match step {
        s if s > 0.0 => x.next_up(),
        s if s < 0.0 => x.next_down(),
        _ => x,
    };
    let moved = p + offset;
    DVec3::new(away(moved.x, offset.x), away(moved.y, offset.y), away(moved.z, offset.z))
}

/// Units in the last place by which a coordinate moves along a normal that runs along it.
const STEPS: f64 = 256.0;
/// Coordinates below this are moved by [`NEAR`] instead: their own units would be too small [lengths of the scene].
const ORIGIN: f64 = 1.0 / 32.0;
/// The constant move of small coordinates, in units of the format's epsilon: `2⁻¹⁶` for `f32`.
const NEAR: f64 = 128.0;

macro_rules! integer_offset {
    ($name:ident, $float:ty, $int:ty, $(#[$doc:meta])*) => {
        $(#[$doc])*
        #[inline]
        pub fn $name(p: [$float; 3], n: [$float; 3]) -> [$float; 3] {
            std::array::from_fn(|i| {
                if p[i].abs() < ORIGIN as $float {
                    return p[i] + NEAR as $float * <$float>::EPSILON * n[i];
                }
                let steps = (STEPS as $float * n[i]) as $int;
                let steps = if p[i] < 0.0 { -steps } else { steps };
                <$float>::from_bits((p[i].to_bits() as $int).wrapping_add(steps) as _)
            })
        }
    };
}

integer_offset!(
    integer_offset_single,
    f32,
    i32,
    /// The point moved along `n` by counting representable numbers, in single precision as published.
    ///
    /// ```text
    /// oᵢ = pᵢ and 256 nᵢ steps of the format more (whole ones)   where |pᵢ| ≥ 1/32
    /// oᵢ = pᵢ + 2⁻¹⁶ nᵢ                                          below: a length of the scene's unit
    /// ```
    ///
    /// - Domain: |p| below 2⁻¹⁰ of the largest number; `n` a unit vector. It knows the point only: an error that comes from
    ///   elsewhere (a large sphere's, of which the point lies near the world's origin) may exceed it.
    /// - Source: C. Wächter & N. Binder, *A Fast and Robust Method for Avoiding Self-Intersection*, Ray Tracing Gems
    ///   (2019) ch. 6, listing 6-1. Its 256, 1/32 and 2⁻¹⁶ are tuned by the authors on scenes in metres.
);
integer_offset!(
    integer_offset_double,
    f64,
    i64,
    /// [`integer_offset_single`] in double precision: 256 steps of that format, and `2⁻⁴⁵ nᵢ` below 1/32, both as many
    /// units of the format as published.
);

/// [`integer_offset_double`] of vectors.
#[inline]
pub fn integer_offset(p: DVec3, n: DVec3) -> DVec3 {
    DVec3::from_array(integer_offset_double(p.to_array(), n.to_array()))
}
