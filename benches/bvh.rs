//! What finding the nearest of many costs: the lines of lesson 12. Nothing is asserted here.
//!
//! - `build`: time to build over a knot of 70 000 triangles.
//! - `whole mesh`: the same with welding, topology, tangents and all that a mesh keeps.
//! - `camera`, `chords`, `shadow`: rays a second from a pinhole, along random chords, and along chords that any hit ends;
//!   the first two also by `Mesh::nearest`.
//! - `scene`: list against hierarchy for few spheres, which sets from how many on a scene builds one.
//! - `dispatch`: spheres as `Box<dyn Shape>` against spheres as an enum.
//!
//! With `--features rivals` every other run is obvhs's (`f32`, its `medium` preset, triangles in the order of its leaves), and
//! the median of the ratios of neighbouring runs is printed with its quartiles: ours is so many times as quick as it. Run:
//! `cargo bench --bench bvh --features rivals`.
//!
//! What `dispatch` said: among spheres alone an enum is 1.25 to 1.3 times as quick, because the only case that occurs is
//! inlined and predicted; with three kinds it is 1.02 to 1.08 times as quick, for then both jump where the kind sends them.
//! A scene mixes kinds, and shapes of the reader's own have no place in an enum: scenes keep `Box<dyn Shape>`.

use glam::DVec3;
use lightbench::accel::{Bvh, Facets};
use lightbench::bounds::Aabb;
use lightbench::mesh::{Mesh, Polygons, tessellate};
use lightbench::ray::{Crossing, Ray, Silent};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::Shape;
use lightbench::shape::cylinder::Cylinder;
use lightbench::shape::disc::Disc;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::triangle::PreparedRay;
use std::hint::black_box;
use std::time::Instant;

const RUNS: usize = 11;
/// Runs of a millisecond, of which the quickest counts: on a busy machine most are interrupted, and their median with them.
const SHORT_RUNS: usize = 101;
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

/// Seconds of each contestant's quickest run.
fn sprint(contestants: &mut [Contestant]) -> Vec<f64> {
    race(SHORT_RUNS, contestants).into_iter().map(|t| quantile(t, 0.0)).collect()
}

fn median(times: &[f64]) -> f64 {
    quantile(times.to_vec(), 0.5)
}

fn quantile(mut values: Vec<f64>, q: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values[(values.len() as f64 * q) as usize]
}

type Contestant<'a> = &'a mut dyn FnMut() -> f64;

/// Seconds of each contestant in alternating runs.
fn race(runs: usize, contestants: &mut [Contestant]) -> Vec<Vec<f64>> {
    let mut times = vec![Vec::new(); contestants.len()];
    for _ in 0..runs {
        for (times, run) in times.iter_mut().zip(contestants.iter_mut()) {
            let start = Instant::now();
            black_box(run());
            times.push(start.elapsed().as_secs_f64());
        }
    }
    times
}

/// How many times as quick as `theirs` we are, from run to run: the median and the quartiles.
fn ratio(theirs: &[f64], ours: &[f64]) -> String {
    let ratios: Vec<f64> = theirs.iter().zip(ours).map(|(a, b)| a / b).collect();
    let at = |q| quantile(ratios.clone(), q);
    format!("{:.2} ({:.2} to {:.2})", at(0.5), at(0.25), at(0.75))
}

/// Races our contestants; the last one is obvhs's, if there is one.
fn report(items: usize, unit: &str, names: &[&str], contestants: &mut [Contestant]) {
    let times = race(RUNS, contestants);
    let rate = |t: &[f64]| items as f64 / median(t) / 1e6;
    for (name, ours) in names.iter().zip(&times) {
        print!("{name}: {:.2} M {unit}/s", rate(ours));
        match times.get(names.len()) {
            Some(theirs) => println!(", obvhs {:.2}; ratio {}", rate(theirs), ratio(theirs, ours)),
            None => println!(),
        }
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
    for count in [2, 4, 6, 7, 8, 9, 10, 11, 12, 14, 16, 24, 32, 64] {
        let sphere = |k: u32| {
            let mut sampler = Sampler::new(9, 0, k);
            Sphere::new(uniform_sphere(sampler.next_2d()) * 3.0, 0.6).expect("a sphere")
        };
        let spheres: Vec<Box<dyn Shape>> =
            (0..count).map(sphere).map(|s| Box::new(s) as Box<dyn Shape>).collect();
        let boxes: Vec<Aabb> = spheres.iter().map(|s| s.bounds()).collect();
        let bvh = Bvh::build(&boxes);
        let rays = &chords()[..20_000];
        let mut by_list = || sum(rays, &spheres, |s, ray, limit| s.nearest(ray, 0.0, limit));
        let mut by_tree = || {
            let test = |ray: &Ray| {
                bvh.nearest(ray, 0.0, f64::INFINITY, &mut Silent, |i, limit| {
                    spheres[i as usize].nearest(ray, 0.0, limit)
                })
            };
            rays.iter().filter_map(test).map(|(_, c)| c.t).sum()
        };
        let times = sprint(&mut [&mut by_list, &mut by_tree]);
        let ns = |t: f64| t / rays.len() as f64 * 1e9;
        println!("scene of {count:2} spheres: list {:.0} ns, hierarchy {:.0} ns", ns(times[0]), ns(times[1]));
    }
}

/// Some of the shapes as an enum.
#[expect(
    clippy::large_enum_variant,
    reason = "a sphere takes the room of a cylinder: that is part of the price"
)]
enum Either {
    Sphere(Sphere),
    Cylinder(Cylinder),
    Disc(Disc),
}

impl Either {
    #[inline]
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        match self {
            Either::Sphere(s) => s.nearest(ray, t_min, t_max),
            Either::Cylinder(s) => s.nearest(ray, t_min, t_max),
            Either::Disc(s) => s.nearest(ray, t_min, t_max),
        }
    }
}

fn dispatch() {
    let rays = &chords()[..20_000];
    for (kinds, count) in [(1, 8), (1, 64), (3, 8), (3, 64)] {
        let place = |k: u32| uniform_sphere(Sampler::new(9, 0, k).next_2d()) * 3.0;
        let kind = |k: u32| Sampler::new(10, 0, k).next_1d() * f64::from(kinds);
        let of = |k: u32| match kind(k) as u32 {
            0 => Either::Sphere(Sphere::new(place(k), 0.6).expect("a sphere")),
            1 => Either::Cylinder(Cylinder::new(place(k), place(k) + DVec3::Y, 0.5).expect("a cylinder")),
            _ => Either::Disc(Disc::new(place(k), DVec3::Y, 0.6).expect("a disc")),
        };
        let enums: Vec<Either> = (0..count).map(of).collect();
        let boxed = |k: u32| -> Box<dyn Shape> {
            match of(k) {
                Either::Sphere(s) => Box::new(s),
                Either::Cylinder(s) => Box::new(s),
                Either::Disc(s) => Box::new(s),
            }
        };
        let boxes: Vec<Box<dyn Shape>> = (0..count).map(boxed).collect();
        let mut by_enum = || sum(rays, &enums, |s, ray, limit| s.nearest(ray, 0.0, limit));
        let mut by_box = || sum(rays, &boxes, |s, ray, limit| s.nearest(ray, 0.0, limit));
        let times = sprint(&mut [&mut by_enum, &mut by_box]);
        println!("{count} shapes of {kinds} kinds: enum {:.2} times as quick as dyn", times[1] / times[0]);
    }
}

/// Sum of the distances to the nearest of a list.
fn sum<S>(rays: &[Ray], shapes: &[S], nearest: impl Fn(&S, &Ray, f64) -> Option<Crossing>) -> f64 {
    let first =
        |ray| shapes.iter().fold(f64::INFINITY, |limit, s| nearest(s, ray, limit).map_or(limit, |c| c.t));
    rays.iter().map(first).filter(|t| t.is_finite()).sum()
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
    let polygons = tessellate::bumpy_knot(1000, 35);
    let mesh = faces(&polygons);
    println!("{} triangles; medians of {RUNS} alternating runs, one thread", mesh.len());
    let facets = Facets::build(mesh.len(), |i| mesh[i as usize]);
    println!("memory: {} bytes a triangle", facets.bytes() / mesh.len());
    let whole = Mesh::new(&polygons).expect("a mesh");
    #[cfg(feature = "rivals")]
    let rival = rival::Rival::new(&mesh);
    let mut contestants: Vec<Contestant> = Vec::new();
    let mut build = || Facets::build(mesh.len(), |i| mesh[i as usize]).bytes() as f64;
    let mut build_whole = || Mesh::new(&polygons).map_or(0.0, |m| m.len() as f64);
    contestants.push(&mut build);
    contestants.push(&mut build_whole);
    #[cfg(feature = "rivals")]
    let mut theirs = || rival.build() as f64;
    #[cfg(feature = "rivals")]
    contestants.push(&mut theirs);
    report(mesh.len(), "triangles", &["build", "whole mesh"], &mut contestants);
    for (name, rays) in [("camera", camera()), ("chords", chords())] {
        let mut contestants: Vec<Contestant> = Vec::new();
        let mut ours = || rays.iter().filter_map(|r| nearest(&facets, &mesh, r)).sum();
        let mut by_mesh =
            || rays.iter().filter_map(|r| whole.nearest(r, 0.0, f64::INFINITY)).map(|c| c.t).sum();
        contestants.push(&mut ours);
        contestants.push(&mut by_mesh);
        #[cfg(feature = "rivals")]
        let prepared: Vec<_> = rays.iter().map(rival::ray).collect();
        #[cfg(feature = "rivals")]
        let mut theirs = || prepared.iter().filter_map(|r| rival.nearest(r)).map(f64::from).sum();
        #[cfg(feature = "rivals")]
        contestants.push(&mut theirs);
        report(rays.len(), "rays", &[name, &format!("{name} by Mesh")], &mut contestants);
    }
    let rays = chords();
    let mut ours = || rays.iter().filter(|r| blocked(&facets, &mesh, r)).count() as f64;
    report(rays.len(), "rays", &["shadow"], &mut [&mut ours]);
    scenes();
    dispatch();
}
