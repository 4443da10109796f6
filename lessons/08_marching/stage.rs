//! A still life of shapes that have both a formula and a distance.

use glam::{DAffine3, DMat3, DVec2, DVec3, dvec3};
use lightbench::ray::Ray;
use lightbench::scene::{Camera, FieldOfView};
use lightbench::sdf::combine::Union;
use lightbench::sdf::placed::Placed;
use lightbench::shape::Shape;
use lightbench::shape::cone::Cone;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::cylinder::Cylinder;
use lightbench::shape::instance::Instance;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::torus::Torus;

/// Where the stage stands if nothing is said.
pub const HOME: DVec3 = DVec3::ZERO;
/// Height of the floor.
pub const FLOOR: f64 = -1.05; // m
/// Eyes, from the stage's middle [m].
pub const FROM_ABOVE: DVec3 = DVec3::new(0.9, 1.5, 5.0);
pub const FROM_THE_FLOOR: DVec3 = DVec3::new(0.9, FLOOR + 0.02, 5.0);

/// Angle of view, from the bottom of a picture to its top [rad].
pub const ANGLE: f64 = 0.62;

/// All of it as one field.
pub type Field = Union<Union<Union<Sphere, Cuboid>, Union<Placed<Torus>, Cylinder>>, Union<Cone, Cuboid>>;

pub struct Stage {
    pub field: Field,
    shapes: Vec<Box<dyn Shape>>,
    at: DVec3,
}

impl Stage {
    /// The stage about a place.
    pub fn new(at: DVec3) -> Self {
        let p = |x, y, z| at + dvec3(x, y, z);
        let sphere = Sphere::new(p(-1.7, FLOOR + 0.6, 0.2), 0.6).expect("a radius");
        let cube = Cuboid::new(p(1.15, FLOOR, -0.7), p(2.1, 0.1, 0.3)).expect("a box");
        let floor = Cuboid::new(p(-5.0, FLOOR - 0.4, -5.0), p(5.0, FLOOR, 5.0)).expect("a box");
        let cylinder = Cylinder::new(p(0.6, FLOOR, 1.3), p(0.6, -0.45, 1.3), 0.35).expect("a radius");
        let cone = Cone::new(p(-0.65, FLOOR, 1.3), p(-0.65, -0.05, 1.3), 0.42, 0.0).expect("radii");
        let torus = Torus::new(0.8, 0.25).expect("a ring");
        let ring = Placed::new(torus, DMat3::IDENTITY, 1.0, at).expect("a shift");
        let moved = Instance::new(Box::new(torus), DAffine3::from_translation(at)).expect("a shift");
        let shapes: Vec<Box<dyn Shape>> = vec![
            Box::new(sphere),
            Box::new(cube),
            Box::new(moved),
            Box::new(cylinder),
            Box::new(cone),
            Box::new(floor),
        ];
        let field = Union(Union(Union(sphere, cube), Union(ring, cylinder)), Union(cone, floor));
        Stage { field, shapes, at }
    }

    /// Rays of a picture three by two, `width` pixels across, row by row.
    pub fn view(&self, width: usize, from: DVec3) -> Vec<Ray> {
        let (eye, target) = (self.at + from, self.at + dvec3(0.1, from.y.min(-0.5), 0.0));
        let field = FieldOfView::Vertical(ANGLE);
        let camera = Camera::new(eye, target, DVec3::Y, field).expect("an eye and another point");
        picture(&camera, width)
    }

    /// Distance to the first surface by formula.
    pub fn by_formula(&self, ray: &Ray) -> Option<f64> {
        self.shapes.iter().fold(None, |near: Option<f64>, shape| {
            let t = shape.nearest(ray, 0.0, near.unwrap_or(super::FAR)).map(|c| c.t);
            t.or(near)
        })
    }
}

/// Camera rays of a picture three by two.
pub fn picture(camera: &Camera, width: usize) -> Vec<Ray> {
    let height = width * 2 / 3;
    let raster = |i: usize| DVec2::new((i % width) as f64 + 0.5, (i / width) as f64 + 0.5);
    (0..width * height).map(|i| camera.ray(raster(i), width, height)).collect()
}
