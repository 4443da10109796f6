//! Rays from inside a closed mesh.

use super::{Face, LEVELS};
use glam::DVec3;
use lightbench::ray::Ray;
use lightbench::sample::{Sampler, uniform_triangle};
use lightbench::shape::triangle::icosphere;

/// Where rays go: to edges and corners, or anywhere.
#[derive(Clone, Copy)]
pub enum Aim {
    Edges,
    Inside,
}

/// A ray from inside the unit mesh, and the face that it is aimed at.
pub fn shot(seed: u64, k: u32, aim: Aim) -> (Ray, usize) {
    thread_local! { static MESH: Vec<Face> = icosphere(LEVELS); }
    let mut sampler = Sampler::new(seed, k.into(), 0);
    let (pick, along, from) =
        (sampler.next_1d(), sampler.next_2d(), [(); 3].map(|()| sampler.next_1d() - 0.5));
    MESH.with(|mesh| {
        let face = (pick * mesh.len() as f64) as usize;
        let [a, b, c] = mesh[face];
        let target = match (aim, k % 2) {
            (Aim::Edges, 0) => a,
            (Aim::Edges, _) => a + (b - a) * along.x,
            (Aim::Inside, _) => {
                let w = uniform_triangle(along);
                a * w.x + b * w.y + c * w.z
            }
        };
        let origin = DVec3::from_array(from) * 0.8;
        (Ray::new(origin, (target - origin).normalize()), face)
    })
}
