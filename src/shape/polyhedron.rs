//! The convex polyhedron: what several half-spaces have in common [D §5.9.1.2]. A turned box is one.
//!
//! ```text
//! nᵢ · (p − pᵢ) ≤ 0 for every face i;    tᵢ = nᵢ · (pᵢ − o) / nᵢ · d
//! ```
//!
//! A line is inside from the largest `tᵢ` of the faces that it meets from the front (`nᵢ · d < 0`) to the
//! smallest of the others. The signs and the order of the `tᵢ` are decided with error bounds, again in 106 bits
//! where these leave a doubt ([`crate::num::certified`]); nothing is compared with a small number.

use super::{Shape, ShapeError, Solid, basis, first_between, span_of_pair};
use crate::bounds::Aabb;
use crate::num::certified::{Bounded, Scalar, Uncertain, Vector, power_of_two_below};
use crate::num::double_double::DoubleDouble;
use crate::num::{U, gamma};
use crate::ray::{Crossing, Hit, Ray, Span};
use glam::{DAffine3, DVec2, DVec3};

/// The side of a plane that its normal points away from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSpace {
    /// A point of the plane.
    pub point: DVec3,
    /// Outward, of any length but 0.
    pub normal: DVec3,
}

/// A face, ready for rays.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Face {
    point: DVec3,
    /// In the polyhedron's unit, and with a largest coordinate about 1.
    scaled: HalfSpace,
    normal: DVec3,
    tangent: DVec3,
    /// Lowest corner and size of the rectangle round the face, along tangent and bitangent.
    low: DVec2,
    size: DVec2,
}

/// A bounded convex solid with flat faces, numbered as its half-spaces were given.
///
/// Texture coordinates run over a rectangle round each face.
#[derive(Clone, Debug, PartialEq)]
pub struct ConvexPolyhedron {
    faces: Vec<Face>,
    vertices: Vec<DVec3>,
    bounds: Aabb,
    /// Power of two near the solid's size.
    unit: f64,
}

impl ConvexPolyhedron {
    /// What the half-spaces have in common.
    ///
    /// - Errors: numbers that are not finite, a normal of length 0; half-spaces that leave no volume or an unbounded one.
    pub fn new(half_spaces: &[HalfSpace]) -> Result<Self, ShapeError> {
        let mut faces = Vec::with_capacity(half_spaces.len());
        for half_space in half_spaces {
            let point = ShapeError::finite("point of a half-space", half_space.point)?;
            let normal = ShapeError::direction("normal of a half-space", half_space.normal)?;
            let tangent = basis(normal).0;
            let scaled = *half_space;
            faces.push(Face { point, scaled, normal, tangent, low: DVec2::ZERO, size: DVec2::ONE });
        }
        let met = vertices(&faces)?;
        let vertices: Vec<DVec3> = met.iter().map(|(v, _)| *v).collect();
        let tight = Aabb::of_points(vertices.iter().copied());
        let extent = (tight.max - tight.min).max_element();
        let unit = power_of_two_below(extent);
        let slack =
            4.0 * misplacement(&faces, extent) + U * tight.min.abs().max(tight.max.abs()).max_element();
        for face in &mut faces {
            let normal = face.scaled.normal;
            let point = face.point / unit;
            face.scaled =
                HalfSpace { point, normal: normal / power_of_two_below(normal.abs().max_element()) };
        }
        for (i, face) in faces.iter_mut().enumerate() {
            face.frame(met.iter().filter(|(_, meeting)| meeting.contains(&i)).map(|(v, _)| *v));
        }
        Ok(ConvexPolyhedron {
            faces,
            vertices,
            bounds: Aabb::new(tight.min - slack, tight.max + slack),
            unit,
        })
    }

    /// The box `min ≤ p ≤ max` seen through an affine map; faces as of [`super::cuboid::Cuboid`].
    ///
    /// - Errors: those of [`ConvexPolyhedron::new`]; a map that squashes space flat leaves no volume.
    pub fn of_box(min: DVec3, max: DVec3, to_world: &DAffine3) -> Result<Self, ShapeError> {
        let m = to_world.matrix3;
        let side = if m.determinant() < 0.0 { -1.0 } else { 1.0 };
        let along = [m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis)];
        let corners = [min, max].map(|p| to_world.transform_point3(p));
        let half_spaces: Vec<HalfSpace> = (0..6)
            .map(|face| {
                let outward = if face % 2 == 0 { -side } else { side };
                HalfSpace { point: corners[face % 2], normal: along[face / 2] * outward }
            })
            .collect();
        Self::new(&half_spaces)
    }

    /// The corners, in no particular order.
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// Where the whole line enters and leaves, equal for a touch.
    ///
    /// - Accuracy: each `t` within `64 u |t|`.
    pub fn roots(&self, ray: &Ray) -> Option<(Crossing, Crossing)> {
        let length = power_of_two_below(ray.direction.abs().max_element());
        let (o, d, stretch) = (ray.origin / self.unit, ray.direction / length, self.unit / length);
        let found = self.clip::<Bounded>(o, d).or_else(|Uncertain| self.clip::<DoubleDouble>(o, d));
        let (enter, leave) = found.unwrap_or(None)?;
        let scaled = |c: Crossing| Crossing { t: c.t * stretch, ..c };
        let (enter, leave) = (scaled(enter), scaled(leave));
        (enter.t.is_finite() && leave.t.is_finite()).then_some((enter, leave))
    }

    fn clip<T: Scalar>(&self, o: DVec3, d: DVec3) -> Result<Option<(Crossing, Crossing)>, Uncertain> {
        let mut enter: Option<(T, u32)> = None;
        let mut leave: Option<(T, u32)> = None;
        let direction = Vector::of(d);
        for (i, face) in self.faces.iter().enumerate() {
            let n = Vector::<T>::of(face.scaled.normal);
            let depth = n.dot(Vector::difference(face.scaled.point, o));
            let speed = n.dot(direction);
            match speed.sign()? {
                0 if depth.sign()? < 0 => return Ok(None),
                0 => {}
                way => {
                    let t = depth / speed;
                    let best = if way < 0 { &mut enter } else { &mut leave };
                    let better = match best {
                        None => true,
                        Some((held, _)) if way < 0 => held.is_below(t)?,
                        Some((held, _)) => t.is_below(*held)?,
                    };
                    if better {
                        *best = Some((t, i as u32));
                    }
                }
            }
        }
        // A bounded solid is entered and left.
        let (Some((t0, first)), Some((t1, last))) = (enter, leave) else { return Ok(None) };
        if t1.is_below(t0)? {
            return Ok(None);
        }
        Ok(Some((Crossing::new(t0.settled()?, first), Crossing::new(t1.settled()?, last))))
    }

    fn face(&self, face: u32) -> &Face {
        &self.faces[(face as usize).min(self.faces.len() - 1)]
    }

    /// How far out of the other faces' half-spaces a point lies; 0 inside.
    fn excess(&self, p: DVec3) -> f64 {
        self.faces.iter().map(|f| f.normal.dot(p - f.point)).fold(0.0, f64::max)
    }
}

impl Face {
    /// The rectangle round the face's vertices.
    fn frame(&mut self, vertices: impl Iterator<Item = DVec3>) {
        let (low, high) = vertices
            .map(|v| self.flat(v))
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), p| (l.min(p), h.max(p)));
        if low.cmplt(high).all() {
            (self.low, self.size) = (low, high - low);
        }
    }

    fn bitangent(&self) -> DVec3 {
        self.normal.cross(self.tangent)
    }

    fn flat(&self, p: DVec3) -> DVec2 {
        let from = p - self.point;
        DVec2::new(from.dot(self.tangent), from.dot(self.bitangent()))
    }
}

/// Bound on the error of a vertex computed from three planes whose normals' box product is 1.
fn misplacement(faces: &[Face], extent: f64) -> f64 {
    let reach = faces.iter().map(|f| (f.point - faces[0].point).abs().max_element()).fold(extent, f64::max);
    let origin = faces.iter().map(|f| f.point.abs().max_element()).fold(0.0, f64::max);
    gamma(40) * reach + 2.0 * U * origin
}

/// Points where three faces meet that lie outside no other, and which three.
fn vertices(faces: &[Face]) -> Result<Vec<(DVec3, [usize; 3])>, ShapeError> {
    let volume = ShapeError::NoVolume { what: "convex polyhedron" };
    let Some(base) = faces.first().map(|f| f.point) else { return Err(volume) };
    let offsets: Vec<f64> = faces.iter().map(|f| f.normal.dot(f.point - base)).collect();
    let blur = misplacement(faces, 0.0);
    let mut found = Vec::new();
    for i in 0..faces.len() {
        for j in 0..i {
            let edge = faces[i].normal.cross(faces[j].normal);
            // An edge along which no face turns the line away runs to infinity.
            let endless = |way: f64| faces.iter().all(|f| way * f.normal.dot(edge) <= gamma(8));
            if edge.length() > gamma(8) && (endless(1.0) || endless(-1.0)) {
                return Err(ShapeError::Unbounded { what: "convex polyhedron" });
            }
            for k in 0..j {
                let determinant = edge.dot(faces[k].normal);
                if determinant.abs() <= gamma(16) {
                    continue; // parallel to within rounding
                }
                let sum = faces[j].normal.cross(faces[k].normal) * offsets[i]
                    + faces[k].normal.cross(faces[i].normal) * offsets[j]
                    + edge * offsets[k];
                let v = sum / determinant;
                let slack = 4.0 * blur / determinant.abs();
                let inside = faces.iter().zip(&offsets).all(|(f, offset)| f.normal.dot(v) - offset <= slack);
                if inside {
                    found.push((base + v, [i, j, k]));
                }
            }
        }
    }
    let center = found.iter().map(|(v, _)| *v).sum::<DVec3>() / found.len().max(1) as f64;
    let deep = faces.iter().all(|f| f.normal.dot(center - f.point) < -4.0 * blur);
    if found.len() >= 4 && deep { Ok(found) } else { Err(volume) }
}

impl Shape for ConvexPolyhedron {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        let (enter, leave) = self.roots(ray)?;
        first_between([enter, leave], t_min, t_max)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        if let Some((enter, leave)) = self.roots(ray) {
            out.extend([enter].iter().filter(|c| c.t > 0.0));
            out.extend([leave].iter().filter(|c| c.t > 0.0 && c.t > enter.t));
        }
    }

    /// The point is put onto its plane and, near an edge, back behind the neighbours' planes.
    ///
    /// Each projection rounds 10 times relative to the distance from the face's own point; what then still
    /// stands out at an edge is added.
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let face = self.face(crossing.face);
        let w = (ray.origin - face.point) + ray.direction * crossing.t;
        let mut flat = w - face.normal * w.dot(face.normal);
        for (i, other) in self.faces.iter().enumerate() {
            let out = other.normal.dot(flat + (face.point - other.point));
            let slide = other.normal - face.normal * other.normal.dot(face.normal);
            // The squared sine of the angle between the planes: below rounding they have no edge in common.
            let sin2 = slide.length_squared();
            if out > 0.0 && i != crossing.face as usize && sin2 > gamma(16) {
                flat -= slide * (out / sin2);
            }
        }
        let point = face.point + flat;
        let rounding = gamma(20) * flat.abs().max_element() + 2.0 * U * point.abs().max_element();
        let share = ((face.flat(point) - face.low) / face.size).clamp(DVec2::ZERO, DVec2::ONE);
        Hit {
            t: crossing.t,
            point,
            point_error: (rounding + self.excess(point)).max(f64::MIN_POSITIVE),
            ng: face.normal,
            n: face.normal,
            tangent: face.tangent,
            uv: share,
            face: crossing.face,
            part: crossing.part,
        }
    }

    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        let face = self.face(face);
        let p = face.low + uv * face.size;
        face.point + face.tangent * p.x + face.bitangent() * p.y
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }
}

impl Solid for ConvexPolyhedron {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        out.extend(self.roots(ray).and_then(|(enter, leave)| span_of_pair(enter, leave)));
    }

    fn contains(&self, p: DVec3) -> bool {
        fn inside<T: Scalar>(polyhedron: &ConvexPolyhedron, p: DVec3) -> Result<bool, Uncertain> {
            for HalfSpace { point, normal } in polyhedron.faces.iter().map(|f| f.scaled) {
                if Vector::<T>::of(normal).dot(Vector::difference(point, p)).sign()? < 0 {
                    return Ok(false);
                }
            }
            Ok(true)
        }
        let p = p / self.unit;
        inside::<Bounded>(self, p).or_else(|Uncertain| inside::<DoubleDouble>(self, p)).unwrap_or(false)
    }
}

/// Where the line enters and leaves, from planes `n · p + D = 0` in plain `f64`.
///
/// - Domain: planes `(n, D)` with outward normals; faces are their numbers. A line parallel to a plane is judged by
///   its origin.
/// - Accuracy: `n · o + D` cancels with the distance; digits are lost in proportion to it.
/// - Source: Haines, *Fast Ray–Convex Polyhedron Intersection*, Graphics Gems II (1991) 247–250, which [D §5.9.1.2] uses.
pub fn textbook(planes: &[(DVec3, f64)], ray: &Ray) -> Option<(Crossing, Crossing)> {
    let mut near = Crossing::new(f64::NEG_INFINITY, 0);
    let mut far = Crossing::new(f64::INFINITY, 0);
    for (face, (n, offset)) in planes.iter().enumerate() {
        let (height, speed) = (n.dot(ray.origin) + offset, n.dot(ray.direction));
        if speed == 0.0 {
            if height > 0.0 {
                return None;
            }
            continue;
        }
        let t = -height / speed;
        if speed < 0.0 && t > near.t {
            near = Crossing::new(t, face as u32);
        } else if speed > 0.0 && t < far.t {
            far = Crossing::new(t, face as u32);
        }
        if near.t > far.t {
            return None;
        }
    }
    (near.t.is_finite() && far.t.is_finite()).then_some((near, far))
}
