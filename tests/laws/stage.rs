//! Laws of the stage: exposure, framing, no horizon, no dark corners, the same bytes on any threads.

use glam::{DVec2, DVec3, dvec2};
use lightbench::bsdf::Lobes;
use lightbench::color::Rgb;
use lightbench::film::tone::{KNEE, shoulder};
use lightbench::light::{Emission, Emitter, Light, polygon_irradiance};
use lightbench::measure::Z;
use lightbench::num::U;
use lightbench::ray::Silent;
use lightbench::scene::{Met, Scene};
use lightbench::shape::sphere::Sphere;
use lightbench_kit::stage::{BRIGHTEST, RenderSize, Stage, colour, material};
use std::f64::consts::PI;

const SMALL: RenderSize = RenderSize { width: 96, height: 60, cells: 1, seed: 3 };

fn with_ball(material: lightbench::scene::Material) -> Stage {
    Stage::new(DVec3::Y, 1.0).with(Sphere::new(DVec3::Y, 1.0).unwrap(), material)
}

/// Radiance of a diffuse surface in closed form, if only its own horizon hides the lights.
fn radiance(scene: &Scene, reflectance: Rgb, p: DVec3, n: DVec3) -> Rgb {
    let of = |light: &Light| match light {
        Light::Area(light) => match (&light.emitter, light.emission) {
            (Emitter::Rectangle(r), Emission::Diffuse { radiance }) => {
                radiance * polygon_irradiance(&r.corners(), p, n)
            }
            other => panic!("{other:?}"),
        },
        other => panic!("{other:?}"),
    };
    reflectance * scene.lights.iter().map(of).sum::<Rgb>() / PI
}

/// What the ray through each pixel's centre finds: object, point and normal.
fn seen(scene: &Scene, size: &RenderSize) -> Vec<Option<(usize, DVec3, DVec3)>> {
    let view = scene.camera.view(size.width, size.height);
    let find = |i: usize| {
        let ray = view.ray(dvec2((i % size.width) as f64, (i / size.width) as f64) + 0.5);
        match scene.first_met(&ray, &mut Silent)? {
            Met::Object(i, crossing) => {
                let hit = scene.hit(&ray, i, &crossing);
                Some((i, hit.point, hit.ng))
            }
            Met::Light(..) => None,
        }
    };
    (0..size.width * size.height).map(find).collect()
}

/// With a camera ray a pixel each pixel is an unbiased estimate of what its centre shows. Its noise is measured; the mean
/// may be off by Z of its standard deviations, and so may the brightest pixel.
#[test]
fn the_brightest_diffuse_pixel_shows_four_fifths() {
    let stage = with_ball(material::diffuse(colour::PAPER));
    let (scene, image) = (stage.scene(&SMALL), stage.radiance(&SMALL));
    let (mut errors, mut found, mut exact) = (Vec::new(), 0.0f64, 0.0f64);
    for (pixel, seen) in image.pixels().iter().zip(seen(&scene, &SMALL)) {
        let Some((1, p, n)) = seen else { continue };
        let truth = radiance(&scene, colour::PAPER, p, n).max_element();
        errors.push(pixel.max_element() - truth);
        (found, exact) = (found.max(pixel.max_element()), exact.max(truth));
    }
    let n = errors.len() as f64;
    assert!(n > 1000.0, "{n} pixels of the ball");
    let sigma = (errors.iter().map(|e| e * e).sum::<f64>() / n).sqrt();
    let mean = errors.iter().sum::<f64>() / n;
    assert!(mean.abs() <= Z * sigma / n.sqrt(), "mean error {mean}, sigma {sigma}");
    // The ball's pixels are 2/37 of a radius wide, and its meter's places lie 0.11 apart: together less than 0.1 from the
    // brightest point, whose light falls with the cosine there: 0.1²/2.
    assert!(exact <= BRIGHTEST * 1.005 && exact >= BRIGHTEST * 0.995, "{exact}");
    assert!((found - BRIGHTEST).abs() <= Z * sigma + 0.005 * BRIGHTEST, "{found}, sigma {sigma}");
    assert!(sigma < 0.05, "noise of {sigma}");
}

#[test]
fn an_empty_stage_has_no_horizon_no_dark_corner_and_shows_no_light() {
    for (width, height) in [(60, 60), (96, 60), (120, 50), (45, 60)] {
        for (elevation, azimuth) in [(15.0, 0.0), (20.0, 75.0), (25.0, -140.0)] {
            let size = RenderSize { width, height, ..SMALL };
            let stage = Stage::new(DVec3::new(3.0, -2.0, 5.0), 0.125);
            let scene = stage.seen_from_above(elevation).seen_from(azimuth).scene(&size);
            let shown: Vec<Rgb> = seen(&scene, &size)
                .into_iter()
                .map(|s| {
                    let (object, p, n) =
                        s.unwrap_or_else(|| panic!("{width}:{height} {elevation}: a light, or nothing"));
                    assert_eq!(object, 0);
                    radiance(&scene, colour::PAPER, p, n)
                })
                .collect();
            let darkest = shown.iter().map(|p| p.min_element()).fold(f64::INFINITY, f64::min);
            let brightest = shown.iter().map(|p| p.max_element()).fold(0.0, f64::max);
            // Paper that a corner leaves a quarter of the brightest light is still grey on a screen (0.2 is level 124 of 255).
            assert!(darkest > BRIGHTEST / 4.0 && brightest < 1.0, "{darkest} to {brightest}");
            // An edge would be a step from one row to the next; a gradient over 45 rows takes a 45th of the range each,
            // thrice that where it is steepest.
            for i in width..shown.len() {
                let step = (shown[i] - shown[i - width]).abs().max_element();
                assert!(step <= 3.0 * (brightest - darkest) / 45.0, "{step} at {i}");
            }
        }
    }
}

#[test]
fn the_subject_takes_its_part_of_the_height_and_stands_where_it_should() {
    for (width, height, portion) in [(160, 100, 0.62), (120, 120, 0.55), (200, 80, 0.7)] {
        let size = RenderSize { width, height, ..SMALL };
        let scene = with_ball(material::diffuse(colour::CLAY)).filling(portion).scene(&size);
        let seen = seen(&scene, &size);
        let is_ball = |x: usize, y: usize| matches!(seen[y * width + x], Some((1, ..)));
        let rows: Vec<usize> = (0..height).filter(|y| (0..width).any(|x| is_ball(x, *y))).collect();
        let columns: Vec<usize> = (0..width).filter(|x| (0..height).any(|y| is_ball(*x, y))).collect();
        let middle = |v: &[usize]| (v[0] + v[v.len() - 1] + 1) as f64 / 2.0;
        // A ball off the picture's centre is an ellipse: by less than 1/cos² of 8°, 2 %; and each end errs by a pixel.
        let taken = rows.len() as f64;
        assert!((taken - portion * height as f64).abs() <= 2.0 + 0.02 * taken, "{taken} of {height} rows");
        let at = DVec2::new(middle(&columns) / width as f64, middle(&rows) / height as f64);
        assert!((at - dvec2(0.43, 0.47)).abs().max_element() <= 0.02, "{at}");
    }
}

#[test]
fn the_picture_is_the_same_on_any_threads_and_at_any_scale() {
    let bits = |image: &lightbench::film::Image| -> Vec<u64> {
        image.pixels().iter().flat_map(|p| p.to_array()).map(f64::to_bits).collect()
    };
    let size = RenderSize { width: 48, height: 30, cells: 2, seed: 1 };
    let stage = with_ball(material::glossy(colour::TEAL, 0.2));
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| stage.render(&size))
    };
    let one = bits(&on(1));
    assert_eq!(one, bits(&on(3)));
    assert_eq!(one, bits(&stage.render(&size)));
    assert_ne!(one, bits(&stage.render(&RenderSize { seed: 2, ..size })), "the seed has no effect");
    // Another scale moves a shadow ray's origin by rounding only.
    let small = Stage::new(DVec3::Y * 0.001, 0.001)
        .with(Sphere::new(DVec3::Y * 0.001, 0.001).unwrap(), material::glossy(colour::TEAL, 0.2));
    let (small, large) = (small.radiance(&size), stage.radiance(&size));
    let close = |(a, b): (&Rgb, &Rgb)| (*a - *b).abs().max_element() <= 1.0e-9;
    let same = small.pixels().iter().zip(large.pixels()).filter(|pair| close(*pair)).count();
    // A shadow's edge may fall on the other side of a single ray: of 5760 hardly one.
    assert!(same + 8 >= small.pixels().len(), "{same} of {}", small.pixels().len());
}

#[test]
fn a_pixel_s_error_falls_faster_than_that_of_independent_samples() {
    let stage = with_ball(material::diffuse(colour::PAPER));
    let rms = |cells: u32| {
        let size = RenderSize { cells, ..SMALL };
        let (a, b) = (stage.radiance(&size), stage.radiance(&RenderSize { seed: 99, ..size }));
        let errors = a.pixels().iter().zip(b.pixels()).map(|(a, b)| (a.x - b.x).powi(2));
        (errors.sum::<f64>() / a.pixels().len() as f64).sqrt()
    };
    // From 8 points on the key to 128: independent ones would gain a factor of 4.
    let gain = rms(1) / rms(8);
    assert!(gain > 5.0, "{gain}");
}

#[test]
fn the_palette_is_darker_than_the_ground_and_lacquer_shines_without_making_light() {
    for c in colour::ALL {
        assert!(c.cmple(colour::PAPER).all());
        for roughness in [0.05, 0.2, 0.5, 1.0] {
            let material = material::glossy(c, roughness);
            let lobes: &Lobes = material.model.as_ref().expect("a model");
            for cos in [0.3f64, 0.6, 0.9] {
                let wo = DVec3::new((1.0 - cos * cos).sqrt(), 0.0, cos);
                let (albedo, error) = lobes.albedo(wo);
                assert!(albedo.max_element() <= 1.0 + error, "{c} {roughness} {cos}: {albedo}");
                let mirrored = lobes.eval(DVec3::new(-wo.x, 0.0, wo.z), wo);
                assert!(mirrored.x > c.x / PI * 0.9 + if roughness < 0.3 { 0.05 } else { 0.0 });
            }
        }
    }
}

#[test]
fn the_shoulder_keeps_what_is_dark_and_rolls_off_what_is_bright() {
    for i in 0..=1000 {
        let x = f64::from(i) * KNEE / 1000.0;
        assert_eq!(shoulder(x), x);
    }
    let above: Vec<f64> = (0..4000).map(|i| shoulder(KNEE + f64::from(i) / 1000.0)).collect();
    assert!(above.windows(2).all(|w| w[0] < w[1]) && above.iter().all(|y| *y < 1.0));
    // Slope 1 on both sides: over a step h the exponential leaves h²/(2 (1 − k)).
    let h = 1.0e-6;
    assert!((shoulder(KNEE + h) - KNEE - h).abs() <= h * h / (2.0 * (1.0 - KNEE)) + 4.0 * U);
    assert!((shoulder(0.8) - 0.785).abs() < 5.0e-4 && (shoulder(1.0) - 0.890).abs() < 5.0e-4);
    assert!((shoulder(2.0) - 0.996).abs() < 5.0e-4);
    assert_eq!((shoulder(f64::INFINITY), shoulder(-1.0)), (1.0, -1.0));
    assert!(shoulder(f64::NAN).is_nan());
}
