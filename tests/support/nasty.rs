//! Inputs that break programs, for proptest.
//!
//! Each generator mixes plain values with the ones on the edge of the format or of the geometry.

use glam::{DVec2, DVec3};
use lightbench::ray::Ray;
use lightbench::sample::{LARGEST_BELOW_ONE, uniform_sphere};
use proptest::prelude::*;

/// Any finite number worth fearing: ±0, subnormals, 10^±150, integers, numbers next to ±1, plain ones.
pub fn number() -> impl Strategy<Value = f64> {
    (magnitude(), any::<bool>()).prop_map(|(x, negative)| if negative { -x } else { x })
}

/// A number ≥ 0 of any size whose square neither overflows nor vanishes, or an edge of the format.
pub fn magnitude() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => 0.0..10.0,
        2 => positive(),
        1 => Just(0.0),
        1 => (1u64..1 << 52).prop_map(f64::from_bits), // subnormal
        1 => Just(f64::MIN_POSITIVE),
        1 => (0u32..8).prop_map(f64::from),
        1 => neighbour(1.0),
    ]
}

/// A positive number of any order between 10⁻¹⁵⁰ and 10¹⁵⁰: a scale of a scene.
pub fn positive() -> impl Strategy<Value = f64> {
    prop_oneof![2 => -3.0..3.0, 1 => -150.0..150.0].prop_map(|e: f64| 10f64.powf(e))
}

/// `x`, or a number at most 16 steps of the format away.
pub fn neighbour(x: f64) -> impl Strategy<Value = f64> {
    (-16i64..=16).prop_map(move |steps| f64::from_bits((x.to_bits() as i64 + steps) as u64))
}

/// Two numbers that differ by a few steps, or by 10⁻¹⁶ … 10⁻¹ relative: differences cancel.
pub fn near_pair() -> impl Strategy<Value = (f64, f64)> {
    prop_oneof![
        (positive(), 0i64..16).prop_map(|(x, k)| (x, f64::from_bits((x.to_bits() as i64 + k) as u64))),
        (positive(), -16.0..-1.0).prop_map(|(x, e)| (x, x * (1.0 + 10f64.powf(e)))),
    ]
    .prop_flat_map(|(a, b)| prop_oneof![Just((a, b)), Just((b, a)), Just((-a, -b))])
}

/// What a generator may hand out: 0, the smallest numbers, ½, the last number below 1, plain ones.
pub fn unit_interval() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => 0.0..1.0,
        2 => (-300.0..-1.0).prop_map(|e: f64| 10f64.powf(e)),
        2 => (1u64..1 << 40).prop_map(|k| 1.0 - k as f64 * lightbench::num::U), // near 1
        1 => Just(0.0),
        1 => Just(lightbench::num::U),
        1 => Just(f64::from_bits(1)),
        1 => Just(0.5),
        1 => Just(LARGEST_BELOW_ONE),
    ]
}

/// A point of [0,1)², also on its edges, corners and diagonals.
pub fn unit_square() -> impl Strategy<Value = DVec2> {
    prop_oneof![
        6 => (unit_interval(), unit_interval()).prop_map(DVec2::from),
        1 => unit_interval().prop_map(DVec2::splat),
        1 => unit_interval().prop_map(|u| DVec2::new(u, (1.0 - u).min(LARGEST_BELOW_ONE))),
    ]
}

/// A unit vector (to 3 u): anywhere, along an axis (also with −0), or 10⁻¹ … 10⁻³⁰⁰ off an axis.
pub fn unit_vector() -> impl Strategy<Value = DVec3> {
    let anywhere = (unit_interval(), unit_interval()).prop_map(|u| uniform_sphere(u.into()).normalize());
    let axis = (0usize..3, any::<bool>(), any::<[bool; 2]>()).prop_map(|(axis, negative, zeros)| {
        let mut v = DVec3::new(0.0, if zeros[0] { -0.0 } else { 0.0 }, if zeros[1] { -0.0 } else { 0.0 });
        v[axis] = if negative { -1.0 } else { 1.0 };
        v
    });
    let nearly =
        (axis.clone(), 0usize..3, prop_oneof![-16.0..-1.0, -300.0..-16.0]).prop_map(|(mut v, other, e)| {
            if v[other] == 0.0 {
                v[other] = 10f64.powf(e);
            }
            v.normalize()
        });
    prop_oneof![3 => anywhere, 1 => axis, 2 => nearly]
}

/// A point at a distance of any order from the origin.
pub fn point() -> impl Strategy<Value = DVec3> {
    prop_oneof![8 => (unit_vector(), positive()).prop_map(|(w, r)| w * r), 1 => Just(DVec3::ZERO)]
}

/// A ray that passes a sphere nearly at its rim.
#[derive(Clone, Copy, Debug)]
pub struct TangentRay {
    pub center: DVec3,
    pub radius: f64,
    pub ray: Ray,
    /// The line's distance from the centre is meant to be `radius · (1 + excess)`, up to rounding at the scale of
    /// origin and centre; 0 for a tangent.
    pub excess: f64,
}

/// Rays tangent to a sphere, or off by 10⁻¹⁶ … 10⁻², from near and from up to 10⁴ radii away.
pub fn tangent_ray() -> impl Strategy<Value = TangentRay> {
    let excess = prop_oneof![
        1 => Just(0.0),
        2 => (-16.0..-2.0).prop_map(|e: f64| 10f64.powf(e)),
        2 => (-16.0..-2.0).prop_map(|e: f64| -(10f64.powf(e))),
    ];
    let scale = (-3.0..3.0).prop_map(|e: f64| 10f64.powf(e));
    let distance = (-1.0..4.0).prop_map(|e: f64| 10f64.powf(e));
    (unit_vector(), unit_vector(), unit_vector(), scale, distance, excess).prop_map(
        |(direction, aside, place, radius, distance, excess)| {
            let aside =
                aside.cross(direction).try_normalize().unwrap_or_else(|| direction.any_orthonormal_vector());
            let center = place * radius;
            let rim = center + aside * (radius * (1.0 + excess));
            let origin = rim - direction * (radius * distance);
            TangentRay { center, radius, ray: Ray::new(origin, direction), excess }
        },
    )
}
