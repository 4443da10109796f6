//! The verbs of the `lightbench` command: what each does with files, apart from reading flags.

pub mod compare;
