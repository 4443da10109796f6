//! Laws of leaving a surface: the default meets no shadow of its own and lets no light through, whatever the scene's unit and place.

use crate::support::nasty;
use glam::{DAffine3, DMat3, DVec3, dvec3};
use lightbench::num::U;
use lightbench::num::double_double::DoubleDouble;
use lightbench::ray::leaving::{
    Departure, Leaving, integer_offset, integer_offset_double, integer_offset_single,
};
use lightbench::ray::{Hit, Ray};
use lightbench::shape::Shape;
use lightbench::shape::cone::Cone;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::cylinder::Cylinder;
use lightbench::shape::disc::Disc;
use lightbench::shape::fan::{Ends, Fan, Vectors};
use lightbench::shape::instance::Instance;
use lightbench::shape::plane::Plane;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::torus::Torus;
use lightbench::shape::triangle::Triangle;
use proptest::prelude::*;
use std::f64::consts::TAU;

fn config() -> ProptestConfig {
    ProptestConfig { failure_persistence: None, cases: 3000, ..ProptestConfig::default() }
}

/// A convex shape, or the part of one that its tangent planes do not cut.
struct Body {
    shape: Box<dyn Shape>,
    is_closed: bool,
    /// Is the hit clear of edges?
    admits: fn(&Hit) -> bool,
}

const BODIES: usize = 8;

/// Of this size about a centre. Sizes and centres that are powers of two apart give bodies that are.
fn body(kind: usize, size: f64, center: DVec3) -> Body {
    let at = |x: f64, y: f64, z: f64| center + dvec3(x, y, z) * size;
    let turned = DMat3::from_rotation_x(0.7) * DMat3::from_rotation_y(0.4);
    let (low, high) = (center - turned.z_axis * size, center + turned.z_axis * size);
    let flat = dvec3(0.36, -0.48, 0.8);
    let make = |shape: Box<dyn Shape>, is_closed, admits| Body { shape, is_closed, admits };
    let off_the_rim = |h: &Hit| h.uv.y < 0.9 && (h.face > 0 || h.uv.y > 0.1);
    match kind {
        0 => make(Box::new(Sphere::new(center, size).unwrap()), true, |_| true),
        1 => make(Box::new(Cuboid::new(at(-1.0, -0.7, -0.8), at(1.0, 0.7, 0.8)).unwrap()), true, |h| {
            h.uv.min_element() > 0.1 && h.uv.max_element() < 0.9
        }),
        2 => make(Box::new(Plane::new(center, flat).unwrap()), false, |_| true),
        3 => make(Box::new(Disc::new(center, flat, size).unwrap()), false, |h| h.uv.y < 0.9),
        4 => make(Box::new(Cylinder::new(low, high, 0.6 * size).unwrap()), true, off_the_rim),
        5 => make(Box::new(Cone::new(low, high, 0.9 * size, 0.0).unwrap()), true, off_the_rim),
        6 => {
            let torus = Torus::new(0.75 * size, 0.25 * size).unwrap();
            let there = DAffine3::from_mat3_translation(turned, center);
            // The outer half of the tube lies behind its tangent planes.
            make(Box::new(Instance::new(Box::new(torus), there).unwrap()), true, |h| {
                (h.uv.y * TAU).cos() > 0.2
            })
        }
        _ => {
            let triangle = Triangle::new(at(-1.0, -0.6, 0.1), at(0.9, -0.7, -0.2), at(0.1, 0.9, 0.3));
            make(Box::new(triangle.unwrap()), false, |h| h.uv.min_element() > 0.1 && h.uv.element_sum() < 0.9)
        }
    }
}

/// A ray towards a body, and what it finds.
#[derive(Clone, Copy, Debug)]
struct Aim {
    from: DVec3,
    through: DVec3,
}

fn aims() -> impl Strategy<Value = Aim> {
    (nasty::unit_vector(), nasty::unit_vector(), 0.0..0.6)
        .prop_map(|(from, through, share)| Aim { from: from * 4.0, through: through * share })
}

/// Without coordinates so small that a scale may take them below the normal numbers.
fn without_dust(v: DVec3) -> DVec3 {
    v.map(|x| if x.abs() < 1.0e-100 { 0.0 } else { x })
}

impl Aim {
    fn without_dust(self) -> Self {
        Aim { from: without_dust(self.from), through: without_dust(self.through) }
    }

    /// The ray, the hit, and the seen side.
    fn at(&self, body: &Body, size: f64, center: DVec3) -> Option<(Ray, Hit, DVec3)> {
        let from = center + self.from * size;
        let ray = Ray::new(from, center + self.through * size - from);
        let hit = body.shape.hit(&ray, &body.shape.nearest(&ray, 0.0, f64::INFINITY)?);
        let side = if ray.direction.dot(hit.ng) > 0.0 { -hit.ng } else { hit.ng };
        (body.admits)(&hit).then_some((ray, hit, side))
    }
}

/// A light over a tangent plane or under it: the exponent of the sine of its height, its turn, its distance [sizes].
#[derive(Clone, Copy, Debug)]
struct Lamp {
    grazing: f64,
    turn: f64,
    away: f64,
}

fn lamps() -> impl Strategy<Value = Lamp> {
    (0.0..1.0, 0.0..TAU, 4.0..400.0).prop_map(|(grazing, turn, away)| Lamp { grazing, turn, away })
}

impl Lamp {
    /// Way to the light [sizes], `least` the smallest sine asked for.
    fn way(&self, normal: DVec3, up: f64, least: f64) -> DVec3 {
        let height = least.powf(self.grazing);
        let (x, y) = normal.any_orthonormal_pair();
        let around = x * self.turn.cos() + y * self.turn.sin();
        (around * ((1.0 - height) * (1.0 + height)).max(0.0).sqrt() + normal * (up * height)) * self.away
    }
}

/// What rounding moves of a body `distance` sizes away, in sizes: fewer than 256 roundings of coordinates `1 + distance`.
fn doubt(distance: f64) -> f64 {
    256.0 * U * (1.0 + distance)
}

/// A light is surely seen from 8 doubts over the plane on (place 1, tilt 4 for radii of curvature over ¼, direction 1), and
/// surely hidden from 4 √doubt under it (√(2h/0.09) for starts of height h < doubt/5 over the cone's smallest radius).
fn certain(up: f64, distance: f64) -> f64 {
    if up > 0.0 { 8.0 * doubt(distance) } else { 4.0 * doubt(distance).sqrt() }
}

/// Sizes 10^±60: squares of squares stay within the format. Distances to 10⁹ sizes, most of them near.
fn places() -> impl Strategy<Value = (f64, f64)> {
    let size = prop_oneof![-6.0..6.0, -60.0..60.0].prop_map(|e: f64| 10f64.powf(e));
    let distance = prop_oneof![1 => Just(0.0), 3 => (-1.0..9.0).prop_map(|e: f64| 10f64.powf(e))];
    (size, distance)
}

proptest! {
    #![proptest_config(config())]

    /// From convex bodies of any size anywhere, by single rays and by fans.
    #[test]
    fn no_false_shadow_and_no_leak(
        kind in 0..BODIES,
        (size, distance) in places(),
        away in nasty::unit_vector(),
        aim in aims(),
        lamp in lamps(),
        above in any::<bool>(),
    ) {
        let center = away * (size * distance);
        let body = body(kind, size, center);
        let Some((_, hit, side)) = aim.at(&body, size, center) else { return Ok(()) };
        let up = if above { 1.0 } else { -1.0 };
        let light = hit.point + lamp.way(side, up, certain(up, distance)) * size;
        let origin = hit.origin_towards(side);
        let blocked = body.shape.blocks(&Ray::new(origin, light - origin), 1.0);
        prop_assert_eq!(blocked, !above, "{:?} from {}", hit, origin);
        let mut fan = Fan::new(Vectors::default());
        let mut ends = Ends::within(hit.point, 500.0 * size);
        ends.place([light].into_iter());
        fan.aim(origin, &ends);
        let mut lit = vec![1.0; fan.padded_len()];
        body.shape.shade(&fan, &mut lit);
        prop_assert_eq!(lit[0] == 0.0, !above);
    }

    /// A transmitted ray sets out on the other side: it leaves a closed body an odd number of times, and never meets an open one.
    #[test]
    fn what_goes_in_comes_out(
        kind in 0..BODIES,
        (size, distance) in places(),
        away in nasty::unit_vector(),
        aim in aims(),
        lamp in lamps(),
    ) {
        let center = away * (size * distance);
        let body = body(kind, size, center);
        let Some((ray, hit, side)) = aim.at(&body, size, center) else { return Ok(()) };
        let inward = lamp.way(side, -1.0, certain(-1.0, distance)) * size;
        let way = Departure { arriving: ray.direction, side: -side, leaving: inward };
        for leaving in [Leaving::ErrorBound, Leaving::RoundedAway] {
            let mut found = Vec::new();
            body.shape.crossings(&Ray::new(leaving.origin(&hit, &way), inward), &mut found);
            prop_assert_eq!(found.len() % 2 == 1, body.is_closed, "{:?}: {:?}", leaving, found);
        }
        // Those that know one side only set out on the wrong one.
        if kind == 0 && distance < 1.0e3 {
            let bias = 1.0e-4 * size;
            for leaving in [Leaving::AlongNormal(bias), Leaving::Back(bias)] {
                let outside = leaving.origin(&hit, &way);
                prop_assert!((outside - center).length() > size, "{leaving:?}");
            }
        }
    }

    /// A power of two scales every number of a scene exactly: so does it the start, and the light decision stays, grazing or not.
    #[test]
    fn powers_of_two_change_no_decision(
        kind in 0..BODIES,
        size in 0.5..2.0,
        distance in prop_oneof![Just(0.0), 0.0..1.0e6],
        away in nasty::unit_vector().prop_map(without_dust),
        aim in aims().prop_map(Aim::without_dust),
        lamp in lamps(),
        above in any::<bool>(),
        exponent in -100i32..100,
    ) {
        let scale = 2f64.powi(exponent);
        let center = away * (size * distance);
        let one = body(kind, size, center);
        let other = body(kind, size * scale, center * scale);
        let up = if above { 1.0 } else { -1.0 };
        match (aim.at(&one, size, center), aim.at(&other, size * scale, center * scale)) {
            (Some((_, a, side)), Some((_, b, scaled_side))) => {
                prop_assert_eq!(side, scaled_side);
                let (from, scaled) = (a.origin_towards(side), b.origin_towards(side));
                prop_assert_eq!(from * scale, scaled);
                // As near to the horizon as doubles go.
                let light = a.point + lamp.way(side, up, U) * size;
                let decided = one.shape.blocks(&Ray::new(from, light - from), 1.0);
                let again = other.shape.blocks(&Ray::new(scaled, light * scale - scaled), 1.0);
                prop_assert_eq!(decided, again);
            }
            (a, b) => prop_assert_eq!(a.is_some(), b.is_some()),
        }
    }

    /// A ball over a floor: scaled by a power of ten, or moved far away, it shades the same places, but for those where the ray
    /// passes its rim within what rounding moves.
    #[test]
    fn powers_of_ten_and_distance_change_no_shadow_of_another(
        place in (-3.0..3.0, -3.0..3.0),
        light in (-4.0..4.0, 3.0..6.0, -4.0..4.0),
        exponent in -60i32..60,
        distance in prop_oneof![Just(0.0), (0.0..9.0).prop_map(|e: f64| 10f64.powf(e))],
        away in nasty::unit_vector(),
    ) {
        let scale = 10f64.powi(exponent);
        let decided = |scale: f64, center: DVec3| {
            let ball = Sphere::new(center + DVec3::Y * (1.5 * scale), scale).unwrap();
            let floor = Plane::new(center, dvec3(0.1, 1.0, -0.05)).unwrap();
            let eye = center + dvec3(0.0, 3.0, 8.0) * scale;
            let at = center + dvec3(place.0, 0.0, place.1) * scale;
            let ray = Ray::new(eye, at - eye);
            let hit = floor.hit(&ray, &floor.nearest(&ray, 0.0, f64::INFINITY).unwrap());
            let from = hit.origin_towards(hit.ng);
            let to = center + DVec3::from(light) * scale - from;
            let segment = Ray::new(from, to);
            // Impact of the line on the ball, in radii.
            let impact = (from - ball.center()).cross(to).length() / (to.length() * scale);
            (ball.blocks(&segment, 1.0) || floor.blocks(&segment, 1.0), impact)
        };
        let (near, impact) = decided(1.0, DVec3::ZERO);
        // The floor is up to 8 sizes long, so its point rounds as often eightfold; the impact grows by the way's length over the
        // distance of light to ball, below 16 to 1.
        prop_assume!((impact - 1.0).abs() > 128.0 * doubt(distance));
        // Under the tilted floor lie none of the lights: they stand 3 up, the floor rises to 0.6.
        prop_assert_eq!(decided(scale, away * (distance * scale)).0, near);
    }

    /// Decided with 106 bits: the start lies outside the true sphere.
    #[test]
    fn starts_lie_outside_the_true_sphere((size, distance) in places(), away in nasty::unit_vector(), aim in aims()) {
        let center = away * (size * distance);
        let sphere = body(0, size, center);
        let Some((ray, hit, side)) = aim.at(&sphere, size, center) else { return Ok(()) };
        let way = Departure { arriving: ray.direction, side, leaving: side };
        for leaving in [Leaving::ErrorBound, Leaving::RoundedAway] {
            let origin = leaving.origin(&hit, &way);
            let squares = |i: usize| DoubleDouble::difference(origin[i], center[i]).square();
            let excess = squares(0) + squares(1) + squares(2) - DoubleDouble::product(size, size);
            prop_assert!(excess.value() > 0.0, "{leaving:?}: {}", excess.value());
        }
        prop_assert_eq!(Leaving::ErrorBound.origin(&hit, &way), hit.origin_towards(side));
        prop_assert_eq!(Leaving::OnTheSpot.origin(&hit, &way), hit.point);
    }

    /// 256 steps of the format along each axis, on the side of the normal; a length for small coordinates.
    #[test]
    fn the_integer_offset_counts_steps(p in prop_oneof![0.04f64..1.0e6, -1.0e6..-0.04], n in nasty::unit_vector()) {
        let moved = integer_offset_double([p, 0.0, -0.01], n.to_array());
        let steps = moved[0].to_bits() as i64 - p.to_bits() as i64;
        let outwards = if p < 0.0 { -steps } else { steps };
        prop_assert_eq!(outwards, (256.0 * n.x) as i64);
        prop_assert!((moved[0] - p) * n.x >= 0.0);
        prop_assert_eq!([moved[1], moved[2]], [2f64.powi(-45) * n.y, -0.01 + 2f64.powi(-45) * n.z]);
        prop_assert_eq!(integer_offset(dvec3(p, 0.0, -0.01), n).to_array(), moved);
        let (q, m) = (p as f32, n.as_vec3());
        let single = integer_offset_single([q, 0.0, -0.01], m.to_array());
        let steps = single[0].to_bits() as i32 - q.to_bits() as i32;
        prop_assert_eq!(if q < 0.0 { -steps } else { steps }, (256.0 * m.x) as i32);
        prop_assert_eq!([single[1], single[2]], [2f32.powi(-16) * m.y, -0.01 + 2f32.powi(-16) * m.z]);
    }

    /// Finite input, finite starts; NaN goes through.
    #[test]
    fn nothing_makes_nan(p in (nasty::number(), nasty::number(), nasty::number()), n in nasty::unit_vector(), d in nasty::unit_vector()) {
        let point = DVec3::from(p);
        prop_assume!(point.abs().max_element() < 1.0e300);
        let ray = Ray::new(dvec3(0.0, 0.0, 4.0), DVec3::NEG_Z);
        let sphere = Sphere::new(DVec3::ZERO, 1.0).unwrap();
        let hit = sphere.hit(&ray, &sphere.nearest(&ray, 0.0, f64::INFINITY).unwrap());
        let hit = Hit { point, ng: n, point_error: 1.0e-9, ..hit };
        let way = Departure { arriving: d * 1.0e-200, side: d, leaving: d * 1.0e200 };
        let all = [
            Leaving::ErrorBound,
            Leaving::RoundedAway,
            Leaving::Integer,
            Leaving::AlongNormal(0.01),
            Leaving::Ahead(0.01),
            Leaving::Back(0.01),
            Leaving::OnTheSpot,
        ];
        for leaving in all {
            prop_assert!(leaving.origin(&hit, &way).is_finite(), "{leaving:?}");
            let lost = Hit { point: DVec3::NAN, ..hit };
            prop_assert!(leaving.origin(&lost, &way).is_nan(), "{leaving:?}");
        }
        let bias = Leaving::Ahead(0.01).origin(&Hit { point: DVec3::ZERO, ..hit }, &way);
        prop_assert!((bias.length() - 0.01).abs() <= 0.01 * 8.0 * U, "{bias}");
    }
}
