//! Outlines on paper are where the shapes have them.

use glam::{DVec2, DVec3};
use lightbench::bounds::Aabb;
use lightbench::csg::{Csg, Tree};
use lightbench::shape::Shape;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::plane::Plane;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::torus::Torus;
use lightbench_kit::figure::Space;
use lightbench_kit::replay::outline::{Outlines, Paper};

const PEN: f64 = 0.02;

fn space() -> Space {
    Space::axonometric(35.0, 20.0)
}

fn outlines(shape: &dyn Shape) -> Outlines {
    Paper::new(&space(), Aabb::new(DVec3::splat(-3.0), DVec3::splat(3.0))).outlines(shape, PEN)
}

/// Distance of a point of the paper from a segment in space.
fn distance(p: DVec2, (a, b): (DVec3, DVec3)) -> f64 {
    let (a, b) = (space().at(a), space().at(b));
    let along = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
    p.distance(a.lerp(b, along))
}

/// Every outline lies on one of the segments, and every segment is drawn from end to end.
fn agree(found: &Outlines, segments: &[(DVec3, DVec3)]) {
    assert!(!found.are_dense && !found.lines.is_empty());
    let points: Vec<DVec2> = found.lines.concat();
    // A corner is cut off inside a cell, which the pen's width bounds.
    let near = 1.5 * PEN;
    for p in &points {
        assert!(segments.iter().any(|s| distance(*p, *s) < near), "nothing is at {p}");
    }
    for (a, b) in segments {
        for k in 0..=40 {
            let p = space().at(a.lerp(*b, f64::from(k) / 40.0));
            // Neighbours on a line are up to a cell's diagonal apart.
            assert!(points.iter().any(|q| q.distance(p) < 2.0 * PEN), "{a} … {b}: not drawn at {p}");
        }
    }
}

/// The points of a smooth rim are as exact as the bisection: 1/256 of a cell, and a cell is no larger than the pen.
#[test]
fn a_sphere_is_a_circle() {
    let center = DVec3::new(0.3, -0.2, 0.7);
    let found = outlines(&Sphere::new(center, 0.8).expect("a sphere"));
    assert_eq!(found.lines.len(), 1, "one closed line");
    let line = &found.lines[0];
    assert_eq!(line.first(), line.last(), "it closes");
    for p in line {
        assert!((p.distance(space().at(center)) - 0.8).abs() < PEN / 256.0, "{p}");
    }
    let length: f64 = line.windows(2).map(|w| w[0].distance(w[1])).sum();
    // A chord of length s is shorter than its arc by s³/24 r²: 2e-5 of the whole here.
    assert!((length / (std::f64::consts::TAU * 0.8) - 1.0).abs() < 1e-3, "{length}");
}

/// The nine edges of a box that can be seen from above, right and front.
fn seen_edges(min: DVec3, max: DVec3) -> Vec<(DVec3, DVec3)> {
    let hidden = min; // the corner away from the viewer
    let corner = |i: usize| {
        let pick = |bit: usize, a: f64, b: f64| if i >> bit & 1 == 1 { b } else { a };
        DVec3::new(pick(0, min.x, max.x), pick(1, min.y, max.y), pick(2, min.z, max.z))
    };
    let pairs = (0..8).flat_map(|i| [1, 2, 4].map(|bit| (i, i | bit))).filter(|(i, j)| i != j);
    pairs.map(|(i, j)| (corner(i), corner(j))).filter(|(a, b)| *a != hidden && *b != hidden).collect()
}

#[test]
fn a_box_shows_nine_edges() {
    let (min, max) = (DVec3::new(-0.5, -0.7, -0.4), DVec3::new(0.6, 0.5, 0.9));
    let edges = seen_edges(min, max);
    assert_eq!(edges.len(), 9);
    agree(&outlines(&Cuboid::new(min, max).expect("a box")), &edges);
}

#[test]
fn a_plane_ends_where_the_drawing_does() {
    let plane = Plane::new(DVec3::new(0.0, -1.0, 0.0), DVec3::Y).expect("a plane");
    let corners = [(-3.0, -3.0), (3.0, -3.0), (3.0, 3.0), (-3.0, 3.0)].map(|(x, z)| DVec3::new(x, -1.0, z));
    let edges: Vec<_> = (0..4).map(|i| (corners[i], corners[(i + 1) % 4])).collect();
    // The room is grown by the pen, so that what fills it is not cut.
    let found = outlines(&plane);
    for p in found.lines.concat() {
        assert!(edges.iter().any(|e| distance(p, *e) < 3.0 * PEN), "nothing is at {p}");
    }
    let length: f64 = found.lines.iter().flat_map(|l| l.windows(2)).map(|w| w[0].distance(w[1])).sum();
    let whole: f64 = edges.iter().map(|(a, b)| space().at(*a).distance(space().at(*b))).sum();
    assert!((length / whole - 1.0).abs() < 0.05, "{length} of {whole}");
}

#[test]
fn a_ring_shows_its_hole_and_a_cut_its_edge() {
    let ring = Torus::new(1.0, 0.25).expect("a ring"); // about z, which is turned away from the viewer by 40°
    assert!(outlines(&ring).lines.iter().filter(|l| l.len() > 40).count() >= 2);
    // Half a ball: the plane of the cut is an ellipse, which a whole ball has not.
    let ball = || Tree::leaf(Sphere::new(DVec3::ZERO, 1.0).expect("a sphere"));
    let above = Tree::leaf(Cuboid::new(DVec3::new(-2.0, 0.0, -2.0), DVec3::splat(2.0)).expect("a box"));
    let found = outlines(&Csg::new(ball().difference(above)).expect("a solid"));
    let points: Vec<DVec2> = found.lines.concat();
    for k in 0..36 {
        let turn = f64::from(k) * std::f64::consts::TAU / 36.0;
        let p = space().at(DVec3::new(turn.cos(), 0.0, turn.sin()));
        assert!(points.iter().any(|q| q.distance(p) < 2.0 * PEN), "the rim is not drawn at {p}");
    }
}

#[test]
fn what_lies_outside_is_not_drawn() {
    let far = Sphere::new(DVec3::splat(9.0), 1.0).expect("a sphere");
    assert!(outlines(&far).lines.is_empty());
}
