//! The cove: the laws of every shape, and that its air is convex.

use crate::shape_laws;
use crate::shapes::{Inside, Member, dot, exact, length, minus};
use glam::{DVec2, DVec3};
use lightbench::ray::Ray;
use lightbench::sample::Sampler;
use lightbench::shape::cove::Cove;
use lightbench::shape::{Shape, ShapeError};

const CORNER: DVec3 = DVec3::new(0.125, -0.75, -0.5);
const RADIUS: f64 = 0.625;

/// `(s, h)` at home, without rounding that counts.
fn section(p: DVec3) -> DVec2 {
    let from = minus(exact(p), exact(CORNER));
    DVec2::new(dot(from, exact(DVec3::Z)).value(), dot(from, exact(DVec3::Y)).value())
}

const COVE: Member = Member {
    make: |pose| {
        let [up, front] = [DVec3::Y, DVec3::new(0.0, 3.0, 2.0)].map(|v| pose.vector(v));
        Box::new(Cove::new(pose.point(CORNER), up, front, RADIUS * pose.scale).unwrap())
    },
    solid: None,
    near: |p, face, reach| {
        let (at, axis) = (section(p), CORNER + DVec3::new(0.0, RADIUS, RADIUS));
        match face {
            0 => at.y.abs() <= reach && at.x >= RADIUS - reach,
            2 => at.x.abs() <= reach && at.y >= RADIUS - reach,
            _ => {
                let away = minus(exact(p.with_x(0.0)), exact(axis.with_x(0.0)));
                (length(away) - lightbench::num::double_double::DoubleDouble::of(RADIUS)).value().abs()
                    <= reach
                    && at.max_element() <= RADIUS + reach
            }
        }
    },
    uv_slope: |_| 4.0, // an arc's angle has the radius below 1, and two functions of an angle up to π/2
    inside: Inside::Any,
};

shape_laws!(cove_laws, COVE);

#[test]
fn a_cove_without_a_corner_is_an_error() {
    let [y, z] = [DVec3::Y, DVec3::Z];
    assert!(matches!(Cove::new(y, y, z, 0.0), Err(ShapeError::NotPositive { .. })));
    assert!(matches!(Cove::new(y, DVec3::ZERO, z, 1.0), Err(ShapeError::NoDirection { .. })));
    assert!(matches!(Cove::new(y, y, y * -2.0, 1.0), Err(ShapeError::NoDirection { .. })));
    assert!(matches!(Cove::new(y, y, DVec3::NAN, 1.0), Err(ShapeError::NotFinite { .. })));
}

/// Turned out of the axes, so that its normals are rounded.
fn turned() -> Cove {
    Cove::new(DVec3::new(0.3, -1.0, 0.2), DVec3::new(0.1, 0.9, -0.2), DVec3::new(0.6, 0.1, 0.7), 2.0).unwrap()
}

/// A place in the air, spread over floor, joint and wall: `height` over the surface of `point_at`.
fn starts(cove: &Cove) -> impl Iterator<Item = (Ray, DVec3)> + '_ {
    (0..4000).map(|i| {
        let mut sampler = Sampler::new(7, 0, i);
        let (u, v) = (sampler.next_2d(), sampler.next_2d());
        let eye = cove.point_at(0, DVec2::new(u.x - 0.5, 5.0)) + cove.point_at(2, DVec2::new(0.0, 3.0)) * 0.5;
        let face = i % 3;
        let along = [2.0 + 6.0 * v.y, v.y * std::f64::consts::FRAC_PI_2, 2.0 + 6.0 * v.y][face as usize];
        let target = cove.point_at(face, DVec2::new(8.0 * v.x - 4.0, along));
        (Ray::new(eye, target - eye), cove.point_at(0, DVec2::new(4.0 * u.y - 2.0, 1.5 + 5.0 * u.x)))
    })
}

#[test]
fn every_ray_from_the_air_towards_the_cove_hits_it_where_it_was_aimed() {
    let cove = turned();
    for (ray, _) in starts(&cove) {
        let hit = cove.nearest(&ray, 0.0, f64::INFINITY).map(|c| cove.hit(&ray, &c)).expect("a hit");
        // The target itself is off by the rounding of `point_at`: some ten roundings of coordinates below 16, stretched
        // where the ray grazes.
        let slant = ray.direction.normalize().dot(hit.ng).abs();
        assert!((hit.t - 1.0).abs() <= 1024.0 * f64::EPSILON / slant, "{hit:?}");
        assert!(hit.ng.dot(ray.direction) < 0.0, "the normal points into the air: {hit:?}");
    }
}

#[test]
fn a_ray_that_leaves_the_cove_is_not_blocked_by_it_and_never_slips_through() {
    let cove = turned();
    let mut grazing = 0;
    for (ray, _) in starts(&cove) {
        let hit = cove.hit(&ray, &cove.nearest(&ray, 0.0, f64::INFINITY).expect("a hit"));
        for (other, _) in starts(&cove).step_by(97) {
            // To another point of the surface, halfway: inside the air, for that is convex.
            let end = hit.point.midpoint(other.at(1.0));
            let origin = hit.origin_towards(hit.ng);
            let segment = Ray::new(origin, end - origin);
            let rise = segment.direction.normalize_or_zero().dot(hit.ng);
            // Points of one flat piece see each other along it, where rounding may decide.
            if rise < 1.0e-12 {
                grazing += 1;
                continue;
            }
            assert!(!cove.blocks(&segment, 1.0), "{hit:?} {end}");
            // Twice as far and a little more it is behind the surface.
            assert!(cove.blocks(&segment, 2.5), "{hit:?} {end}");
        }
    }
    assert!(grazing > 0, "no grazing pair was made");
}
