//! The blocks that describe objects.

use super::{ANY, ONES, SOURCE, ZERO, integer, length, number, point, triple};
use crate::scene_file::format::{Default, Domain, Kind, Names, Origin, Param, Role, Rule, State};
use crate::sdf::Menger;

pub(super) const MATERIAL: Param = Param::new(
    "Material",
    "name",
    Kind::Reference(Names::Material),
    Default::Required,
    "a material declared above",
);
const TRANSLATION: Param =
    Param::new("Translation", "x y z", triple(ANY), Default::Absent, "moves it").unit("m").repeatable();
const ROTATION: Param = Param::new(
    "Rotation",
    "x y z angle",
    Kind::Numbers { count: 4, domain: Domain::AxisAngle },
    Default::Absent,
    "turns it about the axis through the origin, counter-clockwise seen from the axis' tip",
)
.unit("rad")
.repeatable();
const SCALE: Param = Param::new(
    "Scale",
    "x y z",
    triple(Domain::EachNotZero),
    Default::Absent,
    "stretches it about the origin; negative factors mirror",
)
.repeatable();

/// What moves, turns and stretches.
pub const TRANSFORMATIONS: &[Param] = &[TRANSLATION, ROTATION, SCALE];

pub(super) const MOVED: Param = TRANSLATION.extension();
pub(super) const TURNED: Param = ROTATION.extension();
pub(super) const STRETCHED: Param = SCALE.extension();
const SIDES: Param = Param::new(
    "Sides",
    "side",
    Kind::Choice(&["both", "front"]),
    Default::Word("both"),
    "from which sides rays hit it: from both, or only from the side its normal points to",
);

const UP: &[f64] = &[0.0, 1.0, 0.0];

const fn direction(name: &'static str, doc: &'static str) -> Param {
    Param::new(name, "x y z", triple(Domain::Direction), Default::Numbers(UP), doc)
}

const fn corner(name: &'static str, doc: &'static str) -> Param {
    Param::new(name, "x y z", triple(ANY), Default::Required, doc).unit("m")
}

const fn radius(name: &'static str, default: &'static [f64], doc: &'static str) -> Param {
    Param::new(name, "length", number(Domain::NotNegative), Default::Numbers(default), doc).unit("m")
}

const fn coefficient(name: &'static str, doc: &'static str) -> Param {
    Param::new(name, "number", number(ANY), Default::Numbers(&[0.0]), doc)
}

const fn clip(name: &'static str, doc: &'static str) -> Param {
    Param::new(name, "x y z", triple(ANY), Default::Absent, doc).unit("m")
}

/// A block of the document.
const fn documented(name: &'static str, state: State, doc: &'static str, params: &'static [Param]) -> Rule {
    Rule { name, role: Role::Object, state, origin: Origin::Document, doc, params }
}

/// A block of this project.
const fn own(name: &'static str, doc: &'static str, params: &'static [Param]) -> Rule {
    Rule { name, role: Role::Object, state: State::Supported, origin: Origin::Extension, doc, params }
}

/// What a scene is made of.
pub const OBJECTS: &[Rule] = &[
    documented(
        "Sphere",
        State::Supported,
        "A sphere [D §4.7.1].",
        &[
            MATERIAL,
            point("Center", ZERO, "its centre"),
            length("Radius", &[1.0], "its radius"),
            MOVED,
            TURNED,
            STRETCHED,
        ],
    ),
    documented(
        "Box",
        State::Supported,
        "The cube of edge 1 about the origin, transformed [D §4.7.2].",
        &[MATERIAL, TRANSLATION, ROTATION, SCALE],
    ),
    documented(
        "Cylinder",
        State::Supported,
        "A cylinder with its caps [D §4.7.3].",
        &[
            MATERIAL,
            point("Base", ZERO, "centre of its base"),
            direction("Axis", "from the base to the top"),
            length("Height", &[1.0], "from the base to the top"),
            length("Radius", &[1.0], "its radius"),
            MOVED,
            TURNED,
            STRETCHED,
        ],
    ),
    own(
        "Cone",
        "A cone, or with both radii a frustum, and its caps [A §2.3.1]. Not both radii are 0.",
        &[
            MATERIAL,
            point("Base", ZERO, "centre of its base"),
            direction("Axis", "from the base to the top"),
            length("Height", &[1.0], "from the base to the top"),
            radius("Radius", &[1.0], "radius of the base"),
            radius("TopRadius", &[0.0], "radius of the top"),
            MOVED,
            TURNED,
            STRETCHED,
        ],
    ),
    own(
        "Ellipsoid",
        "An ellipsoid with its axes along the coordinate axes [A (2.6)].",
        &[
            MATERIAL,
            point("Center", ZERO, "its centre"),
            Param::new(
                "SemiAxes",
                "a b c",
                triple(Domain::Positive),
                Default::Numbers(ONES),
                "from the centre to the surface along x, y and z",
            )
            .unit("m"),
            MOVED,
            TURNED,
            STRETCHED,
        ],
    ),
    own(
        "Torus",
        "A ring: a circle swept around a larger one [A §2.3.2]. `Major` exceeds `Minor`.",
        &[
            MATERIAL,
            point("Center", ZERO, "its centre"),
            direction("Axis", "through the hole"),
            length("Major", &[1.0], "from the centre to the middle of the tube"),
            length("Minor", &[0.25], "radius of the tube"),
            MOVED,
            TURNED,
            STRETCHED,
        ],
    ),
    own(
        "Julia",
        "A slice of a quaternion Julia set [A §2.4]: the points x + y i + z j + w k that are no farther than `Bailout` from 0 \
         after `Iterations` steps of q² + c.",
        &[
            MATERIAL,
            Param::new(
                "C",
                "c0 c1 c2 c3",
                Kind::Numbers { count: 4, domain: ANY },
                Default::Numbers(&[-0.2, 0.6, 0.2, 0.2]),
                "the quaternion that is added, its factors of 1, i, j and k; its length is at most 100",
            ),
            Param::new(
                "Iterations",
                "steps",
                Kind::Integers { count: 1, from: 0, to: 100 },
                Default::Integers(&[8]),
                "steps of the iteration; each doubles the degree of the surface",
            ),
            Param::new(
                "NormalIterations",
                "steps",
                Kind::Integers { count: 1, from: 0, to: 100 },
                Default::Absent,
                "steps of the iteration whose gradient shades; none: those of the surface",
            ),
            Param::new(
                "Bailout",
                "length",
                number(Domain::Positive),
                Default::Numbers(&[2.0]),
                "what counts as far; at most 10⁶⁰",
            ),
            Param::new(
                "W",
                "w",
                number(ANY),
                Default::Numbers(&[0.0]),
                "the slice: the factor of k of all points",
            ),
            point("Center", ZERO, "its point 0"),
            length("Unit", &[1.0], "the length of its 1"),
            MOVED,
            TURNED,
            STRETCHED,
        ],
    ),
    own(
        "Plane",
        "A plane without bounds [A §2.3].",
        &[
            MATERIAL,
            point("Point", ZERO, "a point of it"),
            direction("Normal", "square to it"),
            SIDES,
            MOVED,
            TURNED,
            STRETCHED,
        ],
    ),
    own(
        "Disc",
        "A flat round plate [E problem 5.1].",
        &[
            MATERIAL,
            point("Center", ZERO, "its centre"),
            direction("Normal", "square to it"),
            length("Radius", &[1.0], "its radius"),
            SIDES,
            MOVED,
            TURNED,
            STRETCHED,
        ],
    ),
    own(
        "Triangle",
        "A triangle [A §5.4.1]; its front shows the corners counter-clockwise.",
        &[
            MATERIAL,
            corner("V0", "first corner"),
            corner("V1", "second corner"),
            corner("V2", "third corner"),
            SIDES,
            MOVED,
            TURNED,
            STRETCHED,
        ],
    ),
    own(
        "Quadric",
        "The surface A x² + E y² + H z² + 2B xy + 2F yz + 2C xz + 2D x + 2G y + 2I z + J = 0 [A (2.1)], lengths in m; \
         what lies outside a clip box is cut off, and leaves it open there. One number beside J is not 0.",
        &[
            MATERIAL,
            coefficient("A", "of x²"),
            coefficient("B", "half that of xy"),
            coefficient("C", "half that of xz"),
            coefficient("D", "half that of x"),
            coefficient("E", "of y²"),
            coefficient("F", "half that of yz"),
            coefficient("G", "half that of y"),
            coefficient("H", "of z²"),
            coefficient("I", "half that of z"),
            coefficient("J", "constant"),
            clip("ClipMin", "lowest corner of the clip box; none: unbounded that way"),
            clip("ClipMax", "highest corner of the clip box; none: unbounded that way"),
            MOVED,
            TURNED,
            STRETCHED,
        ],
    ),
    own(
        "Menger",
        "A Menger sponge: a cube cut into 27, of which seven are taken away, and so again with those that are left [E §2.3].",
        &[
            MATERIAL,
            point("Center", ZERO, "its centre"),
            length("Edge", &[1.0], "edge of the cube"),
            Param::new(
                "Depth",
                "n",
                integer(0, Menger::MOST_DEPTH as i64),
                Default::Integers(&[3]),
                "how often it is cut; 0 is the whole cube",
            ),
            MOVED,
            TURNED,
            STRETCHED,
        ],
    ),
    documented(
        "CSG",
        State::Supported,
        "Solids combined by union, intersection and difference [D §4.8]: from a `.csg` file, or † written inside it, as \
         `CSG { Material m  Difference { Box { } Sphere { Material n } } }`. Solids inside that name no material have \
         that of what holds them. Solids are `Sphere`, `Box`, `Cylinder`, `Cone`, `Ellipsoid`, `Torus`, `Julia`, `Menger`, a \
         closed `Mesh`, `Quadric` without clip box, and `Plane`, which is everything behind it.",
        &[
            MATERIAL,
            Param::new("Source", "\"file\"", Kind::Text, Default::Absent, "the `.csg` file, beside this one"),
            MOVED,
            TURNED,
            STRETCHED,
        ],
    ),
    documented(
        "Mesh",
        State::Supported,
        "Polygons from an OBJ file [D §4.9]. Without `Material` † its faces are made of the \
         materials of the file's own libraries. A closed mesh is a solid: it may stand in a `CSG` †.",
        &[
            Param::new(
                "Material",
                "name",
                Kind::Reference(Names::Material),
                Default::Absent,
                "a material declared above, for all faces",
            ),
            SOURCE,
            TRANSLATION,
            ROTATION,
            SCALE,
            Param::new(
                "Normals",
                "which",
                Kind::Choice(&["file", "smooth", "flat"]),
                Default::Word("file"),
                "those of the file, and computed ones where it has none; all computed; or none, so that facets show",
            )
            .extension(),
            Param::new(
                "Crease",
                "angle",
                number(Domain::Closed(0.0, 180.0)),
                Default::Numbers(&[50.0]),
                "where computed: edges that bend by more than this stay sharp",
            )
            .unit("degrees")
            .extension(),
        ],
    ),
];
