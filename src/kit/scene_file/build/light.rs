//! From blocks to lights.

use super::natural;
use crate::light::{
    AreaLight, Attenuation, DirectionalLight, Emission, Emitter, Light, LightError, Measure, PointLight,
    Rectangle, SpotLight,
};
use crate::sample::Pattern;
use crate::scene_file::blocks::MOST_CELLS;
use crate::scene_file::diagnostic::Diagnostic;
use crate::scene_file::parse::{Block, Entry};
use crate::shape::ShapeError;
use crate::shape::sphere::Sphere;
use crate::shape::triangle::Triangle;
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// Farthest part of a light with a surface [m]: fourth powers of distances, of which its light is made, are numbers still.
const FARTHEST: f64 = 1e70;

/// Ways to say how much light there is; a block has one at most.
const MEASURES: &[&str] = &["Color", "Intensity", "Flux", "Irradiance", "Radiance"];

/// The light of a block; none if something is wrong, which is reported.
pub fn light(block: &Block, log: &mut Vec<Diagnostic>) -> Option<Light> {
    if let Some(d) = contradiction(block) {
        log.push(d);
        return None;
    }
    if block.is_broken() || super::objects::lacks_numbers(block) {
        return None; // reported where it was read
    }
    let made = match block.rule.name {
        "PointLight" => Ok(point_light(block).into()),
        "SpotLight" => spot_light(block).map(Light::from),
        "DirectionalLight" => directional_light(block).map(Light::from),
        _ => return area_light(block, log).map(Light::from),
    };
    made.map_err(|error: LightError| log.push(Diagnostic::error(block.keyword.clone(), error.to_string())))
        .ok()
}

fn vector(block: &Block, name: &str) -> DVec3 {
    DVec3::from(block.numbers(name))
}

fn angle(block: &Block, name: &str) -> f64 {
    block.numbers::<1>(name)[0].to_radians()
}

/// Two parameters that are right alone and wrong together.
fn contradiction(block: &Block) -> Option<Diagnostic> {
    let written = |name: &&str| block.entry(name);
    let mut measures: Vec<&Entry> = MEASURES.iter().filter_map(written).collect();
    measures.sort_by_key(|e| e.keyword.start);
    let name = block.rule.name;
    if let [first, second, ..] = measures[..] {
        let (a, b) = if second.param.name == "Color" { (second, first) } else { (first, second) };
        let message = format!("`{name}` has both `{}` and `{}`", a.param.name, b.param.name);
        return Some(
            Diagnostic::error(second.keyword.clone(), message)
                .expected("one of them")
                .related(first.keyword.clone(), "the other is given here"),
        );
    }
    let radiometric = measures.first().filter(|e| e.param.name != "Color");
    let clash = |other: &Entry, message: String, expected: &str| {
        let d = Diagnostic::error(other.keyword.clone(), message).expected(expected.to_owned());
        Some(match radiometric {
            Some(measure) => d.related(measure.keyword.clone(), "this is the measure"),
            None => d,
        })
    };
    if let (Some(attenuation), Some(measure)) = (block.entry("Attenuation"), radiometric) {
        let message = format!("`{}` thins out by itself, without `Attenuation`", measure.param.name);
        return clash(attenuation, message, "`Color` with it");
    }
    if let (Some(cap), None) = (block.entry("AttenuationCap"), block.entry("Attenuation")) {
        let wanted =
            if radiometric.is_some() { "`Color` and an `Attenuation` with it" } else { "an `Attenuation`" };
        return clash(cap, "`AttenuationCap` caps nothing".into(), wanted);
    }
    let by_angle = block.entry("Sampling").filter(|_| block.word("Sampling") == Some("solid-angle"));
    if let (Some(sampling), None) = (by_angle, radiometric) {
        let message = "a light with `Color` is a mean over its area".into();
        return clash(sampling, message, "`Sampling area`, or `Radiance` instead of `Color`");
    }
    if block.entry("Attenuation").is_some_and(|e| e.value.is_some())
        && block.numbers("Attenuation") == [0.0; 3]
    {
        let d = Diagnostic::error(block.span("Attenuation"), LightError::NoAttenuation.to_string());
        return Some(d.expected("3 numbers ≥ 0, one of them above 0").found("three times 0"));
    }
    if block.is_broken() {
        return None; // what cannot be read is not to be compared
    }
    let (full, edge) = (block.entry("FullAngle")?, block.numbers::<1>("Angle")[0]);
    let [found] = block.numbers("FullAngle");
    let d = Diagnostic::error(full.span.clone(), "the full cone is wider than the cone");
    let d = d.expected(format!("at most Angle, {edge}")).found(found.to_string());
    (found > edge).then_some(d)
}

fn attenuation(block: &Block) -> Attenuation {
    let law = match block.entry("Attenuation") {
        Some(_) => Attenuation::polynomial(block.numbers("Attenuation")).unwrap_or_default(),
        None => Attenuation::None,
    };
    match block.entry("AttenuationCap") {
        Some(_) => law.capped(block.numbers::<1>("AttenuationCap")[0]),
        None => law,
    }
}

fn point_light(block: &Block) -> PointLight {
    let position = vector(block, "Position");
    let given = |name| block.entry(name).is_some();
    if given("Intensity") {
        PointLight::of_intensity(position, vector(block, "Intensity"))
    } else if given("Flux") {
        PointLight::of_flux(position, vector(block, "Flux"))
    } else {
        PointLight::of_color(position, vector(block, "Color")).with_attenuation(attenuation(block))
    }
}

fn spot_light(block: &Block) -> Result<SpotLight, LightError> {
    let edge = angle(block, "Angle").min(PI);
    let full = match block.entry("FullAngle") {
        Some(_) => angle(block, "FullAngle").min(edge),
        None => edge * (2.0 / 3.0),
    };
    SpotLight::new(point_light(block), vector(block, "Direction"), full, edge)
}

fn directional_light(block: &Block) -> Result<DirectionalLight, LightError> {
    let direction = vector(block, "Direction");
    match block.entry("Irradiance") {
        Some(_) => DirectionalLight::new(direction, vector(block, "Irradiance")),
        None => DirectionalLight::of_color(direction, vector(block, "Color")),
    }
}

/// Why there is no surface.
enum Wrong {
    Light(LightError),
    Shape(ShapeError),
}

fn emitter(block: &Block) -> Result<Emitter, Wrong> {
    match block.rule.name {
        "TriangleLight" => {
            let [v0, v1, v2] = ["V0", "V1", "V2"].map(|name| vector(block, name));
            Triangle::new(v0, v1, v2).map(Emitter::from).map_err(Wrong::Shape)
        }
        "SphereLight" => {
            let [radius] = block.numbers("Radius");
            Sphere::new(vector(block, "Center"), radius).map(Emitter::from).map_err(Wrong::Shape)
        }
        _ => {
            let [[width], [height], [roll]] =
                ["Width", "Height", "RollAngle"].map(|name| block.numbers(name));
            let (center, direction) = (vector(block, "Position"), vector(block, "Direction"));
            let rectangle = Rectangle::facing(center, direction, roll, DVec2::new(width, height));
            rectangle.map(Emitter::from).map_err(Wrong::Light)
        }
    }
}

fn area_light(block: &Block, log: &mut Vec<Diagnostic>) -> Option<AreaLight> {
    let pattern = match block.word("Placement") {
        Some("grid") | None => Pattern::Centres,
        Some(word) => Pattern::from_name(word).unwrap_or(Pattern::Centres),
    };
    let emission = match block.entry("Radiance") {
        Some(_) => Emission::diffuse(vector(block, "Radiance")),
        None => Emission::Even { color: vector(block, "Color"), attenuation: attenuation(block) },
    };
    let measure = match block.word("Sampling") {
        Some("solid-angle") => Measure::SolidAngle,
        _ => Measure::Area,
    };
    let light = match emitter(block) {
        Ok(emitter) => AreaLight::new(emitter, emission).by(measure),
        Err(wrong) => {
            let message = match wrong {
                Wrong::Light(error) => error.to_string(),
                Wrong::Shape(error) => format!("this is no {}: {error}", block.rule.name),
            };
            log.push(Diagnostic::error(block.keyword.clone(), message));
            return None;
        }
    };
    let (center, radius) = light.emitter.ball();
    let reach = center.abs().max_element() + radius;
    if !(reach <= FARTHEST) {
        let d = Diagnostic::error(block.keyword.clone(), "the light is too large or too far away");
        log.push(
            d.expected(format!("all of it within {FARTHEST:e} m of the origin"))
                .found(format!("{reach:e} m")),
        );
        return None;
    }
    if block.rule.param("Subdivision").is_none() {
        return Some(light.sampled(natural(block.integers::<1>("Samples")[0]), pattern));
    }
    let [columns, rows] = block.integers("Subdivision").map(natural);
    let cells = u64::from(columns) * u64::from(rows);
    if cells > MOST_CELLS {
        let d = Diagnostic::error(block.span("Subdivision"), format!("the light has {cells} cells"));
        log.push(d.expected(format!("at most {MOST_CELLS}")).found(format!("{columns} × {rows}")));
        return None;
    }
    Some(light.subdivided(columns, rows, pattern))
}
