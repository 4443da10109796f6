//! What lesson 07 measures beside the contest of moved shapes: bases, normals, rotations.

use glam::{DMat3, DQuat, DVec3, dvec3};
use lightbench::frame::{Frame, rotation_about};
use lightbench::measure::{Series, Tally};
use lightbench::num::real::{Real, Triple};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench_kit::lesson::Lesson;
use std::f64::consts::TAU;

/// Two vectors square to a third.
type Basis<R> = fn(Triple<R>) -> (Triple<R>, Triple<R>);

/// The worst of 64 bases round directions with `z = −1 + gap`: how far from orthonormal.
pub fn defects<R: Real>(lesson: &Lesson, gaps: &[f64], basis: Basis<R>) -> Series {
    Series::over(gaps, |gap| {
        let mut tally = Tally::new();
        for i in 0..64 {
            let turn = TAU * Sampler::new(lesson.seed(), gap.to_bits(), i).next_1d();
            let out = (gap * (2.0 - gap)).max(0.0).sqrt();
            let n = [out * turn.cos(), out * turn.sin(), gap - 1.0].map(R::from_f64);
            let (x, y) = basis(n);
            let v = [x, y, n].map(|v| DVec3::from_array(v.map(R::to_f64)));
            let off = |i: usize, j: usize| (v[i].dot(v[j]) - f64::from(u8::from(i == j))).abs();
            tally.error(
                (0..3).flat_map(|i| (i..3).map(move |j| (i, j))).map(|(i, j)| off(i, j)).fold(0.0, f64::max),
            );
        }
        tally.worst_at(gap)
    })
}

/// Angles [rad] between a transformed normal and the square to the transformed surface, under ever wider stretches.
pub fn tilts(
    lesson: &Lesson,
    stretches: &[f64],
    count: u32,
    normal: fn(&DMat3, DVec3) -> Option<DVec3>,
) -> Series {
    Series::over(stretches, |s| {
        let mut tally = Tally::new();
        for i in 0..count {
            let mut dice = Sampler::new(lesson.seed(), s.to_bits(), i);
            let n = uniform_sphere(dice.next_2d());
            let turned = rotation_about(uniform_sphere(dice.next_2d()), TAU * dice.next_1d())
                .unwrap_or(DMat3::IDENTITY);
            let m = turned * DMat3::from_diagonal(dvec3(1.0, 1.0 / s, 1.0));
            // Two tangents, sent along as the displacements that they are, span the transformed surface.
            let frame = Frame::around(n);
            let square = (m * frame.right).cross(m * frame.up).normalize();
            tally.error(
                normal(&m, n).map_or(f64::NAN, |n| n.cross(square).length().atan2(n.dot(square).abs())),
            );
        }
        tally.worst_at(s)
    })
}

/// The largest difference between a unit vector turned by quaternion, and by matrix.
pub fn quaternions_agree(seed: u64, count: u32) -> f64 {
    let apart = |i| {
        let mut dice = Sampler::new(seed, 7, i);
        let (axis, v, angle) =
            (uniform_sphere(dice.next_2d()), uniform_sphere(dice.next_2d()), TAU * dice.next_1d());
        let matrix = rotation_about(axis, angle).unwrap_or(DMat3::IDENTITY);
        (DQuat::from_axis_angle(axis.normalize(), angle) * v - matrix * v).length()
    };
    (0..count).map(apart).fold(0.0, f64::max)
}
