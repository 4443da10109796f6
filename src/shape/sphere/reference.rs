//! Where a line truly meets a sphere: some digits beyond `f64`, without a longer arithmetic.

/// A line and a sphere, measured so that nothing of the size `|f|²` is ever subtracted.
///
/// ```text
/// t_ca = −f·d / d·d,    b = |f × d| / |d|,    h = √((r − b)(r + b)) / |d|,    t = t_ca ∓ h
/// ```
///
/// The scalar products are kept in two numbers each, and the differences in `f × d` are rounded once; so `b`
/// is known to a few roundings of `b` itself, whatever the distance, and `t_ca` to a few of `u t_ca`'s last place.
///
/// - Domain: finite input, `d ≠ 0`, squares that neither overflow nor vanish.
/// - Accuracy: `t_ca` relative 4 u² (condition of `f·d`) ; `b` relative `γ₈`; `h` absolute `γ₁₂ (h + b²/h)`.
/// - Source: Ogita, Rump & Oishi, *Accurate Sum and Dot Product* (2005); Kahan's difference of products,
///   analysed by Jeannerod, Louvet & Muller (2013).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    /// Parameter of the closest point, as an unevaluated sum of a large and a small number.
    closest: (f64, f64),
    /// Distance of the line from the centre: the impact parameter.
    pub impact: f64,
    /// Half of the chord [lengths of `d`]; `None` if the line misses.
    pub half_chord: Option<f64>,
}

impl Meeting {
    /// `f` from the centre to the origin of the ray, `d` its direction, `r` the radius.
    pub fn of(f: [f64; 3], d: [f64; 3], r: f64) -> Self {
        let (fd, dd) = (dot(f, d), dot(d, d));
        let large = -fd.0 / dd.0;
        // What the quotient left over: −f·d − large (d·d), exact in its leading part.
        let left = (-large).mul_add(dd.0, -fd.0) - fd.1 - large * dd.1;
        let cross: [f64; 3] = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| difference(f[i], d[j], f[j], d[i]));
        let speed = dd.0.sqrt();
        let impact = (cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]).sqrt() / speed;
        let half_chord = (impact <= r).then(|| ((r - impact) * (r + impact)).sqrt() / speed);
        Meeting { closest: (large, left / dd.0), impact, half_chord }
    }

    /// Both parameters, rounded to `f64`.
    pub fn roots(&self) -> Option<(f64, f64)> {
        let h = self.half_chord?;
        Some((self.closest.0 + (self.closest.1 - h), self.closest.0 + (self.closest.1 + h)))
    }

    /// `t − t₀`: how far a found parameter lies behind the entering point; `None` if the line misses.
    pub fn behind_first(&self, t: f64) -> Option<f64> {
        self.half_chord.map(|h| (t - self.closest.0) + (h - self.closest.1))
    }

    /// `t − t₁`: how far a found parameter lies behind the leaving point; `None` if the line misses.
    pub fn behind_second(&self, t: f64) -> Option<f64> {
        self.half_chord.map(|h| (t - self.closest.0) - (h + self.closest.1))
    }
}

/// `a·b` as a large and a small number.
fn dot(a: [f64; 3], b: [f64; 3]) -> (f64, f64) {
    let (mut sum, mut small) = (0.0f64, 0.0f64);
    for i in 0..3 {
        let product = a[i] * b[i];
        let next = sum + product;
        let back = next - sum;
        // What the product and the sum have rounded away.
        small += a[i].mul_add(b[i], -product) + ((sum - (next - back)) + (product - back));
        sum = next;
    }
    (sum, small)
}

/// `a b − c e`, with an error of at most 1.5 units in the last place.
fn difference(a: f64, b: f64, c: f64, e: f64) -> f64 {
    let product = c * e;
    a.mul_add(b, -product) + (-c).mul_add(e, product)
}
