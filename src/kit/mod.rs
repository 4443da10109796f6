//! The kit of lessons and commands: flags, progress, figures.

pub mod figure;
pub mod flags;
pub mod lesson;
pub mod page;
pub mod progress;
pub mod replay;
