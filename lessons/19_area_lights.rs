//! Lesson 19. How many shadow rays does a soft shadow need, and where on the light should they end?
//!
//! Builds on:  17 (lights and hard shadows), 18 (where shadow rays start).
//! New here:
//! Notation:
//! Predict:
//! Figure:

use lightbench::kit::lesson::{Lesson, Result};

fn main() -> Result {
    Lesson::open(19)?.answer("")
}
