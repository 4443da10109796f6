//! `probe`: a library function on each row of a table.
//!
//! Students check exercises with it, and other programs check the library: a CSV with a header goes
//! in, a CSV with the answers comes out, row by row, every number printed so that it reads back exactly.

pub mod surface;

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
    names: &'a [&'static str],
    cells: &'a [&'a str],
}

impl Row<'_> {
    /// The text of a column that the topic declares.
    pub fn text(&self, column: &str) -> &str {
        let i = self
            .names
            .iter()
            .position(|n| *n == column)
            .unwrap_or_else(|| panic!("undeclared column {column}"));
        self.cells[i].trim()
    }

    /// The number in a column; a blank, a word or a NaN is an error, infinities are allowed.
    pub fn number(&self, column: &str) -> Result<f64, RowError> {
        let text = self.text(column);
        match text.parse::<f64>() {
            Ok(x) if !x.is_nan() => Ok(x),
            _ => Err(self.error(column, "a number")),
        }
    }

    /// The vector in the columns `{prefix}x {prefix}y {prefix}z`.
    pub fn vector(&self, prefix: &str) -> Result<glam::DVec3, RowError> {
        let n = |axis: &str| self.number(&format!("{prefix}{axis}"));
        Ok(glam::DVec3::new(n("x")?, n("y")?, n("z")?))
    }

    pub fn error(&self, column: &str, expected: &str) -> RowError {
        let found = self.text(column);
        let found = if found.is_empty() { "nothing".to_string() } else { format!("`{found}`") };
        RowError { column: column.to_string(), expected: expected.to_string(), found }
    }
}
