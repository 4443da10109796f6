//! XYZ, chromaticities, and the matrices that follow from three primaries and a white [C §1.7.5 C–D].

use super::Rgb;
use glam::{DMat3, DVec2, DVec3, dvec2, dvec3};

/// CIE 1931 tristimulus values; `Y` is the luminance. Light adds as these do.
pub type Xyz = DVec3;

/// The white of daylight screens.
pub const D65: DVec2 = dvec2(0.3127, 0.3290);
/// The white of equal energy at every wavelength.
pub const EQUAL_ENERGY: DVec2 = dvec2(1.0 / 3.0, 1.0 / 3.0);

/// Chromaticities of three lamps, and of the white they make at full power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Primaries {
    pub red: DVec2,
    pub green: DVec2,
    pub blue: DVec2,
    pub white: DVec2,
}

/// Linear maps between amounts of three primaries and XYZ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RgbSpace {
    pub xyz_from_rgb: DMat3,
    pub rgb_from_xyz: DMat3,
}

impl Primaries {
    /// Those of Rec. 709 and sRGB.
    pub const REC_709: Primaries =
        Primaries { red: dvec2(0.64, 0.33), green: dvec2(0.30, 0.60), blue: dvec2(0.15, 0.06), white: D65 };

    /// The primaries as corners of their gamut.
    pub fn corners(&self) -> [DVec2; 3] {
        [self.red, self.green, self.blue]
    }

    /// The matrices that send (1, 1, 1) to the white of luminance 1.
    ///
    /// ```text
    /// P = (r g b), columns (x, y, 1 − x − y);    P t = w / y_w;    xyz_from_rgb = P diag(t)
    /// ```
    ///
    /// - Domain: primaries not on one line, a white that needs all three of them and has `y ≠ 0`; else `None`.
    ///   Primaries with `y = 0`, as X and Z have, are allowed.
    /// - Accuracy: relative error of an entry about `γ₁₆` times the condition of `P`, which is 6 for Rec. 709.
    /// - Source: SMPTE RP 177 (1993); Lindbloom, *RGB/XYZ Matrices*.
    pub const fn space(&self) -> Option<RgbSpace> {
        let (r, g, b) = (homogeneous(self.red), homogeneous(self.green), homogeneous(self.blue));
        let w = scaled(homogeneous(self.white), 1.0 / self.white.y);
        // Cramer's rule: t = (w·(g×b), w·(b×r), w·(r×g)) / r·(g×b).
        let (gb, br, rg) = (cross(g, b), cross(b, r), cross(r, g));
        let det = dot(r, gb);
        let t = scaled(dvec3(dot(w, gb), dot(w, br), dot(w, rg)), 1.0 / det);
        // The rows of the inverse of P diag(t) are those of P⁻¹ over t.
        let (x, y, z) =
            (scaled(gb, 1.0 / (det * t.x)), scaled(br, 1.0 / (det * t.y)), scaled(rg, 1.0 / (det * t.z)));
        let xyz_from_rgb = DMat3::from_cols(scaled(r, t.x), scaled(g, t.y), scaled(b, t.z));
        let rgb_from_xyz = DMat3::from_cols(dvec3(x.x, y.x, z.x), dvec3(x.y, y.y, z.y), dvec3(x.z, y.z, z.z));
        if decided(r, g, b) && decided(w, g, b) && decided(w, b, r) && decided(w, r, g) {
            Some(RgbSpace { xyz_from_rgb, rgb_from_xyz })
        } else {
            None
        }
    }
}

const fn homogeneous(xy: DVec2) -> DVec3 {
    // From x first: 1 − x is exact for every x in [½, 1].
    dvec3(xy.x, xy.y, 1.0 - xy.x - xy.y)
}

/// Is the determinant other than 0 beyond its rounding error? Each of its six products meets 5 roundings on the way, and as
/// many before it in [`homogeneous`].
const fn decided(a: DVec3, b: DVec3, c: DVec3) -> bool {
    let (a1, b1, c1) = (magnitudes(a), magnitudes(b), magnitudes(c));
    let products = dvec3(b1.y * c1.z + c1.y * b1.z, b1.z * c1.x + c1.z * b1.x, b1.x * c1.y + c1.x * b1.y);
    let det = dot(a, cross(b, c));
    det.is_finite() && det.abs() > 10.0 * f64::EPSILON * 0.5 * dot(a1, products)
}

const fn magnitudes(v: DVec3) -> DVec3 {
    dvec3(v.x.abs(), v.y.abs(), v.z.abs())
}

const fn scaled(v: DVec3, k: f64) -> DVec3 {
    dvec3(v.x * k, v.y * k, v.z * k)
}

const fn dot(a: DVec3, b: DVec3) -> f64 {
    a.x * b.x + a.y * b.y + a.z * b.z
}

const fn cross(a: DVec3, b: DVec3) -> DVec3 {
    dvec3(a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y)
}

/// The space of our linear RGB.
///
/// The standard (IEC 61966-2-1) prints 4 digits of each matrix; its two roundings are not inverse to each other, and
/// a colour that goes there and back moves by up to 4e-5.
pub const SRGB: RgbSpace = match Primaries::REC_709.space() {
    Some(space) => space,
    None => panic!("the primaries of Rec. 709 enclose their white"),
};

/// Tristimulus values of a linear colour; white (1, 1, 1) has `Y = 1`.
///
/// - Domain: up to 1e300 in size, beyond which sums overflow; negative channels stand for colours outside the gamut.
/// - Accuracy: `γ₂₀ · 6` relative to the value of `|rgb|`.
/// - NaN goes through.
/// - Source: [`Primaries::space`].
pub fn xyz_from_rgb(rgb: Rgb) -> Xyz {
    SRGB.xyz_from_rgb * rgb
}

/// The linear colour with those tristimulus values, the inverse of [`xyz_from_rgb`]. Colours outside the gamut have
/// negative channels; [`super::gamut`] brings them in.
///
/// - Domain: up to 1e300 in size.
/// - Accuracy: `γ₂₀ · 6` relative to the sum of the terms' sizes.
/// - NaN goes through.
/// - Source: [`Primaries::space`].
pub fn rgb_from_xyz(xyz: Xyz) -> Rgb {
    SRGB.rgb_from_xyz * xyz
}

/// Share of each linear channel in the luminance: the `Y` row of [`SRGB`]. The standard prints 0.2126, 0.7152, 0.0722.
pub const LUMINANCE: Rgb =
    dvec3(SRGB.xyz_from_rgb.x_axis.y, SRGB.xyz_from_rgb.y_axis.y, SRGB.xyz_from_rgb.z_axis.y);

/// Luminance `Y` of a linear colour, in the unit of its channels: white (1, 1, 1) has 1.
///
/// ```text
/// Y = 0.2126 r + 0.7152 g + 0.0722 b
/// ```
///
/// - Domain: up to 1e300 in size; negative channels count negatively.
/// - Accuracy: `γ₂₀ · 6` relative to `Y(|rgb|)`.
/// - NaN goes through.
/// - Source: ITU-R BT.709-6 (2015); weights from the primaries (SMPTE RP 177, 1993).
pub fn luminance(rgb: Rgb) -> f64 {
    LUMINANCE.dot(rgb)
}

/// The luminance as C's text before equation (12) has it: `X + Y + Z`.
///
/// Luminance is `Y` alone; this sum counts a blue of 450 nm 56 times.
///
/// - Source: [C §1.7.5 C], an erratum.
pub fn luminance_as_printed(xyz: Xyz) -> f64 {
    xyz.element_sum()
}

/// A chromaticity with a luminance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Xyy {
    pub xy: DVec2,
    /// `Y`, in the unit of XYZ.
    pub luminance: f64,
}

/// Chromaticity and luminance of tristimulus values [C (12)].
///
/// ```text
/// x = X / (X + Y + Z),    y = Y / (X + Y + Z)
/// ```
///
/// - Domain: finite; `None` where the sum is 0 (black has no chromaticity) or not finite.
/// - Accuracy: relative error ≤ `γ₃` for values of one sign; the sum of imaginary colours may cancel.
/// - Source: CIE 015:2018.
pub fn xyy_from_xyz(xyz: Xyz) -> Option<Xyy> {
    let sum = xyz.element_sum();
    let xy = if sum.is_finite() {
        xyz.truncate() / sum
    } else {
        // The sum of three huge numbers overflows; a quarter of each does not.
        xyz.truncate() * 0.25 / (xyz * 0.25).element_sum()
    };
    xy.is_finite().then_some(Xyy { xy, luminance: xyz.y })
}

/// Tristimulus values of a chromaticity and a luminance, the inverse of [`xyy_from_xyz`].
///
/// ```text
/// X = x Y / y,    Z = (1 − x − y) Y / y
/// ```
///
/// - Domain: finite; luminance 0 is black whatever the chromaticity; `None` where `y = 0` and `Y ≠ 0`, or where the
///   quotient leaves the range of numbers.
/// - Accuracy: relative error of X ≤ `γ₂`, of Z ≤ `γ₄ (1 + |x| + |y|) / |1 − x − y|`.
/// - Source: CIE 015:2018.
pub fn xyz_from_xyy(Xyy { xy, luminance }: Xyy) -> Option<Xyz> {
    if luminance == 0.0 && xy.is_finite() {
        return Some(Xyz::ZERO);
    }
    let k = luminance / xy.y;
    let xyz = dvec3(xy.x * k, luminance, (1.0 - xy.x - xy.y) * k);
    (k.is_finite() && xyz.is_finite()).then_some(xyz)
}
