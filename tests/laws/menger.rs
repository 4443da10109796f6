//! The Menger sponge: its walk through the grid against every cell tested by itself, and its field.

use crate::shape_laws;
use crate::shapes::{Inside, Member, Pose};
use glam::DVec3;
use lightbench::num::gamma;
use lightbench::ray::{Crossing, Ray, Span};
use lightbench::sdf::{DistanceField, FieldShape, Menger};
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::{Shape, ShapeError, Solid};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};

/// Cells of 1/16: the planes are exact, at home and moved.
const EDGE: f64 = 27.0 / 16.0;

fn posed(pose: &Pose) -> Menger {
    Menger::new(pose.point(DVec3::ZERO), EDGE * pose.scale, 3).unwrap()
}

/// Which plane a face number names, from the middle of the sponge of depth 3 and edge [`EDGE`].
fn plane_of(face: u32) -> f64 {
    let i = if face.is_multiple_of(2) { face / 6 } else { 27 - face / 6 };
    EDGE * ((f64::from(i) - 13.5) / 27.0)
}

const SPONGE: Member = Member {
    make: |pose| Box::new(posed(pose)),
    solid: Some(|pose| Box::new(posed(pose))),
    near: |p, face, reach| {
        (p[(face % 6 / 2) as usize] - plane_of(face)).abs() <= reach + gamma(3) * EDGE
            && p.abs().max_element() <= EDGE / 2.0 + reach
    },
    uv_slope: |_| 1.0,
    inside: Inside::Any,
};

shape_laws!(sponge_laws, SPONGE);

/// Every solid cell of a sponge as a box. Edge `3^depth` about half of it: the planes are whole numbers, without rounding.
fn cells(depth: u32) -> (Menger, Vec<Cuboid>) {
    let n = 3u32.pow(depth);
    let edge = f64::from(n);
    let sponge = Menger::new(DVec3::splat(edge / 2.0), edge, depth).unwrap();
    let all = (0..n).flat_map(|x| (0..n).flat_map(move |y| (0..n).map(move |z| [x, y, z])));
    let solid = all.filter(|c| sponge.is_solid(*c));
    let boxes = solid.map(|c| {
        let min = DVec3::from_array(c.map(f64::from));
        Cuboid::new(min, min + 1.0).unwrap()
    });
    (sponge, boxes.collect())
}

/// Where the ray's line lies in a box, by slabs; it may leave beyond all numbers.
fn slabs(cube: &Cuboid, ray: &Ray) -> Option<(f64, f64)> {
    let b = Shape::bounds(cube);
    let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
    for k in 0..3 {
        let (o, d) = (ray.origin[k], ray.direction[k]);
        if d != 0.0 {
            let (s, t) = ((b.min[k] - o) / d, (b.max[k] - o) / d);
            (enter, leave) = (enter.max(s.min(t)), leave.min(s.max(t)));
        } else if o < b.min[k] || o > b.max[k] {
            return None;
        }
    }
    (enter < leave).then_some((enter, leave))
}

/// The union of the boxes along the ray's line: sorted, disjoint, none of length 0.
fn brute(boxes: &[Cuboid], ray: &Ray) -> Vec<(f64, f64)> {
    let mut spans: Vec<(f64, f64)> = boxes.iter().filter_map(|b| slabs(b, ray)).collect();
    spans.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut out: Vec<(f64, f64)> = Vec::new();
    for s in spans {
        match out.last_mut() {
            Some(last) if s.0 <= last.1 => last.1 = last.1.max(s.1),
            _ => out.push(s),
        }
    }
    out
}

fn ends(spans: &[Span]) -> Vec<(f64, f64)> {
    spans.iter().map(|s| (s.enter.t, s.leave.t)).collect()
}

/// Every answer of the sponge about a ray, against the boxes.
fn agrees(sponge: &Menger, boxes: &[Cuboid], ray: &Ray) -> Result<(), TestCaseError> {
    let truth = brute(boxes, ray);
    let (mut spans, mut found) = (Vec::new(), Vec::new());
    sponge.spans(ray, &mut spans);
    prop_assert_eq!(&ends(&spans), &truth, "{:?}", ray);
    sponge.crossings(ray, &mut found);
    let ahead: Vec<f64> =
        truth.iter().flat_map(|s| [s.0, s.1]).filter(|t| *t > 0.0 && t.is_finite()).collect();
    let ts: Vec<f64> = found.iter().map(|c| c.t).collect();
    prop_assert_eq!(&ts, &ahead, "{:?}", ray);
    for (t_min, t_max) in [(0.0, f64::INFINITY), (0.5, 9.0), (1.0, 3.0), (-4.0, 2.0)] {
        let first = truth.iter().flat_map(|s| [s.0, s.1]).find(|t| *t > t_min).filter(|t| *t < t_max);
        prop_assert_eq!(sponge.nearest(ray, t_min, t_max).map(|c| c.t), first, "{:?}", ray);
    }
    prop_assert_eq!(sponge.blocks(ray, 5.0), ahead.iter().any(|t| *t < 5.0));
    for c in &found {
        let hit = sponge.hit(ray, c);
        prop_assert!(!clear_of_edges(hit.point) || sponge.contains(hit.point - hit.ng * 0.25));
        prop_assert!(!clear_of_edges(hit.point) || !sponge.contains(hit.point + hit.ng * 0.25));
    }
    Ok(())
}

/// Does a point of a wall lie well off the planes that cross it, which are whole numbers?
fn clear_of_edges(p: DVec3) -> bool {
    p.to_array().into_iter().filter(|x| (x - x.round()).abs() > 1e-6).count() == 2
}

/// Coordinates on planes, in the middle of cells, and anywhere.
fn coordinate(n: f64) -> impl Strategy<Value = f64> {
    let n32 = n as i32;
    prop_oneof![
        3 => (-2..=n32 + 2).prop_map(f64::from),
        1 => (-2..=n32 + 2).prop_map(|i| f64::from(i) + 0.5),
        1 => (0..=n32).prop_map(|i| f64::from(i).next_up()),
        1 => (0..=n32).prop_map(|i| f64::from(i).next_down()),
        2 => -0.2 * n..1.2 * n,
    ]
}

fn slope() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => Just(0.0),
        1 => Just(-0.0),
        4 => (-3..=3i32).prop_map(f64::from),
        1 => prop_oneof![Just(1e-17), Just(-1e-9), Just(5e-324), Just(1e300), Just(-1e-300)],
        3 => -1.0..1.0,
    ]
}

fn hostile(n: f64) -> impl Strategy<Value = Ray> {
    let point = move || [coordinate(n), coordinate(n), coordinate(n)].prop_map(DVec3::from_array);
    let direction = [slope(), slope(), slope()].prop_map(DVec3::from_array);
    prop_oneof![
        2 => (point(), direction).prop_map(|(o, d)| Ray::new(o, d)),
        1 => (point(), point()).prop_map(|(o, p)| Ray::new(o, p - o)),
    ]
    .prop_filter("no direction", |r| r.direction != DVec3::ZERO)
}

fn config(cases: u32) -> Config {
    Config {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(94),
        max_global_rejects: 1 << 20,
        ..Config::default()
    }
}

/// The same quotients make the same spans, to the bit: along faces, edges and diagonals, from inside and on planes.
#[test]
fn the_walk_finds_what_every_cell_by_itself_finds() {
    for (depth, cases) in [(0, 2_000), (1, 20_000), (2, 8_000), (3, 400)] {
        let (sponge, boxes) = cells(depth);
        proptest!(config(cases), |(ray in hostile(3f64.powi(depth as i32)))| agrees(&sponge, &boxes, &ray)?);
    }
}

/// Of the four cells around an edge no two that are solid stand across from two that are not; else a ray could slip through.
#[test]
fn no_two_cells_hang_together_by_an_edge_alone() {
    let n = 27u32;
    let sponge = Menger::new(DVec3::ZERO, 1.0, 3).unwrap();
    let solid = |c: [u32; 3]| c.iter().all(|i| (1..=n).contains(i)) && sponge.is_solid(c.map(|i| i - 1));
    for (axis, layer) in (0..3usize).flat_map(|a| (1..=n).map(move |l| (a, l))) {
        for (u, v) in (0..=n).flat_map(|u| (0..=n).map(move |v| (u, v))) {
            let at = |du: u32, dv: u32| {
                let mut c = [layer; 3];
                (c[(axis + 1) % 3], c[(axis + 2) % 3]) = (u + du, v + dv);
                solid(c)
            };
            let (a, b, c, d) = (at(0, 0), at(1, 1), at(0, 1), at(1, 0));
            let crossed = a == b && c == d && a != c;
            assert!(!crossed, "axis {axis}, layer {layer}, {u} {v}");
        }
    }
}

fn solid_part(digits: [u32; 3]) -> bool {
    digits.iter().filter(|d| **d == 1).count() < 2
}

/// Rays at the middle of a solid cell end at it or before, wherever the sponge stands and whatever its size.
#[test]
fn no_ray_reaches_the_inside_of_a_cell_unseen() {
    let places = (-8f64..9.0, [-3f64..3.0, -3f64..3.0, -3f64..3.0], 1u32..=8);
    // At each depth one of the 20 parts that are left.
    let left: Vec<[u32; 3]> = (0..27).map(|i| [i % 3, i / 3 % 3, i / 9]).filter(|d| solid_part(*d)).collect();
    let rays = ([-1f64..1.0, -1f64..1.0, -1f64..1.0], proptest::collection::vec(0usize..20, 8), 0u8..7);
    proptest!(config(20_000), |((power, center, depth) in places, (way, parts, flat) in rays)| {
        let edge = 10f64.powf(power);
        let sponge = Menger::new(DVec3::from_array(center) * edge, edge, depth).unwrap();
        let n = 3u32.pow(depth);
        let cell = parts[..depth as usize].iter().fold([0; 3], |c, p| [0, 1, 2].map(|k| 3 * c[k] + left[*p][k]));
        let mut way = DVec3::from_array(way);
        // Some directions lie along a plane or an axis.
        (0..3).filter(|k| flat >> k & 1 == 1).for_each(|k| way[k] = 0.0);
        prop_assert!(sponge.is_solid(cell));
        prop_assume!(way.length() > 0.01);
        let middle = |k: usize| (f64::from(cell[k]) + 0.5) / f64::from(n) - 0.5;
        let target = sponge.center() + DVec3::new(middle(0), middle(1), middle(2)) * edge;
        prop_assert!(sponge.contains(target));
        let way = way.normalize();
        let ray = Ray::new(target - way * (4.0 * edge), way * edge);
        let found = sponge.nearest(&ray, 0.0, f64::INFINITY);
        prop_assert!(found.is_some_and(|c| c.t < 4.0), "{found:?}");
        // From there into the solid the ray is blocked, and from inside the cell it finds its way out.
        prop_assert!(sponge.nearest(&Ray::new(target, way), 0.0, f64::INFINITY).is_some());
    });
}

/// Shadow and reflected rays: a hit's point is left outwards without meeting its own wall, and inwards it is inside.
#[test]
fn rays_leave_the_walls_they_hit() {
    let any = [-1f64..1.0, -1f64..1.0, -1f64..1.0];
    proptest!(config(20_000), |(from in any.clone(), at in any.clone(), way in any, depth in 0u32..7, power in -8f64..9.0)| {
        let size = 10f64.powf(power);
        let sponge = Menger::new(DVec3::splat(0.3 * size), size, depth).unwrap();
        let from = DVec3::splat(0.3 * size) + DVec3::from_array(from) * 2.0 * size;
        let ray = Ray::new(from, DVec3::from_array(at) * 0.5 * size + DVec3::splat(0.3 * size) - from);
        let Some(c) = sponge.nearest(&ray, 0.0, f64::INFINITY) else { return Ok(()) };
        let hit = sponge.hit(&ray, &c);
        let leaving = hit.origin_towards(hit.ng);
        let way = DVec3::from_array(way);
        let way = if way.dot(hit.ng) < 0.0 { -way } else { way };
        if let Some(next) = sponge.nearest(&Ray::new(leaving, way), 0.0, f64::INFINITY) {
            prop_assert!(next.face != hit.face || next.t * way.length() > sponge.detail() * 0.5);
        }
    });
}

/// (1) of the module: no more than the distance to any wall, 0 on walls, and its sign that of the cells.
#[test]
fn the_field_knows_inside_from_outside_and_never_exceeds_the_distance() {
    let any = [-1.2f64..1.2, -1.2f64..1.2, -1.2f64..1.2];
    proptest!(config(20_000), |(p in any.clone(), q in any, depth in 0u32..7)| {
        let sponge = Menger::new(DVec3::splat(0.1), 2.0, depth).unwrap();
        let (p, q) = (DVec3::from_array(p), DVec3::from_array(q));
        let (f, blur) = (sponge.distance(p), sponge.rounding(p));
        prop_assert!(f.abs() <= blur || sponge.contains(p) == (f < 0.0), "{f}");
        prop_assert!((f - sponge.distance(q)).abs() <= (p - q).length() + 2.0 * blur);
        let ray = Ray::new(p, (q - p).normalize());
        if let Some(c) = sponge.nearest(&ray, 0.0, f64::INFINITY) {
            prop_assert!(c.t >= f.abs() - 2.0 * blur, "{} nearer than {f}", c.t);
            let wall = sponge.hit(&ray, &c).point;
            prop_assert!(sponge.distance(wall).abs() <= blur + sponge.rounding(wall));
        }
    });
}

/// Marched and walked: the same crossing, unless the ray dives less than the tolerance into the sponge there.
#[test]
fn marching_finds_what_the_walk_finds() {
    let any = [-1f64..1.0, -1f64..1.0, -1f64..1.0];
    proptest!(config(3_000), |(from in any.clone(), to in any, far in 0.2f64..4.0, depth in 0u32..6)| {
        let sponge = Menger::new(DVec3::ZERO, 2.0, depth).unwrap();
        let marched = FieldShape::new(sponge).unwrap();
        let from = DVec3::from_array(from) * far;
        let ray = Ray::new(from, DVec3::from_array(to) - from);
        let (mut spans, mut truth) = (Vec::new(), Vec::new());
        sponge.spans(&ray, &mut spans);
        sponge.crossings(&ray, &mut truth);
        let speed = ray.direction.length();
        // 4096 steps leave the tolerance 2⁴ times what it was; a sponge's field is at least 1/√2 of the depth along the ray's way.
        let unseen = 32.0 * marched.march().tolerance;
        let deep = |s: &Span| (0..64).any(|i| {
            let t = s.enter.t + (s.leave.t - s.enter.t) * (f64::from(i) + 0.5) / 64.0;
            t > 0.0 && sponge.distance(ray.at(t)) < -unseen
        });
        let first = marched.nearest(&ray, 0.0, f64::INFINITY);
        let close = |c: &Crossing, t: f64| (c.t - t).abs() * speed <= unseen * 4.0;
        if let Some(first) = first {
            prop_assert!(truth.iter().any(|c| close(&first, c.t)) , "{first:?} is no crossing of {truth:?}");
        }
        // What it passes over is shallow.
        let reached = first.map_or(f64::INFINITY, |c| c.t);
        for s in spans.iter().filter(|s| s.enter.t > 0.0 && (s.enter.t - reached) * speed < -4.0 * unseen) {
            prop_assert!(!deep(s), "{s:?} passed over, {first:?}");
        }
    });
}

#[test]
fn what_is_no_sponge_is_refused() {
    let o = DVec3::ZERO;
    assert!(matches!(Menger::new(o, 1.0, 13), Err(ShapeError::TooDeep { allowed: 12, found: 13 })));
    assert!(matches!(Menger::new(o, 0.0, 1), Err(ShapeError::NotPositive { .. })));
    assert!(matches!(Menger::new(o, f64::NAN, 1), Err(ShapeError::NotFinite { .. })));
    assert!(matches!(Menger::new(DVec3::splat(1e9), 1e-8, 1), Err(ShapeError::TooFine { .. })));
    assert!(matches!(Menger::new(DVec3::splat(1e9), 1.0, 12), Err(ShapeError::TooFine { .. })));
    assert!(Menger::new(DVec3::splat(1e9), 1e9, 12).is_ok());
    assert!(Menger::new(o, 1e-8, 12).is_ok());
    assert!(
        matches!(Menger::new(o, f64::MAX, 1), Err(ShapeError::NotFinite { .. }))
            || Menger::new(o, 1e307, 1).is_ok()
    );
}

/// 20ⁿ cells are left.
#[test]
fn twenty_of_twenty_seven_cells_are_left() {
    for depth in 0..4 {
        assert_eq!(cells(depth).1.len(), 20usize.pow(depth));
    }
}
