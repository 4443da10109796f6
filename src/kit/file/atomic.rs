//! Files that appear whole or not at all.

use super::FileError;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// Writes `bytes` to `path`: into a temporary file in the same folder, which is then renamed.
///
/// Whoever reads `path` sees the old content or the new one, never a part. Missing folders are
/// created. On any error the temporary file is removed, and what stood at `path` is untouched.
/// A symbolic link is followed; a device or a pipe is written to as it is. The disk is not
/// flushed: this guards against errors and interruption of the program, not against loss of power.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    let failed = |action| move |source| FileError::Io { path: path.to_path_buf(), action, source };
    // A link's target is replaced, not the link.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    if fs::metadata(&target).is_ok_and(|m| !m.is_file() && !m.is_dir()) {
        return fs::write(&target, bytes).map_err(failed("write to it"));
    }
    let folder = match target.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    fs::create_dir_all(folder).map_err(failed("create its folder"))?;
    let (mut file, temporary) = Temporary::create(folder).map_err(failed("create a file in its folder"))?;
    file.write_all(bytes).map_err(failed("write to it"))?;
    drop(file);
    fs::rename(&temporary.0, &target).map_err(failed("put it in place"))?;
    std::mem::forget(temporary);
    Ok(())
}

/// A file that is removed when its owner goes out of scope, be it by `?` or by a panic.
struct Temporary(PathBuf);

impl Temporary {
    fn create(folder: &Path) -> io::Result<(fs::File, Temporary)> {
        static NUMBER: AtomicU64 = AtomicU64::new(0);
        loop {
            let number = NUMBER.fetch_add(1, Ordering::Relaxed);
            let path = folder.join(format!(".lightbench-{}-{number}.tmp", std::process::id()));
            match fs::File::create_new(&path) {
                // Left behind by a killed process of the same number: it is not ours, take the next name.
                Err(e) if e.kind() == io::ErrorKind::AlreadyExists => {}
                other => return other.map(|file| (file, Temporary(path))),
            }
        }
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        // Nothing can be done about a failure here, and the first error is the one to report.
        let _ = fs::remove_file(&self.0);
    }
}
