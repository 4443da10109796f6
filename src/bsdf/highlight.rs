//! Highlights as they were drawn before they were BRDFs [C §1.8.3].
//!
//! ```text
//! I = Iᵢ W(θ) cosⁿ φ            [C (23)]   φ between the viewer and the mirror direction of the light
//! I = Iᵢ K (n·h)ᵐ, n·h = cos β  [C (28)]   β between the normal and the half vector h of light and viewer
//! φ = 2β                        [C (27)]   where light, viewer and normal lie in one plane
//! ```
//!
//! The two are BRDFs with [`PhongScale::OverCosine`](super::PhongScale::OverCosine) and
//! [`BlinnScale::OverCosine`](super::BlinnScale::OverCosine). Here stands what one asks before: which exponent `m` answers
//! which `n` ([`Match`]), and what may stand for the power.

use super::phong;
use crate::num::quadrature::integrate;
use crate::num::real::Real;
use std::f64::consts::LN_2;

/// The coefficient `W(θ)` of a material that is dull from the front and a mirror at grazing angles, glass for one.
///
/// ```text
/// W(θ) = least + (1 − least) (1 − cos θ)^sharpness
/// ```
///
/// - Domain: `least` in `[0,1]`, `sharpness > 0`, `cos_theta` in `[0,1]`; from the front `least`, in the horizon 1.
/// - NaN in, NaN out.
/// - Source: [C §1.8.3 B] asks for a function that grows from near 0 to 1, and gives none; the form is ours.
pub fn grazing_coefficient(least: f64, sharpness: f64, cos_theta: f64) -> f64 {
    least + (1.0 - least) * (1.0 - cos_theta).powf(sharpness)
}

/// `cosⁿ φ` from `1 − cos φ`.
///
/// - Domain: `versine` in `[0,2]`, finite `n ≥ 0`; from 90° on 0, also for n = 0.
/// - Accuracy: relative, a few `u` times `1 + n ln(1/cos φ)`.
/// - NaN in, NaN out.
#[inline]
pub fn power(versine: f64, n: f64) -> f64 {
    phong::power(versine, || 1.0 - versine, n)
}

/// A rational stand-in for `tⁿ`, `t = cos φ`.
///
/// ```text
/// t/(n − n t + t) = t/(n v + t),    v = 1 − t
/// ```
///
/// - Domain: as [`power`].
/// - Accuracy: exact for n = 1; for n ≥ 1 never below `tⁿ`, and at most 0.2037 above, where `n v` is about 2.5: value and
///   slope are right at the peak, but the flank falls as `1/(1 + n v)` instead of `e^(−n v)`.
/// - NaN in, NaN out.
/// - Source: Schlick, *A Fast Alternative to Phong's Specular Model*, Graphics Gems IV (1994) §VI.1.
#[inline]
pub fn schlick_power<R: Real>(versine: R, n: R) -> R {
    let t = R::from_f64(1.0) - versine;
    if t <= R::ZERO { R::ZERO } else { t / (n * versine + t) }
}

/// A product for `cosⁿ φ`: `g = 2ᵏ` factors, made by squaring `k` times.
///
/// ```text
/// max(0, 1 − n v/g)^g,    v = 1 − cos φ
/// ```
///
/// - Domain: as [`power`], `squarings < 64`.
/// - Accuracy: exact for n = g; for n ≥ g never above `cosⁿ φ`, and at most `4 e⁻²/g` below.
/// - NaN in, NaN out.
/// - Source: Lyon, *Phong Shading Reformulation for Hardware Renderer Simplification*, Apple TR 43 (1993).
#[inline]
pub fn lyon_power<R: Real>(versine: R, n: R, squarings: u32) -> R {
    let share = R::from_f64(1.0 / (1u64 << squarings) as f64);
    let mut power = R::from_f64(1.0) - n * share * versine;
    if power <= R::ZERO || versine >= R::from_f64(1.0) {
        return R::ZERO;
    }
    for _ in 0..squarings {
        power = power * power;
    }
    power
}

/// What the exponent `m` of `n·h` is to have in common with `n` of `r·v`.
///
/// Light along the normal: then `φ = 2β` for every viewer, and the lobes are `cosⁿ φ` and `cosᵐ(φ/2)`. All four grow as
/// `4n`; for large `n` they come to `4n + 0`, `4n + ln 2`, `4n + 3/2` and `4n + 2`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Match {
    /// The curvature at the peak: `m = 4n`.
    Peak,
    /// The angle where half is left.
    HalfWidth,
    /// The square of the difference is least, over solid angle.
    LeastSquares,
    /// The integral over solid angle.
    Energy,
}

impl Match {
    pub const ALL: [Match; 4] = [Match::Peak, Match::HalfWidth, Match::LeastSquares, Match::Energy];

    /// The exponent `m`.
    ///
    /// ```text
    /// half width:   m = n ln cos φ½ / ln cos(φ½/2) = −2 ln 2 / ln(1 − v/2),   v = 1 − 2^(−1/n)
    /// energy:       4 (1 − 2^(−m/2−1)) / (m + 2) = 1/(n + 1)
    /// squares:      ∫ (cosⁿ φ − cosᵐ(φ/2)) cosᵐ(φ/2) ln cos(φ/2) dω = 0
    /// ```
    ///
    /// - Domain: finite `n > 0`, up to 10⁸ for least squares.
    /// - Accuracy: relative, `gamma(8)` for peak and half width, 10⁻¹² for energy; that of least squares stands on a
    ///   quadrature, and is absolute: 10⁻⁶ (1 + n 10⁻⁸) or better.
    /// - NaN in, NaN out.
    pub fn exponent(self, n: f64) -> f64 {
        match self {
            Match::Peak => 4.0 * n,
            Match::HalfWidth => -2.0 * LN_2 / (0.5 * (-LN_2 / n).exp_m1()).ln_1p(),
            // Both fall with m.
            Match::LeastSquares => root(n, |m| over_lobe(n, m, |excess, w| -excess * w)),
            Match::Energy => {
                root(n, |m| -4.0 * (n + 1.0) * (-LN_2 * (0.5 * m + 1.0)).exp_m1() / (m + 2.0) - 1.0)
            }
        }
    }
}

/// Where a falling function of an exponent between 2n and 4n + 8 vanishes.
fn root(n: f64, falling: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (2.0 * n, 4.0 * n + 8.0);
    while low < high {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        match falling(middle) {
            y if y > 0.0 => low = middle,
            y if y <= 0.0 => high = middle,
            nan => return nan,
        }
    }
    if n.is_nan() { n } else { 0.5 * (low + high) }
}

/// Difference of the lobes `cosⁿ φ` and `cosᵐ(φ/2)`, light along the normal: root mean square over the hemisphere, in
/// units of that of `cosⁿ φ`.
///
/// ```text
/// √(∫ (cosⁿ φ − cosᵐ(φ/2))² dω / ∫ cos²ⁿ φ dω),    ∫ cos²ⁿ φ dω = 2π/(2n + 1)
/// ```
///
/// - Domain: finite `n > 0`, `0 ≤ m ≤ 5n + 8`.
/// - Accuracy: relative 10⁻⁶ for n up to 10⁶, by quadrature of the difference itself.
pub fn mismatch(n: f64, m: f64) -> f64 {
    ((2.0 * n + 1.0) * over_lobe(n, m, |excess, _| excess * excess)).sqrt()
}

/// `∫ cos²ᵐ(φ/2) · part(cosⁿ φ/cosᵐ(φ/2) − 1, −ln cos²(φ/2)) d cos φ` over the hemisphere.
///
/// In `q = 1 − p^(m+1)`, `p = cos²(φ/2)`, the lobe is spread evenly, whatever its width.
fn over_lobe(n: f64, m: f64, part: impl Fn(f64, f64) -> f64) -> f64 {
    let over = |q: f64| {
        let w = -(-q).ln_1p() / (m + 1.0);
        // cos φ = 2p − 1
        let versine = -2.0 * (-w).exp_m1();
        let log_ratio = if versine < 1.0 { n * (-versine).ln_1p() + 0.5 * m * w } else { f64::NEG_INFINITY };
        part(log_ratio.exp_m1(), w)
    };
    let horizon = -(-(m + 1.0) * LN_2).exp_m1();
    let breaks = [0.0, 0.5 * horizon, horizon];
    // The difference falls with n: what is a small error of it, its own size must tell.
    let size = integrate(|q| over(q).abs(), &breaks, f64::INFINITY).value;
    integrate(over, &breaks, 1.0e-9 * size).value * (2.0 / (m + 1.0))
}
