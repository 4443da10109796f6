//! What a torus costs per ray. Nothing is asserted here; the numbers feed lesson 05:
//!
//! - `nearest/{10 a,10⁴ a}/{method}`: the cost axis of its speed–accuracy chart, seconds per ray; half of the rays hit.
//! - `blocks/{method}`: shadow segments from points of the surface to a lamp.
//! - `quartic/{solver}`: the solvers alone, on the moved quartics of the same rays.
//!
//! Run: `cargo bench --bench torus`.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use glam::{DVec2, DVec3};
use lightbench::num::quartic;
use lightbench::ray::Ray;
use lightbench::sample::uniform;
use lightbench::shape::Shape;
use lightbench::shape::torus::{Torus, TorusMethod};
use std::hint::black_box;
use std::time::Duration;

/// Enough to defeat the branch predictor, few enough for the nearest cache.
const RAYS: u64 = 1024;
const LAMP: DVec3 = DVec3::new(3.0, 9.0, 8.0);

fn torus() -> Torus {
    Torus::new(2.0, 0.6).expect("a ring torus")
}

/// Three coordinates in (−1, 1).
fn cube(i: u64, dimension: u32) -> DVec3 {
    DVec3::from_array([0, 1, 2].map(|k| 2.0 * uniform(0, i, 0, dimension + k) - 1.0))
}

/// From a sphere of radius `distance` towards points of the box about the torus.
fn towards(distance: f64) -> Vec<Ray> {
    let ray = |i| {
        let origin = cube(i, 0).normalize_or(DVec3::X) * distance;
        Ray::new(origin, (cube(i, 3) * DVec3::new(2.6, 2.6, 0.6) - origin).normalize())
    };
    (0..RAYS).map(ray).collect()
}

/// From points of the surface that face the lamp, to the lamp at `t = 1`.
fn shadow_segments() -> Vec<Ray> {
    let torus = torus();
    let segment = |i| {
        let target = torus.point_at(0, DVec2::new(uniform(1, i, 0, 0), uniform(1, i, 0, 1)));
        let eye = Ray::new(target + DVec3::new(1.0, -9.0, 5.0), DVec3::new(-1.0, 9.0, -5.0));
        let hit = torus.hit(&eye, &torus.nearest(&eye, 0.0, f64::INFINITY)?);
        let from = hit.origin_towards(LAMP - hit.point);
        (hit.ng.dot(LAMP - hit.point) > 0.0).then_some(Ray::new(from, LAMP - from))
    };
    (0..8 * RAYS).filter_map(segment).take(RAYS as usize).collect()
}

fn rays(c: &mut Criterion) {
    let mut group = c.benchmark_group("nearest");
    group.sample_size(20).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(2));
    group.throughput(Throughput::Elements(RAYS));
    for (name, distance) in [("10 a", 20.0), ("10⁴ a", 2.0e4)] {
        let rays = towards(distance);
        for method in TorusMethod::ALL {
            let torus = torus().with_method(method);
            let hits = || rays.iter().filter_map(|r| torus.nearest(r, 0.0, f64::INFINITY)).count();
            group.bench_function(BenchmarkId::new(name, method.name()), |b| b.iter(hits));
        }
    }
    group.finish();
}

fn shadows(c: &mut Criterion) {
    let segments = shadow_segments();
    let mut group = c.benchmark_group("blocks");
    group.sample_size(20).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(2));
    group.throughput(Throughput::Elements(segments.len() as u64));
    for method in TorusMethod::ALL {
        let torus = torus().with_method(method);
        let blocked = || segments.iter().filter(|r| torus.blocks(r, 1.0)).count();
        group.bench_function(method.name(), |b| b.iter(blocked));
    }
    group.finish();
}

fn solvers(c: &mut Criterion) {
    let solvers: [(&str, quartic::Solver); 6] = [
        ("adaptive", quartic::adaptive),
        ("bracketed", quartic::bracketed),
        ("algorithm_1010", quartic::algorithm_1010),
        ("ferrari", quartic::ferrari),
        ("sturm", quartic::sturm),
        ("as_printed", quartic::graphics_gems_as_printed),
    ];
    let coefficients: Vec<DVec3> = (0..RAYS).map(|i| cube(i, 6) * DVec3::new(8.0, 4.0, 2.0)).collect();
    let mut group = c.benchmark_group("quartic");
    group.sample_size(20).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(2));
    group.throughput(Throughput::Elements(RAYS));
    for (name, solve) in solvers {
        let roots = || coefficients.iter().map(|c| black_box(solve(0.0, c.x, c.y, c.z)).len()).sum::<usize>();
        group.bench_function(name, |b| b.iter(roots));
    }
    group.finish();
}

criterion_group!(benches, rays, shadows, solvers);
criterion_main!(benches);
