//! The `lightbench` command as its users meet it: what it prints, what it writes, how it ends.

mod bench;
mod check;
mod compare;
mod csg;
mod interrupt;
mod lights;
mod probe;
mod quality;
mod readme;
mod render;
mod usage;
