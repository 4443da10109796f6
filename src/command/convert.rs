//! `lightbench convert`: trees of solids as files of their own.

use super::target::{self, Out};
use super::{Failure, render};
use lightbench_kit::file::write_atomically;
use lightbench_kit::flags::Flags;
use lightbench_kit::scene_file::csg;
use std::path::{Path, PathBuf};

/// Writes every `CSG` of the scene files: `x.scene` with one tree makes `x.csg`, with several `x_1.csg`, `x_2.csg` ….
/// Nothing is written if anything is wrong with any of them.
pub(super) fn convert(files: &[PathBuf], flags: &Flags) -> Result<String, Failure> {
    if files.is_empty() {
        return Err(Failure::input("convert: expected scene files, found none"));
    }
    files.iter().try_for_each(|file| target::scene(file))?;
    let out = target::named(flags.out.as_deref(), &["csg"])?;
    let folder = match &out {
        Out::Folder(folder) => folder.as_path(),
        Out::File(file) => file.parent().filter(|f| !f.as_os_str().is_empty()).unwrap_or(Path::new(".")),
    };
    let mut written: Vec<(PathBuf, String)> = Vec::new();
    for file in files {
        let trees =
            csg::of_scene_file(file, folder).map_err(|e| Failure::input(e.render(render::stderr_color())))?;
        let stem = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let several = trees.len() > 1;
        for (i, tree) in (1..).zip(trees) {
            let path = match &out {
                Out::File(file) => file.clone(),
                Out::Folder(folder) if several => folder.join(format!("{stem}_{i}.csg")),
                Out::Folder(folder) => folder.join(format!("{stem}.csg")),
            };
            if written.iter().any(|(other, _)| *other == path) {
                return Err(Failure::input(format!(
                    "convert: two trees would be written to {}",
                    path.display()
                )));
            }
            written.push((path, tree));
        }
    }
    for (path, _) in &written {
        target::writable(path)?;
    }
    let mut paths = String::new();
    for (path, text) in &written {
        write_atomically(path, text.as_bytes()).map_err(Failure::work)?;
        paths.push_str(&format!("{}\n", path.display()));
    }
    Ok(paths)
}
