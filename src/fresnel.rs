//! Fresnel's equations: the share of light that a smooth boundary sends back.
//!
//! With the indices `nᵢ, nₜ` of the two sides, `c = cos θᵢ` and `g = nₜ cos θₜ = √(nₜ² − nᵢ² sin²θᵢ)`, the
//! amplitudes are usually printed as differences, which cancel where the indices are nearly equal. Multiplied
//! by the conjugate the differences become those of the *indices*:
//!
//! ```text
//! r_s = (nᵢ c − g)/(nᵢ c + g)         = −(nₜ² − nᵢ²) / (nᵢ c + g)²                                   (1)
//! r_p = (nₜ² c − nᵢ g)/(nₜ² c + nᵢ g) = (nₜ² − nᵢ²) ((nₜ² + nᵢ²) c² − nᵢ²) / (nₜ² c + nᵢ g)²         (2)
//! g²  = (nₜ − nᵢ)(nₜ + nᵢ) + nᵢ² c²                                                                  (3)
//! ```
//!
//! A negative `g²` is total internal reflection. For a metal, `nₜ = η + ik` makes `g` complex, and the same
//! formulas hold with moduli.
//!
//! Source: Born & Wolf, *Principles of Optics* (1999) §1.5.2, §14.2; [B §7.5.3], whose formula for s-polarised
//! light is that for p (see the errata).

/// Reflectances of light polarised across and along the plane of incidence, each in `[0,1]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polarised {
    /// Electric field across the plane of incidence (senkrecht).
    pub s: f64,
    /// Electric field in the plane.
    pub p: f64,
}

impl Polarised {
    /// Everything comes back.
    pub const ALL: Polarised = Polarised { s: 1.0, p: 1.0 };

    /// Reflectance of light without polarisation: the mean.
    #[inline]
    pub fn mean(self) -> f64 {
        0.5 * (self.s + self.p)
    }
}

/// Cuts off what rounding has added; NaN goes through, which `f64::min` would swallow.
#[inline]
fn at_most_one(x: f64) -> f64 {
    if x > 1.0 { 1.0 } else { x }
}

/// Cosine of the angle on the far side, `None` where light is totally reflected.
///
/// ```text
/// cos θₜ = g / nₜ,    sin²θₜ = (nᵢ/nₜ)² sin²θᵢ < 1
/// ```
///
/// - Domain: positive indices, `0 ≤ cos_i ≤ 1`. At the critical angle exactly, `Some(0)`.
/// - Source: Snell's law; (3).
#[inline]
pub fn cos_transmitted(ior_i: f64, ior_t: f64, cos_i: f64) -> Option<f64> {
    let g2 = (ior_t - ior_i) * (ior_t + ior_i) + (ior_i * cos_i) * (ior_i * cos_i);
    (!(g2 < 0.0)).then(|| at_most_one(g2.sqrt() / ior_t))
}

/// Reflectances of a boundary between two clear media.
///
/// - Domain: positive indices, `0 ≤ cos_i ≤ 1` on the incident side. Grazing light, `cos_i = 0`, comes back
///   wholly, also where the indices are equal (the limit is 1 for every other pair); equal indices reflect nothing
///   of any other light; beyond the critical angle everything comes back.
/// - Accuracy: relative error a few `u` of `1 − η²` and of `g`, however close the indices; at Brewster's angle
///   `r_p` vanishes and keeps an absolute error of `u`.
/// - NaN in, NaN out.
/// - Source: (1)–(3).
pub fn dielectric(ior_i: f64, ior_t: f64, cos_i: f64) -> Polarised {
    if cos_i <= 0.0 {
        return Polarised::ALL;
    }
    let (i2, t2) = (ior_i * ior_i, ior_t * ior_t);
    let contrast = (ior_t - ior_i) * (ior_t + ior_i);
    if contrast == 0.0 {
        return Polarised { s: 0.0, p: 0.0 };
    }
    let c2 = cos_i * cos_i;
    let g2 = contrast + i2 * c2;
    if g2 < 0.0 {
        return Polarised::ALL;
    }
    let g = g2.sqrt();
    let (sum_s, sum_p) = (ior_i * cos_i + g, t2 * cos_i + ior_i * g);
    let r_s = contrast / (sum_s * sum_s);
    let r_p = contrast * ((t2 + i2) * c2 - i2) / (sum_p * sum_p);
    Polarised { s: at_most_one(r_s * r_s), p: at_most_one(r_p * r_p) }
}

/// Reflectances of a metal, seen from a clear medium: relative index `η + ik`.
///
/// With `q = a + ib = √(ε − sin²θ)`, `ε = (η + ik)²`:
///
/// ```text
/// R_s = |ε − 1|² / |q + c|⁴,    R_p = |ε − 1|² |(ε + 1) c² − 1|² / |ε c + q|⁴
/// ```
///
/// - Domain: `eta > 0`, `k ≥ 0`, relative to the incident side; `0 ≤ cos_i ≤ 1`. `cos_i = 0` gives 1;
///   `k = 0` gives [`dielectric`].
/// - Accuracy: a few `u`, but where `q` itself is undecided: `k` tiny beside the critical angle.
/// - NaN in, NaN out.
/// - Source: (1), (2) with moduli; Born & Wolf (1999) §14.2.
pub fn conductor(eta: f64, k: f64, cos_i: f64) -> Polarised {
    if cos_i <= 0.0 {
        return Polarised::ALL;
    }
    // ε − 1 = (η − 1 + ik)(η + 1 + ik)
    let contrast2 = ((eta - 1.0) * (eta - 1.0) + k * k) * ((eta + 1.0) * (eta + 1.0) + k * k);
    if contrast2 == 0.0 {
        return Polarised { s: 0.0, p: 0.0 };
    }
    let c2 = cos_i * cos_i;
    let (re, im) = ((eta - 1.0) * (eta + 1.0) - k * k + c2, 2.0 * eta * k);
    let modulus = re.hypot(im);
    // The larger part of the root first; the other from their product, which does not cancel.
    let larger = (0.5 * (modulus + re.abs())).sqrt();
    let other = if larger > 0.0 { 0.5 * im / larger } else { 0.0 };
    let (a, b) = if re >= 0.0 { (larger, other) } else { (other, larger) };
    let s_sum = (a + cos_i) * (a + cos_i) + b * b;
    // ε = (η² − k²) + 2ηk i
    let (er, ei) = ((eta - k) * (eta + k), im);
    let (up_r, up_i) = ((er + 1.0) * c2 - 1.0, ei * c2);
    let (down_r, down_i) = (er * cos_i + a, ei * cos_i + b);
    let p_sum = down_r * down_r + down_i * down_i;
    let up = up_r * up_r + up_i * up_i;
    let r_p = (contrast2.sqrt() / p_sum) * (contrast2.sqrt() / p_sum) * up;
    Polarised { s: at_most_one(contrast2 / (s_sum * s_sum)), p: at_most_one(r_p) }
}

/// Reflectance at normal incidence, `F₀ = ((nₜ − nᵢ)/(nₜ + nᵢ))²`.
#[inline]
pub fn normal_incidence(ior_i: f64, ior_t: f64) -> f64 {
    let r = (ior_t - ior_i) / (ior_t + ior_i);
    r * r
}

/// Schlick's approximation, `F ≈ F₀ + (1 − F₀)(1 − cos θ)⁵`.
///
/// - Domain: `f0` in `[0,1]`; `versine = 1 − cos θ` in `[0,1]`, of the *larger* of the two angles: where light
///   leaves the denser side that is the transmitted one ([`schlick_between`] sees to it).
/// - Accuracy: within 0.036 of the exact value from air to glass (1.5); worse as the index grows.
/// - Source: Schlick, *An Inexpensive BRDF Model for Physically-Based Rendering* (1994), (15).
#[inline]
pub fn schlick(f0: f64, versine: f64) -> f64 {
    let v2 = versine * versine;
    f0 + (1.0 - f0) * (v2 * v2 * versine)
}

/// [`schlick`] between two clear media, in either direction: it takes the cosine of the thinner side, and
/// total reflection is total.
pub fn schlick_between(ior_i: f64, ior_t: f64, cos_i: f64) -> f64 {
    let f0 = normal_incidence(ior_i, ior_t);
    let cos = if ior_i > ior_t { cos_transmitted(ior_i, ior_t, cos_i) } else { Some(cos_i) };
    cos.map_or(1.0, |c| schlick(f0, 1.0 - c))
}

/// What a smooth facet is made of, seen from air.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fresnel {
    /// Reflectance at normal incidence, the rest by Schlick; 1 is the perfect mirror.
    Schlick { f0: f64 },
    /// Clear, with this index.
    Dielectric { ior: f64 },
    /// A metal with index `eta + ik`; 0 for `k` gives the dielectric.
    Conductor { eta: f64, k: f64 },
}

impl Fresnel {
    /// Reflectance of light without polarisation at an angle with this cosine, and `versine = 1 − cos θ`.
    #[inline]
    pub fn reflectance(&self, cos_theta: f64, versine: f64) -> f64 {
        match *self {
            Fresnel::Schlick { f0 } => schlick(f0, versine),
            Fresnel::Dielectric { ior } => dielectric(1.0, ior, cos_theta).mean(),
            Fresnel::Conductor { eta, k } => conductor(eta, k, cos_theta).mean(),
        }
    }
}
