//! The studio in which the lessons' pictures are taken: one ground, one set of lights, one lens for all of them.
//!
//! A warm off-white [`Cove`] without a horizon; a large soft key light at 45° on the left, a weak cool fill on the right, a rim
//! light behind, a faint ceiling over all; the camera at 20° above with a lens of 50 mm. There is no ambient light: whatever
//! touches the ground darkens it. Lengths are measured in radii of the subject, so that every subject gets the same picture.
//!
//! ```
//! use glam::DVec3;
//! use lightbench::shape::sphere::Sphere;
//! use lightbench_kit::stage::{RenderSize, Stage, colour, material};
//! let ball = Sphere::new(DVec3::Y, 1.0).expect("a sphere of literal numbers");
//! let stage = Stage::new(DVec3::Y, 1.0).with(ball, material::glossy(colour::CLAY, 0.3));
//! let image = stage.render(&RenderSize { width: 48, height: 30, cells: 1, seed: 0 });
//! assert_eq!(image.width(), 48);
//! ```

mod lights;
pub mod material;
mod size;

pub use crate::render::shade;
pub use material::colour;
pub use size::RenderSize;

use crate::color::Rgb;
use crate::film::{Image, tone};
use crate::ray::Ray;
use crate::render::render_local;
use crate::scene::{Camera, FieldOfView, Material, Object, Scene};
use crate::shape::Shape;
use crate::shape::cove::Cove;
use glam::DVec3;
use lightbench::integrator::Local;
use std::sync::Arc;

/// Radiance of the brightest diffuse surface.
pub const BRIGHTEST: f64 = 0.8;
/// Half a side of the film over the lens's focal length: 50 mm before 36 × 24 mm.
const SLOPE: [f64; 2] = [18.0 / 50.0, 12.0 / 50.0];
/// Where in the picture the subject's centre stands, in shares of its width and height from the upper left.
const AT: [f64; 2] = [0.43, 0.47];
/// Wall behind the subject's centre, and the radius of its joint with the ground \[subject radii\].
const WALL: f64 = 9.0;
const JOINT: f64 = 7.0;

/// A subject in the studio, with whatever stands beside it.
#[derive(Clone, Debug)]
pub struct Stage {
    center: DVec3,
    radius: f64,
    ground: f64,
    ground_material: Material,
    azimuth: f64,
    elevation: f64,
    portion: f64,
    objects: Vec<(Arc<dyn Shape>, Vec<usize>)>,
    materials: Vec<Material>,
}

impl Stage {
    /// An empty studio for a subject in the ball about `center`, which stands on the ground.
    ///
    /// # Panics
    /// If the numbers are not finite, or the radius is not positive: they are literals of a lesson.
    pub fn new(center: DVec3, radius: f64) -> Self {
        assert!(
            center.is_finite() && radius > 0.0 && radius.is_finite(),
            "subject of {radius} m at {center}"
        );
        Stage {
            center,
            radius,
            ground: center.y - radius,
            ground_material: material::diffuse(colour::PAPER),
            azimuth: 0.0,
            elevation: 20.0,
            portion: 0.62,
            objects: Vec::new(),
            materials: Vec::new(),
        }
    }

    /// Adds an object: the subject, or what stands beside it.
    pub fn with(self, shape: impl Shape + 'static, material: Material) -> Self {
        self.with_parts(Arc::new(shape), vec![material])
    }

    /// Adds an object whose parts, the leaves of a tree, each have their own material.
    ///
    /// # Panics
    /// If there is no material.
    pub fn with_parts(mut self, shape: Arc<dyn Shape>, materials: Vec<Material>) -> Self {
        assert!(!materials.is_empty(), "an object without a material");
        let first = self.materials.len();
        self.materials.extend(materials);
        self.objects.push((shape, (first..self.materials.len()).collect()));
        self
    }

    /// The height of the ground, if the subject does not touch it with its ball, or floats over it.
    pub fn ground(self, height: f64) -> Self {
        Stage { ground: height, ..self }
    }

    /// A ground of another material.
    pub fn ground_of(self, material: Material) -> Self {
        Stage { ground_material: material, ..self }
    }

    /// Turns camera, lights and wall together about the subject, counter-clockwise from above \[degrees\]; at 0 the camera
    /// stands along z.
    pub fn seen_from(self, azimuth: f64) -> Self {
        Stage { azimuth, ..self }
    }

    /// The camera's height over the subject \[degrees, at most 80\]: 20 unless told otherwise.
    pub fn seen_from_above(self, elevation: f64) -> Self {
        assert!((0.0..=80.0).contains(&elevation), "a camera {elevation}° above the subject");
        Stage { elevation, ..self }
    }

    /// The fraction of the picture's height that the subject's ball takes: 0.62 unless told otherwise.
    pub fn filling(self, portion: f64) -> Self {
        assert!(portion > 0.0 && portion <= 1.0, "a subject that fills {portion} of the picture");
        Stage { portion, ..self }
    }

    /// The scene for a picture of this size, its light scaled so that the brightest diffuse surface shows [`BRIGHTEST`]: of
    /// a ball of [`colour::PAPER`] in the subject's place and of the ground round it, with nothing else in the way.
    ///
    /// Material 0 and object 0 are the ground; the others follow in the order in which they were added.
    pub fn scene(&self, size: &RenderSize) -> Scene {
        let mut scene = Scene::new(self.camera(size));
        scene.lights = lights::lights(self, size);
        scene.materials.push(self.ground_material.clone());
        scene.materials.extend(self.materials.iter().cloned());
        scene.objects.push(Object::new("ground", Box::new(self.cove()), 0));
        for (shape, materials) in &self.objects {
            let materials = materials.iter().map(|m| m + 1).collect();
            scene.objects.push(Object::of_parts("object", Box::new(shape.clone()), materials));
        }
        scene
    }

    /// The picture, its highlights rolled off by [`tone::shoulder`].
    pub fn render(&self, size: &RenderSize) -> Image {
        developed(&self.radiance(size))
    }

    /// The picture before its highlights are rolled off: what errors are measured on.
    pub fn radiance(&self, size: &RenderSize) -> Image {
        render_local(&self.scene(size), &Local::default(), size.picture()).image
    }

    /// The same picture, each camera ray bringing what the closure says; see [`shade`].
    pub fn shade(&self, size: &RenderSize, radiance: impl Fn(&Ray, &Scene) -> Rgb + Sync) -> Image {
        developed(&shade(&self.scene(size), size.picture(), radiance))
    }

    /// Right, up, and from the subject towards the camera's side, level.
    fn frame(&self) -> [DVec3; 3] {
        let (sin, cos) = self.azimuth.to_radians().sin_cos();
        [DVec3::new(cos, 0.0, -sin), DVec3::Y, DVec3::new(sin, 0.0, cos)]
    }

    /// A point by its coordinates in [`Stage::frame`] from the subject's foot \[subject radii\].
    fn at(&self, right: f64, up: f64, front: f64) -> DVec3 {
        let [x, y, z] = self.frame();
        DVec3 { y: self.ground, ..self.center } + (x * right + y * up + z * front) * self.radius
    }

    /// A picture narrower than the film is a cut from its middle.
    fn slopes(&self, size: &RenderSize) -> [f64; 2] {
        let aspect = size.width as f64 / size.height.max(1) as f64;
        let across = SLOPE[0].min(SLOPE[1] * aspect);
        [across, across / aspect]
    }

    /// ```text
    /// r/d = sin atan(portion · slope):    the ball's outline is a cone about its centre, at the distance d
    /// ```
    fn camera(&self, size: &RenderSize) -> Camera {
        let [across, up] = self.slopes(size);
        let distance = self.radius / (self.portion * up).atan().sin();
        let ([right, _, front], (sin, cos)) = (self.frame(), self.elevation.to_radians().sin_cos());
        let back = front * cos + DVec3::Y * sin;
        let eye = self.center + back * distance;
        let shift = right * ((1.0 - 2.0 * AT[0]) * across) - right.cross(-back) * ((1.0 - 2.0 * AT[1]) * up);
        let view = FieldOfView::Vertical(2.0 * up.atan());
        Camera::new(eye, self.center + shift * distance, DVec3::Y, view).expect("a camera in its place")
    }

    fn cove(&self) -> Cove {
        let corner = self.at(0.0, 0.0, -WALL);
        Cove::new(corner, DVec3::Y, self.frame()[2], JOINT * self.radius).expect("a cove of positive radius")
    }
}

/// A picture as it is shown.
pub fn developed(radiance: &Image) -> Image {
    radiance.map(|p: Rgb| p.map(tone::shoulder))
}
