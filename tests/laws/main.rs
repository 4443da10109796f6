//! Laws: properties and invariants, module by module.

mod architecture;
mod film;
mod film_files;
mod frame;
mod local;
mod num;
mod scene_file;
mod torus;
