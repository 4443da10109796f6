//! Colour: linear RGB, and the transfer curve of files.

use glam::DVec3;

/// Linear RGB with the Rec. 709 primaries: `x` is red, `y` green, `z` blue. Radiance
/// [W m⁻² sr⁻¹] per channel, or a reflectance in [0,1].
pub type Rgb = DVec3;
