//! Lesson 18. How far off its surface must a ray start, so that it meets no shadow of its own and lets no light leak?
//!
//! Builds on:  02 (a ray meets a sphere), 03 (shadow rays start on surfaces), 17 (lights and hard shadows).
//! New here:
//! Notation:
//! Predict:
//! Figure:

use lightbench::kit::lesson::{Lesson, Result};

fn main() -> Result {
    Lesson::open(18)?.answer("")
}
