//! Eight shapes of any size, anywhere, and shadow rays from them whose answers are known beforehand.

use glam::{DAffine3, DMat3, DVec3, dvec3};
use lightbench::frame::basis;
use lightbench::num::U;
use lightbench::ray::{Hit, Ray};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::cone::Cone;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::cylinder::Cylinder;
use lightbench::shape::disc::Disc;
use lightbench::shape::instance::Instance;
use lightbench::shape::plane::Plane;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::torus::Torus;
use lightbench::shape::triangle::Triangle;
use lightbench::shape::{Shape, ShapeError};
use std::f64::consts::TAU;

/// Which way the bodies are moved from the world's origin.
pub const AWAY: DVec3 = DVec3::new(0.48, 0.6, 0.64);

/// Bodies whose shadow rays are tested eight at a time come first in [`bodies`].
pub const VECTORISED: usize = 2;

/// A shape that its tangent planes do not cut where it is asked, so that the answers are known.
pub struct Body {
    pub shape: Box<dyn Shape>,
    /// Does it enclose a solid, so that what enters must leave?
    pub is_closed: bool,
    pub size: f64,
    center: DVec3,
    /// Is the hit clear of edges, and its tangent plane clear of the rest of the shape?
    admits: fn(&Hit) -> bool,
}

/// What must come out.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Truth {
    /// The light stands above the tangent plane: it is seen.
    Lit,
    /// The light stands below: the body itself is in the way.
    Dark,
}

/// A hit, with the side that the viewer sees.
pub struct Start {
    pub arriving: DVec3,
    pub hit: Hit,
    pub side: DVec3,
}

impl Start {
    /// Two tangents and the normal on the seen side.
    pub fn frame(&self) -> (DVec3, DVec3, DVec3) {
        let (x, y) = basis(self.side);
        (x, y, self.side)
    }
}

/// A light as seen from any start: in the frame of the normal on the seen side, in sizes of the body.
pub struct Lamp {
    from: DVec3,
    pub truth: Truth,
}

/// Lamps 4 to 400 sizes away, above and below in turn. Of the sines of their height over the tangent plane every other
/// pair is uniform, the rest uniform on a logarithm, both down to where the truth is certain, `least(truth)`.
pub fn lamps(seed: u64, count: u32, least: impl Fn(Truth) -> f64) -> Vec<Lamp> {
    let lamp = |i: u32| {
        let mut sampler = Sampler::new(seed, u64::MAX, i);
        let truth = if i.is_multiple_of(2) { Truth::Lit } else { Truth::Dark };
        let (u, least) = (sampler.next_2d(), least(truth));
        let height = if i & 2 == 0 { least.powf(u.x) } else { least + (1.0 - least) * u.x };
        let (sin, cos) = (TAU * u.y).sin_cos();
        let flat = ((1.0 - height) * (1.0 + height)).max(0.0).sqrt();
        let up = if truth == Truth::Lit { height } else { -height };
        Lamp { from: dvec3(flat * cos, flat * sin, up) * (4.0 * 100f64.powf(sampler.next_1d())), truth }
    };
    (0..count).map(lamp).collect()
}

impl Lamp {
    /// From a point of a surface with this frame, in sizes.
    #[inline]
    pub fn way(&self, (x, y, normal): (DVec3, DVec3, DVec3)) -> DVec3 {
        x * self.from.x + y * self.from.y + normal * self.from.z
    }
}

/// All bodies of one `size` [m], `distance` sizes from the world's origin.
pub fn bodies(size: f64, distance: f64) -> Result<Vec<Body>, ShapeError> {
    let center = AWAY * (size * distance);
    let at = |x: f64, y: f64, z: f64| center + dvec3(x, y, z) * size;
    let turned = DMat3::from_rotation_x(0.7) * DMat3::from_rotation_y(0.4);
    let (axis, flat) = (turned.z_axis, dvec3(0.36, -0.48, 0.8));
    let torus = Torus::new(0.75 * size, 0.25 * size)?;
    let torus = Instance::new(Box::new(torus), DAffine3::from_mat3_translation(turned, center))?;
    let ends = [center - axis * (0.9 * size), center + axis * (0.9 * size)];
    let body = |shape: Box<dyn Shape>, is_closed, admits| Body { shape, is_closed, size, center, admits };
    Ok(vec![
        body(Box::new(Sphere::new(center, size)?), true, |_| true),
        body(Box::new(Cuboid::new(at(-1.0, -0.7, -0.8), at(1.0, 0.7, 0.8))?), true, |h| {
            h.uv.min_element() > 0.1 && h.uv.max_element() < 0.9
        }),
        body(Box::new(Plane::new(center, flat)?), false, |_| true),
        body(Box::new(Disc::new(center, flat, size)?), false, |h| h.uv.y < 0.9),
        body(Box::new(Cylinder::new(ends[0], ends[1], 0.6 * size)?), true, off_the_rim),
        body(Box::new(Cone::new(ends[0], ends[1], 0.9 * size, 0.0)?), true, off_the_rim),
        // The outer half of the tube: there a torus lies behind its tangent planes.
        body(Box::new(torus), true, |h| (h.uv.y * TAU).cos() > 0.2),
        body(
            Box::new(Triangle::new(at(-1.0, -0.6, 0.1), at(0.9, -0.7, -0.2), at(0.1, 0.9, 0.3))?),
            false,
            |h| h.uv.min_element() > 0.1 && h.uv.element_sum() < 0.9,
        ),
    ])
}

/// Of cylinders and cones: inside the caps' rims, between the ends of the side.
fn off_the_rim(hit: &Hit) -> bool {
    hit.uv.y < 0.9 && (hit.face > 0 || hit.uv.y > 0.1)
}

/// What rounding may move of a body `distance` sizes away, in sizes: coordinates of magnitude `1 + distance` that pass
/// fewer than 256 roundings before a shadow ray is answered, the worst of them an instance's way to its own space and back.
pub fn doubt(distance: f64) -> f64 {
    256.0 * U * (1.0 + distance)
}

/// Sine of the angle to the tangent plane from which on the truth is certain. In sizes, no radius of curvature is below ¼
/// but a cone's 0.09 near its tip.
///
/// - Above: the plane's place is known to `doubt`, its tilt to four times that (curvature), the light's direction to
///   `doubt`: together less than 8.
/// - Below: a start raised by `h` sees over the horizon by √(2h/0.09); no way that rounding asks for raises it by more
///   than `doubt/5`, and a scene whose coordinates round otherwise may well show that light. Beyond 4 √doubt none does.
pub fn certain(distance: f64, truth: Truth) -> f64 {
    match truth {
        Truth::Lit => 8.0 * doubt(distance),
        Truth::Dark => 4.0 * doubt(distance).sqrt(),
    }
}

impl Body {
    /// A place on the body that a ray from anywhere round it finds; `None` if it misses, or finds an edge.
    pub fn start(&self, sampler: &mut Sampler) -> Option<Start> {
        let from = self.center + uniform_sphere(sampler.next_2d()) * (4.0 * self.size);
        let near = uniform_sphere(sampler.next_2d()) * (0.6 * self.size * sampler.next_1d().sqrt());
        let ray = Ray::new(from, self.center + near - from);
        let hit = self.shape.hit(&ray, &self.shape.nearest(&ray, 0.0, f64::INFINITY)?);
        let side = if ray.direction.dot(hit.ng) > 0.0 { -hit.ng } else { hit.ng };
        (self.admits)(&hit).then_some(Start { arriving: ray.direction, hit, side })
    }
}
