//! How light thins out on its way.

use super::LightError;

/// The factor by which a light's irradiance falls with distance `d` \[m\].
///
/// | document | prints | here |
/// |---|---|---|
/// | D §4.10 | nothing | [`Attenuation::None`] |
/// | A (4.1) | `1/d` | constant 0, linear 1, quadratic 0 |
/// | A (4.2), B §7.3, C §1.8.3 D | `1/d²` | [`Attenuation::InverseSquare`] |
/// | A (4.3), C §1.8.3 D | `1/(a₀ + a₁ d + a₂ d²)` | [`Attenuation::Polynomial`] |
/// | C §1.8.3 D | `1/(d + d₀)` | constant d₀, linear 1, quadratic 0 |
/// | A ill. 67 | `min(1, 1/(a₀ + a₁ d + a₂ d²))` | the same, at most 1 |
///
/// Light that spreads over spheres thins out with `1/d²` and with nothing else; the other laws are made for the eye.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Attenuation {
    /// 1 at every distance.
    #[default]
    None,
    /// `1/d²` [m⁻²].
    InverseSquare,
    /// `1/(a₀ + a₁ d + a₂ d²)`, cut off at `most`; made by [`Attenuation::polynomial`].
    Polynomial { constant: f64, linear: f64, quadratic: f64, most: f64 },
}

impl Attenuation {
    /// `1/(a₀ + a₁ d + a₂ d²)`, without a cap.
    ///
    /// - Domain: finite coefficients ≥ 0, one of them above 0.
    /// - Errors: others.
    pub fn polynomial(coefficients: [f64; 3]) -> Result<Self, LightError> {
        if let Some(&found) = coefficients.iter().find(|a| !(a.is_finite() && **a >= 0.0)) {
            return Err(LightError::Negative { what: "coefficient of attenuation", found });
        }
        if coefficients == [0.0; 3] {
            return Err(LightError::NoAttenuation);
        }
        let [constant, linear, quadratic] = coefficients;
        Ok(Attenuation::Polynomial { constant, linear, quadratic, most: f64::INFINITY })
    }

    /// The same law, never above `most` (A's cap is 1).
    ///
    /// - Domain: `most > 0`. The law of no attenuation stays as it is.
    pub fn capped(self, most: f64) -> Self {
        debug_assert!(most > 0.0, "cap {most}");
        match self {
            Attenuation::None => self,
            Attenuation::InverseSquare => {
                Attenuation::Polynomial { constant: 0.0, linear: 0.0, quadratic: 1.0, most }
            }
            Attenuation::Polynomial { constant, linear, quadratic, .. } => {
                Attenuation::Polynomial { constant, linear, quadratic, most }
            }
        }
    }

    /// The factor at distance `d`.
    ///
    /// - Domain: `d ≥ 0`, also infinite. Laws that diverge at 0 give `+∞` there.
    /// - Accuracy: relative error ≤ `num::gamma(6)`: sums of positive terms. A square that leaves the range of numbers,
    ///   nearer than 10⁻¹⁵⁴ or farther than 10¹⁵⁴, gives `+∞` or 0.
    /// - NaN in, NaN out.
    #[inline]
    pub fn factor(self, d: f64) -> f64 {
        match self {
            Attenuation::None => 1.0,
            Attenuation::InverseSquare => 1.0 / (d * d),
            Attenuation::Polynomial { constant, linear, quadratic, most } => {
                // Horner's form, but that 0·∞ must not make NaN of a law without that term.
                let slope = if quadratic == 0.0 { linear } else { linear + quadratic * d };
                let sum = if slope == 0.0 { constant } else { constant + slope * d };
                let factor = 1.0 / sum;
                if factor > most { most } else { factor }
            }
        }
    }
}
