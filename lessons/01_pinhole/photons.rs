//! Diagrams of lesson 01: photons forwards, rays backwards.

use super::obscura::told;
use super::{DISTANCE, HOLES, PHOTONS};
use glam::{DVec2, DVec3, Vec3Swizzles, dvec2, dvec3};
use lightbench::sample::{point2, uniform, uniform_sphere};
use lightbench_kit::figure::{Diagram, Figure, Light, grouped};
use std::f64::consts::{PI, TAU};

/// Where a line first meets a ball, in lengths of its direction; lesson 02 does it with care.
pub fn meets(origin: DVec3, direction: DVec3, center: DVec3, radius: f64) -> Option<f64> {
    let (f, d) = (origin - center, direction.normalize());
    let along = -f.dot(d);
    let across2 = (f + d * along).length_squared();
    let t = along - (radius * radius - across2).max(0.0).sqrt();
    (across2 <= radius * radius && t > 0.0).then_some(t / direction.length())
}

/// B, figures 3.4 and 5.1: a ray hits or misses.
pub fn hit_or_miss() -> Figure {
    let (center, radius, plane, rows) = (dvec3(5.0, 0.05, 0.0), 1.15, 1.5, 7);
    let mut hits = 0;
    let mut d =
        Diagram::new(dvec2(-0.9, -2.05), dvec2(7.2, 2.15)).circle(center.truncate(), radius).word("ball");
    d = d.curve(&[dvec2(plane, -1.05), dvec2(plane, 1.05)]).note(dvec2(plane, -1.45), "image plane");
    for j in 0..rows {
        let (low, high) = (0.3 * f64::from(j) - 1.05, 0.3 * f64::from(j) - 0.75);
        let direction = dvec3(plane, 0.5 * (low + high), 0.0);
        d = d
            .thin(&[dvec2(plane - 0.06, low), dvec2(plane + 0.06, low)])
            .thin(&[dvec2(plane - 0.06, high), dvec2(plane + 0.06, high)]);
        match meets(DVec3::ZERO, direction, center, radius) {
            Some(t) => {
                hits += 1;
                let p = (direction * t).truncate();
                d = d.path(Light::Reflected, &[dvec2(plane, low + 0.03), dvec2(plane, high - 0.03)]);
                d = d.ray(Light::Incident, DVec2::ZERO, p).spot(Light::Reflected, p);
            }
            None => {
                d = d.ray(
                    Light::Shadow,
                    DVec2::ZERO,
                    direction.truncate() * (6.6 / plane).min(2.0 / direction.y.abs()),
                )
            }
        }
    }
    d = d.eye(DVec2::ZERO, DVec2::X).word("eye");
    let d = d
        .title(&format!(
            "Backwards every ray tells its pixel something: {hits} of {rows} hit, {} \
         miss",
            rows - hits
        ))
        .subtitle(
            "side view; one ray from the eye through each pixel's centre; a miss is an answer too: \
             background",
        )
        .alt(
            "Side view: an eye sends seven rays through the pixels of an image plane. Some hit a ball, \
             where they end in a dot, and their pixels \
              are marked in its colour; the others, dashed, pass by.",
        );
    told(
        d,
        "After B, figures 3.4 and 5.1: primary rays hit or miss; a pixel takes the colour of the point that \
             its ray meets.",
    )
}

/// B, figure 3.3: photons scattered by a ball, and the first that finds the eye.
pub fn forward(seed: u64) -> Figure {
    let (lamp, eye, pupil) = (dvec2(-2.6, 2.1), dvec2(3.2, 1.0), 0.05);
    const DRAWN: u32 = 20;
    let (center, radius) = (DVec2::ZERO, 0.9);
    let mut first = None;
    let mut d = Diagram::new(dvec2(-3.6, -1.75), dvec2(4.2, 2.6)).circle(center, radius).word("matt ball");
    for i in 0..100_000u32 {
        // Towards the ball, and away from it by the cosine law of the plane: sin θ uniform.
        let spread = (radius / lamp.distance(center)).asin() * (2.0 * uniform(seed, 33, i, 0) - 1.0);
        let way = DVec2::from_angle(spread).rotate((center - lamp).normalize());
        let Some(t) = meets(lamp.extend(0.0), way.extend(0.0), center.extend(0.0), radius) else { continue };
        let (p, n) = (lamp + way * t, (lamp + way * t - center) / radius);
        let out = DVec2::from_angle((2.0 * uniform(seed, 33, i, 1) - 1.0).asin()).rotate(n);
        let found = out.dot(eye - p) > 0.0 && out.perp_dot(eye - p).abs() < pupil;
        if found {
            d = d.ray(Light::Incident, lamp, p).ray(Light::Reflected, p, eye);
            first = Some(i + 1);
            break;
        }
        if i < DRAWN {
            let reach = exit(p, out, dvec2(-3.45, -1.6), dvec2(4.05, 2.45)).min(1.9);
            d = d.thin(&[lamp, p]).ray(Light::Shadow, p, p + out * reach);
        }
    }
    let first = first.map_or("none of 100 000".to_string(), |n| format!("number {n}"));
    let d = d
        .lamp(lamp)
        .word("lamp")
        .eye(eye, DVec2::NEG_X)
        .word("eye")
        .title(&format!("Forwards photons are wasted: {first} is the first to find the eye"))
        .subtitle(&format!(
            "plane scene, pupil 0.1 wide at 3.2 from the ball; the first {DRAWN} photons are \
             drawn; seed {seed}"
        ))
        .alt(
            "A lamp throws photons at a ball, which scatters them in all directions, drawn as dashed grey \
             arrows. One photon, drawn in colour, leaves the ball \
              towards the eye on the right.",
        );
    told(
        d,
        "After B, figure 3.3, from traced photons, all of them aimed at the ball already: many leave it, \
             one arrives.",
    )
}

/// How far from inside a box its edge is.
fn exit(p: DVec2, way: DVec2, min: DVec2, max: DVec2) -> f64 {
    let to = |p: f64, w: f64, a: f64, b: f64| {
        if w > 0.0 {
            (b - p) / w
        } else if w < 0.0 {
            (a - p) / w
        } else {
            f64::INFINITY
        }
    };
    to(p.x, way.x, min.x, max.x).min(to(p.y, way.y, min.y, max.y)).max(0.0)
}

const ROOM: [DVec2; 2] = [DVec2::new(0.0, 0.0), DVec2::new(8.0, 5.0)];
const BALL: (DVec2, f64) = (DVec2::new(4.6, 1.6), 0.45);
const EYE: (DVec2, f64) = (DVec2::new(0.9, 0.6), 0.12);

/// A photon's path through the room: the right wall is a mirror, the ball shines like one, the rest absorbs.
/// Its signature names what it met: `b` ball, `m` mirror, `f` floor, `c` ceiling, `w` wall, `e` eye.
fn follow(start: DVec2, angle: f64) -> (String, Vec<DVec2>) {
    let (mut p, mut way) = (start, DVec2::from_angle(angle));
    let (mut met, mut path) = (String::new(), vec![start]);
    for _ in 0..4 {
        let ball = meets(p.extend(0.0), way.extend(0.0), BALL.0.extend(0.0), BALL.1)
            .filter(|t| *t > 1.0e-9 * BALL.1);
        let wall = exit(p, way, ROOM[0], ROOM[1]);
        let t = ball.map_or(wall, |t| t.min(wall));
        let ahead = (EYE.0 - p).dot(way);
        if !met.is_empty() && ahead > 0.0 && ahead < t && way.perp_dot(EYE.0 - p).abs() < EYE.1 {
            path.push(p + way * ahead);
            return (met + "e", path);
        }
        p += way * t;
        path.push(p);
        let n = if ball.is_some_and(|b| b <= wall) { (p - BALL.0) / BALL.1 } else { DVec2::NEG_X };
        let sign = if n != DVec2::NEG_X {
            'b'
        } else if p.x > ROOM[1].x - 1.0e-9 {
            'm'
        } else if p.y < 1.0e-9 {
            'f'
        } else if p.y > ROOM[1].y - 1.0e-9 {
            'c'
        } else {
            'w'
        };
        met.push(sign);
        if sign != 'b' && sign != 'm' {
            break;
        }
        way -= n * (2.0 * way.dot(n));
    }
    (met, path)
}

/// A, illustration 53: the complicated ways of photons.
pub fn ways_of_photons(photons: u32) -> Figure {
    let lamp = dvec2(7.2, 4.7);
    let kinds = [
        ("A", "w", Light::Shadow),
        ("B", "mbe", Light::Incident),
        ("C", "bme", Light::Reflected),
        ("D", "be", Light::Transmitted),
        ("E", "bf", Light::Other),
    ];
    let mut ways: Vec<Vec<Vec<DVec2>>> = vec![Vec::new(); kinds.len()];
    let mut arrived = 0;
    for i in 0..photons {
        let (met, path) = follow(lamp, TAU * f64::from(i) / f64::from(photons) - PI);
        arrived += usize::from(met.ends_with('e'));
        if let Some(k) = kinds.iter().position(|kind| kind.1 == met) {
            ways[k].push(path);
        }
    }
    let [min, max] = ROOM;
    let mut d = Diagram::new(dvec2(-0.25, -0.15), dvec2(8.95, 5.15))
        .polygon(&[min, dvec2(max.x, min.y), max, dvec2(min.x, max.y)])
        .circle(BALL.0, BALL.1)
        .word("ball");
    for ((name, met, light), paths) in kinds.iter().zip(&ways) {
        // Of those that find the eye, B comes in at the top of it, C and D at the bottom.
        let end = |path: &Vec<DVec2>| path.last().map_or(0.0, |p| if *name == "B" { p.y } else { -p.y });
        let ending = paths.iter().max_by(|a, b| end(a).total_cmp(&end(b)));
        let Some(path) = (if met.ends_with('e') { ending } else { paths.get(paths.len() / 2) }) else {
            continue;
        };
        for (i, leg) in path.windows(2).enumerate() {
            d = d.ray(*light, leg[0], leg[1]);
            // The second leg tells the ways apart.
            d = if i == 1 || path.len() == 2 { d.name(name) } else { d };
        }
    }
    d = d
        .path(Light::Incident, &[dvec2(max.x, 0.02), dvec2(max.x, max.y - 0.02)])
        .note(dvec2(8.47, 2.3), "mirror");
    d = d.lamp(lamp).word("lamp").eye(EYE.0, DVec2::X).word("eye");
    d = d.curve(&[EYE.0 + dvec2(0.6, -0.45), EYE.0 + dvec2(0.6, 0.45)]).word("image plane");
    let share = f64::from(arrived as u32) / f64::from(photons) * 100.0;
    let d = d
        .title(&format!("Photons B, C and D find the eye, A and E do not: {share:.2} % of all arrive"))
        .subtitle(&format!(
            "{} photons from the lamp in a plane room, evenly spread over all angles; mirror \
             and ball reflect, the rest absorbs",
            grouped(photons.into())
        ))
        .alt(
            "A room in section with a lamp under the ceiling, a shining ball, a mirror on the right wall \
             and an eye on the left. Photon A ends at a wall. B goes by mirror and \
              ball to the eye, C by ball and mirror, D by the ball alone. E is thrown by the ball to the \
              floor.",
        );
    told(d, "After A, illustration 53, each way picked from the traced photons of its kind.")
}

/// Photons of a bare bulb on the axis that pass each of the [`HOLES`].
pub fn through(seed: u64) -> [u64; HOLES.len()] {
    let mut counted = [0; HOLES.len()];
    for i in 0..PHOTONS {
        let w = uniform_sphere(point2(seed, u32::MAX, i)); // a run of its own
        let off_axis = DISTANCE * w.xy().length() / w.z;
        for (count, hole) in counted.iter_mut().zip(HOLES) {
            *count += u64::from(w.z > 0.0 && off_axis <= 0.5 * hole);
        }
    }
    counted
}
