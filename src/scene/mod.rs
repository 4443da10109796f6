//! A scene: camera, objects with their materials, lights, background.

mod camera;

pub use camera::{Camera, CameraError, FieldOfView};

use crate::color::Rgb;
use crate::light::Light;
use crate::shape::Shape;

/// How a surface looks. The parameters and defaults of [D §4.6].
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    pub name: String,
    /// Share of the light that a matt surface sends back, per channel.
    pub diffuse: Rgb,
    pub specular: Rgb,
    /// Radiance the surface sends out by itself.
    pub emissive: Rgb,
    /// 0 polished … 1 rough.
    pub roughness: f64,
    /// 0 clear … 1 opaque.
    pub opacity: f64,
    /// Absolute index of refraction.
    pub ior: f64,
    /// Half angle [rad] of the cone of reflected rays.
    pub reflection_angle: f64,
    /// Share of `specular` that is mirrored.
    pub reflection_amount: f64,
}

impl Default for Material {
    fn default() -> Self {
        Material {
            name: String::new(),
            diffuse: Rgb::splat(0.9),
            specular: Rgb::splat(0.8),
            emissive: Rgb::ZERO,
            roughness: 0.5,
            opacity: 1.0,
            ior: 1.0,
            reflection_angle: 0.0,
            reflection_amount: 0.0,
        }
    }
}

/// A shape made of a material.
#[derive(Debug)]
pub struct Object {
    /// What messages call it: `Sphere` and where it was declared, or the name a lesson gives it.
    pub name: String,
    pub shape: Box<dyn Shape>,
    /// Index into [`Scene::materials`].
    pub material: usize,
}

/// Everything a ray can meet.
#[derive(Debug)]
pub struct Scene {
    pub camera: Camera,
    pub materials: Vec<Material>,
    pub objects: Vec<Object>,
    pub lights: Vec<Light>,
    /// Radiance where a ray meets nothing.
    pub background: Rgb,
    /// Ambient light: radiance that every matt surface sees from everywhere [C §1.8].
    pub ambient: Rgb,
}
