//! What lessons are made with.

pub mod figure;
