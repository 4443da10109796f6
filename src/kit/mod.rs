//! The kit of lessons and commands: flags, progress, figures.

pub mod figure;
pub mod flags;
pub mod progress;
pub mod replay;
