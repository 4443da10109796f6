//! The torus: roots on the surface, spans inside, coordinates that lead back.

use glam::{DVec2, DVec3};
use lightbench::num::{U, gamma};
use lightbench::ray::{Crossing, Ray, Span};
use lightbench::shape::torus::{Torus, TorusMethod};
use lightbench::shape::{Shape, Solid};
use proptest::prelude::*;

fn crossings(torus: &Torus, ray: &Ray) -> Vec<f64> {
    let mut out = Vec::new();
    torus.crossings(ray, &mut out);
    out.iter().map(|c| c.t).collect()
}

fn spans(torus: &Torus, ray: &Ray) -> Vec<Span> {
    let mut out = Vec::new();
    torus.spans(ray, &mut out);
    out
}

fn distance(torus: &Torus, p: DVec3) -> f64 {
    (p.x.hypot(p.y) - torus.ring()).hypot(p.z) - torus.tube()
}

fn direction() -> impl Strategy<Value = DVec3> {
    let any = (-1.0f64..1.0, 0.0f64..std::f64::consts::TAU).prop_map(|(z, phi)| {
        let r = (1.0 - z * z).sqrt();
        DVec3::new(r * phi.cos(), r * phi.sin(), z)
    });
    let axes = prop::sample::select(vec![DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Z]);
    prop_oneof![6 => any, 1 => axes]
}

/// Fat and thin tori, and rays that pass within 1.2 tube radii of a point of the ring, from near and far.
fn torus_and_ray() -> impl Strategy<Value = (Torus, Ray)> {
    let shape = (0.5f64..4.0, -4.0f64..-0.0005);
    let aim = (0.0f64..1.0, 0.0f64..1.0, -1.2f64..1.2);
    (shape, aim, direction(), -1.0f64..6.0, -2.0f64..2.0).prop_map(
        |((a, thin), (u, v, depth), d, far, length)| {
            let torus = Torus::new(a, a * 10f64.powf(thin)).expect("a torus");
            let ring = torus.point_at(0, DVec2::new(u, v)) * 0.0
                + DVec3::new((u * std::f64::consts::TAU).cos(), (u * std::f64::consts::TAU).sin(), 0.0) * a;
            let target = ring + (torus.point_at(0, DVec2::new(u, v)) - ring) * depth;
            let origin = target - d * (a * 10f64.powf(far));
            (torus, Ray::new(origin, d * 10f64.powf(length)))
        },
    )
}

fn nasty() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => prop::sample::select(vec![0.0, -0.0, 5e-324, -1e-310, 1e-150, -1e150, 1e300, 1.0, -1.0, f64::MAX]),
        1 => -4.0f64..4.0,
        1 => (-150.0f64..150.0).prop_map(|e| 10f64.powf(e)),
    ]
}

fn config() -> ProptestConfig {
    ProptestConfig {
        failure_persistence: None,
        rng_seed: proptest::test_runner::RngSeed::Fixed(42),
        ..ProptestConfig::with_cases(2000)
    }
}

proptest! {
    #![proptest_config(config())]

    /// `o + t d` rounds by γ₂ of its terms, t itself by 2 u, the distance by γ₆ of the point: γ₁₂ of all
    /// sizes in all.
    #[test]
    fn roots_lie_on_the_surface((torus, ray) in torus_and_ray()) {
        for t in crossings(&torus, &ray) {
            let size = ray.origin.length() + t * ray.direction.length() + torus.ring() + torus.tube();
            let off = distance(&torus, ray.at(t)).abs();
            prop_assert!(off <= gamma(12) * size, "{off:e} off, allowed {:e}", gamma(12) * size);
        }
    }

    /// Each is within 2 u of the same root.
    #[test]
    fn the_nearest_is_the_first((torus, ray) in torus_and_ray(), t_min in prop_oneof![Just(0.0), 0.0f64..10.0]) {
        let all = crossings(&torus, &ray);
        let near = torus.nearest(&ray, t_min, f64::INFINITY).map(|c| c.t);
        match (near, all.iter().find(|t| **t > t_min)) {
            (Some(n), Some(t)) => prop_assert!((n - t).abs() <= 4.0 * U * t, "{n} for {t}"),
            (n, t) => prop_assert!(n.is_none() && t.is_none(), "{n:?} for {t:?} of {all:?}"),
        }
        prop_assert_eq!(near.is_some(), torus.nearest(&ray, t_min, f64::INFINITY).is_some());
        prop_assert_eq!(torus.blocks(&ray, f64::INFINITY), !all.is_empty());
    }

    /// Rays that leave a place on the surface, just off it or inside the tube: the quick answers by signs against
    /// the list of all roots. Each is within 2 u of the same root; next to the surface a root is known as well as the
    /// surface itself in double-double, to 2⁻⁹⁵ a²/b across it.
    #[test]
    fn rays_that_begin_at_the_torus_find_the_same(
        (torus, ray) in torus_and_ray(), d in direction(), depth in -1.0f64..0.5, near in -16.0f64..0.0, end in -3.0f64..1.0
    ) {
        let Some(c) = torus.nearest(&ray, 0.0, f64::INFINITY) else { return Ok(()) };
        let hit = torus.hit(&ray, &c);
        let shift = depth * 10f64.powf(near) * torus.tube();
        let t_end = torus.ring() * 10f64.powf(end);
        let grain = 2f64.powi(-95) * torus.ring() * torus.ring() / (torus.tube() * d.dot(hit.ng).abs());
        for origin in [hit.origin_towards(d), hit.point, hit.point + hit.ng * shift] {
            let leaving = Ray::new(origin, d);
            let all = crossings(&torus, &leaving);
            for t_max in [f64::INFINITY, t_end] {
                let want = all.first().filter(|t| **t < t_max);
                match (torus.nearest(&leaving, 0.0, t_max).map(|c| c.t), want) {
                    (Some(n), Some(t)) => prop_assert!((n - t).abs() <= 4.0 * U * t + grain, "{n} for {t}"),
                    (n, t) => prop_assert!(n.is_none() && t.is_none(), "{n:?} for {t:?} of {all:?}"),
                }
                prop_assert_eq!(torus.blocks(&leaving, t_max), want.is_some());
            }
        }
    }

    /// Middles of spans are inside by half the span's depth at least; middles of gaps outside.
    #[test]
    fn entering_and_leaving_alternate((torus, ray) in torus_and_ray()) {
        let all = spans(&torus, &ray);
        let ends: Vec<f64> = all.iter().flat_map(|s| [s.enter.t, s.leave.t]).collect();
        prop_assert!(ends.windows(2).all(|w| w[0] <= w[1]));
        let speed = ray.direction.length();
        for (i, w) in ends.windows(2).enumerate() {
            // Shorter stretches than this are not resolved at this distance.
            let reach = ray.origin.length() + w[1].abs() * speed + torus.ring();
            let depth = distance(&torus, ray.at(0.5 * (w[0] + w[1])));
            if depth.abs() > gamma(12) * reach {
                prop_assert_eq!(depth < 0.0, i % 2 == 0);
                prop_assert_eq!(torus.contains(ray.at(0.5 * (w[0] + w[1]))), i % 2 == 0);
            }
        }
    }

    /// Powers of two scale without rounding, lengths and directions alike.
    #[test]
    fn scaling_by_powers_of_two_changes_nothing((torus, ray) in torus_and_ray(), e in -300i32..300, f in -300i32..300) {
        let (k, l) = (2f64.powi(e), 2f64.powi(f));
        let scaled = Torus::new(torus.ring() * k, torus.tube() * k).expect("a torus");
        let moved = Ray::new(ray.origin * k, ray.direction * l);
        let want: Vec<f64> = crossings(&torus, &ray).iter().map(|t| t * k / l).collect();
        prop_assert_eq!(crossings(&scaled, &moved), want);
    }

    /// The gradient of the quartic form at the hit point, against the normal: the gradient's two
    /// components each cancel down to the tube's radius.
    #[test]
    fn normals_are_gradients((torus, ray) in torus_and_ray()) {
        let Some(c) = torus.nearest(&ray, 0.0, f64::INFINITY) else { return Ok(()) };
        let hit = torus.hit(&ray, &c);
        let p = hit.point;
        let rho = p.x.hypot(p.y);
        let gradient = DVec3::new(p.x * (rho - torus.ring()) / rho, p.y * (rho - torus.ring()) / rho, p.z) / torus.tube();
        let tolerance = gamma(16) * (torus.ring() + torus.tube()) / torus.tube();
        prop_assert!(gradient.distance(hit.ng) <= tolerance, "{} for {gradient}", hit.ng);
        prop_assert!((hit.ng.length() - 1.0).abs() <= gamma(8));
        prop_assert!(hit.tangent.dot(hit.ng).abs() <= gamma(8));
        // Distance to the surface: the promise, and the rounding of this test.
        prop_assert!(distance(&torus, p).abs() <= hit.point_error + gamma(6) * (torus.ring() + torus.tube()));
    }

    /// Angles err by 4 u of a turn: 2π·4 u of the radius, and γ₁₂ for the point.
    #[test]
    fn coordinates_lead_back_to_the_point((torus, ray) in torus_and_ray()) {
        let Some(c) = torus.nearest(&ray, 0.0, f64::INFINITY) else { return Ok(()) };
        let hit = torus.hit(&ray, &c);
        prop_assert!(hit.uv.cmpge(DVec2::ZERO).all() && hit.uv.cmplt(DVec2::ONE).all());
        let back = torus.point_at(hit.face, hit.uv);
        let tolerance = gamma(12 + 26) * (torus.ring() + torus.tube());
        prop_assert!(back.distance(hit.point) <= tolerance, "{back} for {}", hit.point);
        prop_assert!(torus.bounds().contains(back));
    }

    #[test]
    fn nothing_undefined_comes_out(
        a in nasty(), b in nasty(), o in prop::array::uniform3(nasty()), d in prop::array::uniform3(nasty()),
    ) {
        let Ok(torus) = Torus::new(a, b) else { return Ok(()) };
        let ray = Ray::new(DVec3::from_array(o), DVec3::from_array(d));
        for method in TorusMethod::ALL {
            let torus = torus.with_method(method);
            prop_assert!(crossings(&torus, &ray).iter().all(|t| t.is_finite()), "{method:?}");
            for s in spans(&torus, &ray) {
                prop_assert!(s.enter.t <= s.leave.t, "{method:?}");
            }
            if let Some(c) = torus.nearest(&ray, 0.0, f64::INFINITY) {
                let hit = torus.hit(&ray, &c);
                prop_assert!(hit.point.is_finite() && hit.ng.is_finite() && hit.uv.is_finite(), "{method:?} {hit:?}");
            }
        }
    }
}

/// A torus whose radii and touching lines are exact in `f64`.
fn exact() -> Torus {
    Torus::new(2.0, 0.5).expect("a torus")
}

#[test]
fn touches_count_once_and_enclose_nothing() {
    let outer = Ray::new(DVec3::new(2.5, -3.0, 0.0), DVec3::Y);
    assert_eq!(crossings(&exact(), &outer), [3.0]);
    assert!(spans(&exact(), &outer).is_empty());
    let top = Ray::new(DVec3::new(-5.0, 0.0, 0.5), DVec3::X);
    assert_eq!(crossings(&exact(), &top), [3.0, 7.0]);
    assert!(spans(&exact(), &top).is_empty());
    // Touching the inner equator from inside leaves one span.
    let inner = Ray::new(DVec3::new(1.5, -4.0, 0.0), DVec3::Y);
    assert_eq!(crossings(&exact(), &inner), [2.0, 4.0, 6.0]);
    assert_eq!(spans(&exact(), &inner).len(), 1);
    assert_eq!(spans(&exact(), &inner)[0].leave, Crossing::new(6.0, 0));
}

#[test]
fn an_origin_on_the_surface_is_no_hit() {
    let out = Ray::new(DVec3::new(2.5, 0.0, 0.0), DVec3::X);
    assert_eq!(exact().nearest(&out, 0.0, f64::INFINITY), None);
    let through = Ray::new(DVec3::new(2.5, 0.0, 0.0), -DVec3::X);
    assert_eq!(crossings(&exact(), &through), [1.0, 4.0, 5.0]);
}

/// The document's program takes any negative root for "inside": a torus seen from its hole.
#[test]
fn a_torus_is_seen_from_its_hole() {
    let torus = Torus::new(2.0, 0.6).expect("a torus");
    let t = torus.nearest(&Ray::new(DVec3::ZERO, DVec3::X), 0.0, f64::INFINITY).expect("a hit").t;
    assert!((t - 1.4).abs() <= 2.0 * U * 1.4);
}

#[test]
fn other_radii_are_refused() {
    for (a, b) in [(1.0, 1.0), (1.0, 2.0), (1.0, 0.0), (-2.0, -3.0), (f64::NAN, 0.5), (f64::INFINITY, 1.0)] {
        assert!(Torus::new(a, b).is_err(), "{a} {b}");
    }
    assert!(Torus::new(1.0, 1.5).unwrap_err().to_string().contains("1.5"));
}
