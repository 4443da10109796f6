//! What is put on the stage: the house's colours, dull or glossy.

use crate::bsdf::{CookTorrance, Lambert, Lobes};
use crate::color::Rgb;
use crate::fresnel::Fresnel;
use crate::scene::Material;

/// Diffuse reflectances that go together, none brighter than the ground.
pub mod colour {
    use crate::color::Rgb;

    /// The ground: warm off-white.
    pub const PAPER: Rgb = Rgb::new(0.86, 0.825, 0.775);
    /// Burnt clay.
    pub const CLAY: Rgb = Rgb::new(0.64, 0.215, 0.115);
    /// Ochre.
    pub const OCHRE: Rgb = Rgb::new(0.74, 0.46, 0.12);
    /// Sage green.
    pub const SAGE: Rgb = Rgb::new(0.30, 0.42, 0.24);
    /// Teal.
    pub const TEAL: Rgb = Rgb::new(0.075, 0.30, 0.36);
    /// Night blue.
    pub const NIGHT: Rgb = Rgb::new(0.075, 0.10, 0.24);
    /// The five for objects, in the order in which to take them.
    pub const ALL: [Rgb; 5] = [CLAY, TEAL, OCHRE, SAGE, NIGHT];
}

/// A diffuse surface: Lambert's law.
pub fn diffuse(reflectance: Rgb) -> Material {
    Material { diffuse: reflectance, specular: Rgb::ZERO, ..Material::default() }
}

/// A diffuse surface under a coat of lacquer: GGX facets of index 1.6, `roughness` from 0.1 (polished) to 0.5 (satin).
///
/// ```text
/// f = (1 − F₀) ρ/π + f_facets,    F₀ = ((1.6 − 1)/(1.6 + 1))² = 0.053
/// ```
///
/// The lobes do not know of each other: nearer than some 10° to grazing, together they may send back up to a tenth more
/// than comes in.
///
/// # Panics
/// If the reflectance is negative or not finite, or the roughness outside \[0.05,1\]: below, lights of this stage would need
/// more points than it has.
pub fn glossy(reflectance: Rgb, roughness: f64) -> Material {
    assert!((0.05..=1.0).contains(&roughness), "a coat of roughness {roughness}");
    const IOR: f64 = 1.6;
    let f0 = crate::fresnel::normal_incidence(1.0, IOR);
    let lobes = Lambert::new(1.0).and_then(|base| {
        let coat = CookTorrance::ggx(roughness, Fresnel::Dielectric { ior: IOR })?;
        Lobes::new([(reflectance * (1.0 - f0), base.into()), (Rgb::ONE, coat.into())])
    });
    Material { model: Some(lobes.expect("a reflectance")), ..diffuse(reflectance) }
}
