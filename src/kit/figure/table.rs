//! Tables: columns that align, thin rules, no boxes.

use super::drawing::{Anchor, Drawing, Face, Fill, Rect, Stroke, Text};
use super::heading::{HEIGHT, Heading, MARGIN, SIZE, WIDTH};
use super::ink::Ink;
use super::{Data, Figure, Repeats, font};
use glam::dvec2;

/// A table of texts; columns of numbers stand right-aligned.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    heading: Heading,
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
    marked: Option<usize>,
    repeats: Repeats,
}

impl Table {
    pub fn new(columns: &[&str]) -> Self {
        let columns = columns.iter().map(|c| c.to_string()).collect();
        Table {
            heading: Heading::default(),
            columns,
            rows: Vec::new(),
            marked: None,
            repeats: Repeats::Always,
        }
    }
    pub fn title(mut self, title: &str) -> Self {
        self.heading.title = title.to_string();
        self
    }
    pub fn subtitle(mut self, subtitle: &str) -> Self {
        self.heading.subtitle = subtitle.to_string();
        self
    }
    /// A row; missing cells stay empty, surplus ones are left out.
    pub fn row(mut self, cells: &[&str]) -> Self {
        self.rows.push((0..self.columns.len()).map(|i| cells.get(i).unwrap_or(&"").to_string()).collect());
        self
    }
    /// The last row is the one to look at.
    pub fn marked(mut self) -> Self {
        self.marked = self.rows.len().checked_sub(1);
        self
    }
    /// The table holds measured seconds.
    pub fn timed(mut self) -> Self {
        self.repeats = Repeats::Timed;
        self
    }

    /// The table as lines of Markdown.
    pub fn markdown(&self) -> String {
        let line = |cells: &[String]| {
            let cells: Vec<String> = cells.iter().map(|c| font::plain(c).replace('|', "\\|")).collect();
            format!("| {} |\n", cells.join(" | "))
        };
        let rule: Vec<String> = (0..self.columns.len())
            .map(|i| if self.is_numeric(i) { "---:" } else { "---" }.to_string())
            .collect();
        let head = line(&self.columns) + &format!("| {} |\n", rule.join(" | "));
        self.rows.iter().fold(head, |text, row| text + &line(row))
    }

    /// The table as HTML.
    pub fn html(&self) -> String {
        let cell = |tag: &str, i: usize, text: &str| {
            let side = if self.is_numeric(i) { " class=\"number\"" } else { "" };
            format!("<{tag}{side}>{}</{tag}>", super::svg::escaped(&font::plain(text)))
        };
        let row = |tag: &str, cells: &[String]| -> String {
            cells.iter().enumerate().map(|(i, text)| cell(tag, i, text)).collect()
        };
        let rows = self.rows.iter().enumerate().map(|(i, cells)| {
            let mark = if self.marked == Some(i) { " class=\"marked\"" } else { "" };
            format!("<tr{mark}>{}</tr>\n", row("td", cells))
        });
        let body: String = rows.collect();
        format!(
            "<table>\n<thead><tr>{}</tr></thead>\n<tbody>\n{body}</tbody>\n</table>",
            row("th", &self.columns)
        )
    }

    /// The table as CSV.
    pub fn csv(&self) -> String {
        let quoted = |cell: &String| {
            let cell = font::plain(cell);
            if cell.contains([',', '"', '\n', '\r']) {
                format!("\"{}\"", cell.replace('"', "\"\""))
            } else {
                cell
            }
        };
        let line = |cells: &[String]| cells.iter().map(quoted).collect::<Vec<_>>().join(",") + "\n";
        self.rows.iter().fold(line(&self.columns), |text, row| text + &line(row))
    }

    /// Does every filled cell of the column begin like a number?
    fn is_numeric(&self, column: usize) -> bool {
        let cells = self.rows.iter().map(|r| r[column].trim()).filter(|c| !c.is_empty() && *c != "–");
        let mut any = false;
        let all = cells.inspect(|_| any = true).all(|c| {
            c.trim_start_matches(['−', '-', '+', '±', '<', '>', '≤', '≥', '≈', ' '])
                .starts_with(|d: char| d.is_ascii_digit() || d == '∞')
        });
        all && any
    }

    pub fn draw(&self) -> Drawing {
        let mut drawing = Drawing::new(WIDTH, HEIGHT);
        let top = self.heading.draw(&mut drawing);
        let (size, widths) = self.fitted();
        let line = size * 1.75;
        drawing.height = (top + line * (self.rows.len() as f64 + 1.3) + MARGIN).ceil().max(200.0);
        let total: f64 = widths.iter().sum::<f64>() + PAD * 2.0 * widths.len() as f64;
        let right = MARGIN + total;
        let rule = |d: &mut Drawing, y: f64, w: f64| {
            d.line(dvec2(MARGIN, y), dvec2(right, y), Stroke::new(Ink::Outline, w))
        };
        rule(&mut drawing, top, 1.8);
        if let Some(i) = self.marked {
            let y = top + line * (i as f64 + 1.15);
            let place = Rect::new(MARGIN, y, right, y + line);
            drawing.rect(place, Some(Fill::new(Ink::Surface).faint(0.7)), None);
        }
        let mut row_of = |cells: &[String], y: f64, face: Face| {
            let mut x = MARGIN;
            for (i, (cell, width)) in cells.iter().zip(&widths).enumerate() {
                let numeric = self.is_numeric(i);
                let (at, anchor) =
                    if numeric { (x + PAD + width, Anchor::End) } else { (x + PAD, Anchor::Start) };
                drawing.text(Text::new(dvec2(at, y), cell, size, Ink::Text).face(face).anchor(anchor));
                x += width + 2.0 * PAD;
            }
        };
        row_of(&self.columns, top + line * 0.7, Face::Bold);
        for (i, row) in self.rows.iter().enumerate() {
            let face = if self.marked == Some(i) { Face::Bold } else { Face::Regular };
            row_of(row, top + line * (i as f64 + 1.83), face);
        }
        rule(&mut drawing, top + line * 1.08, 1.2);
        rule(&mut drawing, top + line * (self.rows.len() as f64 + 1.25), 1.8);
        drawing
    }

    /// The size of writing at which the table fits the canvas, and the columns' widths.
    fn fitted(&self) -> (f64, Vec<f64>) {
        let widths = |size: f64| -> Vec<f64> {
            (0..self.columns.len())
                .map(|i| {
                    let cells = self.rows.iter().map(|r| font::width(&r[i], Face::Bold, size));
                    cells.fold(font::width(&self.columns[i], Face::Bold, size), f64::max)
                })
                .collect()
        };
        let mut size = SIZE * 1.1;
        let room = WIDTH - 2.0 * MARGIN - 2.0 * PAD * self.columns.len() as f64;
        while size > 8.0 && widths(size).iter().sum::<f64>() > room {
            size *= 0.96;
        }
        (size, widths(size))
    }
}

/// Clear space on both sides of a column [px].
const PAD: f64 = 12.0;

impl From<Table> for Figure {
    fn from(table: Table) -> Figure {
        let alt = format!(
            "{}. Table of {} rows; columns: {}.",
            table.heading.sentence(),
            table.rows.len(),
            table.columns.join(", ")
        );
        let mut figure = Figure::new(table.draw(), &table.heading.title, &alt);
        figure.caption = table.heading.caption();
        figure.repeats = table.repeats;
        figure.data.push(Data { repeats: table.repeats, csv: table.csv() });
        figure
    }
}
