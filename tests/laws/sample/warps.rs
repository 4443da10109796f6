//! Laws of the warps: densities, unit lengths, edges.

use crate::support::chi2::check_sample;
use crate::support::{Cone, Disc, Triangle, nasty, sample_matches_pdf};
use glam::{DVec2, DVec3};
use lightbench::num::gamma;
use lightbench::sample::*;
use proptest::prelude::*;

#[test]
fn uniform_sphere_follows_its_pdf() {
    sample_matches_pdf(
        "sphere",
        &Cone::SPHERE,
        |s| Some(uniform_sphere(s.next_2d())),
        |_| uniform_sphere_pdf(),
    );
}

#[test]
fn uniform_hemisphere_follows_its_pdf() {
    let sample = |s: &mut Sampler| Some(uniform_hemisphere(s.next_2d()));
    sample_matches_pdf("hemisphere", &Cone::HEMISPHERE, sample, uniform_hemisphere_pdf);
    sample_matches_pdf("hemisphere in sphere", &Cone::SPHERE, sample, uniform_hemisphere_pdf);
}

#[test]
fn uniform_cone_follows_its_pdf() {
    for versine in [1e-12, 1e-3, 0.3, 1.7, 2.0] {
        let sample = |s: &mut Sampler| Some(uniform_cone(s.next_2d(), versine));
        sample_matches_pdf("cone", &Cone { versine }, sample, |w| uniform_cone_pdf(w, versine));
    }
    // The rim inside the domain, where the density jumps.
    let sample = |s: &mut Sampler| Some(uniform_cone(s.next_2d(), 0.3));
    sample_matches_pdf("cone in hemisphere", &Cone::HEMISPHERE, sample, |w| uniform_cone_pdf(w, 0.3));
}

#[test]
fn cosine_hemisphere_follows_its_pdf() {
    let sample = |s: &mut Sampler| Some(cosine_hemisphere(s.next_2d()));
    sample_matches_pdf("cosine", &Cone::HEMISPHERE, sample, cosine_hemisphere_pdf);
}

#[test]
fn power_cosine_follows_its_pdf() {
    for (n, versine) in [(0.0, 1.0), (1.0, 1.0), (3.5, 1.0), (20.0, 1.0)] {
        let sample = |s: &mut Sampler| Some(power_cosine(s.next_2d(), n));
        sample_matches_pdf("power cosine", &Cone { versine }, sample, |w| power_cosine_pdf(w, n));
    }
    // Sharp lobes: only the cone that holds most of them; samples beyond it count as lost.
    for (n, versine) in [(1e3, 5e-3), (1e8, 5e-8)] {
        let edge = 1.0 - versine;
        let sample = |s: &mut Sampler| Some(power_cosine(s.next_2d(), n)).filter(|w| w.z > edge);
        sample_matches_pdf("sharp power cosine", &Cone { versine }, sample, |w| power_cosine_pdf(w, n));
    }
}

#[test]
fn uniform_disc_follows_its_pdf() {
    sample_matches_pdf("disc", &Disc, |s| Some(uniform_disc(s.next_2d())), uniform_disc_pdf_area);
}

#[test]
fn uniform_triangles_follow_their_pdf() {
    for (name, warp) in [
        ("root", uniform_triangle as fn(DVec2) -> DVec3),
        ("fold", uniform_triangle_fold as fn(DVec2) -> DVec3),
    ] {
        sample_matches_pdf(name, &Triangle, |s| Some(warp(s.next_2d())), |_| uniform_triangle_pdf_area(1.0));
    }
}

#[test]
fn latitude_and_longitude_follow_the_pdf_with_the_sine() {
    // The printed constants leave a wedge empty; here the ideal ones.
    use std::f64::consts::{PI, TAU};
    let sample = |s: &mut Sampler| {
        let u = s.next_2d();
        let ((sin, cos), (y, x)) = ((PI * u.x).sin_cos(), (TAU * u.y).sin_cos());
        Some(DVec3::new(sin * x, sin * y, cos))
    };
    sample_matches_pdf("latitude and longitude", &Cone::SPHERE, sample, sphere_as_printed_pdf);
}

#[test]
fn the_sphere_as_printed_is_rejected() {
    let sample = |s: &mut Sampler| Some(sphere_as_printed(s.next_2d()));
    let verdict = check_sample("as printed", &Cone::SPHERE, sample, |_| uniform_sphere_pdf());
    assert!(verdict.is_err_and(|why| why.contains("do not follow")));
}

#[test]
fn normal_plus_a_point_in_the_ball_is_rejected() {
    // The classic mistake: the normal plus a random point IN the unit ball makes cos³, ON the sphere makes cos.
    let lobe =
        |s: &mut Sampler, radius: f64| Some((DVec3::Z + uniform_sphere(s.next_2d()) * radius).normalize());
    let ball = |s: &mut Sampler| {
        let radius = s.next_1d().cbrt();
        lobe(s, radius)
    };
    let verdict = check_sample("ball", &Cone::HEMISPHERE, ball, cosine_hemisphere_pdf);
    assert!(verdict.is_err_and(|why| why.contains("do not follow")));
    sample_matches_pdf("ball", &Cone::HEMISPHERE, ball, |w| power_cosine_pdf(w, 3.0));
    sample_matches_pdf("on the sphere", &Cone::HEMISPHERE, |s| lobe(s, 1.0), cosine_hemisphere_pdf);
}

#[test]
fn the_kit_rejects_what_is_wrong() {
    let sphere = |s: &mut Sampler| Some(uniform_sphere(s.next_2d()));
    let upper = |s: &mut Sampler| sphere(s).filter(|w| w.z > 0.0);
    let rejects =
        |sample: &dyn Fn(&mut Sampler) -> Option<DVec3>, pdf: &dyn Fn(DVec3) -> f64, words: &str| {
            let verdict = check_sample("wrong", &Cone::HEMISPHERE, sample, pdf);
            assert!(verdict.as_ref().is_err_and(|why| why.contains(words)), "{verdict:?}");
        };
    rejects(&sphere, &uniform_hemisphere_pdf, "outside");
    rejects(&upper, &uniform_hemisphere_pdf, "lost");
    rejects(&upper, &|_| 1.0, "integrates to");
    rejects(&|s| Some(uniform_hemisphere(s.next_2d())), &cosine_hemisphere_pdf, "do not follow");
    // 4 % more on one side than on the other.
    rejects(
        &|s| Some(uniform_hemisphere(s.next_2d())),
        &|w| uniform_hemisphere_pdf(w) * (1.0 + 0.04 * w.x.signum()),
        "do not follow",
    );
    // Half the sphere's samples lost, and a density that says so: accepted.
    assert!(check_sample("right", &Cone::HEMISPHERE, upper, |_| uniform_sphere_pdf()).is_ok());
}

/// Every warp to directions, at one `u`.
fn directions(u: DVec2, versine: f64, n: f64) -> [(&'static str, DVec3, f64); 5] {
    let (cone, power) = (uniform_cone(u, versine), power_cosine(u, n));
    [
        ("sphere", uniform_sphere(u), uniform_sphere_pdf()),
        ("hemisphere", uniform_hemisphere(u), uniform_hemisphere_pdf(uniform_hemisphere(u))),
        ("cone", cone, uniform_cone_pdf(cone, versine)),
        ("cosine", cosine_hemisphere(u), cosine_hemisphere_pdf(cosine_hemisphere(u))),
        ("power", power, power_cosine_pdf(power, n)),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn directions_are_unit_and_their_density_is_positive(
        u in nasty::unit_square(),
        versine in prop_oneof![1e-300..2.0f64, (-300.0..0.0f64).prop_map(|e| 10f64.powf(e)), Just(1.0), Just(2.0)],
        n in prop_oneof![Just(0.0), 0.0..100.0, (0.0..15.0f64).prop_map(|e| 10f64.powf(e))],
    ) {
        for (name, w, pdf) in directions(u, versine, n) {
            prop_assert!(w.is_finite(), "{} {}", name, w);
            // γ₆ in each coordinate doubles in the square; three products and two sums (γ₃) measure it.
            prop_assert!((w.length_squared() - 1.0).abs() <= gamma(2 * 6 + 3), "{} {}", name, w);
            // A lobe falls by e^(−36 n/(n+1)) at the last u, which is no underflow.
            prop_assert!(pdf > 0.0 && pdf < f64::INFINITY, "{} {} {}", name, w, pdf);
        }
        for (name, w) in [("hemisphere", uniform_hemisphere(u)), ("cosine", cosine_hemisphere(u)), ("power", power_cosine(u, n))] {
            prop_assert!(w.z > 0.0, "{} {}", name, w);
        }
    }

    #[test]
    fn disc_points_lie_in_the_disc_and_keep_their_ring(u in nasty::unit_square()) {
        let p = uniform_disc(u);
        prop_assert!(uniform_disc_pdf_area(p) > 0.0);
        // Concentric squares become circles: the radius is the larger coordinate. Cosine and product: 3 u.
        let ring = (2.0 * u - 1.0).abs().max_element();
        prop_assert!((p.length() - ring).abs() <= gamma(8) * ring, "{} {}", p.length(), ring);
    }

    #[test]
    fn barycentric_coordinates_are_a_partition(u in nasty::unit_square()) {
        for b in [uniform_triangle(u), uniform_triangle_fold(u)] {
            prop_assert!(b.min_element() >= 0.0, "{}", b);
            prop_assert!((b.element_sum() - 1.0).abs() <= gamma(6), "{}", b); // γ₄ and the two additions
        }
    }

    #[test]
    fn the_cone_keeps_the_digits_of_narrow_angles(u in nasty::unit_square(), e in -150.0..-1.0f64) {
        // sin θ = √(h(2 − h)) grows with √u_x: at the rim it is that of the cone.
        let versine = 10f64.powf(e);
        let w = uniform_cone(DVec2::new(1.0, u.y), versine);
        let sin = w.x.hypot(w.y);
        let truth = (versine * (2.0 - versine)).sqrt();
        prop_assert!((sin - truth).abs() <= gamma(8) * truth); // γ₅, and the root of the measurement
    }
}

#[test]
fn edges_of_the_square() {
    let corner = DVec2::splat(LARGEST_BELOW_ONE);
    assert_eq!(uniform_sphere(DVec2::ZERO), DVec3::Z);
    assert_eq!(uniform_sphere(DVec2::new(1.0, 0.0)), -DVec3::Z);
    assert_eq!(uniform_hemisphere(DVec2::ZERO), DVec3::Z);
    assert!(uniform_hemisphere(corner).z > 0.0);
    assert_eq!(uniform_cone(DVec2::new(0.7, 0.2), 0.0), DVec3::Z);
    assert_eq!(uniform_cone_pdf(DVec3::Z, 0.0), f64::INFINITY);
    assert_eq!(uniform_cone_pdf(DVec3::X, 0.0), 0.0);
    assert_eq!(uniform_disc(DVec2::splat(0.5)), DVec2::ZERO);
    assert_eq!(uniform_disc(DVec2::new(1.0, 0.5)), DVec2::X);
    assert_eq!(uniform_disc(DVec2::new(0.0, 0.5)), -DVec2::X);
    assert_eq!(cosine_hemisphere(DVec2::splat(0.5)), DVec3::Z);
    assert_eq!(uniform_triangle(DVec2::ZERO), DVec3::X);
    assert_eq!(uniform_triangle(DVec2::new(1.0, 0.0)), DVec3::Y);
    assert_eq!(uniform_triangle(DVec2::new(1.0, 1.0)), DVec3::Z);
    assert_eq!(uniform_triangle_pdf_area(0.0), f64::INFINITY);
    assert_eq!(power_cosine_pdf(DVec3::X, 5.0), 0.0);
    assert_eq!(power_cosine_pdf(-DVec3::Z, 5.0), 0.0);
    assert_eq!(sphere_as_printed_pdf(DVec3::Z), f64::INFINITY);
    assert!(uniform_sphere(DVec2::splat(f64::NAN)).is_nan());
    assert!(uniform_disc(DVec2::new(f64::NAN, 0.5)).is_nan());
}
