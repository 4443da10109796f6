//! Meshes: what hangs together, what is closed, what is inside, and no ray between the faces.

mod obj;
mod scene;
mod solid;
mod topology;
