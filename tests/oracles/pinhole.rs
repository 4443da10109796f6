//! Light through a hole against closed forms of other origin.

use glam::DVec2;
use lightbench::measure::{agrees, rounding, truncation};
use lightbench::scene::pinhole::{
    coaxial_discs_share, hole_solid_angle, rectangle_solid_angle, solid_angle_density,
};
use std::f64::consts::{FRAC_1_SQRT_2, TAU};

/// Two equal discs as far apart as their radius share (3 − √5)/2; a point and a disc, sin² of its half angle.
#[test]
fn discs_share_light_as_the_catalogues_say() {
    let equal = coaxial_discs_share(1.0, 1.0, 1.0);
    assert!(agrees(equal, 0.5 * (3.0 - 5f64.sqrt()), rounding(28, 1.0)), "{equal}");
    for (to, distance) in [(0.01, 0.1), (1.0, 1.0), (3.0, 0.5)] {
        let sin2 = to * to / (to * to + distance * distance);
        let share = coaxial_discs_share(1e-9, to, distance);
        // The point's own size enters with its square over the distance's.
        assert!(
            agrees(share, sin2, truncation(1e-18 / (distance * distance)) + rounding(32, sin2)),
            "{share}"
        );
    }
}

#[test]
fn a_hole_at_45_degrees_is_a_cap() {
    let omega = hole_solid_angle(2.0, 2.0);
    assert!(agrees(omega, TAU * (1.0 - FRAC_1_SQRT_2), rounding(14, TAU)), "{omega}");
}

/// A face of a cube covers a sixth of the sphere.
#[test]
fn a_picture_of_90_degrees_is_a_face_of_a_cube() {
    let omega = rectangle_solid_angle(DVec2::NEG_ONE, DVec2::ONE);
    assert!(agrees(omega, TAU / 3.0, rounding(40, TAU)), "{omega}");
}

/// The density is what small pixels tend to.
#[test]
fn small_pixels_see_cos_cubed() {
    const HALF: f64 = 1e-3;
    for p in [DVec2::ZERO, DVec2::new(0.5, -0.2), DVec2::new(2.0, 1.0), DVec2::new(0.0, 7.0)] {
        let omega = rectangle_solid_angle(p - HALF, p + HALF);
        let area = 4.0 * HALF * HALF;
        // Mean over the pixel: HALF²/6 times the Laplacian, at most 6 in size; rounding over the area.
        let tolerance = truncation(HALF * HALF) + rounding(40, 2.0 * TAU) / area;
        let found = omega / area;
        assert!(agrees(found, solid_angle_density(p), tolerance), "{found} at {p}");
    }
}
