//! Where results go: what `--out` means, and whether a file can be written there, found out before the work.

use super::Failure;
use std::fs;
use std::path::{Path, PathBuf};

/// Endings of pictures and drawings: a name with one of them is meant as a file, even where no such file is written.
const PICTURES: &[&str] = &[
    "bmp", "exr", "gif", "hdr", "jpeg", "jpg", "pbm", "pdf", "pfm", "pgm", "pic", "png", "pnm", "ppm", "qoi",
    "svg", "tga", "tif", "tiff", "webp",
];

/// What `--out` names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Out {
    Folder(PathBuf),
    File(PathBuf),
}

/// A path with one of the endings is a file, any other a folder; without `--out`, the folder `out`. The ending of a
/// picture that is not written here is a mistake, and not the name of a folder.
pub(super) fn named(out: Option<&Path>, endings: &[&str]) -> Result<Out, Failure> {
    let Some(out) = out else { return Ok(Out::Folder(PathBuf::from("out"))) };
    let ending = ending(out);
    if out.as_os_str().as_encoded_bytes().ends_with(b"/") {
        return Ok(Out::Folder(out.to_path_buf())); // `pictures.png/`
    }
    if endings.contains(&ending.as_str()) {
        return Ok(Out::File(out.to_path_buf()));
    }
    if PICTURES.contains(&ending.as_str()) && !out.is_dir() {
        return Err(unknown_ending("--out", out, endings));
    }
    Ok(Out::Folder(out.to_path_buf()))
}

/// The file that `--name` and `--out` name together: a name without a known ending gets the first of them.
pub(super) fn in_folder(out: Option<&Path>, name: &str, endings: &[&str]) -> Result<PathBuf, Failure> {
    let path = Path::new(name);
    if path.file_name() != Some(path.as_os_str()) {
        let expected = "expected the name of a file without folders (those are for --out)";
        return Err(Failure::input(format!("--name `{name}`: {expected}")));
    }
    let folder = match named(out, endings)? {
        Out::Folder(folder) => folder,
        Out::File(file) => {
            let file = file.display();
            return Err(Failure::input(format!(
                "--name {name}: expected --out to be a folder, found the file {file}"
            )));
        }
    };
    let ending = ending(path);
    if endings.contains(&ending.as_str()) {
        return Ok(folder.join(name));
    }
    if PICTURES.contains(&ending.as_str()) {
        return Err(unknown_ending("--name", path, endings));
    }
    Ok(folder.join(format!("{name}.{}", endings[0])))
}

/// The refusal of a file name's ending.
pub(super) fn unknown_ending(flag: &str, name: &Path, endings: &[&str]) -> Failure {
    let expected = endings.join(", .");
    Failure::input(format!("{flag} {}: expected one of the endings .{expected}", name.display()))
}

/// Refuses a file that is no scene by its ending, and says what it is for.
pub(super) fn scene(file: &Path) -> Result<(), Failure> {
    let is = match ending(file).as_str() {
        "csg" => {
            "a tree of solids, which a scene names: `CSG { Material …  Source \"…\" }` (`check` takes it alone)"
        }
        "obj" => "a mesh, which a scene names: `Mesh { Material …  Source \"…\" }`",
        "mtl" => "materials, which a mesh names",
        ending if PICTURES.contains(&ending) => "a picture (`compare` takes two)",
        _ => return Ok(()),
    };
    Err(Failure::input(format!("{}: expected a scene file, found {is}", file.display())))
}

/// The ending of a path in small letters, without the dot.
pub(super) fn ending(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_lowercase()
}

/// Finds out whether a file can be written, by a trial in its folder, or in the folder that would hold that one; leaves
/// nothing behind.
pub(super) fn writable(file: &Path) -> Result<(), Failure> {
    let refused = |why: String| Err(Failure::work(format!("{}: {why}", file.display())));
    match fs::metadata(file) {
        Ok(found) if found.is_dir() => return refused("expected a file, found a folder".to_string()),
        Ok(found) if !found.is_file() => return Ok(()), // a device or a pipe, which is written to as it is
        _ => {}
    }
    let folder = file.ancestors().skip(1).find(|f| f.as_os_str().is_empty() || f.symlink_metadata().is_ok());
    let folder = folder.filter(|f| !f.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if !folder.is_dir() {
        return refused(format!("expected a folder, found the file {}", folder.display()));
    }
    let trial = folder.join(format!(".lightbench-{}-trial.tmp", std::process::id()));
    match fs::File::create_new(&trial) {
        Ok(_) => fs::remove_file(&trial)
            .or_else(|e| refused(format!("{} cannot be changed: {e}", folder.display()))),
        Err(e) => refused(format!("cannot create a file in {}: {e}", folder.display())),
    }
}
