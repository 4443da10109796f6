//! Pictures: lamps and inks that overlap, an orange under four lamps, a star averaged in two ways, a spectrum on a screen.

use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::color::dominant::{Locus, Rim, Wheel};
use lightbench::color::gamut::IntoGamut;
use lightbench::color::models::rgb_from_cmy;
use lightbench::color::spectrum::Matching;
use lightbench::color::xyz::{Xyy, rgb_from_xyz, xyy_from_xyz, xyz_from_rgb, xyz_from_xyy};
use lightbench::color::{Rgb, luminance, srgb_decode, srgb_encode};
use lightbench::film::Image;
use lightbench::integrator::Local;
use lightbench::light::{AreaLight, Emission, Light};
use lightbench::render::{Picture, render};
use lightbench::sample::Pattern;
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::sphere::Sphere;
use lightbench_kit::figure::drawing::{Anchor, Drawing, Face, Rect, Stroke, Text};
use lightbench_kit::figure::heading::Heading;
use lightbench_kit::figure::ink::Ink;
use lightbench_kit::figure::{ErrorPanel, Figure, Panels, Pixels, Shades};
use std::f64::consts::TAU;

/// Reflectances of an orange for red, green and blue light [B §7.1.2].
pub const ORANGE: Rgb = dvec3(0.9, 0.6, 0.1);

/// Centre of the k-th of three discs on a sheet of side 1, and their radius.
const RADIUS: f64 = 0.27;
fn center(k: usize) -> DVec2 {
    let angle = TAU * (k as f64 / 3.0 - 0.25);
    dvec2(0.5, 0.52) + 0.185 * dvec2(angle.cos(), angle.sin())
}

/// B, illustration 6.8, and its counterpart in inks.
pub fn discs(size: usize) -> Figure {
    let side = 4;
    let sheet = |mix: &dyn Fn(DVec3) -> Rgb| {
        Pixels::from(&Image::from_fn(size, size, |x, y| {
            let sample = |k: usize| {
                let p = dvec2(x as f64, y as f64)
                    + (dvec2((k % side) as f64, (k / side) as f64) + 0.5) / side as f64;
                let covered = |i: usize| f64::from(u8::from((p / size as f64).distance(center(i)) < RADIUS));
                mix(dvec3(covered(0), covered(1), covered(2)))
            };
            (0..side * side).map(sample).sum::<Rgb>() / (side * side) as f64
        }))
    };
    let lamps = sheet(&|amount| Rgb::splat(0.012).max(amount));
    let inks = sheet(&|amount| rgb_from_cmy(amount).max(Rgb::splat(0.012)) * 0.93);
    let title = "Three lamps add up to white, three inks take it all away";
    let mut d = Drawing::new(1200.0, 770.0);
    let heading = Heading {
        title: title.to_string(),
        subtitle:
            "left: discs of light on a dark wall, RGB added; right: discs of ink on paper, CMY multiplied"
                .to_string(),
    };
    let top = heading.draw(&mut d);
    let names = [
        (["red", "green", "blue"], ["cyan", "magenta", "yellow"], "white"),
        (["cyan", "magenta", "yellow"], ["red", "green", "blue"], "black"),
    ];
    for (i, (picture, (alone, pairs, all))) in [lamps, inks].into_iter().zip(names).enumerate() {
        let x = 40.0 + 568.0 * i as f64;
        let place = Rect::new(x, top, x + 552.0, top + 552.0);
        d.image(place, picture);
        let dark = Ink::Fixed([20, 22, 28]);
        let light = Ink::Fixed([250, 250, 250]);
        let middle = (center(0) + center(1) + center(2)) / 3.0;
        let mut word = |at: DVec2, words: &str, size: f64, ink: Ink| {
            let at = place.min + at * place.width() + dvec2(0.0, 8.0);
            d.text(Text::new(at, words, size, ink).anchor(Anchor::Middle).face(Face::Bold));
        };
        for k in 0..3 {
            let out = center(k) - middle;
            let ink =
                |name: &str| if ["blue", "red", "magenta", "black"].contains(&name) { light } else { dark };
            word(middle + out * 1.55, alone[k], 22.0, ink(alone[k]));
            // Opposite each disc lies the overlap of the two others.
            word(middle - out * 1.02, pairs[k], 18.0, ink(pairs[k]));
        }
        word(middle, all, 22.0, if i == 0 { dark } else { light });
        let words = ["additive: light on light", "subtractive: ink on ink"][i];
        let at = dvec2(place.center().x, place.max.y + 28.0);
        d.text(Text::new(at, words, 20.0, Ink::Text).anchor(Anchor::Middle));
    }
    Figure::new(d, title, "Left, discs of red, green and blue light on a dark wall overlap in yellow, cyan, magenta and white. Right, discs of cyan, magenta and yellow ink on paper overlap in blue, red, green and black.")
        .caption("Lamps add, inks multiply (after B, illustration 6.8, with its counterpart). White needs all three lamps, black all three inks.")
}

/// B's orange: what a lamp sends and what the skin sends back, channel by channel.
pub fn orange(size: usize, samples: u32, seed: u64) -> Figure {
    let lamps = [
        ("white lamp", Rgb::ONE),
        ("red lamp", dvec3(1.0, 0.0, 0.0)),
        ("green lamp", dvec3(0.0, 1.0, 0.0)),
        ("blue lamp", dvec3(0.0, 0.0, 1.0)),
    ];
    let mut panels = Panels::new()
        .columns(4)
        .title("An orange sends back 0.9 of the red, 0.6 of the green, 0.1 of the blue: a lamp's colour times its own")
        .subtitle("reflectances of B §7.1.2; the floor sends back 0.8 of each")
        .alt("An orange ball on a pale floor under a white, a red, a green and a blue lamp: orange, bright red, green of two thirds, and nearly black blue.");
    for (name, lamp) in lamps {
        let image =
            render(&fruit(lamp), &Local::default(), Picture { width: size, height: size, samples, seed })
                .image;
        let sent = (lamp * ORANGE).to_array().map(|c| format!("{c}"));
        panels = panels.picture(Pixels::from(&image), &format!("{name}: ({})", sent.join(", ")));
    }
    Figure::from(panels).caption("The worked reflectances of B, §7.1.2 (illustration 7.11 is a photograph): the colour that leaves is the product, channel by channel.")
}

fn fruit(lamp: Rgb) -> Scene {
    let view = FieldOfView::Vertical(27f64.to_radians());
    let camera = Camera::new(dvec3(0.0, 1.5, 5.2), dvec3(0.0, 0.0, 0.0), DVec3::Y, view);
    let mut scene = Scene::new(camera.expect("a camera in its place"));
    let matt = |diffuse| Material { diffuse, specular: DVec3::ZERO, ..Material::default() };
    scene.materials = vec![matt(DVec3::splat(0.8)), matt(ORANGE)];
    let floor = Cuboid::new(dvec3(-60.0, -1.2, -60.0), dvec3(60.0, -1.0, 60.0)).expect("a floor");
    let ball = Sphere::new(DVec3::ZERO, 1.0).expect("a ball");
    scene.objects =
        vec![Object::new("floor", Box::new(floor), 0), Object::new("orange", Box::new(ball), 1)].into();
    let at = dvec3(-2.6, 4.6, 3.0);
    let light =
        AreaLight::rectangle(at, -at, 0.0, dvec2(1.4, 1.4), Emission::even(lamp * 0.98)).expect("a lamp");
    scene.lights = vec![Light::Area(light.subdivided(4, 4, Pattern::Jittered))];
    scene.ambient = lamp * 0.14;
    scene.background = lamp * 0.55 + 0.08;
    scene
}

/// A star of thin wedges in complementary colours, averaged as light and as stored bytes.
pub fn averages(size: usize) -> Figure {
    const RAYS: f64 = 36.0;
    const SIDE: usize = 8; // samples along a pixel's side
    let star = |p: DVec2| {
        let turn = p.y.atan2(p.x) / TAU * RAYS;
        if turn.rem_euclid(1.0) < 0.5 { dvec3(1.0, 0.0, 1.0) } else { dvec3(0.0, 1.0, 0.0) }
    };
    let averaged = |into: fn(f64) -> f64, back: fn(f64) -> f64| {
        Image::from_fn(size, size, |x, y| {
            let sample = |k: usize| {
                let offset = dvec2((k % SIDE) as f64 + 0.5, (k / SIDE) as f64 + 0.5) / SIDE as f64;
                star((dvec2(x as f64, y as f64) + offset) / size as f64 - 0.5).map(into)
            };
            ((0..SIDE * SIDE).map(sample).sum::<Rgb>() / (SIDE * SIDE) as f64).map(back)
        })
    };
    let light = averaged(|x| x, |x| x);
    let bytes = averaged(srgb_encode, srgb_decode);
    let errors: Vec<f64> =
        light.pixels().iter().zip(bytes.pixels()).map(|(a, b)| luminance(*b) - luminance(*a)).collect();
    let rmse = (errors.iter().map(|e| e * e).sum::<f64>() / errors.len().max(1) as f64).sqrt();
    let lost = 1.0 - srgb_decode(0.5) / 0.5;
    let error = ErrorPanel {
        width: size,
        height: size,
        values: errors,
        shades: Shades::Signed,
        name: "error of luminance".into(),
        rmse,
        range: Some((-0.3, 0.3)),
    };
    Figure::from(
        Panels::new()
            .columns(3)
            .title(&format!("Averaging stored bytes loses {:.0} % of the light where two colours share a pixel", lost * 100.0))
            .subtitle("36 wedges of magenta and green, each pixel the mean of 64 samples; together they are white of half power, grey")
            .alt("A star of magenta and green wedges whose centre is too fine for the pixels: averaged as light the centre is an even light grey, averaged as bytes it is dark, and every edge has a dark fringe.")
            .picture(Pixels::from(&light), "mean of the light")
            .picture(Pixels::from(&bytes), "mean of the stored bytes")
            .error(error),
    )
    .caption("A mean is a mixture of light, and only linear values add. Stored bytes follow the sRGB curve: half of 0 and 255 is 128, which is a fifth of the light, not half.")
}

/// The lines of the spectrum on a screen, clipped and desaturated.
pub fn spectrum(width: usize, wheel: &Wheel) -> Figure {
    let (low, high) = (400.0, 690.0);
    let height = width / 7;
    let bar = |way: IntoGamut| {
        let colour = |x: usize| {
            let w = low + (high - low) * (x as f64 + 0.5) / width as f64;
            way.apply(rgb_from_xyz(Matching::Table1nm.at(w)))
        };
        let row: Vec<Rgb> = (0..width).map(colour).collect();
        // One exposure for both bars.
        Pixels::from(&Image::from_fn(width, height, |x, _| row[x] * 0.55))
    };
    let title =
        "No line of the spectrum is in a screen's gamut: clipping turns hues, mixing with white pales them";
    let mut d = Drawing::new(1200.0, 650.0);
    let added = (420..=660).map(|w| changes(IntoGamut::Clip, f64::from(w), wheel).1).fold(0.0, f64::max);
    let subtitle = format!(
        "lines of equal power at one exposure; clipping multiplies their luminance by up to {:.1}",
        1.0 + added
    );
    let top = Heading { title: title.to_string(), subtitle }.draw(&mut d);
    for (i, way) in IntoGamut::ALL.into_iter().enumerate() {
        let y = top + 36.0 + 222.0 * i as f64;
        let place = Rect::new(40.0, y, 1160.0, y + 160.0);
        d.text(Text::new(dvec2(40.0, y - 10.0), way.name(), 20.0, Ink::Text));
        d.image(place, bar(way));
        for nm in (400..=680).step_by(20) {
            let x = 40.0 + 1120.0 * (f64::from(nm) - low) / (high - low);
            d.line(dvec2(x, y + 162.0), dvec2(x, y + 169.0), Stroke::new(Ink::Outline, 1.4));
            if i == 1 {
                d.text(
                    Text::new(dvec2(x, y + 190.0), nm.to_string(), 18.0, Ink::Muted).anchor(Anchor::Middle),
                );
            }
        }
        if i == 1 {
            d.text(
                Text::new(dvec2(1160.0, y + 216.0), "wavelength, nm", 20.0, Ink::Text).anchor(Anchor::End),
            );
        }
    }
    Figure::new(d, title, "Two bars of the spectrum from violet to red: mixed with white the hues run smoothly and pale; clipped they are strong and fall into blocks of blue, green and red.")
        .caption("What a screen does with colours that it cannot show. Desaturating keeps luminance and dominant wavelength; clipping keeps neither.")
}

/// How the dominant wavelength [nm] and the luminance (share) of a line change on the way to the screen.
pub fn changes(way: IntoGamut, wavelength: f64, wheel: &Wheel) -> (f64, f64) {
    let xy = Locus::of(Matching::Table1nm).at(wavelength);
    let line = xyz_from_xyy(Xyy { xy, luminance: 1.0 }).unwrap_or_default();
    let shown = xyz_from_rgb(way.apply(rgb_from_xyz(line)));
    let rim = xyy_from_xyz(shown).and_then(|c| wheel.dominant(c.xy)).map(|d| d.rim);
    let shift = match rim {
        Some(Rim::Spectral(found)) => (found - wavelength).abs(),
        _ => f64::NAN,
    };
    (shift, shown.y - 1.0)
}
