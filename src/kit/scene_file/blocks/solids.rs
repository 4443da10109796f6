//! The blocks that make solids of solids [D §4.8, Annex C].

use super::integer;
use super::objects::{MATERIAL, MOVED, STRETCHED, TURNED};
use crate::scene_file::format::{Default, Kind, Origin, Param, Role, Rule, State};

/// What `LeftType` and `RightType` may say.
const TYPES: &[&str] = &[
    "Sphere",
    "Box",
    "Cylinder",
    "Cone",
    "Ellipsoid",
    "Torus",
    "Julia",
    "Plane",
    "Quadric",
    "Menger",
    "Mesh",
    "Union",
    "Difference",
    "Intersection",
    "Operation",
];

const fn of_type(name: &'static str, doc: &'static str) -> Param {
    Param::new(name, "type", Kind::Choice(TYPES), Default::Absent, doc)
}

const fn index(name: &'static str, doc: &'static str) -> Param {
    Param::new(name, "n", integer(0, i64::MAX), Default::Absent, doc)
}

/// The same for all three.
const PARAMS: &[Param] = &[
    of_type("LeftType", "`.csg` files: the left operand's block; `Operation` means any of the three"),
    index("LeftIndex", "`.csg` files: which of the blocks of that type, from 0 in the order of the file"),
    of_type("RightType", "`.csg` files: the right operand's block"),
    index("RightIndex", "`.csg` files: which of the blocks of that type"),
    Param { default: Default::Absent, doc: "for the solids in it that name none", ..MATERIAL }.extension(),
    MOVED,
    TURNED,
    STRETCHED,
];

const fn operation(name: &'static str, doc: &'static str) -> Rule {
    let (role, state, origin) = (Role::Operation, State::Supported, Origin::Document);
    Rule { name, role, state, origin, doc, params: PARAMS }
}

/// Inside a `CSG` an operation holds its operands; in a `.csg` file it names two of the file's blocks.
pub const OPERATIONS: &[Rule] = &[
    operation(
        "Union",
        "What lies in any of its solids [D Annex C]. In a scene it stands in a `CSG` and † holds two or more blocks. In a \
         `.csg` file it names two blocks of the file; the one block that none names is the whole. Solids of a `.csg` file whose \
         `Material` the scene does not declare have that of the `CSG`.",
    ),
    operation(
        "Difference",
        "What lies in the first of its solids and in no other [D Annex C]; written like `Union`.",
    ),
    operation("Intersection", "What lies in all of its solids [D Annex C]; written like `Union`."),
];
