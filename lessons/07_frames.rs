//! Lesson 07. What does it cost to move, turn and stretch a shape, and where do frames break?
//!
//! Builds on:  01 (the camera's right, up and forward), 06 (shapes along the axes).
//! New here:   affine maps; a ray in the shape's own space; normals under a stretch; bases round a direction;
//!             polyhedra as half-spaces; rotations by matrix and by quaternion.
//! Notation:   M the map's matrix, T its translation; p ↦ M p + T; n normal, f forward; u = 2⁻⁵³ one rounding.
//! Predict:    a ball is flattened to half its height, and its normals with it. By how many degrees are they wrong?
//! Figure:     07_frames_speed_accuracy_time.svg, 07_frames_bases.svg

#[path = "07_frames/charts.rs"]
mod charts;
#[path = "07_frames/diagrams.rs"]
mod diagrams;
#[path = "07_frames/measured.rs"]
mod measured;
#[path = "07_frames/moved.rs"]
mod moved;
#[path = "07_frames/stage.rs"]
mod stage;

use glam::{DMat3, DQuat, DVec3, dvec3};
use lightbench::frame::{duff, frisvad, transform_normal};
use lightbench::measure::{Method, Point, Series, log_spaced, rounding};
use lightbench::num::real::Real;
use lightbench_kit::figure::short;
use lightbench_kit::lesson::{Lesson, Result};
use measured::{defects, quaternions_agree, tilts};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

const STRETCH: DVec3 = dvec3(1.0, 0.5, 1.0); // of the picture with wrong normals
const GAPS: (f64, f64) = (1.0e-16, 1.0); // 1 + z of the directions round which bases are built
const TURN: f64 = 0.1; // rad, of each of the many rotations that are composed

fn main() -> Result {
    let lesson = Lesson::without_essay(7)?;

    // 1. The truth: what the words mean, two rotations by hand, and meetings in 106 bits in the shape's own space.
    diagrams::save(&lesson)?;
    rotations_by_hand(&lesson);
    let rays = lesson.pick([64, 512, 4096, 16384]);

    // 2. The contestants: a shape moved, or made in its place; two bases; two normals; matrix and quaternion.
    let contest = moved::contest(&lesson, rays);
    let gaps = log_spaced(GAPS.0, GAPS.1, lesson.pick([33, 33, 65, 65]));
    let bases = [
        (Method::new("Frisvad, f32").styled(1), defects(&lesson, &gaps, frisvad::<f32>)),
        (Method::new("Frisvad, f64").styled(3), defects(&lesson, &gaps, frisvad::<f64>)),
        (Method::new("Duff, f32").styled(4), defects(&lesson, &gaps, duff::<f32>)),
        (Method::default_of("Duff, f64").styled(0), defects(&lesson, &gaps, duff::<f64>)),
    ];
    let stretches = log_spaced(1.0, 1.0e3, lesson.pick([7, 13, 25, 25]));
    let normals = [
        (Method::new("M n").styled(1), tilts(&lesson, &stretches, rays, |m, n| Some((*m * n).normalize()))),
        (Method::default_of("M⁻ᵀ n").styled(0), tilts(&lesson, &stretches, rays, transform_normal)),
    ];

    // 3. The figures.
    lesson.save("speed_accuracy", charts::speed(&contest, rays))?;
    lesson.save("stability", charts::stability(&contest, rays))?;
    lesson.save("bases", charts::bases(&bases))?;
    lesson.save("look_at", charts::look_at())?;
    lesson.save("normals", charts::normals(&normals))?;
    lesson.save(
        "drift",
        charts::drift(lesson.seed(), TURN, lesson.pick([1000, 100_000, 1_000_000, 1_000_000])),
    )?;
    lesson.save("normals_picture", stage::normals(STRETCH, lesson.pick([48, 300, 400, 600])))?;
    lesson.save(
        "all_surfaces",
        stage::all_surfaces(lesson.pick([48, 360, 640, 960]), lesson.pick([1, 4, 16, 64]), lesson.seed()),
    )?;

    // 4. What the figures show, checked.
    let worst = |s: &Series| s.points.iter().filter_map(|p| p.error).map(|e| e.mid).fold(0.0, f64::max);
    // γ₁₆: a rounded direction is within 2 u of length 1, and the basis multiplies and adds some ten times.
    let [lost, kept] = [worst(&bases[0].1), worst(&bases[3].1)];
    lesson.claim(
        &format!(
            "near z = −1 Frisvad's basis in f32 is off by up to {}; Duff's in f64 stays orthonormal to {}",
            short(lost),
            short(kept)
        ),
        lost > 0.1 && kept <= rounding(16, 1.0) && worst(&bases[2].1) <= 16.0 * f32::ROUNDOFF,
    );
    // sin of the largest angle between M n and M⁻ᵀ n under a stretch s: (s² − 1)/(s² + 1). The sampled worst lies below.
    let closed = |s: f64| ((s * s - 1.0) / (s * s + 1.0)).asin();
    let under = |p: &Point| p.error.is_some_and(|e| e.mid <= closed(p.parameter) + rounding(40, 1.0));
    lesson.claim("M n is off by up to asin((s² − 1)/(s² + 1)), M⁻ᵀ n by rounding only", {
        let near = normals[0].1.points.iter().filter_map(|p| p.error.map(|e| (e.mid, closed(p.parameter))));
        normals[0].1.points.iter().all(under)
            && near.into_iter().all(|(found, c)| found >= 0.5 * c)
            && worst(&normals[1].1) <= rounding(40, 1.0)
    });
    let agree = quaternions_agree(lesson.seed(), rays);
    lesson.claim(
        "quaternion and matrix turn every vector the same way, to 40 roundings",
        agree <= rounding(40, 1.0),
    );
    let at = |k: usize| moved::cost(&contest[k].1, 1.0e3);
    let ((e0, t0), (e1, t1)) = (at(0), at(1));
    lesson.answer(&format!(
        "moving is cheap: at 10³ radii a stretched unit sphere takes {:.1} × the time of our error-bounded ellipsoid and errs {} \
         times as much, for the map's own rounding; flattened to half, normals sent through M instead of M⁻ᵀ tilt by up to {:.0}°; and frames break \
         at their pole: looking along up, and at z = −1, where Frisvad's basis in f32 is off by {}.",
        t1 / t0, short(e1 / e0), closed(2.0).to_degrees(), short(lost)
    ))
}

/// B's worked rotations: row vectors, the matrix printed first and the one that holds.
fn rotations_by_hand(lesson: &Lesson) {
    let row = |p: DVec3, m: [[f64; 3]; 3]| {
        DVec3::from_array([0, 1, 2].map(|j| (0..3).map(|i| p[i] * m[i][j]).sum::<f64>()))
    };
    let printed = |a: f64| [[a.cos(), a.sin(), 0.0], [a.sin(), a.cos(), 0.0], [0.0, 0.0, 1.0]];
    let right = |a: f64| [[a.cos(), a.sin(), 0.0], [-a.sin(), a.cos(), 0.0], [0.0, 0.0, 1.0]];
    let told = |p: DVec3| format!("({:.4}, {:.4})", p.x, p.y).replace("-0.0000", "0.0000");
    let mut text =
        String::from("B's rotations about z (row vectors), printed first | final | by quaternion:");
    for (name, p, angle) in [
        ("(1,0), 90°", DVec3::X, FRAC_PI_2),
        ("(1,0), 45°", DVec3::X, FRAC_PI_4),
        ("(0,1), −90°", DVec3::Y, -FRAC_PI_2),
    ] {
        let turned = DQuat::from_rotation_z(angle) * p;
        text += &format!(
            "\n  {name:<12} {} | {} | {}",
            told(row(p, printed(angle))),
            told(row(p, right(angle))),
            told(turned)
        );
    }
    let flat = DMat3::from_cols_array_2d(&printed(FRAC_PI_4)).determinant();
    lesson.say(&format!("{text}\nThe first matrix has determinant cos 2θ: {flat:.0e} at 45°, where it presses the plane into a line."));
}
