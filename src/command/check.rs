//! `lightbench check`: is this scene file right, and what is in it?

use super::target;
use lightbench::light::Light;
use lightbench_kit::scene_file::{Color, SceneFile, csg, read_file};
use std::path::Path;

/// What there is to say about a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CheckReport {
    /// Every finding, in order of place; and a summary if the file is right.
    pub text: String,
    /// Number of errors: 0 for a file that can be drawn.
    pub problems: usize,
}

/// Reads a scene file and says everything that can be said about it without drawing it.
pub fn check(path: &Path, color: Color) -> CheckReport {
    if path.extension().is_some_and(|e| e == "csg") {
        return check_csg(path, color);
    }
    if let Err(failure) = target::scene(path) {
        return CheckReport { text: failure.message + "\n", problems: 1 };
    }
    match read_file(path) {
        Ok(file) => {
            let text = file.remarks.render(color) + &summary(&path.display().to_string(), &file);
            CheckReport { text, problems: 0 }
        }
        Err(error) => {
            let problems = error.problems();
            let text = error.render(color) + &format!("{}: {}\n", path.display(), counted(problems, "error"));
            CheckReport { text, problems }
        }
    }
}

/// Reads a tree of solids, says everything that can be said about it, and shows it.
fn check_csg(path: &Path, color: Color) -> CheckReport {
    let name = path.display();
    let file = match csg::read_file(path) {
        Ok(file) => file,
        Err(error) => {
            let problems = error.problems();
            let text = error.render(color) + &format!("{name}: {}\n", counted(problems, "error"));
            return CheckReport { text, problems };
        }
    };
    let problems = file.remarks.errors().count();
    let verdict = if problems == 0 { "right".to_string() } else { counted(problems, "error") };
    let (operations, solids) = file.counts();
    let counts = format!("{}, {}", counted(operations, "operation"), counted(solids, "solid"));
    let text = format!("{}{name}: {verdict}\n  {counts}\n{}", file.remarks.render(color), file.outline());
    CheckReport { text, problems }
}

/// What is in a right file, in a few lines.
fn summary(name: &str, file: &SceneFile) -> String {
    let (scene, settings) = (&file.scene, &file.settings);
    let areas = scene.lights.iter().filter(|l| matches!(l, Light::Area(_))).count();
    let diffuse = scene.materials.iter().filter(|m| m.model.is_none()).count();
    format!(
        "{name}: right\n  {}, {} ({diffuse} with `Model lambert`), {} ({} without size, {areas} with area)\n  {} × {} pixels, {} each; \
         local illumination shoots up to {} per pixel\n",
        counted(scene.objects.len(), "object"),
        counted(scene.materials.len(), "material"),
        counted(scene.lights.len(), "light"),
        scene.lights.len() - areas,
        settings.width,
        settings.height,
        counted(settings.samples as usize, "sample"),
        counted(usize::try_from(file.rays_per_pixel()).unwrap_or(usize::MAX), "ray"),
    )
}

/// `1 object`, `2 objects`.
pub(super) fn counted(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}
