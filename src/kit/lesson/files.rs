//! The files of a lesson's figures: vectors for charts and diagrams, pixels for renders, each once.

use super::{FigureRecord, Lesson, LessonError, Result};
use crate::figure::{Data, Figure, Provenance, Repeats, Table};
use crate::file::{Format, encode, write_atomically};
use crate::film::Image;
use crate::flags::PictureFormat;
use std::io::Write;
use std::process::{Command, Stdio};

/// A figure with more pixels than this in it is a picture: it becomes a PNG \[bytes of the SVG\].
const LARGEST_RASTER: usize = 200_000;
/// Data beyond this are left out: the figure itself holds them \[bytes\].
const LARGEST_DATA: usize = 100_000;

/// A rendered picture and its words.
#[derive(Clone, Debug)]
pub struct Picture {
    pub image: Image,
    /// What the picture shows, in a few words: its heading on the page.
    pub title: String,
    /// What to look at.
    pub caption: String,
    /// What the picture shows, for those who do not see it.
    pub alt: String,
}

impl Lesson {
    /// Measures and draws a figure if it is asked for, and writes it with its data.
    ///
    /// Charts and diagrams become SVG, or what `--format` says; a figure that shows renders becomes PNG. What shows
    /// measured seconds is named `…_time`.
    ///
    /// - Errors: what `draw` returns, a file that cannot be written.
    pub fn figure<F: Into<Figure>>(&self, name: &str, draw: impl FnOnce() -> Result<F>) -> Result {
        self.name(name);
        if !self.wants(name) {
            return Ok(());
        }
        self.measuring(name);
        self.write_figure(name, draw()?.into())
    }

    /// Renders a picture if it is asked for, and writes it as PNG.
    ///
    /// - Errors: what `draw` returns, a file that cannot be written.
    pub fn picture(&self, name: &str, draw: impl FnOnce() -> Result<Picture>) -> Result {
        self.name(name);
        if !self.wants(name) {
            return Ok(());
        }
        self.measuring(name);
        self.write_picture(name, draw()?)
    }

    /// Measures a table if it is asked for; it stands on the page as HTML and in the folder as CSV.
    ///
    /// - Errors: what `make` returns, a file that cannot be written.
    pub fn table(&self, name: &str, make: impl FnOnce() -> Result<Table>) -> Result {
        self.name(name);
        if !self.wants(name) {
            return Ok(());
        }
        self.measuring(name);
        let table = make()?;
        let html = table.html();
        let figure = Figure::from(table);
        let files = self.data(name, &figure.data)?;
        let record = FigureRecord {
            table: html,
            ..self.words(name, &figure.title, &figure.caption, &figure.alt, files)
        };
        self.record.borrow_mut().figures.push(record);
        Ok(())
    }

    pub(super) fn wants(&self, name: &str) -> bool {
        let only = self.cli.flags.only.as_deref();
        only.is_none_or(|only| match self.essay {
            Some(_) => only.split(',').any(|wanted| wanted == name),
            None => name.contains(only),
        })
    }

    pub(super) fn write_figure(&self, name: &str, figure: Figure) -> Result {
        let mut provenance = self.provenance();
        provenance.parameters = figure.provenance.parameters.clone();
        let figure = figure.provenance(provenance);
        let figure = if self.cli.no_title { figure.without_heading() } else { figure };
        let svg = figure.svg();
        let format = match self.cli.flags.format {
            Some(PictureFormat::Pdf) => "pdf",
            Some(PictureFormat::Svg) => "svg",
            Some(_) => "png",
            None if svg.len() > LARGEST_RASTER && svg.contains("<image ") => "png",
            None => "svg",
        };
        let bytes = match format {
            "svg" => svg.into_bytes(),
            "pdf" => pdf(&svg)?,
            _ => figure.png(),
        };
        let timed = if figure.repeats == Repeats::Timed { "_time" } else { "" };
        let mut files = vec![self.write(&format!("{}_{name}{timed}.{format}", self.entry.stem()), &bytes)?];
        files.extend(self.data(name, &figure.data)?);
        let mut record = self.words(name, &figure.title, &figure.caption, &figure.alt, files);
        (record.width, record.height) = (figure.drawing.width, figure.drawing.height);
        record.heading = figure.drawing.heading.0;
        record.text = figure.drawing.smallest_text().unwrap_or(0.0);
        self.record.borrow_mut().figures.push(record);
        Ok(())
    }

    pub(super) fn write_picture(&self, name: &str, picture: Picture) -> Result {
        let p = self.provenance();
        let texts = [
            ("Title", picture.title.clone()),
            ("Description", picture.alt.clone()),
            ("Command", p.command),
            ("Seed", self.seed().to_string()),
            ("Version", p.version),
        ];
        let file = format!("{}_{name}.png", self.entry.stem());
        let (bytes, _) = encode(&self.out.join(&file), &picture.image, Format::Png8, &texts)?;
        let files = vec![self.write(&file, &bytes)?];
        let mut record = self.words(name, &picture.title, &picture.caption, &picture.alt, files);
        (record.width, record.height) = (picture.image.width() as f64, picture.image.height() as f64);
        self.record.borrow_mut().figures.push(record);
        Ok(())
    }

    fn data(&self, name: &str, data: &[Data]) -> Result<Vec<String>> {
        let small = data.iter().filter(|d| d.csv.len() <= LARGEST_DATA);
        small
            .map(|d| {
                let timed = if d.repeats == Repeats::Timed { "_time" } else { "" };
                self.write(&format!("{}_{name}{timed}.csv", self.entry.stem()), d.csv.as_bytes())
            })
            .collect()
    }

    fn words(&self, name: &str, title: &str, caption: &str, alt: &str, files: Vec<String>) -> FigureRecord {
        FigureRecord {
            name: name.to_string(),
            title: title.to_string(),
            caption: caption.to_string(),
            alt: alt.to_string(),
            command: self.record.borrow().command.clone(),
            seed: self.seed(),
            version: env!("CARGO_PKG_VERSION").to_string(),
            files,
            ..FigureRecord::default()
        }
    }

    fn provenance(&self) -> Provenance {
        Provenance {
            command: self.record.borrow().command.clone(),
            parameters: String::new(),
            seed: Some(self.seed()),
            version: env!("CARGO_PKG_VERSION").to_string(),
        }
    }

    /// Writes a file of the lesson; returns its name.
    pub(super) fn write(&self, name: &str, bytes: &[u8]) -> Result<String> {
        let path = self.out.join(name);
        write_atomically(&path, bytes)?;
        self.paths.borrow_mut().push(path);
        Ok(name.to_string())
    }
}

/// An SVG as PDF, by the program `rsvg-convert`.
///
/// - Errors: the program is not there, or does not take the drawing.
fn pdf(svg: &str) -> Result<Vec<u8>> {
    let mut command = Command::new("rsvg-convert");
    command.args(["--format", "pdf"]).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().map_err(|e| {
        LessonError(format!(
            "--format pdf needs the program rsvg-convert (of librsvg): {e}; --format svg needs nothing"
        ))
    })?;
    if let Some(mut input) = child.stdin.take() {
        input.write_all(svg.as_bytes())?;
    }
    let done = child.wait_with_output()?;
    if !done.status.success() {
        return Err(LessonError(format!("rsvg-convert: {}", String::from_utf8_lossy(&done.stderr).trim())));
    }
    Ok(done.stdout)
}
