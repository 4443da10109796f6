//! A node with up to eight children, whose boxes a ray is tested against all at once.

use super::frame::{Box32, LocalRay, WIDEN};
#[cfg(target_arch = "x86_64")]
use super::pack::sift_avx2;
use super::pack::{Pack, sift_portable};

/// Children of a node.
pub(super) const WIDTH: usize = 8;
/// A child with this bit is a leaf; the other bits are its number.
pub(super) const LEAF: u32 = 1 << 31;

/// Planes `x₀ y₀ z₀ x₁ y₁ z₁` of eight boxes; a missing child has an empty box.
#[derive(Clone, Debug, PartialEq)]
#[repr(C, align(32))]
pub(super) struct Node {
    pub planes: [[f32; WIDTH]; 6],
    pub child: [u32; WIDTH],
}

impl Node {
    pub const EMPTY: Node = Node {
        planes: [
            [f32::INFINITY; WIDTH],
            [f32::INFINITY; WIDTH],
            [f32::INFINITY; WIDTH],
            [f32::NEG_INFINITY; WIDTH],
            [f32::NEG_INFINITY; WIDTH],
            [f32::NEG_INFINITY; WIDTH],
        ],
        child: [u32::MAX; WIDTH],
    };

    pub fn set(&mut self, slot: usize, bounds: &Box32, child: u32) {
        for axis in 0..3 {
            self.planes[axis][slot] = bounds.min[axis];
            self.planes[axis + 3][slot] = bounds.max[axis];
        }
        self.child[slot] = child;
    }

    pub fn bounds(&self, slot: usize) -> Box32 {
        let at = |k: usize| self.planes[k][slot];
        Box32 { min: [at(0), at(1), at(2)], max: [at(3), at(4), at(5)] }
    }

    /// Number of children; they come first.
    pub fn len(&self) -> usize {
        self.child.iter().position(|&c| c == u32::MAX).unwrap_or(WIDTH)
    }
}

/// Where a ray enters the children of a node.
#[derive(Clone, Copy)]
#[repr(C, align(32))]
pub(super) struct Entries {
    pub near: [f32; WIDTH],
    /// Bit `i`: the ray meets child `i` within its limit.
    pub met: u32,
}

/// Eight numbers in one instruction set.
pub(super) trait Eight {
    /// # Safety
    /// The processor has the instruction set.
    unsafe fn enter(node: &Node, ray: &LocalRay, limit: f32) -> Entries;

    /// # Safety
    /// The processor has the instruction set.
    unsafe fn sift(pack: &Pack, ray: &LocalRay, limit: f32) -> u32;
}

/// Whatever the target has.
pub(super) struct Portable;

impl Eight for Portable {
    #[inline(always)]
    unsafe fn enter(node: &Node, ray: &LocalRay, limit: f32) -> Entries {
        let mut near = [0f32; WIDTH];
        let mut far = [f32::INFINITY; WIDTH];
        for axis in 0..3 {
            let first = &node.planes[ray.near_plane[axis]];
            let last = &node.planes[(ray.near_plane[axis] + 3) % 6];
            for i in 0..WIDTH {
                let a = (first[i] - ray.near_origin[axis]) * ray.inverse[axis];
                let b = (last[i] - ray.far_origin[axis]) * ray.inverse[axis];
                near[i] = if a > near[i] { a } else { near[i] };
                far[i] = if b < far[i] { b } else { far[i] };
            }
        }
        let mut met = 0;
        for i in 0..WIDTH {
            let far = far[i] * WIDEN;
            let far = if far < limit { far } else { limit };
            met |= u32::from(near[i] <= far) << i;
        }
        Entries { near, met }
    }

    #[inline(always)]
    unsafe fn sift(pack: &Pack, ray: &LocalRay, limit: f32) -> u32 {
        sift_portable(pack, ray, limit)
    }
}

#[cfg(target_arch = "x86_64")]
pub(super) struct Avx2;

#[cfg(target_arch = "x86_64")]
impl Eight for Avx2 {
    #[inline(always)]
    unsafe fn enter(node: &Node, ray: &LocalRay, limit: f32) -> Entries {
        // SAFETY: the caller has AVX2.
        unsafe { enter_avx2(node, ray, limit) }
    }

    #[inline(always)]
    unsafe fn sift(pack: &Pack, ray: &LocalRay, limit: f32) -> u32 {
        // SAFETY: the caller has AVX2.
        unsafe { sift_avx2(pack, ray, limit) }
    }
}

#[cfg(target_arch = "x86_64")]
#[inline]
#[target_feature(enable = "avx2")]
fn enter_avx2(node: &Node, ray: &LocalRay, limit: f32) -> Entries {
    use std::arch::x86_64::*;
    let mut near = _mm256_setzero_ps();
    let mut far = _mm256_set1_ps(f32::INFINITY);
    for axis in 0..3 {
        let plane = ray.near_plane[axis];
        let other = if plane > 2 { plane - 3 } else { plane + 3 };
        // SAFETY: the loads are of the eight numbers of an array of eight, aligned as a node is.
        let (first, last) = unsafe {
            (_mm256_load_ps(node.planes[plane].as_ptr()), _mm256_load_ps(node.planes[other].as_ptr()))
        };
        let inverse = _mm256_set1_ps(ray.inverse[axis]);
        let a = _mm256_mul_ps(_mm256_sub_ps(first, _mm256_set1_ps(ray.near_origin[axis])), inverse);
        let b = _mm256_mul_ps(_mm256_sub_ps(last, _mm256_set1_ps(ray.far_origin[axis])), inverse);
        near = _mm256_max_ps(a, near);
        far = _mm256_min_ps(b, far);
    }
    far = _mm256_min_ps(_mm256_mul_ps(far, _mm256_set1_ps(WIDEN)), _mm256_set1_ps(limit));
    let met = _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(near, far)) as u32;
    let mut entries = Entries { near: [0.0; WIDTH], met };
    // SAFETY: the store is of eight numbers into an array of eight, aligned as entries are.
    unsafe { _mm256_store_ps(entries.near.as_mut_ptr(), near) };
    entries
}
