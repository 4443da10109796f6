//! `lightbench convert`: trees of solids as files of their own.

use super::{Failure, render};
use lightbench_kit::file::write_atomically;
use lightbench_kit::flags::Flags;
use lightbench_kit::scene_file::csg;
use std::path::PathBuf;

/// Writes every `CSG` of the scene files: `x.scene` with one tree makes `x.csg`, with several `x_1.csg`, `x_2.csg` ….
/// Nothing is written if anything is wrong with any of them.
pub(super) fn convert(files: &[PathBuf], flags: &Flags) -> Result<String, Failure> {
    if files.is_empty() {
        return Err(Failure::input("convert: expected scene files, found none"));
    }
    let mut written: Vec<(PathBuf, String)> = Vec::new();
    for file in files {
        let trees = csg::of_scene_file(file).map_err(|e| Failure::input(e.render(render::stderr_color())))?;
        let stem = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let several = trees.len() > 1;
        for (i, tree) in (1..).zip(trees) {
            let name = if several { format!("{stem}_{i}.csg") } else { format!("{stem}.csg") };
            let path = flags.out().join(name);
            if written.iter().any(|(other, _)| *other == path) {
                return Err(Failure::input(format!("convert: two files would be called {}", path.display())));
            }
            written.push((path, tree));
        }
    }
    let mut paths = String::new();
    for (path, text) in &written {
        write_atomically(path, text.as_bytes()).map_err(Failure::work)?;
        paths.push_str(&format!("{}\n", path.display()));
    }
    Ok(paths)
}
