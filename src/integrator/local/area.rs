//! What an area light sends to a place: one fan of shadow rays.

use super::place::Place;
use super::{LightScratch, Lighting, Scratch, Stage, report};
use crate::color::Rgb;
use crate::light::{AreaLight, Attenuation, Emission, Emitter, Measure};
use crate::num::certified::power_of_two_below;
use crate::ray::{Ray, RayKind, Trace, Work};
use crate::shape::fan::{Fan, LANES, Lanes, vectorised};
use glam::DVec3;

impl<T: Trace> Lighting<'_, T> {
    /// Radiance reflected at `place` of the light numbered `index`.
    pub(super) fn lit_by_area(&mut self, index: usize, light: &AreaLight, place: &Place) -> Rgb {
        let Scratch { fan, lights, weights } = &mut *self.scratch;
        let LightScratch { ends, cells, .. } = &mut lights[index];
        let mut solid_angle = 0.0;
        match light.measure() {
            Measure::Area if light.is_fixed() => {}
            Measure::Area => ends.place(light.squares(cells, self.sampler).map(|u| light.emitter.point(u))),
            Measure::SolidAngle => {
                if !light.emitter.faces(place.origin) {
                    return Rgb::ZERO;
                }
                let seen = light.emitter.seen_from(place.origin);
                solid_angle = seen.solid_angle();
                ends.place(light.squares(cells, self.sampler).map(|u| seen.point(u)));
            }
        }
        fan.aim(place.origin, ends);
        weights.clear();
        weights.resize(fan.padded_len(), 0.0);
        let scale = scale_of(fan);
        weigh(light, fan, place.n, scale, weights);
        weights[fan.len()..].fill(0.0);
        let lit = weights.iter().filter(|w| **w > 0.0).count();
        if lit == 0 {
            return Rgb::ZERO;
        }
        let share = light.share(solid_angle, scale);
        if self.local.stage == Stage::Shadowed {
            self.trace.count(Work::Ray(RayKind::Shadow), lit as u64);
            if T::ACTIVE {
                for i in (0..fan.len()).filter(|i| weights[*i] > 0.0) {
                    let segment = Ray::new(fan.origin, fan.direction(i));
                    let blocker = self.scene.blocker(&segment, 1.0, self.trace);
                    let f = place.f(segment.direction.normalize());
                    report(self.trace, &segment, 1.0, share * f * weights[i], blocker);
                }
            }
            self.scene.shade(fan, weights, self.trace);
        }
        match place.constant_f() {
            Some(f) => f * (share * sum(weights)),
            None => {
                let lit = (0..fan.len()).filter(|i| weights[*i] > 0.0);
                share * lit.map(|i| place.f(fan.direction(i).normalize()) * weights[i]).sum::<Rgb>()
            }
        }
    }
}

/// A power of two that brings the longest coordinate of a fan's segments near 1: `d⁴` of metres is out of range below
/// 10⁻⁷⁷ and above 10⁷⁷, and what arrives depends on no unit of length. No digit changes.
fn scale_of(fan: &Fan) -> f64 {
    let reach = (fan.hull.max - fan.hull.min).max_element();
    1.0 / power_of_two_below(reach.min(LONGEST))
}

/// `2¹⁰²²`, whose reciprocal is a normal number.
const LONGEST: f64 = 1.0 / f64::MIN_POSITIVE;

/// What each ray of the fan brings for lengths multiplied by `scale`, in units of the light's share; 0 for those below a horizon.
fn weigh(light: &AreaLight, fan: &Fan, n: DVec3, scale: f64, weights: &mut [f64]) {
    let vectors = fan.vectors;
    match (light.emission, light.measure()) {
        (Emission::Even { attenuation: Attenuation::None, .. }, _) | (_, Measure::SolidAngle) => {
            cosines(vectors, fan, n, scale, weights);
        }
        (Emission::Even { attenuation, .. }, _) => {
            cosines(vectors, fan, n, scale, weights);
            for (i, weight) in weights.iter_mut().enumerate() {
                *weight *= attenuation.factor(fan.direction(i).length());
            }
        }
        (Emission::Diffuse { .. }, Measure::Area) => match (light.emitter.flat_normal(), &light.emitter) {
            (Some(normal), _) => flat(vectors, fan, n, normal, scale, weights),
            (None, Emitter::Sphere(s)) => {
                round(
                    vectors,
                    fan,
                    n,
                    ((s.center() - fan.origin) * scale, s.radius() * scale),
                    scale,
                    weights,
                );
            }
            (None, _) => unreachable!("only spheres are round"),
        },
    }
}

vectorised! {
    /// `cos θ` of every segment: D's lights, and points spread over solid angle.
    fn cosines(fan: &Fan, n: DVec3, scale: f64, weights: &mut [f64]) {
        for (Lanes { x, y, z }, weights) in fan.lanes().zip(weights.chunks_exact_mut(LANES)) {
            for i in 0..LANES {
                let (x, y, z) = (x[i] * scale, y[i] * scale, z[i] * scale);
                let d2 = x * x + y * y + z * z;
                let cos = (n.x * x + n.y * y + n.z * z) / d2.sqrt();
                weights[i] = if cos > 0.0 { cos } else { 0.0 };
            }
        }
    }
}

vectorised! {
    /// `cos θ cos θₗ / d²` of every segment to a flat light with normal `nl`.
    fn flat(fan: &Fan, n: DVec3, nl: DVec3, scale: f64, weights: &mut [f64]) {
        for (Lanes { x, y, z }, weights) in fan.lanes().zip(weights.chunks_exact_mut(LANES)) {
            for i in 0..LANES {
                let (x, y, z) = (x[i] * scale, y[i] * scale, z[i] * scale);
                let d2 = x * x + y * y + z * z;
                let cos = n.x * x + n.y * y + n.z * z;
                let cos_light = -(nl.x * x + nl.y * y + nl.z * z);
                let weight = cos * cos_light / (d2 * d2);
                weights[i] = if (cos > 0.0) & (cos_light > 0.0) { weight } else { 0.0 };
            }
        }
    }
}

vectorised! {
    /// The same for a ball `(centre from the fan's origin, radius)`: its normal is `(d − centre)/radius`.
    fn round(fan: &Fan, n: DVec3, ball: (DVec3, f64), scale: f64, weights: &mut [f64]) {
        let (c, radius) = ball;
        for (Lanes { x, y, z }, weights) in fan.lanes().zip(weights.chunks_exact_mut(LANES)) {
            for i in 0..LANES {
                let (x, y, z) = (x[i] * scale, y[i] * scale, z[i] * scale);
                let d2 = x * x + y * y + z * z;
                let cos = n.x * x + n.y * y + n.z * z;
                let facing = (c.x - x) * x + (c.y - y) * y + (c.z - z) * z;
                let cos_light = facing / radius;
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
