//! Local illumination: what the lights send to the first surface, and nothing else [C §1.7–1.8, D §5.9.4].
//!
//! ```text
//! L = emissive + ρ ambient + Σ_lights f E cos θ V,    f = ρ/π of a matt surface
//! ```
//!
//! `E` is the irradiance of a facing surface (see [`crate::light`]), `f` the reflection model ([`crate::bsdf`]), `V` is 1 where
//! nothing stands between. An area light is the mean over its points, one ray to each.

mod area;
mod place;

use super::Integrator;
use crate::color::Rgb;
use crate::light::Light;
use crate::ray::{Ray, RayKind, Trace, Work};
use crate::sample::{Cell, Sampler};
use crate::scene::{Met, Scene};
use crate::shape::fan::{Ends, Fan, Vectors};
use place::Place;

/// How far local illumination goes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stage {
    /// The nearest surface in its own colour: which object is seen, and no light [B fig. 7.1].
    Visibility,
    /// Reflection and ambient light, as if surfaces threw no shadows.
    Unshadowed,
    /// Shadows too: hard ones of points, soft ones of areas.
    #[default]
    Shadowed,
}

/// What is kept from one shadow ray to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Memory {
    Nothing,
    /// The object that last stood before a light without size: it is asked first, for what hid the light from one place
    /// mostly hides it from the next. Where the light is seen it is forgotten, so that it is asked in vain only where a
    /// shadow ends; that costs less than it saves unless blockers are narrower than the distance of neighbouring rays
    /// (lesson 17). The picture is the same.
    #[default]
    LastBlocker,
}

/// Local illumination.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Local {
    pub stage: Stage,
    pub memory: Memory,
    /// Which instructions shadow rays may use; the picture is the same.
    pub vectors: Vectors,
}

/// Memory for the rays to lights.
#[derive(Debug)]
pub struct Scratch {
    fan: Fan,
    lights: Vec<LightScratch>,
    /// What each ray of the fan would bring, in units of [`AreaLight::share`](crate::light::AreaLight::share).
    weights: Vec<f64>,
}

/// The same for one light.
#[derive(Debug, Default)]
struct LightScratch {
    /// The points of an area light; those of a fixed grid are the same for every place that is lit.
    ends: Ends,
    /// The cells in which they lie, if they are jittered.
    cells: Vec<Cell>,
    /// The object that stood before the light last.
    blocker: Option<usize>,
}

impl LightScratch {
    fn new(light: &Light) -> Self {
        let Light::Area(light) = light else { return LightScratch::default() };
        let (center, radius) = light.emitter.ball();
        let mut ends = Ends::within(center, radius);
        if light.is_fixed() {
            ends.place(light.cells().iter().map(|cell| light.emitter.point(cell.center())));
        }
        LightScratch { ends, cells: light.jittered_cells(), blocker: None }
    }
}

impl Integrator for Local {
    type Scratch = Scratch;

    fn scratch(&self, scene: &Scene) -> Scratch {
        let lights = scene.lights.iter().map(LightScratch::new).collect();
        Scratch { fan: Fan::new(self.vectors), lights, weights: Vec::new() }
    }

    fn radiance<T: Trace>(
        &self,
        scene: &Scene,
        ray: &Ray,
        sampler: &mut Sampler,
        scratch: &mut Scratch,
        trace: &mut T,
    ) -> Rgb {
        trace.count(Work::Ray(RayKind::Camera), 1);
        trace.enter(RayKind::Camera, ray, f64::INFINITY, Rgb::ONE);
        let radiance = match scene.first_met(ray, trace) {
            None => scene.background,
            Some(Met::Light(_, radiance)) => radiance,
            Some(Met::Object(i, crossing)) => {
                let hit = scene.hit(ray, i, &crossing);
                trace.hit(i, &hit);
                let object = &scene.objects[i];
                let material = &scene.materials[object.material(hit.part)];
                if self.stage == Stage::Visibility {
                    material.diffuse
                } else {
                    let place = Place::new(ray, &hit, object.shape(), material);
                    let mut lighting = Lighting { local: *self, scene, sampler, scratch, trace };
                    material.emissive + material.diffuse * scene.ambient + lighting.reflected(&place)
                }
            }
        };
        trace.leave(radiance);
        radiance
    }
}

/// Everything at hand where one place is lit.
struct Lighting<'a, T> {
    local: Local,
    scene: &'a Scene,
    sampler: &'a mut Sampler,
    scratch: &'a mut Scratch,
    trace: &'a mut T,
}

impl<T: Trace> Lighting<'_, T> {
    /// Radiance that the place reflects towards the ray's origin.
    fn reflected(&mut self, place: &Place) -> Rgb {
        let mut sum = Rgb::ZERO;
        for (i, light) in self.scene.lights.iter().enumerate() {
            sum += match light {
                Light::Area(light) => self.lit_by_area(i, light, place),
                _ => self.lit_by_sharp(i, light, place),
            };
        }
        sum
    }

    /// From a light without size.
    fn lit_by_sharp(&mut self, index: usize, light: &Light, place: &Place) -> Rgb {
        let Some(arrival) = light.arriving(place.origin) else { return Rgb::ZERO };
        let cos_theta = place.n.dot(arrival.wi);
        if !(cos_theta > 0.0) {
            return Rgb::ZERO; // the light stands behind the surface, or in the point itself
        }
        let brought = place.f(arrival.wi) * arrival.irradiance * cos_theta;
        if self.local.stage == Stage::Unshadowed || brought == Rgb::ZERO {
            return brought;
        }
        let segment = Ray::new(place.origin, arrival.to);
        self.trace.count(Work::Ray(RayKind::Shadow), 1);
        let blocker = self.blocker(index, &segment, arrival.t_max);
        report(self.trace, &segment, arrival.t_max, brought, blocker);
        if blocker.is_some() { Rgb::ZERO } else { brought }
    }

    /// What stands before a light: the last that did, or whatever the scene finds.
    fn blocker(&mut self, light: usize, segment: &Ray, t_max: f64) -> Option<usize> {
        let last = &mut self.scratch.lights[light].blocker;
        if self.local.memory == Memory::Nothing || T::ACTIVE {
            return self.scene.blocker(segment, t_max, self.trace); // a listener is told the first by order
        }
        if let Some(i) = *last
            && self.scene.objects[i].blocks(segment, t_max, self.trace)
        {
            return *last;
        }
        *last = self.scene.blocker(segment, t_max, self.trace);
        *last
    }
}

fn report<T: Trace>(trace: &mut T, segment: &Ray, t_max: f64, brought: Rgb, blocker: Option<usize>) {
    if T::ACTIVE {
        trace.enter(RayKind::Shadow, segment, t_max, brought);
        if let Some(object) = blocker {
            trace.blocked(object);
        }
        trace.leave(if blocker.is_some() { Rgb::ZERO } else { Rgb::ONE });
    }
}
