//! Laws of area lights: their irradiance here, the maps of the unit square to what is seen of them beside it.

mod maps;
mod printed;

use super::support::{nasty, seed};
use glam::{DMat3, DVec3};
use lightbench::frame::{basis, rotation_about};
use lightbench::light::{polygon_irradiance, sphere_irradiance};
use lightbench::num::{U, gamma};
use lightbench::sample::{Sampler, uniform_sphere};
use proptest::prelude::*;
use std::f64::consts::PI;

/// A light and a receiver, of size 1 or so.
pub struct Case {
    pub center: DVec3,
    pub half_width: DVec3,
    pub half_height: DVec3,
    pub p: DVec3,
    pub n: DVec3,
    pub sampler: Sampler,
}

impl Case {
    pub fn corners(&self) -> [DVec3; 4] {
        let (c, w, h) = (self.center, self.half_width, self.half_height);
        [c - w - h, c + w - h, c + w + h, c - w + h]
    }
}

pub fn cases(name: &str, count: u32) -> impl Iterator<Item = Case> {
    let seed = seed(name);
    (0..count).map(move |i| {
        let mut s = Sampler::new(seed, 0, i);
        let (x, y) = basis(uniform_sphere(s.next_2d()));
        let sides = s.next_2d() * 1.5 + 0.05;
        Case {
            center: uniform_sphere(s.next_2d()) * (0.2 + 2.0 * s.next_1d()),
            half_width: x * sides.x,
            half_height: y * sides.y,
            p: uniform_sphere(s.next_2d()) * 0.1,
            n: uniform_sphere(s.next_2d()),
            sampler: s,
        }
    })
}

/// Each side of the comparison rounds its corners, by 4 u of their distances, which turns edges by up to `r/distance` of that; then
/// 4 u per edge.
const ROUNDED_CORNERS: f64 = 4096.0 * U;

#[test]
fn a_polygon_cut_in_two_sends_as_much() {
    for mut case in cases("cut", 2000) {
        let [a, b, c, d] = case.corners();
        let (s, t) = (case.sampler.next_1d(), case.sampler.next_1d());
        let (e, f) = (a.lerp(b, s), d.lerp(c, t));
        let of = |v: &[DVec3]| polygon_irradiance(v, case.p, case.n);
        let (whole, parts) = (of(&[a, b, c, d]), of(&[a, e, f, d]) + of(&[e, b, c, f]));
        let near = case.corners().into_iter().map(|v| v.distance(case.p)).fold(0.05, f64::min);
        assert!((whole - parts).abs() <= ROUNDED_CORNERS / near, "{whole} {parts}");
        // And either way round.
        let back = of(&[d, c, b, a]);
        assert!((whole - back).abs() <= 32.0 * U, "{whole} {back}");
    }
}

#[test]
fn irradiance_does_not_turn() {
    for mut case in cases("turn", 1000) {
        let axis = uniform_sphere(case.sampler.next_2d());
        let turn: DMat3 = rotation_about(axis, 7.0 * case.sampler.next_1d()).expect("an axis");
        let v = case.corners();
        let (there, here) = (
            polygon_irradiance(&v.map(|v| turn * v), turn * case.p, turn * case.n),
            polygon_irradiance(&v, case.p, case.n),
        );
        assert!((there - here).abs() <= ROUNDED_CORNERS / 0.05, "{there} {here}");
        let sphere = |m: DMat3| sphere_irradiance(m * case.center, 0.15, m * case.p, m * case.n);
        assert!((sphere(turn) - sphere(DMat3::IDENTITY)).abs() <= ROUNDED_CORNERS);
    }
}

#[test]
fn a_power_of_two_changes_nothing() {
    for case in cases("power of two", 200) {
        for exponent in [-900, -60, -1, 1, 60, 900] {
            let k = 2f64.powi(exponent);
            let v = case.corners();
            let polygon = polygon_irradiance(&v.map(|v| v * k), case.p * k, case.n);
            assert_eq!(polygon, polygon_irradiance(&v, case.p, case.n));
            let sphere = sphere_irradiance(case.center * k, 0.5 * k, case.p * k, case.n);
            assert_eq!(sphere, sphere_irradiance(case.center, 0.5, case.p, case.n));
        }
    }
}

/// A sphere sends what the disc sends that fills the same cone, and that lies between its inner and outer polygons, which differ by
/// `1 − cos² (π/m)` of their areas.
#[test]
fn a_sphere_lies_between_polygons() {
    const SIDES: u32 = 720;
    let half_turn = PI / f64::from(SIDES);
    for case in cases("between", 300) {
        let d = case.center - case.p;
        let sine = 0.02 + 0.9 * case.half_width.length() / 1.6;
        let (x, y) = basis(d.normalize());
        let ring = |radius: f64| -> Vec<DVec3> {
            let at = |i: u32| f64::from(2 * i) * half_turn;
            (0..SIDES)
                .map(|i| case.center + (x * at(i).cos() + y * at(i).sin()) * (radius * d.length()))
                .collect()
        };
        let tangent = sine / (1.0 - sine * sine).sqrt();
        let inner = polygon_irradiance(&ring(tangent), case.p, case.n);
        let outer = polygon_irradiance(&ring(tangent / half_turn.cos()), case.p, case.n);
        let sphere = sphere_irradiance(case.center, sine * d.length(), case.p, case.n);
        // 4 u for each of 720 edges.
        let rounding = f64::from(SIDES) * 4.0 * U;
        assert!(inner - rounding <= sphere && sphere <= outer + rounding, "{inner} {sphere} {outer}");
    }
}

#[test]
fn whole_skies_and_what_lies_behind() {
    let far = 1e9;
    let v = [(-far, -far), (far, -far), (far, far), (-far, far)].map(|(x, y)| DVec3::new(x, y, 1.0));
    // Beyond a square of half width w the sky's last ring sends π/w² at most.
    assert!((polygon_irradiance(&v, DVec3::ZERO, DVec3::Z) - PI).abs() <= 16.0 * U);
    assert_eq!(polygon_irradiance(&v, DVec3::ZERO, -DVec3::Z), 0.0);
    assert_eq!(
        polygon_irradiance(&v, DVec3::new(0.0, 0.0, 1.0), DVec3::Z),
        0.0,
        "on the light, looking away"
    );
    assert_eq!(polygon_irradiance(&v, DVec3::new(2e9, 0.0, 1.0), DVec3::X), 0.0, "in its plane");
    assert_eq!(polygon_irradiance(&v[..2], DVec3::ZERO, DVec3::Z), 0.0);
    assert_eq!(polygon_irradiance(&[DVec3::Z; 5], DVec3::ZERO, DVec3::Z), 0.0);
    assert_eq!(polygon_irradiance(&v, DVec3::ZERO, DVec3::ZERO), 0.0);
    assert!(polygon_irradiance(&v, DVec3::NAN, DVec3::Z).is_nan());
    assert_eq!(sphere_irradiance(DVec3::X, 2.0, DVec3::ZERO, DVec3::Y), PI);
    assert_eq!(sphere_irradiance(DVec3::X, 0.0, DVec3::ZERO, DVec3::X), 0.0);
    assert_eq!(sphere_irradiance(DVec3::X * 3.0, 1.0, DVec3::ZERO, -DVec3::X), 0.0);
    assert!(sphere_irradiance(DVec3::X, f64::INFINITY, DVec3::ZERO, DVec3::X).is_nan());
}

/// A receiver on the light: `π (1 − |cos γ|)/2` in the interior, half of that of a half-plane whose edge points uphill.
#[test]
fn on_the_light_the_side_decides() {
    let v = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
    for degrees in [0.0f64, 20.0, 70.0, 89.999, 91.0, 179.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let n = DVec3::new(sin, 0.0, cos);
        let whole = PI * (1.0 - cos.abs()) / 2.0;
        let at = |x: f64, y: f64| polygon_irradiance(&v, DVec3::new(x, y, 0.0), n);
        for (found, expected) in [
            (at(2.0, 1.0), whole),
            (at(1.0, 0.0), whole / 2.0),
            (at(0.0, 1.0), whole),
            (at(4.0, 1.0), 0.0),
            (at(0.0, 0.0), whole / 2.0),
            (at(5.0, 1.0), 0.0),
        ] {
            assert!((found - expected).abs() <= 16.0 * U, "{degrees}°: {found} {expected}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn irradiance_is_between_0_and_pi(
        v in prop::collection::vec((nasty::number(), nasty::number(), nasty::number()), 0..6),
        p in nasty::point(),
        at in 0usize..6,
        n in (nasty::number(), nasty::number(), nasty::number()),
        radius in nasty::magnitude(),
    ) {
        let v: Vec<DVec3> = v.into_iter().map(DVec3::from).collect();
        let n = DVec3::from(n);
        for p in [p, v.get(at).copied().unwrap_or(p)] {
            let polygon = polygon_irradiance(&v, p, n);
            prop_assert!((0.0..=PI).contains(&polygon), "{}", polygon);
            let sphere = sphere_irradiance(v.first().copied().unwrap_or(p), radius, p, n);
            prop_assert!((0.0..=PI).contains(&sphere), "{}", sphere);
        }
    }

    #[test]
    fn a_far_lamp_obeys_the_inverse_square(w in nasty::unit_vector(), n in nasty::unit_vector(), e in -140.0..-3.0f64) {
        // To first order in the width, whose square is what the form with differences leaves out; 64 u for products.
        let width = 10f64.powf(e);
        let (x, y) = basis(w);
        let v = [-x - y, x - y, x + y, y - x].map(|d| d * width);
        let found = polygon_irradiance(&v, -w, n);
        let expected = (2.0 * width).powi(2) * w.dot(n).max(0.0);
        let slack = (2.0 * width).powi(2) * (4.0 * width + gamma(64));
        prop_assert!((found - expected).abs() <= slack, "{} {}", found, expected);
        let ball = sphere_irradiance(DVec3::ZERO, width, -w, n);
        let slack = PI * width * width * (4.0 * width + gamma(64));
        prop_assert!((ball - PI * width * width * w.dot(n).max(0.0)).abs() <= slack, "{}", ball);
    }
}
