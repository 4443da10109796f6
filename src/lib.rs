//! lightbench: an optical bench for learning light transport.
//!
//! The library implements, chapter by chapter, what five course documents teach, from ray casting
//! to photon mapping; the numbered lessons draw the documents' figures with it; the tests hold
//! every formula against truth. `ARCHITECTURE.md` explains the layout and the conventions.
//!
//! Modules stand on floors, and a module imports strictly lower floors only:
//!
//! | floor | module | holds |
//! |---|---|---|
//! | 0 | [`num`], [`color`] | polynomial roots, rounding bounds, compensated sums, quadrature, statistics; colour spaces |
//! | 1 | [`ray`], [`frame`], [`bounds`] | rays, hits, the trace hook; rotations and bases; boxes and spheres |
//! | 2 | [`sample`], [`film`], [`measure`] | random numbers and warps; images and their metrics; cost and error of methods |
//! | 3 | [`shape`], [`accel`], [`fresnel`] | one file per surface: where a ray meets it, and its solid's spans; the nearest of many things with bounds; what a boundary reflects |
//! | 4 | [`bsdf`], [`csg`], [`light`], [`mesh`], [`sdf`] | reflection models: eval, sample, pdf, albedo; solids made of solids by root diagrams; emission and its fall-off; polygons, half-edges, triangles in a hierarchy of boxes; distance fields, marching, the Menger sponge, Julia sets |
//! | 5 | [`scene`] | camera, objects, materials |
//! | 6 | [`scene_file`] | readers of the documents' formats |
//! | 8 | [`integrator`] | each turns a ray into radiance |
//! | 9 | [`render`] | the tile loop: threads, progress, interruption |
//! | 11 | [`kit`], [`probe`] | charts, diagrams, lessons, the page; one function on each row of a table |
//! | 12 | [`command`] | the verbs of the `lightbench` command |
//!
//! The table is law: `tests/laws/architecture.rs` reads it, and fails on an import that goes up or sideways.

pub mod accel;
pub mod bounds;
pub mod bsdf;
pub mod color;
pub mod command;
pub mod csg;
pub mod film;
pub mod frame;
pub mod fresnel;
pub mod integrator;
pub mod kit;
pub mod light;
pub mod measure;
pub mod mesh;
pub mod num;
pub mod probe;
pub mod ray;
pub mod render;
pub mod sample;
pub mod scene;
pub mod scene_file;
pub mod sdf;
pub mod shape;
