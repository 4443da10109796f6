//! Every structure answers as no structure does, to the bit.

use glam::DVec3;
use lightbench::accel::Bvh;
use lightbench::bounds::Aabb;
use lightbench::num::vectors::Vectors;
use lightbench::ray::{Crossing, Ray, Tally};
use lightbench::shape::Shape;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::triangle::Triangle;
use proptest::prelude::*;
use proptest::test_runner::Config;

fn config() -> Config {
    Config { cases: 300, failure_persistence: None, ..Config::default() }
}

/// The answer without a structure: every item, in order; a tie keeps the earlier one.
fn scan(shapes: &[Box<dyn Shape>], ray: &Ray, t_min: f64, t_max: f64) -> Option<(u32, Crossing)> {
    let mut best: Option<(u32, Crossing)> = None;
    for (item, shape) in (0..).zip(shapes) {
        let limit = best.map_or(t_max, |(_, c)| c.t);
        if let Some(c) = shape.nearest(ray, t_min, limit) {
            best = Some((item, c));
        }
    }
    best
}

/// Coordinates on a coarse grid meet each other's faces and corners; others lie anywhere, near and far.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (-8i32..=8).prop_map(|i| f64::from(i) * 0.25),
        4 => -2.0..2.0,
        1 => Just(-0.0),
        1 => Just(1e-300),
        1 => -1e6..1e6,
    ]
}

fn point() -> impl Strategy<Value = DVec3> {
    [number(), number(), number()].prop_map(DVec3::from_array)
}

/// Directions along axes, in planes, almost so, and anywhere; of any length.
fn direction() -> impl Strategy<Value = DVec3> {
    let lengths = prop_oneof![Just(1.0), Just(1e-3), Just(1e8)];
    (point(), lengths).prop_map(|(d, length)| d * length).prop_filter("no direction", |d| *d != DVec3::ZERO)
}

fn ray() -> impl Strategy<Value = Ray> {
    let far = prop_oneof![4 => Just(0.0), 1 => Just(1e9), 1 => Just(1e20)];
    (point(), direction(), far).prop_map(|(o, d, away)| Ray::new(o - d * away, d))
}

fn shape() -> impl Strategy<Value = Option<Box<dyn Shape>>> {
    let triangle = [point(), point(), point()]
        .prop_map(|[a, b, c]| Triangle::new(a, b, c).ok().map(|t| Box::new(t) as Box<dyn Shape>));
    let sphere = (point(), 0.01..2.0f64)
        .prop_map(|(c, r)| Sphere::new(c, r).ok().map(|s| Box::new(s) as Box<dyn Shape>));
    prop_oneof![3 => triangle, 1 => sphere]
}

/// Up to sixty shapes, some of them several times.
fn shapes() -> impl Strategy<Value = Vec<Box<dyn Shape>>> {
    proptest::collection::vec(shape(), 0..60).prop_map(|s| s.into_iter().flatten().collect())
}

fn boxes(shapes: &[Box<dyn Shape>]) -> Vec<Aabb> {
    shapes.iter().map(|s| s.bounds()).collect()
}

#[test]
fn bvh_answers_as_no_structure() {
    proptest!(config(), |(shapes in shapes(), rays in proptest::collection::vec(ray(), 20))| {
        let bvh = Bvh::build(&boxes(&shapes));
        let baseline = bvh.clone().with_vectors(Vectors::Baseline);
        for ray in &rays {
            let truth = scan(&shapes, ray, 0.0, f64::INFINITY);
            let mut counts = [Tally::default(); 2];
            for (bvh, count) in [&bvh, &baseline].into_iter().zip(&mut counts) {
                let found = bvh.nearest(ray, 0.0, f64::INFINITY, count, |i, limit| {
                    shapes[i as usize].nearest(ray, 0.0, limit)
                });
                prop_assert_eq!(found, truth, "{:?}", ray);
            }
            prop_assert_eq!(counts[0], counts[1]);
            let blocker = bvh.any(ray, 0.0, 1.0, &mut counts[0], |i| shapes[i as usize].blocks(ray, 1.0));
            prop_assert_eq!(blocker.is_some(), shapes.iter().any(|s| s.blocks(ray, 1.0)));
        }
    });
}
