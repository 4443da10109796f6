//! Local illumination: what the lights send to the first surface, and nothing else [C §1.7–1.8, D §5.9.4].
//!
//! ```text
//! L = emissive + ρ (ambient + Σ_lights E cos θ V / π)
//! ```
//!
//! `E` is the irradiance of a facing surface (see [`crate::light`]), `V` is 1 where nothing stands between.
//! An area light is the mean over its points, or rather over one ray to each of its cells.

use super::Integrator;
use crate::color::Rgb;
use crate::light::{AreaLight, Falloff, Light, Placement, PointLight};
use crate::ray::{Hit, Ray, RayKind, Trace, Work};
use crate::sample::Sampler;
use crate::scene::{Material, Met, Scene};
use crate::shape::Shape;
use crate::shape::fan::{Ends, Fan, LANES, Lanes, Vectors, vectorised};
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_1_PI, PI};

/// How far local illumination goes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stage {
    /// The nearest surface in its own colour: which object is seen, and no light [B fig. 7.1].
    Visibility,
    /// Lambert and ambient light, as if surfaces threw no shadows.
    Unshadowed,
    /// Shadows too: hard ones of points, soft ones of areas.
    #[default]
    Shadowed,
}

/// Local illumination.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Local {
    pub stage: Stage,
    /// Which instructions shadow rays may use; the picture is the same.
    pub vectors: Vectors,
}

/// Memory for the rays to an area light.
#[derive(Debug)]
pub struct Scratch {
    fan: Fan,
    /// The points of each light; those of a fixed grid are the same for every place that is lit.
    ends: Vec<Ends>,
    /// Irradiance per unit of the light's power that each ray would bring.
    weights: Vec<f64>,
}

impl Integrator for Local {
    type Scratch = Scratch;

    fn scratch(&self, scene: &Scene) -> Scratch {
        let ends = |light: &Light| match light {
            Light::Point(_) => Ends::default(),
            Light::Area(light) => {
                let mut ends = Ends::within(light.center, (light.half_width + light.half_height).length());
                ends.place((0..light.cells()).map(|cell| light.point(cell, DVec2::splat(0.5))));
                ends
            }
        };
        Scratch {
            fan: Fan::new(self.vectors),
            ends: scene.lights.iter().map(ends).collect(),
            weights: Vec::new(),
        }
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
            Some(Met::Light(i, _)) => match &scene.lights[i] {
                Light::Area(light) => light.radiance_towards(ray.direction).unwrap_or(Rgb::ZERO),
                Light::Point(_) => Rgb::ZERO,
            },
            Some(Met::Object(i, crossing)) => {
                let hit = scene.hit(ray, i, &crossing);
                trace.hit(i, &hit);
                let material = &scene.materials[scene.objects[i].material(hit.part)];
                match self.stage {
                    Stage::Visibility => material.diffuse,
                    stage => {
                        let mut lighting = Lighting { stage, scene, sampler, scratch, trace };
                        lighting.leaving(ray, &hit, scene.objects[i].shape(), material)
                    }
                }
            }
        };
        trace.leave(radiance);
        radiance
    }
}

/// Everything at hand where one hit is lit.
struct Lighting<'a, T> {
    stage: Stage,
    scene: &'a Scene,
    sampler: &'a mut Sampler,
    scratch: &'a mut Scratch,
    trace: &'a mut T,
}

impl<T: Trace> Lighting<'_, T> {
    /// Radiance that leaves the hit towards the ray's origin.
    fn leaving(&mut self, ray: &Ray, hit: &Hit, shape: &dyn Shape, material: &Material) -> Rgb {
        let side = if ray.direction.dot(hit.ng) > 0.0 { -1.0 } else { 1.0 };
        let n = hit.n * side;
        let lifted = Hit { point: shape.lifted(hit, n), ..*hit };
        // A smooth normal may lean over the facet's horizon: the facet says which side is seen.
        let from = Place { origin: lifted.origin_towards(hit.ng * side), n, weight: material.diffuse };
        let mut irradiance = Rgb::ZERO;
        for (i, light) in self.scene.lights.iter().enumerate() {
            irradiance += match light {
                Light::Point(light) => self.point_irradiance(light, &from),
                Light::Area(light) => self.area_irradiance(i, light, &from),
            };
        }
        material.emissive + material.diffuse * (self.scene.ambient + irradiance * FRAC_1_PI)
    }

    fn point_irradiance(&mut self, light: &PointLight, from: &Place) -> Rgb {
        let to = light.position - from.origin;
        let distance = to.length();
        let cos_theta = from.n.dot(to) / distance;
        if !(cos_theta > 0.0) {
            return Rgb::ZERO; // the light stands behind the surface, or in the point itself
        }
        let e = light.irradiance(distance) * cos_theta;
        if self.stage == Stage::Unshadowed {
            return e;
        }
        let segment = Ray::new(from.origin, to);
        self.trace.count(Work::Ray(RayKind::Shadow), 1);
        let blocker = self.scene.blocker(&segment, 1.0, self.trace);
        report(self.trace, &segment, e * from.weight, blocker);
        if blocker.is_some() { Rgb::ZERO } else { e }
    }

    fn area_irradiance(&mut self, index: usize, light: &AreaLight, from: &Place) -> Rgb {
        let Scratch { fan, ends, weights } = &mut *self.scratch;
        let ends = &mut ends[index];
        if light.placement == Placement::Jittered {
            ends.place((0..light.cells()).map(|cell| light.point(cell, self.sampler.next_2d())));
        }
        fan.aim(from.origin, ends);
        weights.clear();
        weights.resize(fan.padded_len(), 0.0);
        match light.falloff {
            Falloff::None => flat_weights(fan.vectors, fan, from.n, weights),
            Falloff::InverseSquare => radiometric_weights(fan.vectors, fan, from.n, light.normal, weights),
        }
        weights[fan.len()..].fill(0.0);
        let lit = weights.iter().filter(|w| **w > 0.0).count();
        if lit == 0 {
            return Rgb::ZERO;
        }
        let unit = match light.falloff {
            Falloff::None => light.power * (PI / f64::from(light.cells())),
            Falloff::InverseSquare => light.power * (light.area() / f64::from(light.cells())),
        };
        if self.stage == Stage::Shadowed {
            self.trace.count(Work::Ray(RayKind::Shadow), lit as u64);
            if T::ACTIVE {
                for i in (0..fan.len()).filter(|i| weights[*i] > 0.0) {
                    let segment = Ray::new(fan.origin, fan.direction(i));
                    let blocker = self.scene.blocker(&segment, 1.0, self.trace);
                    report(self.trace, &segment, unit * weights[i] * from.weight, blocker);
                }
            }
            self.scene.shade(fan, weights, self.trace);
        }
        unit * sum(weights)
    }
}

/// A place that light falls on.
struct Place {
    /// Where shadow rays start: beyond the rounding error of the surface.
    origin: DVec3,
    /// The normal on the viewer's side.
    n: DVec3,
    /// What irradiance is multiplied by on its way to the eye, but for 1/π.
    weight: Rgb,
}

fn report<T: Trace>(trace: &mut T, segment: &Ray, brought: Rgb, blocker: Option<usize>) {
    if T::ACTIVE {
        trace.enter(RayKind::Shadow, segment, 1.0, brought * FRAC_1_PI);
        if let Some(object) = blocker {
            trace.blocked(object);
        }
        trace.leave(if blocker.is_some() { Rgb::ZERO } else { Rgb::ONE });
    }
}

vectorised! {
    /// `cos θ` of every segment, 0 for those below the horizon: D's lights.
    fn flat_weights(fan: &Fan, n: DVec3, weights: &mut [f64]) {
        for (Lanes { x, y, z }, weights) in fan.lanes().zip(weights.chunks_exact_mut(LANES)) {
            for i in 0..LANES {
                let d2 = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
                let cos = (n.x * x[i] + n.y * y[i] + n.z * z[i]) / d2.sqrt();
                weights[i] = if cos > 0.0 { cos } else { 0.0 };
            }
        }
    }
}

vectorised! {
    /// `cos θ cos θₗ / d²` of every segment, 0 for those below either horizon.
    fn radiometric_weights(fan: &Fan, n: DVec3, nl: DVec3, weights: &mut [f64]) {
        for (Lanes { x, y, z }, weights) in fan.lanes().zip(weights.chunks_exact_mut(LANES)) {
            for i in 0..LANES {
                let d2 = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
                let cos = n.x * x[i] + n.y * y[i] + n.z * z[i];
                let cos_light = -(nl.x * x[i] + nl.y * y[i] + nl.z * z[i]);
                let weight = cos * cos_light / (d2 * d2);
                weights[i] = if (cos > 0.0) & (cos_light > 0.0) { weight } else { 0.0 };
            }
        }
    }
}

/// Sums lane by lane, then across: the same order in every instruction set.
fn sum(weights: &[f64]) -> f64 {
    let mut lanes = [0.0; LANES];
    for eight in weights.chunks_exact(LANES) {
        for (lane, w) in lanes.iter_mut().zip(eight) {
            *lane += w;
        }
    }
    lanes.iter().sum()
}
