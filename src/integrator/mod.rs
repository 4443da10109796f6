//! Integrators: each turns a ray into radiance.

mod local;

pub use local::{Local, Memory, Stage};

use crate::color::Rgb;
use crate::ray::{Ray, Trace};
use crate::sample::Sampler;
use crate::scene::Scene;

/// A way to find the radiance that arrives along a ray.
pub trait Integrator: Sync {
    /// Memory that one thread keeps from ray to ray, so that rays allocate nothing.
    type Scratch;

    /// Fresh memory for one thread.
    fn scratch(&self, scene: &Scene) -> Self::Scratch;

    /// Radiance [W m⁻² sr⁻¹] that arrives at the origin of a camera ray from its direction.
    ///
    /// Every ray, hit and weight is reported to `trace`; random numbers come from `sampler` only.
    fn radiance<T: Trace>(
        &self,
        scene: &Scene,
        ray: &Ray,
        sampler: &mut Sampler,
        scratch: &mut Self::Scratch,
        trace: &mut T,
    ) -> Rgb;
}
