//! Distance fields against the shapes they are the distances of; combinations; and marching against the shapes' formulas.

use crate::shape_laws;
use crate::shapes::{Inside, Member, Pose, rays};
use glam::{DMat3, DVec2, DVec3, dvec3};
use lightbench::num::{U, gamma};
use lightbench::ray::{Crossing, Ray};
use lightbench::sdf::capsule::Capsule;
use lightbench::sdf::combine::{Difference, Intersection, Offset, Rippled, SmoothUnion, Union, smooth_min};
use lightbench::sdf::general::{bisection, brackets, first, newton};
use lightbench::sdf::placed::Placed;
use lightbench::sdf::printed::AsPrinted;
use lightbench::sdf::{DistanceField, FieldShape, March, Menger, Stride, central_difference};
use lightbench::shape::cone::Cone;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::cylinder::Cylinder;
use lightbench::shape::plane::Plane;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::torus::Torus;
use lightbench::shape::{Shape, ShapeError, Solid};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};

fn config(cases: u32) -> Config {
    Config {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(8),
        max_global_rejects: 1 << 20,
        ..Config::default()
    }
}

fn blob(pose: &Pose) -> FieldShape<SmoothUnion<Sphere, Sphere>> {
    let ball = |x: f64| Sphere::new(pose.point(dvec3(x, 0.0, 0.0)), 0.5 * pose.scale).unwrap();
    FieldShape::new(SmoothUnion::new(ball(-0.0625), ball(0.0625), 0.5 * pose.scale).unwrap()).unwrap()
}

fn lens(pose: &Pose) -> FieldShape<Intersection<Sphere, Cuboid>> {
    let (a, b) = (pose.point(DVec3::splat(-0.6)), pose.point(DVec3::splat(0.7)));
    let ball = Sphere::new(pose.point(DVec3::ZERO), 0.75 * pose.scale).unwrap();
    FieldShape::new(Intersection(ball, Cuboid::new(a.min(b), a.max(b)).unwrap())).unwrap()
}

/// Texture coordinates are seen along the axis nearest to the normal: there the surface slopes by √2 at most.
const BLOB: Member = Member {
    make: |pose| Box::new(blob(pose)),
    solid: Some(|pose| Box::new(blob(pose))),
    near: |p, _, reach| blob(&Pose::HOME).field().distance(p).abs() <= reach,
    uv_slope: |_| 3.0,
    inside: Inside::Any,
};

const LENS: Member = Member {
    make: |pose| Box::new(lens(pose)),
    solid: Some(|pose| Box::new(lens(pose))),
    near: |p, _, reach| lens(&Pose::HOME).field().distance(p).abs() <= reach,
    uv_slope: |_| 3.0,
    inside: Inside::Convex,
};

/// The laws of every shape but one: a field is evaluated where the ray is, and rounds with the distance from the world's
/// origin; [`moved_together_a_field_moves`] says by how much.
macro_rules! field_laws {
    ($name:ident, $member:expr) => {
        mod $name {
            use super::*;
            shape_laws!(
                @each $member;
                crossings_ascend_and_nearest_is_the_first,
                hit_points_lie_within_their_error,
                normals_and_tangents_are_unit_and_square,
                t_counts_lengths_of_the_direction,
                texture_coordinates_lead_back,
                finite_input_never_makes_nan,
                entering_and_leaving_alternate,
                normals_point_outwards,
            );
        }
    };
}

field_laws!(blob_laws, BLOB);
field_laws!(lens_laws, LENS);

/// Scaled by powers of two, moved by whole numbers, coordinates renamed: the same crossings, each across the surface as
/// near as its point's error says.
#[test]
fn moved_together_a_field_moves() {
    let poses = (-300..300i32, [-8..8i32, -8..8, -8..8], 0..3usize).prop_map(|(power, shift, cycle)| Pose {
        scale: 2f64.powi(power),
        shift: DVec3::from_array(shift.map(f64::from)),
        cycle,
    });
    proptest!(config(2_000), |(ray in rays(), pose in poses)| {
        for member in [BLOB, LENS] {
            let (home, moved) = ((member.make)(&Pose::HOME), (member.make)(&pose));
            let there = Ray::new(pose.point(ray.origin), pose.vector(ray.direction));
            let (a, b) = (crossings(&*home, &ray), crossings(&*moved, &there));
            prop_assert_eq!(a.len(), b.len());
            for (a, b) in a.iter().zip(&b) {
                let (here, far) = (home.hit(&ray, a), moved.hit(&there, b));
                let across = (b.t / pose.scale - a.t) * ray.direction.dot(here.ng);
                prop_assert!(across.abs() <= here.point_error + far.point_error / pose.scale, "{a:?} {b:?}");
            }
        }
    });
}

/// A solid with a formula, and the same as a field.
struct Twin {
    name: &'static str,
    solid: Box<dyn Solid>,
    field: Box<dyn DistanceField>,
}

fn twin<S: Solid + DistanceField + Clone + 'static>(name: &'static str, shape: S) -> Twin {
    Twin { name, solid: Box::new(shape.clone()), field: Box::new(shape) }
}

/// Every shape that is a field, about `center` and of size about `size`; the torus stands at the origin.
fn twins(center: DVec3, size: f64) -> Vec<Twin> {
    let at = |x: f64, y: f64, z: f64| center + dvec3(x, y, z) * size;
    let (p0, p1) = (at(-0.3, -0.5, 0.1), at(0.4, 0.6, 0.2));
    vec![
        twin("sphere", Sphere::new(center, 0.8 * size).unwrap()),
        twin("box", Cuboid::new(at(-0.7, -0.4, -0.5), at(0.6, 0.8, 0.3)).unwrap()),
        twin("torus", Torus::new(0.7 * size, 0.25 * size).unwrap()),
        twin("cylinder", Cylinder::new(p0, p1, 0.4 * size).unwrap()),
        twin("cone", Cone::new(p0, p1, 0.6 * size, 0.0).unwrap()),
        twin("frustum", Cone::new(p0, p1, 0.3 * size, 0.7 * size).unwrap()),
    ]
}

/// Fields of every kind.
fn fields() -> Vec<(&'static str, Box<dyn DistanceField>)> {
    let ball = Sphere::new(dvec3(0.2, -0.1, 0.3), 0.6).unwrap();
    let cube = Cuboid::new(DVec3::splat(-0.5), DVec3::splat(0.4)).unwrap();
    let ring = Torus::new(0.7, 0.2).unwrap();
    let rod = Capsule::new(dvec3(-0.4, 0.0, 0.5), dvec3(0.5, 0.3, -0.2), 0.25).unwrap();
    let turn = DMat3::from_axis_angle(dvec3(1.0, 2.0, 2.0) / 3.0, 0.7);
    vec![
        ("plane", Box::new(Plane::new(dvec3(0.1, 0.2, 0.3), dvec3(1.0, -2.0, 0.5)).unwrap())),
        ("capsule", Box::new(rod)),
        ("union", Box::new(Union(ball, cube))),
        ("intersection", Box::new(Intersection(ball, cube))),
        ("difference", Box::new(Difference(cube, ball))),
        ("smooth union", Box::new(SmoothUnion::new(cube, ring, 0.3).unwrap())),
        ("offset", Box::new(Offset::new(cube, 0.1).unwrap())),
        ("shrunk", Box::new(Offset::new(cube, -0.1).unwrap())),
        ("rippled", Box::new(Rippled::new(ball, 0.05, 20.0).unwrap())),
        ("placed", Box::new(Placed::new(Difference(cube, rod), turn, 1.5, dvec3(0.3, -0.2, 0.1)).unwrap())),
        ("sponge", Box::new(Menger::new(DVec3::splat(0.1), 1.5, 4).unwrap())),
        ("nested", Box::new(Union(SmoothUnion::new(ring, rod, 0.2).unwrap(), Difference(cube, ball)))),
    ]
}

fn every_field() -> Vec<(&'static str, Box<dyn DistanceField>)> {
    let shapes = twins(DVec3::ZERO, 1.0).into_iter().map(|t| (t.name, t.field));
    shapes.chain(fields()).collect()
}

fn vector(reach: f64) -> impl Strategy<Value = DVec3> {
    [-reach..reach, -reach..reach, -reach..reach].prop_map(DVec3::from_array)
}

/// (1) of the module, from near and far: what marching stands on.
#[test]
fn no_field_changes_faster_than_its_bound() {
    let all = every_field();
    proptest!(config(20_000), |(p in vector(2.0), d in vector(1.0), far in -6f64..3.0)| {
        let p = p * 10f64.powf(far.max(0.0));
        let q = p + d * 10f64.powf(far.min(0.0));
        for (name, field) in &all {
            let change = (field.distance(p) - field.distance(q)).abs();
            let blur = field.rounding(p) + field.rounding(q);
            prop_assert!(change <= field.lipschitz() * (p - q).length() * (1.0 + gamma(8)) + blur, "{name} {p} {q}");
        }
    });
}

/// The rippled sphere's bound is one: near places it is reached to a tenth, so that it cannot be made smaller by much.
#[test]
fn the_ripples_are_as_steep_as_they_say() {
    let field = Rippled::new(Sphere::new(DVec3::ZERO, 1.0).unwrap(), 0.05, 20.0).unwrap();
    let steepest = (0..40_000).map(|i| {
        let u = lightbench::sample::r2(1, i);
        central_difference(&field, lightbench::sample::uniform_sphere(u) * (0.9 + 0.2 * u.x), 1e-6).length()
    });
    let steepest = steepest.fold(0.0, f64::max);
    assert_eq!(field.lipschitz(), 2.0);
    assert!(steepest <= 2.0 + 1e-6 && steepest > 1.8, "{steepest}");
}

/// Everything where the field is at most a level lies in its bounds.
#[test]
fn bounds_hold_what_they_promise() {
    let all = every_field();
    proptest!(config(20_000), |(p in vector(2.5), level in prop_oneof![Just(0.0), 0.0f64..1.0])| {
        for (name, field) in &all {
            let b = field.bounds(level);
            prop_assert!(field.distance(p) > level || b.contains(p), "{name}: {p} is not in {b:?}");
        }
    });
}

/// Points that the shapes say lie on the surface are where the field is 0, up to what both promise; and the signs agree.
#[test]
fn fields_are_zero_on_the_shapes_surfaces() {
    let scales = prop_oneof![Just(0.0), -8f64..9.0];
    proptest!(config(10_000), |(o in vector(3.0), way in vector(1.0), p in vector(1.2), power in scales, shift in vector(2.0))| {
        let size = 10f64.powf(power);
        for Twin { name, solid, field } in twins(shift * size, size) {
            let shift = if name == "torus" { DVec3::ZERO } else { shift };
            let ray = Ray::new((shift + o) * size, (way - o) * size);
            prop_assume!(way != o);
            let mut found = Vec::new();
            solid.crossings(&ray, &mut found);
            for c in found {
                let hit = solid.hit(&ray, &c);
                let off = field.distance(hit.point).abs();
                prop_assert!(off <= hit.point_error + field.rounding(hit.point), "{name}: {off:e} at {hit:?}");
            }
            let q = (shift + p) * size;
            let f = field.distance(q);
            prop_assert!(f.abs() <= 2.0 * field.rounding(q) || solid.contains(q) == (f < 0.0), "{name}: {f:e} at {q}");
        }
    });
}

/// Exact distances: from any point the way down the gradient, as long as the distance, ends on the surface, and no ray
/// meets the shape sooner. On the medial axis, where the gradient jumps, the central difference is no direction.
#[test]
fn distances_are_exact() {
    let all = twins(DVec3::ZERO, 1.0);
    proptest!(config(10_000), |(p in vector(2.0), way in vector(1.0))| {
        prop_assume!(way.length() > 0.01);
        for Twin { name, solid, field } in &all {
            let (f, g) = (field.distance(p), field.gradient(p));
            if (g.length() - 1.0).abs() < 1e-7 || *name == "sphere" {
                // The difference errs by 10⁻⁹ or so, which tilts the way; distance is blind to that in first order, but
                // beside an edge of the field the error is 1e-7 of the way at most.
                let foot = p - g.normalize() * f;
                prop_assert!(field.distance(foot).abs() <= 1e-6 * f.abs() + 4.0 * field.rounding(p), "{name} {p} {f}");
            }
            if let Some(c) = solid.nearest(&Ray::new(p, way.normalize()), 0.0, f64::INFINITY) {
                prop_assert!(c.t >= f.abs() - 4.0 * field.rounding(p), "{name}: {} sooner than {f}", c.t);
            }
        }
    });
}

/// Between the minimum and a quarter of `k` below it; the minimum itself where the two are `k` apart; no steeper than either.
#[test]
fn the_smooth_minimum_keeps_its_bounds() {
    proptest!(config(20_000), |(a in -5f64..5.0, b in -5f64..5.0, da in -1f64..1.0, db in -1f64..1.0, k in 1e-3f64..4.0)| {
        let (s, least) = (smooth_min(a, b, k), a.min(b));
        let blur = gamma(8) * (least.abs() + k);
        prop_assert!(s <= least + blur && s >= least - 0.25 * k - blur);
        prop_assert!((a - b).abs() < k || s == least);
        let moved = smooth_min(a + da, b + db, k);
        prop_assert!((moved - s).abs() <= da.abs().max(db.abs()) + 16.0 * blur);
    });
}

fn crossings(shape: &dyn Shape, ray: &Ray) -> Vec<Crossing> {
    let mut out = Vec::new();
    shape.crossings(ray, &mut out);
    out
}

/// By every stride: a crossing that marching finds is one of the shape's, to rounding across the surface; and what it passes
/// over is no deeper than the tolerance says. From places near and far, inside and out, at every scale.
#[test]
fn marching_finds_what_the_formulas_find() {
    let scales = prop_oneof![Just(0.0), -8f64..9.0];
    let case = (vector(1.0), vector(1.0), -1f64..4.0, scales, vector(2.0), -3f64..3.0);
    proptest!(config(4_000), |((from, to, far, power, shift, length) in case)| {
        let size = 10f64.powf(power);
        for Twin { name, solid, field } in twins(shift * size, size) {
            let shift = if name == "torus" { DVec3::ZERO } else { shift };
            let target = (shift + to) * size;
            let ray = Ray::new(target + from * 10f64.powf(far) * size, -from * 10f64.powf(length));
            prop_assume!(from.length() > 0.01);
            let truth = crossings(&*solid, &ray);
            let speed = ray.direction.length();
            let marched = FieldShape::new(field).unwrap();
            for stride in Stride::ALL {
                let march = marched.march().with_stride(stride);
                let reach = ray.origin.length() + 8.0 * size;
                let done = march.first(marched.field(), &ray, 0.0, reach);
                let unseen = 2.0 * done.tolerance + 4.0 * marched.field().rounding(ray.origin) + gamma(16) * reach;
                let depth = |t: f64| marched.field().distance(ray.at(t)) * sign(marched.field().distance(ray.origin));
                if let Some(s) = done.distance {
                    // Across the surface, whatever its slope: the field there is 0 within what the root is known to.
                    let off = marched.field().distance(ray.at(s / speed)).abs();
                    prop_assert!(off <= done.within + gamma(32) * reach, "{name} {stride:?}: {off:e} off, {done:?}");
                }
                let reached = done.distance.map_or(f64::INFINITY, |s| s / speed);
                for pair in truth.windows(2).step_by(1).filter(|w| w[1].t < reached) {
                    let middle = 0.5 * (pair[0].t + pair[1].t);
                    prop_assert!(depth(middle) >= -unseen, "{name} {stride:?}: passed {pair:?}, {done:?}");
                }
            }
        }
    });
}

fn sign(x: f64) -> f64 {
    if x < 0.0 { -1.0 } else { 1.0 }
}

/// Long strides are taken back where they might miss: all find the same first crossing, if it is no graze.
#[test]
fn every_stride_finds_the_same() {
    let all = every_field();
    proptest!(config(3_000), |(from in vector(3.0), to in vector(0.6))| {
        prop_assume!(from != to);
        let ray = Ray::new(from, (to - from).normalize());
        for (name, field) in all.iter().filter(|(name, _)| *name != "plane") {
            let march = March::through(field);
            let found = Stride::ALL.map(|stride| march.with_stride(stride).first(field, &ray, 0.0, 12.0));
            for other in &found[1..] {
                let (a, b) = (found[0], *other);
                let unseen = 2.0 * field.lipschitz() * a.tolerance.max(b.tolerance);
                match (a.distance, b.distance) {
                    (None, None) => {}
                    (Some(s), Some(t)) if (s - t).abs() <= a.within + b.within + gamma(16) * 8.0 => {}
                    (s, t) => {
                        // The one that came farther passed over something shallow: where the other stopped.
                        let s = s.into_iter().chain(t).fold(f64::INFINITY, f64::min);
                        let deepest = (1..200).map(|i| field.distance(ray.at(s + 1e-4 * f64::from(i) / 200.0)));
                        let outside = sign(field.distance(ray.origin));
                        let deepest = deepest.map(|f| f * outside).take_while(|f| *f <= 0.0).fold(0.0, f64::min);
                        prop_assert!(deepest >= -unseen, "{name}: {found:?} {deepest:e}");
                    }
                }
            }
        }
    });
}

/// Powers of two scale everything without rounding: the field, the steps, the crossings.
#[test]
fn scaling_by_powers_of_two_changes_nothing() {
    proptest!(config(3_000), |(from in vector(3.0), to in vector(0.6), e in -200i32..200)| {
        prop_assume!(from != to);
        let k = 2f64.powi(e);
        let ray = Ray::new(from, to - from);
        let far = Ray::new(from * k, ray.direction);
        let of = |k: f64| {
            let ball = Sphere::new(DVec3::ZERO, 0.5 * k).unwrap();
            FieldShape::new(Union(ball, Cuboid::new(DVec3::splat(-0.25 * k), DVec3::splat(0.75 * k)).unwrap())).unwrap()
        };
        let here: Vec<f64> = crossings(&of(1.0), &ray).iter().map(|c| c.t * k).collect();
        let there: Vec<f64> = crossings(&of(k), &far).iter().map(|c| c.t).collect();
        prop_assert_eq!(here, there);
    });
}

/// However a ray runs, along a face or past an edge: patience steps for each doubling between the tolerance and the way.
#[test]
fn steps_are_bounded() {
    let all = every_field();
    proptest!(config(3_000), |(from in vector(3.0), way in vector(1.0), flat in 0usize..8, height in -16f64..0.0)| {
        let mut way = way;
        (0..3).filter(|k| flat >> k & 1 == 1).for_each(|k| way[k] = 0.0);
        let from = dvec3(from.x, 0.4 + 10f64.powf(height), from.z);
        prop_assume!(way != DVec3::ZERO);
        for (name, field) in &all {
            let march = March::through(field);
            let done = march.first(field, &Ray::new(from, way), 0.0, 10.0);
            let doublings = (10.0 / march.tolerance).log2().ceil().max(1.0);
            prop_assert!(f64::from(done.steps) <= 2.0 * f64::from(march.patience) * (doublings + 1.0), "{name}: {done:?}");
        }
    });
}

/// A hit's point lies within its error of where the sign changes, and a ray that leaves along the normal is outside: the
/// surface does not shade itself.
#[test]
fn rays_leave_the_surface_they_hit() {
    let all: Vec<_> =
        every_field().into_iter().filter(|(n, f)| *n != "plane" && f.lipschitz() < 1.5).collect();
    proptest!(config(3_000), |(from in vector(1.0), to in vector(0.6), far in 0f64..4.0)| {
        let from = from.normalize() * 10f64.powf(far);
        prop_assume!(from.is_finite());
        for (name, field) in &all {
            let shape = FieldShape::new(field).unwrap();
            let ray = Ray::new(from, to - from);
            let Some(c) = shape.nearest(&ray, 0.0, f64::INFINITY) else { continue };
            let hit = shape.hit(&ray, &c);
            let slack = hit.point_error + field.rounding(hit.point);
            prop_assert!(field.distance(hit.point).abs() <= slack, "{name}");
            // At an edge the mean of two normals leaves along neither.
            let g = field.gradient(hit.point);
            if (g.length() - 1.0).abs() < 1e-6 {
                let out = hit.origin_towards(hit.ng);
                prop_assert!(field.distance(out) >= -field.rounding(out), "{name}: {}", field.distance(out));
            }
        }
    });
}

fn nasty() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => prop::sample::select(vec![0.0, -0.0, 5e-324, -1e-310, 1e-150, -1e150, 1e300, 1.0, -1.0, f64::MAX]),
        1 => -4.0f64..4.0,
        1 => (-150.0f64..150.0).prop_map(|e| 10f64.powf(e)),
    ]
}

#[test]
fn nothing_undefined_comes_out() {
    let shapes: Vec<_> = every_field()
        .into_iter()
        .filter_map(|(name, field)| Some((name, FieldShape::new(field).ok()?)))
        .collect();
    proptest!(config(5_000), |(o in prop::array::uniform3(nasty()), d in prop::array::uniform3(nasty()))| {
        let ray = Ray::new(DVec3::from_array(o), DVec3::from_array(d));
        for (name, shape) in &shapes {
            for c in crossings(shape, &ray) {
                let hit = shape.hit(&ray, &c);
                prop_assert!(c.t.is_finite() && c.t > 0.0, "{name}");
                prop_assert!(hit.point.is_finite() && hit.ng.is_finite() && hit.uv.is_finite(), "{name} {hit:?}");
            }
        }
    });
}

/// What has no end cannot be marched through, and what is no length is refused.
#[test]
fn what_is_no_field_is_refused() {
    let plane = Plane::new(DVec3::ZERO, DVec3::Y).unwrap();
    let ball = Sphere::new(DVec3::ZERO, 1.0).unwrap();
    assert!(matches!(FieldShape::new(plane), Err(ShapeError::NotFinite { .. })));
    assert!(FieldShape::new(Intersection(plane, ball)).is_ok());
    assert_eq!(Intersection(plane, ball).bounds(0.0).max.y, f64::MIN_POSITIVE * f64::EPSILON);
    assert!(matches!(SmoothUnion::new(ball, ball, 0.0), Err(ShapeError::NotPositive { .. })));
    assert!(matches!(Offset::new(ball, f64::NAN), Err(ShapeError::NotFinite { .. })));
    assert!(matches!(Rippled::new(ball, -1.0, 1.0), Err(ShapeError::NotPositive { .. })));
    assert!(matches!(Capsule::new(DVec3::ZERO, DVec3::X, 0.0), Err(ShapeError::NotPositive { .. })));
    let skewed = DMat3::from_diagonal(dvec3(1.0, 2.0, 1.0));
    assert!(matches!(Placed::new(ball, skewed, 1.0, DVec3::ZERO), Err(ShapeError::Flat { .. })));
    assert!(matches!(
        Placed::new(ball, DMat3::IDENTITY, 0.0, DVec3::ZERO),
        Err(ShapeError::NotPositive { .. })
    ));
}

/// The gradient's step is where truncation and rounding meet: a hundred times shorter or longer it is worse.
#[test]
fn the_difference_is_taken_at_the_right_step() {
    let torus = Torus::new(0.7, 0.25).unwrap();
    let worst = |h: f64| {
        let each = (0..500).map(|i| {
            let u = lightbench::sample::r2(3, i);
            let p = torus.point_at(0, u);
            let rho = p.x.hypot(p.y);
            let truth = (p - dvec3(p.x, p.y, 0.0) / rho * 0.7).normalize();
            (central_difference(&torus, p, h).normalize() - truth).length()
        });
        each.fold(0.0, f64::max)
    };
    let ours = 4.8e-6 * torus.detail();
    assert!(worst(ours) < 1e-8, "{:e}", worst(ours));
    assert!(worst(ours) < 0.1 * worst(100.0 * ours) && worst(ours) < 0.1 * worst(0.01 * ours));
    assert_eq!(torus.gradient(dvec3(1.0, 0.1, 0.2)), central_difference(&torus, dvec3(1.0, 0.1, 0.2), ours));
}

/// As printed, ε is below the rounding of a scene far from the world's origin, and rays are lost; a ray that leaves the
/// surface is said to hit it; a ray from inside walks backwards. The default does none of it.
#[test]
fn the_printed_march_fails_where_the_default_does_not() {
    let ball = Sphere::new(DVec3::ZERO, 1.0).unwrap();
    let (shape, printed) = (FieldShape::new(ball).unwrap(), AsPrinted::new(1e-9, 200));
    let away = dvec3(3e9, -2e9, 1e9);
    let far = Sphere::new(away, 1.0).unwrap();
    let far_shape = FieldShape::new(far).unwrap();
    let mut lost = 0;
    for i in 0..500 {
        let u = (lightbench::sample::r2(2, i) - 0.5) * 1.2;
        let ray = Ray::new(away + dvec3(4.0, 3.0, 5.0), dvec3(-4.0 + u.x, -3.0 + u.y, -5.0).normalize());
        lost += u32::from(printed.intersect(&[&far], &ray).0.is_none());
        let truth = far.nearest(&ray, 0.0, f64::INFINITY).unwrap().t;
        let found = far_shape.nearest(&ray, 0.0, f64::INFINITY).unwrap().t;
        // Across the surface the point is rounded to 4e-7; the rays meet it at 30° at least.
        assert!((found - truth).abs() <= 16.0 * U * 8e9, "{found} {truth}");
    }
    assert!(lost > 250, "{lost}");
    let leaving = Ray::new(dvec3(0.0, 1.0 + 1e-10, 0.0), DVec3::Y);
    assert!(printed.intersect(&[&ball], &leaving).0.is_some());
    assert_eq!(shape.nearest(&leaving, 0.0, f64::INFINITY), None);
    let inside = Ray::new(DVec3::ZERO, DVec3::X);
    assert!(printed.intersect(&[&ball], &inside).0.is_some_and(|(t, _)| t < 0.0));
    // A root is known to twice what rounding may hide: γ₃₂ of the field's terms and γ₈ of the way, each below 8.
    let out = shape.nearest(&inside, 0.0, f64::INFINITY).unwrap().t;
    assert!((out - 1.0).abs() <= 2.0 * 8.0 * gamma(40), "{out}");
    // Which of several is met.
    let cube = Cuboid::new(DVec3::splat(3.0), DVec3::splat(4.0)).unwrap();
    let (hit, _) = printed.intersect(&[&ball, &cube], &Ray::new(DVec3::splat(9.0), -DVec3::ONE.normalize()));
    assert_eq!(hit.unwrap().1, 1);
}

/// Leaping by the whole of a field twice too steep makes holes; dividing by its bound does not.
#[test]
fn steep_fields_are_leapt_through_unless_divided_by_their_bound() {
    let field = Rippled::new(Sphere::new(DVec3::ZERO, 1.0).unwrap(), 0.15, 20.0).unwrap();
    let shape = FieldShape::new(field).unwrap();
    let (mut holes, mut hits) = (0, 0);
    for i in 0..2000 {
        let u = lightbench::sample::r2(5, i) * 2.0 - DVec2::ONE;
        let ray = Ray::new(dvec3(u.x, u.y, 4.0), DVec3::NEG_Z);
        // A safe march by a tenth of the bound at most, and a change of sign.
        let scan = |t: f64| field.distance(ray.at(t));
        let truth = brackets(scan, 2.0, 6.0, 8000).next().map(|b| bisection(scan, b));
        let found = shape.nearest(&ray, 0.0, f64::INFINITY).map(|c| c.t);
        match (truth, found) {
            (None, None) => {}
            (Some(t), Some(s)) => assert!((t - s).abs() <= 1e-9, "{t} {s}"),
            // Between two places of the scan a ray may dip in and out.
            (None, Some(s)) => assert!((0..100).all(|k| scan(s + 1e-5 * f64::from(k)) > -1e-3)),
            (Some(t), None) => panic!("missed at {t}"),
        }
        let printed = AsPrinted::new(1e-4, 1000).intersect(&[&field], &ray).0;
        hits += u32::from(truth.is_some());
        holes += u32::from(truth.is_some_and(|t| printed.is_none_or(|(s, _)| (s - t).abs() > 1e-2)));
    }
    assert!(hits > 1000 && holes * 10 > hits, "{holes} holes of {hits}");
}

/// The general method: its roots are those of the formula, its condition cuts a sphere open, and it fails where it must.
#[test]
fn the_general_method_finds_roots_and_loses_pairs() {
    let ball = Sphere::new(DVec3::ZERO, 1.0).unwrap();
    let ray = Ray::new(dvec3(0.2, 0.3, 3.0), DVec3::NEG_Z);
    let f = |t: f64| ray.at(t).length_squared() - 1.0;
    let roots: Vec<f64> = brackets(f, 0.0, 6.0, 64).map(|b| bisection(f, b)).collect();
    let truth = ball.roots(&ray).unwrap();
    assert!(
        roots.len() == 2 && (roots[0] - truth.0).abs() <= 8.0 * U && (roots[1] - truth.1).abs() <= 16.0 * U
    );
    // A bowl: only the lower half counts.
    let bowl = first(roots.clone(), |t| ray.at(t).z < 0.0).unwrap();
    assert_eq!(bowl, roots[1]);
    assert_eq!(first(roots, |_| false), None);
    assert_eq!(first([-1.0, 0.0], |_| true), None);
    let slope = |t: f64| (f(t), 2.0 * ray.at(t).dot(ray.direction));
    assert!((newton(slope, 0.0, 1e-12, 50).unwrap() - truth.0).abs() <= 16.0 * U);
    assert_eq!(newton(slope, 3.0, 1e-12, 50), None); // the slope is 0 at the middle
    let graze = Ray::new(dvec3(0.0, 1.0 - 1e-6, 3.0), DVec3::NEG_Z);
    let f = |t: f64| graze.at(t).length_squared() - 1.0;
    assert_eq!(brackets(f, 0.0, 6.1, 64).count(), 0); // 0.003 apart, between two places
    assert!(FieldShape::new(ball).unwrap().blocks(&graze, f64::INFINITY));
}
