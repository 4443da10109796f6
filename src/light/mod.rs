//! Lights: where light starts, and how much of it arrives.
//!
//! The documents measure light in different ways; here every light answers with the irradiance that a
//! surface facing it receives, [W m⁻²], and a matt surface of reflectance ρ sends back `ρ E cos θ / π`.
//!
//! | source | says | irradiance of a facing surface at distance d |
//! |---|---|---|
//! | D | `Color c`, no fall-off | `π c`, so that radiance is `ρ c cos θ` |
//! | ours | point light of intensity `I` [W sr⁻¹] | `I / d²` |
//! | ours | rectangle of radiance `L` [W m⁻² sr⁻¹], emitting to its front only | `L cos θₗ A / d²`, a point standing for the area `A` |

mod irradiance;
mod solid_angle;

pub use irradiance::{polygon_irradiance, sphere_irradiance};
pub use solid_angle::{SphericalCap, SphericalRectangle, SphericalTriangle};

use crate::color::Rgb;
use crate::frame::{Frame, rotation_about, unit};
use crate::ray::Ray;
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// How light thins out on its way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Falloff {
    /// Not at all, in no direction: the lights of [D §4.10]. `power` is D's `Color`.
    None,
    /// With the inverse square of the distance; `power` is intensity [W sr⁻¹] of a point, and
    /// radiance [W m⁻² sr⁻¹] of an area that emits by Lambert's cosine law to its front.
    InverseSquare,
}

/// Where the rays to an area light's cells end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Placement {
    /// The cell's centre: the same points for every pixel, hence steps in the penumbra [D §5.9.4].
    Grid,
    /// A random place in the cell, new for every pixel.
    Jittered,
}

/// A light without size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    pub position: DVec3,
    pub power: Rgb,
    pub falloff: Falloff,
}

/// A rectangle that shines, seen by camera and reflected rays and never blocking a shadow ray [D §4.10.2].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AreaLight {
    pub center: DVec3,
    /// From the centre to the middle of an edge across the width.
    pub half_width: DVec3,
    /// From the centre to the middle of an edge across the height.
    pub half_height: DVec3,
    /// Unit; the direction in which the light faces.
    pub normal: DVec3,
    pub power: Rgb,
    pub falloff: Falloff,
    /// Cells along width and height; each is one shadow ray.
    pub subdivision: (u32, u32),
    pub placement: Placement,
}

/// Any light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    Point(PointLight),
    Area(AreaLight),
}

/// Why no light stands there.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LightError {
    #[error("a light's direction must not be the zero vector")]
    NoDirection,
    #[error("a light's {what} must be positive, found {found}")]
    NotPositive { what: &'static str, found: f64 },
}

impl PointLight {
    /// Irradiance [W m⁻²] of a facing surface at `distance`.
    pub fn irradiance(&self, distance: f64) -> Rgb {
        match self.falloff {
            Falloff::None => self.power * PI,
            Falloff::InverseSquare => self.power / (distance * distance),
        }
    }
}

impl AreaLight {
    /// A rectangle `size` (width, height) about `center` that faces `direction`, turned by `roll` [rad]
    /// counter-clockwise about it [D §4.10.2].
    ///
    /// Without roll the width runs horizontally and the height upwards (for a light that faces
    /// straight up or down: along x and z), as for a camera that looks along `direction`.
    /// It has one cell at its whole; see [`AreaLight::subdivided`].
    pub fn new(
        center: DVec3,
        direction: DVec3,
        roll: f64,
        size: DVec2,
        power: Rgb,
        falloff: Falloff,
    ) -> Result<Self, LightError> {
        for (what, found) in [("width", size.x), ("height", size.y)] {
            if !(found > 0.0 && found.is_finite()) {
                return Err(LightError::NotPositive { what, found });
            }
        }
        let normal = unit(direction).ok_or(LightError::NoDirection)?;
        let up = if normal.x == 0.0 && normal.z == 0.0 { DVec3::Z } else { DVec3::Y };
        let frame = Frame::look_at(DVec3::ZERO, normal, up).map_err(|_| LightError::NoDirection)?;
        let turn = rotation_about(normal, roll).ok_or(LightError::NoDirection)?;
        Ok(AreaLight {
            center,
            half_width: turn * frame.right * (0.5 * size.x),
            half_height: turn * frame.up * (0.5 * size.y),
            normal,
            power,
            falloff,
            subdivision: (1, 1),
            placement: Placement::Grid,
        })
    }

    /// The same light in `columns × rows` cells (at least one each).
    pub fn subdivided(self, columns: u32, rows: u32, placement: Placement) -> Self {
        AreaLight { subdivision: (columns.max(1), rows.max(1)), placement, ..self }
    }

    /// Number of cells, each of which sends one shadow ray.
    pub fn cells(&self) -> u32 {
        self.subdivision.0 * self.subdivision.1
    }

    /// The point at `u` in [0,1)² of a cell; cells count along the width first.
    pub fn point(&self, cell: u32, u: DVec2) -> DVec3 {
        let (columns, rows) = self.subdivision;
        let x = (f64::from(cell % columns) + u.x) / f64::from(columns);
        let y = (f64::from(cell / columns) + u.y) / f64::from(rows);
        self.center + self.half_width * (2.0 * x - 1.0) + self.half_height * (2.0 * y - 1.0)
    }

    /// Area [m²].
    pub fn area(&self) -> f64 {
        4.0 * self.half_width.length() * self.half_height.length()
    }

    /// The corners, in order around the rectangle.
    pub fn corners(&self) -> [DVec3; 4] {
        let (c, w, h) = (self.center, self.half_width, self.half_height);
        [c - w - h, c + w - h, c + w + h, c - w + h]
    }

    /// Radiance [W m⁻² sr⁻¹] that a viewer who looks along `direction` sees on the rectangle: D's lights
    /// show their colour on both sides, a radiometric one its front; its back is not there.
    pub fn radiance_towards(&self, direction: DVec3) -> Option<Rgb> {
        match self.falloff {
            Falloff::None => Some(self.power),
            Falloff::InverseSquare => (direction.dot(self.normal) < 0.0).then_some(self.power),
        }
    }

    /// Where a ray meets the rectangle, if at some `t > 0`.
    pub fn crossing(&self, ray: &Ray) -> Option<f64> {
        let to = self.center - ray.origin;
        let t = to.dot(self.normal) / ray.direction.dot(self.normal);
        if !(t > 0.0 && t.is_finite()) {
            return None;
        }
        let p = ray.direction * t - to;
        let inside = |half: DVec3| p.dot(half).abs() <= half.length_squared();
        (inside(self.half_width) && inside(self.half_height)).then_some(t)
    }
}
