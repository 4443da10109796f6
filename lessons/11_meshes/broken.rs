//! What breaks a mesh: rays from inside a closed body, aimed at corners and edges of its faces, that meet nothing.

use glam::{DVec3, dvec3};
use lightbench::measure::{Point, Series, Spread, log_spaced};
use lightbench::mesh::{Mesh, Polygons, Topology, tessellate};
use lightbench::ray::{Ray, Silent};
use lightbench::sample::Sampler;
use lightbench::shape::Shape;
use lightbench::shape::triangle::moller_trumbore;
use rayon::prelude::*;

/// A place on an edge of a face: which face, which edge, and how far along it; every fourth at the corner itself.
fn aim(seed: u64, i: u32, mesh: &Mesh) -> DVec3 {
    let mut s = Sampler::new(seed, 21, i);
    let face = mesh.triangle((s.next_1d() * mesh.len() as f64) as usize);
    let (k, along) = ((s.next_1d() * 3.0) as usize, if i.is_multiple_of(4) { 0.0 } else { s.next_1d() });
    face[k] * (1.0 - along) + face[(k + 1) % 3] * along
}

/// A ray from near the middle of the body to such a place.
fn ray(seed: u64, i: u32, mesh: &Mesh) -> Ray {
    let mut s = Sampler::new(seed, 22, i);
    let b = mesh.bounds();
    let (u, w) = (s.next_2d(), s.next_1d());
    let origin = b.center() + (dvec3(u.x, u.y, w) - 0.5) * (b.max - b.min) * 0.25;
    Ray::new(origin, (aim(seed, i, mesh) - origin).normalize())
}

fn leaks(seed: u64, rays: u32, mesh: &Mesh, met: impl Fn(&Mesh, &Ray) -> bool + Sync) -> u64 {
    (0..rays).into_par_iter().filter(|&i| !met(mesh, &ray(seed, i, mesh))).count() as u64
}

fn watertight(mesh: &Mesh, ray: &Ray) -> bool {
    mesh.nearest(ray, 0.0, f64::INFINITY).is_some()
}

/// Möller and Trumbore's test on the faces that the hierarchy offers.
fn quick(mesh: &Mesh, ray: &Ray) -> bool {
    let test = |f: u32| moller_trumbore(ray, mesh.triangle(f as usize)).is_some_and(|m| m.t > 0.0);
    mesh.bvh().any(ray, 0.0, f64::INFINITY, &mut Silent, test).is_some()
}

pub struct Cracks {
    /// Faces that share their points, moved or not.
    pub shared: Series,
    /// Faces with points of their own, each moved by itself.
    pub split: Series,
    /// Rays that got out of the one and of the other, and how many were shot at each.
    pub leaks: [u64; 2],
    pub of: u64,
}

/// Points moved by up to a distance, those that are shared together, or each corner alone.
pub fn cracks(seed: u64, rays: u32) -> Cracks {
    let ball = tessellate::icosphere(2);
    let torn = Polygons::of_triangles(&(0..ball.len()).map(|f| corners(&ball, f)).collect::<Vec<_>>());
    let distances = log_spaced(1.0e-17, 1.0e-2, 16);
    let over = |polygons: &Polygons| {
        let leak = |&d: &f64| leaks(seed, rays, &moved(seed, polygons, d), watertight);
        let all: Vec<u64> = distances.iter().map(leak).collect();
        let point = |(&d, &n): (&f64, &u64)| Point::at(d).erred(Spread::exact(n as f64 / f64::from(rays)));
        (Series::new(distances.iter().zip(&all).map(point).collect()), all.iter().sum())
    };
    let ((shared, none), (split, some)) = (over(&ball), over(&torn));
    Cracks { shared, split, leaks: [none, some], of: u64::from(rays) * distances.len() as u64 }
}

fn corners(mesh: &Polygons, face: usize) -> [DVec3; 3] {
    let mut outline = mesh.outline(face);
    std::array::from_fn(|_| outline.next().unwrap_or_default())
}

/// Every point moved by up to `distance` along each axis.
fn moved(seed: u64, polygons: &Polygons, distance: f64) -> Mesh {
    let mut out = polygons.clone();
    for (i, p) in out.points.iter_mut().enumerate() {
        let mut s = Sampler::new(seed, 23, i as u32);
        let (u, w) = (s.next_2d(), s.next_1d());
        *p += (dvec3(u.x, u.y, w) * 2.0 - 1.0) * distance;
    }
    Mesh::new(&out).expect("a mesh")
}

/// A kind of damage, and how many rays get out.
pub struct Case {
    pub name: &'static str,
    pub topology: Topology,
    /// By the watertight test, which is the default; by Möller and Trumbore's.
    pub leaks: [u64; 2],
    /// Has the surface no hole, in exact arithmetic on its own numbers?
    pub whole: bool,
}

impl Case {
    /// A whole surface loses no ray.
    pub fn is_survived(&self) -> bool {
        !self.whole || self.leaks[0] == 0
    }
}

pub fn cases(seed: u64, rays: u32) -> Vec<Case> {
    let ball = || tessellate::icosphere(2);
    let at = |scale: f64, shift: DVec3| {
        let mut mesh = ball();
        mesh.points.iter_mut().for_each(|p| *p = *p * scale + shift);
        mesh
    };
    let twins = Polygons::of_triangles(&(0..320).map(|f| corners(&ball(), f)).collect::<Vec<_>>());
    let far = DVec3::new(1.0e6, -2.0e6, 3.0e6);
    let case = |name, polygons: Polygons, whole| {
        let mesh = Mesh::new(&polygons).expect("a mesh");
        let tests: [fn(&Mesh, &Ray) -> bool; 2] = [watertight, quick];
        Case { name, topology: *mesh.topology(), leaks: tests.map(|t| leaks(seed, rays, &mesh, t)), whole }
    };
    vec![
        case("sphere of 320 faces that share their points", ball(), true),
        case("the same, every face with its own copies", twins, true),
        case("the same, 1 nm in size", at(1.0e-9, DVec3::ZERO), true),
        case("the same, 3700 km from the origin", at(1.0, far), true),
        case(
            "needles: a cylinder of 20 000 sides",
            tessellate::cylinder(if rays > 5000 { 20_000 } else { 2000 }),
            true,
        ),
        case("flattened to a millionth of its height", flattened(), true),
        case("T-junctions: edges cut on one side only", t_junctions(), false),
        case("one face of 320 missing", without_a_face(), false),
    ]
}

fn flattened() -> Polygons {
    let mut mesh = tessellate::icosphere(2);
    mesh.points.iter_mut().for_each(|p| p.y *= 1.0e-6);
    mesh
}

/// Every other face is cut in four at the middles of its edges, its neighbours are not; middles lie on the edges as far as
/// rounding lets them.
fn t_junctions() -> Polygons {
    let ball = tessellate::icosphere(2);
    let mut mesh = Polygons::of_points(ball.points.clone());
    for f in 0..ball.len() {
        let face = [0, 1, 2].map(|k| ball.face(f)[k]);
        if f % 2 == 0 {
            mesh.push_points(&face);
            continue;
        }
        let [a, b, c] = face;
        let mut middle = |i: u32, j: u32| {
            mesh.points.push((ball.points[i as usize] + ball.points[j as usize]) * 0.5);
            mesh.points.len() as u32 - 1
        };
        let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
        for part in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
            mesh.push_points(&part);
        }
    }
    mesh
}

fn without_a_face() -> Polygons {
    let ball = tessellate::icosphere(2);
    let mut mesh = Polygons::of_points(ball.points.clone());
    ball.faces().skip(1).for_each(|face| mesh.push_points(face));
    mesh
}
