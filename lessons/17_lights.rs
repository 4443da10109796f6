//! Lesson 17. What does each kind of light ask of a shadow ray, and what does remembering the last blocker save?
//!
//! Builds on:  03 (a light, a shadow and a first picture), 13 (Lambert's law).
//! New here:
//! Notation:
//! Predict:
//! Figure:

use lightbench::kit::lesson::{Lesson, Result};

fn main() -> Result {
    Lesson::open(17)?.answer("")
}
