//! Maps over angle and width: where light is created or lost, and where formulas lose their digits.

use super::models::WHITE;
use super::naive::naive_ggx;
use super::view;
use lightbench::bsdf::{
    Angles, Blinn, BlinnScale, Brdf, CookTorrance, Directions, Distribution, Geometry, Model, OrenNayar,
    OrenNayarForm, ParameterError, Phong, Shadowing,
};
use lightbench::num::U;
use lightbench_kit::figure::{Axis, FailureMap, Figure, Shades};
use rayon::prelude::*;
use std::cell::RefCell;
use std::f64::consts::{FRAC_PI_2, PI};

/// The value of every cell, computed on all cores, then the map.
fn filled(
    axes: (&Axis, &Axis),
    value: &str,
    size: (usize, usize),
    cell: impl Fn(f64, f64) -> f64 + Sync,
) -> (FailureMap, Vec<f64>) {
    let places = RefCell::new(Vec::new());
    let place = |x: f64, y: f64| {
        places.borrow_mut().push((x, y));
        None
    };
    FailureMap::new(axes.0.clone(), axes.1.clone(), value, size, place);
    let values: Vec<f64> = places.into_inner().into_par_iter().map(|(x, y)| cell(x, y)).collect();
    let mut next = values.iter().copied();
    (FailureMap::new(axes.0.clone(), axes.1.clone(), value, size, |_, _| next.next()), values)
}

/// Light gained or lost over angle and width, of four models.
pub fn furnaces(columns: usize) -> Result<Vec<(&'static str, Figure)>, ParameterError> {
    let angle = Axis::linear("angle of view θₒ, degrees").range(0.0, 90.0).every(15.0);
    let exponent = Axis::log("exponent n").range(1.0, 1.0e4);
    let rough = |name: &str| Axis::linear(name).range(0.0, 1.0);
    let mut maps = Vec::new();
    let mut map =
        |name, y: Axis, words: [&str; 3], model: &(dyn Fn(f64) -> Result<Model, ParameterError> + Sync)| {
            let excess =
                |degrees: f64, y: f64| model(y).map_or(f64::NAN, |m| m.albedo(view(degrees)).value - 1.0);
            let (map, values) = filled((&angle, &y), "albedo − 1", (columns, columns * 3 / 4), excess);
            let (least, most) =
                values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(*v), b.max(*v)));
            let title = format!(
                "{}: from {:.0} % to {:.1} % of the light comes back",
                words[0],
                100.0 * (1.0 + least),
                100.0 * (1.0 + most)
            );
            let map = map.shades(Shades::Signed).range(-0.4, 0.4).title(&title).subtitle(words[1]);
            maps.push((name, Figure::from(map).caption(words[2])));
        };
    map(
        "furnace_phong",
        exponent.clone(),
        [
            "Cosine lobe",
            "A (4.7), normalised by (n + 2)/2π; white: all light returns; blue: light is lost",
            "Towards grazing the lobe dips below the horizon, and what falls there is lost: half of any sharp lobe at 90°, the more the \
             cosine of the transport falls with it. No exponent gets it back.",
        ],
        &|n| Phong::new(n).map(Model::from),
    );
    map(
        "furnace_blinn",
        exponent,
        [
            "Blinn's lobe by (n + 8)/8π",
            "white: all light returns; blue: light is lost; red: light is created",
            "The usual scale is a fit from above to the exact one: it creates light near the normal for every exponent, most for blunt lobes.",
        ],
        &|n| Blinn::new(n).map(|b| b.scaled(BlinnScale::Eighth).into()),
    );
    map(
        "furnace_ggx",
        rough("roughness α"),
        [
            "GGX with Smith's shadowing",
            "facets that reflect everything; blue: light that facets send to each other, which the model drops",
            "Facets under a white sky. What a facet sends to another one is counted as lost: nothing at roughness 0, most of all at \
             roughness 1. The model never creates light.",
        ],
        &|m| CookTorrance::ggx(m, WHITE).map(Model::from),
    );
    map(
        "furnace_v_cavity",
        rough("roughness m"),
        [
            "Beckmann's facets in V-cavities",
            "facets that reflect everything; D's model [D §5.3]; blue: lost",
            "Cook and Torrance's own shadowing: grooves all seen across, which hide less than Smith's at normal incidence.",
        ],
        &|m| CookTorrance::new(m, Distribution::Beckmann, Shadowing::VCavity, WHITE).map(Model::from),
    );
    map(
        "furnace_oren_nayar",
        rough("standard deviation of slopes σ, rad"),
        [
            "Oren and Nayar's full model",
            "ρ = 1; blue: lost; red: created",
            "The full model adds the light that is reflected twice, by a fit; near grazing the sum exceeds what came in.",
        ],
        &|s| OrenNayar::new(1.0, s, OrenNayarForm::Full).map(Model::from),
    );
    Ok(maps)
}

/// Errors of the naive and of the default GGX over grazing and roughness.
pub struct Cells {
    naive: (FailureMap, Vec<f64>),
    default: (FailureMap, Vec<f64>),
    /// What the rounding of two unit vectors does to f, per cell.
    vectors: Vec<f64>,
}

/// The light stands where the half vector tilts by 0.7 α.
fn pair(gap: f64, alpha: f64) -> Angles {
    let theta_o = FRAC_PI_2 - gap;
    Angles::new((theta_o - 1.4 * alpha.atan()).max(0.0), theta_o, PI)
}

/// The view lies `gap` over the horizon; the truth works with the angles, where nothing is rounded off.
pub fn naive_against_default(columns: usize) -> Cells {
    let gap = Axis::log("height of the view over the horizon, rad").range(1.0e-12, 1.0);
    let roughness = Axis::log("roughness α").range(1.0e-10, 1.0);
    let error = |naive: bool| {
        move |gap: f64, alpha: f64| {
            let g = pair(gap, alpha);
            let Ok(model) = CookTorrance::ggx(alpha, WHITE) else { return f64::NAN };
            let Directions { wi, wo } = g.directions();
            let found = if naive { naive_ggx(alpha, wi, wo) } else { model.eval(wi, wo) };
            let error = (found / model.value(&g) - 1.0).abs();
            if error.is_finite() { error.max(1.0e-17) } else { f64::NAN }
        }
    };
    // A half vector is the sum of two, as high as both together; rounding tilts it by u over that, and α is a tilt.
    let limit =
        |gap: f64, alpha: f64| U / (alpha * 0.5 * (pair(gap, alpha).cos_i() + pair(gap, alpha).cos_o()));
    let (axes, size) = ((&gap, &roughness), (columns, columns * 3 / 4));
    let made = |naive| filled(axes, "relative error of f", size, error(naive));
    Cells { naive: made(true), default: made(false), vectors: filled(axes, "", size, limit).1 }
}

/// An error of more than this is a failure.
const WRONG: f64 = 0.01;

impl Cells {
    /// Share of the cells where the naive form errs by more than 1 % or gives no number.
    pub fn naive_share(&self) -> f64 {
        self.naive.0.clone().failing_above(WRONG, "").failing_share()
    }
    /// The default's largest error, in roundings of the vectors, where those leave four digits of f.
    pub fn default_roundings(&self) -> f64 {
        let cells = self.default.1.iter().zip(&self.vectors).filter(|(_, limit)| **limit < 1.0e-4);
        cells
            .map(|(e, limit)| e / limit.max(U))
            .fold(0.0, |m, r| if r.is_nan() { f64::INFINITY } else { f64::max(m, r) })
    }
    pub fn naive_map(&self) -> Figure {
        let none = self.naive.0.failing_share();
        let title = format!(
            "Typed from the cosine, GGX errs by over 1 % on {:.0} % of the map, and is no number on {:.0} %",
            100.0 * self.naive_share(),
            100.0 * none
        );
        let map =
            self.naive.0.clone().range(1.0e-17, 1.0).failing_above(WRONG, "wrong by over 1 %").title(&title);
        Figure::from(map.subtitle("half vector tilted by 0.7 α; relative error against the same formula in angles, where nothing cancels"))
            .caption(
                "The textbook's c²(α² − 1) + 1 is 0 or 10⁻¹⁶ as soon as α² is smaller than a rounding: the lobe becomes flat, or infinite. \
                 Towards the horizon 1 − c² over c² and the division by 4 cᵢ cₒ take their share.",
            )
    }
    pub fn default_map(&self) -> Figure {
        let map = self.default.0.clone().range(1.0e-17, 1.0).failing_above(WRONG, "unit vectors end");
        let title = format!(
            "The default fails only where unit vectors end, on {:.0} % of the map; where they hold four digits it errs by {:.0} of their roundings",
            100.0 * map.failing_share(),
            self.default_roundings()
        );
        let map = map
            .title(&title)
            .subtitle("α² cos²θ + sin²θ from the sum of the two vectors; the same pairs, the same truth");
        Figure::from(map).caption(
            "In the corner two vectors in f64 no longer say where the half vector points: rounding tilts it by u over their height, which \
             is more than the facets' own tilt α. No formula can know better from vectors; the table of angles does.",
        )
    }
}
