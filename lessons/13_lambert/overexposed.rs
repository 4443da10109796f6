//! Too much light: C's clamp, C's division by the channels' maxima, and one divisor [C §1.8.2 D].

use super::model::{Made, other};
use super::study::shoot;
use glam::DVec3;
use lightbench::color::models::{Hsv, degrees, hsv_from_rgb, hue, rgb_from_hsv};
use lightbench::color::{Rgb, srgb_encode};
use lightbench::film::Image;
use lightbench::film::tone::{ToneMap, divide_by_channel_maxima_as_printed};
use lightbench::integrator::Local;
use lightbench::light::DirectionalLight;
use lightbench::measure::{Method, log_spaced};
use lightbench::render::{Picture, render};
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::plane::Plane;
use lightbench_kit::figure::{Axis, Chart, FailureMap, Figure, Panels, Pixels, Shades, Table, short};
use lightbench_kit::lesson::Result;

/// A hue that turns by more than this is another colour [degrees].
const WRONG: f64 = 5.0;
const COLOURED: f64 = 0.3; // saturation from which on a colour has a hue worth keeping
pub const EXPOSURE: f64 = 3.0; // times the radiance that a display shows

/// Three ways into a display's range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    Clamp,
    Channels,
    One,
}

impl Way {
    pub const ALL: [Way; 3] = [Way::Clamp, Way::Channels, Way::One];

    fn method(self) -> Method {
        match self {
            Way::Clamp => Method::new("clamp").styled(0),
            Way::Channels => Method::as_printed("each channel by its maximum"),
            Way::One => Method::new("one divisor").styled(1),
        }
    }

    pub fn apply(self, image: &Image) -> Image {
        match self {
            Way::Clamp => ToneMap::Clamp.apply(image),
            Way::Channels => divide_by_channel_maxima_as_printed(image),
            Way::One => ToneMap::DivideByMaximum.apply(image),
        }
    }
}

/// How far a hue turns [degrees], the shorter way; 180 if it is lost to grey; none of a colour that is nearly grey.
pub fn turn(before: Rgb, after: Rgb) -> Option<f64> {
    if !(hsv_from_rgb(before).saturation > COLOURED) {
        return None;
    }
    let a = hue(before)?;
    let Some(b) = hue(after) else { return Some(180.0) };
    let d = degrees((a - b).rem_euclid(6.0));
    Some(d.min(360.0 - d))
}

/// Mean turn of the hues of a picture [degrees], the largest, and the share of coloured pixels beyond [`WRONG`].
pub fn turns(before: &Image, after: &Image) -> (f64, f64, f64) {
    let all: Vec<f64> =
        before.pixels().iter().zip(after.pixels()).filter_map(|(p, q)| turn(*p, *q)).collect();
    let count = all.len().max(1) as f64;
    let wrong = all.iter().filter(|d| **d > WRONG).count() as f64;
    (all.iter().sum::<f64>() / count, all.iter().copied().fold(0.0, f64::max), wrong / count)
}

/// The spheres, overexposed; and the same with one pixel that is hotter by far.
pub fn pictures(picture: Picture) -> Result<(Image, Image)> {
    let image = shoot(Made::NONE.with(2).with(6), 1, picture)?.map(|p| p * EXPOSURE);
    let mut hot = image.clone();
    hot.set(picture.width / 2, picture.height / 32, Rgb::new(24.0, 12.0, 6.0));
    Ok((image, hot))
}

pub fn panels(picture: Picture) -> Result<Figure> {
    let (image, hot) = pictures(picture)?;
    let mut panels = Panels::new()
        .columns(3)
        .title("Clamping turns the hues of what is too bright; own maxima turn all hues; one divisor turns none, and darkens all")
        .subtitle(&format!(
            "{EXPOSURE} times overexposed; below with a hot pixel (24, 12, 6) in the sky; mean turn of hue at saturations over 0.3"
        ))
        .alt("Six pictures of two spheres. Clamped: a bright washed-out picture, the same with a hot pixel. Each channel by its maximum: nearly right, but with a hot pixel dark and blue. One divisor: right, but with a hot pixel nearly black.");
    for (image, what) in [(&image, ""), (&hot, ", hot pixel")] {
        for way in Way::ALL {
            let shown = way.apply(image);
            let name = ["clamped", "by channels, as printed", "one divisor"][way as usize];
            panels = panels
                .picture(Pixels::from(&shown), &format!("{name}{what}: {:.1}°", turns(image, &shown).0));
        }
    }
    Ok(Figure::from(panels).caption(
        "C's two ways to bring colours into range, and the second put right (C §1.8.2 D). None is stable: the clamp depends on the \
         exposure, both divisions on a single pixel. Lesson 03's `ToneMap` offers the clamp and the one divisor."))
}

/// Hue error of the clamp over hue and overexposure.
pub fn clamp_map(columns: usize) -> Figure {
    let cell = |hue: f64, exposure: f64| {
        let color = rgb_from_hsv(Hsv { hue: hue / 60.0, saturation: 0.8, value: 1.0 }) * exposure;
        turn(color, color.min(Rgb::ONE))
    };
    let axes = (
        Axis::linear("hue [degrees]").range(0.0, 360.0).every(60.0),
        Axis::log("overexposure, largest channel").range(1.0, 10.0),
    );
    let map = FailureMap::new(axes.0, axes.1, "turn of hue [degrees]", (columns, columns * 3 / 4), cell)
        .shades(Shades::Linear)
        .range(0.0, 60.0)
        .failing_above(WRONG, &format!("over {WRONG}°"));
    let title = format!(
        "Clamped, {:.0} % of these colours turn by over {WRONG}°: towards yellow, cyan, magenta, and at last to white",
        100.0 * map.failing_share()
    );
    let map = map.title(&title).subtitle("colours of saturation 0.8; a hue that is lost to white counts as 180°: five times overexposed, that is all of them");
    Figure::from(map).caption(
        "A channel that saturates stays while the others grow. Pure hues, such as C's red, and those half way between two of them keep \
         theirs until white; the rest run towards the nearest mixture of two full channels.")
}

/// Hue error of the printed division over hue and the picture's colour cast.
pub fn printed_map(columns: usize) -> Figure {
    let cell = |hue: f64, ratio: f64| {
        let color = rgb_from_hsv(Hsv { hue: hue / 60.0, saturation: 0.8, value: 1.0 });
        turn(color, color / Rgb::new(1.0, ratio.sqrt(), ratio))
    };
    let axes = (
        Axis::linear("hue [degrees]").range(0.0, 360.0).every(60.0),
        Axis::log("blue maximum over red maximum of the picture; green between them").range(0.1, 10.0),
    );
    let map = FailureMap::new(axes.0, axes.1, "turn of hue [degrees]", (columns, columns * 3 / 4), cell)
        .shades(Shades::Linear)
        .range(0.0, 60.0)
        .failing_above(WRONG, &format!("over {WRONG}°"));
    let title = format!(
        "Divided by their own maxima, {:.0} % of these colours turn by over {WRONG}°; only equal maxima are harmless",
        100.0 * map.failing_share()
    );
    let map = map.title(&title).subtitle("colours of saturation 0.8 in pictures whose brightest red, green and blue differ, as under a warm or a cold lamp");
    Figure::from(map).caption("C divides each channel by its own maximum over the picture. A lamp's colour is taken out of it, and every other colour with it.")
}

/// The picture's level as a display shows it, over the radiance of one hot pixel.
pub fn hot_pixel(picture: Picture) -> Result<Figure> {
    let (image, hot) = pictures(picture)?;
    let at = hot.pixels().iter().zip(image.pixels()).position(|(a, b)| a != b).unwrap_or(0);
    let green = |image: &Image| {
        let mut levels: Vec<f64> =
            image.pixels().iter().map(|p| 255.0 * srgb_encode(p.y.clamp(0.0, 1.0))).collect();
        levels.sort_by(f64::total_cmp);
        levels[levels.len() / 2]
    };
    let radiances = log_spaced(1.0, 1.0e6, 49);
    let line = |way: Way| {
        let level = |&radiance: &f64| {
            let mut hot = image.clone();
            hot.pixels_mut()[at] = Rgb::new(1.0, 0.5, 0.25) * radiance;
            (radiance, green(&way.apply(&hot)))
        };
        radiances.iter().map(level).collect::<Vec<_>>()
    };
    let lines = Way::ALL.map(|way| (way.method(), line(way)));
    let dark = lines[2].1.iter().find(|p| p.1 < 10.0).map_or(f64::NAN, |p| p.0);
    let mut chart = Chart::new(
        Axis::log("radiance of one pixel [W m⁻² sr⁻¹]"),
        Axis::linear("median level of green, of 255").range(0.0, 255.0),
    )
    .title(&format!("One pixel of {} W/(m² sr) makes a picture black, if it divides the others", short(dark)))
    .subtitle(&format!(
        "two spheres, {EXPOSURE} times overexposed, {} × {} pixels, one of them (1, ½, ¼) times what the axis says",
        picture.width, picture.height
    ));
    for (method, points) in lines {
        chart = chart.function(method, &points);
    }
    Ok(Figure::from(chart).caption("Dividing by a maximum is unstable: the whole picture hangs on its brightest pixel. The clamp does not care."))
}

/// What a surface of reflectance `k` shows that faces C's lamp (1, 1, 1) under ambient light (0.5, 0.5, 0.5): (22).
fn facing(k: Rgb) -> Result<Rgb> {
    let view = FieldOfView::Vertical(0.1);
    let mut scene = Scene::new(Camera::new(DVec3::Y, DVec3::ZERO, DVec3::Z, view).map_err(other)?);
    scene.materials.push(Material { diffuse: k, ..Material::default() });
    let floor = Plane::new(DVec3::ZERO, DVec3::Y).map_err(other)?;
    scene.objects.push(Object::new("floor", Box::new(floor), 0));
    scene.lights.push(DirectionalLight::of_color(DVec3::NEG_Y, Rgb::ONE).map_err(other)?.into());
    scene.ambient = Rgb::splat(0.5);
    Ok(render(&scene, &Local::default(), Picture { width: 1, height: 1, samples: 1, seed: 0 })
        .image
        .get(0, 0))
}

/// C's worked example, and what becomes of other colours.
pub fn examples() -> Result<Table> {
    let cases = [
        ("C's red, K = (1, 0, 0)", facing(Rgb::X)?),
        ("orange, K = (1, 0.5, 0.1)", facing(Rgb::new(1.0, 0.5, 0.1))?),
        ("violet, K = (0.5, 0.2, 0.9)", facing(Rgb::new(0.5, 0.2, 0.9))?),
        ("dark green, K = (0.1, 0.3, 0.2)", facing(Rgb::new(0.1, 0.3, 0.2))?),
    ];
    let sheet = Image::from_pixels(cases.len(), 1, cases.iter().map(|c| c.1).collect());
    let three = |c: Rgb| format!("({})", c.to_array().map(short).join(", "));
    let turned = |before: Rgb, after: Rgb| {
        turn(before, after)
            .map_or("grey".to_string(), |d| if d >= 180.0 { "lost".into() } else { format!("{d:.0}°") })
    };
    let mut table = Table::new(&["surface", "I, raw", "clamped", "turn", "own maxima", "turn", "one divisor", "turn"])
        .title("C's red survives both of C's ways; other colours do not")
        .subtitle("lamp (1, 1, 1) from straight above, ambient light (0.5, 0.5, 0.5); four surfaces are one picture; turn of hue");
    let ways = Way::ALL.map(|way| way.apply(&sheet));
    for (i, (name, raw)) in cases.iter().enumerate() {
        let of = |w: usize| ways[w].get(i, 0);
        table = table.row(&[
            name,
            &three(*raw),
            &three(of(0)),
            &turned(*raw, of(0)),
            &three(of(1)),
            &turned(*raw, of(1)),
            &three(of(2)),
            &turned(*raw, of(2)),
        ]);
    }
    Ok(table)
}
