//! A picture from a closure: an integrator in one line.

use super::{Picture, render};
use crate::color::Rgb;
use crate::film::Image;
use crate::integrator::Integrator;
use crate::ray::{Ray, Trace};
use crate::sample::Sampler;
use crate::scene::Scene;

/// Renders a picture whose camera rays bring what `radiance(ray, scene)` says: an integrator without random numbers and
/// without counts, through the same tile loop as any other.
pub fn shade(scene: &Scene, picture: Picture, radiance: impl Fn(&Ray, &Scene) -> Rgb + Sync) -> Image {
    render(scene, &Closure(radiance), picture).image
}

struct Closure<F>(F);

impl<F: Fn(&Ray, &Scene) -> Rgb + Sync> Integrator for Closure<F> {
    type Scratch = ();

    fn scratch(&self, _: &Scene) {}

    fn radiance<T: Trace>(&self, scene: &Scene, ray: &Ray, _: &mut Sampler, _: &mut (), _: &mut T) -> Rgb {
        (self.0)(ray, scene)
    }
}
