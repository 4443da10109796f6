//! What finding the nearest of many costs: the lines of lesson 12. Nothing is asserted here.
//!
//! - `build`: time to build over a knot of 70 000 triangles.
//! - `camera`, `chords`, `shadow`: rays a second from a pinhole, along random chords, and along chords that any hit ends.
//! - `scene`: list against hierarchy for few spheres, which sets from how many on a scene builds one.
//!
//! With `--features rivals` every other run is obvhs's (`f32`, its `medium` preset, triangles in the order of its leaves), and
//! the ratio of the medians is printed. Run: `cargo bench --bench bvh --features rivals`.

use glam::DVec3;
use lightbench::accel::{Bvh, Facets};
use lightbench::bounds::Aabb;
use lightbench::mesh::{Polygons, tessellate};
use lightbench::ray::{Ray, Silent};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::Shape;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::triangle::PreparedRay;
use std::hint::black_box;
use std::time::Instant;

const RUNS: usize = 11;
/// Pixels along the side of the picture that camera rays make.
const SIDE: u32 = 512;
const CHORDS: u32 = 200_000;

type Face = [DVec3; 3];

fn faces(mesh: &Polygons) -> Vec<Face> {
    let cut = mesh.triangulated().expect("a mesh").mesh;
    (0..cut.len())
        .map(|f| {
            let corners: Vec<DVec3> = cut.outline(f).collect();
            [corners[0], corners[1], corners[2]]
        })
        .collect()
}

fn camera() -> Vec<Ray> {
    let eye = DVec3::new(0.0, 0.0, 12.0);
    let at = |k: u32| (f64::from(k) + 0.5) / f64::from(SIDE) - 0.5;
    let target = |k: u32| DVec3::new(at(k % SIDE), at(k / SIDE), 0.0) * 7.6;
    (0..SIDE * SIDE).map(|k| Ray::new(eye, (target(k) - eye).normalize())).collect()
}

fn chords() -> Vec<Ray> {
    let end = |salt: u64, k: u32| uniform_sphere(Sampler::new(7, salt, k).next_2d()) * 3.7;
    (0..CHORDS).map(|k| Ray::new(end(0, k), (end(1, k) - end(0, k)).normalize())).collect()
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Seconds of each contestant: medians of alternating runs.
fn race(contestants: &mut [&mut dyn FnMut() -> f64]) -> Vec<f64> {
    let mut times = vec![Vec::new(); contestants.len()];
    for _ in 0..RUNS {
        for (times, run) in times.iter_mut().zip(contestants.iter_mut()) {
            let start = Instant::now();
            black_box(run());
            times.push(start.elapsed().as_secs_f64());
        }
    }
    times.into_iter().map(median).collect()
}

fn say(what: &str, items: usize, unit: &str, times: &[f64]) {
    let rate = |t: f64| items as f64 / t / 1e6;
    match times {
        [ours] => println!("{what}: {:.2} M {unit}/s", rate(*ours)),
        [ours, rest @ ..] => {
            let best = rest.iter().copied().fold(f64::INFINITY, f64::min);
            println!(
                "{what}: ours {:.2} M {unit}/s, obvhs {:.2}; ratio {:.2}",
                rate(*ours),
                rate(best),
                best / ours
            );
        }
        [] => {}
    }
}

fn nearest(facets: &Facets, mesh: &[Face], ray: &Ray) -> Option<f64> {
    let mut prepared = None;
    let found = facets.nearest(ray, 0.0, f64::INFINITY, &mut Silent, |face, limit| {
        let ray = prepared.get_or_insert_with(|| PreparedRay::new(ray));
        ray.meet(mesh[face as usize]).map(|m| m.t).filter(|&t| 0.0 < t && t < limit)
    });
    found.map(|(_, t)| t)
}

fn blocked(facets: &Facets, mesh: &[Face], ray: &Ray) -> bool {
    let mut prepared = None;
    let blocks = |face: u32| {
        let ray = prepared.get_or_insert_with(|| PreparedRay::new(ray));
        ray.meet(mesh[face as usize]).is_some_and(|m| 0.0 < m.t)
    };
    facets.any(ray, 0.0, f64::INFINITY, &mut Silent, blocks).is_some()
}

fn scenes() {
    for count in [2, 4, 6, 8, 12, 16, 24, 32, 64] {
        let sphere = |k: u32| {
            let mut sampler = Sampler::new(9, 0, k);
            Sphere::new(uniform_sphere(sampler.next_2d()) * 3.0, 0.6).expect("a sphere")
        };
        let spheres: Vec<Box<dyn Shape>> =
            (0..count).map(sphere).map(|s| Box::new(s) as Box<dyn Shape>).collect();
        let boxes: Vec<Aabb> = spheres.iter().map(|s| s.bounds()).collect();
        let bvh = Bvh::build(&boxes);
        let rays = &chords()[..20_000];
        let mut by_list = || {
            let test = |ray: &Ray| {
                let mut limit = f64::INFINITY;
                for s in &spheres {
                    limit = s.nearest(ray, 0.0, limit).map_or(limit, |c| c.t);
                }
                limit
            };
            rays.iter().map(test).filter(|t| t.is_finite()).sum()
        };
        let mut by_tree = || {
            let test = |ray: &Ray| {
                bvh.nearest(ray, 0.0, f64::INFINITY, &mut Silent, |i, limit| {
                    spheres[i as usize].nearest(ray, 0.0, limit)
                })
            };
            rays.iter().filter_map(test).map(|(_, c)| c.t).sum()
        };
        let times = race(&mut [&mut by_list, &mut by_tree]);
        let ns = |t: f64| t / rays.len() as f64 * 1e9;
        println!("scene of {count:2} spheres: list {:.0} ns, hierarchy {:.0} ns", ns(times[0]), ns(times[1]));
    }
}

#[cfg(feature = "rivals")]
mod rival {
    use super::Face;
    use lightbench::ray::Ray;
    use obvhs::BvhBuildParams;
    use obvhs::cwbvh::{CwBvh, builder::build_cwbvh_from_tris};
    use obvhs::ray::RayHit;
    use obvhs::rt_triangle::RtTriangle;
    use obvhs::triangle::Triangle;
    use std::time::Duration;

    pub struct Rival {
        triangles: Vec<Triangle>,
        bvh: CwBvh,
        leaves: Vec<RtTriangle>,
    }

    pub fn ray(ray: &Ray) -> obvhs::ray::Ray {
        obvhs::ray::Ray::new_inf(ray.origin.as_vec3a(), ray.direction.as_vec3a())
    }

    impl Rival {
        pub fn new(mesh: &[Face]) -> Self {
            let triangle =
                |v: &Face| Triangle { v0: v[0].as_vec3a(), v1: v[1].as_vec3a(), v2: v[2].as_vec3a() };
            let triangles: Vec<Triangle> = mesh.iter().map(triangle).collect();
            let bvh = Self::tree(&triangles);
            let leaves = bvh.primitive_indices.iter().map(|&i| (&triangles[i as usize]).into()).collect();
            Rival { triangles, bvh, leaves }
        }

        fn tree(triangles: &[Triangle]) -> CwBvh {
            build_cwbvh_from_tris(triangles, BvhBuildParams::medium_build(), &mut Duration::default())
        }

        pub fn build(&self) -> usize {
            Self::tree(&self.triangles).nodes.len()
        }

        pub fn nearest(&self, ray: &obvhs::ray::Ray) -> Option<f32> {
            let mut hit = RayHit::none();
            self.bvh.ray_traverse(*ray, &mut hit, |ray, id| self.leaves[id].intersect(ray)).then_some(hit.t)
        }
    }
}

fn main() {
    let mesh = faces(&tessellate::bumpy_knot(1000, 35));
    println!("{} triangles; medians of {RUNS} alternating runs, one thread", mesh.len());
    let facets = Facets::build(mesh.len(), |i| mesh[i as usize]);
    println!("memory: {} bytes a triangle", facets.bytes() / mesh.len());
    let mut build = || Facets::build(mesh.len(), |i| mesh[i as usize]).bytes() as f64;
    #[cfg(feature = "rivals")]
    let rival = rival::Rival::new(&mesh);
    #[cfg(feature = "rivals")]
    let times = race(&mut [&mut build, &mut || rival.build() as f64]);
    #[cfg(not(feature = "rivals"))]
    let times = race(&mut [&mut build]);
    say("build", mesh.len(), "triangles", &times);
    for (name, rays) in [("camera", camera()), ("chords", chords())] {
        let mut ours = || rays.iter().filter_map(|r| nearest(&facets, &mesh, r)).sum();
        #[cfg(feature = "rivals")]
        let times = {
            let theirs: Vec<_> = rays.iter().map(rival::ray).collect();
            race(&mut [&mut ours, &mut || {
                theirs.iter().filter_map(|r| rival.nearest(r)).map(f64::from).sum()
            }])
        };
        #[cfg(not(feature = "rivals"))]
        let times = race(&mut [&mut ours]);
        say(name, rays.len(), "rays", &times);
    }
    let rays = chords();
    let mut ours = || rays.iter().filter(|r| blocked(&facets, &mesh, r)).count() as f64;
    say("shadow", rays.len(), "rays", &race(&mut [&mut ours]));
    scenes();
}
