//! The verbs of the `lightbench` command.

pub mod check;
