//! Diagrams of lesson 01: from a pixel to a ray.

use super::obscura::told;
use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::scene::{Camera, FieldOfView, camera_from_screen, ndc_from_raster, screen_from_ndc};
use lightbench_kit::figure::{Diagram, Figure, Light, Space};

/// A number as short as it is: 0.75, −1.2, 1.
pub fn plain(x: f64) -> String {
    let text = format!("{:.3}", x.abs());
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if x < 0.0 && text != "0" { format!("−{text}") } else { text.to_string() }
}

pub fn pair(p: DVec2) -> String {
    format!("({}, {})", plain(p.x), plain(p.y))
}

/// One pixel of B's picture of 7 × 5, from the raster to a ray in the world, in words.
pub fn of_one_pixel() -> String {
    let (size, fov) = (dvec2(7.0, 5.0), FieldOfView::Vertical(90f64.to_radians()));
    let raster = dvec2(0.5, 0.5); // the centre of the upper left pixel
    let ndc = ndc_from_raster(raster, size);
    let screen = screen_from_ndc(ndc, size.x / size.y, fov);
    let p = camera_from_screen(screen);
    let triple = |v: DVec3| format!("({}, {}, {})", plain(v.x), plain(v.y), plain(v.z));
    format!(
        "A picture of 7 × 5 pixels, 90° at distance 1, aspect 7/5 = {}. The centre of its first pixel is\n  \
             {} in \
         raster space,\n  {} in NDC,\n  {} on the screen, after aspect and tan 45° = 1,\n  {} in camera \
         space,\nand its ray leaves the origin along {}.",
        plain(size.x / size.y),
        pair(raster),
        pair(ndc),
        pair(screen),
        triple(p),
        triple(p.normalize())
    )
}

/// A grid of pixels on paper, the raster's corner (0,0) at its upper left, with one pixel tinted.
fn grid(mut d: Diagram, upper_left: DVec2, size: DVec2, raster: DVec2, pixel: DVec2) -> Diagram {
    let at = |p: DVec2| upper_left + dvec2(p.x, -p.y) * (size / raster);
    let corners = |a: DVec2, b: DVec2| [at(a), at(dvec2(b.x, a.y)), at(b), at(dvec2(a.x, b.y))];
    d = d.polygon(&corners(DVec2::ZERO, raster)).region(Light::Reflected, &corners(pixel, pixel + 1.0));
    for i in 1..raster.x as usize {
        d = d.thin(&[at(dvec2(i as f64, 0.0)), at(dvec2(i as f64, raster.y))]);
    }
    for j in 1..raster.y as usize {
        d = d.thin(&[at(dvec2(0.0, j as f64)), at(dvec2(raster.x, j as f64))]);
    }
    d.spot(Light::Reflected, at(pixel + 0.5))
}

/// B, figure 5.3: one pixel in raster, NDC and screen space.
pub fn raster_ndc_screen() -> Figure {
    let (size, pixel) = (dvec2(6.0, 6.0), dvec2(4.0, 1.0));
    let ndc = ndc_from_raster(pixel + 0.5, size);
    let screen = screen_from_ndc(ndc, 1.0, FieldOfView::Vertical(90f64.to_radians()));
    let side = DVec2::splat(3.0);
    let mut d = Diagram::new(dvec2(-0.75, -1.15), dvec2(12.6, 4.25))
        .title(&format!("One pixel, three names: {} → {} → {}", pair(pixel + 0.5), pair(ndc), pair(screen)))
        .subtitle(
            "6 × 6 pixels; the centre of column 4, row 1, counted from 0 at the upper left; aspect 1, \
             90°",
        )
        .alt(
            "Three square grids of 6 by 6 pixels side by side, joined by arrows. The same pixel, in column \
             4 and row 1, \
              is marked in each, with its coordinates in raster, NDC and screen space.",
        );
    let ends = [("0, 0", "6, 6"), ("0, 0", "1, 1"), ("−1, 1", "1, −1")];
    let names = [("raster", pixel + 0.5), ("NDC", ndc), ("screen", screen)];
    for (i, ((name, at), (first, last))) in names.into_iter().zip(ends).enumerate() {
        let corner = dvec2(4.4 * i as f64, 3.0);
        d = grid(d, corner, side, size, pixel);
        d = d.note(corner + dvec2(0.0, 0.28), &format!("({first})"));
        d = d.note(corner + dvec2(3.0, -3.28), &format!("({last})"));
        d = d.note(corner + dvec2(1.5, 0.95), &format!("{name} space"));
        d = d.note(corner + dvec2(1.5, -3.75), &pair(at));
        if i < 2 {
            d = d.ray(Light::Normal, corner + dvec2(3.25, -1.5), corner + dvec2(4.15, -1.5));
            d = d.name(["÷ 6", "2x − 1"][i]).note(corner + dvec2(3.7, -1.9), ["", "1 − 2y"][i]);
        }
    }
    let middle = dvec2(8.8 + 1.5, 1.5);
    d = d.ray(Light::Normal, middle, middle + dvec2(1.85, 0.0)).name_end("x");
    d = d.ray(Light::Normal, middle, middle + dvec2(0.0, 1.85)).name_end("y");
    told(
        d,
        "After B, figure 5.3. Dividing by the picture's size gives NDC in [0,1]; 2x − 1 and 1 − 2y move \
             the origin to the middle and turn y upwards.",
    )
}

/// B, figure 5.4: 7 × 5 pixels, squashed into [−1,1]² and put right by the aspect.
pub fn aspect() -> Figure {
    let (size, pixel) = (dvec2(7.0, 5.0), dvec2(0.0, 0.0));
    let fov = FieldOfView::Vertical(90f64.to_radians());
    let ndc = ndc_from_raster(pixel + 0.5, size);
    let (square, right) = (screen_from_ndc(ndc, 1.0, fov), screen_from_ndc(ndc, size.x / size.y, fov));
    let mut d = Diagram::new(dvec2(-1.5, -1.6), dvec2(4.5, 1.5))
        .title(&format!("The aspect 7/5 = {} makes the pixels square again", plain(size.x / size.y)))
        .subtitle(&format!(
            "7 × 5 pixels, 90° at distance 1; the upper left pixel's centre: {} → \
             {}",
            pair(square),
            pair(right)
        ))
        .alt(
            "Two grids of 7 by 5 pixels. On the left a square from −1 to 1 with pixels that are taller \
             than wide; on \
              the right a rectangle from −1.4 to 1.4 with square pixels.",
        );
    d = grid(d, dvec2(-1.0, 1.0), dvec2(2.0, 2.0), size, pixel);
    d = grid(d, dvec2(1.6, 1.0), dvec2(2.8, 2.0), size, pixel);
    for (middle, half) in [(0.0, 1.0), (3.0, 1.4)] {
        d = d
            .note(dvec2(middle - half, -1.12), &plain(-half))
            .note(dvec2(middle + half, -1.12), &plain(half));
        d = d.note(dvec2(middle, -1.12), "x");
    }
    d = d.note(dvec2(-1.12, 1.0), "1").note(dvec2(-1.15, -1.0), "−1").note(dvec2(-1.12, 0.0), "y");
    d = d.note(dvec2(0.0, 1.14), "[−1, 1]²: a pixel is 2/7 × 2/5");
    d = d.note(dvec2(3.0, 1.14), "x · aspect: a pixel is 2/5 × 2/5");
    d = d.ray(Light::Normal, dvec2(1.1, 0.0), dvec2(1.5, 0.0)).name("× 1.4");
    told(d, "After B, figure 5.4. Without the aspect a picture that is wider than high looks squashed.")
}

/// B, figure 5.5: half the angle, and the image plane at distance 1.
pub fn field_of_view() -> Figure {
    let angles = [60.0f64, 90.0, 120.0];
    let heights = angles.map(|a| (0.5 * a.to_radians()).tan());
    let mut d = Diagram::new(dvec2(-0.75, -2.15), dvec2(3.1, 1.95))
        .title(&format!(
            "‖BC‖ = tan(α/2): {} at 60°, {} at 90°, {} at \
             120°",
            plain(heights[0]),
            plain(heights[1]),
            plain(heights[2])
        ))
        .subtitle("side view; the image plane stands at distance ‖AB‖ = 1")
        .alt(
            "Side view of a camera: an eye at A, the image plane at distance 1 in B, its top C. The half \
             angle at A between \
              AB and AC is α/2. Dashed lines show the fields of 60 and 120 degrees, which end lower and \
              higher.",
        );
    d = d.region(Light::Incident, &[DVec2::ZERO, dvec2(1.0, heights[1]), dvec2(1.0, -heights[1])]);
    for (angle, height) in angles.iter().zip(heights).filter(|(a, _)| **a != 90.0) {
        for sign in [1.0, -1.0] {
            d = d.hidden(&[DVec2::ZERO, dvec2(1.0, sign * height)]);
        }
        d = d.note(dvec2(1.42, height), &format!("{angle}°: {}", plain(height)));
    }
    d = d.curve(&[dvec2(1.0, -1.85), dvec2(1.0, 1.85)]).note(dvec2(1.42, -1.6), "image plane");
    d = d.ray(Light::Incident, DVec2::ZERO, dvec2(1.0, 1.0)).ray(
        Light::Incident,
        DVec2::ZERO,
        dvec2(1.0, -1.0),
    );
    d = d
        .ray(Light::Normal, dvec2(1.0, 0.0), dvec2(2.7, 0.0))
        .name_end("−z")
        .thin(&[DVec2::ZERO, dvec2(1.0, 0.0)]);
    d = d.dimension(dvec2(0.0, -1.9), dvec2(1.0, -1.9), -9.0).word("1");
    d = d
        .eye(DVec2::ZERO, DVec2::X)
        .name("A")
        .point(dvec2(1.0, 0.0))
        .name("B")
        .point(dvec2(1.0, 1.0))
        .name("C");
    d = d.angle_at(DVec2::ZERO, DVec2::X, DVec2::ONE, 120.0).name("α/2");
    d = d.angle_at(DVec2::ZERO, dvec2(1.0, -1.0), DVec2::ONE, 64.0).name("α");
    d = d.right_angle(dvec2(1.0, 0.0), DVec2::NEG_X, DVec2::Y);
    d = d.dimension(dvec2(1.0, 1.0), dvec2(1.0, 0.0), 165.0).word("tan 45° = 1");
    told(
        d,
        "After B, figure 5.5. At 90° the image plane at distance 1 is 2 high; other angles scale every \
             pixel's \
             coordinates by the same tangent, which is what a zoom does.",
    )
}

/// The image plane of a camera as `columns × rows` pixels, ruled on paper.
fn film(d: Diagram, space: &Space, camera: &Camera, at: f64, columns: u32, rows: u32) -> Diagram {
    let (w, h) = (columns as usize, rows as usize);
    let corner = |x: f64, y: f64| {
        let ray = camera.ray(dvec2(x, y), w, h);
        ray.at(at / ray.direction.dot(camera.frame().forward))
    };
    let (o, u, v) = (corner(0.0, 0.0), corner(w as f64, 0.0), corner(0.0, h as f64));
    let edges = [corner(0.0, 0.0), corner(w as f64, 0.0), corner(w as f64, h as f64), corner(0.0, h as f64)];
    d.pixel_grid(space, o, u - o, v - o, columns, rows).pyramid(space, camera.position(), &edges)
}

fn default_camera(angle: f64) -> Camera {
    let fov = FieldOfView::Vertical(f64::to_radians(angle));
    Camera::new(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, fov).expect("a camera in its place")
}

/// B, figure 5.2: the basic camera with 6 × 6 pixels, and the signs of its pixels.
pub fn basic_camera() -> Figure {
    let space = Space::axonometric(58.0, 18.0);
    let camera = default_camera(90.0);
    let mut d = Diagram::new(dvec2(-1.5, -2.25), dvec2(6.95, 2.05))
        .title("The camera looks along −z; pixels left of its axis have x < 0")
        .subtitle("6 × 6 pixels on the image plane z = −1, 90°; the numbers are the pixels' centres")
        .alt(
            "Left: the camera at the origin of the axes x, y, z, with an image plane of 6 by 6 pixels one \
             unit ahead, \
              along minus z. Right: the same plane from the front, the centres of its corner pixels written \
              in.",
        );
    d = film(d, &space, &camera, 1.0, 6, 6).axes(&space, DVec3::ZERO, 1.15);
    d = d.point(space.at(DVec3::ZERO)).name("O");
    d = d.ray(Light::Incident, space.at(DVec3::ZERO), space.at(DVec3::NEG_Z * 2.2)).name_end("−z");
    let (corner, unit) = (dvec2(3.0, 1.5), 0.5);
    d = grid(d, corner, DVec2::splat(6.0 * unit), DVec2::splat(6.0), dvec2(4.0, 1.0));
    let middle = corner + dvec2(3.0, -3.0) * unit;
    d = d.ray(Light::Normal, middle, middle + dvec2(1.8, 0.0)).name_end("x");
    d = d.ray(Light::Normal, middle, middle + dvec2(0.0, 1.8)).name_end("y");
    for (i, j) in [(0, 0), (5, 0), (0, 5), (5, 5), (4, 1)] {
        let raster = dvec2(f64::from(i), f64::from(j)) + 0.5;
        let screen = screen_from_ndc(raster / 6.0, 1.0, camera.field_of_view());
        let at = corner + dvec2(raster.x, -raster.y) * unit;
        let place = match (i, j) {
            (4, 1) => corner + dvec2(3.42, -raster.y * unit),
            (i, 0) => at + dvec2(if i == 0 { -0.1 } else { 0.1 }, 0.45),
            (i, _) => at - dvec2(if i == 0 { 0.1 } else { -0.1 }, 0.45),
        };
        d = d.spot(Light::Reflected, at).note(place, &pair(screen));
    }
    told(d, "After B, figure 5.2. Six columns share the width 2, so the outermost centres lie at ±5/6.")
}

/// B, figure 5.6: the same camera in its place, and moved.
pub fn camera_to_world() -> Figure {
    let space = Space::axonometric(28.0, 24.0);
    let fov = FieldOfView::Vertical(60f64.to_radians());
    let moved = Camera::new(dvec3(3.4, 1.0, 0.6), dvec3(5.4, 0.2, -1.4), DVec3::Y, fov).expect("a camera");
    let camera = default_camera(60.0);
    let raster = dvec2(5.5, 0.5);
    let p = camera_from_screen(screen_from_ndc(ndc_from_raster(raster, dvec2(7.0, 5.0)), 1.4, fov));
    let turned = moved.world_from_camera(p);
    let q = moved.position() + turned;
    let text = |v: DVec3| format!("({:.2}, {:.2}, {:.2})", v.x, v.y, v.z).replace('-', "−");
    let mut d = Diagram::fitted()
        .title("Camera to world turns P and carries it along: the ray is O′P′")
        .subtitle(&format!(
            "P = {} in camera space → P′ = {} in the world, O′ = \
             {}",
            text(p),
            text(q),
            text(moved.position())
        ))
        .alt(
            "Two cameras with their image planes of 7 by 5 pixels: one at the origin that looks along \
             minus z, with the point P \
              on its plane, and the same camera moved and turned, with the points O prime and P prime and \
              the ray through them.",
        );
    for (camera, p, [o, name]) in [(&camera, p, ["O", "P"]), (&moved, q, ["O′", "P′"])] {
        d = film(d, &space, camera, 1.0, 7, 5);
        let (from, f) = (camera.position(), camera.frame());
        for (axis, name) in [(f.right * 0.75, "right"), (f.up * 1.25, "up")] {
            d = d.ray(Light::Normal, space.at(from), space.at(from + axis)).name_end(name);
        }
        d = d.ray(Light::Incident, space.at(from), space.at(from + (p - from) * 1.9));
        d = d.point(space.at(from)).name(o).spot(Light::Reflected, space.at(p)).name(name);
    }
    told(
        d,
        "After B, figure 5.6. In its place the camera's axes are the world's; moved, three unit vectors \
             (right, up, \
             forward) and the position O′ make the matrix.",
    )
}

/// D, figure 14: the parameters of a camera in a scene file.
pub fn parameters() -> Figure {
    let (pov, poi, fov) = (dvec3(0.0, 1.0, 1.0), DVec3::ZERO, 45.0f64);
    let space = Space::axonometric(62.0, 16.0);
    let camera =
        Camera::new(pov, poi, DVec3::Y, FieldOfView::Vertical(fov.to_radians())).expect("D's default camera");
    let (f, reach) = (*camera.frame(), pov.distance(poi));
    let half = (0.5 * fov.to_radians()).tan() * 0.55;
    let (eye, at) = (space.at(pov), |s: f64| space.at(pov + f.forward * 0.55 + f.up * (s * half)));
    let mut d = Diagram::fitted()
        .title(&format!("A camera is two points and an angle: POV, POI, FOV {fov}°"))
        .subtitle(&format!(
            "Camera {{ POV 0 1 1   POI 0 0 0   FOV {fov} }}: D's defaults; distance \
             {reach:.3}"
        ))
        .alt(
            "A camera at the point of view POV looks down at the point of interest POI. Its field of view \
             FOV opens between the \
              bottom and the top of the image plane. The axes x, y, z start at the origin.",
        );
    d = film(d, &space, &camera, 0.55, 4, 4).axes(&space, DVec3::ZERO, 0.6);
    d = d.ray(Light::Incident, eye, space.at(poi)).point(space.at(poi)).word("POI = (0, 0, 0)");
    d = d.point(eye).word("POV = (0, 1, 1)");
    d = d.angle_at(eye, at(-1.0) - eye, at(1.0) - eye, 130.0).word("FOV");
    d = d.thin(&[eye, at(-1.0)]).thin(&[eye, at(1.0)]);
    d = d.ray(Light::Normal, eye, space.at(pov + f.up * 0.4)).word("up");
    told(
        d,
        "After D, figure 14. The angle spans the picture from its lower to its upper edge; up is the y axis \
             as far as it \
             is perpendicular to the view.",
    )
}
