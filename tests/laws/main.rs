//! Laws: properties and invariants, module by module.

#[path = "../support/mod.rs"]
mod support;

mod architecture;
mod film;
mod film_files;
mod frame;
mod local;
mod pinhole;
mod sample;
mod scene_file;
mod statistics;
