//! The contestants, on hills of triangles.

use glam::DVec3;
use lightbench::accel::{Ball, Bvh, Facets, Hull, Hulls, Octree, Splitting, as_printed_nearest};
use lightbench::bounds::Aabb;
use lightbench::measure::{Spread, time_each, timed};
use lightbench::ray::{Ray, Silent, Tally, Trace, Work};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::triangle::PreparedRay;

pub type Face = [DVec3; 3];

/// Rays behind a time, and behind counts and comparisons.
const RAYS: u32 = 512;
/// Tests that a time may cost before fewer rays have to do.
const PATIENCE: usize = 400_000;
/// A's octree is cut to the depth at which a cube is about as wide as a field of the hills, as far as memory goes.
const DEEPEST: usize = 7;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Facets,
    Bvh,
    Threshold,
    Printed,
    Hulls,
    Nothing,
}

/// A structure over triangles.
pub enum Structure {
    Facets(Facets),
    Bvh(Bvh),
    Octree(Octree),
    Printed(Octree, Vec<Ball>),
    Hulls(Hulls),
    Nothing,
}

/// Hills over a square in the unit ball, of about `n` triangles: two to each of `k × k` fields.
pub fn hills(n: usize) -> Vec<Face> {
    let k = (n as f64 / 2.0).sqrt().round().max(1.0) as usize;
    let at = |i: usize, j: usize| {
        let (x, z) = (2.0 * i as f64 / k as f64 - 1.0, 2.0 * j as f64 / k as f64 - 1.0);
        let y = 0.25 * (5.0 * x + 2.0 * z).sin() * (4.0 * z - x).cos()
            + 0.04 * (31.0 * x).sin() * (29.0 * z).sin();
        DVec3::new(x, y, z)
    };
    let field = |f: usize| {
        let (i, j) = (f / k, f % k);
        let [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
        [[a, b, c], [a, c, d]]
    };
    (0..k * k).flat_map(field).collect()
}

/// Between points of a sphere round the hills.
pub fn chords(seed: u64, count: u32) -> Vec<Ray> {
    let ray = |k: u32| {
        let mut sampler = Sampler::new(seed, 2, k);
        let [a, b] = [0; 2].map(|_| uniform_sphere(sampler.next_2d()) * 1.5);
        Ray::new(a, (b - a).normalize_or(DVec3::X))
    };
    (0..count).map(ray).collect()
}

pub fn boxes(mesh: &[Face]) -> Vec<Aabb> {
    mesh.iter().map(|f| Aabb::of_points(*f)).collect()
}

impl Structure {
    pub fn build(kind: Kind, mesh: &[Face]) -> Self {
        match kind {
            Kind::Facets => Structure::Facets(Facets::build(mesh.len(), |i| mesh[i as usize])),
            Kind::Bvh => Structure::Bvh(Bvh::build(&boxes(mesh))),
            Kind::Threshold => Structure::Octree(Octree::build(&boxes(mesh), Splitting::D)),
            Kind::Printed => {
                let depth = ((mesh.len() as f64).log2() / 2.0).round() as usize;
                let boxes = boxes(mesh);
                let octree = Octree::build(&boxes, Splitting::to_depth(depth.clamp(1, DEEPEST)));
                Structure::Printed(octree, boxes.iter().map(Ball::around).collect())
            }
            Kind::Hulls => Structure::Hulls(Hulls::build(&boxes(mesh), Hull::Box)),
            Kind::Nothing => Structure::Nothing,
        }
    }

    pub fn bytes(&self) -> usize {
        match self {
            Structure::Facets(s) => s.bytes(),
            Structure::Bvh(s) => s.bytes(),
            Structure::Octree(s) => s.bytes(),
            Structure::Printed(s, balls) => s.bytes() + size_of_val(&balls[..]),
            Structure::Hulls(s) => s.bytes(),
            Structure::Nothing => 0,
        }
    }

    pub fn nearest<T: Trace>(&self, mesh: &[Face], ray: &Ray, trace: &mut T) -> Option<(u32, f64)> {
        let prepared = PreparedRay::new(ray);
        let t = |i: u32| prepared.meet(mesh[i as usize]).map(|m| m.t).filter(|&t| t > 0.0);
        let test = |i: u32, limit: f64| t(i).filter(|&t| t < limit);
        let end = f64::INFINITY;
        match self {
            Structure::Facets(s) => s.nearest(ray, 0.0, end, trace, test),
            Structure::Bvh(s) => s.nearest(ray, 0.0, end, trace, test),
            Structure::Octree(s) => s.nearest(ray, 0.0, end, trace, &mut Vec::new(), test),
            Structure::Hulls(s) => s.nearest(ray, 0.0, end, trace, test),
            Structure::Printed(octree, balls) => {
                let (mut items, mut visits) = (Vec::new(), Tally::default());
                octree.each(ray, 0.0, end, &mut visits, |i| items.push(i));
                items.sort_unstable();
                items.dedup();
                trace.count(Work::NodeVisit, visits.node_visits + items.len() as u64);
                let tested = |i: u32| {
                    trace.count(Work::ShapeTest, 1);
                    t(i)
                };
                as_printed_nearest(items, |i| balls[i as usize], ray, tested)
            }
            Structure::Nothing => {
                trace.count(Work::ShapeTest, mesh.len() as u64);
                let mut best: Option<(u32, f64)> = None;
                for i in 0..mesh.len() as u32 {
                    best = test(i, best.map_or(end, |b| b.1)).map(|t| (i, t)).or(best);
                }
                best
            }
        }
    }
}

/// A structure on hills of one size.
pub struct Outcome {
    pub n: usize,
    /// Seconds to build, and a ray.
    pub build: f64,
    pub time: Option<Spread>,
    /// Boxes, cubes, balls and triangles that a ray looks at.
    pub looks: f64,
    pub bytes: usize,
    /// Answers that are not those of no structure.
    pub wrong: usize,
    pub asked: usize,
}

pub fn sweep(seed: u64, sizes: &[usize], kind: Kind) -> Vec<Outcome> {
    sizes.iter().map(|&n| outcome(seed, n, kind)).collect()
}

fn outcome(seed: u64, n: usize, kind: Kind) -> Outcome {
    let (mesh, rays) = (hills(n), chords(seed, RAYS));
    let n = mesh.len();
    let (build, structure) = timed(|| Structure::build(kind, &mesh));
    let few = (PATIENCE / n).clamp(4, RAYS as usize);
    let count = if matches!(kind, Kind::Nothing | Kind::Hulls) { few } else { rays.len() };
    let mut tally = Tally::default();
    let found: Vec<_> = rays[..count].iter().map(|r| structure.nearest(&mesh, r, &mut tally)).collect();
    let truth: Vec<_> =
        rays[..few].iter().map(|r| Structure::Nothing.nearest(&mesh, r, &mut Silent)).collect();
    let time = time_each(count, || {
        rays[..count].iter().filter(|r| structure.nearest(&mesh, r, &mut Silent).is_some()).count()
    });
    Outcome {
        n,
        build,
        time: Some(time),
        looks: (tally.node_visits + tally.shape_tests) as f64 / count as f64,
        bytes: structure.bytes(),
        wrong: truth.iter().zip(&found).filter(|(a, b)| a != b).count(),
        asked: truth.len(),
    }
}
