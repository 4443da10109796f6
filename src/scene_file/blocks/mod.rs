//! The format as a table: every block, its parameters, their values, defaults and units.
//!
//! The parser, its messages and the printed reference all read this table; a new block is a new row
//! here, and its construction in `build`.

mod objects;
mod solids;

use super::format::{Default, Domain, Kind, Names, Origin, Param, Role, Rule, State};

/// The block of that name.
pub fn rule(name: &str) -> Option<&'static Rule> {
    rules().find(|r| r.name == name)
}

/// Every block of the format, in the order of the reference.
pub fn rules() -> impl Iterator<Item = &'static Rule> {
    [WORLD, objects::OBJECTS, solids::OPERATIONS, LIGHTS].into_iter().flatten()
}

/// Largest width or height of a picture [pixels].
pub const LONGEST_SIDE: u32 = 65_535;
/// Largest picture [pixels]: 1.5 GiB as three `f64` each.
pub const MOST_PIXELS: u64 = 1 << 26;
/// Most cells of an area light, each a shadow ray at every hit.
pub const MOST_CELLS: u64 = 65_536;

const ANY: Domain = Domain::Any;
const SHARE: Domain = Domain::Closed(0.0, 1.0);

const fn number(domain: Domain) -> Kind {
    Kind::Numbers { count: 1, domain }
}

const fn triple(domain: Domain) -> Kind {
    Kind::Numbers { count: 3, domain }
}

const fn integer(from: i64, to: i64) -> Kind {
    Kind::Integers { count: 1, from, to }
}

const fn color(name: &'static str, domain: Domain, default: &'static [f64], doc: &'static str) -> Param {
    Param::new(name, "r g b", triple(domain), Default::Numbers(default), doc)
}

const fn point(name: &'static str, default: &'static [f64], doc: &'static str) -> Param {
    Param::new(name, "x y z", triple(ANY), Default::Numbers(default), doc).unit("m")
}

const fn length(name: &'static str, default: &'static [f64], doc: &'static str) -> Param {
    Param::new(name, "length", number(Domain::Positive), Default::Numbers(default), doc).unit("m")
}

const fn texture(name: &'static str, doc: &'static str) -> Param {
    Param::new(name, "name", Kind::Reference(Names::Texture), Default::Absent, doc)
}

const fn setting(name: &'static str, to: i64, default: &'static [i64], doc: &'static str) -> Param {
    Param::new(name, "n", integer(0, to), Default::Integers(default), doc)
}

const NAME: Param =
    Param::new("Name", "name", Kind::Name, Default::Required, "what other blocks call it; unique");
const SOURCE: Param =
    Param::new("Source", "\"file\"", Kind::Text, Default::Required, "path of the file to load");
const ZERO: &[f64] = &[0.0, 0.0, 0.0];
const ONES: &[f64] = &[1.0, 1.0, 1.0];
const SIDE: Kind = integer(1, LONGEST_SIDE as i64);

/// The picture, the viewer, and what surfaces are made of.
const WORLD: &[Rule] = &[
    Rule {
        name: "SceneSettings",
        role: Role::Settings,
        state: State::Supported,
        origin: Origin::Document,
        doc: "The picture and its quality [D §4.3]. If there are several, the last one wins.",
        params: &[
            color("BackgroundColor", Domain::NotNegative, ZERO, "radiance where a ray meets nothing")
                .unit("W m⁻² sr⁻¹"),
            Param::new("RenderWidth", "n", SIDE, Default::Integers(&[512]), "width of the picture")
                .unit("pixels"),
            Param::new("RenderHeight", "n", SIDE, Default::Integers(&[512]), "height of the picture")
                .unit("pixels"),
            setting("ReflectionQuality", 1000, &[3], "2n² rays for each glossy reflection"),
            setting("ReflectionSteps", 1000, &[1], "most reflections in a row"),
            setting("IndirectQuality", 1000, &[3], "2n² rays for indirect light, which is computed if n > 2"),
            Param::new(
                "ColorBleeding",
                "factor",
                number(Domain::NotNegative),
                Default::Numbers(&[1.0]),
                "multiplies indirect light",
            ),
            Param::new(
                "Antialiasing",
                "n",
                integer(i64::MIN, i64::MAX),
                Default::Integers(&[1]),
                "samples in each pixel: 1, 4 or 16; anything else means the default",
            ),
            color(
                "AmbientLight",
                Domain::NotNegative,
                ZERO,
                "radiance that matt surfaces see from everywhere",
            )
            .unit("W m⁻² sr⁻¹")
            .extension(),
        ],
    },
    Rule {
        name: "Camera",
        role: Role::Camera,
        state: State::Supported,
        origin: Origin::Document,
        doc: "Where the picture is seen from [D §4.4]. If there are several, the last one wins.",
        params: &[
            point("POV", &[0.0, 1.0, 1.0], "where the camera stands"),
            point("POI", ZERO, "where it looks"),
            Param::new(
                "FOV",
                "angle",
                number(Domain::Open(0.0, 180.0)),
                Default::Numbers(&[45.0]),
                "from the picture's bottom edge to its top edge",
            )
            .unit("degrees"),
            Param::new(
                "Up",
                "x y z",
                triple(Domain::Direction),
                Default::Numbers(&[0.0, 1.0, 0.0]),
                "towards the picture's top",
            )
            .extension(),
        ],
    },
    Rule {
        name: "Texture",
        role: Role::Named(Names::Texture),
        state: State::Planned,
        origin: Origin::Document,
        doc: "A picture for materials [D §4.5].",
        params: &[NAME, SOURCE],
    },
    Rule {
        name: "Material",
        role: Role::Named(Names::Material),
        state: State::Supported,
        origin: Origin::Document,
        doc: "How surfaces look [D §4.6]. Spheres, boxes and other primitives use its colours, never its textures.",
        params: &[
            NAME,
            color("DiffuseColor", SHARE, &[0.9, 0.9, 0.9], "share of light sent back in all directions"),
            color(
                "SpecularColor",
                SHARE,
                &[0.8, 0.8, 0.8],
                "share of light sent back about the mirror direction",
            ),
            color("EmissiveColor", Domain::NotNegative, ZERO, "radiance of its own").unit("W m⁻² sr⁻¹"),
            texture("DiffuseTexture", "multiplies DiffuseColor"),
            texture("SpecularTexture", "multiplies SpecularColor"),
            texture("EmissiveTexture", "multiplies EmissiveColor"),
            texture("NormalTexture", "tilts the normals"),
            Param::new("Roughness", "r", number(SHARE), Default::Numbers(&[0.5]), "0 polished … 1 rough"),
            Param::new("Opacity", "o", number(SHARE), Default::Numbers(&[1.0]), "0 clear … 1 opaque"),
            Param::new(
                "RefractionIndex",
                "n",
                number(Domain::Positive),
                Default::Numbers(&[1.0]),
                "absolute index of refraction",
            ),
            Param::new(
                "ReflectionAngle",
                "angle",
                number(Domain::Closed(0.0, 90.0)),
                Default::Numbers(&[0.0]),
                "half angle of the cone of reflected rays",
            )
            .unit("degrees")
            .alias("ReflecionAngle"),
            Param::new(
                "ReflectionAmount",
                "a",
                number(SHARE),
                Default::Numbers(&[0.0]),
                "share of SpecularColor that is mirrored",
            ),
        ],
    },
];

/// What shines.
const LIGHTS: &[Rule] = &[
    Rule {
        name: "PointLight",
        role: Role::Light,
        state: State::Supported,
        origin: Origin::Document,
        doc: "A light without size [D §4.10.1].",
        params: &[
            point("Position", ZERO, "where it is"),
            color(
                "Color",
                Domain::NotNegative,
                ONES,
                "a facing surface of reflectance ρ shows the radiance ρ·Color, at any distance",
            )
            .unit("W m⁻² sr⁻¹"),
            Param::new(
                "Intensity",
                "r g b",
                triple(Domain::NotNegative),
                Default::Absent,
                "instead of Color: thins out with the squared distance",
            )
            .unit("W sr⁻¹")
            .extension(),
        ],
    },
    Rule {
        name: "AreaLight",
        role: Role::Light,
        state: State::Supported,
        origin: Origin::Document,
        doc: "A rectangle that shines [D §4.10.2]. Without roll its width runs horizontally.",
        params: &[
            color(
                "Color",
                Domain::NotNegative,
                ONES,
                "a facing surface of reflectance ρ shows the radiance ρ·Color, at any distance",
            )
            .unit("W m⁻² sr⁻¹"),
            Param::new(
                "Radiance",
                "r g b",
                triple(Domain::NotNegative),
                Default::Absent,
                "instead of Color: shines to its front by Lambert's cosine law",
            )
            .unit("W m⁻² sr⁻¹")
            .extension(),
            point("Position", ZERO, "its centre"),
            Param::new(
                "Direction",
                "x y z",
                triple(Domain::Direction),
                Default::Numbers(&[0.0, -1.0, 0.0]),
                "where it faces",
            ),
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
            Param::new(
                "Placement",
                "place",
                Kind::Choice(&["grid", "jittered"]),
                Default::Word("grid"),
                "where in its cell a shadow ray ends: at the centre, or at random",
            )
            .extension(),
        ],
    },
];
