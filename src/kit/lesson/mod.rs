//! What a lesson is: a question, figures, claims, an answer.
//!
//! The harness is a value: [`Lesson::open`] reads the flags, [`Lesson::save`] writes figures with
//! their data and provenance, [`Lesson::claim`] checks a sentence, and [`Lesson::answer`] ends the lesson with
//! one more sentence and the paths of what it wrote.

mod record;
mod syllabus;

pub use record::{ClaimRecord, FigureRecord, LessonRecord};
pub use syllabus::{Entry, SYLLABUS, entry};

use super::figure::{Figure, Provenance, Repeats};
use super::flags::{Flags, Quality};
use crate::file::{FileError, Format, encode, write_atomically};
use crate::film::Image;
use clap::{CommandFactory, FromArgMatches, Parser};
use rayon::prelude::*;
use std::cell::RefCell;
use std::io::Write;
use std::ops::RangeInclusive;
use std::path::PathBuf;

/// Why a lesson failed.
#[derive(thiserror::Error)]
pub enum LessonError {
    #[error(transparent)]
    File(#[from] FileError),
    #[error("{failed} of {all} claims failed")]
    Claims { failed: usize, all: usize },
    #[error("{0}")]
    Other(String),
}

/// `main` prints its error with `Debug`: the sentence is what a reader wants.
impl std::fmt::Debug for LessonError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{self}")
    }
}

/// What a lesson's `main` returns.
pub type Result<T = ()> = std::result::Result<T, LessonError>;

#[derive(Parser)]
#[command(version, max_term_width = 100)]
struct Cli {
    #[command(flatten)]
    flags: Flags,
}

/// Prints a line; a reader that closed the pipe has read enough.
fn print(text: &str) {
    let _ = writeln!(std::io::stdout(), "{text}");
}

/// A lesson that runs.
pub struct Lesson {
    entry: &'static Entry,
    flags: Flags,
    out: PathBuf,
    record: RefCell<LessonRecord>,
    paths: RefCell<Vec<PathBuf>>,
    /// Figures whose PNG is drawn at the end, all at once on all cores.
    pending: RefCell<Vec<(PathBuf, Figure)>>,
}

impl Lesson {
    /// Reads the command line and prints the question. Wrong usage ends the program with code 2.
    ///
    /// - Errors: a number that is not in the [`SYLLABUS`].
    pub fn open(number: u32) -> Result<Self> {
        let entry = entry(number).ok_or_else(|| LessonError::Other(format!("no lesson {number}")))?;
        let command =
            Cli::command().bin_name(entry.program()).display_name(entry.program()).about(entry.question);
        let matches = command.get_matches();
        let flags = Flags::from_arg_matches(&matches).unwrap_or_else(|e| e.exit());
        if flags.list {
            print(&format!("{}  {}", entry.program(), entry.question));
            std::process::exit(0);
        }
        if let Some(threads) = flags.threads {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into());
            pool.build_global()
                .map_err(|e| LessonError::Other(format!("threads could not be started: {e}")))?;
        }
        print(&format!("Lesson {:02} · {}\n", entry.number, entry.question));
        let command = format!("cargo run --bin {}{}", entry.program(), flags.canonical());
        let record = LessonRecord::new(entry, command);
        let out = flags.out();
        let (paths, pending) = (RefCell::default(), RefCell::default());
        Ok(Lesson { entry, flags, out, record: RefCell::new(record), paths, pending })
    }

    pub fn seed(&self) -> u64 {
        self.flags.seed()
    }

    pub fn quality(&self) -> Quality {
        self.flags.quality()
    }

    /// The flags, for the few that a lesson reads itself: `--width`, `--height`, `--spp`, `--threads`.
    pub fn flags(&self) -> &Flags {
        &self.flags
    }

    /// One of four values, by quality: smoke, draft, standard, final.
    pub fn pick<T: Copy>(&self, by_quality: [T; 4]) -> T {
        by_quality[self.quality() as usize]
    }

    /// Powers of two as budgets, from 2^first on: the first three at smoke quality, all at draft, four
    /// and sixteen times as many at standard and final.
    pub fn budgets(&self, exponents: RangeInclusive<u32>) -> Vec<u32> {
        let (first, last) = (*exponents.start(), *exponents.end());
        let last = self.pick([last.min(first + 2), last, last + 2, last + 4]).min(31);
        (first..=last).map(|e| 1 << e).collect()
    }

    /// Prints a paragraph of the lesson.
    pub fn say(&self, text: &str) {
        print(&format!("{text}\n"));
    }

    /// Writes a figure as SVG and PNG, its data as CSV, and its words as JSON: `02_sphere_{what}.svg` and so on.
    /// What shows measured seconds is named `…_time`.
    ///
    /// - Errors: a file that cannot be written.
    pub fn save(&self, what: &str, figure: impl Into<Figure>) -> Result {
        let figure = figure.into();
        if !self.wants(what) {
            return Ok(());
        }
        let mut provenance = self.provenance();
        provenance.parameters = figure.provenance.parameters.clone();
        let figure = figure.provenance(provenance);
        let timed = |repeats| if repeats == Repeats::Timed { "_time" } else { "" };
        let name = format!("{}_{what}{}", self.entry.stem(), timed(figure.repeats));
        let mut files =
            vec![self.write(&format!("{name}.svg"), figure.svg().as_bytes())?, format!("{name}.png")];
        self.paths.borrow_mut().push(self.out.join(&files[1]));
        for data in &figure.data {
            let name = format!("{}_{what}{}.csv", self.entry.stem(), timed(data.repeats));
            files.push(self.write(&name, data.csv.as_bytes())?);
        }
        self.describe(&name, &figure.title, &figure.caption, &figure.alt, files)?;
        self.pending.borrow_mut().push((self.out.join(format!("{name}.png")), figure));
        Ok(())
    }

    /// Writes a rendered picture as PNG, and its words as JSON.
    ///
    /// - Errors: a file that cannot be written.
    pub fn save_picture(&self, what: &str, image: &Image, caption: &str, alt: &str) -> Result {
        if !self.wants(what) {
            return Ok(());
        }
        let name = format!("{}_{what}", self.entry.stem());
        let p = self.provenance();
        let texts = [
            ("Title", caption.to_string()),
            ("Description", alt.to_string()),
            ("Command", p.command),
            ("Seed", self.seed().to_string()),
            ("Version", p.version),
        ];
        let path = self.out.join(format!("{name}.png"));
        let (bytes, _) = encode(&path, image, Format::Png8, &texts)?;
        let files = vec![self.write(&format!("{name}.png"), &bytes)?];
        self.describe(&name, caption, caption, alt, files)
    }

    /// A claim: one sentence, and whether it holds in this run.
    pub fn claim(&self, sentence: &str, holds: bool) {
        print(&format!("{} {sentence}", if holds { "holds: " } else { "FAILS: " }));
        self.record.borrow_mut().claims.push(ClaimRecord { sentence: sentence.to_string(), holds });
    }

    /// Ends the lesson: its answer in one sentence, and the paths of what it wrote.
    ///
    /// - Errors: a claim that failed, a file that cannot be written.
    pub fn answer(self, sentence: &str) -> Result {
        let pending = self.pending.take();
        pending.into_par_iter().try_for_each(|(path, figure)| write_atomically(&path, &figure.png()))?;
        print(&format!("\nAnswer: {sentence}\n"));
        self.record.borrow_mut().answer = sentence.to_string();
        let json = self.record.borrow().json();
        self.write(&format!("{}.json", self.entry.stem()), json.as_bytes())?;
        for path in self.paths.borrow().iter() {
            print(&path.display().to_string());
        }
        let record = self.record.borrow();
        let failed = record.claims.iter().filter(|c| !c.holds).count();
        if failed > 0 {
            return Err(LessonError::Claims { failed, all: record.claims.len() });
        }
        Ok(())
    }

    /// Does `--only` let this figure through?
    fn wants(&self, what: &str) -> bool {
        self.flags.only.as_ref().is_none_or(|only| what.contains(only.as_str()))
    }

    fn provenance(&self) -> Provenance {
        Provenance {
            command: self.record.borrow().command.clone(),
            parameters: String::new(),
            seed: Some(self.seed()),
            version: env!("CARGO_PKG_VERSION").to_string(),
        }
    }

    fn write(&self, name: &str, bytes: &[u8]) -> Result<String> {
        let path = self.out.join(name);
        write_atomically(&path, bytes)?;
        self.paths.borrow_mut().push(path);
        Ok(name.to_string())
    }

    fn describe(&self, name: &str, title: &str, caption: &str, alt: &str, files: Vec<String>) -> Result {
        let record = FigureRecord {
            title: title.to_string(),
            caption: caption.to_string(),
            alt: alt.to_string(),
            command: self.record.borrow().command.clone(),
            seed: self.seed(),
            version: env!("CARGO_PKG_VERSION").to_string(),
            files,
        };
        self.write(&format!("{name}.json"), record.json().as_bytes())?;
        self.record.borrow_mut().figures.push(record);
        Ok(())
    }
}
