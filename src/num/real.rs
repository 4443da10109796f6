//! The arithmetic of a formula as a parameter: `f64` to render, `f32` to see what would be lost.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A floating-point type.
pub trait Real:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    const ZERO: Self;
    /// Bound on the relative error of one operation.
    const ROUNDOFF: f64;
    /// Rounds to the nearest value of the type.
    fn from_f64(x: f64) -> Self;
    fn to_f64(self) -> f64;
    fn sqrt(self) -> Self;
    /// The magnitude of `self` with the sign of `sign`.
    fn with_sign_of(self, sign: Self) -> Self;
}

macro_rules! real {
    ($float:ty) => {
        impl Real for $float {
            const ZERO: Self = 0.0;
            const ROUNDOFF: f64 = <$float>::EPSILON as f64 / 2.0;
            #[inline(always)]
            fn from_f64(x: f64) -> Self {
                x as $float
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                self.sqrt()
            }
            #[inline(always)]
            fn with_sign_of(self, sign: Self) -> Self {
                self.copysign(sign)
            }
        }
    };
}
real!(f32);
real!(f64);

/// Three coordinates of any [`Real`].
pub type Triple<R> = [R; 3];

/// The scalar product.
#[inline(always)]
pub fn dot<R: Real>(a: Triple<R>, b: Triple<R>) -> R {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `a + k b`.
#[inline(always)]
pub fn along<R: Real>(a: Triple<R>, k: R, b: Triple<R>) -> Triple<R> {
    [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]]
}
