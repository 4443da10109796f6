//! Polygons, half-edges, tessellations.

use glam::{DAffine3, DVec2, DVec3, dvec2, dvec3};
use lightbench::mesh::{
    Corner, HalfEdges, NONE, NotAManifold, Outline, Polygons, Tangents, Topology, tessellate, triangulate,
};
use lightbench::num::U;
use proptest::prelude::*;
use proptest::test_runner::Config;
use std::f64::consts::PI;

fn config(cases: u32) -> Config {
    Config { cases, failure_persistence: None, ..Config::default() }
}

/// Closed surfaces of known genus.
fn closed() -> Vec<(&'static str, Polygons, i64)> {
    vec![
        ("sphere", tessellate::sphere(7, 5), 0),
        ("coarsest sphere", tessellate::sphere(0, 0), 0),
        ("icosphere", tessellate::icosphere(2), 0),
        ("cylinder", tessellate::cylinder(9), 0),
        ("coarsest cylinder", tessellate::cylinder(0), 0),
        ("cone", tessellate::cone(5), 0),
        ("cone on its tip", tessellate::frustum(0.0, 2.0, 6), 0),
        ("frustum", tessellate::frustum(2.0, 0.5, 6), 0),
        ("cube", tessellate::cube(1), 0),
        ("cube of squares", tessellate::cube(4), 0),
        ("torus", tessellate::torus(2.0, 0.5, 8, 6), 1),
        ("coarsest torus", tessellate::torus(2.0, 0.5, 0, 0), 1),
        ("knot", tessellate::bumpy_knot(64, 6), 1),
    ]
}

#[test]
fn tessellations_are_closed_and_have_their_euler_characteristic() {
    for (name, mesh, genus) in closed() {
        let t = Topology::of(&mesh);
        assert!(t.is_closed(), "{name}: {t:?}");
        assert_eq!(t.genus(), Some(genus), "{name}: {t:?}");
        assert_eq!(t.euler(), 2 - 2 * genus, "{name}");
        assert!(mesh.volume() > 0.0, "{name} is inside out");
        assert_eq!((t.boundary_edges, t.branching_edges, t.components), (0, 0, 1), "{name}");
    }
}

#[test]
fn half_edges_lead_back_to_the_same_polygons() {
    for (name, mesh, genus) in closed() {
        let half = HalfEdges::of(&mesh).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!(half.is_closed() && half.boundary().is_empty(), "{name}");
        assert_eq!(half.euler(), 2 - 2 * genus, "{name}");
        let back = half.polygons();
        assert!(mesh.faces().eq(back.faces()), "{name}");
        assert_eq!(mesh.points, back.points);
        for h in 0..half.halves.len() as u32 {
            let twin = half.twin(h).expect("closed");
            assert_eq!(half.twin(twin), Some(h));
            assert_eq!(
                half.halves[half.halves[h as usize].next as usize].origin,
                half.halves[twin as usize].origin
            );
        }
    }
}

/// The queries of the half-edges against looking at everything.
#[test]
fn half_edges_find_what_a_scan_finds() {
    let mut open = Polygons::of_points(tessellate::sphere(9, 6).points);
    let whole = tessellate::sphere(9, 6);
    for face in whole.faces().skip(11) {
        open.push_points(face);
    }
    for mesh in [whole, open, tessellate::torus(2.0, 0.5, 7, 5)] {
        let half = HalfEdges::of(&mesh).expect("a manifold");
        for v in 0..mesh.points.len() as u32 {
            let mut around: Vec<usize> =
                half.around(v).map(|h| half.halves[h as usize].face as usize).collect();
            around.sort_unstable();
            assert!(mesh.faces_around(v).eq(around.iter().copied()));
            let mut ring: Vec<u32> = half.one_ring(v).collect();
            ring.sort_unstable();
            let mut scanned: Vec<u32> = mesh
                .faces_around(v)
                .flat_map(|f| {
                    let face = mesh.face(f);
                    let at = face.iter().position(|p| *p == v).expect("a corner of the face");
                    [face[(at + 1) % face.len()], face[(at + face.len() - 1) % face.len()]]
                })
                .collect();
            scanned.sort_unstable();
            scanned.dedup();
            assert_eq!(ring, scanned);
        }
        for f in 0..mesh.len() as u32 {
            for g in half.neighbours(f) {
                let shared =
                    mesh.face(f as usize).iter().filter(|v| mesh.face(g as usize).contains(v)).count();
                assert!(shared >= 2);
                assert!(half.neighbours(g).any(|back| back == f));
            }
        }
    }
}

#[test]
fn a_hole_has_a_rim() {
    let whole = tessellate::sphere(9, 6);
    let mut open = Polygons::of_points(whole.points.clone());
    for face in whole.faces().skip(9) {
        open.push_points(face);
    }
    // The triangles of the first pole are gone: their 9 outer edges remain.
    let (t, half) = (Topology::of(&open), HalfEdges::of(&open).expect("a manifold"));
    assert_eq!((t.boundary_edges, t.unbalanced_edges, t.euler()), (9, 9, 1));
    assert!(!t.is_closed() && t.genus().is_none());
    let rims = half.boundary();
    assert_eq!(rims.len(), 1);
    assert_eq!(rims[0].len(), 9);
    for (a, b) in rims[0].iter().zip(rims[0].iter().cycle().skip(1)) {
        let next = half.halves[*a as usize].next;
        assert_eq!(half.halves[next as usize].origin, half.halves[*b as usize].origin);
    }
}

#[test]
fn what_is_no_manifold_is_told() {
    let points = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, DVec3::ONE];
    let mut book = Polygons::of_points(points.clone());
    for page in [[0, 1, 2], [0, 1, 3]] {
        book.push_points(&page);
    }
    assert_eq!(HalfEdges::of(&book), Err(NotAManifold::Edge { from: 0, to: 1 }));
    assert_eq!(Topology::of(&book).unbalanced_edges, 5);
    let mut bow = Polygons::of_points([points, vec![dvec3(2.0, 2.0, 2.0)]].concat());
    for wing in [[0, 1, 2], [0, 4, 5]] {
        bow.push_points(&wing);
    }
    assert_eq!(HalfEdges::of(&bow), Err(NotAManifold::Point { point: 0 }));
}

/// Volume and area by the divergence theorem; the error falls with the squared size of a face.
#[test]
fn volumes_and_areas_converge_quadratically_to_closed_forms() {
    type Make = fn(u32) -> Polygons;
    let cases: [(&str, Make, f64, f64); 5] = [
        ("sphere", |n| tessellate::sphere(2 * n, n), 4.0 / 3.0 * PI, 4.0 * PI),
        ("cylinder", tessellate::cylinder, PI, 4.0 * PI),
        ("cone", tessellate::cone, PI / 3.0, PI * (1.0 + 2f64.sqrt())),
        ("frustum", |n| tessellate::frustum(2.0, 1.0, n), 7.0 / 3.0 * PI, PI * (5.0 + 3.0 * 2f64.sqrt())),
        ("torus", |n| tessellate::torus(2.0, 0.5, 3 * n, n), PI * PI, 4.0 * PI * PI),
    ];
    for (name, make, volume, area) in cases {
        let error = |n: u32| {
            let mesh = make(n).triangulated().expect("short outlines").mesh;
            assert!(mesh.volume() > 0.0, "{name} is inside out");
            [volume - mesh.volume(), area - mesh.area()]
        };
        let (coarse, fine) = (error(64), error(128));
        for i in 0..2 {
            // A series in 1/n²: the ratio is 4 + O(1/n²), with a factor of a few.
            let ratio = coarse[i] / fine[i];
            assert!((ratio - 4.0).abs() < 40.0 / (64.0 * 64.0), "{name} {i}: {ratio}");
        }
    }
    // 96 triangles of exact numbers, summed.
    assert!((tessellate::cube(4).volume() - 1.0).abs() <= 128.0 * U);
    assert_eq!(tessellate::cube(4).area(), 6.0);
}

#[test]
fn tessellated_points_lie_on_the_surface_and_normals_point_out() {
    for (name, mesh, _) in closed() {
        for f in 0..mesh.len() {
            let flat = mesh.area_vector(f).normalize();
            for c in mesh.range(f) {
                let Some(n) = mesh.normals.get(c) else { continue };
                assert!((n.length() - 1.0).abs() <= 8.0 * U, "{name}");
                // The coarsest are prisms and worse; of the others every side sees its surface's normals within 70°.
                assert!(name.starts_with("coarsest") || n.dot(flat) > 0.3, "{name}: {n} {flat}");
                assert!(
                    mesh.uvs
                        .get(c)
                        .is_none_or(|uv| uv.cmpge(DVec2::ZERO).all() && uv.cmple(DVec2::ONE).all())
                );
            }
        }
    }
    for p in tessellate::sphere(17, 9).points {
        assert!((p.length() - 1.0).abs() <= 4.0 * U);
    }
    for p in tessellate::torus(2.0, 0.5, 13, 11).points {
        let tube = dvec2(p.x.hypot(p.y) - 2.0, p.z).length();
        assert!((tube - 0.5).abs() <= 16.0 * U);
    }
}

#[test]
fn a_mirror_keeps_fronts_in_front() {
    let map = DAffine3::from_scale(dvec3(-1.0, 2.0, 0.5));
    let mesh = tessellate::sphere(8, 6).transformed(&map);
    assert!(mesh.volume() > 0.0);
    for f in 0..mesh.len() {
        let flat = mesh.area_vector(f);
        assert!(mesh.range(f).all(|c| mesh.normals.get(c).is_some_and(|n| n.dot(flat) > 0.0)));
    }
}

/// A star-shaped outline: corners at ascending angles, any radii.
fn stars() -> impl Strategy<Value = Vec<DVec3>> {
    prop::collection::vec(0.05..1.0, 4..60).prop_map(|radii| {
        let n = radii.len() as f64;
        let corner = |(i, r): (usize, &f64)| (DVec2::from_angle(2.0 * PI * i as f64 / n) * *r).extend(0.0);
        radii.iter().enumerate().map(corner).collect()
    })
}

fn area(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    0.5 * (b - a).cross(c - a).z
}

proptest! {
    #![proptest_config(config(500))]

    /// n − 2 triangles, none of them turned round, with the outline's area: no gap, no overlap.
    #[test]
    fn concave_outlines_are_filled(star in stars(), turned in 0..3usize) {
        let mut cut = Vec::new();
        let outline: Vec<DVec3> = star.iter().map(|p| DVec3::from_array([0, 1, 2].map(|k| p[(k + turned) % 3]))).collect();
        prop_assert_eq!(triangulate(&outline, &mut cut), Outline::Simple);
        prop_assert_eq!(cut.len(), star.len() - 2);
        let areas: Vec<f64> = cut.iter().map(|t| { let [a, b, c] = t.map(|k| star[k as usize]); area(a, b, c) }).collect();
        prop_assert!(areas.iter().all(|a| *a > -4.0 * U));
        let whole: f64 = star.iter().zip(star.iter().cycle().skip(1)).map(|(a, b)| area(DVec3::ZERO, *a, *b)).sum();
        // Below 200 products and sums of size up to 1.
        prop_assert!((areas.iter().sum::<f64>() - whole).abs() <= 256.0 * U);
    }

    /// Whatever the outline: n − 2 triangles of its corners, and an end.
    #[test]
    fn any_outline_is_cut_without_harm(points in prop::collection::vec((-3i32..4, -3i32..4, 0i32..2), 0..24)) {
        let outline: Vec<DVec3> = points.iter().map(|&(x, y, z)| dvec3(x.into(), y.into(), z.into())).collect();
        let mut cut = Vec::new();
        triangulate(&outline, &mut cut);
        prop_assert_eq!(cut.len(), outline.len().saturating_sub(2));
        prop_assert!(cut.iter().flatten().all(|k| (*k as usize) < outline.len()));
        // Every side of the outline belongs to a triangle, and inner edges cancel: the rim stays the rim.
        let mut mesh = Polygons::of_points(outline.clone());
        cut.iter().for_each(|t| mesh.push_points(t));
        if outline.len() >= 3 {
            let rim: Vec<u32> = (0..outline.len() as u32).rev().collect();
            mesh.push_points(&rim);
            prop_assert!(Topology::of(&mesh).is_closed());
        }
    }
}

#[test]
fn a_comb_of_too_many_teeth_is_told_and_a_round_one_is_not() {
    let tooth = |i: usize| dvec3(i as f64, if i.is_multiple_of(2) { 0.0 } else { 1.0 }, 0.0);
    let mut comb: Vec<DVec3> = (0..4095).map(tooth).collect();
    comb.push(dvec3(2000.0, -9.0, 0.0));
    let mut cut = Vec::new();
    assert_eq!(triangulate(&comb, &mut cut), Outline::Simple);
    assert_eq!(cut.len(), 4094);
    comb.insert(4095, dvec3(4096.0, -1.0, 0.0));
    cut.clear();
    assert_eq!(triangulate(&comb, &mut cut), Outline::TooLong);
    assert!(cut.is_empty());
    let round = tessellate::cylinder(20_000);
    let cap: Vec<DVec3> = round.outline(round.len() - 1).collect();
    assert_eq!(triangulate(&cap, &mut cut), Outline::Simple);
    assert_eq!(cut.len(), 19_998);
}

#[test]
fn computed_normals_are_smooth_on_a_sphere_and_sharp_on_a_cube() {
    let ball = tessellate::sphere(48, 24).facetted().with_smooth_normals(PI / 3.0);
    for f in 0..ball.len() {
        for c in ball.range(f) {
            let (n, p) = (ball.normals.get(c).expect("computed"), ball.points[ball.corner(c).point as usize]);
            // The mean of faces that bend by 7.5°, each way as much: an error of the second order.
            assert!(n.dot(p) > 0.999, "{n} {p}");
        }
    }
    let cube = tessellate::cube(3).facetted().with_smooth_normals(PI / 3.0);
    let same = tessellate::cube(3);
    for c in 0..cube.corner_count() {
        assert_eq!(cube.normals.get(c), same.normals.get(c));
    }
    let round = tessellate::cube(1).facetted().with_smooth_normals(PI);
    for c in 0..round.corner_count() {
        let p = round.points[round.corner(c).point as usize];
        assert!(round.normals.get(c).expect("computed").dot(p.normalize()) > 1.0 - 4.0 * U);
    }
}

#[test]
fn tangents_are_orthonormal_and_follow_u() {
    for mesh in [
        tessellate::sphere(16, 8),
        tessellate::torus(2.0, 0.5, 9, 7),
        tessellate::cylinder(12),
        tessellate::cube(2),
    ] {
        let mesh = mesh.triangulated().expect("short outlines").mesh;
        let tangents = Tangents::of(&mesh);
        for f in 0..mesh.len() {
            for c in mesh.range(f) {
                let (t, n) =
                    (tangents.values[tangents.corners[c] as usize], mesh.normals.get(c).expect("given"));
                assert!((t.direction.length() - 1.0).abs() <= 8.0 * U);
                assert!(t.direction.dot(n).abs() <= 16.0 * U);
                assert_eq!(t.handedness, 1.0, "a texture as seen from outside");
            }
        }
    }
    // On the torus u runs along the ring: the tangent is e_φ.
    let ring = tessellate::torus(2.0, 0.5, 64, 32).triangulated().expect("short outlines").mesh;
    let tangents = Tangents::of(&ring);
    for c in 0..ring.corner_count() {
        let p = ring.points[ring.corner(c).point as usize];
        let along = dvec3(-p.y, p.x, 0.0).normalize();
        // Chords of 1/64 of a turn, meeting at both sides of a seam at least on one: 2.8° off.
        assert!(tangents.values[tangents.corners[c] as usize].direction.dot(along) > 0.998);
    }
}

#[test]
fn mirrored_and_missing_textures_are_told_apart() {
    let mut mesh = Polygons::of_points(vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::NEG_X]);
    mesh.uvs.values = vec![DVec2::ZERO, DVec2::X, DVec2::Y, dvec2(0.5, 0.5)];
    mesh.normals.values = vec![DVec3::Z];
    let corner = |point, uv| Corner { point, uv, normal: 0 };
    mesh.push(&[corner(0, 0), corner(1, 1), corner(2, 2)], 0);
    mesh.push(&[corner(0, 0), corner(2, 2), corner(3, 1)], 0); // u grows towards −x: mirrored
    mesh.push(&[corner(0, NONE), corner(1, NONE), corner(2, NONE)], 0);
    mesh.push(&[corner(0, 3), corner(1, 3), corner(2, 3)], 0);
    let tangents = Tangents::of(&mesh);
    let of = |c: usize| tangents.values[tangents.corners[c] as usize];
    assert_eq!(tangents.undetermined, 2);
    assert!((0..3).all(|c| of(c).direction == DVec3::X && of(c).handedness == 1.0));
    assert!((3..6).all(|c| of(c).direction == DVec3::NEG_X && of(c).handedness == -1.0));
    assert!((6..12).all(|c| of(c).direction.is_normalized() && of(c).direction.z == 0.0));
}
