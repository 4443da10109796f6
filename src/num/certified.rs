//! One formula, two arithmetics: quick with a running error bound, and slow with 106 bits.
//!
//! A geometric decision is the sign of some expression. [`Bounded`] evaluates it in `f64` and carries a bound
//! on the rounding error so far; when the bound does not exclude the other sign the answer is
//! [`Uncertain`], and the same generic function runs again in [`DoubleDouble`]. Nothing is compared with a
//! fixed small number. Callers scale their input by powers of two, so that nothing under- or overflows.

use super::U;
use super::double_double::DoubleDouble;
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The error bound does not decide the question.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Uncertain;

/// What the geometric formulas need of a number.
pub trait Scalar:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// A number that is known exactly.
    fn of(x: f64) -> Self;
    /// `a − b` of numbers that are known exactly.
    fn difference(a: f64, b: f64) -> Self;
    /// `a · b` of numbers that are known exactly.
    fn product(a: f64, b: f64) -> Self;
    /// Square root; of a negative number 0.
    fn sqrt(self) -> Self;
    /// The nearest `f64`.
    fn value(self) -> f64;
    /// −1, 0 or 1.
    fn sign(self) -> Result<i8, Uncertain>;
    /// The nearest `f64`, if its relative error is certainly at most `64 u`: the error of a careful
    /// algorithm on a well-conditioned problem.
    fn settled(self) -> Result<f64, Uncertain>;

    /// Is `self` certainly below `other`? (If not, it is certainly not.)
    fn is_below(self, other: Self) -> Result<bool, Uncertain> {
        Ok((self - other).sign()? < 0)
    }
}

/// Plain rounding, every answer taken for certain: what a textbook program does.
impl Scalar for f64 {
    #[inline]
    fn of(x: f64) -> Self {
        x
    }
    #[inline]
    fn difference(a: f64, b: f64) -> Self {
        a - b
    }
    #[inline]
    fn product(a: f64, b: f64) -> Self {
        a * b
    }
    #[inline]
    fn sqrt(self) -> Self {
        f64::sqrt(self.max(0.0))
    }
    #[inline]
    fn value(self) -> f64 {
        self
    }
    #[inline]
    fn sign(self) -> Result<i8, Uncertain> {
        Ok(if self > 0.0 {
            1
        } else if self < 0.0 {
            -1
        } else {
            0
        })
    }
    #[inline]
    fn settled(self) -> Result<f64, Uncertain> {
        Ok(self)
    }
}

impl Scalar for DoubleDouble {
    #[inline]
    fn of(x: f64) -> Self {
        DoubleDouble::of(x)
    }
    #[inline]
    fn difference(a: f64, b: f64) -> Self {
        DoubleDouble::difference(a, b)
    }
    #[inline]
    fn product(a: f64, b: f64) -> Self {
        DoubleDouble::product(a, b)
    }
    #[inline]
    fn sqrt(self) -> Self {
        DoubleDouble::sqrt(self)
    }
    #[inline]
    fn value(self) -> f64 {
        DoubleDouble::value(self)
    }
    #[inline]
    fn sign(self) -> Result<i8, Uncertain> {
        Ok(if self.high > 0.0 {
            1
        } else if self.high < 0.0 {
            -1
        } else {
            0
        })
    }
    #[inline]
    fn settled(self) -> Result<f64, Uncertain> {
        Ok(DoubleDouble::value(self))
    }
}

/// An `f64` and a bound on its distance from the number that exact arithmetic would give.
///
/// - Accuracy: each step adds `u |result|` to what the operands' bounds contribute. The bounds are sums of
///   positive terms, so their own rounding errs by a factor `1 + n u` after `n` steps, which the
///   constant's factor `1 + 2⁻²⁰` covers up to `n = 2³²`.
/// - Source: Higham, *Accuracy and Stability of Numerical Algorithms* (2002) §3.3, running error analysis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounded {
    value: f64,
    error: f64,
}

const STEP: f64 = U * (1.0 + 1.0 / 1_048_576.0);

impl Bounded {
    /// `value`, known to within `error`.
    pub fn within(value: f64, error: f64) -> Self {
        Bounded { value, error }
    }

    /// The bound on the error.
    pub fn error(self) -> f64 {
        self.error
    }

    #[inline]
    fn rounded(value: f64, inherited: f64) -> Self {
        Bounded { value, error: inherited + STEP * value.abs() }
    }
}

impl Scalar for Bounded {
    #[inline]
    fn of(x: f64) -> Self {
        Bounded { value: x, error: 0.0 }
    }
    #[inline]
    fn difference(a: f64, b: f64) -> Self {
        Self::rounded(a - b, 0.0)
    }
    #[inline]
    fn product(a: f64, b: f64) -> Self {
        Self::rounded(a * b, 0.0)
    }
    /// `|√x − √v| ≤ e / √v`, because `√x + √v ≥ √v`.
    #[inline]
    fn sqrt(self) -> Self {
        if self.value > 0.0 {
            let root = self.value.sqrt();
            Self::rounded(root, self.error / root)
        } else {
            Bounded { value: 0.0, error: self.error.sqrt() }
        }
    }
    #[inline]
    fn value(self) -> f64 {
        self.value
    }
    #[inline]
    fn sign(self) -> Result<i8, Uncertain> {
        if self.value > self.error {
            Ok(1)
        } else if self.value < -self.error {
            Ok(-1)
        } else if self.value == 0.0 && self.error == 0.0 {
            Ok(0)
        } else {
            Err(Uncertain)
        }
    }
    #[inline]
    fn settled(self) -> Result<f64, Uncertain> {
        let close = self.error <= 64.0 * U * self.value.abs();
        if close && self.value.is_finite() { Ok(self.value) } else { Err(Uncertain) }
    }
}

impl Add for Bounded {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::rounded(self.value + other.value, self.error + other.error)
    }
}

impl Sub for Bounded {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::rounded(self.value - other.value, self.error + other.error)
    }
}

impl Neg for Bounded {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Bounded { value: -self.value, error: self.error }
    }
}

impl Mul for Bounded {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let inherited = self.error * (other.value.abs() + other.error) + self.value.abs() * other.error;
        Self::rounded(self.value * other.value, inherited)
    }
}

impl Div for Bounded {
    type Output = Self;
    /// `|x/y − v/w| ≤ (eᵥ + |v/w| e_w) / (|w| − e_w)`; unbounded if the divisor may be zero.
    #[inline]
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let room = other.value.abs() - other.error;
        if room > 0.0 {
            Self::rounded(quotient, (self.error + quotient.abs() * other.error) / room)
        } else {
            Bounded { value: quotient, error: f64::INFINITY }
        }
    }
}

/// The real roots of `a t² + 2 b t + c`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Roots<T> {
    None,
    /// Of a linear equation, or a double root.
    One(T),
    /// Ascending.
    Two(T, T),
}

/// Solves `a t² + 2 b t + c = 0` without cancellation between `b` and the root of the discriminant.
///
/// ```text
/// q = −(b + sign(b) √(b² − a c)),    t = q/a, c/q
/// ```
///
/// - Domain: `a = 0` leaves a line; `a = b = 0` has no root, even if `c = 0`.
/// - Source: Press et al., *Numerical Recipes* (2007) §5.6.
#[inline]
pub fn solve_quadratic<T: Scalar>(a: T, b: T, c: T) -> Result<Roots<T>, Uncertain> {
    if a.sign()? == 0 {
        let root = || -(c / (b + b));
        return Ok(if b.sign()? == 0 { Roots::None } else { Roots::One(root()) });
    }
    let discriminant = b * b - a * c;
    match discriminant.sign()? {
        -1 => Ok(Roots::None),
        0 => Ok(Roots::One(-(b / a))),
        _ => {
            let s = discriminant.sqrt();
            let q = if b.value() < 0.0 { s - b } else { -(b + s) };
            let (t0, t1) = (q / a, c / q);
            Ok(if t0.value() <= t1.value() { Roots::Two(t0, t1) } else { Roots::Two(t1, t0) })
        }
    }
}

/// Has `a t² + 2 b t + c` certainly no root `t > 0`? A "no" may be wrong.
///
/// Without a change of sign in the coefficients all roots lie behind (Descartes), and without a positive
/// discriminant there are none. `c` is the one number that vanishes for rays that start on the surface: its
/// sign is asked of `exact_c` where its bound does not tell.
#[inline]
pub fn no_root_ahead([a, b, c]: [Bounded; 3], exact_c: impl FnOnce() -> i8) -> bool {
    let Ok(way @ (-1 | 1)) = a.sign() else { return false };
    match b.sign() {
        Ok(along) if along == way => c.sign().unwrap_or_else(|Uncertain| exact_c()) * way >= 0,
        _ => c.sign() == Ok(way) && (b * b - a * c).sign() == Ok(-1),
    }
}

/// A vector of such numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector<T>(pub [T; 3]);

impl<T: Scalar> Vector<T> {
    #[inline]
    pub fn of(v: glam::DVec3) -> Self {
        Vector([T::of(v.x), T::of(v.y), T::of(v.z)])
    }

    #[inline]
    pub fn difference(a: glam::DVec3, b: glam::DVec3) -> Self {
        Vector([T::difference(a.x, b.x), T::difference(a.y, b.y), T::difference(a.z, b.z)])
    }

    /// `t d` of numbers that are known exactly.
    #[inline]
    pub fn along(d: glam::DVec3, t: f64) -> Self {
        Vector([T::product(t, d.x), T::product(t, d.y), T::product(t, d.z)])
    }

    #[inline(always)]
    pub fn dot(self, o: Self) -> T {
        self.0[0] * o.0[0] + self.0[1] * o.0[1] + self.0[2] * o.0[2]
    }

    #[inline(always)]
    pub fn cross(self, o: Self) -> Self {
        let ([x, y, z], [a, b, c]) = (self.0, o.0);
        Vector([y * c - z * b, z * a - x * c, x * b - y * a])
    }

    #[inline]
    pub fn scaled(self, s: T) -> Self {
        Vector(self.0.map(|x| x * s))
    }

    #[inline]
    pub fn value(self) -> glam::DVec3 {
        glam::DVec3::from_array(self.0.map(T::value))
    }
}

impl<T: Scalar> Add for Vector<T> {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Vector([self.0[0] + o.0[0], self.0[1] + o.0[1], self.0[2] + o.0[2]])
    }
}

impl<T: Scalar> Sub for Vector<T> {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Vector([self.0[0] - o.0[0], self.0[1] - o.0[1], self.0[2] - o.0[2]])
    }
}

/// The power of two in `(x/2, x]`, for a positive `x`; between `2⁻¹⁰²²` and `2¹⁰²²`, 1 if `x` is not positive.
///
/// Multiplying or dividing by it changes no digit.
#[inline]
pub fn power_of_two_below(x: f64) -> f64 {
    if x > 0.0 {
        let exponent = (x.to_bits() >> 52).clamp(1, 2045);
        f64::from_bits(exponent << 52)
    } else {
        1.0
    }
}
