//! Eight triangles in `f32`, enough to tell for certain that most rays miss them.
//!
//! The numbers are those of Möller & Trumbore (1997), `from = o − v₀`,
//!
//! ```text
//! s = d × e₂,  q = from × e₁:   det = e₁·s,  u = from·s,  v = d·q,  t det = e₂·q
//! ```
//!
//! each with a bound on its error. With `U = 2⁻²⁴`, `|d| < 2`, `|from| < 3` by coordinate, `E` the larger of the sums
//! `|x| + |y| + |z|` of the edges, and `δ` the displacement of the ray's origin:
//!
//! ```text
//! |s| ≤ 4E in all, 4U of that lost;  from: δ + 4U:   u, v err by E (4δ + 16U + 48U + 36U)
//! det: E² · 32U,   t det: E² (2δ + 50U);             E ≤ 6:  u + v − det by E (8δ + 200U + 24U + 192U)
//! ```
//!
//! A triangle that passes goes to the caller's test, which decides.

use super::frame::{Frame, LocalRay};
use super::node::WIDTH;
use glam::DVec3;

const U: f32 = f32::EPSILON / 2.0;
/// Triangles count as at least this large, so that squares of their size are far from underflow.
const SMALLEST: f64 = 1.0 / (1u64 << 40) as f64;

/// First corner and two edges of eight triangles, by coordinate, and the size `E` of their edges; −1 where one is missing.
#[derive(Clone, Debug, PartialEq)]
#[repr(C, align(64))]
pub(super) struct Pack {
    pub corner: [[f32; WIDTH]; 3],
    pub edge1: [[f32; WIDTH]; 3],
    pub edge2: [[f32; WIDTH]; 3],
    pub size: [f32; WIDTH],
}

impl Pack {
    pub const EMPTY: Pack = Pack {
        corner: [[0.0; WIDTH]; 3],
        edge1: [[0.0; WIDTH]; 3],
        edge2: [[0.0; WIDTH]; 3],
        size: [-1.0; WIDTH],
    };

    pub fn set(&mut self, lane: usize, frame: &Frame, [v0, v1, v2]: [DVec3; 3]) {
        let (corner, edge1, edge2) = (frame.place(v0), frame.scale(v1 - v0), frame.scale(v2 - v0));
        for i in 0..3 {
            self.corner[i][lane] = corner[i] as f32;
            self.edge1[i][lane] = edge1[i] as f32;
            self.edge2[i][lane] = edge2[i] as f32;
        }
        let size = edge1.abs().element_sum().max(edge2.abs().element_sum()).max(SMALLEST);
        self.size[lane] = (size * (1.0 + 1e-6)) as f32;
    }

    /// Lanes that hold a triangle.
    pub fn filled(&self) -> u32 {
        (0..WIDTH).fold(0, |mask, i| mask | u32::from(self.size[i] > 0.0) << i)
    }
}

/// A ray's share in the error bounds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Doubt {
    side: f32,
    third: f32,
    det: f32,
    along: f32,
}

impl Doubt {
    #[inline]
    pub fn of(ray: &LocalRay) -> Self {
        let shift = ray.displacement;
        // A few U more for the roundings of the bounds themselves; `along` includes `limit ≤ 4` times that of det.
        Doubt {
            side: 4.0 * shift + 108.0 * U,
            third: 8.0 * shift + 448.0 * U,
            det: 40.0 * U,
            along: 2.0 * shift + 256.0 * U,
        }
    }
}

/// Bit `i`: the ray may meet triangle `i` before `limit`; 0 is certain.
#[inline(always)]
pub(super) fn sift_portable(pack: &Pack, ray: &LocalRay, doubt: &Doubt, limit: f32) -> u32 {
    if ray.displacement == f32::INFINITY {
        return pack.filled();
    }
    let [dx, dy, dz] = ray.direction;
    let mut mask = 0;
    for i in 0..WIDTH {
        let [ax, ay, az] = pack.edge1.map(|e| e[i]);
        let [bx, by, bz] = pack.edge2.map(|e| e[i]);
        let [x, y, z] = [0, 1, 2].map(|axis| ray.origin[axis] - pack.corner[axis][i]);
        let (sx, sy, sz) = (dy * bz - dz * by, dz * bx - dx * bz, dx * by - dy * bx);
        let (qx, qy, qz) = (y * az - z * ay, z * ax - x * az, x * ay - y * ax);
        let det = ax * sx + ay * sy + az * sz;
        let sign = det.to_bits() & 0x8000_0000;
        let turned = |x: f32| f32::from_bits(x.to_bits() ^ sign);
        let (u, v) = (turned(x * sx + y * sy + z * sz), turned(dx * qx + dy * qy + dz * qz));
        let (size, t) = (turned(det), turned(bx * qx + by * qy + bz * qz));
        let reach = pack.size[i];
        let square = reach * reach;
        let (side, along) = (-reach * doubt.side, square * doubt.along);
        let inside = (u >= side) & (v >= side) & (u + v <= size + reach * doubt.third);
        let between = (t >= -along) & (t <= limit * size + along);
        let unsure = (size <= square * doubt.det) & (reach > 0.0);
        mask |= u32::from(inside & between | unsure) << i;
    }
    mask
}

/// The same in AVX2.
///
/// # Safety
/// The processor has AVX2.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) unsafe fn sift_avx2(pack: &Pack, ray: &LocalRay, doubt: &Doubt, limit: f32) -> u32 {
    use std::arch::x86_64::*;
    if ray.displacement == f32::INFINITY {
        return pack.filled();
    }
    // SAFETY: the caller has AVX2; every load is of eight numbers of an array of eight.
    unsafe {
        let load = |x: &[f32; WIDTH]| _mm256_load_ps(x.as_ptr());
        let all = |x: f32| _mm256_set1_ps(x);
        let (mul, add, sub) =
            (|a, b| _mm256_mul_ps(a, b), |a, b| _mm256_add_ps(a, b), |a, b| _mm256_sub_ps(a, b));
        let dot =
            |a: [__m256; 3], b: [__m256; 3]| add(add(mul(a[0], b[0]), mul(a[1], b[1])), mul(a[2], b[2]));
        let cross = |a: [__m256; 3], b: [__m256; 3]| {
            let minor = |i: usize, j: usize| sub(mul(a[i], b[j]), mul(a[j], b[i]));
            [minor(1, 2), minor(2, 0), minor(0, 1)]
        };
        let d = ray.direction.map(all);
        let e1 = [load(&pack.edge1[0]), load(&pack.edge1[1]), load(&pack.edge1[2])];
        let e2 = [load(&pack.edge2[0]), load(&pack.edge2[1]), load(&pack.edge2[2])];
        let from = [0, 1, 2].map(|i| sub(all(ray.origin[i]), load(&pack.corner[i])));
        let (s, q) = (cross(d, e2), cross(from, e1));
        let det = dot(e1, s);
        let sign = _mm256_and_ps(det, all(-0.0));
        let turned = |x| _mm256_xor_ps(x, sign);
        let (u, v) = (turned(dot(from, s)), turned(dot(d, q)));
        let (size, t) = (turned(det), turned(dot(e2, q)));
        let reach = load(&pack.size);
        let square = mul(reach, reach);
        let minus = _mm256_xor_ps(reach, all(-0.0));
        let (side, along) = (mul(minus, all(doubt.side)), mul(square, all(doubt.along)));
        let at_least = |a, b| _mm256_cmp_ps::<_CMP_GE_OQ>(a, b);
        let and = |a, b| _mm256_and_ps(a, b);
        let third = at_least(add(size, mul(reach, all(doubt.third))), add(u, v));
        let inside = and(and(at_least(u, side), at_least(v, side)), third);
        let late = at_least(add(mul(all(limit), size), along), t);
        let between = and(at_least(t, _mm256_xor_ps(along, all(-0.0))), late);
        let filled = _mm256_cmp_ps::<_CMP_GT_OQ>(reach, all(0.0));
        let unsure = and(at_least(mul(square, all(doubt.det)), size), filled);
        _mm256_movemask_ps(_mm256_or_ps(and(inside, between), unsure)) as u32
    }
}
