//! Laws: properties and invariants, module by module.

#[path = "../support/mod.rs"]
mod support;

mod accel;
mod architecture;
mod area_light;
mod area_lights;
mod brdf;
mod certified;
mod colour;
mod cove;
mod csg;
mod csg_files;
mod figure;
mod film;
mod film_files;
mod flat;
mod frame;
mod fresnel;
mod highlights;
mod julia;
mod leaving;
mod lessons;
mod light_files;
mod lights;
mod local;
mod measure;
mod menger;
mod mesh;
mod num;
mod outline;
mod pinhole;
mod polyhedron;
mod progress;
mod quadrature;
mod quadrics;
mod sample;
mod scene_file;
mod scene_objects;
mod sdf;
mod shapes;
mod sphere;
mod stage;
mod statistics;
mod torus;
