//! The scene of lesson 01: a paper theatre, flat shapes that shine by themselves, one behind the other, so
//! that no ray needs more than a division. And the dotted sky, to see what wide angles do.

use super::DEPTH;
use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::color::Rgb;
use lightbench::film::Image;
use lightbench::scene::pinhole::obscura_line;
use lightbench::scene::{Camera, FieldOfView, ndc_from_raster};

/// The stage stands a hair off round numbers [m], so that no pixel's centre lies on an edge, where
/// rounding decides.
const OFF: DVec2 = dvec2(0.00137, 0.00071);

const PICTURE: (usize, usize) = (840, 600); // pixels; 7 : 5, as B's little picture

/// Distance of each flat before the hole [m], and what is painted on it; nothing where it is cut away.
type Flat = (f64, fn(DVec2) -> Option<Rgb>);
const FLATS: [Flat; 4] = [(2.0, letter), (3.2, tree), (4.0, house), (9.0, hills)];

/// Radiance that arrives from `direction` at `origin`, in camera space.
pub fn radiance(origin: DVec3, direction: DVec3) -> Rgb {
    for (distance, painted) in FLATS {
        let t = (-distance - origin.z) / direction.z;
        if let Some(rgb) = (t > 0.0).then(|| painted((origin + direction * t).truncate() + OFF)).flatten() {
            return rgb;
        }
    }
    let height = (direction.normalize().y * 1.6).clamp(0.0, 1.0);
    dvec3(0.95, 0.83, 0.66).lerp(dvec3(0.20, 0.45, 0.85), height)
}

fn within(p: DVec2, min: [f64; 2], max: [f64; 2]) -> bool {
    p.cmpge(DVec2::from(min)).all() && p.cmple(DVec2::from(max)).all()
}

fn letter(p: DVec2) -> Option<Rgb> {
    let bars = [([-1.45, -0.95], [-1.2, 0.75]), ([-1.2, 0.52], [-0.45, 0.75]), ([-1.2, -0.1], [-0.65, 0.13])];
    bars.iter().any(|(a, b)| within(p, *a, *b)).then_some(dvec3(0.85, 0.10, 0.06))
}

fn tree(p: DVec2) -> Option<Rgb> {
    let crown = [(1.55, 0.25, 0.62), (1.15, 0.0, 0.42), (1.95, -0.02, 0.42)];
    if crown.iter().any(|&(x, y, r)| p.distance(dvec2(x, y)) < r) {
        return Some(dvec3(0.07, 0.33, 0.09));
    }
    within(p, [1.45, -1.5], [1.65, 0.0]).then_some(dvec3(0.20, 0.10, 0.05))
}

fn house(p: DVec2) -> Option<Rgb> {
    let panes = [[-0.62, -0.55], [0.28, -0.55]];
    if panes.iter().any(|&[x, y]| within(p, [x, y], [x + 0.34, y + 0.42])) {
        return Some(dvec3(0.98, 0.78, 0.25));
    }
    if within(p, [-0.12, -1.6], [0.16, -0.75]) {
        return Some(dvec3(0.16, 0.08, 0.05));
    }
    if within(p, [-0.9, -1.6], [0.9, 0.15]) {
        return Some(dvec3(0.80, 0.74, 0.62));
    }
    let roof = p.y > 0.15 && p.x.abs() < 1.1 * (1.0 - (p.y - 0.15) / 0.75);
    roof.then_some(dvec3(0.42, 0.12, 0.08))
}

fn hills(p: DVec2) -> Option<Rgb> {
    let crest = -0.3 + 0.45 * (0.7 * p.x + 1.0).sin() + 0.2 * (1.7 * p.x).sin();
    let sun = p.distance(dvec2(-1.0, 3.1)) < 0.55;
    let meadow = dvec3(0.30, 0.52, 0.16).lerp(dvec3(0.16, 0.36, 0.12), ((crest - p.y) * 0.3).clamp(0.0, 1.0));
    (p.y < crest).then_some(meadow).or(sun.then_some(dvec3(1.0, 0.93, 0.55)))
}

/// Half the width and height of the film [m].
pub fn film_half() -> DVec2 {
    DVec2::new(0.7, 0.5) * DEPTH
}

/// The film of a box with a hole without width, as somebody inside sees it who looks towards the scene.
pub fn on_film() -> Image {
    let size = dvec2(PICTURE.0 as f64, PICTURE.1 as f64);
    Image::from_fn(PICTURE.0, PICTURE.1, |i, j| {
        let ndc = ndc_from_raster(dvec2(i as f64, j as f64) + 0.5, size);
        let film = film_half() * dvec2(2.0 * ndc.x - 1.0, 1.0 - 2.0 * ndc.y);
        let (_, direction) = obscura_line(film, DVec2::ZERO, DEPTH);
        radiance(DVec3::ZERO, direction)
    })
}

/// The same picture by a camera: the film stands before the hole, at distance 1.
pub fn in_window() -> Image {
    let fov = FieldOfView::Vertical(2.0 * (film_half().y / DEPTH).atan());
    let camera = Camera::new(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, fov).expect("a camera in its place");
    Image::from_fn(PICTURE.0, PICTURE.1, |i, j| {
        let ray = camera.ray(dvec2(i as f64, j as f64) + 0.5, PICTURE.0, PICTURE.1);
        radiance(ray.origin, ray.direction)
    })
}

/// A sky with round dots every 15° of latitude and longitude, 5° in radius: the same solid angle each.
pub fn dotted_sky(direction: DVec3) -> Rgb {
    let d = direction.normalize();
    let step = 15f64.to_radians();
    let latitude = (d.y.asin() / step).round() * step;
    // Dots of a circle of latitude stand as far apart as elsewhere.
    let apart = step / latitude.cos().max(0.1);
    let longitude = (d.x.atan2(-d.z) / apart).round() * apart;
    let (sin, cos) = latitude.sin_cos();
    let center = dvec3(cos * longitude.sin(), sin, -cos * longitude.cos());
    match d.dot(center) > 5f64.to_radians().cos() {
        true if latitude.abs() < 0.5 * step && longitude.abs() < 0.5 * step => dvec3(0.80, 0.20, 0.03),
        true => dvec3(0.03, 0.20, 0.45),
        false => dvec3(0.93, 0.91, 0.86),
    }
}
