//! The transfer curve of files: what is stored for a linear channel.

/// Largest linear value on the straight piece of the sRGB curve, inclusive.
const LINEAR_KNEE: f64 = 0.0031308;
/// Largest encoded value on the straight piece, inclusive.
const ENCODED_KNEE: f64 = 0.04045;
const SLOPE: f64 = 12.92;
const OFFSET: f64 = 0.055;
const EXPONENT: f64 = 2.4;

/// What a file stores for a linear channel: the sRGB curve, `[0,1]` → `[0,1]`.
///
/// ```text
/// s = 12.92 l                      l ≤ 0.0031308
/// s = 1.055 l^(1/2.4) − 0.055      otherwise
/// ```
///
/// The published constants leave a gap at the knee: the curve falls there by 2.9e-8, and is
/// monotone on either side.
///
/// - Domain: all numbers. Negative values stay on the straight piece; above 1 the power goes on;
///   infinities keep their sign.
/// - Accuracy: absolute error ≤ `num::gamma(12)` on `[0,1]`: at the knee the exponent, which errs by 2u at
///   most, costs `2u·|ln l|/2.4` = 4.8u, the power 2u, the factor, the difference and their constants the rest.
/// - NaN in, NaN out.
/// - Source: IEC 61966-2-1:1999.
pub fn srgb_encode(linear: f64) -> f64 {
    if linear <= LINEAR_KNEE { SLOPE * linear } else { (1.0 + OFFSET) * linear.powf(1.0 / EXPONENT) - OFFSET }
}

/// The linear channel behind a stored value: the inverse sRGB curve, `[0,1]` → `[0,1]`.
///
/// ```text
/// l = s / 12.92                    s ≤ 0.04045
/// l = ((s + 0.055) / 1.055)^2.4    otherwise
/// ```
///
/// It undoes [`srgb_encode`] up to rounding, except on the gap of the published constants
/// (0.0031308 < l < 0.0031308073), where up to 2.4e-9 remain.
///
/// - Domain: all numbers. Negative values stay on the straight piece; above 1 the power goes on,
///   and overflows to infinity beyond 1e128.
/// - Accuracy: relative error ≤ `num::gamma(16)` on `[0,1]`: sum, quotient and constants 3.7u, times 2.4;
///   the stored exponent errs by 0.34u, which costs `0.34u·2.4·|ln 0.09|` = 2u; the power 2u.
/// - NaN in, NaN out.
/// - Source: IEC 61966-2-1:1999.
pub fn srgb_decode(encoded: f64) -> f64 {
    if encoded <= ENCODED_KNEE {
        encoded / SLOPE
    } else {
        ((encoded + OFFSET) / (1.0 + OFFSET)).powf(EXPONENT)
    }
}
