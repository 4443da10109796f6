//! Tables of truth in `tests/data/`.

use std::collections::HashMap;

/// A CSV file with a header, in memory; lines that start with `#` are comments.
pub struct Table {
    columns: HashMap<String, usize>,
    rows: Vec<csv::StringRecord>,
}

impl Table {
    /// Reads `tests/data/<file>`.
    pub fn read(file: &str) -> Table {
        let path = format!("{}/tests/data/{file}", env!("CARGO_MANIFEST_DIR"));
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(&path).expect(&path);
        let columns =
            reader.headers().expect(&path).iter().enumerate().map(|(i, c)| (c.to_string(), i)).collect();
        let rows: Vec<_> = reader.records().collect::<Result<_, _>>().expect(&path);
        assert!(!rows.is_empty(), "{path} is empty");
        Table { columns, rows }
    }

    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.rows.iter().map(|record| Row { table: self, record })
    }
}

/// One row of a [`Table`].
#[derive(Clone, Copy)]
pub struct Row<'a> {
    table: &'a Table,
    record: &'a csv::StringRecord,
}

impl<'a> Row<'a> {
    /// The text of a cell.
    pub fn text(&self, column: &str) -> &'a str {
        let i = self.table.columns.get(column).unwrap_or_else(|| panic!("no column {column}"));
        &self.record[*i]
    }

    /// The number in a cell.
    pub fn f64(&self, column: &str) -> f64 {
        self.text(column).parse().unwrap_or_else(|_| panic!("{column} is no number in {:?}", self.record))
    }

    /// The number in a cell, or `None` of an empty one.
    pub fn optional(&self, column: &str) -> Option<f64> {
        (!self.text(column).is_empty()).then(|| self.f64(column))
    }
}
