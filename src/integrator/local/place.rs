//! A place that light falls on.

use crate::bsdf::Lobes;
use crate::color::Rgb;
use crate::ray::{Hit, Ray};
use crate::scene::Material;
use crate::shape::{Shape, perpendicular_part};
use glam::{DMat3, DVec3};
use std::f64::consts::FRAC_1_PI;

/// Where light is gathered, and how it is reflected to the viewer.
pub struct Place<'a> {
    /// Where shadow rays start: beyond the rounding error of the surface.
    pub origin: DVec3,
    /// The normal on the viewer's side, unit.
    pub n: DVec3,
    response: Response<'a>,
}

enum Response<'a> {
    /// `ρ/π`, whatever the directions.
    Matt(Rgb),
    Glossy {
        lobes: &'a Lobes,
        /// From the world to the local frame, whose z is the normal.
        local: DMat3,
        wo: DVec3,
    },
}

impl<'a> Place<'a> {
    /// The place where `ray` met `shape`, made of `material`.
    #[inline]
    pub fn new(ray: &Ray, hit: &Hit, shape: &dyn Shape, material: &'a Material) -> Self {
        let side = if ray.direction.dot(hit.ng) > 0.0 { -1.0 } else { 1.0 };
        let n = hit.n * side;
        let lifted = Hit { point: shape.lifted(hit, n), ..*hit };
        // A smooth normal may lean over the facet's horizon: the facet says which side is seen.
        let origin = lifted.origin_towards(hit.ng * side);
        let response = match &material.model {
            None => Response::Matt(material.diffuse * FRAC_1_PI),
            Some(lobes) => glossy(lobes, -ray.direction.normalize(), n, hit.ng * side, hit.tangent),
        };
        Place { origin, n, response }
    }

    /// Reflected radiance per irradiance from the unit direction `wi` [sr⁻¹].
    #[inline]
    pub fn f(&self, wi: DVec3) -> Rgb {
        match &self.response {
            Response::Matt(f) => *f,
            Response::Glossy { lobes, local, wo } => lobes.eval(*local * wi, *wo),
        }
    }

    /// The model's value, if it is the same for all directions.
    #[inline]
    pub fn constant_f(&self) -> Option<Rgb> {
        match self.response {
            Response::Matt(f) => Some(f),
            Response::Glossy { .. } => None,
        }
    }
}

/// A viewer whom the smooth normal `n` puts below the horizon sees the facet, normal `ng`, instead.
fn glossy(lobes: &Lobes, wo: DVec3, n: DVec3, ng: DVec3, tangent: DVec3) -> Response<'_> {
    let z = if wo.dot(n) > 0.0 { n } else { ng };
    let x = perpendicular_part(tangent, z);
    let local = DMat3::from_cols(x, z.cross(x), z).transpose();
    Response::Glossy { lobes, local, wo: local * wo }
}
