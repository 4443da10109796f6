//! Properties that hold for every input.

mod certified;
mod flat;
mod quadrics;
mod shapes;
