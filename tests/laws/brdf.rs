//! Laws of reflection models, one suite for all: a line per model.

use crate::support::chi2::sample_matches_pdf;
use crate::support::domain::Cone;
use crate::support::{nasty, seed, z};
use glam::{DVec2, DVec3};
use lightbench::bsdf::{
    Blinn, BlinnScale, Brdf, CookTorrance, CosinePrinted, Distribution, FacetSampling, Lafortune, Lambert,
    Lobes, MIRROR_BELOW, Model, OrenNayar, OrenNayarForm, Phong, PhongScale, Shadowing, as_printed, mirror,
};
use lightbench::frame::basis;
use lightbench::fresnel::Fresnel;
use lightbench::num::gamma;
use lightbench::num::statistics::Moments;
use lightbench::sample::{Sampler, uniform_hemisphere};
use proptest::prelude::*;

const WHITE: Fresnel = Fresnel::Schlick { f0: 1.0 };
const GLASS: Fresnel = Fresnel::Dielectric { ior: 1.5 };
const GOLD: Fresnel = Fresnel::Conductor { eta: 0.143, k: 3.983 };

fn phong(n: f64, scale: PhongScale) -> Model {
    Phong::new(n).expect("an exponent").scaled(scale).into()
}
fn blinn(n: f64, scale: BlinnScale) -> Model {
    Blinn::new(n).expect("an exponent").scaled(scale).into()
}
fn oren_nayar(rho: f64, sigma: f64, form: OrenNayarForm) -> Model {
    OrenNayar::new(rho, sigma, form).expect("a matt model").into()
}
fn facets(
    roughness: f64,
    distribution: Distribution,
    shadowing: Shadowing,
    fresnel: Fresnel,
) -> CookTorrance {
    CookTorrance::new(roughness, distribution, shadowing, fresnel).expect("a glossy model")
}

/// A direction at an angle [degrees], off the axes.
fn view(degrees: f64) -> DVec3 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    DVec3::new(sin * 0.7f64.cos(), sin * 0.7f64.sin(), cos)
}

/// Degrees. What little of a lobe falls below the horizon must be too little for the quadrature to see, or enough for samples.
const VIEWS: [f64; 4] = [0.0, 25.0, 70.0, 87.0];

/// Pairs of directions above the horizon, half of them in each other's mirror lobe, some at grazing angles.
fn pairs(name: &str) -> impl Iterator<Item = (DVec3, DVec3)> {
    let seed = seed(name);
    (0..2000).map(move |i| {
        let mut s = Sampler::new(seed, 0, i);
        let mut wo = uniform_hemisphere(s.next_2d());
        if i.is_multiple_of(5) {
            wo = DVec3::new(wo.x, wo.y, wo.z * 1e-6).normalize();
        }
        let mut wi = uniform_hemisphere(s.next_2d());
        if i.is_multiple_of(2) {
            wi = (mirror(wo) + wi * s.next_1d() * 0.3).normalize();
        }
        (wi, wo)
    })
}

/// Both ways use the same half vector and mirror angle, bit by bit; factors of the two cosines are multiplied in another
/// order: 32 roundings at most.
fn reciprocity(name: &str, model: &Model) {
    let mut worst: f64 = 0.0;
    for (wi, wo) in pairs(name) {
        let (there, back) = (model.eval(wi, wo), model.eval(wo, wi));
        let error = (there - back).abs() / there.max(back).max(f64::MIN_POSITIVE);
        worst = worst.max(error);
        assert!(!model.is_reciprocal() || error <= gamma(32), "{wi} {wo}: {there} {back}");
    }
    assert!(model.is_reciprocal() || worst > 0.5, "claims less than it keeps: {worst}");
}

/// The chi-square test at several views, over the hemisphere for wide lobes, over a cone about the mirror direction for
/// narrow ones, where what lies outside counts as lost.
fn samples_follow_the_density(name: &str, model: &Model, versine: f64) {
    for degrees in VIEWS {
        let wo = view(degrees);
        let axis = if versine < 1.0 { mirror(wo) } else { DVec3::Z };
        let (x, y) = basis(axis);
        let cone = Cone { versine };
        let edge = 1.0 - versine;
        let sample = |s: &mut Sampler| {
            let wi = model.sample(wo, s.next_2d())?.wi;
            Some(DVec3::new(wi.dot(x), wi.dot(y), wi.dot(axis))).filter(|w| w.z > edge)
        };
        let density = |w: DVec3| model.pdf(x * w.x + y * w.y + axis * w.z, wo);
        sample_matches_pdf(&format!("{name} {degrees}"), &cone, sample, density);
    }
}

/// The mean weight is the albedo; and each weight is `f cos/pdf`.
///
/// The weight is made before `wi` is rounded; its height is known to 8 u, and the model divides by heights and by `cos d`.
fn weights_mean_the_albedo(name: &str, model: &Model) {
    for degrees in VIEWS {
        let wo = view(degrees);
        let mut moments = Moments::default();
        for i in 0..20_000 {
            let u = Sampler::new(seed(name), degrees as u64, i).next_2d();
            let Some(made) = model.sample(wo, u) else {
                moments.add(0.0);
                continue;
            };
            moments.add(made.weight);
            if made.pdf < f64::INFINITY {
                let lit = model.eval(made.wi, wo) * made.wi.z;
                let cos_d = (0.5 * (1.0 + made.wi.dot(wo))).sqrt();
                let tolerance = gamma(512) / (made.wi.z * wo.z * cos_d);
                assert!((made.weight * made.pdf - lit).abs() <= tolerance * lit, "{wo} {u}: {made:?} {lit}");
            }
        }
        let albedo = model.albedo(wo);
        let (mean, error) = (moments.mean().expect("samples"), moments.standard_error().expect("samples"));
        let tolerance = z() * error + albedo.error + gamma(64);
        assert!((mean - albedo.value).abs() <= tolerance, "{degrees}°: {mean} ± {error}, {albedo:?}");
    }
}

/// Nobody returns more than comes in who claims not to, and the quadrature says how far it may be off.
fn energy(model: &Model) {
    let mut most: f64 = 0.0;
    for degrees in (0..90).step_by(3).map(f64::from).chain([89.0, 89.9, 89.999_999]) {
        let albedo = model.albedo(view(degrees));
        assert!(albedo.value >= 0.0 && albedo.error < 1e-6, "{degrees}°: {albedo:?}");
        most = most.max(albedo.value - albedo.error);
    }
    assert!(!model.conserves_energy() || most <= 1.0 + gamma(64), "creates light: {most}");
    let down = model.albedo(-DVec3::Z);
    assert_eq!(down.value, 0.0, "seen from below");
}

fn below_there_is_nothing(model: &Model) {
    let (up, down) = (view(40.0), -view(40.0));
    for (wi, wo) in [(up, down), (down, up), (down, down), (DVec3::X, up), (up, DVec3::X)] {
        assert_eq!((model.eval(wi, wo), model.pdf(wi, wo)), (0.0, 0.0), "{wi} {wo}");
    }
    assert_eq!(model.sample(down, DVec2::splat(0.3)), None);
}

macro_rules! brdf_laws {
    ($($name:ident, $versine:expr, $model:expr;)*) => {$(
        mod $name {
            use super::*;

            #[test]
            fn is_reciprocal_where_it_says_so() {
                reciprocity(stringify!($name), &Model::from($model));
            }
            #[test]
            fn samples_follow_the_density() {
                super::samples_follow_the_density(stringify!($name), &Model::from($model), $versine);
            }
            #[test]
            fn weights_mean_the_albedo() {
                super::weights_mean_the_albedo(stringify!($name), &Model::from($model));
            }
            #[test]
            fn keeps_its_claim_of_energy() {
                energy(&Model::from($model));
                below_there_is_nothing(&Model::from($model));
            }
        }
    )*};
}

brdf_laws! {
    lambert, 1.0, Lambert::new(0.7).unwrap();
    cosine_as_printed, 1.0, CosinePrinted;
    phong_1, 1.0, phong(1.0, PhongScale::Normalised);
    phong_20, 1.0, phong(20.0, PhongScale::Normalised);
    phong_1e6, 1e-5, phong(1e6, PhongScale::Normalised);
    phong_raw, 1.0, phong(5.0, PhongScale::Raw);
    phong_over_cosine, 1.0, phong(5.0, PhongScale::OverCosine);
    blinn_30, 1.0, blinn(30.0, BlinnScale::Exact);
    blinn_eighth, 1.0, blinn(3.0, BlinnScale::Eighth);
    blinn_raw, 1.0, blinn(3.0, BlinnScale::Raw);
    blinn_over_cosine, 1.0, blinn(30.0, BlinnScale::OverCosine);
    // 8π (1 − 2^(−n/2−1))/(n + 2) just under 1: the least exponent that claims to create nothing, rounded up.
    blinn_over_cosine_at_its_limit, 1.0, blinn(23.133, BlinnScale::OverCosine);
    blinn_over_cosine_blunt, 1.0, blinn(3.0, BlinnScale::OverCosine);
    blinn_over_cosine_1e6, 1e-5, blinn(1e6, BlinnScale::OverCosine);
    lafortune_off_specular, 1.0, Lafortune::new(DVec3::new(-1.0, -1.0, 0.7), 12.0, 0.9).unwrap();
    lafortune_retro, 1.0, Lafortune::new(DVec3::ONE, 8.0, 0.5).unwrap();
    lafortune_brushed, 1.0, Lafortune::new(DVec3::new(-1.0, -0.6, 0.9), 6.0, 1.0).unwrap();
    oren_nayar_short, 1.0, oren_nayar(0.9, 0.5, OrenNayarForm::Qualitative);
    oren_nayar_full, 1.0, oren_nayar(1.0, 0.5, OrenNayarForm::Full);
    beckmann_v_cavity, 1.0, facets(0.4, Distribution::Beckmann, Shadowing::VCavity, WHITE);
    beckmann_smith, 1.0, facets(0.5, Distribution::Beckmann, Shadowing::Smith, GOLD);
    beckmann_rational, 1.0, facets(0.5, Distribution::Beckmann, Shadowing::SmithRational, GOLD);
    ggx, 1.0, facets(0.5, Distribution::Ggx, Shadowing::Smith, GLASS);
    ggx_all_facets, 1.0, facets(0.5, Distribution::Ggx, Shadowing::Smith, GLASS).sampled(FacetSampling::All);
    ggx_v_cavity, 1.0, facets(0.6, Distribution::Ggx, Shadowing::VCavity, WHITE);
    ggx_narrow, 1e-2, facets(0.02, Distribution::Ggx, Shadowing::Smith, WHITE);
    beckmann_narrow, 1e-5, facets(1e-3, Distribution::Beckmann, Shadowing::VCavity, WHITE);
}

/// Any model with any parameters that it accepts.
fn any_model() -> impl Strategy<Value = Model> {
    let exponent =
        || prop_oneof![Just(0.0), 0.0..10.0, (0.0..15.0f64).prop_map(|e| 10f64.powf(e)), Just(1e6)];
    let roughness = || {
        let decades = (-15.0..1.0f64).prop_map(|e| 10f64.powf(e));
        prop_oneof![Just(0.0), Just(MIRROR_BELOW), Just(1.0), Just(f64::MIN_POSITIVE), decades]
    };
    let c = || prop_oneof![-1.0..1.0f64, Just(0.0), Just(1.0), Just(-1.0), Just(1e-200)];
    let form = prop_oneof![Just(OrenNayarForm::Qualitative), Just(OrenNayarForm::Full)];
    let fresnel = prop_oneof![
        Just(WHITE),
        Just(GLASS),
        Just(GOLD),
        Just(Fresnel::Schlick { f0: 0.0 }),
        Just(Fresnel::Dielectric { ior: 1.0 }),
        Just(Fresnel::Dielectric { ior: 1.0 + 1e-15 }),
        Just(Fresnel::Dielectric { ior: 0.5 }),
        Just(Fresnel::Conductor { eta: 1e-3, k: 1e3 }),
    ];
    let shadowing =
        prop_oneof![Just(Shadowing::VCavity), Just(Shadowing::Smith), Just(Shadowing::SmithRational)];
    let distribution = prop_oneof![Just(Distribution::Beckmann), Just(Distribution::Ggx)];
    let sampling = prop_oneof![Just(FacetSampling::All), Just(FacetSampling::Visible)];
    prop_oneof![
        (exponent(), prop_oneof![Just(PhongScale::Normalised), Just(PhongScale::Raw)])
            .prop_map(|(n, s)| phong(n, s)),
        (
            exponent(),
            prop_oneof![Just(BlinnScale::Exact), Just(BlinnScale::Raw), Just(BlinnScale::OverCosine)]
        )
            .prop_map(|(n, s)| blinn(n, s)),
        (c(), c(), c(), exponent())
            .prop_map(|(x, y, z, n)| Lafortune::new(DVec3::new(x, y, z), n, 1.0).unwrap().into()),
        (prop_oneof![Just(0.0), 0.0..2.0, Just(1e200)], form).prop_map(|(s, form)| oren_nayar(1.0, s, form)),
        (roughness(), distribution, shadowing, fresnel, sampling).prop_map(|(m, d, g, f, s)| facets(
            m, d, g, f
        )
        .sampled(s)
        .into()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn finite_input_gives_numbers(model in any_model(), a in nasty::unit_vector(), b in nasty::unit_vector()) {
        for (wi, wo) in [(a, b), (a, mirror(a)), (a, a), (DVec3::Z, a), (DVec3::Z, DVec3::Z)] {
            let (f, pdf) = (model.eval(wi, wo), model.pdf(wi, wo));
            prop_assert!(f >= 0.0, "{wi} {wo} {f}");
            prop_assert!(pdf >= 0.0, "{wi} {wo} {pdf}");
        }
    }

    #[test]
    fn samples_are_directions_with_weights(model in any_model(), wo in nasty::unit_vector(), u in nasty::unit_square()) {
        if let Some(made) = model.sample(wo, u) {
            prop_assert!(wo.z > 0.0 && made.wi.z > 0.0);
            // Two vectors of γ₆ and a reflection: under 64 roundings.
            prop_assert!((made.wi.length_squared() - 1.0).abs() <= gamma(64), "{made:?}");
            prop_assert!(made.weight >= 0.0 && made.weight < f64::INFINITY, "{made:?}");
            prop_assert!(made.pdf >= 0.0, "{made:?}");
        }
    }

    #[test]
    fn albedos_are_certain(model in any_model(), wo in nasty::unit_vector()) {
        let albedo = model.albedo(wo);
        prop_assert!(albedo.value >= 0.0 && albedo.error <= 1e-6, "{albedo:?}");
        prop_assert!(!model.conserves_energy() || albedo.value <= 1.0 + albedo.error + gamma(64), "{albedo:?}");
    }
}

#[test]
fn special_cases_coincide() {
    let lobe = Lafortune::new(DVec3::new(-1.0, -1.0, 1.0), 7.0, 1.0).unwrap();
    for (wi, wo) in pairs("special") {
        // The generalised lobe keeps its cosine to u, hence its 7th power relative to 7 u over the cosine.
        let (f, cos) = (Phong::new(7.0).unwrap().eval(wi, wo), mirror(wo).dot(wi));
        assert!((lobe.eval(wi, wo) - f).abs() <= gamma(64) * f / cos.abs(), "{wi} {wo}");
        for form in [OrenNayarForm::Qualitative, OrenNayarForm::Full] {
            assert_eq!(oren_nayar(0.5, 0.0, form).eval(wi, wo), Lambert::new(0.5).unwrap().eval(wi, wo));
        }
    }
}

#[test]
fn a_roughness_of_nothing_is_the_mirror() {
    for roughness in [0.0, f64::MIN_POSITIVE, 0.5 * MIRROR_BELOW] {
        let model = facets(roughness, Distribution::Ggx, Shadowing::Smith, GLASS);
        let wo = view(60.0);
        let made = model.sample(wo, DVec2::splat(0.4)).expect("a direction");
        assert_eq!((made.wi, made.pdf), (mirror(wo), f64::INFINITY));
        assert_eq!(made.weight, model.albedo(wo).value);
        assert_eq!(model.eval(mirror(wo), wo), 0.0);
    }
    // And the limit is the mirror too: at 60° glass returns 8.9 %.
    let thin = facets(1e-7, Distribution::Ggx, Shadowing::Smith, GLASS).albedo(view(60.0)).value;
    let smooth = facets(0.0, Distribution::Ggx, Shadowing::Smith, GLASS).albedo(view(60.0)).value;
    assert!((thin - smooth).abs() < 1e-7, "{thin} {smooth}");
}

/// FAILURES of the field: the lobe (n + 2)/2π keeps its energy at normal incidence only.
#[test]
fn the_cosine_lobe_loses_light_towards_grazing() {
    let lobe = Phong::new(10.0).unwrap();
    for (degrees, share) in [(0.0, 1.0), (60.0, 0.505), (89.0, 0.13)] {
        let albedo = lobe.albedo(view(degrees)).value;
        assert!((albedo - share).abs() < 0.0051, "{degrees}°: {albedo}");
    }
    let raw = |n: f64| phong(n, PhongScale::Raw).albedo(DVec3::Z).value;
    assert!((raw(1.0) - 2.0943951).abs() < 1e-6 && (raw(100.0) - 0.0616).abs() < 1e-4);
}

#[test]
fn the_usual_fit_creates_light_and_the_exact_scale_does_not() {
    for n in [1.0, 10.0, 100.0] {
        let at_normal = |scale| blinn(n, scale).albedo(DVec3::Z).value;
        assert!((at_normal(BlinnScale::Exact) - 1.0).abs() < 1e-8);
        assert!(at_normal(BlinnScale::Eighth) > 1.005, "{n}: {}", at_normal(BlinnScale::Eighth));
    }
}

#[test]
fn the_printed_lobe_is_not_cut_off_at_zero() {
    let (u, n) = (view(30.0), DVec3::Z);
    let v = -mirror(u); // behind the lobe
    assert!(as_printed::cosine_lobe_as_printed(u, n, v, 2.5).is_nan());
    assert!(as_printed::cosine_lobe_as_printed(u, n, v, 3.0) < 0.0);
    assert!(as_printed::cosine_lobe_as_printed(u, n, v, 4.0) > 0.9);
    assert_eq!(as_printed::lambertian_as_printed(1.0), Lambert::new(1.0).unwrap().eval(u, n));
}

#[test]
fn wrong_parameters_are_refused_by_name() {
    let refused = [
        Lambert::new(1.5).map(drop),
        Phong::new(-1.0).map(drop),
        Phong::new(f64::NAN).map(drop),
        Blinn::new(f64::INFINITY).map(drop),
        Lafortune::new(DVec3::new(2.0, 0.0, 0.0), 1.0, 1.0).map(drop),
        OrenNayar::new(0.5, -0.1, OrenNayarForm::Full).map(drop),
        CookTorrance::ggx(-0.1, WHITE).map(drop),
        CookTorrance::ggx(0.1, Fresnel::Dielectric { ior: 0.0 }).map(drop),
        CookTorrance::ggx(0.1, Fresnel::Schlick { f0: 1.1 }).map(drop),
    ];
    for result in refused {
        let message = result.expect_err("refused").to_string();
        assert!(message.contains("must be") && message.contains("found"), "{message}");
    }
}

#[test]
fn nan_goes_through() {
    for model in [
        Model::from(Phong::new(5.0).unwrap()),
        blinn(5.0, BlinnScale::Exact),
        facets(0.3, Distribution::Ggx, Shadowing::Smith, GLASS).into(),
    ] {
        assert!(model.eval(DVec3::NAN, DVec3::Z).is_nan(), "{model:?}");
    }
}

/// Sums of lobes: the mixture's samples follow its density, and their mean weight is its albedo.
#[test]
fn lobes_add_up() {
    let (diffuse, specular) = (DVec3::new(0.5, 0.3, 0.1), DVec3::new(0.2, 0.5, 0.9));
    let lobes = Lobes::matt_and_glossy(diffuse, specular, 0.4).expect("a material");
    let wo = view(50.0);
    let sample = |s: &mut Sampler| lobes.sample(wo, s.next_2d()).map(|m| m.wi);
    sample_matches_pdf("lobes", &Cone::HEMISPHERE, sample, |wi| lobes.pdf(wi, wo));
    let mut moments = [Moments::default(); 3];
    for i in 0..20_000 {
        let u = Sampler::new(seed("lobes albedo"), 0, i).next_2d();
        let weight = lobes.sample(wo, u).map_or(DVec3::ZERO, |m| m.weight);
        moments.iter_mut().zip(weight.to_array()).for_each(|(m, w)| m.add(w));
    }
    let (albedo, error) = lobes.albedo(wo);
    for (moment, truth) in moments.iter().zip(albedo.to_array()) {
        let (mean, spread) = (moment.mean().unwrap(), moment.standard_error().unwrap());
        assert!((mean - truth).abs() <= z() * spread + error, "{mean} ± {spread}, {truth}");
    }
    // Schlick in colour: red of the metal is its own F₀.
    let metal = facets(0.4, Distribution::Beckmann, Shadowing::VCavity, Fresnel::Schlick { f0: 0.2 });
    let only = Lobes::matt_and_glossy(DVec3::ZERO, specular, 0.4).expect("a metal");
    for (wi, wo) in pairs("metal") {
        let (ours, theirs) = (only.eval(wi, wo).x, metal.eval(wi, wo));
        assert!((ours - theirs).abs() <= gamma(64) * theirs, "{wi} {wo}");
    }
}
