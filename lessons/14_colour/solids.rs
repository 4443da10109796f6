//! Colour models as solids: every point has the colour of its coordinates.

use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::color::Rgb;
use lightbench::color::models::{Hls, Hsv, rgb_from_cmy, rgb_from_hls, rgb_from_hsv};
use lightbench::film::Image;
use lightbench::ray::Ray;
use lightbench::scene::{Camera, FieldOfView};
use lightbench::shape::cone::Cone;
use lightbench::shape::cuboid::Cuboid;
use lightbench_kit::figure::Figure;
use lightbench_kit::figure::drawing::{Anchor, Drawing, Pixels, Rect, Stroke, Text};
use lightbench_kit::figure::heading::Heading;
use lightbench_kit::figure::ink::Ink;
use std::f64::consts::FRAC_PI_3;

/// Behind the solids.
const PAPER: Rgb = Rgb::splat(0.93);
/// Rays along a pixel's side.
const SIDE: usize = 3;
/// Half the field of view is `atan` of this.
const SLOPE: f64 = 0.235;

/// Eight corners with their names: coordinates, and what RGB calls them.
const CORNERS: [(DVec3, &str, &str); 8] = [
    (dvec3(0.0, 0.0, 0.0), "black", "white"),
    (dvec3(1.0, 0.0, 0.0), "red", "cyan"),
    (dvec3(0.0, 1.0, 0.0), "green", "magenta"),
    (dvec3(0.0, 0.0, 1.0), "blue", "yellow"),
    (dvec3(1.0, 1.0, 0.0), "yellow", "blue"),
    (dvec3(1.0, 0.0, 1.0), "magenta", "green"),
    (dvec3(0.0, 1.0, 1.0), "cyan", "red"),
    (dvec3(1.0, 1.0, 1.0), "white", "black"),
];

fn camera(from: DVec3, target: DVec3) -> Camera {
    let angle = FieldOfView::Vertical(2.0 * SLOPE.atan());
    Camera::new(from, target, DVec3::Y, angle).expect("a camera in its place")
}

/// The place of a point on a square picture of side 1, y down.
fn projected(camera: &Camera, p: DVec3) -> DVec2 {
    let (v, frame) = (p - camera.position(), camera.frame());
    let on_plane = dvec2(v.dot(frame.right), -v.dot(frame.up)) / v.dot(frame.forward);
    on_plane / (2.0 * SLOPE) + 0.5
}

/// A square picture of what `colour` finds along each ray.
fn pictured(camera: &Camera, size: usize, colour: impl Fn(&Ray) -> Option<Rgb>) -> Pixels {
    let view = camera.view(size, size);
    let offsets = (0..SIDE * SIDE).map(|k| (dvec2((k % SIDE) as f64, (k / SIDE) as f64) + 0.5) / SIDE as f64);
    let offsets: Vec<DVec2> = offsets.collect();
    let image = Image::from_fn(size, size, |x, y| {
        let corner = dvec2(x as f64, y as f64);
        let sum = offsets.iter().map(|o| colour(&view.ray(corner + *o)).unwrap_or(PAPER)).sum::<Rgb>();
        sum / offsets.len() as f64
    });
    Pixels::from(&image)
}

/// The unit cube without the octant next to (1, 1, 1).
fn opened(ray: &Ray) -> Option<DVec3> {
    let cube = Cuboid::new(DVec3::ZERO, DVec3::ONE).expect("a cube");
    let octant = Cuboid::new(DVec3::splat(0.5), DVec3::splat(1.5)).expect("a cube");
    let (enter, leave) = cube.roots(ray)?;
    match octant.roots(ray) {
        Some((a, b)) if a.t <= enter.t && enter.t < b.t => (b.t < leave.t).then(|| ray.at(b.t)),
        _ => Some(ray.at(enter.t)),
    }
}

/// C, figures 19 and 20: the cube whole, and opened to its grey diagonal.
pub fn cube(size: usize, model: Model) -> Figure {
    let cuboid = Cuboid::new(DVec3::ZERO, DVec3::ONE).expect("a cube");
    let camera = camera(dvec3(3.1, 2.5, 3.7), dvec3(0.48, 0.44, 0.48));
    let paint = |p: DVec3| {
        match model {
            Model::Rgb => p,
            Model::Cmy => rgb_from_cmy(p),
        }
        .clamp(DVec3::ZERO, DVec3::ONE)
    };
    let whole = pictured(&camera, size, |ray| cuboid.roots(ray).map(|(a, _)| paint(ray.at(a.t))));
    let inside = pictured(&camera, size, |ray| opened(ray).map(paint));
    let (title, subtitle) = match model {
        Model::Rgb => (
            "RGB counts from black: the cube's far corner, and light is added",
            "coordinates are linear light; seen from white",
        ),
        Model::Cmy => (
            "CMY counts from white: the same cube turned round, and inks take light away",
            "coordinates are shares of the light that each ink takes; seen from black",
        ),
    };
    let (mut d, places) = side_by_side(title, subtitle, [whole, inside]);
    for (i, place) in places.iter().enumerate() {
        edges(&mut d, &camera, place);
        for (corner, rgb, cmy) in CORNERS {
            let name = if model == Model::Rgb { rgb } else { cmy };
            if corner == DVec3::ZERO || (i == 1 && corner == DVec3::ONE) {
                continue;
            }
            label(&mut d, &camera, place, corner, name);
        }
    }
    let letters = if model == Model::Rgb { ["R", "G", "B"] } else { ["C", "M", "Y"] };
    let under = [
        format!(
            "{} behind; axes {} to the right, {} up, {} to the left",
            if model == Model::Rgb { "black" } else { "white" },
            letters[0],
            letters[1],
            letters[2]
        ),
        "opened: grey (½, ½, ½) in the corner, half way".to_string(),
    ];
    for (place, words) in places.iter().zip(under) {
        below(&mut d, place, &words);
    }
    let which = if model == Model::Rgb { ("RGB", "19") } else { ("CMY", "20") };
    let alt = format!(
        "The {} cube seen from one corner, its faces blending between eight named colours; beside it the same with an eighth cut out, which shows grey inside.",
        which.0
    );
    Figure::new(d, title, &alt)
        .caption(&format!("The cube of the {} model (after C, figure {}).", which.0, which.1))
}

/// Which cube.
#[derive(Clone, Copy, PartialEq)]
pub enum Model {
    Rgb,
    Cmy,
}

fn side_by_side(title: &str, subtitle: &str, pictures: [Pixels; 2]) -> (Drawing, [Rect; 2]) {
    let mut drawing = Drawing::new(1200.0, 760.0);
    let top = Heading { title: title.to_string(), subtitle: subtitle.to_string() }.draw(&mut drawing);
    let side = 552.0;
    let place = |i: usize| {
        let x = 40.0 + (side + 16.0) * i as f64;
        Rect::new(x, top, x + side, top + side)
    };
    for (i, picture) in pictures.into_iter().enumerate() {
        drawing.image(place(i), picture);
    }
    (drawing, [place(0), place(1)])
}

fn below(drawing: &mut Drawing, place: &Rect, words: &str) {
    let at = dvec2(place.center().x, place.max.y + 28.0);
    drawing.text(Text::new(at, words, 19.0, Ink::Text).anchor(Anchor::Middle));
}

/// The outline of the cube and its three front edges.
fn edges(drawing: &mut Drawing, camera: &Camera, place: &Rect) {
    let at = |p: DVec3| place.min + projected(camera, p) * place.width();
    let outline = [
        dvec3(1.0, 0.0, 0.0),
        dvec3(1.0, 1.0, 0.0),
        dvec3(0.0, 1.0, 0.0),
        dvec3(0.0, 1.0, 1.0),
        dvec3(0.0, 0.0, 1.0),
        dvec3(1.0, 0.0, 1.0),
    ];
    let pen = || Stroke::new(Ink::Fixed([60, 64, 72]), 1.6);
    drawing.polygon(&outline.map(at), None, Some(pen()));
}

/// A corner's name and coordinates, outside the outline.
fn label(drawing: &mut Drawing, camera: &Camera, place: &Rect, corner: DVec3, name: &str) {
    let at = place.min + projected(camera, corner) * place.width();
    let middle = place.min + projected(camera, DVec3::splat(0.5)) * place.width();
    let out = (at - middle).normalize_or(DVec2::Y);
    let front = corner == DVec3::ONE;
    let anchor = match out.x {
        x if front || x.abs() < 0.3 => Anchor::Middle,
        x if x < 0.0 => Anchor::End,
        _ => Anchor::Start,
    };
    let ink = Ink::Fixed(if name == "black" { [245, 245, 245] } else { [27, 31, 39] });
    // Two lines: the name, and the coordinates under it.
    let first = match (front, out.y) {
        (true, _) => at + dvec2(0.0, 28.0),
        (_, y) if y < -0.6 => at + dvec2(0.0, -32.0),
        (_, y) if y > 0.6 => at + dvec2(0.0, 24.0),
        _ => at + out * 10.0 + dvec2(0.0, -4.0),
    };
    let words = [name.to_string(), format!("({:.0},{:.0},{:.0})", corner.x, corner.y, corner.z)];
    for (i, words) in words.into_iter().enumerate() {
        let line = first + dvec2(0.0, 21.0 * i as f64);
        drawing.text(Text::new(line, words, 19.0, ink).anchor(anchor));
    }
}

/// The first meeting with solids of which a wedge towards the viewer is cut away.
fn cut(solids: &[Cone], wedge: [DVec3; 2], ray: &Ray) -> Option<DVec3> {
    let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
    for n in wedge {
        let (height, rate) = (n.dot(ray.origin), n.dot(ray.direction));
        let t = -height / rate;
        if rate > 0.0 { from = from.max(t) } else { to = to.min(t) }
    }
    let mut first = f64::INFINITY;
    for span in solids.iter().filter_map(|solid| solid.span(ray)) {
        let enter = span.enter.t;
        let t = if from < enter && enter < to { to } else { enter };
        if t < span.leave.t {
            first = first.min(t);
        }
    }
    first.is_finite().then(|| ray.at(first))
}

/// HSV as a cone and HLS as two, each opened to its axis of greys.
pub fn cones(size: usize) -> Figure {
    let made = |a: DVec3, b: DVec3, r: f64| Cone::new(a, b, r, 0.0).expect("a cone");
    let hsv = [made(DVec3::Y, DVec3::ZERO, 1.0)];
    let hls = [made(DVec3::Y * 0.5, DVec3::ZERO, 1.0), made(DVec3::Y * 0.5, DVec3::Y, 1.0)];
    let stretch = 1.5; // the solids are half as high again as their coordinates
    let camera = camera(dvec3(0.65, 3.05, 5.0), dvec3(0.0, 0.87, 0.0));
    // A quarter towards the viewer; hue 0, red, lies to the right.
    let wedge = [dvec3(0.8, 0.0, 0.6), dvec3(-0.6, 0.0, 0.8)];
    let squeeze = |ray: &Ray| {
        let by = dvec3(1.0, 1.0 / stretch, 1.0);
        Ray::new(ray.origin * by, ray.direction * by)
    };
    let hue = |p: DVec3| (-p.z).atan2(p.x) / FRAC_PI_3;
    let reach = |p: DVec3| dvec2(p.x, p.z).length();
    let share = |part: f64, of: f64| if of > 0.0 { (part / of).min(1.0) } else { 0.0 };
    let paint_hsv =
        |p: DVec3| Hsv { hue: hue(p), saturation: share(reach(p), p.y), value: p.y.clamp(0.0, 1.0) };
    let paint_hls = |p: DVec3| {
        let lightness = p.y.clamp(0.0, 1.0);
        Hls { hue: hue(p), lightness, saturation: share(reach(p), 1.0 - (2.0 * lightness - 1.0).abs()) }
    };
    let left = pictured(&camera, size, |ray| {
        cut(&hsv, wedge, &squeeze(ray)).map(|p| rgb_from_hsv(paint_hsv(p)).max(DVec3::ZERO))
    });
    let right = pictured(&camera, size, |ray| {
        cut(&hls, wedge, &squeeze(ray)).map(|p| rgb_from_hls(paint_hls(p)).max(DVec3::ZERO))
    });
    let title = "The painter's models: HSV darkens to one point, HLS runs from black to white";
    let (mut d, places) = side_by_side(
        title,
        "hue round the axis, saturation outwards, value or lightness upwards; a quarter is cut away to show the greys",
        [left, right],
    );
    below(&mut d, &places[0], "HSV: black below, white in the middle of the top");
    below(&mut d, &places[1], "HLS: black below, white above, full hues half way");
    Figure::new(d, title, "A cone that is black at its tip and a colour wheel on top, and a double cone from black to white with full hues round its waist; both opened to show the axis of greys.")
        .caption("The solids of HSV and HLS, which C names and leaves for later.")
}
