//! A scene: camera, objects with their materials, lights, background.

mod camera;
pub mod pinhole;

pub use camera::{
    Camera, CameraError, FieldOfView, camera_from_screen, ndc_from_raster, obscura_from_camera,
    screen_from_ndc,
};

use crate::bounds::Aabb;
use crate::color::Rgb;
use crate::light::Light;
use crate::ray::{Crossing, Hit, Ray, Trace, Work};
use crate::shape::Shape;
use crate::shape::fan::Fan;
use glam::DVec3;

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

/// A shape made of a material, or of several by its parts.
#[derive(Debug)]
pub struct Object {
    /// What messages call it: `Sphere` and where it was declared, or the name a lesson gives it.
    pub name: String,
    /// Of each part, an index into [`Scene::materials`]; if there is one only, it is that of all parts.
    materials: Vec<usize>,
    shape: Box<dyn Shape>,
    bounds: Aabb,
    /// Does a ray look at the bounds before it is tested against the shape?
    guarded: bool,
}

impl Object {
    /// An object of one material, by its index in [`Scene::materials`].
    pub fn new(name: impl Into<String>, shape: Box<dyn Shape>, material: usize) -> Self {
        Self::of_parts(name, shape, vec![material])
    }

    /// An object whose parts, the leaves of a tree, each have their own material.
    pub fn of_parts(name: impl Into<String>, shape: Box<dyn Shape>, materials: Vec<usize>) -> Self {
        assert!(!materials.is_empty(), "an object without a material");
        let bounds = shape.bounds();
        let guarded = shape.is_costly() && bounds.is_finite();
        Object { name: name.into(), materials, shape, bounds, guarded }
    }

    /// The material where a ray met it, by [`Hit::part`], as an index into [`Scene::materials`].
    #[inline]
    pub fn material(&self, part: u32) -> usize {
        let one = self.materials[0];
        if part == 0 { one } else { self.materials.get(part as usize).copied().unwrap_or(one) }
    }

    /// Does the ray certainly miss the object? `inv_direction` is `1/d`.
    #[inline]
    fn is_passed_by(&self, ray: &Ray, inv_direction: DVec3, t_max: f64) -> bool {
        self.guarded && self.bounds.slab(ray.origin, inv_direction, 0.0, t_max).is_none()
    }

    pub fn shape(&self) -> &dyn Shape {
        &*self.shape
    }

    pub fn bounds(&self) -> &Aabb {
        &self.bounds
    }
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

/// What a ray meets first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Met {
    /// An object, by its index.
    Object(usize, Crossing),
    /// A shining rectangle, by the light's index.
    Light(usize, f64),
}

impl Scene {
    /// A scene of nothing but a camera.
    pub fn new(camera: Camera) -> Self {
        Scene {
            camera,
            materials: Vec::new(),
            objects: Vec::new(),
            lights: Vec::new(),
            background: Rgb::ZERO,
            ambient: Rgb::ZERO,
        }
    }

    /// The nearest object along a ray with `0 < t < t_max`.
    #[inline]
    pub fn nearest<T: Trace>(&self, ray: &Ray, mut t_max: f64, trace: &mut T) -> Option<(usize, Crossing)> {
        let inv_direction = ray.direction.recip();
        let mut nearest = None;
        let mut tests = 0;
        for (i, object) in self.objects.iter().enumerate() {
            if object.is_passed_by(ray, inv_direction, t_max) {
                continue;
            }
            tests += 1;
            if let Some(crossing) = object.shape.nearest(ray, 0.0, t_max) {
                t_max = crossing.t;
                nearest = Some((i, crossing));
            }
        }
        trace.count(Work::ShapeTest, tests);
        nearest
    }

    /// What a camera or reflected ray meets: objects, and the rectangles of area lights, which shadow
    /// rays pass through [D §5.9.3].
    pub fn first_met<T: Trace>(&self, ray: &Ray, trace: &mut T) -> Option<Met> {
        let object = self.nearest(ray, f64::INFINITY, trace);
        let t_object = object.map_or(f64::INFINITY, |(_, c)| c.t);
        let shining = |(i, light): (usize, &Light)| match light {
            Light::Area(area) if area.radiance_towards(ray.direction).is_some() => {
                Some((i, area.crossing(ray)?))
            }
            _ => None,
        };
        let lights = self.lights.iter().enumerate().filter_map(shining).filter(|(_, t)| *t < t_object);
        match lights.min_by(|a, b| a.1.total_cmp(&b.1)) {
            Some((i, t)) => Some(Met::Light(i, t)),
            None => object.map(|(i, crossing)| Met::Object(i, crossing)),
        }
    }

    /// Details of a crossing that [`Scene::nearest`] found.
    pub fn hit(&self, ray: &Ray, object: usize, crossing: &Crossing) -> Hit {
        self.objects[object].shape.hit(ray, crossing)
    }

    /// The first object, in order of declaration, that stands between the ends of a segment: `0 < t < t_max`.
    pub fn blocker<T: Trace>(&self, segment: &Ray, t_max: f64, trace: &mut T) -> Option<usize> {
        let inv_direction = segment.direction.recip();
        let mut tests = 0;
        let blocker = self.objects.iter().position(|object| {
            if object.is_passed_by(segment, inv_direction, t_max) {
                return false;
            }
            tests += 1;
            object.shape.blocks(segment, t_max)
        });
        trace.count(Work::ShapeTest, tests);
        blocker
    }

    /// Puts 0 into `lit[i]` for every segment of the fan that something stands in the way of.
    pub fn shade<T: Trace>(&self, fan: &Fan, lit: &mut [f64], trace: &mut T) {
        for object in &self.objects {
            if object.bounds.overlaps(&fan.hull) && object.shape.may_block(fan) {
                trace.count(Work::ShapeTest, fan.len() as u64);
                object.shape.shade(fan, lit);
            }
        }
    }
}
