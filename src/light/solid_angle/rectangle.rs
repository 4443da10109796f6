//! What is seen of a rectangle.

use super::half_difference;
use crate::num::certified::power_of_two_below;
use glam::{DVec2, DVec3};

/// A rectangle as seen from a point: its solid angle, and its points uniform by solid angle.
///
/// Coordinates: `p` is the origin, `x` and `y` run along the sides, the rectangle `[x₀, x₁] × [y₀, y₁]` lies at distance `z`; mirrored if
/// need be, its centre has `x, y ≥ 0`. What lies between `x = 0` and `x` has a signed solid angle `T(x)`:
///
/// ```text
/// tan T = x z (y₁ r₀ − y₀ r₁) / (z² r₀ r₁ + x² y₀ y₁),    rᵢ = |(x, yᵢ, z)|                        (1)
/// x² = z² q (1 − q) / ((A − q)(B − q)),                    q = sin² T/2                            (2)
///      A = sin² ½(η₀ − η₁),  B = sin² ½(η₀ + η₁),  tan ηᵢ = z/yᵢ
/// y/√(x² + z²) = h/√(1 − h²),    h = h₀ + u_y (h₁ − h₀),   hᵢ = yᵢ/rᵢ                             (3)
/// ```
///
/// For `u_x`, `T = T(x₀) + u_x Ω`. Where `x₀ ≥ 0`, (2) would lose the digits `|T|/Ω`, so the difference from `x₀` is taken of (2) itself,
/// where it factors:
///
/// ```text
/// x² − x₀² = z² (q − q₀) (A B (1 − q)(1 − q₀) − (1 − A)(1 − B) q q₀) / ((A − q)(B − q)(A − q₀)(B − q₀))
/// ```
///
/// and in the same way for `y` in (3). Cosines of half angles stand by for `1 − q`, `1 − A`, `1 − B`; all is divided by `A` and `B`, which
/// may be tiny.
///
/// - Accuracy: `Ω` relative, about `32 u |r|/z`. Places on the sides are relative to the sides, however small `Ω` is.
/// - Source: Ureña, Fajardo & King, *An area-preserving parametrization for spherical rectangles*, EGSR (2013); (2) is its
///   construction in half angles. Where the receiver is beside the rectangle in both
///   directions, `Ω` is the sum of two triangles by Van Oosterom & Strackee (1983), else of two slices (1).
#[derive(Clone, Copy, Debug)]
pub struct SphericalRectangle {
    center: DVec3,
    half_width: DVec3,
    half_height: DVec3,
    solid_angle: f64,
    /// Half the sides; negative where mirrored.
    half: DVec2,
    low: DVec2,
    high: DVec2,
    z: f64,
    /// `y₁² − y₀²`
    gain: f64,
    start: HalfAngle,
    difference: HalfAngle,
    sum: HalfAngle,
    /// `1/√A` and `1/√B`
    over: DVec2,
    /// `1 − q₀/A` and `1 − q₀/B`, where `x₀ ≥ 0`
    start_beyond: DVec2,
}

/// Sine and cosine of half an angle in [−π, π].
#[derive(Clone, Copy, Debug)]
struct HalfAngle {
    sin: f64,
    cos: f64,
}

impl HalfAngle {
    /// Half of `atan2(y, x)`, both to relative accuracy.
    fn of(x: f64, y: f64) -> Self {
        let scale = power_of_two_below(x.abs().max(y.abs())).recip(); // exact
        let (x, y) = (x * scale, y * scale);
        let half_over_length = 0.5 / (x * x + y * y).sqrt();
        let larger = (0.5 + x.abs() * half_over_length).sqrt();
        let smaller = y.abs() * half_over_length / larger;
        let (sin, cos) = if x > 0.0 { (smaller, larger) } else { (larger, smaller) };
        HalfAngle { sin: sin.copysign(y), cos }
    }

    /// The whole angle from `self` on to `end`, where the two lie on either side of 0.
    fn to(self, end: HalfAngle) -> f64 {
        let sin = end.sin * self.cos - self.sin * end.cos;
        2.0 * sin.atan2(end.cos * self.cos + self.sin * end.sin)
    }

    /// `1 − sin² other / sin² self`, given `1 / sin self`.
    #[inline]
    fn share_beyond(self, other: HalfAngle, over_sin: f64) -> f64 {
        if other.sin.abs() < other.cos {
            let share = other.sin * over_sin;
            (1.0 - share) * (1.0 + share)
        } else {
            (other.cos - self.cos) * (other.cos + self.cos) * (over_sin * over_sin)
        }
    }
}

impl SphericalRectangle {
    /// The rectangle `center ± half_width ± half_height` as seen from `p`.
    ///
    /// - Domain: finite, the halves perpendicular. In the rectangle's plane, also on the rectangle, and without area: solid
    ///   angle 0.
    pub fn new(center: DVec3, half_width: DVec3, half_height: DVec3, p: DVec3) -> Self {
        let r = half_difference(center, p);
        let largest = r.abs().max(half_width.abs()).max(half_height.abs()).max_element();
        let scale = power_of_two_below(largest).recip(); // exact
        let (r, w, h) = (r * scale, half_width * scale * 0.5, half_height * scale * 0.5);
        let (a, b) = (w.length(), h.length());
        let (x_axis, y_axis) = (w * a.recip(), h * b.recip());
        let (x, y, z) = (r.dot(x_axis), r.dot(y_axis), r.dot(x_axis.cross(y_axis)).abs());
        let half = DVec2::new(a.copysign(x), b.copysign(y));
        let middle = DVec2::new(x.abs(), y.abs());
        let (low, high) = (middle - half.abs(), middle + half.abs());
        let distance = |x: f64, y: f64| (x * x + y * y + z * z).sqrt();
        let (r00, r01) = (distance(low.x, low.y), distance(low.x, high.y));
        let (r10, r11) = (distance(high.x, low.y), distance(high.x, high.y));
        let (z2, gain) = (z * z, 4.0 * b * middle.y);
        let volume = 4.0 * a * b * z;
        // Between the axis and a line across the rectangle, (1); in x, then the same in y.
        let slice = |x: f64, y: DVec2, gain: f64, r0: f64, r1: f64| {
            let across = x * z * across(y.x, y.y, gain, x * x + z2, r0, r1);
            HalfAngle::of(z2 * r0 * r1 + x * x * (y.x * y.y), across)
        };
        let in_y = DVec2::new(low.y, high.y);
        let start = slice(low.x, in_y, gain, r00, r01);
        let whole = if low.x < 0.0 {
            start.to(slice(high.x, in_y, gain, r10, r11))
        } else if low.y < 0.0 {
            let (in_x, gain) = (DVec2::new(low.x, high.x), 4.0 * a * middle.x);
            slice(low.y, in_x, gain, r00, r10).to(slice(high.y, in_x, gain, r01, r11))
        } else {
            // Two triangles on the diagonal 00–11, all cosines positive.
            let (xx, yy) = (low.x * high.x + z2, low.y * high.y + z2);
            let diagonal = low.x * high.x + yy;
            let below =
                r00 * r10 * r11 + (xx + low.y * low.y) * r11 + diagonal * r10 + (high.x * high.x + yy) * r00;
            let above =
                r00 * r01 * r11 + (low.x * low.x + yy) * r11 + diagonal * r01 + (xx + high.y * high.y) * r00;
            2.0 * (volume * (below + above)).atan2(below * above - volume * volume)
        };
        let difference = HalfAngle::of(low.y * high.y + z2, 2.0 * b * z);
        let sum = HalfAngle::of(low.y * high.y - z2, 2.0 * middle.y * z);
        let over = DVec2::new(difference.sin, sum.sin).recip();
        let beyond_sum = sum.share_beyond(start, over.y);
        // By (2), since x₀ knows how near q₀ is to A.
        let beyond = if low.x > 0.0 {
            let share = (start.sin * over.x) * over.y * start.cos * (z / low.x);
            share * share / beyond_sum
        } else {
            1.0
        };
        let start_beyond = DVec2::new(beyond, beyond_sum);
        let solid_angle = if volume > 0.0 && whole > 0.0 { whole } else { 0.0 };
        SphericalRectangle {
            center,
            half_width,
            half_height,
            solid_angle,
            half,
            low,
            high,
            z,
            gain,
            start,
            difference,
            sum,
            over,
            start_beyond,
        }
    }

    /// \[sr\], from 0 to 2π.
    pub fn solid_angle(&self) -> f64 {
        self.solid_angle
    }

    /// The point of the rectangle for a point `u` of the square: uniform by solid angle; by area where there is none. Lines of constant
    /// `u_x` are parallel to the height.
    #[inline]
    pub fn point(&self, u: DVec2) -> DVec3 {
        let place = 2.0 * if self.solid_angle > 0.0 { self.place(u) } else { u } - 1.0;
        self.center + self.half_width * place.x + self.half_height * place.y
    }

    /// Where along width and height.
    fn place(&self, u: DVec2) -> DVec2 {
        let mirrored = |half: f64, u: f64| if half.is_sign_negative() { 1.0 - u } else { u };
        let u = DVec2::new(mirrored(self.half.x, u.x), mirrored(self.half.y, u.y));
        let (x, along_x) = self.across_width(u.x);
        let along_y = self.across_height(u.y, x * x + self.z * self.z);
        let share = |along: f64, half: f64| {
            let share = along / (2.0 * half.abs());
            if share > 0.0 { share.min(1.0) } else { 0.0 } // 0/0 where side and place are nothing
        };
        DVec2::new(
            mirrored(self.half.x, share(along_x, self.half.x)),
            mirrored(self.half.y, share(along_y, self.half.y)),
        )
    }

    /// `x` and `x − x₀`.
    fn across_width(&self, u: f64) -> (f64, f64) {
        let (sin, cos) = (0.5 * u * self.solid_angle).sin_cos();
        let (start, difference, sum) = (self.start, self.difference, self.sum);
        let half = HalfAngle {
            sin: start.sin * cos + start.cos * sin,
            cos: (start.cos * cos - start.sin * sin).max(0.0),
        };
        let over = self.over;
        let beyond_sum = sum.share_beyond(half, over.y);
        let (low, high) = (self.low.x, self.high.x);
        if low < 0.0 {
            let beyond = difference.share_beyond(half, over.x);
            let x = self.z * (half.sin * over.x * over.y) * half.cos / (beyond * beyond_sum).sqrt();
            let x = x.max(low).min(high);
            return (x, x - low);
        }
        let square = |x: f64| x * x;
        let step = sin * (start.cos - start.sin * (sin / (1.0 + cos)));
        let growth = (step * over.x) * ((half.sin + start.sin) * over.x); // (q − q₀)/A
        let beyond = if half.sin < half.cos {
            self.start_beyond.x - growth
        } else {
            difference.share_beyond(half, over.x)
        };
        let bracket = square(half.cos * start.cos)
            - square(difference.cos * sum.cos * (half.sin * over.x) * (start.sin * over.y));
        let product = (beyond * beyond_sum) * (self.start_beyond.x * self.start_beyond.y);
        let gain = square(self.z * over.y) * growth * bracket / product;
        let x = (low * low + gain).sqrt().max(low).min(high);
        (x, gain / (x + low))
    }

    /// `y − y₀`, where `d2 = x² + z²`.
    fn across_height(&self, v: f64, d2: f64) -> f64 {
        let (low, high) = (self.low.y, self.high.y);
        let (r0, r1) = ((d2 + low * low).sqrt(), (d2 + high * high).sqrt());
        let rise = across(low, high, self.gain, d2, r0, r1) / (r0 * r1); // h₁ − h₀
        let (h0, gain) = (low / r0, v * rise);
        let h = h0 + gain;
        let less = d2 / (r1 * (r1 + high)) + (1.0 - v) * rise; // 1 − h
        if low < 0.0 {
            let more = d2 / (r0 * (r0 - low)) + gain; // 1 + h
            return h * (d2 / (less * more)).sqrt() - low;
        }
        let cos2 = less * (1.0 + h);
        gain * (h + h0) * (r0 * r0) / (cos2 * (h * (d2 / cos2).sqrt() + low))
    }
}

/// `y₁ r₀ − y₀ r₁` with `rᵢ² = d² + yᵢ²`, from positive terms; `gain = y₁² − y₀² ≥ 0`, which the two no longer tell of a narrow
/// rectangle far aside.
#[inline]
fn across(y0: f64, y1: f64, gain: f64, d2: f64, r0: f64, r1: f64) -> f64 {
    if y0 <= 0.0 { y1 * r0 - y0 * r1 } else { d2 * gain / (y1 * r0 + y0 * r1) }
}
