//! Diagrams of lesson 01: light, holes and eyes.

use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::kit::figure::{Diagram, Figure, Light, Space};
use lightbench::sample::uniform;
use lightbench::scene::{Camera, FieldOfView, obscura_from_camera};
use std::f64::consts::{PI, TAU};

fn told(diagram: Diagram, caption: &str) -> Figure {
    Figure::from(diagram).caption(caption)
}

/// The letter that shows a mirror image for what it is.
const LETTER: [[(f64, f64); 2]; 3] =
    [[(-0.4, -0.8), (-0.4, 0.8)], [(-0.4, 0.8), (0.55, 0.8)], [(-0.4, 0.05), (0.3, 0.05)]];

/// A, illustration 49; B, figure 3.1; C, figure 1: the box.
pub fn the_box() -> Figure {
    let (space, depth) = (Space::axonometric(142.0, 20.0), 1.7);
    let film = |p: DVec3| obscura_from_camera(p, depth).expect("in front of the hole").extend(depth);
    let letter = LETTER.map(|line| line.map(|(x, y)| dvec3(x, y, -2.7)));
    let (min, max) = (dvec3(-0.8, -0.75, 0.0), dvec3(0.8, 0.75, depth));
    let mut d = Diagram::fitted()
        .title("A closed box with a hole in one face draws the world on the opposite face")
        .subtitle(&format!("film {depth} behind the hole, letter 2.7 before it: its image is {:.2} times as large", depth / 2.7))
        .alt("A closed box seen from outside. Light from a letter F in front of it passes a small hole in the middle of the front \
              face and draws a smaller letter, upside down and mirrored, on the film at the back.")
        .solid_box(&space, min, max);
    let back =
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| dvec3(0.68 * x, 0.63 * y, depth));
    d = d.region(Light::Reflected, &back.map(|p| space.at(p)));
    for [a, b] in letter {
        d = d.path(Light::Incident, &[space.at(a), space.at(b)]);
        d = d.path(Light::Incident, &[space.at(film(a)), space.at(film(b))]);
    }
    for p in [letter[0][0], letter[0][1], letter[1][1]] {
        d = d.hidden(&[space.at(p), space.at(film(p))]);
    }
    d = d.point(space.at(DVec3::ZERO)).word("hole").note(space.at(dvec3(-0.2, -1.1, -2.7)), "object");
    d = d.note(space.at(dvec3(0.0, 1.0, depth)), "film").note(space.at(dvec3(0.8, -1.0, 0.9)), "closed box");
    told(
        d,
        "After A, illustration 49, B, figure 3.1, and C, figure 1: the pinhole camera, or camera obscura.",
    )
}

/// A, illustration 50: what the hole keeps out.
pub fn what_the_hole_keeps() -> Figure {
    let points = [-1.4, -0.7, 0.0, 0.7, 1.4];
    let (wall, film, hole) = (3.0, 4.5, 0.12);
    let mut passed = 0;
    let mut d = Diagram::new(dvec2(-0.6, -2.3), dvec2(11.3, 2.15));
    for (shift, has_wall) in [(0.0, false), (6.0, true)] {
        let at = |x: f64, y: f64| dvec2(x + shift, y);
        for y in points {
            for image in [-0.7, -0.35, 0.0, 0.35, 0.7] {
                let crossing = y + (image - y) * wall / film;
                match has_wall {
                    false => d = d.path(Light::Shadow, &[at(0.0, y), at(film, image)]),
                    true if crossing.abs() < hole => {
                        passed += 1;
                        d = d.ray(Light::Incident, at(0.0, y), at(film, image));
                    }
                    true => d = d.path(Light::Shadow, &[at(0.0, y), at(wall, crossing)]),
                }
            }
            d = d.spot(Light::Incident, at(0.0, y));
        }
        if has_wall {
            d = d.curve(&[at(wall, hole), at(wall, 1.7)]).curve(&[at(wall, -1.7), at(wall, -hole)]);
            d = d.note(at(wall, -1.95), "hole");
        }
        d = d
            .curve(&[at(film, -1.1), at(film, 1.1)])
            .note(at(film, -1.4), "film")
            .note(at(0.0, -1.8), "scene");
        d = d.note(at(2.2, 1.95), if has_wall { "the hole chooses" } else { "bare film: white everywhere" });
    }
    let d = d.title(&format!("Of 25 lines of light the hole lets {passed} through: one to each point of the film"))
        .subtitle("5 points of the scene, 5 of the film; what ends at the wall is dashed")
        .alt("Left: every point of the scene sends light to every point of a bare film. Right: a wall with a small hole lets only one \
              line pass to each film point, so that the scene's points lie in reversed order on the film.");
    told(
        d,
        "After A, illustration 50. A bare film turns white at once; a wider hole lets more lines through, brighter and less sharp.",
    )
}

/// C, figure 2: why the picture is upside down.
pub fn inverts() -> Figure {
    let (height, distance, depth) = (1.5, 3.0, 1.5);
    let image = |y: f64| obscura_from_camera(dvec3(0.0, y, -distance), depth).expect("before the hole").y;
    let mut d = Diagram::new(dvec2(-3.6, -1.55), dvec2(2.4, 1.95))
        .title(&format!("Straight lines through one point turn the picture over: A′ = −({depth}/{distance}) A = {}", super::spaces::plain(image(height))))
        .subtitle("side view; object 3 m before the hole, film 1.5 m behind it")
        .alt("Side view of a camera obscura: an arrow from B on the axis up to A, 3 metres before the hole; lines through the hole lead to \
              its image, half as tall and pointing down from B prime to A prime, on the film.");
    let (left, right) = (dvec2(-distance, 0.0), dvec2(depth, 0.0));
    d = d.polygon(&[dvec2(0.0, -1.1), dvec2(depth, -1.1), dvec2(depth, 1.1), dvec2(0.0, 1.1)]);
    for y in [0.0, 0.5, 1.0, 1.5] {
        d = d.ray(Light::Incident, dvec2(-distance, y), dvec2(depth, image(y)));
    }
    d = d.ray(Light::Transmitted, left, left + DVec2::Y * height).ray(
        Light::Reflected,
        right,
        right + DVec2::Y * image(height),
    );
    d = d
        .point(left)
        .name("B")
        .point(left + DVec2::Y * height)
        .name("A")
        .point(right)
        .name("B′")
        .point(right + DVec2::Y * image(height))
        .name("A′");
    d = d.spot(Light::Other, DVec2::ZERO).word("hole");
    d = d
        .dimension(left, DVec2::ZERO, -150.0)
        .word("distance 3 m")
        .dimension(dvec2(0.0, -1.1), dvec2(depth, -1.1), -36.0)
        .word("depth 1.5 m");
    told(d, "After C, figure 2, the diagram; the picture itself is the next figure.")
}

/// A, illustration 51; B, figure 3.2; C, figure 3: the film moved before the hole.
pub fn window() -> Figure {
    let space = Space::axonometric(60.0, 18.0);
    let (near, far) = (1.5, 3.6);
    let corner = |x: f64, y: f64, z: f64| dvec3(0.62 * x, 0.5 * y, -1.0) * z;
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let base = corners.map(|(x, y)| corner(x, y, far));
    let letter = LETTER.map(|line| line.map(|(x, y)| dvec3(1.5 * x, 1.5 * y, -3.1)));
    let mut d = Diagram::fitted()
        .title("Move the film in front of the hole, call the hole an eye: the picture stands upright")
        .subtitle("the pyramid of view holds what can be seen; every useful ray ends in its apex")
        .alt("An eye on the left looks through an upright window ruled into pixels at a letter F on the right. Four edges of a pyramid lead from \
              the eye through the window's corners. Lines from the letter to the eye draw an upright, smaller F on the window.");
    let place = corners.map(|(x, y)| corner(x, y, near));
    d = d.pixel_grid(&space, place[3], place[2] - place[3], place[0] - place[3], 8, 6).pyramid(
        &space,
        DVec3::ZERO,
        &base,
    );
    d = d.hidden(&[base[0], base[1], base[2], base[3], base[0]].map(|p| space.at(p)));
    for [a, b] in letter {
        let seen = |p: DVec3| space.at(p * (near / -p.z));
        d = d.path(Light::Incident, &[space.at(a), space.at(b)]).path(Light::Incident, &[seen(a), seen(b)]);
    }
    for p in [letter[0][0], letter[0][1], letter[1][1]] {
        d = d.ray(Light::Reflected, space.at(p), space.at(p * 0.03));
    }
    d = d.eye(space.at(DVec3::ZERO), DVec2::X).word("eye");
    d = d
        .note(space.at(dvec3(0.0, -0.95, -near)), "window")
        .note(space.at(dvec3(0.0, -2.05, -far)), "pyramid of view");
    told(
        d,
        "After A, illustration 51, B, figure 3.2, and C, figure 3, the window model: the same lines as in the box, the same picture turned by 180°.",
    )
}

/// Where a line first meets a ball, in lengths of its direction; lesson 02 does it with care.
fn meets(origin: DVec3, direction: DVec3, center: DVec3, radius: f64) -> Option<f64> {
    let (f, d) = (origin - center, direction.normalize());
    let along = -f.dot(d);
    let across2 = (f + d * along).length_squared();
    let t = along - (radius * radius - across2).max(0.0).sqrt();
    (across2 <= radius * radius && t > 0.0).then_some(t / direction.length())
}

/// C, figure 4; E, slide 65: a ray through the centre of every pixel.
pub fn through_the_centres() -> Figure {
    let (space, columns, rows) = (Space::axonometric(64.0, 14.0), 8usize, 6usize);
    let fov = FieldOfView::Vertical(52f64.to_radians());
    let camera = Camera::new(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, fov).expect("a camera in its place");
    let (center, radius) = (dvec3(0.2, 0.05, -3.6), 0.85);
    let on_plane = |x: f64, y: f64| {
        let ray = camera.ray(dvec2(x, y), columns, rows);
        ray.at(1.5 / -ray.direction.z)
    };
    let (o, u, v) = (on_plane(0.0, 0.0), on_plane(columns as f64, 0.0), on_plane(0.0, rows as f64));
    let mut hits = 0;
    let mut d = Diagram::fitted().ball(&space, center, radius, DVec3::Y);
    d = d.pixel_grid(&space, o, u - o, v - o, columns as u32, rows as u32);
    let (mut tints, mut rays) = (Vec::new(), Vec::new());
    for (i, j) in (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))) {
        let (x, y) = (i as f64, j as f64);
        let p = on_plane(x + 0.5, y + 0.5);
        let hit = meets(DVec3::ZERO, p, center, radius);
        rays.push((p, hit));
        if hit.is_some() {
            hits += 1;
            tints.push([
                on_plane(x, y),
                on_plane(x + 1.0, y),
                on_plane(x + 1.0, y + 1.0),
                on_plane(x, y + 1.0),
            ]);
        }
    }
    for tint in tints {
        d = d.region(Light::Reflected, &tint.map(|p| space.at(p)));
    }
    for (p, hit) in rays {
        d = match hit {
            Some(t) => d
                .path(Light::Incident, &[space.at(DVec3::ZERO), space.at(p * t)])
                .spot(Light::Incident, space.at(p * t)),
            None => d.spot(Light::Shadow, space.at(p)),
        };
    }
    d = d.eye(space.at(DVec3::ZERO), DVec2::X).word("eye").note(space.at(dvec3(0.0, -1.05, -1.5)), "pixels");
    let d = d.title(&format!("One ray through the centre of each pixel: {hits} of {} find the ball", columns * rows))
        .subtitle(&format!("{columns} × {rows} pixels; a pixel takes the colour of what its ray meets first"))
        .alt("An eye sends a ray through the centre of every pixel of a grid. Those that meet a ball are drawn up to the ball, and their pixels \
              are tinted; the others are grey dots.");
    told(
        d,
        "After C, figure 4, and E, slide 65. Pixels are dealt with one after the other; each makes its primary ray.",
    )
}

/// A, illustration 52: a pixel, its part of the film, its rays.
pub fn one_pixel(seed: u64) -> Figure {
    let space = Space::axonometric(60.0, 18.0);
    let at = |x: f64, y: f64, z: f64| dvec3((x - 3.0) * 0.26, (2.0 - y) * 0.26, -1.0) * z;
    let (near, far, pixel) = (1.6, 4.2, dvec2(3.0, 1.0));
    let square = |z: f64| {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| at(pixel.x + x, pixel.y + y, z))
    };
    let mut d = Diagram::fitted()
        .title("A pixel is a piece of film, and owns all the rays through it: its colour is their mean")
        .subtitle(&format!("6 × 4 pixels; 8 of the rays of the pixel in column 3, row 1, at random, seed {seed}"))
        .alt("A film of 6 by 4 pixels before an eye. One pixel is tinted; a bundle of eight rays from the eye through random points of it \
              spreads to a larger tinted patch of the scene.");
    d = d.pixel_grid(
        &space,
        at(0.0, 0.0, near),
        at(6.0, 0.0, near) - at(0.0, 0.0, near),
        at(0.0, 4.0, near) - at(0.0, 0.0, near),
        6,
        4,
    );
    d = d
        .region(Light::Reflected, &square(near).map(|p| space.at(p)))
        .region(Light::Reflected, &square(far).map(|p| space.at(p)));
    d = d.pyramid(&space, DVec3::ZERO, &square(far));
    for i in 0..8u32 {
        // A jittered 4 × 2 grid: spread like the real thing, and legible.
        let cell = dvec2(f64::from(i % 4) / 4.0, f64::from(i / 4) / 2.0);
        let p = pixel + cell + dvec2(uniform(seed, 52, i, 0) / 4.0, uniform(seed, 52, i, 1) / 2.0);
        d = d.ray(Light::Incident, space.at(DVec3::ZERO), space.at(at(p.x, p.y, far)));
    }
    d = d.eye(space.at(DVec3::ZERO), DVec2::X).word("eye");
    d = d
        .note(space.at(at(1.0, 5.4, near)), "film of 6 × 4 pixels")
        .note(space.at(at(3.5, 3.0, far)), "what the pixel sees");
    told(d, "After A, illustration 52: pixel, region of film, rays of light.")
}

/// B, figures 3.4 and 5.1: a ray hits or misses.
pub fn hit_or_miss() -> Figure {
    let (center, radius, plane, rows) = (dvec3(5.0, 0.35, 0.0), 0.95, 1.5, 7);
    let mut hits = 0;
    let mut d =
        Diagram::new(dvec2(-0.9, -2.05), dvec2(7.2, 2.15)).circle(center.truncate(), radius).word("ball");
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
    d = d
        .curve(&[dvec2(plane, -1.05), dvec2(plane, 1.05)])
        .note(dvec2(plane, -1.35), "image plane")
        .eye(DVec2::ZERO, DVec2::X)
        .word("eye");
    let d = d.title(&format!("Backwards every ray tells its pixel something: {hits} of {rows} hit, {} miss", rows - hits))
        .subtitle("side view; one ray from the eye through each pixel's centre; a miss is an answer too: background")
        .alt("Side view: an eye sends seven rays through the pixels of an image plane. Some hit a ball, where they end in a dot, and their pixels \
              are marked in its colour; the others, dashed, pass by.");
    told(
        d,
        "After B, figures 3.4 and 5.1: primary rays hit or miss; a pixel takes the colour of the point that its ray meets.",
    )
}

/// B, figure 3.3: photons scattered by a ball, and the first that finds the eye.
pub fn forward(seed: u64) -> Figure {
    let (lamp, eye, pupil) = (dvec2(-2.6, 2.1), dvec2(3.2, 1.0), 0.05);
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
        if i < 28 {
            let reach = exit(p, out, dvec2(-3.45, -1.6), dvec2(4.05, 2.45)).min(1.9);
            d = d.path(Light::Shadow, &[lamp, p]).ray(Light::Shadow, p, p + out * reach);
        }
    }
    let first = first.map_or("no".to_string(), |n| format!("{n}th"));
    let d = d.lamp(lamp).word("lamp").eye(eye, DVec2::NEG_X).word("eye")
        .title(&format!("Forwards nearly all photons are wasted: the {first} is the first to find the eye"))
        .subtitle(&format!("plane scene, pupil 0.1 wide at 3.2 from the ball; the first 28 photons are drawn dashed; seed {seed}"))
        .alt("A lamp throws photons at a ball, which scatters them in all directions, drawn as dashed grey arrows. One photon, drawn in colour, leaves the ball \
              towards the eye on the right.");
    told(
        d,
        "After B, figure 3.3, from traced photons, all of them aimed at the ball already: many leave it, one arrives.",
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

const ROOM: [DVec2; 2] = [DVec2::new(0.0, 0.0), DVec2::new(8.0, 4.5)];
const BALL: (DVec2, f64) = (DVec2::new(4.6, 1.7), 0.85);
const EYE: (DVec2, f64) = (DVec2::new(0.9, 2.3), 0.08);

/// A photon's path through the room: the right wall is a mirror, the ball shines like one, the rest absorbs.
/// Its signature names what it met: `b` ball, `m` mirror, `f` floor, `w` wall, `e` eye.
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
        } else {
            'w'
        };
        met.push(sign);
        if sign == 'f' || sign == 'w' {
            break;
        }
        way -= n * (2.0 * way.dot(n));
    }
    (met, path)
}

/// A, illustration 53: the complicated ways of photons.
pub fn ways_of_photons(photons: u32) -> Figure {
    let lamp = dvec2(3.4, 4.1);
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
    let mut d = Diagram::new(dvec2(-0.25, -0.35), dvec2(8.95, 4.75))
        .polygon(&[min, dvec2(max.x, min.y), max, dvec2(min.x, max.y)])
        .circle(BALL.0, BALL.1)
        .word("ball");
    for ((name, _, light), paths) in kinds.iter().zip(&ways) {
        let Some(path) = paths.get(paths.len() / 2) else { continue };
        for leg in path.windows(2) {
            d = d.ray(*light, leg[0], leg[1]);
        }
        // The name stands at the middle of the leg that tells it from the others.
        let leg = if path.len() > 2 && *name != "D" { 1 } else { path.len() - 2 };
        d = d
            .path(*light, &[path[leg].lerp(path[leg + 1], 0.45), path[leg].lerp(path[leg + 1], 0.55)])
            .name(name);
    }
    d = d
        .path(Light::Incident, &[dvec2(max.x, 0.02), dvec2(max.x, max.y - 0.02)])
        .note(dvec2(8.47, 2.3), "mirror");
    d = d.lamp(lamp).word("lamp").eye(EYE.0, DVec2::X).word("eye");
    d = d.curve(&[EYE.0 + dvec2(0.6, -0.45), EYE.0 + dvec2(0.6, 0.45)]).word("image plane");
    let share = f64::from(arrived as u32) / f64::from(photons) * 100.0;
    let d = d.title(&format!("Photons B, C and D find the eye, A and E do not: {share:.2} % of all arrive"))
        .subtitle(&format!("{photons} photons from the lamp in a plane room, evenly spread over all angles; mirror and ball reflect, the rest absorbs"))
        .alt("A room in section with a lamp under the ceiling, a shining ball, a mirror on the right wall and an eye on the left. Photon A ends at a wall. B goes by mirror and \
              ball to the eye, C by ball and mirror, D by the ball alone. E is thrown by the ball to the floor.");
    told(d, "After A, illustration 53, each way picked from the traced photons of its kind.")
}
