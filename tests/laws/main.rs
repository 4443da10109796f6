//! Laws: properties and invariants, module by module.

#[path = "../support/mod.rs"]
mod support;

mod sample;
mod statistics;
