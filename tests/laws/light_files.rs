//! Lights and reflection models in scene files: every value arrives in its unit, every contradiction is told once, at
//! its place.

use glam::{DVec2, DVec3, dvec3};
use lightbench::bsdf::{Blinn, BlinnScale, Lambert, Lobes, OrenNayar, OrenNayarForm, Phong, PhongScale};
use lightbench::color::Rgb;
use lightbench::integrator::Local;
use lightbench::light::{
    AreaLight, Attenuation, DirectionalLight, Emission, Light, Measure, PointLight, SpotLight,
};
use lightbench::render::{Picture, render, replay};
use lightbench::sample::Pattern;
use lightbench::scene::Material;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::triangle::Triangle;
use lightbench_kit::scene_file::{Color, SceneFile, Severity, read};
use std::f64::consts::{FRAC_1_PI, PI};

/// A small right scene on three lines; the tests add theirs from line 4 on.
const BASE: &str = "Camera { }\nMaterial { Name m Roughness 0 SpecularColor 0 0 0 }\nSphere { Material m }\n";

fn right(block: &str) -> SceneFile {
    match read(&format!("{BASE}{block}"), "t.scene") {
        Ok(file) => file,
        Err(d) => panic!("{}", d.render(Color::Never)),
    }
}

fn lights(blocks: &str) -> Vec<Light> {
    right(blocks).scene.lights
}

/// The material that a block makes, without its name.
fn material(parameters: &str) -> Material {
    let mut materials = right(&format!("Material {{ Name a {parameters} }}")).scene.materials;
    Material { name: String::new(), ..materials.swap_remove(1) }
}

const P: DVec3 = dvec3(1.0, 2.0, 3.0);
const C: DVec3 = dvec3(4.0, 5.0, 6.0);

#[test]
fn point_lights_arrive_in_their_units() {
    let fall = |a, b, c| Attenuation::polynomial([a, b, c]).expect("a law");
    let told = lights(
        "PointLight { Position 1 2 3 Color 4 5 6 }
         PointLight { Position 1 2 3 Intensity 4 5 6 }
         PointLight { Position 1 2 3 Flux 4 5 6 }
         PointLight { Position 1 2 3 Color 4 5 6 Attenuation 1 .5 .25 }
         PointLight { Position 1 2 3 Attenuation 0 0 1 AttenuationCap 2 Color 4 5 6 }
         PointLight { }",
    );
    let expected = [
        PointLight::of_color(P, C),
        PointLight::of_intensity(P, C),
        PointLight::of_flux(P, C),
        PointLight::of_color(P, C).with_attenuation(fall(1.0, 0.5, 0.25)),
        PointLight::of_color(P, C).with_attenuation(Attenuation::InverseSquare.capped(2.0)),
        PointLight::of_color(DVec3::ZERO, DVec3::ONE),
    ];
    assert_eq!(told, expected.map(Light::from));
    // What the units mean, two metres off along x: π c; I/d²; Φ/(4π d²); π c/(1 + 1 + 1); π c · min(2, ¼).
    let irradiance = |light: &Light| light.arriving(P + 2.0 * DVec3::X).expect("one ray").irradiance.x;
    let means = [4.0 * PI, 1.0, 0.25 * FRAC_1_PI, 4.0 * PI / 3.0, PI];
    for (light, means) in told.iter().zip(means) {
        let found = irradiance(light);
        assert!((found - means).abs() <= 8.0 * f64::EPSILON * means, "{found} {means}"); // 8 roundings
    }
}

#[test]
fn spots_and_parallel_light_arrive_in_their_units() {
    let told = lights(
        "SpotLight { Position 1 2 3 Direction 0 0 -2 Angle 40 FullAngle 10 Intensity 4 5 6 }
         SpotLight { Position 1 2 3 Color 4 5 6 }
         SpotLight { Angle 180 FullAngle 180 Attenuation 1 0 0 AttenuationCap .5 }
         DirectionalLight { Direction -1 -1 0 Color 4 5 6 }
         DirectionalLight { Irradiance 4 5 6 Direction 0 0 1e-200 }
         DirectionalLight { }",
    );
    let spot = |point, direction, full: f64, edge: f64| {
        SpotLight::new(point, direction, full.to_radians(), edge.to_radians()).expect("a cone").into()
    };
    let dim = Attenuation::polynomial([1.0, 0.0, 0.0]).expect("a law").capped(0.5);
    let everywhere = PointLight::of_color(DVec3::ZERO, DVec3::ONE).with_attenuation(dim);
    let expected: [Light; 6] = [
        spot(PointLight::of_intensity(P, C), DVec3::NEG_Z, 10.0, 40.0),
        spot(PointLight::of_color(P, C), DVec3::NEG_Y, 20.0, 30.0),
        spot(everywhere, DVec3::NEG_Y, 180.0, 180.0),
        DirectionalLight::of_color(dvec3(-1.0, -1.0, 0.0), C).expect("a direction").into(),
        DirectionalLight::new(DVec3::Z, C).expect("a direction").into(),
        DirectionalLight::of_color(DVec3::NEG_Y, DVec3::ONE).expect("a direction").into(),
    ];
    assert_eq!(told.len(), expected.len());
    for (told, expected) in told.iter().zip(&expected) {
        let (Light::Spot(a), Light::Spot(b)) = (told, expected) else {
            assert_eq!(told, expected);
            continue;
        };
        // Two thirds of an angle in degrees or in radians: one rounding apart.
        assert_eq!((a.point(), a.axis()), (b.point(), b.axis()));
        let (a, b) = (a.solid_angle(), b.solid_angle());
        assert!((a - b).abs() <= 8.0 * f64::EPSILON * b, "{a} {b}");
    }
}

#[test]
fn lights_with_a_surface_arrive_in_their_units() {
    let told = lights(
        "TriangleLight { V0 0 0 0 V1 2 0 0 V2 0 3 0 }
         TriangleLight { V0 0 0 0 V1 2 0 0 V2 0 3 0 Color 4 5 6 Attenuation 1 0 0.5 AttenuationCap 3 Samples 7
           Placement sobol }
         TriangleLight { V0 0 0 0 V1 2 0 0 V2 0 3 0 Radiance 4 5 6 Sampling solid-angle Placement random }
         SphereLight { }
         SphereLight { Center 1 2 3 Radius 2.5 Radiance 4 5 6 Samples 65536 Placement r2 Sampling solid-angle }
         AreaLight { Radiance 4 5 6 Sampling solid-angle Placement grid Subdivision 2 3 }
         AreaLight { Color 4 5 6 Attenuation 0 1 0 }",
    );
    let triangle = Triangle::new(DVec3::ZERO, 2.0 * DVec3::X, 3.0 * DVec3::Y).expect("a triangle");
    let sphere = |center, radius| Sphere::new(center, radius).expect("a sphere");
    let falls = |a, most: f64| Attenuation::polynomial(a).expect("a law").capped(most);
    let even = |attenuation| Emission::Even { color: C, attenuation };
    let square = |emission| {
        AreaLight::rectangle(DVec3::ZERO, DVec3::NEG_Y, 0.0, DVec2::ONE, emission).expect("a square")
    };
    let expected = [
        AreaLight::new(triangle, Emission::even(Rgb::ONE)).sampled(16, Pattern::Sobol),
        AreaLight::new(triangle, even(falls([1.0, 0.0, 0.5], 3.0))).sampled(7, Pattern::Sobol),
        AreaLight::new(triangle, Emission::diffuse(C)).by(Measure::SolidAngle).sampled(16, Pattern::Random),
        AreaLight::new(sphere(DVec3::ZERO, 1.0), Emission::even(Rgb::ONE))
            .sampled(16, Pattern::Sobol)
            .by(Measure::SolidAngle),
        AreaLight::new(sphere(P, 2.5), Emission::diffuse(C))
            .by(Measure::SolidAngle)
            .sampled(65_536, Pattern::R2),
        square(Emission::diffuse(C)).by(Measure::SolidAngle).subdivided(2, 3, Pattern::Centres),
        square(even(falls([0.0, 1.0, 0.0], f64::INFINITY))).subdivided(5, 5, Pattern::Centres),
    ];
    assert_eq!(told, expected.map(Light::Area));
}

#[test]
fn reflection_models_arrive_with_their_parameters() {
    let plain = material("");
    assert_eq!(plain.model, None);
    assert_eq!(material("Model lambert"), plain);
    let colors = "DiffuseColor .5 .25 .125 SpecularColor .25 .5 .0625";
    let (diffuse, specular) = (dvec3(0.5, 0.25, 0.125), dvec3(0.25, 0.5, 0.0625));
    let lambert = || (diffuse, Lambert::new(1.0).expect("white").into());
    let phong = |scale| Phong::new(7.0).expect("a lobe").scaled(scale).into();
    let blinn = |scale| Blinn::new(7.0).expect("a lobe").scaled(scale).into();
    let cases = [
        ("phong Exponent 7", phong(PhongScale::Normalised)),
        ("phong Exponent 7 Normalisation energy", phong(PhongScale::Normalised)),
        ("phong Exponent 7 Normalisation none", phong(PhongScale::Raw)),
        ("phong Exponent 7 Normalisation shading", phong(PhongScale::OverCosine)),
        ("blinn Exponent 7", blinn(BlinnScale::Exact)),
        ("blinn Exponent 7 Normalisation none", blinn(BlinnScale::Raw)),
        ("blinn Exponent 7 Normalisation shading", blinn(BlinnScale::OverCosine)),
    ];
    for (told, lobe) in cases {
        let expected = Lobes::new([lambert(), (specular, lobe)]).expect("a model");
        assert_eq!(material(&format!("{colors} Model {told}")).model, Some(expected), "{told}");
    }
    let rough = OrenNayar::new(1.0, 20f64.to_radians(), OrenNayarForm::Qualitative).expect("a model");
    let expected = Lobes::new([(diffuse, rough.into())]).expect("a model");
    assert_eq!(material(&format!("{colors} Model oren-nayar Slope 20")).model, Some(expected));
    let expected = Lobes::matt_and_glossy(diffuse, specular, 0.25).expect("a model");
    assert_eq!(material(&format!("{colors} Model rough Roughness .25")).model, Some(expected));
    // Each choice makes another model.
    let choices = [
        "lafortune Exponent 7",
        "lafortune Lobe 1 1 1 Exponent 7",
        "oren-nayar Slope 20 Form full",
        "cook-torrance Roughness .25",
        "cook-torrance Roughness .25 Facets beckmann",
        "cook-torrance Roughness .25 Shadowing v-cavity",
        "cook-torrance Roughness .25 FacetIndex .2 3",
    ];
    let models = choices.map(|m| material(&format!("{colors} Model {m}")).model.expect("a model"));
    for (i, model) in models.iter().enumerate() {
        assert!(!models[..i].contains(model), "{} is what another choice is", choices[i]);
    }
}

/// One error, where it is said to stand (line 4), that says these words.
#[track_caller]
fn one_error(block: &str, column: usize, words: &[&str]) {
    let Err(d) = read(&format!("{BASE}{block}\n"), "t.scene") else {
        panic!("this was to be wrong: {block}")
    };
    let text = d.render(Color::Never);
    let errors: Vec<_> = d.errors().collect();
    assert_eq!(errors.len(), 1, "{text}");
    let place = d.place(errors[0]);
    assert_eq!((place.line, place.column), (4, column), "{text}");
    for word in words {
        assert!(text.contains(word), "`{word}` is not in\n{text}");
    }
}

/// Where a word begins in a block, in characters from 1; the first of them, or the last.
fn at(block: &str, word: &str) -> usize {
    block.rfind(word).map_or(0, |i| block[..i].chars().count() + 1)
}

#[test]
fn two_measures_contradict_each_other() {
    let triangle = "TriangleLight { V0 0 0 0 V1 1 0 0 V2 0 1 0";
    for (block, first, second) in [
        ("PointLight { Color 1 1 1 Intensity 2 2 2 }", "Color", "Intensity"),
        ("PointLight { Intensity 2 2 2 Color 1 1 1 }", "Intensity", "Color"),
        ("PointLight { Flux 1 1 1 Position 1 1 1 Intensity 2 2 2 }", "Flux", "Intensity"),
        ("SpotLight { Color 1 1 1 Intensity 2 2 2 }", "Color", "Intensity"),
        ("DirectionalLight { Irradiance 1 1 1 Color 2 2 2 }", "Irradiance", "Color"),
        ("AreaLight { Radiance 1 1 1 Color 2 2 2 }", "Radiance", "Color"),
        ("SphereLight { Radiance 1 1 1 Color 2 2 2 }", "Radiance", "Color"),
        (&format!("{triangle} Radiance 1 1 1 Color 2 2 2 }}"), "Radiance", "Color"),
    ] {
        let (a, b) = if second == "Color" { (second, first) } else { (first, second) };
        let both = format!("has both `{a}` and `{b}`");
        one_error(block, at(block, second), &[&both, "expected one of them", "the other is given here"]);
    }
}

#[test]
fn attenuation_goes_with_the_measure_that_does_not_thin_out() {
    for (block, measure) in [
        ("PointLight { Intensity 1 1 1 Attenuation 1 0 0 }", "Intensity"),
        ("PointLight { Attenuation 1 0 0 AttenuationCap 1 Flux 1 1 1 }", "Flux"),
        ("SpotLight { Attenuation 1 0 0 Intensity 1 1 1 }", "Intensity"),
        ("AreaLight { Radiance 1 1 1 Attenuation 1 0 0 }", "Radiance"),
        ("SphereLight { Radiance 1 1 1 Attenuation 1 0 0 }", "Radiance"),
    ] {
        let thins = format!("`{measure}` thins out by itself");
        one_error(block, at(block, "Attenuation "), &[&thins, "this is the measure", "expected `Color`"]);
    }
    let capped = "PointLight { AttenuationCap 1 }";
    one_error(capped, 14, &["caps nothing", "expected an `Attenuation`"]);
    let capped = "PointLight { Flux 1 1 1 AttenuationCap 1 }";
    one_error(capped, at(capped, "AttenuationCap"), &["caps nothing", "`Color` and an `Attenuation`"]);
    let none = "SpotLight { Attenuation 0 0 0 }";
    one_error(none, at(none, "0 0 0"), &["one of them above 0", "three times 0"]);
    let none = "PointLight { Attenuation -0 0 0e5 Color 1 1 1 }";
    one_error(none, at(none, "-0"), &["one of them above 0"]);
    let negative = "PointLight { Attenuation 0 -1 2 }";
    one_error(negative, at(negative, "-1"), &["≥ 0", "`-1`"]);
    let cap = "PointLight { Attenuation 0 0 1 AttenuationCap 0 }";
    one_error(cap, at(cap, "0 }"), &["`AttenuationCap` is out of range", "> 0"]);
}

#[test]
fn surfaces_cones_and_samples_that_cannot_be() {
    let wide = "SpotLight { Angle 20 FullAngle 30 }";
    one_error(wide, at(wide, "30"), &["wider than the cone", "at most Angle, 20", "found 30"]);
    let wide = "SpotLight { FullAngle 30.5 }"; // the cone's default is 30
    one_error(wide, at(wide, "30.5"), &["at most Angle, 30", "found 30.5"]);
    let unread = "SpotLight { FullAngle 40 Angle x }";
    one_error(unread, at(unread, "x"), &["`x` is not a number"]);
    let zero = "SpotLight { Angle 0 }";
    one_error(zero, at(zero, "0"), &["[0.1, 180]"]);
    for block in ["SpotLight { Direction 0 0 0 }", "DirectionalLight { Direction 0 -0 0 }"] {
        one_error(block, at(block, "Direction ") + 10, &["`Direction` has no direction", "not all 0"]);
    }
    let line = "TriangleLight { V0 0 0 0 V1 1 1 1 V2 3 3 3 }";
    one_error(line, 1, &["this is no TriangleLight", "area above 0", "on one line"]);
    one_error("TriangleLight { V0 0 0 0 V1 1 1 1 }", 1, &["has no `V2`"]);
    let none = "SphereLight { Radius 0 }";
    one_error(none, at(none, "0 }"), &["`Radius` is out of range", "> 0"]);
    let none = "SphereLight { Samples 0 }";
    one_error(none, at(none, "0 }"), &["from 1 to 65536"]);
    let many = "AreaLight { Subdivision 1000 1000 }";
    one_error(many, at(many, "1000 1000"), &["1000000 cells", "at most 65536"]);
    for block in [
        "AreaLight { Sampling solid-angle }",
        "SphereLight { Color 1 1 1 Sampling solid-angle }",
        "TriangleLight { V0 0 0 0 V1 1 0 0 V2 0 1 0 Sampling solid-angle }",
    ] {
        one_error(block, at(block, "Sampling"), &["a mean over its area", "`Radiance` instead of `Color`"]);
    }
}

#[test]
fn materials_that_cannot_be() {
    let index = "Material { Name a Model cook-torrance FacetIndex 0 2 }";
    one_error(index, at(index, "0 2"), &["no index of refraction", "n at least 0.000001", "n = 0 and k = 2"]);
    let model = "Material { Name a Model ward }";
    one_error(model, at(model, "ward"), &["`Model` has no choice `ward`", "cook-torrance"]);
    let exponent = "Material { Name a Model phong Exponent -1 }";
    one_error(exponent, at(exponent, "-1"), &["`Exponent` is out of range", "≥ 0"]);
}

#[test]
fn what_a_model_does_not_read_is_warned_of() {
    for (block, param, by) in [
        ("Material { Name a Exponent 3 }", "Exponent", "phong, blinn, lafortune"),
        ("Material { Name a Exponent 3 Model lambert }", "Exponent", "phong, blinn, lafortune"),
        ("Material { Name a Model phong Slope 3 }", "Slope", "oren-nayar"),
        ("Material { Name a Model rough FacetIndex 0 0 }", "FacetIndex", "cook-torrance"),
    ] {
        let file = right(&format!("{block} PointLight {{ }}")); // or there is a warning of darkness, too
        let warnings: Vec<_> = file.remarks.of(Severity::Warning).collect();
        assert_eq!(warnings.len(), 1, "{block}");
        let place = file.remarks.place(warnings[0]);
        assert_eq!((place.line, place.column), (4, at(block, param)), "{block}");
        assert!(warnings[0].message.contains(&format!("`{param}` has no effect")));
        assert!(warnings[0].help.as_ref().is_some_and(|h| h.contains(by)), "{block}");
    }
    assert_eq!(
        right("Material { Name a Model phong Exponent 3 } PointLight { }").remarks.warnings().count(),
        0
    );
}

/// Whatever the table lets through makes a model whose values are numbers, and never negative.
#[test]
fn every_value_in_range_makes_a_model() {
    let mut made = 0;
    for exponent in ["0", "5e-324", "1", "1e9", "1.7e308"] {
        for lobe in ["0 0 0", "1 1 1", "-1 -1 1", "1 -1 -1", "-1 -1 1e-300"] {
            made += shows_numbers(&format!("Model lafortune Lobe {lobe} Exponent {exponent}"));
        }
        for scale in ["energy", "none", "shading"] {
            for model in ["phong", "blinn"] {
                made += shows_numbers(&format!("Model {model} Exponent {exponent} Normalisation {scale}"));
            }
        }
    }
    for roughness in ["0", "5e-324", "1e-8", "1"] {
        made += shows_numbers(&format!("Model rough Roughness {roughness}"));
        for facets in ["ggx", "beckmann"] {
            for rest in
                ["", "FacetIndex 1 0", "FacetIndex 1e-6 0", "FacetIndex 1e-6 1e6", "FacetIndex 1e6 1e6"]
            {
                made += shows_numbers(&format!(
                    "Model cook-torrance Roughness {roughness} Facets {facets} {rest}"
                ));
            }
        }
    }
    for slope in ["0", "90"] {
        for form in ["short", "full"] {
            made += shows_numbers(&format!("Model oren-nayar Slope {slope} Form {form}"));
        }
    }
    assert_eq!(made, 55 + 4 + 40 + 4);
}

fn shows_numbers(parameters: &str) -> usize {
    let model = material(parameters).model.expect("a model");
    for degrees in [0.0f64, 30.0, 89.0, 89.999_999] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        for wo in [dvec3(sin, 0.0, cos), dvec3(-sin, 0.0, cos), dvec3(0.0, sin, cos)] {
            let f = model.eval(dvec3(sin, 0.0, cos), wo);
            // A mirror of no roughness at all is infinitely bright in one direction.
            assert!(!f.is_nan() && f.min_element() >= 0.0, "{parameters} at {degrees}°: {f}");
        }
    }
    1
}

/// What overflows is told, or ends at the largest number; nothing becomes NaN.
#[test]
fn extreme_lights_are_refused_or_stay_numbers() {
    let head = "Camera { POV 0 2 6 POI 0 0.8 0 }\nMaterial { Name m DiffuseColor 0.6 0.6 0.6 }\nPlane { Material m }\n";
    for light in [
        "AreaLight { Position 0 4 0 Width 1e155 Height 1e155 Radiance 1 1 1 }",
        "SphereLight { Center 0 1e155 0 Radius 5e154 Radiance 1 1 1 }",
        "TriangleLight { V0 0 4 0 V1 1e200 4 0 V2 0 4 1e200 Radiance 1 1 1 }",
    ] {
        let wrong = read(&format!("{head}{light}\n"), "t").expect_err("an error").render(Color::Never);
        assert!(wrong.contains("t:4:1: error: the light is too large") && wrong.contains("1e70"), "{wrong}");
    }
    for light in [
        "Color 1e308 1e308 1e308 Attenuation 1e308 1e308 1e308",
        "Color 0 1 0 Attenuation 0 0 1e-320",
        "Color 1 1 0 Attenuation 0 0 5e-324",
        "Intensity 1e308 0 1",
    ] {
        let text = format!("{head}PointLight {{ Position 2 4 3 {light} }}\n");
        let scene = read(&text, "t").unwrap_or_else(|e| panic!("{}", e.render(Color::Never))).scene;
        let picture = Picture { width: 8, height: 6, samples: 1, seed: 0 };
        let image = render(&scene, &Local::default(), picture).image;
        assert!(image.pixels().iter().all(|p| !p.is_nan()), "{light}");
        let (value, _) = replay(&scene, &Local::default(), picture, (4, 4));
        assert!(!value.is_nan(), "{light}");
    }
}

/// A roughness that is written is read, or told to be without effect.
#[test]
fn a_roughness_without_effect_is_told() {
    let head = "Camera { POV 0 2 6 POI 0 0.8 0 }\nPointLight { }\n";
    let remarks = |model: &str| {
        let text =
            format!("{head}Material {{ Name m Model {model} Roughness 0.3 }}\nPlane {{ Material m }}\n");
        read(&text, "t").unwrap_or_else(|e| panic!("{}", e.render(Color::Never))).remarks.render(Color::Never)
    };
    let told = remarks("oren-nayar");
    assert!(told.contains("t:3:36: warning: `Roughness` has no effect with `Model oren-nayar`"), "{told}");
    assert!(told.contains("cook-torrance, rough"), "{told}");
    assert!(!remarks("rough").contains("warning") && !remarks("cook-torrance").contains("warning"));
}
