//! Closed forms and high-precision tables.

mod surfaces;
