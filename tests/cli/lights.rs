//! Lights and reflection models from a scene file to a picture, and the rays of one pixel.

use crate::bench::Bench;

const SMALL: &str = "--width 40 --height 24 --quiet";
const STAGE: &str = "Camera { POV 0 2 6 POI 0 0.5 0 }\nMaterial { Name m MODEL }\n\
                     Plane { Material m Point 0 0 0 Normal 0 1 0 }\nSphere { Material m Center 0 1 0 Radius 1 }\n";

fn scene(model: &str, lights: &str) -> Vec<u8> {
    (STAGE.replace("MODEL", model) + lights).into_bytes()
}

/// Every kind of light and every model reads, is summed up, and draws a picture of its own.
#[test]
fn every_kind_of_light_and_model_is_checked_and_rendered() {
    let bench = Bench::new("lights_all");
    let lights = [
        ("", "PointLight { Position 3 5 4 }", "1 without size, 0 with area"),
        ("", "PointLight { Position 3 5 4 Intensity 40 40 40 }", "1 without size, 0 with area"),
        ("", "PointLight { Position 3 5 4 Flux 300 300 300 }", "1 without size, 0 with area"),
        (
            "",
            "PointLight { Position 3 5 4 Color 9 9 9 Attenuation 0 0 1 AttenuationCap 0.02 }",
            "1 without size",
        ),
        (
            "",
            "SpotLight { Position 3 5 4 Direction -3 -4 -4 Angle 20 FullAngle 5 }",
            "1 without size, 0 with area",
        ),
        (
            "",
            "SpotLight { Position 3 5 4 Direction -3 -4 -4 Intensity 40 40 40 }",
            "1 without size, 0 with area",
        ),
        ("", "DirectionalLight { Direction -1 -1 0 }", "1 without size, 0 with area"),
        ("", "DirectionalLight { Direction -1 -1 1 Irradiance 2 2 2 }", "1 without size, 0 with area"),
        ("", "TriangleLight { V0 3 5 4 V1 2 5 4 V2 3 5 3 Samples 4 }", "0 without size, 1 with area"),
        ("", "TriangleLight { V0 3 5 4 V1 2 5 4 V2 3 4 3 Radiance 60 60 60 }", "0 without size, 1 with area"),
        (
            "",
            "SphereLight { Center 3 5 4 Radius 0.5 Radiance 20 20 20 Sampling solid-angle }",
            "0 without size",
        ),
        (
            "",
            "AreaLight { Position 3 5 4 Direction -3 -4 -4 Radiance 20 20 20 }",
            "0 without size, 1 with area",
        ),
        ("Model oren-nayar Slope 40", "DirectionalLight { Direction -1 -1 -1 }", "2 objects"),
        ("Model phong Exponent 30", "DirectionalLight { Direction -1 -1 -1 }", "2 objects"),
        (
            "Model phong Exponent 30 Normalisation shading",
            "DirectionalLight { Direction -1 -1 -1 }",
            "2 objects",
        ),
        ("Model blinn Exponent 30", "DirectionalLight { Direction -1 -1 -1 }", "2 objects"),
        ("Model lafortune Lobe 1 1 1 Exponent 30", "DirectionalLight { Direction -1 -1 -1 }", "2 objects"),
        ("Model cook-torrance Roughness 0.3", "DirectionalLight { Direction -1 -1 -1 }", "2 objects"),
        ("Model rough Roughness 0.3", "DirectionalLight { Direction -1 -1 -1 }", "2 objects"),
    ];
    let mut pictures: Vec<Vec<u8>> = Vec::new();
    for (i, (model, light, summary)) in lights.iter().enumerate() {
        bench.write("s.scene", &scene(model, light));
        let checked = bench.line("check s.scene").done();
        assert!(checked.out.contains("right") && checked.out.contains(summary), "{light}\n{}", checked.out);
        bench.line(&format!("render s.scene {SMALL} --format hdr")).done();
        let picture = bench.read("out/s.hdr");
        assert!(!pictures.contains(&picture), "picture {i} is that of another light: {model} {light}");
        pictures.push(picture);
    }
}

/// What is wrong with a light stops the command before a picture, at its place.
#[test]
fn a_wrong_light_is_told_where_it_stands() {
    let bench = Bench::new("lights_wrong");
    bench.write(
        "s.scene",
        &scene("", "SpotLight { Angle 10 FullAngle 20 }\nPointLight { Flux 1 1 1 Color 1 1 1 }\n"),
    );
    for command in ["check s.scene", "render s.scene"] {
        let told = bench.line(command);
        assert_eq!(told.code, Some(2), "{command}");
        for word in ["s.scene:5:32: error", "at most Angle, 10", "s.scene:6:25: error", "has both"] {
            assert!(told.err.contains(word), "`{word}` is not in\n{}", told.err);
        }
    }
    assert_eq!(bench.files(), ["s.scene"], "nothing is written");
}

/// A ray to a light without a place, or to one of the last places there are, is drawn as far as the scene goes.
#[test]
fn endless_shadow_rays_are_replayed() {
    let bench = Bench::new("lights_pixel");
    let sun = "DirectionalLight { Direction -1 -1 0 }\n";
    let ends = |lights: &str| {
        bench.write("s.scene", &scene("", lights));
        let ran = bench.line(&format!("render s.scene {SMALL} --pixel 4,20")).done();
        assert_eq!(ran.out.matches("reaches the light").count(), lights.lines().count(), "{}", ran.out);
        assert!(!ran.out.contains("inf") && !ran.out.contains("NaN"), "{}", ran.out);
        let svg = String::from_utf8(bench.read("out/s_pixel_4_20.svg")).expect("text");
        assert!(!svg.contains("inf") && !svg.contains("NaN"), "{svg}");
        svg
    };
    let drawn = |svg: &str| svg.split("<path").count();
    let (one, two) = (ends(sun), ends(&format!("{sun}PointLight {{ Position 1e300 1e300 0 }}\n")));
    // The far light's ray lies on the sun's, and everything else keeps its place.
    let lines = |svg: &str| -> Vec<String> {
        svg.lines().filter(|l| l.contains("<path")).map(str::to_owned).collect()
    };
    assert!(drawn(&one) > 3 && lines(&one).iter().all(|l| lines(&two).contains(l)), "{one}\n{two}");
}
