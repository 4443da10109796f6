//! The format as a table: every block, its parameters, their values, defaults and units.
//!
//! The parser, its messages and the printed reference all read this table; a new block is a new row
//! here, and its construction in `build`.

/// Who says that a block or parameter exists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// [D §4].
    Document,
    /// This project.
    Extension,
}

/// What happens to a block once it is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    Supported,
    /// Known and checked, but nothing can be built from it yet: an error, because the picture would be wrong.
    Planned,
}

/// What a block describes, and how often it may stand in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// One; the last one wins.
    Settings,
    /// One; the last one wins.
    Camera,
    /// Any number, each with its own name.
    Named(Names),
    Object,
    Light,
}

/// A family of names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Names {
    Material,
    Texture,
}

impl Names {
    pub fn word(self) -> &'static str {
        match self {
            Names::Material => "material",
            Names::Texture => "texture",
        }
    }
}

/// Which numbers a parameter accepts. NaN and infinities are never among them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Domain {
    Any,
    Positive,
    NotNegative,
    Closed(f64, f64),
    Open(f64, f64),
    /// A vector, not the zero vector.
    Direction,
    /// None of them 0.
    EachNotZero,
    /// A direction, and an angle.
    AxisAngle,
}

impl Domain {
    /// The domain after "a number" or "3 numbers"; empty if any will do.
    pub fn words(self) -> String {
        match self {
            Domain::Any => String::new(),
            Domain::Positive => " > 0".to_owned(),
            Domain::NotNegative => " ≥ 0".to_owned(),
            Domain::Closed(from, to) => format!(" in [{from}, {to}]"),
            Domain::Open(from, to) => format!(" strictly between {from} and {to}"),
            Domain::Direction => ", not all 0".to_owned(),
            Domain::EachNotZero => ", none of them 0".to_owned(),
            Domain::AxisAngle => ", the axis not all 0".to_owned(),
        }
    }

    /// The first value that lies outside, by its index; for a zero vector, all of it (`Some(None)`).
    pub fn outside(self, values: &[f64]) -> Option<Option<usize>> {
        let each = |ok: &dyn Fn(f64) -> bool| values.iter().position(|&v| !ok(v)).map(Some);
        let zero = |v: &[f64]| v.iter().all(|&x| x == 0.0).then_some(None);
        match self {
            Domain::Any => each(&|v| v.is_finite()),
            Domain::Positive => each(&|v| v > 0.0),
            Domain::NotNegative => each(&|v| v >= 0.0),
            Domain::Closed(from, to) => each(&|v| from <= v && v <= to),
            Domain::Open(from, to) => each(&|v| from < v && v < to),
            Domain::EachNotZero => each(&|v| v != 0.0),
            Domain::Direction => zero(values),
            Domain::AxisAngle => zero(&values[..values.len().min(3)]),
        }
    }
}

/// What values a parameter takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Numbers {
        count: usize,
        domain: Domain,
    },
    /// Whole numbers from … to, both included.
    Integers {
        count: usize,
        from: i64,
        to: i64,
    },
    /// The name that this block declares.
    Name,
    /// A name declared above.
    Reference(Names),
    /// A text in double quotes.
    Text,
    Choice(&'static [&'static str]),
}

impl Kind {
    /// How many values.
    pub fn count(self) -> usize {
        match self {
            Kind::Numbers { count, .. } | Kind::Integers { count, .. } => count,
            _ => 1,
        }
    }

    /// One value, as messages say it.
    pub fn one(self) -> String {
        match self {
            Kind::Numbers { domain: Domain::Any | Domain::Direction | Domain::AxisAngle, .. } => "a number".into(),
            Kind::Numbers { domain: Domain::EachNotZero, .. } => "a number other than 0".into(),
            Kind::Numbers { domain, .. } => format!("a number{}", domain.words()),
            Kind::Integers { from, to: i64::MAX, .. } => format!("a whole number ≥ {from}"),
            Kind::Integers { from: i64::MIN, .. } => "a whole number".into(),
            Kind::Integers { from, to, .. } => format!("a whole number from {from} to {to}"),
            Kind::Name => "a name without spaces".into(),
            Kind::Reference(names) => format!("the name of a {}", names.word()),
            Kind::Text => "a text in double quotes".into(),
            Kind::Choice(words) => words.join(" or "),
        }
    }

    /// All values, as messages say it.
    pub fn all(self) -> String {
        match self {
            Kind::Numbers { count, domain } if count > 1 => format!("{count} numbers{}", domain.words()),
            Kind::Integers { count, from, to } if count > 1 => format!("{count} whole numbers from {from} to {to}"),
            _ => self.one(),
        }
    }
}

/// What holds if the parameter is not written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Default {
    /// It must be written.
    Required,
    /// Nothing.
    Absent,
    Numbers(&'static [f64]),
    Integers(&'static [i64]),
    Word(&'static str),
}

/// How often a parameter may stand in one block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Times {
    Once,
    /// Any number; the order counts.
    Any,
}

/// A parameter of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Param {
    pub name: &'static str,
    pub kind: Kind,
    pub default: Default,
    /// Names of the values, for messages and the reference: `x y z`.
    pub values: &'static str,
    /// Empty for pure numbers.
    pub unit: &'static str,
    pub doc: &'static str,
    pub times: Times,
    pub origin: Origin,
    /// A misprint of the document that is understood too.
    pub alias: Option<&'static str>,
}

impl Param {
    const fn new(
        name: &'static str,
        values: &'static str,
        kind: Kind,
        default: Default,
        doc: &'static str,
    ) -> Self {
        let (times, origin, alias) = (Times::Once, Origin::Document, None);
        Param { name, kind, default, values, unit: "", doc, times, origin, alias }
    }

    const fn unit(self, unit: &'static str) -> Self {
        Param { unit, ..self }
    }

    const fn repeatable(self) -> Self {
        Param { times: Times::Any, ..self }
    }

    const fn extension(self) -> Self {
        Param { origin: Origin::Extension, ..self }
    }

    const fn alias(self, alias: &'static str) -> Self {
        Param { alias: Some(alias), ..self }
    }
}

/// A block.
#[derive(Debug, PartialEq)]
pub struct Rule {
    pub name: &'static str,
    pub role: Role,
    pub state: State,
    pub origin: Origin,
    pub doc: &'static str,
    pub params: &'static [Param],
}

impl Rule {
    /// The parameter of that name, or with that misprint.
    pub fn param(&self, name: &str) -> Option<&'static Param> {
        self.params.iter().find(|p| p.name == name || p.alias == Some(name))
    }
}

/// The block of that name.
pub fn rule(name: &str) -> Option<&'static Rule> {
    BLOCKS.iter().find(|r| r.name == name)
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

const NAME: Param = Param::new("Name", "name", Kind::Name, Default::Required, "what other blocks call it; unique");
const MATERIAL: Param = Param::new(
    "Material",
    "name",
    Kind::Reference(Names::Material),
    Default::Required,
    "a material declared above",
);
const SOURCE: Param = Param::new("Source", "\"file\"", Kind::Text, Default::Required, "path of the file to load");
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

const ZERO: &[f64] = &[0.0, 0.0, 0.0];
const ONES: &[f64] = &[1.0, 1.0, 1.0];
const SIDE: Kind = integer(1, LONGEST_SIDE as i64);

/// Every block of the format.
pub const BLOCKS: &[Rule] = &[
    Rule {
        name: "SceneSettings",
        role: Role::Settings,
        state: State::Supported,
        origin: Origin::Document,
        doc: "The picture and its quality [D §4.3]. If there are several, the last one wins.",
        params: &[
            color("BackgroundColor", Domain::NotNegative, ZERO, "radiance where a ray meets nothing").unit("W m⁻² sr⁻¹"),
            Param::new("RenderWidth", "n", SIDE, Default::Integers(&[512]), "width of the picture").unit("pixels"),
            Param::new("RenderHeight", "n", SIDE, Default::Integers(&[512]), "height of the picture").unit("pixels"),
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
            color("AmbientLight", Domain::NotNegative, ZERO, "radiance that matt surfaces see from everywhere")
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
            color("SpecularColor", SHARE, &[0.8, 0.8, 0.8], "share of light sent back about the mirror direction"),
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
    Rule {
        name: "Sphere",
        role: Role::Object,
        state: State::Supported,
        origin: Origin::Document,
        doc: "A sphere [D §4.7.1].",
        params: &[MATERIAL, point("Center", ZERO, "its centre"), length("Radius", &[1.0], "its radius")],
    },
    Rule {
        name: "Box",
        role: Role::Object,
        state: State::Supported,
        origin: Origin::Document,
        doc: "The cube of edge 1 about the origin, transformed [D §4.7.2]: any number of transformations, \
              applied in the order in which they are written.",
        params: &[MATERIAL, TRANSLATION, ROTATION, SCALE],
    },
    Rule {
        name: "Cylinder",
        role: Role::Object,
        state: State::Planned,
        origin: Origin::Document,
        doc: "A cylinder with its caps [D §4.7.3].",
        params: &[
            MATERIAL,
            point("Base", ZERO, "centre of its base"),
            Param::new(
                "Axis",
                "x y z",
                triple(Domain::Direction),
                Default::Numbers(&[0.0, 1.0, 0.0]),
                "from the base to the top",
            ),
            length("Height", &[1.0], "from the base to the top"),
            length("Radius", &[1.0], "its radius"),
        ],
    },
    Rule {
        name: "CSG",
        role: Role::Object,
        state: State::Planned,
        origin: Origin::Document,
        doc: "Solids combined by union, intersection and difference, from a file [D §4.8].",
        params: &[MATERIAL, SOURCE],
    },
    Rule {
        name: "Mesh",
        role: Role::Object,
        state: State::Planned,
        origin: Origin::Document,
        doc: "Triangles from an OBJ file, transformed in written order [D §4.9].",
        params: &[MATERIAL, SOURCE, TRANSLATION, ROTATION, SCALE],
    },
    Rule {
        name: "PointLight",
        role: Role::Light,
        state: State::Supported,
        origin: Origin::Document,
        doc: "A light without size [D §4.10.1].",
        params: &[
            point("Position", ZERO, "where it is"),
            color("Color", Domain::NotNegative, ONES, "a facing surface of reflectance ρ shows the radiance ρ·Color, at any distance")
                .unit("W m⁻² sr⁻¹"),
            Param::new("Intensity", "r g b", triple(Domain::NotNegative), Default::Absent, "instead of Color: thins out with the squared distance")
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
            color("Color", Domain::NotNegative, ONES, "a facing surface of reflectance ρ shows the radiance ρ·Color, at any distance")
                .unit("W m⁻² sr⁻¹"),
            Param::new("Radiance", "r g b", triple(Domain::NotNegative), Default::Absent, "instead of Color: shines to its front by Lambert's cosine law")
                .unit("W m⁻² sr⁻¹")
                .extension(),
            point("Position", ZERO, "its centre"),
            Param::new("Direction", "x y z", triple(Domain::Direction), Default::Numbers(&[0.0, -1.0, 0.0]), "where it faces"),
            Param::new("RollAngle", "angle", number(ANY), Default::Numbers(&[0.0]), "turns it about its direction").unit("rad"),
            length("Width", &[1.0], "its width"),
            length("Height", &[1.0], "its height"),
            Param::new(
                "Subdivision",
                "columns rows",
                Kind::Integers { count: 2, from: 1, to: MOST_CELLS as i64 },
                Default::Integers(&[5, 5]),
                "cells along width and height, one shadow ray each; at most 65536 in all",
            ),
            Param::new("Placement", "place", Kind::Choice(&["grid", "jittered"]), Default::Word("grid"), "where in its cell a shadow ray ends: at the centre, or at random")
                .extension(),
        ],
    },
];
