//! One body of arithmetic in two instruction sets.

/// Which instructions a vectorised function may use; the answer is the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Vectors {
    /// The widest that the processor has.
    #[default]
    Widest,
    /// Those of the default target.
    Baseline,
}

impl Vectors {
    /// May AVX2 be used, and does the processor have it?
    #[inline]
    pub fn has_avx2(self) -> bool {
        #[cfg(target_arch = "x86_64")]
        {
            self == Vectors::Widest && std::arch::is_x86_feature_detected!("avx2")
        }
        #[cfg(not(target_arch = "x86_64"))]
        {
            false
        }
    }
}

/// Compiles a function twice, for the default target and for AVX2, and calls the one that its first
/// argument allows and the processor has.
///
/// Rust never contracts a product and a sum by itself, so both round alike and give the same bits.
macro_rules! vectorised {
    ($(#[$doc:meta])* $visibility:vis fn $name:ident($($argument:ident: $kind:ty),* $(,)?) $body:block) => {
        $(#[$doc])*
        $visibility fn $name(vectors: $crate::num::vectors::Vectors, $($argument: $kind),*) {
            #[inline(always)]
            fn body($($argument: $kind),*) $body
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx2")]
            fn avx2($($argument: $kind),*) {
                body($($argument),*);
            }
            #[cfg(target_arch = "x86_64")]
            if vectors.has_avx2() {
                // SAFETY: the processor has AVX2.
                unsafe { avx2($($argument),*) };
                return;
            }
            let _ = vectors; // read on x86-64 only
            body($($argument),*);
        }
    };
}
pub(crate) use vectorised;
