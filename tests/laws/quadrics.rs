//! Cylinder, cone, ellipsoid and the general quadric.

use crate::shape_laws;
use crate::shapes::{Inside, Member, Pose, dot, exact, length, minus};
use glam::{DVec2, DVec3};
use lightbench::bounds::Aabb;
use lightbench::num::U;
use lightbench::num::double_double::DoubleDouble as Dd;
use lightbench::ray::Ray;
use lightbench::shape::cone::{Cone, Ends};
use lightbench::shape::cylinder::Cylinder;
use lightbench::shape::quadric::{ClippedQuadric, Coefficients, Ellipsoid, Quadric};
use lightbench::shape::{Shape, ShapeError, Solid};
use proptest::prelude::*;
use proptest::test_runner::Config;

const P0: DVec3 = DVec3::new(-0.5, -0.25, 0.125);
const P1: DVec3 = DVec3::new(0.75, 0.5, -0.25);
const R0: f64 = 0.5;
const R1: f64 = 0.125;

/// Is `p` within `reach` of a face of the cone? Its side is straight, so that the distance is along its normal.
fn near_cone(p: DVec3, face: u32, reach: f64, [r0, r1]: [f64; 2]) -> bool {
    let axis = minus(exact(P1), exact(P0));
    let (height, w) = (length(axis), minus(exact(p), exact(P0)));
    let s = dot(w, axis) / height;
    let foot = axis.map(|x| x * s / height);
    let away = length(minus(w, foot));
    let growth = Dd::difference(r1, r0) / height;
    let slack = |x: Dd| x.value() <= reach;
    let within = slack(-s) && slack(s - height);
    match face {
        0 => {
            let off = (away - Dd::of(r0) - growth * s) / (Dd::of(1.0) + growth * growth).sqrt();
            within && off.value().abs() <= reach
        }
        1 => s.value().abs() <= reach && slack(away - Dd::of(r0)),
        _ => (s - height).value().abs() <= reach && slack(away - Dd::of(r1)),
    }
}

fn cylinder(pose: &Pose) -> Cylinder {
    Cylinder::new(pose.point(P0), pose.point(P1), R0 * pose.scale).unwrap()
}

fn cone(pose: &Pose, r1: f64) -> Cone {
    Cone::new(pose.point(P0), pose.point(P1), R0 * pose.scale, r1 * pose.scale).unwrap()
}

/// Points by angle and share of the radius: small circles make small steps.
const ROUND: Member = Member {
    make: |pose| Box::new(cylinder(pose)),
    solid: Some(|pose| Box::new(cylinder(pose))),
    near: |p, face, reach| near_cone(p, face, reach, [R0, R0]),
    uv_slope: |_| 1.0,
    inside: Inside::Convex,
};
const TUBE: Member =
    Member { make: |pose| Box::new(cylinder(pose).with_ends(Ends::Open)), solid: None, ..ROUND };
const FRUSTUM: Member = Member {
    make: |pose| Box::new(cone(pose, R1)),
    solid: Some(|pose| Box::new(cone(pose, R1))),
    near: |p, face, reach| near_cone(p, face, reach, [R0, R1]),
    ..ROUND
};
const POINTED: Member = Member {
    make: |pose| Box::new(cone(pose, 0.0)),
    solid: Some(|pose| Box::new(cone(pose, 0.0))),
    near: |p, face, reach| near_cone(p, face, reach, [R0, 0.0]),
    ..ROUND
};

/// The coefficients of the same surface in another pose: exact for these small numbers.
fn posed(q: Coefficients, pose: &Pose) -> Quadric {
    let square = |v: DVec3| {
        let x = DVec3::new(q.a, q.b, q.c).dot(v);
        let y = DVec3::new(q.b, q.e, q.f).dot(v);
        DVec3::new(x, y, DVec3::new(q.c, q.f, q.h).dot(v))
    };
    let back = Pose { cycle: 3 - pose.cycle, ..Pose::HOME };
    let axis = |i: usize| back.vector(DVec3::AXES[i]);
    let entry = |i: usize, j: usize| axis(i).dot(square(axis(j)));
    let shift = back.vector(pose.shift);
    let linear = DVec3::new(q.d, q.g, q.i) - square(shift);
    let line = |i: usize| axis(i).dot(linear) * pose.scale;
    let j = q.j - 2.0 * DVec3::new(q.d, q.g, q.i).dot(shift) + shift.dot(square(shift));
    Quadric::new(Coefficients {
        a: entry(0, 0),
        b: entry(0, 1),
        c: entry(0, 2),
        e: entry(1, 1),
        f: entry(1, 2),
        h: entry(2, 2),
        d: line(0),
        g: line(1),
        i: line(2),
        j: j * pose.scale * pose.scale,
    })
    .unwrap()
}

/// If the surface is within `reach`, then `|q(p)| ≤ |∇q| reach + ‖Q‖ reach²`.
fn near_quadric(p: DVec3, reach: f64, q: &Coefficients) -> bool {
    let x = exact(p);
    let rows = [[q.a, q.b, q.c], [q.b, q.e, q.f], [q.c, q.f, q.h]].map(|r| exact(DVec3::from_array(r)));
    let linear = exact(DVec3::new(q.d, q.g, q.i));
    let half = [0, 1, 2].map(|i| dot(rows[i], x) + linear[i]);
    let value = dot(x, half) + dot(x, linear) + Dd::of(q.j);
    let norm: f64 = rows.iter().map(|r| r.iter().map(|x| x.value().abs()).sum::<f64>()).fold(0.0, f64::max);
    value.value().abs() <= (2.0 * length(half).value() + norm * reach) * reach
}

/// A hyperboloid of one sheet, tilted.
const TILTED: Coefficients =
    Coefficients { a: 4.0, b: 0.5, c: -0.25, d: 0.125, e: 3.0, f: 1.0, g: 0.25, h: -2.0, i: -0.5, j: -0.5 };
/// `z = x² − y²`.
const SADDLE: Coefficients =
    Coefficients { a: 1.0, b: 0.0, c: 0.0, d: 0.0, e: -1.0, f: 0.0, g: 0.0, h: 0.0, i: -0.5, j: 0.0 };
/// `x² + y² = z²`.
const DOUBLE_CONE: Coefficients =
    Coefficients { a: 1.0, b: 0.0, c: 0.0, d: 0.0, e: 1.0, f: 0.0, g: 0.0, h: -1.0, i: 0.0, j: 0.0 };
/// `x² + 2y² + 4z² = 1/2`, shifted by an eighth.
const EGG: Coefficients =
    Coefficients { a: 1.0, b: 0.0, c: 0.0, d: -0.125, e: 2.0, f: 0.0, g: 0.0, h: 4.0, i: 0.0, j: -0.5 };

/// Over the mapping's axis the sheet is as steep as the normal says; near its outline it is vertical.
macro_rules! quadric {
    ($coefficients:ident, $axis:literal, $inside:expr) => {
        Member {
            make: |pose| Box::new(posed($coefficients, pose)),
            solid: Some(|pose| Box::new(posed($coefficients, pose))),
            near: |p, _, reach| near_quadric(p, reach, &$coefficients),
            uv_slope: |hit| {
                // δw = δ/|n_w| while the curvature does not matter, δ < n_w²; before that, no promise is made.
                let slope = hit.ng[$axis].abs();
                if slope * slope > 1e-6 { 4.0 / slope } else { f64::INFINITY }
            },
            inside: $inside,
        }
    };
}

const ELLIPSOID: Member = Member {
    make: |pose| Box::new(ellipsoid(pose)),
    solid: Some(|pose| Box::new(ellipsoid(pose))),
    near: |p, _, reach| near_quadric(p, reach, &Quadric::ellipsoid(CENTER, AXES).unwrap().coefficients()),
    uv_slope: |_| 1.0,
    inside: Inside::Convex,
};
const CENTER: DVec3 = DVec3::new(0.125, -0.25, 0.0);
const AXES: DVec3 = DVec3::new(0.5, 0.25, 1.0);

fn ellipsoid(pose: &Pose) -> Ellipsoid {
    Ellipsoid::new(pose.point(CENTER), pose.vector(AXES) * pose.scale).unwrap()
}

shape_laws!(cylinder_laws, ROUND);
shape_laws!(tube_laws, TUBE);
shape_laws!(frustum_laws, FRUSTUM);
shape_laws!(cone_laws, POINTED);
shape_laws!(ellipsoid_laws, ELLIPSOID);
shape_laws!(egg_laws, quadric!(EGG, 2, Inside::Convex));
shape_laws!(tilted_laws, quadric!(TILTED, 0, Inside::Any));
shape_laws!(saddle_laws, quadric!(SADDLE, 0, Inside::Any));
shape_laws!(double_cone_laws, quadric!(DOUBLE_CONE, 0, Inside::Any));

#[test]
fn degenerate_shapes_are_errors() {
    let (o, x) = (DVec3::ZERO, DVec3::X);
    assert!(matches!(Cylinder::new(o, o, 1.0), Err(ShapeError::NoDirection { .. })));
    assert!(matches!(Cylinder::new(o, x, 0.0), Err(ShapeError::NotPositive { .. })));
    assert!(matches!(Cylinder::upon(o, o, 1.0, 1.0), Err(ShapeError::NoDirection { .. })));
    assert!(matches!(Cylinder::upon(o, x, -1.0, 1.0), Err(ShapeError::NotPositive { .. })));
    assert!(matches!(Cone::new(o, x, 0.0, 0.0), Err(ShapeError::NotPositive { .. })));
    assert!(matches!(Cone::new(o, x, -1.0, 2.0), Err(ShapeError::Negative { .. })));
    assert!(matches!(Cone::new(o, x * f64::NAN, 1.0, 2.0), Err(ShapeError::NotFinite { .. })));
    assert!(matches!(Quadric::new(Coefficients::default()), Err(ShapeError::NoEquation { .. })));
    let constant = Coefficients { j: 1.0, ..Coefficients::default() };
    assert!(matches!(Quadric::new(constant), Err(ShapeError::NoEquation { .. })));
    assert!(matches!(Ellipsoid::new(o, DVec3::new(1.0, 0.0, 1.0)), Err(ShapeError::NotPositive { .. })));
    assert!(matches!(Quadric::paraboloid(o, 1.0, -1.0), Err(ShapeError::NotPositive { .. })));
}

/// Along the axis, across it, along the side, through the apex, along a generator: cases with zeros in them.
#[test]
fn lines_in_special_position_have_their_exact_crossings() {
    let cone = Cone::new(DVec3::ZERO, DVec3::Z, 1.0, 0.0).unwrap();
    let spans = |solid: &dyn Solid, o: [f64; 3], d: [f64; 3]| {
        let mut out = Vec::new();
        solid.spans(&Ray::new(o.into(), d.into()), &mut out);
        out.iter().map(|s| (s.enter.t, s.enter.face, s.leave.t, s.leave.face)).collect::<Vec<_>>()
    };
    assert_eq!(spans(&cone, [0.0, 0.0, -1.0], [0.0, 0.0, 1.0])[0].0, 1.0);
    assert_eq!(spans(&cone, [0.5, 0.0, -1.0], [0.0, 0.0, 1.0]), [(1.0, 1, 1.5, 0)]);
    assert_eq!(spans(&cone, [-2.0, 0.0, 0.5], [1.0, 0.0, 0.0]), [(1.5, 0, 2.5, 0)]);
    // Parallel to the generator from (1,0,0) to the apex, half way inside.
    assert_eq!(spans(&cone, [1.5, 0.0, -1.0], [-1.0, 0.0, 1.0]), [(1.0, 1, 1.75, 0)]);
    // Square to the axis through the apex: a touch. Above it: nothing.
    assert_eq!(spans(&cone, [-2.0, 0.0, 1.0], [1.0, 0.0, 0.0]), []);
    assert_eq!(spans(&cone, [-2.0, 0.0, 1.5], [1.0, 0.0, 0.0]), []);
    let cylinder = Cylinder::new(DVec3::ZERO, DVec3::Z * 2.0, 1.0).unwrap();
    assert_eq!(spans(&cylinder, [0.5, 0.0, -1.0], [0.0, 0.0, 2.0]), [(0.5, 1, 1.5, 2)]);
    assert_eq!(spans(&cylinder, [2.0, 0.0, -1.0], [0.0, 0.0, 2.0]), []);
    let mut touch = Vec::new();
    cylinder.crossings(&Ray::new(DVec3::new(-3.0, 1.0, 1.0), DVec3::X), &mut touch);
    assert_eq!(touch.iter().map(|c| c.t).collect::<Vec<_>>(), [3.0]);
    assert_eq!(spans(&cylinder, [-3.0, 1.0, 1.0], [1.0, 0.0, 0.0]), []);
    // Straight down into a paraboloid: one root, not a second one at infinity.
    let bowl = Quadric::paraboloid(DVec3::ZERO, 1.0, 1.0).unwrap();
    let line = bowl.line(&Ray::new(DVec3::new(0.5, 0.0, 3.0), -DVec3::Z));
    assert_eq!(line.iter().map(|c| c.t).collect::<Vec<_>>(), [2.75]);
    // Along an asymptote of the saddle, where 106 bits alone leave rounding for `a`.
    let saddle = Quadric::hyperbolic_paraboloid(DVec3::ZERO, 1.0, 1.0).unwrap();
    let d = DVec3::new(0.1 + 0.2, 0.1 + 0.2, 1.0 / 3.0);
    assert_eq!(saddle.line(&Ray::new(DVec3::new(0.3, 0.1, 0.7), d)).len(), 1);
}

/// From 10⁸ radii away, at a tangent missed or met by 10⁻⁶ of a radius.
#[test]
fn far_and_nearly_tangent_rays_are_decided() {
    let cylinder = Cylinder::new(-DVec3::Z, DVec3::Z, 1.0).unwrap();
    let sphere = Quadric::ellipsoid(DVec3::ZERO, DVec3::ONE).unwrap();
    let ball = Ellipsoid::new(DVec3::ZERO, DVec3::ONE).unwrap();
    let shapes: [&dyn Shape; 3] = [&cylinder, &sphere, &ball];
    for shape in shapes {
        for (height, hits) in [(1.0 - 1e-6, 2), (1.0 + 1e-6, 0)] {
            let mut out = Vec::new();
            shape.crossings(&Ray::new(DVec3::new(-1e8, height, 0.0), DVec3::X), &mut out);
            assert_eq!(out.len(), hits);
            if let [a, b] = out[..] {
                let half = ((1.0 - height) * (1.0 + height)).sqrt();
                assert!((a.t - (1e8 - half)).abs() <= 1e8 * 64.0 * U);
                assert!((b.t - (1e8 + half)).abs() <= 1e8 * 64.0 * U);
            }
        }
    }
}

#[test]
fn a_clipped_quadric_ends_at_its_box() {
    let clip = Aabb::new(-DVec3::ONE, DVec3::ONE);
    let pipe = ClippedQuadric { quadric: Quadric::cylinder(DVec3::ZERO, 0.5).unwrap(), clip };
    let met = |height: f64| {
        pipe.nearest(&Ray::new(DVec3::new(-3.0, 0.0, height), DVec3::X), 0.0, f64::INFINITY).map(|c| c.t)
    };
    assert_eq!(met(0.5), Some(2.5));
    assert_eq!(met(1.5), None);
    assert_eq!(pipe.bounds(), clip);
}

proptest! {
    #![proptest_config(Config { cases: 2000, failure_persistence: None, ..Config::default() })]

    /// The named constructors agree with the surfaces that are made otherwise.
    #[test]
    fn an_ellipsoid_is_a_quadric(ray in crate::shapes::rays()) {
        let (mut a, mut b) = (Vec::new(), Vec::new());
        ellipsoid(&Pose::HOME).crossings(&ray, &mut a);
        Quadric::ellipsoid(CENTER, AXES).unwrap().crossings(&ray, &mut b);
        prop_assert_eq!(a.len(), b.len());
        for (a, b) in a.iter().zip(&b) {
            // The quadric's coefficients are exact for these axes.
            prop_assert!((a.t - b.t).abs() <= 128.0 * U * a.t);
        }
    }

    /// An upright cylinder's side is the quadric's, where the height is right.
    #[test]
    fn a_tube_is_a_clipped_quadric(ray in crate::shapes::rays()) {
        let tube = Cylinder::new(-DVec3::Z, DVec3::Z, 0.5).unwrap().with_ends(Ends::Open);
        let quadric = Quadric::cylinder(DVec3::ZERO, 0.5).unwrap();
        let (mut a, mut b) = (Vec::new(), Vec::new());
        tube.crossings(&ray, &mut a);
        quadric.crossings(&ray, &mut b);
        b.retain(|c| ray.at(c.t).z.abs() <= 1.0);
        prop_assert_eq!(a.len(), b.len());
        for (a, b) in a.iter().zip(&b) {
            prop_assert!((a.t - b.t).abs() <= 128.0 * U * a.t);
        }
    }

    /// `point_at` puts points onto every named quadric, and its hits lead back to the sheet.
    #[test]
    fn points_of_sheets_lie_on_the_surface(u in -1.0..1.0f64, v in -1.0..1.0f64) {
        let one = DVec3::ONE;
        let all = [
            Quadric::ellipsoid(one, one * 3.0), Quadric::cone(one, 0.5), Quadric::cylinder(one, 2.0),
            Quadric::paraboloid(one, 1.0, 2.0), Quadric::hyperbolic_paraboloid(one, 1.0, 2.0),
            Quadric::hyperboloid_of_one_sheet(one, one), Quadric::hyperboloid_of_two_sheets(one, one),
        ];
        for quadric in all.map(Result::unwrap) {
            for face in 0..2 {
                let p = quadric.point_at(face, DVec2::new(u, v));
                prop_assert!(p.is_finite());
                let axis = (0..3).max_by(|&i, &j| {
                    let c = quadric.coefficients();
                    let squares = [c.a.abs(), c.e.abs(), c.h.abs()];
                    squares[i].total_cmp(&squares[j]).then(j.cmp(&i))
                }).unwrap();
                let line = quadric.line(&Ray::new(p - DVec3::AXES[axis] * 16.0, DVec3::AXES[axis]));
                if line.iter().any(|c| c.face == face) {
                    prop_assert!(near_quadric(p, 1e-12, &quadric.coefficients()), "{quadric:?} {p}");
                }
            }
        }
    }
}
