//! Shoots rays at the edges and corners of a closed mesh, and counts those that get out: `cargo bench --bench leaks [RAYS]`.

use glam::DVec3;
use lightbench::ray::Ray;
use lightbench::sample::Sampler;
use lightbench::shape::triangle::{PreparedRay, icosphere};
use rayon::prelude::*;
use std::process::ExitCode;
use std::time::Instant;

const RAYS: u64 = 100_000_000;
const LEVELS: u32 = 3; // 1280 faces
const THREADS: usize = 2;
const SEED: u64 = 1;

type Face = [DVec3; 3];

fn main() -> ExitCode {
    let rays = std::env::args().skip(1).find_map(|a| a.parse().ok()).unwrap_or(RAYS);
    let mesh = icosphere(LEVELS);
    let touching = |f: &Face| -> Vec<Face> {
        let shared = |g: &Face| g.iter().filter(|v| f[..2].contains(v)).count();
        let mut near: Vec<Face> = mesh.iter().copied().filter(|g| shared(g) > 0).collect();
        // Those on both sides of the first edge come first: most rays end there.
        near.sort_by_key(|g| 2 - shared(g));
        near
    };
    let near: Vec<Vec<Face>> = mesh.iter().map(touching).collect();
    let start = Instant::now();
    let count = || (0..rays).into_par_iter().filter(|&i| leaks(i, &mesh, &near)).count();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(THREADS).build();
    let leaks = pool.map_or_else(|_| count(), |pool| pool.install(count));
    let seconds = start.elapsed().as_secs_f64();
    println!("{leaks} of {rays} rays leaked, {seconds:.0} s on {THREADS} threads");
    if leaks == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Does the ray find no way to end at the faces round its target, nor at any other?
fn leaks(i: u64, mesh: &[Face], near: &[Vec<Face>]) -> bool {
    let mut sampler = Sampler::new(SEED, i, 0);
    let place = sampler.next_2d();
    let face = (place.x * mesh.len() as f64) as usize;
    let [a, b, _] = mesh[face];
    let target = match i % 3 {
        0 => a,
        1 => a + (b - a) * place.y,
        _ => (a + b) * 0.5,
    };
    // Every other ray starts in the middle; of those at corners, each then points exactly at one.
    let origin = if i.is_multiple_of(2) {
        DVec3::ZERO
    } else {
        (DVec3::from_array([(); 3].map(|()| sampler.next_1d())) - 0.5) * 0.8
    };
    let ray = PreparedRay::new(&Ray::new(origin, target - origin));
    let ends = |f: &Face| ray.meet(*f).is_some_and(|m| m.t > 0.0);
    !near[face].iter().any(ends) && !mesh.iter().any(ends)
}
