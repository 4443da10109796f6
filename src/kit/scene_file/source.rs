//! From a file on disk to its text.

use super::diagnostic::{Diagnostic, Diagnostics, Span};
use super::render::Color;
use super::{SceneFile, read};
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Largest scene file that is read \[bytes\]. Scenes name their meshes and textures; they do not hold them.
pub const LARGEST_FILE: u64 = 16 << 20;

/// Why no scene came out of a file.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    #[error("{}: cannot be read: {source}", path.display())]
    Unreadable { path: PathBuf, source: io::Error },
    #[error("{}: longer than {} MiB, the most that is read of such a file", path.display(), most >> 20)]
    TooLarge { path: PathBuf, most: u64 },
    #[error("{}", .0.render(Color::Never))]
    Wrong(Diagnostics),
}

impl ReadError {
    /// The whole message, for people.
    pub fn render(&self, color: Color) -> String {
        match self {
            ReadError::Wrong(diagnostics) => diagnostics.render(color),
            other => format!("{other}\n"),
        }
    }

    /// Number of errors.
    pub fn problems(&self) -> usize {
        match self {
            ReadError::Wrong(diagnostics) => {
                let of = |d: &Diagnostics| d.errors().count();
                of(diagnostics) + diagnostics.files.iter().map(of).sum::<usize>()
            }
            _ => 1,
        }
    }
}

/// Reads a scene from a file; messages call it by its path as given.
pub fn read_file(path: &Path) -> Result<SceneFile, ReadError> {
    read_bytes(&contents(path, LARGEST_FILE)?, &path.display().to_string()).map_err(ReadError::Wrong)
}

/// The bytes of a file, unless there are more than `most`.
fn contents(path: &Path, most: u64) -> Result<Vec<u8>, ReadError> {
    let unreadable = |source| ReadError::Unreadable { path: path.to_owned(), source };
    let file = File::open(path).map_err(unreadable)?;
    let mut bytes = Vec::new();
    file.take(most + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > most {
        return Err(ReadError::TooLarge { path: path.to_owned(), most });
    }
    Ok(bytes)
}

/// The text of a file of at most so many bytes.
pub(super) fn text(path: &Path, most: u64) -> Result<String, ReadError> {
    let wrong = |bytes: &[u8], at| ReadError::Wrong(not_utf8(bytes, at, &path.display().to_string()));
    String::from_utf8(contents(path, most)?).map_err(|e| wrong(e.as_bytes(), e.utf8_error().valid_up_to()))
}

/// The text of a file of at most so many bytes, and where its characters stand that are no UTF-8: such bytes are read as
/// Latin-1, each a character of its own.
///
/// - Errors: a file that cannot be read; UTF-16.
pub(super) fn text_or_latin1(path: &Path, most: u64) -> Result<(String, Vec<Span>), ReadError> {
    let bytes = contents(path, most)?;
    if matches!(bytes[..], [0xff, 0xfe, ..] | [0xfe, 0xff, ..]) {
        return Err(ReadError::Wrong(not_utf8(&bytes, 0, &path.display().to_string())));
    }
    let (mut text, mut foreign) = (String::with_capacity(bytes.len()), Vec::new());
    for chunk in bytes.utf8_chunks() {
        text.push_str(chunk.valid());
        for &byte in chunk.invalid() {
            let start = text.len();
            text.push(char::from(byte));
            foreign.push(start..text.len());
        }
    }
    Ok((text, foreign))
}

/// Reads a scene from bytes, which must be UTF-8.
pub fn read_bytes(bytes: &[u8], name: &str) -> Result<SceneFile, Diagnostics> {
    match std::str::from_utf8(bytes) {
        Ok(source) => read(source, name),
        Err(error) => Err(not_utf8(bytes, error.valid_up_to(), name)),
    }
}

fn not_utf8(bytes: &[u8], at: usize, name: &str) -> Diagnostics {
    let text = String::from_utf8_lossy(bytes); // equal to the bytes before `at`; then a replacement character
    let help = match bytes {
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => "this looks like UTF-16: save the file as UTF-8",
        _ => "save the file as UTF-8",
    };
    let span = at..at + char::REPLACEMENT_CHARACTER.len_utf8();
    let message = format!("byte {at} is not UTF-8 text");
    let d = Diagnostic::error(span, message).expected("UTF-8").found(format!("the byte 0x{:02X}", bytes[at]));
    Diagnostics::new(name, &text, vec![d.help(help)])
}
