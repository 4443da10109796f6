//! Transformations: in written order, and out of the way where the shape's own numbers can take them in.

use crate::frame::rotation_about;
use crate::scene_file::parse::Block;
use crate::shape::cuboid::Cuboid;
use crate::shape::instance::Instance;
use crate::shape::quadric::Ellipsoid;
use crate::shape::sphere::Sphere;
use crate::shape::{Shape, ShapeError, Solid};
use glam::{DAffine3, DMat3, DVec3};

/// A shape, or why there is none.
pub type Made = Result<Box<dyn Shape>, ShapeError>;
/// A solid, or why there is none.
pub type MadeSolid = Result<Box<dyn Solid>, ShapeError>;

/// A shape in its place.
pub enum Put<S: Shape> {
    AsItIs(S),
    Moved(Box<Instance<S>>),
}

impl<S: Shape + 'static> Put<S> {
    pub fn shape(self) -> Box<dyn Shape> {
        match self {
            Put::AsItIs(shape) => Box::new(shape),
            Put::Moved(shape) => shape,
        }
    }
}

impl<S: Solid + 'static> Put<S> {
    pub fn solid(self) -> Box<dyn Solid> {
        match self {
            Put::AsItIs(solid) => Box::new(solid),
            Put::Moved(solid) => solid,
        }
    }
}

/// All transformations of a block, in written order.
pub fn transformation(block: &Block) -> DAffine3 {
    let mut map = DAffine3::IDENTITY;
    for entry in &block.entries {
        let Some(value) = &entry.value else { continue };
        let step = match (entry.param.name, value.numbers()) {
            ("Translation", &[x, y, z]) => DAffine3::from_translation(DVec3::new(x, y, z)),
            ("Scale", &[x, y, z]) => DAffine3::from_scale(DVec3::new(x, y, z)),
            ("Rotation", &[x, y, z, angle]) => {
                let turn = rotation_about(DVec3::new(x, y, z), angle).unwrap_or(DMat3::IDENTITY);
                DAffine3::from_mat3(turn)
            }
            _ => continue,
        };
        map = step * map;
    }
    map
}

/// A shape whose points `made` moves by a vector, under a map: an instance only if the map does more than move.
pub fn placed<S: Shape>(
    map: DAffine3,
    made: impl Fn(DVec3) -> Result<S, ShapeError>,
) -> Result<Put<S>, ShapeError> {
    if map.matrix3 == DMat3::IDENTITY {
        return Ok(Put::AsItIs(made(map.translation)?));
    }
    instance(made(DVec3::ZERO)?, map)
}

/// A shape under a map; itself if the map changes nothing.
pub fn instance<S: Shape>(shape: S, map: DAffine3) -> Result<Put<S>, ShapeError> {
    if map == DAffine3::IDENTITY {
        return Ok(Put::AsItIs(shape));
    }
    Ok(Put::Moved(Box::new(Instance::new(Box::new(shape), map)?)))
}

/// The factors of a map that only stretches along the axes and moves.
fn stretch(map: DAffine3) -> Option<DVec3> {
    let m = map.matrix3;
    let factors = DVec3::new(m.x_axis.x, m.y_axis.y, m.z_axis.z);
    (m == DMat3::from_diagonal(factors)).then_some(factors)
}

/// The cube of edge 1 about the origin under a map: a plain box if its edges stay along the axes.
pub fn cube(map: DAffine3) -> MadeSolid {
    let half = DVec3::splat(0.5);
    match stretch(map) {
        Some(factors) => {
            let reach = (factors * half).abs();
            Ok(Box::new(Cuboid::new(map.translation - reach, map.translation + reach)?))
        }
        None => Ok(instance(Cuboid::new(-half, half)?, map)?.solid()),
    }
}

/// An ellipsoid under a map: a sphere or a plain ellipsoid if its axes stay along the axes and nothing is mirrored.
pub fn ellipsoid(center: DVec3, semi_axes: DVec3, map: DAffine3) -> MadeSolid {
    let Some(factors) = stretch(map).filter(|f| f.cmpgt(DVec3::ZERO).all()) else {
        return Ok(instance(Ellipsoid::new(center, semi_axes)?, map)?.solid());
    };
    let (center, semi_axes) = (center * factors + map.translation, semi_axes * factors);
    if semi_axes == DVec3::splat(semi_axes.x) {
        return Ok(Box::new(Sphere::new(center, semi_axes.x)?));
    }
    Ok(Box::new(Ellipsoid::new(center, semi_axes)?))
}
