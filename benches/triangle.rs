//! Time of a ray–triangle test by method: the lines of lesson 04, figure `leaks`.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use glam::DVec3;
use lightbench::ray::Ray;
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::Sides;
use lightbench::shape::triangle::{
    Meeting, PreparedRay, as_printed, icosphere, moller_trumbore, plane_and_areas,
};
use std::hint::black_box;

const RAYS: u32 = 64;

fn rays() -> Vec<Ray> {
    let ray = |k: u32| {
        let mut sampler = Sampler::new(1, 0, k);
        Ray::new(uniform_sphere(sampler.next_2d()) * 0.4, uniform_sphere(sampler.next_2d()))
    };
    (0..RAYS).map(ray).collect()
}

fn triangle_tests(c: &mut Criterion) {
    let (mesh, rays) = (icosphere(2), rays());
    let mut group = c.benchmark_group("triangle");
    group.throughput(Throughput::Elements(u64::from(RAYS) * mesh.len() as u64));
    let sum = |found: &dyn Fn(&Ray, &[[DVec3; 3]]) -> f64| {
        rays.iter().map(|r| found(black_box(r), &mesh)).sum::<f64>()
    };
    fn total(mesh: &[[DVec3; 3]], test: impl Fn([DVec3; 3]) -> Option<Meeting>) -> f64 {
        mesh.iter().filter_map(|&f| test(f)).map(|m| m.t).sum()
    }
    group.bench_function("watertight", |b| {
        b.iter(|| {
            sum(&|ray, mesh| {
                let ray = PreparedRay::new(ray);
                total(mesh, |f| ray.meet(f))
            })
        })
    });
    group.bench_function("Möller–Trumbore", |b| {
        b.iter(|| sum(&|ray, mesh| total(mesh, |f| moller_trumbore(ray, f))))
    });
    group.bench_function("plane and areas", |b| {
        b.iter(|| sum(&|ray, mesh| total(mesh, |f| plane_and_areas(ray, f))))
    });
    group.bench_function("as A prints it", |b| {
        b.iter(|| sum(&|ray, mesh| total(mesh, |f| as_printed(ray, f, Sides::Both))))
    });
    group.finish();
}

criterion_group!(benches, triangle_tests);
criterion_main!(benches);
