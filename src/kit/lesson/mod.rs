//! The harness of lessons: a lesson is a program that measures and an essay that explains.
//!
//! The harness is a value. [`Lesson::open`] reads the flags and the essay; [`Lesson::figure`], [`Lesson::picture`],
//! [`Lesson::value`] and [`Lesson::claim`] take closures, so that `--only roots` measures what `roots` needs and no more;
//! [`Lesson::close`] holds the run against the essay, writes the page, and prints what a student reads on a terminal.
//!
//! ```no_run
//! use lightbench_kit::figure::Chart;
//! use lightbench_kit::lesson::{Lesson, Result};
//!
//! # const ESSAY: &str = "";
//! fn main() -> Result {
//!     let lesson = Lesson::open(2, ESSAY)?; // include_str!("02_sphere.md")
//!     lesson.figure("stability", || Ok(Chart::speed_accuracy("relative error of t")))?;
//!     lesson.value("lost", || 31);
//!     lesson.claim("the robust method loses no ray", || true);
//!     lesson.close()
//! }
//! ```

mod earlier;
mod files;
mod text;

pub use crate::syllabus::{ClaimRecord, Entry, FigureRecord, LessonRecord, SYLLABUS, entry};
pub use files::Picture;

use crate::essay::{Essay, EssayError, Part};
use crate::file::write_atomically;
use crate::flags::{Flags, PictureFormat, Quality};
use crate::page;
use crate::progress::{Progress, Verbosity};
use crate::stage::RenderSize;
use clap::{CommandFactory, FromArgMatches, Parser};
use std::cell::RefCell;
use std::fmt::Display;
use std::io::Write;
use std::ops::RangeInclusive;
use std::path::PathBuf;

/// Why a lesson failed: a sentence.
pub struct LessonError(pub String);

/// `main` prints its error with `Debug`: the sentence is what a reader wants.
impl std::fmt::Debug for LessonError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

/// Every error of the library becomes a lesson's by `?`.
impl<E: std::error::Error> From<E> for LessonError {
    fn from(error: E) -> Self {
        LessonError(error.to_string())
    }
}

/// What a lesson's `main` returns.
pub type Result<T = ()> = std::result::Result<T, LessonError>;

#[derive(Parser)]
#[command(version, max_term_width = 100)]
struct Cli {
    #[command(flatten)]
    flags: Flags,
    /// Leave out the headings drawn in the figures, for slides
    #[arg(long)]
    no_title: bool,
    /// List every file that was written, one a line, instead of the page alone
    #[arg(long)]
    paths: bool,
}

/// Prints a line; a reader that closed the pipe has read enough.
fn print(text: &str) {
    let _ = writeln!(std::io::stdout(), "{text}");
}

/// Ends the program as wrong usage does.
fn refuse(message: &str) -> ! {
    crate::progress::say(&format!("error: {message}\n"));
    std::process::exit(2)
}

/// A lesson that runs.
pub struct Lesson {
    entry: &'static Entry,
    essay: Option<Essay<'static>>,
    cli: Cli,
    out: PathBuf,
    record: RefCell<LessonRecord>,
    paths: RefCell<Vec<PathBuf>>,
    /// Names of figures, pictures and values so far, to find one that is used twice.
    names: RefCell<Vec<String>>,
    problems: RefCell<Vec<String>>,
    progress: Progress,
}

/// Whether a claim holds: a truth value, or a closure that finds out.
pub trait Holds {
    fn holds(self) -> bool;
}

impl Holds for bool {
    fn holds(self) -> bool {
        self
    }
}

impl<F: FnOnce() -> bool> Holds for F {
    fn holds(self) -> bool {
        self()
    }
}

impl Lesson {
    /// Reads the command line and the essay, and prints the question with its options. Wrong usage ends the program
    /// with code 2.
    ///
    /// - Errors: a number that is not in the [`SYLLABUS`], an essay that departs from the form or asks another question.
    pub fn open(number: u32, essay: &'static str) -> Result<Self> {
        let essay = Essay::parse(essay)?;
        let lesson = Lesson::with(number, Some(essay))?;
        lesson.opening();
        Ok(lesson)
    }

    fn with(number: u32, essay: Option<Essay<'static>>) -> Result<Self> {
        let entry = entry(number).ok_or_else(|| LessonError(format!("no lesson {number}")))?;
        if let Some(essay) = essay.as_ref().filter(|e| e.question() != entry.question) {
            let (expected, found) = (entry.question, essay.question());
            return Err(
                EssayError(vec![format!("expected the question “{expected}”, found “{found}”")]).into()
            );
        }
        let command =
            Cli::command().bin_name(entry.program()).display_name(entry.program()).about(entry.question);
        let cli = Cli::from_arg_matches(&command.get_matches()).unwrap_or_else(|e| e.exit());
        if let Some(essay) = &essay {
            check_names(entry, essay, &cli);
            if cli.flags.spp.is_some() {
                refuse("--spp has no effect on this lesson: --quality chooses the samples of its pictures");
            }
        } else if cli.flags.list {
            print(&format!("{}  {}", entry.program(), entry.question));
            std::process::exit(0);
        }
        if let Some(format @ (PictureFormat::Exr | PictureFormat::Hdr | PictureFormat::Png16)) =
            cli.flags.format
        {
            refuse(
                &format!("--format: expected svg, png or pdf for figures, found {format:?}").to_lowercase(),
            );
        }
        if let Some(threads) = cli.flags.threads {
            rayon::ThreadPoolBuilder::new().num_threads(threads.into()).build_global()?;
        }
        let arguments = cli.flags.canonical() + if cli.no_title { " --no-title" } else { "" };
        let dashes = if arguments.is_empty() { "" } else { " --" };
        let command = format!("cargo run --bin {}{dashes}{arguments}", entry.program());
        let verbosity = if cli.flags.quiet { Verbosity::Quiet } else { Verbosity::Normal };
        Ok(Lesson {
            entry,
            essay,
            out: cli.flags.out(),
            cli,
            record: RefCell::new(LessonRecord::new(entry, command)),
            paths: RefCell::default(),
            names: RefCell::default(),
            problems: RefCell::default(),
            progress: Progress::start(&entry.program(), verbosity),
        })
    }

    pub fn seed(&self) -> u64 {
        self.cli.flags.seed()
    }

    pub fn quality(&self) -> Quality {
        self.cli.flags.quality()
    }

    /// The flags, for the few that a lesson reads itself.
    pub fn flags(&self) -> &Flags {
        &self.cli.flags
    }

    /// Size of a render \[px\]: `--width` and `--height` if given (one alone keeps the proportions), else `usual`.
    pub fn size(&self, usual: (usize, usize)) -> (usize, usize) {
        let scaled =
            |given: u16, from: usize, to: usize| (usize::from(given) * to).div_ceil(from.max(1)).max(1);
        match (self.cli.flags.width, self.cli.flags.height) {
            (Some(w), Some(h)) => (w.into(), h.into()),
            (Some(w), None) => (w.into(), scaled(w, usual.0, usual.1)),
            (None, Some(h)) => (scaled(h, usual.1, usual.0), h.into()),
            (None, None) => usual,
        }
    }

    /// The size of a picture of the [stage](crate::stage) across the page: of the quality, unless `--width` or
    /// `--height` says otherwise.
    pub fn hero(&self) -> RenderSize {
        self.asked(RenderSize::hero(self.quality(), self.seed()))
    }

    /// The same for pictures side by side.
    pub fn panel(&self) -> RenderSize {
        self.asked(RenderSize::panel(self.quality(), self.seed()))
    }

    fn asked(&self, usual: RenderSize) -> RenderSize {
        let (width, height) = self.size((usual.width, usual.height));
        RenderSize { width, height, ..usual }
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

    /// A number of this run that the essay quotes as `{name}`; it is computed only if the essay is told.
    pub fn value<T: Display>(&self, name: &str, value: impl FnOnce() -> T) {
        self.name(name);
        if self.cli.flags.only.is_none() {
            self.measuring(name);
            self.record.borrow_mut().values.insert(name.to_string(), value().to_string());
        }
    }

    /// A claim: one sentence, and whether it holds in this run.
    pub fn claim(&self, sentence: &str, holds: impl Holds) {
        if self.essay.is_some() && self.cli.flags.only.is_some() {
            return;
        }
        let holds = holds.holds();
        if self.essay.is_none() || !holds {
            self.progress
                .suspend(|| print(&format!("{} {sentence}", if holds { "holds: " } else { "FAILS: " })));
        }
        self.record.borrow_mut().claims.push(ClaimRecord { sentence: sentence.to_string(), holds });
    }

    /// Ends the lesson: holds the run against the essay, writes record and page, prints the reasoning and the answer
    /// with this run's numbers, and last the path of the page.
    ///
    /// - Errors: a claim that failed, a file that cannot be written, a figure or value that the essay or the run
    ///   lacks, a name used twice.
    pub fn close(self) -> Result {
        let Some(essay) = &self.essay else {
            return Err(LessonError("a lesson without an essay ends with `answer`".to_string()));
        };
        if self.cli.flags.only.is_some() {
            self.finish_problems()?;
            self.last_line(None);
            return Ok(());
        }
        self.compare(essay);
        self.finish_problems()?;
        let values = self.record.borrow().values.clone();
        self.record.borrow_mut().answer = crate::essay::paragraphs(essay, Part::Use, &values).join(" ");
        let path = self.finish_page()?;
        self.reasoning(essay, &values);
        self.last_line(Some(path));
        self.verdict()
    }

    /// Writes the record, and the page made of it.
    fn finish_page(&self) -> Result<PathBuf> {
        let record = self.record.borrow();
        self.write(&format!("{}.json", self.entry.stem()), record.json().as_bytes())?;
        write_atomically(&self.out.join("glossary.html"), page::glossary().as_bytes())?;
        let text = page::lesson(self.entry, self.essay.as_ref(), &record);
        let name = self.write(&format!("{}.html", self.entry.stem()), text.as_bytes())?;
        Ok(self.out.join(name))
    }

    fn verdict(&self) -> Result {
        let record = self.record.borrow();
        let failed = record.claims.iter().filter(|c| !c.holds).count();
        if failed > 0 {
            return Err(LessonError(format!("{failed} of {} claims failed", record.claims.len())));
        }
        Ok(())
    }

    /// Is every figure and value of the run in the essay, and the other way round?
    fn compare(&self, essay: &Essay) {
        let record = self.record.borrow();
        let made: Vec<String> = record.figures.iter().map(|f| f.name.clone()).collect();
        let shown: Vec<String> = essay.figures().into_iter().map(|f| f.name).collect();
        let given: Vec<String> = record.values.keys().cloned().collect();
        let quoted: Vec<String> = essay.values().into_iter().collect();
        let mut problems = self.problems.borrow_mut();
        let mut missing = |what: &str, all: &[String], from: &[String], place: &str| {
            for name in all.iter().filter(|n| !from.contains(n)) {
                problems.push(format!("the {what} `{name}` does not occur in {place}"));
            }
        };
        missing("figure", &made, &shown, "the essay");
        missing("figure", &shown, &made, "the run");
        missing("value", &given, &quoted, "the essay");
        missing("value", &quoted, &given, "the run");
    }

    fn finish_problems(&self) -> Result {
        let problems = self.problems.borrow();
        if problems.is_empty() { Ok(()) } else { Err(LessonError(problems.join("\n"))) }
    }

    /// Takes note of a name; one that was used before is a fault of the lesson.
    fn name(&self, name: &str) {
        let mut names = self.names.borrow_mut();
        if names.iter().any(|n| n == name) {
            self.problems.borrow_mut().push(format!("the name `{name}` is used twice"));
        }
        names.push(name.to_string());
    }

    /// Shows what is being measured, and how much of the lesson is done.
    fn measuring(&self, what: &str) {
        let Some(essay) = &self.essay else { return };
        let all = (essay.figures().len() + essay.values().len()).max(1);
        self.progress.step(&what.replace('_', " "), self.names.borrow().len() as f64 / all as f64);
    }
}

/// `--list` prints the names of the figures; `--only` takes one of them, or several with commas.
fn check_names(entry: &Entry, essay: &Essay, cli: &Cli) {
    let names: Vec<String> = essay.figures().into_iter().map(|f| f.name).collect();
    if cli.flags.list {
        print(&names.join("\n"));
        std::process::exit(0);
    }
    let mut wanted = cli.flags.only.iter().flat_map(|only| only.split(','));
    if let Some(name) = wanted.find(|n| !names.iter().any(|known| known == n)) {
        refuse(&format!(
            "--only: expected a figure of {}, found `{name}`\nfigures: {}",
            entry.program(),
            names.join(", ")
        ));
    }
}
