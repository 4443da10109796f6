//! Colour: three numbers, and what they are the coordinates of [C §1.7.5].
//!
//! Light is a spectrum; an eye keeps three numbers of it, its integrals with three matching functions
//! ([`spectrum`]). Written as [`xyz`], those numbers give a luminance and a point of the chromaticity diagram, where
//! mixtures lie on straight lines. From that follow the [`dominant`] wavelength and purity of a colour, and which
//! colours three lamps can make ([`gamut`]). RGB are the amounts of three such lamps; CMY, HSV and HLS ([`models`])
//! are other coordinates in the same cube; [`srgb`] is the curve along which files store a channel.
//!
//! ```text
//! spectrum → XYZ = ∫ L(λ) (x̄, ȳ, z̄)(λ) dλ → linear RGB = M⁻¹ XYZ → stored sRGB
//! ```

pub mod dominant;
pub mod gamut;
pub mod models;
pub mod spectrum;
pub mod srgb;
pub mod xyz;

pub use srgb::{srgb_decode, srgb_encode};
pub use xyz::{LUMINANCE, luminance};

use glam::DVec3;

/// Linear RGB with the Rec. 709 primaries: `x` is red, `y` green, `z` blue. Radiance
/// [W m⁻² sr⁻¹] per channel, or a reflectance in `[0,1]`.
pub type Rgb = DVec3;
