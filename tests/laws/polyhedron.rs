//! Convex polyhedra.

use crate::shape_laws;
use crate::shapes::*;
use glam::{DAffine3, DVec3, dvec3};
use lightbench::ray::Ray;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::polyhedron::{ConvexPolyhedron, HalfSpace, textbook};
use lightbench::shape::{Shape, ShapeError, Solid};
use proptest::prelude::*;

/// A cube without one corner; every number a short binary fraction, so that poses move it exactly.
const PLANES: [(DVec3, DVec3); 7] = [
    (dvec3(-0.5, 0.0, 0.0), dvec3(-1.0, 0.0, 0.0)),
    (dvec3(0.5, 0.0, 0.0), dvec3(2.0, 0.0, 0.5)),
    (dvec3(0.0, -0.5, 0.0), dvec3(0.0, -1.0, 0.0)),
    (dvec3(0.0, 0.5, 0.0), dvec3(0.25, 3.0, 0.0)),
    (dvec3(0.0, 0.0, -0.5), dvec3(0.0, 0.0, -1.0)),
    (dvec3(0.0, 0.0, 0.5), dvec3(0.0, -0.5, 2.0)),
    (dvec3(0.375, 0.375, 0.375), dvec3(1.0, 1.0, 1.0)),
];

fn cut_cube(pose: &Pose) -> ConvexPolyhedron {
    let posed = PLANES.map(|(p, n)| HalfSpace { point: pose.point(p), normal: pose.vector(n) });
    ConvexPolyhedron::new(&posed).unwrap()
}

/// Distance above the plane of a face, in high precision.
fn height(p: DVec3, face: usize) -> f64 {
    let (point, normal) = PLANES[face];
    let n = exact(normal);
    (dot(n, minus(exact(p), exact(point))) / length(n)).value()
}

/// In its plane, and outside no other by more than that: edges meet at 54° or more, so that the solid is
/// then at most `2 reach` away.
fn near(p: DVec3, face: u32, reach: f64) -> bool {
    height(p, face as usize).abs() <= reach && (0..PLANES.len()).all(|i| height(p, i) <= reach)
}

const CUT_CUBE: Member = Member {
    make: |pose| Box::new(cut_cube(pose)),
    solid: Some(|pose| Box::new(cut_cube(pose))),
    near,
    uv_slope: |_| 1.0,
    inside: Inside::Convex,
};

shape_laws!(cut_cube_laws, CUT_CUBE);

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Both know t to 64 u.
    #[test]
    fn an_upright_box_is_the_cuboid(ray in rays()) {
        let (min, max) = (dvec3(-0.75, -0.5, -0.25), dvec3(0.5, 0.625, 1.0));
        let polyhedron = ConvexPolyhedron::of_box(min, max, &DAffine3::IDENTITY).unwrap();
        let cuboid = Cuboid::new(min, max).unwrap();
        let ends = polyhedron.roots(&ray);
        prop_assert_eq!(ends.is_some(), cuboid.roots(&ray).is_some());
        if let (Some((a, b)), Some((c, d))) = (ends, cuboid.roots(&ray)) {
            prop_assert!((a.t - c.t).abs() <= 128.0 * f64::EPSILON * c.t.abs());
            prop_assert!((b.t - d.t).abs() <= 128.0 * f64::EPSILON * d.t.abs());
            prop_assert_eq!(polyhedron.hit(&ray, &a).ng, cuboid.hit(&ray, &a).ng);
        }
    }

    /// Far from every edge the printed algorithm gives the same; its t errs by some roundings of the distance.
    #[test]
    fn the_textbook_agrees_nearby(ray in rays()) {
        let planes = PLANES.map(|(p, n)| (n.normalize(), -n.normalize().dot(p)));
        let ours = cut_cube(&Pose::HOME).roots(&ray);
        if let (Some((a, b)), Some((c, d))) = (ours, textbook(&planes, &ray)) {
            for (x, y) in [(a, c), (b, d)] {
                let slant = ray.direction.dot(PLANES[x.face as usize].1.normalize()).abs();
                let size = ray.origin.abs().element_sum() + (ray.direction * x.t).abs().element_sum();
                prop_assert!(x.face != y.face || (x.t - y.t).abs() <= 32.0 * f64::EPSILON * size / slant);
            }
        }
    }
}

#[test]
fn vertices_lie_in_three_faces_and_bounds_hold_them() {
    let solid = cut_cube(&Pose::HOME);
    // Seven faces, all corners simple: 2 · 7 − 4 of them.
    assert_eq!(solid.vertices().len(), 10);
    for v in solid.vertices() {
        let touching = (0..PLANES.len()).filter(|i| height(*v, *i).abs() < 1e-14).count();
        assert_eq!(touching, 3, "{v}");
        assert!(solid.bounds().contains(*v));
    }
    assert!(solid.contains(DVec3::ZERO) && !solid.contains(DVec3::splat(0.4)));
}

#[test]
fn a_line_in_a_face_is_inside() {
    let polyhedron = ConvexPolyhedron::of_box(DVec3::ZERO, DVec3::ONE, &DAffine3::IDENTITY).unwrap();
    let ray = Ray::new(dvec3(-1.0, 1.0, 0.5), DVec3::X);
    assert_eq!(polyhedron.roots(&ray).map(|(a, b)| (a.t, b.t)), Some((1.0, 2.0)));
    let above = Ray::new(dvec3(-1.0, 1.0f64.next_up(), 0.5), DVec3::X);
    assert_eq!(polyhedron.roots(&above), None);
}

#[test]
fn what_is_no_solid_is_refused() {
    let half = |p: [f64; 3], n: [f64; 3]| HalfSpace { point: p.into(), normal: n.into() };
    let box_of = |planes: &[(DVec3, DVec3)]| {
        let half: Vec<HalfSpace> =
            planes.iter().map(|(point, normal)| HalfSpace { point: *point, normal: *normal }).collect();
        ConvexPolyhedron::new(&half)
    };
    assert!(matches!(box_of(&PLANES[..4]), Err(ShapeError::Unbounded { .. })));
    assert!(matches!(ConvexPolyhedron::new(&[]), Err(ShapeError::NoVolume { .. })));
    let mut empty = PLANES.map(|(point, normal)| HalfSpace { point, normal }).to_vec();
    empty.push(half([-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]));
    assert!(matches!(ConvexPolyhedron::new(&empty), Err(ShapeError::NoVolume { .. })));
    let flat = DAffine3::from_scale(dvec3(1.0, 0.0, 1.0));
    assert!(ConvexPolyhedron::of_box(DVec3::ZERO, DVec3::ONE, &flat).is_err());
    assert!(box_of(&[(DVec3::ZERO, DVec3::ZERO)]).is_err());
}
