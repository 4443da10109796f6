//! Eight triangles in 16 bits a coordinate, enough to tell for certain that most rays miss them.
//!
//! Corners are whole numbers of steps from the corner of a box. The ray is moved along itself to the side of that box, so
//! that all numbers stay small. Then, after Möller & Trumbore (1997), `from = o − v₀`,
//!
//! ```text
//! s = d × e₂,  q = from × e₁:   det = e₁·s,  u = from·s,  v = d·q,  t det = e₂·q
//! ```
//!
//! each with a bound on its error, counted in steps. There are `Q = 2¹⁶` of them; `U = 2⁻²⁴`; by coordinate corners
//! err by ½, edges by 1, the ray's origin by `δ`; `|d| < 2`, `|e| < Q`, `|from| < 5Q + 2δ`. Summed over coordinates
//! `|s| < 12 Q`, off by `12 + 36 U Q`, and `|q| < 30 Q²`, off by `33.3 Q + 6.1 δ Q`. Hence
//!
//! ```text
//! u, v err by (68 + 13 δ) Q,   det by 25 Q,   u + v − det by (162 + 26 δ) Q,
//! t det by (64 + 6.1 δ) Q², and by 5Q · 25Q more when compared with det.
//! ```
//!
//! A triangle that passes goes to the caller's test, which decides.

use super::frame::{Frame, LocalRay};
use super::node::WIDTH;
use super::split::Item;
use glam::DVec3;

/// Steps to the largest side of the box.
const STEPS: f64 = 65535.0;
const Q: f32 = 65536.0;

/// Corners of eight triangles by corner and coordinate, and their numbers.
#[derive(Clone, Debug, PartialEq)]
#[repr(C, align(64))]
pub(super) struct Pack {
    corner: [[[u16; WIDTH]; 3]; 3],
    origin: [f32; 3],
    per_step: f32,
    pub id: [u32; WIDTH],
}

impl Pack {
    /// Up to eight triangles.
    pub fn new(frame: &Frame, items: &[Item], corners: impl Fn(u32) -> [DVec3; 3]) -> Self {
        let mut bounds = super::frame::Box32::EMPTY;
        items.iter().for_each(|item| bounds.grow(&item.bounds));
        let side = (0..3).map(|i| f64::from(bounds.max[i]) - f64::from(bounds.min[i])).fold(0.0, f64::max);
        // Rounded down, so that the last corner is in reach; a single point gets a side.
        let per_step = (STEPS * (1.0 - 1e-6) / side.max(1e-18)) as f32;
        let mut pack =
            Pack { corner: [[[0; WIDTH]; 3]; 3], origin: bounds.min, per_step, id: [u32::MAX; WIDTH] };
        for (lane, item) in items.iter().enumerate() {
            pack.id[lane] = item.id;
            for (corner, v) in corners(item.id).map(|v| frame.place(v)).into_iter().enumerate() {
                for axis in 0..3 {
                    let steps = (v[axis] - f64::from(bounds.min[axis])) * f64::from(per_step);
                    pack.corner[corner][axis][lane] = steps.round() as u16;
                }
            }
        }
        pack
    }

    /// Lanes that hold a triangle.
    #[inline]
    fn filled(&self) -> u32 {
        (0..WIDTH).fold(0, |mask, i| mask | u32::from(self.id[i] != u32::MAX) << i)
    }
}

/// A ray in a pack's steps.
struct Aim {
    origin: [f32; 3],
    /// Where the ray begins, and beyond where nothing is asked for.
    first: f32,
    last: f32,
    side: f32,
    third: f32,
    along: f32,
}

enum Aimed {
    At(Aim),
    Past,
    /// Nothing can be said.
    Lost,
}

impl Aim {
    #[inline(always)]
    fn of(pack: &Pack, ray: &LocalRay, limit: f32) -> Aimed {
        let axis = ray.longest;
        let ahead = (f64::from(pack.origin[axis]) - ray.origin[axis]) * ray.ahead;
        let per_step = f64::from(pack.per_step);
        let mut o = [0.0; 3];
        for (i, o) in o.iter_mut().enumerate() {
            let from = ray.origin[i] + ray.direction[i] * ahead - f64::from(pack.origin[i]);
            *o = (from * per_step) as f32;
        }
        let shift = ray.shift * pack.per_step;
        // A ray through the box is within Q of it in all coordinates where it meets the plane of its side.
        let reach = 4.0 * Q + 2.0 * shift;
        if !(shift < Q) {
            return Aimed::Lost;
        }
        if o[0].abs().max(o[1].abs()).max(o[2].abs()) > reach {
            return Aimed::Past;
        }
        Aimed::At(Aim {
            origin: o,
            first: (-ahead * per_step) as f32,
            last: ((f64::from(limit) - ahead) * per_step) as f32,
            side: (70.0 + 13.0 * shift) * -Q,
            third: (165.0 + 26.0 * shift) * Q,
            along: (192.0 + 7.0 * shift) * (Q * Q),
        })
    }
}

/// Up to here the sign of `det` is in doubt.
const FLAT: f32 = 26.0 * Q;

/// Bit `i`: the ray may meet triangle `i` before `limit`; 0 is certain.
#[inline(always)]
pub(super) fn sift_portable(pack: &Pack, ray: &LocalRay, limit: f32) -> u32 {
    let aim = match Aim::of(pack, ray, limit) {
        Aimed::At(aim) => aim,
        Aimed::Past => return 0,
        Aimed::Lost => return pack.filled(),
    };
    let [dx, dy, dz] = ray.direction32;
    let mut mask = 0;
    for i in 0..WIDTH {
        let [v0, v1, v2] = [0, 1, 2].map(|c| [0, 1, 2].map(|axis| f32::from(pack.corner[c][axis][i])));
        let [ax, ay, az] = [0, 1, 2].map(|axis| v1[axis] - v0[axis]);
        let [bx, by, bz] = [0, 1, 2].map(|axis| v2[axis] - v0[axis]);
        let [x, y, z] = [0, 1, 2].map(|axis| aim.origin[axis] - v0[axis]);
        let (sx, sy, sz) = (dy * bz - dz * by, dz * bx - dx * bz, dx * by - dy * bx);
        let (qx, qy, qz) = (y * az - z * ay, z * ax - x * az, x * ay - y * ax);
        let det = ax * sx + ay * sy + az * sz;
        let sign = det.to_bits() & 0x8000_0000;
        let turned = |x: f32| f32::from_bits(x.to_bits() ^ sign);
        let (u, v) = (turned(x * sx + y * sy + z * sz), turned(dx * qx + dy * qy + dz * qz));
        let (size, t) = (turned(det), turned(bx * qx + by * qy + bz * qz));
        let inside = (u >= aim.side) & (v >= aim.side) & (size + aim.third >= u + v);
        let between = (t + aim.along >= aim.first * size) & (aim.last * size + aim.along >= t);
        mask |= u32::from(inside & between | (FLAT >= size)) << i;
    }
    mask & pack.filled()
}

/// The same in AVX2.
#[cfg(target_arch = "x86_64")]
#[inline]
#[target_feature(enable = "avx2")]
pub(super) fn sift_avx2(pack: &Pack, ray: &LocalRay, limit: f32) -> u32 {
    use std::arch::x86_64::*;
    let aim = match Aim::of(pack, ray, limit) {
        Aimed::At(aim) => aim,
        Aimed::Past => return 0,
        Aimed::Lost => return pack.filled(),
    };
    let all = |x: f32| _mm256_set1_ps(x);
    let (mul, add, sub) =
        (|a, b| _mm256_mul_ps(a, b), |a, b| _mm256_add_ps(a, b), |a, b| _mm256_sub_ps(a, b));
    let dot = |a: [__m256; 3], b: [__m256; 3]| add(add(mul(a[0], b[0]), mul(a[1], b[1])), mul(a[2], b[2]));
    let cross = |a: [__m256; 3], b: [__m256; 3]| {
        let minor = |i: usize, j: usize| sub(mul(a[i], b[j]), mul(a[j], b[i]));
        [minor(1, 2), minor(2, 0), minor(0, 1)]
    };
    let load = |c: usize, axis: usize| {
        // SAFETY: the load is of the eight numbers of an array of eight, aligned as they are.
        let words = unsafe { _mm_load_si128(pack.corner[c][axis].as_ptr().cast()) };
        _mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(words))
    };
    let d = [all(ray.direction32[0]), all(ray.direction32[1]), all(ray.direction32[2])];
    let v0 = [load(0, 0), load(0, 1), load(0, 2)];
    let e1 = [sub(load(1, 0), v0[0]), sub(load(1, 1), v0[1]), sub(load(1, 2), v0[2])];
    let e2 = [sub(load(2, 0), v0[0]), sub(load(2, 1), v0[1]), sub(load(2, 2), v0[2])];
    let o = aim.origin;
    let from = [sub(all(o[0]), v0[0]), sub(all(o[1]), v0[1]), sub(all(o[2]), v0[2])];
    let (s, q) = (cross(d, e2), cross(from, e1));
    let det = dot(e1, s);
    let sign = _mm256_and_ps(det, all(-0.0));
    let turned = |x| _mm256_xor_ps(x, sign);
    let (u, v) = (turned(dot(from, s)), turned(dot(d, q)));
    let (size, t) = (turned(det), turned(dot(e2, q)));
    let at_least = |a, b| _mm256_cmp_ps::<_CMP_GE_OQ>(a, b);
    let and = |a, b| _mm256_and_ps(a, b);
    let third = at_least(add(size, all(aim.third)), add(u, v));
    let inside = and(and(at_least(u, all(aim.side)), at_least(v, all(aim.side))), third);
    let early = at_least(add(t, all(aim.along)), mul(all(aim.first), size));
    let late = at_least(add(mul(all(aim.last), size), all(aim.along)), t);
    let unsure = at_least(all(FLAT), size);
    let mask = _mm256_or_ps(and(inside, and(early, late)), unsure);
    // SAFETY: likewise.
    let ids = unsafe { _mm256_load_si256(pack.id.as_ptr().cast()) };
    let missing = _mm256_castsi256_ps(_mm256_cmpeq_epi32(ids, _mm256_set1_epi32(-1)));
    _mm256_movemask_ps(_mm256_andnot_ps(missing, mask)) as u32
}
