//! Orthonormal bases, rotations, and what they do to normals [B §4, §5.3].

use crate::num::certified::power_of_two_below;
use crate::num::double_double::difference_of_products;
use crate::num::expansion::Expansion;
use crate::num::gamma;
use crate::num::real::{Real, Triple};
use glam::{DMat3, DVec3, Vec3Swizzles};

/// Right, up and forward: unit vectors, pairwise perpendicular, `right × up = −forward`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    pub right: DVec3,
    pub up: DVec3,
    pub forward: DVec3,
}

/// Why there is no frame.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FrameError {
    #[error("position and target are the same point {0}: there is no direction to look in")]
    NoDirection(DVec3),
    #[error("position, target and up must be finite, found {0}")]
    NotFinite(DVec3),
}

/// Length at which a cross product of unit vectors is mostly rounding: its direction is then
/// not known to half the digits.
const PARALLEL: f64 = 1.0e-8; // ≈ √u: the error u/|r| of the direction r exceeds |r| itself

impl Frame {
    /// The frame of a viewer at `eye` who looks at `target`.
    ///
    /// ```text
    /// f = (t − e)/|t − e|,   r = (f × up)/|f × up|,   u = r × f
    /// ```
    ///
    /// - Where `up` is zero or parallel to the view, `r` does not exist [B §5.3.2]; the frame
    ///   of [`Frame::around`] is taken instead, which is continuous in `f` almost everywhere.
    /// - Accuracy: error of `r` and `u` ≤ a few u / sin∠(f, up).
    /// - Source: [B §5.3], with `right` normalised (see the errata).
    pub fn look_at(eye: DVec3, target: DVec3, up: DVec3) -> Result<Self, FrameError> {
        for v in [eye, target, up] {
            if !v.is_finite() {
                return Err(FrameError::NotFinite(v));
            }
        }
        let Some(forward) = unit(half_difference(target, eye)) else {
            return Err(FrameError::NoDirection(eye));
        };
        let right = unit(up).map(|up| forward.cross(up)).filter(|r| r.length() > PARALLEL).and_then(unit);
        Ok(match right {
            Some(right) => Frame { right, up: right.cross(forward), forward },
            None => Self::around(forward),
        })
    }

    /// Some frame with this unit `forward`, by [`basis`].
    pub fn around(forward: DVec3) -> Self {
        let (right, down) = basis(forward);
        Frame { right, up: -down, forward }
    }
}

fn half_difference(a: DVec3, b: DVec3) -> DVec3 {
    a * 0.5 - b * 0.5 // halves, so that the difference of two large points does not overflow
}

/// The unit vector along `v`, however long or short; `None` for the zero vector and those that are not finite.
///
/// - Accuracy: each coordinate to 4 u: the scale is a power of two, hence exact.
pub fn unit(v: DVec3) -> Option<DVec3> {
    let scale = power_of_two_below(v.abs().max_element());
    let scaled = v / scale;
    let length = scaled.length();
    (length > 0.0 && length.is_finite()).then(|| scaled / length)
}

/// Two unit vectors that make a right-handed basis with the unit vector `n`: `x × y = n`.
///
/// - Accuracy: orthonormal to 4 u, for every direction.
/// - Source: Duff et al., *Building an Orthonormal Basis, Revisited*, JCGT 6(1) (2017).
#[inline]
pub fn basis(n: DVec3) -> (DVec3, DVec3) {
    let (x, y) = duff(n.to_array());
    (DVec3::from_array(x), DVec3::from_array(y))
}

/// [`basis`] in any arithmetic: the pole at which Frisvad's fraction grows moves to the other side of the sphere,
/// so that `|sign + z| ≥ 1`.
///
/// ```text
/// a = −1/(s + z),  b = x y a,    (1 + s x² a, s b, −s x),  (b, s + y² a, −y),    s = ±1 with the sign of z
/// ```
#[inline]
pub fn duff<R: Real>([x, y, z]: Triple<R>) -> (Triple<R>, Triple<R>) {
    let one = R::from_f64(1.0);
    let sign = one.with_sign_of(z);
    let a = -one / (sign + z);
    let b = x * y * a;
    ([one + sign * x * x * a, sign * b, -(sign * x)], [b, sign + y * y * a, -y])
}

/// The basis that [`basis`] replaced: one fraction for all directions, and a patch at its pole.
///
/// ```text
/// a = 1/(1 + z),  b = −x y a,    (1 − x² a, b, −x),  (b, 1 − y² a, −y)
/// ```
///
/// - Domain: unit vectors; for `z < −0.9999999` it answers `(0, −1, 0), (−1, 0, 0)` whatever x and y are.
/// - Accuracy: `1 + z` keeps an absolute error of u, so that the basis is orthonormal to about `u/(1 + z)` only: in `f32`,
///   just before the patch, nothing is left of it. Within the patch it is off by `√(2 (1 + z))`.
/// - Source: Frisvad, *Building an Orthonormal Basis from a 3D Unit Vector Without Normalization*, J. Graphics Tools 16(3) (2012).
pub fn frisvad<R: Real>([x, y, z]: Triple<R>) -> (Triple<R>, Triple<R>) {
    let (zero, one) = (R::ZERO, R::from_f64(1.0));
    if z < R::from_f64(-0.999_999_9) {
        return ([zero, -one, zero], [-one, zero, zero]);
    }
    let a = one / (one + z);
    let b = -(x * y * a);
    ([one - x * x * a, b, -x], [b, one - y * y * a, -y])
}

/// The matrix that turns by `angle` \[rad\] counter-clockwise about `axis` (any length but 0).
///
/// ```text
/// M = cos θ I + sin θ [a]ₓ + (1 − cos θ) a aᵀ,    1 − cos θ = 2 sin²(θ/2)
/// ```
///
/// - Domain: `None` for the zero axis. Angles of any size; the sine's argument reduction is exact.
/// - Accuracy: each entry ≤ 8 u absolute: products of factors ≤ 1, summed once.
/// - Source: Rodrigues (1840); [B §4.5.4] has the three axes.
pub fn rotation_about(axis: DVec3, angle: f64) -> Option<DMat3> {
    let a = unit(axis)?;
    let (s, c) = angle.sin_cos();
    let half = (0.5 * angle).sin();
    let k = 2.0 * half * half;
    let column = |e: DVec3| e * c + a.cross(e) * s + a * (k * a.dot(e));
    Some(DMat3::from_cols(column(DVec3::X), column(DVec3::Y), column(DVec3::Z)))
}

/// The unit normal of a surface after the linear map `m`: along `m⁻ᵀ n`.
///
/// A normal is not a displacement: under a non-uniform scale `m n` tilts away from the surface. The
/// cofactor matrix, `det(m) m⁻ᵀ`, needs no division; its sign is undone for mirrors.
///
/// - Domain: `None` if `m` squashes the surface's normal to nothing (singular), or `n = 0`.
/// - Source: Turkowski, *Properties of Surface-Normal Transformations*, Graphics Gems (1990).
pub fn transform_normal(m: &DMat3, n: DVec3) -> Option<DVec3> {
    unit(normal_matrix(m)? * n)
}

/// The matrix of [`transform_normal`] but for a positive factor: the cofactors, with the sign of the determinant.
///
/// - Domain: `None` for a matrix that is singular or not finite. The sign is exact unless entries of one row and column
///   lie more than `2³²⁰` apart; cofactors
///   below 10⁻³⁰⁸ of the largest become 0, as for `diag(10²⁰⁰, 10⁻²⁰⁰, 1)`, which maps (1, 1, 0) to (0, 1, 0).
pub fn normal_matrix(m: &DMat3) -> Option<DMat3> {
    let largest = m.x_axis.abs().max(m.y_axis.abs()).max(m.z_axis.abs()).max_element();
    if largest == 0.0 || !m.is_finite() {
        return None;
    }
    let (x, y, z) = (m.x_axis / largest, m.y_axis / largest, m.z_axis / largest);
    let cofactors = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
    let det = x.dot(cofactors.x_axis);
    // The six products that the determinant sums, by size: it errs by γ₈ of this, as long as none of them underflows.
    let (ax, ay, az) = (x.abs(), y.abs(), z.abs());
    let permanent = ax.dot(ay.yzx() * az.zxy() + ay.zxy() * az.yzx());
    if permanent > SMALLEST_PERMANENT && det.abs() > gamma(8) * permanent {
        return Some(cofactors * det.signum());
    }
    balanced_normal_matrix(m)
}

/// `2⁻⁹⁰⁰`: products of three numbers up to 1 that add to this lose nothing to underflow (below `2⁻¹⁰²²`) that a
/// relative rounding error of `2⁻⁵³` would notice.
const SMALLEST_PERMANENT: f64 = f64::from_bits((1023 - 900) << 52);

/// The same with the sign of the exact determinant, of the matrix `R m C` whose rows and then columns are scaled by
/// powers of two to a largest entry in [1, 2): `cof(m)ᵢⱼ` is `cof(R m C)ᵢⱼ rᵢ cⱼ` but for a common positive factor.
fn balanced_normal_matrix(m: &DMat3) -> Option<DMat3> {
    let mut a = m.transpose().to_cols_array_2d(); // a[row][column]
    let (mut rows, mut columns) = ([0; 3], [0; 3]);
    for i in 0..3 {
        rows[i] = exponent(a[i].iter().fold(0.0, |most, x| f64::max(most, x.abs())))?;
        a[i] = a[i].map(|x| times_power(x, -rows[i]));
    }
    for j in 0..3 {
        columns[j] = exponent(a.iter().fold(0.0, |most, row| f64::max(most, row[j].abs())))?;
        a.iter_mut().for_each(|row| row[j] = times_power(row[j], -columns[j]));
    }
    let mut det = Expansion::default();
    for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
        det.add_triple([a[0][i], a[1][j], a[2][k]]);
        det.add_triple([-a[0][i], a[1][k], a[2][j]]);
    }
    let sign = match det.sign() {
        0 => return None,
        sign => f64::from(sign),
    };
    let mut entries = [[0.0; 3]; 3];
    let mut most = i32::MIN;
    for i in 0..3 {
        for j in 0..3 {
            let ([p, q], [s, t]) = ([(i + 1) % 3, (i + 2) % 3], [(j + 1) % 3, (j + 2) % 3]);
            entries[i][j] = sign * difference_of_products(a[p][s], a[q][t], a[p][t], a[q][s]);
            if let Some(e) = exponent(entries[i][j].abs()) {
                most = most.max(e - rows[i] - columns[j]);
            }
        }
    }
    for i in 0..3 {
        for j in 0..3 {
            entries[i][j] = times_power(entries[i][j], -rows[i] - columns[j] - most);
        }
    }
    Some(DMat3::from_cols_array_2d(&entries).transpose())
}

/// The exponent of the power of two at or next to `x ≥ 0`; none of 0.
fn exponent(x: f64) -> Option<i32> {
    (x > 0.0).then(|| x.log2().floor() as i32)
}

/// `x 2ᵉ`, in steps that are numbers themselves.
fn times_power(x: f64, e: i32) -> f64 {
    let step = e.clamp(-1000, 1000);
    let x = x * 2f64.powi(step);
    if step == e || x == 0.0 || !x.is_finite() { x } else { times_power(x, e - step) }
}
