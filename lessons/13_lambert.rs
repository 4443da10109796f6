//! Lesson 13. What does each simplification of local light cost the picture, and what does it save?
//!
//! Builds on:  03 (a light, a shadow and a first picture).
//! New here:
//! Notation:
//! Predict:
//! Figure:

use lightbench::kit::lesson::{Lesson, Result};

fn main() -> Result {
    Lesson::open(13)?.answer("")
}
