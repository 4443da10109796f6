//! Where the constructions fail as they are printed, and the library's do not.

use super::cases;
use glam::{DVec2, DVec3};
use lightbench::light::{SphericalRectangle, SphericalTriangle};
use std::f64::consts::{PI, TAU};

/// Ureña, Fajardo & King (2013), listings 1 and 2, word for word; x of the point.
struct NaiveRectangle {
    s: f64,
    k: f64,
    b0: f64,
    b1: f64,
    z0: f64,
    x0: f64,
    x1: f64,
}

impl NaiveRectangle {
    fn new(corner: DVec3, ex: DVec3, ey: DVec3, o: DVec3) -> Self {
        let (x, y) = (ex.normalize(), ey.normalize());
        let mut z = x.cross(y);
        let d = corner - o;
        let mut z0 = d.dot(z);
        if z0 > 0.0 {
            z = -z;
            z0 = -z0;
        }
        let _ = z;
        let (x0, y0) = (d.dot(x), d.dot(y));
        let (x1, y1) = (x0 + ex.length(), y0 + ey.length());
        let v = |x, y| DVec3::new(x, y, z0);
        let (v00, v01, v10, v11) = (v(x0, y0), v(x0, y1), v(x1, y0), v(x1, y1));
        let n = [(v00, v10), (v10, v11), (v11, v01), (v01, v00)].map(|(a, b)| a.cross(b).normalize());
        let g: [f64; 4] = std::array::from_fn(|i| (-n[i].dot(n[(i + 1) % 4])).acos());
        let k = TAU - g[2] - g[3];
        NaiveRectangle { s: g[0] + g[1] - k, k, b0: n[0].z, b1: n[2].z, z0, x0, x1 }
    }

    fn x(&self, u: f64) -> f64 {
        let au = u * self.s + self.k;
        let fu = (au.cos() * self.b0 - self.b1) / au.sin();
        let cu = (1.0 / (fu * fu + self.b0 * self.b0).sqrt()).copysign(fu).clamp(-1.0, 1.0);
        (-(cu * self.z0) / (1.0 - cu * cu).sqrt()).clamp(self.x0, self.x1)
    }
}

/// Arvo (1995), figure 3, word for word: the area and the point on the arc from A to C.
fn naive_triangle(v: [DVec3; 3], u: f64) -> (f64, DVec3) {
    let [a, b, c] = v.map(DVec3::normalize);
    let normal = |a: DVec3, b: DVec3| a.cross(b).normalize();
    let (ab, bc, ca) = (normal(a, b), normal(b, c), normal(c, a));
    let (alpha, beta, gamma) = ((-ca.dot(ab)).acos(), (-ab.dot(bc)).acos(), (-bc.dot(ca)).acos());
    let area = alpha + beta + gamma - PI;
    let (s, t) = (u * area - alpha).sin_cos();
    let (p, q) = (t - alpha.cos(), s + alpha.sin() * a.dot(b));
    let cos_b = ((q * t - p * s) * alpha.cos() - q) / ((q * s + p * t) * alpha.sin());
    (area, a * cos_b + (c - a * c.dot(a)).normalize() * (1.0 - cos_b * cos_b).sqrt())
}

/// The worst errors of a light `size` rad wide or so: of Ω (relative) and of the share cut off by a point, printed and ours.
#[derive(Default, Debug)]
struct Worst {
    omega: f64,
    share: f64,
    our_share: f64,
}

/// NaN counts as 1: everything lost.
fn grow(worst: &mut f64, error: f64) {
    *worst = worst.max(if error.is_nan() { 1.0 } else { error.abs().min(1.0) });
}

fn rectangles(size: f64) -> Worst {
    let mut worst = Worst::default();
    for mut case in cases("printed", 300) {
        let (w, h) = (case.half_width * size, case.half_height * size);
        let p = case.p - case.center;
        if w.cross(h).normalize().dot(p).abs() < 0.1 * p.length() {
            continue;
        }
        let u = case.sampler.next_2d();
        let ours = SphericalRectangle::new(DVec3::ZERO, w, h, p);
        let printed = NaiveRectangle::new(-w - h, 2.0 * w, 2.0 * h, p);
        let share = |along: f64| {
            SphericalRectangle::new(w * (along - 1.0), w * along, h, p).solid_angle() / ours.solid_angle()
        };
        let along = (printed.x(u.x) - printed.x0) / (2.0 * w.length());
        grow(&mut worst.omega, printed.s / ours.solid_angle() - 1.0);
        grow(&mut worst.share, share(along) - u.x);
        let along = 0.5 + 0.5 * ours.point(u).dot(w.normalize()) / w.length();
        grow(&mut worst.our_share, share(along) - u.x);
    }
    worst
}

fn triangles(size: f64) -> Worst {
    let mut worst = Worst::default();
    for mut case in cases("printed", 300) {
        let (w, h) = (case.half_width * size, case.half_height * size);
        let p = case.p - case.center;
        let normal = w.cross(h).normalize();
        if normal.dot(p).abs() < 0.1 * p.length() {
            continue;
        }
        let v = [-w - h, w - h, w * 0.3 + h];
        let u = case.sampler.next_1d();
        let ours = SphericalTriangle::new(v, p);
        let (area, direction) = naive_triangle(v.map(|v| v - p), u);
        let share = |q: DVec3| SphericalTriangle::new([v[0], v[1], q], p).solid_angle() / ours.solid_angle();
        let hit = p + direction * (-normal.dot(p) / normal.dot(direction));
        grow(&mut worst.omega, area / ours.solid_angle() - 1.0);
        grow(&mut worst.share, share(hit) - u);
        grow(&mut worst.our_share, share(ours.point(DVec2::new(u, 1.0))) - u);
    }
    worst
}

/// A sum of angles minus 2π or π has the absolute error of its terms, some u: what is left of Ω are `u/Ω`. A light 10⁻³ rad wide has
/// lost 9 digits, one of 10⁻⁸ all of them. The point loses as much, for it uses the same differences.
#[test]
fn small_lights_lose_all_digits_as_printed() {
    for (name, measure) in [("rectangle", rectangles as fn(f64) -> Worst), ("triangle", triangles)] {
        for exponent in [0, 2, 4, 6, 8, 10] {
            let worst = measure(10f64.powi(-exponent));
            println!("{name} 1e-{exponent}: {worst:?}");
            assert!(worst.our_share <= 1e-12, "{name} 1e-{exponent}: {worst:?}");
            if exponent == 0 {
                assert!(worst.omega < 1e-9 && worst.share < 1e-9, "{name}: {worst:?}");
            }
            if exponent == 4 {
                assert!(worst.omega > 1e-9 && worst.share > 1e-9, "{name}: {worst:?}");
            }
            if exponent >= 8 {
                assert!(worst.omega > 0.5 && worst.share > 0.3, "{name} 1e-{exponent}: {worst:?}");
            }
        }
    }
}
