//! Pictures and charts of lesson 01, and the list of its diagrams.

use super::{DEPTH, DISTANCE, HOLES, PHOTONS, REPETITIONS, obscura, photons, spaces, stage};
use glam::{DVec2, DVec3, dvec2};
use lightbench::film::Image;
use lightbench::measure::{Method, Series};
use lightbench::sample::{point2, uniform, uniform_disc};
use lightbench::scene::pinhole::{
    blur, diffraction_blur, hole_solid_angle, obscura_line, shadow_blur, sharpest_hole, solid_angle_density,
};
use lightbench::scene::{Camera, FieldOfView, obscura_from_camera};
use lightbench_kit::figure::{Axis, Chart, FailureMap, Figure, Guide, Panels, Pixels, grouped, short};
use lightbench_kit::lesson::{Lesson, Result};
use std::f64::consts::TAU;

const GREEN: f64 = 550.0e-9; // m, wavelength
const FAR: f64 = 2.0; // m, distance of the point whose blur is measured

/// The documents' diagrams.
pub fn diagrams(lesson: &Lesson) -> Result {
    let seed = lesson.seed();
    lesson.save("box", obscura::the_box())?;
    lesson.save("hole_or_not", obscura::what_the_hole_keeps())?;
    lesson.save("inverts_rays", obscura::inverts())?;
    lesson.save("window", obscura::window())?;
    lesson.save("one_pixel", obscura::one_pixel(seed))?;
    lesson.save("pixel_rays", obscura::through_the_centres())?;
    lesson
        .save("photons", photons::ways_of_photons(lesson.pick([200_000, 400_000, 1_000_000, 4_000_000])))?;
    lesson.save("forward", photons::forward(seed))?;
    lesson.save("backward", photons::hit_or_miss())?;
    lesson.save("basic_camera", spaces::basic_camera())?;
    lesson.save("spaces", spaces::raster_ndc_screen())?;
    lesson.save("aspect", spaces::aspect())?;
    lesson.save("field_of_view", spaces::field_of_view())?;
    lesson.save("camera_to_world", spaces::camera_to_world())?;
    lesson.save("parameters", spaces::parameters())
}

/// C, figure 2: the film and the window; then the film behind wider and wider holes.
pub fn pictures(lesson: &Lesson, film: &Image, window: &Image) -> Result {
    let panels = Panels::new()
        .title("The same rays draw the same picture, on film upside down")
        .subtitle("a paper theatre 2 to 9 m away; film 14 × 10 cm, 10 cm behind a hole without width")
        .alt(
            "Two pictures of a house with a red letter F, a tree, hills and the sun. On the left, on the \
                 film of a camera \
             obscura, it stands upside down with left and right exchanged; on the right, through the \
             window, it is upright.",
        )
        .picture(Pixels::from(film), "on the film, behind the hole")
        .picture(Pixels::from(window), "in the window, before it");
    let caption =
        "After C, figure 2, rendered: the camera obscura inverts the picture; the window model does not.";
    lesson.save("inverts", Figure::from(panels).caption(caption))?;

    let spp = lesson.pick([2, 16, 128, 1024]);
    let mut panels = Panels::new()
        .columns(3)
        .title("Twice as wide a hole: four times the light, twice the blur")
        .subtitle(&format!(
            "film 10 cm behind the hole, same exposure for all, {spp} rays a pixel, seed {}; \
             no diffraction",
            lesson.seed()
        ))
        .alt(
            "Three pictures of the same scene behind holes of 1.5, 3 and 6 millimetres: the first is dark \
             and sharp, the last white and blurred.",
        );
    for hole in [0.0015, 0.003, 0.006] {
        let image = through_hole(hole, lesson.seed(), spp);
        let exposure = (hole / 0.003f64).powi(2);
        let label = format!(
            "{} mm: light × {exposure}, blur {:.2} mm",
            hole * 1e3,
            1e3 * shadow_blur(hole, DEPTH, FAR)
        );
        panels = panels.picture(Pixels::from(&image.map(|p| p * (1.25 * exposure))), &label);
    }
    let caption = "What A says of ill. 50: the hole's size sets how bright the film gets, and how sharp. \
         Corners are darker by cos⁴θ.";
    lesson.save("hole_pictures", Figure::from(panels).caption(caption))
}

/// The film behind a hole of that diameter, turned upright, in units of what the axis receives.
fn through_hole(hole: f64, seed: u64, spp: u32) -> Image {
    let (width, height) = (364, 260);
    let size = dvec2(width as f64, height as f64);
    Image::from_fn(width, height, |i, j| {
        let of = |s: u32| {
            let index = (j * width + i) as u64;
            let aside = dvec2(uniform(seed, index, s, 0), uniform(seed, index, s, 1));
            let ndc = (dvec2(i as f64, j as f64) + aside) / size;
            let film = stage::film_half() * dvec2(1.0 - 2.0 * ndc.x, 2.0 * ndc.y - 1.0);
            let at = 0.5 * hole * uniform_disc(dvec2(uniform(seed, index, s, 2), uniform(seed, index, s, 3)));
            let (_, direction) = obscura_line(film, at, DEPTH);
            let cos2 = DEPTH * DEPTH / direction.length_squared();
            stage::radiance(at.extend(0.0), direction) * (cos2 * cos2)
        };
        (0..spp).map(of).sum::<DVec3>() / f64::from(spp)
    })
}

/// How much passes a hole, and how sharply.
pub fn holes(lesson: &Lesson, counted: &[u64]) -> Result {
    let found: Vec<(f64, f64)> = HOLES.iter().zip(counted).map(|(h, n)| (h * 1e3, *n as f64)).collect();
    let share = |h: f64| f64::from(PHOTONS) * hole_solid_angle(0.5 * h, DISTANCE) / (2.0 * TAU);
    let exact: Vec<(f64, f64)> =
        (0..=40).map(|k| 0.01 * 100f64.powf(f64::from(k) / 40.0)).map(|h| (h * 1e3, share(h))).collect();
    let axis = || Axis::log("diameter of the hole, mm");
    let chart = Chart::new(axis(), Axis::log(&format!("photons of {} that pass", grouped(PHOTONS.into()))))
        .title(&format!("Light grows with the hole's area: {} in a million pass 2 cm", counted[1]))
        .subtitle(&format!("a bare bulb on the axis, {DISTANCE} m away; seed {}", lesson.seed()))
        .function("solid angle", &exact)
        .dots("counted", &found)
        .guide(Guide::slope(2.0, "area: slope 2"));
    lesson.save("hole_light", chart)?;

    let sharpest = sharpest_hole(DEPTH, FAR, GREEN);
    let at: Vec<f64> = (0..=60).map(|k| 0.05e-3 * 100f64.powf(f64::from(k) / 60.0)).collect();
    let curve = |f: &dyn Fn(f64) -> f64| at.iter().map(|h| (h * 1e3, 1e3 * f(*h))).collect::<Vec<_>>();
    let traced: Vec<(f64, f64)> = [0.0625e-3, 0.125e-3, 0.25e-3, 0.5e-3, 1e-3, 2e-3, 4e-3]
        .map(|h| (h * 1e3, 1e3 * traced_blur(h, lesson.seed())))
        .to_vec();
    let chart = Chart::new(axis(), Axis::log("diameter of a point's spot on the film, mm"))
        .title(&format!("A smaller hole is sharper only down to {:.2} mm: then light bends", 1e3 * sharpest))
        .subtitle(&format!(
            "film {:.0} cm behind the hole, point 2 m before it, wavelength 550 nm; traced: \
             4096 rays, seed {}",
            DEPTH * 1e2,
            lesson.seed()
        ))
        .function("both", &curve(&|h| blur(h, DEPTH, FAR, GREEN)))
        .function("shadow of the hole", &curve(&|h| shadow_blur(h, DEPTH, FAR)))
        .function("diffraction", &curve(&|h| diffraction_blur(h, DEPTH, GREEN)))
        .dots("traced rays", &traced)
        .guide(Guide::upright(1e3 * sharpest, "sharpest"))
        .better("↓ sharper");
    lesson.save("hole_blur", chart)
}

/// Diameter of the uniform disc that has the spread of traced light: `2√2` times the RMS distance
/// from its middle.
fn traced_blur(hole: f64, seed: u64) -> f64 {
    const RAYS: u32 = 4096;
    let aside = |i: u32| {
        // A point on the axis, seen from a place in the hole: shift the hole there, and back.
        let at = 0.5 * hole * uniform_disc(point2(seed, u32::MAX - 1, i));
        let film = obscura_from_camera((-at).extend(-FAR), DEPTH).unwrap_or(DVec2::ZERO) + at;
        film.length_squared()
    };
    (8.0 * (0..RAYS).map(aside).sum::<f64>() / f64::from(RAYS)).sqrt()
}

/// Forward against backward: the headline.
pub fn contest(lesson: &Lesson, methods: &[(Method, Series)]) -> Result {
    let rays: Vec<f64> = methods.iter().map(|(_, s)| rays_to(s, 0.01)).collect();
    let title =
        format!("One pixel to 1 %: {} photons forwards, {} rays backwards", short(rays[0]), rays[3].ceil());
    let subtitle = format!(
        "irradiance of 2 cm of film through a hole of 2 cm, against the closed form; {REPETITIONS} runs a \
             point, seed {}",
        lesson.seed()
    );
    let mut time =
        Chart::speed_accuracy("relative error of the irradiance").title(&title).subtitle(&subtitle);
    let mut work = Chart::work_accuracy("photons or rays traced", "relative error of the irradiance")
        .title(&title)
        .subtitle(&subtitle);
    for (method, series) in methods {
        time = time.line(method.clone(), series);
        work = work.line(method.clone(), series);
    }
    lesson.save("error_over_rays", time.guide(Guide::slope(-0.5, "slope −½")))?;
    lesson.save("error_over_work", work.guide(Guide::slope(-0.5, "slope −½")))
}

/// Rays to that relative error, from the mean of `error² · rays` over the series.
pub fn rays_to(series: &Series, error: f64) -> f64 {
    let terms = series.points.iter().filter_map(|p| Some(p.error?.mid.powi(2) * p.work?));
    terms.sum::<f64>() / series.points.len() as f64 / (error * error)
}

/// Where a flat picture fails: towards 180°.
pub fn wide_angles(lesson: &Lesson) -> Result {
    let fov = Axis::linear("field of view along the diagonal, °").range(20.0, 176.0).every(20.0);
    let place = Axis::percent("way from the centre to the corner").range(0.0, 1.0);
    let map = FailureMap::new(fov, place, "centre's solid angle / pixel's", (156, 80), |fov, way| {
        Some(1.0 / solid_angle_density(dvec2(way * (0.5 * fov.to_radians()).tan(), 0.0)))
    })
    .range(1.0, 1.0e4)
    .failing_above(10.0, "a pixel sees less than a tenth");
    let edge = 2.0 * 0.1f64.cbrt().acos().to_degrees();
    let share = map.failing_share();
    let map = map
        .title(&format!("Flat film fails towards 180°: past {edge:.0}° corners see under a tenth"))
        .subtitle(&format!(
            "solid angle of a pixel: cos³θ of the centre's; {:.0} % of the map fail",
            share * 100.0
        ));
    lesson.save("wide_map", map)?;

    let (width, height) = (364, 260);
    let mut panels = Panels::new()
        .columns(3)
        .title("Flat film draws out round dots towards its edge")
        .subtitle(
            "dots of the sky, 10° wide, every 15°; at θ from the axis a length grows by 1/cos θ round \
             it, by 1/cos²θ away from it",
        )
        .alt(
            "Three views of a sky with equal round dots, 60, 100 and 140 degrees wide. The dots stay round \
             in the middle; towards the edge they \
              are drawn out, at 140 degrees into long streaks.",
        );
    for angle in [60.0f64, 100.0, 140.0] {
        let camera =
            Camera::new(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, FieldOfView::Horizontal(angle.to_radians()))
                .expect("an angle below 180°");
        let image = Image::from_fn(width, height, |i, j| {
            let of = |k: u32| {
                stage::dotted_sky(
                    camera
                        .ray(
                            dvec2(i as f64, j as f64)
                                + dvec2(f64::from(k % 2) + 0.5, f64::from(k / 2) + 0.5) / 2.0,
                            width,
                            height,
                        )
                        .direction,
                )
            };
            (0..4).map(of).sum::<DVec3>() / 4.0
        });
        let density = solid_angle_density(dvec2(1.0, 0.0) * (0.5 * angle.to_radians()).tan());
        panels = panels.picture(
            Pixels::from(&image),
            &format!("{angle}°: cos³θ = {:.1} % at the edge", 100.0 * density),
        );
    }
    let caption = "The picture is right if seen from the pinhole's place; from farther away it looks \
         stretched. At 180° the film would have no end.";
    lesson.save("wide", Figure::from(panels).caption(caption))
}
