//! Laws: properties and invariants, module by module.

#[path = "../support/mod.rs"]
mod support;

mod architecture;
mod figure;
mod film;
mod film_files;
mod frame;
mod lessons;
mod local;
mod measure;
mod sample;
mod scene_file;
mod statistics;
