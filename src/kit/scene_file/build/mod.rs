//! From blocks to a scene: the only place that knows what becomes of each block.

mod csg;
mod light;
mod material;
mod mesh;
mod objects;
mod transformation;

use super::blocks::MOST_PIXELS;
use super::diagnostic::{Diagnostic, Diagnostics, Severity, Span};
use super::format::Role;
use super::parse::{Block, Parsed};
use super::{Given, Settings, declared, pending};
use crate::color::Rgb;
use crate::scene::{Camera, CameraError, FieldOfView, Material, Scene};
use glam::DVec3;
use std::path::Path;

/// The scene, unless something is missing or wrong, and what was found in the files of `folder` that it names; what is
/// wrong with the scene's own text is added to the log.
pub fn build(
    source: &str,
    folder: &Path,
    parsed: &Parsed,
    log: &mut Vec<Diagnostic>,
) -> (Option<(Scene, Settings)>, Vec<Diagnostics>) {
    let mut files = Vec::new();
    (scene(source, folder, parsed, log, &mut files), files)
}

fn scene(
    source: &str,
    folder: &Path,
    parsed: &Parsed,
    log: &mut Vec<Diagnostic>,
    files: &mut Vec<Diagnostics>,
) -> Option<(Scene, Settings)> {
    let blocks = &parsed.blocks;
    declared::check(blocks, log);
    let settings_block = last(blocks, Role::Settings, log);
    let camera_block = last(blocks, Role::Camera, log);
    let settings = settings_block.map_or(Settings::default(), |b| settings(b, log));
    let camera = camera_block.and_then(|b| camera(b, log));
    let materials: Vec<_> = of(blocks, Role::is_material).map(|b| (b, material::material(b, log))).collect();
    let (objects, found) = objects::objects(blocks, folder, &materials, log, files);
    let lights: Vec<_> = of(blocks, |r| r == Role::Light).filter_map(|b| light::light(b, log)).collect();
    missing(source, parsed, log);
    let mut scene = Scene::new(camera?);
    if let Some(block) = settings_block {
        scene.background = DVec3::from(block.numbers("BackgroundColor"));
        scene.ambient = DVec3::from(block.numbers("AmbientLight"));
    }
    let remark = log.iter().all(|d| d.severity != Severity::Error); // what is wrong comes first
    log.extend(pending::note(&settings, settings_block, &materials).filter(|_| remark));
    scene.materials = materials.into_iter().map(|(_, m)| m).chain(found).collect();
    scene.objects = objects.into();
    scene.lights = lights;
    log.extend(darkness(&scene, blocks).filter(|_| remark));
    Some((scene, settings))
}

/// Was a value already found wrong as a word, so that what it names is not to be trusted?
fn is_spoilt(value: &Span, log: &[Diagnostic]) -> bool {
    let overlaps = |d: &Diagnostic| d.span.start < value.end && value.start < d.span.end;
    log.iter().any(|d| d.severity == Severity::Error && overlaps(d))
}

/// The blocks of a role, in the file's order.
fn of(blocks: &[Block], wanted: impl Fn(Role) -> bool) -> impl Iterator<Item = &Block> {
    blocks.iter().filter(move |b| wanted(b.rule.role))
}

/// The last block of a role; a warning for each before it.
fn last<'a>(blocks: &'a [Block], role: Role, log: &mut Vec<Diagnostic>) -> Option<&'a Block> {
    let last = of(blocks, |r| r == role).last()?;
    for earlier in of(blocks, |r| r == role).filter(|b| b.keyword != last.keyword) {
        let message = format!(
            "`{}` in line {} has no effect: the one in line {} replaces it",
            earlier.rule.name, earlier.line, last.line
        );
        log.push(
            Diagnostic::warning(earlier.keyword.clone(), message)
                .related(last.keyword.clone(), "this one counts"),
        );
    }
    Some(last)
}

/// What a scene cannot do without.
fn missing(source: &str, parsed: &Parsed, log: &mut Vec<Diagnostic>) {
    if parsed.lost > 0 {
        return; // it may stand in what could not be understood
    }
    let end = source.trim_end().len();
    let end = end..source[end..].chars().next().map_or(end, |c| end + c.len_utf8());
    if parsed.blocks.is_empty() {
        let d = Diagnostic::error(end, "this file holds no scene");
        log.push(d.expected("blocks: a `Camera`, and at least one object, such as a `Sphere`"));
        return;
    }
    for (role, article, what, example) in [
        (Role::Camera, "a", "camera", "`Camera { POV 0 1 5  POI 0 0 0 }`"),
        (Role::Object, "an", "object", "`Sphere { Material …  Radius 1 }`"),
    ] {
        if of(&parsed.blocks, |r| r == role).next().is_none() {
            let d = Diagnostic::error(end.clone(), format!("the scene has no {what}"));
            log.push(
                d.expected(format!("{article} {what} before the end of the file"))
                    .help(format!("such as {example}")),
            );
        }
    }
}

/// A warning if nothing shines on anything.
fn darkness(scene: &Scene, blocks: &[Block]) -> Option<Diagnostic> {
    let shines = |m: &Material| m.emissive != Rgb::ZERO;
    if !scene.lights.is_empty() || scene.ambient != Rgb::ZERO || scene.materials.iter().any(shines) {
        return None;
    }
    let first = of(blocks, |r| r == Role::Object).next()?;
    let d = Diagnostic::warning(first.keyword.clone(), "nothing is lit: the scene has no light");
    Some(d.help("add a `PointLight`, a `DirectionalLight` or an `AreaLight`"))
}

fn natural(n: i64) -> u32 {
    u32::try_from(n).unwrap_or(0) // the table keeps it in range
}

fn settings(block: &Block, log: &mut Vec<Diagnostic>) -> Settings {
    let one = |name: &str| natural(block.integers::<1>(name)[0]);
    let given = |name: &str| block.entry(name).is_some();
    let mut settings = Settings {
        width: one("RenderWidth"),
        height: one("RenderHeight"),
        samples: Settings::default().samples,
        reflection_quality: one("ReflectionQuality"),
        reflection_steps: one("ReflectionSteps"),
        indirect_quality: one("IndirectQuality"),
        color_bleeding: block.numbers::<1>("ColorBleeding")[0],
        given: Given {
            width: given("RenderWidth"),
            height: given("RenderHeight"),
            samples: given("Antialiasing"),
        },
    };
    match block.integers("Antialiasing") {
        [n @ (1 | 4 | 16)] => settings.samples = natural(n),
        [n] => {
            let message = format!("`Antialiasing {n}` is read as {}, the default", settings.samples);
            log.push(
                Diagnostic::warning(block.span("Antialiasing"), message)
                    .expected("1, 4 or 16")
                    .found(format!("`{n}`")),
            );
        }
    }
    let pixels = u64::from(settings.width) * u64::from(settings.height);
    if pixels > MOST_PIXELS {
        let message = format!("the picture has {pixels} pixels");
        log.push(
            Diagnostic::error(block.span(later(block, "RenderWidth", "RenderHeight")), message)
                .expected(format!("at most {MOST_PIXELS}"))
                .found(format!("{} × {}", settings.width, settings.height)),
        );
    }
    settings
}

/// Of two parameters, the one that stands further down.
fn later<'n>(block: &Block, a: &'n str, b: &'n str) -> &'n str {
    let at = |name| block.entry(name).map_or(0, |e: &super::parse::Entry| e.keyword.start);
    if at(a) > at(b) { a } else { b }
}

fn camera(block: &Block, log: &mut Vec<Diagnostic>) -> Option<Camera> {
    if block.is_broken() {
        return None;
    }
    let [fov] = block.numbers("FOV");
    let [position, target, up] = ["POV", "POI", "Up"].map(|name| DVec3::from(block.numbers(name)));
    match Camera::new(position, target, up, FieldOfView::Vertical(fov.to_radians())) {
        Ok(camera) => Some(camera),
        Err(error) => {
            let d = match error {
                CameraError::FieldOfView(_) => Diagnostic::error(block.span("FOV"), error.to_string()),
                CameraError::Frame(_) => Diagnostic::error(
                    block.span(later(block, "POV", "POI")),
                    "`POV` and `POI` are the same point",
                )
                .expected("two points: where the camera stands, and where it looks")
                .found(format!("{} twice", point(position))),
            };
            log.push(d);
            None
        }
    }
}

fn point(p: DVec3) -> String {
    format!("({}, {}, {})", p.x, p.y, p.z)
}

impl Role {
    fn is_material(self) -> bool {
        self == Role::Named(super::format::Names::Material)
    }
}
