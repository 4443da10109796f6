//! What local illumination costs. Nothing is asserted here; the numbers feed these chart lines:
//!
//! - `shadow ray/{grid,jittered}/{widest,baseline}`: lines "grid" and "jittered" of lesson 19's chart of time per
//!   shadow ray, with the widest vectors of the processor and with those of the default target. criterion's
//!   throughput is in shadow rays; its inverse is the chart's nanoseconds per ray.
//! - `sphere/{algebraic,geometric,robust}`: the cost axis of lesson 02's speed–accuracy chart, per pair of roots.
//!
//! Run: `cargo bench --bench local`.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use glam::DVec3;
use lightbench::integrator::Local;
use lightbench::ray::RayKind;
use lightbench::render::{Picture, render};
use lightbench::sample::uniform;
use lightbench::scene::Scene;
use lightbench::shape::fan::Vectors;
use lightbench::shape::sphere::method::{algebraic, geometric, robust};
use lightbench_kit::scene_file::{Color, read};
use std::hint::black_box;
use std::time::Duration;

const SCENE: &str = include_str!("../scenes/d01_boxes_spheres.scene");
const PICTURE: Picture = Picture { width: 512, height: 512, samples: 1, seed: 0 };
/// Rays for the sphere methods: enough to defeat the branch predictor, few enough for the nearest cache.
const RAYS: usize = 1024;

fn scene(placement: &str) -> Scene {
    let source = SCENE.replace("Subdivision", &format!("Placement {placement}\n  Subdivision"));
    match read(&source, "d01_boxes_spheres.scene") {
        Ok(file) => file.scene,
        Err(wrong) => panic!("{}", wrong.render(Color::Never)),
    }
}

/// Scene 1 at 512 × 512 on one thread, per shadow ray.
fn shadow_rays(c: &mut Criterion) {
    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread");
    let mut group = c.benchmark_group("shadow ray");
    group.sample_size(10).warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(5));
    for placement in ["grid", "jittered"] {
        let scene = scene(placement);
        for (name, vectors) in [("widest", Vectors::Widest), ("baseline", Vectors::Baseline)] {
            let local = Local { vectors, ..Local::default() };
            let draw = || one_thread.install(|| render(&scene, &local, PICTURE));
            group.throughput(Throughput::Elements(draw().tally.rays(RayKind::Shadow)));
            group.bench_function(BenchmarkId::new(placement, name), |b| b.iter(draw));
        }
    }
    group.finish();
}

/// Rays from a shell of radius 5 towards points in the cube about the unit sphere: about half of them hit.
fn towards_the_sphere() -> Vec<([f64; 3], [f64; 3])> {
    let point = |i: u64, d: u32| DVec3::from_array([0, 1, 2].map(|k| 2.0 * uniform(0, i, 0, d + k) - 1.0));
    let ray = |i: u64| {
        let origin = 5.0 * point(i, 0).normalize_or(DVec3::X);
        (origin.to_array(), (point(i, 3) - origin).normalize().to_array())
    };
    (0..RAYS as u64).map(ray).collect()
}

fn sphere_methods(c: &mut Criterion) {
    let rays = towards_the_sphere();
    let mut group = c.benchmark_group("sphere");
    group.sample_size(20).measurement_time(Duration::from_secs(2));
    group.throughput(Throughput::Elements(RAYS as u64));
    for (name, method) in [
        ("algebraic", algebraic::<f64> as fn([f64; 3], [f64; 3], f64) -> Option<(f64, f64)>),
        ("geometric", geometric::<f64>),
        ("robust", robust::<f64>),
    ] {
        let all =
            || rays.iter().filter_map(|(f, d)| method(*f, *d, black_box(1.0))).map(|t| t.0).sum::<f64>();
        group.bench_function(name, |b| b.iter(all));
    }
    group.finish();
}

criterion_group!(benches, shadow_rays, sphere_methods);
criterion_main!(benches);
