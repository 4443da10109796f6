//! How far the outline of a mesh stays behind that of the round thing it stands for, and what a ray costs.

use super::DIRECTIONS;
use glam::{DAffine3, DVec3, dvec3};
use lightbench::measure::{Point, Series, Spread, time_each};
use lightbench::mesh::{Mesh, Polygons, tessellate};
use lightbench::ray::Ray;
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::Shape;
use lightbench::shape::cylinder::Cylinder;
use lightbench::shape::sphere::Sphere;
use std::ops::RangeInclusive;

/// What is cut into triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solid {
    Cylinder,
    Sphere,
}

impl Solid {
    /// About the origin: the cylinder of height 1 and radius 1 along y, or the unit sphere.
    fn polygons(self, n: u32) -> Polygons {
        match self {
            Solid::Cylinder => {
                let down = DAffine3::from_translation(dvec3(0.0, -0.5, 0.0));
                tessellate::cylinder(n).transformed(&down)
            }
            Solid::Sphere => tessellate::sphere(n, n / 2),
        }
    }

    fn shape(self) -> Box<dyn Shape> {
        let half = DVec3::Y * 0.5;
        match self {
            Solid::Cylinder => Box::new(Cylinder::new(-half, half, 1.0).expect("a cylinder")),
            Solid::Sphere => Box::new(Sphere::new(DVec3::ZERO, 1.0).expect("a sphere")),
        }
    }

    /// A direction across which the outline is a circle of radius 1.
    fn direction(self, seed: u64, i: u32) -> DVec3 {
        let mut sampler = Sampler::new(seed, 11, i);
        let d = uniform_sphere(sampler.next_2d());
        match self {
            Solid::Cylinder => dvec3(d.x, 0.0, d.z).normalize_or(DVec3::X),
            Solid::Sphere => d,
        }
    }
}

/// How far out rays along `along` still meet the shape, going to `out`, a unit vector across; by halving 60 times.
fn reach(shape: &dyn Shape, along: DVec3, out: DVec3) -> f64 {
    let meets = |b: f64| shape.nearest(&Ray::new(out * b - along * 4.0, along), 0.0, f64::INFINITY).is_some();
    let (mut met, mut missed) = (0.0, 2.0);
    for _ in 0..60 {
        let middle = 0.5 * (met + missed);
        if meets(middle) { met = middle } else { missed = middle }
    }
    met
}

/// How much the outline falls short of 1 at worst.
fn shortfall(solid: Solid, shape: &dyn Shape, seed: u64) -> f64 {
    let short = |i: u32| {
        let along = solid.direction(seed, i);
        let out = match solid {
            Solid::Cylinder => along.cross(DVec3::Y),
            Solid::Sphere => along.cross(solid.direction(seed, i + DIRECTIONS)).normalize_or(DVec3::X),
        };
        1.0 - reach(shape, along, out)
    };
    (0..DIRECTIONS).map(short).fold(0.0, f64::max)
}

/// Rays from a distance of 4 m towards places in the cube that holds the shape.
fn rays(seed: u64) -> Vec<Ray> {
    (0..2048)
        .map(|i| {
            let mut sampler = Sampler::new(seed, 12, i);
            let origin = uniform_sphere(sampler.next_2d()) * 4.0;
            let (a, b) = (sampler.next_2d(), sampler.next_1d());
            let target = dvec3(a.x, a.y, b) * 2.0 - 1.0;
            Ray::new(origin, (target - origin).normalize())
        })
        .collect()
}

fn time(shape: &dyn Shape, seed: u64) -> Spread {
    let rays = rays(seed);
    time_each(rays.len(), || rays.iter().filter(|r| shape.nearest(r, 0.0, f64::INFINITY).is_some()).count())
}

/// A solid as meshes of more and more triangles.
pub struct Sweep {
    pub solid: Solid,
    /// Error of the outline over the number of triangles.
    pub over_triangles: Series,
}

pub fn sweep(solid: Solid, seed: u64, powers: RangeInclusive<u32>) -> Sweep {
    let point = |power: u32| {
        let mesh = Mesh::new(&solid.polygons(1 << power)).expect("a mesh");
        Point::at(mesh.len() as f64)
            .worked(mesh.len() as f64)
            .erred(Spread::exact(shortfall(solid, &mesh, seed)))
            .timed(time(&mesh, seed))
    };
    Sweep { solid, over_triangles: Series::new(powers.map(point).collect()) }
}

/// The points from the third on: there the next term of the series in 1/n² is below a hundredth.
pub fn tail(series: &Series) -> Series {
    Series::new(series.points[2..].to_vec())
}

/// What the formula takes, and how much it falls short.
pub struct Formula {
    pub time: Spread,
    pub error: f64,
}

pub fn formula(solid: Solid, seed: u64) -> Formula {
    let shape = solid.shape();
    Formula { time: time(&*shape, seed), error: shortfall(solid, &*shape, seed).abs() }
}
