//! The harness of lessons that have no essay yet: they print their own words and save figures as they come.

use super::{Lesson, LessonError, Picture, Result, print, refuse};
use crate::figure::Figure;
use crate::film::Image;

impl Lesson {
    /// As [`Lesson::open`], for a lesson without an essay.
    ///
    /// - Errors: a number that is not in the syllabus.
    pub fn without_essay(number: u32) -> Result<Self> {
        let lesson = Lesson::with(number, None)?;
        print(&format!("Lesson {:02} · {}\n", lesson.entry.number, lesson.entry.question));
        Ok(lesson)
    }

    /// Prints a paragraph of the lesson.
    pub fn say(&self, text: &str) {
        print(&format!("{text}\n"));
    }

    /// Writes a figure as [`Lesson::figure`] does.
    ///
    /// - Errors: a file that cannot be written, a name used twice.
    pub fn save(&self, name: &str, figure: impl Into<Figure>) -> Result {
        self.name(name);
        self.finish_problems()?;
        if self.wants(name) { self.write_figure(name, figure.into()) } else { Ok(()) }
    }

    /// Writes a rendered picture as [`Lesson::picture`] does.
    ///
    /// - Errors: a file that cannot be written, a name used twice.
    pub fn save_picture(&self, name: &str, image: &Image, caption: &str, alt: &str) -> Result {
        self.name(name);
        self.finish_problems()?;
        if !self.wants(name) {
            return Ok(());
        }
        let words = (caption.to_string(), String::new(), alt.to_string());
        self.write_picture(
            name,
            Picture { image: image.clone(), title: words.0, caption: words.1, alt: words.2 },
        )
    }

    /// Ends the lesson with its answer.
    ///
    /// - Errors: a claim that failed, a file that cannot be written.
    pub fn answer(self, sentence: &str) -> Result {
        let figures = self.record.borrow().figures.len();
        if self.cli.flags.only.is_some() && figures == 0 {
            let only = self.cli.flags.only.as_deref().unwrap_or_default();
            refuse(&format!(
                "--only: expected a part of a figure's name, found `{only}`\nfigures: {}",
                self.names.borrow().join(", ")
            ));
        }
        if self.essay.is_some() {
            return Err(LessonError("a lesson with an essay ends with `close`".to_string()));
        }
        print(&format!("\nAnswer: {sentence}\n"));
        self.record.borrow_mut().answer = sentence.to_string();
        let page = if self.cli.flags.only.is_none() { Some(self.finish_page()?) } else { None };
        self.last_line(page);
        self.verdict()
    }
}
