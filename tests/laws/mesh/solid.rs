//! Meshes under rays: the laws of shapes, no gaps, every crossing once.

use crate::shape_laws;
use crate::shapes::{Inside, Member, Pose, dot, exact, length, minus, rays};
use glam::{DVec3, dvec3};
use lightbench::mesh::{ClosedMesh, Mesh, MeshError, Polygons, tessellate};
use lightbench::num::U;
use lightbench::ray::{Crossing, Ray, Span};
use lightbench::shape::{Shape, ShapeError, Solid};
use proptest::prelude::*;
use proptest::test_runner::Config;
use std::sync::LazyLock;

fn config(cases: u32) -> Config {
    Config { cases, failure_persistence: None, ..Config::default() }
}

/// The mesh at a pose; coordinates are cut to 20 bits, so that poses move them exactly.
fn posed(mesh: &Polygons, pose: &Pose) -> ClosedMesh {
    let mut mesh = mesh.clone().facetted();
    mesh.uvs.corners.fill(lightbench::mesh::NONE);
    for p in &mut mesh.points {
        *p = pose.point((*p * 2f64.powi(20)).round() / 2f64.powi(20));
    }
    ClosedMesh::new(Mesh::new(&mesh).expect("a mesh")).expect("closed")
}

fn ring(pose: &Pose) -> ClosedMesh {
    posed(&tessellate::torus(0.625, 0.25, 9, 7), pose)
}

fn ball(pose: &Pose) -> ClosedMesh {
    posed(&tessellate::icosphere(1), pose)
}

static RING: LazyLock<ClosedMesh> = LazyLock::new(|| ring(&Pose::HOME));
static BALL: LazyLock<ClosedMesh> = LazyLock::new(|| ball(&Pose::HOME));

/// In the triangle's plane, and outside none of its edges by more than that.
fn near(solid: &ClosedMesh, p: DVec3, face: u32, reach: f64) -> bool {
    let corners = solid.mesh().triangle(face as usize);
    let across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    let height = |point: DVec3, way: DVec3| {
        (dot(minus(exact(p), exact(point)), exact(way)) / length(exact(way))).value()
    };
    let beyond = |i: usize| height(corners[i], (corners[(i + 1) % 3] - corners[i]).cross(across)) > reach;
    height(corners[0], across).abs() <= reach && !(0..3).any(beyond)
}

const RING_MESH: Member = Member {
    make: |pose| Box::new(ring(pose)),
    solid: Some(|pose| Box::new(ring(pose))),
    near: |p, face, reach| near(&RING, p, face, reach),
    uv_slope: |_| 1.0,
    inside: Inside::Any,
};

const BALL_MESH: Member = Member {
    make: |pose| Box::new(ball(pose)),
    solid: Some(|pose| Box::new(ball(pose))),
    near: |p, face, reach| near(&BALL, p, face, reach),
    uv_slope: |_| 1.0,
    inside: Inside::Any,
};

shape_laws!(ring_laws, RING_MESH);
shape_laws!(ball_laws, BALL_MESH);

/// Surfaces to shoot at.
fn meshes() -> Vec<(&'static str, Mesh)> {
    [
        ("knot", tessellate::bumpy_knot(90, 9)),
        ("sphere", tessellate::sphere(24, 12)),
        ("cube", tessellate::cube(3)),
        ("cone", tessellate::cone(40)),
        ("octahedron", octahedron(4)),
    ]
    .map(|(name, polygons)| (name, Mesh::new(&polygons).expect("a mesh")))
    .into()
}

/// Where to aim at in a triangle: corners, edges, inside.
fn weights() -> impl Strategy<Value = DVec3> {
    prop_oneof![
        Just(dvec3(1.0, 0.0, 0.0)),
        Just(dvec3(0.0, 0.0, 1.0)),
        Just(dvec3(0.5, 0.5, 0.0)),
        (0.0..1.0).prop_map(|s| dvec3(0.0, s, 1.0 - s)),
        (0.0..1.0, 0.0..1.0).prop_map(|(a, b): (f64, f64)| dvec3(a * b, a * (1.0 - b), 1.0 - a)),
    ]
}

#[test]
fn nearest_is_that_of_testing_every_triangle_to_the_bit() {
    for (name, mesh) in meshes() {
        proptest!(config(300), |(ray in rays(), face in 0..10_000usize, w in weights(), t_max in 0.1..20.0f64)| {
            let [a, b, c] = mesh.triangle(face % mesh.len());
            let aimed = Ray::new(ray.origin, a * w.x + b * w.y + c * w.z - ray.origin);
            for ray in [ray, aimed] {
                for (t_min, t_max) in [(0.0, f64::INFINITY), (0.0, 1.0), (0.5, t_max)] {
                    let scan = mesh.nearest_by_scan(&ray, t_min, t_max);
                    prop_assert_eq!(mesh.nearest(&ray, t_min, t_max), scan, "{}", name);
                    if t_min == 0.0 {
                        prop_assert_eq!(mesh.blocks(&ray, t_max), scan.is_some());
                    }
                }
            }
        });
    }
}

/// From inside a convex body at corners and edges of its faces: no ray gets out, however large the body and far from the origin.
#[test]
fn closed_meshes_leak_no_ray() {
    for scale in [1e-200, 1e-3, 1.0, 1e9, 1e140] {
        for shift in [DVec3::ZERO, dvec3(3.0, -1.0, 2.0), DVec3::splat(1e6)] {
            let mut ball = tessellate::icosphere(2);
            ball.points.iter_mut().for_each(|p| *p = (*p + shift) * scale);
            let mesh = ClosedMesh::new(Mesh::new(&ball).expect("a mesh")).expect("closed");
            proptest!(config(300), |(from in [-0.4..0.4, -0.4..0.4, -0.4..0.4], face in 0..320usize, w in weights())| {
                let [a, b, c] = mesh.mesh().triangle(face);
                let origin = (DVec3::from_array(from) + shift) * scale;
                let ray = Ray::new(origin, (a * w.x + b * w.y + c * w.z) - origin);
                prop_assert!(mesh.nearest(&ray, 0.0, f64::INFINITY).is_some());
                let (mut found, mut spans) = (Vec::new(), Vec::new());
                mesh.crossings(&ray, &mut found);
                mesh.spans(&ray, &mut spans);
                prop_assert_eq!((found.len(), spans.len()), (1, 1), "{:?} {:?}", found, spans);
                prop_assert!(mesh.contains(origin));
            });
        }
    }
}

/// `|x| + |y| + |z| ≤ n`, its faces cut along whole numbers: a line with small whole coordinates meets edges and corners all the time.
fn octahedron(n: i32) -> Polygons {
    let mut soup = Vec::new();
    for octant in 0..8 {
        let sign = |bit: i32| if octant >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let at = |x: i32, y: i32| {
            dvec3(sign(0) * f64::from(x), sign(1) * f64::from(y), sign(2) * f64::from(n - x - y)) + 0.0
        };
        let mirrored = sign(0) * sign(1) * sign(2) < 0.0;
        let mut push = |a: DVec3, b: DVec3, c: DVec3| soup.push(if mirrored { [a, c, b] } else { [a, b, c] });
        for x in 0..n {
            for y in 0..n - x {
                push(at(x, y), at(x + 1, y), at(x, y + 1));
                if x + y + 1 < n {
                    push(at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
                }
            }
        }
    }
    Polygons::of_triangles(&soup)
}

/// The stretch of a line in the octahedron, exactly but for the last division, and whether it runs along a face.
fn in_octahedron(o: [i64; 3], d: [i64; 3], n: i64) -> (f64, f64, bool) {
    let (mut from, mut to, mut along) = (f64::NEG_INFINITY, f64::INFINITY, false);
    for octant in 0..8 {
        let sign = |bit: usize| if octant >> bit & 1 == 0 { 1 } else { -1 };
        let height = n - (0..3).map(|i| sign(i) * o[i]).sum::<i64>();
        let slope: i64 = (0..3).map(|i| sign(i) * d[i]).sum();
        match slope.signum() {
            1 => to = to.min(height as f64 / slope as f64),
            -1 => from = from.max(height as f64 / slope as f64),
            _ if height < 0 => return (0.0, -1.0, false),
            _ => along |= height == 0,
        }
    }
    (from, to, along)
}

#[test]
fn lines_through_edges_and_corners_cross_once() {
    let solid = ClosedMesh::new(Mesh::new(&octahedron(4)).expect("a mesh")).expect("closed");
    let whole = || [-6..7i64, -6..7, -6..7];
    proptest!(config(4000), |(o in whole(), d in whole())| {
        prop_assume!(d != [0, 0, 0]);
        let vector = |v: [i64; 3]| DVec3::from_array(v.map(|x| x as f64));
        let ray = Ray::new(vector(o), vector(d));
        let mut spans: Vec<Span> = Vec::new();
        solid.spans(&ray, &mut spans);
        let (from, to, along) = in_octahedron(o, d, 4);
        if along {
            // In the surface itself: inside or not, but not both.
            prop_assert!(spans.len() <= 1);
        } else if from < to {
            prop_assert_eq!(spans.len(), 1, "{:?}", spans);
            let near = |a: f64, b: f64| (a - b).abs() <= 64.0 * U * (a.abs() + 8.0);
            prop_assert!(near(spans[0].enter.t, from) && near(spans[0].leave.t, to), "{:?} {} {}", spans, from, to);
        } else {
            prop_assert!(spans.is_empty(), "{:?}", spans);
        }
        // Whole points: inside or on the surface, exactly.
        prop_assert_eq!(solid.contains(ray.origin), o.iter().map(|x| x.abs()).sum::<i64>() <= 4);
        let mut found: Vec<Crossing> = Vec::new();
        solid.crossings(&ray, &mut found);
        if !along {
            let ends = [from, to].iter().filter(|t| from <= to && **t > 0.0).count();
            prop_assert_eq!(found.len(), if from == to { ends / 2 } else { ends });
        }
        prop_assert_eq!(solid.nearest(&ray, 0.0, f64::INFINITY), found.first().copied());
    });
}

#[test]
fn an_inside_out_mesh_is_turned_round_and_an_open_one_is_no_solid() {
    let mut ball = tessellate::sphere(8, 6);
    ball.turn_round();
    let mesh = Mesh::new(&ball).expect("a mesh");
    assert!(mesh.repairs().inside_out);
    let ray = Ray::new(dvec3(0.1, 0.2, 3.0), DVec3::NEG_Z);
    let hit = mesh.hit(&ray, &mesh.nearest(&ray, 0.0, f64::INFINITY).expect("a hit"));
    assert!(hit.ng.z > 0.5 && hit.n.z > 0.5);
    let mut open = Polygons::of_points(ball.points.clone());
    ball.faces().skip(1).for_each(|f| open.push_points(f));
    let mesh = ClosedMesh::new(Mesh::new(&open).expect("a mesh")).expect_err("a hole");
    assert_eq!(mesh.topology().boundary_edges, 3);
}

#[test]
fn what_has_no_area_is_dropped_and_the_rest_stays_closed() {
    // A cube whose top has a corner more, in the middle of an edge, and a face of no area in that gap.
    let mut cube = Polygons::of_points(
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]
            .map(|p: [i32; 3]| DVec3::from_array(p.map(f64::from)))
            .to_vec(),
    );
    cube.points.push(dvec3(0.5, 0.0, 1.0));
    for face in [
        &[3u32, 2, 1, 0][..],
        &[0, 1, 5, 4],
        &[1, 2, 6, 5],
        &[2, 3, 7, 6],
        &[3, 0, 4, 7],
        &[4, 8, 5, 6, 7],
        &[4, 5, 8],
    ] {
        cube.push_points(face);
    }
    let mesh = Mesh::new(&cube).expect("a mesh");
    assert_eq!(mesh.repairs().flat, 1);
    let solid = ClosedMesh::new(mesh).expect("closed");
    proptest!(config(500), |(from in [0.1..0.9, 0.1..0.9, 0.1..0.9], s in 0.0..1.0f64)| {
        let origin = DVec3::from_array(from);
        let ray = Ray::new(origin, dvec3(s, 0.0, 1.0) - origin);
        prop_assert!(solid.nearest(&ray, 0.0, f64::INFINITY).is_some());
        prop_assert!(solid.contains(origin));
    });
    let nothing = Polygons::of_triangles(&[[DVec3::ZERO, DVec3::X, DVec3::X * 2.0]]);
    assert!(matches!(Mesh::new(&nothing), Err(MeshError::Shape(ShapeError::NoArea { .. }))));
    let mut far = tessellate::cube(1);
    far.points[3].y = f64::NAN;
    assert!(matches!(Mesh::new(&far), Err(MeshError::Shape(ShapeError::NotFinite { .. }))));
}

#[test]
fn smooth_normals_are_between_the_corners_and_shadow_rays_start_above() {
    let mesh = Mesh::new(&tessellate::sphere(16, 8)).expect("a mesh");
    proptest!(config(500), |(ray in rays())| {
        let Some(crossing) = mesh.nearest(&ray, 0.0, f64::INFINITY) else { return Ok(()) };
        let hit = mesh.hit(&ray, &crossing);
        prop_assert!((hit.n.length() - 1.0).abs() <= 16.0 * U);
        // On the unit sphere the interpolated normal is nearly the direction of the point.
        prop_assert!(hit.n.dot(hit.point.normalize()) > 0.99);
        let side = if ray.direction.dot(hit.ng) > 0.0 { -hit.n } else { hit.n };
        let lifted = mesh.lifted(&hit, side);
        let height = (lifted - hit.point).dot(hit.ng);
        // The tangent planes at the corners of a facet rise above it by half the square of its diagonal, 0.55, over 2.
        match side.dot(hit.ng) > 0.0 {
            true => prop_assert!((-1e-15..0.08).contains(&height), "{}", height),
            false => prop_assert!(height.abs() <= 1e-15, "{}", height),
        }
    });
}
