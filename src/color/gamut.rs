//! What three lamps can make, and two ways to bring in what they cannot [C §1.7.5 D].
//!
//! Light adds in XYZ, so a mixture lies on the straight line between its parts, and three lamps make a
//! triangle of the chromaticity diagram. No triangle with corners inside a curved outline fills it.

use super::dominant::Locus;
use super::{Rgb, luminance};
use glam::DVec2;

/// How a colour with negative channels is brought into the gamut.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum IntoGamut {
    /// Mixed with the grey of its own luminance until no channel is negative: keeps luminance and dominant wavelength,
    /// gives up purity.
    #[default]
    Desaturate,
    /// Negative channels become 0: adds light, and turns the hue.
    Clip,
}

impl IntoGamut {
    pub const ALL: [IntoGamut; 2] = [IntoGamut::Desaturate, IntoGamut::Clip];

    pub fn name(self) -> &'static str {
        match self {
            IntoGamut::Desaturate => "desaturate towards white",
            IntoGamut::Clip => "clip negative channels",
        }
    }

    /// The colour with no channel below 0. Channels above 1 are left to the tone map.
    ///
    /// ```text
    /// desaturate: Y + s (rgb − Y),  s = Y / (Y − min)      clip: max(rgb, 0)
    /// ```
    ///
    /// - Domain: channels up to 1e300 in size; colours of the gamut come back as they are. A colour with negative channels and luminance
    ///   ≤ 0 is no light at all: desaturated it is black.
    /// - Accuracy: `γ₆ · max|rgb|`; the smallest channel becomes exactly 0.
    /// - NaN goes through.
    /// - Source: mixing with white is Grassmann's law (1853); named in Hall, *Illumination and Color in Computer
    ///   Generated Imagery* (1989) §5.4.
    pub fn apply(self, rgb: Rgb) -> Rgb {
        let min = rgb.min_element();
        if rgb.is_nan() || min >= 0.0 {
            return rgb;
        }
        match self {
            IntoGamut::Clip => rgb.max(Rgb::ZERO),
            IntoGamut::Desaturate => {
                let y = luminance(rgb);
                if y <= 0.0 {
                    return Rgb::ZERO;
                }
                let keep = y / (y - min);
                rgb.map(|c| if c == min { 0.0 } else { (y + keep * (c - y)).max(0.0) })
            }
        }
    }
}

/// Area of a polygon of the diagram.
///
/// - Accuracy: `γ_{n+3}` times the sum of its triangles' sizes, seen from the first corner.
/// - Source: Gauss' formula.
pub fn area(corners: &[DVec2]) -> f64 {
    let Some((first, rest)) = corners.split_first() else { return 0.0 };
    let twice: f64 = rest.windows(2).map(|w| (w[0] - first).perp_dot(w[1] - first)).sum();
    twice.abs() / 2.0
}

/// Is the chromaticity in the triangle, or on its edge?
pub fn in_triangle([a, b, c]: [DVec2; 3], xy: DVec2) -> bool {
    let sides = [(a, b), (b, c), (c, a)].map(|(p, q)| (q - p).perp_dot(xy - p));
    sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0)
}

/// The wavelengths \[nm\] of the three lines whose triangle is the largest in the diagram.
///
/// All triples of the locus' points are tried, `n³/6` of them.
pub fn largest_triangle(locus: &Locus) -> [f64; 3] {
    let points = locus.points();
    let (mut best, mut corners) = (-1.0, [0; 3]);
    for i in 0..points.len() {
        for j in i + 1..points.len() {
            let side = points[j] - points[i];
            for k in j + 1..points.len() {
                let twice = side.perp_dot(points[k] - points[i]).abs();
                if twice > best {
                    (best, corners) = (twice, [i, j, k]);
                }
            }
        }
    }
    corners.map(|i| locus.wavelength(i))
}
