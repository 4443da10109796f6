//! A scene: camera, objects with their materials, lights, background.

mod camera;
mod objects;
pub mod pinhole;

pub use camera::{
    Camera, CameraError, FieldOfView, View, camera_from_screen, ndc_from_raster, obscura_from_camera,
    screen_from_ndc,
};

pub use objects::{Object, Objects};

use crate::bsdf::Lobes;
use crate::color::Rgb;
use crate::light::Light;
use crate::ray::{Crossing, Hit, Ray, Trace};
use crate::shape::fan::Fan;

/// How a surface looks. The parameters and defaults of [D §4.6].
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    pub name: String,
    /// Share of the light that a matt surface sends back, per channel; of ambient light, any surface.
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
    /// Half angle \[rad\] of the cone of reflected rays.
    pub reflection_angle: f64,
    /// Share of `specular` that is mirrored.
    pub reflection_amount: f64,
    /// How the light of lamps is reflected; without a model by Lambert's law, with reflectance `diffuse`.
    pub model: Option<Lobes>,
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
            model: None,
        }
    }
}

/// Everything a ray can meet.
#[derive(Debug)]
pub struct Scene {
    pub camera: Camera,
    pub materials: Vec<Material>,
    pub objects: Objects,
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
    /// An area light, by its index, and the radiance that it shows.
    Light(usize, Rgb),
}

impl Scene {
    /// A scene of nothing but a camera.
    pub fn new(camera: Camera) -> Self {
        Scene {
            camera,
            materials: Vec::new(),
            objects: Objects::default(),
            lights: Vec::new(),
            background: Rgb::ZERO,
            ambient: Rgb::ZERO,
        }
    }

    /// The nearest object along a ray with `0 < t < t_max`; of equally near ones the first in order of declaration.
    #[inline]
    pub fn nearest<T: Trace>(&self, ray: &Ray, t_max: f64, trace: &mut T) -> Option<(usize, Crossing)> {
        self.objects.nearest(ray, t_max, trace)
    }

    /// What a camera or reflected ray meets: objects, and the rectangles of area lights, which shadow
    /// rays pass through [D §5.9.3].
    pub fn first_met<T: Trace>(&self, ray: &Ray, trace: &mut T) -> Option<Met> {
        let object = self.nearest(ray, f64::INFINITY, trace);
        let t_object = object.map_or(f64::INFINITY, |(_, c)| c.t);
        let mut nearest: Option<(f64, Met)> = None;
        for (i, light) in self.lights.iter().enumerate() {
            let Light::Area(area) = light else { continue };
            let Some((t, radiance)) = area.met(ray) else { continue };
            if t < nearest.as_ref().map_or(t_object, |(t, _)| *t) {
                nearest = Some((t, Met::Light(i, radiance)));
            }
        }
        match nearest {
            Some((_, light)) => Some(light),
            None => object.map(|(i, crossing)| Met::Object(i, crossing)),
        }
    }

    /// Details of a crossing that [`Scene::nearest`] found.
    pub fn hit(&self, ray: &Ray, object: usize, crossing: &Crossing) -> Hit {
        self.objects[object].shape().hit(ray, crossing)
    }

    /// An object that stands between the ends of a segment: `0 < t < t_max`. An active listener is told the first in
    /// order of declaration, whatever structure the scene has.
    pub fn blocker<T: Trace>(&self, segment: &Ray, t_max: f64, trace: &mut T) -> Option<usize> {
        self.objects.blocker(segment, t_max, trace)
    }

    /// Puts 0 into `lit[i]` for every segment of the fan that something stands in the way of.
    pub fn shade<T: Trace>(&self, fan: &Fan, lit: &mut [f64], trace: &mut T) {
        self.objects.shade(fan, lit, trace);
    }
}
