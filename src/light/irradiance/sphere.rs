//! A sphere: closed forms above, across and below the horizon.

use super::{height, rounded, seen_from, square};
use crate::num::certified::power_of_two_below;
use crate::num::double_double::DoubleDouble;
use glam::DVec3;
use std::f64::consts::PI;

/// Irradiance [W m⁻²] at `p`, with unit normal `n`, from a sphere of radiance 1.
///
/// With `s = sin σ = R/D` for half the angle that the sphere covers, `k = cos σ`, and `c = cos θ` of its centre's direction:
///
/// ```text
/// E = π s² c                                                       wholly above, c ≥ s               (1)
/// E = s² c atan2(w, −k c) + ½(2ψ − sin 2ψ) + c² k w/(k² + w²)      across the horizon                (2)
///     w = √((s − c)(s + c)),   ψ = atan2(w, k)
/// E = 0                                                            wholly below, c ≤ −s              (3)
/// ```
///
/// In (2) the usual `ψ − k w` of the last two terms is split, since it cancels to `s³` for small spheres.
///
/// - Domain: finite; `radius ≥ 0`; `n` of any length but 0 counts as normalised. Without radius, and for `n = 0`: 0. On the
///   sphere, seen from outside: `π (1 + c)/2`. Inside, where it emits inwards too: `π`.
/// - Accuracy: 16 u of `π s²|c|` in (1), of `s³` in (2): below the horizon, near (3), the terms cancel to less.
/// - NaN: out if any number is NaN or infinite.
/// - Source: integral (1) of the module over a cap; Snyder, *Area light sources for real-time graphics* (1996).
pub fn sphere_irradiance(center: DVec3, radius: f64, p: DVec3, n: DVec3) -> f64 {
    if !(center.is_finite() && radius.is_finite() && p.is_finite() && n.is_finite()) {
        return f64::NAN;
    }
    if !(radius > 0.0) || n == DVec3::ZERO {
        return 0.0;
    }
    let unit = power_of_two_below(center.abs().max(p.abs()).max_element().max(radius));
    let n = n / power_of_two_below(n.abs().max_element());
    let d = seen_from(center, p, unit);
    // Both may be tiny next to the coordinates.
    let larger = power_of_two_below(rounded(d).abs().max_element().max(radius / unit));
    let (d, radius) = (d.map(|x| x.shift(1.0 / larger)), radius / unit / larger);
    if rounded(d) == DVec3::ZERO {
        return PI; // the centre, even of a radius that has underflowed
    }
    let square = square(d);
    let outside = (square - DoubleDouble::of(radius).square()).value();
    if outside < 0.0 {
        return PI;
    }
    let distance = square.value().sqrt();
    let (s, k) = ((radius / distance).min(1.0), outside.sqrt() / distance);
    let c = (height(n, d).value() / (n.length() * distance)).clamp(-1.0, 1.0);
    if c <= -s {
        return 0.0;
    }
    if c >= s {
        return PI * (s * s) * c;
    }
    let w = ((s - c) * (s + c)).sqrt();
    let psi = w.atan2(k);
    let rest = 0.5 * minus_sine(2.0 * psi) + c * c * (k * w) / (k * k + w * w);
    (s * s * c * w.atan2(-k * c) + rest).clamp(0.0, PI)
}

/// `x − sin x` for `0 ≤ x ≤ π`.
///
/// - Accuracy: relative. Below `½` the series to `x¹³`; the next term is at most 2⁻⁵¹ of the sum. Above it the
///   difference loses a factor of 24.
fn minus_sine(x: f64) -> f64 {
    if x > 0.5 {
        return x - x.sin();
    }
    // 1/3!, 1/5!, … with alternating signs.
    let x2 = x * x;
    let term = |sum: f64, k: f64| (1.0 - sum) * x2 / (k * (k - 1.0));
    [13.0, 11.0, 9.0, 7.0, 5.0, 3.0].into_iter().fold(0.0, term) * x
}
