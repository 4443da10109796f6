//! Diagrams of lesson 01: boxes, windows and eyes.

use super::photons::meets;
use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::sample::uniform;
use lightbench::scene::{Camera, FieldOfView, obscura_from_camera};
use lightbench_kit::figure::{Diagram, Figure, Light, Space};

pub fn told(diagram: Diagram, caption: &str) -> Figure {
    Figure::from(diagram).caption(caption)
}

/// The letter that shows a mirror image for what it is.
const LETTER: [[(f64, f64); 2]; 3] =
    [[(-0.4, -0.8), (-0.4, 0.8)], [(-0.4, 0.8), (0.55, 0.8)], [(-0.4, 0.05), (0.3, 0.05)]];

/// A, illustration 49; B, figure 3.1; C, figure 1: the box.
pub fn the_box() -> Figure {
    let (space, depth) = (Space::axonometric(118.0, 16.0), 1.7);
    let film = |p: DVec3| obscura_from_camera(p, depth).expect("in front of the hole").extend(depth);
    let letter = LETTER.map(|line| line.map(|(x, y)| dvec3(x, y, -2.7)));
    let (min, max) = (dvec3(-0.8, -0.75, 0.0), dvec3(0.8, 0.75, depth));
    let mut d = Diagram::fitted()
        .title("A hole in a closed box draws the world on its back wall")
        .subtitle(&format!(
            "film {depth} behind the hole, letter 2.7 before it: its image is {:.2} times as \
             large",
            depth / 2.7
        ))
        .alt(
            "A closed box seen from outside. Light from a letter F in front of it passes a small hole in \
             the middle of the front \
              face and draws a smaller letter, upside down and mirrored, on the film at the back.",
        );
    let back =
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| dvec3(0.68 * x, 0.63 * y, depth));
    d = glass_box(d.region(Light::Reflected, &back.map(|p| space.at(p))), &space, min, max);
    for [a, b] in letter {
        d = d.path(Light::Transmitted, &[space.at(a), space.at(b)]);
        d = d.path(Light::Reflected, &[space.at(film(a)), space.at(film(b))]);
    }
    for p in [letter[0][0], letter[0][1], letter[1][1]] {
        d = d.ray(Light::Incident, space.at(p), space.at(film(p)));
    }
    d = d.point(space.at(DVec3::ZERO)).note(space.at(dvec3(0.0, -0.95, 0.0)) + dvec2(0.1, 0.0), "hole");
    d = d.note(space.at(dvec3(0.0, -1.05, -2.7)), "object").note(space.at(dvec3(0.0, 1.0, depth)), "film");
    d = d.hidden(&[space.at(dvec3(0.0, -0.82, 0.0)) + dvec2(0.1, 0.0), space.at(dvec3(0.0, -0.05, 0.0))]);
    told(
        d,
        "After A, illustration 49, B, figure 3.1, and C, figure 1: the pinhole camera, or camera obscura.",
    )
}

/// The edges of a box that lets us look inside: those at its farthest corner dashed.
fn glass_box(mut d: Diagram, space: &Space, min: DVec3, max: DVec3) -> Diagram {
    let far = dvec3(min.x, min.y, max.z);
    for axis in 0..3 {
        for (i, j) in [(false, false), (false, true), (true, false), (true, true)] {
            let (mut a, mut b) = (min, max);
            for (k, high) in [((axis + 1) % 3, i), ((axis + 2) % 3, j)] {
                a[k] = if high { max[k] } else { min[k] };
                b[k] = a[k];
            }
            let edge = [space.at(a), space.at(b)];
            d = if a == far || b == far { d.hidden(&edge) } else { d.curve(&edge) };
        }
    }
    d
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
    let d = d
        .title(&format!(
            "Of 25 lines of light the hole lets {passed} through: one to each point of the \
         film"
        ))
        .subtitle("5 points of the scene, 5 of the film; what ends at the wall is dashed")
        .alt(
            "Left: every point of the scene sends light to every point of a bare film. Right: a wall with \
             a small hole lets only one \
              line pass to each film point, so that the scene's points lie in reversed order on the film.",
        );
    told(
        d,
        "After A, illustration 50. A bare film turns white at once; a wider hole lets more lines through, \
             brighter and less sharp.",
    )
}

/// C, figure 2: why the picture is upside down.
pub fn inverts() -> Figure {
    let (height, distance, depth) = (1.5, 3.0, 1.5);
    let image = |y: f64| obscura_from_camera(dvec3(0.0, y, -distance), depth).expect("before the hole").y;
    let mut d = Diagram::new(dvec2(-3.6, -1.55), dvec2(2.4, 1.95))
        .title(&format!(
            "Light runs straight: the image of A, at {height} m, lies at {} \
             m",
            super::spaces::plain(image(height))
        ))
        .subtitle("side view; object 3 m before the hole, film 1.5 m behind it")
        .alt(
            "Side view of a camera obscura: an arrow from B on the axis up to A, 3 metres before the hole; \
             lines through the hole lead to \
              its image, half as tall and pointing down from B prime to A prime, on the film.",
        );
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
    d = d.spot(Light::Other, DVec2::ZERO).word("hole").note(dvec2(depth, 1.25), "film");
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
        .title("Film before the hole, now an eye: the picture stands upright")
        .subtitle("the pyramid of view holds what can be seen; every useful ray ends in its apex")
        .alt(
            "An eye on the left looks through an upright window ruled into pixels at a letter F on the \
             right. Four edges of a pyramid lead from \
              the eye through the window's corners. Lines from the letter to the eye draw an upright, \
              smaller F on the window.",
        );
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
        .note(space.at(place[3]) + dvec2(-0.45, 0.1), "window")
        .note(space.at(base[1]) - dvec2(1.3, 0.0), "pyramid of view");
    told(
        d,
        "After A, illustration 51, B, figure 3.2, and C, figure 3, the window model: the same lines as in \
             the box, the same picture turned by 180°.",
    )
}

/// C, figure 4; E, slide 65: a ray through the centre of every pixel.
pub fn through_the_centres() -> Figure {
    let (space, columns, rows) = (Space::axonometric(60.0, 14.0), 8usize, 6usize);
    let fov = FieldOfView::Vertical(52f64.to_radians());
    let camera = Camera::new(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, fov).expect("a camera in its place");
    let (center, radius) = (dvec3(0.15, 0.05, -3.2), 0.9);
    let on_plane = |x: f64, y: f64| {
        let ray = camera.ray(dvec2(x, y), columns, rows);
        ray.at(1.5 / -ray.direction.z)
    };
    let (o, u, v) = (on_plane(0.0, 0.0), on_plane(columns as f64, 0.0), on_plane(0.0, rows as f64));
    let mut hits = 0;
    let mut d = Diagram::fitted().circle(space.at(center), radius).word("ball");
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
    let d = d
        .title(&format!(
            "One ray through the centre of each pixel: {hits} of {} find the \
         ball",
            columns * rows
        ))
        .subtitle(&format!("{columns} × {rows} pixels; a pixel takes the colour of what its ray meets first"))
        .alt(
            "An eye sends a ray through the centre of every pixel of a grid. Those that meet a ball are \
             drawn up to the ball, and their pixels \
              are tinted; the others are grey dots.",
        );
    told(
        d,
        "After C, figure 4, and E, slide 65. Pixels are dealt with one after the other; each makes its \
             primary ray.",
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
        .title("A pixel owns all rays through its piece of film")
        .subtitle(&format!(
            "6 × 4 pixels; its colour is their mean; 8 of those of the pixel in column 3, \
             row 1, at random, seed {seed}"
        ))
        .alt(
            "A film of 6 by 4 pixels before an eye. One pixel is tinted; a bundle of eight rays from the \
             eye through random points of it \
              spreads to a larger tinted patch of the scene.",
        );
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
        .note(space.at(at(3.5, 2.3, far)), "what the pixel sees");
    told(d, "After A, illustration 52: pixel, region of film, rays of light.")
}
