//! Laws: properties and invariants, module by module.

#[path = "../support/mod.rs"]
mod support;

mod architecture;
mod brdf;
mod certified;
mod figure;
mod film;
mod film_files;
mod flat;
mod frame;
mod fresnel;
mod lessons;
mod local;
mod measure;
mod num;
mod pinhole;
mod polyhedron;
mod quadrature;
mod quadrics;
mod sample;
mod scene_file;
mod scene_objects;
mod shapes;
mod sphere;
mod statistics;
mod torus;
