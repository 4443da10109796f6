//! `probe`: a library function on each row of a table.
//!
//! Students check exercises with it, and other programs check the library: a CSV with a header goes
//! in, a CSV with the answers comes out, row by row, every number printed so that it reads back exactly.

mod area_light;
mod camera;
mod colour;
mod csg;
mod julia;
mod menger;
mod reflection;
mod sphere_box;
mod surface;
mod torus;

use crate::ray::Ray;
use crate::scene_file::{quoted, quoted_name};
use glam::DVec3;
use std::fmt::Write;

/// Every topic, chapter by chapter.
pub const TOPICS: &[Topic] = &[
    colour::SRGB_TRANSFER,
    colour::COLOUR_CONVERT,
    colour::DOMINANT_WAVELENGTH,
    camera::PINHOLE,
    camera::LOOKAT,
    camera::ROTATIONS,
    camera::NORMAL_TRANSFORM,
    sphere_box::RAY_SPHERE,
    sphere_box::RAY_BOX,
    surface::RAY_TRIANGLE,
    surface::RAY_DISC,
    surface::RAY_CYLINDER,
    surface::RAY_CONE,
    surface::RAY_QUADRIC,
    torus::RAY_TORUS,
    torus::QUARTIC_ROOTS,
    csg::CSG,
    julia::JULIA_ESCAPE,
    julia::JULIA_DISTANCE,
    julia::JULIA_HIT,
    menger::RAY_MENGER,
    reflection::BRDF_VALUES,
    reflection::BRDF_ALBEDO,
    area_light::AREA_LIGHT,
];

/// A topic: one function of the library, or several methods for the same question.
pub struct Topic {
    pub name: &'static str,
    /// What is computed, in one line.
    pub about: &'static str,
    /// Names and one-line descriptions; the first is the default.
    pub methods: &'static [(&'static str, &'static str)],
    /// Input columns and their units.
    pub inputs: &'static [(&'static str, &'static str)],
    /// Output columns and their units.
    pub outputs: &'static [(&'static str, &'static str)],
    /// Answers one row; `method` is one of `methods`.
    pub answer: fn(&Row, &str) -> Result<Vec<Cell>, RowError>,
}

impl Topic {
    /// The method of that name, or the default; the empty name where there is one way only.
    ///
    /// - Errors: unknown name; the message lists those that exist.
    pub fn method(&self, name: Option<&str>) -> Result<&'static str, ProbeError> {
        let Some(found) = name else { return Ok(self.methods.first().map_or("", |m| m.0)) };
        self.methods.iter().map(|m| m.0).find(|m| *m == found).ok_or_else(|| {
            let expected = match self.methods {
                [] => "no --method, for there is one way only".to_string(),
                methods => format!("one of: {}", names(methods.iter().map(|m| m.0))),
            };
            ProbeError::UnknownMethod { topic: self.name, found: found.to_string(), expected }
        })
    }
}

/// One value of an answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    Number(f64),
    Count(i64),
    Text(String),
    /// No answer: an empty cell.
    Blank,
}

impl From<Option<f64>> for Cell {
    fn from(value: Option<f64>) -> Self {
        value.map_or(Cell::Blank, Cell::Number)
    }
}

/// What is wrong with a row: the column, what was expected there, and what was found.
#[derive(Clone, Debug, PartialEq)]
pub struct RowError {
    pub column: String,
    pub expected: String,
    pub found: String,
}

/// The named cells of one input row.
pub struct Row<'a> {
    inputs: &'static [(&'static str, &'static str)],
    /// Where each input stands in the record.
    places: &'a [usize],
    record: &'a csv::StringRecord,
}

impl Row<'_> {
    /// The text of a column that the topic declares.
    pub fn text(&self, column: &str) -> &str {
        let i = self.inputs.iter().position(|(name, _)| *name == column);
        let place =
            self.places[i.unwrap_or_else(|| panic!("the topic does not declare the column {column}"))];
        self.record.get(place).unwrap_or("").trim()
    }

    /// The finite number in a column.
    pub fn number(&self, column: &str) -> Result<f64, RowError> {
        match self.text(column).parse::<f64>() {
            Ok(x) if x.is_finite() => Ok(x),
            _ => Err(self.error(column, "a finite number")),
        }
    }

    /// The vector in the columns `{prefix}x {prefix}y {prefix}z`.
    pub fn vector(&self, prefix: &str) -> Result<glam::DVec3, RowError> {
        let n = |axis: &str| self.number(&format!("{prefix}{axis}"));
        Ok(DVec3::new(n("x")?, n("y")?, n("z")?))
    }

    /// The ray in the columns `ox … dz`; its direction may have any length but 0.
    pub fn ray(&self) -> Result<Ray, RowError> {
        let ray = Ray::new(self.vector("o")?, self.vector("d")?);
        if ray.direction == DVec3::ZERO {
            return Err(self.error("dx", "a direction that is not the zero vector"));
        }
        Ok(ray)
    }

    pub fn error(&self, column: &str, expected: &str) -> RowError {
        let found = self.text(column);
        let found = if found.is_empty() { "nothing".to_string() } else { quoted(found) };
        RowError { column: column.to_string(), expected: expected.to_string(), found }
    }
}

/// Why a table was not answered.
#[derive(Debug, thiserror::Error)]
pub enum ProbeError {
    #[error("no topic is called {}; expected one of: {expected}", quoted(found))]
    UnknownTopic { found: String, expected: String },
    #[error("topic {topic} has no method {}; expected {expected}", quoted(found))]
    UnknownMethod { topic: &'static str, found: String, expected: String },
    #[error(
        "line {line}: the header lacks the column `{column}` of topic {topic}; expected {expected}; found {found}"
    )]
    MissingColumn { line: u64, topic: &'static str, column: &'static str, expected: String, found: String },
    #[error("line {line}, column {number}: the header has the column `{column}` twice; expected it once")]
    TwiceColumn { line: u64, number: usize, column: &'static str },
    #[error("line {line}: expected {expected} cells, as in the header, found {found}")]
    Cells { line: u64, expected: u64, found: u64 },
    #[error("line {line}, column {number}: expected UTF-8 text, found other bytes")]
    Utf8 { line: u64, number: usize },
    #[error("line {line}, column {number} (`{column}`): expected {expected}, found {found}", column = error.column, expected = error.expected, found = error.found)]
    Row { line: u64, number: usize, error: RowError },
    #[error("line {line}: {source}")]
    Csv { line: u64, source: csv::Error },
}

/// The names of all topics, comma by comma.
fn names<'a>(all: impl Iterator<Item = &'a str>) -> String {
    all.collect::<Vec<_>>().join(", ")
}

/// Most names of a header that a message lists.
const MOST_NAMES: usize = 32;

/// The names in a header, each escaped and shortened, as far as a message lists them.
fn header_names(header: &csv::StringRecord) -> String {
    let shown: Vec<String> = header.iter().take(MOST_NAMES).map(quoted_name).collect();
    let rest = if header.len() > MOST_NAMES { ", …" } else { "" };
    format!("{}{rest}", shown.join(", "))
}

/// The topic of that name.
///
/// - Errors: unknown name; the message lists those that exist.
pub fn topic(name: &str) -> Result<&'static Topic, ProbeError> {
    TOPICS.iter().find(|t| t.name == name).ok_or_else(|| ProbeError::UnknownTopic {
        found: name.to_string(),
        expected: names(TOPICS.iter().map(|t| t.name)),
    })
}

/// Answers a table: the output's header and a line for each row of `input`.
///
/// - Errors: the first row that cannot be answered, by line and column; there is no partial answer.
pub fn run(topic: &'static Topic, method: Option<&str>, input: &[u8]) -> Result<String, ProbeError> {
    let method = topic.method(method)?;
    let input = input.strip_prefix("\u{feff}".as_bytes()).unwrap_or(input);
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(input);
    let header = reader.headers().map_err(|e| unreadable(input, 0, e))?.clone();
    let places = places(topic, &header, line_at(input, 0))?;
    let mut out = topic.outputs.iter().map(|o| o.0).collect::<Vec<_>>().join(",");
    out.push('\n');
    let mut record = csv::StringRecord::new();
    loop {
        let start = reader.position().byte();
        if !reader.read_record(&mut record).map_err(|e| unreadable(input, start, e))? {
            return Ok(out);
        }
        let row = Row { inputs: topic.inputs, places: &places, record: &record };
        let cells = (topic.answer)(&row, method).map_err(|error| {
            let number = header.iter().position(|name| name == error.column).map_or(0, |i| i + 1);
            ProbeError::Row { line: line_at(input, start), number, error }
        })?;
        debug_assert_eq!(cells.len(), topic.outputs.len(), "topic {} answers its columns", topic.name);
        write_row(&mut out, &cells);
    }
}

/// Where each input of the topic stands in the header.
fn places(topic: &Topic, header: &csv::StringRecord, line: u64) -> Result<Vec<usize>, ProbeError> {
    let place = |column: &'static str| {
        let mut found = header.iter().enumerate().filter(|(_, name)| *name == column).map(|(i, _)| i);
        let Some(place) = found.next() else {
            let expected = names(topic.inputs.iter().map(|i| i.0));
            let found = if header.is_empty() { "nothing".to_string() } else { header_names(header) };
            return Err(ProbeError::MissingColumn { line, topic: topic.name, column, expected, found });
        };
        match found.next() {
            Some(again) => Err(ProbeError::TwiceColumn { line, number: again + 1, column }),
            None => Ok(place),
        }
    };
    topic.inputs.iter().map(|(column, _)| place(column)).collect()
}

/// Line of the record that is read from a byte on. The reader's own count misses the second half of a CR LF, and
/// the empty lines that it skips.
fn line_at(input: &[u8], start: u64) -> u64 {
    let start = usize::try_from(start).unwrap_or(input.len()).min(input.len());
    let skipped = input[start..].iter().take_while(|b| matches!(b, b'\r' | b'\n')).count();
    let before = &input[..start + skipped];
    let lone = |i: usize| before[i] == b'\r' && before.get(i + 1) != Some(&b'\n');
    1 + (0..before.len()).filter(|&i| before[i] == b'\n' || lone(i)).count() as u64
}

/// What the reader of tables refuses, in our words.
fn unreadable(input: &[u8], start: u64, source: csv::Error) -> ProbeError {
    let line = line_at(input, start);
    match source.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            ProbeError::Cells { line, expected: *expected_len, found: *len }
        }
        csv::ErrorKind::Utf8 { err, .. } => ProbeError::Utf8 { line, number: err.field() + 1 },
        _ => ProbeError::Csv { line, source },
    }
}

/// Numbers are printed with the fewest digits that read back exactly.
fn write_row(out: &mut String, cells: &[Cell]) {
    for (i, cell) in cells.iter().enumerate() {
        if i > 0 {
            out.push(',');
        }
        // Writing to a string cannot fail.
        let _ = match cell {
            Cell::Number(x) if *x == 0.0 || (1.0e-5..1.0e16).contains(&x.abs()) => write!(out, "{x}"),
            Cell::Number(x) => write!(out, "{x:e}"),
            Cell::Count(n) => write!(out, "{n}"),
            Cell::Text(text) => write!(out, "{text}"),
            Cell::Blank => Ok(()),
        };
    }
    out.push('\n');
}

/// What `probe --list` prints: topics, methods, columns and units.
pub fn list() -> String {
    let columns = |all: &[(&str, &str)]| {
        let shown = all.iter().map(|(name, unit)| match *unit {
            "" => name.to_string(),
            unit => format!("{name} [{unit}]"),
        });
        shown.collect::<Vec<_>>().join(" ")
    };
    let mut out = String::new();
    for topic in TOPICS {
        let _ = writeln!(out, "{}: {}", topic.name, topic.about);
        let _ = writeln!(out, "  in:  {}", columns(topic.inputs));
        let _ = writeln!(out, "  out: {}", columns(topic.outputs));
        for (i, (name, about)) in topic.methods.iter().enumerate() {
            let default = if i == 0 { " (default)" } else { "" };
            let _ = writeln!(out, "  method {name}{default}: {about}");
        }
    }
    out
}

/// A vector in three cells.
fn cells_of(vector: Option<DVec3>) -> [Cell; 3] {
    match vector {
        Some(v) => v.to_array().map(Cell::Number),
        None => [Cell::Blank, Cell::Blank, Cell::Blank],
    }
}
