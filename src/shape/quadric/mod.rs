//! Quadrics: every surface of second degree [A §2.3.1, §5.4.3].
//!
//! ```text
//! q(p) = A x² + E y² + H z² + 2B xy + 2F yz + 2C xz + 2D x + 2G y + 2I z + J = 0        (1)  [A (2.1)]
//! q(o + t d) = a t² + 2 b t + c,    a = d·Qd,  b = d·(Qo + l),  c = o·(Qo + 2l) + J     (2)  [A (5.12)–(5.14)]
//! ```
//!
//! `q < 0` is inside; normals follow the gradient `2(Qp + l)`. Far from the surface `c` in (2) is a small
//! difference of large terms, so the ray's origin first moves along the ray to the surface or to the middle
//! of the chord; (2) is then evaluated with error bounds, and in 106 bits where these do not decide.

mod clipped;
mod ellipsoid;
mod named;
mod textbook;

pub use clipped::ClippedQuadric;
pub use ellipsoid::Ellipsoid;
pub use textbook::{as_printed, textbook};

use super::triangle::largest_axis;
use super::{Shape, ShapeError, Solid, unit};
use crate::bounds::Aabb;
use crate::num::certified::{
    Bounded, Roots, Scalar, Uncertain, Vector, no_root_ahead, power_of_two_below, solve_quadratic,
};
use crate::num::double_double::DoubleDouble;
use crate::num::expansion::Expansion;
use crate::num::{U, gamma};
use crate::ray::{Crossing, Hit, Ray, Span};
use arrayvec::ArrayVec;
use glam::{DVec2, DVec3};

/// The ten numbers of (1), by their names there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Coefficients {
    pub a: f64,
    pub b: f64,
    pub c: f64,
    pub d: f64,
    pub e: f64,
    pub f: f64,
    pub g: f64,
    pub h: f64,
    pub i: f64,
    pub j: f64,
}

impl Coefficients {
    fn rows(&self) -> [[f64; 3]; 3] {
        [[self.a, self.b, self.c], [self.b, self.e, self.f], [self.c, self.f, self.h]]
    }

    fn linear(&self) -> DVec3 {
        DVec3::new(self.d, self.g, self.i)
    }

    /// Quadratic, linear and constant numbers divided by what belongs to their degree.
    fn divided(&self, [by2, by1, by0]: [f64; 3]) -> Self {
        let Coefficients { a, b, c, d, e, f, g, h, i, j } = *self;
        Coefficients {
            a: a / by2,
            b: b / by2,
            c: c / by2,
            e: e / by2,
            f: f / by2,
            h: h / by2,
            d: d / by1,
            g: g / by1,
            i: i / by1,
            j: j / by0,
        }
    }

    /// The same surface with lengths counted in `unit`, a power of two, and its leading numbers as large as before.
    fn counted_in(&self, unit: f64) -> Self {
        if self.is_curved() {
            // One division after the other: the square of the unit may overflow.
            self.divided([1.0, unit, unit]).divided([1.0, 1.0, unit])
        } else {
            self.divided([1.0, 1.0, unit])
        }
    }

    fn is_curved(&self) -> bool {
        self.rows().iter().flatten().any(|&x| x != 0.0)
    }

    /// `Qp`.
    #[inline]
    fn times<T: Scalar>(&self, p: Vector<T>) -> Vector<T> {
        Vector(self.rows().map(|row| Vector(row.map(T::of)).dot(p)))
    }

    /// `a`, `b`, `c` of (2) about the point at `t`.
    #[inline]
    fn along<T: Scalar>(&self, o: DVec3, d: DVec3, t: f64) -> [T; 3] {
        let p = Vector::of(o) + Vector::along(d, t);
        let (d, l) = (Vector::of(d), Vector::of(self.linear()));
        let half_gradient = self.times(p) + l;
        let a = d.dot(self.times(d));
        [a, half_gradient.dot(d), p.dot(half_gradient + l) + T::of(self.j)]
    }

    /// Sums of the absolute values of the terms of `a`, `b`, `c` of (2) at the ray's origin.
    fn sizes(&self, o: DVec3, d: DVec3) -> [f64; 3] {
        let (o, d, l) = (o.abs(), d.abs(), self.linear().abs());
        let rows = self.rows().map(|row| DVec3::from_array(row).abs());
        let times = |p: DVec3| DVec3::new(rows[0].dot(p), rows[1].dot(p), rows[2].dot(p));
        let half = times(o) + l;
        [d.dot(times(d)), d.dot(half), o.dot(half + l) + self.j.abs()]
    }

    /// The sign of `q(p)`, in 106 bits.
    fn sign_at(&self, p: DVec3) -> i8 {
        let [_, _, c] = self.along::<DoubleDouble>(p, DVec3::ZERO, 0.0);
        c.sign().unwrap_or(0)
    }

    /// `q(p)` and half its gradient `Qp + l`.
    fn at(&self, p: DVec3) -> (f64, DVec3) {
        let rows = self.rows().map(DVec3::from_array);
        let half = DVec3::new(rows[0].dot(p), rows[1].dot(p), rows[2].dot(p)) + self.linear();
        (p.dot(half + self.linear()) + self.j, half)
    }

    /// Sum of the absolute values of the terms of `q(p)`, and the largest of the matrix's row sums.
    fn magnitude(&self, p: DVec3) -> (f64, f64) {
        let [_, _, terms] = self.sizes(p, DVec3::ZERO);
        let norm = self.rows().iter().map(|row| row.iter().map(|x| x.abs()).sum()).fold(0.0, f64::max);
        (terms, norm)
    }
}

fn largest(xs: &[f64]) -> f64 {
    xs.iter().map(|x| x.abs()).fold(0.0, f64::max)
}

/// A surface of second degree; unbounded, but for ellipsoids.
///
/// Faces: 0 where `q` grows along the mapping's axis, 1 where it falls: the two sheets over a plane.
/// Texture coordinates: the other two coordinates of the point, in lengths, not confined to `[0,1]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadric {
    given: Coefficients,
    /// The same surface with lengths counted in `unit`, and the largest number about 1.
    scaled: Coefficients,
    unit: f64,
    /// Over which axis the sheets are told apart: that of the largest square, else of the largest slope.
    axis: usize,
}

/// The roots of (2) on a whole line.
struct Found {
    roots: ArrayVec<f64, 2>,
    /// Is the line inside before the first root, and does it change sides at a single one?
    inside_before: bool,
    single_crosses: bool,
}

impl Quadric {
    /// The surface with these coefficients.
    ///
    /// - Domain: finite; at least one coefficient beside `J` is not 0.
    pub fn new(given: Coefficients) -> Result<Self, ShapeError> {
        let quadratic = [given.a, given.b, given.c, given.e, given.f, given.h];
        let linear = given.linear().to_array();
        if let Some(&found) = quadratic.iter().chain(&linear).chain([&given.j]).find(|x| !x.is_finite()) {
            return Err(ShapeError::NotFinite { what: "coefficient of a quadric", found });
        }
        let (square, slope) = (largest(&quadratic), largest(&linear));
        // Lengths at which the linear and the constant terms are as large as the leading ones.
        let (lead, unit) = if square > 0.0 {
            let unit = (slope / square).max((given.j.abs() / square).sqrt());
            (power_of_two_below(square), power_of_two_below(unit))
        } else if slope > 0.0 {
            (power_of_two_below(slope), power_of_two_below(given.j.abs() / slope))
        } else {
            return Err(ShapeError::NoEquation { what: "quadric" });
        };
        let scaled = given.divided([lead, lead, lead]).counted_in(unit);
        let squares = [scaled.a, scaled.e, scaled.h];
        let upright = if largest(&squares) > 0.0 {
            squares
        } else if square > 0.0 {
            scaled.rows().map(|row| largest(&row))
        } else {
            linear
        };
        Ok(Quadric { given, scaled, unit, axis: largest_axis(DVec3::from_array(upright)) })
    }

    pub fn coefficients(&self) -> Coefficients {
        self.given
    }

    /// The unit vector along the gradient, from `q < 0` to `q > 0`; `None` where it vanishes (the apex of a cone).
    pub fn gradient(&self, p: DVec3) -> Option<DVec3> {
        unit(self.scaled.at(p / self.unit).1)
    }

    /// The axis over which the two sheets lie, and the two others.
    fn axes(&self) -> [usize; 3] {
        [self.axis, (self.axis + 1) % 3, (self.axis + 2) % 3]
    }

    fn face_at(&self, p: DVec3) -> u32 {
        u32::from(self.scaled.at(p / self.unit).1[self.axis] < 0.0)
    }

    /// All crossings on the line, ascending, any sign of `t`.
    ///
    /// - Accuracy: each `t` within `64 u |t|`; their number as exact arithmetic decides, unless a change of the
    ///   coefficients by `2⁻⁹⁵` would change it.
    pub fn line(&self, ray: &Ray) -> ArrayVec<Crossing, 2> {
        let roots = self.find(ray).roots;
        roots.into_iter().map(|t| Crossing::new(t, self.face_at(ray.at(t)))).collect()
    }

    /// Does the ray certainly not meet the surface at any `t > 0`?
    ///
    /// The numbers of (2) at the ray's origin, with their errors: `a` is a sum of products of three
    /// inputs, behind which stand at most 8 roundings (2 products and 3 sums in `Qd`, a product and 2 sums outside),
    /// and `b` and `c` have the sum with `l` as one more, `c` a last one with `J`: 10 u of the sums of the absolute values.
    fn is_behind_or_beside(&self, ray: &Ray) -> bool {
        let length = power_of_two_below(ray.direction.abs().max_element());
        let (o, d) = (ray.origin / self.unit, ray.direction / length);
        let q = &self.scaled;
        let sizes = q.sizes(o, d);
        let abc = q.along::<f64>(o, d, 0.0);
        let bounded = std::array::from_fn(|i| Bounded::within(abc[i], gamma(10) * sizes[i]));
        no_root_ahead(bounded, || q.sign_at(o))
    }

    fn find(&self, ray: &Ray) -> Found {
        let length = power_of_two_below(ray.direction.abs().max_element());
        let (mut o, d) = (ray.origin / self.unit, ray.direction / length);
        let (mut q, mut unit) = (self.scaled, self.unit);
        let far = o.abs().max_element();
        if far > 2f64.powi(200) {
            // Beside such distances the surface's own size does not matter; the powers stay finite.
            let by = power_of_two_below(far);
            q = q.counted_in(by);
            (o, unit) = (o / by, unit * by);
        }
        let t = start(&q, o, d);
        let mut found = roots_about::<Bounded>(&q, o, d, t)
            .or_else(|Uncertain| roots_about::<DoubleDouble>(&q, o, d, t))
            .unwrap_or(Found { roots: ArrayVec::new(), inside_before: false, single_crosses: false });
        found.roots = found.roots.into_iter().map(|t| t * unit / length).filter(|t| t.is_finite()).collect();
        found
    }
}

/// Where along the ray to expand (2): at the nearer root if the other is far away, else between the two.
///
/// Any answer is right; this one keeps `b² − ac` and the roots free from large cancelling terms.
fn start(q: &Coefficients, o: DVec3, d: DVec3) -> f64 {
    let [a, b, c] = q.along::<f64>(o, d, 0.0);
    let vertex = -b / a;
    let discriminant = b * b - a * c;
    let nearer = if discriminant > 0.0 { -c / (b + discriminant.sqrt().copysign(b)) } else { vertex };
    let t = if nearer.abs() < 0.5 * vertex.abs() || !vertex.is_finite() { nearer } else { vertex };
    if t.is_finite() { t } else { 0.0 }
}

fn roots_about<T: Quadratic>(q: &Coefficients, o: DVec3, d: DVec3, t: f64) -> Result<Found, Uncertain> {
    let [a, b, c] = T::sharpened(q.along::<T>(o, d, t), q, o, d);
    let solved = solve_quadratic(a, b, c)?;
    let mut roots = ArrayVec::new();
    let middle = T::of(t);
    let way = a.sign()?;
    let inside_before = match way {
        0 if b.sign()? == 0 => c.sign()? < 0,
        0 => b.sign()? > 0,
        way => way < 0,
    };
    match solved {
        Roots::None => {}
        Roots::One(t) => roots.push((middle + t).settled()?),
        Roots::Two(t0, t1) => roots.extend([(middle + t0).settled()?, (middle + t1).settled()?]),
    }
    Ok(Found { roots, inside_before, single_crosses: way == 0 })
}

/// What the slow arithmetic does beyond rounding carefully.
trait Quadratic: Scalar {
    /// The same `a`, `b`, `c`, where an `a` or `b` that is nothing but rounding is replaced.
    fn sharpened(abc: [Self; 3], _q: &Coefficients, _o: DVec3, _d: DVec3) -> [Self; 3] {
        abc
    }
}

impl Quadratic for Bounded {}

impl Quadratic for DoubleDouble {
    /// `a` is computed exactly where 106 bits leave less than 53 of it: a line parallel to a paraboloid's axis, a
    /// cone's side or an asymptote has exactly one root or none, and no second one at 10³⁰.
    fn sharpened([a, b, c]: [Self; 3], q: &Coefficients, o: DVec3, d: DVec3) -> [Self; 3] {
        let (_, norm) = q.magnitude(d);
        let size = d.abs().max_element();
        if a.value().abs() > 2f64.powi(-48) * norm * size * size {
            return [a, b, c];
        }
        let mut sum = Expansion::default();
        for (row, x) in q.rows().iter().zip(d.to_array()) {
            for (q, y) in row.iter().zip(d.to_array()) {
                sum.add_triple([x, *q, y]);
            }
        }
        let exact_a = sum.value();
        if exact_a != 0.0 {
            return [DoubleDouble::of(exact_a), b, c];
        }
        // Without `a`, `b` is the same all along the line.
        let mut sum = Expansion::default();
        for (row, x) in q.rows().iter().zip(d.to_array()) {
            for (q, y) in row.iter().zip(o.to_array()) {
                sum.add_triple([x, *q, y]);
            }
        }
        for (x, l) in d.to_array().into_iter().zip(q.linear().to_array()) {
            sum.add_triple([x, l, 1.0]);
        }
        let b = if sum.sign() == 0 { DoubleDouble::ZERO } else { b };
        [DoubleDouble::ZERO, b, c]
    }
}

impl Shape for Quadric {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        if t_min >= 0.0 && self.is_behind_or_beside(ray) {
            return None;
        }
        let t = self.find(ray).roots.into_iter().find(|&t| t_min < t && t < t_max)?;
        Some(Crossing::new(t, self.face_at(ray.at(t))))
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        out.extend(self.line(ray).into_iter().filter(|c| c.t > 0.0));
    }

    /// One Newton step along the gradient puts the point onto the surface.
    ///
    /// Its distance is then at most `2 |δ|/|∇q|`, `δ` the rounding of `q` (14 operations, relative to the sum of its
    /// absolute terms), as long as the gradient outweighs the curvature: `4 |q| ‖Q‖ ≤ |∇q|²`. Near
    /// a singular point the point stays where the ray puts it, known to the accuracy of `t`. There
    /// the normal, which does not exist, is turned towards the ray.
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let p = ray.at(crossing.t);
        let scaled = p / self.unit;
        let (q, half) = self.scaled.at(scaled);
        let (terms, norm) = self.scaled.magnitude(scaled);
        let (noise, steep) = (gamma(14) * terms, 2.0 * half.length());
        let along = ray.origin.abs() + (ray.direction * crossing.t).abs();
        let mut point = p;
        let mut point_error = 70.0 * U * along.length();
        let corrected = 2.0 * noise / steep * self.unit + 2.0 * U * p.abs().max_element();
        if 4.0 * (q.abs() + noise) * norm <= steep * steep && corrected < point_error {
            point = (scaled - half * (2.0 * q / (steep * steep))) * self.unit;
            point_error = corrected;
        }
        let toward = unit(-ray.direction).unwrap_or(DVec3::X);
        let ng = self.gradient(point).unwrap_or(toward);
        let [w, u, v] = self.axes();
        // Along growing u on the sheet: square to the gradient, without the third axis.
        let mut tangent = DVec3::ZERO;
        tangent[u] = ng[w];
        tangent[w] = -ng[u];
        let tangent = unit(if ng[w] < 0.0 { -tangent } else { tangent });
        Hit {
            t: crossing.t,
            point,
            point_error,
            ng,
            n: ng,
            tangent: tangent.unwrap_or(DVec3::AXES[u]),
            uv: DVec2::new(point[u], point[v]),
            face: crossing.face,
            part: crossing.part,
        }
    }

    /// Where the face has no point over `uv`, that of the other face, else where the sheets come closest.
    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        let [w, u, v] = self.axes();
        let mut p = DVec3::ZERO;
        (p[u], p[v]) = (uv.x, uv.y);
        let upright = Ray::new(p, DVec3::AXES[w]);
        let line = self.line(&upright);
        let chosen = line.iter().find(|c| c.face == face).or(line.first()).map(|c| c.t);
        let [a, b, _] = self.scaled.along::<f64>(p / self.unit, DVec3::AXES[w], 0.0);
        p[w] = chosen.unwrap_or(if a != 0.0 { -b / a * self.unit } else { 0.0 });
        p
    }

    fn bounds(&self) -> Aabb {
        Aabb::EVERYTHING
    }
}

impl Solid for Quadric {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        let found = self.find(ray);
        let crossing = |t: f64| Crossing::new(t, self.face_at(ray.at(t)));
        let never = Crossing::new(f64::NEG_INFINITY, 0);
        let always = Crossing::new(f64::INFINITY, 0);
        match (found.inside_before, found.roots.as_slice()) {
            (true, [t]) if found.single_crosses => out.push(Span { enter: never, leave: crossing(*t) }),
            (false, [t]) if found.single_crosses => out.push(Span { enter: crossing(*t), leave: always }),
            (true, [] | [_]) => out.push(Span { enter: never, leave: always }),
            (true, [t0, t1, ..]) => {
                out.push(Span { enter: never, leave: crossing(*t0) });
                out.push(Span { enter: crossing(*t1), leave: always });
            }
            (false, [t0, t1, ..]) if t0 < t1 => {
                out.push(Span { enter: crossing(*t0), leave: crossing(*t1) });
            }
            (false, _) => {}
        }
    }

    fn contains(&self, p: DVec3) -> bool {
        let p = p / self.unit;
        let [_, _, c] = self.scaled.along::<Bounded>(p, DVec3::ZERO, 0.0);
        c.sign().unwrap_or_else(|Uncertain| self.scaled.sign_at(p)) <= 0
    }
}
