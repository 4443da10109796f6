//! What surfaces are made of.

use super::{NAME, SHARE, ZERO, color, number, texture, triple};
use crate::scene_file::format::{Default, Domain, Kind, Names, Origin, Param, Role, Rule, State};

/// Names of the reflection models.
pub const MODELS: &[&str] =
    &["lambert", "oren-nayar", "phong", "blinn", "lafortune", "cook-torrance", "rough"];

/// Parameters that some models read, and which.
pub const READ_BY: &[(&str, &[&str])] = &[
    // The document's materials have no model and write it all the same.
    ("Roughness", &["lambert", "cook-torrance", "rough"]),
    ("Exponent", &["phong", "blinn", "lafortune"]),
    ("Normalisation", &["phong", "blinn"]),
    ("Lobe", &["lafortune"]),
    ("Slope", &["oren-nayar"]),
    ("Form", &["oren-nayar"]),
    ("Facets", &["cook-torrance"]),
    ("Shadowing", &["cook-torrance"]),
    ("FacetIndex", &["cook-torrance"]),
];

const fn choice(
    name: &'static str,
    word: &'static str,
    words: &'static [&'static str],
    default: &'static str,
    doc: &'static str,
) -> Param {
    Param::new(name, word, Kind::Choice(words), Default::Word(default), doc).extension()
}

pub const MATERIAL: Rule = Rule {
    name: "Material",
    role: Role::Named(Names::Material),
    state: State::Supported,
    origin: Origin::Document,
    doc: "How surfaces look [D §4.6]. Spheres, boxes and other primitives use its colours, never its textures.\n\n\
          `Model` † says how the light of light sources is reflected; formulas and sources stand in the library's module `bsdf`. \
          `lambert`: `DiffuseColor/π` and nothing else. `oren-nayar`: rough and diffuse, `DiffuseColor` with `Slope` and `Form`. `phong`, `blinn`, \
          `lafortune`: Lambert's law, plus `SpecularColor` times a lobe of that `Exponent`. `cook-torrance`: Lambert's law, plus small \
          mirrors of slope `Roughness`, of reflectance `SpecularColor` at normal incidence (Schlick), or of index `FacetIndex` and then \
          multiplied by `SpecularColor` if that is written. `rough`: document D's mixture, `oren-nayar` of slope `Roughness` [rad] and \
          `cook-torrance` with Beckmann's facets and V-cavities [D §5.3].",
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
        choice("Model", "model", MODELS, "lambert", "how the light of light sources is reflected"),
        Param::new(
            "Exponent",
            "n",
            number(Domain::NotNegative),
            Default::Numbers(&[20.0]),
            "how narrow the highlight is",
        )
        .extension(),
        choice(
            "Normalisation",
            "factor",
            &["energy", "none", "shading"],
            "energy",
            "all light comes back at normal incidence; or the bare power of the cosine; or that without the cosine \
             of the light's angle, as in Phong's and C's formulas (24) and (28)",
        ),
        Param::new(
            "Lobe",
            "Cx Cy Cz",
            triple(Domain::Closed(-1.0, 1.0)),
            Default::Numbers(&[-1.0, -1.0, 1.0]),
            "Lafortune's coefficients: −1 −1 1 mirrors, 1 1 1 sends back",
        )
        .extension(),
        Param::new(
            "Slope",
            "angle",
            number(Domain::Closed(0.0, 90.0)),
            Default::Numbers(&[30.0]),
            "standard deviation of the grooves' slopes",
        )
        .unit("degrees")
        .extension(),
        choice("Form", "form", &["short", "full"], "short", "which of Oren and Nayar's two formulas"),
        choice("Facets", "law", &["ggx", "beckmann"], "ggx", "how the small mirrors are tilted"),
        choice("Shadowing", "law", &["smith", "v-cavity"], "smith", "how they hide each other"),
        Param::new(
            "FacetIndex",
            "n k",
            Kind::Numbers { count: 2, domain: Domain::Closed(0.0, 1.0e6) },
            Default::Absent,
            "complex index of refraction of the small mirrors, exact Fresnel; n at least 10⁻⁶, k is 0 for what is clear",
        )
        .extension(),
    ],
};
