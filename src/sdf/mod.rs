//! Distance fields and fractals.

pub mod julia;
