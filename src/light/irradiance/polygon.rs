//! A flat polygon: Lambert's formula, without its cancellation.

use super::touching::{Standing, standing};
use super::{cross, height, length, rounded, seen_from};
use crate::num::certified::power_of_two_below;
use crate::num::double_double::DoubleDouble;
use crate::num::real::{Triple, dot};
use glam::DVec3;
use std::f64::consts::PI;

/// Irradiance [W m⁻²] at `p`, with unit normal `n`, from a flat convex polygon of radiance 1 that emits to both sides.
///
/// Seen from `p`, with `r` for corners relative to it, each edge spans a triangle of angle `θ`:
///
/// ```text
/// 2E = Σ θ n·(r × r′)/|r × r′|                                                          (Lambert)   (1)
///    = Σ f n·(r × r′) = f₀ n·Σ(r × r′) + Σ (f − f₀) n·(r × r′),    f = (θ/sin θ)/(|r||r′|)           (2)
/// ```
///
/// over the edges of what is above the horizon. The terms of (1) are as large as the polygon is wide, `δ`, and sum to
/// `δ²`: a far lamp loses the digits `u/δ`. In (2), `f₀ = 1/|r₀|²` takes the sum of the cross products, an area that the places
/// `q = r − r₀` on the polygon make alone, and `f − f₀`, itself of order `δ`, is made from `|r|² − |r₀|² = q·(q + 2r₀)` and from the series
/// of `θ/sin θ − 1`: no term is larger than `δ²`. It is used where the polygon lies within `|r₀|/4` of its first corner.
///
/// - Domain: finite vertices in order, either way round, of a convex polygon; `n` of any length but 0 counts as normalised.
///   Fewer than three vertices, no area, or `n = 0`: 0. In the polygon's plane, beside it: 0, exactly. On it, the limit
///   from `p + ε n`: with the angle `γ` between `n` and the polygon's normal `π (1 − |cos γ|)/2` in its interior, which is
///   0 for a receiver that looks away, and the corresponding part at an edge or a vertex.
/// - Accuracy: where (2) is used 16 u of `δ²`, the square of the largest angle between corners: relative to E but for slivers and grazing
///   angles. Elsewhere 4 u per edge, absolute. Off the plane, but within 10⁻¹⁷ of the length of an edge that crosses the horizon, where it crosses is
///   known to 10⁻³² of that length only.
/// - NaN: out if any number is NaN or infinite.
/// - Source: Lambert, *Photometria* (1760); Baum, Rushmeier & Winget, SIGGRAPH (1989), for the form with cross products.
pub fn polygon_irradiance(vertices: &[DVec3], p: DVec3, n: DVec3) -> f64 {
    if !(p.is_finite() && n.is_finite() && vertices.iter().all(|v| v.is_finite())) {
        return f64::NAN;
    }
    if vertices.len() < 3 || n == DVec3::ZERO {
        return 0.0;
    }
    let largest = vertices.iter().fold(p.abs(), |m, v| m.max(v.abs())).max_element();
    let unit = power_of_two_below(largest);
    let n = n / power_of_two_below(n.abs().max_element());
    let side = match standing(vertices, p, n, unit) {
        Standing::Beside(side) => side,
        Standing::Within(irradiance) => return irradiance,
    };
    let corner = |v: DVec3| Corner::new(seen_from(v, p, unit), rounded(seen_from(v, vertices[0], unit)), n);
    let first = corner(vertices[0]);
    let mut edges = Edges::new(vertices, &first, unit, n, side);
    let mut a = first;
    for k in 0..vertices.len() {
        let b = if k + 1 < vertices.len() { corner(vertices[k + 1]) } else { first };
        if a.height.high >= 0.0 {
            edges.to(a);
        }
        if a.height.high * b.height.high < 0.0 {
            edges.to(Corner::between(&a, &b));
        }
        a = b;
    }
    (0.5 * side * edges.close() / n.length()).clamp(0.0, PI)
}

/// A corner as `p` sees it.
#[derive(Clone, Copy)]
struct Corner {
    r: Triple<DoubleDouble>,
    /// From the first corner of the polygon.
    q: DVec3,
    /// Above the horizon, times `|n|`.
    height: DoubleDouble,
}

impl Corner {
    fn new(r: Triple<DoubleDouble>, q: DVec3, n: DVec3) -> Self {
        Corner { r, q, height: height(n, r) }
    }

    /// Where the edge between a corner above the horizon and one below it crosses the horizon.
    fn between(a: &Self, b: &Self) -> Self {
        let t = a.height / (a.height - b.height);
        let r = [0, 1, 2].map(|i| a.r[i] + (b.r[i] - a.r[i]) * t);
        Corner { r, q: a.q + (b.q - a.q) * t.value(), height: DoubleDouble::ZERO }
    }
}

/// The sum (2) along a chain of corners.
struct Edges {
    n: DVec3,
    /// 1 if the corners run to the left, seen from `p`, else −1.
    side: f64,
    /// `r₀` of a polygon that is small as seen from here; `None` sums by (1).
    reference: Option<DVec3>,
    start: Option<Corner>,
    /// Is anything above the horizon, and not just in it?
    rises: bool,
    last: Option<Corner>,
    /// `n·Σ(r × r′) = n·Σ(q × q′)`.
    moments: f64,
    rest: f64,
}

impl Edges {
    fn new(vertices: &[DVec3], first: &Corner, unit: f64, n: DVec3, side: f64) -> Self {
        // What is clipped lies in the same ball.
        let far = |v: &DVec3| (*v / unit - vertices[0] / unit).length_squared();
        let widest = vertices.iter().map(far).fold(0.0, f64::max);
        let r = rounded(first.r);
        let reference = (16.0 * widest <= r.length_squared()).then_some(r);
        Edges { n, side, reference, start: None, rises: false, last: None, moments: 0.0, rest: 0.0 }
    }

    fn to(&mut self, corner: Corner) {
        self.rises |= corner.height.high > 0.0;
        if let Some(last) = self.last.replace(corner) {
            self.add(&last, &corner);
        } else {
            self.start = Some(corner);
        }
    }

    fn close(mut self) -> f64 {
        if let (Some(last), Some(start)) = (self.last, self.start) {
            self.add(&last, &start);
        }
        if !self.rises {
            return 0.0;
        }
        match self.reference {
            Some(r) => self.moments / r.length_squared() + self.rest,
            None => self.rest,
        }
    }

    fn add(&mut self, a: &Corner, b: &Corner) {
        match self.reference {
            Some(r) => self.add_to_second_order(a, b, r),
            None => self.add_by_lambert(a, b),
        }
    }

    /// One term of (1).
    fn add_by_lambert(&mut self, a: &Corner, b: &Corner) {
        let c = cross(a.r, b.r);
        let sine = length(rounded(c)); // times |r||r′|
        if sine == 0.0 {
            return;
        }
        // An edge in the horizon has the normal n itself, also where it all but passes through p.
        let in_horizon = a.height == DoubleDouble::ZERO && b.height == DoubleDouble::ZERO;
        let facing = if in_horizon { self.side * self.n.length() } else { height(self.n, c).value() / sine };
        self.rest += sine.atan2(dot(a.r, b.r).value()) * facing;
    }

    /// One term of each sum of (2).
    fn add_to_second_order(&mut self, a: &Corner, b: &Corner, first: DVec3) {
        let (ra, rb) = (rounded(a.r), rounded(b.r));
        let c = ra.cross(b.q - a.q);
        let (square, distance) = (first.length_squared(), first.length());
        let (da, db) = (ra.length(), rb.length());
        // |r| − |r₀|
        let longer = |q: DVec3, d: f64| q.dot(q + 2.0 * first) / (d + distance);
        let excess = longer(a.q, da) * db + distance * longer(b.q, db);
        let area = da * db;
        let change = (arc_over_sine_excess(c.length() / area) * square - excess) / (area * square);
        self.moments += self.n.dot(a.q.cross(b.q));
        self.rest += change * self.n.dot(c);
    }
}

/// `θ/sin θ − 1` for `0 ≤ θ ≤ π/2` by its sine.
///
/// - Accuracy: below `sin θ = 1/16` the series of `asin(s)/s` to `s¹²`; the next term, `0.014 s¹⁴`, is at most `2⁻⁵⁰` of the sum.
///   Above it the difference of 1, `2 u` absolute, which a polygon as wide as that does not feel.
fn arc_over_sine_excess(sine: f64) -> f64 {
    if sine > 1.0 / 16.0 {
        return sine.min(1.0).asin() / sine - 1.0;
    }
    const SERIES: [f64; 6] =
        [1.0 / 6.0, 3.0 / 40.0, 5.0 / 112.0, 35.0 / 1152.0, 63.0 / 2816.0, 231.0 / 13312.0];
    let s2 = sine * sine;
    SERIES.iter().rev().fold(0.0, |sum, c| (sum + c) * s2)
}
