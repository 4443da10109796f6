//! Lesson 15. Which formula for a highlight is worth its time, and what do the others get wrong?
//!
//! Builds on:  13 (Lambert's law and ambient light).
//! New here:
//! Notation:
//! Predict:
//! Figure:

use lightbench::kit::lesson::{Lesson, Result};

fn main() -> Result {
    Lesson::open(15)?.answer("")
}
