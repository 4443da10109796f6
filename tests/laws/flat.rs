//! Plane, disc, polygon, triangle.

use crate::shape_laws;
use crate::shapes::{Inside, Member, Pose, dot, exact, length, minus};
use glam::DVec3;
use lightbench::num::U;
use lightbench::ray::Ray;
use lightbench::shape::disc::Disc;
use lightbench::shape::plane::Plane;
use lightbench::shape::polygon::Polygon;
use lightbench::shape::triangle::{
    Facing, PreparedRay, Triangle, icosphere, interpolated_normal, moller_trumbore, plane_and_areas,
    terminator_point,
};
use lightbench::shape::{Shape, ShapeError, Sides, triangle};
use proptest::prelude::*;
use proptest::test_runner::Config;
use rayon::prelude::*;

const CENTER: DVec3 = DVec3::new(0.125, -0.25, 0.0625);
const ACROSS: DVec3 = DVec3::new(1.0, -2.0, 3.0);
const RADIUS: f64 = 0.75;
const CORNERS: [DVec3; 3] =
    [DVec3::new(-0.75, -0.5, 0.25), DVec3::new(1.0, -0.25, -0.5), DVec3::new(0.125, 0.875, 0.375)];
/// An arrowhead in the plane `z = 0.25`, its notch at the third corner.
const ARROW: [DVec3; 4] = [
    DVec3::new(-0.75, -0.5, 0.25),
    DVec3::new(0.875, 0.0, 0.25),
    DVec3::new(0.0, 0.0, 0.25),
    DVec3::new(-0.25, 0.75, 0.25),
];

fn plane(pose: &Pose) -> Plane {
    Plane::new(pose.point(CENTER), pose.vector(ACROSS)).unwrap()
}

fn off_plane(p: DVec3, center: DVec3, across: DVec3) -> f64 {
    (dot(minus(exact(p), exact(center)), exact(across)) / length(exact(across))).value().abs()
}

const PLANE: Member = Member {
    make: |pose| Box::new(plane(pose)),
    solid: Some(|pose| Box::new(plane(pose))),
    near: |p, _, reach| off_plane(p, CENTER, ACROSS) <= reach,
    uv_slope: |_| 1.0,
    inside: Inside::Any,
};

const DISC: Member = Member {
    make: |pose| Box::new(Disc::new(pose.point(CENTER), pose.vector(ACROSS), RADIUS * pose.scale).unwrap()),
    solid: None,
    near: |p, _, reach| {
        let away = length(minus(exact(p), exact(CENTER))).value();
        off_plane(p, CENTER, ACROSS) <= reach && away <= RADIUS + reach
    },
    uv_slope: |_| 1.0,
    inside: Inside::Any,
};

const TRIANGLE: Member = Member {
    make: |pose| {
        let [a, b, c] = CORNERS.map(|v| pose.point(v));
        Box::new(Triangle::new(a, b, c).unwrap())
    },
    solid: None,
    near: |p, _, reach| {
        let across = (CORNERS[1] - CORNERS[0]).cross(CORNERS[2] - CORNERS[0]);
        let beyond = |i: usize| {
            let (a, b) = (CORNERS[i], CORNERS[(i + 1) % 3]);
            let out = (b - a).cross(across).normalize();
            dot(minus(exact(p), exact(a)), exact(out)).value() > reach
        };
        off_plane(p, CORNERS[0], across) <= reach && !(beyond(0) || beyond(1) || beyond(2))
    },
    uv_slope: |_| 1.0,
    inside: Inside::Any,
};

const POLYGON: Member = Member {
    make: |pose| Box::new(Polygon::new(ARROW.iter().map(|&v| pose.point(v)).collect()).unwrap()),
    solid: None,
    near: |p, _, reach| off_plane(p, ARROW[0], DVec3::Z) <= reach,
    uv_slope: |_| 1.0,
    inside: Inside::Any,
};

shape_laws!(plane_laws, PLANE);
shape_laws!(disc_laws, DISC);
shape_laws!(triangle_laws, TRIANGLE);
shape_laws!(polygon_laws, POLYGON);

#[test]
fn degenerate_shapes_are_errors() {
    let zero = DVec3::ZERO;
    assert!(matches!(Plane::new(zero, zero), Err(ShapeError::NoDirection { .. })));
    assert!(matches!(Plane::new(zero, DVec3::NAN), Err(ShapeError::NotFinite { .. })));
    assert!(matches!(Disc::new(zero, DVec3::X, 0.0), Err(ShapeError::NotPositive { .. })));
    assert!(matches!(Disc::new(zero, DVec3::X, f64::INFINITY), Err(ShapeError::NotFinite { .. })));
    let [a, b] = [DVec3::new(0.1, 0.2, 0.3), DVec3::new(1.1, 2.2, 3.3)];
    assert!(matches!(Triangle::new(a, b, a), Err(ShapeError::NoArea { .. })));
    assert!(matches!(Triangle::new(a, a * 2.0, a * 4.0), Err(ShapeError::NoArea { .. })));
    assert!(matches!(Polygon::new(vec![a, b]), Err(ShapeError::TooFewVertices { found: 2 })));
    assert!(matches!(Polygon::new(vec![a, b, a, b]), Err(ShapeError::NoArea { .. })));
    let bent = vec![zero, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y + DVec3::Z * 0.1];
    assert!(matches!(Polygon::new(bent), Err(ShapeError::NotFlat { .. })));
    let message = Disc::new(zero, DVec3::X, -2.0).unwrap_err().to_string();
    assert_eq!(message, "radius of a disc: expected a length above 0, found -2");
}

/// The thinnest triangle that `f64` can hold still has its normal.
#[test]
fn the_thinnest_triangle_has_its_normal() {
    let thin = Triangle::new(DVec3::ZERO, DVec3::X, DVec3::new(0.5, 5e-324, 0.0)).unwrap();
    assert_eq!(thin.normal(), DVec3::Z);
    let sliver =
        Triangle::new(DVec3::ONE, DVec3::splat(3.0), DVec3::new(2.0, 2.0, 2.0f64.next_up())).unwrap();
    let expected = DVec3::new(1.0, -1.0, 0.0).normalize();
    assert!((sliver.normal() - expected).length() <= 4.0 * U);
}

#[test]
fn front_sides_answer_only_rays_against_the_normal() {
    let front = Triangle::new(CORNERS[0], CORNERS[1], CORNERS[2]).unwrap().with_sides(Sides::Front);
    let disc = Disc::new(CENTER, ACROSS, RADIUS).unwrap().with_sides(Sides::Front);
    let plane = plane(&Pose::HOME).with_sides(Sides::Front);
    let polygon = Polygon::new(ARROW.to_vec()).unwrap().with_sides(Sides::Front);
    let shapes: [&dyn Shape; 4] = [&front, &disc, &plane, &polygon];
    for shape in shapes {
        let inner = shape.point_at(0, glam::DVec2::new(0.25, 0.25));
        let hit = (0..2).map(|way| {
            let normal = [front.normal(), disc.normal(), plane.normal(), polygon.normal()]
                [shapes.iter().position(|s| std::ptr::eq(*s, shape)).unwrap()];
            let away = if way == 0 { normal } else { -normal };
            shape.nearest(&Ray::new(inner + away, -away), 0.0, f64::INFINITY).is_some()
        });
        assert_eq!(hit.collect::<Vec<_>>(), [true, false], "{shape:?}");
    }
}

/// Every edge belongs to two faces, which run along it in opposite ways; corners are equal to the bit.
#[test]
fn the_icosphere_is_closed() {
    let bits = |v: DVec3| v.to_array().map(f64::to_bits);
    for levels in 0..=3 {
        let faces = icosphere(levels);
        assert_eq!(faces.len(), 20 << (2 * levels));
        let edges: std::collections::HashSet<_> = faces
            .iter()
            .flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)].map(|(p, q)| (bits(p), bits(q))))
            .collect();
        assert_eq!(edges.len(), 3 * faces.len(), "an edge twice in the same way");
        assert!(edges.iter().all(|&(p, q)| edges.contains(&(q, p))), "an open edge");
        assert!(
            faces.iter().all(|[a, b, c]| (*b - *a).cross(*c - *a).dot(*a) > 0.0),
            "a face turned inwards"
        );
    }
}

/// Hit or miss does not depend on the unit of length; the printed test's answer does.
///
/// The target misses its plane by some 8 u of the size, which at a slant of 10⁻⁶ moves `t` by 8 u · 10⁶ ≈ 10⁻⁹.
#[test]
fn triangles_are_met_at_every_size() {
    let printed = |k: i32| {
        let scale = 2f64.powi(k);
        let [a, b, c] = CORNERS.map(|v| v * scale);
        let target = (a + b + c) / 3.0;
        let normal = Triangle::new(a, b, c).unwrap().normal();
        for slant in [0.0, 0.9, 0.999_999] {
            let way = -normal * (1.0 - slant) + (b - a).normalize() * slant;
            let ray = Ray::new(target - way * scale, way);
            let m = PreparedRay::new(&ray).meet([a, b, c]).unwrap();
            assert!((m.t / scale - 1.0).abs() <= 1e-9, "2^{k}, {slant}: {m:?}");
        }
        triangle::as_printed(&Ray::new(target + normal * scale, -normal), [a, b, c], Sides::Both).is_some()
    };
    assert_eq!(
        [-300, -100, -20, 0, 20, 100, 300].map(printed),
        [false, false, false, true, true, true, true]
    );
}

/// Numbers in [0,1) from a counter (Steele, Lea & Flood's SplitMix64).
fn hashed(i: u64, dimension: u64) -> f64 {
    let mut z = (i * 16 + dimension + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / 2f64.powi(53)
}

/// A million rays from inside, at edges and at corners: every one gets out.
#[test]
fn a_closed_mesh_does_not_leak() {
    let faces = icosphere(2);
    assert_eq!(faces.len(), 320);
    let touching: Vec<Vec<usize>> = faces
        .iter()
        .map(|f| (0..faces.len()).filter(|&g| faces[g].iter().any(|v| f.contains(v))).collect())
        .collect();
    let leaks: usize = (0..1_000_000u64)
        .into_par_iter()
        .filter(|&i| {
            let face = (hashed(i, 0) * faces.len() as f64) as usize;
            let [a, b, _] = faces[face];
            let target = match i % 3 {
                0 => a,
                1 => a + (b - a) * hashed(i, 1),
                _ => (a + b) * 0.5,
            };
            // Every other ray starts in the middle, and every sixth then points exactly at a corner.
            let spread = if i % 2 == 0 { 0.0 } else { 0.8 };
            let origin = DVec3::new(hashed(i, 2) - 0.5, hashed(i, 3) - 0.5, hashed(i, 4) - 0.5) * spread;
            let ray = PreparedRay::new(&Ray::new(origin, target - origin));
            !touching[face].iter().any(|&g| ray.meet(faces[g]).is_some_and(|m| m.t > 0.0))
        })
        .count();
    assert_eq!(leaks, 0);
}

/// The quick test loses some of them: that is why it is not the default.
#[test]
fn moller_trumbore_leaks_at_edges() {
    let [a, b, c] = CORNERS;
    let d = a + b - c;
    let through = |i: u64| {
        let target = a + (b - a) * hashed(i, 0);
        let origin = DVec3::new(hashed(i, 1), hashed(i, 2), hashed(i, 3)) * 4.0 + DVec3::Z;
        let ray = Ray::new(origin, target - origin);
        (moller_trumbore(&ray, [a, b, c]).or(moller_trumbore(&ray, [b, a, d])).is_some(), ray)
    };
    let lost: Vec<Ray> = (0..100_000).map(through).filter(|(hit, _)| !hit).map(|(_, ray)| ray).collect();
    assert!(!lost.is_empty());
    for ray in lost {
        let ray = PreparedRay::new(&ray);
        assert!(ray.meet([a, b, c]).or(ray.meet([b, a, d])).is_some());
    }
}

/// Two polygons on the two sides of an edge: a ray at the edge meets exactly one of them.
#[test]
fn polygons_share_an_edge_without_gap_or_overlap() {
    let [a, b, c] = CORNERS;
    let d = a + b - c;
    let (one, two) = (Polygon::new(vec![a, b, c]).unwrap(), Polygon::new(vec![b, a, d]).unwrap());
    for i in 0..100_000 {
        let target = a + (b - a) * (0.001 + 0.998 * hashed(i, 0));
        let origin = DVec3::new(hashed(i, 1), hashed(i, 2), hashed(i, 3)) * 4.0 + DVec3::Z;
        let ray = Ray::new(origin, target - origin);
        let met = [&one, &two].map(|p| p.nearest(&ray, 0.0, f64::INFINITY).is_some());
        assert!(met[0] != met[1], "{ray:?}");
    }
}

fn config() -> Config {
    Config { cases: 2000, failure_persistence: None, ..Config::default() }
}

proptest! {
    #![proptest_config(config())]

    /// The arrowhead is its two halves.
    #[test]
    fn a_polygon_is_the_sum_of_its_triangles(ray in crate::shapes::rays()) {
        let polygon = Polygon::new(ARROW.to_vec()).unwrap();
        let sheared = PreparedRay::new(&ray);
        let halves = [[ARROW[0], ARROW[1], ARROW[2]], [ARROW[0], ARROW[2], ARROW[3]]];
        let met = halves.iter().find_map(|&half| sheared.meet(half)).filter(|m| m.t > 0.0);
        let found = polygon.nearest(&ray, 0.0, f64::INFINITY);
        prop_assert_eq!(found.is_some(), met.is_some());
        if let (Some(m), Some(c)) = (met, found) {
            prop_assert!((m.t - c.t).abs() <= 1100.0 * U * c.t);
        }
    }

    /// Away from edges three methods agree, on barycentric coordinates too: a ray of this family is conditioned by
    /// 1/cos and 1000 lengths, hence the 10⁻⁹.
    #[test]
    fn three_ways_to_meet_a_triangle_agree(ray in crate::shapes::rays()) {
        let Some(m) = PreparedRay::new(&ray).meet_plane(CORNERS) else { return Ok(()) };
        prop_assume!(m.b.iter().all(|b| b.abs() > 1e-9));
        let slant = ray.direction.normalize().dot(Triangle::new(CORNERS[0], CORNERS[1], CORNERS[2]).unwrap().normal());
        prop_assume!(slant.abs() > 1e-3);
        let inside = m.b.iter().all(|&b| b > 0.0);
        let sheared = PreparedRay::new(&ray).meet(CORNERS);
        for found in [moller_trumbore(&ray, CORNERS), plane_and_areas(&ray, CORNERS), sheared] {
            prop_assert_eq!(found.is_some(), inside);
            if let Some(f) = found {
                prop_assert_eq!(f.facing, m.facing);
                prop_assert!((0..3).all(|k| (f.b[k] - m.b[k]).abs() <= 1e-9));
            }
        }
    }

    /// Turning the corners about changes the names of the coordinates; swapping two turns the triangle over.
    #[test]
    fn corners_may_be_renamed(ray in crate::shapes::rays()) {
        let [a, b, c] = CORNERS;
        let sheared = PreparedRay::new(&ray);
        let met = sheared.meet([a, b, c]);
        let turned = sheared.meet([b, c, a]);
        let flipped = sheared.meet([b, a, c]);
        prop_assert_eq!(met.is_some(), turned.is_some());
        prop_assert_eq!(met.is_some(), flipped.is_some());
        if let (Some(m), Some(f)) = (met, flipped) {
            prop_assert!((m.facing == Facing::Front) != (f.facing == Facing::Front));
        }
    }

    /// The lifted point is above the facet, and at a corner it is the corner.
    #[test]
    fn terminator_points_lie_above_the_facet(b1 in 0.0..1.0f64, share in 0.0..1.0f64) {
        let b = [1.0 - b1 - (1.0 - b1) * share, b1, (1.0 - b1) * share];
        let face = Triangle::new(CORNERS[0], CORNERS[1], CORNERS[2]).unwrap();
        let center = (CORNERS[0] + CORNERS[1] + CORNERS[2]) / 3.0 - face.normal();
        let normals = CORNERS.map(|v| (v - center).normalize());
        let p = terminator_point(b, CORNERS, normals);
        prop_assert!((p - CORNERS[0]).dot(face.normal()) >= -16.0 * U);
        let n = interpolated_normal(b, normals).unwrap();
        prop_assert!((n.length() - 1.0).abs() <= 8.0 * U && n.dot(face.normal()) > 0.0);
        prop_assert_eq!(terminator_point([1.0, 0.0, 0.0], CORNERS, normals), CORNERS[0]);
    }
}
