//! Julia sets: hits on the level set, nothing stepped over, bounds below distances, orbits that do not overflow.

use crate::shape_laws;
use crate::shapes::{Inside, Member, Pose};
use glam::{DAffine3, DMat3, DVec3, DVec4};
use lightbench::num::double_double::DoubleDouble;
use lightbench::num::real::Real;
use lightbench::num::{U, gamma};
use lightbench::ray::{Crossing, Ray};
use lightbench::sdf::julia::orbit::{
    as_printed_estimate, escape, escape_radius, length, quaternion, safe_step, squared_plus,
};
use lightbench::sdf::julia::{Julia, JuliaMethod, March};
use lightbench::shape::fan::Vectors;
use lightbench::shape::instance::Instance;
use lightbench::shape::{Shape, Solid};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use std::sync::OnceLock;

/// Every generator below, each case with a grid of its own: some 10 ms.
fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(9),
        ..ProptestConfig::with_cases(cases)
    }
}

/// The set of the race against POV-Ray, with fewer steps.
fn home() -> &'static Julia {
    static HOME: OnceLock<Julia> = OnceLock::new();
    HOME.get_or_init(|| Julia::new(DVec4::new(-0.2, 0.6, 0.2, 0.2), 6, 2.0, 0.0).expect("a set"))
}

/// An instance; its determinant holds scales up to 2^±330, so the extreme poses stop there.
fn posed(pose: &Pose) -> Instance<Julia> {
    let scale = pose.scale.clamp(2f64.powi(-330), 2f64.powi(330));
    let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| pose.vector(axis) * scale);
    let map = DAffine3::from_mat3_translation(DMat3::from_cols(x, y, z), pose.shift * scale);
    Instance::new(Box::new(home().clone()), map).expect("a map")
}

/// `|q_N| − B` of a point, with 106 bits.
fn level(julia: &Julia, p: DVec3) -> f64 {
    let c = quaternion::<DoubleDouble>(julia.c());
    let mut q = quaternion::<DoubleDouble>(p.extend(julia.w()));
    for _ in 0..julia.iterations() {
        q = squared_plus(q, c);
    }
    (length(q) - DoubleDouble::of(julia.bailout())).to_f64()
}

/// Does the surface pass between the two ends of a needle along the gradient?
fn near(p: DVec3, _face: u32, reach: f64) -> bool {
    let (_, gradient) = home().level(p).expect("a point near the set");
    let needle = gradient.normalize() * reach;
    level(home(), p + needle) >= 0.0 && level(home(), p - needle) <= 0.0
}

/// Directions from the middle name a point only where the set is a star, so coordinates need not lead back.
const JULIA: Member = Member {
    make: |pose| Box::new(posed(pose)),
    solid: Some(|pose| Box::new(posed(pose))),
    near,
    uv_slope: |_| f64::INFINITY,
    inside: Inside::Any,
};

shape_laws!(julia, JULIA);

fn unit_vector() -> impl Strategy<Value = DVec3> {
    let any = (-1.0f64..1.0, 0.0f64..std::f64::consts::TAU).prop_map(|(z, phi)| {
        let r = (1.0 - z * z).sqrt();
        DVec3::new(r * phi.cos(), r * phi.sin(), z)
    });
    let axes = prop::sample::select(vec![DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Z]);
    prop_oneof![6 => any, 1 => axes]
}

/// The added quaternion: anywhere, real, complex, 0, on the edge of the domain.
fn any_c() -> impl Strategy<Value = DVec4> {
    let part = || -1.0f64..1.0;
    prop_oneof![
        4 => [part(), part(), part(), part()].prop_map(DVec4::from_array),
        1 => (-2.0f64..0.5).prop_map(|x| DVec4::new(x, 0.0, 0.0, 0.0)),
        1 => (part(), part()).prop_map(|(x, y)| DVec4::new(x, y, 0.0, 0.0)),
        1 => prop::sample::select(vec![DVec4::ZERO, DVec4::X * -2.0, DVec4::Y * 4.0, DVec4::new(60.0, 0.0, 0.0, 80.0), DVec4::new(-0.125, -0.256, 0.847, 0.0895)]),
    ]
}

/// Sets with few and many steps, low and high bailouts, through the middle and aside.
fn any_julia() -> impl Strategy<Value = Julia> {
    let w = prop_oneof![2 => Just(0.0), 1 => -0.8f64..0.8];
    (any_c(), 0u32..14, prop::sample::select(vec![0.5, 1.5, 2.0, 8.0, 1000.0, 1e60]), w)
        .prop_map(|(c, n, b, w)| Julia::new(c, n, b, w).expect("a set"))
}

/// Rays towards the ball of radius 1.5 about the middle, from inside it and from up to 10⁶ away.
fn any_ray() -> impl Strategy<Value = Ray> {
    (unit_vector(), unit_vector(), 0.0f64..1.5, -2.0f64..6.0, -3.0f64..3.0).prop_map(
        |(d, aside, off, far, speed)| Ray::new(aside * off - d * 10f64.powf(far), d * 10f64.powf(speed)),
    )
}

fn crossings(shape: &dyn Shape, ray: &Ray) -> Vec<f64> {
    let mut out = Vec::new();
    shape.crossings(ray, &mut out);
    out.iter().map(|c| c.t).collect()
}

/// What rounding may do to `|q_N|` at a point known to `place`: every step rounds by γ₁₂ of |q|² + |c| and stretches errors by 2|q|.
fn rounding_of_level(julia: &Julia, p: DVec3, place: f64) -> f64 {
    let c = quaternion::<f64>(julia.c());
    let mut q = quaternion::<f64>(p.extend(julia.w()));
    let mut error = place + gamma(12) * length(q);
    for _ in 0..julia.iterations() {
        let size = length(q);
        error = (2.0 * size + error) * error + gamma(12) * (size * size + julia.c().length());
        q = squared_plus(q, c);
    }
    error + gamma(12) * length(q)
}

proptest! {
    #![proptest_config(config(150))]

    /// A place on the ray is known to a few roundings of the origin and of the way; the sign of `|q_N| − B` changes within.
    #[test]
    fn hits_lie_on_the_level_set(julia in any_julia(), rays in prop::collection::vec(any_ray(), 40)) {
        for ray in rays {
            for t in crossings(&julia, &ray) {
                let place = gamma(12) * (ray.origin.length() + (ray.direction * t).length() + 4.0);
                let p = ray.at(t);
                let off = level(&julia, p).abs();
                let allowed = rounding_of_level(&julia, p, place);
                prop_assert!(off <= allowed, "{julia:?} {ray:?} t {t}: {off:e} off, allowed {allowed:e}");
            }
        }
    }

    /// Looked at in 500 places, no ray is inside before its first hit, or without one.
    #[test]
    fn nothing_is_stepped_over(julia in any_julia(), rays in prop::collection::vec(any_ray(), 30)) {
        for ray in rays {
            let speed = ray.direction.length();
            let middle = -ray.origin.dot(ray.direction) / (speed * speed);
            let reach = 2.0 * escape_radius(julia.c()).max(julia.bailout()) / speed;
            let hit = julia.nearest(&ray, 0.0, f64::INFINITY).map_or(f64::INFINITY, |c| c.t);
            let started_inside = julia.contains(ray.origin);
            for i in 0..500 {
                let t = middle + reach * (2.0 * f64::from(i) / 499.0 - 1.0);
                // A little before the hit, as much as its place is uncertain.
                let place = gamma(64) * (ray.origin.length() + 4.0);
                if t <= 0.0 || t * speed >= hit * speed - place {
                    continue;
                }
                let p = ray.at(t);
                let level = level(&julia, p);
                if level.is_finite() && level.abs() > rounding_of_level(&julia, p, place) {
                    prop_assert_eq!(level < 0.0, started_inside, "{:?} {:?} at {} before {}", julia, ray, t, hit);
                }
            }
        }
    }

    /// Random points of the ball that is said to be free are on the same side.
    #[test]
    fn free_balls_hold_no_point_of_the_surface(
        julia in any_julia(), points in prop::collection::vec([-2.0f64..2.0, -2.0..2.0, -2.0..2.0], 60),
        ways in prop::collection::vec((unit_vector(), 0.0f64..1.0), 20)
    ) {
        for p in points.into_iter().map(DVec3::from_array) {
            let radius = julia.free_radius(p);
            prop_assert!(radius >= 0.0);
            let inside = level(&julia, p) < 0.0;
            for (way, share) in &ways {
                // Uniform in the ball, and on its surface.
                for r in [radius * share.cbrt(), radius * (1.0 - 1e-9)] {
                    let q = p + *way * r.min(4.0);
                    let off = level(&julia, q);
                    let rounded = rounding_of_level(&julia, q, gamma(4) * 4.0);
                    prop_assert!((off < 0.0) == inside || !off.is_finite() || off.abs() <= rounded, "{julia:?} {p} {q}");
                }
            }
        }
    }

    /// No point within a safe step stays for ever: followed on, it leaves.
    #[test]
    fn safe_steps_lead_to_no_point_that_stays(
        c in any_c(), p in [-2.5f64..2.5, -2.5..2.5, -2.5..2.5, -1.0..1.0],
        ways in prop::collection::vec((unit_vector(), -1.0f64..1.0), 30)
    ) {
        let p = DVec4::from_array(p);
        let step = safe_step::<DoubleDouble>(p, c);
        prop_assert!(step >= 0.0 && step.is_finite());
        if step > 0.0 {
            for (way, w) in ways {
                let q = p + way.extend(w).normalize() * (step * (1.0 - 1e-12));
                let end = escape(quaternion::<DoubleDouble>(q), quaternion(c), 200_000, 2.0 * escape_radius(c));
                prop_assert!(end.escaped, "{c} {p} {step} {q}");
            }
        }
    }

    /// Central differences: truncation h²/6 of the third derivative, which (4 |q'|³/|q|² and its like) is watched by halving h;
    /// rounding over h.
    #[test]
    fn the_normal_is_the_gradient(julia in any_julia(), rays in prop::collection::vec(any_ray(), 10)) {
        for ray in rays {
            let Some(c) = julia.nearest(&ray, 0.0, f64::INFINITY) else { continue };
            let hit = julia.hit(&ray, &c);
            let Some((_, gradient)) = julia.level(hit.point) else { continue };
            let slope = gradient.length();
            let rounding = rounding_of_level(&julia, hit.point, 0.0);
            let difference = |h: f64| {
                let along = |axis: DVec3| {
                    // The steps as they came out of the addition: their difference is exact.
                    let (a, b) = (hit.point + axis * h, hit.point - axis * h);
                    (level(&julia, a) - level(&julia, b)) / (a - b).dot(axis)
                };
                DVec3::new(along(DVec3::X), along(DVec3::Y), along(DVec3::Z))
            };
            // In 106 bits the differences themselves hardly round: only their truncation counts.
            let h = 1e-6 * (julia.bailout() / slope).min(hit.point.length().max(1.0));
            let (coarse, fine) = (difference(2.0 * h), difference(h));
            // Shrinking h by 2 shrinks the truncation by 4: a third of the change is what is left, a whole is allowed.
            let truncation = (coarse - fine).length() + 4.0 * U * slope;
            // The gradient's own rounding, relative, as the level's error over the place it moves.
            let own = 64.0 * f64::from(julia.iterations() + 1) * rounding / julia.bailout().min(1.0) * slope.max(1.0);
            prop_assert!((gradient - fine).length() <= truncation + own, "{julia:?} {gradient} {fine}");
            prop_assert!((hit.ng * slope - gradient).length() <= 8.0 * U * slope);
        }
    }

    /// A set through the middle is its own mirror image in the origin; a real c makes it round about x.
    #[test]
    fn sets_are_symmetric(c in any_c(), n in 1u32..9, rays in prop::collection::vec(any_ray(), 20), angle in 0.0f64..6.0) {
        let same = |julia: &Julia, a: &Ray, b: &Ray| {
            let (x, y) = (julia.nearest(a, 0.0, f64::INFINITY), julia.nearest(b, 0.0, f64::INFINITY));
            match (x, y) {
                (Some(x), Some(y)) => {
                    // The same root, or another that the turned ray's rounding let through.
                    let place = gamma(64) * (a.origin.length() + 4.0);
                    let p = b.at(y.t);
                    (x.t - y.t).abs() * a.direction.length() <= 1e3 * place
                        || level(julia, b.at(x.t)).abs() <= 64.0 * rounding_of_level(julia, p, place)
                }
                (None, None) => true,
                // A touch.
                (Some(c), None) | (None, Some(c)) => {
                    let p = a.at(c.t);
                    level(julia, p).abs() <= 64.0 * rounding_of_level(julia, p, gamma(64) * (a.origin.length() + 4.0))
                }
            }
        };
        let julia = Julia::new(c, n, 2.0, 0.0).expect("a set");
        let real = Julia::new(DVec4::new(c.x, 0.0, 0.0, 0.0), n, 2.0, 0.0).expect("a set");
        let turn = DMat3::from_rotation_x(angle);
        for ray in rays {
            prop_assert!(same(&julia, &ray, &Ray::new(-ray.origin, -ray.direction)), "{ray:?}");
            prop_assert!(same(&real, &ray, &Ray::new(turn * ray.origin, turn * ray.direction)), "{ray:?}");
        }
    }

    #[test]
    fn vectors_give_the_same_bits(julia in any_julia(), rays in prop::collection::vec(any_ray(), 30)) {
        let plain = julia.clone().with_vectors(Vectors::Baseline);
        for ray in rays {
            prop_assert_eq!(crossings(&julia, &ray), crossings(&plain, &ray));
            prop_assert_eq!(julia.blocks(&ray, 0.75), plain.blocks(&ray, 0.75));
        }
    }

    /// c = 0 leaves the ball of radius B^(1/2^N): no ray that leaves it outwards meets it again, however flat.
    #[test]
    fn a_ball_throws_no_shadow_on_itself(n in 0u32..8, at in unit_vector(), ways in prop::collection::vec((unit_vector(), -16.0f64..0.0), 60)) {
        let ball = Julia::new(DVec4::ZERO, n, 2.0, 0.0).expect("a ball");
        let ray = Ray::new(at * 3.0, -at);
        let crossing = ball.nearest(&ray, 0.0, f64::INFINITY).expect("a hit");
        let radius = 2f64.powf(1.0 / f64::from(1u32 << n));
        prop_assert!((crossing.t - (3.0 - radius)).abs() <= gamma(24) * 3.0);
        let hit = ball.hit(&ray, &crossing);
        for (way, rise) in ways {
            let flat = (way - hit.ng * way.dot(hit.ng)).normalize_or(hit.tangent);
            let out = flat + hit.ng * 10f64.powf(rise);
            let leaving = Ray::new(hit.origin_towards(hit.ng), out);
            prop_assert!(!ball.blocks(&leaving, f64::INFINITY), "{leaving:?}");
            prop_assert!(ball.nearest(&leaving, 0.0, f64::INFINITY).is_none(), "{leaving:?}");
        }
    }
}

fn nasty() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => prop::sample::select(vec![0.0, -0.0, 5e-324, -1e-310, 1e-150, -1e150, 1e300, 1.0, -1.0, f64::MAX]),
        2 => -4.0f64..4.0,
        1 => (-150.0f64..150.0).prop_map(|e| 10f64.powf(e)),
    ]
}

proptest! {
    #![proptest_config(config(60))]

    /// Any set, any ray, every method: answers or none, no panic, nothing that is no number.
    #[test]
    fn hostile_input_makes_no_nan(
        julia in any_julia(), deep in 0u32..101,
        rays in prop::collection::vec(([nasty(), nasty(), nasty()], [nasty(), nasty(), nasty()]), 25)
    ) {
        let march = March { tolerance: 1e-4, most: 200 };
        let deep = Julia::new(julia.c(), deep, julia.bailout(), julia.w()).expect("a set");
        let ways = [
            julia.clone(),
            deep,
            julia.clone().with_method(JuliaMethod::AsPrinted(march)),
            julia.clone().with_method(JuliaMethod::Estimate(march)),
            julia.clone().with_method(JuliaMethod::AtLeast(march)),
            julia.clone().with_method(JuliaMethod::Ball(march)),
        ];
        for (o, d) in rays {
            let ray = Ray::new(DVec3::from_array(o), DVec3::from_array(d));
            if ray.direction == DVec3::ZERO {
                continue;
            }
            for julia in &ways {
                for t in crossings(julia, &ray) {
                    prop_assert!(t > 0.0 && t.is_finite(), "{julia:?} {ray:?} {t}");
                    let hit = julia.hit(&ray, &Crossing::new(t, 0));
                    prop_assert!(hit.point.is_finite() && hit.ng.is_finite() && hit.point_error.is_finite());
                    prop_assert!(hit.tangent.is_finite() && hit.uv.is_finite() && hit.point_error >= 0.0);
                }
            }
            let (p, c) = (ray.origin.extend(o[0]), julia.c());
            let step = safe_step::<f64>(p, c);
            prop_assert!(step >= 0.0 && !step.is_nan(), "{p} {step}");
        }
    }
}

/// Without a bailout squares overflow: nine steps of f32, twelve of f64. With one, they are never formed.
#[test]
fn orbits_need_a_bailout() {
    let (p, c) = (DVec4::new(1.2, 0.3, 0.0, 0.0), DVec4::new(-0.2, 0.6, 0.2, 0.2));
    let first = |bad: &dyn Fn(u32) -> bool| (0..60).find(|n| bad(*n));
    let single = first(&|n| !as_printed_estimate::<f32>(quaternion(p), quaternion(c), n).is_finite());
    let double = first(&|n| !as_printed_estimate::<f64>(quaternion(p), quaternion(c), n).is_finite());
    assert!(
        single.is_some_and(|n| n < 16) && double.is_some_and(|n| n < 16) && single < double,
        "{single:?} {double:?}"
    );
    for most in [20, 200, 20_000] {
        let end = escape::<f64>(quaternion(p), quaternion(c), most, 1e100);
        assert!(end.escaped && end.estimate().is_some_and(f64::is_finite));
    }
}

/// c = 0: the distance of a point is |p| − 1; c = −2: that to the segment [−2, 2].
#[test]
fn safe_steps_stay_below_exact_distances_and_above_a_quarter() {
    for i in 0..2000 {
        let turn = f64::from(i) * 2.399_963;
        let r = 1.0 + 10f64.powf(-12.0 + f64::from(i) / 125.0);
        let p = DVec4::new(turn.cos(), 0.6 * turn.sin(), 0.8 * turn.sin(), 0.0) * r;
        let (step, exact) = (safe_step::<DoubleDouble>(p, DVec4::ZERO), p.length() - 1.0);
        assert!(step <= exact + gamma(4) * r && step >= 0.25 * (exact - gamma(4) * r), "{p} {step} {exact}");
        let q = DVec4::new(2.0 * turn.cos(), 0.0, 0.0, 0.0) + (p - DVec4::X * p.x) * (r - 1.0).min(4.0);
        let aside = (q - DVec4::X * q.x).length();
        let exact = aside.hypot((q.x.abs() - 2.0).max(0.0));
        let step = safe_step::<DoubleDouble>(q, DVec4::X * -2.0);
        assert!(step <= exact * (1.0 + gamma(8)), "{q} {step} {exact}");
    }
}

/// The plain estimate is longer than the way: for c = 0 from ½ r ln r > r − 1 on.
#[test]
fn the_estimate_oversteps_far_away() {
    let estimate = |r: f64| {
        let p = quaternion::<f64>(DVec4::new(r, 0.0, 0.0, 0.0));
        escape(p, quaternion(DVec4::ZERO), 100, 4.0).estimate().expect("outside")
    };
    assert!(estimate(4.9) < 3.9 && estimate(5.0) > 4.0 && estimate(1e6) > 5e6);
    // The printed march from there is thrown past the set; from the bounding ball it arrives.
    let march = March { tolerance: 1e-6, most: 1000 };
    let ray = Ray::new(DVec3::new(0.0, 0.0, 1e6), -DVec3::Z);
    let hit = |method| home().clone().with_method(method).nearest(&ray, 0.0, f64::INFINITY).is_some();
    assert!(!hit(JuliaMethod::AsPrinted(march)) && hit(JuliaMethod::Estimate(march)));
    assert!(hit(JuliaMethod::Ball(march)) && hit(JuliaMethod::AtLeast(march)) && hit(JuliaMethod::Certified));
}

#[test]
fn other_sets_are_refused() {
    let c = DVec4::new(-0.2, 0.6, 0.2, 0.2);
    let nan = DVec4::new(f64::NAN, 0.0, 0.0, 0.0);
    for (c, n, b, w) in [
        (DVec4::X * 100.1, 8, 2.0, 0.0),
        (nan, 8, 2.0, 0.0),
        (c, 101, 2.0, 0.0),
        (c, 8, 0.0, 0.0),
        (c, 8, f64::NAN, 0.0),
        (c, 8, 2e60, 0.0),
        (c, 8, 2.0, f64::INFINITY),
    ] {
        assert!(Julia::new(c, n, b, w).is_err(), "{c} {n} {b} {w}");
    }
    // A slice that passes by the set is no mistake: nothing is there.
    let nothing = Julia::new(c, 8, 2.0, 3.0).expect("a slice of nothing");
    assert!(nothing.bounds().is_empty() && !nothing.contains(DVec3::ZERO));
    assert_eq!(nothing.nearest(&Ray::new(DVec3::Z * 3.0, -DVec3::Z), 0.0, f64::INFINITY), None);
}
