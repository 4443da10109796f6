//! What a reflection model asks about a pair of directions, in forms that do not cancel.
//!
//! The cosine of a small angle has no digits left for the angle: `1 − cos²θ` of a direction 10⁻⁸ off the
//! mirror's is rounding. So models ask for versines `1 − cos` and squared sines, and each way to describe
//! a pair, by vectors or by angles, computes those from what it has:
//!
//! ```text
//! vectors:  1 − cos a = |wi − mirror(wo)|²/2,    sin²d = |wi − wo|²/4,    sin²θₕ = |tangential part of wi + wo|² / (4 cos²d)
//! angles:   1 − cos a = 2 sin²((θᵢ − θₒ)/2) + 2 sin θᵢ sin θₒ cos²(φ/2)
//!           cos²d     =   cos²((θᵢ + θₒ)/2) + sin θᵢ sin θₒ cos²(φ/2),    cos((θᵢ + θₒ)/2) = (cos θᵢ + cos θₒ) / (2 cos((θᵢ − θₒ)/2))
//! ```
//!
//! `a` is the angle between `wi` and the mirror direction of `wo`, `θₕ` that of the half vector with the normal,
//! `d` that of either direction with the half vector. Every term is positive; nothing cancels but the vectors
//! themselves, and that is exact to the digits they have.

use glam::DVec3;

/// The half vector's angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Half {
    pub cos_h: f64,
    pub sin2_h: f64,
    /// Cosine of the angle between either direction and the half vector.
    pub cos_d: f64,
    /// `1 − cos_d`.
    pub versine_d: f64,
}

impl Half {
    /// From the squares and the two heights.
    fn of(cos2_d: f64, sin2_d: f64, sum_of_cosines: f64, tangential2: f64) -> Self {
        let cos_d = cos2_d.sqrt();
        if cos_d == 0.0 {
            // Opposite in the horizon, but for heights whose squares vanish: the half vector is the normal.
            return Half { cos_h: 1.0, sin2_h: 0.0, cos_d: 0.5 * sum_of_cosines, versine_d: 1.0 };
        }
        let cos_h = at_most_one(0.5 * sum_of_cosines / cos_d);
        let sin2_h = at_most_one(0.25 * tangential2 / cos2_d);
        Half { cos_h, sin2_h, cos_d: at_most_one(cos_d), versine_d: sin2_d / (1.0 + cos_d) }
    }

    /// `ln cos θₕ`, from whichever of sine and cosine is small; −∞ in the horizon.
    #[inline]
    pub fn log_cos_h(&self) -> f64 {
        if self.sin2_h < 0.5 { 0.5 * (-self.sin2_h).ln_1p() } else { self.cos_h.ln() }
    }
}

/// Cuts off what rounding has added; NaN goes through, which `f64::min` would swallow.
#[inline]
fn at_most_one(x: f64) -> f64 {
    if x > 1.0 { 1.0 } else { x }
}

/// A pair of directions above the horizon.
pub trait Geometry {
    fn cos_i(&self) -> f64;
    fn cos_o(&self) -> f64;
    fn sin_i(&self) -> f64;
    fn sin_o(&self) -> f64;
    /// Angles with the normal \[rad\].
    fn theta_i(&self) -> f64;
    fn theta_o(&self) -> f64;
    /// Cosine of the difference of azimuths; 0 where one of them is the normal.
    fn cos_phi(&self) -> f64;
    /// Squared sine of that difference.
    fn sin2_phi(&self) -> f64;
    /// Cosine of the angle `a` between `wi` and the mirror direction of `wo`.
    #[inline]
    fn mirror_cosine(&self) -> f64 {
        let p = self.product();
        p.z - (p.x + p.y)
    }
    /// `1 − cos a`.
    fn mirror_versine(&self) -> f64;
    fn half(&self) -> Half;
    /// `wi` times `wo`, coordinate by coordinate.
    fn product(&self) -> DVec3;
}

/// Unit vectors in the local frame: what rays have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Directions {
    pub wi: DVec3,
    pub wo: DVec3,
}

impl Geometry for Directions {
    #[inline]
    fn cos_i(&self) -> f64 {
        self.wi.z
    }
    #[inline]
    fn cos_o(&self) -> f64 {
        self.wo.z
    }
    #[inline]
    fn sin_i(&self) -> f64 {
        sin_theta(self.wi)
    }
    #[inline]
    fn sin_o(&self) -> f64 {
        sin_theta(self.wo)
    }
    #[inline]
    fn theta_i(&self) -> f64 {
        self.sin_i().atan2(self.wi.z)
    }
    #[inline]
    fn theta_o(&self) -> f64 {
        self.sin_o().atan2(self.wo.z)
    }
    #[inline]
    fn cos_phi(&self) -> f64 {
        let (i, o) = (self.wi.truncate().normalize_or_zero(), self.wo.truncate().normalize_or_zero());
        i.dot(o).clamp(-1.0, 1.0)
    }
    #[inline]
    fn sin2_phi(&self) -> f64 {
        let (i, o) = (self.wi.truncate().normalize_or_zero(), self.wo.truncate().normalize_or_zero());
        let sin = i.perp_dot(o);
        sin * sin
    }
    #[inline]
    fn mirror_versine(&self) -> f64 {
        0.5 * (self.wi - mirror(self.wo)).length_squared()
    }
    #[inline]
    fn half(&self) -> Half {
        let (sum, difference) = (self.wi + self.wo, self.wi - self.wo);
        Half::of(
            0.25 * sum.length_squared(),
            0.25 * difference.length_squared(),
            sum.z,
            sum.truncate().length_squared(),
        )
    }
    #[inline]
    fn product(&self) -> DVec3 {
        self.wi * self.wo
    }
}

/// The mirror direction of `w`, in the local frame.
#[inline]
pub fn mirror(w: DVec3) -> DVec3 {
    DVec3::new(-w.x, -w.y, w.z)
}

/// Sine of the angle with the normal.
#[inline]
pub fn sin_theta(w: DVec3) -> f64 {
    (w.x * w.x + w.y * w.y).sqrt()
}

/// Angles \[rad\]: what tables and diagrams have. The mirror direction lies at `φ = π`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angles {
    theta_i: f64,
    theta_o: f64,
    phi: f64,
    sin_i: f64,
    cos_i: f64,
    sin_o: f64,
    cos_o: f64,
}

impl Angles {
    /// - Domain: `0 ≤ theta ≤ π/2`, any `phi`, the difference of azimuths.
    pub fn new(theta_i: f64, theta_o: f64, phi: f64) -> Self {
        let ((sin_i, cos_i), (sin_o, cos_o)) = (theta_i.sin_cos(), theta_o.sin_cos());
        Angles { theta_i, theta_o, phi, sin_i, cos_i, sin_o, cos_o }
    }

    /// The directions, `wo` at azimuth 0.
    pub fn directions(&self) -> Directions {
        let (sin, cos) = self.phi.sin_cos();
        Directions {
            wi: DVec3::new(self.sin_i * cos, self.sin_i * sin, self.cos_i),
            wo: DVec3::new(self.sin_o, 0.0, self.cos_o),
        }
    }

    /// `sin θᵢ sin θₒ cos²(φ/2)` and the same with `sin²(φ/2)`.
    fn sines(&self) -> (f64, f64) {
        let (sin, cos) = (0.5 * self.phi).sin_cos();
        let both = self.sin_i * self.sin_o;
        (both * cos * cos, both * sin * sin)
    }
    /// Sine of `(θᵢ − θₒ)/2`, cosine of `(θᵢ + θₒ)/2`: a sum of angles near 90° would be rounded to their digits, not
    /// to those of what is missing.
    fn half_angles(&self) -> (f64, f64) {
        let (sin, cos) = (0.5 * (self.theta_i - self.theta_o)).sin_cos();
        (sin, 0.5 * (self.cos_i + self.cos_o) / cos)
    }
}

impl Geometry for Angles {
    fn cos_i(&self) -> f64 {
        self.cos_i
    }
    fn cos_o(&self) -> f64 {
        self.cos_o
    }
    fn sin_i(&self) -> f64 {
        self.sin_i
    }
    fn sin_o(&self) -> f64 {
        self.sin_o
    }
    fn theta_i(&self) -> f64 {
        self.theta_i
    }
    fn theta_o(&self) -> f64 {
        self.theta_o
    }
    fn cos_phi(&self) -> f64 {
        if self.sin_i * self.sin_o > 0.0 { self.phi.cos() } else { 0.0 }
    }
    fn sin2_phi(&self) -> f64 {
        let sin = self.phi.sin();
        sin * sin
    }
    fn mirror_versine(&self) -> f64 {
        let s = self.half_angles().0;
        2.0 * (s * s + self.sines().0)
    }
    fn half(&self) -> Half {
        let ((s, c), (along, across)) = (self.half_angles(), self.sines());
        // sin θᵢ − sin θₒ = 2 cos((θᵢ + θₒ)/2) sin((θᵢ − θₒ)/2)
        let tangential2 = 4.0 * (c * s * c * s + along);
        Half::of(c * c + along, s * s + across, self.cos_i + self.cos_o, tangential2)
    }
    fn product(&self) -> DVec3 {
        DVec3::new(self.sin_i * self.sin_o * self.phi.cos(), 0.0, self.cos_i * self.cos_o)
    }
}
