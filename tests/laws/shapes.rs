//! The laws of every shape, written once; a shape joins with one line, `shape_laws!(name, MEMBER)`.

use glam::{DVec2, DVec3};
use lightbench::num::U;
use lightbench::num::double_double::DoubleDouble as Dd;
use lightbench::ray::{Crossing, Hit, Ray};
use lightbench::shape::{Shape, Solid};
use proptest::prelude::*;
use proptest::test_runner::Config;

/// A rigid motion and a scale that round nothing: powers of two, whole shifts, coordinates renamed.
#[derive(Clone, Copy, Debug)]
pub struct Pose {
    pub scale: f64,
    pub shift: DVec3,
    pub cycle: usize,
}

impl Pose {
    pub const HOME: Pose = Pose { scale: 1.0, shift: DVec3::ZERO, cycle: 0 };

    pub fn vector(&self, v: DVec3) -> DVec3 {
        DVec3::from_array([0, 1, 2].map(|i| v[(i + self.cycle) % 3]))
    }

    pub fn point(&self, p: DVec3) -> DVec3 {
        (self.vector(p) + self.shift) * self.scale
    }
}

pub type MakeSolid = fn(&Pose) -> Box<dyn Solid>;

/// A shape under the laws, of size about 1 about the origin when at home.
pub struct Member {
    pub make: fn(&Pose) -> Box<dyn Shape>,
    pub solid: Option<MakeSolid>,
    /// Does the surface of the shape at home come within `reach` of a point of `face`? In high precision.
    pub near: fn(DVec3, u32, f64) -> bool,
    /// By what the error of a texture coordinate is multiplied on its way to the point.
    pub uv_slope: fn(&Hit) -> f64,
    pub inside: Inside,
}

/// What a line does to the solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Inside {
    Convex,
    Any,
}

/// Coordinates on a grid of 2⁻³⁰, so that shifts by whole numbers are exact.
fn on_grid(x: f64) -> f64 {
    (x * 2f64.powi(30)).round() / 2f64.powi(30)
}

fn point(reach: f64) -> impl Strategy<Value = DVec3> {
    [-reach..reach, -reach..reach, -reach..reach].prop_map(|p| DVec3::from_array(p.map(on_grid)))
}

/// Rays towards the unit cube, from near and far, not normalised.
pub fn rays() -> impl Strategy<Value = Ray> {
    let origins = prop_oneof![point(1.0), point(4.0), point(1000.0)];
    (origins, point(1.1))
        .prop_filter_map("no direction", |(o, target)| (o != target).then(|| Ray::new(o, target - o)))
}

/// Finite numbers that programs trip over.
fn nasty_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(0.0),
        Just(-0.0),
        Just(1.0),
        Just(-1.0),
        Just(0.5),
        Just(5e-324),
        Just(1e-150),
        Just(-1e150),
        Just(1.0 + f64::EPSILON),
        -2.0..2.0,
        -1e9..1e9,
    ]
}

fn nasty_rays() -> impl Strategy<Value = Ray> {
    let vector = || [nasty_number(), nasty_number(), nasty_number()].prop_map(DVec3::from_array);
    (vector(), vector().prop_filter("no direction", |d| *d != DVec3::ZERO)).prop_map(|(o, d)| Ray::new(o, d))
}

fn config() -> Config {
    Config { cases: 1000, failure_persistence: None, ..Config::default() }
}

fn crossings(shape: &dyn Shape, ray: &Ray) -> Vec<Crossing> {
    let mut out = Vec::new();
    shape.crossings(ray, &mut out);
    out
}

pub fn crossings_ascend_and_nearest_is_the_first(member: &Member) {
    let shape = (member.make)(&Pose::HOME);
    proptest!(config(), |(ray in rays())| {
        let found = crossings(&*shape, &ray);
        prop_assert!(found.iter().all(|c| c.t > 0.0));
        prop_assert!(found.windows(2).all(|w| w[0].t <= w[1].t));
        prop_assert_eq!(shape.nearest(&ray, 0.0, f64::INFINITY), found.first().copied());
        prop_assert_eq!(shape.blocks(&ray, f64::INFINITY), !found.is_empty());
        for c in &found {
            prop_assert_eq!(shape.nearest(&ray, c.t, c.t), None);
            let from_there = shape.nearest(&ray, c.t.next_down(), f64::INFINITY);
            prop_assert_eq!(from_there.map(|n| n.t), Some(c.t));
        }
    });
}

pub fn hit_points_lie_within_their_error(member: &Member) {
    let shape = (member.make)(&Pose::HOME);
    proptest!(config(), |(ray in rays())| {
        for c in crossings(&*shape, &ray) {
            let hit = shape.hit(&ray, &c);
            prop_assert!(hit.point_error > 0.0);
            prop_assert!((member.near)(hit.point, hit.face, hit.point_error), "{hit:?}");
            // And it is the point of the ray: t is right to 1024 u, whatever the surface's slope makes of it.
            let along = ray.origin.abs().element_sum() + (ray.direction * c.t).abs().element_sum();
            let slant = ray.direction.normalize().dot(hit.ng).abs();
            prop_assert!((hit.point - ray.at(c.t)).length() <= 2048.0 * U * along / slant.max(U));
            // It lies in the bounds, widened by that error.
            let bounds = shape.bounds();
            let wide = DVec3::splat(hit.point_error);
            prop_assert!(hit.point.cmpge(bounds.min - wide).all() && hit.point.cmple(bounds.max + wide).all());
        }
    });
}

/// Normals: 8 roundings; a tangent is made square to the normal and then normalised.
pub fn normals_and_tangents_are_unit_and_square(member: &Member) {
    let shape = (member.make)(&Pose::HOME);
    proptest!(config(), |(ray in rays())| {
        for c in crossings(&*shape, &ray) {
            let hit = shape.hit(&ray, &c);
            prop_assert!((hit.ng.length() - 1.0).abs() <= 16.0 * U);
            prop_assert!((hit.tangent.length() - 1.0).abs() <= 16.0 * U);
            prop_assert!(hit.ng.dot(hit.tangent).abs() <= 32.0 * U, "{hit:?}");
            prop_assert_eq!(hit.n, hit.ng);
        }
    });
}

/// Both answers are right to 1024 u at worst.
pub fn moved_together_nothing_changes(member: &Member) {
    moved_together_stays_within(member, 0.0);
}

/// The same for shapes whose `t` also errs by `slack` lengths at home, however small it is.
pub fn moved_together_stays_within(member: &Member, slack: f64) {
    let home = (member.make)(&Pose::HOME);
    let poses = (-300..300i32, [-8..8i32, -8..8, -8..8], 0..3usize).prop_map(|(power, shift, cycle)| Pose {
        scale: 2f64.powi(power),
        shift: DVec3::from_array(shift.map(f64::from)),
        cycle,
    });
    proptest!(config(), |(ray in rays(), pose in poses)| {
        let moved = (member.make)(&pose);
        let there = Ray::new(pose.point(ray.origin), pose.vector(ray.direction));
        let (a, b) = (crossings(&*home, &ray), crossings(&*moved, &there));
        prop_assert_eq!(a.len(), b.len());
        for (a, b) in a.iter().zip(&b) {
            let expected = a.t * pose.scale;
            let slack = slack * pose.scale / ray.direction.length();
            prop_assert!((b.t - expected).abs() <= 2048.0 * U * expected + slack, "{a:?} {b:?}");
        }
    });
}

/// A direction twice as long halves `t`, and no more.
pub fn t_counts_lengths_of_the_direction(member: &Member) {
    let shape = (member.make)(&Pose::HOME);
    proptest!(config(), |(ray in rays(), power in -400..400i32)| {
        let factor = 2f64.powi(power);
        let stretched = Ray::new(ray.origin, ray.direction * factor);
        let (a, b) = (crossings(&*shape, &ray), crossings(&*shape, &stretched));
        prop_assert_eq!(a.len(), b.len());
        for (a, b) in a.iter().zip(&b) {
            prop_assert!((b.t * factor - a.t).abs() <= 2048.0 * U * a.t);
            prop_assert_eq!(a.face, b.face);
        }
    });
}

/// Angles of a turn err by 4 u of it, which is 2π 4 u of the circumference; lengths by what the point errs.
pub fn texture_coordinates_lead_back(member: &Member) {
    let shape = (member.make)(&Pose::HOME);
    proptest!(config(), |(ray in rays())| {
        for c in crossings(&*shape, &ray) {
            let hit = shape.hit(&ray, &c);
            let back = shape.point_at(hit.face, hit.uv);
            let size = 1.0 + hit.point.abs().element_sum();
            let allowed = (64.0 * U * size + 4.0 * hit.point_error) * (member.uv_slope)(&hit);
            prop_assert!((back - hit.point).length() <= allowed, "{hit:?} {back:?} {allowed}");
        }
    });
}

pub fn finite_input_never_makes_nan(member: &Member) {
    let shape = (member.make)(&Pose::HOME);
    let tiny = (member.make)(&Pose { scale: 2f64.powi(-490), ..Pose::HOME });
    let huge = (member.make)(&Pose { scale: 2f64.powi(490), ..Pose::HOME });
    proptest!(config(), |(ray in nasty_rays())| {
        for shape in [&shape, &tiny, &huge] {
            for c in crossings(&**shape, &ray) {
                prop_assert!(c.t.is_finite() && c.t > 0.0);
                let hit = shape.hit(&ray, &c);
                let numbers = [hit.point, hit.ng, hit.n, hit.tangent, hit.uv.extend(hit.point_error)];
                prop_assert!(numbers.iter().all(|v| !v.is_nan()), "{hit:?}");
            }
        }
    });
    for uv in [DVec2::ZERO, DVec2::ONE, DVec2::new(0.25, 0.75)] {
        for face in 0..3 {
            assert!(shape.point_at(face, uv).is_finite());
        }
    }
}

/// Spans ascend, hold points inside between their ends and outside elsewhere, and end where crossings are.
pub fn entering_and_leaving_alternate(member: &Member) {
    let Some(make) = member.solid else { return };
    let solid = make(&Pose::HOME);
    proptest!(config(), |(ray in rays())| {
        let mut spans = Vec::new();
        solid.spans(&ray, &mut spans);
        let ends: Vec<f64> = spans.iter().flat_map(|s| [s.enter.t, s.leave.t]).collect();
        prop_assert!(ends.windows(2).all(|w| w[0] < w[1]), "{ends:?}");
        let ahead = ends.iter().filter(|t| t.is_finite() && **t > 0.0).count();
        let found = crossings(&*solid, &ray).len();
        // A touch is a crossing, but no end of a span.
        prop_assert!(found == ahead || found == ahead + 1);
        if member.inside == Inside::Convex {
            prop_assert!(spans.len() <= 1);
            if solid.contains(ray.origin) {
                prop_assert!(ahead <= 1 && spans.iter().all(|s| s.enter.t <= 0.0 && s.leave.t >= 0.0));
            }
        }
        let stops: Vec<f64> = [-1e3].into_iter().chain(ends.into_iter().filter(|t| t.abs() < 1e3)).chain([1e3]).collect();
        for w in stops.windows(2) {
            let (middle, length) = (0.5 * (w[0] + w[1]), w[1] - w[0]);
            // The point at t is off the ray by its rounding; far inside a stretch that does not matter.
            if length > 1e-6 {
                let expected = spans.iter().any(|s| s.enter.t < middle && middle < s.leave.t);
                prop_assert_eq!(solid.contains(ray.at(middle)), expected, "at {}", middle);
            }
        }
    });
}

/// The normal points out of the solid: a step along it leaves, a step back enters.
pub fn normals_point_outwards(member: &Member) {
    let Some(make) = member.solid else { return };
    let solid = make(&Pose::HOME);
    proptest!(config(), |(ray in rays())| {
        for c in crossings(&*solid, &ray) {
            let hit = solid.hit(&ray, &c);
            // Well beyond the error, well below the size; edges and tips are left out by the slack at random rays.
            let step = hit.ng * (1e-7 + 4.0 * hit.point_error);
            prop_assert!(!solid.contains(hit.point + step), "{hit:?}");
            let out = hit.origin_towards(hit.ng);
            prop_assert!(!solid.contains(out), "{hit:?}");
        }
    });
}

/// All laws for one member.
#[macro_export]
macro_rules! shape_laws {
    ($name:ident, $member:expr) => {
        mod $name {
            #[allow(unused_imports)]
            use super::*;
            $crate::shape_laws!(
                @each $member;
                crossings_ascend_and_nearest_is_the_first,
                hit_points_lie_within_their_error,
                normals_and_tangents_are_unit_and_square,
                moved_together_nothing_changes,
                t_counts_lengths_of_the_direction,
                texture_coordinates_lead_back,
                finite_input_never_makes_nan,
                entering_and_leaving_alternate,
                normals_point_outwards,
            );
        }
    };
    (@each $member:expr; $($law:ident,)*) => {
        $(
            #[test]
            fn $law() {
                $crate::shapes::$law(&$member);
            }
        )*
    };
}

/// Vectors of 106 bits, to look at what `f64` computed.
pub fn exact(p: DVec3) -> [Dd; 3] {
    p.to_array().map(Dd::of)
}

pub fn dot(a: [Dd; 3], b: [Dd; 3]) -> Dd {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn minus(a: [Dd; 3], b: [Dd; 3]) -> [Dd; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn length(a: [Dd; 3]) -> Dd {
    dot(a, a).sqrt()
}
