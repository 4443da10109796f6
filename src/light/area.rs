//! Lights with a surface: their shadows are soft [A §4.3.5–6, D §4.10.2, §5.9.4].

use super::{Attenuation, Emitter, LightError, Rectangle};
use crate::color::Rgb;
use crate::ray::Ray;
use crate::sample::{Cell, Cells, Pattern, Sampler, ScrambledSobol, r2};
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// How a surface shines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Emission {
    /// Every point shines alike in all directions, to both sides, and the light is the mean over its points: a facing
    /// surface of reflectance ρ shows `ρ color`, times the attenuation's factor. The documents' lights [A §4.3.5, D §4.10.2].
    Even { color: Rgb, attenuation: Attenuation },
    /// The same radiance [W m⁻² sr⁻¹] in all directions to the front, outwards from a sphere: Lambert's cosine law, which
    /// every hot surface follows closely.
    Diffuse { radiance: Rgb },
}

impl Emission {
    /// D's light, which does not thin out.
    pub fn even(color: Rgb) -> Self {
        Emission::Even { color, attenuation: Attenuation::None }
    }

    /// A radiometric light.
    pub fn diffuse(radiance: Rgb) -> Self {
        Emission::Diffuse { radiance }
    }
}

/// What the square, from which points are drawn, is mapped to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Measure {
    /// Equal areas of the light.
    #[default]
    Area,
    /// Equal solid angles, as the place that is lit sees them: neither `cos θₗ` nor `1/d²` is left to chance. Only
    /// for [`Emission::Diffuse`]; the documents' lights are means over area.
    SolidAngle,
}

/// A surface that shines, seen by camera and reflected rays and never blocking a shadow ray [D §4.10.2].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AreaLight {
    pub emitter: Emitter,
    pub emission: Emission,
    cells: Cells,
    pattern: Pattern,
    measure: Measure,
}

impl AreaLight {
    /// A light of one ray, to the middle of its surface; see [`AreaLight::subdivided`] and [`AreaLight::sampled`].
    pub fn new(emitter: impl Into<Emitter>, emission: Emission) -> Self {
        let (cells, pattern, measure) = (Cells::grid(1, 1), Pattern::Centres, Measure::Area);
        AreaLight { emitter: emitter.into(), emission, cells, pattern, measure }
    }

    /// D's rectangle: see [`Rectangle::facing`].
    ///
    /// - Errors: those of the rectangle.
    pub fn rectangle(
        center: DVec3,
        direction: DVec3,
        roll: f64,
        size: DVec2,
        emission: Emission,
    ) -> Result<Self, LightError> {
        Ok(Self::new(Rectangle::facing(center, direction, roll, size)?, emission))
    }

    /// The same light in `columns × rows` cells (at least one each), one shadow ray each [D §4.10.2].
    pub fn subdivided(self, columns: u32, rows: u32, pattern: Pattern) -> Self {
        AreaLight { cells: Cells::grid(columns.max(1), rows.max(1)), pattern, ..self }
    }

    /// The same light with `n` shadow rays (at least one).
    pub fn sampled(self, n: u32, pattern: Pattern) -> Self {
        AreaLight { cells: Cells::equal_areas(n.max(1)), pattern, ..self }
    }

    pub fn by(self, measure: Measure) -> Self {
        AreaLight { measure, ..self }
    }

    /// Number of shadow rays from each place.
    pub fn samples(&self) -> u32 {
        self.cells.len()
    }

    pub fn cells(&self) -> Cells {
        self.cells
    }

    pub fn pattern(&self) -> Pattern {
        self.pattern
    }

    /// What its points are spread over: the documents' lights are means over area, whatever was asked for.
    pub fn measure(&self) -> Measure {
        match self.emission {
            Emission::Even { .. } => Measure::Area,
            Emission::Diffuse { .. } => self.measure,
        }
    }

    /// Are the points the same for every place that is lit?
    pub fn is_fixed(&self) -> bool {
        self.pattern == Pattern::Centres && self.measure() == Measure::Area
    }

    /// The cells from which jittered points are drawn, for [`AreaLight::squares`]; none of other patterns.
    pub fn jittered_cells(&self) -> Vec<Cell> {
        if self.pattern == Pattern::Jittered { self.cells.iter().collect() } else { Vec::new() }
    }

    /// The points of the square for one place; random ones take their numbers from `sampler`. `cells` are the
    /// [`AreaLight::jittered_cells`], made once.
    ///
    /// Sequences go on from one camera ray of a pixel to the next: their points are even over the whole pixel.
    pub fn squares(&self, cells: &[Cell], sampler: &mut Sampler) -> impl Iterator<Item = DVec2> {
        let n = self.samples();
        let (seed, sample) = match self.pattern {
            Pattern::Sobol | Pattern::R2 => sampler.next_sequence(),
            _ => (0, 0),
        };
        let (first, sobol) = (sample.wrapping_mul(n), ScrambledSobol::new(seed));
        (0..n).map(move |i| match self.pattern {
            Pattern::Sobol => sobol.point(first.wrapping_add(i)),
            Pattern::R2 => r2(seed, first.wrapping_add(i)),
            Pattern::Centres => self.cells.cell(i).center(),
            Pattern::Jittered => cells[i as usize].at(sampler.next_2d()),
            Pattern::Random => sampler.next_2d(),
        })
    }

    /// Radiance [W m⁻² sr⁻¹] and ray parameter where a camera or reflected ray meets the light: the documents' lights show
    /// their colour from both sides, a diffuse one its front; its back is not there.
    pub fn met(&self, ray: &Ray) -> Option<(f64, Rgb)> {
        let (radiance, both_sides) = match self.emission {
            Emission::Even { color, .. } => (color, true),
            Emission::Diffuse { radiance } => (radiance, false),
        };
        if !both_sides && !self.emitter.faces(ray.origin) {
            return None;
        }
        self.emitter.crossing(ray).map(|t| (t, radiance))
    }

    /// What one of `n` rays brings to a facing surface, but for the geometry: irradiance [W m⁻²] of the documents' lights
    /// where the attenuation's factor is 1; `radiance · scale² area / n`, for lengths multiplied by `scale`;
    /// `radiance · solid_angle / n`.
    pub fn share(&self, solid_angle: f64, scale: f64) -> Rgb {
        let n = f64::from(self.samples());
        match (self.emission, self.measure()) {
            (Emission::Even { color, .. }, _) => color * (PI / n),
            (Emission::Diffuse { radiance }, Measure::Area) => {
                radiance * (self.emitter.area_scaled(scale) / n)
            }
            (Emission::Diffuse { radiance }, Measure::SolidAngle) => radiance * (solid_angle / n),
        }
    }
}
