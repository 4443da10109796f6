//! Four numbers at a time, in whatever vectors the processor has; the same operations in the same order, hence the
//! same bits.

use std::ops::{Add, Div, Mul, Sub};

/// Points of a ray that are looked at together.
pub(super) const LANES: usize = 4;

/// Four `f64`. A mask has all bits of a lane set or none.
pub(super) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    fn of(x: [f64; LANES]) -> Self;
    fn array(self) -> [f64; LANES];
    fn sqrt(self) -> Self;
    /// `self · b + c`, rounded once.
    fn mul_add(self, b: Self, c: Self) -> Self;
    /// A mask: where is `self` above `other`? Not where one is NaN.
    fn above(self, other: Self) -> Self;
    /// A mask: where both are set.
    fn and(self, other: Self) -> Self;
    /// A mask: where `self` is set and `other` is not.
    fn without(self, other: Self) -> Self;
    /// `a` where the mask is set, else `b`.
    fn pick(self, a: Self, b: Self) -> Self;
    /// Is the mask set anywhere?
    fn any(self) -> bool;

    #[inline(always)]
    fn splat(x: f64) -> Self {
        Self::of([x; LANES])
    }
}

/// The default target's way.
#[derive(Clone, Copy)]
pub(super) struct Plain([f64; LANES]);

impl Plain {
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Plain(std::array::from_fn(|i| f(self.0[i], other.0[i])))
    }
}

macro_rules! operators {
    ($kind:ident: $(($operator:ident, $name:ident, |$a:ident, $b:ident| $body:expr)),*) => {
        $(impl $operator for $kind {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                let ($a, $b) = (self, other);
                $body
            }
        })*
    };
}

operators!(Plain:
    (Add, add, |a, b| a.zip(b, |x, y| x + y)),
    (Sub, sub, |a, b| a.zip(b, |x, y| x - y)),
    (Mul, mul, |a, b| a.zip(b, |x, y| x * y)),
    (Div, div, |a, b| a.zip(b, |x, y| x / y))
);

impl Lanes for Plain {
    #[inline(always)]
    fn of(x: [f64; LANES]) -> Self {
        Plain(x)
    }

    #[inline(always)]
    fn array(self) -> [f64; LANES] {
        self.0
    }

    #[inline(always)]
    fn mul_add(self, b: Self, c: Self) -> Self {
        Plain(std::array::from_fn(|i| self.0[i].mul_add(b.0[i], c.0[i])))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Plain(self.0.map(f64::sqrt))
    }

    #[inline(always)]
    fn above(self, other: Self) -> Self {
        self.zip(other, |x, y| f64::from_bits(if x > y { u64::MAX } else { 0 }))
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self.zip(other, |x, y| f64::from_bits(x.to_bits() & y.to_bits()))
    }

    #[inline(always)]
    fn without(self, other: Self) -> Self {
        self.zip(other, |x, y| f64::from_bits(x.to_bits() & !y.to_bits()))
    }

    #[inline(always)]
    fn pick(self, a: Self, b: Self) -> Self {
        Plain(std::array::from_fn(|i| if self.0[i].to_bits() != 0 { a.0[i] } else { b.0[i] }))
    }

    #[inline(always)]
    fn any(self) -> bool {
        self.0.iter().any(|x| x.to_bits() != 0)
    }
}

#[cfg(target_arch = "x86_64")]
pub(super) use avx2::Avx2;

/// May [`Avx2`] be used here?
#[cfg(target_arch = "x86_64")]
pub(super) fn has_avx2() -> bool {
    std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma")
}

#[cfg(target_arch = "x86_64")]
mod avx2 {
    use super::{Add, Div, LANES, Lanes, Mul, Sub};
    use std::arch::x86_64::*;

    /// AVX2's way, with the fused products of FMA3. To be used only where the processor has both: all its functions are inlined
    /// into ones that say so.
    #[derive(Clone, Copy)]
    pub struct Avx2(__m256d);

    // SAFETY, for all of this module: the caller has made sure that the processor has AVX2 and FMA3.
    operators!(Avx2:
        (Add, add, |a, b| Avx2(unsafe { _mm256_add_pd(a.0, b.0) })),
        (Sub, sub, |a, b| Avx2(unsafe { _mm256_sub_pd(a.0, b.0) })),
        (Mul, mul, |a, b| Avx2(unsafe { _mm256_mul_pd(a.0, b.0) })),
        (Div, div, |a, b| Avx2(unsafe { _mm256_div_pd(a.0, b.0) }))
    );

    impl Lanes for Avx2 {
        #[inline(always)]
        fn of(x: [f64; LANES]) -> Self {
            Avx2(unsafe { _mm256_loadu_pd(x.as_ptr()) })
        }

        #[inline(always)]
        fn array(self) -> [f64; LANES] {
            let mut out = [0.0; LANES];
            unsafe { _mm256_storeu_pd(out.as_mut_ptr(), self.0) };
            out
        }

        #[inline(always)]
        fn mul_add(self, b: Self, c: Self) -> Self {
            Avx2(unsafe { _mm256_fmadd_pd(self.0, b.0, c.0) })
        }

        #[inline(always)]
        fn sqrt(self) -> Self {
            Avx2(unsafe { _mm256_sqrt_pd(self.0) })
        }

        #[inline(always)]
        fn above(self, other: Self) -> Self {
            Avx2(unsafe { _mm256_cmp_pd::<_CMP_GT_OQ>(self.0, other.0) })
        }

        #[inline(always)]
        fn and(self, other: Self) -> Self {
            Avx2(unsafe { _mm256_and_pd(self.0, other.0) })
        }

        #[inline(always)]
        fn without(self, other: Self) -> Self {
            Avx2(unsafe { _mm256_andnot_pd(other.0, self.0) })
        }

        #[inline(always)]
        fn pick(self, a: Self, b: Self) -> Self {
            Avx2(unsafe { _mm256_blendv_pd(b.0, a.0, self.0) })
        }

        #[inline(always)]
        fn any(self) -> bool {
            unsafe { _mm256_movemask_pd(self.0) != 0 }
        }

        #[inline(always)]
        fn splat(x: f64) -> Self {
            Avx2(unsafe { _mm256_set1_pd(x) })
        }
    }
}
