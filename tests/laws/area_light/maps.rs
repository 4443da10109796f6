//! Maps of the unit square to lights, uniform by solid angle.

use super::super::support::{Cone, Square, Triangle, mean_matches, nasty, sample_matches_pdf};
use super::cases;
use glam::{DVec2, DVec3};
use lightbench::frame::basis;
use lightbench::light::{
    SphericalCap, SphericalRectangle, SphericalTriangle, polygon_irradiance, sphere_irradiance,
};
use lightbench::num::U;
use lightbench::sample::{Sampler, uniform_sphere, uniform_triangle};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const ORIGIN: DVec3 = DVec3::ZERO;

/// Receivers of a light in the plane z = 0, about 1 wide: above, aside, far, near, near and aside, grazing.
const RECEIVERS: [DVec3; 7] = [
    DVec3::new(0.1, 0.2, 0.8),
    DVec3::new(2.0, -1.5, -0.7),
    DVec3::new(30.0, 20.0, 10.0),
    DVec3::new(0.2, 0.1, 0.02),
    DVec3::new(-0.7, 0.1, 0.02),
    DVec3::new(1.2, -1.4, 1e-9),
    DVec3::new(3e6, 1e6, -2e6),
];

/// Density per area is `z/(r³ Ω)`; in shares of the sides, times the area.
#[test]
fn rectangles_follow_their_density() {
    let (w, h) = (DVec3::X * 0.5, DVec3::Y * 0.75);
    for p in RECEIVERS {
        let light = SphericalRectangle::new(ORIGIN, w, h, p);
        let sample = |s: &mut Sampler| {
            let q = light.point(s.next_2d());
            Some(DVec2::new(0.5 + 0.5 * q.x / w.x, 0.5 + 0.5 * q.y / h.y))
        };
        let density = |st: DVec2| {
            let q = w * (2.0 * st.x - 1.0) + h * (2.0 * st.y - 1.0);
            4.0 * w.x * h.y * p.z.abs() / (q - p).length().powi(3) / light.solid_angle()
        };
        sample_matches_pdf(&format!("rectangle from {p}"), &Square, sample, density);
    }
}

#[test]
fn triangles_follow_their_density() {
    let v = [DVec3::new(-0.6, -0.5, 0.0), DVec3::new(0.7, -0.4, 0.0), DVec3::new(0.1, 0.8, 0.0)];
    let area = 0.5 * (v[1] - v[0]).cross(v[2] - v[0]).length();
    for p in RECEIVERS {
        let light = SphericalTriangle::new(v, p);
        let share = |q: DVec3, i: usize| {
            let (a, b) = (v[(i + 1) % 3] - q, v[(i + 2) % 3] - q);
            (0.5 * a.cross(b).z / area).max(0.0) // the sampled point is in the triangle but for rounding
        };
        let sample = |s: &mut Sampler| {
            let q = light.point(s.next_2d());
            Some(DVec3::new(share(q, 0), share(q, 1), share(q, 2)))
        };
        let density = |b: DVec3| {
            let q = v[0] * b.x + v[1] * b.y + v[2] * b.z;
            area * p.z.abs() / (q - p).length().powi(3) / light.solid_angle()
        };
        sample_matches_pdf(&format!("triangle from {p}"), &Triangle, sample, density);
    }
}

/// Over the directions of the cone, `1/Ω`; the angle is measured from the axis by a cross product.
#[test]
fn spheres_follow_their_density() {
    for (distance, radius) in [(1.0, 0.5), (1.0, 0.999_999), (1.0, 1e-3), (1.0, 1e-7), (40.0, 30.0)] {
        let axis = DVec3::new(0.48, 0.6, 0.64);
        let (x, y) = basis(axis);
        let light = SphericalCap::new(axis * distance, radius, ORIGIN);
        let versine = light.solid_angle() / TAU;
        let sample = |s: &mut Sampler| {
            let w = light.point(s.next_2d()).normalize();
            let w = DVec3::new(w.dot(x), w.dot(y), w.dot(axis));
            // A point of a tiny sphere is rounded where it stands, by u of its distance.
            let aside = w.truncate().length();
            let rim = (versine * (2.0 - versine)).sqrt();
            let slack = (rim / aside).min(1.0);
            if aside <= rim + 8.0 * U { Some(DVec3::new(w.x * slack, w.y * slack, w.z)) } else { Some(-w) }
        };
        let name = format!("sphere of {radius} at {distance}");
        sample_matches_pdf(&name, &Cone { versine }, sample, |_| 1.0 / light.solid_angle());
    }
    let inside = SphericalCap::new(ORIGIN, 2.0, DVec3::new(0.5, 1.2, -0.7));
    let sample = |s: &mut Sampler| Some((inside.point(s.next_2d()) - DVec3::new(0.5, 1.2, -0.7)).normalize());
    sample_matches_pdf("inside", &Cone::SPHERE, sample, |_| 1.0 / inside.solid_angle());
}

#[test]
fn solid_angles_in_closed_form() {
    let octant = SphericalTriangle::new([DVec3::X, DVec3::Y, DVec3::Z], ORIGIN);
    assert!((octant.solid_angle() - FRAC_PI_2).abs() <= 8.0 * U);
    let face = SphericalRectangle::new(DVec3::Z, DVec3::X, DVec3::Y, ORIGIN);
    assert!((face.solid_angle() - 4.0 * PI / 6.0).abs() <= 16.0 * U);
    let sky = SphericalRectangle::new(DVec3::Z * 1e-20, DVec3::X, DVec3::Y, ORIGIN);
    assert!((sky.solid_angle() - TAU).abs() <= 16.0 * U);
    // Above an edge half of it, above a corner a quarter.
    let edge = SphericalRectangle::new(DVec3::new(1.0, 0.0, 1e-20), DVec3::X, DVec3::Y, ORIGIN);
    assert!((edge.solid_angle() - PI).abs() <= 16.0 * U);
    let corner = SphericalRectangle::new(DVec3::new(1.0, -1.0, 1e-20), DVec3::X, DVec3::Y, ORIGIN);
    assert!((corner.solid_angle() - FRAC_PI_2).abs() <= 16.0 * U);
    let cap = SphericalCap::new(DVec3::X * 5.0, 3.0, ORIGIN);
    assert!((cap.solid_angle() - TAU * 0.2).abs() <= 16.0 * U); // cosine 4/5
    assert_eq!(SphericalCap::new(DVec3::X, 1.0, ORIGIN).solid_angle(), TAU);
    assert_eq!(SphericalCap::new(DVec3::X, 1.5, ORIGIN).solid_angle(), 2.0 * TAU);
}

/// Distances from the plane have an error of 4 u of the distance from the nearest corner or the centre.
#[test]
fn a_rectangle_is_two_triangles() {
    for case in cases("two triangles", 3000) {
        let [a, b, c, d] = case.corners();
        let whole = SphericalRectangle::new(case.center, case.half_width, case.half_height, case.p);
        let of = |v| SphericalTriangle::new(v, case.p).solid_angle();
        let parts = of([a, b, c]) + of([a, c, d]);
        let up = case.half_width.cross(case.half_height).normalize();
        let height = up.dot(case.center - case.p).abs();
        let tolerance = 64.0 * U * case.center.distance(case.p).max(1.0) / height * parts.min(1.0);
        assert!((whole.solid_angle() - parts).abs() <= tolerance + 64.0 * U, "{parts}");
    }
}

/// What is cut off at `u_x` has the share `u_x` of the solid angle: an exact law, at every size and without statistics.
///
/// Rounding: some 32 u of the place and of two solid angles, times `r/z`, with `r` the largest distance: up to 62 u r/z in 400 000 cases.
#[test]
fn shares_are_shares_at_every_size() {
    let unit = |x: f64| 2f64.powi(-x as i32);
    for exponent in (-4..400).step_by(4).map(f64::from) {
        for mut case in cases("shares", 40) {
            let size = unit(exponent);
            let up = case.half_width.cross(case.half_height).normalize();
            let (w, h, mut p) = (case.half_width * size, case.half_height * size, case.p - case.center);
            if case.sampler.next_1d() < 0.2 {
                p -= up * (up.dot(p) * (1.0 - 10f64.powf(-9.0 * case.sampler.next_1d()))); // grazing
            }
            let height = up.dot(p).abs() / (p.length() + w.length() + h.length());
            let tolerance = 256.0 * U / height;
            let u = case.sampler.next_2d();

            let light = SphericalRectangle::new(ORIGIN, w, h, p);
            let q = light.point(u);
            let along = 0.5 + 0.5 * q.dot(w / size) / (w / size).length_squared() / size;
            let cut = SphericalRectangle::new(w * (along - 1.0), w * along, h, p);
            let share = cut.solid_angle() / light.solid_angle();
            assert!((share - u.x).abs() <= tolerance, "rectangle 2^-{exponent}: {share} {u}");

            let v = [-w - h, w - h, w * 0.3 + h];
            let light = SphericalTriangle::new(v, p);
            let q = light.point(DVec2::new(u.x, 1.0));
            let share = SphericalTriangle::new([v[0], v[1], q], p).solid_angle() / light.solid_angle();
            assert!((share - u.x).abs() <= tolerance, "triangle 2^-{exponent}: {share} {u}");
        }
    }
}

/// The mean over points of `cos θ Ω` by solid angle, and of `cos θ cos θₗ A/r²` by area, is the irradiance.
#[test]
fn both_maps_estimate_the_irradiance() {
    let mut tested = 0;
    for (i, case) in cases("estimates", 40).enumerate() {
        let v = case.corners();
        let truth = polygon_irradiance(&v, case.p, case.n);
        let normal = case.half_width.cross(case.half_height).normalize();
        // The other estimator's variance grows with 1/distance²; and little may be seen too seldom for a t-test.
        let depth = normal.dot(case.center - case.p).abs();
        if depth < 0.3 || truth < 0.02 {
            continue;
        }
        tested += 1;
        let samples = |k: u64| {
            (0..40_000).map(move |j| Sampler::new(super::seed("estimate"), 9 * i as u64 + k, j).next_2d())
        };
        let cosine = |q: DVec3| (q - case.p).normalize().dot(case.n).max(0.0);
        let by_area = |q: DVec3| {
            let r = q - case.p;
            cosine(q) * normal.dot(r).abs() / r.length().powi(3)
        };
        let area = 4.0 * case.half_width.length() * case.half_height.length();
        let light = SphericalRectangle::new(case.center, case.half_width, case.half_height, case.p);
        mean_matches("rectangle", truth, samples(0).map(|u| cosine(light.point(u)) * light.solid_angle()));
        let at = |u: DVec2| {
            case.center + case.half_width * (2.0 * u.x - 1.0) + case.half_height * (2.0 * u.y - 1.0)
        };
        mean_matches("rectangle by area", truth, samples(1).map(|u| by_area(at(u)) * area));

        let v = [v[0], v[1], v[2]];
        let truth = polygon_irradiance(&v, case.p, case.n);
        if truth > 0.02 {
            let light = SphericalTriangle::new(v, case.p);
            mean_matches("triangle", truth, samples(2).map(|u| cosine(light.point(u)) * light.solid_angle()));
            let at = |u: DVec2| {
                let b = uniform_triangle(u);
                v[0] * b.x + v[1] * b.y + v[2] * b.z
            };
            mean_matches("triangle by area", truth, samples(3).map(|u| by_area(at(u)) * area * 0.5));
        }

        let radius = 0.9 * (case.center - case.p).length() * case.half_width.length() / 1.6;
        let truth = sphere_irradiance(case.center, radius, case.p, case.n);
        if truth > 0.02 {
            let light = SphericalCap::new(case.center, radius, case.p);
            mean_matches("sphere", truth, samples(4).map(|u| cosine(light.point(u)) * light.solid_angle()));
            let by_area = |u: DVec2| {
                let out = uniform_sphere(u);
                let r = case.center + out * radius - case.p;
                let faces = -out.dot(r).min(0.0);
                cosine(r + case.p) * faces / r.length().powi(3) * 2.0 * TAU * radius * radius
            };
            mean_matches("sphere by area", truth, samples(5).map(by_area));
        }
    }
    assert!(tested >= 8, "{tested}");
}

#[test]
fn a_receiver_in_the_plane_sees_nothing_and_gets_a_point() {
    let (w, h) = (DVec3::X, DVec3::Y * 2.0);
    let v = [-w - h, w - h, w + h];
    for p in [ORIGIN, w, w + h, w - h, DVec3::X * 3.0, DVec3::new(5.0, 7.0, 0.0)] {
        for u in [DVec2::ZERO, DVec2::ONE, DVec2::new(0.3, 0.8), DVec2::X, DVec2::Y] {
            let light = SphericalRectangle::new(ORIGIN, w, h, p);
            let q = light.point(u);
            assert!(light.solid_angle() == 0.0 && q.abs().cmple(w + h).all(), "{p} {u}: {q}");
            let light = SphericalTriangle::new(v, p);
            let q = light.point(u);
            assert!(
                light.solid_angle() == 0.0 && q.is_finite() && q.abs().cmple((w + h) * (1.0 + 4.0 * U)).all()
            );
        }
    }
    let nothing = SphericalCap::new(w, 0.0, ORIGIN);
    assert_eq!((nothing.solid_angle(), nothing.point(DVec2::splat(0.3))), (0.0, w));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 2000, ..ProptestConfig::default() })]

    /// Coordinates are convex combinations, to 16 u of the largest.
    #[test]
    fn points_lie_on_the_light(
        place in nasty::point(),
        aside in nasty::point(),
        to_p in nasty::point(),
        w in nasty::unit_vector(),
        turn in nasty::unit_vector(),
        size in (nasty::positive(), nasty::positive()),
        u in nasty::unit_square(),
        corner in any::<bool>(),
    ) {
        let h = (turn - w * turn.dot(w)).try_normalize().unwrap_or_else(|| w.any_orthonormal_vector());
        let (w, h) = (w * size.0, h * size.1);
        let p = if corner { place + w + h } else { to_p };
        let light = SphericalRectangle::new(place, w, h, p);
        prop_assert!((0.0..=TAU).contains(&light.solid_angle()), "{}", light.solid_angle());
        let reach = w.abs() + h.abs();
        let slack = (place.abs() + reach) * (16.0 * U);
        let q = light.point(u);
        prop_assert!((q - place).abs().cmple(reach + slack).all(), "rectangle {} {} {}", place, q, reach);

        let v = [place, aside, place + w];
        let light = SphericalTriangle::new(v, p);
        prop_assert!((0.0..=TAU).contains(&light.solid_angle()), "{}", light.solid_angle());
        let (low, high) = (v[0].min(v[1]).min(v[2]), v[0].max(v[1]).max(v[2]));
        let slack = low.abs().max(high.abs()) * (16.0 * U);
        let q = light.point(u);
        prop_assert!(q.cmpge(low - slack).all() && q.cmple(high + slack).all(), "triangle {} {} {}", low, q, high);

        let light = SphericalCap::new(place, size.0, p);
        prop_assert!((0.0..=2.0 * TAU).contains(&light.solid_angle()), "{}", light.solid_angle());
        let q = light.point(u);
        let slack = size.0 * 16.0 * U + 4.0 * U * place.length();
        prop_assert!(((q - place).length() - size.0).abs() <= slack, "sphere {} {} {}", place, q, size.0);
    }
}
