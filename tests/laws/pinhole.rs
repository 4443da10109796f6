//! Laws of the pinhole: it turns the picture over, shares light both ways alike, and is sharpest at one size.

use crate::support::nasty;
use glam::DVec2;
use lightbench::measure::{agrees, rounding};
use lightbench::scene::obscura_from_camera;
use lightbench::scene::pinhole::{
    blur, coaxial_discs_share, diffraction_blur, hole_solid_angle, obscura_line, rectangle_solid_angle,
    shadow_blur, sharpest_hole, solid_angle_density,
};
use proptest::prelude::*;
use std::f64::consts::TAU;

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// The line from a point of the film through the hole meets only points whose light ends there.
    #[test]
    fn film_and_scene_are_joined_by_one_line(
        x in -10.0..10.0, y in -10.0..10.0, depth in 0.01..10.0, far in 1.01..100.0,
    ) {
        let film = DVec2::new(x, y);
        let (origin, direction) = obscura_line(film, DVec2::ZERO, depth);
        let image = obscura_from_camera(origin + direction * far, depth).expect("in front of the hole");
        // film − far·film cancels down to (far − 1), and so does the depth: far/(far − 1) roundings, 8 in all.
        let tolerance = rounding(8, film.length() * far / (far - 1.0));
        prop_assert!(image.distance(film) <= tolerance, "{image} for {film}");
    }

    #[test]
    fn nothing_behind_the_hole_is_seen(p in nasty::point()) {
        prop_assert_eq!(obscura_from_camera(p, 1.0).is_some(), p.z < 0.0);
    }

    /// Area times share is the same in both directions.
    #[test]
    fn discs_share_light_both_ways_alike(
        a in nasty::positive(), b in nasty::positive(), h in nasty::positive(),
    ) {
        let (there, back) = (coaxial_discs_share(a, b, h), coaxial_discs_share(b, a, h));
        prop_assert!((0.0..=1.0 + rounding(24, 1.0)).contains(&there), "{there}");
        // Squares of the ratio leave the format early; then one of the shares is 0, or near it.
        let ratio = (b / a) * (b / a);
        if (1e-200..1e200).contains(&ratio) && there.min(back) > 1e-100 {
            prop_assert!(agrees(there / ratio, back, rounding(52, back)), "{there} / {ratio} against {back}");
        }
    }

    /// At the sharpest hole both spots are equal; a wider or narrower one is not sharper.
    #[test]
    fn no_hole_is_sharper_than_the_sharpest(
        depth in 1e-3..10.0, distance in 1e-2..1e3, wavelength in 4e-7..8e-7, factor in 0.1..10.0,
    ) {
        let hole = sharpest_hole(depth, distance, wavelength);
        let (shadow, rings) = (shadow_blur(hole, depth, distance), diffraction_blur(hole, depth, wavelength));
        prop_assert!(agrees(shadow, rings, rounding(16, rings)), "{shadow} and {rings}");
        let least = blur(hole, depth, distance, wavelength);
        prop_assert!(blur(hole * factor, depth, distance, wavelength) >= least - rounding(16, least));
    }

    /// The parts of a rectangle cover its solid angle.
    #[test]
    fn solid_angles_of_parts_add_up(x in -5.0..5.0, y in -5.0..5.0, w in 0.0..5.0, h in 0.0..5.0, s in 0.0..1.0) {
        let (min, max) = (DVec2::new(x, y), DVec2::new(x + w, y + h));
        let cut = x + s * w;
        let left = rectangle_solid_angle(min, DVec2::new(cut, max.y));
        let right = rectangle_solid_angle(DVec2::new(cut, min.y), max);
        // Twelve corners, each an angle up to π/2 after some six roundings, and their sums up to 2π.
        prop_assert!(agrees(left + right, rectangle_solid_angle(min, max), rounding(12 * 8, TAU)));
    }

    #[test]
    fn a_pixel_sees_the_less_the_farther_from_the_axis(x in 0.0..1e3f64, step in 0.01..10.0f64) {
        let density = |x: f64| solid_angle_density(DVec2::new(x, 0.0));
        prop_assert!(density(x + step) < density(x) && density(x) <= 1.0);
    }

    #[test]
    fn a_hole_covers_at_most_half_of_all_directions(radius in nasty::magnitude(), distance in nasty::positive()) {
        let omega = hole_solid_angle(radius, distance);
        prop_assert!((0.0..=TAU).contains(&omega), "{omega}");
    }
}

#[test]
fn a_hole_at_its_edges() {
    assert_eq!(hole_solid_angle(0.0, 1.0), 0.0);
    assert_eq!(hole_solid_angle(1.0, 0.0), TAU);
    assert!(hole_solid_angle(f64::NAN, 1.0).is_nan());
    assert_eq!(shadow_blur(2.0, 1.0, f64::INFINITY), 2.0);
}
