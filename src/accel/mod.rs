//! The nearest of many things [A §5.6, D §5.4.8, E §2.2]: structures that know where not to look.
//!
//! A ray that is tested against everything pays for everything. A structure over the bounds of things answers the same,
//! to the bit, for the logarithm of the price. It knows its items by index; what an item is, and where a ray
//! meets it, is the caller's, who hands in a test.

mod bvh;
mod facets;
mod frame;
mod hulls;
mod node;
mod octree;
mod pack;
mod slabs;
mod split;
mod tree;

pub use bvh::Bvh;
pub use facets::Facets;
pub use hulls::{Hull, Hulls, as_printed_nearest};
pub use octree::{Cube, Octree, Splitting};
pub use slabs::Ball;

use crate::ray::Crossing;

/// What lies at some distance along a ray.
pub trait Along {
    /// Ray parameter [lengths of the direction].
    fn t(&self) -> f64;
}

impl Along for f64 {
    #[inline]
    fn t(&self) -> f64 {
        *self
    }
}

impl Along for Crossing {
    #[inline]
    fn t(&self) -> f64 {
        self.t
    }
}
