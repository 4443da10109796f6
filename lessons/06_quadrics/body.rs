//! A surface of second degree about a centre: its truth in 106 bits, its rays, and those who compete for it.

use glam::{DVec2, DVec3};
use lightbench::measure::Method;
use lightbench::num::double_double::DoubleDouble as Dd;
use lightbench::ray::{Crossing, Ray};
use lightbench::sample::{Sampler, uniform_disc};
use lightbench::shape::Shape;
use lightbench::shape::cone::{self, Cone, Ends};
use lightbench::shape::cylinder::{self, Cylinder, FarEnd};
use lightbench::shape::quadric::{Coefficients, Ellipsoid, Quadric, as_printed, textbook};
use lightbench::shape::sphere::Sphere;
use std::f64::consts::TAU;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Sphere,
    Ellipsoid,
    Cylinder,
    Cone,
}

impl Kind {
    pub const ALL: [Kind; 4] = [Kind::Sphere, Kind::Ellipsoid, Kind::Cylinder, Kind::Cone];

    pub fn name(self) -> &'static str {
        ["sphere", "ellipsoid 1 : ½ : 2", "cylinder", "cone"][self as usize]
    }

    /// The body with its centre, or the cone's apex, there. All numbers are powers of two: no coefficient rounds at home.
    pub fn at(self, center: DVec3) -> Body {
        let everywhere = [f64::NEG_INFINITY, f64::INFINITY];
        let body =
            |s, w, heights, aim, reach| Body { kind: self, center, s, slope: 0.0, w, heights, aim, reach };
        match self {
            Kind::Sphere => body([1.0, 1.0, 1.0], 1.0, everywhere, 0.0, 0.9),
            Kind::Ellipsoid => body([1.0, 4.0, 0.25], 1.0, everywhere, 0.0, 0.45),
            Kind::Cylinder => body([1.0, 1.0, 0.0], 1.0, [-64.0, 64.0], 0.0, 0.9),
            Kind::Cone => body([1.0, 1.0, -0.25], 0.0, [-4.0, 0.0], -2.0, 0.6),
        }
    }
}

/// `Σ sᵢ pᵢ² + 2 slope z = w` about a centre, between two heights above it.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    pub kind: Kind,
    pub center: DVec3,
    pub s: [f64; 3],
    pub slope: f64,
    pub w: f64,
    pub heights: [f64; 2],
    /// Rays are aimed at this height of the axis, within a disc of radius `reach` across them.
    pub aim: f64,
    pub reach: f64,
}

pub type FirstOf = Box<dyn Fn(&Ray) -> Option<f64>>;

/// A way to the first meeting.
pub struct Rival {
    pub method: Method,
    pub first: FirstOf,
}

pub fn first_positive(ts: impl IntoIterator<Item = f64>) -> Option<f64> {
    ts.into_iter().filter(|t| *t > 0.0).min_by(f64::total_cmp)
}

impl Body {
    /// `x² + y² = z`.
    pub fn paraboloid() -> Body {
        let (s, heights) = ([1.0, 1.0, 0.0], [f64::NEG_INFINITY, f64::INFINITY]);
        Body { slope: -0.5, w: 0.0, s, heights, ..Kind::Cylinder.at(DVec3::ZERO) }
    }

    /// A short cylinder: radius 1, height 4.
    pub fn can() -> Body {
        Body { heights: [-2.0, 2.0], reach: 2.5, ..Kind::Cylinder.at(DVec3::ZERO) }
    }

    /// A tube of radius 1 and height 8.
    pub fn tube() -> Body {
        Body { heights: [-4.0, 4.0], ..Kind::Cylinder.at(DVec3::ZERO) }
    }

    pub fn ends(&self) -> (DVec3, DVec3) {
        (self.center + DVec3::Z * self.heights[0], self.center + DVec3::Z * self.heights[1])
    }

    /// All crossings of the side between the two heights, ahead or behind, ascending, in 106 bits.
    ///
    /// The discriminant is taken by Lagrange's identity, `B² − A C = w A − Σ sᵢsⱼ (oᵢdⱼ − oⱼdᵢ)²`, which does not
    /// cancel with the distance.
    fn side(&self, ray: &Ray) -> Vec<Dd> {
        let o = [0, 1, 2].map(|i| Dd::difference(ray.origin[i], self.center[i]));
        let d = ray.direction.to_array().map(Dd::of);
        let (s, w, slope) = (self.s.map(Dd::of), Dd::of(self.w), Dd::of(self.slope));
        let form = |p: &[Dd; 3], q: &[Dd; 3]| s[0] * p[0] * q[0] + s[1] * p[1] * q[1] + s[2] * p[2] * q[2];
        let (a, b) = (form(&d, &d), form(&o, &d) + slope * d[2]);
        let c = form(&o, &o) + slope * o[2].shift(2.0) - w;
        let moment = |i: usize, j: usize| s[i] * s[j] * (o[i] * d[j] - o[j] * d[i]).square();
        let lagrange = w * a - moment(0, 1) - moment(1, 2) - moment(2, 0);
        let discriminant = if self.slope == 0.0 { lagrange } else { b * b - a * c };
        if discriminant.high < 0.0 {
            return Vec::new();
        }
        let root = discriminant.sqrt();
        let q = -(b + if b.high < 0.0 { -root } else { root });
        let inside = |t: &Dd| {
            let z = (o[2] + d[2] * *t).value();
            t.value().is_finite() && self.heights[0] <= z && z <= self.heights[1]
        };
        let mut found: Vec<Dd> = [q / a, c / q].into_iter().filter(inside).collect();
        found.sort_by(|a, b| a.high.total_cmp(&b.high));
        found
    }

    /// The first meeting with the side.
    pub fn truth(&self, ray: &Ray) -> Option<f64> {
        first_positive(self.side(ray).into_iter().map(Dd::value))
    }

    /// The first meeting with the side or a cap, in 106 bits.
    pub fn capped_truth(&self, ray: &Ray) -> Option<f64> {
        let cap = |height: f64| {
            let t = (Dd::of(self.center.z + height) - Dd::of(ray.origin.z)) / Dd::of(ray.direction.z);
            let at = |i: usize| Dd::difference(ray.origin[i], self.center[i]) + Dd::of(ray.direction[i]) * t;
            let out = at(0).square() + at(1).square();
            (t.value().is_finite() && out.value() <= self.w).then(|| t.value())
        };
        let caps = self.heights.into_iter().filter_map(cap);
        first_positive(self.side(ray).into_iter().map(Dd::value).chain(caps))
    }

    /// Rays from `distance` away that are no steeper than cos 37° to the axis.
    pub fn rays(&self, seed: u64, count: u32, distance: f64) -> Vec<Ray> {
        let ray = |i| {
            let mut dice = Sampler::new(seed, distance.to_bits(), i);
            let [turn, rise] = dice.next_2d().to_array();
            let z = 0.8 * (2.0 * rise - 1.0);
            let out = (1.0 - z * z).sqrt() * DVec2::from_angle(turn * TAU);
            let direction = out.extend(z).normalize();
            let (right, up) = direction.any_orthonormal_pair();
            let aside = self.reach * uniform_disc(dice.next_2d());
            let target = self.center + DVec3::Z * self.aim + right * aside.x + up * aside.y;
            Ray::new(target - direction * distance, direction)
        };
        (0..count).map(ray).collect()
    }

    /// The ten numbers of [A (2.1)], rounded as `f64` must.
    pub fn coefficients(&self) -> Coefficients {
        let s = DVec3::from_array(self.s);
        let moved = -(s * self.center);
        let j = (s * self.center).dot(self.center) - 2.0 * self.slope * self.center.z - self.w;
        let (d, g, i) = (moved.x, moved.y, moved.z + self.slope);
        Coefficients { a: s.x, e: s.y, h: s.z, d, g, i, j, ..Coefficients::default() }
    }

    /// The library's own shape, open at the ends.
    fn shape(&self) -> Box<dyn Shape> {
        let (p0, p1) = self.ends();
        match self.kind {
            Kind::Sphere => Box::new(Sphere::new(self.center, 1.0).expect("a sphere")),
            Kind::Ellipsoid => {
                Box::new(Ellipsoid::new(self.center, DVec3::new(1.0, 0.5, 2.0)).expect("an ellipsoid"))
            }
            Kind::Cylinder => Box::new(Cylinder::new(p0, p1, 1.0).expect("a cylinder").with_ends(Ends::Open)),
            Kind::Cone => Box::new(Cone::new(p0, p1, 2.0, 0.0).expect("a cone").with_ends(Ends::Open)),
        }
    }

    /// The capped cylinder by the library.
    pub fn dedicated(&self) -> FirstOf {
        let (p0, p1) = self.ends();
        let shape = Cylinder::new(p0, p1, 1.0).expect("a cylinder");
        Box::new(move |ray| shape.nearest(ray, 0.0, f64::INFINITY).map(|c| c.t))
    }

    /// Dedicated: ours, and the documents' formulas; general: ours, A's formulas, A's listing.
    pub fn rivals(&self) -> [Rival; 5] {
        let (shape, coefficients) = (self.shape(), self.coefficients());
        let ((p0, p1), [low, high], middle) = (self.ends(), self.heights, self.center.z);
        let quadric = Quadric::new(coefficients).expect("a quadric");
        let kept = move |ray: &Ray, t: &f64| {
            let z = ray.origin.z - middle + ray.direction.z * t;
            low <= z && z <= high
        };
        let side = |found: Vec<Crossing>| found.into_iter().find(|c| c.face == 0).map(|c| c.t);
        let by_document: FirstOf = match self.kind {
            Kind::Cone => Box::new(move |ray| side(cone::textbook(p0, p1, 2.0, 0.0, ray))),
            _ => Box::new(move |ray| side(cylinder::textbook(p0, p1, 1.0, FarEnd::Corrected, ray))),
        };
        let rival = |method: Method, first: FirstOf| Rival { method, first };
        let document =
            if self.kind == Kind::Cone { "dedicated, E's field" } else { "dedicated, B's formulas" };
        [
            rival(
                Method::default_of("dedicated, ours").styled(0),
                Box::new(move |ray| shape.nearest(ray, 0.0, f64::INFINITY).map(|c| c.t)),
            ),
            rival(Method::new(document).styled(1), by_document),
            rival(
                Method::new("general, ours").styled(2),
                Box::new(move |ray| {
                    first_positive(quadric.line(ray).into_iter().map(|c| c.t).filter(|t| kept(ray, t)))
                }),
            ),
            rival(
                Method::new("general, A's formulas").styled(3),
                Box::new(move |ray| {
                    first_positive(textbook(&coefficients, ray).into_iter().filter(|t| kept(ray, t)))
                }),
            ),
            rival(
                Method::as_printed("general, A's listing"),
                Box::new(move |ray| as_printed(&coefficients, ray).filter(|t| kept(ray, t))),
            ),
        ]
    }
}
