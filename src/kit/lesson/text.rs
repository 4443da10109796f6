//! What a lesson prints.

use super::{Lesson, print};
use crate::essay::{Essay, Part, Values, paragraphs, wrapped};
use std::path::PathBuf;

/// Columns of prose: as many as the terminal has, at most so many; and where there is no terminal.
const WIDEST: usize = 100;
const WITHOUT_TERMINAL: usize = 80;

impl Lesson {
    /// The question, and the prediction with its options.
    pub(super) fn opening(&self) {
        let Some(essay) = &self.essay else { return };
        self.progress.suspend(|| {
            print(&format!(
                "{}\n",
                bold(&format!("Lesson {:02} · {}", self.entry.number, self.entry.question))
            ));
            let predict = paragraphs(essay, Part::Predict, &Values::new());
            print(&format!("{}\n", joined(&predict)));
        });
    }

    /// The paragraphs that reason with this run's numbers, and the answer.
    pub(super) fn reasoning(&self, essay: &Essay, values: &Values) {
        for part in [Part::Measure, Part::Breaks] {
            print(&bold(part.heading()));
            print(&format!("{}\n", joined(&paragraphs(essay, part, values))));
        }
        print(&bold("Answer"));
        print(&format!("{}\n", joined(&paragraphs(essay, Part::Use, values))));
    }

    /// The last line: how many figures, and the page; with `--paths` every file instead.
    pub(super) fn last_line(&self, page: Option<PathBuf>) {
        let paths = self.paths.borrow();
        self.progress.clear();
        if self.cli.paths {
            for path in paths.iter() {
                print(&path.display().to_string());
            }
            return;
        }
        let count = self.record.borrow().figures.len();
        let figures = if count == 1 { "1 figure".to_string() } else { format!("{count} figures") };
        let shown = page.or_else(|| paths.first().cloned()).unwrap_or_else(|| self.out.clone());
        print(&format!("{figures} · {}", shown.display()));
    }
}

/// Paragraphs wrapped to the terminal, with an empty line between them, none between options.
fn joined(paragraphs: &[String]) -> String {
    let terminal = console::Term::stdout();
    let width = terminal
        .size_checked()
        .map_or(WITHOUT_TERMINAL, |(_, columns)| usize::from(columns).clamp(40, WIDEST));
    let mut out = String::new();
    for (i, paragraph) in paragraphs.iter().enumerate() {
        let is_item = |p: &str| p.starts_with("• ") || p.get(1..3).is_some_and(|m| m == ") " || m == ". ");
        if i > 0 {
            out += if is_item(paragraph) && is_item(&paragraphs[i - 1]) { "\n" } else { "\n\n" };
        }
        out += &wrapped(paragraph, width);
    }
    out
}

/// A heading: bold where the terminal can and the reader has not said `NO_COLOR`.
fn bold(text: &str) -> String {
    console::style(text).bold().to_string()
}
