//! Meshes: surfaces as polygons that share their corners [A §2.1–2.2, D §4.9, §5.4.8, §5.6.2].
//!
//! [`Polygons`] is what files hold and [`tessellate`] makes: a list of points, and faces that count in it [A ill. 5].
//! [`EdgeList`] [A ill. 6] and [`HalfEdges`] hold the same with the edges between; [`Topology`] says whether it is closed.
//! [`Mesh`] is a [`Shape`](crate::shape::Shape): triangles in a hierarchy of boxes, met without gaps.

mod closed;
mod edge_list;
mod half_edge;
mod line;
mod normals;
mod polygons;
mod surface;
mod tangents;
pub mod tessellate;
mod topology;
mod triangulate;

pub use closed::ClosedMesh;
pub use edge_list::EdgeList;
pub use half_edge::{Half, HalfEdges, NotAManifold};
pub use polygons::{Attribute, Corner, NONE, Polygons};
pub use surface::{Mesh, Repairs};
pub use tangents::{Tangent, Tangents};
pub use topology::Topology;
pub use triangulate::{Cut, MOST_CONCAVE, MeshError, Outline, triangulate};
