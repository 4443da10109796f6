//! The format as a table: every block, its parameters, their values, defaults and units.
//!
//! The parser, its messages and the printed reference all read this table; a new block is a new row
//! here, and its construction in `build`.

mod lights;
mod material;
mod objects;
mod solids;

pub use material::READ_BY;
pub use objects::TRANSFORMATIONS;

use super::format::{Default, Domain, Kind, Names, Origin, Param, Role, Rule, State};

/// The block of that name.
pub fn rule(name: &str) -> Option<&'static Rule> {
    rules().find(|r| r.name == name)
}

/// Every block of the format, in the order of the reference.
pub fn rules() -> impl Iterator<Item = &'static Rule> {
    [WORLD, objects::OBJECTS, solids::OPERATIONS, lights::LIGHTS].into_iter().flatten()
}

/// Largest width or height of a picture [pixels].
pub const LONGEST_SIDE: u32 = 65_535;
/// Largest picture \[pixels\]: 1.5 GiB as three `f64` each.
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
            color("BackgroundColor", Domain::NotNegative, ZERO, "radiance of a ray that hits nothing")
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
                "radiance that diffuse surfaces receive from everywhere",
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
            point("POI", ZERO, "the point at the middle of the picture"),
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
    material::MATERIAL,
];
