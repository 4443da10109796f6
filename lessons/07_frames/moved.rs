//! Shapes moved, turned and stretched, against shapes made in their place: truth, rays, contestants.

use glam::{DAffine3, DMat3, DQuat, DVec3, dvec3};
use lightbench::measure::{Method, Point, Series, Tally, time_each};
use lightbench::num::double_double::DoubleDouble as Dd;
use lightbench::ray::Ray;
use lightbench::sample::{Sampler, uniform_disc, uniform_sphere};
use lightbench::shape::Shape;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::instance::Instance;
use lightbench::shape::polyhedron::{ConvexPolyhedron, textbook};
use lightbench::shape::quadric::Ellipsoid;
use lightbench::shape::sphere::Sphere;
use lightbench_kit::lesson::Lesson;

const PLACE: DVec3 = dvec3(0.612_372_435_7, 0.643_767_529_1, 0.458_870_231_3); // direction from the origin to the body
const AXES: DVec3 = dvec3(1.0, 0.5, 2.0); // semi-axes of the ellipsoid, half the sides of the box

/// Which body a contestant is.
#[derive(Clone, Copy, PartialEq)]
enum Body {
    Ellipsoid,
    Box,
}

type First = Box<dyn Fn(&Ray) -> Option<f64>>;

impl Body {
    /// Unit shape to world; the box is turned as well.
    fn map(self, distance: f64) -> DAffine3 {
        let turn = match self {
            Body::Ellipsoid => DMat3::IDENTITY,
            Body::Box => DMat3::from_quat(DQuat::from_axis_angle(dvec3(0.36, 0.48, 0.8), 0.7)),
        };
        DAffine3 { matrix3: turn * DMat3::from_diagonal(AXES), translation: PLACE * distance }
    }

    /// The first meeting in the unit shape's own space, in 106 bits.
    fn truth(self, map: &DAffine3, ray: &Ray) -> Option<f64> {
        let columns = map.matrix3.to_cols_array_2d().map(|c| c.map(Dd::of));
        let cross =
            |a: [Dd; 3], b: [Dd; 3]| [1, 2, 0].map(|i: usize| a[i] * b[(i + 1) % 3] - a[(i + 1) % 3] * b[i]);
        let dot = |a: [Dd; 3], b: [Dd; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

        let rows =
            [cross(columns[1], columns[2]), cross(columns[2], columns[0]), cross(columns[0], columns[1])];
        let volume = dot(columns[0], rows[0]);
        let away = [0, 1, 2].map(|i| Dd::difference(ray.origin[i], map.translation[i]));
        let direction = ray.direction.to_array().map(Dd::of);
        let (o, d) = (rows.map(|r| dot(r, away) / volume), rows.map(|r| dot(r, direction) / volume));
        let ends = match self {
            Body::Ellipsoid => {
                let m = cross(o, d);
                let (a, b) = (dot(d, d), dot(o, d));
                let discriminant = a - dot(m, m); // Lagrange: no cancelling with the distance
                if discriminant.high < 0.0 {
                    return None;
                }
                let root = discriminant.sqrt();
                [(-b - root) / a, (-b + root) / a]
            }
            Body::Box => {
                let (mut near, mut far) = (Dd::of(f64::NEG_INFINITY), Dd::of(f64::INFINITY));
                for i in 0..3 {
                    let (t0, t1) = ((Dd::of(-1.0) - o[i]) / d[i], (Dd::of(1.0) - o[i]) / d[i]);
                    let (t0, t1) = if t0 < t1 { (t0, t1) } else { (t1, t0) };
                    (near, far) = (if t0 > near { t0 } else { near }, if t1 < far { t1 } else { far });
                }
                if near > far {
                    return None;
                }
                [near, far]
            }
        };
        ends.map(Dd::value).into_iter().find(|t| *t > 0.0)
    }

    fn ways(self, distance: f64) -> Vec<(Method, First)> {
        let map = self.map(distance);
        let first = |shape: Box<dyn Shape>| -> First {
            Box::new(move |ray| shape.nearest(ray, 0.0, f64::INFINITY).map(|c| c.t))
        };
        let instance = |shape: Box<dyn Shape>| {
            first(Box::new(Instance::new(shape, map).expect("a map that keeps space")))
        };
        match self {
            Body::Ellipsoid => {
                let sphere = Sphere::new(DVec3::ZERO, 1.0).expect("a unit sphere");
                let ellipsoid = Ellipsoid::new(map.translation, AXES).expect("an ellipsoid");
                vec![
                    (Method::default_of("ellipsoid in its place").styled(0), first(Box::new(ellipsoid))),
                    (Method::new("unit sphere, stretched").styled(1), instance(Box::new(sphere))),
                ]
            }
            Body::Box => {
                let cube = Cuboid::new(-DVec3::ONE, DVec3::ONE).expect("a cube");
                let polyhedron =
                    ConvexPolyhedron::of_box(-DVec3::ONE, DVec3::ONE, &map).expect("a turned box");
                let planes: Vec<(DVec3, f64)> = (0..6)
                    .map(|face| {
                        let n =
                            map.matrix3.col(face / 2).normalize() * if face % 2 == 0 { -1.0 } else { 1.0 };
                        (n, -n.dot(map.translation) - AXES[face / 2])
                    })
                    .collect();
                let haines = move |ray: &Ray| {
                    let (near, far) = textbook(&planes, ray)?;
                    [near.t, far.t].into_iter().find(|t| *t > 0.0)
                };
                vec![
                    (Method::new("turned box: unit cube, moved").styled(2), instance(Box::new(cube))),
                    (Method::new("turned box: half-spaces, ours").styled(4), first(Box::new(polyhedron))),
                    (Method::new("turned box: Haines's planes").styled(3), Box::new(haines)),
                ]
            }
        }
    }

    /// Rays from `distance` away, aimed within 0.4 of the centre: all of them hit.
    fn rays(self, seed: u64, count: u32, distance: f64) -> Vec<Ray> {
        let center = self.map(distance).translation;
        let ray = |i| {
            let mut dice = Sampler::new(seed, distance.to_bits(), i);
            let direction = uniform_sphere(dice.next_2d()).normalize();
            let (right, up) = direction.any_orthonormal_pair();
            let aside = 0.4 * uniform_disc(dice.next_2d());
            Ray::new(center + right * aside.x + up * aside.y - direction * distance, direction)
        };
        (0..count).map(ray).collect()
    }
}

const DISTANCES: [f64; 7] = [1.0e1, 1.0e2, 1.0e3, 1.0e4, 1.0e5, 1.0e6, 1.0e7]; // half sides
const TIMED: [f64; 3] = [1.0e1, 1.0e3, 1.0e5];

/// Error and (at three distances) time of every contestant.
pub fn contest(lesson: &Lesson, rays: u32) -> Vec<(Method, Series)> {
    let mut contest = Vec::new();
    for body in [Body::Ellipsoid, Body::Box] {
        for (k, (method, _)) in body.ways(1.0).into_iter().enumerate() {
            let point = |distance: f64| -> Point {
                let (map, (_, first)) = (body.map(distance), body.ways(distance).swap_remove(k));
                let rays = body.rays(lesson.seed(), rays, distance);
                let mut tally = Tally::new();
                for ray in &rays {
                    match (first(ray), body.truth(&map, ray)) {
                        (Some(t), Some(truth)) => tally.error(t - truth),
                        (found, truth) => tally.answer(found, truth),
                    }
                }
                let point = tally.rms_at(distance);
                if !TIMED.contains(&distance) {
                    return point;
                }
                point.timed(time_each(rays.len(), || rays.iter().filter_map(&first).sum::<f64>()))
            };
            contest.push((method, Series::over(&DISTANCES, point)));
        }
    }
    contest
}

/// Error and time of a contestant at a distance.
pub fn cost(series: &Series, distance: f64) -> (f64, f64) {
    let point = series.points.iter().find(|p| p.parameter == distance);
    point.map_or((f64::NAN, f64::NAN), |p| {
        (p.error.map_or(f64::NAN, |e| e.mid), p.time.map_or(f64::NAN, |t| t.mid))
    })
}
