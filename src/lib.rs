//! lightbench: an optical bench for learning light transport.
//!
//! The library implements, chapter by chapter, what five course documents teach, from ray casting
//! to photon mapping; the numbered lessons draw the documents' figures with it; the tests hold
//! every formula against truth. `ARCHITECTURE.md` explains the layout and the conventions.
//!
//! Modules stand on floors, and a module imports strictly lower floors only. Those marked * belong to the crate
//! `lightbench_kit`, `command` is a crate of its own:
//!
//! | floor | module | holds |
//! |---|---|---|
//! | 0 | [`num`], [`color`] | polynomial roots, rounding bounds, compensated sums, quadrature, statistics; colour spaces |
//! | 1 | [`ray`], [`frame`], [`bounds`] | rays, hits, the trace hook; rotations and bases; boxes and spheres |
//! | 2 | [`sample`], [`film`], [`measure`] | random numbers and warps; images and their metrics; cost and error of methods |
//! | 3 | [`shape`], [`accel`], [`fresnel`], `file`* | one file per surface: where a ray intersects it, and its solid's spans; the nearest of many objects with bounds; what a boundary reflects; files of pictures |
//! | 4 | [`bsdf`], [`csg`], [`light`], [`mesh`], [`sdf`] | reflection models: eval, sample, pdf, albedo; solids made of solids by root diagrams; emission and its fall-off; polygons, half-edges, triangles in a hierarchy of boxes; distance fields, marching, the Menger sponge, Julia sets |
//! | 5 | [`scene`] | camera, objects, materials |
//! | 6 | `scene_file`* | readers of the documents' formats |
//! | 8 | [`integrator`] | each turns a ray into radiance |
//! | 9 | [`render`] | the tile loop: threads, progress, interruption |
//! | 10 | `figure`*, `flags`*, `progress`* | charts, diagrams, panels; the flags of every program; the bar on stderr |
//! | 11 | `compare`*, `essay`*, `probe`*, `replay`*, `stage`*, `syllabus`* | two pictures in numbers; a lesson's text; one function on each row of a table; the rays of one pixel; the house stage of the lessons' pictures; the list of lessons |
//! | 12 | `page`* | the pages that students read |
//! | 13 | `lesson`* | the harness of lessons |
//! | 14 | `command` | the verbs of the `lightbench` command |
//!
//! The table is law: `tests/laws/architecture.rs` reads it, and fails on an import that goes up or sideways.

pub mod accel;
pub mod bounds;
pub mod bsdf;
pub mod color;
pub mod csg;
pub mod film;
pub mod frame;
pub mod fresnel;
pub mod integrator;
pub mod light;
pub mod measure;
pub mod mesh;
pub mod num;
pub mod ray;
pub mod render;
pub mod sample;
pub mod scene;
pub mod sdf;
pub mod shape;
