//! Where a line truly meets a sphere: the measure of the methods, some digits beyond `f64`.

use crate::num::double_double::{DoubleDouble, difference_of_products};

/// A line and a sphere, measured so that nothing of the size `|f|²` is ever subtracted.
///
/// ```text
/// t_ca = −f·d / d·d,    b = |f × d| / |d|,    h = √((r − b)(r + b)) / |d|,    t = t_ca ∓ h
/// ```
///
/// The scalar products are kept to twice the digits, and no difference in `f × d` cancels; so `b` is known to
/// a few roundings of `b` itself, whatever the distance, and `t_ca` to a few roundings of `u t_ca`.
///
/// - Domain: finite input, `d ≠ 0`, squares in the domain of [`crate::num::double_double::two_product`].
/// - Accuracy: `t_ca` relative 8 u² |f| |d| / |f·d|; `b` relative `γ₈`; `h` absolute `γ₁₂ (h + b²/h)`.
/// - Source: the identity `|f|² |d|² = (f·d)² + |f × d|²` (Lagrange).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    /// Parameter of the closest point, to twice the digits.
    closest: DoubleDouble,
    /// Distance of the line from the centre: the impact parameter.
    pub impact: f64,
    /// Half of the chord [lengths of `d`]; `None` if the line misses.
    pub half_chord: Option<f64>,
}

impl Meeting {
    /// `f` from the centre to the origin of the ray, `d` its direction, `r` the radius.
    pub fn of(f: [f64; 3], d: [f64; 3], r: f64) -> Self {
        let dd = dot(d, d);
        let closest = -(dot(f, d) / dd);
        let cross: [f64; 3] =
            [(1, 2), (2, 0), (0, 1)].map(|(i, j)| difference_of_products(f[i], d[j], f[j], d[i]));
        let speed = dd.value().sqrt();
        let impact = (cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]).sqrt() / speed;
        let half_chord = (impact <= r).then(|| ((r - impact) * (r + impact)).sqrt() / speed);
        Meeting { closest, impact, half_chord }
    }

    /// Both parameters, rounded to `f64`.
    pub fn roots(&self) -> Option<(f64, f64)> {
        let h = self.half_chord?;
        let at = |h: f64| (self.closest + DoubleDouble::of(h)).value();
        Some((at(-h), at(h)))
    }

    /// `t − t₀`: how far a found parameter lies behind the entering point; `None` if the line misses.
    pub fn behind_first(&self, t: f64) -> Option<f64> {
        self.half_chord.map(|h| (DoubleDouble::of(t) - self.closest + DoubleDouble::of(h)).value())
    }

    /// `t − t₁`: how far a found parameter lies behind the leaving point; `None` if the line misses.
    pub fn behind_second(&self, t: f64) -> Option<f64> {
        self.half_chord.map(|h| (DoubleDouble::of(t) - self.closest - DoubleDouble::of(h)).value())
    }
}

/// `a·b` to twice the digits.
fn dot(a: [f64; 3], b: [f64; 3]) -> DoubleDouble {
    DoubleDouble::product(a[0], b[0]) + DoubleDouble::product(a[1], b[1]) + DoubleDouble::product(a[2], b[2])
}
