//! What shines.

use super::{ANY, MOST_CELLS, ONES, ZERO, color, integer, length, number, point, triple};
use crate::scene_file::format::{Default, Domain, Kind, Origin, Param, Role, Rule, State};

/// The document's measure of light.
const COLOR: Param = color(
    "Color",
    Domain::NotNegative,
    ONES,
    "a facing surface of reflectance ρ shows the radiance ρ·Color, at any distance unless there is an Attenuation",
)
.unit("W m⁻² sr⁻¹");

const fn instead(name: &'static str, unit: &'static str, doc: &'static str) -> Param {
    Param::new(name, "r g b", triple(Domain::NotNegative), Default::Absent, doc).unit(unit).extension()
}

const INTENSITY: Param =
    instead("Intensity", "W sr⁻¹", "instead of Color: thins out with the squared distance");
const FLUX: Param = instead(
    "Flux",
    "W",
    "instead of Color: sent out evenly in all directions, thins out with the squared distance [B §7.3.2]",
);
const RADIANCE: Param =
    instead("Radiance", "W m⁻² sr⁻¹", "instead of Color: shines to its front by Lambert's cosine law");
const ATTENUATION: Param = Param::new(
    "Attenuation",
    "a b c",
    triple(Domain::NotNegative),
    Default::Absent,
    "Color is multiplied by 1/(a + b d + c d²) at the distance d [A (4.3), C §1.8.3]",
)
.extension();
const CAP: Param = Param::new(
    "AttenuationCap",
    "most",
    number(Domain::Positive),
    Default::Absent,
    "the factor of Attenuation never exceeds it; A's is 1 [A ill. 67]",
)
.extension();
const PLACEMENT: Param = Param::new(
    "Placement",
    "place",
    Kind::Choice(&["grid", "jittered", "random", "sobol", "r2"]),
    Default::Word("grid"),
    "where shadow rays end: at the centres of cells, at random in each cell, anywhere at random, or at points of a \
     low-discrepancy sequence",
)
.extension();
const SAMPLING: Param = Param::new(
    "Sampling",
    "measure",
    Kind::Choice(&["area", "solid-angle"]),
    Default::Word("area"),
    "of a light with Radiance: are the points spread evenly over its area, or over what is seen of it?",
)
.extension();
/// Of the patterns that err as noise, not as bands, Sobol's err least in lesson 19: 16 points err 0.6 times as much as
/// jittered ones by area, and on a sphere 17 times less by solid angle than by area.
const SPREAD: Param = Param { default: Default::Word("sobol"), ..PLACEMENT };
const SAMPLES: Param = Param::new(
    "Samples",
    "n",
    integer(1, MOST_CELLS as i64),
    Default::Integers(&[16]),
    "shadow rays from each point",
)
.extension();
const DIRECTION: Param = Param::new(
    "Direction",
    "x y z",
    triple(Domain::Direction),
    Default::Numbers(&[0.0, -1.0, 0.0]),
    "where it faces",
);

const fn corner(name: &'static str) -> Param {
    Param::new(name, "x y z", triple(ANY), Default::Required, "a corner").unit("m").extension()
}

const fn light(name: &'static str, origin: Origin, doc: &'static str, params: &'static [Param]) -> Rule {
    Rule { name, role: Role::Light, state: State::Supported, origin, doc, params }
}

pub const LIGHTS: &[Rule] = &[
    light(
        "PointLight",
        Origin::Document,
        "A light without size [A §4.3.1, D §4.10.1].",
        &[point("Position", ZERO, "where it is"), COLOR, INTENSITY, FLUX, ATTENUATION, CAP],
    ),
    light(
        "SpotLight",
        Origin::Extension,
        "A light without size that shines in a cone.",
        &[
            point("Position", ZERO, "where it is"),
            DIRECTION,
            Param::new(
                "Angle",
                "angle",
                number(Domain::Closed(0.1, 180.0)),
                Default::Numbers(&[30.0]),
                "half angle of the cone",
            )
            .unit("degrees"),
            Param::new(
                "FullAngle",
                "angle",
                number(Domain::Closed(0.0, 180.0)),
                Default::Absent,
                "half angle of the cone in which all of the light is let out, at most Angle; two thirds of it if not written",
            )
            .unit("degrees"),
            COLOR,
            INTENSITY,
            ATTENUATION,
            CAP,
        ],
    ),
    light(
        "DirectionalLight",
        Origin::Extension,
        "Parallel light from infinitely far away [A §4.3.3, B §7.3.1].",
        &[
            Param { doc: "where the light travels", ..DIRECTION },
            Param { doc: "a facing surface of reflectance ρ shows the radiance ρ·Color", ..COLOR },
            instead("Irradiance", "W m⁻²", "instead of Color: what a facing surface receives"),
        ],
    ),
    light(
        "AreaLight",
        Origin::Document,
        "A rectangle that shines [D §4.10.2]. Without roll its width runs horizontally.",
        &[
            COLOR,
            RADIANCE,
            point("Position", ZERO, "its centre"),
            DIRECTION,
            Param::new(
                "RollAngle",
                "angle",
                number(ANY),
                Default::Numbers(&[0.0]),
                "turns it about its direction",
            )
            .unit("rad"),
            length("Width", &[1.0], "its width"),
            length("Height", &[1.0], "its height"),
            Param::new(
                "Subdivision",
                "columns rows",
                Kind::Integers { count: 2, from: 1, to: MOST_CELLS as i64 },
                Default::Integers(&[5, 5]),
                "cells along width and height, one shadow ray each; at most 65536 in all",
            ),
            PLACEMENT,
            SAMPLING,
            ATTENUATION,
            CAP,
        ],
    ),
    light(
        "TriangleLight",
        Origin::Extension,
        "A triangle that shines [A §4.3.5]; its front shows the corners counter-clockwise.",
        &[
            corner("V0"),
            corner("V1"),
            corner("V2"),
            COLOR,
            RADIANCE,
            SAMPLES,
            SPREAD,
            SAMPLING,
            ATTENUATION,
            CAP,
        ],
    ),
    light(
        "SphereLight",
        Origin::Extension,
        "A sphere that shines outwards [A §4.3.5].",
        &[
            point("Center", ZERO, "its centre"),
            length("Radius", &[1.0], "its radius"),
            COLOR,
            RADIANCE,
            SAMPLES,
            SPREAD,
            Param { default: Default::Word("solid-angle"), ..SAMPLING },
            ATTENUATION,
            CAP,
        ],
    ),
];
